//! Rows of a sweep's table.

/// Result of one point of a sweep.
pub struct Row {
    /// Index of the point in the whole sweep, from 0.
    pub point: u64,
    /// Values of the swept quantities at the point.
    pub values: Vec<f64>,
    /// End of the point's run, or the reason why it has none.
    pub outcome: Result<Ended, String>,
}

/// End of a run, with its costs and checks.
pub struct Ended {
    /// Instant at which the run ended, s.
    pub t_end: f64,
    /// Code of the [`tripos_sim::Stop`] that ended the run.
    pub stop: String,
    /// Reason why the run could not go on, or why its end has no value; `None` if the end is valid.
    pub failure: Option<String>,
    /// Coordinates and generalized speeds at the end of the run, then the other outputs of the scene.
    pub shown: Vec<f64>,
    /// Number of accepted steps of the run.
    pub steps: u64,
    /// Number of rejected steps of the run.
    pub rejected: u64,
    /// Number of evaluations of the equations in the run.
    pub evaluations: u64,
    /// Largest change of each first integral from its start along the run.
    pub changes: Vec<f64>,
    /// Number of digits that are correct in every value at the end; `None` if not requested, or if the run was not
    /// assessed to its end.
    pub digits: Option<f64>,
}

/// Entry of the column `stop` for a point whose run could not start.
pub const NO_START: &str = "no-start";

impl Row {
    /// Code of the way in which the run of the point ended.
    #[must_use]
    pub fn stop(&self) -> &str {
        self.outcome.as_ref().map_or(NO_START, |ended| &ended.stop)
    }

    /// Reason why the point has no valid result; `None` if it has one.
    #[must_use]
    pub fn failure(&self) -> Option<&str> {
        match &self.outcome {
            Ok(ended) => ended.failure.as_deref(),
            Err(reason) => Some(reason),
        }
    }
}
