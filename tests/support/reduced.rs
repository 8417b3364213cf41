//! Runs of reduced systems, interpreted, and where they put what a scene wants to see.

use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::reduce::{ReducedQuantity, Reduction};
use tripos_derive::scene::Scene;
use tripos_sim::{Failure, Method, Options, OutputOption, integrate};

/// A reduced system with the numbers of a scene.
pub struct Reduced {
    /// M, f and q̇ at parameters, coordinates and speeds.
    rates: Tape,
    /// Outputs of the scene, at a state and a time.
    outputs: Tape,
    parameters: Vec<f64>,
    start: Vec<f64>,
    coordinates: usize,
    speeds: usize,
}

impl Reduced {
    /// From the start of the scene.
    pub fn new(reduction: &Reduction, scene: &Scene, whole: &tripos_derive::Model) -> Self {
        let (arena, e) = (reduction.arena(), &reduction.derivation.equations);
        let stated = [whole.p(), whole.q(), whole.u()].concat();
        let numbers = [scene.parameters.clone(), scene.q.clone(), scene.u.clone()].concat();
        let at_start = |of_start: Expr| Tape::new(arena, &stated, &[of_start]).unwrap().evaluate(&numbers)[0];
        let parameter = |name: &str| {
            let constant = reduction.constants.iter().find(|c| c.name == name).map(|c| at_start(c.of_start));
            let own = || whole.parameters.iter().position(|p| p.name == name).map(|at| scene.parameters[at]);
            constant.or_else(own).unwrap_or_else(|| panic!("no value of {name}"))
        };
        let parameters = reduction.model.parameters.iter().map(|p| parameter(&p.name)).collect();
        let all: Vec<&ReducedQuantity> = reduction.states.iter().chain(&reduction.quadratures).collect();
        let variables = [e.coordinates.clone(), e.variables.clone()].concat();
        let start = variables.iter().map(|v| at_start(all.iter().find(|q| q.symbol == *v).unwrap().of_start)).collect();
        // In a moving frame no formula gives the start.
        let (parameters, start) = match &reduction.frame {
            None => (parameters, start),
            Some(_) => {
                let own = tripos::ReducedScene::from_reduction(reduction.clone(), whole, scene).unwrap().scene;
                (own.parameters, [own.q, own.u].concat())
            }
        };
        let inputs = [reduction.model.p(), variables].concat();
        let tape = |inputs: &[Expr], out: &[Expr]| Tape::stepwise(arena, inputs, &e.definitions, out).unwrap();
        let rates = tape(&inputs, &[e.matrix.concat(), e.forcing.clone(), e.coordinate_rates.clone()].concat());
        let values: Vec<Expr> = reduction.outputs.iter().map(|o| o.value).collect();
        let outputs = tape(&[inputs, vec![reduction.time]].concat(), &values);
        Self { rates, outputs, parameters, start, coordinates: e.coordinates.len(), speeds: e.variables.len() }
    }

    /// The outputs after t seconds, by DOP853 at this tolerance.
    pub fn after(&self, t: f64, tolerance: f64) -> Vec<f64> {
        let rhs = |_: f64, y: &[f64], dy: &mut [f64]| {
            let values = self.rates.evaluate(&[&self.parameters, y].concat());
            let (matrix, rest) = values.split_at(self.speeds * self.speeds);
            let (forcing, q_dot) = rest.split_at(self.speeds);
            dy[..self.coordinates].copy_from_slice(q_dot);
            dy[self.coordinates..].copy_from_slice(&solve(matrix.to_vec(), forcing.to_vec()));
            Ok::<(), Failure>(())
        };
        let tolerances = Options::tolerances(tolerance, tolerance);
        let options = Options { method: Method::Dop853, output: OutputOption::Ends, ..tolerances };
        // A system without states is known at all times.
        let y = if self.start.is_empty() {
            Vec::new()
        } else {
            let run = integrate(rhs, (0.0, t), &self.start, &options, &mut []).unwrap();
            assert_eq!(run.stop.code(), "end");
            run.y_end
        };
        self.outputs.evaluate(&[&self.parameters, &y[..], &[t]].concat())
    }
}

/// A x = b by elimination with partial pivoting.
fn solve(mut a: Vec<f64>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|i, j| a[i * n + k].abs().total_cmp(&a[j * n + k].abs())).unwrap();
        for column in 0..n {
            a.swap(k * n + column, pivot * n + column);
        }
        b.swap(k, pivot);
        for row in k + 1..n {
            let factor = a[row * n + k] / a[k * n + k];
            for column in k..n {
                a[row * n + column] -= factor * a[k * n + column];
            }
            b[row] -= factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let others: f64 = (k + 1..n).map(|column| a[k * n + column] * b[column]).sum();
        b[k] = (b[k] - others) / a[k * n + k];
    }
    b
}
