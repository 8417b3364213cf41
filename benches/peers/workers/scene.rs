//! The disk by the equations of its scenes: a worker of `benches/peers/run.py`, which documents the lines it reads and answers.
//!
//! `scene SCENE METHOD` runs `report-10s`, whose ten outputs it answers as q and q̇, or `lean`, whose two are q2 and u1. A method is
//! one of [`METHODS`], by stepping, with `-energy` behind its name if the energy is to be kept after each step, or
//! [`QUADRATURE`], for which no tolerance matters.
//!
//! A run is all that follows from the scene's start: the constants of the motion, which are taken from it in twice the precision of
//! a double, as `tripos simulate` does; the motion, in doubles; and the outputs at its end.

mod disk;

use std::hint::black_box;
use std::process::ExitCode;
use std::time::Instant;

use disk::{Known, N, SPAN, numbers, options, question, serve};
use tripos::disk::kane;
use tripos::disk::lagrange::Lagrange;
use tripos::disk::scenes::{lean, report_10s};
use tripos_sim::projection::Invariants;
use tripos_sim::{Lent, Method, Solution, Stop, integrate, integrate_projected, quadrature};
use tripos_traits::{DoubleDouble, Real, Scalar, System};

/// The methods that step.
const METHODS: &[Method] = &[Method::Dop853, Method::Taylor];
/// The end of a method's name if the energy is kept.
const PROJECTED: &str = "-energy";
/// The motion as integrals.
const QUADRATURE: &str = "quadrature";

/// The motion from its start.
#[derive(Clone, Copy)]
enum How {
    Steps(Method),
    Projected(Method),
    Quadrature,
}

impl How {
    fn named(name: &str) -> Option<Self> {
        let method = |name| METHODS.iter().copied().find(|method| method.name() == name);
        match name.strip_suffix(PROJECTED) {
            Some(name) => method(name).map(Self::Projected),
            None if name == QUADRATURE => Some(Self::Quadrature),
            None => method(name).map(Self::Steps),
        }
    }
}

/// Parameters of a scene's equations and their state, from the ten numbers of the start, q and q̇.
type Beginning = fn(&[DoubleDouble]) -> (Vec<f64>, Vec<f64>);

/// q and u of the model from q and q̇: M and R are 1.
fn speeds(start: &[DoubleDouble]) -> [DoubleDouble; N] {
    let one = DoubleDouble::int(1);
    let mut u = [one; N];
    let (q, q_dot) = start.split_at(N);
    System::<DoubleDouble>::generalized_speeds(&Lagrange, &[one, one, DoubleDouble::decimal("9.81")], q, q_dot, &mut u);
    u
}

fn doubles<const L: usize>(list: [DoubleDouble; L]) -> Vec<f64> {
    list.iter().map(|x| x.to_f64()).collect()
}

/// As the header of `report_10s` states them.
fn ten(start: &[DoubleDouble]) -> (Vec<f64>, Vec<f64>) {
    let [u1, u2, u3, u4, u5] = speeds(start);
    let [q1, q2, q3, q4, q5] = [0, 1, 2, 3, 4].map(|i| start[i]);
    let ((s1, c1), (s2, c2)) = (q1.sin_cos(), q2.sin_cos());
    let [one, half] = [1, 2].map(|n| DoubleDouble::ratio(1, n));
    let tilt = u2 * s2 / c2;
    let p_q3 = half * u3;
    let p_q4 = u1 * s1 * c2 - c1 * tilt + u4;
    let p_q5 = u5 - u1 * c1 * c2 - s1 * tilt;
    let h_a3_there = half * (half * u2 * c2 + u3 * (s2 - one));
    let constants = doubles([p_q3, p_q4, p_q5, h_a3_there, q4 - s1 * s2, q5 + c1 * s2]);
    (constants, doubles([q2 - half * DoubleDouble::pi(), q3, q1, u1]))
}

/// As the header of `lean` states them.
fn two(start: &[DoubleDouble]) -> (Vec<f64>, Vec<f64>) {
    let [u1, u2, u3, ..] = speeds(start);
    let (s2, c2) = start[1].sin_cos();
    let [one, half] = [1, 2].map(|n| DoubleDouble::ratio(1, n));
    let h_a3_there = half * (half * u2 * c2 + u3 * (s2 - one));
    (doubles([half * u3, h_a3_there]), doubles([start[1] - half * DoubleDouble::pi(), u1]))
}

/// What answers lines.
struct Worker<E> {
    rhs: Known<E>,
    beginning: Beginning,
    how: How,
}

impl<E: System<f64> + Copy> Worker<E> {
    /// One run, and its outputs.
    fn once(&mut self, start: &[DoubleDouble], tolerance: f64) -> Option<(Solution, Vec<f64>)> {
        let (parameters, y0) = (self.beginning)(start);
        let (equations, n, span) = (self.rhs.equations, self.rhs.equations.coordinates(), (0.0, SPAN));
        self.rhs.parameters.clone_from(&parameters);
        let with = |method| options(method, tolerance);
        let solution = match self.how {
            How::Steps(method) => integrate(Lent(&mut self.rhs), span, &y0, &with(method), &mut []).ok()?,
            How::Projected(method) => {
                let energy = |_: f64, y: &[f64], values: &mut [f64], gradient: &mut [f64]| {
                    values[0] = equations.energy_gradient(&parameters, &y[..n], &y[n..], gradient);
                };
                let mut energy = Invariants { count: 1, function: Box::new(energy) };
                integrate_projected(Lent(&mut self.rhs), span, &y0, &with(method), &mut [], &mut energy).ok()?
            }
            How::Quadrature => {
                quadrature::solve(&equations, &parameters, span, &y0, &with(Method::Dop853), &mut []).ok()?
            }
        };
        let mut outputs = vec![0.0; equations.output_count()];
        let (q, v) = solution.y_end.split_at(n);
        equations.outputs(&parameters, SPAN, q, v, &mut outputs);
        (solution.stop == Stop::End).then_some((solution, outputs))
    }

    fn run(&mut self, tolerance: f64, repeats: u32) -> Option<Vec<f64>> {
        let (_, start) = question::<DoubleDouble>();
        let mut last = None;
        let begin = Instant::now();
        for _ in 0..repeats {
            last = Some(self.once(black_box(&start), tolerance)?);
        }
        let seconds = begin.elapsed().as_secs_f64() / f64::from(repeats);
        let (solution, outputs) = last?;
        let counts = [solution.steps + solution.rejected, solution.evaluations].map(|n| n as f64);
        Some([[seconds].as_slice(), &counts, &rates(outputs)].concat())
    }

    /// Answers one line; `None` if it is not understood.
    fn answer(&mut self, line: &str) -> Option<String> {
        let words: Vec<&str> = line.split_whitespace().collect();
        let answer = match words.as_slice() {
            ["start"] => {
                let (parameters, start) = question::<f64>();
                [parameters, start].concat()
            }
            ["prepare", _] => vec![0.0],
            ["run", tolerance, repeats] => self.run(tolerance.parse().ok()?, repeats.parse().ok()?)?,
            _ => return None,
        };
        Some(numbers(&answer))
    }
}

/// q and q̇ where the outputs are q and u; otherwise the outputs.
fn rates(mut outputs: Vec<f64>) -> Vec<f64> {
    if outputs.len() == 2 * N {
        let (q, u) = outputs.split_at_mut(N);
        let mut q_dot = [0.0; N];
        System::<f64>::coordinate_rates(&kane::Kane, &[1.0, 1.0, 9.81], q, u, &mut q_dot);
        u.copy_from_slice(&q_dot);
    }
    outputs
}

fn answers<E: System<f64> + Copy>(equations: E, beginning: Beginning, how: How) -> ExitCode {
    let rhs = Known { equations, parameters: Vec::new(), work: Vec::new() };
    let mut worker = Worker { rhs, beginning, how };
    serve(|line| worker.answer(line))
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scene, how] = arguments.as_slice() else { return usage() };
    match (scene.as_str(), How::named(how)) {
        ("report-10s", Some(how)) => answers(report_10s::Reduced, ten, how),
        ("lean", Some(how)) => answers(lean::Reduced, two, how),
        _ => usage(),
    }
}

fn usage() -> ExitCode {
    eprintln!("usage: scene report-10s | lean METHOD, METHOD-energy or quadrature");
    ExitCode::from(2)
}
