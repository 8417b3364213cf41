//! Arguments of the command line. Doc comments of options are the help texts that the command prints.

use clap::{Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use std::path::PathBuf;
use tripos::{EquationsName, Error, Overrides};

/// Derives the equations of motion of a mechanism by Kane, Lagrange and Newton–Euler from one model
/// file, generates Rust for them, and runs it.
///
/// Exit status: 0 done; 1 the answer is "no" (stale, different); 2 bad input; 3 a run that could not
/// go on; 130 interrupted, with what was finished kept. With --json, standard output is the JSON alone, also that
/// of a failure.
#[derive(Parser)]
#[command(name = "tripos", version)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    /// Derive, run every scene of a model by all formulations, and write one page that shows it
    Page(Page),
    /// Print the equations of motion of a model
    Derive {
        /// A model file, or a folder with model.toml
        model: PathBuf,
        /// kane, lagrange or newton-euler; all that the model supports if not given
        #[arg(long)]
        by: Option<String>,
        /// Formulas written out, or in steps that have names; written out where they fit some two pages if not given
        #[arg(long, value_enum)]
        form: Option<Form>,
        /// Notation of the mathematics
        #[arg(long, value_enum, default_value_t = Format::Text)]
        format: Format,
        /// Sections of LaTeX for another document to \\input, and not a document
        #[arg(long)]
        fragment: bool,
        /// Print JSON, as --format json does
        #[arg(long, conflicts_with = "format")]
        json: bool,
    },
    /// Say what a model is: its freedoms, integrable or redundant constraints, singularities of its speeds, and unused
    /// declarations
    Check {
        /// A model file, or a folder with model.toml
        model: PathBuf,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Prove the formulations equivalent and find what the motion conserves; exit status 1 if they are not
    Prove {
        /// A model file, or a folder with model.toml
        model: PathBuf,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Find rest positions and steady motions, and say whether they are stable
    Equilibria {
        /// A model file, or a folder with model.toml
        model: PathBuf,
        /// A state file or a scene to begin from: values under [guess] are sought, values under [state] are held;
        /// without [guess], all coordinates are sought, and all speeds if one is not 0. If not given, only the
        /// conditions in closed form are printed
        #[arg(long, value_name = "STATE")]
        from: Option<PathBuf>,
        /// Begin also from so many other places
        #[arg(long, value_name = "COUNT", default_value_t = 0, requires = "from")]
        starts: u64,
        /// Follow the steady motion along a parameter, a held value, or a name of the state file, and find where its
        /// stability changes; twice, for a map over two of them
        #[arg(long, value_name = "NAME=FROM:TO:COUNT", requires = "from")]
        over: Vec<String>,
        /// In closed form solve for this coordinate, velocity or parameter rather than for others; may be given again
        #[arg(long = "for", value_name = "NAME", conflicts_with = "over")]
        wanted: Vec<String>,
        /// Draw the followed motions to this file, .svg, .png or .pdf: eigenvalues over one number, or where stability
        /// changes over two; with the data beside it
        #[arg(long, value_name = "FILE", requires = "over")]
        out: Option<PathBuf>,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Linearise a mechanism about rest or a steady motion: A, B, C, D, eigenvalues and modes
    Linearise {
        /// A model file, or a folder with model.toml
        model: PathBuf,
        /// A state file or a scene: what is under [guess] is solved for
        #[arg(long, value_name = "STATE")]
        about: PathBuf,
        /// An input of the model, or a parameter, for B; all inputs of the model if none is given
        #[arg(long = "input", value_name = "NAME")]
        inputs: Vec<String>,
        /// An output for C, a name or a formula, beside the `outputs` of the file
        #[arg(long = "output", value_name = "FORMULA")]
        outputs: Vec<String>,
        /// Keep a parameter, or a name of the state file, as a letter: A, B, C and D by exact algebra
        #[arg(long = "symbolic", value_name = "NAME")]
        letters: Vec<String>,
        /// Keep states that symmetries shift, such as where on its plane a wheel is
        #[arg(long)]
        whole: bool,
        /// Linearise about the state as it is, also if it is no equilibrium
        #[arg(long)]
        as_is: bool,
        /// Language of the matrices
        #[arg(long, value_enum, default_value_t = Notation::Text, conflicts_with = "json")]
        format: Notation,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Compute the forces that a motion needs, and the inputs that give them; exit status 1 if no inputs do
    Inverse {
        /// A model file, or a folder with model.toml
        model: PathBuf,
        /// A motion: TOML with [state] and [accelerations], or with [motion] (coordinates as formulas of t) and
        /// [times]; or a CSV table with a column for every coordinate, speed and acceleration
        #[arg(long, value_name = "FILE", visible_alias = "at")]
        motion: PathBuf,
        /// An input of the model, or a parameter that loads are linear in, to solve for; all inputs of the model if
        /// none is given
        #[arg(long = "input", value_name = "NAME")]
        inputs: Vec<String>,
        /// Print a CSV table, a row an instant
        #[arg(long, conflicts_with = "json")]
        csv: bool,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Find the base parameters: what of the inertia of bodies, and of loads, can be identified from motion
    Identify {
        /// A model file, or a folder with model.toml
        model: PathBuf,
        /// Ask of the parameters that the file declares, as they enter, and not of all ten inertial parameters of every
        /// body
        #[arg(long)]
        declared: bool,
        /// A motion, as `inverse` takes it: the regressor at its instants is printed with --csv and --json
        #[arg(long, value_name = "FILE")]
        at: Option<PathBuf>,
        /// Print the regressor as a CSV table, a row for each speed at each instant
        #[arg(long, conflicts_with = "json", requires = "at")]
        csv: bool,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Compare a model with a published derivation, or with an edited model; exit status 1 if anything differs
    Diff {
        /// A model file, or a folder with model.toml
        model: PathBuf,
        /// A publication file (docs/publication.md), or the newer of two models
        other: PathBuf,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Write generated/ anew from models/
    Regenerate {
        /// Models of the workspace, by the names of their folders; all of them if none is given
        models: Vec<PathBuf>,
        /// Only say what would change; exit status 1 if anything would
        #[arg(long)]
        check: bool,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Write a commented model and a scene of it into a new folder, to begin from
    New {
        /// The folder to make
        #[arg(value_name = "NAME")]
        folder: PathBuf,
        /// Begin from this model and its scenes: a model file, a folder with model.toml, or a name of the library here
        #[arg(long, value_name = "MODEL")]
        like: Option<PathBuf>,
    },
    /// Print the JSON Schema of a format of files, for editors
    Schema {
        /// Format of the files
        #[arg(value_parser = tripos_derive::schema::Format::ALL.map(tripos_derive::schema::Format::name))]
        format: String,
    },
    /// Print completions for a shell, to be read by it when it starts
    ///
    /// For example, for bash:
    ///
    ///   tripos completions bash > ~/.local/share/bash-completion/completions/tripos
    #[command(verbatim_doc_comment)]
    Completions {
        /// Shell for which completions are printed
        shell: Shell,
    },
    /// Print the manual page, or those of all commands into a folder
    Man {
        /// Folder for the pages, tripos.1 and one for each command
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
    },
    /// Write the generated code of any model file for programs of your own: a Rust module, or JavaScript modules
    Emit {
        /// A model file, or a folder with model.toml
        model: PathBuf,
        /// The folder of the module, named as the module; files in it that this command did not write stay untouched
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        /// rust: mod.rs, and one file for each formulation; js: one module for each formulation, kane.mjs, with
        /// dop853.mjs and run.mjs
        #[arg(long, value_name = "LANGUAGE", default_value = "rust")]
        language: String,
        /// kane, lagrange or newton-euler, more than once for several; all that the model supports if not given, and
        /// what the publication beside it prints
        #[arg(long = "formulation", value_name = "F")]
        formulations: Vec<String>,
        /// Further functions for Rust: jacobian, its entries for implicit methods, which else differentiate the code as
        /// it runs; taylor, recurrences for Taylor's method
        #[arg(long, value_name = "FUNCTIONS", value_delimiter = ',')]
        with: Vec<String>,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Evaluate the equations of motion at one state
    Evaluate {
        /// A model file, or a folder with model.toml
        model: PathBuf,
        /// kane, lagrange, newton-euler, or printed:ID for a system of the publication beside the model
        #[arg(long)]
        by: String,
        /// A TOML file with [parameters] and [state]
        #[arg(long, value_name = "STATE.toml")]
        at: PathBuf,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Run a scene
    Simulate(Simulate),
    /// Draw quantities of one or several runs over time, or against one another, with the data beside the figure
    ///
    /// For example, two angles in one panel and the energy below, a phase portrait, and two methods beside one another:
    ///
    ///   tripos plot SCENE --what 'q1, q2' --what total_energy --out figure.pdf
    ///
    ///   tripos plot SCENE --what u1 --against q1
    ///
    ///   tripos plot SCENE --what integrals --also method=ode45,rtol=1e-3
    #[command(verbatim_doc_comment)]
    Plot(Plot),
    /// Print what a scene keeps of its model, what it leaves out, and why that is exact
    Scene {
        /// A scene file
        scene: PathBuf,
        #[command(flatten)]
        set: Set,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Draw a mechanism as textbooks do: bodies, frames, coordinates, points, gravity and where the ground holds it
    ///
    /// For example, for a page and for a thesis:
    ///
    ///   tripos sketch models/disk --out disk.svg
    ///
    ///   tripos sketch models/disk --out disk.tex
    #[command(verbatim_doc_comment)]
    Sketch {
        /// A model file, a folder with model.toml, or a scene file; of a model its first scene is drawn
        #[arg(value_name = "MODEL|SCENE")]
        model: PathBuf,
        /// Draw exactly this state: a TOML file with [parameters] and [state]
        #[arg(long, value_name = "STATE.toml")]
        at: Option<PathBuf>,
        /// File of the picture: .svg, .png, .pdf, or .tex for LaTeX with TikZ
        #[arg(long, value_name = "FILE", default_value = "sketch.svg")]
        out: PathBuf,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Write a scene's motion as a 3-D view that plays: one file that needs nothing else
    ///
    /// For example, the publication's printed equations as ghosts beside the derived ones:
    ///
    ///   tripos view models/disk/scenes/report.toml --against printed:kane-final --out disk.html
    #[command(verbatim_doc_comment)]
    View(View),
    /// Run a scene from many starts or with many parameters, on all cores
    ///
    /// For example, the disk from a thousand leans, and the second hundredth of half a million runs between the Moon's
    /// gravity and the Earth's:
    ///
    ///   tripos sweep models/disk/scenes/report-10s.toml --over q2=0.01:1.5:1000 --out leans.csv
    ///
    ///   tripos sweep models/disk/scenes/report-10s.toml --over g=1.62:9.81:500 --over 'q2=1*deg:80*deg:1000' \
    ///       --shard 2/100 --out part-002.csv
    ///
    /// Exit status: 0 if every point has an answer, 3 if one could not start or go on; its row says why. docs/sweep.md
    /// describes the table.
    #[command(verbatim_doc_comment)]
    Sweep(Sweep),
    /// Find where runs of a scene give way: passages, conditioning, domain, growth of errors, drifts
    Stability {
        /// A scene file
        scene: PathBuf,
        #[command(flatten)]
        set: Set,
        /// Shorter runs and fewer steps
        #[arg(long)]
        quick: bool,
        /// Folder for the table and the figures
        #[arg(long, default_value = "target/stability")]
        out: PathBuf,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Measure a scene by every formulation, solve and method at many tolerances: speed against accuracy
    Chart {
        /// A scene file
        scene: PathBuf,
        #[command(flatten)]
        set: Set,
        /// Fewer tolerances and repeats: less than two minutes
        #[arg(long)]
        quick: bool,
        /// Also the printed equations of the publication beside the model
        #[arg(long)]
        printed: bool,
        /// Folder for the tables and the chart
        #[arg(long, default_value = "target/chart")]
        out: PathBuf,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
}

/// A page about a model.
#[derive(clap::Args)]
pub struct Page {
    /// A model file, or a folder with model.toml and its scenes; in a workspace, models/disk if not given
    pub model: Option<PathBuf>,
    /// Folder for index.html
    #[arg(long, default_value = "target/page")]
    pub out: PathBuf,
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
    /// events, and in the columns d(NAME)/d(PARAMETER) of --csv; more than once for several. Whole equations are run
    #[arg(long, value_name = "NAME")]
    pub sensitivity: Vec<String>,
    /// Also print the derivatives of this output, coordinate, speed or energy at the end, or of t, the instant at which
    /// an event ends the run, by all parameters and all numbers of the start at once. Whole equations are run
    #[arg(long, value_name = "NAME")]
    pub gradient: Option<String>,
    /// Write the samples to this file; one that is there is replaced if its name ends in .csv
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Replace the file of --csv whatever its name is; never what the run reads
    #[arg(long, requires = "csv")]
    pub overwrite: bool,
    /// End with status 3 also where a warning says not to trust the run, or where its digits are not assessed
    #[arg(long)]
    pub strict: bool,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
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
    /// scene of the same model; more than once for several
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
    /// Threads; all that the machine has if not given. The results do not depend on them
    #[arg(long)]
    pub threads: Option<usize>,
    /// A column of digits: how many are right at the end, by a second run of each point, which takes about as long
    #[arg(long)]
    pub digits: bool,
    /// Write a row for each point to this file
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

/// Other values for numbers of a scene.
#[derive(clap::Args)]
pub struct Set {
    /// Another value of a parameter or of a number of the start, as the scene would state it: NAME=VALUE, more than
    /// once for several
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
}

/// Options with which the command line overrides a scene's integration.
#[derive(clap::Args)]
pub struct RunOptions {
    /// kane, lagrange, newton-euler, or printed:ID for a system of the publication beside the model. If not given,
    /// `simulate` and `plot` take the scene's reduced equations where these are a gain (`tripos scene`), `view` and
    /// `sweep` the first formulation that the model supports
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
    /// The last instant, s; before the first, the run goes backward
    #[arg(long, allow_negative_numbers = true)]
    pub until: Option<f64>,
}

impl RunOptions {
    /// Settings of the command line that override the scene's; `None` keeps the scene's value.
    ///
    /// # Errors
    /// [`Error::Request`] for an unknown name of a method, solve or invariant.
    pub fn overrides(&self) -> Result<Overrides, Error> {
        let Self { by, method, project, solve, step, max_step, rtol, atol, until } = self;
        Ok(Overrides {
            by: by.as_deref().map(EquationsName::from),
            method: method.as_deref().map(str::parse).transpose()?,
            project: project.as_deref().map(str::parse).transpose()?,
            solve: solve.as_deref().map(str::parse).transpose()?,
            step: *step,
            max_step: *max_step,
            rtol: *rtol,
            atol: *atol,
            until: *until,
        })
    }
}

/// Notation of formulas in a document.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// The language of model files
    Text,
    /// A document of LaTeX
    Latex,
    /// Markdown, with formulas as GitHub shows them
    Markdown,
    /// A document of Typst
    Typst,
    /// A program in Python that defines the equations for SymPy
    Sympy,
    /// `MathML` for web pages
    Mathml,
    /// Text inside JSON
    Json,
}

/// Form of printed equations.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Form {
    /// Every formula written out
    Closed,
    /// Terms that grow have names, and each formula contains the names before it
    Steps,
}

/// Language of a printed linear system.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Notation {
    /// Words and tables
    Text,
    /// `NumPy` arrays
    Python,
    /// Matrices, and a model of the Control System Toolbox where there are inputs and outputs
    Matlab,
    /// Matrices for a document with amsmath
    Latex,
}

impl Command {
    /// True if the command prints JSON.
    pub fn is_json(&self) -> bool {
        match self {
            Self::Derive { format, json, .. } => *json || *format == Format::Json,
            Self::Check { json, .. }
            | Self::Regenerate { json, .. }
            | Self::Emit { json, .. }
            | Self::Sketch { json, .. }
            | Self::Stability { json, .. }
            | Self::Chart { json, .. }
            | Self::Equilibria { json, .. }
            | Self::Linearise { json, .. }
            | Self::Inverse { json, .. }
            | Self::Identify { json, .. }
            | Self::Prove { json, .. }
            | Self::Diff { json, .. }
            | Self::Evaluate { json, .. }
            | Self::Scene { json, .. } => *json,
            Self::Page(request) => request.json,
            Self::Plot(request) => request.json,
            Self::View(request) => request.json,
            Self::Simulate(request) => request.json,
            Self::Sweep(request) => request.json,
            _ => false,
        }
    }
}

#[cfg(test)]
mod documented_tests;
