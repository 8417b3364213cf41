// Four-bar linkage.
//
// Generated from `models/four_bar/model.toml`. Do not edit; run `tripos regenerate`.
// 3 configuration variables, 2 holonomic constraints, 3 generalized coordinates, 0 nonholonomic constraints, 1 generalized speed.

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
    /// length of the crank, m
    pub a: S,
    /// length of the coupler, m
    pub b: S,
    /// length of the rocker, m
    pub c: S,
    /// distance of the fixed pins, m
    pub d: S,
    /// mass of the crank, kg
    pub ma: S,
    /// mass of the coupler, kg
    pub mb: S,
    /// mass of the rocker, kg
    pub mc: S,
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
            a: p[0], b: p[1], c: p[2], d: p[3], ma: p[4], mb: p[5], mc: p[6], g: p[7],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 8] {
        let Self { a, b, c, d, ma, mb, mc, g, .. } = self;
        [a, b, c, d, ma, mb, mc, g]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            a: S::ratio(3, 10),
            b: S::ratio(4, 5),
            c: S::ratio(3, 5),
            d: S::ratio(7, 10),
            ma: S::int(1),
            mb: S::int(2),
            mc: S::ratio(3, 2),
            g: S::ratio(981, 100),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 8] = ["a", "b", "c", "d", "ma", "mb", "mc", "g"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 3] = ["q1", "q2", "q3"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 1] = ["u1"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "four_bar",
    text_hash: "a1b3ae14c43f1392",
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
    scenes: &[],
};
