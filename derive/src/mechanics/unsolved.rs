//! Reasons why accelerations cannot be used, or other results computed from equations of motion.

use crate::algebra::solve::linear::Singular;
use crate::diagnostic::{Diagnostic, Diagnostics, Source};
use std::fmt;

/// Result, computed from equations of motion, that an exact check did not confirm.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Unproved {
    /// The accelerations do not satisfy the row of the equations of motion with this index, counted from 0.
    Accelerations(usize),
    /// The Jacobian is not the derivative of the row with this index. Rows count from 0: first those of q̇, then the
    /// equations of motion.
    Jacobian(usize),
    /// The inverse dynamics is not M v̇ − f in the row with this index, counted from 0.
    InverseDynamics(usize),
    /// No random state was found at which all terms of the check have a value.
    NoPoint,
}

impl fmt::Display for Unproved {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Accelerations(row) => {
                write!(
                    out,
                    "the accelerations found by elimination do not satisfy row {} of the equations of motion",
                    row + 1
                )
            }
            Self::Jacobian(row) => write!(out, "row {} of the Jacobian is not the derivative of the rates", row + 1),
            Self::InverseDynamics(row) => write!(out, "row {} of inverse dynamics is not M v̇ - f", row + 1),
            Self::NoPoint => write!(out, "the eliminated accelerations have no value at any state that was tried"),
        }
    }
}

/// Reason why no accelerations can be computed from equations of motion.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Unsolved {
    /// The equations of motion determine the accelerations in no configuration.
    Singular(Singular),
    /// Accelerations were found, but an exact check did not confirm them. This is a fault of the
    /// program.
    Unproved(Unproved),
}

impl From<Singular> for Unsolved {
    fn from(singular: Singular) -> Self {
        Self::Singular(singular)
    }
}

impl From<Unproved> for Unsolved {
    fn from(unproved: Unproved) -> Self {
        Self::Unproved(unproved)
    }
}

impl fmt::Display for Unsolved {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Singular(_) => write!(out, "the accelerations are determined in no configuration"),
            Self::Unproved(unproved) => write!(out, "{unproved}"),
        }
    }
}

impl Unsolved {
    /// Advice for the user about the failure, in a single line.
    #[must_use]
    pub fn help(&self) -> &'static str {
        match self {
            Self::Singular(_) => "give every coordinate something that resists it",
            Self::Unproved(_) => {
                "this is a fault of Tripos, please report it with the model; `--solve numeric` runs from the proved mass matrix and forcing"
            }
        }
    }
}

/// Error for equations whose accelerations could not be solved for or proved. `equations` is the title of the
/// equations in the message.
#[must_use]
pub fn unsolved_equations_error(source: &Source, equations: &str, why: Unsolved) -> Diagnostics {
    Diagnostics::new(source.clone(), vec![Diagnostic::of_file(format!("{equations}: {why}"), why.help())])
}
