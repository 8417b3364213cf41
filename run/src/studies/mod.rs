//! Studies of mechanisms: charts, sweeps, derivatives, steady motions, inverse dynamics and
//! identification.

pub mod case;
#[cfg(feature = "clock")]
pub mod chart;
pub mod figure;
pub mod identify;
pub mod inverse;
pub mod sensitivity;
pub mod stability;
pub mod steady;
pub mod study;
pub mod sweep;
