//! Comparison of two versions of a model or a scene.

pub(super) mod declaration_changes;
pub(super) mod derived_model;
pub(super) mod model_changes;
pub(super) mod scene_changes;
pub(super) mod variable_changes;
