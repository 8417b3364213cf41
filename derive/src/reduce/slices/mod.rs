//! Selection of variables: the smallest set that determines the outputs of a scene (its slice).

pub(super) mod dependence;
pub(super) mod one_degree;
pub(super) mod outputs;
pub(super) mod slice;
