//! Printed linear systems and printed programs (listings), judged and solved for their motion.

pub(super) mod consequences;
pub(super) mod linear_systems;
pub(super) mod listings;
mod partial_time_derivative;
pub(super) mod printed_equations;
pub mod printed_motion;
mod row_findings;
mod whole_rows;
