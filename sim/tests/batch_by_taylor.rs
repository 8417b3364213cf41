//! Batches by Taylor's method, and batches that are watched: each trajectory as it would run alone.

#![allow(clippy::float_cmp, reason = "equal bits are asked for")]

use crate::lent::integrate;
use tripos_sim::batch::{self, BatchOutcome, BatchPlan, Equations, Trajectory, WatchedTrajectory};
use tripos_sim::{Direction, Effect, Event, Failure, Method, RightHandSide, SimError, Solution};
use tripos_traits::{InLanes, Lanes, Lengths, Rates, Scalar, Series};

/// A pendulum, q' = v, v' = −p sin q, by the recurrences of its sine and cosine.
struct Pendulum;

impl<S: Scalar> Rates<S> for Pendulum {
    fn lengths(&self) -> Lengths {
        Lengths { parameters: 1, coordinates: 1, variables: 1, speeds: 1, reactions: 0 }
    }
    fn rates(&self, p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]) {
        (q_dot[0], v_dot[0]) = (v[0], -(p[0] * q[0].sin_cos().0));
    }
}

impl<S: Scalar> Series<S> for Pendulum {
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        2 * (order + 1)
    }
    fn taylor(&self, p: &[S], order: usize, x: &mut [S], work: &mut [S]) {
        let (sines, cosines) = work.split_at_mut(order + 1);
        (sines[0], cosines[0]) = x[0].sin_cos();
        for k in 1..=order {
            let over_k = S::int(1) / S::from_f64(k as f64);
            (x[2 * k], x[2 * k + 1]) = (x[2 * k - 1] * over_k, -(p[0] * sines[k - 1] * over_k));
            // k s_k = Σ j q_j c_{k−j}, k c_k = −Σ j q_j s_{k−j}.
            let (mut s, mut c) = (S::int(0), S::int(0));
            for j in 1..=k {
                let factor = S::from_f64(j as f64) * x[2 * j];
                s = s + factor * cosines[k - j];
                c = c - factor * sines[k - j];
            }
            (sines[k], cosines[k]) = (s * over_k, c * over_k);
        }
    }
}

/// q' = q², whose coefficients q^(k+1) overflow where the start is large.
struct Pole;

impl<S: Scalar> Rates<S> for Pole {
    fn lengths(&self) -> Lengths {
        Lengths { parameters: 0, coordinates: 1, variables: 0, speeds: 0, reactions: 0 }
    }
    fn rates(&self, _p: &[S], q: &[S], _v: &[S], q_dot: &mut [S], _v_dot: &mut [S]) {
        q_dot[0] = q[0] * q[0];
    }
}

impl<S: Scalar> Series<S> for Pole {
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, _order: usize) -> usize {
        0
    }
    fn taylor(&self, _p: &[S], order: usize, x: &mut [S], _work: &mut [S]) {
        for k in 1..=order {
            x[k] = x[k - 1] * x[0];
        }
    }
}

/// A point with q' = v/q and v' = 1/4. It has no motion through q = 0 except at one speed; its Taylor coefficients are
/// never used.
struct Point;

impl<S: Scalar> Rates<S> for Point {
    fn lengths(&self) -> Lengths {
        Lengths { parameters: 0, coordinates: 1, variables: 1, speeds: 1, reactions: 0 }
    }
    fn rates(&self, _p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]) {
        (q_dot[0], v_dot[0]) = (v[0] / q[0], S::ratio(1, 4));
    }
}

impl<S: Scalar> Series<S> for Point {
    fn has_taylor(&self) -> bool {
        false
    }
    fn taylor_work(&self, _order: usize) -> usize {
        0
    }
    fn taylor(&self, _p: &[S], _order: usize, _x: &mut [S], _work: &mut [S]) {}
}

/// One trajectory in plain doubles, with its divisors.
struct Alone<'a, E> {
    equations: &'a E,
    parameters: &'a [f64],
    divisor: Option<fn(&[f64]) -> f64>,
}

impl<E: Rates<f64> + Series<f64>> RightHandSide for Alone<'_, E> {
    fn rhs(&mut self, _t: f64, y: &[f64], f: &mut [f64]) -> Result<(), Failure> {
        let n = self.equations.lengths().coordinates;
        let ((q, v), (q_dot, v_dot)) = (y.split_at(n), f.split_at_mut(n));
        self.equations.rates(self.parameters, q, v, q_dot, v_dot);
        Ok(())
    }
    fn taylor(&mut self, _t: f64, order: usize, x: &mut [f64]) -> Option<Result<(), Failure>> {
        let mut work = vec![0.0; self.equations.taylor_work(order)];
        self.equations.taylor(self.parameters, order, x, &mut work);
        Some(Ok(()))
    }
    fn divisor_count(&self) -> usize {
        usize::from(self.divisor.is_some())
    }
    fn divisors(&mut self, _t: f64, y: &[f64], out: &mut [f64]) {
        if let Some(divisor) = self.divisor {
            out[0] = divisor(y);
        }
    }
}

fn plan(method: Method, span: f64, tolerance: f64) -> BatchPlan {
    let (rtol, atol) = (tolerance, tolerance.into());
    BatchPlan { method, order: None, span: (0.0, span), rtol, atol, max_step: None, step_limit: 100_000 }
}

type Starts = Vec<(Vec<f64>, Vec<f64>)>;

fn trajectories(starts: &Starts) -> Vec<Trajectory<'_>> {
    starts.iter().map(|(parameters, start)| Trajectory { parameters, start }).collect()
}

fn pendulums(n: usize) -> Starts {
    let start = |i: usize| (vec![9.81 / (0.3 + 0.1 * i as f64)], vec![0.02 + 0.13 * i as f64, 0.3 * (i % 7) as f64]);
    (0..n).map(start).collect()
}

fn poles(n: usize) -> Starts {
    (0..n).map(|i| (vec![], vec![[0.9, 1e300, 2.0, 1e-3][i % 4] / (1.0 + i as f64)])).collect()
}

fn lanes<const N: usize, E>(equations: &E, plan: &BatchPlan, list: &[Trajectory<'_>]) -> Vec<BatchOutcome>
where
    E: Rates<Lanes<N>> + Series<Lanes<N>> + Sync,
{
    batch::integrate_in_lanes(Equations { rates: equations, series: Some(equations) }, plan, list, None).unwrap()
}

/// Goal: one method, whether in lanes or not. Method: the counts and ends of `integrate`. Tolerance: 1e-3 of the runs'
/// own. Both take the same steps except for the rounding of their sizes, so that only errors of steps differ; 2e-13
/// where that is below rounding.
fn agrees_with_runs_alone<E>(equations: &E, span: f64, starts: &Starts)
where
    E: Rates<f64> + Series<f64> + Rates<Lanes<4>> + Series<Lanes<4>> + Sync,
{
    for tolerance in [1e-3, 1e-6, 1e-9, 1e-12] {
        let plan = plan(Method::Taylor, span, tolerance);
        for ((parameters, start), outcome) in starts.iter().zip(lanes::<4, _>(equations, &plan, &trajectories(starts)))
        {
            let rhs = Alone { equations, parameters, divisor: None };
            let run = integrate(rhs, plan.span, start, &plan.options(), &mut []).unwrap();
            let (found, expected) = ((outcome.steps, outcome.rejected), (run.steps, run.rejected));
            assert_eq!(found, expected, "{start:?} at {tolerance:e}");
            assert_eq!(
                (outcome.evaluations, &outcome.stop),
                (run.evaluations, &run.stop),
                "{start:?} at {tolerance:e}"
            );
            let near = |a: f64, b: f64| (a - b).abs() <= (1e-3 * tolerance).max(2e-13) * (1.0 + b.abs());
            assert!(near(outcome.t_end, run.t_end), "{} {}", outcome.t_end, run.t_end);
            let ends = outcome.y_end.iter().zip(&run.y_end);
            if !run.stop.is_failure() {
                ends.for_each(|(a, b)| assert!(near(*a, *b), "{start:?} at {tolerance:e}: {a} {b}"));
            }
        }
    }
}

#[test]
fn pendulums_by_taylor_take_the_steps_that_each_takes_alone() {
    agrees_with_runs_alone(&Pendulum, 20.0, &pendulums(21));
    agrees_with_runs_alone(&Pendulum, -7.0, &pendulums(9));
}

/// Coefficients that overflow leave a lane at a lower order, and the others at theirs.
#[test]
fn poles_by_taylor_take_the_steps_that_each_takes_alone() {
    agrees_with_runs_alone(&Pole, 0.7, &poles(23));
}

#[test]
fn an_outcome_by_taylor_does_not_depend_on_the_company() {
    let (starts, plan) = (pendulums(61), plan(Method::Taylor, 9.0, 1e-7));
    let list = trajectories(&starts);
    let four = lanes::<4, _>(&Pendulum, &plan, &list);
    assert_eq!(four, lanes::<8, _>(&Pendulum, &plan, &list), "eight lanes");
    assert_eq!(four, lanes::<1, _>(&Pendulum, &plan, &list), "one lane");
    let in_lanes = InLanes::of_rates(&Pendulum).with_series(&Pendulum);
    assert_eq!(four, batch::integrate_batch(in_lanes, &plan, &list).unwrap(), "as many as there are");
    let order: Vec<usize> = (0..61).map(|i| i * 37 % 61).collect();
    let shuffled: Vec<Trajectory<'_>> = order.iter().map(|i| list[*i]).collect();
    for (i, outcome) in order.iter().zip(lanes::<4, _>(&Pendulum, &plan, &shuffled)) {
        assert_eq!(four[*i], outcome, "shuffled");
    }
}

#[test]
fn methods_that_are_not_had_in_lanes_are_refused() {
    let starts = pendulums(2);
    for method in [Method::Taylor, Method::Gauss6, Method::Ode45] {
        let refused =
            batch::integrate_batch(InLanes::of_rates(&Pendulum), &plan(method, 1.0, 1e-6), &trajectories(&starts));
        assert!(matches!(refused, Err(SimError::NoLanes { .. })), "{method:?}: {refused:?}");
    }
}

/// Events of a pendulum: the top, which ends the run; its bottom, which is recorded; a speed limit as its domain.
fn events<'a>(limit: f64) -> Vec<Event<'a>> {
    let top = Event::terminal("top", Direction::Rising, |_t, y: &[f64]| y[0] - 3.0);
    let bottom = Event::recorded("bottom", Direction::Either, |_t, y: &[f64]| y[0]).with_ranges(|_t, y| y[0]);
    let up = Event { effect: Effect::Domain, ..Event::domain("slow", move |_t, y| limit - y[1]) };
    vec![top, bottom, up]
}

fn watched_alone(plan: &BatchPlan, limit: f64, parameters: &[f64], start: &[f64]) -> Solution {
    let rhs = Alone { equations: &Pendulum, parameters, divisor: None };
    integrate(rhs, plan.span, start, &plan.options(), &mut events(limit)).unwrap()
}

/// Goal: the watcher of a lane sees the same as in a run alone. Method: events that end, that are recorded, that are a
/// domain, by both methods. Stops and records are the same, instants to 1e-8, as the tolerance of 1e-10 leaves them
/// where a pendulum is slow.
#[test]
fn what_watches_a_lane_sees_a_run_alone() {
    let starts = pendulums(40);
    let mut stops = std::collections::BTreeMap::new();
    for method in [Method::Dop853, Method::Taylor] {
        let plan = plan(method, 6.0, 1e-10);
        let limit = |i: usize| if i.is_multiple_of(5) { 3.0 } else { 100.0 };
        let watching = |i: usize| {
            let rhs = Alone { equations: &Pendulum, parameters: &starts[i].0, divisor: None };
            WatchedTrajectory { equations: Box::new(rhs), events: events(limit(i)) }
        };
        let equations = Equations::<4> { rates: &Pendulum, series: Some(&Pendulum) };
        let outcomes = batch::integrate_in_lanes(equations, &plan, &trajectories(&starts), Some(&watching)).unwrap();
        for (i, (start, outcome)) in starts.iter().zip(&outcomes).enumerate() {
            let run = watched_alone(&plan, limit(i), &start.0, &start.1);
            assert_eq!((&outcome.stop, outcome.steps), (&run.stop, run.steps), "{method:?} {start:?}");
            *stops.entry(run.stop.code().split(':').next().unwrap().to_owned()).or_insert(0) += 1;
            let near = |a: f64, b: f64| (a - b).abs() < 1e-8;
            assert!(near(outcome.t_end, run.t_end), "{method:?} {start:?}");
            assert!(outcome.y_end.iter().zip(&run.y_end).all(|(a, b)| near(*a, *b)), "{method:?} {start:?}");
            assert_eq!(outcome.events.len(), run.events.len(), "{method:?} {start:?}");
            for (a, b) in outcome.events.iter().zip(&run.events) {
                assert!((&a.name, a.kind, a.terminal) == (&b.name, b.kind, b.terminal) && near(a.t, b.t));
            }
        }
    }
    // Each way to end was met.
    for stop in ["end", "event", "domain"] {
        assert!(stops.get(stop).is_some_and(|count| *count >= 2), "{stop}: {stops:?}");
    }
}

/// Goal: no lane goes over a place where its equations have no value. Method: points that come to q = 0 from both
/// sides, of which several turn before, beside runs alone.
#[test]
fn a_lane_whose_divisor_changes_its_sign_ends_there() {
    let start = |i: usize| (vec![], vec![[-1.0, 0.8][i % 2], -1.21 + 0.05 * i as f64]);
    let (starts, plan): (Starts, BatchPlan) = ((0..34).map(start).collect(), plan(Method::Dop853, 10.0, 1e-6));
    let alone = || Alone { equations: &Point, parameters: &[], divisor: Some(|y| y[0]) };
    let watching = |_: usize| WatchedTrajectory { equations: Box::new(alone()), events: Vec::new() };
    let equations = Equations::<4> { rates: &Point, series: None };
    let outcomes = batch::integrate_in_lanes(equations, &plan, &trajectories(&starts), Some(&watching)).unwrap();
    let mut stops = [0, 0];
    for ((_, start), outcome) in starts.iter().zip(outcomes) {
        let run = integrate(alone(), plan.span, start, &plan.options(), &mut []).unwrap();
        assert_eq!(outcome.stop.is_failure(), run.stop.is_failure(), "{start:?}: {:?} {:?}", outcome.stop, run.stop);
        assert!((outcome.t_end - run.t_end).abs() < 1e-6, "{start:?}: {} {}", outcome.t_end, run.t_end);
        assert!(outcome.y_end[0] * start[0] >= -1e-9, "{start:?} went over: {:?}", outcome.y_end);
        stops[usize::from(run.stop.is_failure())] += 1;
    }
    assert!(stops[0] >= 4 && stops[1] >= 4, "{stops:?}");
}

/// Watching changes no step: an event that never comes leaves the outcome as it is, all bits of it.
#[test]
fn watching_changes_no_bit() {
    let starts = pendulums(13);
    for method in [Method::Dop853, Method::Taylor] {
        let plan = plan(method, 4.0, 1e-8);
        let watching = |i: usize| WatchedTrajectory {
            equations: Box::new(Alone { equations: &Pendulum, parameters: &starts[i].0, divisor: None }),
            events: vec![Event::terminal("never", Direction::Either, |_t, y: &[f64]| 100.0 + y[0])],
        };
        let equations = Equations::<4> { rates: &Pendulum, series: Some(&Pendulum) };
        let watched = batch::integrate_in_lanes(equations, &plan, &trajectories(&starts), Some(&watching)).unwrap();
        for (watched, plain) in watched.iter().zip(lanes::<4, _>(&Pendulum, &plan, &trajectories(&starts))) {
            assert_eq!((watched.t_end, &watched.y_end, watched.steps), (plain.t_end, &plain.y_end, plain.steps));
        }
    }
}
