//! Equations of motion by several methods that share nothing but the kinematics: see [`Formulation`].

mod accelerations;
mod by;
mod derivation;
mod distance;
mod energy;
mod equations;
mod error;
mod formulation;
mod inertia;
mod kane;
mod kinematics;
mod lagrange;
mod loads;
mod newton_euler;
mod quantities;
mod quantity;
mod rows;
mod vector;

pub use accelerations::{Jacobian, Solved, accelerations, energy_gradient, jacobian};
pub use by::{By, Distance};
pub use derivation::{Derivation, DerivationInSteps, Derivations, derive, derive_all, derive_in_steps};
pub use distance::{distances, in_distance};
pub use energy::Momentum;
pub use equations::Equations;
pub use error::DeriveError;
pub use formulation::{Formulation, Method, MotionVariables};
pub use inertia::{InertiaCheck, has_inertia_at};
pub use kinematics::{Kinematics, Velocities, motion_rates, rates_to_speeds, speeds_to_rates};
pub use lagrange::generalized_forces;
pub use loads::{Load, MovingPlace, moving_places};
pub use newton_euler::{Balance, balances, partial_velocities};
pub use quantities::{Quantities, QuantityError};
pub use quantity::{Energy, Owner, Quantity, QuantityKind, Row, VectorName};
pub use rows::{BalanceName, LineName, RowName, Rows, Stage, Step};
pub use vector::{Frames, Vector};
