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
mod dense_output;
mod driver;
mod equations;
mod error;
pub mod error_growth;
mod error_test;
pub mod events;
pub mod exact;
pub mod linear;
mod methods;
pub mod projection;
pub mod quadrature;
mod right_hand_side;
pub mod rigorous_run;
mod rounding;
mod solution;
mod step_polynomial;
mod stepper;
mod transposed_right_hand_side;
mod warning;
pub mod work_precision;

pub use constraints::multipliers::{DistancesFromSingularity, Multipliers};
pub use contacts::closed_contacts::{ClosedContacts, ImpactRecord, ImpactShare};
pub use contacts::friction::{ContactMode, ContactSolution, UndecidedContacts};
pub use driver::integrate::{integrate, integrate_projected};
pub use driver::second_run::{SecondRun, TaylorSeries, second_runs};
pub use equations::dynamics::Dynamics;
pub use equations::eliminated::EliminatedDynamics;
pub use equations::tangents::DynamicsWithTangents;
pub use error::{Failure, SimError};
pub use error_test::SMALLEST_RTOL;
pub use events::corners::{Corner, SLOPE_DIRECTIONS};
pub use events::{Effect, Event, EventFunction, EventRecord, InRanges, Kind, RangeFunction};
pub use methods::dormand_prince::DORMAND_PRINCE_54;
pub use methods::dormand_prince_853::{DORMAND_PRINCE_853, Decimal, Published853, Row};
pub use methods::run_options::{Options, OutputOption, Poll};
pub use methods::tableau::{Fraction, Tableau};
pub use right_hand_side::{
    AccompaniedRightHandSide, HandsOver, LentRightHandSide, PowerAt, RightHandSide, WithJacobian, Yields,
};
pub use solution::{Solution, Stop};
pub use transposed_right_hand_side::{ProductSums, TransposedRightHandSide};
pub use tripos_traits::{ATOL, AbsoluteTolerance, Direction, Method, RTOL};
pub use warning::Warning;
