//! Identities: pairs of terms that are proved equal, with the engine that proved it.
//!
//! Proofs return identities as data. The code that shows or checks identities converts them to
//! text. The terms of an identity belong to the arena in which they were compared.

use super::compare::Engine;
use crate::algebra::value::zero_test::{Trial, zero_test_points};
use crate::algebra::{Arena, Expr};

/// Two terms that are proved equal for all values of their symbols at which both terms have a
/// value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Identity {
    /// Left side of the identity.
    pub left: Expr,
    /// Right side of the identity.
    pub right: Expr,
    /// Engine that proved the identity, with its error bound if it has any.
    pub engine: Engine,
}

impl Identity {
    /// Points of prime fields at which left − right is zero, so that another program can evaluate
    /// it there again. The points depend only on the terms and are the same on every machine. Empty
    /// if both sides are the same term.
    #[must_use]
    pub fn trials(&self, arena: &mut Arena) -> Vec<Trial> {
        let difference = arena.sub(self.left, self.right);
        zero_test_points(arena, difference)
    }
}
