//! Formulas in every notation that Tripos reads.

use crate::campaign::{Answer, Random, Share, campaign, tried};
use crate::grammar::formula;
use crate::mutation::spoilt;
use crate::refusal::check_errors;
use crate::seeds::quoted_text;
use tripos_derive::algebra::text::notation::{LatexSymbol, Notation, SymbolNames, Unknown, translate};
use tripos_derive::algebra::text::parse::{ParseError, parse_primed, parse_published, parse_with_quantities};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::{Diagnostic, Diagnostics, Source};

/// Names for symbols: most symbols have a name made from their letters, and a few are unknown.
pub struct Letters;

impl SymbolNames for Letters {
    fn knows(&self, symbol: &LatexSymbol) -> bool {
        ["", "B", "*"].contains(&symbol.mark.as_str()) && symbol.base != "\\pi"
    }

    fn is_coordinate(&self, symbol: &LatexSymbol) -> bool {
        symbol.base.starts_with(['q', 'x'])
    }

    fn name_of_latex_symbol(&mut self, symbol: &LatexSymbol, _: &str) -> Result<String, Unknown> {
        let letters = |text: &str| text.chars().filter(char::is_ascii_alphanumeric).collect::<String>();
        let name = format!("{}{}", letters(&symbol.base), letters(&symbol.subscript));
        if name.is_empty() || !self.knows(symbol) {
            return Err(("a symbol without a name".to_owned(), Some("declare it".to_owned())));
        }
        Ok(format!("{name}{}", "'".repeat(symbol.dots)))
    }

    fn name_of_variable(&mut self, name: &str) -> Result<String, Unknown> {
        let inside: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
        let name = inside.trim_end_matches('_');
        if name.starts_with(|c: char| c.is_ascii_alphabetic()) {
            Ok(name.to_owned())
        } else {
            Err(("a variable without a name".to_owned(), Some("declare it".to_owned())))
        }
    }
}

/// Refuses the names that begin with `zz`, and declares all others.
fn resolve(arena: &mut Arena, name: &str) -> Result<Expr, (String, Option<String>)> {
    if name.starts_with("zz") {
        Err(("an unknown name".to_owned(), Some("declare it".to_owned())))
    } else {
        Ok(arena.symbol(name))
    }
}

/// Reads a formula of a notation, by one of the readers that files use.
fn read(text: &str, notation: Notation, random: &mut Random) -> Result<(), ParseError> {
    let translation = translate(text, notation, &mut Letters)?;
    let mut arena = Arena::new();
    let plain = translation.text();
    let answer = match random.below(3) {
        0 => parse_primed(&mut arena, plain, 2, &mut resolve),
        1 => parse_published(&mut arena, plain, 2, &mut resolve, &mut |arena, e| {
            let half = arena.symbol("rate");
            Ok(arena.mul(half, e))
        }),
        _ => parse_with_quantities(
            &mut arena,
            plain,
            &mut resolve,
            &mut |arena, _| Ok(arena.symbol("velocity")),
            &mut |arena, _| Ok(arena.symbol("interaction")),
        ),
    };
    answer.map(drop).map_err(|error| ParseError { span: translation.source_range(error.span), ..error })
}

/// A formula from the grammar or from a file, mostly with changes.
fn formula_text(notation: Notation, random: &mut Random) -> String {
    let depth = random.below(6);
    let made = formula(notation, depth, random);
    match random.below(5) {
        0 => made,
        1 | 2 => spoilt(&made, quoted_text(random), random),
        3 => {
            let (seed, other) = (quoted_text(random), quoted_text(random));
            spoilt(seed, other, random)
        }
        _ => spoilt(quoted_text(random), &made, random),
    }
}

/// Reads one random formula of a notation.
fn read_formula(notation: Notation, random: &mut Random) -> Answer {
    let text = formula_text(notation, random);
    tried(&text);
    let Err(error) = read(&text, notation, random) else { return Answer::Read };
    let Some(help) = error.help else { panic!("a refusal without a hint | {}", error.message) };
    let source = Source { path: "formula".into(), text };
    let list = vec![Diagnostic::new(error.span, error.message, help)];
    check_errors(&Diagnostics::new(source, list), &|_| false);
    Answer::Refused
}

#[test]
fn formulas_of_models() {
    let share = Share { short: 20_000, long: 3_950_000 };
    campaign("formulas of models", &share, |random| read_formula(Notation::Tripos, random));
}

#[test]
fn formulas_in_latex() {
    let share = Share { short: 15_000, long: 2_400_000 };
    campaign("formulas in LaTeX", &share, |random| read_formula(Notation::Latex, random));
}

#[test]
fn formulas_in_python() {
    let share = Share { short: 5_000, long: 600_000 };
    campaign("formulas in Python", &share, |random| read_formula(Notation::Python, random));
}

#[test]
fn formulas_in_matlab() {
    let share = Share { short: 5_000, long: 600_000 };
    campaign("formulas in MATLAB", &share, |random| read_formula(Notation::Matlab, random));
}

#[test]
fn formulas_in_c() {
    let share = Share { short: 5_000, long: 500_000 };
    campaign("formulas in C", &share, |random| read_formula(Notation::C, random));
}
