//! Output of a sweep: table, summary, and the record by which an interrupted sweep is resumed.

mod kept_rows;
mod record;
mod summary;
mod table;

pub use kept_rows::{Alien, KeptRows};
pub use record::{Record, refused, remove};
pub use summary::Tally;
pub use table::Columns;
