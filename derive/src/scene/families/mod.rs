//! Families of scenes: a scene file, read again for many values of its numbers.

pub(super) mod neighbours;
pub(super) mod scene_family;
pub(super) mod start_ladder;
pub(super) mod sweep_grid;
