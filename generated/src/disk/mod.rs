//! Thin disk sliding on a frictionless plane.
//!
//! Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.
//! 6 configuration variables, 1 holonomic constraint, 5 generalized coordinates, 0 nonholonomic constraints, 5 generalized speeds.

#[rustfmt::skip]
pub mod kane;
#[rustfmt::skip]
pub mod lagrange;
#[rustfmt::skip]
pub mod newton_euler;
#[rustfmt::skip]
pub mod printed_kane_final;
#[rustfmt::skip]
pub mod printed_lagrange_final;
#[rustfmt::skip]
pub mod printed_newton_euler_final;
#[rustfmt::skip]
pub mod printed_listing_5_4;
#[rustfmt::skip]
pub mod printed_listing_5_5;
#[rustfmt::skip]
pub mod printed_listing_5_6;
use tripos_traits::{CompiledModel, Scalar};

/// The parameters, in the order of the model file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// mass of the disk, kg
    pub M: S,
    /// radius of the disk, m
    pub R: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
}

impl<S: Scalar> Parameters<S> {
    /// From values in the order of [`PARAMETERS`].
    ///
    /// # Panics
    /// If `p` has fewer values than there are parameters.
    #[must_use]
    pub fn from_slice(p: &[S]) -> Self {
        Self { M: p[0], R: p[1], g: p[2] }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 3] = ["M", "R", "g"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 5] = ["q1", "q2", "q3", "q4", "q5"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 5] = ["u1", "u2", "u3", "u4", "u5"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "disk",
    text_hash: "54a1cd4035aa304c",
    report_hash: "e3e31532fb92edb5",
    systems: &[
        ("kane", &kane::Kane),
        ("lagrange", &lagrange::Lagrange),
        ("newton-euler", &newton_euler::NewtonEuler),
        ("printed:kane-final", &printed_kane_final::PrintedKaneFinal),
        ("printed:lagrange-final", &printed_lagrange_final::PrintedLagrangeFinal),
        (
            "printed:newton-euler-final",
            &printed_newton_euler_final::PrintedNewtonEulerFinal,
        ),
        ("printed:listing-5.4", &printed_listing_5_4::PrintedListing54),
        ("printed:listing-5.5", &printed_listing_5_5::PrintedListing55),
        ("printed:listing-5.6", &printed_listing_5_6::PrintedListing56),
    ],
};
