//! What became of the points of a sweep.

/// What became of one point.
pub struct Row {
    /// Its index in the whole sweep, from 0.
    pub point: u64,
    /// The values of what is swept.
    pub values: Vec<f64>,
    /// How its run ended, or why there was none.
    pub outcome: Result<Ended, String>,
}

/// How a run ended.
pub struct Ended {
    /// When, s.
    pub t_end: f64,
    /// The code of [`tripos_sim::Stop`].
    pub stop: String,
    /// Why the run could not go on, if it could not.
    pub failure: Option<String>,
    /// Coordinates and generalized speeds, or what the scene asks for.
    pub shown: Vec<f64>,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Evaluations of the equations.
    pub evaluations: u64,
    /// By how much each first integral differs at the end from its start.
    pub changes: Vec<f64>,
    /// The digits that every value has at the end, if they were asked for and the run was assessed to its end.
    pub digits: Option<f64>,
}

/// What the column `stop` says of a point without a run.
pub const NO_START: &str = "no-start";

impl Row {
    /// The code of how it ended.
    #[must_use]
    pub fn stop(&self) -> &str {
        self.outcome.as_ref().map_or(NO_START, |ended| &ended.stop)
    }

    /// Why it has no answer, if it has none.
    #[must_use]
    pub fn failure(&self) -> Option<&str> {
        match &self.outcome {
            Ok(ended) => ended.failure.as_deref(),
            Err(reason) => Some(reason),
        }
    }
}
