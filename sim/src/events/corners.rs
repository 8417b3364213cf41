//! Instants at which a right-hand side has a corner or a jump in time. Steps end there, and each step sees only the
//! right-hand side on its own side of the corner.
//!
//! If such an instant depends on a variable along which slopes are taken, the slopes of the state jump there. Before
//! and after it the state is y(t, p). With a right-hand side that jumps from f⁻ to f⁺ at t(p), the slopes change by (f⁻
//! − f⁺) dt/dp. If a right-hand side only bends, its slopes are those on the side of the step.

use crate::error::Failure;
use crate::rhs::{Pulled, RightHandSide, Transposed};
use crate::rounding::smallest_step;
use tripos_traits::Real;

/// An instant at which a right-hand side is not smooth in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Time of the corner, s.
    pub at: f64,
    /// True if the right-hand side jumps there: steps to and from the corner see their own side, at 8 ulp of t from it.
    pub jumps: bool,
    /// Derivative of the corner's time along each direction along which the state carries slopes.
    pub moves: [f64; DIRECTIONS],
}

/// Largest number of directions along which a state carries slopes.
pub const DIRECTIONS: usize = 4;

impl Corner {
    /// Makes a corner at which the right-hand side jumps, and whose time, s, depends on nothing.
    #[must_use]
    pub const fn jump(at: f64) -> Self {
        Self { at, jumps: true, moves: [0.0; DIRECTIONS] }
    }

    /// Makes a corner at which the right-hand side is continuous, and whose time, s, depends on nothing.
    #[must_use]
    pub const fn bend(at: f64) -> Self {
        Self { at, jumps: false, moves: [0.0; DIRECTIONS] }
    }
}

/// Intervals of time in which a right-hand side is one smooth function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sides {
    /// Interval between the neighbouring jumps, s; its ends are just inside.
    pub(crate) values: (f64, f64),
    /// Interval between the neighbouring corners of any kind, s; its ends are just inside. There the slopes are one
    /// function, too.
    pub(crate) slopes: (f64, f64),
}

/// Corners of a run, and the number of corners that it has passed.
#[derive(Clone, Default)]
pub(crate) struct Corners {
    /// Corners in the order in which the run comes to them.
    all: Vec<Corner>,
    /// Direction of the run: 1 forwards in time, −1 backwards.
    toward: f64,
    end: f64,
    behind: usize,
}

impl Corners {
    pub(crate) fn new(corners: &[Corner], span: (f64, f64)) -> Self {
        let (t0, t1) = span;
        let toward = (t1 - t0).signum();
        let mut all = corners.to_vec();
        all.sort_by(|a, b| (toward * a.at).total_cmp(&(toward * b.at)));
        Self { all, toward, end: t1, behind: 0 }
    }

    /// Passes all corners before `t`, at it, or beyond it by less than the smallest step; `None` if there are none.
    /// Returns the derivatives of the instant of a jump that moves, or zeros if no jump moves.
    pub(crate) fn pass(&mut self, t: f64) -> Option<[f64; DIRECTIONS]> {
        let passed = self.passed(t);
        let moved = passed.iter().find(|corner| corner.jumps && corner.moves.iter().any(|by| *by != 0.0));
        (!passed.is_empty()).then(|| moved.map_or([0.0; DIRECTIONS], |corner| corner.moves))
    }

    /// Passes the same corners as [`Self::pass`], and returns these corners.
    pub(crate) fn passed(&mut self, t: f64) -> &[Corner] {
        let before = self.behind;
        let least = smallest_step(t);
        while self.all.get(self.behind).is_some_and(|corner| self.toward * (corner.at - t) < least) {
            self.behind += 1;
        }
        &self.all[before..self.behind]
    }

    /// Time of the next corner before the end of the run, s.
    pub(crate) fn next(&self) -> Option<f64> {
        let next = self.all.get(self.behind).map(|corner| corner.at);
        next.filter(|corner| self.toward * (self.end - corner) >= smallest_step(self.end))
    }

    /// Intervals between the neighbouring jumps and between the neighbouring corners.
    pub(crate) fn sides(&self) -> Sides {
        Sides { values: self.between(|corner| corner.jumps), slopes: self.between(|_| true) }
    }

    /// Interval between the neighbouring corners that satisfy `is_meant`; its ends are half the smallest step inside.
    fn between(&self, is_meant: impl Fn(&Corner) -> bool) -> (f64, f64) {
        // Farther from the corner than the rounding error of an argument such as `k*t - a`.
        let beside = |corner: &Corner, toward: f64| corner.at + toward * smallest_step(corner.at) / 2.0;
        let (behind, ahead) = self.all.split_at(self.behind);
        let behind = behind.iter().rfind(|corner| is_meant(corner)).map(|corner| beside(corner, self.toward));
        let ahead = ahead.iter().find(|corner| is_meant(corner)).map(|corner| beside(corner, -self.toward));
        let (low, high) = if self.toward > 0.0 { (behind, ahead) } else { (ahead, behind) };
        (low.unwrap_or(f64::NEG_INFINITY), high.unwrap_or(f64::INFINITY))
    }
}

/// A right-hand side between two corners. At a jump it has the value just inside, at a bend the slopes just inside.
pub(crate) struct Between<'a, R, S> {
    rhs: &'a mut R,
    /// Index of the state's component that is the time.
    clock: Option<usize>,
    sides: Sides,
    /// Copy of a state, with its time moved inside the interval.
    state: Vec<S>,
    /// Values whose slopes are taken, computed inside the interval.
    beside: Vec<S>,
}

impl<'a, R, S: Real> Between<'a, R, S> {
    pub(crate) fn new(rhs: &'a mut R, clock: Option<usize>, sides: Sides) -> Self {
        Self { rhs, clock, sides, state: Vec::new(), beside: Vec::new() }
    }

    /// Sets the interval to that between two other corners.
    pub(crate) fn go_on(&mut self, sides: Sides) {
        self.sides = sides;
    }

    /// Evaluates the right-hand side at an instant and a state whose time is moved inside the interval.
    #[inline]
    fn ask<T>(&mut self, t: f64, y: &[S], question: impl FnOnce(&mut R, f64, &[S]) -> T) -> T {
        self.ask_inside(self.sides.values, t, y, question)
    }

    /// Asks at an instant and a state whose time is moved inside the interval, s.
    #[inline]
    fn ask_inside<T>(
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

    /// Gives `values` the slopes of this side of a corner, if they were computed at a corner: at `t`, or at the time in
    /// the state.
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
        self.ask_inside((low, high), t, y, |rhs, t, y| again(rhs, t, y, &mut beside));
        turn(values, &beside);
        self.beside = beside;
    }
}

impl<R: RightHandSide<S>, S: Real> Between<'_, R, S> {
    /// Enters the interval between other corners from a state at `t`. The slopes of the state change if the jump
    /// between the intervals moves.
    pub(crate) fn enter(&mut self, sides: Sides, t: f64, y: &mut [S], moves: &[f64; DIRECTIONS]) {
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

    /// Computes y′ in doubles; not a number if f has no value.
    fn rates(&mut self, t: f64, y: &[S]) -> Vec<f64> {
        let mut rates = vec![S::from_f64(0.0); y.len()];
        match self.rhs(t, y, &mut rates) {
            Ok(()) => rates.iter().map(|rate| rate.to_f64()).collect(),
            Err(_) => vec![f64::NAN; y.len()],
        }
    }
}

impl<R: Transposed> Between<'_, R, f64> {
    /// Pulls weights back as [`Transposed::pull`] does, with the right-hand side of this interval between corners.
    pub(crate) fn pull(&mut self, t: f64, y: &[f64], weights: &[f64], to: Pulled<'_>) -> Result<(), Failure> {
        self.ask_inside(self.sides.slopes, t, y, |rhs, t, y| rhs.pull(t, y, weights, to))
    }

    /// Pulls weights of constraints back as [`Transposed::pull_constraints`] does, with the constraints of this
    /// interval.
    pub(crate) fn pull_constraints(
        &mut self,
        t: f64,
        y: &[f64],
        shares: &[f64],
        to: Pulled<'_>,
    ) -> Result<(), Failure> {
        self.ask_inside(self.sides.slopes, t, y, |rhs, t, y| rhs.pull_constraints(t, y, shares, to))
    }
}

/// Replaces the slopes of `numbers` by those of `of`; the values stay.
pub(crate) fn turn<S: Real>(numbers: &mut [S], of: &[S]) {
    for (number, of) in numbers.iter_mut().zip(of) {
        for at in 0..S::SLOPES {
            *number = number.turned(at, of.slope(at) - number.slope(at));
        }
    }
}

impl<S: Real, R: RightHandSide<S>> RightHandSide<S> for Between<'_, R, S> {
    #[inline]
    fn rhs(&mut self, t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure> {
        self.ask(t, y, |rhs, t, y| rhs.rhs(t, y, dydt))?;
        let mut known = Ok(());
        self.turn(t, y, dydt, |rhs, t, y, dydt| known = rhs.rhs(t, y, dydt));
        known
    }

    fn jacobian(&mut self, t: f64, y: &[S], out: &mut [S]) -> Option<Result<(), Failure>> {
        self.ask(t, y, |rhs, t, y| rhs.jacobian(t, y, out))
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
        self.ask(t, y, |rhs, t, y| rhs.inertia(t, y, out))
    }

    fn avoids(&mut self, t: f64, y: &[S]) -> bool {
        self.ask(t, y, RightHandSide::avoids)
    }

    fn yields(&mut self, t: f64, y: &[S]) -> bool {
        self.rhs.yields(t, y)
    }

    fn hands_over(&mut self, t: f64, y: Option<&[S]>) -> bool {
        self.rhs.hands_over(t, y)
    }

    fn power(&mut self, t: f64, y: &[S]) -> Option<f64> {
        self.ask(t, y, RightHandSide::power)
    }
}
