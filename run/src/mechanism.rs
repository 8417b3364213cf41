//! A model with what is compiled of it.

use crate::follow::Follow;
use std::ops::{Deref, DerefMut};
#[cfg(feature = "files")]
use std::path::Path;
use tripos_derive::Model;
#[cfg(feature = "files")]
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_traits::CompiledModel;

/// A model, the compiled equations that a program brings along, and who follows long work on it.
///
/// Equations run compiled if they were generated from the model's very text, else interpreted.
#[derive(Clone)]
pub struct Mechanism {
    /// The model.
    pub model: Model,
    /// The compiled equations, of this model or of others.
    pub compiled: &'static [CompiledModel],
    /// Who may end long work early.
    pub follow: Follow,
}

impl Mechanism {
    /// A model that nothing is compiled of, and nobody follows.
    #[must_use]
    pub fn new(model: Model) -> Self {
        Self { model, compiled: &[], follow: Follow::default() }
    }

    /// Reads a model file.
    ///
    /// # Errors
    /// [`Diagnostics`] with every error of the file.
    #[cfg(feature = "files")]
    pub fn read(path: &Path) -> Result<Self, Diagnostics> {
        Ok(Self::new(tripos_derive::model::load(&Source::read(path)?)?))
    }

    /// With the equations that were compiled into a program.
    #[must_use]
    pub fn with(self, compiled: &'static [CompiledModel]) -> Self {
        Self { compiled, ..self }
    }

    /// With somebody who may end long work early.
    #[must_use]
    pub fn followed(self, follow: Follow) -> Self {
        Self { follow, ..self }
    }
}

/// A mechanism is used as its model where nothing else is asked of it.
impl Deref for Mechanism {
    type Target = Model;

    fn deref(&self) -> &Model {
        &self.model
    }
}

impl DerefMut for Mechanism {
    fn deref_mut(&mut self) -> &mut Model {
        &mut self.model
    }
}
