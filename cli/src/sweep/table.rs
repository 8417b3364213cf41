//! Table of a sweep as CSV text.
//!
//! Invariant: a number is written as the shortest text that reads back as the same `f64`.

use tripos::studies::sweep::{NO_START, Sweep, SweepRow};

/// Columns of the table of a sweep.
pub struct Columns {
    /// Names of the sweep table's columns, in order.
    names: Vec<String>,
    /// Index of the column with the stop code.
    stop: usize,
    /// Number of columns with values at the end of a run.
    states: usize,
    /// Number of columns with changes of first integrals.
    changes: usize,
    /// True if there is a column with the number of correct digits.
    tells_digits: bool,
}

impl Columns {
    /// Returns the columns for a sweep: `index`, `over:NAME` for each varied number, `t_end`, `stop`, and the values at
    /// the end. The following columns are `steps`, `rejected`, `evaluations`, the change of each first integral,
    /// `digits` if requested, `warning` and `reason`.
    pub fn new(sweep: &Sweep<'_>) -> Self {
        let states = sweep.names.clone();
        let changes: Vec<String> = sweep.conserved_names().iter().map(|name| format!("change of {name}")).collect();
        let fixed = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
        let swept: Vec<String> = sweep.grid.names().into_iter().map(|name| format!("over:{name}")).collect();
        // The columns before `stop` are the index, the varied values and `t_end`.
        let stop = swept.len() + 2;
        let counts = [states.len(), changes.len()];
        let names = [
            fixed(&["index"]),
            swept,
            fixed(&["t_end", "stop"]),
            states,
            fixed(&["steps", "rejected", "evaluations"]),
            changes,
            fixed(if sweep.tells_digits { &["digits"] } else { &[] }),
            fixed(&["warning", "reason"]),
        ];
        Self { names: names.concat(), stop, states: counts[0], changes: counts[1], tells_digits: sweep.tells_digits }
    }

    /// Returns a name that two columns share; `None` if all names differ. A scene may choose any name for an output.
    pub fn duplicate_column_name(&self) -> Option<&str> {
        let is_twice = |(at, name): &(usize, &String)| self.names[..*at].contains(name);
        self.names.iter().enumerate().find(is_twice).map(|(_, name)| name.as_str())
    }

    /// Returns the number of columns of the sweep's table.
    pub fn count(&self) -> usize {
        self.names.len()
    }

    /// Returns the name of the first column of a row in which text stands for a number; `None` if there is none. Cells
    /// may be empty.
    pub fn first_without_number(&self, row: &csv::StringRecord) -> Option<&str> {
        let is_number = |cell: &str| cell.is_empty() || cell.parse::<f64>().is_ok();
        let has_text = |at: usize| at == self.stop || at + 2 >= self.names.len();
        let mut cells = row.iter().zip(&self.names).enumerate();
        cells.find(|(at, (cell, _))| !has_text(*at) && !is_number(cell)).map(|(_, (_, name))| name.as_str())
    }

    /// Returns the index of the column with the stop code.
    pub fn stop_column_index(&self) -> usize {
        self.stop
    }

    /// Returns the first line of the table, with the names of the columns.
    pub fn header(&self) -> Vec<u8> {
        lines([self.names.clone()].into_iter())
    }

    /// Returns the lines of the table for these rows, as CSV.
    pub fn lines(&self, rows: &[SweepRow]) -> Vec<u8> {
        lines(rows.iter().map(|row| self.fields(row)))
    }

    /// Returns the fields of a row, as texts.
    fn fields(&self, row: &SweepRow) -> Vec<String> {
        let numbers = |list: &[f64]| list.iter().map(|x| sweep_number_text(*x)).collect::<Vec<String>>();
        let nothing = |count: usize| vec![String::new(); count];
        let mut fields = vec![row.point.to_string()];
        fields.extend(numbers(&row.values));
        match &row.outcome {
            Ok(ended) => {
                fields.extend([sweep_number_text(ended.t_end), ended.stop.clone()]);
                fields.extend(numbers(&ended.shown));
                fields.extend([ended.steps, ended.rejected, ended.evaluations].map(|n| n.to_string()));
                fields.extend(numbers(&ended.changes));
                if self.tells_digits {
                    fields.push(ended.digits.map_or_else(String::new, |digits| format!("{digits:.1}")));
                }
            }
            Err(_) => {
                fields.extend([String::new(), NO_START.to_owned()]);
                fields.extend(nothing(self.states + 3 + self.changes + usize::from(self.tells_digits)));
            }
        }
        fields.extend([row.warning(), row.failure()].map(|text| text.unwrap_or_default().to_owned()));
        fields
    }
}

/// Writes records as lines of CSV.
fn lines(records: impl Iterator<Item = Vec<String>>) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for record in records {
        writer.write_record(record).expect("memory takes every record, and all have one length");
    }
    writer.into_inner().expect("memory takes everything")
}

/// Returns the shortest decimal text that reads back as the same `f64`: `0.01`, `1e-3`, `NaN`.
pub fn sweep_number_text(x: f64) -> String {
    // For numbers of this size with a fraction, text with an exponent is never shorter.
    if x.is_finite() && x.abs() >= 0.01 && x.fract().abs() > 0.0 {
        return x.to_string();
    }
    let (plain, scientific) = (x.to_string(), format!("{x:e}"));
    if scientific.len() < plain.len() { scientific } else { plain }
}

#[cfg(test)]
mod tests {
    use super::sweep_number_text;

    #[test]
    fn numbers_are_short_and_read_back() {
        for (x, text) in [
            (0.1, "0.1"),
            (0.01, "0.01"),
            (1e-3, "1e-3"),
            (0.0012, "0.0012"),
            (1e-7, "1e-7"),
            (1e5, "1e5"),
            (0.0, "0"),
            (1e300, "1e300"),
            (1500.0, "1500"),
            (-0.0, "-0"),
            (5e-324, "5e-324"),
            (0.1 + 0.2, "0.30000000000000004"),
            (f64::MAX, "1.7976931348623157e308"),
            (f64::NAN, "NaN"),
            (f64::NEG_INFINITY, "-inf"),
        ] {
            assert_eq!(sweep_number_text(x), text);
            let back: f64 = text.parse().unwrap();
            assert!(back.to_bits() == x.to_bits() || x.is_nan());
        }
        for k in 0..100_000_u64 {
            let x = f64::from_bits(k.wrapping_mul(0x9E37_79B9_7F4A_7C15));
            let text = sweep_number_text(x);
            assert!(text.len() <= x.to_string().len().min(format!("{x:e}").len()), "{text}");
        }
    }
}
