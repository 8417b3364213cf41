//! Summary of a sweep: the number of rows with each outcome.

use std::collections::BTreeMap;
use std::fmt::Write;
use tripos::studies::sweep::SweepRow;

/// Numbers of a sweep's rows, by outcome.
#[derive(Default)]
pub struct Tally {
    /// Number of rows for each stop code, such as `end`.
    stops: BTreeMap<String, Count>,
}

/// Number of rows with the same stop code.
#[derive(Default)]
struct Count {
    /// Number of the sweep's rows with this stop code.
    rows: u64,
    /// First point whose run has no result, with the reason; `None` if all rows have results.
    failure: Option<(u64, String)>,
    /// Number of rows whose numbers cannot be trusted.
    warned: u64,
    /// First point whose numbers cannot be trusted, with the reasons; `None` if there is none.
    warning: Option<(u64, String)>,
}

impl Tally {
    /// Counts a row of the sweep by its stop code.
    pub fn add(&mut self, row: &SweepRow) {
        self.count(row.point, row.stop(), row.warning(), row.failure());
    }

    /// Counts a row by its stop code. `point` is the index of its point, `warning` has the reasons not to trust its
    /// numbers, and `failure` the reason why the row has no result; `None` if there are none.
    pub fn count(&mut self, point: u64, stop: &str, warning: Option<&str>, failure: Option<&str>) {
        let count = self.stops.entry(stop.to_owned()).or_default();
        count.rows += 1;
        if let (None, Some(reason)) = (&count.failure, failure) {
            count.failure = Some((point, reason.to_owned()));
        }
        if let Some(reasons) = warning {
            count.warned += 1;
            count.warning.get_or_insert_with(|| (point, reasons.to_owned()));
        }
    }

    /// Returns the number of rows whose numbers cannot be trusted.
    pub fn rows_with_warnings(&self) -> u64 {
        self.stops.values().map(|count| count.warned).sum()
    }

    /// Returns the number of rows whose stop code belongs to runs without a result.
    pub fn rows_without_result(&self) -> u64 {
        self.stops.values().filter(|count| count.failure.is_some()).map(|count| count.rows).sum()
    }

    /// Returns the counts as text, one line per stop code.
    pub fn text(&self) -> String {
        let mut out = String::new();
        for (stop, Count { rows, failure, warned, warning }) in &self.stops {
            let _ = match failure {
                None => writeln!(out, "  {rows} {stop}"),
                Some((point, reason)) => writeln!(out, "  {rows} {stop}, first at point {point}: {reason}"),
            };
            if let Some((point, reasons)) = warning {
                let _ = writeln!(out, "    {warned} of them with a warning, first at point {point}: {reasons}");
            }
        }
        out
    }

    /// Returns the counts as JSON `{CODE: {rows, first, reason}}`. Only codes of rows without results have `first` and
    /// `reason`.
    pub fn json(&self) -> serde_json::Value {
        let entry = |Count { rows, failure, .. }: &Count| match failure {
            None => serde_json::json!({ "rows": rows }),
            Some((point, reason)) => serde_json::json!({ "rows": rows, "first": point, "reason": reason }),
        };
        self.stops.iter().map(|(stop, count)| (stop.clone(), entry(count))).collect::<serde_json::Map<_, _>>().into()
    }
}
