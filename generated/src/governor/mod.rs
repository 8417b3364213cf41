// Flyball governor.
//
// Generated from `models/governor/model.toml`. Do not edit; run `tripos regenerate`.
// 6 configuration variables, 4 holonomic constraints, 5 generalized coordinates, 0 nonholonomic constraints, 2 generalized speeds.

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
    /// length of a rod, m
    pub l: S,
    /// mass of a rod, kg
    pub m: S,
    /// mass of a ball, kg
    pub mb: S,
    /// mass of the sleeve, kg
    pub ms: S,
    /// moment of inertia of the spindle, kg*m^2
    pub J: S,
    /// moment of inertia of the sleeve, kg*m^2
    pub Js: S,
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
        Self {
            l: p[0], m: p[1], mb: p[2], ms: p[3], J: p[4], Js: p[5], g: p[6],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 7] {
        let Self { l, m, mb, ms, J, Js, g, .. } = self;
        [l, m, mb, ms, J, Js, g]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            l: S::ratio(1, 5),
            m: S::ratio(1, 10),
            mb: S::ratio(1, 2),
            ms: S::int(1),
            J: S::ratio(1, 250),
            Js: S::ratio(1, 2000),
            g: S::ratio(981, 100),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 7] = ["l", "m", "mb", "ms", "J", "Js", "g"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 5] = [
    "psi", "theta", "q_right_top", "q_left_ball", "q_right_ball",
];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 2] = ["spin", "opening"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "governor",
    text_hash: "e4989b488b79bf5b",
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
            lanes: Some(InLanes::of_four(&Derivative(code::lagrange::Lagrange))),
        },
        CompiledSystem {
            name: "newton-euler",
            double: &code::newton_euler::NewtonEuler,
            extended: &code::newton_euler::NewtonEuler,
            lanes: Some(InLanes::of(&Derivative(code::newton_euler::NewtonEuler))),
        },
    ],
    scenes: &[],
};
