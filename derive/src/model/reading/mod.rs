//! Sections of a model file that need no others to be read: names, parameters, expressions, repetition.

pub(super) mod domain;
pub(super) mod expressions;
pub(super) mod names;
pub(super) mod parameters;
pub(super) mod reader;
pub(super) mod repetition;
pub(super) mod tree;
pub(super) mod unknown_names;
