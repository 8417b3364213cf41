//! Motions known in closed form, with which integrators are checked.
//!
//! Each type is one motion from one start, with its position and rate at any instant, before or after the start. The
//! types are generic over the scalar: in [`tripos_traits::DoubleDouble`] they give about 30 digits, so that a measured
//! difference is the integrator's error.
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
//! Conventions: angles are in rad, and times in s from the start; other quantities have the units of the arguments. The
//! parameter of elliptic functions is m = k². Data without such a motion (a negative moment of inertia, m > 1) give
//! NaN, never a panic.
//!
//! Absent on purpose: frames, points and models, so that the motions are independent of the models that they check.

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
