//! IFToMM's benchmarks A01, A02 and A04: ten seconds of each mechanism to an energy error of 1e-10 J, by compiled
//! equations.
//!
//! A run is one integration from a start that is ready. It leaves out the second run that estimates errors, and the
//! search for a failure of the chosen speeds on the way. Where the speeds fail, all rates run beside them, as in
//! `tripos simulate`. The error is the largest change of T + V at the ends of steps; no projection keeps the energy.
//! For each method the tolerance is the first of a ladder that reaches the aim, found before anything is timed.
//! M. González, D. Dopico, U. Lugrís & J. Cuadrado, *Multibody System Dynamics* 16 (2006) 179–190.
#![allow(missing_docs, reason = "`criterion_group!` makes a public function")]

use std::hint::black_box;
use std::path::Path;
use std::sync::Mutex;
use std::time::Instant;

use criterion::{Criterion, criterion_group, criterion_main};
use tripos::code::{Code, CodePreparation, runnable_code};
use tripos::preparation::speed_changes::ChosenSpeedEquations;
use tripos::{Problem, Scene};
use tripos_derive::Formulation;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::scene::AccelerationSolution;
use tripos_sim::{Method, Options, OutputOption, Solution};

/// Largest permitted change of the energy T + V, J.
const AIM: f64 = 1e-10;
const BENCHMARKS: [&str; 3] = ["a01", "a02", "a04"];
const METHODS: [Method; 3] = [Method::Dop853, Method::Taylor, Method::Ode45];
const TURNS: usize = 101;

/// The equations of a mechanism in its speeds, and those in all rates.
struct Equations {
    by: [EquationsOrigin; 2],
    code: [Code; 2],
}

impl Equations {
    fn new(scene: &Scene) -> Self {
        let by = [Formulation::Kane, Formulation::Lagrange].map(EquationsOrigin::from);
        let compiled = |by: &EquationsOrigin| {
            runnable_code(scene.mechanism(), by, None, CodePreparation::AsDerived).expect("a model of the library")
        };
        let code = [compiled(&by[0]), compiled(&by[1])];
        assert!(code.iter().all(Code::is_compiled), "run `tripos regenerate`: interpreted equations are not measured");
        Self { by, code }
    }
}

/// A run at one tolerance; nothing if it did not come to its end.
fn run(problem: &Problem<'_>, method: Method, tolerance: f64) -> Option<Solution> {
    let options =
        Options { method, output: OutputOption::Steps { refine: 1 }, ..Options::tolerances(tolerance, tolerance) };
    let start = problem.start().expect("the scene states its start");
    let solution = problem.solve(&start, &options, &mut [], None).ok()?;
    (!solution.stop.is_failure()).then_some(solution)
}

fn energy_error(problem: &Problem<'_>, solution: &Solution) -> f64 {
    let (system, p) = (problem.system(), &problem.scene.parameters);
    let energy = |y: &Vec<f64>| {
        let (q, v) = y.split_at(system.lengths().coordinates);
        system.kinetic_energy(p, q, v) + system.potential_energy(p, q)
    };
    solution.energy_drift(solution.y.iter().map(energy), energy(&solution.y_end))
}

/// The loosest tolerance of a ladder by which the energy is kept, with the run.
fn loosest(problem: &Problem<'_>, method: Method) -> Option<(f64, Solution)> {
    let ladder = (18..=30).map(|half| 10_f64.powf(-f64::from(half) / 2.0));
    ladder.map(|tolerance| (tolerance, run(problem, method, tolerance))).find_map(|(tolerance, solution)| {
        let solution = solution.filter(|solution| energy_error(problem, solution) <= AIM)?;
        Some((tolerance, solution))
    })
}

/// Median and least time of runs in ms.
fn timed(mut run: impl FnMut()) -> (f64, f64) {
    let mut times: Vec<f64> = (0..TURNS)
        .map(|_| {
            let begin = Instant::now();
            run();
            begin.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    times.sort_by(f64::total_cmp);
    (times[TURNS / 2], times[0])
}

fn linkages(c: &mut Criterion) {
    let mut group = c.benchmark_group("IFToMM, 10 s to 1e-10 J");
    for name in BENCHMARKS {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("scenes/{name}.toml"));
        let scene = Scene::read(path).expect("the scene is ours").with_compiled_equations(tripos_models::MODELS);
        let equations = Equations::new(&scene);
        let ([speeds, rates], [in_speeds, in_rates]) = (&equations.by, &equations.code);
        let changes = Mutex::default();
        let chosen = ChosenSpeedEquations {
            by: speeds,
            code: in_speeds,
            solve: AccelerationSolution::Eliminated,
            changes: &changes,
        };
        let problem = |by, code, solve| Problem::new(scene.mechanism(), scene.description(), by, code, solve);
        let plain = problem(speeds, in_speeds, None).expect("equations that run");
        let changing = problem(rates, in_rates, Some(AccelerationSolution::Numeric))
            .expect("equations that run")
            .with_chosen_speeds(chosen);
        for method in METHODS {
            let found = [(&plain, "its speeds"), (&changing, "all rates beside its speeds")]
                .into_iter()
                .find_map(|(problem, how)| Some((problem, how, loosest(problem, method)?)));
            let Some((problem, how, (tolerance, solution))) = found else {
                println!("{name}, {}: not reached", method.name());
                continue;
            };
            let once = || drop(black_box(run(problem, method, tolerance)));
            group.bench_function(format!("{name}, {}", method.name()), |b| b.iter(once));
            let (median, least) = timed(once);
            println!(
                "{name}, {}, {how}: {median:.2} ms ({least:.2} ms), {:.1e} J at a tolerance of {tolerance:.0e}, {} steps, {} rejected, {} evaluations",
                method.name(),
                energy_error(problem, &solution),
                solution.steps,
                solution.rejected,
                solution.evaluations
            );
        }
    }
    group.finish();
}

criterion_group!(benches, linkages);
criterion_main!(benches);
