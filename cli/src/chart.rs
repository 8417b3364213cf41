//! Output of a speed chart: tables, a figure, and sentences.

pub mod chart_tables;
pub mod figure;
pub mod sentences;
