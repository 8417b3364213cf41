//! Constraints of a run: equations of motion with multipliers, and corrections of states that violate
//! constraints.

pub(crate) mod correction;
pub(crate) mod multipliers;
pub(crate) mod nearest_state;
