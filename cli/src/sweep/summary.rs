//! Counts of the outcomes of a sweep's points.

use std::collections::BTreeMap;
use std::fmt::Write;
use tripos::studies::sweep::Row;

/// Counts of a sweep's rows by their outcomes.
#[derive(Default)]
pub struct Tally {
    /// Counts of rows, by the code of the stop.
    stops: BTreeMap<String, Count>,
}

/// Number of rows with one code of the stop.
#[derive(Default)]
struct Count {
    rows: u64,
    /// First point without an answer, and the reason why it has none; `None` if all have answers.
    failure: Option<(u64, String)>,
}

impl Tally {
    /// Counts a row of the sweep.
    pub fn add(&mut self, row: &Row) {
        self.count(row.point, row.stop(), row.failure());
    }

    /// Counts a row by its point and the code of its stop; `failure` is the reason why it has no answer, if it has
    /// none.
    pub fn count(&mut self, point: u64, stop: &str, failure: Option<&str>) {
        let count = self.stops.entry(stop.to_owned()).or_default();
        count.rows += 1;
        if let (None, Some(reason)) = (&count.failure, failure) {
            count.failure = Some((point, reason.to_owned()));
        }
    }

    /// Number of rows without an answer.
    pub fn failed(&self) -> u64 {
        self.stops.values().filter(|count| count.failure.is_some()).map(|count| count.rows).sum()
    }

    /// Text of the counts, a line for each code of the stop.
    pub fn text(&self) -> String {
        let mut out = String::new();
        for (stop, Count { rows, failure }) in &self.stops {
            let _ = match failure {
                None => writeln!(out, "  {rows} {stop}"),
                Some((point, reason)) => writeln!(out, "  {rows} {stop}, first at point {point}: {reason}"),
            };
        }
        out
    }

    /// JSON `{CODE: {rows, first, reason}}`; rows without an answer have `first` and `reason`.
    pub fn json(&self) -> serde_json::Value {
        let entry = |Count { rows, failure }: &Count| match failure {
            None => serde_json::json!({ "rows": rows }),
            Some((point, reason)) => serde_json::json!({ "rows": rows, "first": point, "reason": reason }),
        };
        self.stops.iter().map(|(stop, count)| (stop.clone(), entry(count))).collect::<serde_json::Map<_, _>>().into()
    }
}
