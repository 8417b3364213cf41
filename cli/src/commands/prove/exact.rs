//! Report on the exact proofs of `tripos prove --exact`: the number of identities that normal forms prove.

use serde_json::{Value, json};
use std::fmt::Write;
use tripos::Mechanism;
use tripos_derive::algebra::Arena;
use tripos_derive::prove::{ExactCount, Proof, ProvedStatement};

/// Returns the counts of exact proofs as text: a line for each statement, and the statements that are not proved
/// exactly.
pub fn exact_proofs_text(model: &Mechanism, arena: &Arena, proof: &Proof, counts: &[ExactCount]) -> String {
    let mut out = "\nExact proofs, by normal forms with s² + c² = 1\n".to_owned();
    for count in counts {
        let name = statement_name(model, arena, proof, count.statement);
        let total = count.exact + count.open;
        let _ = match count.open {
            0 => writeln!(out, "  {name}: all {total} identities"),
            open => {
                writeln!(out, "  {name}: {} of {total} identities; NOT PROVED EXACTLY: {open}, too long", count.exact)
            }
        };
    }
    out
}

/// Returns the counts of exact proofs as JSON.
pub fn exact_proofs_json(model: &Mechanism, arena: &Arena, proof: &Proof, counts: &[ExactCount]) -> Value {
    let count = |count: &ExactCount| {
        json!({
            "statement": statement_name(model, arena, proof, count.statement),
            "exact": count.exact,
            "not_proved_exactly": count.open,
        })
    };
    counts.iter().map(count).collect()
}

/// Name of a statement in words, such as `kane from lagrange`.
fn statement_name(model: &Mechanism, arena: &Arena, proof: &Proof, statement: ProvedStatement) -> String {
    match statement {
        ProvedStatement::Combination(of, gives) => format!("{} from {}", gives.name(), of.name()),
        ProvedStatement::Integral(at) => proof.integrals[at].name(model, arena),
    }
}
