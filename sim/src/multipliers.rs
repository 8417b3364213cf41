//! Equations in all rates with the multipliers of their constraints, E q̈ − Aᵀλ = f beside A q̈ = γ, solved at each state whatever the
//! rank of A.
//!
//! With E = L Lᵀ and z = Lᵀ q̈ the motion is what the forces alone would do, L⁻¹ f, without its part along the columns of L⁻¹ Aᵀ, which the
//! constraints decide (F. E. Udwadia & R. E. Kalaba, *Analytical Dynamics* (1996), §3.3). No independent speeds are chosen, so that there
//! is no place where a choice fails; rows that follow from others, everywhere or in a singular pose, are left out. In such a pose the motion
//! goes on by its inertia; nothing is divided by what vanishes there.
//!
//! Accelerations are those at the nearest state on the constraints, in the metric of E. Stages of a step are off the constraints by errors of low order, and next to
//! a singular pose these would be divided by what vanishes there; on the constraints the accelerations of a regular motion are bounded up to the
//! pose itself, so that whole steps lead across it.

use nalgebra::{DMatrix, DVector};
use tripos_traits::{Lengths, System};

use crate::error::Failure;
use crate::metric::{Conditions, DEPENDENT, Metric, correction};
use crate::rhs::RightHandSide;

/// Newton iterations that bring a stage onto the constraints, and units in the last place that count as there.
const ITERATIONS: usize = 6;
const ROUNDING: f64 = 4.0;

/// The part of the largest [`Standing::constraints`] below which no step ends.
const AVOIDED: f64 = 0.003;

/// y' = [q̇; q̈] of equations in all rates with multipliers, as a right-hand side.
#[derive(Clone)]
pub struct Multipliers<'a> {
    system: &'a dyn System<f64>,
    parameters: Vec<f64>,
    matrix: Vec<f64>,
    forcing: Vec<f64>,
    /// The least and the largest [`Standing::constraints`] at which accelerations were asked for.
    nearest: f64,
    farthest: f64,
    /// The largest length of each row of A so far.
    sizes: Vec<f64>,
    /// The coordinate that is the time.
    clock: Option<usize>,
}

/// How far a choice of independent speeds is from failing at a state, and the constraints from following from one another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing {
    /// How well the speeds tell the motions that the constraints leave from one another, over how well they do without constraints: from
    /// 0, where the choice fails, to 1.
    pub speeds: f64,
    /// What is left of the constraint that is nearest to following from others, over the largest length that its row had so far: 0 in a
    /// singular pose, where rows may depend on one another or vanish.
    pub constraints: f64,
}

impl<'a> Multipliers<'a> {
    /// These equations with parameters in the order of the model file, and the coordinate that is the time, if one is; `None` if they are not
    /// in all rates with multipliers, or the parameters are not theirs.
    #[must_use]
    pub fn new(system: &'a dyn System<f64>, parameters: &[f64], clock: Option<usize>) -> Option<Self> {
        let Lengths { coordinates, variables, reactions, .. } = system.lengths();
        let fits = parameters.len() == system.lengths().parameters && variables == coordinates && reactions > 0;
        let order = coordinates + reactions;
        fits.then(|| Self {
            system,
            parameters: parameters.to_vec(),
            matrix: vec![0.0; order * order],
            forcing: vec![0.0; order],
            nearest: 1.0,
            farthest: 0.0,
            sizes: vec![0.0; reactions],
            clock,
        })
    }

    /// These equations, which know how far from singular poses they have been, for a run of their own.
    #[must_use]
    pub fn again(&self) -> Self {
        Self { nearest: 1.0, ..self.clone() }
    }

    /// What is left of the constraint that is nearest to following from others: [`Standing::constraints`].
    fn near(&mut self, conditions: &Conditions) -> f64 {
        for (most, size) in self.sizes.iter_mut().zip(&conditions.sizes) {
            *most = most.max(*size);
        }
        let least = conditions.left.iter().zip(&self.sizes).map(|(left, size)| left / size).fold(1.0, f64::min);
        (self.nearest, self.farthest) = (self.nearest.min(least), self.farthest.max(least));
        least
    }

    /// The least [`Standing::constraints`] of all states so far.
    #[must_use]
    pub fn nearest(&self) -> f64 {
        self.nearest
    }

    /// E and A at a state.
    fn matrices(&mut self, q: &[f64], v: &[f64]) -> (DMatrix<f64>, DMatrix<f64>) {
        let (n, order) = (q.len(), self.forcing.len());
        self.system.mass_matrix(&self.parameters, q, v, &mut self.matrix);
        let all = DMatrix::from_row_slice(order, order, &self.matrix);
        (all.view((0, 0), (n, n)).into_owned(), all.view((n, 0), (order - n, n)).into_owned())
    }

    /// The nearest state on the constraints; the state itself where the search for it fails.
    fn placed(&self, y: &[f64]) -> Vec<f64> {
        let (system, p, count) = (self.system, self.parameters.as_slice(), self.system.constraint_count());
        let (mut values, mut slopes, mut inertia) = (vec![0.0; count], vec![0.0; count * y.len()], Vec::new());
        let mut placed = y.to_vec();
        for _ in 0..ITERATIONS {
            crate::rhs::constraints(system, p, &placed, &mut values, &mut slopes);
            crate::rhs::inertia(system, p, &placed, &mut inertia);
            if !values.iter().chain(&slopes).chain(&inertia).all(|x| x.is_finite()) {
                return y.to_vec();
            }
            let gradients = DMatrix::from_row_slice(count, y.len(), &slopes);
            let Some(step) = correction(&inertia, &gradients, &values, self.clock) else { return y.to_vec() };
            let size = placed.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            for (x, step) in placed.iter_mut().zip(&step) {
                *x -= step;
            }
            if step.iter().all(|step| step.abs() <= ROUNDING * f64::EPSILON * size) {
                break;
            }
        }
        placed
    }

    /// q̈ at a state.
    fn accelerations(&mut self, q: &[f64], v: &[f64]) -> Result<DVector<f64>, Failure> {
        let n = q.len();
        let (inertia, rows) = self.matrices(q, v);
        self.system.forcing(&self.parameters, q, v, &mut self.forcing);
        if !self.matrix.iter().chain(&self.forcing).all(|x| x.is_finite()) {
            let message = "an entry of the equations with multipliers is not finite".to_owned();
            return Err(Failure { code: "not-finite", message });
        }
        let Some(metric) = Metric::of_inertia(inertia, &rows) else {
            let message = "something that the constraints let move has no inertia".to_owned();
            return Err(Failure { code: "singular", message });
        };
        let conditions = Conditions::new(&metric, &rows, DEPENDENT);
        self.near(&conditions);
        let forces = metric.raise(DMatrix::from_column_slice(n, 1, &self.forcing[..n]));
        let z = conditions.free(forces).column(0) + conditions.least(&self.forcing[n..]);
        Ok(metric.vector(z))
    }

    /// How far the generalized speeds of the model are from failing to determine the motion at a state, and the constraints
    /// from depending on one another; nothing where the equations have no value.
    pub fn standing(&mut self, y: &[f64]) -> Option<Standing> {
        let Lengths { coordinates: n, speeds: p, .. } = self.system.lengths();
        let (q, v) = y.split_at(n);
        let (inertia, rows) = self.matrices(q, v);
        let finite = self.matrix.iter().all(|x| x.is_finite());
        let metric = Metric::of_inertia(inertia, &rows).filter(|_| finite)?;
        let constraints = Conditions::new(&metric, &rows, DEPENDENT);
        let mut forms = metric.raise(self.speeds(q, p).transpose());
        for mut column in forms.column_iter_mut() {
            column.normalize_mut();
        }
        let told = |forms: DMatrix<f64>| if p == 0 { 1.0 } else { forms.singular_values().min() };
        let without = told(forms.clone());
        let speeds = told(constraints.free(forms)) / without;
        speeds.is_finite().then_some(Standing { speeds, constraints: self.near(&constraints) })
    }

    /// J of u = J q̇ + d, row by row, by differences along the axes: u is linear in q̇.
    fn speeds(&self, q: &[f64], p: usize) -> DMatrix<f64> {
        let n = q.len();
        let at = |v: &[f64]| {
            let mut u = vec![0.0; p];
            self.system.generalized_speeds(&self.parameters, q, v, &mut u);
            DVector::from_vec(u)
        };
        let rest = at(&vec![0.0; n]);
        let mut slopes = DMatrix::zeros(p, n);
        let mut axis = vec![0.0; n];
        for (i, mut column) in slopes.column_iter_mut().enumerate() {
            axis[i] = 1.0;
            column.copy_from(&(at(&axis) - &rest));
            axis[i] = 0.0;
        }
        slopes
    }
}

impl RightHandSide<f64> for Multipliers<'_> {
    fn rhs(&mut self, _t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
        let n = self.system.lengths().coordinates;
        let placed = self.placed(y);
        let ((q, v), (q_dot, v_dot)) = (placed.split_at(n), dydt.split_at_mut(n));
        self.system.coordinate_rates(&self.parameters, q, v, q_dot);
        v_dot.copy_from_slice(self.accelerations(q, v)?.as_slice());
        Ok(())
    }

    fn constraint_count(&self) -> usize {
        self.system.constraint_count()
    }

    fn constraints(&mut self, _t: f64, y: &[f64], values: &mut [f64], slopes: &mut [f64]) {
        crate::rhs::constraints(self.system, &self.parameters, y, values, slopes);
    }

    /// Next to a singular pose rounding is divided by the square of what vanishes there.
    fn avoids(&mut self, _t: f64, y: &[f64]) -> bool {
        self.standing(y).is_some_and(|standing| standing.constraints < AVOIDED * self.farthest)
    }

    fn inertia(&mut self, _t: f64, y: &[f64], out: &mut Vec<f64>) -> bool {
        crate::rhs::inertia(self.system, &self.parameters, y, out)
    }
}
