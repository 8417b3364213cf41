//! A publication judged against its model.

use crate::failure::Failure;
use tripos::Mechanism;
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::diff::{CoordinateTable, Difference, diff};
use tripos_derive::mechanics::{Derivations, derive_all};
use tripos_derive::prove::{Proof, prove};
use tripos_derive::publication::{Publication, load, load_in};

/// A publication with its verdicts, and the derived equations that they are about.
pub struct Judged {
    /// Model of the publication; the publication's formulas are in its arena.
    pub model: Mechanism,
    /// Printed derivation.
    pub publication: Publication,
    /// Derived equations, with the terms of all verdicts.
    pub derivations: Derivations,
    /// Proofs about the derived equations.
    pub proof: Proof,
    /// Verdicts on all entries.
    pub difference: Difference,
}

impl Judged {
    /// Reads a publication for a model and judges it. The model of the caller stays as it is.
    ///
    /// # Errors
    /// [`Failure`] with every error of the publication file, or if the model cannot be derived.
    pub fn new(model: &Mechanism, source: &Source) -> Result<Self, Failure> {
        Self::read(model, &|model| load(source, model))
    }

    /// Reads a publication with a table of coordinates in the place of its own, and judges it.
    ///
    /// # Errors
    /// [`Failure`] with every error of the publication file, or if the model cannot be derived.
    pub fn new_in(model: &Mechanism, source: &Source, coordinates: &CoordinateTable) -> Result<Self, Failure> {
        Self::read(model, &|model| load_in(source, model, coordinates))
    }

    fn read(
        model: &Mechanism,
        load: &dyn Fn(&mut Mechanism) -> Result<Publication, Diagnostics>,
    ) -> Result<Self, Failure> {
        let mut model = model.clone();
        let publication = load(&mut model)?;
        let mut derivations = derive_all(&model).map_err(|error| model.diagnose(&error))?;
        let proof = prove(&model, &mut derivations);
        let difference = diff(&model, &mut derivations, &publication, &proof);
        Ok(Self { model, publication, derivations, proof, difference })
    }
}
