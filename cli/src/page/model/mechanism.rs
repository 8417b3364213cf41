//! Section of the page about the mechanism: parameters, coordinates, speeds, constraints, bodies and loads.

use crate::page::markup::formula_mathml::{
    MathmlSide, breakable_mathml, distinct_symbol_mathml, formula, inline_mathml, matrix_mathml, symbol_mathml,
    unit_vector_mathml, vector_components_html,
};
use crate::page::markup::html::{escape, folded_html, number, table};
use std::fmt::Write;
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::mechanics::moving_load_places;
use tripos_derive::model::{ForcePlace, MotionConstraintKind, ReactionKind, Turn, Unit};

/// Largest number of parameters whose table is not folded.
const SEEN: usize = 10;

/// Returns the HTML section about the mechanism.
pub fn section(model: &Model) -> String {
    let mut out = format!(
        "<section id=\"mechanism\">\n<h2>Mechanism</h2>\n<p class=\"count\">{}.</p>\n",
        escape(&model.counts_in_words())
    );
    let parameters = parameters(model);
    let parameters = match model.parameters.len() {
        n if n > SEEN => folded_html(&format!("Parameters <span class=\"quiet\">({n})</span>"), &parameters),
        _ => parameters,
    };
    let given = parameters + &coordinates(model) + &mechanism_speeds_table(model) + &constraints(model);
    let _ = writeln!(out, "<div class=\"tables\">\n{given}</div>");
    out += &folded_html(
        "Frames, points, bodies and loads",
        &(frames(model) + &points(model) + &bodies(model) + &loads(model)),
    );
    out + "</section>\n"
}

/// Returns the HTML of a unit. A quantity without a unit gets the text `plain`.
fn mechanism_unit_html(unit: &Unit, plain: &str) -> String {
    let text = match unit.to_string().as_str() {
        "1" => plain.to_owned(),
        "kg*m/s^2" => "N".to_owned(),
        "kg*m^2/s^2" => "N*m".to_owned(),
        "kg/s^2" => "N/m".to_owned(),
        "kg/s" => "N*s/m".to_owned(),
        text => text.to_owned(),
    };
    let mut out = String::new();
    for (at, part) in text.split('^').enumerate() {
        if at == 0 {
            out += &escape(part);
            continue;
        }
        let digits = part.len() - part.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let _ = write!(out, "<sup>{}</sup>{}", &part[..digits], escape(&part[digits..]));
    }
    out.replace('*', "·")
}

/// Returns the HTML table of the parameters.
fn parameters(model: &Model) -> String {
    let rows = model.parameters.iter().map(|p| {
        let value = p.value.as_ref().map_or_else(|| "—".to_owned(), |v| number(&v.to_f64().to_string()));
        let sign = if p.positive { "positive" } else { "" };
        vec![
            inline_mathml(&distinct_symbol_mathml(model, &p.name)),
            escape(&p.about),
            value,
            mechanism_unit_html(&p.unit, "1"),
            sign.to_owned(),
        ]
    });
    mechanism_table("Parameters", &["Symbol", "Meaning", "Value", "Unit", "Known"], &rows.collect::<Vec<_>>())
}

/// Returns the HTML table of the generalized coordinates.
fn coordinates(model: &Model) -> String {
    let rows = model.coordinates.iter();
    let rows = rows.map(|c| {
        vec![
            inline_mathml(&distinct_symbol_mathml(model, &c.name)),
            escape(&c.about),
            mechanism_unit_html(&c.unit, "rad"),
        ]
    });
    mechanism_table("Generalized coordinates", &["Symbol", "Meaning", "Unit"], &rows.collect::<Vec<_>>())
}

/// Returns the HTML table of the generalized speeds.
fn mechanism_speeds_table(model: &Model) -> String {
    let rows = model.speeds.iter().map(|s| {
        let definition = format!(
            "<mrow>{}<mo>=</mo>{}</mrow>",
            distinct_symbol_mathml(model, &s.name),
            formula(&model.arena, s.definition)
        );
        vec![inline_mathml(&definition)]
    });
    mechanism_table("Generalized speeds", &["Definition"], &rows.collect::<Vec<_>>())
}

/// Returns the HTML tables of the constraints, the loops and the conditions of the domain.
fn constraints(model: &Model) -> String {
    let zero =
        |e: Expr| breakable_mathml(&[MathmlSide::of(&model.arena, e), MathmlSide::Whole("<mn>0</mn>".to_owned())]);
    let rows = model.constraints.iter().map(|c| {
        let fixed = breakable_mathml(&[
            MathmlSide::Whole(distinct_symbol_mathml(model, &c.fixes)),
            MathmlSide::of(&model.arena, c.value),
        ]);
        let by = c.enforced_by.map_or_else(
            || "—".to_owned(),
            |at| inline_mathml(&distinct_symbol_mathml(model, &model.reactions[at].name)),
        );
        vec![escape(&c.name), zero(c.equation), fixed, by]
    });
    let constraints = mechanism_table(
        "Holonomic constraints",
        &["Name", "Equation", "Solved", "Enforced by"],
        &rows.collect::<Vec<_>>(),
    );
    let loops = model.loops.iter().map(|c| vec![escape(&c.name), zero(c.equation)]);
    let loops = mechanism_table("Loops, which stay closed", &["Name", "Equation"], &loops.collect::<Vec<_>>());
    let of_motion = model.motion_constraints.iter().map(|c| {
        let states = match c.kind {
            MotionConstraintKind::Stated => "velocities",
            MotionConstraintKind::Rolling(_) => "rolling without slip",
            MotionConstraintKind::Loop(_) => "the rate of a loop",
            MotionConstraintKind::Clock => "time, which goes on",
        };
        let by = c.enforced_by.map_or_else(
            || "—".to_owned(),
            |at| inline_mathml(&distinct_symbol_mathml(model, &model.reactions[at].name)),
        );
        vec![escape(&c.name), zero(c.equation), states.to_owned(), by]
    });
    let heads = ["Name", "Equation", "Of", "Enforced by"];
    let of_motion = mechanism_table("Motion constraints", &heads, &of_motion.collect::<Vec<_>>());
    let constraints = constraints + &loops + &of_motion;
    let rows = model.domain.iter().map(|c| vec![escape(&c.name), format!("<code>{}</code>", escape(&c.text))]);
    constraints
        + &mechanism_table("Domain, where the equations hold", &["Name", "Condition"], &rows.collect::<Vec<_>>())
}

/// Returns the HTML table of the frames and their rotations.
fn frames(model: &Model) -> String {
    let rows = model.frames.iter().filter_map(|f| {
        let (parent, turn) = f.rotation.as_ref()?;
        let parent = &model.frames[*parent].name;
        let by = |e: &Expr| inline_mathml(&formula(&model.arena, *e));
        let (about, by) = match turn {
            Turn::About(axis, angle) => (inline_mathml(&unit_vector_mathml(parent, *axis)), by(angle)),
            Turn::Oriented(turn) if turn.spins.is_empty() => ("axes that stay as they are".to_owned(), "—".to_owned()),
            Turn::Oriented(_) => {
                let all: Vec<String> = turn.quantities().iter().map(by).collect();
                ("Euler parameters".to_owned(), all.join(", "))
            }
        };
        Some(vec![inline_mathml(&symbol_mathml(&f.name)), inline_mathml(&symbol_mathml(parent)), about, by])
    });
    mechanism_table("Frames", &["Frame", "Turned from", "About", "By the angle"], &rows.collect::<Vec<_>>())
}

/// Returns the HTML table of the points and their positions.
fn points(model: &Model) -> String {
    let rows = model.points.iter().filter_map(|p| {
        let placement = p.position?;
        let parent = inline_mathml(&symbol_mathml(&model.points[placement.parent].name));
        let vector = components_in(model, placement.frame, &placement.components);
        Some(vec![inline_mathml(&symbol_mathml(&p.name)), parent, vector])
    });
    mechanism_table("Points", &["Point", "Placed from", "By the vector"], &rows.collect::<Vec<_>>())
}

/// Returns the HTML table of the bodies with mass and central inertia.
fn bodies(model: &Model) -> String {
    let rows = model.bodies.iter().map(|b| {
        let centre = inline_mathml(&symbol_mathml(&model.points[b.centre].name));
        let (frame, inertia) = match &b.rigid {
            None => ("—".to_owned(), "particle".to_owned()),
            Some((frame, inertia)) => {
                let rows = inertia.tensor.map(|row| row.map(|e| formula(&model.arena, e)).to_vec());
                let basis = inline_mathml(&symbol_mathml(&model.frames[inertia.frame].name));
                let tensor = inline_mathml(&matrix_mathml(&rows));
                (inline_mathml(&symbol_mathml(&model.frames[*frame].name)), format!("{tensor} in {basis}"))
            }
        };
        vec![escape(&b.name), centre, inline_mathml(&formula(&model.arena, b.mass)), frame, inertia]
    });
    mechanism_table("Bodies", &["Body", "Mass centre", "Mass", "Frame", "Central inertia"], &rows.collect::<Vec<_>>())
}

/// Returns the HTML table of the loads: gravity, forces, torques, potentials and reactions.
fn loads(model: &Model) -> String {
    let mut rows = Vec::new();
    let at = |place: ForcePlace| {
        let point = inline_mathml(&symbol_mathml(&model.points[place.point].name));
        format!("{} at {point}", escape(&model.bodies[place.body].name))
    };
    let against = |on: String, other: Option<String>| match other {
        Some(other) => format!("{on}, its opposite on {other}"),
        None => on,
    };
    let turned = |(frame, body): (usize, Option<usize>)| match body {
        Some(body) => escape(&model.bodies[body].name),
        None => format!("frame {}", inline_mathml(&symbol_mathml(&model.frames[frame].name))),
    };
    if let Some(g) = &model.gravity {
        let vector = components_in(model, g.frame, &g.acceleration);
        rows.push(vec!["gravity".to_owned(), "every body, as an acceleration".to_owned(), vector]);
    }
    for f in &model.forces {
        let on = against(at(f.on), f.against.map(at));
        rows.push(vec![escape(&f.name), on, components_in(model, f.frame, &f.vector)]);
    }
    for t in &model.torques {
        let on = against(turned(t.on), t.against.map(turned));
        rows.push(vec![format!("{} (torque)", escape(&t.name)), on, components_in(model, t.frame, &t.vector)]);
    }
    for p in &model.potentials {
        let name = format!("{} (potential)", escape(&p.name));
        rows.push(vec![name, "coordinates, by its slopes".to_owned(), inline_mathml(&formula(&model.arena, p.energy))]);
    }
    for r in &model.reactions {
        let body = |body: usize| escape(&model.bodies[body].name);
        let (kind, on) = match r.kind {
            ReactionKind::Force { on, against: other } => ("reaction", against(at(on), other.map(at))),
            ReactionKind::Torque { on, against: other } => ("reaction torque", against(body(on), other.map(body))),
        };
        let direction = components_in(model, r.frame, &r.direction);
        let kind = if r.is_stated { kind.to_owned() } else { format!("{kind}, found") };
        rows.push(vec![
            format!("{} ({kind})", inline_mathml(&distinct_symbol_mathml(model, &r.name))),
            on,
            format!("along {direction}"),
        ]);
    }
    mechanism_table("Loads", &["Name", "On", "Vector"], &rows) + &mechanism_moving_loads(model)
}

/// Returns HTML paragraphs about points of action that move relative to their bodies.
fn mechanism_moving_loads(model: &Model) -> String {
    let line = |text: String| format!("<p>{}</p>\n", escape(&text));
    match moving_load_places(model) {
        Ok(places) => places.iter().map(|place| line(place.text(model))).collect(),
        Err(error) => line(format!("Where loads act is not known: {error}.")),
    }
}

/// Returns the HTML of a vector's components as (x, y, z) in a frame.
fn components_in(model: &Model, frame: usize, components: &[Expr; 3]) -> String {
    format!(
        "{} in {}",
        vector_components_html(&model.arena, components),
        inline_mathml(&symbol_mathml(&model.frames[frame].name))
    )
}

/// Returns the HTML of a table; empty if it has no rows.
fn mechanism_table(caption: &str, head: &[&str], rows: &[Vec<String>]) -> String {
    if rows.is_empty() { String::new() } else { table(caption, head, rows) }
}
