//! A scene's own equations, ready to be run: the least system that gives what the scene asks for.

use crate::code::{By, Code, compiled_scene, interpreted_scene};
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::problem::wide;
use crate::wide::values;
use tripos_derive::Model;
use tripos_derive::reduce::{Quantity, Reduction, reduce, reduce_without_momenta};
use tripos_derive::scene::{AbsoluteTolerance, Exact, Extended, Motion, Scene, SceneEvent};
use tripos_traits::{DoubleDouble, Real, Scalar};

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
    /// Of a scene of this model.
    ///
    /// # Errors
    /// [`Error`] if the model cannot be derived, or the scene asks for what it does not determine.
    pub fn new(model: &Model, scene: &Scene) -> Result<Self, Error> {
        let reduction = reduce(model, scene).map_err(|error| model.diagnose(&error))?;
        Ok(Self::with(reduction, model, scene))
    }

    /// The same without momenta, which are singular nowhere but where the model's own equations are.
    ///
    /// # Errors
    /// As [`Reduced::new`].
    pub fn without_momenta(model: &Model, scene: &Scene) -> Result<Self, Error> {
        let reduction = reduce_without_momenta(model, scene).map_err(|error| model.diagnose(&error))?;
        Ok(Self::with(reduction, model, scene))
    }

    /// The same equations from the start of another scene: one with other numbers.
    ///
    /// What the reduction was made from must be the same: model, outputs, events and parameters.
    #[must_use]
    pub fn with(reduction: Reduction, model: &Model, scene: &Scene) -> Self {
        let start = Start::of(&reduction, model, scene);
        let number = |x: &DoubleDouble| x.to_f64();
        let doubles = |list: &[DoubleDouble]| list.iter().map(number).collect::<Vec<_>>();
        let exact = Exact {
            parameters: extended(&start.parameters),
            rational: vec![None; start.parameters.len()],
            q: extended(&start.q),
            motion: Motion::Speeds(extended(&start.u)),
        };
        let mut integration = scene.integration.clone();
        integration.distance = None;
        if let AbsoluteTolerance::Each(each) = &integration.atol {
            integration.atol = AbsoluteTolerance::Each(tolerances(&reduction, model, each));
        }
        let events = scene.events.iter().zip(&reduction.events);
        let own = Scene {
            parameters: doubles(&start.parameters),
            q: doubles(&start.q),
            u: doubles(&start.u),
            exact,
            integration,
            ladder: None,
            events: events.map(|(event, function)| SceneEvent { function: *function, ..event.clone() }).collect(),
            ..scene.clone()
        };
        Self { reduction, scene: own, by: By::reduced() }
    }

    /// The equations, ready to run: compiled in if they were generated from what this scene says.
    ///
    /// # Errors
    /// [`Error`] if they cannot be interpreted.
    pub fn code(&self, mechanism: &Mechanism) -> Result<Code, Error> {
        match compiled_scene(mechanism, &self.reduction) {
            Some(code) => Ok(code),
            None => interpreted_scene(&self.reduction),
        }
    }

    /// The constants of the motion, with their values.
    pub fn constants(&self) -> impl Iterator<Item = (&Quantity, f64)> {
        let first = self.scene.parameters.len() - self.reduction.constants.len();
        self.reduction.constants.iter().zip(self.scene.parameters[first..].iter().copied())
    }
}

/// Parameters and variables of a reduced system at the start.
struct Start {
    parameters: Vec<DoubleDouble>,
    q: Vec<DoubleDouble>,
    u: Vec<DoubleDouble>,
}

impl Start {
    /// From the scene's own numbers, in twice the precision of a double: a momentum near a singular surface is a small
    /// difference.
    fn of(reduction: &Reduction, model: &Model, scene: &Scene) -> Self {
        let arena = reduction.terms();
        let exact = &scene.exact;
        let numbers = |symbols: Vec<tripos_derive::algebra::Expr>, list: &[Extended]| -> Vec<_> {
            symbols.into_iter().zip(list.iter().map(wide)).collect()
        };
        let mut known = [numbers(model.p(), &exact.parameters), numbers(model.q(), &exact.q)].concat();
        match &exact.motion {
            Motion::Speeds(u) => known.extend(numbers(model.u(), u)),
            Motion::Rates(rates) => {
                known.extend(numbers(model.q_dot(), rates));
                let definitions: Vec<_> = model.speeds.iter().map(|s| s.definition).collect();
                let u = values(&model.arena, &definitions, &known);
                known.extend(model.u().into_iter().zip(u));
            }
        }
        let of = |list: &[&Quantity]| values(arena, &list.iter().map(|q| q.of_start).collect::<Vec<_>>(), &known);
        let free = reduction.model.parameters.len() - reduction.constants.len();
        let mut parameters: Vec<DoubleDouble> = reduction.model.parameters[..free]
            .iter()
            .map(|p| known.iter().find(|(e, _)| *e == p.symbol).map_or(DoubleDouble::from_f64(f64::NAN), |(_, x)| *x))
            .collect();
        parameters.extend(of(&reduction.constants.iter().collect::<Vec<_>>()));
        let variables = || reduction.states.iter().chain(&reduction.quadratures);
        let equations = &reduction.derivation.equations;
        let quantities = |symbols: &[tripos_derive::algebra::Expr]| -> Vec<&Quantity> {
            symbols.iter().filter_map(|s| variables().find(|q| q.symbol == *s)).collect()
        };
        Self { parameters, q: of(&quantities(&equations.coordinates)), u: of(&quantities(&equations.variables)) }
    }
}

fn extended(list: &[DoubleDouble]) -> Vec<Extended> {
    list.iter().map(|x| Extended { high: x.hi(), low: x.lo() }).collect()
}

/// The tolerance of each reduced variable: that of the variable that it is or stands for.
fn tolerances(reduction: &Reduction, model: &Model, each: &[f64]) -> Vec<f64> {
    let arena = reduction.terms();
    let own: Vec<_> = model.q().into_iter().chain(model.u()).collect();
    let equations = &reduction.derivation.equations;
    let all = || reduction.states.iter().chain(&reduction.quadratures);
    let of = |symbol: &tripos_derive::algebra::Expr| {
        let start = all().find(|q| q.symbol == *symbol).map_or(*symbol, |q| q.of_start);
        let mentioned = own.iter().zip(each).filter(|(e, _)| arena.mentions(start, **e)).map(|(_, x)| *x);
        mentioned.fold(f64::INFINITY, f64::min)
    };
    equations.coordinates.iter().chain(&equations.variables).map(of).collect()
}
