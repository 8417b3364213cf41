//! Point of a polynomial ring modulo a prime, which shows that most trial divisions must fail.
//!
//! A point gives numbers of a prime field to all generators (variables) but one, or but one angle, which stays a
//! variable t. It turns polynomials of the ring into polynomials in t. If b divides a, the polynomial of b divides that
//! of a. So a remainder that is not 0 shows that b does not divide a, at the cost of an evaluation of each, where a
//! division multiplies both by conjugates. The converse does not hold, so that a division still decides.

use super::ring_polynomial::{GENERATORS, Powers, RingPolynomial, Square};
use crate::algebra::Rational;
use crate::algebra::value::field::{Field, Generator};
use std::collections::BTreeMap;

/// Values of the generators of a ring modulo a prime. They satisfy all known squares.
#[derive(Clone)]
pub struct RingPoint {
    /// Field of the values.
    field: Field,
    /// State of the source of random numbers.
    draws: u64,
    /// Generators, in the order of the ring.
    generators: Vec<PointGenerator>,
}

/// Generator of a ring at a point.
#[derive(Clone)]
struct PointGenerator {
    /// Value; `None` if it is the root of a number without a root.
    value: Option<u64>,
    /// Relation of the generator to earlier ones.
    kind: PointKind,
}

/// Relation of a generator to earlier ones.
#[derive(Clone, Copy)]
enum PointKind {
    /// The generator is independent.
    Free {
        /// Number s with s² + value² = 1.
        partner: u64,
        /// Number of the sine, if the generator is a cosine.
        sine: Option<usize>,
    },
    /// The generator is a sine.
    Sine,
    /// The generator is a root. The mask has a bit for each generator on which the root depends, and for the sine and
    /// the cosine of each angle.
    Root(u64),
}

const _: () = assert!(GENERATORS <= 64, "a mask has a bit for each generator");

/// Variable of the polynomials into which a point turns polynomials of the ring.
#[derive(Clone, Copy)]
enum PointVariable {
    /// One generator.
    Generator(usize),
    /// Tangent t of half an angle, whose cosine and sine are (1 − t²)/(1 + t²) and 2 t/(1 + t²).
    HalfAngle {
        /// Number of the cosine.
        cosine: usize,
        /// Number of the sine.
        sine: usize,
    },
}

/// Polynomial in one variable over a prime field: its coefficients, from the constant one on.
type FieldPolynomial = Vec<u64>;

impl PointVariable {
    /// Mask of the generators that depend on the variable.
    fn mask(self) -> u64 {
        match self {
            Self::Generator(at) => 1 << at,
            Self::HalfAngle { cosine, sine } => 1 << cosine | 1 << sine,
        }
    }

    /// Exponents of the cosine and of the sine in a monomial; for a generator, its exponent and 0.
    fn exponents(self, powers: &Powers) -> (usize, usize) {
        let exponent = |at| usize::from(powers.exponent_of(at));
        match self {
            Self::Generator(at) => (exponent(at), 0),
            Self::HalfAngle { cosine, sine } => (exponent(cosine), exponent(sine)),
        }
    }
}

impl RingPoint {
    /// Creates a point without generators. All points have the same prime and the same values.
    pub fn new() -> Self {
        let mut generator = Generator(0x7469_7269);
        let field = Field::random(&mut generator);
        Self { field, draws: generator.0, generators: Vec::new() }
    }

    /// Adds the value of a further generator with the given known square.
    pub fn add_generator(&mut self, square: &Square) {
        let number = self.generators.len();
        let (value, kind) = match square {
            Square::Free => {
                let (value, partner) = self.point_of_circle();
                (Some(value), PointKind::Free { partner, sine: None })
            }
            Square::Sine(cosine) => match &mut self.generators[*cosine].kind {
                PointKind::Free { partner, sine } => {
                    *sine = Some(number);
                    (Some(*partner), PointKind::Sine)
                }
                PointKind::Sine | PointKind::Root(_) => (None, PointKind::Sine),
            },
            Square::Root(radicand) => {
                let mut mask = 0;
                for at in (0..number).filter(|at| radicand.mentions(*at)) {
                    mask |= 1 << at;
                    match self.generators[at].kind {
                        PointKind::Free { sine, .. } => mask |= sine.map_or(0, |sine| 1 << sine),
                        PointKind::Sine => mask |= self.cosine_of(at).map_or(0, |cosine| 1 << cosine),
                        PointKind::Root(more) => mask |= more,
                    }
                }
                let value = self.value_of(radicand).and_then(|square| self.field.root(square));
                (value, PointKind::Root(mask))
            }
        };
        self.generators.push(PointGenerator { value, kind });
    }

    /// Number of the cosine that belongs to a sine.
    fn cosine_of(&self, of_sine: usize) -> Option<usize> {
        let is_cosine = |g: &PointGenerator| matches!(g.kind, PointKind::Free { sine, .. } if sine == Some(of_sine));
        self.generators.iter().position(is_cosine)
    }

    /// Random point (c, s) of the circle c² + s² = 1.
    fn point_of_circle(&mut self) -> (u64, u64) {
        let field = self.field;
        let mut generator = Generator(self.draws);
        let t = generator.next() % field.prime;
        self.draws = generator.0;
        let square = field.mul(t, t);
        let inverse =
            field.inverse(field.add(1, square)).expect("−1 is no square in the field, so that 1 + t² is not 0");
        (field.mul(field.sub(1, square), inverse), field.mul(field.add(t, t), inverse))
    }

    /// True if the point shows that `b` does not divide `a`. False if nothing is shown.
    pub fn refutes_division(&self, a: &RingPolynomial, b: &RingPolynomial) -> bool {
        let variables = self.generators.iter().enumerate().filter_map(|(at, generator)| match generator.kind {
            PointKind::Free { sine: Some(sine), .. } => Some(PointVariable::HalfAngle { cosine: at, sine }),
            PointKind::Free { sine: None, .. } => Some(PointVariable::Generator(at)),
            PointKind::Sine | PointKind::Root(_) => None,
        });
        variables.into_iter().find_map(|variable| self.leaves_remainder(a, b, variable)).unwrap_or(false)
    }

    /// True if the polynomial of `b` in one variable does not divide that of `a`. `None` if `b` is no polynomial in
    /// this variable, or is constant in it.
    fn leaves_remainder(&self, a: &RingPolynomial, b: &RingPolynomial, variable: PointVariable) -> Option<bool> {
        let opaque = self.opaque_roots(variable);
        let divisor = self.polynomial_in(variable, &b.terms, opaque)?;
        if divisor.len() < 2 {
            return None;
        }
        // A factor 1 + t² of b would be lost in the common denominator of sines and cosines.
        let circle = [1, 0, 1];
        if matches!(variable, PointVariable::HalfAngle { .. }) && self.remainder(divisor.clone(), &circle).is_empty() {
            return None;
        }
        // Since b has no opaque root, it divides a exactly if it divides the coefficient of each product of such roots.
        let roots: Vec<usize> = (0..GENERATORS).filter(|at| opaque >> at & 1 == 1).collect();
        let mut coefficients: BTreeMap<Powers, Vec<(Powers, Rational)>> = BTreeMap::new();
        for (powers, k) in &a.terms {
            let (roots, rest) = powers.split(&roots);
            coefficients.entry(roots).or_default().push((rest, k.clone()));
        }
        let mut is_shown = false;
        for terms in coefficients.values() {
            let polynomial = self.polynomial_in(variable, terms, opaque)?;
            is_shown |= !self.remainder(polynomial, &divisor).is_empty();
        }
        Some(is_shown)
    }

    /// Mask of the roots that have no value once a variable has none.
    fn opaque_roots(&self, variable: PointVariable) -> u64 {
        let is_opaque = |generator: &PointGenerator| match generator.kind {
            PointKind::Root(mask) => generator.value.is_none() || mask & variable.mask() != 0,
            PointKind::Free { .. } | PointKind::Sine => generator.value.is_none(),
        };
        let masks = self.generators.iter().enumerate().map(|(at, generator)| u64::from(is_opaque(generator)) << at);
        masks.fold(0, |all, mask| all | mask)
    }

    /// Polynomial in one variable with the given terms, times a power of 1 + t² if the variable is an angle. Its last
    /// coefficient is not 0. `None` if the terms contain a generator of the mask `opaque`.
    fn polynomial_in(
        &self,
        variable: PointVariable,
        terms: &[(Powers, Rational)],
        opaque: u64,
    ) -> Option<FieldPolynomial> {
        let field = self.field;
        let mut coefficients: BTreeMap<(usize, usize), u64> = BTreeMap::new();
        for (powers, k) in terms {
            let mut product = field.residue_of_rational(k)?;
            for (at, generator) in self.generators.iter().enumerate() {
                let exponent = powers.exponent_of(at);
                if exponent == 0 || variable.mask() >> at & 1 == 1 {
                    continue;
                }
                let value = generator.value.filter(|_| opaque >> at & 1 == 0)?;
                product = field.mul(product, field.pow(value, u64::from(exponent)));
            }
            let sum = coefficients.entry(variable.exponents(powers)).or_default();
            *sum = field.add(*sum, product);
        }
        let degree = coefficients.keys().map(|(i, j)| i + j).max().unwrap_or(0);
        let mut sum = Vec::new();
        for ((i, j), k) in coefficients {
            let mut product = vec![k];
            match variable {
                PointVariable::Generator(_) => product.splice(0..0, std::iter::repeat_n(0, i)).for_each(drop),
                PointVariable::HalfAngle { .. } => {
                    let factors = [([1, 0, field.sub(0, 1)], i), ([0, 2, 0], j), ([1, 0, 1], degree - i - j)];
                    for (factor, exponent) in factors {
                        for _ in 0..exponent {
                            product = self.product(&product, &factor);
                        }
                    }
                }
            }
            sum.resize(sum.len().max(product.len()), 0);
            for (sum, k) in sum.iter_mut().zip(product) {
                *sum = field.add(*sum, k);
            }
        }
        Some(without_leading_zeros(sum))
    }

    /// Product of two polynomials in one variable.
    fn product(&self, a: &[u64], b: &[u64]) -> FieldPolynomial {
        let mut product = vec![0; a.len() + b.len() - 1];
        for (i, a) in a.iter().enumerate() {
            for (j, b) in b.iter().enumerate() {
                product[i + j] = self.field.add(product[i + j], self.field.mul(*a, *b));
            }
        }
        product
    }

    /// Remainder of a division of polynomials in one variable. The last coefficient of `divisor` is not 0.
    fn remainder(&self, mut polynomial: FieldPolynomial, divisor: &[u64]) -> FieldPolynomial {
        let field = self.field;
        let Some(inverse) = divisor.last().and_then(|last| field.inverse(*last)) else { return polynomial };
        while polynomial.len() >= divisor.len() {
            let from = polynomial.len() - divisor.len();
            let factor = field.mul(polynomial[polynomial.len() - 1], inverse);
            for (k, d) in polynomial[from..].iter_mut().zip(divisor) {
                *k = field.sub(*k, field.mul(factor, *d));
            }
            polynomial = without_leading_zeros(polynomial);
        }
        polynomial
    }

    /// Value of a polynomial at the point; `None` if it contains a generator without a value.
    fn value_of(&self, polynomial: &RingPolynomial) -> Option<u64> {
        let field = self.field;
        let mut sum = 0;
        for (powers, k) in &polynomial.terms {
            let mut product = field.residue_of_rational(k)?;
            for (at, generator) in self.generators.iter().enumerate().filter(|(at, _)| powers.exponent_of(*at) > 0) {
                product = field.mul(product, field.pow(generator.value?, u64::from(powers.exponent_of(at))));
            }
            sum = field.add(sum, product);
        }
        Some(sum)
    }
}

/// Removes coefficients 0 from the end of a polynomial.
fn without_leading_zeros(mut polynomial: FieldPolynomial) -> FieldPolynomial {
    let length = polynomial.iter().rposition(|k| *k != 0).map_or(0, |last| last + 1);
    polynomial.truncate(length);
    polynomial
}

#[cfg(test)]
mod tests {
    use super::super::ring::Ring;
    use super::*;
    use crate::algebra::Arena;

    /// Goal: multiples are never refuted, and others are. Method: products of sums in a free generator, an angle and a
    /// root of both, with and without 1 added.
    #[test]
    fn only_divisions_that_fail_are_refuted() {
        let (mut arena, mut ring, mut point) = (Arena::new(), Ring::new(1_000_000), RingPoint::new());
        let mut variable = |ring: &mut Ring, name: &str, square: Square| {
            point.add_generator(&square);
            Ring::variable(ring.generator(arena.symbol(name), |_| Some(square)).unwrap())
        };
        let x = variable(&mut ring, "x", Square::Free);
        let c = variable(&mut ring, "c", Square::Free);
        let s = variable(&mut ring, "s", Square::Sine(1));
        let sum = |ring: &mut Ring, parts: &[(&RingPolynomial, i64)]| {
            ring.sum(parts.iter().map(|(p, k)| (*p, Rational::integer(*k)))).unwrap()
        };
        let one = RingPolynomial::constant(&Rational::ONE);
        let linear = sum(&mut ring, &[(&x, 3), (&c, 1), (&one, 2)]);
        let angle = sum(&mut ring, &[(&c, 4), (&s, 3), (&one, -2)]);
        let [square, double] = [(&x, &x), (&c, &s)].map(|(a, b)| ring.mul(a, b).unwrap());
        let quadratic = sum(&mut ring, &[(&square, 1), (&double, 5), (&s, -7)]);
        let root = variable(&mut ring, "r", Square::Root(quadratic.clone()));
        let with_root = sum(&mut ring, &[(&root, 2), (&x, 1)]);
        let mut refuted = 0;
        for divisor in [&linear, &angle, &quadratic] {
            for other in [&linear, &angle, &quadratic, &square, &with_root] {
                let product = ring.mul(divisor, other).unwrap();
                assert!(!point.refutes_division(&product, divisor));
                assert!(ring.divide(&product, divisor).is_some_and(|quotient| quotient == *other));
                let more = sum(&mut ring, &[(&product, 1), (&one, 1)]);
                refuted += usize::from(point.refutes_division(&more, divisor));
                assert!(ring.divide(&more, divisor).is_none());
            }
        }
        assert_eq!(refuted, 15);
    }
}
