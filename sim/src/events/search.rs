//! Search for the zeros of an event function in a step: by interval arithmetic if the event has ranges,
//! else by samples.

use super::Kind;
use super::event_findings::{Finding, Findings};
use super::event_memory::EventMemory;
use super::interval_isolation::{Isolation, Known, Ranges, isolate};
use super::probe::Probe;
use super::root_and_minimum::NotANumber;
use super::sample_walk::{Doubt, LADDER, walk_over_samples};
use super::samples::{
    Node, hidden_extrema, sample_nearest_to_zero, samples_are_far_from_zero, samples_may_hide_zero, sign_of_sample,
};

/// Fraction of a step used to measure the slope of an event function at the step's ends. It is √ε, within which a
/// smooth function cannot turn by more than rounding.
const DELTA: f64 = 1.0 / 67_108_864.0;
/// Number of equal intervals between the samples of an event function in a step.
const INTERVALS: u32 = 8;

/// Searches a step for the zeros of an event function, and returns them. Updates `memory` to the end of the step. If
/// `ranges` is `None`, the function is sampled.
pub(crate) fn search(probe: &mut Probe<'_>, memory: &mut EventMemory, ranges: Option<Ranges<'_, '_>>) -> Findings {
    match ranges {
        Some(mut ranges) => search_by_ranges(probe, memory, &mut ranges),
        None => search_by_samples(probe, memory),
    }
}

/// Searches a step for the zeros of an event function, on parts on which interval arithmetic decides
/// its behaviour.
fn search_by_ranges(probe: &mut Probe<'_>, memory: &mut EventMemory, ranges: &mut Ranges<'_, '_>) -> Findings {
    let isolation = isolate(probe, ranges);
    let mut findings = Findings { not_a_number: isolation.cut, ..Findings::default() };
    if let Some(side) = isolation.side_of_whole_step()
        && side == memory.side
        && memory.begun
    {
        memory.stay_on_side(side);
        return findings;
    }
    let mut nodes = Vec::new();
    add_samples_to_search(probe, isolation.ends(), &mut nodes, &mut findings);
    let Some(near) = sample_nearest_to_zero(&nodes) else { return findings };
    let tolerance = probe.rounding(near, 0.0) + 0.5 * ranges.rounding_spread(near);
    let slope = if memory.begun { 0.0 } else { ranges.range_over_part(0.0, 0.0).slope.size() };
    set_signs_before_search(probe, &mut nodes, memory, tolerance, slope, &mut findings);
    set_start_signs_before_search(probe, &mut nodes, memory);
    let doubt = |k: usize| doubt_about_part(isolation.parts[k - 1].known);
    let outcome = walk_over_samples(probe, &nodes, &doubt, memory, tolerance, &mut findings);
    findings.note_not_a_number(outcome);
    findings.found.extend(undecided_event(&isolation, &nodes, memory));
    memory.move_on(&nodes);
    findings
}

/// Possibility of a hidden zero on a part of the step with this known behaviour of the event function.
fn doubt_about_part(known: Known) -> Doubt {
    match known {
        Known::Clear(_) | Known::Monotone => Doubt::None,
        Known::Unknown => Doubt::Unknown,
        Known::Open => Doubt::Dip,
    }
}

/// Reports all parts of a step that stayed undecided as a single undecided event, at the sample with the smallest |g|.
/// `None` if there are none; parts that begin and end at zero do not count.
fn undecided_event(isolation: &Isolation, nodes: &[Node], memory: &EventMemory) -> Option<Finding> {
    let parts = isolation.parts.iter().zip(nodes.windows(2)).filter(|(part, _)| part.known == Known::Open);
    let ends = parts.filter(|(_, ends)| ends.iter().any(|n| n.sign != 0)).flat_map(|(_, ends)| ends);
    let near = ends.min_by(|a, b| a.g.abs().total_cmp(&b.g.abs()))?;
    Some(Finding { theta: near.theta, kind: Kind::Undecided, side: memory.side })
}

/// Searches a step for the zeros of an event function by sampling it.
fn search_by_samples(probe: &mut Probe<'_>, memory: &mut EventMemory) -> Findings {
    let mut findings = Findings::default();
    let nodes = &mut samples_to_search(probe, memory, &mut findings);
    let scale = nodes.iter().map(|n| n.g.abs()).filter(|g| g.is_finite()).fold(0.0, f64::max);
    if !(memory.begun && needs_no_search(nodes, memory, scale)) {
        let outcome = search_among_samples(probe, nodes, memory, scale, &mut findings);
        findings.note_not_a_number(outcome);
    }
    memory.move_on(nodes);
    findings
}

/// Takes the samples of an event function in a step, in order, up to the first value that is not a
/// number.
fn samples_to_search(probe: &mut Probe<'_>, memory: &EventMemory, findings: &mut Findings) -> Vec<Node> {
    let mut nodes = vec![Node { theta: 0.0, g: memory.value, sign: memory.sign }];
    let thetas = (1..INTERVALS).map(|i| f64::from(i) / f64::from(INTERVALS));
    let thetas = std::iter::once(DELTA).chain(thetas).chain([1.0 - DELTA, 1.0]);
    add_samples_to_search(probe, thetas, &mut nodes, findings);
    if samples_are_far_from_zero(&nodes) {
        return nodes;
    }
    let hidden: Vec<f64> = (1..nodes.len()).flat_map(|k| hidden_extrema(&nodes, k)).collect();
    add_samples_to_search(probe, hidden.into_iter(), &mut nodes, findings);
    if let Some(end) = findings.not_a_number {
        nodes.retain(|n| n.theta < end);
    }
    nodes.sort_by(|a, b| a.theta.total_cmp(&b.theta));
    nodes.dedup_by(|a, b| a.theta.total_cmp(&b.theta).is_eq());
    nodes
}

/// Appends samples of the event function at the fractions `thetas` of the step to `nodes`, until a
/// value is not a number.
fn add_samples_to_search(
    probe: &mut Probe<'_>,
    thetas: impl Iterator<Item = f64>,
    nodes: &mut Vec<Node>,
    findings: &mut Findings,
) {
    for theta in thetas {
        let g = probe.event_value(theta);
        if g.is_nan() {
            findings.not_a_number = Some(theta);
            return;
        }
        nodes.push(Node { theta, g, sign: sign_of_sample(g, 0.0) });
    }
}

/// True if the samples prove that the event function had no zero in the step. `scale` is the largest |g| of the
/// samples.
fn needs_no_search(nodes: &[Node], memory: &EventMemory, scale: f64) -> bool {
    if samples_are_far_from_zero(nodes) && nodes[0].sign == memory.side {
        return true;
    }
    let same_side = nodes.iter().all(|n| n.sign == memory.side);
    let end_is_clear = nodes.last().is_some_and(|n| n.g.abs() > 1e-6 * scale);
    same_side && end_is_clear && !(1..nodes.len()).any(|k| samples_may_hide_zero(nodes, k))
}

/// Determines up to which size values of the event function count as zero, then finds its zeros by a walk over the
/// samples. `scale` is the largest |g| of the samples. Error if a value is not a number.
fn search_among_samples(
    probe: &mut Probe<'_>,
    nodes: &mut Vec<Node>,
    memory: &mut EventMemory,
    scale: f64,
    findings: &mut Findings,
) -> Result<(), NotANumber> {
    let tolerance = probe.rounding(sample_nearest_to_zero(nodes).unwrap_or(0.0), scale);
    let slope = nodes.get(1).map_or(0.0, |next| (next.g - nodes[0].g).abs() / next.theta);
    set_signs_before_search(probe, nodes, memory, tolerance, slope, findings);
    if nodes[0].sign == 0 && nodes.len() > 2 {
        let mut ladder = Vec::new();
        for theta in LADDER {
            let g = probe.value_at(theta)?;
            ladder.push(Node { theta, g, sign: sign_of_sample(g, tolerance) });
        }
        nodes.splice(2..2, ladder);
    }
    set_start_signs_before_search(probe, nodes, memory);
    let nodes = &nodes[..];
    let doubt = |k: usize| if samples_may_hide_zero(nodes, k) { Doubt::Dip } else { Doubt::None };
    walk_over_samples(probe, nodes, &doubt, memory, tolerance, findings)
}

/// Sets the signs of samples of an event function; absolute values up to `tolerance` count as zero.
///
/// The start time of a run is uncertain by rounding. Within this uncertainty the function changes by its derivative
/// `slope` by the fraction of the step, times the uncertain fraction. A run that begins where an event ended another
/// run therefore begins at zero.
fn set_signs_before_search(
    probe: &Probe<'_>,
    nodes: &mut [Node],
    memory: &mut EventMemory,
    tolerance: f64,
    slope: f64,
    findings: &mut Findings,
) {
    for node in nodes.iter_mut().skip(1) {
        node.sign = sign_of_sample(node.g, tolerance);
    }
    let ((start, end), instant) = (probe.step.times(), probe.rounding_of_time());
    nodes[0].sign = memory.sign;
    if !memory.begun {
        let passed = slope * (instant / (end - start).abs());
        nodes[0].sign = sign_of_sample(nodes[0].g, tolerance + if passed.is_finite() { passed } else { 0.0 });
        memory.begin(nodes[0].sign, findings);
        memory.zero_at = Some(start).filter(|_| nodes[0].sign == 0);
    }
}

/// Sets the signs of the first samples to zero if the run began at a zero. This concerns samples whose times cannot be
/// distinguished from the start because of rounding.
fn set_start_signs_before_search(probe: &Probe<'_>, nodes: &mut [Node], memory: &mut EventMemory) {
    let Some(zero_at) = memory.zero_at else { return };
    let (end, instant) = (probe.step.times().1, probe.rounding_of_time());
    let within = |n: &&mut Node| (probe.step.time_at(n.theta) - zero_at).abs() <= instant;
    nodes.iter_mut().filter(within).for_each(|n| n.sign = 0);
    memory.zero_at = Some(zero_at).filter(|t| (end - t).abs() <= instant);
}
