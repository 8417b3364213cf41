//! Families of scenes: a scene file, read again for many values of its numbers.

pub(super) mod axis;
pub(super) mod family;
pub(super) mod ladder;
pub(super) mod neighbours;
