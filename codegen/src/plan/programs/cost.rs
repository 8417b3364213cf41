//! Cost of a planned function: its number of operations, counted over its program.

use super::fusion::order_sum_for_fusion;
use super::program::{Program, ProgramLine};
use std::fmt;
use tripos_derive::algebra::text::display_tree::{DisplayTree, constant_and_factors};

/// Number of operations in one call of a function. A fused multiply-add counts as two operations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OperationCount {
    /// Number of additions, subtractions, multiplications, divisions and sign changes.
    pub operations: usize,
    /// Number of divisions, which are also counted in `operations`.
    pub divisions: usize,
    /// Number of pairs of a sine and a cosine of the same angle.
    pub sincos: usize,
    /// Number of calls of other mathematical functions, square roots included.
    pub functions: usize,
}

impl std::iter::Sum for OperationCount {
    fn sum<I: Iterator<Item = Self>>(counts: I) -> Self {
        counts.fold(Self::default(), |all, count| Self {
            operations: all.operations + count.operations,
            divisions: all.divisions + count.divisions,
            sincos: all.sincos + count.sincos,
            functions: all.functions + count.functions,
        })
    }
}

impl OperationCount {
    /// Approximate cost of a division, in additions. On current processors a division occupies its unit about four
    /// times as long as an addition.
    const DIVISION: usize = 4;
    /// Approximate cost, in additions, of a sine with its cosine, or of another mathematical function.
    const FUNCTION: usize = 30;

    /// Counts the operations in one call of a planned program.
    #[must_use]
    pub fn of(program: &Program) -> Self {
        let mut cost = Self::default();
        for line in &program.lines {
            cost.sincos += usize::from(matches!(line, ProgramLine::Circular { .. }));
            cost.count(line.value());
        }
        program.outputs.iter().for_each(|output| cost.count(&output.value));
        cost
    }

    /// Returns the cost of one call as a number of additions. It compares programs that compute the
    /// same values.
    #[must_use]
    pub fn weight(&self) -> usize {
        self.operations + (Self::DIVISION - 1) * self.divisions + Self::FUNCTION * (self.sincos + self.functions)
    }

    /// Adds the operations of a formula to the count.
    fn count(&mut self, view: &DisplayTree) {
        match view {
            DisplayTree::Number(_)
            | DisplayTree::Name(_)
            | DisplayTree::Word(_)
            | DisplayTree::Shared(_)
            | DisplayTree::Pi
            | DisplayTree::Cut => {}
            DisplayTree::Sum(terms) => {
                let opens_with_sign = terms[0].0 && order_sum_for_fusion(terms)[0].0;
                self.operations += terms.len() - 1 + usize::from(opens_with_sign);
                for (_, term) in terms {
                    self.count(term);
                }
            }
            DisplayTree::Product(factors) => {
                self.operations += factors.len().saturating_sub(1);
                for factor in factors {
                    self.count(factor);
                }
            }
            DisplayTree::Fraction(above, below) => self.count_fraction(above, below),
            DisplayTree::Power(base, n) => {
                self.operations += multiplications(base, *n);
                self.count(base);
            }
            DisplayTree::Call(_, argument) | DisplayTree::Root(argument) => {
                self.functions += 1;
                self.count(argument);
            }
        }
    }

    /// Adds the operations of a fraction. The whole numbers in its numerator and denominator
    /// together are one constant.
    fn count_fraction(&mut self, above: &DisplayTree, below: &DisplayTree) {
        let (n, above) = constant_and_factors(above);
        let (d, below) = constant_and_factors(below);
        let has_constant = n != "1" || d != "1" || above.is_empty();
        self.operations += (above.len() + usize::from(has_constant) - 1) + below.len();
        self.divisions += usize::from(!below.is_empty());
        above.iter().chain(&below).for_each(|factor| self.count(factor));
    }
}

/// Returns the number of multiplications in the power `base`^n. It is n − 1 if the base is a name and n is 2 or 3.
/// Otherwise it is that of repeated squaring.
fn multiplications(base: &DisplayTree, n: i32) -> usize {
    let n = n.unsigned_abs();
    match base {
        DisplayTree::Name(_) | DisplayTree::Shared(_) if (2..=3).contains(&n) => n as usize - 1,
        _ => (n.ilog2() + n.count_ones() - 1) as usize,
    }
}

impl fmt::Display for OperationCount {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plural = |n: usize, one: &str, many: &str| if n == 1 { format!("1 {one}") } else { format!("{n} {many}") };
        f.write_str(&plural(self.operations, "operation", "operations"))?;
        if self.sincos > 0 {
            write!(f, ", {}", plural(self.sincos, "sine and cosine", "sines and cosines"))?;
        }
        if self.functions > 0 {
            write!(f, ", {}", plural(self.functions, "other function", "other functions"))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tripos_derive::algebra::Arena;
    use tripos_derive::algebra::text::display_tree::{SharedNames, display_tree};
    use tripos_derive::algebra::text::parse::parse_primed;

    fn cost(formula: &str) -> [usize; 3] {
        let mut arena = Arena::default();
        let e = parse_primed(&mut arena, formula, 0, &mut |arena, name| Ok(arena.symbol(name))).unwrap();
        let mut cost = OperationCount::default();
        cost.count(&display_tree(&arena, e, &SharedNames::default(), usize::MAX));
        [cost.operations, cost.divisions, cost.functions]
    }

    #[test]
    fn operations_are_counted_as_they_are_written() {
        let counts = [
            ("a*b + c", [2, 0, 0]),
            // A negative product that can be written last is a subtraction.
            ("c - a*b", [2, 0, 0]),
            ("-a - b", [2, 0, 0]),
            ("a^3", [2, 0, 0]),
            // The power is computed by repeated squaring.
            ("a^9", [4, 0, 0]),
            // The number 3/2 is one constant.
            ("3*a/(2*b)", [2, 1, 0]),
            ("a/(b*c)", [2, 1, 0]),
            ("exp(a + b)*sqrt(a)", [2, 0, 2]),
        ];
        for (formula, expected) in counts {
            assert_eq!(cost(formula), expected, "{formula}");
        }
    }
}
