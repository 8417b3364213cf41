//! Whole motion of one degree of freedom by quadrature, composed of stretches (integrated parts) that the motion passes
//! in both directions.

use super::energy::{Energy, LeastKineticEnergy};
use super::quadrature_error::{NoQuadrature, StretchObstacle};
use super::stretch::{Goal, PanelPlace, Scratch, Stretch};
use super::stretch_variable::StretchVariable;

/// Largest number of panels (subintervals) of a stretch between two turning points; rejected attempts count, too.
const PANELS_OF_SWING: u32 = 2000;
/// Largest number of panels (subintervals) of a stretch without a known second end.
const PANELS: u32 = 20_000;
/// Number of panels for which a motion without a known turning point is followed to find one.
const EXPLORED: usize = 100;
/// Largest number of turning points that the search may miss and the integration may then meet.
const MISSED_LIMIT: u32 = 16;

/// Kind of a motion of one degree of freedom, with its integrated stretches. Times τ, s, are counted
/// from a turning point if there is one.
#[derive(Clone, Debug)]
pub(super) enum MotionKind {
    /// The motion rests at its start for ever.
    Rest,
    /// The motion oscillates between two turning points. The first half starts from the lower turning point
    /// (τ = 0), the second from the upper.
    Swing { halves: Box<[Stretch; 2]> },
    /// The coordinate rotates in one direction, and the motion repeats after the signed period `length` of the
    /// coordinate.
    ///
    /// The first half goes from the coordinate of least kinetic energy (τ = 0) half a period forward. The second half
    /// goes from the next such coordinate half a period back.
    Rotation { halves: Box<[Stretch; 2]>, length: f64, rising: bool },
    /// The motion comes to a single turning point (τ = 0) and goes back.
    Return { track: Box<Stretch> },
    /// The motion passes its start (τ = 0) without a turning point. The stretches lead forward and backward
    /// in time.
    Pass { tracks: Box<[Stretch; 2]>, rising: bool },
}

/// Point of a motion by quadrature at an instant: the stretch and the point on it. Further data convert integrals along
/// the stretch to integrals along the motion.
pub(super) struct MotionPoint<'c> {
    /// Stretch (integrated part of the motion) on which the point lies.
    pub(super) track: &'c Stretch,
    /// Point on the stretch: its panel and its variable w.
    pub(super) found: PanelPlace,
    /// True if the coordinate q rises at this instant.
    pub(super) rising: bool,
    /// Number of whole periods from τ = 0 to this instant.
    turns: f64,
    /// Coordinate of the motion minus the coordinate of the point on the stretch.
    pub(super) shift: f64,
    /// True if the coordinate q both rises and falls within a period.
    returns: bool,
    /// Both stretches of a period; `None` for a motion without a period.
    halves: Option<&'c [Stretch; 2]>,
    /// True if the first half of the period is completely passed. The point is then counted back from the end of the
    /// second half.
    whole: bool,
    /// Sign of the integrals along the stretch in those along the motion, 1 or −1.
    sign: f64,
}

impl MotionKind {
    /// Determines the kind of the motion from the start of `energy`, with the coordinates `q` and the speed `v`.
    ///
    /// `turns` are the turning points below and above the start, if known. Turning points that the motion meets are
    /// added to it. Error if the integrals are not resolved.
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
                [Some(low), Some(high)] => match Self::oscillation(energy, n, [low, high], scratch) {
                    Ok(course) => return Ok(course),
                    Err(obstacle) => {
                        add_turning_point_of_motion(energy, turns, obstacle, PANELS_OF_SWING)?;
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
                                add_turning_point_of_motion(energy, turns, obstacle, PANELS_OF_SWING)?;
                                continue;
                            }
                        }
                    }
                    let track = |side: f64| {
                        let width = 0.1 * energy.start.abs().clamp(1e-6, 1.0);
                        Stretch::new(StretchVariable::Line { end: energy.start, side }, n, 0.0, width)
                    };
                    return Ok(Self::Pass { tracks: Box::new([track(forward), track(-forward)]), rising });
                }
            };
            let width = (2.0 * (energy.start - end).abs()).sqrt().max(1e-3 * end.abs().clamp(1e-6, 1.0));
            let track = Stretch::new(StretchVariable::Root { end, side }, n, 0.0, width);
            return Ok(Self::Return { track: Box::new(track) });
        }
        Err(NoQuadrature::Unresolved { at: energy.start, panels: PANELS_OF_SWING })
    }

    /// Creates the oscillation between the turning points `low` and `high`, with integrated stretches for `n`
    /// coordinates. Error if a stretch is not resolved or meets a barrier.
    fn oscillation(
        energy: &Energy<'_>,
        n: usize,
        [low, high]: [f64; 2],
        scratch: &mut Scratch<'_>,
    ) -> Result<Self, StretchObstacle> {
        let length = high - low;
        let blur = 16.0 * f64::EPSILON * low.abs().max(high.abs());
        if length <= 4.0 * blur {
            return Ok(Self::Rest);
        }
        let quarter = std::f64::consts::FRAC_PI_2;
        let half =
            |end: f64, side: f64| Stretch::new(StretchVariable::Arc { end, side, length }, n, blur / length, quarter);
        let mut halves = Box::new([half(low, 1.0), half(high, -1.0)]);
        for track in halves.iter_mut() {
            track.extend(energy, scratch, Goal::End(quarter), PANELS_OF_SWING)?;
        }
        Ok(Self::Swing { halves })
    }

    /// Creates the motion that rotates with the speed `v` at the start, and repeats after `length` of the coordinate.
    /// The inner error is a barrier, or a stretch that is not resolved.
    fn rotation(
        energy: &Energy<'_>,
        n: usize,
        length: f64,
        v: f64,
        scratch: &mut Scratch<'_>,
    ) -> Result<Result<Self, StretchObstacle>, NoQuadrature> {
        let rising = energy.rises(v);
        let side = if rising { 1.0 } else { -1.0 };
        let LeastKineticEnergy { at, kinetic, width } = match energy.least_kinetic_energy(length, side)? {
            Ok(crest) => crest,
            Err(barrier) => return Ok(Err(barrier)),
        };
        let end = (0.5 * length / width).asinh();
        let noise = 16.0 * f64::EPSILON * (at.abs() + length) / width;
        let half = |end: f64, side: f64, w: f64| {
            Stretch::new(StretchVariable::Crest { end, side, width, kinetic }, n, noise, w.min(1.0))
        };
        let mut halves = Box::new([half(at, side, end), half(at + side * length, -side, end)]);
        for track in halves.iter_mut() {
            if let Err(obstacle) = track.extend(energy, scratch, Goal::End(end), PANELS_OF_SWING) {
                return Ok(Err(obstacle));
            }
        }
        Ok(Ok(Self::Rotation { halves, length: side * length, rising }))
    }

    /// Time τ of the start of the motion, s. `v` is the speed at the start. Error if the stretch up to the start is not
    /// resolved.
    pub(super) fn time_of_start(
        &mut self,
        energy: &Energy<'_>,
        v: f64,
        scratch: &mut Scratch<'_>,
    ) -> Result<f64, StretchObstacle> {
        let rising = energy.rises(v);
        match self {
            Self::Rest | Self::Pass { .. } => Ok(0.0),
            Self::Swing { halves } => {
                let half_time = halves[0].duration() + halves[1].duration();
                let upper = halves.iter().position(|track| track.variable_of_start(energy).is_some()).unwrap_or(1);
                let time = halves[upper].variable_of_start(energy).map_or(0.0, |w| halves[upper].time_at(w));
                let size = if upper == 0 { time } else { half_time - time };
                Ok(if rising { size } else { -size })
            }
            Self::Rotation { halves, .. } => {
                let upper = halves.iter().position(|track| track.variable_of_start(energy).is_some()).unwrap_or(1);
                let time = halves[upper].variable_of_start(energy).map_or(0.0, |w| halves[upper].time_at(w));
                Ok(if upper == 0 { time } else { halves[0].duration() + halves[1].duration() - time })
            }
            Self::Return { track } => {
                let w = track.variable_of_start(energy).unwrap_or(0.0);
                track.extend(energy, scratch, Goal::Variable(w), PANELS)?;
                let time = track.time_at(w);
                Ok(if rising == track.coordinate_rises_along_stretch() { time } else { -time })
            }
        }
    }

    /// Follows a motion without a known turning point for a number of panels, to find a narrow barrier that the search
    /// missed. A found barrier is returned as the error.
    pub(super) fn search_missed_turning_point(
        &mut self,
        energy: &Energy<'_>,
        scratch: &mut Scratch<'_>,
    ) -> Result<(), StretchObstacle> {
        let track = match self {
            Self::Rest | Self::Swing { .. } | Self::Rotation { .. } => return Ok(()),
            Self::Return { track } => &mut **track,
            Self::Pass { tracks, .. } => &mut tracks[0],
        };
        match track.extend(energy, scratch, Goal::Panels(EXPLORED), PANELS) {
            // The motion is followed here farther than requested, so that unresolved panels are no error.
            Err(StretchObstacle::Unresolved(_)) | Ok(()) => Ok(()),
            barrier => barrier,
        }
    }

    /// Integrates the stretches as far as needed to know the motion at the time τ, s. Error if they are not resolved or
    /// meet a barrier.
    pub(super) fn integrate_to_time(
        &mut self,
        energy: &Energy<'_>,
        tau: f64,
        scratch: &mut Scratch<'_>,
    ) -> Result<(), StretchObstacle> {
        match self {
            Self::Rest | Self::Swing { .. } | Self::Rotation { .. } => Ok(()),
            Self::Return { track } => track.extend(energy, scratch, Goal::Time(tau.abs()), PANELS),
            Self::Pass { tracks, .. } => {
                let track = &mut tracks[usize::from(tau < 0.0)];
                track.extend(energy, scratch, Goal::Time(tau.abs()), PANELS)
            }
        }
    }

    /// Period of the motion, s; `None` if the motion does not repeat.
    pub(super) fn period(&self) -> Option<f64> {
        match self {
            Self::Swing { halves } => Some(2.0 * (halves[0].duration() + halves[1].duration())),
            Self::Rotation { halves, .. } => Some(halves[0].duration() + halves[1].duration()),
            _ => None,
        }
    }

    /// Point of the motion at the time τ, s; `None` at rest, and at times that are not covered yet.
    pub(super) fn point_of_motion(&self, tau: f64) -> Option<MotionPoint<'_>> {
        match self {
            Self::Rest => None,
            Self::Swing { halves } => {
                let half_time = halves[0].duration() + halves[1].duration();
                let turns = (tau / (2.0 * half_time)).round();
                let rest = tau - turns * (2.0 * half_time);
                let (rising, size) = (rest >= 0.0, rest.abs().min(half_time));
                let whole = size > halves[0].duration();
                let track = &halves[usize::from(whole)];
                let found = track.stretch_point_at_time(if whole { half_time - size } else { size });
                let sign = if rising { 1.0 } else { -1.0 };
                Some(MotionPoint {
                    track,
                    found,
                    rising,
                    turns,
                    shift: 0.0,
                    returns: true,
                    halves: Some(halves),
                    whole,
                    sign,
                })
            }
            Self::Rotation { halves, length, rising } => {
                let period = halves[0].duration() + halves[1].duration();
                let turns = (tau / period).floor();
                let rest = (tau - turns * period).clamp(0.0, period);
                let whole = rest > halves[0].duration();
                let track = &halves[usize::from(whole)];
                let found = track.stretch_point_at_time(if whole { period - rest } else { rest });
                let (shift, halves) = (turns * length, Some(&**halves));
                Some(MotionPoint {
                    track,
                    found,
                    rising: *rising,
                    turns,
                    shift,
                    returns: false,
                    halves,
                    whole,
                    sign: 1.0,
                })
            }
            Self::Return { track } => {
                let rising = (tau >= 0.0) == track.coordinate_rises_along_stretch();
                Self::point_without_period(track, tau, rising)
            }
            Self::Pass { tracks, rising } => Self::point_without_period(&tracks[usize::from(tau < 0.0)], tau, *rising),
        }
    }

    /// Point of a motion without a period at the time τ, s, on this stretch. `None` if the stretch is not integrated up
    /// to there.
    fn point_without_period(track: &Stretch, tau: f64, rising: bool) -> Option<MotionPoint<'_>> {
        if track.times.len() < 2 || tau.abs() > track.duration() {
            // A stretch without panels is used only at τ = 0.
            return None;
        }
        let sign = if tau >= 0.0 { 1.0 } else { -1.0 };
        Some(MotionPoint {
            track,
            found: track.stretch_point_at_time(tau.abs()),
            rising,
            turns: 0.0,
            shift: 0.0,
            returns: false,
            halves: None,
            whole: false,
            sign,
        })
    }

    /// Times τ at which panels (subintervals) meet, s, in ascending order. If the motion has a period, only the times
    /// of one period.
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

    /// Stretches (integrated parts) of the motion; none for a motion at rest.
    pub(super) fn stretches_of_motion(&self) -> &[Stretch] {
        match self {
            Self::Rest => &[],
            Self::Swing { halves } | Self::Rotation { halves, .. } => &**halves,
            Self::Return { track } => std::slice::from_ref(track),
            Self::Pass { tracks, .. } => &**tracks,
        }
    }
}

/// Adds to `turns` the turning point between the start and a barrier that the motion met. Error if the obstacle is a
/// stretch that `panels` panels do not resolve.
pub(super) fn add_turning_point_of_motion(
    energy: &Energy<'_>,
    turns: &mut [Option<f64>; 2],
    obstacle: StretchObstacle,
    panels: u32,
) -> Result<(), NoQuadrature> {
    match obstacle {
        StretchObstacle::Unresolved(at) => Err(NoQuadrature::Unresolved { at, panels }),
        StretchObstacle::Barrier(at) => {
            turns[usize::from(at > energy.start)] = Some(energy.turning_point_before(at)?);
            Ok(())
        }
    }
}

/// Adds to `turns` the turning point before a barrier that a motion without a known end met. Error if the obstacle is a
/// stretch that is not resolved.
pub(super) fn add_far_turning_point_of_motion(
    energy: &Energy<'_>,
    turns: &mut [Option<f64>; 2],
    obstacle: StretchObstacle,
) -> Result<(), NoQuadrature> {
    add_turning_point_of_motion(energy, turns, obstacle, PANELS)
}

impl MotionPoint<'_> {
    /// Integral of the rate of coordinate `i` ≥ 1 along the motion, from τ = 0 to this instant. `count` is the number
    /// of coordinates other than coordinate 0.
    pub(super) fn integral_along_motion(&self, i: usize, count: usize) -> f64 {
        let along = |rising: bool| if rising { i } else { i + count };
        let own = self.track.value(&self.found, along(self.rising));
        let Some(halves) = self.halves else { return self.sign * own };
        let half = |rising: bool| halves[0].totals()[along(rising)] + halves[1].totals()[along(rising)];
        let rest = if self.whole { self.sign * (half(self.rising) - own) } else { self.sign * own };
        let period = if self.returns { half(true) + half(false) } else { half(self.rising) };
        self.turns * period + rest
    }
}
