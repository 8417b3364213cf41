//! In what runs are compared: in every coordinate and speed, or in what the scene wants to see.
//!
//! Invariant: what is compared is a function of the state of the whole model, so that all equations are compared in the
//! same. Accelerations and reactions are not: an output that needs them is left out, and named.

use crate::problem::{Problem, wide};
use crate::wide::values;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::derive;
use tripos_derive::scene::Scene;
use tripos_derive::{Formulation, Model};
use tripos_traits::{DoubleDouble, Scalar};

/// What is compared in the runs of a scene.
pub struct Compared {
    /// Nothing if the scene does not say what it wants to see: then it is the state.
    outputs: Option<Outputs>,
}

/// What a scene wants to see, as functions of the whole state.
struct Outputs {
    arena: Arena,
    /// Parameters with their values, then the symbols of coordinates and speeds.
    parameters: Vec<(Expr, DoubleDouble)>,
    states: Vec<Expr>,
    rates: Vec<(Expr, Expr)>,
    energies: Vec<(Expr, Expr)>,
    list: Vec<Shown>,
}

struct Shown {
    name: String,
    value: Expr,
    is_known: bool,
}

impl Compared {
    /// Of a scene of this model.
    #[must_use]
    pub fn new(model: &Model, scene: &Scene) -> Self {
        Self { outputs: scene.states_outputs.then(|| Outputs::new(model, scene)) }
    }

    /// What a state of the whole model shows: one value for each output, not a number for those that are left out.
    #[must_use]
    pub fn of_state(&self, state: &[DoubleDouble]) -> Vec<DoubleDouble> {
        match &self.outputs {
            Some(outputs) => outputs.values(state),
            None => state.to_vec(),
        }
    }

    /// What is compared of values for each output: those that are not left out.
    #[must_use]
    pub fn kept(&self, values: Vec<DoubleDouble>) -> Vec<DoubleDouble> {
        match &self.outputs {
            Some(outputs) => {
                values.into_iter().zip(&outputs.list).filter(|(_, o)| o.is_known).map(|(x, _)| x).collect()
            }
            None => values,
        }
    }

    /// The same of an integrated state, whichever equations it is of.
    #[must_use]
    pub fn of_run(&self, problem: &Problem<'_>, t: f64, y: &[f64]) -> Vec<DoubleDouble> {
        let shown = problem.precise_state(t, y);
        self.kept(if problem.by.is_reduced() { shown } else { self.of_state(&shown) })
    }

    /// Whether there is anything to compare.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.outputs.as_ref().is_some_and(|outputs| outputs.list.iter().all(|o| !o.is_known))
    }

    /// In what runs are compared, as a sentence; nothing if it is all states.
    #[must_use]
    pub fn said(&self) -> Option<String> {
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
            known => format!("Errors are those of what the scene wants to see: {known}.{more}"),
        })
    }
}

impl Outputs {
    fn new(model: &Model, scene: &Scene) -> Self {
        let exact = &scene.exact.parameters;
        let parameters = model.p().into_iter().zip(exact.iter().map(wide)).collect();
        let mut arena = model.arena.clone();
        let rates = model.q_dot().into_iter().zip(model.kinematic_equations.rates.iter().copied()).collect();
        let mut energies = Vec::new();
        let symbols = ["kinetic_energy", "potential_energy", "total_energy"].map(|name| arena.find_symbol(name));
        let mentioned = symbols.iter().flatten().any(|s| scene.outputs.iter().any(|o| arena.mentions(o.value, *s)));
        if let (true, Ok(mut kane)) = (mentioned, derive(model, Formulation::Kane)) {
            let (kinetic, potential) = (kane.equations.kinetic_energy, kane.equations.potential_energy);
            let total = kane.arena.add(kinetic, potential);
            let pairs = symbols.into_iter().zip([kinetic, potential, total]);
            energies = pairs.filter_map(|(symbol, value)| Some((symbol?, value))).collect();
            arena = kane.arena;
        }
        let mut own =
            Self { arena, parameters, states: [model.q(), model.u()].concat(), rates, energies, list: Vec::new() };
        let known = [own.parameters.iter().map(|(e, _)| *e).collect(), own.states.clone()].concat();
        let known = [own.rates.iter().chain(&own.energies).map(|(e, _)| *e).collect(), known].concat();
        let list = scene.outputs.iter().map(|o| {
            let symbols = own.arena.reachable(&[o.value]);
            let is_symbol = |e: &Expr| matches!(own.arena.node(*e), tripos_derive::algebra::Node::Symbol(_));
            let is_known = symbols.iter().filter(|e| is_symbol(e)).all(|e| known.contains(e));
            Shown { name: o.name.clone(), value: o.value, is_known }
        });
        own.list = list.collect();
        own
    }

    fn values(&self, state: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let mut known = self.parameters.clone();
        known.extend(self.states.iter().copied().zip(state.iter().copied()));
        for list in [&self.rates, &self.energies] {
            let terms: Vec<Expr> = list.iter().map(|(_, value)| *value).collect();
            let found = values(&self.arena, &terms, &known);
            known.extend(list.iter().map(|(symbol, _)| *symbol).zip(found));
        }
        let terms: Vec<Expr> = self.list.iter().map(|o| o.value).collect();
        let found = values(&self.arena, &terms, &known);
        let shown = found.into_iter().zip(&self.list);
        shown.map(|(x, o)| if o.is_known { x } else { DoubleDouble::from_f64(f64::NAN) }).collect()
    }
}
