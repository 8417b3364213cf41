//! The free rigid body.

use super::{DERIVATIVE, Dd, INSTANTS, assert_close, dd, derivative};
use tripos_sim::exact::FreeBody;
use tripos_traits::Scalar;

fn body(inertia: [&str; 3], omega_0: [&str; 3]) -> (FreeBody<Dd>, [Dd; 3]) {
    (FreeBody::new(inertia.map(dd), omega_0.map(dd)), inertia.map(dd))
}

/// Table: I = (1, 2, 3), ω₀ = (0.7, 0, 1.1).
#[test]
fn angular_velocities_are_those_of_the_table() {
    let (motion, _) = body(["1", "2", "3"], ["0.7", "0", "1.1"]);
    assert_close(motion.period(), dd("5.92091402687042592"), 2e-17, "period");
    for (t, omega) in [
        ("1", ["0.332059703889005439", "0.616227517280059497", "1.04087521617576779"]),
        ("5", ["0.381734401720633814", "-0.586752798496087075", "1.04653733066989544"]),
        ("10", ["-0.25392882903334178", "-0.652319055206695522", "1.03351823886732386"]),
    ] {
        let in_f64 = FreeBody::new([1.0, 2.0, 3.0], [0.7, 0.0, 1.1]).angular_velocity(t.parse().unwrap());
        for axis in 0..3 {
            assert_close(motion.angular_velocity(dd(t))[axis], dd(omega[axis]), 2e-17, t);
            assert_close(Dd::from(in_f64[axis]), dd(omega[axis]), 1e-14, t);
        }
    }
}

/// Every order of the moments, circling about the smallest and the largest axis, symmetric bodies, nearly the
/// separatrix.
fn motions() -> Vec<(FreeBody<Dd>, [Dd; 3])> {
    let mut motions = Vec::new();
    for inertia in [
        ["1", "2", "3"],
        ["1", "3", "2"],
        ["2", "1", "3"],
        ["2", "3", "1"],
        ["3", "1", "2"],
        ["3", "2", "1"],
        ["2", "2", "3"],
        ["3", "2", "2"],
        ["2", "1", "2"],
        ["2", "2", "2"],
    ] {
        for omega_0 in [["0.7", "0.2", "-1.1"], ["-1.3", "0.4", "0.3"], ["0.01", "1", "-0.02"], ["0", "0.5", "1.5"]] {
            motions.push(body(inertia, omega_0));
        }
    }
    motions.push(body(["1", "2", "3"], ["0", "1", "0"]));
    motions.push(body(["1", "1", "3"], ["1", "1", "0"]));
    motions
}

#[test]
fn satisfies_eulers_equations() {
    for (motion, inertia) in motions() {
        for t in INSTANTS.map(dd) {
            let omega = motion.angular_velocity(t);
            for axis in 0..3 {
                let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
                let wanted = (inertia[next] - inertia[last]) * omega[next] * omega[last] / inertia[axis];
                let got = derivative(|t| motion.angular_velocity(t)[axis], t);
                assert_close(got, wanted, DERIVATIVE, &format!("{inertia:?} axis {axis}"));
            }
        }
    }
}

#[test]
fn keeps_energy_and_angular_momentum() {
    for (motion, inertia) in motions() {
        let square = |t: Dd, power: i32| {
            let omega = motion.angular_velocity(t);
            (0..3).fold(Dd::int(0), |sum, axis| sum + inertia[axis].powi(power) * omega[axis] * omega[axis])
        };
        for t in INSTANTS.map(dd) {
            assert_close(square(t, 1), square(Dd::int(0), 1), 1e-29, "2 T");
            assert_close(square(t, 2), square(Dd::int(0), 2), 1e-29, "L²");
        }
    }
}

#[test]
fn starts_where_it_is_told() {
    for inertia in [["1", "2", "3"], ["3", "2", "1"], ["2", "2", "3"]] {
        for omega_0 in [["0.7", "0.2", "-1.1"], ["-1.3", "-0.4", "0.3"], ["0", "1", "0"], ["0", "0", "0"]] {
            let (motion, _) = body(inertia, omega_0);
            for (got, wanted) in motion.angular_velocity(Dd::int(0)).into_iter().zip(omega_0) {
                assert_close(got, dd(wanted), 1e-30, wanted);
            }
        }
    }
}
