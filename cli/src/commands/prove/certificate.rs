//! Certificate of the proofs about a model: a text from which another program decides whether they hold.
//!
//! Each line is a JSON value. The lines before the prime are the statement; their hash determines the prime and the
//! points of modular proofs, so that nobody can choose them. `docs/certificate.md` states the format.

use super::identities::{IdentityName, derivation_identities, parameter_identities, reaction_identities};
use super::inputs_in_integral;
use crate::commands::derive::DerivationText;
use crate::terminal::failure::Failure;
use serde_json::{Value, json};
use std::fmt::Write;
use tripos::Mechanism;
use tripos_derive::algebra::solve::elimination::divisors;
use tripos_derive::algebra::term::calculus::Substitution;
use tripos_derive::algebra::text::definitions::definitions_shown;
use tripos_derive::algebra::text::print::{print_text, print_whole_text};
use tripos_derive::algebra::value::proved_prime::proved_prime_after;
use tripos_derive::algebra::{Arena, Expr, Function, Node};
use tripos_derive::identify::{BaseParameterFactor, Completeness, Identification};
use tripos_derive::mechanics::{Derivations, Formulation, Regressor, RegressorParameters};
use tripos_derive::model::text_digest;
use tripos_derive::prove::{Combination, Integral, IntegralKind, Proof};

/// Version of the format of certificates.
const VERSION: u32 = 1;

/// Statements about a model that no certificate contains yet.
const NOT_CERTIFIED: [&str; 9] = [
    "the kinematics, the loads and the energies of the model: tests/certificate/kinematics.py checks them",
    "entries that only determine a multiplier, and coefficients of t'' = 0",
    "the members steps, count, singular_where and accelerations_divide_by of the derivation",
    "the names of integrals, except energies and momenta of coordinates",
    "that no further first integrals exist",
    "that all other parameters can be identified, in particular inertias that the model does not declare",
    "reductions and redundant constraints",
    "verdicts on printed derivations",
    "stability, runs and emitted code",
];

/// Returns the certificate of the proofs about a model. The proofs must belong to the derivation.
///
/// # Errors
/// `Failure` if a formula is too long, or contains a root of a number that may not exist modulo the prime.
pub fn certificate_text(
    model: &Mechanism,
    derivations: &mut Derivations,
    proof: &Proof,
    derivation: &DerivationText,
) -> Result<String, Failure> {
    refuse_uncertifiable_formulas(derivations, proof)?;
    let mut identities = derivation_identities(&derivation.value, is_driven(model, derivations));
    let arena = &derivations.kinematics.arena;
    let mut lines = vec![
        json!({ "tripos_certificate": VERSION, "model": model.title }),
        json!({ "model_text": model.source.text, "sha256": text_digest(&model.source.text) }),
        json!({ "derivation": derivation.json, "sha256": text_digest(&derivation.json) }),
    ];
    let mut nonzero: serde_json::Map<String, Value> =
        derivation.divisors.iter().map(|(name, list)| (name.clone(), json!(list))).collect();
    for formulation in Formulation::STANDARD {
        let Some((multipliers, name)) = combination_multipliers(proof, formulation) else { continue };
        let all: Vec<Expr> = multipliers.iter().flatten().copied().collect();
        nonzero.insert(format!("multipliers of {name}"), json!(divisor_texts(arena, &all)));
        let rows: Vec<Vec<String>> = multipliers.iter().map(|row| texts(arena, row)).collect();
        lines.push(json!({ "combination": name, "named": named(arena, &all), "multipliers": rows }));
    }
    if let Some(name) = formulation_of_reactions(derivations, proof) {
        let of_reactions = reaction_identities(&derivation.value, name);
        if !of_reactions.is_empty() {
            let all: Vec<Expr> = proof.reactions.iter().map(|reaction| reaction.value).collect();
            nonzero.insert(format!("reactions of {name}"), json!(divisor_texts(arena, &all)));
            identities.extend(of_reactions);
            lines.push(reactions_line(arena, proof, name, &all));
        }
    }
    for integral in proof.integrals.iter().filter(|integral| integral.verdict.is_equal()) {
        let (line, divided) = integral_line(model, arena, integral);
        nonzero.insert(format!("integral {}", integral.name(model, arena)), json!(divided));
        identities.extend(integral_identities(&line));
        lines.push(line);
    }
    for (line, divided) in unidentifiable_parameters(model) {
        let name = format!("parameter {}", line["without_effect"].as_str().unwrap_or_default());
        identities.extend(parameter_identities(&derivation.value, &name));
        nonzero.insert(name, json!(divided));
        lines.push(line);
    }
    lines.push(json!({ "nonzero": nonzero }));
    let missing = proof.missing.iter().map(|(formulation, why)| format!("{}: {why}", formulation.name()));
    let left_out: Vec<String> = NOT_CERTIFIED.into_iter().map(str::to_owned).chain(missing).collect();
    lines.push(json!({ "not_certified": left_out }));
    let mut out = String::new();
    for line in &lines {
        let _ = writeln!(out, "{line}");
    }
    let prime = proved_prime_after(&text_digest(&out));
    for line in [json!({ "prime": prime.cofactor, "witness": prime.witness }), json!({ "identities": identities })] {
        let _ = writeln!(out, "{line}");
    }
    Ok(out)
}

/// Refuses formulas that the checker would refuse although they are true: values of reactions and integrals of more
/// nodes than a text shows, and square roots of numbers with large prime factors.
fn refuse_uncertifiable_formulas(derivations: &Derivations, proof: &Proof) -> Result<(), Failure> {
    let arena = &derivations.kinematics.arena;
    let reactions = proof.reactions.iter().map(|reaction| (format!("the reaction {}", reaction.name), reaction.value));
    let integrals = proof.integrals.iter().map(|integral| ("a first integral".to_owned(), integral.expression));
    let values: Vec<(String, Expr)> = reactions.chain(integrals).collect();
    if let Some((what, _)) = values.iter().find(|(_, value)| print_whole_text(arena, *value).contains('…')) {
        let help = "prove the model without `--certificate`: the proofs do not need this formula";
        return Err(Failure::request(format!("the formula of {what} is too long for a certificate"), help));
    }
    let equations = Formulation::STANDARD.into_iter().filter_map(|formulation| derivations.get(formulation));
    let entries = equations.flat_map(|e| e.matrix.iter().flatten().chain(&e.forcing).chain(&e.coordinate_rates));
    let formulas: Vec<Expr> = entries.copied().chain(values.into_iter().map(|(_, value)| value)).collect();
    for part in arena.reachable(&formulas) {
        let Node::Apply(Function::Sqrt, argument) = *arena.node(part) else { continue };
        if let Node::Number(value) = arena.node(argument)
            && !value.small().is_some_and(|(above, below)| [above, below].into_iter().all(is_product_of_small_primes))
        {
            let what = format!("no certificate can contain {}", print_text(arena, part));
            let help = "the checker knows roots of products of primes up to 31: use such numbers, or a parameter";
            return Err(Failure::request(what, help));
        }
    }
    Ok(())
}

/// True if no prime factor of a number is above 31.
fn is_product_of_small_primes(number: i64) -> bool {
    let mut rest = number;
    for factor in 2..=31 {
        while rest != 0 && rest % factor == 0 {
            rest /= factor;
        }
    }
    rest == 1
}

/// Returns the name of the formulation whose reactions were solved for. `None` if there are no reactions.
fn formulation_of_reactions(derivations: &Derivations, proof: &Proof) -> Option<&'static str> {
    let mut derived = Formulation::STANDARD.into_iter().filter(|f| f.has_reactions() && derivations.get(*f).is_some());
    derived.next().filter(|_| !proof.reactions.is_empty()).map(Formulation::name)
}

/// Returns the line with the values of all reactions, as functions of the motion and its accelerations.
fn reactions_line(arena: &Arena, proof: &Proof, name: &str, all: &[Expr]) -> Value {
    let values = proof.reactions.iter().map(|r| json!({ "name": r.name, "value": print_whole_text(arena, r.value) }));
    json!({ "reactions": name, "named": named(arena, all), "values": values.collect::<Vec<_>>() })
}

/// True if the mechanism moves although all speeds are 0, because a drive prescribes a motion.
fn is_driven(model: &Mechanism, derivations: &mut Derivations) -> bool {
    let rates = derivations.get(Formulation::Kane).map(|kane| kane.coordinate_rates.clone()).unwrap_or_default();
    let arena = &mut derivations.kinematics.arena;
    let at_rest: Vec<(Expr, Expr)> = model.u().into_iter().map(|speed| (speed, Expr::ZERO)).collect();
    let mut at_rest = Substitution::new(&at_rest);
    rates.into_iter().any(|rate| at_rest.apply(arena, rate) != Expr::ZERO)
}

/// Lists the identities about the integral in a line of the certificate.
fn integral_identities(line: &Value) -> Vec<IdentityName> {
    let name = format!("integral {}", line["integral"].as_str().unwrap_or_default());
    let values = [line["is_energy"] == true, line["is_momentum_of"].is_string()];
    let values = values.into_iter().filter(|is_stated| *is_stated).map(|_| "value");
    std::iter::once("rate").chain(values).map(|what| vec![name.clone(), what.to_owned()]).collect()
}

/// Returns the multipliers with which the rows of a formulation with reactions give Kane's rows, and the
/// formulation's name. `None` for other formulations, and without a proof.
fn combination_multipliers(proof: &Proof, formulation: Formulation) -> Option<(&[Vec<Expr>], &'static str)> {
    let mut combinations =
        proof.pairs.iter().filter(|pair| pair.verdict.is_equal()).flat_map(|pair| &pair.combinations);
    let found = combinations.find(|c| c.of == formulation && gives_kane(c) && c.relations.is_empty())?;
    Some((&found.multipliers, formulation.name()))
}

/// True if a combination gives rows along speeds without reactions. Of the standard formulations, Kane's has such rows.
pub fn gives_kane(combination: &Combination) -> bool {
    !combination.gives.is_in_rates() && !combination.gives.has_reactions()
}

/// Returns a line for each declared parameter that motions do not determine. If it grows by 1 while others change by
/// the stated formulas, no force changes. Each line comes with the divisors in its formulas. Parameters whose factors
/// have no formula are left out, and so are all if the base parameters cannot be found.
fn unidentifiable_parameters(model: &Mechanism) -> Vec<(Value, Vec<String>)> {
    let Ok(mut found) = Identification::new(model, RegressorParameters::Declared) else { return Vec::new() };
    found.ungroup();
    if !matches!(found.complete, Completeness::Proved(_)) {
        return Vec::new();
    }
    let Regressor { arena, columns, .. } = &mut found.regressor;
    let (base, mut lines) = (&found.base, Vec::new());
    for (at, column) in columns.iter().enumerate().filter(|(at, _)| base.iter().all(|b| b.column != *at)) {
        let factors =
            base.iter().flat_map(|b| b.with.iter().filter(|(with, _)| *with == at).map(|(_, f)| (b.column, *f)));
        let factors: Vec<(usize, BaseParameterFactor)> = factors.collect();
        let exact = factors.iter().map(|(pivot, factor)| match factor {
            BaseParameterFactor::Exact(e) => Some((*pivot, *e)),
            BaseParameterFactor::Number(_) | BaseParameterFactor::Unknown => None,
        });
        let Some(exact) = exact.collect::<Option<Vec<_>>>() else { continue };
        let rates: Vec<(usize, Expr)> = exact.into_iter().map(|(pivot, e)| (pivot, arena.neg(e))).collect();
        let formulas: Vec<Expr> = rates.iter().map(|(_, rate)| *rate).collect();
        let others =
            rates.iter().map(|(pivot, rate)| (columns[*pivot].name.clone(), json!(print_whole_text(arena, *rate))));
        let along: serde_json::Map<String, Value> = others.chain([(column.name.clone(), json!("1"))]).collect();
        let divided = divisor_texts(arena, &formulas);
        lines.push((json!({ "without_effect": column.name, "along": along, "named": [] }), divided));
    }
    lines
}

/// Returns the line of a first integral, and the divisors in its formulas.
fn integral_line(model: &Mechanism, arena: &Arena, integral: &Integral) -> (Value, Vec<String>) {
    let all: Vec<Expr> = std::iter::once(integral.expression).chain(integral.multipliers.iter().copied()).collect();
    let momentum = integral.kinds.iter().zip(&integral.of_places).find_map(|(kind, place)| match kind {
        IntegralKind::Coordinate(at) if *place == Expr::ZERO => Some(print_text(arena, model.coordinates[*at].symbol)),
        _ => None,
    });
    let line = json!({
        "integral": integral.name(model, arena),
        "is_energy": integral.kinds.contains(&IntegralKind::Energy),
        "is_momentum_of": momentum,
        "while_constant": inputs_in_integral(model, arena, integral),
        "named": named(arena, &all),
        "value": print_whole_text(arena, integral.expression),
        "multipliers": texts(arena, &integral.multipliers),
    });
    (line, divisor_texts(arena, &all))
}

/// Returns formulas as texts.
fn texts(arena: &Arena, list: &[Expr]) -> Vec<String> {
    list.iter().map(|e| print_whole_text(arena, *e)).collect()
}

/// Returns the divisors in formulas as texts.
fn divisor_texts(arena: &Arena, formulas: &[Expr]) -> Vec<String> {
    texts(arena, &divisors(arena, formulas))
}

/// Returns the definitions of the names in formulas, each after those that it contains.
fn named(arena: &Arena, formulas: &[Expr]) -> Vec<Value> {
    let definitions = definitions_shown(arena, formulas).into_iter();
    definitions
        .map(|d| json!({ "name": print_text(arena, d.symbol), "value": print_whole_text(arena, d.value) }))
        .collect()
}
