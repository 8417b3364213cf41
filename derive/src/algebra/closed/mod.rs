//! Systems of equations solved in closed form, where exact algebra solves them: by factors, and an unknown at a time.
//!
//! An unknown is solved for where a factor of an equation is linear in it, linear or quadratic in its square, linear or quadratic in its
//! cosine or its sine alone, or linear in both; angles also where two sines or cosines cancel. What is found is put back into the equations that were given, and what does not
//! vanish there by exact algebra is shown as a condition: nothing is claimed that is not proved, and nothing is hidden.
//!
//! Work is counted: [`MOST_STEPS`], [`MOST_BRANCHES`] and multiplications of terms. Absent on purpose: Gröbner bases and resultants, whose results nobody
//! reads, and any knowledge of what the unknowns are.

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

use super::normal::Normalizer;
use super::{Arena, Expr};
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
    /// What must vanish, in factors, nothing being divided by.
    pub equations: Vec<Expr>,
    /// What the equations as they were given divide by: they say nothing where it is 0.
    pub divided_by: Vec<Expr>,
    /// How many equations have no normal form within the budget: nothing is solved then.
    pub too_large: usize,
    /// All solutions where no divisor is 0, as far as they were found.
    pub branches: Vec<Branch>,
    /// Whether a search ended before it had all branches.
    pub is_cut: bool,
}

/// Solves equations, each a term that must vanish, for unknowns: those that come first in the list rather than later ones, where they can be had
/// alike. `asked` of them, from the first, are preferred whatever it costs. The divisors are not 0.
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
