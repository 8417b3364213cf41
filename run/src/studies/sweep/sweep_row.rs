//! Rows of the table that a sweep writes, one row for each point.

/// Result of one point of a sweep, as a row of its table.
pub struct SweepRow {
    /// Index of the point in the whole sweep, from 0.
    pub point: u64,
    /// Values of the varied quantities at the point, in the order of the grid.
    pub values: Vec<f64>,
    /// Results at the end of the run of this point, or the reason why the run could not start.
    pub outcome: Result<RunEnd, String>,
}

/// Results of a run at its end, with the numbers of its steps and evaluations.
pub struct RunEnd {
    /// Instant at which the run ended, s.
    pub t_end: f64,
    /// Code of the reason why the run ended, from [`tripos_sim::Stop`].
    pub stop: String,
    /// Reason why the run could not continue, or why its end has no value; `None` if the end is valid.
    pub failure: Option<String>,
    /// Reasons why the numbers of a valid end cannot be trusted, joined by semicolons; `None` if there are none.
    pub warning: Option<String>,
    /// Values at the end of the run: coordinates and generalized speeds, followed by the other outputs
    /// of the scene.
    pub shown: Vec<f64>,
    /// Number of accepted steps of the run.
    pub steps: u64,
    /// Number of rejected steps of the run.
    pub rejected: u64,
    /// Number of evaluations of the right-hand side in the run.
    pub evaluations: u64,
    /// Largest change of each conserved quantity over the run, in its unit. The order is that of the
    /// sweep's conserved quantities.
    pub changes: Vec<f64>,
    /// Least number of correct decimal digits among the values at the end. `None` if it was not requested,
    /// or if a second run did not confirm the end.
    pub digits: Option<f64>,
}

/// Entry in the column `stop` of the table, for a point whose run could not start.
pub const NO_START: &str = "no-start";

impl SweepRow {
    /// Code of the reason why the point's run ended, or `no-start` if it could not start.
    #[must_use]
    pub fn stop(&self) -> &str {
        self.outcome.as_ref().map_or(NO_START, |ended| &ended.stop)
    }

    /// Reason why the point has no valid result; `None` if its result is valid.
    #[must_use]
    pub fn failure(&self) -> Option<&str> {
        match &self.outcome {
            Ok(ended) => ended.failure.as_deref(),
            Err(reason) => Some(reason),
        }
    }

    /// Reasons why the numbers of the row cannot be trusted, joined by semicolons; `None` if there are none.
    #[must_use]
    pub fn warning(&self) -> Option<&str> {
        self.outcome.as_ref().ok()?.warning.as_deref()
    }
}
