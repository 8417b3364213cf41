//! What no body can be: checks of masses and inertias at the default values.

use super::{Body, Parameter};
use crate::algebra::evaluate::Tape;
use crate::algebra::{Arena, Expr};

/// Values of expressions at the default parameters, if all that they need have one.
pub fn at_defaults(arena: &Arena, parameters: &[Parameter], outputs: &[Expr]) -> Option<Vec<f64>> {
    let known: Vec<&Parameter> = parameters.iter().filter(|p| p.value.is_some()).collect();
    let symbols: Vec<Expr> = known.iter().map(|p| p.symbol).collect();
    let values: Vec<f64> =
        known.iter().filter_map(|p| p.value.as_ref().map(crate::algebra::Rational::to_f64)).collect();
    Some(Tape::new(arena, &symbols, outputs).ok()?.evaluate(&values))
}

/// Relative rounding allowed in the checks of an inertia: a thin disk fulfils 1 + 1 ≥ 2 with equality.
pub const TOLERANCE: f64 = 1e-12;

/// Why this body cannot exist, in a line, if it cannot.
pub fn objection(arena: &Arena, parameters: &[Parameter], body: &Body) -> Option<(String, &'static str)> {
    let mass = at_defaults(arena, parameters, &[body.mass]).map(|v| v[0]);
    if let Some(mass) = mass.filter(|m| m.is_nan() || *m < 0.0) {
        return Some((
            format!("the mass of `{}` is {} at the default values", body.name, rounded(mass)),
            "give a mass that is not negative",
        ));
    }
    let (_, inertia) = body.rigid.as_ref()?;
    let flat: Vec<Expr> = inertia.tensor.iter().flatten().copied().collect();
    let values = at_defaults(arena, parameters, &flat)?;
    let trace = values[0] + values[4] + values[8];
    // ∫ x xᵀ dm = tr(I)/2 · 1 − I is positive semidefinite for every body: all principal minors ≥ 0.
    let p = |i: usize, j: usize| if i == j { trace / 2.0 - values[3 * i + j] } else { -values[3 * i + j] };
    let scale = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let minors = [
        (p(0, 0), 1),
        (p(1, 1), 1),
        (p(2, 2), 1),
        (p(0, 0) * p(1, 1) - p(0, 1) * p(0, 1), 2),
        (p(1, 1) * p(2, 2) - p(1, 2) * p(1, 2), 2),
        (p(0, 0) * p(2, 2) - p(0, 2) * p(0, 2), 2),
        (determinant(&p), 3),
    ];
    let broken = minors.iter().any(|(minor, degree)| minor.is_nan() || *minor < -TOLERANCE * scale.powi(*degree));
    let negative = (0..3).any(|i| values[4 * i] < -TOLERANCE * scale);
    let at = |i: usize| rounded(values[i]);
    if negative {
        return Some((
            format!("the central moments of inertia of `{}` are {}, {}, {}", body.name, at(0), at(4), at(8)),
            "a moment of inertia is not negative; one stated about another point must be at least m d^2",
        ));
    }
    let moments = format!("moments {}, {}, {}", at(0), at(4), at(8));
    let why = if [1, 5, 6].iter().all(|i| values[*i] == 0.0) {
        format!("{moments} break the triangle inequality")
    } else {
        format!("{moments}, products {}, {}, {} (xy, yz, zx)", at(1), at(5), at(6))
    };
    broken.then(|| {
        (
            format!("no body has the central inertia of `{}`: {why}", body.name),
            "each principal moment is at most the sum of the other two (equal for a thin plate)",
        )
    })
}

/// A value to show: 12 digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

fn determinant(p: &impl Fn(usize, usize) -> f64) -> f64 {
    p(0, 0) * (p(1, 1) * p(2, 2) - p(1, 2) * p(1, 2)) - p(0, 1) * (p(0, 1) * p(2, 2) - p(1, 2) * p(0, 2))
        + p(0, 2) * (p(0, 1) * p(1, 2) - p(1, 1) * p(0, 2))
}
