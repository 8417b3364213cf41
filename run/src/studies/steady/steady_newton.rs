//! Newton's method for steady states, at which all rates are along symmetries. Derivatives are in double
//! precision, and residuals in 32 digits. So each step adds about fifteen digits.

use super::SteadyProblem;
use super::spectra::wide_matrix::least_squares;
use super::steady_state::{BALANCED, SteadyState};
use crate::{Error, Mechanism};
use nalgebra::{DMatrix, DVector};
use tripos_derive::flow::FlowProgramResults;
use tripos_derive::plain_text::with_significant_digits;
use tripos_derive::scene::{Loops, StateWithUnknowns};
use tripos_traits::{DoubleDouble, Scalar};

/// Largest number of Newton steps towards a steady state.
const STEPS: usize = 60;
/// Largest number of times that a Newton step is halved if it does not reduce the residual.
const HALVINGS: usize = 14;
/// Fraction of the largest singular value below which a singular value counts as zero.
const NOTHING: f64 = 1e-11;
/// Relative size above which the direction of a symmetry counts as independent of the directions before
/// it. The size is what remains after its components along these directions are removed.
const INDEPENDENT: f64 = 1e-8;
/// Residual up to which numbers of 32 digits allow no further improvement.
const EXACT: f64 = 1e-27;
/// Largest change of an angle in one Newton step, rad.
const MOST_TURN: f64 = 1.0;
/// Ratio of two successive changes above which convergence counts as slow. Regular steps shrink much
/// faster.
const SLOW: f64 = 0.05;
/// Unknowns of a search for a steady state: components of the state, and velocities along symmetries if
/// wanted.
#[derive(Clone, Debug)]
pub struct Unknowns {
    /// Indices of the components of the state that may change.
    pub states: Vec<usize>,
    /// True if velocities along symmetries are unknown too; false in a search for rest.
    pub moves: bool,
}

/// Unknowns of one solution by Newton's method, as indices.
struct UnknownIndices {
    /// Indices of the unknown components of the state.
    states: Vec<usize>,
    /// Indices of the symmetries whose velocities are unknown.
    along: Vec<usize>,
}

/// State during Newton's method, with its residuals.
struct NewtonIterate {
    /// Values of the coordinates and generalized speeds.
    x: Vec<DoubleDouble>,
    /// Velocity along each symmetry.
    along: Vec<DoubleDouble>,
    /// Rates, loop residuals and directions of the symmetries at this state.
    values: FlowProgramResults<DoubleDouble>,
    /// Residuals of the rates, followed by the residuals of the loops.
    left: Vec<DoubleDouble>,
    /// Possible error of the state, relative to its size or to 1; 0 if convergence was fast.
    uncertain: f64,
}

impl NewtonIterate {
    /// Evaluates the equations at a state, and computes the residuals. `along` are the velocities along
    /// the symmetries.
    fn new(question: &SteadyProblem, x: Vec<DoubleDouble>, along: Vec<DoubleDouble>) -> Self {
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

    /// Euclidean norm of the residuals, each multiplied by its weight.
    fn residual_norm(&self, weights: &[f64]) -> f64 {
        self.left.iter().zip(weights).map(|(left, weight)| (left.hi() * weight).powi(2)).sum::<f64>().sqrt()
    }

    /// Weights of the residuals, which are 0 from the index `first` on. Residuals of large rates get
    /// small weights, because such rates need no more digits than others.
    fn residual_weights(&self, first: usize) -> Vec<f64> {
        let beside = |at: usize| self.values.flow.get(at).map_or(1.0, |rate| rate.hi().abs().max(1.0));
        (0..self.left.len()).map(|at| if at < first { 1.0 / beside(at) } else { 0.0 }).collect()
    }
}

impl SteadyProblem {
    /// Finds a steady state near the guess `x`, by changing the given unknowns. If none is found, returns
    /// the last state of Newton's method with its residuals.
    #[must_use]
    pub fn find_steady_state(&self, x: &[DoubleDouble], unknowns: &Unknowns) -> SteadyState {
        let others = (0..self.program.sizes.symmetries).filter(|at| Some(*at) != self.by_time);
        let all = if unknowns.moves { others.collect() } else { Vec::new() };
        let none = self.rest_velocities();
        // First, the velocities along symmetries that best fit the guess are found, so that the guess changes
        // as little as possible.
        let carried = self.newton_improved(x, none.clone(), &UnknownIndices { states: Vec::new(), along: all.clone() });
        let near =
            self.newton_improved(x, carried.along, &UnknownIndices { states: unknowns.states.clone(), along: all });
        if !unknowns.moves {
            return self.steady_from_iterate(near);
        }
        // At some states, symmetries act alike, as spin and turn of an upright top do. Only the first of such
        // symmetries is used.
        let along = self.independent(&near.values.symmetries);
        let settled = self.newton_improved(&near.x, none, &UnknownIndices { states: Vec::new(), along });
        self.steady_from_iterate(NewtonIterate { uncertain: near.uncertain, ..settled })
    }

    /// Accepts the requested state without a search, with no velocity along symmetries. Only the unknown
    /// coordinates of the request are changed, to close the loops.
    ///
    /// # Errors
    /// [`Error::Request`] if the unknown coordinates cannot close the loops.
    pub(super) fn accept_state(&self, model: &Mechanism, asked: &StateWithUnknowns) -> Result<SteadyState, Error> {
        let (mut x, n) = (asked.x.clone(), self.coordinates);
        let free: Vec<usize> = asked.sought.iter().copied().filter(|at| *at < n).collect();
        let closed = || Loops::new(model).close(&self.parameters, &x[..n], &free);
        if let Some(q) = (!self.loops.is_empty() && !free.is_empty()).then(closed).flatten() {
            x[..n].copy_from_slice(&q);
        }
        let steady = self.steady_from_iterate(NewtonIterate::new(self, x, self.rest_velocities()));
        if steady.open.is_empty() {
            return Ok(steady);
        }
        let open = steady
            .open
            .iter()
            .map(|(at, left)| format!("`{}` by {}", self.loops[*at], with_significant_digits(*left, 4)));
        let what = format!("loops are open at this state: {}", open.collect::<Vec<_>>().join(", "));
        Err(Error::request(what, "give coordinates that close the loops, or list enough coordinates under [guess]"))
    }

    /// Improves a guess by Newton's method as long as the residual falls: first with all loops, then with
    /// the independent loops alone. Redundant loops can be closed only to the digits of the numbers in the
    /// model file.
    fn newton_improved(
        &self,
        x: &[DoubleDouble],
        along: Vec<DoubleDouble>,
        unknowns: &UnknownIndices,
    ) -> NewtonIterate {
        let sizes = self.program.sizes;
        let guess = NewtonIterate::new(self, x.to_vec(), along);
        if sizes.ties == sizes.loops {
            return self.newton_improved_partly(guess, unknowns, sizes.states + sizes.loops);
        }
        let near = self.newton_improved_partly(guess, unknowns, sizes.states + sizes.loops);
        self.newton_improved_partly(near, unknowns, sizes.states + sizes.ties)
    }

    /// Improves a guess by Newton's method, with only the first `first` residuals.
    fn newton_improved_partly(&self, guess: NewtonIterate, unknowns: &UnknownIndices, first: usize) -> NewtonIterate {
        let mut guess = guess;
        let weights = guess.residual_weights(first);
        let mut changes = [0.0; 2];
        for _ in 0..STEPS {
            if guess.residual_norm(&weights) <= EXACT {
                break;
            }
            let Some(better) = self.newton_step(&guess, unknowns, &weights) else { break };
            changes = [changes[1], largest_newton_change(&guess.x, &better.x)];
            guess = better;
        }
        let is_slow = changes[0] > 0.0 && changes[1] > SLOW * changes[0];
        guess.uncertain = if is_slow { changes[1] } else { 0.0 };
        guess
    }

    /// Makes a step of Newton's method, shortened if necessary. `None` if no fraction of the step reduces
    /// the residual.
    fn newton_step(&self, guess: &NewtonIterate, unknowns: &UnknownIndices, weights: &[f64]) -> Option<NewtonIterate> {
        let mut jacobian = self.residual_slopes(guess, unknowns);
        jacobian.row_iter_mut().zip(weights).for_each(|(mut row, weight)| row *= *weight);
        let left = guess.left.iter().zip(weights).map(|(left, weight)| left.hi() * weight);
        let change = least_squares(&jacobian, &DVector::from_iterator(guess.left.len(), left), NOTHING)?;
        let turns = unknowns.states.iter().zip(change.iter()).filter(|(at, _)| self.is_angle[**at]);
        let most = turns.fold(0.0_f64, |most, (_, by)| most.max(by.abs()));
        let (size, mut share) = (guess.residual_norm(weights), (MOST_TURN / most).min(1.0));
        for _ in 0..HALVINGS {
            let (mut x, mut along) = (guess.x.clone(), guess.along.clone());
            let moved = |value: &mut DoubleDouble, by: f64| *value = *value + DoubleDouble::from_f64(share * by);
            for (at, by) in unknowns.states.iter().zip(change.iter()) {
                moved(&mut x[*at], *by);
            }
            for (at, by) in unknowns.along.iter().zip(change.iter().skip(unknowns.states.len())) {
                moved(&mut along[*at], *by);
            }
            let next = NewtonIterate::new(self, x, along);
            if next.residual_norm(weights) < size {
                return Some(next);
            }
            share /= 2.0;
        }
        None
    }

    /// Indices of the states that a search may change: all except the time.
    pub(super) fn free_states(&self) -> Vec<usize> {
        (0..self.names.len()).filter(|at| Some(*at) != self.time).collect()
    }

    /// Velocities along the symmetries in a state of rest: 1 for the shift of time, otherwise 0.
    pub(super) fn rest_velocities(&self) -> Vec<DoubleDouble> {
        (0..self.program.sizes.symmetries).map(|at| DoubleDouble::int(i64::from(Some(at) == self.by_time))).collect()
    }

    /// Indices of the symmetries whose directions do not depend on the directions before them. The shift of
    /// time is left out. `fields` has the direction of each symmetry at a state.
    fn independent(&self, fields: &[Vec<DoubleDouble>]) -> Vec<usize> {
        let others: Vec<usize> = (0..fields.len()).filter(|at| Some(*at) != self.by_time).collect();
        let fields: Vec<&Vec<DoubleDouble>> = others.iter().map(|at| &fields[*at]).collect();
        independent_symmetries(&fields).into_iter().map(|place| others[place]).collect()
    }

    /// Derivatives of the residuals at a steady state, a column for each unknown. The unknowns are the
    /// given states, followed by the velocities along the symmetries that are independent at this state.
    pub(super) fn residual_slopes_at(&self, steady: &SteadyState, states: &[usize]) -> DMatrix<f64> {
        let guess = NewtonIterate::new(self, steady.x.clone(), steady.along.clone());
        let along = self.independent(&guess.values.symmetries);
        self.residual_slopes(&guess, &UnknownIndices { states: states.to_vec(), along })
    }

    /// Derivatives of the residuals at a state of Newton's method, a column for each unknown.
    fn residual_slopes(&self, guess: &NewtonIterate, unknowns: &UnknownIndices) -> DMatrix<f64> {
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

    /// Makes the result of a search from the last state of Newton's method. Lists the residuals that are
    /// too large.
    fn steady_from_iterate(&self, guess: NewtonIterate) -> SteadyState {
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
        SteadyState {
            x: guess.x,
            along: guess.along,
            residual,
            uncertain,
            unbalanced,
            forces: Vec::new(),
            open,
            by_time,
        }
    }
}

/// Largest difference of two states in any component, relative to the component or to 1, whichever is
/// larger.
fn largest_newton_change(a: &[DoubleDouble], b: &[DoubleDouble]) -> f64 {
    let one = |(a, b): (&DoubleDouble, &DoubleDouble)| (*a - *b).hi().abs() / a.hi().abs().max(1.0);
    a.iter().zip(b).map(one).fold(0.0, f64::max)
}

/// Indices of the vectors in `fields` that do not depend linearly on the vectors before them.
fn independent_symmetries(fields: &[&Vec<DoubleDouble>]) -> Vec<usize> {
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let mut list = Vec::new();
    for (at, field) in fields.iter().enumerate() {
        let field = DVector::from_iterator(field.len(), field.iter().map(|x| x.hi()));
        let size = field.norm();
        let mut left = field;
        // The components are removed twice, since rounding leaves a remainder the first time.
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
