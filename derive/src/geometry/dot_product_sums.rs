//! Weighted sums of dot products of vectors, collected before they are expanded. Mass matrices are
//! built from them.

use super::frames::Frames;
use super::vector::{Part, Vector};
use crate::algebra::{Arena, Expr};
use rustc_hash::FxHashMap;

/// Weighted sum Σ weight · (a · b) of dot products. It becomes one term after all products are
/// collected.
///
/// Products of equal components are collected first. If several bodies of a chain have equal
/// velocity parts, their masses add up to one factor of one dot product: Σ m_k (a · b) = (Σ m_k) (a
/// · b). So a sum over n bodies has n terms, not n².
#[derive(Default)]
pub struct Dots {
    /// Index in `list` of each pair of vector parts.
    places: FxHashMap<(Part, Part), usize>,
    /// Pairs of vector parts in the order of first use, each with its weights.
    list: Vec<((Part, Part), Vec<Expr>)>,
}

impl Dots {
    /// Adds weight · (a · b) to the sum.
    pub fn add(&mut self, weight: Expr, a: &Vector, b: &Vector) {
        for x in &a.parts {
            for y in &b.parts {
                let place = *self.places.entry((*x, *y)).or_insert(self.list.len());
                match self.list.get_mut(place) {
                    Some((_, weights)) => weights.push(weight),
                    None => self.list.push(((*x, *y), vec![weight])),
                }
            }
        }
    }

    /// Sum of the collected products, as one term of the arena.
    pub fn sum(&self, arena: &mut Arena, frames: &mut Frames) -> Expr {
        let mut terms = Vec::with_capacity(self.list.len());
        for ((a, b), weights) in &self.list {
            let product = frames.dot_of_parts(arena, *a, *b);
            if product != Expr::ZERO {
                let mut weight = arena.sum(weights);
                if frames.carries {
                    weight = arena.name(weight, "mass");
                }
                terms.push(arena.mul(weight, product));
            }
        }
        arena.sum(&terms)
    }
}

/// Symmetric matrix whose entries are weighted sums of dot products, such as a mass matrix. Only
/// the upper triangle is collected.
pub struct SymmetricDots {
    /// Upper triangle of the matrix: row r has the sums of columns r, r + 1, ….
    rows: Vec<Vec<Dots>>,
}

impl SymmetricDots {
    /// Creates an n × n matrix of empty sums.
    #[must_use]
    pub fn new(n: usize) -> Self {
        Self { rows: (0..n).map(|r| (r..n).map(|_| Dots::default()).collect()).collect() }
    }

    /// Adds weight · (a_r · b_s) to entry (r, s), for each indexed vector a_r and b_s with r ≤ s.
    pub fn add(&mut self, weight: Expr, a: &[(usize, Vector)], b: &[(usize, Vector)]) {
        for (r, x) in a {
            for (s, y) in b.iter().filter(|(s, _)| s >= r) {
                self.rows[*r][s - r].add(weight, x, y);
            }
        }
    }

    /// Full n × n matrix of the collected sums; the lower triangle mirrors the upper triangle.
    pub fn sum(&self, arena: &mut Arena, frames: &mut Frames) -> Vec<Vec<Expr>> {
        let n = self.rows.len();
        let mut matrix = vec![vec![Expr::ZERO; n]; n];
        for (r, row) in self.rows.iter().enumerate() {
            for (above, dots) in row.iter().enumerate() {
                let entry = dots.sum(arena, frames);
                matrix[r][r + above] = entry;
                matrix[r + above][r] = entry;
            }
        }
        matrix
    }
}
