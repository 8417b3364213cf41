//! Indices into the table of looks, by meaning, the same in every figure.

use tripos_derive::Formulation;
use tripos_derive::mechanics::By;
use tripos_sim::Method;

/// Formulations and a scene's own equations keep their colours, whichever a model supports; printed ones come after
/// these.
pub fn style(by: &By) -> usize {
    let reduced = Formulation::ALL.len();
    let formulation = Formulation::ALL.iter().position(|f| by.formulation() == Some(*f));
    formulation.unwrap_or(if by.is_reduced() { reduced } else { PRINTED })
}

/// Curves of printed systems in a figure, of each kind; more cannot be told apart.
pub const MOST_PRINTED: usize = 5;
/// Curves of a figure, printed ones among them; more names are not told apart.
pub const MOST_CURVES: usize = 8;
/// The style of the first printed system that is not proved wrong.
pub const PRINTED: usize = Formulation::ALL.len() + 1;
/// The style of the first wrong one: these are red, and nothing else is.
pub const WRONG: usize = PRINTED + MOST_PRINTED;
/// The style of a Pareto front.
pub const FRONT: usize = WRONG + MOST_PRINTED;
/// The style of the first method of a chart.
pub const METHODS: usize = FRONT + 1;
/// The style of the numeric solve.
pub const NUMERIC: usize = METHODS + Method::ALL.len();
/// The style of quadrature.
pub const BY_QUADRATURE: usize = NUMERIC + 1;
