//! Class of models.

use crate::arrays::{NAMES, Quantity};
use crate::failure::{RequestError, raised};
use numpy::{PyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
use tripos::code::{Code, CodePreparation, runnable_code};
use tripos::equations_name::find_equations;
use tripos::{EquationsName, Mechanism};
use tripos_derive::diagnostic::Source;
use tripos_derive::model::load;

/// Model of a mechanism, read from a file or a text.
#[pyclass(frozen, subclass, module = "tripos._tripos")]
pub struct Model {
    pub mechanism: Mechanism,
    /// Equations that were derived so far, by their names.
    codes: Mutex<BTreeMap<String, Arc<Code>>>,
}

impl Model {
    pub fn new(mechanism: Mechanism) -> Self {
        Self { mechanism, codes: Mutex::default() }
    }

    /// Equations of a name, derived at the first call.
    fn code(&self, py: Python<'_>, name: &str) -> PyResult<Arc<Code>> {
        let known = |codes: &Mutex<BTreeMap<String, Arc<Code>>>| {
            codes.lock().unwrap_or_else(PoisonError::into_inner).get(name).cloned()
        };
        if let Some(code) = known(&self.codes) {
            return Ok(code);
        }
        let derived = py.detach(|| {
            let by = find_equations(&self.mechanism, &EquationsName::from(name))?;
            runnable_code(&self.mechanism, &by, None, CodePreparation::Solved)
        });
        let code = Arc::new(derived.map_err(|error| raised(py, &error))?);
        self.codes.lock().unwrap_or_else(PoisonError::into_inner).insert(name.to_owned(), Arc::clone(&code));
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
        mechanism.map(Self::new).map_err(|error| raised(py, &error.into()))
    }

    /// Reads a model from its text.
    #[staticmethod]
    fn parse(py: Python<'_>, text: &str) -> PyResult<Self> {
        let model = py.detach(|| load(&Source::from_text("model.toml", text)));
        model.map(|model| Self::new(Mechanism::new(model))).map_err(|error| raised(py, &error.into()))
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
        let of = |p: &tripos_derive::model::Parameter| {
            let value = p.value.as_ref().map(tripos_derive::algebra::Rational::to_f64);
            (p.name.clone(), p.unit.to_string(), value, p.about.clone(), p.is_input)
        };
        self.mechanism.model.parameters.iter().map(of).collect()
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

    /// Numbers of coordinates, of motion variables and of values that a function of the equations has, for one state.
    fn lengths(&self, py: Python<'_>, name: &str, equations: &str) -> PyResult<(usize, usize, usize)> {
        let code = self.code(py, equations)?;
        let quantity = Quantity::of(code.system(), name).ok_or_else(|| absent(name, code.system()))?;
        let lengths = code.system().lengths();
        Ok((lengths.coordinates, lengths.variables, quantity.count))
    }

    /// File from which the model was read.
    #[getter]
    fn file(&self) -> PathBuf {
        self.mechanism.model.source.path.clone()
    }

    /// Values of a function at the rows of q, v and x, one after the other.
    #[expect(clippy::too_many_arguments, clippy::needless_pass_by_value, reason = "arguments as Python gives them")]
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        equations: &str,
        p: Vec<f64>,
        q: PyReadonlyArray2<'py, f64>,
        v: PyReadonlyArray2<'py, f64>,
        x: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let code = self.code(py, equations)?;
        let quantity = Quantity::of(code.system(), name).ok_or_else(|| absent(name, code.system()))?;
        // Another thread may change an array while the lock of the interpreter is free: values are copied.
        let arrays = [&q, &v, &x].map(|array| {
            let array = array.as_array();
            (array.iter().copied().collect::<Vec<f64>>(), array.ncols())
        });
        let states = q.as_array().nrows();
        let lengths = code.system().lengths();
        let accelerations = if quantity.takes_accelerations { lengths.variables } else { 0 };
        let expected = [(states, lengths.coordinates), (states, lengths.variables), (states, accelerations)];
        let given = [&q, &v, &x].map(|array| array.as_array().dim());
        if given != expected || p.len() != lengths.parameters {
            let what = format!("the arrays have the shapes {given:?}; `{name}` takes {expected:?}");
            return Err(RequestError::new_err(what));
        }
        let values = py.detach(|| {
            let [q, v, x] = &arrays;
            quantity.values(&code, &p, states, [(&q.0, q.1), (&v.0, v.1), (&x.0, x.1)])
        });
        Ok(PyArray1::from_vec(py, values))
    }
}

/// Exception for a function that the equations do not have.
fn absent(name: &str, system: &dyn tripos_traits::System<f64>) -> PyErr {
    let names: Vec<&str> = NAMES.into_iter().filter(|name| Quantity::of(system, name).is_some()).collect();
    RequestError::new_err(format!("the equations have no function `{name}`; they have {}", names.join(", ")))
}
