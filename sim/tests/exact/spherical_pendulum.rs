//! The spherical pendulum.

use super::{DERIVATIVE, Dd, INSTANTS, assert_close, dd, derivative};
use tripos_sim::exact::{Pendulum, SphericalPendulum};
use tripos_traits::Scalar;

/// Table: g/l = 9.81, θ₀ = 2, φ′₀ = 0.8.
#[test]
fn motion_is_that_of_the_table() {
    let motion = SphericalPendulum::new(dd("9.81"), dd("2"), Dd::int(0), dd("0.8"));
    assert_close(motion.period(), dd("1.09152605151175354"), 2e-17, "period");
    let [smallest, largest] = motion.extremes().map(|theta| theta.sin_cos().1);
    assert_close(smallest, dd("-0.416146836547142387"), 2e-17, "u₂");
    assert_close(largest, dd("-0.980978336846125515"), 2e-17, "u₁");
    for (t, cosine, [angle, rate, azimuth]) in [
        ("0.5", "-0.969538610307547483", [2.894_136_363_604_056, 2.023_361_401_486_955, 1.042_170_602_333_100_3]),
        ("1.0", "-0.448802001520821152", [2.036_220_617_799_201_3, -0.788_655_909_190_986_9, 3.378_428_111_546_719_4]),
        ("2.0", "-0.541704696341921811", [2.143_260_141_011_613_7, -1.540_575_771_728_748, 6.750_998_980_256_252]),
        ("5.0", "-0.939534394510107703", [2.792_064_474_127_171, -2.658_432_720_385_178, 16.558_783_808_780_895]),
    ] {
        let time = dd(t);
        assert_close(motion.cosine(time), dd(cosine), 1e-16, t);
        assert_close(motion.angle(time), Dd::from(angle), 1e-12, t);
        assert_close(motion.angle_rate(time), Dd::from(rate), 1e-12, t);
        assert_close(motion.azimuth(time), Dd::from(azimuth), 1e-12, t);
    }
}

#[test]
fn satisfies_its_equations_and_keeps_its_integrals() {
    let g = dd("9.81");
    for (theta, theta_rate, phi_rate) in [("2", "0", "0.8"), ("1", "2", "-3"), ("3.1", "-5", "4"), ("0.3", "0", "0.4")]
    {
        let motion = SphericalPendulum::new(g, dd(theta), dd(theta_rate), dd(phi_rate));
        let constants = |t: Dd| {
            let (sin, cos) = motion.angle(t).sin_cos();
            let (rate, turn) = (motion.angle_rate(t), motion.azimuth_rate(t) * sin);
            ((rate * rate + turn * turn) / Dd::int(2) + g * cos, turn * sin)
        };
        let (energy, momentum) = constants(Dd::int(0));
        for t in INSTANTS.map(dd) {
            assert_close(constants(t).0, energy, 1e-27, "energy");
            assert_close(constants(t).1, momentum, 1e-27, "momentum");
            let (sin, cos) = motion.angle(t).sin_cos();
            let azimuth_rate = motion.azimuth_rate(t);
            assert_close(derivative(|t| motion.angle(t), t), motion.angle_rate(t), DERIVATIVE, "θ′");
            assert_close(derivative(|t| motion.azimuth(t), t), azimuth_rate, DERIVATIVE, "φ′");
            let acceleration = sin * (cos * azimuth_rate * azimuth_rate + g);
            assert_close(derivative(|t| motion.angle_rate(t), t), acceleration, DERIVATIVE, "θ″");
        }
    }
}

/// A motion in a plane is the plane pendulum's, with angles from below.
#[test]
fn without_azimuthal_rate_it_is_the_plane_pendulum() {
    let spherical = SphericalPendulum::new(dd("9.81"), Dd::pi() - dd("1.2"), dd("0.5"), Dd::int(0));
    let plane = Pendulum::new(dd("9.81"), dd("1.2"), dd("-0.5"));
    for t in INSTANTS.map(dd) {
        assert_close(spherical.cosine(t), -plane.angle(t).sin_cos().1, 1e-28, "height");
        assert_eq!(spherical.azimuth(t), Dd::int(0));
    }
}
