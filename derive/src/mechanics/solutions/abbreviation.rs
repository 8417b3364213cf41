//! Abbreviated equations of motion: terms of sums in mass matrix and forcing are left out.
//!
//! A term of the equations is one summand of one sum, wherever the sum occurs. A sum that the mass matrix and the
//! forcing share loses a term in both, so a symmetric matrix stays symmetric. Sums inside functions, such as the angle
//! q1 + q2 of a sine, keep all their terms, and so do the kinematic equations.
//!
//! Precedent: B. Armstrong, O. Khatib & J. Burdick, IEEE International Conference on Robotics and Automation (1986)
//! 510-518, who left out terms of a PUMA 560 below one per cent.

use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::Definition;
use crate::algebra::value::tape::{Tape, UnknownSymbol};
use crate::algebra::{Arena, Expr, Node, Rational};
use crate::mechanics::Equations;
use rustc_hash::{FxHashMap, FxHashSet};

/// One summand of one sum of the equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SumTerm {
    /// Handle of the sum.
    pub sum: Expr,
    /// Index of the summand in the sum's list of terms.
    pub index: usize,
}

/// Summands of the mass matrix and the forcing of equations of motion, with a program that measures their effects.
pub struct SumTerms {
    /// Equations in which each symbol that they define is replaced by its term.
    equations: Equations,
    /// All subterms of mass matrix and forcing outside of functions, operands first.
    nodes: Vec<Expr>,
    /// Position of each subterm in `nodes`.
    places: FxHashMap<Expr, usize>,
    /// Summands, in the order of their sums.
    list: Vec<SumTerm>,
    /// Program that computes all `nodes` from parameters, q and v.
    tape: Tape,
}

impl SumTerms {
    /// Lists the summands of equations of motion. `parameters` are the symbols of the parameters.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if the equations contain a symbol that is neither a parameter nor in q or v.
    pub fn new(arena: &mut Arena, equations: &Equations, parameters: &[Expr]) -> Result<Self, UnknownSymbol> {
        let equations = without_definitions(arena, equations);
        let roots: Vec<Expr> = equations.matrix.iter().flatten().chain(&equations.forcing).copied().collect();
        let nodes = subterms_outside_functions(arena, &roots);
        let places = nodes.iter().enumerate().map(|(at, e)| (*e, at)).collect();
        let terms_of = |e: &Expr| match arena.node(*e) {
            Node::Sum(constant, terms) if terms.len() + usize::from(!constant.is_zero()) > 1 => terms.len(),
            _ => 0,
        };
        let list = nodes.iter().flat_map(|sum| (0..terms_of(sum)).map(|index| SumTerm { sum: *sum, index })).collect();
        let inputs = [parameters, &equations.coordinates, &equations.variables].concat();
        let tape = Tape::new(arena, &inputs, &nodes)?;
        Ok(Self { equations, nodes, places, list, tape })
    }

    /// Summands, in the order in which their effects are given.
    #[must_use]
    pub fn list(&self) -> &[SumTerm] {
        &self.list
    }

    /// Values of all subterms at one state. `inputs` are the values of parameters, q and v, in SI units.
    #[must_use]
    pub fn values(&self, inputs: &[f64]) -> Vec<f64> {
        self.tape.evaluate(inputs)
    }

    /// Value of a subterm in the list that [`Self::values`] gives.
    fn value(&self, values: &[f64], e: Expr) -> f64 {
        values[self.places[&e]]
    }

    /// Mass matrix by rows, and forcing, from the values of all subterms.
    #[must_use]
    pub fn linear_system(&self, values: &[f64]) -> (Vec<Vec<f64>>, Vec<f64>) {
        let matrix = self.equations.matrix.iter().map(|row| row.iter().map(|e| self.value(values, *e)).collect());
        (matrix.collect(), self.equations.forcing.iter().map(|e| self.value(values, *e)).collect())
    }

    /// First-order changes of Σ wᵢ (f − M x)ᵢ if single summands are left out, with their signs reversed, in the order
    /// of [`Self::list`]. `values` are those of all subterms at one state, `unknowns` are x, and `weights` are w.
    ///
    /// With a row of M⁻¹ as weights, a change is that of one unknown.
    #[must_use]
    pub fn effects(&self, arena: &Arena, values: &[f64], unknowns: &[f64], weights: &[f64]) -> Vec<f64> {
        let mut adjoints = vec![0.0; self.nodes.len()];
        for ((row, forcing), weight) in self.equations.matrix.iter().zip(&self.equations.forcing).zip(weights) {
            adjoints[self.places[forcing]] += weight;
            for (entry, x) in row.iter().zip(unknowns) {
                adjoints[self.places[entry]] -= weight * x;
            }
        }
        for (at, e) in self.nodes.iter().enumerate().rev() {
            let adjoint = adjoints[at];
            if adjoint == 0.0 {
                continue;
            }
            match arena.node(*e) {
                Node::Sum(_, terms) => {
                    for (term, factor) in terms {
                        adjoints[self.places[term]] += adjoint * factor.to_f64();
                    }
                }
                Node::Product(factors) => {
                    for (this, (base, n)) in factors.iter().enumerate() {
                        let others = factors.iter().enumerate().filter(|(other, _)| *other != this);
                        let rest: f64 =
                            others.map(|(_, (other, power))| self.value(values, *other).powi(*power)).product();
                        let slope = f64::from(*n) * self.value(values, *base).powi(n - 1) * rest;
                        adjoints[self.places[base]] += adjoint * slope;
                    }
                }
                Node::Named(_, term) => adjoints[self.places[term]] += adjoint,
                Node::Number(_) | Node::Symbol(_) | Node::Pi | Node::Apply(..) => {}
            }
        }
        let of = |term: &SumTerm| {
            let (summand, factor) = summand(arena, *term);
            adjoints[self.places[&term.sum]] * factor.to_f64() * self.value(values, summand)
        };
        self.list.iter().map(of).collect()
    }

    /// Equations without the summands `dropped`. `None` if the equations then divide by zero.
    #[must_use]
    pub fn equations_without(&self, arena: &mut Arena, dropped: &FxHashSet<SumTerm>) -> Option<Equations> {
        let mut without: FxHashMap<Expr, Expr> = FxHashMap::default();
        for e in &self.nodes {
            let new = match arena.node(*e).clone() {
                Node::Sum(constant, terms) => {
                    let kept = terms.iter().enumerate();
                    let kept = kept.filter(|(index, _)| !dropped.contains(&SumTerm { sum: *e, index: *index }));
                    let mut list: Vec<(Expr, Rational)> =
                        kept.map(|(_, (term, factor))| (without[term], factor.clone())).collect();
                    list.push((Expr::ONE, constant));
                    arena.linear_combination(&list)
                }
                Node::Product(factors) => {
                    let list: Vec<(Expr, i32)> = factors.iter().map(|(base, n)| (without[base], *n)).collect();
                    arena.try_product(&list).ok()?
                }
                Node::Named(_, term) => arena.name_like(*e, without[&term]),
                Node::Number(_) | Node::Symbol(_) | Node::Pi | Node::Apply(..) => *e,
            };
            without.insert(*e, new);
        }
        let mut equations = self.equations.clone();
        let entries = equations.matrix.iter_mut().flatten().chain(&mut equations.forcing);
        for entry in entries {
            *entry = without[entry];
        }
        equations.gauss = None;
        equations.required.clear();
        Some(equations)
    }
}

/// Summand of a sum and its numerical factor.
///
/// # Panics
/// If the term is not a summand of this arena's sum.
#[must_use]
pub fn summand(arena: &Arena, term: SumTerm) -> (Expr, Rational) {
    match arena.node(term.sum) {
        Node::Sum(_, terms) => terms[term.index].clone(),
        _ => unreachable!("a summand belongs to a sum"),
    }
}

/// Subterms of the terms `roots`, operands first. Arguments of functions are left out.
fn subterms_outside_functions(arena: &Arena, roots: &[Expr]) -> Vec<Expr> {
    let mut seen: FxHashSet<Expr> = roots.iter().copied().collect();
    let mut waiting: Vec<Expr> = seen.iter().copied().collect();
    while let Some(e) = waiting.pop() {
        if !matches!(arena.node(e), Node::Apply(..)) {
            waiting.extend(arena.operands(e).filter(|operand| seen.insert(*operand)));
        }
    }
    let mut list: Vec<Expr> = seen.into_iter().collect();
    list.sort_unstable();
    list
}

/// Equations in which each defined symbol is replaced by its term. The list of definitions stays, for outputs of a
/// scene that contain these symbols.
fn without_definitions(arena: &mut Arena, equations: &Equations) -> Equations {
    let mut result = equations.clone();
    if equations.definitions.is_empty() {
        return result;
    }
    let mut written = Substitution::new(&[]);
    for Definition { symbol, value } in &equations.definitions {
        let value = written.apply(arena, *value);
        written.set(*symbol, value);
    }
    result.change_terms(&mut |e, arena| *e = written.apply(arena, *e), arena);
    result.definitions.clone_from(&equations.definitions);
    result
}
