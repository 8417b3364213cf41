//! Linear system near a steady motion, in which chosen parameters remain symbols (letters). Exact algebra derives it
//! from the values and derivatives of the flow at a state that is given by formulas.

use super::{Flow, FlowProgramResults};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::linear::solve_linear;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::value::tape::{Numeric, Tape};
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Node, Rational};
use rustc_hash::FxHashSet;

/// Highest power of a symbol up to which a matrix entry is treated as a polynomial.
const MOST_POWERS: i64 = 8;

/// States that the linear system keeps, and the loops and symmetries that eliminate all other states. All are indices
/// from 0, which a numeric elimination chose.
#[derive(Clone, Debug, Default)]
pub struct StateElimination {
    /// Indices of the states that the linear system keeps.
    pub kept: Vec<usize>,
    /// Indices of the states that the loop equations determine.
    pub closed: Vec<usize>,
    /// Indices of the states that symmetries eliminate. A shift along a symmetry does not change the linear system.
    pub shifted: Vec<usize>,
    /// Indices of the symmetries that eliminate the states `shifted`.
    pub symmetries: Vec<usize>,
    /// Square system that determines the velocities along the symmetries, as (indices of states, indices of
    /// symmetries).
    pub carried: (Vec<usize>, Vec<usize>),
}

/// Steady state and numbers at which the linear system is derived.
#[derive(Clone, Debug, Default)]
pub struct OperatingPoint {
    /// Symbols of the parameters that have numbers, each with its exact value.
    pub numbers: Vec<(Expr, Rational)>,
    /// Formula of each state, in parameters and the symbols that remain.
    pub states: Vec<Expr>,
    /// Symbols of the parameters that are inputs of the linear system.
    pub inputs: Vec<Expr>,
    /// Outputs of the linear system, as terms in the states.
    pub outputs: Vec<Expr>,
}

/// Reason why there is no linear system with symbolic parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LinearSystemError {
    /// The state is not steady for every value of the symbolic parameters.
    NotSteady,
    /// The elimination, or a derivative, divides by a term that is 0 for every value of the symbolic
    /// parameters.
    Singular,
}

/// Linear system d' = A d + B r, y = C d + D r with symbolic entries. Here d are the deviations of the states, r the
/// inputs and y the outputs.
#[derive(Clone)]
pub struct SymbolicLinearSystem {
    /// Arena that holds the terms of the matrices.
    pub arena: Arena,
    /// Matrices A, B, C and D, in this order. Each is a list of rows.
    pub matrices: [Vec<Vec<Expr>>; 4],
}

impl Flow {
    /// Derives the linear system near a steady motion of this flow, with symbolic parameters.
    ///
    /// # Errors
    /// Returns [`LinearSystemError`] if the state is not steady, or if a divisor is zero.
    pub fn symbolic_linear_system(
        &self,
        stated: &OperatingPoint,
        chosen: &StateElimination,
    ) -> Result<SymbolicLinearSystem, LinearSystemError> {
        let mut work = SymbolicLinearSystemTerms { arena: self.arena.clone(), simplifier: Simplifier::default() };
        let (values, slopes) = work.slopes(self, stated)?;
        let along = work.velocities_along_symmetries(self, &values, chosen)?;
        let states = self.states.len();
        let moving = |work: &mut SymbolicLinearSystemTerms, slope: &FlowProgramResults<Expr>| {
            let fields = chosen.carried.1.iter().map(|at| &slope.symmetries[*at]);
            let fields: Vec<&Vec<Expr>> = fields.collect();
            (0..states)
                .map(|row| {
                    let shifted: Vec<Expr> = fields.iter().map(|zeta| zeta[row]).collect();
                    work.minus_products(slope.flow[row], &along, &shifted)
                })
                .collect::<Vec<Expr>>()
        };
        let columns: Vec<Vec<Expr>> = slopes.iter().map(|slope| moving(&mut work, slope)).collect();
        // Columns of the derivatives: states that the loops do not determine, then inputs.
        let inputs = states..states + stated.inputs.len();
        let all: Vec<usize> = (0..states).filter(|at| !chosen.closed.contains(at)).chain(inputs).collect();
        let free = all.len() - stated.inputs.len();
        // The states that the loops determine depend on these columns: δx_d = E (δx_k, δr).
        let loops: Vec<usize> = (0..self.loops.len()).collect();
        let follows = work.dependent_columns(&loops, &chosen.closed, &all, |row, column| slopes[column].loops[row])?;
        let on = |work: &mut SymbolicLinearSystemTerms, of: &dyn Fn(usize) -> Expr| -> Vec<Expr> {
            let direct = all.iter().enumerate().map(|(k, column)| {
                let parts: Vec<Expr> = chosen.closed.iter().map(|at| of(*at)).collect();
                let shares: Vec<Expr> = follows.iter().map(|row| row[k]).collect();
                work.minus_products(of(*column), &parts, &shares)
            });
            direct.collect()
        };
        let rows: Vec<Vec<Expr>> = (0..states).map(|row| on(&mut work, &|column| columns[column][row])).collect();
        let outputs: Vec<Vec<Expr>> =
            (0..stated.outputs.len()).map(|row| on(&mut work, &|column| slopes[column].outputs[row])).collect();
        // The shifted states are eliminated: H G_out = G_kept.
        let field = |row: usize, column: usize| values.symmetries[chosen.symmetries[column]][row];
        let order: Vec<usize> = (0..chosen.symmetries.len()).collect();
        let shares = work.dependent_columns(&order, &chosen.shifted, &chosen.kept, |row, column| field(column, row))?;
        let place = |at: &usize| all.iter().position(|known| known == at).expect("what is kept is not closed");
        let mut a = Vec::new();
        let mut b = Vec::new();
        for (k, row) in chosen.kept.iter().enumerate() {
            // Row k of H, from `follows`; `minus` subtracts its products with the shifted rows.
            let factors: Vec<Expr> = shares.iter().map(|share| share[k]).collect();
            let quotient = |work: &mut SymbolicLinearSystemTerms, direct: Expr, others: Vec<Expr>| {
                work.minus_products(direct, &others, &factors)
            };
            let mut line = Vec::new();
            for column in chosen.kept.iter().map(place) {
                let others = chosen.shifted.iter().map(|at| rows[*at][column]).collect();
                line.push(quotient(&mut work, rows[*row][column], others));
            }
            a.push(line);
            let mut line = Vec::new();
            for (at, direct) in rows[*row].iter().enumerate().skip(free) {
                let others = chosen.shifted.iter().map(|shifted| rows[*shifted][at]).collect();
                line.push(quotient(&mut work, *direct, others));
            }
            b.push(line);
        }
        let kept: Vec<usize> = chosen.kept.iter().map(place).collect();
        let c = outputs.iter().map(|row| kept.iter().map(|column| row[*column]).collect()).collect();
        let d = outputs.iter().map(|row| row[free..].to_vec()).collect();
        Ok(SymbolicLinearSystem { matrices: [a, b, c, d], arena: work.arena })
    }
}

/// Arena and simplifier of the terms of a linear system while it is derived.
struct SymbolicLinearSystemTerms {
    /// Arena of the terms of the linear system. It starts as a copy of the flow's arena.
    arena: Arena,
    /// Simplifier of terms, which keeps its earlier results.
    simplifier: Simplifier,
}

impl SymbolicLinearSystemTerms {
    /// Values of the flow at the stated state, and their derivatives with respect to each state, then to each input.
    ///
    /// # Errors
    /// Returns `LinearSystemError::Singular` if a term divides by zero.
    fn slopes(
        &mut self,
        flow: &Flow,
        stated: &OperatingPoint,
    ) -> Result<(FlowProgramResults<Expr>, Vec<FlowProgramResults<Expr>>), LinearSystemError> {
        let Self { arena, simplifier } = self;
        let zetas = flow.symmetries.iter().flat_map(|symmetry| &symmetry.along);
        let terms: Vec<Expr> =
            flow.rates.iter().chain(&flow.loops).chain(zetas).chain(&stated.outputs).copied().collect();
        let inside = symbols_inside_functions(
            arena,
            &flow.steps.iter().map(|step| step.value).chain(terms.iter().copied()).collect::<Vec<_>>(),
        );
        // A parameter inside a function remains a letter. Otherwise the function would have no exact value.
        let numbers = stated.numbers.iter().filter(|(symbol, _)| !inside.contains(symbol));
        let numbers: Vec<(Expr, Expr)> = numbers
            .map(|(symbol, value)| (*symbol, value.clone()))
            .collect::<Vec<_>>()
            .into_iter()
            .map(|(s, v)| (s, arena.number(v)))
            .collect();
        let mut put = Substitution::new(&numbers);
        let states: Vec<Expr> = stated.states.iter().map(|formula| put.apply(arena, *formula)).collect();
        let pairs: Vec<(Expr, Expr)> = flow.states.iter().copied().zip(states).chain(numbers).collect();
        let mut put = Substitution::new(&pairs);
        let mut along: Vec<Differential> =
            flow.states.iter().chain(&stated.inputs).map(|x| Differential::partial(*x)).collect();
        for step in &flow.steps {
            for slope_of in &mut along {
                let slope = slope_of.apply(arena, step.value);
                let slope = put.apply(arena, slope);
                let slope = simplifier.simplify(arena, slope);
                slope_of.set_rate(step.symbol, slope);
            }
            let value = put.apply(arena, step.value);
            put.set(step.symbol, simplifier.simplify(arena, value));
        }
        let sizes = super::FlowProgramSizes {
            parameters: 0,
            states: flow.states.len(),
            inputs: stated.inputs.len(),
            loops: flow.loops.len(),
            ties: flow.loops.len(),
            symmetries: flow.symmetries.len(),
            outputs: stated.outputs.len(),
        };
        let mut at = |arena: &mut Arena, term: Expr| {
            let value = put.apply(arena, term);
            simplifier.simplify(arena, value)
        };
        let values: Vec<Expr> = terms.iter().map(|term| at(arena, *term)).collect();
        let mut slopes = Vec::with_capacity(along.len());
        for slope_of in &mut along {
            let list: Vec<Expr> = terms
                .iter()
                .map(|term| {
                    let slope = slope_of.apply(arena, *term);
                    at(arena, slope)
                })
                .collect();
            slopes.push(FlowProgramResults::new(sizes, &list));
        }
        if put.undefined.is_some() {
            return Err(LinearSystemError::Singular);
        }
        Ok((FlowProgramResults::new(sizes, &values), slopes))
    }

    /// Finds the velocities c with f = Σ c ζ along the symmetries ζ, and proves this equation for all values of the
    /// symbols.
    ///
    /// # Errors
    /// Returns `LinearSystemError` if c is not determined, or if the state is not steady.
    fn velocities_along_symmetries(
        &mut self,
        flow: &Flow,
        values: &FlowProgramResults<Expr>,
        chosen: &StateElimination,
    ) -> Result<Vec<Expr>, LinearSystemError> {
        let (rows, columns) = &chosen.carried;
        let a: Vec<Vec<Expr>> =
            rows.iter().map(|row| columns.iter().map(|column| values.symmetries[*column][*row]).collect()).collect();
        let b: Vec<Vec<Expr>> = rows.iter().map(|row| vec![values.flow[*row]]).collect();
        let (found, _) =
            solve_linear(&mut self.arena, &mut self.simplifier, &a, &b).map_err(|_| LinearSystemError::Singular)?;
        let along: Vec<Expr> = found.iter().map(|row| row[0]).collect();
        for row in 0..flow.states.len() {
            let shifted: Vec<Expr> = columns.iter().map(|column| values.symmetries[*column][row]).collect();
            let left = self.minus_products(values.flow[row], &along, &shifted);
            self.check_is_zero(left)?;
        }
        values.loops.iter().try_for_each(|open| self.check_is_zero(*open))?;
        Ok(along)
    }

    /// Checks that a term is identically zero. Returns `LinearSystemError::NotSteady` if it is not.
    fn check_is_zero(&self, e: Expr) -> Result<(), LinearSystemError> {
        if zero_test(&self.arena, e) == ZeroTest::Zero { Ok(()) } else { Err(LinearSystemError::NotSteady) }
    }

    /// Finds X with M_d X = M_k, so that M x = 0 for x_d = −X x_k. M_d and M_k are the columns `dependent` and `kept`
    /// of a matrix M, whose entries `entry` gives. The result is empty if `dependent` is empty.
    ///
    /// # Errors
    /// Returns `LinearSystemError::Singular` if M_d is singular.
    fn dependent_columns(
        &mut self,
        rows: &[usize],
        dependent: &[usize],
        kept: &[usize],
        entry: impl Fn(usize, usize) -> Expr,
    ) -> Result<Vec<Vec<Expr>>, LinearSystemError> {
        if dependent.is_empty() {
            return Ok(Vec::new());
        }
        let part = |columns: &[usize]| -> Vec<Vec<Expr>> {
            rows.iter().map(|row| columns.iter().map(|column| entry(*row, *column)).collect()).collect()
        };
        let (found, _) = solve_linear(&mut self.arena, &mut self.simplifier, &part(dependent), &part(kept))
            .map_err(|_| LinearSystemError::Singular)?;
        Ok(found)
    }

    /// Simplified term e − Σ a_i b_i over the entries of two lists of equal length.
    fn minus_products(&mut self, e: Expr, a: &[Expr], b: &[Expr]) -> Expr {
        let mut terms = vec![(e, Rational::ONE)];
        for (a, b) in a.iter().zip(b) {
            terms.push((self.arena.mul(*a, *b), Rational::MINUS_ONE));
        }
        let sum = self.arena.linear_combination(&terms);
        self.simplifier.simplify(&mut self.arena, sum)
    }
}

/// Symbols that occur in arguments of functions, such as of sine.
fn symbols_inside_functions(arena: &Arena, terms: &[Expr]) -> FxHashSet<Expr> {
    let arguments: Vec<Expr> = arena
        .reachable(terms)
        .into_iter()
        .filter_map(|e| if let Node::Apply(_, argument) = arena.node(e) { Some(*argument) } else { None })
        .collect();
    arena.reachable(&arguments).into_iter().filter(|e| arena.symbol_name(*e).is_some()).collect()
}

impl SymbolicLinearSystem {
    /// Coefficients of an entry of the matrices as a polynomial in the symbol `letter`, that of power 0 first.
    /// `known` are the values of all other symbols. `None` if the entry is not a polynomial of degree 8 or less in
    /// `letter`.
    pub fn polynomial<S: Numeric>(&mut self, entry: Expr, letter: Expr, known: &[(Expr, S)]) -> Option<Vec<S>> {
        let arena = &mut self.arena;
        let (symbols, values): (Vec<Expr>, Vec<S>) = known.iter().copied().unzip();
        let mut coefficients = Vec::new();
        let mut slope = entry;
        let mut factorial = S::int(1);
        let mut d = Differential::partial(letter);
        for power in 0..=MOST_POWERS {
            let mut at_zero = Substitution::new(&[(letter, Expr::ZERO)]);
            let value = at_zero.apply(arena, slope);
            if at_zero.undefined.is_some() {
                return None;
            }
            let value = Tape::new(arena, &symbols, &[value]).ok()?.to::<S>().evaluate(&values)[0];
            coefficients.push(value / factorial);
            slope = d.apply(arena, slope);
            if zero_test(arena, slope) == ZeroTest::Zero {
                return Some(coefficients);
            }
            factorial = factorial * S::int(power + 1);
        }
        None
    }
}
