//! Fewer operations: common sub-sums and sub-products over everything that one function computes.
//!
//! The values become sums of monomials over atoms, and two kinds of common divisor are taken out, one at a time, the
//! one that saves most first: a sum of two terms, whatever monomial stands before it (this is factoring where it occurs
//! once, and sharing where it occurs more often), and a product of two factors. Longer ones arise by repetition, so
//! that what grows along a chain is added up once along it. Reciprocals are atoms too: what many terms divide by is
//! inverted once.
//!
//! Invariant: the value of every step and output is the same function as before; only polynomial identities are used.
//! Absent on purpose: names. New symbols are called `#1`, `#2`, …, or `#sin(q1 - q2)` after what they hold, which no
//! model file can contain; who writes them down gives them better ones.
//!
//! Source: greedy extraction of double-cube and single-cube divisors, J. Rajski & J. Vasudevamurthy, "The
//! testability-preserving concurrent decomposition and factorization of Boolean expressions", IEEE Trans. CAD 11
//! (1992); for polynomials, A. Hosangadi, F. Fallah & R. Kastner, "Optimizing polynomial expressions by algebraic
//! factorization and common subexpression elimination", IEEE Trans. CAD 25 (2006).

mod angles;
mod divisors;
mod network;
mod rebuild;
mod same;

use super::simplify::Simplifier;
use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr, Function};
use angles::Composed;
use divisors::Extraction;
use network::Network;

pub use rebuild::{Shared, is_shared_symbol};
pub use same::is_same;

/// Preparation of the values before common divisors are looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reading {
    /// Extent to which products are multiplied out.
    pub products: Products,
    /// Treatment of angles that are sums of other angles.
    pub angles: Angles,
}

/// Treatment of sines and cosines of sums of angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Angles {
    /// They are computed as such.
    Kept,
    /// They come from those of the parts by the addition theorems, where that saves sines and cosines.
    Composed,
    /// Angles are composed, and the theorems are multiplied out with the rest.
    Open,
}

/// Extent to which products are multiplied out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Products {
    /// Products stay as they are factored.
    Factored,
    /// Multiplied out, as far as that stays short.
    Expanded,
    /// Multiplied out, with 1 − cos² for sin².
    Cosines,
    /// Multiplied out, with 1 − sin² for cos².
    Sines,
}

impl Reading {
    /// All of them.
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

    /// Those that win most often.
    pub const SAMPLE: [Self; 3] = [
        Self { products: Products::Factored, angles: Angles::Kept },
        Self { products: Products::Expanded, angles: Angles::Kept },
        Self { products: Products::Expanded, angles: Angles::Open },
    ];
}

impl Products {
    /// Terms beyond which a value is read as it is factored.
    const LIMIT: usize = 60;

    /// A value as this reading has it.
    fn read(self, arena: &mut Arena, simplifier: &mut Simplifier, e: Expr) -> Expr {
        if self == Self::Factored {
            return e;
        }
        let Some(mut polynomial) = simplifier.polynomial(arena, e) else { return e };
        if self != Self::Expanded {
            for angle in polynomial.angles(arena) {
                let (sine, cosine) = (arena.apply(Function::Sin, angle), arena.apply(Function::Cos, angle));
                let (from, to) = if self == Self::Cosines { (sine, cosine) } else { (cosine, sine) };
                if let Some(traded) = polynomial.pythagoras(from, to, Self::LIMIT) {
                    polynomial = traded;
                }
            }
        }
        if polynomial.terms.len() > Self::LIMIT { e } else { polynomial.expand(arena) }
    }
}

/// Takes common sub-sums and sub-products out of steps and values.
///
/// `None` if there is nothing that this reading reads otherwise than one before it.
pub fn share(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    reading: Reading,
    steps: &[Definition],
    values: &[Expr],
) -> Option<Shared> {
    let (steps, values) = match reading.angles {
        Angles::Kept => (steps.to_vec(), values.to_vec()),
        Angles::Composed => angles::compose(arena, &Composed::Named, steps, values)?,
        Angles::Open => angles::compose(arena, &Composed::Open, steps, values)?,
    };
    let steps: Vec<Definition> = steps
        .iter()
        .map(|step| Definition { symbol: step.symbol, value: reading.products.read(arena, simplifier, step.value) })
        .collect();
    let values: Vec<Expr> = values.iter().map(|e| reading.products.read(arena, simplifier, *e)).collect();
    let network = Network::new(arena, &steps, &values);
    let network = Extraction::new(network).run();
    rebuild::rebuild(arena, &network)
}
