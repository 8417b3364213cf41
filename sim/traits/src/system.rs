//! Equations of motion of a model by one formulation, as numeric functions.

use crate::{AtPoints, Scalar};

/// Lengths of the arguments and results of a [`System`]. They are stated only here.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lengths {
    /// Number of parameters of the model: length of `p`.
    pub parameters: usize,
    /// Number n of generalized coordinates: length of `q` and of q̇.
    pub coordinates: usize,
    /// Number of motion variables, which the formulation integrates together with the coordinates:
    /// length of `v` and of v̇.
    pub variables: usize,
    /// Number p ≤ n of generalized speeds of the model: length of `u` and of u̇.
    pub speeds: usize,
    /// Number of reactions among the unknowns, where they follow v̇.
    pub reactions: usize,
}

impl Lengths {
    /// Number of unknowns (v̇ and the reactions), which is the order of the linear system.
    #[must_use]
    pub const fn unknowns(self) -> usize {
        self.variables + self.reactions
    }

    /// Length of the state (q, v): number of coordinates and motion variables.
    #[must_use]
    pub const fn state(self) -> usize {
        self.coordinates + self.variables
    }
}

/// Equations of motion of a model by one formulation: A(q, v) x = b(q, v), q̇ = k(q, v).
///
/// `q` holds the n generalized coordinates and `v` the motion variables. These are the p ≤ n
/// generalized speeds u for Kane and Newton–Euler, and the n coordinate rates q̇ for Lagrange. The
/// unknowns x are v̇, followed by reaction forces and torques. `p` holds the parameters in the
/// order of the model file. All slices have exactly the lengths that [`System::lengths`] states;
/// implementations may panic on others.
pub trait System<S: Scalar = f64> {
    /// Lengths of all arguments and results of these functions.
    fn lengths(&self) -> Lengths;
    /// True if [`System::mass_matrix`] is symmetric and, except in singular configurations, positive
    /// definite.
    fn symmetric(&self) -> bool;

    /// True if v̇ was solved for when the code was generated. If false, [`System::accelerations`],
    /// [`System::derivative`] and [`System::jacobian`] give "not a number".
    fn has_accelerations(&self) -> bool {
        false
    }
    /// Writes the accelerations v̇, which were eliminated exactly from A x = b when the equations were
    /// derived. `out` has the length of `v`. "Not a number" by default.
    fn accelerations(&self, _p: &[S], _q: &[S], _v: &[S], out: &mut [S]) {
        out.fill(S::from_f64(f64::NAN));
    }
    /// Writes q̇ and v̇ at once, so that shared terms are computed once. `q_dot` has the length of `q`,
    /// `v_dot` that of `v`.
    fn derivative(&self, p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]) {
        self.coordinate_rates(p, q, v, q_dot);
        self.accelerations(p, q, v, v_dot);
    }
    /// Writes the Jacobian ∂(q̇, v̇)/∂(q, v) of [`System::derivative`], row by row. `out` has
    /// [`Lengths::state`]² entries. "Not a number" by default.
    fn jacobian(&self, _p: &[S], _q: &[S], _v: &[S], out: &mut [S]) {
        out.fill(S::from_f64(f64::NAN));
    }

    /// True if the recurrences of the Taylor coefficients were generated, so that [`System::taylor`]
    /// has values. They need eliminated accelerations without |x| and sign x, which have no Taylor
    /// series at 0.
    fn has_taylor(&self) -> bool {
        false
    }
    /// Length of the workspace of [`System::taylor`] for this order.
    fn taylor_work(&self, _order: usize) -> usize {
        0
    }
    /// Writes the Taylor coefficients of the motion in time: (1/k!) dᵏ(q, v)/dtᵏ for k = 0 … `order`,
    /// row by row. "Not a number" by default.
    ///
    /// `x` has (`order` + 1) [`Lengths::state`] entries, and its first row must contain the state (q,
    /// v). `work` has [`System::taylor_work`] entries with any contents.
    fn taylor(&self, _p: &[S], _order: usize, x: &mut [S], _work: &mut [S]) {
        let state = self.lengths().state();
        x[state..].fill(S::from_f64(f64::NAN));
    }

    /// Writes the rates q̇ = k(q, v) of the coordinates; `out` has the length of `q`.
    fn coordinate_rates(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]);
    /// Writes the mass matrix A(q, v), row by row; `out` has [`Lengths::unknowns`]² entries. The
    /// default is the identity, for equations that give only v̇.
    fn mass_matrix(&self, _p: &[S], _q: &[S], _v: &[S], out: &mut [S]) {
        let n = self.lengths().unknowns();
        for (at, entry) in out.iter_mut().enumerate() {
            *entry = S::int(i64::from(at % (n + 1) == 0));
        }
    }
    /// Writes the forcing b(q, v); `out` has [`Lengths::unknowns`] entries. The default is v̇, for
    /// equations that give only v̇.
    fn forcing(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.accelerations(p, q, v, out);
    }

    /// Writes the mass matrix A and the forcing b at once, like [`System::mass_matrix`] and
    /// [`System::forcing`]. Generated code may compute shared terms only once.
    fn linear_system(&self, p: &[S], q: &[S], v: &[S], matrix: &mut [S], forcing: &mut [S]) {
        self.mass_matrix(p, q, v, matrix);
        self.forcing(p, q, v, forcing);
    }

    /// Number of values that [`System::outputs`] writes.
    fn output_count(&self) -> usize;
    /// Writes the outputs of a state at time `t` after the start, s. They are those that a scene
    /// states, or [`System::whole_state`] if there is no scene. `out` has [`System::output_count`]
    /// entries.
    ///
    /// It has no default, because values that nobody asked for must not appear under other names.
    fn outputs(&self, p: &[S], t: S, q: &[S], v: &[S], out: &mut [S]);
    /// Writes the coordinates q, then the generalized speeds u of the model. `out` has the length of q
    /// and u together.
    fn whole_state(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        let (of_q, of_u) = out.split_at_mut(q.len());
        of_q.copy_from_slice(q);
        self.generalized_speeds(p, q, v, of_u);
    }

    /// True if [`System::energy_gradient`] has values; if false, it gives "not a number".
    fn has_energy_gradient(&self) -> bool {
        false
    }
    /// Returns T + V, and writes ∂(T + V)/∂(q, v) to `out`, which has [`Lengths::state`] entries. All
    /// are "not a number" if [`System::has_energy_gradient`] is false.
    fn energy_gradient(&self, _p: &[S], _q: &[S], _v: &[S], out: &mut [S]) -> S {
        out.fill(S::from_f64(f64::NAN));
        S::from_f64(f64::NAN)
    }

    /// Number of divisors in these equations that may become zero, and that a run therefore watches.
    fn divisor_count(&self) -> usize {
        0
    }
    /// Name of divisor number `at` (from 0), for messages: its formula or, if that is long, its number
    /// among the divisors.
    fn divisor_name(&self, _at: usize) -> &str {
        Default::default()
    }
    /// Writes the divisors at a state; `out` has [`System::divisor_count`] entries. The equations have
    /// no value where a divisor is zero. A step across a change of its sign is not part of a motion.
    fn divisors(&self, _p: &[S], _q: &[S], _v: &[S], out: &mut [S]) {
        out.fill(S::from_f64(f64::NAN));
    }

    /// Number of constraints that a run corrects after each step, because steps may violate them. These
    /// are positions that close loops, and velocities if v can violate motion constraints.
    fn constraint_count(&self) -> usize {
        0
    }
    /// Name of constraint number `at` (from 0), for messages.
    fn constraint_name(&self, _at: usize) -> &str {
        Default::default()
    }
    /// Writes the residuals of the constraints, which are zero where the constraints hold. `out` has
    /// [`System::constraint_count`] entries, each in its own unit.
    fn constraints(&self, _p: &[S], _q: &[S], _v: &[S], out: &mut [S]) {
        out.fill(S::from_f64(f64::NAN));
    }
    /// Writes the derivatives of [`System::constraints`] by (q, v), row by row. `out` has
    /// [`Lengths::state`] entries for each constraint.
    fn constraint_slopes(&self, _p: &[S], _q: &[S], _v: &[S], out: &mut [S]) {
        out.fill(S::from_f64(f64::NAN));
    }

    /// Writes the generalized speeds u of the model file as functions of v; `out` has
    /// [`Lengths::speeds`] entries.
    fn generalized_speeds(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]);
    /// Writes the rates u̇ of the generalized speeds from v̇, so that formulations can be compared.
    /// `out` has `Lengths::speeds` entries.
    fn generalized_speed_rates(&self, p: &[S], q: &[S], v: &[S], v_dot: &[S], out: &mut [S]);
    /// Writes v from the generalized speeds u: the inverse of [`System::generalized_speeds`]. `out` has
    /// `Lengths::variables` entries.
    fn motion_variables(&self, p: &[S], q: &[S], u: &[S], out: &mut [S]);

    /// Kinetic energy T at a state, in joules for a model in SI units.
    fn kinetic_energy(&self, p: &[S], q: &[S], v: &[S]) -> S;
    /// Potential energy V of gravity and of the applied loads that have a potential, in joules for a
    /// model in SI units.
    fn potential_energy(&self, p: &[S], q: &[S]) -> S;
    /// True if [`System::power`] may differ from zero; false if T + V is conserved.
    fn has_power(&self) -> bool {
        false
    }
    /// Power d(T + V)/dt of the loads that V does not contain, in watts for a model in SI units. Zero
    /// if T + V is conserved.
    fn power(&self, _p: &[S], _q: &[S], _v: &[S]) -> S {
        S::from_f64(0.0)
    }

    /// True if [`System::potential_slope`] has values; if false, it gives "not a number".
    fn has_potential_slope(&self) -> bool {
        false
    }
    /// Divided difference V\[a, b\] = (V(b) − V(a))/(b − a) of the potential energy along the first
    /// coordinate. V must depend on no other coordinate. The value is ∂V/∂q at b = a, and nothing
    /// cancels near there. Its unit is that of V divided by that of the coordinate.
    ///
    /// Quadrature computes the motion of one degree of freedom from it. The default is "not a number".
    fn potential_slope(&self, _p: &[S], _a: S, _b: S) -> S {
        S::from_f64(f64::NAN)
    }
    /// Period of the first coordinate, in its unit, positive. The rates of the coordinates, T and V
    /// repeat after it; quadrature uses this. `None` if no period is known.
    fn coordinate_period(&self) -> Option<f64> {
        None
    }
    /// Integrands of quadrature at several values of the coordinate at once, in f64; `None` if they
    /// were not generated. Quadrature spends most of its time in them.
    fn at_points(&self) -> Option<AtPoints<'_>> {
        None
    }
}

/// Writes an N × N Jacobian, row by row. `product` gives the product of the Jacobian with a
/// direction; each unit direction gives a column.
pub fn by_columns<S: Scalar, const N: usize>(out: &mut [S], mut product: impl FnMut(&[S; N]) -> [S; N]) {
    for at in 0..N {
        let mut direction = [S::int(0); N];
        direction[at] = S::int(1);
        for (row, value) in product(&direction).into_iter().enumerate() {
            out[row * N + at] = value;
        }
    }
}
