//! Equations of motion through `Dynamics`: hand-written systems with exact answers.
#![allow(clippy::float_cmp, reason = "exact answers are compared exactly")]

use crate::lent::integrate;
use tripos_sim::{Direction, Dynamics, Event, Options, RightHandSide, SimError};
use tripos_traits::{Lengths, System};

/// Functions of a small system whose speeds are the coordinate rates.
trait Small {
    const COORDINATES: usize;
    const REACTIONS: usize;
    const SYMMETRIC: bool;
    const PARAMETERS: usize;
    fn matrix(p: &[f64], q: &[f64], out: &mut [f64]);
    fn forcing(p: &[f64], q: &[f64], v: &[f64], out: &mut [f64]);
    fn kinetic(p: &[f64], q: &[f64], v: &[f64]) -> f64;
    fn potential(p: &[f64], q: &[f64]) -> f64;
}

struct SmallSystem<S>(S);

impl<S: Small> System<f64> for SmallSystem<S> {
    fn lengths(&self) -> Lengths {
        let n = S::COORDINATES;
        Lengths { parameters: S::PARAMETERS, coordinates: n, variables: n, speeds: n, reactions: S::REACTIONS }
    }
    fn symmetric(&self) -> bool {
        S::SYMMETRIC
    }
    fn coordinate_rates(&self, _p: &[f64], _q: &[f64], v: &[f64], out: &mut [f64]) {
        out.copy_from_slice(v);
    }
    fn mass_matrix(&self, p: &[f64], q: &[f64], _v: &[f64], out: &mut [f64]) {
        S::matrix(p, q, out);
    }
    fn forcing(&self, p: &[f64], q: &[f64], v: &[f64], out: &mut [f64]) {
        S::forcing(p, q, v, out);
    }
    fn output_count(&self) -> usize {
        2 * S::COORDINATES
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
    fn kinetic_energy(&self, p: &[f64], q: &[f64], v: &[f64]) -> f64 {
        S::kinetic(p, q, v)
    }
    fn potential_energy(&self, p: &[f64], q: &[f64]) -> f64 {
        S::potential(p, q)
    }
}

/// A point mass m on a massless rod of length l, parameters [m, l, g]; q from the downward
/// vertical.
struct Pendulum;

impl Small for Pendulum {
    const COORDINATES: usize = 1;
    const REACTIONS: usize = 0;
    const SYMMETRIC: bool = true;
    const PARAMETERS: usize = 3;
    fn matrix(p: &[f64], _q: &[f64], out: &mut [f64]) {
        out[0] = p[0] * p[1] * p[1];
    }
    fn forcing(p: &[f64], q: &[f64], _v: &[f64], out: &mut [f64]) {
        out[0] = -p[0] * p[2] * p[1] * q[0].sin();
    }
    fn kinetic(p: &[f64], _q: &[f64], v: &[f64]) -> f64 {
        0.5 * p[0] * (p[1] * v[0]).powi(2)
    }
    fn potential(p: &[f64], q: &[f64]) -> f64 {
        -p[0] * p[2] * p[1] * q[0].cos()
    }
}

/// The same pendulum with the tension S of the rod as an unknown, by Newton's law along x
/// (sideways) and y (up): m l (cos q q̈ − sin q q̇²) = −S sin q,  m l (sin q q̈ + cos q q̇²) = S
/// cos q − m g.
struct PendulumWithTension;

impl Small for PendulumWithTension {
    const COORDINATES: usize = 1;
    const REACTIONS: usize = 1;
    const SYMMETRIC: bool = false;
    const PARAMETERS: usize = 3;
    fn matrix(p: &[f64], q: &[f64], out: &mut [f64]) {
        let (ml, (s, c)) = (p[0] * p[1], q[0].sin_cos());
        out.copy_from_slice(&[ml * c, s, ml * s, -c]);
    }
    fn forcing(p: &[f64], q: &[f64], v: &[f64], out: &mut [f64]) {
        let (ml, (s, c)) = (p[0] * p[1], q[0].sin_cos());
        out[0] = ml * s * v[0] * v[0];
        out[1] = -ml * c * v[0] * v[0] - p[0] * p[2];
    }
    fn kinetic(p: &[f64], q: &[f64], v: &[f64]) -> f64 {
        Pendulum::kinetic(p, q, v)
    }
    fn potential(p: &[f64], q: &[f64]) -> f64 {
        Pendulum::potential(p, q)
    }
}

/// Two equal point masses on equal massless rods, both angles from the vertical; [m, l, g].
struct DoublePendulum;

impl Small for DoublePendulum {
    const COORDINATES: usize = 2;
    const REACTIONS: usize = 0;
    const SYMMETRIC: bool = true;
    const PARAMETERS: usize = 3;
    fn matrix(p: &[f64], q: &[f64], out: &mut [f64]) {
        let (ml2, c) = (p[0] * p[1] * p[1], (q[0] - q[1]).cos());
        out.copy_from_slice(&[2.0 * ml2, ml2 * c, ml2 * c, ml2]);
    }
    fn forcing(p: &[f64], q: &[f64], v: &[f64], out: &mut [f64]) {
        let (ml2, mgl, s) = (p[0] * p[1] * p[1], p[0] * p[2] * p[1], (q[0] - q[1]).sin());
        out[0] = -ml2 * s * v[1] * v[1] - 2.0 * mgl * q[0].sin();
        out[1] = ml2 * s * v[0] * v[0] - mgl * q[1].sin();
    }
    fn kinetic(p: &[f64], q: &[f64], v: &[f64]) -> f64 {
        let c = (q[0] - q[1]).cos();
        p[0] * p[1] * p[1] * (v[0] * v[0] + 0.5 * v[1] * v[1] + c * v[0] * v[1])
    }
    fn potential(p: &[f64], q: &[f64]) -> f64 {
        -p[0] * p[2] * p[1] * (2.0 * q[0].cos() + q[1].cos())
    }
}

/// [m, l, g].
const PARAMETERS: [f64; 3] = [2.0, 1.0, 9.81];

fn tight(rtol: f64) -> Options {
    Options::tolerances(rtol, rtol)
}

/// The time from rest at `amplitude` to rest at the other side and back, by a terminal event.
fn period(system: &dyn System<f64>, amplitude: f64) -> f64 {
    let mut dynamics = Dynamics::new(system, &PARAMETERS).unwrap();
    let back = Event::terminal("back", Direction::Falling, |_t, y: &[f64]| y[1]);
    let rhs = |t: f64, y: &[f64], dydt: &mut [f64]| dynamics.rhs(t, y, dydt);
    let y0 = [amplitude, 0.0];
    let solution = integrate(rhs, (0.0, 20.0), &y0, &tight(1e-12), &mut [back]).unwrap();
    assert_eq!(solution.stop.code(), "event:back");
    solution.t_end
}

/// 4 √(l/g) K(sin(amplitude / 2)) by the complete elliptic integral. Tolerance: 1e-12 a step over
/// some thousand steps, divided by the acceleration near the turn (1.4 at 3 rad).
#[test]
fn a_pendulum_keeps_its_exact_period() {
    for (amplitude, exact) in [(1.0, 2.139_137_600_558_689), (3.0, 5.158_066_754_267_866)] {
        for system in [&SmallSystem(Pendulum) as &dyn System<f64>, &SmallSystem(PendulumWithTension)] {
            let found = period(system, amplitude);
            assert!((found - exact).abs() < 1e-9, "{amplitude}: {found}");
        }
    }
}

/// S = m (g cos q + l q̇²), whatever the state: a system that is not symmetric, with a reaction.
#[test]
fn the_tension_comes_out_beside_the_acceleration() {
    let mut dynamics = Dynamics::new(&SmallSystem(PendulumWithTension), &PARAMETERS).unwrap();
    let [m, l, g] = PARAMETERS;
    for (q, v) in [(0.0, 0.0), (0.3, -2.0), (2.0, 1.0), (-3.0, 0.5)] {
        let x = dynamics.unknowns(&[q], &[v]).unwrap().to_vec();
        // 8 ε of the largest term, 2 · 9.81 + 2 · 4: an orthogonal matrix of order 2.
        let tolerance = 8.0 * f64::EPSILON * 28.0;
        assert!((x[0] + g / l * f64::sin(q)).abs() < tolerance, "{q} {v}: {x:?}");
        let tension = m * (g * f64::cos(q) + l * v * v);
        assert!((x[1] - tension).abs() < tolerance, "{q} {v}: {x:?}");
    }
}

/// The chaotic double pendulum conserves T + V. A relative tolerance of 1e-10 over some 1 000
/// steps.
#[test]
fn a_double_pendulum_conserves_energy() {
    let mut dynamics = Dynamics::new(&SmallSystem(DoublePendulum), &PARAMETERS).unwrap();
    let y0 = dynamics.state(&[2.0, 2.5], &[0.0, 0.0]).unwrap();
    let rhs = |t: f64, y: &[f64], dydt: &mut [f64]| dynamics.rhs(t, y, dydt);
    let solution = integrate(rhs, (0.0, 10.0), &y0, &tight(1e-10), &mut []).unwrap();
    let drift = dynamics.energy_drift(&solution);
    assert!(drift > 0.0 && drift < 1e-6, "{drift}");
    let loose = |t: f64, y: &[f64], dydt: &mut [f64]| dynamics.rhs(t, y, dydt);
    let solution = integrate(loose, (0.0, 10.0), &y0, &tight(1e-4), &mut []).unwrap();
    assert!(dynamics.energy_drift(&solution) > 1e3 * drift);
}

/// Small oscillations have the frequencies ω² = (2 ± √2) g/l; the slow mode keeps q2 = √2 q1.
#[test]
fn a_double_pendulum_swings_in_its_slow_mode() {
    let mut dynamics = Dynamics::new(&SmallSystem(DoublePendulum), &PARAMETERS).unwrap();
    let amplitude = 1e-5;
    let y0 = [amplitude, amplitude * 2_f64.sqrt(), 0.0, 0.0];
    let rhs = |t: f64, y: &[f64], dydt: &mut [f64]| dynamics.rhs(t, y, dydt);
    let options = Options { atol: 1e-16.into(), ..tight(1e-10) };
    let solution = integrate(rhs, (0.0, 3.0), &y0, &options, &mut []).unwrap();
    let omega = ((2.0 - 2_f64.sqrt()) * 9.81).sqrt();
    // The neglected terms are of the order of amplitude².
    let exact = amplitude * (3.0 * omega).cos();
    assert!((solution.y_end[0] - exact).abs() < 1e-8 * amplitude, "{}", solution.y_end[0]);
    assert!((solution.y_end[1] / solution.y_end[0] - 2_f64.sqrt()).abs() < 1e-6);
}

#[test]
fn a_singular_matrix_is_named() {
    let mut dynamics =
        Dynamics::new(&SmallSystem(DoublePendulum), &[0.0, 1.0, 9.81]).unwrap().with_label("double pendulum, kane");
    let failure = dynamics.unknowns(&[0.1, 0.2], &[0.0, 0.0]).unwrap_err();
    assert_eq!(failure.code, "singular");
    assert_eq!(failure.message, "double pendulum, kane: mass matrix of order 2 is singular");
    let failure = dynamics.unknowns(&[f64::NAN, 0.2], &[0.0, 0.0]).unwrap_err();
    assert_eq!(failure.code, "not-finite");
    assert_eq!(failure.message, "double pendulum, kane: entry 1, 2 of the mass matrix of order 2 is not finite");
    let failure = dynamics.unknowns(&[0.1, 0.2], &[0.0, f64::INFINITY]).unwrap_err();
    assert_eq!(failure.code, "not-finite");
    assert_eq!(failure.message, "double pendulum, kane: entry 1 of 2 of the forcing is not finite");
    assert_eq!(dynamics.reciprocal_condition(&[0.1, 0.2], &[0.0, 0.0]), 0.0);

    let rhs = |t: f64, y: &[f64], dydt: &mut [f64]| dynamics.rhs(t, y, dydt);
    let solution = integrate(rhs, (0.0, 1.0), &[0.0; 4], &Options::default(), &mut []).unwrap();
    assert_eq!((solution.stop.code().as_str(), solution.steps), ("singular", 0));
}

#[test]
fn the_condition_of_a_mass_matrix_is_at_hand() {
    let mut dynamics = Dynamics::new(&SmallSystem(DoublePendulum), &PARAMETERS).unwrap();
    // Perpendicular rods: diagonal, so perfect once scaled. Aligned rods: [[1, 1/2], [1, 1]] scaled
    // by rows and columns, ‖A‖ = 2, A⁻¹ = [[2, −1], [−2, 2]], ‖A⁻¹‖ = 4.
    let perpendicular = [std::f64::consts::FRAC_PI_2, 0.0];
    assert!((dynamics.reciprocal_condition(&perpendicular, &[0.0; 2]) - 1.0).abs() < 1e-12);
    assert!((dynamics.reciprocal_condition(&[0.0; 2], &[0.0; 2]) - 0.125).abs() < 1e-15);
}

#[test]
fn lengths_and_parameters_are_checked() {
    let few = Dynamics::new(&SmallSystem(Pendulum), &[1.0]).err();
    assert_eq!(few, Some(SimError::Length { what: "parameters", expected: 3, found: 1 }));
    let nan = Dynamics::new(&SmallSystem(Pendulum), &[1.0, f64::NAN, 1.0]).err();
    assert_eq!(nan, Some(SimError::NotFinite { what: "parameter 1".into() }));
    let mut dynamics = Dynamics::new(&SmallSystem(Pendulum), &PARAMETERS).unwrap();
    assert!(dynamics.state(&[0.0], &[]).is_err());
    assert_eq!(dynamics.unknowns(&[], &[0.0]).unwrap_err().code, "length");
    assert_eq!(dynamics.rhs(0.0, &[0.0; 3], &mut [0.0; 3]).unwrap_err().code, "length");
    assert!(dynamics.energy(&[0.0], &[]).is_nan());
}
