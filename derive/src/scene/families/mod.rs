//! Families of scenes: one scene file, read for many values of its numbers.

pub(super) mod axis;
pub(super) mod family;
pub(super) mod ladder;
pub(super) mod neighbours;
