//! What a run needs before its first step: where it starts, which equations it uses, what may happen on its way.

pub(super) mod frame_start;
pub(super) mod impacts;
pub(super) mod near_divisors;
pub mod passage;
pub(super) mod problem;
pub(super) mod reduced;
pub(super) mod start;
