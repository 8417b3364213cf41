//! Compiled equations against motions known in closed form, in 32 digits: no integrator stands between.
//!
//! At an instant the exact motion gives q, u and, by central differences of order 8 with steps of 1e-5 s, their rates; these
//! must satisfy q' = k(q, u) and M u' = f. 1e-19 is the error of the differences,
//! mostly the rounding of angles of up to 300 rad divided by the step.

use tripos::{heavy_top, pendulum};
use tripos_sim::exact::{HeavyTop, Pendulum, Top, TopStart};
use tripos_traits::{DoubleDouble, Real, Scalar, System};

type Dd = DoubleDouble;

const TOLERANCE: f64 = 1e-19;
const INSTANTS: [&str; 5] = ["-1.3", "0.05", "0.31", "0.9", "4.7"];

fn dd(text: &str) -> Dd {
    Dd::decimal(text)
}

fn derivatives<const N: usize>(f: impl Fn(Dd) -> [Dd; N], t: Dd) -> [Dd; N] {
    let h = dd("1e-5");
    let weights = [(1, Dd::ratio(4, 5)), (2, Dd::ratio(-1, 5)), (3, Dd::ratio(4, 105)), (4, Dd::ratio(-1, 280))];
    let mut sums = [Dd::int(0); N];
    for (k, weight) in weights {
        let step = h * Dd::int(k);
        let (after, before) = (f(t + step), f(t - step));
        for (sum, (after, before)) in sums.iter_mut().zip(after.into_iter().zip(before)) {
            *sum = *sum + weight * (after - before) / h;
        }
    }
    sums
}

/// The motion `state(t)` = (q, u) is one of `system`; by Kane's method u are the motion variables.
fn assert_motion<const N: usize>(system: &dyn System<Dd>, p: &[Dd], state: impl Fn(Dd) -> ([Dd; N], [Dd; N])) {
    let zero = Dd::int(0);
    for t in INSTANTS.map(dd) {
        let (q, u) = state(t);
        let (mut rates, mut matrix, mut forcing) = ([zero; N], vec![zero; N * N], [zero; N]);
        system.coordinate_rates(p, &q, &u, &mut rates);
        system.mass_matrix(p, &q, &u, &mut matrix);
        system.forcing(p, &q, &u, &mut forcing);
        let q_dot = derivatives(|t| state(t).0, t);
        let u_dot = derivatives(|t| state(t).1, t);
        for i in 0..N {
            assert_small(q_dot[i] - rates[i], &format!("q{}' at t = {t:.3}", i + 1));
            let row = (0..N).fold(zero, |sum, j| sum + matrix[i * N + j] * u_dot[j]);
            assert_small(row - forcing[i], &format!("row {} of M u' = f at t = {t:.3}", i + 1));
        }
    }
}

fn assert_small(difference: Dd, what: &str) {
    assert!(difference.to_f64().abs() < TOLERANCE, "{what}: off by {difference:.3}");
}

#[test]
fn pendulum_moves_by_elliptic_functions() {
    let [m, l, g] = ["1.7", "0.6", "9.81"].map(dd);
    for (theta, omega) in [("3", "0"), ("2", "-1"), ("0", "9")] {
        let exact = Pendulum::new(g / l, dd(theta), dd(omega));
        assert_motion(&pendulum::kane::Kane, &[m, l, g], |t| ([exact.angle(t)], [exact.rate(t)]));
    }
}

/// The state of the model from Euler's angles φ, θ, ψ of the exact motion. The axis of the top is
/// (sin q2, −sin q1 cos q2, cos q1 cos q2) = (sin θ sin φ, −sin θ cos φ, cos θ).
fn state_of_top(motion: &HeavyTop<Dd>, spin: Dd, t: Dd) -> ([Dd; 3], [Dd; 3]) {
    let (sin, cos) = motion.nutation(t).sin_cos();
    let (sin_phi, cos_phi) = motion.precession(t).sin_cos();
    let (theta_rate, phi_rate) = (motion.nutation_rate(t), motion.precession_rate(t));
    let axis = [sin * sin_phi, -sin * cos_phi, cos];
    let axis_rate = [
        cos * theta_rate * sin_phi + sin * cos_phi * phi_rate,
        -cos * theta_rate * cos_phi + sin * sin_phi * phi_rate,
        -sin * theta_rate,
    ];
    // The axis stays above the horizontal plane, so cos q1 and cos q2 are positive.
    let (q_1, q_2) = ((-axis[1] / axis[2]).atan(), axis[0].asin());
    let ((sin_1, cos_1), (sin_2, cos_2)) = (q_1.sin_cos(), q_2.sin_cos());
    // The line of nodes (cos φ, sin φ, 0), from which ψ counts, along B2 and B1, from which q3 counts.
    let node = [sin_phi * cos_1, cos_phi * cos_2 + sin_phi * sin_1 * sin_2];
    let q_3 = motion.spin_angle(t) + angle_of_unit_vector(node);
    let u_1 = (axis[1] * axis_rate[2] - axis[2] * axis_rate[1]) / cos_2;
    ([q_1, q_2, q_3], [u_1, axis_rate[0] / cos_2, spin])
}

fn angle_of_unit_vector([y, x]: [Dd; 2]) -> Dd {
    Dd::int(2) * (y / (Dd::int(1) + x)).atan()
}

#[test]
fn heavy_top_moves_by_elliptic_functions() {
    let p = ["1.3", "0.22", "0.095", "0.021", "9.81"].map(dd);
    let [mass, arm, transverse, axial, gravity] = p;
    let top = Top { mass, arm, gravity, transverse, axial };
    for start in [["0.9", "0.3", "-1.5", "55"], ["0.3", "0", "0", "60"], ["0.01", "0.02", "0", "44"]] {
        let [nutation, nutation_rate, precession_rate, spin] = start.map(dd);
        let motion = HeavyTop::new(top, TopStart { nutation, nutation_rate, precession_rate, spin });
        assert_motion(&heavy_top::kane::Kane, &p, |t| state_of_top(&motion, spin, t));
    }
}
