//! What a chart leaves behind: tables, a figure, and words.

pub mod figure;
pub mod files;
pub mod words;
