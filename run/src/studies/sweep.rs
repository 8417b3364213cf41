//! Sweeps: runs of a scene from many starts or with many parameters, each of which gives a row of a table.
//!
//! Invariants:
//! - A row equals the result of `tripos simulate` for the scene with the values of its point, to the bit, or to
//!   rounding in lanes. It does not depend on threads, on the cutting of points into blocks or shards, or on earlier
//!   points.
//! - Work that does not depend on the point is done once: derivation, compilation of formulas, finding compiled
//!   equations.
//! - Rows are written in the order of their points. The number of rows that wait for an earlier one is bounded.
//! - No point ends the sweep. A point that cannot start or go on gives a row with the reason.

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
