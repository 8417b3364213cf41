//! Step of an explicit Runge–Kutta method, and its transpose for the adjoint of a run.
//!
//! The step is kᵢ = f(t + cᵢ h, Yᵢ) with Yᵢ = y + h Σⱼ aᵢⱼ kⱼ, and y⁺ = y + h Σᵢ bᵢ kᵢ. The transposed step starts from
//! weights λ of y⁺. They give the weights of kᵢ, from the last stage to the first: wᵢ = h bᵢ λ + h Σⱼ aⱼᵢ zⱼ with zᵢ =
//! f_yᵀ wᵢ. The weights of y are λ + Σᵢ zᵢ, and each f_pᵀ wᵢ is added to the weights of the parameters. E. Hairer, C.
//! Lubich & G. Wanner, *Geometric Numerical Integration*, 2nd edition (2006), §VI.1: the transpose of a method is that
//! of its linear part.

use crate::error::Failure;
use crate::events::corners::BetweenCorners;
use crate::methods::dormand_prince::DORMAND_PRINCE_54;
use crate::methods::dormand_prince_853::{DORMAND_PRINCE_853, Row};
use crate::methods::tableau::Coefficients;
use crate::right_hand_side::RightHandSide;
use crate::transposed_right_hand_side::TransposedRightHandSide;
use tripos_traits::Method;

/// Nonzero coefficients aᵢⱼ of a row of a Runge–Kutta method, each with the index j of its stage, from 0.
type NonzeroCoefficients = Vec<(usize, f64)>;

/// Coefficients of an explicit Runge–Kutta method; coefficients that are 0 are left out.
pub(super) struct RungeKuttaCoefficients {
    /// Times cᵢ of the Runge–Kutta stages, as fractions of the step.
    c: Vec<f64>,
    /// Runge–Kutta coefficients aᵢⱼ that are not 0, a row for each stage i.
    a: Vec<NonzeroCoefficients>,
    /// Runge–Kutta weights bᵢ of the stages in the new state, without those that are 0.
    b: NonzeroCoefficients,
}

impl RungeKuttaCoefficients {
    /// Coefficients of a method; `None` if it is no explicit Runge–Kutta method.
    pub(super) fn of(method: Method) -> Option<Self> {
        match method {
            Method::Rk4 => Some(Self {
                c: vec![0.0, 0.5, 0.5, 1.0],
                a: vec![Vec::new(), vec![(0, 0.5)], vec![(1, 0.5)], vec![(2, 1.0)]],
                b: vec![(0, 1.0 / 6.0), (1, 1.0 / 3.0), (2, 1.0 / 3.0), (3, 1.0 / 6.0)],
            }),
            Method::Ode45 | Method::Dopri5 => {
                let Coefficients { a, c, .. } = Coefficients::<f64, 7>::new(&DORMAND_PRINCE_54);
                let row = |row: &[f64; 7]| row.iter().copied().enumerate().filter(|(_, a)| *a != 0.0).collect();
                Some(Self { c: c[..6].to_vec(), a: a[..6].iter().map(row).collect(), b: row(&a[6]) })
            }
            Method::Dop853 => {
                let row = |row: &Row| row.iter().map(|(stage, a)| (*stage, a.value)).collect();
                let (a, b) = DORMAND_PRINCE_853.a.split_at(12);
                Some(Self { c: DORMAND_PRINCE_853.c[..12].to_vec(), a: a.iter().map(row).collect(), b: row(&b[0]) })
            }
            Method::Gauss6 | Method::Radau5 | Method::Taylor => None,
        }
    }
}

/// Stages of the last step of an explicit Runge–Kutta method, with the working space for the transposed step.
pub(super) struct Stages {
    /// States Yᵢ at which the stages of the last step were evaluated.
    points: Vec<Vec<f64>>,
    /// Derivatives kᵢ = f(tᵢ, Yᵢ) of the stages of the last step.
    rates: Vec<Vec<f64>>,
    /// Weights wᵢ of the derivatives kᵢ in the transposed step.
    weights: Vec<Vec<f64>>,
    /// Working space for the product zᵢ = f_yᵀ wᵢ of the transposed Jacobian with the weights of a stage.
    share: Vec<f64>,
}

impl Stages {
    /// Creates the space for the stages of a method, for states of `n` components.
    pub(super) fn new(rows: &RungeKuttaCoefficients, n: usize) -> Self {
        let zeros = || vec![vec![0.0; n]; rows.a.len()];
        Self { points: zeros(), rates: zeros(), weights: zeros(), share: vec![0.0; n] }
    }

    /// Takes the step from time `t` to `t_new`, s, and replaces the state `y` by the state at its end.
    /// Error if f has no value.
    pub(super) fn step<R: RightHandSide<f64>>(
        &mut self,
        rows: &RungeKuttaCoefficients,
        rhs: &mut R,
        t: f64,
        t_new: f64,
        y: &mut [f64],
    ) -> Result<(), Failure> {
        let h = t_new - t;
        for (stage, row) in rows.a.iter().enumerate() {
            let point = &mut self.points[stage];
            point.copy_from_slice(y);
            add_stages(point, h, row, &self.rates);
            rhs.rhs(stage_time(t, t_new, rows.c[stage]), point, &mut self.rates[stage])?;
        }
        add_stages(y, h, &rows.b, &self.rates);
        Ok(())
    }

    /// Replaces the weights `state` of the last step's end state with the weights of its start state. Adds the step's
    /// part to the weights `parameters`. `t` and `t_new` are the ends of the step, s. Error if the Jacobians have no
    /// value.
    pub(super) fn transposed_step<R: TransposedRightHandSide>(
        &mut self,
        rows: &RungeKuttaCoefficients,
        rhs: &mut BetweenCorners<'_, R, f64>,
        t: f64,
        t_new: f64,
        state: &mut [f64],
        parameters: &mut [f64],
    ) -> Result<(), Failure> {
        let h = t_new - t;
        for weights in &mut self.weights {
            weights.fill(0.0);
        }
        for (stage, b) in &rows.b {
            self.weights[*stage].iter_mut().zip(&*state).for_each(|(w, x)| *w = h * b * x);
        }
        for (stage, row) in rows.a.iter().enumerate().rev() {
            self.share.fill(0.0);
            let when = stage_time(t, t_new, rows.c[stage]);
            rhs.pull(when, &self.points[stage], &self.weights[stage], (&mut self.share, parameters))?;
            for (earlier, a) in row {
                self.weights[*earlier].iter_mut().zip(&self.share).for_each(|(w, z)| *w += h * a * z);
            }
            state.iter_mut().zip(&self.share).for_each(|(x, z)| *x += z);
        }
        Ok(())
    }
}

/// Time of a stage, s, at the fraction `part` of the step from `t` to `t_new`; exactly `t_new` for the
/// fraction 1.
fn stage_time(t: f64, t_new: f64, part: f64) -> f64 {
    if crate::rounding::exactly_equal(part, 1.0) { t_new } else { t + part * (t_new - t) }
}

/// Adds h Σⱼ aⱼ kⱼ to the state `y`. `row` has the coefficients aⱼ, and `rates` the derivatives kⱼ of the stages.
fn add_stages(y: &mut [f64], h: f64, row: &NonzeroCoefficients, rates: &[Vec<f64>]) {
    for (i, y) in y.iter_mut().enumerate() {
        let sum: f64 = row.iter().map(|(stage, a)| a * rates[*stage][i]).sum();
        *y += h * sum;
    }
}
