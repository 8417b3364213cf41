//! Two versions of a model or a scene compared.

pub(super) mod declared;
pub(super) mod models;
pub(super) mod scenes;
