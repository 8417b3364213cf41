//! Output of a chart: tables, a figure, and words.

pub mod figure;
pub mod files;
pub mod sentences;
