//! Exact polar angle θ of a symmetric top or a spherical pendulum, and the precession φ. θ moves like a system with one
//! degree of freedom.
//!
//! u = cos θ obeys  u′² = f(u) = (1 − u²)(α − β u) − (a − b u)²  with β = 2 M g l/I, a = p_φ/I and b = p_ψ/I. The
//! motion lies between the zeros −1 ≤ u₁ ≤ u₂ ≤ 1 of f, and the third zero is u₃ ≥ 1:  u = u₁ + (u₂ − u₁) sn²,  m = (u₂
//! − u₁)/(u₃ − u₁). The precession has two parts with a pole each: φ′ = (a − b u)/(1 − u²) = ½(a + b)/(1 + u) + ½(a −
//! b)/(1 − u). They are integrated numerically, one by one.
//!
//! Whittaker, *Analytical Dynamics of Particles and Rigid Bodies* §71; Landau & Lifshitz, *Mechanics* §35.

use super::adaptive_quadrature::PeriodicIntegral;
use super::elliptic::{Elliptic, JacobiValues};
use super::trigonometry::{arctangent_of_two, root_of_positive};
use tripos_traits::Real;

/// Largest number of steps of Newton's method for the largest zero of a cubic. Each step reduces the distance from the
/// zero by at least a third.
const NEWTON_LIMIT: usize = 400;

/// Initial values and constants that determine the motion of the polar angle θ and the precession φ.
#[derive(Clone, Copy, Debug)]
pub(super) struct PolarStart<S> {
    /// Polar angle θ at t = 0, rad, from the upward vertical.
    pub(super) theta: S,
    /// Rate θ′ of the polar angle at t = 0, rad/s.
    pub(super) theta_rate: S,
    /// Rate φ′ of the precession at t = 0, rad/s.
    pub(super) phi_rate: S,
    /// Strength β = 2 M g l/I > 0 of gravity, 1/s², with the transverse inertia I about the fixed point.
    pub(super) beta: S,
    /// Momentum about the axis over the transverse inertia, b = p_ψ/I, 1/s.
    pub(super) spin: S,
}

/// Exact polar angle θ of a symmetric top as a function of time, and the precession φ as two integrals.
#[derive(Clone, Debug)]
pub(super) struct PolarAngle<S> {
    /// Elliptic functions that give the polar angle θ.
    elliptic: Elliptic<S>,
    /// Rate of the argument rate · (t + lead) of the elliptic functions, 1/s.
    rate: S,
    /// Time from the nearest instant with the lowest u = cos θ to t = 0, s; negative if that instant comes after t = 0.
    lead: S,
    /// Lowest value u₁ of u = cos θ in the motion.
    lowest: S,
    /// Difference u₂ − u₁ of the highest and the lowest value of u = cos θ.
    span: S,
    /// Distances 1 + u₁ and 1 − u₂ of the extremes of u = cos θ from −1 and 1.
    margins: [S; 2],
    /// Half sums ½(a + b) and ½(a − b) of the momenta a = p_φ/I and b = p_ψ/I, 1/s.
    momenta: [S; 2],
    /// Integrals over time of the two parts of φ′, which have poles at u = −1 and at u = 1.
    parts: [PeriodicIntegral<S>; 2],
    /// Values of the integrals of both parts of φ′ at t = 0, rad.
    at_start: [S; 2],
}

impl<S: Real> PolarAngle<S> {
    /// Creates the exact motion of the polar angle and the precession from these initial values at t = 0.
    pub(super) fn new(start: PolarStart<S>) -> Self {
        let momenta = half_momenta(start);
        let zeros = Zeros::new(start, momenta);
        let span = zeros.to_highest - zeros.to_lowest;
        let reach = span + zeros.gap_of_upper_zeros();
        let elliptic = if span == S::int(0) {
            Elliptic::new(span)
        } else {
            Elliptic::with_complement(span / reach, zeros.gap_of_upper_zeros() / reach)
        };
        let mut polar = Self {
            rate: (start.beta * reach).sqrt() / S::int(2),
            lead: S::int(0),
            lowest: start.theta.sin_cos().1 + zeros.to_lowest,
            span,
            margins: [zeros.from_bottom, zeros.from_top],
            momenta,
            parts: [PeriodicIntegral::zero_integral(), PeriodicIntegral::zero_integral()],
            at_start: [S::int(0); 2],
            elliptic,
        };
        polar.lead = polar.time_from_lowest(&zeros, start.theta_rate);
        let period = polar.period();
        polar.parts = [0, 1].map(|part| PeriodicIntegral::new(|time| polar.rate_of_part(part, time), period));
        polar.at_start = polar.precession_integrals(polar.lead);
        polar
    }

    /// Time from the nearest instant with the lowest u = cos θ to t = 0, s; negative if that instant comes after t = 0.
    fn time_from_lowest(&self, zeros: &Zeros<S>, theta_rate: S) -> S {
        if self.span == S::int(0) {
            return S::int(0);
        }
        let sn = root_of_positive(-zeros.to_lowest);
        // u rises while θ falls.
        let cn = root_of_positive(zeros.to_highest);
        let cn = if theta_rate > S::int(0) { -cn } else { cn };
        let phase = arctangent_of_two(sn, cn);
        // The phase is reduced to the range around 0, since sn² repeats after 2 K.
        let phase = if phase > S::pi() / S::int(2) { phase - S::pi() } else { phase };
        self.elliptic.incomplete_integral(phase) / self.rate
    }

    /// Period of θ, s. It is infinite if θ is constant at an unstable equilibrium, or approaches the vertical for ever.
    pub(super) fn period(&self) -> S {
        S::int(2) * self.elliptic.quarter_period() / self.rate
    }

    /// Smallest and largest polar angle θ of the motion, rad.
    pub(super) fn extremes(&self) -> [S; 2] {
        let [from_bottom, from_top] = self.margins;
        let two = S::int(2);
        [
            two * arctangent_of_two(from_top.sqrt(), root_of_positive(two - from_top)),
            two * arctangent_of_two(root_of_positive(two - from_bottom), from_bottom.sqrt()),
        ]
    }

    /// Jacobi's functions at a time, s, that is counted from an instant with the lowest u = cos θ.
    fn jacobi(&self, time_from_lowest: S) -> JacobiValues<S> {
        self.elliptic.jacobi_functions(self.rate * time_from_lowest)
    }

    /// Distances 1 + u and 1 − u of u = cos θ from −1 and 1, each with a small relative error.
    fn distances_of_cosine_from_one(&self, at: &JacobiValues<S>) -> (S, S) {
        (self.margins[0] + self.span * at.sn * at.sn, self.margins[1] + self.span * at.cn * at.cn)
    }

    /// Cosine u = cos θ of the polar angle at time t, s.
    pub(super) fn cosine(&self, t: S) -> S {
        let sn = self.jacobi(t + self.lead).sn;
        self.lowest + self.span * sn * sn
    }

    /// Polar angle θ at time t, s: from 0 to π rad.
    pub(super) fn angle(&self, t: S) -> S {
        let (above, below) = self.distances_of_cosine_from_one(&self.jacobi(t + self.lead));
        S::int(2) * arctangent_of_two(below.sqrt(), above.sqrt())
    }

    /// Rate θ′ = −u′/sin θ of the polar angle at time t, s, in rad/s; NaN at θ = 0 and θ = π.
    pub(super) fn angle_rate(&self, t: S) -> S {
        let at = self.jacobi(t + self.lead);
        let (above, below) = self.distances_of_cosine_from_one(&at);
        -S::int(2) * self.span * self.rate * at.sn * at.cn * at.dn / (above * below).sqrt()
    }

    /// Rate φ′ of the precession at time t, s, in rad/s.
    pub(super) fn precession_rate(&self, t: S) -> S {
        self.rate_of_part(0, t + self.lead) + self.rate_of_part(1, t + self.lead)
    }

    /// Two parts of the precession, rad, with the sum φ(t) − φ(0). The first has its pole at u = −1, the second at u =
    /// 1.
    pub(super) fn parts_of_precession(&self, t: S) -> [S; 2] {
        let now = self.precession_integrals(t + self.lead);
        [now[0] - self.at_start[0], now[1] - self.at_start[1]]
    }

    /// Integrals of both parts of φ′, rad, from an instant with the lowest u = cos θ over `time`, s.
    fn precession_integrals(&self, time: S) -> [S; 2] {
        [0, 1].map(|part| self.parts[part].integral_to(|time| self.rate_of_part(part, time), time))
    }

    /// Rate of a part of the precession, rad/s: ½(a + b)/(1 + u) for part 0, ½(a − b)/(1 − u) for part 1. The time, s,
    /// is counted from an instant with the lowest u.
    fn rate_of_part(&self, part: usize, time_from_lowest: S) -> S {
        // A part of the precession whose momentum is 0 is 0 at all times, also at its pole.
        if self.momenta[part] == S::int(0) {
            return S::int(0);
        }
        let (above, below) = self.distances_of_cosine_from_one(&self.jacobi(time_from_lowest));
        self.momenta[part] / if part == 0 { above } else { below }
    }
}

/// Half sums ½(a + b) and ½(a − b) of the momenta, 1/s, with a = φ′ sin² θ + b cos θ. They are computed
/// without cancellation near θ = 0 or π.
fn half_momenta<S: Real>(start: PolarStart<S>) -> [S; 2] {
    let two = S::int(2);
    let (sin, cos) = (start.theta / two).sin_cos();
    let about_vertical = two * start.phi_rate * sin * sin * cos * cos;
    [about_vertical + start.spin * cos * cos, about_vertical - start.spin * sin * sin]
}

/// Zeros u₁ ≤ u₂ ≤ u₃ of the cubic f(u), stored as differences from the start u₀ and from ±1. All differences are
/// computed without cancellation.
struct Zeros<S> {
    /// Difference u₁ − u₀ ≤ 0 of the lowest zero of the cubic f(u) from the start u₀ = cos θ.
    to_lowest: S,
    /// Difference u₂ − u₀ ≥ 0 of the middle zero of the cubic f(u) from the start u₀ = cos θ.
    to_highest: S,
    /// Distance 1 + u₁ of the lowest zero u₁ of the cubic f(u) from −1.
    from_bottom: S,
    /// Distance 1 − u₂ of the middle zero u₂ of the cubic f(u) from 1.
    from_top: S,
    /// Distance u₃ − 1 of the highest zero u₃ of the cubic f(u) from 1.
    beyond_top: S,
}

impl<S: Real> Zeros<S> {
    /// Computes the zeros of the cubic f(u) from the initial values and the half sums ½(a ± b) of the momenta, 1/s.
    fn new(start: PolarStart<S>, momenta: [S; 2]) -> Self {
        let [zero, two] = [0, 2].map(S::int);
        let (sin, cos) = (start.theta / two).sin_cos();
        let (above, below) = (two * cos * cos, two * sin * sin);
        let from_start = coefficients_from_start(start);
        let [c_0, c_1, c_2] = from_start;
        if c_0 == zero && c_1 == zero {
            // θ is constant: a steady precession, or an upright top.
            let third = if c_2 < zero { -c_2 } else { zero };
            return Self {
                to_lowest: zero,
                to_highest: zero,
                from_bottom: above,
                from_top: below,
                beyond_top: third - below,
            };
        }
        let beyond_top = largest_zero_of_cubic(coefficients_from_top(start, momenta, below));
        let [to_lowest, to_highest] = inner_zeros_of_cubic(from_start, below + beyond_top);
        Self { to_lowest, to_highest, from_bottom: zero, from_top: zero, beyond_top }
            .with_distances_from_one(start.beta, momenta, above, below)
    }

    /// Difference u₃ − u₂ of the two upper zeros of the cubic f(u).
    fn gap_of_upper_zeros(&self) -> S {
        self.beyond_top + self.from_top
    }

    /// Sets the distances 1 + u₁ and 1 − u₂, from `above` = 1 + u₀ and `below` = 1 − u₀.
    ///
    /// They are computed as quotients, by f(∓1) = −(a ± b)². As differences they would lose their digits for a top that
    /// nearly passes through the vertical.
    fn with_distances_from_one(self, beta: S, momenta: [S; 2], above: S, below: S) -> Self {
        let [zero, four] = [0, 4].map(S::int);
        let [at_bottom, at_top] = momenta.map(|half| four * half * half / beta);
        let from_bottom = if at_bottom == zero {
            zero
        } else {
            at_bottom / ((above + self.to_highest) * (above + below + self.beyond_top))
        };
        let difference = below - self.to_highest;
        let from_top = if self.beyond_top > difference {
            at_top / ((below - self.to_lowest) * self.beyond_top)
        } else {
            difference
        };
        Self { from_bottom, from_top: if from_top < zero { zero } else { from_top }, ..self }
    }
}

/// Computes the differences u₁ − u₀ and u₂ − u₀ of the two lower zeros from the start. The arguments are the
/// coefficients of f(u₀ + v)/β and `third` = u₃ − u₀.
fn inner_zeros_of_cubic<S: Real>([c_0, _, c_2]: [S; 3], third: S) -> [S; 2] {
    let [zero, two] = [0, 2].map(S::int);
    // The zeros follow from their sum and their product. The product is at most 0, so that the radicand below is a sum
    // of two terms that are not negative.
    let half_sum = -(c_2 + third) / two;
    let product = if c_0 == zero { zero } else { -c_0 / third };
    let root = (half_sum * half_sum - product).sqrt();
    if half_sum > zero {
        let highest = half_sum + root;
        [product / highest, highest]
    } else {
        let lowest = half_sum - root;
        [lowest, if product == zero { zero } else { product / lowest }]
    }
}

/// Coefficients c₀, c₁, c₂ of f(1 + v)/β = v³ + c₂ v² + c₁ v + c₀, from `below` = 1 − u₀. The zeros u₂ and u₃ can be
/// close only near 1; their distances from 1 are not close.
fn coefficients_from_top<S: Real>(start: PolarStart<S>, momenta: [S; 2], below: S) -> [S; 3] {
    let PolarStart { theta, theta_rate, phi_rate, beta, spin } = start;
    let two = S::int(2);
    let sin = theta.sin_cos().0;
    // α − β and a − b:
    let excess = theta_rate * theta_rate + phi_rate * phi_rate * sin * sin - beta * below;
    let momentum = two * momenta[1];
    let c_0 = -momentum * momentum;
    let c_1 = two * (spin * momentum - excess);
    let c_2 = two * beta - excess - spin * spin;
    [c_0, c_1, c_2].map(|c| c / beta)
}

/// Coefficients c₀, c₁, c₂ of f(u₀ + v)/β = v³ + c₂ v² + c₁ v + c₀, with u₀ = cos θ at t = 0.
fn coefficients_from_start<S: Real>(start: PolarStart<S>) -> [S; 3] {
    let PolarStart { theta, theta_rate, phi_rate, beta, spin } = start;
    let two = S::int(2);
    let (sin, cos) = theta.sin_cos();
    let square = sin * sin;
    // α − β u₀ and a − b u₀ from the rates:
    let kinetic = theta_rate * theta_rate + phi_rate * phi_rate * square;
    let vertical = phi_rate * square;
    let c_0 = square * theta_rate * theta_rate;
    let c_1 = two * spin * vertical - two * cos * kinetic - beta * square;
    let c_2 = two * cos * beta - kinetic - spin * spin;
    [c_0, c_1, c_2].map(|c| c / beta)
}

/// Largest zero of the cubic v³ + c₂ v² + c₁ v + c₀, whose zeros must be real. Newton's method finds it from above,
/// where it converges monotonically.
fn largest_zero_of_cubic<S: Real>([c_0, c_1, c_2]: [S; 3]) -> S {
    // Fujiwara's bound (1916): no zero has a larger absolute value.
    let sizes = [c_2.to_f64().abs(), c_1.to_f64().abs().sqrt(), c_0.to_f64().abs().cbrt()];
    let mut v = S::from_f64(2.001 * sizes.into_iter().fold(0.0, f64::max));
    let [two, three] = [2, 3].map(S::int);
    for _ in 0..NEWTON_LIMIT {
        let value = ((v + c_2) * v + c_1) * v + c_0;
        let slope = (three * v + two * c_2) * v + c_1;
        let next = v - value / slope;
        if next >= v {
            break;
        }
        v = next;
    }
    v
}
