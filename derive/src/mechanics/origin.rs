//! Origin of a set of equations of motion, as data. The names and titles of equations are made only here.

use super::formulations::formulation::Formulation;
use crate::model::Model;

/// Origin of a set of equations of motion.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum EquationsOrigin {
    /// Derived by the program, with this formulation.
    Derived(Formulation),
    /// Equations of a published system or listing, as printed.
    Printed {
        /// Id of the system or listing in the publication file.
        id: String,
        /// Formulation that the publication states for the system.
        formulation: Formulation,
    },
    /// The reduced equations of a scene.
    Reduced,
}

/// Prefix of the id of printed equations.
const PRINTED: &str = "printed:";

impl EquationsOrigin {
    /// Name of the equations on the command line and in files: `kane`, `printed:ID`, `reduced`.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Derived(formulation) => formulation.name().to_owned(),
            Self::Printed { id, .. } => format!("{PRINTED}{id}"),
            Self::Reduced => "reduced".to_owned(),
        }
    }

    /// Title of the equations for a heading.
    #[must_use]
    pub fn title(&self) -> String {
        match self {
            Self::Derived(formulation) => formulation.title().to_owned(),
            Self::Printed { id, formulation } => format!("{} as printed ({id})", formulation.title()),
            Self::Reduced => "Reduced equations".to_owned(),
        }
    }

    /// Name in generated code, with the distance if there is one: `kane@q2-90deg`.
    #[must_use]
    pub fn name_in(&self, distance: Option<Distance>, model: &Model) -> String {
        distance.map_or_else(|| self.name(), |distance| format!("{}@{}", self.name(), distance.name(model)))
    }

    /// Formulation of derived equations; `None` for printed and reduced equations.
    #[must_use]
    pub fn formulation(&self) -> Option<Formulation> {
        if let Self::Derived(formulation) = self { Some(*formulation) } else { None }
    }

    /// Id of printed equations; `None` for derived and reduced equations.
    #[must_use]
    pub fn printed_id(&self) -> Option<&str> {
        if let Self::Printed { id, .. } = self { Some(id) } else { None }
    }

    /// True for the reduced equations of a scene.
    #[must_use]
    pub fn is_reduced(&self) -> bool {
        *self == Self::Reduced
    }

    /// Id in an argument such as `printed:ID`; `None` if the argument does not ask for printed equations.
    #[must_use]
    pub fn asked_id(argument: &str) -> Option<&str> {
        argument.strip_prefix(PRINTED)
    }
}

impl From<Formulation> for EquationsOrigin {
    fn from(formulation: Formulation) -> Self {
        Self::Derived(formulation)
    }
}

/// Distance of a coordinate from a multiple of a quarter turn, which replaces the coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Distance {
    /// Index of the replaced coordinate, from 0.
    pub coordinate: usize,
    /// Angle at which the distance is zero, in quarter turns: 1 for 90°.
    pub quarter_turns: i32,
}

impl Distance {
    /// Angle at which the distance is zero, degrees.
    #[must_use]
    pub fn degrees(self) -> i64 {
        90 * i64::from(self.quarter_turns)
    }

    /// Name of the distance for names of equations: `q2-90deg`.
    #[must_use]
    pub fn name(&self, model: &Model) -> String {
        self.with_unit(model, "deg")
    }

    /// Title of the distance for a heading: `q2-90°`.
    #[must_use]
    pub fn title(&self, model: &Model) -> String {
        self.with_unit(model, "°")
    }

    fn with_unit(self, model: &Model, unit: &str) -> String {
        let sign = if self.quarter_turns < 0 { '+' } else { '-' };
        format!("{}{sign}{}{unit}", model.coordinates[self.coordinate].name, self.degrees().abs())
    }
}
