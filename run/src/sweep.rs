//! Sweeps: a scene from many starts or with many parameters, a row of a table for each.
//!
//! Invariants:
//! - A row is what `tripos simulate` gives for the scene with the values of its point, to the bit, or to rounding in lanes. It
//!   depends on nothing else: neither on threads, nor on how points are cut into blocks or shards, nor on the points before it.
//! - What does not depend on the point is done once: derivation, compilation of formulas, finding compiled equations.
//! - Rows are written in the order of their points; how many wait for an earlier one is bounded.
//! - No point ends the sweep. One that cannot start or go on is a row with its reason.

mod block;
#[cfg(feature = "threads")]
mod in_order;
mod lanes;
#[cfg(not(feature = "threads"))]
mod one_by_one;
mod row;
mod shard;

pub use block::{Sweep, Worker};
#[cfg(feature = "threads")]
pub use in_order::in_order;
#[cfg(not(feature = "threads"))]
pub use one_by_one::in_order;
pub use row::{Ended, NO_START, Row};
pub use shard::Shard;
