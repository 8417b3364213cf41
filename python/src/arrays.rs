//! NumPy arrays as arguments of functions and as returned values.

use crate::failure::RequestError;
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyDict;
use tripos::state_arrays::{Rows, StateRows, ValueShape};

/// Arrays of coordinates, generalized speeds and, for some functions, accelerations. They have the shape (n,) for one
/// state, or (N, n) for N states.
pub struct StateArrays<'py> {
    q: StateArray<'py>,
    u: StateArray<'py>,
    u_dot: Option<StateArray<'py>>,
    /// Number of states; `None` for a single state in arrays of the shape (n,).
    pub states: Option<usize>,
}

impl<'py> StateArrays<'py> {
    /// Reads the arrays of states with these numbers of coordinates and motion variables. Error if the arrays have
    /// different numbers of states.
    pub fn new(
        (coordinates, variables): (usize, usize),
        q: &Bound<'py, PyAny>,
        u: &Bound<'py, PyAny>,
        u_dot: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Self> {
        let q = StateArray::new("q", q, coordinates)?;
        let u = StateArray::new("u", u, variables)?;
        let u_dot = u_dot.map(|given| StateArray::new("u_dot", given, variables)).transpose()?;
        let arrays = [Some(&q), Some(&u), u_dot.as_ref()];
        let counts = || arrays.iter().flatten().filter_map(|array| array.states);
        // As in NumPy, an array with a single row is used for all states.
        let states = counts().find(|count| *count != 1).or_else(|| counts().next());
        if counts().any(|count| count != 1 && Some(count) != states) {
            let counts: Vec<String> = counts().map(|count| count.to_string()).collect();
            return Err(RequestError::new_err(format!("the arrays have {} states", counts.join(", "))));
        }
        Ok(Self { q, u, u_dot, states })
    }

    /// Returns the rows of all arrays, with one row of each array for each state. An array with a single row serves all
    /// states.
    pub fn rows(&self) -> PyResult<StateRows<'_>> {
        let count = self.states.unwrap_or(1);
        let v_dot = self.u_dot.as_ref().map_or(Ok(Rows::shared(&[])), |array| array.rows(count))?;
        Ok(StateRows { count, q: self.q.rows(count)?, v: self.u.rows(count)?, v_dot })
    }
}

/// Array given as one argument of a function, with a row for each state.
struct StateArray<'py> {
    /// Numbers of the array, row by row.
    array: PyReadonlyArrayDyn<'py, f64>,
    /// Number of states; `None` for a single state in an array of the shape (n,).
    states: Option<usize>,
}

impl<'py> StateArray<'py> {
    /// Reads the argument with this name. Each state must have `width` numbers. An array of `f64` numbers, row by row,
    /// is used without a copy; anything else is converted by NumPy.
    fn new(name: &str, given: &Bound<'py, PyAny>, width: usize) -> PyResult<Self> {
        let in_place = given.extract::<PyReadonlyArrayDyn<'py, f64>>().ok().filter(|array| array.is_c_contiguous());
        let array = match in_place {
            Some(array) => array,
            None => converted(name, given)?,
        };
        let states = match *array.shape() {
            [last] if last == width => None,
            [states, last] if last == width => Some(states),
            ref shape => {
                let given: Vec<String> = shape.iter().map(usize::to_string).collect();
                let comma = if given.len() == 1 { "," } else { "" };
                let given = given.join(", ");
                let what = format!("{name} has the shape ({given}{comma}); give ({width},) or (N, {width})");
                return Err(RequestError::new_err(what));
            }
        };
        Ok(Self { array, states })
    }

    /// Returns the rows of the argument for `count` states. If the argument has another number of rows, its single row
    /// serves all states.
    fn rows(&self, count: usize) -> PyResult<Rows<'_>> {
        let values = self.array.as_slice()?;
        let width = self.array.shape().last().copied().unwrap_or(0);
        Ok(if self.states == Some(count) { Rows::each(values, width) } else { Rows::shared(values) })
    }
}

/// Converts any array or list of real numbers to an array of `f64` numbers, row by row. Error for other values.
fn converted<'py>(name: &str, given: &Bound<'py, PyAny>) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    static CONVERT: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    let py = given.py();
    let convert = CONVERT.get_or_try_init(py, || py.import("numpy")?.getattr("asarray").map(Bound::unbind))?.bind(py);
    let how = PyDict::new(py);
    how.set_item(intern!(py, "dtype"), intern!(py, "float64"))?;
    how.set_item(intern!(py, "order"), intern!(py, "C"))?;
    let array = convert.call1((given,)).and_then(|array| {
        let kind: String = array.getattr(intern!(py, "dtype"))?.getattr(intern!(py, "kind"))?.extract()?;
        // Accepted kinds are truth values, integers, floats, and objects such as fractions, but not times and complex
        // numbers.
        if !["b", "i", "u", "f", "O"].contains(&kind.as_str()) {
            let dtype = array.getattr(intern!(py, "dtype"))?;
            return Err(PyTypeError::new_err(format!("its numbers are of the type {dtype}")));
        }
        convert.call((array,), Some(&how))
    });
    let array = array.map_err(|error| {
        let refused = RequestError::new_err(format!("{name} is no array of real numbers: {}", error.value(py)));
        refused.set_cause(py, Some(error));
        refused
    })?;
    array.extract()
}

/// Creates an array of values, which `fill` writes. It has the values of one state if `states` is `None`, else a row
/// for each state.
pub fn filled_array(
    py: Python<'_>,
    states: Option<usize>,
    shape: ValueShape,
    fill: impl FnOnce(&mut [f64]),
) -> PyResult<Bound<'_, PyAny>> {
    macro_rules! filled {
        ($kind:ident, $dimensions:expr) => {{
            let array = $kind::<f64>::zeros(py, $dimensions, false);
            fill(array.readwrite().as_slice_mut()?);
            Ok(array.into_any())
        }};
    }
    match (states, shape) {
        (None, ValueShape::Number) => {
            let mut value = [0.0];
            fill(&mut value);
            let array = PyArray1::from_slice(py, &value);
            array.get_item(0)
        }
        (None, ValueShape::Vector(n)) => filled!(PyArray1, [n]),
        (None, ValueShape::Matrix(n)) => filled!(PyArray2, [n, n]),
        (Some(count), ValueShape::Number) => filled!(PyArray1, [count]),
        (Some(count), ValueShape::Vector(n)) => filled!(PyArray2, [count, n]),
        (Some(count), ValueShape::Matrix(n)) => filled!(PyArray3, [count, n, n]),
    }
}
