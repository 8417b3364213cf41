//! Exact motion of the symmetric heavy top about a fixed point.

use super::polar::{Polar, PolarStart};
use tripos_traits::Real;

/// A symmetric top with a fixed point on its axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Top<S> {
    /// Mass of the top, kg.
    pub mass: S,
    /// Distance from the fixed point to the mass centre along the axis, m; positive, as is `gravity`.
    pub arm: S,
    /// Acceleration of free fall, m/s².
    pub gravity: S,
    /// Moment of inertia across the axis, about the fixed point, kg m².
    pub transverse: S,
    /// Moment of inertia about the axis, kg m².
    pub axial: S,
}

/// Start of a top. Precession and spin angle are 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TopStart<S> {
    /// Nutation θ: the angle of the axis from the upward vertical, rad.
    pub nutation: S,
    /// Rate θ′ of the nutation, rad/s.
    pub nutation_rate: S,
    /// Rate φ′ of the precession, rad/s.
    pub precession_rate: S,
    /// Spin ω₃ = ψ′ + φ′ cos θ: the angular velocity along the axis, rad/s. It is constant.
    pub spin: S,
}

/// Exact motion of a symmetric heavy top in Euler's angles: precession φ about the upward vertical, nutation θ from it,
/// spin ψ about the axis (rotations z–x–z).
///
/// θ is exact by elliptic functions; φ and ψ are integrals of functions of θ, taken to rounding. Constant are the
/// energy ½ I₁(θ′² + φ′² sin² θ) + ½ I₃ ω₃² + M g l cos θ, p_φ = I₁ φ′ sin² θ + I₃ ω₃ cos θ and p_ψ = I₃ ω₃. If a top
/// passes exactly through the vertical (p_φ = ±p_ψ), θ ≥ 0 is reflected there, and φ does not jump by π.
///
/// Whittaker, *Analytical Dynamics of Particles and Rigid Bodies* §71; Landau & Lifshitz, *Mechanics* §35 problem 1.
#[derive(Clone, Debug)]
pub struct HeavyTop<S> {
    polar: Polar<S>,
    /// Constant part of ψ′, rad/s: ω₃ (1 − I₃/I₁).
    free_spin: S,
}

impl<S: Real> HeavyTop<S> {
    /// Exact motion of the top `top` from its state `start` at t = 0.
    #[must_use]
    pub fn new(top: Top<S>, start: TopStart<S>) -> Self {
        let ratio = top.axial / top.transverse;
        let polar = Polar::new(PolarStart {
            theta: start.nutation,
            theta_rate: start.nutation_rate,
            phi_rate: start.precession_rate,
            beta: S::int(2) * top.mass * top.gravity * top.arm / top.transverse,
            spin: start.spin * ratio,
        });
        Self { polar, free_spin: start.spin - start.spin * ratio }
    }

    /// Cosine of the nutation, cos θ(t).
    #[must_use]
    pub fn cosine(&self, t: S) -> S {
        self.polar.cosine(t)
    }

    /// Nutation θ(t) in [0, π], rad.
    #[must_use]
    pub fn nutation(&self, t: S) -> S {
        self.polar.angle(t)
    }

    /// Rate θ′(t) of the nutation, rad/s; not a number where θ = 0.
    #[must_use]
    pub fn nutation_rate(&self, t: S) -> S {
        self.polar.angle_rate(t)
    }

    /// Precession φ(t) from φ(0) = 0, rad.
    #[must_use]
    pub fn precession(&self, t: S) -> S {
        let [from_below, from_above] = self.polar.parts_of_precession(t);
        from_below + from_above
    }

    /// Rate φ′(t) of the precession, rad/s.
    #[must_use]
    pub fn precession_rate(&self, t: S) -> S {
        self.polar.precession_rate(t)
    }

    /// Spin angle ψ(t) from ψ(0) = 0, rad.
    #[must_use]
    pub fn spin_angle(&self, t: S) -> S {
        // φ′ cos θ = b − ½(a + b)/(1 + u) + ½(a − b)/(1 − u) and ψ′ = ω₃ − φ′ cos θ.
        let [from_below, from_above] = self.polar.parts_of_precession(t);
        self.free_spin * t + (from_below - from_above)
    }

    /// Time after which θ repeats, s.
    #[must_use]
    pub fn nutation_period(&self) -> S {
        self.polar.period()
    }

    /// Smallest and largest nutation θ, rad.
    #[must_use]
    pub fn extremes(&self) -> [S; 2] {
        self.polar.extremes()
    }
}
