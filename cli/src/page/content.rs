//! Content of the page, as data.

use tripos::Reduced;
use tripos::studies::study::Study;
use tripos_codegen::plan::Costs;
use tripos_derive::mechanics::DerivationInSteps;
use tripos_derive::{Formulation, Model};

/// Content of a page about a model.
pub struct Page<'a> {
    /// The mechanism.
    pub model: &'a Model,
    /// Its equations of motion by each formulation, or why there are none.
    pub derivations: Vec<(Formulation, Result<DerivationInSteps, String>)>,
    /// Proofs about the equations, and the verdict on the publication beside the model.
    pub study: &'a Study,
    /// The simulations.
    pub scenes: Vec<SceneSection>,
    /// The mechanism as textbooks draw it, or why there is no sketch.
    pub sketch: Result<Drawing, String>,
    /// The motion of one of them, to be looked at.
    pub moving: Option<Moving>,
    /// Why there are not all of them, if there are not.
    pub unfinished: Option<String>,
    /// The model, as a command takes it.
    pub file: String,
}

/// A sketch of the mechanism.
pub struct Drawing {
    /// An element `<svg>`.
    pub svg: String,
    /// At which values it is drawn.
    pub caption: String,
}

/// The motion of a scene, to be looked at.
pub struct Moving {
    /// Index of the scene that it shows.
    pub scene: usize,
    /// The figure that shows it, or why there is none.
    pub viewer: Result<Viewer, String>,
}

/// A figure that moves.
pub struct Viewer {
    /// The figure, as HTML.
    pub figure: String,
    /// Its style, as CSS that speaks of nothing else.
    pub style: &'static str,
    /// The element `<script>` that moves it.
    pub script: String,
    /// Doubt about the shown motion; `None` if it can be trusted.
    pub doubt: Option<String>,
}

/// One simulated scene.
pub struct SceneSection {
    /// Its file, as a command takes it.
    pub file: String,
    /// Its title.
    pub title: String,
    /// Description of the scene, from its file.
    pub about: String,
    /// Given data: parameters, start, tolerances.
    pub facts: Vec<(&'static str, Fact)>,
    /// Its own equations, or why there are none.
    pub needs: Result<Needs, String>,
    /// One run for each formulation, one by the scene's own equations, then one for each printed system.
    pub runs: Vec<RunRow>,
    /// Printed systems that could not be run: (title, why).
    pub not_run: Vec<(String, String)>,
    /// Its figures.
    pub figures: Vec<Figure>,
    /// Figures that it cannot have, and why.
    pub not_drawn: Vec<String>,
    /// Recommended equations, solve and method; `None` if they were not measured.
    pub advice: Option<Advice>,
    /// First integrals over time, if there are any.
    pub integrals: Option<Figure>,
    /// Determinants, condition numbers and kinematic divisors over time.
    pub nearness: Option<Figure>,
}

/// A given datum of a scene.
pub enum Fact {
    /// Names with their values.
    Values(Vec<(String, f64)>),
    /// Plain words.
    Words(String),
}

/// Reduced equations of a scene, and their cost.
pub struct Needs {
    /// Its own equations.
    pub reduced: Reduced,
    /// Cost of a call of them, beside that of one of the whole model.
    pub costs: Costs,
}

/// Results of one run, as a row of the table.
pub struct RunRow {
    /// Title of the equations that ran, for a heading.
    pub title: String,
    /// The id of the printed system; none for derived equations.
    pub printed: Option<String>,
    /// The integration method.
    pub method: &'static str,
    /// `compiled` or `interpreted`.
    pub code: String,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Calls of the right-hand side.
    pub evaluations: u64,
    /// Instant at which the run ended, s.
    pub t_end: f64,
    /// True if the run reached the last instant of its span.
    pub arrived: bool,
    /// Why it ended, as a sentence.
    pub stop: String,
    /// Standing of the run: the verdict on its equations and on its numbers.
    pub standing: Standing,
    /// Largest change of total energy that no work accounts for, J; none of equations that do not know it.
    pub energy_drift: Option<f64>,
    /// Correct digits of every value at the end of the run, estimated by its second run; `None` if not assessed, or if
    /// the equations are not those of the motion.
    pub digits: Option<f64>,
    /// From when on there are fewer than three digits, s; nothing if they are kept, or that was not assessed.
    pub few_from: Option<f64>,
    /// Further warnings for the reader.
    pub warnings: Vec<String>,
    /// Largest change of each first integral; nothing of a run that does not show every state.
    pub changes: Vec<f64>,
    /// Least distances of the run from singular configurations.
    pub nearest: Nearest,
}

/// Verdict on the equations of a run, and on its numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum Standing {
    /// Derived equations, or printed ones that are proved to move alike, integrated as well as was asked for.
    Right,
    /// Right equations at tolerances that leave few digits.
    Loose {
        /// The method and its tolerances.
        how: String,
        /// The largest |e| / (1 + |value|) at the end of the run, or why it is not known.
        error: Result<f64, String>,
    },
    /// Right equations whose run could not go on.
    Stopped,
    /// Printed equations that do not give the derived accelerations, however their run ends.
    Wrong,
    /// Printed equations of which that is not known, and why.
    Undecided(String),
}

/// Extremes along a run: (value, time), nothing where no sample has a value.
#[derive(Default)]
pub struct Nearest {
    /// The least and the greatest determinant.
    pub determinant: Option<(f64, f64)>,
    /// The least |det A / det A(t₀)|.
    pub relative: Option<(f64, f64)>,
    /// The least reciprocal condition number.
    pub condition: Option<(f64, f64)>,
    /// The least absolute value of each divisor of the kinematic equations.
    pub divisors: Vec<Option<(f64, f64)>>,
}

/// A figure and its caption.
pub struct Figure {
    /// The caption.
    pub caption: String,
    /// An `<svg>` element.
    pub svg: String,
    /// Lesson from the figure, below the caption.
    pub remark: Option<String>,
    /// Tables with every plotted point, relative to the page.
    pub data: Vec<String>,
}

/// Recommended equations, solve and method, as measured.
pub struct Advice {
    /// In words.
    pub lead: String,
    /// (accuracy, the fastest run that reaches it).
    pub rows: Vec<(f64, Option<Choice>)>,
}

/// One run that was measured.
pub struct Choice {
    /// The name of the equations.
    pub equations: String,
    /// Solution for the accelerations: eliminated or numeric.
    pub solve: &'static str,
    /// The method.
    pub method: &'static str,
    /// Its tolerance; none where no steps are taken.
    pub tolerance: Option<f64>,
    /// Computing time of the run, s.
    pub seconds: f64,
    /// Its error.
    pub error: f64,
}
