//! Right-hand sides made of a model's equations of motion: solved at each state, eliminated in advance,
//! or with derivatives.

pub(crate) mod dynamics;
pub(crate) mod eliminated;
pub(crate) mod tangents;
