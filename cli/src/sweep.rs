//! Output of a sweep: a table, and a summary; an interrupted sweep also has a record with which it can be resumed.

mod kept;
mod record;
mod summary;
mod table;

pub use kept::{Alien, KeptRows};
pub use record::{Record, refused, remove};
pub use summary::Tally;
pub use table::Columns;
