//! Walk over the samples of an event function in a step, which finds its zeros. See [`crate::events`] for
//! the conventions.

use super::Kind;
use super::event_findings::{Finding, Findings, crossing_to};
use super::event_memory::EventMemory;
use super::probe::Probe;
use super::root_and_minimum::{self, NotANumber};
use super::samples::{Node, sign_or_zero};

/// Distances beyond a zero at which the sign of the event function is examined, as fractions of a step: 2⁻²⁰, 2⁻¹⁴ and
/// 2⁻⁸.
pub(crate) const LADDER: [f64; 3] = [1.0 / 1_048_576.0, 1.0 / 16_384.0, 1.0 / 256.0];
/// Factor that separates a pole from a zero: at a pole the event function is larger by this factor than at the ends of
/// the bracket.
const BEYOND: f64 = 4.0;

/// Possibility that an event function reached zero and returned between two neighbouring samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Doubt {
    /// The function certainly did not reach zero.
    None,
    /// The function may have reached zero: the minimum of |g| between the samples decides.
    Dip,
    /// The function may have reached zero: the minimum of |g| between the samples decides. A minimum above zero leaves
    /// the place undecided.
    Unknown,
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
    // `clear` is the last sample that is clearly on a side of zero, and `zeros` the first zero sample after it. Zeros
    // at the start of the step were reported at the end of the step before.
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

/// Finds the change of sign between samples `low` and `high`. It is a pole if the function grows towards the change.
/// Error if a value is not a number.
///
/// If both values have the same sign before rounding, the change is placed at the last sample before `high`.
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

/// Finds the minimum of |g| between two samples on the same side of zero. Adds two crossings, a touch, an undecided
/// place or nothing to `findings`. Error if a value is not a number.
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

/// Creates the finding for an event function that is zero at the samples `zeros` up to the end of the step. It is a
/// touch if the function returns to its side shortly after the step, else a crossing.
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
    // If the function stays at zero, the crossing is at the first zero sample.
    let theta = if beyond.is_some() { nearest } else { zeros[0].theta };
    crossing_to(memory.side, theta)
}
