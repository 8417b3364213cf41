//! Which equations of motion: data, from which what they are called is made, here and nowhere else.

use super::formulation::Formulation;
use crate::model::Model;

/// Which equations of motion.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum By {
    /// Derived ones.
    Derived(Formulation),
    /// Those of a published system or listing, as they stand.
    Printed {
        /// Its id in the report.
        id: String,
        /// The formulation that it says it is.
        formulation: Formulation,
    },
    /// A scene's own.
    Reduced,
}

/// What stands before the id of printed equations.
const PRINTED: &str = "printed:";

impl By {
    /// What they are called on the command line and in files: `kane`, `printed:ID`, `reduced`.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Derived(formulation) => formulation.name().to_owned(),
            Self::Printed { id, .. } => format!("{PRINTED}{id}"),
            Self::Reduced => "reduced".to_owned(),
        }
    }

    /// What they are called in a heading.
    #[must_use]
    pub fn title(&self) -> String {
        match self {
            Self::Derived(formulation) => formulation.title().to_owned(),
            Self::Printed { id, formulation } => format!("{} as printed ({id})", formulation.title()),
            Self::Reduced => "Reduced equations".to_owned(),
        }
    }

    /// What the same equations in a distance are called in generated code: `kane@q2-90deg`.
    #[must_use]
    pub fn name_in(&self, distance: Option<Distance>, model: &Model) -> String {
        distance.map_or_else(|| self.name(), |distance| format!("{}@{}", self.name(), distance.name(model)))
    }

    /// The formulation of derived equations; none for others.
    #[must_use]
    pub fn formulation(&self) -> Option<Formulation> {
        if let Self::Derived(formulation) = self { Some(*formulation) } else { None }
    }

    /// The id of printed equations; none for others.
    #[must_use]
    pub fn printed_id(&self) -> Option<&str> {
        if let Self::Printed { id, .. } = self { Some(id) } else { None }
    }

    /// Whether these are a scene's own equations.
    #[must_use]
    pub fn is_reduced(&self) -> bool {
        *self == Self::Reduced
    }

    /// The id that an argument such as `printed:ID` asks for, if it asks for printed equations.
    #[must_use]
    pub fn asked_id(argument: &str) -> Option<&str> {
        argument.strip_prefix(PRINTED)
    }
}

impl From<Formulation> for By {
    fn from(formulation: Formulation) -> Self {
        Self::Derived(formulation)
    }
}

/// A coordinate is replaced by its distance from a multiple of a quarter turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Distance {
    /// Which coordinate, from 0.
    pub coordinate: usize,
    /// The origin in quarter turns: 1 for 90°.
    pub quarter_turns: i32,
}

impl Distance {
    /// The origin, degrees.
    #[must_use]
    pub fn degrees(self) -> i64 {
        90 * i64::from(self.quarter_turns)
    }

    /// How equations in it are called: `q2-90deg`.
    #[must_use]
    pub fn name(&self, model: &Model) -> String {
        self.with_unit(model, "deg")
    }

    /// The name of a distance for a heading: `q2-90°`.
    #[must_use]
    pub fn title(&self, model: &Model) -> String {
        self.with_unit(model, "°")
    }

    fn with_unit(self, model: &Model, unit: &str) -> String {
        let sign = if self.quarter_turns < 0 { '+' } else { '-' };
        format!("{}{sign}{}{unit}", model.coordinates[self.coordinate].name, self.degrees().abs())
    }
}
