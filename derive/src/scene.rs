//! Readers of scene files and state files. A scene states the parameters, start, time span,
//! accuracy and outputs of a run. A state is a single instant: parameters, coordinates and speeds.

mod families;
mod motions;
mod numbers;
mod settings;
mod starts;

use crate::algebra::Expr;
use crate::diagnostic::{Diagnostic, Diagnostics, Source};
use crate::model::{Coordinate, Model, TIME};
use crate::toml_reader::TomlReader;
use numbers::number_reader::ValueReader;
use numbers::scene_number::{Number, double_values};
use starts::state::Start;
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml::de::{DeTable, DeValue};
use tripos_traits::{Ball, Direction, DoubleDouble};

pub use families::neighbours::SceneNeighbours;
pub use families::scene_family::Family;
pub use families::start_ladder::Ladder;
pub use families::sweep_grid::{Grid, MOST_POINTS};
#[cfg(feature = "files")]
pub use motions::measurements::MeasuredTable;
#[cfg(feature = "files")]
pub use motions::motion_samples::load_samples;
pub use motions::prescribed_motion::{Formulas, Motion, MotionForm, MotionSample, load_motion};
pub use numbers::number_reader::NamedNumber;
pub use settings::claims::{DETERMINANT, SceneClaim, load_claim};
pub use settings::impacts::{ContactFriction, ImpactContact, ImpactLaw};
pub(crate) use settings::integration::SOLVES;
pub use settings::integration::{
    AccelerationSolution, Integration, Integrator, ProjectionTarget, SAMPLES, STEP_LIMITS,
};
pub use settings::outputs::{ENERGIES, default_outputs, load_output};
pub use starts::enclosed_scene::{EnclosedScene, enclosed_scene};
pub use starts::loops::{DependentLoop, Loops};
pub use starts::start::{EnclosedStart, ExactStart, InitialMotion, SolvedVariable};
pub use starts::state::{State, load_state};
pub use starts::state_with_unknowns::{StateWithUnknowns, load_state_with_unknowns};

/// Event of a scene: an instant of a run at which a function of the state crosses zero.
#[derive(Clone, Debug)]
pub struct SceneEvent {
    /// Name of the event, unique in the scene.
    pub name: String,
    /// Event function, which is zero at the event: a term in parameters, q, q̇, u and reactions.
    pub function: Expr,
    /// Direction of the zero crossings that count: rising, falling or either.
    pub direction: Direction,
    /// True if the run ends at the event; false if the event is only recorded.
    pub terminal: bool,
}

/// Kind of a figure on the page of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FigureKind {
    /// Figure of the total energy over time.
    Energy,
    /// Figure of every coordinate and speed over time, each in its own panel.
    States,
    /// Figure of computing speed against accuracy, for every formulation, every [`AccelerationSolution`] and every
    /// integration method.
    WorkPrecision,
    /// Heat map of the errors after passages near a singular surface of the equations.
    Passages,
    /// Figure of the errors of the accelerations along a passage near a singular surface, with
    /// condition numbers.
    Conditioning,
}

impl FigureKind {
    /// All kinds of figures, in the order in which they are listed to users.
    pub const ALL: [Self; 5] = [Self::Energy, Self::States, Self::WorkPrecision, Self::Passages, Self::Conditioning];

    /// Name of this kind of figure in scene files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Energy => "energy",
            Self::States => "states",
            Self::WorkPrecision => "work-precision",
            Self::Passages => "passages",
            Self::Conditioning => "conditioning",
        }
    }
}

/// Names of all kinds of figures in scene files.
pub(crate) const FIGURES: [&str; FigureKind::ALL.len()] = {
    let mut names = [""; FigureKind::ALL.len()];
    let mut at = 0;
    while at < names.len() {
        names[at] = FigureKind::ALL[at].name();
        at += 1;
    }
    names
};

/// Figure on the page of a scene: its kind and caption.
#[derive(Clone, Debug)]
pub struct Figure {
    /// Kind of the figure.
    pub kind: FigureKind,
    /// Caption of the figure; empty if the file states none.
    pub caption: String,
}

/// Output: a named quantity that a scene shows over time.
#[derive(Clone, Debug)]
pub struct SceneOutput {
    /// Name of the output: the name that the scene file gives, or the formula as written.
    pub name: String,
    /// Term of the output in parameters, q, q̇, u, u̇, reactions and energies.
    pub value: Expr,
}

/// Scene: the parameters, start, span, accuracy, events and outputs of a run of a model.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Scene file from which the scene was read.
    pub source: Source,
    /// Title of the scene; empty if the file states none.
    pub title: String,
    /// Description of the scene in words; empty if the file states none.
    pub about: String,
    /// Values of the parameters in SI units, in the order of the model.
    pub parameters: Vec<f64>,
    /// Values of the generalized coordinates at the start, in SI units and in the order of the model.
    pub q: Vec<f64>,
    /// Values of the generalized speeds at the start, in SI units and in the order of the model.
    pub u: Vec<f64>,
    /// Coordinates whose start values were computed so that the loops of the mechanism are closed.
    pub closed: Vec<SolvedVariable>,
    /// First and last instant of the run, s. The last may be earlier than the first.
    pub span: (f64, f64),
    /// Parameters and start values to 32 digits, for reference runs.
    pub exact: ExactStart,
    /// Settings of the integration: method, tolerances, steps, samples.
    pub integration: Integration,
    /// Further start values of one coordinate or speed, for stability tests; `None` if the file
    /// states none.
    pub ladder: Option<Ladder>,
    /// Outputs to show. If the file states none, they are all coordinates and speeds.
    pub outputs: Vec<SceneOutput>,
    /// True if the scene file states outputs. False if `outputs` contains the default: all
    /// coordinates and speeds.
    pub states_outputs: bool,
    /// Indices of the parameters that stay symbols in the scene's reduced equations, because runs
    /// vary these parameters.
    pub free: Vec<usize>,
    /// Claims about the motion, for rigorous runs.
    pub claims: Vec<SceneClaim>,
    /// Events to detect during the run.
    pub events: Vec<SceneEvent>,
    /// Contacts at which bodies can meet and part during the run.
    pub impacts: Vec<ImpactContact>,
    /// Figures to draw on the scene's page.
    pub figures: Vec<Figure>,
}

/// Keys of a scene file at its top level.
const KEYS: [&str; 17] = [
    "schema",
    "model",
    "title",
    "about",
    "parameters",
    "inputs",
    "free",
    "start",
    "guess",
    "ladder",
    "span",
    "integration",
    "outputs",
    "claims",
    "events",
    "impacts",
    "figures",
];

/// True if a text is a scene file: it has a top-level key that no other file format has.
#[must_use]
pub fn is_scene(source: &Source) -> bool {
    const OWN: [&str; 9] =
        ["start", "span", "integration", "outputs", "claims", "events", "impacts", "figures", "ladder"];
    TomlReader::parse(source).is_ok_and(|(_, table)| OWN.iter().any(|key| table.get_ref().contains_key(*key)))
}

/// Path of the model file to which a scene file belongs. It is the scene's key `model`, relative to
/// the scene's folder, or `../model.toml` if the key is absent.
///
/// # Errors
/// [`Diagnostics`] if the scene file is not TOML, or if its key `model` is not a string.
pub fn model_path_of_scene(source: &Source) -> Result<PathBuf, Diagnostics> {
    let (mut reader, table) = TomlReader::parse(source)?;
    let stated = reader.get(table.get_ref(), "model").and_then(|v| reader.string(v, "`model`"));
    reader.finish()?;
    let folder = source.path.parent().unwrap_or(Path::new("."));
    let stated = stated.map_or(PathBuf::from("../model.toml"), |s| PathBuf::from(s.text));
    Ok(if stated.is_absolute() { stated } else { folder.join(stated) })
}

/// Reads a scene file for its model. The terms of events and outputs are added to the model's
/// arena.
///
/// # Errors
/// [`Diagnostics`] with every error of the scene file.
pub fn load(source: &Source, model: &mut Model) -> Result<Scene, Diagnostics> {
    let (mut reader, table) = TomlReader::parse(source)?;
    let table = table.get_ref();
    reader.schema(table);
    reader.finish()?;
    let mut values = ValueReader::new(reader, model);
    values.reader.report_unknown_keys(table, "a scene file", &KEYS);
    let given = values.inputs(table);
    if given.bindings != values.model.bindings {
        let message = "this scene gives formulas to inputs, and has equations of its own, which are not shown beside those of others";
        values.reader.error(given.place.clone(), message, "run it by `tripos simulate`");
    }
    let numbers = values.scene_numbers(table);
    let ladder = values.ladder(table, &numbers.p, &numbers.start.exact);
    let (outputs, states_outputs) = values.outputs(table);
    let claims = values.scene_claims(table, &outputs);
    let free = values.free_parameters(table);
    let events = values.scene_events(table);
    let impacts = values.impacts(table, &numbers.coefficients);
    let figures = values.figures(table);
    let title = values.reader.get(table, "title").and_then(|v| values.reader.name(v, "`title`"));
    let title = title.map_or_else(String::new, |title| title.text);
    let about = values.scene_text(table, "about").unwrap_or_default();
    values.reader.finish()?;
    let Start { q, u, exact, closed, .. } = numbers.start;
    Ok(Scene {
        source: source.clone(),
        title,
        about,
        parameters: double_values(&numbers.p),
        q,
        u,
        closed,
        exact,
        span: numbers.span.expect("reported if missing"),
        integration: numbers.integration,
        ladder,
        outputs,
        states_outputs,
        free,
        claims,
        events,
        impacts,
        figures,
    })
}

/// Reads a scene for its model and replaces inputs of the model by the scene's formulas. Equations
/// derived from the model afterwards contain these formulas. The model must not have been used to
/// read another scene before.
///
/// # Errors
/// [`Diagnostics`] with every error of the scene file.
pub fn load_scene_with_inputs(source: &Source, model: &mut Model) -> Result<Scene, Diagnostics> {
    settings::inputs::bind_inputs(source, model)?;
    load(source, model)
}

impl Scene {
    /// Scenes with each start value of the ladder, as pairs of the text "name = value" and the
    /// scene. Without a ladder, the scene itself is the only entry, with the text "as it is".
    #[must_use]
    pub fn ladder_scenes(&self) -> Vec<(String, Self)> {
        let Some(ladder) = &self.ladder else { return vec![("as it is".to_owned(), self.clone())] };
        let n = self.q.len();
        let rung = |value: &DoubleDouble| {
            let mut scene = Self { ladder: None, ..self.clone() };
            if ladder.at < n {
                scene.q[ladder.at] = value.hi();
                scene.exact.q[ladder.at] = *value;
            } else {
                scene.u[ladder.at - n] = value.hi();
                if let InitialMotion::Speeds(u) = &mut scene.exact.motion {
                    u[ladder.at - n] = *value;
                }
            }
            (format!("{} = {}", ladder.name, value.hi()), scene)
        };
        ladder.values.iter().map(rung).collect()
    }

    /// Warnings about start angles that look like degrees instead of radians, one line each.
    #[must_use]
    pub fn degree_warnings(&self, model: &Model) -> Vec<String> {
        let starts = model.coordinates.iter().zip(&self.q).filter(|(c, q)| c.looks_like_degrees(**q));
        let hint = |(c, q): (&Coordinate, &f64)| {
            format!("`{}` starts at {q} rad: if degrees are meant, write \"{q}*deg\"", c.name)
        };
        starts.map(hint).collect()
    }
}

/// Numeric values of a scene file: parameters, and the values that may be formulas in parameters.
struct SceneNumbers {
    /// Values of the parameters, in the order of the model.
    p: Vec<Number>,
    /// Coordinates and speeds at the start.
    start: Start,
    /// First and last instant, s; `None` after an error.
    span: Option<(f64, f64)>,
    /// First and last instant, s, as balls that contain them; `None` after an error.
    enclosed_span: Option<(Ball, Ball)>,
    /// Settings of the integration.
    integration: Integration,
    /// Coefficients of restitution and friction, in the order of the scene's contacts.
    coefficients: Vec<settings::impacts::Coefficients>,
}

impl<'a> ValueReader<'a, '_> {
    /// Reads the parameters, start, time span, integration settings and contact coefficients of a
    /// scene file. Errors are recorded in the reader.
    fn scene_numbers(&mut self, table: &'a DeTable<'a>) -> SceneNumbers {
        let parameters = self.parameters(table);
        let span = self.scene_span(table, parameters.as_deref().unwrap_or_default());
        self.instant = span.as_ref().map(|(from, _)| from.clone());
        let start = match (self.section(table, "start"), &parameters) {
            (None, _) => {
                let is_told = self.model.coordinates.iter().all(|c| c.name == TIME);
                let help = if is_told {
                    "add [start] with nothing under it: all of this mechanism moves as it is told"
                } else {
                    "add [start] with every coordinate and every speed or every q'"
                };
                self.reader.errors.push(Diagnostic::of_file("the scene has no `start`", help));
                None
            }
            (Some(start), Some(parameters)) => self.state(table, start, parameters),
            (Some(_), None) => None,
        };
        let p = parameters.unwrap_or_default();
        let enclosed_span = span.as_ref().map(|(from, to)| (from.enclosure(), to.enclosure()));
        let span = span.map(|(from, to)| (from.double, to.double));
        let integration = self.integration(table, &p);
        let coefficients = self.impact_coefficients(table, &p);
        SceneNumbers { coefficients, p, start: start.unwrap_or_default(), span, enclosed_span, integration }
    }

    /// Reads `span`: first and last instant, s. If it is absent or wrong, an error is recorded and
    /// `None` is returned.
    fn scene_span(&mut self, table: &'a DeTable<'a>, p: &[Number]) -> Option<(Number, Number)> {
        let Some(value) = self.reader.get(table, "span") else {
            let help = "add span = [0, 1], in seconds";
            self.reader.errors.push(Diagnostic::of_file("the scene has no `span`", help));
            return None;
        };
        let DeValue::Array(array) = value.get_ref() else {
            self.reader.error(value.span(), "`span` must be two instants", "write span = [0, 1], in seconds");
            return None;
        };
        let ends: Vec<Option<Number>> = array
            .iter()
            .map(|v| {
                let formula = self.reader.formula(v, "an instant")?;
                self.number(&formula, p, "an instant")
            })
            .collect();
        let [from, to] = ends.as_slice() else {
            let message = format!("`span` has {} values, not 2", ends.len());
            self.reader.error(value.span(), message, "write span = [0, 1], in seconds");
            return None;
        };
        let (from, to) = (from.clone()?, to.clone()?);
        if from.double - to.double == 0.0 {
            self.reader.error(value.span(), "the span is empty", "let the last instant differ from the first");
            return None;
        }
        Some((from, to))
    }

    /// Reads an array of tables such as `[[events]]`. Returns pairs of the table and its TOML
    /// value, which contains its place in the file. Empty if the key is absent.
    fn scene_entries(&mut self, table: &'a DeTable<'a>, key: &str) -> Vec<(&'a DeTable<'a>, &'a Spanned<DeValue<'a>>)> {
        let Some(value) = self.reader.get(table, key) else { return Vec::new() };
        let DeValue::Array(array) = value.get_ref() else {
            let help = format!("write each as [[{key}]]");
            self.reader.error(value.span(), format!("`{key}` must be a list of tables"), help);
            return Vec::new();
        };
        array
            .iter()
            .filter_map(|v| Some((self.reader.table(v, &format!("an entry of `{key}`"), &format!("[[{key}]]"))?, v)))
            .collect()
    }

    /// Reads the events of a scene file. Wrong events are left out and recorded as errors.
    fn scene_events(&mut self, table: &'a DeTable<'a>) -> Vec<SceneEvent> {
        let mut events: Vec<SceneEvent> = Vec::new();
        for (entry, value) in self.scene_entries(table, "events") {
            self.reader.report_unknown_keys(entry, "an event", &["name", "zero", "direction", "terminal", "about"]);
            let name = self.reader.required(entry, "name", "an event", &value.span());
            let name = name.and_then(|v| self.reader.name(v, "an event's name"));
            let zero = self.reader.required(entry, "zero", "an event", &value.span());
            let zero = zero.and_then(|v| self.reader.formula(v, "an event function"));
            let function = zero.and_then(|f| self.value_formula(&f));
            let direction = self.choice(Some(entry), "direction", &["rising", "falling", "either"]);
            let terminal = self.reader.get(entry, "terminal").and_then(|v| self.reader.boolean(v, "`terminal`"));
            let direction = match direction {
                Some("rising") => Direction::Rising,
                Some("falling") => Direction::Falling,
                _ => Direction::Either,
            };
            let (Some(name), Some(function)) = (name, function) else { continue };
            if events.iter().any(|e| e.name == name.text) {
                self.reader.error(
                    name.span,
                    format!("the event `{}` is declared twice", name.text),
                    "rename one of them",
                );
                continue;
            }
            events.push(SceneEvent { name: name.text, function, direction, terminal: terminal.unwrap_or(false) });
        }
        events
    }

    /// Reads the figures of a scene file. Wrong figures are left out and recorded as errors.
    fn figures(&mut self, table: &'a DeTable<'a>) -> Vec<Figure> {
        let mut figures = Vec::new();
        for (entry, value) in self.scene_entries(table, "figures") {
            self.reader.report_unknown_keys(entry, "a figure", &["kind", "caption"]);
            if self.reader.required(entry, "kind", "a figure", &value.span()).is_none() {
                continue;
            }
            let name = self.choice(Some(entry), "kind", &FIGURES);
            let Some(kind) = FigureKind::ALL.into_iter().find(|kind| Some(kind.name()) == name) else { continue };
            figures.push(Figure { kind, caption: self.scene_text(entry, "caption").unwrap_or_default() });
        }
        figures
    }

    /// Text of an optional key, on one line. `None` if the key is absent or is not a string.
    fn scene_text(&mut self, table: &'a DeTable<'a>, key: &str) -> Option<String> {
        self.reader.prose(table, key)
    }
}
