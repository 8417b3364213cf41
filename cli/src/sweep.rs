//! What a sweep leaves behind: a table, and a summary; and, where it does not come to its end, what it takes to go on.

mod kept;
mod record;
mod summary;
mod table;

pub use kept::{Alien, Kept};
pub use record::{Record, refused, remove};
pub use summary::Tally;
pub use table::Columns;
