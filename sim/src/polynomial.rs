//! The solution inside a step as one polynomial for each component, and its ranges over parts of the step.

use tripos_traits::{Enclosure, Interval};

use crate::stepper::DenseStep;

/// The polynomials of one step.
///
/// Invariant: `rows` holds, component by component, the coefficients of the powers of τ = 2θ − 1, which is at most 1 in
/// size inside the step; they differ from those of the dense output by rounding, which `margins` bound.
#[derive(Debug, Default)]
pub(crate) struct Polynomial {
    degree: usize,
    rows: Vec<f64>,
    /// What rounding may have changed of the value, and of the slope by θ, of each component.
    margins: Vec<[f64; 2]>,
    /// Start and end of the step, in s.
    times: (f64, f64),
    /// Room for the coefficients of one component.
    row: Vec<f64>,
}

impl Polynomial {
    /// Takes the polynomials of a step; says no if it has none.
    pub(crate) fn take(&mut self, step: &dyn DenseStep, components: usize) -> bool {
        let Some(degree) = step.degree() else { return false };
        (self.degree, self.times) = (degree, step.times());
        self.rows.clear();
        self.rows.resize(components * (degree + 1), 0.0);
        let rows = &mut self.rows;
        step.powers(&mut |i, power, value| rows[i * (degree + 1) + power] = value);
        self.margins.clear();
        for row in self.rows.chunks_exact_mut(degree + 1) {
            self.margins.push(margins(row));
            let mut scale = 1.0;
            for x in row.iter_mut() {
                *x *= scale;
                scale *= 0.5;
            }
            shift(row, 1.0);
        }
        true
    }

    /// The time over a part of the step, with the fraction of the step as the argument of its slope.
    pub(crate) fn time(&self, from: f64, to: f64) -> Enclosure {
        let (start, end) = (Interval::point(self.times.0), Interval::point(self.times.1));
        let slope = end - start;
        Enclosure { value: start + Interval::new(from, to) * slope, slope }
    }

    /// Every component over a part of the step, with the fraction of the step as the argument of its slope.
    pub(crate) fn state(&mut self, from: f64, to: f64, out: &mut Vec<Enclosure>) {
        let (middle, radius) = (from + to - 1.0, to - from);
        out.clear();
        for (row, margins) in self.rows.chunks_exact(self.degree + 1).zip(&self.margins) {
            self.row.clear();
            self.row.extend_from_slice(row);
            shift(&mut self.row, middle);
            out.push(range(&self.row, radius, *margins));
        }
    }
}

/// What rounding may change of a polynomial with these coefficients, and of its slope, where |θ| ≤ 1: each operation
/// of the shifts, and of the method's own evaluation, by ε of what it adds up.
fn margins(row: &[f64]) -> [f64; 2] {
    let degree = (row.len() - 1) as f64;
    let rest: f64 = row[1..].iter().map(|x| x.abs()).sum();
    let slope: f64 = row.iter().enumerate().map(|(k, x)| k as f64 * x.abs()).sum();
    [f64::EPSILON * (4.0 * row[0].abs() + 3.0 * degree * rest), f64::EPSILON * 4.0 * degree * slope]
}

/// The coefficients of p(x + by) from those of p(x), by Horner's scheme, in place.
fn shift(row: &mut [f64], by: f64) {
    if by == 0.0 {
        return;
    }
    for low in 0..row.len() {
        for k in (low..row.len() - 1).rev() {
            row[k] += by * row[k + 1];
        }
    }
}

/// The range of Σ c_k (radius x)^k over |x| ≤ 1, and of its slope by θ, of which x is 2/radius times.
fn range(row: &[f64], radius: f64, [margin, slope_margin]: [f64; 2]) -> Enclosure {
    // Even powers are between 0 and 1, odd ones between −1 and 1.
    let (mut value, mut slope) = (Spread::at(row[0]), Spread::at(0.0));
    let mut power = 1.0;
    for (k, c) in row.iter().enumerate().skip(1) {
        slope.add(2.0 * k as f64 * c * power, k - 1);
        power *= radius;
        value.add(c * power, k);
    }
    Enclosure { value: value.within(margin), slope: slope.within(slope_margin) }
}

/// A sum of terms between bounds.
struct Spread {
    lo: f64,
    hi: f64,
}

impl Spread {
    fn at(x: f64) -> Self {
        Self { lo: x, hi: x }
    }

    /// Adds c xᵏ with |x| ≤ 1.
    fn add(&mut self, c: f64, k: usize) {
        match k {
            0 => (self.lo, self.hi) = (self.lo + c, self.hi + c),
            _ if k.is_multiple_of(2) => (self.lo, self.hi) = (self.lo + c.min(0.0), self.hi + c.max(0.0)),
            _ => (self.lo, self.hi) = (self.lo - c.abs(), self.hi + c.abs()),
        }
    }

    fn within(&self, margin: f64) -> Interval {
        Interval::new(self.lo - margin, self.hi + margin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three components of degree 4 as a step would give them.
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
        fn powers(&self, put: &mut dyn FnMut(usize, usize, f64)) {
            for (i, row) in self.0.iter().enumerate() {
                row.iter().enumerate().for_each(|(k, c)| put(i, k, *c));
            }
        }
    }

    /// Goal: no value outside of its range, and no range much wider than the values. Method: parts of every width, at a
    /// hundred points each.
    #[test]
    fn values_and_slopes_lie_in_their_ranges() {
        let step = Quartics([[1.0, -3.0, 2.0, 5.0, -4.0], [1e8, 1.0, 0.0, 0.0, 1e-3], [0.0, 0.0, 1.0, 0.0, 0.0]]);
        let (mut polynomial, mut out) = (Polynomial::default(), Vec::new());
        assert!(polynomial.take(&step, 3));
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
