//! Values of terms: in floating point, as intervals, as rational numbers, and as residues modulo
//! primes.

pub(crate) mod field;
pub(crate) mod interval;
pub mod positive_range;
pub mod proved_prime;
pub mod range;
pub mod rank;
pub(crate) mod rational_value;
pub(crate) mod reconstruction;
pub(crate) mod residues;
pub(crate) mod tangent;
pub mod tape;
pub(super) mod zero_error_bound;
pub mod zero_test;
