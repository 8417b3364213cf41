//! Numbers in scene and state files: formulas, tables of signals, positions and velocities.

pub(super) mod named_positions;
pub(super) mod number_reader;
pub(super) mod scene_number;
pub(super) mod signal_table;
