//! Names by which the user selects the equations of motion of a run, and the search for the equations of a
//! model by name.

use crate::error::Error;
use crate::mechanism::Mechanism;
use std::fmt;
use tripos_derive::algebra::Arena;
use tripos_derive::diagnostic::nearest_name_advice;
use tripos_derive::diff::printed_equations;
use tripos_derive::mechanics::{EquationsOrigin, derive_all};
use tripos_derive::publication::load_publication_of_model;
use tripos_derive::{Equations, Formulation, derive};

/// Name by which the user of a run selects its equations of motion, such as `kane` or `printed:ID`.
///
/// Every text is accepted here, because only a model knows which printed equations exist. A name that fits no
/// equations of the model is refused later, in the search for the equations.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EquationsName {
    /// Equations that the program derives by a formulation, such as `kane`.
    Derived(Formulation),
    /// Printed equations of the publication beside the model file, named `printed:ID`. The value is their id.
    Printed(String),
    /// Reduced equations of the scene, named `reduced`.
    Reduced,
    /// Any other text, which is the name of no equations in any model.
    Unknown(String),
}

impl From<&str> for EquationsName {
    fn from(name: &str) -> Self {
        if let Some(formulation) = Formulation::from_name(name) {
            return Self::Derived(formulation);
        }
        match EquationsOrigin::printed_id_of_argument(name) {
            Some(id) => Self::Printed(id.to_owned()),
            None if name == EquationsOrigin::Reduced.name() => Self::Reduced,
            None => Self::Unknown(name.to_owned()),
        }
    }
}

impl From<&EquationsOrigin> for EquationsName {
    fn from(by: &EquationsOrigin) -> Self {
        match by {
            EquationsOrigin::Derived(formulation) => Self::Derived(*formulation),
            EquationsOrigin::Printed { id, .. } => Self::Printed(id.clone()),
            EquationsOrigin::Reduced => Self::Reduced,
        }
    }
}

impl fmt::Display for EquationsName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Derived(formulation) => f.write_str(formulation.name()),
            Self::Printed(id) => write!(f, "printed:{id}"),
            Self::Reduced => f.write_str(&EquationsOrigin::Reduced.name()),
            Self::Unknown(name) => f.write_str(name),
        }
    }
}

/// Finds the formulation with the given name, such as `kane`.
///
/// # Errors
/// [`Error::Request`] if no formulation has this name.
pub fn formulation_of_name(name: &str) -> Result<Formulation, Error> {
    Formulation::from_name(name).ok_or_else(|| {
        let names = Formulation::ALL.map(Formulation::name);
        Error::request(format!("there is no formulation `{name}`"), nearest_name_advice(name, names))
    })
}

/// Finds the origin of the equations of a model with the given name, such as `kane` or
/// `printed:ID`.
///
/// # Errors
/// [`Error::Request`] if the model has no equations of this name. The name `reduced` is refused too, because
/// reduced equations belong to a scene. [`Error::Input`] if the publication has errors.
pub fn find_equations(model: &Mechanism, name: &EquationsName) -> Result<EquationsOrigin, Error> {
    let id = match name {
        EquationsName::Derived(formulation) => return Ok(EquationsOrigin::from(*formulation)),
        EquationsName::Printed(id) => id,
        // The reduced equations belong to a scene, and a model does not have them.
        EquationsName::Reduced | EquationsName::Unknown(_) => {
            // The names of printed equations are needed for the advice. Errors of the publication file are ignored,
            // because the user did not ask for it.
            let printed = list_printed_equations(model).unwrap_or_default();
            let names = Formulation::ALL.map(|f| f.name().to_owned()).into_iter();
            let names: Vec<String> = names.chain(printed.iter().map(EquationsOrigin::name)).collect();
            let name = name.to_string();
            return Formulation::from_name(&name).map(EquationsOrigin::from).ok_or_else(|| {
                let help = nearest_name_advice(&name, names.iter().map(String::as_str));
                Error::request(format!("there is no formulation `{name}`"), help)
            });
        }
    };
    let list = list_printed_equations(model)?;
    list.iter().find(|by| by.printed_id() == Some(id)).cloned().ok_or_else(|| {
        let names: Vec<String> = list.iter().map(EquationsOrigin::name).collect();
        let help = if list.is_empty() {
            "the model has no publication.toml beside it".to_owned()
        } else {
            nearest_name_advice(&name.to_string(), names.iter().map(String::as_str))
        };
        Error::request(format!("there are no printed equations `{name}`"), help)
    })
}

/// Finds the origin of the equations of a model with the given name. If `name` is `None`, it is the first
/// standard formulation by which the model can be derived, or Kane's if none is.
///
/// # Errors
/// `Error::Request` if the model has no equations of the given name. `Error::Input` if its publication has
/// errors. Without a name there are no errors.
pub fn find_equations_or_first(model: &Mechanism, name: Option<&EquationsName>) -> Result<EquationsOrigin, Error> {
    let first = || Formulation::STANDARD.into_iter().find(|f| derive(model, *f).is_ok()).unwrap_or(Formulation::Kane);
    name.map_or_else(|| Ok(EquationsOrigin::from(first())), |name| find_equations(model, name))
}

/// Lists the origins of the printed equations in the publication file beside the model file, in the order of
/// the publication. The list is empty if there is no publication file.
///
/// # Errors
/// [`Error::Input`] if the publication file or the model has errors.
pub fn list_printed_equations(model: &Mechanism) -> Result<Vec<EquationsOrigin>, Error> {
    let list = read_printed_equations(model)?.map(|(_, equations)| equations).unwrap_or_default();
    Ok(list.into_iter().map(|equations| equations.by).collect())
}

/// Reads the printed equations of the publication beside the model file, with the arena that contains their
/// expressions. `None` if there is no publication file.
pub(crate) fn read_printed_equations(model: &Mechanism) -> Result<Option<(Arena, Vec<Equations>)>, Error> {
    let mut with_publication = model.clone();
    let Some(publication) = load_publication_of_model(&model.source.path, &mut with_publication)? else {
        return Ok(None);
    };
    let mut derivations = derive_all(&with_publication).map_err(|error| model.diagnose(&error))?;
    let list = printed_equations(&with_publication, &mut derivations, &publication);
    Ok(Some((derivations.kinematics.arena, list)))
}
