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
        /// The component, from 0.
        component: usize,
    },
    /// The right-hand side has no value.
    Failed(Failure),
    /// The equations of an implicit step were not solved.
    NotConverged {
        /// Iterations made.
        iterations: u32,
    },
}

/// Fails with the position of the first entry that is not finite.
pub(crate) fn check_finite<S: Real>(values: &[S]) -> Result<(), Trouble> {
    match values.iter().position(|x| !x.to_f64().is_finite()) {
        Some(component) => Err(Trouble::NotFinite { component }),
        None => Ok(()),
    }
}

/// Evaluates f(t, y), which must be finite.
#[inline]
pub(crate) fn evaluate<S, R>(rhs: &mut R, t: f64, y: &[S], out: &mut [S]) -> Result<(), Trouble>
where
    S: Real,
    R: RightHandSide<S>,
{
    rhs.rhs(t, y, out).map_err(Trouble::Failed)?;
    check_finite(out)
}

/// True if two numbers are equal.
#[expect(clippy::float_cmp, reason = "asks for identity, not for nearness")]
pub(crate) fn same(a: f64, b: f64) -> bool {
    a == b
}

/// A step that is being tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Trial {
    /// Signed size, in s, as the step control chose it.
    pub(crate) h: f64,
    /// Time at the end, in s: t + h rounded, or the end of the run.
    pub(crate) t_new: f64,
}

impl Trial {
    /// The distance from `t` to the end, without the rounding of t + h: in a scalar wider than `f64` it is exact.
    pub(crate) fn exact<S: Real>(self, t: f64) -> S {
        S::from_f64(self.t_new) - S::from_f64(t)
    }
}

/// The solution inside one step, rounded to `f64`, for events.
pub(crate) trait DenseStep {
    /// Start and end of the step, in s; the end is smaller when integrating backward.
    fn times(&self) -> (f64, f64);
    /// The state at the fraction `theta` of the step, exactly the step's ends at 0 and 1.
    /// A little beyond 1 is allowed and extrapolates.
    fn interpolate(&self, theta: f64, out: &mut [f64]);
    /// The degree of the solution inside the step; nothing if it is no polynomial.
    fn degree(&self) -> Option<usize>;
    /// Writes the coefficients of the powers of the fraction of the step, up to the degree: first those of power 0, one
    /// for each component.
    fn powers(&self, out: &mut [f64]);
    /// The time at the fraction `theta` of the step.
    fn time_at(&self, theta: f64) -> f64 {
        let (start, end) = self.times();
        if same(theta, 1.0) { end } else { start + theta * (end - start) }
    }
}

/// The solution inside one step, in the scalar of the run.
pub(crate) trait Interpolant {
    /// The scalar of the run.
    type Real: Real;
    /// Start and end of the step, in s.
    fn span(&self) -> (f64, f64);
    /// States at the start and at the end of the step.
    fn ends(&self) -> (&[Self::Real], &[Self::Real]);
    /// Hands each component of the state at the fraction `theta` to `put`.
    fn inside(&self, theta: Self::Real, put: impl FnMut(usize, Self::Real));
    /// The degree of the solution inside the step as a polynomial in its fraction; nothing if it is none.
    fn order_inside(&self) -> Option<usize>;
    /// Hands `put` the component, the power of the fraction of the step and its coefficient, for every power up to the
    /// degree: the polynomial of [`Interpolant::inside`] but for rounding.
    fn coefficients(&self, put: impl FnMut(usize, usize, Self::Real));

    /// The state at the fraction `theta`, which is at the time `t`.
    fn sample(&self, theta: f64, t: f64) -> Vec<Self::Real> {
        let (y, y_new) = self.ends();
        let mut out = if same(theta, 1.0) { y_new.to_vec() } else { y.to_vec() };
        if !same(theta, 0.0) && !same(theta, 1.0) {
            self.inside(self.fraction(theta, t), |i, value| out[i] = value);
        }
        out
    }

    /// The fraction of the step at the time `t`, as exactly as the scalar can tell; `theta` is its `f64`.
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

/// A one-step method. The driver alone knows about step sizes, events and output.
pub(crate) trait Stepper: Interpolant {
    /// Puts the method at (t, y) and evaluates the derivative there.
    fn start<R>(&mut self, rhs: &mut R, t: f64, y: &[Self::Real]) -> Result<(), Trouble>
    where
        R: RightHandSide<Self::Real>;
    /// The size of the next step where the method knows it before the step is tried; it then needs no step control.
    fn proposal(&mut self, test: &ErrorTest) -> Option<f64> {
        let _ = test;
        None
    }
    /// Tries a step from the current point, and returns its error in the norm of `test`; 0 without a test. A step
    /// that passes the test has a derivative at its end.
    fn attempt<R>(&mut self, rhs: &mut R, trial: Trial, test: Option<&ErrorTest>) -> Result<f64, Trouble>
    where
        R: RightHandSide<Self::Real>;
    /// Evaluates the stages that only the solution inside the step last tried needs. False if f has no value there; the
    /// solution inside is then of lower order.
    fn prepare_inside<R>(&mut self, rhs: &mut R) -> bool
    where
        R: RightHandSide<Self::Real>,
    {
        let _ = rhs;
        true
    }
    /// Says, before the start, that each accepted step is followed by [`Stepper::restart`] or [`Stepper::stay`].
    fn expect_moves(&mut self) {}
    /// Goes on from the state that it has come to, where that might have been moved.
    fn stay<R>(&mut self, rhs: &mut R) -> Result<(), Trouble>
    where
        R: RightHandSide<Self::Real>,
    {
        let _ = rhs;
        Ok(())
    }
    /// Goes on from another state at the time it has come to.
    fn restart<R>(&mut self, rhs: &mut R, y: &[Self::Real]) -> Result<(), Trouble>
    where
        R: RightHandSide<Self::Real>,
    {
        let t = self.span().0;
        self.start(rhs, t, y)
    }
    /// Part that the next step is to take of the size that the error of the step last tried allows, at most 1. It is
    /// less where the step was hard to solve.
    fn margin(&self) -> f64 {
        1.0
    }
    /// The component with the largest weighted error in the step last tried.
    fn worst(&self, test: &ErrorTest) -> Option<usize>;
    /// Moves to the end of the step last tried.
    fn accept(&mut self);
    /// Derivative at the start; asked for before the first step.
    fn slope(&self) -> &[Self::Real];
    /// Calls of the right-hand side so far.
    fn evaluations(&self) -> u64;
    /// Evaluations of the Jacobian so far.
    fn jacobians(&self) -> u64 {
        0
    }
}
