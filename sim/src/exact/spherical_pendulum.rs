//! The spherical pendulum.

use super::polar::{Polar, PolarStart};
use tripos_traits::Real;

/// A particle on a massless rod about a fixed point: θ from the *upward* vertical, so that it hangs at θ = π, and the
/// azimuth φ about the upward vertical; φ(0) = 0.
///
/// θ″ = φ′² sin θ cos θ + (g/l) sin θ; constant are φ′ sin² θ and ½(θ′² + φ′² sin² θ) + (g/l) cos θ. It is the heavy
/// top without axial inertia.
///
/// Whittaker, *Analytical Dynamics of Particles and Rigid Bodies* §55; Landau & Lifshitz, *Mechanics* §14 problem 1.
#[derive(Clone, Debug)]
pub struct SphericalPendulum<S> {
    polar: Polar<S>,
}

impl<S: Real> SphericalPendulum<S> {
    /// The motion with g/l = `stiffness` > 0, in 1/s², from the angle θ and the rates θ′ and φ′.
    #[must_use]
    pub fn new(stiffness: S, theta: S, theta_rate: S, phi_rate: S) -> Self {
        let [zero, two] = [0, 2].map(S::int);
        Self { polar: Polar::new(PolarStart { theta, theta_rate, phi_rate, beta: two * stiffness, spin: zero }) }
    }

    /// cos θ(t): the height in units of the length.
    #[must_use]
    pub fn cosine(&self, t: S) -> S {
        self.polar.cosine(t)
    }

    /// θ(t) in [0, π], rad.
    #[must_use]
    pub fn angle(&self, t: S) -> S {
        self.polar.angle(t)
    }

    /// θ′(t), rad/s; not a number at the vertical.
    #[must_use]
    pub fn angle_rate(&self, t: S) -> S {
        self.polar.angle_rate(t)
    }

    /// φ(t), rad.
    #[must_use]
    pub fn azimuth(&self, t: S) -> S {
        let [from_below, from_above] = self.polar.parts_of_precession(t);
        from_below + from_above
    }

    /// φ′(t), rad/s.
    #[must_use]
    pub fn azimuth_rate(&self, t: S) -> S {
        self.polar.precession_rate(t)
    }

    /// The time after which θ repeats, s.
    #[must_use]
    pub fn period(&self) -> S {
        self.polar.period()
    }

    /// The smallest and the largest θ, rad.
    #[must_use]
    pub fn extremes(&self) -> [S; 2] {
        self.polar.extremes()
    }
}
