// Pendulum on a driven pivot.
//
// Generated from `models/driven_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
// 1 configuration variable, 0 holonomic constraints, 1 generalized coordinate, 0 nonholonomic constraints, 1 generalized speed, time.

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
    /// length of the rod, which has no mass, m
    pub l: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// amplitude of the pivot, m
    pub a: S,
    /// frequency of the pivot, 1/s
    pub w: S,
}

impl<S: Scalar> Parameters<S> {
    /// From values in the order of [`PARAMETERS`].
    ///
    /// # Panics
    /// If `p` has fewer values than there are parameters.
    #[must_use]
    #[inline(always)]
    pub fn from_slice(p: &[S]) -> Self {
        Self {
            m: p[0], l: p[1], g: p[2], a: p[3], w: p[4],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 5] {
        let Self { m, l, g, a, w, .. } = self;
        [m, l, g, a, w]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            m: S::ratio(1, 5),
            l: S::ratio(1, 2),
            g: S::ratio(981, 100),
            a: S::ratio(1, 50),
            w: S::int(200),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 5] = ["m", "l", "g", "a", "w"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 2] = ["q", "t"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 1] = ["u"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "driven_pendulum",
    text_hash: "33ce9db23dc61269",
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
