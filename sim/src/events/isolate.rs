//! Division of a step into parts on which ranges decide the behaviour of an event function.
//!
//! A part is halved until one of four conditions holds. Its range excludes 0, so that nothing happens in it; or the
//! range of its slope does, so that at most one zero is in it; or it is as narrow as [`resolution`]; or its range is no
//! wider than rounding makes it. Work is counted: a part that is not decided after [`MOST`] ranges stays open.

use tripos_traits::{Enclosure, Interval};

use super::RangeFunction;
use super::samples::{Probe, Sign};
use crate::polynomial::Polynomial;

/// Width of the narrowest part, as a fraction of the step: 2⁻⁴⁰.
const NARROW: f64 = 1.0 / 1_099_511_627_776.0;
/// Largest number of ranges that are computed in a step for one event.
const MOST: u32 = 4096;
/// Number of ranges after which the search gives up on a function that is zero within rounding at all open parts.
const ENOUGH: u32 = 128;

/// Known behaviour of an event function on a part of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Known {
    /// The function has this sign on the whole part.
    Clear(Sign),
    /// The function is finite, and only rises or only falls. It has one zero if its signs at the ends differ, else
    /// none.
    Monotone,
    /// The behaviour is unknown, and no narrower part would decide it.
    Unknown,
    /// The behaviour is undecided so far: the part is to be halved.
    Open,
}

/// Part of a step, from one fraction of the step to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Part {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) known: Known,
}

/// An event function in ranges, along the polynomial of a step.
pub(crate) struct Ranges<'p, 'f> {
    pub(crate) polynomial: &'p mut Polynomial,
    pub(crate) function: &'p mut RangeFunction<'f>,
    /// Space for the ranges of a state.
    pub(crate) y: &'p mut Vec<Enclosure>,
}

impl Ranges<'_, '_> {
    /// Range of the function from one fraction of the step to another, and of its slope by that fraction.
    pub(crate) fn over(&mut self, from: f64, to: f64) -> Enclosure {
        self.polynomial.state(from, to, self.y);
        (self.function)(self.polynomial.time(from, to), self.y)
    }

    /// Spread of the function by rounding alone at a fraction of the step; 0 if it is infinite.
    pub(crate) fn spread(&mut self, theta: f64) -> f64 {
        let width = self.over(theta, theta).value.width();
        if width.is_finite() { width } else { 0.0 }
    }
}

/// Parts of a step in order, and the fraction at which the function first had no value; no part begins at this
/// fraction or later.
pub(crate) struct Isolation {
    pub(crate) parts: Vec<Part>,
    pub(crate) cut: Option<f64>,
}

impl Isolation {
    /// Ends of the parts, in order, up to where the function has no value.
    pub(crate) fn ends(&self) -> impl Iterator<Item = f64> {
        let ends = self.parts.first().map(|part| part.from).into_iter().chain(self.parts.iter().map(|part| part.to));
        ends.filter(|theta| self.cut.is_none_or(|cut| *theta < cut))
    }

    /// Side on which the function is in the whole step; `None` if it is not known to be on one side.
    pub(crate) fn side(&self) -> Option<Sign> {
        match self.parts[..] {
            [Part { known: Known::Clear(side), .. }] if self.cut.is_none() => Some(side),
            _ => None,
        }
    }
}

/// Width of the narrowest part of a step over `span`, s, that is not halved: 2⁻⁴⁰, or 8 ε of the time over the step if
/// that is more.
pub(crate) fn resolution(span: (f64, f64)) -> f64 {
    let (start, end) = span;
    NARROW.max(8.0 * f64::EPSILON * start.abs().max(end.abs()) / (end - start).abs())
}

/// Divides a step into parts on which the behaviour of an event function is known.
pub(crate) fn isolate(probe: &mut Probe<'_>, ranges: &mut Ranges<'_, '_>) -> Isolation {
    let narrow = resolution(probe.step.times());
    let mut search = Search { probe, ranges, narrow, spent: 0, cut: f64::INFINITY, steady: false };
    let mut parts = vec![search.judge(0.0, 1.0)];
    while parts.iter().any(|part| part.known == Known::Open) && !search.gives_up(&parts) {
        parts = search.halve(&parts);
    }
    let cut = search.cut;
    parts.retain(|part| part.from < cut);
    Isolation { parts: joined(&parts), cut: cut.is_finite().then_some(cut) }
}

/// Joins neighbouring parts with the same known behaviour, except monotone and open parts.
fn joined(parts: &[Part]) -> Vec<Part> {
    let mut list: Vec<Part> = Vec::new();
    for part in parts {
        match list.last_mut() {
            Some(last) if last.known == part.known && matches!(part.known, Known::Clear(_) | Known::Unknown) => {
                last.to = part.to;
            }
            _ => list.push(*part),
        }
    }
    list
}

struct Search<'s, 'p, 'r, 'q, 'f> {
    probe: &'s mut Probe<'p>,
    ranges: &'r mut Ranges<'q, 'f>,
    narrow: f64,
    /// Number of ranges that were computed so far.
    spent: u32,
    /// First fraction of the step at which the function has no value; infinite if it has one everywhere.
    cut: f64,
    /// True once the search has checked if the function stays at zero.
    steady: bool,
}

impl Search<'_, '_, '_, '_, '_> {
    fn judge(&mut self, from: f64, to: f64) -> Part {
        self.spent += 1;
        let over = self.ranges.over(from, to);
        let known = if over.value.excludes_zero() {
            Known::Clear(if over.value.lo() > 0.0 { 1 } else { -1 })
        } else if over.value.is_finite() && over.slope.is_finite() && over.slope.excludes_zero() {
            Known::Monotone
        } else {
            self.judge_about_middle(from, to, over)
        };
        Part { from, to, known }
    }

    /// Judges a part by g(x) = g(m) + g'(ξ) (x − m) with the middle m. The overestimate of this form falls with the
    /// square of the width.
    fn judge_about_middle(&mut self, from: f64, to: f64, over: Enclosure) -> Known {
        let middle = f64::midpoint(from, to);
        if over.value.is_undefined() && self.probe.at(middle).is_nan() {
            self.cut = self.cut.min(middle);
        }
        if to - from <= self.narrow {
            return Known::Unknown;
        }
        self.spent += 1;
        let at = self.ranges.over(middle, middle).value;
        let half = 0.5 * (to - from);
        let value = over.value.and(at + over.slope * Interval::new(-half, half));
        if value.excludes_zero() {
            Known::Clear(if value.lo() > 0.0 { 1 } else { -1 })
        } else if value.width() <= 4.0 * at.width() {
            Known::Unknown
        } else {
            Known::Open
        }
    }

    fn halve(&mut self, parts: &[Part]) -> Vec<Part> {
        let mut finer = Vec::with_capacity(parts.len() + 8);
        for part in parts {
            if part.from >= self.cut {
                break;
            }
            if part.known == Known::Open {
                let middle = f64::midpoint(part.from, part.to);
                finer.push(self.judge(part.from, middle));
                finer.push(self.judge(middle, part.to));
            } else {
                finer.push(*part);
            }
        }
        finer
    }

    /// True if the search is to stop: it has computed the largest number of ranges, or the event function is zero
    /// within rounding at all open parts.
    fn gives_up(&mut self, parts: &[Part]) -> bool {
        if self.spent >= ENOUGH && !self.steady {
            self.steady = true;
            let open: Vec<f64> = parts.iter().filter(|p| p.known == Known::Open).map(|p| p.to).collect();
            let tolerance = self.probe.rounding(open[0], 0.0) + 0.5 * self.ranges.spread(open[0]);
            return open.iter().all(|theta| self.probe.at(*theta).abs() <= tolerance);
        }
        self.spent >= MOST
    }
}
