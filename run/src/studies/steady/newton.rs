//! Newton's method for states that symmetries carry along, with slopes in doubles and residuals in 32 digits: each step
//! gives some fifteen digits more.

use super::Question;
use super::dense::least;
use crate::{Error, Mechanism};
use nalgebra::{DMatrix, DVector};
use tripos_derive::flow::Rates;
use tripos_derive::scene::{Asked, Loops};
use tripos_traits::{DoubleDouble, Scalar};

/// Largest number of Newton steps. `HALVINGS` is that of halvings of one; singular values below `NOTHING` of the
/// largest are zero.
const STEPS: usize = 60;
const HALVINGS: usize = 14;
const NOTHING: f64 = 1e-11;
/// Relative size above which a field is independent: that of its rest, after the fields before it are taken out.
const INDEPENDENT: f64 = 1e-8;
/// Residual below which 32 digits tell no more. `MOST_TURN` is the largest change of an angle at once, rad.
const EXACT: f64 = 1e-27;
const MOST_TURN: f64 = 1.0;
/// Ratio of a change to the one before it above which convergence is slow: a regular step is smaller by far.
const SLOW: f64 = 0.05;
/// Residual of a rate, relative to its size or 1, up to which a motion counts as steady.
pub const BALANCED: f64 = 1e-9;

/// A state, and the velocities at which the symmetries carry it along.
#[derive(Clone, Debug)]
pub struct Steady {
    /// Values of the coordinates, then of the speeds.
    pub x: Vec<DoubleDouble>,
    /// Velocities c along the symmetries, one each.
    pub along: Vec<DoubleDouble>,
    /// Largest residual of x' − Σ c ζ, and of the loops that tie the mechanism.
    pub residual: f64,
    /// Possible error of the state, relative to its size or 1. It is the last change of the state where changes shrank
    /// by no more than a factor, as where steady motions meet; 0 elsewhere.
    pub uncertain: f64,
    /// Residuals of the rates that are not balanced, with the indices of their states.
    pub unbalanced: Vec<(usize, f64)>,
    /// Openings of the loops that are not closed, with the indices of the loops.
    pub open: Vec<(usize, f64)>,
    /// Index of the shift of time among the symmetries. A state that moves with time alone is at rest relative to its
    /// drives.
    by_time: Option<usize>,
}

impl Steady {
    /// True if the symmetries carry the state along: all rates are balanced, and the loops are closed.
    #[must_use]
    pub fn is_steady(&self) -> bool {
        self.residual.is_finite() && self.unbalanced.is_empty() && self.open.is_empty()
    }

    /// Indices of the symmetries that carry the state along.
    #[must_use]
    pub fn carriers(&self) -> Vec<usize> {
        (0..self.along.len()).filter(|at| self.along[*at].hi().abs() > 0.0).collect()
    }

    /// Velocities along all symmetries except the shift of time.
    #[must_use]
    pub fn velocities(&self) -> Vec<DoubleDouble> {
        let others = self.along.iter().enumerate().filter(|(at, _)| Some(*at) != self.by_time);
        others.map(|(_, c)| *c).collect()
    }

    /// True if only the shift of time, or nothing, carries the state along.
    #[must_use]
    pub fn is_rest(&self) -> bool {
        self.along.iter().enumerate().all(|(at, c)| Some(at) == self.by_time || c.hi().abs() <= BALANCED)
    }
}

/// Unknowns of a search: states, by their indices, and velocities along symmetries.
#[derive(Clone, Debug)]
pub struct Unknowns {
    /// Indices of the unknown states.
    pub states: Vec<usize>,
    /// True if the symmetries may carry the state along.
    pub moves: bool,
}

/// Unknowns of one solve: states, and velocities along these symmetries.
struct Sought {
    states: Vec<usize>,
    along: Vec<usize>,
}

/// A guess of Newton's method, with its residuals.
struct Guess {
    x: Vec<DoubleDouble>,
    along: Vec<DoubleDouble>,
    values: Rates<DoubleDouble>,
    left: Vec<DoubleDouble>,
    uncertain: f64,
}

impl Guess {
    fn new(question: &Question, x: Vec<DoubleDouble>, along: Vec<DoubleDouble>) -> Self {
        let (values, _) = question.program.evaluate(&question.wide, &question.parameters, &x, &[]);
        let mut left = values.flow.clone();
        for (c, zeta) in along.iter().zip(&values.symmetries) {
            for (rate, component) in left.iter_mut().zip(zeta) {
                *rate = *rate - *c * *component;
            }
        }
        left.extend(&values.loops);
        Self { x, along, values, left, uncertain: 0.0 }
    }

    /// Length of the residual, each part with its weight.
    fn size(&self, weights: &[f64]) -> f64 {
        self.left.iter().zip(weights).map(|(left, weight)| (left.hi() * weight).powi(2)).sum::<f64>().sqrt()
    }

    /// Weights of the first parts of the residual: a large rate need not be balanced to more digits than others. The
    /// rest has the weight 0.
    fn weights(&self, first: usize) -> Vec<f64> {
        let beside = |at: usize| self.values.flow.get(at).map_or(1.0, |rate| rate.hi().abs().max(1.0));
        (0..self.left.len()).map(|at| if at < first { 1.0 / beside(at) } else { 0.0 }).collect()
    }
}

impl Question {
    /// Finds the steady state nearest to a guess, by these unknowns. If none is near, the guess is returned with its
    /// residuals.
    #[must_use]
    pub fn settle(&self, x: &[DoubleDouble], unknowns: &Unknowns) -> Steady {
        let others = (0..self.program.sizes.symmetries).filter(|at| Some(*at) != self.by_time);
        let all = if unknowns.moves { others.collect() } else { Vec::new() };
        let none = self.standing();
        // First the velocities that carry the guess along, so that the guess itself is changed no more than it must be.
        let carried = self.improved(x, none.clone(), &Sought { states: Vec::new(), along: all.clone() });
        let near = self.improved(x, carried.along, &Sought { states: unknowns.states.clone(), along: all });
        if !unknowns.moves {
            return self.told(near);
        }
        // Where symmetries act alike at a state, as spin and turn of an upright top, the first one carries it along.
        let along = self.independent(&near.values.symmetries);
        let settled = self.improved(&near.x, none, &Sought { states: Vec::new(), along });
        self.told(Guess { uncertain: near.uncertain, ..settled })
    }

    /// Takes the state that was asked about as it is, carried along by no symmetry. Only the sought coordinates that
    /// close the loops are solved for.
    ///
    /// # Errors
    /// [`Error::Request`] if the loops are not closed by these.
    pub(super) fn as_it_is(&self, model: &Mechanism, asked: &Asked) -> Result<Steady, Error> {
        let (mut x, n) = (asked.x.clone(), self.coordinates);
        let free: Vec<usize> = asked.sought.iter().copied().filter(|at| *at < n).collect();
        let closed = || Loops::new(model).close(&self.parameters, &x[..n], &free);
        if let Some(q) = (!self.loops.is_empty() && !free.is_empty()).then(closed).flatten() {
            x[..n].copy_from_slice(&q);
        }
        let steady = self.told(Guess::new(self, x, self.standing()));
        if steady.open.is_empty() {
            return Ok(steady);
        }
        let open = steady.open.iter().map(|(at, left)| format!("`{}` by {left:.6e}", self.loops[*at]));
        let what = format!("loops are open at this state: {}", open.collect::<Vec<_>>().join(", "));
        Err(Error::request(what, "state coordinates that close them, or put as many as close them under [guess]"))
    }

    /// Improves a guess by Newton's method as long as it helps: first with all loops, then with those that tie the
    /// mechanism. The numbers of a file close the other loops only to its digits.
    fn improved(&self, x: &[DoubleDouble], along: Vec<DoubleDouble>, unknowns: &Sought) -> Guess {
        let sizes = self.program.sizes;
        let guess = Guess::new(self, x.to_vec(), along);
        if sizes.ties == sizes.loops {
            return self.improved_by(guess, unknowns, sizes.states + sizes.loops);
        }
        let near = self.improved_by(guess, unknowns, sizes.states + sizes.loops);
        self.improved_by(near, unknowns, sizes.states + sizes.ties)
    }

    /// Improves a guess by Newton's method for the first parts of the residual.
    fn improved_by(&self, guess: Guess, unknowns: &Sought, first: usize) -> Guess {
        let mut guess = guess;
        let weights = guess.weights(first);
        let mut changes = [0.0; 2];
        for _ in 0..STEPS {
            if guess.size(&weights) <= EXACT {
                break;
            }
            let Some(better) = self.step(&guess, unknowns, &weights) else { break };
            changes = [changes[1], apart(&guess.x, &better.x)];
            guess = better;
        }
        let is_slow = changes[0] > 0.0 && changes[1] > SLOW * changes[0];
        guess.uncertain = if is_slow { changes[1] } else { 0.0 };
        guess
    }

    /// Takes one step of Newton's method; `None` if no part of it reduces the residual.
    fn step(&self, guess: &Guess, unknowns: &Sought, weights: &[f64]) -> Option<Guess> {
        let mut jacobian = self.slopes_of_left(guess, unknowns);
        jacobian.row_iter_mut().zip(weights).for_each(|(mut row, weight)| row *= *weight);
        let left = guess.left.iter().zip(weights).map(|(left, weight)| left.hi() * weight);
        let change = least(&jacobian, &DVector::from_iterator(guess.left.len(), left), NOTHING)?;
        let turns = unknowns.states.iter().zip(change.iter()).filter(|(at, _)| self.is_angle[**at]);
        let most = turns.fold(0.0_f64, |most, (_, by)| most.max(by.abs()));
        let (size, mut share) = (guess.size(weights), (MOST_TURN / most).min(1.0));
        for _ in 0..HALVINGS {
            let (mut x, mut along) = (guess.x.clone(), guess.along.clone());
            let moved = |value: &mut DoubleDouble, by: f64| *value = *value + DoubleDouble::from_f64(share * by);
            for (at, by) in unknowns.states.iter().zip(change.iter()) {
                moved(&mut x[*at], *by);
            }
            for (at, by) in unknowns.along.iter().zip(change.iter().skip(unknowns.states.len())) {
                moved(&mut along[*at], *by);
            }
            let next = Guess::new(self, x, along);
            if next.size(weights) < size {
                return Some(next);
            }
            share /= 2.0;
        }
        None
    }

    /// Indices of the states that may be changed for balance: all except time.
    pub(super) fn free_states(&self) -> Vec<usize> {
        (0..self.names.len()).filter(|at| Some(*at) != self.time).collect()
    }

    /// Velocities along symmetries of a state at rest: time alone goes on.
    fn standing(&self) -> Vec<DoubleDouble> {
        (0..self.program.sizes.symmetries).map(|at| DoubleDouble::int(i64::from(Some(at) == self.by_time))).collect()
    }

    /// Indices of the symmetries that are independent of those before them at a state; the shift of time is left out.
    fn independent(&self, fields: &[Vec<DoubleDouble>]) -> Vec<usize> {
        let others: Vec<usize> = (0..fields.len()).filter(|at| Some(*at) != self.by_time).collect();
        let fields: Vec<&Vec<DoubleDouble>> = others.iter().map(|at| &fields[*at]).collect();
        independent(&fields).into_iter().map(|place| others[place]).collect()
    }

    /// Slopes of the residual at a steady state, by these states and by the velocities along all symmetries that are
    /// independent there.
    pub(super) fn slopes_at(&self, steady: &Steady, states: &[usize]) -> DMatrix<f64> {
        let guess = Guess::new(self, steady.x.clone(), steady.along.clone());
        let along = self.independent(&guess.values.symmetries);
        self.slopes_of_left(&guess, &Sought { states: states.to_vec(), along })
    }

    /// Slopes of the residual by the unknowns.
    fn slopes_of_left(&self, guess: &Guess, unknowns: &Sought) -> DMatrix<f64> {
        let sizes = self.program.sizes;
        let count = sizes.states + sizes.inputs;
        let unit = |at: usize| (0..count).map(|k| f64::from(u8::from(k == at))).collect::<Vec<f64>>();
        let directions: Vec<Vec<f64>> = unknowns.states.iter().map(|at| unit(*at)).collect();
        let doubles = |list: &[DoubleDouble]| list.iter().map(|x| x.hi()).collect::<Vec<f64>>();
        let (values, slopes) =
            self.program.evaluate(self.program.tape(), &doubles(&self.parameters), &doubles(&guess.x), &directions);
        let along = doubles(&guess.along);
        DMatrix::from_fn(sizes.states + sizes.loops, slopes.len() + unknowns.along.len(), |row, column| {
            let Some(slope) = slopes.get(column) else {
                let field = &values.symmetries[unknowns.along[column - slopes.len()]];
                return field.get(row).map_or(0.0, |component| -component);
            };
            let Some(rate) = slope.flow.get(row) else { return slope.loops[row - sizes.states] };
            along.iter().zip(&slope.symmetries).fold(*rate, |sum, (c, zeta)| sum - c * zeta[row])
        })
    }

    /// Steady state of a guess, with the residuals that are not balanced.
    fn told(&self, guess: Guess) -> Steady {
        let (rates, loops) = guess.left.split_at(self.program.sizes.states);
        let open = |size: f64, beside: f64| size.is_nan() || size.abs() > BALANCED * beside;
        let unbalanced = rates.iter().zip(&guess.values.flow).enumerate();
        let unbalanced = unbalanced.filter(|(_, (left, rate))| open(left.hi(), rate.hi().abs().max(1.0)));
        let unbalanced = unbalanced.map(|(at, (left, _))| (at, left.hi())).collect();
        let open = loops.iter().enumerate().filter(|(_, left)| open(left.hi(), 1.0));
        let open = open.map(|(at, left)| (at, left.hi())).collect();
        let residual = guess.left[..self.program.sizes.states + self.program.sizes.ties]
            .iter()
            .fold(0.0, |most: f64, left| if left.hi().is_nan() { f64::NAN } else { most.max(left.hi().abs()) });
        let (uncertain, by_time) = (guess.uncertain, self.by_time);
        Steady { x: guess.x, along: guess.along, residual, uncertain, unbalanced, open, by_time }
    }
}

/// Largest difference of two states, each number relative to its size or 1.
fn apart(a: &[DoubleDouble], b: &[DoubleDouble]) -> f64 {
    let one = |(a, b): (&DoubleDouble, &DoubleDouble)| (*a - *b).hi().abs() / a.hi().abs().max(1.0);
    a.iter().zip(b).map(one).fold(0.0, f64::max)
}

/// Indices of the fields that do not follow from those before them.
fn independent(fields: &[&Vec<DoubleDouble>]) -> Vec<usize> {
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let mut list = Vec::new();
    for (at, field) in fields.iter().enumerate() {
        let field = DVector::from_iterator(field.len(), field.iter().map(|x| x.hi()));
        let size = field.norm();
        let mut left = field;
        // Twice, since rounding leaves a rest.
        for _ in 0..2 {
            for known in &basis {
                left -= known * known.dot(&left);
            }
        }
        if left.norm() > INDEPENDENT * size {
            basis.push(left.normalize());
            list.push(at);
        }
    }
    list
}
