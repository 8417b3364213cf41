//! What was left out, why, and how that is known.

use super::ground::Ground;
use super::level::Level;
use super::proof::Proof;
use super::reduction::Omission;
use super::slice::{Flow, Variable};
use crate::algebra::Expr;
use crate::algebra::calculus::Differential;
use crate::algebra::modular::{ZeroTest, bounded_zero_test};
use crate::algebra::print::text;
use crate::algebra::steps::Definition;
use crate::scene::Scene;

/// Everything of the model that the scene's equations do not have.
pub fn omissions(ground: &mut Ground, level: &Level, flow: &Flow, scene: &Scene, proof: &Proof) -> Vec<Omission> {
    let mut list = Vec::new();
    for (name, value) in &ground.folded {
        list.push(Omission {
            what: format!("parameter {name}"),
            why: format!("the scene fixes it at {}", value.to_f64()),
            proof: "the number of the scene file, put in exactly".to_owned(),
        });
    }
    list.extend(held(ground, level, flow, proof));
    for carried in &flow.carried {
        let name = text(&ground.arena, carried.coordinate);
        list.push(Omission {
            what: name.clone(),
            why: format!("not integrated: {name} = {}", text(&ground.arena, carried.value)),
            proof: format!("the rate of that position is the momentum, by identity{}", proof.doubt()),
        });
    }
    for relative in &ground.relatives {
        let (arena, name) = (&ground.arena, text(&ground.arena, relative.variable));
        let symbol = text(arena, relative.symbol);
        list.push(Omission {
            what: name.clone(),
            why: format!("{symbol} stands for it"),
            proof: format!("a symmetry moves {name} and {} together, by identity", text(arena, relative.pivot)),
        });
    }
    let dropped: Vec<Variable> =
        flow.dropped.iter().filter(|v| !flow.carried.iter().any(|c| c.coordinate == v.symbol)).copied().collect();
    for variable in dropped {
        list.push(independence(ground, flow, variable));
    }
    list.extend(unasked(ground, flow, scene));
    list
}

/// Speeds that momenta determine.
fn held(ground: &Ground, level: &Level, flow: &Flow, proof: &Proof) -> Vec<Omission> {
    let used = flow.dependence.mentioned(&ground.arena, &flow.terms());
    let one = |d: &Definition| {
        let (name, value) = (text(&ground.arena, d.symbol), text(&ground.arena, d.value));
        if !used.contains(&d.symbol) {
            let why = format!("no output and nothing that outputs need depends on {name}");
            return Omission { what: name, why, proof: "no formula that is left mentions it".to_owned() };
        }
        let constants = level.held.iter().filter(|h| ground.arena.mentions(d.value, h.symbol));
        let constants: Vec<&str> = constants.map(|h| h.about.as_str()).collect();
        Omission {
            why: format!("{name} = {value}, from what is constant: {}", constants.join("; ")),
            what: name,
            proof: format!("Kane's equations of the whole model hold with it, by identity{}", proof.doubt()),
        }
    };
    level.definitions.iter().rev().map(one).collect()
}

/// A variable that neither the outputs nor what they need depends on.
fn independence(ground: &mut Ground, flow: &Flow, variable: Variable) -> Omission {
    let name = text(&ground.arena, variable.symbol);
    let (mut weakest, mut shown) = (f64::INFINITY, Vec::new());
    for (rate, value) in &flow.raw {
        let present = flow.core.iter().chain(&flow.quadratures).any(|v| v.symbol == *rate);
        if !present || !ground.arena.mentions(*value, variable.symbol) {
            continue;
        }
        let slope = Differential::partial(variable.symbol).apply(&mut ground.arena, *value);
        if let (ZeroTest::Zero, exponent) = bounded_zero_test(&ground.arena, slope) {
            weakest = weakest.min(exponent);
            shown.push(format!("{}'", text(&ground.arena, *rate)));
        }
    }
    let why = format!("no output and nothing that outputs need depends on {name}");
    let proof = if shown.is_empty() {
        "no formula that is left mentions it".to_owned()
    } else {
        let exponent = weakest.min(999.0).floor();
        format!("{} mention it and do not depend on it: exact (in doubt by less than 2^-{exponent})", shown.join(", "))
    };
    Omission { what: name, why, proof }
}

/// What no output asks for.
fn unasked(ground: &Ground, flow: &Flow, scene: &Scene) -> Vec<Omission> {
    let (arena, model) = (&ground.arena, &ground.model);
    let asked: Vec<Expr> = scene
        .outputs
        .iter()
        .map(|o| o.value)
        .chain(scene.events.iter().map(|e| e.function))
        .chain(model.domain.iter().map(|c| c.positive))
        .collect();
    let mut list = Vec::new();
    let reactions: Vec<&str> = model
        .reactions
        .iter()
        .filter(|r| !asked.iter().any(|e| arena.mentions(*e, r.symbol)))
        .map(|r| r.name.as_str())
        .collect();
    if !reactions.is_empty() {
        let what = reactions.join(", ");
        list.push(Omission {
            what,
            why: "no output or event asks for it".to_owned(),
            proof: "reactions enter no equation of motion".to_owned(),
        });
    }
    if flow.energy.is_none() && ground.energy.is_some() {
        let why = "it depends on what is left out".to_owned();
        list.push(Omission {
            what: "the total energy".to_owned(),
            why,
            proof: "zero tests of its derivatives".to_owned(),
        });
    }
    list
}
