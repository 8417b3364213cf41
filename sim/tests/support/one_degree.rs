//! Systems of one degree of freedom, written by hand.

use tripos_traits::{Lengths, System};

/// q₀′ = v, T = ½ v², V by its divided difference; further coordinates by their rates.
pub struct OneSpeed<R, V, D> {
    pub coordinates: usize,
    /// Rates of the coordinates after the first, at (q₀, v).
    pub rates: R,
    pub potential: V,
    /// Divided difference V\[a, b\] of the potential energy.
    pub slope: D,
    /// Length of q₀ after which all repeats.
    pub period: Option<f64>,
}

impl<R, V, D> System<f64> for OneSpeed<R, V, D>
where
    R: Fn(f64, f64, &mut [f64]),
    V: Fn(f64) -> f64,
    D: Fn(f64, f64) -> f64,
{
    fn lengths(&self) -> Lengths {
        Lengths { coordinates: self.coordinates, variables: 1, speeds: 1, ..Lengths::default() }
    }
    fn symmetric(&self) -> bool {
        true
    }
    fn coordinate_rates(&self, _p: &[f64], q: &[f64], v: &[f64], out: &mut [f64]) {
        out[0] = v[0];
        (self.rates)(q[0], v[0], &mut out[1..]);
    }
    fn mass_matrix(&self, _p: &[f64], _q: &[f64], _v: &[f64], out: &mut [f64]) {
        out[0] = 1.0;
    }
    fn forcing(&self, _p: &[f64], q: &[f64], _v: &[f64], out: &mut [f64]) {
        out[0] = -(self.slope)(q[0], q[0]);
    }
    fn output_count(&self) -> usize {
        self.coordinates + 1
    }
    fn outputs(&self, p: &[f64], _t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        self.whole_state(p, q, v, out);
    }
    fn generalized_speeds(&self, _p: &[f64], _q: &[f64], v: &[f64], out: &mut [f64]) {
        out.copy_from_slice(v);
    }
    fn generalized_speed_rates(&self, _p: &[f64], _q: &[f64], _v: &[f64], v_dot: &[f64], out: &mut [f64]) {
        out.copy_from_slice(v_dot);
    }
    fn motion_variables(&self, _p: &[f64], _q: &[f64], u: &[f64], out: &mut [f64]) {
        out.copy_from_slice(u);
    }
    fn kinetic_energy(&self, _p: &[f64], _q: &[f64], v: &[f64]) -> f64 {
        0.5 * v[0] * v[0]
    }
    fn potential_energy(&self, _p: &[f64], q: &[f64]) -> f64 {
        (self.potential)(q[0])
    }
    fn has_potential_slope(&self) -> bool {
        true
    }
    fn potential_slope(&self, _p: &[f64], a: f64, b: f64) -> f64 {
        (self.slope)(a, b)
    }
    fn coordinate_period(&self) -> Option<f64> {
        self.period
    }
}

/// Computes sin z/z, and 1 at 0.
pub fn sinc(z: f64) -> f64 {
    if z == 0.0 { 1.0 } else { z.sin() / z }
}

/// q″ = −g sin q, which is not known to repeat.
pub fn pendulum(g: f64) -> impl System<f64> {
    repeating_pendulum(g, None)
}

/// q″ = −g sin q, with the length after which it repeats.
pub fn repeating_pendulum(g: f64, period: Option<f64>) -> impl System<f64> {
    OneSpeed {
        period,
        coordinates: 1,
        rates: |_: f64, _: f64, _: &mut [f64]| (),
        potential: move |q: f64| -g * q.cos(),
        slope: move |a: f64, b: f64| g * (0.5 * (a + b)).sin() * sinc(0.5 * (b - a)),
    }
}

/// Nutation with precession and spin angle as quadratures: momenta over the transverse moment, weight M g l over it,
/// and p_ψ/I₃.
pub fn top([about_vertical, about_axis]: [f64; 2], weight: f64, spin: f64) -> impl System<f64> {
    let precession = move |q: f64| (about_vertical - about_axis * q.cos()) / q.sin().powi(2);
    OneSpeed {
        period: None,
        coordinates: 3,
        rates: move |q: f64, _: f64, out: &mut [f64]| {
            out[0] = precession(q);
            out[1] = spin - out[0] * q.cos();
        },
        potential: move |q: f64| {
            0.5 * (about_vertical - about_axis * q.cos()).powi(2) / q.sin().powi(2) + weight * q.cos()
        },
        slope: move |a: f64, b: f64| {
            let [(sin_a, cos_a), (sin_b, cos_b)] = [a, b].map(f64::sin_cos);
            let [square_a, square_b] = [sin_a * sin_a, sin_b * sin_b];
            let momentum = about_vertical - about_axis * cos_a;
            let rise = -about_axis * (2.0 * about_vertical - about_axis * (cos_a + cos_b));
            let by_cosine = 0.5 * (rise + momentum * momentum * (cos_a + cos_b) / square_a) / square_b + weight;
            -by_cosine * (0.5 * (a + b)).sin() * sinc(0.5 * (b - a))
        },
    }
}

/// The radius of a planar motion with angular momentum `l` about a centre with V = −μ/r; the angle, and ∫ v dt = r.
pub fn kepler(mu: f64, l: f64) -> impl System<f64> {
    OneSpeed {
        period: None,
        coordinates: 3,
        rates: move |r: f64, v: f64, out: &mut [f64]| {
            out[0] = l / (r * r);
            out[1] = v;
        },
        potential: move |r: f64| 0.5 * l * l / (r * r) - mu / r,
        slope: move |a: f64, b: f64| (mu - 0.5 * l * l * (a + b) / (a * b)) / (a * b),
    }
}
