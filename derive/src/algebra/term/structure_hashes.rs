//! Hashes of the structure of terms. A term has the same hash in every arena, whatever else the
//! arena contains.

use crate::algebra::{Arena, Expr, Node};
use rustc_hash::FxHashMap;

/// Hash of the structure of each given term. The list must contain every operand before the terms
/// built from it.
///
/// Equal structures have equal hashes in any arena; different structures hardly ever do. So hashes
/// give an order of terms that does not depend on when the terms were built. They must not decide
/// if terms are equal.
pub(in crate::algebra) fn structure_hashes(arena: &Arena, terms: &[Expr]) -> FxHashMap<Expr, u64> {
    let mut known: FxHashMap<Expr, u64> = FxHashMap::default();
    for e in terms {
        let number = match arena.node(*e) {
            Node::Number(value) => hash_of_text(1, &value.to_string()),
            Node::Symbol(_) => hash_of_text(2, arena.symbol_name(*e).unwrap_or_default()),
            Node::Pi => mix_hashes(3, 0),
            // The sum of operand hashes does not depend on the order of the operands, which differs
            // between arenas.
            Node::Sum(constant, terms) => {
                let parts = terms.iter().map(|(term, k)| mix_hashes(known[term], hash_of_text(4, &k.to_string())));
                mix_hashes(hash_of_text(5, &constant.to_string()), parts.fold(0, u64::wrapping_add))
            }
            Node::Product(factors) => {
                let parts = factors.iter().map(|(base, n)| mix_hashes(known[base], hash_of_text(6, &n.to_string())));
                mix_hashes(7, parts.fold(0, u64::wrapping_add))
            }
            Node::Apply(f, argument) => mix_hashes(hash_of_text(8, f.name()), known[argument]),
            Node::Named(_, term) => mix_hashes(9, known[term]),
        };
        known.insert(*e, number);
    }
    known
}

/// Hash of two numbers combined (the last step of SplitMix64).
fn mix_hashes(a: u64, b: u64) -> u64 {
    let mut x = a.rotate_left(23) ^ b.wrapping_add(0x9e37_79b9_7f4a_7c15);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// Hash of a text. `kind` is the number of a node kind; equal texts of different kinds have
/// different hashes.
fn hash_of_text(kind: u64, words: &str) -> u64 {
    words.bytes().fold(mix_hashes(kind, 0), |sum, byte| mix_hashes(sum, u64::from(byte)))
}
