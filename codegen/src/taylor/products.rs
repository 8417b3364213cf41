//! Products of many factors as products and quotients of two, shared between the products that have them in common.

use rustc_hash::FxHashMap;
use tripos_derive::algebra::Expr;

/// A factor that changes in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Base {
    /// A single term, not a pair.
    Term(Expr),
    /// The pair at this place of [`Pairs`].
    Pair(usize),
}

/// A factor, or what is divided by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Atom {
    /// The factor or divisor itself.
    pub base: Base,
    /// True if it is a divisor.
    pub inverse: bool,
}

/// Powers up to here are written out factor by factor, so that any factor can be shared; higher ones go by squares.
const WRITTEN: u32 = 3;

/// Pairs of atoms, each once.
#[derive(Default)]
pub struct Pairs {
    list: Vec<[Atom; 2]>,
    place: FxHashMap<[Atom; 2], usize>,
}

impl Pairs {
    /// The two atoms of a pair.
    pub fn atoms(&self, place: usize) -> [Atom; 2] {
        self.list[place]
    }

    /// Two atoms joined: a quotient if one of them is divided by, and itself divided by if both are.
    pub fn joined(&mut self, a: Atom, b: Atom) -> Atom {
        let inverse = a.inverse && b.inverse;
        let [mut a, mut b] = [a, b].map(|atom| Atom { inverse: atom.inverse && !inverse, ..atom });
        // What is divided by comes second; otherwise the order does not matter.
        if (b.inverse, b.base) < (a.inverse, a.base) {
            std::mem::swap(&mut a, &mut b);
        }
        let next = self.list.len();
        let place = *self.place.entry([a, b]).or_insert(next);
        if place == next {
            self.list.push([a, b]);
        }
        Atom { base: Base::Pair(place), inverse }
    }

    /// The atoms of base^n.
    pub fn power(&mut self, base: Expr, n: i32) -> Vec<Atom> {
        let mut atom = Atom { base: Base::Term(base), inverse: n < 0 };
        let mut left = n.unsigned_abs();
        if left <= WRITTEN {
            return vec![atom; left as usize];
        }
        let mut list = Vec::new();
        while left > 0 {
            if left & 1 == 1 {
                list.push(atom);
            }
            left >>= 1;
            if left > 0 {
                atom = self.joined(atom, atom);
            }
        }
        list
    }

    /// Joins, again and again, the pair that most products have, while two or more have it.
    pub fn share(&mut self, products: &mut [Vec<Atom>]) {
        loop {
            let mut counts: FxHashMap<[Atom; 2], usize> = FxHashMap::default();
            let mut order: Vec<[Atom; 2]> = Vec::new();
            for product in products.iter() {
                for pair in distinct_pairs(product) {
                    let count = counts.entry(pair).or_insert(0);
                    if *count == 0 {
                        order.push(pair);
                    }
                    *count += 1;
                }
            }
            // The first of those that occur most often.
            let best = order.into_iter().rev().max_by_key(|pair| counts[pair]);
            let Some([a, b]) = best.filter(|pair| counts[pair] > 1) else { return };
            for product in products.iter_mut() {
                while distinct_pairs(product).contains(&[a, b]) {
                    remove(product, a);
                    remove(product, b);
                    product.push(self.joined(a, b));
                    product.sort_unstable();
                }
            }
        }
    }
}

fn distinct_pairs(product: &[Atom]) -> Vec<[Atom; 2]> {
    let mut sorted = product.to_vec();
    sorted.sort_unstable();
    let mut pairs: Vec<[Atom; 2]> = (0..sorted.len())
        .flat_map(|i| (i + 1..sorted.len()).map(move |j| (i, j)))
        .map(|(i, j)| [sorted[i], sorted[j]])
        .collect();
    pairs.dedup();
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

fn remove(product: &mut Vec<Atom>, atom: Atom) {
    if let Some(at) = product.iter().position(|other| *other == atom) {
        product.remove(at);
    }
}
