//! A scene's own equations, ready to be run: the least system that gives what the scene asks for.

use crate::code::{Code, Ready, compiled_scene, interpreted_scene, tape};
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::start::known;
use crate::turned::turned;
use tripos_codegen::plan::{Costs, costs};
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::mechanics::By;
use tripos_derive::reduce::{Ground, Quantity, Reduction};
use tripos_derive::scene::{Exact, Scene, SceneEvent, Stated};
use tripos_traits::{AbsoluteTolerance, DoubleDouble};

/// The reduced equations of a scene, and the scene in their variables.
pub struct Reduced {
    /// The equations.
    pub reduction: Reduction,
    /// The scene in the variables of the reduced model, the momenta among its parameters.
    pub scene: Scene,
    /// How the equations are called.
    pub by: By,
}

impl Reduced {
    /// The reduced equations of a scene of this model.
    ///
    /// # Errors
    /// [`Error`] if the model cannot be derived, or the scene asks for what it does not determine.
    pub fn new(model: &Model, scene: &Scene) -> Result<Self, Error> {
        let ground = Ground::new(model).map_err(|error| model.diagnose(&error))?;
        Self::of_ground(&ground, model, scene)
    }

    /// The reduced equations of a scene of the model that `ground` was derived from.
    ///
    /// # Errors
    /// [`Error`] if the scene asks for what the model does not determine.
    pub fn of_ground(ground: &Ground, model: &Model, scene: &Scene) -> Result<Self, Error> {
        let reduction = ground.reduce(scene).map_err(|error| model.diagnose(&error))?;
        let turns = reduction.frame.is_some();
        match Self::with(reduction, model, scene) {
            // Not every start can be turned to where the frame is.
            Err(Error::Stopped(_)) if turns => {
                let plain = ground.reduce_without_frame(scene).map_err(|error| model.diagnose(&error))?;
                Self::with(plain, model, scene)
            }
            found => found,
        }
    }

    /// Without momenta, so that nothing is singular but where the model's own equations are.
    ///
    /// # Errors
    /// As [`Reduced::of_ground`].
    pub fn without_momenta(ground: &Ground, model: &Model, scene: &Scene) -> Result<Self, Error> {
        let reduction = ground.reduce_without_momenta(scene).map_err(|error| model.diagnose(&error))?;
        Self::with(reduction, model, scene)
    }

    /// The equations from the start of another scene: one with other numbers.
    ///
    /// What the reduction was made from must be the same: model, outputs, events and parameters.
    ///
    /// # Errors
    /// [`Error::Request`] if a variable depends on what has no value at the start; [`Error::Stopped`] if the start cannot be
    /// turned to where its moving frame is.
    pub fn with(reduction: Reduction, model: &Model, scene: &Scene) -> Result<Self, Error> {
        let [parameters, q, v] = start(&reduction, model, &scene.exact)?;
        let doubles = |list: &[DoubleDouble]| list.iter().map(|x| x.hi()).collect::<Vec<_>>();
        let mut integration = scene.integration.clone();
        integration.distance = None;
        if let AbsoluteTolerance::Each(each) = &integration.atol {
            integration.atol = AbsoluteTolerance::Each(tolerances(&reduction, model, each));
        }
        let events = scene.events.iter().zip(&reduction.events);
        let own = Scene {
            parameters: doubles(&parameters),
            q: doubles(&q),
            u: doubles(&v),
            exact: Exact { rational: vec![None; parameters.len()], parameters, q, motion: Stated::Speeds(v) },
            integration,
            ladder: None,
            events: events.map(|(event, function)| SceneEvent { function: *function, ..event.clone() }).collect(),
            ..scene.clone()
        };
        Ok(Self { reduction, scene: own, by: By::Reduced })
    }

    /// The equations, ready to run: compiled in if they were generated from what this scene says.
    ///
    /// # Errors
    /// [`Error`] if they cannot be interpreted.
    pub fn code(&self, mechanism: &Mechanism) -> Result<Code, Error> {
        match compiled_scene(mechanism, &self.reduction, Ready::for_runs(&self.scene)?) {
            Some(code) => Ok(code),
            None => interpreted_scene(&self.reduction),
        }
    }

    /// Why these equations are no gain over the whole ones: they carry as many variables along, and a call costs as
    /// much or more. Nothing if they are a gain.
    ///
    /// # Errors
    /// [`Error`] if Kane's equations of the model cannot be had.
    pub fn no_gain(&self, model: &Model) -> Result<Option<String>, Error> {
        if !self.scene.impacts.is_empty() {
            return Ok(Some("impacts change what the scene's own equations hold constant".to_owned()));
        }
        let whole = model.coordinates.len() + model.speeds.len();
        if self.reduction.states.len() + self.reduction.quadratures.len() < whole {
            return Ok(None);
        }
        let Costs { full, scene } = costs(model, &self.reduction).map_err(|error| model.diagnose(&error))?;
        Ok((scene.weight() >= full.weight()).then(|| {
            format!(
                "the scene's own equations carry all {whole} variables and take {scene} a call, the whole ones {full}"
            )
        }))
    }

    /// The constants of the motion, with their values.
    pub fn constants(&self) -> impl Iterator<Item = (&Quantity, f64)> {
        let first = self.scene.parameters.len() - self.reduction.constants.len();
        self.reduction.constants.iter().zip(self.scene.parameters[first..].iter().copied())
    }
}

/// Parameters, coordinates and motion variables of a reduced system at the start, from the scene's own numbers.
fn start(reduction: &Reduction, model: &Model, exact: &Exact) -> Result<[Vec<DoubleDouble>; 3], Error> {
    let (mut symbols, mut values) = known(model, exact)?;
    if let Some(frame) = &reduction.frame {
        let count = model.parameters.len() + model.coordinates.len() + model.speeds.len();
        // Rates that the file states are those before the turn; the speeds say the same.
        symbols.truncate(count);
        values.truncate(count);
        let states = values.split_off(model.parameters.len());
        let turned = turned(reduction.terms(), frame, &symbols, (&values, &states))?;
        values.extend(turned);
    }
    let free = reduction.model.parameters.len() - reduction.constants.len();
    let equations = &reduction.derivation.equations;
    let variables = || reduction.states.iter().chain(&reduction.quadratures);
    let of_start = |symbol: &Expr| variables().find(|q| q.symbol == *symbol).map_or(*symbol, |q| q.of_start);
    let mut wanted: Vec<Expr> = reduction.model.parameters[..free].iter().map(|p| p.symbol).collect();
    wanted.extend(reduction.constants.iter().map(|constant| constant.of_start));
    wanted.extend(equations.coordinates.iter().chain(&equations.variables).map(of_start));
    let tape = tape(reduction.terms(), &symbols, &wanted, "the start of a reduced variable")?.to();
    let mut parameters: Vec<DoubleDouble> = tape.evaluate(&values);
    let mut q = parameters.split_off(reduction.model.parameters.len());
    let v = q.split_off(equations.coordinates.len());
    Ok([parameters, q, v])
}

/// The tolerance of each reduced variable: that of the variable that it is or stands for.
fn tolerances(reduction: &Reduction, model: &Model, each: &[f64]) -> Vec<f64> {
    let arena = reduction.terms();
    let own: Vec<_> = model.q().into_iter().chain(model.u()).collect();
    let equations = &reduction.derivation.equations;
    let all = || reduction.states.iter().chain(&reduction.quadratures);
    let of = |symbol: &Expr| {
        let start = all().find(|q| q.symbol == *symbol).map_or(*symbol, |q| q.of_start);
        let mentioned = own.iter().zip(each).filter(|(e, _)| arena.mentions(start, **e)).map(|(_, x)| *x);
        mentioned.fold(f64::INFINITY, f64::min)
    };
    equations.coordinates.iter().chain(&equations.variables).map(of).collect()
}
