//! What one event function did during one step.
//!
//! Invariant: `Memory::side` is the side of zero the function was last known to be on, and every
//! sign change against it is reported exactly once. See [`crate::events`] for the conventions.

use crate::events::Kind;
use crate::root::{self, NotANumber};
use crate::samples::{Node, Probe, Sign, hidden_extrema, may_dip, sign};

/// The slope at the ends of a step is taken over this fraction of it: the root of ε, below which a
/// smooth function cannot turn by more than rounding.
const DELTA: f64 = 1.0 / 67_108_864.0;
/// Samples a step, evenly spaced.
const INTERVALS: u32 = 8;
/// Where to look for the side on which a function leaves zero: 2⁻²⁰, 2⁻¹⁴ and 2⁻⁸ of a step away.
const LADDER: [f64; 3] = [1.0 / 1_048_576.0, 1.0 / 16_384.0, 1.0 / 256.0];

/// What is known of an event function at the start of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Memory {
    /// Its value there.
    pub(crate) value: f64,
    /// The sign of that value.
    pub(crate) sign: Sign,
    /// The side it was last on; 0 if it has been zero since the start of the run.
    pub(crate) side: Sign,
    /// Whether a step has been searched.
    pub(crate) begun: bool,
    /// The side assumed for a run that starts at zero.
    pub(crate) side_at_zero: Sign,
}

/// Something the function did, at a fraction of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Found {
    pub(crate) theta: f64,
    pub(crate) kind: Kind,
}

/// What a step held, in no particular order, up to where the function stopped having a value.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Findings {
    pub(crate) found: Vec<Found>,
    pub(crate) not_a_number: Option<f64>,
}

/// Looks at one step; `memory` moves on to its end.
pub(crate) fn search(probe: &mut Probe<'_>, memory: &mut Memory) -> Findings {
    let mut findings = Findings::default();
    let nodes = &mut gather(probe, memory, &mut findings);
    let scale = nodes.iter().map(|n| n.g.abs()).filter(|g| g.is_finite()).fold(0.0, f64::max);
    if !(memory.begun && is_quiet(nodes, memory, scale)) {
        let outcome = examine(probe, nodes, memory, scale, &mut findings);
        if let Err(NotANumber { at }) = outcome {
            let first = findings.not_a_number.map_or(at, |theta| theta.min(at));
            findings.not_a_number = Some(first);
        }
    }
    memory.begun = true;
    if let Some(end) = nodes.last() {
        (memory.value, memory.sign) = (end.g, end.sign);
    }
    findings
}

/// The samples, in order, up to the first that is not a number.
fn gather(probe: &mut Probe<'_>, memory: &Memory, findings: &mut Findings) -> Vec<Node> {
    let mut nodes = vec![Node { theta: 0.0, g: memory.value, sign: memory.sign }];
    let thetas = (1..INTERVALS).map(|i| f64::from(i) / f64::from(INTERVALS));
    let thetas = std::iter::once(DELTA).chain(thetas).chain([1.0 - DELTA, 1.0]);
    sample(probe, thetas, &mut nodes, findings);
    if is_far(&nodes) {
        return nodes;
    }
    let hidden: Vec<f64> = (1..nodes.len()).flat_map(|k| hidden_extrema(&nodes, k)).collect();
    sample(probe, hidden.into_iter(), &mut nodes, findings);
    if let Some(end) = findings.not_a_number {
        nodes.retain(|n| n.theta < end);
    }
    nodes.sort_by(|a, b| a.theta.total_cmp(&b.theta));
    nodes.dedup_by(|a, b| a.theta.total_cmp(&b.theta).is_eq());
    nodes
}

/// Whether the function stays 4 times as far from zero as it varies: a shortcut for the common case.
fn is_far(nodes: &[Node]) -> bool {
    let low = nodes.iter().map(|n| n.g).fold(f64::INFINITY, f64::min);
    let high = nodes.iter().map(|n| n.g).fold(f64::NEG_INFINITY, f64::max);
    low.max(-high) > 4.0 * (high - low)
}

/// Appends samples until one is not a number.
fn sample(probe: &mut Probe<'_>, thetas: impl Iterator<Item = f64>, nodes: &mut Vec<Node>, findings: &mut Findings) {
    for theta in thetas {
        let g = probe.at(theta);
        if g.is_nan() {
            findings.not_a_number = Some(theta);
            return;
        }
        nodes.push(Node { theta, g, sign: sign(g, 0.0) });
    }
}

/// Whether the samples leave no doubt that nothing happened.
fn is_quiet(nodes: &[Node], memory: &Memory, scale: f64) -> bool {
    if is_far(nodes) && nodes[0].sign == memory.side {
        return true;
    }
    let same_side = nodes.iter().all(|n| n.sign == memory.side);
    let end_is_clear = nodes.last().is_some_and(|n| n.g.abs() > 1e-6 * scale);
    same_side && end_is_clear && !(1..nodes.len()).any(|k| may_dip(nodes, k))
}

/// Tells zeros from rounding, then walks over the samples.
fn examine(
    probe: &mut Probe<'_>,
    nodes: &mut Vec<Node>,
    memory: &mut Memory,
    scale: f64,
    findings: &mut Findings,
) -> Result<(), NotANumber> {
    let nearest = nodes.iter().min_by(|a, b| a.g.abs().total_cmp(&b.g.abs()));
    let tolerance = probe.rounding(nearest.map_or(0.0, |n| n.theta), scale);
    for node in nodes.iter_mut().skip(usize::from(memory.begun)) {
        node.sign = sign(node.g, tolerance);
    }
    if !memory.begun {
        memory.side = nodes[0].sign;
        if memory.side == 0 {
            memory.side = memory.side_at_zero;
            findings.found.push(Found { theta: 0.0, kind: Kind::AtStart });
        }
    }
    if nodes[0].sign == 0 && nodes.len() > 2 {
        let mut ladder = Vec::new();
        for theta in LADDER {
            let g = probe.value_at(theta)?;
            ladder.push(Node { theta, g, sign: sign(g, tolerance) });
        }
        nodes.splice(2..2, ladder);
    }
    walk(probe, nodes, memory, tolerance, findings)
}

fn crossing_to(side: Sign, theta: f64) -> Found {
    Found { theta, kind: if side > 0 { Kind::Rising } else { Kind::Falling } }
}

fn walk(
    probe: &mut Probe<'_>,
    nodes: &[Node],
    memory: &mut Memory,
    tolerance: f64,
    findings: &mut Findings,
) -> Result<(), NotANumber> {
    // Last sample clearly on a side, and the first of the zeros after it. Zeros that begin with the
    // step were dealt with at the end of the step before.
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
            let theta = locate(probe, nodes, clear.unwrap_or(k.saturating_sub(1)), k)?;
            findings.found.push(crossing_to(node.sign, theta));
            memory.side = node.sign;
        } else if let (Some(low), Some(_)) = (clear, zeros) {
            dip(probe, [nodes[low], *node], tolerance, findings)?;
        } else if k > 0 && may_dip(nodes, k) {
            dip(probe, [nodes[k - 1], *node], tolerance, findings)?;
        }
        (clear, zeros) = (Some(k), None);
    }
    if let Some(z) = zeros.filter(|z| *z > 0) {
        findings.found.push(arrive(probe, &nodes[z..], memory, tolerance));
    }
    Ok(())
}

/// The zero between samples `low` and `high`; the last sample before `high` if they do not bracket
/// one.
fn locate(probe: &mut Probe<'_>, nodes: &[Node], low: usize, high: usize) -> Result<f64, NotANumber> {
    let (a, b) = (nodes[low], nodes[high]);
    if (a.g < 0.0) == (b.g < 0.0) || a.g == 0.0 {
        return Ok(nodes[high.saturating_sub(1)].theta);
    }
    root::zero(&mut |theta| probe.at(theta), (a.theta, a.g), (b.theta, b.g), 0.0)
}

/// Follows |g| down between two samples of one side: two crossings, a touch, or nothing.
fn dip(probe: &mut Probe<'_>, [a, b]: [Node; 2], tolerance: f64, findings: &mut Findings) -> Result<(), NotANumber> {
    let side = f64::from(a.sign);
    let mut height = |theta| side * probe.at(theta);
    let (theta, least) = root::minimum(&mut height, (a.theta, b.theta), -tolerance)?;
    if least < -tolerance {
        let mut g = |theta| probe.at(theta);
        let bottom = (theta, side * least);
        let first = root::zero(&mut g, (a.theta, a.g), bottom, 0.0)?;
        let second = root::zero(&mut g, bottom, (b.theta, b.g), 0.0)?;
        findings.found.push(crossing_to(-a.sign, first));
        findings.found.push(crossing_to(a.sign, second));
    } else if least <= tolerance {
        findings.found.push(Found { theta, kind: Kind::Touch });
    }
    Ok(())
}

/// A function that is zero at the last sample, since the first of `zeros`: a touch if it goes back
/// a little beyond, else a crossing.
fn arrive(probe: &mut Probe<'_>, zeros: &[Node], memory: &mut Memory, tolerance: f64) -> Found {
    let end = zeros.last().map_or(1.0, |n| n.theta);
    let mut sides = LADDER.iter().map(|d| sign_or_zero(probe.at(end + d), tolerance));
    let beyond = sides.find(|s| *s != 0);
    let nearest = zeros.iter().rev().min_by(|a, b| a.g.abs().total_cmp(&b.g.abs()));
    let nearest = nearest.map_or(end, |n| n.theta);
    if beyond == Some(memory.side) {
        return Found { theta: nearest, kind: Kind::Touch };
    }
    memory.side = -memory.side;
    // A function that stays at zero arrived at the first of them.
    let theta = if beyond.is_some() { nearest } else { zeros[0].theta };
    crossing_to(memory.side, theta)
}

fn sign_or_zero(g: f64, tolerance: f64) -> Sign {
    if g.is_nan() { 0 } else { sign(g, tolerance) }
}
