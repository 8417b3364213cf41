// Chain of three rods floating in a plane.
//
// Generated from `models/floating_chain/model.toml`. Do not edit; run `tripos regenerate`.
// 5 configuration variables, 0 holonomic constraints, 5 generalized coordinates, 0 nonholonomic constraints, 5 generalized speeds.

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
    /// mass of each rod, kg
    pub m: S,
    /// length of each rod, m
    pub l: S,
}

impl<S: Scalar> Parameters<S> {
    /// From values in the order of [`PARAMETERS`].
    ///
    /// # Panics
    /// If `p` has fewer values than there are parameters.
    #[must_use]
    #[inline(always)]
    pub fn from_slice(p: &[S]) -> Self {
        Self { m: p[0], l: p[1] }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 2] {
        let Self { m, l, .. } = self;
        [m, l]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            m: S::ratio(7, 10),
            l: S::ratio(2, 5),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 2] = ["m", "l"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 5] = ["x", "y", "theta1", "theta2", "theta3"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 5] = ["u1", "u2", "u3", "u4", "u5"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "floating_chain",
    text_hash: "c7f43e1c3f694e99",
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
    ],
    scenes: scenes::SCENES,
};
