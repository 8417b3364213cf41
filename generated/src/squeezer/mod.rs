// Andrews' squeezing mechanism.
//
// Generated from `models/squeezer/model.toml`. Do not edit; run `tripos regenerate`.
// 7 configuration variables, 6 holonomic constraints, 7 generalized coordinates, 0 nonholonomic constraints, 1 generalized speed.

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
    /// parameter, kg
    pub m1: S,
    /// parameter, kg
    pub m2: S,
    /// parameter, kg
    pub m3: S,
    /// parameter, kg
    pub m4: S,
    /// parameter, kg
    pub m5: S,
    /// parameter, kg
    pub m6: S,
    /// parameter, kg
    pub m7: S,
    /// parameter, kg*m^2
    pub I1: S,
    /// parameter, kg*m^2
    pub I2: S,
    /// parameter, kg*m^2
    pub I3: S,
    /// parameter, kg*m^2
    pub I4: S,
    /// parameter, kg*m^2
    pub I5: S,
    /// parameter, kg*m^2
    pub I6: S,
    /// parameter, kg*m^2
    pub I7: S,
    /// parameter, m
    pub xa: S,
    /// parameter, m
    pub ya: S,
    /// parameter, m
    pub xb: S,
    /// parameter, m
    pub yb: S,
    /// parameter, m
    pub xc: S,
    /// parameter, m
    pub yc: S,
    /// stiffness of the spring, kg/s^2
    pub c0: S,
    /// length of the spring without load, m
    pub l0: S,
    /// parameter, m
    pub d: S,
    /// parameter, m
    pub da: S,
    /// parameter, m
    pub e: S,
    /// parameter, m
    pub ea: S,
    /// parameter, m
    pub rr: S,
    /// parameter, m
    pub ra: S,
    /// parameter, m
    pub ss: S,
    /// parameter, m
    pub sa: S,
    /// parameter, m
    pub sb: S,
    /// parameter, m
    pub sc: S,
    /// parameter, m
    pub sd: S,
    /// parameter, m
    pub ta: S,
    /// parameter, m
    pub tb: S,
    /// parameter, m
    pub zt: S,
    /// parameter, m
    pub u: S,
    /// parameter, m
    pub ua: S,
    /// parameter, m
    pub ub: S,
    /// parameter, m
    pub zf: S,
    /// parameter, m
    pub fa: S,
    /// drive, kg*m^2/s^2
    pub mom: S,
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
            m1: p[0], m2: p[1], m3: p[2], m4: p[3], m5: p[4], m6: p[5], m7: p[6], I1: p[7],
            I2: p[8], I3: p[9], I4: p[10], I5: p[11], I6: p[12], I7: p[13], xa: p[14], ya: p[15],
            xb: p[16], yb: p[17], xc: p[18], yc: p[19], c0: p[20], l0: p[21], d: p[22], da: p[23],
            e: p[24], ea: p[25], rr: p[26], ra: p[27], ss: p[28], sa: p[29], sb: p[30], sc: p[31],
            sd: p[32], ta: p[33], tb: p[34], zt: p[35], u: p[36], ua: p[37], ub: p[38], zf: p[39],
            fa: p[40], mom: p[41],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 42] {
        let Self {
            m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, xa, ya, xb, yb, xc, yc, c0, l0,
            d, da, e, ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, zt, u, ua, ub, zf, fa, mom,
            ..
        } = self;
        [
            m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, xa, ya, xb, yb, xc, yc, c0, l0,
            d, da, e, ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, zt, u, ua, ub, zf, fa, mom,
        ]
    }
}

/// The values that the model file states.
impl<S: Scalar> Default for Parameters<S> {
    fn default() -> Self {
        Self {
            m1: S::ratio(173, 4000),
            m2: S::ratio(73, 20000),
            m3: S::ratio(2373, 100000),
            m4: S::ratio(353, 50000),
            m5: S::ratio(141, 2000),
            m6: S::ratio(353, 50000),
            m7: S::ratio(2749, 50000),
            I1: S::ratio(1097, 500000000),
            I2: S::ratio(441, 1000000000),
            I3: S::ratio(1051, 200000000),
            I4: S::ratio(5667, 10000000000),
            I5: S::ratio(1169, 100000000),
            I6: S::ratio(5667, 10000000000),
            I7: S::ratio(239, 12500000),
            xa: -S::ratio(3467, 50000),
            ya: -S::ratio(227, 100000),
            xb: -S::ratio(727, 20000),
            yb: S::ratio(3273, 100000),
            xc: S::ratio(7, 500),
            yc: S::ratio(9, 125),
            c0: S::int(4530),
            l0: S::ratio(1557, 20000),
            d: S::ratio(7, 250),
            da: S::ratio(23, 2000),
            e: S::ratio(1, 50),
            ea: S::ratio(1421, 100000),
            rr: S::ratio(7, 1000),
            ra: S::ratio(23, 25000),
            ss: S::ratio(7, 200),
            sa: S::ratio(937, 50000),
            sb: S::ratio(1043, 100000),
            sc: S::ratio(9, 500),
            sd: S::ratio(1, 50),
            ta: S::ratio(577, 25000),
            tb: S::ratio(229, 25000),
            zt: S::ratio(1, 25),
            u: S::ratio(1, 25),
            ua: S::ratio(307, 25000),
            ub: S::ratio(449, 100000),
            zf: S::ratio(1, 50),
            fa: S::ratio(1421, 100000),
            mom: S::ratio(33, 1000),
        }
    }
}

/// Names of the parameters.
pub const PARAMETERS: [&str; 42] = [
    "m1", "m2", "m3", "m4", "m5", "m6", "m7", "I1", "I2", "I3", "I4", "I5", "I6", "I7", "xa", "ya",
    "xb", "yb", "xc", "yc", "c0", "l0", "d", "da", "e", "ea", "rr", "ra", "ss", "sa", "sb", "sc",
    "sd", "ta", "tb", "zt", "u", "ua", "ub", "zf", "fa", "mom",
];

/// Names of the generalized coordinates.
pub const COORDINATES: [&str; 7] = [
    "beta", "theta", "gamma", "delta", "phi", "epsilon", "omega",
];

/// Names of the generalized speeds.
pub const SPEEDS: [&str; 1] = ["beta_rate"];

/// What a program needs to find these equations and to trust them.
pub const MODEL: CompiledModel = CompiledModel {
    name: "squeezer",
    text_hash: "d99b8740a71d9b44",
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
