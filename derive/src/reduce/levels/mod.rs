//! Level sets of momenta, which are held constant at the values of a scene.

pub(super) mod constants;
pub(super) mod level;
pub(super) mod momenta;
pub(super) mod separate;
