//! Sweeps: runs of a scene from many starts or with many parameters. Each run gives a row of a
//! table.
//!
//! Invariants:
//! - A row equals the result of `tripos simulate` for the scene with the values of its point. It
//!   agrees to the bit, or to rounding in lanes (vector registers). It does not depend on threads,
//!   blocks, shards or earlier points.
//! - Computations that do not depend on the point are done once: derivation, compilation of
//!   formulas, search for compiled equations.
//! - Rows are written in the order of their points. The number of rows that wait for an earlier row
//!   is bounded.
//! - No point ends the sweep. A point that cannot start or continue gives a row with the reason.

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
