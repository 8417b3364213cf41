//! Kinematics, inertia, energy and loads of the bodies, which all formulations use.

pub(super) mod anchor;
pub(super) mod carried_accelerations;
pub(super) mod carry;
pub(super) mod composite;
pub(super) mod energy;
pub(super) mod form;
pub(super) mod inertial;
pub(super) mod kinematics;
pub(super) mod loads;
pub(super) mod potential;
