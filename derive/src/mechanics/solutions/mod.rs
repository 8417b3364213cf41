//! Results computed from equations of motion, such as accelerations. Each result is proved from the equations.

pub(super) mod abbreviation;
pub(super) mod accelerations;
pub(super) mod certificate;
pub(super) mod divisors;
pub(super) mod equations_in_distance;
pub(super) mod inertia_check;
pub(super) mod jacobian;
pub(super) mod proved_jacobians;
pub(super) mod quantities;
pub(super) mod regressor;
