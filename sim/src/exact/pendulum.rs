//! Exact motion of the plane pendulum, by elliptic functions.

use super::elliptic::Elliptic;
use super::trigonometry::{arctangent_of_two, nearest_whole, root_of_positive};
use tripos_traits::Real;

/// Exact motion of a plane pendulum, θ″ = −(g/l) sin θ. The angle θ, rad, is measured from the hanging position and
/// grows over full turns.
///
/// Let w = √(g/l), and let κ = sin²(θ₀/2) + (ω₀/2w)² be the energy over 2 w². The pendulum swings for κ < 1: sin(θ/2) =
/// √κ sn(w t + u₀; m = κ). It turns over for κ > 1: θ/2 = am(√κ w t + u₀; m = 1/κ). At κ = 1 it climbs for ever. For a
/// compound pendulum g/l = M g s/I, with the moment of inertia I about the pivot.
///
/// Whittaker, *Analytical Dynamics of Particles and Rigid Bodies* §44; DLMF 22.19(i).
#[derive(Clone, Debug)]
pub struct Pendulum<S> {
    /// Elliptic functions that give the angle of the pendulum.
    elliptic: Elliptic<S>,
    /// Kind of the motion: a swing, or full turns.
    motion: Motion<S>,
    /// Rate of the argument u = rate · t + start of the elliptic functions, 1/s.
    rate: S,
    /// Argument u of the elliptic functions at t = 0.
    start: S,
}

/// Kind of the motion of a pendulum.
#[derive(Clone, Debug)]
enum Motion<S> {
    /// The pendulum swings about the angle 2π · `turns`. `modulus` is √κ = sin(θ_max/2), with the largest angle θ_max
    /// from there.
    Libration { modulus: S, turns: S },
    /// The pendulum makes full turns in the same direction.
    Rotation,
}

impl<S: Real> Pendulum<S> {
    /// Creates the exact motion from the angle `theta_0`, rad, and the rate `omega_0`, rad/s, at t = 0. `stiffness` is
    /// g/l > 0, 1/s².
    #[must_use]
    pub fn new(stiffness: S, theta_0: S, omega_0: S) -> Self {
        let [one, two] = [1, 2].map(S::int);
        let w = stiffness.sqrt();
        let turns = nearest_whole(theta_0 / (two * S::pi()));
        let (sin, cos) = (theta_0 / two - turns * S::pi()).sin_cos();
        let speed = omega_0 / (two * w);
        let kappa = sin * sin + speed * speed;
        // 1 − κ as a difference of squares of the given values.
        let below_top = (cos - speed) * (cos + speed);
        if below_top >= S::int(0) {
            let elliptic = Elliptic::with_complement(kappa, below_top);
            // sn u₀ = sin(θ₀/2)/√κ and cn u₀ = ω₀/(2 w √κ).
            let start = elliptic.incomplete_integral(arctangent_of_two(sin, speed));
            Self { elliptic, motion: Motion::Libration { modulus: kappa.sqrt(), turns }, rate: w, start }
        } else {
            let elliptic = Elliptic::with_complement(one / kappa, -below_top / kappa);
            let start = elliptic.incomplete_integral(theta_0 / two);
            Self { elliptic, motion: Motion::Rotation, rate: kappa.sqrt() * w * omega_0.sign(), start }
        }
    }

    /// Angle θ of the pendulum at time t, s, in rad.
    #[must_use]
    pub fn angle(&self, t: S) -> S {
        let two = S::int(2);
        let at = self.elliptic.jacobi_functions(self.rate * t + self.start);
        match self.motion {
            // cos(θ/2) = dn. With the sine and the cosine the angle keeps its digits at θ = π too.
            Motion::Libration { modulus, turns } => two * (arctangent_of_two(modulus * at.sn, at.dn) + turns * S::pi()),
            Motion::Rotation => two * at.am,
        }
    }

    /// Angular velocity θ′ of the pendulum at time t, s, in rad/s.
    #[must_use]
    pub fn rate(&self, t: S) -> S {
        let two = S::int(2);
        let at = self.elliptic.jacobi_functions(self.rate * t + self.start);
        match self.motion {
            Motion::Libration { modulus, .. } => two * modulus * self.rate * at.cn,
            Motion::Rotation => two * self.rate * at.dn,
        }
    }

    /// Period of a swing to both sides, or of a full turn, s; infinite on the border between both kinds of motion.
    #[must_use]
    pub fn period(&self) -> S {
        let quarters = match self.motion {
            Motion::Libration { .. } => S::int(4),
            Motion::Rotation => S::int(2),
        };
        quarters * self.elliptic.quarter_period() / self.rate.abs()
    }

    /// True if the pendulum makes full turns, false if it swings.
    #[must_use]
    pub fn turns_over(&self) -> bool {
        matches!(self.motion, Motion::Rotation)
    }

    /// Largest angle of the swing from its lowest point, in [0, π], rad; π for a pendulum that turns over.
    #[must_use]
    pub fn amplitude(&self) -> S {
        match self.motion {
            Motion::Libration { modulus, .. } => {
                let cos = root_of_positive(self.elliptic.complement());
                S::int(2) * arctangent_of_two(modulus, cos)
            }
            Motion::Rotation => S::pi(),
        }
    }
}
