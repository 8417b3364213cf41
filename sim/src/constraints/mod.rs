//! Constraints of a run: their multipliers, and corrections of states that violate them.

pub(crate) mod correction;
pub(crate) mod multipliers;
pub(crate) mod placement;
