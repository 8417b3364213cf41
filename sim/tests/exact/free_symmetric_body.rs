//! The free symmetric body in Euler's angles.

use super::{DERIVATIVE, Dd, INSTANTS, assert_close, dd, derivative};
use tripos_sim::exact::{BodyStart, FreeBody, FreeSymmetricBody};
use tripos_traits::Scalar;

fn start(angles: [&str; 3], angular_velocity: [&str; 3]) -> BodyStart<Dd> {
    let [precession, nutation, spin_angle] = angles.map(dd);
    BodyStart { precession, nutation, spin_angle, angular_velocity: angular_velocity.map(dd) }
}

/// Flat and long bodies; cones that go round n₃, round −n₃, round neither and round both; angles of several turns; at
/// rest.
fn motions() -> Vec<([Dd; 2], BodyStart<Dd>, FreeSymmetricBody<Dd>)> {
    let starts = [
        start(["0.4", "1.1", "-0.3"], ["1.3", "0.8", "2.1"]),
        start(["0.4", "2.6", "-0.3"], ["0.2", "0.5", "-2.1"]),
        start(["-9.5", "1.4", "20"], ["-1.3", "3", "0.1"]),
        start(["3", "0.3", "1"], ["0.1", "-0.02", "4"]),
        start(["1", "1.5", "0"], ["0", "0.3", "-5"]),
        start(["1", "1.5", "0"], ["2", "0", "0.5"]),
        start(["1", "1.5", "2"], ["0", "0", "0"]),
    ];
    let mut motions = Vec::new();
    for inertia in [["0.3", "0.5"], ["0.3", "0.1"], ["0.4", "0.4"]] {
        let [transverse, axial] = inertia.map(dd);
        for start in starts {
            motions.push(([transverse, axial], start, FreeSymmetricBody::new(transverse, axial, start)));
        }
    }
    motions
}

#[test]
fn starts_where_it_is_told() {
    for (_, start, motion) in motions() {
        let wanted = [start.precession, start.nutation, start.spin_angle];
        for (angle, wanted) in motion.angles(Dd::int(0)).into_iter().zip(wanted) {
            assert_close(angle, wanted, 1e-29, "angle");
        }
        for (rate, wanted) in motion.angular_velocity(Dd::int(0)).into_iter().zip(start.angular_velocity) {
            assert_close(rate, wanted, 1e-29, "angular velocity");
        }
    }
}

/// Rates of the angles, and Euler's equations in the frame that does not spin.
#[test]
fn satisfies_its_equations_of_motion() {
    for ([transverse, axial], _, motion) in motions() {
        for t in INSTANTS.map(dd) {
            let [node, across, along] = motion.angular_velocity(t);
            let (sin, cos) = motion.angles(t)[1].sin_cos();
            let rates = [across / sin, node, along - across * cos / sin];
            for (k, rate) in rates.into_iter().enumerate() {
                assert_close(derivative(|t| motion.angles(t)[k], t), rate, DERIVATIVE, "rate of an angle");
            }
            let coupling = axial / transverse * along - across * cos / sin;
            for (k, acceleration) in [-across * coupling, node * coupling, Dd::int(0)].into_iter().enumerate() {
                assert_close(derivative(|t| motion.angular_velocity(t)[k], t), acceleration, DERIVATIVE, "ω′");
            }
        }
    }
}

/// Seen from the body, ω is given by Jacobi's functions, as for any body.
#[test]
fn its_angular_velocity_is_that_of_the_free_body() {
    for ([transverse, axial], _, motion) in motions() {
        let in_body = |t: Dd| {
            let [node, across, along] = motion.angular_velocity(t);
            let (sin, cos) = motion.angles(t)[2].sin_cos();
            [cos * node + sin * across, cos * across - sin * node, along]
        };
        let body = FreeBody::new([transverse, transverse, axial], in_body(Dd::int(0)));
        for t in INSTANTS.map(dd) {
            for (found, wanted) in in_body(t).into_iter().zip(body.angular_velocity(t)) {
                assert_close(found, wanted, 1e-27, "ω in the body");
            }
        }
    }
}

/// H along n₃: θ is steady, ψ′ = H/I₁ and φ′ = H cos θ (1/I₃ − 1/I₁), over hundreds of turns.
#[test]
fn about_its_angular_momentum_it_precesses_steadily() {
    let [momentum, transverse, axial, theta] = ["1.5", "0.3", "0.5", "0.6"].map(dd);
    let (sin, cos) = theta.sin_cos();
    let angular_velocity = [Dd::int(0), momentum * sin / transverse, momentum * cos / axial];
    let start = BodyStart { precession: dd("0.2"), nutation: theta, spin_angle: dd("-1"), angular_velocity };
    let motion = FreeSymmetricBody::new(transverse, axial, start);
    assert_close(motion.precession_rate(), dd("5"), 1e-30, "|H|/I₁");
    for t in ["-3", "0.7", "500"].map(dd) {
        let spin = momentum * cos * (Dd::int(1) / axial - Dd::int(1) / transverse);
        let wanted = [dd("0.2") + dd("5") * t, theta, dd("-1") + spin * t];
        for (angle, wanted) in motion.angles(t).into_iter().zip(wanted) {
            assert_close(angle, wanted, 1e-28, "angle");
        }
    }
}
