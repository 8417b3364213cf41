//! Conversion of a network of sums into terms of the arena. Each step comes after the steps that it
//! uses.

use super::network::{Atom, Network, NetworkTerm, Value, is_unit};
use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr, PowerError, Rational};
use rustc_hash::FxHashSet;

/// Steps and values of a function after common parts were shared.
#[derive(Clone, Debug)]
pub struct SharedComputation {
    /// Steps that were given and steps for shared parts, each after the steps that it uses.
    pub steps: Vec<Definition>,
    /// Values that were given, in their order, rewritten in the symbols of the steps.
    pub values: Vec<Expr>,
}

/// True if the symbol stands for a shared part that [`super::share_common_parts`] introduced: its name begins
/// with `#`.
#[must_use]
pub fn is_shared_symbol(arena: &Arena, symbol: Expr) -> bool {
    arena.symbol_name(symbol).is_some_and(|name| name.starts_with('#'))
}

/// Rebuilds steps and values from a network. A sum or inverse that is used more than once, or that
/// cannot be inside another term, gets a symbol of its own. `None` if an exponent is too large for
/// the arena.
pub(super) fn rebuild(arena: &mut Arena, network: &Network) -> Option<SharedComputation> {
    let mut builder = Rebuilder {
        arena,
        network,
        uses: uses(network),
        built: vec![None; network.atoms.len()],
        named: 0,
        too_large: false,
        steps: Vec::new(),
    };
    // A step for a shared part is computed only if another term uses it.
    for step in &network.steps {
        let symbol = network.atoms[*step as usize].symbol;
        if symbol.is_none_or(|symbol| !is_shared_symbol(builder.arena, symbol)) {
            builder.build_with_operands(*step);
        }
    }
    let values = network.values.iter().map(|value| builder.build_with_operands(*value)).collect();
    (!builder.too_large).then_some(SharedComputation { steps: builder.steps, values })
}

/// Number of uses of each atom (a leaf, inverse or sum of the network), as an operand and as an
/// output. A power counts as many uses as its exponent.
fn uses(network: &Network) -> Vec<usize> {
    let mut uses = vec![0; network.atoms.len()];
    let mut seen = FxHashSet::default();
    for value in &network.values {
        uses[*value as usize] += 1;
    }
    let mut stack: Vec<Atom> = network.steps.iter().chain(&network.values).copied().collect();
    while let Some(atom) = stack.pop() {
        if !seen.insert(atom) {
            continue;
        }
        for used in operands(network, atom) {
            uses[used.0 as usize] += used.1;
            stack.push(used.0);
        }
    }
    uses
}

/// Atoms that occur directly in the value of an atom, each with its number of occurrences.
fn operands(network: &Network, atom: Atom) -> Vec<(Atom, usize)> {
    match &network.atoms[atom as usize].value {
        Value::Leaf(_) => network.inside.get(&atom).into_iter().flatten().map(|step| (*step, 1)).collect(),
        Value::Inverse(of) => vec![(*of, 1)],
        Value::Sum(_) => {
            network.terms(atom).flat_map(|(_, term)| term.factors.iter().map(|(a, n)| (*a, *n as usize))).collect()
        }
    }
}

/// State of rebuilding terms from a network.
struct Rebuilder<'a> {
    /// Arena in which the terms are built.
    arena: &'a mut Arena,
    /// Network from which the terms are rebuilt.
    network: &'a Network,
    /// Number of uses of each atom of the network, by number.
    uses: Vec<usize>,
    /// Term that stands for each atom (a leaf, inverse or sum of the network) wherever it is used.
    /// `None` until it is built.
    built: Vec<Option<Expr>>,
    /// Number of new symbols for shared parts so far.
    named: usize,
    /// True if an exponent was too large for the arena.
    too_large: bool,
    /// Steps built so far, each after the steps that it uses.
    steps: Vec<Definition>,
}

/// Position of a term in the sum that is rebuilt.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Place {
    /// The term is the only term of its sum.
    Alone,
    /// The term is one of at least two terms of its sum.
    AmongTerms,
}

impl Rebuilder<'_> {
    /// Builds an atom after all atoms that it uses, and returns the term that stands for it. The
    /// method is not recursive, since chains of steps are long.
    fn build_with_operands(&mut self, atom: Atom) -> Expr {
        let mut stack = vec![(atom, false)];
        while let Some((atom, ready)) = stack.pop() {
            if self.built[atom as usize].is_some() {
                continue;
            }
            if ready {
                self.build(atom);
                continue;
            }
            stack.push((atom, true));
            let mut needed: Vec<Atom> = operands(self.network, atom).into_iter().map(|(a, _)| a).collect();
            needed.reverse();
            stack.extend(needed.into_iter().filter(|a| self.built[*a as usize].is_none()).map(|a| (a, false)));
        }
        self.built[atom as usize].unwrap_or(Expr::ZERO)
    }

    /// Builds the value of an atom from its operands, which must be built already. Adds a step if
    /// the atom needs a symbol.
    fn build(&mut self, atom: Atom) {
        let member = &self.network.atoms[atom as usize];
        let value = match &member.value {
            Value::Leaf(e) => *e,
            Value::Inverse(of) => {
                let below = self.built[*of as usize].unwrap_or(Expr::ONE);
                let inverse = self.arena.pow(below, -1);
                self.note_too_large(inverse)
            }
            Value::Sum(_) => self.sum(atom),
        };
        let stands = match (member.symbol, &member.value) {
            (Some(symbol), _) => {
                self.steps.push(Definition { symbol, value });
                symbol
            }
            (None, Value::Inverse(_) | Value::Sum(_)) if self.uses[atom as usize] > 1 && !self.is_plain(value) => {
                self.new_symbol(value)
            }
            _ => value,
        };
        self.built[atom as usize] = Some(stands);
    }

    /// True if the term is a symbol or a number, which needs no symbol of its own.
    fn is_plain(&self, e: Expr) -> bool {
        self.arena.symbol_name(e).is_some() || self.arena.as_number(e).is_some()
    }

    /// Creates a new symbol for a shared value, and adds the step that defines it.
    fn new_symbol(&mut self, value: Expr) -> Expr {
        self.named += 1;
        let symbol = self.arena.symbol(&format!("#{}", self.named));
        self.steps.push(Definition { symbol, value });
        symbol
    }

    /// Builds the term for an atom that is a sum, from its summands.
    fn sum(&mut self, atom: Atom) -> Expr {
        let network = self.network;
        let place = if network.terms(atom).count() > 1 { Place::AmongTerms } else { Place::Alone };
        let mut terms: Vec<(Expr, Rational)> = Vec::new();
        for (_, term) in network.terms(atom) {
            let product = self.product(term, place);
            terms.push((product, term.k.clone()));
        }
        self.arena.linear_combination(&terms)
    }

    /// Builds the product of the factors of a network term, without its coefficient. If the only
    /// factor is itself a sum, it gets a symbol, so that it does not merge into the surrounding
    /// sum.
    fn product(&mut self, term: &NetworkTerm, place: Place) -> Expr {
        if let [(only, 1)] = term.factors.as_slice()
            && (place == Place::AmongTerms || !is_unit(&term.k))
        {
            let value = self.built[*only as usize].unwrap_or(Expr::ONE);
            let is_sum = matches!(self.arena.node(value), crate::algebra::Node::Sum(..));
            if is_sum {
                let symbol = self.new_symbol(value);
                self.built[*only as usize] = Some(symbol);
                return symbol;
            }
            return value;
        }
        let factors: Vec<(Expr, i32)> = term
            .factors
            .iter()
            .map(|(atom, n)| (self.built[*atom as usize].unwrap_or(Expr::ONE), i32::try_from(*n).unwrap_or(i32::MAX)))
            .collect();
        let product = self.arena.try_product(&factors);
        self.note_too_large(product)
    }

    /// Unwraps a power. If it could not be built, returns 0 and sets `too_large`.
    fn note_too_large(&mut self, power: Result<Expr, PowerError>) -> Expr {
        self.too_large |= power.is_err();
        power.unwrap_or(Expr::ZERO)
    }
}
