//! Slices: the smallest set of variables that determines the outputs of a scene.

pub(super) mod dependence;
pub(super) mod one_degree;
pub(super) mod outputs;
pub(super) mod slice;
