//! All tests of the command, as one program.

mod changed_force;
mod charts;
mod command_line;
mod differences;
mod edited_model;
mod emit;
mod files;
mod hostile;
mod latex;
mod numbers;
mod page;
mod random_scenes;
mod regenerate;
mod scene;
mod spoilt;
mod support;
mod sweep;
mod sweep_lanes;
mod trust;
