//! Search for one mistake in several components of one vector or matrix.
//!
//! Invariant: one description explains the whole difference from the derived value in both components, by identity. It
//! is an equal factor, an equal factor of one part of the vector's formula, or the angular velocity of a wrong frame.

use super::derived_values::{arena_of, components, difference};
use super::exact::{Exact, Value};
use crate::algebra::Expr;
use crate::algebra::text::print::text;
use crate::geometry::{Components, cross_components};
use crate::mechanics::{Kinematics, Quantities, QuantityKind, VectorName};

/// Mistake that two components of a vector or matrix share.
pub enum Shared {
    /// Factor of both printed components against the derived ones.
    Factor(Expr),
    /// Name of a part of both components, and the part's factor against the derived part.
    Part(String, Expr),
    /// Angular velocity of a wrong frame in ω × a vector: index of the used frame, index of the right frame, name of
    /// the vector.
    Turned(usize, usize, &'static str),
}

impl Shared {
    /// Description of the mistake, in words.
    pub fn words(&self, quantities: &Quantities<'_>) -> String {
        let arena = &quantities.derivations.kinematics.arena;
        let frame = |at: usize| &quantities.model.frames[at].name;
        match self {
            Self::Factor(factor) => {
                format!("several components are wrong by the factor {}", text(arena, *factor))
            }
            Self::Part(part, factor) if *factor == Expr::ZERO => format!("{part} is missing"),
            Self::Part(part, factor) => format!("{part} has the factor {}", text(arena, *factor)),
            Self::Turned(used, right, vector) => {
                format!("omega({}) is printed instead of omega({}) in omega x {vector}", frame(*used), frame(*right))
            }
        }
    }
}

/// Vector that is ±m times the rate of another vector, so that its formula has the parts of a rate.
struct Rate {
    /// Components of the vector that changes.
    of: Components,
    /// Kind of the vector that changes.
    changing: VectorName,
    /// Factor ±m of the rate in the quantity.
    times: Expr,
    /// Index of the frame of the components.
    frame: usize,
    /// Index of the frame that turns with the vector's body or is its own; `None` for linear motion.
    carrier: Option<usize>,
}

/// Finds the common mistake of two wrong components. `None` unless they belong to one vector or matrix and share a
/// mistake.
pub fn common(exact: &mut Exact<'_, '_>, a: &Value, b: &Value) -> Option<Shared> {
    if family(&a.kind).is_none() || family(&a.kind) != family(&b.kind) || a.kind == b.kind {
        return None;
    }
    if let Some(factor) = same_ratio(exact, (a.printed, a.derived), (b.printed, b.derived)) {
        return Some(Shared::Factor(factor));
    }
    let (QuantityKind::Component { axis: one, .. }, QuantityKind::Component { axis: other, .. }) = (&a.kind, &b.kind)
    else {
        return None;
    };
    let rate = rate(exact.quantities, &a.kind)?;
    let off = [a, b].map(|v| arena_of(exact.quantities).sub(v.printed, v.derived));
    let axes = [*one, *other];
    parts(exact, &rate, &a.kind, axes, off).or_else(|| turned(exact, &rate, axes, off))
}

/// Key of the vector or matrix to which a component belongs; `None` for other quantities.
fn family(kind: &QuantityKind) -> Option<QuantityKind> {
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

/// Ratio of two pairs of terms; `None` unless both ratios are equal and depend on parameters only.
fn same_ratio(exact: &mut Exact<'_, '_>, a: (Expr, Expr), b: (Expr, Expr)) -> Option<Expr> {
    let (k, other) = (exact.ratio(a.0, a.1)?, exact.ratio(b.0, b.1)?);
    exact.same(k, other).then_some(k)
}

/// Writes a vector as a rate times a factor; `None` if the vector is no rate.
fn rate(quantities: &mut Quantities<'_>, kind: &QuantityKind) -> Option<Rate> {
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
    let times = if is_opposite { arena_of(quantities).neg(mass) } else { mass };
    Some(Rate { of: components(quantities, changing, owner, frame)?, changing, times, frame, carrier })
}

/// Finds a part of the formula with an equal factor in both components: the vector's ω × part, or the remainder. `off`
/// are the differences from the derived components along the two `axes`.
fn parts(
    exact: &mut Exact<'_, '_>,
    rate: &Rate,
    kind: &QuantityKind,
    axes: [usize; 2],
    off: [Expr; 2],
) -> Option<Shared> {
    let QuantityKind::Component { vector, of, frame, .. } = *kind else { return None };
    let whole = components(exact.quantities, vector, of, frame)?;
    for seen in [Some(rate.frame), rate.carrier].into_iter().flatten() {
        let w = components(exact.quantities, VectorName::AngularVelocity, seen, rate.frame)?;
        let arena = arena_of(exact.quantities);
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
                return Some(Shared::Part(words, simplifier.simplify(arena, factor)));
            }
        }
    }
    None
}

/// Finds a wrong frame whose ω is used in the ω × part.
fn turned(exact: &mut Exact<'_, '_>, rate: &Rate, axes: [usize; 2], off: [Expr; 2]) -> Option<Shared> {
    for right in [rate.carrier, Some(rate.frame)].into_iter().flatten() {
        let own = components(exact.quantities, VectorName::AngularVelocity, right, rate.frame)?;
        for used in (0..exact.quantities.model.frames.len()).filter(|used| *used != right) {
            let w = components(exact.quantities, VectorName::AngularVelocity, used, rate.frame)?;
            let arena = arena_of(exact.quantities);
            let more = difference(arena, &w, &own);
            let change = cross_components(arena, &more, &rate.of).map(|e| arena.mul(rate.times, e));
            if exact.same(off[0], change[axes[0]]) && exact.same(off[1], change[axes[1]]) {
                return Some(Shared::Turned(used, right, rate.changing.name()));
            }
        }
    }
    None
}
