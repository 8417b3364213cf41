//! Preparation of a run: its start, its equations, and the contacts and changes of speeds on its way.

pub(super) mod frame_start;
pub(super) mod impacts;
pub(super) mod initial;
pub(super) mod near_divisors;
pub mod passage;
pub(super) mod problem;
pub(super) mod reduced;
pub(super) mod start;
