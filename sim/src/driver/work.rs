//! Work of the forces in a run: the integral of their power along the accepted steps. It has no effect on the steps.
//!
//! The integral is computed by Gauss–Legendre quadrature on the dense output, from sample to sample: NIST Digital
//! Library of Mathematical Functions, §3.5(v). With five points its error is of a higher order than that of every
//! method except Taylor's. The steps of Taylor's method are a small part of the radius of convergence of its series.

use tripos_traits::Real;

use crate::dense_output::Interpolant;
use crate::right_hand_side::RightHandSide;

/// Points of five-point Gauss–Legendre quadrature on the interval from 0 to 1, each with its weight.
const POINTS: [(f64, f64); 5] = [
    (0.046_910_077_030_668_0, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_23),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_23),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// Work of the forces along a run, up to a place inside the current step.
pub(crate) struct Work<S> {
    /// Work from the start of the run up to the fraction `up_to` of the current step, J.
    pub(crate) done: f64,
    /// Fraction of the current step up to which the power has been integrated.
    up_to: f64,
    /// Working space for a state inside a step, at which the power is evaluated.
    y: Vec<S>,
}

impl<S: Real> Work<S> {
    /// Creates the work of a run at its start (t, y), 0 J. `None` if the right-hand side defines no power.
    pub(crate) fn new<R: RightHandSide<S>>(rhs: &mut R, t: f64, y: &[S]) -> Option<Self> {
        rhs.power(t, y).map(|_| Self { done: 0.0, up_to: 0.0, y: y.to_vec() })
    }

    /// Integrates the power up to the fraction `to` of the step. Returns the work done from the start of
    /// the run up to there, J.
    pub(crate) fn work_up_to<R: RightHandSide<S>>(
        &mut self,
        rhs: &mut R,
        step: &impl Interpolant<Real = S>,
        to: f64,
    ) -> f64 {
        let (t, t_new) = step.span();
        let (from, part) = (self.up_to, to - self.up_to);
        if part <= 0.0 {
            return self.done;
        }
        for (point, weight) in POINTS {
            let theta = from + point * part;
            step.dense_output(S::from_f64(theta), |i, x| self.y[i] = x);
            let power = rhs.power(t + theta * (t_new - t), &self.y).unwrap_or(f64::NAN);
            self.done += weight * part * (t_new - t) * power;
        }
        self.up_to = to;
        self.done
    }

    /// Moves to the start of the next step. The power must be integrated to the end of the current step before.
    pub(crate) fn accept(&mut self) {
        self.up_to = 0.0;
    }
}

#[cfg(test)]
mod tests {
    use crate::right_hand_side::AccompaniedRightHandSide;
    use crate::{Event, Method, Options, OutputOption, integrate};
    use tripos_traits::Direction;

    /// Truth: x″ = −x − c x′ with E = ½(x′² + x²) gives dE/dt = −c x′².
    #[test]
    fn the_energy_of_a_damped_oscillator_is_balanced_at_every_sample_and_its_end() {
        let c = 0.3;
        let times: Vec<f64> = (1..100).map(|i| 0.173 * f64::from(i)).collect();
        let outputs = [OutputOption::Ends, OutputOption::Steps { refine: 3 }, OutputOption::At(times)];
        for method in [Method::Rk4, Method::Ode45, Method::Dopri5, Method::Dop853] {
            for output in outputs.clone() {
                let mut rhs = |_t: f64, y: &[f64], out: &mut [f64]| {
                    (out[0], out[1]) = (y[1], -y[0] - c * y[1]);
                    Ok(())
                };
                let mut power = |_t: f64, y: &[f64]| -c * y[1] * y[1];
                let step = (method == Method::Rk4).then_some(1e-3);
                let options = Options { method, step, output, ..Options::tolerances(1e-10, 1e-10) };
                let low = |_t: f64, y: &[f64]| y[0] * y[0] + y[1] * y[1] - 0.01;
                let events = &mut [Event::terminal("low", Direction::Falling, low)];
                let with =
                    AccompaniedRightHandSide { rhs: &mut rhs, power: Some(&mut power), over: None, yields: None };
                let run = integrate(with, (0.0, 40.0), &[1.0, 0.0], &options, events).unwrap();
                assert_eq!(run.stop.code(), "event:low", "{method:?}");
                let energy = |y: &[f64]| 0.5 * (y[0] * y[0] + y[1] * y[1]);
                assert_eq!(run.work.len(), run.t.len());
                for (y, work) in run.y.iter().zip(&run.work).chain([(&run.y_end, &run.work_end)]) {
                    let off = energy(y) - 0.5 - work;
                    assert!(off.abs() < 2e-9, "{method:?} {:?}: {off:e}", options.output);
                }
                assert!(run.work_end < -0.4, "{}", run.work_end);
                let drift = run.energy_drift(run.y.iter().map(|y| energy(y)), energy(&run.y_end));
                assert!(drift < 4e-9, "{method:?} {:?}: {drift:e}", options.output);
            }
        }
    }

    #[test]
    fn the_steps_are_those_of_a_run_without() {
        let f = |_t: f64, y: &[f64], out: &mut [f64]| {
            (out[0], out[1]) = (y[1], -y[0].sin() - 0.1 * y[1]);
            Ok(())
        };
        let (mut rhs, mut power) = (f, |_t: f64, y: &[f64]| -0.1 * y[1] * y[1]);
        let options = Options { method: Method::Dop853, ..Options::tolerances(1e-8, 1e-8) };
        let plain = integrate(f, (0.0, 9.0), &[2.0, 0.0], &options, &mut []).unwrap();
        let with = AccompaniedRightHandSide { rhs: &mut rhs, power: Some(&mut power), over: None, yields: None };
        let watched = integrate(with, (0.0, 9.0), &[2.0, 0.0], &options, &mut []).unwrap();
        assert!(plain.work.is_empty() && watched.work.len() == watched.t.len());
        assert_eq!((plain.y, plain.t), (watched.y, watched.t));
    }
}
