//! Command `tripos prove`: proves that the formulations are equivalent, and finds first integrals of the motion.

mod certificate;
mod exact;
mod identities;
mod lemmas;

use crate::arguments::CertificateFormat;
use crate::commands::derive::derivation_text_in_json;
use crate::files::output_files::{refuse_overwriting_inputs, write_text_file};
use crate::files::workspace::{read_model, short_name};
use crate::glossary::{glossary_json, glossary_text};
use crate::terminal::failure::{Failure, Output, print, print_json, status};
use lemmas::Assistant;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::Mechanism;
use tripos::equations_name::formulation_of_name;
use tripos_derive::algebra::form::simplify::operation_count;
use tripos_derive::algebra::meaning::compare::{Engine, Verdict, Witness};
use tripos_derive::algebra::text::print::{print_text, print_whole_text};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{LoadDivisor, derive_all};
use tripos_derive::prove::{Integral, Proof, prove as prove_model, prove_exactly};

/// Largest length, in bytes, of a reaction's formula that the text shows.
const LONGEST: usize = 600;

/// Runs `tripos prove`: proves that the standard formulations and those in `also` are equivalent, and finds first
/// integrals. Writes a certificate of these proofs to the file `certificate`, if given. With `is_exact`, the identities
/// of the proofs are proved by normal forms alone. Returns the exit status, which is 1 if a pair of formulations is not
/// proved equivalent, or not exactly; without equivalence there is no certificate.
///
/// # Errors
/// `Failure` if the model has errors, if a formulation in `also` is unknown or cannot be derived, or if the certificate
/// cannot be written.
pub fn prove(
    model: &Path,
    also: &[String],
    certificate: Option<(&Path, CertificateFormat)>,
    is_exact: bool,
    output: Output,
) -> Result<u8, Failure> {
    let also = also.iter().map(|name| formulation_of_name(name)).collect::<Result<Vec<_>, _>>()?;
    let model = read_model(model)?;
    refuse_overwriting_inputs(&model, None, certificate.map(|(path, _)| path))?;
    let mut derivations = derive_all(&model).map_err(|error| model.diagnose(&error))?;
    for formulation in also {
        derivations.add(&model, formulation).map_err(|error| model.diagnose(&error))?;
    }
    let proof = prove_model(&model, &mut derivations);
    proof.write_names(&mut derivations);
    if let Some((path, format)) = certificate.filter(|_| proof.is_equivalent()) {
        let derivation = derivation_text_in_json(&model)?;
        let text = match format {
            CertificateFormat::Lines => certificate::certificate_text(&model, &mut derivations, &proof, &derivation)?,
            CertificateFormat::Coq => {
                lemmas::lemma_text(&model, &mut derivations, &proof, &derivation.json, Assistant::Coq)
            }
            CertificateFormat::Lean => {
                lemmas::lemma_text(&model, &mut derivations, &proof, &derivation.json, Assistant::Lean)
            }
        };
        write_text_file(path, &text)?;
    }
    let exact = is_exact.then(|| prove_exactly(&mut derivations.kinematics.arena, &proof));
    let arena = &derivations.kinematics.arena;
    if output == Output::Json {
        let mut value = json_of(&model, arena, &proof);
        if let Some(counts) = &exact {
            value["exact"] = exact::exact_proofs_json(&model, arena, &proof, counts);
        }
        print_json(&value)?;
    } else {
        let exact = exact.as_ref().map(|counts| exact::exact_proofs_text(&model, arena, &proof, counts));
        print(&(text_of(&model, arena, &proof) + &exact.unwrap_or_default()))?;
    }
    let is_open = exact.is_some_and(|counts| counts.iter().any(|count| count.open > 0));
    Ok(if proof.is_equivalent() && !is_open { 0 } else { status::NO })
}

/// Returns the certificate of all proofs about a model, with the bytes that `prove --certificate` writes. `None` if a
/// pair of formulations is not proved equivalent.
///
/// # Errors
/// `Failure` if the model cannot be derived, or if its proofs cannot be certified.
pub fn certificate_of_model(model: &Mechanism) -> Result<Option<String>, Failure> {
    let mut derivations = derive_all(model).map_err(|error| model.diagnose(&error))?;
    let proof = prove_model(model, &mut derivations);
    if !proof.is_equivalent() {
        return Ok(None);
    }
    proof.write_names(&mut derivations);
    let derivation = derivation_text_in_json(model)?;
    certificate::certificate_text(model, &mut derivations, &proof, &derivation).map(Some)
}

/// Returns the word for a verdict in tables and in JSON: `equal`, `different` or `undecided`.
pub fn proof_verdict_word(verdict: &Verdict) -> &'static str {
    match verdict {
        Verdict::Equal(_) => "equal",
        Verdict::Different(_) => "different",
        Verdict::Undecided(_) => "undecided",
    }
}

/// Returns, as JSON, the method of proof that decided equality. Null if the verdict is not "equal".
pub fn proof_method_json(verdict: &Verdict) -> Value {
    match verdict {
        Verdict::Equal(Engine::NormalForm) => json!("normal-form"),
        Verdict::Equal(engine @ Engine::Modular { .. }) => json!(engine.to_string()),
        Verdict::Different(_) | Verdict::Undecided(_) => Value::Null,
    }
}

/// Returns the witness of a difference as JSON: a state, and the values of both sides in it.
pub fn proof_witness_json(witness: &Witness) -> Value {
    let at: serde_json::Map<String, Value> = witness.at.iter().map(|(name, x)| (name.clone(), json!(x))).collect();
    json!({ "at": at, "left": witness.left, "right": witness.right, "difference": witness.difference })
}

/// Returns the results of all proofs about a model as JSON.
pub fn json_of(model: &Mechanism, arena: &Arena, proof: &Proof) -> Value {
    let pairs: Vec<Value> = proof
        .pairs
        .iter()
        .map(|pair| {
            let mut value = json!({
                "left": pair.left.name(),
                "right": pair.right.name(),
                "verdict": proof_verdict_word(&pair.verdict),
                "engine": proof_method_json(&pair.verdict),
                "map": pair.map.text(),
            });
            match &pair.verdict {
                Verdict::Different(found) => value["witness"] = proof_witness_json(found),
                Verdict::Undecided(why) => value["why"] = json!(why),
                Verdict::Equal(_) => {}
            }
            value
        })
        .collect();
    let integrals: Vec<Value> = proof
        .integrals
        .iter()
        .map(|integral| {
            json!({
                "name": integral.name(model, arena),
                "also": integral.names(model, arena).split_off(1),
                "expression": print_whole_text(arena, integral.expression),
                "except_where": integral.divisors(arena).iter().map(|e| format!("{} = 0", print_whole_text(arena, *e))).collect::<Vec<_>>(),
                "while_constant": inputs_in_integral(model, arena, integral),
                "verdict": if integral.verdict.is_equal() { "proved" } else { proof_verdict_word(&integral.verdict) },
                "engine": proof_method_json(&integral.verdict),
            })
        })
        .collect();
    let reactions: Vec<Value> =
        proof.reactions.iter().map(|r| json!({ "name": r.name, "value": print_whole_text(arena, r.value) })).collect();
    let missing: Vec<Value> =
        proof.missing.iter().map(|(f, why)| json!({ "formulation": f.name(), "why": why.to_string() })).collect();
    let all: Vec<Expr> =
        formulas_in_proof_report(arena, proof).chain(proof.reactions.iter().map(|reaction| reaction.value)).collect();
    json!({
        "model": short_name(model),
        "equivalent": proof.is_equivalent(),
        "pairs": pairs,
        "missing": missing,
        "reactions": reactions,
        "integrals": integrals,
        "search": proof.search.text(arena),
        "names": glossary_json(arena, &all),
        "loads_divide_by": proof.loads.iter().map(|load| json!({
            "load": load.load, "divisor": print_whole_text(arena, load.value), "meaning": load.zero_divisor_meaning(),
        })).collect::<Vec<_>>(),
        "singular_where": proof.singular_where.iter().map(|e| print_whole_text(arena, *e)).collect::<Vec<_>>(),
    })
}

/// Returns the results of all proofs about a model as text.
fn text_of(model: &Mechanism, arena: &Arena, proof: &Proof) -> String {
    let mut out = format!("{}\n{}\n\nEquivalence\n", model.title, model.counts_in_words());
    for pair in &proof.pairs {
        let verdict = match &pair.verdict {
            Verdict::Equal(engine) => format!("proved ({engine})"),
            Verdict::Different(found) => format!("DIFFERENT: {} against {}", found.left, found.right),
            Verdict::Undecided(why) => format!("undecided: {why}"),
        };
        let _ = writeln!(out, "  {} <=> {}: {verdict}\n    {}", pair.left.name(), pair.right.name(), pair.map.text());
    }
    for (formulation, why) in &proof.missing {
        let _ = writeln!(out, "  {}: not derived: {why}", formulation.name());
    }
    if proof.singular_where.is_empty() {
        out.push_str("  valid everywhere: neither the kinematic equations nor loads divide by what may be 0\n");
    } else {
        let place = |e: &Expr| {
            let loads: Vec<String> =
                proof.loads.iter().filter(|load| load.value == *e).map(LoadDivisor::zero_divisor_meaning).collect();
            let meaning = if loads.is_empty() { String::new() } else { format!(" ({})", loads.join(", ")) };
            format!("{} = 0{meaning}", print_text(arena, *e))
        };
        let list: Vec<String> = proof.singular_where.iter().map(place).collect();
        let _ = writeln!(out, "  valid except where {}", list.join(", "));
    }
    if !proof.reactions.is_empty() {
        out.push_str("\nReactions, from the equations that Kane's method leaves over\n");
    }
    for reaction in &proof.reactions {
        if is_short_reaction(arena, reaction.value) {
            let _ = writeln!(out, "  {} = {}", reaction.name, print_text(arena, reaction.value));
        } else {
            let operations = operation_count(arena, reaction.value);
            let _ = writeln!(out, "  {}: {operations} operations, which `--json` has", reaction.name);
        }
    }
    out.push_str("\nFirst integrals\n");
    for integral in &proof.integrals {
        let verdict = match &integral.verdict {
            Verdict::Equal(engine) => format!("proved ({engine})"),
            Verdict::Different(_) => "NOT conserved".to_owned(),
            Verdict::Undecided(why) => format!("undecided: {why}"),
        };
        let _ = writeln!(
            out,
            "  {}: {verdict}\n    {}",
            integral.full_name(model, arena),
            print_text(arena, integral.expression)
        );
        let inputs = inputs_in_integral(model, arena, integral);
        if !inputs.is_empty() {
            let _ = writeln!(out, "    while constant: {}", inputs.join(", "));
        }
        let divisors: Vec<String> =
            integral.divisors(arena).iter().map(|e| format!("{} = 0", print_text(arena, *e))).collect();
        if !divisors.is_empty() {
            let _ = writeln!(out, "    except where {}", divisors.join(", "));
        }
    }
    if proof.integrals.is_empty() {
        out.push_str("  none found\n");
    }
    let _ = writeln!(out, "  ({})", proof.search.text(arena));
    let reactions = proof.reactions.iter().map(|reaction| reaction.value);
    let shown: Vec<Expr> =
        formulas_in_proof_report(arena, proof).chain(reactions.filter(|e| is_short_reaction(arena, *e))).collect();
    out + &glossary_text(arena, &shown)
}

/// Names of the inputs in the value of a first integral. It is conserved only while they are constant.
pub fn inputs_in_integral(model: &Mechanism, arena: &Arena, integral: &Integral) -> Vec<String> {
    let parts = arena.reachable(&[integral.expression]);
    let inputs = model.inputs.iter().filter(|input| input.is_parameter && parts.contains(&input.value));
    inputs.map(|input| input.name.clone()).collect()
}

/// True if a reaction's formula is short enough to be shown in the text.
fn is_short_reaction(arena: &Arena, e: Expr) -> bool {
    print_text(arena, e).len() <= LONGEST
}

/// Returns the formulas that the report on a proof shows, except those of reactions.
fn formulas_in_proof_report<'a>(arena: &'a Arena, proof: &'a Proof) -> impl Iterator<Item = Expr> + 'a {
    let integrals = proof.integrals.iter().flat_map(|integral| integral.shown_formulas_of_integral(arena));
    integrals.chain(proof.search.power).chain(proof.singular_where.iter().copied())
}
