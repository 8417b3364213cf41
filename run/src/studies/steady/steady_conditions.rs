//! Conditions of rest and of steady motion in closed form: expressions that must be zero, and exact
//! solutions where algebra finds them.

use super::steady_state::SteadyState;
use crate::{Error, Mechanism};
use std::f64::consts::TAU;
use tripos_derive::algebra::solve::closed::{Branch, Relation, RelationCondition, RelationKind, factored_fraction};
use tripos_derive::algebra::text::print::{latex, print_text};
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::flow::Steadiness;
use tripos_traits::DoubleDouble;

/// Difference up to which a number and the value of a formula count as equal, relative to the number or
/// to 1, whichever is larger.
const NEAR: f64 = 1e-9;

/// Formula as text in two notations: the notation of model files, and LaTeX.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Formula {
    /// Formula in the notation of model files.
    pub text: String,
    /// Formula in LaTeX for math mode, without dollar signs.
    pub latex: String,
}

/// Equation `name` = `value`, with both sides as formulas.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedFormula {
    /// Left side: an unknown, its square, or its sine, cosine or tangent.
    pub name: Formula,
    /// Right side: the value of the left side.
    pub value: Formula,
}

/// Velocity along a symmetry of the mechanism, a symbol in the conditions of steady motion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Velocity {
    /// Symbol of the velocity. If the velocity is the rate of a coordinate, it is the name of this rate,
    /// such as `q1'`.
    pub name: String,
    /// Text that describes how the mechanism moves along the symmetry.
    pub along: String,
    /// True if the velocity is the rate of a coordinate; false if it has a symbol of its own.
    pub is_rate: bool,
}

/// Branch of the solutions of the conditions of rest or steady motion, as formulas. Angles are
/// determined up to whole turns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SolutionBranch {
    /// Formulas of the unknowns that are solved for, in terms of the free unknowns and the parameters.
    pub solved: Vec<NamedFormula>,
    /// Conditions under which the solved unknowns are real, such as `l*cos(q) >= 0`.
    pub needs: Vec<Formula>,
    /// Divisors of the formulas, which must not be 0.
    pub divided_by: Vec<Formula>,
    /// Further expressions that must be zero, but could not be solved.
    pub left: Vec<Formula>,
    /// Branch as expressions in the arena, for evaluation at numbers.
    branch: Branch,
}

/// Conditions of rest, or of steady motion along symmetries, in closed form.
#[derive(Clone, Debug)]
pub struct Conditions {
    /// True for conditions of rest, with all velocities 0; false for conditions of steady motion.
    pub rest: bool,
    /// Velocities along the symmetries; empty for conditions of rest.
    pub along: Vec<Velocity>,
    /// Generalized speeds as formulas in the coordinates and the velocities `along`.
    pub speeds: Vec<NamedFormula>,
    /// Names of the velocities, coordinates and parameters to solve for, in the order of preference.
    pub unknowns: Vec<String>,
    /// Expressions that must be zero.
    pub equations: Vec<Formula>,
    /// Number of further conditions that are too large to be readable.
    pub too_large: usize,
    /// Divisors of the conditions. The conditions do not hold where a divisor is 0.
    pub divided_by: Vec<Formula>,
    /// Branches of solutions at which no divisor is 0. Each is proved by substitution. If `complete` is
    /// true, there are no further branches.
    pub branches: Vec<SolutionBranch>,
    /// True if the search for branches ended within its budget, so that no branch is missing.
    pub complete: bool,
    /// Symbols of the parameters, coordinates and velocities, in this order.
    symbols: Vec<Expr>,
}

/// Conditions of rest and of steady motion of a mechanism, in closed form.
#[derive(Clone)]
pub struct SteadyConditions {
    /// Conditions of rest, followed by conditions of steady motion if the mechanism has symmetries.
    pub list: Vec<Conditions>,
    /// Arena that contains the expressions of all branches.
    arena: Arena,
    /// Tells for each coordinate if it is an angle.
    is_angle: Vec<bool>,
}

/// Derives the conditions of rest and of steady motion in closed form, and solves them where exact
/// algebra can. `asked` are the names of the velocities, coordinates and parameters that are preferred
/// as unknowns. A parameter is an unknown only if it is named.
///
/// # Errors
/// [`Error`] if the model cannot be derived or depends on time, or if it has no quantity with a name in
/// `asked`.
pub fn conditions(model: &Mechanism, asked: &[String]) -> Result<SteadyConditions, Error> {
    let mut flow = super::steady_flow(model)?;
    let mut balances = vec![flow.steady_balance(model, Steadiness::Rest)];
    if flow.symmetries.len() > usize::from(flow.time_shift_symmetry(model).is_some()) {
        balances.push(flow.steady_balance(model, Steadiness::SteadyMotion));
    }
    let velocities: Vec<Expr> = balances.iter().flat_map(|balance| &balance.along).map(|along| along.symbol).collect();
    let known: Vec<Expr> = velocities.into_iter().chain(model.q()).chain(model.p()).collect();
    let place = |name: &String| {
        let found = known.iter().copied().find(|e| flow.arena.symbol_name(*e) == Some(name.as_str()));
        found.ok_or_else(|| {
            let names = known.iter().filter_map(|e| flow.arena.symbol_name(*e));
            let help = tripos_derive::diagnostic::nearest_name_advice(name, names);
            Error::request(format!("`{name}` is no coordinate, velocity or parameter to solve for"), help)
        })
    };
    let asked = asked.iter().map(place).collect::<Result<Vec<Expr>, Error>>()?;
    let mut list = Vec::new();
    for balance in &balances {
        let speeds: Vec<Expr> = balance.speeds.iter().map(|u| factored_fraction(&mut flow.arena, *u)).collect();
        let (unknowns, found) = flow.steady_balance_in_closed_form(model, balance, &asked);
        let arena = &mut flow.arena;
        let name = |arena: &Arena, e: Expr| arena.symbol_name(e).unwrap_or_default().to_owned();
        let along = balance.along.iter().map(|along| Velocity {
            name: name(arena, along.symbol),
            along: flow.symmetries[along.symmetry].words(model),
            is_rate: along.is_rate,
        });
        let along: Vec<Velocity> = along.collect();
        let told = |arena: &Arena, (e, value): (Expr, &Expr)| NamedFormula {
            name: condition_formula(arena, e),
            value: condition_formula(arena, *value),
        };
        let speeds = model.u().into_iter().zip(&speeds).map(|pair| told(arena, pair)).collect();
        let branches = found.branches.into_iter().map(|branch| steady_solution_branch(arena, branch)).collect();
        list.push(Conditions {
            rest: balance.along.is_empty(),
            along,
            speeds,
            unknowns: unknowns.iter().map(|e| name(arena, *e)).collect(),
            equations: found.equations.iter().map(|e| condition_formula(arena, *e)).collect(),
            too_large: found.too_large,
            divided_by: found.divided_by.iter().map(|e| condition_formula(arena, *e)).collect(),
            branches,
            complete: !found.is_cut,
            symbols: model.p().into_iter().chain(model.q()).chain(balance.along.iter().map(|a| a.symbol)).collect(),
        });
    }
    let is_angle = model.coordinates.iter().map(|c| c.unit.is_plain()).collect();
    Ok(SteadyConditions { list, arena: flow.arena, is_angle })
}

/// Writes an expression as text in the notation of model files and in LaTeX.
fn condition_formula(arena: &Arena, e: Expr) -> Formula {
    Formula { text: print_text(arena, e), latex: latex(arena, e) }
}

/// Left side of a solved relation: the unknown, its square, or its sine, cosine or tangent.
fn condition_left_side(arena: &mut Arena, relation: &Relation) -> Expr {
    match relation.kind {
        RelationKind::Value => relation.unknown,
        RelationKind::Square => arena.square(relation.unknown),
        RelationKind::Sine => arena.sin(relation.angle),
        RelationKind::Cosine => arena.cos(relation.angle),
        RelationKind::Tangent => {
            let (sine, cosine) = (arena.sin(relation.angle), arena.cos(relation.angle));
            arena.div(sine, cosine).unwrap_or(sine)
        }
    }
}

/// Writes a branch of solutions as formulas in both notations.
fn steady_solution_branch(arena: &mut Arena, branch: Branch) -> SolutionBranch {
    let mut list = Vec::new();
    for relation in &branch.solved {
        let subject = condition_left_side(arena, relation);
        list.push(NamedFormula {
            name: condition_formula(arena, subject),
            value: condition_formula(arena, relation.value),
        });
    }
    let need = |need: &RelationCondition| {
        let Formula { text, latex } = condition_formula(arena, need.term());
        match need {
            RelationCondition::NotNegative(_) => {
                Formula { text: format!("{text} >= 0"), latex: format!(r"{latex} \ge 0") }
            }
            RelationCondition::Unit(_) => {
                Formula { text: format!("abs({text}) <= 1"), latex: format!(r"\left|{latex}\right| \le 1") }
            }
        }
    };
    let all = |list: &[Expr]| list.iter().map(|e| condition_formula(arena, *e)).collect();
    SolutionBranch {
        solved: list,
        needs: branch.needs.iter().map(need).collect(),
        divided_by: all(&branch.divided_by),
        left: all(&branch.left),
        branch,
    }
}

/// Conditions that apply to a given steady motion, and the branches of solutions to which the motion
/// belongs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BranchesAt {
    /// Index of the conditions that apply, in [`SteadyConditions::list`].
    pub conditions: usize,
    /// Indices of the branches to which the motion belongs; empty if it belongs to none.
    pub branches: Vec<usize>,
}

impl SteadyConditions {
    /// Finds the conditions that apply to a steady motion, and the branches to which it belongs. The
    /// decision is numerical and proves nothing. `None` if the list has no conditions of rest, or of steady
    /// motion, for this motion.
    #[must_use]
    pub fn branches_at(&self, parameters: &[DoubleDouble], steady: &SteadyState) -> Option<BranchesAt> {
        let at = self.list.iter().position(|conditions| conditions.rest == steady.is_rest())?;
        let conditions = &self.list[at];
        let q = &steady.x[..self.is_angle.len()];
        let along = if conditions.rest { Vec::new() } else { steady.velocities() };
        let values = [parameters, q, &along].concat();
        let holds = |branch: &usize| self.satisfies_branch(conditions, &conditions.branches[*branch].branch, &values);
        let branches = (0..conditions.branches.len()).filter(holds).collect();
        Some(BranchesAt { conditions: at, branches })
    }

    /// True if the numerical values of a motion satisfy a branch of solutions, up to rounding. `values` are
    /// in the order of the symbols of the conditions.
    fn satisfies_branch(&self, conditions: &Conditions, branch: &Branch, values: &[DoubleDouble]) -> bool {
        let mut arena = self.arena.clone();
        let sides = branch.solved.iter().map(|relation| [condition_left_side(&mut arena, relation), relation.value]);
        let mut terms: Vec<Expr> = sides.flatten().collect();
        terms.extend(branch.needs.iter().map(|need| need.term()));
        terms.extend(branch.left.iter().chain(&branch.divided_by));
        let Ok(tape) = Tape::new(&arena, &conditions.symbols, &terms) else { return false };
        let found: Vec<f64> = tape.to::<DoubleDouble>().evaluate(values).iter().map(|x| x.hi()).collect();
        let (sides, rest) = found.split_at(2 * branch.solved.len());
        let (needs, rest) = rest.split_at(branch.needs.len());
        let (left, divisors) = rest.split_at(branch.left.len());
        let parameters = conditions.symbols.len() - self.is_angle.len() - conditions.along.len();
        let is_turned = |relation: &Relation| {
            let place = conditions.symbols[parameters..].iter().position(|e| *e == relation.unknown);
            relation.kind == RelationKind::Value && place.is_some_and(|at| self.is_angle.get(at) == Some(&true))
        };
        let is_told = branch.solved.iter().zip(sides.chunks(2)).all(|(relation, pair)| {
            let difference = pair[0] - pair[1];
            let turns = if is_turned(relation) { (difference / TAU).round() * TAU } else { 0.0 };
            (difference - turns).abs() <= NEAR * pair[1].abs().max(1.0)
        });
        let is_met = branch.needs.iter().zip(needs).all(|(need, value)| match need {
            RelationCondition::NotNegative(_) => *value >= -NEAR,
            RelationCondition::Unit(_) => value.abs() <= 1.0 + NEAR,
        });
        is_told && is_met && left.iter().all(|x| x.abs() <= NEAR) && divisors.iter().all(|x| x.abs() > 0.0)
    }
}
