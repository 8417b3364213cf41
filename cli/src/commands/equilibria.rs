//! `tripos equilibria`: where a mechanism rests or moves steadily, and whether it stays there.

mod figure;
mod followed;
mod range;

use super::linearise::{kind_of, modes_of, modes_text, moves_of, state_of};
use crate::failure::{Failure, print, print_json};
use crate::workspace::{read_model, short_name};
use range::Range;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::Error;
use tripos::steady::{About, Found, equilibria as of_model};
use tripos_derive::diagnostic::Source;
use tripos_derive::scene::load_asked;

/// Finds the steady motions of a model from the state of a file.
pub fn equilibria(
    model: &Path,
    from: &Path,
    starts: u64,
    over: &[String],
    out: Option<&Path>,
    as_json: bool,
) -> Result<u8, Failure> {
    let mut model = read_model(model)?;
    let source = Source::read(from)?;
    let asked = load_asked(&source, &mut model, &[])?;
    if let Some(out) = out {
        figure::check(out, &model, from)?;
    }
    let ranges: Result<Vec<Range>, Error> = over.iter().map(|over| Range::new(&model, &asked, over)).collect();
    match ranges?.as_slice() {
        [] => {}
        [one] => return followed::along(&mut model, &source, one, out, as_json),
        [first, second] if first.name != second.name => {
            return followed::over_two(&mut model, &source, [first, second], out, as_json);
        }
        _ => {
            let what = "a map is over two different numbers".to_owned();
            return Err(Failure::request(what, "give --over once or twice, each with another name".to_owned()));
        }
    }
    let found = of_model(&model, &asked, starts)?;
    if as_json {
        let list: Vec<Value> = found.iter().map(json_of).collect();
        print_json(&json!({ "model": short_name(&model), "steady": list }))?;
    } else {
        let mut out = format!("{}\n", model.title);
        for found in &found {
            let _ = write!(out, "\n{}", text_of(found));
        }
        print(&out)?;
    }
    Ok(0)
}

fn json_of(found: &Found) -> Value {
    match &found.about {
        Ok(about) => point_of(about),
        Err(why) => {
            json!({ "residual": found.steady.residual, "at": found.steady.x.iter().map(|x| x.hi()).collect::<Vec<_>>(), "not_linearised": why.first_line() })
        }
    }
}

fn point_of(about: &About) -> Value {
    json!({
        "at": state_of(about),
        "rest": about.moves.is_empty(),
        "moves": moves_of(about),
        "residual": about.steady.residual,
        "stability": about.stability.name(),
        "family": about.family,
        "eigenvalues": about.modes.iter().map(|mode| mode.value).collect::<Vec<_>>(),
        "modes": modes_of(about),
    })
}

fn text_of(found: &Found) -> String {
    let mut out = String::new();
    let about = match &found.about {
        Ok(about) => about,
        Err(why) => {
            let x: Vec<String> = found.steady.x.iter().map(|x| x.hi().to_string()).collect();
            return format!("steady at {}, and not linearised: {}\n", x.join(", "), why.first_line());
        }
    };
    let _ = writeln!(out, "{}, what is left of the balance {:.1e}", kind_of(about), about.steady.residual);
    for (name, x) in about.all.iter().zip(&about.steady.x) {
        let _ = writeln!(out, "  {name} = {:?}", x.hi());
    }
    let _ = write!(out, "eigenvalues, 1/s\n{}", modes_text(about));
    out
}
