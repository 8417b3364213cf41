//! Which code runs a model: compiled in, or interpreted.

use crate::error::Error;
use crate::interpreted::{Interpreted, InterpretedSystem, NotInterpreted};
use crate::mechanism::Mechanism;
use crate::run::method;
use std::sync::Arc;
use tripos_derive::algebra::evaluate::Tape;
use tripos_derive::algebra::steps::Definition;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diff::printed_equations;
use tripos_derive::mechanics::{Derivation, Distance, derive_all, in_distance};
use tripos_derive::reduce::Reduction;
use tripos_derive::report::load_beside;
use tripos_derive::scene::{QUADRATURE, Scene, Solve};
use tripos_derive::{Equations, Formulation, derive};
use tripos_traits::{CompiledModel, CompiledSystem, DoubleDouble, System};

/// Equations ready to run.
#[derive(Clone)]
pub enum Code {
    /// Generated Rust, compiled in.
    Compiled(&'static CompiledSystem),
    /// A tape made just now.
    Interpreted(Arc<InterpretedSystem>),
}

impl Code {
    /// The equations.
    #[must_use]
    pub fn system(&self) -> &dyn System<f64> {
        match self {
            Self::Compiled(system) => system.double,
            Self::Interpreted(system) => &system.double,
        }
    }

    /// The equations in twice the precision of a double.
    #[must_use]
    pub fn extended(&self) -> &dyn System<DoubleDouble> {
        match self {
            Self::Compiled(system) => system.extended,
            Self::Interpreted(system) => system.extended(),
        }
    }

    fn interpreted(system: Interpreted) -> Self {
        Self::Interpreted(Arc::new(system.into()))
    }

    /// Whether they are compiled in.
    #[must_use]
    pub fn is_compiled(&self) -> bool {
        matches!(self, Self::Compiled(_))
    }

    /// How tables name it.
    #[must_use]
    pub fn name(&self) -> &'static str {
        if self.is_compiled() { "compiled" } else { "interpreted" }
    }
}

/// The formulation of this name.
///
/// # Errors
/// [`Error::Request`] if there is none.
pub fn formulation(name: &str) -> Result<Formulation, Error> {
    Formulation::ALL.into_iter().find(|f| f.name() == name).ok_or_else(|| {
        let names = Formulation::ALL.map(Formulation::name);
        Error::request(format!("there is no formulation `{name}`"), tripos_derive::diagnostic::nearest(name, names))
    })
}

/// Which equations run: derived ones, or printed ones of the report beside the model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct By {
    /// `kane`, `lagrange`, `newton-euler` or `printed:ID`.
    pub name: String,
    /// The name in a heading.
    pub title: String,
    /// The formulation; none for printed equations.
    derived: Option<Formulation>,
}

impl From<Formulation> for By {
    fn from(f: Formulation) -> Self {
        Self { name: f.name().to_owned(), title: f.title().to_owned(), derived: Some(f) }
    }
}

impl By {
    /// Printed equations.
    #[must_use]
    pub fn printed(equations: &Equations) -> Self {
        Self { name: equations.name.clone(), title: equations.title.clone(), derived: None }
    }

    /// A scene's own equations.
    #[must_use]
    pub fn reduced() -> Self {
        Self { name: "reduced".to_owned(), title: "Reduced equations".to_owned(), derived: None }
    }

    /// Whether these are a scene's own equations.
    #[must_use]
    pub fn is_reduced(&self) -> bool {
        self.name == "reduced"
    }

    /// The formulation; none for printed and for reduced equations.
    #[must_use]
    pub fn formulation(&self) -> Option<Formulation> {
        self.derived
    }
}

/// What `--by` means for this model.
///
/// # Errors
/// [`Error::Request`] if there are no such equations; [`Error::Input`] if the report has errors.
pub fn by(model: &Mechanism, name: &str) -> Result<By, Error> {
    if !name.starts_with("printed:") {
        return formulation(name).map(By::from);
    }
    let list = printed(model)?;
    list.iter().find(|by| by.name == name).cloned().ok_or_else(|| {
        let names = list.iter().map(|by| by.name.as_str());
        let help = if list.is_empty() {
            "the model has no report.toml beside it".to_owned()
        } else {
            tripos_derive::diagnostic::nearest(name, names)
        };
        Error::request(format!("there are no printed equations `{name}`"), help)
    })
}

/// What `--by` means, or the first formulation that the model supports if it is not given.
///
/// # Errors
/// As [`by`].
pub fn by_or_first(model: &Mechanism, name: Option<&str>) -> Result<By, Error> {
    let first = || Formulation::ALL.into_iter().find(|f| derive(model, *f).is_ok()).unwrap_or(Formulation::Kane);
    name.map_or_else(|| Ok(By::from(first())), |name| by(model, name))
}

/// The printed equations of the report beside a model, in the order of the report.
///
/// # Errors
/// [`Error::Input`] if the report or the model has errors.
pub fn printed(model: &Mechanism) -> Result<Vec<By>, Error> {
    let list = printed_derivation(model)?.map(|(_, equations)| equations).unwrap_or_default();
    Ok(list.iter().map(By::printed).collect())
}

/// Printed equations, with the model that holds their terms.
fn printed_derivation(model: &Mechanism) -> Result<Option<(Arena, Vec<Equations>)>, Error> {
    let mut with_report = model.clone();
    let Some(report) = load_beside(&model.source.path, &mut with_report)? else { return Ok(None) };
    let mut derivations = derive_all(&with_report).map_err(|error| model.diagnose(&error))?;
    let list = printed_equations(&with_report, &mut derivations, &report);
    Ok(Some((derivations.kinematics.arena, list)))
}

/// How much of interpreted equations is made ready: compiled ones have everything.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Ready {
    /// The equations as they were derived: a matrix, a right-hand side, energies.
    AsDerived,
    /// Also the accelerations solved for, with their Jacobian and their recurrences, which takes much longer.
    Solved,
}

impl Ready {
    /// What runs of a scene need: a numeric solve asks for nothing that elimination gives but the Jacobian.
    ///
    /// # Errors
    /// [`Error::Request`] if there is no such method.
    pub fn for_runs(scene: &Scene) -> Result<Self, Error> {
        let how = &scene.integration;
        let numeric = how.solve == Some(Solve::Numeric) && how.method != QUADRATURE;
        Ok(if numeric && !method(&how.method)?.needs_jacobian() { Self::AsDerived } else { Self::Solved })
    }
}

/// The equations of a model: compiled in if they were derived from this very text.
///
/// In a distance, if one is given.
///
/// # Errors
/// [`Error::Unsupported`] if the model does not have this formulation; [`Error::Input`] if it cannot be derived; [`Error::Request`] if
/// the equations cannot be run.
pub fn code(model: &Mechanism, by: &By, distance: Option<Distance>, ready: Ready) -> Result<Code, Error> {
    if let Some(code) = compiled_code(model, by, distance) {
        return Ok(code);
    }
    let derivation = derivation(model, by)?;
    let derivation = match distance {
        Some(distance) => in_distance(model, derivation, distance),
        None => derivation,
    };
    code_of(model, by, &derivation, ready)
}

/// The equations of a model that were compiled in, if there are such and they are current.
pub fn compiled_code(model: &Mechanism, by: &By, distance: Option<Distance>) -> Option<Code> {
    let compiled = compiled(model)?;
    let name = match distance {
        Some(distance) => format!("{}@{}", by.name, distance.name(model)),
        None => by.name.clone(),
    };
    let found = compiled.systems.iter().find(|system| system.name == name);
    let current = by.derived.is_some() || report_hash(model) == compiled.report_hash;
    found.filter(|_| current).map(Code::Compiled)
}

/// The equations of a scene that were compiled in, if they are of what it says.
#[must_use]
pub fn compiled_scene(mechanism: &Mechanism, reduction: &Reduction) -> Option<Code> {
    let key = reduction.key();
    let found = mechanism.compiled.iter().flat_map(|model| model.scenes).find(|scene| scene.key == key);
    found.map(|scene| Code::Compiled(&scene.system))
}

/// Equations made ready to be run by interpretation. Printed ones are run as they stand.
///
/// # Errors
/// [`Error::Request`] if they depend on what has no value during a run, as only printed ones can.
pub fn code_of(model: &Mechanism, by: &By, derivation: &Derivation, ready: Ready) -> Result<Code, Error> {
    let code = Interpreted::new(model, derivation).map_err(NotInterpreted::from);
    let code = match ready {
        Ready::Solved if by.derived.is_some() => code.and_then(|code| code.solved(derivation)),
        _ => code,
    };
    Ok(Code::interpreted(code.map_err(|why| not_interpreted(&by.name, &why))?))
}

/// The equations of a scene made ready to be run by interpretation.
///
/// # Errors
/// [`Error::Request`] if they depend on what has no value during a run, which what a reduction gives never does.
pub fn interpreted_scene(reduction: &Reduction) -> Result<Code, Error> {
    let derivation = &reduction.derivation;
    let code = Interpreted::new(&reduction.model, derivation).map_err(NotInterpreted::from);
    let code = code.and_then(|code| Ok(code.solved(derivation)?.showing(reduction)?));
    Ok(Code::interpreted(code.map_err(|why| not_interpreted(&derivation.equations.name, &why))?))
}

fn not_interpreted(name: &str, why: &NotInterpreted) -> Error {
    match why {
        NotInterpreted::Unknown(unknown) => Error::request(
            format!("`{name}` mentions `{}`, which has no value during a run", unknown.0),
            "equations that run hold parameters, coordinates and motion variables only".to_owned(),
        ),
        NotInterpreted::Singular => Error::request(
            format!("`{name}` determines its accelerations in no configuration"),
            "its mass matrix is singular everywhere: give every coordinate something that resists it".to_owned(),
        ),
    }
}

/// What computes these values of inputs.
///
/// # Errors
/// [`Error::Request`] if one of them mentions what is no input.
pub fn tape(arena: &Arena, inputs: &[Expr], values: &[Expr], what: &str) -> Result<Tape, Error> {
    stepwise(arena, inputs, &[], values, what)
}

/// What computes these values of inputs and of what the steps define.
///
/// # Errors
/// As [`tape`].
pub fn stepwise(
    arena: &Arena,
    inputs: &[Expr],
    steps: &[Definition],
    values: &[Expr],
    what: &str,
) -> Result<Tape, Error> {
    Tape::stepwise(arena, inputs, steps, values).map_err(|unknown| {
        let what = format!("{what} mentions `{}`, which has no value during a run", unknown.0);
        Error::request(what, "use parameters, coordinates, q', speeds and reactions".to_owned())
    })
}

/// The equations of a model as terms.
///
/// # Errors
/// [`Error::Unsupported`] if the model does not have this formulation; [`Error::Input`] if it cannot be derived.
pub fn derivation(model: &Mechanism, by: &By) -> Result<Derivation, Error> {
    if let Some(formulation) = by.derived {
        return derive(model, formulation).map_err(|error| {
            let kind = if error.is_unsupported() { Error::Unsupported } else { Error::Input };
            kind(model.diagnose(&error))
        });
    }
    let (arena, list) = printed_derivation(model)?.unwrap_or_default();
    let equations = list.into_iter().find(|e| e.name == by.name);
    let missing = || {
        let help = "the report has changed while it was read: try again".to_owned();
        Error::request(format!("there are no equations `{}`", by.name), help)
    };
    Ok(Derivation { arena, equations: equations.ok_or_else(missing)? })
}

/// The hash of the text of the report beside a model; empty if there is none.
fn report_hash(model: &Mechanism) -> String {
    let text = std::fs::read_to_string(model.source.path.with_file_name("report.toml"));
    text.map(|text| tripos_derive::model::text_hash(&text)).unwrap_or_default()
}

/// The compiled equations of a model's very text, if a program brought them along.
#[must_use]
pub fn compiled(model: &Mechanism) -> Option<&'static CompiledModel> {
    let hash = model.text_hash();
    model.compiled.iter().find(|m| m.text_hash == hash)
}
