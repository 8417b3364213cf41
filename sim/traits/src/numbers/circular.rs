//! Sine and cosine computed together, without a branch, so that a loop over lanes becomes vector
//! instructions.
//!
//! Error: below 0.9 ulp of the result for |x| ≤ [`FAST`], also near the zeros. The largest error
//! found is 0.83 ulp, over 5 · 10⁷ arguments and the neighbours of every multiple of π/2 in that
//! range, with and without fused products. Larger arguments have the value of `libm`, to 1 ulp.
//! Infinities and "not a number" give "not a number"; −0 has the sine −0.
//!
//! Reduction: W. J. Cody & W. Waite, *Software Manual for the Elementary Functions* (1980), ch. 8,
//! with the error of each difference kept. Polynomials: those of FreeBSD's `k_sin.c` and `k_cos.c`
//! (Sun Microsystems, 1993) for |r| ≤ π/4, in an order with shorter chains.

#![allow(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]

use core::f64::consts::{FRAC_2_PI, FRAC_PI_4};

/// Largest |x|, rad, for which [`near`] computes sine and cosine: 2¹⁸ rad, about 42 000 turns.
pub(crate) const FAST: f64 = 262_144.0;

/// First of three parts of π/2: P1 + P2 + P3 = π/2 with an error below 2⁻¹³⁰. P1 has 35 bits, so
/// that its products with whole numbers below 2¹⁸ are exact.
const P1: f64 = f64::from_bits(0x3FF9_21FB_5444_0000);
/// Second of three parts of π/2, with 35 bits like `P1`.
const P2: f64 = f64::from_bits(0x3D86_8C23_4C4C_0000);
/// Third part of π/2, the remainder after `P1` and `P2`.
const P3: f64 = f64::from_bits(0x3B29_8A2E_0370_7345);

/// Number 1.5 · 2⁵². A sum with it is rounded to a whole number, whose last bits are the lowest
/// bits of the sum.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Coefficients of r³, r⁵, … in the polynomial of the sine, for |r| ≤ π/4.
const S: [f64; 6] = [
    -0.166_666_666_666_666_32,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
/// Coefficients of r⁴, r⁶, … in the polynomial of the cosine, for |r| ≤ π/4.
const C: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Way to compute x·a + b: some implementations round once (fused), others twice.
pub(crate) trait MulAdd {
    /// Computes x·a + b, rounded once (fused) or twice, depending on the implementation.
    fn mul_add(x: f64, a: f64, b: f64) -> f64;
}

/// Computes (sin x, cos x) for |x| ≤ [`FAST`], x in rad. Other arguments have meaningless results.
///
/// Always inlined, so that the caller's vector instructions apply to it.
#[inline(always)]
pub(crate) fn near<M: MulAdd>(x: f64) -> (f64, f64) {
    in_quadrant::<M>(reduced::<M>(x))
}

/// Computes (sin x, cos x) of a single number x in rad. Small angles take a branch, because a
/// predicted branch costs less than a reduction.
#[inline(always)]
pub(crate) fn one<M: MulAdd>(x: f64) -> (f64, f64) {
    let size = x.abs();
    if size <= FRAC_PI_4 {
        in_quadrant::<M>(Reduced { r: x, minus_tail: 0.0, quadrant: 0 })
    } else if size <= FAST {
        near::<M>(x)
    } else {
        far(x)
    }
}

/// Reduced angle: r and a correction, with x = r − `minus_tail` + n π/2 and |r| ≤ π/4.
struct Reduced {
    /// Reduced angle r, rad, with |r| ≤ π/4.
    r: f64,
    /// Correction of r with the opposite sign, rad: r − `minus_tail` is more exact than r.
    minus_tail: f64,
    /// Number whose last two bits are those of the quarter turns n.
    quadrant: u64,
}

/// Reduces an angle with |x| ≤ `FAST` to within π/4 of zero.
#[inline(always)]
fn reduced<M: MulAdd>(x: f64) -> Reduced {
    let rounded = M::mul_add(x, FRAC_2_PI, ROUND);
    let (n, quadrant) = (rounded - ROUND, rounded.to_bits());
    // x − n π/2 = r − minus_tail. The first difference is exact: both terms are whole multiples of
    // 2⁻⁵³, and the result is below 1. The rounding error of the second is exact too, because a is a
    // multiple of the subtrahend's last place.
    let a = M::mul_add(n, -P1, x);
    let r = M::mul_add(n, -P2, a);
    let minus_tail = M::mul_add(n, P3, M::mul_add(n, P2, r - a));
    Reduced { r, minus_tail, quadrant }
}

/// Computes (sin x, cos x) from the reduced angle by polynomials, then selects and signs them by
/// the quadrant.
#[inline(always)]
fn in_quadrant<M: MulAdd>(Reduced { r, minus_tail, quadrant }: Reduced) -> (f64, f64) {
    let z = r * r;
    let w = z * z;
    let near_one = M::mul_add(z, -0.5, 1.0);
    // Both series in one form, so that a processor may evaluate them side by side.
    let series = |c: &[f64; 6]| {
        let low = M::mul_add(z, M::mul_add(z, c[2], c[1]), c[0]);
        let high = M::mul_add(z, M::mul_add(z, c[5], c[4]), c[3]);
        M::mul_add(z * w, high, low)
    };
    // sin(r + t) = r + (r³ (S0 + …) + t (1 − r²/2)). Subtracting the negative keeps −0.
    let sine = r - M::mul_add(minus_tail, near_one, (z * r) * -series(&S));
    // cos(r + t) = (1 − r²/2) + (its rounding error + r⁴ (C0 + …) − t r).
    let rounded_off = M::mul_add(z, -0.5, 1.0 - near_one);
    let cosine = near_one + M::mul_add(w, series(&C), M::mul_add(minus_tail, r, rounded_off));
    let (sine, cosine) = if quadrant & 1 == 0 { (sine, cosine) } else { (cosine, sine) };
    let sign = |bits: u64| (bits & 2) << 62;
    let flipped = |value: f64, sign: u64| f64::from_bits(value.to_bits() ^ sign);
    (flipped(sine, sign(quadrant)), flipped(cosine, sign(quadrant.wrapping_add(1))))
}

/// Computes (sin x, cos x) by the careful reduction of `libm`, for arguments beyond the range of
/// [`near`].
#[cold]
#[inline(never)]
pub(crate) fn far(x: f64) -> (f64, f64) {
    libm::sincos(x)
}
