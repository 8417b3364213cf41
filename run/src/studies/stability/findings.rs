//! Inputs of the studies, and their findings.

use crate::follow::Progress;
use crate::mechanism::Mechanism;
use crate::studies::figure::Figure;
use tripos_derive::mechanics::By;
use tripos_derive::scene::{Scene, Solve};

/// One number that a study found.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// Name of the study.
    pub check: &'static str,
    /// Name of the equations; empty where it does not matter.
    pub formulation: String,
    /// Name of the solve for accelerations.
    pub solve: &'static str,
    /// Name of the integration method.
    pub method: &'static str,
    /// Rung, instant or tolerance to which the value belongs.
    pub case: String,
    /// Name of the quantity.
    pub quantity: &'static str,
    /// Value of the quantity; `None` where a run did not get there.
    pub value: Option<f64>,
    /// Value by theory or by the reference; `None` if there is none.
    pub expected: Option<f64>,
    /// Place and reason of a run's stop, or a note on the value.
    pub remark: String,
}

/// A run past a singular surface: a cell of the heat map.
#[derive(Clone, Debug)]
pub struct Passed {
    /// Equations that were integrated.
    pub by: By,
    /// Name of the solve for accelerations.
    pub solve: &'static str,
    /// Name of the integration method.
    pub method: &'static str,
    /// Variable that was integrated.
    pub variable: Variable,
    /// Least distance of the passage: the smallest size of the divisor of the kinematic equations.
    pub least: f64,
    /// Error at the end; `None` if the run did not get there.
    pub error: Option<f64>,
    /// Number of accepted steps.
    pub steps: u64,
    /// Reason why the run ended.
    pub stop: String,
    /// Instant at which the run ended, s.
    pub t_end: f64,
}

/// Topic of a study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topic {
    /// Passages near a singular surface.
    Passages,
    /// Matrices along a passage.
    Conditioning,
    /// The domain of the equations.
    Domain,
    /// Growth of small errors.
    Growth,
    /// Drift of conserved quantities over long runs.
    Drift,
}

impl Topic {
    /// The name in a line of progress.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Passages => "passages",
            Self::Conditioning => "conditioning",
            Self::Domain => "domain",
            Self::Growth => "growth",
            Self::Drift => "drift",
        }
    }
}

/// Accelerations and a matrix at one place of a passage.
#[derive(Clone, Debug)]
pub struct Looked {
    /// Equations that give the accelerations.
    pub by: By,
    /// Solve for the accelerations.
    pub solve: Solve,
    /// Size of the divisor of the kinematic equations.
    pub divisor: f64,
    /// Largest error of the accelerations against those with 32 digits, in units of the largest acceleration.
    pub error: f64,
    /// Condition number of the matrix with its rows and columns scaled.
    pub equilibrated: f64,
}

/// Variable that is integrated past a singular surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variable {
    /// The coordinate itself.
    Coordinate,
    /// Its distance from the surface.
    Distance,
}

impl Variable {
    /// The name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Coordinate => "coordinate",
            Self::Distance => "distance",
        }
    }
}

/// Findings of all studies.
#[derive(Default)]
pub struct Findings {
    /// Rows of the table: every number that was found.
    pub rows: Vec<Row>,
    /// The cells of the heat map of passages.
    pub passages: Vec<Passed>,
    /// Accelerations and matrices along the narrowest passage, on the way in.
    pub looked: Vec<Looked>,
    /// True if the motion leaves the domain of its equations.
    pub left_domain: bool,
    /// Figures by file name.
    pub figures: Vec<(&'static str, Figure)>,
    /// Conclusions, one line each.
    pub statements: Vec<Statement>,
    /// The study that was interrupted, if one was: those after it were not begun.
    pub unfinished: Option<Topic>,
}

/// Conclusion of a study, in a sentence.
#[derive(Clone, Debug)]
pub struct Statement {
    /// The study that found it.
    pub study: Topic,
    /// The sentence.
    pub text: String,
}

/// Model, scene and options on which a study works.
pub struct Study<'a> {
    /// The model.
    pub model: &'a Mechanism,
    /// The scene.
    pub scene: &'a Scene,
    /// True if a shorter study with fewer runs is wanted.
    pub quick: bool,
    /// Receiver of progress messages.
    pub progress: &'a dyn Progress,
}

impl Findings {
    /// Adds a conclusion of a study.
    pub(super) fn say(&mut self, study: Topic, text: String) {
        self.statements.push(Statement { study, text });
    }
}
