// Chaotic pendulum: a swinging rod with a plate turning about it.
//
// Generated from `models/chaotic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
// 2 configuration variables, 0 holonomic constraints, 2 generalized coordinates, 0 nonholonomic constraints, 2 generalized speeds.

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
    /// mass of the rod, kg
    pub mA: S,
    /// mass of the plate, kg
    pub mB: S,
    /// pin to the centre of the rod, m
    pub lA: S,
    /// pin to the centre of the plate, m
    pub lB: S,
    /// rod, across its axis, kg*m^2
    pub IAxx: S,
    /// plate, about its first axis, kg*m^2
    pub IBxx: S,
    /// plate, about its second axis, kg*m^2
    pub IByy: S,
    /// plate, about the rod, kg*m^2
    pub IBzz: S,
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
            mA: p[0], mB: p[1], lA: p[2], lB: p[3], IAxx: p[4], IBxx: p[5], IByy: p[6], IBzz: p[7],
            g: p[8],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 9] {
        let Self { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, g, .. } = self;
        [mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, g]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            mA: S::ratio(4, 5),
            mB: S::ratio(3, 2),
            lA: S::ratio(2, 5),
            lB: S::ratio(9, 10),
            IAxx: S::ratio(11, 1000),
            IBxx: S::ratio(1, 50),
            IByy: S::ratio(1, 20),
            IBzz: S::ratio(13, 200),
            g: S::ratio(981, 100),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 9] = [
    "mA", "mB", "lA", "lB", "IAxx", "IBxx", "IByy", "IBzz", "g",
];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 2] = ["theta", "phi"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 2] = ["omega", "alpha"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "chaotic_pendulum",
    text_hash: "a123c9848e86dc99",
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
