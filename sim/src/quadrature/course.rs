//! Whole motion of one degree of freedom as stretches, gone through to and fro.

use super::chart::{Chart, Place};
use super::energy::{Crest, Energy};
use super::error::{NoQuadrature, Obstacle};
use super::track::{Goal, PanelPlace, Scratch, Track};

/// Largest number of panels of a stretch between turning points, rejected attempts included.
const PANELS_OF_SWING: u32 = 2000;
/// Largest number of panels of a stretch without an end.
const PANELS: u32 = 20_000;
/// Number of panels in which a motion without a known turning point is examined for one.
const EXPLORED: usize = 100;
/// Largest number of times that the motion may meet a turning point that the search missed.
const MISSED_LIMIT: u32 = 16;

/// Shape of a motion of one degree of freedom. Times τ, s, are counted from a turning point, if there is one, or else
/// from the start.
#[derive(Clone, Debug)]
pub(super) enum Course {
    /// The motion rests for ever.
    Rest,
    /// The motion goes to and fro between two turning points. One half of it starts from the lower (τ = 0), the other
    /// from the upper turning point.
    Swing { halves: Box<[Track; 2]> },
    /// The coordinate goes round; everything repeats after `length` of it. One half goes from the place of least
    /// kinetic energy (τ = 0) half way on, the other from the next such place half way back.
    Rotation { halves: Box<[Track; 2]>, length: f64, rising: bool },
    /// The motion goes to a turning point (τ = 0) and back.
    Return { track: Box<Track> },
    /// The motion goes past the start (τ = 0), forward and backward, without a turn.
    Pass { tracks: Box<[Track; 2]>, rising: bool },
}

/// Place of the motion at an instant: a stretch, a place on it, and the data that turn the stretch's quadratures into
/// those of the motion.
pub(super) struct Spot<'c> {
    pub(super) track: &'c Track,
    pub(super) found: PanelPlace,
    /// True if the coordinate q rises at this instant.
    pub(super) rising: bool,
    /// Number of whole periods before this instant.
    turns: f64,
    /// Coordinate of the motion minus the coordinate of the place on the stretch.
    pub(super) shift: f64,
    /// True if a period goes both ways.
    returns: bool,
    /// Both stretches of a period. If `whole` is true, the place is counted back from the end of the second; sums of
    /// quadratures count with `sign`.
    halves: Option<&'c [Track; 2]>,
    whole: bool,
    sign: f64,
}

impl Course {
    /// Finds the course from the start of `energy`. `turns` are the turning points below and above, if they are known;
    /// turning points that the motion meets are added. `q` holds the coordinates of the start.
    pub(super) fn new(
        energy: &Energy<'_>,
        q: &[f64],
        v: f64,
        turns: &mut [Option<f64>; 2],
        scratch: &mut Scratch<'_>,
    ) -> Result<Self, NoQuadrature> {
        let n = q.len();
        for _ in 0..MISSED_LIMIT {
            let (end, side) = match *turns {
                [Some(low), Some(high)] => match Self::swing(energy, n, [low, high], scratch) {
                    Ok(course) => return Ok(course),
                    Err(obstacle) => {
                        note(energy, turns, obstacle, PANELS_OF_SWING)?;
                        continue;
                    }
                },
                [Some(low), None] => (low, 1.0),
                [None, Some(high)] => (high, -1.0),
                [None, None] => {
                    let rising = energy.rises(v);
                    let forward = if rising { 1.0 } else { -1.0 };
                    if let Some(length) = energy.repeats {
                        match Self::rotation(energy, n, length, v, scratch)? {
                            Ok(course) => return Ok(course),
                            Err(obstacle) => {
                                note(energy, turns, obstacle, PANELS_OF_SWING)?;
                                continue;
                            }
                        }
                    }
                    let track = |side: f64| {
                        let width = 0.1 * energy.start.abs().clamp(1e-6, 1.0);
                        Track::new(Chart::Line { end: energy.start, side }, n, 0.0, width)
                    };
                    return Ok(Self::Pass { tracks: Box::new([track(forward), track(-forward)]), rising });
                }
            };
            let width = (2.0 * (energy.start - end).abs()).sqrt().max(1e-3 * end.abs().clamp(1e-6, 1.0));
            let track = Track::new(Chart::Root { end, side }, n, 0.0, width);
            return Ok(Self::Return { track: Box::new(track) });
        }
        Err(NoQuadrature::Unresolved { at: energy.start, panels: PANELS_OF_SWING })
    }

    fn swing(
        energy: &Energy<'_>,
        n: usize,
        [low, high]: [f64; 2],
        scratch: &mut Scratch<'_>,
    ) -> Result<Self, Obstacle> {
        let length = high - low;
        let blur = 16.0 * f64::EPSILON * low.abs().max(high.abs());
        if length <= 4.0 * blur {
            return Ok(Self::Rest);
        }
        let quarter = std::f64::consts::FRAC_PI_2;
        let half = |end: f64, side: f64| Track::new(Chart::Arc { end, side, length }, n, blur / length, quarter);
        let mut halves = Box::new([half(low, 1.0), half(high, -1.0)]);
        for track in halves.iter_mut() {
            track.extend(energy, scratch, Goal::End(quarter), PANELS_OF_SWING)?;
        }
        Ok(Self::Swing { halves })
    }

    /// Course of a motion that goes round with the motion variable `v` at the start: everything repeats after `length`
    /// of the coordinate. An inner error is a barrier that stops it.
    fn rotation(
        energy: &Energy<'_>,
        n: usize,
        length: f64,
        v: f64,
        scratch: &mut Scratch<'_>,
    ) -> Result<Result<Self, Obstacle>, NoQuadrature> {
        let rising = energy.rises(v);
        let side = if rising { 1.0 } else { -1.0 };
        let Crest { at, kinetic, width } = match energy.crest(length, side)? {
            Ok(crest) => crest,
            Err(barrier) => return Ok(Err(barrier)),
        };
        let end = (0.5 * length / width).asinh();
        let noise = 16.0 * f64::EPSILON * (at.abs() + length) / width;
        let half =
            |end: f64, side: f64, w: f64| Track::new(Chart::Crest { end, side, width, kinetic }, n, noise, w.min(1.0));
        let mut halves = Box::new([half(at, side, end), half(at + side * length, -side, end)]);
        for track in halves.iter_mut() {
            if let Err(obstacle) = track.extend(energy, scratch, Goal::End(end), PANELS_OF_SWING) {
                return Ok(Err(obstacle));
            }
        }
        Ok(Ok(Self::Rotation { halves, length: side * length, rising }))
    }

    /// Time τ of the start of the motion, s.
    pub(super) fn lead(&mut self, energy: &Energy<'_>, v: f64, scratch: &mut Scratch<'_>) -> Result<f64, Obstacle> {
        let rising = energy.rises(v);
        match self {
            Self::Rest | Self::Pass { .. } => Ok(0.0),
            Self::Swing { halves } => {
                let half_time = halves[0].duration() + halves[1].duration();
                let upper = halves.iter().position(|track| track.phase(energy).is_some()).unwrap_or(1);
                let time = halves[upper].phase(energy).map_or(0.0, |w| halves[upper].time_at(w));
                let size = if upper == 0 { time } else { half_time - time };
                Ok(if rising { size } else { -size })
            }
            Self::Rotation { halves, .. } => {
                let upper = halves.iter().position(|track| track.phase(energy).is_some()).unwrap_or(1);
                let time = halves[upper].phase(energy).map_or(0.0, |w| halves[upper].time_at(w));
                Ok(if upper == 0 { time } else { halves[0].duration() + halves[1].duration() - time })
            }
            Self::Return { track } => {
                let w = track.phase(energy).unwrap_or(0.0);
                track.extend(energy, scratch, Goal::Variable(w), PANELS)?;
                let time = track.time_at(w);
                Ok(if rising == track.opens_upwards() { time } else { -time })
            }
        }
    }

    /// Follows a motion that seems not to turn for some panels: a narrow barrier that the search missed may show there.
    pub(super) fn explore(&mut self, energy: &Energy<'_>, scratch: &mut Scratch<'_>) -> Result<(), Obstacle> {
        let track = match self {
            Self::Rest | Self::Swing { .. } | Self::Rotation { .. } => return Ok(()),
            Self::Return { track } => &mut **track,
            Self::Pass { tracks, .. } => &mut tracks[0],
        };
        match track.extend(energy, scratch, Goal::Panels(EXPLORED), PANELS) {
            // Panels that were not needed for an answer may stay unresolved.
            Err(Obstacle::Unresolved(_)) | Ok(()) => Ok(()),
            barrier => barrier,
        }
    }

    /// Integrates the stretches as far as the time τ, s, needs.
    pub(super) fn cover(&mut self, energy: &Energy<'_>, tau: f64, scratch: &mut Scratch<'_>) -> Result<(), Obstacle> {
        match self {
            Self::Rest | Self::Swing { .. } | Self::Rotation { .. } => Ok(()),
            Self::Return { track } => track.extend(energy, scratch, Goal::Time(tau.abs()), PANELS),
            Self::Pass { tracks, .. } => {
                let track = &mut tracks[usize::from(tau < 0.0)];
                track.extend(energy, scratch, Goal::Time(tau.abs()), PANELS)
            }
        }
    }

    /// Period of the motion, s; `None` if it does not repeat.
    pub(super) fn period(&self) -> Option<f64> {
        match self {
            Self::Swing { halves } => Some(2.0 * (halves[0].duration() + halves[1].duration())),
            Self::Rotation { halves, .. } => Some(halves[0].duration() + halves[1].duration()),
            _ => None,
        }
    }

    /// Place of the motion at the time τ, s; `None` at rest, and at times that were not covered yet.
    pub(super) fn spot(&self, tau: f64) -> Option<Spot<'_>> {
        match self {
            Self::Rest => None,
            Self::Swing { halves } => {
                let half_time = halves[0].duration() + halves[1].duration();
                let turns = (tau / (2.0 * half_time)).round();
                let rest = tau - turns * (2.0 * half_time);
                let (rising, size) = (rest >= 0.0, rest.abs().min(half_time));
                let whole = size > halves[0].duration();
                let track = &halves[usize::from(whole)];
                let found = track.find(if whole { half_time - size } else { size });
                let sign = if rising { 1.0 } else { -1.0 };
                Some(Spot { track, found, rising, turns, shift: 0.0, returns: true, halves: Some(halves), whole, sign })
            }
            Self::Rotation { halves, length, rising } => {
                let period = halves[0].duration() + halves[1].duration();
                let turns = (tau / period).floor();
                let rest = (tau - turns * period).clamp(0.0, period);
                let whole = rest > halves[0].duration();
                let track = &halves[usize::from(whole)];
                let found = track.find(if whole { period - rest } else { rest });
                let (shift, halves) = (turns * length, Some(&**halves));
                Some(Spot { track, found, rising: *rising, turns, shift, returns: false, halves, whole, sign: 1.0 })
            }
            Self::Return { track } => {
                let rising = (tau >= 0.0) == track.opens_upwards();
                Self::alone(track, tau, rising)
            }
            Self::Pass { tracks, rising } => Self::alone(&tracks[usize::from(tau < 0.0)], tau, *rising),
        }
    }

    fn alone(track: &Track, tau: f64, rising: bool) -> Option<Spot<'_>> {
        if track.times.len() < 2 || tau.abs() > track.duration() {
            // A stretch without panels is used only at τ = 0.
            return None;
        }
        let sign = if tau >= 0.0 { 1.0 } else { -1.0 };
        Some(Spot {
            track,
            found: track.find(tau.abs()),
            rising,
            turns: 0.0,
            shift: 0.0,
            returns: false,
            halves: None,
            whole: false,
            sign,
        })
    }

    /// Times τ at which panels meet, s, in order; those of one period if the motion has a period.
    pub(super) fn nodes(&self) -> Vec<f64> {
        let mut nodes: Vec<f64> = match self {
            Self::Rest => Vec::new(),
            Self::Swing { halves } => {
                let half_time = halves[0].duration() + halves[1].duration();
                let lower = halves[0].times.iter().copied();
                lower.chain(halves[1].times.iter().map(|t| half_time - t)).flat_map(|t| [t, -t]).collect()
            }
            Self::Rotation { halves, .. } => {
                let period = halves[0].duration() + halves[1].duration();
                halves[0].times.iter().copied().chain(halves[1].times.iter().map(|t| period - t)).collect()
            }
            Self::Return { track } => track.times.iter().flat_map(|t| [*t, -*t]).collect(),
            Self::Pass { tracks, .. } => {
                tracks[0].times.iter().copied().chain(tracks[1].times.iter().map(|t| -t)).collect()
            }
        };
        nodes.sort_by(f64::total_cmp);
        nodes
    }

    pub(super) fn tracks(&self) -> &[Track] {
        match self {
            Self::Rest => &[],
            Self::Swing { halves } | Self::Rotation { halves, .. } => &**halves,
            Self::Return { track } => std::slice::from_ref(track),
            Self::Pass { tracks, .. } => &**tracks,
        }
    }
}

/// Adds the turning point between the start and a barrier that the motion met. An unresolved stretch is an error.
pub(super) fn note(
    energy: &Energy<'_>,
    turns: &mut [Option<f64>; 2],
    obstacle: Obstacle,
    panels: u32,
) -> Result<(), NoQuadrature> {
    match obstacle {
        Obstacle::Unresolved(at) => Err(NoQuadrature::Unresolved { at, panels }),
        Obstacle::Barrier(at) => {
            turns[usize::from(at > energy.start)] = Some(energy.turning_before(at)?);
            Ok(())
        }
    }
}

/// Adds a turning point like [`note`], for a motion that was followed without an end.
pub(super) fn note_far(
    energy: &Energy<'_>,
    turns: &mut [Option<f64>; 2],
    obstacle: Obstacle,
) -> Result<(), NoQuadrature> {
    note(energy, turns, obstacle, PANELS)
}

impl Spot<'_> {
    /// Quadrature of coordinate i = 1, 2 … from τ = 0 to this instant.
    pub(super) fn quadrature(&self, i: usize, count: usize) -> f64 {
        let along = |rising: bool| if rising { i } else { i + count };
        let own = self.track.value(&self.found, along(self.rising));
        let Some(halves) = self.halves else { return self.sign * own };
        let half = |rising: bool| halves[0].totals()[along(rising)] + halves[1].totals()[along(rising)];
        let rest = if self.whole { self.sign * (half(self.rising) - own) } else { self.sign * own };
        let period = if self.returns { half(true) + half(false) } else { half(self.rising) };
        self.turns * period + rest
    }
}

impl Track {
    /// Time at the variable w, s, from the start of the stretch.
    fn time_at(&self, w: f64) -> f64 {
        self.value(&self.at_variable(w), 0)
    }

    /// True if q rises along the stretch.
    fn opens_upwards(&self) -> bool {
        self.chart.start().1 > 0.0
    }

    /// Variable w of the motion's start; `None` if the start lies in the other half of a swing or a turn.
    ///
    /// Next to the turning point w follows from T₀ = (reach)² G: the difference of coordinates would keep only half of
    /// its digits.
    fn phase(&self, energy: &Energy<'_>) -> Option<f64> {
        let (end, side) = self.chart.start();
        let offset = (side * (energy.start - end)).max(0.0);
        let close = offset < 0.125 * energy.start.abs().max(end.abs());
        let here = Place { q: energy.start, offset, reach: 1.0 };
        let level = || self.chart.level(energy, |a, b| energy.slope(a, b), &here);
        let reach = close.then(|| (energy.kinetic / level()).sqrt());
        let reach = reach.filter(|reach| reach.is_finite());
        match self.chart {
            Chart::Arc { length, .. } => {
                let cos = 1.0 - 2.0 * (offset / length);
                if cos < 0.0 {
                    return None;
                }
                let sin = 2.0 * reach.unwrap_or_else(|| (offset * (length - offset)).sqrt()) / length;
                Some(sin.atan2(cos).min(std::f64::consts::FRAC_PI_2))
            }
            Chart::Root { .. } => Some(reach.unwrap_or_else(|| (2.0 * offset).sqrt())),
            Chart::Line { .. } => Some(0.0),
            Chart::Crest { width, .. } => {
                // The middle of a turn lies in at least one half, however it is rounded.
                let half = self.chart.at(self.end()).offset;
                (offset <= half * (1.0 + 1e-9)).then(|| (offset / width).asinh().min(self.end()))
            }
        }
    }
}
