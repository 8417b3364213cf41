//! Printed linear systems and printed programs (listings), judged and solved for their motion.

pub(super) mod consequences;
mod findings;
mod held_time;
pub(super) mod listings;
pub mod motion;
pub(super) mod printed_equations;
pub(super) mod systems;
mod whole_rows;
