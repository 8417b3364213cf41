//! Two models compared: what an edit changed in the equations of motion, entry by entry.

use crate::algebra::compare::{Comparer, Verdict};
use crate::algebra::{Arena, Expr, Node, Rational};
use crate::mechanics::Derivations;
use crate::model::Model;
use crate::prove::Proof;
use rustc_hash::FxHashMap;

/// Something that both models could have, compared.
#[derive(Clone, Debug)]
pub struct Change {
    /// What it is: `kane M[u1, u2']`, `T`, `u1`.
    pub name: String,
    /// Its value in the old model, in the new model's arena.
    pub old: Option<Expr>,
    /// Its value in the new model.
    pub new: Option<Expr>,
    /// new − old in its shortest form, where both are there.
    pub difference: Option<Expr>,
    /// Whether they are the same; none where one is missing.
    pub verdict: Option<Verdict>,
}

/// What an edit changed.
#[derive(Clone, Debug)]
pub struct ModelDifference {
    /// Everything that is not the same, in the order of the equations.
    pub changes: Vec<Change>,
    /// How many entries were compared.
    pub compared: usize,
    /// Names of first integrals that only the old model has.
    pub integrals_lost: Vec<String>,
    /// Names of first integrals that only the new model has.
    pub integrals_gained: Vec<String>,
}

/// A model with everything derived and proved of it.
pub struct Derived<'a> {
    /// The model.
    pub model: &'a Model,
    /// Its equations.
    pub derivations: &'a mut Derivations,
    /// What was proved of it.
    pub proof: &'a Proof,
}

/// Compares two models; terms of the old one are written in the new one's arena, symbol by name.
pub fn diff_models(old: &mut Derived<'_>, new: &mut Derived<'_>) -> ModelDifference {
    let before = entries(old.model, old.derivations);
    let after = entries(new.model, new.derivations);
    let from = &old.derivations.kinematics.arena;
    let kinematics = &mut new.derivations.kinematics;
    let mut transfer = Transfer { from, done: FxHashMap::default() };
    let mut comparer = Comparer::default();
    let mut changes = Vec::new();
    let find = |list: &[(String, Expr)], name: &str| list.iter().find(|(n, _)| n == name).map(|(_, e)| *e);
    for (name, new) in &after {
        let arena = &mut kinematics.arena;
        let Some(old) = find(&before, name) else {
            // An entry that is zero says nothing new.
            if *new != Expr::ZERO {
                changes.push(Change {
                    name: name.clone(),
                    old: None,
                    new: Some(*new),
                    difference: None,
                    verdict: None,
                });
            }
            continue;
        };
        let old = transfer.term(arena, old);
        let verdict = comparer.compare(arena, old, *new);
        if !verdict.is_equal() {
            let difference = arena.sub(*new, old);
            let difference = kinematics.simplifier.simplify(arena, difference);
            let (old, new) = (Some(old), Some(*new));
            changes.push(Change { name: name.clone(), old, new, difference: Some(difference), verdict: Some(verdict) });
        }
    }
    for (name, old) in before.iter().filter(|(name, e)| find(&after, name).is_none() && *e != Expr::ZERO) {
        let old = Some(transfer.term(&mut kinematics.arena, *old));
        changes.push(Change { name: name.clone(), old, new: None, difference: None, verdict: None });
    }
    let names = |proof: &Proof| proof.integrals.iter().map(|i| i.name.clone()).collect::<Vec<_>>();
    let (lost, gained) = (names(old.proof), names(new.proof));
    ModelDifference {
        changes,
        compared: after.len(),
        integrals_lost: lost.iter().filter(|name| !gained.contains(name)).cloned().collect(),
        integrals_gained: gained.into_iter().filter(|name| !lost.contains(name)).collect(),
    }
}

/// Everything that is compared, by name: speeds, kinematic equations, energies, each formulation's system.
fn entries(model: &Model, derivations: &Derivations) -> Vec<(String, Expr)> {
    let arena = &derivations.kinematics.arena;
    let mut list: Vec<(String, Expr)> = model.speeds.iter().map(|s| (s.name.clone(), s.definition)).collect();
    let rates = model.coordinates.iter().zip(&model.kinematic_equations.rates);
    list.extend(rates.map(|(c, rate)| (format!("{}'", c.name), *rate)));
    for (formulation, equations) in &derivations.list {
        let Ok(e) = equations else { continue };
        let name = formulation.name();
        if !list.iter().any(|(n, _)| n == "T") {
            list.push(("T".to_owned(), e.kinetic_energy));
            list.push(("V".to_owned(), e.potential_energy));
        }
        for (label, row) in e.rows.iter().zip(&e.matrix) {
            for (unknown, entry) in e.unknowns.iter().zip(row) {
                let unknown = arena.symbol_name(*unknown).unwrap_or_default();
                list.push((format!("{name} M[{label}, {unknown}]"), *entry));
            }
        }
        let forcing = e.rows.iter().zip(&e.forcing);
        list.extend(forcing.map(|(label, entry)| (format!("{name} f[{label}]"), *entry)));
    }
    list
}

/// Writes terms of one arena in another.
struct Transfer<'a> {
    from: &'a Arena,
    done: FxHashMap<Expr, Expr>,
}

impl Transfer<'_> {
    fn term(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        for part in self.from.reachable(&[e]) {
            if !self.done.contains_key(&part) {
                let new = self.one(arena, part);
                self.done.insert(part, new);
            }
        }
        self.done[&e]
    }

    fn one(&self, arena: &mut Arena, e: Expr) -> Expr {
        match self.from.node(e) {
            Node::Number(value) => arena.number(value.clone()),
            Node::Symbol(_) => arena.symbol(self.from.symbol_name(e).unwrap_or_default()),
            Node::Pi => arena.pi(),
            Node::Sum(constant, terms) => {
                let constant = arena.number(constant.clone());
                let mut list: Vec<_> = terms.iter().map(|(term, k)| (self.done[term], k.clone())).collect();
                list.push((constant, Rational::ONE));
                arena.linear_combination(&list)
            }
            Node::Product(factors) => {
                let list: Vec<_> = factors.iter().map(|(base, n)| (self.done[base], *n)).collect();
                arena.try_product(&list).expect("what could be built in one arena can be built in another")
            }
            Node::Apply(f, argument) => arena.apply(*f, self.done[argument]),
        }
    }
}
