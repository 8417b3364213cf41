//! Corners of drives: instants at which a prescribed motion or load has a kink or a jump in time.

use super::Model;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::value::tape::{Numeric, Tape};
use crate::algebra::{Expr, Function, Node};
use rustc_hash::FxHashSet;
use tripos_traits::Real;

impl Model {
    /// Instants at which the model's drives have a kink (of an absolute value) or a jump (of a sign). Each is
    /// (instant in s, true for a jump). Only arguments linear in t are found, at the given parameter values.
    ///
    /// An integrator that steps across such an instant loses its order. Derivatives with respect to parameters,
    /// carried by the type S, pass on to the instants.
    #[must_use]
    pub fn corner_instants<S: Numeric + Real>(&self, parameters: &[S]) -> Vec<(S, bool)> {
        let Some(time) = self.time().map(|at| self.coordinates[at].symbol) else { return Vec::new() };
        let cornered: FxHashSet<(Expr, bool)> = self.arena.nodes().filter_map(drive_corner_argument).collect();
        if cornered.is_empty() {
            return Vec::new();
        }
        let arena = &mut self.arena.clone();
        let symbols = self.p();
        let (mut along, mut at_rest) = (Differential::partial(time), Substitution::new(&[(time, Expr::ZERO)]));
        let mut corners = Vec::new();
        for (argument, jumps) in cornered {
            let line = [at_rest.apply(arena, argument), along.apply(arena, argument)];
            // An argument that is not linear in time leaves more than parameters in `line`, so no program is made.
            let Ok(tape) = Tape::new(arena, &symbols, &line) else { continue };
            if let [value, slope] = tape.to::<S>().evaluate(parameters)[..] {
                corners.push((-value / slope, jumps));
            }
        }
        corners.retain(|(corner, _): &(S, bool)| corner.to_f64().is_finite());
        corners
    }

    /// Arguments of sign functions in the model that contain coordinates, rates or speeds, as text. Arguments in time
    /// alone are left out.
    #[must_use]
    pub fn sign_arguments_of_states(&self) -> Vec<String> {
        let time = self.time();
        let coordinates = self.coordinates.iter().enumerate().filter(|(at, _)| Some(*at) != time);
        let states: Vec<Expr> =
            coordinates.flat_map(|(_, c)| [c.symbol, c.rate]).chain(self.speeds.iter().map(|s| s.symbol)).collect();
        let signs = self.arena.nodes().filter_map(drive_corner_argument).filter(|(_, jumps)| *jumps);
        let of_states = signs.filter(|(argument, _)| states.iter().any(|s| self.arena.mentions(*argument, *s)));
        of_states.map(|(argument, _)| crate::algebra::text::print::print_text(&self.arena, argument)).collect()
    }
}

/// Argument of an absolute value or of a sign function, and a flag: false for the absolute value (a kink), true for
/// the sign (a jump). `None` for other terms.
fn drive_corner_argument(node: &Node) -> Option<(Expr, bool)> {
    match node {
        Node::Apply(Function::Abs, argument) => Some((*argument, false)),
        Node::Apply(Function::Sign, argument) => Some((*argument, true)),
        _ => None,
    }
}
