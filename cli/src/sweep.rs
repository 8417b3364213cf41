//! Output of a sweep: table, summary, and the record with which an interrupted sweep is resumed.

mod growing_table;
mod kept_rows;
mod summary;
mod sweep_record;
mod table;

pub use growing_table::GrowingTable;
pub use kept_rows::{KeptRows, UnfinishedTableMismatch};
pub use summary::Tally;
pub use sweep_record::{Record, other_sweep_failure, remove_record};
pub use table::Columns;
