//! Spellings that a publication uses for the names of a model: spellings from its table `[symbols]`, and the usual
//! LaTeX forms of names.

use super::program_variables::{ProgramVariables, variable_number_of_substitute, variable_substitute};
use crate::algebra::text::notation::{
    LatexSymbol, Notation, SymbolNames, Unknown, ascii_names_of_unicode, is_program_index, read_symbol,
};
use crate::algebra::text::print::latex_name;
use crate::diagnostic::shortened_for_message;
use rustc_hash::FxHashMap;

/// Spellings of names in a publication, with the names that they represent.
#[derive(Default)]
pub struct NameSpellings {
    /// Names by their LaTeX symbols from `[symbols]`. The key is the symbol without dots, with the number of dots.
    latex: FxHashMap<(String, usize), String>,
    /// Names by their program variables from `[symbols]`.
    variables: FxHashMap<String, String>,
    /// Names by their usual LaTeX symbols; several names may share a symbol.
    usual: FxHashMap<String, Vec<String>>,
    /// Names with more than one letter, which LaTeX sets in roman type.
    words: Vec<String>,
}

/// Outcome of adding a spelling from `[symbols]`.
pub enum SpellingOutcome {
    /// The spelling was free and has been added.
    New,
    /// The spelling is already in use for the name given here.
    Taken(String),
    /// The text is not a symbol in any notation.
    NoSymbol,
}

impl NameSpellings {
    /// Adds a name of the model or of the publication file, with its usual LaTeX symbol. Names with
    /// primes are ignored.
    pub fn add_name(&mut self, name: &str) {
        if name.contains('\'') {
            return;
        }
        if let Some(symbol) = read_symbol(&latex_name(name)) {
            let mut spelled = vec![symbol.clone()];
            // The symbol u_{psi} is also written u_{\psi}.
            if symbol.subscript.starts_with('\\') {
                spelled.push(LatexSymbol { subscript: symbol.subscript.replace(['\\', '_'], ""), ..symbol });
            }
            for symbol in spelled {
                let names = self.usual.entry(symbol.without_dots()).or_default();
                if !names.iter().any(|n| n == name) {
                    names.push(name.to_owned());
                }
            }
        }
        if name.len() > 1 {
            self.words.push(name.to_owned());
        }
    }

    /// Adds the spelling `symbol` from `[symbols]` for the name `name`.
    pub fn add_spelling(&mut self, symbol: &str, name: &str) -> SpellingOutcome {
        let variable = program_variable_spelling(symbol);
        // A spelling in the form of a program variable is also a LaTeX symbol, like the names of a model.
        let latex = match ascii_names_of_unicode(symbol).first() {
            Some(name) if is_name(name) => read_symbol(&latex_name(name)),
            Some(name) if !symbol.is_ascii() => read_symbol(&latex_name(name.trim_end_matches('\'')))
                .map(|still| LatexSymbol { dots: name.len() - name.trim_end_matches('\'').len(), ..still }),
            _ => read_symbol(symbol),
        };
        if variable.is_none() && latex.is_none() {
            return SpellingOutcome::NoSymbol;
        }
        if let Some(variable) = variable
            && let Some(other) = self.variables.insert(variable, name.to_owned())
        {
            return SpellingOutcome::Taken(other);
        }
        if let Some(latex) = latex
            && let Some(other) = self.latex.insert((latex.without_dots(), latex.dots), name.to_owned())
        {
            return SpellingOutcome::Taken(other);
        }
        SpellingOutcome::New
    }

    /// Name that `[symbols]` gives to a program variable, which may end in primes. `None` if `[symbols]` does not
    /// contain the variable.
    pub fn variable(&self, text: &str) -> Option<String> {
        if let Some(name) = self.variables.get(text) {
            return Some(name.clone());
        }
        let stem = text.trim_end_matches('\'');
        self.variables.get(stem).map(|name| format!("{name}{}", &text[stem.len()..]))
    }

    /// True if `name`, without its primes, is a name of the model or of the publication file.
    fn has_name(&self, name: &str) -> bool {
        let stem = name.trim_end_matches('\'');
        let of = |symbol: LatexSymbol| {
            self.usual.get(&symbol.without_dots()).is_some_and(|names| names.iter().any(|n| n == stem))
        };
        read_symbol(&latex_name(stem)).is_some_and(of)
    }

    /// Names that a LaTeX symbol may represent: none, one, or several names with the same symbol.
    fn latex_names(&self, symbol: &LatexSymbol) -> Vec<String> {
        let still = symbol.without_dots();
        for own in (0..=symbol.dots).rev() {
            if let Some(name) = self.latex.get(&(still.clone(), own)) {
                return vec![format!("{name}{}", "'".repeat(symbol.dots - own))];
            }
        }
        let names = self.usual.get(&still).map(Vec::as_slice).unwrap_or_default();
        names.iter().map(|name| format!("{name}{}", "'".repeat(symbol.dots))).collect()
    }
}

/// Translator of the symbols in a formula into names.
pub struct NameSpeller<'a> {
    /// Spellings that the publication uses for names.
    pub spellings: &'a NameSpellings,
    /// Variables of the program to which the formula belongs.
    pub locals: &'a ProgramVariables,
    /// Names of the model's coordinates, to recognize variables for their rates.
    pub coordinates: &'a [String],
    /// True if the last error may occur at many places of the file.
    pub repeated: bool,
}

impl SymbolNames for NameSpeller<'_> {
    fn knows(&self, symbol: &LatexSymbol) -> bool {
        !self.spellings.latex_names(symbol).is_empty()
    }

    fn is_coordinate(&self, symbol: &LatexSymbol) -> bool {
        let names = self.spellings.latex_names(symbol);
        names.len() == 1 && self.coordinates.contains(&names[0])
    }

    fn name_of_latex_symbol(&mut self, symbol: &LatexSymbol, run: &str) -> Result<String, Unknown> {
        let mut names = self.spellings.latex_names(symbol);
        if names.len() == 1 {
            return Ok(names.remove(0));
        }
        self.repeated = true;
        let symbol = shortened_for_message(&symbol.to_string());
        if names.len() > 1 {
            let help = format!("say in [symbols] which of {} it is", names.join(", "));
            return Err((format!("`{symbol}` may stand for several names"), Some(help)));
        }
        // The spelling of a coordinate also applies to its time derivatives.
        let stated = toml_key_of_spelling(symbol.trim_end_matches('\''));
        let help = match self.spellings.words.iter().find(|word| *word == run) {
            Some(word) => {
                format!("side by side letters are a product: the name `{word}` is written {}", latex_name(word))
            }
            None => format!("say in [symbols] what it stands for, as in {stated} = \"q1\""),
        };
        Err((format!("unknown symbol `{symbol}`"), Some(help)))
    }

    fn name_of_variable(&mut self, name: &str) -> Result<String, Unknown> {
        if let Some(number) = self.locals.variable_number(name) {
            return Ok(variable_substitute(number));
        }
        // If a vector was assigned as a whole and this assignment was not read, an entry of it has no value.
        let whole = name.find(['(', '[']).and_then(|at| self.locals.variable_number(&name[..at]));
        if let Some(number) = whole.filter(|number| self.locals.unread(*number).is_some()) {
            return Ok(variable_substitute(number));
        }
        if let Some(name) = self.spellings.variable(name) {
            return Ok(name);
        }
        if is_name(name) && variable_number_of_substitute(name).is_none() {
            let is_known = self.spellings.has_name(name);
            let mut rates = rate_spellings(name);
            rates.retain(|(stem, _)| !is_known && self.coordinates.iter().any(|c| c == stem));
            return Ok(match rates[..] {
                [(stem, primes)] => format!("{stem}{}", "'".repeat(primes)),
                _ => name.to_owned(),
            });
        }
        let mut names = ascii_names_of_unicode(name);
        if let Some(at) = names.iter().position(|name| self.spellings.has_name(name)) {
            return Ok(names.swap_remove(at));
        }
        self.repeated = true;
        let help =
            format!("give the meaning of the symbol in [symbols], as in {} = \"u1\"", toml_key_of_spelling(name));
        Err((format!("unknown name `{}`", shortened_for_message(name)), Some(help)))
    }
}

/// Possible meanings of a program variable as a time derivative: base name and order of the derivative. Examples are
/// `theta_dot`, `xddot`, `dq1` and `dx_dt`. The base names need not be coordinates.
fn rate_spellings(name: &str) -> Vec<(&str, usize)> {
    let over = name.strip_prefix('d').and_then(|rest| rest.strip_suffix("_dt").or_else(|| rest.strip_suffix("dt")));
    let twice = name.strip_prefix("d2").and_then(|rest| rest.strip_suffix("_dt2").or_else(|| rest.strip_suffix("dt2")));
    let forms = [
        (name.strip_suffix("_ddot"), 2),
        (name.strip_suffix("ddot"), 2),
        (name.strip_prefix("ddot_"), 2),
        (twice, 2),
        (name.strip_suffix("_dot"), 1),
        (name.strip_suffix("dot"), 1),
        (name.strip_prefix("dot_"), 1),
        (over, 1),
        (name.strip_prefix("dd"), 2),
        (name.strip_prefix('d'), 1),
    ];
    forms.into_iter().filter_map(|(stem, order)| Some((stem.filter(|stem| !stem.is_empty())?, order))).collect()
}

/// Text as a quoted TOML key, in single quotes if it contains a backslash.
fn toml_key_of_spelling(text: &str) -> String {
    if text.contains('\\') { format!("'{text}'") } else { format!("\"{text}\"") }
}

/// True if a text has the form of a name in the language of model files.
fn is_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// Uniform spelling of a program variable: a name, members after dots, and indices. `None` if the text is no variable.
fn program_variable_spelling(text: &str) -> Option<String> {
    let text = text.replace("->", ".").replace(' ', "").replace('"', "'");
    let (name, mut rest) = match text.find(['(', '[']) {
        Some(at) => text.split_at(at),
        None => (text.as_str(), ""),
    };
    while !rest.is_empty() {
        let (inside, after) = match rest.strip_prefix('(') {
            Some(rest) => rest.split_once(')')?,
            None => rest.strip_prefix('[')?.split_once(']')?,
        };
        if !is_program_index(inside) {
            return None;
        }
        rest = after;
    }
    let is_spelled = |name: &String| is_name(name.trim_end_matches('\''));
    let is_word = |part: &str| is_name(part) || ascii_names_of_unicode(part).first().is_some_and(is_spelled);
    name.split('.').all(is_word).then_some(text)
}

/// Names of the notations that may be used in a publication file.
pub fn notation_names() -> [&'static str; 6] {
    let [a, b, c, d, e] = Notation::ALL.map(Notation::name);
    [a, b, c, "sympy", d, e]
}
