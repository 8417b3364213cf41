//! Sweeps: runs of a scene from many starts or with many values of its parameters. Each run gives a row
//! of a table.
//!
//! Invariants:
//! - A row equals the result of `tripos simulate` for the scene with the values of the row's point. It
//!   agrees to the bit, or to rounding in lanes (vector registers). By reduced equations it agrees to the errors
//!   of the run, if the sweep varies parameters: they stay symbols, for which `simulate` puts numbers. A row does
//!   not depend on threads, blocks, shards or earlier points.
//! - Computations that do not depend on the point are done once: derivation, compilation of
//!   formulas, search for compiled equations.
//! - Rows are written in the order of their points. The number of rows that wait for an earlier row is
//!   bounded.
//! - The failure of a point does not end the sweep. The row of such a point gives the reason.

mod full_equations;
mod lanes;
#[cfg(feature = "threads")]
mod ordered_work;
mod own_equations;
mod point_problem;
mod shard;
mod sweep_row;
mod sweep_worker;
mod swept_scene;
#[cfg(not(feature = "threads"))]
mod unthreaded_work;

#[cfg(feature = "threads")]
pub use ordered_work::work_in_order;
pub use shard::Shard;
pub use sweep_row::{NO_START, RunEnd, SweepRow};
pub use sweep_worker::SweepWorker;
pub use swept_scene::Sweep;
#[cfg(not(feature = "threads"))]
pub use unthreaded_work::work_in_order;
