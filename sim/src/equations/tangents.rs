//! Right-hand side of equations of motion whose numbers carry derivatives along several directions (dual numbers).
//!
//! Invariant: values have the same bits as those of [`crate::EliminatedDynamics`], so that a run takes the same steps.
//! A single call of the generated equations gives the derivatives of the rates f(y, p), which are f_y s + f_p p′. Here
//! s are the derivatives of the state, and p′ those of the parameters.

use tripos_traits::{Flow, Scalar, Series, System, Tangent};

use crate::error::Failure;
use crate::right_hand_side::RightHandSide;

/// Right-hand side y' = (q̇, v̇) and constraints of a model, in numbers that carry derivatives along K directions. A
/// run with it gives sensitivities.
pub struct DynamicsWithTangents<'a, const K: usize> {
    /// Equations in `f64`, for values without derivatives: divisors, slopes of constraints and the Jacobian.
    system: &'a dyn System<f64>,
    /// Rates and constraints of the equations in numbers with derivatives.
    flow: &'a dyn Flow<Tangent<K>>,
    /// Taylor coefficients in numbers with derivatives; `None` if the equations have none.
    series: Option<&'a dyn Series<Tangent<K>>>,
    /// Parameters with their derivatives, in the order of the model file.
    parameters: Vec<Tangent<K>>,
    /// Values of the parameters, without derivatives.
    values: Vec<f64>,
    /// Working space for the Taylor coefficients.
    work: Vec<Tangent<K>>,
    /// Working space for the values of a state, without derivatives.
    state: Vec<f64>,
    /// Working space for results in `f64`, without derivatives.
    out: Vec<f64>,
}

impl<'a, const K: usize> DynamicsWithTangents<'a, K> {
    /// Creates the right-hand side from the equations and from `parameters` with their derivatives, in the
    /// order of the model file. `series` gives Taylor coefficients, if known.
    ///
    /// `None` if the accelerations were not solved for in advance, or if the number of parameters is wrong.
    #[must_use]
    pub fn new(
        system: &'a dyn System<f64>,
        flow: &'a dyn Flow<Tangent<K>>,
        series: Option<&'a dyn Series<Tangent<K>>>,
        parameters: &[Tangent<K>],
    ) -> Option<Self> {
        let fits = parameters.len() == system.lengths().parameters;
        let values = parameters.iter().map(|p| p.value).collect();
        let (work, state, out) = (Vec::new(), Vec::new(), Vec::new());
        (system.has_accelerations() && fits).then(|| Self {
            system,
            flow,
            series,
            parameters: parameters.to_vec(),
            values,
            work,
            state,
            out,
        })
    }

    /// Evaluates a function `of` of the state in `f64`, and writes the result to `out` with derivatives of 0.
    fn without_tangents(
        &mut self,
        y: &[Tangent<K>],
        out: &mut [Tangent<K>],
        of: impl FnOnce(&dyn System<f64>, &[f64], &[f64], &[f64], &mut [f64]),
    ) {
        self.state.clear();
        self.state.extend(y.iter().map(|y| y.value));
        self.out.clear();
        self.out.resize(out.len(), 0.0);
        let (q, v) = self.state.split_at(self.system.lengths().coordinates);
        of(self.system, &self.values, q, v, &mut self.out);
        for (out, value) in out.iter_mut().zip(&self.out) {
            *out = Tangent::constant(*value);
        }
    }
}

impl<const K: usize> RightHandSide<Tangent<K>> for DynamicsWithTangents<'_, K> {
    #[inline]
    fn rhs(&mut self, _t: f64, y: &[Tangent<K>], dydt: &mut [Tangent<K>]) -> Result<(), Failure> {
        let n = self.system.lengths().coordinates;
        let ((q, v), (q_dot, v_dot)) = (y.split_at(n), dydt.split_at_mut(n));
        self.flow.rates(&self.parameters, q, v, q_dot, v_dot);
        Ok(())
    }

    /// Writes the Jacobian with derivatives of 0. Newton iterations with it find the derivatives of a
    /// solution as they find its value.
    fn jacobian(&mut self, _t: f64, y: &[Tangent<K>], out: &mut [Tangent<K>]) -> Option<Result<(), Failure>> {
        self.without_tangents(y, out, |system, p, q, v, out| system.jacobian(p, q, v, out));
        Some(Ok(()))
    }

    #[inline]
    fn taylor(&mut self, _t: f64, order: usize, x: &mut [Tangent<K>]) -> Option<Result<(), Failure>> {
        let series = self.series.filter(|series| series.has_taylor())?;
        let room = series.taylor_work(order);
        if self.work.len() < room {
            self.work.resize(room, Tangent::from_f64(0.0));
        }
        series.taylor(&self.parameters, order, x, &mut self.work);
        Some(Ok(()))
    }

    fn divisor_count(&self) -> usize {
        self.system.divisor_count()
    }

    fn divisors(&mut self, _t: f64, y: &[Tangent<K>], out: &mut [Tangent<K>]) {
        self.without_tangents(y, out, |system, p, q, v, out| system.divisors(p, q, v, out));
    }

    fn divisor_name(&self, at: usize) -> String {
        self.system.divisor_name(at).to_owned()
    }

    fn constraint_count(&self) -> usize {
        self.system.constraint_count()
    }

    fn constraints(&mut self, _t: f64, y: &[Tangent<K>], values: &mut [Tangent<K>], slopes: &mut [Tangent<K>]) {
        let (q, v) = y.split_at(self.system.lengths().coordinates);
        self.flow.constraints(&self.parameters, q, v, values);
        self.without_tangents(y, slopes, |system, p, q, v, out| system.constraint_slopes(p, q, v, out));
    }

    fn inertia(&mut self, _t: f64, y: &[Tangent<K>], out: &mut Vec<f64>) -> bool {
        self.state.clear();
        self.state.extend(y.iter().map(|y| y.value));
        crate::right_hand_side::system_inertia(self.system, &self.values, &self.state, &mut self.out, out)
    }
}
