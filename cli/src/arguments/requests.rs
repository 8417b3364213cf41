//! Options of the commands that run scenes, one struct for each command, and the options that several of them share.

use std::path::PathBuf;
use tripos::{EquationsName, Error, Overrides};

/// A page about a model.
#[derive(clap::Args)]
pub struct Page {
    /// A model file, or a folder with model.toml and its scenes; in a workspace, models/disk if not given
    pub model: Option<PathBuf>,
    #[command(flatten)]
    pub set: Set,
    /// Folder for index.html
    #[arg(long, default_value = "target/page")]
    pub out: PathBuf,
    /// A further formulation that is derived on request only, such as gibbs-appell; may be given more than once
    #[arg(long, value_name = "F")]
    pub also: Vec<String>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// A run of a scene.
#[derive(clap::Args)]
pub struct Simulate {
    /// A scene file
    pub scene: PathBuf,
    #[command(flatten)]
    pub set: Set,
    #[command(flatten)]
    pub how: RunOptions,
    /// Also print the derivatives of all shown quantities by a parameter or a number of the start, at the end, at
    /// events, and in the columns d(NAME)/d(PARAMETER) of --csv; may be given more than once. Whole equations are run
    #[arg(long, value_name = "NAME")]
    pub sensitivity: Vec<String>,
    /// Also print the derivatives of this output, coordinate, speed or energy at the end, or of t, the instant at which
    /// an event ends the run, by all parameters and all numbers of the start at once. Whole equations are run
    #[arg(long, value_name = "NAME")]
    pub gradient: Option<String>,
    #[command(flatten)]
    pub enclosure: EnclosureOptions,
    /// Write the samples to this file: CSV, or Parquet or Arrow by its ending, as docs/files.md says; one that is
    /// there is replaced if it has one of these endings
    #[arg(long, visible_alias = "out", value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Replace the file of --csv, whatever its name is; files that the run reads are never replaced
    #[arg(long, requires = "csv")]
    pub overwrite: bool,
    /// Also end with status 3 if a warning says not to trust the run, or if its correct digits are not known
    #[arg(long)]
    pub strict: bool,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// Options of a rigorous run.
#[derive(clap::Args)]
pub struct EnclosureOptions {
    /// Enclose the motion instead: boxes that provably contain what is shown, at the number of `samples` of the scene
    /// and at the end, with all rounding and truncation errors bounded. docs/rigorous.md
    #[arg(long, conflicts_with_all = ["sensitivity", "gradient", "strict", "method", "solve", "rtol", "atol", "step"])]
    pub rigorous: bool,
    /// A claim that --rigorous proves, refutes or leaves open, beside `claims` of the scene: FORMULA < FORMULA or
    /// FORMULA > FORMULA, at all instants of the run; may be given more than once
    #[arg(long, requires = "rigorous", value_name = "CLAIM")]
    pub claim: Vec<String>,
}

/// A figure of runs.
#[derive(clap::Args)]
pub struct Plot {
    /// Scene files
    #[arg(required = true, value_name = "SCENE")]
    pub scenes: Vec<PathBuf>,
    /// Quantities of a panel, with commas between them: names or formulas as in `outputs` of a scene; or `integrals`
    /// for the changes of all conserved quantities. If not given, each shown quantity of the scene has a panel
    #[arg(long, value_name = "QUANTITIES")]
    pub what: Vec<String>,
    /// Quantity on the horizontal axis; the time if not given
    #[arg(long, value_name = "QUANTITY")]
    pub against: Option<String>,
    /// A further curve of each scene, run in another way: by, method, solve, step, rtol, atol
    #[arg(long, value_name = "KEY=VALUE,…")]
    pub also: Vec<String>,
    /// The figure, .svg, .png or .pdf, or .csv for its data alone, which are written beside every figure; if not given,
    /// an .svg named as the first scene
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Pixels of an inch of a .png
    #[arg(long, value_name = "DOTS", default_value_t = crate::picture::DPI)]
    pub dpi: u32,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub set: Set,
    #[command(flatten)]
    pub how: RunOptions,
}

/// A view of a scene.
#[derive(clap::Args)]
pub struct View {
    /// A scene file
    pub scene: PathBuf,
    #[command(flatten)]
    pub set: Set,
    #[command(flatten)]
    pub how: RunOptions,
    /// Also show, transparent: the scene by other equations (kane, lagrange, newton-euler, printed:ID), or another
    /// scene of the same model; may be given more than once
    #[arg(long, value_name = "F|SCENE")]
    pub against: Vec<String>,
    /// File of the view
    #[arg(long, value_name = "FILE.html", default_value = "view.html")]
    pub out: PathBuf,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// Runs of a scene from many starts or with many parameters.
#[derive(clap::Args)]
#[allow(clippy::struct_excessive_bools, reason = "each is an option of its own")]
pub struct Sweep {
    /// A scene file
    pub scene: PathBuf,
    /// Values of a parameter or of a number of the start: NAME=FROM:TO:COUNT (evenly spaced, both ends included),
    /// NAME=FROM:TO:COUNT:log, or NAME=a,b,c, each as a scene would state it; of several, every combination, the last
    /// varying fastest
    #[arg(long, required = true, value_name = "NAME=VALUES")]
    pub over: Vec<String>,
    #[command(flatten)]
    pub how: RunOptions,
    /// Run the i-th of n parts of the points; the files of all parts, one after another with one header, are the file
    /// of the whole sweep
    #[arg(long, value_name = "I/N", default_value = "1/1")]
    pub shard: String,
    /// Number of threads; by default one for each core. The results do not depend on it
    #[arg(long)]
    pub threads: Option<usize>,
    /// A column of digits: how many are right at the end, by a second run of each point, which takes about as long
    #[arg(long)]
    pub digits: bool,
    /// Write a row for each point to this file: CSV, or Parquet or Arrow by its ending, as docs/files.md says
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Replace the file if it is there
    #[arg(long)]
    pub overwrite: bool,
    /// Go on where this sweep was interrupted or killed: the rows in FILE.part stay, and the others are run. A sweep
    /// begun with other options or other files is refused
    #[arg(long)]
    pub resume: bool,
    /// Print a summary as JSON
    #[arg(long)]
    pub json: bool,
}

/// Parameters from measurements.
#[derive(clap::Args)]
#[allow(clippy::struct_excessive_bools, reason = "each is an option of its own")]
pub struct Fit {
    /// A scene, whose runs are fitted to measured motions; or a model, whose base parameters are fitted to measured
    /// motions and forces
    #[arg(value_name = "SCENE|MODEL")]
    pub target: PathBuf,
    /// A table of measurements, CSV; may be given more than once, for several experiments
    #[arg(long, required = true, value_name = "FILE.csv")]
    pub data: Vec<PathBuf>,
    /// A parameter, or a number of the start, to be found from the scene's value: NAME, or NAME=LOW:HIGH within bounds;
    /// for a scene
    #[arg(long = "for", value_name = "NAME[=LOW:HIGH]")]
    pub unknowns: Vec<String>,
    /// A value that an unknown probably has, with its standard deviation; for a scene
    #[arg(long = "prior", value_name = "NAME=VALUE:DEVIATION")]
    pub priors: Vec<String>,
    /// The standard deviation of a measured quantity or force; otherwise it is estimated from the residuals
    #[arg(long, value_name = "NAME=DEVIATION")]
    pub noise: Vec<String>,
    /// Let large residuals count linearly (Huber's loss), so that outliers move the estimates little
    #[arg(long)]
    pub robust: bool,
    /// Fit the parameters that the model file declares, instead of all ten inertial parameters of every body; for a
    /// model
    #[arg(long)]
    pub declared: bool,
    /// Also find inertial parameters that real bodies can have, nearest to the measured forces; for a model
    #[arg(long)]
    pub possible: bool,
    /// Filter all columns with a low-pass filter without delay, of this cut-off frequency; for a model
    #[arg(long, value_name = "HZ", allow_negative_numbers = true)]
    pub filter: Option<f64>,
    /// Write the residuals to this file, as CSV
    #[arg(long, value_name = "FILE.csv")]
    pub residuals: Option<PathBuf>,
    #[command(flatten)]
    pub set: Set,
    #[command(flatten)]
    pub how: RunOptions,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// A motion for the estimation of base parameters.
#[derive(clap::Args)]
pub struct Excite {
    /// A model file, or a folder with model.toml
    pub model: PathBuf,
    /// Period of the motion, s
    #[arg(long, value_name = "T", default_value_t = 10.0, allow_negative_numbers = true)]
    pub period: f64,
    /// Number of harmonics in the motion of each coordinate
    #[arg(long, value_name = "L", default_value_t = 5)]
    pub harmonics: usize,
    /// Number of instants at which forces are measured, both ends included; by default 20 for each harmonic, and one
    /// more
    #[arg(long, value_name = "N")]
    pub samples: Option<usize>,
    /// Limits of a coordinate q1, of its rates q1' and q1'', or of a speed u1 and its rate u1', beside those of the
    /// domain: NAME=LOW:HIGH, or NAME=MAX for -MAX to MAX; may be given more than once
    #[arg(long = "limit", value_name = "NAME=LIMITS")]
    pub limits: Vec<String>,
    /// Begin and end at rest: rates and second rates are zero there
    #[arg(long)]
    pub rest: bool,
    /// The value of a coordinate at the start and at the end; may be given more than once
    #[arg(long, value_name = "NAME=VALUE")]
    pub home: Vec<String>,
    /// The standard deviation of a measured force, such as "force(u1)=0.1"; 1 for the others, in SI units
    #[arg(long, value_name = "NAME=DEVIATION")]
    pub noise: Vec<String>,
    /// Estimate the parameters that the model file declares, instead of all ten inertial parameters of every body
    #[arg(long)]
    pub declared: bool,
    /// Number of searches, each from its own random start
    #[arg(long, value_name = "K", default_value_t = 4)]
    pub starts: usize,
    /// Seed of the random numbers; equal seeds give equal motions
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Write the motion to this file: a table of coordinates, speeds and their rates as CSV, or formulas as a motion
    /// file if the name ends in .toml; an existing file is replaced
    #[arg(long, value_name = "FILE")]
    pub write: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// Other values for numbers of a scene.
#[derive(clap::Args)]
pub struct Set {
    /// Another value of a parameter or of a number of the start, as the scene would state it: NAME=VALUE; may be given
    /// more than once
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
}

/// Options with which the command line overrides a scene's integration.
#[derive(clap::Args)]
pub struct RunOptions {
    /// kane, lagrange, newton-euler, or printed:ID for a system of the publication beside the model. If not given,
    /// `simulate`, `plot` and `sweep` take the scene's reduced equations where these are a gain (`tripos scene`), and
    /// `view` the first formulation that the model supports
    #[arg(long)]
    pub by: Option<String>,
    /// The method of integration: rk4, ode45, dopri5, dop853, gauss6, radau5 or taylor; or quadrature, for a scene's
    /// reduced equations with one degree of freedom
    #[arg(long)]
    pub method: Option<String>,
    /// Invariant onto which each step is projected: energy, for a scene's reduced equations; the removed drift is
    /// reported
    #[arg(long)]
    pub project: Option<String>,
    /// Solution for the accelerations: eliminated (solved for when the code was generated) or numeric (the linear
    /// system at each state)
    #[arg(long)]
    pub solve: Option<String>,
    /// The length of every step, s, instead of steps chosen by the error
    #[arg(long)]
    pub step: Option<f64>,
    /// The longest step that the error may choose, s
    #[arg(long)]
    pub max_step: Option<f64>,
    /// Relative tolerance
    #[arg(long)]
    pub rtol: Option<f64>,
    /// Absolute tolerance
    #[arg(long)]
    pub atol: Option<f64>,
    /// The largest number of attempted steps
    #[arg(long)]
    pub step_limit: Option<u64>,
    /// The number of equally spaced samples, both ends included
    #[arg(long)]
    pub samples: Option<usize>,
    /// The last instant, s; before the first, the run goes backward
    #[arg(long, allow_negative_numbers = true)]
    pub until: Option<f64>,
}

impl RunOptions {
    /// Settings of the command line that override those of a scene; `None` keeps the scene's value.
    ///
    /// # Errors
    /// [`Error::Request`] for an unknown name of a method, a solve or an invariant.
    pub fn overrides(&self) -> Result<Overrides, Error> {
        let Self { by, method, project, solve, step, max_step, rtol, atol, step_limit, samples, until } = self;
        Ok(Overrides {
            by: by.as_deref().map(EquationsName::from),
            method: method.as_deref().map(str::parse).transpose()?,
            project: project.as_deref().map(str::parse).transpose()?,
            solve: solve.as_deref().map(str::parse).transpose()?,
            step: *step,
            max_step: *max_step,
            rtol: *rtol,
            atol: *atol,
            step_limit: *step_limit,
            samples: *samples,
            until: *until,
        })
    }
}

/// Form in which marks are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum MarksFormat {
    /// Lines for people.
    Text,
    /// JSON for programs.
    Json,
    /// The `results.json` of Gradescope, for one submission.
    Gradescope,
}

/// Marks for submissions.
#[derive(clap::Args)]
pub struct Grade {
    /// A model file, or a folder with model.toml
    pub model: PathBuf,
    /// Submissions: publication files (docs/publication.md), or folders of them
    #[arg(required = true)]
    pub submissions: Vec<PathBuf>,
    /// Points of entries, and the entries that a submission must have (docs/grading.md)
    #[arg(long)]
    pub rubric: Option<PathBuf>,
    /// Detail of the feedback: hint, place or term; by default that of the rubric, else hint
    #[arg(long)]
    pub level: Option<String>,
    /// Form of the marks
    #[arg(long, value_enum, default_value_t = MarksFormat::Text)]
    pub format: MarksFormat,
    /// Also write a page about all submissions to this file: who made which mistake
    #[arg(long)]
    pub out: Option<PathBuf>,
    /// Print JSON
    #[arg(long, conflicts_with = "format")]
    pub json: bool,
}
