//! Sines and cosines of sums of angles, computed by addition theorems from sines and cosines that
//! are needed anyway.
//!
//! A sine and a cosine together cost as much as thirty operations, an addition theorem costs six.
//! Small differences of angles lose accuracy: the error of their sine is a rounding error of 1, not
//! of the sine itself. The same holds in every program that multiplies such products out.

use crate::algebra::term::elementary::angle_atoms;
use crate::algebra::term::steps::Definition;
use crate::algebra::text::print::print_text;
use crate::algebra::{Arena, Expr, Function, Node};
use rustc_hash::{FxHashMap, FxHashSet};

/// Largest number of addition theorems that are multiplied out together. The coefficients of nested
/// theorems have as many bits as there are theorems, so with more theorems the result is never
/// shorter.
const MOST_OPENED: usize = 48;

/// Angle that is the sum or difference of two other angles. Its sine and cosine follow from theirs
/// by the addition theorems.
struct Addition {
    /// Angle that is the sum or difference of `first` and `second`, rad.
    angle: Expr,
    /// First angle of the sum or difference, rad.
    first: Expr,
    /// Second angle of the sum or difference, rad.
    second: Expr,
    /// True for first − second; false for first + second.
    minus: bool,
}

/// Form in which the sine or cosine of a composed angle is written.
pub(super) enum Composed {
    /// The sine or cosine is replaced by a new symbol, which a new step defines by the addition
    /// theorem.
    Named,
    /// The sine or cosine is replaced by the right-hand side of the addition theorem, to be
    /// multiplied out.
    Open,
}

/// Rewrites steps and values so that fewer sines and cosines are computed. Returns the new steps
/// and values. `None` if no angle can be composed, or if the form is `Open` and more than 48 angles
/// can be composed.
pub(super) fn compose_angles(
    arena: &mut Arena,
    how: &Composed,
    steps: &[Definition],
    values: &[Expr],
) -> Option<(Vec<Definition>, Vec<Expr>)> {
    let roots: Vec<Expr> = steps.iter().map(|step| step.value).chain(values.iter().copied()).collect();
    let parts = arena.reachable(&roots);
    let additions = find_composed_angles(arena, &parts);
    if additions.is_empty() || (matches!(how, Composed::Open) && additions.len() > MOST_OPENED) {
        return None;
    }
    let mut rewriting = Rewriting { of: FxHashMap::default() };
    let mut new_steps = Vec::new();
    for addition in &additions {
        let [sine, cosine] = rewriting.addition_theorem(arena, addition);
        for (f, value) in [(Function::Sin, sine), (Function::Cos, cosine)] {
            let composed = arena.apply(f, addition.angle);
            let stands = match how {
                Composed::Open => value,
                Composed::Named => {
                    let symbol = arena.symbol(&format!("#{}", print_text(arena, composed)));
                    new_steps.push(Definition { symbol, value });
                    symbol
                }
            };
            rewriting.of.insert(composed, stands);
        }
    }
    for part in parts {
        rewriting.rewrite(arena, part);
    }
    let value = |e: Expr| rewriting.of.get(&e).copied().unwrap_or(e);
    new_steps.extend(steps.iter().map(|step| Definition { symbol: step.symbol, value: value(step.value) }));
    Some((new_steps, values.iter().map(|e| value(*e)).collect()))
}

/// Finds the angles among the terms `parts` that are sums or differences of two others. Angles with
/// fewer parts come first.
///
/// Two sets of known angles are compared: the single angles whose sines or cosines occur anyway,
/// and all single angles that occur in sums. The set that needs fewer sines and cosines in total is
/// used.
fn find_composed_angles(arena: &mut Arena, parts: &[Expr]) -> Vec<Addition> {
    let mut angles: Vec<Expr> = Vec::new();
    for part in parts {
        if let Node::Apply(Function::Sin | Function::Cos, angle) = arena.node(*part)
            && !angles.contains(angle)
        {
            angles.push(*angle);
        }
    }
    // The sine of a difference must be accurate near zero if it is a divisor. So it is computed
    // directly.
    let divides = |angle: &Expr| {
        parts.iter().any(|part| match arena.node(*part) {
            Node::Product(factors) => factors.iter().any(|(base, n)| {
                *n < 0 && matches!(arena.node(*base), Node::Apply(Function::Sin | Function::Cos, of) if of == angle)
            }),
            _ => false,
        })
    };
    angles.retain(|angle| is_atom(arena, *angle) || !divides(angle));
    angles.sort_by_key(|angle| (angle_atoms(arena, *angle).len(), *angle));
    let plain: Vec<Expr> = angles.iter().copied().filter(|a| is_atom(arena, *a)).collect();
    let mut atoms: Vec<Expr> = angles
        .iter()
        .flat_map(|a| angle_atoms(arena, *a))
        .map(|(atom, _)| atom)
        .filter(|atom| is_atom(arena, *atom))
        .collect();
    atoms.sort_unstable();
    atoms.dedup();
    let (few, alone) = composed_of(arena, &angles, &plain);
    let (all, alone_of_atoms) = composed_of(arena, &angles, &atoms);
    if plain.len() + alone <= atoms.len() + alone_of_atoms { few } else { all }
}

/// True if the angle is a single symbol, not a sum.
fn is_atom(arena: &Arena, angle: Expr) -> bool {
    matches!(arena.node(angle), Node::Symbol(_))
}

/// Finds the angles that are sums or differences of two known angles. Returns them with the number
/// of angles that are neither known nor composed. `there` lists the angles that are known at first.
fn composed_of(arena: &mut Arena, angles: &[Expr], there: &[Expr]) -> (Vec<Addition>, usize) {
    let mut list: Vec<Expr> = there.to_vec();
    let mut known: FxHashSet<Expr> = there.iter().copied().collect();
    let (mut additions, mut alone) = (Vec::new(), 0);
    for angle in angles {
        if known.contains(angle) {
            continue;
        }
        let found = list.iter().find_map(|first| {
            let rest = arena.sub(*angle, *first);
            if known.contains(&rest) {
                return Some(Addition { angle: *angle, first: *first, second: rest, minus: false });
            }
            let rest = arena.neg(rest);
            known.contains(&rest).then_some(Addition { angle: *angle, first: *first, second: rest, minus: true })
        });
        match found {
            Some(addition) => additions.push(addition),
            None => alone += 1,
        }
        list.push(*angle);
        known.insert(*angle);
    }
    (additions, alone)
}

/// State of the rewriting of terms by addition theorems.
struct Rewriting {
    /// Rewritten term by original term, for each term that changes.
    of: FxHashMap<Expr, Expr>,
}

impl Rewriting {
    /// Sine and cosine of a composed angle a ± b, as the pair (sin, cos). The addition theorems are
    /// sin (a ± b) = sin a cos b ± cos a sin b; cos (a ± b) = cos a cos b ∓ sin a sin b.
    fn addition_theorem(&self, arena: &mut Arena, addition: &Addition) -> [Expr; 2] {
        let value = |arena: &mut Arena, f: Function, angle: Expr| {
            let e = arena.apply(f, angle);
            self.of.get(&e).copied().unwrap_or(e)
        };
        let (sa, ca) = (value(arena, Function::Sin, addition.first), value(arena, Function::Cos, addition.first));
        let (sb, cb) = (value(arena, Function::Sin, addition.second), value(arena, Function::Cos, addition.second));
        let (sc, cs, cc, ss) = (arena.mul(sa, cb), arena.mul(ca, sb), arena.mul(ca, cb), arena.mul(sa, sb));
        if addition.minus { [arena.sub(sc, cs), arena.add(cc, ss)] } else { [arena.add(sc, cs), arena.sub(cc, ss)] }
    }

    /// Rewrites a term by the replacements of its operands, and records the result. The operands
    /// must be rewritten first. A term whose operands do not change is not recorded.
    fn rewrite(&mut self, arena: &mut Arena, e: Expr) {
        if self.of.contains_key(&e) || !arena.operands(e).any(|o| self.of.contains_key(&o)) {
            return;
        }
        let of = |e: &Expr| self.of.get(e).copied().unwrap_or(*e);
        let new = match arena.node(e).clone() {
            Node::Sum(constant, terms) => {
                let mut list: Vec<_> = terms.iter().map(|(term, k)| (of(term), k.clone())).collect();
                list.push((Expr::ONE, constant));
                arena.linear_combination(&list)
            }
            Node::Product(factors) => {
                let list: Vec<(Expr, i32)> = factors.iter().map(|(base, n)| (of(base), *n)).collect();
                match arena.try_product(&list) {
                    Ok(product) => product,
                    Err(_) => return,
                }
            }
            Node::Apply(f, argument) => {
                let argument = of(&argument);
                arena.apply(f, argument)
            }
            Node::Named(_, term) => arena.name_like(e, of(&term)),
            Node::Number(_) | Node::Symbol(_) | Node::Pi => return,
        };
        self.of.insert(e, new);
    }
}
