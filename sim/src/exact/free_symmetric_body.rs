//! Exact orientation of a symmetric rigid body without torque, in Euler's angles.

use super::trigonometry::{arctangent_of_two, nearest_whole};
use tripos_traits::Real;

/// Orientation and angular velocity at t = 0 of a free symmetric body, in Euler's angles (rotations
/// z–x–z).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyStart<S> {
    /// Precession ψ, rad: the angle of the line of nodes about the fixed third axis n₃.
    pub precession: S,
    /// Nutation θ between 0 and π, rad: the angle of the body's axis from n₃.
    pub nutation: S,
    /// Spin angle φ, rad: the angle of the body about its axis, from the line of nodes.
    pub spin_angle: S,
    /// Angular velocity, rad/s, in three components: θ′ along the line of nodes, ψ′ sin θ across the line of nodes and
    /// the body's axis, and φ′ + ψ′ cos θ along the body's axis.
    pub angular_velocity: [S; 3],
}

/// Exact motion of a symmetric rigid body without torque, in Euler's angles ψ, θ, φ about any fixed axes. The nutation
/// θ need not be steady.
///
/// The angular momentum H is fixed, and so is ω₃ along the body's axis e. With the transverse moment I₁ and the axial
/// moment I₃, ω = H/I₁ + (1 − I₃/I₁) ω₃ e. The body turns about e at the rate (1 − I₃/I₁) ω₃, while e turns about H at
/// |H|/I₁.
///
/// The product of two quaternions, that of the start and that of the turn, gives the angles, continuous in time. Its
/// parts z = cos ½θ e^{i(ψ+φ)/2} and w = sin ½θ e^{i(ψ−φ)/2} both go round ellipses about 0. If the body's axis passes
/// exactly through ±n₃, one of the ellipses is a segment: θ is reflected there, and ψ and φ do not jump by π.
///
/// Landau & Lifshitz, *Mechanics* §33 and §35; Whittaker, *Analytical Dynamics of Particles and Rigid Bodies* §§8, 69.
#[derive(Clone, Debug)]
pub struct FreeSymmetricBody<S> {
    /// Rate Ω = |H|/I₁ at which the body's axis turns about the angular momentum H, rad/s.
    rate: S,
    /// Direction H/|H| of the angular momentum in the fixed axes; 0 for a body at rest.
    direction: [S; 3],
    /// Angular velocity ω₃ along the body's axis, rad/s.
    axial: S,
    /// Rate (1 − I₃/I₁) ω₃ at which the body turns about its axis relative to the rotation about H, rad/s.
    spin: S,
    /// Ellipse of the part z = cos ½θ e^{i(ψ+φ)/2} of the body's quaternion, in the complex plane.
    z: SymmetricBodyEllipse<S>,
    /// Ellipse of the part w = sin ½θ e^{i(ψ−φ)/2} of the body's quaternion, in the complex plane.
    w: SymmetricBodyEllipse<S>,
}

/// Ellipse cos s · a + sin s · b in the complex plane.
#[derive(Clone, Debug)]
struct SymmetricBodyEllipse<S> {
    /// Point of the ellipse at s = 0: real and imaginary part.
    a: [S; 2],
    /// Point of the ellipse at s = π/2: real and imaginary part.
    b: [S; 2],
    /// Argument (angle) of the ellipse's point at s = 0, as a complex number, rad.
    argument: S,
}

impl<S: Real> FreeSymmetricBody<S> {
    /// Creates the exact motion of a body from its state `start` at t = 0. `transverse` and `axial` are its positive
    /// moments of inertia about the mass centre, kg m².
    #[must_use]
    pub fn new(transverse: S, axial: S, start: BodyStart<S>) -> Self {
        let [zero, two] = [0, 2].map(S::int);
        let [node, across, along] = start.angular_velocity;
        let axes = symmetric_body_axes(start.precession, start.nutation);
        let weights = [transverse * node, transverse * across, axial * along];
        let momentum = [0, 1, 2].map(|k| (0..3).fold(zero, |sum, axis| sum + weights[axis] * axes[axis][k]));
        let size = weights.iter().fold(zero, |sum, h| sum + *h * *h).sqrt();
        // The angular momentum of a body at rest has no direction.
        let [h1, h2, h3] = momentum.map(|h| if size == zero { zero } else { h / size });
        let sum = (start.precession + start.spin_angle) / two;
        let difference = (start.precession - start.spin_angle) / two;
        let (sin, cos) = (start.nutation / two).sin_cos();
        let [(sin_sum, cos_sum), (sin_difference, cos_difference)] = [sum, difference].map(S::sin_cos);
        let (z, w) = ([cos * cos_sum, cos * sin_sum], [sin * cos_difference, sin * sin_difference]);
        // The vector (h1, h2, h3) times the quaternion z₁ + w₁ i + w₂ j + z₂ k.
        let turned_z = [-(h1 * w[0] + h2 * w[1] + h3 * z[1]), h3 * z[0] + h1 * w[1] - h2 * w[0]];
        let turned_w = [h1 * z[0] + h2 * z[1] - h3 * w[1], h2 * z[0] + h3 * w[0] - h1 * z[1]];
        Self {
            rate: size / transverse,
            direction: [h1, h2, h3],
            axial: along,
            spin: along - along * (axial / transverse),
            z: SymmetricBodyEllipse { a: z, b: turned_z, argument: sum },
            w: SymmetricBodyEllipse { a: w, b: turned_w, argument: difference },
        }
    }

    /// Euler's angles ψ, θ and φ at time t, s, in rad; ψ and φ are continuous in time.
    #[must_use]
    pub fn angles(&self, t: S) -> [S; 3] {
        let two = S::int(2);
        let half = self.rate * t / two;
        let (sum, difference) = (self.z.argument_at(half), self.w.argument_at(half));
        let nutation = two * arctangent_of_two(self.w.size_at(half), self.z.size_at(half));
        [sum + difference, nutation, sum - difference + self.spin * t]
    }

    /// Angular velocity at time t, s, in rad/s, in the components of [`BodyStart::angular_velocity`]. The
    /// third component is constant.
    #[must_use]
    pub fn angular_velocity(&self, t: S) -> [S; 3] {
        let [precession, nutation, _] = self.angles(t);
        let [node, across, _] = symmetric_body_axes(precession, nutation);
        let along = |axis: [S; 3]| {
            let cosine = (0..3).fold(S::int(0), |sum, k| sum + axis[k] * self.direction[k]);
            self.rate * cosine
        };
        [along(node), along(across), self.axial]
    }

    /// Rate |H|/I₁ at which the body's axis goes round the angular momentum H, rad/s.
    #[must_use]
    pub fn precession_rate(&self) -> S {
        self.rate
    }
}

/// Three unit vectors in the fixed axes: along the line of nodes, perpendicular to it and the body's axis, and along
/// the body's axis. Angles are in rad.
fn symmetric_body_axes<S: Real>(precession: S, nutation: S) -> [[S; 3]; 3] {
    let ((sin_p, cos_p), (sin_n, cos_n)) = (precession.sin_cos(), nutation.sin_cos());
    [[cos_p, sin_p, S::int(0)], [-sin_p * cos_n, cos_p * cos_n, sin_n], [sin_p * sin_n, -cos_p * sin_n, cos_n]]
}

impl<S: Real> SymmetricBodyEllipse<S> {
    /// Absolute value of the ellipse's point cos s · a + sin s · b, as a complex number.
    fn size_at(&self, s: S) -> S {
        let (sin, cos) = s.sin_cos();
        let [x, y] = [0, 1].map(|k| cos * self.a[k] + sin * self.b[k]);
        (x * x + y * y).sqrt()
    }

    /// Argument (angle) of the ellipse's point at s, both in rad, continuous in s. When s grows by half a turn, the
    /// argument changes by half a turn in the same or the opposite direction.
    fn argument_at(&self, s: S) -> S {
        let [[a1, a2], [b1, b2]] = [self.a, self.b];
        let (cross, dot, square) = (a1 * b2 - a2 * b1, a1 * b1 + a2 * b2, a1 * a1 + a2 * a2);
        let turns = nearest_whole(s / S::pi());
        let (sin, cos) = (s - turns * S::pi()).sin_cos();
        self.argument + turns * S::pi() * cross.sign() + arctangent_of_two(sin * cross, cos * square + sin * dot)
    }
}
