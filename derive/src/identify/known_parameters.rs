//! Known parameters in the columns of a regressor, and the products of their powers that a factor
//! may contain.

use crate::algebra::{Arena, Expr, Function, Node};
use crate::mechanics::Column;
use crate::model::{Model, Unit};
use rustc_hash::FxHashSet;

/// Largest number of products that a stage of the search may try for a factor.
const MOST: usize = 240;
/// Stages of the search for a factor, in the order of the search. A model file may state lengths as
/// plain numbers, so the last stages ignore units.
pub const STAGES: [FactorSearchStage; 6] = [
    FactorSearchStage { degree: 1, divides: false, by_unit: true },
    FactorSearchStage { degree: 2, divides: false, by_unit: true },
    FactorSearchStage { degree: 4, divides: false, by_unit: true },
    FactorSearchStage { degree: 4, divides: true, by_unit: true },
    FactorSearchStage { degree: 2, divides: false, by_unit: false },
    FactorSearchStage { degree: 2, divides: true, by_unit: false },
];
/// Largest number of constant angles, given as numbers, whose sines and cosines formulas may
/// contain.
const MOST_FIXED: usize = 2;
/// Largest power of the sine, then of the cosine, of a single angle in a product.
const TURNS: [i32; 2] = [1, 2];
/// Largest total power of the sines and cosines of all angles in a product.
const MOST_TURNS: i32 = 4;

/// Stage of the search for a factor: the kind of products of known parameters that it tries.
#[derive(Clone, Copy)]
pub struct FactorSearchStage {
    /// Largest total degree of a tried product in the known parameters.
    degree: i32,
    /// True if a product may divide by known parameters; false if no exponent is negative.
    divides: bool,
    /// True if only products that have the unit of the wanted factor are tried; false if units are
    /// ignored.
    by_unit: bool,
}

/// Parameter whose value counts as known in the search for factors.
pub struct KnownParameter {
    /// Symbol of the known parameter.
    pub symbol: Expr,
    /// Unit of the known parameter.
    unit: Unit,
    /// Index of the parameter in the list of atoms.
    plain: usize,
    /// Indices in the list of atoms of the sine and the cosine of the parameter; `None` if it
    /// occurs in no function.
    turned: Option<[usize; 2]>,
}

/// Known parameters in the columns of a regressor, with the atoms of which formulas for factors
/// consist.
pub struct KnownParameters {
    /// Known parameters that occur in the columns, in the order of the model.
    pub list: Vec<KnownParameter>,
    /// Atoms of formulas: parameters, and sines and cosines of angles.
    atoms: Vec<Expr>,
    /// Indices, in the list of atoms, of the sine and the cosine of each constant angle that is
    /// given as a number.
    fixed: Vec<[usize; 2]>,
    /// True if square roots occur in the columns. Then coefficients of formulas may be a + b √n.
    pub has_roots: bool,
    /// Symbols that change during a motion: coordinates, speeds, accelerations and inputs.
    pub moving: FxHashSet<Expr>,
}

/// Product of powers of atoms: pairs of the index of an atom and its exponent.
pub type PowerProduct = Vec<(usize, i32)>;

impl KnownParameters {
    /// Collects the known parameters and the atoms in columns of a regressor.
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
            letters.list.push(KnownParameter { symbol: parameter.symbol, unit: parameter.unit.clone(), plain, turned });
        }
        letters
    }

    /// Adds a term to the list of atoms, and returns its index.
    fn atom(&mut self, e: Expr) -> usize {
        self.atoms.push(e);
        self.atoms.len() - 1
    }

    /// Atoms of formulas for factors: known parameters, and sines and cosines of angles.
    pub fn atoms(&self) -> &[Expr] {
        &self.atoms
    }

    /// Lists the products of powers of the given parameters that a stage tries for a factor with
    /// the unit `unit`. Empty if there would be more than 240 products.
    pub fn products(&self, letters: &[usize], unit: &Unit, stage: FactorSearchStage) -> Vec<PowerProduct> {
        let plain = self.plain_products(letters, unit, stage);
        let circles = self.sine_cosine_products(letters);
        if plain.len() * circles.len() > MOST {
            return Vec::new();
        }
        plain.iter().flat_map(|p| circles.iter().map(move |c| [p.clone(), c.clone()].concat())).collect()
    }

    /// Lists the products of powers of the given parameters, without sines and cosines. Empty if
    /// there are too many.
    fn plain_products(&self, letters: &[usize], unit: &Unit, stage: FactorSearchStage) -> Vec<PowerProduct> {
        let mut list: Vec<(PowerProduct, i32, Unit)> = vec![(Vec::new(), stage.degree, Unit::default())];
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

    /// Lists the products of powers of sines and cosines of angles. A sine has the power 1 at most,
    /// because sin² = 1 − cos².
    fn sine_cosine_products(&self, letters: &[usize]) -> Vec<PowerProduct> {
        let mut circles: Vec<(PowerProduct, i32)> = vec![(Vec::new(), MOST_TURNS)];
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

    /// Builds the term of a product of powers of atoms; `None` if a power cannot be built.
    pub fn term(&self, arena: &mut Arena, powers: &PowerProduct) -> Option<Expr> {
        let mut factors = Vec::new();
        for (at, n) in powers {
            // No atom is the literal 0, and powers are small.
            let Ok(power) = arena.pow(self.atoms[*at], *n) else { return None };
            factors.push(power);
        }
        Some(arena.product(&factors))
    }
}
