//! Interface of a method that takes a step in every lane at once.
//!
//! Invariant: a lane computes the same numbers whatever the other lanes hold.

#![allow(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]

use tripos_traits::{Lanes, Scalar};

use crate::stepper::Interpolant;
use crate::tolerance::ErrorTest;

/// Result of an attempted step in each lane.
pub(super) struct Attempt<const N: usize> {
    /// Error in the norm of the error test, below the tolerance for a good step; meaningless if the step has no result.
    pub(super) error: [f64; N],
    /// True if all points of the step and its new state are finite.
    pub(super) finite: [bool; N],
    /// True if the derivative at the new state of the step is finite.
    pub(super) finite_end: [bool; N],
    /// Number of evaluations of the equations that the step made for each lane.
    pub(super) evaluations: [u64; N],
}

/// A method of integration in `N` lanes. Each lane has its own step size and its own error.
pub(super) trait Method<const N: usize> {
    /// Number of parameters of the equations.
    fn parameters(&self) -> usize;
    /// Length of the state [q; v].
    fn states(&self) -> usize;

    /// Writes the derivative of the state `y`, for parameters `p`, to `f`.
    fn rates(&self, p: &[Lanes<N>], y: &[Lanes<N>], f: &mut [Lanes<N>]);
    /// Initial rows of the lanes for the states `y` and parameters `p`. Each row is as long as the state: the first is
    /// the state, the second its derivative, then possibly higher Taylor coefficients.
    fn begin(&mut self, p: &[Lanes<N>], y: &[Lanes<N>]) -> Vec<Lanes<N>>;
    /// Puts a trajectory into a lane: its parameters, and its rows from [`Method::begin`].
    fn load(&mut self, lane: usize, parameters: &[f64], begun: &[f64]);

    /// Sizes of the next steps, s, if the method knows them before they are tried; else `None`.
    fn proposals(&mut self, test: &ErrorTest) -> Option<[f64; N]> {
        let _ = test;
        None
    }
    /// Tries a step of signed size `h`, in s, in every lane.
    fn attempt(&mut self, h: [f64; N], test: &ErrorTest) -> Attempt<N>;
    /// Component, from 0, of the first number that is not finite when a lane repeats its step of size `h`, in s.
    fn first_not_finite(&mut self, lane: usize, h: [f64; N], test: &ErrorTest) -> usize;
    /// Lets the marked lanes go on from the end of their last tried step, and the other lanes from its start.
    fn accept(&mut self, accepted: [bool; N]);
    /// State [q; v] of a lane.
    fn state(&self, lane: usize) -> Vec<f64>;

    /// Evaluates the stages that only the solution inside a step needs, for the steps of sizes `h`, s, that were tried
    /// last.
    fn prepare_inside(&mut self, h: [f64; N]) {
        let _ = h;
    }
    /// Number of evaluations that [`Method::prepare_inside`] makes for each lane.
    const INSIDE: u64 = 0;
    /// Writes the states at the start and at the end of the step that a lane tried last, before it is accepted.
    fn ends(&self, lane: usize, out: &mut [Vec<f64>; 2]);
    /// Degree of the polynomial that gives the solution inside a step.
    fn degree(&self) -> usize;
    /// Hands `put` each component of the solution inside the last step of a lane, `after` seconds from its start; the
    /// step is `h` seconds long.
    fn inside(&self, lane: usize, after: f64, h: f64, put: impl FnMut(usize, f64));
    /// Hands `put` the coefficients of the solution inside a step: component, power of the fraction of the step, and
    /// coefficient, as [`Interpolant::coefficients`] does.
    fn coefficients(&self, lane: usize, h: f64, put: impl FnMut(usize, usize, f64));
}

/// Step that one lane tried last, for the watcher of its trajectory.
pub(super) struct LaneStep<'m, M, const N: usize> {
    pub(super) method: &'m M,
    pub(super) lane: usize,
    /// Start and end of the step, s.
    pub(super) span: (f64, f64),
    /// States at the start and at the end of the step.
    pub(super) ends: &'m [Vec<f64>; 2],
}

impl<M: Method<N>, const N: usize> Interpolant for LaneStep<'_, M, N> {
    type Real = f64;

    fn span(&self) -> (f64, f64) {
        self.span
    }

    fn ends(&self) -> (&[f64], &[f64]) {
        (&self.ends[0], &self.ends[1])
    }

    fn inside(&self, theta: f64, put: impl FnMut(usize, f64)) {
        let h = self.span.1 - self.span.0;
        self.method.inside(self.lane, theta * h, h, put);
    }

    fn order_inside(&self) -> Option<usize> {
        Some(self.method.degree())
    }

    fn coefficients(&self, put: impl FnMut(usize, usize, f64)) {
        self.method.coefficients(self.lane, self.span.1 - self.span.0, put);
    }
}

/// Numbers of `a` in the lanes whose bits in `mask` are all set, those of `b` in the other lanes.
#[inline(always)]
pub(super) fn chosen<const N: usize>(mask: [u64; N], a: Lanes<N>, b: Lanes<N>) -> Lanes<N> {
    Lanes(std::array::from_fn(|l| f64::from_bits(a.0[l].to_bits() & mask[l] | b.0[l].to_bits() & !mask[l])))
}

/// Mask of the marked lanes: all bits are set in these, none in the other lanes.
pub(super) fn mask<const N: usize>(marked: [bool; N]) -> [u64; N] {
    marked.map(|marked| if marked { u64::MAX } else { 0 })
}

/// Makes a lane of `odd` not a number if that of `x` is not finite: 0 · x is then not a number, else 0.
#[inline(always)]
pub(super) fn note<const N: usize>(odd: &mut Lanes<N>, x: Lanes<N>) {
    *odd = x.mul_add(Lanes([0.0; N]), *odd);
}
