//! Corners of a right-hand side: times at which it has a kink or a jump. Steps end there, and each step uses the
//! right-hand side only on its own side of the corner.
//!
//! States may carry derivatives by variables p (dual numbers). If the time of a jump depends on p, these derivatives
//! jump, too. Where the right-hand side jumps from f⁻ to f⁺ at time t(p), the derivatives of the state y(t, p) change
//! by (f⁻ − f⁺) dt/dp. At a kink, a step uses the derivatives of f on its own side.

use crate::error::Failure;
use crate::right_hand_side::RightHandSide;
use crate::rounding::smallest_step_beyond_rounding;
use crate::transposed_right_hand_side::{ProductSums, TransposedRightHandSide};
use tripos_traits::Real;

/// Time at which a right-hand side f(t, y) is not smooth: it has a kink or a jump.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Time at which the right-hand side has the kink or jump, s.
    pub at: f64,
    /// True if the right-hand side jumps at the corner, false for a kink. At a jump a step evaluates f on the step's
    /// own side, 8 ulp of t away.
    pub jumps: bool,
    /// Derivative of the corner's time by each variable by which the numbers of the state carry derivatives.
    pub moves: [f64; SLOPE_DIRECTIONS],
}

/// Largest number of variables by which the numbers of a state can carry derivatives.
pub const SLOPE_DIRECTIONS: usize = 4;

impl Corner {
    /// Creates a corner at time `at`, s, at which the right-hand side jumps. The time is constant: it
    /// does not depend on the variables by which the state carries derivatives.
    #[must_use]
    pub const fn jump(at: f64) -> Self {
        Self { at, jumps: true, moves: [0.0; SLOPE_DIRECTIONS] }
    }

    /// Creates a corner at time `at`, s, at which the right-hand side is continuous and has a kink. The
    /// time is constant: it does not depend on the variables by which the state carries derivatives.
    #[must_use]
    pub const fn kink(at: f64) -> Self {
        Self { at, jumps: false, moves: [0.0; SLOPE_DIRECTIONS] }
    }
}

/// Intervals of time around the current time of a run: one without jumps of the right-hand side, and one without
/// corners of any kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct IntervalsBetweenCorners {
    /// Interval between the neighbouring jumps, s. Each end is 8 ulp of t inside.
    pub(crate) values: (f64, f64),
    /// Interval between the neighbouring corners of any kind, s. Each end is 8 ulp of t inside. The derivatives of f
    /// are smooth in it, too.
    pub(crate) slopes: (f64, f64),
}

/// Corners of a run's right-hand side, and the number of corners that the run has passed.
#[derive(Clone, Default)]
pub(crate) struct Corners {
    /// Corners in the order in which the run meets them.
    all: Vec<Corner>,
    /// Direction of the run: 1 forward in time, −1 backward.
    toward: f64,
    /// Time at which the run ends, s.
    end: f64,
    /// Number of corners that the run has passed.
    behind: usize,
}

impl Corners {
    /// Creates the list of corners for a run over `span`, s, of which none is passed yet.
    pub(crate) fn new(corners: &[Corner], span: (f64, f64)) -> Self {
        let (t0, t1) = span;
        let toward = (t1 - t0).signum();
        let mut all = corners.to_vec();
        all.sort_by(|a, b| (toward * a.at).total_cmp(&(toward * b.at)));
        Self { all, toward, end: t1, behind: 0 }
    }

    /// Marks all corners up to time `t`, s, as passed; corners beyond `t` by less than the smallest step count, too.
    /// `None` if none is newly passed. Else returns the derivatives dt/dp of a passed jump's time by the variables p of
    /// the state; zeros if no passed jump depends on p.
    pub(crate) fn pass_corners(&mut self, t: f64) -> Option<[f64; SLOPE_DIRECTIONS]> {
        let passed = self.passed_corners(t);
        let moved = passed.iter().find(|corner| corner.jumps && corner.moves.iter().any(|by| *by != 0.0));
        (!passed.is_empty()).then(|| moved.map_or([0.0; SLOPE_DIRECTIONS], |corner| corner.moves))
    }

    /// Marks all corners up to time `t`, s, as passed; corners beyond `t` by less than the smallest step count, too.
    /// Returns the newly passed corners.
    pub(crate) fn passed_corners(&mut self, t: f64) -> &[Corner] {
        let before = self.behind;
        let least = smallest_step_beyond_rounding(t);
        while self.all.get(self.behind).is_some_and(|corner| self.toward * (corner.at - t) < least) {
            self.behind += 1;
        }
        &self.all[before..self.behind]
    }

    /// Time of the next corner, s; `None` if there is none before the end of the run.
    pub(crate) fn next_corner(&self) -> Option<f64> {
        let next = self.all.get(self.behind).map(|corner| corner.at);
        next.filter(|corner| self.toward * (self.end - corner) >= smallest_step_beyond_rounding(self.end))
    }

    /// Intervals between the neighbouring jumps and between the neighbouring corners of any kind.
    pub(crate) fn intervals_between_corners(&self) -> IntervalsBetweenCorners {
        IntervalsBetweenCorners {
            values: self.interval_between_corners(|corner| corner.jumps),
            slopes: self.interval_between_corners(|_| true),
        }
    }

    /// Interval between the neighbouring corners for which `is_meant` is true, s. Each end is half the smallest step
    /// inside; infinite if there is no such corner on a side.
    fn interval_between_corners(&self, is_meant: impl Fn(&Corner) -> bool) -> (f64, f64) {
        // The distance from the corner exceeds the rounding error of an argument such as `k*t - a`.
        let beside = |corner: &Corner, toward: f64| corner.at + toward * smallest_step_beyond_rounding(corner.at) / 2.0;
        let (behind, ahead) = self.all.split_at(self.behind);
        let behind = behind.iter().rfind(|corner| is_meant(corner)).map(|corner| beside(corner, self.toward));
        let ahead = ahead.iter().find(|corner| is_meant(corner)).map(|corner| beside(corner, -self.toward));
        let (low, high) = if self.toward > 0.0 { (behind, ahead) } else { (ahead, behind) };
        (low.unwrap_or(f64::NEG_INFINITY), high.unwrap_or(f64::INFINITY))
    }
}

/// Right-hand side that is smooth between two neighbouring corners. At a jump it has the value just inside the
/// interval, at a kink the derivatives just inside the interval.
pub(crate) struct BetweenCorners<'a, R, S> {
    /// Right-hand side that has corners in time.
    rhs: &'a mut R,
    /// Index of the component of the state that is the time; `None` if there is none.
    clock: Option<usize>,
    /// Intervals of time in which the right-hand side is smooth: between neighbouring jumps, and between neighbouring
    /// corners of any kind.
    sides: IntervalsBetweenCorners,
    /// Copy of a state, with its time moved into the interval between two corners.
    state: Vec<S>,
    /// Working space for values that are computed inside the interval only for their derivatives.
    beside: Vec<S>,
}

impl<'a, R, S: Real> BetweenCorners<'a, R, S> {
    /// Creates the smooth right-hand side in these intervals of time. `clock` is the index of the state's
    /// component that is the time; `None` if there is none.
    pub(crate) fn new(rhs: &'a mut R, clock: Option<usize>, sides: IntervalsBetweenCorners) -> Self {
        Self { rhs, clock, sides, state: Vec::new(), beside: Vec::new() }
    }

    /// Sets the intervals in which the right-hand side is smooth to those between other corners.
    pub(crate) fn set_corner_intervals(&mut self, sides: IntervalsBetweenCorners) {
        self.sides = sides;
    }

    /// Calls `question` with the right-hand side, a time and a state. Moves the time, and the state's time component,
    /// into the interval between jumps before.
    #[inline]
    fn evaluate_beside_corner<T>(&mut self, t: f64, y: &[S], question: impl FnOnce(&mut R, f64, &[S]) -> T) -> T {
        self.evaluate_inside_corners(self.sides.values, t, y, question)
    }

    /// Calls `question` with the right-hand side, a time and a state. Moves the time, and the state's time component,
    /// into `interval`, s, before.
    #[inline]
    fn evaluate_inside_corners<T>(
        &mut self,
        interval: (f64, f64),
        t: f64,
        y: &[S],
        question: impl FnOnce(&mut R, f64, &[S]) -> T,
    ) -> T {
        let (low, high) = interval;
        let inside = t.max(low).min(high);
        let Some(clock) = self.clock.map(|at| (at, y[at].to_f64())).filter(|(_, told)| !(low..=high).contains(told))
        else {
            return question(self.rhs, inside, y);
        };
        self.state.clear();
        self.state.extend_from_slice(y);
        self.state[clock.0] = S::from_f64(clock.1.max(low).min(high));
        question(self.rhs, inside, &self.state)
    }

    /// Replaces the derivatives that `values` carry if `t` or the state's time component lies outside the interval
    /// between corners. The new derivatives are those inside the interval; `again` computes the values a second time
    /// there.
    #[inline]
    fn turn(&mut self, t: f64, y: &[S], values: &mut [S], again: impl FnOnce(&mut R, f64, &[S], &mut [S])) {
        let (low, high) = self.sides.slopes;
        let is_inside = |t: f64| (low..=high).contains(&t);
        if S::SLOPES == 0 || (is_inside(t) && self.clock.is_none_or(|at| is_inside(y[at].to_f64()))) {
            return;
        }
        let mut beside = std::mem::take(&mut self.beside);
        beside.clear();
        beside.extend_from_slice(values);
        self.evaluate_inside_corners((low, high), t, y, |rhs, t, y| again(rhs, t, y, &mut beside));
        replace_slopes(values, &beside);
        self.beside = beside;
    }
}

impl<R: RightHandSide<S>, S: Real> BetweenCorners<'_, R, S> {
    /// Moves to the intervals after a corner at time `t`, s. `moves` are the derivatives of the corner's time; at a
    /// jump they change the derivatives that the state `y` carries.
    pub(crate) fn pass_jump(
        &mut self,
        sides: IntervalsBetweenCorners,
        t: f64,
        y: &mut [S],
        moves: &[f64; SLOPE_DIRECTIONS],
    ) {
        let is_moved = S::SLOPES > 0 && moves.iter().any(|by| *by != 0.0);
        let before = is_moved.then(|| self.rates(t, y));
        self.sides = sides;
        let Some(before) = before else { return };
        let after = self.rates(t, y);
        for ((y, before), after) in y.iter_mut().zip(before).zip(after) {
            // s⁺ = s⁻ + (f⁻ − f⁺) dt/dp
            for (at, by) in moves.iter().enumerate().take(S::SLOPES) {
                *y = y.turned(at, (before - after) * by);
            }
        }
    }

    /// Computes y′ = f(t, y), rounded to `f64`; NaN if f has no value.
    fn rates(&mut self, t: f64, y: &[S]) -> Vec<f64> {
        let mut rates = vec![S::from_f64(0.0); y.len()];
        match self.rhs(t, y, &mut rates) {
            Ok(()) => rates.iter().map(|rate| rate.to_f64()).collect(),
            Err(_) => vec![f64::NAN; y.len()],
        }
    }
}

impl<R: TransposedRightHandSide> BetweenCorners<'_, R, f64> {
    /// Adds f_yᵀ w and f_pᵀ w to the two vectors of `to`, for the smooth right-hand side between corners and w =
    /// `weights`. It calls [`TransposedRightHandSide::add_transposed_product`]. Error if the Jacobians have no value.
    pub(crate) fn pull(&mut self, t: f64, y: &[f64], weights: &[f64], to: ProductSums<'_>) -> Result<(), Failure> {
        self.evaluate_inside_corners(self.sides.slopes, t, y, |rhs, t, y| rhs.add_transposed_product(t, y, weights, to))
    }

    /// Adds φ_yᵀ w and φ_pᵀ w to the two vectors of `to`, for the constraints φ between corners and w = `shares`. It
    /// calls [`TransposedRightHandSide::add_transposed_constraint_product`]. Error if the Jacobians have no value.
    pub(crate) fn pull_constraints(
        &mut self,
        t: f64,
        y: &[f64],
        shares: &[f64],
        to: ProductSums<'_>,
    ) -> Result<(), Failure> {
        self.evaluate_inside_corners(self.sides.slopes, t, y, |rhs, t, y| {
            rhs.add_transposed_constraint_product(t, y, shares, to)
        })
    }
}

/// Replaces the derivatives that `numbers` carry with those of the numbers `of`. The values are not changed.
pub(crate) fn replace_slopes<S: Real>(numbers: &mut [S], of: &[S]) {
    for (number, of) in numbers.iter_mut().zip(of) {
        for at in 0..S::SLOPES {
            *number = number.turned(at, of.slope(at) - number.slope(at));
        }
    }
}

impl<S: Real, R: RightHandSide<S>> RightHandSide<S> for BetweenCorners<'_, R, S> {
    #[inline]
    fn rhs(&mut self, t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure> {
        self.evaluate_beside_corner(t, y, |rhs, t, y| rhs.rhs(t, y, dydt))?;
        let mut known = Ok(());
        self.turn(t, y, dydt, |rhs, t, y, dydt| known = rhs.rhs(t, y, dydt));
        known
    }

    fn jacobian(&mut self, t: f64, y: &[S], out: &mut [S]) -> Option<Result<(), Failure>> {
        self.evaluate_beside_corner(t, y, |rhs, t, y| rhs.jacobian(t, y, out))
    }

    #[inline]
    fn taylor(&mut self, t: f64, order: usize, x: &mut [S]) -> Option<Result<(), Failure>> {
        let (low, high) = self.sides.values;
        self.rhs.taylor(t.max(low).min(high), order, x)
    }

    fn divisor_count(&self) -> usize {
        self.rhs.divisor_count()
    }

    fn divisors(&mut self, t: f64, y: &[S], out: &mut [S]) {
        self.rhs.divisors(t, y, out);
    }

    fn divisor_name(&self, at: usize) -> String {
        self.rhs.divisor_name(at)
    }

    fn constraint_count(&self) -> usize {
        self.rhs.constraint_count()
    }

    fn constraints(&mut self, t: f64, y: &[S], values: &mut [S], slopes: &mut [S]) {
        self.rhs.constraints(t, y, values, slopes);
        self.turn(t, y, values, |rhs, t, y, values| rhs.constraints(t, y, values, &mut slopes.to_vec()));
    }

    fn inertia(&mut self, t: f64, y: &[S], out: &mut Vec<f64>) -> bool {
        self.evaluate_beside_corner(t, y, |rhs, t, y| rhs.inertia(t, y, out))
    }

    fn avoids_end_of_step(&mut self, t: f64, y: &[S]) -> bool {
        self.evaluate_beside_corner(t, y, RightHandSide::avoids_end_of_step)
    }

    fn yields_step(&mut self, t: f64, y: &[S]) -> bool {
        self.rhs.yields_step(t, y)
    }

    fn hands_over(&mut self, t: f64, y: Option<&[S]>) -> bool {
        self.rhs.hands_over(t, y)
    }

    fn power(&mut self, t: f64, y: &[S]) -> Option<f64> {
        self.evaluate_beside_corner(t, y, RightHandSide::power)
    }
}
