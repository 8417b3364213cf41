//! Python class of models.

use crate::arrays::{StateArrays, filled_array};
use crate::failure::{RequestError, raised};
use numpy::{PyArray3, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Mutex, OnceLock, PoisonError};
use tripos::code::{Code, CodePreparation, runnable_code};
use tripos::equations_name::find_equations;
use tripos::state_arrays::{StateFunction, evaluate_states};
use tripos::studies::identification::{StateRegressor, base_parameter_values, identify};
use tripos::{EquationsName, Mechanism};
use tripos_derive::algebra::Rational;
use tripos_derive::diagnostic::Source;
use tripos_derive::identify::Identification;
use tripos_derive::mechanics::RegressorParameters;
use tripos_derive::model::load;
use tripos_models::MODELS;
use tripos_traits::DoubleDouble;

/// Model of a mechanism, read from a file or a text.
#[pyclass(frozen, subclass, module = "tripos._tripos")]
pub struct Model {
    pub mechanism: Mechanism,
    /// Equations that were derived so far; the key is the name of the equations.
    codes: Mutex<BTreeMap<String, Code>>,
    /// Default value of each parameter; `None` if the file gives none.
    defaults: Vec<Option<f64>>,
    /// Base parameters and their regressor; empty until they are first used.
    identified: OnceLock<(Identification, StateRegressor)>,
}

impl Model {
    pub fn new(mechanism: Mechanism) -> Self {
        let value = |p: &tripos_derive::model::Parameter| p.value.as_ref().map(Rational::to_f64);
        let defaults = mechanism.model.parameters.iter().map(value).collect();
        Self { mechanism, codes: Mutex::default(), defaults, identified: OnceLock::new() }
    }

    /// Values of the parameters in the order of the model: the given value, or else the default of the file. Error for
    /// an unknown name, a value that is no number, or a parameter without a value.
    fn parameter_values(&self, given: &Bound<'_, PyDict>) -> PyResult<Vec<f64>> {
        let parameters = &self.mechanism.model.parameters;
        let mut values: Vec<Option<f64>> = self.defaults.clone();
        for (name, value) in given {
            let name: Bound<'_, PyString> = name.cast_into()?;
            let name = name.to_cow()?;
            let Some(at) = parameters.iter().position(|parameter| parameter.name == *name) else {
                let names: Vec<&str> = parameters.iter().map(|parameter| parameter.name.as_str()).collect();
                let what = format!("the model has no parameter `{name}`; its parameters are {}", names.join(", "));
                return Err(RequestError::new_err(what));
            };
            let number = value.extract().map_err(|_| {
                RequestError::new_err(format!("the parameter `{name}` is {value:?}, not a real number"))
            })?;
            values[at] = Some(number);
        }
        let missing = |at: usize| {
            let name = &parameters[at].name;
            RequestError::new_err(format!("the parameter `{name}` has no default: give {name}=…"))
        };
        values.iter().enumerate().map(|(at, value)| value.ok_or_else(|| missing(at))).collect()
    }

    /// Returns the base parameters and their regressor, which are computed at the first call.
    fn identification(&self, py: Python<'_>) -> PyResult<&(Identification, StateRegressor)> {
        if let Some(known) = self.identified.get() {
            return Ok(known);
        }
        let found = py.detach(|| {
            let mut found = identify(&self.mechanism, RegressorParameters::Bodies)?;
            // Arrays may contain any pose and any parameters, but groups that were found from closed poses are not
            // valid for all of them.
            found.ungroup();
            let regressor = StateRegressor::new(&self.mechanism, &found)?;
            Ok((found, regressor))
        });
        let found = found.map_err(|error| raised(py, &error))?;
        Ok(self.identified.get_or_init(|| found))
    }

    /// Returns the equations with this name, which are derived at the first call.
    fn code(&self, py: Python<'_>, name: &str) -> PyResult<Code> {
        let known = |codes: &Mutex<BTreeMap<String, Code>>| {
            codes.lock().unwrap_or_else(PoisonError::into_inner).get(name).cloned()
        };
        if let Some(code) = known(&self.codes) {
            return Ok(code);
        }
        let derived = py.detach(|| {
            let by = find_equations(&self.mechanism, &EquationsName::from(name))?;
            runnable_code(&self.mechanism, &by, None, CodePreparation::Solved)
        });
        let code = derived.map_err(|error| raised(py, &error))?;
        self.codes.lock().unwrap_or_else(PoisonError::into_inner).insert(name.to_owned(), code.clone());
        Ok(code)
    }
}

#[pymethods]
impl Model {
    /// Reads a model file.
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let path = if path.is_dir() { path.join("model.toml") } else { path };
        let mechanism = py.detach(|| Mechanism::read(&path));
        let mechanism = mechanism.map(|mechanism| mechanism.with_compiled_equations(MODELS));
        mechanism.map(Self::new).map_err(|error| raised(py, &error.into()))
    }

    /// Reads a model from its text.
    #[staticmethod]
    fn parse(py: Python<'_>, text: &str) -> PyResult<Self> {
        let model = py.detach(|| load(&Source::from_text("model.toml", text)));
        let mechanism = model.map(|model| Mechanism::new(model).with_compiled_equations(MODELS));
        mechanism.map(Self::new).map_err(|error| raised(py, &error.into()))
    }

    #[getter]
    fn title(&self) -> &str {
        &self.mechanism.model.title
    }

    #[getter]
    fn text(&self) -> String {
        self.mechanism.model.source.text.clone()
    }

    /// Name, unit, default and meaning of each parameter; the default is `None` if the file gives none.
    fn parameter_list(&self) -> Vec<(String, String, Option<f64>, String, bool)> {
        let of = |(p, default): (&tripos_derive::model::Parameter, &Option<f64>)| {
            (p.name.clone(), p.unit.to_string(), *default, p.about.clone(), p.is_input)
        };
        self.mechanism.model.parameters.iter().zip(&self.defaults).map(of).collect()
    }

    /// Name, unit and meaning of each coordinate.
    fn coordinate_list(&self) -> Vec<(String, String, String)> {
        let of = |q: &tripos_derive::model::Coordinate| (q.name.clone(), q.unit.to_string(), q.about.clone());
        self.mechanism.model.coordinates.iter().map(of).collect()
    }

    /// Name, unit and definition of each generalized speed.
    fn speed_list(&self) -> Vec<(String, String, String)> {
        let model = &self.mechanism.model;
        let text = |e| tripos_derive::algebra::text::print::print_text(&model.arena, e);
        model.speeds.iter().map(|u| (u.name.clone(), u.unit.to_string(), text(u.definition))).collect()
    }

    /// File from which the model was read.
    #[getter]
    fn file(&self) -> PathBuf {
        self.mechanism.model.source.path.clone()
    }

    /// Values of a function at the states (q, u), for inverse dynamics also with the accelerations `u_dot`. Parameters
    /// that are not among `parameters` have their defaults.
    #[expect(clippy::too_many_arguments, reason = "arguments as Python gives them")]
    #[pyo3(signature = (name, equations, parameters, q, u, u_dot=None, /))]
    fn value<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        equations: &str,
        parameters: &Bound<'py, PyDict>,
        q: &Bound<'py, PyAny>,
        u: &Bound<'py, PyAny>,
        u_dot: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let code = self.code(py, equations)?;
        let found = StateFunction::of_name(name).and_then(|function| Some((function, function.shape(&code)?)));
        let (function, shape) = found.ok_or_else(|| absent(name, &code))?;
        let p = self.parameter_values(parameters)?;
        let lengths = code.system().lengths();
        let arrays = StateArrays::new((lengths.coordinates, lengths.variables), q, u, u_dot)?;
        let rows = arrays.rows()?;
        filled_array(py, arrays.states, shape, |out| {
            // The lock of the interpreter is kept only for work that is shorter than two changes of the lock.
            if rows.count < STATES_WITHOUT_LOCK {
                evaluate_states(function, &code, &p, rows, out);
            } else {
                py.detach(|| evaluate_states(function, &code, &p, rows, out));
            }
        })
    }

    /// Regressor of the base parameters at the states: for each a row for each speed, with a column for each base
    /// parameter and the known part as the last column.
    #[pyo3(signature = (parameters, q, u, u_dot, /))]
    fn regressor<'py>(
        &self,
        py: Python<'py>,
        parameters: &Bound<'py, PyDict>,
        q: &Bound<'py, PyAny>,
        u: &Bound<'py, PyAny>,
        u_dot: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (_, regressor) = self.identification(py)?;
        let p = self.parameter_values(parameters)?;
        let lengths = (self.mechanism.model.coordinates.len(), self.mechanism.model.speeds.len());
        let arrays = StateArrays::new(lengths, q, u, Some(u_dot))?;
        let rows = arrays.rows()?;
        let (height, width) = regressor.shape();
        let array = PyArray3::zeros(py, [rows.count, height, width], false);
        let mut place = array.readwrite();
        let out = place.as_slice_mut()?;
        py.detach(|| regressor.evaluate(&p, rows, out));
        drop(place);
        if arrays.states.is_none() { array.get_item(0) } else { Ok(array.into_any()) }
    }

    /// Names and values of the base parameters; a value is `None` if no formula gives it.
    #[pyo3(signature = (parameters, /))]
    fn base_parameters(&self, py: Python<'_>, parameters: &Bound<'_, PyDict>) -> PyResult<Vec<(String, Option<f64>)>> {
        let (found, _) = self.identification(py)?;
        let p: Vec<DoubleDouble> = self.parameter_values(parameters)?.into_iter().map(DoubleDouble::from).collect();
        let values = base_parameter_values(&self.mechanism, found, &p).map_err(|error| raised(py, &error))?;
        let names = found.base.iter().map(|base| found.regressor.columns[base.column].name.clone());
        Ok(names.zip(values).map(|(name, value)| (name, value.map(DoubleDouble::hi))).collect())
    }
}

/// Smallest number of states for which other threads get the lock of the interpreter during the evaluation.
const STATES_WITHOUT_LOCK: usize = 16;

/// Creates the exception for a function that the equations do not have.
fn absent(name: &str, code: &Code) -> PyErr {
    let names: Vec<&str> =
        StateFunction::ALL.into_iter().filter(|f| f.shape(code).is_some()).map(StateFunction::name).collect();
    RequestError::new_err(format!("the equations have no function `{name}`; they have {}", names.join(", ")))
}
