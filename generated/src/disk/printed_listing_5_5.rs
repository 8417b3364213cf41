//! Thin disk sliding on a frictionless plane: Lagrange's equations as printed (listing-5.5), E(q) q'' = A(q, q').
//!
//! Generated from `models/disk/publication.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (q1'', q2'', q3'', q4'', q5'').
//! The kinematic equations are singular where cos(q2) = 0.

pub use super::code::printed_listing_5_5::PrintedListing55;

pub use super::printed_lagrange_final::{
    forcing, generalized_speed_rates, kinetic_energy, mass_matrix, motion_variables,
};

pub use super::lagrange::{coordinate_rates, generalized_speeds};

pub use super::kane::potential_energy;
