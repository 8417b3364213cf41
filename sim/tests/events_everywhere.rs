//! Events on solutions of no special kind: an oscillator, and polynomials drawn at random.
#![allow(clippy::float_cmp, reason = "exact answers are compared exactly")]

use crate::lent::integrate;
use tripos_sim::{Direction, Event, Failure, Kind, Method, Options, OutputOption};

#[allow(clippy::unnecessary_wraps, reason = "the signature of a right-hand side")]
fn oscillator(_t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
    dydt[0] = y[1];
    dydt[1] = -y[0];
    Ok(())
}

fn value(_t: f64, y: &[f64]) -> f64 {
    y[0]
}

/// Terminal event at the zeros of the first component, by samples or by ranges.
fn zero(in_ranges: bool) -> Event<'static> {
    let event = Event::terminal("zero", Direction::Either, value);
    if in_ranges { event.with_ranges(|_, y| y[0]) } else { event }
}

/// Goal: the event that ended a run does not end the run that goes on from there. Method: the zeros of cos t one by
/// one, at every pair of tolerances from 1e-3 to 1e-12. Tolerance: 1e3 times the tolerances, for 40 s.
#[test]
fn a_run_continued_from_its_terminal_event_does_not_meet_it_again() {
    for (r, a) in (3..=12).flat_map(|r| (3..=12).map(move |a| (r, a))) {
        let (rtol, atol) = (10_f64.powi(-r), 10_f64.powi(-a));
        for (method, in_ranges) in [Method::Ode45, Method::Dop853].into_iter().flat_map(|m| [(m, false), (m, true)]) {
            let options = Options { method, ..Options::tolerances(rtol, atol) };
            let (mut t, mut y) = (0.0, vec![1.0, 0.0]);
            for k in 0..12 {
                let solution = integrate(oscillator, (t, 100.0), &y, &options, &mut [zero(in_ranges)]).unwrap();
                (t, y) = (solution.t_end, solution.y_end);
                let exact = std::f64::consts::PI * (f64::from(k) + 0.5);
                let allowed = 1e3 * rtol.max(atol);
                assert!((t - exact).abs() < allowed.min(1.0), "{method:?} {rtol} {atol} {k}: {t} {exact}");
            }
        }
    }
}

#[test]
fn watching_does_not_change_the_steps() {
    let options = Options::default();
    let event = Event::recorded("zero", Direction::Either, value);
    let bare = integrate(oscillator, (0.0, 20.0), &[1.0, 0.0], &options, &mut []).unwrap();
    let in_ranges = Event::recorded("zero", Direction::Either, value).with_ranges(|_, y| y[0]);
    for event in [event, in_ranges] {
        let watched = integrate(oscillator, (0.0, 20.0), &[1.0, 0.0], &options, &mut [event]).unwrap();
        assert_eq!((&bare.t, &bare.y, bare.evaluations), (&watched.t, &watched.y, watched.evaluations));
        assert_eq!(watched.events.len(), 6); // zeros of cos t up to 20
    }
}

/// A generator of numbers in [0, 1): the same ones on every machine (Knuth's MMIX constants).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Goal: no crossing lost, none invented, wherever it falls in whatever step. Method: y = (t − a)
/// (t − b) (t − c) is integrated exactly; 2 000 triples of zeros at least 1e-3 apart and not all in
/// an eighth of a step, steps of 0.02 to 1, both directions of time. Tolerance: rounding of y, some
/// ε of its size 1, by its slope at the zero.
#[test]
fn every_zero_of_random_cubics_is_found_once_and_in_order() {
    let mut numbers = Numbers(1);
    for trial in 0..2_000 {
        let way = if trial % 2 == 0 { 1.0 } else { -1.0 };
        let mut zeros = [0.0; 3].map(|_| 0.001 + 0.998 * numbers.next());
        zeros.sort_by(f64::total_cmp);
        let [a, b, c] = zeros;
        let step = 0.02 + 0.98 * numbers.next();
        if b - a < 1e-3 || c - b < 1e-3 || c - a < step / 16.0 {
            continue;
        }
        let slope = |t: f64| (t - b) * (t - c) + (t - a) * (t - c) + (t - a) * (t - b);
        let rhs = |t: f64, _y: &[f64], dydt: &mut [f64]| {
            dydt[0] = way * slope(way * t);
            Ok(())
        };
        let options = Options {
            rtol: 1e3,
            max_step: Some(step),
            initial_step: Some(step),
            output: OutputOption::Ends,
            ..Options::default()
        };
        let mut events = [Event::recorded("zero", Direction::Either, value)];
        let solution = integrate(rhs, (0.0, way), &[-a * b * c], &options, &mut events).unwrap();
        let kinds: Vec<Kind> = solution.events.iter().map(|e| e.kind).collect();
        assert_eq!(kinds, [Kind::Rising, Kind::Falling, Kind::Rising], "{zeros:?} {step}");
        for (event, zero) in solution.events.iter().zip(zeros) {
            let error = (way * event.t - zero).abs() * slope(zero).abs();
            assert!(error < 8.0 * f64::EPSILON, "{zeros:?} {step}: {}", event.t);
        }
    }
}
