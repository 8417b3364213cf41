//! Derivatives of the quantities that a run shows, from the derivatives of its states.
//!
//! A coordinate has the derivative of its component of the state, and so has a speed that is
//! integrated. Every other quantity is a function of parameters and state. Its derivative is a
//! difference in 32 digits ([`super::difference`]), so the quantity need not be defined a second time.

use super::difference::directional_difference;
use crate::code::{Code, CodePreparation, compile_tape, runnable_code};
use crate::error::{Error, refused_scene_error};
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use crate::simulation::shown_quantities::state_names;
use tripos_derive::Formulation;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::model::Unit;
use tripos_derive::scene::{ENERGIES, Scene};
use tripos_sim::Dynamics;
use tripos_sim::linear::{self, MatrixKind};
use tripos_traits::{DoubleDouble, Lengths, Scalar};

/// Quantities of a run that are differentiated: the shown quantities, the energies, and the functions
/// whose zeros are events.
pub struct DifferentiableQuantities {
    /// Names of the quantities: coordinates, generalized speeds, other outputs, kinetic energy and
    /// potential energy, in this order.
    pub names: Vec<String>,
    /// Units of the quantities, in the order of `names`; `None` if a unit is not known.
    pub units: Vec<Option<Unit>>,
    /// Number of coordinates and generalized speeds together. They come first in `names`.
    states: usize,
    /// Tape of the other outputs, followed by the watched functions. These are the conditions of the
    /// domain and the functions of the scene's events.
    tape: Tape<DoubleDouble>,
    /// Number of outputs that are neither coordinates nor speeds.
    outputs: usize,
    /// True if an output or a watched function depends on accelerations.
    needs_accelerations: bool,
    /// Indices in [`ENERGIES`] of the energies that are inputs of the tape.
    energies: Vec<usize>,
    /// Newton–Euler equations, which give the reactions; `None` if no quantity depends on a reaction.
    balance: Option<Code>,
}

/// State of a run at which derivatives are taken, with the reactions there if a quantity depends on a
/// reaction.
pub struct StateWithReactions<'a> {
    /// Scene with its equations of motion.
    problem: &'a Problem<'a>,
    /// Integrated state (q, v).
    y: &'a [f64],
    /// Unknowns of the Newton–Euler equations: accelerations, then reactions. Empty if no quantity depends
    /// on a reaction.
    reactions: Vec<f64>,
}

/// Derivatives of the shown quantities and the watched functions, in a direction of parameters and
/// state.
pub struct QuantityDerivatives {
    /// Derivatives of the shown quantities, in the order of [`DifferentiableQuantities::names`].
    pub shown: Vec<f64>,
    /// Derivatives of the watched functions: conditions of the domain, then events of the scene.
    pub watched: Vec<f64>,
}

impl DifferentiableQuantities {
    /// Prepares the quantities of a scene's runs for derivatives.
    ///
    /// # Errors
    /// [`Error`] if an output contains a symbol without a value, or if the Newton–Euler equations are
    /// needed and cannot be derived.
    pub fn new(mechanism: &Mechanism, scene: &Scene) -> Result<Self, Error> {
        let (model, arena) = (&mechanism.model, &mechanism.arena);
        let mut names = state_names(model);
        let mut units: Vec<Option<Unit>> = model.coordinates.iter().map(|c| Some(c.unit.clone())).collect();
        units.extend(model.speeds.iter().map(|s| Some(s.unit.clone())));
        let states = names.len();
        let others: Vec<_> = scene.outputs.iter().filter(|o| !names.contains(&o.name)).collect();
        names.extend(others.iter().map(|o| o.name.clone()));
        units.extend(others.iter().map(|o| model.unit_of(arena, o.value)));
        names.extend(
            ENERGIES[..2].iter().filter(|name| !others.iter().any(|o| o.name == **name)).map(|n| (*n).to_owned()),
        );
        units.resize(names.len(), Some(Unit::new(2, 1, -2)));
        let watched = model.domain.iter().map(|c| c.positive).chain(scene.events.iter().map(|e| e.function));
        let values: Vec<Expr> = others.iter().map(|o| o.value).chain(watched).collect();
        let mentioned = |list: &[Expr]| list.iter().any(|s| values.iter().any(|e| arena.mentions(*e, *s)));
        let u_dot: Vec<Expr> = model.speeds.iter().map(|s| s.rate).collect();
        let reactions: Vec<Expr> = model.reactions.iter().map(|r| r.symbol).collect();
        let inputs = [model.p(), model.q(), model.q_dot(), model.u(), u_dot.clone(), reactions.clone()].concat();
        let energies = ENERGIES.iter().enumerate().filter_map(|(at, name)| Some((at, arena.find_symbol(name)?)));
        let energies: Vec<_> = energies.filter(|(_, symbol)| !inputs.contains(symbol)).collect();
        let inputs: Vec<Expr> = inputs.into_iter().chain(energies.iter().map(|(_, symbol)| *symbol)).collect();
        let needs_balance = mentioned(&reactions);
        let balance = needs_balance
            .then(|| runnable_code(mechanism, &Formulation::NewtonEuler.into(), None, CodePreparation::AsDerived));
        Ok(Self {
            tape: compile_tape(arena, &inputs, &values, "an output")?.to(),
            outputs: others.len(),
            needs_accelerations: mentioned(&u_dot),
            energies: energies.into_iter().map(|(at, _)| at).collect(),
            balance: balance.transpose()?,
            names,
            units,
            states,
        })
    }

    /// Number of watched functions: the conditions of the domain and the events of the scene.
    pub fn watched_function_count(&self) -> usize {
        self.tape.outputs() - self.outputs
    }

    /// Prepares the integrated state `y` at time `t`, s, for derivatives. Computes the reactions there if
    /// a quantity depends on a reaction. They are NaN if the model does not determine them.
    ///
    /// # Errors
    /// [`Error::Request`] if the number of parameters does not fit the equations.
    pub fn prepare_state<'a>(
        &self,
        problem: &'a Problem<'a>,
        t: f64,
        y: &'a [f64],
    ) -> Result<StateWithReactions<'a>, Error> {
        let mut reactions = Vec::new();
        if let Some(balance) = &self.balance {
            let state = problem.shown_state(t, y);
            let (q, u) = state.split_at(problem.system().lengths().coordinates);
            let parameters = &problem.scene.parameters;
            let mut dynamics = Dynamics::new(balance.system(), parameters)
                .map_err(|error| refused_scene_error(problem.scene, &error))?;
            let order = balance.system().lengths().unknowns();
            reactions = dynamics.unknowns(q, u).map_or_else(|_| vec![f64::NAN; order], <[f64]>::to_vec);
        }
        Ok(StateWithReactions { problem, y, reactions })
    }

    /// Computes the derivatives of all quantities in a direction, with components for the parameters and
    /// the integrated state.
    pub fn quantity_derivatives(
        &self,
        place: &StateWithReactions<'_>,
        parameters: &[f64],
        state: &[f64],
    ) -> QuantityDerivatives {
        let problem = place.problem;
        let moved = self.directly_shown_derivatives(problem, state);
        let unknowns = self.reaction_derivatives(place, parameters, state);
        let x = [&problem.scene.parameters[..], place.y, &place.reactions].concat();
        let direction = [parameters, state, &unknowns].concat();
        let mut all = directional_difference(&x, &direction, |x| self.values(problem, x));
        let watched = all.split_off(self.names.len());
        all[..moved.len()].copy_from_slice(&moved);
        QuantityDerivatives { shown: all, watched }
    }

    /// Derivatives of the components of the state that are shown unchanged: the coordinates, and the
    /// speeds if they are integrated.
    fn directly_shown_derivatives(&self, problem: &Problem<'_>, state: &[f64]) -> Vec<f64> {
        let is_rate = problem.by.formulation().is_some_and(Formulation::is_in_rates);
        let known = if is_rate { problem.model.coordinates.len() } else { self.states };
        state[..known].to_vec()
    }

    /// Computes all quantities in 32 digits. `x` joins the parameters, the integrated state, and the
    /// unknowns of the Newton–Euler equations.
    fn values(&self, problem: &Problem<'_>, x: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let system = problem.code.extended();
        let Lengths { parameters, coordinates: n, speeds, .. } = system.lengths();
        let (p, rest) = x.split_at(parameters);
        let (y, unknowns) = rest.split_at(system.lengths().state());
        let (variables, v) = y.split_at(n);
        let zeros = |count: usize| vec![DoubleDouble::int(0); count];
        let state = problem.extended_state(p, problem.scene.span.0, y);
        let (mut q_dot, mut v_dot, mut u_dot) = (zeros(n), zeros(v.len()), zeros(speeds));
        if self.needs_accelerations {
            system.derivative(p, variables, v, &mut q_dot, &mut v_dot);
            system.generalized_speed_rates(p, variables, v, &v_dot, &mut u_dot);
        } else {
            system.coordinate_rates(p, variables, v, &mut q_dot);
        }
        let (kinetic, potential) = (system.kinetic_energy(p, variables, v), system.potential_energy(p, variables));
        let energies = [kinetic, potential, kinetic + potential];
        let named: Vec<DoubleDouble> = self.energies.iter().map(|at| energies[*at]).collect();
        let nothing = zeros(problem.model.reactions.len());
        let reactions = unknowns.get(speeds..).unwrap_or(&nothing);
        let inputs = [p, &state[..n], &q_dot, &state[n..], &u_dot, reactions, &named].concat();
        let mut values = self.tape.evaluate(&inputs);
        let watched = values.split_off(self.outputs);
        let more = self.names.len() - self.states - self.outputs;
        let own = self.names[self.names.len() - more..].iter();
        let own = own.map(|name| if name == ENERGIES[0] { kinetic } else { potential });
        state.iter().copied().chain(values).chain(own).chain(watched).collect()
    }

    /// Derivatives of the unknowns x of the Newton–Euler equations A x = b in a direction, from
    /// A x′ = b′ − A′ x. They are NaN if A is singular. Empty if no quantity depends on a reaction.
    fn reaction_derivatives(&self, place: &StateWithReactions<'_>, parameters: &[f64], state: &[f64]) -> Vec<f64> {
        let Some(balance) = &self.balance else { return Vec::new() };
        let (problem, system) = (place.problem, balance.extended());
        let Lengths { parameters: count, coordinates: n, .. } = system.lengths();
        let order = system.lengths().unknowns();
        let unknowns: Vec<DoubleDouble> = place.reactions.iter().map(|x| DoubleDouble::from_f64(*x)).collect();
        let left = |x: &[DoubleDouble]| {
            let (p, y) = x.split_at(count);
            let shown = problem.extended_state(p, problem.scene.span.0, y);
            let (q, u) = shown.split_at(n);
            let (mut matrix, mut sides) =
                (vec![DoubleDouble::int(0); order * order], vec![DoubleDouble::int(0); order]);
            system.linear_system(p, q, u, &mut matrix, &mut sides);
            for (side, row) in sides.iter_mut().zip(matrix.chunks_exact(order.max(1))) {
                *side = row.iter().zip(&unknowns).fold(*side, |side, (a, x)| side - *a * *x);
            }
            sides
        };
        let x = [&problem.scene.parameters[..], place.y].concat();
        let mut sides = directional_difference(&x, &[parameters, state].concat(), left);
        let shown = problem.shown_state(problem.scene.span.0, place.y);
        let mut matrix = vec![0.0; order * order];
        balance.system().mass_matrix(&problem.scene.parameters, &shown[..n], &shown[n..], &mut matrix);
        match linear::solve_linear_system(&matrix, &mut sides, MatrixKind::General) {
            Ok(()) => sides,
            Err(_) => vec![f64::NAN; order],
        }
    }
}
