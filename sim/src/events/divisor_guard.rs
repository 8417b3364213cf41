//! Guard of the divisors of equations, so that no step leads across a place where the equations have no value.
//!
//! Invariant: the steps are those of a run without a guard, up to the step in which a divisor changes its sign. The
//! divisors are evaluated once for each accepted step; zeros inside the step are found on the dense output.
//!
//! A divisor may touch zero without a change of sign, such as the distance of two points that meet. The run ends there
//! if f jumps, as a force along the line between the points does. The run goes on if f is continuous.
//!
//! The guard can miss a divisor that reaches zero and turns back within a step, if the divisor did not move towards
//! zero in the step before.

use tripos_traits::{Real, larger};

use super::root_and_minimum::{self, NotANumber};
use crate::dense_output::Interpolant;
use crate::right_hand_side::RightHandSide;

/// Place inside a step at which a divisor of the equations is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DivisorZero {
    /// Index of the divisor that is zero, from 0.
    pub(crate) divisor: usize,
    /// Fraction of the step at which the divisor is zero.
    pub(crate) theta: f64,
}

/// Distances from a zero of a divisor at which the size of f is examined, as fractions of a step.
const NEAR: [f64; 3] = [1e-4, 1e-8, 1e-12];
/// Two distances from a zero of a divisor at which f is compared on both sides, as fractions of a step. If f jumps, the
/// change of f is as large at the second distance as at the first.
const SIDES: [f64; 2] = [1e-4, 1e-6];
/// Largest value of a divisor that counts as touching zero, as a fraction of its value at the ends of the step. It is
/// small because a divisor may be the square of a distance.
const TOUCHED: f64 = 1e-12;
/// Smallest change of f across a zero of a divisor that counts as a jump, as a fraction of the largest component of f.
/// The quotient of rounding errors and a divisor stays below it.
const JUMP: f64 = 1e-7;
/// Factor by which f may be larger near a zero of a divisor than elsewhere in the step to count as bounded there.
const LARGE: f64 = 100.0;
/// Smallest size with which a component of f is compared, as a fraction of the largest component of f.
const SMALL: f64 = 1e-9;

/// Guard of a run's divisors, with their values at the ends of the last two steps.
pub(crate) struct DivisorGuard<S> {
    /// Values of the divisors at the start of the previous step, at the start of the current step, and at
    /// its end.
    values: [Vec<f64>; 3],
    /// Signed length of the previous step, s; `None` if the current step is the first.
    before: Option<f64>,
    /// Working space for the values of the divisors.
    out: Vec<S>,
    /// Working space for a state at which divisors are evaluated.
    y: Vec<S>,
}

impl<S: Real> DivisorGuard<S> {
    /// Creates the guard of the divisors of `rhs` at the start (t, y) of a run.
    pub(crate) fn new<R: RightHandSide<S>>(rhs: &mut R, t: f64, y: &[S]) -> Self {
        let count = rhs.divisor_count();
        let zeros = || vec![0.0; count];
        let values = [zeros(), zeros(), zeros()];
        let mut guard = Self { values, before: None, out: vec![S::from_f64(0.0); count], y: y.to_vec() };
        guard.evaluate(rhs, t);
        let [_, start, end] = &mut guard.values;
        start.clone_from(end);
        guard
    }

    /// True if the equations have no divisors.
    pub(crate) fn is_empty(&self) -> bool {
        self.out.is_empty()
    }

    /// Evaluates the divisors at the end of an accepted step. Returns true if a divisor may have been zero inside the
    /// step.
    pub(crate) fn suspects_divisor_zero<R: RightHandSide<S>>(
        &mut self,
        rhs: &mut R,
        step: &impl Interpolant<Real = S>,
    ) -> bool {
        let (t, t_new) = step.span();
        self.y.copy_from_slice(step.ends().1);
        self.evaluate(rhs, t_new);
        (0..self.out.len()).any(|at| self.is_suspect(at, t_new - t))
    }

    /// Finds the first zero of a divisor inside a suspected step. `None` if no divisor is zero there, or if
    /// f is bounded and continuous at the zero.
    pub(crate) fn first_divisor_zero<R: RightHandSide<S>>(
        &mut self,
        rhs: &mut R,
        step: &impl Interpolant<Real = S>,
    ) -> Option<DivisorZero> {
        let (t, t_new) = step.span();
        let suspects: Vec<usize> = (0..self.out.len()).filter(|at| self.is_suspect(*at, t_new - t)).collect();
        let found = suspects.into_iter().filter_map(|divisor| {
            let theta = self.locate_divisor_zero(rhs, step, divisor)?;
            (!self.motion_passes_zero(rhs, step, theta)).then_some(DivisorZero { divisor, theta })
        });
        found.min_by(|a, b| a.theta.total_cmp(&b.theta))
    }

    /// Moves to the next step, after an accepted step of this signed length, s.
    pub(crate) fn accept(&mut self, length: f64) {
        self.values.rotate_left(1);
        self.before = Some(length);
    }

    /// True if the divisor with index `at` changed its sign over the step of this signed length, s. Also true if the
    /// divisor would have changed its sign by a linear continuation of the previous step.
    fn is_suspect(&self, at: usize, length: f64) -> bool {
        let [before, start, end] = [0, 1, 2].map(|k| self.values[k][at]);
        if start == 0.0 || start.is_nan() || end.is_nan() {
            return false;
        }
        let goes_on = self.before.map_or(start, |h| start + (start - before) * (length / h));
        (end < 0.0) != (start < 0.0) || end == 0.0 || (goes_on < 0.0) != (start < 0.0)
    }

    /// Fraction of the step at which the suspected divisor with index `at` is first zero. `None` if it only
    /// came near zero, or passed through a pole.
    fn locate_divisor_zero<R: RightHandSide<S>>(
        &mut self,
        rhs: &mut R,
        step: &impl Interpolant<Real = S>,
        at: usize,
    ) -> Option<f64> {
        let (t, t_new) = step.span();
        let (start, end) = (self.values[1][at], self.values[2][at]);
        let side = start.signum();
        let mut value = |theta: f64| {
            step.dense_output(S::from_f64(theta), |i, x| self.y[i] = x);
            rhs.divisors(t + theta * (t_new - t), &self.y, &mut self.out);
            side * self.out[at].to_f64()
        };
        let touched = TOUCHED * start.abs().max(end.abs());
        let bottom = if end * side <= 0.0 {
            (1.0, end * side)
        } else {
            // A point without a value is not a minimum.
            root_and_minimum::minimum(&mut value, 0.0, 1.0, 0.0).ok().filter(|(_, least)| *least <= touched)?
        };
        if bottom.1 > 0.0 {
            return Some(bottom.0);
        }
        let theta = match root_and_minimum::root_in_bracket(&mut value, (0.0, start * side), bottom, 0.0) {
            Ok(theta) | Err(NotANumber { at: theta }) => theta,
        };
        let there = value(theta).abs();
        (there <= start.abs().max(end.abs()) || there.is_nan()).then_some(theta)
    }

    /// True if the motion can pass a zero of a divisor at the fraction `zero` of the step: near it f is as large as
    /// elsewhere in the step, and does not jump.
    ///
    /// The dividend is zero there, too. It must be exactly zero, such as a speed that no force changes, because an
    /// error of the dividend would be divided by a vanishing divisor.
    fn motion_passes_zero<R: RightHandSide<S>>(
        &mut self,
        rhs: &mut R,
        step: &impl Interpolant<Real = S>,
        zero: f64,
    ) -> bool {
        let (t, t_new) = step.span();
        let mut rates = |theta: f64| {
            let mut out = vec![S::from_f64(0.0); self.y.len()];
            step.dense_output(S::from_f64(theta), |i, x| self.y[i] = x);
            let known = rhs.rhs(t + theta * (t_new - t), &self.y, &mut out).is_ok();
            known.then(|| out.iter().map(|f| f.to_f64()).collect::<Vec<_>>())
        };
        let far: Vec<Vec<f64>> = [0.5 * zero, 0.5 + 0.5 * zero].into_iter().filter_map(&mut rates).collect();
        let far: Vec<Vec<f64>> = far.into_iter().map(|f| f.into_iter().map(f64::abs).collect()).collect();
        let next_to = NEAR.iter().flat_map(|d| [zero - d, zero + d]).filter(|theta| (0.0..=1.0).contains(theta));
        let largest = far.iter().flatten().copied().fold(0.0, larger);
        let is_bounded = |near: Vec<f64>| {
            near.iter().enumerate().all(|(i, f)| {
                let own = far.iter().map(|far| far[i]).fold(SMALL * largest, larger);
                *f <= LARGE * own
            })
        };
        let jumps = |by: [f64; 2]| by[1] > 0.5 * by[0] && by[1] > JUMP * largest;
        let sides = SIDES.map(|d| [zero - d, zero + d].map(|theta| rates(theta.clamp(0.0, 1.0))));
        let is_smooth = match sides {
            [[Some(a), Some(b)], [Some(c), Some(d)]] => {
                (0..a.len()).all(|i| !jumps([(a[i] - b[i]).abs(), (c[i] - d[i]).abs()]))
            }
            _ => false,
        };
        let sizes = |f: Vec<f64>| f.into_iter().map(f64::abs).collect::<Vec<_>>();
        is_smooth && far.len() == 2 && next_to.into_iter().all(|theta| rates(theta).map(sizes).is_some_and(is_bounded))
    }

    /// Evaluates the divisors at time `t`, s, and state `self.y`, and stores them as the values at the end
    /// of the step.
    fn evaluate<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64) {
        rhs.divisors(t, &self.y, &mut self.out);
        for (value, out) in self.values[2].iter_mut().zip(&self.out) {
            *value = out.to_f64();
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::{Failure, Method, Options, RightHandSide, Stop, integrate};

    /// Equations x′ = v/x and v′ = 1/4, which divide by x.
    struct Point;

    impl RightHandSide for Point {
        fn rhs(&mut self, _t: f64, y: &[f64], out: &mut [f64]) -> Result<(), Failure> {
            (out[0], out[1]) = (y[1] / y[0], 0.25);
            Ok(())
        }
        fn divisor_count(&self) -> usize {
            1
        }
        fn divisors(&mut self, _t: f64, y: &[f64], out: &mut [f64]) {
            out[0] = y[0];
        }
        fn divisor_name(&self, _at: usize) -> String {
            "x".to_owned()
        }
    }

    /// Truth: with v = x/2 at the start, the motion is x = −1 + t/2, and the rate is 0/0 at t = 2. With v lower by
    /// 1e-9, x² = (1 − t/2)² − 2e-9 t: there is no motion beyond t = 2 − 9e-5.
    #[test]
    fn a_run_ends_where_a_divisor_changes_its_sign() {
        for method in [Method::Ode45, Method::Dopri5, Method::Dop853] {
            let options = Options { method, ..Options::tolerances(1e-6, 1e-9) };
            let run = integrate(Point, (0.0, 10.0), &[-1.0, -0.5 - 1e-9], &options, &mut []).unwrap();
            let ended = matches!(&run.stop, Stop::Singular { divisor } if divisor == "x")
                || matches!(run.stop, Stop::StepTooSmall { .. } | Stop::NotFinite { .. });
            assert!(ended && run.t_end < 3.0 && run.y_end[0] < 1e-3, "{method:?}: {:?} {:?}", run.stop, run.y_end);
        }
    }

    /// Right-hand side from a closure that divides by the first component of the state.
    struct Watched<F>(F);
    impl<F: FnMut(f64, &[f64], &mut [f64]) -> Result<(), Failure>> RightHandSide for Watched<F> {
        fn rhs(&mut self, t: f64, y: &[f64], out: &mut [f64]) -> Result<(), Failure> {
            (self.0)(t, y, out)
        }
        fn divisor_count(&self) -> usize {
            1
        }
        fn divisors(&mut self, _t: f64, y: &[f64], out: &mut [f64]) {
            out[0] = y[0];
        }
    }

    /// Truth: x = 1 − t passes the zero of its divisor if the dividend is exactly 0, and ends there if it is 1e-9.
    #[test]
    fn what_passes_with_bounded_rates_goes_on() {
        let rhs = |_t: f64, y: &[f64], out: &mut [f64]| {
            (out[0], out[1]) = (-1.0, y[1] / y[0]);
            Ok(())
        };
        for (start, passes) in [(0.0, true), (1e-9, false)] {
            let options = Options { method: Method::Dop853, ..Options::tolerances(1e-6, 1e-9) };
            let run = integrate(Watched(rhs), (0.0, 2.0), &[1.0, start], &options, &mut []).unwrap();
            assert_eq!(run.stop == Stop::End, passes, "{:?}", run.stop);
        }
    }
    /// Truth: a mass is pulled by k (d − l) towards a point at the distance d, which is a divisor. The force jumps when
    /// the mass comes to the point, and every method reports it. With l = 0 the mass passes through.
    #[test]
    fn a_force_along_a_distance_that_vanishes_ends_the_run() {
        struct Spring(f64);
        impl RightHandSide for Spring {
            fn rhs(&mut self, _t: f64, y: &[f64], out: &mut [f64]) -> Result<(), Failure> {
                let d = (y[0] * y[0] + y[2] * y[2]).sqrt();
                let pull = -3.0 * (d - self.0) / d;
                (out[0], out[1], out[2], out[3]) = (y[1], pull * y[0], y[3], pull * y[2]);
                Ok(())
            }
            fn divisor_count(&self) -> usize {
                1
            }
            fn divisors(&mut self, _t: f64, y: &[f64], out: &mut [f64]) {
                out[0] = y[0] * y[0] + y[2] * y[2];
            }
            fn divisor_name(&self, _at: usize) -> String {
                "d".to_owned()
            }
        }
        for method in [Method::Ode45, Method::Dopri5, Method::Dop853] {
            for (free_length, passes) in [(0.0, true), (0.01, false), (0.3, false)] {
                let options = Options { method, ..Options::tolerances(1e-8, 1e-10) };
                let run =
                    integrate(Spring(free_length), (0.0, 10.0), &[1.0, 0.0, 0.7, 0.0], &options, &mut []).unwrap();
                assert_eq!(run.stop == Stop::End, passes, "{method:?} {free_length}: {:?} at {}", run.stop, run.t_end);
            }
        }
    }

    /// Truth: the first step leads across a zero of the divisor. No earlier step can warn of it, so that the zero must
    /// be found from the divisor's values at the ends of the first step.
    #[test]
    fn a_first_step_that_leads_across_ends_the_run_inside_it() {
        let rhs = |_t: f64, y: &[f64], out: &mut [f64]| {
            (out[0], out[1]) = (-1.0, 1.0 / y[0]);
            Ok(())
        };
        let options = Options { method: Method::Rk4, step: Some(1.5), ..Options::default() };
        let run = integrate(Watched(rhs), (0.0, 3.0), &[1.0, 0.0], &options, &mut []).unwrap();
        assert!(matches!(run.stop, Stop::Singular { .. }) && (run.t_end - 1.0).abs() < 1e-9, "{run:?}");
    }
}
