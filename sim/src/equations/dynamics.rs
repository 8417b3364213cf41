//! Equations of motion as a right-hand side: solves the linear system of a [`System`] for the accelerations at each
//! state.
//!
//! The state is y = (q, v): generalized coordinates, then motion variables. Buffers are allocated once: for up to 12
//! unknowns an evaluation allocates nothing.

use tripos_traits::System;

use crate::error::{Failure, SimError};
use crate::linear::{self, MatrixKind, UnsolvableSystem};
use crate::right_hand_side::RightHandSide;
use crate::solution::Solution;

/// Right-hand side y' = (q̇, v̇) of a model's equations of motion with given parameters. The
/// accelerations v̇ are solved for at each state.
pub struct Dynamics<'a> {
    /// Equations of motion of the model in a formulation.
    system: &'a dyn System<f64>,
    /// Values of the parameters, in the order of the model file.
    parameters: Vec<f64>,
    /// Name of the equations in messages; may be empty.
    label: String,
    /// Matrix A of the linear system for accelerations and reactions, row by row.
    matrix: Vec<f64>,
    /// Right-hand side b of the linear system A x = b; after the solution its unknowns x: accelerations, then
    /// reactions.
    unknowns: Vec<f64>,
}

impl<'a> Dynamics<'a> {
    /// Creates the right-hand side of a system, with `parameters` in the order of the model file.
    ///
    /// # Errors
    /// [`SimError::Length`] for a wrong number of parameters; [`SimError::NotFinite`] if a parameter is not
    /// finite.
    pub fn new(system: &'a dyn System<f64>, parameters: &[f64]) -> Result<Self, SimError> {
        check_dynamics_length("parameters", system.lengths().parameters, parameters)?;
        if let Some(i) = parameters.iter().position(|p| !p.is_finite()) {
            return Err(SimError::NotFinite { what: format!("parameter {i}") });
        }
        let order = system.lengths().unknowns();
        Ok(Self {
            system,
            parameters: parameters.to_vec(),
            label: String::new(),
            matrix: vec![0.0; order * order],
            unknowns: vec![0.0; order],
        })
    }

    /// Sets the name of the equations in messages, for instance "disk, kane".
    #[must_use]
    pub fn with_label(mut self, label: impl Into<String>) -> Self {
        self.label = label.into();
        self
    }

    /// Equations of motion that this right-hand side evaluates.
    #[must_use]
    pub fn system(&self) -> &'a dyn System<f64> {
        self.system
    }

    /// Values of the parameters, in the order of the model file.
    #[must_use]
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// Number of components of the state: coordinates and motion variables.
    #[must_use]
    pub fn state_length(&self) -> usize {
        self.system.lengths().state()
    }

    /// Joins generalized coordinates `q` and motion variables `v` to a state y = (q, v).
    ///
    /// # Errors
    /// [`SimError::Length`] if the length of `q` or `v` is not that of the system.
    pub fn state(&self, q: &[f64], v: &[f64]) -> Result<Vec<f64>, SimError> {
        check_dynamics_length("coordinates", self.system.lengths().coordinates, q)?;
        check_dynamics_length("motion variables", self.system.lengths().variables, v)?;
        Ok([q, v].concat())
    }

    /// Splits a state y into generalized coordinates q and motion variables v. If y is too short, q gets its entries
    /// first.
    #[must_use]
    pub fn split<'y>(&self, y: &'y [f64]) -> (&'y [f64], &'y [f64]) {
        y.split_at(self.system.lengths().coordinates.min(y.len()))
    }

    /// Solves the equations of motion A x = b at (q, v) for the unknowns x: the accelerations v̇, then the
    /// reactions.
    ///
    /// # Errors
    /// [`Failure`] with the code `singular` if A is exactly singular or x overflows; `not-finite` if A or b
    /// is not finite, with the entry; `length` if q or v has the wrong length.
    pub fn unknowns(&mut self, q: &[f64], v: &[f64]) -> Result<&[f64], Failure> {
        self.check_lengths(q, v)?;
        let (system, p, shape) = (self.system, self.parameters.as_slice(), self.shape());
        system.linear_system(p, q, v, &mut self.matrix, &mut self.unknowns);
        match linear::solve_linear_system(&self.matrix, &mut self.unknowns, shape) {
            Ok(()) => Ok(&self.unknowns),
            Err(why) => Err(self.linear_system_failure(why)),
        }
    }

    /// Reciprocal condition number, between 0 and 1, of the matrix A(q, v) of the equations of motion, see
    /// [`linear::reciprocal_condition`]. It is 0 if A is singular, or if `q` or `v` does not have the
    /// system's length.
    pub fn reciprocal_condition(&mut self, q: &[f64], v: &[f64]) -> f64 {
        if self.check_lengths(q, v).is_err() {
            return 0.0;
        }
        self.system.mass_matrix(&self.parameters, q, v, &mut self.matrix);
        linear::reciprocal_condition(&self.matrix, self.system.lengths().unknowns())
    }

    /// Determinant of the matrix A(q, v) of the equations of motion. NaN if A is not finite, or if `q` or `v` does not
    /// have the system's length.
    pub fn determinant(&mut self, q: &[f64], v: &[f64]) -> f64 {
        if self.check_lengths(q, v).is_err() {
            return f64::NAN;
        }
        self.system.mass_matrix(&self.parameters, q, v, &mut self.matrix);
        linear::matrix_determinant(&self.matrix, self.system.lengths().unknowns())
    }

    /// Total energy T + V of the system at (q, v), J. NaN if `q` or `v` does not have the system's length.
    #[must_use]
    pub fn energy(&self, q: &[f64], v: &[f64]) -> f64 {
        if self.check_lengths(q, v).is_err() {
            return f64::NAN;
        }
        self.system.kinetic_energy(&self.parameters, q, v) + self.system.potential_energy(&self.parameters, q)
    }

    /// Largest drift |E(t) − E(t0) − W(t)| of the energy E over the samples of a solution and its end, J. W is the work
    /// that is recorded in the solution, and E(t0) the energy of the first sample. NaN if an energy is NaN.
    #[must_use]
    pub fn energy_drift(&self, solution: &Solution) -> f64 {
        let energy = |y: &Vec<f64>| {
            let (q, v) = self.split(y);
            self.energy(q, v)
        };
        solution.energy_drift(solution.y.iter().map(energy), energy(&solution.y_end))
    }

    /// Kind of the matrix of the equations of motion: symmetric or general.
    fn shape(&self) -> MatrixKind {
        if self.system.symmetric() { MatrixKind::Symmetric } else { MatrixKind::General }
    }

    /// Refuses coordinates `q` or motion variables `v` whose length is not that of the system.
    fn check_lengths(&self, q: &[f64], v: &[f64]) -> Result<(), Failure> {
        if q.len() == self.system.lengths().coordinates && v.len() == self.system.lengths().variables {
            Ok(())
        } else {
            Err(wrong_dynamics_length())
        }
    }

    /// Creates the failure of a linear system that has no solution. It names the entry that is not finite, if there is
    /// one. The matrix and the forcing must still be unchanged.
    fn linear_system_failure(&self, why: UnsolvableSystem) -> Failure {
        let matrix = match self.shape() {
            MatrixKind::Symmetric => "mass matrix",
            MatrixKind::General => "matrix of accelerations and reactions",
        };
        let order = self.system.lengths().unknowns();
        let label = if self.label.is_empty() { String::new() } else { format!("{}: ", self.label) };
        let odd = |values: &[f64]| values.iter().position(|x| !x.is_finite());
        let (code, fact) = match (why, odd(&self.matrix), odd(&self.unknowns)) {
            (UnsolvableSystem::Singular, ..) | (UnsolvableSystem::NotFinite, None, None) => {
                ("singular", format!("{matrix} of order {order} is singular"))
            }
            (UnsolvableSystem::NotFinite, Some(i), _) => {
                let (row, column) = (i / order + 1, i % order + 1);
                ("not-finite", format!("entry {row}, {column} of the {matrix} of order {order} is not finite"))
            }
            (UnsolvableSystem::NotFinite, None, Some(i)) => {
                ("not-finite", format!("entry {} of {order} of the forcing is not finite", i + 1))
            }
        };
        Failure { code, message: format!("{label}{fact}") }
    }
}

/// Right-hand side y' = (q̇, v̇) with accelerations from the linear system at each state; the time is not used.
///
/// The Jacobian is available if the system also has accelerations that were solved for when its code was generated. It
/// is the Jacobian of these.
impl RightHandSide<f64> for Dynamics<'_> {
    fn rhs(&mut self, _t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
        let (n, speeds) = (self.system.lengths().coordinates, self.system.lengths().variables);
        let (q, v) = self.split(y);
        self.check_lengths(q, v)?;
        if dydt.len() != y.len() {
            return Err(wrong_dynamics_length());
        }
        let (q_dot, v_dot) = dydt.split_at_mut(n);
        self.system.coordinate_rates(&self.parameters, q, v, q_dot);
        v_dot.copy_from_slice(&self.unknowns(q, v)?[..speeds]);
        Ok(())
    }

    fn jacobian(&mut self, _t: f64, y: &[f64], out: &mut [f64]) -> Option<Result<(), Failure>> {
        let (q, v) = self.split(y);
        if let Err(failure) = self.check_lengths(q, v) {
            return Some(Err(failure));
        }
        self.system.has_accelerations().then(|| {
            self.system.jacobian(&self.parameters, q, v, out);
            Ok(())
        })
    }

    fn divisor_count(&self) -> usize {
        self.system.divisor_count()
    }

    fn divisors(&mut self, _t: f64, y: &[f64], out: &mut [f64]) {
        let (q, v) = y.split_at(self.system.lengths().coordinates);
        self.system.divisors(&self.parameters, q, v, out);
    }

    fn divisor_name(&self, at: usize) -> String {
        self.system.divisor_name(at).to_owned()
    }

    fn constraint_count(&self) -> usize {
        self.system.constraint_count()
    }

    fn constraints(&mut self, _t: f64, y: &[f64], values: &mut [f64], slopes: &mut [f64]) {
        crate::right_hand_side::system_constraints(self.system, &self.parameters, y, values, slopes);
    }

    fn inertia(&mut self, _t: f64, y: &[f64], out: &mut Vec<f64>) -> bool {
        crate::right_hand_side::system_inertia(self.system, &self.parameters, y, &mut self.matrix, out)
    }
}

/// Creates the failure for a state whose length does not fit the equations.
fn wrong_dynamics_length() -> Failure {
    let message = "the state does not have the length of the equations".to_owned();
    Failure { code: "length", message }
}

/// Refuses a list whose length differs from `expected`. `what` names the list in the error.
fn check_dynamics_length(what: &'static str, expected: usize, found: &[f64]) -> Result<(), SimError> {
    let found = found.len();
    if found == expected { Ok(()) } else { Err(SimError::Length { what, expected, found }) }
}
