//! Rows of a sweep's table.

/// Result of one point of a sweep.
pub struct Row {
    /// Index of the point in the whole sweep, from 0.
    pub point: u64,
    /// Values of the swept quantities.
    pub values: Vec<f64>,
    /// End of its run, or the reason why there is none.
    pub outcome: Result<Ended, String>,
}

/// End of a run, with its costs and checks.
pub struct Ended {
    /// Instant of the end, s.
    pub t_end: f64,
    /// Code of the [`tripos_sim::Stop`].
    pub stop: String,
    /// Reason why the run could not go on, or why its end has no value; `None` if it is valid.
    pub failure: Option<String>,
    /// Coordinates and generalized speeds at the end, or the outputs of the scene.
    pub shown: Vec<f64>,
    /// Number of accepted steps.
    pub steps: u64,
    /// Number of rejected steps.
    pub rejected: u64,
    /// Number of evaluations of the equations.
    pub evaluations: u64,
    /// Difference of each first integral between end and start.
    pub changes: Vec<f64>,
    /// Number of correct digits of every value at the end; `None` if not asked for, or if the run was not assessed to
    /// its end.
    pub digits: Option<f64>,
}

/// Entry of the column `stop` for a point without a run.
pub const NO_START: &str = "no-start";

impl Row {
    /// Code of the way in which the run ended.
    #[must_use]
    pub fn stop(&self) -> &str {
        self.outcome.as_ref().map_or(NO_START, |ended| &ended.stop)
    }

    /// Reason why the point has no answer; `None` if it has one.
    #[must_use]
    pub fn failure(&self) -> Option<&str> {
        match &self.outcome {
            Ok(ended) => ended.failure.as_deref(),
            Err(reason) => Some(reason),
        }
    }
}
