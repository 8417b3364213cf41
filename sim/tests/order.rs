//! The order of the methods: proved on the coefficients, then observed on solutions known exactly.

use crate::trees;

use crate::lent::integrate;
use trees::{Number, dot, trees};
use tripos_sim::{DORMAND_PRINCE_54, Fraction, Options, OutputOption, Solution, Tableau};

/// An exact fraction in lowest terms. Overflow panics, so that a test cannot pass by wrapping
/// round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Exact(i128, i128);

impl Exact {
    const ZERO: Self = Self(0, 1);
    const ONE: Self = Self(1, 1);

    fn new((numerator, denominator): Fraction) -> Self {
        Self::reduced(numerator.into(), denominator.into())
    }

    fn reduced(numerator: i128, denominator: i128) -> Self {
        let common = gcd(numerator, denominator);
        Self(numerator / common, denominator / common)
    }

    fn add(self, other: Self) -> Self {
        let common = gcd(self.1, other.1);
        let left = self.0.checked_mul(other.1 / common).unwrap();
        let right = other.0.checked_mul(self.1 / common).unwrap();
        let denominator = (self.1 / common).checked_mul(other.1).unwrap();
        Self::reduced(left.checked_add(right).unwrap(), denominator)
    }

    fn mul(self, other: Self) -> Self {
        let (a, b) = (Self::reduced(self.0, other.1), Self::reduced(other.0, self.1));
        Self(a.0.checked_mul(b.0).unwrap(), a.1.checked_mul(b.1).unwrap())
    }
}

fn gcd(mut a: i128, mut b: i128) -> i128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.abs().max(1)
}

impl Number for Exact {
    fn whole(n: i64) -> Self {
        Self(n.into(), 1)
    }
    fn plus(self, other: Self) -> Self {
        self.add(other)
    }
    fn times(self, other: Self) -> Self {
        self.mul(other)
    }
}

fn exact_matrix<const S: usize>(tableau: &Tableau<S>) -> Vec<Vec<Exact>> {
    tableau.a.iter().map(|row| row.iter().map(|f| Exact::new(*f)).collect()).collect()
}

/// True if Σ bᵢ Φᵢ(tree) = 1 / γ(tree) for every tree of the order.
fn satisfies(weights: &[Exact], a: &[Vec<Exact>], order: u32) -> bool {
    trees(order).iter().all(|t| dot(weights, &t.stages(a)) == Exact(1, i128::from(t.density())))
}

#[test]
fn there_are_200_rooted_trees_up_to_order_eight() {
    let counts: Vec<usize> = (1..=8).map(|order| trees(order).len()).collect();
    assert_eq!(counts, [1, 1, 2, 4, 9, 20, 48, 115]);
}

/// Goal: no coefficient is mistyped. Method: all 17 order conditions, in exact fractions (Butcher,
/// *Numerical Methods for Ordinary Differential Equations*, §31).
#[test]
fn dormand_prince_satisfies_every_order_condition_and_no_more() {
    let a = exact_matrix(&DORMAND_PRINCE_54);
    let weights = a[6].clone();
    let embedded: Vec<Exact> =
        DORMAND_PRINCE_54.error.iter().zip(&weights).map(|(e, b)| b.add(Exact::new(*e).mul(Exact(-1, 1)))).collect();
    for order in 1..=5 {
        assert!(satisfies(&weights, &a, order), "new point, order {order}");
    }
    for order in 1..=4 {
        assert!(satisfies(&embedded, &a, order), "embedded solution, order {order}");
    }
    assert!(!satisfies(&weights, &a, 6));
    assert!(!satisfies(&embedded, &a, 5));
}

/// Goal: the dense output has order 4 at every θ. Method: Σ bᵢ(θ) Φᵢ = θ^ρ / γ as polynomials in
/// θ.
#[test]
fn dense_output_satisfies_every_order_condition_up_to_four() {
    let a = exact_matrix(&DORMAND_PRINCE_54);
    for order in 1..=4 {
        for tree in trees(order) {
            for power in 1..=4_u32 {
                let column: Vec<Exact> =
                    DORMAND_PRINCE_54.dense.iter().map(|row| Exact::new(row[power as usize - 1])).collect();
                let expected = if power == order { Exact(1, i128::from(tree.density())) } else { Exact::ZERO };
                assert_eq!(dot(&column, &tree.stages(&a)), expected, "θ^{power} {tree:?}");
            }
        }
    }
}

/// At θ = 0 the slope is k₁, at θ = 1 the value is the new point and the slope k₇: the pieces
/// join with a continuous derivative.
#[test]
fn dense_output_joins_smoothly() {
    let unit = |i: usize, j: usize| if i == j { Exact::ONE } else { Exact::ZERO };
    for (i, row) in DORMAND_PRINCE_54.dense.iter().enumerate() {
        let d: Vec<Exact> = row.iter().map(|f| Exact::new(*f)).collect();
        assert_eq!(d[0], unit(i, 0), "slope at 0, stage {i}");
        let value = d.iter().fold(Exact::ZERO, |sum, x| sum.add(*x));
        assert_eq!(value, Exact::new(DORMAND_PRINCE_54.a[6][i]), "value at 1, stage {i}");
        let powers = [Exact(1, 1), Exact(2, 1), Exact(3, 1), Exact(4, 1)];
        assert_eq!(dot(&d, &powers), unit(i, 6), "slope at 1, stage {i}");
    }
}

/// Options that take every step with the same size, whatever its error.
fn fixed(step: f64, output: OutputOption) -> Options {
    Options { max_step: Some(step), initial_step: Some(step), output, ..Options::tolerances(1e9, 1e9) }
}

const ECCENTRICITY: f64 = 0.5;

/// Kepler's problem from the pericentre, one revolution a 2π; position and velocity.
fn kepler(span: f64, step: f64, output: OutputOption) -> Solution {
    let start = kepler_start();
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        let r3 = (y[0] * y[0] + y[1] * y[1]).powf(1.5);
        dydt.copy_from_slice(&[y[2], y[3], -y[0] / r3, -y[1] / r3]);
        Ok(())
    };
    integrate(rhs, (0.0, span), &start, &fixed(step, output), &mut []).unwrap()
}

fn kepler_start() -> [f64; 4] {
    let e = ECCENTRICITY;
    [1.0 - e, 0.0, 0.0, ((1.0 + e) / (1.0 - e)).sqrt()]
}

/// The exact position, by Newton's iteration on Kepler's equation E − e sin E = t.
fn kepler_position(t: f64) -> [f64; 2] {
    let e = ECCENTRICITY;
    let mut anomaly = t + e * t.sin();
    for _ in 0..50 {
        anomaly -= (anomaly - e * anomaly.sin() - t) / (1.0 - e * anomaly.cos());
    }
    [anomaly.cos() - e, (1.0 - e * e).sqrt() * anomaly.sin()]
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Slope of the logarithm of the error against that of the step, between halvings.
fn observed_order(error: impl Fn(f64) -> f64, step: f64) -> f64 {
    (error(step) / error(step / 2.0)).log2()
}

#[test]
fn dormand_prince_converges_at_order_five_on_kepler() {
    use std::f64::consts::TAU;
    let error = |h: f64| distance(&kepler(TAU, h, OutputOption::Ends).y_end, &kepler_start());
    let order = observed_order(error, TAU / 400.0);
    assert!((order - 5.0).abs() < 0.3, "{order}");
}

/// The error of one step of a method of order p is O(h^(p+1)): 6 at its end, 5 inside.
#[test]
fn one_step_errs_at_order_six_and_its_dense_output_at_order_five() {
    let inside = |theta: f64, h: f64| {
        let solution = kepler(h, h, OutputOption::At(vec![theta * h]));
        distance(&solution.y[0][..2], &kepler_position(theta * h))
    };
    let end = observed_order(|h| inside(1.0, h), 0.025);
    assert!((end - 6.0).abs() < 0.3, "{end}");
    let middle = observed_order(|h| inside(0.3, h), 0.025);
    assert!((middle - 5.0).abs() < 0.3, "{middle}");
}

/// Polynomials up to degree 4 in t are exact everywhere; 4 ε since the values stay below 4.
#[test]
fn polynomials_of_degree_four_are_exact_inside_a_step() {
    let rhs = |t: f64, _y: &[f64], dydt: &mut [f64]| {
        dydt[0] = 4.0 * t.powi(3) - 3.0 * t.powi(2) + 1.0;
        Ok(())
    };
    let times: Vec<f64> = (0..=10).map(|i| 0.1 * f64::from(i)).collect();
    let options = fixed(1.0, OutputOption::At(times.clone()));
    let solution = integrate(rhs, (0.0, 1.0), &[0.0], &options, &mut []).unwrap();
    assert_eq!((solution.steps, solution.y.len()), (1, 11));
    for (t, y) in times.iter().zip(&solution.y) {
        let exact = t.powi(4) - t.powi(3) + t;
        assert!((y[0] - exact).abs() < 4.0 * f64::EPSILON, "{t}: {} {exact}", y[0]);
    }
}
