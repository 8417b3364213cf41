//! Equations of sines and cosines that reduce to a single wave (a sine or cosine of a linear
//! angle), or to two waves of equal amplitude. For example, sin A + sin B = 0 where A = −B or A = B +
//! π.

use super::relation::{FactorSolutions, Relation, Solution};
use super::workspace::Workspace;
use crate::algebra::form::ring_polynomial::RingPolynomial;
use crate::algebra::{Expr, Function, Node, Rational};
use std::collections::BTreeMap;

/// Largest number of terms of a polynomial in sines and cosines that is examined, and of the waves
/// that it becomes.
const MOST_TERMS: usize = 12;

/// Function of a wave: sine or cosine.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Cosine,
    Sine,
}

/// Angle Σ n · unknown, as a map from each unknown to its integer n. An empty map is the angle 0.
type Angle = BTreeMap<Expr, i64>;

/// Sine or cosine of an angle. The coefficient of the first unknown in the angle is positive.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Wave {
    /// Function of the wave: sine or cosine.
    kind: Kind,
    /// Argument of the sine or cosine, as an angle in the unknowns.
    angle: Angle,
}

/// Linear equation for angles: angle = `half_turns` · π.
struct Line {
    /// Left-hand side of the equation angle = `half_turns` · π.
    angle: Angle,
    /// Right-hand side of the equation, as a multiple of π.
    half_turns: Rational,
}

impl Workspace<'_> {
    /// Solves the equation p = 0 for the unknown `x`, where p contains only sines and cosines.
    ///
    /// `None` if p is neither a single wave nor the sum of two waves of equal amplitude. `None`
    /// also unless `x` is, in each solution, the last unknown with the coefficient 1 or −1.
    pub fn solve_waves(&mut self, p: &RingPolynomial, x: Expr) -> Option<FactorSolutions> {
        let waves = self.sum_of_waves(p)?;
        let lines = angle_equations(&waves)?;
        let mut solutions = Vec::new();
        for Line { angle, half_turns } in lines {
            let last = self.unknowns.iter().rev().find(|y| angle.get(y).is_some_and(|n| n.abs() == 1))?;
            if *last != x {
                return None;
            }
            let sign = Rational::integer(angle[&x]);
            let pi = self.arena.pi();
            let others = angle.iter().filter(|(y, _)| **y != x).map(|(y, n)| (*y, Rational::integer(-*n).mul(&sign)));
            let terms: Vec<(Expr, Rational)> = others.chain([(pi, half_turns.mul(&sign))]).collect();
            let value = self.arena.linear_combination(&terms);
            solutions.push(Solution { relations: vec![Relation::value(x, value)], needs: Vec::new() });
        }
        Some(FactorSolutions { solutions, divisor: None, degree: 0 })
    }

    /// Writes a polynomial in sines and cosines of unknowns as a sum of waves with their
    /// amplitudes. Products of sines and cosines become sums. `None` if the polynomial contains
    /// other atoms or is too long.
    fn sum_of_waves(&mut self, p: &RingPolynomial) -> Option<Vec<(Wave, Rational)>> {
        if p.terms.len() > MOST_TERMS {
            return None;
        }
        let half = Rational::fraction(1, 2)?;
        let mut sum: BTreeMap<Wave, Rational> = BTreeMap::new();
        for (powers, k) in &p.terms {
            let mut waves: Vec<(Wave, Rational)> =
                vec![(Wave { kind: Kind::Cosine, angle: BTreeMap::new() }, k.clone())];
            for at in 0..self.normalizer.ring().size() {
                let n = powers.exponent_of(at);
                if n == 0 {
                    continue;
                }
                let e = self.normalizer.expression_of(at);
                let Node::Apply(f @ (Function::Sin | Function::Cos), angle) = *self.arena.node(e) else { return None };
                if !self.unknowns.contains(&angle) {
                    return None;
                }
                let kind = if f == Function::Sin { Kind::Sine } else { Kind::Cosine };
                for _ in 0..n {
                    waves = waves.into_iter().flat_map(|(wave, k)| times(&wave, &k.mul(&half), kind, angle)).collect();
                    if waves.len() > MOST_TERMS {
                        return None;
                    }
                }
            }
            for (wave, k) in waves {
                let known = sum.entry(wave).or_insert(Rational::ZERO);
                *known = known.add(&k);
            }
        }
        Some(
            sum.into_iter()
                .filter(|(wave, k)| !(k.is_zero() || wave.kind == Kind::Sine && wave.angle.is_empty()))
                .collect(),
        )
    }
}

/// Product of a wave of amplitude 2 k and the sine or cosine of the unknown `x`: the two waves
/// whose sum it is, each with its amplitude.
fn times(wave: &Wave, k: &Rational, by: Kind, x: Expr) -> [(Wave, Rational); 2] {
    let turned = |by: i64| {
        let mut angle = wave.angle.clone();
        *angle.entry(x).or_insert(0) += by;
        angle.retain(|_, n| *n != 0);
        angle
    };
    // sin A cos x = (sin(A + x) + sin(A − x))/2, cos A sin x = (sin(A + x) − sin(A − x))/2 and so on.
    let (kind, [plus, minus]) = match (wave.kind, by) {
        (Kind::Sine, Kind::Cosine) => (Kind::Sine, [k.clone(), k.clone()]),
        (Kind::Cosine, Kind::Sine) => (Kind::Sine, [k.clone(), k.neg()]),
        (Kind::Cosine, Kind::Cosine) => (Kind::Cosine, [k.clone(), k.clone()]),
        (Kind::Sine, Kind::Sine) => (Kind::Cosine, [k.neg(), k.clone()]),
    };
    [(turned(1), plus), (turned(-1), minus)].map(|(angle, k)| {
        let is_negative = angle.values().next().is_some_and(|n| *n < 0);
        let angle = if is_negative { angle.into_iter().map(|(x, n)| (x, -n)).collect() } else { angle };
        let k = if is_negative && kind == Kind::Sine { k.neg() } else { k };
        (Wave { kind, angle }, k)
    })
}

/// Linear equations for the angles at which a sum of waves is 0. It must be a single wave, or two
/// waves of equal amplitude; `None` for other sums.
fn angle_equations(waves: &[(Wave, Rational)]) -> Option<Vec<Line>> {
    let [zero, half, one] = [Rational::ZERO, Rational::fraction(1, 2)?, Rational::ONE];
    let line = |angle: Angle, half_turns: Rational| Line { angle, half_turns };
    let combined = |a: &Wave, b: &Wave, sign: i64| {
        let mut angle = a.angle.clone();
        for (x, n) in &b.angle {
            *angle.entry(*x).or_insert(0) += sign * n;
        }
        angle.retain(|_, n| *n != 0);
        angle
    };
    let lines = match waves {
        [(Wave { kind: Kind::Sine, angle }, _)] => vec![line(angle.clone(), zero), line(angle.clone(), one)],
        [(Wave { kind: Kind::Cosine, angle }, _)] if !angle.is_empty() => {
            vec![line(angle.clone(), half.clone()), line(angle.clone(), half.neg())]
        }
        [(a, k), (b, l)]
            if a.kind == b.kind && (k == l || *k == l.neg()) && !a.angle.is_empty() && !b.angle.is_empty() =>
        {
            let (sum, difference) = (combined(a, b, 1), combined(a, b, -1));
            match (a.kind, k == l) {
                (Kind::Sine, true) => vec![line(sum, zero), line(difference, one)],
                (Kind::Sine, false) => vec![line(difference, zero), line(sum, one)],
                (Kind::Cosine, true) => vec![line(sum, one.clone()), line(difference, one)],
                (Kind::Cosine, false) => vec![line(sum, zero.clone()), line(difference, zero)],
            }
        }
        _ => return None,
    };
    // An equation without unknowns would arise if both angles were equal; then there is no solution
    // of this kind.
    lines.iter().all(|line| !line.angle.is_empty()).then_some(lines)
}
