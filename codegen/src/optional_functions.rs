//! Optional functions of generated code: Jacobians and Taylor recurrences.
//!
//! They are longer than all other generated code, and runs are possible without them. If the Jacobian is not
//! generated, the code of the derivative is differentiated as it runs. If the recurrences are not generated, Taylor's
//! method interprets them.

use crate::model_folders::{is_same_model_file, scenes_in_model_folder};
use std::path::Path;
use tripos_derive::Model;
use tripos_derive::diagnostic::{Diagnostic, Diagnostics, Source, nearest_name_advice};
use tripos_derive::scene::{load_scene_with_inputs, model_path_of_scene};
use tripos_traits::Method;

/// Name of the file in a model's folder that lists the optional functions of its code.
const EXTRAS_FILE: &str = "code.toml";

/// Set of optional functions in generated code. A flag is true if the function is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Extras {
    /// Entries of the Jacobian ∂f/∂x of the state derivative x' = f(x), for implicit methods.
    pub jacobian: bool,
    /// Recurrences of the Taylor coefficients of the motion in time, for Taylor's method.
    pub taylor: bool,
}

impl Extras {
    /// Set of all optional functions: Jacobian and Taylor recurrences.
    pub const ALL: Self = Self { jacobian: true, taylor: true };
    /// Names of the optional functions in files and on the command line.
    pub const NAMES: [&str; 2] = ["jacobian", "taylor"];

    /// Returns the set of optional functions with the given names, `jacobian` and `taylor`.
    ///
    /// # Errors
    /// Returns a message and advice for the first unknown name.
    pub fn extras_from_names<'a>(names: impl IntoIterator<Item = &'a str>) -> Result<Self, (String, String)> {
        let mut all = Self::default();
        for name in names {
            match name {
                "jacobian" => all.jacobian = true,
                "taylor" => all.taylor = true,
                _ => {
                    let what = format!("there is no function `{name}` to be written beside the equations");
                    return Err((what, nearest_name_advice(name, Self::NAMES)));
                }
            }
        }
        Ok(all)
    }

    /// Returns the optional functions that a method of integration uses. The method works without them, but more
    /// slowly.
    #[must_use]
    pub fn for_method(method: Method) -> Self {
        Self { jacobian: method.needs_jacobian(), taylor: method.needs_series() }
    }

    /// Returns the union of two sets of optional functions.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self { jacobian: self.jacobian || other.jacobian, taylor: self.taylor || other.taylor }
    }

    /// Reads the set of optional functions from the file `code.toml` in the model's folder. The set is empty if there
    /// is no such file.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] of a file that cannot be read, has another key than `functions`, or names an unknown
    /// function.
    pub fn extras_from_code_toml(model: &Path) -> Result<Self, Diagnostics> {
        let path = model.with_file_name(EXTRAS_FILE);
        if !path.exists() {
            return Ok(Self::default());
        }
        let source = Source::read(&path)?;
        let refused =
            |message: String, help: &str| Diagnostics::new(source.clone(), vec![Diagnostic::of_file(message, help)]);
        let help = format!("write functions = [\"{}\"], or one of these names", Self::NAMES.join("\", \""));
        let table: toml::Table =
            source.text.parse().map_err(|error: toml::de::Error| refused(error.message().to_owned(), &help))?;
        let mut all = Self::default();
        for (key, value) in &table {
            let names: Option<Vec<&str>> =
                value.as_array().and_then(|list| list.iter().map(toml::Value::as_str).collect());
            let (true, Some(names)) = (key == "functions", names) else {
                return Err(refused(format!("`{key}` is no list of functions to be compiled"), &help));
            };
            all = all.and(Self::extras_from_names(names).map_err(|(what, help)| refused(what, &help))?);
        }
        Ok(all)
    }
}

/// Returns the optional functions of a model's code. They are those that `code.toml` in its folder names, and those
/// that the integration methods of its scenes use.
///
/// # Errors
/// Returns [`Diagnostics`] of `code.toml`. Scenes with errors are skipped.
pub(crate) fn requested_extras(model: &Model, path: &Path) -> Result<Extras, Diagnostics> {
    // Scenes with errors are skipped here, and reported where their own equations are derived.
    let scenes = scenes_in_model_folder(path).into_iter().filter_map(|scene| {
        let source = Source::read(&scene).ok()?;
        let belongs = model_path_of_scene(&source).is_ok_and(|of| is_same_model_file(&of, path));
        belongs.then(|| load_scene_with_inputs(&source, &mut model.clone()).ok())?
    });
    let methods = scenes.filter_map(|scene| scene.integration.method.method());
    Ok(methods.map(Extras::for_method).fold(Extras::extras_from_code_toml(path)?, Extras::and))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_asks_for_what_it_names() {
        let folder = tempfile::tempdir().unwrap();
        let model = folder.path().join("model.toml");
        assert_eq!(Extras::extras_from_code_toml(&model).unwrap(), Extras::default());
        let asked = |text: &str| {
            std::fs::write(folder.path().join(EXTRAS_FILE), text).unwrap();
            Extras::extras_from_code_toml(&model).map_err(|error| error.to_string())
        };
        assert_eq!(asked("functions = [\"taylor\"]\n"), Ok(Extras { taylor: true, jacobian: false }));
        assert_eq!(asked("functions = [\"jacobian\", \"taylor\"]\n"), Ok(Extras::ALL));
        for (text, part) in [
            ("functions = [\"tailor\"]", "there is no function `tailor`"),
            ("functions = \"taylor\"", "`functions` is no list"),
            ("function = []", "`function` is no list"),
            ("functions = [", "functions = [\"jacobian\", \"taylor\"]"),
        ] {
            let said = asked(text).unwrap_err();
            assert!(said.contains(part) && said.contains("code.toml"), "{said}");
        }
    }
}
