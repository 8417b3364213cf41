//! Symmetries of the flow of a mechanism: vector fields ζ(x) with [ζ, f] = 0. A shift along ζ takes solutions to
//! solutions.
//!
//! A field ξ(q) on the coordinates also changes the speeds. A shift by ε changes u = J q̇ + d to u + ε η with η =
//! ∂u/∂q ξ + J ξ̇. A symmetry need not conserve a momentum: a rolling wheel may be shifted on its plane, although the
//! momenta along the plane change.

use super::Flow;
use crate::algebra::term::calculus::Differential;
use crate::algebra::value::tape::Tape;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::mechanics::{Kinematics, rates_to_speeds};
use crate::model::Model;
use crate::prove::{IntegralKind, Pivot, VectorField, rigid_motions};
use nalgebra::DMatrix;
use tripos_linear::SingularValues;

/// Symmetry of a flow: a vector field on the states that commutes with the flow and keeps the loops
/// closed.
#[derive(Clone, Debug)]
pub struct Symmetry {
    /// Kind of the motion that the symmetry gives the mechanism, such as a translation.
    pub kind: IntegralKind,
    /// Components of the vector field, one for each state, as terms in parameters and states.
    pub along: Vec<Expr>,
}

impl Symmetry {
    /// Description in words of the motion along the symmetry.
    #[must_use]
    pub fn words(&self, model: &Model) -> String {
        self.kind.motion(model)
    }
}

/// Shift of time, as a candidate for a symmetry. It is a symmetry if the equations do not depend on time, such as
/// with a drive at a constant rate. `None` if time is not a coordinate of the model.
pub(super) fn time_symmetry_candidate(model: &Model) -> Option<VectorField> {
    let time = model.time()?;
    let unit = |at| if at == time { Expr::ONE } else { Expr::ZERO };
    Some(VectorField { kind: IntegralKind::Coordinate(time), xi: (0..model.coordinates.len()).map(unit).collect() })
}

/// Vector fields on the coordinates that may be symmetries. They are the fields along each coordinate except time,
/// and the rigid motions of the mechanism and of each body.
pub fn symmetry_candidates(model: &Model, kinematics: &mut Kinematics) -> Vec<VectorField> {
    let n = model.coordinates.len();
    let unit = |i: usize| (0..n).map(|k| if k == i { Expr::ONE } else { Expr::ZERO }).collect();
    let mut list: Vec<VectorField> = (0..n)
        .filter(|i| model.time() != Some(*i))
        .map(|i| VectorField { kind: IntegralKind::Coordinate(i), xi: unit(i) })
        .collect();
    list.extend(rigid_motions(model, kinematics));
    list
}

/// Selects the symmetries of the flow among candidate fields, by exact tests. Fields that repeat others are left out.
pub(super) fn proved_symmetries(model: &Model, flow: &mut Flow, candidates: Vec<VectorField>) -> Vec<Symmetry> {
    let rates = flow.rates.clone();
    let rates = flow.without_definitions(&rates);
    let mut list: Vec<Symmetry> = Vec::new();
    for field in candidates {
        let along = symmetry_prolongation(model, flow, &field.xi);
        let is_known = list.iter().any(|known| is_same_symmetry(flow, &known.along, &along));
        if !is_known && symmetry_keeps_loops(flow, &along) && symmetry_commutes_with_flow(flow, &rates, &along) {
            list.push(Symmetry { kind: field.kind, along });
        }
    }
    // A turn about the mass centre is mostly a combination of other symmetries: the turn about the origin, and
    // translations that depend on the pose.
    let is_of_centre =
        |symmetry: &Symmetry| matches!(symmetry.kind, IntegralKind::Angular { through: Pivot::MassCentre, .. });
    for at in (0..list.len()).rev() {
        if is_of_centre(&list[at]) && is_combination_of_symmetries(flow, &list, model.coordinates.len(), at) {
            list.remove(at);
        }
    }
    list
}

/// Selects the symmetries that turn states into one another, among the candidate fields that `is_wanted` accepts. A
/// field turns states if at least one of its components is not a number. The tests are exact. Loops are not tested.
pub fn symmetries_that_turn_states(
    model: &Model,
    flow: &mut Flow,
    candidates: Vec<VectorField>,
    is_wanted: &mut dyn FnMut(&mut Arena, &[Expr]) -> bool,
) -> Vec<Symmetry> {
    let rates = flow.rates.clone();
    let rates = flow.without_definitions(&rates);
    let mut list: Vec<Symmetry> = Vec::new();
    for field in candidates {
        let along = symmetry_prolongation(model, flow, &field.xi);
        let turns = along.iter().any(|e| flow.arena.as_number(*e).is_none());
        let is_wanted = turns && is_wanted(&mut flow.arena, &along);
        let is_new = is_wanted && !list.iter().any(|known| is_same_symmetry(flow, &known.along, &along));
        if is_new && symmetry_commutes_with_flow(flow, &rates, &along) {
            list.push(Symmetry { kind: field.kind, along });
        }
    }
    list
}

/// True if the field with the index `at` moves the coordinates like a combination of the other fields, at a random
/// state. The coefficients may depend on the state, so the speeds may still change differently. `count` is the number
/// of coordinates.
fn is_combination_of_symmetries(flow: &mut Flow, list: &[Symmetry], count: usize, at: usize) -> bool {
    let fields: Vec<Expr> = list.iter().flat_map(|symmetry| symmetry.along[..count].iter().copied()).collect();
    let fields = flow.without_definitions(&fields);
    let symbols = [flow.parameters.clone(), flow.states.clone()].concat();
    // Values that have no relation to one another.
    let values: Vec<f64> = (1..=symbols.len()).map(|k| 0.5 + (k as f64 * 0.754_877_666_246_693).fract()).collect();
    let Ok(tape) = Tape::new(&flow.arena, &symbols, &fields) else { return false };
    let columns = DMatrix::from_column_slice(count, list.len(), &tape.evaluate(&values));
    let own = columns.column(at).into_owned();
    let others = columns.remove_column(at);
    let shares = SingularValues::new(&others).solve(&own, DEPENDENT * others.norm());
    (others * shares - &own).norm() <= DEPENDENT * own.norm()
}

/// Relative remainder below which a vector field counts as a combination of other vector fields.
const DEPENDENT: f64 = 1e-9;

/// True if two vector fields on the states are equal in every component, by exact zero tests.
fn is_same_symmetry(flow: &mut Flow, a: &[Expr], b: &[Expr]) -> bool {
    a.iter().zip(b).all(|(a, b)| {
        let difference = flow.arena.sub(*a, *b);
        zero_test(&flow.arena, difference) == ZeroTest::Zero
    })
}

/// Extends a field ξ on the coordinates to the field (ξ, η) on the states. Here η is the change of the generalized
/// speeds.
fn symmetry_prolongation(model: &Model, flow: &mut Flow, xi: &[Expr]) -> Vec<Expr> {
    let arena = &mut flow.arena;
    let mut d_dt = Differential::along(&model.q().into_iter().zip(model.q_dot()).collect::<Vec<_>>());
    let mut moves: Vec<(Expr, Expr)> = model.q().into_iter().zip(xi.iter().copied()).collect();
    for (rate, x) in model.q_dot().into_iter().zip(xi) {
        let changes = d_dt.apply(arena, *x);
        moves.push((rate, changes));
    }
    let mut moved = Differential::along(&moves);
    let mut in_speeds = rates_to_speeds(model);
    let eta = model.speeds.iter().map(|speed| {
        let change = moved.apply(arena, speed.definition);
        in_speeds.apply(arena, change)
    });
    xi.iter().copied().chain(eta.collect::<Vec<_>>()).collect()
}

/// True if a field on the states keeps all loop equations satisfied.
fn symmetry_keeps_loops(flow: &mut Flow, along: &[Expr]) -> bool {
    let mut moved = Differential::along(&symmetry_state_pairs(flow, along));
    let arena = &mut flow.arena;
    flow.loops.iter().chain(&flow.closed).all(|equation| {
        let change = moved.apply(arena, *equation);
        zero_test(arena, change) == ZeroTest::Zero
    })
}

/// True if a field ζ on the states commutes with the flow f: the bracket `[ζ, f] = Df ζ − Dζ f` is zero.
fn symmetry_commutes_with_flow(flow: &mut Flow, rates: &[Expr], along: &[Expr]) -> bool {
    let mut by_field = Differential::along(&symmetry_state_pairs(flow, along));
    let mut by_time = Differential::along(&symmetry_state_pairs(flow, rates));
    let arena = &mut flow.arena;
    rates.iter().zip(along).all(|(rate, component)| {
        let (a, b) = (by_field.apply(arena, *rate), by_time.apply(arena, *component));
        let bracket = arena.sub(a, b);
        zero_test(arena, bracket) == ZeroTest::Zero
    })
}

/// Pairs of each state symbol with its value.
fn symmetry_state_pairs(flow: &Flow, values: &[Expr]) -> Vec<(Expr, Expr)> {
    flow.states.iter().copied().zip(values.iter().copied()).collect()
}
