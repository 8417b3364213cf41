//! Exact motion of the spherical pendulum, by elliptic functions.

use super::polar_angle::{PolarAngle, PolarStart};
use tripos_traits::Real;

/// Exact motion of a spherical pendulum: a particle on a massless rod about a fixed point, under gravity. θ is the
/// angle from the *upward* vertical, so that the particle hangs at θ = π. φ is the azimuth about this vertical, with φ
/// = 0 at t = 0.
///
/// Equation: θ″ = φ′² sin θ cos θ + (g/l) sin θ. The constants of the motion are φ′ sin² θ and ½(θ′² + φ′² sin² θ) +
/// (g/l) cos θ. The pendulum is a heavy top without axial inertia.
///
/// Whittaker, *Analytical Dynamics of Particles and Rigid Bodies* §55; Landau & Lifshitz, *Mechanics* §14 problem 1.
#[derive(Clone, Debug)]
pub struct SphericalPendulum<S> {
    /// Motion of the angle θ, with the azimuth φ.
    polar: PolarAngle<S>,
}

impl<S: Real> SphericalPendulum<S> {
    /// Creates the exact motion from the angle θ, rad, and the rates θ′ and φ′, rad/s, at t = 0. `stiffness` is g/l >
    /// 0, 1/s².
    #[must_use]
    pub fn new(stiffness: S, theta: S, theta_rate: S, phi_rate: S) -> Self {
        let [zero, two] = [0, 2].map(S::int);
        Self { polar: PolarAngle::new(PolarStart { theta, theta_rate, phi_rate, beta: two * stiffness, spin: zero }) }
    }

    /// Cosine of the angle θ from the upward vertical at time t, s. It is the height of the particle in units of the
    /// length of the rod.
    #[must_use]
    pub fn cosine(&self, t: S) -> S {
        self.polar.cosine(t)
    }

    /// Angle θ from the upward vertical at time t, s: from 0 to π rad.
    #[must_use]
    pub fn angle(&self, t: S) -> S {
        self.polar.angle(t)
    }

    /// Rate θ′ of the angle from the upward vertical at time t, s, in rad/s; NaN if the rod is vertical.
    #[must_use]
    pub fn angle_rate(&self, t: S) -> S {
        self.polar.angle_rate(t)
    }

    /// Azimuth φ about the upward vertical at time t, s, in rad, with φ = 0 at t = 0.
    #[must_use]
    pub fn azimuth(&self, t: S) -> S {
        let [from_below, from_above] = self.polar.parts_of_precession(t);
        from_below + from_above
    }

    /// Rate φ′ of the azimuth at time t, s, in rad/s.
    #[must_use]
    pub fn azimuth_rate(&self, t: S) -> S {
        self.polar.precession_rate(t)
    }

    /// Time after which the angle θ repeats, s; infinite if it never repeats.
    #[must_use]
    pub fn period(&self) -> S {
        self.polar.period()
    }

    /// Smallest and largest angle θ from the upward vertical in the motion, rad.
    #[must_use]
    pub fn extremes(&self) -> [S; 2] {
        self.polar.extremes()
    }
}
