//! Printed linear systems, and their reading. A system is printed as a matrix or as equations of motion.

use super::row_text::system_row_text;
use crate::algebra::solve::linear::{LinearForm, linear_row_term};
use crate::algebra::text::notation::Notation;
use crate::algebra::{Arena, Expr};
use crate::diagnostic::{Diagnostic, nearest_name_advice, shortened_for_message};
use crate::mechanics::Formulation;
use crate::publication::entries::EntryTable;
use crate::publication::printed::LabelChoice;
use crate::publication::publication_reader::PublicationReader;
use crate::toml_reader::Located;
use std::ops::Range;
use toml::Spanned;
use toml::de::DeValue;

/// Largest number of rows of a printed matrix.
const MAX_ROWS: usize = 500;

/// Mark that an error has been reported. It differs from `None`, which means that a key is absent.
struct ReportedError;

/// List of formulas as terms, and the list of their printed texts.
pub(in crate::publication) type Formulas = (Vec<Expr>, Vec<String>);
/// Entries of a printed matrix, row by row: first as terms, then as printed texts.
pub(in crate::publication) type Matrix = (Vec<Vec<Expr>>, Vec<Vec<String>>);

/// Requirements for a printed matrix: its width, and the symbols that its entries must not contain.
#[derive(Clone, Copy)]
pub(in crate::publication) struct MatrixRequirements<'a> {
    /// Number of entries in each row; `None` if rows of any equal length are allowed.
    pub(in crate::publication) columns: Option<usize>,
    /// Help text for an error in the number of columns.
    pub(in crate::publication) help: &'a str,
    /// Unknowns of the system, which no entry of the matrix may contain.
    pub(in crate::publication) unknowns: &'a [Expr],
    /// Notation in which the matrix entries are written.
    pub(in crate::publication) notation: Notation,
}

/// Printed linear system, matrix · unknowns = right, with any number of rows, and one column for each unknown.
#[derive(Clone, Debug)]
pub struct System {
    /// Formulation whose derived system is compared with the printed system.
    pub formulation: Formulation,
    /// Index of the frame of the components of a Newton–Euler system; `None` for other systems.
    pub frame: Option<usize>,
    /// Unknowns of the system, each once. They are u̇ for Kane, q̈ for Lagrange, u̇ and reactions for Newton–Euler.
    pub unknowns: Vec<Expr>,
    /// Names of the unknowns, in the order of `unknowns`.
    pub unknown_names: Vec<String>,
    /// Matrix of the printed system: one row for each equation, one column for each unknown.
    pub matrix: Vec<Vec<Expr>>,
    /// Printed texts of the matrix entries, row by row.
    pub matrix_texts: Vec<Vec<String>>,
    /// Right-hand sides of the printed system, one for each row.
    pub right: Vec<Expr>,
    /// Printed texts of the right-hand sides, one for each row.
    pub right_texts: Vec<String>,
    /// Printed texts of whole rows; `None` if the system is printed as a matrix.
    pub row_texts: Option<Vec<String>>,
    /// True if the system is a single printed equation, whose row has the id of the entry.
    pub is_single: bool,
    /// Template for the ids of matrix entries, with `{i}` for the row and `{j}` for the column. `None` if matrix
    /// entries have no ids.
    pub matrix_ids: Option<String>,
    /// Template for the ids of right-hand sides, with `{i}` for the row. `None` if right-hand sides have no ids.
    pub right_ids: Option<String>,
}

impl System {
    /// Id of the row with the index `row`, from 0; `id` is the id of the system's entry.
    #[must_use]
    pub fn row_id(&self, id: &str, row: usize) -> String {
        if self.is_single { id.to_owned() } else { format!("{id}-row{}", row + 1) }
    }

    /// Id of the matrix entry in `row` and `column`, both from 0; `None` if matrix entries have no ids.
    #[must_use]
    pub fn matrix_id(&self, row: usize, column: usize) -> Option<String> {
        let template = self.matrix_ids.as_ref()?;
        Some(template.replace("{i}", &(row + 1).to_string()).replace("{j}", &(column + 1).to_string()))
    }

    /// Id of the right-hand side of `row`, from 0; `None` if right-hand sides have no ids.
    #[must_use]
    pub fn right_id(&self, row: usize) -> Option<String> {
        Some(self.right_ids.as_ref()?.replace("{i}", &(row + 1).to_string()))
    }

    /// Ids of all rows, matrix entries and right-hand sides; `id` is the id of the system's entry.
    pub(in crate::publication) fn ids(&self, id: &str) -> Vec<String> {
        let mut ids: Vec<String> = (0..self.right.len()).map(|row| self.row_id(id, row)).collect();
        for row in 0..self.right.len() {
            ids.extend((0..self.unknowns.len()).filter_map(|column| self.matrix_id(row, column)));
        }
        ids.extend((0..self.right.len()).filter_map(|row| self.right_id(row)));
        ids
    }
}

impl<'a> PublicationReader<'a, '_> {
    /// Reads an entry `[[system]]`: a linear system matrix · unknowns = right, or equations that are linear in the
    /// unknowns. Returns `None` if an error is reported.
    pub fn read_system(&mut self, item: &EntryTable<'a>) -> Option<System> {
        let keys = ["equations", "label", "labels"];
        if keys.iter().any(|key| self.reader.get(item.table, key).is_some()) {
            return self.system_of_equations(item);
        }
        let formulation = self.read_system_formulation(item);
        let frame = self.read_system_frame(item, formulation);
        let unknowns = self.required_entry_array(item, "unknowns", "[\"u1'\", \"u2'\"]");
        let unknowns = unknowns.and_then(|(array, span)| {
            let mut known = self.own_accelerations(array);
            known.extend(formulation?.unknowns(self.model));
            let (what, of) = ("an unknown", formulation?.name());
            self.read_names_from_list(array, &span, &known, &format!("{what} of {of}"))
        });
        let columns = unknowns.as_ref().map(|(list, _)| list.len());
        let solved_for = unknowns.as_ref().map_or_else(Vec::new, |(list, _)| list.clone());
        let rows = self.required_entry_array(item, "matrix", "rows, as in [[\"m\", 0], [0, \"I\"]]");
        let row_count = rows.as_ref().map(|(array, _)| array.len());
        let fit = MatrixRequirements {
            columns,
            help: "one entry for each unknown",
            unknowns: &solved_for,
            notation: item.notation,
        };
        let matrix = rows.and_then(|(array, span)| self.read_system_matrix(array, &span, fit));
        let right = self.required_entry_array(item, "right", "[\"-m*g\", 0]");
        let right = right.and_then(|(array, span)| {
            if let Some(rows) = row_count.filter(|rows| *rows != array.len()) {
                let message = format!(
                    "`right` has {} for {}",
                    count_with_noun(array.len(), "entry"),
                    count_with_noun(rows, "row")
                );
                self.reader.error(span, message, "one right-hand side for each row of the matrix");
                return None;
            }
            self.read_system_formulas(array, "an entry of `right`", &[], item.notation)
        });
        let matrix_ids = self.read_system_id_template(item, "matrix_ids", &["{i}", "{j}"]);
        let right_ids = self.read_system_id_template(item, "right_ids", &["{i}"]);
        let ((unknowns, unknown_names), (matrix, matrix_texts), (right, right_texts)) = (unknowns?, matrix?, right?);
        let system = System {
            formulation: formulation?,
            frame: frame.ok()?,
            unknowns,
            unknown_names,
            matrix,
            matrix_texts,
            right,
            right_texts,
            row_texts: None,
            is_single: false,
            matrix_ids: matrix_ids.ok()?,
            right_ids: right_ids.ok()?,
        };
        Some(self.move_unknowns_to_matrix(system, item))
    }

    /// Moves unknowns from the right-hand sides of a system to its matrix. Accelerations of the publication's own
    /// coordinates are expressed in those of the model.
    fn move_unknowns_to_matrix(&mut self, system: System, item: &EntryTable<'a>) -> System {
        let arena = &mut self.model.arena;
        let parts = arena.reachable(&system.right);
        let is_plain = |u: &Expr| arena.symbol_name(*u).is_some() && parts.binary_search(u).is_err();
        if system.unknowns.iter().all(is_plain) {
            return system;
        }
        let known = system.formulation.unknowns(self.model);
        let arena = &mut self.model.arena;
        let symbols: Vec<Expr> = known.iter().map(|(_, symbol)| *symbol).collect();
        let mut form = LinearForm::new(&symbols);
        let (mut matrix, mut rests) = (Vec::new(), Vec::new());
        for (row, right) in system.matrix.iter().zip(&system.right) {
            let residual = linear_row_term(arena, &system.unknowns, &[&row[..], &[*right]].concat());
            let (entries, rest) = system_row_coefficients(&mut form, arena, residual);
            matrix.push(entries);
            rests.push(arena.neg(rest));
        }
        let row = |at: usize| {
            let (entries, right) = (&system.matrix_texts[at], &system.right_texts[at]);
            system_row_text(entries, &system.unknown_names, right, item.notation)
        };
        let row_texts = (0..matrix.len()).map(row).collect();
        let (names, unknowns) = known.into_iter().unzip();
        let row_texts = Some(row_texts);
        System { unknowns, unknown_names: names, matrix, right: rests, row_texts, matrix_ids: None, ..system }
    }

    /// Reads a system that is printed as equations. Each must be linear in accelerations and reactions. Returns `None`
    /// if an error is reported.
    fn system_of_equations(&mut self, item: &EntryTable<'a>) -> Option<System> {
        for key in ["matrix", "right", "matrix_ids", "right_ids"] {
            if let Some(value) = self.reader.get(item.table, key) {
                let help = "a system is either `equations`, or `unknowns`, `matrix` and `right`";
                self.reader.error(value.span(), format!("`{key}` beside `equations`"), help);
            }
        }
        let formulation = self.read_system_formulation(item);
        let frame = self.read_system_frame(item, formulation);
        let equations = self.read_system_equations(item)?;
        let residuals: Vec<Option<(Expr, String)>> = equations
            .into_iter()
            .map(|formula| {
                let residual = self.system_row_residual(&formula, item.notation)?;
                Some((residual, formula.text))
            })
            .collect();
        let residuals = residuals.into_iter().collect::<Option<Vec<_>>>()?;
        self.check_system_unknowns(item, formulation?, &residuals)?;
        Some(self.system_of_residuals(formulation?, frame.ok()?, residuals))
    }

    /// Equations of a system: the equations under the key `equations`, or labelled equations of a file. A single
    /// `label` means all equations of the LaTeX environment that contains the label. `None` if an error is reported.
    fn read_system_equations(&mut self, item: &EntryTable<'a>) -> Option<Vec<Located>> {
        let stated: Vec<&str> =
            ["equations", "label", "labels"].into_iter().filter(|k| self.reader.get(item.table, k).is_some()).collect();
        if let [_, second, ..] = stated[..] {
            let span = self.reader.get(item.table, second).map_or_else(|| item.span.clone(), Spanned::span);
            let help = "give equations here as `printed`, or give labels of a file, not both";
            self.reader.error(span, format!("`{second}` beside `{}`", stated[0]), help);
            return None;
        }
        if let Some(label) = self.reader.get(item.table, "label") {
            let label = self.reader.string(label, "`label`")?;
            return self.equations_by_label(item, &label, LabelChoice::Display);
        }
        if self.reader.get(item.table, "labels").is_some() {
            let (array, _) = self.required_entry_array(item, "labels", "[\"eq:1\", \"eq:2\"]")?;
            let labels: Vec<_> = array.iter().map(|value| self.reader.string(value, "a label")).collect();
            let found = labels.into_iter().map(|label| self.equations_by_label(item, &label?, LabelChoice::Labelled));
            let found: Vec<_> = found.collect();
            return Some(found.into_iter().collect::<Option<Vec<_>>>()?.concat());
        }
        let (array, _) = self.required_entry_array(item, "equations", "[\"m*x'' = -k*x\"]")?;
        let list: Vec<_> = array.iter().map(|value| self.reader.formula(value, "an equation")).collect();
        list.into_iter().collect()
    }

    /// Checks the `unknowns` that are given with equations: they must belong to the formulation, and the equations must
    /// contain no others. Reports an error and returns `None` if the check fails.
    fn check_system_unknowns(
        &mut self,
        item: &EntryTable<'a>,
        formulation: Formulation,
        residuals: &[(Expr, String)],
    ) -> Option<()> {
        if self.reader.get(item.table, "unknowns").is_none() {
            return Some(());
        }
        let (array, span) = self.required_entry_array(item, "unknowns", "[\"u1'\", \"u2'\"]")?;
        let known = formulation.unknowns(self.model);
        let mut names = self.own_accelerations(array);
        let has_own = !names.is_empty();
        names.extend(known.clone());
        let (stated, _) =
            self.read_names_from_list(array, &span, &names, &format!("an unknown of {}", formulation.name()))?;
        let all: Vec<Expr> = residuals.iter().map(|(e, _)| *e).collect();
        let parts = self.model.arena.reachable(&all);
        let other = |(_, symbol): &&(String, Expr)| parts.binary_search(symbol).is_ok() && !stated.contains(symbol);
        if let Some((name, _)) = known.iter().find(other).filter(|_| !has_own) {
            let message = format!("the equations contain the unknown `{name}`, too");
            self.reader.error(span, message, "list this symbol among `unknowns`, or leave `unknowns` out");
            return None;
        }
        Some(())
    }

    /// Reads an equation of motion `left = right`, or a formula that is zero, as a system with one row. If the entry
    /// gives no formulation, the unknowns in the equation determine it. `None` if an error is reported.
    pub fn system_of_motion_equation(&mut self, item: &EntryTable<'a>, formula: &Located) -> Option<System> {
        let residual = self.system_row_residual(formula, item.notation)?;
        let formulation = match self.reader.get(item.table, "formulation") {
            Some(_) => self.read_system_formulation(item)?,
            None => self.formulation_of(residual),
        };
        self.single_row(item, formulation, residual, formula.text.clone())
    }

    /// Formulation and symbol of the reaction or multiplier with the name `name`; `None` for any
    /// other name.
    pub fn system_unknown_by_name(&self, name: &str) -> Option<(Formulation, Expr)> {
        let reaction = self.model.reactions.iter().find(|r| r.name == name).map(|r| r.symbol);
        let is_named = |m: &Expr| self.model.arena.symbol_name(*m) == Some(name);
        let multiplier = self.model.motion_constraints.iter().map(|c| c.multiplier).find(is_named);
        let found = reaction.map(|symbol| (Formulation::NewtonEuler, symbol));
        found.or(multiplier.map(|symbol| (Formulation::Lagrange, symbol)))
    }

    /// Reads a printed value of a reaction or a multiplier as the equation value − symbol = 0, a system with one row.
    /// `None` if an error is reported.
    pub fn value_of_unknown(
        &mut self,
        item: &EntryTable<'a>,
        unknown: (Formulation, Expr),
        value: &Located,
    ) -> Option<System> {
        let (formulation, symbol) = unknown;
        let right = self.formula(value, item.notation)?;
        // With value − symbol, the signs in the description of a mistake are those of the printed value.
        let residual = self.model.arena.sub(right, symbol);
        self.words.shorthand.record_difference(&self.model.arena, residual, right, symbol);
        self.single_row(item, formulation, residual, value.text.clone())
    }

    /// Creates the system of one equation residual = 0. Components need a frame only if the equation has several
    /// unknowns: an equation for one unknown is the same in all frames. `None` if an error is reported.
    fn single_row(
        &mut self,
        item: &EntryTable<'a>,
        formulation: Formulation,
        residual: Expr,
        text: String,
    ) -> Option<System> {
        let parts = self.model.arena.reachable(&[residual]);
        let unknowns = formulation.unknowns(self.model);
        let count = unknowns.iter().filter(|(_, unknown)| parts.binary_search(unknown).is_ok()).count();
        let needs_none = count == 1 && formulation.has_reactions();
        let frame = match self.reader.get(item.table, "frame") {
            None if needs_none => Some(0),
            _ => self.read_system_frame(item, Some(formulation)).ok()?,
        };
        let system = self.system_of_residuals(formulation, frame, vec![(residual, text)]);
        Some(System { is_single: true, ..system })
    }

    /// Formulation that fits the unknowns in an equation: Newton–Euler for reactions, Kane for u̇, else Lagrange.
    fn formulation_of(&self, residual: Expr) -> Formulation {
        let parts = self.model.arena.reachable(&[residual]);
        let mentions = |symbol: Expr| parts.binary_search(&symbol).is_ok();
        if self.model.reactions.iter().any(|r| mentions(r.symbol)) {
            Formulation::NewtonEuler
        } else if self.model.speeds.iter().any(|s| mentions(s.rate)) {
            Formulation::Kane
        } else {
            Formulation::Lagrange
        }
    }

    /// Difference left − right of an equation, or the whole formula if it has no `=`. Reports a second `=` and returns
    /// `None`.
    fn system_row_residual(&mut self, formula: &Located, notation: Notation) -> Option<Expr> {
        let mut places = formula.text.match_indices('=').map(|(at, _)| at);
        let (first, second) = (places.next(), places.next());
        if let Some(second) = second {
            let help = "a chain a = b = c is two entries";
            self.reader.error(formula.part(second..second + 1), "a second `=` in one equation", help);
            return None;
        }
        let Some(at) = first else { return self.formula(formula, notation) };
        let part = |range: Range<usize>| Located {
            text: formula.text[range.clone()].to_owned(),
            span: formula.part(range),
            exact: formula.exact,
        };
        let (left, right) = (part(0..at), part(at + 1..formula.text.len()));
        let (left, right) = (self.formula(&left, notation), self.formula(&right, notation));
        let (left, right) = (left?, right?);
        let residual = self.model.arena.sub(left, right);
        self.words.shorthand.record_difference(&self.model.arena, residual, left, right);
        Some(residual)
    }

    /// Builds a system from equations residual = 0, each with its printed text. `frame` is the index of the frame for
    /// components; `None` for formulations without components.
    fn system_of_residuals(
        &mut self,
        formulation: Formulation,
        frame: Option<usize>,
        residuals: Vec<(Expr, String)>,
    ) -> System {
        let (unknown_names, unknowns): (Vec<String>, Vec<Expr>) = formulation.unknowns(self.model).into_iter().unzip();
        let mut form = LinearForm::new(&unknowns);
        let (mut matrix, mut right, mut texts) = (Vec::new(), Vec::new(), Vec::new());
        for (residual, text) in residuals {
            let arena = &mut self.model.arena;
            let (entries, rest) = system_row_coefficients(&mut form, arena, residual);
            let negative = arena.neg(rest);
            self.words.shorthand.record_row(arena, residual, &unknowns, &[&entries[..], &[negative]].concat());
            matrix.push(entries);
            right.push(negative);
            texts.push(text);
        }
        System {
            formulation,
            frame,
            matrix_texts: vec![vec![String::new(); unknowns.len()]; matrix.len()],
            unknowns,
            unknown_names,
            matrix,
            right_texts: vec![String::new(); right.len()],
            right,
            row_texts: Some(texts),
            is_single: false,
            matrix_ids: None,
            right_ids: None,
        }
    }

    /// Reads the formulation of an entry. Reports an unknown name and returns `None`.
    pub(in crate::publication) fn read_system_formulation(&mut self, item: &EntryTable<'a>) -> Option<Formulation> {
        let name = self.required_entry_text(item, "formulation")?;
        let standard = Formulation::STANDARD;
        let found = Formulation::from_name(&name.text).filter(|formulation| standard.contains(formulation));
        if found.is_none() {
            let help = nearest_name_advice(&name.text, standard.map(Formulation::name));
            self.reader.error(
                name.span,
                format!("there is no formulation `{}`", shortened_for_message(&name.text)),
                help,
            );
        }
        found
    }

    /// Reads the index of the frame for the components of a Newton–Euler system; `None` for systems of other
    /// formulations. The error means that an unsuitable frame has been reported.
    fn read_system_frame(
        &mut self,
        item: &EntryTable<'a>,
        formulation: Option<Formulation>,
    ) -> Result<Option<usize>, ReportedError> {
        if !formulation.ok_or(ReportedError)?.has_reactions() {
            let Some(value) = self.reader.get(item.table, "frame") else { return Ok(None) };
            let message = "only a newton-euler system has a `frame`";
            self.reader.error(value.span(), message, "remove it: generalized forces have no components");
            return Err(ReportedError);
        }
        let name = self.required_entry_text(item, "frame").ok_or(ReportedError)?;
        let found = self.model.frames.iter().position(|f| f.name == name.text);
        if found.is_none() {
            let help = nearest_name_advice(&name.text, self.model.frames.iter().map(|f| f.name.as_str()));
            self.reader.error(
                name.span,
                format!("the model has no frame `{}`", shortened_for_message(&name.text)),
                help,
            );
        }
        found.map(Some).ok_or(ReportedError)
    }

    /// Reads a list of names from `known`: at least one, and each at most once. Returns their symbols and names.
    /// Reports an unknown or repeated name and returns `None`. `what` describes the names in messages.
    pub(in crate::publication) fn read_names_from_list(
        &mut self,
        array: &'a [Spanned<DeValue<'a>>],
        span: &Range<usize>,
        known: &[(String, Expr)],
        what: &str,
    ) -> Option<Formulas> {
        if array.is_empty() || array.len() > known.len() {
            let message = format!("{} here, where the model has {}", count_with_noun(array.len(), "name"), known.len());
            let names: Vec<&str> = known.iter().take(20).map(|(n, _)| n.as_str()).collect();
            self.reader.error(span.clone(), message, format!("choose from {}", names.join(", ")));
            return None;
        }
        let mut found: Vec<(Expr, Located)> = Vec::new();
        let mut complete = true;
        for value in array {
            let Some(name) = self.reader.string(value, "a name") else {
                complete = false;
                continue;
            };
            let Some((_, symbol)) = known.iter().find(|(n, _)| *n == name.text) else {
                let help = nearest_name_advice(&name.text, known.iter().map(|(n, _)| n.as_str()));
                self.reader.error(name.span, format!("`{}` is not {what}", shortened_for_message(&name.text)), help);
                complete = false;
                continue;
            };
            if let Some((_, first)) = found.iter().find(|(e, _)| e == symbol) {
                let message = format!("`{}` is named twice", name.text);
                let twice = Diagnostic::new(name.span, message, "name each once");
                self.reader.errors.push(twice.with_other(first.span.clone(), "first named here"));
                complete = false;
                continue;
            }
            found.push((*symbol, name));
        }
        complete.then(|| found.into_iter().map(|(e, name)| (e, name.text)).unzip())
    }

    /// Reads formulas, which must not contain any of the `unknowns`; `None` if an error is reported.
    pub(in crate::publication) fn read_system_formulas(
        &mut self,
        array: &'a [Spanned<DeValue<'a>>],
        what: &str,
        unknowns: &[Expr],
        notation: Notation,
    ) -> Option<Formulas> {
        let read = array.iter().map(|value| {
            let formula = self.reader.formula(value, what)?;
            let e = self.formula(&formula, notation)?;
            self.report_unknown_in_system(e, &formula, what, unknowns)?;
            Some((e, formula.text))
        });
        // All formulas are read before the first error ends the reading, so that all errors are reported.
        let read: Vec<Option<_>> = read.collect();
        read.into_iter().collect::<Option<Vec<_>>>().map(|list| list.into_iter().unzip())
    }

    /// Reports a formula that contains an unknown of its system, and returns `None`. A system matrix · unknowns = right
    /// must be linear as printed.
    fn report_unknown_in_system(&mut self, e: Expr, formula: &Located, what: &str, unknowns: &[Expr]) -> Option<()> {
        let arena = &self.model.arena;
        let parts = arena.reachable(&[e]);
        let Some(unknown) = unknowns.iter().find(|u| parts.binary_search(u).is_ok()) else { return Some(()) };
        let name = arena.symbol_name(*unknown).unwrap_or_default();
        let message = format!("{what} contains the unknown `{name}`");
        let help =
            format!("a row reads Σ entry·unknown = right: put the factor of `{name}` into its column of the matrix");
        self.reader.error_once(formula.span.clone(), message, help);
        None
    }

    /// Reads a matrix whose rows have the same number of formulas; `None` if an error is reported.
    pub(in crate::publication) fn read_system_matrix(
        &mut self,
        array: &'a [Spanned<DeValue<'a>>],
        span: &Range<usize>,
        fit: MatrixRequirements<'_>,
    ) -> Option<Matrix> {
        if array.is_empty() || array.len() > MAX_ROWS {
            let message = format!("a matrix of {}", count_with_noun(array.len(), "row"));
            self.reader.error(span.clone(), message, format!("a matrix has 1 to {MAX_ROWS} rows"));
            return None;
        }
        let MatrixRequirements { mut columns, help, unknowns, notation } = fit;
        let mut rows = Vec::new();
        for (at, value) in array.iter().enumerate() {
            let what = format!("row {} of the matrix", at + 1);
            let row = self.require_array(value, &what, "a row as an array, such as [\"m\", 0]").and_then(|row| {
                if *columns.get_or_insert(row.len()) == row.len() {
                    return self.read_system_formulas(row, "an entry of the matrix", unknowns, notation);
                }
                let expected = columns.unwrap_or_default();
                let message = format!("{what} has {}, not {expected}", count_with_noun(row.len(), "entry"));
                self.reader.error(value.span(), message, help);
                None
            });
            rows.push(row);
        }
        rows.into_iter().collect::<Option<Vec<_>>>().map(|rows| rows.into_iter().unzip())
    }

    /// Reads a template for ids, which contains marks for the row and the column. `None` if the key is absent. The
    /// error means that an unsuitable template has been reported.
    fn read_system_id_template(
        &mut self,
        item: &EntryTable<'a>,
        key: &str,
        marks: &[&str],
    ) -> Result<Option<String>, ReportedError> {
        let Some(value) = self.reader.get(item.table, key) else { return Ok(None) };
        let template = self.reader.string(value, &format!("`{key}`")).ok_or(ReportedError)?;
        if let Some(missing) = marks.iter().find(|mark| !template.text.contains(**mark)) {
            let help = format!("write the row as {{i}}{}", if marks.len() > 1 { " and the column as {j}" } else { "" });
            self.reader.error(template.span, format!("`{key}` has no {missing}: its ids would be the same"), help);
            return Err(ReportedError);
        }
        Ok(Some(template.text))
    }
}

/// Coefficients of the unknowns in an equation, and its remainder without unknowns. If the equation is not linear in
/// the unknowns, all coefficients are 0 and the remainder is the whole equation. It is then judged as printed.
fn system_row_coefficients(form: &mut LinearForm, arena: &mut Arena, equation: Expr) -> (Vec<Expr>, Expr) {
    match form.coefficients(arena, equation) {
        Ok(found) => found,
        Err(_) => (vec![Expr::ZERO; form.symbols().len()], equation),
    }
}

/// Number with its noun in the singular or plural, such as "2 entries".
pub(in crate::publication) fn count_with_noun(n: usize, noun: &str) -> String {
    match (n, noun.strip_suffix('y')) {
        (1, _) => format!("1 {noun}"),
        (_, Some(stem)) => format!("{n} {stem}ies"),
        _ => format!("{n} {noun}s"),
    }
}
