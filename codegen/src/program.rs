//! A straight-line program: sines and cosines, shared terms, outputs, each with a name that says what
//! it holds.

use crate::identifiers::input_name;
use rustc_hash::{FxHashMap, FxHashSet};
use tripos_derive::algebra::print::text;
use tripos_derive::algebra::view::{View, view};
use tripos_derive::algebra::{Arena, Expr, Function, Node};

/// Nodes in one formula above which code generation gives up rather than write megabytes.
const BUDGET: usize = 2_000_000;

/// A statement `let name = value;` with the equation it stands for.
#[derive(Clone, Debug)]
pub struct Statement {
    /// The variable.
    pub name: String,
    /// Its value, with shared terms standing as their names.
    pub value: View,
    /// What the variable is, in the language of model files, and where it comes from.
    pub comment: String,
}

/// The body of one generated function.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// Symbols that the program reads.
    pub inputs: FxHashSet<Expr>,
    /// Angles whose sine and cosine are needed: (sine's name, cosine's name, angle, angle as text).
    pub angles: Vec<(String, String, View, String)>,
    /// Shared terms, operands first.
    pub shared: Vec<Statement>,
    /// The outputs, in order.
    pub outputs: Vec<Statement>,
}

/// An output to be computed: its variable, its symbol in comments, its expression.
#[derive(Clone, Debug)]
pub struct Output {
    /// The variable, unique among the outputs.
    pub name: String,
    /// How comments call it: `M12`, `f3`.
    pub label: String,
    /// What is computed.
    pub value: Expr,
}

/// Orders, shares and names everything that the outputs need.
#[must_use]
pub fn program(arena: &Arena, outputs: &[Output]) -> Program {
    let roots: Vec<Expr> = outputs.iter().map(|o| o.value).collect();
    let parts = arena.reachable(&roots);
    let mut names = Names::new(outputs);
    let inputs: FxHashSet<Expr> = parts.iter().copied().filter(|e| matches!(arena.node(*e), Node::Symbol(_))).collect();
    let uses = use_counts(arena, &parts, &roots);
    let mut shared: FxHashMap<Expr, String> = FxHashMap::default();
    let mut result = Program { inputs, ..Program::default() };
    for &e in &parts {
        if matches!(arena.node(e), Node::Symbol(_)) {
            shared.insert(e, input_name(arena.symbol_name(e).unwrap_or_default()));
        }
    }
    for &e in &parts {
        match arena.node(e) {
            Node::Apply(Function::Sin | Function::Cos, angle) => {
                let sine = circular(arena, *angle, "s", &mut names);
                let cosine = circular(arena, *angle, "c", &mut names);
                let name = if matches!(arena.node(e), Node::Apply(Function::Sin, _)) { &sine } else { &cosine };
                shared.insert(e, name.clone());
                if !result.angles.iter().any(|(s, ..)| *s == sine) {
                    result.angles.push((sine, cosine, operand(arena, *angle, &shared), text(arena, *angle)));
                }
            }
            Node::Sum(..) | Node::Product(_) | Node::Apply(..) if uses.get(&e).copied().unwrap_or(0) > 1 => {
                let name = names.descriptive(arena, e, outputs);
                let value = view(arena, e, &shared, BUDGET);
                let comment = format!("{}; used {} times", text(arena, e), uses[&e]);
                shared.insert(e, name.clone());
                result.shared.push(Statement { name, value, comment });
            }
            _ => {}
        }
    }
    for output in outputs {
        // A root that is itself shared is already computed.
        let value = operand(arena, output.value, &shared);
        let comment = format!("{} = {}", output.label, text(arena, output.value));
        result.outputs.push(Statement { name: output.name.clone(), value, comment });
    }
    name_tangents(&mut result, &mut names);
    result
}

/// A term as it stands inside others: by its name, if it has one.
fn operand(arena: &Arena, e: Expr, shared: &FxHashMap<Expr, String>) -> View {
    match shared.get(&e) {
        Some(name) => View::Shared(name.clone()),
        None => view(arena, e, shared, BUDGET),
    }
}

/// How often each term is used as an operand or as an output.
fn use_counts(arena: &Arena, parts: &[Expr], roots: &[Expr]) -> FxHashMap<Expr, usize> {
    let mut uses: FxHashMap<Expr, usize> = FxHashMap::default();
    for operand in parts.iter().flat_map(|part| arena.operands(*part)).chain(roots.iter().copied()) {
        *uses.entry(operand).or_default() += 1;
    }
    uses
}

/// `s1`, `c1` for the angle q1; `sin_theta` for others.
fn circular(arena: &Arena, angle: Expr, kind: &str, names: &mut Names) -> String {
    let key = format!("{kind} of {}", text(arena, angle));
    if let Some(known) = names.known.get(&key) {
        return known.clone();
    }
    let long = if kind == "s" { "sin" } else { "cos" };
    let stem = match arena.symbol_name(angle) {
        Some(name) if name.starts_with('q') && name[1..].bytes().all(|b| b.is_ascii_digit()) && name.len() > 1 => {
            format!("{kind}{}", &name[1..])
        }
        Some(name) => format!("{long}_{}", input_name(name).trim_end_matches('_')),
        None => format!("{long}_{}", identifier(&text(arena, angle), 24).unwrap_or_else(|| "angle".to_owned())),
    };
    let name = names.unique(&stem);
    names.known.insert(key, name.clone());
    name
}

/// Letters and digits of a formula as one word, if that is short enough.
fn identifier(formula: &str, longest: usize) -> Option<String> {
    let spelled = formula.replace('-', "_minus_").replace('+', "_plus_").replace('/', "_by_");
    let words: Vec<&str> =
        spelled.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').filter(|w| !w.is_empty()).collect();
    let word = words.join("_").split('_').filter(|w| !w.is_empty()).collect::<Vec<_>>().join("_").to_lowercase();
    (word.len() <= longest && word.starts_with(|c: char| c.is_ascii_alphabetic())).then_some(word)
}

/// Names given so far.
struct Names {
    taken: FxHashSet<String>,
    known: FxHashMap<String, String>,
}

impl Names {
    fn new(outputs: &[Output]) -> Self {
        let mut taken: FxHashSet<String> = outputs.iter().map(|o| o.name.clone()).collect();
        taken.extend(["p", "q", "u", "q_dot", "v_dot", "out", "zero"].map(str::to_owned));
        Self { taken, known: FxHashMap::default() }
    }

    fn unique(&mut self, stem: &str) -> String {
        let mut name = input_name(stem);
        let mut count = 2;
        while !self.taken.insert(name.clone()) {
            name = format!("{stem}_{count}");
            count += 1;
        }
        name
    }

    /// A name after what the term holds, or after the output that needs it first.
    fn descriptive(&mut self, arena: &Arena, e: Expr, outputs: &[Output]) -> String {
        let factors: Vec<(Expr, i32)> = match arena.node(e) {
            Node::Product(factors) => factors.to_vec(),
            Node::Sum(constant, terms) if constant_free(constant) && terms.len() == 1 => match arena.node(terms[0].0) {
                Node::Product(factors) => factors.to_vec(),
                _ => vec![(terms[0].0, 1)],
            },
            _ => Vec::new(),
        };
        let mut words = Vec::new();
        for (base, n) in &factors {
            let Some(word) = self.word(arena, *base) else {
                words.clear();
                break;
            };
            let power = match n {
                1 => String::new(),
                2 => "_sq".to_owned(),
                n if *n > 0 => format!("_p{n}"),
                -1 => "_inv".to_owned(),
                n => format!("_inv{}", -n),
            };
            words.push(format!("{word}{power}"));
        }
        let joined = words.join("_").to_lowercase();
        if !joined.is_empty() && joined.len() <= 20 {
            let scaled = matches!(arena.node(e), Node::Sum(..));
            return self.unique(&if scaled { format!("{joined}_scaled") } else { joined });
        }
        if let Some(word) = identifier(&text(arena, e), 16) {
            return self.unique(&word);
        }
        let first = outputs.iter().find(|o| arena.reachable(&[o.value]).binary_search(&e).is_ok());
        let stem = first.map_or("shared".to_owned(), |o| o.name.clone());
        self.unique(&format!("{stem}_part"))
    }

    fn word(&mut self, arena: &Arena, base: Expr) -> Option<String> {
        match arena.node(base) {
            Node::Symbol(_) => Some(input_name(arena.symbol_name(base)?)),
            Node::Apply(Function::Sin, angle) => Some(circular(arena, *angle, "s", self)),
            Node::Apply(Function::Cos, angle) => Some(circular(arena, *angle, "c", self)),
            _ => None,
        }
    }
}

fn constant_free(constant: &tripos_derive::algebra::Rational) -> bool {
    constant.is_zero()
}

/// Gives each tangent a variable of its own, right after the sines and cosines.
fn name_tangents(program: &mut Program, names: &mut Names) {
    let mut tangents: Vec<(View, String)> = Vec::new();
    let mut statements = Vec::new();
    let angles = program.angles.clone();
    let all = program.shared.iter_mut().chain(&mut program.outputs).map(|s| &mut s.value);
    for value in all {
        replace_tangents(value, &mut |angle| {
            if let Some((_, name)) = tangents.iter().find(|(a, _)| a == angle) {
                return View::Shared(name.clone());
            }
            let (sine, cosine, _, spelled) =
                angles.iter().find(|(_, _, a, _)| a == angle).expect("a tangent is a quotient of a sine and a cosine");
            let stem = if let Some(digits) = sine.strip_prefix('s').filter(|d| d.bytes().all(|b| b.is_ascii_digit())) {
                format!("t{digits}")
            } else {
                sine.replacen("sin", "tan", 1)
            };
            let name = names.unique(&stem);
            let quotient = View::Fraction(Box::new(View::Shared(sine.clone())), Box::new(View::Shared(cosine.clone())));
            statements.push(Statement { name: name.clone(), value: quotient, comment: format!("tan({spelled})") });
            tangents.push((angle.clone(), name.clone()));
            View::Shared(name)
        });
    }
    statements.append(&mut program.shared);
    program.shared = statements;
}

fn replace_tangents(view: &mut View, name: &mut impl FnMut(&View) -> View) {
    match view {
        View::Call("tan", angle) => *view = name(angle),
        View::Call(_, inner) | View::Root(inner) | View::Power(inner, _) => replace_tangents(inner, name),
        View::Sum(terms) => terms.iter_mut().for_each(|(_, term)| replace_tangents(term, name)),
        View::Product(factors) => factors.iter_mut().for_each(|factor| replace_tangents(factor, name)),
        View::Fraction(above, below) => {
            replace_tangents(above, name);
            replace_tangents(below, name);
        }
        View::Number(_) | View::Name(_) | View::Shared(_) | View::Pi | View::Cut => {}
    }
}
