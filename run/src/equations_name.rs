//! Names by which the user of a run selects its equations of motion.

use std::fmt;
use tripos_derive::Formulation;
use tripos_derive::mechanics::EquationsOrigin;

/// Name by which the user of a run selects its equations of motion, such as `kane` or `printed:ID`.
///
/// Every text is accepted here, because only a model knows which printed equations exist. A name
/// that no equations of the model have is refused later, when the equations are looked up.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EquationsName {
    /// Equations that the program derives by a formulation, such as `kane`.
    Derived(Formulation),
    /// Printed equations of the publication beside the model, named `printed:ID`; the value is their
    /// id.
    Printed(String),
    /// Reduced equations of the scene, named `reduced`.
    Reduced,
    /// Any other text, which is the name of no equations.
    Unknown(String),
}

impl From<&str> for EquationsName {
    fn from(name: &str) -> Self {
        if let Some(formulation) = Formulation::from_name(name) {
            return Self::Derived(formulation);
        }
        match EquationsOrigin::printed_id_of_argument(name) {
            Some(id) => Self::Printed(id.to_owned()),
            None if name == EquationsOrigin::Reduced.name() => Self::Reduced,
            None => Self::Unknown(name.to_owned()),
        }
    }
}

impl From<&EquationsOrigin> for EquationsName {
    fn from(by: &EquationsOrigin) -> Self {
        match by {
            EquationsOrigin::Derived(formulation) => Self::Derived(*formulation),
            EquationsOrigin::Printed { id, .. } => Self::Printed(id.clone()),
            EquationsOrigin::Reduced => Self::Reduced,
        }
    }
}

impl fmt::Display for EquationsName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Derived(formulation) => f.write_str(formulation.name()),
            Self::Printed(id) => write!(f, "printed:{id}"),
            Self::Reduced => f.write_str(&EquationsOrigin::Reduced.name()),
            Self::Unknown(name) => f.write_str(name),
        }
    }
}
