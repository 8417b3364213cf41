//! Families of scenes: one file read for many values of some of its numbers.

pub(super) mod axis;
pub(super) mod family;
pub(super) mod ladder;
pub(super) mod neighbours;
