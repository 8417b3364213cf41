// Thin disk sliding on a frictionless plane.
//
// Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.
// 6 configuration variables, 1 holonomic constraint, 5 generalized coordinates, 0 nonholonomic constraints, 5 generalized speeds.

/// Kane's method.
#[rustfmt::skip]
pub mod kane;

/// Lagrange's equations.
#[rustfmt::skip]
pub mod lagrange;

/// Newton–Euler equations.
#[rustfmt::skip]
pub mod newton_euler;

/// Kane's method as printed (kane-final).
#[rustfmt::skip]
pub mod printed_kane_final;

/// Lagrange's equations as printed (lagrange-final).
#[rustfmt::skip]
pub mod printed_lagrange_final;

/// Newton–Euler equations as printed (newton-euler-final).
#[rustfmt::skip]
pub mod printed_newton_euler_final;

/// Kane's method as printed (listing-5.4).
#[rustfmt::skip]
pub mod printed_listing_5_4;

/// Lagrange's equations as printed (listing-5.5).
#[rustfmt::skip]
pub mod printed_listing_5_5;

/// Newton–Euler equations as printed (listing-5.6).
#[rustfmt::skip]
pub mod printed_listing_5_6;

/// The code of the equations.
#[rustfmt::skip]
#[allow(non_snake_case, clippy::let_and_return)]
pub mod code;

/// The equations of its scenes.
#[rustfmt::skip]
pub mod scenes;

use tripos_traits::{CompiledModel, CompiledSystem, Derivative, InLanes, Scalar};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
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
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 3] {
        let Self { M, R, g, .. } = self;
        [M, R, g]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            M: S::int(1),
            R: S::int(1),
            g: S::ratio(981, 100),
        }
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
    publication_hash: "0605eac23fe5d309",
    systems: &[
        CompiledSystem {
            name: "kane",
            double: &code::kane::Kane,
            extended: &code::kane::Kane,
            lanes: Some(
                InLanes::of(&Derivative(code::kane::Kane))
                    .with_series(&Derivative(code::kane::Kane)),
            ),
        },
        CompiledSystem {
            name: "lagrange",
            double: &code::lagrange::Lagrange,
            extended: &code::lagrange::Lagrange,
            lanes: Some(
                InLanes::of(&Derivative(code::lagrange::Lagrange))
                    .with_series(&Derivative(code::lagrange::Lagrange)),
            ),
        },
        CompiledSystem {
            name: "newton-euler",
            double: &code::newton_euler::NewtonEuler,
            extended: &code::newton_euler::NewtonEuler,
            lanes: Some(
                InLanes::of(&Derivative(code::newton_euler::NewtonEuler))
                    .with_series(&Derivative(code::newton_euler::NewtonEuler)),
            ),
        },
        CompiledSystem {
            name: "printed:kane-final",
            double: &code::printed_kane_final::PrintedKaneFinal,
            extended: &code::printed_kane_final::PrintedKaneFinal,
            lanes: None,
        },
        CompiledSystem {
            name: "printed:lagrange-final",
            double: &code::printed_lagrange_final::PrintedLagrangeFinal,
            extended: &code::printed_lagrange_final::PrintedLagrangeFinal,
            lanes: None,
        },
        CompiledSystem {
            name: "printed:newton-euler-final",
            double: &code::printed_newton_euler_final::PrintedNewtonEulerFinal,
            extended: &code::printed_newton_euler_final::PrintedNewtonEulerFinal,
            lanes: None,
        },
        CompiledSystem {
            name: "printed:listing-5.4",
            double: &code::printed_listing_5_4::PrintedListing54,
            extended: &code::printed_listing_5_4::PrintedListing54,
            lanes: None,
        },
        CompiledSystem {
            name: "printed:listing-5.5",
            double: &code::printed_listing_5_5::PrintedListing55,
            extended: &code::printed_listing_5_5::PrintedListing55,
            lanes: None,
        },
        CompiledSystem {
            name: "printed:listing-5.6",
            double: &code::printed_listing_5_6::PrintedListing56,
            extended: &code::printed_listing_5_6::PrintedListing56,
            lanes: None,
        },
        CompiledSystem {
            name: "kane@q2-90deg",
            double: &code::kane_q2_90deg::KaneQ290deg,
            extended: &code::kane_q2_90deg::KaneQ290deg,
            lanes: Some(
                InLanes::of(&Derivative(code::kane_q2_90deg::KaneQ290deg))
                    .with_series(&Derivative(code::kane_q2_90deg::KaneQ290deg)),
            ),
        },
        CompiledSystem {
            name: "lagrange@q2-90deg",
            double: &code::lagrange_q2_90deg::LagrangeQ290deg,
            extended: &code::lagrange_q2_90deg::LagrangeQ290deg,
            lanes: Some(
                InLanes::of(&Derivative(code::lagrange_q2_90deg::LagrangeQ290deg))
                    .with_series(&Derivative(code::lagrange_q2_90deg::LagrangeQ290deg)),
            ),
        },
        CompiledSystem {
            name: "newton-euler@q2-90deg",
            double: &code::newton_euler_q2_90deg::NewtonEulerQ290deg,
            extended: &code::newton_euler_q2_90deg::NewtonEulerQ290deg,
            lanes: Some(
                InLanes::of(&Derivative(code::newton_euler_q2_90deg::NewtonEulerQ290deg))
                    .with_series(
                        &Derivative(code::newton_euler_q2_90deg::NewtonEulerQ290deg),
                    ),
            ),
        },
    ],
    scenes: scenes::SCENES,
};
