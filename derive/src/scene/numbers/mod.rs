//! Numbers of scene and state files: formulas, tables, positions and velocities by name.

pub(super) mod places;
pub(super) mod table;
pub(super) mod values;
