//! Rows of the equations of motion, computed with printed values instead of derived values.

use super::consequences_of_values::ValueConsequences;
use super::derived_values::component_name;
use crate::algebra::Expr;
use crate::algebra::solve::linear::LinearForm;
use crate::algebra::term::calculus::{Differential, Gradient};
use crate::diff::equations::matched_system::MatchedSystem;
use crate::diff::equations::row_judgement::Row as Entries;
use crate::mechanics::{BalanceName, EnergyQuantity, Quantities, QuantityKind, RowName, RowQuantity, VectorName};

/// Derived row `at` of a system, computed with the printed values in `chain` instead of derived values. The row has one
/// coefficient for each unknown, then the right-hand side. `None` if it depends on no printed value.
pub fn row_changed_by_printed_values(
    quantities: &mut Quantities<'_>,
    chain: &mut ValueConsequences,
    table: &MatchedSystem,
    at: usize,
) -> Option<Entries> {
    if let Some(stated) = row_changed_by_printed_entries(chain, table, at) {
        return Some(stated);
    }
    let change = match table.names[at] {
        RowName::Speed(speed) => kane_row_change(quantities, chain, speed),
        RowName::Coordinate(coordinate) => lagrange_row_change(quantities, chain, coordinate),
        RowName::Balance(name) => balance_row_change(quantities, chain, name),
        _ => None,
    }?;
    let arena = &mut quantities.derivations.kinematics.arena;
    let Ok((coefficients, rest)) = LinearForm::new(&table.unknowns).coefficients(arena, change) else { return None };
    let mut row = table.derived[at].clone();
    for (entry, coefficient) in row.iter_mut().zip(coefficients) {
        *entry = arena.add(*entry, coefficient);
    }
    let right = row.len() - 1;
    row[right] = arena.sub(row[right], rest);
    Some(row)
}

/// Derived row `at`, in which printed entries such as `M[1,2]`, `f[1]`, `E[1,2]` or `A[1]` replace derived ones. `None`
/// if no entry of the row is printed as a quantity.
fn row_changed_by_printed_entries(chain: &ValueConsequences, table: &MatchedSystem, at: usize) -> Option<Entries> {
    let kind = |column: usize| match table.names[at] {
        RowName::Speed(row) if column < table.unknowns.len() => Some(QuantityKind::MassMatrix(row, column)),
        RowName::Speed(row) => Some(QuantityKind::Row(RowQuantity::Forcing, row)),
        RowName::Coordinate(row) if column < table.unknowns.len() => Some(QuantityKind::LagrangeMatrix(row, column)),
        RowName::Coordinate(row) => Some(QuantityKind::Row(RowQuantity::LagrangeForcing, row)),
        _ => None,
    };
    let printed: Vec<Option<Expr>> = (0..table.derived[at].len()).map(|column| chain.printed(&kind(column)?)).collect();
    let is_stated = printed.iter().any(Option::is_some);
    is_stated.then(|| printed.iter().zip(&table.derived[at]).map(|(p, d)| p.unwrap_or(*d)).collect())
}

/// Change of Kane's row M u̇ − f = −F* − F for the speed with index `speed`, when printed values replace derived
/// values. Returns `None` if the row depends on no printed value.
fn kane_row_change(quantities: &mut Quantities<'_>, chain: &mut ValueConsequences, speed: usize) -> Option<Expr> {
    let inertia = chain.change_of_quantity(quantities, &QuantityKind::Row(RowQuantity::InertiaForce, speed));
    let active = chain.change_of_quantity(quantities, &QuantityKind::Row(RowQuantity::ActiveForce, speed));
    if inertia.is_none() && active.is_none() {
        return None;
    }
    let arena = &mut quantities.derivations.kinematics.arena;
    let total = arena.sum(&inertia.into_iter().chain(active).collect::<Vec<_>>());
    Some(arena.neg(total))
}

/// Change of Lagrange's row d/dt ∂L/∂q̇ − ∂L/∂q for a coordinate, caused by the error of the printed L. Returns `None`
/// if L depends on no printed value. Also `None` unless the model has as many speeds as coordinates and no motion
/// constraints, since only then T and V in u can be written in q̇.
fn lagrange_row_change(
    quantities: &mut Quantities<'_>,
    chain: &mut ValueConsequences,
    coordinate: usize,
) -> Option<Expr> {
    let model = quantities.model;
    if model.speeds.len() != model.coordinates.len() || !model.motion_constraints.is_empty() {
        return None;
    }
    let off = chain.change_of_quantity(quantities, &QuantityKind::Energy(EnergyQuantity::Lagrangian))?;
    let off = quantities.in_rates(off);
    let c = &model.coordinates[coordinate];
    let mut moving: Vec<_> = model.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
    moving.extend(model.coordinates.iter().map(|c| (c.rate, c.second_rate)));
    let arena = &mut quantities.derivations.kinematics.arena;
    let mut slopes = [Expr::ZERO; 2];
    for (at, slope) in Gradient::new(&[c.symbol, c.rate]).apply(arena, off).iter() {
        slopes[*at] = *slope;
    }
    let momentum_rate = Differential::along(&moving).apply(arena, slopes[1]);
    Some(arena.sub(momentum_rate, slopes[0]))
}

/// Change of a Newton–Euler balance m a − F or dH/dt − M, when printed values replace derived values. Returns `None` if
/// the balance depends on no printed value.
fn balance_row_change(
    quantities: &mut Quantities<'_>,
    chain: &mut ValueConsequences,
    name: BalanceName,
) -> Option<Expr> {
    let BalanceName { body, moments, frame, axis } = name;
    let (rate, load) = if moments {
        (VectorName::MomentumRate, VectorName::Moment)
    } else {
        (VectorName::LinearMomentumRate, VectorName::Force)
    };
    let rate = chain.change_of_quantity(quantities, &component_name(rate, body, frame, axis));
    let load = chain.change_of_quantity(quantities, &component_name(load, body, frame, axis));
    if rate.is_none() && load.is_none() {
        return None;
    }
    let arena = &mut quantities.derivations.kinematics.arena;
    Some(arena.sub(rate.unwrap_or(Expr::ZERO), load.unwrap_or(Expr::ZERO)))
}
