//! Taylor's method: the solution inside a step is the Taylor polynomial at its start.
//!
//! Invariant: row k of `x` has the coefficients of order k at (t, y). After a trial step that passed its error test,
//! `next` has those at its end. The right-hand side computes the coefficients by recurrence. The order is fixed for a
//! run and follows from its tolerance. The length of a step follows from the last two coefficients before the step is
//! taken, so that steps are hardly ever rejected. The same polynomial is the dense output. A. Jorba & M. Zou, "A
//! software package for the numerical integration of ODEs by means of high-order Taylor methods", Experimental
//! Mathematics 14 (2005) 99–117, §3.
//!
//! The rounding error of a step's sum of terms is added in the next step (compensated summation).

use tripos_traits::Real;

use super::run_options::{ORDERS, Options};
use crate::dense_output::Interpolant;
use crate::error_test::ErrorTest;
use crate::right_hand_side::RightHandSide;
use crate::stepper::{StepFailure, Stepper, TrialStep, check_finite};

/// Increase of the order of Taylor's method per unit of −ln(tolerance). Jorba and Zou use ½, since their cost grows
/// with the square of the order. Here only a small part of the cost grows like that.
const ORDERS_PER_DIGIT: f64 = 0.7;

/// Largest allowed jump of the derivative between the Taylor polynomials of two steps, expressed as an error and
/// divided by the allowed error.
///
/// The jump contains all terms from the first one that was cut off. A good step leaves that first term below the
/// allowed error.
pub(crate) const ALLOWED_JUMP: f64 = 10.0;

/// Order of Taylor's method for a run: the order of the options, or else the order that reaches the tolerance at the
/// lowest cost.
///
/// The relative tolerance decides, or the smallest absolute tolerance if the relative one is 0.
pub(crate) fn taylor_order(options: &Options) -> usize {
    let tolerance = if options.rtol > 0.0 { options.rtol } else { options.atol.smallest() };
    let wanted = 2.0 - ORDERS_PER_DIGIT * tolerance.clamp(f64::MIN_POSITIVE, 0.1).ln();
    // The number that is cast is neither negative nor large.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 3 and 500")]
    let order = wanted.ceil() as usize;
    options.order.unwrap_or(order).clamp(ORDERS.0, ORDERS.1)
}

/// Taylor's method in a run: the current step with its coefficients.
pub(crate) struct Taylor<S> {
    /// Number of components of the state.
    n: usize,
    /// Order of the Taylor polynomials.
    order: usize,
    /// Time at the start of the step, s.
    t: f64,
    /// Time at the end of the step, s.
    t_new: f64,
    /// Taylor coefficients at the start of the step, (order + 1) × n entries: row k has those of order k.
    x: Vec<S>,
    /// Highest order up to which all coefficients in `x` are finite.
    usable: usize,
    /// Taylor coefficients at the end of the last tried step, (order + 1) × n entries.
    next: Vec<S>,
    /// Highest order up to which all coefficients in `next` are finite.
    next_usable: usize,
    /// Rounding errors of the state at the start of the step. The next sum adds them (compensated summation).
    carry: Vec<S>,
    /// Rounding errors of the state at the end of the step, for the sum of the next step (compensated
    /// summation).
    carry_new: Vec<S>,
    /// Norms of the Taylor coefficients of the last two usable orders, divided by the weights of the error test.
    norms: [f64; 2],
    /// Jump of the derivative at the end of the last tried step, expressed as an error of the state.
    jump: Vec<S>,
    /// Number of calls for Taylor coefficients so far.
    evaluations: u64,
    /// True if the driver may move the state after each step. A trial step then computes only the derivative at its
    /// end, no higher coefficients.
    moved: bool,
}

impl<S: Real> Taylor<S> {
    /// Creates Taylor's method of this order for a state of `n` components.
    pub(crate) fn new(n: usize, order: usize) -> Self {
        let zeros = |n: usize| vec![S::from_f64(0.0); n];
        Self {
            n,
            order,
            t: 0.0,
            t_new: 0.0,
            x: zeros((order + 1) * n),
            usable: 1,
            next: zeros((order + 1) * n),
            next_usable: 1,
            carry: zeros(n),
            carry_new: zeros(n),
            norms: [0.0; 2],
            jump: zeros(n),
            evaluations: 0,
            moved: false,
        }
    }

    /// Computes the Taylor coefficients up to `order` at time `t`, s, from the state in the first row of `next`. Error
    /// if the right-hand side does not know them, or if the derivative is not finite.
    fn taylor_coefficients_at_end<R: RightHandSide<S>>(
        &mut self,
        rhs: &mut R,
        t: f64,
        order: usize,
    ) -> Result<(), StepFailure> {
        // The derivative alone costs little, since it needs no sums of products of coefficients.
        self.evaluations += u64::from(order > 1);
        match rhs.taylor(t, order, &mut self.next[..(order + 1) * self.n]) {
            Some(outcome) => outcome.map_err(StepFailure::Failed)?,
            None => return Err(StepFailure::NotFinite { component: 0 }),
        }
        let n = self.n;
        let row = |k: usize| &self.next[k * n..(k + 1) * n];
        // Coefficients grow by powers of 1/(radius of convergence); if the highest overflow, fewer are used.
        let mut usable = order;
        while usable > 1 && check_finite(row(usable)).is_err() {
            usable -= 1;
        }
        self.next_usable = usable;
        check_finite(row(1))
    }

    /// Writes the state y + Σ x_k hᵏ at the end of a step of `h` s to `next`, and its rounding errors to
    /// `carry_new`.
    fn advance(&mut self, h: S) {
        let (n, x) = (self.n, &self.x);
        polynomial(x, n, self.usable, h, &mut self.next[..n]);
        let rows = x.iter().zip(&mut self.next).zip(self.carry.iter().zip(&mut self.carry_new));
        for ((start, end), (carry, carry_new)) in rows.take(n) {
            let add = *carry + h * *end;
            let new = *start + add;
            let added = new - *start;
            *carry_new = (*start - (new - added)) + (add - added);
            *end = new;
        }
    }

    /// Larger of the last two terms of the Taylor polynomial after `h` seconds, divided by the weights of the error
    /// test.
    fn last_terms(&self, h: f64) -> f64 {
        let [before, last] = self.norms;
        let power = taylor_step_power(h, self.usable - 1);
        (before * power).max(last * (power * h))
    }

    /// Norm of the jump of the state's derivative at the end of a step of `h` s. The jump is the difference between the
    /// Taylor polynomial of the step and that of the next step. It is expressed as the error of the state that a term
    /// of the next order would make.
    ///
    /// The jump reveals an error if the last terms happen to vanish. For x'' = −x³ at x = 0, only every fourth term is
    /// not zero.
    fn jump_of_taylor_derivative(&mut self, test: &ErrorTest, h: S) -> f64 {
        let n = self.n;
        self.jump.fill(S::from_f64(0.0));
        for k in (1..=self.usable).rev() {
            let times = S::from_f64(k as f64);
            for (sum, x) in self.jump.iter_mut().zip(&self.x[k * n..]) {
                *sum = sum.mul_add(h, times * *x);
            }
        }
        let share = h / S::from_f64((self.usable + 1) as f64);
        for (sum, slope) in self.jump.iter_mut().zip(&self.next[n..]) {
            *sum = (*sum - *slope) * share;
        }
        test.norm(&self.jump, &self.x[..n], &self.next[..n])
    }
}

/// Power hⁿ with a whole exponent.
pub(crate) fn taylor_step_power(h: f64, n: usize) -> f64 {
    h.powi(i32::try_from(n).unwrap_or(i32::MAX))
}

/// Size of a step, s, at which the larger of the last two terms equals the allowed error. `norms` are the weighted
/// norms of the coefficients of these two orders; `order` is the higher order.
pub(crate) fn proposed_taylor_step_size(norms: [f64; 2], order: usize, tolerance: f64) -> f64 {
    let [before, last] = norms.map(|norm| norm / tolerance);
    // The term of order k is as large as the allowed error after norm^(−1/k) seconds.
    let size = last.powf(-1.0 / order as f64);
    let enough = order < 2 || before * taylor_step_power(size, order - 1) <= 1.0;
    let size = if enough { size } else { before.powf(-1.0 / (order - 1) as f64) };
    size * (1.0 - 1e-9)
}

/// Writes Σ x_k h^(k−1) over 1 ≤ k ≤ `order` to `out`, for each of `n` polynomials. Row k of `x` has the coefficients
/// of order k.
fn polynomial<S: Real>(x: &[S], n: usize, order: usize, h: S, out: &mut [S]) {
    let mut at = 0;
    while at < n {
        at += match n - at {
            8.. => taylor_polynomial_block::<S, 8>(x, n, at, order, h, out),
            4.. => taylor_polynomial_block::<S, 4>(x, n, at, order, h, out),
            2.. => taylor_polynomial_block::<S, 2>(x, n, at, order, h, out),
            _ => taylor_polynomial_block::<S, 1>(x, n, at, order, h, out),
        };
    }
}

/// Writes Σ x_k h^(k−1) to `out` for `N` of the `n` polynomials, from index `at` on, and returns N. Even and odd orders
/// are summed separately, so that neither sum waits for the other.
#[inline]
fn taylor_polynomial_block<S: Real, const N: usize>(
    x: &[S],
    n: usize,
    at: usize,
    order: usize,
    h: S,
    out: &mut [S],
) -> usize {
    let zero = [S::from_f64(0.0); N];
    let square = h * h;
    let row = |k: usize| x[k * n + at..].first_chunk::<N>().unwrap_or(&zero);
    let (mut odd, mut even) = (zero, zero);
    let mut k = order;
    if k % 2 == 1 {
        odd = *row(k);
        k -= 1;
    }
    while k > 0 {
        let (of_even, of_odd) = (row(k), row(k - 1));
        for i in 0..N {
            even[i] = of_even[i].plus_multiple(square, even[i]);
            odd[i] = of_odd[i].plus_multiple(square, odd[i]);
        }
        k -= 2;
    }
    for i in 0..N {
        out[at + i] = even[i].mul_add(h, odd[i]);
    }
    N
}

impl<S: Real> Interpolant for Taylor<S> {
    type Real = S;

    fn span(&self) -> (f64, f64) {
        (self.t, self.t_new)
    }

    fn ends(&self) -> (&[S], &[S]) {
        (&self.x[..self.n], &self.next[..self.n])
    }

    fn dense_output(&self, theta: S, mut put: impl FnMut(usize, S)) {
        let h = theta * (S::from_f64(self.t_new) - S::from_f64(self.t));
        let mut sums = vec![S::from_f64(0.0); self.n];
        polynomial(&self.x, self.n, self.usable, h, &mut sums);
        for (i, sum) in sums.into_iter().enumerate() {
            put(i, self.x[i] + (self.carry[i] + h * sum));
        }
    }

    fn degree_of_dense_output(&self) -> Option<usize> {
        Some(self.usable)
    }

    fn coefficients(&self, mut put: impl FnMut(usize, usize, S)) {
        let h = S::from_f64(self.t_new) - S::from_f64(self.t);
        let mut power = S::int(1);
        for (k, row) in self.x.chunks_exact(self.n.max(1)).take(self.usable + 1).enumerate() {
            for (i, x) in row.iter().enumerate() {
                put(i, k, power * *x);
            }
            power = power * h;
        }
    }
}

impl<S: Real> Stepper for Taylor<S> {
    fn start<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64, y: &[S]) -> Result<(), StepFailure> {
        (self.t, self.t_new) = (t, t);
        self.next[..self.n].copy_from_slice(y);
        let outcome = self.taylor_coefficients_at_end(rhs, t, self.order);
        self.accept();
        self.carry.fill(S::from_f64(0.0));
        self.next[..self.n].copy_from_slice(y);
        outcome
    }

    fn proposal(&mut self, test: &ErrorTest) -> Option<f64> {
        let n = self.n;
        let row = |k: usize| &self.x[k * n..(k + 1) * n];
        let p = self.usable;
        self.norms = test.largest_weighted_of_two(row(p - 1), row(p), row(0));
        Some(proposed_taylor_step_size(self.norms, p, test.tolerance))
    }

    fn attempt<R>(&mut self, rhs: &mut R, trial: TrialStep, test: Option<&ErrorTest>) -> Result<f64, StepFailure>
    where
        R: RightHandSide<S>,
    {
        self.advance(trial.exact_step_length(self.t));
        self.t_new = trial.t_new;
        check_finite(&self.next[..self.n])?;
        let error = test.map_or(0.0, |_| self.last_terms(trial.h.abs()));
        if test.is_some_and(|test| error > test.tolerance) {
            return Ok(error);
        }
        self.taylor_coefficients_at_end(rhs, trial.t_new, if self.moved { 1 } else { self.order })?;
        let jump = test.map_or(0.0, |test| self.jump_of_taylor_derivative(test, trial.exact_step_length(self.t)));
        Ok(error.max(jump / ALLOWED_JUMP))
    }

    fn component_of_largest_error(&self, test: &ErrorTest) -> Option<usize> {
        let (y, y_new) = self.ends();
        let h = S::from_f64(taylor_step_power(self.t_new - self.t, self.usable));
        let last = &self.x[self.usable * self.n..(self.usable + 1) * self.n];
        test.component_of_largest_weighted_error(last.iter().map(|x| *x * h), y, y_new)
    }

    fn accept(&mut self) {
        self.t = self.t_new;
        self.usable = self.next_usable;
        std::mem::swap(&mut self.x, &mut self.next);
        std::mem::swap(&mut self.carry, &mut self.carry_new);
    }

    fn expect_moves(&mut self) {
        self.moved = true;
    }

    fn continue_unmoved<R: RightHandSide<S>>(&mut self, rhs: &mut R) -> Result<(), StepFailure> {
        let n = self.n;
        self.next[..n].copy_from_slice(&self.x[..n]);
        self.taylor_coefficients_at_end(rhs, self.t, self.order)?;
        self.usable = self.next_usable;
        std::mem::swap(&mut self.x, &mut self.next);
        Ok(())
    }

    fn slope(&self) -> &[S] {
        &self.x[self.n..2 * self.n]
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
