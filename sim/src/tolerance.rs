//! How large an error a step may have: relative and absolute tolerances, and the norm they define.

use crate::error::SimError;
use crate::solution::Warning;

/// Absolute tolerance: the error that is acceptable in a component however small it is.
#[derive(Clone, Debug, PartialEq)]
pub enum AbsoluteTolerance {
    /// The same for every component.
    Uniform(f64),
    /// One for each component of the state, each in its own unit.
    Each(Vec<f64>),
}

impl AbsoluteTolerance {
    fn per_component(&self, n: usize) -> Result<Vec<f64>, SimError> {
        match self {
            Self::Uniform(atol) => Ok(vec![*atol; n]),
            Self::Each(atol) if atol.len() == n => Ok(atol.clone()),
            Self::Each(atol) => Err(SimError::Length { what: "absolute tolerances", expected: n, found: atol.len() }),
        }
    }
}

/// The smallest relative tolerance that is taken at its word, 100 ε, as in `ode45`.
pub const SMALLEST_RTOL: f64 = 100.0 * f64::EPSILON;

/// The test a step must pass: norm ≤ `tolerance`.
///
/// As in `ode45`, error eᵢ is divided by max(|yᵢ|, |yᵢ new|, atolᵢ / rtol) and the largest quotient
/// compared with rtol. Without a relative tolerance it is divided by atolᵢ and compared with 1.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ErrorTest {
    /// Largest acceptable norm.
    pub(crate) tolerance: f64,
    /// 1 if errors are relative to the state, else 0.
    magnitude_weight: f64,
    thresholds: Vec<f64>,
}

impl ErrorTest {
    /// # Errors
    /// [`SimError::Tolerance`] for a tolerance that is negative or not finite, or a component with
    /// none; [`SimError::Length`] for a wrong number of absolute tolerances.
    pub(crate) fn new(rtol: f64, atol: &AbsoluteTolerance, n: usize) -> Result<(Self, Option<Warning>), SimError> {
        if !(rtol.is_finite() && rtol >= 0.0) {
            let what = format!("relative tolerance {rtol} must be finite and not negative");
            return Err(SimError::Tolerance { what });
        }
        let mut thresholds = atol.per_component(n)?;
        for (i, &a) in thresholds.iter().enumerate() {
            if !(a.is_finite() && a >= 0.0) {
                let what = format!("absolute tolerance {a} of component {i} must be finite and not negative");
                return Err(SimError::Tolerance { what });
            }
            if a == 0.0 && rtol == 0.0 {
                let what = format!("component {i} has neither a relative nor an absolute tolerance");
                return Err(SimError::Tolerance { what });
            }
        }
        if rtol == 0.0 {
            return Ok((Self { tolerance: 1.0, magnitude_weight: 0.0, thresholds }, None));
        }
        let raised = rtol.max(SMALLEST_RTOL);
        let warning = (rtol < SMALLEST_RTOL).then_some(Warning::RtolRaised { from: rtol, to: raised });
        for a in &mut thresholds {
            *a /= raised;
        }
        Ok((Self { tolerance: raised, magnitude_weight: 1.0, thresholds }, warning))
    }

    /// maxᵢ |eᵢ| / wᵢ, the largest error by its weight. An error of exactly 0 counts as 0 even
    /// where the weight is 0.
    pub(crate) fn norm(&self, error: &[f64], y: &[f64], y_new: &[f64]) -> f64 {
        let mut norm = 0.0_f64;
        for (i, &e) in error.iter().enumerate() {
            if e.is_nan() {
                return f64::NAN;
            }
            if e != 0.0 {
                norm = norm.max(e.abs() / self.weight(i, y[i].abs().max(y_new[i].abs())));
            }
        }
        norm
    }

    /// maxᵢ |y′ᵢ| / wᵢ, leaving out components without a weight: there is nothing to
    /// compare them with, and the error test will see to them after the first step.
    pub(crate) fn slope_norm(&self, slope: &[f64], y: &[f64]) -> f64 {
        slope
            .iter()
            .enumerate()
            .map(|(i, s)| (s.abs(), self.weight(i, y[i].abs())))
            .filter(|&(_, weight)| weight > 0.0)
            .fold(0.0, |norm: f64, (s, weight)| norm.max(s / weight))
    }

    fn weight(&self, i: usize, magnitude: f64) -> f64 {
        (self.magnitude_weight * magnitude).max(self.thresholds[i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_that_mean_nothing_are_refused() {
        let uniform = AbsoluteTolerance::Uniform;
        for (rtol, atol) in [
            (0.0, uniform(0.0)),
            (-1e-3, uniform(1e-6)),
            (f64::NAN, uniform(1e-6)),
            (1e-3, uniform(-1.0)),
            (1e-3, uniform(f64::NAN)),
            (f64::INFINITY, uniform(1e-6)),
            (0.0, AbsoluteTolerance::Each(vec![1e-6, 0.0])),
            (1e-3, AbsoluteTolerance::Each(vec![1e-6])),
        ] {
            assert!(ErrorTest::new(rtol, &atol, 2).is_err(), "{rtol} {atol:?}");
        }
    }

    #[test]
    fn an_absolute_tolerance_alone_is_compared_directly() {
        let (test, _) = ErrorTest::new(0.0, &AbsoluteTolerance::Each(vec![0.5, 0.25]), 2).unwrap();
        assert_eq!(test.norm(&[1.0, 1.0], &[100.0, 100.0], &[0.0, 0.0]), 4.0);
        assert_eq!(test.tolerance, 1.0);
    }

    #[test]
    fn a_component_at_rest_at_zero_needs_no_absolute_tolerance() {
        let (test, _) = ErrorTest::new(1e-3, &AbsoluteTolerance::Uniform(0.0), 1).unwrap();
        assert_eq!(test.norm(&[0.0], &[0.0], &[0.0]), 0.0);
        assert_eq!(test.norm(&[1.0], &[0.0], &[0.0]), f64::INFINITY);
    }
}
