//! Meanings of the names in the formulas of a publication, and the reading of these formulas.

use super::name_spelling::{NameSpeller, NameSpellings, SpellingOutcome};
use super::printed_abbreviations::PrintedAbbreviations;
use super::program_variables::{ProgramValue, ProgramVariables, UnreadAssignment, variable_number_of_substitute};
use super::time_derivatives::TimeDerivatives;
use crate::algebra::term::calculus::Differential;
use crate::algebra::term::transfer::Transfer;
use crate::algebra::text::notation::{Notation, SymbolNames, translate};
use crate::algebra::text::parse::{ParseError, is_reserved_by_parser, parse_published};
use crate::algebra::{Arena, Expr, Node};
use crate::diagnostic::{Diagnostic, nearest_name_advice, shortened_for_message};
use crate::model::{Model, TIME};
use crate::toml_reader::{Located, TomlReader};
use rustc_hash::FxHashMap;
use std::ops::Range;
use std::sync::Arc;

/// Largest number of characters in a name that a publication file declares.
const MAX_LENGTH: usize = 60;
/// Largest number of primes after a name: q̈ is written `q1''`.
const PRIMES: usize = 2;
/// Largest number of terms that abbreviations may add to the formulas of one file. Without a limit, a long abbreviation
/// in frequent use would exhaust any memory.
const MAX_EXPANSION: usize = 200_000;

/// Notes on errors met while one formula is read.
#[derive(Default)]
struct FormulaErrorNotes {
    /// True if the formula uses a name whose declaration is wrong and already reported.
    spoiled: bool,
    /// True if the same error may occur in many formulas, so that it is reported once.
    repeated: bool,
    /// Number of the program variable whose assignment was not read, if this is the error; else `None`.
    assignment: Option<usize>,
}

/// Meaning of a name in the formulas of a publication.
#[derive(Clone, Copy)]
enum NameMeaning {
    /// Quantity of the model, with the word for its kind, such as "speed".
    Model(&'static str, Expr),
    /// Name that the publication file declares for a formula, or for the symbol of a derived quantity.
    Declared(Expr),
    /// Abbreviation that is declared later in the file.
    Later,
    /// Name whose declaration is wrong and reported. Formulas that use the name fail without a further message.
    Spoiled,
}

/// All names that formulas of a publication may use, with their meanings.
pub struct NameMeanings {
    /// Meaning of each name that formulas may use, by name.
    known: FxHashMap<String, NameMeaning>,
    /// Byte range of each name's declaration in the publication file.
    places: FxHashMap<String, Range<usize>>,
    /// Names in the order of their declaration, for advice in messages.
    order: Vec<String>,
    /// Spellings (symbols and program variables) that the publication uses for names.
    spellings: NameSpellings,
    /// Number of terms that abbreviations have added to formulas so far.
    expansion: usize,
    /// Rule for time derivatives of formulas.
    pub clock: TimeDerivatives,
    /// Variables of the program to which the formulas of an entry belong.
    pub locals: Arc<ProgramVariables>,
    /// Names of the model's coordinates and speeds that have another meaning in the publication.
    renamed: Vec<String>,
    /// Names of the model's coordinates, to recognize program variables for their rates.
    coordinates: Vec<String>,
    /// Names of multipliers that do not exist because their constraint is solved. Each is followed by the constraint
    /// and by the variable that it fixes.
    solved: Vec<(String, String, String)>,
    /// Abbreviations as symbols, with the formulas that use them.
    pub shorthand: PrintedAbbreviations,
}

impl NameMeanings {
    /// Names of all symbols of a model, with their meanings.
    pub fn new(model: &mut Model) -> Self {
        let mut words = Self {
            known: FxHashMap::default(),
            places: FxHashMap::default(),
            order: Vec::new(),
            spellings: NameSpellings::default(),
            expansion: 0,
            clock: TimeDerivatives::new(model),
            locals: Arc::default(),
            renamed: Vec::new(),
            coordinates: model.coordinates.iter().map(|c| c.name.clone()).collect(),
            solved: Vec::new(),
            shorthand: PrintedAbbreviations::of(
                &model.arena,
                model.parameters.iter().map(|p| p.name.clone()).collect(),
            ),
        };
        for p in &model.parameters {
            words.insert(&p.name, NameMeaning::Model("parameter", p.symbol));
        }
        for c in &model.coordinates {
            words.insert(&c.name, NameMeaning::Model("coordinate", c.symbol));
            words.insert(&format!("{}'", c.name), NameMeaning::Model("time derivative", c.rate));
            words.insert(&format!("{}''", c.name), NameMeaning::Model("time derivative", c.second_rate));
        }
        for s in &model.speeds {
            words.insert(&s.name, NameMeaning::Model("speed", s.symbol));
            words.insert(&format!("{}'", s.name), NameMeaning::Model("time derivative", s.rate));
        }
        for r in &model.reactions {
            words.insert(&r.name, NameMeaning::Model("reaction", r.symbol));
        }
        for c in &model.motion_constraints {
            let name = model.arena.symbol_name(c.multiplier).unwrap_or_default().to_owned();
            if !words.known.contains_key(&name) {
                words.insert(&name, NameMeaning::Model("multiplier", c.multiplier));
            }
        }
        words.insert_constrained_variables(model);
        words
    }

    /// Declares a coordinate or speed of the publication, and its known time derivatives as names with primes. Reports
    /// a name that cannot be declared, and returns false.
    pub fn declare_moving(
        &mut self,
        reader: &mut TomlReader<'_>,
        arena: &mut Arena,
        name: &Located,
        value: Option<Expr>,
    ) -> bool {
        let is_declared = self.declare(reader, name, value);
        let (mut rate, mut primed) = (value.filter(|_| is_declared), name.text.clone());
        for _ in 0..PRIMES {
            rate = rate.and_then(|e| self.clock.time_derivative(arena, e).ok());
            primed.push('\'');
            if let Some(rate) = rate {
                self.insert(&primed, NameMeaning::Declared(rate));
            }
        }
        is_declared
    }

    /// True if a name belongs to a coordinate or speed of the model.
    pub fn is_motion(&self, name: &str) -> bool {
        matches!(self.known.get(name), Some(NameMeaning::Model("coordinate" | "speed", _)))
    }

    /// Gives another meaning to a coordinate or speed of the model, and to its time derivatives. `value` is `None` if
    /// the declaration is wrong and already reported. Reports a second declaration.
    pub fn redefine(&mut self, reader: &mut TomlReader<'_>, arena: &mut Arena, name: &Located, value: Option<Expr>) {
        if let Some(first) = self.places.get(&name.text) {
            let message = format!("`{}` is declared twice", name.text);
            let twice = Diagnostic::new(name.span.clone(), message, "rename one of the two");
            reader.errors.push(twice.with_other(first.clone(), "first declared here"));
            return;
        }
        self.places.insert(name.text.clone(), name.span.clone());
        let (mut value, mut primed) = (value, name.text.clone());
        for _ in 0..=PRIMES {
            let is_known = self.known.contains_key(&primed);
            match value {
                Some(value) => self.insert(&primed, NameMeaning::Declared(value)),
                None if is_known => self.insert(&primed, NameMeaning::Spoiled),
                None => {}
            }
            value = value.and_then(|e| self.clock.time_derivative(arena, e).ok());
            primed.push('\'');
        }
        self.renamed.push(name.text.clone());
    }

    /// True if a name of the model, without its primes, has another meaning in the publication.
    pub fn is_renamed(&self, name: &str) -> bool {
        self.renamed.iter().any(|renamed| renamed == name.trim_end_matches('\''))
    }

    /// Formula of a declared name, such as `alpha''`; `None` for names that are not declared in the publication.
    pub fn declared_formula(&self, name: &str) -> Option<Expr> {
        match self.known.get(name) {
            Some(NameMeaning::Declared(value)) => Some(*value),
            _ => None,
        }
    }

    /// Adds the variables that constraints fix: their formulas in the generalized coordinates, and their time
    /// derivatives.
    fn insert_constrained_variables(&mut self, model: &mut Model) {
        let mut rates: Vec<_> = model.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        rates.extend(model.coordinates.iter().map(|c| (c.rate, c.second_rate)));
        let mut d_dt = Differential::along(&rates);
        for constraint in &model.constraints {
            let multiplier = format!("lambda_{}", constraint.name);
            self.solved.push((multiplier, constraint.name.clone(), constraint.fixes.clone()));
            let (mut name, mut value) = (constraint.fixes.clone(), constraint.value);
            for _ in 0..=PRIMES {
                self.insert(&name, NameMeaning::Model("constrained variable", value));
                value = d_dt.apply(&mut model.arena, value);
                name.push('\'');
            }
        }
    }

    /// Sets the meaning of a name, and adds its usual spelling.
    fn insert(&mut self, name: &str, word: NameMeaning) {
        if self.known.insert(name.to_owned(), word).is_none() {
            self.order.push(name.to_owned());
        }
        self.spellings.add_name(name);
    }

    /// Announces an abbreviation before it is declared, so that an earlier use gets a suitable error message.
    pub fn announce_abbreviation(&mut self, name: &str) {
        if !self.known.contains_key(name) {
            self.known.insert(name.to_owned(), NameMeaning::Later);
        }
        self.spellings.add_name(name);
    }

    /// Records a symbol that the publication uses for a name, which may end in primes. Reports an unknown name, a
    /// symbol that is already in use, and a text that cannot be a symbol.
    pub fn add_spelling(&mut self, reader: &mut TomlReader<'_>, symbol: &Located, name: &Located) {
        if !self.known.contains_key(&name.text) {
            let message = format!("unknown name `{}`", shortened_for_message(&name.text));
            return reader.error(name.span.clone(), message, self.advice(&name.text));
        }
        let shown_symbol = shortened_for_message(&symbol.text);
        match self.spellings.add_spelling(&symbol.text, &name.text) {
            SpellingOutcome::New => {}
            SpellingOutcome::Taken(other) => {
                let message = format!("`{shown_symbol}` is the same symbol as one that stands for `{other}`");
                reader.error(symbol.span.clone(), message, "remove one of the two");
            }
            SpellingOutcome::NoSymbol => {
                let help = "a symbol is LaTeX, as in 'I_{xx}' or '\\dot{\\psi}', or a name of a program, as in Ixx, \"p.m\" or \"z(6)\"";
                reader.error(symbol.span.clone(), format!("`{shown_symbol}` is not a symbol"), help);
            }
        }
    }

    /// Declares a name of the publication file. Reports a name that cannot be declared, and returns false. `value` is
    /// `None` if the declaration is wrong and already reported.
    pub fn declare(&mut self, reader: &mut TomlReader<'_>, name: &Located, value: Option<Expr>) -> bool {
        let text = &name.text;
        let valid = text.starts_with(|c: char| c.is_ascii_alphabetic())
            && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
            && text.len() <= MAX_LENGTH;
        let wrong = if !valid {
            let help = format!("a name is an ASCII letter and up to {} letters, digits and `_`", MAX_LENGTH - 1);
            Some((format!("`{}` cannot be a name", shortened_for_message(text)), help))
        } else if is_reserved_by_parser(text) {
            let help = "choose another name: this one belongs to the expression language";
            Some((format!("`{text}` is reserved"), help.to_owned()))
        } else if let Some(NameMeaning::Model(noun, _)) = self.known.get(text) {
            let help = format!("choose another name: in formulas `{text}` is the model's");
            Some((format!("`{text}` is a {noun} of the model"), help))
        } else {
            None
        };
        if let Some((message, help)) = wrong {
            reader.error(name.span.clone(), message, help);
            if let Some(word @ NameMeaning::Later) = self.known.get_mut(text) {
                *word = NameMeaning::Spoiled;
            }
            return false;
        }
        if let Some(first) = self.places.get(text) {
            let message = format!("`{text}` is declared twice");
            let twice = Diagnostic::new(name.span.clone(), message, "rename one of the two");
            reader.errors.push(twice.with_other(first.clone(), "first declared here"));
            return false;
        }
        self.places.insert(text.clone(), name.span.clone());
        self.insert(text, value.map_or(NameMeaning::Spoiled, NameMeaning::Declared));
        true
    }

    /// Reads a formula in a notation into the model's arena; reports its errors and returns `None`.
    pub fn formula(
        &mut self,
        reader: &mut TomlReader<'_>,
        arena: &mut Arena,
        formula: &Located,
        notation: Notation,
    ) -> Option<Expr> {
        // An error that has a single cause but may occur at many places is reported once.
        let mut course = FormulaErrorNotes::default();
        match self.read(arena, formula, notation, &mut course) {
            Ok(e) => {
                let is_read = !course.spoiled && reader.is_computable(arena, formula, e);
                if is_read {
                    self.record_printed_form(arena, formula, notation, e);
                }
                is_read.then_some(e)
            }
            Err(error) => {
                let (span, help) = (self.place(formula, &error, &course), error.help.unwrap_or_default());
                if course.repeated {
                    reader.error_once(span, error.message, help);
                } else {
                    reader.error(span, error.message, help);
                }
                None
            }
        }
    }

    /// Reads a formula of a program. An error is not reported, but returned as an unread value.
    pub fn read_program_formula(&mut self, arena: &mut Arena, formula: &Located, notation: Notation) -> ProgramValue {
        let mut course = FormulaErrorNotes::default();
        let unread = match self.read(arena, formula, notation, &mut course) {
            Ok(e) if !course.spoiled => return ProgramValue::Value(e),
            Ok(_) => UnreadAssignment {
                place: formula.span.clone(),
                message: "it uses a name that is declared wrongly".to_owned(),
                help: String::new(),
                names_assignment: false,
            },
            Err(error) => UnreadAssignment {
                place: self.place(formula, &error, &course),
                message: error.message,
                help: error.help.unwrap_or_default(),
                names_assignment: course.assignment.is_some(),
            },
        };
        ProgramValue::Unread(unread)
    }

    /// Place of an error in a formula: the unread assignment that caused the error, if any, else the part of the
    /// formula.
    fn place(&self, formula: &Located, error: &ParseError, course: &FormulaErrorNotes) -> Range<usize> {
        let unread = course.assignment.and_then(|number| self.locals.unread(number));
        unread.map_or_else(|| formula.part(error.span.clone()), |unread| unread.place.clone())
    }

    /// Meaning of a program variable by the model and the publication file, whatever the program assigns to it. The
    /// second value is true for a parameter. `None` if the name has no meaning there.
    pub fn meaning(&self, name: &str) -> Option<(Expr, bool)> {
        let (none, coordinates) = (ProgramVariables::default(), self.coordinates.as_slice());
        let mut speller = NameSpeller { spellings: &self.spellings, locals: &none, coordinates, repeated: false };
        match self.known.get(&speller.name_of_variable(name).ok()?)? {
            NameMeaning::Model(noun, e) => Some((*e, *noun == "parameter")),
            NameMeaning::Declared(e) => Some((*e, false)),
            NameMeaning::Later | NameMeaning::Spoiled => None,
        }
    }

    /// Name of the model or of the publication file that the text `text` spells in a notation; `None` for any other
    /// text.
    pub fn name_of(&self, text: &str, notation: Notation) -> Option<String> {
        let (none, coordinates) = (ProgramVariables::default(), self.coordinates.as_slice());
        let mut speller = NameSpeller { spellings: &self.spellings, locals: &none, coordinates, repeated: false };
        let plain = translate(text, notation, &mut speller).ok()?;
        let name = plain.text().trim();
        self.known.contains_key(name).then(|| name.to_owned())
    }

    /// Records a program variable as an abbreviation, so that a mistake in its assignment is found there. A name with
    /// an index, and a variable that is assigned a second time, are written out instead.
    pub fn record_program_variable(
        &mut self,
        arena: &Arena,
        name: &str,
        formula: &Located,
        notation: Notation,
        e: Expr,
    ) {
        self.record_printed_form(arena, formula, notation, e);
        if name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
            self.shorthand.add_abbreviation(arena, name, e);
        }
    }

    /// Reads a formula once more with its abbreviations as symbols, and records this printed form for the written-out
    /// form `e`. Formulas with `ddt` of an abbreviation are not recorded.
    fn record_printed_form(&mut self, arena: &Arena, formula: &Located, notation: Notation, e: Expr) {
        // A formula that equals an abbreviation's formula need not be printed as the abbreviation's name.
        let is_known = self.shorthand.printed.contains_key(&e) && !self.shorthand.is_name(e);
        if self.shorthand.abbreviations().is_empty() || is_known {
            return;
        }
        let locals = Arc::clone(&self.locals);
        let coordinates = self.coordinates.as_slice();
        let mut speller = NameSpeller { spellings: &self.spellings, locals: &locals, coordinates, repeated: false };
        let Ok(plain) = translate(&formula.text, notation, &mut speller) else { return };
        let (known, spellings) = (&self.known, &self.spellings);
        let (mut kept, mut mentions) = (std::mem::take(&mut self.shorthand), false);
        let mut own = std::mem::take(&mut kept.arena);
        let mut transfer = Transfer::new(arena);
        let mut no_rate = |_: &mut Arena, _: Expr| Err((String::new(), None));
        let mut resolve = |own: &mut Arena, name: &str| {
            let stated = spellings.variable(name).filter(|_| notation == Notation::Tripos);
            let name = stated.as_deref().unwrap_or(name);
            if let Some(symbol) = kept.symbol(name) {
                mentions = true;
                return Ok(symbol);
            }
            if let Some(ProgramValue::Value(e)) =
                variable_number_of_substitute(name).and_then(|number| locals.value(number))
            {
                let as_printed = kept.printed_form(*e);
                mentions |= as_printed.is_some();
                return Ok(as_printed.unwrap_or_else(|| transfer.transfer_term(own, *e)));
            }
            match known.get(name) {
                Some(NameMeaning::Model(_, e) | NameMeaning::Declared(e)) => Ok(transfer.transfer_term(own, *e)),
                _ => Err((String::new(), None)),
            }
        };
        let read = parse_published(&mut own, plain.text(), PRIMES, &mut resolve, &mut no_rate);
        kept.arena = own;
        if let (Ok(as_printed), true) = (read, mentions) {
            kept.printed.insert(e, as_printed);
        }
        self.shorthand = kept;
    }

    /// Reads a formula as a term. If it fails, the kind of the error is noted in `course`.
    fn read(
        &mut self,
        arena: &mut Arena,
        formula: &Located,
        notation: Notation,
        course: &mut FormulaErrorNotes,
    ) -> Result<Expr, ParseError> {
        let locals = Arc::clone(&self.locals);
        let coordinates = self.coordinates.as_slice();
        let mut speller = NameSpeller { spellings: &self.spellings, locals: &locals, coordinates, repeated: false };
        let plain =
            translate(&formula.text, notation, &mut speller).inspect_err(|_| course.repeated = speller.repeated)?;
        let (known, spellings, expansion) = (&self.known, &self.spellings, &mut self.expansion);
        let clock = &mut self.clock;
        let mut unknown = None;
        let mut rate = |arena: &mut Arena, e: Expr| clock.time_derivative(arena, e);
        let mut resolve = |arena: &mut Arena, name: &str| {
            // In other notations, the symbols of a formula have been replaced already.
            let stated = spellings.variable(name).filter(|_| notation == Notation::Tripos);
            let name = stated.as_deref().unwrap_or(name);
            if let Some((number, local)) =
                variable_number_of_substitute(name).and_then(|number| Some((number, locals.value(number)?)))
            {
                return match local {
                    ProgramValue::Value(e) => {
                        *expansion += operand_count(arena, *e);
                        if *expansion > MAX_EXPANSION {
                            course.repeated = true;
                            let help = "name a part of the program that has fewer assignments";
                            return Err(("the assignments make these formulas too long".to_owned(), Some(help.into())));
                        }
                        Ok(*e)
                    }
                    ProgramValue::Unread(unread) => {
                        course.assignment = Some(number);
                        Err((unread.message.clone(), Some(unread.help.clone())))
                    }
                };
            }
            match known.get(name).copied() {
                Some(NameMeaning::Model(_, e)) => Ok(e),
                Some(NameMeaning::Declared(e)) => {
                    *expansion += operand_count(arena, e);
                    if *expansion > MAX_EXPANSION {
                        course.repeated = true;
                        let help = "shorten the abbreviations, or split the file";
                        return Err(("abbreviations make these formulas too long".to_owned(), Some(help.to_owned())));
                    }
                    Ok(e)
                }
                Some(NameMeaning::Spoiled) => {
                    course.spoiled = true;
                    Ok(arena.symbol("not read"))
                }
                Some(NameMeaning::Later) => {
                    let message = format!("`{name}` is used before it is declared");
                    Err((message, Some("an abbreviation may use those above it".to_owned())))
                }
                None if !locals.entries(name).is_empty() => {
                    let message = format!(
                        "`{}` is a vector or a matrix, of which only entries are read",
                        shortened_for_message(name)
                    );
                    Err((message, Some("write out its products entry by entry".to_owned())))
                }
                None => {
                    course.repeated = true;
                    unknown = Some(name.to_owned());
                    Err((format!("unknown name `{}`", shortened_for_message(name)), None))
                }
            }
        };
        let read = parse_published(arena, plain.text(), PRIMES, &mut resolve, &mut rate);
        read.map_err(|error| {
            let help = unknown.map(|name| self.advice(&name)).or(error.help);
            ParseError { span: plain.source_range(error.span), help, ..error }
        })
    }

    /// Advice for an unknown name, such as the nearest known name.
    fn advice(&self, name: &str) -> String {
        let plain = name.trim_end_matches('\'');
        if let Some((_, constraint, fixes)) = self.solved.iter().find(|(multiplier, ..)| multiplier == name) {
            return format!("the constraint `{constraint}` is solved for `{fixes}`, so it has no multiplier");
        }
        match (name, self.known.get(plain)) {
            (TIME, _) => "nothing in the model depends on time".to_owned(),
            ("deg" | "degree" | "degrees", _) => "angles are in radians: write 10 degrees as `10*pi/180`".to_owned(),
            (_, Some(NameMeaning::Model("speed", _))) => format!("a speed has one derivative only: {plain}'"),
            (_, Some(_)) => format!("a prime stands after coordinates and speeds only; `{plain}` is neither"),
            _ => nearest_name_advice(name, self.order.iter().map(String::as_str)),
        }
    }
}

/// Number of operands that a term adds to a sum or product that contains it.
fn operand_count(arena: &Arena, e: Expr) -> usize {
    match arena.node(e) {
        Node::Sum(_, terms) => terms.len(),
        Node::Product(factors) => factors.len(),
        _ => 1,
    }
}
