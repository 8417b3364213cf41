//! Exact orientation of a symmetric rigid body without torque.

use super::trigonometry::{angle_of, nearest_whole};
use tripos_traits::Real;

/// Start of a free symmetric body: Euler's angles (rotations z–x–z), in rad, and rates in rad/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyStart<S> {
    /// Precession ψ, rad: the angle of the line of nodes about the fixed third axis n₃.
    pub precession: S,
    /// Nutation θ in (0, π), rad: the angle of the body's axis from n₃.
    pub nutation: S,
    /// Spin angle φ, rad: the angle of the body about its axis, from the line of nodes.
    pub spin_angle: S,
    /// Angular velocity, rad/s, in three components. Along the line of nodes it is θ′; across this line and the axis ψ′
    /// sin θ; along the axis φ′ + ψ′ cos θ.
    pub angular_velocity: [S; 3],
}

/// Exact motion of a symmetric rigid body without torque, in Euler's angles about any fixed axes: θ need not be steady.
///
/// The angular momentum H is fixed, and so is ω₃ along the axis. With the transverse moment I₁ and the axial I₃ ω =
/// H/I₁ + (1 − I₃/I₁) ω₃ e: the body turns about its axis e at the second rate while all of it turns about H at |H|/I₁.
/// The product of the start's quaternion and that of the turn gives the angles, continuous in time. Its parts z = cos
/// ½θ e^{i(ψ+φ)/2} and w = sin ½θ e^{i(ψ−φ)/2} both go round ellipses about 0. If the axis passes exactly through ±n₃,
/// one of the ellipses is a segment: θ is reflected there, and ψ and φ do not jump by π.
///
/// Landau & Lifshitz, *Mechanics* §33 and §35; Whittaker, *Analytical Dynamics of Particles and Rigid Bodies* §§8, 69.
#[derive(Clone, Debug)]
pub struct FreeSymmetricBody<S> {
    /// Rate Ω = |H|/I₁, rad/s; `direction` is H/|H| in the fixed axes.
    rate: S,
    direction: [S; 3],
    /// Angular velocity ω₃ along the axis, rad/s; `spin` is (1 − I₃/I₁) ω₃.
    axial: S,
    spin: S,
    z: Ellipse<S>,
    w: Ellipse<S>,
}

/// Ellipse cos s · a + sin s · b in the plane of complex numbers; `argument` is its argument at s = 0, rad.
#[derive(Clone, Debug)]
struct Ellipse<S> {
    a: [S; 2],
    b: [S; 2],
    argument: S,
}

impl<S: Real> FreeSymmetricBody<S> {
    /// Motion of a body with the moments `transverse` and `axial`, positive, in kg m² about the mass centre.
    #[must_use]
    pub fn new(transverse: S, axial: S, start: BodyStart<S>) -> Self {
        let [zero, two] = [0, 2].map(S::int);
        let [node, across, along] = start.angular_velocity;
        let axes = moving_axes(start.precession, start.nutation);
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
            z: Ellipse { a: z, b: turned_z, argument: sum },
            w: Ellipse { a: w, b: turned_w, argument: difference },
        }
    }

    /// Euler's angles ψ, θ and φ at the time t, rad.
    #[must_use]
    pub fn angles(&self, t: S) -> [S; 3] {
        let two = S::int(2);
        let half = self.rate * t / two;
        let (sum, difference) = (self.z.argument_at(half), self.w.argument_at(half));
        let nutation = two * angle_of(self.w.size_at(half), self.z.size_at(half));
        [sum + difference, nutation, sum - difference + self.spin * t]
    }

    /// Angular velocity at the time t, as in [`BodyStart::angular_velocity`], rad/s; its third component is constant.
    #[must_use]
    pub fn angular_velocity(&self, t: S) -> [S; 3] {
        let [precession, nutation, _] = self.angles(t);
        let [node, across, _] = moving_axes(precession, nutation);
        let along = |axis: [S; 3]| {
            let cosine = (0..3).fold(S::int(0), |sum, k| sum + axis[k] * self.direction[k]);
            self.rate * cosine
        };
        [along(node), along(across), self.axial]
    }

    /// Rate |H|/I₁ at which the axis goes round the angular momentum, rad/s.
    #[must_use]
    pub fn precession_rate(&self) -> S {
        self.rate
    }
}

/// Unit vectors along the line of nodes, across it and the axis, and along the axis, in the fixed axes.
fn moving_axes<S: Real>(precession: S, nutation: S) -> [[S; 3]; 3] {
    let ((sin_p, cos_p), (sin_n, cos_n)) = (precession.sin_cos(), nutation.sin_cos());
    [[cos_p, sin_p, S::int(0)], [-sin_p * cos_n, cos_p * cos_n, sin_n], [sin_p * sin_n, -cos_p * sin_n, cos_n]]
}

impl<S: Real> Ellipse<S> {
    fn size_at(&self, s: S) -> S {
        let (sin, cos) = s.sin_cos();
        let [x, y] = [0, 1].map(|k| cos * self.a[k] + sin * self.b[k]);
        (x * x + y * y).sqrt()
    }

    /// Argument of the ellipse's point at s, rad, continuous in s: half a turn of s is half a turn of the argument, one
    /// way or the other.
    fn argument_at(&self, s: S) -> S {
        let [[a1, a2], [b1, b2]] = [self.a, self.b];
        let (cross, dot, square) = (a1 * b2 - a2 * b1, a1 * b1 + a2 * b2, a1 * a1 + a2 * a2);
        let turns = nearest_whole(s / S::pi());
        let (sin, cos) = (s - turns * S::pi()).sin_cos();
        self.argument + turns * S::pi() * cross.sign() + angle_of(sin * cross, cos * square + sin * dot)
    }
}
