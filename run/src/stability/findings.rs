//! What the studies work on, and what they find.

use crate::figure::Figure;
use crate::follow::Progress;
use crate::mechanism::Mechanism;
use tripos_derive::mechanics::By;
use tripos_derive::scene::{Scene, Solve};

/// One number that was found.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// Which study.
    pub check: &'static str,
    /// Which equations; empty where it does not matter.
    pub formulation: String,
    /// How accelerations were found.
    pub solve: &'static str,
    /// The method.
    pub method: &'static str,
    /// Which rung, instant or tolerance.
    pub case: String,
    /// What the value is.
    pub quantity: &'static str,
    /// The value; none where a run did not get there.
    pub value: Option<f64>,
    /// What theory or the reference says.
    pub expected: Option<f64>,
    /// Where and why a run stopped, or what to know.
    pub remark: String,
}

/// A run past a singular surface: a cell of the heat map.
#[derive(Clone, Debug)]
pub struct Passed {
    /// Which equations.
    pub by: By,
    /// How accelerations were found.
    pub solve: &'static str,
    /// The method.
    pub method: &'static str,
    /// What was integrated.
    pub variable: Variable,
    /// How near it came: the least size of what the kinematic equations divide by.
    pub least: f64,
    /// The error at the end; none if the run did not get there.
    pub error: Option<f64>,
    /// Accepted steps.
    pub steps: u64,
    /// Why it ended.
    pub stop: String,
    /// Where it ended, s.
    pub t_end: f64,
}

/// What a study is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topic {
    /// Passages near a singular surface.
    Passages,
    /// Matrices along a passage.
    Conditioning,
    /// The domain of the equations.
    Domain,
    /// How errors grow.
    Growth,
    /// What is conserved, over long runs.
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
    /// Which equations.
    pub by: By,
    /// How accelerations were found.
    pub solve: Solve,
    /// The size of what the kinematic equations divide by.
    pub divisor: f64,
    /// How far the accelerations are from those with 32 digits, in units of the largest.
    pub error: f64,
    /// The condition number of the matrix with its rows and columns scaled.
    pub equilibrated: f64,
}

/// What is integrated past a singular surface.
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

/// What the studies found.
#[derive(Default)]
pub struct Findings {
    /// Every number.
    pub rows: Vec<Row>,
    /// The cells of the heat map of passages.
    pub passages: Vec<Passed>,
    /// What was seen along the narrowest passage, on the way in.
    pub looked: Vec<Looked>,
    /// Whether the motion leaves the domain of its equations.
    pub left_domain: bool,
    /// Figures by file name.
    pub figures: Vec<(&'static str, Figure)>,
    /// What to take away, a line each.
    pub statements: Vec<Statement>,
    /// The study that was interrupted, if one was: those after it were not begun.
    pub unfinished: Option<Topic>,
}

/// What to take away, in a sentence.
#[derive(Clone, Debug)]
pub struct Statement {
    /// The study that found it.
    pub study: Topic,
    /// The sentence.
    pub text: String,
}

/// What a study works on.
pub struct Study<'a> {
    /// The model.
    pub model: &'a Mechanism,
    /// The scene.
    pub scene: &'a Scene,
    /// Whether less is to be run.
    pub quick: bool,
    /// What is being done.
    pub progress: &'a dyn Progress,
}

impl Findings {
    /// Adds what to take away from a study.
    pub(super) fn say(&mut self, study: Topic, text: String) {
        self.statements.push(Statement { study, text });
    }
}
