//! Step of DOP853 in all lanes of a vector register at once. Each lane has its own trajectory, step size and error.
//!
//! The formulae, coefficients and errors are those of [`crate::methods::dop853`], in the same order of operations. A
//! lane therefore takes the steps that a single run takes, up to rounding. Invariant: the numbers of a lane depend on
//! no other lane.

#![allow(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]

use tripos_traits::{Lanes, Lengths, Rates, Scalar};

use super::lane_method::{Attempt, LaneMethod, lane_mask, mark_not_finite_lanes, select_lanes};
use crate::error_test::ErrorTest;
use crate::methods::dop853::{END, STAGES, USED, USED_BY_ERROR, dop853_error};
use crate::methods::dop853_dense_output::{dense_output_powers, dense_output_value};
use crate::methods::dormand_prince_853::{DORMAND_PRINCE_853 as PUBLISHED, Row};

/// Coefficients aᵢⱼ of the stages of DOP853, row by row; 0 where the published row has no entry.
const A: [[f64; STAGES]; STAGES] = {
    let mut a = [[0.0; STAGES]; STAGES];
    let mut i = 0;
    while i < STAGES {
        a[i] = lane_row_with_zeros(PUBLISHED.a[i]);
        i += 1;
    }
    a
};
/// Weights of the stages in the last four coefficients of the dense output of DOP853.
const DENSE: [[f64; STAGES]; 4] = [
    lane_row_with_zeros(PUBLISHED.dense[0]),
    lane_row_with_zeros(PUBLISHED.dense[1]),
    lane_row_with_zeros(PUBLISHED.dense[2]),
    lane_row_with_zeros(PUBLISHED.dense[3]),
];
/// Weights of the stages in the error estimate of DOP853 against a solution of order 5.
const ERROR5: [f64; STAGES] = lane_row_with_zeros(PUBLISHED.error5);
/// Weights of the stages in the solution of order 3, with which DOP853 estimates its error.
const ERROR3: [f64; STAGES] = lane_row_with_zeros(PUBLISHED.error3);
/// Marks the stages of DOP853 with a nonzero weight in the solution of order 3, which serves the error estimate.
const USED_BY_ERROR3: [bool; STAGES] = {
    let mut used = [false; STAGES];
    let mut entry = 0;
    while entry < PUBLISHED.error3.len() {
        used[PUBLISHED.error3[entry].0] = true;
        entry += 1;
    }
    used
};

/// Expands the nonzero entries of a published row of coefficients to a row with an entry for each stage.
const fn lane_row_with_zeros(row: Row) -> [f64; STAGES] {
    let mut values = [0.0; STAGES];
    let mut entry = 0;
    while entry < row.len() {
        values[row[entry].0] = row[entry].1.value;
        entry += 1;
    }
    values
}

/// Derivatives of a single component of the state at all stages, in all lanes.
type Stages<const N: usize> = [Lanes<N>; STAGES];

/// Method DOP853 in N lanes: the states of all lanes, and the stages of a step.
pub(super) struct Dop853<'a, const N: usize> {
    /// Equations of motion, evaluated in N lanes at once.
    equations: &'a (dyn Rates<Lanes<N>> + Sync),
    /// Number of generalized coordinates at the head of the state.
    coordinates: usize,
    /// Parameters of the trajectory in each lane.
    parameters: Vec<Lanes<N>>,
    /// States of the trajectories in all lanes at the start of the step.
    y: Vec<Lanes<N>>,
    /// States at which the next stage is evaluated; after the last stage, the states at the end of the step.
    y_new: Vec<Lanes<N>>,
    /// Derivatives of the states in all lanes at the last evaluation of the equations.
    f: Vec<Lanes<N>>,
    /// Derivatives at `y`, which are stage 0 of the next step.
    slope: Vec<Lanes<N>>,
    /// Derivatives of all stages, for each component of the state.
    k: Vec<Stages<N>>,
    /// Partial sums over the known stages, for each component of the state. Before the last stage, entry 0 is for the
    /// next state to evaluate. At the last stage, the three entries are for the new state and its error estimates of
    /// order 5 and 3.
    before: Vec<[Lanes<N>; 3]>,
    /// Mask of the lanes whose last step was accepted but is not copied to `y` yet. All bits of such a lane are set;
    /// the bits of other lanes are 0.
    accepted: [u64; N],
    /// Error estimates of order 5 and 3, divided by the weights of the error test. They are stored in memory, because
    /// the compiler vectorizes loops that end in stores.
    quotients: Vec<[Lanes<N>; 2]>,
    /// States inside the step at which a stage of the dense output is evaluated.
    inner: Vec<Lanes<N>>,
    /// Derivatives at the states `inner`, which serve the dense output.
    slope_inside: Vec<Lanes<N>>,
    /// Eight coefficients of the dense output, for each component of the state.
    dense: Vec<[Lanes<N>; 8]>,
}

impl<'a, const N: usize> Dop853<'a, N> {
    /// Creates DOP853 for these equations, with lanes that have no trajectory yet.
    pub(super) fn new(equations: &'a (dyn Rates<Lanes<N>> + Sync)) -> Self {
        let Lengths { parameters, coordinates, variables: speeds, .. } = equations.lengths();
        let zero = Lanes([0.0; N]);
        let zeros = || vec![zero; coordinates + speeds];
        Self {
            equations,
            coordinates,
            parameters: vec![zero; parameters],
            y: zeros(),
            y_new: zeros(),
            f: zeros(),
            slope: zeros(),
            k: vec![[zero; STAGES]; coordinates + speeds],
            before: vec![[zero; 3]; coordinates + speeds],
            accepted: [0; N],
            quotients: vec![[zero; 2]; coordinates + speeds],
            inner: zeros(),
            slope_inside: zeros(),
            dense: vec![[zero; 8]; coordinates + speeds],
        }
    }

    /// Evaluates the derivatives at `y_new` and writes them to `f`.
    #[inline(always)]
    fn evaluate(&mut self) {
        let ((q, v), (q_dot, v_dot)) = (self.y_new.split_at(self.coordinates), self.f.split_at_mut(self.coordinates));
        self.equations.rates(&self.parameters, q, v, q_dot, v_dot);
    }

    /// Computes stages 1 to 11 of steps of signed sizes `h`, s. Leaves the derivative of the last stage in `f`. Sets a
    /// lane of `odd` to NaN if a state in that lane is not finite.
    ///
    /// `look` is called before each evaluation with the last derivatives and the next states.
    #[inline(always)]
    fn stages(&mut self, h: Lanes<N>, odd: &mut Lanes<N>, mut look: impl FnMut(&[Lanes<N>], &[Lanes<N>])) {
        self.first_stage_point(h, odd);
        look(&[], &self.y_new);
        self.evaluate();
        macro_rules! stages {
            ($($i:literal)*) => {
                $(
                    self.stage_point_in_lanes::<$i>(h, odd);
                    look(&self.f, &self.y_new);
                    self.evaluate();
                )*
            };
        }
        stages!(2 3 4 5 6 7 8 9 10 11);
    }

    /// Copies the accepted steps to `y`, and writes the states of stage 1 of the next steps to `y_new`. `h` are the
    /// signed sizes of these steps, s.
    #[inline(always)]
    fn first_stage_point(&mut self, h: Lanes<N>, odd: &mut Lanes<N>) {
        let first = h * Lanes::from_f64(A[1][0]);
        let states = self.y_new.iter_mut().zip(&mut self.y).zip(self.slope.iter_mut().zip(&self.f));
        for (((next, y), (slope, f)), (k, before)) in states.zip(self.k.iter_mut().zip(&mut self.before)) {
            *y = select_lanes(self.accepted, *next, *y);
            *slope = select_lanes(self.accepted, *f, *slope);
            *next = first.mul_add(*slope, *y);
            mark_not_finite_lanes(odd, *next);
            k[0] = *slope;
            before[0] = h.mul_add(combine_stages_in_lanes(&A[2], &USED[2], k, 1), *y);
        }
        self.accepted = [0; N];
    }

    /// Writes the states y + h Σⱼ aᵢⱼ kⱼ of stage I to `y_new`. Copies stage I − 1 from `f` to its place in `k`.
    ///
    /// All terms except the last were summed before stage I − 1 was evaluated. The terms of the next stage are summed
    /// here, too: the processor works on them while it waits for the evaluation of this stage.
    #[inline(always)]
    fn stage_point_in_lanes<const I: usize>(&mut self, h: Lanes<N>, odd: &mut Lanes<N>) {
        let last = h * Lanes::from_f64(A[I][I - 1]);
        let points = self.y_new.iter_mut().zip(&self.y).zip(&self.f);
        for (((next, y), f), (k, before)) in points.zip(self.k.iter_mut().zip(&mut self.before)) {
            *next = last.mul_add(*f, before[0]);
            mark_not_finite_lanes(odd, *next);
            k[I - 1] = *f;
            if I + 1 < END {
                before[0] = h.mul_add(combine_stages_in_lanes(&A[I + 1], &USED[I + 1], k, I), *y);
            } else {
                before[0] = combine_stages_in_lanes(&A[END], &USED[END], k, I);
                before[1] = combine_stages_in_lanes(&ERROR5, &USED_BY_ERROR, k, I);
                before[2] = combine_stages_in_lanes(&ERROR3, &USED_BY_ERROR3, k, I);
            }
        }
    }

    /// Computes the coefficients of the dense output of steps of signed sizes `h`, s.
    #[inline(always)]
    fn stages_inside(&mut self, h: Lanes<N>) {
        for (k, f) in self.k.iter_mut().zip(&self.f) {
            k[END] = *f;
        }
        self.inner_stage::<13>(h);
        self.inner_stage::<14>(h);
        self.inner_stage::<15>(h);
        let states = self.y.iter().zip(&self.y_new);
        for ((r, k), (y, y_new)) in self.dense.iter_mut().zip(&self.k).zip(states) {
            let rise = *y_new - *y;
            let bend = h * k[0] - rise;
            (r[0], r[1], r[2], r[3]) = (*y, rise, bend, rise - h * k[END] - bend);
            for (r, d) in r[4..].iter_mut().zip(&DENSE) {
                let term = h * combine_stages_in_lanes(d, &[true; STAGES], k, STAGES);
                // If a point inside the step has no value, the solution inside the step is of order 3.
                *r = Lanes(term.0.map(|x| if x.is_finite() { x } else { 0.0 }));
            }
        }
    }

    /// Computes stage I of steps of signed sizes `h`, s. Only the dense output needs this stage.
    #[inline(always)]
    fn inner_stage<const I: usize>(&mut self, h: Lanes<N>) {
        for ((inner, y), k) in self.inner.iter_mut().zip(&self.y).zip(&self.k) {
            *inner = h.mul_add(combine_stages_in_lanes(&A[I], &USED[I], k, I), *y);
        }
        let (q, v) = self.inner.split_at(self.coordinates);
        let (q_dot, v_dot) = self.slope_inside.split_at_mut(self.coordinates);
        self.equations.rates(&self.parameters, q, v, q_dot, v_dot);
        for (k, f) in self.k.iter_mut().zip(&self.slope_inside) {
            k[I] = *f;
        }
    }

    /// Writes the new states to `y_new`, and returns the error of each lane in the norm of the error test. Sets a lane
    /// of `odd` to NaN if the state in that lane is not finite.
    #[inline(always)]
    fn new_state_and_error(&mut self, h: Lanes<N>, test: &ErrorTest, odd: &mut Lanes<N>) -> [f64; N] {
        let zero = Lanes([0.0; N]);
        let (mut sum5, mut sum3) = (zero, zero);
        let n = self.y.len();
        let points = self.y_new.iter_mut().zip(&self.y).zip(test.absolute_weights());
        let last = [A[END], ERROR5, ERROR3].map(|row| Lanes::from_f64(row[END - 1]));
        let stages = self.k.iter_mut().zip(&self.before).zip(&self.f);
        for ((((next, y), absolute), ((k, before), f)), quotients) in points.zip(stages).zip(&mut self.quotients) {
            k[END - 1] = *f;
            let eighth = last[0].mul_add(*f, before[0]);
            let fifth = last[1].mul_add(*f, before[1]);
            let third = eighth - last[2].mul_add(*f, before[2]);
            *next = h.mul_add(eighth, *y);
            mark_not_finite_lanes(odd, *next);
            let inverse = Lanes(test.inverse_weights(&[*absolute; N], &y.0, &next.0));
            *quotients = [fifth * inverse, third * inverse];
        }
        for [fifth, third] in &self.quotients {
            sum5 = fifth.mul_add(*fifth, sum5);
            sum3 = third.mul_add(*third, sum3);
        }
        std::array::from_fn(|l| dop853_error(h.0[l], sum5.0[l], sum3.0[l], n))
    }
}

impl<const N: usize> LaneMethod<N> for Dop853<'_, N> {
    const INSIDE: u64 = 3;

    fn parameters(&self) -> usize {
        self.parameters.len()
    }

    fn states(&self) -> usize {
        self.y.len()
    }

    fn rates(&self, p: &[Lanes<N>], y: &[Lanes<N>], f: &mut [Lanes<N>]) {
        let ((q, v), (q_dot, v_dot)) = (y.split_at(self.coordinates), f.split_at_mut(self.coordinates));
        self.equations.rates(p, q, v, q_dot, v_dot);
    }

    fn initial_rows(&mut self, p: &[Lanes<N>], y: &[Lanes<N>]) -> Vec<Lanes<N>> {
        let mut rows = y.repeat(2);
        self.rates(p, y, &mut rows[y.len()..]);
        rows
    }

    fn load(&mut self, lane: usize, parameters: &[f64], begun: &[f64]) {
        let places = self.parameters.iter_mut().chain(&mut self.y).chain(&mut self.slope);
        for (to, from) in places.zip(parameters.iter().chain(begun)) {
            to.0[lane] = *from;
        }
        self.accepted[lane] = 0;
    }

    fn attempt(&mut self, h: [f64; N], test: &ErrorTest) -> Attempt<N> {
        let h = Lanes(h);
        let (error, odd, odd_end) = Lanes::<N>::dispatch(
            #[inline(always)]
            || {
                let mut odd = Lanes([0.0; N]);
                self.stages(h, &mut odd, |_, _| {});
                let error = self.new_state_and_error(h, test, &mut odd);
                self.evaluate();
                let mut odd_end = Lanes([0.0; N]);
                for f in &self.f {
                    mark_not_finite_lanes(&mut odd_end, *f);
                }
                (error, odd, odd_end)
            },
        );
        let [finite, finite_end] = [odd, odd_end].map(|odd| odd.0.map(|x| !x.is_nan()));
        // A single run does not evaluate the right-hand side at the end of a rejected step.
        let passed = |l: usize| finite[l] && error[l] <= test.tolerance;
        let evaluations = std::array::from_fn(|l| END as u64 - u64::from(!passed(l)));
        Attempt { error, finite, finite_end, evaluations }
    }

    #[cold]
    fn first_not_finite(&mut self, lane: usize, h: [f64; N], test: &ErrorTest) -> usize {
        let mut found = None;
        let of = |values: &[Lanes<N>]| values.iter().position(|x| !x.0[lane].is_finite());
        let h = Lanes(h);
        self.stages(h, &mut Lanes([0.0; N]), |before, point| {
            found = found.or_else(|| of(before)).or_else(|| of(point));
        });
        found = found.or_else(|| of(&self.f));
        self.new_state_and_error(h, test, &mut Lanes([0.0; N]));
        found = found.or_else(|| of(&self.y_new));
        self.evaluate();
        found.or_else(|| of(&self.f)).unwrap_or(0)
    }

    fn accept(&mut self, accepted: [bool; N]) {
        self.accepted = lane_mask(accepted);
    }

    fn state(&self, lane: usize) -> Vec<f64> {
        let y = if self.accepted[lane] == 0 { &self.y } else { &self.y_new };
        y.iter().map(|y| y.0[lane]).collect()
    }

    fn prepare_inside(&mut self, h: [f64; N]) {
        Lanes::<N>::dispatch(
            #[inline(always)]
            || self.stages_inside(Lanes(h)),
        );
    }

    fn ends(&self, lane: usize, out: &mut [Vec<f64>; 2]) {
        for (out, y) in out.iter_mut().zip([&self.y, &self.y_new]) {
            out.clear();
            out.extend(y.iter().map(|y| y.0[lane]));
        }
    }

    fn degree(&self) -> usize {
        7
    }

    fn inside(&self, lane: usize, after: f64, h: f64, mut put: impl FnMut(usize, f64)) {
        for (i, r) in self.dense.iter().enumerate() {
            put(i, dense_output_value(r.map(|r| r.0[lane]), after / h));
        }
    }

    fn coefficients(&self, lane: usize, _h: f64, mut put: impl FnMut(usize, usize, f64)) {
        for (i, r) in self.dense.iter().enumerate() {
            for (power, value) in dense_output_powers(r.map(|r| r.0[lane])).into_iter().enumerate() {
                put(i, power, value);
            }
        }
    }
}

/// Sum Σⱼ aⱼ kⱼ for a component of the state in all lanes, over stage 0 and the used stages before
/// `end`.
#[inline(always)]
fn combine_stages_in_lanes<const N: usize>(
    a: &[f64; STAGES],
    used: &[bool; STAGES],
    k: &Stages<N>,
    end: usize,
) -> Lanes<N> {
    let mut sum = Lanes::from_f64(a[0]) * k[0];
    for j in 1..end {
        if used[j] {
            sum = Lanes::from_f64(a[j]).mul_add(k[j], sum);
        }
    }
    sum
}
