//! Motion, inertia, energy and loads of the bodies, which all formulations use.

pub(super) mod composite_bodies;
pub(super) mod energy;
pub(super) mod equation_form;
pub(super) mod inertial_anchor;
pub(super) mod inertial_parameter;
pub(super) mod kinematics;
pub(super) mod loads;
pub(super) mod placed_inertia;
pub(super) mod potential;
pub(super) mod tree_accelerations;
