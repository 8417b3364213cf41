//! Equations of motion in one kind of balls, with the quantities that a rigorous run observes.

use crate::code::compile_tape;
use crate::error::Error;
use crate::interpreted_equations::InterpretedEquations;
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::tape::{Numeric, Tape};
use tripos_derive::scene::{DETERMINANT, ENERGIES};
use tripos_traits::{Derivative, Scalar, System};

/// Equations of motion in numbers of the type `S`, with formulas of further quantities.
pub struct ObservedEquations<S> {
    /// Equations of motion whose accelerations were solved for.
    pub equations: Derivative<InterpretedEquations<S>>,
    /// Further quantities of whole equations; `None` if the outputs of the equations are all that is observed.
    formulas: Option<StateFormulas<S>>,
}

/// Formulas of the state of whole equations, as a tape.
#[derive(Clone)]
pub struct StateFormulas<S = f64> {
    /// Program that computes the formulas from p, q, q̇, u, u̇, the energies and the determinant of the mass matrix.
    tape: Tape<S>,
    /// True if a formula contains the determinant.
    has_determinant: bool,
    /// Indices in [`ENERGIES`] of the energies that are no names of the model.
    energies: Vec<usize>,
    /// True if [`DETERMINANT`] is no name of the model, and so an input of the tape.
    takes_determinant: bool,
}

impl StateFormulas {
    /// Compiles formulas of a model's whole state.
    ///
    /// # Errors
    /// `Error::Request` if a formula contains a reaction or another symbol without a value.
    pub fn new(model: &mut Model, formulas: &[Expr]) -> Result<Self, Error> {
        let u_dot: Vec<Expr> = model.speeds.iter().map(|s| s.rate).collect();
        let mut inputs = [model.p(), model.q(), model.q_dot(), model.u(), u_dot].concat();
        let mut free_symbol = |model: &mut Model, name: &str| {
            let symbol = model.arena.symbol(name);
            let is_free = !inputs.contains(&symbol);
            if is_free {
                inputs.push(symbol);
            }
            is_free
        };
        let energies = (0..ENERGIES.len()).filter(|at| free_symbol(model, ENERGIES[*at])).collect();
        let takes_determinant = free_symbol(model, DETERMINANT);
        let symbol = model.arena.symbol(DETERMINANT);
        let has_determinant = takes_determinant && formulas.iter().any(|f| model.arena.mentions(*f, symbol));
        let tape = compile_tape(&model.arena, &inputs, formulas, "a claim, an event or an output")?;
        Ok(Self { tape, has_determinant, energies, takes_determinant })
    }

    /// The same formulas in numbers of the type `S`.
    pub fn convert_to<S: Numeric>(&self) -> StateFormulas<S> {
        StateFormulas {
            tape: self.tape.to(),
            has_determinant: self.has_determinant,
            energies: self.energies.clone(),
            takes_determinant: self.takes_determinant,
        }
    }
}

impl<S: Numeric> ObservedEquations<S> {
    /// Converts equations and formulas to numbers of the type `S`.
    pub fn new(tapes: &InterpretedEquations, formulas: Option<&StateFormulas>) -> Self {
        Self { equations: Derivative(tapes.convert_to()), formulas: formulas.map(StateFormulas::convert_to) }
    }

    /// Observed quantities in the state (q, v) at the time `t`, s after the start: the outputs of the equations, then
    /// the further formulas.
    pub fn observed(&self, p: &[S], t: S, state: &[S]) -> Vec<S> {
        let system = &self.equations.0;
        let lengths = system.lengths();
        let (q, v) = state.split_at(lengths.coordinates);
        let mut out = vec![S::int(0); system.output_count()];
        system.outputs(p, t, q, v, &mut out);
        let Some(formulas) = &self.formulas else { return out };
        let (coordinates, u) = out.split_at(lengths.coordinates);
        let mut q_dot = vec![S::int(0); q.len()];
        let mut v_dot = vec![S::int(0); v.len()];
        system.derivative(p, q, v, &mut q_dot, &mut v_dot);
        let mut u_dot = vec![S::int(0); u.len()];
        system.generalized_speed_rates(p, q, v, &v_dot, &mut u_dot);
        let (kinetic, potential) = (system.kinetic_energy(p, q, v), system.potential_energy(p, q));
        let energies = [kinetic, potential, kinetic + potential];
        let mut inputs = [p, coordinates, &q_dot, u, &u_dot].concat();
        inputs.extend(formulas.energies.iter().map(|at| energies[*at]));
        if formulas.takes_determinant {
            inputs.push(if formulas.has_determinant {
                let n = lengths.unknowns();
                let mut matrix = vec![S::int(0); n * n];
                system.mass_matrix(p, q, v, &mut matrix);
                determinant(&matrix, n)
            } else {
                S::int(0)
            });
        }
        let further = formulas.tape.evaluate(&inputs);
        [out, further].concat()
    }
}

/// Determinant of an n × n matrix, given row by row, by sums and products alone.
///
/// Method: R. S. Bird, "A simple division-free algorithm for computing determinants", Information Processing Letters
/// 111 (2011) 1072–1074.
fn determinant<S: Scalar>(matrix: &[S], n: usize) -> S {
    let mut product = matrix.to_vec();
    for _ in 1..n {
        let mut left = vec![S::int(0); n * n];
        let mut trace = S::int(0);
        for row in (0..n).rev() {
            left[row * n + row] = -trace;
            trace = trace + product[row * n + row];
            left[row * n + row + 1..(row + 1) * n].copy_from_slice(&product[row * n + row + 1..(row + 1) * n]);
        }
        let entry = |at: usize| {
            let (row, column) = (at / n, at % n);
            (0..n).fold(S::int(0), |sum, k| sum + left[row * n + k] * matrix[k * n + column])
        };
        product = (0..n * n).map(entry).collect();
    }
    let sign = if n % 2 == 1 { 1 } else { -1 };
    product.first().map_or(S::int(1), |first| S::int(sign) * *first)
}

#[cfg(test)]
mod tests {
    use super::determinant;

    /// Goal: determinants are right. Method: matrices of whole numbers of order 1 to 4, by hand and by a product of
    /// triangular matrices with known determinants.
    #[test]
    fn determinants_of_whole_numbers_are_exact() {
        assert!((determinant(&[7.0], 1) - 7.0f64).abs() < 1e-12);
        assert!((determinant(&[1.0, 2.0, 3.0, 4.0], 2) - -2.0f64).abs() < 1e-12);
        assert!((determinant(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 9.0], 3) - -3.0f64).abs() < 1e-12);
        let (lower, upper) = (
            [[1, 0, 0, 0], [2, 1, 0, 0], [0, 3, 1, 0], [4, 0, 5, 1]],
            [[2, 1, 0, 3], [0, 3, 1, 1], [0, 0, -1, 2], [0, 0, 0, 5]],
        );
        let entry = |at: usize| (0..4).map(|k| f64::from(lower[at / 4][k] * upper[k][at % 4])).sum::<f64>();
        let product: Vec<f64> = (0..16).map(entry).collect();
        assert!((determinant(&product, 4) - -30.0).abs() < 1e-9);
    }
}
