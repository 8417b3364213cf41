//! Model with everything that is known of it, for the comparison of two models.

use crate::mechanics::Derivations;
use crate::model::Model;
use crate::prove::Proof;

/// Model with its derivations and its proof, for comparison.
pub struct Derived<'a> {
    /// Model that is compared.
    pub model: &'a Model,
    /// Equations of the model by every formulation.
    pub derivations: &'a mut Derivations,
    /// Proof of the model; without it, first integrals are not compared.
    pub proof: Option<&'a Proof>,
}
