// Slider-crank.
//
// Generated from `models/slider_crank/model.toml`. Do not edit; run `tripos regenerate`.
// 3 configuration variables, 2 holonomic constraints, 2 generalized coordinates, 0 nonholonomic constraints, 1 generalized speed.

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
    pub r: S,
    /// length of the connecting rod, m
    pub l: S,
    /// from the crank pin to the mass centre of the rod, m
    pub b: S,
    /// moment of inertia of crank and flywheel, about the shaft, kg*m^2
    pub I: S,
    /// mass of the rod, kg
    pub mr: S,
    /// moment of inertia of the rod, about its mass centre, kg*m^2
    pub Ir: S,
    /// mass of the piston, kg
    pub mp: S,
    /// mass of crank and flywheel, balanced about the shaft, kg
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
            r: p[0], l: p[1], b: p[2], I: p[3], mr: p[4], Ir: p[5], mp: p[6], mc: p[7], g: p[8],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 9] {
        let Self { r, l, b, I, mr, Ir, mp, mc, g, .. } = self;
        [r, l, b, I, mr, Ir, mp, mc, g]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            r: S::ratio(1, 20),
            l: S::ratio(4, 25),
            b: S::ratio(1, 20),
            I: S::ratio(3, 250),
            mr: S::ratio(3, 5),
            Ir: S::ratio(11, 5000),
            mp: S::ratio(9, 20),
            mc: S::int(2),
            g: S::ratio(981, 100),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 9] = ["r", "l", "b", "I", "mr", "Ir", "mp", "mc", "g"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 2] = ["q", "p"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 1] = ["u"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "slider_crank",
    text_hash: "ccf9462455ed13a7",
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
