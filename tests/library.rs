//! Motions of mechanisms of the library against published results and equations written by hand.
//!
//! Truth: closed forms, first integrals by other formulas than the program's, published figures. Each scene runs by
//! every formulation, unchanged except for the method.

use crate::support::Random;
use std::path::Path;
use tripos::{Method, Overrides, Run, Scene};
use tripos_derive::Model;
use tripos_sim::Dynamics;
use tripos_sim::exact::Pendulum;

const G: f64 = 9.81;

/// A scene of the library, run by each formulation.
fn runs(scene: &str) -> Vec<(&'static str, Run)> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(scene);
    let scene = Scene::read(path).unwrap_or_else(|e| panic!("{e}")).with_compiled_equations(tripos_models::MODELS);
    let run = |by: &'static str| {
        let (rtol, atol) = (Some(1e-12), Some(1e-13));
        let how =
            Overrides { by: Some(by.into()), method: Some(Method::Dop853.into()), rtol, atol, ..Overrides::default() };
        let run = scene.simulate(&how).unwrap_or_else(|e| panic!("{by}: {e}"));
        assert!(run.failure().is_none() && run.warnings.is_empty(), "{by}: {:?} {:?}", run.failure(), run.warnings);
        assert!(run.solution.t.len() > 20, "{by}: {} samples", run.solution.t.len());
        (by, run)
    };
    ["kane", "lagrange", "newton-euler"].map(run).into()
}

/// Columns of a run, sample by sample, after the time.
fn samples<const N: usize>(run: &Run, names: [&str; N]) -> Vec<(f64, [f64; N])> {
    let columns = names.map(|name| run.column_of_quantity(name).unwrap_or_else(|e| panic!("{e}")));
    run.solution.t.iter().enumerate().map(|(at, t)| (*t, std::array::from_fn(|i| columns[i][at]))).collect()
}

fn close(found: f64, truth: f64, tolerance: f64, what: &str) {
    assert!((found - truth).abs() <= tolerance * truth.abs().max(1.0), "{what}: {found}, not {truth}");
}

/// Method: x = l + A e^(-δt) cos(wt - ε).
#[test]
fn a_cart_on_a_damped_spring_swings_as_in_closed_form() {
    let (m, k, l, c, x0): (f64, f64, f64, f64, f64) = (1.5, 60.0, 0.3, 1.2, 0.5);
    let delta = c / (2.0 * m);
    let w = (k / m - delta * delta).sqrt();
    for (by, run) in runs("cart_with_spring/scenes/released.toml") {
        for (t, [x, v]) in samples(&run, ["x", "v"]) {
            let (swing, fade) = ((x0 - l) / w, (-delta * t).exp());
            close(x, l + swing * fade * (w * (w * t).cos() + delta * (w * t).sin()), 1e-11, by);
            close(v, -swing * fade * (w * w + delta * delta) * (w * t).sin(), 1e-11, by);
        }
    }
}

/// Method: rod and piston by trigonometry, the speed by the energy at the start.
#[test]
fn a_slider_crank_keeps_its_energy_by_hand() {
    let (r, l, b, i, mr, ir, mp): (f64, f64, f64, f64, f64, f64, f64) = (0.05, 0.16, 0.05, 0.012, 0.6, 0.0022, 0.45);
    // Angle of the rod, height of the piston, inertia that the crank feels, potential.
    let by_hand = |q: f64| {
        let a = (-r / l * q.sin()).asin();
        let rate = -r / l * q.cos() / a.cos();
        let slide = -r * q.sin() - l * rate * a.sin();
        let (vx, vy) = (-r * q.cos() - b * rate * a.cos(), -r * q.sin() - b * rate * a.sin());
        let height = r * q.cos() + l * a.cos();
        let inertia = i + mr * (vx * vx + vy * vy) + ir * rate * rate + mp * slide * slide;
        (a, height, inertia, G * (mr * (r * q.cos() + b * a.cos()) + mp * height))
    };
    for (by, run) in runs("slider_crank/scenes/coasting.toml") {
        let list = samples(&run, ["q", "p", "y", "u"]);
        let energy = |q: f64, u: f64| by_hand(q).2 * u * u / 2.0 + by_hand(q).3;
        let start = energy(list[0].1[0], list[0].1[3]);
        for (_, [q, p, y, u]) in list {
            let (a, height, ..) = by_hand(q);
            close((q + p).sin(), a.sin(), 1e-11, by);
            close(y, height, 1e-11, by);
            close(energy(q, u), start, 1e-10, by);
        }
    }
}

/// Goal: Andrews' squeezing mechanism ends where it is known to. Truth: angles at 30 ms of the Test Set for Initial
/// Value Problem Solvers (F. Mazzia & C. Magherini, release 2.4, 2008, problem Andrews' squeezing mechanism), which
/// agree with these runs to 2e-9.
#[test]
fn the_squeezer_ends_where_it_is_known_to() {
    let known = [
        ("beta", 15.810_771_196_299_04),
        ("theta", -15.756_371_059_842_98),
        ("gamma", 0.040_822_240_130_731_01),
        ("phi", -0.534_730_116_322_694_8),
        ("delta", 0.524_409_965_880_530_4),
        ("omega", 0.534_730_116_322_694_8),
        ("epsilon", 1.048_080_741_042_263),
    ];
    for (by, run) in runs("squeezer/scenes/handbook.toml") {
        for (name, truth) in known {
            close(*run.column_of_quantity(name).unwrap().last().unwrap(), truth, 2e-9, &format!("{by}: {name}"));
        }
    }
}

/// Method: parallel cranks are one pendulum, whose motion is known in elliptic functions.
#[test]
fn windows_swing_as_one_pendulum() {
    let n = 2.0;
    let (inertia, torque) = ((n + 1.0) / 3.0 + n, G * (1.5 * n + 0.5));
    let exact = Pendulum::new(torque / inertia, std::f64::consts::PI / 3.0, 0.0);
    for (by, run) in runs("window_linkage/scenes/hanging.toml") {
        for (t, [first, second, third, u]) in samples(&run, ["q", "q_ground1", "q_ground2", "u"]) {
            let angle = exact.angle(t) - std::f64::consts::FRAC_PI_2;
            for found in [first, second, third] {
                close(found, angle, 1e-9, by);
            }
            close(u, exact.rate(t), 1e-9, by);
        }
    }
}

/// Method: the momentum of turning and the energy, of rods, balls and sleeve with the angle of opening, by hand.
#[test]
fn a_governor_hunts_as_its_two_integrals_say() {
    let (l, m, mb, ms, j, js) = (0.2, 0.1, 0.5, 1.0, 0.004, 0.0005);
    let turning = |s: f64| j + js + l * l * s * s * (4.0 * m / 3.0 + 2.0 * mb);
    let opening = |s: f64| l * l * (2.0 * m / 3.0 + 2.0 * m * (1.0 / 3.0 + 2.0 * s * s) + 2.0 * mb + 4.0 * ms * s * s);
    for (by, run) in runs("governor/scenes/hunting.toml") {
        let list = samples(&run, ["theta", "spin", "opening"]);
        let both = |[theta, spin, rate]: [f64; 3]| {
            let s = theta.sin();
            let twice = turning(s) * spin * spin + opening(s) * rate * rate;
            (turning(s) * spin, twice / 2.0 - G * l * theta.cos() * (4.0 * m + 2.0 * mb + 2.0 * ms))
        };
        let (momentum, energy) = both(list[0].1);
        assert!(list.iter().any(|(_, [theta, ..])| *theta > 0.6), "{by}: the balls do not fly out");
        for (_, sample) in list {
            let (found_momentum, found_energy) = both(sample);
            close(found_momentum / momentum, 1.0, 1e-10, by);
            close(found_energy / energy, 1.0, 1e-10, by);
        }
    }
}

/// Truth: B. S. Cazzolato & Z. Prime, Journal of Control Science and Engineering 2011, 528341, the equations of motion
/// with slender links, at random states and parameters.
#[test]
fn a_furuta_pendulum_has_the_published_equations() {
    let all = tripos_models::MODELS.iter().find(|m| m.name == "furuta").unwrap();
    let mut random = Random(7);
    for _ in 0..200 {
        // L1 l1 m1 J1 l2 m2 J2 b1 b2 g tau, as the file declares them.
        let p: Vec<f64> = (0..11).map(|_| random.between(0.2, 2.0)).collect();
        let [ll1, l1, m1, j1, l2, m2, j2, b1, b2, g, tau] = p[..] else { unreachable!() };
        let [t1, t2, u1, u2] = [(); 4].map(|()| random.between(-3.0, 3.0));
        let (j0, j2) = (j1 + m1 * l1 * l1 + m2 * ll1 * ll1, j2 + m2 * l2 * l2);
        let (s, c, coupling) = (t2.sin(), t2.cos(), m2 * ll1 * l2);
        let first = tau - b1 * u1 + coupling * s * u2 * u2 - u1 * u2 * (2.0 * t2).sin() * j2;
        let second = -b2 * u2 - g * m2 * l2 * s + u1 * u1 * j2 * (2.0 * t2).sin() / 2.0;
        let (a, b) = (j0 + j2 * s * s, coupling * c);
        let determinant = a * j2 - b * b;
        let truth = [(j2 * first - b * second) / determinant, (a * second - b * first) / determinant];
        for system in all.systems.iter().filter(|system| system.name != "newton-euler") {
            let mut dynamics = Dynamics::new(system.double, &p).unwrap();
            let found = dynamics.unknowns(&[t1, t2], &[u1, u2]).unwrap();
            for (x, y) in found.iter().zip(truth) {
                close(*x, y, 1e-11, system.name);
            }
        }
    }
}

/// Method: two momenta and the energy of two rings and a rotor in Euler's angles, by hand.
#[test]
fn a_gyroscope_in_gimbals_keeps_its_integrals_by_hand() {
    let (iz, ax, ay, az, b, c) = (0.011, 0.004, 0.005, 0.006, 0.003, 0.005);
    for (by, run) in runs("gimbals/scenes/nutation.toml") {
        let list = samples(&run, ["psi", "theta", "u_psi", "u_theta", "u_phi"]);
        let integrals = |[_, theta, psi_rate, rate, phi_rate]: [f64; 5]| {
            let (s, cosine) = (theta.sin(), theta.cos());
            let spin = c * (phi_rate + psi_rate * cosine);
            let across = iz + (ay + b) * s * s + az * cosine * cosine;
            let energy = (across * psi_rate * psi_rate + (ax + b) * rate * rate + spin * spin / c) / 2.0;
            [spin, across * psi_rate + spin * cosine, energy]
        };
        let start = integrals(list[0].1);
        // Magnus' drift: the outer ring goes round, though nothing torques it on.
        assert!(list.last().unwrap().1[0].abs() > 0.5, "{by}: the outer ring stays");
        for (_, sample) in list {
            for (now, at_start) in integrals(sample).into_iter().zip(start) {
                close(now / at_start, 1.0, 1e-11, by);
            }
        }
    }
}

/// Goal: Bricard's mechanism moves in its one way. Truth: with bars of one length at right angles and angles from the
/// cube, which are equal by threes, closing is sin b - sin a = sin a sin b (J. E. Baker, Mechanism and Machine Theory
/// 15 (1980) 267-286, the trihedral case).
#[test]
fn bricards_mechanism_keeps_its_one_relation() {
    for (by, run) in runs("bricard/scenes/let_go.toml") {
        for (_, [a1, b1, a3, b4, a5]) in samples(&run, ["q_P1", "q_P2", "q_P3", "q_P4", "q_P5"]) {
            close(a3, -a1, 1e-10, by);
            close(a5, -a1, 1e-10, by);
            close(b4, -b1, 1e-10, by);
            close(b4.sin() - a3.sin(), b4.sin() * a3.sin(), 1e-10, by);
        }
        assert!(run.energy_drift.unwrap() < 1e-9, "{by}: {:?}", run.energy_drift);
    }
}

/// Truth: the output of Corke's Robotics Toolbox for MATLAB for its PUMA 560 in the pose `qn` (P. I. Corke, Robotics,
/// Vision and Control (2011), section 9.1): its inertia, less the rotors of the motors, Jm G^2, and its gravity load.
#[test]
fn the_puma_weighs_what_is_printed() {
    let printed = [
        [3.6594, -0.4044, 0.1006, -0.0025, 0.0, 0.0],
        [-0.4044, 4.4137, 0.3509, 0.0, 0.0024, 0.0],
        [0.1006, 0.3509, 0.9378, 0.0, 0.0015, 0.0],
        [-0.0025, 0.0, 0.0, 0.1925, 0.0, 0.0],
        [0.0, 0.0024, 0.0015, 0.0, 0.1713, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.1941],
    ];
    let load = [0.0, 31.6399, 6.0351, 0.0, 0.0283, 0.0];
    let rotors =
        [(200e-6, 62.6111), (200e-6, 107.815), (200e-6, 53.7063), (33e-6, 76.0364), (33e-6, 71.923), (33e-6, 76.686)]
            .map(|(moment, gear): (f64, f64)| moment * gear * gear);
    let model = Model::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("models/puma560/model.toml")).unwrap();
    let mut p: Vec<f64> = model.parameters.iter().map(|p| p.value.as_ref().unwrap().to_f64()).collect();
    // The moment as printed, which no body can have.
    p[model.parameters.iter().position(|p| p.name == "Iyy3").unwrap()] = 0.086;
    let (quarter, half) = (std::f64::consts::FRAC_PI_4, std::f64::consts::PI);
    let (q, u) = ([0.0, quarter, half, 0.0, quarter, 0.0], [0.0; 6]);
    for by in ["kane", "lagrange"] {
        let system = crate::support::system("puma560", by);
        let (mut matrix, mut forcing) = ([0.0; 36], [0.0; 6]);
        system.mass_matrix(&p, &q, &u, &mut matrix);
        system.forcing(&p, &q, &u, &mut forcing);
        for i in 0..6 {
            assert!((forcing[i] + load[i]).abs() < 1e-4, "{by}: {forcing:?}");
            for j in 0..6 {
                let rotor = if i == j { rotors[i] } else { 0.0 };
                assert!((matrix[6 * i + j] + rotor - printed[i][j]).abs() < 1e-4, "{by}: {i}, {j}");
            }
        }
    }
    for (by, run) in runs("puma560/scenes/collapse.toml") {
        assert!(run.energy_drift.unwrap().abs() < 1e-10, "{by}: {:?}", run.energy_drift);
    }
}

/// Truth: a gyrostat's equations in vectors, J w' + w x (J w + h e) = -T e and h' = T for the wheel's spin momentum, h
/// = J_s (s + e . w), with the inertia of the wheel across its axle in J; the body's axes by w x b. Both by classical
/// Runge-Kutta steps short enough (P. C. Hughes, Spacecraft Attitude Dynamics (1986), section 3.5).
#[test]
fn a_satellite_tumbles_as_a_gyrostat_does() {
    type Vector = nalgebra::Vector3<f64>;
    type Matrix = nalgebra::Matrix3<f64>;
    let (moment, across, torque) = (0.5, 0.3, 0.2);
    let e = Vector::repeat(1.0 / 3.0_f64.sqrt());
    let inertia =
        Matrix::from_diagonal(&Vector::new(10.0, 15.0, 20.0)) + across * (Matrix::identity() - e * e.transpose());
    let inverse = inertia.try_inverse().unwrap();
    // Components of the inertial axes in the body: columns of a matrix that goes round with -w x.
    let slope = |w: &Vector, h: f64, axes: &Matrix| {
        (inverse * (-w.cross(&(inertia * w + h * e)) - torque * e), torque, -w.cross_matrix() * axes)
    };
    for (by, run) in runs("satellite/scenes/spin_up.toml") {
        let list = samples(&run, ["e0", "e1", "e2", "e3", "w1", "w2", "w3", "s"]);
        let mut w = Vector::new(0.1, 0.02, -0.05);
        let (mut h, mut axes, mut now) = (moment * e.dot(&w), Matrix::identity(), 0.0);
        for (t, [e0, e1, e2, e3, w1, w2, w3, s]) in list {
            let steps = ((t - now) / 0.005_f64).ceil().max(1.0);
            let step = (t - now) / steps;
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few thousand")]
            for _ in 0..steps as usize {
                let a = slope(&w, h, &axes);
                let at = |k: &(Vector, f64, Matrix), part: f64| {
                    slope(&(w + part * k.0), h + part * k.1, &(axes + part * k.2))
                };
                let b = at(&a, step / 2.0);
                let c = at(&b, step / 2.0);
                let d = at(&c, step);
                w += step / 6.0 * (a.0 + 2.0 * b.0 + 2.0 * c.0 + d.0);
                h += step / 6.0 * (a.1 + 2.0 * b.1 + 2.0 * c.1 + d.1);
                axes += step / 6.0 * (a.2 + 2.0 * b.2 + 2.0 * c.2 + d.2);
            }
            now = t;
            for (found, truth) in [w1, w2, w3].into_iter().zip(&w) {
                close(found, *truth, 1e-9, by);
            }
            close(s, h / moment - e.dot(&w), 1e-9, by);
            let attitude = nalgebra::Quaternion::new(e0, e1, e2, e3);
            close(attitude.norm(), 1.0, 1e-11, by);
            let turned = nalgebra::UnitQuaternion::from_quaternion(attitude).inverse().to_rotation_matrix();
            for (found, truth) in turned.matrix().iter().zip(&axes) {
                close(*found, *truth, 1e-8, by);
            }
        }
    }
}
