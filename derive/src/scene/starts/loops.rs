//! Loops of a mechanism as functions of parameters and coordinates, and Newton's method for poses in which they are
//! closed.

use super::proved_zero::enclose_zero;
use crate::algebra::Expr;
use crate::algebra::term::calculus::Gradient;
use crate::algebra::value::tape::Tape;
use crate::model::Model;
use crate::model::constraints::closed_pose_search::RandomNumbers;
use crate::scene::numbers::scene_number::Number;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;
use tripos_linear::{SingularValues, singular_values};
use tripos_traits::{Ball, DoubleDouble, Scalar};

/// Number of random poses from which a pose with right orientations is searched.
const TRIES: u32 = 60;
/// Largest number of steps of Newton's method.
const STEPS: usize = 100;
/// Largest number of times that a single Newton step is halved.
const HALVINGS: usize = 40;
/// Residual up to which a loop counts as closed, relative to the sum of the sizes of the loop's
/// terms.
const OPEN: f64 = 1e-13;
/// Residual up to which a loop counts as closed if no coordinate is free, relative to the size of
/// its terms. Stated coordinates may have few digits.
const HELD: f64 = 1e-9;
/// Singular value below which the matrix of derivatives loses rank in Newton's method, relative to the largest
/// singular value.
const RANK: f64 = 1e-10;
/// Smallest singular value up to which loops count as dependent, relative to the largest singular value. It is large,
/// since a pose that is a double root has only half of the digits.
const SINGULAR: f64 = 1e-6;

/// Share of a loop's largest term that counts as size of the loop where its derivatives are smaller. The derivatives of
/// a redundant loop may vanish in every closed pose.
const LEAST_SIZE: f64 = 1e-2;
/// Norm of a redundant loop's derivatives below which they count as zero, relative to the norm of all derivatives.
const VANISHING: f64 = 1e-8;

/// Loop equations of a model as functions of parameters and coordinates. Independent loops come first, then redundant
/// loops. Variables that constraints determine follow, if they are held at values.
pub struct Loops {
    /// Program that computes the left sides of the loops, then the held variables.
    values: Tape,
    /// Program that computes the partial derivatives of the loops, then of the held variables, with respect to the
    /// coordinates, row by row.
    slopes: Tape,
    /// Names of the loops, then of the held variables.
    names: Vec<String>,
    /// Number of independent loops.
    independent: usize,
    /// Number of all loops, redundant loops included.
    count: usize,
    /// Values at which variables that constraints determine are held.
    held: Vec<Ball>,
    /// Program that computes the sum of the cosines of each orientation that a joint holds.
    cosines: Tape,
    /// Names of the joints that hold these orientations.
    joints: Vec<String>,
}

/// Residual of a redundant loop. It should vanish if the independent loops are closed.
#[derive(Clone, Copy, Debug)]
pub struct DependentLoop<'l> {
    /// Name of the redundant loop in the model file.
    pub name: &'l str,
    /// Left side of the loop equation in the given pose, in the equation's SI unit.
    pub residual: f64,
    /// Absolute value of the residual, relative to the sum of the sizes of the loop's terms.
    pub part: f64,
}

/// Result of a search for a pose in which all loops are closed.
pub(in crate::scene) struct FoundPose {
    /// Coordinates of the pose, in SI units.
    pub q: Vec<f64>,
    /// Residual of each loop in its SI unit, then the deviation of each held variable from its value.
    pub open: Vec<f64>,
    /// True if all loops are closed within rounding.
    pub is_closed: bool,
    /// Pseudo-inverse of the loops' derivatives with respect to the free coordinates: a row for each
    /// free coordinate.
    pub inverse: DMatrix<f64>,
}

impl Loops {
    /// Creates the loops of a model, without held variables.
    #[must_use]
    pub fn new(model: &Model) -> Self {
        Self::with_held_variables(model, &[])
    }

    /// Creates the loops of a model with held variables. Each is (index of the constraint that determines the
    /// variable, value).
    pub(in crate::scene) fn with_held_variables(model: &Model, held: &[(usize, Number)]) -> Self {
        let arena = &mut model.arena.clone();
        let coordinates = model.q();
        let inputs = [model.p(), coordinates.clone()].concat();
        let all = || model.loops.iter().chain(&model.closed);
        let fixed = || held.iter().map(|(at, _)| &model.constraints[*at]);
        let equations: Vec<Expr> = all().map(|c| c.equation).chain(fixed().map(|c| c.value)).collect();
        let mut gradient = Gradient::new(&coordinates);
        let mut slopes = vec![Expr::ZERO; equations.len() * coordinates.len()];
        // The search never changes time, so the derivatives with respect to time stay zero.
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
        let names: Vec<String> = all().map(|c| c.name.clone()).chain(fixed().map(|c| c.fixes.clone())).collect();
        Self {
            values: tape(&equations),
            slopes: tape(&slopes),
            independent: model.loops.len(),
            count: names.len() - held.len(),
            names,
            held: held.iter().map(|(_, value)| value.enclosure()).collect(),
            cosines: tape(&model.orientations.iter().map(|held| held.cosines).collect::<Vec<_>>()),
            joints: model.orientations.iter().map(|held| held.joint.clone()).collect(),
        }
    }

    /// Names of the loops, followed by the names of the held variables.
    pub(in crate::scene) fn names(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(String::as_str)
    }

    /// Residuals of the redundant loops in a pose, for parameters `p` and coordinates `q` in SI units.
    #[must_use]
    pub fn redundant_residuals(&self, p: &[f64], q: &[f64]) -> Vec<DependentLoop<'_>> {
        let (open, sizes) = (self.loop_residuals(p, q), self.term_sizes(p, q));
        let following = (self.independent..self.count).map(|row| DependentLoop {
            name: &self.names[row],
            residual: open[row],
            part: open[row].abs() / sizes[row],
        });
        following.collect()
    }

    /// Finds a closed pose near `q`, to 32 digits. Only the coordinates with the indices `free` change. `None` if no
    /// closed pose is found, or if the loops do not determine the free coordinates.
    #[must_use]
    pub fn close(&self, p: &[DoubleDouble], q: &[DoubleDouble], free: &[usize]) -> Option<Vec<DoubleDouble>> {
        let doubles = |list: &[DoubleDouble]| list.iter().map(|x| x.hi()).collect::<Vec<f64>>();
        let known = doubles(p);
        if free.is_empty() {
            let held = doubles(q);
            return self.is_closed(&known, &held, &self.loop_residuals(&known, &held), HELD).then(|| q.to_vec());
        }
        let found = self.closed_pose_near(&known, &doubles(q), free);
        let slopes = self.slopes(&known, &found.q).select_columns(free);
        let sizes = singular_values(&slopes);
        let determines = slopes.nrows() >= free.len() && sizes.min() > SINGULAR * sizes.max();
        if !found.is_closed || !determines || self.turned_joint(&known, &found.q).is_some() {
            return None;
        }
        // With derivatives in doubles, each step adds about sixteen digits.
        let mut precise = q.to_vec();
        for at in free {
            precise[*at] = found.q[*at].into();
        }
        for _ in 0..3 {
            let open = self.loop_residuals_extended(p, &precise);
            for (row, at) in free.iter().enumerate() {
                for (column, open) in open.iter().enumerate() {
                    precise[*at] = precise[*at] - DoubleDouble::from_f64(found.inverse[(row, column)]) * *open;
                }
            }
        }
        Some(precise)
    }

    /// Residuals in the pose `q`, as (name, residual in SI units): of each loop, then of each held variable.
    #[must_use]
    pub fn openings(&self, p: &[f64], q: &[f64]) -> Vec<(&str, f64)> {
        self.names.iter().map(String::as_str).zip(self.loop_residuals(p, q)).collect()
    }

    /// Name of a redundant loop whose derivatives in this pose are no combination of those of the independent loops,
    /// although they should be. `None` if there is no such loop.
    pub(in crate::scene) fn violated_redundant_loop(&self, p: &[f64], q: &[f64]) -> Option<&str> {
        if self.independent == self.count {
            return None;
        }
        let slopes = self.slopes(p, q);
        let axes = slopes.rows(0, self.independent).transpose().qr().q();
        (self.independent..self.count).find_map(|row| {
            let row_of = slopes.row(row).transpose();
            let left = &row_of - &axes * axes.tr_mul(&row_of);
            let size = row_of.norm().max(VANISHING / SINGULAR * slopes.norm());
            (left.norm() > SINGULAR * size).then(|| self.names[row].as_str())
        })
    }

    /// Residual of each loop, then the deviation of each held variable from its value, in SI units.
    pub(in crate::scene) fn loop_residuals(&self, p: &[f64], q: &[f64]) -> Vec<f64> {
        let mut open = self.values.evaluate(&[p, q].concat());
        for (open, held) in open[self.count..].iter_mut().zip(&self.held) {
            *open -= held.centre.hi();
        }
        open
    }

    /// Residual of each loop, then the deviation of each held variable from its value, in SI units and to 32 digits.
    pub(in crate::scene) fn loop_residuals_extended(
        &self,
        p: &[DoubleDouble],
        q: &[DoubleDouble],
    ) -> Vec<DoubleDouble> {
        let mut open = self.values.to::<DoubleDouble>().evaluate(&[p, q].concat());
        for (open, held) in open[self.count..].iter_mut().zip(&self.held) {
            *open = *open - held.centre;
        }
        open
    }

    /// Balls that contain the coordinates with the indices `free` in exactly one closed pose near `q`. `None` if this
    /// is not proved, or if the independent loops and held variables are not as many as these coordinates.
    pub(in crate::scene) fn enclosed_pose(&self, p: &[Ball], q: &[Ball], free: &[usize]) -> Option<Vec<Ball>> {
        let rows: Vec<usize> = (0..self.independent).chain(self.count..self.names.len()).collect();
        if rows.len() != free.len() {
            return None;
        }
        let (values, slopes) = (self.values.to::<Ball>(), self.slopes.to::<Ball<f64>>());
        let residuals = |x: &[Ball]| {
            let mut open = values.evaluate(&[p, &with_free(q, free, x)].concat());
            for (open, held) in open[self.count..].iter_mut().zip(&self.held) {
                *open = *open - *held;
            }
            rows.iter().map(|row| open[*row]).collect()
        };
        let narrow = |list: &[Ball]| list.iter().map(|x| Ball::narrowed(*x)).collect::<Vec<Ball<f64>>>();
        let (p_narrow, q_narrow) = (narrow(p), narrow(q));
        let derivatives = |x: &[Ball<f64>]| {
            let all = slopes.evaluate(&[&p_narrow[..], &with_free(&q_narrow, free, x)].concat());
            rows.iter().flat_map(|row| free.iter().map(|at| all[row * q.len() + at]).collect::<Vec<_>>()).collect()
        };
        let middle: Vec<DoubleDouble> = free.iter().map(|at| q[*at].centre).collect();
        enclose_zero(&middle, residuals, derivatives)
    }

    /// Matrix of the loops' partial derivatives in a pose. It has a row for each loop, then for each held variable,
    /// and a column for each coordinate.
    fn slopes(&self, p: &[f64], q: &[f64]) -> DMatrix<f64> {
        let values = self.slopes.evaluate(&[p, q].concat());
        DMatrix::from_row_slice(values.len() / q.len().max(1), q.len(), &values)
    }

    /// True if no residual in `open` exceeds `part` times the size of the loop's terms.
    pub(in crate::scene) fn is_closed(&self, p: &[f64], q: &[f64], open: &[f64], part: f64) -> bool {
        open.iter().zip(self.term_sizes(p, q)).all(|(open, size)| open.abs() <= part * size)
    }

    /// Size of the terms of each loop and of each held variable, in its SI unit: |∂φ/∂q| max(1, |q|), summed over the
    /// coordinates q, but at least `LEAST_SIZE` times the largest term.
    fn term_sizes(&self, p: &[f64], q: &[f64]) -> Vec<f64> {
        let slopes = self.slopes(p, q);
        let largest = self.values.largest_terms(&[p, q].concat());
        largest.iter().enumerate().map(|(row, term)| loop_term_size(&slopes, row, q).max(LEAST_SIZE * term)).collect()
    }

    /// True if the derivatives of the independent loops are linearly dependent in this pose (it is singular).
    pub(in crate::scene) fn is_singular(&self, p: &[f64], q: &[f64]) -> bool {
        if self.independent == 0 {
            return false;
        }
        let values = singular_values(&self.slopes(p, q).rows(0, self.independent));
        values.min() <= SINGULAR * values.max()
    }

    /// Name of a joint that closes a loop and whose frames are half a turn away from their orientation in the closed
    /// pose `q`. `None` if there is no such joint.
    pub(in crate::scene) fn turned_joint(&self, p: &[f64], q: &[f64]) -> Option<&str> {
        let cosines = self.cosines.evaluate(&[p, q].concat());
        cosines.iter().zip(&self.joints).find(|(sum, _)| **sum <= 0.0).map(|(_, joint)| joint.as_str())
    }

    /// Finds a closed pose from the pose `start` by Newton's method. If a joint is half a turn away from its
    /// orientation in that pose, the search starts again from random poses, at first near `start`. Only the coordinates
    /// with the indices `free` change. If no pose with right orientations is found, the result is that of the first
    /// search.
    pub(in crate::scene) fn closed_pose_near(&self, p: &[f64], start: &[f64], free: &[usize]) -> FoundPose {
        let first = self.newton(p, start, free);
        if !first.is_closed || self.turned_joint(p, &first.q).is_none() {
            return first;
        }
        let mut chance = RandomNumbers::new();
        let is_right = |found: &FoundPose| found.is_closed && self.turned_joint(p, &found.q).is_none();
        let mut others = (1..=TRIES).map(|at| {
            let mut beside = start.to_vec();
            for place in free {
                beside[*place] += f64::from(at) / f64::from(TRIES) * PI * chance.draw();
            }
            self.newton(p, &beside, free)
        });
        let Some(mut found) = others.find(is_right) else { return first };
        // Coordinates that need not differ from those of `start` return to them.
        let distance = |q: &[f64]| q.iter().zip(start).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
        for place in free {
            let mut beside = found.q.clone();
            beside[*place] = start[*place];
            let other = self.newton(p, &beside, free);
            if is_right(&other) && distance(&other.q) < distance(&found.q) {
                found = other;
            }
        }
        found
    }

    /// Runs Newton's method with halved steps from the pose `start`. Only the coordinates with the indices `free`
    /// change. If the loops do not determine all of them, each step is the smallest change.
    pub(in crate::scene) fn newton(&self, p: &[f64], start: &[f64], free: &[usize]) -> FoundPose {
        let mut q = start.to_vec();
        let mut open = DVector::from_vec(self.loop_residuals(p, &q));
        let inverse_at = |q: &[f64]| {
            let slopes = self.slopes(p, q).select_columns(free);
            let found = SingularValues::new(&slopes);
            let largest = found.values.iter().fold(0.0, |most: f64, s| most.max(*s));
            found.pseudo_inverse(RANK * largest)
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
                let left = DVector::from_vec(self.loop_residuals(p, &next));
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
        FoundPose { q, open, is_closed, inverse }
    }
}

/// List with other values at the given indices.
fn with_free<T: Copy>(list: &[T], free: &[usize], values: &[T]) -> Vec<T> {
    let mut list = list.to_vec();
    for (at, value) in free.iter().zip(values) {
        list[*at] = *value;
    }
    list
}

/// Sum of the sizes of the terms of the loop with the index `row`: |∂φ/∂q| max(1, |q|), summed over the coordinates
/// q.
fn loop_term_size(slopes: &DMatrix<f64>, row: usize, q: &[f64]) -> f64 {
    slopes.row(row).iter().zip(q).map(|(slope, q)| (slope * q).abs().max(slope.abs())).sum()
}
