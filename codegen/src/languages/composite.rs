//! Composite functions of a generated module, which call its planned functions.

use tripos_derive::Equations;

/// Function that a language writes in addition to the planned functions, and that calls them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CompositeFunction {
    /// Solves the linear system numerically for all unknowns: the accelerations, then the reactions or multipliers.
    Unknowns,
    /// Solves the linear system numerically, and returns only the reactions.
    Reactions,
    /// Projects a state, or a guess of a pose, onto the constraints.
    Project,
    /// Computes the derivative in time of the state (q, v), as a function of time, state and
    /// parameters.
    StateDerivative,
    /// Computes the matrix M of the state's linear system M x' = f, with the identity for the
    /// coordinates.
    StateMass,
    /// Computes the right-hand side f of the state's linear system M x' = f.
    StateForcing,
    /// Returns the ordinary differential equation x' = f(x, p) of the state as symbolic expressions.
    Ode,
    /// Returns the semi-explicit differential-algebraic equation of the state and the unknowns as symbolic
    /// expressions.
    Dae,
}

impl CompositeFunction {
    /// Returns the name of the function in the generated module.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Unknowns => "unknowns",
            Self::Reactions => "reactions",
            Self::Project => "project",
            Self::StateDerivative => "state_derivative",
            Self::StateMass => "state_mass",
            Self::StateForcing => "state_forcing",
            Self::Ode => "ode",
            Self::Dae => "dae",
        }
    }

    /// Returns the names of the planned functions that this function calls.
    #[must_use]
    pub const fn needs(self) -> &'static [&'static str] {
        match self {
            Self::Unknowns | Self::Reactions => &["mass_matrix", "forcing"],
            Self::Project => &["constraints", "constraint_slopes"],
            Self::StateDerivative | Self::Ode => &["derivative"],
            Self::StateMass => &["mass_matrix"],
            Self::StateForcing => &["forcing", "coordinate_rates"],
            Self::Dae => &["coordinate_rates", "residual"],
        }
    }

    /// True if the function is possible for the given equations. `StateMass` and `StateForcing` need equations whose
    /// only unknowns are accelerations. `Reactions` needs reactions among the unknowns.
    #[must_use]
    pub fn exists_for_equations(self, equations: &Equations) -> bool {
        let has_more = equations.unknowns.len() > equations.variables.len();
        match self {
            Self::StateMass | Self::StateForcing => !has_more,
            Self::Reactions => has_more && equations.formulation.has_reactions(),
            Self::Unknowns | Self::Project | Self::StateDerivative | Self::Ode | Self::Dae => true,
        }
    }
}
