//! Errors of the simulator: questions that make no sense, and right-hand sides that have no value.
//!
//! Two kinds, kept apart: [`SimError`] is a question that makes no sense (nothing ran);
//! [`Failure`] is a right-hand side that has no value at some state. The second is part of a run:
//! it shortens the step, and ends the run as a [`crate::Stop`] when no shorter step helps.

use std::fmt;

/// Reason why a run cannot start. Nothing was integrated.
#[derive(Clone, Debug, PartialEq)]
pub enum SimError {
    /// A slice has the wrong length.
    Length {
        /// Content of the slice, in words.
        what: &'static str,
        /// Length that the slice must have.
        expected: usize,
        /// Length that the slice has.
        found: usize,
    },
    /// A number is not finite, though it must be.
    NotFinite {
        /// Name of the number.
        what: String,
    },
    /// The run would end at the time at which it starts.
    EmptySpan {
        /// Time of the start and of the end, s.
        t: f64,
    },
    /// A tolerance is negative, not a number, or leaves a component without any tolerance.
    Tolerance {
        /// Description of the mistake, for people.
        what: String,
    },
    /// An option of the run has a value outside its range.
    Option {
        /// Name of the option.
        name: &'static str,
        /// Condition that the value must meet, in words.
        must: &'static str,
    },
    /// A method without an error estimate has no fixed step.
    NoStep {
        /// Name of the method.
        method: &'static str,
    },
    /// A method that needs ∂f/∂y cannot run a right-hand side without it.
    NoJacobian {
        /// Name of the method.
        method: &'static str,
    },
    /// A trajectory of a batch cannot be run.
    Trajectory {
        /// Position of the trajectory in the batch, from 0.
        index: usize,
        /// Error of this trajectory.
        error: Box<SimError>,
    },
    /// A method that needs Taylor coefficients cannot run a right-hand side without them.
    NoSeries {
        /// Name of the method.
        method: &'static str,
    },
    /// The method of a batch does not run in lanes, or not with these equations.
    NoLanes {
        /// Name of the method.
        method: &'static str,
    },
    /// An output time lies outside the span or before its predecessor.
    OutputTime {
        /// Position of the output time in the list, from 0.
        index: usize,
        /// Output time, s.
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

/// Reason why a right-hand side has no value at some state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// A short stable word for programs, such as `"singular"`.
    pub code: &'static str,
    /// A sentence for people: the value that does not exist, and the place where it was needed.
    pub message: String,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Failure {}
