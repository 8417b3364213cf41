//! Interface of an integration method that takes a step in all lanes of a vector register at once. Each lane has its
//! own trajectory.
//!
//! Invariant: a lane computes the same numbers whatever the other lanes contain.

#![allow(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]

use tripos_traits::{Lanes, Scalar};

use crate::dense_output::Interpolant;
use crate::error_test::ErrorTest;

/// Result of an attempted step in each of N lanes.
pub(super) struct Attempt<const N: usize> {
    /// Error of each lane in the norm of the error test. It has no meaning if the lane's step has no finite
    /// result.
    pub(super) error: [f64; N],
    /// True for each lane in which all states of the step are finite.
    pub(super) finite: [bool; N],
    /// True for each lane in which the derivative at the end of the step is finite.
    pub(super) finite_end: [bool; N],
    /// Number of evaluations of the equations that the step made for each lane.
    pub(super) evaluations: [u64; N],
}

/// Method of integration in `N` lanes. Each lane has a trajectory, a step size and an error of its own.
pub(super) trait LaneMethod<const N: usize> {
    /// Number of parameters of the equations.
    fn parameters(&self) -> usize;
    /// Number of components of the state (q, v).
    fn states(&self) -> usize;

    /// Writes the derivatives of the states `y`, for parameters `p`, to `f`.
    fn rates(&self, p: &[Lanes<N>], y: &[Lanes<N>], f: &mut [Lanes<N>]);
    /// Initial rows of the lanes for the states `y` and parameters `p`. Each row is as long as the state:
    /// the first is the state, the second its derivative. For Taylor's method higher Taylor coefficients
    /// follow.
    fn initial_rows(&mut self, p: &[Lanes<N>], y: &[Lanes<N>]) -> Vec<Lanes<N>>;
    /// Starts a trajectory in a lane, from its parameters and its initial rows, which
    /// [`LaneMethod::initial_rows`] computes.
    fn load(&mut self, lane: usize, parameters: &[f64], begun: &[f64]);

    /// Sizes of the next steps of all lanes, s, for a method that knows them before it tries the steps. `None` for a
    /// method that needs step control.
    fn proposals(&mut self, test: &ErrorTest) -> Option<[f64; N]> {
        let _ = test;
        None
    }
    /// Tries a step of signed size `h`, s, in each lane.
    fn attempt(&mut self, h: [f64; N], test: &ErrorTest) -> Attempt<N>;
    /// Repeats the last step of a lane, of signed size `h`, s. Returns the index of the first component of the state
    /// that is not finite.
    fn first_not_finite(&mut self, lane: usize, h: [f64; N], test: &ErrorTest) -> usize;
    /// Ends the step: lanes marked true continue from its end, the other lanes repeat it from its start.
    fn accept(&mut self, accepted: [bool; N]);
    /// Current state (q, v) of a lane.
    fn state(&self, lane: usize) -> Vec<f64>;

    /// Evaluates the stages that only the dense output needs, for the last tried steps of signed sizes `h`, s.
    fn prepare_inside(&mut self, h: [f64; N]) {
        let _ = h;
    }
    /// Number of evaluations that [`LaneMethod::prepare_inside`] makes for each lane.
    const INSIDE: u64 = 0;
    /// Writes the states at the start and at the end of a lane's last tried step to `out`. The step is not accepted
    /// yet.
    fn ends(&self, lane: usize, out: &mut [Vec<f64>; 2]);
    /// Degree of the dense output as a polynomial in the fraction of the step.
    fn degree(&self) -> usize;
    /// Computes the state of a lane `after` seconds from the start of its last step, which is `h` seconds
    /// long. Calls `put(i, value)` for each component i.
    fn inside(&self, lane: usize, after: f64, h: f64, put: impl FnMut(usize, f64));
    /// Computes the coefficients of the dense output of a lane's last step, `h` s long, in powers of the
    /// fraction of the step. Calls `put(i, k, value)` for each component i and each power k, as
    /// [`Interpolant::coefficients`] does.
    fn coefficients(&self, lane: usize, h: f64, put: impl FnMut(usize, usize, f64));
}

/// Last tried step of a single lane, with its dense output, for the search of events.
pub(super) struct LaneStep<'m, M, const N: usize> {
    /// Method of integration in lanes that took the step.
    pub(super) method: &'m M,
    /// Index of the lane of the vector register in which the step was taken, from 0.
    pub(super) lane: usize,
    /// Start and end time of the step, s.
    pub(super) span: (f64, f64),
    /// States at the start and at the end of the step.
    pub(super) ends: &'m [Vec<f64>; 2],
}

impl<M: LaneMethod<N>, const N: usize> Interpolant for LaneStep<'_, M, N> {
    type Real = f64;

    fn span(&self) -> (f64, f64) {
        self.span
    }

    fn ends(&self) -> (&[f64], &[f64]) {
        (&self.ends[0], &self.ends[1])
    }

    fn dense_output(&self, theta: f64, put: impl FnMut(usize, f64)) {
        let h = self.span.1 - self.span.0;
        self.method.inside(self.lane, theta * h, h, put);
    }

    fn degree_of_dense_output(&self) -> Option<usize> {
        Some(self.method.degree())
    }

    fn coefficients(&self, put: impl FnMut(usize, usize, f64)) {
        self.method.coefficients(self.lane, self.span.1 - self.span.0, put);
    }
}

/// Combines two vectors lane by lane. A lane of the result is taken from `a` if all bits of that lane in `mask` are
/// set, else from `b`.
#[inline(always)]
pub(super) fn select_lanes<const N: usize>(mask: [u64; N], a: Lanes<N>, b: Lanes<N>) -> Lanes<N> {
    Lanes(std::array::from_fn(|l| f64::from_bits(a.0[l].to_bits() & mask[l] | b.0[l].to_bits() & !mask[l])))
}

/// Bit mask of the lanes that are marked true: all bits of such a lane are set, the bits of other lanes are 0.
pub(super) fn lane_mask<const N: usize>(marked: [bool; N]) -> [u64; N] {
    marked.map(|marked| if marked { u64::MAX } else { 0 })
}

/// Sets a lane of `odd` to NaN if that lane of `x` is not finite. Adds 0 · x, which is 0 for finite x and NaN
/// otherwise.
#[inline(always)]
pub(super) fn mark_not_finite_lanes<const N: usize>(odd: &mut Lanes<N>, x: Lanes<N>) {
    *odd = x.mul_add(Lanes([0.0; N]), *odd);
}
