//! Backward sweep through the recorded steps of a run, from its end to its start, for a gradient. It
//! also crosses the changes of contacts between the parts of the run.

use super::backward_crossings::BackwardCrossings;
use super::recorded_steps::{RecordedPart, RecordedRun};
use super::transposed_contact_forces::{ContactsAndHeld, TransposedMotion};
use super::transposed_products::BackwardTapes;
use super::varied_numbers::{VariedNumber, moved_jumps};
use crate::error::Error;
use crate::preparation::problem::Problem;
use crate::studies::sensitivity::contacts::contact_history::DerivativeEnd;
use crate::studies::sensitivity::contacts::grazing_contacts::grazing_gap_limit;
use crate::studies::sensitivity::contacts::precise_contacts::PreciseContacts;
use crate::studies::sensitivity::differentiable_quantities::DifferentiableQuantities;
use crate::studies::sensitivity::equations_with_slopes::SlopeEquations;
use tripos_sim::adjoint::{Adjoint, AdjointError, RecordedSteps, adjoint_segments};
use tripos_sim::{Options, RightHandSide};

/// Quantity at the end of a run whose gradient is computed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// Instant at which an event ends the run, s.
    End,
    /// Quantity shown at the end of the run. The value is its index in
    /// [`DifferentiableQuantities::names`].
    Shown(usize),
}

/// Tapes, quantities and varied numbers that a backward sweep needs.
pub struct SweepInputs<'a> {
    /// Tapes of the equations of motion, which the sweep runs backwards.
    pub tapes: &'a BackwardTapes,
    /// Quantities at the end of the run that can be differentiated.
    pub quantities: &'a DifferentiableQuantities,
    /// Numbers by which derivatives are taken.
    pub numbers: &'a [VariedNumber],
    /// Equations of motion that also compute derivatives; `None` for scenes without contacts.
    pub equations: Option<&'a SlopeEquations>,
}

/// Result of a backward sweep: derivatives of its target by the integrated state at the start of a run,
/// and by each parameter. The target is the quantity whose gradient is computed.
pub struct BackwardSweep {
    /// Derivatives of the target by the state at the start, just after a change of contacts there.
    state: Vec<f64>,
    /// Derivatives of the target by each parameter. In a scene with contacts, the derivatives by each
    /// coefficient of restitution follow, then those by each coefficient of friction.
    parameters: Vec<f64>,
    /// Largest number of states that the sweep stored at one time.
    pub states: usize,
    /// Derivatives of the state at the start by each number, or the reason why they do not exist.
    starts: Vec<Result<Vec<f64>, String>>,
    /// Instant from which no derivatives exist, and the reason. `None` if the sweep reached the start.
    pub ended: Option<DerivativeEnd>,
    /// True if the derivatives by some numbers may not exist, so that each number must be checked.
    pub asks: bool,
}

impl BackwardSweep {
    /// Derivative of the target by the number with the index `at`, and the sum of the sizes of its terms.
    /// Both are NaN if the derivative does not exist.
    pub fn derivative_by(&self, at: usize, number: &VariedNumber) -> (f64, f64) {
        let (Ok(seed), Ok(start), None) = (&number.seed, &self.starts[at], &self.ended) else {
            return (f64::NAN, f64::NAN);
        };
        let slopes = start.iter().chain(&seed.parameters).chain(&seed.restitutions).chain(&seed.frictions);
        // A slope of zero adds nothing, even if the other factor is not finite.
        let terms = self.state.iter().chain(&self.parameters).zip(slopes).filter(|(_, slope)| **slope != 0.0);
        let terms = terms.map(|(share, slope)| share * slope);
        terms.fold((0.0, 0.0), |(sum, size), term| (sum + term, size + term.abs()))
    }

    /// Reason why the derivative by the number with the index `at` does not exist. `None` if no reason is
    /// known.
    pub fn missing_reason(&self, at: usize) -> Option<String> {
        self.starts[at].as_ref().err().cloned().or_else(|| self.ended.as_ref().map(DerivativeEnd::to_string))
    }
}

/// Sweeps backwards through the parts of a run. Computes the derivatives of the target by the start and
/// by the parameters.
///
/// If an event ended a part, the integrator itself repeats its last step with the actual length.
///
/// # Errors
/// [`Error::Interrupted`] if the observer ends the sweep. [`Error::Stopped`] if a value does not exist.
pub fn sweep_backwards(
    problem: &Problem<'_>,
    through: &SweepInputs<'_>,
    target: Target,
    options: &Options,
    run: &RecordedRun,
) -> Result<BackwardSweep, Error> {
    let options = problem.run_options(options);
    let contacts = through.equations.map(|equations| (problem.contacts(), equations));
    let crossings = contacts.as_ref().map(|(contacts, equations)| BackwardCrossings {
        problem,
        contacts,
        wide: PreciseContacts::new(contacts, problem.code.extended(), grazing_gap_limit(&options)),
        equations,
        corners: &options.corners,
    });
    let moved = moved_jumps(problem);
    let mut swept = BackwardSweep::new(through.numbers, crossings.as_ref(), run);
    swept.asks |= run.is_near;
    for (at, part) in run.parts.iter().enumerate().rev() {
        let held = contacts.as_ref().map(|(contacts, _)| ContactsAndHeld { contacts, kept: part.kept() });
        let mut motion = TransposedMotion::new(problem, through.tapes, held)?;
        let span = (part.t, problem.scene.span.1);
        let course = RecordedSteps { span, y0: &part.y, ends: &part.ends, options: &options, moved: &moved };
        let adjoint = Adjoint::new(course, &mut motion, &adjoint_segments(part.ends.len())).map_err(sweep_error)?;
        if at + 1 == run.parts.len() {
            let end = RunEnd { t: run.solution.t_end, y: &adjoint.end, event: run.ending_event() };
            (swept.state, swept.parameters) = end_weights(problem, through.quantities, target, &end, &mut motion)?;
        }
        let by_part = adjoint.gradient(&mut motion, &swept.state).map_err(sweep_error)?;
        swept.add_part_gradient(by_part, at);
        if let (Some(crossings), true) = (&crossings, at > 0) {
            match crossings.pull_across_crossing(part, (&mut swept.state, &mut swept.parameters)) {
                Ok(asks) => swept.asks |= asks,
                Err(ending) => swept.ended = Some(ending),
            }
        }
        if swept.ended.is_some() {
            break;
        }
    }
    Ok(swept)
}

impl BackwardSweep {
    /// Begins a sweep: computes the derivatives of the run's start by each number. They include a change
    /// of contacts at the start.
    fn new(numbers: &[VariedNumber], crossings: Option<&BackwardCrossings<'_>>, run: &RecordedRun) -> Self {
        let mut asks = false;
        let begins = crossings.zip(run.parts.first().and_then(RecordedPart::crossing));
        let start = |number: &VariedNumber| {
            let seed = number.seed.as_ref().map_err(Clone::clone)?;
            let Some((crossings, crossing)) = &begins else { return Ok(seed.state.clone()) };
            let known = crossings.with_crossing(crossing, |crossed| {
                asks |= crossed.has_shared_motion();
                crossed.slopes_after_crossing(&seed.as_varied_number(), &seed.state)
            });
            known.map(|(_, state)| state).map_err(|ending| ending.to_string())
        };
        let starts = numbers.iter().map(start).collect();
        Self { state: Vec::new(), parameters: Vec::new(), states: 0, starts, ended: None, asks }
    }

    /// Adds the derivatives of a part of the run. `before` is the number of parts before it.
    fn add_part_gradient(&mut self, part: tripos_sim::adjoint::Gradient, before: usize) {
        self.state = part.state;
        self.states = self.states.max(part.states + before);
        let count = self.parameters.len().max(part.parameters.len());
        self.parameters.resize(count, 0.0);
        self.parameters.iter_mut().zip(&part.parameters).for_each(|(sum, share)| *sum += share);
    }
}

/// Makes the error for a sweep that could not reach the start of the run.
fn sweep_error(why: AdjointError) -> Error {
    match why {
        AdjointError::Interrupted => Error::Interrupted,
        why => Error::Stopped(why.to_string()),
    }
}

/// End of a run, where a backward sweep begins.
struct RunEnd<'a> {
    /// Instant at which the run ends, s.
    t: f64,
    /// Integrated state (q, v) at the end.
    y: &'a [f64],
    /// Index of the event that ended the run; `None` if no event ended it.
    event: Option<usize>,
}

/// Computes the derivatives of the target by the state at the end of a run, and its direct derivatives
/// by the parameters. If an event g = 0 ends the run, they include the shift of the end,
/// dt = −(g_y dy + g_p dp)/(g_y f).
///
/// # Errors
/// `Error` if the rates or the reactions at the end cannot be computed.
fn end_weights(
    problem: &Problem<'_>,
    quantities: &DifferentiableQuantities,
    target: Target,
    end: &RunEnd<'_>,
    motion: &mut TransposedMotion<'_>,
) -> Result<(Vec<f64>, Vec<f64>), Error> {
    let RunEnd { t, y, event } = *end;
    let place = quantities.prepare_state(problem, t, y)?;
    let count = problem.scene.parameters.len();
    let still = (vec![0.0; count], vec![0.0; y.len()]);
    let flow = match event {
        Some(_) => {
            let mut rates = vec![0.0; y.len()];
            motion.rhs(t, y, &mut rates).map_err(|failure| sweep_error(failure.into()))?;
            Some(quantities.quantity_derivatives(&place, &still.0, &rates))
        }
        None => None,
    };
    let along = |parameters: &[f64], state: &[f64]| {
        let slopes = quantities.quantity_derivatives(&place, parameters, state);
        let later = match (event, &flow) {
            (Some(event), Some(flow)) => -slopes.watched[event] / flow.watched[event],
            _ => 0.0,
        };
        match target {
            Target::End => later,
            Target::Shown(at) => slopes.shown[at] + flow.as_ref().map_or(0.0, |flow| flow.shown[at] * later),
        }
    };
    let unit = |length: usize, at: usize| (0..length).map(|i| f64::from(u8::from(i == at))).collect::<Vec<_>>();
    let state = (0..y.len()).map(|i| along(&still.0, &unit(y.len(), i))).collect();
    Ok((state, (0..count).map(|j| along(&unit(count, j), &still.1)).collect()))
}
