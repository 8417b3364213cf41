//! Division of a step into parts on which interval arithmetic decides the behaviour of an event function.
//!
//! A part is halved until one of four conditions holds. The range of the function excludes 0, so that it has no zero in
//! the part. The range of its slope excludes 0, so that it has at most one zero. The part is as narrow as
//! [`isolation_resolution`]. The range is no wider than rounding makes it. The number of ranges is limited: a part that
//! is not decided after [`MOST`] ranges stays open.

use tripos_traits::{Enclosure, Interval};

use super::RangeFunction;
use super::probe::Probe;
use super::samples::Sign;
use crate::step_polynomial::StepPolynomial;

/// Width of the narrowest part of a step that the search for events makes, as a fraction of the step:
/// 2⁻⁴⁰.
const NARROW: f64 = 1.0 / 1_099_511_627_776.0;
/// Largest number of ranges that are computed in a step for a single event.
const MOST: u32 = 4096;
/// Number of ranges after which the search tests if the event function is zero within rounding at all undecided parts.
/// If it is, the search gives up.
const ENOUGH: u32 = 128;

/// Known behaviour of an event function on a part of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Known {
    /// The event function has this sign, 1 or −1, on the whole part of the step.
    Clear(Sign),
    /// The function is finite, and only rises or only falls. It has a single zero if its signs at the ends
    /// of the part differ, else none.
    Monotone,
    /// The behaviour is not known, and halving the part would not reveal it.
    Unknown,
    /// The behaviour is not decided yet: the part must be halved.
    Open,
}

/// Part of a step between two fractions of it, with the known behaviour of an event function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Part {
    /// Fraction of the step at which the part begins.
    pub(crate) from: f64,
    /// Fraction of the step at which the part ends.
    pub(crate) to: f64,
    /// Known behaviour of the event function on the part.
    pub(crate) known: Known,
}

/// Event function in interval arithmetic, along the polynomial dense output of a step.
pub(crate) struct Ranges<'p, 'f> {
    /// Dense output of the step, as a polynomial for each component of the state.
    pub(crate) polynomial: &'p mut StepPolynomial,
    /// Event function of ranges of time and state.
    pub(crate) function: &'p mut RangeFunction<'f>,
    /// Working space for the ranges of a state.
    pub(crate) y: &'p mut Vec<Enclosure>,
}

impl Ranges<'_, '_> {
    /// Range of the event function between the fractions `from` and `to` of the step, with the range of its derivative
    /// by the fraction of the step.
    pub(crate) fn range_over_part(&mut self, from: f64, to: f64) -> Enclosure {
        self.polynomial.state(from, to, self.y);
        (self.function)(self.polynomial.time(from, to), self.y)
    }

    /// Width of the event function's range at the fraction `theta` of the step, caused by rounding alone; 0 if it is
    /// infinite.
    pub(crate) fn rounding_spread(&mut self, theta: f64) -> f64 {
        let width = self.range_over_part(theta, theta).value.width();
        if width.is_finite() { width } else { 0.0 }
    }
}

/// Division of a step into parts with known behaviour of an event function.
pub(crate) struct Isolation {
    /// Parts of the step in order, each with the known behaviour of the event function.
    pub(crate) parts: Vec<Part>,
    /// First fraction of the step at which the event function has no value; `None` if it has values everywhere. All
    /// parts begin before it.
    pub(crate) cut: Option<f64>,
}

impl Isolation {
    /// Ends of all parts as fractions of the step, in order. Fractions from which on the function has no value are left
    /// out.
    pub(crate) fn ends(&self) -> impl Iterator<Item = f64> {
        let ends = self.parts.first().map(|part| part.from).into_iter().chain(self.parts.iter().map(|part| part.to));
        ends.filter(|theta| self.cut.is_none_or(|cut| *theta < cut))
    }

    /// Sign of the event function, 1 or −1, if it is the same in the whole step; `None` if that is not
    /// known.
    pub(crate) fn side_of_whole_step(&self) -> Option<Sign> {
        match self.parts[..] {
            [Part { known: Known::Clear(side), .. }] if self.cut.is_none() => Some(side),
            _ => None,
        }
    }
}

/// Width below which a part of a step over `span`, s, is not halved any more, as a fraction of the step. It is 2⁻⁴⁰, or
/// 8 ε of the time divided by the length of the step if that is more.
pub(crate) fn isolation_resolution(span: (f64, f64)) -> f64 {
    let (start, end) = span;
    NARROW.max(8.0 * f64::EPSILON * start.abs().max(end.abs()) / (end - start).abs())
}

/// Divides a step into parts on which the behaviour of an event function is known.
pub(crate) fn isolate(probe: &mut Probe<'_>, ranges: &mut Ranges<'_, '_>) -> Isolation {
    let narrow = isolation_resolution(probe.step.times());
    let mut search = IsolationSearch { probe, ranges, narrow, spent: 0, cut: f64::INFINITY, steady: false };
    let mut parts = vec![search.judge_part(0.0, 1.0)];
    while parts.iter().any(|part| part.known == Known::Open) && !search.gives_up(&parts) {
        parts = search.halve_parts(&parts);
    }
    let cut = search.cut;
    parts.retain(|part| part.from < cut);
    Isolation { parts: join_parts(&parts), cut: cut.is_finite().then_some(cut) }
}

/// Joins neighbouring parts with the same known behaviour, except monotone and open parts.
fn join_parts(parts: &[Part]) -> Vec<Part> {
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

/// Search that divides a step into parts with known behaviour of an event function.
struct IsolationSearch<'s, 'p, 'r, 'q, 'f> {
    /// Event function along the step, evaluated at single points.
    probe: &'s mut Probe<'p>,
    /// Event function along the step, evaluated on ranges by interval arithmetic.
    ranges: &'r mut Ranges<'q, 'f>,
    /// Width at which a part is not halved any more, as a fraction of the step.
    narrow: f64,
    /// Number of ranges of the event function that were computed so far.
    spent: u32,
    /// First fraction of the step at which the event function has no value; infinite if it has values
    /// everywhere.
    cut: f64,
    /// True once the search has tested if the event function is zero at all undecided parts.
    steady: bool,
}

impl IsolationSearch<'_, '_, '_, '_, '_> {
    /// Finds the behaviour of the event function between the fractions `from` and `to` of the step.
    fn judge_part(&mut self, from: f64, to: f64) -> Part {
        self.spent += 1;
        let over = self.ranges.range_over_part(from, to);
        let known = if over.value.excludes_zero() {
            Known::Clear(if over.value.lo() > 0.0 { 1 } else { -1 })
        } else if over.value.is_finite() && over.slope.is_finite() && over.slope.excludes_zero() {
            Known::Monotone
        } else {
            self.judge_about_middle(from, to, over)
        };
        Part { from, to, known }
    }

    /// Finds the behaviour of the event function g on a part by g(x) = g(m) + g'(ξ) (x − m), with the middle m. `over`
    /// has the ranges of g and g' on the part.
    ///
    /// The overestimate of the range by this form falls with the square of the part's width.
    fn judge_about_middle(&mut self, from: f64, to: f64, over: Enclosure) -> Known {
        let middle = f64::midpoint(from, to);
        if over.value.is_undefined() && self.probe.event_value(middle).is_nan() {
            self.cut = self.cut.min(middle);
        }
        if to - from <= self.narrow {
            return Known::Unknown;
        }
        self.spent += 1;
        let at = self.ranges.range_over_part(middle, middle).value;
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

    /// Halves all undecided parts, and finds the behaviour of the event function on the halves.
    fn halve_parts(&mut self, parts: &[Part]) -> Vec<Part> {
        let mut finer = Vec::with_capacity(parts.len() + 8);
        for part in parts {
            if part.from >= self.cut {
                break;
            }
            if part.known == Known::Open {
                let middle = f64::midpoint(part.from, part.to);
                finer.push(self.judge_part(part.from, middle));
                finer.push(self.judge_part(middle, part.to));
            } else {
                finer.push(*part);
            }
        }
        finer
    }

    /// True if the search must stop. Either it has computed the largest number of ranges, or the event
    /// function is zero within rounding at all undecided parts.
    fn gives_up(&mut self, parts: &[Part]) -> bool {
        if self.spent >= ENOUGH && !self.steady {
            self.steady = true;
            let open: Vec<f64> = parts.iter().filter(|p| p.known == Known::Open).map(|p| p.to).collect();
            let tolerance = self.probe.rounding(open[0], 0.0) + 0.5 * self.ranges.rounding_spread(open[0]);
            return open.iter().all(|theta| self.probe.event_value(*theta).abs() <= tolerance);
        }
        self.spent >= MOST
    }
}
