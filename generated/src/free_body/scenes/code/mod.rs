//! Symmetric rigid body free of forces: the code of the equations of its scenes.
//!
//! Generated from `models/free_body/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod steady;
