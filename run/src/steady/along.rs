//! A steady motion followed along a number: where eigenvalues pass the imaginary axis, and where it ends.

use super::Question;
use super::about::About;
use super::dense::Wide;
use super::eigen::Mode;
use super::newton::{Steady, Unknowns};
use super::search::{ELSEWHERE, unknowns};
use crate::{Error, Mechanism};
use tripos_derive::scene::Asked;
use tripos_traits::{DoubleDouble, Scalar};

/// Halvings of an interval on the way to a crossing, at most, and its width beside the number where it is found.
const HALVINGS: usize = 200;
const WIDTH: f64 = 4.0 * f64::EPSILON;
/// Crossings that are told apart between two values.
const MOST_CROSSINGS: usize = 32;

/// A steady motion at one value of the number.
#[derive(Clone, Debug)]
pub struct Point {
    /// The value.
    pub value: f64,
    /// What is near it there.
    pub about: About,
}

/// What happens between values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CrossingKind {
    /// A real eigenvalue passes 0: other steady motions branch off, or it exchanges stability with them.
    Real,
    /// A pair of eigenvalues passes the imaginary axis: oscillations begin to grow, or end to (E. Hopf).
    Pair,
    /// Two steady motions meet and end: no steady motion goes on beyond.
    Fold,
}

impl CrossingKind {
    /// Its name in JSON and tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Real => "real",
            Self::Pair => "pair",
            Self::Fold => "fold",
        }
    }
}

/// Where a steady motion changes its stability, or ends.
#[derive(Clone, Debug)]
pub struct Crossing {
    /// What happens.
    pub kind: CrossingKind,
    /// At which value.
    pub value: f64,
    /// The angular frequency there, rad/s: 0 but for a pair.
    pub frequency: f64,
}

/// A steady motion along a number.
#[derive(Clone, Debug, Default)]
pub struct Course {
    /// At the values that were asked for, as far as it goes.
    pub points: Vec<Point>,
    /// What happens between them.
    pub crossings: Vec<Crossing>,
    /// Why it ends before the last value.
    pub ended: Option<String>,
}

/// Follows a steady motion over values of a number of the state file, which `asked` puts in.
///
/// # Errors
/// [`Error`] as [`super::equilibria`], at the first value.
pub fn follow(
    model: &Mechanism,
    asked: &mut dyn FnMut(f64) -> Result<Asked, Error>,
    values: &[f64],
) -> Result<Course, Error> {
    let Some(first) = values.first() else { return Ok(Course::default()) };
    let mut question = Question::new(model, &asked(*first)?, &[])?;
    along((model, &mut question), asked, values)
}

/// Follows a steady motion, as [`follow`] does, of a question that was put already.
pub(super) fn along(
    (model, question): (&Mechanism, &mut Question),
    asked: &mut dyn FnMut(f64) -> Result<Asked, Error>,
    values: &[f64],
) -> Result<Course, Error> {
    let mut course = Course::default();
    let Some(first) = values.first() else { return Ok(course) };
    let start = asked(*first)?;
    let mut unknowns = unknowns(question, &start);
    if let Some(last) = values.last() {
        // What the number moves is held.
        let other = asked(*last)?;
        unknowns.states.retain(|at| start.x[*at] == other.x[*at]);
    }
    let mut way = Way { model, question, unknowns, asked };
    for value in values {
        let from = course.points.last();
        match (way.point(*value, from.map(|point| &point.about.steady)), from) {
            (Ok(point), None) => course.points.push(point),
            (Ok(point), Some(from)) => {
                course.crossings.extend(way.crossings(from, &point)?);
                course.points.push(point);
            }
            (Err(error), None) => return Err(error),
            (Err(_), Some(from)) => {
                let last = way.end(from, *value);
                course.crossings.push(Crossing { kind: CrossingKind::Fold, value: last, frequency: 0.0 });
                course.ended = Some(format!("no steady motion near it was found beyond {last}"));
                break;
            }
        }
    }
    Ok(course)
}

/// On the way along a number.
struct Way<'w> {
    model: &'w Mechanism,
    question: &'w mut Question,
    unknowns: Unknowns,
    asked: &'w mut dyn FnMut(f64) -> Result<Asked, Error>,
}

impl Way<'_> {
    /// The steady motion at a value, sought from one that is near.
    fn point(&mut self, value: f64, near: Option<&Steady>) -> Result<Point, Error> {
        self.point_in(value, near, true)
    }

    /// The steady motion at a value of the parameter, with its family looked for or not.
    fn point_in(&mut self, value: f64, near: Option<&Steady>, with_family: bool) -> Result<Point, Error> {
        let asked = (self.asked)(value)?;
        self.question.at(&asked.parameters);
        let mut x: Vec<DoubleDouble> = asked.x;
        if let Some(near) = near {
            self.unknowns.states.iter().for_each(|at| x[*at] = near.x[*at]);
        }
        let steady = self.question.settle(&x, &self.unknowns);
        if !steady.is_steady() {
            return Err(self.question.unbalanced(&steady, ELSEWHERE));
        }
        Ok(Point { value, about: self.question.about_in(self.model, steady, false, with_family)? })
    }

    /// The last value at which it is found, between one at which it is and one at which it is not.
    fn end(&mut self, from: &Point, to: f64) -> f64 {
        let (mut near, mut last, mut beyond) = (from.about.steady.clone(), from.value, to);
        for _ in 0..HALVINGS {
            let middle = last / 2.0 + beyond / 2.0;
            if (beyond - last).abs() <= 1e-10 * last.abs().max(1e-3) {
                break;
            }
            match self.point_in(middle, Some(&near), false) {
                Ok(point) => (near, last) = (point.about.steady, middle),
                Err(_) => beyond = middle,
            }
        }
        last
    }

    /// Eigenvalues that pass the imaginary axis between two points: one that is real where the product of all that are not the family's
    /// changes its sign, which is known where eigenvalues near 0 are not; a pair where the number of those that grow changes by two. Two
    /// real ones that meet and become a pair pass nothing.
    fn crossings(&mut self, from: &Point, to: &Point) -> Result<Vec<Crossing>, Error> {
        let family = from.about.still;
        let is_negative = |point: &Point| is_negative(&point.about.system.a, family);
        let stands = |point: &Point| (growing(point), is_negative(point));
        let mut list = Vec::new();
        let mut from = from.clone();
        for _ in 0..MOST_CROSSINGS {
            if stands(&from) == stands(to) {
                break;
            }
            let [before, after] = self.change(&from, to, stands)?;
            let passing = after.about.modes.iter().filter(|mode| mode.value[1] > 0.0);
            let passing = passing.min_by(|a, b| a.value[0].abs().total_cmp(&b.value[0].abs()));
            let (kind, frequency) = match passing {
                _ if is_negative(&before) != is_negative(&after) => (Some(CrossingKind::Real), 0.0),
                Some(mode) if growing(&before).abs_diff(growing(&after)) == 2 => {
                    (Some(CrossingKind::Pair), mode.value[1])
                }
                _ => (None, 0.0),
            };
            list.extend(kind.map(|kind| Crossing { kind, value: after.value, frequency }));
            from = after;
        }
        Ok(list)
    }

    /// The last point, to rounding, where something is as at the beginning, and the first one where it is not, by halving.
    fn change<T: PartialEq>(
        &mut self,
        from: &Point,
        to: &Point,
        what: impl Fn(&Point) -> T,
    ) -> Result<[Point; 2], Error> {
        let (mut low, mut high) = (from.clone(), to.clone());
        let before = what(from);
        for _ in 0..HALVINGS {
            let middle = low.value / 2.0 + high.value / 2.0;
            let width = (high.value - low.value).abs();
            if width <= WIDTH * low.value.abs().max(high.value.abs()) {
                break;
            }
            let point = self.point_in(middle, Some(&low.about.steady), false)?;
            let side = if what(&point) == before { &mut low } else { &mut high };
            *side = point;
        }
        Ok([low, high])
    }
}

/// How many eigenvalues grow.
fn growing(point: &Point) -> usize {
    let grows = |mode: &&Mode| mode.grows();
    point.about.modes.iter().filter(grows).count()
}

/// Whether the coefficient of s^family in det(s − A), ± the sum of the products of n − family eigenvalues, is negative (D. K. Faddeev's
/// recurrence).
fn is_negative(a: &Wide, family: usize) -> bool {
    let n = a.rows.len();
    let one = DoubleDouble::int(1);
    let mut matrix = Wide::zeros(n, n);
    let mut coefficient = one;
    for k in 1..=n.saturating_sub(family) {
        for (at, row) in matrix.rows.iter_mut().enumerate() {
            row[at] = row[at] + coefficient;
        }
        matrix = Wide::zeros(n, n).plus(1.0, a, &matrix);
        let trace = (0..n).fold(DoubleDouble::int(0), |sum, at| sum + matrix.rows[at][at]);
        coefficient = -trace / DoubleDouble::int(i64::try_from(k).unwrap_or(1));
    }
    coefficient.hi() < 0.0
}
