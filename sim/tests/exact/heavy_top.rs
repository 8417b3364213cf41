//! The symmetric heavy top.

use super::{DERIVATIVE, Dd, INSTANTS, assert_close, dd, derivative};
use tripos_sim::exact::{HeavyTop, Top, TopStart};
use tripos_traits::Scalar;

/// Table: the looping top B.
fn top_b() -> (Top<Dd>, TopStart<Dd>) {
    let top =
        Top { mass: dd("1.3"), arm: dd("0.22"), gravity: dd("9.81"), transverse: dd("0.095"), axial: dd("0.021") };
    (top, start("0.9", "0.3", "-1.5", "55"))
}

fn start(nutation: &str, nutation_rate: &str, precession_rate: &str, spin: &str) -> TopStart<Dd> {
    TopStart {
        nutation: dd(nutation),
        nutation_rate: dd(nutation_rate),
        precession_rate: dd(precession_rate),
        spin: dd(spin),
    }
}

/// Table: roots, period and cos θ to 18 digits, angles by integration with an error of about 1e-12.
#[test]
fn the_looping_top_is_that_of_the_table() {
    let (top, start) = top_b();
    let motion = HeavyTop::new(top, start);
    assert_close(motion.nutation_period(), dd("0.563589275653064984"), 2e-17, "period");
    let [smallest, largest] = motion.extremes().map(|theta| theta.sin_cos().1);
    assert_close(smallest, dd("0.622522446190600609"), 2e-17, "u₂");
    assert_close(largest, dd("0.0647797182228726687"), 2e-17, "u₁");
    for (t, cosine, [nutation, nutation_rate, precession, spin_angle]) in [
        (
            "0.5",
            "0.576254602084107042",
            [0.956_657_895_143_952_8, -1.986_393_218_936_445, 1.422_034_649_816_892_3, 27.259_402_760_393_385],
        ),
        (
            "1.0",
            "0.426999640879573312",
            [1.129_624_216_605_650_3, -3.226_396_674_291_86, 2.729_741_355_739_625, 54.583_143_107_721],
        ),
        (
            "2.0",
            "0.0888048105656127755",
            [1.481_874_376_562_483_6, -1.345_918_330_286_857_1, 4.920_004_883_591_18, 109.302_554_744_359_43],
        ),
        (
            "5.0",
            "0.561113365274066572",
            [0.975_066_070_950_231_3, -2.234_733_400_361_546, 12.179_262_748_648_863, 273.213_749_537_511_6],
        ),
    ] {
        let time = dd(t);
        assert_close(motion.cosine(time), dd(cosine), 1e-16, t);
        assert_close(motion.nutation(time), Dd::from(nutation), 1e-11, t);
        assert_close(motion.nutation_rate(time), Dd::from(nutation_rate), 1e-10, t);
        assert_close(motion.precession(time), Dd::from(precession), 1e-11, t);
        assert_close(motion.spin_angle(time), Dd::from(spin_angle), 1e-11, t);
    }
}

#[test]
fn f64_follows_double_double() {
    let (top, start) = top_b();
    let exact = HeavyTop::new(top, start);
    let narrow = HeavyTop::new(
        Top { mass: 1.3, arm: 0.22, gravity: 9.81, transverse: 0.095, axial: 0.021 },
        TopStart { nutation: 0.9, nutation_rate: 0.3, precession_rate: -1.5, spin: 55.0 },
    );
    for t in [-3.0, 0.4, 5.0] {
        let wide = Dd::from(t);
        // Angles of up to 270 rad, from arguments rounded to f64: a hundred ε, relative.
        for (got, wanted) in [
            (narrow.nutation(t), exact.nutation(wide)),
            (narrow.nutation_rate(t), exact.nutation_rate(wide)),
            (narrow.precession(t), exact.precession(wide)),
            (narrow.spin_angle(t), exact.spin_angle(wide)),
        ] {
            assert_close(Dd::from(got), wanted, 2e-13, &format!("t = {t}"));
        }
    }
}

/// Loops, cusps (φ′ = 0 at the top), waves, a slow top, one that nearly passes upright, a steady precession.
fn motions() -> Vec<(Top<Dd>, TopStart<Dd>, HeavyTop<Dd>)> {
    let (top, looping) = top_b();
    let starts = [
        looping,
        start("0.9", "0", "0", "55"),
        start("0.9", "-0.3", "3", "55"),
        start("2.5", "1", "0.8", "2"),
        start("0.05", "0", "0", "40"),
        start("1.2", "0.7", "0", "0"),
        start("1.2", "0.7", "-2", "0"),
    ];
    starts.map(|start| (top, start, HeavyTop::new(top, start))).to_vec()
}

#[test]
fn starts_where_it_is_told() {
    let zero = Dd::int(0);
    for (_, start, motion) in motions() {
        assert_close(motion.nutation(zero), start.nutation, 1e-28, "θ");
        assert_close(motion.nutation_rate(zero), start.nutation_rate, 1e-28, "θ′");
        assert_close(motion.precession_rate(zero), start.precession_rate, 1e-28, "φ′");
        assert_close(motion.precession(zero), zero, 1e-28, "φ");
        assert_close(motion.spin_angle(zero), zero, 1e-28, "ψ");
    }
}

#[test]
fn satisfies_the_equations_of_motion() {
    for (top, start, motion) in motions() {
        for t in INSTANTS.map(dd) {
            let (sin, cos) = motion.nutation(t).sin_cos();
            let (nutation_rate, precession_rate) = (motion.nutation_rate(t), motion.precession_rate(t));
            assert_close(derivative(|t| motion.nutation(t), t), nutation_rate, DERIVATIVE, "θ′");
            assert_close(derivative(|t| motion.precession(t), t), precession_rate, DERIVATIVE, "φ′");
            let spin_rate = start.spin - precession_rate * cos;
            assert_close(derivative(|t| motion.spin_angle(t), t), spin_rate, DERIVATIVE, "ψ′");
            let torque = top.mass * top.gravity * top.arm / top.transverse;
            let spin = top.axial * start.spin / top.transverse;
            let acceleration = sin * (cos * precession_rate * precession_rate - spin * precession_rate + torque);
            assert_close(derivative(|t| motion.nutation_rate(t), t), acceleration, DERIVATIVE, "θ″");
        }
    }
}

#[test]
fn keeps_energy_and_momentum() {
    for (top, start, motion) in motions() {
        let constants = |t: Dd| {
            let (sin, cos) = motion.nutation(t).sin_cos();
            let (theta_rate, phi_rate) = (motion.nutation_rate(t), motion.precession_rate(t));
            let kinetic = top.transverse * (theta_rate * theta_rate + phi_rate * phi_rate * sin * sin) / Dd::int(2);
            let energy = kinetic + top.mass * top.gravity * top.arm * cos;
            (energy, top.transverse * phi_rate * sin * sin + top.axial * start.spin * cos)
        };
        let (energy, momentum) = constants(Dd::int(0));
        for t in INSTANTS.map(dd) {
            assert_close(constants(t).0, energy, 1e-27, "energy");
            assert_close(constants(t).1, momentum, 1e-27, "p_φ");
        }
    }
}

/// A sleeping top stays; a steady precession keeps its rate: I₁ φ′² cos θ − I₃ ω₃ φ′ + M g l = 0.
#[test]
fn steady_motions_are_steady() {
    let (top, _) = top_b();
    let sleeping = HeavyTop::new(top, start("0", "0", "0", "55"));
    assert_eq!(sleeping.nutation(dd("7")), Dd::int(0));
    let falling = HeavyTop::new(top, start("0", "0", "0", "20"));
    assert_eq!(falling.nutation(dd("7")), Dd::int(0));

    let momentum = top.axial * dd("55");
    let weight = top.mass * top.gravity * top.arm;
    let cos = dd("0.9").sin_cos().1;
    let discriminant = momentum * momentum - Dd::int(4) * top.transverse * weight * cos;
    let slow = (momentum - discriminant.sqrt()) / (Dd::int(2) * top.transverse * cos);
    let steady = HeavyTop::new(top, TopStart { precession_rate: slow, ..start("0.9", "0", "0", "55") });
    let t = dd("3");
    assert_close(steady.nutation(t), dd("0.9"), 1e-28, "θ");
    assert_close(steady.precession(t), slow * t, 1e-28, "φ");
    assert_close(steady.spin_angle(t), (dd("55") - slow * cos) * t, 1e-28, "ψ");
}

/// The axis passes through the vertical at 1e-7 rad: φ turns by π there, within 1e-8 s. Against the same motion started
/// elsewhere.
#[test]
fn a_near_passage_of_the_vertical_keeps_its_digits() {
    let (top, _) = top_b();
    let passing = HeavyTop::new(top, start("1e-7", "0", "300", "3"));
    let [smallest, largest] = passing.extremes();
    assert_close(smallest, dd("1e-7"), 1e-30, "θ at its smallest");
    let t = passing.nutation_period() * dd("0.4");
    let later = HeavyTop::new(
        top,
        TopStart {
            nutation: passing.nutation(t),
            nutation_rate: passing.nutation_rate(t),
            precession_rate: passing.precession_rate(t),
            spin: dd("3"),
        },
    );
    // The momentum a − b of 1e-12 is a difference of terms of 1: half of the digits are in the start.
    assert_close(later.extremes()[1], largest, 1e-26, "θ at its largest");
    assert_close(later.precession(-t), -passing.precession(t), 1e-19, "φ");
}

/// Upright with a push: the top leaves by θ = |θ′| t and passes through the vertical again.
#[test]
fn a_top_may_start_upright() {
    let (top, _) = top_b();
    let motion = HeavyTop::new(top, start("0", "1", "0", "55"));
    assert_close(motion.nutation(Dd::int(0)), Dd::int(0), 1e-30, "θ");
    assert_close(motion.nutation(dd("1e-12")), dd("1e-12"), 1e-30, "θ");
    assert_close(motion.nutation(motion.nutation_period()), Dd::int(0), 1e-28, "θ");
}

/// Impossible data of a top give no number, and end at once.
#[test]
fn impossible_data_give_no_number() {
    for (mass, nutation, spin) in
        [(-1.3, 0.9, 55.0), (f64::NAN, 0.9, 55.0), (1.3, f64::INFINITY, 1.0), (1.3, 0.9, f64::NAN)]
    {
        let top = Top { mass, arm: 0.22, gravity: 9.81, transverse: 0.095, axial: 0.021 };
        let start = TopStart { nutation, nutation_rate: 0.3, precession_rate: -1.5, spin };
        let motion = HeavyTop::new(top, start);
        assert!(motion.nutation(1.0).is_nan(), "{mass} {nutation} {spin}");
        assert!(motion.precession(1.0).is_nan() || motion.spin_angle(1.0).is_nan());
    }
}
