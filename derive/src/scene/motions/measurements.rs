//! Tables of measured quantities, from CSV files.

use crate::csv_text::{csv_error_message, csv_head_span, csv_line_span};
use crate::diagnostic::{Diagnostic, Diagnostics, Source, nearest_name_advice, shortened_for_message};
use crate::model::TIME;
use std::ops::Range;

/// Largest number of rows of a table of measured quantities.
const MOST_ROWS: usize = 1_000_000;

/// Table of measured quantities: a head with names, and rows of cells.
#[derive(Clone, Debug)]
pub struct MeasuredTable {
    /// File of the table.
    source: Source,
    /// Names of the columns, in the order of the file.
    pub names: Vec<String>,
    /// Cells of each row as text, in the order of the names.
    rows: Vec<csv::StringRecord>,
}

impl MeasuredTable {
    /// Reads the head and the rows of a CSV file. Cells are read as numbers only when [`Self::column`] asks for them.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] with the first error of the file: no table, no rows, too many rows, rows of unequal
    /// length, or a name that two columns have.
    pub fn read(source: &Source) -> Result<Self, Diagnostics> {
        let wrong = |span: Range<usize>, message: String, help: &str| {
            Diagnostics::new(source.clone(), vec![Diagnostic::new(span, message, help)])
        };
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(source.text.as_bytes());
        let no_table = |error: csv::Error| {
            let place = error.position().map_or(0..0, |position| csv_line_span(source, position));
            wrong(place, csv_error_message(&error), "give a head with names, and rows of as many numbers")
        };
        let heads = reader.headers().map_err(no_table)?.clone();
        let names: Vec<String> = heads.iter().map(str::to_owned).collect();
        if let Some(twice) = names.iter().enumerate().find_map(|(at, name)| names[..at].contains(name).then_some(name))
        {
            let message = format!("two columns have the name `{twice}`");
            return Err(wrong(0..0, message, "give each column a name of its own"));
        }
        if names.len() == 1 && names[0].contains([';', '\t']) {
            let message = "the columns are not separated by commas".to_owned();
            return Err(wrong(csv_head_span(source), message, "separate the names and the numbers by commas"));
        }
        let rows = reader.records().take(MOST_ROWS + 1).collect::<Result<Vec<_>, _>>().map_err(no_table)?;
        if rows.is_empty() {
            return Err(wrong(0..0, "the table has no rows".to_owned(), "give a row for each instant"));
        }
        if rows.len() > MOST_ROWS {
            let message = format!("the table has more than {MOST_ROWS} rows");
            return Err(wrong(0..0, message, "leave rows out, or divide the table"));
        }
        Ok(Self { source: source.clone(), names, rows })
    }

    /// Number of rows of the table.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows.len()
    }

    /// True if the table has a column of this name.
    #[must_use]
    pub fn has(&self, name: &str) -> bool {
        self.names.iter().any(|known| known == name)
    }

    /// Numbers of the column with the given name, one for each row.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] if the table has no such column, or if a cell is no finite number.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, Diagnostics> {
        let Some(at) = self.names.iter().position(|known| known == name) else {
            let help = nearest_name_advice(name, self.names.iter().map(String::as_str));
            return Err(self.column_error(format!("the table has no column `{name}`"), help));
        };
        let number = |row: &csv::StringRecord| {
            let cell = row.get(at).unwrap_or_default();
            cell.parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(|| {
                let message = format!("the column `{name}` has no number here: `{}`", shortened_for_message(cell));
                let help = "give a finite number, or leave the row out".to_owned();
                self.error(self.row_span(row), message, help)
            })
        };
        self.rows.iter().map(number).collect()
    }

    /// Instants of the rows, s, from the column `t`. They increase from row to row.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] if the table has no column `t`, if a cell is no finite number, or if an instant is not
    /// after the instant before.
    pub fn instants(&self) -> Result<Vec<f64>, Diagnostics> {
        let t = self.column(TIME)?;
        if let Some(at) = (1..t.len()).find(|at| t[*at] <= t[at - 1]) {
            let message = format!("the time goes from {} s to {} s", t[at - 1], t[at]);
            let help = "put the rows in the order of time, each instant once".to_owned();
            return Err(self.error(self.row_span(&self.rows[at]), message, help));
        }
        Ok(t)
    }

    /// Error about a column, with a message and advice.
    #[must_use]
    pub fn column_error(&self, message: String, help: String) -> Diagnostics {
        self.error(csv_head_span(&self.source), message, help)
    }

    /// Place of a row in the text of the file.
    fn row_span(&self, row: &csv::StringRecord) -> Range<usize> {
        row.position().map_or(0..0, |position| csv_line_span(&self.source, position))
    }

    /// Error about a place of the file.
    fn error(&self, span: Range<usize>, message: String, help: String) -> Diagnostics {
        Diagnostics::new(self.source.clone(), vec![Diagnostic::new(span, message, help)])
    }
}
