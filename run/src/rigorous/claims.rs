//! Verdicts of a rigorous run on claims about a motion, such as `N > 0`.

use tripos_traits::Ball;

/// Verdict of a rigorous run on a claim.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ClaimVerdict {
    /// Instant up to which the claim is proved, s; `None` if it is not proved at the start.
    pub proved_to: Option<f64>,
    /// Instant by which the claim is proved to be false, s; `None` if it is not proved to be false.
    pub refuted_by: Option<f64>,
    /// True once the claim was not proved over some time, or if the enclosure ended before the motion.
    pub(super) is_open: bool,
}

impl ClaimVerdict {
    /// True if the claim is proved at all instants of the motion.
    #[must_use]
    pub fn is_proved(&self) -> bool {
        !self.is_open && self.proved_to.is_some()
    }

    /// True if the larger side less the smaller side, a number of the ball `distance`, may keep or break a claim that
    /// was proved until now.
    pub(super) fn is_undecided(&self, distance: Ball<f64>) -> bool {
        !self.is_open && distance.low() <= 0.0 && distance.high() > 0.0
    }

    /// Goes on with the verdict: from the last instant to an instant of the ball `t`, s, the larger side less the
    /// smaller side is in the ball `distance`. Where the motion may be over, nothing is refuted.
    pub(super) fn go_on(&mut self, distance: Ball<f64>, t: Ball<f64>, may_be_over: bool) {
        if distance.low() > 0.0 && distance.is_defined() {
            if !self.is_open {
                self.proved_to = Some(t.low());
            }
            return;
        }
        self.is_open = true;
        let is_broken = distance.is_defined() && distance.high() <= 0.0;
        if is_broken && !may_be_over && self.refuted_by.is_none() {
            self.refuted_by = Some(t.high());
        }
    }
}
