//! Python classes of scenes and of their runs.

use crate::failure::{RequestError, raised};
use crate::model::Model;
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, OnceLock, PoisonError};
use std::time::Instant;
use tripos::observer::Observer;
use tripos::{
    AccelerationSolution, ControllerSample, DerivativeInstants, EquationsName, Error, Integrator, Overrides,
    ProjectionTarget,
};
use tripos_models::MODELS;
use tripos_sim::Poll;

/// Scene of a model: a start, parameters, a span and outputs.
#[pyclass(frozen, subclass, module = "tripos._tripos")]
pub struct Scene {
    scene: Mutex<tripos::Scene>,
}

/// Time between two checks for signals of Python, ms. It limits how often a run takes the lock of the interpreter.
const BETWEEN_SIGNALS: u64 = 20;

/// Time of the last check for signals, in milliseconds after the first check.
static LOOKED: AtomicU64 = AtomicU64::new(0);
/// True if a signal has come during the run.
static IS_INTERRUPTED: AtomicBool = AtomicBool::new(false);
/// Exception of the signal that came during the run. No thread may wait while it holds this mutex, since a process
/// forked at this moment would never see the mutex released.
static RAISED: Mutex<Option<PyErr>> = Mutex::new(None);

/// Calls `look` with the lock of the interpreter if the time for the next check has come, and stores an exception that
/// it raises. Returns true if there is an exception, which [`raise_signal`] raises after the run.
fn is_interrupted_after(look: impl Fn(Python<'_>) -> PyResult<()>) -> bool {
    static BEGIN: OnceLock<Instant> = OnceLock::new();
    let now = u64::try_from(BEGIN.get_or_init(Instant::now).elapsed().as_millis()).unwrap_or(u64::MAX);
    let looked = LOOKED.load(Ordering::Relaxed);
    // If several threads run, only one of them checks.
    let is_time = now >= looked + BETWEEN_SIGNALS
        && LOOKED.compare_exchange(looked, now, Ordering::Relaxed, Ordering::Relaxed).is_ok();
    if is_time
        && !IS_INTERRUPTED.load(Ordering::Acquire)
        && let Some(signal) = Python::attach(|py| look(py).err())
    {
        *RAISED.lock().unwrap_or_else(PoisonError::into_inner) = Some(signal);
        IS_INTERRUPTED.store(true, Ordering::Release);
    }
    IS_INTERRUPTED.load(Ordering::Acquire)
}

/// True if the user has interrupted Python. [`raise_signal`] raises the exception after the run.
#[expect(clippy::redundant_closure_for_method_calls, reason = "the method is of one lifetime alone")]
fn is_interrupted() -> bool {
    is_interrupted_after(|py| py.check_signals())
}

/// Raises the exception of a signal that came during the last run.
fn raise_signal(py: Python<'_>) -> PyResult<()> {
    if IS_INTERRUPTED.swap(false, Ordering::AcqRel)
        && let Some(signal) = RAISED.lock().unwrap_or_else(PoisonError::into_inner).take()
    {
        return Err(signal);
    }
    py.check_signals()
}

/// Observer that ends long work if the user interrupts Python. It calls `report` with the time that a run has reached, s.
fn observer(report: Option<Py<PyAny>>) -> Observer {
    let poll = move |t: f64| {
        let is_interrupted = is_interrupted_after(|py| {
            py.check_signals()?;
            report.as_ref().map_or(Ok(()), |report| report.call1(py, (t,)).map(drop))
        });
        if is_interrupted { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    Observer::new(Poll::new(poll), is_interrupted)
}

/// Parses the text of a setting; `None` without a text. Error with a Python exception if the text is invalid.
fn setting<T: std::str::FromStr>(text: Option<&str>) -> PyResult<Option<T>>
where
    T::Err: ToString,
{
    text.map(str::parse).transpose().map_err(|error: T::Err| RequestError::new_err(error.to_string()))
}

/// Reads the settings of a run from keyword arguments.
fn overrides(settings: Option<&Bound<'_, PyDict>>) -> PyResult<Overrides> {
    let mut how = Overrides::default();
    for (name, value) in settings.into_iter().flatten() {
        let name: String = name.extract()?;
        if value.is_none() {
            continue;
        }
        match name.as_str() {
            "by" => how.by = Some(EquationsName::from(value.extract::<String>()?.as_str())),
            "method" => how.method = setting::<Integrator>(Some(&value.extract::<String>()?))?,
            "project" => how.project = setting::<ProjectionTarget>(Some(&value.extract::<String>()?))?,
            "solve" => how.solve = setting::<AccelerationSolution>(Some(&value.extract::<String>()?))?,
            "step" => how.step = Some(value.extract()?),
            "max_step" => how.max_step = Some(value.extract()?),
            "rtol" => how.rtol = Some(value.extract()?),
            "atol" => how.atol = Some(value.extract()?),
            "step_limit" => how.step_limit = Some(value.extract()?),
            "samples" => how.samples = Some(value.extract()?),
            "until" => how.until = Some(value.extract()?),
            name => {
                let names = "by, method, project, solve, step, max_step, rtol, atol, step_limit, samples, until";
                return Err(RequestError::new_err(format!("there is no setting `{name}`; settings are {names}")));
            }
        }
    }
    Ok(how)
}

impl Scene {
    fn new(scene: tripos::Scene) -> Self {
        Self { scene: Mutex::new(scene.with_compiled_equations(MODELS).with_observer(observer(None))) }
    }

    /// Copy of the scene for work without the lock of the interpreter.
    fn copied(&self) -> tripos::Scene {
        self.scene.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Copy of the scene whose runs call `report` with the time that they have reached, s.
    fn reporting(&self, report: Option<Py<PyAny>>) -> tripos::Scene {
        let scene = self.copied();
        if report.is_some() { scene.with_observer(observer(report)) } else { scene }
    }
}

#[pymethods]
impl Scene {
    /// Reads a scene file, and the model file that it names.
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let scene = py.detach(|| tripos::Scene::read(path)).map_err(|error| raised(py, &error))?;
        Ok(Self::new(scene))
    }

    /// Makes a scene of a model from the text of a scene file.
    #[staticmethod]
    fn parse(py: Python<'_>, model: &Model, text: &str) -> PyResult<Self> {
        let mechanism = model.mechanism.clone();
        let scene = py.detach(|| tripos::Scene::parse(mechanism, text)).map_err(|error| raised(py, &error))?;
        Ok(Self::new(scene))
    }

    /// A scene that can be changed without changing this one.
    fn copy(&self) -> Self {
        Self { scene: Mutex::new(self.copied()) }
    }

    /// Model of the scene.
    fn mechanism(&self) -> Model {
        Model::new(self.copied().mechanism().clone())
    }

    /// Sets a parameter or a number of the start, in the unit of the model file.
    fn set(&self, py: Python<'_>, name: &str, value: f64) -> PyResult<()> {
        let mut scene = self.copied();
        py.detach(|| scene.set_number(name, value)).map_err(|error| raised(py, &error))?;
        *self.scene.lock().unwrap_or_else(PoisonError::into_inner) = scene;
        Ok(())
    }

    /// First and last instant of a run, s.
    #[getter]
    fn span(&self) -> (f64, f64) {
        self.copied().description().span
    }

    /// Runs the scene with settings that replace those of its file. `report` is called some times with the time that
    /// the run has reached, s; then a second run, for the digits, begins again.
    #[pyo3(signature = (settings=None, report=None))]
    fn run(&self, py: Python<'_>, settings: Option<&Bound<'_, PyDict>>, report: Option<Py<PyAny>>) -> PyResult<Run> {
        let (scene, how) = (self.reporting(report), overrides(settings)?);
        let run = py.detach(|| scene.simulate(&how));
        raise_signal(py)?;
        run.map(|run| Run { run }).map_err(|error| raised(py, &error))
    }

    /// Derivatives of the shown quantities at the end of the run with respect to these numbers: rows are quantities.
    #[expect(clippy::needless_pass_by_value, reason = "arguments as Python gives them")]
    #[pyo3(signature = (names, settings=None))]
    fn slopes<'py>(
        &self,
        py: Python<'py>,
        names: Vec<String>,
        settings: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<(Bound<'py, PyDict>, Vec<String>)> {
        let (scene, how) = (self.copied(), overrides(settings)?);
        let list: Vec<&str> = names.iter().map(String::as_str).collect();
        let found = py.detach(|| scene.sensitivities(&list, DerivativeInstants::End, &how));
        raise_signal(py)?;
        let found = found.map_err(|error| raised(py, &error))?;
        let table = PyDict::new(py);
        for quantity in &found.names {
            let row = PyDict::new(py);
            for name in &names {
                row.set_item(name, found.derivative_of(quantity, name).map_err(|error| raised(py, &error))?)?;
            }
            table.set_item(quantity, row)?;
        }
        Ok((table, found.run.objections().into_iter().chain(found.missing_derivative()).collect()))
    }

    /// One number at the end of the run, its derivatives with respect to all parameters and numbers of the start, and
    /// reasons not to trust them.
    #[pyo3(signature = (of, settings=None))]
    fn gradient_of<'py>(
        &self,
        py: Python<'py>,
        of: &str,
        settings: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<(f64, Bound<'py, PyDict>, Vec<String>)> {
        let (scene, how) = (self.copied(), overrides(settings)?);
        let found = py.detach(|| scene.gradient(of, &how));
        raise_signal(py)?;
        let table = PyDict::new(py);
        let found = found.map_err(|error| raised(py, &error))?;
        for slope in &found.slopes {
            table.set_item(&slope.by, slope.value)?;
        }
        let value = match found.run.names.iter().position(|name| name == of) {
            Some(at) => found.run.end[at],
            None if of == "t" => found.run.solution.t_end,
            None => energy_at_end(&found.run, of).ok_or_else(|| {
                RequestError::new_err(format!("the run does not show `{of}`; add it to the outputs of the scene"))
            })?,
        };
        let fixed = found.moving_span.iter();
        let fixed =
            fixed.map(|name| format!("the span depends on `{name}`: the derivative is that at a fixed instant"));
        Ok((value, table, found.run.objections().into_iter().chain(found.missing()).chain(fixed).collect()))
    }

    /// Runs the scene with inputs that a Python function sets at instants: `controller(t, values)` gets a dictionary of
    /// the shown quantities, and returns the values of the inputs: numbers, or a number for one input. `make` returns a new controller for each run.
    #[expect(clippy::needless_pass_by_value, reason = "arguments as Python gives them")]
    #[pyo3(signature = (inputs, instants, make, settings=None, report=None))]
    fn run_sampled<'py>(
        &self,
        py: Python<'py>,
        inputs: Vec<String>,
        instants: Vec<f64>,
        make: &Bound<'py, PyAny>,
        settings: Option<&Bound<'py, PyDict>>,
        report: Option<Py<PyAny>>,
    ) -> PyResult<SampledRun> {
        let (scene, how) = (self.reporting(report), overrides(settings)?);
        let failed: Mutex<Option<PyErr>> = Mutex::new(None);
        let names: Vec<&str> = inputs.iter().map(String::as_str).collect();
        let count = names.len();
        let controller = || {
            let own = make.call0();
            let (failed, names) = (&failed, &names);
            move |sample: &ControllerSample<'_>| {
                let call = || -> PyResult<Vec<f64>> {
                    let values = values_by_name(py, sample.names, sample.values)?;
                    let own = own.as_ref().map_err(|error| error.clone_ref(py))?;
                    let returned = own.call1((sample.t, values))?;
                    let numbers = returned.extract::<Vec<f64>>().or_else(|_| returned.extract().map(|x| vec![x]));
                    match numbers {
                        Ok(numbers) if numbers.len() == count && numbers.iter().all(|x| x.is_finite()) => Ok(numbers),
                        _ => Err(RequestError::new_err(format!(
                            "the controller returned {} at t = {} s; return a finite number for each of {}",
                            returned.repr()?,
                            sample.t,
                            names.join(", "),
                        ))),
                    }
                };
                let stopped = failed.lock().is_ok_and(|failed| failed.is_some());
                if stopped {
                    return vec![f64::NAN; count];
                }
                call().unwrap_or_else(|error| {
                    if let Ok(mut failed) = failed.lock() {
                        *failed = Some(error);
                    }
                    vec![f64::NAN; count]
                })
            }
        };
        let run = scene.simulate_sampled(&names, &instants, controller, &how);
        raise_signal(py)?;
        if let Some(error) = failed.into_inner().ok().flatten() {
            return Err(error);
        }
        let run = run.map_err(|error: Error| raised(py, &error))?;
        Ok(SampledRun { run })
    }
}

/// Finished run of a scene.
#[pyclass(frozen, subclass, module = "tripos._tripos")]
pub struct Run {
    run: tripos::Run,
}

#[pymethods]
impl Run {
    #[getter]
    fn names(&self) -> Vec<String> {
        self.run.names.clone()
    }

    /// Instants of the samples, s.
    #[getter]
    fn t<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_iter(py, self.run.samples().map(|(t, _)| t))
    }

    /// Values of the shown quantities: a row for each sample.
    #[getter]
    fn values<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let rows: Vec<Vec<f64>> = self.run.samples().map(|(_, row)| row.to_vec()).collect();
        rows_as_array(py, &rows, self.run.names.len())
    }

    /// Values at the end, by names.
    #[getter]
    fn end<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        values_by_name(py, &self.run.names, &self.run.end)
    }

    /// Estimated errors at the end, by names; `None` if they are not known.
    #[getter]
    fn errors<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let errors = self.run.digits.as_ref().and_then(|digits| digits.errors_at_end());
        errors.map(|errors| values_by_name(py, &self.run.names, errors)).transpose()
    }

    /// Correct digits at the end, by names; `None` if they are not known.
    #[getter]
    fn digits<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let digits = self.run.digits.as_ref().and_then(|digits| digits.digits_at_end());
        digits.map(|digits| values_by_name(py, &self.run.names, digits)).transpose()
    }

    /// Names and instants of the events.
    #[getter]
    fn events(&self) -> Vec<(String, f64)> {
        self.run.events().iter().map(|event| (event.name.clone(), event.t)).collect()
    }

    /// Reasons not to trust the run.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.run.objections()
    }

    /// Notes on the way in which the run was made.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.run.notes.clone()
    }

    /// Sentence that says when and why the run ended.
    #[getter]
    fn ending(&self) -> &str {
        &self.run.ending
    }

    /// Largest change of each conserved quantity, by its name.
    #[getter]
    fn drift<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (names, changes): (Vec<String>, Vec<f64>) =
            self.run.drifts.iter().map(|drift| (drift.integral.name.clone(), drift.change)).unzip();
        values_by_name(py, &names, &changes)
    }

    #[getter]
    fn is_trusted(&self) -> bool {
        self.run.is_trusted()
    }

    /// Steps, rejected steps and evaluations of the equations.
    #[getter]
    fn work(&self) -> (u64, u64, u64) {
        let solution = &self.run.solution;
        (solution.steps, solution.rejected, solution.evaluations)
    }
}

/// Finished run of a scene with a controller.
#[pyclass(frozen, module = "tripos._tripos")]
pub struct SampledRun {
    run: tripos::SampledRun,
}

#[pymethods]
impl SampledRun {
    #[getter]
    fn names(&self) -> Vec<String> {
        self.run.names.clone()
    }

    /// Instants of the samples, s.
    #[getter]
    fn t<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.run.t)
    }

    /// Values of the shown quantities: a row for each sample.
    #[getter]
    fn values<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rows_as_array(py, &self.run.states, self.run.names.len())
    }

    /// Values at the end, by names.
    #[getter]
    fn end<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        values_by_name(py, &self.run.names, &self.run.end)
    }

    /// Estimated errors at the end, by names; `None` if they are not known.
    #[getter]
    fn errors<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let errors = self.run.errors_at_end.as_ref();
        errors.map(|errors| values_by_name(py, &self.run.names, errors)).transpose()
    }

    /// Correct digits at the end, by names; `None` if they are not known.
    #[getter]
    fn digits<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let digits = self.run.digits_at_end.as_ref();
        digits.map(|digits| values_by_name(py, &self.run.names, digits)).transpose()
    }

    #[getter]
    fn is_trusted(&self) -> bool {
        self.run.is_trusted()
    }

    /// Instants at which the controller set the inputs, s.
    #[getter]
    fn decision_times<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_iter(py, self.run.decisions.iter().map(|decision| decision.t))
    }

    /// Values of the inputs: a row for each of the instants.
    #[getter]
    fn decisions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let rows: Vec<Vec<f64>> = self.run.decisions.iter().map(|decision| decision.inputs.clone()).collect();
        rows_as_array(py, &rows, self.run.inputs.len())
    }

    /// Names and instants of the events.
    #[getter]
    fn events(&self) -> Vec<(String, f64)> {
        self.run.events.iter().map(|event| (event.name.clone(), event.t)).collect()
    }

    /// Reasons not to trust the run.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.run.objections()
    }

    /// Sentence that says when and why the run ended.
    #[getter]
    fn ending(&self) -> String {
        self.run.ending()
    }
}

/// Energy with this name at the end of a run, J. `None` for another name, or if the run has no energies at its end.
fn energy_at_end(run: &tripos::Run, name: &str) -> Option<f64> {
    let (kinetic, potential) = run.energies.last().filter(|_| run.solution.t.last() == Some(&run.solution.t_end))?;
    match name {
        "kinetic_energy" => Some(*kinetic),
        "potential_energy" => Some(*potential),
        "total_energy" => Some(kinetic + potential),
        _ => None,
    }
}

/// Converts rows of equal lengths to a NumPy array. `width` is the number of columns if there are no rows.
fn rows_as_array<'py>(py: Python<'py>, rows: &[Vec<f64>], width: usize) -> PyResult<Bound<'py, PyArray2<f64>>> {
    if rows.is_empty() {
        return Ok(PyArray2::zeros(py, [0, width], false));
    }
    Ok(PyArray2::from_vec2(py, rows)?)
}

/// Creates a Python dictionary of values by name.
fn values_by_name<'py>(py: Python<'py>, names: &[String], values: &[f64]) -> PyResult<Bound<'py, PyDict>> {
    let table = PyDict::new(py);
    for (name, value) in names.iter().zip(values) {
        table.set_item(name, value)?;
    }
    Ok(table)
}
