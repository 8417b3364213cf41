//! Command `tripos fit`: finds parameters from measured motions, or from measured motions and forces.

use super::identify::combination;
use crate::arguments::Fit as Request;
use crate::files::output_files::{refuse_overwriting_files, refuse_overwriting_inputs, write_table_file};
use crate::files::scene_file::{read_scene, set_scene_values};
use crate::files::workspace::{model_file, read_model};
use crate::terminal::failure::{Failure, print, print_json, status, warn};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::fit::force_fit::{ForceFit, fit_to_forces};
use tripos::fit::motion_tables::{MotionTable, motion_of_table};
use tripos::fit::possible_inertia::{PossibleInertia, possible_inertia};
use tripos::fit::run_fit::{Experiment, fit_to_runs};
use tripos::fit::{Fit, FitOptions};
use tripos::studies::identification::identify;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::RegressorParameters;
use tripos_derive::plain_text::{path_as_plain_text, with_reliable_digits};
use tripos_derive::scene::{MeasuredTable, is_scene};

/// Correlation above which a pair of estimates is listed.
const HIGH: f64 = 0.9;
/// Residual of a loop at measured coordinates above which the loop is not closed, in the unit of the loop.
const OPEN: f64 = 1e-2;
/// Ratio of the residuals of unseen and seen instants above which the fit does not carry over.
const UNSEEN: f64 = 1.5;

/// Runs `tripos fit`: fits a scene to measured motions, or base parameters to measured forces, and prints the
/// estimates. Returns the exit status: 1 if the data leave a combination open, 3 if a search does not come to an end.
///
/// # Errors
/// `Failure` if a file or an option has errors, or if a run or the regressor has no values.
pub fn fit(request: &Request) -> Result<u8, Failure> {
    let is_of_scene = Source::read(&model_file(&request.target)).is_ok_and(|source| is_scene(&source));
    check_options(request, is_of_scene)?;
    if let Some(path) = &request.residuals {
        refuse_overwriting_files(&request.data, path)?;
    }
    let options = FitOptions { is_robust: request.robust, noise: request.named_deviations()?, ..FitOptions::default() };
    let tables = request.data.iter().map(|path| Ok(MeasuredTable::read(&Source::read(path)?)?));
    let tables = tables.collect::<Result<Vec<_>, Failure>>()?;
    let (fit, of_forces, possible) = if is_of_scene {
        (fit_scene(request, tables, &options)?, None, None)
    } else {
        let (of_forces, possible) = fit_model(request, &tables, &options)?;
        (of_forces.fit.clone(), Some(of_forces), possible)
    };
    for quantity in fit.quantities.iter().filter(|quantity| quantity.has_pattern) {
        warn(&format!(
            "neighbouring residuals of `{}` are alike: the model lacks something, or the search ended at a wrong minimum; standard errors are too small",
            quantity.name
        ));
    }
    if let Some(path) = &request.residuals {
        write_residuals(path, request, &fit)?;
    }
    let unseen = of_forces.as_ref().and_then(|of_forces| of_forces.unseen);
    if request.json {
        print_json(&json_of(request, &fit, unseen, possible.as_ref()))?;
    } else {
        print(&text_of(request, &fit, unseen, possible.as_ref()))?;
    }
    if !fit.has_converged {
        warn("the search did not come to an end: start it nearer to the data, or give bounds");
    }
    if possible.as_ref().is_some_and(|possible| !possible.has_converged) {
        warn("the search for possible inertias did not come to an end: state masses and inertias nearer to the data");
    }
    if !fit.has_converged || possible.is_some_and(|possible| !possible.has_converged) {
        return Ok(status::STOPPED);
    }
    Ok(if fit.untold.is_empty() { 0 } else { status::NO })
}

/// Checks that the options belong to the kind of the fit.
///
/// # Errors
/// `Failure` that names the first option of the other kind.
fn check_options(request: &Request, is_of_scene: bool) -> Result<(), Failure> {
    let of_models =
        [("--declared", request.declared), ("--possible", request.possible), ("--filter", request.filter.is_some())];
    let of_scenes = [
        ("--for", !request.unknowns.is_empty()),
        ("--prior", !request.priors.is_empty()),
        ("--set", !request.set.set.is_empty()),
    ];
    let (others, own, other) =
        if is_of_scene { (of_models, "a scene", "a model") } else { (of_scenes, "a model", "a scene") };
    if let Some((name, _)) = others.iter().find(|(_, is_given)| *is_given) {
        let what =
            format!("`{name}` belongs to the fit of {other}, and `{}` is {own}", path_as_plain_text(&request.target));
        return Err(Failure::request(what, format!("leave `{name}` out, or give {other}")));
    }
    for (name, is_given) in [("--until", request.how.until.is_some()), ("--samples", request.how.samples.is_some())] {
        if is_given {
            let help = format!("leave `{name}` out: the table states the instants");
            return Err(Failure::request(format!("`{name}` means nothing for a fit"), help));
        }
    }
    if let Some(twice) =
        request.data.iter().enumerate().find_map(|(at, path)| request.data[..at].contains(path).then_some(path))
    {
        let what = format!("`{}` is given twice", path_as_plain_text(twice));
        return Err(Failure::request(what, "give each table once"));
    }
    if is_of_scene && request.unknowns.is_empty() {
        let help = "name parameters or numbers of the start, as in `--for m --for theta`";
        return Err(Failure::request("nothing is to be fitted", help));
    }
    if request.possible && request.declared {
        let help = "leave `--declared` out: possible inertias are about all ten parameters of every body";
        return Err(Failure::request("`--possible` and `--declared` exclude one another", help));
    }
    Ok(())
}

/// Fits a scene to measured motions.
///
/// # Errors
/// `Failure` if the scene, an option or a table has errors, or if a run has no values.
fn fit_scene(request: &Request, tables: Vec<MeasuredTable>, options: &FitOptions) -> Result<Fit, Failure> {
    let (mut mechanism, scene) = read_scene(&request.target)?;
    refuse_overwriting_inputs(&mechanism, Some(&scene), request.residuals.as_deref())?;
    let (_, set) = set_scene_values(scene.clone(), &mut mechanism, &request.set.set)?;
    let scene = tripos::Scene::from_description(mechanism, scene).with_numbers(&set)?;
    let unknowns = request.unknowns()?;
    let named = request.data.iter().zip(tables);
    let experiments =
        named.map(|(path, table)| Experiment { name: path_as_plain_text(path), scene: scene.clone(), table });
    Ok(fit_to_runs(experiments.collect(), &unknowns, options, &request.how.overrides()?)?)
}

/// Fits the base parameters of a model to measured motions and forces.
///
/// # Errors
/// `Failure` if the model or a table has errors, or if the regressor has no values.
fn fit_model(
    request: &Request,
    tables: &[MeasuredTable],
    options: &FitOptions,
) -> Result<(ForceFit, Option<PossibleInertia>), Failure> {
    let model = read_model(&request.target)?;
    refuse_overwriting_inputs(&model, None, request.residuals.as_deref())?;
    let varied = if request.declared { RegressorParameters::Declared } else { RegressorParameters::Bodies };
    let found = identify(&model, varied)?;
    let mut options = options.clone();
    let mut experiments = Vec::new();
    for (path, table) in request.data.iter().zip(tables) {
        let name = path_as_plain_text(path);
        let MotionTable { motions, rows_for_each_error, unused, has_inputs_and_forces, open } =
            motion_of_table(&model, &name, table, request.filter)?;
        options.rows_for_each_error = options.rows_for_each_error.max(rows_for_each_error);
        experiments.push(motions);
        if !unused.is_empty() {
            warn(&format!("columns of `{name}` that are not used: {}", unused.join(", ")));
        }
        if has_inputs_and_forces {
            warn(&format!("`{name}` has inputs and forces: the forces act beside the inputs"));
        }
        if open > OPEN {
            warn(&format!("the coordinates of `{name}` leave a loop open by {}", with_reliable_digits(open, None)));
        }
    }
    let mut fit = fit_to_forces(&model, &found, &experiments, &options)?;
    for (estimate, base) in fit.fit.estimates.iter_mut().zip(&found.base) {
        estimate.name = combination(&found, base);
    }
    if let Some(unseen) = fit.unseen.filter(|unseen| *unseen > UNSEEN) {
        warn(&format!(
            "instants that were left out of the fit have residuals of {unseen:.2} standard deviations: the model does not carry over to them"
        ));
    }
    let possible = request.possible.then(|| possible_inertia(&model, &found, &experiments, &fit)).transpose()?;
    Ok((fit, possible))
}

/// Writes the residuals to a table: a row for each measured value.
///
/// # Errors
/// `Failure` if the file cannot be written.
fn write_residuals(path: &Path, request: &Request, fit: &Fit) -> Result<(), Failure> {
    let rows = fit.quantities.iter().flat_map(|quantity| {
        let file = path_as_plain_text(&request.data[quantity.experiment]);
        quantity.residuals.iter().enumerate().map(move |(at, residual)| {
            let t = quantity.instants.get(at).map_or_else(String::new, |t| format!("{t:?}"));
            vec![
                file.clone(),
                quantity.name.clone(),
                t,
                format!("{residual:?}"),
                format!("{:?}", residual / quantity.noise),
            ]
        })
    });
    write_table_file(path, &["data", "quantity", "t", "residual", "in_deviations"], rows)
}

/// Returns the name of an unknown, with its file if it belongs to one of several experiments.
fn name_of_estimate(request: &Request, fit: &Fit, at: usize) -> String {
    let estimate = &fit.estimates[at];
    match estimate.experiment {
        Some(experiment) => format!("{} in {}", estimate.name, path_as_plain_text(&request.data[experiment])),
        None => estimate.name.clone(),
    }
}

/// Returns the result of a fit as text.
fn text_of(request: &Request, fit: &Fit, unseen: Option<f64>, possible: Option<&PossibleInertia>) -> String {
    let mut out = String::new();
    let is_of_scene = !request.unknowns.is_empty();
    for (at, estimate) in fit.estimates.iter().enumerate() {
        let name = name_of_estimate(request, fit, at);
        let value = with_reliable_digits(estimate.value, estimate.error.map(|error| error / 10.0));
        let unit = if estimate.unit.is_empty() { String::new() } else { format!(" {}", estimate.unit) };
        let _ = match estimate.error {
            Some(error) => write!(out, "{name} = {value} ± {}{unit}", with_reliable_digits(error, Some(error / 100.0))),
            None if estimate.is_at_bound => write!(out, "{name} = {value}{unit}, at its bound"),
            None => write!(out, "{name} = {value}{unit}, not told by the data"),
        };
        if let Some(stated) = estimate.stated {
            let kind = if is_of_scene { "scene" } else { "model" };
            let _ = write!(out, "  ({kind}: {})", with_reliable_digits(stated, None));
        }
        out.push('\n');
    }
    out.push('\n');
    for quantity in &fit.quantities {
        let of = if request.data.len() > 1 {
            format!(" in {}", path_as_plain_text(&request.data[quantity.experiment]))
        } else {
            String::new()
        };
        let _ = writeln!(
            out,
            "{}{of}: {} values, residuals {} (root mean square)",
            quantity.name,
            quantity.residuals.len(),
            with_reliable_digits(quantity.root_mean_square(), None)
        );
    }
    if let Some(unseen) = unseen {
        let _ = writeln!(
            out,
            "instants left out of the fit, a fifth at a time: residuals of {unseen:.2} standard deviations"
        );
    }
    for direction in &fit.untold {
        let parts: Vec<String> = direction
            .iter()
            .map(|(at, rate)| {
                format!("{} changes by {}", name_of_estimate(request, fit, *at), with_reliable_digits(*rate, None))
            })
            .collect();
        let _ = writeln!(out, "not told by the data: no measured value changes if {}", parts.join(" and "));
    }
    for (at, row) in fit.correlations.iter().enumerate() {
        for (other, correlation) in
            row.iter().enumerate().skip(at + 1).filter(|(_, correlation)| correlation.abs() > HIGH)
        {
            let names = [at, other].map(|at| name_of_estimate(request, fit, at));
            let _ = writeln!(out, "correlation of {} and {}: {correlation:.3}", names[0], names[1]);
        }
    }
    if let Some(possible) = possible {
        let _ = writeln!(
            out,
            "\ninertias that bodies can have: residuals of {:.3} standard deviations, {:.3} without this condition",
            possible.residual, possible.free_residual
        );
        for (name, unit, value) in &possible.parameters {
            let _ = writeln!(out, "  {name} = {} {unit}", with_reliable_digits(*value, None));
        }
    }
    out
}

/// Returns the result of a fit as JSON.
fn json_of(request: &Request, fit: &Fit, unseen: Option<f64>, possible: Option<&PossibleInertia>) -> Value {
    let file = |experiment: usize| path_as_plain_text(&request.data[experiment]);
    let estimates = fit.estimates.iter().map(|estimate| {
        json!({
            "name": estimate.name, "data": estimate.experiment.map(file), "unit": estimate.unit,
            "value": estimate.value, "error": estimate.error, "stated": estimate.stated,
            "at_bound": estimate.is_at_bound,
        })
    });
    let quantities = fit.quantities.iter().map(|quantity| {
        json!({
            "name": quantity.name, "data": file(quantity.experiment), "values": quantity.residuals.len(),
            "root_mean_square": quantity.root_mean_square(), "noise": quantity.noise,
        })
    });
    let untold = fit.untold.iter().map(|direction| {
        let part = |(at, rate): &(usize, f64)| json!([name_of_estimate(request, fit, *at), rate]);
        Value::Array(direction.iter().map(part).collect())
    });
    let possible = possible.map(|possible| {
        let parameters = possible.parameters.iter();
        json!({
            "residual": possible.residual, "free_residual": possible.free_residual,
            "parameters": parameters.map(|(name, unit, value)| json!({ "name": name, "unit": unit, "value": value })).collect::<Vec<_>>(),
        })
    });
    json!({
        "estimates": estimates.collect::<Vec<_>>(),
        "quantities": quantities.collect::<Vec<_>>(),
        "correlations": fit.correlations,
        "untold": untold.collect::<Vec<_>>(),
        "unseen": unseen,
        "possible": possible,
        "steps": fit.steps,
        "converged": fit.has_converged,
    })
}
