//! Exact values and symmetries of the elementary functions.
//! Every rule is valid wherever the function is defined. Rules that are valid only for a part of
//! the arguments are not used.

use super::calculus::Substitution;
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use num_rational::BigRational;

/// True if the function is computed from eˣ: exp, sinh, cosh or tanh.
pub(in crate::algebra) fn is_exponential(function: Function) -> bool {
    matches!(function, Function::Exp | Function::Sinh | Function::Cosh | Function::Tanh)
}

/// True if the term `e` is a sine or a cosine.
pub(in crate::algebra) fn is_sine_or_cosine(arena: &Arena, e: Expr) -> bool {
    matches!(arena.node(e), Node::Apply(Function::Sin | Function::Cos, _))
}

/// Function value f(argument) in canonical form: known values and symmetries are resolved.
pub(super) fn canonical_function_value(arena: &mut Arena, f: Function, argument: Expr) -> Expr {
    match f {
        Function::Sin | Function::Cos => canonical_sine_or_cosine(arena, f, argument),
        Function::Sqrt => square_root(arena, argument),
        // Odd functions have f(−x) = −f(x), even functions f(−x) = f(x). The values at 0 are known.
        Function::Asin | Function::Atan | Function::Sinh | Function::Tanh | Function::Sign => {
            if argument == Expr::ZERO {
                return Expr::ZERO;
            }
            if f == Function::Sign
                && let Some(value) = arena.as_number(argument)
            {
                return if value.is_negative() { Expr::MINUS_ONE } else { Expr::ONE };
            }
            let (positive, flipped) = positive_argument(arena, argument);
            let value = arena.intern_apply(f, positive);
            if flipped { arena.neg(value) } else { value }
        }
        Function::Cosh | Function::Abs => {
            if let (Function::Abs, Some(value)) = (f, arena.as_number(argument)) {
                let value = if value.is_negative() { value.neg() } else { value.clone() };
                return arena.number(value);
            }
            let (positive, _) = positive_argument(arena, argument);
            if f == Function::Cosh && positive == Expr::ZERO {
                return Expr::ONE;
            }
            arena.intern_apply(f, positive)
        }
        Function::Exp if argument == Expr::ZERO => Expr::ONE,
        Function::Log | Function::Acos if argument == Expr::ONE => Expr::ZERO,
        _ => arena.intern_apply(f, argument),
    }
}

/// Returns `e` or −`e`, whichever has a positive first coefficient, and true if the sign was
/// changed.
fn positive_argument(arena: &mut Arena, e: Expr) -> (Expr, bool) {
    let negative = match arena.node(e) {
        Node::Number(value) => value.is_negative(),
        Node::Sum(_, terms) => terms[0].1.is_negative(),
        _ => false,
    };
    if negative { (arena.neg(e), true) } else { (e, false) }
}

/// Splits an angle into a rational multiple of π and a rest: angle = multiple · π + rest. Returns
/// (multiple, rest).
pub fn split_multiple_of_pi(arena: &mut Arena, argument: Expr) -> (Rational, Expr) {
    let pi = arena.pi();
    if argument == pi {
        return (Rational::ONE, Expr::ZERO);
    }
    let turns = match arena.node(argument) {
        Node::Sum(_, terms) => terms.iter().find(|(term, _)| *term == pi).map(|(_, k)| k.clone()),
        _ => None,
    };
    match turns {
        Some(turns) => {
            let rest = arena.linear_combination(&[(argument, Rational::ONE), (pi, turns.neg())]);
            (turns, rest)
        }
        None => (Rational::ZERO, argument),
    }
}

/// Number of half turns (multiples of π) above which whole turns are subtracted from an angle. A
/// double would lose the fraction of a turn in a larger number.
const MANY_TURNS: f64 = 1e6;

/// Subtracts whole turns from an angle, which is given as a multiple of π. The result is a multiple
/// of π from 0 to 2.
fn without_whole_turns(turns: &Rational) -> Rational {
    let halves = turns.to_big() / BigRational::from_integer(2.into());
    turns.add(&Rational::from_big(halves.floor()).mul(&Rational::integer(-2)))
}

/// Largest number of inverse trigonometric functions in an angle whose sine or cosine is rewritten
/// without these functions.
const MOST_INVERSE: usize = 2;
/// Largest whole multiple of an inverse trigonometric function, in an angle whose sine or cosine is
/// rewritten without that function.
const MOST_MULTIPLE: i64 = 4;

/// Rewrites the sine or cosine of an angle that contains a whole multiple of an asin, acos or atan.
/// For example, sin(atan x) = x/√(1 + x²): the result is algebraic in x. `None` if the angle
/// contains no such function, too many such functions, or too large a multiple.
fn wave_of_inverse(arena: &mut Arena, f: Function, argument: Expr) -> Option<Expr> {
    let is_inverse =
        |e: Expr| matches!(arena.node(e), Node::Apply(Function::Asin | Function::Acos | Function::Atan, _));
    let atoms = match arena.node(argument) {
        Node::Apply(..) => vec![(argument, Rational::ONE)],
        Node::Sum(_, terms) => terms.to_vec(),
        _ => return None,
    };
    let mut inverse = atoms.into_iter().filter(|(atom, _)| is_inverse(*atom)).collect::<Vec<_>>();
    let (atom, k) = inverse.pop().filter(|_| inverse.len() < MOST_INVERSE)?;
    let times = k.to_i64().filter(|times| times.abs() <= MOST_MULTIPLE)?;
    let Node::Apply(inverse, x) = *arena.node(atom) else { return None };
    let own = sine_and_cosine(arena, inverse, x);
    let rest = arena.linear_combination(&[(argument, Rational::ONE), (atom, k.neg())]);
    let mut angle = (arena.sin(rest), arena.cos(rest));
    for _ in 0..times.abs() {
        let sine = if times < 0 { arena.neg(own.0) } else { own.0 };
        let products = [(angle.0, own.1), (angle.1, sine), (angle.1, own.1), (angle.0, sine)];
        let [sc, cs, cc, ss] = products.map(|(a, b)| arena.mul(a, b));
        angle = (arena.add(sc, cs), arena.sub(cc, ss));
    }
    Some(if f == Function::Sin { angle.0 } else { angle.1 })
}

/// Pair (sine, cosine) of the angle asin x, acos x or atan x, algebraic in x.
fn sine_and_cosine(arena: &mut Arena, inverse: Function, x: Expr) -> (Expr, Expr) {
    let square = arena.square(x);
    if inverse == Function::Atan {
        let sum = arena.add(Expr::ONE, square);
        let root = arena.apply(Function::Sqrt, sum);
        let cosine = arena.div(Expr::ONE, root).expect("1 + x² is not the number 0");
        return (arena.mul(x, cosine), cosine);
    }
    let left = arena.sub(Expr::ONE, square);
    let root = arena.apply(Function::Sqrt, left);
    if inverse == Function::Asin { (x, root) } else { (root, x) }
}

/// Sine or cosine in canonical form: quarter turns, special angles and signs are resolved.
fn canonical_sine_or_cosine(arena: &mut Arena, f: Function, argument: Expr) -> Expr {
    if let Some(value) = wave_of_inverse(arena, f, argument) {
        return value;
    }
    let (mut turns, rest) = split_multiple_of_pi(arena, argument);
    let mut argument = argument;
    if turns.to_f64().abs() > MANY_TURNS {
        turns = without_whole_turns(&turns);
        let pi = arena.pi();
        argument = arena.linear_combination(&[(rest, Rational::ONE), (pi, turns.clone())]);
    }
    // sin(x + k π/2) is sin x, cos x, −sin x, −cos x for k = 0, 1, 2, 3.
    let quarters = turns.mul(&Rational::integer(2));
    let Some(k) = quarters.to_i64() else {
        if rest == Expr::ZERO
            && let Some(value) = special_angle(arena, f, &turns)
        {
            return value;
        }
        let (positive, flipped) = positive_argument(arena, argument);
        let value = arena.intern_apply(f, positive);
        return if flipped && f == Function::Sin { arena.neg(value) } else { value };
    };
    let k = (k.rem_euclid(4) + i64::from(f == Function::Cos)) % 4;
    let (positive, flipped) = positive_argument(arena, rest);
    let value = match (k % 2, positive == Expr::ZERO) {
        (0, true) => Expr::ZERO,
        (_, true) => Expr::ONE,
        (0, false) => arena.intern_apply(Function::Sin, positive),
        (_, false) => arena.intern_apply(Function::Cos, positive),
    };
    let negative = (k >= 2) ^ (flipped && k % 2 == 0);
    if negative { arena.neg(value) } else { value }
}

/// Exact sine or cosine of the angle turns·π, if that is a multiple of π/6 or π/4; `None`
/// otherwise.
fn special_angle(arena: &mut Arena, f: Function, turns: &Rational) -> Option<Expr> {
    let twelfths = turns.mul(&Rational::integer(12)).to_i64()?;
    let shift = if f == Function::Cos { 6 } else { 0 };
    let k = (twelfths.rem_euclid(24) + shift) % 24;
    let (quadrant_sign, k) = if k >= 12 { (-1, k - 12) } else { (1, k) };
    // sin is symmetric about π/2.
    let squared = match k.min(12 - k) {
        2 => return Some(arena.ratio(quadrant_sign, 2)),
        3 => 2,
        4 => 3,
        _ => return None,
    };
    let radicand = arena.integer(squared);
    let root = arena.apply(Function::Sqrt, radicand);
    Some(arena.scale(root, &Rational::fraction(quadrant_sign, 2)?))
}

/// Square root in canonical form: squares of numbers and of positive symbols are taken out of the
/// root.
fn square_root(arena: &mut Arena, argument: Expr) -> Expr {
    if let Some(value) = arena.as_number(argument)
        && let Some(root) = exact_root(value)
    {
        return arena.number(root);
    }
    // Squares of positive symbols come out: √(M² x) = M √x.
    let (content, factors) = match arena.node(argument) {
        Node::Product(factors) => (Rational::ONE, factors.to_vec()),
        Node::Sum(constant, terms) if constant.is_zero() && terms.len() == 1 => match arena.node(terms[0].0) {
            Node::Product(factors) => (terms[0].1.clone(), factors.to_vec()),
            _ => (terms[0].1.clone(), vec![(terms[0].0, 1)]),
        },
        _ => return arena.intern_apply(Function::Sqrt, argument),
    };
    let halved = |(base, n): &(Expr, i32)| (*base, if arena.is_positive(*base) { n.div_euclid(2) } else { 0 });
    let mut outside: Vec<(Expr, i32)> = factors.iter().map(halved).filter(|(_, n)| *n != 0).collect();
    let mut inside: Vec<(Expr, i32)> = outside.iter().map(|(base, n)| (*base, -2 * n)).collect();
    if let Some(root) = exact_root(&content) {
        let root = arena.number(root);
        outside.push((root, 1));
        inside.push((root, -2));
    }
    inside.push((argument, 1));
    let inside = arena.try_product(&inside).expect("positive symbols and numbers are not zero");
    if arena.as_number(inside).is_some_and(Rational::is_negative) {
        // √(−M²) has no value, so it stays as written. As M √(−1), a saved model could not be read
        // again.
        return arena.intern_apply(Function::Sqrt, argument);
    }
    let root = if inside == Expr::ONE { Expr::ONE } else { arena.intern_apply(Function::Sqrt, inside) };
    outside.push((root, 1));
    arena.try_product(&outside).expect("positive symbols and numbers are not zero")
}

/// Exact square root of a rational number; `None` if the root is not rational or the number is
/// negative.
fn exact_root(value: &Rational) -> Option<Rational> {
    if value.is_negative() {
        return None;
    }
    let big = value.to_big();
    let root = num_rational::BigRational::new(big.numer().sqrt(), big.denom().sqrt());
    (&root * &root == big).then(|| Rational::from_big(root))
}

/// Splits an angle into the sum Σ k·atom and returns the pairs (atom, k). Atoms are neither numbers
/// nor sums; a constant counts as a multiple of the atom 1.
pub fn angle_atoms(arena: &Arena, argument: Expr) -> Vec<(Expr, Rational)> {
    match arena.node(argument) {
        Node::Sum(constant, terms) => {
            let mut atoms = terms.to_vec();
            if !constant.is_zero() {
                atoms.push((Expr::ONE, constant.clone()));
            }
            atoms
        }
        Node::Number(value) => vec![(Expr::ONE, value.clone())],
        _ => vec![(argument, Rational::ONE)],
    }
}

/// True for a number, π, a symbol, or a product of powers of symbols such as r/R. Different ones are independent as
/// parts of angles.
pub(in crate::algebra) fn is_plain_angle_atom(arena: &Arena, atom: Expr) -> bool {
    match arena.node(atom) {
        Node::Symbol(_) | Node::Number(_) | Node::Pi => true,
        Node::Product(factors) => factors.iter().all(|(base, _)| arena.symbol_name(*base).is_some()),
        _ => false,
    }
}

/// Writes a sum that is divided by a product of symbols as a sum of quotients, such as θ − r/R for (R θ − r)/R. Other
/// terms are returned unchanged.
pub(in crate::algebra) fn divided_term_by_term(arena: &mut Arena, e: Expr) -> Expr {
    let (quotient, scale) = match arena.node(e) {
        Node::Sum(constant, terms) if constant.is_zero() && terms.len() == 1 => terms[0].clone(),
        _ => (e, Rational::ONE),
    };
    let Node::Product(factors) = arena.node(quotient).clone() else { return e };
    let (sums, symbols): (Vec<_>, Vec<_>) = factors.iter().partition(|(base, _)| arena.symbol_name(*base).is_none());
    let [(sum, 1)] = sums.as_slice() else { return e };
    let Node::Sum(constant, terms) = arena.node(*sum).clone() else { return e };
    let constant = arena.number(constant);
    let mut quotients = Vec::new();
    for (term, k) in std::iter::once((constant, Rational::ONE)).chain(terms.iter().cloned()) {
        let product: Vec<_> = symbols.iter().map(|(base, n)| (*base, *n)).chain([(term, 1)]).collect();
        let Ok(quotient) = arena.try_product(&product) else { return e };
        quotients.push((quotient, k.mul(&scale)));
    }
    arena.linear_combination(&quotients)
}

/// Largest whole multiple n of an angle for which sin nq and cos nq are expanded into sin q and cos
/// q.
const MOST_TURNS: u64 = 16;

/// Expands sines and cosines in a term by the addition theorems. Sines and cosines of sums and
/// whole multiples of angles are replaced by those of single angles.
pub fn expand_multiple_angles(arena: &mut Arena, e: Expr) -> Expr {
    let mut put = Substitution::default();
    for part in arena.reachable(&[e]) {
        let Node::Apply(f @ (Function::Sin | Function::Cos), argument) = *arena.node(part) else { continue };
        let inner = put.apply(arena, argument);
        let (mut sine, mut cosine) = (Expr::ZERO, Expr::ONE);
        for (atom, k) in angle_atoms(arena, inner) {
            let whole = k.to_i64().filter(|n| n.unsigned_abs() <= MOST_TURNS);
            let (angle, times) = match whole {
                Some(n) => (atom, n),
                None => (arena.scale(atom, &k), 1),
            };
            let (mut s, c) = (arena.sin(angle), arena.cos(angle));
            if times < 0 {
                s = arena.neg(s);
            }
            for _ in 0..times.unsigned_abs() {
                (sine, cosine) = sine_and_cosine_of_sum(arena, (sine, cosine), (s, c));
            }
        }
        put.set(part, if f == Function::Sin { sine } else { cosine });
    }
    put.apply(arena, e)
}

/// Sine and cosine of the sum of two angles, as a pair (sin, cos). Each angle is given as such a
/// pair.
fn sine_and_cosine_of_sum(arena: &mut Arena, a: (Expr, Expr), b: (Expr, Expr)) -> (Expr, Expr) {
    let (sc, cs, cc, ss) = (arena.mul(a.0, b.1), arena.mul(a.1, b.0), arena.mul(a.1, b.1), arena.mul(a.0, b.0));
    (arena.add(sc, cs), arena.sub(cc, ss))
}
