//! Conversion of a network back to terms of the arena, each step after the steps that it uses.

use super::network::{Atom, Network, Term, Value, is_unit};
use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr, PowerError, Rational};
use rustc_hash::FxHashSet;

/// Steps and values after sharing.
#[derive(Clone, Debug)]
pub struct Shared {
    /// Given steps and new steps, each after the steps that it uses.
    pub steps: Vec<Definition>,
    /// Given values, rewritten in the symbols of the steps, in the given order.
    pub values: Vec<Expr>,
}

/// True if a symbol was introduced by [`super::share`].
#[must_use]
pub fn is_shared_symbol(arena: &Arena, symbol: Expr) -> bool {
    arena.symbol_name(symbol).is_some_and(|name| name.starts_with('#'))
}

/// Converts a network to steps and values. A sum or inverse that is used more than once, or that cannot stand inside
/// another term, gets a symbol of its own. `None` if a term has an exponent that the arena cannot hold.
pub(super) fn rebuild(arena: &mut Arena, network: &Network) -> Option<Shared> {
    let mut builder = Builder {
        arena,
        network,
        uses: uses(network),
        built: vec![None; network.atoms.len()],
        named: 0,
        too_large: false,
        steps: Vec::new(),
    };
    // A step that sharing introduced is computed only if another term uses it.
    for step in &network.steps {
        let symbol = network.atoms[*step as usize].symbol;
        if symbol.is_none_or(|symbol| !is_shared_symbol(builder.arena, symbol)) {
            builder.define(*step);
        }
    }
    let values = network.values.iter().map(|value| builder.define(*value)).collect();
    (!builder.too_large).then_some(Shared { steps: builder.steps, values })
}

/// Number of uses of each atom, in other atoms and as an output. A power counts as many times as its exponent.
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

fn operands(network: &Network, atom: Atom) -> Vec<(Atom, usize)> {
    match &network.atoms[atom as usize].value {
        Value::Leaf(_) => network.inside.get(&atom).into_iter().flatten().map(|step| (*step, 1)).collect(),
        Value::Inverse(of) => vec![(*of, 1)],
        Value::Sum(_) => {
            network.terms(atom).flat_map(|(_, term)| term.factors.iter().map(|(a, n)| (*a, *n as usize))).collect()
        }
    }
}

struct Builder<'a> {
    arena: &'a mut Arena,
    network: &'a Network,
    uses: Vec<usize>,
    /// Term that replaces each atom in others; `None` until it is built.
    built: Vec<Option<Expr>>,
    /// Number of new symbols so far.
    named: usize,
    /// True if an exponent was larger than the arena allows.
    too_large: bool,
    steps: Vec<Definition>,
}

/// Place of a term in the sum that is rebuilt.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Place {
    /// The sum has this term only.
    Alone,
    /// The sum has further terms.
    AmongTerms,
}

impl Builder<'_> {
    /// Returns the term that stands for an atom, and defines all steps that it uses first. It is not recursive, since
    /// chains of steps are long.
    fn define(&mut self, atom: Atom) -> Expr {
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

    fn build(&mut self, atom: Atom) {
        let member = &self.network.atoms[atom as usize];
        let value = match &member.value {
            Value::Leaf(e) => *e,
            Value::Inverse(of) => {
                let below = self.built[*of as usize].unwrap_or(Expr::ONE);
                let inverse = self.arena.pow(below, -1);
                self.or_too_large(inverse)
            }
            Value::Sum(_) => self.sum(atom),
        };
        let stands = match (member.symbol, &member.value) {
            (Some(symbol), _) => {
                self.steps.push(Definition { symbol, value });
                symbol
            }
            (None, Value::Inverse(_) | Value::Sum(_)) if self.uses[atom as usize] > 1 && !self.is_plain(value) => {
                self.fresh(value)
            }
            _ => value,
        };
        self.built[atom as usize] = Some(stands);
    }

    fn is_plain(&self, e: Expr) -> bool {
        self.arena.symbol_name(e).is_some() || self.arena.as_number(e).is_some()
    }

    fn fresh(&mut self, value: Expr) -> Expr {
        self.named += 1;
        let symbol = self.arena.symbol(&format!("#{}", self.named));
        self.steps.push(Definition { symbol, value });
        symbol
    }

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

    /// Product of the factors of a term. A single factor that is a sum, and would merge into the surrounding sum, gets
    /// a symbol.
    fn product(&mut self, term: &Term, place: Place) -> Expr {
        if let [(only, 1)] = term.factors.as_slice()
            && (place == Place::AmongTerms || !is_unit(&term.k))
        {
            let value = self.built[*only as usize].unwrap_or(Expr::ONE);
            let is_sum = matches!(self.arena.node(value), crate::algebra::Node::Sum(..));
            if is_sum {
                let symbol = self.fresh(value);
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
        self.or_too_large(product)
    }

    fn or_too_large(&mut self, power: Result<Expr, PowerError>) -> Expr {
        self.too_large |= power.is_err();
        power.unwrap_or(Expr::ZERO)
    }
}
