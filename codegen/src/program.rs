//! A straight-line program: sines and cosines, shared terms, outputs, each with a name that says what
//! it holds.

use crate::identifiers::{Allocator, Variables, spelled};
use rustc_hash::{FxHashMap, FxHashSet};
use tripos_derive::algebra::elimination::Definition;
use tripos_derive::algebra::print::text;
use tripos_derive::algebra::sharing::is_shared_symbol;
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

/// One line of a program.
#[derive(Clone, Debug)]
pub enum Line {
    /// Sine and cosine of an angle.
    Circular {
        /// The sine's variable.
        sine: String,
        /// The cosine's variable.
        cosine: String,
        /// The angle.
        angle: View,
    },
    /// A shared term.
    Let(Statement),
    /// A step of an elimination.
    Step(Statement),
}

/// The body of one generated function.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// Symbols that the program reads.
    pub inputs: FxHashSet<Expr>,
    /// Sines, cosines and shared terms, each after what it needs.
    pub lines: Vec<Line>,
    /// The outputs, in order.
    pub outputs: Vec<Statement>,
}

/// An output to be computed: its variable, its symbol in comments, its expression.
#[derive(Clone, Debug)]
pub struct Output {
    /// The variable that is wanted; another if an input has that name.
    pub name: String,
    /// How comments call it: `M12`, `f3`.
    pub label: String,
    /// What is computed.
    pub value: Expr,
    /// The same as comments state it.
    pub stated: Expr,
}

/// Orders, shares and names everything that the outputs need. The symbols of `steps` are no inputs: each is
/// computed after the ones before it, and before what mentions it. Comments state the values that `stated` has for steps;
/// symbols that [`tripos_derive::algebra::sharing`] introduced get names here.
#[must_use]
pub fn program(
    arena: &Arena,
    variables: &Variables,
    steps: &[Definition],
    stated: &[Definition],
    outputs: &[Output],
) -> Program {
    let mut variables = variables.clone();
    let values: Vec<Expr> = outputs.iter().map(|o| o.value).collect();
    let roots: Vec<Expr> = steps.iter().map(|step| step.value).chain(values.iter().copied()).collect();
    let parts = arena.reachable(&roots);
    let uses = use_counts(arena, &parts, &roots);
    let needs = first_needs(arena, &variables, steps, outputs);
    let mut names = Names { allocator: variables.allocator.clone(), circular: FxHashMap::default() };
    let output_names: Vec<String> = outputs.iter().map(|o| names.allocator.unique(&o.name)).collect();
    let mut shared = variables.of.clone();
    let mut lines = Lines::default();
    let mut done: FxHashSet<Expr> = FxHashSet::default();
    let stages = steps.iter().map(|step| (vec![step.value], Some(step))).chain([(values, None)]);
    for (roots, step) in stages {
        for e in arena.reachable(&roots) {
            if !done.insert(e) {
                continue;
            }
            match arena.node(e) {
                Node::Apply(f @ (Function::Sin | Function::Cos), angle) => {
                    let (sine, cosine) = names.circular(arena, *angle);
                    shared.insert(e, if *f == Function::Sin { sine.clone() } else { cosine.clone() });
                    if lines.known.insert(*angle) {
                        let view = lines.resolve(arena, &mut names, operand(arena, *angle, &shared));
                        lines.circular.push((view.clone(), *angle));
                        lines.list.push(Line::Circular { sine, cosine, angle: view });
                    }
                }
                Node::Sum(..) | Node::Product(_) | Node::Apply(..) if uses.get(&e).copied().unwrap_or(0) > 1 => {
                    let name = names.descriptive(arena, &variables, e, &needs);
                    let value = lines.resolve(arena, &mut names, view(arena, e, &shared, BUDGET));
                    let comment = format!("{}; used {} times", variables.spell(&text(arena, e)), uses[&e]);
                    shared.insert(e, name.clone());
                    lines.list.push(Line::Let(Statement { name, value, comment }));
                }
                _ => {}
            }
        }
        let Some(step) = step else { continue };
        if is_shared_symbol(arena, step.symbol) {
            let value = lines.resolve(arena, &mut names, operand(arena, step.value, &shared));
            // What has a name already, a tangent for instance, keeps it.
            if let View::Shared(name) = &value {
                variables.insert(arena, step.symbol, name);
                shared.insert(step.symbol, name.clone());
                continue;
            }
            let held = arena.symbol_name(step.symbol).and_then(|name| identifier(name.trim_start_matches('#'), 24));
            let name = match held {
                Some(word) => names.allocator.unique(&word),
                None => names.descriptive(arena, &variables, step.value, &needs),
            };
            let meaning = variables.spell(&text(arena, step.value));
            let comment = match uses.get(&step.symbol) {
                Some(n) if *n > 1 => format!("{meaning}; used {n} times"),
                _ => meaning,
            };
            variables.insert(arena, step.symbol, &name);
            shared.insert(step.symbol, name.clone());
            lines.list.push(Line::Let(Statement { name, value, comment }));
        } else {
            let name = variables.of[&step.symbol].clone();
            let value = lines.resolve(arena, &mut names, operand(arena, step.value, &shared));
            let symbol = arena.symbol_name(step.symbol).unwrap_or_default();
            let stated = stated.iter().find(|s| s.symbol == step.symbol).map_or(step.value, |s| s.value);
            let comment = format!("{symbol} = {}", text(arena, stated));
            lines.list.push(Line::Step(Statement { name, value, comment }));
        }
    }
    let mut result = Vec::new();
    for (output, name) in outputs.iter().zip(output_names) {
        let value = lines.resolve(arena, &mut names, operand(arena, output.value, &shared));
        let comment = format!("{} = {}", output.label, text(arena, output.stated));
        result.push(Statement { name, value, comment });
    }
    let computed: FxHashSet<Expr> = steps.iter().map(|step| step.symbol).collect();
    let is_input = |e: &Expr| matches!(arena.node(*e), Node::Symbol(_)) && !computed.contains(e);
    let inputs: FxHashSet<Expr> = parts.into_iter().filter(is_input).collect();
    // Sines and cosines of inputs first: that is where a reader looks for them.
    let needs_nothing = |line: &Line| match line {
        Line::Circular { angle, .. } => matches!(angle, View::Shared(name) if variables.of.values().any(|v| v == name)),
        Line::Let(_) | Line::Step(_) => false,
    };
    let (mut first, rest): (Vec<Line>, Vec<Line>) = lines.list.into_iter().partition(needs_nothing);
    first.extend(rest);
    Program { inputs, lines: first, outputs: result }
}

/// Lines under construction, and the tangents among them.
#[derive(Default)]
struct Lines {
    list: Vec<Line>,
    known: FxHashSet<Expr>,
    /// The angles whose sine and cosine are there.
    circular: Vec<(View, Expr)>,
    tangents: Vec<(View, String)>,
}

impl Lines {
    /// Replaces every tangent by its variable, computed before it is first needed.
    fn resolve(&mut self, arena: &Arena, names: &mut Names, mut value: View) -> View {
        replace_tangents(&mut value, &mut |angle| {
            if let Some((_, name)) = self.tangents.iter().find(|(a, _)| a == angle) {
                return View::Shared(name.clone());
            }
            let found = self.circular.iter().find(|(a, _)| a == angle);
            let (_, e) = *found.expect("a tangent is a quotient of a sine and a cosine");
            let (sine, cosine) = names.circular(arena, e);
            let stem = match sine.strip_prefix("sin") {
                Some(rest) => format!("tan{rest}"),
                None => sine.replacen('s', "t", 1),
            };
            let name = names.allocator.unique(&stem);
            let value = View::Fraction(Box::new(View::Shared(sine)), Box::new(View::Shared(cosine)));
            let comment = format!("tan({})", text(arena, e));
            self.list.push(Line::Let(Statement { name: name.clone(), value, comment }));
            self.tangents.push((angle.clone(), name.clone()));
            View::Shared(name)
        });
        value
    }
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

/// For each term, the first step or output that needs it: what it is named after.
fn first_needs(
    arena: &Arena,
    variables: &Variables,
    steps: &[Definition],
    outputs: &[Output],
) -> FxHashMap<Expr, String> {
    let behind: FxHashMap<Expr, Expr> =
        steps.iter().filter(|s| is_shared_symbol(arena, s.symbol)).map(|s| (s.symbol, s.value)).collect();
    let named = steps.iter().filter_map(|step| Some((step.value, variables.of.get(&step.symbol)?)));
    let mut needs: FxHashMap<Expr, String> = FxHashMap::default();
    for (value, name) in named.chain(outputs.iter().map(|o| (o.value, &o.name))) {
        let mut stack = vec![value];
        while let Some(e) = stack.pop() {
            if let std::collections::hash_map::Entry::Vacant(place) = needs.entry(e) {
                place.insert(name.clone());
                stack.extend(arena.operands(e));
                stack.extend(behind.get(&e));
            }
        }
    }
    needs
}

/// Letters and digits of a formula as one word, if that is short enough.
pub(crate) fn identifier(formula: &str, longest: usize) -> Option<String> {
    let spelled = formula.replace('-', "_minus_").replace('+', "_plus_").replace('/', "_by_");
    let words: Vec<&str> =
        spelled.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').filter(|w| !w.is_empty()).collect();
    let word = words.join("_").split('_').filter(|w| !w.is_empty()).collect::<Vec<_>>().join("_").to_lowercase();
    (word.len() <= longest && word.starts_with(|c: char| c.is_ascii_alphabetic())).then_some(word)
}

/// Names given so far.
pub(crate) struct Names {
    pub(crate) allocator: Allocator,
    pub(crate) circular: FxHashMap<Expr, (String, String)>,
}

impl Names {
    /// The variables of an angle's sine and cosine: `s1`, `c1` for q1, `sin_theta`, `cos_theta` for others.
    pub(crate) fn circular(&mut self, arena: &Arena, angle: Expr) -> (String, String) {
        if let Some(known) = self.circular.get(&angle) {
            return known.clone();
        }
        let digits = arena.symbol_name(angle).and_then(|name| name.strip_prefix('q'));
        let digits = digits.filter(|d| !d.is_empty() && d.bytes().all(|b| b.is_ascii_digit()));
        let mut name = |long: &str, short: &str| match (digits, arena.symbol_name(angle)) {
            (Some(digits), _) => self.allocator.unique(&format!("{short}{digits}")),
            (None, Some(symbol)) => self.allocator.unique(&format!("{long}_{}", spelled(symbol))),
            (None, None) => {
                let word = identifier(&text(arena, angle), 24).unwrap_or_else(|| "angle".to_owned());
                self.allocator.unique(&format!("{long}_{word}"))
            }
        };
        let pair = (name("sin", "s"), name("cos", "c"));
        self.circular.insert(angle, pair.clone());
        pair
    }

    /// A name after what the term holds, or after the output that needs it first.
    fn descriptive(
        &mut self,
        arena: &Arena,
        variables: &Variables,
        e: Expr,
        needs: &FxHashMap<Expr, String>,
    ) -> String {
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
            let Some(word) = self.word(arena, variables, *base) else {
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
            return self.allocator.unique(&if scaled { format!("{joined}_scaled") } else { joined });
        }
        if let Some(word) = identifier(&variables.spell(&text(arena, e)), 16) {
            return self.allocator.unique(&word);
        }
        let stem = needs.get(&e).map_or("shared", String::as_str);
        self.allocator.unique(&format!("{stem}_part"))
    }

    fn word(&mut self, arena: &Arena, variables: &Variables, base: Expr) -> Option<String> {
        match arena.node(base) {
            Node::Symbol(_) => variables.of.get(&base).cloned(),
            Node::Apply(Function::Sin, angle) => Some(self.circular(arena, *angle).0),
            Node::Apply(Function::Cos, angle) => Some(self.circular(arena, *angle).1),
            _ => None,
        }
    }
}

fn constant_free(constant: &tripos_derive::algebra::Rational) -> bool {
    constant.is_zero()
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
