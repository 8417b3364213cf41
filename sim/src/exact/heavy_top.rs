//! Exact motion of a symmetric heavy top about a fixed point, by elliptic functions.

use super::polar_angle::{PolarAngle, PolarStart};
use tripos_traits::Real;

/// Symmetric top with a fixed point on its axis, under gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Top<S> {
    /// Mass of the top, kg.
    pub mass: S,
    /// Distance from the fixed point to the mass centre along the axis, m; positive.
    pub arm: S,
    /// Acceleration of free fall, m/s²; positive.
    pub gravity: S,
    /// Moment of inertia about any line through the fixed point perpendicular to the axis, kg m².
    pub transverse: S,
    /// Moment of inertia about the axis of symmetry, kg m².
    pub axial: S,
}

/// State of a symmetric top at t = 0. Its precession φ and spin angle ψ are 0 then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TopStart<S> {
    /// Nutation θ, rad: the angle of the axis from the upward vertical.
    pub nutation: S,
    /// Rate θ′ of the nutation at t = 0, rad/s.
    pub nutation_rate: S,
    /// Rate φ′ of the precession at t = 0, rad/s.
    pub precession_rate: S,
    /// Spin ω₃ = ψ′ + φ′ cos θ, rad/s: the angular velocity along the axis, which is constant.
    pub spin: S,
}

/// Exact motion of a symmetric heavy top in Euler's angles (rotations z–x–z): precession φ about the upward vertical,
/// nutation θ from it, spin ψ about the axis.
///
/// θ is exact by elliptic functions; φ and ψ are integrals of functions of θ, computed to rounding. The constants of
/// the motion are the energy ½ I₁(θ′² + φ′² sin² θ) + ½ I₃ ω₃² + M g l cos θ, p_φ = I₁ φ′ sin² θ + I₃ ω₃ cos θ and p_ψ
/// = I₃ ω₃. If a top passes exactly through the vertical (p_φ = ±p_ψ), θ ≥ 0 is reflected there, and φ does not jump by
/// π.
///
/// Whittaker, *Analytical Dynamics of Particles and Rigid Bodies* §71; Landau & Lifshitz, *Mechanics* §35 problem 1.
#[derive(Clone, Debug)]
pub struct HeavyTop<S> {
    /// Motion of the nutation θ, with the precession φ.
    polar: PolarAngle<S>,
    /// Constant part ω₃ (1 − I₃/I₁) of the rate ψ′ of the spin angle, rad/s.
    free_spin: S,
}

impl<S: Real> HeavyTop<S> {
    /// Creates the exact motion of the top `top` from its state `start` at t = 0.
    #[must_use]
    pub fn new(top: Top<S>, start: TopStart<S>) -> Self {
        let ratio = top.axial / top.transverse;
        let polar = PolarAngle::new(PolarStart {
            theta: start.nutation,
            theta_rate: start.nutation_rate,
            phi_rate: start.precession_rate,
            beta: S::int(2) * top.mass * top.gravity * top.arm / top.transverse,
            spin: start.spin * ratio,
        });
        Self { polar, free_spin: start.spin - start.spin * ratio }
    }

    /// Cosine of the nutation θ, the angle of the axis from the upward vertical, at time t, s.
    #[must_use]
    pub fn cosine(&self, t: S) -> S {
        self.polar.cosine(t)
    }

    /// Nutation θ, the angle of the axis from the upward vertical, at time t, s: from 0 to π rad.
    #[must_use]
    pub fn nutation(&self, t: S) -> S {
        self.polar.angle(t)
    }

    /// Rate θ′ of the nutation at time t, s, in rad/s; NaN if the axis is vertical.
    #[must_use]
    pub fn nutation_rate(&self, t: S) -> S {
        self.polar.angle_rate(t)
    }

    /// Precession φ, the angle about the upward vertical, at time t, s, in rad, with φ = 0 at t = 0.
    #[must_use]
    pub fn precession(&self, t: S) -> S {
        let [from_below, from_above] = self.polar.parts_of_precession(t);
        from_below + from_above
    }

    /// Rate φ′ of the precession at time t, s, in rad/s.
    #[must_use]
    pub fn precession_rate(&self, t: S) -> S {
        self.polar.precession_rate(t)
    }

    /// Spin angle ψ about the axis of the top at time t, s, in rad, with ψ = 0 at t = 0.
    #[must_use]
    pub fn spin_angle(&self, t: S) -> S {
        // φ′ cos θ = b − ½(a + b)/(1 + u) + ½(a − b)/(1 − u) and ψ′ = ω₃ − φ′ cos θ.
        let [from_below, from_above] = self.polar.parts_of_precession(t);
        self.free_spin * t + (from_below - from_above)
    }

    /// Time after which the nutation θ repeats, s; infinite if it never repeats.
    #[must_use]
    pub fn nutation_period(&self) -> S {
        self.polar.period()
    }

    /// Smallest and largest nutation θ of the motion, rad.
    #[must_use]
    pub fn extremes(&self) -> [S; 2] {
        self.polar.extremes()
    }
}
