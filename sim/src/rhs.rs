//! Right-hand sides that a run integrates: y' = f(t, y), and ∂f/∂y for methods that need it.

use tripos_traits::{Lengths, Real, System};

use crate::error::Failure;

/// Right-hand side f of y' = f(t, y). Every closure `|t: f64, y: &[S], dydt: &mut [S]| -> Result<(), Failure>` is one.
///
/// The time is in s and always an `f64`; the state has the scalar type that the run computes in.
pub trait RightHandSide<S = f64> {
    /// Writes f(t, y) to `dydt`, which comes with old contents; both slices have the state's length.
    ///
    /// # Errors
    /// [`Failure`] if f has no value at (t, y).
    fn rhs(&mut self, t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure>;

    /// Writes ∂f/∂y row by row to `out`, n² entries: `out[i * n + j]` is ∂fᵢ/∂yⱼ. `None` if it is not known,
    /// which rules out the implicit methods.
    fn jacobian(&mut self, t: f64, y: &[S], out: &mut [S]) -> Option<Result<(), Failure>> {
        let _ = (t, y, out);
        None
    }

    /// Writes the Taylor coefficients of the solution through the state in the first row of `x` at the time `t`. Row k
    /// has those of order k, (1/k!) dᵏy/dtᵏ, up to `order`; each row has the state's length. `None` if they are not
    /// known, which rules out [`crate::Method::Taylor`].
    fn taylor(&mut self, t: f64, order: usize, x: &mut [S]) -> Option<Result<(), Failure>> {
        let _ = (t, order, x);
        None
    }

    /// Number of watched divisors: expressions by which f divides, and which might be zero somewhere.
    fn divisor_count(&self) -> usize {
        0
    }

    /// Writes the divisors at (t, y) to `out`, which has [`RightHandSide::divisor_count`] entries. A step over a change
    /// of sign of a divisor is no part of a solution: the run ends there, with [`crate::Stop::Singular`].
    fn divisors(&mut self, t: f64, y: &[S], out: &mut [S]) {
        let _ = (t, y, out);
    }

    /// Name of a divisor for people; divisors are counted from 0.
    fn divisor_name(&self, at: usize) -> String {
        format!("divisor {at}")
    }

    /// Number of constraints that a run corrects after each step.
    fn constraint_count(&self) -> usize {
        0
    }

    /// Writes the constraint functions to `values`, an entry each, and their slopes along the state to `slopes`, row by
    /// row. After each step the state is moved to where the functions are zero: [`crate::projection`].
    fn constraints(&mut self, t: f64, y: &[S], values: &mut [S], slopes: &mut [S]) {
        let _ = (t, y, values, slopes);
    }

    /// Writes the mass matrix of the rates to `out`, row by row, n² entries, if the state is (q, q̇) with n of each.
    /// Corrections of the state are then the smallest in the metric of this matrix. False if it is not.
    fn inertia(&mut self, t: f64, y: &[S], out: &mut Vec<f64>) -> bool {
        let _ = (t, y, out);
        false
    }

    /// True if other equations of the same motion must go on from the state `y` that a step has reached at `t`. The run
    /// ends there with [`crate::Stop::HandedOver`]. With `None` as `y`, they must go on from the start of a step to `t`
    /// that would lead across a zero of a divisor.
    fn hands_over(&mut self, t: f64, y: Option<&[S]>) -> bool {
        let _ = (t, y);
        false
    }

    /// True if a step must not end at `y`, since rates are known to few digits there: the step is then made shorter.
    fn avoids(&mut self, t: f64, y: &[S]) -> bool {
        let _ = (t, y);
        false
    }

    /// True if other equations of the same motion must make the step that led to `y` at `t`. The run ends at the start
    /// of this step with [`crate::Stop::HandedOver`].
    fn yields(&mut self, t: f64, y: &[S]) -> bool {
        let _ = (t, y);
        false
    }

    /// Power at (t, y), W, whose integral is computed beside the solution as [`crate::Solution::work`]; `None` at every
    /// state if no work is wanted. It changes no step.
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

/// Sums to which pulled weights are added: an entry for each component of the state, and one for each parameter.
pub type Pulled<'a> = (&'a mut [f64], &'a mut [f64]);

/// A right-hand side f(t, y, p) with its transposed slopes by state and parameters, for the adjoint of a run.
pub trait Transposed: RightHandSide<f64> {
    /// Number of parameters of the right-hand side.
    fn parameter_count(&self) -> usize;

    /// Adds f_yᵀ w to the first and f_pᵀ w to the second part of `to`, for weights w of the components of f at (t, y).
    ///
    /// # Errors
    /// [`Failure`] if the slopes have no value at (t, y).
    fn pull(&mut self, t: f64, y: &[f64], weights: &[f64], to: Pulled<'_>) -> Result<(), Failure>;

    /// Adds φ_yᵀ w to the first and φ_pᵀ w to the second part of `to`, for weights w of the constraints φ of the state.
    ///
    /// # Errors
    /// [`Failure`] if the slopes have no value at (t, y).
    fn pull_constraints(&mut self, t: f64, y: &[f64], weights: &[f64], to: Pulled<'_>) -> Result<(), Failure> {
        let _ = (t, y, weights, to);
        Ok(())
    }
}

/// Right-hand side made of a closure and its Jacobian, another closure of the same form that writes n² entries.
pub struct WithJacobian<F, J> {
    /// Closure that writes f(t, y).
    pub rhs: F,
    /// Closure that writes ∂f/∂y at (t, y), row by row.
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

/// Right-hand side with additional functions for a run: a power to integrate, and conditions under which other
/// equations take over.
pub struct Accompanied<'a, S = f64> {
    /// Right-hand side of the equations.
    pub rhs: &'a mut dyn RightHandSide<S>,
    /// Power at (t, y), W, whose integral is computed; `None` if no work is wanted.
    pub power: Option<PowerAt<'a, S>>,
    /// Condition under which other equations go on, as [`RightHandSide::hands_over`]; `None` if they never do.
    pub over: Option<HandsOver<'a, S>>,
    /// Condition under which other equations make a step, as [`RightHandSide::yields`]; `None` if they never do.
    pub yields: Option<Yields<'a, S>>,
}

/// Power, W, as a function of time, s, and state.
pub type PowerAt<'a, S = f64> = &'a mut dyn FnMut(f64, &[S]) -> f64;

/// Condition of time and state under which other equations make a step: [`RightHandSide::yields`].
pub type Yields<'a, S = f64> = &'a mut dyn FnMut(f64, &[S]) -> bool;

/// Condition of time and state under which other equations go on: [`RightHandSide::hands_over`].
pub type HandsOver<'a, S = f64> = &'a mut dyn FnMut(f64, Option<&[S]>) -> bool;

/// Right-hand side that is lent to a run and used again afterwards.
///
/// In `Lent(&mut f as &mut dyn RightHandSide<S>)` the type of f is erased. All methods are then compiled once, not once
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

    fn inertia(&mut self, t: f64, y: &[S], out: &mut Vec<f64>) -> bool {
        self.0.inertia(t, y, out)
    }

    fn avoids(&mut self, t: f64, y: &[S]) -> bool {
        self.0.avoids(t, y)
    }

    fn yields(&mut self, t: f64, y: &[S]) -> bool {
        self.0.yields(t, y)
    }

    fn hands_over(&mut self, t: f64, y: Option<&[S]>) -> bool {
        self.0.hands_over(t, y)
    }

    fn power(&mut self, t: f64, y: &[S]) -> Option<f64> {
        self.0.power(t, y)
    }
}

impl<S: Real> RightHandSide<S> for Accompanied<'_, S> {
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

    fn inertia(&mut self, t: f64, y: &[S], out: &mut Vec<f64>) -> bool {
        self.rhs.inertia(t, y, out)
    }

    fn avoids(&mut self, t: f64, y: &[S]) -> bool {
        self.rhs.avoids(t, y)
    }

    fn yields(&mut self, t: f64, y: &[S]) -> bool {
        self.yields.as_mut().is_some_and(|yields| yields(t, y))
    }

    fn hands_over(&mut self, t: f64, y: Option<&[S]>) -> bool {
        self.over.as_mut().is_some_and(|over| over(t, y))
    }

    fn power(&mut self, t: f64, y: &[S]) -> Option<f64> {
        self.power.as_mut().map(|power| power(t, y))
    }
}

/// Writes the constraints of a system and their slopes, as [`RightHandSide::constraints`] does.
pub(crate) fn constraints<S: Real>(system: &dyn System<S>, p: &[S], y: &[S], values: &mut [S], slopes: &mut [S]) {
    let (q, v) = y.split_at(system.lengths().coordinates);
    system.constraints(p, q, v, values);
    system.constraint_slopes(p, q, v, slopes);
}

/// Writes the mass matrix of a system in all rates with multipliers, as [`RightHandSide::inertia`] does: the first
/// block of the system's matrix, which is kept in `matrix`. False for other systems, such as those of Newton and Euler:
/// their reactions are unknowns too, and their matrix is no mass matrix.
pub(crate) fn inertia<S: Real>(
    system: &dyn System<S>,
    p: &[S],
    y: &[S],
    matrix: &mut Vec<S>,
    out: &mut Vec<f64>,
) -> bool {
    let Lengths { coordinates: n, variables, speeds, reactions, .. } = system.lengths();
    if variables != n || speeds == n || reactions == 0 {
        return false;
    }
    let order = n + reactions;
    matrix.resize(order * order, S::from_f64(0.0));
    let (q, v) = y.split_at(n);
    system.mass_matrix(p, q, v, matrix);
    out.clear();
    out.extend(matrix.chunks_exact(order).take(n).flat_map(|row| row[..n].iter().map(|x| x.to_f64())));
    true
}
