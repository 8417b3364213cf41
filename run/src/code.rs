//! Code that runs the equations of a model: compiled into the program, or interpreted.

use crate::equations_name::EquationsName;
use crate::error::Error;
use crate::interpreted::{Interpreted, NotInterpreted};
use crate::mechanism::Mechanism;
use std::sync::{Arc, OnceLock};
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::value::evaluate::Tape;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diff::printed_equations;
use tripos_derive::mechanics::{Derivation, Distance, EquationsOrigin, derive_all, in_distance};
use tripos_derive::publication::{hash_beside, load_beside};
use tripos_derive::reduce::Reduction;
use tripos_derive::scene::{Scene, Solve};
use tripos_derive::{Equations, Formulation, derive};
use tripos_traits::{CompiledModel, CompiledSystem, DoubleDouble, System};

/// Form of the code that runs equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Generated Rust code.
    Compiled,
    /// Tape for interpretation.
    Interpreted,
}

impl Form {
    /// Name of the form in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Compiled => "compiled",
            Self::Interpreted => "interpreted",
        }
    }
}

/// Interpreted equations in each number type that runs use.
pub struct InterpretedSystem {
    /// Equations as tapes in doubles.
    pub double: Interpreted,
    /// Equations as tapes in twice the precision of a double, made on first use.
    extended: OnceLock<Interpreted<DoubleDouble>>,
}

impl From<Interpreted> for InterpretedSystem {
    fn from(double: Interpreted) -> Self {
        Self { double, extended: OnceLock::new() }
    }
}

impl InterpretedSystem {
    /// Interpreted equations in twice the precision of a double.
    #[must_use]
    pub fn extended(&self) -> &Interpreted<DoubleDouble> {
        self.extended.get_or_init(|| self.double.to())
    }
}

/// Equations of motion that are ready to run.
#[derive(Clone)]
pub enum Code {
    /// Generated Rust code that is compiled into the program.
    Compiled(&'static CompiledSystem),
    /// Tapes that were made at run time.
    Interpreted(Arc<InterpretedSystem>),
}

impl Code {
    /// The equations of motion in double precision.
    #[must_use]
    pub fn system(&self) -> &dyn System<f64> {
        match self {
            Self::Compiled(system) => system.double,
            Self::Interpreted(system) => &system.double,
        }
    }

    /// The equations of motion in twice the precision of a double.
    #[must_use]
    pub fn extended(&self) -> &dyn System<DoubleDouble> {
        match self {
            Self::Compiled(system) => system.extended,
            Self::Interpreted(system) => system.extended(),
        }
    }

    /// Makes code from interpreted equations.
    fn interpreted(system: Interpreted) -> Self {
        Self::Interpreted(Arc::new(system.into()))
    }

    /// True if the equations are compiled in.
    #[must_use]
    pub fn is_compiled(&self) -> bool {
        self.form() == Form::Compiled
    }

    /// Name of the form in tables: `compiled` or `interpreted`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.form().name()
    }

    /// Form of the code: compiled or interpreted.
    #[must_use]
    pub fn form(&self) -> Form {
        match self {
            Self::Compiled(_) => Form::Compiled,
            Self::Interpreted(_) => Form::Interpreted,
        }
    }
}

/// Finds the formulation with the given name, such as `kane`.
///
/// # Errors
/// [`Error::Request`] if there is no formulation of this name.
pub fn formulation(name: &str) -> Result<Formulation, Error> {
    Formulation::named(name).ok_or_else(|| {
        let names = Formulation::ALL.map(Formulation::name);
        Error::request(format!("there is no formulation `{name}`"), tripos_derive::diagnostic::nearest(name, names))
    })
}

/// Finds the equations with the given name, such as `kane` or `printed:ID`.
///
/// # Errors
/// [`Error::Request`] if there are no such equations; [`Error::Input`] if the publication has errors.
pub fn by(model: &Mechanism, name: &EquationsName) -> Result<EquationsOrigin, Error> {
    let id = match name {
        EquationsName::Derived(formulation) => return Ok(EquationsOrigin::from(*formulation)),
        EquationsName::Printed(id) => id,
        // The reduced equations belong to a scene, and a model does not have them.
        EquationsName::Reduced | EquationsName::Unknown(_) => {
            return formulation(&name.to_string()).map(EquationsOrigin::from);
        }
    };
    let list = printed(model)?;
    list.iter().find(|by| by.printed_id() == Some(id)).cloned().ok_or_else(|| {
        let names: Vec<String> = list.iter().map(EquationsOrigin::name).collect();
        let help = if list.is_empty() {
            "the model has no publication.toml beside it".to_owned()
        } else {
            tripos_derive::diagnostic::nearest(&name.to_string(), names.iter().map(String::as_str))
        };
        Error::request(format!("there are no printed equations `{name}`"), help)
    })
}

/// Finds the equations with the given name, or those of the first formulation that the model supports if no name is
/// given.
///
/// # Errors
/// Errors of [`by`].
pub fn by_or_first(model: &Mechanism, name: Option<&EquationsName>) -> Result<EquationsOrigin, Error> {
    let first = || Formulation::STANDARD.into_iter().find(|f| derive(model, *f).is_ok()).unwrap_or(Formulation::Kane);
    name.map_or_else(|| Ok(EquationsOrigin::from(first())), |name| by(model, name))
}

/// Names of the printed equations in the publication file beside a model, in the order of that file.
///
/// # Errors
/// [`Error::Input`] if the publication file or the model has errors.
pub fn printed(model: &Mechanism) -> Result<Vec<EquationsOrigin>, Error> {
    let list = printed_derivation(model)?.map(|(_, equations)| equations).unwrap_or_default();
    Ok(list.into_iter().map(|equations| equations.by).collect())
}

/// Printed equations of the publication beside a model, with the arena that holds their terms. `None` without
/// publication.
fn printed_derivation(model: &Mechanism) -> Result<Option<(Arena, Vec<Equations>)>, Error> {
    let mut with_publication = model.clone();
    let Some(publication) = load_beside(&model.source.path, &mut with_publication)? else { return Ok(None) };
    let mut derivations = derive_all(&with_publication).map_err(|error| model.diagnose(&error))?;
    let list = printed_equations(&with_publication, &mut derivations, &publication);
    Ok(Some((derivations.kinematics.arena, list)))
}

/// Extent to which equations are made ready to run. Compiled equations have everything except recurrences, which few
/// have. If recurrences are needed, compiled equations without them are not used: the equations are interpreted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ready {
    /// The equations as they were derived: a matrix, a right-hand side, energies.
    AsDerived,
    /// The derived equations, and the accelerations solved for, with their Jacobian. This takes much longer.
    Solved,
    /// The solved equations, and the recurrences of Taylor coefficients.
    WithSeries,
}

impl Ready {
    /// Extent of preparation that runs of a scene need. Taylor's method needs recurrences. A numeric solve needs
    /// elimination only for the Jacobian.
    #[must_use]
    pub fn for_runs(scene: &Scene) -> Self {
        let how = &scene.integration;
        let Some(method) = how.method.method() else { return Self::Solved };
        let is_numeric = how.solve == Some(Solve::Numeric);
        match () {
            () if is_numeric && !method.needs_jacobian() => Self::AsDerived,
            () if method.needs_series() => Self::WithSeries,
            () => Self::Solved,
        }
    }

    /// True if compiled equations are ready to this extent.
    fn is_had(self, system: &CompiledSystem) -> bool {
        self != Self::WithSeries || system.double.has_taylor()
    }
}

/// Makes the equations of a model ready to run. They are compiled code if this was generated from exactly the model's
/// text and is ready to the given extent; otherwise they are interpreted.
///
/// The equations are written in the distance from a singular surface, if one is given.
///
/// # Errors
/// [`Error::Unsupported`] if the model does not have this formulation; [`Error::Input`] if it cannot be derived;
/// [`Error::Request`] if the equations cannot be run.
pub fn code(model: &Mechanism, by: &EquationsOrigin, distance: Option<Distance>, ready: Ready) -> Result<Code, Error> {
    if let Some(code) = compiled_code(model, by, distance, ready) {
        return Ok(code);
    }
    let derivation = derivation(model, by)?;
    let derivation = match distance {
        Some(distance) => in_distance(model, derivation, distance),
        None => derivation,
    };
    code_of(model, by, &derivation, ready)
}

/// Finds the compiled equations of a model; `None` unless they are current and ready to the given extent.
pub fn compiled_code(
    model: &Mechanism,
    by: &EquationsOrigin,
    distance: Option<Distance>,
    ready: Ready,
) -> Option<Code> {
    let compiled = compiled(model)?;
    let name = by.name_in(distance, model);
    let found = compiled.systems.iter().find(|system| system.name == name);
    // Printed equations must also come from exactly this text of the publication file.
    let current = by.printed_id().is_none() || hash_beside(&model.source.path) == compiled.publication_hash;
    found.filter(|system| current && ready.is_had(system)).map(Code::Compiled)
}

/// Finds the compiled equations of a scene; `None` unless they belong to this reduction and are ready to the given
/// extent.
#[must_use]
pub fn compiled_scene(mechanism: &Mechanism, reduction: &Reduction, ready: Ready) -> Option<Code> {
    let key = reduction.key();
    let found = mechanism.compiled.iter().flat_map(|model| model.scenes).find(|scene| scene.key == key);
    found.filter(|scene| ready.is_had(&scene.system)).map(|scene| Code::Compiled(&scene.system))
}

/// Prepares equations for interpretation. Printed equations are run as they stand, without solving for accelerations.
///
/// # Errors
/// [`Error::Request`] if the equations depend on a symbol that has no value during a run. Only printed ones can do so.
pub fn code_of(model: &Mechanism, by: &EquationsOrigin, derivation: &Derivation, ready: Ready) -> Result<Code, Error> {
    let code = Interpreted::new(model, derivation).map_err(NotInterpreted::from);
    let code = match ready {
        Ready::Solved | Ready::WithSeries if by.formulation().is_some() => {
            code.and_then(|code| code.solved(derivation))
        }
        _ => code,
    };
    Ok(Code::interpreted(code.map_err(|why| not_interpreted(&by.name(), &why))?))
}

/// Prepares the equations of a scene for interpretation.
///
/// # Errors
/// [`Error::Request`] if the equations depend on a symbol that has no value during a run. Equations of a reduction
/// never do.
pub fn interpreted_scene(reduction: &Reduction) -> Result<Code, Error> {
    let derivation = &reduction.derivation;
    let code = Interpreted::new(&reduction.model, derivation).map_err(NotInterpreted::from);
    let code = code.and_then(|code| Ok(code.solved(derivation)?.showing(reduction)?));
    Ok(Code::interpreted(code.map_err(|why| not_interpreted(&EquationsOrigin::Reduced.name(), &why))?))
}

/// Error for the named equations, which cannot be interpreted.
fn not_interpreted(name: &str, why: &NotInterpreted) -> Error {
    match why {
        NotInterpreted::Unknown(unknown) => Error::request(
            format!("`{name}` mentions `{}`, which has no value during a run", unknown.0),
            "equations of a run contain only parameters, coordinates and motion variables".to_owned(),
        ),
        NotInterpreted::Unsolved(why) => Error::request(format!("`{name}`: {why}"), why.help().to_owned()),
    }
}

/// Compiles a tape that computes `values` from inputs; `what` names them in an error.
///
/// # Errors
/// [`Error::Request`] if a value mentions a symbol other than the inputs.
pub fn tape(arena: &Arena, inputs: &[Expr], values: &[Expr], what: &str) -> Result<Tape, Error> {
    stepwise(arena, inputs, &[], values, what)
}

/// Compiles a tape that computes `values` from inputs and from the symbols that the steps define; `what` names the
/// values in an error.
///
/// # Errors
/// Errors of [`tape`].
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

/// Derives the equations of a model as terms, or reads its printed ones.
///
/// # Errors
/// [`Error::Unsupported`] if the model does not have this formulation; [`Error::Input`] if it cannot be derived.
pub fn derivation(model: &Mechanism, by: &EquationsOrigin) -> Result<Derivation, Error> {
    if let Some(formulation) = by.formulation() {
        return model.derive(formulation);
    }
    let (arena, list) = printed_derivation(model)?.unwrap_or_default();
    let equations = list.into_iter().find(|e| e.by == *by);
    let missing = || {
        let help = "the publication file changed while it was read: try again".to_owned();
        Error::request(format!("there are no equations `{}`", by.name()), help)
    };
    Ok(Derivation { arena, equations: equations.ok_or_else(missing)? })
}

/// Finds the compiled equations of a model with exactly this text; `None` if the program has none.
#[must_use]
pub fn compiled(model: &Mechanism) -> Option<&'static CompiledModel> {
    let hash = model.text_hash();
    model.compiled.iter().find(|m| m.text_hash == hash)
}
