//! Proofs of equivalence and of first integrals as a file for Coq or Lean, whose kernels check every step.
//!
//! Each identity is a lemma about real numbers. Sine and cosine of an angle are two numbers with s² = 1 − c², a square
//! root is a number with r² = x, and divisors are premises. Formulas are written out without names of parts.

use super::certificate::gives_kane;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use tripos::Mechanism;
use tripos_derive::algebra::form::simplify::operation_count_of_all;
use tripos_derive::algebra::meaning::identity::Identity;
use tripos_derive::algebra::solve::elimination::divisors;
use tripos_derive::algebra::term::calculus::expand_names;
use tripos_derive::algebra::{Arena, Expr, Function, Node, Rational};
use tripos_derive::mechanics::Derivations;
use tripos_derive::model::text_digest;
use tripos_derive::prove::{CombinationPart, Proof};

/// Proof assistant for which lemmas are written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Assistant {
    /// Coq 8.16 with its standard library.
    Coq,
    /// Lean 4 with Mathlib.
    Lean,
}

/// Largest number of operations, and of different subterms, of an identity that becomes a lemma. Coq needs minutes for
/// larger ones.
const LARGEST: usize = 250;

/// Largest number of bytes of a lemma's formulas.
const LONGEST: usize = 2500;

/// Largest number of turns, counted with multiplicity, that an angle in a lemma may be the sum of.
const MOST_TURNS: u64 = 6;

/// Beginning of the file for Lean. The tactic `grind` knows fields and equations between polynomials.
const LEAN_HEADER: &str = "import Mathlib\n";

/// Beginning of the file for Coq: a tactic that proves an expression not zero, since it is ± a divisor among the
/// premises.
const COQ_HEADER: &str = "From Coq Require Import Reals.
Open Scope R_scope.

Ltac divisor rules :=
  let z := fresh in intro z;
  match type of z with ?e = 0 => match goal with H : ?d <> 0 |- _ =>
    apply H; first [transitivity e; [rules | exact z] | transitivity (- e); [rules | rewrite z; ring]] end end.
";

/// Returns the text for a proof assistant: a lemma for each identity that proves a pair of formulations equivalent to
/// Kane's, or a quantity constant. The text states how many identities it leaves out: long ones, and ones with several
/// roots.
pub fn lemma_text(
    model: &Mechanism,
    derivations: &mut Derivations,
    proof: &Proof,
    derivation: &str,
    assistant: Assistant,
) -> String {
    let integrals: Vec<(String, Vec<Identity>)> = proof
        .integrals
        .iter()
        .map(|integral| (integral.name(model, &derivations.kinematics.arena), integral.identities.clone()))
        .collect();
    let mut writer = LemmaWriter::new(&mut derivations.kinematics.arena, assistant);
    for combination in proof.pairs.iter().flat_map(|pair| &pair.combinations) {
        if !gives_kane(combination) {
            continue;
        }
        for (at, (part, identity)) in combination.identities.iter().enumerate() {
            let name = format!("kane_of_{}_{at}", combination.of.name().replace('-', "_"));
            let about = format!("Kane's equations from {}: {}", combination.of.name(), part_in_words(*part));
            writer.lemma(&name, &about, identity);
        }
    }
    for (number, (name, identities)) in integrals.iter().enumerate() {
        for (at, identity) in identities.iter().enumerate() {
            writer.lemma(&format!("integral_{number}_{at}"), &format!("{name}: its rate, part {at}"), identity);
        }
    }
    let (begin, end) = assistant.comment_marks();
    let mut out = format!("{begin} {}\n", comment(&model.title));
    let _ = writeln!(out, "   SHA-256 of the model file: {}", text_digest(&model.source.text));
    let _ = writeln!(out, "   SHA-256 of `tripos derive --json`: {}", text_digest(derivation));
    let _ = writeln!(
        out,
        "   {} lemmas; {} identities are left out, as too long or with several roots {end}",
        writer.count, writer.left_out
    );
    match assistant {
        Assistant::Coq => out + COQ_HEADER + &writer.coq_section(),
        Assistant::Lean => out + LEAN_HEADER + &writer.lean_section(),
    }
}

impl Assistant {
    /// Marks at the beginning and at the end of a comment.
    fn comment_marks(self) -> (&'static str, &'static str) {
        match self {
            Self::Coq => ("(*", "*)"),
            Self::Lean => ("/-", "-/"),
        }
    }
}

/// Returns a text that may stand in a comment of Coq and of Lean.
fn comment(text: &str) -> String {
    let text = text.replace("(*", "( *").replace("*)", "* )").replace('"', "'");
    text.replace("/-", "/ -").replace("-/", "- /")
}

/// Returns in words to which part of the equations an identity belongs. Rows and columns count from 1.
fn part_in_words(part: CombinationPart) -> String {
    match part {
        CombinationPart::Coefficient { row, unknown } => format!("row {}, coefficient {}", row + 1, unknown + 1),
        CombinationPart::Right { row } => format!("row {}, right-hand side", row + 1),
        CombinationPart::Constraint => "row of a constraint".to_owned(),
        CombinationPart::Power { speed, reaction } => {
            format!("power of reaction {} along speed {}", reaction + 1, speed + 1)
        }
    }
}

/// Writer of lemmas, with the variables that they need.
struct LemmaWriter<'a> {
    /// Proof assistant for which the lemmas are written.
    assistant: Assistant,
    /// Arena that stores the terms of the identities.
    arena: &'a mut Arena,
    /// Names of all variables.
    variables: BTreeSet<String>,
    /// Number of each angle, root or other function value that is a variable; the key is its term.
    numbers: BTreeMap<Expr, usize>,
    /// Equations of the variables for sines and roots, by their names.
    rules: BTreeMap<String, String>,
    /// Names of the rules for square roots.
    roots: BTreeSet<String>,
    /// Names of the rules that the lemma needs that is being written.
    needed: BTreeSet<String>,
    /// Text of the lemmas.
    lemmas: String,
    /// Number of lemmas.
    count: usize,
    /// Number of identities that are left out.
    left_out: usize,
}

impl<'a> LemmaWriter<'a> {
    /// Starts a file without lemmas.
    fn new(arena: &'a mut Arena, assistant: Assistant) -> Self {
        Self {
            assistant,
            arena,
            variables: BTreeSet::new(),
            numbers: BTreeMap::new(),
            rules: BTreeMap::new(),
            roots: BTreeSet::new(),
            needed: BTreeSet::new(),
            lemmas: String::new(),
            count: 0,
            left_out: 0,
        }
    }

    /// Returns the section of Lean with the variables and the lemmas. The rules are premises of the lemmas.
    fn lean_section(self) -> String {
        let mut out = "\nsection Identities\n".to_owned();
        for name in &self.variables {
            let _ = writeln!(out, "variable ({name} : ℝ)");
        }
        out + &self.lemmas + "\nend Identities\n"
    }

    /// Returns the section of Coq with the variables, their rules and the lemmas.
    fn coq_section(self) -> String {
        let mut out = "\nSection Identities.\n".to_owned();
        for name in &self.variables {
            let _ = writeln!(out, "Variable {name} : R.");
        }
        for (name, rule) in &self.rules {
            let _ = writeln!(out, "Hypothesis {name} : {rule}.");
        }
        out + &self.lemmas + "\nEnd Identities.\n"
    }

    /// Adds an identity as a lemma with its proof, or counts it as left out.
    fn lemma(&mut self, name: &str, about: &str, identity: &Identity) {
        let Some(texts) = self.formulas(identity) else {
            self.left_out += 1;
            return;
        };
        self.count += 1;
        match self.assistant {
            Assistant::Coq => self.coq_lemma(name, about, &texts),
            Assistant::Lean => self.lean_lemma(name, about, &texts),
        }
    }

    /// Adds a lemma of Lean. The texts are the sides of the identity, and then its divisors.
    fn lean_lemma(&mut self, name: &str, about: &str, texts: &[String]) {
        let _ = writeln!(self.lemmas, "\n/- {} -/\ntheorem {name}", comment(about));
        for rule in &self.needed {
            let _ = writeln!(self.lemmas, "    ({rule} : {})", self.rules[rule]);
        }
        for (at, divisor) in texts[2..].iter().enumerate() {
            let _ = writeln!(self.lemmas, "    (divisor_{at} : {divisor} ≠ 0)");
        }
        let proof = if texts[0] == texts[1] { "rfl" } else { "grind" };
        let _ = writeln!(self.lemmas, "    : {} = {} := by {proof}", texts[0], texts[1]);
    }

    /// Adds a lemma of Coq. The texts are the sides of the identity, and then its divisors.
    fn coq_lemma(&mut self, name: &str, about: &str, texts: &[String]) {
        let _ = writeln!(self.lemmas, "\n(* {} *)\nLemma {name} :", comment(about));
        for divisor in &texts[2..] {
            let _ = writeln!(self.lemmas, "  {divisor} <> 0 ->");
        }
        let _ = writeln!(self.lemmas, "  {} = {}.", texts[0], texts[1]);
        let rules: Vec<&str> = self.needed.iter().map(String::as_str).collect();
        let rules = if rules.is_empty() { String::new() } else { format!(" [{}]", rules.join(" ")) };
        let proof = if texts[0] == texts[1] {
            "reflexivity".to_owned()
        } else {
            format!("field{rules}; repeat split; first [assumption | discrR | divisor ltac:(field{rules})]")
        };
        let _ = writeln!(self.lemmas, "Proof. intros. {proof}. Qed.");
    }

    /// Returns the sides of an identity and then its divisors as formulas. `None` if they are too long.
    fn formulas(&mut self, identity: &Identity) -> Option<Vec<String>> {
        let sides = [identity.left, identity.right];
        let is_short = |arena: &Arena, sides: &[Expr]| {
            arena.reachable(sides).len() <= LARGEST && operation_count_of_all(arena, sides) <= LARGEST
        };
        if !is_short(self.arena, &sides) {
            return None;
        }
        let sides = sides.map(|side| expand_names(self.arena, side));
        self.needed.clear();
        let divided = divisors(self.arena, &sides);
        let texts = sides.iter().chain(&divided).map(|e| self.text(*e)).collect::<Option<Vec<_>>>()?;
        // Two roots may be equal although their squares are written differently, and the assistant is not told so.
        let roots = self.needed.iter().filter(|rule| self.roots.contains(*rule)).count();
        let is_short = texts.iter().map(String::len).sum::<usize>() <= LONGEST;
        (is_short && roots <= 1).then_some(texts)
    }

    /// Returns a term as a formula. `None` if an angle is no sum of a few multiples of terms.
    fn text(&mut self, e: Expr) -> Option<String> {
        Some(match self.arena.node(e).clone() {
            Node::Number(value) => self.number_text(&value),
            Node::Symbol(_) => {
                let name = format!("x_{}", self.arena.symbol_name(e)?);
                self.variable(name)
            }
            Node::Pi => self.variable("number_pi".to_owned()),
            Node::Named(_, value) => self.text(value)?,
            Node::Sum(constant, terms) => {
                let mut parts = if constant.is_zero() { Vec::new() } else { vec![self.number_text(&constant)] };
                for (term, factor) in &terms {
                    let term = self.text(*term)?;
                    parts.push(if factor.is_one() { term } else { format!("{} * {term}", self.number_text(factor)) });
                }
                format!("({})", parts.join(" + "))
            }
            Node::Product(factors) => {
                let mut parts = Vec::new();
                for (base, exponent) in &factors {
                    let power = match (self.text(*base)?, exponent.unsigned_abs()) {
                        (base, 1) => base,
                        (base, n) => format!("{base} ^ {n}"),
                    };
                    parts.push(match self.assistant {
                        _ if *exponent > 0 => power,
                        Assistant::Coq => format!("/ {power}"),
                        Assistant::Lean => format!("({power})⁻¹"),
                    });
                }
                format!("({})", parts.join(" * "))
            }
            Node::Apply(Function::Cos, angle) => self.turn(angle)?.0,
            Node::Apply(Function::Sin, angle) => self.turn(angle)?.1,
            Node::Apply(Function::Sqrt, square) => {
                let root = format!("root_{}", self.number_of(e));
                let rule = format!("{root} ^ 2 = {}", self.text(square)?);
                self.roots.insert(format!("square_of_{root}"));
                self.rule(format!("square_of_{root}"), rule);
                self.variable(root)
            }
            Node::Apply(..) => {
                let value = format!("value_{}", self.number_of(e));
                self.variable(value)
            }
        })
    }

    /// Returns cosine and sine of an angle by the addition theorem. `None` if the angle is too long a sum.
    fn turn(&mut self, angle: Expr) -> Option<(String, String)> {
        let parts = match self.arena.node(angle).clone() {
            Node::Sum(constant, terms) if constant.is_zero() => terms.into_vec(),
            _ => vec![(angle, Rational::ONE)],
        };
        let counts: Vec<i64> = parts.iter().map(|(_, factor)| factor.to_i64()).collect::<Option<_>>()?;
        if counts.iter().map(|count| count.unsigned_abs()).sum::<u64>() > MOST_TURNS {
            return None;
        }
        let mut found: Option<(String, String)> = None;
        for ((part, _), count) in parts.iter().zip(counts) {
            let at = self.number_of(*part);
            let (c, s) = (self.variable(format!("cos_{at}")), self.variable(format!("sin_{at}")));
            self.rule(format!("circle_{at}"), format!("{s} ^ 2 = 1 - {c} ^ 2"));
            let s = if count < 0 { format!("(- {s})") } else { s };
            for _ in 0..count.unsigned_abs() {
                found = Some(match found {
                    None => (c.clone(), s.clone()),
                    Some((a, b)) => (format!("({a} * {c} - {b} * {s})"), format!("({b} * {c} + {a} * {s})")),
                });
            }
        }
        found
    }

    /// Adds a variable, and returns its name.
    fn variable(&mut self, name: String) -> String {
        self.variables.insert(name.clone());
        name
    }

    /// Adds an equation of a variable, which the lemma needs that is being written.
    fn rule(&mut self, name: String, rule: String) {
        self.needed.insert(name.clone());
        self.rules.insert(name, rule);
    }

    /// Returns a rational number as a formula.
    fn number_text(&self, value: &Rational) -> String {
        match self.assistant {
            Assistant::Coq => format!("({value})"),
            Assistant::Lean => format!("({value} : ℝ)"),
        }
    }

    /// Returns the number of the variable for a term.
    fn number_of(&mut self, e: Expr) -> usize {
        let next = self.numbers.len() + 1;
        *self.numbers.entry(e).or_insert(next)
    }
}
