//! Properties of Radau IIA alone: stability, stiff problems of the literature, its error estimate and Newton's method.
#![allow(clippy::unnecessary_wraps, reason = "the signature of a right-hand side")]

use crate::stiff::Stiff;
use tripos_sim::{
    AbsoluteTolerance, Direction, Event, Failure, LentRightHandSide, Method, Options, OutputOption, RightHandSide,
    Solution, Stop, WithJacobian, integrate,
};
use tripos_traits::{DoubleDouble, Real, Scalar};

/// y' = λ y with λ = a + i b, as a real system.
fn turning(a: f64, b: f64) -> impl RightHandSide<f64> {
    let rhs = move |_t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt.copy_from_slice(&[a * y[0] - b * y[1], b * y[0] + a * y[1]]);
        Ok(())
    };
    let jacobian = move |_t: f64, _y: &[f64], out: &mut [f64]| {
        out.copy_from_slice(&[a, -b, b, a]);
        Ok(())
    };
    WithJacobian { rhs, jacobian }
}

fn fixed(step: f64) -> Options {
    Options { method: Method::Radau5, step: Some(step), output: OutputOption::Ends, ..Options::default() }
}

fn adaptive(rtol: f64, atol: impl Into<AbsoluteTolerance>) -> Options {
    Options { method: Method::Radau5, output: OutputOption::Ends, ..Options::tolerances(rtol, atol) }
}

/// A run whose right-hand side is known by its table alone: each type of one would compile all methods anew.
fn ran(
    mut rhs: impl RightHandSide<f64>,
    span: f64,
    y0: &[f64],
    options: &Options,
    events: &mut [Event<'_>],
) -> Solution {
    integrate(LentRightHandSide(&mut rhs as &mut dyn RightHandSide<f64>), (0.0, span), y0, options, events).unwrap()
}

/// One step of length 1: R(λ), as (re, im).
fn amplification(a: f64, b: f64) -> (f64, f64) {
    let run = ran(turning(a, b), 1.0, &[1.0, 0.0], &fixed(1.0), &mut []);
    assert_eq!((run.stop, run.steps), (Stop::End, 1), "{a} {b}");
    (run.y_end[0], run.y_end[1])
}

fn times((a, b): (f64, f64), (c, d): (f64, f64)) -> (f64, f64) {
    (a * c - b * d, a * d + b * c)
}

/// The Padé approximant with degrees 2 and 3: (1 + 2/5 z + z²/20) / (1 − 3/5 z + 3/20 z² − z³/60).
fn stability_function(a: f64, b: f64) -> (f64, f64) {
    let z = (a, b);
    let polynomial = |coefficients: &[f64]| {
        coefficients.iter().rev().fold((0.0, 0.0), |sum, c| {
            let (re, im) = times(sum, z);
            (re + c, im)
        })
    };
    let (up, (re, im)) = (polynomial(&[1.0, 2.0 / 5.0, 1.0 / 20.0]), polynomial(&[1.0, -0.6, 3.0 / 20.0, -1.0 / 60.0]));
    let size = re * re + im * im;
    times(up, (re / size, -im / size))
}

/// Goal: the steps are those of Radau IIA, A- and L-stable. Method: its stability function over the left half of the
/// plane, |R(iy)| ≤ 1 along the axis, and R → 0. 1e-13: Newton's method ends at rounding.
#[test]
fn steps_have_the_stability_function_of_radau_iia() {
    for size in [1e-3, 0.1, 1.0, 5.0, 20.0, 300.0, 1e6] {
        for turn in 0..=8 {
            let angle = std::f64::consts::PI * (0.5 + f64::from(turn) / 8.0);
            let (a, b) = ((size * angle.cos()).min(0.0), size * angle.sin());
            let (found, right) = (amplification(a, b), stability_function(a, b));
            let apart = (found.0 - right.0).hypot(found.1 - right.1);
            assert!(apart < 1e-13, "{a} {b}: {found:?} {right:?}");
            assert!(found.0.hypot(found.1) <= 1.0 + 1e-14, "{a} {b}: {found:?}");
        }
    }
    // R(z) is −3/z far out.
    let (far, _) = amplification(-1e12, 0.0);
    assert!((far * 1e12 - 3.0).abs() < 1e-2, "{far:e}");
}

fn solved(problem: &Stiff<f64>, rtol: f64) -> Solution {
    let atol: Vec<f64> = problem.sizes.iter().map(|size| size * rtol).collect();
    let run = ran(problem, problem.span, &problem.start(), &adaptive(rtol, atol), &mut []);
    assert_eq!(run.stop, Stop::End, "{}: {run}", problem.name);
    assert!(run.warnings.is_empty(), "{}: {:?}", problem.name, run.warnings);
    run
}

/// Goal: errors follow the tolerance, and steps are as few as those of the method elsewhere. Method: published
/// solutions; SciPy 1.17's Radau takes 311, 181 and 75 steps at 1e-4, and 2 749, 1 600 and 635 at 1e-8, which it reads
/// as a tolerance of the estimate.
#[test]
fn stiff_problems_end_where_they_are_published_to() {
    for (problem, most) in Stiff::all().iter().zip([[311, 2_749], [181, 1_600], [75, 635]]) {
        for (rtol, most) in [1e-4, 1e-8].into_iter().zip(most) {
            let run = solved(problem, rtol);
            let error = problem.error(&run.y_end);
            assert!(error < 10.0 * rtol, "{} at {rtol:e}: {error:e}", problem.name);
            assert!(run.steps + run.rejected <= most, "{} at {rtol:e}: {run}", problem.name);
            // A Jacobian serves several steps where it can, and never more than one is made for an attempt.
            assert!(run.jacobians <= run.steps + run.rejected, "{}: {}", problem.name, run.jacobians);
        }
        let finest = problem.error(&solved(problem, 1e-13).y_end);
        assert!(finest < 1e-11, "{}: {finest:e}", problem.name);
    }
}

/// Goal: 32 digits are of use. Method: HIRES against its 16 published digits, which end at 2.6e-15 of what is found at
/// tolerances of 1e-15 and finer; and e^(−1) to 22.
#[test]
fn a_wider_scalar_is_not_limited_by_the_rounding_of_f64() {
    let [_, _, problem] = Stiff::<DoubleDouble>::all();
    let atol: Vec<f64> = problem.sizes.iter().map(|size| size * 1e-16).collect();
    let run = integrate(&problem, (0.0, problem.span), &problem.start(), &adaptive(1e-16, atol), &mut []).unwrap();
    assert_eq!(run.stop, Stop::End);
    let error = problem.error(&run.y_end);
    assert!(error < 4e-15, "{error:e} {run}");

    let rhs = |_t: f64, y: &[DoubleDouble], dydt: &mut [DoubleDouble]| {
        dydt[0] = -y[0];
        Ok(())
    };
    let jacobian = |_t: f64, _y: &[DoubleDouble], out: &mut [DoubleDouble]| {
        out[0] = DoubleDouble::int(-1);
        Ok(())
    };
    let decay = WithJacobian { rhs, jacobian };
    let run = integrate(decay, (0.0, 1.0), &[DoubleDouble::int(1)], &adaptive(1e-22, 1e-22), &mut []).unwrap();
    let error = (run.y_end[0] - DoubleDouble::int(-1).exp()).to_f64().abs();
    assert!(error < 1e-22, "{error:e} {run}");
}

/// Prothero and Robinson's equation, y' = λ (y − φ) + φ' with φ = sin(t + 1), from φ: y = φ however large −λ is.
fn prothero_robinson(rate: f64) -> impl RightHandSide<f64> {
    let rhs = move |t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt[0] = rate * (y[0] - (t + 1.0).sin()) + (t + 1.0).cos();
        Ok(())
    };
    let jacobian = move |_t: f64, _y: &[f64], out: &mut [f64]| {
        out[0] = rate;
        Ok(())
    };
    WithJacobian { rhs, jacobian }
}

/// The order seen between two steps.
fn order(rate: f64, step: f64) -> f64 {
    let error = |h: f64| {
        let run = ran(prothero_robinson(rate), 2.0, &[1.0_f64.sin()], &fixed(h), &mut []);
        (run.y_end[0] - 3.0_f64.sin()).abs()
    };
    (error(step) / error(step / 2.0)).log2()
}

/// Goal: the order is known also for stiff equations. Method: A. Prothero & A. Robinson, Math. Comp. 28 (1974) 145: the
/// order is 5 where h λ is small. Where h λ is large, the error is that of the stages over λ, h³/|λ| at a step, and is
/// not carried on (Hairer & Wanner II, §IV.15).
#[test]
fn order_five_comes_down_to_three_where_equations_are_stiff() {
    for (rate, step, expected) in [(-1.0, 0.25, 5.0), (-1e6, 0.05, 3.0)] {
        let found = order(rate, step);
        assert!((found - expected).abs() < 0.2, "{rate}: {found}");
    }
}

/// x'' = −k (x − sin t) − 2 ζ √k x': a damped spring of 1 kg whose end is driven.
fn damped(k: f64, zeta: f64) -> impl RightHandSide<f64> {
    let c = 2.0 * zeta * k.sqrt();
    let rhs = move |t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt.copy_from_slice(&[y[1], -k * (y[0] - t.sin()) - c * y[1]]);
        Ok(())
    };
    let jacobian = move |_t: f64, _y: &[f64], out: &mut [f64]| {
        out.copy_from_slice(&[0.0, 1.0, -k, -c]);
        Ok(())
    };
    WithJacobian { rhs, jacobian }
}

/// Its steady motion a sin t + b cos t, the slow manifold, from a (k − 1) − b c = k and a c + b (k − 1) = 0.
fn steady(k: f64, zeta: f64, t: f64) -> [f64; 2] {
    let (c, d) = (2.0 * zeta * k.sqrt(), k - 1.0);
    let size = d * d + c * c;
    let (a, b) = (k * d / size, -k * c / size);
    [a * t.sin() + b * t.cos(), a * t.cos() - b * t.sin()]
}

/// Goal: steps are bounded however stiff a spring is, and errors stay near the tolerance. Method: the steady motion of
/// a critically damped spring of 1 to 1e12 N/m; DOP853 takes 73 557 steps at 1e8, and 3 282 140 at 1e12. Speeds, whose
/// equations are those of index 3 in the limit, have errors up to 20 times the tolerance; places stay within it.
#[test]
fn a_spring_of_any_stiffness_takes_some_hundred_steps() {
    let off = |run: &Solution, end: [f64; 2]| [0, 1].map(|i| (run.y_end[i] - end[i]).abs());
    for k in (0..=12).map(|exponent| 10_f64.powi(exponent)) {
        let (start, end) = (steady(k, 1.0, 0.0), steady(k, 1.0, 10.0));
        let implicit = ran(damped(k, 1.0), 10.0, &start, &adaptive(1e-8, 1e-8), &mut []);
        let [place, speed] = off(&implicit, end);
        assert!(place < 1e-8 && speed < 5e-7, "{k:e}: {place:e} {speed:e}");
        assert!(implicit.stop == Stop::End && implicit.steps + implicit.rejected < 550, "{k:e}: {implicit}");
    }
    let explicit = Options { method: Method::Dop853, ..adaptive(1e-8, 1e-8) };
    let explicit = ran(damped(1e8, 1.0), 10.0, &steady(1e8, 1.0, 0.0), &explicit, &mut []);
    assert!(explicit.steps > 50_000, "{explicit}");
}

/// An event in the middle of a transient and one long after it, beside their closed forms: x = e^(−1000 t) + t.
#[test]
fn events_are_met_within_a_transient_and_after_it() {
    let rhs = |t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt[0] = -1e3 * (y[0] - t) + 1.0;
        Ok(())
    };
    let jacobian = |_t: f64, _y: &[f64], out: &mut [f64]| {
        out[0] = -1e3;
        Ok(())
    };
    let half = Event::recorded("half", Direction::Either, |_t, y: &[f64]| y[0] - 0.5);
    let options = adaptive(1e-10, 1e-10);
    let run = ran(WithJacobian { rhs, jacobian }, 1.0, &[1.0], &options, &mut [half]);
    let times: Vec<f64> = run.events.iter().map(|event| event.t).collect();
    assert_eq!(times.len(), 2, "{times:?}");
    // e^(−1000 t) + t = 1/2 by three steps of Newton's method from ln 2/1000.
    let mut early = 2_f64.ln() / 1e3;
    for _ in 0..3 {
        early -= ((-1e3 * early).exp() + early - 0.5) / (1.0 - 1e3 * (-1e3 * early).exp());
    }
    assert!((times[0] - early).abs() < 1e-8 && (times[1] - 0.5).abs() < 1e-8, "{times:?} {early}");
}

/// y' = −1000 y with a Jacobian of the wrong sign.
fn wrong_jacobian() -> impl RightHandSide<f64> {
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt[0] = -1e3 * y[0];
        Ok(())
    };
    let jacobian = |_t: f64, _y: &[f64], out: &mut [f64]| {
        out[0] = 1e3;
        Ok(())
    };
    WithJacobian { rhs, jacobian }
}

#[test]
fn steps_that_newton_cannot_solve_are_shortened_or_end_the_run() {
    let run = ran(wrong_jacobian(), 1.0, &[1.0], &fixed(0.1), &mut []);
    assert!(matches!(run.stop, Stop::NotConverged { .. }) && run.steps == 0, "{run}");
    let options = Options { initial_step: Some(0.01), ..adaptive(1e-6, 1e-9) };
    let run = ran(wrong_jacobian(), 0.01, &[1.0], &options, &mut []);
    assert!(run.stop == Stop::End && run.rejected > 0, "{run}");
    assert!((run.y_end[0] - (-10_f64).exp()).abs() < 1e-6, "{:?}", run.y_end);
}

/// A Jacobian for which γ/h − J is singular at the first step, γ = 3.637…: a shorter step is not, and the run goes on.
#[test]
fn a_singular_matrix_shortens_the_step() {
    let gamma = 3.0 + 3_f64.powf(2.0 / 3.0) - 3_f64.cbrt();
    let h = 0.125;
    let rhs = |_t: f64, _y: &[f64], dydt: &mut [f64]| {
        dydt.copy_from_slice(&[1.0, 0.0]);
        Ok(())
    };
    // The rows of γ/h − J are opposite, but for rounding.
    let jacobian = move |_t: f64, _y: &[f64], out: &mut [f64]| {
        out.copy_from_slice(&[gamma / h - 1.0, 1.0, 1.0, gamma / h - 1.0]);
        Ok(())
    };
    let run = ran(WithJacobian { rhs, jacobian }, h, &[0.0, 0.0], &fixed(h), &mut []);
    assert!(matches!(run.stop, Stop::NotConverged { .. } | Stop::End), "{run}");
    let options = Options { initial_step: Some(h), ..adaptive(1e-6, 1e-9) };
    let run = ran(WithJacobian { rhs, jacobian }, 1.0, &[0.0, 0.0], &options, &mut []);
    assert!(run.stop == Stop::End && (run.y_end[0] - 1.0).abs() < 1e-6, "{run}");
}

/// A state without components, and a component that rests at 0 without any absolute tolerance.
#[test]
fn what_rests_needs_no_tolerance_and_nothing_is_no_trouble() {
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt.copy_from_slice(&[0.0, -y[1]]);
        Ok(())
    };
    let jacobian = |_t: f64, _y: &[f64], out: &mut [f64]| {
        out.copy_from_slice(&[0.0, 0.0, 0.0, -1.0]);
        Ok(())
    };
    let run = ran(WithJacobian { rhs, jacobian }, 1.0, &[0.0, 1.0], &adaptive(1e-8, 0.0), &mut []);
    assert!(run.stop == Stop::End && (run.y_end[1] - (-1_f64).exp()).abs() < 1e-8 && run.y_end[0] == 0.0, "{run}");
    let nothing = |_t: f64, _y: &[f64], _out: &mut [f64]| Ok(());
    let run = ran(WithJacobian { rhs: nothing, jacobian: nothing }, 1.0, &[], &adaptive(1e-8, 1e-8), &mut []);
    assert_eq!(run.stop, Stop::End);
}

/// A Jacobian that fails, or is not finite, ends the run with that reason.
#[test]
fn a_jacobian_without_a_value_ends_the_run_with_its_own_reason() {
    for (entry, code) in [(f64::NAN, "not-finite"), (1.0, "singular")] {
        let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
            dydt[0] = y[0];
            Ok(())
        };
        let jacobian = move |_t: f64, _y: &[f64], out: &mut [f64]| {
            out[0] = entry;
            let failure = Failure { code: "singular", message: "no derivative".to_owned() };
            if entry.is_nan() { Ok(()) } else { Err(failure) }
        };
        let run = ran(WithJacobian { rhs, jacobian }, 1.0, &[1.0], &adaptive(1e-6, 1e-6), &mut []);
        assert_eq!((run.stop.code().as_str(), run.steps), (code, 0));
    }
}
