//! Scene with its mechanism, read from files and run. Most programs start here.

use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::observer::Observer;
use crate::overrides::Overrides;
use crate::preparation::reduced_equations::ReducedScene;
use crate::simulation::run::Run;
use crate::simulation::sampled_inputs::{self, ControllerSample, HeldSignal, SampledRun};
use crate::simulation::simulate::simulate;
use crate::studies::abbreviation::{Abbreviation, abbreviate};
use crate::studies::sensitivity::gradient::{Gradient, gradient};
use crate::studies::sensitivity::{DerivativeInstants, Sensitivities, sensitivities};
use crate::trust::reference_solution::ReferenceSolution;
#[cfg(feature = "files")]
use std::path::Path;
use tripos_derive::diagnostic::Source;
use tripos_derive::prove::Proof;
#[cfg(feature = "files")]
use tripos_derive::scene::model_path_of_scene;
use tripos_derive::scene::{self as description, Family, Grid, SceneNeighbours, load_output, load_scene_with_inputs};
use tripos_traits::{CompiledModel, Real};

/// Scene (parameters, start and span of a run) with its mechanism.
#[derive(Clone)]
pub struct Scene {
    /// Model of the scene, with compiled equations and an observer.
    mechanism: Mechanism,
    /// Description of the scene exactly as its file states it.
    file: description::Scene,
    /// Description of the scene after all changes by [`Scene::set_number`].
    current: description::Scene,
    /// Names of the numbers that [`Scene::set_number`] changed, with their new values.
    set: Vec<(String, f64)>,
}

impl Scene {
    /// Reads a scene file, and the model file that it names.
    ///
    /// # Errors
    /// [`Error::Input`] with every error of the first file that has errors, each with its line and column.
    #[cfg(feature = "files")]
    pub fn read(path: impl AsRef<Path>) -> Result<Self, Error> {
        let source = Source::read(path.as_ref())?;
        let mechanism = Mechanism::read(&model_path_of_scene(&source)?)?;
        Self::from_source(mechanism, &source)
    }

    /// Makes a scene of a mechanism from the text of a scene file. The model file that the text names is not read.
    ///
    /// # Errors
    /// [`Error::Input`] with every error of the text, each with its line and column.
    pub fn parse(mechanism: Mechanism, text: &str) -> Result<Self, Error> {
        Self::from_source(mechanism, &Source::from_text("scene", text))
    }

    /// Reads the text of a scene file. Puts the scene's formulas for inputs into the model of the mechanism.
    fn from_source(mut mechanism: Mechanism, source: &Source) -> Result<Self, Error> {
        let file = load_scene_with_inputs(source, &mut mechanism)?;
        Ok(Self::from_description(mechanism, file))
    }

    /// Makes a scene of a mechanism from a description that [`load_scene_with_inputs`] read for this mechanism.
    #[must_use]
    pub fn from_description(mechanism: Mechanism, description: description::Scene) -> Self {
        Self { mechanism, current: description.clone(), file: description, set: Vec::new() }
    }

    /// Adds equations of motion that were compiled into the program, such as `tripos_models::MODELS`. Without
    /// them, the equations of every model are interpreted.
    #[must_use]
    pub fn with_compiled_equations(mut self, compiled: &'static [CompiledModel]) -> Self {
        self.mechanism.compiled = compiled;
        self
    }

    /// Adds an observer that may end long computations early.
    #[must_use]
    pub fn with_observer(mut self, follow: Observer) -> Self {
        self.mechanism.follow = follow;
        self
    }

    /// Mechanism of the scene: its model, its compiled equations, and its observer.
    #[must_use]
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// Description of the scene, with the numbers that [`Scene::set_number`] changed.
    #[must_use]
    pub fn description(&self) -> &description::Scene {
        &self.current
    }

    /// Sets a parameter, or a number of the start, to another value, in the unit of the model file. Numbers that
    /// the scene computes from it change too. After an error, the scene is unchanged.
    ///
    /// # Errors
    /// [`Error::Inputs`] if the scene has no number of this name. [`Error::Input`] if the number cannot have this
    /// value,
    /// such as a mass below zero.
    pub fn set_number(&mut self, name: &str, value: f64) -> Result<(), Error> {
        *self = self.with_numbers(&[(name.to_owned(), value)])?;
        Ok(())
    }

    /// Returns the scene with other values of several parameters and numbers of the start, in the units of the model
    /// file. Numbers that the scene computes from them change too.
    ///
    /// # Errors
    /// [`Error`], for the same reasons as [`Scene::set_number`].
    pub fn with_numbers(&self, numbers: &[(String, f64)]) -> Result<Self, Error> {
        let mut changed = self.clone();
        changed.set.retain(|(known, _)| !numbers.iter().any(|(name, _)| name == known));
        changed.set.extend(numbers.iter().cloned());
        let grid = Grid::of_values(&changed.set, "what was set", &changed.file, &mut changed.mechanism);
        let grid = grid.map_err(Error::Inputs)?;
        changed.current = Family::new(&changed.file, &changed.mechanism, &grid)?.point(0).1?;
        Ok(changed)
    }

    /// Returns the value of a parameter or of a number of the start, in the unit of the model file.
    ///
    /// # Errors
    /// [`Error::Input`] if the scene has no number of this name, or if it solves for the number.
    pub fn number(&self, name: &str) -> Result<f64, Error> {
        let number = SceneNeighbours::new(&self.current, &self.mechanism, &self.set, name)?;
        Ok(number.value().to_f64())
    }

    /// Returns the unit of a parameter or of a number of the start, in SI. It is empty if the scene has no number of
    /// this name, and for a pure number.
    #[must_use]
    pub fn unit_of_number(&self, name: &str) -> String {
        let number = SceneNeighbours::new(&self.current, &self.mechanism, &self.set, name);
        number
            .ok()
            .map(|number| number.unit())
            .filter(|unit| !unit.is_plain())
            .map_or_else(String::new, |unit| unit.to_string())
    }

    /// Returns the scene with other outputs, and with samples at the given instants, s. An output is the name of an
    /// output of the scene, or a formula.
    ///
    /// # Errors
    /// [`Error::Input`] if a text is neither an output of the scene nor a formula in names of the model.
    pub fn with_outputs_at(&self, outputs: &[String], instants: &[f64]) -> Result<Self, Error> {
        let mut changed = self.clone();
        let mut list = Vec::new();
        for text in outputs {
            let known = self.file.outputs.iter().find(|output| output.name == *text);
            list.push(match known {
                Some(known) => known.clone(),
                None => load_output(text, &mut changed.mechanism)?,
            });
        }
        for scene in [&mut changed.file, &mut changed.current] {
            scene.outputs.clone_from(&list);
            scene.states_outputs = true;
        }
        Ok(changed.with_instants(instants))
    }

    /// Returns the scene with samples at the given instants, s.
    pub(crate) fn with_instants(mut self, instants: &[f64]) -> Self {
        for scene in [&mut self.file, &mut self.current] {
            scene.integration.instants = instants.to_vec();
        }
        self
    }

    /// Proves that the formulations of the model are equivalent, and finds the quantities that its motions
    /// conserve.
    ///
    /// # Errors
    /// [`Error::Input`] if the model cannot be derived.
    pub fn prove(&self) -> Result<Proof, Error> {
        self.mechanism.prove()
    }

    /// Leaves out terms of the scene's equations as long as no shown quantity changes by more than the part `within` of
    /// its largest size, in runs of this scene. With other starts, parameters or spans, the differences may be larger.
    ///
    /// # Errors
    /// [`Error::Request`] if `within` is not between 0 and 1, or if the scene has impacts. [`Error::Stopped`] if the
    /// run of the whole equations fails. [`Error`] if the model cannot be derived.
    pub fn abbreviate(&self, within: f64) -> Result<Abbreviation, Error> {
        abbreviate(&self.mechanism, &self.current, within)
    }

    /// Derives the smallest set of equations that gives all outputs of the scene, and the constants of its
    /// motion.
    ///
    /// # Errors
    /// [`Error`] if the model cannot be derived, or does not determine an output of the scene.
    pub fn reduce(&self) -> Result<ReducedScene, Error> {
        ReducedScene::new(&self.mechanism, &self.current)
    }

    /// Computes reference states at the given instants to about twenty digits, with their uncertainty. The
    /// instants are in s, in the order of the run.
    ///
    /// # Errors
    /// [`Error`] if a run does not reach the last instant, or if no reference can be computed.
    pub fn reference(&self, times: &[f64]) -> Result<ReferenceSolution, Error> {
        ReferenceSolution::new(&self.mechanism, &self.current, times)
    }

    /// Runs the scene with the settings `how`. If these name no equations, the scene's reduced equations are used if
    /// they have an advantage and reach the end. Otherwise full equations are used.
    ///
    /// # Errors
    /// [`Error`] if the scene cannot be run. A run that began and stopped early is a [`Run`] that says why.
    pub fn simulate(&self, how: &Overrides) -> Result<Run, Error> {
        let mut scene = self.current.clone();
        how.apply_to_scene(&mut scene)?;
        simulate(&self.mechanism, &scene, how.by.as_ref())
    }

    /// Runs the scene by full (not reduced) equations. Returns the derivatives of its shown quantities by the
    /// numbers `names`, which are parameters and numbers of the start. `at` selects the instants of the
    /// derivatives.
    ///
    /// ```
    /// # use tripos::{DerivativeInstants, Overrides, Scene};
    /// let scene = Scene::read("../models/pendulum/scenes/over.toml")?;
    /// let slopes = scene.sensitivities(&["l", "theta"], DerivativeInstants::End, &Overrides::default())?;
    /// println!("theta at the end changes by {} rad for each metre", slopes.derivative_of("theta", "l")?);
    /// # Ok::<(), tripos::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Input`] if the scene has no number of a given name. [`Error::Request`] if the equations, the
    /// integrator or a number cannot be differentiated. Otherwise [`Error`] if the scene cannot be run.
    pub fn sensitivities(
        &self,
        names: &[&str],
        at: DerivativeInstants,
        how: &Overrides,
    ) -> Result<Sensitivities, Error> {
        let mut scene = self.current.clone();
        how.apply_to_scene(&mut scene)?;
        let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
        sensitivities(&self.mechanism, &scene, &self.set, &names, at, how.by.as_ref())
    }

    /// Runs the scene by full (not reduced) equations. Returns the derivatives of the quantity `of` at the end of
    /// the run, by all parameters and all numbers of the start. One backward sweep computes all of them.
    ///
    /// ```
    /// # use tripos::{Overrides, Scene};
    /// let scene = Scene::read("../models/pendulum/scenes/over.toml")?;
    /// let gradient = scene.gradient("theta", &Overrides::default())?;
    /// for slope in &gradient.slopes {
    ///     println!("d(theta)/d({}) = {}", slope.by, slope.value);
    /// }
    /// # Ok::<(), tripos::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Request`] if the scene shows no quantity named `of`, or if its equations cannot be
    /// differentiated. Otherwise [`Error`] if the scene cannot be run.
    pub fn gradient(&self, of: &str, how: &Overrides) -> Result<Gradient, Error> {
        let mut scene = self.current.clone();
        how.apply_to_scene(&mut scene)?;
        gradient(&self.mechanism, &scene, &self.set, of, how.by.as_ref())
    }

    /// Runs the scene with recorded signals for some of its inputs. Each value of a signal is held constant until
    /// the next instant of the signal.
    ///
    /// # Errors
    /// [`Error::Request`] if a signal does not have as many values as instants. Otherwise the errors of
    /// [`Scene::simulate_sampled`], such as for unknown inputs.
    pub fn simulate_held(&self, signals: &[HeldSignal<'_>], how: &Overrides) -> Result<SampledRun, Error> {
        let mut scene = self.current.clone();
        how.apply_to_scene(&mut scene)?;
        sampled_inputs::simulate_recorded_signals(&self.mechanism, &scene, signals, how.by.as_ref())
    }

    /// Runs the scene with inputs that a controller sets at the given instants, s, from the state at each
    /// instant. The inputs are held constant until the next instant (zero-order hold). Before the first instant,
    /// they have the scene's values.
    ///
    /// Full (not reduced) equations are used, and a step ends at each instant. A second run estimates the
    /// errors. Each run has a new controller, which may keep data between instants:
    ///
    /// ```
    /// # use tripos::{ControllerSample, Mechanism, Overrides, Scene};
    /// # let text = r#"
    /// # name = "cart"
    /// # [parameters]
    /// # m = "2 kg"
    /// # [inputs]
    /// # F = { unit = "N" }
    /// # [coordinates]
    /// # x = { unit = "m" }
    /// # [speeds]
    /// # v = "x'"
    /// # [inertial]
    /// # frame = "N"
    /// # origin = "O"
    /// # [points]
    /// # P = { from = "O", frame = "N", position = ["x", 0, 0] }
    /// # [particles]
    /// # cart = { point = "P", mass = "m" }
    /// # [forces]
    /// # push = { on = "cart", frame = "N", vector = ["F", 0, 0] }
    /// # "#;
    /// # let model = tripos_derive::model::load(&tripos_derive::diagnostic::Source::from_text("model.toml", text))?;
    /// # let scene = Scene::parse(Mechanism::new(model), "span = [0, 5]\n[start]\nx = 1\nv = 0\n")?;
    /// let every_50_ms: Vec<f64> = (0..100).map(|k| f64::from(k) * 0.05).collect();
    /// let controller = || {
    ///     let mut sum = 0.0;
    ///     move |sample: &ControllerSample<'_>| {
    ///         let (x, v) = (sample.values[0], sample.values[1]);
    ///         sum += 0.05 * x;
    ///         vec![-8.0 * x - 6.0 * v - 2.0 * sum]
    ///     }
    /// };
    /// let run = scene.simulate_sampled(&["F"], &every_50_ms, controller, &Overrides::default())?;
    /// assert_eq!(run.decisions.len(), 100);
    /// assert!(run.end[0].abs() < 0.2 && run.errors_at_end.is_some());
    /// # Ok::<(), tripos::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Request`] in these cases:
    /// - an input is unknown or has a formula;
    /// - the instants are not in order, or are outside the span;
    /// - the controller returns a wrong number of values, or a value that is not finite;
    /// - the run goes backwards in time, uses quadrature or projection, or has impacts.
    ///
    /// Otherwise the errors of [`Scene::simulate`].
    pub fn simulate_sampled<C: FnMut(&ControllerSample<'_>) -> Vec<f64>>(
        &self,
        inputs: &[&str],
        instants: &[f64],
        controller: impl Fn() -> C,
        how: &Overrides,
    ) -> Result<SampledRun, Error> {
        let mut scene = self.current.clone();
        how.apply_to_scene(&mut scene)?;
        sampled_inputs::simulate_sampled(&self.mechanism, &scene, inputs, instants, controller, how.by.as_ref())
    }
}
