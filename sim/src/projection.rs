//! Projection of a run onto its invariants or its constraints, with an account of what it did.
//!
//! After each accepted step the state is moved onto I_k(y) = I_k(y₀), or onto the constraints φ_k(y) = 0 of the equations, by the smallest correction in the norm of the
//! tolerances, and the method goes on from there. What was removed is added up with its sign: a projected run does not
//! hide the drift that the method has. E. Hairer, C. Lubich & G. Wanner, *Geometric Numerical Integration*, 2nd edition
//! (2006), §IV.4.
//!
//! Events, and output at and inside a step, belong to the step as the method took it, before the correction at its end;
//! the last state, and all later steps, follow from the corrected one.

use tripos_traits::Real;

use crate::options::Options;
use crate::rhs::RightHandSide;
use crate::tolerance::ErrorTest;

/// Newton iterations of one correction.
const ITERATIONS: u32 = 3;
/// Sine of an angle between gradients below which they count as dependent.
const DEPENDENT: f64 = 1e-8;
/// Corrections of fewer units in the last place of the largest component than this are rounding.
const ROUNDING: f64 = 16.0;
/// The part of the drift that may be left by the last iteration; Newton's method squares it each time.
const LEFT: f64 = 1e-3;

/// `(t, y, values, gradients)`: writes the invariants, and ∂I_k/∂y row by row.
pub type InvariantFunction<'a, S> = Box<dyn FnMut(f64, &[S], &mut [S], &mut [S]) + 'a>;

/// Invariants to be kept.
pub struct Invariants<'a, S = f64> {
    /// How many there are.
    pub count: usize,
    /// Their values and gradients: `count` values and `count` times the length of the state, each in its own unit.
    pub function: InvariantFunction<'a, S>,
}

impl<S> std::fmt::Debug for Invariants<'_, S> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Invariants").field("count", &self.count).finish_non_exhaustive()
    }
}

/// What projection did in a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ProjectionReport {
    /// Steps after which the state was moved.
    pub corrections: u64,
    /// Steps after which it was not, since the gradients are zero, dependent or not finite.
    pub singular: u64,
    /// Steps after which it was not, since three iterations of Newton's method do not reach the invariants: the
    /// gradients are wrong, or the step was far too long.
    pub not_converged: u64,
    /// Σ |correction| of each component of the state, in its unit.
    pub moved: Vec<f64>,
    /// For each invariant or constraint, the drift that was removed: Σ (value before − value after), with its sign.
    pub removed: Vec<f64>,
    /// For each of them, the largest of these in size, with its sign.
    pub largest: Vec<f64>,
}

/// What a run is moved onto.
pub(crate) enum Onto<'p, 'a, S> {
    /// The values that these have at the start.
    Invariants(&'p mut Invariants<'a, S>),
    /// Where the constraints of the equations, this many, are zero.
    Constraints(usize),
}

/// Projection of a run under way.
pub(crate) struct Projector<'p, 'a, S> {
    onto: Onto<'p, 'a, S>,
    weights: Option<ErrorTest>,
    wanted: Vec<S>,
    values: Vec<S>,
    gradients: Vec<S>,
    drift: Vec<f64>,
    before: Vec<f64>,
    y: Vec<S>,
    pub(crate) report: ProjectionReport,
}

/// Why the state is left as it is.
enum Hindrance {
    Singular,
    NotConverged,
}

impl<'p, 'a, S: Real> Projector<'p, 'a, S> {
    /// Onto invariants with their values at the start, or onto constraints.
    pub(crate) fn new<R: RightHandSide<S>>(
        onto: Onto<'p, 'a, S>,
        rhs: &mut R,
        options: &Options,
        (t0, y0): (f64, &[S]),
    ) -> Self {
        let count = match &onto {
            Onto::Invariants(invariants) => invariants.count,
            Onto::Constraints(count) => *count,
        };
        let (m, n) = (count, y0.len());
        let zeros = |n: usize| vec![S::from_f64(0.0); n];
        // A run with fixed steps has no tolerances: all components then count alike if those given make no sense.
        let weights = ErrorTest::new::<S>(crate::method::norm(options.method), options.rtol, &options.atol, n)
            .ok()
            .map(|(test, _)| test);
        let mut projector = Self {
            onto,
            weights,
            wanted: zeros(m),
            values: zeros(m),
            gradients: zeros(m * n),
            drift: vec![0.0; m],
            before: vec![0.0; m],
            y: y0.to_vec(),
            report: ProjectionReport {
                moved: vec![0.0; n],
                removed: vec![0.0; m],
                largest: vec![0.0; m],
                ..ProjectionReport::default()
            },
        };
        if matches!(projector.onto, Onto::Invariants(_)) {
            projector.measure(rhs, t0);
            projector.wanted.clone_from(&projector.values);
        }
        projector
    }

    /// The state moved onto the invariants; nothing if it is there to rounding, or cannot be moved.
    pub(crate) fn project<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64, y: &[S]) -> Option<&[S]> {
        self.y.copy_from_slice(y);
        if self.values.is_empty() || self.measure(rhs, t) {
            return None;
        }
        self.before.clone_from(&self.drift);
        match self.iterate(rhs, t) {
            Ok(()) => {
                self.account(y);
                Some(&self.y)
            }
            Err(Hindrance::Singular) => {
                self.report.singular += 1;
                None
            }
            Err(Hindrance::NotConverged) => {
                self.report.not_converged += 1;
                None
            }
        }
    }

    /// Values and gradients at the state, and the drift; says whether that is rounding.
    fn measure<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64) -> bool {
        match &mut self.onto {
            Onto::Invariants(invariants) => (invariants.function)(t, &self.y, &mut self.values, &mut self.gradients),
            Onto::Constraints(_) => rhs.constraints(t, &self.y, &mut self.values, &mut self.gradients),
        }
        let mut rounding = true;
        for (k, row) in self.gradients.chunks_exact(self.y.len().max(1)).enumerate() {
            self.drift[k] = (self.values[k] - self.wanted[k]).to_f64();
            let sizes = row.iter().zip(&self.y).map(|(g, y)| (g.to_f64() * y.to_f64()).abs());
            let size = sizes.sum::<f64>() + self.wanted[k].to_f64().abs();
            rounding &= self.drift[k].abs() <= 2.0 * S::EPSILON * size;
        }
        rounding
    }

    fn iterate<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64) -> Result<(), Hindrance> {
        for _ in 0..ITERATIONS {
            let is_rounding = self.step()?;
            if self.measure(rhs, t) || is_rounding {
                return Ok(());
            }
        }
        let near = self.drift.iter().zip(&self.before).all(|(now, before)| now.abs() <= LEFT * before.abs());
        if near { Ok(()) } else { Err(Hindrance::NotConverged) }
    }

    /// y − W² Gᵀ (G W² Gᵀ)⁻¹ drift, with the weights W of the tolerances and the gradients G as rows. Says whether that moves
    /// nothing but digits that rounding decides.
    fn step(&mut self) -> Result<bool, Hindrance> {
        let (m, n) = (self.values.len(), self.y.len());
        let weight = |i: usize| self.weights.as_ref().map_or(1.0, |test| test.weight(i, self.y[i].to_f64().abs()));
        let weights: Vec<f64> = (0..n).map(weight).collect();
        // Orthonormal rows by Gram and Schmidt: no invariant's unit matters, and dependence shows as what is left of a
        // row.
        let mut rows: Vec<Vec<f64>> = Vec::with_capacity(m);
        let mut shares: Vec<f64> = Vec::with_capacity(m);
        for k in 0..m {
            let mut row: Vec<f64> = (0..n).map(|i| self.gradients[k * n + i].to_f64() * weights[i]).collect();
            let size = norm(&row);
            let mut share = self.drift[k];
            for (other, other_share) in rows.iter().zip(&shares) {
                let part: f64 = row.iter().zip(other).map(|(a, b)| a * b).sum();
                for (a, b) in row.iter_mut().zip(other) {
                    *a -= part * b;
                }
                share -= part * other_share;
            }
            let left = norm(&row);
            let independent = left > DEPENDENT * size && left.is_finite() && share.is_finite();
            if !independent {
                return Err(Hindrance::Singular);
            }
            for a in &mut row {
                *a /= left;
            }
            rows.push(row);
            shares.push(share / left);
        }
        let size = self.y.iter().fold(0.0, |most: f64, y| most.max(y.to_f64().abs()));
        let mut is_rounding = true;
        for (i, y) in self.y.iter_mut().enumerate() {
            let correction: f64 = rows.iter().zip(&shares).map(|(row, share)| row[i] * share).sum::<f64>() * weights[i];
            is_rounding &= correction.abs() <= ROUNDING * S::EPSILON * size;
            *y = *y - S::from_f64(correction);
        }
        Ok(is_rounding)
    }

    fn account(&mut self, y: &[S]) {
        self.report.corrections += 1;
        for ((moved, new), old) in self.report.moved.iter_mut().zip(&self.y).zip(y) {
            *moved += (*new - *old).to_f64().abs();
        }
        let removed = self.before.iter().zip(&self.drift).map(|(before, after)| before - after);
        for ((sum, largest), drift) in self.report.removed.iter_mut().zip(&mut self.report.largest).zip(removed) {
            *sum += drift;
            if drift.abs() > largest.abs() {
                *largest = drift;
            }
        }
    }
}

fn norm(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}
