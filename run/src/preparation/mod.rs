//! Preparation of a run: its start, its equations, its contacts, and changes of its generalized
//! speeds.

pub(super) mod exact_start;
pub(super) mod impacts;
pub(super) mod initial_state;
pub(super) mod moving_frame_start;
pub(super) mod near_divisors;
pub(super) mod problem;
pub(super) mod reduced_equations;
pub(super) mod reduced_start;
pub mod speed_changes;
