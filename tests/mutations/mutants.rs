//! Six ways to spoil a formula, one place at a time.

use super::printed::{Printed, System};
use super::tree::{call, edits, name, number, power, product, quotient, sum, text};
use crate::support::Random;
use rustc_hash::FxHashSet;
use tripos_derive::algebra::text::display_tree::DisplayTree;

/// Kind of change to a formula.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Kind {
    /// A term changes its sign.
    Sign,
    /// A number becomes another, or a term gets a factor.
    Coefficient,
    /// A sine becomes a cosine or the other way round, a tangent a cotangent.
    SineCosine,
    /// A term is left out.
    Term,
    /// A symbol becomes another of its kind, or two of them change places.
    Index,
    /// An exponent becomes another, or a symbol gets one.
    Power,
}

impl Kind {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Sign, Self::Coefficient, Self::SineCosine, Self::Term, Self::Index, Self::Power];
}

/// Place of a mutant among the formulas of a model.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Place {
    /// The value of a quantity: its position in [`Printed::equations`].
    Equation(usize),
    /// A row of a system: the positions of both.
    Row(usize, usize),
}

/// A formula that was right, and what became of it.
#[derive(Clone, Debug)]
pub struct Mutant {
    pub kind: Kind,
    pub place: Place,
    /// The right value, or the right row with its right-hand side.
    pub original: Vec<String>,
    /// The value or row with one place changed.
    pub mutated: Vec<String>,
}

/// Chooses different mutants of each kind, up to the wanted numbers: of quantities, then of rows of systems.
pub fn choose(printed: &Printed, of_equations: usize, of_rows: usize, random: &mut Random) -> Vec<Mutant> {
    let mut list = Vec::new();
    let mut seen: FxHashSet<(Place, Vec<String>)> = FxHashSet::default();
    for kind in Kind::ALL {
        for (wanted, draw) in [(of_equations, of_equation as Draw), (of_rows, of_row)] {
            let (mut found, mut tries) = (0, 0);
            while found < wanted && tries < 100 * wanted {
                tries += 1;
                let Some(mutant) = draw(kind, printed, random) else { continue };
                if mutant.mutated != mutant.original && seen.insert((mutant.place.clone(), mutant.mutated.clone())) {
                    list.push(mutant);
                    found += 1;
                }
            }
        }
    }
    list
}

type Draw = fn(Kind, &Printed, &mut Random) -> Option<Mutant>;

fn of_equation(kind: Kind, printed: &Printed, random: &mut Random) -> Option<Mutant> {
    let at = random.below(printed.equations.len());
    let tree = &printed.equations[at].1;
    let all = spoiled(kind, tree, &printed.families);
    let new = random.one_of(&all)?;
    Some(Mutant { kind, place: Place::Equation(at), original: vec![text(tree)], mutated: vec![text(new)] })
}

fn of_row(kind: Kind, printed: &Printed, random: &mut Random) -> Option<Mutant> {
    let at = random.below(printed.systems.len());
    let System { rows, .. } = &printed.systems[at];
    let row = random.below(rows.len());
    let original: Vec<String> = rows[row].iter().map(text).collect();
    let column = random.below(original.len());
    let tree = &rows[row][column];
    let mut mutated = original.clone();
    if kind == Kind::Term && random.below(3) == 0 {
        // A whole term of the equation that the row stands for.
        "0".clone_into(&mut mutated[column]);
    } else if kind == Kind::Index && random.below(3) == 0 {
        mutated.swap(column, random.below(original.len()));
    } else {
        mutated[column] = text(random.one_of(&spoiled(kind, tree, &printed.families))?);
    }
    Some(Mutant { kind, place: Place::Row(at, row), original, mutated })
}

/// Everything that one change of a kind can make of a formula.
fn spoiled(kind: Kind, tree: &DisplayTree, families: &[Vec<String>]) -> Vec<DisplayTree> {
    let mut list = edits(tree, &|node| match kind {
        Kind::Sign => signs(node),
        Kind::Coefficient => coefficients(node),
        Kind::SineCosine => waves(node),
        Kind::Term => terms(node),
        Kind::Index => indices(node, families),
        Kind::Power => powers(node),
    });
    match kind {
        Kind::Sign if !matches!(tree, DisplayTree::Sum(_)) && *tree != number(0) => {
            list.push(DisplayTree::Sum(vec![(true, tree.clone())]));
        }
        Kind::Coefficient if !matches!(tree, DisplayTree::Sum(_) | DisplayTree::Number(_)) => {
            list.push(product([number(2), tree.clone()]));
        }
        Kind::Index => list.extend(exchanges(tree, families)),
        _ => {}
    }
    list
}

fn signs(node: &DisplayTree) -> Vec<DisplayTree> {
    let DisplayTree::Sum(terms) = node else { return Vec::new() };
    let flipped = |at: usize| {
        let mut terms = terms.clone();
        terms[at].0 = !terms[at].0;
        DisplayTree::Sum(terms)
    };
    (0..terms.len()).map(flipped).collect()
}

fn coefficients(node: &DisplayTree) -> Vec<DisplayTree> {
    match node {
        DisplayTree::Number(text) => {
            let n: u32 = text.parse().expect("coefficients of mechanics are small");
            [n + 1, 2 * n + 3, n.saturating_sub(1)].into_iter().filter(|m| *m > 0 && *m != n).map(number).collect()
        }
        DisplayTree::Sum(terms) => {
            let scaled = |at: usize| {
                let mut terms = terms.clone();
                terms[at].1 = product([number(2), terms[at].1.clone()]);
                DisplayTree::Sum(terms)
            };
            (0..terms.len()).map(scaled).collect()
        }
        _ => Vec::new(),
    }
}

fn waves(node: &DisplayTree) -> Vec<DisplayTree> {
    match node {
        DisplayTree::Call("sin", x) => vec![call("cos", (**x).clone())],
        DisplayTree::Call("cos", x) => vec![call("sin", (**x).clone())],
        DisplayTree::Call("tan", _) => vec![quotient(number(1), node.clone())],
        _ => Vec::new(),
    }
}

fn terms(node: &DisplayTree) -> Vec<DisplayTree> {
    let DisplayTree::Sum(terms) = node else { return Vec::new() };
    let without = |at: usize| {
        let mut terms = terms.clone();
        terms.remove(at);
        DisplayTree::Sum(terms)
    };
    if terms.len() < 2 { Vec::new() } else { (0..terms.len()).map(without).collect() }
}

fn indices(node: &DisplayTree, families: &[Vec<String>]) -> Vec<DisplayTree> {
    let DisplayTree::Name(own) = node else { return Vec::new() };
    let family = families.iter().find(|family| family.contains(own));
    family.into_iter().flatten().filter(|other| *other != own).map(|other| name(other)).collect()
}

/// Two symbols of one kind change places everywhere.
fn exchanges(tree: &DisplayTree, families: &[Vec<String>]) -> Vec<DisplayTree> {
    let mut list = Vec::new();
    for family in families {
        for (at, a) in family.iter().enumerate() {
            list.extend(family[at + 1..].iter().map(|b| exchanged(tree, a, b)));
        }
    }
    list.retain(|new| new != tree);
    list
}

fn exchanged(tree: &DisplayTree, a: &str, b: &str) -> DisplayTree {
    let inner = |tree: &DisplayTree| Box::new(exchanged(tree, a, b));
    match tree {
        DisplayTree::Name(own) if own == a => name(b),
        DisplayTree::Name(own) if own == b => name(a),
        DisplayTree::Sum(terms) => DisplayTree::Sum(terms.iter().map(|(sign, term)| (*sign, *inner(term))).collect()),
        DisplayTree::Product(factors) => product(factors.iter().map(|factor| *inner(factor))),
        DisplayTree::Fraction(above, below) => DisplayTree::Fraction(inner(above), inner(below)),
        DisplayTree::Power(base, n) => DisplayTree::Power(inner(base), *n),
        DisplayTree::Call(function, argument) => DisplayTree::Call(function, inner(argument)),
        DisplayTree::Root(argument) => DisplayTree::Root(inner(argument)),
        other => other.clone(),
    }
}

fn powers(node: &DisplayTree) -> Vec<DisplayTree> {
    match node {
        DisplayTree::Power(base, n) => vec![power((**base).clone(), n + 1), power((**base).clone(), n - 1)],
        DisplayTree::Name(_) | DisplayTree::Call(..) => vec![power(node.clone(), 2)],
        DisplayTree::Sum(terms) if terms.len() > 1 => vec![power(sum([node.clone()]), 2)],
        _ => Vec::new(),
    }
}
