//! The exact solutions: against tabulated figures, against their equations of motion, and against their conserved
//! quantities.
//!
//! Figures marked *table* come from independent computations with elliptic functions at 40 digits. Derivatives are
//! central differences of order 8 in 32-digit arithmetic: with step h = 1e-5 s their error is about rate⁹ h⁸/630, and
//! rounding divided by h: 1e-21 for rates up to 100/s.

mod elliptic;
mod free_body;
mod free_symmetric_body;
mod heavy_top;
mod pendulum;
mod spherical_pendulum;

use tripos_traits::{DoubleDouble, Real, Scalar};

type Dd = DoubleDouble;

fn dd(text: &str) -> Dd {
    Dd::decimal(text)
}

fn assert_close(got: Dd, wanted: Dd, tolerance: f64, what: &str) {
    let scale = wanted.to_f64().abs().max(1.0);
    let error = (got - wanted).to_f64().abs() / scale;
    assert!(error <= tolerance, "{what}: {got} instead of {wanted}, off by {error:.1e}");
}

/// f′(t) by the central difference of order 8.
fn derivative(f: impl Fn(Dd) -> Dd, t: Dd) -> Dd {
    let h = dd("1e-5");
    let weights = [(1, Dd::ratio(4, 5)), (2, Dd::ratio(-1, 5)), (3, Dd::ratio(4, 105)), (4, Dd::ratio(-1, 280))];
    let sum = weights.iter().fold(Dd::int(0), |sum, &(k, weight)| {
        let step = h * Dd::int(k);
        sum + weight * (f(t + step) - f(t - step))
    });
    sum / h
}

/// Tolerance of a derivative.
const DERIVATIVE: f64 = 1e-20;
const INSTANTS: [&str; 6] = ["-3.1", "-0.4", "0.05", "0.7", "1.9", "12.3"];
