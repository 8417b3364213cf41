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

// The examples of `README.md` are tested as doc tests, too.
#![cfg_attr(doctest, doc = include_str!("../README.md"))]
#![cfg_attr(test, allow(clippy::float_cmp, reason = "exact answers are compared exactly"))]

pub mod adjoint;
pub mod batch;
mod blocks;
mod constraints;
mod contacts;
mod driver;
mod equations;
mod error;
pub mod events;
pub mod exact;
pub mod linear;
mod methods;
mod polynomial;
pub mod projection;
pub mod quadrature;
mod rhs;
mod rounding;
mod solution;
pub mod stability;
mod stepper;
mod tolerance;
mod warning;
pub mod work_precision;

pub use constraints::multipliers::{Multipliers, Standing};
pub use contacts::friction::{ContactSolution, Mode, Undecided};
pub use contacts::impact::{ClosedContacts, ImpactRecord, Share};
pub use driver::integrate::{integrate, integrate_projected};
pub use driver::second::{Second, TaylorSeries, seconds};
pub use equations::dynamics::Dynamics;
pub use equations::eliminated::Eliminated;
pub use equations::tangents::Tangents;
pub use error::{Failure, SimError};
pub use events::corners::{Corner, DIRECTIONS};
pub use events::{Effect, Event, EventFunction, EventRecord, InRanges, Kind, RangeFunction};
pub use methods::dormand_prince::DORMAND_PRINCE_54;
pub use methods::dormand_prince_853::{DORMAND_PRINCE_853, Decimal, Published853, Row};
pub use methods::options::{Options, Output, Poll};
pub use methods::tableau::{Fraction, Tableau};
pub use rhs::{Accompanied, HandsOver, Lent, PowerAt, Pulled, RightHandSide, Transposed, WithJacobian, Yields};
pub use solution::{Solution, Stop};
pub use tolerance::SMALLEST_RTOL;
pub use tripos_traits::{ATOL, AbsoluteTolerance, Direction, Method, RTOL};
pub use warning::Warning;
