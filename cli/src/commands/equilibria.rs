//! `tripos equilibria`: where a mechanism rests or moves steadily, and whether it stays there.

use super::linearise::{kind_of, modes_of, modes_text, moves_of, state_of, value_text};
use crate::failure::{Failure, print, print_json};
use crate::workspace::{read_model, short_name};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::steady::{About, Course, Crossing, CrossingKind, Found, equilibria as of_model, follow};
use tripos::{Error, Mechanism};
use tripos_derive::diagnostic::Source;
use tripos_derive::scene::{Asked, load_asked};

/// Finds the steady motions of a model from the state of a file.
pub fn equilibria(model: &Path, from: &Path, starts: u64, over: Option<&str>, as_json: bool) -> Result<u8, Failure> {
    let mut model = read_model(model)?;
    let source = Source::read(from)?;
    let asked = load_asked(&source, &mut model, &[])?;
    if let Some(over) = over {
        return along(&mut model, &source, &asked, over, as_json);
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

/// Follows a steady motion along a number.
fn along(model: &mut Mechanism, source: &Source, asked: &Asked, over: &str, as_json: bool) -> Result<u8, Failure> {
    let (name, values) = values(model, asked, over)?;
    let of_model = model.clone();
    let mut asked_at = |value: f64| Ok(load_asked(source, model, &[(name.clone(), value)])?);
    let course = follow(&of_model, &mut asked_at, &values)?;
    if as_json {
        let point = |point: &tripos::steady::Point| {
            let mut value = point_of(&point.about);
            value["value"] = json!(point.value);
            value
        };
        let crossing = |c: &Crossing| json!({ "kind": word(c.kind), "value": c.value, "frequency": c.frequency });
        print_json(&json!({
            "model": short_name(model),
            "over": name,
            "points": course.points.iter().map(point).collect::<Vec<_>>(),
            "crossings": course.crossings.iter().map(crossing).collect::<Vec<_>>(),
            "ended": course.ended,
        }))?;
    } else {
        print(&course_text(model, &name, &course))?;
    }
    Ok(0)
}

fn word(kind: CrossingKind) -> &'static str {
    match kind {
        CrossingKind::Real => "real",
        CrossingKind::Pair => "pair",
        CrossingKind::Fold => "fold",
    }
}

fn course_text(model: &Mechanism, name: &str, course: &Course) -> String {
    let mut out = format!("{}, over {name}\n\n", model.title);
    for point in &course.points {
        let list = point.about.modes.iter().filter(|mode| mode.value[1] >= 0.0);
        let list: Vec<String> = list.map(|mode| value_text(mode, 9)).collect();
        let _ = writeln!(out, "{name} = {}: {}; {}", point.value, point.about.stability.name(), list.join(", "));
    }
    if !course.crossings.is_empty() {
        out.push('\n');
    }
    for crossing in &course.crossings {
        let value = crossing.value;
        let _ = match crossing.kind {
            CrossingKind::Real => writeln!(out, "{name} = {value}: a real eigenvalue passes 0"),
            CrossingKind::Pair => {
                writeln!(out, "{name} = {value}: a pair passes the imaginary axis at {} rad/s", crossing.frequency)
            }
            CrossingKind::Fold => writeln!(out, "{name} = {value}: it ends there"),
        };
    }
    if let Some(ended) = &course.ended {
        let _ = writeln!(out, "{ended}");
    }
    out
}

/// What `NAME=FROM:TO:COUNT` says.
fn values(model: &Mechanism, asked: &Asked, over: &str) -> Result<(String, Vec<f64>), Error> {
    let how = "write NAME=FROM:TO:COUNT, such as v=0:10:11";
    let wrong = || Error::request(format!("`{over}` are no values to follow"), how);
    let (name, range) = over.split_once('=').ok_or_else(wrong)?;
    let parts: Vec<&str> = range.split(':').collect();
    let [from, to, count] = parts.as_slice() else { return Err(wrong()) };
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite()).ok_or_else(wrong);
    let (from, to) = (number(from)?, number(to)?);
    let count: u32 = count.trim().parse().map_err(|_| wrong())?;
    if !(2..=100_000).contains(&count) {
        return Err(Error::request(format!("{count} values are none to follow"), "give from 2 to 100000 values"));
    }
    let name = name.trim();
    let held = |at: usize| !asked.sought.contains(&at);
    let states = model.coordinates.iter().map(|c| &c.name).chain(model.speeds.iter().map(|s| &s.name)).enumerate();
    let states = states.filter(|(at, _)| held(*at)).map(|(_, name)| name.as_str());
    let known =
        model.parameters.iter().map(|p| p.name.as_str()).chain(asked.names.iter().map(|(name, ..)| name.as_str()));
    let known: Vec<&str> = known.chain(states).collect();
    if !known.contains(&name) {
        let help = tripos_derive::diagnostic::nearest(name, known);
        return Err(Error::request(format!("there is no `{name}` to follow along"), help));
    }
    let value = |at: u32| from + (to - from) * f64::from(at) / f64::from(count - 1);
    Ok((name.to_owned(), (0..count).map(value).collect()))
}
