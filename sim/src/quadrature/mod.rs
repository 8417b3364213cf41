//! Motion of one degree of freedom by quadrature instead of stepping.
//!
//! With the energy h = ½ m(q) v² + V(q) and q′ = k(q) v, time is an integral over the coordinate, dt = dq/(k √(2 (h −
//! V)/m)). Every other coordinate whose rate depends on q and v alone is an integral, too. The integrals are computed
//! once, as series of Legendre polynomials on panels (subintervals) that are halved until all series are resolved to
//! rounding. The state at any instant then follows by one inversion. Whole periods are added exactly: errors grow only
//! by the rounding error of the period.
//!
//! Invariants: the integrands are smooth where the motion turns, since each stretch is half a swing in a variable that
//! makes them smooth. The difference h − V is never computed from nearly equal energies: it is the divided difference
//! of V times the distance from a turning point ([`tripos_traits::System::potential_slope`]).
//!
//! Absent on purpose: friction, forces that depend on time, and unlimited work. A motion that is not resolved by the
//! allowed number of panels is refused with its reason.

mod energy;
mod integrand_sampler;
mod legendre_rule;
mod motion_by_quadrature;
mod motion_kind;
mod quadrature_error;
mod quadrature_run;
mod stretch;
mod stretch_variable;

pub use motion_by_quadrature::MotionByQuadrature;
pub use quadrature_error::NoQuadrature;
pub use quadrature_run::run_by_quadrature;
