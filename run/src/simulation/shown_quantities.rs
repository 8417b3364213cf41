//! Quantities that a run by full equations shows: every coordinate, every speed, and further outputs
//! of the scene.
//!
//! Invariant: an output without a value at a state is NaN, never another number. Reduced equations have
//! their own outputs ([`tripos_traits::System::outputs`]).

use crate::code::{Code, CodePreparation, compile_tape, runnable_code};
use crate::error::{Error, refused_scene_error};
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::scene::{AccelerationSolution, ENERGIES, Scene};
use tripos_derive::{Formulation, Model};
use tripos_sim::{Dynamics, EliminatedDynamics, RightHandSide};
use tripos_traits::Lengths;

/// Names of the states of a model: coordinates, then generalized speeds.
#[must_use]
pub fn state_names(model: &Model) -> Vec<String> {
    let coordinates = model.coordinates.iter().map(|c| c.name.clone());
    coordinates.chain(model.speeds.iter().map(|s| s.name.clone())).collect()
}

/// Quantities that a scene shows, computed from the states of full equations.
#[derive(Clone)]
pub struct ShownQuantities {
    /// Names of the shown quantities: coordinates, generalized speeds, then further outputs of the
    /// scene.
    pub names: Vec<String>,
    /// Outputs that are not states; `None` if the scene requests only states.
    outputs: Option<Outputs>,
}

/// Outputs of a scene as functions of p, q, q̇, u, u̇, the reactions and the energies.
#[derive(Clone)]
struct Outputs {
    /// Program that computes all further outputs of the scene.
    tape: Tape,
    /// True if an output contains an acceleration u̇.
    needs_accelerations: bool,
    /// Newton–Euler equations that give the reactions; `None` if no output needs a reaction.
    balance: Option<Code>,
    /// Indices of the energies that the outputs contain: 0 for kinetic, 1 for potential, 2 for total.
    energies: Vec<usize>,
}

impl ShownQuantities {
    /// Prepares the quantities that a scene of this model shows, and compiles its outputs.
    ///
    /// # Errors
    /// [`Error`] if an output needs a reaction that the model does not determine. Also if an output needs
    /// accelerations or reactions in a scene with impacts.
    pub fn new(model: &Mechanism, scene: &Scene) -> Result<Self, Error> {
        let mut names = state_names(model);
        let others: Vec<_> = scene.outputs.iter().filter(|o| !names.contains(&o.name)).collect();
        if others.is_empty() {
            return Ok(Self { names, outputs: None });
        }
        let (arena, values) = (&model.arena, others.iter().map(|o| o.value).collect::<Vec<_>>());
        let mentioned = |list: &[Expr]| list.iter().any(|s| values.iter().any(|e| arena.mentions(*e, *s)));
        let u_dot: Vec<Expr> = model.speeds.iter().map(|s| s.rate).collect();
        let reactions: Vec<Expr> = model.reactions.iter().map(|r| r.symbol).collect();
        let energies: Vec<(usize, Expr)> =
            ENERGIES.iter().enumerate().filter_map(|(at, name)| Some((at, arena.find_symbol(name)?))).collect();
        let inputs = [model.p(), model.q(), model.q_dot(), model.u(), u_dot.clone(), reactions.clone()].concat();
        let energies: Vec<_> = energies.into_iter().filter(|(_, symbol)| !inputs.contains(symbol)).collect();
        let inputs = inputs.into_iter().chain(energies.iter().map(|(_, symbol)| *symbol)).collect::<Vec<_>>();
        let balance = mentioned(&reactions)
            .then(|| runnable_code(model, &Formulation::NewtonEuler.into(), None, CodePreparation::AsDerived))
            .transpose()?;
        if !scene.impacts.is_empty() && (balance.is_some() || mentioned(&u_dot)) {
            let what = "accelerations and reactions are not shown in scenes with impacts: they would lack the forces of closed contacts".to_owned();
            return Err(Error::request(
                what,
                "leave accelerations and reactions out of `outputs`, or the impacts out of the scene",
            ));
        }
        let outputs = Outputs {
            tape: compile_tape(arena, &inputs, &values, "an output")?,
            needs_accelerations: mentioned(&u_dot),
            balance,
            energies: energies.into_iter().map(|(at, _)| at).collect(),
        };
        names.extend(others.iter().map(|o| o.name.clone()));
        Ok(Self { names, outputs: Some(outputs) })
    }

    /// Computes the shown quantities at the time `t`, s, in the integrated state `y` of full equations.
    ///
    /// # Errors
    /// [`Error::Request`] if the number of parameters does not fit the equations.
    pub fn of(&self, problem: &Problem<'_>, t: f64, y: &[f64]) -> Result<Vec<f64>, Error> {
        let state = problem.shown_state(t, y);
        match &self.outputs {
            None => Ok(state),
            Some(outputs) => {
                let values = outputs.of(problem, &state, t, y)?;
                Ok([state, values].concat())
            }
        }
    }
}

impl Outputs {
    /// Computes the further outputs in the integrated state `y`. `state` has the coordinates and
    /// generalized speeds of this state.
    fn of(&self, problem: &Problem<'_>, state: &[f64], t: f64, y: &[f64]) -> Result<Vec<f64>, Error> {
        let (system, p) = (problem.system(), problem.scene.parameters.as_slice());
        let (variables, v) = y.split_at(system.lengths().coordinates);
        let (q, u) = state.split_at(system.lengths().coordinates);
        let mut q_dot = vec![0.0; q.len()];
        system.coordinate_rates(p, variables, v, &mut q_dot);
        let u_dot = self.accelerations(problem, t, y)?;
        let reactions = self.reactions(problem, q, u)?;
        let (kinetic, potential) = (system.kinetic_energy(p, variables, v), system.potential_energy(p, variables));
        let energies = [kinetic, potential, kinetic + potential];
        let energies: Vec<f64> = self.energies.iter().map(|at| energies[*at]).collect();
        Ok(self.tape.evaluate(&[p, q, &q_dot, u, &u_dot, &reactions, &energies].concat()))
    }

    /// Accelerations u̇, found by the method of the run. NaN if no output needs them, or if they have no
    /// value.
    ///
    /// # Errors
    /// `Error::Request` if the number of parameters does not fit the equations.
    fn accelerations(&self, problem: &Problem<'_>, t: f64, y: &[f64]) -> Result<Vec<f64>, Error> {
        let (system, p) = (problem.system(), problem.scene.parameters.as_slice());
        let Lengths { coordinates: n, speeds, .. } = system.lengths();
        let mut u_dot = vec![f64::NAN; speeds];
        if !self.needs_accelerations {
            return Ok(u_dot);
        }
        let mut rhs: Box<dyn RightHandSide<f64> + '_> = match EliminatedDynamics::new(system, p) {
            Some(rhs) if problem.solve == AccelerationSolution::Eliminated => Box::new(rhs),
            _ => Box::new(problem.dynamics().map_err(|error| refused_scene_error(problem.scene, &error))?),
        };
        let mut rates = vec![0.0; y.len()];
        // At a state without accelerations, NaN is shown; the run reports why it stops there.
        if rhs.rhs(t, y, &mut rates).is_ok() {
            system.generalized_speed_rates(p, &y[..n], &y[n..], &rates[n..], &mut u_dot);
        }
        Ok(u_dot)
    }

    /// Values of all reactions of the model. NaN if no output needs them, or if they have no value.
    ///
    /// # Errors
    /// `Error::Request` if the number of parameters does not fit the equations.
    fn reactions(&self, problem: &Problem<'_>, q: &[f64], u: &[f64]) -> Result<Vec<f64>, Error> {
        let count = problem.model.reactions.len();
        let Some(balance) = &self.balance else { return Ok(vec![f64::NAN; count]) };
        let mut dynamics = Dynamics::new(balance.system(), &problem.scene.parameters)
            .map_err(|error| refused_scene_error(problem.scene, &error))?;
        let unknowns = dynamics.unknowns(q, u);
        Ok(unknowns.map_or_else(|_| vec![f64::NAN; count], |x| x[u.len()..].to_vec()))
    }
}
