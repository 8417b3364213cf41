//! Equations of motion by several methods that share nothing but the kinematics: see [`Formulation`].

mod accelerations;
mod along;
mod anchor;
mod budget;
mod by;
mod carried;
mod carry;
mod composite;
mod derivation;
mod distance;
mod divisors;
mod energy;
mod equations;
mod error;
mod formulation;
mod inertia;
mod inertial;
mod kane;
mod kinematics;
mod lagrange;
mod loads;
mod multipliers;
mod newton_euler;
mod potential;
mod quantities;
mod quantity;
mod recursion;
mod regressor;
mod rows;

pub use accelerations::{Jacobian, Solved, accelerations, energy_gradient, jacobian};
pub use along::along_reactions;
pub use anchor::Anchor;
pub use by::{By, Distance};
pub use carry::{is_large, is_reducible};
pub(crate) use derivation::derive_with;
pub use derivation::{
    Derivation, DerivationInSteps, Derivations, derive, derive_all, derive_all_with, derive_in_steps,
};
pub use distance::{distances, in_distance};
pub use divisors::{Divisors, bare};
pub use energy::Momentum;
pub use equations::{Constrained, Equations};
pub use error::DeriveError;
pub use formulation::{Formulation, Method, MotionVariables};
pub use inertia::{InertiaCheck, has_inertia_at};
pub use inertial::Inertial;
pub use kinematics::{Kinematics, LoadPotential, Velocities, motion_rates, rates_to_speeds, speeds_to_rates};
pub use loads::{Load, MovingPlace, moving_places};
pub use newton_euler::{Balance, balances, partial_velocities};
pub use potential::potential_at_rest;
pub use quantities::{Quantities, QuantityError};
pub use quantity::{Energy, Owner, Quantity, QuantityKind, Row, VectorName};
pub use regressor::{Column, Of, Regressor, Varied};
pub use rows::{BalanceName, Embedding, LineName, RowName, Rows, Stage, Step};
