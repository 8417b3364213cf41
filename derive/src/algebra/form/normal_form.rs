//! Normal form of terms: fractions of polynomials over ℚ in symbols, in sines and cosines of base
//! angles, and in roots.
//!
//! Every angle is expanded to Σ k·atom. The base angle of an atom is the atom divided by the common
//! denominator of its k. The addition theorems then give the sine and cosine of each angle in those
//! of base angles.
//! With sin² = 1 − cos² and √x² = x, no relation is left between the generators, unless roots or
//! functions without rules occur. So a fraction is identically zero exactly if its numerator has no
//! terms; [`Normalizer::zero_by_normal_form`] says if this holds.

use super::fraction::Fraction;
use super::polynomial::{LaurentPolynomial, Monomial};
use super::ring::Ring;
use super::ring_polynomial::{GENERATORS, RingPolynomial, Square};
use crate::algebra::term::elementary::{angle_atoms, divided_term_by_term, is_exponential, is_plain_angle_atom};
use crate::algebra::value::zero_test::{has_roots, zero_test_is_proof};
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use num_integer::Integer;
use rustc_hash::FxHashMap;
use std::rc::Rc;

/// Answer of the normal form to the question if a term is identically zero.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Zero {
    /// The term is proved to be identically zero.
    Yes,
    /// The term is proved not to be identically zero, since the generators of its normal form are
    /// independent.
    No,
    /// The normal form is not zero, but it has roots, exponentials or functions without rules,
    /// which may be related in unknown ways.
    Unknown,
    /// The term has no normal form within the budget, or it divides by zero.
    TooLarge,
}

/// Converter of terms to normal forms. It stores the normal form of every term that it has
/// converted.
pub struct Normalizer {
    /// Polynomial ring in which all normal forms are written.
    ring: Ring,
    /// Normal form of each term so far; `None` if the term has none within the budget.
    forms: FxHashMap<Expr, Option<Rc<Fraction>>>,
    /// Divisor of each atom: a term without a sum, such as q₁, of which angles are multiples. The
    /// base angle is the atom divided by this number.
    parts_of_turn: FxHashMap<Expr, i64>,
    /// True if named terms are independent generators; false if a named term has the normal form of the term that it
    /// abbreviates.
    names_are_generators: bool,
}

impl Default for Normalizer {
    fn default() -> Self {
        Self::new(Self::BUDGET)
    }
}

impl Normalizer {
    /// Usual budget for one normal form: a number of multiplications of terms that takes about a
    /// second.
    pub const BUDGET: u64 = 2_000_000;

    /// Creates a normalizer. The budget is the number of multiplications of terms that all its
    /// conversions together may use.
    #[must_use]
    pub fn new(budget: u64) -> Self {
        Self {
            ring: Ring::new(budget),
            forms: FxHashMap::default(),
            parts_of_turn: FxHashMap::default(),
            names_are_generators: false,
        }
    }

    /// Creates a normalizer to which named terms are independent generators. The terms of its normal forms equal the
    /// given terms, but a term whose normal form is not zero may be zero. The budget is that of [`Self::new`].
    #[must_use]
    pub fn for_rewriting(budget: u64) -> Self {
        Self { names_are_generators: true, ..Self::new(budget) }
    }

    /// Sets the number of multiplications of terms that are still allowed. If the ring has its
    /// largest number of generators, the ring and all normal forms are dropped first.
    pub fn set_budget(&mut self, budget: u64) {
        if self.ring.size() == GENERATORS {
            self.ring = Ring::new(0);
            self.forms.clear();
        }
        if self.ring.budget == 0 {
            self.forms.retain(|_, form| form.is_some());
        }
        self.ring.budget = budget;
    }

    /// Tests if the term `e` is identically zero, by its normal form.
    pub fn zero_by_normal_form(&mut self, arena: &mut Arena, e: Expr) -> Zero {
        match self.normal_form(arena, e) {
            None => Zero::TooLarge,
            Some(form) if form.is_zero() => Zero::Yes,
            Some(_) => {
                let parts = arena.reachable(&[e]);
                // Exponentials are generators here, and related to one another.
                let is_power = |part: &Expr| matches!(arena.node(*part), Node::Apply(f, _) if is_exponential(*f));
                let is_told =
                    zero_test_is_proof(arena, &parts) && !has_roots(arena, &parts) && !parts.iter().any(is_power);
                if is_told { Zero::No } else { Zero::Unknown }
            }
        }
    }

    /// Normal form of the term `e`; `None` if it is too large for the budget, or if the term
    /// divides by zero.
    pub fn normal_form(&mut self, arena: &mut Arena, e: Expr) -> Option<Rc<Fraction>> {
        if let Some(done) = self.forms.get(&e) {
            return done.clone();
        }
        let parts = if self.names_are_generators { arena.subterms_up_to_names(&[e]) } else { arena.reachable(&[e]) };
        self.refine_angles(arena, &parts);
        for part in parts {
            if !self.forms.contains_key(&part) {
                let form = self.normal_form_of_node(arena, part).map(Rc::new);
                self.forms.insert(part, form);
            }
        }
        self.forms[&e].clone()
    }

    /// Refines the base angles until every angle in the listed terms is a whole multiple of base
    /// angles. The normal forms of all these terms are then polynomials and fractions of the same
    /// ring.
    pub fn prepare(&mut self, arena: &Arena, list: &[Expr]) {
        let parts = arena.reachable(list);
        self.refine_angles(arena, &parts);
    }

    /// Polynomial ring in which all normal forms found so far are written.
    pub fn ring(&mut self) -> &mut Ring {
        &mut self.ring
    }

    /// Term for which a generator stands. The generator is a variable of the ring, given by its
    /// number.
    #[must_use]
    pub fn expression_of(&self, generator: usize) -> Expr {
        self.ring.expression(generator)
    }

    /// Numbers of the generators (variables of the ring) that depend on no symbols other than
    /// `symbols`.
    #[must_use]
    pub fn generators_in(&self, arena: &Arena, symbols: &[Expr]) -> Vec<usize> {
        let known = |e: &Expr| arena.symbol_name(*e).is_none() || symbols.contains(e);
        (0..self.ring.size()).filter(|at| arena.reachable(&[self.ring.expression(*at)]).iter().all(known)).collect()
    }

    /// Refines the base angles until every angle among the terms `parts` is a whole multiple of
    /// base angles. If a base angle changes, all normal forms so far are dropped.
    fn refine_angles(&mut self, arena: &Arena, parts: &[Expr]) {
        let mut finer = false;
        for part in parts {
            if let Node::Apply(Function::Sin | Function::Cos, argument) = arena.node(*part) {
                for (atom, k) in angle_atoms(arena, *argument) {
                    let d = k.small().map_or(1, |(_, d)| d);
                    let known = self.parts_of_turn.get(&atom).copied().unwrap_or(1);
                    // The divisor of an angle stays unchanged if it would not fit a 64-bit integer;
                    // a term with this angle has no normal form.
                    let common = (known / known.gcd(&d)).checked_mul(d).unwrap_or(known);
                    finer |= common != known;
                    self.parts_of_turn.insert(atom, common);
                }
            }
        }
        if finer {
            self.forms.clear();
            self.ring = Ring::new(self.ring.budget);
        }
    }

    /// Normal form of a term from the normal forms of its operands; `None` if it is too large or
    /// divides by zero.
    fn normal_form_of_node(&mut self, arena: &mut Arena, e: Expr) -> Option<Fraction> {
        match arena.node(e).clone() {
            Node::Number(value) => Some(Fraction::from_polynomial(RingPolynomial::constant(&value))),
            Node::Symbol(_) | Node::Pi => self.independent_generator(e),
            Node::Named(..) if self.names_are_generators => self.independent_generator(e),
            Node::Named(_, term) => self.forms[&term].as_deref().cloned(),
            Node::Sum(constant, terms) => {
                let constant = Fraction::from_polynomial(RingPolynomial::constant(&constant));
                let forms: Option<Vec<Rc<Fraction>>> = terms.iter().map(|(term, _)| self.forms[term].clone()).collect();
                let forms = forms?;
                let coefficients = terms.iter().map(|(_, k)| k.clone());
                let mut parts: Vec<(&Fraction, Rational)> = forms.iter().map(Rc::as_ref).zip(coefficients).collect();
                parts.push((&constant, Rational::ONE));
                Fraction::sum(&mut self.ring, &parts)
            }
            Node::Product(factors) => {
                let mut product = Fraction::from_polynomial(RingPolynomial::constant(&Rational::ONE));
                for (base, n) in &factors {
                    let power = self.forms[base].clone()?.pow(&mut self.ring, *n)?;
                    product = product.mul(&mut self.ring, &power)?;
                }
                Some(product)
            }
            Node::Apply(f @ (Function::Sin | Function::Cos), argument) => self.circular(arena, f, argument),
            Node::Apply(f, argument) => {
                // Equal arguments must give equal generators.
                let argument = self.forms[&argument].clone()?;
                let canonical = self.expression(arena, &argument);
                let value = arena.apply(f, canonical);
                match arena.node(value) {
                    Node::Apply(Function::Sqrt, _) if argument.denominator.is_empty() => {
                        let radicand = argument.numerator.clone();
                        let root = self.ring.generator(value, |_| Some(Square::Root(radicand)))?;
                        Some(Fraction::from_polynomial(Ring::variable(root)))
                    }
                    Node::Apply(..) => self.independent_generator(value),
                    _ => {
                        // The value is a number or a multiple of another function value.
                        let (content, rest) = arena.split_content(value);
                        let rest = if rest == Expr::ONE { None } else { Some(self.independent_generator(rest)?) };
                        let content = Fraction::from_polynomial(RingPolynomial::constant(&content));
                        rest.map_or(Some(content.clone()), |rest| content.mul(&mut self.ring, &rest))
                    }
                }
            }
        }
    }

    /// Normal form of a term that is an independent generator; `None` if the ring is full.
    fn independent_generator(&mut self, e: Expr) -> Option<Fraction> {
        let number = self.ring.generator(e, |_| Some(Square::Free))?;
        Some(Fraction::from_polynomial(Ring::variable(number)))
    }

    /// Normal form of the sine or cosine of the angle Σ k·atom, by the addition theorems; `None` if
    /// it is too large.
    fn circular(&mut self, arena: &mut Arena, f: Function, argument: Expr) -> Option<Fraction> {
        let one = RingPolynomial::constant(&Rational::ONE);
        let mut total = (RingPolynomial::default(), one);
        for (atom, k) in self.expanded_angle(arena, argument)? {
            let mut d = self.parts_of_turn.get(&atom).copied().unwrap_or(1);
            if *arena.node(atom) == Node::Pi && 12 % d == 0 {
                d = 12;
            }
            let multiple = k.mul(&Rational::integer(d)).to_i64().filter(|n| n.unsigned_abs() <= 64)?;
            let base = arena.scale(atom, &Rational::fraction(1, d)?);
            let turn = self.multiple_of_base_angle(arena, base, multiple)?;
            total = self.sum_of_angles(&total, &turn)?;
        }
        Some(Fraction::from_polynomial(if f == Function::Sin { total.0 } else { total.1 }))
    }

    /// Splits an angle into Σ k·atom with atoms that are products, so that equal angles have equal
    /// atoms. `None` if the angle has no normal form.
    fn expanded_angle(&mut self, arena: &mut Arena, argument: Expr) -> Option<Vec<(Expr, Rational)>> {
        let atoms = angle_atoms(arena, argument);
        if atoms.iter().all(|(atom, _)| is_plain_angle_atom(arena, *atom)) {
            return Some(atoms);
        }
        let form = self.forms[&argument].clone()?;
        let expanded = self.expression(arena, &form);
        let expanded = divided_term_by_term(arena, expanded);
        Some(angle_atoms(arena, expanded))
    }

    /// Sine and cosine of n times a base angle, as two polynomials of the ring. `None` if the
    /// number of multiplications exceeds the budget or the ring is full.
    fn multiple_of_base_angle(
        &mut self,
        arena: &mut Arena,
        base: Expr,
        n: i64,
    ) -> Option<(RingPolynomial, RingPolynomial)> {
        let (mut sine, mut cosine) = (arena.sin(base), arena.cos(base));
        let pi = arena.pi();
        if base == arena.scale(pi, &Rational::fraction(1, 12)?) {
            (sine, cosine) = twelfth_of_pi(arena);
        }
        let is_generator = |e: Expr| matches!(arena.node(e), Node::Apply(Function::Sin | Function::Cos, _));
        if !is_generator(sine) || !is_generator(cosine) {
            // A multiple of π with exact values.
            let unit = (self.polynomial_of_number(arena, sine)?, self.polynomial_of_number(arena, cosine)?);
            return self.multiple_of_angle(&unit, n);
        }
        let cosine = self.ring.generator(cosine, |_| Some(Square::Free))?;
        let sine = self.ring.generator(sine, |_| Some(Square::Sine(cosine)))?;
        let unit = (Ring::variable(sine), Ring::variable(cosine));
        self.multiple_of_angle(&unit, n)
    }

    /// Sine and cosine of n times an angle, as two polynomials of the ring. `unit` is the pair
    /// (sin, cos) of the single angle. `None` if the budget of multiplications is used up.
    fn multiple_of_angle(
        &mut self,
        unit: &(RingPolynomial, RingPolynomial),
        n: i64,
    ) -> Option<(RingPolynomial, RingPolynomial)> {
        let mut result = (RingPolynomial::default(), RingPolynomial::constant(&Rational::ONE));
        for _ in 0..n.unsigned_abs() {
            result = self.sum_of_angles(&result, unit)?;
        }
        if n < 0 {
            result.0 = result.0.scaled(&Rational::MINUS_ONE);
        }
        Some(result)
    }

    /// Converts an exact number to a polynomial in square roots; `None` if it has a denominator or
    /// is too large.
    fn polynomial_of_number(&mut self, arena: &mut Arena, e: Expr) -> Option<RingPolynomial> {
        for part in arena.reachable(&[e]) {
            if !self.forms.contains_key(&part) {
                let form = self.normal_form_of_node(arena, part).map(Rc::new);
                self.forms.insert(part, form);
            }
        }
        let form = self.forms[&e].clone()?;
        form.denominator.is_empty().then(|| form.numerator.clone())
    }

    /// Sine and cosine of the sum of two angles, as two polynomials of the ring. Each angle is
    /// given as its pair (sin, cos). `None` if the budget of multiplications is used up.
    fn sum_of_angles(
        &mut self,
        a: &(RingPolynomial, RingPolynomial),
        b: &(RingPolynomial, RingPolynomial),
    ) -> Option<(RingPolynomial, RingPolynomial)> {
        let ring = &mut self.ring;
        let (sc, cs, cc, ss) =
            (ring.mul(&a.0, &b.1)?, ring.mul(&a.1, &b.0)?, ring.mul(&a.1, &b.1)?, ring.mul(&a.0, &b.0)?);
        let sine = ring.sum([(&sc, Rational::ONE), (&cs, Rational::ONE)].into_iter())?;
        let cosine = ring.sum([(&cc, Rational::ONE), (&ss, Rational::MINUS_ONE)].into_iter())?;
        Some((sine, cosine))
    }

    /// Converts a normal form to a term of the arena. The numerator and each factor of the
    /// denominator are expanded.
    pub fn expression(&self, arena: &mut Arena, form: &Fraction) -> Expr {
        let above = self.polynomial(&form.numerator).expand(arena);
        let mut factors = vec![(above, 1)];
        for (factor, n) in &form.denominator {
            let factor = self.polynomial(factor).expand(arena);
            factors.push((factor, -i32::try_from(*n).unwrap_or(i32::MAX)));
        }
        arena.try_product(&factors).expect("factors below are not zero")
    }

    /// Converts a polynomial of the ring to a polynomial with terms of the arena as atoms.
    #[must_use]
    pub fn polynomial(&self, p: &RingPolynomial) -> LaurentPolynomial {
        let mut result = LaurentPolynomial::default();
        for (powers, k) in &p.terms {
            let mut monomial: Monomial = (0..self.ring.size())
                .filter(|at| powers.exponent_of(*at) > 0)
                .map(|at| (self.ring.expression(at), i32::from(powers.exponent_of(at))))
                .collect();
            monomial.sort_unstable_by_key(|(e, _)| *e);
            result.add_term(monomial, k);
        }
        result
    }
}

/// Exact sine and cosine of π/12: √2 (√3 ∓ 1)/4.
fn twelfth_of_pi(arena: &mut Arena) -> (Expr, Expr) {
    let [two, three] = [2, 3].map(|n| arena.integer(n)).map(|n| arena.apply(Function::Sqrt, n));
    let quarter = arena.ratio(1, 4);
    let (less, more) = (arena.sub(three, Expr::ONE), arena.add(three, Expr::ONE));
    [less, more].map(|factor| arena.product(&[two, factor, quarter])).into()
}
