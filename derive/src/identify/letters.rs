//! Known quantities in the columns of a regressor: parameters as letters, and products of these that a factor may
//! contain.

use crate::algebra::{Arena, Expr, Function, Node};
use crate::mechanics::Column;
use crate::model::{Model, Unit};
use rustc_hash::FxHashSet;

/// Largest number of products of which a sum is searched.
const MOST: usize = 240;
/// Stages of the search for a factor, in this order. A model file may state lengths as plain numbers, so the last
/// stages ignore units.
pub const STAGES: [Stage; 6] = [
    Stage { degree: 1, divides: false, by_unit: true },
    Stage { degree: 2, divides: false, by_unit: true },
    Stage { degree: 4, divides: false, by_unit: true },
    Stage { degree: 4, divides: true, by_unit: true },
    Stage { degree: 2, divides: false, by_unit: false },
    Stage { degree: 2, divides: true, by_unit: false },
];
/// Largest number of constant angles, given as numbers, whose sines and cosines are tried.
const MOST_FIXED: usize = 2;
/// Largest powers of the sine and of the cosine of one angle. `MOST_TURNS` is the largest total power of all angles.
const TURNS: [i32; 2] = [1, 2];
const MOST_TURNS: i32 = 4;

/// Set of products that one stage of the search for a factor tries.
#[derive(Clone, Copy)]
pub struct Stage {
    /// Largest total degree of a product in the letters.
    degree: i32,
    /// True if letters may be divisors.
    divides: bool,
    /// True if products must have the unit of the factor that is sought.
    by_unit: bool,
}

/// A parameter whose value counts as known in the search for factors.
pub struct Letter {
    /// Symbol of the parameter.
    pub symbol: Expr,
    unit: Unit,
    /// Index of the parameter among the atoms. `turned` has the indices of its sine and its cosine, if it occurs inside
    /// functions.
    plain: usize,
    turned: Option<[usize; 2]>,
}

/// Known parameters in the columns of a regressor, with the atoms from which formulas for factors are built.
pub struct Letters {
    /// Known parameters, in the order of the model.
    pub list: Vec<Letter>,
    atoms: Vec<Expr>,
    /// Indices, among the atoms, of the sine and the cosine of each numeric angle.
    fixed: Vec<[usize; 2]>,
    /// True if square roots occur in the columns.
    pub has_roots: bool,
    /// Symbols that change during a motion: coordinates, speeds, accelerations and inputs.
    pub moving: FxHashSet<Expr>,
}

/// A product of powers of atoms: the index of each atom and its exponent.
pub type Powers = Vec<(usize, i32)>;

impl Letters {
    /// Collects the letters and atoms of columns of a regressor.
    pub fn of(model: &Model, arena: &mut Arena, columns: &[Column]) -> Self {
        let inputs = model.parameters.iter().filter(|p| p.is_input).map(|p| p.symbol);
        let moving: FxHashSet<Expr> =
            model.q().into_iter().chain(model.u()).chain(model.speeds.iter().map(|s| s.rate)).chain(inputs).collect();
        let terms: Vec<Expr> = columns.iter().flat_map(|column| column.forces.clone()).collect();
        let reached = arena.reachable(&terms);
        let arguments: Vec<Expr> = reached
            .iter()
            .filter_map(|e| match arena.node(*e) {
                Node::Apply(_, argument) => Some(*argument),
                _ => None,
            })
            .collect();
        let inside: FxHashSet<Expr> = arena.reachable(&arguments).into_iter().collect();
        let has_roots = reached.iter().any(|e| matches!(arena.node(*e), Node::Apply(Function::Sqrt, _)));
        let mut numbers: Vec<Expr> = reached
            .iter()
            .filter_map(|e| match arena.node(*e) {
                Node::Apply(Function::Sin | Function::Cos, angle) if arena.as_number(*angle).is_some() => Some(*angle),
                _ => None,
            })
            .collect();
        numbers.sort_unstable();
        numbers.dedup();
        let reached: FxHashSet<Expr> = reached.into_iter().collect();
        let mut letters = Self { list: Vec::new(), atoms: Vec::new(), fixed: Vec::new(), has_roots, moving };
        for angle in numbers.into_iter().take(MOST_FIXED) {
            let circle = [arena.sin(angle), arena.cos(angle)].map(|e| letters.atom(e));
            letters.fixed.push(circle);
        }
        for parameter in model.parameters.iter().filter(|p| !p.is_input && reached.contains(&p.symbol)) {
            let plain = letters.atom(parameter.symbol);
            let turned = inside.contains(&parameter.symbol).then(|| {
                let circle = [arena.sin(parameter.symbol), arena.cos(parameter.symbol)];
                circle.map(|e| letters.atom(e))
            });
            letters.list.push(Letter { symbol: parameter.symbol, unit: parameter.unit.clone(), plain, turned });
        }
        letters
    }

    fn atom(&mut self, e: Expr) -> usize {
        self.atoms.push(e);
        self.atoms.len() - 1
    }

    /// Terms from which formulas for factors are built: letters, and sines and cosines of angles.
    pub fn atoms(&self) -> &[Expr] {
        &self.atoms
    }

    /// Products of these letters that a stage tries for a factor of this unit; empty if there are too many.
    pub fn products(&self, letters: &[usize], unit: &Unit, stage: Stage) -> Vec<Powers> {
        let plain = self.plain_products(letters, unit, stage);
        let circles = self.circles(letters);
        if plain.len() * circles.len() > MOST {
            return Vec::new();
        }
        plain.iter().flat_map(|p| circles.iter().map(move |c| [p.clone(), c.clone()].concat())).collect()
    }

    /// Products of powers of these letters, without sines and cosines.
    fn plain_products(&self, letters: &[usize], unit: &Unit, stage: Stage) -> Vec<Powers> {
        let mut list: Vec<(Powers, i32, Unit)> = vec![(Vec::new(), stage.degree, Unit::default())];
        for letter in letters.iter().map(|at| &self.list[*at]) {
            let mut next = Vec::new();
            for (powers, left, so_far) in &list {
                for n in if stage.divides { -*left..=*left } else { 0..=*left } {
                    let mut powers = powers.clone();
                    if n != 0 {
                        powers.push((letter.plain, n));
                    }
                    next.push((powers, left - n.abs(), so_far.times(&letter.unit.to_power(n))));
                }
                if next.len() > MOST * MOST {
                    return Vec::new();
                }
            }
            list = next;
        }
        list.into_iter().filter(|(.., u)| !stage.by_unit || u == unit).map(|(powers, ..)| powers).collect()
    }

    /// Products of sines and cosines of angles. A sine has at most power 1: its square is 1 less that of the cosine.
    fn circles(&self, letters: &[usize]) -> Vec<Powers> {
        let mut circles: Vec<(Powers, i32)> = vec![(Vec::new(), MOST_TURNS)];
        let turned = letters.iter().filter_map(|at| self.list[*at].turned).chain(self.fixed.iter().copied());
        for [sine, cosine] in turned {
            let mut next = Vec::new();
            for (powers, left) in &circles {
                for (s, c) in (0..=TURNS[0]).flat_map(|s| (0..=TURNS[1]).map(move |c| (s, c))) {
                    if s + c <= *left {
                        let own = [(sine, s), (cosine, c)].into_iter().filter(|(_, n)| *n > 0);
                        next.push((powers.iter().copied().chain(own).collect(), left - s - c));
                    }
                }
            }
            circles = next;
        }
        circles.into_iter().map(|(powers, _)| powers).collect()
    }

    pub fn term(&self, arena: &mut Arena, powers: &Powers) -> Option<Expr> {
        let mut factors = Vec::new();
        for (at, n) in powers {
            // No atom is the literal 0, and powers are small.
            let Ok(power) = arena.pow(self.atoms[*at], *n) else { return None };
            factors.push(power);
        }
        Some(arena.product(&factors))
    }
}
