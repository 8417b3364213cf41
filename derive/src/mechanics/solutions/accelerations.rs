//! Accelerations v̇ in closed form, as the solution of equations of motion.

use super::certificate::{Certificate, certify_accelerations};
use super::jacobian::{Jacobian, jacobian};
use crate::algebra::form::simplify::{Simplifier, operation_count_of_all};
use crate::algebra::solve::elimination::{Elimination, LinearSystem, divisors, eliminate};
use crate::algebra::solve::linear::Singular;
use crate::algebra::solve::quadratic_minimum::minimize_quadratic_form;
use crate::algebra::term::calculus::Differential;
use crate::algebra::term::steps::{Definition, needed_steps};
use crate::algebra::text::definitions::write_definitions;
use crate::algebra::{Arena, Expr};
use crate::mechanics::equations::Equations;
use crate::mechanics::rows::AccelerationEmbedding;
use crate::mechanics::unsolved::Unsolved;
use rustc_hash::FxHashSet;

/// Accelerations v̇ that solve equations of motion, with their Jacobian and the proof.
#[derive(Clone, Debug)]
pub struct SolvedAccelerations {
    /// Accelerations v̇ as a list of definitions, each of which may contain symbols of earlier definitions.
    pub accelerations: Elimination,
    /// Jacobian ∂(q̇, v̇)/∂(q, v) of the rates q̇ and v̇ with respect to the state (q, v).
    pub jacobian: Jacobian,
    /// Evidence that the accelerations and the Jacobian satisfy the equations of motion.
    pub certificate: Certificate,
}

impl SolvedAccelerations {
    /// Solves the equations, whose terms are in `arena`, for v̇ and proves the solution from the equations.
    ///
    /// # Errors
    /// Returns [`Unsolved`] if v̇ is not determined in any configuration, or if the proof fails.
    pub fn new(arena: &mut Arena, equations: &Equations) -> Result<Self, Unsolved> {
        let mut simplifier = Simplifier::default();
        let equations = &equations.with_definitions(arena);
        let accelerations = solve_for_accelerations(arena, &mut simplifier, equations)?;
        let jacobian = jacobian(arena, &mut simplifier, equations, &accelerations);
        let certificate = certify_accelerations(arena, equations, &accelerations, Some(&jacobian))?;
        Ok(Self { accelerations, jacobian, certificate })
    }

    /// Definitions that compute v̇, and those that q̇ and the energies need. The equations must be [in written
    /// form][Equations::with_definitions].
    ///
    /// # Errors
    /// Returns [`Unsolved`], for the same reasons as [`Self::new`].
    pub fn steps(arena: &mut Arena, equations: &Equations) -> Result<Vec<Definition>, Unsolved> {
        let solved = accelerations(arena, &mut Simplifier::default(), equations)?;
        let energies = [equations.kinetic_energy, equations.potential_energy, equations.power];
        let unknowns = &equations.unknowns[..equations.variables.len()];
        Ok(needed_steps(arena, &solved.steps, &[unknowns, &equations.coordinate_rates, &energies].concat()))
    }
}

/// Solves equations for the accelerations v̇ as terms in parameters, q and v, and proves the solution. The result is
/// a list of definitions; the last entries define the unknowns of `equations`.
///
/// # Errors
/// Returns [`Unsolved`] if v̇ is not determined in any configuration, or if the proof fails.
pub fn accelerations(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    equations: &Equations,
) -> Result<Elimination, Unsolved> {
    let solved = solve_for_accelerations(arena, simplifier, equations)?;
    certify_accelerations(arena, equations, &solved, None)?;
    Ok(solved)
}

/// Solves for v̇ by elimination or by the recursion from Gauss's principle. The method with fewer operations is
/// chosen.
///
/// With reactions among the unknowns, the rows are first multiplied by the partial velocities. Then the reactions
/// cancel, since they do no work in a permitted motion. The remaining system is symmetric and positive definite, so
/// no pivot vanishes. The multipliers of motion constraints cancel in the same way, which leaves a system for the
/// free accelerations. Elimination of the reactions would instead divide by direction cosines, which do vanish.
///
/// # Errors
/// Returns [`Singular`] if v̇ is not determined in any configuration.
fn solve_for_accelerations(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    equations: &Equations,
) -> Result<Elimination, Singular> {
    let n = equations.variables.len();
    let unknowns = &equations.unknowns[..n];
    let Some(gauss) = &equations.gauss else { return accelerations_by_elimination(arena, simplifier, equations) };
    // Both methods are tried, each in its own arena, so that the names of the rejected method stay
    // free.
    let mut other = arena.clone();
    let Some(recursion) = minimize_quadratic_form(&mut other, &mut simplifier.clone(), gauss, unknowns) else {
        return accelerations_by_elimination(arena, simplifier, equations);
    };
    let (recursion, _) = write_definitions(&mut other, &recursion, &[]);
    let mut steps = needed_steps(&other, &equations.definitions, &equations.coordinate_rates);
    let known: FxHashSet<Expr> = steps.iter().map(|step| step.symbol).collect();
    steps.extend(recursion.into_iter().filter(|step| !known.contains(&step.symbol)));
    let recursive = operation_count(&other, &steps, unknowns);
    let divisors = divisors(&other, &steps.iter().map(|step| step.value).collect::<Vec<_>>());
    let recursion = Elimination { steps, divisors };
    if acceleration_elimination_cost(&equations.matrix) > MOST_TIMES * recursive {
        *arena = other;
        return Ok(recursion);
    }
    let (mut store, mut its_simplifier) = (arena.clone(), simplifier.clone());
    let solved = accelerations_by_elimination(&mut store, &mut its_simplifier, equations)?;
    if recursive >= operation_count(&store, &solved.steps, unknowns) {
        (*arena, *simplifier) = (store, its_simplifier);
        return Ok(solved);
    }
    *arena = other;
    Ok(recursion)
}

/// Largest ratio of an elimination's operations to the recursion's for which an elimination is tried. The
/// elimination's operations are counted without cancellation, which has never saved more than this ratio.
const MOST_TIMES: usize = 2;

/// Number of multiplications and subtractions that eliminate a symmetric matrix with the given zeros, without square
/// roots. The order is from the last unknown, a leaf of the tree, to the first.
fn acceleration_elimination_cost(matrix: &[Vec<Expr>]) -> usize {
    let mut is_full: Vec<Vec<bool>> = matrix.iter().map(|row| row.iter().map(|e| *e != Expr::ZERO).collect()).collect();
    let mut count = 0;
    for pivot in (0..matrix.len()).rev() {
        let row: Vec<usize> = (0..pivot).filter(|at| is_full[pivot][*at]).collect();
        for (at, i) in row.iter().enumerate() {
            for j in &row[..=at] {
                is_full[*i][*j] = true;
                count += 2;
            }
            is_full[*i][pivot] = true;
        }
    }
    count
}

/// Definitions of the equations that do not depend on the unknowns v̇. Definitions of inverse dynamics depend on v̇
/// and are left out.
fn definitions_without_accelerations(arena: &Arena, equations: &Equations) -> Vec<Definition> {
    let mut sought: FxHashSet<Expr> = equations.unknowns.iter().copied().collect();
    let mut list = Vec::with_capacity(equations.definitions.len());
    for definition in &equations.definitions {
        if arena.reachable(&[definition.value]).iter().any(|part| sought.contains(part)) {
            sought.insert(definition.symbol);
        } else {
            list.push(*definition);
        }
    }
    list
}

/// Number of operations in the definitions that the given symbols need. A shared subterm counts once.
fn operation_count(arena: &Arena, steps: &[Definition], symbols: &[Expr]) -> usize {
    operation_count_of_all(
        arena,
        &needed_steps(arena, steps, symbols).iter().map(|step| step.value).collect::<Vec<_>>(),
    )
}

/// Solves for v̇ by elimination of the linear system. If reactions or multipliers are among the unknowns, the rows
/// are projected first. Returns `Singular` if v̇ is not determined in any configuration.
fn accelerations_by_elimination(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    equations: &Equations,
) -> Result<Elimination, Singular> {
    let n = equations.variables.len();
    let unknowns = &equations.unknowns[..n];
    // Without speeds no row is left, and the embedding alone gives the rates.
    if equations.projection.is_empty() && !equations.generalized_speeds.is_empty() {
        let system = LinearSystem {
            matrix: &equations.matrix,
            right: &equations.forcing,
            unknowns,
            symmetric: equations.symmetric,
            is_large: equations.is_large(),
        };
        let mut solved = eliminate(arena, simplifier, system)?;
        solved.steps.splice(0..0, definitions_without_accelerations(arena, equations));
        return Ok(solved);
    }
    let (mut matrix, mut right) = (Vec::new(), Vec::new());
    for multipliers in &equations.projection {
        let column = |c: usize| equations.matrix.iter().map(move |row| row[c]);
        let row: Vec<Expr> =
            (0..n).map(|c| combine_for_accelerations(arena, simplifier, multipliers, column(c))).collect();
        let value = combine_for_accelerations(arena, simplifier, multipliers, equations.forcing.iter().copied());
        let Some(embedding) = &equations.embedding else {
            matrix.push(row);
            right.push(value);
            continue;
        };
        // (Wᵀ E W) s = Wᵀ (f − E x).
        let known = combine_for_accelerations(arena, simplifier, &row, embedding.rest.iter().copied());
        let columns = (0..embedding.free.len()).map(|s| {
            let of_free = embedding.matrix.iter().map(|line| line[s]);
            combine_for_accelerations(arena, simplifier, &row, of_free)
        });
        matrix.push(columns.collect());
        right.push(arena.sub(value, known));
    }
    let is_large = equations.is_large();
    let solved_for = equations.embedding.as_ref().map_or(unknowns, |embedding| embedding.free.as_slice());
    let system = LinearSystem { matrix: &matrix, right: &right, unknowns: solved_for, symmetric: true, is_large };
    let mut solved = eliminate(arena, simplifier, system)?;
    if let Some(AccelerationEmbedding { free, matrix, rest }) = &equations.embedding {
        for ((unknown, row), rest) in unknowns.iter().zip(matrix).zip(rest) {
            let moved = combine_for_accelerations(arena, simplifier, row, free.iter().copied());
            solved.steps.push(Definition { symbol: *unknown, value: arena.add(moved, *rest) });
        }
    }
    solved.steps.splice(0..0, definitions_without_accelerations(arena, equations));
    Ok(solved)
}

/// Simplified sum Σ multiplier · entry over two lists of equal length.
fn combine_for_accelerations(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    multipliers: &[Expr],
    entries: impl Iterator<Item = Expr>,
) -> Expr {
    let products: Vec<Expr> = multipliers.iter().zip(entries).map(|(a, b)| arena.mul(*a, b)).collect();
    let sum = arena.sum(&products);
    simplifier.simplify(arena, sum)
}

/// Gradient ∂(T + V)/∂(q, v) of the total energy, with an entry for each q, then for each v. It is computed by the
/// chain rule over the definitions.
pub fn energy_gradient(arena: &mut Arena, simplifier: &mut Simplifier, equations: &Equations) -> Vec<Expr> {
    let energy = arena.add(equations.kinetic_energy, equations.potential_energy);
    let variables = equations.coordinates.iter().chain(&equations.variables);
    let slope = |x: &Expr| {
        let mut slope_of = Differential::partial(*x);
        for definition in &equations.definitions {
            let slope = slope_of.apply(arena, definition.value);
            slope_of.set_rate(definition.symbol, slope);
        }
        let slope = slope_of.apply(arena, energy);
        simplifier.simplify(arena, slope)
    };
    variables.map(slope).collect()
}
