//! Output of a sweep: a table, and a summary; if it is interrupted, a record with which it can go on.

mod kept;
mod record;
mod summary;
mod table;

pub use kept::{Alien, Kept};
pub use record::{Record, refused, remove};
pub use summary::Tally;
pub use table::Columns;
