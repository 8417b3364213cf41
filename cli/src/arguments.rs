//! Arguments of the command line. Doc comments of options are the help texts that the command prints.

mod excite_options;
mod fit_options;
mod notations;
mod requests;

pub use notations::{CertificateFormat, Form, Format, Notation};
pub use requests::{Excite, Fit, Grade, MarksFormat, Page, Plot, Set, Simulate, Sweep, View};

use clap::{Parser, Subcommand};
use clap_complete::Shell;
use std::path::PathBuf;

/// Derives the equations of motion of a mechanism by Kane, Lagrange and Newton–Euler from one model
/// file, generates Rust for them, and runs it.
///
/// Exit status: 0 done; 1 the answer is "no" (stale, different); 2 bad input; 3 a run could not go on; 130 interrupted,
/// finished results are kept. With --json, standard output has JSON alone, also after a failure.
#[derive(Parser)]
#[command(name = "tripos", version)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    /// Write one page about a model: equations, proofs, and runs of every scene by all formulations
    Page(Page),
    /// Print the equations of motion of a model
    Derive {
        /// A model file, or a folder with model.toml
        model: PathBuf,
        /// A formulation, such as kane; by default the three standard ones, as far as the model supports them
        #[arg(long)]
        by: Option<String>,
        /// Print closed formulas, or formulas in named steps; closed formulas are the default if they fit on two pages
        #[arg(long, value_enum)]
        form: Option<Form>,
        /// Notation of the mathematics
        #[arg(long, value_enum, default_value_t = Format::Text)]
        format: Format,
        /// Write sections of LaTeX that another document can \\input, not a whole document
        #[arg(long)]
        fragment: bool,
        /// Print JSON, as --format json does
        #[arg(long, conflicts_with = "format")]
        json: bool,
    },
    /// Check a model: its degrees of freedom, integrable and redundant constraints, poses where its speeds do not
    /// determine the motion, and unused declarations
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
        /// A further formulation that is derived on request only, such as gibbs-appell; may be given more than once
        #[arg(long, value_name = "F")]
        also: Vec<String>,
        /// Write a certificate of the proofs, from which a program outside Tripos decides whether they hold
        #[arg(long, value_name = "FILE", conflicts_with = "also")]
        certificate: Option<PathBuf>,
        /// Format of the certificate
        #[arg(long, value_name = "FORMAT", default_value = "lines", requires = "certificate")]
        format: CertificateFormat,
        /// Prove every identity by its normal form instead of residues modulo primes; exit status 1 if a normal form is
        /// too long
        #[arg(long)]
        exact: bool,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Find rest positions and steady motions, and print the stability of each
    Equilibria {
        /// A model file, or a folder with model.toml
        model: PathBuf,
        /// A state file or a scene to begin from; Tripos solves for the values under [guess] and holds those under
        /// [state]; without [guess], it solves for all coordinates, and for all speeds if one is not 0; without this
        /// option, only the conditions in closed form are printed
        #[arg(long, value_name = "STATE")]
        from: Option<PathBuf>,
        /// Number of further starts of the search
        #[arg(long, value_name = "COUNT", default_value_t = 0, requires = "from")]
        starts: u64,
        /// Follow the steady motion along a parameter, a held value or a name of the state file, and find changes of
        /// stability; give the option twice for a map over two numbers
        #[arg(long, value_name = "NAME=FROM:TO:COUNT", requires = "from")]
        over: Vec<String>,
        /// Solve for this coordinate, velocity or parameter in closed form; may be given several times
        #[arg(long = "for", value_name = "NAME", conflicts_with = "over")]
        wanted: Vec<String>,
        /// Draw the followed motions to this .svg, .png or .pdf file: eigenvalues over one number, or the limits of
        /// stability over two; the data are written beside the file
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
        /// A state file or a scene; the values under [guess] are solved for
        #[arg(long, value_name = "STATE")]
        about: PathBuf,
        /// An input of the model, or a parameter, for B; all inputs of the model if none is given
        #[arg(long = "input", value_name = "NAME")]
        inputs: Vec<String>,
        /// An output for C, a name or a formula, beside the `outputs` of the file
        #[arg(long = "output", value_name = "FORMULA")]
        outputs: Vec<String>,
        /// Keep a parameter, or a name from the state file, symbolic: A, B, C and D are then computed exactly
        #[arg(long = "symbolic", value_name = "NAME")]
        letters: Vec<String>,
        /// Keep the states that do not influence the others, such as the place of a wheel on its plane
        #[arg(long)]
        whole: bool,
        /// Linearise about exactly this state, even if the state is no equilibrium
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
        /// Solve for this input of the model, or parameter in which loads are linear; by default all inputs of the
        /// model
        #[arg(long = "input", value_name = "NAME")]
        inputs: Vec<String>,
        /// Print a CSV table with a row for each instant
        #[arg(long, conflicts_with = "json")]
        csv: bool,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Find the base parameters: the combinations of masses, inertias and loads that can be identified from motion
    Identify {
        /// A model file, or a folder with model.toml
        model: PathBuf,
        /// Use the parameters that the file declares, instead of all ten inertial parameters of every body
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
    /// Find parameters from measurements: of motions by runs of a scene, or of motions and forces by a model
    ///
    /// Examples, with tables whose columns have the names of outputs, or of coordinates, speeds, accelerations and
    /// inputs:
    ///
    ///   tripos fit swing.toml --data swing.csv --for l --for d=0:1 --for theta
    ///
    ///   tripos fit arm.toml --data motion.csv --filter 20 --possible
    ///
    /// Exit status: 1 if the data leave a combination of the unknowns open; 3 if a search does not come to an end.
    #[command(verbatim_doc_comment)]
    Fit(Fit),
    /// Design a motion from which the base parameters of a mechanism can be estimated well: periodic, within limits
    ///
    /// Example, with a table for the robot, and the fit of the forces that were measured on it:
    ///
    ///   tripos excite arm.toml --limit q1=-1:1 --limit q2=-2:2 --limit "q1'=3" --write motion.csv
    ///
    ///   tripos fit arm.toml --data measured.csv
    ///
    /// Exit status: 1 if the motion leaves a combination of base parameters open.
    #[command(verbatim_doc_comment)]
    Excite(Excite),
    /// Compare a model with a published derivation, or with an edited model; exit status 1 if anything differs
    Diff {
        /// A model file, or a folder with model.toml
        model: PathBuf,
        /// A publication file (docs/publication.md), or the newer of two models; several are compared one after
        /// another
        #[arg(required = true, value_name = "OTHER")]
        others: Vec<PathBuf>,
        /// Find the coordinates that the publication means: other signs, zeros, orders, absolute for relative angles
        #[arg(long)]
        find_coordinates: bool,
        /// Write a certificate of the verdicts on one publication, from which a program outside Tripos decides whether
        /// they hold
        #[arg(long, value_name = "FILE", conflicts_with = "find_coordinates")]
        certificate: Option<PathBuf>,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Give marks to submissions by their root mistakes; exit status 1 if any has one
    Grade(Grade),
    /// Judge many publications: every folder that has a model and a printed derivation
    Shelf {
        /// The folder that contains these folders; by default the folder `publications` of the workspace
        folder: Option<PathBuf>,
        /// Also write a page about all publications to this file
        #[arg(long)]
        out: Option<PathBuf>,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Write the folder `generated` again from the folder `models`
    Regenerate {
        /// Models of the workspace, by the names of their folders; by default all models
        models: Vec<PathBuf>,
        /// Print what would change, and write nothing; exit status 1 if anything would change
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
        /// Copy this model and its scenes as a beginning: a model file, a folder with model.toml, or a model's name in
        /// the library
        #[arg(long, value_name = "MODEL")]
        like: Option<PathBuf>,
        /// Read this robot description as a beginning: a URDF or an MJCF file
        #[arg(long, value_name = "FILE", conflicts_with = "like")]
        from: Option<PathBuf>,
        /// Close the loops of a URDF file by this TOML file: pairs of links that are connected, and joints that follow
        /// others
        #[arg(long, value_name = "FILE.toml", requires = "from")]
        loops: Option<PathBuf>,
        /// Let the root of a URDF file move freely; by default it is fixed to the ground
        #[arg(long, requires = "from")]
        floating: bool,
        /// Keep the digits of all angles; by default 1.5708 is read as pi/2, which makes the equations shorter
        #[arg(long, requires = "from")]
        as_written: bool,
    },
    /// Print the JSON Schema of a format of files, for editors
    Schema {
        /// Format of the files
        #[arg(value_parser = tripos_derive::schema::SchemaFormat::ALL.map(tripos_derive::schema::SchemaFormat::name))]
        format: String,
    },
    /// Print completions of commands and options, for a shell to read at its start
    ///
    /// For example, for bash:
    ///
    ///   tripos completions bash > ~/.local/share/bash-completion/completions/tripos
    #[command(verbatim_doc_comment)]
    Completions {
        /// Shell for which completions are printed
        shell: Shell,
    },
    /// Print the manual page, or write those of all commands to a folder
    Man {
        /// Folder for the pages, tripos.1 and one for each command
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
    },
    /// Write the equations of a model as code in Rust, JavaScript, C, Python or MATLAB, or for CasADi, or a URDF file
    Emit {
        /// A model file, or a folder with model.toml; in languages beside Rust and JavaScript also a scene file, whose
        /// outputs and events become functions
        model: PathBuf,
        /// Folder of the module, with the module's name; files that this command did not write stay untouched
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        /// rust: mod.rs, and one file for each formulation; js: one module for each formulation, kane.mjs, with
        /// dop853.mjs and run.mjs; c: a header and a source for each formulation, with tripos.h; python and casadi: one
        /// module for each formulation; matlab: one file for each function; urdf: a robot description
        #[arg(long, value_name = "LANGUAGE", default_value = "rust")]
        language: String,
        /// A formulation, such as kane; may be given more than once; if not given, the three standard ones, as far as
        /// the model supports them, and what the publication beside it prints
        #[arg(long = "formulation", value_name = "F")]
        formulations: Vec<String>,
        /// Further functions for Rust: jacobian writes the entries of the Jacobian for implicit methods; taylor writes
        /// recurrences for Taylor's method
        #[arg(long, value_name = "FUNCTIONS", value_delimiter = ',')]
        with: Vec<String>,
        /// Functions to be written in C, Python, MATLAB or for CasADi, such as mass_matrix,forcing; all if not
        /// given, but a regressor only if named
        #[arg(long, value_name = "FUNCTIONS", value_delimiter = ',')]
        functions: Vec<String>,
        /// Write Kane's equations in base parameters, which need fewer operations; the function base_parameters gives
        /// them once; in C, Python, MATLAB or for CasADi
        #[arg(long)]
        base: bool,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Write a scene as a Functional Mock-up Unit, for model exchange and co-simulation
    Fmu {
        /// A scene file
        scene: PathBuf,
        /// File of the unit, which ends with .fmu
        #[arg(long, value_name = "FILE.fmu")]
        out: PathBuf,
        /// Version of the interface: 2 or 3
        #[arg(long, value_name = "VERSION", default_value = "3")]
        fmi: String,
        /// Another value of a parameter, or another initial value, such as m=2; may be given more than once
        #[arg(long, value_name = "NAME=VALUE")]
        set: Vec<String>,
        /// Write only the sources, without compiled code; importing tools compile the sources
        #[arg(long)]
        only_sources: bool,
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
    /// Draw quantities of one or several runs over time or against one another, and write the data beside the figure
    ///
    /// Examples: two angles above the energy; a phase portrait; two methods in one figure:
    ///
    ///   tripos plot SCENE --what 'q1, q2' --what total_energy --out figure.pdf
    ///
    ///   tripos plot SCENE --what u1 --against q1
    ///
    ///   tripos plot SCENE --what integrals --also method=ode45,rtol=1e-3
    #[command(verbatim_doc_comment)]
    Plot(Plot),
    /// Print the scene's reduced equations: the needed parts of the model, the omitted parts, and the proof that the
    /// motion stays the same
    Scene {
        /// A scene file
        scene: PathBuf,
        #[command(flatten)]
        set: Set,
        /// Print abbreviated equations instead: leave out terms as long as no shown quantity changes by more than this
        /// part of its largest size, such as 1e-3, in runs of this scene
        #[arg(long, value_name = "PART")]
        within: Option<f64>,
        /// Write a certificate that the reduced equations give motions of the whole model, from which a program outside
        /// Tripos decides whether they do
        #[arg(long, value_name = "FILE", conflicts_with_all = ["within", "set"])]
        certificate: Option<PathBuf>,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Draw a mechanism as textbooks do: bodies, frames, coordinates, points, gravity and supports
    ///
    /// Examples, for a web page and for a thesis:
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
    /// Write a scene's motion as an animated 3-D view in one file, which needs no other files
    ///
    /// Example, with the motion of the printed equations as a ghost beside the derived motion:
    ///
    ///   tripos view models/disk/scenes/report.toml --against printed:kane-final --out disk.html
    #[command(verbatim_doc_comment)]
    View(View),
    /// Run a scene from many starts or with many parameters, on all cores
    ///
    /// Examples: the disk from 1000 leans; the second of 100 parts of a grid of 500 000 runs over gravity and lean:
    ///
    ///   tripos sweep models/disk/scenes/lean.toml --over q2=0.01:1.5:1000 --out leans.csv
    ///
    ///   tripos sweep models/disk/scenes/report-10s.toml --over g=1.62:9.81:500 --over 'q2=1*deg:80*deg:1000' \
    ///       --shard 2/100 --out part-002.csv
    ///
    /// Exit status: 0 if every point has an answer; 3 if a run could not start or go on, and its row of the table gives
    /// the reason. docs/sweep.md describes the table.
    #[command(verbatim_doc_comment)]
    Sweep(Sweep),
    /// Find places where runs of a scene lose accuracy or stop: near singular surfaces, at the limits of the domain, by
    /// growing errors or by drift
    Stability {
        /// A scene file
        scene: PathBuf,
        #[command(flatten)]
        set: Set,
        /// Make shorter runs with fewer steps
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
        /// Use fewer tolerances and repeats, so that the run takes less than two minutes
        #[arg(long)]
        quick: bool,
        /// Also run the equations that the publication beside the model prints
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

impl Command {
    /// True if the command prints JSON.
    pub fn is_json(&self) -> bool {
        match self {
            Self::Derive { format, json, .. } => *json || *format == Format::Json,
            Self::Check { json, .. }
            | Self::Regenerate { json, .. }
            | Self::Emit { json, .. }
            | Self::Fmu { json, .. }
            | Self::Sketch { json, .. }
            | Self::Stability { json, .. }
            | Self::Chart { json, .. }
            | Self::Equilibria { json, .. }
            | Self::Linearise { json, .. }
            | Self::Inverse { json, .. }
            | Self::Identify { json, .. }
            | Self::Prove { json, .. }
            | Self::Diff { json, .. }
            | Self::Shelf { json, .. }
            | Self::Evaluate { json, .. }
            | Self::Scene { json, .. } => *json,
            Self::Grade(request) => request.json || request.format == MarksFormat::Json,
            Self::Page(request) => request.json,
            Self::Plot(request) => request.json,
            Self::View(request) => request.json,
            Self::Simulate(request) => request.json,
            Self::Sweep(request) => request.json,
            Self::Fit(request) => request.json,
            Self::Excite(request) => request.json,
            _ => false,
        }
    }
}

#[cfg(test)]
mod documented_tests;
