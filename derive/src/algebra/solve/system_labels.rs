//! Names for long terms of a linear system that is solved block by block.
//!
//! Without names, the solution of a block is as long as the product of its entries, and the solutions of later blocks
//! contain it in full. Short blocks stay without names, so that their terms cancel.

use super::linear::LinearForm;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::contraction::contract_products;
use crate::algebra::text::print::length_up_to_names;
use crate::algebra::{Arena, Expr};

/// Length of the entries of a block above which the block's terms get names, in printed nodes.
const LONG_BLOCK: usize = 1_000;
/// Length above which a term of a long block gets a name, in printed nodes.
const LONG_TERM: usize = 30;

/// Words from which the names of terms of a linear system A x = b are made. The right-hand side b is linear in given
/// symbols.
#[derive(Clone, Debug)]
pub struct SystemLabels {
    /// Name of each row.
    pub rows: Vec<String>,
    /// Name of each unknown.
    pub unknowns: Vec<String>,
    /// Symbols in which b is linear, each with its name. If empty, each unknown gets its own name as a whole.
    pub symbols: Vec<(Expr, String)>,
}

/// Names of the terms of one long block.
#[derive(Clone, Debug)]
pub struct BlockLabels<'a> {
    /// Names of the whole system.
    of: &'a SystemLabels,
    /// Indices of the block's rows in the system.
    rows: &'a [usize],
    /// Indices of the block's unknowns in the system.
    columns: &'a [usize],
}

impl SystemLabels {
    /// Labels of the block with the given rows and columns. `None` if the block is so short that its terms need no
    /// names, unless each unknown gets its own.
    pub fn of_block<'a>(
        &'a self,
        arena: &Arena,
        block: &[Vec<Expr>],
        rows: &'a [usize],
        columns: &'a [usize],
    ) -> Option<BlockLabels<'a>> {
        let length: usize =
            block.iter().flatten().map(|e| length_up_to_names(arena, *e)).fold(0, usize::saturating_add);
        (length > LONG_BLOCK || self.symbols.is_empty()).then_some(BlockLabels { of: self, rows, columns })
    }
}

impl BlockLabels<'_> {
    /// True if each unknown gets its own name as a whole.
    #[must_use]
    pub fn of_whole_unknowns(&self) -> bool {
        self.of.symbols.is_empty()
    }

    /// The value `e` of the block's unknown with the index `column`, with the name of the unknown.
    pub fn name_unknown(&self, arena: &mut Arena, column: usize, e: Expr) -> Expr {
        arena.name(e, &self.of.unknowns[self.columns[column]])
    }

    /// Names the long entries of the block's matrix, and the long coefficients of its right-hand side.
    pub fn name_entries(
        &self,
        arena: &mut Arena,
        simplifier: &mut Simplifier,
        block: &mut [Vec<Expr>],
        right: &mut [Expr],
    ) {
        for ((row, label), right) in block.iter_mut().zip(self.rows.iter().map(|r| &self.of.rows[*r])).zip(right) {
            for (entry, column) in row.iter_mut().zip(self.columns) {
                let label = format!("slope_{label}_{}", self.of.unknowns[*column]);
                *entry = name_long_term(arena, simplifier, *entry, &label);
            }
            *right =
                self.name_coefficients(arena, simplifier, *right, &format!("slope_{label}"), &format!("drift_{label}"));
        }
    }

    /// Names a minor of the block with the given rows, or an eliminated entry of one row, if it is long. The name
    /// contains that of the first row.
    pub fn name_minor(&self, arena: &mut Arena, e: Expr, rows: &[usize]) -> Expr {
        let first = rows.first().map_or("", |r| self.of.rows[self.rows[*r]].as_str());
        if length_up_to_names(arena, e) > LONG_TERM { arena.name(e, &format!("minor_{first}")) } else { e }
    }

    /// The block's unknowns, each named as a whole, or with names for their long coefficients.
    pub fn name_unknowns(&self, arena: &mut Arena, simplifier: &mut Simplifier, unknowns: &[Expr]) -> Vec<Expr> {
        if self.of_whole_unknowns() {
            return unknowns.iter().enumerate().map(|(column, e)| self.name_unknown(arena, column, *e)).collect();
        }
        let labels = self.columns.iter().map(|column| &self.of.unknowns[*column]);
        let named = unknowns.iter().zip(labels).map(|(e, label)| {
            self.name_coefficients(arena, simplifier, *e, &format!("ratio_{label}"), &format!("drift_{label}"))
        });
        named.collect()
    }

    /// The term `e` with names for its long coefficients in the symbols of the system, and for its long rest. The name
    /// of a coefficient is `label` and the symbol's name.
    fn name_coefficients(
        &self,
        arena: &mut Arena,
        simplifier: &mut Simplifier,
        e: Expr,
        label: &str,
        label_of_rest: &str,
    ) -> Expr {
        let symbols: Vec<Expr> = self.of.symbols.iter().map(|(symbol, _)| *symbol).collect();
        let Ok((row, rest)) = LinearForm::new(&symbols).coefficients(arena, e) else { return e };
        let mut terms = vec![name_long_term(arena, simplifier, rest, label_of_rest)];
        for (coefficient, (symbol, name)) in row.into_iter().zip(&self.of.symbols) {
            let named = name_long_term(arena, simplifier, coefficient, &format!("{label}_{name}"));
            terms.push(arena.mul(named, *symbol));
        }
        arena.sum(&terms)
    }
}

/// The term `e` in short form; a named term if this is long.
fn name_long_term(arena: &mut Arena, simplifier: &mut Simplifier, e: Expr, label: &str) -> Expr {
    if length_up_to_names(arena, e) <= LONG_TERM {
        return e;
    }
    let short = simplifier.simplify(arena, e);
    let short = contract_products(arena, short);
    if length_up_to_names(arena, short) > LONG_TERM { arena.name(short, label) } else { short }
}
