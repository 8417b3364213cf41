//! Random small mechanisms with every kind of element that a model file has, as model text.
#![allow(dead_code, reason = "each user needs a part")]

use crate::random::Random;
use std::fmt::Write;

/// Kinds of elements that mechanisms draw, by the words that stand in [`Mechanism::elements`].
pub const ELEMENTS: [&str; 28] = [
    "pin",
    "slider",
    "planar",
    "cylinder",
    "screw",
    "universal",
    "ball",
    "free",
    "weld",
    "euler",
    "own speeds",
    "gravity",
    "spring",
    "damped spring",
    "damper",
    "drag",
    "friction",
    "input",
    "potential",
    "loop",
    "tie",
    "curved tie",
    "blade",
    "rolling",
    "curve",
    "given angle",
    "given rate",
    "moved base",
];

/// A mechanism as model text, with its kinds of elements.
pub struct Mechanism {
    pub text: String,
    pub elements: Vec<&'static str>,
}

/// Sections of a model file, filled one by one.
#[derive(Default)]
struct Parts {
    elements: Vec<&'static str>,
    parameters: Vec<String>,
    sections: Vec<(&'static str, Vec<String>)>,
    tables: String,
    /// Names of bodies, and of the coordinates of their joints with their number of turns.
    bodies: Vec<(String, Vec<String>)>,
    coordinates: usize,
    has_own_speeds: bool,
}

impl Parts {
    fn parameter(&mut self, name: &str, unit: &str, random: &mut Random) -> String {
        let name = format!("{name}{}", self.parameters.len());
        let value = random.decimal(0.4, 2.5);
        self.parameters.push(format!("{name} = {{ unit = \"{unit}\", value = {value}, positive = true }}"));
        name
    }

    fn line(&mut self, section: &'static str, line: String) {
        match self.sections.iter_mut().find(|(name, _)| *name == section) {
            Some((_, lines)) => lines.push(line),
            None => self.sections.push((section, vec![line])),
        }
    }

    /// A body with a joint to the last body, or to the ground.
    fn body(&mut self, random: &mut Random, kind: &'static str, axis: usize, keys: &str, count: usize) {
        let at = self.bodies.len();
        let (name, m) = (format!("b{at}"), self.parameter("m", "kg", random));
        let in_plane = ["pin", "slider", "planar"].contains(&kind) && axis == 3;
        let inertia = if in_plane && random.chance(70) {
            format!("\"{}\"", self.parameter("J", "kg*m^2", random))
        } else if random.chance(50) {
            let l = self.parameter("l", "m", random);
            format!("{{ diagonal = [\"{m}*{l}^2/4\", \"{m}*{l}^2/4\", \"{m}*{l}^2/2\"] }}")
        } else {
            let a = self.parameter("A", "kg*m^2", random);
            format!("{{ diagonal = [\"{a}\", \"{a}\", \"{a}\"] }}")
        };
        self.line("bodies", format!("{name} = {{ mass = \"{m}\", inertia = {inertia} }}"));
        let mut place = |parts: &mut Self, percent: usize| -> String {
            if !random.chance(percent) {
                return String::new();
            }
            let l = parts.parameter("l", "m", random);
            if axis == 1 || random.chance(70) { format!("\"{l}\", 0, 0") } else { format!("0, \"-{l}\", 0") }
        };
        let (joint_at, centre) = (if at == 0 { String::new() } else { place(self, 90) }, place(self, 60));
        let to = if at == 0 { String::new() } else { format!(", to = \"b{}\"", at - 1) };
        let mut places = String::new();
        for (key, list) in [("at", joint_at), ("centre", centre)] {
            if !list.is_empty() {
                let _ = write!(places, ", {key} = [{list}]");
            }
        }
        let names: Vec<String> = (self.coordinates..self.coordinates + count).map(|k| format!("q{k}")).collect();
        let list = names.iter().map(|q| format!("\"{q}\"")).collect::<Vec<_>>().join(", ");
        let speeds = if self.has_own_speeds { ", speeds = []" } else { "" };
        let coordinates = if kind == "weld" { String::new() } else { format!(", coordinates = [{list}]{speeds}") };
        self.line(
            "joints",
            format!("j{at} = {{ kind = \"{kind}\", body = \"{name}\"{to}{places}{keys}{coordinates} }}"),
        );
        self.coordinates += count;
        self.bodies.push((name, names));
        self.elements.push(kind);
    }

    fn text(&self) -> String {
        let mut text = format!("name = \"Random mechanism\"\n[parameters]\n{}\n", self.parameters.join("\n"));
        text += "[inertial]\nframe = \"N\"\norigin = \"O\"\n";
        for (section, lines) in &self.sections {
            let _ = write!(text, "[{section}]\n{}\n", lines.join("\n"));
        }
        text + &self.tables
    }
}

impl Mechanism {
    /// A mechanism of one to three bodies. The model file may be refused: constraints may follow from one another.
    pub fn new(random: &mut Random) -> Self {
        let mut parts = Parts::default();
        match random.below(13) {
            0..=2 => tree(&mut parts, random),
            3 => wheel(&mut parts, random),
            4 => blade(&mut parts, random),
            5 => closed(&mut parts, random),
            6 => bead(&mut parts, random),
            7 => driven(&mut parts, random),
            8 => tied(&mut parts, random),
            _ => space(&mut parts, random),
        }
        loads(&mut parts, random);
        Self { text: parts.text(), elements: parts.elements }
    }
}

/// A chain in a plane, whose speeds may be sums of rates.
fn tree(parts: &mut Parts, random: &mut Random) {
    parts.has_own_speeds = random.chance(40);
    let count = 1 + random.below(3);
    for at in 0..count {
        match random.below(if at == 0 { 4 } else { 3 }) {
            0 | 1 => parts.body(random, "pin", 3, "", 1),
            2 => parts.body(random, "slider", 1, ", axis = 1", 1),
            _ => parts.body(random, "planar", 3, "", 3),
        }
    }
    if random.chance(15) {
        parts.body(random, "weld", 3, "", 0);
    }
    if parts.has_own_speeds {
        parts.elements.push("own speeds");
        for k in 0..parts.coordinates {
            let factor = *random.one(&["", "2*", "-"]);
            let turned = if k == 1 && !parts.is_length(0) && random.chance(50) { "*cos(q0)" } else { "" };
            // Rates of lengths and of angles do not add.
            parts.line("speeds", format!("u{k} = \"{factor}q{k}'{turned}\""));
        }
        if random.chance(50) {
            parts.sections.retain(|(name, _)| *name != "speeds");
            for k in 0..parts.coordinates {
                let is_length = |q: usize| parts.is_length(q);
                let more = (k > 0 && is_length(k) == is_length(k - 1)).then(|| format!(" + q{}'", k - 1));
                parts.line("speeds", format!("u{k} = \"q{k}'{}\"", more.unwrap_or_default()));
            }
        }
    }
}

impl Parts {
    /// True if a coordinate is a length, not an angle.
    fn is_length(&self, q: usize) -> bool {
        let mut first = 0;
        for (body, (_, names)) in self.bodies.iter().enumerate() {
            if q < first + names.len() {
                return match self.elements[body] {
                    "slider" => true,
                    "planar" => q - first < 2,
                    _ => false,
                };
            }
            first += names.len();
        }
        false
    }
}

/// A wheel on a line, or a ball on a plane, with a rod on it.
fn wheel(parts: &mut Parts, random: &mut Random) {
    let r = parts.parameter("R", "m", random);
    if random.chance(50) {
        parts.body(random, "planar", 3, "", 3);
        parts.line("points", "E = { from = \"O\", frame = \"N\", position = [\"q0\", 0, 0] }".to_owned());
        parts.line("constraints", format!("up = {{ equation = \"q1 = {r}\" }}"));
    } else {
        let keys = *random.one(&[", sequence = \"euler\"", ", sequence = \"123\"", ", sequence = \"313\""]);
        parts.body(random, "free", 3, keys, if keys.contains("euler") { 7 } else { 6 });
        if keys.contains("euler") {
            parts.elements.push("euler");
        }
        parts.line("points", "E = { from = \"O\", frame = \"N\", position = [\"q0\", \"q1\", 0] }".to_owned());
        parts.line("constraints", format!("up = {{ equation = \"q2 = {r}\" }}"));
    }
    // The place of the joint is the centre of the wheel.
    let joints = parts.sections.iter_mut().find(|(name, _)| *name == "joints").expect("a joint");
    if let Some((before, rest)) = joints.1[0].clone().split_once(", centre = [") {
        joints.1[0] = format!("{before}{}", rest.split_once(']').expect("a list").1);
    }
    parts.line("rolling", "roll = { body = \"b0\", at = \"E\" }".to_owned());
    if random.chance(40) && parts.coordinates == 3 {
        parts.body(random, "pin", 3, "", 1);
    }
    parts.elements.push("rolling");
}

/// A sleigh in a plane, with a trailer at times.
fn blade(parts: &mut Parts, random: &mut Random) {
    parts.body(random, "planar", 3, "", 3);
    let at = *random.one(&["b0_centre", "j0"]);
    if random.chance(40) {
        parts.body(random, "pin", 3, "", 1);
        if random.chance(40) {
            parts.line("constraints", "edge1 = { equation = \"v(b1_centre) @ b1_frame [2] = 0\" }".to_owned());
        }
    }
    let axis = 1 + random.below(2);
    parts.line("constraints", format!("edge0 = {{ equation = \"v({at}) @ b0_frame [{axis}] = 0\" }}"));
    parts.elements.push("blade");
}

/// A loop of bars, closed on the ground.
fn closed(parts: &mut Parts, random: &mut Random) {
    parts.body(random, "pin", 3, "", 1);
    parts.body(random, "pin", 3, "", 1);
    let l = parts.parameter("l", "m", random);
    if random.chance(50) {
        parts.body(random, "pin", 3, "", 1);
        let d = parts.parameter("d", "m", random);
        parts.line(
            "joints",
            format!("close = {{ kind = \"pin\", body = \"b2\", at = [\"{d}\", 0, 0], body_at = [\"{l}\", 0, 0] }}"),
        );
    } else {
        parts.line("points", format!("slot = {{ from = \"j1\", frame = \"b1_frame\", position = [\"{l}\", 0, 0] }}"));
        parts.line("constraints", "guide = { equation = \"p(slot) @ N [2] = 0\" }".to_owned());
    }
    parts.elements.push("loop");
}

/// A particle on a curve, with a pendulum beside it at times.
fn bead(parts: &mut Parts, random: &mut Random) {
    let (m, l) = (parts.parameter("m", "kg", random), parts.parameter("l", "m", random));
    parts.line("coordinates", "x = { unit = \"m\" }".to_owned());
    parts.line("coordinates", "y = { unit = \"m\" }".to_owned());
    parts.line("points", "P = { from = \"O\", frame = \"N\", position = [\"x\", \"y\", 0] }".to_owned());
    parts.line("particles", format!("bead = {{ point = \"P\", mass = \"{m}\" }}"));
    let curve = match random.below(5) {
        0 => format!("x^2 + y^2 = {l}^2"),
        1 => format!("x^2/4 + y^2 = {l}^2"),
        2 => format!("x*y = {l}^2"),
        3 => format!("{l}*y + x*y + y^2 = x^2"),
        _ => format!("y - x^2/(2*{l}) - x^3/{l}^2 = {l}/3"),
    };
    parts.line("constraints", format!("curve = {{ equation = \"{curve}\" }}"));
    let speed = if curve.starts_with("y - ") {
        "x'".to_owned()
    } else {
        (*random.one(&["x'", "y'", "(x*y' - y*x')/LENGTH"])).replace("LENGTH", &l)
    };
    parts.line("speeds", format!("v = \"{speed}\""));
    parts.elements.push("curve");
    if random.chance(30) {
        parts.has_own_speeds = true;
        parts.body(random, "pin", 3, "", 1);
        parts.line("speeds", "u0 = \"q0'\"".to_owned());
        // Elements of bodies come first in the list.
        parts.elements.rotate_right(1);
    }
}

/// A chain of which one part moves as is given.
fn driven(parts: &mut Parts, random: &mut Random) {
    let w = parts.parameter("w", "1/s", random);
    if random.chance(40) {
        let a = parts.parameter("a", "m", random);
        let law = *random.one(&["A*sin(W*t)", "A*W*t", "A*cos(W*t)^2"]);
        let law = law.replace('A', &a).replace('W', &w);
        parts.line("points", format!("S = {{ from = \"O\", frame = \"N\", position = [0, \"{law}\", 0] }}"));
        parts.body(random, "pin", 3, ", at = \"S\"", 1);
        if random.chance(50) {
            parts.body(random, "pin", 3, "", 1);
        }
        parts.elements.push("moved base");
        return;
    }
    for _ in 0..2 + random.below(2) {
        parts.body(random, "pin", 3, "", 1);
    }
    let (equation, element) = *random.one(&[
        ("q0 = W*t", "given angle"),
        ("q1 = sin(W*t)", "given angle"),
        ("q0' = W", "given rate"),
        ("q0' + q1' = W*cos(q1)", "given rate"),
    ]);
    parts.line("constraints", format!("drive = {{ equation = \"{}\" }}", equation.replace('W', &w)));
    parts.elements.push(element);
}

/// A chain two angles of which are tied by an equation.
fn tied(parts: &mut Parts, random: &mut Random) {
    for _ in 0..2 + random.below(2) {
        parts.body(random, "pin", 3, "", 1);
    }
    let [a, b] = ["a", "b"].map(|name| parts.parameter(name, "m", random));
    let (equation, element) = *random.one(&[
        ("q1 = 2*q0", "tie"),
        ("q1 = sin(q0)/2", "tie"),
        ("a*sin(q1) = b*sin(q0)", "curved tie"),
        ("sin(q1) = cos(q0)/2", "curved tie"),
        ("a*sin(q1) + b*cos(q0) = a/2", "curved tie"),
    ]);
    let equation = equation.replace('a', &a).replace('b', &b);
    parts.line("constraints", format!("tie = {{ equation = \"{equation}\" }}"));
    parts.elements.push(element);
}

/// One or two bodies in space.
fn space(parts: &mut Parts, random: &mut Random) {
    let sequence = *random.one(&["euler", "123", "313", "321"]);
    let keys = format!(", sequence = \"{sequence}\"");
    let more = usize::from(sequence == "euler");
    let about = format!(", axis = {}", 1 + random.below(3));
    let mut is_ball = false;
    match random.below(7) {
        0 | 1 => {
            parts.body(random, "ball", 1, &keys, 3 + more);
            is_ball = true;
        }
        2 => {
            parts.body(random, "free", 1, &keys, 6 + more);
            is_ball = true;
        }
        3 => parts.body(random, "universal", 1, ", axes = [1, 2]", 2),
        4 => parts.body(random, "cylinder", 1, &about, 2),
        _ => {
            let lead = parts.parameter("h", "m", random);
            parts.body(random, "screw", 1, &format!("{about}, lead = \"{lead}\""), 1);
        }
    }
    if random.chance(if is_ball { 10 } else { 50 }) {
        let axis = format!(", axis = {}", 1 + random.below(3));
        parts.body(random, "pin", 1, &axis, 1);
    }
    if is_ball && more == 1 {
        parts.elements.push("euler");
    }
}

/// Loads of several kinds.
fn loads(parts: &mut Parts, random: &mut Random) {
    if random.chance(70) {
        let g = parts.parameter("g", "m/s^2", random);
        let _ = write!(parts.tables, "[gravity]\nframe = \"N\"\nacceleration = [0, \"-{g}\", 0]\n");
        parts.elements.push("gravity");
    }
    let Some((body, _)) = parts.bodies.last().cloned() else { return };
    let first = parts.bodies[0].1.first().cloned();
    if random.chance(12) {
        let (k, l) = (parts.parameter("k", "N/m", random), parts.parameter("l", "m", random));
        parts.line("points", format!("anchor = {{ from = \"O\", frame = \"N\", position = [0, \"2*{l}\", 0] }}"));
        let damping = if random.chance(50) {
            parts.elements.push("damped spring");
            format!("damping = \"{}\"\n", parts.parameter("c", "N*s/m", random))
        } else {
            String::new()
        };
        let _ = write!(
            parts.tables,
            "[springs.leg]\non = \"{body}\"\nagainst_at = \"anchor\"\nstiffness = \"{k}\"\nfree_length = \"{l}\"\n{damping}"
        );
        parts.elements.push("spring");
    }
    if random.chance(15) {
        let c = parts.parameter("c", "N*s/m", random);
        let drag = [1, 2].map(|k| format!("\"-{c}*v({body}, {body}_centre) @ N [{k}]\"")).join(", ");
        let _ = write!(parts.tables, "[forces.drag]\non = \"{body}\"\nframe = \"N\"\nvector = [{drag}, 0]\n");
        parts.elements.push("drag");
    }
    if random.chance(20) {
        let c = parts.parameter("c", "N*m*s", random);
        let law = [1, 2, 3].map(|k| format!("\"-{c}*omega({body}) @ N [{k}]\"")).join(", ");
        let _ = write!(parts.tables, "[torques.damper]\non = \"{body}\"\nframe = \"N\"\nvector = [{law}]\n");
        parts.elements.push("damper");
    }
    if random.chance(12) && parts.elements.first() == Some(&"pin") {
        let (t, w) = (parts.parameter("T", "N*m", random), parts.parameter("w", "1/s", random));
        let _ = write!(
            parts.tables,
            "[friction.bearing]\non = \"b0\"\nframe = \"N\"\naxis = 3\ntorque = \"{t}\"\nsmoothing = \"{w}\"\n"
        );
        parts.elements.push("friction");
    }
    if random.chance(25) {
        parts.line("inputs", "F = { unit = \"N\", value = 1.5 }".to_owned());
        let _ = write!(parts.tables, "[forces.push]\non = \"{body}\"\nframe = \"N\"\nvector = [\"F\", 0, 0]\n");
        parts.elements.push("input");
    }
    let is_euler = parts.elements.contains(&"euler");
    if random.chance(15)
        && !is_euler
        && let Some(q) = first
    {
        let unit = if parts.is_length(0) || ["free", "planar"].contains(&parts.elements[0]) { "N/m" } else { "N*m" };
        let k = parts.parameter("k", unit, random);
        parts.line("potentials", format!("twist = \"{k}*{q}^2/2\""));
        parts.elements.push("potential");
    }
}
