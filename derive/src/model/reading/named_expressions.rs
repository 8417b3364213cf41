//! Named expressions of a model file: formulas with a name. The name may occur wherever all quantities in the formula
//! are allowed.

use super::declared_names::{AllowedQuantities, NameKind};
use super::loading::Loading;
use crate::algebra::Expr;
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// Kinds of quantities that a named expression may contain.
const PARTS: AllowedQuantities =
    AllowedQuantities(&[NameKind::Parameter, NameKind::Coordinate, NameKind::Rate, NameKind::Speed]);

impl<'a> Loading<'a> {
    /// Reads `[expressions]` in the order of the file. An expression may contain earlier expressions by name. Returns
    /// (term, byte range of its formula). Errors are recorded in the reader.
    pub fn expressions(&mut self, table: &'a DeTable<'a>) -> Vec<(Expr, Range<usize>)> {
        let mut list = Vec::new();
        for (name, value) in self.section(table, "expressions", &[NameKind::Expression]) {
            let value = match value.get_ref() {
                DeValue::Table(entry) => {
                    self.reader.report_unknown_keys(entry, "an expression", &["value", "about"]);
                    self.about(entry);
                    self.reader.required(entry, "value", &format!("expression `{}`", name.text), &name.span)
                }
                _ => Some(value),
            };
            let what = "an expression";
            let formula = value.and_then(|value| self.reader.formula(value, what));
            let e = formula.as_ref().and_then(|formula| self.formula(formula, PARTS, what));
            let (Some(formula), Some(e)) = (formula, e) else {
                self.names.mark_wrong_name(&name.text);
                continue;
            };
            let parts = self.arena.reachable(&[e]);
            self.names.declare_expression(&mut self.reader, &name, e, &parts);
            list.push((e, formula.span));
        }
        list
    }
}
