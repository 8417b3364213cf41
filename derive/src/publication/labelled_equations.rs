//! Equations of a LaTeX file, found by their labels, and abbreviations that such equations define.

use super::entries::{EntryTable, entry_formula_part};
use super::names::author_files::notation_of_author_file;
use super::printed::LabelChoice;
use super::printed::equalities::{equations, sides};
use super::publication_reader::PublicationReader;
use crate::algebra::text::notation::Notation;
use crate::diagnostic::shortened_for_message;
use crate::toml_reader::Located;
use std::ops::Range;
use toml::de::DeTable;

impl<'a> PublicationReader<'a, '_> {
    /// Equations with this label in the LaTeX file of an entry, as formulas without macros. Definitions that
    /// `[abbreviations]` takes from the file are left out. Reports an unknown label or a file that is not LaTeX, and
    /// returns `None`.
    pub fn equations_by_label(
        &mut self,
        item: &EntryTable<'a>,
        label: &Located,
        choice: LabelChoice,
    ) -> Option<Vec<Located>> {
        let mut list = self.all_labelled_equations(item, label, choice)?;
        let is_defined = |equation: &Located| {
            let left = self.name_of_labelled_equation(equation);
            left.is_some_and(|name| self.files.defined.contains(&name))
        };
        if !list.iter().all(is_defined) {
            list.retain(|equation| !is_defined(equation));
        }
        Some(list)
    }

    /// Formula of an abbreviation that is defined by an equation `name = formula` in the file at the top of the
    /// publication file. The table of the abbreviation, at `span` of the publication file, gives the label of the
    /// equation. `None` if an error is reported.
    pub fn labelled_definition(
        &mut self,
        name: &Located,
        table: &'a DeTable<'a>,
        span: Range<usize>,
    ) -> Option<Located> {
        let item = &EntryTable { table, what: "an abbreviation", span, notation: Notation::Latex };
        self.reader.report_unknown_keys(item.table, item.what, &["label"]);
        let label = self.reader.required(item.table, "label", item.what, &item.span)?;
        let label = self.reader.string(label, "`label`")?;
        let list = self.all_labelled_equations(item, &label, LabelChoice::Display)?;
        let named: Vec<&Located> = list
            .iter()
            .filter(|equation| self.name_of_labelled_equation(equation).is_some_and(|left| left == name.text))
            .collect();
        let [equation] = named[..] else {
            let what = if named.is_empty() { "no equation" } else { "more than one equation" };
            let message = format!(
                "{what} of `{}` has `{}` alone on its left side",
                shortened_for_message(&label.text),
                name.text
            );
            let help = "say in [symbols] which symbol stands for the abbreviation, or copy its formula";
            self.reader.error(label.span, message, help);
            return None;
        };
        let sides = sides(&equation.text, 0..equation.text.len(), item.notation);
        let [_, right] = &sides[..] else {
            let message = format!("`{}` is equal to more than one formula", name.text);
            self.reader.error(equation.span.clone(), message, "copy the formula that is meant");
            return None;
        };
        self.files.defined.push(name.text.clone());
        Some(entry_formula_part(equation, right.clone()))
    }

    /// Name that is alone on the left side of an equation, or has only arguments, as in `h(q) = …`. `None` if the left
    /// side is a formula or an unknown symbol.
    fn name_of_labelled_equation(&self, equation: &Located) -> Option<String> {
        let left = sides(&equation.text, 0..equation.text.len(), Notation::Latex).swap_remove(0);
        let left = equation.text[left].trim();
        let name = left.split_once('(').map_or(left, |(name, _)| name);
        self.words.name_of(name, Notation::Latex)
    }

    /// Equations with this label, including equations side by side in one line. `None` if an error is reported.
    fn all_labelled_equations(
        &mut self,
        item: &EntryTable<'a>,
        label: &Located,
        choice: LabelChoice,
    ) -> Option<Vec<Located>> {
        let Some(name) = self.file_of(item) else {
            self.reader.error(label.span.clone(), "a label of no file", "name the file: file = \"paper.tex\"");
            return None;
        };
        if notation_of_author_file(&name.text) != Some(Notation::Latex) {
            let help = "labels are of LaTeX files; name the variable of a program under `printed`";
            self.reader.error(
                label.span.clone(),
                format!("`{}` is no LaTeX file", shortened_for_message(&name.text)),
                help,
            );
            return None;
        }
        let (source, paper) = (self.read_source_file(&name)?, self.read_paper(&name)?);
        match paper.equations(label.text.trim(), choice) {
            Err(help) => {
                let message =
                    format!("no equation of `{}` has the label `{}`", name.text, shortened_for_message(&label.text));
                self.reader.error(label.span.clone(), message, help);
                None
            }
            Ok(Err(problem)) => {
                self.report_problem_in_named_file(Some(source), problem);
                None
            }
            Ok(Ok(list)) => {
                let list = list.into_iter().map(|formula| self.register_assembled_formula(&source, formula));
                let apart = |line: Located| {
                    let parts = equations(&line.text, Notation::Latex).into_iter();
                    parts.map(|range| entry_formula_part(&line, range)).collect::<Vec<_>>()
                };
                Some(list.flat_map(apart).collect())
            }
        }
    }
}
