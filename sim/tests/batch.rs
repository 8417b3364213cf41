//! Batches in lanes: each trajectory as it would run alone, in whatever company.

#![allow(clippy::float_cmp, reason = "equal bits are asked for")]

use std::sync::atomic::{AtomicUsize, Ordering};

use tripos_sim::batch::{self, BatchOutcome, BatchPlan, Equations, Trajectory};
use tripos_sim::{Failure, Method, SimError, Solution, Stop};
use tripos_traits::{InLanes, Lanes, Lengths, Rates, Scalar};

/// Equations written once for every scalar; the state is q alone, or q and v.
macro_rules! equations {
    ($name:ident, $parameters:literal, $coordinates:literal, $speeds:literal, |$p:ident, $q:ident, $v:ident| $rates:expr) => {
        struct $name;
        impl<S: Scalar> Rates<S> for $name {
            fn lengths(&self) -> Lengths {
                let (coordinates, speeds) = ($coordinates, $speeds);
                Lengths { parameters: $parameters, coordinates, variables: speeds, speeds, reactions: 0 }
            }
            fn rates(&self, $p: &[S], $q: &[S], $v: &[S], q_dot: &mut [S], v_dot: &mut [S]) {
                let (of_q, of_v) = $rates;
                q_dot.copy_from_slice(&of_q);
                v_dot.copy_from_slice(&of_v);
            }
        }
    };
}

// A pendulum with g/l as its parameter.
equations!(Pendulum, 1, 1, 1, |p, q, v| ([v[0]], [-(p[0] * q[0].sin_cos().0)]));
// Kepler's problem in the plane.
equations!(Kepler, 0, 2, 2, |_p, q, v| {
    let r2 = q[0] * q[0] + q[1] * q[1];
    let r3 = r2 * r2.sqrt();
    ([v[0], v[1]], [-q[0] / r3, -q[1] / r3])
});
// Van der Pol's oscillator.
equations!(VanDerPol, 1, 1, 1, |p, q, v| ([v[0]], [p[0] * (S::int(1) - q[0] * q[0]) * v[0] - q[0]]));
// A pole at t = 1/q.
equations!(Pole, 0, 1, 0, |_p, q, _v| ([q[0] * q[0]], []));
// Reaches 0, beyond which it has no value.
equations!(Drain, 0, 1, 0, |_p, q, _v| ([-S::int(1) - q[0].sqrt()], []));
// A rotation by an angle t with the rate p.
equations!(Rotation, 1, 2, 0, |p, q, _v| ([-(p[0] * q[1]), p[0] * q[0]], []));

fn plan(span: f64, tolerance: f64) -> BatchPlan {
    let (method, rtol, atol) = (Method::Dop853, tolerance, tolerance.into());
    BatchPlan { method, order: None, span: (0.0, span), rtol, atol, max_step: None, step_limit: 100_000 }
}

/// All trajectories in so many lanes, unwatched.
fn lanes<const N: usize>(
    rates: &(dyn Rates<Lanes<N>> + Sync),
    plan: &BatchPlan,
    list: &[Trajectory<'_>],
) -> Result<Vec<BatchOutcome>, SimError> {
    batch::integrate_in_lanes(Equations { rates, series: None }, plan, list, None)
}

/// The trajectory by itself, in plain doubles.
fn alone<E: Rates<f64>>(equations: &E, plan: &BatchPlan, parameters: &[f64], start: &[f64]) -> Solution {
    let n = equations.lengths().coordinates;
    let rhs = |_t: f64, y: &[f64], f: &mut [f64]| -> Result<(), Failure> {
        let ((q, v), (q_dot, v_dot)) = (y.split_at(n), f.split_at_mut(n));
        equations.rates(parameters, q, v, q_dot, v_dot);
        Ok(())
    };
    crate::lent::integrate(rhs, plan.span, start, &plan.options(), &mut []).unwrap()
}

type Starts = Vec<(Vec<f64>, Vec<f64>)>;

fn trajectories(starts: &Starts) -> Vec<Trajectory<'_>> {
    starts.iter().map(|(parameters, start)| Trajectory { parameters, start }).collect()
}

fn pendulums(n: usize) -> Starts {
    let start = |i: usize| (vec![9.81 / (0.3 + 0.1 * i as f64)], vec![0.02 + 0.13 * i as f64, 0.3 * (i % 7) as f64]);
    (0..n).map(start).collect()
}

fn ellipses(n: usize) -> Starts {
    let start = |e: f64| (vec![], vec![1.0 - e, 0.0, 0.0, ((1.0 + e) / (1.0 - e)).sqrt()]);
    (0..n).map(|i| start(0.9 * i as f64 / n as f64)).collect()
}

fn oscillators(n: usize) -> Starts {
    (0..n).map(|i| (vec![0.5 + i as f64], vec![2.0, 0.1 * i as f64])).collect()
}

/// Goal: one method, whether in lanes or not. Method: the counts of `integrate`, in 19 of 20 cases, and ends that
/// differ by what rounding may do. How much that is, grown by the motion and by the choice of steps, runs by
/// `integrate` tell whose starts differ by 4 ulp: 50 times that, since rounding happens in every step.
fn agrees_with_runs_alone<E: Rates<f64> + Rates<Lanes<8>> + Sync>(equations: &E, span: f64, starts: &Starts) {
    let (mut equal, tolerances) = (0, [1e-3, 1e-6, 1e-9, 1e-12]);
    for tolerance in tolerances {
        let plan = plan(span, tolerance);
        let outcomes = lanes::<8>(equations, &plan, &trajectories(starts));
        for ((parameters, start), outcome) in starts.iter().zip(outcomes.unwrap()) {
            let run = alone(equations, &plan, parameters, start);
            // An error that meets the tolerance to rounding may be accepted by one and rejected by the other.
            let (found, expected) = ((outcome.steps, outcome.rejected), (run.steps, run.rejected));
            let differ = found.0.abs_diff(expected.0) + found.1.abs_diff(expected.1);
            assert!(differ <= 1, "{start:?} at {tolerance:e}: {found:?} is not {expected:?}");
            assert!(differ == 1 || outcome.evaluations == run.evaluations);
            assert_eq!((outcome.t_end, &outcome.stop), (run.t_end, &run.stop));
            equal += usize::from(differ == 0);
            let spread = [-4.0, -2.0, 2.0, 4.0].map(|ulps: f64| {
                let moved: Vec<f64> = start.iter().map(|x| x * (1.0 + ulps * f64::EPSILON)).collect();
                distance(&run.y_end, &alone(equations, &plan, parameters, &moved).y_end)
            });
            let size = run.y_end.iter().fold(1.0, |m: f64, y| m.max(y.abs()));
            let bound = 50.0 * spread.into_iter().fold(4.0 * f64::EPSILON * size, f64::max);
            let found = distance(&run.y_end, &outcome.y_end);
            assert!(differ == 1 || found <= bound, "{start:?} at {tolerance:e}: {found:e} > {bound:e}");
        }
    }
    assert!(20 * equal >= 19 * tolerances.len() * starts.len(), "only {equal} have equal counts");
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn pendulums_take_the_steps_that_each_takes_alone() {
    agrees_with_runs_alone(&Pendulum, 20.0, &pendulums(21));
}

#[test]
fn ellipses_take_the_steps_that_each_takes_alone() {
    agrees_with_runs_alone(&Kepler, 13.0, &ellipses(19));
}

#[test]
fn relaxation_oscillators_with_their_rejected_steps_agree_too() {
    agrees_with_runs_alone(&VanDerPol, 20.0, &oscillators(17));
}

#[test]
fn a_run_backward_agrees_too() {
    agrees_with_runs_alone(&Pendulum, -7.0, &pendulums(9));
}

/// Goal: the invariant. Method: equal outcomes, all bits of them, in other orders, widths and companies.
#[test]
fn an_outcome_does_not_depend_on_the_company() {
    let (starts, plan) = (pendulums(61), plan(9.0, 1e-7));
    let list = trajectories(&starts);
    let eight = lanes::<8>(&Pendulum, &plan, &list).unwrap();
    assert_eq!(eight, lanes::<4>(&Pendulum, &plan, &list).unwrap(), "four lanes");
    assert_eq!(eight, lanes::<1>(&Pendulum, &plan, &list).unwrap(), "one lane");
    assert_eq!(
        eight,
        batch::integrate_batch(InLanes::of_rates(&Pendulum), &plan, &list).unwrap(),
        "as many as are best"
    );
    for (trajectory, outcome) in list.iter().zip(&eight) {
        let one = lanes::<8>(&Pendulum, &plan, &[*trajectory]).unwrap();
        assert_eq!(&one[0], outcome, "a batch of one");
    }
    // 37 has no factor in common with 61, so this is a shuffle.
    let order: Vec<usize> = (0..61).map(|i| i * 37 % 61).collect();
    let shuffled: Vec<Trajectory<'_>> = order.iter().map(|i| list[*i]).collect();
    let outcomes = lanes::<8>(&Pendulum, &plan, &shuffled).unwrap();
    for (i, outcome) in order.iter().zip(outcomes) {
        assert_eq!(eight[*i], outcome, "shuffled");
    }
}

#[test]
fn all_cores_give_the_outcomes_of_one_and_say_how_far_they_are() {
    let (starts, plan) = (oscillators(50), plan(8.0, 1e-6));
    let list = trajectories(&starts);
    let expected = batch::integrate_batch(InLanes::of_rates(&VanDerPol), &plan, &list).unwrap();
    for threads in [1, 2, 3, 7] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let (calls, largest) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let progress = |done: usize| {
            calls.fetch_add(1, Ordering::Relaxed);
            largest.fetch_max(done, Ordering::Relaxed);
        };
        let outcomes =
            pool.install(|| batch::integrate_on_all_cores(InLanes::of_rates(&VanDerPol), &plan, &list, &progress));
        assert_eq!(outcomes.unwrap(), expected, "{threads} threads");
        assert_eq!((calls.into_inner(), largest.into_inner()), (50, 50));
    }
}

/// Goal: a failure is its own. Method: poles among trajectories that have none in the span.
#[test]
fn a_lane_that_meets_a_pole_ends_alone() {
    let plan = plan(1.0, 1e-8);
    let start = |i: usize| (vec![], vec![if i.is_multiple_of(3) { 2.0 + i as f64 } else { 0.5 / i as f64 }]);
    let starts: Starts = (0..26).map(start).collect();
    let outcomes = lanes::<8>(&Pole, &plan, &trajectories(&starts)).unwrap();
    for ((_, y0), outcome) in starts.iter().zip(&outcomes) {
        let run = alone(&Pole, &plan, &[], y0);
        assert_eq!(outcome.stop.is_failure(), run.stop.is_failure(), "{y0:?}");
        if y0[0] < 1.0 {
            // y = 1 / (1/y0 − t); an error of 1e-8 a step.
            let exact = 1.0 / (1.0 / y0[0] - 1.0);
            assert!(outcome.stop == Stop::End && (outcome.y_end[0] - exact).abs() < 1e-6, "{outcome:?}");
        } else {
            let (pole, gap) = (1.0 / y0[0], (outcome.t_end - 1.0 / y0[0]).abs());
            assert!(outcome.stop.is_failure() && gap < 1e-8 * pole, "{outcome:?} {pole}");
        }
    }
    let without: Starts = starts.into_iter().filter(|(_, y0)| y0[0] < 1.0).collect();
    let expected = lanes::<8>(&Pole, &plan, &trajectories(&without)).unwrap();
    let others: Vec<BatchOutcome> = outcomes.into_iter().filter(|o| o.stop == Stop::End).collect();
    assert_eq!(others, expected);
}

#[test]
fn where_the_equations_have_no_value_the_lane_ends_with_the_component() {
    let plan = plan(5.0, 1e-6);
    let starts: Starts = (1..12).map(|i| (vec![], vec![0.1 * f64::from(i)])).collect();
    for ((_, y0), outcome) in starts.iter().zip(lanes::<4>(&Drain, &plan, &trajectories(&starts)).unwrap()) {
        let run = alone(&Drain, &plan, &[], y0);
        assert_eq!((&outcome.stop, &run.stop), (&Stop::NotFinite { component: 0 }, &Stop::NotFinite { component: 0 }));
        // y = 0 where 2 (√y0 − ln (1 + √y0)) = t.
        let root = y0[0].sqrt();
        assert!((outcome.t_end - 2.0 * (root - root.ln_1p())).abs() < 1e-4, "{outcome:?}");
    }
}

#[test]
fn a_start_without_a_derivative_ends_at_once() {
    let starts: Starts = vec![(vec![], vec![4.0]), (vec![], vec![-1.0]), (vec![], vec![0.25])];
    let outcomes = lanes::<4>(&Drain, &plan(0.01, 1e-6), &trajectories(&starts)).unwrap();
    let expected = BatchOutcome {
        t_end: 0.0,
        y_end: vec![-1.0],
        stop: Stop::NotFinite { component: 0 },
        steps: 0,
        rejected: 0,
        evaluations: 1,
        events: Vec::new(),
    };
    assert_eq!(outcomes[1], expected);
    assert!(outcomes[0].stop == Stop::End && outcomes[2].stop == Stop::End);
}

#[test]
fn any_number_of_bad_starts_stops_no_other() {
    let start = |i: i32| (vec![], vec![if i < 100 { -1.0 } else { 4.0 }]);
    let starts: Starts = (0..110).map(start).collect();
    for outcomes in [
        lanes::<4>(&Drain, &plan(0.01, 1e-6), &trajectories(&starts)).unwrap(),
        batch::integrate_on_all_cores(InLanes::of_rates(&Drain), &plan(0.01, 1e-6), &trajectories(&starts), &|_| ())
            .unwrap(),
    ] {
        assert!(
            outcomes[..100].iter().all(|o| o.stop.is_failure()) && outcomes[100..].iter().all(|o| o.stop == Stop::End)
        );
    }
}

#[test]
fn the_limit_of_steps_is_each_trajectory_s_own() {
    let starts = pendulums(11);
    for limit in [0, 1, 9] {
        let plan = BatchPlan { step_limit: limit, ..plan(20.0, 1e-9) };
        for ((parameters, start), outcome) in
            starts.iter().zip(lanes::<8>(&Pendulum, &plan, &trajectories(&starts)).unwrap())
        {
            let run = alone(&Pendulum, &plan, parameters, start);
            assert_eq!(outcome.stop, Stop::StepLimit { limit });
            assert_eq!((outcome.steps + outcome.rejected, outcome.steps), (limit, run.steps));
            // Step sizes follow errors, which are what is left of a cancellation.
            assert!((outcome.t_end - run.t_end).abs() <= 1e-6 * run.t_end);
        }
    }
}

/// A rotation is known exactly: 1e-9 is 30 times the largest error met.
#[test]
fn a_rotation_ends_where_it_should() {
    let starts: Starts = (0..20).map(|i| (vec![0.5 * f64::from(i)], vec![0.6, 0.8])).collect();
    for ((p, y), outcome) in
        starts.iter().zip(lanes::<8>(&Rotation, &plan(3.0, 1e-11), &trajectories(&starts)).unwrap())
    {
        let (s, c) = (3.0 * p[0]).sin_cos();
        let exact = [c * y[0] - s * y[1], s * y[0] + c * y[1]];
        assert!(distance(&outcome.y_end, &exact) < 1e-9, "{outcome:?} {exact:?}");
    }
}

#[test]
fn questions_without_sense_are_refused_with_their_place() {
    let good = (vec![9.81], vec![0.5, 0.0]);
    let refused = |plan: &BatchPlan, starts: Starts| {
        batch::integrate_batch(InLanes::of_rates(&Pendulum), plan, &trajectories(&starts)).unwrap_err().to_string()
    };
    let with = |odd: (Vec<f64>, Vec<f64>)| refused(&plan(1.0, 1e-6), vec![good.clone(), good.clone(), odd]);
    assert_eq!(with((vec![], vec![0.5, 0.0])), "trajectory 2: parameters: expected 1 numbers, found 0");
    assert_eq!(with((vec![9.81], vec![0.5])), "trajectory 2: the initial state: expected 2 numbers, found 1");
    assert_eq!(with((vec![f64::NAN], vec![0.5, 0.0])), "trajectory 2: parameter 0 is not a finite number");
    let odd_start = (vec![9.81], vec![0.5, f64::INFINITY]);
    assert_eq!(with(odd_start), "trajectory 2: component 1 of the initial state is not a finite number");
    let plan_of = |span, rtol| BatchPlan { span, rtol, ..plan(1.0, 1e-6) };
    assert!(refused(&plan_of((2.0, 2.0), 1e-6), vec![good.clone()]).contains("starts and ends at the same time"));
    assert!(refused(&plan_of((0.0, 2.0), -1.0), vec![good.clone()]).contains("must be finite and not negative"));
    let none: Result<Vec<BatchOutcome>, SimError> =
        batch::integrate_batch(InLanes::of_rates(&Pendulum), &plan(1.0, 1e-6), &[]);
    assert_eq!(none, Ok(vec![]));
}
