//! Warnings: a run that chases rounding or kinks says so, and one that does not is silent.

use crate::lent::integrate;
use tripos_sim::{Method, Options, OutputOption, Solution, Warning};

const ADAPTIVE: [Method; 3] = [Method::Ode45, Method::Dopri5, Method::Dop853];

fn options(method: Method, rtol: f64, atol: f64) -> Options {
    Options { method, output: OutputOption::Ends, step_limit: 20_000, ..Options::tolerances(rtol, atol) }
}

/// A circle of this radius.
fn oscillator(radius: f64, options: &Options) -> Solution {
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt[0] = y[1];
        dydt[1] = -y[0];
        Ok(())
    };
    integrate(rhs, (0.0, 10.0), &[radius, 0.0], options, &mut []).unwrap()
}

/// Numbers near 1e4 are 2e-12 apart: an error of 1e-13 cannot be told from rounding, one of 1e-9 can.
#[test]
fn an_absolute_tolerance_below_rounding_is_told_once() {
    for method in ADAPTIVE {
        let solution = oscillator(1e4, &options(method, 0.0, 1e-13));
        let [Warning::ToleranceBelowRounding { size, spacing, allowed, attempts, .. }] = solution.warnings[..] else {
            panic!("{method:?} {solution}: {:?}", solution.warnings);
        };
        assert!(size > 5e3 && size < 1.001e4 && spacing > 1e-12 && spacing < 3e-12, "{method:?} {size} {spacing}");
        assert!((allowed / 1e-13 - 1.0).abs() < 1e-12 && attempts >= 20);
        let text = solution.warnings[0].to_string();
        assert!(text.contains("apart, yet its error was to stay below 1.0e-13"), "{text}");
        for (radius, rtol, atol) in [(1e4, 0.0, 1e-9), (1.0, 0.0, 1e-13), (1e4, 1e-12, 1e-13)] {
            let quiet = oscillator(radius, &options(method, rtol, atol));
            assert!(quiet.warnings.is_empty(), "{method:?} {radius} {rtol} {atol}: {:?}", quiet.warnings);
        }
    }
}

/// A component that is large but moves uniformly decides no step, however fine its tolerance.
#[test]
fn a_large_component_that_decides_nothing_is_no_reason_to_warn() {
    for method in ADAPTIVE {
        let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
            dydt.copy_from_slice(&[y[1], -y[0], 1.0]);
            Ok(())
        };
        let solution = integrate(rhs, (0.0, 10.0), &[1.0, 0.0, 1e9], &options(method, 0.0, 1e-10), &mut []).unwrap();
        assert!(solution.warnings.is_empty(), "{method:?}: {:?}", solution.warnings);
    }
}

/// A number between −½ and ½ that has nothing to do with the ones before it.
fn noise(y: &[f64]) -> f64 {
    let mix = |h: u64, v: &f64| {
        let h = (h ^ v.to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        (h ^ (h >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9)
    };
    let hash = y.iter().fold(1, mix);
    ((hash ^ (hash >> 32)) >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
}

/// Goal: noise of 1e-7 in f is told where the tolerance asks for more, and only there. At 1e-6 it makes no difference.
#[test]
fn noise_in_the_equations_is_told_where_it_matters() {
    for method in ADAPTIVE {
        let run = |tolerance: f64| {
            let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
                dydt[0] = y[1];
                dydt[1] = -y[0] + 1e-7 * noise(y);
                Ok(())
            };
            integrate(rhs, (0.0, 2.0), &[1.0, 0.0], &options(method, tolerance, tolerance), &mut []).unwrap()
        };
        let noisy = run(1e-12);
        assert!(matches!(noisy.warnings[..], [Warning::NotSmooth { .. }]), "{method:?}: {:?}", noisy.warnings);
        assert!(noisy.warnings[0].to_string().contains("a shorter step did not make the error smaller"));
        assert!(run(1e-6).warnings.is_empty(), "{method:?}");
    }
}

/// A force that changes sign with the position: every passage through zero is a jump.
#[test]
fn jumps_in_the_equations_are_told() {
    for method in ADAPTIVE {
        let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
            dydt[0] = y[1];
            dydt[1] = -y[0].signum();
            Ok(())
        };
        let solution = integrate(rhs, (0.0, 200.0), &[1.0, 0.0], &options(method, 1e-8, 1e-8), &mut []).unwrap();
        assert!(matches!(solution.warnings[..], [Warning::NotSmooth { .. }]), "{method:?}: {:?}", solution.warnings);
    }
}

/// The stage at a tenth of the step is one that only the dense output of DOP853 has.
#[test]
fn a_gap_that_only_the_dense_output_meets_changes_no_step_and_is_told() {
    let run = |output: OutputOption| {
        let rhs = |t: f64, y: &[f64], dydt: &mut [f64]| {
            dydt[0] = if (t - 0.1).abs() < 1e-3 { f64::NAN } else { y[0] };
            Ok(())
        };
        let options = Options { method: Method::Dop853, step: Some(1.0), output, ..Options::default() };
        integrate(rhs, (0.0, 1.0), &[1.0], &options, &mut []).unwrap()
    };
    let (ends, inside) = (run(OutputOption::Ends), run(OutputOption::At(vec![0.5, 1.0])));
    assert_eq!((ends.y_end, ends.warnings), (inside.y_end.clone(), vec![]));
    assert_eq!(inside.warnings, [Warning::CoarseInside { t: 0.0 }]);
    // Hermite's cubic errs by the fourth derivative over 384.
    assert!((inside.y[0][0] - 0.5_f64.exp()).abs() < 3.0 / 384.0, "{:?}", inside.y);
}
