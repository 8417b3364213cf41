//! Dense output of a step (the solution inside it), in the scalar type of the run or rounded to `f64` for the search of
//! events.

use tripos_traits::{Real, Scalar};

use crate::rounding::exactly_equal;

/// Dense output of a step (the solution inside it), rounded to `f64`, for the search of events.
pub(crate) trait DenseStep {
    /// Start and end time of the step, s. The end is before the start in a run backward in time.
    fn times(&self) -> (f64, f64);
    /// Writes the state at the fraction `theta` of the step. At 0 and 1 it is exactly the state at the
    /// step's ends. Values a little above 1 are allowed and extrapolate.
    fn interpolate(&self, theta: f64, out: &mut [f64]);
    /// Degree of the dense output as a polynomial in the fraction of the step; `None` if it is no
    /// polynomial.
    fn degree(&self) -> Option<usize>;
    /// Writes the coefficients of the dense output in powers of the fraction of the step, (degree + 1) × n numbers. Row
    /// k has the coefficients of power k, with an entry for each of the n components.
    fn dense_output_powers(&self, out: &mut [f64]);
    /// Time at the fraction `theta` of the step, s.
    fn time_at(&self, theta: f64) -> f64 {
        let (start, end) = self.times();
        if exactly_equal(theta, 1.0) { end } else { start + theta * (end - start) }
    }
}

/// Dense output of a step (the solution inside it), in the scalar type of the run.
pub(crate) trait Interpolant {
    /// Scalar type in which the run computes its states.
    type Real: Real;
    /// Start and end time of the step, s.
    fn span(&self) -> (f64, f64);
    /// States at the start and at the end of the step.
    fn ends(&self) -> (&[Self::Real], &[Self::Real]);
    /// Computes the state at the fraction `theta` of the step. Calls `put(i, value)` for each component i.
    fn dense_output(&self, theta: Self::Real, put: impl FnMut(usize, Self::Real));
    /// Degree of the dense output as a polynomial in the fraction of the step; `None` if it is no
    /// polynomial.
    fn degree_of_dense_output(&self) -> Option<usize>;
    /// Computes the coefficients of the dense output in powers of the fraction of the step. Calls `put(i,
    /// k, value)` for each component i and each power k up to the degree. The polynomial equals
    /// [`Interpolant::dense_output`] up to rounding.
    fn coefficients(&self, put: impl FnMut(usize, usize, Self::Real));

    /// Returns the state at the fraction `theta` of the step. `t` is the time there, s.
    fn sample(&self, theta: f64, t: f64) -> Vec<Self::Real> {
        let (y, y_new) = self.ends();
        let mut out = if exactly_equal(theta, 1.0) { y_new.to_vec() } else { y.to_vec() };
        if !exactly_equal(theta, 0.0) && !exactly_equal(theta, 1.0) {
            self.dense_output(self.fraction(theta, t), |i, value| out[i] = value);
        }
        out
    }

    /// Fraction of the step at time `t`, s, as exactly as the run's scalar can hold it. `theta` is the same
    /// fraction in `f64`.
    fn fraction(&self, theta: f64, t: f64) -> Self::Real {
        let wide = <Self::Real as Scalar>::from_f64;
        if <Self::Real as Real>::EPSILON < f64::EPSILON {
            let (start, end) = self.span();
            (wide(t) - wide(start)) / (wide(end) - wide(start))
        } else {
            wide(theta)
        }
    }
}

impl<I: Interpolant> DenseStep for I {
    fn times(&self) -> (f64, f64) {
        self.span()
    }

    fn interpolate(&self, theta: f64, out: &mut [f64]) {
        let (y, y_new) = self.ends();
        let mut round = |values: &[I::Real]| {
            for (o, value) in out.iter_mut().zip(values) {
                *o = value.to_f64();
            }
        };
        if exactly_equal(theta, 0.0) {
            round(y);
        } else if exactly_equal(theta, 1.0) {
            round(y_new);
        } else {
            self.dense_output(I::Real::from_f64(theta), |i, value| out[i] = value.to_f64());
        }
    }

    fn degree(&self) -> Option<usize> {
        self.degree_of_dense_output()
    }

    fn dense_output_powers(&self, out: &mut [f64]) {
        let components = self.ends().0.len();
        self.coefficients(|i, k, value| out[k * components + i] = value.to_f64());
    }
}
