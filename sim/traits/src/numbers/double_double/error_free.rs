//! Sums and products of two f64 together with their exact rounding errors.
//!
//! Each function returns (s, e): s is the rounded result and s + e the exact result, if nothing
//! overflows or underflows. No fused multiply–add is used. Without the hardware instruction,
//! `libm::fma` is emulated, at many times the cost. If the instruction is found at run time, its
//! call costs 2.6 ns a product against 1.1 ns of the split. In a chain of dependent products, the
//! call costs 7 ns against 12 ns.
//!
//! Knuth, *The Art of Computer Programming* 2, §4.2.2; Dekker, "A floating-point technique for
//! extending the available precision", Numerische Mathematik 18 (1971) 224–242.

/// Sum a + b of two f64 as (rounded sum, its exact rounding error).
#[inline]
pub(super) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let b_seen = s - a;
    (s, (a - (s - b_seen)) + (b - b_seen))
}

/// Sum a + b as (rounded sum, its rounding error), for |a| ≥ |b| or a = 0. Cheaper than `two_sum`.
#[inline]
pub(super) fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

/// Product a b as (rounded product, its rounding error). The error is "not a number" if |a| or |b|
/// exceeds 2⁹⁹⁶.
#[inline]
pub(super) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let (a_hi, a_lo) = split(a);
    let (b_hi, b_lo) = split(b);
    (p, ((a_hi * b_hi - p) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo)
}

/// Splits a into (high, low), a sum of two numbers of 26 bits. Products of such numbers are exact.
#[inline]
fn split(a: f64) -> (f64, f64) {
    const FACTOR: f64 = 134_217_729.0; // 2²⁷ + 1
    let scaled = FACTOR * a;
    let hi = scaled - (scaled - a);
    (hi, a - hi)
}
