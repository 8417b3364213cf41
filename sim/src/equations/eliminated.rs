//! Right-hand side of equations whose accelerations were solved for (eliminated) when their code was
//! generated.

use tripos_traits::{Real, System};

use crate::error::Failure;
use crate::right_hand_side::RightHandSide;

/// Right-hand side y' = (q̇, v̇) of equations whose accelerations v̇ were solved for when their code was generated. It
/// works for any scalar type, calls [`System::derivative`] and has an exact Jacobian.
///
/// The state is y = (q, v), as for [`crate::Dynamics`], which solves the linear system at each state instead.
pub struct EliminatedDynamics<'a, S: Real = f64> {
    /// Equations of motion whose accelerations were solved for when their code was generated.
    system: &'a dyn System<S>,
    /// Values of the parameters, in the order of the model file.
    parameters: Vec<S>,
    /// Working space for the Taylor coefficients.
    work: Vec<S>,
    /// Working space for the matrix of the linear system, from which the mass matrix is read.
    matrix: Vec<S>,
}

impl<'a, S: Real> EliminatedDynamics<'a, S> {
    /// Creates the right-hand side of a system, with `parameters` in the order of the model file. `None` if the
    /// accelerations were not solved for in advance, or if the number of parameters is wrong.
    #[must_use]
    pub fn new(system: &'a dyn System<S>, parameters: &[S]) -> Option<Self> {
        let fits = parameters.len() == system.lengths().parameters;
        (system.has_accelerations() && fits).then(|| Self {
            system,
            parameters: parameters.to_vec(),
            work: Vec::new(),
            matrix: Vec::new(),
        })
    }
}

impl<S: Real> RightHandSide<S> for EliminatedDynamics<'_, S> {
    #[inline]
    fn rhs(&mut self, _t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure> {
        let n = self.system.lengths().coordinates;
        let ((q, v), (q_dot, v_dot)) = (y.split_at(n), dydt.split_at_mut(n));
        self.system.derivative(&self.parameters, q, v, q_dot, v_dot);
        Ok(())
    }

    fn jacobian(&mut self, _t: f64, y: &[S], out: &mut [S]) -> Option<Result<(), Failure>> {
        let (q, v) = y.split_at(self.system.lengths().coordinates);
        self.system.jacobian(&self.parameters, q, v, out);
        Some(Ok(()))
    }

    #[inline]
    fn taylor(&mut self, _t: f64, order: usize, x: &mut [S]) -> Option<Result<(), Failure>> {
        let room = self.system.taylor_work(order);
        if self.work.len() < room {
            self.work.resize(room, S::from_f64(0.0));
        }
        self.system.has_taylor().then(|| {
            self.system.taylor(&self.parameters, order, x, &mut self.work);
            Ok(())
        })
    }

    fn divisor_count(&self) -> usize {
        self.system.divisor_count()
    }

    fn divisors(&mut self, _t: f64, y: &[S], out: &mut [S]) {
        let (q, v) = y.split_at(self.system.lengths().coordinates);
        self.system.divisors(&self.parameters, q, v, out);
    }

    fn divisor_name(&self, at: usize) -> String {
        self.system.divisor_name(at).to_owned()
    }

    fn constraint_count(&self) -> usize {
        self.system.constraint_count()
    }

    fn constraints(&mut self, _t: f64, y: &[S], values: &mut [S], slopes: &mut [S]) {
        crate::right_hand_side::system_constraints(self.system, &self.parameters, y, values, slopes);
    }

    fn inertia(&mut self, _t: f64, y: &[S], out: &mut Vec<f64>) -> bool {
        crate::right_hand_side::system_inertia(self.system, &self.parameters, y, &mut self.matrix, out)
    }
}
