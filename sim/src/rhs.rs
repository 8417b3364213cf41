//! What is integrated: y' = f(t, y), and ∂f/∂y where a method needs it.

use tripos_traits::Real;

use crate::error::Failure;

/// A right-hand side. Every closure `|t: f64, y: &[S], dydt: &mut [S]| -> Result<(), Failure>` is one.
///
/// The time is in s and always an `f64`; the state has the scalar type that the run computes in.
pub trait RightHandSide<S = f64> {
    /// Writes f(t, y) to `dydt`, which comes with old contents; both slices have the state's length.
    ///
    /// # Errors
    /// [`Failure`] if f has no value there.
    fn rhs(&mut self, t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure>;

    /// Writes ∂f/∂y row by row to `out`, n² entries: `out[i * n + j]` is ∂fᵢ/∂yⱼ. `None` if it is not known,
    /// which rules out the implicit methods.
    fn jacobian(&mut self, t: f64, y: &[S], out: &mut [S]) -> Option<Result<(), Failure>> {
        let _ = (t, y, out);
        None
    }

    /// Writes the Taylor coefficients of the solution through the state in the first row of `x` at the time `t`:
    /// row k has those of order k, (1/k!) dᵏy/dtᵏ, up to `order`; each row has the state's length. `None` if they are
    /// not known, which rules out [`crate::Method::Taylor`].
    fn taylor(&mut self, t: f64, order: usize, x: &mut [S]) -> Option<Result<(), Failure>> {
        let _ = (t, order, x);
        None
    }

    /// How many divisors f has that are watched: what it divides by and might be zero somewhere.
    fn divisor_count(&self) -> usize {
        0
    }

    /// Writes the divisors at (t, y) to `out`, which has [`RightHandSide::divisor_count`] entries. A step over a change
    /// of the sign of one is no part of a solution: the run ends there, with [`crate::Stop::Singular`].
    fn divisors(&mut self, t: f64, y: &[S], out: &mut [S]) {
        let _ = (t, y, out);
    }

    /// What people call a divisor, counted from 0.
    fn divisor_name(&self, at: usize) -> String {
        format!("divisor {at}")
    }

    /// How many constraints the state is kept on.
    fn constraint_count(&self) -> usize {
        0
    }

    /// Writes what is zero on the constraints to `values`, an entry each, and its slopes along the state to `slopes`, row by
    /// row. After each step the state is moved to where they are zero: [`crate::projection`].
    fn constraints(&mut self, t: f64, y: &[S], values: &mut [S], slopes: &mut [S]) {
        let _ = (t, y, values, slopes);
    }

    /// The power, W, whose integral is wanted beside the solution, as [`crate::Solution::work`]; `None`, at every state,
    /// where none is. It changes no step.
    fn power(&mut self, t: f64, y: &[S]) -> Option<f64> {
        let _ = (t, y);
        None
    }
}

impl<S, F> RightHandSide<S> for F
where
    F: FnMut(f64, &[S], &mut [S]) -> Result<(), Failure>,
{
    #[inline]
    fn rhs(&mut self, t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure> {
        self(t, y, dydt)
    }
}

/// A closure with its Jacobian, another closure of the same form that writes n² entries.
pub struct WithJacobian<F, J> {
    /// f(t, y).
    pub rhs: F,
    /// ∂f/∂y at (t, y), row by row.
    pub jacobian: J,
}

impl<S, F, J> RightHandSide<S> for WithJacobian<F, J>
where
    F: FnMut(f64, &[S], &mut [S]) -> Result<(), Failure>,
    J: FnMut(f64, &[S], &mut [S]) -> Result<(), Failure>,
{
    #[inline]
    fn rhs(&mut self, t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure> {
        (self.rhs)(t, y, dydt)
    }

    fn jacobian(&mut self, t: f64, y: &[S], out: &mut [S]) -> Option<Result<(), Failure>> {
        Some((self.jacobian)(t, y, out))
    }
}

/// Equations with a power whose integral is wanted.
pub struct WithPower<'a, S = f64> {
    /// The equations.
    pub rhs: &'a mut dyn RightHandSide<S>,
    /// The power at (t, y), W.
    pub power: &'a mut dyn FnMut(f64, &[S]) -> f64,
}

/// A right-hand side that is lent to a run and used again afterwards.
///
/// As `Lent(&mut f as &mut dyn RightHandSide<S>)` its type is forgotten: all methods are then compiled once, not once
/// for every right-hand side, at the price of an indirect call.
pub struct Lent<'a, R: ?Sized>(pub &'a mut R);

impl<S: Real, R: RightHandSide<S> + ?Sized> RightHandSide<S> for Lent<'_, R> {
    #[inline]
    fn rhs(&mut self, t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure> {
        self.0.rhs(t, y, dydt)
    }

    fn jacobian(&mut self, t: f64, y: &[S], out: &mut [S]) -> Option<Result<(), Failure>> {
        self.0.jacobian(t, y, out)
    }

    #[inline]
    fn taylor(&mut self, t: f64, order: usize, x: &mut [S]) -> Option<Result<(), Failure>> {
        self.0.taylor(t, order, x)
    }

    fn divisor_count(&self) -> usize {
        self.0.divisor_count()
    }

    fn divisors(&mut self, t: f64, y: &[S], out: &mut [S]) {
        self.0.divisors(t, y, out);
    }

    fn divisor_name(&self, at: usize) -> String {
        self.0.divisor_name(at)
    }

    fn constraint_count(&self) -> usize {
        self.0.constraint_count()
    }

    fn constraints(&mut self, t: f64, y: &[S], values: &mut [S], slopes: &mut [S]) {
        self.0.constraints(t, y, values, slopes);
    }

    fn power(&mut self, t: f64, y: &[S]) -> Option<f64> {
        self.0.power(t, y)
    }
}

impl<S: Real> RightHandSide<S> for WithPower<'_, S> {
    #[inline]
    fn rhs(&mut self, t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure> {
        self.rhs.rhs(t, y, dydt)
    }

    fn jacobian(&mut self, t: f64, y: &[S], out: &mut [S]) -> Option<Result<(), Failure>> {
        self.rhs.jacobian(t, y, out)
    }

    #[inline]
    fn taylor(&mut self, t: f64, order: usize, x: &mut [S]) -> Option<Result<(), Failure>> {
        self.rhs.taylor(t, order, x)
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

    fn power(&mut self, t: f64, y: &[S]) -> Option<f64> {
        Some((self.power)(t, y))
    }
}
