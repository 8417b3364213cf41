//! Inputs of the stability studies, and their findings.

use crate::follow::Progress;
use crate::mechanism::Mechanism;
use crate::studies::figure::Figure;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::scene::{Scene, Solve};

/// Row of the table of a study: one number, with the run that it belongs to.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// Name of the study.
    pub check: &'static str,
    /// Name of the equations; empty if the number does not depend on them.
    pub formulation: String,
    /// Name of the solve for accelerations.
    pub solve: &'static str,
    /// Name of the integration method.
    pub method: &'static str,
    /// Rung, instant or tolerance that the value belongs to.
    pub case: String,
    /// Name of the quantity whose value is given.
    pub quantity: &'static str,
    /// Value of the quantity; `None` if the run stopped before it.
    pub value: Option<f64>,
    /// Expected value by theory or by the reference; `None` if there is none.
    pub expected: Option<f64>,
    /// Instant and reason of a run's stop, or a note on the value.
    pub remark: String,
}

/// A run past a singular surface, which gives a cell of the heat map.
#[derive(Clone, Debug)]
pub struct Passed {
    /// Equations that were integrated.
    pub by: EquationsOrigin,
    /// Name of the solve for accelerations.
    pub solve: &'static str,
    /// Name of the integration method.
    pub method: &'static str,
    /// Variable that was integrated past the surface: the coordinate or its distance.
    pub variable: Variable,
    /// Least distance of the passage: the smallest size of the divisor of the kinematic equations.
    pub least: f64,
    /// Error at the end of the run; `None` if the run stopped earlier.
    pub error: Option<f64>,
    /// Number of accepted steps of the run.
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
    /// Condition of the matrices along a passage.
    Conditioning,
    /// Domain in which the equations describe the motion.
    Domain,
    /// Growth of small errors of the start.
    Growth,
    /// Drift of conserved quantities over long runs.
    Drift,
}

impl Topic {
    /// Name of the study in a line of progress.
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

/// Errors of accelerations and condition of a matrix at one state of a passage.
#[derive(Clone, Debug)]
pub struct Looked {
    /// Equations that give the accelerations.
    pub by: EquationsOrigin,
    /// Way in which the accelerations are found.
    pub solve: Solve,
    /// Size of the divisor of the kinematic equations at the state.
    pub divisor: f64,
    /// Largest error of the accelerations against those with 32 digits, relative to the largest acceleration.
    pub error: f64,
    /// Condition number of the matrix with its rows and columns scaled.
    pub equilibrated: f64,
}

/// Variable that is integrated past a singular surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variable {
    /// The coordinate that is singular on the surface.
    Coordinate,
    /// Distance of the coordinate from its value on the surface.
    Distance,
}

impl Variable {
    /// Name of the variable in tables.
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
    /// Rows of the table, one for every number that was found.
    pub rows: Vec<Row>,
    /// Runs past singular surfaces, the cells of the heat map.
    pub passages: Vec<Passed>,
    /// Errors of accelerations and conditions of matrices along the narrowest passage, up to its least distance.
    pub looked: Vec<Looked>,
    /// True if the motion leaves the domain of its equations.
    pub left_domain: bool,
    /// File names and contents of the figures.
    pub figures: Vec<(&'static str, Figure)>,
    /// Conclusions of the studies, one line each.
    pub statements: Vec<Statement>,
    /// Study that was interrupted; later studies were not begun. `None` if all were completed.
    pub unfinished: Option<Topic>,
}

/// Conclusion of a study in one sentence.
#[derive(Clone, Debug)]
pub struct Statement {
    /// Study that the conclusion belongs to.
    pub study: Topic,
    /// The conclusion as a sentence.
    pub text: String,
}

/// Model, scene and options on which a study works.
pub struct Study<'a> {
    /// Mechanism that the study examines.
    pub model: &'a Mechanism,
    /// Scene that the study examines.
    pub scene: &'a Scene,
    /// True for a shorter study with fewer runs.
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
