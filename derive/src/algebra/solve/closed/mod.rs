//! Solutions of systems of equations in closed form, found by exact algebra. Each factor of an
//! equation is solved for one unknown at a time.
//!
//! A factor can be solved for an unknown if it is linear or quadratic in one of these: the unknown,
//! its square, its cosine, its sine. It can also be linear in both sine and cosine. Angles are also
//! solved for if two sines or cosines cancel.
//!
//! Each solution is inserted into the given equations. Terms that exact algebra does not reduce to
//! 0 there are shown as conditions: only proved results are claimed, and nothing is hidden.
//!
//! The work is counted: [`MOST_STEPS`], [`MOST_BRANCHES`] and multiplications of terms. Absent on
//! purpose: Gröbner bases and resultants, whose results nobody reads, and any knowledge of the
//! meaning of the unknowns.

mod branch_search;
mod factors;
mod isolation;
mod relation;
mod square_roots;
mod substitution;
mod verification;
mod waves;
mod workspace;

pub use relation::{Branch, Relation, RelationCondition, RelationKind};

use crate::algebra::form::normal_form::Normalizer;
use crate::algebra::{Arena, Expr};
use branch_search::BranchSearch;
use workspace::Workspace;

/// Largest number of steps of a search for solutions. A step splits a product or solves for an
/// unknown.
pub const MOST_STEPS: usize = 200;
/// Largest number of branches of solutions that a search returns.
pub const MOST_BRANCHES: usize = 32;
/// Largest number of multiplications of terms for solving one system.
pub const BUDGET: u64 = 2 * Normalizer::BUDGET;

/// Solutions of a system of equations in closed form, with the equations as factored terms.
#[derive(Clone, Debug, Default)]
pub struct Solutions {
    /// Left-hand sides of the equations, which must be 0, in factors and without divisors.
    pub equations: Vec<Expr>,
    /// Divisors of the given equations. The solutions are not valid where a divisor is 0.
    pub divided_by: Vec<Expr>,
    /// Number of equations that have no normal form within the budget. If it is not 0, no equation
    /// is solved.
    pub too_large: usize,
    /// Branches of solutions where no divisor of the equations is 0. If `is_cut` is true, there may
    /// be more.
    pub branches: Vec<Branch>,
    /// True if the search ended before it had found all branches.
    pub is_cut: bool,
}

/// Solves equations in closed form. Each equation is a term that must be 0; the divisors are
/// assumed not to be 0.
///
/// The system is solved for the first `asked` unknowns if possible. Among equally good choices,
/// unknowns that come first in the list are solved for.
pub fn solve_in_closed_form(
    arena: &mut Arena,
    equations: &[Expr],
    unknowns: &[Expr],
    asked: usize,
    divisors: &[Expr],
) -> Solutions {
    let mut work = Workspace::new(arena, unknowns, asked);
    work.normalizer.prepare(work.arena, &[equations, divisors].concat());
    let found = BranchSearch::new(&mut work, equations, divisors).run();
    // A partial solution in functions of an unsolved unknown is harder to read than the equation.
    if !found.is_cut && found.branches.iter().all(|branch| !branch.left.is_empty()) {
        work.keeps_tangents = false;
        return BranchSearch::new(&mut work, equations, divisors).run();
    }
    found
}

/// Writes a term as a fraction with numerator and denominator in factors. A term that is too large
/// is only brought to short form.
pub fn factored_fraction(arena: &mut Arena, e: Expr) -> Expr {
    Workspace::new(arena, &[], 0).short_form_in_factors(e)
}
