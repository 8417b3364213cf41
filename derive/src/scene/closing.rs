//! Starts of mechanisms with loops: coordinates that close them, from guesses.

use super::start::Closed;
use super::values::{Number, Values, doubles};
use crate::algebra::Expr;
use crate::algebra::calculus::Gradient;
use crate::algebra::evaluate::Tape;
use crate::model::TIME;
use nalgebra::{DMatrix, DVector};
use std::ops::Range;
use toml::de::DeTable;
use tripos_traits::{DoubleDouble, Scalar};

/// Steps of Newton's method, and halvings of one.
const STEPS: usize = 100;
const HALVINGS: usize = 40;
/// What may be left of a loop, over the sum of the sizes of what it is made of.
const OPEN: f64 = 1e-13;
/// What may be left where every coordinate is stated, in as many digits as people write.
const STATED: f64 = 1e-9;
/// Singular values below the largest times this do not count.
const RANK: f64 = 1e-10;
/// Where one of all loops is below the largest times this, they are dependent: a pose that is a double root is found to half
/// of the digits.
const SINGULAR: f64 = 1e-6;

/// The loops of a model as functions of parameters and coordinates.
struct Loops {
    values: Tape,
    slopes: Tape,
    /// How many of them are independent where all are closed: the first.
    independent: usize,
}

/// Where a search ended.
struct Found {
    q: Vec<f64>,
    /// How far each loop is open.
    open: Vec<f64>,
    is_closed: bool,
    /// The pseudo-inverse of the slopes along the coordinates that were free.
    inverse: DMatrix<f64>,
}

impl<'a> Values<'a, '_> {
    /// The guesses of a scene for the coordinates that its start leaves open.
    pub(super) fn guesses(&mut self, table: &'a DeTable<'a>, parameters: &[Number]) -> Option<Vec<Option<Number>>> {
        let mut guesses = vec![None; self.model.coordinates.len()];
        let Some(section) = self.section(table, "guess") else { return Some(guesses) };
        let place = self.reader.get(table, "guess").map_or(0..0, toml::Spanned::span);
        if self.model.loops.is_empty() {
            let message = "the model has no loop that a coordinate could be solved from";
            self.reader.error(place, message, "state every coordinate in [start]");
            return None;
        }
        for (name, value) in self.reader.entries(section) {
            // What a constraint fixes needs no guess; whether it does is no matter of the scene.
            if self.model.constraints.iter().any(|c| c.fixes == name.text) {
                let formula = self.reader.formula(value, &format!("`{}`", name.text))?;
                self.number(&formula, parameters, "a guess")?;
                continue;
            }
            let Some(at) = self.model.coordinates.iter().position(|c| c.name == name.text && c.name != TIME) else {
                let names = self.model.coordinates.iter().map(|c| c.name.as_str());
                let help = crate::diagnostic::nearest(&name.text, names);
                self.reader.error(name.span, format!("the model has no coordinate `{}`", name.text), help);
                continue;
            };
            let formula = self.reader.formula(value, &format!("`{}`", name.text))?;
            guesses[at] = Some(self.number(&formula, parameters, "a guess")?);
        }
        Some(guesses)
    }

    /// Closes the loops by the coordinates that are not stated, or says by how much they are open. Returns what was solved
    /// for.
    pub(super) fn close(
        &mut self,
        q: &mut [Option<Number>],
        guesses: &[Option<Number>],
        parameters: &[Number],
        place: Range<usize>,
    ) -> Option<Vec<Closed>> {
        if self.model.loops.is_empty() {
            return Some(Vec::new());
        }
        let free: Vec<usize> = (0..q.len()).filter(|at| q[*at].is_none()).collect();
        let loops = self.loops();
        let p = doubles(parameters);
        let value = |at: usize| q[at].as_ref().or(guesses[at].as_ref()).map_or(0.0, |x| x.double);
        let start: Vec<f64> = (0..q.len()).map(value).collect();
        let all: Vec<usize> = (0..q.len()).collect();
        let found = loops.newton(&p, &start, if free.is_empty() { &all } else { &free });
        let open_at_start = loops.open(&p, &start);
        let is_stated = free.is_empty() && loops.is_closed(&p, &start, &open_at_start, STATED);
        if !found.is_closed || free.is_empty() && !is_stated {
            self.report_open(&found, &open_at_start, &free, place);
            return None;
        }
        if loops.is_singular(&p, &found.q) {
            let message = "the start is a singular pose: the slopes of the loops are dependent there, and several motions may go on from it";
            let shown = |at: &usize| format!("{} = {}", self.model.coordinates[*at].name, found.q[*at]);
            let pose: Vec<String> = all.iter().map(shown).collect();
            self.reader.error(place, message, format!("start beside {}", pose.join(", ")));
            return None;
        }
        // To 32 digits, with the slopes in doubles: each step gives sixteen more.
        let mut precise: Vec<DoubleDouble> = (0..q.len())
            .map(|at| q[at].as_ref().map_or_else(|| DoubleDouble::from_f64(found.q[at]), Number::extended))
            .collect();
        let moving = if free.is_empty() { &all } else { &free };
        let values = loops.values.to::<DoubleDouble>();
        let wide: Vec<DoubleDouble> = parameters.iter().map(Number::extended).collect();
        for _ in 0..3 {
            let open = values.evaluate(&[wide.as_slice(), &precise].concat());
            for (row, at) in moving.iter().enumerate() {
                for (column, open) in open.iter().enumerate() {
                    let share = DoubleDouble::from_f64(found.inverse[(row, column)]) * *open;
                    precise[*at] = precise[*at] - share;
                }
            }
        }
        for at in moving {
            q[*at] = Some(Number::wide(precise[*at]));
        }
        let name = |at: &usize| Closed { name: self.model.coordinates[*at].name.clone(), value: precise[*at].hi() };
        Some(free.iter().map(name).collect())
    }

    fn loops(&mut self) -> Loops {
        let model = &mut *self.model;
        let inputs = [model.p(), model.q()].concat();
        let independent = model.loops.len();
        let equations: Vec<Expr> = model.loops.iter().chain(&model.closed).map(|c| c.equation).collect();
        let coordinates = model.q();
        let mut gradient = Gradient::new(&coordinates);
        let mut slopes = vec![Expr::ZERO; equations.len() * coordinates.len()];
        // Nothing moves time.
        let time = model.time();
        for (row, equation) in equations.iter().enumerate() {
            for &(at, slope) in gradient.apply(&mut model.arena, *equation).iter().filter(|(at, _)| Some(*at) != time) {
                slopes[row * coordinates.len() + at] = slope;
            }
        }
        let tape = |values: &[Expr]| match Tape::new(&model.arena, &inputs, values) {
            Ok(tape) => tape,
            Err(unknown) => unreachable!("loops tie coordinates, not {}", unknown.0),
        };
        Loops { values: tape(&equations), slopes: tape(&slopes), independent }
    }

    fn report_open(&mut self, found: &Found, open_at_start: &[f64], free: &[usize], place: Range<usize>) {
        let model = &self.model;
        let worst = |open: &[f64]| {
            let largest = open.iter().enumerate().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
            let name =
                |at: usize| model.loops.iter().chain(&model.closed).nth(at).map_or(String::new(), |c| c.name.clone());
            largest.map_or((String::new(), 0.0), |(at, open)| (name(at), *open))
        };
        let shown = |at: &usize| format!("{} = {}", model.coordinates[*at].name, found.q[*at]);
        let all: Vec<usize> = (0..found.q.len()).collect();
        let nearest: Vec<String> = if free.is_empty() { &all } else { free }.iter().map(shown).collect();
        let (message, help) = if free.is_empty() && found.is_closed {
            let (name, open) = worst(open_at_start);
            let message = format!("the start breaks the constraint `{name}`: it is {open:e}, not 0");
            let help = format!(
                "leave a coordinate out of [start] for each loop, with a value near it in [guess]; the nearest closed \
                 configuration has {}",
                nearest.join(", ")
            );
            (message, help)
        } else {
            let (name, open) = worst(&found.open);
            let message = format!("no configuration that closes the loops was found: `{name}` stays open by {open:e}");
            (message, format!("the nearest that was found has {}: give other guesses", nearest.join(", ")))
        };
        self.reader.error(place, message, help);
    }
}

impl Loops {
    fn open(&self, p: &[f64], q: &[f64]) -> Vec<f64> {
        self.values.evaluate(&[p, q].concat())
    }

    fn slopes(&self, p: &[f64], q: &[f64]) -> DMatrix<f64> {
        let values = self.slopes.evaluate(&[p, q].concat());
        DMatrix::from_row_slice(values.len() / q.len().max(1), q.len(), &values)
    }

    /// Whether every loop is closed to this part of what it is made of.
    fn is_closed(&self, p: &[f64], q: &[f64], open: &[f64], part: f64) -> bool {
        let slopes = self.slopes(p, q);
        open.iter().enumerate().all(|(row, open)| {
            let size: f64 = slopes.row(row).iter().zip(q).map(|(slope, q)| (slope * q).abs().max(slope.abs())).sum();
            open.abs() <= part * size
        })
    }

    /// Whether the slopes of the loops are dependent.
    fn is_singular(&self, p: &[f64], q: &[f64]) -> bool {
        let values = self.slopes(p, q).rows(0, self.independent).singular_values();
        values.min() <= SINGULAR * values.max()
    }

    /// Newton's method with halved steps, along these coordinates alone; where the loops leave some of them open, by the
    /// smallest change.
    fn newton(&self, p: &[f64], start: &[f64], free: &[usize]) -> Found {
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
