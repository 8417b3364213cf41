//! Divisors of the equations of motion and of the loads that may vanish in a run.

use crate::algebra::solve::elimination::{Elimination, divisors};
use crate::algebra::term::calculus::Gradient;
use crate::algebra::term::steps::{Definition, needed_steps};
use crate::algebra::text::print::print_text;
use crate::algebra::value::range::range_excludes_zero;
use crate::algebra::{Arena, Expr, Node};
use crate::mechanics::equations::Equations;
use crate::model::Model;

/// Divisors in the equations of a run that depend on the state and may vanish. The equations have no value if a
/// divisor is zero, so a run must not step across such a state. Divisors that are proved never to be zero are left
/// out.
///
/// Pivots of an elimination are also left out, because pivots of a positive definite matrix never change sign.
#[derive(Clone, Debug, Default)]
pub struct Divisors {
    /// Definitions of the symbols that occur in [`Self::values`], in the order of computation.
    pub steps: Vec<Definition>,
    /// Distinct divisors, without powers and without numeric factors.
    pub values: Vec<Expr>,
}

impl Divisors {
    /// Finds the divisors of the equations. If `solved` is given, it takes those of the solved accelerations instead
    /// of those of the matrix and forcing.
    #[must_use]
    pub fn of(arena: &Arena, equations: &Equations, solved: Option<&Elimination>) -> Self {
        let e = equations;
        let mut wanted = e.coordinate_rates.clone();
        let steps = match solved {
            Some(solved) => {
                wanted.extend(&e.unknowns[..e.variables.len()]);
                needed_steps(arena, &solved.steps, &wanted)
            }
            None => {
                wanted.extend(e.matrix.iter().flatten().chain(&e.forcing));
                needed_steps(arena, &e.definitions, &wanted)
            }
        };
        let all: Vec<Expr> = steps.iter().map(|step| step.value).chain(wanted).collect();
        let moving = symbols_of_moving_divisors(arena, e, &steps);
        let moves = |divisor: &Expr| arena.reachable(&[*divisor]).iter().any(|part| moving.contains(part));
        let mut values: Vec<Expr> = Vec::new();
        let pivots = Pivots::new(arena, e, &steps, &moving);
        for divisor in divisors(arena, &all).into_iter().filter(|d| moves(d) && !pivots.contains(arena, *d)) {
            let bare = divisor_without_number(arena, divisor);
            if !values.contains(&bare) && !range_excludes_zero(arena, bare) {
                values.push(bare);
            }
        }
        Self { steps: needed_steps(arena, &steps, &values), values }
    }
}

/// Divisor of an applied load. The load has no value if its divisor is zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadDivisor {
    /// Name of the load in the model file.
    pub load: String,
    /// True if the load is a spring or damper between two points. Its divisor is zero if the points coincide.
    pub is_distance: bool,
    /// Divisor of the load, as a term that depends on the state.
    pub value: Expr,
}

impl LoadDivisor {
    /// Clause for the user about the state in which the divisor is zero, such as "the ends of the spring `s` meet".
    #[must_use]
    pub fn zero_divisor_meaning(&self) -> String {
        if self.is_distance {
            format!("the ends of the spring `{}` meet", self.load)
        } else {
            format!("the load `{}` divides by it", self.load)
        }
    }
}

/// Divisors of a model's loads that depend on the state and may be zero, in the order of the model file. They are
/// lengths of springs, divisors of quotients, and divisors of derivatives of potentials.
#[must_use]
pub fn load_divisors(arena: &mut Arena, model: &Model) -> Vec<LoadDivisor> {
    let forces = model.forces.iter().map(|f| (f.name.clone(), f.end.is_some(), f.vector.to_vec()));
    let torques = model.torques.iter().map(|t| (t.name.clone(), false, t.vector.to_vec()));
    let mut loads: Vec<(String, bool, Vec<Expr>)> = forces.chain(torques).collect();
    let mut gradient = Gradient::new(&model.q());
    for potential in &model.potentials {
        let slopes = gradient.apply(arena, potential.energy).iter().map(|(_, slope)| *slope).collect();
        loads.push((potential.name.clone(), false, slopes));
    }
    let fixed = model.p();
    let moves = |arena: &Arena, e: Expr| {
        let is_symbol = |part: &Expr| matches!(arena.node(*part), Node::Symbol(_));
        arena.reachable(&[e]).iter().any(|part| is_symbol(part) && !fixed.contains(part))
    };
    let mut list: Vec<LoadDivisor> = Vec::new();
    for (load, is_distance, values) in loads {
        for divisor in divisors(arena, &values) {
            let value = divisor_without_number(arena, divisor);
            if moves(arena, value) && !range_excludes_zero(arena, value) {
                let divisor = LoadDivisor { load: load.clone(), is_distance, value };
                if !list.contains(&divisor) {
                    list.push(divisor);
                }
            }
        }
    }
    list
}

/// Largest length, in bytes, of a formula that serves as the name of a divisor.
const LONGEST: usize = 80;

impl Divisors {
    /// Names of the divisors. A name is the divisor's formula, or its number if the formula is longer than 80 bytes.
    #[must_use]
    pub fn names(&self, arena: &Arena) -> Vec<String> {
        let name = |(at, value): (usize, &Expr)| {
            let formula = print_text(arena, *value);
            if formula.len() <= LONGEST { formula } else { format!("divisor {} of the accelerations", at + 1) }
        };
        self.values.iter().enumerate().map(name).collect()
    }
}

/// Test for pivots: decides if a divisor is a pivot of the elimination, which does not occur in the equations before.
struct Pivots<'a> {
    /// True if the eliminated matrix is symmetric and positive definite, so that its pivots are
    /// positive.
    is_definite: bool,
    /// Divisors that occur in the equations before the elimination.
    before: Vec<Expr>,
    /// Definitions of the solution, among which pivots are looked up by their symbol.
    steps: &'a [Definition],
    /// Symbols of the state, and of the definitions whose values depend on the state.
    moving: &'a [Expr],
}

impl<'a> Pivots<'a> {
    /// Creates the test: collects the divisors of the equations before the elimination.
    fn new(arena: &Arena, e: &Equations, steps: &'a [Definition], moving: &'a [Expr]) -> Self {
        let entries = e.matrix.iter().flatten().chain(&e.forcing).chain(&e.coordinate_rates);
        let values: Vec<Expr> = entries.copied().chain(e.definitions.iter().map(|d| d.value)).collect();
        let is_definite = e.symmetric || !e.projection.is_empty();
        Self { is_definite, before: divisors(arena, &values), steps, moving }
    }

    /// True if a divisor is a pivot: a sum that divides only in the elimination, perhaps with constant factors, or
    /// the symbol of such a sum.
    fn contains(&self, arena: &Arena, divisor: Expr) -> bool {
        let is_constant = |e: Expr| !arena.reachable(&[e]).iter().any(|part| self.moving.contains(part));
        let is_sum = |e: Expr| match arena.node(divisor_without_number(arena, e)) {
            Node::Sum(..) => true,
            Node::Product(factors) => factors
                .iter()
                .all(|(base, n)| is_constant(*base) || *n > 0 && matches!(arena.node(*base), Node::Sum(..))),
            _ => false,
        };
        match self.steps.iter().find(|step| step.symbol == divisor) {
            Some(step) => self.is_definite && is_sum(step.value),
            None => self.is_definite && is_sum(divisor) && !self.before.contains(&divisor),
        }
    }
}

/// Symbols of the state (q, v), and of the definitions whose values depend on the state.
fn symbols_of_moving_divisors(arena: &Arena, equations: &Equations, steps: &[Definition]) -> Vec<Expr> {
    let mut list: Vec<Expr> = equations.coordinates.iter().chain(&equations.variables).copied().collect();
    for step in steps {
        if arena.reachable(&[step.value]).iter().any(|part| list.contains(part)) {
            list.push(step.symbol);
        }
    }
    list
}

/// The divisor without its numeric factor: x for 2 x.
#[must_use]
pub fn divisor_without_number(arena: &Arena, divisor: Expr) -> Expr {
    match arena.node(divisor) {
        Node::Sum(constant, terms) if constant.is_zero() && terms.len() == 1 => terms[0].0,
        _ => divisor,
    }
}

/// Distinct divisors, which vanish in different configurations: without numeric factors, and without repetition.
#[must_use]
pub fn distinct_divisors(arena: &Arena, divisors: &[Expr]) -> Vec<Expr> {
    let mut list: Vec<Expr> = Vec::new();
    for &divisor in divisors {
        let bare = divisor_without_number(arena, divisor);
        if !list.contains(&bare) {
            list.push(bare);
        }
    }
    list
}
