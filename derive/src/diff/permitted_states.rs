//! Permitted states, in which printed and derived values are compared: states on the constraints of a model and in its
//! domain.
//!
//! Rates are those that the speeds permit, q̇ = W u + w. Each equation between coordinates is solved for one symbol.
//! The first choice is a coordinate in which the equation is linear. The next is a parameter, such as a length of a
//! loop; the last is the root of a quadratic equation. A statement that is proved for the remaining symbols then holds
//! in every state on the constraints, except where a divisor is 0.

use crate::algebra::form::normal_form::Normalizer;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::meaning::permitted_states::PermittedStates;
use crate::algebra::solve::linear::LinearForm;
use crate::algebra::solve::quadratic_equation::QuadraticEquation;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::elementary::expand_multiple_angles;
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use crate::mechanics::{Kinematics, Quantities};
use crate::model::{Model, MotionConstraintKind, TIME};

/// Largest number of multiplications of terms for the numerator of one loop equation.
const BUDGET: u64 = 100_000;

/// Permitted states of a model: values for the symbols that its constraints determine, and the
/// conditions of its domain.
pub fn permitted_states(quantities: &mut Quantities<'_>) -> PermittedStates {
    let model = quantities.model;
    let (mut solved, open) = permitted_values_from_loops(quantities);
    if !model.motion_constraints.is_empty() {
        let mut put = Substitution::new(&solved);
        let mut free = |arena: &mut Arena, e: Expr| {
            let separate = expand_multiple_angles(arena, e);
            put.apply(arena, separate)
        };
        for c in &model.coordinates {
            for rate in [c.rate, c.second_rate] {
                let in_speeds = quantities.in_speeds(rate);
                let arena = &mut quantities.derivations.kinematics.arena;
                solved.push((rate, free(arena, in_speeds)));
            }
        }
    }
    let conditions = model.domain.iter().map(|condition| condition.positive).collect();
    let arena = &mut quantities.derivations.kinematics.arena;
    let shorter = sums_fixed_by_constraints(model, arena);
    let permitted =
        PermittedStates::new(arena, solved, conditions).with_shorter_terms(&shorter).with_unsolved_equation(open);
    let is_told = model.motion_constraints.iter().any(|constraint| constraint.kind != MotionConstraintKind::Clock);
    if is_told { permitted } else { permitted.hide_free_symbols() }
}

/// Solves the loop equations of a model. Returns pairs (symbol, value). The second part is the reason if an equation
/// cannot be solved for a symbol in closed form, else `None`.
fn permitted_values_from_loops(quantities: &mut Quantities<'_>) -> (Vec<(Expr, Expr)>, Option<String>) {
    let model = quantities.model;
    let Kinematics { arena, simplifier, .. } = &mut quantities.derivations.kinematics;
    let mut solved: Vec<(Expr, Expr)> = Vec::new();
    let mut open = None;
    for one in model.loops.iter().chain(&model.closed) {
        let equation = expand_multiple_angles(arena, one.equation);
        let equation = Substitution::new(&solved).apply(arena, equation);
        let equation = numerator(arena, equation);
        if zero_test(arena, equation) == ZeroTest::Zero {
            continue;
        }
        let found = permitted_value_of_symbol(model, arena, simplifier, equation).map(|pair| vec![pair]);
        let Some(found) = found.or_else(|| permitted_values_of_angle(model, arena, equation)) else {
            open = Some(format!(
                "the equation of `{}` gives no symbol in closed form, so that no state on it is known",
                one.name
            ));
            continue;
        };
        let found: Vec<_> = found.into_iter().map(|(e, value)| (e, simplifier.simplify(arena, value))).collect();
        let mut put = Substitution::new(&found);
        for (_, earlier) in &mut solved {
            let separate = expand_multiple_angles(arena, *earlier);
            *earlier = put.apply(arena, separate);
        }
        solved.extend(found);
    }
    (solved, open)
}

/// Sums of coordinates that a loop equation fixes, each with its value in parameters, such as (x² +
/// y², l²).
fn sums_fixed_by_constraints(model: &Model, arena: &mut Arena) -> Vec<(Expr, Expr)> {
    let coordinates = model.q();
    let mut list = Vec::new();
    for one in model.loops.iter().chain(&model.closed) {
        let Node::Sum(constant, terms) = arena.node(one.equation).clone() else { continue };
        let moves = |term: &Expr| coordinates.iter().any(|q| arena.mentions(*term, *q));
        let (moving, fixed): (Vec<_>, Vec<_>) = terms.iter().cloned().partition(|(term, _)| moves(term));
        if moving.len() < 2 || (fixed.is_empty() && constant.is_zero()) {
            continue;
        }
        let constant = arena.number(constant);
        let fixed: Vec<_> = fixed.into_iter().chain([(constant, Rational::ONE)]).collect();
        let (sum, rest) = (arena.linear_combination(&moving), arena.linear_combination(&fixed));
        // The equation is sum + rest = 0. Sums in terms have no numerical factor.
        let (content, sum) = arena.split_content(sum);
        let Some(inverse) = content.reciprocal() else { continue };
        list.push((sum, arena.scale(rest, &inverse.neg())));
    }
    list
}

/// Numerator of the fraction `e`, expanded. Returns `e` itself if the numerator exceeds the work
/// limit.
fn numerator(arena: &mut Arena, e: Expr) -> Expr {
    let mut normalizer = Normalizer::new(BUDGET);
    match normalizer.normal_form(arena, e) {
        Some(form) => normalizer.polynomial(&form.numerator).expand(arena),
        None => e,
    }
}

/// Solves a loop equation for one symbol. Returns the symbol and its value, or `None` if no symbol can be solved for.
/// The value must contain a coordinate, because a symbol that occurs in only one factor of a product is not determined.
/// A symbol in which the equation is linear is preferred, then a positive parameter that occurs as a pure square.
fn permitted_value_of_symbol(
    model: &Model,
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    equation: Expr,
) -> Option<(Expr, Expr)> {
    let ties_coordinates = |arena: &Arena, e: Expr| {
        let parts = arena.reachable(&[e]);
        model.coordinates.iter().any(|c| parts.binary_search(&c.symbol).is_ok())
    };
    let coordinates = model.coordinates.iter().filter(|c| c.name != TIME).map(|c| (c.symbol, false));
    let parameters = model.parameters.iter().filter(|p| !p.is_input).map(|p| (p.symbol, p.positive));
    let mut found: Option<(usize, Expr, Expr)> = None;
    for (symbol, positive) in coordinates.chain(parameters) {
        if !arena.mentions(equation, symbol) {
            continue;
        }
        let Some(quadratic) = QuadraticEquation::new(arena, equation, symbol) else { continue };
        // The best symbol is one in which the equation is linear. Next is a positive parameter that occurs as a pure
        // square, because its root is unique.
        let rank = match (quadratic.is_linear(), positive && quadratic.b == Expr::ZERO) {
            (true, _) => 0,
            (false, true) => 1,
            (false, false) => 2,
        };
        if found.as_ref().is_some_and(|(best, ..)| *best <= rank) {
            continue;
        }
        let Some(value) = quadratic.value(arena) else { continue };
        let value = simplifier.simplify(arena, value);
        if ties_coordinates(arena, value) {
            found = Some((rank, symbol, value));
        }
    }
    found.map(|(_, symbol, value)| (symbol, value))
}

/// Solves an equation a sin q + b cos q + c = 0 for a coordinate q. Returns pairs of sin q, cos q and q with their
/// values. Returns `None` if no coordinate occurs in this form.
fn permitted_values_of_angle(model: &Model, arena: &mut Arena, equation: Expr) -> Option<Vec<(Expr, Expr)>> {
    model.coordinates.iter().filter(|c| c.name != TIME).find_map(|q| {
        let (sine, cosine) = (arena.sin(q.symbol), arena.cos(q.symbol));
        let [s, c] = ["sine", "cosine"].map(|name| fresh_symbol(arena, name));
        let plain = Substitution::new(&[(sine, s), (cosine, c)]).apply(arena, equation);
        let Ok((factors, rest)) = LinearForm::new(&[s, c]).coefficients(arena, plain) else { return None };
        let (a, b) = (factors[0], factors[1]);
        let is_free = [a, b, rest].into_iter().all(|e| !arena.mentions(e, q.symbol));
        let depends = [a, b].into_iter().any(|e| zero_test(arena, e) == ZeroTest::NonZero);
        if !is_free || !depends {
            return None;
        }
        // (sin, cos) = (−a c + b r, −b c − a r)/(a² + b²) with r² = a² + b² − c².
        let squares = [a, b, rest].map(|e| arena.square(e));
        let length = arena.add(squares[0], squares[1]);
        let radicand = arena.sub(length, squares[2]);
        let root = arena.apply(Function::Sqrt, radicand);
        let products = [(b, root), (a, rest), (b, rest), (a, root)].map(|(x, y)| arena.mul(x, y));
        let (above_sine, below) = (arena.sub(products[0], products[1]), arena.add(products[2], products[3]));
        let (value, opposite) = (arena.div(above_sine, length)?, arena.div(below, length)?);
        let across = arena.neg(opposite);
        // q = 2 atan(sin q/(1 + cos q)).
        let beside = arena.add(Expr::ONE, across);
        let tangent = arena.div(value, beside)?;
        let half = arena.apply(Function::Atan, tangent);
        Some(vec![(sine, value), (cosine, across), (q.symbol, arena.add(half, half))])
    })
}
