// PUMA 560.
//
// Generated from `models/puma560/model.toml`. Do not edit; run `tripos regenerate`.
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

use tripos_traits::{CompiledModel, CompiledSystem, Derivative, InLanes, Scalar};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// length of the upper arm, m
    pub a2: S,
    /// offset of the elbow, m
    pub a3: S,
    /// offset of the upper arm from the column, along its joint, m
    pub d3: S,
    /// length of the forearm, up to the wrist, m
    pub d4: S,
    /// mass of the column, which plays no part, kg
    pub m1: S,
    /// mass of the upper arm, kg
    pub m2: S,
    /// mass of the forearm, kg
    pub m3: S,
    /// parameter, kg
    pub m4: S,
    /// parameter, kg
    pub m5: S,
    /// parameter, kg
    pub m6: S,
    /// mass centre of the upper arm, in its axes, from the elbow, m
    pub x2: S,
    /// parameter, m
    pub y2: S,
    /// parameter, m
    pub z2: S,
    /// mass centre of the forearm, in its axes, from the end of the elbow's offset, m
    pub x3: S,
    /// parameter, m
    pub y3: S,
    /// parameter, m
    pub z3: S,
    /// mass centre of the first link of the wrist, from the wrist, m
    pub y4: S,
    /// mass centre of the flange, from the wrist, m
    pub z6: S,
    /// moment of the column about its joint, kg*m^2
    pub I1: S,
    /// moments of the upper arm about its mass centre, kg*m^2
    pub Ixx2: S,
    /// parameter, kg*m^2
    pub Iyy2: S,
    /// parameter, kg*m^2
    pub Izz2: S,
    /// parameter, kg*m^2
    pub Ixx3: S,
    /// printed as 0.086, which is more than the other two together: no body has that, kg*m^2
    pub Iyy3: S,
    /// parameter, kg*m^2
    pub Izz3: S,
    /// parameter, kg*m^2
    pub Ixx4: S,
    /// parameter, kg*m^2
    pub Iyy4: S,
    /// parameter, kg*m^2
    pub Ixx5: S,
    /// parameter, kg*m^2
    pub Iyy5: S,
    /// parameter, kg*m^2
    pub Ixx6: S,
    /// parameter, kg*m^2
    pub Izz6: S,
    /// torque of joint 1, kg*m^2/s^2
    pub tau1: S,
    /// torque of joint 2, kg*m^2/s^2
    pub tau2: S,
    /// torque of joint 3, kg*m^2/s^2
    pub tau3: S,
    /// torque of joint 4, kg*m^2/s^2
    pub tau4: S,
    /// torque of joint 5, kg*m^2/s^2
    pub tau5: S,
    /// torque of joint 6, kg*m^2/s^2
    pub tau6: S,
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
            g: p[0], a2: p[1], a3: p[2], d3: p[3], d4: p[4], m1: p[5], m2: p[6], m3: p[7], m4: p[8],
            m5: p[9], m6: p[10], x2: p[11], y2: p[12], z2: p[13], x3: p[14], y3: p[15], z3: p[16],
            y4: p[17], z6: p[18], I1: p[19], Ixx2: p[20], Iyy2: p[21], Izz2: p[22], Ixx3: p[23],
            Iyy3: p[24], Izz3: p[25], Ixx4: p[26], Iyy4: p[27], Ixx5: p[28], Iyy5: p[29],
            Ixx6: p[30], Izz6: p[31], tau1: p[32], tau2: p[33], tau3: p[34], tau4: p[35],
            tau5: p[36], tau6: p[37],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 38] {
        let Self {
            g, a2, a3, d3, d4, m1, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6, I1, Ixx2,
            Iyy2, Izz2, Ixx3, Iyy3, Izz3, Ixx4, Iyy4, Ixx5, Iyy5, Ixx6, Izz6, tau1, tau2, tau3,
            tau4, tau5, tau6,
            ..
        } = self;
        [
            g, a2, a3, d3, d4, m1, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6, I1, Ixx2,
            Iyy2, Izz2, Ixx3, Iyy3, Izz3, Ixx4, Iyy4, Ixx5, Iyy5, Ixx6, Izz6, tau1, tau2, tau3,
            tau4, tau5, tau6,
        ]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            g: S::ratio(981, 100),
            a2: S::ratio(2159, 5000),
            a3: S::ratio(203, 10000),
            d3: S::ratio(3001, 20000),
            d4: S::ratio(2159, 5000),
            m1: S::int(13),
            m2: S::ratio(87, 5),
            m3: S::ratio(24, 5),
            m4: S::ratio(41, 50),
            m5: S::ratio(17, 50),
            m6: S::ratio(9, 100),
            x2: -S::ratio(1819, 5000),
            y2: S::ratio(3, 500),
            z2: S::ratio(91, 400),
            x3: -S::ratio(203, 10000),
            y3: -S::ratio(141, 10000),
            z3: S::ratio(7, 100),
            y4: S::ratio(19, 1000),
            z6: S::ratio(4, 125),
            I1: S::ratio(7, 20),
            Ixx2: S::ratio(13, 100),
            Iyy2: S::ratio(131, 250),
            Izz2: S::ratio(539, 1000),
            Ixx3: S::ratio(33, 500),
            Iyy3: S::ratio(157, 2000),
            Izz3: S::ratio(1, 80),
            Ixx4: S::ratio(9, 5000),
            Iyy4: S::ratio(13, 10000),
            Ixx5: S::ratio(3, 10000),
            Iyy5: S::ratio(1, 2500),
            Ixx6: S::ratio(3, 20000),
            Izz6: S::ratio(1, 25000),
            tau1: S::int(0),
            tau2: S::int(0),
            tau3: S::int(0),
            tau4: S::int(0),
            tau5: S::int(0),
            tau6: S::int(0),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 38] = [
    "g", "a2", "a3", "d3", "d4", "m1", "m2", "m3", "m4", "m5", "m6", "x2", "y2", "z2", "x3", "y3",
    "z3", "y4", "z6", "I1", "Ixx2", "Iyy2", "Izz2", "Ixx3", "Iyy3", "Izz3", "Ixx4", "Iyy4", "Ixx5",
    "Iyy5", "Ixx6", "Izz6", "tau1", "tau2", "tau3", "tau4", "tau5", "tau6",
];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 6] = ["q1", "q2", "q3", "q4", "q5", "q6"];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 6] = ["u1", "u2", "u3", "u4", "u5", "u6"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "puma560",
    text_hash: "7022f95ea022d1ca",
    publication_hash: "",
    systems: &[
        CompiledSystem {
            name: "kane",
            double: &code::kane::Kane,
            extended: &code::kane::Kane,
            lanes: Some(InLanes::of_four(&Derivative(code::kane::Kane))),
        },
        CompiledSystem {
            name: "lagrange",
            double: &code::lagrange::Lagrange,
            extended: &code::lagrange::Lagrange,
            lanes: Some(InLanes::of_four(&Derivative(code::lagrange::Lagrange))),
        },
        CompiledSystem {
            name: "newton-euler",
            double: &code::newton_euler::NewtonEuler,
            extended: &code::newton_euler::NewtonEuler,
            lanes: Some(InLanes::of_four(&Derivative(code::newton_euler::NewtonEuler))),
        },
    ],
    scenes: &[],
};
