//! Errors of the accelerations along a passage near a singular surface, and condition numbers of their
//! matrices. They show how many digits a numeric solution for the accelerations loses, and why.

use super::findings::{ConditioningFinding, FindingRow, FindingTopic, Findings, StudyInputs};
use super::passages::find_passage;
use crate::code::{CodePreparation, compile_tape, runnable_code};
use crate::error::{Error, refused_scene_error};
use crate::observer::require_uninterrupted;
use crate::preparation::problem::Problem;
use crate::studies::chart_case::{ChartCase, PrintedEquationsChoice, full_equation_cases};
use crate::studies::figure::{Figure, Panel, Scale, Series};
use tripos_derive::Formulation;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::scene::{AccelerationSolution, Scene};
use tripos_sim::{Dynamics, Options, OutputOption, linear};
use tripos_traits::{DoubleDouble, Real, Scalar, System, larger};

/// Number of examined states for each factor of ten in the distance from the singular surface.
const PER_DECADE: usize = 6;

/// State of a motion that passes near a singular surface of the kinematic equations.
struct Waypoint {
    /// Absolute value of the divisor of the kinematic equations, which is zero on the surface.
    divisor: f64,
    /// Generalized coordinates.
    q: Vec<f64>,
    /// Generalized speeds.
    u: Vec<f64>,
}

/// Computes the accelerations u̇ at a state of a passage, to 32 digits. `system` are the equations of
/// motion.
fn exact_accelerations(
    study: &StudyInputs<'_>,
    system: &dyn System<DoubleDouble>,
    place: &Waypoint,
) -> Vec<DoubleDouble> {
    let wide = |list: &[f64]| list.iter().map(|x| DoubleDouble::from_f64(*x)).collect::<Vec<_>>();
    let (p, q, u) = (wide(&study.scene.parameters), wide(&place.q), wide(&place.u));
    let zeros = vec![DoubleDouble::int(0); system.lengths().variables];
    let (mut v, mut v_dot, mut u_dot) = (zeros.clone(), zeros.clone(), vec![DoubleDouble::int(0); u.len()]);
    system.motion_variables(&p, &q, &u, &mut v);
    system.accelerations(&p, &q, &v, &mut v_dot);
    system.generalized_speed_rates(&p, &q, &v, &v_dot, &mut u_dot);
    u_dot
}

/// Error of the accelerations at a state of a passage, and condition numbers of their matrix.
struct ExaminedConditioning {
    /// Largest error of u̇ relative to the largest u̇; NaN if the linear system for u̇ has no solution.
    error: f64,
    /// Condition number of the unscaled matrix.
    plain: f64,
    /// Condition number of the matrix after its rows and columns are scaled.
    scaled: f64,
}

/// Computes the error of the accelerations by one case at a state of a passage, and the condition
/// numbers. `exact` are the accelerations u̇ to 32 digits.
///
/// # Errors
/// `Error::Request` if the parameters do not fit the equations.
fn examine_conditioning(
    case: &ChartCase,
    extended: &dyn System<DoubleDouble>,
    scene: &Scene,
    place: &Waypoint,
    exact: &[DoubleDouble],
) -> Result<ExaminedConditioning, Error> {
    let (system, p) = (case.code.system(), scene.parameters.as_slice());
    let mut v = vec![0.0; system.lengths().variables];
    system.motion_variables(p, &place.q, &place.u, &mut v);
    let mut v_dot = vec![0.0; system.lengths().variables];
    let mut dynamics = Dynamics::new(system, p).map_err(|error| refused_scene_error(scene, &error))?;
    match case.solve {
        AccelerationSolution::Eliminated => system.accelerations(p, &place.q, &v, &mut v_dot),
        AccelerationSolution::Numeric => match dynamics.unknowns(&place.q, &v) {
            Ok(x) => v_dot.copy_from_slice(&x[..v.len()]),
            Err(_) => v_dot.fill(f64::NAN),
        },
    }
    // The definitions of the speeds are evaluated to 32 digits, so that they add no error.
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
    Ok(ExaminedConditioning { error, plain, scaled: 1.0 / linear::reciprocal_condition(&matrix, n) })
}

/// Lists states along the passage that comes closest to the singular surface. It is the first passage of
/// one variant (rung) of the scene's ladder. For each factor of ten of the divisor, there are at most
/// `PER_DECADE` states. Empty if no rung has a passage.
///
/// # Errors
/// `Error` if the rungs cannot be run.
fn passage_states(study: &StudyInputs<'_>) -> Result<Vec<Waypoint>, Error> {
    let model = study.model;
    let mut narrow: Option<(f64, f64, Scene)> = None;
    for (_, mut scene) in study.scene.ladder_scenes() {
        if let Some(found) = find_passage(model, &scene)?
            && narrow.as_ref().is_none_or(|(least, ..)| found.least < *least)
        {
            scene.span.1 = found.t;
            narrow = Some((found.least, found.t, scene));
        }
    }
    let Some((least, _, mut scene)) = narrow else { return Ok(Vec::new()) };
    scene.integration.distance = None;
    let by = tripos_derive::mechanics::EquationsOrigin::from(Formulation::Kane);
    let code = runnable_code(model, &by, None, CodePreparation::Solved)?;
    let problem = Problem::new(model, &scene, &by, &code, None)?;
    let options = Options {
        method: tripos_sim::Method::Dop853,
        output: OutputOption::Steps { refine: 50 },
        ..Options::tolerances(1e-12, 1e-12)
    };
    let run = require_uninterrupted(
        problem.integrate(&problem.start()?, &options, &mut []).map_err(|e| refused_scene_error(&scene, &e))?,
    )?;
    let Some(divisor) = model.kinematic_equations.divisors.first() else { return Ok(Vec::new()) };
    let inputs = [model.p(), model.q()].concat();
    let tape = compile_tape(&model.arena, &inputs, &[*divisor], "a divisor of the kinematic equations")?;
    let n = problem.system().lengths().coordinates;
    let mut list: Vec<Waypoint> = Vec::new();
    let mut next = 0.7;
    for (t, y) in run.t.iter().zip(&run.y) {
        let state = problem.shown_state(*t, y);
        let value = tape.evaluate(&[scene.parameters.as_slice(), &state[..n]].concat())[0].abs();
        if value <= next && value >= 0.9 * least {
            list.push(Waypoint { divisor: value, q: state[..n].to_vec(), u: state[n..].to_vec() });
            next = value * 10_f64.powf(-1.0 / PER_DECADE as f64);
        }
    }
    Ok(list)
}

/// Curves of the figure of condition numbers, which has four panels. Each panel has a curve for each
/// formulation.
#[derive(Default)]
struct ConditioningCurves {
    /// Errors of eliminated accelerations against the divisor of the kinematic equations.
    eliminated: Vec<Series>,
    /// Errors of numerically solved accelerations against the divisor of the kinematic equations.
    numeric: Vec<Series>,
    /// Condition numbers of the unscaled matrices against the divisor.
    plain: Vec<Series>,
    /// Condition numbers of the matrices with scaled rows and columns, against the divisor.
    scaled: Vec<Series>,
    /// Largest error of each examined case, as text.
    worst: Vec<String>,
}

impl ConditioningCurves {
    /// Adds the curves of a case: the errors and both condition numbers, as points (divisor, value). Does
    /// nothing if there are no points.
    fn add(&mut self, case: &ChartCase, errors: Vec<(f64, f64)>, plain: Vec<(f64, f64)>, scaled: Vec<(f64, f64)>) {
        if errors.is_empty() {
            return;
        }
        let worst = errors.iter().map(|point| point.1).fold(0.0, larger);
        self.worst.push(format!("{}, {} {worst:.0e}", case.by.name(), case.solve.name()));
        let formulation = Formulation::ALL.iter().position(|f| case.by.formulation() == Some(*f));
        let curve = |points| Series::curve(case.by.name(), formulation.unwrap_or_default(), points);
        match case.solve {
            AccelerationSolution::Eliminated => self.eliminated.push(curve(errors)),
            AccelerationSolution::Numeric => {
                self.numeric.push(curve(errors));
                self.plain.push(curve(plain));
                self.scaled.push(curve(scaled));
            }
        }
    }
}

/// Examines the accelerations by all cases along a passage near a singular surface. Does nothing if the
/// scene has no passage. Also does nothing if the model has no Lagrange's equations, which give the
/// exact accelerations to 32 digits.
///
/// # Errors
/// [`Error`] if the scene cannot be run.
pub fn study_conditioning(study: &StudyInputs<'_>, findings: &mut Findings) -> Result<(), Error> {
    let lagrange = match runnable_code(study.model, &Formulation::Lagrange.into(), None, CodePreparation::Solved) {
        Ok(lagrange) => lagrange,
        Err(Error::Unsupported(_)) => return Ok(()),
        Err(failure) => return Err(failure),
    };
    let places = passage_states(study)?;
    let mut scene = study.scene.clone();
    scene.integration.distance = None;
    let (cases, _) = full_equation_cases(study.model, &scene, PrintedEquationsChoice::LeftOut)?;
    let mut curves = ConditioningCurves::default();
    for case in &cases {
        let (mut error_points, mut plain, mut scaled) = (Vec::new(), Vec::new(), Vec::new());
        for place in &places {
            let exact = exact_accelerations(study, lagrange.extended(), place);
            let ExaminedConditioning { error, plain: cond, scaled: equilibrated } =
                examine_conditioning(case, case.code.extended(), &scene, place, &exact)?;
            // Errors below 1e-17 are drawn at 1e-17, because a logarithmic axis has no zero.
            error_points.push((place.divisor, larger(error, 1e-17)));
            plain.push((place.divisor, cond));
            scaled.push((place.divisor, equilibrated));
            let (by, divisor) = (case.by.clone(), place.divisor);
            findings.looked.push(ConditioningFinding { by, solve: case.solve, divisor, error, equilibrated });
            for (quantity, value) in
                [("acceleration error", error), ("condition", cond), ("equilibrated condition", equilibrated)]
            {
                findings.rows.push(FindingRow {
                    check: "conditioning",
                    formulation: case.by.name(),
                    solve: case.solve.name(),
                    case: format!("{:.6e}", place.divisor),
                    quantity,
                    value: Some(value),
                    ..FindingRow::default()
                });
            }
        }
        curves.add(case, error_points, plain, scaled);
    }
    if curves.worst.is_empty() {
        return Ok(());
    }
    let divisor = study.model.kinematic_equations.divisors.first().map(|d| print_text(&study.model.arena, *d));
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
    findings
        .add_statement(FindingTopic::Conditioning, format!("largest error of the accelerations on the way in: {list}"));
    let error = "largest |e| / largest |u'|";
    let ConditioningCurves { eliminated, numeric, plain, scaled, .. } = curves;
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
