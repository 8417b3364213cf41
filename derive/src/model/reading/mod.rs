//! Basic parts of the reading of model files: names, notation, parameters, expressions, repetition
//! and domain.

pub(super) mod domain;
pub(super) mod expressions;
pub(super) mod literals;
pub(super) mod names;
pub(super) mod notation;
pub(super) mod parameters;
pub(super) mod reader;
pub(super) mod repetition;
pub(super) mod tree;
pub(super) mod unknown_names;
