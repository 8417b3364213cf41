// Symmetric rigid body free of forces.
//
// Generated from `models/free_body/model.toml`. Do not edit; run `tripos regenerate`.
// 6 configuration variables, 0 holonomic constraints, 6 generalized coordinates, 0 nonholonomic constraints, 6 generalized speeds.

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
    /// across the axis, about the mass centre, kg*m^2
    pub I1: S,
    /// about the axis, kg*m^2
    pub I3: S,
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
            m: p[0], I1: p[1], I3: p[2],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 3] {
        let Self { m, I1, I3, .. } = self;
        [m, I1, I3]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            m: S::int(2),
            I1: S::ratio(3, 10),
            I3: S::ratio(1, 2),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 3] = ["m", "I1", "I3"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 6] = ["x", "y", "z", "psi", "theta", "phi"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 6] = ["v1", "v2", "v3", "w1", "w2", "w3"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "free_body",
    text_hash: "aaca89bd177914aa",
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
