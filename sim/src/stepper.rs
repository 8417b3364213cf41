//! Interface of a one-step method to the driver: a trial step, its error, and the solution inside it.

use tripos_traits::{Real, Scalar};

use crate::error::Failure;
use crate::rhs::RightHandSide;
use crate::tolerance::ErrorTest;

/// Reason why a trial step has no result.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Trouble {
    /// A component of the state or its derivative became infinite or not a number.
    NotFinite {
        /// Component of the state, from 0.
        component: usize,
    },
    /// The right-hand side has no value at a point of the step.
    Failed(Failure),
    /// The equations of an implicit step were not solved.
    NotConverged {
        /// Number of iterations of Newton's method that were made.
        iterations: u32,
    },
}

/// Fails with the index of the first entry that is not finite.
pub(crate) fn check_finite<S: Real>(values: &[S]) -> Result<(), Trouble> {
    match values.iter().position(|x| !x.to_f64().is_finite()) {
        Some(component) => Err(Trouble::NotFinite { component }),
        None => Ok(()),
    }
}

/// Evaluates f(t, y), and fails if it is not finite.
#[inline]
pub(crate) fn evaluate<S, R>(rhs: &mut R, t: f64, y: &[S], out: &mut [S]) -> Result<(), Trouble>
where
    S: Real,
    R: RightHandSide<S>,
{
    rhs.rhs(t, y, out).map_err(Trouble::Failed)?;
    check_finite(out)
}

/// True if two numbers are equal, to the last bit except for the sign of 0.
#[expect(clippy::float_cmp, reason = "asks for identity, not for nearness")]
pub(crate) fn same(a: f64, b: f64) -> bool {
    a == b
}

/// Size and end of a step that is being tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Trial {
    /// Signed size of the step, s, as the step control chose it.
    pub(crate) h: f64,
    /// Time at the end of the step, s: t + h rounded, or the end of the run.
    pub(crate) t_new: f64,
}

impl Trial {
    /// Distance from `t` to the end of the step, s, without the rounding of t + h: exact in a scalar wider than `f64`.
    pub(crate) fn exact<S: Real>(self, t: f64) -> S {
        S::from_f64(self.t_new) - S::from_f64(t)
    }
}

/// Solution inside a step, rounded to `f64`, for events.
pub(crate) trait DenseStep {
    /// Start and end of the step, s; the end is smaller in a run backward in time.
    fn times(&self) -> (f64, f64);
    /// Writes the state at the fraction `theta` of the step; it is exactly that of the step's ends at 0 and 1. A little
    /// beyond 1 is allowed and extrapolates.
    fn interpolate(&self, theta: f64, out: &mut [f64]);
    /// Degree of the solution inside the step as a polynomial; `None` if it is no polynomial.
    fn degree(&self) -> Option<usize>;
    /// Writes the coefficients of the powers of the fraction of the step, up to the degree: first those of power 0, a
    /// coefficient for each component.
    fn powers(&self, out: &mut [f64]);
    /// Time at the fraction `theta` of the step, s.
    fn time_at(&self, theta: f64) -> f64 {
        let (start, end) = self.times();
        if same(theta, 1.0) { end } else { start + theta * (end - start) }
    }
}

/// Solution inside a step, in the scalar of the run.
pub(crate) trait Interpolant {
    /// Type of the numbers of the run.
    type Real: Real;
    /// Start and end of the step, s.
    fn span(&self) -> (f64, f64);
    /// States at the start and at the end of the step.
    fn ends(&self) -> (&[Self::Real], &[Self::Real]);
    /// Hands each component of the state at the fraction `theta` of the step to `put`, with its index.
    fn inside(&self, theta: Self::Real, put: impl FnMut(usize, Self::Real));
    /// Degree of the solution inside the step as a polynomial in the fraction of the step; `None` if it is no
    /// polynomial.
    fn order_inside(&self) -> Option<usize>;
    /// Hands `put` the component, the power of the fraction of the step and its coefficient, for every power up to the
    /// degree: the polynomial of [`Interpolant::inside`] up to rounding.
    fn coefficients(&self, put: impl FnMut(usize, usize, Self::Real));

    /// State at the fraction `theta` of the step, which is at the time `t`, s.
    fn sample(&self, theta: f64, t: f64) -> Vec<Self::Real> {
        let (y, y_new) = self.ends();
        let mut out = if same(theta, 1.0) { y_new.to_vec() } else { y.to_vec() };
        if !same(theta, 0.0) && !same(theta, 1.0) {
            self.inside(self.fraction(theta, t), |i, value| out[i] = value);
        }
        out
    }

    /// Fraction of the step at the time `t`, s, as exactly as the scalar can hold it; `theta` is this fraction as
    /// `f64`.
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
        if same(theta, 0.0) {
            round(y);
        } else if same(theta, 1.0) {
            round(y_new);
        } else {
            self.inside(I::Real::from_f64(theta), |i, value| out[i] = value.to_f64());
        }
    }

    fn degree(&self) -> Option<usize> {
        self.order_inside()
    }

    fn powers(&self, out: &mut [f64]) {
        let components = self.ends().0.len();
        self.coefficients(|i, k, value| out[k * components + i] = value.to_f64());
    }
}

/// A one-step method of integration. Only the driver knows about step sizes, events and output.
pub(crate) trait Stepper: Interpolant {
    /// Puts the method at (t, y) and evaluates the derivative there.
    fn start<R>(&mut self, rhs: &mut R, t: f64, y: &[Self::Real]) -> Result<(), Trouble>
    where
        R: RightHandSide<Self::Real>;
    /// Size of the next step, s, if the method knows it before the step is tried, so that it needs no step control.
    fn proposal(&mut self, test: &ErrorTest) -> Option<f64> {
        let _ = test;
        None
    }
    /// Tries a step from the current point, and returns its error in the norm of the error test; 0 without a test. A
    /// step that passes the test has a derivative at its end.
    fn attempt<R>(&mut self, rhs: &mut R, trial: Trial, test: Option<&ErrorTest>) -> Result<f64, Trouble>
    where
        R: RightHandSide<Self::Real>;
    /// Evaluates the stages that only the solution inside the last tried step needs. False if f has no value there; the
    /// solution inside is then of lower order.
    fn prepare_inside<R>(&mut self, rhs: &mut R) -> bool
    where
        R: RightHandSide<Self::Real>,
    {
        let _ = rhs;
        true
    }
    /// Announces, before the start, that each accepted step is followed by [`Stepper::restart`] or [`Stepper::stay`].
    fn expect_moves(&mut self) {}
    /// Goes on from the current state, which might have been moved but was not.
    fn stay<R>(&mut self, rhs: &mut R) -> Result<(), Trouble>
    where
        R: RightHandSide<Self::Real>,
    {
        let _ = rhs;
        Ok(())
    }
    /// Goes on from another state at the current time.
    fn restart<R>(&mut self, rhs: &mut R, y: &[Self::Real]) -> Result<(), Trouble>
    where
        R: RightHandSide<Self::Real>,
    {
        let t = self.span().0;
        self.start(rhs, t, y)
    }
    /// Fraction, at most 1, of the size that the error of the last tried step allows for the next step. It is less than
    /// 1 if the equations of the step were hard to solve.
    fn margin(&self) -> f64 {
        1.0
    }
    /// Component with the largest weighted error in the last tried step; `None` if no component has an error.
    fn worst(&self, test: &ErrorTest) -> Option<usize>;
    /// Moves to the end of the last tried step.
    fn accept(&mut self);
    /// Derivative of the state at the start, before the first step.
    fn slope(&self) -> &[Self::Real];
    /// Number of calls of the right-hand side so far.
    fn evaluations(&self) -> u64;
    /// Number of evaluations of the Jacobian so far.
    fn jacobians(&self) -> u64 {
        0
    }
}
