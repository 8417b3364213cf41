//! Straight-line program: sines and cosines, shared terms and outputs, each with a name that describes it.

use super::form::is_flat;
use super::names::{Names, Variables, identifier};
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;
use tripos_derive::algebra::form::sharing::is_shared_symbol;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::text::print::text;
use tripos_derive::algebra::text::view::{View, view};
use tripos_derive::algebra::{Arena, Expr, Function, Node};

/// Most nodes of one formula that is written; a larger formula is cut, instead of megabytes of code.
const BUDGET: usize = 2_000_000;

/// Statement `let name = value;` with the equation that it computes.
#[derive(Clone, Debug)]
pub struct Statement {
    /// Name of the variable.
    pub name: String,
    /// Value of the variable, with shared terms replaced by their names.
    pub value: View,
    /// Meaning of the variable, in the language of model files; `None` if the value is clear by itself.
    pub comment: Option<String>,
}

/// One line of a program.
#[derive(Clone, Debug)]
pub enum Line {
    /// Sine and cosine of an angle.
    Circular {
        /// Name of the sine's variable.
        sine: String,
        /// Name of the cosine's variable.
        cosine: String,
        /// Angle in radians, as a formula.
        angle: View,
    },
    /// Shared term.
    Let(Statement),
    /// Step of an elimination.
    Step(Statement),
}

impl Line {
    /// Expression that the line computes; for a sine and a cosine, their angle.
    #[must_use]
    pub fn value(&self) -> &View {
        match self {
            Self::Circular { angle, .. } => angle,
            Self::Let(statement) | Self::Step(statement) => &statement.value,
        }
    }
}

impl Line {
    /// Variables that the line sets.
    fn names_set(&self) -> Vec<&str> {
        match self {
            Self::Circular { sine, cosine, .. } => vec![sine, cosine],
            Self::Let(statement) | Self::Step(statement) => vec![&statement.name],
        }
    }
}

/// Body of one generated function.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// Symbols that the program reads.
    pub inputs: FxHashSet<Expr>,
    /// Sines, cosines and shared terms, each after those that it needs.
    pub lines: Vec<Line>,
    /// Statements of the outputs, in order.
    pub outputs: Vec<Statement>,
}

impl Program {
    /// Equations that the program computes, as formulas: of the steps of an elimination, and of the outputs.
    pub fn equations(&self) -> impl Iterator<Item = &str> {
        let steps = self.lines.iter().filter_map(|line| match line {
            Line::Step(step) => Some(step),
            Line::Circular { .. } | Line::Let(_) => None,
        });
        steps.chain(&self.outputs).filter_map(|statement| statement.comment.as_deref())
    }

    /// Drops lines and inputs that no later line, no output and no result reads. A shared term or a step may be read by
    /// nothing: the formulas in which it stood are written without it.
    fn drop_unread(&mut self, variables: &Variables, results: &[Expr]) {
        let of = |symbol: &Expr| variables.of.get(symbol).map(String::as_str);
        let mut read: FxHashSet<&str> = results.iter().filter_map(of).collect();
        self.outputs.iter().for_each(|output| collect(&output.value, &mut read));
        let mut is_read = vec![true; self.lines.len()];
        for (at, line) in self.lines.iter().enumerate().rev() {
            is_read[at] = line.names_set().iter().any(|name| read.contains(name));
            if is_read[at] {
                collect(line.value(), &mut read);
            }
        }
        self.inputs.retain(|symbol| of(symbol).is_none_or(|name| read.contains(name)));
        let mut is_read = is_read.into_iter();
        self.lines.retain(|_| is_read.next().unwrap_or(true));
    }

    /// Variables that lines and outputs of a range read. Lines count first, then outputs.
    #[must_use]
    pub fn names_read(&self, range: Range<usize>) -> FxHashSet<&str> {
        let mut names = FxHashSet::default();
        let values = self.lines.iter().map(Line::value).chain(self.outputs.iter().map(|output| &output.value));
        values.skip(range.start).take(range.len()).for_each(|value| collect(value, &mut names));
        names
    }

    /// Variables that lines and outputs of a range set, in order. Lines count first, then outputs.
    #[must_use]
    pub fn names_set(&self, range: Range<usize>) -> Vec<&str> {
        let of_outputs = self.outputs.iter().map(|output| vec![output.name.as_str()]);
        self.lines.iter().map(Line::names_set).chain(of_outputs).skip(range.start).take(range.len()).flatten().collect()
    }
}

/// Collects the variables in a value.
fn collect<'v>(view: &'v View, names: &mut FxHashSet<&'v str>) {
    match view {
        View::Shared(name) => {
            names.insert(name);
        }
        View::Sum(terms) => terms.iter().for_each(|(_, term)| collect(term, names)),
        View::Product(factors) => factors.iter().for_each(|factor| collect(factor, names)),
        View::Fraction(above, below) => {
            collect(above, names);
            collect(below, names);
        }
        View::Power(inner, _) | View::Call(_, inner) | View::Root(inner) => collect(inner, names),
        View::Number(_) | View::Name(_) | View::Word(_) | View::Pi | View::Cut => {}
    }
}

/// Output to be computed: its variable, its symbol in comments, its expression.
#[derive(Clone, Debug)]
pub struct Output {
    /// Wanted name of the variable; another name is used if it is taken.
    pub name: String,
    /// Label of the output in comments: `M12`, `f3`.
    pub label: String,
    /// Expression to be computed.
    pub value: Expr,
    /// Value as comments state it, before terms were shared.
    pub stated: Expr,
}

/// Orders, shares and names all terms that the outputs need. The symbols of `steps` are no inputs: each is computed
/// after the steps before it, and before the terms that contain it. Comments show the values that `stated` has for
/// steps. Symbols that [`tripos_derive::algebra::form::sharing`] introduced get names here. Symbols in `results` are
/// returned as they are, and so their steps are kept.
#[must_use]
pub fn program(
    arena: &Arena,
    variables: &Variables,
    steps: &[Definition],
    stated: &[Definition],
    outputs: &[Output],
    results: &[Expr],
) -> Program {
    let values: Vec<Expr> = outputs.iter().map(|o| o.value).collect();
    let roots: Vec<Expr> = steps.iter().map(|step| step.value).chain(values.iter().copied()).collect();
    let parts = arena.reachable(&roots);
    let mut names = Names::new(variables.allocator.clone());
    let output_names: Vec<String> = outputs.iter().map(|o| names.allocator.unique(&o.name)).collect();
    let mut builder = Builder {
        arena,
        uses: use_counts(arena, &parts, &roots),
        needs: first_needs(arena, variables, steps, outputs),
        names,
        shared: variables.of.clone(),
        variables: variables.clone(),
        lines: Vec::new(),
        done: FxHashSet::default(),
        circular: Vec::new(),
        tangents: Vec::new(),
    };
    for &step in steps {
        builder.terms(&[step.value]);
        if is_shared_symbol(arena, step.symbol) {
            builder.shared_step(step);
        } else {
            builder.step(step, stated);
        }
    }
    builder.terms(&values);
    let outputs: Vec<_> = outputs.iter().zip(output_names).map(|(output, name)| builder.output(output, name)).collect();
    let computed: FxHashSet<Expr> = steps.iter().map(|step| step.symbol).collect();
    let is_input = |e: &Expr| matches!(arena.node(*e), Node::Symbol(_)) && !computed.contains(e);
    let mut program =
        Program { inputs: parts.into_iter().filter(is_input).collect(), lines: builder.ordered(), outputs };
    program.drop_unread(variables, results);
    program
}

/// Builder of a program.
struct Builder<'a> {
    arena: &'a Arena,
    uses: FxHashMap<Expr, usize>,
    /// Name of the first step or output that needs each term. It is the stem of a term's name if the term has no better
    /// one.
    needs: FxHashMap<Expr, String>,
    names: Names,
    /// Variables of symbols, steps included.
    variables: Variables,
    /// Names of the variables of all terms that have one.
    shared: FxHashMap<Expr, String>,
    lines: Vec<Line>,
    /// Terms that were already handled.
    done: FxHashSet<Expr>,
    /// Angles whose sine and cosine are computed, as formula and as term.
    circular: Vec<(View, Expr)>,
    /// Tangents that are computed: angle and name of the variable.
    tangents: Vec<(View, String)>,
}

impl Builder<'_> {
    /// Adds lines for the sines, cosines and shared terms in these terms.
    fn terms(&mut self, roots: &[Expr]) {
        for e in self.arena.reachable(roots) {
            if !self.done.insert(e) {
                continue;
            }
            match self.arena.node(e) {
                Node::Apply(f @ (Function::Sin | Function::Cos), angle) => self.circle(e, *f, *angle),
                Node::Sum(..) | Node::Product(_) | Node::Apply(..) if self.uses.get(&e).is_some_and(|n| *n > 1) => {
                    self.share(e);
                }
                _ => {}
            }
        }
    }

    /// Adds a line for the sine and the cosine of an angle, unless there is one.
    fn circle(&mut self, e: Expr, f: Function, angle: Expr) {
        let (sine, cosine) = self.names.circular(self.arena, angle);
        self.shared.insert(e, if f == Function::Sin { sine.clone() } else { cosine.clone() });
        if self.circular.iter().any(|(_, known)| *known == angle) {
            return;
        }
        let view = self.operand(angle);
        let view = self.resolve(view);
        self.circular.push((view.clone(), angle));
        self.lines.push(Line::Circular { sine, cosine, angle: view });
    }

    /// Adds a line for a term that is used more than once.
    fn share(&mut self, e: Expr) {
        let name = self.descriptive(e);
        let value = self.resolve(view(self.arena, e, &self.shared, BUDGET));
        let comment = self.meaning(e, &value);
        self.shared.insert(e, name.clone());
        self.lines.push(Line::Let(Statement { name, value, comment }));
    }

    /// Adds a step that sharing introduced. A term that already has a name, such as a tangent, keeps it.
    fn shared_step(&mut self, step: Definition) {
        let value = self.operand(step.value);
        let value = self.resolve(value);
        if let View::Shared(name) = &value {
            let name = name.clone();
            self.name(step.symbol, &name);
            return;
        }
        let held = self.arena.symbol_name(step.symbol).and_then(|name| identifier(name.trim_start_matches('#'), 24));
        let name = match held {
            Some(word) => self.names.allocator.unique(&word),
            None => self.descriptive(step.value),
        };
        let comment = self.meaning(step.value, &value);
        self.variables.behind.insert(step.symbol, step.value);
        self.name(step.symbol, &name);
        self.lines.push(Line::Let(Statement { name, value, comment }));
    }

    /// Adds a step of an elimination, whose variable is named after its symbol.
    fn step(&mut self, step: Definition, stated: &[Definition]) {
        let name = self.variables.of[&step.symbol].clone();
        let value = self.operand(step.value);
        let value = self.resolve(value);
        let symbol = self.arena.symbol_name(step.symbol).unwrap_or_default();
        let stated = stated.iter().find(|s| s.symbol == step.symbol).map_or(step.value, |s| s.value);
        let comment = Some(self.equation(symbol, stated));
        self.lines.push(Line::Step(Statement { name, value, comment }));
    }

    fn output(&mut self, output: &Output, name: String) -> Statement {
        let value = self.operand(output.value);
        let value = self.resolve(value);
        Statement { name, value, comment: Some(self.equation(&output.label, output.stated)) }
    }

    /// Comment `name = formula`; the name alone if the value is this symbol.
    fn equation(&self, name: &str, value: Expr) -> String {
        let stays = self.arena.symbol_name(value) == Some(name);
        if stays { name.to_owned() } else { format!("{name} = {}", text(self.arena, value)) }
    }

    /// Free name after the formula of a term, or after the first step or output that needs it.
    fn descriptive(&mut self, e: Expr) -> String {
        let stem = self.needs.get(&e).map_or("shared", String::as_str);
        self.names.descriptive(self.arena, &self.variables, e, stem)
    }

    /// Formula of a shared term, for a comment; `None` if its value contains no sum, because such a value reads well in
    /// any language.
    fn meaning(&self, e: Expr, value: &View) -> Option<String> {
        (!is_flat(value)).then(|| self.variables.spell(&text(self.arena, e)))
    }

    /// Adds the variable of a symbol that sharing introduced.
    fn name(&mut self, symbol: Expr, name: &str) {
        self.variables.insert(self.arena, symbol, name);
        self.shared.insert(symbol, name.to_owned());
    }

    /// View of a term inside others: its variable, if it has one.
    fn operand(&self, e: Expr) -> View {
        match self.shared.get(&e) {
            Some(name) => View::Shared(name.clone()),
            None => view(self.arena, e, &self.shared, BUDGET),
        }
    }

    /// Replaces every tangent by its variable, which is computed before.
    fn resolve(&mut self, mut value: View) -> View {
        replace_tangents(&mut value, &mut |angle| self.tangent(angle));
        value
    }

    fn tangent(&mut self, angle: &View) -> View {
        if let Some((_, name)) = self.tangents.iter().find(|(a, _)| a == angle) {
            return View::Shared(name.clone());
        }
        let found = self.circular.iter().find(|(a, _)| a == angle);
        let (_, e) = *found.expect("a tangent is a quotient of a sine and a cosine");
        let (sine, cosine) = self.names.circular(self.arena, e);
        let stem = match sine.strip_prefix("sin") {
            Some(rest) => format!("tan{rest}"),
            None => sine.replacen('s', "t", 1),
        };
        let name = self.names.allocator.unique(&stem);
        let value = View::Fraction(Box::new(View::Shared(sine)), Box::new(View::Shared(cosine)));
        self.lines.push(Line::Let(Statement { name: name.clone(), value, comment: None }));
        self.tangents.push((angle.clone(), name.clone()));
        View::Shared(name)
    }

    /// Lines of the program. Sines and cosines of inputs come first, where a reader looks for them.
    fn ordered(self) -> Vec<Line> {
        let set: FxHashSet<String> = self.lines.iter().flat_map(Line::names_set).map(str::to_owned).collect();
        let needs_nothing = |line: &Line| match line {
            Line::Circular { angle: View::Shared(name), .. } => !set.contains(name),
            Line::Circular { .. } | Line::Let(_) | Line::Step(_) => false,
        };
        let (mut first, rest): (Vec<Line>, Vec<Line>) = self.lines.into_iter().partition(needs_nothing);
        first.extend(rest);
        first
    }
}

/// Numbers of uses of each term, as an operand or as an output.
fn use_counts(arena: &Arena, parts: &[Expr], roots: &[Expr]) -> FxHashMap<Expr, usize> {
    let mut uses: FxHashMap<Expr, usize> = FxHashMap::default();
    for operand in parts.iter().flat_map(|part| arena.operands(*part)).chain(roots.iter().copied()) {
        *uses.entry(operand).or_default() += 1;
    }
    uses
}

/// Name of the first step or output that needs each term.
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
        View::Number(_) | View::Name(_) | View::Word(_) | View::Shared(_) | View::Pi | View::Cut => {}
    }
}
