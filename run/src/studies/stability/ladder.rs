//! Passages near a singular surface: errors of every formulation, solve and method, in the coordinate and in its
//! distance.

use super::findings::{Findings, Passed, Row, Study, Topic, Variable};
use crate::code::{Ready, code, tape};
use crate::error::{Error, refused};
use crate::follow::uninterrupted;
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use crate::studies::case::{Case, MethodAtTolerance, Printed, own, whole};
use crate::studies::figure::{Cell, Figure, HeatMap};
use crate::trust::comparison::Compared;
use crate::trust::reference::Reference;
use tripos_derive::Formulation;
use tripos_derive::algebra::text::print::text;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::mechanics::{Distance, distances};
use tripos_derive::scene::Scene;
use tripos_sim::work_precision::{error, options};
use tripos_sim::{Method, Options, Output};
use tripos_traits::larger;

/// Methods that are compared, each at a tolerance near the finest that it accepts.
const METHODS: [(Method, f64); 5] = [
    (Method::Dop853, 3e-14),
    (Method::Ode45, 1e-12),
    (Method::Dopri5, 1e-12),
    (Method::Gauss6, 1e-11),
    (Method::Rk4, 1e-12),
];
/// Method for a scene's reduced equations. Near the surface their states have very different sizes, and none of them
/// loses digits. An absolute tolerance alone keeps the digits of all.
const OWN: MethodAtTolerance = MethodAtTolerance::Absolute(Method::Dop853, 1e-14);
/// Number of methods that a quick study compares.
const QUICK: usize = 2;

/// Passage of a motion near a singular surface.
pub struct Passage {
    /// Instant at which the motion is nearest to the surface, s.
    pub t: f64,
    /// Distance from the surface at that instant: the size of the divisor of the kinematic equations.
    pub least: f64,
}

/// Finds the first passage of a scene near a singular surface: a minimum of a divisor of the kinematic equations.
/// `None` if there is none.
///
/// # Errors
/// [`Error`] if the scene cannot be run at all.
pub fn passage(model: &Mechanism, scene: &Scene) -> Result<Option<Passage>, Error> {
    let Some(divisor) = model.kinematic_equations.divisors.first() else { return Ok(None) };
    let by = EquationsOrigin::from(Formulation::Kane);
    let mut scene = scene.clone();
    scene.integration.distance = distances(model).first().copied();
    let code = code(model, &by, scene.integration.distance, Ready::Solved)?;
    let problem = Problem::new(model, &scene, &by, &code, None)?;
    let inputs = [model.p(), model.q()].concat();
    let tape = tape(&model.arena, &inputs, &[*divisor], "a divisor of the kinematic equations")?;
    let options = Options { output: Output::Steps { refine: 20 }, ..options(Method::Dop853, 1e-12, 1.0, 1_000_000) };
    let run = uninterrupted(problem.integrate(&problem.start()?, &options, &mut []).map_err(|e| refused(&scene, &e))?)?;
    let values: Vec<f64> =
        run.y.iter().map(|y| tape.evaluate(&[scene.parameters.clone(), problem.coordinates(y)].concat())[0]).collect();
    // A motion that goes through the surface does not pass by it.
    if values.iter().any(|v| *v > 0.0) && values.iter().any(|v| *v < 0.0) {
        return Ok(None);
    }
    let values: Vec<f64> = values.into_iter().map(f64::abs).collect();
    let least = values.windows(3).position(|v| v[1] <= v[0] && v[1] < v[2] && v[1] < 0.5).map(|at| at + 1);
    Ok(least.map(|at| Passage { t: run.t[at], least: values[at] }))
}

/// Rung of the ladder: a scene, with the reference at its passage and at its end.
struct Rung {
    scene: Scene,
    reference: Reference,
    /// Least distance of the passage.
    least: f64,
}

/// Runs all passages of the scene's ladder, if the kinematic equations become singular near the motion.
///
/// # Errors
/// [`Error`] if the scene cannot be run at all.
pub fn study(study: &Study<'_>, findings: &mut Findings) -> Result<(), Error> {
    let model = study.model;
    let mut rungs = Vec::new();
    for (_, scene) in study.scene.rungs() {
        study.progress.set_message("reference of a passage");
        let Some(passage) = passage(model, &scene)? else { continue };
        let reference = Reference::new(model, &scene, &[passage.t, scene.span.1])?;
        rungs.push(Rung { scene, reference, least: passage.least });
    }
    let (Some(divisor), false) = (model.kinematic_equations.divisors.first(), rungs.is_empty()) else { return Ok(()) };
    let divisor = text(&model.arena, *divisor);
    let limit = if study.quick { 20_000 } else { 200_000 };
    let length = study.scene.span.1 - study.scene.span.0;
    let mut rows: Vec<(String, Vec<Cell>)> = Vec::new();
    let mut row =
        |findings: &mut Findings, case: &Case, what: Integrated, way: MethodAtTolerance| -> Result<(), Error> {
            let name = [case.by.name().as_str(), way.solve(case.solve), way.name()].join(" ").replace(" - ", " ");
            let name = what.distance.map_or_else(|| name.clone(), |v| format!("{name}, {}", v.name(model)));
            study.progress.set_message(&name);
            let cells =
                rungs.iter().map(|rung| cell(study, findings, rung, case, what, way, &way.options(length, limit)));
            rows.push((name, cells.collect::<Result<Vec<_>, _>>()?));
            Ok(())
        };
    for distance in std::iter::once(None).chain(distances(model).first().copied().map(Some)) {
        let mut scene = study.scene.clone();
        scene.integration.distance = distance;
        let what = Integrated { distance, variable: distance.map_or(Variable::Coordinate, |_| Variable::Distance) };
        // The list has only formulations that the model has.
        for case in whole(model, &scene, Printed::LeftOut)?.0 {
            for (method, tolerance) in METHODS.into_iter().take(if study.quick { QUICK } else { METHODS.len() }) {
                if case.has(method) {
                    row(findings, &case, what, MethodAtTolerance::Steps(method, tolerance))?;
                }
            }
        }
    }
    // A scene's reduced equations are written in the distance if they have one.
    let own = own(model, study.scene);
    if let Err(failure) = &own {
        findings.say(Topic::Passages, format!("the scene's reduced equations were not run: {}", failure.first_line()));
    }
    if let Ok(case) = own {
        let measured = case.reduction.as_ref().is_some_and(|reduction| !reduction.divisors.is_empty());
        let variable = if measured { Variable::Distance } else { Variable::Coordinate };
        let what = Integrated { distance: None, variable };
        row(findings, &case, what, OWN)?;
        if case.has_quadrature() {
            row(findings, &case, what, MethodAtTolerance::Quadrature)?;
        }
    }
    let t = study.scene.span.1;
    let map = HeatMap {
        title: format!("Error at t = {t} s after a passage by {divisor} = 0"),
        columns: rungs.iter().map(|rung| format!("least {:.0e}", rung.least)).collect(),
        rows,
        range: (1e-14, 1e-1),
        note: format!(
            "Largest |e| / (1 + |reference|) over all coordinates and speeds. Grey: why and when a run stopped; it is given \
             up after {limit} steps. The references are double-double runs by two formulations."
        ),
    };
    findings.figures.push(("ladder.svg", Figure::HeatMap(map)));
    summary(findings, &rungs);
    Ok(())
}

/// Variable that is integrated in a row of the heat map.
#[derive(Clone, Copy)]
struct Integrated {
    /// Distance in which the equations of the whole model are written; `None` for the coordinate.
    distance: Option<Distance>,
    variable: Variable,
}

/// Makes one run of one rung. Adds its rows to the findings, and returns its cell of the heat map.
fn cell(
    study: &Study<'_>,
    findings: &mut Findings,
    rung: &Rung,
    case: &Case,
    Integrated { distance, variable }: Integrated,
    way: MethodAtTolerance,
    options: &Options,
) -> Result<Cell, Error> {
    let mut scene = rung.scene.clone();
    scene.integration.distance = distance;
    let prepared = case.prepare(study.model, &scene)?;
    let problem = prepared.problem()?;
    let compared = Compared::new(study.model, &scene)?;
    let row = |quantity, value, remark: &str| Row {
        check: "passage",
        formulation: case.by.name(),
        solve: way.solve(case.solve),
        method: way.name(),
        case: format!("{:.2e} {}", rung.least, variable.name()),
        quantity,
        value,
        expected: None,
        remark: remark.to_owned(),
    };
    let passed = |error, steps, stop: &str, t_end| Passed {
        by: case.by.clone(),
        solve: way.solve(case.solve),
        method: way.name(),
        variable,
        least: rung.least,
        error,
        steps,
        stop: stop.to_owned(),
        t_end,
    };
    let start = problem.start()?;
    let (mut t, mut y, mut steps, mut last) = (scene.span.0, start.clone(), 0, f64::NAN);
    let instants = rung.reference.times.iter().zip(&rung.reference.states);
    for (quantity, (next, state)) in ["error inside", "error at the end"].into_iter().zip(instants) {
        // Quadrature starts anew for each part: it takes no steps that a first part could save, and a state inside the
        // passage holds the energy with fewer digits.
        if way == MethodAtTolerance::Quadrature {
            (t, y) = (scene.span.0, start.clone());
        }
        let arrival = arrive(study, &problem, (t, *next), &y, way, options)?;
        steps += arrival.steps;
        if let Some(y_end) = arrival.y_end {
            y = y_end;
        }
        let t_end = arrival.t_end;
        if let Some(stop) = arrival.stop {
            let why = format!("{stop} at {t_end:.3} s");
            findings.passages.push(passed(None, steps, &stop, t_end));
            findings.rows.push(row(quantity, None, &why));
            findings.rows.push(row("steps", Some(steps as f64), &why));
            // A cell is narrow, so its text is short.
            return Ok(Cell::Stopped(format!("{stop} {t_end:.2} s")));
        }
        t = *next;
        let right = compared.kept(compared.of_state(state));
        last = larger(error(&compared.of_run(&problem, t, &y), &right), rung.reference.uncertainty);
        findings.rows.push(row(quantity, Some(last), ""));
    }
    findings.rows.push(row("steps", Some(steps as f64), ""));
    findings.passages.push(passed(Some(last), steps, "end", t));
    Ok(Cell::Value(last))
}

/// End of a run over one part of a passage.
struct Arrival {
    /// Reason why the run stopped before the end of the part; `None` if it did not.
    stop: Option<String>,
    t_end: f64,
    steps: u64,
    y_end: Option<Vec<f64>>,
}

/// Runs a problem over one part of a passage.
fn arrive(
    study: &Study<'_>,
    problem: &Problem<'_>,
    span: (f64, f64),
    y0: &[f64],
    way: MethodAtTolerance,
    options: &Options,
) -> Result<Arrival, Error> {
    match way.run(problem, span, y0, options) {
        Ok(solution) => Ok(Arrival {
            stop: solution.stop.is_failure().then(|| solution.stop.code()),
            t_end: solution.t_end,
            steps: solution.steps,
            y_end: Some(solution.y_end),
        }),
        // Quadrature does not give every motion.
        Err(_) if way == MethodAtTolerance::Quadrature && !study.model.follow.is_interrupted() => {
            Ok(Arrival { stop: Some("no-quadrature".to_owned()), t_end: span.0, steps: 0, y_end: None })
        }
        Err(failure) => Err(failure),
    }
}

/// Adds to the findings the best and the worst run through the narrowest passage, and the uncertainty of the
/// references.
fn summary(findings: &mut Findings, rungs: &[Rung]) {
    let Some(narrow) = rungs.iter().min_by(|a, b| a.least.total_cmp(&b.least)) else { return };
    let describe = |p: &Passed| format!("{}, {}, {}, in the {}", p.by.name(), p.solve, p.method, p.variable.name());
    let ends = findings.passages.iter().filter(|p| p.least.total_cmp(&narrow.least).is_eq());
    let arrived: Vec<(f64, String)> = ends.filter_map(|p| Some((p.error?, describe(p)))).collect();
    let by_error = |a: &&(f64, String), b: &&(f64, String)| a.0.total_cmp(&b.0);
    if let (Some(best), Some(worst)) = (arrived.iter().min_by(by_error), arrived.iter().max_by(by_error)) {
        findings.say(
            Topic::Passages,
            format!(
                "narrowest passage, {:.0e}: best {:.1e} ({}), worst that arrived {:.1e} ({})",
                narrow.least, best.0, best.1, worst.0, worst.1
            ),
        );
    }
    let known = rungs.iter().map(|r| r.reference.uncertainty).fold(0.0, larger);
    findings.say(Topic::Passages, format!("the references are known to {:.0e}: {}", known, narrow.reference.how));
}
