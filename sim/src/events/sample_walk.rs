//! Walk over the samples of an event function in a step: finds its zeros, and remembers its sign from
//! step to step.
//!
//! Invariant: `EventMemory::side_of_whole_step` is the side of zero on which the function was last known to be. Every
//! change of sign against it is reported exactly once. See [`crate::events`] for the conventions.

use super::Kind;
use super::root_and_minimum::{self, NotANumber};
use super::samples::{Node, Probe, Sign, sign_of_sample};

/// Distances from a zero at which the sign of the event function is examined, as fractions of a step:
/// 2⁻²⁰, 2⁻¹⁴ and 2⁻⁸.
pub(crate) const LADDER: [f64; 3] = [1.0 / 1_048_576.0, 1.0 / 16_384.0, 1.0 / 256.0];
/// Factor by which an event function is larger where it changes sign than at the ends of the bracket,
/// if it does so through infinity.
const BEYOND: f64 = 4.0;

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
    /// Start time of the run, s, if the event function is zero there and the run is still within rounding
    /// of it; else `None`.
    pub(crate) zero_at: Option<f64>,
}

impl EventMemory {
    /// Updates the memory to the last of a step's samples.
    pub(crate) fn move_on(&mut self, nodes: &[Node]) {
        self.begun = true;
        if let Some(end) = nodes.last() {
            (self.value, self.sign) = (end.g, end.sign);
        }
    }

    /// Updates the memory to the end of a step in which the event function had the sign `side`, with an
    /// unknown value.
    pub(crate) fn stay_on_side(&mut self, side: Sign) {
        (self.begun, self.side, self.sign, self.value) = (true, side, side, f64::from(side));
    }

    /// Sets the memory to the first sample of a run, whose sign is `first`. If it is zero, that is reported
    /// in `findings`.
    pub(crate) fn begin(&mut self, first: Sign, findings: &mut Findings) {
        self.side = first;
        if first == 0 {
            self.side = self.side_at_zero;
            findings.found.push(Finding { theta: 0.0, kind: Kind::AtStart, side: self.side });
        }
    }
}

/// Zero of an event function that a search found in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Finding {
    /// Fraction of the step at which the zero lies.
    pub(crate) theta: f64,
    /// Kind of the zero, such as a rising crossing or a touch.
    pub(crate) kind: Kind,
    /// Sign of the event function after the zero.
    pub(crate) side: Sign,
}

/// Zeros of an event function that a search found in a step.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Findings {
    /// Zeros that were found in the step, in no particular order.
    pub(crate) found: Vec<Finding>,
    /// First fraction of the step at which the function is not a number; `None` if there is none.
    pub(crate) not_a_number: Option<f64>,
}

impl Findings {
    /// Records the fraction of the step at which the function is not a number, if `outcome` is an error and
    /// no earlier fraction is recorded.
    pub(crate) fn note_not_a_number(&mut self, outcome: Result<(), NotANumber>) {
        if let Err(NotANumber { at }) = outcome {
            self.not_a_number = Some(self.not_a_number.map_or(at, |theta| theta.min(at)));
        }
    }
}

/// Doubt whether an event function reached zero and returned between two neighbouring samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Doubt {
    /// The function certainly did not reach zero.
    None,
    /// The minimum of |g| between the samples decides if it reached zero.
    Dip,
    /// The minimum of |g| between the samples decides if it is at zero or beyond. If it is above zero, the
    /// place is undecided.
    Unknown,
}

/// Crossing at the fraction `theta` of the step, after which the function has the sign `side`.
fn crossing_to(side: Sign, theta: f64) -> Finding {
    Finding { theta, kind: if side > 0 { Kind::Rising } else { Kind::Falling }, side }
}

/// Walks over the samples of an event function in a step, in order, and adds its zeros to `findings`.
/// Values up to `tolerance` count as zero. Error if a value is not a number.
///
/// `doubt(k)` is the doubt about a zero between samples k − 1 and k.
pub(crate) fn walk_over_samples(
    probe: &mut Probe<'_>,
    nodes: &[Node],
    doubt: &dyn Fn(usize) -> Doubt,
    memory: &mut EventMemory,
    tolerance: f64,
    findings: &mut Findings,
) -> Result<(), NotANumber> {
    // Last sample that is clearly on a side, and the first zero sample after it. Zeros at the start of the step were
    // reported at the end of the step before.
    let mut clear: Option<usize> = None;
    let mut zeros: Option<usize> = None;
    for (k, node) in nodes.iter().enumerate() {
        if node.sign == 0 {
            zeros.get_or_insert(k);
            continue;
        }
        if memory.side == 0 {
            memory.side = node.sign;
        } else if node.sign != memory.side {
            findings.found.push(walk_across_zero(probe, nodes, clear.unwrap_or(k.saturating_sub(1)), k, tolerance)?);
            memory.side = node.sign;
        } else if let (Some(low), Some(_)) = (clear, zeros) {
            walk_past_minimum(probe, [nodes[low], *node], Doubt::Dip, tolerance, findings)?;
        } else if k > 0 && clear.is_some() && doubt(k) != Doubt::None {
            walk_past_minimum(probe, [nodes[k - 1], *node], doubt(k), tolerance, findings)?;
        }
        (clear, zeros) = (Some(k), None);
    }
    if let Some(z) = zeros.filter(|z| *z > 0) {
        findings.found.push(walk_onto_zero(probe, &nodes[z..], memory, tolerance));
    }
    Ok(())
}

/// Finds the change of sign between samples `low` and `high`. It is a pole if the function grows
/// towards it. Error if a value is not a number.
///
/// If both values have the same sign before rounding, the change counts as being at the last sample
/// before `high`.
fn walk_across_zero(
    probe: &mut Probe<'_>,
    nodes: &[Node],
    low: usize,
    high: usize,
    tolerance: f64,
) -> Result<Finding, NotANumber> {
    let (a, b) = (nodes[low], nodes[high]);
    if (a.g < 0.0) == (b.g < 0.0) || a.g == 0.0 {
        return Ok(crossing_to(b.sign, nodes[high.saturating_sub(1)].theta));
    }
    let theta =
        root_and_minimum::root_in_bracket(&mut |theta| probe.event_value(theta), (a.theta, a.g), (b.theta, b.g), 0.0)?;
    let grown = probe.value_at(theta)?.abs() > BEYOND * a.g.abs().max(b.g.abs()).max(tolerance);
    let crossing = crossing_to(b.sign, theta);
    Ok(if grown { Finding { kind: Kind::Pole, ..crossing } } else { crossing })
}

/// Follows |g| to its minimum between two samples on the same side of zero. Adds two crossings, a
/// touch, an undecided place or nothing to `findings`. Error if a value is not a number.
fn walk_past_minimum(
    probe: &mut Probe<'_>,
    [a, b]: [Node; 2],
    doubt: Doubt,
    tolerance: f64,
    findings: &mut Findings,
) -> Result<(), NotANumber> {
    let side = f64::from(a.sign);
    let mut height = |theta| side * probe.event_value(theta);
    let (theta, least) = root_and_minimum::minimum(&mut height, a.theta, b.theta, -tolerance)?;
    if least < -tolerance {
        let mut g = |theta| probe.event_value(theta);
        let bottom = (theta, side * least);
        let first = root_and_minimum::root_in_bracket(&mut g, (a.theta, a.g), bottom, 0.0)?;
        let second = root_and_minimum::root_in_bracket(&mut g, bottom, (b.theta, b.g), 0.0)?;
        findings.found.push(crossing_to(-a.sign, first));
        findings.found.push(crossing_to(a.sign, second));
    } else if least <= tolerance {
        findings.found.push(Finding { theta, kind: Kind::Touch, side: a.sign });
    } else if doubt == Doubt::Unknown {
        findings.found.push(Finding { theta, kind: Kind::Undecided, side: a.sign });
    }
    Ok(())
}

/// Reports an event function that is zero from the first of `zeros` to the last sample of the step. It
/// is a touch if the function returns to its side shortly after the step, else a crossing.
fn walk_onto_zero(probe: &mut Probe<'_>, zeros: &[Node], memory: &mut EventMemory, tolerance: f64) -> Finding {
    let end = zeros.last().map_or(1.0, |n| n.theta);
    let mut sides = LADDER.iter().map(|d| sign_or_zero(probe.event_value(end + d), tolerance));
    let beyond = sides.find(|s| *s != 0);
    let nearest = zeros.iter().rev().min_by(|a, b| a.g.abs().total_cmp(&b.g.abs()));
    let nearest = nearest.map_or(end, |n| n.theta);
    if beyond == Some(memory.side) {
        return Finding { theta: nearest, kind: Kind::Touch, side: memory.side };
    }
    memory.side = -memory.side;
    // A function that stays at zero arrived at the first zero sample.
    let theta = if beyond.is_some() { nearest } else { zeros[0].theta };
    crossing_to(memory.side, theta)
}

/// Sign of the value `g` of an event function: 0 if it is not a number, or up to `tolerance` in size.
fn sign_or_zero(g: f64, tolerance: f64) -> Sign {
    if g.is_nan() { 0 } else { sign_of_sample(g, tolerance) }
}
