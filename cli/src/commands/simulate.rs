//! Command `tripos simulate`: runs a scene once.

mod gradient;
mod rigorous;
mod sensitivity;

use crate::arguments::Simulate;
use crate::files::output_files::{TableFormat, refuse_overwriting_inputs, write_table_file};
use crate::files::scene_file::{SceneWithSetValues, read_scene_with};
use crate::files::workspace::short_name;
use crate::terminal::failure::{Failure, print, print_json, print_to_stderr, status, warn};
use crate::terminal::interruption;
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::code::CodeForm;
use tripos::{
    CorrectDigits, DerivativeInstants, Drift, Mechanism, Run, Sensitivities, integration_method_words, sensitivities,
    simulate as simulate_scene,
};
use tripos_codegen::draft_file::ExistingFilePolicy;
use tripos_derive::model::TIME;
use tripos_derive::plain_text::{path_as_plain_text, with_reliable_digits, with_significant_digits};
use tripos_derive::scene::Scene;
use tripos_sim::projection::ProjectionReport;
use tripos_sim::{EventRecord, ImpactRecord, Stop};

/// Runs `tripos simulate`: runs a scene and prints its end, errors and events. Returns the exit
/// status.
pub fn simulate(request: &Simulate) -> Result<u8, Failure> {
    let SceneWithSetValues { model, mut scene, set } = read_scene_with(&request.scene, &request.set.set)?;
    let how = request.how.overrides()?;
    how.apply_to_scene(&mut scene)?;
    if let Some(of) = &request.gradient {
        return gradient::simulate_gradient(request, &model, &scene, &set, of, how.by.as_ref());
    }
    if let Some(path) = &request.csv {
        let existing = if request.overwrite { ExistingFilePolicy::Replaced } else { ExistingFilePolicy::Kept };
        check_csv(path, existing, &model, &scene)?;
    }
    if request.enclosure.rigorous {
        return rigorous::simulate_rigorously(request, &model, &scene, &set, how.by.as_ref());
    }
    interruption::listen_for_interruption();
    interruption::show_progress_bar(scene.span);
    let (plain, with);
    let by = how.by.as_ref();
    let (run, slopes): (&Run, Option<&Sensitivities>) = if request.sensitivity.is_empty() {
        plain = simulate_scene(&model, &scene, by)?;
        (&plain, None)
    } else {
        let at = if request.csv.is_some() { DerivativeInstants::Samples } else { DerivativeInstants::End };
        with = sensitivities(&model, &scene, &set, &request.sensitivity, at, by)?;
        (&with.run, Some(&with))
    };
    interruption::hide_progress_bar();
    let status = report_run(request, run, slopes.and_then(Sensitivities::missing_derivative));
    if request.json {
        let mut whole = as_json(&model, &scene, run);
        if let Some(slopes) = slopes {
            sensitivity::add_sensitivity_json(&mut whole, slopes);
        }
        print_json(&whole)?;
    } else {
        print(&(as_text(&model, &scene, run) + &slopes.map_or_else(String::new, sensitivity::sensitivity_text)))?;
    }
    // The file is written last, so that the answer is printed even if writing fails.
    if let Some(path) = &request.csv {
        write_csv(path, run, slopes)?;
    }
    Ok(status)
}

/// Prints notes and warnings about a run. `missing` is the reason why results are missing, if any are. Returns the exit
/// status.
fn report_run(request: &Simulate, run: &Run, missing: Option<String>) -> u8 {
    run.notes.iter().for_each(|note| print_to_stderr(&format!("note: {note}")));
    run.warnings.iter().for_each(|warning| warn(warning));
    let failure = run.failure().or(missing);
    if let Some(failure) = failure.as_ref().filter(|_| request.json || !run.solution.stop.is_failure()) {
        print_to_stderr(failure);
    }
    match &run.solution.stop {
        Stop::Interrupted => status::INTERRUPTED,
        _ if failure.is_some() || (request.strict && !run.is_trusted()) => status::STOPPED,
        _ => 0,
    }
}

/// Returns the result of a run as JSON.
fn as_json(model: &Mechanism, scene: &Scene, run: &Run) -> Value {
    let named_values = |list: &[f64]| -> Map<String, Value> {
        shown_value_indices(run).map(|at| (run.names[at].clone(), json!(list[at]))).collect()
    };
    let state = named_values(&run.end);
    let solution = &run.solution;
    let mut drift = Map::new();
    drift.insert("energy".to_owned(), json!(run.energy_drift));
    drift.extend(run.drifts.iter().map(|drift| (drift.integral.name.clone(), json!(drift.change))));
    let named = |list: Option<&[f64]>| -> Value { list.map_or(Value::Null, |list| Value::Object(named_values(list))) };
    let digits = run.digits.as_ref();
    let event = |(at, e): (usize, &EventRecord)| {
        let kind = format!("{:?}", e.kind).to_lowercase();
        let uncertainty = digits.and_then(|digits| digits.events[at]);
        json!({ "name": e.name, "t": e.t, "uncertainty": uncertainty, "kind": kind, "terminal": e.terminal })
    };
    let events: Vec<Value> = solution.events.iter().enumerate().map(event).collect();
    json!({
        "model": short_name(model),
        "formulation": run.by.name(),
        "method": scene.integration.method.name(),
        "solve": run.solve.name(),
        "compiled": run.code == CodeForm::Compiled,
        "t": solution.t_end,
        "state": state,
        "digits": digits.and_then(CorrectDigits::digits_at_end_least),
        "digits_of": named(digits.and_then(CorrectDigits::digits_at_end)),
        "uncertainty": named(digits.and_then(CorrectDigits::errors_at_end)),
        "fewest_digits": fewest_digits_json(run),
        "assessed_to": digits.and_then(CorrectDigits::last_assessed_instant),
        "assessed_by": digits.map(|digits| &digits.by),
        "steps": solution.steps,
        "rejected": solution.rejected,
        "evaluations": solution.evaluations,
        "stop": solution.stop.code(),
        "failure": run.failure(),
        "drift": drift,
        "work": is_work_known(run).then_some(run.solution.work_end),
        "impacts": impacts_json(scene, run),
        "residual": run.residuals.iter().map(|r| (r.name.clone(), json!(r.largest))).collect::<Map<_, _>>(),
        "projection": projection_json(run),
        "events": events,
        "notes": run.notes,
        "warnings": run.warnings,
    })
}

/// True if the work of the run is known. Reduced equations that do not show the energies do not watch it.
fn is_work_known(run: &Run) -> bool {
    !run.by.is_reduced() || run.energy_drift.is_some()
}

/// Returns the impacts of a run as JSON: times in s, impulses, and energy losses in J.
fn impacts_json(scene: &Scene, run: &Run) -> Vec<Value> {
    let named = |at: &usize| scene.impacts[*at].name.clone();
    let one = |impact: &ImpactRecord| {
        let impulses = impact.impulses.iter().map(|(at, impulse)| (named(at), json!(impulse)));
        let held: Vec<String> = impact.held.iter().map(named).collect();
        let uncertainty = run.error_of_impact(impact);
        json!({
            "t": impact.t,
            "uncertainty": uncertainty,
            "impulses": impulses.collect::<Map<_, _>>(),
            "loss": impact.loss,
            "work": impact.work,
            "held": held,
        })
    };
    run.solution.impacts.iter().map(one).collect()
}

/// Returns a line with the number of impacts and the energy lost in them, J. Empty if there are no impacts.
fn impacts_in_words(run: &Run) -> String {
    let list = &run.solution.impacts;
    // The sum with 0 removes the sign of a negative zero.
    let lost = list.iter().map(|impact| impact.loss).sum::<f64>() + 0.0;
    match list.len() {
        0 => String::new(),
        1 => format!("lost in 1 impact: {lost} J\n"),
        count => format!("lost in {count} impacts: {lost} J\n"),
    }
}

/// Returns the indices of the run's values that are shown: all except the time, which is shown
/// separately.
fn shown_value_indices(run: &Run) -> impl Iterator<Item = usize> {
    (0..run.names.len()).filter(|at| run.names[*at] != TIME)
}

/// Returns, as JSON, the smallest number of correct digits along a run, with the quantity and the time. Null if digits
/// were not assessed.
fn fewest_digits_json(run: &Run) -> Value {
    let found = run.digits.as_ref().and_then(|digits| Some((digits, digits.fewest_of_all()?)));
    found.map_or(
        Value::Null,
        |(digits, fewest)| json!({ "digits": fewest.digits, "of": run.names[fewest.value], "t": digits.t[fewest.instant] }),
    )
}

/// Returns a line with the numbers of correct digits at the end of the run and along the run. Empty if digits were not
/// assessed.
fn digits_in_words(run: &Run) -> String {
    let Some((digits, fewest)) = run.digits.as_ref().and_then(|digits| Some((digits, digits.fewest_of_all()?))) else {
        return String::new();
    };
    let at_end =
        digits.digits_at_end_least().map_or_else(String::new, |end| format!("{end:.1} digits are right at the end, "));
    let (least, t, name) = (fewest.digits, digits.t[fewest.instant], &run.names[fewest.value]);
    format!(
        "{at_end}{least:.1} at least on the way (`{name}` at t = {} s), by comparison with {}\n",
        with_significant_digits(t, 4),
        digits.by
    )
}

/// Returns the drifts of all first integrals except the energy, whose drift is shown separately.
fn drifts_except_energy(run: &Run) -> impl Iterator<Item = &Drift> {
    run.drifts.iter().filter(|drift| !drift.integral.kind.is_energy())
}

/// Returns, as JSON, a report on the corrections by projection in a run, so that projection hides no drift. Null
/// without projection.
fn projection_json(run: &Run) -> Value {
    match &run.solution.projection {
        None => Value::Null,
        Some(report) => {
            let constraints: Vec<&str> = run.residuals.iter().map(|residual| residual.name.as_str()).collect();
            let onto = if constraints.is_empty() { vec!["energy"] } else { constraints };
            json!({
            "onto": onto,
            "corrections": report.corrections,
            "removed": report.removed,
            "largest": report.largest,
            "moved": report.moved,
            "left": report.singular + report.not_converged,
            })
        }
    }
}

/// Returns, as text, a report on the corrections by projection in a run, with the largest residual of the constraints.
fn projection_in_words(run: &Run, report: &ProjectionReport) -> String {
    let left = report.singular + report.not_converged;
    let Some(worst) = run.residuals.iter().max_by(|a, b| a.largest.abs().total_cmp(&b.largest.abs())) else {
        return format!(
            "projected onto the energy after {} steps: {} J of drift removed in all, {} J at most at once; {left} steps left as they were\n",
            report.corrections,
            with_significant_digits(report.removed.first().copied().unwrap_or_default(), 3),
            with_significant_digits(report.largest.first().copied().unwrap_or_default(), 3),
        );
    };
    let largest = report.largest.iter().fold(0.0, |most: f64, drift| most.max(drift.abs()));
    format!(
        "kept on {} constraint{}: largest residual {} ({}); moved back after {} steps, by {} at most; {left} steps left as they were\n",
        run.residuals.len(),
        if run.residuals.len() == 1 { "" } else { "s" },
        with_significant_digits(worst.largest.abs(), 3),
        worst.name,
        report.corrections,
        with_significant_digits(largest, 3)
    )
}

/// Returns the result of a run as text.
fn as_text(model: &Mechanism, scene: &Scene, run: &Run) -> String {
    let mut out = format!(
        "{}, {}, {} code, accelerations {}, {}\n",
        model.title,
        run.by.title(),
        run.code.name(),
        run.solve.name(),
        integration_method_words(scene)
    );
    let _ = writeln!(out, "{}", run.ending);
    for (at, event) in run.solution.events.iter().enumerate() {
        let error = run.digits.as_ref().and_then(|digits| digits.events[at]);
        let t = with_reliable_digits(event.t, error);
        let error = error.map_or_else(String::new, |error| format!(" ± {} s", with_significant_digits(error, 1)));
        let _ = writeln!(out, "  {} at t = {t} s{error} ({:?})", event.name, event.kind);
    }
    let _ = writeln!(out, "\nstate at t = {} s", with_reliable_digits(run.solution.t_end, None));
    let errors = run.digits.as_ref().and_then(CorrectDigits::errors_at_end);
    for at in shown_value_indices(run) {
        let (name, x) = (&run.names[at], run.end[at]);
        let error = errors.map_or_else(String::new, |errors| format!(" ± {}", with_significant_digits(errors[at], 1)));
        let _ = writeln!(out, "  {name} = {x}{error}");
    }
    out += &digits_in_words(run);
    out.push('\n');
    out += &impacts_in_words(run);
    if let Some(drift) = run.energy_drift {
        if run.solution.work.is_empty() {
            let _ = writeln!(out, "largest change of total energy: {} J", with_significant_digits(drift, 3));
        } else {
            let work = run.solution.work_end;
            let of_impacts = if scene.impacts.is_empty() { "" } else { " and of impacts" };
            let _ = writeln!(
                out,
                "work of drag and other loads without a potential{of_impacts}: {} J",
                with_significant_digits(work, 6)
            );
            let _ =
                writeln!(out, "largest change of total energy less this work: {} J", with_significant_digits(drift, 3));
        }
    }
    if let Some(report) = &run.solution.projection {
        out += &projection_in_words(run, report);
    }
    for drift in drifts_except_energy(run) {
        let _ =
            writeln!(out, "largest change of {}: {}", drift.integral.name, with_significant_digits(drift.change, 3));
    }
    out
}

/// Writes the samples of a run to a CSV file: time, shown values, energies, and derivatives if there are any. `Err` if
/// the file cannot be written.
fn write_csv(path: &Path, run: &Run, slopes: Option<&Sensitivities>) -> Result<(), Failure> {
    // A scene that lists outputs has no columns for energies.
    let energies = ["kinetic_energy", "potential_energy"].into_iter().filter(|_| !run.energies.is_empty());
    let energies = energies.chain(["work"].into_iter().filter(|_| !run.solution.work.is_empty()));
    let header: Vec<String> = ["t"]
        .into_iter()
        .chain(shown_value_indices(run).map(|at| run.names[at].as_str()))
        .chain(energies)
        .map(str::to_owned)
        .chain(slopes.into_iter().flat_map(sensitivity::sensitivity_header))
        .collect();
    let rows = run.solution.t.iter().zip(&run.states).enumerate().map(|(at, (t, state))| {
        let energies = run.energies.get(at).into_iter().flat_map(|(kinetic, potential)| [*kinetic, *potential]);
        let energies = energies.chain(run.solution.work.get(at).copied());
        let energies =
            energies.chain(slopes.into_iter().flat_map(move |slopes| sensitivity::sensitivity_row(slopes, at)));
        [*t].into_iter()
            .chain(shown_value_indices(run).map(|at| state[at]))
            .chain(energies)
            .map(|x| x.to_string())
            .collect()
    });
    write_table_file(path, &header, rows)
}

/// Checks the path for the samples before the run. Refuses an input file, an existing file that is no CSV file, and a
/// folder that does not exist. `Err` is the refusal.
fn check_csv(path: &Path, existing: ExistingFilePolicy, model: &Mechanism, scene: &Scene) -> Result<(), Failure> {
    refuse_overwriting_inputs(model, Some(scene), [path])?;
    let format = TableFormat::of_name(path)?;
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    if let Some(Err(error)) = folder.map(std::fs::metadata) {
        return Err(Failure::Output(path_as_plain_text(path), error));
    }
    let is_csv = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("csv"));
    let is_table = is_csv || format != TableFormat::Csv;
    if path.is_file() && !is_table && existing == ExistingFilePolicy::Kept && !path.starts_with("/dev") {
        let what = format!("the file `{}` exists, and its name does not end in `.csv`", path_as_plain_text(path));
        return Err(Failure::request(what, "give another --csv, or --overwrite to replace it".to_owned()));
    }
    Ok(())
}
