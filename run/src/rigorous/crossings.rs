//! Instants of events in rigorous runs, enclosed by an interval Newton method.
//!
//! Method: E. Hansen & G. W. Walster, *Global Optimization Using Interval Analysis*, 2nd ed. (2004), chapter 9. If the
//! slope of a function is bounded away from 0 over an interval, the function has at most one zero there, and it has
//! one if its signs at the ends differ.

use tripos_traits::{Ball, Direction, DoubleDouble, Scalar};

/// Instants between which an event occurs in a rigorous run.
#[derive(Clone, Debug)]
pub struct Crossing {
    /// Index of the event in the scene.
    pub event: usize,
    /// Instant before the event, s.
    pub from: f64,
    /// Instant after the event, s.
    pub to: f64,
    /// Proved number of crossings between the two instants.
    pub count: CrossingCount,
    /// Balls of the shown quantities at all instants between the two, in SI units.
    pub shown: Vec<Ball<f64>>,
}

/// Number of crossings that is proved between two instants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CrossingCount {
    /// Exactly one crossing.
    One,
    /// At least one crossing.
    AtLeastOne,
    /// No number: the event function comes near 0 and may cross it, touch it, or stay away from it.
    Open,
}

/// Sign of a function that is proved not to be 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Sign of numbers below 0.
    Negative,
    /// Sign of numbers above 0.
    Positive,
}

impl Sign {
    /// Sign of all numbers of a ball; `None` if the ball contains 0 or is undefined.
    pub fn of(ball: Ball<f64>) -> Option<Self> {
        if !ball.is_defined() {
            return None;
        }
        match (ball.low() > 0.0, ball.high() < 0.0) {
            (true, _) => Some(Self::Positive),
            (_, true) => Some(Self::Negative),
            _ => None,
        }
    }
}

/// Search for the crossings of one event along a rigorous run.
pub struct EventSearch {
    /// Index of the event in the scene.
    pub event: usize,
    /// Directions of the crossings that count.
    pub direction: Direction,
    /// True if the event ends the motion.
    pub is_terminal: bool,
    /// Last proved sign of the event function; `None` before the first one.
    sign: Option<Sign>,
    /// True if the event function is exactly 0 at the start.
    starts_at_zero: bool,
    /// Instants since the last proved sign at which the event function may be 0; `None` if there are none.
    window: Option<Window>,
}

/// Instants at which an event function may be 0.
struct Window {
    /// First instant, s.
    from: f64,
    /// Last instant, s.
    to: f64,
    /// Sign of the function's slope at all these instants; `None` if it is not proved.
    slope: Option<Sign>,
    /// Balls of the shown quantities at these instants.
    shown: Vec<Ball<f64>>,
}

impl EventSearch {
    /// Search for an event whose function is in the ball `start` at the first instant.
    pub fn new(event: usize, direction: Direction, is_terminal: bool, start: Ball) -> Self {
        let starts_at_zero = start.radius == 0.0 && start.centre == DoubleDouble::int(0);
        let sign = Sign::of(Ball::narrowed(start));
        Self { event, direction, is_terminal, sign, starts_at_zero, window: None }
    }

    /// True if the event may have occurred since the last proved sign.
    pub fn may_have_occurred(&self) -> bool {
        self.window.is_some()
    }

    /// Goes on over instants at which the event function has a proved sign. Returns the crossings that this proves.
    pub fn go_on_with_sign(&mut self, sign: Sign) -> Option<Crossing> {
        let before = self.sign.replace(sign);
        let window = self.window.take()?;
        let count = match (before, window.slope) {
            (Some(before), Some(_)) if before != sign => CrossingCount::One,
            (Some(before), None) if before != sign => CrossingCount::AtLeastOne,
            // A function with a slope of one sign that has equal signs at both ends is not 0 between them.
            (Some(_), Some(_)) => return None,
            // A motion that begins exactly where the function is 0 has not crossed it.
            (None, Some(slope)) if slope == sign && self.starts_at_zero => return None,
            _ => CrossingCount::Open,
        };
        let counts = match self.direction {
            Direction::Either => true,
            Direction::Rising => sign == Sign::Positive || count == CrossingCount::Open,
            Direction::Falling => sign == Sign::Negative || count == CrossingCount::Open,
        };
        // Several crossings, of which the first is in the other direction, end in the sign of the last.
        let several = count == CrossingCount::AtLeastOne;
        let count = if counts {
            count
        } else if several {
            CrossingCount::Open
        } else {
            return None;
        };
        Some(Crossing { event: self.event, from: window.from, to: window.to, count, shown: window.shown })
    }

    /// Goes on over the instants from `from` to `to`, s, at which the event function may be 0 and has a slope of the
    /// sign `slope`, if one is proved. No crossing is proved before the next sign.
    pub fn go_on_without_sign(&mut self, (from, to): (f64, f64), slope: Option<Sign>, shown: &[Ball<f64>]) {
        self.window = Some(match self.window.take() {
            None => Window { from, to, slope, shown: shown.to_vec() },
            Some(window) => Window {
                from: window.from,
                to,
                slope: window.slope.filter(|before| Some(*before) == slope),
                shown: window.shown.iter().zip(shown).map(|(a, b)| a.hull(*b)).collect(),
            },
        });
    }

    /// Ends the search: the crossing that is open at the end of the run, if there is one.
    pub fn finish(&mut self) -> Option<Crossing> {
        let window = self.window.take()?;
        let count = CrossingCount::Open;
        Some(Crossing { event: self.event, from: window.from, to: window.to, count, shown: window.shown })
    }
}

/// Contracts an interval of instants to those at which a function can be 0, given bounds of its slope over the whole
/// interval that do not contain 0. `value` bounds the function at an instant. The result is `None` if the function is
/// nowhere 0.
pub fn contracted_zero(
    (mut low, mut high): (f64, f64),
    slope: Ball<f64>,
    value: impl Fn(f64) -> Ball<f64>,
) -> Option<(f64, f64)> {
    /// Largest number of contractions; each halves the interval at least.
    const CONTRACTIONS: u32 = 60;
    for _ in 0..CONTRACTIONS {
        let middle = 0.5 * low + 0.5 * high;
        let zero = Ball::point(middle) - value(middle) / slope;
        if !zero.is_defined() {
            break;
        }
        let (next_low, next_high) = (low.max(zero.low()), high.min(zero.high()));
        if next_low > next_high {
            return None;
        }
        let shrinks = next_high - next_low < 0.5 * (high - low);
        (low, high) = (next_low, next_high);
        if !shrinks {
            break;
        }
    }
    Some((low, high))
}
