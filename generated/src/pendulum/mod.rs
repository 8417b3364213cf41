// Pendulum.
//
// Generated from `models/pendulum/model.toml`. Do not edit; run `tripos regenerate`.
// 1 configuration variable, 0 holonomic constraints, 1 generalized coordinate, 0 nonholonomic constraints, 1 generalized speed.

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
    /// mass of the bob, kg
    pub m: S,
    /// length of the massless rod, m
    pub l: S,
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
        Self { m: p[0], l: p[1], g: p[2] }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 3] {
        let Self { m, l, g, .. } = self;
        [m, l, g]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            m: S::int(1),
            l: S::int(1),
            g: S::ratio(981, 100),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 3] = ["m", "l", "g"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 1] = ["theta"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 1] = ["omega"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "pendulum",
    text_hash: "8127e7b4c37d945f",
    publication_hash: "",
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
    ],
    scenes: scenes::SCENES,
};
