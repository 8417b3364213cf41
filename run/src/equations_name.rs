//! Names by which a run asks for its equations of motion.

use std::fmt;
use tripos_derive::Formulation;
use tripos_derive::mechanics::EquationsOrigin;

/// Name of the equations of motion that a run asks for.
///
/// Every text is such a name, as only a model tells which printed equations there are. A name that no equations have is
/// refused where it is looked up.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EquationsName {
    /// Equations that the program derives with a formulation, such as `kane`.
    Derived(Formulation),
    /// Equations of the publication beside the model, `printed:ID`, by their id.
    Printed(String),
    /// The reduced equations of a scene, `reduced`.
    Reduced,
    /// Another text. No equations have this name.
    Unknown(String),
}

impl From<&str> for EquationsName {
    fn from(name: &str) -> Self {
        if let Some(formulation) = Formulation::named(name) {
            return Self::Derived(formulation);
        }
        match EquationsOrigin::asked_id(name) {
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
