//! Rigorous runs: boxes that provably contain the motion.
//!
//! Every operation of the equations is done on balls (numbers with proved error bounds), the rest of every
//! Taylor polynomial is bounded over all states that the motion can reach in the step, and the set of
//! states is carried by its derivatives. A run ends where no further box can be proved.

mod flow_enclosure;
mod state_set;

pub use flow_enclosure::SeriesInBalls;
use flow_enclosure::{FlowEnclosure, Tube};
use state_set::StateSet;
use tripos_traits::{Ball, Scalar, larger};

/// Options of a rigorous run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigorousOptions {
    /// Highest power of the time in the Taylor polynomials.
    pub order: usize,
    /// Largest rest of a Taylor polynomial, relative to the size of each component.
    pub tolerance: f64,
    /// Largest number of steps.
    pub step_limit: u64,
    /// Largest width of a component's box, relative to 1 and the size of the component; wider boxes end the run.
    pub widest: f64,
}

impl Default for RigorousOptions {
    fn default() -> Self {
        Self { order: 28, tolerance: 1e-30, step_limit: 100_000, widest: 1.0 }
    }
}

/// Reason why a rigorous run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RigorousEnd {
    /// The last instant was reached.
    Reached,
    /// No enclosure could be proved for any step, however short: a divisor may be 0, or the set is too wide.
    NoEnclosure,
    /// The box became wider than the options allow.
    TooWide,
    /// The limit of steps was reached.
    StepLimit,
    /// The observer ended the run.
    Interrupted,
}

/// Result of a rigorous run.
#[derive(Clone, Debug)]
pub struct RigorousRun {
    /// Box of the state at each instant that was reached, in the order of the instants.
    pub boxes: Vec<Vec<Ball>>,
    /// Instant up to which the motion is enclosed, s; the double nearest to it at an instant of the request.
    pub t_end: f64,
    /// Reason why the run ended.
    pub end: RigorousEnd,
    /// Number of steps.
    pub steps: u64,
    /// Number of steps that were tried and could not be proved, or whose rest was too large.
    pub rejected: u64,
}

/// Piece of a rigorous run, for an observer: all motions between two instants.
pub struct Passage<'a> {
    /// Ball of the instant at the start of the step, s.
    pub t: Ball<f64>,
    /// Length of the step, s.
    pub h: f64,
    /// Enclosure of the motions over the step.
    tube: &'a Tube,
}

impl Passage<'_> {
    /// Box that contains the state at all instants between two instants of the step, which are given in seconds
    /// after its start.
    #[must_use]
    pub fn bounds_between(&self, from: f64, to: f64) -> Vec<Ball<f64>> {
        self.tube.bounds_between(from, to)
    }
}

/// Encloses the motion that begins in the box `start` at the instant `t0`, s, at each of the given `instants`,
/// which must increase.
///
/// `observer` sees each step and returns false to end the run. The instants are balls, since an instant such as
/// 0.1 s is no double; the boxes hold at the exact instant.
///
/// Every result holds for a processor that rounds to nearest.
pub fn enclose(
    series: SeriesInBalls<'_>,
    parameters: &[Ball],
    t0: Ball,
    start: &[Ball],
    instants: &[Ball],
    options: &RigorousOptions,
    mut observer: impl FnMut(&Passage<'_>) -> bool,
) -> RigorousRun {
    let narrow_parameters = parameters.iter().map(|x| Ball::narrowed(*x)).collect();
    let flow = FlowEnclosure { series, parameters, narrow_parameters, order: options.order };
    let mut set = {
        let is_last = flow.moves_alike(start);
        StateSet::of_box(start, |at| is_last[at])
    };
    let mut run = RigorousRun { boxes: Vec::new(), t_end: t0.low(), end: RigorousEnd::Reached, steps: 0, rejected: 0 };
    let mut t = t0;
    let mut h = f64::INFINITY;
    for instant in instants {
        loop {
            let left = *instant - t;
            if left.high() <= 0.0 || left.centre.hi() <= 0.0 {
                break;
            }
            if run.steps >= options.step_limit {
                run.end = RigorousEnd::StepLimit;
                return run;
            }
            let Some(step) = proved_step(&flow, &set, left, h, options, &mut run.rejected) else {
                run.end = RigorousEnd::NoEnclosure;
                return run;
            };
            run.steps += 1;
            let passage = Passage { t: Ball::narrowed(t), h: step.length.high(), tube: &step.tube };
            let goes_on = observer(&passage);
            set = flow.advanced(&set, step.length, &step.rest);
            t = if step.is_last { *instant } else { t + step.length };
            run.t_end = if step.is_last { instant.centre.hi() } else { t.low() };
            h = step.next;
            let too_wide = |x: &Ball| !x.is_defined() || 2.0 * x.radius > options.widest * (1.0 + x.centre.hi().abs());
            if set.bounds().iter().any(too_wide) {
                run.end = RigorousEnd::TooWide;
                return run;
            }
            if !goes_on {
                run.end = RigorousEnd::Interrupted;
                return run;
            }
        }
        run.boxes.push(set.bounds());
    }
    run
}

/// Step whose motions are enclosed.
struct ProvedStep {
    /// Length of the step, s.
    length: Ball,
    /// True if the step ends at the next instant.
    is_last: bool,
    /// Enclosure of the motions over the step.
    tube: Tube,
    /// Rest of the Taylor polynomials at the end of the step.
    rest: Vec<Ball<f64>>,
    /// Length that the next step should have, s.
    next: f64,
}

/// Finds a step of at most `left` and about `wanted` seconds whose motions are enclosed with a small rest. `None`
/// if no step is proved.
fn proved_step(
    flow: &FlowEnclosure<'_>,
    set: &StateSet,
    left: Ball,
    wanted: f64,
    options: &RigorousOptions,
    rejected: &mut u64,
) -> Option<ProvedStep> {
    /// Number of trials before a step counts as impossible.
    const TRIALS: u32 = 60;
    /// Part of the length that the rest allows.
    const SAFETY: f64 = 0.9;
    let states = set.bounds();
    let bounds: Vec<Ball<f64>> = states.iter().map(|x| Ball::narrowed(*x)).collect();
    let mut h = wanted.min(left.high());
    for _ in 0..TRIALS {
        let is_last = h >= left.centre.hi() * (1.0 - 1e-9);
        // Lengths with few digits keep the instants exact.
        let length = if is_last { left } else { Ball::from_f64(few_digits(h)) };
        let upper = length.high();
        let Some(tube) = flow.tube(&bounds, upper) else {
            *rejected += 1;
            h = upper * 0.5;
            continue;
        };
        let rest = flow.rest(&tube, length);
        let allowed = |x: &Ball| options.tolerance * (x.size() + f64::MIN_POSITIVE) + 1e-3 * x.radius;
        let reach = |(x, whole): (&Ball, &Ball<f64>)| allowed(x) + options.tolerance * whole.radius;
        let ratio = rest.iter().zip(states.iter().zip(&tube.bounds).map(reach));
        let ratio = ratio.fold(0.0, |most: f64, (rest, allowed)| larger(most, rest.size() / allowed));
        let factor = (SAFETY * ratio.recip().powf(1.0 / (options.order + 1) as f64)).clamp(0.2, 2.0);
        if ratio <= 1.0 {
            return Some(ProvedStep { length, is_last, tube, rest, next: upper * factor });
        }
        *rejected += 1;
        h = upper * factor.min(0.95);
    }
    None
}

/// The number with its last 30 binary digits cleared, so that sums of such numbers are exact with 32 digits.
fn few_digits(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & !((1 << 30) - 1))
}
