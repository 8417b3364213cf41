//! Steps of the method DOP853: Dormand–Prince 8(5,3) with a dense output of order 7.
//!
//! Invariant: `k[b][0]` is block b of the derivative at (t, y). After a trial step that passed its error test,
//! `k[b][12]` is the derivative at its end. If the driver may move the state there, this derivative is computed only
//! when the dense output needs it.
//!
//! A step allocates nothing. The formulae are those of E. Hairer, S. P. Nørsett & G. Wanner, *Solving Ordinary
//! Differential Equations I* (1993), §II.5 (error) and §II.6 (dense output).

use std::array::from_fn;

use tripos_traits::Real;

use super::dop853_dense_output::{dense_output_powers, dense_output_value};
use super::dormand_prince_853::{DORMAND_PRINCE_853 as PUBLISHED, Row};
use crate::blocks::{Block, Blocks, FiniteTest, LANES};
use crate::dense_output::Interpolant;
use crate::error_test::ErrorTest;
use crate::right_hand_side::RightHandSide;
use crate::stepper::{StepFailure, Stepper, TrialStep, check_finite};

/// Number of stages of DOP853: 12 of the step, one at the end of the step, and three that only the dense output needs.
pub(crate) const STAGES: usize = 16;
/// Index of the row of coefficients that gives the new state, and of the stage that is evaluated at this state.
pub(crate) const END: usize = 12;

/// Marks the stages j that row i of the coefficients uses. The table is known at compile time, so that unused stages
/// cost nothing.
pub(crate) const USED: [[bool; STAGES]; STAGES] = {
    let mut used = [[false; STAGES]; STAGES];
    let mut i = 0;
    while i < STAGES {
        used[i] = dop853_stages_used_by(PUBLISHED.a[i]);
        i += 1;
    }
    used
};
/// Marks the stages that the order-5 error estimate of DOP853 uses.
pub(crate) const USED_BY_ERROR: [bool; STAGES] = dop853_stages_used_by(PUBLISHED.error5);

/// Marks the stages that a row of coefficients of DOP853 uses.
const fn dop853_stages_used_by(row: Row) -> [bool; STAGES] {
    let mut used = [false; STAGES];
    let mut entry = 0;
    while entry < row.len() {
        used[row[entry].0] = true;
        entry += 1;
    }
    used
}

/// Same number twice, as an operand for a vector register of two numbers. No instruction has to copy it.
type TwoCopies<S> = [S; 2];

/// Published coefficients of DOP853 in the scalar of the run.
struct Coefficients<S> {
    /// Coefficients aᵢⱼ of the stages, each written twice for vector registers.
    a: [[TwoCopies<S>; STAGES]; STAGES],
    /// Weights of the stages in the error estimate of DOP853 against a solution of order 5.
    error5: [TwoCopies<S>; STAGES],
    /// Weights of the stages in the solution of order 3, which serves the error estimate of DOP853.
    error3: [TwoCopies<S>; STAGES],
    /// Weights of the stages in the last four coefficients of the dense output of DOP853.
    dense: [[TwoCopies<S>; STAGES]; 4],
}

impl<S: Real> Coefficients<S> {
    /// Rounds the published coefficients to the scalar `S`.
    fn new() -> Self {
        Self {
            a: PUBLISHED.a.map(coefficient_row),
            error5: coefficient_row(PUBLISHED.error5),
            error3: coefficient_row(PUBLISHED.error3),
            dense: PUBLISHED.dense.map(coefficient_row),
        }
    }
}

/// Expands the nonzero entries of a published row of coefficients to a row with an entry for each stage.
fn coefficient_row<S: Real>(entries: Row) -> [TwoCopies<S>; STAGES] {
    let mut values = [[S::from_f64(0.0); 2]; STAGES];
    for (stage, decimal) in entries {
        values[*stage] = [decimal.to(); 2];
    }
    values
}

/// Method DOP853 of a run: the current step with its stages, error and dense output.
pub(crate) struct Dop853<S> {
    /// Coefficients of the method DOP853 in the scalar of the run.
    coefficients: Coefficients<S>,
    /// Time at the start of the step, s.
    t: f64,
    /// Time at the end of the step, s.
    t_new: f64,
    /// State at the start of the step.
    y: Blocks<S>,
    /// State at which a stage is evaluated; after the last stage, the state at the end of the step.
    y_new: Blocks<S>,
    /// Derivative at the last evaluation of the right-hand side.
    f: Blocks<S>,
    /// Derivatives of all stages, for each block of components of the state.
    k: Vec<[Block<S>; STAGES]>,
    /// Eight coefficients of the dense output, for each block of components.
    dense: Vec<[Block<S>; 8]>,
    /// State at which a stage of the dense output is evaluated.
    inner: Blocks<S>,
    /// Error estimates of order 5 and 3, divided by the weights of the error test. They are stored in memory, because
    /// the compiler vectorizes loops that end in stores.
    quotients: Vec<[Block<f64>; 2]>,
    /// True if the driver may move the state after each step: only the moved state then needs a derivative.
    moves: bool,
    /// True if the derivative at the end of the last tried step is known.
    has_end: bool,
    /// Number of calls of the right-hand side so far.
    evaluations: u64,
}

impl<S: Real> Dop853<S> {
    /// Creates the method for a state of `n` components.
    pub(crate) fn new(n: usize) -> Self {
        let zero = S::from_f64(0.0);
        let count = n.div_ceil(LANES);
        Self {
            coefficients: Coefficients::new(),
            t: 0.0,
            t_new: 0.0,
            y: Blocks::zeros(n),
            y_new: Blocks::zeros(n),
            f: Blocks::zeros(n),
            k: vec![[[zero; LANES]; STAGES]; count],
            dense: vec![[[zero; LANES]; 8]; count],
            inner: Blocks::zeros(n),
            quotients: vec![[[0.0; LANES]; 2]; count],
            moves: false,
            has_end: false,
            evaluations: 0,
        }
    }

    /// Evaluates stage I at time `t`, s: f(t + c_I h, y + h Σ_j a_Ij k_j), with the step `h`, s. Leaves the result in
    /// `self.f`, from which the next stage copies it. Error if a number is not finite or f has no value.
    #[inline]
    fn stage<const I: usize, R: RightHandSide<S>>(&mut self, rhs: &mut R, h: S, t: f64) -> Result<(), StepFailure> {
        let row = &self.coefficients.a[I];
        let finite = advance::<S, I>(row, h, &self.y, &mut self.k, &self.f, &mut self.y_new);
        if !finite.is_finite() {
            return Err(self.not_finite(&self.y_new));
        }
        self.evaluations += 1;
        rhs.rhs(t, self.y_new.components_of_blocks(), self.f.components_mut()).map_err(StepFailure::Failed)
    }

    /// Evaluates stage I of a step `h`, s; only the dense output needs this stage. Error if a number is not finite or f
    /// has no value.
    fn inner_stage<const I: usize, R: RightHandSide<S>>(&mut self, rhs: &mut R, h: S) -> Result<(), StepFailure> {
        let row = &self.coefficients.a[I];
        let finite = advance::<S, I>(row, h, &self.y, &mut self.k, &self.f, &mut self.inner);
        if !finite.is_finite() {
            return Err(self.not_finite(&self.inner));
        }
        self.evaluations += 1;
        let t = self.t + (self.t_new - self.t) * PUBLISHED.c[I];
        rhs.rhs(t, self.inner.components_of_blocks(), self.f.components_mut()).map_err(StepFailure::Failed)
    }

    /// Evaluates f at time `t`, s, and state `y_new`, and stores the result as the stage with index `stage`. Error if f
    /// has no finite value there.
    fn evaluate<R: RightHandSide<S>>(&mut self, rhs: &mut R, stage: usize, t: f64) -> Result<(), StepFailure> {
        self.evaluations += 1;
        rhs.rhs(t, self.y_new.components_of_blocks(), self.f.components_mut()).map_err(StepFailure::Failed)?;
        self.store_stage(stage)
    }

    /// Stores the last derivative, in `self.f`, as the stage with index `stage`. Error if it is not finite.
    fn store_stage(&mut self, stage: usize) -> Result<(), StepFailure> {
        let mut finite = FiniteTest::new();
        for (k, f) in self.k.iter_mut().zip(&self.f.blocks) {
            finite.examine_block(f);
            k[stage] = *f;
        }
        if finite.is_finite() { Ok(()) } else { Err(self.not_finite(&self.y_new)) }
    }

    /// Creates the error that names the first component that is not finite, in the last derivative or else in the state
    /// `point`.
    #[cold]
    fn not_finite(&self, point: &Blocks<S>) -> StepFailure {
        let checks =
            check_finite(self.f.components_of_blocks()).and_then(|()| check_finite(point.components_of_blocks()));
        checks.err().unwrap_or(StepFailure::NotFinite { component: 0 })
    }

    /// Computes the state at the end of the step `h`, s, and its error |h| e₅² / √(e₅² + 0.01 e₃²). e₅ and e₃ are the
    /// norms of the differences from solutions of order 5 and 3.
    ///
    /// The error falls like h⁸, as the error of the method does. The first result tells if all numbers are finite.
    fn new_state_and_error(&mut self, h: S, test: &ErrorTest) -> (FiniteTest, f64) {
        let (b, e5, e3) = (&self.coefficients.a[END], &self.coefficients.error5, &self.coefficients.error3);
        let (mut finite, mut sum5, mut sum3) = (FiniteTest::new(), [0.0; LANES], [0.0; LANES]);
        let points = self.y_new.blocks.iter_mut().zip(&self.y.blocks).zip(test.absolute_blocks());
        for ((((y_new, y), absolute), (k, f)), quotients) in
            points.zip(self.k.iter_mut().zip(&self.f.blocks)).zip(&mut self.quotients)
        {
            k[END - 1] = *f;
            let eighth = combination(b, &USED[END], k, END);
            let fifth = combination(e5, &USED_BY_ERROR, k, END);
            let next: Block<S> = from_fn(|l| y[l].plus_multiple(h, eighth[l]));
            let third: Block<S> =
                from_fn(|l| eighth[l] - e3[0][l % 2] * k[0][l] - e3[8][l % 2] * k[8][l] - e3[11][l % 2] * k[11][l]);
            finite.examine_block(&next);
            *y_new = next;
            let inverse = test.inverse_weights(absolute, &y.map(Real::to_f64), &next.map(Real::to_f64));
            *quotients = [from_fn(|l| fifth[l].to_f64() * inverse[l]), from_fn(|l| third[l].to_f64() * inverse[l])];
        }
        for [q5, q3] in &self.quotients {
            sum5 = from_fn(|l| sum5[l] + q5[l] * q5[l]);
            sum3 = from_fn(|l| sum3[l] + q3[l] * q3[l]);
        }
        let n = self.y.components_of_blocks().len();
        (finite, dop853_error(h.to_f64(), sum5.iter().sum(), sum3.iter().sum(), n))
    }
}

/// Error of a step of size `h`, s, of `n` components: |h| e₅² / √(n (e₅² + 0.01 e₃²)). `sum5` and
/// `sum3` are e₅² and e₃², the sums of squares of weighted differences; infinite if they overflow.
#[inline(always)]
#[expect(clippy::inline_always, reason = "also inside code for wider registers, lane by lane")]
pub(crate) fn dop853_error(h: f64, sum5: f64, sum3: f64, n: usize) -> f64 {
    let both = sum5 + 0.01 * sum3;
    let both = if both > 0.0 { both } else { 1.0 };
    let error = h.abs() * sum5 / (both * n.max(1) as f64).sqrt();
    // Sums that overflow mean an error beyond any tolerance.
    if error.is_nan() { f64::INFINITY } else { error }
}

/// Sum Σⱼ aⱼ kⱼ for a block of components, over stage 0 and those stages before `end` that the row uses.
#[inline(always)]
#[expect(clippy::inline_always, reason = "with the stages known, the loops below become straight vector code")]
fn combination<S: Real>(a: &[TwoCopies<S>], used: &[bool; STAGES], k: &[Block<S>; STAGES], end: usize) -> Block<S> {
    let mut sum: Block<S> = from_fn(|l| a[0][l % 2] * k[0][l]);
    for j in 1..end {
        if used[j] {
            sum = from_fn(|l| sum[l].plus_multiple(a[j][l % 2], k[j][l]));
        }
    }
    sum
}

/// Writes the state y + h Σⱼ aᵢⱼ kⱼ of row I to `out`, and tests if it is finite. Copies stage I − 1 from `f` to `k`.
///
/// Every row uses the stage before it, so that a stage that is not finite makes the state not finite. Stage I − 1 is
/// added last, because it is known last: only two operations then remain.
#[inline]
fn advance<S: Real, const I: usize>(
    a: &[TwoCopies<S>; STAGES],
    h: S,
    y: &Blocks<S>,
    k: &mut [[Block<S>; STAGES]],
    f: &Blocks<S>,
    out: &mut Blocks<S>,
) -> FiniteTest {
    let mut finite = FiniteTest::new();
    let last = h * a[I - 1][0];
    for ((out, y), (k, f)) in out.blocks.iter_mut().zip(&y.blocks).zip(k.iter_mut().zip(&f.blocks)) {
        let newest = if I > 1 { *f } else { k[0] };
        let before: Block<S> = if I > 1 {
            let sum = combination(a, &USED[I], k, I - 1);
            from_fn(|l| y[l].plus_multiple(h, sum[l]))
        } else {
            *y
        };
        let next: Block<S> = from_fn(|l| before[l].plus_multiple(last, newest[l]));
        finite.examine_block(&next);
        *out = next;
        if I > 1 {
            k[I - 1] = newest;
        }
    }
    finite
}

impl<S: Real> Interpolant for Dop853<S> {
    type Real = S;

    fn span(&self) -> (f64, f64) {
        (self.t, self.t_new)
    }

    fn ends(&self) -> (&[S], &[S]) {
        (self.y.components_of_blocks(), self.y_new.components_of_blocks())
    }

    fn dense_output(&self, theta: S, mut put: impl FnMut(usize, S)) {
        for i in 0..self.y.components_of_blocks().len() {
            put(i, dense_output_value(self.dense[i / LANES].map(|r| r[i % LANES]), theta));
        }
    }

    fn degree_of_dense_output(&self) -> Option<usize> {
        Some(7)
    }

    fn coefficients(&self, mut put: impl FnMut(usize, usize, S)) {
        for i in 0..self.y.components_of_blocks().len() {
            let powers = dense_output_powers(self.dense[i / LANES].map(|r| r[i % LANES]));
            for (power, value) in powers.into_iter().enumerate() {
                put(i, power, value);
            }
        }
    }
}

impl<S: Real> Stepper for Dop853<S> {
    fn start<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64, y: &[S]) -> Result<(), StepFailure> {
        (self.t, self.t_new) = (t, t);
        self.y.components_mut().copy_from_slice(y);
        self.y_new.components_mut().copy_from_slice(y);
        self.evaluate(rhs, 0, t)
    }

    fn attempt<R>(&mut self, rhs: &mut R, trial: TrialStep, test: Option<&ErrorTest>) -> Result<f64, StepFailure>
    where
        R: RightHandSide<S>,
    {
        let h: S = trial.exact_step_length(self.t);
        let t = self.t;
        let at = |stage: usize| t + PUBLISHED.c[stage] * trial.h;
        self.stage::<1, R>(rhs, h, at(1))?;
        self.stage::<2, R>(rhs, h, at(2))?;
        self.stage::<3, R>(rhs, h, at(3))?;
        self.stage::<4, R>(rhs, h, at(4))?;
        self.stage::<5, R>(rhs, h, at(5))?;
        self.stage::<6, R>(rhs, h, at(6))?;
        self.stage::<7, R>(rhs, h, at(7))?;
        self.stage::<8, R>(rhs, h, at(8))?;
        self.stage::<9, R>(rhs, h, at(9))?;
        self.stage::<10, R>(rhs, h, at(10))?;
        self.stage::<11, R>(rhs, h, trial.t_new)?;
        self.t_new = trial.t_new;
        let (finite, error) = match test {
            Some(test) => self.new_state_and_error(h, test),
            None => {
                let row = &self.coefficients.a[END];
                (advance::<S, END>(row, h, &self.y, &mut self.k, &self.f, &mut self.y_new), 0.0)
            }
        };
        if !finite.is_finite() {
            return Err(self.not_finite(&self.y_new));
        }
        self.has_end = !self.moves && test.is_none_or(|test| error <= test.tolerance);
        if self.has_end {
            self.evaluate(rhs, END, trial.t_new)?;
        }
        Ok(error)
    }

    fn prepare_inside<R: RightHandSide<S>>(&mut self, rhs: &mut R) -> bool {
        let h = S::from_f64(self.t_new) - S::from_f64(self.t);
        self.has_end = self.has_end || self.evaluate(rhs, END, self.t_new).is_ok();
        // If the derivative at the end does not exist, the last stage of the step replaces it; its point is near the
        // end.
        let end = if self.has_end { END } else { END - 1 };
        let mut stages = || {
            self.inner_stage::<13, R>(rhs, h)?;
            self.inner_stage::<14, R>(rhs, h)?;
            self.inner_stage::<15, R>(rhs, h)?;
            self.store_stage(15)
        };
        let known = stages().is_ok() && self.has_end;
        let zero = S::from_f64(0.0);
        for (((r, k), y), y_new) in self.dense.iter_mut().zip(&self.k).zip(&self.y.blocks).zip(&self.y_new.blocks) {
            for l in 0..LANES {
                let rise = y_new[l] - y[l];
                let bend = h * k[0][l] - rise;
                r[0][l] = y[l];
                r[1][l] = rise;
                r[2][l] = bend;
                r[3][l] = rise - h * k[end][l] - bend;
            }
            for (r, d) in r[4..].iter_mut().zip(&self.coefficients.dense) {
                let sum = combination(d, &[true; STAGES], k, STAGES);
                *r = if known { sum.map(|x| h * x) } else { [zero; LANES] };
            }
        }
        known
    }

    fn component_of_largest_error(&self, test: &ErrorTest) -> Option<usize> {
        let e5 = &self.coefficients.error5;
        let errors = self.k.iter().flat_map(|k| combination(e5, &USED_BY_ERROR, k, END));
        let (y, y_new) = self.ends();
        test.component_of_largest_weighted_error(errors.take(y.len()), y, y_new)
    }

    fn accept(&mut self) {
        self.t = self.t_new;
        std::mem::swap(&mut self.y, &mut self.y_new);
        for k in &mut self.k {
            k[0] = k[END];
        }
    }

    fn expect_moves(&mut self) {
        self.moves = true;
    }

    fn continue_unmoved<R: RightHandSide<S>>(&mut self, rhs: &mut R) -> Result<(), StepFailure> {
        if self.has_end {
            return Ok(());
        }
        self.y_new.components_mut().copy_from_slice(self.y.components_of_blocks());
        self.evaluate(rhs, 0, self.t)
    }

    fn slope(&self) -> &[S] {
        self.f.components_of_blocks()
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
