//! What a sweep leaves behind: a table, and a summary.

mod summary;
mod table;

pub use summary::Tally;
pub use table::Columns;
