//! Content of the page, as data.

use tripos::Reduced;
use tripos::studies::study::Study;
use tripos_codegen::plan::Costs;
use tripos_derive::mechanics::DerivationInSteps;
use tripos_derive::{Formulation, Model};

/// Content of the page about a model.
pub struct Page<'a> {
    /// Mechanism that the page describes.
    pub model: &'a Model,
    /// Equations of motion by each formulation, or the reason why there are none.
    pub derivations: Vec<(Formulation, Result<DerivationInSteps, String>)>,
    /// Proofs about the equations, and the verdict on the publication beside the model.
    pub study: &'a Study,
    /// Sections about the simulated scenes.
    pub scenes: Vec<SceneSection>,
    /// Sketch of the mechanism as textbooks draw it, or the reason why there is none.
    pub sketch: Result<Drawing, String>,
    /// Motion of one of the scenes, shown as a moving figure; `None` if there is none.
    pub moving: Option<Moving>,
    /// Reason why the page is partial; `None` if it is complete.
    pub unfinished: Option<String>,
    /// Path of the model, as a command accepts it.
    pub file: String,
}

/// A sketch of the mechanism, with its caption.
pub struct Drawing {
    /// Picture as an `<svg>` element.
    pub svg: String,
    /// Caption: the values at which the mechanism is drawn.
    pub caption: String,
}

/// Motion of a scene for the page's moving figure.
pub struct Moving {
    /// Index of the scene whose motion the figure shows.
    pub scene: usize,
    /// Moving figure, or the reason why there is none.
    pub viewer: Result<Viewer, String>,
}

/// A moving figure of the page, in its three parts.
pub struct Viewer {
    /// HTML of the figure.
    pub figure: String,
    /// CSS of the figure, which styles no other element.
    pub style: &'static str,
    /// Element `<script>` that moves the figure.
    pub script: String,
    /// Doubt about the shown motion; `None` if it can be trusted.
    pub doubt: Option<String>,
}

/// Section of the page about a simulated scene.
pub struct SceneSection {
    /// Path of the scene's file, as a command accepts it.
    pub file: String,
    /// Title of the scene.
    pub title: String,
    /// Description of the scene, from its file.
    pub about: String,
    /// Given data of the scene: parameters, start, tolerances; each with its heading.
    pub facts: Vec<(&'static str, Fact)>,
    /// Reduced equations of the scene, or the reason why there are none.
    pub needs: Result<Needs, String>,
    /// Runs: one for each formulation, one by the scene's reduced equations, then one for each printed system.
    pub runs: Vec<RunRow>,
    /// Printed systems that could not be run: (title, reason).
    pub not_run: Vec<(String, String)>,
    /// Figures of the scene.
    pub figures: Vec<Figure>,
    /// Figures that the scene cannot have, each with the reason.
    pub not_drawn: Vec<String>,
    /// Recommended equations, solve and method; `None` if they were not measured.
    pub advice: Option<Advice>,
    /// Figure of the first integrals over time; `None` if there are no first integrals or no curves.
    pub integrals: Option<Figure>,
    /// Figure of determinants, condition numbers and kinematic divisors over time; `None` without curves.
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
    /// Reduced equations of the scene.
    pub reduced: Reduced,
    /// Cost of a call of the reduced equations, beside that of the whole model's.
    pub costs: Costs,
}

/// Results of a run, as a row of the page's table of runs.
pub struct RunRow {
    /// Title of the equations that ran, for a heading.
    pub title: String,
    /// Id of the printed system; `None` for derived equations.
    pub printed: Option<String>,
    /// Name of the integration method.
    pub method: &'static str,
    /// Form of the code that ran: `compiled` or `interpreted`.
    pub code: String,
    /// Number of accepted steps.
    pub steps: u64,
    /// Number of rejected steps.
    pub rejected: u64,
    /// Number of calls of the right-hand side.
    pub evaluations: u64,
    /// Instant at which the run ended, s.
    pub t_end: f64,
    /// True if the run reached the last instant of its span.
    pub arrived: bool,
    /// Reason why the run ended, as a sentence.
    pub stop: String,
    /// Standing of the run: the verdict on its equations and on its numbers.
    pub standing: Standing,
    /// Largest change of total energy that no work accounts for, J; `None` if the equations do not know the energy.
    pub energy_drift: Option<f64>,
    /// Number of correct digits of every value at the end of the run, estimated by its second run. `None` if not
    /// assessed, or if the equations are not those of the motion.
    pub digits: Option<f64>,
    /// Time from which on the run has fewer than three correct digits, s; `None` if it keeps them, or if not assessed.
    pub few_from: Option<f64>,
    /// Further warnings about the run, for the reader.
    pub warnings: Vec<String>,
    /// Largest change of each first integral; empty for a run that does not show every state.
    pub changes: Vec<f64>,
    /// Least distances of the run from singular configurations.
    pub nearest: Nearest,
}

/// Verdict on the equations of a run, and on its numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum Standing {
    /// Derived equations, or printed ones that provably move alike, integrated to the wanted tolerance.
    Right,
    /// Right equations at tolerances that leave few digits.
    Loose {
        /// Method of integration and its tolerances, in words.
        how: String,
        /// Error at the end of the run, the largest |e| / (1 + |value|), or the reason why it is unknown.
        error: Result<f64, String>,
    },
    /// Right equations whose run could not go on.
    Stopped,
    /// Printed equations that do not give the derived accelerations, for any end of their run.
    Wrong,
    /// Printed equations whose accelerations could not be compared with the derived ones, with the reason.
    Undecided(String),
}

/// Extremes along a run: most are pairs (value, time in s), and `None` if no sample has a value.
#[derive(Default)]
pub struct Nearest {
    /// Smallest and greatest determinant of A along the run, without times.
    pub determinant: Option<(f64, f64)>,
    /// Smallest |det A / det A(t₀)| of the matrix A of the Newton–Euler equations, with its time; `None` without such a
    /// matrix.
    pub relative: Option<(f64, f64)>,
    /// Smallest reciprocal condition number of A, with its time.
    pub condition: Option<(f64, f64)>,
    /// Smallest absolute value of each divisor of the kinematic equations, with its time.
    pub divisors: Vec<Option<(f64, f64)>>,
}

/// A figure of the page, with its caption.
pub struct Figure {
    /// Caption of the figure.
    pub caption: String,
    /// Picture as an `<svg>` element.
    pub svg: String,
    /// Lesson from the figure, printed below the caption; `None` if there is none.
    pub remark: Option<String>,
    /// Links to the tables with every plotted point, relative to the page.
    pub data: Vec<String>,
}

/// Recommended equations, solve and method, as measured.
pub struct Advice {
    /// Recommendation in words.
    pub lead: String,
    /// Rows of the table of advice: an accuracy, and the fastest run that reaches it, or `None`.
    pub rows: Vec<(f64, Option<Choice>)>,
}

/// A measured run that is recommended.
pub struct Choice {
    /// Name of the equations that ran.
    pub equations: String,
    /// Solution for the accelerations: eliminated or numeric.
    pub solve: &'static str,
    /// Name of the integration method.
    pub method: &'static str,
    /// Tolerance of the run; `None` if it takes no steps.
    pub tolerance: Option<f64>,
    /// Computing time of the run, s.
    pub seconds: f64,
    /// Error of the run at its end, the largest |e| / (1 + |reference|).
    pub error: f64,
}
