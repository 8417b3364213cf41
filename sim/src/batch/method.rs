//! Interface of a method that takes a step in every lane at once, for the queue.
//!
//! Invariant: what a lane computes depends on nothing in another.

#![allow(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]

use tripos_traits::{Lanes, Scalar};

use crate::stepper::Interpolant;
use crate::tolerance::ErrorTest;

/// Result of an attempted step in each lane.
pub(super) struct Attempt<const N: usize> {
    /// The error in the norm of the test; meaningless where the step has no result.
    pub(super) error: [f64; N],
    /// True if all points of the step and the new state are finite.
    pub(super) finite: [bool; N],
    /// True if the derivative at the new state is finite.
    pub(super) finite_end: [bool; N],
    /// Evaluations that were made for each lane.
    pub(super) evaluations: [u64; N],
}

/// A method in `N` lanes. Each lane has its own step size and its own error.
pub(super) trait Method<const N: usize> {
    /// The length of the parameters.
    fn parameters(&self) -> usize;
    /// The length of the state.
    fn states(&self) -> usize;

    /// Writes the derivative at `y`, for parameters `p`, to `f`.
    fn rates(&self, p: &[Lanes<N>], y: &[Lanes<N>], f: &mut [Lanes<N>]);
    /// Initial rows of the lanes at `y`, for parameters `p`: each as long as the state. The first row is the state and
    /// the second its derivative.
    fn begin(&mut self, p: &[Lanes<N>], y: &[Lanes<N>]) -> Vec<Lanes<N>>;
    /// Puts a trajectory into a lane: its parameters, and its rows from [`Method::begin`].
    fn load(&mut self, lane: usize, parameters: &[f64], begun: &[f64]);

    /// The sizes of the next steps where the method knows them before they are tried, in s.
    fn proposals(&mut self, test: &ErrorTest) -> Option<[f64; N]> {
        let _ = test;
        None
    }
    /// Tries a step of signed size `h`, in s, in every lane.
    fn attempt(&mut self, h: [f64; N], test: &ErrorTest) -> Attempt<N>;
    /// The component, from 0, of the first number that is not finite when a lane tries this step again.
    fn first_not_finite(&mut self, lane: usize, h: [f64; N], test: &ErrorTest) -> usize;
    /// Lets the marked lanes go on from the end of the step last tried, the others from its start.
    fn accept(&mut self, accepted: [bool; N]);
    /// The state of a lane.
    fn state(&self, lane: usize) -> Vec<f64>;

    /// Evaluates the stages that only the solution inside the steps last tried, of sizes `h`, needs.
    fn prepare_inside(&mut self, h: [f64; N]) {
        let _ = h;
    }
    /// Evaluations that [`Method::prepare_inside`] makes for each lane.
    const INSIDE: u64 = 0;
    /// The states at the start and at the end of the step last tried in a lane, before it is accepted.
    fn ends(&self, lane: usize, out: &mut [Vec<f64>; 2]);
    /// The degree of the solution inside a step.
    fn degree(&self) -> usize;
    /// Hands `put` each component of the solution inside the step of a lane `after` so many seconds of its `h`.
    fn inside(&self, lane: usize, after: f64, h: f64, put: impl FnMut(usize, f64));
    /// Hands `put` the component, the power of the fraction of the step and its coefficient, as
    /// [`Interpolant::coefficients`] does.
    fn coefficients(&self, lane: usize, h: f64, put: impl FnMut(usize, usize, f64));
}

/// Step last tried in one lane, for the watcher of a trajectory.
pub(super) struct LaneStep<'m, M, const N: usize> {
    pub(super) method: &'m M,
    pub(super) lane: usize,
    /// Start and end, in s.
    pub(super) span: (f64, f64),
    /// The states there.
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

/// `a` in the lanes whose bits are all set, `b` in those that have none.
#[inline(always)]
pub(super) fn chosen<const N: usize>(mask: [u64; N], a: Lanes<N>, b: Lanes<N>) -> Lanes<N> {
    Lanes(std::array::from_fn(|l| f64::from_bits(a.0[l].to_bits() & mask[l] | b.0[l].to_bits() & !mask[l])))
}

/// All bits in the marked lanes, none in the others.
pub(super) fn mask<const N: usize>(marked: [bool; N]) -> [u64; N] {
    marked.map(|marked| if marked { u64::MAX } else { 0 })
}

/// Makes a lane of `odd` not a number if that of `x` is not finite: 0 x is 0, or else not a number.
#[inline(always)]
pub(super) fn note<const N: usize>(odd: &mut Lanes<N>, x: Lanes<N>) {
    *odd = x.mul_add(Lanes([0.0; N]), *odd);
}
