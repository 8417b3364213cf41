//! Thin disk sliding on a frictionless plane.
//!
//! Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.
//! 6 configuration variables, 1 holonomic constraint, 5 generalized coordinates, 0 nonholonomic constraints, 5 generalized speeds.

#[rustfmt::skip]
pub mod kane;
#[rustfmt::skip]
pub mod kane_q2_90deg;
#[rustfmt::skip]
pub mod lagrange;
#[rustfmt::skip]
pub mod lagrange_q2_90deg;
#[rustfmt::skip]
pub mod newton_euler;
#[rustfmt::skip]
pub mod newton_euler_q2_90deg;
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
#[rustfmt::skip]
pub mod scenes;
use tripos_traits::{CompiledModel, CompiledSystem, Derivative, InLanes, Scalar};

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
    #[inline(always)]
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
        CompiledSystem {
            name: "kane",
            double: &kane::Kane,
            extended: &kane::Kane,
            lanes: Some(InLanes::of(&Derivative(kane::Kane))),
        },
        CompiledSystem {
            name: "kane@q2-90deg",
            double: &kane_q2_90deg::KaneQ290deg,
            extended: &kane_q2_90deg::KaneQ290deg,
            lanes: Some(InLanes::of(&Derivative(kane_q2_90deg::KaneQ290deg))),
        },
        CompiledSystem {
            name: "lagrange",
            double: &lagrange::Lagrange,
            extended: &lagrange::Lagrange,
            lanes: Some(InLanes::of(&Derivative(lagrange::Lagrange))),
        },
        CompiledSystem {
            name: "lagrange@q2-90deg",
            double: &lagrange_q2_90deg::LagrangeQ290deg,
            extended: &lagrange_q2_90deg::LagrangeQ290deg,
            lanes: Some(InLanes::of(&Derivative(lagrange_q2_90deg::LagrangeQ290deg))),
        },
        CompiledSystem {
            name: "newton-euler",
            double: &newton_euler::NewtonEuler,
            extended: &newton_euler::NewtonEuler,
            lanes: Some(InLanes::of(&Derivative(newton_euler::NewtonEuler))),
        },
        CompiledSystem {
            name: "newton-euler@q2-90deg",
            double: &newton_euler_q2_90deg::NewtonEulerQ290deg,
            extended: &newton_euler_q2_90deg::NewtonEulerQ290deg,
            lanes: Some(
                InLanes::of(&Derivative(newton_euler_q2_90deg::NewtonEulerQ290deg)),
            ),
        },
        CompiledSystem {
            name: "printed:kane-final",
            double: &printed_kane_final::PrintedKaneFinal,
            extended: &printed_kane_final::PrintedKaneFinal,
            lanes: None,
        },
        CompiledSystem {
            name: "printed:lagrange-final",
            double: &printed_lagrange_final::PrintedLagrangeFinal,
            extended: &printed_lagrange_final::PrintedLagrangeFinal,
            lanes: None,
        },
        CompiledSystem {
            name: "printed:newton-euler-final",
            double: &printed_newton_euler_final::PrintedNewtonEulerFinal,
            extended: &printed_newton_euler_final::PrintedNewtonEulerFinal,
            lanes: None,
        },
        CompiledSystem {
            name: "printed:listing-5.4",
            double: &printed_listing_5_4::PrintedListing54,
            extended: &printed_listing_5_4::PrintedListing54,
            lanes: None,
        },
        CompiledSystem {
            name: "printed:listing-5.5",
            double: &printed_listing_5_5::PrintedListing55,
            extended: &printed_listing_5_5::PrintedListing55,
            lanes: None,
        },
        CompiledSystem {
            name: "printed:listing-5.6",
            double: &printed_listing_5_6::PrintedListing56,
            extended: &printed_listing_5_6::PrintedListing56,
            lanes: None,
        },
    ],
    scenes: scenes::SCENES,
};
