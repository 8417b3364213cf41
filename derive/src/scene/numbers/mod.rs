//! Numbers of scene and state files: formulas, tables of signals, positions and velocities.

pub(super) mod places;
pub(super) mod table;
pub(super) mod values;
