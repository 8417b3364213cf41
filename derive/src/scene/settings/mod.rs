//! Settings of a scene: inputs, integration, outputs, claims and contacts.

pub(super) mod claims;
pub(super) mod impacts;
pub(super) mod inputs;
pub(super) mod integration;
pub(super) mod outputs;
