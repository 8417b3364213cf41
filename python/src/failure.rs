//! Errors of the library as Python exceptions, with their places in files.

use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyKeyboardInterrupt};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use tripos::Error;

create_exception!(tripos, TriposError, PyException, "Error of a model, a scene or a request.");
create_exception!(tripos, InputError, TriposError, "Errors of a file; `places` lists file, line, column and message.");
create_exception!(tripos, RequestError, TriposError, "A request that is not possible; `help` says what to do instead.");
create_exception!(tripos, StoppedError, TriposError, "A run or a state without a result, with the reason.");

/// Creates the exception of an error, with the attributes `places` and `help`.
pub fn raised(py: Python<'_>, error: &Error) -> PyErr {
    let text = error.to_string();
    let exception = match error {
        Error::Interrupted => return PyKeyboardInterrupt::new_err(()),
        Error::Request { .. } => RequestError::new_err(text),
        Error::Stopped(_) => StoppedError::new_err(text),
        _ => InputError::new_err(text),
    };
    let value = exception.value(py);
    let set = || -> PyResult<()> {
        value.setattr("help", error.message_and_advice().1)?;
        value.setattr("places", places(py, error)?)
    };
    set().err().unwrap_or(exception)
}

/// Places of an error in files, as Python dictionaries of file, line, column, message and help.
fn places<'py>(py: Python<'py>, error: &Error) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let mut list = Vec::new();
    for file in error.files() {
        for d in &file.list {
            let (line, column) = file.place(d).unzip();
            let place = PyDict::new(py);
            place.set_item("file", file.file(d).path.display().to_string())?;
            place.set_item("line", line)?;
            place.set_item("column", column)?;
            place.set_item("message", &d.message)?;
            place.set_item("help", &d.help)?;
            list.push(place);
        }
    }
    Ok(list)
}
