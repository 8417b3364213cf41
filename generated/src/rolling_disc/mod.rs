// Thin disc rolling on a plane.
//
// Generated from `models/rolling_disc/model.toml`. Do not edit; run `tripos regenerate`.
// 5 configuration variables, 0 holonomic constraints, 5 generalized coordinates, 2 nonholonomic constraints, 3 generalized speeds.

/// Kane's method.
#[rustfmt::skip]
pub mod kane;

/// Lagrange's equations.
#[rustfmt::skip]
pub mod lagrange;

/// Newton–Euler equations.
#[rustfmt::skip]
pub mod newton_euler;

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
    /// radius, m
    pub r: S,
    /// mass, kg
    pub m: S,
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
        Self { r: p[0], m: p[1], g: p[2] }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 3] {
        let Self { r, m, g, .. } = self;
        [r, m, g]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            r: S::ratio(31, 100),
            m: S::ratio(12, 5),
            g: S::ratio(981, 100),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 3] = ["r", "m", "g"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 5] = ["q1", "q2", "q3", "x", "y"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 3] = ["u1", "u2", "u3"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "rolling_disc",
    text_hash: "cc0ae70f1c900fe9",
    publication_hash: "",
    systems: &[
        CompiledSystem {
            name: "kane",
            double: &code::kane::Kane,
            extended: &code::kane::Kane,
            lanes: Some(InLanes::of(&Derivative(code::kane::Kane))),
        },
        CompiledSystem {
            name: "lagrange",
            double: &code::lagrange::Lagrange,
            extended: &code::lagrange::Lagrange,
            lanes: Some(InLanes::of(&Derivative(code::lagrange::Lagrange))),
        },
        CompiledSystem {
            name: "newton-euler",
            double: &code::newton_euler::NewtonEuler,
            extended: &code::newton_euler::NewtonEuler,
            lanes: Some(InLanes::of(&Derivative(code::newton_euler::NewtonEuler))),
        },
        CompiledSystem {
            name: "kane@q2-90deg",
            double: &code::kane_q2_90deg::KaneQ290deg,
            extended: &code::kane_q2_90deg::KaneQ290deg,
            lanes: Some(InLanes::of(&Derivative(code::kane_q2_90deg::KaneQ290deg))),
        },
        CompiledSystem {
            name: "lagrange@q2-90deg",
            double: &code::lagrange_q2_90deg::LagrangeQ290deg,
            extended: &code::lagrange_q2_90deg::LagrangeQ290deg,
            lanes: Some(
                InLanes::of(&Derivative(code::lagrange_q2_90deg::LagrangeQ290deg)),
            ),
        },
        CompiledSystem {
            name: "newton-euler@q2-90deg",
            double: &code::newton_euler_q2_90deg::NewtonEulerQ290deg,
            extended: &code::newton_euler_q2_90deg::NewtonEulerQ290deg,
            lanes: Some(
                InLanes::of(&Derivative(code::newton_euler_q2_90deg::NewtonEulerQ290deg)),
            ),
        },
    ],
    scenes: scenes::SCENES,
};
