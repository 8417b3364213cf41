//! Values of terms: in floating point, as intervals, as rational numbers, and as residues modulo
//! primes.

pub(super) mod bound;
pub mod evaluate;
pub(crate) mod exact;
pub(crate) mod field;
pub(crate) mod interval;
pub mod modular;
pub(crate) mod points;
pub mod range;
pub mod rank;
pub(crate) mod reconstruct;
pub(crate) mod tangent;
