//! Campaigns for the readers, by kind of input.

mod certificates;
pub mod commands;
mod files;
mod formulas;
mod programs;
mod robots;
mod tables;
