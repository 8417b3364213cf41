//! Counts of the outcomes of a sweep's points.

use std::collections::BTreeMap;
use std::fmt::Write;
use tripos::studies::sweep::Row;

/// Counts of rows by how they ended.
#[derive(Default)]
pub struct Tally {
    /// Counts by the code of the stop.
    stops: BTreeMap<String, Count>,
}

/// Number of rows that ended in one way.
#[derive(Default)]
struct Count {
    rows: u64,
    /// The first point without an answer, and why it has none.
    failure: Option<(u64, String)>,
}

impl Tally {
    /// Counts a row.
    pub fn add(&mut self, row: &Row) {
        self.count(row.point, row.stop(), row.failure());
    }

    /// Counts a row by its point, the code of its stop, and why it has no answer, if it has none.
    pub fn count(&mut self, point: u64, stop: &str, failure: Option<&str>) {
        let count = self.stops.entry(stop.to_owned()).or_default();
        count.rows += 1;
        if let (None, Some(reason)) = (&count.failure, failure) {
            count.failure = Some((point, reason.to_owned()));
        }
    }

    /// Rows without an answer.
    pub fn failed(&self) -> u64 {
        self.stops.values().filter(|count| count.failure.is_some()).map(|count| count.rows).sum()
    }

    /// A line for each way in which rows ended.
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

    /// `{CODE: {rows, first, reason}}`, the last two only of those without an answer.
    pub fn json(&self) -> serde_json::Value {
        let entry = |Count { rows, failure }: &Count| match failure {
            None => serde_json::json!({ "rows": rows }),
            Some((point, reason)) => serde_json::json!({ "rows": rows, "first": point, "reason": reason }),
        };
        self.stops.iter().map(|(stop, count)| (stop.clone(), entry(count))).collect::<serde_json::Map<_, _>>().into()
    }
}
