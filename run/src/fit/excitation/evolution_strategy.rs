//! Minimum of a function by evolution of a normal distribution: CMA-ES.
//!
//! The function need not be smooth: only the order of its values matters. The formulas and their constants are those of
//! N. Hansen, "The CMA Evolution Strategy: A Tutorial", arXiv:1604.00772 (2016).

use crate::Error;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;
use tripos_linear::SingularValues;

/// Gain below which a number of generations counts as no progress.
const GAIN: f64 = 1e-7;
/// Size of the whole distribution below which a search ends.
const SMALL: f64 = 1e-9;

/// Generator of pseudorandom numbers that are equal in every run (SplitMix64).
pub struct RandomNumbers(u64);

impl RandomNumbers {
    /// Generator of the numbers that belong to a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Next number, uniform above 0 and below 1.
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        ((z >> 12) as f64 + 0.5) / (1_u64 << 52) as f64
    }

    /// Next number of the normal distribution with mean 0 and standard deviation 1 (Box & Muller 1958).
    pub fn normal(&mut self) -> f64 {
        let radius = (-2.0 * self.uniform().ln()).sqrt();
        radius * (TAU * self.uniform()).cos()
    }

    /// Vector of independent normal numbers.
    pub fn normal_vector(&mut self, length: usize) -> DVector<f64> {
        DVector::from_fn(length, |_, _| self.normal())
    }
}

/// Weights and learning rates of the strategy (Hansen 2016, table 1).
struct Rates {
    /// Number of points of a generation.
    points: usize,
    /// Weights of the best points, the best first; their sum is 1.
    weights: Vec<f64>,
    /// Number of points with equal weights that would select as sharply.
    selected: f64,
    /// Learning rate of the path of the covariance.
    path: f64,
    /// Learning rate of the path of the step size.
    size_path: f64,
    /// Learning rate of the covariance from its path.
    one: f64,
    /// Learning rate of the covariance from the best points.
    many: f64,
    /// Damping of the step size.
    damping: f64,
    /// Expected length of a vector of normal numbers.
    expected: f64,
}

impl Rates {
    /// Rates for a number of unknowns.
    fn new(unknowns: usize) -> Self {
        let n = unknowns as f64;
        // 4 + ⌊3 ln n⌋
        let points = 4 + (1..=100).take_while(|more| f64::from(*more) <= 3.0 * n.ln()).count();
        let best = points / 2;
        let raw: Vec<f64> =
            (1..=best).map(|rank| f64::midpoint(points as f64, 1.0).ln() - (rank as f64).ln()).collect();
        let sum: f64 = raw.iter().sum();
        let weights: Vec<f64> = raw.iter().map(|weight| weight / sum).collect();
        let selected = 1.0 / weights.iter().map(|weight| weight * weight).sum::<f64>();
        let size_path = (selected + 2.0) / (n + selected + 5.0);
        let one = 2.0 / ((n + 1.3).powi(2) + selected);
        let many = 2.0 * (0.25 + selected + 1.0 / selected - 2.0) / ((n + 2.0).powi(2) + selected);
        Self {
            points,
            weights,
            selected,
            path: (4.0 + selected / n) / (n + 4.0 + 2.0 * selected / n),
            size_path,
            one,
            many: many.min(1.0 - one),
            damping: 1.0 + 2.0 * (((selected - 1.0) / (n + 1.0)).sqrt() - 1.0).max(0.0) + size_path,
            expected: n.sqrt() * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n)),
        }
    }
}

/// Normal distribution of the points of a generation.
struct Distribution {
    /// Mean of the points.
    mean: DVector<f64>,
    /// Step size, which multiplies the covariance.
    size: f64,
    /// Covariance matrix without the step size.
    covariance: DMatrix<f64>,
    /// Principal axes of the covariance, as columns of length 1.
    axes: DMatrix<f64>,
    /// Standard deviations along the axes, without the step size.
    deviations: DVector<f64>,
    /// Path of the mean, for the covariance.
    path: DVector<f64>,
    /// Path of the mean in the principal axes, for the step size.
    size_path: DVector<f64>,
    /// Number of generations so far.
    generations: usize,
}

impl Distribution {
    /// Round distribution about a start.
    fn new(start: &[f64], size: f64) -> Self {
        let n = start.len();
        Self {
            mean: DVector::from_column_slice(start),
            size,
            covariance: DMatrix::identity(n, n),
            axes: DMatrix::identity(n, n),
            deviations: DVector::repeat(n, 1.0),
            path: DVector::zeros(n),
            size_path: DVector::zeros(n),
            generations: 0,
        }
    }

    /// Draws a step from the mean, without the step size.
    fn draw(&self, random: &mut RandomNumbers) -> DVector<f64> {
        let normal = random.normal_vector(self.mean.len());
        &self.axes * normal.component_mul(&self.deviations)
    }

    /// Moves the distribution towards the best steps, which are given in the order of their values.
    fn learn(&mut self, rates: &Rates, steps: &[&DVector<f64>]) {
        let n = self.mean.len();
        let best = || rates.weights.iter().zip(steps);
        let mut way = DVector::zeros(n);
        best().for_each(|(weight, step)| way.axpy(*weight, step, 1.0));
        self.mean.axpy(self.size, &way, 1.0);
        self.generations += 1;
        let along = self.axes.tr_mul(&way).component_div(&self.deviations);
        let turned = &self.axes * along;
        let keep = (rates.size_path * (2.0 - rates.size_path) * rates.selected).sqrt();
        self.size_path = &self.size_path * (1.0 - rates.size_path) + turned * keep;
        let length = self.size_path.norm();
        let settled = (1.0 - (1.0 - rates.size_path).powf(2.0 * self.generations as f64)).sqrt();
        let is_steady = length / settled < (1.4 + 2.0 / (n as f64 + 1.0)) * rates.expected;
        let share = if is_steady { (rates.path * (2.0 - rates.path) * rates.selected).sqrt() } else { 0.0 };
        self.path = &self.path * (1.0 - rates.path) + &way * share;
        let lost = if is_steady { 0.0 } else { rates.one * rates.path * (2.0 - rates.path) };
        self.covariance *= 1.0 - rates.one - rates.many + lost;
        self.covariance.ger(rates.one, &self.path, &self.path, 1.0);
        for (weight, step) in best() {
            self.covariance.ger(rates.many * weight, *step, *step, 1.0);
        }
        self.size *= (rates.size_path / rates.damping * (length / rates.expected - 1.0)).min(1.0).exp();
        if self.generations.is_multiple_of(1 + n / 10) {
            self.find_axes();
        }
    }

    /// Finds the principal axes of the covariance anew.
    fn find_axes(&mut self) {
        let symmetric = (&self.covariance + self.covariance.transpose()) * 0.5;
        let parts = SingularValues::new(&symmetric);
        self.axes = parts.right.transpose();
        self.deviations = parts.values.map(|value| value.max(f64::MIN_POSITIVE).sqrt());
        self.covariance = symmetric;
    }
}

/// Best point of a search.
pub struct BestPoint {
    /// Unknowns.
    pub x: Vec<f64>,
    /// Value of the function there.
    pub value: f64,
    /// Number of points at which the function was evaluated.
    pub tried: usize,
}

/// Minimizes a function from a start, in at most `most` evaluations. `size` is the standard deviation of the first
/// points. Values that are infinite or no number count as the largest ones.
///
/// # Errors
/// The first error of the function.
pub fn minimize(
    function: &mut dyn FnMut(&[f64]) -> Result<f64, Error>,
    start: &[f64],
    size: f64,
    most: usize,
    random: &mut RandomNumbers,
) -> Result<BestPoint, Error> {
    let mut best = BestPoint { x: start.to_vec(), value: function(start)?, tried: 1 };
    if start.is_empty() {
        return Ok(best);
    }
    let rates = Rates::new(start.len());
    let mut spread = Distribution::new(start, size);
    let patience = 10 + 30 * start.len() / rates.points;
    let (mut last_gain, mut level) = (0, best.value);
    while best.tried + rates.points <= most {
        let mut generation = Vec::with_capacity(rates.points);
        for _ in 0..rates.points {
            let step = spread.draw(random);
            let x = &spread.mean + &step * spread.size;
            let value = function(x.as_slice())?;
            best.tried += 1;
            if value < best.value {
                (best.value, best.x) = (value, x.as_slice().to_vec());
            }
            generation.push((if value.is_nan() { f64::INFINITY } else { value }, step));
        }
        generation.sort_by(|one, other| one.0.total_cmp(&other.0));
        let steps: Vec<&DVector<f64>> = generation.iter().map(|(_, step)| step).collect();
        spread.learn(&rates, &steps);
        if best.value < level - GAIN * level.abs().max(1.0) || !level.is_finite() {
            (last_gain, level) = (spread.generations, best.value);
        }
        let is_small = spread.size * spread.deviations.amax() < SMALL;
        if is_small || spread.generations - last_gain > patience || !spread.size.is_finite() {
            break;
        }
    }
    Ok(best)
}

#[cfg(test)]
mod tests {
    use super::{RandomNumbers, minimize};

    /// Goal: the search finds a minimum in a narrow valley. Method: Rosenbrock's function of five unknowns, which is 0
    /// at (1, …, 1).
    #[test]
    fn the_minimum_of_a_narrow_valley_is_found() {
        let mut function = |x: &[f64]| {
            Ok(x.windows(2).map(|pair| 100.0 * (pair[1] - pair[0] * pair[0]).powi(2) + (1.0 - pair[0]).powi(2)).sum())
        };
        let found = minimize(&mut function, &[-0.5; 5], 0.5, 20_000, &mut RandomNumbers::new(1)).unwrap();
        assert!(found.value < 1e-7, "{} after {}", found.value, found.tried);
        assert!(found.x.iter().all(|x| (x - 1.0).abs() < 1e-2), "{:?}", found.x);
    }
}
