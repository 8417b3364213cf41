//! Products of many factors, computed as products and quotients of two factors each. These are shared between all
//! products that contain them.

use rustc_hash::FxHashMap;
use tripos_derive::algebra::Expr;

/// Base of a factor that changes in time: a single term, or a pair of factors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum FactorBase {
    /// Single term that is not a pair of factors.
    Term(Expr),
    /// Pair of factors with this index in [`FactorPairs`].
    Pair(usize),
}

/// Factor or divisor of a product; it changes in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ProductFactor {
    /// Term or pair of factors that multiplies or divides.
    pub base: FactorBase,
    /// True for a divisor, false for a factor.
    pub inverse: bool,
}

/// Highest power that is written factor by factor, so that products can share each factor. Higher powers are computed
/// by repeated squaring.
const WRITTEN: u32 = 3;

/// Table of the distinct pairs of factors, each with an index.
#[derive(Default)]
pub struct FactorPairs {
    /// The two factors of each pair, by the pair's index.
    list: Vec<[ProductFactor; 2]>,
    /// Index of each pair in `list`, by its two factors.
    place: FxHashMap<[ProductFactor; 2], usize>,
}

impl FactorPairs {
    /// Returns the two factors of the pair with the index `place`.
    pub fn atoms(&self, place: usize) -> [ProductFactor; 2] {
        self.list[place]
    }

    /// Joins two factors into a pair, and returns the pair as a factor. The pair is a quotient if one of the two is a
    /// divisor. If both are divisors, their product is returned as a divisor.
    pub fn join_factors(&mut self, a: ProductFactor, b: ProductFactor) -> ProductFactor {
        let inverse = a.inverse && b.inverse;
        let [mut a, mut b] = [a, b].map(|atom| ProductFactor { inverse: atom.inverse && !inverse, ..atom });
        // A divisor is the second atom of a pair; otherwise the order does not matter.
        if (b.inverse, b.base) < (a.inverse, a.base) {
            std::mem::swap(&mut a, &mut b);
        }
        let next = self.list.len();
        let place = *self.place.entry([a, b]).or_insert(next);
        if place == next {
            self.list.push([a, b]);
        }
        ProductFactor { base: FactorBase::Pair(place), inverse }
    }

    /// Returns factors whose product is base^n. High powers are pairs that result from repeated squaring.
    pub fn power(&mut self, base: Expr, n: i32) -> Vec<ProductFactor> {
        let mut atom = ProductFactor { base: FactorBase::Term(base), inverse: n < 0 };
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
                atom = self.join_factors(atom, atom);
            }
        }
        list
    }

    /// Joins the pair of factors that occurs in the most products, again and again, until no pair occurs in two
    /// products.
    pub fn share(&mut self, products: &mut [Vec<ProductFactor>]) {
        loop {
            let mut counts: FxHashMap<[ProductFactor; 2], usize> = FxHashMap::default();
            let mut order: Vec<[ProductFactor; 2]> = Vec::new();
            for product in products.iter() {
                for pair in distinct_pairs(product) {
                    let count = counts.entry(pair).or_insert(0);
                    if *count == 0 {
                        order.push(pair);
                    }
                    *count += 1;
                }
            }
            // Among the most frequent pairs, the first one is joined.
            let best = order.into_iter().rev().max_by_key(|pair| counts[pair]);
            let Some([a, b]) = best.filter(|pair| counts[pair] > 1) else { return };
            for product in products.iter_mut() {
                while distinct_pairs(product).contains(&[a, b]) {
                    remove(product, a);
                    remove(product, b);
                    product.push(self.join_factors(a, b));
                    product.sort_unstable();
                }
            }
        }
    }
}

/// Returns the distinct pairs of factors in a product, sorted.
fn distinct_pairs(product: &[ProductFactor]) -> Vec<[ProductFactor; 2]> {
    let mut sorted = product.to_vec();
    sorted.sort_unstable();
    let mut pairs: Vec<[ProductFactor; 2]> = (0..sorted.len())
        .flat_map(|i| (i + 1..sorted.len()).map(move |j| (i, j)))
        .map(|(i, j)| [sorted[i], sorted[j]])
        .collect();
    pairs.dedup();
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

/// Removes one occurrence of a factor from a product.
fn remove(product: &mut Vec<ProductFactor>, atom: ProductFactor) {
    if let Some(at) = product.iter().position(|other| *other == atom) {
        product.remove(at);
    }
}
