//! Equations of motion by several formulations that share only the kinematics: see [`Formulation`].

mod derivation;
mod derivation_limits;
mod derive_error;
mod equations;
mod equations_origin;
mod formulations;
mod inertial_equations;
mod motion;
mod quantity;
mod rows;
mod singular_distance;
mod solutions;
mod unsolved;

pub(crate) use derivation::derive_with;
pub use derivation::{
    Derivation, DerivationInSteps, Derivations, derive, derive_all, derive_all_with, derive_in_steps,
};
pub use derive_error::DeriveError;
pub use equations::{Constrained, Equations};
pub use equations_origin::EquationsOrigin;
pub use formulations::formulation::{Formulation, FormulationProperties};
pub use formulations::newton_euler::{Balance, newton_euler_balances, newton_euler_partial_velocities};
pub use formulations::reaction_directions::balance_multipliers_along_reactions;
pub(crate) use inertial_equations::equations_with_inertial_parameters;
pub use motion::energy::VelocityMomentum;
pub use motion::equation_form::{EquationForm, has_reducible_form};
pub use motion::inertial_anchor::Anchor;
pub use motion::inertial_parameter::InertialParameter;
pub use motion::kinematics::{
    Kinematics, LoadPotential, MotionVariables, Velocities, kinematic_rates, rates_to_speeds, speeds_to_rates,
};
pub use motion::loads::{Load, MovingLoadPlace, moving_load_places};
pub use motion::potential::potential_at_rest;
pub use quantity::{EnergyQuantity, Quantity, QuantityKind, QuantityOwner, RowQuantity, VectorName};
pub use rows::{AccelerationEmbedding, BalanceName, LineName, RowName, Rows, Stage, Step};
pub use singular_distance::{SingularDistance, singular_distances};
pub use solutions::abbreviation::{SumTerm, SumTerms, summand};
pub use solutions::accelerations::{SolvedAccelerations, accelerations, energy_gradient};
pub use solutions::certificate::{Certificate, certify_accelerations, certify_equal_forces, certify_inverse_dynamics};
pub use solutions::divisors::{Divisors, LoadDivisor, distinct_divisors, divisor_without_number, load_divisors};
pub use solutions::equations_in_distance::equations_in_distance;
pub use solutions::inertia_check::{InertiaCheck, check_inertia_at};
pub use solutions::jacobian::{Jacobian, jacobian};

pub use solutions::proved_jacobians::{parameter_jacobian, proved_jacobian};
pub use solutions::quantities::{Quantities, QuantityError};
pub use solutions::regressor::{Column, ColumnParameter, Regressor, RegressorParameters};
pub use unsolved::{Unproved, Unsolved, unsolved_equations_error};
