//! Memory of an event function from step to step: its value and its sign at the start of a step.
//!
//! Invariant: `EventMemory::side` is the sign of the event function when it was last known not to be zero. Every change
//! from this sign to the opposite sign is reported exactly once. See [`crate::events`] for the conventions.

use super::Kind;
use super::event_findings::{Finding, Findings};
use super::samples::{Node, Sign};

/// Data about an event function that its search keeps from step to step, at the start of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EventMemory {
    /// Value of the event function at the start of the step.
    pub(crate) value: f64,
    /// Sign of the event function at the start of the step; 0 within rounding of zero.
    pub(crate) sign: Sign,
    /// Sign of the event function when it was last not zero; 0 if it has been zero since the start of the
    /// run.
    pub(crate) side: Sign,
    /// True if a step of the run has been searched for zeros.
    pub(crate) begun: bool,
    /// Sign that is assumed for an event function that is zero at the start of the run: 1 for a domain
    /// event, else 0.
    pub(crate) side_at_zero: Sign,
    /// Start time of the run, s, while the run is within rounding of this time and the event function was zero there;
    /// else `None`.
    pub(crate) zero_at: Option<f64>,
}

impl EventMemory {
    /// Updates the memory from the last sample of a step.
    pub(crate) fn move_on(&mut self, nodes: &[Node]) {
        self.begun = true;
        if let Some(end) = nodes.last() {
            (self.value, self.sign) = (end.g, end.sign);
        }
    }

    /// Updates the memory to the end of a step in which the event function always had the sign `side`. Its value is not
    /// known then; ±1 is stored.
    pub(crate) fn stay_on_side(&mut self, side: Sign) {
        (self.begun, self.side, self.sign, self.value) = (true, side, side, f64::from(side));
    }

    /// Sets the memory to the first sample of a run, whose sign is `first`. A zero at the start is reported in
    /// `findings`.
    pub(crate) fn begin(&mut self, first: Sign, findings: &mut Findings) {
        self.side = first;
        if first == 0 {
            self.side = self.side_at_zero;
            findings.found.push(Finding { theta: 0.0, kind: Kind::AtStart, side: self.side });
        }
    }
}
