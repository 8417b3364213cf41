//! Dense output of a step as a polynomial for each component of the state, with guaranteed ranges over
//! parts of the step.

use tripos_traits::{Enclosure, Interval};

use crate::dense_output::DenseStep;

/// Polynomials of the solution inside a step, for the components of the state that event functions need.
///
/// Their variable is τ = 2θ − 1, where θ is the fraction of the step, so that |τ| ≤ 1 inside it. They differ from the
/// dense output only by rounding errors, for which `margins` has bounds.
#[derive(Debug, Default)]
pub(crate) struct StepPolynomial {
    /// Indices in the state of the components that have a polynomial, in ascending order.
    components: Vec<usize>,
    /// Number of components of the state.
    length: usize,
    /// Coefficients of the powers of τ. Row k has the coefficients of τᵏ, with an entry for each of `components`.
    rows: Vec<f64>,
    /// Bounds of the rounding errors of each component's value and of its derivative by the fraction θ of
    /// the step.
    margins: Vec<[f64; 2]>,
    /// Start and end time of the step, s.
    times: (f64, f64),
    /// Working space for the coefficients of all components of the state.
    all: Vec<f64>,
    /// Working space for the coefficients of `rows` about the middle of a part of the step.
    shifted: Vec<f64>,
}

impl StepPolynomial {
    /// Creates polynomials without coefficients. `components` are the indices of the components that get a polynomial,
    /// and `length` is the number of components of the state.
    pub(crate) fn new(components: Vec<usize>, length: usize) -> Self {
        Self { components, length, ..Self::default() }
    }

    /// Copies the dense output of a step. Returns false if the solution inside the step is no polynomial.
    pub(crate) fn copy_dense_output(&mut self, step: &dyn DenseStep) -> bool {
        let Some(degree) = step.degree() else { return false };
        self.times = step.times();
        self.all.resize((degree + 1) * self.length, 0.0);
        step.dense_output_powers(&mut self.all);
        self.rows.clear();
        for row in self.all.chunks_exact(self.length.max(1)) {
            self.rows.extend(self.components.iter().map(|i| row[*i]));
        }
        let count = self.components.len();
        rounding_margins_of_polynomials(&self.rows, count, &mut self.margins);
        let mut scale = 1.0;
        for row in self.rows.chunks_exact_mut(count.max(1)) {
            for x in row {
                *x *= scale;
            }
            scale *= 0.5;
        }
        shift_polynomials(&mut self.rows, count, 1.0);
        true
    }

    /// Range of the time, s, between the fractions `from` and `to` of the step. The slope of the result is the
    /// derivative by the fraction of the step.
    pub(crate) fn time(&self, from: f64, to: f64) -> Enclosure {
        let (start, end) = (Interval::point(self.times.0), Interval::point(self.times.1));
        let slope = end - start;
        Enclosure { value: start + Interval::new(from, to) * slope, slope }
    }

    /// Writes the range of each component of the state between the fractions `from` and `to` of the step. Slopes are
    /// derivatives by the fraction of the step. Components without a polynomial get undefined intervals.
    pub(crate) fn state(&mut self, from: f64, to: f64, out: &mut Vec<Enclosure>) {
        let (middle, radius) = (from + to - 1.0, to - from);
        let count = self.components.len();
        self.shifted.clone_from(&self.rows);
        shift_polynomials(&mut self.shifted, count, middle);
        out.clear();
        out.resize(self.length, Enclosure { value: Interval::UNDEFINED, slope: Interval::UNDEFINED });
        for (at, (i, margins)) in self.components.iter().zip(&self.margins).enumerate() {
            out[*i] = range_of_polynomial(self.shifted[at..].iter().step_by(count), radius, *margins);
        }
    }
}

/// Computes bounds of the rounding errors of `count` polynomials and of their slopes, for |θ| ≤ 1. Row k of `rows` has
/// the coefficients of power k.
///
/// Each operation of a shift, and of the method's own evaluation, contributes ε times the absolute values of the
/// numbers that it adds.
fn rounding_margins_of_polynomials(rows: &[f64], count: usize, out: &mut Vec<[f64; 2]>) {
    let degree = (rows.len() / count.max(1)).saturating_sub(1) as f64;
    out.clear();
    out.resize(count, [0.0; 2]);
    for (k, row) in rows.chunks_exact(count.max(1)).enumerate() {
        let (of_value, of_slope) = if k == 0 { (4.0, 0.0) } else { (3.0 * degree, 4.0 * degree * k as f64) };
        for (margin, x) in out.iter_mut().zip(row) {
            margin[0] += f64::EPSILON * of_value * x.abs();
            margin[1] += f64::EPSILON * of_slope * x.abs();
        }
    }
}

/// Replaces the coefficients of p(x) with those of p(x + `by`), for `count` polynomials, by Horner's scheme. Row k of
/// `rows` has the coefficients of power k.
fn shift_polynomials(rows: &mut [f64], count: usize, by: f64) {
    if by == 0.0 || count == 0 {
        return;
    }
    let degree = rows.len() / count - 1;
    for low in 0..degree {
        for k in (low..degree).rev() {
            let (lower, upper) = rows[k * count..(k + 2) * count].split_at_mut(count);
            for (x, next) in lower.iter_mut().zip(upper) {
                *x += by * *next;
            }
        }
    }
}

/// Range of the polynomial Σ c_k (radius x)^k over |x| ≤ 1, and of its slope by the fraction θ of the step, where dx/dθ
/// = 2/radius. The two margins bound the rounding errors and widen the ranges.
fn range_of_polynomial<'c>(
    row: impl Iterator<Item = &'c f64>,
    radius: f64,
    [margin, slope_margin]: [f64; 2],
) -> Enclosure {
    // Even powers of x lie between 0 and 1, odd powers between −1 and 1.
    let (mut value, mut slope) = (TermBounds::default(), TermBounds::default());
    let (mut power, mut before) = (1.0, 0.0);
    for (k, c) in row.enumerate() {
        value.add(c * power, k);
        slope.add(2.0 * k as f64 * c * before, k.wrapping_sub(1));
        (before, power) = (power, power * radius);
    }
    Enclosure { value: value.with_margin(margin), slope: slope.with_margin(slope_margin) }
}

/// Lower and upper bound of a sum of terms, from the bounds of each term.
#[derive(Default)]
struct TermBounds {
    /// Lower bound of the sum.
    lo: f64,
    /// Upper bound of the sum.
    hi: f64,
}

impl TermBounds {
    /// Adds the bounds of the term c xᵏ for |x| ≤ 1 to the sum.
    fn add(&mut self, c: f64, k: usize) {
        match k {
            0 => (self.lo, self.hi) = (self.lo + c, self.hi + c),
            _ if k.is_multiple_of(2) => (self.lo, self.hi) = (self.lo + c.min(0.0), self.hi + c.max(0.0)),
            _ => (self.lo, self.hi) = (self.lo - c.abs(), self.hi + c.abs()),
        }
    }

    /// Interval of the sum, widened by `margin` on both sides.
    fn with_margin(&self, margin: f64) -> Interval {
        Interval::new(self.lo - margin, self.hi + margin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Step whose three components are polynomials of degree 4.
    struct Quartics([[f64; 5]; 3]);

    impl Quartics {
        fn at(&self, i: usize, theta: f64) -> f64 {
            self.0[i].iter().rev().fold(0.0, |sum, c| sum * theta + c)
        }
    }

    impl DenseStep for Quartics {
        fn times(&self) -> (f64, f64) {
            (3.0, 1.0)
        }
        fn interpolate(&self, theta: f64, out: &mut [f64]) {
            for (i, o) in out.iter_mut().enumerate() {
                *o = self.at(i, theta);
            }
        }
        fn degree(&self) -> Option<usize> {
            Some(4)
        }
        fn dense_output_powers(&self, out: &mut [f64]) {
            for (i, row) in self.0.iter().enumerate() {
                row.iter().enumerate().for_each(|(k, c)| out[3 * k + i] = *c);
            }
        }
    }

    /// Truth: no value lies outside its range, and no range is much wider than the values. Checked on parts of every
    /// width, at a hundred points each.
    #[test]
    fn values_and_slopes_lie_in_their_ranges() {
        let step = Quartics([[1.0, -3.0, 2.0, 5.0, -4.0], [1e8, 1.0, 0.0, 0.0, 1e-3], [0.0, 0.0, 1.0, 0.0, 0.0]]);
        let (mut polynomial, mut out) = (StepPolynomial::new(vec![0, 1, 2], 3), Vec::new());
        assert!(polynomial.copy_dense_output(&step));
        for width in [1.0, 0.3, 1e-3, 1e-9, 0.0] {
            for start in [0.0_f64, 0.1, 0.5, 0.7] {
                let (from, to) = (start, (start + width).min(1.0));
                polynomial.state(from, to, &mut out);
                let time = polynomial.time(from, to);
                for part in 0..=100 {
                    let theta = from + (to - from) * f64::from(part) / 100.0;
                    for (i, range) in out.iter().enumerate() {
                        let value = step.at(i, theta);
                        assert!(range.value.lo() <= value && value <= range.value.hi(), "{i} {from} {to} {theta}");
                        let rest = step.0[i].iter().enumerate().skip(1).rev();
                        let slope = rest.fold(0.0, |sum, (k, c)| sum * theta + k as f64 * c);
                        assert!(range.slope.lo() <= slope && slope <= range.slope.hi(), "{i} {from} {to} {theta}");
                    }
                    let t = step.time_at(theta);
                    assert!(time.value.lo() <= t && t <= time.value.hi());
                }
                assert!(out[0].value.width() <= 40.0 * (to - from) + 1e-13, "{from} {to} {:?}", out[0]);
            }
        }
    }
}
