//! Values of quantities that change when printed values replace derived ones.
//!
//! Every formula is the textbook's, in quantities that a publication can name: a = dv/dt, dH/dt = I·α + ω × I·ω, F*_r =
//! Σ ∂v/∂u_r·R* + ∂ω/∂u_r·T*, L = T − V. A quantity that depends on no printed value has no value here, so that it is
//! never taken for a consequence. Invariant: all values are in q, u and u̇. A formula uses only the printed values of
//! its own operands; walks along the tree of frames are deliberately absent.
//!
//! T. R. Kane & D. A. Levinson, *Dynamics: Theory and Applications* (1985), §§ 2.7, 4.11; H. Goldstein, C. Poole & J.
//! Safko, *Classical Mechanics*, 3rd edition (2002), § 5.5.

mod sums;
mod vectors;

use super::derived_values::{arena_of, component, derived, turned};
use super::exact::Value;
use crate::algebra::Expr;
use crate::algebra::term::calculus::Differential;
use crate::geometry::Components;
use crate::mechanics::{Quantities, QuantityKind, Row, VectorName, motion_rates};
use crate::model::Model;
use rustc_hash::FxHashMap;

/// Printed values, and the values of quantities that depend on them.
pub struct Chain {
    put: Vec<Value>,
    /// Time derivative d/dt, along printed rates of coordinates if there are any.
    d_dt: Differential,
    moves_otherwise: bool,
    vectors: FxHashMap<(VectorName, usize, usize), Option<Components>>,
    scalars: FxHashMap<QuantityKind, Option<Expr>>,
}

impl Chain {
    /// Chain of the given printed values, which are in q, u and u̇.
    pub fn new(model: &Model, put: Vec<Value>) -> Self {
        let mut d_dt = motion_rates(model);
        let mut moves_otherwise = false;
        for value in &put {
            if let QuantityKind::Rate(at) = value.kind {
                d_dt.set_rate(model.coordinates[at].symbol, value.printed);
                moves_otherwise = true;
            }
        }
        Self { put, d_dt, moves_otherwise, vectors: FxHashMap::default(), scalars: FxHashMap::default() }
    }

    /// Printed value of the quantity itself; `None` if it is not printed.
    pub fn printed(&self, kind: &QuantityKind) -> Option<Expr> {
        self.put.iter().find(|value| value.kind == *kind).map(|value| value.printed)
    }

    /// Value of a quantity with the printed values put in; `None` if it depends on no printed value.
    pub fn value(&mut self, quantities: &mut Quantities<'_>, kind: &QuantityKind) -> Option<Expr> {
        if let Some(value) = self.printed(kind) {
            return Some(value);
        }
        if let Some(done) = self.scalars.get(kind) {
            return *done;
        }
        let value = self.made(quantities, kind);
        self.scalars.insert(kind.clone(), value);
        value
    }

    /// Difference of a quantity from its derived value; `None` if it depends on no printed value.
    pub fn change(&mut self, quantities: &mut Quantities<'_>, kind: &QuantityKind) -> Option<Expr> {
        let value = self.value(quantities, kind)?;
        let right = derived(quantities, kind)?;
        Some(arena_of(quantities).sub(value, right))
    }

    fn made(&mut self, quantities: &mut Quantities<'_>, kind: &QuantityKind) -> Option<Expr> {
        match *kind {
            QuantityKind::Component { vector, of, frame, axis } => {
                self.vector(quantities, vector, of, frame).map(|v| v[axis])
            }
            QuantityKind::Partial { vector, of, frame, axis, speed } => {
                self.partial(quantities, vector, of, frame, speed).map(|v| v[axis])
            }
            QuantityKind::Row(Row::InertiaForce, at) => self.inertia_force(quantities, at),
            QuantityKind::Row(Row::ActiveForce, at) => self.active_force(quantities, at),
            QuantityKind::MassMatrix(i, j) => self.mass(quantities, i, j),
            QuantityKind::Row(Row::Forcing, at) => self.forcing(quantities, at),
            QuantityKind::Energy(energy) => self.energy(quantities, energy),
            _ => None,
        }
    }

    /// Components of a vector in a frame; `None` if they depend on no printed value.
    fn vector(
        &mut self,
        quantities: &mut Quantities<'_>,
        name: VectorName,
        of: usize,
        frame: usize,
    ) -> Option<Components> {
        if let Some(done) = self.vectors.get(&(name, of, frame)) {
            return *done;
        }
        let value = match self.stated_frame(name, of, frame) {
            Some(stated) => {
                let own = self.with_printed(quantities, |axis| component(name, of, stated, axis))?;
                turned(quantities, own, stated, frame)
            }
            None => self.made_vector(quantities, name, of, frame),
        };
        self.vectors.insert((name, of, frame), value);
        value
    }

    /// Frame in which components of a vector are printed: `frame` if possible, else the first. `None` if none are
    /// printed.
    fn stated_frame(&self, name: VectorName, of: usize, frame: usize) -> Option<usize> {
        let frames = self.put.iter().filter_map(|value| match value.kind {
            QuantityKind::Component { vector, of: owner, frame, .. } if (vector, owner) == (name, of) => Some(frame),
            _ => None,
        });
        frames.min_by_key(|stated| (*stated != frame, *stated))
    }

    /// Three components of a vector, each printed or else derived.
    fn with_printed(
        &self,
        quantities: &mut Quantities<'_>,
        kind: impl Fn(usize) -> QuantityKind,
    ) -> Option<Components> {
        let mut values = [Expr::ZERO; 3];
        for (axis, value) in values.iter_mut().enumerate() {
            let kind = kind(axis);
            *value = self.printed(&kind).or_else(|| derived(quantities, &kind))?;
        }
        Some(values)
    }
}
