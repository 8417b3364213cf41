//! Symmetric heavy top about a fixed point.
//!
//! Generated from `models/heavy_top/model.toml`. Do not edit; run `tripos regenerate`.
//! 3 configuration variables, 0 holonomic constraints, 3 generalized coordinates, 0 nonholonomic constraints, 3 generalized speeds.

#[rustfmt::skip]
pub mod kane;
#[rustfmt::skip]
pub mod kane_q2_90deg;
#[rustfmt::skip]
pub mod lagrange;
#[rustfmt::skip]
pub mod lagrange_q2_90deg;
#[rustfmt::skip]
pub mod newton_euler;
#[rustfmt::skip]
pub mod newton_euler_q2_90deg;
#[rustfmt::skip]
pub mod scenes;
use tripos_traits::{CompiledModel, CompiledSystem, Derivative, InLanes, Scalar};

/// The parameters, in the order of the model file.
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
            m: p[0],
            l: p[1],
            I1: p[2],
            I3: p[3],
            g: p[4],
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
    report_hash: "",
    systems: &[
        CompiledSystem {
            name: "kane",
            double: &kane::Kane,
            extended: &kane::Kane,
            lanes: Some(InLanes::of(&Derivative(kane::Kane))),
        },
        CompiledSystem {
            name: "kane@q2-90deg",
            double: &kane_q2_90deg::KaneQ290deg,
            extended: &kane_q2_90deg::KaneQ290deg,
            lanes: Some(InLanes::of(&Derivative(kane_q2_90deg::KaneQ290deg))),
        },
        CompiledSystem {
            name: "lagrange",
            double: &lagrange::Lagrange,
            extended: &lagrange::Lagrange,
            lanes: Some(InLanes::of(&Derivative(lagrange::Lagrange))),
        },
        CompiledSystem {
            name: "lagrange@q2-90deg",
            double: &lagrange_q2_90deg::LagrangeQ290deg,
            extended: &lagrange_q2_90deg::LagrangeQ290deg,
            lanes: Some(InLanes::of(&Derivative(lagrange_q2_90deg::LagrangeQ290deg))),
        },
        CompiledSystem {
            name: "newton-euler",
            double: &newton_euler::NewtonEuler,
            extended: &newton_euler::NewtonEuler,
            lanes: Some(InLanes::of(&Derivative(newton_euler::NewtonEuler))),
        },
        CompiledSystem {
            name: "newton-euler@q2-90deg",
            double: &newton_euler_q2_90deg::NewtonEulerQ290deg,
            extended: &newton_euler_q2_90deg::NewtonEulerQ290deg,
            lanes: Some(
                InLanes::of(&Derivative(newton_euler_q2_90deg::NewtonEulerQ290deg)),
            ),
        },
    ],
    scenes: scenes::SCENES,
};
