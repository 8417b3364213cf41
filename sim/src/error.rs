//! Errors of the simulator: runs that cannot start, and right-hand sides that have no value.
//!
//! [`SimError`] means that the arguments of a run make no sense, so that nothing ran. [`Failure`] means that a
//! right-hand side has no value at a state. A failure is part of a run: it shortens the step, and ends the run as a
//! [`crate::Stop`] when no shorter step helps.

use std::fmt;

/// Reason why a run cannot start. Nothing was integrated.
#[derive(Clone, Debug, PartialEq)]
pub enum SimError {
    /// A list, such as the initial state or the parameters, has the wrong length.
    Length {
        /// Name of the list in words, such as "absolute tolerances".
        what: &'static str,
        /// Number of entries that the list must have.
        expected: usize,
        /// Number of entries that the list has.
        found: usize,
    },
    /// A start, a time or another given number is infinite or not a number.
    NotFinite {
        /// Name of the number that is not finite.
        what: String,
    },
    /// The span of the run is empty: the run would end at the time at which it starts.
    EmptySpan {
        /// Time at which the run would both start and end, s.
        t: f64,
    },
    /// A tolerance is negative, not a number, or leaves a component without any tolerance.
    Tolerance {
        /// Message that describes the wrong tolerance.
        what: String,
    },
    /// An option of the run has a value outside its range.
    Option {
        /// Name of the option whose value is outside its range.
        name: &'static str,
        /// Condition that the value of the option must meet, in words.
        must: &'static str,
    },
    /// The options give no fixed step, but the method estimates no error and cannot choose its steps.
    NoStep {
        /// Name of the integration method that cannot be used.
        method: &'static str,
    },
    /// The method needs the Jacobian ∂f/∂y, and the right-hand side does not provide it.
    NoJacobian {
        /// Name of the integration method that cannot be used.
        method: &'static str,
    },
    /// A trajectory of a batch, which is a set of runs made together, cannot be run.
    Trajectory {
        /// Index of the trajectory in the batch, from 0.
        index: usize,
        /// Reason why this trajectory cannot be run.
        error: Box<SimError>,
    },
    /// The method needs Taylor coefficients of the solution, and the right-hand side does not provide them.
    NoSeries {
        /// Name of the integration method that cannot be used.
        method: &'static str,
    },
    /// The method of a batch cannot integrate several trajectories in the lanes of vector registers, or cannot do so
    /// for these equations.
    NoLanes {
        /// Name of the integration method that cannot be used.
        method: &'static str,
    },
    /// A wanted output time lies outside the span, or before the previous output time in the list.
    OutputTime {
        /// Position of the output time in the list of output times, from 0.
        index: usize,
        /// Output time that is outside the span or out of order, s.
        t: f64,
    },
}

impl fmt::Display for SimError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { what, expected, found } => {
                write!(f, "{what}: expected {expected} numbers, found {found}")
            }
            Self::NotFinite { what } => write!(f, "{what} is not a finite number"),
            Self::EmptySpan { t } => {
                write!(f, "the run starts and ends at the same time t = {t} s")
            }
            Self::Tolerance { what } => f.write_str(what),
            Self::Option { name, must } => write!(f, "option `{name}` must be {must}"),
            Self::NoStep { method } => {
                write!(f, "method {method} estimates no error, so it cannot choose its steps: give it a fixed `step`")
            }
            Self::NoJacobian { method } => {
                write!(
                    f,
                    "method {method} needs the derivatives of the equations, which are not known for these; choose an \
                     explicit method, such as dop853"
                )
            }
            Self::Trajectory { index, error } => write!(f, "trajectory {index}: {error}"),
            Self::NoSeries { method } => {
                write!(
                    f,
                    "method {method} needs the Taylor coefficients of the solutions, which eliminated accelerations without \
                     |x| have and these equations do not; choose another method, such as dop853"
                )
            }
            Self::NoLanes { method } => {
                write!(f, "method {method} is not had in lanes for these equations; choose dop853, or run one by one")
            }
            Self::OutputTime { index, t } => {
                write!(f, "output time {index}, t = {t} s, lies outside the run or before the previous one")
            }
        }
    }
}

impl std::error::Error for SimError {}

/// Reason why a right-hand side or an event function has no value at a state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// Short stable word that names the kind of failure for programs, such as `"singular"`.
    pub code: &'static str,
    /// Sentence for the user: the value that does not exist, and the place where it was needed.
    pub message: String,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Failure {}
