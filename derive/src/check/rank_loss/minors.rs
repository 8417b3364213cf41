//! Minors of a constraint matrix and their common zeros: the poses in which constraints lose rank.
//!
//! A matrix has fewer than r independent rows exactly where all its r × r minors are zero (J. M.
//! Selig, *Geometric Fundamentals of Robotics*, 2nd edition (2005), § 4.6). The minors are computed
//! without divisions. Blocks of rows that share no column are treated separately: the whole matrix
//! loses rank where one of its blocks does.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::contraction::contract_products;
use crate::algebra::text::print::print_text;
use crate::algebra::value::range::range_excludes_zero;
use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr, Node};
use crate::mechanics::divisor_without_number;
use rustc_hash::FxHashSet;

/// Largest number of rows of a minor that is computed as a formula.
const MOST_ROWS: usize = 4;
/// Largest number of minors of one block of rows.
const MOST_MINORS: usize = 200;
/// Largest number of formulas of all blocks together.
const MOST_FORMULAS: usize = 20;
/// Largest number of characters of a formula that a proof shows.
const LONGEST: usize = 120;

/// Matrix of constraints, with data that proofs use: default values, loop equations and
/// coordinates.
pub struct Matrix<'a> {
    /// Rows of the matrix: the coefficients of the rates in each constraint.
    pub rows: &'a [Vec<Expr>],
    /// Number of rows at the beginning that are independent in most poses. The later rows depend on
    /// these rows, except in single poses.
    pub rank: usize,
    /// Symbols of the parameters with their default values, in SI units.
    pub known: &'a [(Expr, f64)],
    /// Left sides of the loop equations: terms that are zero in every closed pose.
    pub loops: &'a [Expr],
    /// Symbols of the coordinates. All other symbols are constant.
    pub places: &'a [Expr],
}

/// Poses where the rows of a constraint matrix lose rank, as common zeros of formulas.
pub struct RankLossSurfaces {
    /// Formulas that are all zero exactly in the poses where rank is lost. Empty if it is proved that
    /// no such pose exists.
    pub all_zero: Vec<Expr>,
    /// Sentences, one for each block of the matrix that never loses rank. Each names a term that is
    /// never zero.
    pub never: Vec<String>,
    /// Factors without coordinates that a proof assumes nonzero because they are nonzero at the default
    /// values.
    pub taken: Vec<Expr>,
}

/// Finds the poses where the rows of a constraint matrix lose rank; `None` if there are too many
/// minors.
pub fn common_zeros_of_minors(arena: &mut Arena, matrix: &Matrix<'_>) -> Option<RankLossSurfaces> {
    let mut found = RankLossSurfaces { all_zero: Vec::new(), never: Vec::new(), taken: Vec::new() };
    let mut sets: Vec<Vec<Expr>> = Vec::new();
    for part in blocks_of_minors(matrix) {
        let mut simplifier = Simplifier::default();
        let minors = minors(arena, &mut simplifier, matrix.rows, &part)?;
        let mut minors: Vec<Vec<(Expr, i32)>> =
            minors.into_iter().map(|minor| moving_factors(arena, matrix, minor, &mut found.taken)).collect();
        minors.sort();
        minors.dedup();
        let common = take_common_minor_factors(&mut minors);
        let mut left: Vec<Expr> = minors.iter().map(|factors| product(arena, factors)).collect();
        if let Some(proof) = prove_minors_not_all_zero(arena, &mut simplifier, &left, matrix, &mut found.taken) {
            if common.is_empty() {
                found.never.push(proof);
                continue;
            }
            left = vec![Expr::ONE];
        }
        let common = product(arena, &common);
        sets.push(left.iter().map(|e| arena.mul(common, *e)).collect());
    }
    found.taken.sort_unstable();
    found.taken.dedup();
    found.all_zero = products_of_minor_sets(arena, sets)?;
    Some(found)
}

/// Combines sets of formulas into one set. Its formulas are all zero exactly where all formulas of
/// at least one given set are zero: they are products. `None` if there are too many products.
fn products_of_minor_sets(arena: &mut Arena, sets: Vec<Vec<Expr>>) -> Option<Vec<Expr>> {
    let mut all: Vec<Expr> = Vec::new();
    for set in sets {
        if all.is_empty() {
            all = set;
            continue;
        }
        if all.len() * set.len() > MOST_FORMULAS {
            return None;
        }
        all = all
            .iter()
            .flat_map(|a| set.iter().map(|b| (*a, *b)).collect::<Vec<_>>())
            .map(|(a, b)| arena.mul(a, b))
            .collect();
    }
    Some(all)
}

/// Block of a constraint matrix: rows that are connected by common columns and share no column with
/// other rows.
struct Part {
    /// Indices of the rows of the block.
    rows: Vec<usize>,
    /// Indices of the columns in which rows of the block have entries.
    columns: Vec<usize>,
    /// Number of rows of the block that are independent in most poses.
    rank: usize,
}

/// Splits a constraint matrix into blocks that share no column. Blocks without an independent row
/// are left out.
fn blocks_of_minors(matrix: &Matrix<'_>) -> Vec<Part> {
    let mut list: Vec<Part> = Vec::new();
    for (at, row) in matrix.rows.iter().enumerate() {
        let columns: Vec<usize> = (0..row.len()).filter(|column| row[*column] != Expr::ZERO).collect();
        let mut part = Part { rows: vec![at], columns, rank: usize::from(at < matrix.rank) };
        let (shared, apart) =
            list.into_iter().partition(|other| other.columns.iter().any(|c| part.columns.contains(c)));
        list = apart;
        for other in shared as Vec<Part> {
            part.rows.extend(other.rows);
            part.columns.extend(other.columns);
            part.rank += other.rank;
        }
        part.columns.sort_unstable();
        part.columns.dedup();
        part.rows.sort_unstable();
        list.push(part);
    }
    // A block without an independent row restricts no motion.
    list.retain(|part| part.rank > 0);
    list
}

/// Nonzero minors of a block of rows, each once; `None` if there are more than `MOST_MINORS`, or if
/// they have too many rows.
fn minors(arena: &mut Arena, simplifier: &mut Simplifier, rows: &[Vec<Expr>], part: &Part) -> Option<Vec<Expr>> {
    let choices = |n: usize| (0..part.rank).fold(1_usize, |count, k| count.saturating_mul(n - k) / (k + 1));
    if part.rank > MOST_ROWS || choices(part.rows.len()).saturating_mul(choices(part.columns.len())) > MOST_MINORS {
        return None;
    }
    let mut found = Vec::new();
    for chosen in combinations(&part.rows, part.rank) {
        for columns in combinations(&part.columns, part.rank) {
            let minor = minor(arena, rows, &chosen, &columns);
            let minor = simplifier.simplify(arena, minor);
            if minor != Expr::ZERO && !found.contains(&minor) {
                found.push(minor);
            }
        }
    }
    Some(found)
}

/// All subsets of `count` items, each in the order of the items.
fn combinations(items: &[usize], count: usize) -> Vec<Vec<usize>> {
    let Some(left) = count.checked_sub(1) else { return vec![Vec::new()] };
    let with = |at: usize| {
        combinations(&items[at + 1..], left).into_iter().map(move |rest| [&[items[at]], rest.as_slice()].concat())
    };
    (0..items.len().saturating_sub(left)).flat_map(with).collect()
}

/// Determinant of the submatrix with the rows `chosen` and the columns `columns`, expanded along
/// its first row.
fn minor(arena: &mut Arena, rows: &[Vec<Expr>], chosen: &[usize], columns: &[usize]) -> Expr {
    let Some((first, rest)) = chosen.split_first() else { return Expr::ONE };
    let mut terms = Vec::new();
    for (at, column) in columns.iter().enumerate().filter(|(_, column)| rows[*first][**column] != Expr::ZERO) {
        let others: Vec<usize> = columns.iter().copied().filter(|other| other != column).collect();
        let below = minor(arena, rows, rest, &others);
        let term = arena.mul(rows[*first][*column], below);
        terms.push(if at % 2 == 0 { term } else { arena.neg(term) });
    }
    arena.sum(&terms)
}

/// Factors of a minor that may be zero in a pose, each with the power 1. A factor without
/// coordinates is left out if it is nonzero at the default values; it is then added to `taken`.
fn moving_factors(arena: &mut Arena, matrix: &Matrix<'_>, minor: Expr, taken: &mut Vec<Expr>) -> Vec<(Expr, i32)> {
    let minor = contract_products(arena, minor);
    let minor = divisor_without_number(arena, minor);
    let factors = match arena.node(minor) {
        Node::Product(factors) => factors.to_vec(),
        _ => vec![(minor, 1)],
    };
    let mut moving = Vec::new();
    for (base, _) in factors.into_iter().filter(|(_, n)| *n > 0) {
        let (_, base) = arena.split_content(base);
        if base != Expr::ONE && !is_nonzero(arena, matrix, base, taken) {
            moving.push((base, 1));
        }
    }
    moving.sort();
    moving
}

/// Value of a term without coordinates, at the default values of the parameters; `None` if a
/// parameter has no default.
fn value(arena: &Arena, e: Expr, known: &[(Expr, f64)]) -> Option<f64> {
    let (inputs, values): (Vec<Expr>, Vec<f64>) = known.iter().copied().unzip();
    Some(Tape::new(arena, &inputs, &[e]).ok()?.evaluate(&values)[0])
}

/// Removes the factors that all products have in common, and returns these factors.
fn take_common_minor_factors(all: &mut [Vec<(Expr, i32)>]) -> Vec<(Expr, i32)> {
    let Some((first, others)) = all.split_first() else { return Vec::new() };
    let common: FxHashSet<(Expr, i32)> =
        first.iter().copied().filter(|factor| others.iter().all(|other| other.contains(factor))).collect();
    for factors in all.iter_mut() {
        factors.retain(|factor| !common.contains(factor));
    }
    let mut common: Vec<(Expr, i32)> = common.into_iter().collect();
    common.sort();
    common
}

/// Product of factors with positive powers, as a term.
fn product(arena: &mut Arena, factors: &[(Expr, i32)]) -> Expr {
    arena.try_product(factors).expect("positive powers")
}

/// Proves that the given terms are never all zero, and returns the proof in words. Either one term
/// is never zero, or the sum of all squares is never zero. A multiple of a loop equation, which is
/// zero in closed poses, may be subtracted from the sum. `None` if no proof is found.
fn prove_minors_not_all_zero(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    terms: &[Expr],
    matrix: &Matrix<'_>,
    taken: &mut Vec<Expr>,
) -> Option<String> {
    if terms.contains(&Expr::ONE) {
        return Some("one of its minors is a constant".to_owned());
    }
    if let Some(term) = terms.iter().find(|term| range_excludes_zero(arena, **term)) {
        return Some(nonzero_minor_sentence(arena, "one of its minors", *term));
    }
    let squares: Vec<Expr> = terms.iter().map(|term| arena.square(*term)).collect();
    let sum = arena.sum(&squares);
    let sum = simplifier.simplify(arena, sum);
    let what = "the sum of the squares of its minors";
    if is_nonzero(arena, matrix, sum, taken) {
        return Some(nonzero_minor_sentence(arena, what, sum));
    }
    matrix.loops.iter().find_map(|equation| {
        let left = minor_sum_less_multiple(arena, simplifier, sum, *equation)?;
        is_nonzero(arena, matrix, left, taken)
            .then(|| nonzero_minor_sentence(arena, &format!("{what}, in closed poses"), left))
    })
}

/// Sentence which says that a term is never 0; `what` describes the term. A long formula is not
/// shown.
fn nonzero_minor_sentence(arena: &Arena, what: &str, e: Expr) -> String {
    let formula = print_text(arena, e);
    if formula.len() > LONGEST { format!("{what} is never 0") } else { format!("{what}, {formula}, is never 0") }
}

/// True if a term is nonzero in every pose. This is proved by its range, or the term has no
/// coordinates and is nonzero at the default values. In the second case the term is added to
/// `taken`.
fn is_nonzero(arena: &Arena, matrix: &Matrix<'_>, e: Expr, taken: &mut Vec<Expr>) -> bool {
    if range_excludes_zero(arena, e) {
        return true;
    }
    let moves = matrix.places.iter().any(|place| arena.mentions(e, *place));
    let is_taken = !moves && value(arena, e, matrix.known).is_some_and(|x| x.is_finite() && x != 0.0);
    taken.extend(is_taken.then_some(e));
    is_taken
}

/// Difference of the sum `sum` and a multiple of the sum `other`, in which a common term of both
/// cancels. `None` if they have no common term.
fn minor_sum_less_multiple(arena: &mut Arena, simplifier: &mut Simplifier, sum: Expr, other: Expr) -> Option<Expr> {
    let terms = |arena: &Arena, e: Expr| match arena.node(e) {
        Node::Sum(_, terms) => terms.to_vec(),
        _ => Vec::new(),
    };
    let (of_sum, of_other) = (terms(arena, sum), terms(arena, other));
    let (k, by) = of_other.iter().find_map(|(term, by)| {
        let (_, k) = of_sum.iter().find(|(own, _)| own == term)?;
        Some((k.clone(), by.clone()))
    })?;
    let multiple = k.mul(&by.reciprocal()?);
    let shift = arena.scale(other, &multiple);
    let left = arena.sub(sum, shift);
    Some(simplifier.simplify(arena, left))
}
