//! Step of Taylor's method in all lanes of a vector register at once. Each lane has its own trajectory, step size and
//! error.
//!
//! The order, the choice of steps, the errors and the compensated sums are those of [`crate::methods::taylor`]. A lane
//! therefore takes the steps that a single run takes, up to rounding.
//!
//! Invariant: row k of `x` has the Taylor coefficients of order k at the start of the step, and row k of `next` those
//! at its end. If the highest coefficients of a lane are not finite, they are set to zero. `usable` of the lane is the
//! highest order below them.

#![allow(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]

use tripos_traits::{Lanes, Lengths, Rates, Scalar, Series};

use super::lane_method::{Attempt, LaneMethod, lane_mask, mark_not_finite_lanes, select_lanes};
use crate::error_test::ErrorTest;
use crate::methods::taylor::{ALLOWED_JUMP, proposed_taylor_step_size, taylor_step_power};

/// Equations of motion in N lanes, for Taylor's method: rates and Taylor coefficients.
#[derive(Clone, Copy)]
pub(super) struct Equations<'a, const N: usize> {
    /// Function that gives the rates of the state (q, v) in N lanes.
    pub(super) rates: &'a (dyn Rates<Lanes<N>> + Sync),
    /// Function that gives the Taylor coefficients of the motion in N lanes.
    pub(super) series: &'a (dyn Series<Lanes<N>> + Sync),
}

/// Taylor's method in N lanes: the Taylor coefficients of all lanes at both ends of a step.
pub(super) struct Taylor<'a, const N: usize> {
    /// Equations of motion, evaluated in N lanes at once.
    equations: Equations<'a, N>,
    /// Numbers of coordinates, speeds and parameters of the equations.
    lengths: Lengths,
    /// Order of the Taylor polynomials.
    order: usize,
    /// Parameters of the trajectory in each lane.
    parameters: Vec<Lanes<N>>,
    /// Taylor coefficients at the start of the step, (order + 1) × n entries: row k has those of order k.
    x: Vec<Lanes<N>>,
    /// Highest order, in each lane, up to which all coefficients in `x` are finite.
    usable: [usize; N],
    /// Taylor coefficients at the end of the last tried step, (order + 1) × n entries.
    next: Vec<Lanes<N>>,
    /// Highest order, in each lane, up to which all coefficients in `next` are finite.
    next_usable: [usize; N],
    /// Rounding errors of the states at the start of the step. The next sum adds them (compensated summation).
    carry: Vec<Lanes<N>>,
    /// Rounding errors of the states at the end of the step, for the sum of the next step (compensated
    /// summation).
    carry_new: Vec<Lanes<N>>,
    /// Norms of the Taylor coefficients of the last two usable orders in each lane, divided by the weights of the error
    /// test.
    norms: [[f64; 2]; N],
    /// Working space for the recurrences of the Taylor coefficients.
    work: Vec<Lanes<N>>,
}

impl<'a, const N: usize> Taylor<'a, N> {
    /// Creates Taylor's method of this order for these equations, with empty lanes.
    pub(super) fn new(equations: Equations<'a, N>, order: usize) -> Self {
        let lengths = equations.rates.lengths();
        let zeros = |n: usize| vec![Lanes([0.0; N]); n];
        let n = lengths.state();
        Self {
            lengths,
            order,
            parameters: zeros(lengths.parameters),
            x: zeros((order + 1) * n),
            usable: [order; N],
            next: zeros((order + 1) * n),
            next_usable: [order; N],
            carry: zeros(n),
            carry_new: zeros(n),
            norms: [[0.0; 2]; N],
            work: zeros(equations.series.taylor_work(order)),
            equations,
        }
    }

    /// Writes the states y + Σ x_k hᵏ at the end of steps of signed sizes `h`, s, to `next`, and their rounding errors
    /// to `carry_new`. Sets a lane of `odd` to NaN if the state in that lane is not finite.
    #[inline(always)]
    fn advance(&mut self, h: Lanes<N>, odd: &mut Lanes<N>) {
        let n = self.lengths.state();
        let square = h * h;
        for i in 0..n {
            let sum = polynomial(&self.x[i..], n, self.order, h, square);
            let add = h.mul_add(sum, self.carry[i]);
            let start = self.x[i];
            let new = start + add;
            let added = new - start;
            self.carry_new[i] = (start - (new - added)) + (add - added);
            self.next[i] = new;
            mark_not_finite_lanes(odd, new);
        }
    }

    /// Computes the Taylor coefficients at the end of the step from the states in the first row of `next`. Sets a lane
    /// of `odd` to NaN if the derivative in that lane is not finite.
    fn expand(&mut self, odd: &mut Lanes<N>) {
        self.equations.series.taylor(&self.parameters, self.order, &mut self.next, &mut self.work);
        let n = self.lengths.state();
        let mut odd_last = Lanes([0.0; N]);
        Lanes::<N>::dispatch(
            #[inline(always)]
            || {
                self.next[self.order * n..].iter().for_each(|x| mark_not_finite_lanes(&mut odd_last, *x));
                self.next[n..2 * n].iter().for_each(|x| mark_not_finite_lanes(odd, *x));
            },
        );
        self.next_usable = [self.order; N];
        for lane in 0..N {
            if odd_last.0[lane].is_nan() {
                self.next_usable[lane] = cut_series_at_finite_order(&mut self.next, n, self.order, lane);
            }
        }
    }

    /// Computes, in each lane, the jump of the derivative between the tried step and the next: the difference of the
    /// derivatives of both Taylor polynomials. The signed step sizes `h`, s, scale the jump to an error of the state,
    /// as in [`crate::methods::taylor`]. Returns the norms of the error test.
    #[inline(always)]
    fn jump(&self, test: &ErrorTest, h: Lanes<N>) -> [f64; N] {
        let n = self.lengths.state();
        let mut norm = Lanes([0.0; N]);
        let mut odd = Lanes([0.0; N]);
        let share = Lanes(std::array::from_fn(|l| h.0[l] / (self.usable[l] + 1) as f64));
        for (i, absolute) in test.absolute_weights().iter().take(n).enumerate() {
            let mut sum = Lanes([0.0; N]);
            for k in (1..=self.order).rev() {
                sum = sum.mul_add(h, Lanes::from_f64(k as f64) * self.x[k * n + i]);
            }
            let error = (sum - self.next[n + i]) * share;
            mark_not_finite_lanes(&mut odd, error);
            let magnitude = self.x[i].abs().larger_or_second(self.next[i].abs());
            // An error of exactly 0 counts as 0 even if its weight is 0: the quotient is NaN then, and is ignored.
            norm = (error.abs() / test.weight_in_lanes(*absolute, magnitude)).larger_or_second(norm);
        }
        std::array::from_fn(|l| if odd.0[l].is_nan() { f64::NAN } else { norm.0[l] })
    }

    /// Computes, in each lane, the norms of the Taylor coefficients of the last two usable orders, divided by the
    /// weights of the error test.
    #[inline(always)]
    fn norms_of_last_orders(&self, test: &ErrorTest) -> [[f64; 2]; N] {
        let n = self.lengths.state();
        let mut norms = [Lanes([0.0; N]); 2];
        let is_whole = self.usable == [self.order; N];
        for (i, absolute) in test.absolute_weights().iter().take(n).enumerate() {
            let row = |below: usize| {
                let whole = self.x[(self.order - below) * n + i];
                let own = |l: usize| self.x[(self.usable[l] - below) * n + i].0[l];
                if is_whole { whole } else { Lanes(std::array::from_fn(own)) }
            };
            let (y, before, last) = (self.x[i], row(1), row(0));
            // A component with the weight 0 is left out here. The error test of the step itself detects a too large
            // error.
            let weight = test.weight_in_lanes(*absolute, y.abs());
            let inverse = Lanes(weight.0.map(|weight| if weight > 0.0 { 1.0 / weight } else { 0.0 }));
            norms[0] = (before.abs() * inverse).larger_or_second(norms[0]);
            norms[1] = (last.abs() * inverse).larger_or_second(norms[1]);
        }
        std::array::from_fn(|l| norms.map(|norm| norm.0[l]))
    }
}

/// Sum Σ x_k h^(k−1) over 1 ≤ k ≤ `order` for a component, whose coefficients are every n-th entry of `x`. `square` is
/// h². Even and odd orders are summed separately, so that neither sum waits for the other.
#[inline(always)]
fn polynomial<const N: usize>(x: &[Lanes<N>], n: usize, order: usize, h: Lanes<N>, square: Lanes<N>) -> Lanes<N> {
    let (mut odd, mut even) = (Lanes([0.0; N]), Lanes([0.0; N]));
    let mut k = order;
    if k % 2 == 1 {
        odd = x[k * n];
        k -= 1;
    }
    while k > 0 {
        even = even.mul_add(square, x[k * n]);
        odd = odd.mul_add(square, x[(k - 1) * n]);
        k -= 2;
    }
    even.mul_add(h, odd)
}

/// Sets to zero all coefficients of a lane above the highest order up to which all are finite. Returns this order, at
/// least 1.
#[cold]
fn cut_series_at_finite_order<const N: usize>(x: &mut [Lanes<N>], n: usize, order: usize, lane: usize) -> usize {
    let finite = |k: usize| x[k * n..(k + 1) * n].iter().all(|x| x.0[lane].is_finite());
    let usable = (2..=order).rev().find(|k| finite(*k)).unwrap_or(1);
    for x in &mut x[(usable + 1) * n..] {
        x.0[lane] = 0.0;
    }
    usable
}

impl<const N: usize> LaneMethod<N> for Taylor<'_, N> {
    fn parameters(&self) -> usize {
        self.lengths.parameters
    }

    fn states(&self) -> usize {
        self.lengths.state()
    }

    fn rates(&self, p: &[Lanes<N>], y: &[Lanes<N>], f: &mut [Lanes<N>]) {
        let ((q, v), (q_dot, v_dot)) = (y.split_at(self.lengths.coordinates), f.split_at_mut(self.lengths.coordinates));
        self.equations.rates.rates(p, q, v, q_dot, v_dot);
    }

    fn initial_rows(&mut self, p: &[Lanes<N>], y: &[Lanes<N>]) -> Vec<Lanes<N>> {
        let mut rows = y.repeat(self.order + 1);
        self.equations.series.taylor(p, self.order, &mut rows, &mut self.work);
        rows
    }

    fn load(&mut self, lane: usize, parameters: &[f64], begun: &[f64]) {
        for (to, from) in self.parameters.iter_mut().chain(&mut self.x).zip(parameters.iter().chain(begun)) {
            to.0[lane] = *from;
        }
        for carry in &mut self.carry {
            carry.0[lane] = 0.0;
        }
        self.usable[lane] = cut_series_at_finite_order(&mut self.x, self.lengths.state(), self.order, lane);
    }

    fn proposals(&mut self, test: &ErrorTest) -> Option<[f64; N]> {
        self.norms = Lanes::<N>::dispatch(
            #[inline(always)]
            || self.norms_of_last_orders(test),
        );
        Some(std::array::from_fn(|l| proposed_taylor_step_size(self.norms[l], self.usable[l], test.tolerance)))
    }

    fn attempt(&mut self, h: [f64; N], test: &ErrorTest) -> Attempt<N> {
        let mut odd = Lanes([0.0; N]);
        Lanes::<N>::dispatch(
            #[inline(always)]
            || self.advance(Lanes(h), &mut odd),
        );
        let last_terms: [f64; N] = std::array::from_fn(|l| {
            let ([before, last], size) = (self.norms[l], h[l].abs());
            let power = taylor_step_power(size, self.usable[l] - 1);
            (before * power).max(last * (power * size))
        });
        let mut odd_end = Lanes([0.0; N]);
        self.expand(&mut odd_end);
        let jump = Lanes::<N>::dispatch(
            #[inline(always)]
            || self.jump(test, Lanes(h)),
        );
        // A single run computes no coefficients after a step whose last terms are too large.
        let passed: [bool; N] = std::array::from_fn(|l| !odd.0[l].is_nan() && last_terms[l] <= test.tolerance);
        let error = |l: usize| if passed[l] { last_terms[l].max(jump[l] / ALLOWED_JUMP) } else { last_terms[l] };
        Attempt {
            error: std::array::from_fn(error),
            finite: odd.0.map(|x| !x.is_nan()),
            finite_end: odd_end.0.map(|x| !x.is_nan()),
            evaluations: passed.map(u64::from),
        }
    }

    #[cold]
    fn first_not_finite(&mut self, lane: usize, h: [f64; N], _test: &ErrorTest) -> usize {
        self.advance(Lanes(h), &mut Lanes([0.0; N]));
        self.expand(&mut Lanes([0.0; N]));
        let n = self.lengths.state();
        self.next[..2 * n].iter().position(|x| !x.0[lane].is_finite()).map_or(0, |at| at % n)
    }

    fn accept(&mut self, accepted: [bool; N]) {
        if !accepted.iter().all(|accepted| *accepted) {
            let mask = lane_mask(accepted);
            let rows = self.next.iter_mut().zip(&self.x).chain(self.carry_new.iter_mut().zip(&self.carry));
            rows.for_each(|(next, x)| *next = select_lanes(mask, *next, *x));
            for (l, accepted) in accepted.into_iter().enumerate() {
                self.next_usable[l] = if accepted { self.next_usable[l] } else { self.usable[l] };
            }
        }
        self.usable = self.next_usable;
        std::mem::swap(&mut self.x, &mut self.next);
        std::mem::swap(&mut self.carry, &mut self.carry_new);
    }

    fn state(&self, lane: usize) -> Vec<f64> {
        self.x[..self.lengths.state()].iter().map(|x| x.0[lane]).collect()
    }

    fn ends(&self, lane: usize, out: &mut [Vec<f64>; 2]) {
        let n = self.lengths.state();
        for (out, y) in out.iter_mut().zip([&self.x, &self.next]) {
            out.clear();
            out.extend(y[..n].iter().map(|y| y.0[lane]));
        }
    }

    fn degree(&self) -> usize {
        self.order
    }

    fn inside(&self, lane: usize, after: f64, _h: f64, mut put: impl FnMut(usize, f64)) {
        let n = self.lengths.state();
        for i in 0..n {
            let terms = self.x[n + i..].iter().step_by(n).rev();
            let sum = terms.fold(0.0, |sum: f64, x| sum * after + x.0[lane]);
            put(i, self.x[i].0[lane] + (self.carry[i].0[lane] + after * sum));
        }
    }

    fn coefficients(&self, lane: usize, h: f64, mut put: impl FnMut(usize, usize, f64)) {
        let mut power = 1.0;
        for (k, row) in self.x.chunks_exact(self.lengths.state().max(1)).enumerate() {
            for (i, x) in row.iter().enumerate() {
                put(i, k, power * x.0[lane]);
            }
            power *= h;
        }
    }
}
