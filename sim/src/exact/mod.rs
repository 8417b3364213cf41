//! Motions known in closed form, against which integrators are checked.
//!
//! Each type is one motion from one start, with its position and rate at any instant, before or after the start.
//! Generic over the scalar: in [`tripos_traits::DoubleDouble`] they give about 30 digits, so that the error measured is
//! the integrator's.
//!
//! ```
//! use tripos_sim::exact::Pendulum;
//! use tripos_traits::{DoubleDouble, Scalar};
//!
//! let [one, three, g] = ["1", "3", "9.81"].map(DoubleDouble::decimal);
//! let pendulum = Pendulum::new(g / one, three, DoubleDouble::int(0)); // 1 m long, released at rest from 3 rad
//! assert_eq!(format!("{:.17}", pendulum.period()), "5.15806675426786591e0");
//! assert_eq!(format!("{:.16}", pendulum.angle(one)), "1.6022489019279172e0");
//! ```
//!
//! Conventions: angles in rad, time in s from the start, other units those of the arguments. The parameter of elliptic
//! functions is m = k². Data without such a motion (a negative moment of inertia, m > 1) give "not a number", never a
//! panic.
//!
//! Absent on purpose: frames, points and models. The motions are compared with those of a model, so they know none.

mod adaptive_quadrature;
mod elliptic;
mod free_body;
mod free_symmetric_body;
mod heavy_top;
mod pendulum;
mod polar_angle;
mod spherical_pendulum;
mod trigonometry;

pub use elliptic::{Elliptic, JacobiValues};
pub use free_body::FreeBody;
pub use free_symmetric_body::{BodyStart, FreeSymmetricBody};
pub use heavy_top::{HeavyTop, Top, TopStart};
pub use pendulum::Pendulum;
pub use spherical_pendulum::SphericalPendulum;
