//! Search for the form of the terms whose Taylor recurrences have the lowest cost.

use super::factored_monomials::{Preference, factored_form, factored_forms};
use super::recurrences::Recurrences;
use super::series_from_terms::{series_from_terms, terms_with_series};
use tripos_derive::Equations;
use tripos_derive::algebra::solve::elimination::Elimination;
use tripos_derive::algebra::term::steps::{Definition, needed_steps};
use tripos_derive::algebra::{Arena, Expr};

/// Largest number of rounds in which the recurrences are improved. Each round tries every form of every expression.
const ROUNDS: usize = 3;

/// Largest number of steps of a program whose recurrences are improved. A longer program already consists of short
/// steps.
const MOST_IMPROVED: usize = 100;

/// Largest number of forms of all expressions together for which several rounds are run. If there are more, each form
/// is tried only once.
const MOST_TRIALS: usize = 150;

/// Derives the recurrences of the state (q, v) of a set of equations, from the program of its
/// accelerations. `None` if a function in the equations has no Taylor series everywhere.
#[must_use]
pub fn cheapest_recurrences_of(
    arena: &mut Arena,
    equations: &Equations,
    accelerations: &Elimination,
) -> Option<Recurrences> {
    let states = [equations.coordinates.as_slice(), &equations.variables].concat();
    let rates = [&equations.coordinate_rates, &equations.unknowns[..equations.variables.len()]].concat();
    cheapest_recurrences(arena, &states, &rates, &accelerations.steps)
}

/// Derives the recurrences of states whose rates are terms in states, parameters and the symbols of `steps`. It
/// chooses forms of the terms with few convolutions. `None` if a term contains |x| or sign x, which have no Taylor
/// series everywhere.
#[must_use]
pub fn cheapest_recurrences(
    arena: &mut Arena,
    states: &[Expr],
    rates: &[Expr],
    steps: &[Definition],
) -> Option<Recurrences> {
    let mut steps = needed_steps(arena, steps, rates);
    let mut rates = rates.to_vec();
    let mut best = series_from_terms(arena, states, &rates, &steps)?;
    let varying = terms_with_series(arena, states, &rates, &steps);
    if steps.len() > MOST_IMPROVED {
        return Some(best);
    }
    let mut together = Vec::new();
    let count = steps.len() + rates.len();
    let of = |steps: &[Definition], rates: &[Expr], at: usize| match steps.get(at) {
        Some(step) => step.value,
        None => rates[at - steps.len()],
    };
    let choices: Vec<Vec<Expr>> =
        (0..count).map(|at| factored_forms(arena, &varying, of(&steps, &rates, at))).collect();
    // Forms that save products only together are tried together, one preference at a time.
    for preference in Preference::ALL {
        let mut form = |e: Expr| factored_form(arena, &varying, e, preference);
        let new_steps: Vec<Definition> = steps.iter().map(|s| Definition { value: form(s.value), ..*s }).collect();
        let new_rates: Vec<Expr> = rates.iter().map(|e| form(*e)).collect();
        together.push((new_steps, new_rates));
    }
    for (new_steps, new_rates) in together {
        let Some(found) = series_from_terms(arena, states, &new_rates, &new_steps) else { continue };
        if cost(&found) < cost(&best) {
            (best, steps, rates) = (found, new_steps, new_rates);
        }
    }
    let trials: usize = choices.iter().map(Vec::len).sum();
    let rounds = if trials > MOST_TRIALS { 1 } else { ROUNDS };
    for _ in 0..rounds {
        let before = cost(&best);
        for (at, forms) in choices.iter().enumerate() {
            for form in std::iter::once(of(&steps, &rates, at)).chain(forms.iter().copied()).collect::<Vec<_>>() {
                let (mut new_steps, mut new_rates) = (steps.clone(), rates.clone());
                match new_steps.get_mut(at) {
                    Some(step) => step.value = form,
                    None => new_rates[at - steps.len()] = form,
                }
                let Some(found) = series_from_terms(arena, states, &new_rates, &new_steps) else {
                    continue;
                };
                if cost(&found) < cost(&best) {
                    (best, steps, rates) = (found, new_steps, new_rates);
                }
            }
        }
        if cost(&best) == before {
            break;
        }
    }
    Some(best)
}

/// Returns the cost of recurrences at one order, as (number of convolutions, number of linear operations). The
/// numbers of convolutions are compared first.
fn cost(list: &Recurrences) -> (usize, usize) {
    (list.convolutions(), list.linear_operations())
}
