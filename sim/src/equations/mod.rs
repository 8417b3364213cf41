//! Right-hand sides made from a model's equations of motion: solved at each state, solved in advance, or with
//! derivatives.

pub(crate) mod dynamics;
pub(crate) mod eliminated;
pub(crate) mod tangents;
