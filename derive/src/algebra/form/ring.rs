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
//! here, and a zero test needs no more.

use crate::algebra::{Expr, Rational};
use rustc_hash::FxHashMap;
use std::cmp::Reverse;

/// Largest number of generators (variables) that a ring may have.
pub const GENERATORS: usize = 64;
/// Largest number of terms of a polynomial that is searched as a square root.
const MOST_ROOT_TERMS: usize = 60;

/// Exponents of a monomial, one for each generator (a variable of the polynomial ring). Their
/// lexicographic order is a monomial order.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Powers([u8; GENERATORS]);

impl Powers {
    /// Exponents of the monomial 1: all are 0.
    pub const ONE: Self = Self([0; GENERATORS]);

    /// Exponent of a generator in the monomial. The generator is a variable of the ring, given by
    /// its number.
    pub fn exponent_of(&self, generator: usize) -> u8 {
        self.0[generator]
    }

    /// Returns the monomial with the exponent of one generator (a variable of the ring) replaced.
    fn with_exponent(mut self, generator: usize, exponent: u8) -> Self {
        self.0[generator] = exponent;
        self
    }

    /// Product of two monomials; `None` if an exponent exceeds 255.
    fn times(&self, other: &Self) -> Option<Self> {
        let mut result = *self;
        for (a, b) in result.0.iter_mut().zip(&other.0) {
            *a = a.checked_add(*b)?;
        }
        Some(result)
    }

    /// Quotient `self` / `other` of two monomials; `None` if an exponent would be negative.
    fn over(&self, other: &Self) -> Option<Self> {
        let mut result = *self;
        for (a, b) in result.0.iter_mut().zip(&other.0) {
            *a = a.checked_sub(*b)?;
        }
        Some(result)
    }

    /// Square root of the monomial; `None` if an exponent is odd.
    pub fn square_root_of_monomial(&self) -> Option<Self> {
        let mut result = *self;
        for n in &mut result.0 {
            if *n % 2 == 1 {
                return None;
            }
            *n /= 2;
        }
        Some(result)
    }

    /// Splits the monomial into two factors: one in the given generators (variables of the ring),
    /// one in all other generators.
    pub fn split(&self, generators: &[usize]) -> (Self, Self) {
        let (mut inside, mut outside) = (Self::ONE, *self);
        for at in generators {
            inside.0[*at] = self.0[*at];
            outside.0[*at] = 0;
        }
        (inside, outside)
    }

    /// Largest monomial that divides both monomials.
    fn common(&self, other: &Self) -> Self {
        let mut result = *self;
        for (a, b) in result.0.iter_mut().zip(&other.0) {
            *a = (*a).min(*b);
        }
        result
    }
}

/// Polynomial of a [`Ring`], with rational coefficients.
#[derive(Clone, PartialEq, Eq, Hash, Default)]
pub struct RingPolynomial {
    /// Terms as pairs (exponents, coefficient), in descending order: the leading term comes first.
    pub terms: Vec<(Powers, Rational)>,
}

impl RingPolynomial {
    /// Creates a constant polynomial.
    pub fn constant(value: &Rational) -> Self {
        if value.is_zero() { Self::default() } else { Self { terms: vec![(Powers::ONE, value.clone())] } }
    }

    /// True if the polynomial is 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Value of a constant polynomial other than 0; `None` for 0 and for polynomials that are not
    /// constant.
    pub fn as_constant(&self) -> Option<&Rational> {
        match self.terms.as_slice() {
            [(Powers::ONE, k)] => Some(k),
            _ => None,
        }
    }

    /// Product of the polynomial and a number, which must not be 0.
    pub fn scaled(&self, k: &Rational) -> Self {
        Self { terms: self.terms.iter().map(|(m, c)| (*m, c.mul(k))).collect() }
    }

    /// Splits the polynomial into its content, which is a number, and its primitive part. The
    /// primitive part has integer coefficients without a common factor, and its first coefficient
    /// is positive.
    pub fn split_content(&self) -> (Rational, Self) {
        let Some((_, first)) = self.terms.first() else { return (Rational::ONE, Self::default()) };
        let size = self.terms.iter().fold(Rational::ZERO, |g, (_, k)| g.greatest_common_divisor(k));
        let content = if first.is_negative() { size.neg() } else { size };
        let inverse = content.reciprocal().expect("a coefficient is not zero");
        (content, self.scaled(&inverse))
    }

    /// Largest monomial that divides every term of the polynomial.
    pub fn common_powers(&self) -> Powers {
        let mut terms = self.terms.iter();
        let first = terms.next().map_or(Powers::ONE, |(m, _)| *m);
        terms.fold(first, |common, (m, _)| common.common(m))
    }

    /// True if the generator occurs in the polynomial. The generator is a variable of the ring,
    /// given by its number.
    fn mentions(&self, generator: usize) -> bool {
        self.terms.iter().any(|(m, _)| m.exponent_of(generator) > 0)
    }
}

/// Square of a generator (a variable of the polynomial ring), as far as it is known.
#[derive(Clone)]
pub enum Square {
    /// The generator is independent: its square is not rewritten.
    Free,
    /// The generator is a sine; the number is that of the generator for its cosine, and sin²
    /// becomes 1 − cos².
    Sine(usize),
    /// The generator is the square root of the polynomial, which replaces its square.
    Root(RingPolynomial),
}

/// Polynomial ring over the rational numbers: its generators (the variables), and a budget of
/// multiplications.
#[derive(Clone)]
pub struct Ring {
    /// Generators by number: the expression of each, and its known square.
    generators: Vec<(Expr, Square)>,
    /// Number of each generator (a variable of the ring), by the expression that it stands for.
    numbers: FxHashMap<Expr, usize>,
    /// Number of multiplications of terms that are still allowed. When it is used up, operations of
    /// the ring return `None`.
    pub budget: u64,
}

impl Ring {
    /// Creates a ring without generators. The budget is the number of multiplications of terms that
    /// are allowed.
    pub fn new(budget: u64) -> Self {
        Self { generators: Vec::new(), numbers: FxHashMap::default(), budget }
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
            let mut sum: FxHashMap<Powers, Rational> = above.terms.into_iter().collect();
            for (n, d) in &below.terms {
                add_ring_term(&mut sum, step.0.times(n)?, step.1.mul(d).neg());
            }
            above = polynomial_of_sum(sum);
            quotient.push(step);
        }
        Some(RingPolynomial { terms: quotient })
    }
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
