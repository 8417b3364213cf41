//! Compiled equations against motions known in closed form, in 32 digits: no integrator stands between.
//!
//! At an instant the exact motion gives q and u, so the state of each formulation, and by central differences of order
//! 8 with steps of 1e-5 s its rate; this must be the derivative that the formulation computes. 1e-19 is the error of
//! the differences, mostly the rounding of angles of up to 300 rad divided by the step.

use crate::support;

use support::exact::{CLOSED_FORMS, Motion, exact, motion, start_of};
use support::stability::{Equations, Start, options, rounded, wide};
use support::{Random, compiled};
use tripos_sim::{Dynamics, Method};
use tripos_traits::{DoubleDouble, Real, Scalar};

type Dd = DoubleDouble;

const TOLERANCE: f64 = 1e-19;
const INSTANTS: [&str; 5] = ["-1.3", "0.05", "0.31", "0.9", "4.7"];

fn derivatives(f: impl Fn(Dd) -> Vec<Dd>, t: Dd) -> Vec<Dd> {
    let h = wide("1e-5");
    let weights = [(1, Dd::ratio(4, 5)), (2, Dd::ratio(-1, 5)), (3, Dd::ratio(4, 105)), (4, Dd::ratio(-1, 280))];
    let mut sums = vec![Dd::int(0); f(t).len()];
    for (k, weight) in weights {
        let step = h * Dd::int(k);
        for (sum, (after, before)) in sums.iter_mut().zip(f(t + step).into_iter().zip(f(t - step))) {
            *sum = *sum + weight * (after - before) / h;
        }
    }
    sums
}

/// Names of the derived systems of a model, those in a distance among them.
fn derived(model: &str) -> Vec<&'static str> {
    let model = tripos_models::MODELS.iter().find(|m| m.name == model).unwrap();
    model.systems.iter().map(|s| s.name).filter(|name| !name.starts_with("printed:")).collect()
}

/// d/dt of (q, v) at a state of a compiled system.
fn derivative(model: &str, name: &str, p: &[Dd], y: &[Dd]) -> Vec<Dd> {
    let system = compiled(model, name).extended;
    let (q, v) = y.split_at(system.lengths().coordinates);
    let mut rates = vec![Dd::int(0); y.len()];
    let (q_dot, v_dot) = rates.split_at_mut(q.len());
    system.derivative(p, q, v, q_dot, v_dot);
    rates
}

/// The exact motion from `start` is one of every formulation.
fn assert_motion(model: &str, start: &Start) {
    let exact = motion(model, start).unwrap_or_else(|| panic!("{model}: no closed form"));
    for name in derived(model) {
        let equations = Equations::new(model, name);
        let state = |t: Dd| {
            let (q, u) = split(&exact, start.q.len(), t);
            equations.state(&Start { p: start.p.clone(), q, u })
        };
        for t in INSTANTS.map(wide) {
            let found = derivative(model, name, &start.p, &state(t));
            for (i, (found, wanted)) in found.into_iter().zip(derivatives(state, t)).enumerate() {
                let off = (found - wanted).to_f64().abs();
                // Written so that what is not a number fails.
                assert!(off < TOLERANCE, "{model} {name}: rate {i} at t = {t:.3} is off by {off:e}");
            }
        }
    }
}

fn split(motion: &Motion, coordinates: usize, t: Dd) -> (Vec<Dd>, Vec<Dd>) {
    let mut q = motion(t);
    let u = q.split_off(coordinates);
    (q, u)
}

#[test]
fn every_exact_scene_moves_by_the_equations_of_every_formulation() {
    for (model, scene) in CLOSED_FORMS {
        let start = start_of(model, scene);
        let at_start = motion(model, &start).unwrap()(Dd::int(0));
        for (found, stated) in at_start.into_iter().zip([start.q.clone(), start.u.clone()].concat()) {
            // 32 digits, and half of them where a rate comes out of an energy that is zero.
            assert!((found - stated).to_f64().abs() < 1e-15, "{model} {scene}: starts at {found}, not {stated}");
        }
        assert_motion(model, &start);
    }
}

#[test]
fn pendulum_moves_by_elliptic_functions() {
    for (theta, omega) in [("3", "0"), ("2", "-1"), ("0", "9")] {
        assert_motion("pendulum", &Start::new(&["1.7", "0.6", "9.81"], &[theta], &[omega]));
    }
}

#[test]
fn spherical_pendulum_moves_by_elliptic_functions() {
    for (q, u) in [(["1", "0.3"], ["2", "-1.5"]), (["3", "-7"], ["0.1", "0.05"]), (["0.2", "0"], ["0", "6"])] {
        assert_motion("spherical_pendulum", &Start::new(&["1.7", "0.6", "9.81"], &q, &u));
    }
}

#[test]
fn heavy_top_moves_by_elliptic_functions_in_both_kinds_of_angles() {
    let p = ["1.3", "0.22", "0.095", "0.021", "9.81"];
    for [nutation, nutation_rate, across, spin] in
        [["0.9", "0.3", "-1.175", "55"], ["0.3", "0", "0", "60"], ["0.01", "0.02", "0", "44"]]
    {
        assert_motion("heavy_top", &Start::new(&p, &[nutation, "0", "0"], &[nutation_rate, across, spin]));
        assert_motion("euler_top", &Start::new(&p, &["0", nutation, "0"], &[nutation_rate, across, spin]));
    }
    // Angles of other quadrants, and a top that hangs.
    assert_motion("heavy_top", &Start::new(&p, &["-0.3", "0.4", "7"], &["0.3", "0.1", "50"]));
    assert_motion("euler_top", &Start::new(&p, &["-4", "2.5", "7"], &["0.3", "0.7", "-3"]));
}

#[test]
fn free_body_moves_by_two_uniform_rotations() {
    let (q, v) = (["1", "2", "-3"], ["0.1", "-0.3", "0.2"]);
    for (p, angles, w) in [
        (["2", "0.3", "0.5"], ["0.4", "1.1", "-0.3"], ["-1.3", "3", "0.1"]),
        (["1", "0.3", "0.1"], ["-4", "2.6", "8"], ["0.2", "0.5", "-2.1"]),
        (["1", "0.4", "0.4"], ["0", "1.5", "0"], ["2", "0", "0.5"]),
    ] {
        assert_motion("free_body", &Start::new(&p, &[q, angles].concat(), &[v, w].concat()));
    }
}

/// Linear and angular momentum of the chain about the origin and m times its mass centre, from (q, u): each rod by its
/// middle.
fn momenta(p: &[Dd], y: &[Dd]) -> [Dd; 5] {
    let [m, l] = [p[0], p[1]];
    let (half, mut out) = (l / Dd::int(2), [Dd::int(0); 5]);
    let (mut place, mut velocity) = ([y[0], y[1]], [y[5], y[6]]);
    for rod in 0..3 {
        let (spin, (sin, cos)) = (y[7 + rod], y[2 + rod].sin_cos());
        let arm = [half * cos, half * sin];
        // From the end of the rod before to the middle, and from there to the next end.
        let advance = |place: &mut [Dd; 2], velocity: &mut [Dd; 2]| {
            *place = [place[0] + arm[0], place[1] + arm[1]];
            *velocity = [velocity[0] - spin * arm[1], velocity[1] + spin * arm[0]];
        };
        if rod > 0 {
            advance(&mut place, &mut velocity);
        }
        let turn = place[0] * velocity[1] - place[1] * velocity[0] + spin * l * l / Dd::int(12);
        let terms = [velocity[0], velocity[1], turn, place[0], place[1]];
        out = std::array::from_fn(|k| out[k] + m * terms[k]);
        advance(&mut place, &mut velocity);
    }
    out
}

/// Goal: both momenta are constant, and the first is the rate of the mass centre, at states without a pattern. Method:
/// their difference along the derivative, in 32 digits with h = 1e-10: h² times the third derivative, of 1e3 at most.
#[test]
fn floating_chain_keeps_its_momenta_in_every_formulation() {
    let mut random = Random(17);
    let mut between = |low, high| Dd::from_f64(random.between(low, high));
    for _ in 0..50 {
        let p = [between(0.5, 2.0), between(0.5, 2.0)];
        let y: Vec<Dd> = (0..10).map(|_| between(-3.0, 3.0)).collect();
        for name in derived("floating_chain") {
            // The speeds are the rates, so (q, v) is (q, u) for all.
            let rates = derivative("floating_chain", name, &p, &y);
            let h = wide("1e-10");
            let at = |h: Dd| momenta(&p, &y.iter().zip(&rates).map(|(y, rate)| *y + h * *rate).collect::<Vec<_>>());
            let (after, before, now) = (at(h), at(-h), momenta(&p, &y));
            let slope: [Dd; 5] = std::array::from_fn(|k| (after[k] - before[k]) / (h + h));
            for (k, wanted) in [Dd::int(0), Dd::int(0), Dd::int(0), now[0], now[1]].into_iter().enumerate() {
                let off = (slope[k] - wanted).to_f64().abs();
                assert!(off < 1e-16, "{name}: momentum {k} changes, or its centre does not move by it: {off:e}");
            }
        }
    }
}

/// Goal: the scenes as they are run. Method: DOP853 in doubles at 1e-12 to the end of each scene by every formulation.
/// 1e-10: what the errors of some hundred steps at the tolerance add up to.
#[test]
fn runs_of_exact_scenes_arrive_where_they_should() {
    for (model, scene) in CLOSED_FORMS {
        let start = start_of(model, scene);
        let (_, read) = support::exact::read(model, scene);
        let end = read.span.1;
        let wanted: Vec<Dd> = exact(model, scene, end).unwrap().iter().map(|(_, x)| Dd::from_f64(*x)).collect();
        for name in derived(model) {
            let equations = Equations::new(model, name);
            let run = equations.run(&start, end, &options(Method::Dop853, 1e-12), &mut []);
            let error = equations.error(&start, &run, &wanted);
            assert!(error < 1e-10, "{model} {scene} {name}: {error:e}");
        }
    }
}

/// The axis from Cardan's and from Euler's angles.
fn axes(cardan: &[f64], euler: &[f64]) -> [[f64; 3]; 2] {
    let ((sin_1, cos_1), (sin_2, cos_2)) = (cardan[0].sin_cos(), cardan[1].sin_cos());
    let ((sin_psi, cos_psi), (sin, cos)) = (euler[0].sin_cos(), euler[1].sin_cos());
    [[sin_2, -sin_1 * cos_2, cos_1 * cos_2], [sin * sin_psi, -sin * cos_psi, cos]]
}

/// Goal: one top in two kinds of angles. Method: both models integrated from their own scene, without a closed form, in
/// 32 digits at 1e-17; 1e-14 is the rounding of the doubles that are compared.
#[test]
fn both_models_of_the_top_have_one_axis() {
    let (cardan, euler) = (start_of("heavy_top", "looping"), start_of("euler_top", "looping"));
    assert_eq!(rounded(&cardan.p), rounded(&euler.p));
    for t in [0.1, 0.5, 1.3, 2.0] {
        let [cardan, euler] = [("heavy_top", &cardan), ("euler_top", &euler)]
            .map(|(model, start)| rounded(&Equations::new(model, "kane").reference(start, t, 1e-17)));
        let [a, b] = axes(&cardan, &euler);
        assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-14), "t = {t}: {a:?} {b:?}");
    }
}

/// Table: the top's nutation period and angles, the pendulum's, from elliptic functions at 40 digits; angles to 12
/// digits.
#[test]
fn runs_pass_through_the_tabulated_states() {
    for (model, theta, azimuth, period, table) in [
        ("euler_top", 1, 0, 0.563_589_275_653_065, [(1.0, 0.426_999_640_879_573_3, 2.729_741_355_739_625)]),
        ("spherical_pendulum", 0, 1, 1.091_526_051_511_753_5, [(5.0, 0.939_534_394_510_107_7, 16.558_783_808_780_895)]),
    ] {
        let scene = if model == "euler_top" { "looping" } else { "wide" };
        let start = start_of(model, scene);
        let equations = Equations::new(model, "newton-euler");
        let after = equations.reference(&start, period, 1e-15);
        let off = (after[theta] - start.q[theta]).to_f64().abs();
        assert!(off < 1e-13, "{model}: θ is off by {off:e} after a period");
        for (t, cosine, angle) in table {
            let state = equations.reference(&start, t, 1e-15);
            assert!((state[theta].sin_cos().1.to_f64() - cosine).abs() < 1e-12, "{model}: cos θ at {t}");
            assert!((state[azimuth].to_f64() - angle).abs() < 1e-11, "{model}: precession at {t}");
        }
    }
}

/// Goal: Newton–Euler's reactions. Method: the exact pull of the rod, m(g cos θ + l(u1² + u2²)), and of the pins of a
/// straight chain that turns: the mass beyond a pin times the distance of its centre times ω², inward. 1e-13 of forces
/// of 10 N.
#[test]
fn reactions_are_those_of_the_exact_motions() {
    let at = |model: &str, scene: &str, t: f64| {
        let start = start_of(model, scene);
        let state: Vec<f64> = exact(model, scene, t).unwrap().iter().map(|(_, x)| *x).collect();
        let (q, u) = state.split_at(start.q.len());
        let p = rounded(&start.p);
        let mut dynamics = Dynamics::new(compiled(model, "newton-euler").double, &p).unwrap();
        let found = dynamics.unknowns(q, u).unwrap()[u.len()..].to_vec();
        (p, state, found)
    };
    for t in [0.0, 0.4, 1.7, 4.9] {
        let (p, y, found) = at("spherical_pendulum", "wide", t);
        let pull = p[0] * (p[2] * y[0].cos() + p[1] * (y[2] * y[2] + y[3] * y[3]));
        assert!((found[0] - pull).abs() < 1e-13 * pull.abs().max(10.0), "pull at {t}: {found:?}, not {pull}");
        let (p, y, found) = at("floating_chain", "straight", t);
        let (sin, cos) = y[2].sin_cos();
        // Two rods beyond the first pin, their centre half a rod from the middle; one beyond the second, a rod from it.
        let inward = p[0] * p[1] * y[7] * y[7];
        for (force, wanted) in found.iter().zip([-inward * cos, -inward * sin, -inward * cos, -inward * sin]) {
            assert!((force - wanted).abs() < 1e-13 * 10.0, "pins at {t}: {found:?}");
        }
    }
}

#[test]
fn what_has_no_closed_form_is_said_to_have_none() {
    assert!(exact("floating_chain", "folding", 1.0).is_none());
    assert!(exact("disk", "report", 1.0).is_none());
    assert!(exact("heavy_top", "sleeping", 1.0).is_none());
    let named = exact("free_body", "steady", 0.0).unwrap();
    assert_eq!(named[4], ("theta".to_owned(), 0.6));
}
