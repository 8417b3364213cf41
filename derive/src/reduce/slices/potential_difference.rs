//! Divided difference of the potential energy of a system with one degree of freedom, for solution
//! by quadrature. It does not subtract nearly equal values.

use super::slice::Slice;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::term::divided_difference::divided_difference;
use crate::algebra::term::period::period_in_turns;
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Rational};
use crate::reduce::basis::reduction_basis::ReductionBasis;

/// Divided difference (V(b) − V(a))/(b − a) of the potential energy V over the only coordinate of a
/// system with one degree of freedom.
#[derive(Clone, Debug)]
pub struct PotentialDifference {
    /// Symbols of the two values a and b of the coordinate.
    pub ends: [Expr; 2],
    /// Divided difference as a term in parameters, a, b and the symbols of `sincs`.
    pub value: Expr,
    /// Symbols in `value` that stand for sin z/z, as pairs (symbol, z).
    pub sincs: Vec<(Expr, Expr)>,
    /// Period of the coordinate in turns of 2 π rad: number of turns after which rates, T and V
    /// repeat. `None` if they do not repeat, or if no period is found.
    pub turns: Option<Rational>,
}

impl PotentialDifference {
    /// Period of the coordinate, rad, after which rates, T and V repeat; `None` if `turns` is
    /// `None`.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        self.turns.as_ref().map(|turns| std::f64::consts::TAU * turns.to_f64())
    }
}

impl Slice {
    /// Divided difference of the potential energy, for solution by quadrature.
    ///
    /// `None` unless the system has one degree of freedom with q′ = k(q) v and T = ½ m(q) v².
    /// `None` also if a quadrature variable has a rate that depends on other variables than q and
    /// v.
    pub(in crate::reduce) fn potential_difference_for_quadrature(
        &self,
        basis: &mut ReductionBasis,
        kinetic: Expr,
        potential: Expr,
    ) -> Option<PotentialDifference> {
        let [q, v] = self.core.as_slice() else { return None };
        if q.is_speed || !v.is_speed || self.quadratures.iter().any(|v| v.is_speed) {
            return None;
        }
        self.energy?;
        let mut dependence = self.dependence.clone();
        let arena = &mut basis.arena;
        let of_core = |arena: &Arena, e: Expr| {
            self.quadratures.iter().chain(&self.dropped).all(|other| !arena.mentions(e, other.symbol))
        };
        let mut repeating = Vec::new();
        for quadrature in &self.quadratures {
            let rate = dependence.without_definitions(arena, quadrature.rate);
            if !of_core(arena, rate) {
                return None;
            }
            repeating.push(rate);
        }
        let [rate, kinetic, potential] = [q.rate, kinetic, potential].map(|e| dependence.without_definitions(arena, e));
        let homogeneous = is_homogeneous(arena, rate, v.symbol, 1) && is_homogeneous(arena, kinetic, v.symbol, 2);
        if !homogeneous
            || arena.mentions(potential, v.symbol)
            || ![kinetic, potential].iter().all(|e| of_core(arena, *e))
        {
            return None;
        }
        let name = arena.symbol_name(q.symbol).unwrap_or_default().to_owned();
        let ends = ["from", "to"].map(|end| fresh_symbol(arena, &format!("{name}_{end}")));
        let divided = divided_difference(arena, potential, q.symbol, ends[0], ends[1])?;
        repeating.extend([rate, kinetic, potential]);
        let turns = period_in_turns(arena, &repeating, q.symbol);
        Some(PotentialDifference { ends, value: divided.value, sincs: divided.sincs, turns })
    }
}

/// True if the term e is homogeneous in x of degree n by meaning: e = xⁿ · e(x = 1).
fn is_homogeneous(arena: &mut Arena, e: Expr, x: Expr, n: i64) -> bool {
    let slope = Differential::partial(x).apply(arena, e);
    let times = arena.mul(x, slope);
    let degree = arena.scale(e, &Rational::integer(n));
    let euler = arena.sub(times, degree);
    let mut at_zero = Substitution::new(&[(x, Expr::ZERO)]);
    let rest = at_zero.apply(arena, e);
    zero_test(arena, euler) == ZeroTest::Zero && zero_test(arena, rest) == ZeroTest::Zero
}
