//! Search for rest positions and steady motions from a guess, and from further starts around it.

use super::SteadyProblem;
use super::force_balance::RestSearch;
use super::linear_system::SteadyLinearSystem;
use super::quotient_system::ShiftedStates;
use super::steady_newton::Unknowns;
use super::steady_state::{SteadyState, is_same_state_value, is_same_steady_state};
use crate::{Error, Mechanism};
use std::f64::consts::PI;
use tripos_derive::scene::StateWithUnknowns;
use tripos_traits::{DoubleDouble, Scalar};

/// First 24 primes, the bases of the sequences by which starts are spread. Source: J. H. Halton, Numer.
/// Math. 2, 1960.
const PRIMES: [u64; 24] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89];

/// Advice to the user if no steady motion is found.
pub(super) const ELSEWHERE: &str =
    "put the values that may change under [guess], begin from another state, or try more starts (--starts)";

/// Steady motion that a search found, with its linear system or the reason why it has none.
#[derive(Clone, Debug)]
pub struct FoundMotion {
    /// State and velocities of the steady motion, with residuals.
    pub steady: SteadyState,
    /// Linear system near the steady motion, or the reason why it has none.
    pub about: Result<SteadyLinearSystem, Error>,
}

/// Selects the unknowns of a search. They are the states that the state file guesses. If it guesses
/// none, all states are unknown if something moves at the guess, and otherwise all coordinates.
#[must_use]
pub fn search_unknowns(question: &SteadyProblem, asked: &StateWithUnknowns) -> Unknowns {
    let n = question.coordinates;
    let moves = question.has_motion_at(&asked.x) || asked.sought.iter().any(|at| *at >= n);
    let states = match (asked.sought.is_empty(), moves) {
        (false, _) => asked.sought.clone(),
        (true, false) => question.free_states().into_iter().filter(|at| *at < n).collect(),
        (true, true) => question.free_states(),
    };
    Unknowns { states, moves }
}

/// Lists the searches to try, each a guess and its unknowns. They form groups, which are tried in turn
/// until a group finds something. The first group is the request of the state file. If it is empty or
/// only closes loops, a second group searches for the steady motion and for rest near the guess.
fn searches_to_try(question: &SteadyProblem, asked: &StateWithUnknowns) -> Vec<Vec<(Vec<DoubleDouble>, Unknowns)>> {
    let n = question.coordinates;
    let mut groups = Vec::new();
    if !asked.sought.is_empty() {
        groups.push(vec![(asked.x.clone(), search_unknowns(question, asked))]);
        if asked.sought.len() > question.program.sizes.ties || asked.sought.iter().any(|at| *at >= n) {
            return groups;
        }
    }
    let mut at_rest = asked.x.clone();
    at_rest[n..].iter_mut().for_each(|u| *u = DoubleDouble::int(0));
    let places = question.free_states().into_iter().filter(|at| *at < n).collect();
    let rest = (at_rest, Unknowns { states: places, moves: false });
    let moving = question.has_motion_at(&asked.x) && !question.flow.symmetries.is_empty();
    let steady = moving.then(|| (asked.x.clone(), Unknowns { states: question.free_states(), moves: true }));
    groups.push(steady.into_iter().chain([rest]).collect());
    groups
}

/// Finds rest positions and, if something moves at the guess, steady motions.
///
/// Newton's method begins at the guess, and then at `starts` further starts around it. If the chosen
/// speeds are singular, rest is found by the balance of forces along every permitted motion.
///
/// # Errors
/// [`Error`] if the model cannot be derived, or if no steady motion is found. The message states
/// the residuals of the first search.
pub fn find_equilibria(model: &Mechanism, asked: &StateWithUnknowns, starts: u64) -> Result<Vec<FoundMotion>, Error> {
    let mut question = SteadyProblem::new(model, asked, &[])?;
    let spread = StartRange::new(model, asked);
    let mut list: Vec<SteadyState> = Vec::new();
    let mut nearest = None;
    let rests = RestSearch::default();
    let tries = searches_to_try(&question, asked).into_iter().flat_map(|group| {
        let last = group.len() - 1;
        group.into_iter().enumerate().map(move |(at, what)| (what, at == last))
    });
    for ((x, unknowns), is_last) in tries {
        let first = question.find_steady_state(&x, &unknowns);
        let others = (1..=starts).map(|start| spread.spread_start(&x, &unknowns.states, start));
        for (start, x) in std::iter::once(x.clone()).chain(others).enumerate() {
            let steady = if start == 0 { first.clone() } else { question.find_steady_state(&x, &unknowns) };
            let steady = rests.replace_by_balanced_rest(model, &question, steady, &x, &unknowns);
            if steady.is_steady() && !list.iter().any(|known| is_same_steady_state(model, known, &steady)) {
                list.push(steady);
            }
        }
        nearest.get_or_insert(first);
        if is_last && !list.is_empty() {
            break;
        }
    }
    if let (true, Some(first)) = (list.is_empty(), nearest) {
        return Err(question.not_steady_error(&first, ELSEWHERE));
    }
    // A singular state is returned only if there is no other: its equations give no linear system.
    let is_regular = |steady: &SteadyState| question.poles.refuse_singular_state(&question.parameters, steady).is_ok();
    if list.iter().any(is_regular) {
        list.retain(is_regular);
    }
    let mut found: Vec<FoundMotion> = Vec::new();
    for steady in list {
        let about = question.linear_system_near(model, steady.clone(), ShiftedStates::LeftOut);
        let is_known = found.iter().any(|known| is_shifted_equilibrium(model, known, &about));
        if !is_known {
            found.push(FoundMotion { steady, about });
        }
    }
    Ok(found)
}

/// True if a new steady motion equals a known one up to symmetries: all states that the symmetries do not
/// shift are equal.
fn is_shifted_equilibrium(model: &Mechanism, known: &FoundMotion, new: &Result<SteadyLinearSystem, Error>) -> bool {
    let (Ok(a), Ok(b)) = (&known.about, new) else { return false };
    a.system.kept == b.system.kept
        && !a.system.shifted.is_empty()
        && a.system
            .kept
            .iter()
            .chain(&a.system.closed)
            .all(|at| is_same_state_value(model, *at, a.steady.x[*at].hi(), b.steady.x[*at].hi()))
}

/// Range in which the starts of a search are spread around the guess.
struct StartRange {
    /// Largest shift of each state from the guess. It is a half turn for angles, twice the longest length
    /// for other coordinates, and twice the largest speed for speeds.
    reach: Vec<f64>,
}

impl StartRange {
    /// Computes the range from the lengths among the parameters and from the speeds of the guess.
    fn new(model: &Mechanism, asked: &StateWithUnknowns) -> Self {
        let is_length = |at: usize| model.parameters[at].unit.is_length();
        let lengths = (0..model.parameters.len()).filter(|at| is_length(*at)).map(|at| asked.parameters[at].hi().abs());
        let longest = lengths.fold(0.0_f64, f64::max);
        let longest = if longest > 0.0 { longest } else { 1.0 };
        let of_place = model.coordinates.iter().map(|c| if c.unit.is_plain() { PI } else { 2.0 * longest });
        let speeds = &asked.x[model.coordinates.len()..];
        let most = speeds.iter().fold(0.0_f64, |most, u| most.max(u.hi().abs())).max(1.0);
        Self { reach: of_place.chain(speeds.iter().map(|_| 2.0 * most)).collect() }
    }

    /// Makes the start with the number `start`, from 1: the guess with its unknown states `sought` shifted
    /// within their range.
    fn spread_start(&self, guess: &[DoubleDouble], sought: &[usize], start: u64) -> Vec<DoubleDouble> {
        let mut x = guess.to_vec();
        for (place, at) in sought.iter().enumerate() {
            let share = 2.0 * radical_inverse(start, PRIMES[place % PRIMES.len()]) - 1.0;
            x[*at] = x[*at] + DoubleDouble::from_f64(self.reach[*at] * share);
        }
        x
    }
}

/// Number between 0 and 1 whose digits in the given base are the digits of `number` in reverse order.
fn radical_inverse(mut number: u64, base: u64) -> f64 {
    let (mut value, mut digit) = (0.0, 1.0);
    while number > 0 {
        digit /= base as f64;
        value += digit * (number % base) as f64;
        number /= base;
    }
    value
}
