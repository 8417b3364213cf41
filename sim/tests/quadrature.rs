//! Motions by quadrature against their exact solutions.

use crate::one_degree;

use one_degree::{OneSpeed, kepler, pendulum, repeating_pendulum, top};
use tripos_sim::exact::{HeavyTop, Pendulum, SphericalPendulum, Top, TopStart};
use tripos_sim::quadrature::{MotionByQuadrature, NoQuadrature, run_by_quadrature};
use tripos_sim::{Direction, Event, Kind, Options, OutputOption, Stop};
use tripos_traits::{DoubleDouble as Dd, Real, Scalar};

const G: f64 = 9.81;

fn dd(x: f64) -> Dd {
    Dd::from_f64(x)
}

fn near(got: f64, wanted: Dd, tolerance: f64, what: &str) {
    let error = (dd(got) - wanted).to_f64().abs();
    assert!(error <= tolerance, "{what}: {got} is off by {error:.2e}");
}

/// 20 instants over `span`, the same way each time, none of them special.
fn instants(span: f64) -> impl Iterator<Item = f64> {
    (1..=20).map(move |i| span * (f64::from(i) * 0.618_033_988_75).fract())
}

/// An error of 2 ε of the period grows with the number of periods, times the rate; and so does the exact solution's
/// knowledge of f64 parameters, which is none. 8 ε of (1 + the rate) (1 + t) covers both and a few roundings.
fn rounding(t: f64, rate: f64) -> f64 {
    8.0 * f64::EPSILON * (1.0 + rate.abs()) * (1.0 + t.abs())
}

#[test]
fn the_pendulum_swings_and_turns_over_as_by_elliptic_functions() {
    let system = pendulum(G);
    for (q, v) in
        [(3.0, 0.0), (-0.3, 2.0), (0.0, 6.2), (0.0, 6.4), (1.0, -20.0), (1e-3, 0.0), (-3.1, 0.01), (3.1, -4.0)]
    {
        let exact = Pendulum::new(dd(G), dd(q), dd(v));
        let mut motion = MotionByQuadrature::new(&system, &[], &[q], v).unwrap();
        motion.cover(-100.0, 100.0).unwrap();
        assert_eq!(motion.period().is_some(), !exact.turns_over());
        if let Some(period) = motion.period() {
            near(period, exact.period(), 4.0 * f64::EPSILON * period * period, "period");
            near(motion.turning_points().1.unwrap(), exact.amplitude(), 1e-15, "amplitude");
        }
        for t in instants(100.0).chain(instants(-100.0)) {
            let state = motion.state(t).unwrap();
            let (angle, rate) = (exact.angle(dd(t)), exact.rate(dd(t)));
            // Near the top an error of the energy, ε, moves the period by ε over the distance to the top in energy.
            let growth = 1.0 + 1.0 / (1.0 - (0.5 * q).sin().powi(2) - v * v / (4.0 * G)).abs();
            let tolerance = growth * rounding(t, rate.to_f64());
            near(state[0], angle, tolerance, &format!("{q} {v} at {t}"));
            near(state[1], rate, G * tolerance, &format!("{q} {v} rate at {t}"));
        }
    }
}

/// Goal: a turn is integrated once, however many there are and however little energy is left to pass the top with.
/// Method: the pendulum by elliptic functions, forwards and backwards, over 2 … 10 000 turns, from several starts, with
/// 1 … 1e-13 of its energy left at the top. Tolerance: the effect of one rounding of the energy. All evaluations are
/// made before the first state is asked for.
#[test]
fn rotations_are_one_turn_again_and_again() {
    let system = repeating_pendulum(G, Some(std::f64::consts::TAU));
    for excess in [1.0, 1e-2, 1e-6, 1e-9, 1e-13] {
        for (q, sign) in [(0.0, 1.0), (2.5, -1.0), (-7.0, 1.0), (3.1, 1.0), (3.2, -1.0)] {
            // ½ v² = 2 g (1 + excess) less what it takes to get from the bottom to q.
            let v = sign * (4.0 * G * (f64::cos(0.5 * q).powi(2) + excess)).sqrt();
            let exact = Pendulum::new(dd(G), dd(q), dd(v));
            let motion = MotionByQuadrature::new(&system, &[], &[q], v).unwrap();
            let period = motion.period().expect("it goes round");
            let left =
                (dd(0.5) * dd(v) * dd(v) - dd(2.0 * G) * dd(0.5 * q).sin_cos().1 * dd(0.5 * q).sin_cos().1).to_f64();
            assert!(left > 0.0, "{excess} {q}");
            let growth = 1.0 + (v * v + G) / left;
            for t in instants(20.0 * period).chain(instants(-20.0 * period)).chain(instants(1e4 * period)) {
                let state = motion.state(t).unwrap();
                let (angle, rate) = (exact.angle(dd(t)), exact.rate(dd(t)));
                let tolerance = growth * rounding(t, rate.to_f64());
                near(
                    state[0],
                    angle,
                    tolerance + 2.0 * f64::EPSILON * angle.to_f64().abs(),
                    &format!("{excess} {q} at {t}"),
                );
                near(state[1], rate, G * tolerance, &format!("{excess} {q} rate at {t}"));
            }
            assert!(motion.evaluations() < 2500, "{excess} {q}: {}", motion.evaluations());
        }
    }
}

/// Goal: a steady motion is one, to rounding. Method: a heavy top that precesses steadily, from the root of its
/// condition in doubles: the nutation rests, precession and spin go on evenly. The pendulum near its unstable rest is
/// still refused.
#[test]
fn a_steady_precession_rests_in_its_nutation() {
    let (nutation, spin, weight) = (0.7_f64, 3.0, 1.0);
    let about_axis = spin;
    // w² cos θ − w s + weight = 0 for V = ½ (h − s cos θ)²/sin² θ + weight cos θ, with h = w sin² θ + s cos θ.
    let rate = (spin - (spin * spin - 4.0 * weight * nutation.cos()).sqrt()) / (2.0 * nutation.cos());
    let about_vertical = rate * nutation.sin().powi(2) + about_axis * nutation.cos();
    let system = top([about_vertical, about_axis], weight, spin);
    let motion = MotionByQuadrature::new(&system, &[], &[nutation, 0.0, 0.0], 0.0).unwrap();
    let state = motion.state(50.0).unwrap();
    assert_eq!((state[0], state[3]), (nutation, 0.0));
    assert!((state[1] - 50.0 * rate).abs() < 1e-11, "{state:?} {rate}");
    let system = pendulum(G);
    let upright = MotionByQuadrature::new(&system, &[], &[std::f64::consts::PI], 1e-18);
    assert!(matches!(upright, Err(NoQuadrature::Asymptotic { .. })), "{upright:?}");
}

/// Goal: no barrier of a motion that repeats is leapt over. Method: V = cosⁿ q from many starts, with a spike each half
/// turn that is not felt between spikes. Truth: turning points where cosⁿ q = h, and a period somewhat above twice
/// their distance over the speed between spikes; a turn where h > 1.
#[test]
fn narrow_barriers_of_motions_that_repeat_turn_them() {
    use std::f64::consts::PI;
    for n in [40_i32, 100, 400] {
        let potential = move |q: f64| q.cos().powi(n);
        let slope = move |a: f64, b: f64| {
            // xⁿ − yⁿ over x − y, and cos b − cos a over b − a.
            let (x, y) = (b.cos(), a.cos());
            let powers: f64 = (0..n).map(|k| x.powi(k) * y.powi(n - 1 - k)).sum();
            -powers * (0.5 * (a + b)).sin() * one_degree::sinc(0.5 * (b - a))
        };
        let rates = |_: f64, _: f64, _: &mut [f64]| ();
        let system = OneSpeed { coordinates: 1, rates, potential, slope, period: Some(PI) };
        for (start, v) in (0..40).flat_map(|k| [0.2, 0.9, -1.3, 1.6].map(|v| (0.4 + 0.06 * f64::from(k), v))) {
            let motion = MotionByQuadrature::new(&system, &[], &[start], v)
                .unwrap_or_else(|why| panic!("{n} {start} {v}: {why}"));
            let energy = 0.5 * v * v + potential(start);
            let (period, turns) = (motion.period().unwrap(), motion.turning_points());
            let speed = (2.0 * energy).sqrt();
            if energy > 1.0 {
                assert!(turns == (None, None) && period > PI / speed && period < 1.5 * PI / speed, "{n} {start} {v}");
                continue;
            }
            let edge = energy.powf(1.0 / f64::from(n)).acos();
            let (low, high) = (turns.0.unwrap(), turns.1.unwrap());
            assert!(
                (low - edge).abs() < 1e-12 && (high - PI + edge).abs() < 1e-12,
                "{n} {start} {v}: {low} {high} {edge}"
            );
            let there = 2.0 * (PI - 2.0 * edge) / speed;
            assert!(period > there && period < 1.5 * there, "{n} {start} {v}: {period} {there}");
        }
    }
}

/// Goal: quadratures go on turn by turn, both ways round. Method: a rate 1 + ½ sin q + v beside the pendulum: ∫ v dt is
/// the angle gone, and ∫ sin q dt = −(v − v₀)/g.
#[test]
fn quadratures_go_on_from_turn_to_turn() {
    let system = OneSpeed {
        coordinates: 2,
        rates: |q: f64, v: f64, out: &mut [f64]| out[0] = 1.0 + 0.5 * q.sin() + v,
        potential: |q: f64| -G * q.cos(),
        slope: |a: f64, b: f64| G * (0.5 * (a + b)).sin() * one_degree::sinc(0.5 * (b - a)),
        period: Some(std::f64::consts::TAU),
    };
    for (q, v) in [(0.3, 7.0), (1.0, -8.0), (-4.0, 6.5)] {
        let motion = MotionByQuadrature::new(&system, &[], &[q, 5.0], v).unwrap();
        for t in instants(300.0).chain(instants(-300.0)) {
            let state = motion.state(t).unwrap();
            let wanted = 5.0 + t - 0.5 * (state[2] - v) / G + (state[0] - q);
            assert!((state[1] - wanted).abs() < 1e-12 * (1.0 + wanted.abs()), "{q} {v} at {t}: {} {wanted}", state[1]);
        }
    }
}

#[test]
fn a_top_nutates_precesses_and_spins_as_it_should() {
    let (mass, arm, transverse, axial) = (1.3, 0.22, 0.095, 0.021);
    for (nutation, nutation_rate, precession_rate, spin) in
        [(0.9, 0.3, -1.5, 55.0), (0.9, 0.0, 0.0, 30.0), (2.0, -1.0, 3.0, -20.0), (0.05, 0.0, 40.0, 25.0)]
    {
        let about_axis = axial / transverse * spin;
        let about_vertical = precession_rate * f64::sin(nutation).powi(2) + about_axis * f64::cos(nutation);
        let system = top([about_vertical, about_axis], mass * G * arm / transverse, spin);
        let motion = MotionByQuadrature::new(&system, &[], &[nutation, 0.0, 0.0], nutation_rate).unwrap();
        let [mass, arm, gravity, transverse, axial] = [mass, arm, G, transverse, axial].map(dd);
        // What the equations hold are the momenta, rounded: the exact motion has these.
        let (sin, cos) = dd(nutation).sin_cos();
        let precession_rate = (dd(about_vertical) - dd(about_axis) * cos) / (sin * sin);
        let full_spin = dd(about_axis) * transverse / axial;
        let start =
            TopStart { nutation: dd(nutation), nutation_rate: dd(nutation_rate), precession_rate, spin: full_spin };
        let exact = HeavyTop::new(Top { mass, arm, gravity, transverse, axial }, start);
        // At each passage an angle of up to π is rounded beside its distance to the vertical, and momenta beside their
        // difference.
        let [smallest, largest] = exact.extremes().map(Real::to_f64);
        let distance = smallest.min(std::f64::consts::PI - largest);
        let passage = 8.0 * f64::EPSILON * std::f64::consts::PI / distance / exact.nutation_period().to_f64();
        for t in instants(50.0) {
            let state = motion.state(t).unwrap();
            let time = dd(t);
            let rate =
                exact.nutation_rate(time).to_f64().abs() + exact.precession_rate(time).to_f64().abs() + spin.abs();
            let tolerance = 4.0 * rounding(t, rate) + passage * t * (1.0 + rate);
            near(state[0], exact.nutation(time), tolerance, "nutation");
            near(state[1], exact.precession(time), tolerance, "precession");
            near(state[2], exact.spin_angle(time), tolerance, "spin");
        }
    }
}

/// From one passage 0.003 rad beside the vertical to the next, where the azimuth turns by almost π in a thousandth of
/// the period.
#[test]
fn a_spherical_pendulum_passes_close_to_the_vertical() {
    for (angle, angle_rate, azimuth_rate) in [(2.0, 0.0, 0.8), (1.0, 2.0, -3.0), (2.0, 0.5, 0.004), (0.003, 0.0, 900.0)]
    {
        let momentum = azimuth_rate * f64::sin(angle).powi(2);
        let system = top([momentum, 0.0], G, 0.0);
        let motion = MotionByQuadrature::new(&system, &[], &[angle, 0.0, 0.0], angle_rate).unwrap();
        let sin = dd(angle).sin_cos().0;
        let exact = SphericalPendulum::new(dd(G), dd(angle), dd(angle_rate), dd(momentum) / (sin * sin));
        // At each passage the coordinate is rounded beside the distance to the lowest point, at π.
        let distance = std::f64::consts::PI - exact.extremes()[1].to_f64();
        let passage = 8.0 * f64::EPSILON / distance / exact.period().to_f64();
        for t in instants(20.0) {
            let state = motion.state(t).unwrap();
            let rate = exact.azimuth_rate(dd(t)).to_f64().abs() + exact.angle_rate(dd(t)).to_f64().abs() + 10.0;
            let tolerance = 4.0 * rounding(t, rate) + passage * t;
            near(state[0], exact.angle(dd(t)), tolerance, &format!("angle {angle} at {t}"));
            near(state[1], exact.azimuth(dd(t)), tolerance, &format!("azimuth {angle} at {t}"));
        }
    }
}

/// q = cos t with ∫ q² dt and ∫ v³ dt, which changes its sign with v, for a hundred thousand periods: 2 π in f64 is off
/// by 2e-16.
#[test]
fn an_oscillator_keeps_its_phase_for_a_hundred_thousand_periods() {
    let system = OneSpeed {
        period: None,
        coordinates: 3,
        rates: |q: f64, v: f64, out: &mut [f64]| {
            out[0] = q * q;
            out[1] = v * v * v;
        },
        potential: |q: f64| 0.5 * q * q,
        slope: |a: f64, b: f64| 0.5 * (a + b),
    };
    for (q, v) in [(1.0, 0.0), (0.6, -0.8), (0.0, 1.0), (-1.0, 0.0), (1.0, 1e-9)] {
        let motion = MotionByQuadrature::new(&system, &[], &[q, 5.0, 0.0], v).unwrap();
        for t in instants(10.0).chain(instants(-10.0)).chain(instants(6e5)) {
            let state = motion.state(t).unwrap();
            let (sin, cos) = dd(t).sin_cos();
            let (x, rate) = (dd(q) * cos + dd(v) * sin, dd(v) * cos - dd(q) * sin);
            near(state[0], x, rounding(t, 0.0), "q");
            near(state[3], rate, rounding(t, 0.0), "v");
            // ∫ q² = ½ (q² + v²) t + ½ (q₀ v₀ − q v); ∫ v³ dt = ∫ (h − q²) dq with h = q² + v².
            let h = dd(q) * dd(q) + dd(v) * dd(v);
            let square = dd(0.5) * (h * dd(t) + dd(q) * dd(v) - x * rate) + dd(5.0);
            let cubic = |x: Dd| h * x - x * x * x / Dd::int(3);
            near(state[1], square, rounding(t, 0.0), "∫ q²");
            near(state[2], cubic(x) - cubic(dd(q)), rounding(t, 0.0), "∫ v³");
        }
    }
}

/// The exact motion in radius and angle, from (r, v).
struct Orbit {
    axis: Dd,
    eccentricity: Dd,
    motion: Dd,
    anomaly: Dd,
}

impl Orbit {
    fn new(mu: f64, l: f64, r: f64, v: f64) -> Self {
        let [mu, l, r, v] = [mu, l, r, v].map(dd);
        let two = Dd::int(2);
        let energy = v * v / two + l * l / (two * r * r) - mu / r;
        let axis = -mu / (two * energy);
        let eccentricity = (Dd::int(1) - l * l / (mu * axis)).sqrt();
        let anomaly = ((Dd::int(1) - r / axis) / eccentricity).acos();
        let anomaly = if v < Dd::int(0) { -anomaly } else { anomaly };
        Self { axis, eccentricity, motion: (mu / (axis * axis * axis)).sqrt(), anomaly }
    }

    fn period(&self) -> Dd {
        Dd::int(2) * Dd::pi() / self.motion
    }

    /// r and the angle from the pericentre, at t.
    fn at(&self, t: f64) -> [Dd; 2] {
        let e = self.eccentricity;
        let mean = self.anomaly - e * self.anomaly.sin_cos().0 + self.motion * dd(t);
        let turns = dd((mean / (Dd::int(2) * Dd::pi())).to_f64().round());
        let mean = mean - turns * Dd::int(2) * Dd::pi();
        let mut anomaly = Dd::pi() * dd(mean.to_f64().signum());
        for _ in 0..200 {
            let (sin, cos) = anomaly.sin_cos();
            anomaly = anomaly - (anomaly - e * sin - mean) / (Dd::int(1) - e * cos);
        }
        let (sin, cos) = (anomaly / Dd::int(2)).sin_cos();
        let ratio = ((Dd::int(1) + e) / (Dd::int(1) - e)).sqrt();
        let angle = Dd::int(2) * ((ratio * sin / cos).atan() + turns * Dd::pi());
        [self.axis * (Dd::int(1) - e * anomaly.sin_cos().1), angle]
    }
}

/// A pericentre of 1e-6 beside an axis of 0.5, where the angle turns by 2 π in a millionth of the period.
///
/// 32 ε of the rates at the instant for the phase, and 1e-14 a second for the angle, two passages with a hundred
/// roundings of ε each.
#[test]
fn a_nearly_radial_orbit_keeps_its_angle() {
    for pericentre in [0.3, 1e-3, 1e-6] {
        let l = f64::sqrt(2.0 * pericentre * (1.0 - pericentre));
        let system = kepler(1.0, l);
        let (r, v) = (0.4, -(2.0 / 0.4 - 2.0 - l * l / 0.16_f64).sqrt());
        let motion = MotionByQuadrature::new(&system, &[], &[r, 0.0, r], v).unwrap();
        let exact = Orbit::new(1.0, l, r, v);
        let period = motion.period().unwrap();
        near(period, exact.period(), 8.0 * f64::EPSILON * period, "period");
        let from = exact.at(0.0)[1];
        for t in instants(30.0).chain([0.05, 0.1]) {
            let state = motion.state(t).unwrap();
            let [radius, angle] = exact.at(t);
            let rate = l / radius.to_f64().powi(2) + state[3].abs();
            near(state[0], radius, rounding(t, rate), &format!("r at {t}"));
            near(state[2], radius, rounding(t, rate), &format!("∫ v at {t}"));
            near(state[1], angle - from, rounding(t, rate) + 1e-14 * t, &format!("angle of {pericentre} at {t}"));
        }
    }
}

/// r² = b² + (v t)² beside a centre without force: one turning point. And a body thrown up: q = v t − g t²/2.
#[test]
fn a_motion_with_one_turning_point_comes_and_goes() {
    let system = kepler(0.0, 2.0);
    // At r = 5 inwards, with r′ = −4: energy 8 + 4/50.
    let mut motion = MotionByQuadrature::new(&system, &[], &[5.0, 0.0, 0.0], -4.0).unwrap();
    assert_eq!(motion.state(1e60), Err(NoQuadrature::Uncovered { t: 1e60 }));
    motion.cover(-50.0, 50.0).unwrap();
    let speed_squared = 16.0 + 4.0 / 25.0;
    assert!(motion.period().is_none() && motion.turning_points().1.is_none());
    for t in instants(50.0).chain(instants(-50.0)) {
        // r² = 25 − 2·20 t + speed² t².
        let state = motion.state(t).unwrap();
        let radius = (25.0 - 40.0 * t + speed_squared * t * t).sqrt();
        assert!((state[0] - radius).abs() <= rounding(t, 4.0), "{t}: {} {radius}", state[0]);
        let angle = |t: f64| ((speed_squared * t - 20.0) / 2.0).atan();
        assert!((state[1] - (angle(t) - angle(0.0))).abs() <= rounding(0.0, 1.0), "{t}: {}", state[1]);
    }
    let thrown = OneSpeed {
        period: None,
        coordinates: 1,
        rates: |_: f64, _: f64, _: &mut [f64]| (),
        potential: |q: f64| G * q,
        slope: |_: f64, _: f64| G,
    };
    for v in [0.0, 3.0, -3.0] {
        let mut motion = MotionByQuadrature::new(&thrown, &[], &[1.0], v).unwrap();
        motion.cover(-3.0, 3.0).unwrap();
        for t in instants(3.0).chain(instants(-3.0)) {
            let state = motion.state(t).unwrap();
            assert!((state[0] - (1.0 + v * t - 0.5 * G * t * t)).abs() < 50.0 * 16.0 * f64::EPSILON, "{v} at {t}");
            assert!((state[1] - (v - G * t)).abs() < 30.0 * 16.0 * f64::EPSILON);
        }
    }
}

#[test]
fn a_free_particle_and_one_at_rest_need_no_search() {
    let free = OneSpeed {
        period: None,
        coordinates: 2,
        rates: |q: f64, v: f64, out: &mut [f64]| out[0] = q * v,
        potential: |_: f64| 0.0,
        slope: |_: f64, _: f64| 0.0,
    };
    let mut motion = MotionByQuadrature::new(&free, &[], &[1.0, 0.0], -2.0).unwrap();
    motion.cover(0.0, 10.0).unwrap();
    assert!((motion.state(10.0).unwrap()[0] + 19.0).abs() < 19.0 * 4.0 * f64::EPSILON);
    assert!((motion.state(10.0).unwrap()[1] - 180.0).abs() < 180.0 * 8.0 * f64::EPSILON);
    let hanging = pendulum(G);
    let rest = MotionByQuadrature::new(&hanging, &[], &[0.0], 0.0).unwrap();
    assert_eq!(rest.state(7.0).unwrap(), [0.0, 0.0]);
}

/// Exactly the energy of the top: the pendulum climbs for ever. And from rest at the top, to the rounding of π.
#[test]
fn what_climbs_for_ever_is_refused_at_once() {
    let system = pendulum(1.0);
    let climbing = MotionByQuadrature::new(&system, &[], &[0.0], 2.0);
    assert!(matches!(climbing, Err(NoQuadrature::Asymptotic { .. })), "{climbing:?}");
    let standing = MotionByQuadrature::new(&system, &[], &[std::f64::consts::PI], 0.0);
    assert!(matches!(standing, Err(NoQuadrature::Asymptotic { .. })), "{standing:?}");
}

/// Equations that quadrature cannot answer say why.
#[test]
fn other_equations_are_refused() {
    let coupled = OneSpeed {
        period: None,
        coordinates: 2,
        rates: |q: f64, _: f64, out: &mut [f64]| out[0] = q.sqrt(),
        potential: |_: f64| 0.0,
        slope: |_: f64, _: f64| f64::NAN,
    };
    assert_eq!(MotionByQuadrature::new(&coupled, &[], &[1.0, 0.0], 1.0).unwrap_err(), NoQuadrature::Irregular);
    let system = pendulum(G);
    assert!(matches!(MotionByQuadrature::new(&system, &[], &[1.0, 0.0], 1.0), Err(NoQuadrature::Question(_))));
    assert!(matches!(MotionByQuadrature::new(&system, &[], &[f64::NAN], 1.0), Err(NoQuadrature::Question(_))));
    let jagged = OneSpeed {
        period: None,
        coordinates: 2,
        rates: |q: f64, _: f64, out: &mut [f64]| out[0] = (1e9 * q).sin(),
        potential: |q: f64| 0.5 * q * q,
        slope: |a: f64, b: f64| 0.5 * (a + b),
    };
    let unresolved = MotionByQuadrature::new(&jagged, &[], &[1.0, 0.0], 0.0);
    assert!(matches!(unresolved, Err(NoQuadrature::Unresolved { .. })), "{unresolved:?}");
}

fn run(span: (f64, f64), output: OutputOption, events: &mut [Event<'_>]) -> tripos_sim::Solution {
    let options = Options { output, ..Options::default() };
    run_by_quadrature(&pendulum(G), &[], span, &[3.0, 0.0], &options, events).unwrap()
}

/// Forward and backward: the passages of the lowest point, with the exact times from the period.
#[test]
fn events_are_found_at_their_instants() {
    let period = Pendulum::new(dd(G), dd(3.0), dd(0.0)).period().to_f64();
    for sign in [1.0, -1.0] {
        let lowest = Event::recorded("lowest", Direction::Either, |_, y: &[f64]| y[0]);
        let solution = run((5.0, 5.0 + sign * 3.1 * period), OutputOption::Ends, &mut [lowest]);
        assert_eq!((solution.stop, solution.events.len()), (Stop::End, 6));
        for (k, event) in solution.events.iter().enumerate() {
            let t = 5.0 + sign * period * (0.25 + 0.5 * k as f64);
            assert!((event.t - t).abs() < 1e-13, "{} instead of {t}", event.t);
            assert!(event.y[0].abs() < 1e-13);
            assert_eq!(event.kind, if k % 2 == 0 { Kind::Falling } else { Kind::Rising });
        }
    }
}

#[test]
fn terminal_events_and_domains_end_a_run() {
    let period = Pendulum::new(dd(G), dd(3.0), dd(0.0)).period().to_f64();
    let passing = Event::terminal("passing", Direction::Rising, |_, y: &[f64]| y[0]);
    let above = Event::domain("above", |_, y: &[f64]| y[0] + 2.9);
    let times: Vec<f64> = (0..20).map(|i| 0.5 * f64::from(i)).collect();
    let solution = run((0.0, 20.0), OutputOption::At(times.clone()), &mut [passing]);
    assert_eq!(solution.stop.code(), "event:passing");
    assert!((solution.t_end - 0.75 * period).abs() < 1e-14 && solution.y_end[0].abs() < 1e-13);
    assert_eq!(solution.t, times.iter().copied().filter(|t| *t <= solution.t_end).collect::<Vec<_>>());
    let solution = run((0.0, 20.0), OutputOption::Ends, &mut [above]);
    assert_eq!(solution.stop.code(), "domain:above");
    assert!((solution.y_end[0] + 2.9).abs() < 1e-13);
}

/// Samples at times are the states there, whether anybody watches or not; steps are in order and end at the end.
#[test]
fn output_is_that_of_the_motion() {
    let system = pendulum(G);
    let motion = MotionByQuadrature::new(&system, &[], &[3.0], 0.0).unwrap();
    let times: Vec<f64> = (0..=50).map(|i| 0.4 * f64::from(i)).collect();
    let plain = run((0.0, 20.0), OutputOption::At(times.clone()), &mut []);
    let never = Event::recorded("never", Direction::Either, |_, y: &[f64]| y[0] + 10.0);
    let watched = run((0.0, 20.0), OutputOption::At(times.clone()), &mut [never]);
    for solution in [&plain, &watched] {
        assert_eq!(solution.t, times);
        for (t, y) in solution.t.iter().zip(&solution.y) {
            assert_eq!(*y, motion.state(*t).unwrap());
        }
    }
    let steps = run((20.0, 0.0), OutputOption::Steps { refine: 4 }, &mut []);
    assert!(steps.t.windows(2).all(|t| t[1] < t[0]) && steps.t.last() == Some(&0.0));
    assert_eq!(steps.t.len() as u64, 1 + 4 * steps.steps);
}
