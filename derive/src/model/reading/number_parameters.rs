//! Literals: numbers with units in formulas. Each becomes a parameter, so that all units are checked and equations
//! keep symbols.

use super::declared_names::{AllowedQuantities, NameKind};
use super::loading::Loading;
use crate::algebra::Expr;
use crate::model::Parameter;
use crate::model::units::{StatedUnit, Unit};
use crate::toml_reader::Located;

/// Letters that books use for quantities, by the exponents of metre, kilogram and second in their
/// units.
const LETTERS: [([i64; 3], &str); 12] = [
    ([1, 0, 0], "l"),
    ([0, 1, 0], "m"),
    ([0, 0, 1], "t"),
    ([2, 1, 0], "I"),
    ([1, 0, -1], "v"),
    ([1, 0, -2], "a"),
    ([0, 0, -1], "w"),
    ([1, 1, -2], "F"),
    ([2, 1, -2], "T"),
    ([0, 1, -2], "k"),
    ([0, 1, -1], "c"),
    ([2, 1, -1], "c"),
];

impl Loading<'_> {
    /// Reads a formula, or a number with a unit, as a term. `what` names it in error messages. `None` after an error
    /// is reported.
    pub fn formula(&mut self, formula: &Located, allowed: AllowedQuantities, what: &str) -> Option<Expr> {
        let Some(stated) = StatedUnit::of(&formula.text) else {
            return self.names.formula(&mut self.reader, &mut self.arena, formula, allowed, what);
        };
        if stated.unit.is_plain() || !allowed.0.contains(&NameKind::Parameter) {
            let number = stated.number_before_unit(formula);
            let e = self.names.formula(&mut self.reader, &mut self.arena, &number, allowed, what)?;
            return Some(stated.apply(&mut self.arena, e));
        }
        self.literal(formula, stated.unit, what)
    }

    /// Symbol of the parameter that stands for a number with a unit. The same place in the file always gives the same
    /// parameter. `None` after an error is reported.
    fn literal(&mut self, formula: &Located, unit: Unit, what: &str) -> Option<Expr> {
        if let Some((_, symbol)) = self.literals.iter().find(|(place, _)| *place == formula.span) {
            return Some(*symbol);
        }
        let value = Some(self.constant_parameter_value(formula)?);
        let name = self.name_of_literal(&unit, what);
        let symbol = self.arena.symbol(&name);
        self.names.insert_used(&name, NameKind::Parameter, formula.span.clone(), symbol);
        self.units.insert(symbol, unit.clone());
        self.literals.push((formula.span.clone(), symbol));
        let about = what.replace('`', "");
        self.stated_numbers.push(Parameter { name, symbol, unit, value, positive: false, is_input: false, about });
        Some(symbol)
    }

    /// Unused name for the parameter that stands for a number with a unit. It consists of the usual letter for the
    /// unit and of the owner that `what` names. An example is `m_cart` for the mass of body `cart`.
    fn name_of_literal(&self, unit: &Unit, what: &str) -> String {
        let known = |exponents: [i64; 3]| LETTERS.iter().find(|(of, _)| *of == exponents).map(|(_, letter)| *letter);
        let letter = unit.whole_exponents().and_then(known).unwrap_or("p");
        let owner =
            what.rsplit('`').nth(1).filter(|owner| owner.chars().all(|c| c.is_ascii_alphanumeric() || c == '_'));
        let stem = owner.map_or_else(|| letter.to_owned(), |owner| format!("{letter}_{owner}"));
        let is_free = |name: &String| self.names.kind(name).is_none() && !contains_word(&self.reader.source.text, name);
        let first = owner.map(|_| stem.clone()).filter(is_free);
        first.unwrap_or_else(|| {
            let numbered = (1..).map(|number| format!("{stem}{number}"));
            numbered.into_iter().find(is_free).expect("a file has finitely many names")
        })
    }
}

/// True if a text contains a name as a whole word.
fn contains_word(text: &str, name: &str) -> bool {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.match_indices(name)
        .any(|(at, _)| !text[..at].ends_with(is_part) && !text[at + name.len()..].starts_with(is_part))
}
