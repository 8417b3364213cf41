//! Origin of equations of motion. The names and titles of equations are made only in this file.

use super::formulations::formulation::Formulation;
use super::singular_distance::SingularDistance;
use crate::model::Model;

/// Origin of equations of motion: derived, printed in a publication, or reduced for a scene.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum EquationsOrigin {
    /// Equations that the program derived with this formulation.
    Derived(Formulation),
    /// Equations of a publication or program listing, exactly as printed.
    Printed {
        /// Identifier of the system or listing in the publication file.
        id: String,
        /// Formulation that the publication states for the system.
        formulation: Formulation,
    },
    /// Equations that the program reduced for a scene.
    Reduced,
}

/// Prefix before the identifier of printed equations on the command line.
const PRINTED: &str = "printed:";

impl EquationsOrigin {
    /// Name of the equations on the command line and in files: `kane`, `printed:ID` or `reduced`.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Derived(formulation) => formulation.name().to_owned(),
            Self::Printed { id, .. } => format!("{PRINTED}{id}"),
            Self::Reduced => "reduced".to_owned(),
        }
    }

    /// Title of the equations for a heading, such as `Kane's method` or `Reduced equations`.
    #[must_use]
    pub fn title(&self) -> String {
        match self {
            Self::Derived(formulation) => formulation.title().to_owned(),
            Self::Printed { id, formulation } => format!("{} as printed ({id})", formulation.title()),
            Self::Reduced => "Reduced equations".to_owned(),
        }
    }

    /// Name of the equations in generated code. If a distance replaces a coordinate, it is part of the
    /// name: `kane@q2-90deg`.
    #[must_use]
    pub fn name_in(&self, distance: Option<SingularDistance>, model: &Model) -> String {
        distance.map_or_else(|| self.name(), |distance| format!("{}@{}", self.name(), distance.name(model)))
    }

    /// Formulation by which the equations were derived; `None` for printed and reduced equations.
    #[must_use]
    pub fn formulation(&self) -> Option<Formulation> {
        if let Self::Derived(formulation) = self { Some(*formulation) } else { None }
    }

    /// Identifier of printed equations; `None` for derived and reduced equations.
    #[must_use]
    pub fn printed_id(&self) -> Option<&str> {
        if let Self::Printed { id, .. } = self { Some(id) } else { None }
    }

    /// True if the equations are the reduced equations of a scene.
    #[must_use]
    pub fn is_reduced(&self) -> bool {
        *self == Self::Reduced
    }

    /// Identifier `ID` in a command-line argument `printed:ID`. `None` for any other argument.
    #[must_use]
    pub fn printed_id_of_argument(argument: &str) -> Option<&str> {
        argument.strip_prefix(PRINTED)
    }
}

impl From<Formulation> for EquationsOrigin {
    fn from(formulation: Formulation) -> Self {
        Self::Derived(formulation)
    }
}
