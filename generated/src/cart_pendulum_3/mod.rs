// Three-link pendulum on a cart.
//
// Generated from `models/cart_pendulum_3/model.toml`. Do not edit; run `tripos regenerate`.
// 4 configuration variables, 0 holonomic constraints, 4 generalized coordinates, 0 nonholonomic constraints, 4 generalized speeds.

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
    pub m0: S,
    /// mass at the end of link 1, kg
    pub m1: S,
    /// mass at the end of link 2, kg
    pub m2: S,
    /// mass at the end of link 3, kg
    pub m3: S,
    /// length of link 1, m
    pub l0: S,
    /// length of link 2, m
    pub l1: S,
    /// length of link 3, m
    pub l2: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// force on the cart, kg*m/s^2
    pub F: S,
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
            m0: p[0], m1: p[1], m2: p[2], m3: p[3], l0: p[4], l1: p[5], l2: p[6], g: p[7], F: p[8],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 9] {
        let Self { m0, m1, m2, m3, l0, l1, l2, g, F, .. } = self;
        [m0, m1, m2, m3, l0, l1, l2, g, F]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            m0: S::ratio(87, 100),
            m1: S::ratio(137, 100),
            m2: S::ratio(49, 25),
            m3: S::ratio(149, 100),
            l0: S::ratio(16, 25),
            l1: S::ratio(13, 25),
            l2: S::ratio(2, 5),
            g: S::ratio(981, 100),
            F: S::ratio(11, 4),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 9] = ["m0", "m1", "m2", "m3", "l0", "l1", "l2", "g", "F"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 4] = ["q0", "q1", "q2", "q3"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 4] = ["u0", "u1", "u2", "u3"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "cart_pendulum_3",
    text_hash: "8318ef39a623b989",
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
