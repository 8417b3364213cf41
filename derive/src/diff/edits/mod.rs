//! Comparison of two versions of a model or a scene.

pub(super) mod declared;
pub(super) mod derived;
pub(super) mod models;
pub(super) mod scenes;
pub(super) mod variables;
