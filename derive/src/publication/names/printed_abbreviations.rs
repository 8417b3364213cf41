//! Formulas of a publication as printed, in which its abbreviations are symbols.
//!
//! Entries are judged with abbreviations written out. The printed form of each written-out formula is kept, too, so
//! that a mistake in an abbreviation is found in the abbreviation's own formula. Printed forms have their own arena:
//! they must not change the order of terms in the model's arena.

use crate::algebra::solve::linear::{LinearForm, linear_row_term};
use crate::algebra::term::transfer::Transfer;
use crate::algebra::{Arena, Expr, Node};
use rustc_hash::FxHashMap;

/// Abbreviation of a publication for a sum, a product, or a function of one of these. Names for a single symbol, a
/// number or a function of a symbol are not kept.
#[derive(Clone, Debug)]
pub struct Abbreviation {
    /// Name of the abbreviation, as declared in the publication file.
    pub name: String,
    /// Symbol of the abbreviation, in the arena of printed formulas.
    pub symbol: Expr,
    /// Formula of the abbreviation as printed, in which earlier abbreviations are symbols.
    pub formula: Expr,
}

/// Abbreviations of a publication, with the printed forms of the formulas that use them.
#[derive(Clone, Default)]
pub struct PrintedAbbreviations {
    /// Store of the terms of printed formulas, separate from the model's arena.
    pub(in crate::publication) arena: Arena,
    /// Abbreviations in the order of the publication file.
    pub(in crate::publication) list: Vec<Abbreviation>,
    /// Printed form of each formula. The key is the formula in the model's arena with all abbreviations written out.
    pub(in crate::publication) printed: FxHashMap<Expr, Expr>,
    /// Names of the model's symbols, which cannot be names of abbreviations.
    reserved: Vec<String>,
    /// Names of the model's parameters, which come before variables in printed products.
    parameters: Vec<String>,
}

impl std::fmt::Debug for PrintedAbbreviations {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Shorthand").field("list", &self.list).finish_non_exhaustive()
    }
}

impl PrintedAbbreviations {
    /// Creates an empty store of printed formulas, with the symbols of the arena `model`.
    pub(in crate::publication) fn of(model: &Arena, parameters: Vec<String>) -> Self {
        Self { reserved: model.symbol_names().to_vec(), parameters, ..Self::default() }
    }

    /// Names that come first in products: abbreviations and parameters precede variables.
    pub fn leading_names(&self) -> impl Iterator<Item = &str> {
        self.list.iter().map(|one| &one.name).chain(&self.parameters).map(String::as_str)
    }

    /// Arena that holds the terms of printed formulas.
    #[must_use]
    pub fn arena(&self) -> &Arena {
        &self.arena
    }

    /// Abbreviations in the order of the publication file.
    #[must_use]
    pub fn abbreviations(&self) -> &[Abbreviation] {
        &self.list
    }

    /// Printed form of a formula of the model's arena, as a term of the arena of printed formulas.
    /// Returns `None` if the formula uses no abbreviation.
    #[must_use]
    pub fn printed_form(&self, e: Expr) -> Option<Expr> {
        self.printed.get(&e).copied()
    }

    /// Abbreviations that a printed formula uses, directly or through others, in the order of their
    /// declaration.
    #[must_use]
    pub fn used_abbreviations(&self, as_printed: Expr) -> Vec<&Abbreviation> {
        let mut formulas = vec![as_printed];
        let mut used = Vec::new();
        for one in self.list.iter().rev() {
            if formulas.iter().any(|e| self.arena.mentions(*e, one.symbol)) {
                formulas.push(one.formula);
                used.push(one);
            }
        }
        used.reverse();
        used
    }

    /// Adds the abbreviation `name` with the formula `e` in the model's arena. An abbreviation of a single symbol, of a
    /// number or of a function of a symbol, such as s1 for sin(q1), is not added: it is written out everywhere.
    pub(in crate::publication) fn add_abbreviation(&mut self, model: &Arena, name: &str, e: Expr) {
        if self.arena.find_symbol(name).is_some()
            || self.reserved.iter().any(|one| one == name)
            || (!is_formula(model, e) && !self.printed.contains_key(&e))
        {
            return;
        }
        let formula = self.printed_form(e).unwrap_or_else(|| Transfer::new(model).transfer_term(&mut self.arena, e));
        let symbol = self.arena.symbol(name);
        // A formula that equals an abbreviation is printed as its name.
        self.printed.insert(e, symbol);
        self.list.push(Abbreviation { name: name.to_owned(), symbol, formula });
    }

    /// Records the printed form of the difference left − right of an equation if either side uses an abbreviation.
    pub(in crate::publication) fn record_difference(
        &mut self,
        model: &Arena,
        difference: Expr,
        left: Expr,
        right: Expr,
    ) {
        if self.printed_form(left).or(self.printed_form(right)).is_none() {
            return;
        }
        let mut transfer = Transfer::new(model);
        let [left, right] =
            [left, right].map(|e| self.printed_form(e).unwrap_or_else(|| transfer.transfer_term(&mut self.arena, e)));
        let as_printed = self.arena.sub(left, right);
        self.printed.entry(difference).or_insert(as_printed);
    }

    /// Records the printed form of a quotient, if its dividend or divisor uses an abbreviation.
    pub fn record_quotient(&mut self, model: &Arena, quotient: Expr, dividend: Expr, divisor: Expr) {
        if self.printed_form(dividend).or(self.printed_form(divisor)).is_none() {
            return;
        }
        let mut transfer = Transfer::new(model);
        let [dividend, divisor] = [dividend, divisor]
            .map(|e| self.printed_form(e).unwrap_or_else(|| transfer.transfer_term(&mut self.arena, e)));
        if let Some(as_printed) = self.arena.div(dividend, divisor) {
            self.printed.entry(quotient).or_insert(as_printed);
        }
    }

    /// Records the printed forms of a row's coefficients and right-hand side if the equation uses an abbreviation.
    /// `row` has abbreviations written out: one coefficient for each unknown, then the right-hand side.
    pub(in crate::publication) fn record_row(
        &mut self,
        model: &mut Arena,
        equation: Expr,
        unknowns: &[Expr],
        row: &[Expr],
    ) {
        let Some(as_printed) = self.printed_form(equation) else { return };
        let whole = linear_row_term(model, unknowns, row);
        self.printed.entry(whole).or_insert(as_printed);
        let mut transfer = Transfer::new(model);
        let unknowns: Vec<Expr> = unknowns.iter().map(|e| transfer.transfer_term(&mut self.arena, *e)).collect();
        let Ok((mut own, rest)) = LinearForm::new(&unknowns).coefficients(&mut self.arena, as_printed) else { return };
        own.push(self.arena.neg(rest));
        for (written_out, own) in row.iter().zip(own) {
            let parts = self.arena.reachable(&[own]);
            if self.list.iter().any(|one| parts.binary_search(&one.symbol).is_ok()) {
                self.printed.entry(*written_out).or_insert(own);
            }
        }
    }

    /// True if a formula is printed as the bare name of an abbreviation.
    #[must_use]
    pub fn is_name(&self, e: Expr) -> bool {
        self.printed_form(e).is_some_and(|printed| self.list.iter().any(|one| one.symbol == printed))
    }

    /// Symbol of an abbreviation; `None` for a name that is no abbreviation or is always written out.
    pub(in crate::publication) fn symbol(&self, name: &str) -> Option<Expr> {
        self.list.iter().find(|one| one.name == name).map(|one| one.symbol)
    }
}

/// True if a term is a sum of at least two terms, a product of at least two factors, or a function of one of these.
fn is_formula(arena: &Arena, e: Expr) -> bool {
    match arena.node(e) {
        Node::Apply(_, argument) => is_formula(arena, *argument),
        Node::Sum(constant, terms) => terms.len() > 1 || !constant.is_zero() || is_formula(arena, terms[0].0),
        Node::Product(factors) => factors.len() > 1 || is_formula(arena, factors[0].0),
        _ => false,
    }
}
