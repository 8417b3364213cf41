//! Right-hand sides f of equations y' = f(t, y) that a run integrates, with optional further functions: the Jacobian
//! ∂f/∂y, divisors, constraints and the power of forces.

use tripos_traits::{Lengths, Real, System};

use crate::error::Failure;

/// Right-hand side f of y' = f(t, y), with optional further functions. The time t is in s and always an `f64`; the
/// state y has the scalar type `S` of the run.
///
/// Every closure `|t: f64, y: &[S], dydt: &mut [S]| -> Result<(), Failure>` is a right-hand side.
pub trait RightHandSide<S = f64> {
    /// Writes f(t, y) to `dydt`, whose old contents have no meaning. Both slices have the length of the
    /// state.
    ///
    /// # Errors
    /// [`Failure`] if f has no value at (t, y).
    fn rhs(&mut self, t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure>;

    /// Writes the n × n Jacobian ∂f/∂y at (t, y) to `out`, row by row: `out[i * n + j]` is ∂fᵢ/∂yⱼ. `None` if the
    /// Jacobian is not known, which rules out the implicit methods `gauss6` and `radau5`. The inner error means that
    /// the Jacobian has no value there.
    fn jacobian(&mut self, t: f64, y: &[S], out: &mut [S]) -> Option<Result<(), Failure>> {
        let _ = (t, y, out);
        None
    }

    /// Writes Taylor coefficients of the solution that passes through the first row of `x` at time `t`, s. Row k of `x`
    /// gets the coefficients of order k, (1/k!) dᵏy/dtᵏ, for k up to `order`; each row has the length of the state.
    /// `None` if the coefficients are not known, which rules out [`crate::Method::Taylor`]. The inner error means that
    /// they have no value there.
    fn taylor(&mut self, t: f64, order: usize, x: &mut [S]) -> Option<Result<(), Failure>> {
        let _ = (t, order, x);
        None
    }

    /// Number of watched divisors: expressions by which f divides, and which may become zero at some states.
    fn divisor_count(&self) -> usize {
        0
    }

    /// Writes the values of the divisors of f at (t, y) to `out`, which has
    /// [`RightHandSide::divisor_count`] entries. If a divisor changes its sign within a step, the run ends
    /// at that place, with [`crate::Stop::Singular`].
    fn divisors(&mut self, t: f64, y: &[S], out: &mut [S]) {
        let _ = (t, y, out);
    }

    /// Returns the name of a divisor of f for messages. `at` is the index of the divisor, from 0.
    fn divisor_name(&self, at: usize) -> String {
        format!("divisor {at}")
    }

    /// Number of constraints on the state that the run restores after each step; 0 if there are none.
    fn constraint_count(&self) -> usize {
        0
    }

    /// Writes the constraint functions φ(t, y) to `values`, m entries, and ∂φ/∂y to `slopes`, m × n
    /// entries, row by row. After each step the run moves the state to φ = 0: [`crate::projection`].
    fn constraints(&mut self, t: f64, y: &[S], values: &mut [S], slopes: &mut [S]) {
        let _ = (t, y, values, slopes);
    }

    /// Writes the n × n mass matrix at (t, y) to `out`, row by row, if the state is (q, q̇) with n coordinates q.
    /// Corrections of the state are then the smallest in the metric of this matrix. Returns false if there is no such
    /// matrix.
    fn inertia(&mut self, t: f64, y: &[S], out: &mut Vec<f64>) -> bool {
        let _ = (t, y, out);
        false
    }

    /// True if the run must end because other equations of the same motion must continue it. The run ends with
    /// [`crate::Stop::HandedOver`].
    ///
    /// With `Some(y)` the question is about the state y that a step has reached at time `t`, s. With `None` it is about
    /// the start of a step to `t` that would lead across a zero of a divisor.
    fn hands_over(&mut self, t: f64, y: Option<&[S]>) -> bool {
        let _ = (t, y);
        false
    }

    /// True if a step must not end at (t, y), because the rates have few correct digits there. The run then
    /// repeats the step with a smaller size.
    fn avoids_end_of_step(&mut self, t: f64, y: &[S]) -> bool {
        let _ = (t, y);
        false
    }

    /// True if the step that led to the state `y` at time `t`, s, must be made by other equations of the
    /// same motion. The run then ends at the start of this step, with [`crate::Stop::HandedOver`].
    fn yields_step(&mut self, t: f64, y: &[S]) -> bool {
        let _ = (t, y);
        false
    }

    /// Power at (t, y), W, whose integral over the run becomes [`crate::Solution::work`]. `None` at every
    /// state if the work is not wanted. The power has no effect on the steps.
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

/// Right-hand side made of two closures `(t, y, out)`: one writes the n entries of f, the other the n²
/// entries of ∂f/∂y.
pub struct WithJacobian<F, J> {
    /// Closure `(t, y, out)` that writes f(t, y), n entries.
    pub rhs: F,
    /// Closure `(t, y, out)` that writes the Jacobian ∂f/∂y at (t, y), n² entries, row by row.
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

/// Right-hand side with three optional functions of a run: a power to integrate, and two conditions under which other
/// equations of the same motion take over.
pub struct AccompaniedRightHandSide<'a, S = f64> {
    /// Right-hand side f of the equations y' = f(t, y).
    pub rhs: &'a mut dyn RightHandSide<S>,
    /// Power at (t, y), W, whose integral is the work of the run; `None` if no work is wanted.
    pub power: Option<PowerAt<'a, S>>,
    /// Condition under which the run ends and other equations continue the motion, as in [`RightHandSide::hands_over`].
    /// `None` means never.
    pub over: Option<HandsOver<'a, S>>,
    /// Condition under which other equations must make the last step, as in [`RightHandSide::yields_step`]. `None`
    /// means never.
    pub yields: Option<Yields<'a, S>>,
}

/// Function of time, s, and state that gives the power of forces, W.
pub type PowerAt<'a, S = f64> = &'a mut dyn FnMut(f64, &[S]) -> f64;

/// Function of time, s, and state, as [`RightHandSide::yields_step`]. True if other equations must make the step that
/// led to this state.
pub type Yields<'a, S = f64> = &'a mut dyn FnMut(f64, &[S]) -> bool;

/// Function of time, s, and state, as [`RightHandSide::hands_over`]. True if the run must end and other equations must
/// continue the motion.
pub type HandsOver<'a, S = f64> = &'a mut dyn FnMut(f64, Option<&[S]>) -> bool;

/// Right-hand side that a run borrows, so that the caller can use it again afterwards.
///
/// In `Lent(&mut f as &mut dyn RightHandSide<S>)` the type of f is erased. All methods are then compiled once, instead
/// of once for every right-hand side, at the price of an indirect call.
pub struct LentRightHandSide<'a, R: ?Sized>(pub &'a mut R);

impl<S: Real, R: RightHandSide<S> + ?Sized> RightHandSide<S> for LentRightHandSide<'_, R> {
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

    fn avoids_end_of_step(&mut self, t: f64, y: &[S]) -> bool {
        self.0.avoids_end_of_step(t, y)
    }

    fn yields_step(&mut self, t: f64, y: &[S]) -> bool {
        self.0.yields_step(t, y)
    }

    fn hands_over(&mut self, t: f64, y: Option<&[S]>) -> bool {
        self.0.hands_over(t, y)
    }

    fn power(&mut self, t: f64, y: &[S]) -> Option<f64> {
        self.0.power(t, y)
    }
}

impl<S: Real> RightHandSide<S> for AccompaniedRightHandSide<'_, S> {
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

    fn avoids_end_of_step(&mut self, t: f64, y: &[S]) -> bool {
        self.rhs.avoids_end_of_step(t, y)
    }

    fn yields_step(&mut self, t: f64, y: &[S]) -> bool {
        self.yields.as_mut().is_some_and(|yields| yields(t, y))
    }

    fn hands_over(&mut self, t: f64, y: Option<&[S]>) -> bool {
        self.over.as_mut().is_some_and(|over| over(t, y))
    }

    fn power(&mut self, t: f64, y: &[S]) -> Option<f64> {
        self.power.as_mut().map(|power| power(t, y))
    }
}

/// Writes the constraint functions of a system at parameters `p` and state y = (q, v), and their slopes. `values` has
/// an entry for each constraint; `slopes` has a row for each constraint, with the length of y.
pub(crate) fn system_constraints<S: Real>(
    system: &dyn System<S>,
    p: &[S],
    y: &[S],
    values: &mut [S],
    slopes: &mut [S],
) {
    let (q, v) = y.split_at(system.lengths().coordinates);
    system.constraints(p, q, v, values);
    system.constraint_slopes(p, q, v, slopes);
}

/// Writes the n × n mass matrix of a system to `out`, row by row. The n variables of the system must be the rates q̇,
/// with multipliers for its constraints. The mass matrix is the upper left block of the system's matrix; `matrix` is
/// working space for that matrix.
///
/// Returns false and writes nothing for any other system. In the equations of Newton and Euler, for example, reactions
/// are unknowns and the matrix is no mass matrix.
pub(crate) fn system_inertia<S: Real>(
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
