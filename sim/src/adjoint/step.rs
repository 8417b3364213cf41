//! Step of an explicit Runge–Kutta method, and its transpose.
//!
//! The step is kᵢ = f(t + cᵢ h, Yᵢ) with Yᵢ = y + h Σⱼ aᵢⱼ kⱼ, and y⁺ = y + h Σᵢ bᵢ kᵢ. Weights λ of y⁺ give those of
//! kᵢ, from the last stage to the first: wᵢ = h bᵢ λ + h Σⱼ aⱼᵢ zⱼ with zᵢ = f_yᵀ wᵢ. The weights of y are λ + Σᵢ zᵢ;
//! f_pᵀ wᵢ adds to those of the parameters. E. Hairer, C. Lubich & G. Wanner, *Geometric Numerical Integration*, 2nd
//! edition (2006), §VI.1: the transpose of a method is that of its linear part.

use crate::error::Failure;
use crate::events::corners::Between;
use crate::methods::dormand_prince::DORMAND_PRINCE_54;
use crate::methods::dormand_prince_853::{DORMAND_PRINCE_853, Row};
use crate::methods::tableau::Coefficients;
use crate::rhs::{RightHandSide, Transposed};
use tripos_traits::Method;

/// Stages that a row of a method uses, counted from 0, each with its coefficient.
type Entries = Vec<(usize, f64)>;

/// Coefficients of an explicit Runge–Kutta method.
pub(super) struct Rows {
    /// Nodes cᵢ of the stages.
    c: Vec<f64>,
    /// Coefficients aᵢⱼ that are not 0, a row for each stage.
    a: Vec<Entries>,
    /// Coefficients bᵢ that are not 0.
    b: Entries,
}

impl Rows {
    /// Coefficients of a method; `None` if the method is no explicit Runge–Kutta method.
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

/// Stages of the last step, and the space for its transpose.
pub(super) struct Stages {
    points: Vec<Vec<f64>>,
    rates: Vec<Vec<f64>>,
    weights: Vec<Vec<f64>>,
    share: Vec<f64>,
}

impl Stages {
    /// Makes space for a method and a state of `n` components.
    pub(super) fn new(rows: &Rows, n: usize) -> Self {
        let zeros = || vec![vec![0.0; n]; rows.a.len()];
        Self { points: zeros(), rates: zeros(), weights: zeros(), share: vec![0.0; n] }
    }

    /// Takes the step from `y` at `t` to `t_new`, in s, and writes the new state to `y`.
    pub(super) fn step<R: RightHandSide<f64>>(
        &mut self,
        rows: &Rows,
        rhs: &mut R,
        t: f64,
        t_new: f64,
        y: &mut [f64],
    ) -> Result<(), Failure> {
        let h = t_new - t;
        for (stage, row) in rows.a.iter().enumerate() {
            let point = &mut self.points[stage];
            point.copy_from_slice(y);
            add(point, h, row, &self.rates);
            rhs.rhs(at(t, t_new, rows.c[stage]), point, &mut self.rates[stage])?;
        }
        add(y, h, &rows.b, &self.rates);
        Ok(())
    }

    /// Turns the weights of the end of the last step into those of its start, in place, and adds to the weights of the
    /// parameters.
    pub(super) fn back<R: Transposed>(
        &mut self,
        rows: &Rows,
        rhs: &mut Between<'_, R, f64>,
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
            let when = at(t, t_new, rows.c[stage]);
            rhs.pull(when, &self.points[stage], &self.weights[stage], (&mut self.share, parameters))?;
            for (earlier, a) in row {
                self.weights[*earlier].iter_mut().zip(&self.share).for_each(|(w, z)| *w += h * a * z);
            }
            state.iter_mut().zip(&self.share).for_each(|(x, z)| *x += z);
        }
        Ok(())
    }
}

/// Instant of a stage, s: at the fraction `part` of a step. The end of the step is met exactly.
fn at(t: f64, t_new: f64, part: f64) -> f64 {
    if crate::stepper::same(part, 1.0) { t_new } else { t + part * (t_new - t) }
}

/// Writes y + h Σⱼ aⱼ kⱼ to `y`.
fn add(y: &mut [f64], h: f64, row: &Entries, rates: &[Vec<f64>]) {
    for (i, y) in y.iter_mut().enumerate() {
        let sum: f64 = row.iter().map(|(stage, a)| a * rates[*stage][i]).sum();
        *y += h * sum;
    }
}
