//! Runs equations of motion: integrators, events, energies.
//!
//! ```
//! use tripos_sim::{Direction, Event, Options, integrate};
//!
//! // A pendulum of 1 m released at rest from 1 rad; the first swing ends where the rate rises to 0.
//! let pendulum = |_t: f64, y: &[f64], dydt: &mut [f64]| {
//!     dydt[0] = y[1];
//!     dydt[1] = -9.81 * y[0].sin();
//!     Ok(())
//! };
//! let turn = Event::terminal("far side", Direction::Rising, |_t, y: &[f64]| y[1]);
//! let options = Options::tolerances(1e-10, 1e-12);
//! let solution = integrate(pendulum, (0.0, 10.0), &[1.0, 0.0], &options, &mut [turn])?;
//!
//! assert_eq!(solution.stop.code(), "event:far side");
//! assert!((solution.t_end - 2.139_137_600_558_688_8 / 2.0).abs() < 1e-6); // half the period
//! assert!((solution.y_end[0] + 1.0).abs() < 1e-6);
//! # Ok::<(), tripos_sim::SimError>(())
//! ```
//!
//! Invariants:
//! - A question is either refused ([`SimError`]) or answered with a [`Solution`] that says why it
//!   ended; no number makes the crate panic or loop for ever.
//! - Watching events and asking for output never changes a step.
//! - The same question gives the same bits.
//!
//! Methods ([`Method`]): `ode45` and `dopri5` (order 5), `dop853` (order 8), `gauss6` (order 6, implicit, conserving),
//! `radau5` (order 5, implicit, for stiff equations) and `taylor` (of the order that the tolerance asks for) choose
//! their steps by the error; each of them and `rk4` also takes equal steps ([`Options::step`]). The state may be of any
//! [`tripos_traits::Real`].
//!
//! Many trajectories of one set of equations are integrated faster together: [`batch`].
//!
//! Units are those of the equations, time in s. Absent on purpose: models. The crate knows
//! equations by the trait [`tripos_traits::System`] ([`Dynamics`] joins one to the integrator) or
//! as a closure.

#![cfg_attr(test, allow(clippy::float_cmp, reason = "exact answers are compared exactly"))]

pub mod adjoint;
pub mod batch;
mod blocks;
mod control;
mod corners;
mod correction;
mod dense;
mod dop853;
mod dormand_prince;
mod dormand_prince_853;
mod doubt;
mod dynamics;
mod eliminated;
mod error;
pub mod events;
pub mod exact;
mod explicit;
mod friction;
mod gauss;
mod guard;
mod impact;
mod integrate;
mod isolate;
pub mod linear;
mod lu;
mod method;
mod metric;
mod multipliers;
mod options;
mod pace;
mod placement;
mod polynomial;
pub mod projection;
pub mod quadrature;
mod radau;
mod recorder;
mod rhs;
mod rk4;
mod root;
mod run;
mod samples;
mod search;
mod second;
mod singular;
mod solution;
pub mod stability;
mod stepper;
mod tableau;
mod tangents;
mod taylor;
mod tolerance;
mod walk;
mod warning;
mod watch;
mod work;
pub mod work_precision;

pub use corners::{Corner, DIRECTIONS};
pub use dormand_prince::DORMAND_PRINCE_54;
pub use dormand_prince_853::{DORMAND_PRINCE_853, Decimal, Published853, Row};
pub use dynamics::Dynamics;
pub use eliminated::Eliminated;
pub use error::{Failure, SimError};
pub use events::{Effect, Event, EventFunction, EventRecord, InRanges, Kind, RangeFunction};
pub use friction::{Found, Mode, Undecided};
pub use impact::{Closed, ImpactRecord, Share};
pub use integrate::{integrate, integrate_projected};
pub use multipliers::{Multipliers, Standing};
pub use options::{Options, Output, Poll};
pub use rhs::{Accompanied, HandsOver, Lent, PowerAt, Pulled, RightHandSide, Transposed, WithJacobian, Yields};
pub use second::{Second, seconds};
pub use solution::{Solution, Stop};
pub use tableau::{Fraction, Tableau};
pub use tangents::Tangents;
pub use tolerance::SMALLEST_RTOL;
pub use tripos_traits::{ATOL, AbsoluteTolerance, Direction, Method, RTOL};
pub use warning::Warning;
