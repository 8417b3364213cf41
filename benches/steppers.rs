//! Our `dop853` beside that of `ode_solvers`, on the same equations and tolerances, taking turns.
//!
//! Both are given a state of 10 components; `ode_solvers` its fastest form, a vector of fixed size. The figure that
//! counts is the last line: the ratio of the medians of many short turns, which a busy machine disturbs least. Ours
//! keeps the ends of the run only; theirs has no such choice, and keeps each step in one growing vector.
#![allow(missing_docs, reason = "`criterion_group!` makes a public function")]

use std::hint::black_box;
use std::time::Instant;

use criterion::{Criterion, criterion_group, criterion_main};
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, SVector, System};
use tripos_sim::{Method, Options, OutputOption, integrate};

const N: usize = 10;
const SPAN: f64 = 20.0;
const TOLERANCE: f64 = 1e-9;

/// A chain of five masses between walls, with springs that stiffen: cheap, so that the method's own cost shows.
#[inline]
fn chain(y: &[f64; N], dydt: &mut [f64; N]) {
    let (x, v) = y.split_at(N / 2);
    let (dx, dv) = dydt.split_at_mut(N / 2);
    dx.copy_from_slice(v);
    let pull = |d: f64| d + 0.5 * d * d * d;
    for i in 0..N / 2 {
        let left = if i == 0 { x[0] } else { x[i] - x[i - 1] };
        let right = if i + 1 == N / 2 { -x[i] } else { x[i + 1] - x[i] };
        dv[i] = pull(right) - pull(left);
    }
}

fn start() -> [f64; N] {
    std::array::from_fn(|i| if i == 0 { 1.0 } else { 0.1 * i as f64 })
}

struct Chain;

impl System<f64, SVector<f64, N>> for Chain {
    fn system(&self, _t: f64, y: &SVector<f64, N>, dy: &mut SVector<f64, N>) {
        chain(&y.data.0[0], &mut dy.data.0[0]);
    }
}

fn theirs() -> (u64, f64) {
    let y0 = SVector::from(start());
    let mut stepper = Dop853::new(Chain, 0.0, SPAN, 0.0, y0, TOLERANCE, TOLERANCE);
    stepper.set_output(OutputType::Sparse);
    let stats = stepper.integrate().expect("the chain has no singularities");
    let last = stepper.y_out().last().map_or(0.0, |y| y[0]);
    (u64::from(stats.accepted_steps), last)
}

fn ours() -> (u64, f64) {
    let options =
        Options { method: Method::Dop853, output: OutputOption::Ends, ..Options::tolerances(TOLERANCE, TOLERANCE) };
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        let (Ok(y), Ok(dydt)) = (y.try_into(), dydt.try_into()) else { unreachable!("the state has N components") };
        chain(y, dydt);
        Ok(())
    };
    let solution = integrate(rhs, (0.0, SPAN), &start(), &options, &mut []).expect("the question makes sense");
    (solution.steps, solution.y_end[0])
}

/// Median times in µs of turns taken one after the other.
fn interleaved(turns: usize) -> (f64, f64) {
    let time = |f: &dyn Fn() -> (u64, f64)| {
        let begin = Instant::now();
        black_box(f());
        begin.elapsed().as_secs_f64() * 1e6
    };
    let (mut a, mut b) = (Vec::new(), Vec::new());
    for _ in 0..turns {
        a.push(time(&ours));
        b.push(time(&theirs));
    }
    let median = |times: &mut Vec<f64>| {
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    };
    (median(&mut a), median(&mut b))
}

fn steppers(c: &mut Criterion) {
    let ((steps, y), (their_steps, their_y)) = (ours(), theirs());
    assert!(steps == their_steps && (y - their_y).abs() < 1e-9, "{steps} {their_steps} {y} {their_y}");
    let mut group = c.benchmark_group("dop853, 10 states");
    group.bench_function("tripos", |b| b.iter(ours));
    group.bench_function("ode_solvers", |b| b.iter(theirs));
    group.finish();
    let (a, b) = interleaved(4_000);
    println!("{steps} steps: tripos {a:.1} µs, ode_solvers {b:.1} µs, ratio {:.2}", a / b);
}

criterion_group!(benches, steppers);
criterion_main!(benches);
