//! A scene and its mechanism, read and run: where a program begins.

use crate::error::Error;
use crate::follow::Follow;
use crate::mechanism::Mechanism;
use crate::overrides::Overrides;
use crate::reduced::Reduced;
use crate::reference::Reference;
use crate::run::Run;
use crate::simulate::simulate;
#[cfg(feature = "files")]
use std::path::Path;
use tripos_derive::diagnostic::Source;
use tripos_derive::prove::Proof;
#[cfg(feature = "files")]
use tripos_derive::scene::model_path;
use tripos_derive::scene::{self as description, Family, Grid, load_bound};
use tripos_traits::CompiledModel;

/// A scene file and the model that it is of.
#[derive(Clone)]
pub struct Scene {
    mechanism: Mechanism,
    /// As its file has it.
    file: description::Scene,
    /// With what was set.
    current: description::Scene,
    set: Vec<(String, f64)>,
}

impl Scene {
    /// Reads a scene file, and the model file that it names.
    ///
    /// # Errors
    /// [`Error::Input`] with every error of the file that has some, each with its place.
    #[cfg(feature = "files")]
    pub fn read(path: impl AsRef<Path>) -> Result<Self, Error> {
        let source = Source::read(path.as_ref())?;
        let mechanism = Mechanism::read(&model_path(&source)?)?;
        Self::load(mechanism, &source)
    }

    /// A scene of this mechanism from the text of a scene file; which model the text names does not matter.
    ///
    /// # Errors
    /// [`Error::Input`] with every error of the text, each with its place.
    pub fn parse(mechanism: Mechanism, text: &str) -> Result<Self, Error> {
        Self::load(mechanism, &Source::from_text("scene", text))
    }

    fn load(mut mechanism: Mechanism, source: &Source) -> Result<Self, Error> {
        let file = load_bound(source, &mut mechanism)?;
        Ok(Self { mechanism, current: file.clone(), file, set: Vec::new() })
    }

    /// With equations that were compiled into a program, such as `tripos_models::MODELS`. Without them every model is
    /// interpreted.
    #[must_use]
    pub fn with(mut self, compiled: &'static [CompiledModel]) -> Self {
        self.mechanism.compiled = compiled;
        self
    }

    /// With somebody who may end long runs early.
    #[must_use]
    pub fn followed(mut self, follow: Follow) -> Self {
        self.mechanism.follow = follow;
        self
    }

    /// The model, and what is compiled of it.
    #[must_use]
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// What the scene says, with what was set.
    #[must_use]
    pub fn description(&self) -> &description::Scene {
        &self.current
    }

    /// Gives a parameter, or a number of the start, another value, in the unit of the model file. What the scene
    /// computes from it follows.
    ///
    /// # Errors
    /// [`Error::Inputs`] if the scene has no such number; [`Error::Input`] if it cannot have this value, such as a
    /// mass below zero.
    pub fn set(&mut self, name: &str, value: f64) -> Result<(), Error> {
        let mut set = self.set.clone();
        set.retain(|(known, _)| known != name);
        set.push((name.to_owned(), value));
        let texts: Vec<String> = set.iter().map(|(name, value)| format!("{name}={value:e}")).collect();
        let grid = Grid::read(&texts, "what was set", &self.file, &mut self.mechanism).map_err(Error::Inputs)?;
        let scene = Family::new(&self.file, &self.mechanism, &grid)?.point(0).1?;
        (self.set, self.current) = (set, scene);
        Ok(())
    }

    /// Proves what can be proved of the model: that its formulations are equivalent, and what motions conserve.
    ///
    /// # Errors
    /// [`Error::Input`] if the model cannot be derived.
    pub fn prove(&self) -> Result<Proof, Error> {
        self.mechanism.prove()
    }

    /// The least equations that give what the scene shows, and the constants that its start has.
    ///
    /// # Errors
    /// [`Error`] if the model cannot be derived, or the scene asks for what it does not determine.
    pub fn reduce(&self) -> Result<Reduced, Error> {
        Reduced::new(&self.mechanism, &self.current)
    }

    /// The states at these instants, s, in the order of the run, to some twenty digits, and how sure they are.
    ///
    /// # Errors
    /// [`Error`] if no formulation gets there.
    pub fn reference(&self, times: &[f64]) -> Result<Reference, Error> {
        Reference::new(&self.mechanism, &self.current, times)
    }

    /// Runs the scene: by its own reduced equations, unless `how` names others or solves numerically.
    ///
    /// # Errors
    /// [`Error`] if it cannot be run. A run that began and could not go on is a [`Run`] that says so.
    pub fn simulate(&self, how: &Overrides) -> Result<Run, Error> {
        let mut scene = self.current.clone();
        how.change(&mut scene)?;
        simulate(&self.mechanism, &scene, how.by.as_deref())
    }
}
