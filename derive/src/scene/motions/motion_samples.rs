//! Motion samples in CSV tables: a row for each instant, and a column for each coordinate, speed and acceleration.

use super::prescribed_motion::MotionSample;
use crate::csv_text::{csv_error_message, csv_head_span, csv_line_span};
use crate::diagnostic::{Diagnostic, Diagnostics, Source, nearest_name_advice, shortened_for_message};
use crate::model::{Model, TIME};
use std::ops::Range;
use tripos_traits::DoubleDouble;

/// Reads samples of a motion from a CSV file. Columns have the model's names of q, u and u'; a column `t` is
/// optional. Other columns are ignored. Values are in SI units.
///
/// # Errors
/// Returns [`Diagnostics`] with the first error of the CSV file.
pub fn load_samples(source: &Source, model: &Model) -> Result<Vec<MotionSample>, Diagnostics> {
    let wrong = |place: Range<usize>, message: String, help: String| {
        Diagnostics::new(source.clone(), vec![Diagnostic::new(place, message, help)])
    };
    let head = csv_head_span(source);
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(source.text.as_bytes());
    let no_table = |error: csv::Error| {
        let place = error.position().map_or(0..0, |position| csv_line_span(source, position));
        wrong(place, csv_error_message(&error), "give a head and rows of as many numbers".to_owned())
    };
    let heads = reader.headers().map_err(no_table)?.clone();
    let q = model.coordinates.iter().map(|c| c.name.clone());
    let u = model.speeds.iter().map(|s| s.name.clone());
    let names: Vec<String> = q.chain(u).chain(model.speeds.iter().map(|s| format!("{}'", s.name))).collect();
    let place = |name: &String| {
        let missing = || {
            let near = nearest_name_advice(name, heads.iter());
            let help =
                format!("give a column for every coordinate, speed and acceleration: {}; {near}", names.join(", "));
            wrong(head.clone(), format!("the table has no column `{name}`"), help)
        };
        heads.iter().position(|head| head == name).ok_or_else(missing)
    };
    let places = names.iter().map(place).collect::<Result<Vec<usize>, _>>()?;
    let instant = heads.iter().position(|head| head == TIME);
    let mut list = Vec::new();
    for (at, record) in reader.records().enumerate() {
        let record = record.map_err(no_table)?;
        let number = |place: usize| {
            let cell = record.get(place).unwrap_or_default();
            cell.parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(|| {
                let message =
                    format!("row {} has no number in `{}`: `{}`", at + 1, &heads[place], shortened_for_message(cell));
                let place = record.position().map_or(0..0, |position| csv_line_span(source, position));
                wrong(place, message, "give a number".to_owned())
            })
        };
        let values = places.iter().map(|place| Ok(number(*place)?.into())).collect::<Result<Vec<DoubleDouble>, _>>()?;
        let (q, rest) = values.split_at(model.coordinates.len());
        let (u, rates) = rest.split_at(model.speeds.len());
        let t = instant.map(number).transpose()?;
        list.push(MotionSample { t, q: q.to_vec(), u: u.to_vec(), rates: rates.to_vec() });
    }
    if list.is_empty() {
        return Err(wrong(head, "the table has no rows".to_owned(), "give at least one".to_owned()));
    }
    Ok(list)
}
