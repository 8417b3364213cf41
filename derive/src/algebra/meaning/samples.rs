//! Values of terms at random permitted states, in doubles.
//!
//! Numbers reject, and prove no equality.

use super::permitted::Permitted;
use crate::algebra::value::evaluate::Tape;
use crate::algebra::value::field::Generator;
use crate::algebra::{Arena, Expr};

/// Number of states that are drawn; those that are not permitted are left out.
const DRAWN: usize = 200;

impl Permitted {
    /// Values of terms at random permitted states at which all are finite, state by state. The same states are drawn
    /// each time. `None` if a term cannot be evaluated.
    pub fn samples(&mut self, arena: &mut Arena, terms: &[Expr]) -> Option<impl Iterator<Item = Vec<f64>> + use<>> {
        let mut outputs: Vec<Expr> = terms.iter().map(|e| self.put(arena, *e)).collect();
        let count = outputs.len();
        outputs.extend(self.free_conditions());
        let parts = arena.reachable(&outputs).into_iter();
        let free: Vec<Expr> = parts.filter(|e| arena.symbol_name(*e).is_some()).collect();
        let tape = Tape::new(arena, &free, &outputs).ok()?;
        let positive: Vec<bool> = free.iter().map(|symbol| arena.is_positive(*symbol)).collect();
        let mut generator = Generator(1 + free.len() as u64);
        let state = move |_| {
            let inputs: Vec<f64> = positive.iter().map(|is_positive| drawn(&mut generator, *is_positive)).collect();
            let mut values = tape.evaluate(&inputs);
            let is_permitted = values[count..].iter().all(|x| *x > 0.0);
            values.truncate(count);
            (is_permitted && values.iter().all(|x| x.is_finite())).then_some(values)
        };
        Some((0..DRAWN).filter_map(state))
    }
}

/// Random number whose size is 0.3 to 1.7, of either sign unless it must be positive.
fn drawn(generator: &mut Generator, is_positive: bool) -> f64 {
    let size = 0.3 + (generator.next() % 1_400_000) as f64 * 1e-6;
    if is_positive || generator.next().is_multiple_of(2) { size } else { -size }
}
