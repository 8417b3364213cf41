//! Reading of model files: names, notation, parameters, expressions, repetition and domain.

pub(super) mod declared_names;
pub(super) mod domain;
pub(super) mod loading;
pub(super) mod named_expressions;
pub(super) mod notation;
pub(super) mod number_parameters;
pub(super) mod parameters;
pub(super) mod repetition;
pub(super) mod tree;
pub(super) mod unknown_names;
