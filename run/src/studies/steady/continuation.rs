//! Follows a steady motion along a varied number. Finds the eigenvalues that cross the imaginary axis,
//! and the end of the motion.

use super::SteadyProblem;
use super::equilibrium_search::{ELSEWHERE, search_unknowns};
use super::linear_system::{FamilySearch, SteadyLinearSystem};
use super::quotient_system::ShiftedStates;
use super::spectra::mode::Mode;
use super::spectra::wide_matrix::WideMatrix;
use super::steady_newton::Unknowns;
use super::steady_state::SteadyState;
use crate::{Error, Mechanism};
use tripos_derive::scene::StateWithUnknowns;
use tripos_traits::{DoubleDouble, Scalar};

/// Largest number of halvings of the interval that contains a crossing or an end.
const HALVINGS: usize = 200;
/// Relative width below which an interval is no longer halved.
const WIDTH: f64 = 4.0 * f64::EPSILON;
/// Relative difference of two values of the varied number up to which two crossings count as equal.
const SAME: f64 = 1e-9;
/// Largest number of crossings that are searched for between two given values of the varied number.
const MOST_CROSSINGS: usize = 32;

/// Steady motion at one value of the varied number.
#[derive(Clone, Debug)]
pub struct ContinuationPoint {
    /// Value of the varied number, in the unit of the state file.
    pub value: f64,
    /// Linear system near the steady motion at this value.
    pub about: SteadyLinearSystem,
}

/// Kind of change of a steady motion along a varied number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CrossingKind {
    /// A real eigenvalue passes 0. Other steady motions branch off, or exchange stability with this
    /// motion.
    Real,
    /// A pair of complex eigenvalues passes the imaginary axis, and oscillations begin or cease to grow
    /// (E. Hopf).
    Pair,
    /// The steady motion ends, because it meets another steady motion.
    Fold,
}

impl CrossingKind {
    /// Name of the kind, for JSON and tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Real => "real",
            Self::Pair => "pair",
            Self::Fold => "fold",
        }
    }
}

/// Change of stability of a steady motion, or its end, at a value of the varied number.
#[derive(Clone, Debug)]
pub struct StabilityCrossing {
    /// Kind of the change, such as a real eigenvalue that passes 0.
    pub kind: CrossingKind,
    /// Value of the varied number at the change.
    pub value: f64,
    /// Angular frequency of the oscillations at the change, rad/s; 0 unless a pair of eigenvalues
    /// crosses.
    pub frequency: f64,
}

/// Steady motion followed along a varied number: its points, its changes of stability and its end.
#[derive(Clone, Debug, Default)]
pub struct Continuation {
    /// Points at the given values of the number, up to the end of the motion.
    pub points: Vec<ContinuationPoint>,
    /// Changes of stability between the points, and the end of the motion if it has one.
    pub crossings: Vec<StabilityCrossing>,
    /// Reason why the motion ends before the last value; `None` if it exists at the last value.
    pub ended: Option<String>,
}

/// Follows a steady motion over the values of a number in the state file. `asked` reads the state file
/// with a given value of this number.
///
/// # Errors
/// `Error` if no steady motion is found at the first value, or if the state file cannot be read with a
/// value.
pub fn continue_steady_motion(
    model: &Mechanism,
    asked: &mut dyn FnMut(f64) -> Result<StateWithUnknowns, Error>,
    values: &[f64],
) -> Result<Continuation, Error> {
    let Some(first) = values.first() else { return Ok(Continuation::default()) };
    let mut question = SteadyProblem::new(model, &asked(*first)?, &[])?;
    continue_prepared(model, &mut question, asked, values)
}

/// Follows a steady motion over the values of a number in the state file, for a prepared mechanism.
/// `asked` reads the state file with a given value of this number.
///
/// # Errors
/// `Error` if no steady motion is found at the first value, or if the state file cannot be read with a
/// value.
pub(super) fn continue_prepared(
    model: &Mechanism,
    question: &mut SteadyProblem,
    asked: &mut dyn FnMut(f64) -> Result<StateWithUnknowns, Error>,
    values: &[f64],
) -> Result<Continuation, Error> {
    let mut course = Continuation::default();
    let Some(first) = values.first() else { return Ok(course) };
    let start = asked(*first)?;
    let mut unknowns = search_unknowns(question, &start);
    if let Some(last) = values.last() {
        // States that the varied number changes are not solved for.
        let other = asked(*last)?;
        unknowns.states.retain(|at| start.x[*at] == other.x[*at]);
    }
    let mut way = ContinuedMotion { model, question, unknowns, asked };
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
                let last = way.last_value_found(from, *value);
                course.crossings.push(StabilityCrossing { kind: CrossingKind::Fold, value: last, frequency: 0.0 });
                course.ended = Some(format!("no steady motion was found nearby beyond {last}"));
                break;
            }
        }
    }
    Ok(course)
}

/// Steady motion that is followed along a varied number: its mechanism, its equations and its unknowns.
struct ContinuedMotion<'w> {
    /// Mechanism whose motion is followed.
    model: &'w Mechanism,
    /// Prepared equations, at the parameters of the last value.
    question: &'w mut SteadyProblem,
    /// Unknowns of the search for the steady motion.
    unknowns: Unknowns,
    /// Function that reads the state file with a value of the number.
    asked: &'w mut dyn FnMut(f64) -> Result<StateWithUnknowns, Error>,
}

impl ContinuedMotion<'_> {
    /// Finds the steady motion at a value of the number, and its family of neighbouring steady motions.
    /// The search begins at the steady motion `near`, or at the guess if this is `None`.
    ///
    /// # Errors
    /// `Error` if no steady motion is found, or if it has no linear system.
    fn point(&mut self, value: f64, near: Option<&SteadyState>) -> Result<ContinuationPoint, Error> {
        self.point_with_family(value, near, FamilySearch::Sought)
    }

    /// Finds the steady motion at a value of the number. The search begins at the steady motion `near`, or
    /// at the guess if this is `None`. `family` tells if neighbouring steady motions are searched for.
    ///
    /// # Errors
    /// `Error` if no steady motion is found, or if it has no linear system.
    fn point_with_family(
        &mut self,
        value: f64,
        near: Option<&SteadyState>,
        family: FamilySearch,
    ) -> Result<ContinuationPoint, Error> {
        let asked = (self.asked)(value)?;
        self.question.set_parameters(&asked.parameters);
        let mut x: Vec<DoubleDouble> = asked.x;
        if let Some(near) = near {
            self.unknowns.states.iter().for_each(|at| x[*at] = near.x[*at]);
        }
        let steady = self.question.find_steady_state(&x, &self.unknowns);
        if !steady.is_steady() {
            return Err(self.question.not_steady_error(&steady, ELSEWHERE));
        }
        Ok(ContinuationPoint {
            value,
            about: self.question.linear_system_with_family(self.model, steady, ShiftedStates::LeftOut, family)?,
        })
    }

    /// Finds the last value of the number at which the steady motion exists. This value lies between the
    /// value at `from`, and `to`, where no steady motion is found.
    fn last_value_found(&mut self, from: &ContinuationPoint, to: f64) -> f64 {
        let (mut near, mut last, mut beyond) = (from.about.steady.clone(), from.value, to);
        for _ in 0..HALVINGS {
            let middle = last / 2.0 + beyond / 2.0;
            if (beyond - last).abs() <= 1e-10 * last.abs().max(1e-3) {
                break;
            }
            match self.point_with_family(middle, Some(&near), FamilySearch::LeftOut) {
                Ok(point) => (near, last) = (point.about.steady, middle),
                Err(_) => beyond = middle,
            }
        }
        last
    }

    /// Finds the eigenvalues that cross the imaginary axis between two points.
    ///
    /// A real eigenvalue crosses where the product of all eigenvalues changes its sign. The zero
    /// eigenvalues of the family of steady motions are left out of the product. Its sign is known even
    /// if eigenvalues near 0 are not. A pair crosses where the number of growing eigenvalues changes by
    /// two. Two real eigenvalues that meet and become a pair do not cross.
    ///
    /// # Errors
    /// `Error` if no steady motion is found between the points.
    fn crossings(&mut self, from: &ContinuationPoint, to: &ContinuationPoint) -> Result<Vec<StabilityCrossing>, Error> {
        let family = from.about.still;
        let is_negative = |point: &ContinuationPoint| is_eigenvalue_product_negative(&point.about.system.a, family);
        let stands = |point: &ContinuationPoint| (growing_mode_count(point), is_negative(point));
        let mut list = Vec::<StabilityCrossing>::new();
        let mut from = from.clone();
        for _ in 0..MOST_CROSSINGS {
            if stands(&from) == stands(to) {
                break;
            }
            let [before, after] = self.bracket_change(&from, to, stands)?;
            let passing = after.about.modes.iter().filter(|mode| mode.value[1] > 0.0);
            let passing = passing.min_by(|a, b| a.value[0].abs().total_cmp(&b.value[0].abs()));
            let (kind, frequency) = match passing {
                _ if is_negative(&before) != is_negative(&after) => (Some(CrossingKind::Real), 0.0),
                Some(mode) if growing_mode_count(&before).abs_diff(growing_mode_count(&after)) == 2 => {
                    (Some(CrossingKind::Pair), mode.value[1])
                }
                _ => (None, 0.0),
            };
            // Next to a crossing, eigenvalues near 0 may be undecided in an interval of the number. The changes
            // at both ends of this interval are the same crossing.
            let is_same = |known: &StabilityCrossing| (known.value - after.value).abs() <= SAME * after.value.abs();
            let kind = kind.filter(|_| !list.iter().any(is_same));
            list.extend(kind.map(|kind| StabilityCrossing { kind, value: after.value, frequency }));
            from = after;
        }
        Ok(list)
    }

    /// Finds the first point after `from` at which the value of `what` differs from its value at `from`.
    /// The interval up to `to` is halved down to rounding. Returns the last point before the change, and
    /// the first point after it.
    ///
    /// # Errors
    /// `Error` if no steady motion is found between the points.
    fn bracket_change<T: PartialEq>(
        &mut self,
        from: &ContinuationPoint,
        to: &ContinuationPoint,
        what: impl Fn(&ContinuationPoint) -> T,
    ) -> Result<[ContinuationPoint; 2], Error> {
        let (mut low, mut high) = (from.clone(), to.clone());
        let before = what(from);
        for _ in 0..HALVINGS {
            let middle = low.value / 2.0 + high.value / 2.0;
            let width = (high.value - low.value).abs();
            if width <= WIDTH * low.value.abs().max(high.value.abs()) {
                break;
            }
            let point = self.point_with_family(middle, Some(&low.about.steady), FamilySearch::LeftOut)?;
            let side = if what(&point) == before { &mut low } else { &mut high };
            *side = point;
        }
        Ok([low, high])
    }
}

/// Number of growing modes at a point: eigenvalues with a positive real part.
fn growing_mode_count(point: &ContinuationPoint) -> usize {
    let grows = |mode: &&Mode| mode.grows();
    point.about.modes.iter().filter(grows).count()
}

/// True if the coefficient of s^family in det(s − A) is negative. Up to its sign, the coefficient
/// is the sum of the products of n − family eigenvalues (D. K. Faddeev's recurrence).
fn is_eigenvalue_product_negative(a: &WideMatrix, family: usize) -> bool {
    let n = a.rows.len();
    let one = DoubleDouble::int(1);
    let mut matrix = WideMatrix::zeros(n, n);
    let mut coefficient = one;
    for k in 1..=n.saturating_sub(family) {
        for (at, row) in matrix.rows.iter_mut().enumerate() {
            row[at] = row[at] + coefficient;
        }
        matrix = WideMatrix::zeros(n, n).plus_product(1.0, a, &matrix);
        let trace = (0..n).fold(DoubleDouble::int(0), |sum, at| sum + matrix.rows[at][at]);
        coefficient = -trace / DoubleDouble::int(i64::try_from(k).unwrap_or(1));
    }
    coefficient.hi() < 0.0
}
