//! Command `tripos identify`: finds the inertial parameters that can be identified from motion, and evaluates the
//! regressor.

use super::inverse::{Shape, read_motion, table};
use crate::files::workspace::{read_model, short_name};
use crate::terminal::failure::{Failure, print, print_json};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::Mechanism;
use tripos::studies::identification::{RegressorRow, base_parameter_values, identify as of_model, regressor_rows};
use tripos::studies::inverse::motion_samples;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::Numeric;
use tripos_derive::identify::{BaseParameter, BaseParameterFactor, Completeness, Identification};
use tripos_derive::mechanics::{ColumnParameter, RegressorParameters};
use tripos_derive::scene::MotionSample;
use tripos_traits::DoubleDouble;

/// Runs `tripos identify`: finds the base parameters of a model, and prints the regressor at the
/// states of a file. Returns the exit status, 1 if the base parameters do not reproduce the
/// dynamics.
///
/// # Errors
/// `Failure` if a file has errors, or the model cannot be derived.
pub fn identify(model: &Path, varied: RegressorParameters, at: Option<&Path>, shape: Shape) -> Result<u8, Failure> {
    let mut model = read_model(model)?;
    let motion = at.map(|at| read_motion(at, &mut model)).transpose()?;
    let mut found = of_model(&model, varied)?;
    // Groups of parameters that were found from closed poses are valid only for the values of the model file.
    if motion.as_ref().is_some_and(|motion| !is_at_defaults(&model, &motion.parameters)) {
        found.ungroup();
    }
    let parameters = motion.as_ref().map(|motion| motion.parameters.clone()).or_else(|| defaults(&model));
    let known = parameters.as_ref().map(|p| base_parameter_values(&model, &found, p)).transpose()?;
    let regressor = match &motion {
        Some(motion) => {
            let states = motion_samples(&model, motion)?;
            let rows = regressor_rows(&model, &found, &motion.parameters, &states)?;
            Some((states, rows))
        }
        None => None,
    };
    match (shape, &regressor) {
        (Shape::Json, regressor) => {
            let mut value = json_of(&model, &found, varied, known.as_deref());
            if let Some((states, rows)) = regressor {
                value["regressor"] = rows.iter().map(|row| json_of_row(&model, states, row)).collect();
            }
            print_json(&value)?;
        }
        (Shape::Csv, Some((states, rows))) => print(&csv_of(&model, &found, states, rows))?,
        _ => print(&text_of(&model, &found, known.as_deref()))?,
    }
    Ok(u8::from(found.complete == Completeness::No))
}

/// Returns the parameter values of the model file, in the order of the model, with 0 for inputs. `None` if a parameter
/// has no value.
fn defaults(model: &Mechanism) -> Option<Vec<DoubleDouble>> {
    let value = |p: &tripos_derive::model::Parameter| match &p.value {
        Some(value) => Some(DoubleDouble::from_rational(value)),
        None => p.is_input.then(|| 0.0.into()),
    };
    model.parameters.iter().map(value).collect()
}

/// True if all parameters except inputs have the values of the model file.
fn is_at_defaults(model: &Mechanism, parameters: &[DoubleDouble]) -> bool {
    let mut known = model.parameters.iter().zip(parameters).filter(|(p, _)| !p.is_input);
    known.all(|(p, x)| p.value.as_ref().is_some_and(|value| DoubleDouble::from_rational(value) == *x))
}

/// Returns the name of the parameter of a regressor column.
fn parameter_name_of_column(found: &Identification, column: usize) -> &str {
    &found.regressor.columns[column].name
}

/// Returns a factor of a combination as text, in parentheses if it is a sum.
fn factor_text(found: &Identification, factor: &BaseParameterFactor) -> String {
    match factor {
        BaseParameterFactor::Exact(e) => {
            let text = print_text(&found.regressor.arena, *e);
            if text.contains(' ') { format!("({text})") } else { text }
        }
        BaseParameterFactor::Number(x) => format!("{x:?}"),
        BaseParameterFactor::Unknown => "?".to_owned(),
    }
}

/// Returns a base parameter as text: a sum of parameters with factors.
pub(super) fn combination(found: &Identification, base: &BaseParameter) -> String {
    let mut out = parameter_name_of_column(found, base.column).to_owned();
    for (column, factor) in &base.with {
        let (name, factor) = (parameter_name_of_column(found, *column), factor_text(found, factor));
        let _ = match (factor.as_str(), factor.strip_prefix('-')) {
            ("1", _) => write!(out, " + {name}"),
            ("-1", _) => write!(out, " - {name}"),
            (_, Some(size)) => write!(out, " - {size}*{name}"),
            _ => write!(out, " + {factor}*{name}"),
        };
    }
    out
}

/// Returns the result of the identification as JSON. `values` are the values of the base parameters, if known.
fn json_of(
    model: &Mechanism,
    found: &Identification,
    varied: RegressorParameters,
    values: Option<&[Option<DoubleDouble>]>,
) -> Value {
    let regressor = &found.regressor;
    let columns = regressor.columns.iter().map(|column| {
        let of = match column.of {
            ColumnParameter::Body(body, _) => json!({ "body": model.bodies[body].name }),
            ColumnParameter::Parameter(at) => json!({ "about": model.parameters[at].about }),
        };
        json!({ "name": column.name, "unit": column.unit.to_string(), "of": of, "stated": print_text(&regressor.arena, column.stated) })
    });
    let factor = |(column, factor): &(usize, BaseParameterFactor)| match factor {
        BaseParameterFactor::Number(x) => json!([parameter_name_of_column(found, *column), x]),
        other => json!([parameter_name_of_column(found, *column), factor_text(found, other)]),
    };
    let base = |(at, base): (usize, &BaseParameter)| {
        json!({
            "name": parameter_name_of_column(found, base.column),
            "with": base.with.iter().map(factor).collect::<Vec<_>>(),
            "combination": combination(found, base),
            "value": values.and_then(|values| values[at]).map(DoubleDouble::hi),
        })
    };
    let names = |list: &mut dyn Iterator<Item = usize>| {
        list.map(|at| parameter_name_of_column(found, at).to_owned()).collect::<Vec<_>>()
    };
    let frames = regressor.anchors.iter().map(|anchor| {
        let (point, frame) = (&model.points[anchor.point].name, &model.frames[anchor.frame].name);
        json!({ "body": model.bodies[anchor.body].name, "point": point, "frame": frame })
    });
    let (word, bound) = match found.complete {
        // The proof covers the formulas before parameters were grouped by numbers at closed poses.
        Completeness::Proved(_) if found.before_grouping().is_some() => {
            ("proved before it was grouped in closed poses", None)
        }
        Completeness::Proved(bound) => ("proved", Some(bound)),
        Completeness::AtPoints => ("at random points", None),
        Completeness::Undecided => ("undecided", None),
        Completeness::No => ("no", None),
    };
    json!({
        "model": short_name(model),
        "bodies": if varied == RegressorParameters::Bodies { "general" } else { "declared" },
        "about": frames.collect::<Vec<_>>(),
        "parameters": columns.collect::<Vec<_>>(),
        "count": found.is_minimal().then_some(found.base.len()),
        "base": found.base.iter().enumerate().map(base).collect::<Vec<_>>(),
        "alone": names(&mut found.single_base_parameters()),
        "without_effect": names(&mut found.without_effect.iter().copied()),
        "grouped_by_loops": found.grouped.iter().map(|group| combination(found, group)).collect::<Vec<_>>(),
        "minimal": found.is_minimal().then(|| json!({ "rank": found.base.len(), "states": found.states })),
        "complete": { "is": word, "false_below_2_to_minus": bound },
        "on_loops": found.on_loops.map(|seen| {
            json!({
                "poses": seen.poses, "independent": finite_or_none(seen.independent), "dependent": seen.dependent,
                "clear": seen.is_clear,
            })
        }),
    })
}

/// Returns a finite number unchanged, and `None` for infinity and NaN, which JSON cannot represent.
fn finite_or_none(x: f64) -> Option<f64> {
    x.is_finite().then_some(x)
}

/// Returns a row of the regressor as JSON.
fn json_of_row(model: &Mechanism, states: &[MotionSample], row: &RegressorRow) -> Value {
    json!({
        "t": states[row.state].t, "state": row.state, "speed": model.speeds[row.speed].name,
        "factors": row.factors.iter().map(|x| x.hi()).collect::<Vec<_>>(), "rest": row.rest.hi(),
    })
}

/// Returns the regressor as CSV. The columns are the time t in s if known, the state, the speed of the row, each base
/// parameter, and the known remainder.
fn csv_of(model: &Mechanism, found: &Identification, states: &[MotionSample], rows: &[RegressorRow]) -> String {
    let names: Vec<&str> = found.base.iter().map(|base| parameter_name_of_column(found, base.column)).collect();
    let heads: Vec<&str> = ["t", "state", "speed"].into_iter().chain(names).chain(["rest"]).collect();
    table(
        &heads,
        rows.iter().map(|row| {
            let t = states[row.state].t.map_or_else(String::new, |t| format!("{t:?}"));
            let numbers = row.factors.iter().chain([&row.rest]).map(|x| format!("{:?}", x.hi()));
            [t, row.state.to_string(), model.speeds[row.speed].name.clone()].into_iter().chain(numbers).collect()
        }),
    )
}

/// Returns the result of the identification as text.
fn text_of(model: &Mechanism, found: &Identification, values: Option<&[Option<DoubleDouble>]>) -> String {
    let regressor = &found.regressor;
    let mut out = format!("{}: what can be identified from motion\n", model.title);
    if !regressor.anchors.is_empty() {
        out.push_str("\nmass m, first moments mx, my, mz and inertias Ixx … of each body about a point, in axes that are fixed in it\n");
    }
    for anchor in &regressor.anchors {
        let (point, frame) = (&model.points[anchor.point].name, &model.frames[anchor.frame].name);
        let _ = writeln!(out, "  {}: about {point}, axes of {frame}", model.bodies[anchor.body].name);
    }
    let at_most = if found.is_minimal() { "" } else { "at most " };
    let _ = writeln!(out, "\n{at_most}{} base parameters of {} parameters", found.base.len(), regressor.columns.len());
    for (at, base) in found.base.iter().enumerate() {
        let value = values.and_then(|values| values[at]).map_or_else(String::new, |x| format!(" = {:?}", x.hi()));
        let unit = regressor.columns[base.column].unit.to_string();
        let unit = if value.is_empty() { unit } else { format!(" {unit}") };
        let gap = if value.is_empty() { ", in " } else { "" };
        let _ = writeln!(out, "  {}{value}{gap}{unit}", combination(found, base));
    }
    for group in &found.grouped {
        let _ = writeln!(
            out,
            "where {} stands for {}",
            parameter_name_of_column(found, group.column),
            combination(found, group)
        );
    }
    if !found.without_effect.is_empty() {
        let names: Vec<&str> = found.without_effect.iter().map(|at| parameter_name_of_column(found, *at)).collect();
        let _ = writeln!(out, "\nof no effect: {}", names.join(", "));
    }
    let _ = writeln!(out, "\n{}", certainty_sentences(found));
    out
}

/// Returns sentences about the certainty of the result: whether a base parameter may be redundant or missing.
fn certainty_sentences(found: &Identification) -> String {
    let minimal = format!(
        "none can be left out: the regressor has rank {} at {} random states modulo a prime",
        found.base.len(),
        found.states
    );
    let complete = match found.complete {
        Completeness::Proved(bound) => {
            let zero = format!("is zero by exact algebra (wrong with a probability below 2^-{bound:.0})");
            if let Some(count) = found.before_grouping() {
                format!(
                    "they are enough: M u' - f less the terms of {count} base parameters {zero}; closed poses group these {count}, and factors that are numbers hold in the sampled poses"
                )
            } else {
                format!("they are enough: M u' - f less the terms of the base parameters {zero}")
            }
        }
        Completeness::AtPoints => {
            "they are enough at random states and parameters modulo a prime; factors marked ? have no short closed form"
                .to_owned()
        }
        Completeness::Undecided => {
            "whether they are enough is not decided: the equations contain functions that algebra has no rules for"
                .to_owned()
        }
        Completeness::No => "the base parameters do not reproduce M u' - f: please report this model".to_owned(),
    };
    if found.is_minimal() && found.on_loops.is_none() {
        return format!("{minimal}\n{complete}");
    }
    let of_loops = match &found.on_loops {
        Some(seen) if seen.is_clear => format!(
            "where the loops are closed, at the values of the file: rank {} in {} poses; what is dependent is so to {:.0e}, the next is {:.0e} away",
            found.base.len(),
            seen.poses,
            seen.dependent,
            seen.independent
        ),
        Some(seen) => format!(
            "where the loops are closed, fewer may do, and their number is not decided: {} poses show no clear gap between dependent parameters ({:.0e}) and independent ones ({:.0e}); choose speeds that move the mechanism in more poses, or other values",
            seen.poses, seen.dependent, seen.independent
        ),
        None => "where the loops are closed, fewer may do, and their number is not decided: no closed pose was found at the values of the file, or a parameter has no value".to_owned(),
    };
    format!("{of_loops}\n{complete}")
}
