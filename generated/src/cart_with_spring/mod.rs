// Cart with spring.
//
// Generated from `models/cart_with_spring/model.toml`. Do not edit; run `tripos regenerate`.
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
    /// mass of the cart, kg
    pub m: S,
    /// stiffness of the spring, kg/s^2
    pub k: S,
    /// length of the spring without load, m
    pub l: S,
    /// damping, kg/s
    pub c: S,
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
            m: p[0], k: p[1], l: p[2], c: p[3],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 4] {
        let Self { m, k, l, c, .. } = self;
        [m, k, l, c]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            m: S::ratio(3, 2),
            k: S::int(60),
            l: S::ratio(3, 10),
            c: S::ratio(6, 5),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 4] = ["m", "k", "l", "c"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 1] = ["x"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 1] = ["v"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "cart_with_spring",
    text_hash: "2e5258b97ad4f79d",
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
