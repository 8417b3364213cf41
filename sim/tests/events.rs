//! Events on solutions that the method integrates exactly: polynomials in t of degree 4 and less.
//!
//! y' = p'(t), so that every dense output is p to rounding, and zeros of p are known exactly. Times
//! are compared to 1e-15 (zeros are simple, of slope and size near 1), touches to 1e-7 (a parabola
//! is flat to the root of rounding). Every case also runs backward in time, as p(−t) from 0 to
//! −span.
#![allow(clippy::float_cmp, reason = "exact answers are compared exactly")]

use crate::lent::integrate;
use tripos_sim::Kind::{AtStart, Falling, Rising, Touch};
use tripos_sim::{Direction, Event, Kind, Options, OutputOption, Solution, Stop};

/// A polynomial given by its zeros.
fn product(zeros: &[f64], t: f64) -> f64 {
    zeros.iter().map(|z| t - z).product()
}

fn derivative(zeros: &[f64], t: f64) -> f64 {
    (0..zeros.len())
        .map(|i| zeros.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, z)| t - z).product::<f64>())
        .sum()
}

/// Directions in time in which a run meets the polynomial: forward and backward.
const WAYS: [f64; 2] = [1.0, -1.0];

/// Equal steps of length `step` from 0 to `way` · `span`, s; `way` is 1 or −1.
#[derive(Clone, Copy)]
struct Steps {
    span: f64,
    step: f64,
    way: f64,
}

/// Runs y = scale · p(way · t) from 0 to way · span with steps of `step`, watching y itself.
fn watch(zeros: &[f64], scale: f64, steps: Steps, event: Event<'_>) -> Solution {
    let Steps { span, step, way } = steps;
    let rhs = |t: f64, _y: &[f64], dydt: &mut [f64]| {
        dydt[0] = scale * way * derivative(zeros, way * t);
        Ok(())
    };
    let options = Options {
        rtol: 1e3,
        max_step: Some(step),
        initial_step: Some(step),
        output: OutputOption::Steps { refine: 1 },
        ..Options::default()
    };
    let y0 = [scale * product(zeros, 0.0)];
    integrate(rhs, (0.0, way * span), &y0, &options, &mut [event]).unwrap()
}

fn value(_t: f64, y: &[f64]) -> f64 {
    y[0]
}

fn any() -> Event<'static> {
    Event::recorded("zero", Direction::Either, value)
}

fn last() -> Event<'static> {
    Event::terminal("zero", Direction::Either, value)
}

fn kinds(solution: &Solution) -> Vec<Kind> {
    solution.events.iter().map(|e| e.kind).collect()
}

fn assert_times(solution: &Solution, way: f64, expected: &[f64], tolerance: f64) {
    let times: Vec<f64> = solution.events.iter().map(|e| way * e.t).collect();
    assert_eq!(times.len(), expected.len(), "{times:?} {expected:?}");
    for (t, e) in times.iter().zip(expected) {
        assert!((t - e).abs() <= tolerance, "{times:?} {expected:?}");
    }
}

#[test]
fn crossings_of_both_directions_are_found_in_order() {
    for way in WAYS {
        let solution = watch(&[0.3, 0.7, 1.1], 1.0, Steps { span: 1.5, step: 0.25, way }, any());
        assert_eq!(kinds(&solution), [Rising, Falling, Rising]);
        assert_times(&solution, way, &[0.3, 0.7, 1.1], 1e-15);
        assert!(solution.events.iter().all(|e| e.y[0].abs() < 1e-15 && !e.terminal));
        assert_eq!(solution.stop, Stop::End);
    }
}

#[test]
fn a_direction_selects_crossings() {
    for way in WAYS {
        for (direction, times) in [
            (Direction::Rising, vec![0.3, 1.1]),
            (Direction::Falling, vec![0.7]),
            (Direction::Either, vec![0.3, 0.7, 1.1]),
        ] {
            let event = Event::recorded("zero", direction, value);
            let solution = watch(&[0.3, 0.7, 1.1], 1.0, Steps { span: 1.5, step: 0.25, way }, event);
            assert_times(&solution, way, &times, 1e-15);
        }
    }
}

#[test]
fn two_crossings_in_one_step_are_both_found() {
    // Down to a distance of 1e-6 of the step, wherever the pair lies in the step.
    for way in WAYS {
        for first in [0.011, 0.2, 0.499, 0.5, 0.62, 0.93, 0.99] {
            for gap in [0.3, 0.05, 1e-3, 1e-6] {
                let zeros = [first, first + gap];
                if zeros[1] < 1.0 {
                    let solution = watch(&zeros, 1.0, Steps { span: 1.0, step: 1.0, way }, any());
                    assert_eq!(solution.steps, 1);
                    assert_eq!(kinds(&solution), [Falling, Rising], "{zeros:?}");
                    // Rounding of y, some ε of its size 1, by the slope there, which is the gap.
                    assert_times(&solution, way, &zeros, 3e-15 / gap);
                }
            }
        }
    }
}

#[test]
fn the_first_of_two_crossings_in_one_step_ends_the_run() {
    for way in WAYS {
        let solution = watch(&[0.52, 0.53], 1.0, Steps { span: 1.0, step: 1.0, way }, last());
        assert_eq!(solution.stop, Stop::Event { name: "zero".into() });
        assert_times(&solution, way, &[0.52], 1e-13);
        assert!(solution.events[0].terminal);
        assert_eq!((solution.t.len(), solution.t[1]), (2, solution.t_end));
        assert_eq!((solution.events[0].t, &solution.events[0].y), (solution.t_end, &solution.y_end));
    }
}

#[test]
fn a_touch_is_recorded_and_ends_nothing() {
    for way in WAYS {
        for at in [0.1, 0.5, 0.51, 0.777, 0.999] {
            for scale in [1.0, -1.0] {
                let event = Event::terminal("zero", Direction::Falling, value);
                let solution = watch(&[at, at], scale, Steps { span: 1.0, step: 1.0, way }, event);
                assert_eq!(kinds(&solution), [Touch], "{at} {scale}");
                assert_times(&solution, way, &[at], 1e-7);
                assert_eq!((solution.stop, way * solution.t_end), (Stop::End, 1.0));
                assert!(!solution.events[0].terminal);
            }
        }
    }
}

#[test]
fn a_touch_at_the_end_of_a_step_is_recorded_once() {
    for way in WAYS {
        for step in [0.5, 0.25, 0.125] {
            let solution = watch(&[0.5, 0.5], 1.0, Steps { span: 1.0, step, way }, last());
            assert_eq!(kinds(&solution), [Touch], "{step}");
            assert_times(&solution, way, &[0.5], 1e-7);
            assert_eq!(solution.stop, Stop::End);
        }
    }
}

#[test]
fn passing_close_by_is_no_touch() {
    for way in WAYS {
        for distance in [1e-3, 1e-9, 1e-13] {
            let near = move |_t: f64, y: &[f64]| y[0] + distance;
            let event = Event::recorded("near", Direction::Either, near);
            let solution = watch(&[0.43, 0.43], 1.0, Steps { span: 1.0, step: 1.0, way }, event);
            assert_eq!(kinds(&solution), [], "{distance}");
        }
    }
}

/// Zeros at 0.25, 0.5 … are exact in binary, and are met by steps of 0.25 at their very ends.
#[test]
fn a_crossing_at_a_step_end_is_found_once_and_there() {
    for way in WAYS {
        for step in [0.125, 0.25, 0.5] {
            let solution = watch(&[0.5, 3.0], 1.0, Steps { span: 1.0, step, way }, any());
            assert_eq!(kinds(&solution), [Falling], "{step}");
            assert_times(&solution, way, &[0.5], 1e-15);
            let solution = watch(&[0.5, 3.0], 1.0, Steps { span: 1.0, step, way }, last());
            assert!((way * solution.t_end - 0.5).abs() < 1e-15, "{solution}");
            assert_eq!(solution.stop.code(), "event:zero");
        }
    }
}

#[test]
fn a_crossing_at_the_end_of_the_run_happens() {
    for way in WAYS {
        let solution = watch(&[1.0, 3.0], 1.0, Steps { span: 1.0, step: 0.25, way }, last());
        assert_eq!((kinds(&solution), way * solution.t_end), (vec![Falling], 1.0));
        assert_eq!(solution.stop.code(), "event:zero");
    }
}

#[test]
fn a_zero_at_the_start_is_recorded_and_ends_nothing_until_the_next_crossing() {
    for way in WAYS {
        // p = t (t − 0.6): leaves downward, comes back up.
        let solution = watch(&[0.0, 0.6], 1.0, Steps { span: 1.0, step: 0.25, way }, last());
        assert_eq!(kinds(&solution), [AtStart, Rising]);
        assert_times(&solution, way, &[0.0, 0.6], 1e-15);
        assert_eq!(solution.stop.code(), "event:zero");
        // Never again: to the end.
        let solution = watch(&[0.0], 1.0, Steps { span: 1.0, step: 0.25, way }, last());
        assert_eq!((kinds(&solution), solution.stop), (vec![AtStart], Stop::End));
    }
}

#[test]
fn a_crossing_soon_after_a_zero_at_the_start_is_found() {
    for way in WAYS {
        for soon in [1e-2, 1e-4, 1e-5] {
            let solution = watch(&[0.0, soon], 1.0, Steps { span: 1.0, step: 1.0, way }, last());
            assert_eq!(kinds(&solution), [AtStart, Rising], "{soon}");
            // Rounding of y, 1e-17 near the zeros, by the slope there, which is `soon`.
            assert_times(&solution, way, &[0.0, soon], 1e-17 / soon);
        }
    }
}

/// Three functions of one clock y = t in one step, listed against their order in time.
#[test]
fn events_of_one_step_come_in_order_of_time_and_end_with_the_terminal_one() {
    for way in WAYS {
        let rhs = |_t: f64, _y: &[f64], dydt: &mut [f64]| {
            dydt[0] = way;
            Ok(())
        };
        let at = |zero: f64| move |_t: f64, y: &[f64]| y[0] - zero;
        let mut events = [
            Event::recorded("late", Direction::Either, at(0.9)),
            Event::terminal("end", Direction::Rising, at(0.5)),
            Event::recorded("early", Direction::Either, at(0.1)),
            Event::recorded("together", Direction::Either, at(0.5)),
        ];
        let options = Options { max_step: Some(1.0), initial_step: Some(1.0), ..Options::default() };
        let solution = integrate(rhs, (0.0, way), &[0.0], &options, &mut events).unwrap();
        let names: Vec<&str> = solution.events.iter().map(|e| e.name.as_str()).collect();
        assert_eq!(names, ["early", "end", "together"]);
        assert_eq!(solution.steps, 1);
        assert!((way * solution.t_end - 0.5).abs() < 1e-15, "{solution}");
        assert_eq!(solution.t.last(), Some(&solution.t_end));
        assert!(solution.t.iter().all(|t| (t - solution.t_end) * way <= 0.0));
    }
}

#[test]
fn leaving_a_domain_ends_the_run_at_its_border() {
    for way in WAYS {
        let domain = Event::domain("N > 0", value);
        let solution = watch(&[0.4], -1.0, Steps { span: 1.0, step: 0.25, way }, domain);
        assert_eq!(solution.stop, Stop::LeftDomain { name: "N > 0".into() });
        assert!((way * solution.t_end - 0.4).abs() < 1e-15, "{solution}");
        assert!(!solution.stop.is_failure());
    }
}

#[test]
fn a_start_outside_the_domain_is_a_run_of_no_steps() {
    let solution = watch(&[0.4], 1.0, Steps { span: 1.0, step: 0.25, way: 1.0 }, Event::domain("N > 0", value));
    assert_eq!((solution.stop.code().as_str(), solution.steps), ("domain:N > 0", 0));
    assert_eq!((&solution.t, solution.evaluations), (&vec![0.0], 0));
    // What never held cannot hold no longer.
    assert_eq!(solution.stop, Stop::StartsOutside { name: "N > 0".into() });
    assert!(solution.stop.to_string().ends_with("`N > 0` does not hold there"), "{}", solution.stop);
}

#[test]
fn a_start_on_the_border_of_the_domain_is_watched_from_the_next_instant() {
    for way in WAYS {
        let out = watch(&[0.0], -1.0, Steps { span: 1.0, step: 0.25, way }, Event::domain("N", value));
        assert_eq!((out.stop.code().as_str(), out.t_end), ("domain:N", 0.0));
        assert_eq!(out.t, [0.0]);
        let into = watch(&[0.0, 0.8], -1.0, Steps { span: 1.0, step: 0.25, way }, Event::domain("N", value));
        assert!((way * into.t_end - 0.8).abs() < 1e-15, "{into}");
    }
}

#[test]
fn a_function_that_stays_at_zero_happens_when_it_arrives() {
    for way in WAYS {
        let flat = move |t: f64, _y: &[f64]| (0.5 - way * t).max(0.0);
        let event = Event::domain("contact", flat);
        let solution = watch(&[0.0], 1.0, Steps { span: 1.0, step: 0.25, way }, event);
        assert_eq!(solution.stop.code(), "domain:contact");
        assert!((way * solution.t_end - 0.5).abs() < 1e-15, "{solution}");
    }
}

/// A conserved quantity minus its start is rounding noise of either sign: one record, no crossings.
#[test]
fn rounding_noise_around_zero_is_not_a_crossing() {
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt[0] = 0.1 * y[1];
        dydt[1] = -0.1 * y[1];
        Ok(())
    };
    let event = Event::terminal("sum", Direction::Either, |_t, y: &[f64]| y[0] + y[1] - 1.0);
    let options = Options { max_step: Some(0.1), ..Options::default() };
    let solution = integrate(rhs, (0.0, 1.0), &[0.3, 0.7], &options, &mut [event]).unwrap();
    assert_eq!((kinds(&solution), solution.stop), (vec![AtStart], Stop::End));
}

#[test]
fn an_event_that_is_not_a_number_ends_the_run_before_it_unless_another_comes_first() {
    for way in WAYS {
        let root = move |t: f64, _y: &[f64]| 1.0 + (0.6 - way * t).sqrt();
        let event = Event::recorded("root", Direction::Either, root);
        let solution = watch(&[0.5], 1.0, Steps { span: 1.0, step: 0.25, way }, event);
        assert_eq!(solution.stop.code(), "event-not-a-number");
        assert_eq!((way * solution.t_end, solution.t.last()), (0.5, Some(&solution.t_end)));

        let before = move |t: f64, _y: &[f64]| (0.6 - way * t).sqrt() - 0.1_f64.sqrt();
        let event = Event::terminal("before", Direction::Falling, before);
        let solution = watch(&[2.0], 1.0, Steps { span: 1.0, step: 1.0, way }, event);
        assert_eq!(solution.stop.code(), "event:before");
        assert!((way * solution.t_end - 0.5).abs() < 1e-15, "{solution}");
    }
    let never = Event::recorded("never", Direction::Either, |_t, _y: &[f64]| f64::NAN);
    let solution = watch(&[0.5], 1.0, Steps { span: 1.0, step: 0.25, way: 1.0 }, never);
    assert_eq!((solution.stop.code().as_str(), solution.steps), ("event-not-a-number", 0));
}

#[test]
fn an_infinite_event_function_still_has_a_sign() {
    for way in WAYS {
        let pole = move |t: f64, _y: &[f64]| if way * t < 0.3 { f64::INFINITY } else { -1.0 };
        let solution = watch(&[2.0], 1.0, Steps { span: 1.0, step: 0.25, way }, Event::domain("pole", pole));
        assert!((way * solution.t_end - 0.3).abs() < 1e-15, "{solution}");
    }
}
