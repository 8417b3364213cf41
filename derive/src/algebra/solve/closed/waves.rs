//! Equations of angles alone that reduce to one sine or cosine, or to two of equal amplitude.
//! For example, sin A + sin B = 0 where A = −B or A = B + π.

use super::relation::{Isolated, Relation, Solution};
use super::work::Work;
use crate::algebra::form::ring::Poly;
use crate::algebra::{Expr, Function, Node, Rational};
use std::collections::BTreeMap;

/// Largest number of terms of a polynomial, and of waves, that are examined.
const MOST_TERMS: usize = 12;

/// Sine or cosine wave: true for a sine, false for a cosine; and the angle Σ n · unknown, with the first n above 0.
type Wave = (bool, BTreeMap<Expr, i64>);

/// Linear equation angle = half turns · π, with the angle Σ n · unknown.
type Line = (BTreeMap<Expr, i64>, Rational);

impl Work<'_> {
    /// Solves a factor that depends on angles alone for the unknown `x`. `x` must be the last unknown that has the
    /// factor 1 or −1 in each solution; otherwise the result is `None`.
    pub fn by_waves(&mut self, p: &Poly, x: Expr) -> Option<Isolated> {
        let waves = self.waves(p)?;
        let lines = lines(&waves)?;
        let mut solutions = Vec::new();
        for (angle, turns) in lines {
            let last = self.unknowns.iter().rev().find(|y| angle.get(y).is_some_and(|n| n.abs() == 1))?;
            if *last != x {
                return None;
            }
            let sign = Rational::integer(angle[&x]);
            let pi = self.arena.pi();
            let others = angle.iter().filter(|(y, _)| **y != x).map(|(y, n)| (*y, Rational::integer(-*n).mul(&sign)));
            let terms: Vec<(Expr, Rational)> = others.chain([(pi, turns.mul(&sign))]).collect();
            let value = self.arena.linear_combination(&terms);
            solutions.push(Solution { relations: vec![Relation::value(x, value)], needs: Vec::new() });
        }
        Some(Isolated { solutions, divisor: None, degree: 0 })
    }

    /// Writes a polynomial with numbers as coefficients as a sum of waves: products of waves become sums. `None` if it
    /// contains other atoms or is too long.
    fn waves(&mut self, p: &Poly) -> Option<Vec<(Wave, Rational)>> {
        if p.terms.len() > MOST_TERMS {
            return None;
        }
        let half = Rational::fraction(1, 2)?;
        let mut sum: BTreeMap<Wave, Rational> = BTreeMap::new();
        for (powers, k) in &p.terms {
            let mut waves: Vec<(Wave, Rational)> = vec![((false, BTreeMap::new()), k.clone())];
            for at in 0..self.normalizer.ring().size() {
                let n = powers.of(at);
                if n == 0 {
                    continue;
                }
                let e = self.normalizer.expression_of(at);
                let Node::Apply(f @ (Function::Sin | Function::Cos), angle) = *self.arena.node(e) else { return None };
                if !self.unknowns.contains(&angle) {
                    return None;
                }
                for _ in 0..n {
                    waves = waves.into_iter().flat_map(|wave| times(wave, f == Function::Sin, angle, &half)).collect();
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
        Some(sum.into_iter().filter(|(wave, k)| !(k.is_zero() || wave.0 && wave.1.is_empty())).collect())
    }
}

/// Product of a wave and the sine or cosine of an angle, as two waves of half the amplitude.
fn times(((is_sine, angle), k): (Wave, Rational), by_sine: bool, x: Expr, half: &Rational) -> [(Wave, Rational); 2] {
    let turned = |by: i64| {
        let mut angle = angle.clone();
        *angle.entry(x).or_insert(0) += by;
        angle.retain(|_, n| *n != 0);
        angle
    };
    let k = k.mul(half);
    // sin A cos x = (sin(A + x) + sin(A − x))/2, cos A sin x = (sin(A + x) − sin(A − x))/2 and so on.
    let (kind, [plus, minus]) = match (is_sine, by_sine) {
        (true, false) => (true, [k.clone(), k]),
        (false, true) => (true, [k.clone(), k.neg()]),
        (false, false) => (false, [k.clone(), k]),
        (true, true) => (false, [k.neg(), k]),
    };
    [(turned(1), plus), (turned(-1), minus)].map(|(angle, k)| {
        let is_negative = angle.values().next().is_some_and(|n| *n < 0);
        let angle = if is_negative { angle.into_iter().map(|(x, n)| (x, -n)).collect() } else { angle };
        let k = if is_negative && kind { k.neg() } else { k };
        ((kind, angle), k)
    })
}

/// Equations for the angles where one wave, or the sum of two waves of equal amplitude, is 0. `None` for other sums.
fn lines(waves: &[(Wave, Rational)]) -> Option<Vec<Line>> {
    let [zero, half, one] = [Rational::ZERO, Rational::fraction(1, 2)?, Rational::ONE];
    let combined = |a: &Wave, b: &Wave, sign: i64| {
        let mut angle = a.1.clone();
        for (x, n) in &b.1 {
            *angle.entry(*x).or_insert(0) += sign * n;
        }
        angle.retain(|_, n| *n != 0);
        angle
    };
    let lines = match waves {
        [((true, angle), _)] => vec![(angle.clone(), zero), (angle.clone(), one)],
        [((false, angle), _)] if !angle.is_empty() => {
            vec![(angle.clone(), half.clone()), (angle.clone(), half.neg())]
        }
        [(a, k), (b, l)] if a.0 == b.0 && (k == l || *k == l.neg()) && !a.1.is_empty() && !b.1.is_empty() => {
            let (sum, difference) = (combined(a, b, 1), combined(a, b, -1));
            match (a.0, k == l) {
                (true, true) => vec![(sum, zero), (difference, one)],
                (true, false) => vec![(difference, zero), (sum, one)],
                (false, true) => vec![(sum, one.clone()), (difference, one)],
                (false, false) => vec![(sum, zero.clone()), (difference, zero)],
            }
        }
        _ => return None,
    };
    // If the angles of a pair are equal, one equation is empty: then it is no pair.
    lines.iter().all(|(angle, _)| !angle.is_empty()).then_some(lines)
}
