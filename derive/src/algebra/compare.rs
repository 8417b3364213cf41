//! Equality of meaning: one question, three answers.
//!
//! ```
//! use tripos_derive::algebra::{Arena, parse::parse_free};
//! use tripos_derive::algebra::compare::{Comparer, Verdict};
//!
//! let mut arena = Arena::new();
//! let a = parse_free(&mut arena, "1 + tan(q)^2").unwrap();
//! let b = parse_free(&mut arena, "sec(q)^2").unwrap();
//! assert!(matches!(Comparer::default().compare(&mut arena, a, b), Verdict::Equal(_)));
//! ```
//!
//! Two engines stand behind it. [`super::modular`] evaluates exactly at random points of random prime
//! fields: one value other than zero proves that the sides differ. Where it sees zeros only,
//! [`super::normal`] proves equality; what is too large for it is equal with the error bound of the first. Floating
//! point decides nothing: it only finds a state that shows a difference which is proved already. (Where roots
//! occur, a formal difference counts only if such a state exists, since √x² is x for some x and not for others.)

use super::calculus::Substitution;
use super::elementary::angle_atoms;
use super::evaluate::Tape;
use super::field::Generator;
use super::modular::{ZeroTest, bounded_zero_test, has_roots};
use super::normal::{Normalizer, Zero};
use super::{Arena, Expr, Function, Node};
use std::fmt;

/// What proves an equality.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Engine {
    /// The difference has the normal form 0.
    NormalForm,
    /// The difference is 0 at random points of random prime fields; wrong with a probability below 2^−exponent.
    Modular {
        /// The exponent of the bound.
        exponent: f64,
    },
}

impl fmt::Display for Engine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NormalForm => f.write_str("normal form"),
            Self::Modular { exponent } => {
                write!(f, "modular, error below 2^-{}", exponent.floor().min(9999.0))
            }
        }
    }
}

/// A state where two sides have different values.
#[derive(Clone, Debug, PartialEq)]
pub struct Witness {
    /// The symbols that occur, with their values.
    pub at: Vec<(String, f64)>,
    /// The left side there.
    pub left: f64,
    /// The right side there.
    pub right: f64,
    /// Left − right, evaluated as one expression and so without cancellation.
    pub difference: f64,
}

/// The answer to "do these two mean the same?".
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// They do.
    Equal(Engine),
    /// They do not.
    Different(Witness),
    /// It is not known.
    Undecided(String),
}

impl Verdict {
    /// Whether the answer is yes.
    #[must_use]
    pub fn is_equal(&self) -> bool {
        matches!(self, Self::Equal(_))
    }
}

/// Compares terms of one arena and remembers their normal forms.
#[derive(Default)]
pub struct Comparer {
    normalizer: Normalizer,
}

impl Comparer {
    /// Whether two terms mean the same wherever both have values.
    pub fn compare(&mut self, arena: &mut Arena, left: Expr, right: Expr) -> Verdict {
        let difference = arena.sub(left, right);
        if difference == Expr::ZERO {
            return Verdict::Equal(Engine::NormalForm);
        }
        let difference = self.expand_angles(arena, difference);
        let (zero, exponent) = bounded_zero_test(arena, difference);
        if zero == ZeroTest::NonZero {
            return different(arena, left, right, difference);
        }
        self.normalizer.allow(Normalizer::BUDGET);
        match (self.normalizer.zero(arena, difference), zero) {
            (Zero::Yes, _) => Verdict::Equal(Engine::NormalForm),
            (Zero::No, _) => different(arena, left, right, difference),
            (_, ZeroTest::Zero) => Verdict::Equal(Engine::Modular { exponent }),
            _ => Verdict::Undecided(reason(arena, left, right, difference)),
        }
    }

    /// Whether a term is zero by meaning.
    pub fn is_zero(&mut self, arena: &mut Arena, e: Expr) -> Verdict {
        self.compare(arena, e, Expr::ZERO)
    }

    /// Angles such as (a + b)² written as sums of products, so that equal angles are equal terms.
    fn expand_angles(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        let mut pairs = Vec::new();
        for part in arena.reachable(&[e]) {
            let Node::Apply(f @ (Function::Sin | Function::Cos), argument) = *arena.node(part) else { continue };
            let is_plain = |atom: &Expr| matches!(arena.node(*atom), Node::Symbol(_) | Node::Number(_) | Node::Pi);
            if angle_atoms(arena, argument).iter().all(|(atom, _)| is_plain(atom)) {
                continue;
            }
            if let Some(form) = self.normalizer.fraction(arena, argument) {
                let expanded = self.normalizer.expression(arena, &form);
                pairs.push((part, arena.apply(f, expanded)));
            }
        }
        if pairs.is_empty() { e } else { Substitution::new(&pairs).apply(arena, e) }
    }
}

/// Why nothing was decided.
fn reason(arena: &Arena, left: Expr, right: Expr, difference: Expr) -> String {
    let parts = arena.reachable(&[difference]);
    let opaque = parts.iter().find_map(|p| match arena.node(*p) {
        Node::Apply(Function::Sin | Function::Cos | Function::Sqrt | Function::Abs | Function::Sign, _) => None,
        Node::Apply(f, _) => Some(f.name()),
        _ => None,
    });
    let why = match opaque {
        Some(name) => format!("`{name}` has no exact rules here"),
        None => "no point was found where both sides have exact values, or the numbers are too large".to_owned(),
    };
    match witness(arena, left, right, difference) {
        Some((witness, true)) => {
            let at: Vec<String> = witness.at.iter().map(|(name, x)| format!("{name} = {x}")).collect();
            format!(
                "{why}; in floating point the sides are {} and {} at {}",
                witness.left,
                witness.right,
                at.join(", ")
            )
        }
        _ => why,
    }
}

/// A proved difference, shown at a state.
fn different(arena: &Arena, left: Expr, right: Expr, difference: Expr) -> Verdict {
    let roots = has_roots(arena, &arena.reachable(&[difference]));
    match witness(arena, left, right, difference) {
        Some((witness, visible)) if visible || !roots => Verdict::Different(witness),
        Some(_) => Verdict::Undecided("the sides differ formally, but at no real state that was tried".to_owned()),
        None => Verdict::Undecided("no real state was found where both sides have values".to_owned()),
    }
}

/// How many states are tried for a witness.
const STATES: usize = 100;

/// A state where the sides differ, and whether they differ there by more than rounding.
fn witness(arena: &Arena, left: Expr, right: Expr, difference: Expr) -> Option<(Witness, bool)> {
    let sides = [left, right, difference];
    let symbols: Vec<Expr> = arena.reachable(&sides).into_iter().filter(|e| arena.symbol_name(*e).is_some()).collect();
    let tape = Tape::new(arena, &symbols, &sides).ok()?;
    let mut generator = Generator(symbols.len() as u64);
    let mut best: Option<(f64, Witness)> = None;
    for _ in 0..STATES {
        let values: Vec<f64> = symbols.iter().map(|s| handy_number(&mut generator, arena.is_positive(*s))).collect();
        let found = tape.evaluate(&values);
        let (left, right, difference) = (found[0], found[1], found[2]);
        if found.iter().any(|x| !x.is_finite()) || difference == 0.0 {
            continue;
        }
        let share = (left - right).abs() / left.abs().max(right.abs()).max(f64::MIN_POSITIVE);
        if best.as_ref().is_none_or(|(most, _)| share > *most) {
            let names = symbols.iter().filter_map(|s| arena.symbol_name(*s)).map(str::to_owned);
            best = Some((share, Witness { at: names.zip(values).collect(), left, right, difference }));
        }
        // A difference that anyone can see.
        if share > 0.05 {
            break;
        }
    }
    best.map(|(share, witness)| (witness, share > 1e-6))
}

/// A number with two decimals, away from 0: people will type it.
fn handy_number(generator: &mut Generator, positive: bool) -> f64 {
    let size = (20 + generator.next() % 280) as f64 / 100.0;
    if positive || generator.next().is_multiple_of(2) { size } else { -size }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::parse::parse_free;

    fn compare(left: &str, right: &str) -> Verdict {
        let mut arena = Arena::new();
        let positive = arena.symbol("M");
        arena.assume_positive(positive);
        let left = parse_free(&mut arena, left).unwrap();
        let right = parse_free(&mut arena, right).unwrap();
        Comparer::default().compare(&mut arena, left, right)
    }

    #[test]
    fn identities_are_proved_by_the_normal_form() {
        for (left, right) in [
            ("sin(q)^2", "1 - cos(q)^2"),
            ("tan(q)*cot(q)", "1"),
            ("sec(q)^2 - tan(q)^2", "csc(q)^2 - cot(q)^2"),
            ("sin(3*q)", "3*sin(q) - 4*sin(q)^3"),
            ("sin(a + b - c)", "sin(a)*cos(b - c) + cos(a)*sin(b - c)"),
            ("cos(q/3)^3", "(3*cos(q/3) + cos(q))/4"),
            ("tan(q/2)", "sin(q)/(1 + cos(q))"),
            ("(a^2 - b^2)/(a - b)", "a + b"),
            ("1/(a - b) - 1/(a + b)", "2*b/(a^2 - b^2)"),
            ("1/(1 + tan(q)^2)", "cos(q)^2"),
            ("sin(q)/(1 - cos(q))", "(1 + cos(q))/sin(q)"),
            ("sqrt(a)*sqrt(a)", "a"),
            ("1/(sqrt(a) - 1)", "(sqrt(a) + 1)/(a - 1)"),
            ("sin((a + b)^2)", "sin(a^2 + 2*a*b + b^2)"),
            ("sin(q + pi/4)*sqrt(2)", "sin(q) + cos(q)"),
            ("9223372036854775807*a*9223372036854775807", "a*9223372036854775807^2"),
        ] {
            assert_eq!(compare(left, right), Verdict::Equal(Engine::NormalForm), "{left} = {right}");
        }
    }

    #[test]
    fn differences_come_with_a_state() {
        for (left, right) in [
            ("sin(q)^2", "1 - cos(q)"),
            ("tan(q/2)", "sin(q)/(1 - cos(q))"),
            ("sqrt(x^2)", "x"),
            ("abs(x)", "x"),
            ("sin((a + b)^2)", "sin(a^2 + a*b + b^2)"),
            ("cos(q)", "sqrt(1 - sin(q)^2)"),
            ("a", "a + b/10^40"),
            ("sin(q + pi/4)", "sin(q + pi/3)"),
        ] {
            let verdict = compare(left, right);
            let Verdict::Different(witness) = verdict else { panic!("{left} = {right}: {verdict:?}") };
            assert!(witness.difference != 0.0 && !witness.at.is_empty(), "{left} = {right}: {witness:?}");
        }
    }

    #[test]
    fn positive_symbols_are_their_own_roots() {
        assert!(compare("sqrt(M^2*a)", "M*sqrt(a)").is_equal());
        assert!(compare("sqrt(M^3)/M", "sqrt(M)").is_equal());
        assert!(compare("abs(M)", "M").is_equal());
        // (1 + M)² has a positive root too, which only the real numbers know.
        assert!(!matches!(compare("sqrt((1 + M)^2)", "1 + M"), Verdict::Different(_)));
    }

    #[test]
    fn what_is_too_large_to_expand_is_equal_within_a_bound() {
        let sums: Vec<String> = (0..40).map(|i| format!("(a{i} + b{i}*sin(q)^2)")).collect();
        let other: Vec<String> = (0..40).map(|i| format!("(a{i} + b{i} - b{i}*cos(q)^2)")).collect();
        let verdict = compare(&sums.join("*"), &other.join("*"));
        let Verdict::Equal(Engine::Modular { exponent }) = verdict else { panic!("{verdict:?}") };
        assert!(exponent > 80.0 && exponent < 250.0, "{exponent}");
        let wrong = other.join("*").replacen("cos(q)", "cos(2*q)", 1);
        assert!(matches!(compare(&sums.join("*"), &wrong), Verdict::Different(_)));
    }

    #[test]
    fn functions_without_rules_leave_it_open_and_say_so() {
        let Verdict::Undecided(why) = compare("exp(a)*exp(b)", "exp(a + b)") else { panic!("no rules for exp") };
        assert!(why.contains("`exp`"), "{why}");
        assert!(compare("exp(a + b)*sin(q)^2", "exp(b + a)*(1 - cos(q)^2)").is_equal());
    }
}
