//! Lanes: several f64 side by side, as the vector registers of a processor hold them.
//!
//! Invariant: the bits of a lane depend neither on the contents nor on the number of the other
//! lanes, nor on the processor. So products are fused everywhere or nowhere: [`Scalar::mul_add`]
//! always, `*` followed by `+` never.
//!
//! Operations are written as loops over arrays, which the compiler turns into vector instructions
//! inside [`Scalar::dispatch`]. Outside it, they use the instructions of the compilation target,
//! and a fused product is a function call if the target has none. Lanes cannot be compared: they
//! may differ, so the caller decides lane by lane.

#![allow(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]

use super::circular;
use super::circular::MulAdd;
use super::maxima::larger_or_second;
use super::scalar::series::{Factors, Pair};
use super::scalar::{Scalar, series};
use crate::dispatch;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Vector of `N` f64, on which every operation acts lane by lane; 4 or 8 of them fill a register.
///
/// ```
/// use tripos_traits::{Lanes, Scalar};
///
/// let angles = Lanes([0.0, 0.5, 1.0, 1.5]);
/// let (sine, cosine) = Lanes::<4>::dispatch(|| angles.sin_cos());
/// let one = sine.mul_add(sine, cosine * cosine);
/// assert!(one.0.iter().all(|one| (one - 1.0).abs() < 1e-15));
/// ```
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub struct Lanes<const N: usize>(
    /// Numbers of the vector, one for each lane.
    pub [f64; N],
);

/// Way to compute x·a + b: fused, so that it is rounded once on every processor.
struct Fused;

impl MulAdd for Fused {
    #[inline(always)]
    fn mul_add(x: f64, a: f64, b: f64) -> f64 {
        #[cfg(feature = "std")]
        return f64::mul_add(x, a, b);
        #[cfg(not(feature = "std"))]
        return libm::fma(x, a, b);
    }
}

/// Square root √x of an f64, correctly rounded.
#[inline(always)]
fn sqrt(x: f64) -> f64 {
    #[cfg(feature = "std")]
    return x.sqrt();
    #[cfg(not(feature = "std"))]
    return libm::sqrt(x);
}

/// Repeats an expression for each lane index. Generated code has thousands of these loops; written
/// out, they compile in half the time that loops to be unrolled take.
macro_rules! each_lane {
    ($l:ident, $n:expr, $do:expr) => {
        if $n == 4 {
            each_lane!($l, $do, 0 1 2 3);
        } else if $n == 8 {
            each_lane!($l, $do, 0 1 2 3 4 5 6 7);
        } else {
            let mut $l = 0;
            while $l < $n {
                $do;
                $l += 1;
            }
        }
    };
    ($l:ident, $do:expr, $($at:literal)+) => {
        $({
            let $l = $at;
            $do;
        })+
    };
}
pub(crate) use each_lane;

impl<const N: usize> Lanes<N> {
    /// Larger of two numbers in each lane, and the second number if either is "not a number", like the
    /// function [`larger_or_second`].
    #[inline(always)]
    #[must_use]
    pub fn larger_or_second(self, other: Self) -> Self {
        let mut out = self;
        each_lane!(l, N, out.0[l] = larger_or_second(self.0[l], other.0[l]));
        out
    }

    /// Applies a function to the number in each lane.
    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Self {
        let mut out = self;
        each_lane!(l, N, out.0[l] = f(self.0[l]));
        out
    }
}

/// Implements an operator such as `+` for `Lanes`, lane by lane.
macro_rules! operator {
    ($trait:ident, $function:ident, $operator:tt) => {
        impl<const N: usize> $trait for Lanes<N> {
            type Output = Self;
            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                let mut out = self;
                each_lane!(l, N, out.0[l] = self.0[l] $operator other.0[l]);
                out
            }
        }
    };
}

operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);
operator!(Div, div, /);

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(|x| -x)
    }
}

/// Replaces sines and cosines in the lanes whose arguments exceed the range of [`circular::near`]
/// by those of `libm`.
#[cold]
#[inline(never)]
fn with_far_lanes<const N: usize>(x: [f64; N], sine: Lanes<N>, cosine: Lanes<N>) -> (Lanes<N>, Lanes<N>) {
    let (mut sine, mut cosine) = (sine, cosine);
    for ((x, s), c) in x.iter().zip(&mut sine.0).zip(&mut cosine.0) {
        if !is_near(*x) {
            (*s, *c) = circular::far(*x);
        }
    }
    (sine, cosine)
}

/// True if the argument is within the range of `circular::near`.
#[inline(always)]
fn is_near(x: f64) -> bool {
    x.abs() <= circular::FAST
}

impl<const N: usize> Scalar for Lanes<N> {
    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self([x; N])
    }
    fn decimal(text: &str) -> Self {
        Self([f64::decimal(text); N])
    }
    #[inline(always)]
    fn pi() -> Self {
        Self([f64::pi(); N])
    }
    #[inline(always)]
    fn ratio(numerator: i64, denominator: i64) -> Self {
        Self([f64::ratio(numerator, denominator); N])
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (mut sine, mut cosine, mut all_near) = (self, self, true);
        each_lane!(l, N, {
            (sine.0[l], cosine.0[l]) = circular::near::<Fused>(self.0[l]);
            all_near &= is_near(self.0[l]);
        });
        if all_near { (sine, cosine) } else { with_far_lanes(self.0, sine, cosine) }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.each(sqrt)
    }
    fn asin(self) -> Self {
        self.each(Scalar::asin)
    }
    fn acos(self) -> Self {
        self.each(Scalar::acos)
    }
    fn atan(self) -> Self {
        self.each(Scalar::atan)
    }
    fn exp(self) -> Self {
        self.each(Scalar::exp)
    }
    fn ln(self) -> Self {
        self.each(Scalar::ln)
    }
    fn sinh(self) -> Self {
        self.each(Scalar::sinh)
    }
    fn cosh(self) -> Self {
        self.each(Scalar::cosh)
    }
    fn tanh(self) -> Self {
        self.each(Scalar::tanh)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.each(f64::abs)
    }
    #[inline(always)]
    fn sign(self) -> Self {
        self.each(Scalar::sign)
    }
    /// Computes x·a + b, rounded once on every processor. On a target without a fused instruction, it
    /// is a slow function call.
    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        let mut out = self;
        each_lane!(l, N, out.0[l] = Fused::mul_add(self.0[l], a.0[l], b.0[l]));
        out
    }
    /// Sums products of Taylor coefficients in blocks that fill the registers of four lanes.
    #[inline(always)]
    fn pair_sums<const W: usize>(history: &[Factors<Self, W>]) -> Pair<Self, W> {
        series::read_twice::<Self, W, { series::LANES / 2 }>(history)
    }
    /// Runs `work` with AVX-512, or with AVX2 and fused products, if the processor has them. The
    /// instructions apply only to `work` and to code that is inlined into it. If its body is long,
    /// write `#[inline(always)] ||` before it.
    #[inline(always)]
    fn dispatch<R>(work: impl FnOnce() -> R) -> R {
        dispatch::run::<N, R>(work)
    }
}
