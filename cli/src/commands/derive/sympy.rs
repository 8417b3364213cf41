//! Derivation as a Python program that defines the equations for SymPy.
//!
//! Invariants:
//! - Numbers are exact, and nothing is expanded: a named term stays a symbol with a definition. Each definition comes
//!   after the definitions of the terms in it.
//! - The program runs for any names in a model. A name that Python or the program itself uses gets an underscore at its
//!   end.
//!
//! All symbols, including coordinates and rates, are plain SymPy symbols. Each can be replaced, can be differentiated
//! by, and can be an argument of compiled functions.

use super::SolvedFormulation;
use crate::terminal::failure::Failure;
use rustc_hash::{FxHashMap, FxHashSet};
use std::fmt::Write;
use tripos_derive::Model;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::text::display_tree::{DisplayTree, SharedNames};
use tripos_derive::algebra::text::print::{print_whole_view, sympy_of};
use tripos_derive::algebra::{Arena, Expr};

/// Words that cannot name variables in the Python program: Python's reserved words, and names that
/// the program uses.
const RESERVED_PYTHON_WORDS: [&str; 42] = [
    "False",
    "None",
    "True",
    "and",
    "as",
    "assert",
    "async",
    "await",
    "break",
    "class",
    "continue",
    "def",
    "del",
    "elif",
    "else",
    "except",
    "finally",
    "for",
    "from",
    "global",
    "if",
    "import",
    "in",
    "is",
    "lambda",
    "nonlocal",
    "not",
    "or",
    "pass",
    "raise",
    "return",
    "try",
    "while",
    "with",
    "yield",
    "sp",
    "SimpleNamespace",
    "evaluated",
    "dict",
    "kane",
    "lagrange",
    "newton_euler",
];

/// Text of the Python function `evaluated`, the last part of the program.
const EVALUATION_FUNCTION: &str = r#"

def evaluated(formulation, values):
    """Values of all symbols: the inputs, named terms, accelerations, and named terms that contain accelerations."""
    values = dict(values)
    for symbol, value in formulation.named + formulation.accelerations + formulation.named:
        values[symbol] = sp.sympify(value).xreplace(values)
    return values
"#;

/// Writes the Python program that defines the equations of each formulation for SymPy.
///
/// # Errors
/// [`Failure::Refused`] if a formula is too long to be written out.
pub fn sympy(model: &Model, derived: &[SolvedFormulation]) -> Result<String, Failure> {
    let names = Names::new(model, derived);
    let mut out = format!("# {}: equations of motion, matrix * unknowns = forcing.\n", model.title);
    out += "# Of rates q1' is q1_dot, of q1'' q1_ddot. Terms that stand by a name are in `named`, each after those that it mentions.\n";
    out += "from types import SimpleNamespace\n\nimport sympy as sp\n";
    names.declare_sympy_symbols(&mut out);
    for derived in derived {
        write_sympy_formulation(&mut out, model, derived, &names)?;
    }
    Ok(out + EVALUATION_FUNCTION)
}

/// Names of the model's symbols in the Python program.
struct Names {
    /// Pairs of the name in the model file and the name in the program, in the order of
    /// declaration.
    list: Vec<(String, String)>,
    /// Index in `list`; the key is the name in the model file.
    by_name: FxHashMap<String, usize>,
    /// Names in the model file of the parameters that are declared as positive.
    positive: FxHashSet<String>,
}

impl Names {
    /// Names all symbols that the derived equations contain.
    fn new(model: &Model, derived: &[SolvedFormulation]) -> Self {
        let positive = model.parameters.iter().filter(|p| p.positive).map(|p| p.name.clone()).collect();
        let mut names = Self { list: Vec::new(), by_name: FxHashMap::default(), positive };
        // Names without primes get their names first: `q1_dot` may be the name of a parameter.
        let mut all: Vec<String> = model.parameters.iter().map(|p| p.name.clone()).collect();
        all.extend(model.coordinates.iter().map(|c| c.name.clone()));
        all.extend(model.speeds.iter().map(|s| s.name.clone()));
        for SolvedFormulation { derivation, solved } in derived {
            let (arena, e) = (&derivation.arena, &derivation.equations);
            let named = e.definitions.iter().chain(solved.iter().flat_map(|solved| &solved.steps));
            let named: Vec<Expr> = named.flat_map(|step| [step.symbol, step.value]).collect();
            let scalars = [e.kinetic_energy, e.potential_energy, e.power];
            let lists = [&e.unknowns, &e.forcing, &e.coordinates, &e.coordinate_rates, &e.divisors, &named];
            let shown: Vec<Expr> =
                lists.into_iter().flatten().chain(e.matrix.iter().flatten()).chain(&scalars).copied().collect();
            let symbols = arena.reachable(&shown).into_iter();
            all.extend(symbols.filter_map(|e| arena.symbol_name(e).map(str::to_owned)));
        }
        let is_primed = |name: &String| name.ends_with('\'');
        let (primed, plain): (Vec<_>, Vec<_>) = all.into_iter().partition(is_primed);
        let mut taken: FxHashSet<String> = RESERVED_PYTHON_WORDS.iter().map(|word| (*word).to_owned()).collect();
        for name in plain.into_iter().chain(primed) {
            names.add_sympy_name(name, &mut taken);
        }
        names
    }

    /// Adds the symbol with this name, unless it already has a name in the program. `taken` are the names in use.
    fn add_sympy_name(&mut self, name: String, taken: &mut FxHashSet<String>) {
        if self.by_name.contains_key(&name) {
            return;
        }
        let stem = name.trim_end_matches('\'');
        let mut variable: String =
            stem.chars().map(|c| if c.is_ascii_alphanumeric() || c == '_' { c } else { '_' }).collect();
        variable += match name.len() - stem.len() {
            0 => "",
            1 => "_dot",
            _ => "_ddot",
        };
        while !taken.insert(variable.clone()) {
            variable.push('_');
        }
        self.by_name.insert(name.clone(), self.list.len());
        self.list.push((name, variable));
    }

    /// Returns the name of a symbol in the program. A name without a symbol is returned unchanged.
    fn sympy_name<'a>(&'a self, name: &'a str) -> &'a str {
        self.by_name.get(name).map_or(name, |at| &self.list[*at].1)
    }

    /// Writes the Python lines that declare the symbols, as positive or real.
    fn declare_sympy_symbols(&self, out: &mut String) {
        out.push('\n');
        for (name, variable) in &self.list {
            let kind = if self.positive.contains(name) { "positive" } else { "real" };
            let _ = writeln!(out, "{variable} = sp.Symbol(\"{variable}\", {kind}=True)");
        }
    }
}

/// Writer of the terms of one arena as Python expressions.
struct SympyWriter<'a> {
    /// Arena that stores the terms (symbolic expressions).
    arena: &'a Arena,
    /// Names of the symbols in the Python program.
    names: &'a Names,
    /// Names in the program; the key is the symbol in the arena.
    symbols: SharedNames,
}

/// Writes the Python statements that define one formulation.
///
/// # Errors
/// [`Failure::Refused`] if a formula is too long to be written out.
fn write_sympy_formulation(
    out: &mut String,
    model: &Model,
    derived: &SolvedFormulation,
    names: &Names,
) -> Result<(), Failure> {
    let SolvedFormulation { derivation, solved } = derived;
    let (arena, e) = (&derivation.arena, &derivation.equations);
    let writer = SympyWriter::new(arena, names);
    let this = e.formulation.name().replace('-', "_");
    let _ = writeln!(out, "\n# {}: a row for each of {}.", e.formulation.title(), e.row_names(model).join(", "));
    let _ = writeln!(out, "{this} = SimpleNamespace()");
    let named = writer.definitions(&e.definitions)?;
    let _ = writeln!(out, "{this}.named = [{named}]");
    let _ = writeln!(out, "{this}.unknowns = {}", writer.sympy_column(&e.unknowns)?);
    let rows: Result<Vec<String>, Failure> =
        e.matrix.iter().map(|row| Ok(format!("    [{}],\n", writer.sympy_list(row)?))).collect();
    let rows = rows?.concat();
    let matrix = if rows.is_empty() { "sp.zeros(0, 0)".to_owned() } else { format!("sp.Matrix([\n{rows}])") };
    let _ = writeln!(out, "{this}.mass_matrix = {matrix}");
    let _ = writeln!(out, "{this}.forcing = {}", writer.sympy_column(&e.forcing)?);
    let _ = writeln!(out, "{this}.coordinates = {}", writer.sympy_column(&e.coordinates)?);
    let _ = writeln!(out, "{this}.coordinate_rates = {}", writer.sympy_column(&e.coordinate_rates)?);
    for (name, value) in
        [("kinetic_energy", e.kinetic_energy), ("potential_energy", e.potential_energy), ("power", e.power)]
    {
        let _ = writeln!(out, "{this}.{name} = sp.sympify({})", writer.formula(value)?);
    }
    let _ = writeln!(out, "{this}.singular_where = [{}]", writer.sympy_list(&e.divisors)?);
    let steps = solved.as_ref().map_or(&[][..], |solved| &solved.steps);
    let _ = writeln!(out, "{this}.accelerations = [{}]", writer.definitions(steps)?);
    Ok(())
}

impl<'a> SympyWriter<'a> {
    /// Returns a writer for the terms of an arena.
    fn new(arena: &'a Arena, names: &'a Names) -> Self {
        let symbols = names.list.iter().filter_map(|(name, variable)| {
            let symbol = arena.find_symbol(name)?;
            Some((symbol, variable.clone()))
        });
        Self { arena, names, symbols: symbols.collect() }
    }

    /// Returns a term as a Python expression.
    ///
    /// # Errors
    /// [`Failure::Refused`] if the expression is too long to be written out.
    fn formula(&self, e: Expr) -> Result<String, Failure> {
        let text = match print_whole_view(self.arena, e, &self.symbols) {
            DisplayTree::Name(name) => self.names.sympy_name(&name).to_owned(),
            view => sympy_of(&view),
        };
        if text.contains('…') {
            let what = "the equations are too long to be printed in full".to_owned();
            return Err(Failure::request(
                what,
                "ask for one formulation with --by; `tripos emit` writes any as code".to_owned(),
            ));
        }
        Ok(text)
    }

    /// Returns terms as Python expressions with commas between them.
    /// `Err` if an expression is too long to be written out.
    fn sympy_list(&self, list: &[Expr]) -> Result<String, Failure> {
        let list: Result<Vec<String>, Failure> = list.iter().map(|e| self.formula(*e)).collect();
        Ok(list?.join(", "))
    }

    /// Returns terms as a SymPy column vector.
    /// `Err` if an expression is too long to be written out.
    fn sympy_column(&self, list: &[Expr]) -> Result<String, Failure> {
        Ok(if list.is_empty() {
            "sp.zeros(0, 1)".to_owned()
        } else {
            format!("sp.Matrix([{}])", self.sympy_list(list)?)
        })
    }

    /// Returns definitions as Python pairs of a symbol and its value, one per line.
    /// `Err` if an expression is too long to be written out.
    fn definitions(&self, list: &[Definition]) -> Result<String, Failure> {
        let pair =
            |step: &Definition| Ok(format!("    ({}, {}),\n", self.formula(step.symbol)?, self.formula(step.value)?));
        let lines: Result<Vec<String>, Failure> = list.iter().map(pair).collect();
        let lines = lines?.concat();
        Ok(if lines.is_empty() { lines } else { format!("\n{lines}") })
    }
}
