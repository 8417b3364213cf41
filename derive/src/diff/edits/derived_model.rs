//! Model with its equations and its proof, as input to the comparison of two models.

use crate::mechanics::Derivations;
use crate::model::Model;
use crate::prove::Proof;

/// Model with its derived equations and its proof, for comparison with another model.
pub struct DerivedModel<'a> {
    /// Model whose equations are compared with those of another model.
    pub model: &'a Model,
    /// Equations of motion of the model, by each formulation.
    pub derivations: &'a mut Derivations,
    /// Proof of the model's equations and first integrals; `None` leaves first integrals out of the
    /// comparison.
    pub proof: Option<&'a Proof>,
}
