//! Cost of lanes: sines, the derivative of the disk's state, and whole runs, compared with single numbers.
//!
//! `cargo bench -p tripos-benches --features measure --bench lanes`. Each figure is the median of short turns, most of
//! them taken alternately; "a state" means: divided by the number of lanes.

use std::hint::black_box;
use std::time::Instant;

use tripos_models::disk::lagrange::Lagrange;
use tripos_sim::batch::{self, BatchPlan, Equations, Trajectory, WatchedTrajectory};
use tripos_sim::{EliminatedDynamics, Event, LentRightHandSide, Method, integrate};
use tripos_traits::{Derivative, InLanes, Lanes, Rates, Scalar, System, lane_width};

const DISK: Derivative<Lagrange> = Derivative(Lagrange);

/// Coordinates of the disk; as many speeds follow them in a state.
const N: usize = 5;
const CALLS: u32 = 20_000;
const TURNS: usize = 15;

/// Median seconds of each of these, taken alternately.
fn medians<const K: usize>(mut work: [&mut dyn FnMut(); K]) -> [f64; K] {
    let mut times: [Vec<f64>; K] = std::array::from_fn(|_| Vec::new());
    for _ in 0..TURNS {
        for (work, times) in work.iter_mut().zip(&mut times) {
            let begin = Instant::now();
            work();
            times.push(begin.elapsed().as_secs_f64());
        }
    }
    times.map(|mut list| {
        list.sort_by(f64::total_cmp);
        list[list.len() / 2]
    })
}

/// Angles that differ from call to call, in every quadrant.
fn angles() -> Vec<f64> {
    (0..1024).map(|i| 0.37 * f64::from(i) - 150.0).collect()
}

fn sines() {
    let list = angles();
    let calls = 20.0 * list.len() as f64;
    let (mut sine, mut cosine) = (list.clone(), list.clone());
    let mut each = |f: fn(f64) -> (f64, f64)| {
        for _ in 0..20 {
            for ((x, s), c) in black_box(&list).iter().zip(&mut sine).zip(&mut cosine) {
                (*s, *c) = f(*x);
            }
            black_box((&sine, &cosine));
        }
    };
    let [theirs, std] = [libm::sincos, f64::sin_cos].map(|f| medians([&mut || each(f)])[0]);
    let mut ours = || {
        for _ in 0..20 {
            for ((x, s), c) in black_box(&list).iter().zip(&mut sine).zip(&mut cosine) {
                (*s, *c) = Scalar::sin_cos(*x);
            }
            black_box((&sine, &cosine));
        }
    };
    let [ours] = medians([&mut ours]);
    let wide: Vec<Lanes<8>> = list.as_chunks().0.iter().map(|x| Lanes(*x)).collect();
    let (mut sine, mut cosine) = (wide.clone(), wide.clone());
    let mut lanes = || {
        for _ in 0..20 {
            Lanes::<8>::dispatch(
                #[inline(always)]
                || {
                    for ((x, s), c) in black_box(&wide).iter().zip(&mut sine).zip(&mut cosine) {
                        (*s, *c) = x.sin_cos();
                    }
                },
            );
            black_box((&sine, &cosine));
        }
    };
    let [lanes] = medians([&mut lanes]);
    let [ours, theirs, std, lanes] = [ours, theirs, std, lanes].map(|s| 1e9 * s / calls);
    println!("sine and cosine: f64 {ours:.2} ns, libm {theirs:.2} ns, std {std:.2} ns, 8 lanes {lanes:.2} ns a number");
}

/// Parameters, coordinates and motion variables at a start.
struct Start<S> {
    p: [S; 3],
    q: [S; N],
    v: [S; N],
}

/// The report's start, in every lane a little different.
fn start<S: Scalar>(of: impl Fn(f64) -> S) -> Start<S> {
    let (q, v) = ([0.1745, 0.6, 0.785, 5.0, 1.0], [0.01, -0.1, 0.02, 0.4, 0.1]);
    Start { p: [1.0, 1.0, 9.81].map(&of), q: q.map(&of), v: v.map(&of) }
}

/// Time of one call, each with arguments that only the memory knows.
fn calls<S: Scalar>(system: &dyn Rates<S>, start: &Start<S>) {
    let Start { p, q, v } = start;
    let (mut q_dot, mut v_dot) = (*q, *v);
    for _ in 0..CALLS {
        black_box(system).rates(black_box(p), black_box(q), black_box(v), &mut q_dot, &mut v_dot);
        black_box((&q_dot, &v_dot));
    }
}

fn derivatives() {
    let spread = |x: f64, l: usize| x * (1.0 + 0.01 * l as f64);
    let one = start(|x| x);
    let four = start(|x| Lanes::<4>(std::array::from_fn(|l| spread(x, l))));
    let eight = start(|x| Lanes::<8>(std::array::from_fn(|l| spread(x, l))));
    let [one, four, eight] =
        medians([&mut || calls(&DISK, &one), &mut || calls(&DISK, &four), &mut || calls(&DISK, &eight)])
            .map(|s| 1e9 * s / f64::from(CALLS));
    let (four, eight) = (four / 4.0, eight / 8.0);
    println!("derivative of the disk: f64 {one:.1} ns, 4 lanes {four:.2} ns a state, 8 lanes {eight:.2} ns a state");
}

/// Whole runs of 10 s at 1e-6 from leans between 0.01 and 1.5 rad, some of which pass near flat.
fn batches() {
    let lean = |i: i32| 0.01 + 1.49 * f64::from(i) / 255.0;
    let starts: Vec<[f64; 2 * N]> =
        (0..256).map(|i| [0.1745, lean(i), 0.785, 5.0, 1.0, 0.01, -0.1, 0.02, 0.4, 0.1]).collect();
    let p = [1.0, 1.0, 9.81];
    let list: Vec<Trajectory<'_>> = starts.iter().map(|start| Trajectory { parameters: &p, start }).collect();
    for method in [Method::Dop853, Method::Taylor] {
        batches_by(method, &p, &list);
    }
}

fn batches_by(method: Method, p: &[f64], list: &[Trajectory<'_>]) {
    let (rtol, atol) = (1e-6, 1e-6.into());
    let plan = BatchPlan { method, order: None, span: (0.0, 10.0), rtol, atol, max_step: None, step_limit: 100_000 };
    let equations = InLanes::of_rates(&DISK).with_series(&DISK);
    let outcomes = batch::integrate_batch(equations, &plan, list).expect("the question makes sense");
    let attempts: u64 = outcomes.iter().map(|o| o.steps + o.rejected).sum();
    let options = plan.options();
    let single = || {
        for Trajectory { start, .. } in list {
            let mut rhs = equations_of(p);
            black_box(
                integrate(LentRightHandSide(&mut rhs), plan.span, start, &options, &mut [])
                    .expect("the question makes sense"),
            );
        }
    };
    // A height above the plane that is never left, beside what the equations divide by.
    let watching = |_: usize| WatchedTrajectory {
        equations: Box::new(equations_of(p)),
        events: vec![Event::domain("up", |_t, y| 2.0 + y[1].cos())],
    };
    let n = list.len() as f64;
    let four = Equations::<4> { rates: &DISK, series: Some(&DISK) };
    let eight = Equations::<8> { rates: &DISK, series: Some(&DISK) };
    let [one, four, eight, watched] = medians([
        &mut || single(),
        &mut || drop(black_box(batch::integrate_in_lanes(four, &plan, list, None))),
        &mut || drop(black_box(batch::integrate_in_lanes(eight, &plan, list, None))),
        &mut || drop(black_box(batch::integrate_in_lanes(four, &plan, list, Some(&watching)))),
    ])
    .map(|s| 1e3 * s / n);
    println!(
        "a run of {:.0} attempted steps by {}: alone {one:.4} ms, in 4 lanes {four:.4} ms ({:.0} ns a step), watched \
         {watched:.4} ms, in 8 lanes {eight:.4} ms",
        attempts as f64 / n,
        method.name(),
        1e6 * four * n / attempts as f64
    );
}

fn equations_of(p: &[f64]) -> EliminatedDynamics<'static> {
    let system: &'static (dyn System<f64> + Sync) = &Lagrange;
    EliminatedDynamics::new(system, p).expect("these equations were solved for")
}

fn main() {
    println!("this processor computes best in {} lanes", lane_width());
    sines();
    derivatives();
    batches();
}
