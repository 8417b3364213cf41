//! One file a command.

pub mod derive;
pub mod evaluate;
pub mod regenerate;
pub mod report;
pub mod simulate;
