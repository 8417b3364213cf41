//! One formulation of one model, as numbers.

use crate::Scalar;

/// Equations of motion  A(q, v) x = b(q, v),  q̇ = k(q, v).
///
/// `q` holds the n generalized coordinates and `v` the n motion variables that the formulation
/// integrates: the generalized speeds u for Kane and Newton–Euler, the coordinate rates q̇ for
/// Lagrange. The unknowns x are v̇, followed by `reactions` reaction forces and torques. `p` holds
/// the parameters in the order of the model file. All slices have exactly the stated lengths;
/// implementations may panic on others.
pub trait System<S: Scalar = f64> {
    /// Number of parameters, the length of `p`.
    fn parameters(&self) -> usize;
    /// Number of generalized coordinates, the length of `q`.
    fn coordinates(&self) -> usize;
    /// Number of motion variables, the length of `v`.
    fn speeds(&self) -> usize;
    /// Number of reactions among the unknowns, after v̇.
    fn reactions(&self) -> usize;
    /// Number of unknowns: the order of the linear system.
    fn unknowns(&self) -> usize {
        self.speeds() + self.reactions()
    }
    /// Whether `mass_matrix` is symmetric and, away from singular configurations, positive definite.
    fn symmetric(&self) -> bool;

    /// q̇ = k(q, v); `out` has `coordinates` entries.
    fn coordinate_rates(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]);
    /// A(q, v), row by row; `out` has `unknowns`² entries.
    fn mass_matrix(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]);
    /// b(q, v); `out` has `unknowns` entries.
    fn forcing(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]);

    /// Generalized speeds u of the model file, from v; `out` has `speeds` entries.
    fn generalized_speeds(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]);
    /// u̇ from v̇, so that formulations compare key by key.
    fn generalized_speed_rates(&self, p: &[S], q: &[S], v: &[S], v_dot: &[S], out: &mut [S]);
    /// v from the generalized speeds u: the inverse of [`System::generalized_speeds`].
    fn motion_variables(&self, p: &[S], q: &[S], u: &[S], out: &mut [S]);

    /// Kinetic energy T, in joules for a model in SI units.
    fn kinetic_energy(&self, p: &[S], q: &[S], v: &[S]) -> S;
    /// Potential energy V of gravity, zero where the model file puts its zero.
    fn potential_energy(&self, p: &[S], q: &[S]) -> S;
}

/// A model whose equations are compiled in: what a program needs to find and to trust them.
pub struct CompiledModel {
    /// The folder's name under `models/`.
    pub name: &'static str,
    /// Hash of the model text the equations were derived from, as the deriving crate computes it.
    pub text_hash: &'static str,
    /// Hash of the text of the report whose printed equations are compiled in; empty if there is none.
    pub report_hash: &'static str,
    /// Equations by name: each supported formulation (`kane`, `lagrange`, `newton-euler`), then those of the
    /// report (`printed:ID`).
    pub systems: &'static [(&'static str, &'static (dyn System<f64> + Sync))],
}
