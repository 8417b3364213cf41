// Bricard's mechanism.
//
// Generated from `models/bricard/model.toml`. Do not edit; run `tripos regenerate`.
// 5 configuration variables, 5 holonomic constraints, 5 generalized coordinates, 0 nonholonomic constraints, 1 generalized speed.

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

use tripos_traits::{CompiledModel, CompiledSystem, Derivative, InLanes, Scalar};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// parameter, m
    pub l: S,
    /// parameter, kg
    pub m: S,
    /// parameter, m/s^2
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
        Self { l: p[0], m: p[1], g: p[2] }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 3] {
        let Self { l, m, g, .. } = self;
        [l, m, g]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            l: S::int(1),
            m: S::int(1),
            g: S::ratio(981, 100),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 3] = ["l", "m", "g"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 5] = ["q_P1", "q_P2", "q_P3", "q_P4", "q_P5"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 1] = ["u_P1"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "bricard",
    text_hash: "9ce81715f399a7f6",
    publication_hash: "",
    systems: &[
        CompiledSystem {
            name: "kane",
            double: &code::kane::Kane,
            extended: &code::kane::Kane,
            lanes: Some(InLanes::of_four(&Derivative(code::kane::Kane))),
        },
        CompiledSystem {
            name: "lagrange",
            double: &code::lagrange::Lagrange,
            extended: &code::lagrange::Lagrange,
            lanes: Some(InLanes::of_four(&Derivative(code::lagrange::Lagrange))),
        },
        CompiledSystem {
            name: "newton-euler",
            double: &code::newton_euler::NewtonEuler,
            extended: &code::newton_euler::NewtonEuler,
            lanes: Some(InLanes::of_four(&Derivative(code::newton_euler::NewtonEuler))),
        },
    ],
    scenes: &[],
};
