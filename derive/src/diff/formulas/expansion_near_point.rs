//! Formulas that hold near a point: printed and derived formulas are expanded up to an order in the deviations.
//!
//! The substitution x = x₀ + ε (x − x₀), for each variable that stays near the point, gives Taylor series in ε. Two
//! formulas are equal up to an order if their series are equal up to this order; later terms do not count.
//!
//! Small parameters, p = δ p, count as deviations, with δ = ε. But a publication may keep products of a small parameter
//! and a deviation, such as Ω ẋ in the linear equations of Foucault's pendulum. Then formulas are compared up to the
//! order in ε and, separately, up to the order in δ.

use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::text::print::print_text;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Function, Node};
use crate::mechanics::{Kinematics, Quantities};
use crate::publication::Approximation;

/// Point of an approximation, with the values that follow from it, and the order of the approximation.
pub struct PointExpansion {
    /// Symbols of the variables that stay near the point, each with its value at the point.
    point: Vec<(Expr, Expr)>,
    /// Substitution of x₀ + ε (x − x₀) for each variable near the point; parameters have δ instead of ε.
    way: Substitution,
    /// Symbol ε, which scales the deviations of variables.
    epsilon: Expr,
    /// Symbol δ, which scales the deviations of parameters from their values at the point.
    delta: Expr,
    /// True if ε and δ are expanded separately, each up to the order; false if δ = ε.
    keeps_products: bool,
    /// Order of the deviations up to which formulas hold.
    pub order: u32,
    /// Description of the order and the point, such as "to first order about q1 = 0".
    pub words: String,
}

impl PointExpansion {
    /// Completes the point of an approximation with the rates and speeds that follow from it. A variable that stays
    /// near a value has a rate near zero. A speed or rate whose formula contains only such variables stays near the
    /// value of the formula.
    pub fn new(quantities: &mut Quantities<'_>, stated: &Approximation) -> Self {
        let model = quantities.model;
        let arena = &mut quantities.derivations.kinematics.arena;
        let values: Vec<String> =
            stated.values.iter().map(|v| format!("{} = {}", v.name, print_text(arena, v.value))).collect();
        let order = match stated.order {
            1 => "first".to_owned(),
            2 => "second".to_owned(),
            3 => "third".to_owned(),
            n => format!("{n}th"),
        };
        let words = format!("to {order} order about {}", values.join(", "));
        let mut point: Vec<(Expr, Expr)> = stated.values.iter().map(|v| (v.symbol, v.value)).collect();
        let add = |point: &mut Vec<(Expr, Expr)>, symbol: Expr, value: Expr| {
            if point.iter().all(|(known, _)| *known != symbol) {
                point.push((symbol, value));
            }
        };
        let states: Vec<Expr> = [model.q(), model.q_dot(), model.u()].concat();
        for c in &model.coordinates {
            if point.iter().any(|(known, _)| *known == c.symbol) {
                add(&mut point, c.rate, Expr::ZERO);
            }
        }
        let settled = |arena: &mut Arena, point: &[(Expr, Expr)], formula: Expr| {
            let mut put = Substitution::new(point);
            let value = put.apply(arena, formula);
            (put.undefined.is_none() && !states.iter().any(|s| arena.mentions(value, *s))).then_some(value)
        };
        for speed in &model.speeds {
            if let Some(value) = settled(arena, &point, speed.definition) {
                add(&mut point, speed.symbol, value);
            }
        }
        for (c, rate) in model.coordinates.iter().zip(&model.kinematic_equations.rates) {
            if let Some(value) = settled(arena, &point, *rate) {
                add(&mut point, c.rate, value);
            }
        }
        for c in &model.coordinates {
            if point.iter().any(|(known, _)| *known == c.rate) {
                add(&mut point, c.second_rate, Expr::ZERO);
            }
        }
        for speed in &model.speeds {
            if point.iter().any(|(known, _)| *known == speed.symbol) {
                add(&mut point, speed.rate, Expr::ZERO);
            }
        }
        let (epsilon, delta) = (fresh_symbol(arena, "deviation"), fresh_symbol(arena, "parameter"));
        let mut way = Vec::new();
        for (symbol, value) in &point {
            let is_parameter = model.parameters.iter().any(|p| p.symbol == *symbol);
            let away = arena.sub(*symbol, *value);
            let away = arena.mul(if is_parameter { delta } else { epsilon }, away);
            way.push((*symbol, arena.add(*value, away)));
        }
        let way = Substitution::new(&way);
        Self { point, way, epsilon, delta, keeps_products: false, order: stated.order, words }
    }

    /// Switches to separate orders in deviations and in parameters if a printed formula needs it. A formula needs it if
    /// it has a product of a deviation and a small parameter that is beyond the common order.
    pub fn separate_orders_if_needed(&mut self, quantities: &mut Quantities<'_>, printed: &[Expr]) {
        let parameters = quantities.model.p();
        if self.point.iter().all(|(symbol, _)| !parameters.contains(symbol)) {
            return;
        }
        for e in printed {
            self.keeps_products = true;
            let whole = self.expand_formula(quantities, *e);
            self.keeps_products = false;
            let (Ok(whole), Ok(short)) = (whole, self.expand_formula(quantities, *e)) else { continue };
            let arena = &mut quantities.derivations.kinematics.arena;
            let beyond = arena.sub(whole, short);
            if zero_test(arena, beyond) == ZeroTest::NonZero {
                self.keeps_products = true;
                return;
            }
        }
    }

    /// Expands a formula about the point up to `order`, by a Taylor series.
    ///
    /// # Errors
    /// Reason why the formula has no series at the point.
    pub fn expand_formula(&mut self, quantities: &mut Quantities<'_>, e: Expr) -> Result<Expr, String> {
        let order = self.order;
        self.expand_to_order(quantities, e, order)
    }

    /// Expands the coefficient of an unknown about the point, so that the product with the unknown
    /// has the right order.
    /// If the unknown is zero at the point, the coefficient is expanded to one order less.
    ///
    /// # Errors
    /// Reason why the coefficient has no series at the point.
    pub fn expand_coefficient(
        &mut self,
        quantities: &mut Quantities<'_>,
        unknown: Expr,
        e: Expr,
    ) -> Result<Expr, String> {
        let is_small = self.point.iter().any(|(symbol, value)| *symbol == unknown && *value == Expr::ZERO);
        let order = self.order - u32::from(is_small);
        self.expand_to_order(quantities, e, order)
    }

    /// Expands `e` about the point up to the given order in the deviations.
    ///
    /// # Errors
    /// Reason why `e` has no series at the point.
    fn expand_to_order(&mut self, quantities: &mut Quantities<'_>, e: Expr, order: u32) -> Result<Expr, String> {
        let Kinematics { arena, simplifier, .. } = &mut quantities.derivations.kinematics;
        let moved = self.way.apply(arena, e);
        if self.way.undefined.is_some() {
            return Err(self.no_value());
        }
        let sum = if self.keeps_products {
            let of_parameters = self.taylor_sum(arena, moved, self.delta, self.order)?;
            self.taylor_sum(arena, of_parameters, self.epsilon, order)?
        } else {
            let moved = Substitution::new(&[(self.delta, self.epsilon)]).apply(arena, moved);
            self.taylor_sum(arena, moved, self.epsilon, order)?
        };
        Ok(simplifier.simplify(arena, sum))
    }

    /// Sum of the Taylor terms of `e` in the symbol `size`, up to an order, in which the symbol is then replaced by 1.
    ///
    /// # Errors
    /// Reason why `e` has no value or a kink at the point.
    fn taylor_sum(&self, arena: &mut Arena, e: Expr, size: Expr, order: u32) -> Result<Expr, String> {
        let mut at_point = Substitution::new(&[(size, Expr::ZERO)]);
        if has_kink_at_point(arena, &mut at_point, size, e) {
            return Err(format!("it has a bend there, and no series {}", self.words));
        }
        let mut slope = Differential::partial(size);
        let (mut term, mut sum, mut factorial) = (e, Vec::new(), 1_i64);
        for k in 0..=order {
            if k > 0 {
                term = slope.apply(arena, term);
                factorial *= i64::from(k);
            }
            let value = at_point.apply(arena, term);
            if at_point.undefined.is_some() {
                return Err(self.no_value());
            }
            let part = arena.ratio(1, factorial);
            sum.push(arena.mul(part, value));
        }
        Ok(arena.sum(&sum))
    }

    /// Message that a formula has no value at the point.
    fn no_value(&self) -> String {
        format!("it has no value there, and no series {}", self.words)
    }
}

/// True if `e` has a kink at the point. Then an argument of |x| or sign x in `e` depends on ε and may be zero at the
/// point.
fn has_kink_at_point(arena: &mut Arena, at_point: &mut Substitution, epsilon: Expr, e: Expr) -> bool {
    let bent: Vec<Expr> = arena
        .reachable(&[e])
        .into_iter()
        .filter_map(|part| match arena.node(part) {
            Node::Apply(Function::Abs | Function::Sign, argument) if arena.mentions(*argument, epsilon) => {
                Some(*argument)
            }
            _ => None,
        })
        .collect();
    bent.into_iter().any(|argument| {
        let value = at_point.apply(arena, argument);
        zero_test(arena, value) != ZeroTest::NonZero
    })
}
