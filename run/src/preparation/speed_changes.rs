//! Runs of constrained mechanisms that switch between chosen generalized speeds and the rates of all
//! coordinates.
//!
//! Chosen speeds u fail in poses where they do not distinguish the motions that the constraints
//! allow. The speed of a rocker, for example, fails in the dead points of its linkage. Near such a
//! pose, the run continues in the rates of all coordinates ("all rates"). It then uses Lagrange's
//! equations with multipliers. These are solved for constraints of any rank
//! ([`tripos_sim::Multipliers`]). The run returns to the chosen speeds where they determine the motion
//! again.
//!
//! The standing of a state has two measures: how well the chosen speeds determine the motion, and how
//! independent the constraints are. Each change of variables is a restart at the end of a step. If
//! the standing is poor at the end of a step in chosen speeds, this step is repeated in all rates.
//! The whole solution is given in (q, q̇). The shown quantities, such as the speeds u, are computed
//! from it.

mod part_options;
mod rates_intervals;

pub use part_options::{join_part_solutions, options_for_next_part};
pub use rates_intervals::{RatesInterval, notes_on_rates_intervals};

use super::initial_state::InitialState;
use crate::code::Code;
use part_options::{part_options_in_rates, part_projection_in_rates, wider_part_options};
use std::cell::{Cell, RefCell};
use std::sync::Mutex;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::plain_text::with_significant_digits;
use tripos_derive::scene::AccelerationSolution;
use tripos_sim::{
    AccompaniedRightHandSide, DistancesFromSingularity, Event, Failure, LentRightHandSide, Multipliers, Options,
    PowerAt, RightHandSide, SimError, Solution, Stop, integrate,
};
use tripos_traits::System;

/// Two sets of equations of motion of one mechanism: in the rates of all coordinates, and in the
/// chosen speeds.
#[derive(Clone, Copy)]
pub struct SpeedAndRateEquations<'a> {
    /// Equations of motion in the rates of all coordinates.
    pub rates: &'a dyn System<f64>,
    /// Equations of motion in the chosen speeds.
    pub speeds: &'a dyn System<f64>,
    /// Values of the parameters of both sets of equations, in the order of the model file.
    pub parameters: &'a [f64],
}

/// Function that computes the power of the loads, W, at an instant, s, in a state (q, q̇).
type Power<'a> = Box<dyn FnMut(f64, &[f64]) -> f64 + 'a>;

/// Power of the loads in a run, and a flag that tells if the run checks the energy balance.
pub struct EnergyBalance<'a> {
    /// Power of the loads, W, whose integral over the run is the work; `None` if no work is integrated.
    pub power: Option<Power<'a>>,
    /// True if T + V minus the work of the power is constant in every motion. A run then checks this
    /// near singular poses.
    pub is_kept: bool,
}

/// Fraction of the best standing so far below which a run leaves the chosen speeds. The standing,
/// from 0 to 1, measures how well these speeds determine the motion.
const LEAVES: f64 = 0.3;
/// Fraction of the best standing so far above which a run returns to the chosen speeds. The
/// standing, from 0 to 1, measures how well these speeds determine the motion.
const RETURNS: f64 = 0.5;
/// Standing (measure from 0 to 1 of how well the chosen speeds determine the motion) that a start
/// in these speeds needs.
const BEGINS: f64 = 0.05;
/// Relative difference of two states up to which they count as equal. A correction onto the
/// constraints changes a state by less.
const SAME: f64 = 1e-9;
/// Independence of the constraints below which they count as nearly dependent, as a fraction of the
/// best independence so far.
const SINGULAR: f64 = 0.1;
/// Factors by which the tolerances are multiplied where the constraints are nearly dependent, in the
/// order in which they are tried.
const COARSER: [f64; 4] = [1.0, 10.0, 100.0, 1000.0];
/// Number of steps after which a run that makes no progress tries the next factor in `COARSER` for its
/// tolerances.
const FEW: u64 = 2000;
/// Fraction of the energy that a run may lose or gain where the constraints are nearly dependent.
const LOST: f64 = 1e-3;

/// Equations in chosen speeds that supplement a problem whose own equations are in the rates of all
/// coordinates. They are used wherever the chosen speeds determine the motion.
#[derive(Clone, Copy)]
pub struct ChosenSpeedEquations<'a> {
    /// Origin of the equations in the chosen speeds, such as Kane's method.
    pub by: &'a EquationsOrigin,
    /// Runnable equations in the chosen speeds, compiled or interpreted.
    pub code: &'a Code,
    /// Method that finds the accelerations of the equations in chosen speeds: eliminated beforehand or
    /// solved numerically.
    pub solve: AccelerationSolution,
    /// Output: the parts of the last run that were computed in the rates of all coordinates.
    pub changes: &'a Mutex<Vec<RatesInterval>>,
}

/// State of a run that may switch between chosen speeds and the rates of all coordinates.
struct SpeedChangingRun<'r> {
    /// Equations of motion in the rates of all coordinates.
    rates: &'r dyn System<f64>,
    /// Equations of motion in the chosen speeds.
    speeds: &'r dyn System<f64>,
    /// Values of the parameters, in the order of the model file.
    parameters: &'r [f64],
    /// Right-hand side in the rates of all coordinates, with multipliers. It also computes how well the
    /// chosen speeds determine the motion.
    multipliers: RefCell<Multipliers<'r>>,
    /// Best values so far of two measures: how well the chosen speeds determine the motion, and how
    /// independent the constraints are.
    best: RefCell<DistancesFromSingularity>,
    /// True if the best standing is known from a good pose. False while a run that began near a singular
    /// pose only moves away from it.
    is_best_known: Cell<bool>,
    /// Last state (q, q̇) whose standing was computed, and this standing. The standing measures how well
    /// the chosen speeds determine the motion and how independent the constraints are. `None` if the
    /// equations have no value at this state.
    last_standing: RefCell<(Vec<f64>, Option<DistancesFromSingularity>)>,
    /// Buffer for a state that is converted to (q, q̇).
    in_rates: RefCell<Vec<f64>>,
    /// Least duration, s, of the next part of the run in all rates before it may return to chosen
    /// speeds.
    dwell: f64,
    /// Duration of the last part of the run in the rates of all coordinates, s.
    lasted: f64,
    /// Parts of the run so far that were computed in the rates of all coordinates, in the order of
    /// time.
    changes: Vec<RatesInterval>,
    /// True if the run checks the energy: T + V minus the work of the loads is constant in every motion.
    keeps_energy: bool,
}

/// Integrates from a start (q, q̇) over its span. The equations in chosen speeds, with the right-hand
/// side `rhs`, are used wherever these speeds determine the motion. Elsewhere the equations in the
/// rates of all coordinates are used. Returns the solution in (q, q̇), and the parts of the run in
/// all rates.
///
/// # Errors
/// [`SimError`] if the options or the start do not fit the equations, or if the equations in all rates
/// have no multipliers.
pub fn run_with_speed_changes(
    systems: SpeedAndRateEquations<'_>,
    rhs: &mut dyn RightHandSide<f64>,
    start: InitialState<'_>,
    options: &Options,
    events: &mut [Event<'_>],
    energy: EnergyBalance<'_>,
) -> Result<(Solution, Vec<RatesInterval>), SimError> {
    let InitialState { span, y: y0 } = start;
    let EnergyBalance { mut power, is_kept: keeps_energy } = energy;
    let mut passage = SpeedChangingRun { keeps_energy, ..SpeedChangingRun::new(systems, options)? };
    let mut in_speeds = passage.begins_in_speeds(y0);
    let mut whole = if in_speeds {
        passage.run_part_in_speeds_as_rates(rhs, start, options, events, power.as_mut())?
    } else {
        passage.run_part_in_rates(start, options, events, power.as_mut())?
    };
    while match &whole.stop {
        Stop::HandedOver => true,
        Stop::StepLimit { .. } | Stop::Interrupted => false,
        stop => in_speeds && stop.is_failure(),
    } {
        in_speeds = !in_speeds;
        let (rest, y) = (options_for_next_part(options, &whole, span), whole.y_end.clone());
        let start = InitialState { span: (whole.t_end, span.1), y: &y };
        let leg = if in_speeds {
            passage.run_part_in_speeds_as_rates(rhs, start, &rest, events, power.as_mut())?
        } else {
            passage.run_part_in_rates(start, &rest, events, power.as_mut())?
        };
        whole = join_part_solutions(whole, leg, options);
    }
    Ok((whole, passage.changes))
}

/// Integrates from a start (q, v) by the equations in chosen speeds alone. Returns the solution in
/// (q, v). `None` if these speeds fail on the way, or hardly determine the motion somewhere. Such a run
/// needs [`run_with_speed_changes`].
///
/// # Errors
/// `SimError` if the options or the start do not fit the equations, or if the equations in all rates
/// have no multipliers.
pub fn run_in_speeds_alone(
    systems: SpeedAndRateEquations<'_>,
    rhs: &mut dyn RightHandSide<f64>,
    start: InitialState<'_>,
    options: &Options,
    events: &mut [Event<'_>],
    mut power: Option<Power<'_>>,
) -> Result<Option<Solution>, SimError> {
    let passage = SpeedChangingRun::new(systems, options)?;
    if !passage.begins_in_speeds(&state_in_rates(passage.speeds, passage.parameters, start.y)) {
        return Ok(None);
    }
    let power = power.as_mut().map(|power| power.as_mut() as &mut dyn FnMut(f64, &[f64]) -> f64);
    let (run, _) = passage.run_part_in_speeds(rhs, start, options, events, power)?;
    let is_whole = match &run.stop {
        Stop::StepLimit { .. } | Stop::Interrupted => true,
        stop => !stop.is_failure() && *stop != Stop::HandedOver,
    };
    Ok(is_whole.then_some(run))
}

impl<'r> SpeedChangingRun<'r> {
    /// Prepares a run that has computed no part yet.
    ///
    /// # Errors
    /// `SimError` if the equations in all rates have no multipliers.
    fn new(systems: SpeedAndRateEquations<'r>, options: &Options) -> Result<Self, SimError> {
        let SpeedAndRateEquations { rates, speeds, parameters } = systems;
        let none = || SimError::Option { name: "equations in all rates", must: "equations with multipliers" };
        Ok(Self {
            rates,
            speeds,
            parameters,
            multipliers: RefCell::new(Multipliers::new(rates, parameters, options.clock).ok_or_else(none)?),
            best: RefCell::new(DistancesFromSingularity { speeds: 0.0, constraints: 0.0 }),
            is_best_known: Cell::new(true),
            last_standing: RefCell::default(),
            in_rates: RefCell::default(),
            dwell: 0.0,
            lasted: 0.0,
            changes: Vec::new(),
            keeps_energy: false,
        })
    }

    /// True if the chosen speeds determine the motion at the state (q, q̇) well enough to begin a run in
    /// these speeds.
    fn begins_in_speeds(&self, y: &[f64]) -> bool {
        let stands = self.determines_motion_well(y, LEAVES) == Some(true) && self.best.borrow().speeds > BEGINS;
        self.is_best_known.set(stands);
        stands
    }

    /// True if both measures of the standing at (q, q̇) exceed the fraction `part` of their best values so
    /// far. The measures are how well the chosen speeds determine the motion, and how independent the
    /// constraints are. Updates the best values. `None` if the equations have no value at this state.
    fn determines_motion_well(&self, y: &[f64], part: f64) -> Option<bool> {
        let now = self.speed_conditioning(y)?;
        let mut best = self.best.borrow_mut();
        if now.speeds < best.speeds {
            self.is_best_known.set(true);
        }
        *best = DistancesFromSingularity {
            speeds: best.speeds.max(now.speeds),
            constraints: best.constraints.max(now.constraints),
        };
        Some(now.speeds > part * best.speeds && now.constraints > part * best.constraints)
    }

    /// Computes how well the chosen speeds determine the motion at (q, q̇), and how independent the
    /// constraints are. `None` if the equations have no value at this state. A state that equals the
    /// last one up to a small correction gets the last result.
    fn speed_conditioning(&self, y: &[f64]) -> Option<DistancesFromSingularity> {
        let mut last = self.last_standing.borrow_mut();
        let (before, stood) = &mut *last;
        let size = y.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let is_same = before.len() == y.len() && before.iter().zip(y).all(|(a, b)| (a - b).abs() <= SAME * size);
        if !is_same {
            before.clear();
            before.extend_from_slice(y);
            *stood = self.multipliers.borrow_mut().distances_from_singularity(y);
        }
        *stood
    }

    /// Compares the standing at a state (q, v) in chosen speeds with the best standing so far. Returns
    /// the result of [`Self::determines_motion_well`] at this state.
    fn has_standing_in_speeds(&self, y: &[f64], part: f64) -> Option<bool> {
        let mut in_rates = self.in_rates.borrow_mut();
        write_state_in_rates(self.speeds, self.parameters, y, &mut in_rates);
        self.determines_motion_well(&in_rates, part)
    }

    /// Runs a part in the chosen speeds from a start (q, v), up to a pose where these speeds hardly
    /// determine the motion. Returns the solution in (q, v), and the instant, s, at which the last
    /// attempted step would have ended.
    fn run_part_in_speeds(
        &self,
        rhs: &mut dyn RightHandSide<f64>,
        start: InitialState<'_>,
        options: &Options,
        events: &mut [Event<'_>],
        power: Option<PowerAt<'_>>,
    ) -> Result<(Solution, f64), SimError> {
        let beyond = Cell::new(start.span.0);
        let mut over = |t: f64, y: Option<&[f64]>| {
            beyond.set(t);
            y.is_none()
        };
        let mut yields = |t: f64, y: &[f64]| {
            beyond.set(t);
            self.has_standing_in_speeds(y, LEAVES) != Some(true)
        };
        let power = power.map(|power| power as &mut dyn FnMut(f64, &[f64]) -> f64);
        let with = AccompaniedRightHandSide { rhs, power, over: Some(&mut over), yields: Some(&mut yields) };
        let leg = integrate_watched(with, start, options, events)?;
        Ok((leg, beyond.get()))
    }

    /// Runs a part in the chosen speeds from a start (q, q̇), up to a pose where these speeds hardly
    /// determine the motion. Returns the solution in (q, q̇).
    fn run_part_in_speeds_as_rates(
        &mut self,
        rhs: &mut dyn RightHandSide<f64>,
        start: InitialState<'_>,
        options: &Options,
        events: &mut [Event<'_>],
        power: Option<&mut Power<'_>>,
    ) -> Result<Solution, SimError> {
        let to_rates = |y: &[f64]| state_in_rates(self.speeds, self.parameters, y);
        let (span, y) = (start.span, self.state_in_speeds(start.y));
        let mut watched: Vec<Event<'_>> =
            events.iter_mut().map(|event| event_in_other_variables(event, &to_rates)).collect();
        let mut worked = power.map(|power| |t: f64, y: &[f64]| power(t, &to_rates(y)));
        let worked = worked.as_mut().map(|power| power as &mut dyn FnMut(f64, &[f64]) -> f64);
        let (mut leg, beyond) =
            self.run_part_in_speeds(rhs, InitialState { span, y: &y }, options, &mut watched, worked)?;
        drop(watched);
        for y in leg.y.iter_mut().chain([&mut leg.y_end]).chain(leg.events.iter_mut().map(|event| &mut event.y)) {
            *y = to_rates(y);
        }
        leg.projection = leg.projection.map(|report| part_projection_in_rates(&report, self.rates));
        // The next part lasts at least as long as the step whose failure ended this part.
        let beyond = (beyond - leg.t_end).abs();
        self.dwell = if leg.t_end.total_cmp(&span.0).is_eq() { beyond.max(2.0 * self.lasted) } else { beyond };
        Ok(leg)
    }

    /// Runs a part in the rates of all coordinates from a start (q, q̇). If the run makes no progress near
    /// a singular pose, it is repeated with wider tolerances. Records the part in `self.changes`. If the
    /// part fails, the `stop` of the returned solution gives the reason.
    fn run_part_in_rates(
        &mut self,
        start: InitialState<'_>,
        options: &Options,
        events: &mut [Event<'_>],
        power: Option<&mut Power<'_>>,
    ) -> Result<Solution, SimError> {
        let InitialState { span, y } = start;
        let options = part_options_in_rates(options, y.len() / 2);
        let mut power = power.map(|power| power.as_mut() as &mut dyn FnMut(f64, &[f64]) -> f64);
        // Near a singular pose, rounding errors may exceed the tolerances. Steps then become tiny. Wider
        // tolerances allow longer steps.
        let (mut leg, mut is_singular, mut coarser) = (None, false, 1.0);
        for times in COARSER {
            let few = Options { step_limit: options.step_limit.min(FEW), ..wider_part_options(&options, times) };
            let lent = power.as_mut().map(|power| &mut **power as &mut dyn FnMut(f64, &[f64]) -> f64);
            let (found, nearest) = self.try_part_in_rates(start, &few, events, lent)?;
            (is_singular, coarser) = (nearest < SINGULAR * self.best.borrow().constraints, times);
            let is_stuck = is_stuck(&found.stop);
            leg = Some(found);
            if !(is_stuck && is_singular) {
                break;
            }
        }
        let mut leg = match leg {
            Some(leg) if !matches!(leg.stop, Stop::StepLimit { .. }) || options.step_limit <= FEW => leg,
            _ => self.try_part_in_rates(start, &options, events, power)?.0,
        };
        self.lasted = (leg.t_end - span.0).abs();
        if is_singular && matches!(leg.stop, Stop::StepTooSmall { .. } | Stop::NotFinite { .. }) {
            let message = "the constraints depend on one another there, in a singular pose of the mechanism itself, and no motion goes on \
                           smoothly from it"
                .to_owned();
            leg.stop = Stop::Failed(Failure { code: "singular", message });
        } else if let (true, Some(lost)) = (is_singular, self.lost_energy_fraction(y, &leg)) {
            let message = format!(
                "the mechanism goes through a singular pose, where its constraints depend on one another, and {} of its energy is not kept there",
                with_significant_digits(lost, 2)
            );
            leg.stop = Stop::Failed(Failure { code: "singular", message });
        }
        let to = (leg.stop == Stop::HandedOver).then_some(leg.t_end);
        match self.changes.last_mut() {
            // No step in chosen speeds was made since the last part in all rates.
            Some(last) if last.to == Some(span.0) => {
                (last.to, last.is_singular) = (to, last.is_singular || is_singular);
                last.coarser = last.coarser.max(coarser);
            }
            _ => self.changes.push(RatesInterval { from: span.0, to, is_singular, coarser }),
        }
        Ok(leg)
    }

    /// Attempts a part of a run in the rates of all coordinates. Returns the solution, and the least
    /// independence of the constraints in this part, from 0 (dependent) to 1.
    fn try_part_in_rates(
        &self,
        start: InitialState<'_>,
        options: &Options,
        events: &mut [Event<'_>],
        power: Option<PowerAt<'_>>,
    ) -> Result<(Solution, f64), SimError> {
        let mut rhs = self.multipliers.borrow().copy_for_another_run();
        let mut over = |t: f64, y: Option<&[f64]>| {
            let lasts = (t - start.span.0).abs() < self.dwell;
            let stands = y.is_some_and(|y| self.determines_motion_well(y, RETURNS) == Some(true));
            !lasts && stands && self.is_best_known.get()
        };
        let power = power.map(|power| power as &mut dyn FnMut(f64, &[f64]) -> f64);
        let with = AccompaniedRightHandSide { rhs: &mut rhs, power, over: Some(&mut over), yields: None };
        let leg = integrate_watched(with, start, options, events)?;
        Ok((leg, rhs.least_distance_from_dependence()))
    }

    /// Relative change of the energy T + V, less the work, from a state `y` = (q, q̇) to the end of a part
    /// of the run. `None` if it is at most [`LOST`], or if the energy balance is not checked.
    fn lost_energy_fraction(&self, y: &[f64], leg: &Solution) -> Option<f64> {
        if !self.keeps_energy {
            return None;
        }
        let energies = |y: &[f64]| {
            let (q, v) = y.split_at(y.len() / 2);
            let (p, rates) = (self.parameters, self.rates);
            (rates.kinetic_energy(p, q, v), rates.potential_energy(p, q))
        };
        let ((t0, v0), (t1, v1)) = (energies(y), energies(&leg.y_end));
        let size = t0.abs().max(t1.abs()) + (v1 - v0).abs() + leg.work_end.abs();
        let part = (t1 + v1 - leg.work_end - t0 - v0).abs() / size.max(f64::MIN_POSITIVE);
        (part > LOST).then_some(part)
    }

    /// Converts a state (q, q̇) to the state (q, v) of the equations in chosen speeds.
    fn state_in_speeds(&self, y: &[f64]) -> Vec<f64> {
        let (q, q_dot) = y.split_at(y.len() / 2);
        let mut u = vec![0.0; self.rates.lengths().speeds];
        self.rates.generalized_speeds(self.parameters, q, q_dot, &mut u);
        let mut v = vec![0.0; self.speeds.lengths().variables];
        self.speeds.motion_variables(self.parameters, q, &u, &mut v);
        [q, &v].concat()
    }
}

/// True if a run stopped because its steps became too small or too many, or a value was not finite.
fn is_stuck(stop: &Stop) -> bool {
    matches!(stop, Stop::StepTooSmall { .. } | Stop::NotFinite { .. } | Stop::StepLimit { .. })
}

/// Makes an event in other variables from an event that is a function of (q, q̇). `to_rates` converts a
/// state in the other variables to (q, q̇).
fn event_in_other_variables<'e>(event: &'e mut Event<'_>, to_rates: &'e dyn Fn(&[f64]) -> Vec<f64>) -> Event<'e> {
    let function = &mut event.function;
    let in_other = move |t: f64, y: &[f64]| function(t, &to_rates(y));
    Event {
        name: event.name.clone(),
        function: Box::new(in_other),
        ranges: None,
        direction: event.direction,
        effect: event.effect,
    }
}

/// Integrates equations from a start. `rhs` also contains the conditions that are tested at each step,
/// such as the need to change variables.
fn integrate_watched(
    mut rhs: AccompaniedRightHandSide<'_>,
    start: InitialState<'_>,
    options: &Options,
    events: &mut [Event<'_>],
) -> Result<Solution, SimError> {
    integrate(LentRightHandSide(&mut rhs as &mut dyn RightHandSide<f64>), start.span, start.y, options, events)
}

/// Converts an integrated state (q, v) to (q, q̇), of length 2 n.
fn state_in_rates(system: &dyn System<f64>, p: &[f64], y: &[f64]) -> Vec<f64> {
    let mut out = Vec::new();
    write_state_in_rates(system, p, y, &mut out);
    out
}

/// Converts an integrated state (q, v) to (q, q̇), of length 2 n, and writes the result to `out`.
fn write_state_in_rates(system: &dyn System<f64>, p: &[f64], y: &[f64], out: &mut Vec<f64>) {
    let n = system.lengths().coordinates;
    let (q, v) = y.split_at(n);
    out.resize(2 * n, 0.0);
    out[..n].copy_from_slice(q);
    system.coordinate_rates(p, q, v, &mut out[n..]);
}
