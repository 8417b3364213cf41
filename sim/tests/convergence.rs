//! Every method converges at its order, inside its steps as well as at their ends, and in wider scalars too.

#![allow(clippy::unnecessary_wraps, reason = "the signature of a right-hand side")]

use crate::trees;
use crate::wide;

use crate::lent::integrate;
use trees::{Number, Tree, dot, trees};
use tripos_sim::{DORMAND_PRINCE_853, Failure, Method, Options, OutputOption, RightHandSide, Row, WithJacobian};
use tripos_traits::{Real, Scalar};
use wide::Wide;

const ECCENTRICITY: f64 = 0.5;

fn kepler<S: Real>(_t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure> {
    let r2 = y[0] * y[0] + y[1] * y[1];
    let r3 = r2 * r2.sqrt();
    dydt.copy_from_slice(&[y[2], y[3], -y[0] / r3, -y[1] / r3]);
    Ok(())
}

fn jacobian<S: Real>(_t: f64, y: &[S], out: &mut [S]) -> Result<(), Failure> {
    let (zero, one, three) = (S::int(0), S::int(1), S::int(3));
    let r2 = y[0] * y[0] + y[1] * y[1];
    let (r3, r5) = (r2 * r2.sqrt(), r2 * r2 * r2.sqrt());
    let force = |i: usize, j: usize| three * y[i] * y[j] / r5 - if i == j { one / r3 } else { zero };
    out.fill(zero);
    (out[2], out[7]) = (one, one);
    (out[8], out[9], out[12], out[13]) = (force(0, 0), force(0, 1), force(1, 0), force(1, 1));
    Ok(())
}

fn equations<S: Real>() -> impl RightHandSide<S> {
    WithJacobian { rhs: kepler::<S>, jacobian: jacobian::<S> }
}

fn start<S: Real>() -> [S; 4] {
    let e = S::from_f64(ECCENTRICITY);
    let one = S::int(1);
    [one - e, S::int(0), S::int(0), ((one + e) / (one - e)).sqrt()]
}

/// The exact position, by Newton's iteration on Kepler's equation E − e sin E = t.
fn exact(t: f64) -> [f64; 2] {
    let e = ECCENTRICITY;
    let mut anomaly = t + e * t.sin();
    for _ in 0..50 {
        anomaly -= (anomaly - e * anomaly.sin() - t) / (1.0 - e * anomaly.cos());
    }
    [anomaly.cos() - e, (1.0 - e * e).sqrt() * anomaly.sin()]
}

/// Error of the position at `at` after equal steps over `span`.
fn error(method: Method, span: f64, step: f64, at: f64) -> f64 {
    let options = Options { method, step: Some(step), output: OutputOption::At(vec![at]), ..Options::default() };
    let solution = integrate(equations(), (0.0, span), &start::<f64>(), &options, &mut []).unwrap();
    let exact = exact(at);
    (0..2).map(|i| (solution.y[0][i] - exact[i]).abs()).fold(0.0, f64::max)
}

/// Slope of the logarithm of the error between halvings of the step.
fn observed(error: impl Fn(f64) -> f64, step: f64) -> f64 {
    (error(step) / error(0.5 * step)).log2()
}

/// Steps at which errors of four steps are far above rounding, yet the leading term rules.
fn step(method: Method) -> f64 {
    match method.order() {
        Some(4) => 0.02,
        Some(8) => 0.2,
        _ => 0.05,
    }
}

#[test]
fn every_method_converges_at_its_order() {
    for method in Method::WITHOUT_SERIES {
        let found = observed(|h| error(method, 4.0 * step(method), h, 4.0 * step(method)), step(method));
        assert!((found - f64::from(method.order().unwrap())).abs() < 0.4, "{method:?}: {found}");
    }
}

/// Goal: the order of the dense output. Method: one step errs inside by O(h^(p+1)); with twice the digits of `f64`, so
/// that steps can be small, against DOP853 with 64 steps up to there.
#[test]
fn every_dense_output_has_its_order() {
    let run = |method, span, step, at: f64| {
        let options = Options { method, step: Some(step), output: OutputOption::At(vec![at]), ..Options::default() };
        integrate(equations(), (0.0, span), &start::<Wide>(), &options, &mut []).unwrap().y.remove(0)
    };
    for method in Method::WITHOUT_SERIES {
        let error = |h: f64| {
            let at = 0.3 * h;
            let (found, fine) = (run(method, h, h, at), run(Method::Dop853, at, at / 64.0, at));
            found.iter().zip(&fine).map(|(a, b)| (*a - *b).abs().to_f64()).fold(0.0, f64::max)
        };
        let found = observed(error, 0.02);
        assert!((found - f64::from(method.dense_order().unwrap()) - 1.0).abs() < 0.2, "{method:?}: {found}");
    }
}

/// At θ = 0 and 1 the dense output is the solution itself, and its slope is f.
#[test]
fn dense_outputs_join_smoothly() {
    for method in Method::WITHOUT_SERIES {
        let (h, d) = (0.1, 1e-6);
        let times = vec![0.0, d * h, (1.0 - d) * h, h];
        let options = Options { method, step: Some(h), output: OutputOption::At(times), ..Options::default() };
        let y = integrate(equations(), (0.0, h), &start::<f64>(), &options, &mut []).unwrap().y;
        for (near, end) in [(&y[1], &y[0]), (&y[2], &y[3])] {
            let mut slope = [0.0; 4];
            kepler(0.0, end, &mut slope).unwrap();
            let sign = if near[1] > end[1] { 1.0 } else { -1.0 };
            for i in 0..4 {
                // A second derivative of some 10 over 1e-7, and rounding of 1e-16 over 1e-7. Collocation takes f at
                // points inside the step only, and misses it at the ends by its third differences.
                let tolerance = if method.needs_jacobian() { 1e-2 } else { 1e-5 };
                let found = sign * (near[i] - end[i]) / (d * h);
                assert!((found - slope[i]).abs() < tolerance, "{method:?} {i}: {found} {}", slope[i]);
            }
        }
    }
}

/// Goal: a wider scalar keeps what its coefficients and its arithmetic promise. Method: one revolution by DOP853 with
/// steps so small that the method errs by less than 1e-24, against the start.
#[test]
fn a_wider_scalar_is_not_limited_by_the_rounding_of_f64() {
    let period = std::f64::consts::TAU;
    let options = Options {
        method: Method::Dop853,
        step: Some(period / 8192.0),
        output: OutputOption::Ends,
        ..Options::default()
    };
    let y0 = start::<Wide>();
    let solution = integrate(equations(), (0.0, period), &y0, &options, &mut []).unwrap();
    // The period is 2π, of which TAU lacks 2.45e-16: that much of the velocity is missing.
    let missing = Wide::from_f64(2.449_293_598_294_706_4e-16);
    for i in 0..4 {
        let mut slope = [Wide::from_f64(0.0); 4];
        kepler(0.0, &y0, &mut slope).unwrap();
        let found = (solution.y_end[i] + missing * slope[i] - y0[i]).to_f64().abs();
        assert!(found < 1e-24, "{i}: {found:e}");
    }
}

impl Number for Wide {
    fn whole(n: i64) -> Self {
        Self::int(n)
    }
    fn plus(self, other: Self) -> Self {
        self + other
    }
    fn times(self, other: Self) -> Self {
        self * other
    }
}

fn dense_row(row: Row) -> Vec<Wide> {
    let mut values = vec![Wide::int(0); 16];
    for (stage, decimal) in row {
        values[*stage] = decimal.to();
    }
    values
}

/// Largest violation of Σ bᵢ Φᵢ(tree) = value(tree) over the trees of an order.
fn violation(weights: &[Wide], a: &[Vec<Wide>], order: u32, value: impl Fn(&Tree) -> Wide) -> f64 {
    let residual = |t: &Tree| (dot(weights, &t.stages(a)) - value(t)).to_f64().abs();
    trees(order).iter().map(residual).fold(0.0, f64::max)
}

/// Goal: no digit of any coefficient is mistyped. Method: all 200 order conditions up to 8 in 32 digits, for the new
/// point; those up to 5 and 3 for the solutions that estimate the error. 1e-26: coefficients of 30 digits and sizes
/// up to 43, in products of up to eight.
#[test]
fn dop853_satisfies_every_order_condition_to_its_last_digits() {
    let p = DORMAND_PRINCE_853;
    let a: Vec<Vec<Wide>> = p.a.into_iter().map(dense_row).collect();
    for (row, c) in a.iter().zip(p.c) {
        let sum = row.iter().fold(Wide::int(0), |sum, x| sum + *x).to_f64();
        assert!((sum - c).abs() < 4.0 * f64::EPSILON, "{sum} {c}");
    }
    let density = |t: &Tree| Wide::ratio(1, t.density());
    let new = &a[12];
    let fifth: Vec<Wide> = new.iter().zip(dense_row(p.error5)).map(|(b, e)| *b - e).collect();
    let third = dense_row(p.error3);
    for (name, weights, orders) in [("new", new, 8), ("fifth", &fifth, 5), ("third", &third, 3)] {
        for order in 1..=orders {
            let found = violation(weights, &a, order, density);
            assert!(found < 1e-26, "{name}, order {order}: {found:e}");
        }
        assert!(violation(weights, &a, orders + 1, density) > 1e-9, "{name} has a higher order than it should");
    }
}

/// Order conditions of the dense output: y(θ) = y + h Σ bᵢ(θ) kᵢ satisfies Σ bᵢ(θ) Φᵢ = θ^ρ / γ up to order 7, whatever
/// θ.
#[test]
fn the_dense_output_of_dop853_satisfies_every_order_condition_up_to_seven() {
    let p = DORMAND_PRINCE_853;
    let a: Vec<Vec<Wide>> = p.a.into_iter().map(dense_row).collect();
    let d = p.dense.map(dense_row);
    let unit = |i: usize, j: usize| Wide::int(i64::from(i == j));
    for theta in [Wide::ratio(1, 3), Wide::ratio(9, 10)] {
        let rest = Wide::int(1) - theta;
        let weights: Vec<Wide> = (0..16)
            .map(|i| {
                let (rise, first, last) = (a[12][i], unit(i, 0), unit(i, 12));
                let bend = first - rise;
                let inner = d[0][i] + theta * (d[1][i] + rest * (d[2][i] + theta * d[3][i]));
                theta * (rise + rest * (bend + theta * ((rise - last - bend) + rest * inner)))
            })
            .collect();
        for order in 1..=7_u32 {
            let value = |t: &Tree| theta.powi(i32::try_from(order).unwrap()) / Wide::int(t.density());
            let found = violation(&weights, &a, order, value);
            assert!(found < 1e-24, "order {order}: {found:e}");
        }
    }
}
