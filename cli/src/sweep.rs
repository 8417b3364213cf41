//! Output of a sweep: a table, and a summary; an interrupted sweep also has a record with which it can be resumed.

mod kept_rows;
mod record;
mod summary;
mod table;

pub use kept_rows::{Alien, KeptRows};
pub use record::{Record, refused, remove};
pub use summary::Tally;
pub use table::Columns;
