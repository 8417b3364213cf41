//! Printed linear systems and printed programs (listings), judged and solved for their motion.

pub(super) mod consequences;
pub(super) mod judged_system;
pub(super) mod listings;
pub mod motion_system;
mod partial_time_derivative;
pub(super) mod printed_equations;
mod row_findings;
mod whole_rows;
