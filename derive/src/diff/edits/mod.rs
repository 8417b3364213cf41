//! Comparison of two versions of a model or a scene.

pub(super) mod declarations;
pub(super) mod derived_model;
pub(super) mod models;
pub(super) mod scenes;
pub(super) mod variables;
