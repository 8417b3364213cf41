//! Inputs of the studies of a scene's limits, and the findings of these studies.

use crate::mechanism::Mechanism;
use crate::observer::Progress;
use crate::studies::figure::Figure;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::scene::{AccelerationSolution, Scene};

/// Row of the table of findings: the value of one quantity, and the run that gave it.
#[derive(Clone, Debug, Default)]
pub struct FindingRow {
    /// Name of the study, such as `passage`.
    pub check: &'static str,
    /// Name of the equations of motion; empty if the value does not depend on them.
    pub formulation: String,
    /// Name of the method that finds the accelerations; empty if the value does not depend on it.
    pub solve: &'static str,
    /// Name of the integrator; empty if the value does not depend on it.
    pub method: &'static str,
    /// Case to which the value belongs, as text: a least distance, an instant or a tolerance.
    pub case: String,
    /// Name of the quantity, such as `energy drift`.
    pub quantity: &'static str,
    /// Value of the quantity; `None` if the run stopped before it was known.
    pub value: Option<f64>,
    /// Value that theory or the reference predicts; `None` if there is no prediction.
    pub expected: Option<f64>,
    /// Instant and reason of the stop of a run, or a note on the value.
    pub remark: String,
}

/// Run past a singular surface. It gives one cell of the heat map.
#[derive(Clone, Debug)]
pub struct PassageRun {
    /// Origin of the equations that were integrated.
    pub by: EquationsOrigin,
    /// Name of the method that finds the accelerations; `-` for quadrature.
    pub solve: &'static str,
    /// Name of the integrator.
    pub method: &'static str,
    /// Variable that was integrated past the surface: the coordinate, or its distance from the surface.
    pub variable: PassageVariable,
    /// Least distance from the surface: the smallest absolute value of the divisor of the kinematic
    /// equations.
    pub least: f64,
    /// Largest error of a compared quantity at the end of the run; `None` if the run stopped before its
    /// end.
    pub error: Option<f64>,
    /// Number of accepted steps of the run.
    pub steps: u64,
    /// Code of the reason why the run ended, such as `end`.
    pub stop: String,
    /// Instant at which the run ended, s.
    pub t_end: f64,
}

/// Topic of a study of a scene's limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FindingTopic {
    /// Passages near a singular surface of the kinematic equations.
    Passages,
    /// Condition numbers of the matrices that give the accelerations, along a passage.
    Conditioning,
    /// Domain in which the equations describe the motion, and runs that leave it.
    Domain,
    /// Growth of small errors of the start during the motion.
    Growth,
    /// Drift of conserved quantities in long runs.
    Drift,
}

impl FindingTopic {
    /// Name of the topic, for a line of progress, such as `passages`.
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

/// Error of the accelerations and condition of their matrix at one state of a passage near a
/// singular surface.
#[derive(Clone, Debug)]
pub struct ConditioningFinding {
    /// Origin of the equations that give the accelerations.
    pub by: EquationsOrigin,
    /// Method that finds the accelerations: eliminated beforehand or solved numerically.
    pub solve: AccelerationSolution,
    /// Absolute value of the divisor of the kinematic equations at the state.
    pub divisor: f64,
    /// Largest error of the accelerations u̇ compared with u̇ to 32 digits, relative to the largest u̇.
    pub error: f64,
    /// Condition number of the matrix after its rows and columns are scaled.
    pub equilibrated: f64,
}

/// Variable that is integrated past a singular surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PassageVariable {
    /// The coordinate itself, such as an angle.
    Coordinate,
    /// Distance of the coordinate from its value on the surface, such as an angle minus 90°.
    Distance,
}

impl PassageVariable {
    /// Name of the variable, for tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Coordinate => "coordinate",
            Self::Distance => "distance",
        }
    }
}

/// Findings of all studies of a scene's limits.
#[derive(Default)]
pub struct Findings {
    /// Rows of the table of findings, one for every value that was found.
    pub rows: Vec<FindingRow>,
    /// Runs past singular surfaces, for the cells of the heat map.
    pub passages: Vec<PassageRun>,
    /// Errors of accelerations and condition numbers at states along the closest passage, up to its least
    /// distance from the singular surface.
    pub looked: Vec<ConditioningFinding>,
    /// True if the motion leaves the domain of its equations in a run.
    pub left_domain: bool,
    /// Figures, each with its file name.
    pub figures: Vec<(&'static str, Figure)>,
    /// Conclusions of the studies, each a sentence.
    pub statements: Vec<Statement>,
    /// Topic of the study that was interrupted. No later study began. `None` if all studies were completed.
    pub unfinished: Option<FindingTopic>,
}

/// Conclusion of a study, in one sentence.
#[derive(Clone, Debug)]
pub struct Statement {
    /// Topic of the study that gave the conclusion.
    pub study: FindingTopic,
    /// Conclusion as a sentence for the user.
    pub text: String,
}

/// Inputs of a study of a scene's limits.
pub struct StudyInputs<'a> {
    /// Mechanism of the scene.
    pub model: &'a Mechanism,
    /// Scene whose limits are studied.
    pub scene: &'a Scene,
    /// True for a shorter study with fewer runs; false for the full study.
    pub quick: bool,
    /// Display of the progress of the study.
    pub progress: &'a dyn Progress,
}

impl Findings {
    /// Adds a conclusion of a study, as a sentence, to the findings.
    pub(super) fn add_statement(&mut self, study: FindingTopic, text: String) {
        self.statements.push(Statement { study, text });
    }
}
