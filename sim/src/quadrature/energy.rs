//! Energy integral of a system with one degree of freedom, and the turning points of its motion.

use tripos_traits::System;

use super::quadrature_error::{NoQuadrature, StretchObstacle};
use crate::rounding::exactly_equal;

/// Largest number of iterations in the search for a turning point. Each iteration at least halves the bracket or the
/// last step.
const ITERATIONS: u32 = 2000;
/// Largest number of steps in the search for a turning point. The first step is a millionth of the size
/// of the coordinate.
const SEARCH: u32 = 100;
/// Largest number of steps in the search for a turning point along a periodic coordinate.
const SEARCH_OF_TURN: u32 = 1000;
/// Number of samples in a period of the coordinate, among which the search for the least kinetic energy begins.
const SAMPLES: u32 = 64;

/// System with one degree of freedom, with the energy of the start of its motion.
#[derive(Clone, Debug)]
pub(super) struct Energy<'a> {
    /// Equations of motion of the system with one degree of freedom.
    pub(super) system: Equations<'a>,
    /// Values of the parameters of the equations.
    pub(super) p: Vec<f64>,
    /// Coordinate q₀, the degree of freedom, at the start.
    pub(super) start: f64,
    /// Kinetic energy T₀ at the start of the motion, J.
    pub(super) kinetic: f64,
    /// Sign of k in q′ = k v, 1 or −1, where q is the coordinate and v the generalized speed.
    pub(super) orientation: f64,
    /// Period of the coordinate, after which the system repeats, such as 2π for an angle; `None` if there is none.
    pub(super) repeats: Option<f64>,
}

/// Point of least kinetic energy of a rotating motion: the crest of the potential energy.
pub(super) struct LeastKineticEnergy {
    /// Coordinate at which the kinetic energy of the rotating motion is least.
    pub(super) at: f64,
    /// Least kinetic energy of the rotating motion, J.
    pub(super) kinetic: f64,
    /// Distance from the crest at which the kinetic energy is about twice as large, in the unit of the
    /// coordinate.
    pub(super) width: f64,
}

/// Wrapper of equations of motion that implements `Debug`.
#[derive(Clone, Copy)]
pub(super) struct Equations<'a>(pub(super) &'a dyn System<f64>);

impl std::fmt::Debug for Equations<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Equations")
    }
}

impl<'a> Energy<'a> {
    /// True if the coordinate rises when the generalized speed is `v`.
    pub(super) fn rises(&self, v: f64) -> bool {
        self.orientation * v > 0.0
    }

    /// Creates the energy integral of the motion from coordinates `q` and speed `v`, with parameters `p`.
    /// Error if the kinetic energy or the rate of the coordinate is not regular.
    pub(super) fn new(system: &'a dyn System<f64>, p: &[f64], q: &[f64], v: f64) -> Result<Self, NoQuadrature> {
        let mut rates = vec![0.0; q.len()];
        system.coordinate_rates(p, q, &[1.0], &mut rates);
        let energy = Self {
            system: Equations(system),
            p: p.to_vec(),
            start: q[0],
            kinetic: system.kinetic_energy(p, q, &[v]),
            orientation: rates[0].signum(),
            repeats: system.coordinate_period().filter(|period| *period > 0.0 && period.is_finite()),
        };
        let inertia = energy.inertia(q);
        let regular = inertia > 0.0 && inertia.is_finite() && energy.kinetic >= 0.0 && energy.kinetic.is_finite();
        if !(regular && rates[0].is_finite() && rates[0] != 0.0 && energy.potential_slope(q[0], q[0]).is_finite()) {
            return Err(NoQuadrature::Irregular);
        }
        Ok(energy)
    }

    /// Inertia m at the coordinates `q`, as in T = ½ m v².
    pub(super) fn inertia(&self, q: &[f64]) -> f64 {
        2.0 * self.system.0.kinetic_energy(&self.p, q, &[1.0])
    }

    /// Writes the rates q′ of all coordinates at (q, v).
    pub(super) fn rates(&self, q: &[f64], v: f64, out: &mut [f64]) {
        self.system.0.coordinate_rates(&self.p, q, &[v], out);
    }

    /// Divided difference V\[a, b\] = (V(b) − V(a))/(b − a) of the potential energy V between coordinates a
    /// and b.
    pub(super) fn potential_slope(&self, a: f64, b: f64) -> f64 {
        self.system.0.potential_slope(&self.p, a, b)
    }

    /// Kinetic energy T at the coordinate `q`, J: T₀ − (q − q₀) V\[q₀, q\]. It is −∞ if this is not a number, so that
    /// the coordinate counts as lying beyond a barrier.
    pub(super) fn kinetic_energy_left(&self, q: f64) -> f64 {
        let left = self.kinetic - (q - self.start) * self.potential_slope(self.start, q);
        if left.is_finite() { left } else { f64::NEG_INFINITY }
    }

    /// Finds the coordinate of the turning point above the start (`side` 1) or below it (−1). `None` if the search
    /// meets no turning point. Error if the motion may creep to an equilibrium.
    ///
    /// Each step of the search ends at most at the zero of the parabola (or line) that approximates T, and is at most
    /// twice as long as the step before. The search therefore does not leap over a narrow barrier unless T shows no
    /// sign of it. Along a periodic coordinate, the search covers one period in small steps.
    pub(super) fn turning_point(&self, side: f64) -> Result<Option<f64>, NoQuadrature> {
        let mut step = self.start.abs().clamp(1e-6, 1.0) / 1_048_576.0;
        let mut good = self.start;
        let mut fall = side * self.potential_slope(good, good);
        if self.kinetic <= 0.0 {
            if fall > 0.0 {
                return self.checked_turning_point(self.start, side).map(Some);
            }
            // The start is the other turning point; close to it there is kinetic energy.
            while self.kinetic_energy_left(self.start + side * step) <= 0.0 {
                step *= 0.5;
                if exactly_equal(self.start + side * step, self.start) {
                    return Err(NoQuadrature::Asymptotic { at: self.start });
                }
            }
        }
        // Below this size the kinetic energy is zero up to rounding.
        let least = 16.0 * f64::EPSILON * self.kinetic;
        let (reach, longest, steps) = match self.repeats {
            Some(length) => (length, length / f64::from(SAMPLES), SEARCH_OF_TURN),
            None => (f64::INFINITY, f64::INFINITY, SEARCH),
        };
        for _ in 0..steps {
            step = step.min(longest);
            if (good - self.start).abs() > reach {
                break;
            }
            let q = good + side * step;
            let left = self.kinetic_energy_left(q);
            if left <= least || exactly_equal(q, good) {
                return self.checked_turning_point(self.zero_of_kinetic_energy(good, q), side).map(Some);
            }
            let fall_here = side * self.potential_slope(q, q);
            let bend = (fall_here - fall) / step;
            // T − fall d − ½ bend d² = 0.
            let root = (fall_here * fall_here + 2.0 * bend * left).sqrt();
            let zero = 2.0 * left / (fall_here + root);
            let zero = if zero.is_nan() && fall_here > 0.0 { left / fall_here } else { zero };
            (good, fall) = (q, fall_here);
            step = if zero > 0.0 { zero.min(2.0 * step) } else { 2.0 * step };
        }
        Ok(None)
    }

    /// True if the motion rests at its start: the start is an equilibrium, or so slow and so near to a stable
    /// equilibrium that only rounding would move it.
    pub(super) fn motion_rests(&self) -> bool {
        let (q, blur) = (self.start, 8.0 * f64::EPSILON * self.start.abs());
        if self.kinetic <= 0.0 && self.potential_slope(q, q).abs() <= 0.0 {
            return true;
        }
        let [below, above] = [q - blur, q + blur].map(|q| self.potential_slope(q, q));
        below <= 0.0 && above >= 0.0 && self.kinetic <= 0.25 * (above - below) * blur
    }

    /// Finds the point of least kinetic energy within a period `length` of the coordinate. `side` is the direction of
    /// the motion, 1 or −1.
    ///
    /// A minimum that the samples miss costs more panels, but no accuracy. The inner error is a barrier: no kinetic
    /// energy is left at the minimum, and the motion turns before it.
    pub(super) fn least_kinetic_energy(
        &self,
        length: f64,
        side: f64,
    ) -> Result<Result<LeastKineticEnergy, StretchObstacle>, NoQuadrature> {
        let place = |part: u32| self.start - side * length * f64::from(part) / f64::from(SAMPLES);
        let lowest = (0..SAMPLES)
            .min_by(|a, b| self.kinetic_energy_left(place(*a)).total_cmp(&self.kinetic_energy_left(place(*b))))
            .unwrap_or_default();
        let (mut a, mut b) = (place(lowest + 1), place(lowest) + side * length / f64::from(SAMPLES));
        // Along the motion, V rises before the crest and falls after it.
        let climb = |q: f64| side * self.potential_slope(q, q);
        let mut at = place(lowest);
        if climb(a) > 0.0 && climb(b) < 0.0 {
            while !exactly_equal(0.5 * (a + b), a) && !exactly_equal(0.5 * (a + b), b) {
                at = 0.5 * (a + b);
                if climb(at) > 0.0 { a = at } else { b = at }
            }
        }
        // A crest beyond the start is replaced by the equivalent point one period before it.
        if side * (at - self.start) > 0.0 {
            at -= side * length;
        }
        let kinetic = self.kinetic_energy_left(at);
        let least = 16.0 * f64::EPSILON * self.kinetic;
        if kinetic < -least {
            return Ok(Err(StretchObstacle::Barrier(at)));
        }
        if kinetic <= least {
            return Err(NoQuadrature::Asymptotic { at });
        }
        let step = 1e-4 * length;
        let bend =
            (self.potential_slope(at - step, at - step) - self.potential_slope(at + step, at + step)) / (2.0 * step);
        let width = (2.0 * kinetic / bend).sqrt();
        Ok(Ok(LeastKineticEnergy { at, kinetic, width: if width > 0.0 { width.min(length) } else { length } }))
    }

    /// Coordinate of the turning point between the start and a coordinate `bad` without kinetic energy.
    /// Error if the motion may creep to an equilibrium.
    pub(super) fn turning_point_before(&self, bad: f64) -> Result<f64, NoQuadrature> {
        let side = (bad - self.start).signum();
        let mut good = self.start;
        if self.kinetic <= 0.0 {
            good += 1e-3 * (bad - self.start);
        }
        if self.kinetic_energy_left(good) <= 0.0 || self.kinetic_energy_left(bad) > 0.0 {
            return Err(NoQuadrature::Asymptotic { at: bad });
        }
        self.checked_turning_point(self.zero_of_kinetic_energy(good, bad), side)
    }

    /// Finds the zero of the kinetic energy between a coordinate `good`, where it is positive, and a coordinate `bad`,
    /// where it is not. The method is Newton's, within a bracket.
    fn zero_of_kinetic_energy(&self, mut good: f64, mut bad: f64) -> f64 {
        let mut x = middle_of_energy_bracket(good, bad);
        let mut before = (bad - good).abs();
        for _ in 0..ITERATIONS {
            if (x - good) * (x - bad) >= 0.0 {
                break;
            }
            let left = self.kinetic_energy_left(x);
            if left > 0.0 {
                good = x;
            } else {
                bad = x;
            }
            let step = left / self.potential_slope(x, x);
            let next = x + step;
            if step.abs() <= f64::EPSILON * x.abs() {
                return next;
            }
            let inside = (next - good) * (next - bad) < 0.0;
            if inside && step.abs() < 0.5 * before {
                before = step.abs();
                x = next;
            } else {
                before = (bad - good).abs();
                x = middle_of_energy_bracket(good, bad);
            }
        }
        good
    }

    /// Returns the turning point `at` if the motion certainly turns there: within the rounding error of the point, the
    /// force pushes back. Otherwise returns an error.
    fn checked_turning_point(&self, at: f64, side: f64) -> Result<f64, NoQuadrature> {
        let force = self.potential_slope(at, at);
        let blur = 4.0 * f64::EPSILON * (at.abs() + self.kinetic / force.abs());
        let nearby = self.potential_slope(at - side * blur, at - side * blur);
        if side * force > 0.0 && (nearby - force).abs() < 0.5 * force.abs() {
            Ok(at)
        } else {
            Err(NoQuadrature::Asymptotic { at })
        }
    }
}

/// Middle of two numbers: the geometric mean if they have the same sign and differ by a factor of 4,
/// else the arithmetic mean.
fn middle_of_energy_bracket(a: f64, b: f64) -> f64 {
    let ratio = a / b;
    if ratio > 4.0 || (ratio > 0.0 && ratio < 0.25) {
        a.signum() * (a.abs().sqrt() * b.abs().sqrt())
    } else {
        a + 0.5 * (b - a)
    }
}
