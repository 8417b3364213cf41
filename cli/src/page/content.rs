//! Content of the page about a model, as data without HTML.

use tripos::ReducedScene;
use tripos::studies::model_analysis::ModelAnalysis;
use tripos_codegen::plan::Costs;
use tripos_derive::mechanics::DerivationInSteps;
use tripos_derive::{Formulation, Model};

/// Content of the page about a model, before it is written as HTML.
pub struct Page<'a> {
    /// Model of the mechanism on the page.
    pub model: &'a Model,
    /// Equations of motion by each formulation; `Err` is the reason why there are none.
    pub derivations: Vec<(Formulation, Result<DerivationInSteps, String>)>,
    /// Proofs about the equations, with the verdict on the publication in the model's folder.
    pub study: &'a ModelAnalysis,
    /// Sections about the scenes that were run, in order.
    pub scenes: Vec<SceneSection>,
    /// Sketch of the mechanism; `Err` is the reason why there is none.
    pub sketch: Result<SketchPicture, String>,
    /// Motion of one of the scenes, shown as a moving figure; `None` if there is none.
    pub moving: Option<MotionFigure>,
    /// Reason why the page is incomplete; `None` if it is complete.
    pub unfinished: Option<String>,
    /// Path of the model, in the form that `tripos` commands accept.
    pub file: String,
}

/// Sketch of the mechanism as textbooks draw it, with its caption.
pub struct SketchPicture {
    /// Picture as an `<svg>` element.
    pub svg: String,
    /// Caption with the values of the coordinates in the sketch.
    pub caption: String,
}

/// Motion of one scene for the page's moving figure.
pub struct MotionFigure {
    /// Index of the scene whose motion the figure shows.
    pub scene: usize,
    /// Moving figure; `Err` is the reason why there is none.
    pub viewer: Result<Viewer, String>,
}

/// Moving figure of the page in three parts: HTML, style and script.
pub struct Viewer {
    /// HTML element of the moving figure.
    pub figure: String,
    /// CSS of the figure, which styles no other element.
    pub style: &'static str,
    /// HTML element `<script>` that moves the figure.
    pub script: String,
    /// Warning that the shown motion is misleading; `None` if it is not.
    pub doubt: Option<String>,
}

/// Section of the page about a scene that was run.
pub struct SceneSection {
    /// Path of the scene file, in the form that `tripos` commands accept.
    pub file: String,
    /// Title of the scene.
    pub title: String,
    /// Description of the scene, from its file.
    pub about: String,
    /// Given data of the scene, each with a heading: parameters, start, span, integration, domain.
    pub facts: Vec<(&'static str, SceneFact)>,
    /// Reduced equations of the scene; `Err` is the reason why there are none.
    pub needs: Result<ReducedEquationsContent, String>,
    /// Runs of the scene: one for each formulation, one by reduced equations, and one for each
    /// printed system.
    pub runs: Vec<RunRow>,
    /// Claims about the motion, with the verdicts of rigorous runs.
    pub claims: Vec<ClaimRow>,
    /// Printed systems that could not be run, each as (name, reason).
    pub not_run: Vec<(String, String)>,
    /// Figures of the scene, in the order of its file.
    pub figures: Vec<Figure>,
    /// Reasons why figures cannot be drawn for the scene, one sentence each.
    pub not_drawn: Vec<String>,
    /// Recommended equations, solve and method; `None` if the scene was not measured.
    pub advice: Option<Advice>,
    /// Figure of the first integrals over time; `None` if there are no first integrals or no curves.
    pub integrals: Option<Figure>,
    /// Figure of determinants, condition numbers and kinematic divisors over time; `None` if there are no curves.
    pub nearness: Option<Figure>,
}

/// Given datum of a scene: values or words.
pub enum SceneFact {
    /// Numbers such as parameters: pairs of name and value.
    Values(Vec<(String, f64)>),
    /// Given datum in words, such as the integration method.
    Words(String),
}

/// Reduced equations of a scene, and their cost compared with the whole model.
pub struct ReducedEquationsContent {
    /// Reduced equations of the scene: those states and equations that its outputs need.
    pub reduced: ReducedScene,
    /// Numbers of operations in an evaluation of the reduced equations and of the whole model's equations.
    pub costs: Costs,
}

/// Claim about the motion of a scene, as a row of the page's table of claims.
pub struct ClaimRow {
    /// Claim as it is written in the scene.
    pub claim: String,
    /// Title of the equations whose motion is meant.
    pub equations: String,
    /// Words of a publication on which the claim decides; empty if there are none.
    pub printed: String,
    /// Explanation in words; empty if there is none.
    pub about: String,
    /// Verdict of a rigorous run.
    pub outcome: ClaimOutcome,
}

/// Verdict of a rigorous run on a claim, for the page.
pub enum ClaimOutcome {
    /// The claim is proved at all instants of the scene.
    Proved,
    /// The claim is proved to be false at an instant before `by`, s.
    Refuted {
        /// Instant, s.
        by: f64,
    },
    /// The claim is neither proved nor refuted over the whole scene.
    Open {
        /// Instant up to which the claim is proved, s; `None` if it is not proved at the start.
        proved_to: Option<f64>,
    },
    /// There is no rigorous run, for this reason.
    NotJudged(String),
}

/// Results of a run, as a row of the page's table of runs.
pub struct RunRow {
    /// Title of the equations that were run, for a heading.
    pub title: String,
    /// Id of the printed system; `None` for derived and reduced equations.
    pub printed: Option<String>,
    /// Name of the integration method.
    pub method: &'static str,
    /// Form of the code that was run: `compiled` or `interpreted`.
    pub code: String,
    /// Number of accepted integration steps of the run.
    pub steps: u64,
    /// Number of rejected integration steps of the run.
    pub rejected: u64,
    /// Number of evaluations of the right-hand side.
    pub evaluations: u64,
    /// Time of the motion at which the run ended, s.
    pub t_end: f64,
    /// True if the run reached the end of its span.
    pub arrived: bool,
    /// Reason why the run ended, as a sentence.
    pub stop: String,
    /// Standing of the run: the verdict on its equations and on its accuracy.
    pub standing: Standing,
    /// Largest change of the total energy that is not explained by work, J; `None` if the equations do not give the
    /// energy.
    pub energy_drift: Option<f64>,
    /// Number of correct digits of the least accurate value at the end of the run, estimated by a
    /// second run. `None` if not assessed, or if the equations are wrong.
    pub digits: Option<f64>,
    /// Time from which on the run has fewer than three correct digits, s. `None` if it always has three, or if not
    /// assessed.
    pub few_from: Option<f64>,
    /// Further warnings about the run, one sentence each.
    pub warnings: Vec<String>,
    /// Largest change of each first integral along the run. Empty if the run does not record every state.
    pub changes: Vec<f64>,
    /// Least distances of the run from singular configurations.
    pub nearest: SingularityDistances,
}

/// Standing (trustworthiness) of a run: the verdict on its equations, and on its accuracy.
#[derive(Clone, Debug, PartialEq)]
pub enum Standing {
    /// Right: derived equations, or printed equations that are proved to give the same motion, integrated to the
    /// requested tolerance.
    Right,
    /// Loose: right equations, but integrated with tolerances that leave few correct digits.
    Loose {
        /// Description of the integration method and its tolerances.
        how: String,
        /// Error at the end of the run, the largest |e|/(1 + |value|); `Err` is the reason why it
        /// is unknown.
        error: Result<f64, String>,
    },
    /// Stopped: right equations, but the run ended before the end of its span.
    Stopped,
    /// Wrong: printed equations that do not give the derived accelerations, even if their run
    /// reaches its end.
    Wrong,
    /// Undecided: printed equations that could not be compared with the derived accelerations. The text is the reason.
    Undecided(String),
}

/// Smallest distances of a run from singular configurations. Most distances are pairs (value, time in s), or `None` if
/// no sample has a value.
#[derive(Default)]
pub struct SingularityDistances {
    /// Smallest and largest determinant of the matrix A along the run. `None` if no sample has a determinant.
    pub determinant: Option<(f64, f64)>,
    /// Smallest |det A/det A(t₀)| of the matrix A of the Newton–Euler equations, with its time in
    /// s; `None` without such a matrix.
    pub relative: Option<(f64, f64)>,
    /// Smallest reciprocal condition number of A, with its time in s. `None` if no sample has a condition number.
    pub condition: Option<(f64, f64)>,
    /// Smallest absolute value of each divisor of the kinematic equations, with its time in s.
    pub divisors: Vec<Option<(f64, f64)>>,
}

/// Figure of the page, with its caption.
pub struct Figure {
    /// Caption of the figure, below its picture.
    pub caption: String,
    /// Picture as an `<svg>` element.
    pub svg: String,
    /// Conclusion from the figure, shown below the caption; `None` if there is none.
    pub remark: Option<String>,
    /// Links to the tables with every plotted point, relative to the page's folder.
    pub data: Vec<String>,
}

/// Recommendation of equations, solve and method for a scene, based on measurements.
pub struct Advice {
    /// Recommendation of equations, solve and method in words.
    pub lead: String,
    /// Rows of the table of recommended runs: an accuracy, and the fastest run that reaches it; `None` if no run does.
    pub rows: Vec<(f64, Option<RecommendedRun>)>,
}

/// Measured run that is recommended for an accuracy.
pub struct RecommendedRun {
    /// Name of the recommended equations, such as `kane`.
    pub equations: String,
    /// Way to solve for the accelerations: `eliminated` or `numeric`.
    pub solve: &'static str,
    /// Name of the integration method.
    pub method: &'static str,
    /// Tolerance of the run; `None` for a method without steps.
    pub tolerance: Option<f64>,
    /// Median computing time of the run, s.
    pub seconds: f64,
    /// Error of the run at its end, the largest |e|/(1 + |reference|).
    pub error: f64,
}
