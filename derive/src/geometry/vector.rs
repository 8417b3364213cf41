//! Vectors with components in several frames at once.
//!
//! A vector keeps each contribution in the frame where its formula is short. Only dot products
//! transform components.

use super::components::Components;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::{Differential, Gradient, Substitution};
use crate::algebra::{Arena, Expr};
use std::collections::BTreeMap;

/// Part of a vector in one frame, as (index of the frame, components in that frame).
pub type Part = (usize, Components);

/// Vector as a sum of parts, each with components in its own frame. Parts are sorted by the index
/// of their frame, and no part is zero.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Vector {
    /// Parts of the vector, as (index of the frame, components in that frame). Empty for the zero
    /// vector.
    pub parts: Vec<Part>,
}

/// Components of the zero vector.
const NOTHING: Components = [Expr::ZERO; 3];

impl Vector {
    /// Creates a vector from its components in one frame.
    #[must_use]
    pub fn in_frame(frame: usize, components: Components) -> Self {
        let parts = if components == NOTHING { Vec::new() } else { vec![(frame, components)] };
        Self { parts }
    }

    /// True if the vector has no parts: all its components are the literal 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.parts.is_empty()
    }

    /// Sum of two vectors.
    #[must_use]
    pub fn add(&self, arena: &mut Arena, other: &Self) -> Self {
        let mut parts = self.parts.clone();
        for (frame, components) in &other.parts {
            match parts.iter_mut().find(|(f, _)| f == frame) {
                Some((_, mine)) => {
                    for (sum, term) in mine.iter_mut().zip(components) {
                        *sum = arena.add(*sum, *term);
                    }
                }
                None => parts.push((*frame, *components)),
            }
        }
        parts.retain(|(_, components)| *components != NOTHING);
        parts.sort_by_key(|(frame, _)| *frame);
        Self { parts }
    }

    /// Applies the function `f` to every component of the vector. Parts that become zero are
    /// dropped.
    #[must_use]
    pub fn map(&self, mut f: impl FnMut(Expr) -> Expr) -> Self {
        let mut parts: Vec<_> = self.parts.iter().map(|(frame, c)| (*frame, c.map(&mut f))).collect();
        parts.retain(|(_, components)| *components != NOTHING);
        Self { parts }
    }

    /// Product of the vector with a scalar k.
    #[must_use]
    pub fn scale(&self, arena: &mut Arena, k: Expr) -> Self {
        self.map(|e| arena.mul(k, e))
    }

    /// Opposite vector −v.
    #[must_use]
    pub fn neg(&self, arena: &mut Arena) -> Self {
        self.map(|e| arena.neg(e))
    }

    /// Vector with symbols replaced by other terms in every component.
    #[must_use]
    pub fn substitute(&self, arena: &mut Arena, substitution: &mut Substitution) -> Self {
        self.map(|e| substitution.apply(arena, e))
    }

    /// Derivative of every component, with basis vectors held fixed. For d/dt, each part is
    /// differentiated as observed from its own frame.
    #[must_use]
    pub fn differentiate(&self, arena: &mut Arena, along: &mut Differential) -> Self {
        self.map(|e| along.apply(arena, e))
    }

    /// Derivatives of the vector with respect to each variable that occurs in it, as pairs (index
    /// of the variable, derivative) in ascending order. Basis vectors are held fixed. For a
    /// velocity and generalized speeds, these are the partial velocities.
    #[must_use]
    pub fn partial_derivatives(&self, arena: &mut Arena, gradient: &mut Gradient) -> Vec<(usize, Self)> {
        let mut by_variable: BTreeMap<usize, Self> = BTreeMap::new();
        for (frame, components) in &self.parts {
            for (axis, component) in components.iter().enumerate() {
                for (at, slope) in gradient.apply(arena, *component).iter() {
                    let slopes = by_variable.entry(*at).or_default();
                    if slopes.parts.last().is_none_or(|(last, _)| last != frame) {
                        slopes.parts.push((*frame, NOTHING));
                    }
                    if let Some((_, part)) = slopes.parts.last_mut() {
                        part[axis] = *slope;
                    }
                }
            }
        }
        by_variable.into_iter().collect()
    }

    /// Vector with the formula of every component simplified.
    #[must_use]
    pub fn simplify(&self, arena: &mut Arena, simplifier: &mut Simplifier) -> Self {
        self.map(|e| simplifier.simplify(arena, e))
    }
}
