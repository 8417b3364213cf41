//! Flow of a mechanism: the motion as a first-order system, with its derivatives and symmetries. Equilibria, steady
//! motions and linearisations are computed from it.
//!
//! The states x are the coordinates, then the generalized speeds. The motion is x' = f(x, r) with f(q, u) = (W u + w,
//! u̇) by Kane's method and inputs r. If loops close the mechanism, f applies to states with φ(q) = 0, and the motion
//! keeps φ(q) = 0.

mod flow_program;
mod rest_balance;
mod steady_balance;
mod symbolic_linear_system;
mod symmetry;

pub use flow_program::{FlowProgramResults, FlowProgramSizes, Program};
pub use rest_balance::RestBalance;
pub use steady_balance::{Balance, Steadiness, SymmetryVelocity};
pub use symbolic_linear_system::{LinearSystemError, OperatingPoint, StateElimination, SymbolicLinearSystem};
pub use symmetry::Symmetry;
pub(crate) use symmetry::{symmetries_that_turn_states, symmetry_candidates};

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::term::steps::Definition;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::mechanics::{DeriveError, Equations, Formulation, Kinematics, SolvedAccelerations, derive_with};
use crate::model::Model;
use crate::prove::{IntegralKind, VectorField};

/// Flow x' = f(x, r) of a mechanism with states x and inputs r, and its loops and symmetries.
#[derive(Clone)]
pub struct Flow {
    /// Arena of all terms of the flow.
    pub arena: Arena,
    /// Definitions that compute f. Each comes after the definitions that it uses. The last ones define u̇.
    pub steps: Vec<Definition>,
    /// Symbols of the parameters of the model, inputs included.
    pub parameters: Vec<Expr>,
    /// Symbols of the states: coordinates q, then generalized speeds u.
    pub states: Vec<Expr>,
    /// Right-hand side f: q̇, then u̇, as terms in parameters, states and defined symbols.
    pub rates: Vec<Expr>,
    /// Mass matrix M of Kane's equations M u̇ = F, as terms in parameters and states.
    pub inertia: Vec<Vec<Expr>>,
    /// Forcing F of Kane's equations M u̇ = F, as terms in parameters and states.
    pub balances: Vec<Expr>,
    /// Residuals φ of the loop equations. They are zero if the loops are closed.
    pub loops: Vec<Expr>,
    /// Residuals of redundant loops, which are zero if all loops are closed. They restrict no velocities that φ does
    /// not restrict.
    pub closed: Vec<Expr>,
    /// Symmetries of the flow, each proved. They are vector fields on the states; a shift along one takes solutions
    /// to solutions.
    pub symmetries: Vec<Symmetry>,
    /// Kinetic energy T (J), potential energy V (J), and power of the forces without a potential in V (W), as terms
    /// in the states.
    pub energies: [Expr; 3],
    /// Divisors of the kinematic equations. In a state in which a divisor is zero, u does not determine q̇.
    pub divisors: Vec<Expr>,
}

impl Flow {
    /// Derives and solves the equations of a model by Kane's method, and finds the symmetries of the flow.
    ///
    /// # Errors
    /// Returns a [`DeriveError`] if the model cannot be derived.
    pub fn new(model: &Model) -> Result<Self, DeriveError> {
        let mut kinematics = Kinematics::new(model)?;
        let equations = derive_with(model, &mut kinematics, Formulation::Kane)?;
        let mut candidates: Vec<VectorField> = symmetry::time_symmetry_candidate(model).into_iter().collect();
        candidates.extend(symmetry::symmetry_candidates(model, &mut kinematics));
        let mut arena = kinematics.arena;
        let (inertia, balances) = (equations.matrix.clone(), equations.forcing.clone());
        let equations = equations.with_definitions(&mut arena);
        let solved = SolvedAccelerations::steps(&mut arena, &equations).map_err(DeriveError::Unsolved)?;
        let Equations { coordinate_rates, unknowns, kinetic_energy, potential_energy, power, divisors, .. } = equations;
        let states = [model.q(), model.u()].concat();
        let mut flow = Self {
            arena,
            steps: solved,
            parameters: model.p(),
            rates: coordinate_rates.into_iter().chain(unknowns.into_iter().take(model.speeds.len())).collect(),
            states,
            inertia,
            balances,
            loops: model.loops.iter().map(|c| c.equation).collect(),
            closed: model.closed.iter().map(|c| c.equation).collect(),
            symmetries: Vec::new(),
            energies: [kinetic_energy, potential_energy, power],
            divisors,
        };
        flow.symmetries = symmetry::proved_symmetries(model, &mut flow, candidates);
        Ok(flow)
    }

    /// Index of the shift of time in [`Self::symmetries`]. `None` if time is not a coordinate of the model, or if its
    /// equations depend on time.
    #[must_use]
    pub fn time_shift_symmetry(&self, model: &Model) -> Option<usize> {
        let time = model.time()?;
        self.symmetries.iter().position(|symmetry| symmetry.kind == IntegralKind::Coordinate(time))
    }

    /// Index of the first state whose rate depends on time explicitly; `None` if no rate does.
    pub fn depends_on_time(&mut self, model: &Model) -> Option<usize> {
        let time = self.states[model.time()?];
        let rates = self.rates.clone();
        let rates = self.without_definitions(&rates);
        let mut by_time = Differential::partial(time);
        rates.into_iter().position(|rate| {
            let slope = by_time.apply(&mut self.arena, rate);
            zero_test(&self.arena, slope) != ZeroTest::Zero
        })
    }

    /// Copies of terms in which all defined symbols are replaced by the terms that define them. Common subterms stay
    /// shared.
    pub fn without_definitions(&mut self, terms: &[Expr]) -> Vec<Expr> {
        let mut put = Substitution::default();
        for step in &self.steps {
            let value = put.apply(&mut self.arena, step.value);
            put.set(step.symbol, value);
        }
        terms.iter().map(|term| put.apply(&mut self.arena, *term)).collect()
    }

    /// Rewrites a term of a scene, such as an output, in states and defined symbols. Rates and accelerations are
    /// replaced by components of f, and energies by their formulas.
    pub fn flow_term_in_states(&mut self, model: &Model, term: Expr) -> Expr {
        let mut put = Substitution::default();
        let rates = model.q_dot().into_iter().chain(model.speeds.iter().map(|speed| speed.rate));
        for (rate, value) in rates.zip(&self.rates) {
            put.set(rate, *value);
        }
        let [kinetic, potential, _] = self.energies;
        let total = self.arena.add(kinetic, potential);
        for (name, value) in crate::scene::ENERGIES.iter().zip([kinetic, potential, total]) {
            if let Some(symbol) = self.arena.find_symbol(name) {
                put.set(symbol, value);
            }
        }
        let term = put.apply(&mut self.arena, term);
        Simplifier::default().simplify(&mut self.arena, term)
    }
}
