//! Straight-line program of one function: sines and cosines, shared terms and outputs, each with a
//! descriptive name.

use super::variable_names::{SymbolVariableNames, TermVariableNames, variable_word_of_formula};
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;
use tripos_derive::algebra::form::sharing::is_shared_symbol;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::text::display_tree::{DisplayTree, display_tree, is_sum_free_formula};
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::{Arena, Expr, Function, Node};

/// Largest number of nodes in a formula that is written. A larger formula is cut, because its code would take
/// megabytes.
const BUDGET: usize = 2_000_000;

/// Statement `let name = value;`, with the formula of its value as a comment.
#[derive(Clone, Debug)]
pub struct Statement {
    /// Name of the variable that the statement sets.
    pub name: String,
    /// Value of the variable, with shared terms replaced by their names.
    pub value: DisplayTree,
    /// Formula of the value in the notation of model files; `None` if the value reads well by
    /// itself.
    pub comment: Option<String>,
}

/// Line of a program: a sine with its cosine, a shared term, or an elimination step.
#[derive(Clone, Debug)]
pub enum ProgramLine {
    /// Sine and cosine of one angle, computed together.
    Circular {
        /// Name of the variable for the sine.
        sine: String,
        /// Name of the variable for the cosine.
        cosine: String,
        /// Formula of the angle, rad.
        angle: DisplayTree,
    },
    /// Definition of a term that is used more than once.
    Let(Statement),
    /// Intermediate term with a symbol of its own, such as a step of an elimination.
    Step(Statement),
}

impl ProgramLine {
    /// Returns the formula that the line computes. For a sine and a cosine, it is the formula of their angle.
    #[must_use]
    pub fn value(&self) -> &DisplayTree {
        match self {
            Self::Circular { angle, .. } => angle,
            Self::Let(statement) | Self::Step(statement) => &statement.value,
        }
    }
}

impl ProgramLine {
    /// Returns the names of the variables that the line sets.
    fn names_set(&self) -> Vec<&str> {
        match self {
            Self::Circular { sine, cosine, .. } => vec![sine, cosine],
            Self::Let(statement) | Self::Step(statement) => vec![&statement.name],
        }
    }
}

/// Body of one generated function: lines in the order of computation, then outputs.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// Symbols that the program reads, such as parameters and coordinates.
    pub inputs: FxHashSet<Expr>,
    /// Lines for sines, cosines, shared terms and elimination steps, each after the lines that it
    /// needs.
    pub lines: Vec<ProgramLine>,
    /// Statements that compute the outputs, in order.
    pub outputs: Vec<Statement>,
}

impl Program {
    /// Returns the equations `name = formula` of the elimination steps, then of the outputs.
    pub fn equations(&self) -> impl Iterator<Item = &str> {
        let steps = self.lines.iter().filter_map(|line| match line {
            ProgramLine::Step(step) => Some(step),
            ProgramLine::Circular { .. } | ProgramLine::Let(_) => None,
        });
        steps.chain(&self.outputs).filter_map(|statement| statement.comment.as_deref())
    }

    /// Removes lines and inputs that are not read: no later line, output or result contains them. A line can be
    /// unread because a formula that contained its term was written without it.
    fn drop_unread(&mut self, variables: &SymbolVariableNames, results: &[Expr]) {
        let of = |symbol: &Expr| variables.of.get(symbol).map(String::as_str);
        let mut read: FxHashSet<&str> = results.iter().filter_map(of).collect();
        self.outputs.iter().for_each(|output| collect_variable_names(&output.value, &mut read));
        let mut is_read = vec![true; self.lines.len()];
        for (at, line) in self.lines.iter().enumerate().rev() {
            is_read[at] = line.names_set().iter().any(|name| read.contains(name));
            if is_read[at] {
                collect_variable_names(line.value(), &mut read);
            }
        }
        self.inputs.retain(|symbol| of(symbol).is_none_or(|name| read.contains(name)));
        let mut is_read = is_read.into_iter();
        self.lines.retain(|_| is_read.next().unwrap_or(true));
    }

    /// Returns the names of the variables that a range of the program reads. Indices count lines
    /// first, then outputs.
    #[must_use]
    pub fn names_read(&self, range: Range<usize>) -> FxHashSet<&str> {
        let mut names = FxHashSet::default();
        let values = self.lines.iter().map(ProgramLine::value).chain(self.outputs.iter().map(|output| &output.value));
        values.skip(range.start).take(range.len()).for_each(|value| collect_variable_names(value, &mut names));
        names
    }

    /// Returns the names of the variables that a range of the program sets, in order. Indices count
    /// lines first, then outputs.
    #[must_use]
    pub fn names_set(&self, range: Range<usize>) -> Vec<&str> {
        let of_outputs = self.outputs.iter().map(|output| vec![output.name.as_str()]);
        self.lines
            .iter()
            .map(ProgramLine::names_set)
            .chain(of_outputs)
            .skip(range.start)
            .take(range.len())
            .flatten()
            .collect()
    }
}

/// Adds the names of the variables in a formula to the set `names`.
fn collect_variable_names<'v>(view: &'v DisplayTree, names: &mut FxHashSet<&'v str>) {
    match view {
        DisplayTree::Shared(name) => {
            names.insert(name);
        }
        DisplayTree::Sum(terms) => terms.iter().for_each(|(_, term)| collect_variable_names(term, names)),
        DisplayTree::Product(factors) => factors.iter().for_each(|factor| collect_variable_names(factor, names)),
        DisplayTree::Fraction(above, below) => {
            collect_variable_names(above, names);
            collect_variable_names(below, names);
        }
        DisplayTree::Power(inner, _) | DisplayTree::Call(_, inner) | DisplayTree::Root(inner) => {
            collect_variable_names(inner, names);
        }
        DisplayTree::Number(_) | DisplayTree::Name(_) | DisplayTree::Word(_) | DisplayTree::Pi | DisplayTree::Cut => {}
    }
}

/// Output of a function to be computed: its variable, its label in comments, and its term.
#[derive(Clone, Debug)]
pub struct Output {
    /// Wanted name of the variable. If it is in use, a number is appended.
    pub name: String,
    /// Label of the output in comments, such as `M12` or `f3`.
    pub label: String,
    /// Term that is computed as the output.
    pub value: Expr,
    /// Term as comments show it, before common operations were shared.
    pub stated: Expr,
}

/// Builds the program that computes the outputs: orders, shares and names all terms.
///
/// The symbols of `steps` are no inputs. Each step is computed after the steps before it, and
/// before the terms that contain it. Comments show the values that `stated` has for steps. Symbols
/// that [`tripos_derive::algebra::form::sharing`] introduced get names here. Steps whose symbols
/// are in `results` are kept, because the function returns them unchanged.
#[must_use]
pub fn program(
    arena: &Arena,
    variables: &SymbolVariableNames,
    steps: &[Definition],
    stated: &[Definition],
    outputs: &[Output],
    results: &[Expr],
) -> Program {
    let values: Vec<Expr> = outputs.iter().map(|o| o.value).collect();
    let roots: Vec<Expr> = steps.iter().map(|step| step.value).chain(values.iter().copied()).collect();
    let parts = arena.reachable(&roots);
    let mut names = TermVariableNames::new(variables.allocator.clone());
    let output_names: Vec<String> = outputs.iter().map(|o| names.allocator.unique(&o.name)).collect();
    let mut builder = ProgramBuilder {
        arena,
        uses: program_use_counts(arena, &parts, &roots),
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
        builder.add_term_lines(&[step.value]);
        if is_shared_symbol(arena, step.symbol) {
            builder.add_shared_definition(step);
        } else {
            builder.add_elimination_step(step, stated);
        }
    }
    builder.add_term_lines(&values);
    let outputs: Vec<_> =
        outputs.iter().zip(output_names).map(|(output, name)| builder.output_statement(output, name)).collect();
    let computed: FxHashSet<Expr> = steps.iter().map(|step| step.symbol).collect();
    let is_input = |e: &Expr| matches!(arena.node(*e), Node::Symbol(_)) && !computed.contains(e);
    let mut program = Program {
        inputs: parts.into_iter().filter(is_input).collect(),
        lines: builder.lines_in_reading_order(),
        outputs,
    };
    program.drop_unread(variables, results);
    program
}

/// Builder of a program. It collects lines, and names each term that gets a variable.
struct ProgramBuilder<'a> {
    /// Arena that stores the terms (symbolic expressions).
    arena: &'a Arena,
    /// Number of uses of each term, in other terms or as an output.
    uses: FxHashMap<Expr, usize>,
    /// Name of the first step or output that contains each term. It is the stem of the term's name
    /// if the term has no better name.
    needs: FxHashMap<Expr, String>,
    /// Names of the program's intermediate terms.
    names: TermVariableNames,
    /// Variables of all symbols, including the symbols of steps.
    variables: SymbolVariableNames,
    /// Names of the variables of all terms that have a variable.
    shared: FxHashMap<Expr, String>,
    /// Lines of the program built so far.
    lines: Vec<ProgramLine>,
    /// Terms whose lines are already in the program.
    done: FxHashSet<Expr>,
    /// Angles whose sine and cosine are computed, as formula and as term.
    circular: Vec<(DisplayTree, Expr)>,
    /// Tangents that are computed, each as its angle and the name of its variable.
    tangents: Vec<(DisplayTree, String)>,
}

impl ProgramBuilder<'_> {
    /// Adds lines for the sines, cosines and repeated terms that the terms `roots` contain.
    fn add_term_lines(&mut self, roots: &[Expr]) {
        for e in self.arena.reachable(roots) {
            if !self.done.insert(e) {
                continue;
            }
            match self.arena.node(e) {
                Node::Apply(f @ (Function::Sin | Function::Cos), angle) => self.add_sine_and_cosine(e, *f, *angle),
                Node::Sum(..) | Node::Product(_) | Node::Apply(..) if self.uses.get(&e).is_some_and(|n| *n > 1) => {
                    self.add_shared_line(e);
                }
                _ => {}
            }
        }
    }

    /// Adds a line for the sine and cosine of an angle, unless there is already such a line. `e` is
    /// the term of one of them.
    fn add_sine_and_cosine(&mut self, e: Expr, f: Function, angle: Expr) {
        let (sine, cosine) = self.names.sine_and_cosine_names(self.arena, angle);
        self.shared.insert(e, if f == Function::Sin { sine.clone() } else { cosine.clone() });
        if self.circular.iter().any(|(_, known)| *known == angle) {
            return;
        }
        let view = self.term_in_formula(angle);
        let view = self.replace_tangents_by_variables(view);
        self.circular.push((view.clone(), angle));
        self.lines.push(ProgramLine::Circular { sine, cosine, angle: view });
    }

    /// Adds a line for a term that is used more than once, with a descriptive name.
    fn add_shared_line(&mut self, e: Expr) {
        let name = self.descriptive(e);
        let value = self.replace_tangents_by_variables(display_tree(self.arena, e, &self.shared, BUDGET));
        let comment = self.shared_term_comment(e, &value);
        self.shared.insert(e, name.clone());
        self.lines.push(ProgramLine::Let(Statement { name, value, comment }));
    }

    /// Adds a line for the symbol of a shared operation. If its value already has a variable, such
    /// as a tangent, the symbol gets this variable and no line.
    fn add_shared_definition(&mut self, step: Definition) {
        let value = self.term_in_formula(step.value);
        let value = self.replace_tangents_by_variables(value);
        if let DisplayTree::Shared(name) = &value {
            let name = name.clone();
            self.record_variable(step.symbol, &name);
            return;
        }
        let held = self
            .arena
            .symbol_name(step.symbol)
            .and_then(|name| variable_word_of_formula(name.trim_start_matches('#'), 24));
        let name = match held {
            Some(word) => self.names.allocator.unique(&word),
            None => self.descriptive(step.value),
        };
        let comment = self.shared_term_comment(step.value, &value);
        self.variables.behind.insert(step.symbol, step.value);
        self.record_variable(step.symbol, &name);
        self.lines.push(ProgramLine::Let(Statement { name, value, comment }));
    }

    /// Adds a line for an elimination step. Its variable is named after its symbol.
    fn add_elimination_step(&mut self, step: Definition, stated: &[Definition]) {
        let name = self.variables.of[&step.symbol].clone();
        let value = self.term_in_formula(step.value);
        let value = self.replace_tangents_by_variables(value);
        let symbol = self.arena.symbol_name(step.symbol).unwrap_or_default();
        let stated = stated.iter().find(|s| s.symbol == step.symbol).map_or(step.value, |s| s.value);
        let comment = Some(self.equation(symbol, stated));
        self.lines.push(ProgramLine::Step(Statement { name, value, comment }));
    }

    /// Returns the statement that computes an output, with the output's equation as a comment.
    fn output_statement(&mut self, output: &Output, name: String) -> Statement {
        let value = self.term_in_formula(output.value);
        let value = self.replace_tangents_by_variables(value);
        Statement { name, value, comment: Some(self.equation(&output.label, output.stated)) }
    }

    /// Returns the comment `name = formula`. It is only the name if the value is the symbol with this name.
    fn equation(&self, name: &str, value: Expr) -> String {
        let stays = self.arena.symbol_name(value) == Some(name);
        if stays { name.to_owned() } else { format!("{name} = {}", print_text(self.arena, value)) }
    }

    /// Returns a free name that describes a term by its formula, or by the first step or output
    /// that needs it.
    fn descriptive(&mut self, e: Expr) -> String {
        let stem = self.needs.get(&e).map_or("shared", String::as_str);
        self.names.take_descriptive_name(self.arena, &self.variables, e, stem)
    }

    /// Returns the formula of a shared term for a comment. `None` if its value contains no sum, because such a value
    /// reads well in any language.
    fn shared_term_comment(&self, e: Expr, value: &DisplayTree) -> Option<String> {
        (!is_sum_free_formula(value)).then(|| self.variables.write_shared_names(&print_text(self.arena, e)))
    }

    /// Records that the variable `name` of the generated code holds the value of the symbol `symbol`.
    fn record_variable(&mut self, symbol: Expr, name: &str) {
        self.variables.insert(self.arena, symbol, name);
        self.shared.insert(symbol, name.to_owned());
    }

    /// Returns a term as it appears in a larger formula: its variable if it has one, otherwise its formula.
    fn term_in_formula(&self, e: Expr) -> DisplayTree {
        match self.shared.get(&e) {
            Some(name) => DisplayTree::Shared(name.clone()),
            None => display_tree(self.arena, e, &self.shared, BUDGET),
        }
    }

    /// Replaces every tangent in a formula by its variable. Adds the lines that compute these
    /// variables.
    fn replace_tangents_by_variables(&mut self, mut value: DisplayTree) -> DisplayTree {
        replace_tangents(&mut value, &mut |angle| self.tangent(angle));
        value
    }

    /// Returns the variable of the tangent of an angle, computed as sine over cosine. Adds its line
    /// if there is none.
    fn tangent(&mut self, angle: &DisplayTree) -> DisplayTree {
        if let Some((_, name)) = self.tangents.iter().find(|(a, _)| a == angle) {
            return DisplayTree::Shared(name.clone());
        }
        let found = self.circular.iter().find(|(a, _)| a == angle);
        let (_, e) = *found.expect("a tangent is a quotient of a sine and a cosine");
        let (sine, cosine) = self.names.sine_and_cosine_names(self.arena, e);
        let stem = match sine.strip_prefix("sin") {
            Some(rest) => format!("tan{rest}"),
            None => sine.replacen('s', "t", 1),
        };
        let name = self.names.allocator.unique(&stem);
        let value = DisplayTree::Fraction(Box::new(DisplayTree::Shared(sine)), Box::new(DisplayTree::Shared(cosine)));
        self.lines.push(ProgramLine::Let(Statement { name: name.clone(), value, comment: None }));
        self.tangents.push((angle.clone(), name.clone()));
        DisplayTree::Shared(name)
    }

    /// Returns the lines of the program in reading order: sines and cosines of input angles are moved to the front.
    fn lines_in_reading_order(self) -> Vec<ProgramLine> {
        let set: FxHashSet<String> = self.lines.iter().flat_map(ProgramLine::names_set).map(str::to_owned).collect();
        let needs_nothing = |line: &ProgramLine| match line {
            ProgramLine::Circular { angle: DisplayTree::Shared(name), .. } => !set.contains(name),
            ProgramLine::Circular { .. } | ProgramLine::Let(_) | ProgramLine::Step(_) => false,
        };
        let (mut first, rest): (Vec<ProgramLine>, Vec<ProgramLine>) = self.lines.into_iter().partition(needs_nothing);
        first.extend(rest);
        first
    }
}

/// Returns the number of uses of each term, as an operand of another term or as an output.
fn program_use_counts(arena: &Arena, parts: &[Expr], roots: &[Expr]) -> FxHashMap<Expr, usize> {
    let mut uses: FxHashMap<Expr, usize> = FxHashMap::default();
    for operand in parts.iter().flat_map(|part| arena.operands(*part)).chain(roots.iter().copied()) {
        *uses.entry(operand).or_default() += 1;
    }
    uses
}

/// Finds, for each term, the name of the first step or output that contains it.
fn first_needs(
    arena: &Arena,
    variables: &SymbolVariableNames,
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

/// Replaces every tangent in a formula by the value of `name` for its angle.
fn replace_tangents(view: &mut DisplayTree, name: &mut impl FnMut(&DisplayTree) -> DisplayTree) {
    match view {
        DisplayTree::Call("tan", angle) => *view = name(angle),
        DisplayTree::Call(_, inner) | DisplayTree::Root(inner) | DisplayTree::Power(inner, _) => {
            replace_tangents(inner, name);
        }
        DisplayTree::Sum(terms) => terms.iter_mut().for_each(|(_, term)| replace_tangents(term, name)),
        DisplayTree::Product(factors) => factors.iter_mut().for_each(|factor| replace_tangents(factor, name)),
        DisplayTree::Fraction(above, below) => {
            replace_tangents(above, name);
            replace_tangents(below, name);
        }
        DisplayTree::Number(_)
        | DisplayTree::Name(_)
        | DisplayTree::Word(_)
        | DisplayTree::Shared(_)
        | DisplayTree::Pi
        | DisplayTree::Cut => {}
    }
}
