//! Primitives (antiderivatives): functions with given partial derivatives, found by rules of
//! integration.
//!
//! Each rule is sound by itself. The result is still differentiated and compared with the given
//! derivatives by zero tests. A field with curl has no primitive, whatever the rules give. Absent
//! on purpose: a procedure that decides if a primitive is elementary. If no rule applies, the
//! result is `None`.

use crate::algebra::form::simplify::{Simplifier, operation_count};
use crate::algebra::term::calculus::Differential;
use crate::algebra::value::zero_test::{ZeroTest, count_roots_for_zero_test, zero_test};
use crate::algebra::{Arena, Expr, Function, Node, Rational};

/// Largest depth of nesting of the integration rules that lead to other integrations.
const DEEPEST: usize = 8;
/// Largest number of operations for one primitive, summed over all terms that are examined. The
/// limit is needed because rules lead to other rules, and derivatives of long products are much
/// longer.
const MOST_WORK: usize = 200_000;

/// Finds a function F with the partial derivatives ∂F/∂xᵢ = `slopes`ᵢ, up to a constant. `None` if
/// the rules find no such function.
///
/// The rules for one variable x follow; r does not depend on x.
/// Powers: r, r bⁿ b′ and r √bⁿ b′, including logarithms of |b| as ½ log b². Functions: r f(b) b′
/// for each function f with an elementary primitive.
/// Waves: squares and products of sines and cosines of terms linear in x. Products: xⁿ g by parts,
/// and products with sums, term by term.
pub fn antiderivative(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    variables: &[Expr],
    slopes: &[Expr],
) -> Option<Expr> {
    let mut rest = slopes.to_vec();
    let (mut parts, mut left) = (Vec::new(), MOST_WORK);
    for (at, x) in variables.iter().enumerate() {
        let mut integration = Integration { arena, simplifier, x: *x, left: &mut left };
        let slope = integration.short(rest[at])?;
        if slope == Expr::ZERO {
            continue;
        }
        let part = integration.integrate(slope, 0)?;
        for (rest, y) in rest.iter_mut().zip(variables) {
            let taken = Differential::partial(*y).apply(arena, part);
            *rest = arena.sub(*rest, taken);
        }
        parts.push(part);
    }
    let none_left = rest.iter().all(|e| zero_test(arena, *e) == ZeroTest::Zero);
    none_left.then(|| {
        let sum = arena.sum(&parts);
        simplifier.simplify(arena, sum)
    })
}

/// Exponents n of a square root (√b)ⁿ that are tried in the integration of r (√b)ⁿ b′. They occur
/// in laws of springs, and in forces that decrease with the distance or its square.
const ROOTS: [i32; 3] = [-1, 1, -3];

/// Number of points of a zero test that are not counted as work.
const FREE_POINTS: usize = 32;

/// Estimated number of multiplications of terms for expanding the powers of sums in a product; 0
/// for other terms.
fn integrand_expansion_work(arena: &Arena, e: Expr) -> usize {
    let Node::Product(factors) = arena.node(e) else { return 0 };
    let of_power = |(base, n): &(Expr, i32)| match arena.node(*base) {
        Node::Sum(_, terms) if *n > 1 => usize::try_from(*n).map_or(usize::MAX, |n| n.saturating_mul(n) * terms.len()),
        _ => 0,
    };
    factors.iter().map(of_power).fold(0, usize::saturating_add)
}

/// Integration of terms along one variable, with a limit of work.
struct Integration<'a> {
    /// Arena of the terms.
    arena: &'a mut Arena,
    /// Simplifier of intermediate results.
    simplifier: &'a mut Simplifier,
    /// Variable of integration.
    x: Expr,
    /// Number of operations that the integration may still examine.
    left: &'a mut usize,
}

impl Integration<'_> {
    /// Primitive of a term with respect to x. `depth` is the number of integrations that led to
    /// this one. `None` if no rule applies, `depth` exceeds its limit or no work is left.
    fn integrate(&mut self, e: Expr, depth: usize) -> Option<Expr> {
        *self.left = self.left.checked_sub(1)?;
        if depth > DEEPEST {
            return None;
        }
        if !self.depends(e) {
            return Some(self.arena.mul(e, self.x));
        }
        if let Node::Sum(constant, terms) = self.arena.node(e).clone() {
            return self.sum(&constant, &terms, depth);
        }
        self.integrate_inner(e)
            .or_else(|| self.integrate_waves(e, depth))
            .or_else(|| self.integrate_by_terms(e, depth))
            .or_else(|| self.integrate_by_parts(e, depth))
    }

    /// True if the term contains the variable x.
    fn depends(&self, e: Expr) -> bool {
        self.arena.mentions(e, self.x)
    }

    /// Short form of a term; `None` if the simplification may need more operations than are
    /// allowed.
    fn short(&mut self, e: Expr) -> Option<Expr> {
        let parts = self.arena.reachable(&[e]);
        let powers: usize =
            parts.iter().map(|part| integrand_expansion_work(self.arena, *part)).fold(0, usize::saturating_add);
        *self.left = self.left.checked_sub(operation_count(self.arena, e).saturating_add(powers))?;
        Some(self.simplifier.simplify(self.arena, e))
    }

    /// Derivative of a term with respect to x, in short form; `None` if the work is used up.
    fn slope(&mut self, e: Expr) -> Option<Expr> {
        let slope = Differential::partial(self.x).apply(self.arena, e);
        self.short(slope)
    }

    /// True if the term is proved not to change with x, even if it contains x. False also if the
    /// test takes more work than is left.
    fn is_constant(&mut self, e: Expr) -> bool {
        if !self.depends(e) {
            return true;
        }
        self.slope(e).and_then(|slope| self.is_zero(slope)).unwrap_or(false)
    }

    /// True if the term is identically zero; `None` if the zero test takes more work than is left.
    /// The cost doubles with each square root, since at half of all random points a root has no
    /// value.
    fn is_zero(&mut self, e: Expr) -> Option<bool> {
        let parts = self.arena.reachable(&[e]);
        let points = 1_usize.checked_shl(count_roots_for_zero_test(self.arena, &parts))? / FREE_POINTS;
        *self.left = self.left.checked_sub(parts.len().saturating_mul(points))?;
        Some(zero_test(self.arena, e) == ZeroTest::Zero)
    }

    /// Quotient a/b in short form if it does not change with x; `None` otherwise.
    fn constant_quotient(&mut self, a: Expr, b: Expr) -> Option<Expr> {
        let quotient = self.arena.div(a, b)?;
        let quotient = self.short(quotient)?;
        self.is_constant(quotient).then_some(quotient)
    }

    /// Primitive of the sum constant + Σ k · term, integrated term by term. `None` if a term has no
    /// primitive by the rules.
    fn sum(&mut self, constant: &Rational, terms: &[(Expr, Rational)], depth: usize) -> Option<Expr> {
        let mut parts = vec![(self.x, constant.clone())];
        for (term, k) in terms {
            parts.push((self.integrate(*term, depth)?, k.clone()));
        }
        Some(self.arena.linear_combination(&parts))
    }

    /// Factors of a product, as pairs (base, exponent). A term that is not a product gives the pair
    /// (term, 1).
    fn factors(&self, e: Expr) -> Vec<(Expr, i32)> {
        match self.arena.node(e) {
            Node::Product(factors) => factors.to_vec(),
            _ => vec![(e, 1)],
        }
    }

    /// Primitive of a term of the form r bⁿ b′, r (√b)ⁿ b′ or r f(b) b′, where r does not change
    /// with x. `None` for other terms.
    fn integrate_inner(&mut self, e: Expr) -> Option<Expr> {
        let factors = self.factors(e);
        for (base, n) in &factors {
            if !self.depends(*base) {
                continue;
            }
            let under_root = match *self.arena.node(*base) {
                Node::Apply(Function::Sqrt, argument) => Some(argument),
                _ => None,
            };
            let found = match under_root {
                // The radicand may be a factor beside its own root: they are one power, counted in
                // halves. The radicand may also be written in another form, or with a number taken
                // out.
                Some(argument) => {
                    let beside = factors.iter().find(|(other, _)| *other == argument).map_or(0, |(_, n)| *n);
                    let own = n + 2 * beside;
                    let others = ROOTS.into_iter().filter(|n| *n != own);
                    std::iter::once(own).chain(others).find_map(|n| self.integrate_power(e, *base, argument, n, 2))
                }
                None => self.integrate_power(e, *base, *base, *n, 1).or_else(|| self.integrate_function(e, *base, *n)),
            };
            if found.is_some() {
                return found;
            }
        }
        None
    }

    /// True if the derivative `slope` may be zero over a whole range of x. This is possible if it
    /// contains a sum with the sign of a term that depends on x. A quotient by such a derivative
    /// has no value in that range, although both sides of the rule have one.
    fn has_plateau(&self, slope: Expr) -> bool {
        let is_jump = |e: Expr| match *self.arena.node(e) {
            Node::Apply(Function::Sign, argument) => self.depends(argument),
            _ => false,
        };
        let is_sum = |e: &Expr| matches!(self.arena.node(*e), Node::Sum(..));
        let sums: Vec<Expr> = self.arena.reachable(&[slope]).into_iter().filter(is_sum).collect();
        self.arena.reachable(&sums).into_iter().any(is_jump)
    }

    /// Primitive of r wⁿ b′ with b = wᵈ: r d wⁿ⁺ᵈ/(n + d), or r log |b| if n + d = 0. `None` if the
    /// term `e` does not have this form.
    fn integrate_power(&mut self, e: Expr, w: Expr, b: Expr, n: i32, d: i32) -> Option<Expr> {
        let slope = self.slope(b)?;
        if slope == Expr::ZERO || self.has_plateau(slope) {
            return None;
        }
        let power = self.arena.pow(w, n).ok()?;
        let divisor = self.arena.mul(power, slope);
        let r = self.constant_quotient(e, divisor)?;
        let raised = n.checked_add(d)?;
        if raised == 0 {
            let square = self.arena.pow(b, 2).ok()?;
            let log = self.arena.apply(Function::Log, square);
            let half = self.arena.scale(log, &Rational::fraction(1, 2)?);
            return Some(self.arena.mul(r, half));
        }
        let power = self.arena.pow(w, raised).ok()?;
        let product = self.arena.mul(r, power);
        Some(self.arena.scale(product, &Rational::fraction(i64::from(d), i64::from(raised))?))
    }

    /// Primitive of the term e = r f(b) b′, where `call` is f(b) and n its exponent. `None` unless
    /// n is 1 and r does not change with x.
    fn integrate_function(&mut self, e: Expr, call: Expr, n: i32) -> Option<Expr> {
        let Node::Apply(f, b) = *self.arena.node(call) else { return None };
        let slope = self.slope(b)?;
        if n != 1 || slope == Expr::ZERO {
            return None;
        }
        let divisor = self.arena.mul(call, slope);
        let r = self.constant_quotient(e, divisor)?;
        let whole = self.of_function(f, b, call)?;
        Some(self.arena.mul(r, whole))
    }

    /// Primitive ∫ f(b) db of an elementary function, where `call` is f(b); `None` if no formula is
    /// known.
    fn of_function(&mut self, f: Function, b: Expr, call: Expr) -> Option<Expr> {
        let arena = &mut *self.arena;
        let half = Rational::fraction(1, 2)?;
        Some(match f {
            Function::Sin => {
                let cos = arena.apply(Function::Cos, b);
                arena.neg(cos)
            }
            Function::Cos => arena.apply(Function::Sin, b),
            Function::Exp => call,
            Function::Sinh => arena.apply(Function::Cosh, b),
            Function::Cosh => arena.apply(Function::Sinh, b),
            // log cosh b, in tanh b alone: −½ log(1 − tanh² b)
            Function::Tanh => {
                let square = arena.pow(call, 2).ok()?;
                let rest = arena.sub(Expr::ONE, square);
                let log = arena.apply(Function::Log, rest);
                arena.scale(log, &half.neg())
            }
            // b log b − b
            Function::Log => {
                let product = arena.mul(b, call);
                arena.sub(product, b)
            }
            // b |b|/2
            Function::Abs => {
                let product = arena.mul(b, call);
                arena.scale(product, &half)
            }
            // b atan b − ½ log(1 + b²)
            Function::Atan => {
                let (product, square) = (arena.mul(b, call), arena.pow(b, 2).ok()?);
                let sum = arena.add(square, Expr::ONE);
                let log = arena.apply(Function::Log, sum);
                let log = arena.scale(log, &half);
                arena.sub(product, log)
            }
            _ => return None,
        })
    }

    /// Primitive of a product with two sines or cosines of terms linear in x, or with the square of
    /// one. The product becomes a sum of sines or cosines. `None` if the term does not have this
    /// form.
    fn integrate_waves(&mut self, e: Expr, depth: usize) -> Option<Expr> {
        let mut list = Vec::new();
        for (base, n) in self.factors(e) {
            if let Node::Apply(f @ (Function::Sin | Function::Cos), angle) = *self.arena.node(base)
                && self.depends(base)
                && (1..=4).contains(&n)
            {
                let slope = self.slope(angle)?;
                if !self.is_constant(slope) {
                    return None;
                }
                list.extend((0..n).map(|_| (f, angle, base)));
            }
        }
        let [(f, a, first), (g, b, second), ..] = list[..] else { return None };
        let both = self.arena.mul(first, second);
        let rest = self.arena.div(e, both)?;
        let (plus, minus) = (self.arena.add(a, b), self.arena.sub(a, b));
        // 2 sin a sin b = cos(a − b) − cos(a + b), and so on.
        let (wave, signs) = match (f, g) {
            (Function::Sin, Function::Sin) => (Function::Cos, [Rational::MINUS_ONE, Rational::ONE]),
            (Function::Cos, Function::Cos) => (Function::Cos, [Rational::ONE, Rational::ONE]),
            (Function::Sin, _) => (Function::Sin, [Rational::ONE, Rational::ONE]),
            _ => (Function::Sin, [Rational::ONE, Rational::MINUS_ONE]),
        };
        let mut parts = Vec::new();
        for (angle, sign) in [plus, minus].into_iter().zip(signs) {
            let angle = self.short(angle)?;
            let wave = self.arena.apply(wave, angle);
            let product = self.arena.mul(rest, wave);
            let half = sign.mul(&Rational::fraction(1, 2)?);
            parts.push((self.integrate(product, depth + 1)?, half));
        }
        Some(self.arena.linear_combination(&parts))
    }

    /// Primitive of a product that contains a sum, by multiplying out one sum. The sums are tried
    /// in turn, because the derivative of a radicand must not be multiplied out. `None` if no sum
    /// gives a primitive.
    fn integrate_by_terms(&mut self, e: Expr, depth: usize) -> Option<Expr> {
        let factors = self.factors(e);
        let sums = factors.iter().filter(|(base, n)| *n > 0 && self.depends(*base)).map(|(base, _)| *base);
        let sums: Vec<Expr> = sums.filter(|base| matches!(self.arena.node(*base), Node::Sum(..))).collect();
        sums.into_iter().find_map(|sum| self.by_terms_of(e, sum, depth))
    }

    /// Primitive of a product by multiplying out the given sum, one of its factors. `None` if a
    /// resulting product has no primitive by the rules.
    fn by_terms_of(&mut self, e: Expr, sum: Expr, depth: usize) -> Option<Expr> {
        let Node::Sum(constant, terms) = self.arena.node(sum).clone() else { return None };
        let rest = self.arena.div(e, sum)?;
        let mut parts = Vec::new();
        if !constant.is_zero() {
            parts.push((self.integrate(rest, depth + 1)?, constant));
        }
        for (term, k) in &terms {
            let product = self.arena.mul(rest, *term);
            parts.push((self.integrate(product, depth + 1)?, k.clone()));
        }
        Some(self.arena.linear_combination(&parts))
    }

    /// Primitive of a product xⁿ g by parts: ∫ xⁿ g = xⁿ G − ∫ n xⁿ⁻¹ G, where G is a primitive of
    /// g. `None` if x is not a factor of the term, or if a part has no primitive by the rules.
    fn integrate_by_parts(&mut self, e: Expr, depth: usize) -> Option<Expr> {
        let (_, n) = *self.factors(e).iter().find(|(base, n)| *base == self.x && *n > 0)?;
        let power = self.arena.pow(self.x, n).ok()?;
        let g = self.arena.div(e, power)?;
        let whole = self.integrate(g, depth + 1)?;
        let slope = self.slope(power)?;
        let product = self.arena.mul(slope, whole);
        let product = self.short(product)?;
        let rest = self.integrate(product, depth + 1)?;
        let first = self.arena.mul(power, whole);
        Some(self.arena.sub(first, rest))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::parse::parse_free;
    use crate::algebra::text::print::print_text;
    use crate::algebra::value::tape::Tape;

    /// Primitive, as text, of a field with the given slopes along x, y and z; a and b are
    /// constants. `None` if the rules find no primitive.
    fn found(slopes: &[&str]) -> Option<String> {
        let mut arena = Arena::default();
        let variables = ["x", "y", "z"].map(|name| arena.symbol(name));
        for name in ["a", "b"] {
            arena.symbol(name);
        }
        let slopes: Vec<Expr> = slopes.iter().map(|s| parse_free(&mut arena, s).unwrap()).collect();
        let f = antiderivative(&mut arena, &mut Simplifier::default(), &variables[..slopes.len()], &slopes)?;
        for (x, slope) in variables.iter().zip(&slopes) {
            let own = Differential::partial(*x).apply(&mut arena, f);
            let rest = arena.sub(own, *slope);
            assert_eq!(zero_test(&arena, rest), ZeroTest::Zero, "{}", print_text(&arena, f));
        }
        Some(print_text(&arena, f))
    }

    #[test]
    fn laws_of_forces_have_their_potentials() {
        for slopes in [
            &["-a*x"][..],
            &["a*sin(x)"],
            &["a*sin(b*x)*cos(b*x)"],
            &["a/x^2"],
            &["a/(x - b)"],
            &["a*(x - b)^3 + sqrt(x)"],
            &["exp(-x^2)*x"],
            &["a*exp(b*x)*x^2"],
            &["sin(x)^2*cos(x)"],
            &["sin(x)^2"],
            &["sin(x)*sin(3*x) + x*cos(x)"],
            &["tanh(a*x)"],
            &["atan(x)"],
            &["x*(a + sin(x))*(x - b)"],
            // The force of a spring of length b, and the weight of a point.
            &["a*(1 - b/sqrt(x^2 + y^2))*x", "a*(1 - b/sqrt(x^2 + y^2))*y"],
            &["a*x/sqrt(x^2 + y^2 + z^2)^3", "a*y/sqrt(x^2 + y^2 + z^2)^3", "a*z/sqrt(x^2 + y^2 + z^2)^3"],
            &["cos(x)*sin(y)", "sin(x)*cos(y)"],
            &["y*exp(x*y)", "x*exp(x*y)"],
            // A spring whose two ends have the same distance from the pivot between them.
            &["sin(x)*(a*(1 + cos(x)) - b*sqrt(2 + 2*cos(x)))/(1 + cos(x))"],
        ] {
            assert!(found(slopes).is_some(), "{slopes:?}");
        }
    }

    /// Two stops with a gap between them have a potential. Each law of force is 0 in the gap, so
    /// the potential must not divide by the slope of the force there.
    #[test]
    fn a_gap_between_stops_has_a_potential() {
        for slope in ["-a*max(x - b, 0) - a*min(x + b, 0)", "-a*max(x - b, 0)", "max(x - b, 0)^2 - min(x + b, 0)^2"] {
            let text = found(&[slope]).unwrap_or_else(|| panic!("{slope}"));
            let (mut arena, x) = (Arena::default(), 0.25);
            let f = parse_free(&mut arena, &text).unwrap();
            let inputs = ["x", "a", "b"].map(|name| arena.symbol(name));
            let tape = Tape::new(&arena, &inputs, &[f]).unwrap();
            let values = [tape.evaluate(&[x, 2.0, 1.0])[0], tape.evaluate(&[-x, 2.0, 1.0])[0]];
            assert!(
                values.iter().all(|value| value.is_finite() && (value - values[0]).abs() < 1e-15),
                "{slope}: {text}"
            );
        }
    }

    #[test]
    fn a_field_with_curl_has_none_and_what_is_not_elementary_is_not_found() {
        for slopes in [&["-y", "x"][..], &["y", "0"], &["exp(x^2)"], &["sin(x)/x"], &["x*y", "x^2"]] {
            assert_eq!(found(slopes), None, "{slopes:?}");
        }
    }
}
