//! Model, together with the compiled equations of the program and an observer of long computations.

use crate::error::Error;
use crate::observer::Observer;
use std::ops::{Deref, DerefMut};
#[cfg(feature = "files")]
use std::path::Path;
#[cfg(feature = "files")]
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::mechanics::{Derivation, derive_all};
use tripos_derive::prove::{Proof, prove};
use tripos_derive::{Formulation, Model, derive};
use tripos_traits::CompiledModel;

/// Model, the compiled equations that the program contains, and an observer of long computations.
///
/// Compiled equations are used if they were generated from exactly the text of the model. Otherwise the equations
/// are interpreted.
#[derive(Clone)]
pub struct Mechanism {
    /// The checked model, as its file describes it.
    pub model: Model,
    /// All compiled equations of the program, for this model or for other models; empty if none were added.
    pub compiled: &'static [CompiledModel],
    /// Observer that may end long computations early.
    pub follow: Observer,
}

impl Mechanism {
    /// Makes a mechanism without compiled equations and without an observer.
    #[must_use]
    pub fn new(model: Model) -> Self {
        Self { model, compiled: &[], follow: Observer::default() }
    }

    /// Reads a model file as a mechanism without compiled equations.
    ///
    /// # Errors
    /// [`Diagnostics`] with every error of the model file.
    #[cfg(feature = "files")]
    pub fn read(path: &Path) -> Result<Self, Diagnostics> {
        Ok(Self::new(tripos_derive::model::load(&Source::read(path)?)?))
    }

    /// Sets the list of equations that were compiled into the program. It replaces the present list.
    #[must_use]
    pub fn with_compiled_equations(self, compiled: &'static [CompiledModel]) -> Self {
        Self { compiled, ..self }
    }

    /// Sets the observer that may end long computations early. It replaces the present observer.
    #[must_use]
    pub fn with_observer(self, follow: Observer) -> Self {
        Self { follow, ..self }
    }
}

impl Mechanism {
    /// Derives the equations of motion by a formulation.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the model does not have this formulation. [`Error::Input`] if it cannot be derived.
    pub fn derive(&self, formulation: Formulation) -> Result<Derivation, Error> {
        derive(&self.model, formulation).map_err(|error| {
            let kind = if error.is_unsupported() { Error::Unsupported } else { Error::Input };
            kind(self.model.diagnose(&error))
        })
    }

    /// Proves that the formulations of the model are equivalent, and finds the quantities that its motions
    /// conserve.
    ///
    /// # Errors
    /// [`Error::Input`] if the model cannot be derived.
    pub fn prove(&self) -> Result<Proof, Error> {
        let mut derivations = derive_all(&self.model).map_err(|error| self.model.diagnose(&error))?;
        Ok(prove(&self.model, &mut derivations))
    }

    /// Checks that the model has a generalized speed. `what` is the end of the message of the error.
    ///
    /// # Errors
    /// `Error::Request` if the constraints leave no generalized speed.
    pub(crate) fn require_speeds(&self, what: &str) -> Result<(), Error> {
        if !self.model.speeds.is_empty() {
            return Ok(());
        }
        let help = "`tripos simulate` follows the given motion and shows the forces; without one of the constraints, the mechanism can move freely";
        Err(Error::request(format!("the constraints leave no speed: {what}"), help))
    }

    /// Writes the equations of motion as a Rust module named `module`, and returns the text of each of its
    /// files. If the list of formulations is empty, all formulations of the model are written. `extras` asks for
    /// the Jacobian and the recurrences.
    ///
    /// # Errors
    /// [`Error::Input`] if the model cannot be derived, or does not have a requested formulation.
    #[cfg(feature = "emit")]
    pub fn emit(
        &self,
        module: &str,
        formulations: &[Formulation],
        extras: tripos_codegen::Extras,
    ) -> Result<tripos_codegen::emit::Emission, Error> {
        Ok(tripos_codegen::emit::emit_rust_model(&self.model, module, formulations, extras)?)
    }
}

/// A mechanism can be used wherever a model is expected.
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
