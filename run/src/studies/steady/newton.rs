//! Newton's method for states that symmetries carry along, with slopes in doubles and residuals in 32 digits: each step
//! adds some fifteen digits.

use super::Question;
use super::dense::least;
use crate::{Error, Mechanism};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;
use tripos_derive::flow::Rates;
use tripos_derive::plain::significant;
use tripos_derive::scene::{Asked, Loops};
use tripos_traits::{DoubleDouble, Scalar};

/// Largest number of Newton steps towards a steady state.
const STEPS: usize = 60;
/// Largest number of halvings of one Newton step.
const HALVINGS: usize = 14;
/// Ratio to the largest singular value below which a singular value counts as zero.
const NOTHING: f64 = 1e-11;
/// Relative size of the rest of a symmetry's field above which the field is independent. The rest is what remains after
/// its parts along the fields before it are removed.
const INDEPENDENT: f64 = 1e-8;
/// Residual below which 32 digits allow no improvement.
const EXACT: f64 = 1e-27;
/// Largest change of an angle in one Newton step, rad.
const MOST_TURN: f64 = 1.0;
/// Ratio of a change to the one before it above which convergence is slow: regular steps shrink much faster.
const SLOW: f64 = 0.05;
/// Difference of two states, relative to their size or 1, below which they are the same steady motion.
const SAME: f64 = 1e-8;
/// Residual of a rate, relative to its size or 1, up to which a motion counts as steady.
pub const BALANCED: f64 = 1e-9;

/// A state, and the velocities at which the symmetries carry it along, with their residuals.
#[derive(Clone, Debug)]
pub struct Steady {
    /// Values of the coordinates, then of the generalized speeds.
    pub x: Vec<DoubleDouble>,
    /// Velocity c along each symmetry.
    pub along: Vec<DoubleDouble>,
    /// Largest residual of x' − Σ c ζ, and of the loops that constrain the mechanism.
    pub residual: f64,
    /// Possible error of the state, relative to its size or 1. It is the last change of the state if changes shrank
    /// slowly, as where steady motions meet; otherwise 0.
    pub uncertain: f64,
    /// Indices of the states whose rates are not balanced, with the residuals.
    pub unbalanced: Vec<(usize, f64)>,
    /// Indices of the coordinates along which forces are not balanced, with the forces. Empty where the rates tell
    /// whether the state is steady.
    pub forces: Vec<(usize, f64)>,
    /// Indices of the loops that are not closed, with their gaps.
    pub open: Vec<(usize, f64)>,
    /// Index of the shift of time among the symmetries; `None` if there is none. A state that moves with time alone is
    /// at rest relative to its drives.
    by_time: Option<usize>,
}

impl Steady {
    /// True if the symmetries carry the state along: all rates are balanced, and the loops are closed.
    #[must_use]
    pub fn is_steady(&self) -> bool {
        self.residual.is_finite() && self.unbalanced.is_empty() && self.forces.is_empty() && self.open.is_empty()
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

/// Unknowns of a search for a steady state: states, by their indices, and velocities along symmetries.
#[derive(Clone, Debug)]
pub struct Unknowns {
    /// Indices of the unknown states.
    pub states: Vec<usize>,
    /// True if the symmetries may carry the state along.
    pub moves: bool,
}

/// Unknowns of one solve by Newton's method: indices of states, and indices of symmetries whose velocities are unknown.
struct Sought {
    states: Vec<usize>,
    along: Vec<usize>,
}

/// Guess of Newton's method, with its residuals.
struct Guess {
    x: Vec<DoubleDouble>,
    along: Vec<DoubleDouble>,
    values: Rates<DoubleDouble>,
    /// Residuals of the rates, then gaps of the loops.
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

    /// Norm of the residual, each part with its weight.
    fn size(&self, weights: &[f64]) -> f64 {
        self.left.iter().zip(weights).map(|(left, weight)| (left.hi() * weight).powi(2)).sum::<f64>().sqrt()
    }

    /// Weights of the parts of the residual, which are 0 after the first `first`. A large rate need not be balanced to
    /// more digits than others.
    fn weights(&self, first: usize) -> Vec<f64> {
        let beside = |at: usize| self.values.flow.get(at).map_or(1.0, |rate| rate.hi().abs().max(1.0));
        (0..self.left.len()).map(|at| if at < first { 1.0 / beside(at) } else { 0.0 }).collect()
    }
}

impl Question {
    /// Rest at a state where the forces balance along every motion that the constraints permit; `by_forces` has the
    /// residuals of that balance.
    pub(super) fn rest_at(&self, x: Vec<DoubleDouble>, by_forces: &Steady) -> Steady {
        Steady { x, along: self.standing(), by_time: self.by_time, ..by_forces.clone() }
    }

    /// Finds a steady state near a guess, by changing the given unknowns. If none is near, the last guess is returned
    /// with its residuals.
    #[must_use]
    pub fn settle(&self, x: &[DoubleDouble], unknowns: &Unknowns) -> Steady {
        let others = (0..self.program.sizes.symmetries).filter(|at| Some(*at) != self.by_time);
        let all = if unknowns.moves { others.collect() } else { Vec::new() };
        let none = self.standing();
        // First the velocities are found that carry the guess along, so that the guess itself changes as little as
        // possible.
        let carried = self.improved(x, none.clone(), &Sought { states: Vec::new(), along: all.clone() });
        let near = self.improved(x, carried.along, &Sought { states: unknowns.states.clone(), along: all });
        if !unknowns.moves {
            return self.steady_of(near);
        }
        // If symmetries act alike at a state, as spin and turn of an upright top do, the first one carries it along.
        let along = self.independent(&near.values.symmetries);
        let settled = self.improved(&near.x, none, &Sought { states: Vec::new(), along });
        self.steady_of(Guess { uncertain: near.uncertain, ..settled })
    }

    /// Accepts the requested state as it is, carried along by no symmetry. Only the sought coordinates that close the
    /// loops are solved for.
    ///
    /// # Errors
    /// [`Error::Request`] if the sought coordinates do not close the loops.
    pub(super) fn as_it_is(&self, model: &Mechanism, asked: &Asked) -> Result<Steady, Error> {
        let (mut x, n) = (asked.x.clone(), self.coordinates);
        let free: Vec<usize> = asked.sought.iter().copied().filter(|at| *at < n).collect();
        let closed = || Loops::new(model).close(&self.parameters, &x[..n], &free);
        if let Some(q) = (!self.loops.is_empty() && !free.is_empty()).then(closed).flatten() {
            x[..n].copy_from_slice(&q);
        }
        let steady = self.steady_of(Guess::new(self, x, self.standing()));
        if steady.open.is_empty() {
            return Ok(steady);
        }
        let open = steady.open.iter().map(|(at, left)| format!("`{}` by {}", self.loops[*at], significant(*left, 4)));
        let what = format!("loops are open at this state: {}", open.collect::<Vec<_>>().join(", "));
        Err(Error::request(what, "state coordinates that close the loops, or put enough coordinates under [guess]"))
    }

    /// Improves a guess by Newton's method as long as it helps: first with all loops, then with those that constrain
    /// the mechanism. The numbers of a file close the redundant loops only to their own digits.
    fn improved(&self, x: &[DoubleDouble], along: Vec<DoubleDouble>, unknowns: &Sought) -> Guess {
        let sizes = self.program.sizes;
        let guess = Guess::new(self, x.to_vec(), along);
        if sizes.ties == sizes.loops {
            return self.improved_by(guess, unknowns, sizes.states + sizes.loops);
        }
        let near = self.improved_by(guess, unknowns, sizes.states + sizes.loops);
        self.improved_by(near, unknowns, sizes.states + sizes.ties)
    }

    /// Improves a guess by Newton's method for the first `first` parts of the residual.
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

    /// Takes one step of Newton's method; `None` if no fraction of the step reduces the residual.
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

    /// Indices of the states that may change to reach balance: all except time.
    pub(super) fn free_states(&self) -> Vec<usize> {
        (0..self.names.len()).filter(|at| Some(*at) != self.time).collect()
    }

    /// Velocities along the symmetries at rest: 1 for the shift of time, otherwise 0.
    fn standing(&self) -> Vec<DoubleDouble> {
        (0..self.program.sizes.symmetries).map(|at| DoubleDouble::int(i64::from(Some(at) == self.by_time))).collect()
    }

    /// Indices of the symmetries that are independent of those before them at a state; the shift of time is left out.
    /// `fields` holds the direction of each symmetry.
    fn independent(&self, fields: &[Vec<DoubleDouble>]) -> Vec<usize> {
        let others: Vec<usize> = (0..fields.len()).filter(|at| Some(*at) != self.by_time).collect();
        let fields: Vec<&Vec<DoubleDouble>> = others.iter().map(|at| &fields[*at]).collect();
        independent(&fields).into_iter().map(|place| others[place]).collect()
    }

    /// Slopes of the residual at a steady state, by the given states, then by the velocities along all symmetries that
    /// are independent at the state.
    pub(super) fn slopes_at(&self, steady: &Steady, states: &[usize]) -> DMatrix<f64> {
        let guess = Guess::new(self, steady.x.clone(), steady.along.clone());
        let along = self.independent(&guess.values.symmetries);
        self.slopes_of_left(&guess, &Sought { states: states.to_vec(), along })
    }

    /// Slopes of the residual of a guess with respect to the unknowns, one column each.
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

    /// Makes the result of a search from a guess, with the residuals that are not balanced.
    fn steady_of(&self, guess: Guess) -> Steady {
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
        Steady { x: guess.x, along: guess.along, residual, uncertain, unbalanced, forces: Vec::new(), open, by_time }
    }
}

/// True if two states are equal, with angles compared up to whole turns.
pub(super) fn is_same(model: &Mechanism, a: &Steady, b: &Steady) -> bool {
    (0..a.x.len()).all(|at| is_near(model, at, a.x[at].hi(), b.x[at].hi()))
}

/// True if two values of a state are equal to a tolerance, an angle up to whole turns.
pub(super) fn is_near(model: &Mechanism, at: usize, a: f64, b: f64) -> bool {
    let turns = model.coordinates.get(at).is_some_and(|c| c.unit.is_plain());
    let difference = if turns { (a - b) - TAU * ((a - b) / TAU).round() } else { a - b };
    difference.abs() <= SAME * a.abs().max(1.0)
}

/// Largest difference of two states, each component relative to its size or 1.
fn apart(a: &[DoubleDouble], b: &[DoubleDouble]) -> f64 {
    let one = |(a, b): (&DoubleDouble, &DoubleDouble)| (*a - *b).hi().abs() / a.hi().abs().max(1.0);
    a.iter().zip(b).map(one).fold(0.0, f64::max)
}

/// Indices of the fields that do not depend linearly on those before them.
fn independent(fields: &[&Vec<DoubleDouble>]) -> Vec<usize> {
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let mut list = Vec::new();
    for (at, field) in fields.iter().enumerate() {
        let field = DVector::from_iterator(field.len(), field.iter().map(|x| x.hi()));
        let size = field.norm();
        let mut left = field;
        // This is done twice, since rounding leaves a rest.
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
