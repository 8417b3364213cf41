//! Equations of motion by several formulations that share only the kinematics: see [`Formulation`].

mod budget;
mod derivation;
mod equations;
mod error;
mod formulations;
mod motion;
mod origin;
mod quantity;
mod rows;
mod solutions;
mod unsolved;

pub(crate) use derivation::derive_with;
pub use derivation::{
    Derivation, DerivationInSteps, Derivations, derive, derive_all, derive_all_with, derive_in_steps,
};
pub use equations::{Constrained, Equations};
pub use error::DeriveError;
pub use formulations::formulation::{Formulation, Method};
pub use formulations::newton_euler::{Balance, balances, partial_velocities};
pub use formulations::reaction_balance::along_reactions;
pub use motion::anchor::Anchor;
pub use motion::energy::Momentum;
pub use motion::form::{Form, is_reducible};
pub use motion::inertial::Inertial;
pub use motion::kinematics::{
    Kinematics, LoadPotential, MotionVariables, Velocities, motion_rates, rates_to_speeds, speeds_to_rates,
};
pub use motion::loads::{Load, MovingPlace, moving_places};
pub use motion::potential::potential_at_rest;
pub use origin::{Distance, EquationsOrigin};
pub use quantity::{Energy, Owner, Quantity, QuantityKind, Row, VectorName};
pub use rows::{BalanceName, Embedding, LineName, RowName, Rows, Stage, Step};
pub use solutions::accelerations::{Solved, accelerations, energy_gradient};
pub use solutions::certificate::{Certificate, certify, certify_inverse_dynamics};
pub use solutions::distance::{distances, in_distance};
pub use solutions::divisors::{Divisors, LoadDivisor, bare, load_divisors};
pub use solutions::inertia::{InertiaCheck, has_inertia_at};
pub use solutions::jacobian::{Jacobian, jacobian};

pub use solutions::quantities::{Quantities, QuantityError};
pub use solutions::regressor::{Column, ColumnParameter, Regressor, Varied};
pub use solutions::slopes::{parameter_jacobian, slopes};
pub use unsolved::{Unproved, Unsolved};
