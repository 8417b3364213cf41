//! Equations in all rates: against closed forms of a pendulum in its plane, and the memory that a call requests.

use crate::counted::allocations;
use crate::lent::{integrate, integrate_projected};
use tripos_sim::projection::Invariants;
use tripos_sim::{Failure, Method, Multipliers, Options, OutputOption, RightHandSide, Solution};
use tripos_traits::{Lengths, System};

const G: f64 = 9.81;
const LENGTH: f64 = 2.0;
const MASS: f64 = 3.0;

/// A point mass on a rod, q = (x, y) with y up; its rod is stated twice, in two units. The speed is x'.
struct Pendulum;

impl System<f64> for Pendulum {
    fn lengths(&self) -> Lengths {
        Lengths { parameters: 0, coordinates: 2, variables: 2, speeds: 1, reactions: 2 }
    }
    fn symmetric(&self) -> bool {
        false
    }
    fn coordinate_rates(&self, _p: &[f64], _q: &[f64], v: &[f64], out: &mut [f64]) {
        out.copy_from_slice(v);
    }
    fn mass_matrix(&self, _p: &[f64], q: &[f64], _v: &[f64], out: &mut [f64]) {
        let [x, y] = [q[0], q[1]];
        let rows =
            [[MASS, 0.0, -x, -10.0 * x], [0.0, MASS, -y, -10.0 * y], [x, y, 0.0, 0.0], [10.0 * x, 10.0 * y, 0.0, 0.0]];
        out.copy_from_slice(rows.as_flattened());
    }
    fn forcing(&self, _p: &[f64], _q: &[f64], v: &[f64], out: &mut [f64]) {
        let square = v[0] * v[0] + v[1] * v[1];
        out.copy_from_slice(&[0.0, -MASS * G, -square, -10.0 * square]);
    }
    fn constraint_count(&self) -> usize {
        2
    }
    fn constraints(&self, _p: &[f64], q: &[f64], v: &[f64], out: &mut [f64]) {
        out[0] = 0.5 * (q[0] * q[0] + q[1] * q[1] - LENGTH * LENGTH);
        out[1] = q[0] * v[0] + q[1] * v[1];
    }
    fn constraint_slopes(&self, _p: &[f64], q: &[f64], v: &[f64], out: &mut [f64]) {
        out.copy_from_slice(&[q[0], q[1], 0.0, 0.0, v[0], v[1], q[0], q[1]]);
    }
    fn output_count(&self) -> usize {
        3
    }
    fn outputs(&self, p: &[f64], _t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        self.whole_state(p, q, v, out);
    }
    fn generalized_speeds(&self, _p: &[f64], _q: &[f64], v: &[f64], out: &mut [f64]) {
        out[0] = v[0];
    }
    fn generalized_speed_rates(&self, _p: &[f64], _q: &[f64], _v: &[f64], v_dot: &[f64], out: &mut [f64]) {
        out[0] = v_dot[0];
    }
    fn motion_variables(&self, _p: &[f64], q: &[f64], u: &[f64], out: &mut [f64]) {
        out.copy_from_slice(&[u[0], -q[0] * u[0] / q[1]]);
    }
    fn kinetic_energy(&self, _p: &[f64], _q: &[f64], v: &[f64]) -> f64 {
        0.5 * MASS * (v[0] * v[0] + v[1] * v[1])
    }
    fn potential_energy(&self, _p: &[f64], q: &[f64]) -> f64 {
        MASS * G * q[1]
    }
}

fn pendulum() -> Multipliers<'static> {
    Multipliers::new(&Pendulum, &[], None).unwrap()
}

fn rates(of: &mut Multipliers<'_>, y: [f64; 4]) -> [f64; 4] {
    let mut out = [0.0; 4];
    of.rhs(0.0, &y, &mut out).unwrap();
    out
}

/// On the circle: q̈ = (0, −g) less its part along the rod, and −v²/l along it.
fn exact(angle: f64, rate: f64) -> ([f64; 4], [f64; 4]) {
    let (s, c) = angle.sin_cos();
    let (along, across) = (-LENGTH * rate * rate, -G * s);
    let y = [LENGTH * s, -LENGTH * c, LENGTH * rate * c, LENGTH * rate * s];
    (y, [y[2], y[3], along * s + across * c, -along * c + across * s])
}

/// States off the circle by up to a tenth have the accelerations of its nearest state. That state is on the same radius
/// and has no radial rate. Tolerance: 1e-14 of numbers of order 10.
#[test]
fn accelerations_are_those_of_the_nearest_state_on_the_constraints() {
    let mut of = pendulum();
    for (angle, rate, off) in [(0.3, 1.5, 0.0), (0.3, 1.5, 1e-6), (1.2, -0.7, 1e-3), (-2.5, 2.0, 0.1)] {
        let (y, truth) = exact(angle, rate);
        let radial = [y[0] / LENGTH, y[1] / LENGTH];
        let moved = [y[0] + off * radial[0], y[1] + off * radial[1], y[2] - off * radial[0], y[3] - off * radial[1]];
        let found = rates(&mut of, moved);
        let error = found.iter().zip(&truth).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(error < 1e-13, "{angle} {off}: {found:?} {truth:?}");
    }
}

/// x' tells the motion as well as the rod leaves of it along x: cos φ.
#[test]
fn a_choice_of_speeds_stands_by_what_the_constraints_leave_of_it() {
    let mut of = pendulum();
    for angle in [0.0, 0.4, 1.5, 2.0] {
        let standing = of.distances_from_singularity(&exact(angle, 1.0).0).unwrap();
        assert!((standing.speeds - f64::cos(angle).abs()).abs() < 1e-14, "{angle}: {standing:?}");
        // One of the two rows follows from the other, everywhere.
        assert!(standing.constraints < 1e-8, "{standing:?}");
    }
}

fn run(span: f64) -> Solution {
    let options = Options { method: Method::Dop853, output: OutputOption::Ends, ..Options::tolerances(1e-9, 1e-9) };
    integrate(pendulum(), (0.0, span), &exact(1.0, 0.0).0, &options, &mut []).unwrap()
}

/// Goal: the space of a run on constraints is made once. Method: a run of ten times the steps asks for memory as often.
#[test]
fn a_run_on_constraints_asks_for_memory_at_its_start_alone() {
    let ((few, short), (many, long)) = (allocations(|| run(2.0)), allocations(|| run(20.0)));
    assert!(long.steps > 5 * short.steps && long.projection.is_some_and(|report| report.corrections > 50));
    assert_eq!(few, many);
    // The last stage of a step is followed by the derivative at the state that was moved, and no other.
    assert!(long.evaluations <= 12 * (long.steps + long.rejected) + 3, "{} in {} steps", long.evaluations, long.steps);
    let mut of = pendulum();
    let y = exact(1.0, 1.0).0.map(|x| x + 1e-4);
    rates(&mut of, y);
    of.distances_from_singularity(&y);
    assert_eq!(allocations(|| (rates(&mut of, y), of.distances_from_singularity(&y))).0, 0);
}

/// A run on an invariant requests memory at its start alone.
#[test]
fn a_run_on_an_invariant_asks_for_memory_at_its_start_alone() {
    let oscillator = |_t: f64, y: &[f64], out: &mut [f64]| -> Result<(), Failure> {
        out.copy_from_slice(&[y[1], -y[0]]);
        Ok(())
    };
    let run = |span: f64| {
        let function = |_t: f64, y: &[f64], values: &mut [f64], gradients: &mut [f64]| {
            values[0] = 0.5 * (y[0] * y[0] + y[1] * y[1]);
            gradients.copy_from_slice(y);
        };
        let mut invariants = Invariants { count: 1, function: Box::new(function) };
        let options = Options { method: Method::Ode45, output: OutputOption::Ends, ..Options::tolerances(1e-8, 1e-8) };
        integrate_projected(oscillator, (0.0, span), &[1.0, 0.0], &options, &mut [], &mut invariants).unwrap()
    };
    let ((few, short), (many, long)) = (allocations(|| run(2.0)), allocations(|| run(20.0)));
    assert!(long.steps > 5 * short.steps && long.projection.is_some_and(|report| report.corrections > 50));
    assert_eq!(few, many);
}
