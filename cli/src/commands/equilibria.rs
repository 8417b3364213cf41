//! Command `tripos equilibria`: finds states in which a mechanism rests or moves steadily, and the stability of these
//! states.

mod closed_form;
mod equilibria_figure;
mod followed_motion;
mod range;

use super::linearise::{linearised_modes_json, linearised_motion_json, modes_text, motion_kind_words, state_json};
use crate::files::workspace::{read_model, short_name};
use crate::terminal::failure::{Failure, Output, print, print_json};
use range::Range;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::Error;
use tripos::studies::steady::{
    BranchesAt, FoundMotion, SteadyConditions, SteadyLinearSystem, conditions, find_equilibria as of_model,
};
use tripos_derive::diagnostic::Source;
use tripos_derive::plain_text::with_significant_digits;
use tripos_derive::scene::load_state_with_unknowns;

/// Starting points of the search for equilibria and steady motions.
pub struct StartingPoints<'a> {
    /// Path of the state file or scene to start from; `None` if only conditions in closed form are requested.
    pub file: Option<&'a Path>,
    /// Number of further starting points of the search.
    pub starts: u64,
}

/// Runs `tripos equilibria`: prints the conditions of rest and steady motion in closed form, and the motions found from
/// the state of a file. `over` has the ranges of numbers to follow, `wanted` the unknowns to solve for, and `out` the
/// path of a figure. Returns the exit status.
///
/// # Errors
/// `Failure` if a file has errors, if a range cannot be read, or if there is no steady motion to follow.
pub fn equilibria(
    model: &Path,
    from: &StartingPoints<'_>,
    over: &[String],
    wanted: &[String],
    out: Option<&Path>,
    output: Output,
) -> Result<u8, Failure> {
    let mut model = read_model(model)?;
    let Some(file) = from.file else {
        let closed = conditions(&model, wanted)?;
        if output == Output::Json {
            print_json(&json!({ "model": short_name(&model), "conditions": closed_form::json(&closed) }))?;
        } else {
            print(&format!("{}\n\n{}", model.title, closed_form::text(&closed)))?;
        }
        return Ok(0);
    };
    let source = Source::read(file)?;
    let asked = load_state_with_unknowns(&source, &mut model, &[])?;
    if let Some(out) = out {
        equilibria_figure::check_equilibria_figure_path(out, &model, file)?;
    }
    let ranges: Result<Vec<Range>, Error> = over.iter().map(|over| Range::new(&model, &asked, over)).collect();
    match ranges?.as_slice() {
        [] => {}
        [one] => return followed_motion::follow_along_number(&mut model, &source, one, out, output),
        [first, second] if first.name != second.name => {
            return followed_motion::map_over_two_numbers(&mut model, &source, [first, second], out, output);
        }
        _ => {
            let what = "a map is over two different numbers".to_owned();
            return Err(Failure::request(what, "give --over once or twice, each with another name".to_owned()));
        }
    }
    let found = of_model(&model, &asked, from.starts)?;
    let closed = conditions(&model, wanted)?;
    let on = |found: &FoundMotion| closed.branches_at(&asked.parameters, &found.steady);
    if output == Output::Json {
        let list: Vec<Value> = found.iter().map(|found| add_equilibrium_branches(json_of(found), on(found))).collect();
        let value = json!({ "model": short_name(&model), "steady": list, "conditions": closed_form::json(&closed) });
        print_json(&value)?;
    } else {
        let mut out = format!("{}\n", model.title);
        for found in &found {
            let _ = write!(out, "\n{}{}", text_of(found), equilibrium_branches_text(&closed, on(found)));
        }
        let _ = write!(out, "\n{}", closed_form::text(&closed));
        print(&out)?;
    }
    Ok(0)
}

/// Returns words for the closed-form solutions on which a motion lies. Empty if it lies on none.
fn equilibrium_branches_text(closed: &SteadyConditions, on: Option<BranchesAt>) -> String {
    let Some(BranchesAt { conditions, branches }) = on.filter(|on| !on.branches.is_empty()) else {
        return String::new();
    };
    let of = if closed.list[conditions].rest { "rest" } else { "steady motion" };
    let list: Vec<String> = branches.iter().map(|branch| (branch + 1).to_string()).collect();
    format!("by its numbers on solution {} of {of} below\n", list.join(", "))
}

/// Adds the closed-form solutions on which a motion lies, by their indices, to the JSON of the
/// motion.
fn add_equilibrium_branches(mut value: Value, on: Option<BranchesAt>) -> Value {
    if let Some(BranchesAt { conditions, branches }) = on {
        value["on"] = json!({ "conditions": conditions, "branches": branches });
    }
    value
}

/// Returns a motion that was found as JSON.
fn json_of(found: &FoundMotion) -> Value {
    match &found.about {
        Ok(about) => point_of(about),
        Err(why) => {
            json!({ "residual": found.steady.residual, "at": found.steady.x.iter().map(|x| x.hi()).collect::<Vec<_>>(), "not_linearised": why.first_line() })
        }
    }
}

/// Returns a linearised equilibrium or steady motion as JSON: state, stability, eigenvalues and
/// modes.
fn point_of(about: &SteadyLinearSystem) -> Value {
    json!({
        "at": state_json(about),
        "rest": about.moves.is_empty(),
        "moves": linearised_motion_json(about),
        "residual": about.steady.residual,
        "stability": about.stability.name(),
        "power_of_t": about.stability.growth_power(),
        "family": about.family,
        "eigenvalues": about.modes.iter().map(|mode| mode.value).collect::<Vec<_>>(),
        "modes": linearised_modes_json(about),
    })
}

/// Returns a motion that was found as text.
fn text_of(found: &FoundMotion) -> String {
    let mut out = String::new();
    let about = match &found.about {
        Ok(about) => about,
        Err(why) => {
            let x: Vec<String> = found.steady.x.iter().map(|x| format!("{:?}", x.hi())).collect();
            return format!("balanced at {}, and not linearised: {}\n", x.join(", "), why.first_line());
        }
    };
    let _ = writeln!(
        out,
        "{}, largest residual {}",
        motion_kind_words(about),
        with_significant_digits(about.steady.residual, 2)
    );
    for (name, x) in about.states() {
        let _ = writeln!(out, "  {name} = {x:?}");
    }
    let _ = write!(out, "eigenvalues, 1/s\n{}", modes_text(about));
    out
}
