// Satellite with a reaction wheel.
//
// Generated from `models/satellite/model.toml`. Do not edit; run `tripos regenerate`.
// 5 configuration variables, 1 holonomic constraint, 5 generalized coordinates, 0 nonholonomic constraints, 4 generalized speeds.

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
    /// moment of the bus about its axis 1, kg*m^2
    pub A: S,
    /// moment of the bus about its axis 2, kg*m^2
    pub B: S,
    /// moment of the bus about its axis 3, kg*m^2
    pub C: S,
    /// moment of the wheel about its axle, kg*m^2
    pub J: S,
    /// moment of the wheel across its axle, kg*m^2
    pub K: S,
    /// mass of the bus, kg
    pub M: S,
    /// mass of the wheel, kg
    pub m: S,
    /// torque of the motor on the wheel, kg*m^2/s^2
    pub T: S,
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
            A: p[0], B: p[1], C: p[2], J: p[3], K: p[4], M: p[5], m: p[6], T: p[7],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 8] {
        let Self { A, B, C, J, K, M, m, T, .. } = self;
        [A, B, C, J, K, M, m, T]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            A: S::int(10),
            B: S::int(15),
            C: S::int(20),
            J: S::ratio(1, 2),
            K: S::ratio(3, 10),
            M: S::int(100),
            m: S::int(5),
            T: S::ratio(1, 5),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 8] = ["A", "B", "C", "J", "K", "M", "m", "T"];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 5] = ["e0", "e1", "e2", "e3", "phi"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 4] = ["w1", "w2", "w3", "s"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "satellite",
    text_hash: "30b1eeeec88e2dcd",
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
