//! Error test of a step: relative and absolute tolerances, and the weighted norm of the error that they
//! define.

use tripos_traits::{AbsoluteTolerance, Lanes, Real, Scalar, larger_or_second};

use crate::blocks::LANES;
use crate::error::SimError;
use crate::warning::Warning;

/// Smallest relative tolerance of a run in `f64`, 100 ε, as in `ode45`. Smaller tolerances are raised to it. Other
/// scalar types use their own ε.
pub const SMALLEST_RTOL: f64 = 100.0 * f64::EPSILON;

/// Norm that joins the weighted errors of all components of the state into one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Norm {
    /// Largest weighted error of a component. As in `ode45`, error eᵢ is divided by max(|yᵢ|, |yᵢ new|,
    /// atolᵢ / rtol) and compared with rtol. Without a relative tolerance it is divided by atolᵢ and
    /// compared with 1.
    Largest,
    /// Root of the mean square of all weighted errors. As in Hairer's codes, error eᵢ is divided by atolᵢ + rtol
    /// max(|yᵢ|, |yᵢ new|) and compared with 1.
    MeanSquare,
}

/// Error test that a step must pass: the weighted norm of its error is at most `tolerance`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ErrorTest {
    /// Norm that joins the weighted errors of all components.
    norm: Norm,
    /// Largest norm of an error that passes the test, without unit.
    pub(crate) tolerance: f64,
    /// Factor of the component's absolute value |y| in the weight by which its error is divided.
    relative: f64,
    /// Part of each component's weight that does not depend on |y|, in the component's unit. Padded with further
    /// entries to whole blocks.
    absolute: Vec<f64>,
}

impl ErrorTest {
    /// Creates the error test for `n` components, with a warning if the relative tolerance was raised.
    ///
    /// # Errors
    /// [`SimError::Tolerance`] for a tolerance that is negative or not finite, or a component without a tolerance;
    /// [`SimError::Length`] for a wrong number of absolute tolerances.
    pub(crate) fn new<S: Real>(
        norm: Norm,
        rtol: f64,
        atol: &AbsoluteTolerance,
        n: usize,
    ) -> Result<(Self, Option<Warning>), SimError> {
        check_relative(rtol)?;
        let mut absolute = tolerance_per_component(atol, n)?;
        for (i, &a) in absolute.iter().enumerate() {
            check_absolute(i, a, rtol)?;
        }
        absolute.resize(n.next_multiple_of(LANES), 1.0);
        if rtol == 0.0 {
            return Ok((Self { norm, tolerance: 1.0, relative: 0.0, absolute }, None));
        }
        let smallest = 100.0 * S::EPSILON;
        let raised = rtol.max(smallest);
        let warning = (rtol < smallest).then_some(Warning::RtolRaised { from: rtol, to: raised });
        let test = match norm {
            Norm::Largest => {
                for a in &mut absolute {
                    *a /= raised;
                }
                Self { norm, tolerance: raised, relative: 1.0, absolute }
            }
            Norm::MeanSquare => {
                for a in &mut absolute {
                    *a = a.max(f64::MIN_POSITIVE);
                }
                Self { norm, tolerance: 1.0, relative: raised, absolute }
            }
        };
        Ok((test, warning))
    }

    /// Weighted norm of the error of a step from state `y` to `y_new`. An error of exactly 0 counts as 0, even if the
    /// weight of its component is 0. NaN if an error is NaN.
    pub(crate) fn norm<S: Real>(&self, error: &[S], y: &[S], y_new: &[S]) -> f64 {
        match self.norm {
            Norm::Largest => self.largest_weighted_error(error, y, y_new),
            Norm::MeanSquare => {
                let mut sum = 0.0;
                for (i, e) in error.iter().enumerate() {
                    let quotient =
                        e.to_f64() / self.weight(i, larger_or_second(y[i].to_f64().abs(), y_new[i].to_f64().abs()));
                    sum += quotient * quotient;
                }
                (sum / error.len().max(1) as f64).sqrt()
            }
        }
    }

    /// Largest weighted error of a step from `y` to `y_new`: the norm for [`Norm::Largest`].
    fn largest_weighted_error<S: Real>(&self, error: &[S], y: &[S], y_new: &[S]) -> f64 {
        let mut norm = 0.0_f64;
        for (i, e) in error.iter().enumerate() {
            let e = e.to_f64();
            if e.is_nan() {
                return f64::NAN;
            }
            if e != 0.0 {
                norm = norm.max(e.abs() / self.weight(i, y[i].to_f64().abs().max(y_new[i].to_f64().abs())));
            }
        }
        norm
    }

    /// Largest quotients |xᵢ| / wᵢ for the two vectors x = `a` and x = `b` of finite numbers, with the weights w at
    /// state `y`. Components of weight 0 are left out; the error test of the step itself detects if they are too large.
    pub(crate) fn largest_weighted_of_two<S: Real>(&self, a: &[S], b: &[S], y: &[S]) -> [f64; 2] {
        let mut norms = [0.0; 2];
        for (((a, b), y), absolute) in a.iter().zip(b).zip(y).zip(&self.absolute) {
            let weight = larger_or_second(self.relative * y.to_f64().abs(), *absolute);
            let inverse = if weight > 0.0 { 1.0 / weight } else { 0.0 };
            norms = [
                larger_or_second(a.to_f64().abs() * inverse, norms[0]),
                larger_or_second(b.to_f64().abs() * inverse, norms[1]),
            ];
        }
        norms
    }

    /// Largest quotient |y′ᵢ| / wᵢ of a derivative y′ and the error test's weights at state `y`, 1/s. Components of
    /// weight 0 are left out, since the error test examines them after the first step.
    pub(crate) fn slope_norm<S: Real>(&self, slope: &[S], y: &[S]) -> f64 {
        self.weighted_quotients(slope, y).fold(0.0, f64::max)
    }

    /// Norm √Σᵢ (xᵢ / wᵢ)² of a vector `x` with the weights w at state `y`: a sum, not a mean. Hairer's codes choose
    /// the first step with this norm. Components of weight 0 are left out.
    pub(crate) fn weighted_root_sum<S: Real>(&self, x: &[S], y: &[S]) -> f64 {
        self.weighted_quotients(x, y).map(|q| q * q).sum::<f64>().sqrt()
    }

    /// Quotients |xᵢ| / wᵢ of a vector `x` and the weights at state `y`, without the components whose
    /// weight is 0.
    fn weighted_quotients<'a, S: Real>(&'a self, x: &'a [S], y: &'a [S]) -> impl Iterator<Item = f64> + 'a {
        x.iter()
            .enumerate()
            .map(|(i, x)| (x.to_f64().abs(), self.weight(i, y[i].to_f64().abs())))
            .filter(|&(_, weight)| weight > f64::MIN_POSITIVE)
            .map(|(x, weight)| x / weight)
    }

    /// Weight by which the error of component `i` of the state is divided, in the component's unit. `magnitude` is the
    /// absolute value |yᵢ| of the component.
    pub(crate) fn weight(&self, i: usize, magnitude: f64) -> f64 {
        match self.norm {
            Norm::Largest => (self.relative * magnitude).max(self.absolute[i]),
            Norm::MeanSquare => self.absolute[i] + self.relative * magnitude,
        }
    }

    /// Weights of a component of the state in N trajectories at once, for [`Norm::Largest`]. `absolute` is the part of
    /// the weight that does not depend on the component's absolute value `magnitude`.
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "two operations, also inside code for wider registers")]
    pub(crate) fn weight_in_lanes<const N: usize>(&self, absolute: f64, magnitude: Lanes<N>) -> Lanes<N> {
        (Lanes::from_f64(self.relative) * magnitude).larger_or_second(Lanes::from_f64(absolute))
    }

    /// True if the relative tolerance is 0, so that only absolute tolerances bound the error.
    pub(crate) fn is_absolute(&self) -> bool {
        self.relative == 0.0
    }

    /// Largest error that the absolute tolerance allows in component `i` of the state, in its unit.
    pub(crate) fn absolutely_allowed_error(&self, i: usize) -> f64 {
        self.tolerance * self.absolute[i]
    }

    /// Index of the component with the largest error over its weight, for a step from `y` to `y_new`;
    /// `None` if all errors are 0.
    pub(crate) fn component_of_largest_weighted_error<S: Real>(
        &self,
        error: impl Iterator<Item = S>,
        y: &[S],
        y_new: &[S],
    ) -> Option<usize> {
        let magnitude = |i: usize| y[i].to_f64().abs().max(y_new[i].to_f64().abs());
        let quotients = error.enumerate().map(|(i, e)| (i, e.to_f64().abs() / self.weight(i, magnitude(i))));
        quotients.filter(|(_, q)| *q > 0.0).max_by(|(_, p), (_, q)| p.total_cmp(q)).map(|(i, _)| i)
    }

    /// Parts of the components' weights that do not depend on |y|, in blocks like the blocks of the state.
    pub(crate) fn absolute_blocks(&self) -> &[[f64; LANES]] {
        self.absolute.as_chunks().0
    }

    /// Reciprocal weights of L components for [`Norm::MeanSquare`], for a step from `y` to `y_new`.
    /// `absolute` has the parts of the weights that do not depend on |y|.
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "a few operations on arrays, also inside code for wider registers")]
    pub(crate) fn inverse_weights<const L: usize>(
        &self,
        absolute: &[f64; L],
        y: &[f64; L],
        y_new: &[f64; L],
    ) -> [f64; L] {
        let mut weights = [0.0; L];
        for l in 0..L {
            weights[l] = 1.0 / (absolute[l] + self.relative * larger_or_second(y[l].abs(), y_new[l].abs()));
        }
        weights
    }

    /// Parts of the weights that do not depend on |y|, with an entry for each component and padding to whole blocks at
    /// the end.
    pub(crate) fn absolute_weights(&self) -> &[f64] {
        &self.absolute
    }
}

/// Returns the absolute tolerances as a list of `n` numbers. Error if the given list has another length.
fn tolerance_per_component(atol: &AbsoluteTolerance, n: usize) -> Result<Vec<f64>, SimError> {
    match atol {
        AbsoluteTolerance::Uniform(atol) => Ok(vec![*atol; n]),
        AbsoluteTolerance::Each(atol) if atol.len() == n => Ok(atol.clone()),
        AbsoluteTolerance::Each(atol) => {
            Err(SimError::Length { what: "absolute tolerances", expected: n, found: atol.len() })
        }
    }
}

/// Refuses a relative tolerance that is negative or not finite.
fn check_relative(rtol: f64) -> Result<(), SimError> {
    if rtol.is_finite() && rtol >= 0.0 {
        return Ok(());
    }
    Err(SimError::Tolerance { what: format!("relative tolerance {rtol} must be finite and not negative") })
}

/// Refuses the absolute tolerance of component `i` if it is negative or not finite, or if both it and the relative
/// tolerance are 0.
fn check_absolute(i: usize, atol: f64, rtol: f64) -> Result<(), SimError> {
    let what = if !(atol.is_finite() && atol >= 0.0) {
        format!("absolute tolerance {atol} of component {i} must be finite and not negative")
    } else if atol == 0.0 && rtol == 0.0 {
        format!("component {i} has neither a relative nor an absolute tolerance")
    } else {
        return Ok(());
    };
    Err(SimError::Tolerance { what })
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
            assert!(ErrorTest::new::<f64>(Norm::Largest, rtol, &atol, 2).is_err(), "{rtol} {atol:?}");
        }
    }

    #[test]
    fn an_absolute_tolerance_alone_is_compared_directly() {
        let (test, _) =
            ErrorTest::new::<f64>(Norm::Largest, 0.0, &AbsoluteTolerance::Each(vec![0.5, 0.25]), 2).unwrap();
        assert_eq!(test.norm(&[1.0, 1.0], &[100.0, 100.0], &[0.0, 0.0]), 4.0);
        assert_eq!(test.tolerance, 1.0);
    }

    #[test]
    fn a_component_at_rest_at_zero_needs_no_absolute_tolerance() {
        let (test, _) = ErrorTest::new::<f64>(Norm::Largest, 1e-3, &AbsoluteTolerance::Uniform(0.0), 1).unwrap();
        assert_eq!(test.norm(&[0.0], &[0.0], &[0.0]), 0.0);
        assert_eq!(test.norm(&[1.0], &[0.0], &[0.0]), f64::INFINITY);
    }
}
