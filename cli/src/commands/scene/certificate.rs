//! Certificate of the reduced equations of a scene: a text from which another program decides whether their solutions
//! are motions of the whole model.
//!
//! Each line is a JSON value. The certificate contains that of the model's proofs, the text of the scene, the reduced
//! equations, and the motion of the whole model in their variables. `docs/certificate.md` states the format.

use crate::terminal::failure::Failure;
use serde_json::{Map, Value, json};
use std::fmt::Write;
use tripos_derive::algebra::term::steps::{Definition, needed_steps};
use tripos_derive::algebra::text::print::{print_text, print_whole_text};
use tripos_derive::algebra::value::proved_prime::proved_prime_after;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::model::text_digest;
use tripos_derive::reduce::{ReducedQuantity, Reduction};
use tripos_derive::scene::Scene;

/// Version of the format of certificates of reductions.
const VERSION: u32 = 1;

/// Statements about a reduction that no certificate contains.
const NOT_CERTIFIED: [&str; 4] = [
    "events, conditions of the domain and the energy of the reduced equations",
    "that the parts that are left out are all that can be left out",
    "start values, and units",
    "the divided difference of the potential for solution by quadrature",
];

/// Returns the certificate of a reduction. `proof` is the certificate of the proofs about the model.
///
/// # Errors
/// `Failure` if the equations are in a moving frame, or if a formula is too long.
pub fn certificate_of_reduction(proof: &str, scene: &Scene, reduction: &Reduction) -> Result<String, Failure> {
    if reduction.frame.is_some() {
        let help = "the proof of a moving frame needs its symmetries; `tripos scene` prints it in words";
        return Err(Failure::request("reduced equations in a moving frame have no certificate", help));
    }
    let arena = reduction.arena();
    let reconstruction = &reduction.proof.reconstruction;
    let (e, text) = (&reduction.derivation.equations, &scene.source.text);
    let folded: Map<String, Value> =
        reduction.folded.iter().map(|(name, value)| (name.clone(), json!(value.to_big().to_string()))).collect();
    let held: Vec<Value> = pairs(arena, &reconstruction.held);
    let formulas = e.matrix.iter().flatten().chain(&e.forcing).chain(&e.coordinate_rates).copied();
    let formulas: Vec<Expr> = formulas.chain(reduction.outputs.iter().map(|o| o.value)).collect();
    let named: Vec<Definition> = reduction.products.iter().chain(&e.definitions).copied().collect();
    let named = needed_steps(arena, &named, &formulas).iter().map(|d| (d.symbol, d.value)).collect::<Vec<_>>();
    let places = reduction.constants.iter().filter_map(|constant| {
        let (_, rate) = reconstruction.positions.iter().find(|(symbol, _)| *symbol == constant.symbol)?;
        let position = print_whole_text(arena, constant.of_start);
        Some(json!({ "name": constant.name, "position": position, "rate": print_text(arena, *rate) }))
    });
    let rates = e.coordinates.iter().copied().zip(e.coordinate_rates.iter().copied()).collect::<Vec<_>>();
    let outputs = reduction.outputs.iter();
    let outputs = outputs.map(|o| json!({ "name": o.name, "value": print_whole_text(arena, o.value) }));
    let names = |list: &[ReducedQuantity]| list.iter().map(|q| q.name.clone()).collect::<Vec<_>>();
    let lines = [
        json!({ "tripos_reduction": VERSION, "scene": scene.title }),
        json!({ "proof": proof, "sha256": text_digest(proof) }),
        json!({ "scene_text": text, "sha256": text_digest(text) }),
        json!({ "folded": folded }),
        json!({
            "states": names(&reduction.states),
            "quadratures": names(&reduction.quadratures),
            "named": pairs(arena, &named),
            "coordinate_rates": pairs(arena, &rates),
            "speeds": texts(arena, &e.variables),
            "mass_matrix": e.matrix.iter().map(|row| texts(arena, row)).collect::<Vec<_>>(),
            "forcing": texts(arena, &e.forcing),
        }),
        json!({ "constants": held, "positions": places.collect::<Vec<_>>() }),
        json!({ "outputs": outputs.collect::<Vec<_>>(), "time": print_text(arena, reduction.time) }),
        json!({
            "variables": pairs(arena, &reconstruction.variables),
            "whole": pairs(arena, &reconstruction.states),
        }),
        json!({ "not_certified": NOT_CERTIFIED }),
    ];
    let mut out = String::new();
    for line in &lines {
        let _ = writeln!(out, "{line}");
    }
    if out.contains('…') {
        let help = "print the reduction without `--certificate`: its proof does not need the formulas written out";
        return Err(Failure::request("a formula of the reduction is too long for a certificate", help));
    }
    let prime = proved_prime_after(&text_digest(&out));
    let _ = writeln!(out, "{}", json!({ "prime": prime.cofactor, "witness": prime.witness }));
    Ok(out)
}

/// Returns pairs of a symbol and its value or rate, as JSON objects.
fn pairs(arena: &Arena, list: &[(Expr, Expr)]) -> Vec<Value> {
    let texts = |(symbol, value): &(Expr, Expr)| (print_text(arena, *symbol), print_whole_text(arena, *value));
    let pair = |(name, value): (String, String)| json!({ "name": name, "value": value });
    list.iter().map(texts).map(pair).collect()
}

/// Returns formulas as texts.
fn texts(arena: &Arena, list: &[Expr]) -> Vec<String> {
    list.iter().map(|e| print_whole_text(arena, *e)).collect()
}
