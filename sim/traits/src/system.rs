//! Equations of motion of a model in one formulation, as functions of numbers.

use crate::{AtPoints, Scalar};

/// Lengths of the arguments and results of a [`System`]; they are stated nowhere else.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lengths {
    /// Number of parameters: length of `p`.
    pub parameters: usize,
    /// Number n of generalized coordinates: length of `q` and of q̇.
    pub coordinates: usize,
    /// Number of motion variables, which the formulation integrates beside the coordinates: length of `v` and of v̇.
    pub variables: usize,
    /// Number p ≤ n of generalized speeds of the model: length of `u` and of u̇.
    pub speeds: usize,
    /// Number of reactions among the unknowns, which stand after v̇.
    pub reactions: usize,
}

impl Lengths {
    /// Order of the linear system: the number of its unknowns, v̇ and the reactions.
    #[must_use]
    pub const fn unknowns(self) -> usize {
        self.variables + self.reactions
    }

    /// Length of the state (q, v).
    #[must_use]
    pub const fn state(self) -> usize {
        self.coordinates + self.variables
    }
}

/// Equations of motion  A(q, v) x = b(q, v),  q̇ = k(q, v).
///
/// `q` holds the n generalized coordinates and `v` the motion variables that the formulation integrates: the p ≤ n
/// generalized speeds u for Kane and Newton–Euler, the n coordinate rates q̇ for Lagrange. The unknowns x are v̇,
/// followed by reaction forces and torques. `p` holds the parameters in the order of the model file. All slices have
/// exactly the lengths that [`System::lengths`] states; implementations may panic on others.
pub trait System<S: Scalar = f64> {
    /// Lengths of the arguments and results.
    fn lengths(&self) -> Lengths;
    /// True if [`System::mass_matrix`] is symmetric and, away from singular configurations, positive definite.
    fn symmetric(&self) -> bool;

    /// True if v̇ was solved for when the code was generated, so that [`System::accelerations`], [`System::derivative`]
    /// and [`System::jacobian`] have values. If false, these functions give "not a number".
    fn has_accelerations(&self) -> bool {
        false
    }
    /// Writes the accelerations v̇, which were eliminated exactly from A x = b when the equations were derived; `out`
    /// is as long as `v`.
    fn accelerations(&self, _p: &[S], _q: &[S], _v: &[S], out: &mut [S]) {
        out.fill(S::from_f64(f64::NAN));
    }
    /// Writes q̇ and v̇ together, which share terms; `q_dot` is as long as `q`, `v_dot` as `v`.
    fn derivative(&self, p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]) {
        self.coordinate_rates(p, q, v, q_dot);
        self.accelerations(p, q, v, v_dot);
    }
    /// Writes the Jacobian ∂(q̇, v̇)/∂(q, v) of [`System::derivative`], row by row; `out` has [`Lengths::state`]²
    /// entries.
    fn jacobian(&self, _p: &[S], _q: &[S], _v: &[S], out: &mut [S]) {
        out.fill(S::from_f64(f64::NAN));
    }

    /// True if the recurrences of the Taylor coefficients were generated, so that [`System::taylor`] has values. These
    /// need eliminated accelerations without |x| and sign x, which have no Taylor series at 0.
    fn has_taylor(&self) -> bool {
        false
    }
    /// Length of the working space of [`System::taylor`] for this order.
    fn taylor_work(&self, _order: usize) -> usize {
        0
    }
    /// Writes the Taylor coefficients of the motion in time: (1/k!) dᵏ(q, v)/dtᵏ for k = 0 … `order`, row by row.
    ///
    /// `x` has (`order` + 1) [`Lengths::state`] entries and comes with the state (q, v) in its first row; `work` has
    /// [`System::taylor_work`] entries with any contents.
    fn taylor(&self, _p: &[S], _order: usize, x: &mut [S], _work: &mut [S]) {
        let state = self.lengths().state();
        x[state..].fill(S::from_f64(f64::NAN));
    }

    /// Writes the rates q̇ = k(q, v) of the coordinates; `out` is as long as `q`.
    fn coordinate_rates(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]);
    /// Writes the mass matrix A(q, v), row by row; `out` has [`Lengths::unknowns`]² entries. Equations that consist of
    /// accelerations only have the identity.
    fn mass_matrix(&self, _p: &[S], _q: &[S], _v: &[S], out: &mut [S]) {
        let n = self.lengths().unknowns();
        for (at, entry) in out.iter_mut().enumerate() {
            *entry = S::int(i64::from(at % (n + 1) == 0));
        }
    }
    /// Writes the forcing b(q, v); `out` has [`Lengths::unknowns`] entries. Equations that consist of accelerations
    /// only have these.
    fn forcing(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.accelerations(p, q, v, out);
    }

    /// Writes the mass matrix A and the forcing b at once, as [`System::mass_matrix`] and [`System::forcing`] do. Terms
    /// that both share are computed once, if that was generated.
    fn linear_system(&self, p: &[S], q: &[S], v: &[S], matrix: &mut [S], forcing: &mut [S]) {
        self.mass_matrix(p, q, v, matrix);
        self.forcing(p, q, v, forcing);
    }

    /// Number of values that [`System::outputs`] gives.
    fn output_count(&self) -> usize;
    /// Writes the outputs of a state at time `t` after the start, s: those that a scene asks for, or
    /// [`System::whole_state`] if no scene does. `out` has [`System::output_count`] entries.
    ///
    /// It has no default: values that nobody asked for must not appear under the names of others.
    fn outputs(&self, p: &[S], t: S, q: &[S], v: &[S], out: &mut [S]);
    /// Writes the coordinates q, then the generalized speeds u of the model; `out` has as many entries as q and u.
    fn whole_state(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        let (of_q, of_u) = out.split_at_mut(q.len());
        of_q.copy_from_slice(q);
        self.generalized_speeds(p, q, v, of_u);
    }

    /// True if [`System::energy_gradient`] has values.
    fn has_energy_gradient(&self) -> bool {
        false
    }
    /// Returns T + V, and writes ∂(T + V)/∂(q, v) to `out`, which has [`Lengths::state`] entries. Both are not numbers
    /// if [`System::has_energy_gradient`] is false.
    fn energy_gradient(&self, _p: &[S], _q: &[S], _v: &[S], out: &mut [S]) -> S {
        out.fill(S::from_f64(f64::NAN));
        S::from_f64(f64::NAN)
    }

    /// Number of watched divisors: expressions by which these equations divide, and which might be zero somewhere.
    fn divisor_count(&self) -> usize {
        0
    }
    /// Name of a divisor for people, divisors counted from 0: its formula, or its place in the model if that is long.
    fn divisor_name(&self, _at: usize) -> &str {
        Default::default()
    }
    /// Writes the divisors at a state; `out` has [`System::divisor_count`] entries. If a divisor is zero, the equations
    /// have no value, and a step over a change of its sign is no part of a motion.
    fn divisors(&self, _p: &[S], _q: &[S], _v: &[S], out: &mut [S]) {
        out.fill(S::from_f64(f64::NAN));
    }

    /// Number of constraints that a run corrects after each step, since steps may break them: positions that close
    /// loops, and velocities where these are variables.
    fn constraint_count(&self) -> usize {
        0
    }
    /// Name of a constraint; constraints are counted from 0.
    fn constraint_name(&self, _at: usize) -> &str {
        Default::default()
    }
    /// Writes the constraint functions, which are zero where the constraints hold. `out` has
    /// [`System::constraint_count`] entries, each in its own unit.
    fn constraints(&self, _p: &[S], _q: &[S], _v: &[S], out: &mut [S]) {
        out.fill(S::from_f64(f64::NAN));
    }
    /// Writes the slopes of [`System::constraints`] along (q, v), row by row; `out` has [`Lengths::state`] entries for
    /// each constraint.
    fn constraint_slopes(&self, _p: &[S], _q: &[S], _v: &[S], out: &mut [S]) {
        out.fill(S::from_f64(f64::NAN));
    }

    /// Writes the generalized speeds u of the model file, from v; `out` has [`Lengths::speeds`] entries.
    fn generalized_speeds(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]);
    /// Writes the rates u̇ of the generalized speeds from v̇, so that formulations can be compared speed by speed.
    fn generalized_speed_rates(&self, p: &[S], q: &[S], v: &[S], v_dot: &[S], out: &mut [S]);
    /// Writes v from the generalized speeds u: the inverse of [`System::generalized_speeds`].
    fn motion_variables(&self, p: &[S], q: &[S], u: &[S], out: &mut [S]);

    /// Kinetic energy T, in joules for a model in SI units.
    fn kinetic_energy(&self, p: &[S], q: &[S], v: &[S]) -> S;
    /// Potential energy V, in joules for a model in SI units: of gravity, and of the applied loads that have a
    /// potential.
    fn potential_energy(&self, p: &[S], q: &[S]) -> S;
    /// True if [`System::power`] is not zero everywhere.
    fn has_power(&self) -> bool {
        false
    }
    /// Power of the loads that have no potential, in watts for a model in SI units: d(T + V)/dt, zero if T + V is
    /// conserved.
    fn power(&self, _p: &[S], _q: &[S], _v: &[S]) -> S {
        S::from_f64(0.0)
    }

    /// True if [`System::potential_slope`] has values.
    fn has_potential_slope(&self) -> bool {
        false
    }
    /// Divided difference V\[a, b\] = (V(b) − V(a))/(b − a) of the potential energy along the first coordinate, on
    /// which alone it must depend. It is ∂V/∂q at b = a, and nothing cancels next to that. Its unit is that of V over
    /// that of the coordinate.
    ///
    /// Quadrature finds the motion of one degree of freedom from it. The default is not a number.
    fn potential_slope(&self, _p: &[S], _a: S, _b: S) -> S {
        S::from_f64(f64::NAN)
    }
    /// Period of the first coordinate, in its unit and above zero. After it the rates of the coordinates, T and V
    /// repeat, from which quadrature finds a motion. `None` if no period is known.
    fn coordinate_period(&self) -> Option<f64> {
        None
    }
    /// Integrands of quadrature at several coordinates at once, in doubles; `None` if they were not generated.
    /// Quadrature spends its time in them.
    fn at_points(&self) -> Option<AtPoints<'_>> {
        None
    }
}

/// Writes the N × N Jacobian, row by row, from its products with the unit directions, a column for each.
pub fn by_columns<S: Scalar, const N: usize>(out: &mut [S], mut product: impl FnMut(&[S; N]) -> [S; N]) {
    for at in 0..N {
        let mut direction = [S::int(0); N];
        direction[at] = S::int(1);
        for (row, value) in product(&direction).into_iter().enumerate() {
            out[row * N + at] = value;
        }
    }
}
