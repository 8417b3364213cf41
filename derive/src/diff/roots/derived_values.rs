//! Derived values of named quantities as functions of q, u and u̇, and arithmetic of vectors with three components.

use crate::algebra::{Arena, Expr};
use crate::geometry::{Components, apply_tensor};
use crate::mechanics::{Quantities, Quantity, QuantityKind, VectorName};

/// Kind of quantity for the component along `axis` (0 to 2) of a vector in `frame`. `of` is the index of the vector's
/// point, frame or body.
pub fn component_name(vector: VectorName, of: usize, frame: usize, axis: usize) -> QuantityKind {
    QuantityKind::Component { vector, of, frame, axis }
}

/// Derived value of a quantity as a function of q, u and u̇; `None` if the quantity cannot be
/// derived.
pub fn derived_value(quantities: &mut Quantities<'_>, kind: &QuantityKind) -> Option<Expr> {
    let quantity = Quantity::new(kind.clone(), quantities.model);
    let Ok(value) = quantities.value(&quantity) else { return None };
    Some(quantities.in_speeds(value))
}

/// Derived value of a quantity plus the given changes; `None` if there are no changes.
pub fn derived_value_with_changes(
    quantities: &mut Quantities<'_>,
    kind: &QuantityKind,
    changes: &[Expr],
) -> Option<Expr> {
    if changes.is_empty() {
        return None;
    }
    let right = derived_value(quantities, kind)?;
    Some(derived_values_arena(quantities).sum(&[&[right], changes].concat()))
}

/// Three components of a derived vector in `frame`, as functions of q, u and u̇; `None` if a
/// component cannot be derived.
pub fn derived_value_components(
    quantities: &mut Quantities<'_>,
    name: VectorName,
    of: usize,
    frame: usize,
) -> Option<Components> {
    let mut values = [Expr::ZERO; 3];
    for (axis, value) in values.iter_mut().enumerate() {
        *value = derived_value(quantities, &component_name(name, of, frame, axis))?;
    }
    Some(values)
}

/// Components of a vector in frame `to`, from its components `v` in frame `from`; `None` if the
/// rotation cannot be derived.
pub fn derived_components_in_frame(
    quantities: &mut Quantities<'_>,
    v: Components,
    from: usize,
    to: usize,
) -> Option<Components> {
    if from == to {
        return Some(v);
    }
    let mut rotation = [[Expr::ZERO; 3]; 3];
    for (at, value) in rotation.iter_mut().flatten().enumerate() {
        *value = derived_value(quantities, &QuantityKind::Rotation { from, to, entry: (at / 3, at % 3) })?;
    }
    Some(apply_tensor(derived_values_arena(quantities), &rotation, &v))
}

/// Arena that holds the terms of all derived values.
pub fn derived_values_arena<'a>(quantities: &'a mut Quantities<'_>) -> &'a mut Arena {
    &mut quantities.derivations.kinematics.arena
}

/// Sum of two vectors, a + b, by components.
pub fn sum(arena: &mut Arena, a: &Components, b: &Components) -> Components {
    [0, 1, 2].map(|at| arena.add(a[at], b[at]))
}

/// Difference of two vectors, a − b, by components.
pub fn difference(arena: &mut Arena, a: &Components, b: &Components) -> Components {
    [0, 1, 2].map(|at| arena.sub(a[at], b[at]))
}

/// Scalar product of two vectors, a · b.
pub fn dot(arena: &mut Arena, a: &Components, b: &Components) -> Expr {
    let products = [0, 1, 2].map(|at| arena.mul(a[at], b[at]));
    arena.sum(&products)
}
