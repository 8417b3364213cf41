//! Formulas that are printed and read again, in every notation that Tripos both prints and reads.

use crate::campaign::{Answer, Random, Share, campaign, tried};
use crate::grammar::formula;
use std::collections::BTreeMap;
use std::collections::HashMap;
use tripos_derive::algebra::text::notation::{LatexSymbol, Notation, SymbolNames, Unknown, read_symbol, translate};
use tripos_derive::algebra::text::parse::{ParseError, parse_primed};
use tripos_derive::algebra::text::print::{latex, latex_name, print_text, print_whole_view, python_of, sympy_of};
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::algebra::{Arena, Expr};

/// Names of a formula, by the LaTeX symbols with which they are printed.
struct Spelling(BTreeMap<String, String>);

impl Spelling {
    /// Finds the LaTeX symbols of names.
    fn new(names: impl Iterator<Item = String>) -> Self {
        let symbol = |name: String| Some((read_symbol(&latex_name(&name))?.without_dots(), name));
        Self(names.filter_map(symbol).collect())
    }
}

impl SymbolNames for Spelling {
    fn knows(&self, symbol: &LatexSymbol) -> bool {
        self.0.contains_key(&symbol.without_dots())
    }

    fn name_of_latex_symbol(&mut self, symbol: &LatexSymbol, _: &str) -> Result<String, Unknown> {
        let name = self.0.get(&symbol.without_dots()).ok_or((format!("`{symbol}` is unknown"), None))?;
        Ok(format!("{name}{}", "'".repeat(symbol.dots)))
    }

    fn name_of_variable(&mut self, name: &str) -> Result<String, Unknown> {
        Ok(name.to_owned())
    }
}

/// Reads a printed formula.
fn read_back(arena: &mut Arena, text: &str, notation: Notation, names: &mut Spelling) -> Result<Expr, ParseError> {
    let translation = translate(text, notation, names)?;
    parse_primed(arena, translation.text(), 2, &mut |arena, name| Ok(arena.symbol(name)))
}

/// Prints a random formula, reads it again, and compares.
fn there_and_back(notation: Notation, print: fn(&Arena, Expr) -> String, random: &mut Random) -> Answer {
    let mut arena = Arena::new();
    let depth = 1 + random.below(5);
    let text = formula(Notation::Tripos, depth, random);
    // Programs have no primes: a rate has a name of its own there.
    let text = if notation == Notation::Python { text.replace('\'', "_dot") } else { text };
    let Ok(term) = parse_primed(&mut arena, &text, 2, &mut |arena, name| Ok(arena.symbol(name))) else {
        return Answer::Refused;
    };
    let printed = print(&arena, term);
    tried(&format!("{text} is printed as {printed}"));
    let words = text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty());
    let mut names = Spelling::new(words.map(str::to_owned));
    let back = match read_back(&mut arena, &printed, notation, &mut names) {
        Ok(back) => back,
        Err(error) => panic!("a printed formula is refused: {} | {error:?}", error.message),
    };
    if back == term {
        return Answer::Read;
    }
    let difference = arena.sub(term, back);
    match zero_test(&arena, difference) {
        ZeroTest::Zero => Answer::Read,
        test => panic!("a printed formula has another meaning ({test:?}) | {}", print_text(&arena, back)),
    }
}

#[test]
fn formulas_of_models_are_read_as_printed() {
    let share = Share { short: 4000, long: 400_000 };
    campaign("print and read: models", &share, |random| there_and_back(Notation::Tripos, print_text, random));
}

#[test]
fn formulas_in_latex_are_read_as_printed() {
    let share = Share { short: 3000, long: 300_000 };
    campaign("print and read: LaTeX", &share, |random| there_and_back(Notation::Latex, latex, random));
}

#[test]
fn formulas_in_python_are_read_as_printed() {
    let share = Share { short: 3000, long: 300_000 };
    campaign("print and read: Python", &share, |random| {
        let print = if random.chance(50) {
            |arena: &Arena, e| python_of(&print_whole_view(arena, e, &HashMap::default()))
        } else {
            |arena: &Arena, e| sympy_of(&print_whole_view(arena, e, &HashMap::default()))
        };
        there_and_back(Notation::Python, print, random)
    });
}
