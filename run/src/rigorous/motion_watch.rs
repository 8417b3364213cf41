//! Ranges, verdicts on claims and crossings of events, collected along a rigorous run.

use super::claims::ClaimVerdict;
use super::crossings::{Crossing, EventSearch, Sign, contracted_zero};
use super::observed_equations::ObservedEquations;
use std::ops::ControlFlow;
use tripos_sim::rigorous_run::Passage;
use tripos_traits::{Ball, Dual, Interval, Rates, Scalar};

/// Number of parts of a step over which ranges are bounded one by one.
const PARTS: usize = 8;
/// Number of times that a part of a step is divided while a claim or an event is undecided in it.
const DIVISIONS: u32 = 14;

/// Collector of everything that is proved at all instants of a rigorous run.
///
/// The observed quantities are, in this order: the shown ones, the distances of the claims, the event functions.
pub struct MotionWatch<'a> {
    /// Equations with the observed quantities, in balls of doubles.
    pub narrow: &'a ObservedEquations<Ball<f64>>,
    /// Equations with the observed quantities, in balls of doubles with derivatives.
    pub slopes: &'a ObservedEquations<Dual<Ball<f64>>>,
    /// Values of the parameters of the equations.
    pub parameters: Vec<Ball<f64>>,
    /// First instant of the run, s.
    pub from: Ball<f64>,
    /// Range of each shown quantity so far.
    pub ranges: Vec<Interval>,
    /// Verdict on each claim so far.
    pub verdicts: Vec<ClaimVerdict>,
    /// Search for each event.
    pub events: Vec<EventSearch>,
    /// Crossings of events so far.
    pub crossings: Vec<Crossing>,
}

/// Bounds of the observed quantities at all instants of a part of a step.
struct PartBounds {
    /// Bounds of the values.
    values: Vec<Ball<f64>>,
    /// Bounds of the rates, per second; empty if the values decide all claims and events.
    rates: Vec<Ball<f64>>,
}

/// Event function over a part of a step.
#[derive(Clone, Copy)]
enum EventInPart {
    /// The function has this sign at all instants of the part.
    Signed(Sign),
    /// The function may be 0, and its slope is in this ball, without 0, at all instants of the part.
    Sloped(Ball<f64>),
    /// Nothing is proved.
    Unknown,
}

impl MotionWatch<'_> {
    /// Goes on over a step. Breaks where a terminal event ends the motion, or may end it.
    pub fn watch(&mut self, passage: &Passage<'_>) -> ControlFlow<()> {
        (0..PARTS).try_for_each(|part| {
            let after = |part: usize| passage.h * (part as f64 / PARTS as f64);
            let to = if part + 1 == PARTS { passage.h } else { after(part + 1) };
            self.watch_part(passage, (after(part), to), DIVISIONS)
        })
    }

    /// Ends the run: adds the events that are undecided at its end.
    pub fn finish(&mut self) {
        let open = self.events.iter_mut().filter_map(EventSearch::finish);
        self.crossings.extend(open);
    }

    /// Goes on over a part of a step, between two instants in s after its start. A part that leaves a claim or an event
    /// undecided is divided up to `divisions` times.
    fn watch_part(&mut self, passage: &Passage<'_>, (a, b): (f64, f64), divisions: u32) -> ControlFlow<()> {
        let bounds = self.bounds(passage, (a, b));
        let events = self.events_in_part(passage, (a, b), &bounds);
        if divisions > 0 {
            let cuts = self.cuts(passage, (a, b), &bounds.values, &events);
            if !cuts.is_empty() {
                let starts = std::iter::once(a).chain(cuts.iter().copied());
                let ends = cuts.iter().copied().chain([b]);
                return starts.zip(ends).try_for_each(|part| self.watch_part(passage, part, divisions - 1));
            }
        }
        let (t, shown) = (passage.t + Ball::between(a, b), self.ranges.len());
        let values = bounds.values;
        let mut is_ended = false;
        for (search, found) in self.events.iter_mut().zip(&events) {
            let instants = (t.low(), t.high());
            let crossing = match found {
                EventInPart::Signed(sign) => search.go_on_with_sign(*sign),
                EventInPart::Sloped(slope) => {
                    search.go_on_without_sign(instants, Sign::of(*slope), &values[..shown]);
                    None
                }
                EventInPart::Unknown => {
                    search.go_on_without_sign(instants, None, &values[..shown]);
                    None
                }
            };
            is_ended |= crossing.is_some() && search.is_terminal;
            self.crossings.extend(crossing);
        }
        if is_ended {
            return ControlFlow::Break(());
        }
        for (range, x) in self.ranges.iter_mut().zip(&values) {
            *range = Interval::new(x.low().min(range.lo()), x.high().max(range.hi()));
        }
        let end = passage.t + Ball::point(b);
        let may_be_over = self.events.iter().any(|search| search.is_terminal && search.may_have_occurred());
        for (verdict, distance) in self.verdicts.iter_mut().zip(&values[shown..]) {
            verdict.go_on(*distance, end, may_be_over);
        }
        ControlFlow::Continue(())
    }

    /// Bounds of the observed quantities between two instants of a step. If the values leave a claim or an event
    /// undecided, each is the narrower of its bound and of the one that follows from the value in the middle and the
    /// rate.
    fn bounds(&self, passage: &Passage<'_>, (a, b): (f64, f64)) -> PartBounds {
        let values = self.values(passage, (a, b));
        if !self.is_undecided(&values) {
            return PartBounds { values, rates: Vec::new() };
        }
        let middle = 0.5 * a + 0.5 * b;
        let away = Ball::between(a, b) - Ball::point(middle);
        let (at_middle, rates) = (self.values(passage, (middle, middle)), self.rates(passage, (a, b)));
        let tighter = |((value, centre), rate): ((&Ball<f64>, &Ball<f64>), &Ball<f64>)| {
            let near = *centre + *rate * away;
            if near.is_defined() && (near.radius < value.radius || !value.is_defined()) { near } else { *value }
        };
        PartBounds { values: values.iter().zip(&at_middle).zip(&rates).map(tighter).collect(), rates }
    }

    /// Observed quantities at all instants between two instants of a step, s after its start.
    fn values(&self, passage: &Passage<'_>, (a, b): (f64, f64)) -> Vec<Ball<f64>> {
        let time = passage.t + Ball::between(a, b) - self.from;
        self.narrow.observed(&self.parameters, time, &passage.bounds_between(a, b))
    }

    /// True if a claim may be kept or broken by the given values, or if an event function may be 0.
    fn is_undecided(&self, values: &[Ball<f64>]) -> bool {
        let mut claims = self.verdicts.iter().zip(&values[self.ranges.len()..]);
        claims.any(|(verdict, distance)| verdict.is_undecided(*distance))
            || values[self.first_event()..].iter().any(|value| Sign::of(*value).is_none())
    }

    /// Index of the first event function among the observed quantities.
    fn first_event(&self) -> usize {
        self.ranges.len() + self.verdicts.len()
    }

    /// Rates of the observed quantities at all instants between two instants of a step.
    fn rates(&self, passage: &Passage<'_>, (a, b): (f64, f64)) -> Vec<Ball<f64>> {
        let state = passage.bounds_between(a, b);
        let equations = &self.narrow.equations;
        let (q, v) = state.split_at(equations.lengths().coordinates);
        let mut rates = vec![Ball::int(0); state.len()];
        let (q_dot, v_dot) = rates.split_at_mut(q.len());
        equations.rates(&self.parameters, q, v, q_dot, v_dot);
        let moving = |(value, slope): (&Ball<f64>, &Ball<f64>)| Dual { value: *value, slope: *slope };
        let state: Vec<_> = state.iter().zip(&rates).map(moving).collect();
        let parameters: Vec<_> = self.parameters.iter().map(|p| Dual::constant(*p)).collect();
        let time = Dual { value: passage.t + Ball::between(a, b) - self.from, slope: Ball::int(1) };
        self.slopes.observed(&parameters, time, &state).iter().map(|x| x.slope).collect()
    }

    /// Proved properties of each event function between two instants of a step, where the observed quantities have the
    /// given bounds.
    fn events_in_part(&self, passage: &Passage<'_>, (a, b): (f64, f64), bounds: &PartBounds) -> Vec<EventInPart> {
        let first = self.first_event();
        let signs: Vec<Option<Sign>> = bounds.values[first..].iter().map(|value| Sign::of(*value)).collect();
        if signs.iter().all(Option::is_some) {
            return signs.into_iter().flatten().map(EventInPart::Signed).collect();
        }
        let [at_start, at_end] = [a, b].map(|x| self.values(passage, (x, x)));
        let found = |(at, sign): (usize, &Option<Sign>)| {
            if let Some(sign) = sign {
                return EventInPart::Signed(*sign);
            }
            let slope = bounds.rates[first + at];
            if Sign::of(slope).is_none() {
                return EventInPart::Unknown;
            }
            let at_start = Sign::of(at_start[first + at]);
            // Between instants with equal signs, a function with a slope of one sign is not 0.
            match at_start {
                Some(sign) if at_start == Sign::of(at_end[first + at]) => EventInPart::Signed(sign),
                _ => EventInPart::Sloped(slope),
            }
        };
        signs.iter().enumerate().map(found).collect()
    }

    /// Instants at which a part of a step is divided, s after the start of the step: around the only zero of an event
    /// function, or in the middle if a claim or an event is undecided. Empty if nothing is gained by a division.
    fn cuts(
        &self,
        passage: &Passage<'_>,
        (a, b): (f64, f64),
        values: &[Ball<f64>],
        events: &[EventInPart],
    ) -> Vec<f64> {
        let (shown, first) = (self.ranges.len(), self.first_event());
        for (at, event) in events.iter().enumerate() {
            let EventInPart::Sloped(slope) = event else { continue };
            let value = |x: f64| self.values(passage, (x, x))[first + at];
            if let Some((low, high)) = contracted_zero((a, b), *slope, value) {
                let [low, high] = [(low, a), (high, b)].map(|(zero, end)| instant_with_sign(zero, end, &value));
                let cuts: Vec<f64> = [low, high].into_iter().filter(|x| *x > a && *x < b).collect();
                if high - low < 0.5 * (b - a) {
                    return cuts;
                }
            }
        }
        let mut claims = self.verdicts.iter().zip(&values[shown..]);
        let is_undecided = claims.any(|(verdict, distance)| verdict.is_undecided(*distance))
            || events.iter().any(|event| matches!(event, EventInPart::Unknown));
        let middle = 0.5 * a + 0.5 * b;
        if is_undecided && middle > a && middle < b { vec![middle] } else { Vec::new() }
    }
}

/// Instant between `zero` and `end`, near `zero`, at which a function has a proved sign; `end` if none is found.
fn instant_with_sign(zero: f64, end: f64, value: &impl Fn(f64) -> Ball<f64>) -> f64 {
    /// Number of distances that are tried, each twice the last.
    const DISTANCES: i32 = 60;
    let whole = end - zero;
    let tried = (0..DISTANCES).map(|k| zero + whole * f64::exp2(f64::from(k - DISTANCES)));
    tried.into_iter().find(|x| Sign::of(value(*x)).is_some()).unwrap_or(end)
}
