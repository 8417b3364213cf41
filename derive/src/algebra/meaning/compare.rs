//! Comparison of two terms by meaning, in whatever form they are written: they are equal,
//! different, or the question is undecided.
//!
//! ```
//! use tripos_derive::algebra::Arena;
//! use tripos_derive::algebra::meaning::compare::{Comparer, Verdict};
//! use tripos_derive::algebra::text::parse::parse_free;
//!
//! let mut arena = Arena::new();
//! let a = parse_free(&mut arena, "1 + tan(q)^2").unwrap();
//! let b = parse_free(&mut arena, "sec(q)^2").unwrap();
//! assert!(matches!(Comparer::default().compare(&mut arena, a, b), Verdict::Equal(_)));
//! ```
//!
//! A [`Comparer`] compares terms in all states, or only in permitted states ([`super::permitted_states`]):
//! those on constraints and in a domain.
//!
//! Two engines decide. [`crate::algebra::value::zero_test`] evaluates exactly at random points of
//! random prime fields: a single non-zero value proves that the sides differ. If it finds zeros
//! only, [`crate::algebra::form::normal_form`] proves equality. Terms that are too large for the normal
//! form are equal with the error bound of the first engine.
//! Floating point decides nothing: it only finds a state that shows a difference which is already
//! proved. With roots or functions without rules, a difference counts only if a real state proves
//! it, by intervals rounded outwards (module `interval`). For example, √x² is x for some x and not
//! for others.

use super::permitted_states::{PermittedStates, RewrittenSides, StatesOfValidity};
use super::signs::Signs;
use super::witness::{WitnessRequest, find_witness};
use crate::algebra::form::normal_form::{Normalizer, Zero};
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::elementary::{angle_atoms, divided_term_by_term, is_exponential, is_plain_angle_atom};
use crate::algebra::text::print::print_text;
use crate::algebra::value::zero_test::{ZeroTest, bounded_zero_test, has_roots, zero_test};
use crate::algebra::{Arena, Expr, Function, Node};
use std::fmt;

pub use super::witness::Witness;

/// Engine that proved an equality of two terms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Engine {
    /// The normal form of the difference of the two terms is 0.
    NormalForm,
    /// The difference of the two terms is 0 at random points of random prime fields. The verdict
    /// "equal" is wrong with a probability below 2^−exponent.
    Modular {
        /// Exponent of the error bound 2^−exponent.
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

/// Verdict on two terms: equal, different or undecided, in whatever form they are written.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The two terms are equal wherever both have a value. The engine says by which method this is
    /// proved.
    Equal(Engine),
    /// The two terms differ. The witness is a state at which their values differ.
    Different(Witness),
    /// The question is not decided; the text is the reason.
    Undecided(String),
}

impl Verdict {
    /// True if the verdict is that the two terms are equal.
    #[must_use]
    pub fn is_equal(&self) -> bool {
        matches!(self, Self::Equal(_))
    }
}

/// Largest number of multiplications of polynomial terms for expanding the angles of one
/// comparison.
const ANGLES: u64 = 100_000;

/// Answer of exact algebra to the question if a difference of terms is zero.
#[derive(Clone, Copy)]
enum Answer {
    /// The difference is proved to be zero, by the engine.
    Zero(Engine),
    /// The difference is proved not to be zero as a formula.
    NonZero,
    /// Neither engine decides if the difference is zero.
    Unknown,
    /// The two engines contradict each other, which shows a defect of the program.
    Disputed,
}

/// Comparer of terms, which decides if they are equal in whatever form they are written. It
/// remembers their normal forms.
pub struct Comparer {
    /// Converter of terms to normal forms, which it remembers.
    normalizer: Normalizer,
    /// Number of multiplications of polynomial terms left for all normal forms together. It keeps
    /// many large comparisons from adding up to hours.
    budget: u64,
    /// Permitted states, in which the terms are compared.
    permitted: PermittedStates,
}

impl Default for Comparer {
    fn default() -> Self {
        Self::in_permitted_states(PermittedStates::default())
    }
}

impl Comparer {
    /// Creates a comparer for permitted states. Equal terms are equal in all permitted states, and
    /// different terms differ in at least one.
    #[must_use]
    pub fn in_permitted_states(permitted: PermittedStates) -> Self {
        Self { normalizer: Normalizer::default(), budget: 10 * Normalizer::BUDGET, permitted }
    }

    /// Permitted states in which the comparer compares terms.
    pub fn permitted(&mut self) -> &mut PermittedStates {
        &mut self.permitted
    }

    /// Compares two terms, in whatever form they are written: they are equal if they agree in all
    /// permitted states in which both have values.
    pub fn compare(&mut self, arena: &mut Arena, left: Expr, right: Expr) -> Verdict {
        self.compare_with_states(arena, left, right).0
    }

    /// Compares two terms like [`Self::compare`], and also returns the states in which an equality
    /// holds.
    pub fn compare_with_states(&mut self, arena: &mut Arena, left: Expr, right: Expr) -> (Verdict, StatesOfValidity) {
        let (everywhere, difference) = self.decide_difference(arena, left, right);
        if let Answer::Zero(engine) = everywhere {
            return (Verdict::Equal(engine), StatesOfValidity::EVERYWHERE);
        }
        if self.permitted.is_everything() {
            let signs = Signs::default();
            let defined = arena.restrictions().to_vec();
            let shown_symbols =
                symbols_compared(arena, &[left, right, difference]).into_iter().map(|s| (s, s)).collect();
            let sides = [left, right, difference];
            let asked = WitnessRequest { sides, defined, positive: &[], signs: &signs, shown: shown_symbols };
            return (compare_by_witness(arena, &asked, everywhere), StatesOfValidity::EVERYWHERE);
        }
        let verdict = self.where_permitted(arena, left, right, everywhere);
        match verdict {
            Ok((engine, holds)) => (Verdict::Equal(engine), holds),
            Err(verdict) => (verdict, StatesOfValidity::EVERYWHERE),
        }
    }

    /// Compares two sides in permitted states, if they are not proved equal in all states. Returns
    /// the engine that proves them equal there, and the states in which the equality holds. The
    /// error is the verdict "different" or "undecided".
    fn where_permitted(
        &mut self,
        arena: &mut Arena,
        left: Expr,
        right: Expr,
        everywhere: Answer,
    ) -> Result<(Engine, StatesOfValidity), Verdict> {
        let Some(views) = self.permitted.rewritten_sides(arena, left, right) else {
            return Err(Verdict::Undecided("the formula divides by a term that the constraints make zero".to_owned()));
        };
        let difference = arena.sub(left, right);
        let (mut answer, mut sides) = (everywhere, [left, right, difference]);
        for RewrittenSides { holds, sides: (left, right) } in views {
            let (found, difference) = self.decide_difference(arena, left, right);
            if let Answer::Zero(engine) = found {
                return Ok((engine, holds));
            }
            (answer, sides) = (found, [left, right, difference]);
        }
        if let Some(why) = self.permitted.unsolved_equation() {
            return Err(Verdict::Undecided(why.to_owned()));
        }
        let defined = arena.restrictions().to_vec();
        let defined = defined.into_iter().map(|e| self.permitted.write_in_free_symbols(arena, e)).collect();
        // Free symbols that determine dependent symbols are shown too, so that a reader can check
        // the state.
        let mentioned = symbols_compared(arena, &[left, right]);
        let values: Vec<Expr> = mentioned.iter().map(|s| self.permitted.write_in_free_symbols(arena, *s)).collect();
        let free = if self.permitted.shows_free_symbols() { symbols_compared(arena, &values) } else { Vec::new() };
        let mut all = [mentioned, free].concat();
        all.sort_unstable();
        all.dedup();
        let shown_symbols = all.into_iter().map(|s| (s, self.permitted.write_in_free_symbols(arena, s))).collect();
        let (positive, signs) = (self.permitted.free_conditions(), self.permitted.free_signs());
        Err(compare_by_witness(
            arena,
            &WitnessRequest { sides, defined, positive, signs, shown: shown_symbols },
            answer,
        ))
    }

    /// Decides by exact algebra if left − right is zero. Returns the answer and the difference with
    /// expanded angles.
    fn decide_difference(&mut self, arena: &mut Arena, left: Expr, right: Expr) -> (Answer, Expr) {
        let difference = arena.sub(left, right);
        if difference == Expr::ZERO {
            return (Answer::Zero(Engine::NormalForm), difference);
        }
        let difference = self.expand_angles(arena, difference);
        let (zero, exponent) = bounded_zero_test(arena, difference);
        if zero == ZeroTest::NonZero {
            return (Answer::NonZero, difference);
        }
        let granted = self.budget.min(Normalizer::BUDGET);
        self.normalizer.set_budget(granted);
        let form = self.normalizer.zero_by_normal_form(arena, difference);
        self.budget -= granted - self.normalizer.ring().budget;
        let answer = match (form, zero) {
            (Zero::Yes, _) => Answer::Zero(Engine::NormalForm),
            (Zero::No, ZeroTest::Zero) => Answer::Disputed,
            (Zero::No, _) => Answer::NonZero,
            (_, ZeroTest::Zero) => Answer::Zero(Engine::Modular { exponent }),
            _ => Answer::Unknown,
        };
        (answer, difference)
    }

    /// Compares the term `e` with zero, in whatever form the term is written.
    pub fn is_zero(&mut self, arena: &mut Arena, e: Expr) -> Verdict {
        self.compare(arena, e, Expr::ZERO)
    }

    /// Expands the arguments of sines and cosines in a term, such as (a + b)², to sums of products,
    /// so that equal angles become equal terms.
    ///
    /// The expansion has its own budget of multiplications. No comparison is possible without it,
    /// and angles are short.
    pub(crate) fn expand_angles(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        self.normalizer.set_budget(ANGLES);
        let mut pairs = Vec::new();
        for part in arena.reachable(&[e]) {
            let Node::Apply(f @ (Function::Sin | Function::Cos), argument) = *arena.node(part) else { continue };
            if angle_atoms(arena, argument).iter().all(|(atom, _)| is_plain_angle_atom(arena, *atom)) {
                continue;
            }
            if let Some(form) = self.normalizer.normal_form(arena, argument) {
                let expanded = self.normalizer.expression(arena, &form);
                let expanded = divided_term_by_term(arena, expanded);
                pairs.push((part, arena.apply(f, expanded)));
            }
        }
        if pairs.is_empty() { e } else { Substitution::new(&pairs).apply(arena, e) }
    }
}

/// Symbols that occur in the given terms, each once.
fn symbols_compared(arena: &Arena, terms: &[Expr]) -> Vec<Expr> {
    arena.reachable(terms).into_iter().filter(|e| arena.symbol_name(*e).is_some()).collect()
}

/// Reason, in words, for an undecided comparison with the given difference of the terms.
fn reason_of_undecided_comparison(arena: &Arena, difference: Expr) -> String {
    let parts = arena.reachable(&[difference]);
    let divisors = parts.iter().flat_map(|p| match arena.node(*p) {
        Node::Product(factors) => factors.iter().filter(|(_, n)| *n < 0).map(|(base, _)| *base).collect(),
        _ => Vec::new(),
    });
    for divisor in divisors {
        if zero_test(arena, divisor) == ZeroTest::Zero {
            return format!("the formula divides by {}, which is zero everywhere", print_text(arena, divisor));
        }
    }
    let opaque = parts.iter().find_map(|p| match arena.node(*p) {
        Node::Apply(Function::Sin | Function::Cos | Function::Sqrt | Function::Abs | Function::Sign, _) => None,
        Node::Apply(f, _) if !is_exponential(*f) => Some(f.name()),
        _ => None,
    });
    match opaque {
        Some(name) => format!("`{name}` has no exact rules here"),
        None if has_roots(arena, &parts) => "its square roots or absolute values cannot be told apart".to_owned(),
        None => "no point was found where both sides have exact values, or the numbers are too large".to_owned(),
    }
}

/// Verdict on two sides that are not proved equal. It is a state that shows their difference, or
/// the reason why the question is undecided.
fn compare_by_witness(arena: &Arena, asked: &WitnessRequest<'_>, zero: Answer) -> Verdict {
    let roots = has_roots(arena, &arena.reachable(&[asked.sides[2]]));
    if let Answer::Disputed = zero {
        return Verdict::Undecided("the two engines disagree: a defect of the program, please report it".to_owned());
    }
    match (find_witness(arena, asked), zero) {
        (Some((witness, true)), _) => Verdict::Different(witness),
        (Some((witness, false)), Answer::NonZero) if !roots => Verdict::Different(witness),
        // If exact arithmetic does not decide, only a real state does whose interval excludes 0.
        (_, Answer::Unknown) => Verdict::Undecided(reason_of_undecided_comparison(arena, asked.sides[2])),
        (Some(_), _) => Verdict::Undecided(
            "the two sides differ as formulas, but are equal at every real state that was tried".to_owned(),
        ),
        (None, _) => {
            Verdict::Undecided("no state was found where both sides have finite values that differ".to_owned())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::parse::parse_free;

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
            ("sin(a)", "sin(a - b/c)*cos(b/c) + cos(a - b/c)*sin(b/c)"),
            ("sin((a + b)/c)", "sin(a/c)*cos(b/c) + cos(a/c)*sin(b/c)"),
            ("sin((a + b)/(2*c))", "sin(a/(2*c))*cos(b/(2*c)) + cos(a/(2*c))*sin(b/(2*c))"),
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
            ("sin(a - b/c)", "sin(a + b/c)"),
        ] {
            let verdict = compare(left, right);
            let Verdict::Different(witness) = verdict else { panic!("{left} = {right}: {verdict:?}") };
            assert!(witness.difference != 0.0 && !witness.at.is_empty(), "{left} = {right}: {witness:?}");
        }
    }

    /// Absolute values, roots of numbers, multiples of π/12 and rounding lead to no wrong verdict.
    /// Random points rarely meet the sign patterns that decide here.
    #[test]
    fn roots_deceive_neither_way() {
        let product = |n: usize| (0..n).map(|i| format!("(abs(x{i}) - x{i})")).collect::<Vec<_>>().join("*");
        for n in 1..9 {
            assert!(!compare(&product(n), "0").is_equal(), "{n} factors");
        }
        for (left, right) in [
            ("sqrt(6 + 4*sqrt(2))", "-2 - sqrt(2)"),
            ("x*sqrt(11 + 6*sqrt(2))", "-x*(3 + sqrt(2))"),
            ("cos(pi/12)", "-sqrt(2 + sqrt(3))/2"),
        ] {
            assert!(matches!(compare(left, right), Verdict::Different(_)), "{left} = {right}");
        }
        for (left, right) in [
            ("sin(pi/12)*cos(pi/12)", "1/4"),
            ("16*sin(pi/12)^4 + 1", "16*sin(pi/12)^2"),
            ("sin(q + pi/12)*sin(5*pi/12)", "(cos(q - pi/3) - cos(q + pi/2))/2"),
            ("sin(5*pi/12)", "cos(pi/12)"),
        ] {
            assert!(compare(left, right).is_equal(), "{left} = {right}: {:?}", compare(left, right));
        }
        for (left, right) in [
            ("sqrt(x^4 + 2*x^2 + 1)", "x^2 + 1"),
            ("sqrt(M^3*a + 2*M^2*a + M*a)", "sqrt(M)*sqrt(a)*(1 + M)"),
            ("10^20*(sqrt(x^4 + 2*x^2 + 1) - x^2 - 1) + x", "x"),
        ] {
            assert!(!matches!(compare(left, right), Verdict::Different(_)), "{left} = {right}");
        }
    }

    #[test]
    fn a_square_of_many_sines_does_not_fill_memory() {
        let product: Vec<String> = (0..28).map(|i| format!("sin(p{}*q{})", i % 4, i / 4)).collect();
        let product = product.join("*");
        let (left, right) =
            (format!("({product} + 1)^2*(a + b)"), format!("({product} + 1)^2*a + b*({product} + 1)^2"));
        assert!(compare(&left, &right).is_equal());
    }

    #[test]
    fn positive_symbols_are_their_own_roots() {
        assert!(compare("sqrt(M^2*a)", "M*sqrt(a)").is_equal());
        assert!(compare("sqrt(M^3)/M", "sqrt(M)").is_equal());
        assert!(compare("abs(M)", "M").is_equal());
        // (1 + M)² has a positive root too, which only the real numbers know.
        assert!(!matches!(compare("sqrt((1 + M)^2)", "1 + M"), Verdict::Different(_)));
        // Rounding proves no difference either, where terms of size 10^17 cancel.
        let verdict = compare("sqrt((1 + M)^2)", "1 + M + 10^17*cos(q)^2 + 10^17*sin(q)^2 - 10^17");
        assert!(!matches!(verdict, Verdict::Different(_)), "{verdict:?}");
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
    fn angles_are_compared_whatever_was_spent_before() {
        let mut arena = Arena::new();
        let [left, right] =
            ["sin((a + b)^2)", "sin(a^2 + 2*a*b + b^2)"].map(|text| parse_free(&mut arena, text).unwrap());
        let mut spent = Comparer { budget: 0, ..Comparer::default() };
        assert!(spent.compare(&mut arena, left, right).is_equal());
    }

    #[test]
    fn functions_without_rules_leave_it_open_and_say_so() {
        let Verdict::Undecided(why) = compare("log(a) + log(b)", "log(a*b)") else { panic!("no rules for log") };
        assert!(why.contains("`log`"), "{why}");
        assert!(compare("exp(a)*exp(b)", "exp(a + b)").is_equal());
        assert!(compare("cosh(a)^2 - sinh(a)^2", "1").is_equal());
        assert!(matches!(compare("exp(a)*exp(b)", "exp(a - b)"), Verdict::Different(_)));
        let Verdict::Undecided(why) = compare("1/(sin(q)^2 + cos(q)^2 - 1)", "a") else { panic!("it has no value") };
        assert!(why.contains("zero everywhere"), "{why}");
        assert!(compare("exp(a + b)*sin(q)^2", "exp(b + a)*(1 - cos(q)^2)").is_equal());
    }

    /// A term that cancels from the difference still restricts the states in which the sides are
    /// compared.
    #[test]
    fn no_witness_is_outside_the_domain_of_what_was_written() {
        let judged = |left: &str, right: &str| {
            let mut arena = Arena::new();
            let (a, b) = (parse_free(&mut arena, left).unwrap(), parse_free(&mut arena, right).unwrap());
            Comparer::default().compare(&mut arena, a, b)
        };
        for text in ["log(w) - (log(w) + abs(w) - w)", "sqrt(w)^2 - abs(w)", "0*acos(w - 2) + abs(w) - w"] {
            assert!(!matches!(judged(text, "0"), Verdict::Different(_)), "{text}: {:?}", judged(text, "0"));
        }
        // Without the logarithm the two sides differ. So do two sides that differ where the
        // logarithm is defined.
        assert!(matches!(judged("abs(w) - w", "0"), Verdict::Different(_)));
        let Verdict::Different(witness) = judged("log(w) - log(w) + 2*w", "w") else { panic!("2 w is not w") };
        assert!(witness.at.len() == 1 && witness.at[0].1 > 0.0, "{witness:?}");
        let Verdict::Different(witness) = judged("log(v) - log(v) + 2*w", "w") else { panic!("2 w is not w") };
        assert_eq!(witness.at.len(), 1, "{witness:?}");
    }
}
