//! Limits of runs: the growth of small errors, the time after which no correct digit is left, and the trend of a drift.
//!
//! Absent on purpose: models and references. Any right-hand side can be examined; with a Jacobian the results are more
//! exact.

use crate::driver::integrate::integrate;
use crate::error::{Failure, SimError};
use crate::methods::run_options::{Options, OutputOption};
use crate::right_hand_side::{LentRightHandSide, RightHandSide};
use crate::solution::Stop;
use tripos_traits::largest;

/// Growth of a small error at the start of a run, as a function of time.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorGrowth {
    /// Times at which the growth is known, s.
    pub times: Vec<f64>,
    /// Logarithm ln(|w(t)| / |w(t0)|) at each of the times, for a solution w of the linearized equations. The size |w|
    /// is the largest quotient |wᵢ| / (1 + |yᵢ|) of a component.
    pub logarithms: Vec<f64>,
    /// Reason why the run that computed the growth ended.
    pub stop: Stop,
}

impl ErrorGrowth {
    /// Time from which on the error is 1 or more, s, so that no correct digit is left. `None` if digits are left at the
    /// end of the run.
    ///
    /// `size(t)` is the relative error that the run has made up to time t, before it grows. Errors that grow to 1 and
    /// shrink again, as near a singular surface, do not count.
    #[must_use]
    pub fn horizon(&self, size: impl Fn(f64) -> f64) -> Option<f64> {
        let lost = |(t, l): &(&f64, &f64)| size(**t).ln() + **l >= 0.0;
        let beyond = self.times.iter().zip(&self.logarithms).rev().take_while(lost).count();
        let first = self.times.len() - beyond;
        self.times.get(first).copied()
    }

    /// Rate of exponential growth of a small error, 1/s: the slope of ln |w|, fitted by least squares over the second
    /// half of the times.
    #[must_use]
    pub fn rate(&self) -> f64 {
        let half = self.times.len() / 2;
        least_squares_slope(&self.times[half..], &self.logarithms[half..])
    }
}

/// Slope of the straight line that fits the points (x, y) best by least squares. NaN for fewer than two points.
#[must_use]
pub fn least_squares_slope(x: &[f64], y: &[f64]) -> f64 {
    let n = x.len().min(y.len()) as f64;
    let mean = |list: &[f64]| list.iter().sum::<f64>() / n;
    let (mx, my) = (mean(x), mean(y));
    let (mut above, mut below) = (0.0, 0.0);
    for (x, y) in x.iter().zip(y) {
        above += (x - mx) * (y - my);
        below += (x - mx) * (x - mx);
    }
    above / below
}

/// Integrates the equations together with their linearization w' = J(y) w from w(t0) = `direction`, and
/// returns the growth of w.
///
/// The length of w is kept constant, and the logarithm of its growth is integrated separately, so that
/// no growth overflows. Without a Jacobian, J w is a central difference of the right-hand side.
///
/// # Errors
/// [`SimError`] in the cases in which [`integrate`] returns it.
pub fn error_growth(
    rhs: &mut dyn RightHandSide<f64>,
    span: (f64, f64),
    y0: &[f64],
    direction: &[f64],
    options: &Options,
) -> Result<ErrorGrowth, SimError> {
    let n = y0.len();
    // A state without components has no error that could grow.
    if n == 0 {
        return Ok(ErrorGrowth { times: Vec::new(), logarithms: Vec::new(), stop: Stop::End });
    }
    let mut slope = JacobianProduct::new(n);
    let length = size_of_growing_error(direction, y0);
    let start: Vec<f64> = y0.iter().copied().chain(direction.iter().map(|w| w / length)).chain([0.0]).collect();
    // y' = f, w' = J w − r w, l' = r with r = (w · J w) / (w · w): w keeps its length, and l is the logarithm of the
    // removed factor.
    let mut joined = |t: f64, z: &[f64], dz: &mut [f64]| -> Result<(), Failure> {
        let (y, w) = (&z[..n], &z[n..2 * n]);
        rhs.rhs(t, y, &mut dz[..n])?;
        slope.jacobian_product(rhs, t, y, w, &mut dz[n..2 * n])?;
        let along: f64 = w.iter().zip(&dz[n..]).map(|(w, change)| w * change).sum();
        let rate = along / w.iter().map(|w| w * w).sum::<f64>();
        for i in 0..n {
            dz[n + i] -= rate * w[i];
        }
        dz[2 * n] = rate;
        Ok(())
    };
    let options = Options { output: OutputOption::Steps { refine: 1 }, ..options.clone() };
    let solution =
        integrate(LentRightHandSide(&mut joined as &mut dyn RightHandSide<f64>), span, &start, &options, &mut [])?;
    let logarithms = solution.y.iter().map(|z| z[2 * n] + size_of_growing_error(&z[n..2 * n], &z[..n]).ln()).collect();
    Ok(ErrorGrowth { times: solution.t, logarithms, stop: solution.stop })
}

/// Working space for the product J w of a Jacobian and a vector.
struct JacobianProduct {
    /// Jacobian ∂f/∂y, n² entries, row by row, for a state of n components.
    jacobian: Vec<f64>,
    /// Values of f at y + h w, for a central difference.
    ahead: Vec<f64>,
    /// Values of f at y − h w, for a central difference.
    behind: Vec<f64>,
    /// State y + h w or y − h w, at which f is evaluated for a central difference.
    place: Vec<f64>,
}

impl JacobianProduct {
    /// Creates the working space for a state of `n` components.
    fn new(n: usize) -> Self {
        Self { jacobian: vec![0.0; n * n], ahead: vec![0.0; n], behind: vec![0.0; n], place: vec![0.0; n] }
    }

    /// Writes the product J(t, y) w of the Jacobian and a vector to `out`. Without a Jacobian a central
    /// difference of f is used. Error if f or J has no value.
    fn jacobian_product(
        &mut self,
        rhs: &mut dyn RightHandSide<f64>,
        t: f64,
        y: &[f64],
        w: &[f64],
        out: &mut [f64],
    ) -> Result<(), Failure> {
        if let Some(known) = rhs.jacobian(t, y, &mut self.jacobian) {
            known?;
            let n = y.len();
            for (i, out) in out.iter_mut().enumerate() {
                *out = self.jacobian[i * n..(i + 1) * n].iter().zip(w).map(|(j, w)| j * w).sum();
            }
            return Ok(());
        }
        // The cube root of ε balances the rounding error against the truncation error of a central difference.
        let h = f64::EPSILON.cbrt() / size_of_growing_error(w, y).max(f64::MIN_POSITIVE);
        for (step, into) in [(h, &mut self.ahead), (-h, &mut self.behind)] {
            for ((place, y), w) in self.place.iter_mut().zip(y).zip(w) {
                *place = y + step * w;
            }
            rhs.rhs(t, &self.place, into)?;
        }
        for ((out, ahead), behind) in out.iter_mut().zip(&self.ahead).zip(&self.behind) {
            *out = (ahead - behind) / (2.0 * h);
        }
        Ok(())
    }
}

/// Size of an error w of a state y: the largest quotient |wᵢ| / (1 + |yᵢ|).
fn size_of_growing_error(w: &[f64], y: &[f64]) -> f64 {
    largest(w.iter().zip(y).map(|(w, y)| w / (1.0 + y.abs())))
}

/// Trend of the drift of a first integral, such as the energy, along a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trend {
    /// The drift at the end of the run is at most three times that at its beginning.
    Bounded,
    /// The drift grows for as long as the run goes on.
    Secular,
}

/// Judges the drift of a first integral from samples of |drift| along a run. The drift is secular if
/// the largest sample of the last tenth is more than three times the largest of the first tenth.
#[must_use]
pub fn drift_trend(drifts: &[f64]) -> Trend {
    let tenth = drifts.len().div_ceil(10);
    let largest = |part: &[f64]| largest(part.iter().copied());
    let (early, late) = (largest(&drifts[..tenth]), largest(&drifts[drifts.len() - tenth..]));
    if late <= 3.0 * early { Trend::Bounded } else { Trend::Secular }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::right_hand_side::WithJacobian;

    /// Truth: small errors at the saddle x'' = x/4 grow with the rate 1/2.
    #[test]
    fn a_saddle_grows_with_its_eigenvalue() {
        let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
            (dydt[0], dydt[1]) = (y[1], 0.25 * y[0]);
            Ok(())
        };
        let jacobian = |_t: f64, _y: &[f64], out: &mut [f64]| {
            out.copy_from_slice(&[0.0, 1.0, 0.25, 0.0]);
            Ok(())
        };
        let options = Options { rtol: 1e-9, ..Options::default() };
        let mut both = WithJacobian { rhs, jacobian };
        let found = error_growth(&mut both, (0.0, 2000.0), &[0.0, 0.0], &[1.0, 0.0], &options).unwrap();
        assert!((found.rate() - 0.5).abs() < 1e-6, "{}", found.rate());
        // cosh(t/2) = 1e10 at t = 2 ln 2e10.
        let horizon = found.horizon(|_| 1e-10).unwrap();
        assert!((horizon / (2.0 * 2e10_f64.ln()) - 1.0).abs() < 0.1, "{horizon}");
        let mut bare = |_t: f64, y: &[f64], dydt: &mut [f64]| {
            (dydt[0], dydt[1]) = (y[1], 0.25 * y[0]);
            Ok(())
        };
        let found = error_growth(&mut bare, (0.0, 2000.0), &[0.0, 0.0], &[1.0, 0.0], &options).unwrap();
        assert!((found.rate() - 0.5).abs() < 1e-6, "by differences: {}", found.rate());
    }

    #[test]
    fn a_drift_that_swings_is_bounded_and_one_that_grows_is_not() {
        let swings: Vec<f64> = (0..1000).map(|i| (0.1 * f64::from(i)).sin()).collect();
        let grows: Vec<f64> = (0..1000).map(|i| 1e-6 * f64::from(i)).collect();
        assert_eq!((drift_trend(&swings), drift_trend(&grows)), (Trend::Bounded, Trend::Secular));
        assert_eq!(drift_trend(&[]), Trend::Bounded);
    }

    #[test]
    fn a_drift_that_is_no_number_is_not_called_bounded() {
        let mut drifts = vec![1e-15; 40];
        assert_eq!(drift_trend(&drifts), Trend::Bounded);
        drifts[39] = f64::NAN;
        assert_eq!(drift_trend(&drifts), Trend::Secular);
    }
}
