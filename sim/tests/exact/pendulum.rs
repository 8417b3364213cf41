//! The plane pendulum.

use super::{DERIVATIVE, Dd, INSTANTS, assert_close, dd, derivative};
use tripos_sim::exact::Pendulum;
use tripos_traits::Scalar;

fn released(theta_0: &str) -> Pendulum<Dd> {
    Pendulum::new(dd("9.81"), dd(theta_0), Dd::int(0))
}

/// Table: periods for g = 9.81, l = 1, released at rest. 18 digits are given.
#[test]
fn periods_are_those_of_the_table() {
    for (theta_0, period) in [
        ("0.1", "2.0073211911753035"),
        ("1", "2.13913760055868884"),
        ("2", "2.66587094283492593"),
        ("3", "5.15806675426786591"),
        ("3.1", "6.71730714993762316"),
    ] {
        assert_close(released(theta_0).period(), dd(period), 2e-17, theta_0);
        let in_f64 = Pendulum::new(9.81, theta_0.parse().unwrap(), 0.0).period();
        assert_close(Dd::from(in_f64), dd(period), 1e-14, theta_0);
    }
}

/// Table: released at rest from 3 rad; from a right angle (IFToMM benchmark A01).
#[test]
fn angles_are_those_of_the_table() {
    let from_3 = released("3");
    for (t, angle) in [
        ("1", "1.60224890192791716"),
        ("5", "2.98235310240016875"),
        ("10", "2.92505567569992929"),
        ("100", "-2.69421106423975095"),
    ] {
        assert_close(from_3.angle(dd(t)), dd(angle), 2e-17, t);
        // At t = 100 rounding of K and of w t is 20 periods old, and the motion near the top enlarges it.
        assert_close(Dd::from(Pendulum::new(9.81, 3.0, 0.0).angle(t.parse().unwrap())), dd(angle), 2e-12, t);
    }
    let horizontal = Pendulum::new(dd("9.81"), Dd::pi() / Dd::int(2), Dd::int(0));
    assert_close(horizontal.period(), dd("2.36784194757623745"), 2e-17, "A01");
    for (t, angle) in [("1", "-1.40502731152479915"), ("5", "1.22945181148538556"), ("10", "0.278680673569982948")] {
        assert_close(horizontal.angle(dd(t)), dd(angle), 2e-17, t);
    }
}

fn motions() -> [Pendulum<Dd>; 6] {
    [("3", "0"), ("-0.3", "2"), ("0", "6.2"), ("0", "6.4"), ("7", "-20"), ("-40.5", "3")]
        .map(|(theta_0, omega_0)| Pendulum::new(dd("9.81"), dd(theta_0), dd(omega_0)))
}

#[test]
fn starts_where_it_is_told() {
    for (theta_0, omega_0) in [("3", "0"), ("-0.3", "2"), ("0", "6.4"), ("7", "-20"), ("-40.5", "3"), ("0", "0")] {
        let motion = Pendulum::new(dd("9.81"), dd(theta_0), dd(omega_0));
        assert_close(motion.angle(Dd::int(0)), dd(theta_0), 1e-29, theta_0);
        assert_close(motion.rate(Dd::int(0)), dd(omega_0), 1e-29, omega_0);
    }
}

#[test]
fn satisfies_its_equation_of_motion() {
    for motion in motions() {
        for t in INSTANTS.map(dd) {
            let rate = motion.rate(t);
            assert_close(derivative(|t| motion.angle(t), t), rate, DERIVATIVE, "θ′");
            let acceleration = -dd("9.81") * motion.angle(t).sin_cos().0;
            assert_close(derivative(|t| motion.rate(t), t), acceleration, DERIVATIVE, "θ″");
        }
    }
}

#[test]
fn keeps_its_energy_and_repeats_after_its_period() {
    for motion in motions() {
        let energy = |t: Dd| motion.rate(t) * motion.rate(t) / Dd::int(2) - dd("9.81") * motion.angle(t).sin_cos().1;
        let turn = if motion.turns_over() { Dd::pi() * Dd::int(2) } else { Dd::int(0) };
        let period = motion.period();
        for t in INSTANTS.map(dd) {
            assert_close(energy(t), energy(Dd::int(0)), 1e-28, "energy");
            let moved = (motion.angle(t + period) - motion.angle(t)).abs();
            assert_close(moved, turn, 1e-28, "one period");
        }
    }
}

#[test]
fn stays_in_its_amplitude_and_at_rest_where_it_hangs() {
    assert_close(released("3.1").amplitude(), dd("3.1"), 1e-30, "amplitude");
    let hanging = Pendulum::new(9.81, 0.0, 0.0);
    assert_eq!((hanging.angle(3.0), hanging.rate(3.0)), (0.0, 0.0));
    assert!((hanging.period() - std::f64::consts::TAU / 9.81_f64.sqrt()).abs() < 1e-15);
}

/// κ = 1 exactly: θ = 2 gd(w t) from the lowest point with ω₀ = 2 w.
#[test]
fn climbs_for_ever_with_the_energy_of_the_top() {
    let climbing = Pendulum::new(1.0, 0.0, 2.0);
    assert!((climbing.angle(1.5) - 4.0 * (0.75_f64).tanh().atan()).abs() < 1e-15);
    assert!((climbing.rate(1.5) - 2.0 / 1.5_f64.cosh()).abs() < 1e-15);
    assert!(climbing.period().is_infinite());
}
