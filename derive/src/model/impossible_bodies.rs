//! Physical checks: finds masses, inertias and added masses that no body can have. The parameters have the default
//! values of a model or the values of a scene.

use super::{AddedMass, Body, Model, Parameter};
use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr};

/// Parameters that have a default value, as (symbol, value in SI units).
pub fn default_parameter_values(parameters: &[Parameter]) -> Vec<(Expr, f64)> {
    parameters.iter().filter_map(|p| Some((p.symbol, p.value.as_ref()?.to_f64()))).collect()
}

/// Values of the terms `outputs` at the given values of symbols, as doubles. `None` if a term contains another
/// symbol.
pub fn values_of_terms_at(arena: &Arena, known: &[(Expr, f64)], outputs: &[Expr]) -> Option<Vec<f64>> {
    let (symbols, values): (Vec<Expr>, Vec<f64>) = known.iter().copied().unzip();
    Some(Tape::new(arena, &symbols, outputs).ok()?.evaluate(&values))
}

/// Error of a body whose mass, inertia or added mass is physically impossible.
#[derive(Clone, Debug)]
pub struct ImpossibleBody {
    /// Message that names the body and its fault.
    pub message: String,
    /// Advice for correcting the values.
    pub help: String,
    /// Indices of the parameters that occur in the body's mass or inertia.
    pub parameters: Vec<usize>,
}

impl Model {
    /// Finds bodies whose mass, inertia or added mass is physically impossible at the given parameter values. The
    /// values are in SI units, in the order of [`Self::parameters`]. Empty if all bodies are possible.
    #[must_use]
    pub fn impossible_bodies(&self, parameters: &[f64]) -> Vec<ImpossibleBody> {
        let known: Vec<(Expr, f64)> = self.p().into_iter().zip(parameters.iter().copied()).collect();
        let objections = self.bodies.iter().filter_map(|body| {
            let (message, help) = impossible_body_message(&self.arena, &known, body, "these")?;
            let tensor = body.rigid.iter().flat_map(|(_, inertia)| inertia.tensor.iter().flatten().copied());
            let values: Vec<Expr> = tensor.chain([body.mass]).collect();
            let mentions = |p: &Parameter| values.iter().any(|e| self.arena.mentions(*e, p.symbol));
            let places = (0..self.parameters.len()).filter(|at| mentions(&self.parameters[*at]));
            Some(ImpossibleBody { message, help, parameters: places.collect() })
        });
        let added = self.added_masses.iter().filter_map(|added| {
            let name = &self.bodies[added.body].name;
            let (message, help) = impossible_added_mass_message(&self.arena, &known, added, name, "these")?;
            let mentions = |p: &Parameter| added.tensor.iter().flatten().any(|e| self.arena.mentions(*e, p.symbol));
            let places = (0..self.parameters.len()).filter(|at| mentions(&self.parameters[*at]));
            Some(ImpossibleBody { message, help, parameters: places.collect() })
        });
        objections.chain(added).collect()
    }
}

/// Relative rounding error allowed in the checks of an inertia. A thin disk lies exactly at the limit: its moments
/// are as 1, 1 and 2.
pub const TOLERANCE: f64 = 1e-12;

/// Rounding allowed in the eigenvalues of an added mass matrix that is scaled to a unit diagonal. A negative
/// eigenvalue of at most this size counts as zero.
const ROUNDING: f64 = 1e-9;

/// Message and advice for a body whose mass or inertia is impossible at the `known` values; `None` if both are
/// possible. `which` describes the values in the message, such as "the default".
pub fn impossible_body_message(
    arena: &Arena,
    known: &[(Expr, f64)],
    body: &Body,
    which: &str,
) -> Option<(String, String)> {
    let mass = values_of_terms_at(arena, known, &[body.mass]).map(|v| v[0]);
    if let Some(mass) = mass.filter(|m| m.is_nan() || *m < 0.0) {
        return Some((
            format!("the mass of `{}` is {} at {which} values", body.name, rounded_impossible_value(mass)),
            "give a mass that is not negative".to_owned(),
        ));
    }
    let (_, inertia) = body.rigid.as_ref()?;
    let flat: Vec<Expr> = inertia.tensor.iter().flatten().copied().collect();
    let values = values_of_terms_at(arena, known, &flat)?;
    let trace = values[0] + values[4] + values[8];
    // The matrix ∫ x xᵀ dm = tr(I)/2 · 1 − I is positive semidefinite for every body. So all its principal minors are
    // ≥ 0.
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
    let at = |i: usize| rounded_impossible_value(values[i]);
    if negative {
        return Some((
            format!("the central moments of inertia of `{}` are {}, {}, {}", body.name, at(0), at(4), at(8)),
            "a moment of inertia cannot be negative; about a point at distance d from the mass centre it is at least m d^2".to_owned(),
        ));
    }
    // A rotor without mass and with a single moment of inertia is allowed. Its other moments are counted with another
    // body.
    let is_rotor = body.mass == Expr::ZERO && only_axis_of_body_inertia(&values).is_some();
    let broken = broken && !is_rotor;
    let moments = format!("moments {}, {}, {}", at(0), at(4), at(8));
    let why = if [1, 5, 6].iter().all(|i| values[*i] == 0.0) {
        format!("{moments} break the triangle inequality")
    } else {
        format!("{moments}, products {}, {}, {} (xy, yz, zx)", at(1), at(5), at(6))
    };
    broken.then(|| {
        (format!("no body has the central inertia of `{}`: {why}", body.name), impossible_inertia_advice(&values))
    })
}

/// Message and advice for an added mass whose kinetic energy can be negative at the `known` values; `None` if it
/// cannot. In the message, `name` is the body, and `which` describes the values, such as "the default".
pub fn impossible_added_mass_message(
    arena: &Arena,
    known: &[(Expr, f64)],
    added: &AddedMass,
    name: &str,
    which: &str,
) -> Option<(String, String)> {
    let values = values_of_terms_at(arena, known, added.tensor.as_flattened())?;
    // Scaling to a unit diagonal gives entries of translation and of rotation the same size. As a congruence it keeps
    // the signs of the eigenvalues.
    let size = |at: usize| values[7 * at].abs().sqrt().max(f64::MIN_POSITIVE);
    let scaled = nalgebra::Matrix6::from_fn(|i, j| values[6 * i + j] / size(i) / size(j));
    let is_number = scaled.iter().all(|x| x.is_finite());
    let least = if is_number { scaled.symmetric_eigenvalues().min() } else { f64::NAN };
    (least.is_nan() || least < -ROUNDING).then(|| {
        let message = format!("the added mass of `{name}` gives motions a negative kinetic energy at {which} values");
        (message, "M_A is positive semidefinite: in the signs of hydrodynamics, M_A is diag(−X_u̇, −Y_v̇, …)".to_owned())
    })
}

/// Axis, 0 to 2, of an inertia with a single nonzero moment. `values` are its nine entries, row by row. `None` if it
/// has other moments, or products of inertia.
fn only_axis_of_body_inertia(values: &[f64]) -> Option<usize> {
    let moments = [values[0], values[4], values[8]];
    let only = (0..3).find(|i| (0..3).all(|j| (i == &j) == (moments[j] != 0.0)));
    only.filter(|_| [1, 5, 6].iter().all(|i| values[*i] == 0.0))
}

/// Advice for an error message: an inertia that a body can have.
fn impossible_inertia_advice(values: &[f64]) -> String {
    let rule = "each principal moment is at most the sum of the other two (equal for a thin plate)";
    match only_axis_of_body_inertia(values) {
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

/// Value rounded to 12 significant digits, for error messages.
fn rounded_impossible_value(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

/// Determinant of a symmetric 3 × 3 matrix with the entries p(i, j).
fn determinant(p: &impl Fn(usize, usize) -> f64) -> f64 {
    p(0, 0) * (p(1, 1) * p(2, 2) - p(1, 2) * p(1, 2)) - p(0, 1) * (p(0, 1) * p(2, 2) - p(1, 2) * p(0, 2))
        + p(0, 2) * (p(0, 1) * p(1, 2) - p(1, 1) * p(0, 2))
}
