//! Functional mock-up units (FMUs): a scene as C sources and a model description, by FMI 2.0 or 3.0.
//!
//! A scene gives Kane's equations, which are solved. From them the functions of the C target are planned, with
//! outputs and events. Then the sources and `modelDescription.xml` are written. The files `fmi2.c` and `fmi3.c`
//! implement the interfaces for every model, with `fmu_core.h`; `fmu_model.h` describes one model.

mod fmi2_description;
mod fmi3_description;
mod functions;
mod variables;
mod xml_elements;

use crate::languages::c::C;
use crate::languages::{CompositeFunction, Dialect, Module};
use crate::origin::{Origin, model_name_of_origin};
use crate::plan::{Function, Planner, Sharing};
use crate::syntax::{CodeWriter, Comments};
use functions::FmuFunctions;
use std::fmt::Write;
use tripos_derive::diagnostic::{Diagnostic, Diagnostics};
use tripos_derive::mechanics::DeriveError;
use tripos_derive::scene::Scene;
use tripos_derive::{Formulation, Model, derive};
use tripos_traits::Direction;
use variables::Variables;

/// Subcommand of `tripos` that writes the C sources, as the headers of the sources state it.
const COMMAND: &str = "fmu";

/// Text of the C header with the code that FMI 2.0 and FMI 3.0 share.
const CORE: &str = include_str!("fmu_core.h");

/// Version of the Functional Mock-up Interface (FMI).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Version {
    /// Version 2.0 of the Functional Mock-up Interface, of 2014.
    Two,
    /// Version 3.0 of the Functional Mock-up Interface, of 2022.
    Three,
}

impl Version {
    /// Returns the version number as model descriptions state it: `2.0` or `3.0`.
    #[must_use]
    pub const fn number(self) -> &'static str {
        match self {
            Self::Two => "2.0",
            Self::Three => "3.0",
        }
    }

    /// Returns the name and text of the C source that implements this version of FMI for every
    /// model.
    const fn fmi_c_source(self) -> (&'static str, &'static str) {
        match self {
            Self::Two => ("fmi2.c", include_str!("fmi2.c")),
            Self::Three => ("fmi3.c", include_str!("fmi3.c")),
        }
    }
}

/// Largest residual of a constraint that model exchange tolerates, in the constraint's own unit. If a residual is
/// larger, the state is projected onto the constraints.
const DRIFT: &str = "1e-9";

/// Functional mock-up unit as C sources and a model description, before it is compiled.
#[derive(Debug)]
pub struct Fmu {
    /// Name of the unit and of its binary: letters, digits and underscores.
    pub identifier: String,
    /// Text of the unit's file `modelDescription.xml`.
    pub description: String,
    /// Texts of the C sources and headers, by file name.
    pub sources: Vec<(String, String)>,
    /// Names of outputs, events and watched conditions that the unit lacks, because they need
    /// reactions.
    pub left_out: Vec<String>,
    /// True if importing tools can ask the unit for directional derivatives.
    pub has_slopes: bool,
}

impl Fmu {
    /// Writes the functional mock-up unit of a scene. The model must already contain the formulas that the scene
    /// gives to inputs.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] if the scene has impacts, if Kane's equations cannot be derived, or if they are not
    /// solved in closed form.
    pub fn new(model: &Model, scene: &Scene, version: Version) -> Result<Self, Diagnostics> {
        if !scene.impacts.is_empty() {
            let message = "a mock-up unit has no impacts".to_owned();
            let help = "leave `[impacts]` out of the scene, or run it by `tripos simulate`";
            return Err(Diagnostics::new(scene.source.clone(), vec![Diagnostic::of_file(message, help)]));
        }
        let derivation = derive(model, Formulation::Kane).map_err(|why| model.diagnose(&why))?;
        let mut arena = derivation.arena;
        let equations = derivation.equations.with_definitions(&mut arena);
        let functions = FmuFunctions::new(model, scene, &mut arena, &equations)
            .map_err(|why| model.diagnose(&DeriveError::Unsolved(why)))?;
        let planner = Planner::new(model, &arena, &equations, C.language(), Sharing::Shared);
        let plan = functions.plan(&planner);
        let identifier = fmu_identifier(scene, model);
        let composites: &[CompositeFunction] =
            if plan.has("constraints") { &[CompositeFunction::Project] } else { &[] };
        let origin = Origin::origin_of_model_file(&model.source.path, COMMAND).model_origin_sentence();
        let module = Module {
            model_word: &identifier,
            equations_word: Formulation::Kane.name(),
            planner: &planner,
            plan: &plan,
            composites,
            origin: &origin,
        };
        let mut sources = C.files(&module);
        sources.extend(C.shared_files(&origin));
        let variables = Variables::new(model, scene, &functions, &plan);
        sources.push(("fmu_model.h".to_owned(), fmu_model_header(&module, scene, &functions, &variables)));
        let (name, text) = version.fmi_c_source();
        sources.extend([("fmu_core.h", CORE), (name, text)].map(|(name, text)| (name.to_owned(), text.to_owned())));
        let description = match version {
            Version::Two => {
                fmi2_description::fmi2_description_text(&identifier, &module, scene, &functions, &variables)
            }
            Version::Three => {
                fmi3_description::fmi3_description_text(&identifier, &module, scene, &functions, &variables)
            }
        };
        let left_out = functions.outputs_needing_reactions().into_iter().chain(plan.unchecked.clone()).collect();
        let has_slopes = functions.has_directional_derivatives(&plan);
        Ok(Self { identifier, description, sources, left_out, has_slopes })
    }
}

/// Returns the name of the unit: a word for its model and a word for its scene, in lower case, joined by an
/// underscore.
fn fmu_identifier(scene: &Scene, model: &Model) -> String {
    let origin = Origin::origin_of_model_file(&model.source.path, COMMAND);
    let of_scene = scene.source.path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    crate::languages::module_identifier_word(&format!("{}_{of_scene}", model_name_of_origin(&origin)))
        .to_ascii_lowercase()
}

/// Returns the title of the model, followed by the title of the scene if it has one.
fn fmu_title(module: &Module<'_>, scene: &Scene) -> String {
    let title = &module.model().title;
    if scene.title.is_empty() { title.clone() } else { format!("{title}: {}", scene.title) }
}

/// Returns the token that ties a model description to its binary: a hash of the texts of the model
/// and the scene, in braces.
fn fmu_instantiation_token(module: &Module<'_>, scene: &Scene) -> String {
    let text = format!("{}\n{}", module.model().source.text, scene.source.text);
    format!("{{{}}}", tripos_derive::model::text_hash(&text))
}

/// Returns the text of `fmu_model.h`, the C header that describes one model: numbers of variables,
/// start values and events.
fn fmu_model_header(module: &Module<'_>, scene: &Scene, functions: &FmuFunctions, variables: &Variables) -> String {
    let (plan, e) = (module.plan, module.equations());
    let stem = format!("{}_{}", module.model_word, module.equations_word);
    let mut writer = CodeWriter::new(&C, Comments::Written);
    writer.comment("Description of a mechanism for fmu_core.h.");
    writer.comment("");
    writer.origin(module.origin);
    writer.write_empty_line();
    writer.write_unbroken("#ifndef FMU_MODEL_H\n#define FMU_MODEL_H");
    writer.write_empty_line();
    writer.write_unbroken(&format!("#include \"{stem}.h\"\n\n#define F(name) {stem}_##name"));
    writer.write_unbroken(&format!("#define TOKEN \"{}\"", fmu_instantiation_token(module, scene)));
    let (start, _) = scene.span;
    writer.write_unbroken(&format!("#define START_TIME {start:?}\n#define TOLERANCE {:?}", scene.integration.rtol));
    writer.write_unbroken(&format!("#define DRIFT {DRIFT}"));
    let count = |name: &str| plan.functions.iter().find(|f| f.name == name).map_or(0, |f: &Function| f.entries.len());
    let events = count("events");
    let counts = [
        ("NP", module.model().parameters.len()),
        ("NQ", e.coordinates.len()),
        ("NU", e.variables.len()),
        ("NOUT", count("outputs")),
        ("NDIV", count("divisors")),
        ("NCOND", count("conditions")),
        ("NEVENT", events),
        ("NCON", count("constraints")),
        ("HAS_OUTPUTS", usize::from(plan.has("outputs"))),
        ("HAS_DIVISORS", usize::from(plan.has("divisors"))),
        ("HAS_CONDITIONS", usize::from(plan.has("conditions"))),
        ("HAS_EVENTS", usize::from(events > 0)),
        ("HAS_SLOPES", usize::from(functions.has_directional_derivatives(plan))),
    ];
    for (name, value) in counts {
        writer.write_unbroken(&format!("#define {name} {value}"));
    }
    writer.write_empty_line();
    let list = |values: &[f64]| {
        let mut text = String::new();
        // The list gets at least one entry, since C has no empty arrays.
        for value in values.iter().chain(values.is_empty().then_some(&0.0)) {
            let _ = write!(text, "{}, ", if value.is_nan() { "NAN".to_owned() } else { format!("{value:?}") });
        }
        text.trim_end_matches(", ").to_owned()
    };
    writer.comment("Parameters and state at the start.");
    writer.line(&format!("static const double start_p[] = {{ {} }};", list(&scene.parameters)));
    writer.line(&format!("static const double start_x[] = {{ {} }};", list(&variables.start())));
    let way = |direction: Direction| match direction {
        Direction::Rising => 1.0,
        Direction::Falling => -1.0,
        Direction::Either => 0.0,
    };
    let ways: Vec<f64> = functions.events().iter().map(|event| way(event.direction)).collect();
    let ends: Vec<f64> = functions.events().iter().map(|event| f64::from(u8::from(event.terminal))).collect();
    writer.comment("Directions of the crossings that count as events, 0 for both, and which events end a simulation.");
    writer.line(&format!("static const double event_direction[] = {{ {} }};", list(&ways)));
    writer.line(&format!("static const double event_is_terminal[] = {{ {} }};", list(&ends)));
    writer.write_empty_line();
    writer.write_unbroken("#endif");
    writer.out
}
