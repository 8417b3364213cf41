//! Values that quantities get when printed values replace derived values in textbook formulas.
//!
//! The formulas are those of textbooks, in quantities that a publication can name: a = dv/dt, dH/dt = I·α + ω × I·ω,
//! F*_r = Σ ∂v/∂u_r·R* + ∂ω/∂u_r·T*, L = T − V. A quantity that depends on no printed value has no value here, so that
//! it never counts as a consequence. Invariant: all values are in q, u and u̇. A formula uses only the printed values
//! of its own operands. The kinematics of the tree of frames is deliberately not recomputed.
//!
//! T. R. Kane & D. A. Levinson, *Dynamics: Theory and Applications* (1985), §§ 2.7, 4.11; H. Goldstein, C. Poole & J.
//! Safko, *Classical Mechanics*, 3rd edition (2002), § 5.5.

mod force_and_energy_sums;
mod vectors;

use super::derived_values::{component_name, derived_components_in_frame, derived_value, derived_values_arena};
use super::exact_comparison::WrongValue;
use crate::algebra::Expr;
use crate::algebra::term::calculus::Differential;
use crate::geometry::Components;
use crate::mechanics::{Quantities, QuantityKind, RowQuantity, VectorName, kinematic_rates};
use crate::model::Model;
use rustc_hash::FxHashMap;

/// Printed values of quantities, with the values of all quantities that follow from them.
pub struct ValueConsequences {
    /// Printed values that replace derived values.
    put: Vec<WrongValue>,
    /// Time derivative d/dt. It uses the printed rates q̇ if the publication prints any.
    d_dt: Differential,
    /// True if the printed values contain rates q̇ of coordinates, so that d/dt differs from the derived one.
    moves_otherwise: bool,
    /// Computed vectors, by (vector, index of its point, frame or body, frame of the components). `None` if they depend
    /// on no printed value.
    vectors: FxHashMap<(VectorName, usize, usize), Option<Components>>,
    /// Computed scalars; `None` if they do not depend on a printed value.
    scalars: FxHashMap<QuantityKind, Option<Expr>>,
}

impl ValueConsequences {
    /// Creates the consequences of the printed values `put`, which are functions of q, u and u̇. Nothing is computed
    /// yet.
    pub fn new(model: &Model, put: Vec<WrongValue>) -> Self {
        let mut d_dt = kinematic_rates(model);
        let mut moves_otherwise = false;
        for value in &put {
            if let QuantityKind::Rate(at) = value.kind {
                d_dt.set_rate(model.coordinates[at].symbol, value.printed);
                moves_otherwise = true;
            }
        }
        Self { put, d_dt, moves_otherwise, vectors: FxHashMap::default(), scalars: FxHashMap::default() }
    }

    /// Value that the publication prints for the quantity `kind`; `None` if there is none.
    pub fn printed(&self, kind: &QuantityKind) -> Option<Expr> {
        self.put.iter().find(|value| value.kind == *kind).map(|value| value.printed)
    }

    /// Value of a quantity, computed with printed values instead of derived values. `None` if the quantity depends on
    /// no printed value.
    pub fn value(&mut self, quantities: &mut Quantities<'_>, kind: &QuantityKind) -> Option<Expr> {
        if let Some(value) = self.printed(kind) {
            return Some(value);
        }
        if let Some(done) = self.scalars.get(kind) {
            return *done;
        }
        let value = self.compute_quantity(quantities, kind);
        self.scalars.insert(kind.clone(), value);
        value
    }

    /// Value of a quantity, computed with printed values, minus its derived value. `None` if the quantity depends on no
    /// printed value.
    pub fn change_of_quantity(&mut self, quantities: &mut Quantities<'_>, kind: &QuantityKind) -> Option<Expr> {
        let value = self.value(quantities, kind)?;
        let right = derived_value(quantities, kind)?;
        Some(derived_values_arena(quantities).sub(value, right))
    }

    /// Computes a quantity from the printed values of its operands; `None` if it depends on no printed value.
    fn compute_quantity(&mut self, quantities: &mut Quantities<'_>, kind: &QuantityKind) -> Option<Expr> {
        match *kind {
            QuantityKind::Component { vector, of, frame, axis } => {
                self.vector(quantities, vector, of, frame).map(|v| v[axis])
            }
            QuantityKind::Partial { vector, of, frame, axis, speed } => {
                self.partial_velocity(quantities, vector, of, frame, speed).map(|v| v[axis])
            }
            QuantityKind::Row(RowQuantity::InertiaForce, at) => self.inertia_force(quantities, at),
            QuantityKind::Row(RowQuantity::ActiveForce, at) => self.active_force(quantities, at),
            QuantityKind::MassMatrix(i, j) => self.mass_matrix_entry(quantities, i, j),
            QuantityKind::Row(RowQuantity::Forcing, at) => self.forcing_entry(quantities, at),
            QuantityKind::Energy(energy) => self.energy_of_bodies(quantities, energy),
            _ => None,
        }
    }

    /// Components of a vector in `frame`, computed with printed values. `None` if they depend on no printed value. `of`
    /// is the index of the vector's point, frame or body.
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
        let value = match self.frame_of_printed_components(name, of, frame) {
            Some(stated) => {
                let own =
                    self.components_printed_or_derived(quantities, |axis| component_name(name, of, stated, axis))?;
                derived_components_in_frame(quantities, own, stated, frame)
            }
            None => self.compute_vector(quantities, name, of, frame),
        };
        self.vectors.insert((name, of, frame), value);
        value
    }

    /// Frame in which the publication prints components of the vector `name`, whose point or body is `of`. It is
    /// `frame` if components are printed there, else the frame with the lowest index. `None` if no component of the
    /// vector is printed.
    fn frame_of_printed_components(&self, name: VectorName, of: usize, frame: usize) -> Option<usize> {
        let frames = self.put.iter().filter_map(|value| match value.kind {
            QuantityKind::Component { vector, of: owner, frame, .. } if (vector, owner) == (name, of) => Some(frame),
            _ => None,
        });
        frames.min_by_key(|stated| (*stated != frame, *stated))
    }

    /// Three components of a vector. Each is the printed component if there is one, else the derived component. Returns
    /// `None` if a needed component cannot be derived.
    fn components_printed_or_derived(
        &self,
        quantities: &mut Quantities<'_>,
        kind: impl Fn(usize) -> QuantityKind,
    ) -> Option<Components> {
        let mut values = [Expr::ZERO; 3];
        for (axis, value) in values.iter_mut().enumerate() {
            let kind = kind(axis);
            *value = self.printed(&kind).or_else(|| derived_value(quantities, &kind))?;
        }
        Some(values)
    }
}
