//! Rates of all coordinates at a start, from stated rates or speeds and from the motion constraints.
//!
//! All conditions are linear in the rates: motion constraints, stated rates, stated speeds, and rates of variables
//! that constraints determine. They are solved in doubles by singular values, and then to 32 digits with the same
//! factors.
//!
//! If a rate stays undetermined, the file has to state more. A speed does not determine the motion at a dead point,
//! nor does the rate of a coordinate that cannot move.

use super::proved_zero::enclose_zero;
use super::start::SolvedVariable;
use crate::algebra::Expr;
use crate::algebra::term::calculus::Gradient;
use crate::algebra::value::tape::Tape;
use crate::model::Model;
use crate::plain_text::with_significant_digits;
use crate::scene::numbers::number_reader::ValueReader;
use crate::scene::numbers::scene_number::{Number, double_values, enclosed_values, extended_values};
use nalgebra::{DMatrix, DVector};
use std::ops::Range;
use tripos_linear::SingularValues;
use tripos_traits::{Ball, DoubleDouble, Scalar};

/// Singular value up to which a direction in the space of rates counts as undetermined, relative to the largest
/// singular value.
const RANK: f64 = 1e-9;
/// Component of a unit direction in the space of rates, above which the direction contains that rate.
const PART: f64 = 1e-6;
/// Residual up to which a condition on the rates is satisfied, relative to the largest rate and to the length of the
/// condition's row.
const RESIDUAL: f64 = 1e-9;
/// Number of refinements of the solved rates. Each adds about sixteen digits.
const REFINEMENTS: usize = 3;

/// Rates and speeds that a start states, by their indices in the lists of the model, in SI units.
#[derive(Default)]
pub(in crate::scene) struct StatedMotion {
    /// Stated rates of coordinates, as (index of the coordinate, rate).
    pub rates: Vec<(usize, Ball)>,
    /// Stated rates of variables that constraints determine, as (index of the constraint, rate).
    pub fixed: Vec<(usize, Ball)>,
    /// Stated generalized speeds, as (index of the speed, value).
    pub speeds: Vec<(usize, Ball)>,
}

/// Program that computes quantities which are linear in the rates. They are motion constraints, generalized speeds,
/// and rates of variables that constraints determine. Its inputs are parameters, coordinates and rates.
fn linear_in_rates(model: &Model) -> Tape {
    let arena = &mut model.arena.clone();
    let (coordinates, rates) = (model.q(), model.q_dot());
    let mut gradient = Gradient::new(&coordinates);
    let mut list: Vec<Expr> = model.motion_constraints.iter().map(|c| c.equation).collect();
    list.extend(model.speeds.iter().map(|speed| speed.definition));
    for constraint in &model.constraints {
        let slopes: Vec<(usize, Expr)> = gradient.apply(arena, constraint.value).to_vec();
        let mut rate = Expr::ZERO;
        for (at, slope) in slopes {
            let share = arena.mul(slope, rates[at]);
            rate = arena.add(rate, share);
        }
        list.push(rate);
    }
    match Tape::new(arena, &[model.p(), coordinates, rates].concat(), &list) {
        Ok(tape) => tape,
        Err(unknown) => unreachable!("constraints and speeds tie coordinates and rates, not {}", unknown.0),
    }
}

/// Linear condition on the rates: a quantity must have a given value.
struct Condition {
    /// Quantity that the condition restricts.
    of: ConditionTerm,
    /// Value that the quantity must have, in SI units.
    value: Ball,
    /// Name of the quantity in error messages.
    name: String,
}

/// Quantity that a condition restricts: an output of the program `linear_in_rates`, or the rate of a coordinate.
enum ConditionTerm {
    /// Output of the program `linear_in_rates`, by its index.
    Tape(usize),
    /// Rate of a coordinate, by the coordinate's index.
    Rate(usize),
}

impl ValueReader<'_, '_> {
    /// Solves for the rates of all coordinates, to 32 digits, in SI units. `None` after reporting rates that stay
    /// undetermined, or stated values that contradict one another.
    pub(in crate::scene) fn solve_rates(
        &mut self,
        stated: &StatedMotion,
        parameters: &[Number],
        q: &[Number],
        place: &Range<usize>,
    ) -> Option<Vec<DoubleDouble>> {
        if self.terms.conditions.is_none() {
            self.terms.conditions = Some(linear_in_rates(self.model));
        }
        let tape = self.terms.conditions.as_ref()?;
        let list = rate_conditions(self.model, stated);
        let n = q.len();
        let known = [double_values(parameters), double_values(q)].concat();
        let matrix = rate_condition_matrix(&list, n, |rates| tape.evaluate(&[&known, rates].concat()));
        let sizes: Vec<f64> = matrix.row_iter().map(|row| row.norm()).collect();
        let square = matrix.resize_vertically(list.len().max(n), 0.0);
        if !square.iter().all(|x| x.is_finite()) {
            self.reader.error(place.clone(), "the constraints have no value at this state", "choose another state");
            return None;
        }
        let found = SingularValues::new(&square);
        let least = RANK * found.values.max();
        let open = undetermined_rates(&found.values, &found.right, least);
        if !open.is_empty() {
            self.report_open_rates(stated, &open, place);
            return None;
        }
        let wide = tape.to::<DoubleDouble>();
        let known = [extended_values(parameters), extended_values(q)].concat();
        let mut rates = vec![DoubleDouble::int(0); n];
        let mut left = Vec::new();
        for _ in 0..=REFINEMENTS {
            let values = wide.evaluate(&[known.as_slice(), &rates].concat());
            left = list.iter().map(|condition| condition.value.centre - condition.at(&values, &rates)).collect();
            let sides = DVector::from_iterator(list.len(), left.iter().map(|left| left.hi()))
                .resize_vertically(list.len().max(n), 0.0);
            for (rate, step) in rates.iter_mut().zip(found.solve(&sides, least).iter()) {
                *rate = *rate + DoubleDouble::from_f64(*step);
            }
        }
        let most = rates.iter().fold(1.0, |most: f64, rate| most.max(rate.hi().abs()));
        let broken = list.iter().zip(&left).zip(&sizes).find(|((_, left), size)| {
            let left = left.hi().abs();
            left.is_nan() || left > RESIDUAL * most * size.max(1.0)
        });
        if let Some(((condition, left), _)) = broken {
            let message = format!(
                "no motion has the rates of the start: in the nearest motion, `{}` is off by {}",
                condition.name,
                with_significant_digits(left.hi(), 4)
            );
            self.reader.error(place.clone(), message, "state fewer rates: the others follow from the constraints");
            return None;
        }
        Some(rates)
    }

    /// Rates of all coordinates that were solved for, as numbers. In a wide reading they are balls if these are proved
    /// to contain the rates.
    pub(in crate::scene) fn numbers_of_solved_rates(
        &self,
        stated: &StatedMotion,
        parameters: &[Number],
        q: &[Number],
        solved: Vec<DoubleDouble>,
    ) -> Vec<Number> {
        let enclosed = self.is_wide.then(|| self.enclosed_rates(stated, parameters, q, &solved)).flatten();
        match enclosed {
            Some(balls) => balls.into_iter().map(Number::enclosed).collect(),
            None => solved.into_iter().map(Number::from_double_double).collect(),
        }
    }

    /// Balls that contain the rates of all coordinates, for rates that were solved for. `None` if this is not proved,
    /// or if there are more conditions than rates.
    fn enclosed_rates(
        &self,
        stated: &StatedMotion,
        parameters: &[Number],
        q: &[Number],
        solved: &[DoubleDouble],
    ) -> Option<Vec<Ball>> {
        let tape = self.terms.conditions.as_ref()?;
        let list = rate_conditions(self.model, stated);
        let (wide, narrow) = (tape.to::<Ball>(), tape.to::<Ball<f64>>());
        let known = [enclosed_values(parameters), enclosed_values(q)].concat();
        let residuals = |rates: &[Ball]| {
            let values = wide.evaluate(&[&known[..], rates].concat());
            list.iter().map(|condition| condition.at(&values, rates) - condition.value).collect()
        };
        let known: Vec<Ball<f64>> = known.iter().map(|x| Ball::narrowed(*x)).collect();
        // The conditions are linear, so that their differences along a rate are their derivatives.
        let slopes = |rates: &[Ball<f64>]| {
            let at = |rates: &[Ball<f64>]| narrow.evaluate(&[&known[..], rates].concat());
            let rest = vec![Ball::point(0.0); rates.len()];
            let still = at(&rest);
            let units = (0..rates.len()).map(|column| {
                let mut along = rest.clone();
                along[column] = Ball::point(1.0);
                along
            });
            let columns: Vec<_> = units.map(|along| (at(&along), along)).collect();
            let entry = |condition: &Condition, (values, along): &(Vec<Ball<f64>>, Vec<Ball<f64>>)| {
                condition.at(values, along) - condition.at(&still, &rest)
            };
            list.iter().flat_map(|c| columns.iter().map(|column| entry(c, column)).collect::<Vec<_>>()).collect()
        };
        enclose_zero(solved, residuals, slopes)
    }

    /// Reports coordinates whose rates the constraints and the stated motion leave undetermined.
    fn report_open_rates(&mut self, stated: &StatedMotion, open: &[usize], place: &Range<usize>) {
        let model = &self.model;
        let names: Vec<String> = open.iter().map(|at| format!("`{}'`", model.coordinates[*at].name)).collect();
        let (names, first) = (names.join(", "), &model.coordinates[open[0]].name);
        let (message, help) = if stated.speeds.is_empty() {
            (
                format!("the rates that the start states leave {names} open"),
                format!("state one of these rates as well, such as \"{first}'\" = 0"),
            )
        } else {
            let speeds: Vec<String> = model.speeds.iter().map(|speed| format!("`{}`", speed.name)).collect();
            let do_not = if speeds.len() == 1 { "does not" } else { "do not" };
            (
                format!(
                    "{} {do_not} determine {names} in this pose, a dead point of this choice of speeds",
                    speeds.join(", ")
                ),
                format!(
                    "state rates in place of speeds, such as \"{first}'\" = 0: as many as the mechanism has freedoms"
                ),
            )
        };
        self.reader.error(place.clone(), message, help);
    }

    /// Rates that the start does not state, with their solved values.
    pub(in crate::scene) fn solved_rates(&self, stated: &StatedMotion, rates: &[DoubleDouble]) -> Vec<SolvedVariable> {
        let is_stated = |at: usize| stated.rates.iter().any(|(other, _)| *other == at);
        let list = self.model.coordinates.iter().zip(rates).enumerate().filter(|(at, _)| !is_stated(*at));
        list.map(|(_, (c, rate))| SolvedVariable { name: format!("{}'", c.name), value: rate.hi(), is_rate: true })
            .collect()
    }
}

impl Condition {
    /// Value of the quantity that the condition restricts. `values` are the program's outputs, `rates` the rates of
    /// the coordinates.
    fn at<S: Copy>(&self, values: &[S], rates: &[S]) -> S {
        match self.of {
            ConditionTerm::Tape(at) => values[at],
            ConditionTerm::Rate(at) => rates[at],
        }
    }
}

/// All conditions on the rates: motion constraints, then stated speeds and stated rates.
fn rate_conditions(model: &Model, stated: &StatedMotion) -> Vec<Condition> {
    let (ties, speeds) = (model.motion_constraints.len(), model.speeds.len());
    let mut list: Vec<Condition> = Vec::new();
    for (at, constraint) in model.motion_constraints.iter().enumerate() {
        list.push(Condition { of: ConditionTerm::Tape(at), value: Ball::int(0), name: constraint.name.clone() });
    }
    for (at, value) in &stated.speeds {
        list.push(Condition {
            of: ConditionTerm::Tape(ties + at),
            value: *value,
            name: model.speeds[*at].name.clone(),
        });
    }
    for (at, value) in &stated.fixed {
        let name = format!("{}'", model.constraints[*at].fixes);
        list.push(Condition { of: ConditionTerm::Tape(ties + speeds + at), value: *value, name });
    }
    for (at, value) in &stated.rates {
        list.push(Condition {
            of: ConditionTerm::Rate(*at),
            value: *value,
            name: format!("{}'", model.coordinates[*at].name),
        });
    }
    list
}

/// Matrix of the conditions' derivatives with respect to the n rates, with a row for each condition. Differences give
/// it exactly, since the conditions are linear.
fn rate_condition_matrix(list: &[Condition], n: usize, evaluate: impl Fn(&[f64]) -> Vec<f64>) -> DMatrix<f64> {
    let mut along = vec![0.0; n];
    let still = evaluate(&along);
    let mut matrix = DMatrix::zeros(list.len(), n);
    for column in 0..n {
        along[column] = 1.0;
        let values = evaluate(&along);
        along[column] = 0.0;
        for (row, condition) in list.iter().enumerate() {
            matrix[(row, column)] = match condition.of {
                ConditionTerm::Tape(at) => values[at] - still[at],
                ConditionTerm::Rate(at) => f64::from(u8::from(at == column)),
            };
        }
    }
    matrix
}

/// Indices of the rates that no condition determines. Each belongs to a direction whose singular value is at most
/// `least`.
fn undetermined_rates(sizes: &DVector<f64>, directions: &DMatrix<f64>, least: f64) -> Vec<usize> {
    let free: Vec<usize> = (0..sizes.len()).filter(|at| sizes[*at] <= least).collect();
    (0..directions.ncols()).filter(|column| free.iter().any(|row| directions[(*row, *column)].abs() > PART)).collect()
}
