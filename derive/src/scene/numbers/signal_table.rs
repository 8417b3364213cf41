//! Tables of measured or planned signals, converted into formulas of time.
//!
//! Between two rows a table is a polynomial. The formula adds up the changes of the signal in all intervals. The
//! change in an interval depends only on the time spent in it, so no large numbers are subtracted.

#[cfg(feature = "files")]
use crate::csv_text::csv_error_message;
use nalgebra::{DMatrix, DVector};
use std::fmt::Write;
use std::path::Path;

/// Largest number of rows of a table of signals.
const MOST_ROWS: usize = 250;

/// Interpolation of a signal table between its rows.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// Interpolation by straight lines between the rows.
    Linear,
    /// Interpolation by a cubic spline with two continuous derivatives. The third derivative is continuous at the
    /// second row and at the last but one: not-a-knot (C. de Boor, *A Practical Guide to Splines* (1978), chapter
    /// IV).
    Cubic,
}

/// Message about a signal table that cannot be used, with advice.
type TableError = (String, String);

/// Formula in t, as text, of a column of a CSV file. `columns` are the names of the time column and of the signal
/// column. `span` is the time that the run covers, s. Returns a message if the table cannot be read or does not cover
/// the run.
pub fn signal_table_formula(
    path: &Path,
    columns: [&str; 2],
    how: Interpolation,
    span: (f64, f64),
) -> Result<String, TableError> {
    let rows = read_signal_rows(path, columns)?;
    let (Some(first), Some(last)) = (rows.first(), rows.last()) else {
        return Err(("the table has no rows".to_owned(), "give at least two".to_owned()));
    };
    let least = if how == Interpolation::Cubic { 4 } else { 2 };
    if rows.len() < least || rows.len() > MOST_ROWS {
        let message = format!("the table has {} rows", rows.len());
        return Err((message, format!("give between {least} and {MOST_ROWS}")));
    }
    if let Some(pair) = rows.windows(2).find(|pair| pair[0].0 >= pair[1].0) {
        let message = format!("the instants of the table do not increase: {} comes before {}", pair[0].0, pair[1].0);
        return Err((message, "sort the rows by time, each instant once".to_owned()));
    }
    if span.0 < first.0 || span.1 > last.0 {
        let message =
            format!("the table goes from {} s to {} s, but the run from {} s to {} s", first.0, last.0, span.0, span.1);
        return Err((message, "add rows, or shorten `span`".to_owned()));
    }
    Ok(formula(&rows, how))
}

/// Refuses every table by a message, since this build cannot read files.
#[cfg(not(feature = "files"))]
fn read_signal_rows(_: &Path, _: [&str; 2]) -> Result<Vec<(f64, f64)>, TableError> {
    Err(("no file can be read here".to_owned(), "give a formula".to_owned()))
}

/// Reads the rows (instant, value) from two columns of a CSV file. Returns a message if that fails.
#[cfg(feature = "files")]
fn read_signal_rows(path: &Path, columns: [&str; 2]) -> Result<Vec<(f64, f64)>, TableError> {
    let text = crate::diagnostic::Source::read(path).map_err(|error| {
        let why = error.list.first().map_or_else(String::new, |error| error.message.clone());
        (
            format!("the table cannot be read: {why}"),
            "give a CSV file, its path from the folder of the scene".to_owned(),
        )
    })?;
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.text.as_bytes());
    let wrong = |error: csv::Error| {
        let line = error.position().map_or(1, csv::Position::line);
        (
            format!("line {line} of the table: {}", csv_error_message(&error)),
            "give a head and rows of as many numbers".to_owned(),
        )
    };
    let heads = reader.headers().map_err(wrong)?.clone();
    let place = |name: &str| {
        heads.iter().position(|head| head == name).ok_or_else(|| {
            (format!("the table has no column `{name}`"), crate::diagnostic::nearest_name_advice(name, heads.iter()))
        })
    };
    let [time, column] = [place(columns[0])?, place(columns[1])?];
    let mut rows = Vec::new();
    for (at, record) in reader.records().enumerate() {
        let record = record.map_err(wrong)?;
        let number = |place: usize| {
            let cell = record.get(place).unwrap_or_default();
            cell.parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(|| {
                (
                    format!(
                        "row {} of the table has no number: `{}`",
                        at + 1,
                        crate::diagnostic::shortened_for_message(cell)
                    ),
                    "give a number".to_owned(),
                )
            })
        };
        rows.push((number(time)?, number(column)?));
    }
    Ok(rows)
}

/// Formula f(t₁) + Σ p_k(τ_k) of a signal table, as text. Here τ_k = (|t − t_k| − |t − t_k₊₁| + h_k)/2 is the time
/// spent in interval k.
fn formula(rows: &[(f64, f64)], how: Interpolation) -> String {
    let slopes = if how == Interpolation::Cubic { spline_slopes(rows) } else { Vec::new() };
    let mut text = number(rows[0].1);
    for (at, pair) in rows.windows(2).enumerate() {
        let [(a, from), (b, to)] = [pair[0], pair[1]];
        let (h, rise) = (b - a, (to - from) / (b - a));
        let clock = format!("((abs(t - {}) - abs(t - {}) + {})/2)", number(a), number(b), number(h));
        // Writing to a string cannot fail.
        let _ = match slopes.get(at..at + 2) {
            None => write!(text, " + {}*{clock}", number(rise)),
            Some(ends) => {
                let square = (3.0 * rise - 2.0 * ends[0] - ends[1]) / h;
                let cube = (ends[0] + ends[1] - 2.0 * rise) / (h * h);
                let [slope, square, cube] = [ends[0], square, cube].map(number);
                write!(text, " + {slope}*{clock} + {square}*{clock}^2 + {cube}*{clock}^3")
            }
        };
    }
    text
}

/// Exact text of a double, as a whole number divided by a power of 2. With powers of 2, denominators do not grow in
/// sums.
fn number(x: f64) -> String {
    let (mut whole, mut twos) = (x, 0);
    while whole.fract() != 0.0 {
        (whole, twos) = (2.0 * whole, twos + 1);
    }
    if twos == 0 { format!("({whole})") } else { format!("({whole}/2^{twos})") }
}

/// Slopes of the not-a-knot spline at the rows of a table with at least four rows.
fn spline_slopes(rows: &[(f64, f64)]) -> Vec<f64> {
    let n = rows.len();
    let h: Vec<f64> = rows.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
    let rise: Vec<f64> = rows.windows(2).zip(&h).map(|(pair, h)| (pair[1].1 - pair[0].1) / h).collect();
    let mut matrix = DMatrix::zeros(n, n);
    let mut right = DVector::zeros(n);
    for k in 1..n - 1 {
        (matrix[(k, k - 1)], matrix[(k, k + 1)]) = (1.0 / h[k - 1], 1.0 / h[k]);
        matrix[(k, k)] = 2.0 * (1.0 / h[k - 1] + 1.0 / h[k]);
        right[k] = 3.0 * (rise[k - 1] / h[k - 1] + rise[k] / h[k]);
    }
    // Not-a-knot condition: the spline is the same cubic on both sides of the second row, and on both sides of the
    // last row but one.
    for (row, k) in [(0, 0), (n - 1, n - 3)] {
        let (one, two) = (1.0 / (h[k] * h[k]), 1.0 / (h[k + 1] * h[k + 1]));
        (matrix[(row, k)], matrix[(row, k + 1)], matrix[(row, k + 2)]) = (one, one - two, -two);
        right[row] = 2.0 * (rise[k] * one - rise[k + 1] * two);
    }
    let slopes = matrix.lu().solve(&right).expect("a spline through different instants is one");
    slopes.iter().copied().collect()
}

#[cfg(test)]
mod tests {
    use super::{Interpolation, formula, spline_slopes};

    #[test]
    fn a_cubic_is_its_own_spline() {
        let cubic = |t: f64| 2.0 - t + 0.5 * t * t - 0.25 * t * t * t;
        let rows = [-1.0, 0.0, 0.5, 2.0, 2.25, 4.0].map(|t| (t, cubic(t)));
        for ((t, _), slope) in rows.iter().zip(spline_slopes(&rows)) {
            assert!((slope - (-1.0 + t - 0.75 * t * t)).abs() < 1e-13, "{t}: {slope}");
        }
    }

    #[test]
    fn lines_are_written_as_they_are() {
        assert_eq!(
            formula(&[(0.5, 1.0), (2.5, 5.0)], Interpolation::Linear),
            "(1) + (2)*((abs(t - (1/2^1)) - abs(t - (5/2^1)) + (2))/2)"
        );
    }
}
