//! Exact motion of the spherical pendulum.

use super::polar::{Polar, PolarStart};
use tripos_traits::Real;

/// Exact motion of a particle on a massless rod about a fixed point. θ is the angle from the *upward* vertical, so that
/// the particle hangs at θ = π, and φ is the azimuth about the upward vertical, with φ(0) = 0.
///
/// Equation: θ″ = φ′² sin θ cos θ + (g/l) sin θ. Constant are φ′ sin² θ and ½(θ′² + φ′² sin² θ) + (g/l) cos θ. The
/// pendulum is a heavy top without axial inertia.
///
/// Whittaker, *Analytical Dynamics of Particles and Rigid Bodies* §55; Landau & Lifshitz, *Mechanics* §14 problem 1.
#[derive(Clone, Debug)]
pub struct SphericalPendulum<S> {
    polar: Polar<S>,
}

impl<S: Real> SphericalPendulum<S> {
    /// Motion with g/l = `stiffness` > 0, in 1/s², from the angle θ, rad, and the rates θ′ and φ′, rad/s.
    #[must_use]
    pub fn new(stiffness: S, theta: S, theta_rate: S, phi_rate: S) -> Self {
        let [zero, two] = [0, 2].map(S::int);
        Self { polar: Polar::new(PolarStart { theta, theta_rate, phi_rate, beta: two * stiffness, spin: zero }) }
    }

    /// Cosine of the angle, cos θ(t): the height in units of the length of the rod.
    #[must_use]
    pub fn cosine(&self, t: S) -> S {
        self.polar.cosine(t)
    }

    /// Angle θ(t) from the upward vertical, in [0, π], rad.
    #[must_use]
    pub fn angle(&self, t: S) -> S {
        self.polar.angle(t)
    }

    /// Rate θ′(t), rad/s; not a number at the vertical.
    #[must_use]
    pub fn angle_rate(&self, t: S) -> S {
        self.polar.angle_rate(t)
    }

    /// Azimuth φ(t), rad.
    #[must_use]
    pub fn azimuth(&self, t: S) -> S {
        let [from_below, from_above] = self.polar.parts_of_precession(t);
        from_below + from_above
    }

    /// Rate φ′(t) of the azimuth, rad/s.
    #[must_use]
    pub fn azimuth_rate(&self, t: S) -> S {
        self.polar.precession_rate(t)
    }

    /// Time after which θ repeats, s.
    #[must_use]
    pub fn period(&self) -> S {
        self.polar.period()
    }

    /// Smallest and largest θ, rad.
    #[must_use]
    pub fn extremes(&self) -> [S; 2] {
        self.polar.extremes()
    }
}
