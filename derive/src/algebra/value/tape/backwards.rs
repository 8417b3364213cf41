//! Backward pass over a tape: derivatives of a weighted sum of its outputs with respect to all
//! inputs, in one pass.
//!
//! First the values of the tape are computed. Then, from the last operation to the first, the
//! derivative of the sum with respect to the result of each operation is computed. The cost is that
//! of a few evaluations, whatever the number of inputs.
//! A. Griewank & A. Walther, *Evaluating Derivatives*, 2nd edition (2008), §3.2.
//!
//! Derivatives are the same as in [`tripos_traits::Tangent`]: the derivative of |x| is the sign of
//! x, and that of the sign is 0. An operation with a zero weight is not followed backwards. So an
//! undefined derivative matters only if the sum depends on it.

use super::{Op, Tape};
use crate::algebra::Function;

/// Working space of a backward pass over a tape, reused between passes.
#[derive(Clone, Debug, Default)]
pub struct BackwardWorkspace {
    /// Result of each operation of the tape.
    values: Vec<f64>,
    /// Derivative of the weighted sum of outputs with respect to the result of each operation.
    shares: Vec<f64>,
    /// Values of the outputs of the tape.
    outputs: Vec<f64>,
}

impl Tape {
    /// Adds the derivative Σₖ weightₖ ∂outputₖ/∂inputᵢ to entry i of `slopes`, for every input i.
    /// `room` is working space that may be reused in later calls.
    ///
    /// # Panics
    /// If the length of `inputs`, `weights` or `slopes` differs from that of the tape.
    pub fn backward_pass(&self, inputs: &[f64], weights: &[f64], room: &mut BackwardWorkspace, slopes: &mut [f64]) {
        assert_eq!(weights.len(), self.outputs.len(), "one weight for each output");
        assert_eq!(slopes.len(), self.inputs, "one place for each input");
        let BackwardWorkspace { values, shares, outputs } = room;
        outputs.resize(self.outputs.len(), 0.0);
        self.evaluate_into(inputs, values, outputs);
        shares.clear();
        shares.resize(self.ops.len(), 0.0);
        for (slot, weight) in self.outputs.iter().zip(weights) {
            shares[*slot as usize] += weight;
        }
        for (at, op) in self.ops.iter().enumerate().rev() {
            let share = shares[at];
            if share == 0.0 {
                continue;
            }
            match op {
                Op::Constant(_) | Op::Pi => (),
                Op::Input(input) => slopes[*input] += share,
                Op::Sum(_, terms) => terms.iter().for_each(|(slot, k)| shares[*slot as usize] += k * share),
                Op::Product(factors) => {
                    for (place, (slot, n)) in factors.iter().enumerate() {
                        let others = factors.iter().enumerate().filter(|(other, _)| *other != place);
                        // The product of the other factors is not a division by this factor,
                        // because it may be 0.
                        let others = others.fold(share, |x, (_, (slot, n))| x * power(values[*slot as usize], *n));
                        shares[*slot as usize] += others * backward_slope_of_power(values[*slot as usize], *n);
                    }
                }
                Op::Apply(f, slot) => {
                    shares[*slot as usize] += share * derivative_of_function(*f, values[*slot as usize], values[at]);
                }
            }
        }
    }
}

/// Power xⁿ, with short forms for n = 1, 2 and −1.
fn power(x: f64, n: i32) -> f64 {
    match n {
        1 => x,
        2 => x * x,
        -1 => 1.0 / x,
        _ => x.powi(n),
    }
}

/// Derivative n xⁿ⁻¹ of the power xⁿ.
fn backward_slope_of_power(x: f64, n: i32) -> f64 {
    match n {
        0 => 0.0,
        1 => 1.0,
        _ => f64::from(n) * power(x, n - 1),
    }
}

/// Derivative f′(x) of an elementary function, where `value` is f(x).
fn derivative_of_function(f: Function, x: f64, value: f64) -> f64 {
    let leg = || (1.0 - x * x).sqrt();
    match f {
        Function::Sin => x.cos(),
        Function::Cos => -x.sin(),
        Function::Sqrt => 0.5 / value,
        Function::Exp => value,
        Function::Log => 1.0 / x,
        Function::Asin => 1.0 / leg(),
        Function::Acos => -1.0 / leg(),
        Function::Atan => 1.0 / (1.0 + x * x),
        Function::Sinh => x.cosh(),
        Function::Cosh => x.sinh(),
        Function::Tanh => 1.0 - value * value,
        Function::Abs => tripos_traits::Scalar::sign(x),
        Function::Sign => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::Arena;
    use tripos_traits::Tangent;

    const FUNCTIONS: [Function; 13] = [
        Function::Sin,
        Function::Cos,
        Function::Sqrt,
        Function::Exp,
        Function::Log,
        Function::Asin,
        Function::Acos,
        Function::Atan,
        Function::Sinh,
        Function::Cosh,
        Function::Tanh,
        Function::Abs,
        Function::Sign,
    ];

    /// The backward pass gives the same derivatives as the forward pass, for every operation.
    /// Weighted products of powers with each function are compared with a tape in numbers with
    /// derivatives. The tolerance is 8 ε of the largest term, since the two passes round their
    /// functions separately.
    #[test]
    fn backwards_are_the_slopes_that_forwards_are() {
        let mut arena = Arena::new();
        let (x, y, z) = (arena.symbol("x"), arena.symbol("y"), arena.symbol("z"));
        let parts = [arena.pow(x, 3).unwrap(), arena.pow(y, -2).unwrap(), z];
        let product = arena.product(&parts);
        let part = arena.ratio(1, 64);
        let small = arena.mul(product, part);
        let mut outputs = vec![product];
        for f in FUNCTIONS {
            outputs.push(arena.apply(f, small));
        }
        let sum = arena.add(product, x);
        outputs.push(sum);
        let tape = Tape::new(&arena, &[x, y, z], &outputs).unwrap();
        let inputs = [1.3, 0.7, 1.9];
        let weights: Vec<f64> = (0..outputs.len()).map(|k| 1.0 + 0.25 * k as f64).collect();
        let mut slopes = vec![0.5; 3];
        tape.backward_pass(&inputs, &weights, &mut BackwardWorkspace::default(), &mut slopes);
        for (along, slope) in slopes.iter().enumerate() {
            let at = |i: usize| Tangent { value: inputs[i], slopes: [f64::from(u8::from(i == along))] };
            let forwards = tape.to::<Tangent<1>>().evaluate(&[at(0), at(1), at(2)]);
            let terms: Vec<f64> = forwards.iter().zip(&weights).map(|(x, w)| w * x.slopes[0]).collect();
            let (truth, size) = (0.5 + terms.iter().sum::<f64>(), terms.iter().fold(1.0, |a: f64, x| a.max(x.abs())));
            assert!((slope - truth).abs() <= 8.0 * f64::EPSILON * size, "{along}: {slope} {truth}");
        }
    }

    /// A factor of zero is allowed, and so is a root at zero on which the sum does not depend.
    #[test]
    fn a_factor_of_zero_and_what_nothing_depends_on_are_no_hindrance() {
        let mut arena = Arena::new();
        let (x, y) = (arena.symbol("x"), arena.symbol("y"));
        let product = arena.mul(x, y);
        let root = arena.apply(Function::Sqrt, x);
        let tape = Tape::new(&arena, &[x, y], &[product, root]).unwrap();
        let mut slopes = vec![0.0; 2];
        tape.backward_pass(&[0.0, 3.0], &[2.0, 0.0], &mut BackwardWorkspace::default(), &mut slopes);
        assert_eq!(slopes, [6.0, 0.0]);
    }
}
