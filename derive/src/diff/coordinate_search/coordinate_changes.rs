//! Changes of coordinates that the search tries: another order, other signs and zeros, and absolute angles instead of
//! relative angles.

use super::CoordinateTable;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::text::print::print_text;
use crate::algebra::{Arena, Expr};
use crate::model::Model;
use crate::publication::Publication;

/// Largest number of coordinate choices that are tried.
const MOST: usize = 20_000;
/// Number of coordinates up to which all orders, signs and quarter turns are tried.
const FEW: usize = 3;

/// Change of coordinates: each coordinate of the publication is a sum of the model's coordinates
/// plus quarter turns.
#[derive(Clone)]
pub(super) struct CoordinateChange {
    /// Matrix of factors −1, 0 or 1, n × n. Row i gives coordinate i of the publication as a sum of the model's
    /// coordinates.
    pub(super) rows: Vec<Vec<i8>>,
    /// Constant added to each coordinate, in quarter turns of π/2 rad.
    pub(super) quarters: Vec<i8>,
    /// Number of differences from the identity; an exchange of order counts as two.
    pub(super) size: usize,
}

impl CoordinateChange {
    /// Composition of two changes, in which `other` is applied first.
    pub(super) fn composed_after(&self, other: &Self) -> Self {
        let n = self.rows.len();
        let product = |i: usize, of: &dyn Fn(usize) -> i8| (0..n).map(|k| self.rows[i][k] * of(k)).sum::<i8>();
        let rows = (0..n).map(|i| (0..n).map(|j| product(i, &|k| other.rows[k][j])).collect()).collect();
        let quarters = (0..n).map(|i| product(i, &|k| other.quarters[k]) + self.quarters[i]).collect();
        Self { rows, quarters, size: 0 }
    }
}

impl PartialEq for CoordinateChange {
    /// True if two changes are equal up to whole turns.
    fn eq(&self, other: &Self) -> bool {
        let turns = |(a, b): (&i8, &i8)| (a - b).rem_euclid(4) == 0;
        self.rows == other.rows && self.quarters.iter().zip(&other.quarters).all(turns)
    }
}

/// Changes of the coordinates with the indices `moving`, with the fewest differences first. The first is the identity.
pub(super) fn coordinate_changes(model: &Model, moving: &[usize]) -> Vec<CoordinateChange> {
    let n = model.coordinates.len();
    let is_angle = |at: usize| model.coordinates[at].unit.is_plain();
    let angles: Vec<usize> = moving.iter().copied().filter(|at| is_angle(*at)).collect();
    let mut forms = vec![(identity(n), 0)];
    if angles.len() > 1 {
        let (mut sums, mut differences) = (identity(n), identity(n));
        for (k, at) in angles.iter().enumerate() {
            for before in &angles[..k] {
                sums[*at][*before] = 1;
            }
            if k > 0 {
                differences[*at][angles[k - 1]] = -1;
            }
        }
        forms.extend([(sums, 1), (differences, 1)]);
    }
    let mut list: Vec<CoordinateChange> = Vec::new();
    for order in coordinate_permutations(model, moving) {
        for (form, own) in &forms {
            for options in sign_and_zero_choices(moving, &is_angle) {
                let (mut rows, mut quarters) = (form.clone(), vec![0; n]);
                let mut size = own + options.iter().filter(|(sign, turn)| (*sign, *turn) != (1, 0)).count();
                size += 2 * usize::from(order.iter().zip(moving).any(|(a, b)| a != b));
                for ((at, from), (sign, turn)) in moving.iter().zip(&order).zip(&options) {
                    rows[*at] = form[*from].iter().map(|factor| factor * sign).collect();
                    quarters[*at] = *turn;
                }
                let change = CoordinateChange { rows, quarters, size };
                list.push(change);
                if list.len() > 4 * MOST {
                    break;
                }
            }
        }
    }
    list.sort_by_key(|change| change.size);
    list.truncate(MOST);
    list
}

/// Identity matrix of small integers, n × n.
pub(super) fn identity(n: usize) -> Vec<Vec<i8>> {
    (0..n).map(|i| (0..n).map(|j| i8::from(i == j)).collect()).collect()
}

/// Permutations of the indices `moving` among coordinates of equal unit. All permutations for up to three coordinates,
/// else only exchanges of two.
fn coordinate_permutations(model: &Model, moving: &[usize]) -> Vec<Vec<usize>> {
    let fits = |order: &Vec<usize>| {
        order.iter().zip(moving).all(|(a, b)| model.coordinates[*a].unit == model.coordinates[*b].unit)
    };
    let mut list = vec![moving.to_vec()];
    let rounds = if moving.len() <= FEW { moving.len() } else { 2 };
    for _ in 1..rounds {
        for order in list.clone() {
            for i in 0..order.len() {
                for j in 0..i {
                    let mut other = order.clone();
                    other.swap(i, j);
                    if !list.contains(&other) {
                        list.push(other);
                    }
                }
            }
        }
    }
    list.retain(fits);
    list
}

/// Choices of (sign, quarter turns) for each coordinate of `moving`; lengths get only a sign. For up to three
/// coordinates, all combinations. For more coordinates, at most two are changed, or all angles are changed alike.
fn sign_and_zero_choices(moving: &[usize], is_angle: &dyn Fn(usize) -> bool) -> Vec<Vec<(i8, i8)>> {
    let all = [(1, 0), (-1, 0), (1, 1), (1, -1), (1, 2), (-1, 1), (-1, -1), (-1, 2)];
    let options = |at: usize| if is_angle(at) { &all[..] } else { &all[..2] };
    let none = vec![(1, 0); moving.len()];
    let mut list = vec![none.clone()];
    if moving.len() <= FEW {
        for (k, at) in moving.iter().enumerate() {
            let before = std::mem::take(&mut list);
            for option in options(*at) {
                list.extend(before.iter().map(|signs| {
                    let mut signs = signs.clone();
                    signs[k] = *option;
                    signs
                }));
            }
        }
        return list;
    }
    for option in &all[1..] {
        let angles = moving.iter().map(|at| if is_angle(*at) { *option } else { (1, 0) });
        list.push(angles.collect());
    }
    for i in 0..moving.len() {
        for first in &options(moving[i])[1..] {
            let mut signs = none.clone();
            signs[i] = *first;
            list.push(signs.clone());
            for j in 0..i {
                for second in &options(moving[j])[1..] {
                    let mut signs = signs.clone();
                    signs[j] = *second;
                    list.push(signs);
                }
            }
        }
    }
    list
}

/// Table `[coordinates]` for a change of coordinates: first the coordinates and speeds of the model that change, then
/// the publication's own coordinates.
///
/// # Errors
/// Message if a changed speed of the model is not the rate of one coordinate.
pub(super) fn coordinate_table(
    model: &Model,
    arena: &mut Arena,
    publication: &Publication,
    change: &CoordinateChange,
) -> Result<CoordinateTable, String> {
    let quarter = arena.pi();
    let half = arena.ratio(1, 2);
    let quarter = arena.mul(quarter, half);
    let same = identity(model.coordinates.len());
    let is_changed = |at: usize| change.rows[at] != same[at] || change.quarters[at] != 0;
    let speed_of = |at: usize| model.speeds.iter().find(|s| s.definition == model.coordinates[at].rate);
    let (mut pairs, mut list) = (Vec::new(), Vec::new());
    for (at, c) in model.coordinates.iter().enumerate().filter(|(at, _)| is_changed(*at)) {
        let mut sum = |of: &dyn Fn(usize) -> Expr, quarters: i8| {
            let turns = arena.integer(i64::from(quarters));
            let mut terms = vec![arena.mul(turns, quarter)];
            for (from, factor) in change.rows[at].iter().enumerate() {
                let factor = arena.integer(i64::from(*factor));
                terms.push(arena.mul(factor, of(from)));
            }
            arena.sum(&terms)
        };
        let value = sum(&|from| model.coordinates[from].symbol, change.quarters[at]);
        let rate = sum(&|from| model.coordinates[from].rate, 0);
        let second = sum(&|from| model.coordinates[from].second_rate, 0);
        let speed = speed_of(at).map(|speed| (speed, sum(&|from| speed_of(from).map_or(Expr::ZERO, |s| s.symbol), 0)));
        list.push((c.name.clone(), print_text(arena, value)));
        pairs.extend([(c.symbol, value), (c.rate, rate), (c.second_rate, second)]);
        if let Some((speed, value)) = speed {
            let plain = change.rows[at].iter().enumerate().all(|(from, f)| *f == 0 || speed_of(from).is_some());
            if !plain {
                return Err("a speed of the model is not the rate of one coordinate".to_owned());
            }
            if value != speed.symbol {
                list.push((speed.name.clone(), print_text(arena, value)));
                pairs.push((speed.symbol, value));
            }
        }
    }
    for (name, value) in &publication.coordinates {
        let value = Substitution::new(&pairs).apply(arena, *value);
        list.push((name.clone(), print_text(arena, value)));
    }
    Ok(list)
}
