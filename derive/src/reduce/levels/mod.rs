//! Level sets of momenta: equations in which momenta are constant at the values of a scene.

pub(super) mod constants;
pub(super) mod level;
pub(super) mod momenta;
pub(super) mod separate;
