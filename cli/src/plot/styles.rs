//! Styles of curves by meaning, as indices into the table of looks, equal in every figure.

use tripos_derive::Formulation;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_sim::Method;

/// Style of a set of equations. The standard formulations and a scene's reduced equations have styles of their own, for
/// any model; printed systems have later styles. Formulations on request share one style.
pub fn style(by: &EquationsOrigin) -> usize {
    match by.formulation() {
        Some(formulation) => Formulation::STANDARD.iter().position(|f| *f == formulation).unwrap_or(ON_REQUEST),
        None if by.is_reduced() => Formulation::STANDARD.len(),
        None => PRINTED,
    }
}

/// Largest number of curves of printed systems in a figure, of right and of wrong ones each; more would look alike.
pub const MOST_PRINTED: usize = 5;
/// Largest number of curves in a figure, printed ones among them; more names could not be told apart.
pub const MOST_CURVES: usize = 8;
/// Style of the first printed system that is not proved wrong.
pub const PRINTED: usize = Formulation::STANDARD.len() + 1;
/// Style of the first wrong printed system: these styles are red, and no other is.
pub const WRONG: usize = PRINTED + MOST_PRINTED;
/// Style of a Pareto front.
pub const FRONT: usize = WRONG + MOST_PRINTED;
/// Style of the first method of integration in a speed chart.
pub const METHODS: usize = FRONT + 1;
/// Style of the numeric solve for accelerations.
pub const NUMERIC: usize = METHODS + Method::ALL.len();
/// Style of runs by quadrature.
pub const BY_QUADRATURE: usize = NUMERIC + 1;
/// Style of a formulation that is derived on request.
pub const ON_REQUEST: usize = BY_QUADRATURE + 1;
