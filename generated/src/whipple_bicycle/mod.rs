// Whipple bicycle.
//
// Generated from `models/whipple_bicycle/model.toml`. Do not edit; run `tripos regenerate`.
// 8 configuration variables, 1 holonomic constraint, 8 generalized coordinates, 4 nonholonomic constraints, 3 generalized speeds.

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
    /// wheel base, m
    pub w: S,
    /// trail, m
    pub c: S,
    /// tilt of the steer axis, 1
    pub lam: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// radius of the rear wheel, m
    pub rR: S,
    /// parameter, kg
    pub mR: S,
    /// parameter, kg*m^2
    pub IRxx: S,
    /// parameter, kg*m^2
    pub IRyy: S,
    /// mass centre of frame and rider, forward of the rear contact, m
    pub xB: S,
    /// the same, down, m
    pub zB: S,
    /// parameter, kg
    pub mB: S,
    /// parameter, kg*m^2
    pub IBxx: S,
    /// parameter, kg*m^2
    pub IBxz: S,
    /// parameter, kg*m^2
    pub IByy: S,
    /// parameter, kg*m^2
    pub IBzz: S,
    /// mass centre of handlebar and fork, forward of the rear contact, m
    pub xH: S,
    /// the same, down, m
    pub zH: S,
    /// parameter, kg
    pub mH: S,
    /// parameter, kg*m^2
    pub IHxx: S,
    /// parameter, kg*m^2
    pub IHxz: S,
    /// parameter, kg*m^2
    pub IHyy: S,
    /// parameter, kg*m^2
    pub IHzz: S,
    /// radius of the front wheel, m
    pub rF: S,
    /// parameter, kg
    pub mF: S,
    /// parameter, kg*m^2
    pub IFxx: S,
    /// parameter, kg*m^2
    pub IFyy: S,
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
            w: p[0], c: p[1], lam: p[2], g: p[3], rR: p[4], mR: p[5], IRxx: p[6], IRyy: p[7],
            xB: p[8], zB: p[9], mB: p[10], IBxx: p[11], IBxz: p[12], IByy: p[13], IBzz: p[14],
            xH: p[15], zH: p[16], mH: p[17], IHxx: p[18], IHxz: p[19], IHyy: p[20], IHzz: p[21],
            rF: p[22], mF: p[23], IFxx: p[24], IFyy: p[25],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 26] {
        let Self {
            w, c, lam, g, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBxz, IByy, IBzz, xH, zH, mH, IHxx,
            IHxz, IHyy, IHzz, rF, mF, IFxx, IFyy,
            ..
        } = self;
        [
            w, c, lam, g, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBxz, IByy, IBzz, xH, zH, mH, IHxx,
            IHxz, IHyy, IHzz, rF, mF, IFxx, IFyy,
        ]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            w: S::ratio(51, 50),
            c: S::ratio(2, 25),
            lam: S::ratio(176855943800711, 562949953421312),
            g: S::ratio(981, 100),
            rR: S::ratio(3, 10),
            mR: S::int(2),
            IRxx: S::ratio(603, 10000),
            IRyy: S::ratio(3, 25),
            xB: S::ratio(3, 10),
            zB: -S::ratio(9, 10),
            mB: S::int(85),
            IBxx: S::ratio(46, 5),
            IBxz: S::ratio(12, 5),
            IByy: S::int(11),
            IBzz: S::ratio(14, 5),
            xH: S::ratio(9, 10),
            zH: -S::ratio(7, 10),
            mH: S::int(4),
            IHxx: S::ratio(1473, 25000),
            IHxz: -S::ratio(189, 25000),
            IHyy: S::ratio(3, 50),
            IHzz: S::ratio(177, 25000),
            rF: S::ratio(7, 20),
            mF: S::int(3),
            IFxx: S::ratio(281, 2000),
            IFyy: S::ratio(7, 25),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 26] = [
    "w", "c", "lam", "g", "rR", "mR", "IRxx", "IRyy", "xB", "zB", "mB", "IBxx", "IBxz", "IByy",
    "IBzz", "xH", "zH", "mH", "IHxx", "IHxz", "IHyy", "IHzz", "rF", "mF", "IFxx", "IFyy",
];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 8] = [
    "x", "y", "psi", "phi", "theta", "delta", "thR", "thF",
];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 3] = ["u1", "u2", "u3"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "whipple_bicycle",
    text_hash: "7b24976634e5e6b0",
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
