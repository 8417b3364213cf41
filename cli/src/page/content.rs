//! What the page shows, as data.

use tripos::Reduced;
use tripos::study::Study;
use tripos_codegen::plan::Costs;
use tripos_derive::mechanics::DerivationInSteps;
use tripos_derive::{Formulation, Model};

/// What the page shows.
pub struct Page<'a> {
    /// The mechanism.
    pub model: &'a Model,
    /// Its equations of motion by each formulation, or why there are none.
    pub derivations: Vec<(Formulation, Result<DerivationInSteps, String>)>,
    /// What is proved of them, and the report beside the model, judged.
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
    /// Which scene it is of.
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
    /// What of it is not to be trusted.
    pub doubt: Option<String>,
}

/// One simulated scene.
pub struct SceneSection {
    /// Its file, as a command takes it.
    pub file: String,
    /// Its title.
    pub title: String,
    /// What it shows.
    pub about: String,
    /// What is given: parameters, start, tolerances.
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
    /// What to run it by, if that was measured.
    pub advice: Option<Advice>,
    /// First integrals over time, if there are any.
    pub integrals: Option<Figure>,
    /// Determinants, condition numbers and kinematic divisors over time.
    pub nearness: Option<Figure>,
}

/// What is given of a scene.
pub enum Fact {
    /// Names with their values.
    Values(Vec<(String, f64)>),
    /// Words.
    Words(String),
}

/// What a scene needs of its model.
pub struct Needs {
    /// Its own equations.
    pub reduced: Reduced,
    /// What a call of them costs beside one of the whole model.
    pub costs: Costs,
}

/// What came of one run.
pub struct RunRow {
    /// Which equations ran, as in a heading.
    pub title: String,
    /// The id of the printed system; none for derived equations.
    pub printed: Option<String>,
    /// The integration method.
    pub method: String,
    /// `compiled` or `interpreted`.
    pub code: String,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Calls of the right-hand side.
    pub evaluations: u64,
    /// Where the run ended, s.
    pub t_end: f64,
    /// Whether it reached the end that was asked for.
    pub arrived: bool,
    /// Why it ended, as a sentence.
    pub stop: String,
    /// Whether its equations are right, and its numbers good.
    pub standing: Standing,
    /// Largest change of total energy that no work accounts for, J; none of equations that do not know it.
    pub energy_drift: Option<f64>,
    /// Digits that every value has where the run ended, as its second run tells; nothing if that was not assessed, or the
    /// equations are not those of the motion.
    pub digits: Option<f64>,
    /// From when on there are fewer than three digits, s; nothing if they are kept, or that was not assessed.
    pub few_from: Option<f64>,
    /// What else the reader should know.
    pub warnings: Vec<String>,
    /// Largest change of each first integral; nothing of a run that does not show every state.
    pub changes: Vec<f64>,
    /// How near it came to singular places.
    pub nearest: Nearest,
}

/// What is known of the equations of a run, and of its numbers.
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
    /// What to learn from it, below the caption.
    pub remark: Option<String>,
    /// Tables with every plotted point, relative to the page.
    pub data: Vec<String>,
}

/// Which equations, solve and method to use, as measured.
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
    /// How accelerations were found.
    pub solve: &'static str,
    /// The method.
    pub method: &'static str,
    /// Its tolerance; none where no steps are taken.
    pub tolerance: Option<f64>,
    /// How long it took, s.
    pub seconds: f64,
    /// Its error.
    pub error: f64,
}
