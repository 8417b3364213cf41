//! Study of passages near a singular surface: the errors by every formulation and integrator. The
//! singular coordinate is integrated, or its distance from the surface.
//!
//! A scene's ladder is a list of variants of its start, called rungs. They pass ever closer to the
//! surface.

use super::findings::{FindingRow, FindingTopic, Findings, PassageRun, PassageVariable, StudyInputs};
use crate::code::{CodePreparation, compile_tape, runnable_code};
use crate::error::{Error, refused_scene_error};
use crate::mechanism::Mechanism;
use crate::observer::require_uninterrupted;
use crate::preparation::problem::Problem;
use crate::studies::chart_case::{ChartCase, PrintedEquationsChoice, full_equation_cases, reduced_equation_case};
use crate::studies::figure::{Cell, Figure, HeatMap};
use crate::studies::method_at_tolerance::MethodAtTolerance;
use crate::trust::compared_quantities::ComparedQuantities;
use crate::trust::reference_solution::ReferenceSolution;
use tripos_derive::Formulation;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::mechanics::{SingularDistance, singular_distances};
use tripos_derive::scene::Scene;
use tripos_sim::work_precision::{work_precision_error, work_precision_options};
use tripos_sim::{Method, Options, OutputOption};
use tripos_traits::larger;

/// Integrators that are compared, each with a tolerance close to the finest that it accepts.
const METHODS: [(Method, f64); 5] = [
    (Method::Dop853, 3e-14),
    (Method::Ode45, 1e-12),
    (Method::Dopri5, 1e-12),
    (Method::Gauss6, 1e-11),
    (Method::Rk4, 1e-12),
];
/// Integrator and tolerance for the scene's reduced equations. Near the surface, the states of these
/// equations have very different sizes, and lose no digits. An absolute tolerance alone keeps the digits
/// of all states.
const OWN: MethodAtTolerance = MethodAtTolerance::Absolute(Method::Dop853, 1e-14);
/// Number of integrators that a quick study compares.
const QUICK: usize = 2;

/// Passage of a motion near a singular surface of the kinematic equations.
pub struct Passage {
    /// Instant at which the motion is closest to the surface, s.
    pub t: f64,
    /// Least distance from the surface, measured by the absolute value of the divisor of the kinematic
    /// equations.
    pub least: f64,
}

/// Finds the first passage of a scene near a singular surface, where the absolute value of a divisor of
/// the kinematic equations has a minimum. `None` if there is no such minimum, or if the motion crosses
/// the surface.
///
/// # Errors
/// [`Error`] if the scene cannot be run.
pub fn find_passage(model: &Mechanism, scene: &Scene) -> Result<Option<Passage>, Error> {
    let Some(divisor) = model.kinematic_equations.divisors.first() else { return Ok(None) };
    let by = EquationsOrigin::from(Formulation::Kane);
    let mut scene = scene.clone();
    scene.integration.distance = singular_distances(model).first().copied();
    let code = runnable_code(model, &by, scene.integration.distance, CodePreparation::Solved)?;
    let problem = Problem::new(model, &scene, &by, &code, None)?;
    let inputs = [model.p(), model.q()].concat();
    let tape = compile_tape(&model.arena, &inputs, &[*divisor], "a divisor of the kinematic equations")?;
    let options = Options {
        output: OutputOption::Steps { refine: 20 },
        ..work_precision_options(Method::Dop853, 1e-12, 1.0, 1_000_000)
    };
    let run = require_uninterrupted(
        problem.integrate(&problem.start()?, &options, &mut []).map_err(|e| refused_scene_error(&scene, &e))?,
    )?;
    let values: Vec<f64> =
        run.y.iter().map(|y| tape.evaluate(&[scene.parameters.clone(), problem.coordinates(y)].concat())[0]).collect();
    // A motion that crosses the surface has no passage beside it.
    if values.iter().any(|v| *v > 0.0) && values.iter().any(|v| *v < 0.0) {
        return Ok(None);
    }
    let values: Vec<f64> = values.into_iter().map(f64::abs).collect();
    let least = values.windows(3).position(|v| v[1] <= v[0] && v[1] < v[2] && v[1] < 0.5).map(|at| at + 1);
    Ok(least.map(|at| Passage { t: run.t[at], least: values[at] }))
}

/// Rung of the ladder: a variant of the scene, with reference states at its passage and at its end.
struct Rung {
    /// Variant of the scene.
    scene: Scene,
    /// Reference states to 32 digits, at the passage and at the end.
    reference: ReferenceSolution,
    /// Least distance of the motion from the singular surface, measured by the divisor of the kinematic
    /// equations.
    least: f64,
}

/// Runs all passages of the scene's ladder by every case and integrator, and records their errors. Does
/// nothing if the scene has no passage near a singular surface.
///
/// # Errors
/// [`Error`] if the scene cannot be run.
pub fn study_passages(study: &StudyInputs<'_>, findings: &mut Findings) -> Result<(), Error> {
    let model = study.model;
    let mut rungs = Vec::new();
    for (_, scene) in study.scene.ladder_scenes() {
        study.progress.set_message("reference of a passage");
        let Some(passage) = find_passage(model, &scene)? else { continue };
        let reference = ReferenceSolution::new(model, &scene, &[passage.t, scene.span.1])?;
        rungs.push(Rung { scene, reference, least: passage.least });
    }
    let (Some(divisor), false) = (model.kinematic_equations.divisors.first(), rungs.is_empty()) else { return Ok(()) };
    let divisor = print_text(&model.arena, *divisor);
    let limit = if study.quick { 20_000 } else { 200_000 };
    let length = study.scene.span.1 - study.scene.span.0;
    let mut rows: Vec<(String, Vec<Cell>)> = Vec::new();
    let mut row = |findings: &mut Findings,
                   case: &ChartCase,
                   what: IntegratedVariable,
                   way: MethodAtTolerance|
     -> Result<(), Error> {
        let name = [case.by.name().as_str(), way.solve(case.solve), way.name()].join(" ").replace(" - ", " ");
        let name = what.distance.map_or_else(|| name.clone(), |v| format!("{name}, {}", v.name(model)));
        study.progress.set_message(&name);
        let cells = rungs
            .iter()
            .map(|rung| run_ladder_cell(study, findings, rung, case, what, way, &way.options(length, limit)));
        rows.push((name, cells.collect::<Result<Vec<_>, _>>()?));
        Ok(())
    };
    for distance in std::iter::once(None).chain(singular_distances(model).first().copied().map(Some)) {
        let mut scene = study.scene.clone();
        scene.integration.distance = distance;
        let what = IntegratedVariable {
            distance,
            variable: distance.map_or(PassageVariable::Coordinate, |_| PassageVariable::Distance),
        };
        // Only formulations that the model has are in the list.
        for case in full_equation_cases(model, &scene, PrintedEquationsChoice::LeftOut)?.0 {
            for (method, tolerance) in METHODS.into_iter().take(if study.quick { QUICK } else { METHODS.len() }) {
                if case.can_run_with(method) {
                    row(findings, &case, what, MethodAtTolerance::Steps(method, tolerance))?;
                }
            }
        }
    }
    // The scene's reduced equations always use the distance from the surface if they have one.
    let own = reduced_equation_case(model, study.scene);
    if let Err(failure) = &own {
        findings.add_statement(
            FindingTopic::Passages,
            format!("the scene's reduced equations were not run: {}", failure.first_line()),
        );
    }
    if let Ok(case) = own {
        let measured = case.reduction.as_ref().is_some_and(|reduction| !reduction.divisors.is_empty());
        let variable = if measured { PassageVariable::Distance } else { PassageVariable::Coordinate };
        let what = IntegratedVariable { distance: None, variable };
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
    add_passage_summary(findings, &rungs);
    Ok(())
}

/// Variable that the runs of one row of the heat map integrate.
#[derive(Clone, Copy)]
struct IntegratedVariable {
    /// Distance from the singular surface that the equations of the whole model use as a variable. `None`
    /// if they use the coordinate itself.
    distance: Option<SingularDistance>,
    /// Kind of the variable, for tables.
    variable: PassageVariable,
}

/// Runs a case on one rung of the ladder. Adds its rows to the findings, and returns its cell of the heat
/// map.
///
/// # Errors
/// `Error` if the run cannot be made or is interrupted.
fn run_ladder_cell(
    study: &StudyInputs<'_>,
    findings: &mut Findings,
    rung: &Rung,
    case: &ChartCase,
    IntegratedVariable { distance, variable }: IntegratedVariable,
    way: MethodAtTolerance,
    options: &Options,
) -> Result<Cell, Error> {
    let mut scene = rung.scene.clone();
    scene.integration.distance = distance;
    let prepared = case.prepare(study.model, &scene)?;
    let problem = prepared.problem()?;
    let compared = ComparedQuantities::new(study.model, &scene)?;
    let row = |quantity, value, remark: &str| FindingRow {
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
    let passed = |error, steps, stop: &str, t_end| PassageRun {
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
        // Quadrature starts again for each part. The first part would save no steps, and a state inside the
        // passage gives the energy to fewer digits.
        if way == MethodAtTolerance::Quadrature {
            (t, y) = (scene.span.0, start.clone());
        }
        let arrival = run_passage_part(study, &problem, (t, *next), &y, way, options)?;
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
        let right = compared.comparable_quantities(compared.quantities_of_state(state));
        last = larger(
            work_precision_error(&compared.quantities_of_run(&problem, t, &y), &right),
            rung.reference.uncertainty,
        );
        findings.rows.push(row(quantity, Some(last), ""));
    }
    findings.rows.push(row("steps", Some(steps as f64), ""));
    findings.passages.push(passed(Some(last), steps, "end", t));
    Ok(Cell::Value(last))
}

/// Result of a run over one part of a passage: up to the closest point, or from there to the end.
struct PassagePartResult {
    /// Code of the reason why the run stopped before the end of the part; `None` if it reached the end.
    stop: Option<String>,
    /// Instant at which the run ended, s.
    t_end: f64,
    /// Number of accepted steps.
    steps: u64,
    /// Integrated state at the end; `None` if quadrature gave no motion.
    y_end: Option<Vec<f64>>,
}

/// Runs a problem over one part of a passage, from the integrated state `y0` over `span`, s.
///
/// # Errors
/// `Error` if the run cannot be made or is interrupted.
fn run_passage_part(
    study: &StudyInputs<'_>,
    problem: &Problem<'_>,
    span: (f64, f64),
    y0: &[f64],
    way: MethodAtTolerance,
    options: &Options,
) -> Result<PassagePartResult, Error> {
    match way.run(problem, span, y0, options) {
        Ok(solution) => Ok(PassagePartResult {
            stop: solution.stop.is_failure().then(|| solution.stop.code()),
            t_end: solution.t_end,
            steps: solution.steps,
            y_end: Some(solution.y_end),
        }),
        // Quadrature cannot compute every motion.
        Err(_) if way == MethodAtTolerance::Quadrature && !study.model.follow.is_interrupted() => {
            Ok(PassagePartResult { stop: Some("no-quadrature".to_owned()), t_end: span.0, steps: 0, y_end: None })
        }
        Err(failure) => Err(failure),
    }
}

/// Adds two conclusions to the findings: the best and the worst run through the closest passage, and the
/// uncertainty of the references.
fn add_passage_summary(findings: &mut Findings, rungs: &[Rung]) {
    let Some(narrow) = rungs.iter().min_by(|a, b| a.least.total_cmp(&b.least)) else { return };
    let describe = |p: &PassageRun| format!("{}, {}, {}, in the {}", p.by.name(), p.solve, p.method, p.variable.name());
    let ends = findings.passages.iter().filter(|p| p.least.total_cmp(&narrow.least).is_eq());
    let arrived: Vec<(f64, String)> = ends.filter_map(|p| Some((p.error?, describe(p)))).collect();
    let by_error = |a: &&(f64, String), b: &&(f64, String)| a.0.total_cmp(&b.0);
    if let (Some(best), Some(worst)) = (arrived.iter().min_by(by_error), arrived.iter().max_by(by_error)) {
        findings.add_statement(
            FindingTopic::Passages,
            format!(
                "narrowest passage, {:.0e}: best {:.1e} ({}), worst that arrived {:.1e} ({})",
                narrow.least, best.0, best.1, worst.0, worst.1
            ),
        );
    }
    let known = rungs.iter().map(|r| r.reference.uncertainty).fold(0.0, larger);
    findings.add_statement(
        FindingTopic::Passages,
        format!("the references are known to {:.0e}: {}", known, narrow.reference.how),
    );
}
