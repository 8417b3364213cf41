//! Sharing of common sub-sums and sub-products among all values that a function computes, so that
//! it needs fewer operations.
//!
//! The values become sums of monomials over atoms. Two kinds of common divisors are taken out in
//! sequence, the divisor that saves most operations first. The first kind is a sum of two terms,
//! times any monomial. This is factoring if it occurs once, and sharing if it occurs more often.
//! The second kind is a product of two factors.
//! Longer divisors arise by repetition, so a sum along a chain is computed once along it.
//! Reciprocals are atoms too: a divisor of many terms is inverted once.
//!
//! Invariant: the value of every step and output is the same function as before; only polynomial
//! identities are used.
//! Absent on purpose: good names. New symbols are called `#1`, `#2`, …, or `#sin(q1 - q2)` after
//! their values, which no model file can contain. The printers rename them.
//!
//! Source: greedy extraction of double-cube and single-cube divisors, J. Rajski & J. Vasudevamurthy, "The
//! testability-preserving concurrent decomposition and factorization of Boolean expressions", IEEE Trans. CAD 11
//! (1992); for polynomials, A. Hosangadi, F. Fallah & R. Kastner, "Optimizing polynomial expressions by algebraic
//! factorization and common subexpression elimination", IEEE Trans. CAD 25 (2006).

mod composed_angles;
mod divisor_extraction;
mod equivalence;
mod network;
mod rebuild;

use super::simplify::Simplifier;
use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr, Function};
use composed_angles::Composed;
use divisor_extraction::Extraction;
use network::Network;

pub use equivalence::is_equivalent_after_sharing;
pub use rebuild::{SharedComputation, is_shared_symbol};

/// Options for preparing values before the search for common divisors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SharingOptions {
    /// Extent to which products in the values are multiplied out.
    pub products: Products,
    /// Treatment of sines and cosines whose angle is a sum of other angles.
    pub angles: Angles,
}

/// Treatment of sines and cosines of sums of angles, when shared values are prepared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Angles {
    /// Sines and cosines of sums of angles are computed directly, without addition theorems.
    Kept,
    /// Sines and cosines of sums of angles are computed by addition theorems from those of the
    /// parts, if that saves sines and cosines. Each sine or cosine gets a step of its own.
    Composed,
    /// Sines and cosines of sums are replaced by the addition theorems, which are multiplied out
    /// with the rest of the values.
    Open,
}

/// Extent to which products are multiplied out, when shared values are prepared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Products {
    /// Products in the values stay factored.
    Factored,
    /// Products are multiplied out, as long as the value stays short.
    Expanded,
    /// Products are multiplied out, and sin² is replaced by 1 − cos².
    Cosines,
    /// Products are multiplied out, and cos² is replaced by 1 − sin².
    Sines,
}

impl SharingOptions {
    /// All twelve options: each of the four treatments of products with each of the three
    /// treatments of angles.
    pub const ALL: [Self; 12] = {
        let mut all = [Self { products: Products::Factored, angles: Angles::Kept }; 12];
        let mut at = 0;
        while at < 12 {
            all[at].products = [Products::Factored, Products::Expanded, Products::Cosines, Products::Sines][at % 4];
            all[at].angles = [Angles::Kept, Angles::Composed, Angles::Open][at / 4];
            at += 1;
        }
        all
    };

    /// Three options that most often give the fewest operations.
    pub const COMMON_OPTIONS: [Self; 3] = [
        Self { products: Products::Factored, angles: Angles::Kept },
        Self { products: Products::Expanded, angles: Angles::Kept },
        Self { products: Products::Expanded, angles: Angles::Open },
    ];
}

impl Products {
    /// Largest number of terms of a value that is multiplied out; a longer value stays factored.
    const LIMIT: usize = 60;

    /// Multiplies the value `e` out to the extent of this option. A value that would become too
    /// long is returned unchanged.
    fn expand_for_sharing(self, arena: &mut Arena, simplifier: &mut Simplifier, e: Expr) -> Expr {
        if self == Self::Factored {
            return e;
        }
        let Some(mut polynomial) = simplifier.polynomial(arena, e) else { return e };
        if self != Self::Expanded {
            for angle in polynomial.angles(arena) {
                let (sine, cosine) = (arena.apply(Function::Sin, angle), arena.apply(Function::Cos, angle));
                let (from, to) = if self == Self::Cosines { (sine, cosine) } else { (cosine, sine) };
                if let Some(traded) = polynomial.replace_squares(from, to, Self::LIMIT) {
                    polynomial = traded;
                }
            }
        }
        if polynomial.terms.len() > Self::LIMIT { e } else { polynomial.expand(arena) }
    }
}

/// Takes common sub-sums and sub-products out of the steps and values of a function. Returns the
/// new steps and values.
///
/// `None` if the options ask for composed angles and no angle can be composed, or too many can.
/// `None` also if an exponent becomes too large for the arena.
pub fn share_common_parts(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    reading: SharingOptions,
    steps: &[Definition],
    values: &[Expr],
) -> Option<SharedComputation> {
    let (steps, values) = match reading.angles {
        Angles::Kept => (steps.to_vec(), values.to_vec()),
        Angles::Composed => composed_angles::compose_angles(arena, &Composed::Named, steps, values)?,
        Angles::Open => composed_angles::compose_angles(arena, &Composed::Open, steps, values)?,
    };
    let steps: Vec<Definition> = steps
        .iter()
        .map(|step| Definition {
            symbol: step.symbol,
            value: reading.products.expand_for_sharing(arena, simplifier, step.value),
        })
        .collect();
    let values: Vec<Expr> = values.iter().map(|e| reading.products.expand_for_sharing(arena, simplifier, *e)).collect();
    let network = Network::new(arena, &steps, &values);
    let network = Extraction::new(network).run();
    rebuild::rebuild(arena, &network)
}
