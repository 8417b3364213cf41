//! Checks for masses and inertias that no body can have: at the default values of a model, and at those of a scene or
//! state.

use super::{AddedMass, Body, Model, Parameter};
use crate::algebra::value::evaluate::Tape;
use crate::algebra::{Arena, Expr};

/// Symbols of the parameters that have a default value, each with that value, in SI.
pub fn defaults(parameters: &[Parameter]) -> Vec<(Expr, f64)> {
    parameters.iter().filter_map(|p| Some((p.symbol, p.value.as_ref()?.to_f64()))).collect()
}

/// Values of expressions at known symbols; `None` if an expression contains another symbol.
pub fn values_at(arena: &Arena, known: &[(Expr, f64)], outputs: &[Expr]) -> Option<Vec<f64>> {
    let (symbols, values): (Vec<Expr>, Vec<f64>) = known.iter().copied().unzip();
    Some(Tape::new(arena, &symbols, outputs).ok()?.evaluate(&values))
}

/// Mass or inertia of a body that no body can have.
#[derive(Clone, Debug)]
pub struct ImpossibleBody {
    /// Message that names the body and its fault.
    pub message: String,
    /// Advice on the way out.
    pub help: String,
    /// Indices of the parameters on which the mass or inertia depends.
    pub parameters: Vec<usize>,
}

impl Model {
    /// Bodies whose mass or inertia no body can have, at these values of the parameters.
    #[must_use]
    pub fn impossible(&self, parameters: &[f64]) -> Vec<ImpossibleBody> {
        let known: Vec<(Expr, f64)> = self.p().into_iter().zip(parameters.iter().copied()).collect();
        let objections = self.bodies.iter().filter_map(|body| {
            let (message, help) = objection(&self.arena, &known, body, "these")?;
            let tensor = body.rigid.iter().flat_map(|(_, inertia)| inertia.tensor.iter().flatten().copied());
            let values: Vec<Expr> = tensor.chain([body.mass]).collect();
            let mentions = |p: &Parameter| values.iter().any(|e| self.arena.mentions(*e, p.symbol));
            let places = (0..self.parameters.len()).filter(|at| mentions(&self.parameters[*at]));
            Some(ImpossibleBody { message, help, parameters: places.collect() })
        });
        let added = self.added_masses.iter().filter_map(|added| {
            let name = &self.bodies[added.body].name;
            let (message, help) = added_objection(&self.arena, &known, added, name, "these")?;
            let mentions = |p: &Parameter| added.tensor.iter().flatten().any(|e| self.arena.mentions(*e, p.symbol));
            let places = (0..self.parameters.len()).filter(|at| mentions(&self.parameters[*at]));
            Some(ImpossibleBody { message, help, parameters: places.collect() })
        });
        objections.chain(added).collect()
    }
}

/// Relative rounding allowed in the checks of an inertia: a thin disk fulfils 1 + 1 ≥ 2 with equality.
pub const TOLERANCE: f64 = 1e-12;

/// Least eigenvalue of an added mass with unit diagonal, below zero, that counts as rounding.
const ROUNDING: f64 = 1e-9;

/// Message and advice for a body that cannot exist at the `known` values; `None` if it can exist. `which` names these
/// values in the message, such as "the default".
pub fn objection(arena: &Arena, known: &[(Expr, f64)], body: &Body, which: &str) -> Option<(String, String)> {
    let mass = values_at(arena, known, &[body.mass]).map(|v| v[0]);
    if let Some(mass) = mass.filter(|m| m.is_nan() || *m < 0.0) {
        return Some((
            format!("the mass of `{}` is {} at {which} values", body.name, rounded(mass)),
            "give a mass that is not negative".to_owned(),
        ));
    }
    let (_, inertia) = body.rigid.as_ref()?;
    let flat: Vec<Expr> = inertia.tensor.iter().flatten().copied().collect();
    let values = values_at(arena, known, &flat)?;
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
            "a moment of inertia cannot be negative; about a point at distance d from the mass centre it is at least m d^2".to_owned(),
        ));
    }
    // The rest of a rotor with one moment of inertia and no mass is counted with the body that carries it.
    let is_rotor = body.mass == Expr::ZERO && only_axis(&values).is_some();
    let broken = broken && !is_rotor;
    let moments = format!("moments {}, {}, {}", at(0), at(4), at(8));
    let why = if [1, 5, 6].iter().all(|i| values[*i] == 0.0) {
        format!("{moments} break the triangle inequality")
    } else {
        format!("{moments}, products {}, {}, {} (xy, yz, zx)", at(1), at(5), at(6))
    };
    broken.then(|| (format!("no body has the central inertia of `{}`: {why}", body.name), way_out(&values)))
}

/// Message and advice for an added mass that no fluid has at the `known` values; `None` if its kinetic energy is never
/// negative.
pub fn added_objection(
    arena: &Arena,
    known: &[(Expr, f64)],
    added: &AddedMass,
    name: &str,
    which: &str,
) -> Option<(String, String)> {
    let values = values_at(arena, known, added.tensor.as_flattened())?;
    // Lengths are scaled so that entries of translation and rotation have one size: a congruence keeps the signs.
    let size = |at: usize| values[7 * at].abs().sqrt().max(f64::MIN_POSITIVE);
    let scaled = nalgebra::Matrix6::from_fn(|i, j| values[6 * i + j] / size(i) / size(j));
    let is_number = scaled.iter().all(|x| x.is_finite());
    let least = if is_number { scaled.symmetric_eigenvalues().min() } else { f64::NAN };
    (least.is_nan() || least < -ROUNDING).then(|| {
        let message = format!("the added mass of `{name}` gives motions a negative kinetic energy at {which} values");
        (message, "M_A is positive semidefinite: in the signs of hydrodynamics, M_A is diag(−X_u̇, −Y_v̇, …)".to_owned())
    })
}

/// Axis of the only moment of an inertia; `None` if it has others, or products.
fn only_axis(values: &[f64]) -> Option<usize> {
    let moments = [values[0], values[4], values[8]];
    let only = (0..3).find(|i| (0..3).all(|j| (i == &j) == (moments[j] != 0.0)));
    only.filter(|_| [1, 5, 6].iter().all(|i| values[*i] == 0.0))
}

/// Advice on stating an inertia that a body can have.
fn way_out(values: &[f64]) -> String {
    let rule = "each principal moment is at most the sum of the other two (equal for a thin plate)";
    match only_axis(values) {
        Some(axis) => {
            let entry = |i: usize| if i == axis { "\"J\"" } else { "\"J/2\"" };
            let plate = format!("[{}, {}, {}]", entry(0), entry(1), entry(2));
            format!(
                "{rule}: of a body that moves in a plane only the moment about the normal counts, so state a thin plate, diagonal = {plate} with J that moment; of a rotor whose mass is counted with the body that carries it, state mass = 0"
            )
        }
        None => rule.to_owned(),
    }
}

/// A value rounded to 12 digits, for messages.
fn rounded(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

fn determinant(p: &impl Fn(usize, usize) -> f64) -> f64 {
    p(0, 0) * (p(1, 1) * p(2, 2) - p(1, 2) * p(1, 2)) - p(0, 1) * (p(0, 1) * p(2, 2) - p(1, 2) * p(0, 2))
        + p(0, 2) * (p(0, 1) * p(1, 2) - p(1, 1) * p(0, 2))
}
