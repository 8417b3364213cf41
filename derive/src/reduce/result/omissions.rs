//! List of the quantities that reduced equations omit, each with its reason and its proof.

use super::reduction::Omission;
use super::reduction_proof::ReductionProof;
use crate::algebra::Expr;
use crate::algebra::term::calculus::Differential;
use crate::algebra::term::steps::Definition;
use crate::algebra::text::print::print_text;
use crate::algebra::value::zero_test::{ZeroTest, bounded_zero_test};
use crate::reduce::basis::prose::{Piece, Prose};
use crate::reduce::basis::reduction_basis::ReductionBasis;
use crate::reduce::levels::momentum_level::Level;
use crate::reduce::slices::slice::{Slice, Variable};
use crate::scene::Scene;

/// Lists the parameters, variables and outputs of the model that the reduced equations omit.
pub fn omissions(
    basis: &mut ReductionBasis,
    level: &Level,
    flow: &Slice,
    scene: &Scene,
    proof: &ReductionProof,
) -> Vec<Omission> {
    let mut list = Vec::new();
    for (name, value) in &basis.folded {
        list.push(Omission {
            what: format!("parameter {name}").into(),
            why: format!("the scene fixes it at {}", value.to_f64()).into(),
            proof: "the number of the scene file, put in exactly".to_owned(),
        });
    }
    list.extend(omitted_speeds(basis, level, flow, proof));
    for carried in &flow.carried {
        let equation = Piece::Equation(carried.coordinate, carried.value);
        list.push(Omission {
            what: Prose::term(carried.coordinate),
            why: Prose::from("not integrated: ").append_prose(equation),
            proof: format!("the rate of that position is the momentum, by identity{}", proof.proof_bound_text()),
        });
    }
    list.extend(omitted_pinned_states(basis, proof));
    for relative in &basis.relatives {
        let (arena, name) = (&basis.arena, print_text(&basis.arena, relative.variable));
        list.push(Omission {
            what: Prose::term(relative.variable),
            why: Prose::term(relative.symbol).append_prose(" stands for it"),
            proof: format!(
                "an identity shows that a symmetry moves {name} and {} together",
                print_text(arena, relative.pivot)
            ),
        });
    }
    let mut pinned = basis.section_substitution();
    let mut is_pinned = |v: &Variable| pinned.apply(&mut basis.arena, v.symbol) != v.symbol;
    let dropped: Vec<Variable> = flow
        .dropped
        .iter()
        .filter(|v| !flow.carried.iter().any(|c| c.coordinate == v.symbol) && !is_pinned(v))
        .copied()
        .collect();
    for variable in dropped {
        list.push(omission_of_independent_variable(basis, flow, variable));
    }
    list.extend(omitted_outputs(basis, flow, scene));
    list
}

/// Omission of the states that a moving frame keeps at zero, as a list of one entry. The list is
/// empty without a frame.
fn omitted_pinned_states(basis: &ReductionBasis, proof: &ReductionProof) -> Vec<Omission> {
    let Some(frame) = &basis.frame else { return Vec::new() };
    let states = [basis.q.as_slice(), &basis.kane.variables].concat();
    let words: Vec<&str> = frame.turns.iter().map(|turn| basis.turns[*turn].words.as_str()).collect();
    let mut pins = frame.pins.iter().map(|pin| Piece::Term(states[*pin]));
    let first = pins.next().map(Prose::from).unwrap_or_default();
    let what = pins.fold(first, |what, pin| what.append_prose(", ").append_prose(pin));
    vec![Omission {
        what,
        why: format!("zero in a frame that moves by {}, which changes nothing that is shown", words.join(" and by "))
            .into(),
        proof: format!(
            "each commutes with the motion of the whole model and leaves what is shown and watched, by identity{}",
            proof.proof_bound_text()
        ),
    }]
}

/// Omissions of the speeds that constant momenta determine.
fn omitted_speeds(basis: &ReductionBasis, level: &Level, flow: &Slice, proof: &ReductionProof) -> Vec<Omission> {
    let used = flow.dependence.mentioned_symbols(&basis.arena, &flow.packed_terms());
    let one = |d: &Definition| {
        if !used.contains(&d.symbol) {
            return Omission {
                what: Prose::term(d.symbol),
                why: omission_reason(d.symbol),
                proof: "no formula that is left mentions it".to_owned(),
            };
        }
        let constants = level.held.iter().filter(|h| basis.arena.mentions(d.value, h.symbol));
        let mut why = Prose::from(Piece::Equation(d.symbol, d.value)).append_prose(", from what is constant: ");
        for (at, held) in constants.enumerate() {
            why = why.append_prose(if at == 0 { "" } else { "; " }).append_prose(held.about.clone());
        }
        Omission {
            why,
            what: Prose::term(d.symbol),
            proof: format!("Kane's equations of the whole model hold with it, by identity{}", proof.proof_bound_text()),
        }
    };
    level.definitions.iter().rev().map(one).collect()
}

/// Omission of a variable on which neither the outputs nor the integrated variables depend.
fn omission_of_independent_variable(basis: &mut ReductionBasis, flow: &Slice, variable: Variable) -> Omission {
    let (mut weakest, mut shown) = (f64::INFINITY, Vec::new());
    for (rate, value) in &flow.raw {
        let present = flow.core.iter().chain(&flow.quadratures).any(|v| v.symbol == *rate);
        if !present || !basis.arena.mentions(*value, variable.symbol) {
            continue;
        }
        let slope = Differential::partial(variable.symbol).apply(&mut basis.arena, *value);
        if let (ZeroTest::Zero, exponent) = bounded_zero_test(&basis.arena, slope) {
            weakest = weakest.min(exponent);
            shown.push(format!("{}'", print_text(&basis.arena, *rate)));
        }
    }
    let proof = if shown.is_empty() {
        "no formula that is left mentions it".to_owned()
    } else {
        let exponent = weakest.min(999.0).floor();
        format!("{} mention it and do not depend on it: exact (in doubt by less than 2^-{exponent})", shown.join(", "))
    };
    Omission { what: Prose::term(variable.symbol), why: omission_reason(variable.symbol), proof }
}

/// Reason of an omission: no wanted quantity depends on this symbol.
fn omission_reason(symbol: Expr) -> Prose {
    Prose::from("no output and nothing that outputs need depends on ").append_prose(Piece::Term(symbol))
}

/// Omissions of quantities that no output requests: reactions, and the total energy.
fn omitted_outputs(basis: &ReductionBasis, flow: &Slice, scene: &Scene) -> Vec<Omission> {
    let (arena, model) = (&basis.arena, &basis.model);
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
        list.push(Omission {
            what: reactions.join(", ").into(),
            why: "no output or event asks for it".into(),
            proof: "reactions enter no equation of motion".to_owned(),
        });
    }
    if flow.energy.is_none() && basis.energy.is_some() {
        list.push(Omission {
            what: "the total energy".into(),
            why: "it depends on what is left out".into(),
            proof: "zero tests of its derivatives".to_owned(),
        });
    }
    list
}
