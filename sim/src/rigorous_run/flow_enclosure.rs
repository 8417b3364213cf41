//! Enclosure of the motion over one step, by Taylor polynomials with proved rests.
//!
//! Method: N. S. Nedialkov, K. R. Jackson & J. D. Pryce, "An effective high-order interval method for validating
//! existence and uniqueness of the solution of an IVP for an ODE", Reliable Computing 7 (2001) 449–465. If
//! a box Y contains Σ_{k ≤ p} [0, h]^k x^[k](X) + [0, h]^(p+1) x^[p+1](Y), every motion from X exists over the
//! step and stays in Y.

use super::state_set::StateSet;
use tripos_traits::{Ball, Dual, Scalar, Series};

/// Taylor coefficients of a motion in three kinds of balls, which must belong to the same equations.
#[derive(Clone, Copy)]
pub struct SeriesInBalls<'a> {
    /// Coefficients with 32 digits, for the middle of a set of states.
    pub wide: &'a dyn Series<Ball>,
    /// Coefficients in doubles, for a whole set of states.
    pub narrow: &'a dyn Series<Ball<f64>>,
    /// Coefficients in doubles with their derivatives by the state.
    pub slopes: &'a dyn Series<Dual<Ball<f64>>>,
}

/// Equations of motion with their parameters, ready for steps of one order.
pub(crate) struct FlowEnclosure<'a> {
    /// Taylor coefficients of the motion.
    pub(crate) series: SeriesInBalls<'a>,
    /// Values of the parameters with 32 digits.
    pub(crate) parameters: &'a [Ball],
    /// Values of the parameters in doubles.
    pub(crate) narrow_parameters: Vec<Ball<f64>>,
    /// Highest power p of the time in the Taylor polynomials.
    pub(crate) order: usize,
}

/// Enclosure of all motions from a set of states over a step.
pub(crate) struct Tube {
    /// Box that contains the motions at all instants of the step.
    pub(crate) bounds: Vec<Ball<f64>>,
    /// Taylor coefficients of the motions at the start of the step, up to the order p, row by row.
    coefficients: Vec<Ball<f64>>,
    /// Coefficients of order p + 1 of all motions at all instants of the step.
    last: Vec<Ball<f64>>,
}

impl Tube {
    /// Box that contains the motions at all instants between two instants of the step, s after its start.
    ///
    /// The polynomial is bounded by its value in the middle and by the range of its derivative.
    pub(crate) fn bounds_between(&self, from: f64, to: f64) -> Vec<Ball<f64>> {
        let n = self.last.len();
        let time = Ball::between(from, to);
        let middle = Ball::point(time.centre);
        let highest = self.coefficients.len() / n.max(1);
        let power = time.powi(i32::try_from(highest).unwrap_or(i32::MAX));
        let value = |at: usize| {
            let (mut value, mut slope) = (Ball::point(0.0), Ball::point(0.0));
            for k in (0..highest).rev() {
                let coefficient = self.coefficients[k * n + at];
                value = coefficient + middle * value;
                if k > 0 {
                    slope = Ball::point(k as f64) * coefficient + time * slope;
                }
            }
            let moved = Ball::around(0.0, time.radius) * slope;
            value + moved + power * self.last[at]
        };
        (0..n).map(value).collect()
    }
}

impl FlowEnclosure<'_> {
    /// For each component, true if its rate is the same exact number in all states, like that of the time.
    pub(crate) fn moves_alike(&self, state: &[Ball]) -> Vec<bool> {
        let wide: Vec<Ball<f64>> = state.iter().map(|x| Ball::narrowed(*x).widened(1.0)).collect();
        let coefficients = taylor(self.series.narrow, &self.narrow_parameters, 2, &wide);
        let n = state.len();
        (0..n).map(|at| (1..=2).all(|k| coefficients[k * n + at].radius == 0.0)).collect()
    }

    /// Encloses all motions from a box over a step of `h` seconds. `None` if no enclosure is proved, because the
    /// step is too long or because the motions may end.
    pub(crate) fn tube(&self, start: &[Ball<f64>], h: f64) -> Option<Tube> {
        let (n, p) = (start.len(), self.order);
        let coefficients = taylor(self.series.narrow, &self.narrow_parameters, p, start);
        let time = Ball::between(0.0, h);
        let mut inner = coefficients[p * n..].to_vec();
        for row in coefficients[..p * n].chunks(n).rev() {
            for (x, coefficient) in inner.iter_mut().zip(row) {
                *x = *coefficient + time * *x;
            }
        }
        // The rest has room for a small part of the motion's width. It will be far smaller.
        let room = |x: &Ball<f64>| 1e-3 * x.radius + 1e-12 * x.size() + f64::MIN_POSITIVE;
        let bounds: Vec<Ball<f64>> = inner.iter().map(|x| x.widened(room(x))).collect();
        let mut last = taylor(self.series.narrow, &self.narrow_parameters, p + 1, &bounds);
        let last = last.split_off((p + 1) * n);
        // Ranges of powers of the time from 0: [0, h^(p + 1)].
        let power = Ball::<f64>::point(h).powi(i32::try_from(p + 1).ok()?).high();
        let is_proved = inner.iter().zip(&last).zip(&bounds).all(|((x, last), bound)| {
            let rest = Ball::between(0.0, power) * *last;
            rest.is_defined() && bound.contains(*x + rest)
        });
        is_proved.then_some(Tube { bounds, coefficients, last })
    }

    /// Rest of the Taylor polynomials after a step of `h` seconds, for motions in a tube.
    pub(crate) fn rest(&self, tube: &Tube, h: Ball) -> Vec<Ball<f64>> {
        let power = Ball::<f64>::narrowed(h.powi(i32::try_from(self.order + 1).unwrap_or(i32::MAX)));
        tube.last.iter().map(|last| power * *last).collect()
    }

    /// Set of all states after a step of `h` seconds from a set whose motions are in a tube.
    pub(crate) fn advanced(&self, set: &StateSet, h: Ball, rest: &[Ball<f64>]) -> StateSet {
        let (n, p) = (set.centre.len(), self.order);
        let centre: Vec<Ball> = set.centre.iter().map(|c| Ball::point(*c)).collect();
        let coefficients = taylor(self.series.wide, self.parameters, p, &centre);
        let mut image: Vec<Ball> = coefficients[p * n..].to_vec();
        for row in coefficients[..p * n].chunks(n).rev() {
            for (x, coefficient) in image.iter_mut().zip(row) {
                *x = *coefficient + h * *x;
            }
        }
        for (x, rest) in image.iter_mut().zip(rest) {
            *x = *x + rest.wide();
        }
        set.image(&image, &self.jacobian(set, Ball::narrowed(h)))
    }

    /// Derivatives of the Taylor polynomials after a step by the state at its start, row by row, for all states of
    /// a set.
    fn jacobian(&self, set: &StateSet, h: Ball<f64>) -> Vec<Ball<f64>> {
        let (n, p) = (set.centre.len(), self.order);
        let parameters: Vec<_> = self.narrow_parameters.iter().map(|x| Dual::constant(*x)).collect();
        let bounds: Vec<Ball<f64>> = set.bounds().iter().map(|x| Ball::narrowed(*x)).collect();
        let mut out = vec![Ball::point(0.0); n * n];
        for column in 0..n {
            let state: Vec<Dual<Ball<f64>>> = (bounds.iter().enumerate())
                .map(|(at, value)| Dual { value: *value, slope: Ball::int(i64::from(at == column)) })
                .collect();
            let coefficients = taylor(self.series.slopes, &parameters, p, &state);
            for row in 0..n {
                let terms = (0..=p).rev().map(|k| coefficients[k * n + row].slope);
                out[row * n + column] = terms.fold(Ball::point(0.0), |sum, term| term + h * sum);
            }
        }
        out
    }
}

/// Taylor coefficients of the motion from a state up to an order, row by row: row k has those of order k.
fn taylor<S: Scalar>(series: &dyn Series<S>, p: &[S], order: usize, state: &[S]) -> Vec<S> {
    let n = state.len();
    let mut x = vec![S::int(0); (order + 1) * n];
    x[..n].copy_from_slice(state);
    let mut work = vec![S::int(0); series.taylor_work(order)];
    series.taylor(p, order, &mut x, &mut work);
    x
}
