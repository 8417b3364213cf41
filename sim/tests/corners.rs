//! Steps that end where the right-hand side has a corner or a jump.
//!
//! Truth: polynomials between corners, which every method here integrates exactly.

use crate::lent::integrate;
use tripos_sim::{Corner, Method, Options, OutputOption, SimError};
use tripos_traits::{DoubleDouble, Real, Scalar, Tangent};

/// y' = |t − 1| + 3 sign(t − 2.5), of which this is the integral from 0.
fn truth(t: f64) -> f64 {
    let bend = |t: f64| (t - 1.0) * (t - 1.0).abs() / 2.0;
    bend(t) + 0.5 + 3.0 * ((t - 2.5).abs() - 2.5)
}

fn run(method: Method, span: (f64, f64), corners: &[f64]) -> tripos_sim::Solution {
    let slope = |t: f64, _: &[f64], dydt: &mut [f64]| {
        dydt[0] = (t - 1.0).abs() + 3.0 * (t - 2.5).signum();
        Ok(())
    };
    let output = OutputOption::Steps { refine: 3 };
    let options = Options {
        method,
        corners: corners.iter().map(|at| Corner::jump(*at)).collect(),
        output,
        max_step: Some(4.0),
        ..Options::tolerances(1e-6, 1e-6)
    };
    integrate(slope, span, &[truth(span.0)], &options, &mut []).unwrap()
}

#[test]
fn steps_end_at_corners() {
    for method in [Method::Ode45, Method::Dopri5, Method::Dop853] {
        for span in [(0.0, 4.0), (4.0, 0.0), (1.0, 2.5), (2.5, 4.0), (0.5, 0.75)] {
            // Those outside, at the ends and twice say nothing; an ulp from each other they are one.
            let corners = [2.5, 1.0, -3.0, 7.0, 1.0_f64.next_up(), 0.0, 2.5, 4.0];
            let run = run(method, span, &corners);
            let inside = |t: f64| (t - span.0) * (t - span.1) < 0.0;
            for corner in [1.0, 2.5].into_iter().filter(|t| inside(*t)) {
                assert!(run.t.iter().any(|t| (t - corner).abs() < 1e-15), "{method:?} {span:?}: {:?}", run.t);
            }
            for (t, y) in run.t.iter().zip(&run.y) {
                assert!((y[0] - truth(*t)).abs() < 1e-13, "{method:?} {span:?}: {t}, {}", y[0] - truth(*t));
            }
            assert_eq!((run.t_end, run.rejected), (span.1, 0), "{method:?} {span:?}");
        }
    }
}

/// The time as a component of the state, in numbers of 32 digits: a jump is as exact as they are.
#[test]
fn a_clock_in_the_state_is_kept_to_its_side() {
    let slope = |_: f64, y: &[DoubleDouble], dydt: &mut [DoubleDouble]| {
        dydt[0] = DoubleDouble::from_f64((y[1].to_f64() - 2.5).signum());
        dydt[1] = DoubleDouble::from_f64(1.0);
        Ok(())
    };
    let corners = vec![Corner::jump(2.5)];
    let options = Options { method: Method::Dop853, corners, clock: Some(1), ..Options::tolerances(1e-24, 1e-24) };
    let run = integrate(slope, (0.0, 4.0), &[DoubleDouble::from_f64(0.0); 2], &options, &mut []).unwrap();
    let error = (run.y_end[0] - DoubleDouble::from_f64(-1.0)).to_f64();
    assert!(error.abs() < 1e-28 && run.rejected == 0, "{error:e}, {}", run.rejected);
    let wrong = Options { clock: Some(2), ..options };
    let error = integrate(slope, (0.0, 4.0), &[DoubleDouble::from_f64(0.0); 2], &wrong, &mut []).unwrap_err();
    assert!(error.to_string().contains("clock"), "{error}");
}

/// A known bend is crossed with the error of rounding, and with less work than an unknown one. The steps after it are
/// as long as before.
#[test]
fn bends_cost_nothing() {
    let slope = |t: f64, _: &[f64], dydt: &mut [f64]| {
        dydt[0] = (t - 1.0).abs() + (t - 1.3).abs();
        Ok(())
    };
    let truth = |t: f64| {
        let bend = |a: f64| (t - a) * (t - a).abs() / 2.0 + a * a / 2.0;
        bend(1.0) + bend(1.3)
    };
    for method in [Method::Ode45, Method::Dopri5, Method::Dop853] {
        let bend = |at| Corner::kink(at);
        let [told, not] = [vec![bend(1.0), bend(1.3)], Vec::new()].map(|corners| {
            let options = Options { method, corners, ..Options::tolerances(1e-10, 1e-10) };
            integrate(slope, (0.0, 20.0), &[0.0], &options, &mut []).unwrap()
        });
        assert!((told.y_end[0] - truth(20.0)).abs() < 1e-12, "{method:?}: {}", told.y_end[0] - truth(20.0));
        assert!(told.rejected == 0 && not.rejected > 0 && told.steps < not.steps, "{method:?}");
    }
}

#[test]
fn corners_that_are_no_instants() {
    let options = Options { corners: vec![Corner::kink(f64::NAN)], ..Options::default() };
    let slope = |_: f64, _: &[f64], dydt: &mut [f64]| {
        dydt[0] = 0.0;
        Ok(())
    };
    let error = integrate(slope, (0.0, 1.0), &[0.0], &options, &mut []).unwrap_err();
    assert!(
        matches!(error, SimError::NotFinite { .. }) && error.to_string().contains("the corner at NaN s"),
        "{error}"
    );
}

/// Goal: slopes jump where a jump moves, and bend where a bend does, also where steps end exactly at both. Truth: y' =
/// 3 sign(t − T) + |t − B| from 0 has y = 3 |t − T| − 3 T + …, dy/dT = −6 from T on, and dy/dB = B − (t − B) from B on,
/// t before. A sample at T has the slope after it.
#[test]
fn slopes_jump_where_jumps_move_and_bend_where_bends_do() {
    let at = [Tangent { value: 2.5, slopes: [1.0, 0.0] }, Tangent { value: 1.25, slopes: [0.0, 1.0] }];
    let slope = |_: f64, y: &[Tangent<2>], dydt: &mut [Tangent<2>]| {
        dydt[0] = Tangent::from_f64(3.0) * (y[1] - at[0]).sign() + (y[1] - at[1]).abs();
        dydt[1] = Tangent::from_f64(1.0);
        Ok(())
    };
    let corners = vec![
        Corner { at: 2.5, jumps: true, moves: [1.0, 0.0, 0.0, 0.0] },
        Corner { at: 1.25, jumps: false, moves: [0.0, 1.0, 0.0, 0.0] },
    ];
    for method in [Method::Ode45, Method::Dopri5, Method::Dop853] {
        for output in [OutputOption::Steps { refine: 2 }, OutputOption::At(vec![0.5, 1.25, 2.0, 2.5, 3.5])] {
            let options =
                Options { method, corners: corners.clone(), clock: Some(1), output, ..Options::tolerances(1e-9, 1e-9) };
            let run = integrate(slope, (0.0, 4.0), &[Tangent::from_f64(0.0); 2], &options, &mut []).unwrap();
            for (t, y) in run.t.iter().zip(&run.y).chain([(&run.t_end, &run.y_end)]) {
                let by_jump = if *t >= 2.5 { -6.0 } else { 0.0 };
                let by_bend = if *t > 1.25 { 1.25 - (t - 1.25) } else { *t };
                assert!((y[0].slopes[0] - by_jump).abs() < 1e-13, "{method:?} {t}: {:?}", y[0]);
                assert!((y[0].slopes[1] - by_bend).abs() < 1e-13, "{method:?} {t}: {:?}", y[0]);
            }
            assert!(run.t.contains(&2.5) && run.t.contains(&1.25));
        }
    }
}
