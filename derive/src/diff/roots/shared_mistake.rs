//! Search for a mistake that several components of a vector or matrix share.
//!
//! Invariant: one description explains, as an identity, the whole difference from the derived value in both components.
//! It is a common factor, a common factor of one part of the vector's formula, or the angular velocity of a wrong
//! frame.

use super::derived_values::{derived_value_components, derived_values_arena, difference};
use super::exact_comparison::{ExactComparison, WrongValue};
use crate::algebra::Expr;
use crate::algebra::text::print::print_text;
use crate::geometry::{Components, cross_components};
use crate::mechanics::{Kinematics, Quantities, QuantityKind, VectorName};

/// Mistake that two components of a vector or matrix share.
pub enum SharedMistake {
    /// Factor printed ÷ derived, equal for both components.
    Factor(Expr),
    /// Name of a part in the formula of both components, and the ratio of the printed part to the derived part.
    Part(String, Expr),
    /// Angular velocity of a wrong frame in ω × vector: index of the printed frame, index of the right frame, and name
    /// of the vector.
    Turned(usize, usize, &'static str),
}

impl SharedMistake {
    /// Description of the shared mistake in words, such as "several components are wrong by the
    /// factor 2".
    pub fn words(&self, quantities: &Quantities<'_>) -> String {
        let arena = &quantities.derivations.kinematics.arena;
        let frame = |at: usize| &quantities.model.frames[at].name;
        match self {
            Self::Factor(factor) => {
                format!("several components are wrong by the factor {}", print_text(arena, *factor))
            }
            Self::Part(part, factor) if *factor == Expr::ZERO => format!("{part} is missing"),
            Self::Part(part, factor) => format!("{part} has the factor {}", print_text(arena, *factor)),
            Self::Turned(used, right, vector) => {
                format!("omega({}) is printed instead of omega({}) in omega x {vector}", frame(*used), frame(*right))
            }
        }
    }
}

/// Vector that equals a factor ±m times the time derivative of another vector.
struct VectorRate {
    /// Components of the differentiated vector in the frame `frame`.
    of: Components,
    /// Kind of the differentiated vector, such as velocity or angular momentum.
    changing: VectorName,
    /// Factor of the time derivative: 1, −1, or ± the mass in kg.
    times: Expr,
    /// Index of the frame in which the components are taken.
    frame: usize,
    /// Index of the frame whose rotation contributes to the derivative: the frame of the body, or of the vector itself.
    /// `None` for linear motion.
    carrier: Option<usize>,
}

/// Finds the mistake that two wrong components share.
/// Returns `None` unless they are different components of one vector or matrix and share a mistake.
pub fn find_shared_mistake(
    exact: &mut ExactComparison<'_, '_>,
    a: &WrongValue,
    b: &WrongValue,
) -> Option<SharedMistake> {
    if shared_vector_of_component(&a.kind).is_none()
        || shared_vector_of_component(&a.kind) != shared_vector_of_component(&b.kind)
        || a.kind == b.kind
    {
        return None;
    }
    if let Some(factor) = same_ratio(exact, (a.printed, a.derived), (b.printed, b.derived)) {
        return Some(SharedMistake::Factor(factor));
    }
    let (QuantityKind::Component { axis: one, .. }, QuantityKind::Component { axis: other, .. }) = (&a.kind, &b.kind)
    else {
        return None;
    };
    let rate = shared_vector_as_rate(exact.quantities, &a.kind)?;
    let off = [a, b].map(|v| derived_values_arena(exact.quantities).sub(v.printed, v.derived));
    let axes = [*one, *other];
    find_shared_part(exact, &rate, &a.kind, axes, off).or_else(|| find_wrong_frame(exact, &rate, axes, off))
}

/// Key that is equal for all components of one vector or matrix; `None` for other quantities.
fn shared_vector_of_component(kind: &QuantityKind) -> Option<QuantityKind> {
    match *kind {
        QuantityKind::Component { vector, of, frame, .. } => {
            Some(QuantityKind::Component { vector, of, frame, axis: 0 })
        }
        QuantityKind::Partial { vector, of, frame, speed, .. } => {
            Some(QuantityKind::Partial { vector, of, frame, axis: 0, speed })
        }
        QuantityKind::Inertia { body, frame, .. } => Some(QuantityKind::Inertia { body, frame, entry: (0, 0) }),
        QuantityKind::Rotation { from, to, .. } => Some(QuantityKind::Rotation { from, to, entry: (0, 0) }),
        _ => None,
    }
}

/// Ratio of the two terms in `a`, if the two terms in `b` have the same ratio and it depends on parameters only.
/// Otherwise `None`.
fn same_ratio(exact: &mut ExactComparison<'_, '_>, a: (Expr, Expr), b: (Expr, Expr)) -> Option<Expr> {
    let (k, other) = (exact.exact_ratio(a.0, a.1)?, exact.exact_ratio(b.0, b.1)?);
    exact.compare_exactly(k, other).then_some(k)
}

/// Writes a vector as a factor times a time derivative; `None` if the vector is not of this form.
fn shared_vector_as_rate(quantities: &mut Quantities<'_>, kind: &QuantityKind) -> Option<VectorRate> {
    let QuantityKind::Component { vector, of, frame, .. } = *kind else { return None };
    let model = quantities.model;
    let (changing, owner, carrier) = match vector {
        VectorName::Acceleration => (VectorName::Velocity, of, None),
        VectorName::LinearMomentumRate | VectorName::InertiaForce => {
            (VectorName::Velocity, model.bodies[of].centre, None)
        }
        VectorName::AngularAcceleration => (VectorName::AngularVelocity, of, Some(of)),
        VectorName::MomentumRate | VectorName::InertiaTorque => {
            (VectorName::AngularMomentum, of, Some(model.bodies[of].rigid.as_ref()?.0))
        }
        _ => return None,
    };
    let mass = match vector {
        VectorName::LinearMomentumRate | VectorName::InertiaForce => model.bodies[of].mass,
        _ => Expr::ONE,
    };
    let is_opposite = matches!(vector, VectorName::InertiaForce | VectorName::InertiaTorque);
    let times = if is_opposite { derived_values_arena(quantities).neg(mass) } else { mass };
    Some(VectorRate {
        of: derived_value_components(quantities, changing, owner, frame)?,
        changing,
        times,
        frame,
        carrier,
    })
}

/// Finds a part of the vector's formula with the same wrong factor in both components: ω × vector, or the remaining
/// part. `off` are the errors printed − derived of the components along the two `axes`. Returns `None` if no part has
/// such a factor.
fn find_shared_part(
    exact: &mut ExactComparison<'_, '_>,
    rate: &VectorRate,
    kind: &QuantityKind,
    axes: [usize; 2],
    off: [Expr; 2],
) -> Option<SharedMistake> {
    let QuantityKind::Component { vector, of, frame, .. } = *kind else { return None };
    let whole = derived_value_components(exact.quantities, vector, of, frame)?;
    for seen in [Some(rate.frame), rate.carrier].into_iter().flatten() {
        let w = derived_value_components(exact.quantities, VectorName::AngularVelocity, seen, rate.frame)?;
        let arena = derived_values_arena(exact.quantities);
        let carried = cross_components(arena, &w, &rate.of).map(|e| arena.mul(rate.times, e));
        let own = difference(arena, &whole, &carried);
        let turning = exact.quantities.model.frames[seen].name.clone();
        let is_euler = rate.changing == VectorName::AngularMomentum && rate.carrier == Some(seen);
        let own_words =
            if is_euler { "I·alpha".to_owned() } else { format!("d{}/dt in {turning}", rate.changing.name()) };
        for (part, words) in [(carried, format!("omega({turning}) x {}", rate.changing.name())), (own, own_words)] {
            if let Some(k) = same_ratio(exact, (off[0], part[axes[0]]), (off[1], part[axes[1]])) {
                let Kinematics { arena, simplifier, .. } = &mut exact.quantities.derivations.kinematics;
                let factor = arena.add(Expr::ONE, k);
                return Some(SharedMistake::Part(words, simplifier.simplify(arena, factor)));
            }
        }
    }
    None
}

/// Finds a frame whose angular velocity is used in ω × vector instead of the right one; `None` if there is no such
/// frame.
fn find_wrong_frame(
    exact: &mut ExactComparison<'_, '_>,
    rate: &VectorRate,
    axes: [usize; 2],
    off: [Expr; 2],
) -> Option<SharedMistake> {
    for right in [rate.carrier, Some(rate.frame)].into_iter().flatten() {
        let own = derived_value_components(exact.quantities, VectorName::AngularVelocity, right, rate.frame)?;
        for used in (0..exact.quantities.model.frames.len()).filter(|used| *used != right) {
            let w = derived_value_components(exact.quantities, VectorName::AngularVelocity, used, rate.frame)?;
            let arena = derived_values_arena(exact.quantities);
            let more = difference(arena, &w, &own);
            let change = cross_components(arena, &more, &rate.of).map(|e| arena.mul(rate.times, e));
            if exact.compare_exactly(off[0], change[axes[0]]) && exact.compare_exactly(off[1], change[axes[1]]) {
                return Some(SharedMistake::Turned(used, right, rate.changing.name()));
            }
        }
    }
    None
}
