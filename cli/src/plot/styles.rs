//! Style numbers of curves by their meaning, the same in every figure. A style number selects a look: colour, dashes
//! and marker.

use tripos_derive::Formulation;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_sim::Method;

/// Returns the style number of a set of equations. Each standard formulation, and the reduced equations, have their own
/// number. Formulations on request share one number, and printed systems begin at `PRINTED`.
pub fn equations_style(by: &EquationsOrigin) -> usize {
    match by.formulation() {
        Some(formulation) => Formulation::STANDARD.iter().position(|f| *f == formulation).unwrap_or(ON_REQUEST),
        None if by.is_reduced() => Formulation::STANDARD.len(),
        None => PRINTED,
    }
}

/// Largest number of curves of right printed systems in a figure, and also of wrong printed systems. Further curves
/// would look alike.
pub const MOST_PRINTED: usize = 5;
/// Largest number of curves in a figure, including printed systems. Further curves could not be distinguished.
pub const MOST_CURVES: usize = 8;
/// Style number of the first printed system that is not proved wrong.
pub const PRINTED: usize = Formulation::STANDARD.len() + 1;
/// Style number of the first wrong printed system. Only wrong systems are red.
pub const WRONG: usize = PRINTED + MOST_PRINTED;
/// Style number of the Pareto front in a speed chart.
pub const FRONT: usize = WRONG + MOST_PRINTED;
/// Style number of the first integration method in a speed chart.
pub const METHODS: usize = FRONT + 1;
/// Style number of the numeric solve for accelerations in a speed chart.
pub const NUMERIC: usize = METHODS + Method::ALL.len();
/// Style number of runs by quadrature in a speed chart.
pub const BY_QUADRATURE: usize = NUMERIC + 1;
/// Style number of formulations that are derived only on request.
pub const ON_REQUEST: usize = BY_QUADRATURE + 1;
