//! Samples: values of terms at random permitted states, in doubles.
//!
//! Such values can show that terms differ. They never prove an equality.

use super::permitted_states::PermittedStates;
use crate::algebra::value::field::Generator;
use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr};

/// Number of random states that are drawn for samples, including states that turn out not to be
/// permitted.
const DRAWN: usize = 200;

impl PermittedStates {
    /// Values of the given terms at random permitted states: for each state, a list in the order of
    /// the terms. States at which a value is not finite are left out. Every call draws the same
    /// states. `None` if a term cannot be evaluated.
    pub fn samples(&mut self, arena: &mut Arena, terms: &[Expr]) -> Option<impl Iterator<Item = Vec<f64>> + use<>> {
        let mut outputs: Vec<Expr> = terms.iter().map(|e| self.write_in_free_symbols(arena, *e)).collect();
        let count = outputs.len();
        outputs.extend(self.free_conditions());
        let parts = arena.reachable(&outputs).into_iter();
        let free: Vec<Expr> = parts.filter(|e| arena.symbol_name(*e).is_some()).collect();
        let tape = Tape::new(arena, &free, &outputs).ok()?;
        let positive: Vec<bool> = free.iter().map(|symbol| arena.is_positive(*symbol)).collect();
        let mut generator = Generator(1 + free.len() as u64);
        let state = move |_| {
            let inputs: Vec<f64> =
                positive.iter().map(|is_positive| random_sample_number(&mut generator, *is_positive)).collect();
            let mut values = tape.evaluate(&inputs);
            let is_permitted = values[count..].iter().all(|x| *x > 0.0);
            values.truncate(count);
            (is_permitted && values.iter().all(|x| x.is_finite())).then_some(values)
        };
        Some((0..DRAWN).filter_map(state))
    }
}

/// Random number with an absolute value from 0.3 to 1.7. Its sign is random, unless the number must
/// be positive.
fn random_sample_number(generator: &mut Generator, is_positive: bool) -> f64 {
    let size = 0.3 + (generator.next() % 1_400_000) as f64 * 1e-6;
    if is_positive || generator.next().is_multiple_of(2) { size } else { -size }
}
