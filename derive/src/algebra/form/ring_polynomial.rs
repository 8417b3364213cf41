//! Polynomials of a ring: exponents, terms, and the known squares of generators.

use crate::algebra::Rational;

/// Largest number of generators (variables) that a ring may have.
pub const GENERATORS: usize = 64;
/// Exponents of a monomial, one for each generator (a variable of the polynomial ring). Their
/// lexicographic order is a monomial order.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Powers(pub [u8; GENERATORS]);

impl Powers {
    /// Exponents of the monomial 1: all are 0.
    pub const ONE: Self = Self([0; GENERATORS]);

    /// Exponent of a generator in the monomial. The generator is a variable of the ring, given by
    /// its number.
    pub fn exponent_of(&self, generator: usize) -> u8 {
        self.0[generator]
    }

    /// Returns the monomial with the exponent of one generator (a variable of the ring) replaced.
    pub fn with_exponent(mut self, generator: usize, exponent: u8) -> Self {
        self.0[generator] = exponent;
        self
    }

    /// Product of two monomials; `None` if an exponent exceeds 255.
    pub fn times(&self, other: &Self) -> Option<Self> {
        // One loop without exits, which compilers turn into vector instructions.
        let (mut result, mut has_overflow) = (*self, false);
        for (a, b) in result.0.iter_mut().zip(&other.0) {
            let sum = a.wrapping_add(*b);
            has_overflow |= sum < *a;
            *a = sum;
        }
        (!has_overflow).then_some(result)
    }

    /// Quotient `self` / `other` of two monomials; `None` if an exponent would be negative.
    pub fn over(&self, other: &Self) -> Option<Self> {
        let (mut result, mut is_negative) = (*self, false);
        for (a, b) in result.0.iter_mut().zip(&other.0) {
            is_negative |= *a < *b;
            *a = a.wrapping_sub(*b);
        }
        (!is_negative).then_some(result)
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

    /// True if an exponent of the monomial exceeds the largest exponent of its generator.
    pub fn exceeds(&self, largest: &Self) -> bool {
        let mut exceeds = false;
        for (a, most) in self.0.iter().zip(&largest.0) {
            exceeds |= a > most;
        }
        exceeds
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

/// Polynomial of a [`super::ring::Ring`], with rational coefficients.
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
    pub fn mentions(&self, generator: usize) -> bool {
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
