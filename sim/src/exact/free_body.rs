//! Exact rotation of a rigid body without torque, by elliptic functions.

use super::elliptic::Elliptic;
use super::trigonometry::arctangent_of_two;
use tripos_traits::Real;

/// Exact solution of Euler's equations I₁ ω₁′ = (I₂ − I₃) ω₂ ω₃ and cyclic. It is the angular velocity, along its
/// principal axes, of a free rigid body, or of a body held at its mass centre.
///
/// The axes are named a, b, c in the order of rising or falling moments, such that ω_c never changes its sign. Then ω_a
/// = A cn u, ω_b = B sn u, ω_c = C dn u, with u = rate · t + u₀. A symmetric body is the case m = 0.
///
/// Landau & Lifshitz, *Mechanics* §37; Whittaker, *Analytical Dynamics of Particles and Rigid Bodies* §69.
#[derive(Clone, Debug)]
pub struct FreeBody<S> {
    /// Kind of the motion of the angular velocity, with its constants.
    motion: Motion<S>,
}

/// Kind of the motion of the angular velocity in the body.
#[derive(Clone, Debug)]
enum Motion<S> {
    /// Constant angular velocity along the principal axes, rad/s.
    Steady([S; 3]),
    /// Angular velocity that moves periodically about an outer principal axis.
    Circling(PeriodicRotation<S>),
}

/// Periodic motion of the angular velocity about a principal axis, by elliptic functions of u = rate ·
/// t + start.
#[derive(Clone, Debug)]
struct PeriodicRotation<S> {
    /// Elliptic functions that give the angular velocity.
    elliptic: Elliptic<S>,
    /// Indices of the body's principal axes in the order a, b, c; the angular velocity circles about c.
    axes: [usize; 3],
    /// Amplitudes A, B, C of the angular velocity's components along the axes a, b, c, rad/s.
    sizes: [S; 3],
    /// Rate of the argument u of the elliptic functions, 1/s.
    rate: S,
    /// Argument u of the elliptic functions at t = 0.
    start: S,
}

impl<S: Real> FreeBody<S> {
    /// Creates the exact motion of a body with the positive principal moments `inertia`, kg m². `omega_0` is the
    /// angular velocity along the principal axes at t = 0, rad/s.
    #[must_use]
    pub fn new(inertia: [S; 3], omega_0: [S; 3]) -> Self {
        let rising = rising_order(inertia);
        let around_largest = momentum_excess_over_middle_axis(inertia, omega_0, rising) >= S::int(0);
        let axes = if around_largest { rising } else { [rising[2], rising[1], rising[0]] };
        let circling = PeriodicRotation::new(inertia, omega_0, axes);
        Self { motion: circling.map_or(Motion::Steady(omega_0), Motion::Circling) }
    }

    /// Angular velocity ω along the principal axes at time t, s, in rad/s.
    #[must_use]
    pub fn angular_velocity(&self, t: S) -> [S; 3] {
        match &self.motion {
            Motion::Steady(omega) => *omega,
            Motion::Circling(circling) => circling.angular_velocity_at(t),
        }
    }

    /// Time after which the angular velocity repeats, s; infinite on the separatrix, 0 if it is constant.
    #[must_use]
    pub fn period(&self) -> S {
        match &self.motion {
            Motion::Steady(_) => S::int(0),
            Motion::Circling(circling) => S::int(4) * circling.elliptic.quarter_period() / circling.rate,
        }
    }
}

impl<S: Real> PeriodicRotation<S> {
    /// Creates the periodic motion with the principal axes in this order a, b, c; `None` if the angular
    /// velocity is constant.
    fn new(inertia: [S; 3], omega_0: [S; 3], axes: [usize; 3]) -> Option<Self> {
        let zero = S::int(0);
        let [i_a, i_b, i_c] = axes.map(|axis| inertia[axis]);
        let [w_a, w_b, w_c] = axes.map(|axis| omega_0[axis]);
        // |2 T I_c − L²| and |L² − 2 T I_a|, as sums whose terms have the same sign.
        let from_c = (i_a * (i_c - i_a) * w_a * w_a + i_b * (i_c - i_b) * w_b * w_b).abs();
        let from_a = (i_b * (i_b - i_a) * w_b * w_b + i_c * (i_c - i_a) * w_c * w_c).abs();
        let [ab, bc, ac] = [i_b - i_a, i_c - i_b, i_c - i_a].map(S::abs);
        let whole = bc * from_a;
        let about_middle = w_a == zero && w_c == zero;
        if whole == zero || from_c == zero || about_middle {
            return None;
        }
        let excess = momentum_excess_over_middle_axis(inertia, omega_0, axes).abs();
        let elliptic = Elliptic::with_complement(ab * from_c / whole, ac * excess / whole);
        // ω_c keeps its sign. With A > 0, Euler's equations require −A I_a rate = ±(I_b − I_c) B C.
        let sign_b = w_c.sign() * handedness(axes) * (i_c - i_a).sign();
        let size_a = (from_c / (i_a * ac)).sqrt();
        let size_b = (from_c / (i_b * bc)).sqrt() * sign_b;
        let size_c = (from_a / (i_c * ac)).sqrt() * w_c.sign();
        let rate = (whole / (i_a * i_b * i_c)).sqrt();
        let start = elliptic.incomplete_integral(arctangent_of_two(w_b / size_b, w_a / size_a));
        Some(Self { elliptic, axes, sizes: [size_a, size_b, size_c], rate, start })
    }

    /// Angular velocity along the principal axes at time t, s, in rad/s.
    fn angular_velocity_at(&self, t: S) -> [S; 3] {
        let at = self.elliptic.jacobi_functions(self.rate * t + self.start);
        let [a, b, c] = self.axes;
        let mut omega = [S::int(0); 3];
        omega[a] = self.sizes[0] * at.cn;
        omega[b] = self.sizes[1] * at.sn;
        omega[c] = self.sizes[2] * at.dn;
        omega
    }
}

/// Difference L² − 2 T I_b of angular momentum L and kinetic energy T, with the middle moment I_b. Its sign decides
/// about which outer axis the angular velocity circles.
fn momentum_excess_over_middle_axis<S: Real>(inertia: [S; 3], omega: [S; 3], [a, b, c]: [usize; 3]) -> S {
    let of = |axis: usize| inertia[axis] * (inertia[axis] - inertia[b]) * omega[axis] * omega[axis];
    of(c) + of(a)
}

/// Indices of the principal axes in the order of rising moments of inertia.
fn rising_order<S: Real>(inertia: [S; 3]) -> [usize; 3] {
    let mut axes = [0, 1, 2];
    axes.sort_by(|&a, &b| inertia[a].partial_cmp(&inertia[b]).unwrap_or(core::cmp::Ordering::Equal));
    axes
}

/// Handedness of an order of three axes: 1 if it is cyclic, −1 if not.
fn handedness<S: Real>([a, b, _]: [usize; 3]) -> S {
    if (a + 1) % 3 == b { S::int(1) } else { S::int(-1) }
}
