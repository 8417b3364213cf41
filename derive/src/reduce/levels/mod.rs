//! Level sets of momenta: equations in which momenta are constant at the values of a scene.

pub(super) mod held_momenta;
pub(super) mod momentum_constants;
pub(super) mod momentum_level;
pub(super) mod surface_quotients;
