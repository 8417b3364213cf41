//! Constructors of terms in canonical form: like terms are collected, powers of one base merged, and
//! known function values resolved.

use super::elementary::canonical_function_value;
use crate::algebra::{Arena, Expr, Function, Node, PowerError, Rational};

impl Arena {
    /// Builds the term for an exact rational number.
    pub fn number(&mut self, value: Rational) -> Expr {
        self.intern(Node::Number(value))
    }

    /// Builds the term for an integer.
    pub fn integer(&mut self, n: i64) -> Expr {
        self.number(Rational::integer(n))
    }

    /// Builds the term for the fraction n/d, an exact number.
    ///
    /// # Panics
    /// If d is 0. The method is meant for literal fractions in code.
    pub fn ratio(&mut self, n: i64, d: i64) -> Expr {
        self.number(Rational::fraction(n, d).expect("a literal fraction"))
    }

    /// Builds the term for the number π.
    pub fn pi(&mut self) -> Expr {
        self.intern(Node::Pi)
    }

    /// Adds `scale · e` to a sum under construction. The sum is kept as a constant and a list of
    /// pairs (term, coefficient).
    fn accumulate(&self, e: Expr, scale: &Rational, constant: &mut Rational, terms: &mut Vec<(Expr, Rational)>) {
        match self.node(e) {
            Node::Number(value) => *constant = constant.add(&value.mul(scale)),
            Node::Sum(c, inner) => {
                *constant = constant.add(&c.mul(scale));
                terms.extend(inner.iter().map(|(term, k)| (*term, k.mul(scale))));
            }
            _ => terms.push((e, scale.clone())),
        }
    }

    /// Builds the sum constant + Σ k · term from the pairs (term, k), with like terms collected.
    fn finish_sum(&mut self, constant: Rational, mut terms: Vec<(Expr, Rational)>) -> Expr {
        terms.sort_by_key(|(term, _)| *term);
        let mut merged: Vec<(Expr, Rational)> = Vec::with_capacity(terms.len());
        for (term, k) in terms {
            match merged.last_mut() {
                Some((last, sum)) if *last == term => *sum = sum.add(&k),
                _ => merged.push((term, k)),
            }
        }
        merged.retain(|(_, k)| !k.is_zero());
        match merged.as_slice() {
            [] => self.number(constant),
            [(term, k)] if constant.is_zero() && k.is_one() => *term,
            _ => self.intern(Node::Sum(constant, merged.into())),
        }
    }

    /// Sum of the given terms, with like terms collected. The time is linear in the number of
    /// terms, except for sorting.
    pub fn sum(&mut self, terms: &[Expr]) -> Expr {
        let (mut constant, mut collected) = (Rational::ZERO, Vec::with_capacity(terms.len()));
        for &e in terms {
            self.accumulate(e, &Rational::ONE, &mut constant, &mut collected);
        }
        self.finish_sum(constant, collected)
    }

    /// Linear combination Σ k · e of the pairs (e, k).
    pub fn linear_combination(&mut self, terms: &[(Expr, Rational)]) -> Expr {
        let (mut constant, mut collected) = (Rational::ZERO, Vec::with_capacity(terms.len()));
        for (e, k) in terms {
            self.accumulate(*e, k, &mut constant, &mut collected);
        }
        self.finish_sum(constant, collected)
    }

    /// Sum a + b of two terms.
    pub fn add(&mut self, a: Expr, b: Expr) -> Expr {
        match (a, b) {
            (Expr::ZERO, x) | (x, Expr::ZERO) => x,
            _ => self.sum(&[a, b]),
        }
    }

    /// Difference a − b of two terms.
    pub fn sub(&mut self, a: Expr, b: Expr) -> Expr {
        if a == b {
            return Expr::ZERO;
        }
        self.linear_combination(&[(a, Rational::ONE), (b, Rational::MINUS_ONE)])
    }

    /// Negative −a of a term.
    pub fn neg(&mut self, a: Expr) -> Expr {
        self.scale(a, &Rational::MINUS_ONE)
    }

    /// Product k · a of a term and a rational number.
    pub fn scale(&mut self, a: Expr, k: &Rational) -> Expr {
        if k.is_one() {
            return a;
        }
        self.linear_combination(&[(a, k.clone())])
    }

    /// Splits a sum into its content, a rational factor with the sign of the first coefficient, and
    /// a sum with content 1. A number is returned as (number, 1). Any other term is returned with
    /// the factor 1.
    pub fn split_content(&mut self, e: Expr) -> (Rational, Expr) {
        let content = match self.node(e) {
            Node::Number(value) => return (value.clone(), Expr::ONE),
            // Most sums have integer coefficients, and the first coefficient is 1: their content is 1.
            Node::Sum(constant, terms)
                if terms[0].1.is_one() && constant.is_integer() && terms.iter().all(|(_, k)| k.is_integer()) =>
            {
                return (Rational::ONE, e);
            }
            Node::Sum(constant, terms) => {
                let all = terms.iter().fold(constant.clone(), |g, (_, k)| g.greatest_common_divisor(k));
                let all = if all.is_negative() { all.neg() } else { all };
                if terms[0].1.is_negative() { all.neg() } else { all }
            }
            _ => return (Rational::ONE, e),
        };
        let inverse = content.reciprocal().expect("the content of a non-zero sum is not zero");
        (content, self.scale(e, &inverse))
    }

    /// Multiplies a product under construction by `e^n`. The product is kept as a number
    /// `coefficient` and a list of pairs (base, exponent). Error for a negative power of 0, or for
    /// a number that is too large.
    fn accumulate_power(
        &mut self,
        e: Expr,
        n: i32,
        coefficient: &mut Rational,
        factors: &mut Vec<(Expr, i64)>,
    ) -> Result<(), PowerError> {
        let (content, primitive) = self.split_content(e);
        if content.is_zero() && n < 0 {
            return Err(PowerError::DivisionByZero);
        }
        *coefficient = coefficient.mul(&content.pow(n).ok_or(PowerError::TooLarge)?);
        match self.node(primitive) {
            Node::Number(_) => {}
            Node::Product(inner) => {
                factors.extend(inner.iter().map(|(base, k)| (*base, i64::from(*k) * i64::from(n))));
            }
            _ => factors.push((primitive, i64::from(n))),
        }
        Ok(())
    }

    /// Builds the product coefficient · Π base^exponent from the pairs (base, exponent), with
    /// powers of one base merged.
    /// Error if an exponent or a number is too large.
    fn finish_product(&mut self, coefficient: &Rational, mut factors: Vec<(Expr, i64)>) -> Result<Expr, PowerError> {
        if coefficient.is_zero() {
            return Ok(Expr::ZERO);
        }
        factors.sort_by_key(|(base, _)| *base);
        let mut merged: Vec<(Expr, i64)> = Vec::with_capacity(factors.len());
        for (base, n) in factors {
            match merged.last_mut() {
                Some((last, sum)) if *last == base => *sum += n,
                _ => merged.push((base, n)),
            }
        }
        // √x² = x is valid where x ≥ 0, and √x has a value only there.
        let root = merged
            .iter()
            .position(|&(base, n)| matches!(self.node(base), Node::Apply(Function::Sqrt, _)) && !(0..=1).contains(&n));
        if let Some(at) = root {
            let (base, n) = merged.remove(at);
            let Node::Apply(_, argument) = *self.node(base) else { unreachable!("found as a square root") };
            let half = i32::try_from(n.div_euclid(2)).map_err(|_| PowerError::TooLarge)?;
            let mut scale = coefficient.clone();
            self.accumulate_power(argument, half, &mut scale, &mut merged)?;
            if n.rem_euclid(2) == 1 {
                merged.push((base, 1));
            }
            return self.finish_product(&scale, merged);
        }
        let mut result = Vec::with_capacity(merged.len());
        for (base, n) in merged.into_iter().filter(|(_, n)| *n != 0) {
            let n = i32::try_from(n).ok().filter(|n| n.abs() <= Self::MAX_EXPONENT).ok_or(PowerError::TooLarge)?;
            result.push((base, n));
        }
        let monomial = match result.as_slice() {
            [] => return Ok(self.number(coefficient.clone())),
            [(base, 1)] => *base,
            _ => self.intern(Node::Product(result.into())),
        };
        Ok(self.scale(monomial, coefficient))
    }

    /// Product Π base^exponent over the pairs (base, exponent).
    ///
    /// # Errors
    /// [`PowerError`] for a negative power of the literal 0, and for an exponent or a number that
    /// is too large.
    pub fn try_product(&mut self, factors: &[(Expr, i32)]) -> Result<Expr, PowerError> {
        let (mut coefficient, mut collected) = (Rational::ONE, Vec::with_capacity(factors.len()));
        for &(e, n) in factors {
            if n != 0 {
                self.accumulate_power(e, n, &mut coefficient, &mut collected)?;
            }
        }
        self.finish_product(&coefficient, collected)
    }

    /// Product a · b of two terms.
    ///
    /// # Panics
    /// If an exponent exceeds [`Self::MAX_EXPONENT`]; the parser keeps all input far below.
    pub fn mul(&mut self, a: Expr, b: Expr) -> Expr {
        match (a, b) {
            (Expr::ZERO, _) | (_, Expr::ZERO) => Expr::ZERO,
            (Expr::ONE, x) | (x, Expr::ONE) => x,
            _ => self.try_product(&[(a, 1), (b, 1)]).expect("exponents far below the limit"),
        }
    }

    /// Product of the given factors, each to the power 1.
    ///
    /// # Panics
    /// If an exponent exceeds `MAX_EXPONENT`, as in [`Self::mul`].
    pub fn product(&mut self, factors: &[Expr]) -> Expr {
        let powers: Vec<(Expr, i32)> = factors.iter().map(|e| (*e, 1)).collect();
        self.try_product(&powers).expect("exponents far below the limit")
    }

    /// Quotient a / b; `None` if b is the literal 0. The caller must make sure that b is not
    /// identically zero.
    pub fn div(&mut self, a: Expr, b: Expr) -> Option<Expr> {
        self.try_product(&[(a, 1), (b, -1)]).ok()
    }

    /// Power eⁿ of a term, for an integer n of either sign.
    ///
    /// # Errors
    /// [`PowerError`] for a negative power of the literal 0, and for an exponent or a number that
    /// is too large.
    pub fn pow(&mut self, e: Expr, n: i32) -> Result<Expr, PowerError> {
        self.try_product(&[(e, n)])
    }

    /// Square e² of a term.
    pub fn square(&mut self, e: Expr) -> Expr {
        self.mul(e, e)
    }

    /// Builds the function value f(argument). Values at 0 and at multiples of π/2, and the
    /// symmetries of even and odd functions, are resolved.
    pub fn apply(&mut self, f: Function, argument: Expr) -> Expr {
        canonical_function_value(self, f, argument)
    }

    /// Sine of the term e, an angle in radians.
    pub fn sin(&mut self, e: Expr) -> Expr {
        self.apply(Function::Sin, e)
    }

    /// Cosine of the term e, an angle in radians.
    pub fn cos(&mut self, e: Expr) -> Expr {
        self.apply(Function::Cos, e)
    }

    /// Builds the function value f(argument) without any simplification.
    pub(super) fn intern_apply(&mut self, f: Function, argument: Expr) -> Expr {
        self.intern(Node::Apply(f, argument))
    }
}
