// Furuta pendulum.
//
// Generated from `models/furuta/model.toml`. Do not edit; run `tripos regenerate`.
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
    /// length of the arm, m
    pub L1: S,
    /// from the shaft to the mass centre of the arm, m
    pub l1: S,
    /// mass of the arm, kg
    pub m1: S,
    /// moment of inertia of the arm, across it, kg*m^2
    pub J1: S,
    /// from the joint to the mass centre of the pendulum, m
    pub l2: S,
    /// mass of the pendulum, kg
    pub m2: S,
    /// moment of inertia of the pendulum, across it, kg*m^2
    pub J2: S,
    /// damping of the motor, kg*m^2/s
    pub b1: S,
    /// damping of the joint, kg*m^2/s
    pub b2: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// torque of the motor, kg*m^2/s^2
    pub tau: S,
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
            L1: p[0], l1: p[1], m1: p[2], J1: p[3], l2: p[4], m2: p[5], J2: p[6], b1: p[7],
            b2: p[8], g: p[9], tau: p[10],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 11] {
        let Self { L1, l1, m1, J1, l2, m2, J2, b1, b2, g, tau, .. } = self;
        [L1, l1, m1, J1, l2, m2, J2, b1, b2, g, tau]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            L1: S::ratio(139, 500),
            l1: S::ratio(3, 20),
            m1: S::ratio(3, 10),
            J1: S::ratio(31, 1250),
            l2: S::ratio(37, 250),
            m2: S::ratio(3, 40),
            J2: S::ratio(193, 50000),
            b1: S::ratio(1, 10000),
            b2: S::ratio(7, 25000),
            g: S::ratio(981, 100),
            tau: S::int(0),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 11] = [
    "L1", "l1", "m1", "J1", "l2", "m2", "J2", "b1", "b2", "g", "tau",
];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 2] = ["theta1", "theta2"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 2] = ["u_theta1", "u_theta2"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "furuta",
    text_hash: "cf8c7be45dc33932",
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
