//! Parity with MATLAB's `ode45`, and how the driver treats a run's ends and tolerances.
#![allow(clippy::float_cmp, reason = "exact answers are compared exactly")]

use crate::lent::integrate;
use tripos_sim::{AbsoluteTolerance, Failure, Options, OutputOption, SimError, Solution, Stop, Warning};

/// The tolerances of MATLAB where nothing is said.
fn matlab() -> Options {
    Options::tolerances(1e-3, 1e-6)
}

type Result = std::result::Result<(), Failure>;

fn run(
    rhs: impl FnMut(f64, &[f64], &mut [f64]) -> Result,
    span: (f64, f64),
    y0: &[f64],
    options: &Options,
) -> Solution {
    integrate(rhs, span, y0, options, &mut []).unwrap()
}

#[allow(clippy::unnecessary_wraps, reason = "the signature of a right-hand side")]
fn van_der_pol(_t: f64, y: &[f64], dydt: &mut [f64]) -> Result {
    dydt[0] = y[1];
    dydt[1] = (1.0 - y[0] * y[0]) * y[1] - y[0];
    Ok(())
}

#[allow(clippy::unnecessary_wraps, reason = "the signature of a right-hand side")]
fn oscillator(_t: f64, y: &[f64], dydt: &mut [f64]) -> Result {
    dydt[0] = y[1];
    dydt[1] = -y[0];
    Ok(())
}

/// Counts printed by MATLAB R2019a for ode45(@(t,x) -2*x+t, [0 10], 0) with Stats on: "14
/// successful steps, 2 failed attempts, 97 function evaluations", and 57 output points.
/// mathworks.com/matlabcentral/answers/480688
#[test]
fn counts_of_a_linear_equation_are_those_of_matlab() {
    let rhs = |t: f64, x: &[f64], dxdt: &mut [f64]| {
        dxdt[0] = -2.0 * x[0] + t;
        Ok(())
    };
    let solution = run(rhs, (0.0, 10.0), &[0.0], &matlab());
    let counts = (solution.steps, solution.rejected, solution.evaluations);
    assert_eq!((counts, solution.t.len()), ((14, 2, 97), 57));
}

/// The mechanism behind the counts: the first step is 1 / (max |f0 / max(|y0|, atol/rtol)| / (0.8
/// rtol^(1/5))), and the last one ends exactly at the end.
#[test]
fn the_first_step_follows_from_the_slope_and_the_last_ends_exactly() {
    let options = Options { output: OutputOption::Steps { refine: 1 }, ..matlab() };
    let solution = run(van_der_pol, (0.0, 20.0), &[2.0, 0.0], &options);
    let expected = 0.8 * 1e-3_f64.powf(0.2) / (2.0 / 1e-3); // f0 = (0, -2), threshold 1e-3
    assert!((solution.t[1] / expected - 1.0).abs() < 1e-14, "{}", solution.t[1]);
    assert_eq!(solution.t_end, 20.0);
    assert_eq!((solution.stop.clone(), solution.t.len() as u64), (Stop::End, solution.steps + 1));
    assert_eq!(solution.evaluations, 1 + 6 * (solution.steps + solution.rejected));
}

#[test]
fn no_step_is_longer_than_a_tenth_of_the_span_or_as_told() {
    let longest = |max_step| {
        let output = OutputOption::Steps { refine: 1 };
        let options = Options { max_step, rtol: 0.1, output, ..matlab() };
        let t = run(oscillator, (0.0, 2.0), &[1.0, 0.0], &options).t;
        t.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max)
    };
    // The last step may be stretched by a tenth.
    assert!(longest(None) > 0.19 && longest(None) <= 0.22 + 1e-15, "{}", longest(None));
    assert!(longest(Some(0.03)) <= 0.033 + 1e-15, "{}", longest(Some(0.03)));
}

/// Ends of the steps of y' = 1, which has no error, but no value for t in `gap`.
fn step_ends(span: f64, initial: f64, max_step: f64, gap: std::ops::Range<f64>) -> Vec<f64> {
    let rhs = |t: f64, _y: &[f64], dydt: &mut [f64]| {
        dydt[0] = if gap.contains(&t) { f64::NAN } else { 1.0 };
        Ok(())
    };
    let output = OutputOption::Steps { refine: 1 };
    let options = Options { initial_step: Some(initial), max_step: Some(max_step), output, ..matlab() };
    run(rhs, (0.0, span), &[1.0], &options).t
}

#[test]
fn the_last_step_is_stretched_by_at_most_a_tenth() {
    let none = 9.0..9.0;
    assert_eq!(step_ends(1.375, 0.25, 0.25, none.clone()).last_chunk(), Some(&[1.0, 1.25, 1.375]));
    assert_eq!(step_ends(1.265_625, 0.25, 0.25, none).last_chunk(), Some(&[1.0, 1.265_625]));
}

#[test]
fn steps_without_error_grow_five_times_and_without_value_halve() {
    assert_eq!(step_ends(1.0, 1.0 / 128.0, 1.0, 9.0..9.0)[..4], [0.0, 1.0 / 128.0, 6.0 / 128.0, 31.0 / 128.0]);
    // Tried: 0.5 and 0.25, and in the second case 0.125.
    assert_eq!(step_ends(1.0, 0.5, 1.0, 0.126..0.5)[..2], [0.0, 0.125]);
    assert_eq!(step_ends(1.0, 0.5, 1.0, 0.12..0.5)[..2], [0.0, 0.0625]);
}

#[test]
fn output_does_not_change_the_steps() {
    let outputs = [
        OutputOption::Steps { refine: 4 },
        OutputOption::Steps { refine: 1 },
        OutputOption::At(vec![0.0, 0.001, 7.0, 7.0, 20.0]),
        OutputOption::Ends,
    ];
    let solutions = outputs.map(|output| run(van_der_pol, (0.0, 20.0), &[2.0, 0.0], &Options { output, ..matlab() }));
    for s in &solutions {
        assert_eq!((&s.y_end, s.steps), (&solutions[0].y_end, solutions[0].steps));
        assert_eq!(s.y.last(), Some(&s.y_end));
    }
    assert_eq!(solutions[2].t, [0.0, 0.001, 7.0, 7.0, 20.0]);
    assert_eq!(solutions[2].y[2], solutions[2].y[3]);
    assert_eq!(solutions[3].t, [0.0, 20.0]);
}

#[test]
fn refinement_divides_every_step_evenly() {
    let fine = run(oscillator, (0.0, 2.0), &[1.0, 0.0], &matlab());
    assert_eq!(fine.t.len() as u64, 4 * fine.steps + 1);
    for step in fine.t.windows(5).step_by(4) {
        let middle = 0.5 * (step[0] + step[4]);
        assert!((step[2] - middle).abs() < 1e-15, "{step:?}");
    }
    for (t, y) in fine.t.iter().zip(&fine.y) {
        assert!((y[0] - t.cos()).abs() < 2e-3, "{t}"); // twice the relative tolerance
    }
}

#[test]
fn forth_and_back_returns_to_the_start() {
    let options = Options { output: OutputOption::Ends, ..Options::tolerances(1e-10, 1e-12) };
    let forth = run(van_der_pol, (1.0, 4.0), &[2.0, 0.0], &options);
    let back = run(van_der_pol, (4.0, 1.0), &forth.y_end, &options);
    assert_eq!(back.t, [4.0, 1.0]);
    for (found, start) in back.y_end.iter().zip([2.0, 0.0]) {
        // Errors of 1e-10 a step grow by e^(∫ y² − 1) ≈ 1e4 backward in time, over some 100 steps.
        assert!((found - start).abs() < 1e-5, "{found} {start}");
    }
}

#[test]
fn a_relative_tolerance_below_rounding_is_raised_with_a_warning() {
    let options = Options { rtol: 1e-20, ..Options::default() };
    let raised = run(oscillator, (0.0, 0.1), &[1.0, 0.0], &options);
    let to = 100.0 * f64::EPSILON;
    assert_eq!(raised.warnings, [Warning::RtolRaised { from: 1e-20, to }]);
    let plain = run(oscillator, (0.0, 0.1), &[1.0, 0.0], &Options { rtol: to, ..options });
    assert_eq!((plain.warnings.len(), plain.y_end), (0, raised.y_end));
}

#[test]
fn either_tolerance_alone_controls_the_error() {
    let alone: [(f64, AbsoluteTolerance); 3] = [(0.0, 1e-9.into()), (1e-9, 0.0.into()), (0.0, vec![1e-9, 1e-9].into())];
    for (rtol, atol) in alone {
        let options = Options::tolerances(rtol, atol.clone());
        let solution = run(oscillator, (0.0, 1.0), &[1.0, 0.0], &options);
        assert_eq!(solution.stop, Stop::End);
        assert!(solution.steps < 100, "{}", solution.steps);
        assert!((solution.y_end[0] - 1_f64.cos()).abs() < 1e-8, "{rtol} {atol:?}");
    }
}

#[test]
fn questions_without_sense_are_refused() {
    let ask = |span, y0: &[f64], options: &Options| integrate(oscillator, span, y0, options, &mut []).unwrap_err();
    let fine = matlab();
    assert_eq!(ask((1.0, 1.0), &[1.0, 0.0], &fine), SimError::EmptySpan { t: 1.0 });
    for span in [(0.0, f64::NAN), (f64::INFINITY, 0.0), (-f64::MAX, f64::MAX)] {
        assert!(matches!(ask(span, &[1.0, 0.0], &fine), SimError::NotFinite { .. }));
    }
    assert!(matches!(ask((0.0, 1.0), &[1.0, f64::NAN], &fine), SimError::NotFinite { .. }));
    let each = Options { atol: vec![1.0; 3].into(), ..matlab() };
    assert!(matches!(ask((0.0, 1.0), &[1.0, 0.0], &each), SimError::Length { found: 3, .. }));
    for times in [vec![2.0], vec![-0.1], vec![0.5, 0.4], vec![f64::NAN]] {
        let at = Options { output: OutputOption::At(times), ..matlab() };
        assert!(matches!(ask((0.0, 1.0), &[1.0, 0.0], &at), SimError::OutputTime { .. }));
    }
    for options in [
        Options { output: OutputOption::Steps { refine: 0 }, ..matlab() },
        Options { max_step: Some(0.0), ..matlab() },
        Options { initial_step: Some(f64::NAN), ..matlab() },
    ] {
        assert!(matches!(ask((0.0, 1.0), &[1.0, 0.0], &options), SimError::Option { .. }));
    }
}
