//! Selection of variables: the smallest set that determines the outputs of a scene (its slice).

pub(super) mod dependence;
pub(super) mod potential_difference;
pub(super) mod slice;
pub(super) mod wanted_outputs;
