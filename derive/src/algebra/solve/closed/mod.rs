//! Systems of equations solved in closed form, where exact algebra solves them: by factors, and an unknown at a time.
//!
//! An unknown is solved for where a factor of an equation is linear in it, linear or quadratic in its square, linear or
//! quadratic in its cosine or its sine alone, or linear in both. Angles are also solved for where two sines or cosines
//! cancel. Each solution is put back into the given equations. Terms that exact algebra does not reduce to 0 there are
//! shown as conditions: only proved results are claimed, and nothing is hidden.
//!
//! The work is counted: [`MOST_STEPS`], [`MOST_BRANCHES`] and multiplications of terms. Absent on purpose: Gröbner
//! bases and resultants, whose results nobody reads, and any knowledge of the meaning of the unknowns.

mod branches;
mod ends;
mod factors;
mod isolate;
mod put;
mod relation;
mod roots;
mod waves;
mod work;

pub use relation::{Branch, Kind, Need, Relation};

use crate::algebra::form::normal::Normalizer;
use crate::algebra::{Arena, Expr};
use branches::Search;
use work::Work;

/// Steps of a search: a product split, or an unknown solved for.
pub const MOST_STEPS: usize = 200;
/// Branches that are followed to their ends.
pub const MOST_BRANCHES: usize = 32;
/// Multiplications of terms that one system may cost.
pub const BUDGET: u64 = 2 * Normalizer::BUDGET;

/// A system with its solutions.
#[derive(Clone, Debug, Default)]
pub struct Solutions {
    /// Terms that must vanish, in factors and without divisors.
    pub equations: Vec<Expr>,
    /// Divisors of the equations as they were given: the equations say nothing where one of these is 0.
    pub divided_by: Vec<Expr>,
    /// Number of equations that have no normal form within the budget; if it is not 0, nothing is solved.
    pub too_large: usize,
    /// All solutions where no divisor is 0, as far as they were found.
    pub branches: Vec<Branch>,
    /// True if the search ended before it had found all branches.
    pub is_cut: bool,
}

/// Solves equations, each a term that must vanish, for unknowns. Where several can be solved for, those that come first
/// in the list are chosen. The first `asked` of them are preferred at any cost. The divisors are taken not to be 0.
pub fn solve(arena: &mut Arena, equations: &[Expr], unknowns: &[Expr], asked: usize, divisors: &[Expr]) -> Solutions {
    let mut work = Work::new(arena, unknowns, asked);
    work.normalizer.prepare(work.arena, &[equations, divisors].concat());
    let found = Search::new(&mut work, equations, divisors).run();
    // Half a solution in functions of what is open beside it is harder to read than what it solves.
    if !found.is_cut && found.branches.iter().all(|branch| !branch.left.is_empty()) {
        work.keeps_tangents = false;
        return Search::new(&mut work, equations, divisors).run();
    }
    found
}

/// A term over one denominator, above and below in factors; as it is where that is too large.
pub fn in_factors(arena: &mut Arena, e: Expr) -> Expr {
    Work::new(arena, &[], 0).neat(e)
}
