//! One step of an explicit Runge–Kutta pair.
//!
//! Invariant: `k[0]` is the derivative at (t, y); after a trial step `k[S-1]` is the one at its
//! end. Buffers are made once; a step allocates nothing. Absent on purpose: the choice of the step
//! size.

use crate::error::Failure;
use crate::stepper::{DenseStep, Stepper, Trouble, check_finite, same};
use crate::tableau::{Coefficients, Tableau};
use crate::tolerance::ErrorTest;

/// State of an explicit Runge–Kutta method between and inside steps.
pub(crate) struct ExplicitRungeKutta<const S: usize> {
    coefficients: Coefficients<S>,
    order: u32,
    t: f64,
    t_new: f64,
    y: Vec<f64>,
    y_new: Vec<f64>,
    k: [Vec<f64>; S],
    sum: Vec<f64>,
    evaluations: u64,
}

impl<const S: usize> ExplicitRungeKutta<S> {
    /// A method for `n` equations; [`Stepper::start`] must come first.
    pub(crate) fn new(tableau: &Tableau<S>, n: usize) -> Self {
        Self {
            coefficients: Coefficients::new(tableau),
            order: tableau.order,
            t: 0.0,
            t_new: 0.0,
            y: vec![0.0; n],
            y_new: vec![0.0; n],
            k: std::array::from_fn(|_| vec![0.0; n]),
            sum: vec![0.0; n],
            evaluations: 0,
        }
    }

    fn evaluate<F>(&mut self, rhs: &mut F, stage: usize, t: f64) -> Result<(), Trouble>
    where
        F: FnMut(f64, &[f64], &mut [f64]) -> Result<(), Failure>,
    {
        check_finite(&self.y_new)?;
        self.evaluations += 1;
        rhs(t, &self.y_new, &mut self.k[stage]).map_err(Trouble::Failed)?;
        check_finite(&self.k[stage])
    }
}

/// sum = Σⱼ weight(j) kⱼ.
fn combine(sum: &mut [f64], k: &[Vec<f64>], weight: impl Fn(usize) -> f64) {
    sum.fill(0.0);
    for (j, k_j) in k.iter().enumerate() {
        let w = weight(j);
        if w != 0.0 {
            for (s, k_ji) in sum.iter_mut().zip(k_j) {
                *s += w * k_ji;
            }
        }
    }
}

impl<const S: usize> DenseStep for ExplicitRungeKutta<S> {
    fn times(&self) -> (f64, f64) {
        (self.t, self.t_new)
    }

    fn interpolate(&self, theta: f64, out: &mut [f64]) {
        if theta == 0.0 {
            out.copy_from_slice(&self.y);
            return;
        }
        if same(theta, 1.0) {
            out.copy_from_slice(&self.y_new);
            return;
        }
        let h = self.t_new - self.t;
        combine(out, &self.k, |j| {
            // h (d_0 θ + d_1 θ² + d_2 θ³ + d_3 θ⁴)
            let d = &self.coefficients.dense[j];
            h * theta * (d[0] + theta * (d[1] + theta * (d[2] + theta * d[3])))
        });
        for (o, y) in out.iter_mut().zip(&self.y) {
            *o += y;
        }
    }
}

impl<const S: usize> Stepper for ExplicitRungeKutta<S> {
    fn start<F>(&mut self, rhs: &mut F, t: f64, y: &[f64]) -> Result<(), Trouble>
    where
        F: FnMut(f64, &[f64], &mut [f64]) -> Result<(), Failure>,
    {
        (self.t, self.t_new) = (t, t);
        self.y.copy_from_slice(y);
        self.y_new.copy_from_slice(y);
        self.evaluate(rhs, 0, t)
    }

    fn attempt<F>(&mut self, rhs: &mut F, h: f64, t_end: f64, test: &ErrorTest) -> Result<f64, Trouble>
    where
        F: FnMut(f64, &[f64], &mut [f64]) -> Result<(), Failure>,
    {
        for i in 1..S {
            // Y_i = y + Σ_j (h a_ij) k_j,  k_i = f(t + c_i h, Y_i); the last Y_i is the new point.
            let row = &self.coefficients.a[i];
            combine(&mut self.sum, &self.k[..i], |j| h * row[j]);
            for ((y_new, y), sum) in self.y_new.iter_mut().zip(&self.y).zip(&self.sum) {
                *y_new = y + sum;
            }
            let t = if i + 1 == S { t_end } else { self.t + h * self.coefficients.c[i] };
            self.evaluate(rhs, i, t)?;
        }
        self.t_new = t_end;
        // error = |h| max_i |Σ_j e_j k_ji| / weight_i
        combine(&mut self.sum, &self.k, |j| self.coefficients.error[j]);
        let error = h.abs() * test.norm(&self.sum, &self.y, &self.y_new);
        if error.is_nan() {
            check_finite(&self.sum)?;
        }
        Ok(error)
    }

    fn accept(&mut self) {
        self.t = self.t_new;
        std::mem::swap(&mut self.y, &mut self.y_new);
        self.k.swap(0, S - 1);
    }

    fn order(&self) -> u32 {
        self.order
    }

    fn time(&self) -> f64 {
        self.t
    }

    fn state(&self) -> &[f64] {
        &self.y
    }

    fn slope(&self) -> &[f64] {
        &self.k[0]
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
