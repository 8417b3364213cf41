//! Code that runs the equations of motion of a model. It is compiled into the program, or consists of tapes
//! that are interpreted.

pub use crate::interpreted_equations::InterpretedSystem;

use crate::equations_name::read_printed_equations;
use crate::error::Error;
use crate::interpreted_equations::{InterpretationError, InterpretedEquations};
use crate::mechanism::Mechanism;
use std::sync::Arc;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{Derivation, EquationsOrigin, SingularDistance, equations_in_distance};
use tripos_derive::publication::hash_publication_of_model;
use tripos_derive::reduce::Reduction;
use tripos_derive::scene::{AccelerationSolution, Scene};
use tripos_traits::{CompiledModel, CompiledSystem, DoubleDouble, System};

/// Form in which equations of motion are run: compiled Rust code, or interpreted tapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CodeForm {
    /// Rust code that was generated from the equations and compiled into the program.
    Compiled,
    /// Tapes (lists of arithmetic instructions) that are interpreted at run time.
    Interpreted,
}

impl CodeForm {
    /// Name of the form, for tables and messages: `compiled` or `interpreted`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Compiled => "compiled",
            Self::Interpreted => "interpreted",
        }
    }
}

/// Equations of motion in a form that can be run, compiled or interpreted. A clone is cheap.
#[derive(Clone)]
pub enum Code {
    /// Generated Rust code that is compiled into the program.
    Compiled(&'static CompiledSystem),
    /// Tapes that were made at run time, shared between clones.
    Interpreted(Arc<InterpretedSystem>),
}

impl Code {
    /// Equations of motion in double precision.
    #[must_use]
    pub fn system(&self) -> &dyn System<f64> {
        match self {
            Self::Compiled(system) => system.double,
            Self::Interpreted(system) => &system.double,
        }
    }

    /// Equations of motion in twice the precision of a double, about 32 digits.
    #[must_use]
    pub fn extended(&self) -> &dyn System<DoubleDouble> {
        match self {
            Self::Compiled(system) => system.extended,
            Self::Interpreted(system) => system.extended(),
        }
    }

    /// Makes runnable code from equations that were compiled to tapes in double precision.
    fn interpreted(system: InterpretedEquations) -> Self {
        Self::Interpreted(Arc::new(system.into()))
    }

    /// True if the equations are Rust code that is compiled into the program. False if they are interpreted.
    #[must_use]
    pub fn is_compiled(&self) -> bool {
        self.form() == CodeForm::Compiled
    }

    /// Name of the form of this code, for tables and messages: `compiled` or `interpreted`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.form().name()
    }

    /// Form of the code: compiled or interpreted.
    #[must_use]
    pub fn form(&self) -> CodeForm {
        match self {
            Self::Compiled(_) => CodeForm::Compiled,
            Self::Interpreted(_) => CodeForm::Interpreted,
        }
    }
}

/// Extent to which equations of motion are prepared for runs: as derived, with accelerations, or with Taylor
/// series.
///
/// Compiled equations always contain accelerations. Few of them contain recurrences of Taylor coefficients.
/// If a run needs recurrences that the compiled equations lack, the equations are interpreted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CodePreparation {
    /// Equations as they were derived: mass matrix, forcing and energies. A run then solves for the
    /// accelerations numerically.
    AsDerived,
    /// Derived equations with the eliminated accelerations v̇ and their Jacobian. This preparation takes much
    /// longer.
    Solved,
    /// Equations with eliminated accelerations, and with recurrences of the Taylor coefficients of the motion.
    WithSeries,
}

impl CodePreparation {
    /// Extent of preparation that the runs of a scene need. Taylor's method needs recurrences. If the scene asks
    /// for numerical accelerations, they are eliminated only if the method needs a Jacobian.
    #[must_use]
    pub fn preparation_for_runs(scene: &Scene) -> Self {
        let how = &scene.integration;
        let Some(method) = how.method.method() else { return Self::Solved };
        let is_numeric = how.solve == Some(AccelerationSolution::Numeric);
        match () {
            () if is_numeric && !method.needs_jacobian() => Self::AsDerived,
            () if method.needs_series() => Self::WithSeries,
            () => Self::Solved,
        }
    }

    /// True if the given compiled equations are prepared to at least this extent.
    fn is_met_by(self, system: &CompiledSystem) -> bool {
        self != Self::WithSeries || system.double.has_taylor()
    }
}

/// Makes the equations of a model ready to run, to at least the given extent. Compiled code is used if it was
/// generated from exactly the text of the model and has this extent. Otherwise the equations are interpreted.
///
/// `by` selects the formulation or the printed equations. If `distance` is given, the distance of an angle from
/// a multiple of 90° replaces this angle as a coordinate.
///
/// # Errors
/// [`Error::Unsupported`] if the model does not have this formulation. [`Error::Input`] if it cannot be derived.
/// [`Error::Request`] if the equations cannot be run.
pub fn runnable_code(
    model: &Mechanism,
    by: &EquationsOrigin,
    distance: Option<SingularDistance>,
    ready: CodePreparation,
) -> Result<Code, Error> {
    if let Some(code) = compiled_code(model, by, distance, ready) {
        return Ok(code);
    }
    let derivation = derive_or_read_equations(model, by)?;
    let derivation = match distance {
        Some(distance) => equations_in_distance(model, derivation, distance),
        None => derivation,
    };
    interpreted_code(model, by, &derivation, ready)
}

/// Finds the compiled equations of a model by their origin. `None` if the program has no such equations that
/// were generated from the present text of the model, with this distance, and to at least the given extent.
pub fn compiled_code(
    model: &Mechanism,
    by: &EquationsOrigin,
    distance: Option<SingularDistance>,
    ready: CodePreparation,
) -> Option<Code> {
    let compiled = compiled_model(model)?;
    let name = by.name_in(distance, model);
    let found = compiled.systems.iter().find(|system| system.name == name);
    // Printed equations must also have been generated from exactly this text of the publication file.
    let current =
        by.printed_id().is_none() || hash_publication_of_model(&model.source.path) == compiled.publication_hash;
    found.filter(|system| current && ready.is_met_by(system)).map(Code::Compiled)
}

/// Finds the compiled reduced equations of a scene by the key of its reduction. `None` if the program has no
/// equations with this key that are prepared to at least the given extent.
#[must_use]
pub fn compiled_scene_code(mechanism: &Mechanism, reduction: &Reduction, ready: CodePreparation) -> Option<Code> {
    let key = reduction.reduction_hash();
    let found = mechanism.compiled.iter().flat_map(|model| model.scenes).find(|scene| scene.key == key);
    found.filter(|scene| ready.is_met_by(&scene.system)).map(|scene| Code::Compiled(&scene.system))
}

/// Compiles derived or printed equations to tapes for interpretation. The accelerations v̇ are eliminated if
/// `ready` asks for it. Printed equations are run as they stand.
///
/// # Errors
/// [`Error::Request`] if the equations contain a symbol that has no value during a run, or if they cannot be
/// solved for v̇. Only printed equations can contain such a symbol.
pub fn interpreted_code(
    model: &Mechanism,
    by: &EquationsOrigin,
    derivation: &Derivation,
    ready: CodePreparation,
) -> Result<Code, Error> {
    let code = InterpretedEquations::new(model, derivation).map_err(InterpretationError::from);
    let code = match ready {
        CodePreparation::Solved | CodePreparation::WithSeries if by.formulation().is_some() => {
            code.and_then(|code| code.with_solved_accelerations(derivation))
        }
        _ => code,
    };
    Ok(Code::interpreted(code.map_err(|why| interpretation_error(&by.name(), &why))?))
}

/// Compiles the equations of a model by a formulation to tapes, with eliminated accelerations.
///
/// # Errors
/// As for [`runnable_code`].
pub(crate) fn solved_tapes(model: &Mechanism, by: &EquationsOrigin) -> Result<InterpretedEquations, Error> {
    let derivation = derive_or_read_equations(model, by)?;
    let code = InterpretedEquations::new(model, &derivation).map_err(InterpretationError::from);
    code.and_then(|code| code.with_solved_accelerations(&derivation))
        .map_err(|why| interpretation_error(&by.name(), &why))
}

/// Compiles the reduced equations of a scene to tapes for interpretation, with the scene's outputs.
///
/// # Errors
/// [`Error::Request`] if the equations contain a symbol that has no value during a run, or if they cannot be
/// solved for v̇. The equations of a reduction never contain such a symbol.
pub fn interpreted_scene_code(reduction: &Reduction) -> Result<Code, Error> {
    Ok(Code::interpreted(solved_scene_tapes(reduction)?))
}

/// Compiles the reduced equations of a scene to tapes, with eliminated accelerations and the scene's outputs.
///
/// # Errors
/// As for [`interpreted_scene_code`].
pub(crate) fn solved_scene_tapes(reduction: &Reduction) -> Result<InterpretedEquations, Error> {
    let derivation = &reduction.derivation;
    let code = InterpretedEquations::new(&reduction.model, derivation).map_err(InterpretationError::from);
    let code = code.and_then(|code| Ok(code.with_solved_accelerations(derivation)?.with_scene_outputs(reduction)?));
    code.map_err(|why| interpretation_error(&EquationsOrigin::Reduced.name(), &why))
}

/// Compiles the reduced equations of a scene to tapes for interpretation, with the scene's outputs but without
/// eliminated accelerations. A run then solves for the accelerations numerically.
///
/// # Errors
/// [`Error::Request`] if the equations contain a symbol that has no value during a run.
pub fn interpreted_scene_code_as_derived(reduction: &Reduction) -> Result<Code, Error> {
    let code = InterpretedEquations::new(&reduction.model, &reduction.derivation);
    let code = code.and_then(|code| code.with_scene_outputs(reduction)).map_err(InterpretationError::from);
    Ok(Code::interpreted(code.map_err(|why| interpretation_error(&EquationsOrigin::Reduced.name(), &why))?))
}

/// Makes the error that says why equations cannot be interpreted. `name` is their name, for people.
fn interpretation_error(name: &str, why: &InterpretationError) -> Error {
    match why {
        InterpretationError::Unknown(unknown) => Error::request(
            format!("`{name}` mentions `{}`, which has no value during a run", unknown.0),
            "equations of a run contain only parameters, coordinates and motion variables".to_owned(),
        ),
        InterpretationError::Unsolved(why) => Error::request(format!("`{name}`: {why}"), why.help().to_owned()),
    }
}

/// Compiles a tape (a list of arithmetic instructions) that computes `values` from numbers for the
/// symbols `inputs`. `what` names the values in an error.
///
/// # Errors
/// [`Error::Request`] if a value contains a symbol other than the inputs.
pub fn compile_tape(arena: &Arena, inputs: &[Expr], values: &[Expr], what: &str) -> Result<Tape, Error> {
    compile_tape_with_steps(arena, inputs, &[], values, what)
}

/// Compiles a tape that computes `values` from numbers for the symbols `inputs`. The values may also contain
/// symbols that `steps` define, in the order of the steps. `what` names the values in an error.
///
/// # Errors
/// `Error::Request` if a value or a step contains a symbol that is neither an input nor defined by an earlier
/// step.
pub fn compile_tape_with_steps(
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

/// Derives the equations of motion of a model by a formulation, or reads its printed equations. The result
/// contains their expressions.
///
/// # Errors
/// [`Error::Unsupported`] if the model does not have this formulation. [`Error::Input`] if it cannot be
/// derived. `Error::Request` if the publication has no such printed equations.
pub fn derive_or_read_equations(model: &Mechanism, by: &EquationsOrigin) -> Result<Derivation, Error> {
    if let Some(formulation) = by.formulation() {
        return model.derive(formulation);
    }
    let (arena, list) = read_printed_equations(model)?.unwrap_or_default();
    let equations = list.into_iter().find(|e| e.by == *by);
    let missing = || {
        let help = "the publication file changed while it was read: try again".to_owned();
        Error::request(format!("there are no equations `{}`", by.name()), help)
    };
    Ok(Derivation { arena, equations: equations.ok_or_else(missing)? })
}

/// Finds the compiled equations of a model whose text has the same hash. `None` if the program contains no
/// such equations.
#[must_use]
pub fn compiled_model(model: &Mechanism) -> Option<&'static CompiledModel> {
    let hash = model.text_hash();
    model.compiled.iter().find(|m| m.text_hash == hash)
}
