//! Studies of mechanisms: charts, sweeps, derivatives, steady motions, inverse dynamics and
//! identification.

pub mod abbreviation;
pub mod chart_case;
pub mod figure;
pub mod identification;
pub mod inverse;
mod method_at_tolerance;
pub mod model_analysis;
pub mod sensitivity;
pub mod stability;
pub mod steady;
pub mod sweep;
#[cfg(feature = "clock")]
pub mod work_precision_chart;
