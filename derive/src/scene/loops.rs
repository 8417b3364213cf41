//! The loops of a mechanism as functions of parameters and coordinates, and the search for poses that close them.

use crate::algebra::Expr;
use crate::algebra::calculus::Gradient;
use crate::algebra::evaluate::Tape;
use crate::model::Model;
use nalgebra::{DMatrix, DVector};
use tripos_traits::{DoubleDouble, Scalar};

/// Steps of Newton's method, and halvings of one.
const STEPS: usize = 100;
const HALVINGS: usize = 40;
/// What may be left of a loop, over the sum of the sizes of what it is made of.
const OPEN: f64 = 1e-13;
/// Singular values below the largest times this do not count.
const RANK: f64 = 1e-10;
/// Where one of all loops is below the largest times this, they are dependent: a pose that is a double root is found to half
/// of the digits.
const SINGULAR: f64 = 1e-6;

/// The loops of a model, first those that tie it, then those that follow from them where all are closed.
pub struct Loops {
    pub(super) values: Tape,
    slopes: Tape,
    names: Vec<String>,
    /// How many tie the mechanism.
    independent: usize,
}

/// Where a search ended.
pub(super) struct Found {
    pub q: Vec<f64>,
    /// How far each loop is open.
    pub open: Vec<f64>,
    pub is_closed: bool,
    /// The pseudo-inverse of the slopes along the coordinates that were free.
    pub inverse: DMatrix<f64>,
}

impl Loops {
    /// Those of a model.
    #[must_use]
    pub fn new(model: &Model) -> Self {
        let arena = &mut model.arena.clone();
        let coordinates = model.q();
        let inputs = [model.p(), coordinates.clone()].concat();
        let all = || model.loops.iter().chain(&model.closed);
        let equations: Vec<Expr> = all().map(|c| c.equation).collect();
        let mut gradient = Gradient::new(&coordinates);
        let mut slopes = vec![Expr::ZERO; equations.len() * coordinates.len()];
        // Nothing moves time.
        let time = model.time();
        for (row, equation) in equations.iter().enumerate() {
            for &(at, slope) in gradient.apply(arena, *equation).iter().filter(|(at, _)| Some(*at) != time) {
                slopes[row * coordinates.len() + at] = slope;
            }
        }
        let tape = |values: &[Expr]| match Tape::new(arena, &inputs, values) {
            Ok(tape) => tape,
            Err(unknown) => unreachable!("loops tie coordinates, not {}", unknown.0),
        };
        let names = all().map(|c| c.name.clone()).collect();
        Self { values: tape(&equations), slopes: tape(&slopes), names, independent: model.loops.len() }
    }

    /// Each loop that is to follow from the others: its name, how far it is open, in its unit, and that over the sum of the sizes of
    /// what it is made of.
    #[must_use]
    pub fn following(&self, p: &[f64], q: &[f64]) -> Vec<(&str, f64, f64)> {
        let (open, slopes) = (self.open(p, q), self.slopes(p, q));
        let following = (self.independent..self.names.len())
            .map(|row| (self.names[row].as_str(), open[row], open[row].abs() / size(&slopes, row, q)));
        following.collect()
    }

    /// A closed pose near another, of which some coordinates are held, to 32 digits; nothing where none is found, or the loops do not
    /// determine the coordinates that are free.
    #[must_use]
    pub fn close(&self, p: &[DoubleDouble], q: &[DoubleDouble], free: &[usize]) -> Option<Vec<DoubleDouble>> {
        let doubles = |list: &[DoubleDouble]| list.iter().map(|x| x.hi()).collect::<Vec<f64>>();
        let known = doubles(p);
        let found = self.newton(&known, &doubles(q), free);
        let slopes = self.slopes(&known, &found.q).select_columns(free);
        let sizes = slopes.singular_values();
        let determines = free.is_empty() || slopes.nrows() >= free.len() && sizes.min() > SINGULAR * sizes.max();
        if !found.is_closed || !determines {
            return None;
        }
        // With the slopes in doubles each step gives sixteen digits more.
        let values = self.values.to::<DoubleDouble>();
        let mut precise = q.to_vec();
        for at in free {
            precise[*at] = found.q[*at].into();
        }
        for _ in 0..3 {
            let open = values.evaluate(&[p, &precise].concat());
            for (row, at) in free.iter().enumerate() {
                for (column, open) in open.iter().enumerate() {
                    precise[*at] = precise[*at] - DoubleDouble::from_f64(found.inverse[(row, column)]) * *open;
                }
            }
        }
        Some(precise)
    }

    /// How far each loop is open, in its unit.
    #[must_use]
    pub fn openings(&self, p: &[f64], q: &[f64]) -> Vec<(&str, f64)> {
        self.names.iter().map(String::as_str).zip(self.open(p, q)).collect()
    }

    /// A loop that is to follow from the others and whose slopes do not.
    pub(super) fn not_following(&self, p: &[f64], q: &[f64]) -> Option<&str> {
        let slopes = self.slopes(p, q);
        let axes = slopes.rows(0, self.independent).transpose().qr().q();
        (self.independent..self.names.len()).find_map(|row| {
            let row_of = slopes.row(row).transpose();
            let left = &row_of - &axes * axes.tr_mul(&row_of);
            (left.norm() > SINGULAR * row_of.norm()).then(|| self.names[row].as_str())
        })
    }

    pub(super) fn open(&self, p: &[f64], q: &[f64]) -> Vec<f64> {
        self.values.evaluate(&[p, q].concat())
    }

    fn slopes(&self, p: &[f64], q: &[f64]) -> DMatrix<f64> {
        let values = self.slopes.evaluate(&[p, q].concat());
        DMatrix::from_row_slice(values.len() / q.len().max(1), q.len(), &values)
    }

    /// Whether every loop is closed to this part of what it is made of.
    pub(super) fn is_closed(&self, p: &[f64], q: &[f64], open: &[f64], part: f64) -> bool {
        let slopes = self.slopes(p, q);
        open.iter().enumerate().all(|(row, open)| open.abs() <= part * size(&slopes, row, q))
    }

    /// Whether the slopes of the loops are dependent.
    pub(super) fn is_singular(&self, p: &[f64], q: &[f64]) -> bool {
        let values = self.slopes(p, q).rows(0, self.independent).singular_values();
        values.min() <= SINGULAR * values.max()
    }

    /// Newton's method with halved steps, along these coordinates alone; where the loops leave some of them open, by the
    /// smallest change.
    pub(super) fn newton(&self, p: &[f64], start: &[f64], free: &[usize]) -> Found {
        let mut q = start.to_vec();
        let mut open = DVector::from_vec(self.open(p, &q));
        let inverse_at = |q: &[f64]| {
            let slopes = self.slopes(p, q).select_columns(free);
            let svd = slopes.svd(true, true);
            let largest = svd.singular_values.iter().fold(0.0, |most: f64, s| most.max(*s));
            svd.pseudo_inverse(RANK * largest).expect("both factors were asked for, and no rank is below 0")
        };
        let mut inverse = inverse_at(&q);
        for _ in 0..STEPS {
            let step = &inverse * &open;
            if !step.iter().all(|x| x.is_finite()) {
                break;
            }
            let mut share = 1.0;
            let mut better = None;
            for _ in 0..HALVINGS {
                let mut next = q.clone();
                for (at, step) in free.iter().zip(step.iter()) {
                    next[*at] -= share * step;
                }
                let left = DVector::from_vec(self.open(p, &next));
                if left.norm() < open.norm() {
                    better = Some((next, left));
                    break;
                }
                share /= 2.0;
            }
            let Some((next, left)) = better else { break };
            (q, open) = (next, left);
            inverse = inverse_at(&q);
        }
        let open: Vec<f64> = open.iter().copied().collect();
        let is_closed = self.is_closed(p, &q, &open, OPEN);
        Found { q, open, is_closed, inverse }
    }
}

/// The sum of the sizes of what a loop is made of.
fn size(slopes: &DMatrix<f64>, row: usize, q: &[f64]) -> f64 {
    slopes.row(row).iter().zip(q).map(|(slope, q)| (slope * q).abs().max(slope.abs())).sum()
}
