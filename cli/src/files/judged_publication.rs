//! Judgement of a publication against its model.

use crate::terminal::failure::Failure;
use tripos::Mechanism;
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::diff::{CoordinateTable, Difference, judge_publication};
use tripos_derive::mechanics::{Derivations, derive_all};
use tripos_derive::prove::{Proof, prove};
use tripos_derive::publication::{Publication, load_publication, load_publication_in_coordinates};

/// Publication with the verdicts on its entries, and with the derived equations that were compared.
pub struct JudgedPublication {
    /// Model of the publication. Its arena also contains the publication's formulas.
    pub model: Mechanism,
    /// Printed derivation with its entries, which is judged.
    pub publication: Publication,
    /// Derived equations of the model, in the arena of all verdicts.
    pub derivations: Derivations,
    /// Proofs about the model's derived equations, such as first integrals.
    pub proof: Proof,
    /// Verdicts on all entries of the publication.
    pub difference: Difference,
}

impl JudgedPublication {
    /// Reads a publication for a model and judges it. The given model is not changed.
    ///
    /// # Errors
    /// [`Failure`] with every error of the publication file, or if the model cannot be derived.
    pub fn new(model: &Mechanism, source: &Source) -> Result<Self, Failure> {
        Self::judge_loaded_publication(model, &|model| load_publication(source, model))
    }

    /// Reads a publication for a model and judges it with another table of coordinates. The given model is not changed.
    ///
    /// # Errors
    /// [`Failure`] with every error of the publication file, or if the model cannot be derived.
    pub fn judge_in_coordinates(
        model: &Mechanism,
        source: &Source,
        coordinates: &CoordinateTable,
    ) -> Result<Self, Failure> {
        Self::judge_loaded_publication(model, &|model| load_publication_in_coordinates(source, model, coordinates))
    }

    /// Judges the publication that the function `load` reads into a copy of the model. `Err` if the publication has
    /// errors, or if the model cannot be derived.
    fn judge_loaded_publication(
        model: &Mechanism,
        load: &dyn Fn(&mut Mechanism) -> Result<Publication, Diagnostics>,
    ) -> Result<Self, Failure> {
        let mut model = model.clone();
        let publication = load(&mut model)?;
        let mut derivations = derive_all(&model).map_err(|error| model.diagnose(&error))?;
        let proof = prove(&model, &mut derivations);
        let difference = judge_publication(&model, &mut derivations, &publication, &proof);
        Ok(Self { model, publication, derivations, proof, difference })
    }
}
