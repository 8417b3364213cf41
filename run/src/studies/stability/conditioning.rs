//! Errors of each solve for accelerations along a passage, with condition numbers: the digits that a numeric solve
//! loses, and the reason.

use super::findings::{Findings, Looked, Row, Study, Topic};
use super::ladder::passage;
use crate::code::{Ready, code, tape};
use crate::error::{Error, refused};
use crate::follow::uninterrupted;
use crate::preparation::problem::Problem;
use crate::studies::case::{Case, Printed, whole};
use crate::studies::figure::{Figure, Panel, Scale, Series};
use tripos_derive::Formulation;
use tripos_derive::algebra::text::print::text;
use tripos_derive::scene::{Scene, Solve};
use tripos_sim::{Dynamics, Options, Output, linear};
use tripos_traits::{DoubleDouble, Real, Scalar, System, larger};

/// Number of distances from the singular surface, per decade, at which matrices are examined.
const PER_DECADE: usize = 6;

/// State of a passage near a singular surface: divisor of the kinematic equations, coordinates, speeds.
struct Waypoint {
    divisor: f64,
    q: Vec<f64>,
    u: Vec<f64>,
}

/// Accelerations u̇ at a state of a passage, in twice the precision of the doubles that give the state.
fn exact(study: &Study<'_>, system: &dyn System<DoubleDouble>, place: &Waypoint) -> Vec<DoubleDouble> {
    let wide = |list: &[f64]| list.iter().map(|x| DoubleDouble::from_f64(*x)).collect::<Vec<_>>();
    let (p, q, u) = (wide(&study.scene.parameters), wide(&place.q), wide(&place.u));
    let zeros = vec![DoubleDouble::int(0); system.lengths().variables];
    let (mut v, mut v_dot, mut u_dot) = (zeros.clone(), zeros.clone(), vec![DoubleDouble::int(0); u.len()]);
    system.motion_variables(&p, &q, &u, &mut v);
    system.accelerations(&p, &q, &v, &mut v_dot);
    system.generalized_speed_rates(&p, &q, &v, &v_dot, &mut u_dot);
    u_dot
}

/// Error of the accelerations at a state, and condition numbers of their matrix.
struct Examined {
    /// Largest error of u̇ relative to the largest u̇; NaN if the linear system has no solution.
    error: f64,
    /// Condition number of the matrix as it is.
    plain: f64,
    /// Condition number of the matrix with its rows and columns scaled.
    scaled: f64,
}

/// Examines the accelerations of a case at a state of a passage.
fn look(
    case: &Case,
    extended: &dyn System<DoubleDouble>,
    scene: &Scene,
    place: &Waypoint,
    exact: &[DoubleDouble],
) -> Result<Examined, Error> {
    let (system, p) = (case.code.system(), scene.parameters.as_slice());
    let mut v = vec![0.0; system.lengths().variables];
    system.motion_variables(p, &place.q, &place.u, &mut v);
    let mut v_dot = vec![0.0; system.lengths().variables];
    let mut dynamics = Dynamics::new(system, p).map_err(|error| refused(scene, &error))?;
    match case.solve {
        Solve::Eliminated => system.accelerations(p, &place.q, &v, &mut v_dot),
        Solve::Numeric => match dynamics.unknowns(&place.q, &v) {
            Ok(x) => v_dot.copy_from_slice(&x[..v.len()]),
            Err(_) => v_dot.fill(f64::NAN),
        },
    }
    // The definitions of the speeds are applied in twice the precision of a double, to add no error of their own.
    let wide = |list: &[f64]| list.iter().map(|x| DoubleDouble::from_f64(*x)).collect::<Vec<_>>();
    let mut u_dot = vec![DoubleDouble::int(0); place.u.len()];
    let mut exact_v = vec![DoubleDouble::int(0); v.len()];
    extended.motion_variables(&wide(p), &wide(&place.q), &wide(&place.u), &mut exact_v);
    extended.generalized_speed_rates(&wide(p), &wide(&place.q), &exact_v, &wide(&v_dot), &mut u_dot);
    let largest = exact.iter().map(|a| a.abs().to_f64()).fold(0.0, larger);
    let error = u_dot.iter().zip(exact).map(|(a, b)| (*a - *b).abs().to_f64()).fold(0.0, larger) / largest;
    let n = system.lengths().unknowns();
    let mut matrix = vec![0.0; n * n];
    system.mass_matrix(p, &place.q, &v, &mut matrix);
    let plain = 1.0 / linear::plain_reciprocal_condition(&matrix, n);
    Ok(Examined { error, plain, scaled: 1.0 / linear::reciprocal_condition(&matrix, n) })
}

/// States along the first passage of the scene's rung that is nearest to the singular surface, up to `PER_DECADE` in
/// each decade of the divisor.
fn places(study: &Study<'_>) -> Result<Vec<Waypoint>, Error> {
    let model = study.model;
    let mut narrow: Option<(f64, f64, Scene)> = None;
    for (_, mut scene) in study.scene.rungs() {
        if let Some(found) = passage(model, &scene)?
            && narrow.as_ref().is_none_or(|(least, ..)| found.least < *least)
        {
            scene.span.1 = found.t;
            narrow = Some((found.least, found.t, scene));
        }
    }
    let Some((least, _, mut scene)) = narrow else { return Ok(Vec::new()) };
    scene.integration.distance = None;
    let by = tripos_derive::mechanics::EquationsOrigin::from(Formulation::Kane);
    let code = code(model, &by, None, Ready::Solved)?;
    let problem = Problem::new(model, &scene, &by, &code, None)?;
    let options = Options {
        method: tripos_sim::Method::Dop853,
        output: Output::Steps { refine: 50 },
        ..Options::tolerances(1e-12, 1e-12)
    };
    let run = uninterrupted(problem.integrate(&problem.start()?, &options, &mut []).map_err(|e| refused(&scene, &e))?)?;
    let Some(divisor) = model.kinematic_equations.divisors.first() else { return Ok(Vec::new()) };
    let inputs = [model.p(), model.q()].concat();
    let tape = tape(&model.arena, &inputs, &[*divisor], "a divisor of the kinematic equations")?;
    let n = problem.system().lengths().coordinates;
    let mut list: Vec<Waypoint> = Vec::new();
    let mut next = 0.7;
    for (t, y) in run.t.iter().zip(&run.y) {
        let state = problem.state(*t, y);
        let value = tape.evaluate(&[scene.parameters.as_slice(), &state[..n]].concat())[0].abs();
        if value <= next && value >= 0.9 * least {
            list.push(Waypoint { divisor: value, q: state[..n].to_vec(), u: state[n..].to_vec() });
            next = value * 10_f64.powf(-1.0 / PER_DECADE as f64);
        }
    }
    Ok(list)
}

/// Curves of the figure of condition numbers: in each panel one for each formulation, with its name and style.
#[derive(Default)]
struct Curves {
    /// Errors of eliminated accelerations along the passage.
    eliminated: Vec<Series>,
    /// Errors of numerically solved accelerations along the passage.
    numeric: Vec<Series>,
    /// Condition numbers of the matrices.
    plain: Vec<Series>,
    /// Condition numbers of the matrices with scaled rows and columns.
    scaled: Vec<Series>,
    /// Text with the largest error of each case that has one.
    worst: Vec<String>,
}

impl Curves {
    fn add(&mut self, case: &Case, errors: Vec<(f64, f64)>, plain: Vec<(f64, f64)>, scaled: Vec<(f64, f64)>) {
        if errors.is_empty() {
            return;
        }
        let worst = errors.iter().map(|point| point.1).fold(0.0, larger);
        self.worst.push(format!("{}, {} {worst:.0e}", case.by.name(), case.solve.name()));
        let formulation = Formulation::ALL.iter().position(|f| case.by.formulation() == Some(*f));
        let curve = |points| Series::curve(case.by.name(), formulation.unwrap_or_default(), points);
        match case.solve {
            Solve::Eliminated => self.eliminated.push(curve(errors)),
            Solve::Numeric => {
                self.numeric.push(curve(errors));
                self.plain.push(curve(plain));
                self.scaled.push(curve(scaled));
            }
        }
    }
}

/// Examines accelerations along a passage, if the scene has one and the model has Lagrange's equations. These give the
/// exact accelerations, in twice the precision of a double.
///
/// # Errors
/// [`Error`] if the scene cannot be run at all.
pub fn study(study: &Study<'_>, findings: &mut Findings) -> Result<(), Error> {
    let lagrange = match code(study.model, &Formulation::Lagrange.into(), None, Ready::Solved) {
        Ok(lagrange) => lagrange,
        Err(Error::Unsupported(_)) => return Ok(()),
        Err(failure) => return Err(failure),
    };
    let places = places(study)?;
    let mut scene = study.scene.clone();
    scene.integration.distance = None;
    let (cases, _) = whole(study.model, &scene, Printed::LeftOut)?;
    let mut curves = Curves::default();
    for case in &cases {
        let (mut error_points, mut plain, mut scaled) = (Vec::new(), Vec::new(), Vec::new());
        for place in &places {
            let exact = exact(study, lagrange.extended(), place);
            let Examined { error, plain: cond, scaled: equilibrated } =
                look(case, case.code.extended(), &scene, place, &exact)?;
            // An error below half a unit in the last place counts as 1e-17.
            error_points.push((place.divisor, larger(error, 1e-17)));
            plain.push((place.divisor, cond));
            scaled.push((place.divisor, equilibrated));
            let (by, divisor) = (case.by.clone(), place.divisor);
            findings.looked.push(Looked { by, solve: case.solve, divisor, error, equilibrated });
            for (quantity, value) in
                [("acceleration error", error), ("condition", cond), ("equilibrated condition", equilibrated)]
            {
                findings.rows.push(Row {
                    check: "conditioning",
                    formulation: case.by.name(),
                    solve: case.solve.name(),
                    case: format!("{:.6e}", place.divisor),
                    quantity,
                    value: Some(value),
                    ..Row::default()
                });
            }
        }
        curves.add(case, error_points, plain, scaled);
    }
    if curves.worst.is_empty() {
        return Ok(());
    }
    let divisor = study.model.kinematic_equations.divisors.first().map(|d| text(&study.model.arena, *d));
    let divisor = divisor.unwrap_or_default();
    let panel = |title: &str, y_label: &str, series| Panel {
        title: title.to_owned(),
        x_label: format!("|{divisor}|"),
        y_label: y_label.to_owned(),
        scale: Scale::Logarithmic,
        x_scale: Scale::Logarithmic,
        series,
        note: None,
    };
    let list = curves.worst.join("; ");
    findings.say(Topic::Conditioning, format!("largest error of the accelerations on the way in: {list}"));
    let error = "largest |e| / largest |u'|";
    let Curves { eliminated, numeric, plain, scaled, .. } = curves;
    let panels = [
        panel("Errors of the accelerations, eliminated", error, eliminated),
        panel("Errors of the accelerations, numeric", error, numeric),
        panel("Condition numbers of the matrices", "cond A", plain),
        panel("The same, rows and columns scaled", "cond A, scaled", scaled),
    ];
    let panels = panels.into_iter().filter(|panel| !panel.series.is_empty()).collect();
    findings.figures.push(("conditioning.svg", Figure::Panels(panels, 2)));
    Ok(())
}
