//! Quantities by which runs are compared: every coordinate and speed, or the outputs that the scene
//! requests.
//!
//! Invariant: a compared quantity is a function of the state of the whole model. So all equations are
//! compared in the same quantities. Outputs that need accelerations or reactions are left out. The
//! summary names them.

use crate::code::compile_tape_with_steps;
use crate::error::Error;
use crate::preparation::problem::Problem;
use tripos_derive::algebra::term::steps::{Definition, needed_steps};
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Expr, Node};
use tripos_derive::mechanics::derive;
use tripos_derive::scene::{ENERGIES, Scene, SceneOutput};
use tripos_derive::{Formulation, Model};
use tripos_traits::DoubleDouble;

/// Quantities by which the runs of a scene are compared.
pub struct ComparedQuantities {
    /// Outputs of the scene. `None` if the scene requests no outputs, so that whole states are compared.
    outputs: Option<Outputs>,
}

/// Outputs of a scene as functions of the coordinates and generalized speeds of the whole model.
struct Outputs {
    /// Values of the parameters, to 32 digits.
    parameters: Vec<DoubleDouble>,
    /// Program that computes the comparable outputs from parameters, coordinates and generalized speeds.
    tape: Tape<DoubleDouble>,
    /// All outputs of the scene, comparable or not, in the order of the scene.
    list: Vec<ComparedOutput>,
}

/// Output of a scene, and a flag that tells if it can be compared.
struct ComparedOutput {
    /// Name of the output in the scene.
    name: String,
    /// True if the output is a function of the state, so that it can be compared.
    is_known: bool,
}

impl ComparedQuantities {
    /// Chooses the quantities by which runs of a scene of this model are compared.
    ///
    /// # Errors
    /// [`Error::Input`] if the scene has an energy as output and the model cannot be derived.
    pub fn new(model: &Model, scene: &Scene) -> Result<Self, Error> {
        let outputs = scene.states_outputs.then(|| Outputs::new(model, scene)).transpose()?;
        Ok(Self { outputs })
    }

    /// Compared quantities at a state (q, u) of the whole model: the outputs of the scene, or the state
    /// itself if the scene requests no outputs. An output that cannot be compared is NaN.
    #[must_use]
    pub fn quantities_of_state(&self, state: &[DoubleDouble]) -> Vec<DoubleDouble> {
        match &self.outputs {
            Some(outputs) => outputs.values(state),
            None => state.to_vec(),
        }
    }

    /// Selects the comparable values from the values of all compared quantities. An output that needs
    /// accelerations or reactions is left out.
    #[must_use]
    pub fn comparable_quantities(&self, values: Vec<DoubleDouble>) -> Vec<DoubleDouble> {
        match &self.outputs {
            Some(outputs) => {
                values.into_iter().zip(&outputs.list).filter(|(_, o)| o.is_known).map(|(x, _)| x).collect()
            }
            None => values,
        }
    }

    /// Compared quantities at time `t`, s, in the integrated state `y` of any set of equations.
    #[must_use]
    pub fn quantities_of_run(&self, problem: &Problem<'_>, t: f64, y: &[f64]) -> Vec<DoubleDouble> {
        let shown = problem.precise_state(t, y);
        self.comparable_quantities(if problem.by.is_reduced() { shown } else { self.quantities_of_state(&shown) })
    }

    /// True if the scene requests outputs but none of them can be compared.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.outputs.as_ref().is_some_and(|outputs| outputs.list.iter().all(|o| !o.is_known))
    }

    /// Sentence that names the compared outputs and the outputs that are left out. `None` if whole states
    /// are compared.
    #[must_use]
    pub fn in_words(&self) -> Option<String> {
        let list = &self.outputs.as_ref()?.list;
        let names = |known: bool| {
            let names = list.iter().filter(|o| o.is_known == known).map(|o| o.name.as_str());
            names.collect::<Vec<_>>().join(", ")
        };
        let left_out = names(false);
        let more = if left_out.is_empty() {
            String::new()
        } else {
            format!(" Not compared, since whole states do not show accelerations and reactions: {left_out}.")
        };
        Some(match names(true).as_str() {
            "" => format!("Errors are those of all states.{more}"),
            known => format!("Errors are those of the scene's outputs: {known}.{more}"),
        })
    }
}

impl Outputs {
    /// Compiles the outputs of a scene that are functions of the state.
    ///
    /// # Errors
    /// `Error::Input` if an output is an energy and the model cannot be derived.
    fn new(model: &Model, scene: &Scene) -> Result<Self, Error> {
        let mut arena = model.arena.clone();
        let pairs = model.q_dot().into_iter().zip(model.kinematic_equations.rates.iter().copied());
        let mut steps: Vec<Definition> = pairs.map(|(symbol, value)| Definition { symbol, value }).collect();
        let symbols = ENERGIES.map(|name| arena.find_symbol(name));
        if symbols.iter().flatten().any(|s| scene.outputs.iter().any(|o| arena.mentions(o.value, *s))) {
            let mut kane = derive(model, Formulation::Kane).map_err(|error| Error::Input(model.diagnose(&error)))?;
            let (kinetic, potential) = (kane.equations.kinetic_energy, kane.equations.potential_energy);
            let total = kane.arena.add(kinetic, potential);
            let pairs = symbols.into_iter().zip([kinetic, potential, total]);
            steps.extend(pairs.filter_map(|(symbol, value)| Some(Definition { symbol: symbol?, value })));
            arena = kane.arena;
        }
        let inputs = [model.p(), model.q(), model.u()].concat();
        let is_known = |value: Expr| {
            let defined = |e: &Expr| inputs.contains(e) || steps.iter().any(|step| step.symbol == *e);
            let is_symbol = |e: &Expr| matches!(arena.node(*e), Node::Symbol(_));
            arena.reachable(&[value]).iter().filter(|e| is_symbol(e)).all(defined)
        };
        let shown = |o: &SceneOutput| ComparedOutput { name: o.name.clone(), is_known: is_known(o.value) };
        let list: Vec<ComparedOutput> = scene.outputs.iter().map(shown).collect();
        let known = scene.outputs.iter().zip(&list).filter(|(_, shown)| shown.is_known);
        let values: Vec<Expr> = known.map(|(output, _)| output.value).collect();
        let steps = needed_steps(&arena, &steps, &values);
        let tape = compile_tape_with_steps(&arena, &inputs, &steps, &values, "an output")?.to();
        Ok(Self { parameters: scene.exact.parameters.clone(), tape, list })
    }

    /// Values of all outputs at a state (q, u). An output that cannot be compared is NaN.
    fn values(&self, state: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let mut known = self.tape.evaluate(&[&self.parameters, state].concat()).into_iter();
        let value = |shown: &ComparedOutput| if shown.is_known { known.next() } else { None };
        self.list.iter().map(value).map(|value| value.unwrap_or(DoubleDouble::NAN)).collect()
    }
}
