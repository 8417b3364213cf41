//! Polynomial ring over ℚ in numbered generators, modulo the known squares of sines and square
//! roots.
//!
//! Invariant of every [`RingPolynomial`] of a [`Ring`]: terms are in descending lexicographic order, and no
//! coefficient is zero. A generator with a known square (sin² = 1 − cos², √x² = x) has no exponent
//! above 1.
//! In such a ring a polynomial is identically zero exactly if it has no terms, as long as the
//! generators are otherwise independent. [`super::normal_form`] says when they are.
//!
//! These polynomials are separate from those of `polynomial`. Descending order and reduction by
//! squares make forms normal and division exact, at a cost that [`super::simplify`] need not pay.
//!
//! Work is counted, not timed: after [`Ring::budget`] multiplications of terms the result is
//! `None`, on every machine alike.
//! Absent on purpose: greatest common divisors. Fractions cancel by trial division, which is exact
//! here, and a zero test needs no more. Most trial divisions fail, and [`RingPoint`] refutes them at little cost.

use super::ring_point::RingPoint;
use super::ring_polynomial::{GENERATORS, Powers, RingPolynomial, Square};
use crate::algebra::{Expr, Rational};
use rustc_hash::FxHashMap;
use std::cmp::Reverse;

/// Largest number of terms of a polynomial that is searched as a square root.
const MOST_ROOT_TERMS: usize = 60;

/// Polynomial ring over the rational numbers: its generators (the variables), and a budget of
/// multiplications.
#[derive(Clone)]
pub struct Ring {
    /// Generators by number: the expression of each, and its known square.
    generators: Vec<(Expr, Square)>,
    /// Number of each generator (a variable of the ring), by the expression that it stands for.
    numbers: FxHashMap<Expr, usize>,
    /// Largest exponent of each generator in a reduced monomial: 1 if its square is known, and else 255.
    largest: Powers,
    /// Point at which divisions that must fail are recognized.
    point: RingPoint,
    /// Number of multiplications of terms that are still allowed. When it is used up, operations of
    /// the ring return `None`.
    pub budget: u64,
}

impl Ring {
    /// Creates a ring without generators. The budget is the number of multiplications of terms that
    /// are allowed.
    pub fn new(budget: u64) -> Self {
        let largest = Powers([u8::MAX; GENERATORS]);
        Self { generators: Vec::new(), numbers: FxHashMap::default(), largest, point: RingPoint::new(), budget }
    }

    /// Expression for which a generator stands. The generator is a variable of the ring, given by
    /// its number.
    pub fn expression(&self, generator: usize) -> Expr {
        self.generators[generator].0
    }

    /// Number of generators: the variables of the ring.
    pub fn size(&self) -> usize {
        self.generators.len()
    }

    /// Number of the generator (a variable of the ring) that stands for the expression `e`. A new
    /// generator is added, with the square that the closure `square` returns. `None` if the ring is
    /// full or the closure returns `None`.
    pub fn generator(&mut self, e: Expr, square: impl FnOnce(&mut Self) -> Option<Square>) -> Option<usize> {
        if let Some(&number) = self.numbers.get(&e) {
            return Some(number);
        }
        let square = square(self)?;
        if self.generators.len() == GENERATORS {
            return None;
        }
        if !matches!(square, Square::Free) {
            self.largest = self.largest.with_exponent(self.generators.len(), 1);
        }
        self.point.add_generator(&square);
        self.generators.push((e, square));
        self.numbers.insert(e, self.generators.len() - 1);
        Some(self.generators.len() - 1)
    }

    /// Creates the polynomial that is a single generator: a variable of the ring, given by its
    /// number.
    pub fn variable(generator: usize) -> RingPolynomial {
        RingPolynomial { terms: vec![(Powers::ONE.with_exponent(generator, 1), Rational::ONE)] }
    }

    /// Subtracts work from the budget; `None` if the budget does not suffice.
    fn count_work(&mut self, work: usize) -> Option<()> {
        let left = self.budget.checked_sub(work as u64);
        self.budget = left.unwrap_or(0);
        left.map(|_| ())
    }

    /// Linear combination Σ k · p over the pairs (p, k); `None` if the ring's budget of
    /// multiplications is used up.
    pub fn sum<'a>(&mut self, parts: impl Iterator<Item = (&'a RingPolynomial, Rational)>) -> Option<RingPolynomial> {
        let mut sum: FxHashMap<Powers, Rational> = FxHashMap::default();
        for (part, k) in parts {
            self.count_work(part.terms.len())?;
            for (m, c) in &part.terms {
                add_ring_term(&mut sum, *m, c.mul(&k));
            }
        }
        Some(polynomial_of_sum(sum))
    }

    /// Product a · b of two polynomials; `None` if the ring's budget of multiplications is used up
    /// or an exponent exceeds 255.
    pub fn mul(&mut self, a: &RingPolynomial, b: &RingPolynomial) -> Option<RingPolynomial> {
        for (one, other) in [(a, b), (b, a)] {
            if let Some(k) = one.as_constant() {
                return Some(other.scaled(k));
            }
        }
        self.count_work(a.terms.len().checked_mul(b.terms.len())?)?;
        let mut product: FxHashMap<Powers, Rational> = FxHashMap::default();
        for (m, c) in &a.terms {
            for (n, d) in &b.terms {
                self.reduce_into(&mut product, m.times(n)?, c.mul(d))?;
            }
        }
        Some(polynomial_of_sum(product))
    }

    /// Adds the term k · powers to the polynomial `sum`. Squares of generators are replaced by
    /// their known values. `None` if the ring's budget of multiplications is used up or an exponent
    /// exceeds 255.
    fn reduce_into(&mut self, sum: &mut FxHashMap<Powers, Rational>, powers: Powers, k: Rational) -> Option<()> {
        if !powers.exceeds(&self.largest) {
            self.count_work(1)?;
            add_ring_term(sum, powers, k);
            return Some(());
        }
        let mut pending = vec![(powers, k)];
        while let Some((powers, k)) = pending.pop() {
            self.count_work(1)?;
            let square = self
                .generators
                .iter()
                .enumerate()
                .find(|(at, (_, square))| powers.exponent_of(*at) > 1 && !matches!(square, Square::Free));
            match square {
                None => add_ring_term(sum, powers, k),
                Some((at, (_, square))) => {
                    let rest = powers.with_exponent(at, powers.exponent_of(at) - 2);
                    match square {
                        Square::Free => unreachable!("a free generator has no known square"),
                        // sin² = 1 − cos².
                        Square::Sine(cosine) => {
                            pending.push((
                                rest.with_exponent(*cosine, rest.exponent_of(*cosine).checked_add(2)?),
                                k.neg(),
                            ));
                            pending.push((rest, k));
                        }
                        Square::Root(radicand) => {
                            let radicand = radicand.clone();
                            self.count_work(radicand.terms.len())?;
                            for (m, c) in &radicand.terms {
                                pending.push((rest.times(m)?, k.mul(c)));
                            }
                        }
                    }
                }
            }
        }
        Some(())
    }

    /// Power p^n of a polynomial; `None` if the ring's budget of multiplications is used up or an
    /// exponent exceeds 255.
    pub fn pow(&mut self, p: &RingPolynomial, n: u32) -> Option<RingPolynomial> {
        let (mut result, mut power, mut left) = (RingPolynomial::constant(&Rational::ONE), p.clone(), n);
        while left > 0 {
            if left & 1 == 1 {
                result = self.mul(&result, &power)?;
            }
            left >>= 1;
            if left > 0 {
                power = self.mul(&power, &power)?;
            }
        }
        Some(result)
    }

    /// Exact quotient a / b of two polynomials; `None` if the quotient is not a polynomial or the
    /// ring's budget of multiplications is used up.
    ///
    /// Every polynomial is p + q · sin, with unique p and q that contain no sine. So a / b is a
    /// polynomial exactly if the norm b · b̄, which contains no sine, divides a · b̄ term by term.
    pub fn divide(&mut self, a: &RingPolynomial, b: &RingPolynomial) -> Option<RingPolynomial> {
        if b.terms.len() > 1 {
            self.count_work(a.terms.len() + b.terms.len())?;
            if self.point.refutes_division(a, b) {
                return None;
            }
        }
        let (mut above, mut below) = (a.clone(), b.clone());
        // Generators are removed from the latest to the first: a root's radicand has only earlier
        // generators.
        for at in (0..self.generators.len()).rev() {
            let known_square = !matches!(self.generators[at].1, Square::Free);
            if known_square && below.mentions(at) {
                let conjugate = ring_conjugate(&below, at);
                above = self.mul(&above, &conjugate)?;
                below = self.mul(&below, &conjugate)?;
            }
        }
        self.divide_plainly(above, &below)
    }

    /// Square root of a polynomial: p with p² = `square`, found from the leading term on. `None` if
    /// no polynomial without sines and roots has this square, or the ring's budget of
    /// multiplications is used up.
    pub fn square_root(&mut self, square: &RingPolynomial) -> Option<RingPolynomial> {
        let (lead, k) = square.terms.first()?;
        let half = lead.square_root_of_monomial()?;
        let first = RingPolynomial { terms: vec![(half, k.small_square_root()?)] };
        let mut root = first.clone();
        for _ in 0..MOST_ROOT_TERMS {
            let whole = self.mul(&root, &root)?;
            let rest = self.sum([(square, Rational::ONE), (&whole, Rational::MINUS_ONE)].into_iter())?;
            let Some(next) = rest.terms.first() else { return Some(root) };
            let next = RingPolynomial { terms: vec![next.clone()] };
            let step = self.divide(&next, &first)?;
            root = self.sum([(&root, Rational::ONE), (&step, Rational::fraction(1, 2)?)].into_iter())?;
        }
        None
    }

    /// Exact quotient by a polynomial `below` without known squares, found from the leading term
    /// on. `None` if the quotient is not a polynomial or the ring's budget of multiplications is
    /// used up.
    fn divide_plainly(&mut self, mut above: RingPolynomial, below: &RingPolynomial) -> Option<RingPolynomial> {
        let (lead, k) = below.terms.first()?;
        let inverse = k.reciprocal()?;
        let mut quotient = Vec::new();
        while let Some((m, c)) = above.terms.first() {
            let step = (m.over(lead)?, c.mul(&inverse));
            self.count_work(below.terms.len() + above.terms.len())?;
            above = without_multiple(above, &step, below)?;
            quotient.push(step);
        }
        Some(RingPolynomial { terms: quotient })
    }
}

/// Difference p − k · m · q for the factor (m, k), without reduction by squares; `None` if an exponent exceeds 255. A
/// product with a monomial keeps the order of terms, so that both lists are merged.
fn without_multiple(p: RingPolynomial, (m, k): &(Powers, Rational), q: &RingPolynomial) -> Option<RingPolynomial> {
    let mut terms = Vec::with_capacity(p.terms.len() + q.terms.len());
    let mut kept = p.terms.into_iter().peekable();
    for (n, d) in &q.terms {
        let (powers, mut sum) = (m.times(n)?, k.mul(d).neg());
        while let Some(term) = kept.next_if(|(other, _)| *other > powers) {
            terms.push(term);
        }
        if let Some((_, c)) = kept.next_if(|(other, _)| *other == powers) {
            sum = c.add(&sum);
        }
        if !sum.is_zero() {
            terms.push((powers, sum));
        }
    }
    terms.extend(kept);
    Some(RingPolynomial { terms })
}

/// Conjugate of the polynomial in one generator: the sign of this variable is changed.
fn ring_conjugate(p: &RingPolynomial, generator: usize) -> RingPolynomial {
    let flip = |(m, k): &(Powers, Rational)| (*m, if m.exponent_of(generator) % 2 == 1 { k.neg() } else { k.clone() });
    RingPolynomial { terms: p.terms.iter().map(flip).collect() }
}

/// Adds the term k · powers to a sum of terms, in which each monomial has one coefficient.
fn add_ring_term(sum: &mut FxHashMap<Powers, Rational>, powers: Powers, k: Rational) {
    match sum.entry(powers) {
        std::collections::hash_map::Entry::Vacant(place) => {
            place.insert(k);
        }
        std::collections::hash_map::Entry::Occupied(mut place) => {
            let value = place.get().add(&k);
            *place.get_mut() = value;
        }
    }
}

/// Converts a map from monomials to coefficients into a polynomial with its terms in descending
/// order.
fn polynomial_of_sum(sum: FxHashMap<Powers, Rational>) -> RingPolynomial {
    let mut terms: Vec<_> = sum.into_iter().filter(|(_, k)| !k.is_zero()).collect();
    terms.sort_unstable_by_key(|(m, _)| Reverse(*m));
    RingPolynomial { terms }
}
