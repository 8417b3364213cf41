//! Output of a speed chart: tables, a figure, and sentences.

pub mod figure;
pub mod files;
pub mod sentences;
