//! Preparation of a run: its start, its equations, its contacts, and changes of its generalized
//! speeds.

pub(super) mod frame_start;
pub(super) mod impacts;
pub(super) mod initial;
pub(super) mod near_divisors;
pub mod passage;
pub(super) mod problem;
pub(super) mod reduced;
pub(super) mod start;
