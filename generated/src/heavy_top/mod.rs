// Symmetric heavy top about a fixed point.
//
// Generated from `models/heavy_top/model.toml`. Do not edit; run `tripos regenerate`.
// 3 configuration variables, 0 holonomic constraints, 3 generalized coordinates, 0 nonholonomic constraints, 3 generalized speeds.

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
    /// mass, kg
    pub m: S,
    /// fixed point to the mass centre, m
    pub l: S,
    /// across the axis, about the fixed point, kg*m^2
    pub I1: S,
    /// about the axis, kg*m^2
    pub I3: S,
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
            m: p[0], l: p[1], I1: p[2], I3: p[3], g: p[4],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 5] {
        let Self { m, l, I1, I3, g, .. } = self;
        [m, l, I1, I3, g]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            m: S::ratio(13, 10),
            l: S::ratio(11, 50),
            I1: S::ratio(19, 200),
            I3: S::ratio(21, 1000),
            g: S::ratio(981, 100),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 5] = ["m", "l", "I1", "I3", "g"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 3] = ["q1", "q2", "q3"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 3] = ["u1", "u2", "u3"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "heavy_top",
    text_hash: "4b32ee19611a4f4a",
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
        CompiledSystem {
            name: "kane@q2-90deg",
            double: &code::kane_q2_90deg::KaneQ290deg,
            extended: &code::kane_q2_90deg::KaneQ290deg,
            lanes: Some(InLanes::of(&Derivative(code::kane_q2_90deg::KaneQ290deg))),
        },
        CompiledSystem {
            name: "lagrange@q2-90deg",
            double: &code::lagrange_q2_90deg::LagrangeQ290deg,
            extended: &code::lagrange_q2_90deg::LagrangeQ290deg,
            lanes: Some(
                InLanes::of(&Derivative(code::lagrange_q2_90deg::LagrangeQ290deg)),
            ),
        },
        CompiledSystem {
            name: "newton-euler@q2-90deg",
            double: &code::newton_euler_q2_90deg::NewtonEulerQ290deg,
            extended: &code::newton_euler_q2_90deg::NewtonEulerQ290deg,
            lanes: Some(
                InLanes::of(&Derivative(code::newton_euler_q2_90deg::NewtonEulerQ290deg)),
            ),
        },
    ],
    scenes: scenes::SCENES,
};
