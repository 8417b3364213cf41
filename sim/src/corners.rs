//! Instants at which a right-hand side has a corner or a jump in time: steps end there, and each step sees the side that it is on.

use crate::control::smallest;
use crate::error::Failure;
use crate::rhs::RightHandSide;
use tripos_traits::Real;

/// An instant at which a right-hand side is not smooth in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// When, in s.
    pub at: f64,
    /// Whether it jumps there: steps to and from it see the side that they are on, at 8 ulp of t from it.
    pub jumps: bool,
}

/// The corners of a run, and how many of them are behind it.
#[derive(Clone, Default)]
pub(crate) struct Corners {
    /// In the order in which the run comes to them.
    all: Vec<Corner>,
    /// 1 for a run forwards in time, −1 for one backwards.
    toward: f64,
    end: f64,
    behind: usize,
}

impl Corners {
    pub(crate) fn new(corners: &[Corner], (t0, t1): (f64, f64)) -> Self {
        let toward = (t1 - t0).signum();
        let mut all = corners.to_vec();
        all.sort_by(|a, b| (toward * a.at).total_cmp(&(toward * b.at)));
        Self { all, toward, end: t1, behind: 0 }
    }

    /// Leaves behind what lies at `t` or before it, but for less than a step may be; says whether something did.
    pub(crate) fn pass(&mut self, t: f64) -> bool {
        let before = self.behind;
        let least = smallest(t);
        while self.all.get(self.behind).is_some_and(|corner| self.toward * (corner.at - t) < least) {
            self.behind += 1;
        }
        self.behind > before
    }

    /// The next one before the end of the run.
    pub(crate) fn next(&self) -> Option<f64> {
        let next = self.all.get(self.behind).map(|corner| corner.at);
        next.filter(|corner| self.toward * (self.end - corner) >= smallest(self.end))
    }

    /// Between which instants the right-hand side is one function: just inside the jumps around.
    pub(crate) fn sides(&self) -> (f64, f64) {
        // Beyond what an argument such as `k*t - a` rounds to.
        let beside = |jump: &Corner, toward: f64| jump.at + toward * smallest(jump.at) / 2.0;
        let (behind, ahead) = self.all.split_at(self.behind);
        let behind = behind.iter().rfind(|corner| corner.jumps).map(|jump| beside(jump, self.toward));
        let ahead = ahead.iter().find(|corner| corner.jumps).map(|jump| beside(jump, -self.toward));
        let (low, high) = if self.toward > 0.0 { (behind, ahead) } else { (ahead, behind) };
        (low.unwrap_or(f64::NEG_INFINITY), high.unwrap_or(f64::INFINITY))
    }
}

/// A right-hand side between two jumps: at the jumps themselves it is what it is just inside.
pub(crate) struct Between<'a, R, S> {
    rhs: &'a mut R,
    /// The component of the state that is the time.
    clock: Option<usize>,
    sides: (f64, f64),
    /// A state of which the time is inside.
    state: Vec<S>,
}

impl<'a, R, S: Real> Between<'a, R, S> {
    pub(crate) fn new(rhs: &'a mut R, clock: Option<usize>, sides: (f64, f64)) -> Self {
        Self { rhs, clock, sides, state: Vec::new() }
    }

    /// Goes on between other jumps.
    pub(crate) fn enter(&mut self, sides: (f64, f64)) {
        self.sides = sides;
    }

    /// Asks the right-hand side at an instant and a state that are inside.
    #[inline]
    fn ask<T>(&mut self, t: f64, y: &[S], question: impl FnOnce(&mut R, f64, &[S]) -> T) -> T {
        let (low, high) = self.sides;
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
}

impl<S: Real, R: RightHandSide<S>> RightHandSide<S> for Between<'_, R, S> {
    #[inline]
    fn rhs(&mut self, t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure> {
        self.ask(t, y, |rhs, t, y| rhs.rhs(t, y, dydt))
    }

    fn jacobian(&mut self, t: f64, y: &[S], out: &mut [S]) -> Option<Result<(), Failure>> {
        self.ask(t, y, |rhs, t, y| rhs.jacobian(t, y, out))
    }

    #[inline]
    fn taylor(&mut self, t: f64, order: usize, x: &mut [S]) -> Option<Result<(), Failure>> {
        self.rhs.taylor(t.max(self.sides.0).min(self.sides.1), order, x)
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
    }

    fn inertia(&mut self, t: f64, y: &[S], out: &mut Vec<f64>) -> bool {
        self.ask(t, y, |rhs, t, y| rhs.inertia(t, y, out))
    }

    fn avoids(&mut self, t: f64, y: &[S]) -> bool {
        self.ask(t, y, RightHandSide::avoids)
    }

    fn hands_over(&mut self, t: f64, y: Option<&[S]>) -> bool {
        self.rhs.hands_over(t, y)
    }

    fn power(&mut self, t: f64, y: &[S]) -> Option<f64> {
        self.ask(t, y, RightHandSide::power)
    }
}
