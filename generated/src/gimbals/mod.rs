// Gyroscope in gimbals.
//
// Generated from `models/gimbals/model.toml`. Do not edit; run `tripos regenerate`.
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
    /// outer ring, about its axis, kg*m^2
    pub Iz: S,
    /// inner ring, about the axis that it turns about in the outer, kg*m^2
    pub Ax: S,
    /// inner ring, across, kg*m^2
    pub Ay: S,
    /// inner ring, about the axis of the rotor, kg*m^2
    pub Az: S,
    /// rotor, across its axis, kg*m^2
    pub B: S,
    /// rotor, about its axis, kg*m^2
    pub C: S,
    /// mass of the outer ring, kg
    pub mo: S,
    /// mass of the inner ring, kg
    pub mi: S,
    /// mass of the rotor, kg
    pub m: S,
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
            Iz: p[0], Ax: p[1], Ay: p[2], Az: p[3], B: p[4], C: p[5], mo: p[6], mi: p[7], m: p[8],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 9] {
        let Self { Iz, Ax, Ay, Az, B, C, mo, mi, m, .. } = self;
        [Iz, Ax, Ay, Az, B, C, mo, mi, m]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            Iz: S::ratio(11, 1000),
            Ax: S::ratio(1, 250),
            Ay: S::ratio(1, 200),
            Az: S::ratio(3, 500),
            B: S::ratio(3, 1000),
            C: S::ratio(1, 200),
            mo: S::int(1),
            mi: S::int(1),
            m: S::int(2),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 9] = ["Iz", "Ax", "Ay", "Az", "B", "C", "mo", "mi", "m"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 3] = ["psi", "theta", "phi"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 3] = ["u_psi", "u_theta", "u_phi"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "gimbals",
    text_hash: "47e3fccdf5715133",
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
