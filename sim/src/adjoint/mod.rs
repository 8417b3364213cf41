//! Gradient of a function of a run's end state, by the start state and the parameters. It is computed in a single
//! backward sweep: a discrete adjoint.
//!
//! The run is a sequence of steps that were taken already. Each step is differentiated with its length held constant.
//! The sweep applies the transposed stages of explicit Runge–Kutta steps. Where the end of a step was corrected onto
//! constraints, it applies the transposed correction. Times at which the right-hand side jumps add a term if they
//! depend on parameters.
//!
//! The result is the transpose of the derivatives that [`crate::DynamicsWithTangents`] carry forward along the same
//! steps, to rounding. It costs the same for one parameter and for thousands. W. W. Hager, "Runge–Kutta methods in
//! optimal control and the transformed adjoint system", Numer. Math. 87 (2000) 247–282.
//!
//! The sweep needs the states in reverse order. Only some of them are kept, and each segment between two kept states is
//! stepped through once more. With segments that get shorter by one step each, √(2 N) states serve N steps. A.
//! Griewank, "Achieving logarithmic growth of temporal and spatial complexity in reverse automatic differentiation",
//! Optim. Methods Softw. 1 (1992) 35–54. The number of kept states changes no bit of the result.
//!
//! Absent on purpose: implicit steps, whose transposes need linear solves; and the choice of the steps.

mod transposed_step;

use crate::error::Failure;
use crate::events::corners::{BetweenCorners, Corner, Corners, IntervalsBetweenCorners};
use crate::methods::run_options::{Options, Poll};
use crate::projection::{ProjectionTarget, Projector};
use crate::right_hand_side::RightHandSide;
use crate::transposed_right_hand_side::TransposedRightHandSide;
use std::fmt;
use transposed_step::{RungeKuttaCoefficients, Stages};
use tripos_traits::Method;

/// Record of a run for its adjoint: the start, the ends of the steps that were taken, and the options.
#[derive(Clone, Copy, Debug)]
pub struct RecordedSteps<'a> {
    /// Start and end time that the run was asked to cover, s.
    pub span: (f64, f64),
    /// State at the start of the run whose gradient is wanted.
    pub y0: &'a [f64],
    /// Times at which the steps of the run ended, s, in order.
    pub ends: &'a [f64],
    /// Options of the run; its method, corners and tolerances are used.
    pub options: &'a Options,
    /// Jumps of the right-hand side whose times depend on parameters. The times of all other jumps are constant.
    pub moved: &'a [MovingJump],
}

/// Jump of the right-hand side at a time that depends on parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct MovingJump {
    /// Time of the jump, s. It must equal the time of a corner in the options of the run.
    pub at: f64,
    /// Derivative of the time of the jump by each parameter, s per unit of the parameter.
    pub by: Vec<f64>,
}

/// Run that is prepared for a backward sweep: its steps, its end state and some of its intermediate states.
pub struct Adjoint<'a> {
    /// Record of the run that is swept backward: its start, steps and options.
    course: RecordedSteps<'a>,
    /// Runge–Kutta coefficients of the run's method.
    rows: RungeKuttaCoefficients,
    /// Groups of steps between neighbouring corners, in order.
    stretches: Vec<StepsBetweenCorners>,
    /// Start of each segment of the run that is not swept yet: index of its first step, and state at the start of this
    /// step.
    kept: Vec<(usize, Vec<f64>)>,
    /// State at the end of the run, reached again by its steps.
    pub end: Vec<f64>,
}

/// Gradient of a weighted sum of the components of a run's end state, by the start and by the
/// parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Gradient {
    /// Derivative of the weighted sum of the end state by each component of the state at the start.
    pub state: Vec<f64>,
    /// Derivative of the weighted sum of the end state by each parameter.
    pub parameters: Vec<f64>,
    /// Largest number of states that the sweep kept at the same time.
    pub states: usize,
}

/// Reason why there is no gradient of a run.
#[derive(Clone, Debug, PartialEq)]
pub enum AdjointError {
    /// The steps of this method cannot be swept backward, since it is no explicit Runge–Kutta method.
    Method(Method),
    /// The lengths of the segments do not add up to the number of steps of the run.
    Segments,
    /// The `poll` function of the options has interrupted the sweep.
    Interrupted,
    /// The right-hand side has no value, or no derivatives, at a state of the run.
    Failed(Failure),
}

impl From<Failure> for AdjointError {
    fn from(failure: Failure) -> Self {
        Self::Failed(failure)
    }
}

impl fmt::Display for AdjointError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Method(method) => write!(f, "steps of `{}` are not swept backwards", method.name()),
            Self::Segments => f.write_str("the segments are not as long as the run"),
            Self::Interrupted => f.write_str("interrupted"),
            Self::Failed(failure) => f.write_str(&failure.message),
        }
    }
}

impl std::error::Error for AdjointError {}

/// Group of steps between two neighbouring corners of the right-hand side.
struct StepsBetweenCorners {
    /// Index in the run, from 0, of the first step of this group of steps between two corners.
    first: usize,
    /// Intervals between neighbouring corners of the right-hand side that contain the steps of this group.
    sides: IntervalsBetweenCorners,
    /// Index in [`RecordedSteps::moved`] of the jump just before the first step; `None` if there is no jump there whose
    /// time depends on parameters.
    jump: Option<usize>,
}

/// Working data of the steps: the right-hand side, the projector onto constraints, and the stages.
struct SweepData<'r, 'o, R> {
    /// Right-hand side in the interval of time between two neighbouring corners.
    rhs: BetweenCorners<'r, R, f64>,
    /// Projector that moves the ends of steps onto constraints; `None` if there are no constraints.
    projector: Option<Projector<'o, 'o, f64>>,
    /// Stages of a Runge–Kutta step, with working space for the transposed step.
    stages: Stages,
}

/// True if the steps of a method can be swept backward, which holds for explicit Runge–Kutta methods.
#[must_use]
pub fn has_adjoint(method: Method) -> bool {
    RungeKuttaCoefficients::of(method).is_some()
}

/// Lengths of segments, in steps, with which the backward sweep keeps the fewest states. Each segment is one step
/// shorter than the segment before it; the sum of all lengths is `steps`.
#[must_use]
pub fn adjoint_segments(steps: usize) -> Vec<usize> {
    let longest = (0..=steps).find(|k| k * (k + 1) / 2 >= steps).unwrap_or(steps);
    let mut left = steps;
    let mut next = |length: usize| {
        let own = length.min(left);
        left -= own;
        own
    };
    (1..=longest).rev().map(&mut next).filter(|length| *length > 0).collect()
}

impl<'a> Adjoint<'a> {
    /// Takes the steps of the run again, and keeps the state at the start of each segment. `segments` gives the length
    /// of each segment in steps; the sum must be the number of steps of the run.
    ///
    /// # Errors
    /// [`AdjointError`] with the reason.
    pub fn new<R: TransposedRightHandSide>(
        course: RecordedSteps<'a>,
        rhs: &mut R,
        segments: &[usize],
    ) -> Result<Self, AdjointError> {
        let method = course.options.method;
        let rows = RungeKuttaCoefficients::of(method).ok_or(AdjointError::Method(method))?;
        if segments.iter().sum::<usize>() != course.ends.len() {
            return Err(AdjointError::Segments);
        }
        let stretches = adjoint_steps_between_corners(&course);
        let mut run = Self { course, rows, stretches, kept: Vec::new(), end: course.y0.to_vec() };
        let mut under = run.sweep_data(rhs);
        let mut y = course.y0.to_vec();
        let mut first = 0;
        for length in segments {
            run.kept.push((first, y.clone()));
            for step in first..first + length {
                run.step(&mut under, step, &mut y)?;
            }
            first += length;
        }
        run.end = y;
        Ok(run)
    }

    /// Computes the gradient of Σ weightᵢ yᵢ by the state at the start and by the parameters, where y is
    /// the state at the end of the run.
    ///
    /// # Errors
    /// [`AdjointError`] with the reason, as for [`Adjoint::new`].
    pub fn gradient<R: TransposedRightHandSide>(
        mut self,
        rhs: &mut R,
        weights: &[f64],
    ) -> Result<Gradient, AdjointError> {
        let count = rhs.parameter_count();
        let mut gradient = Gradient { state: weights.to_vec(), parameters: vec![0.0; count], states: 0 };
        let mut under = self.sweep_data(rhs);
        let mut last = self.course.ends.len();
        while let Some((first, start)) = self.kept.pop() {
            let mut states = vec![start];
            for step in first..last.saturating_sub(1).max(first) {
                let mut y = states[step - first].clone();
                self.step(&mut under, step, &mut y)?;
                states.push(y);
            }
            gradient.states = gradient.states.max(self.kept.len() + states.len());
            for step in (first..last).rev() {
                self.transposed_step(&mut under, step, &states[step - first], &mut gradient)?;
            }
            last = first;
        }
        Ok(gradient)
    }

    /// Creates the working data for the steps of the run, at its start.
    fn sweep_data<'r, 'o, R: TransposedRightHandSide>(&self, rhs: &'r mut R) -> SweepData<'r, 'o, R> {
        let RecordedSteps { span, y0, options, .. } = self.course;
        let count = rhs.constraint_count();
        let mut rhs = BetweenCorners::new(rhs, options.clock, self.stretches[0].sides);
        let onto = (count > 0).then_some(ProjectionTarget::Constraints(count));
        let projector = onto.map(|onto| Projector::new(onto, &mut rhs, options, span.0, y0));
        SweepData { rhs, projector, stages: Stages::new(&self.rows, y0.len()) }
    }

    /// Start and end time of the step with this index, s.
    fn step_times(&self, step: usize) -> (f64, f64) {
        let start = step.checked_sub(1).map_or(self.course.span.0, |before| self.course.ends[before]);
        (start, self.course.ends[step])
    }

    /// Group of steps between corners to which the step with this index belongs.
    fn corner_group_of_step(&self, step: usize) -> &StepsBetweenCorners {
        &self.stretches[self.stretches.partition_point(|stretch| stretch.first <= step).saturating_sub(1)]
    }

    /// Takes the step with this index from the state `y`, and writes its end state to `y`. Returns true if the end
    /// state was moved onto the constraints. Error if f has no value, or if the run is interrupted.
    fn step<R: TransposedRightHandSide>(
        &self,
        under: &mut SweepData<'_, '_, R>,
        step: usize,
        y: &mut [f64],
    ) -> Result<bool, AdjointError> {
        let (t, t_new) = self.step_times(step);
        if Poll::ends(self.course.options.poll.as_ref(), t) {
            return Err(AdjointError::Interrupted);
        }
        let SweepData { rhs, projector, stages } = under;
        rhs.set_corner_intervals(self.corner_group_of_step(step).sides);
        stages.step(&self.rows, rhs, t, t_new, y)?;
        let moved = projector.as_mut().and_then(|projector| projector.project(rhs, t_new, y));
        if let Some(moved) = moved {
            y.copy_from_slice(moved);
        }
        Ok(moved.is_some())
    }

    /// Takes the step with this index from the state `start` again. Replaces the gradient by the step's end state with
    /// the gradient by `start`, and adds the step's derivatives by the parameters to `gradient`.
    fn transposed_step<R: TransposedRightHandSide>(
        &self,
        under: &mut SweepData<'_, '_, R>,
        step: usize,
        start: &[f64],
        gradient: &mut Gradient,
    ) -> Result<(), AdjointError> {
        let mut y = start.to_vec();
        let is_moved = self.step(under, step, &mut y)?;
        let (t, t_new) = self.step_times(step);
        let SweepData { rhs, projector, stages } = under;
        let Gradient { state, parameters, .. } = gradient;
        let next = self.stretches.iter().find(|stretch| stretch.first == step + 1);
        if let Some((next, jump)) = next.and_then(|next| Some((next, next.jump?))) {
            // s⁺ = s⁻ + (f⁻ − f⁺) dt/dp
            let own = self.corner_group_of_step(step).sides;
            let share = weighted_jump_of_rates(rhs, own, next.sides, t_new, &y, state)?;
            parameters.iter_mut().zip(&self.course.moved[jump].by).for_each(|(sum, by)| *sum += share * by);
            rhs.set_corner_intervals(own);
        }
        if let Some(projector) = projector.as_mut().filter(|_| is_moved) {
            // s⁺ = s − C (G s + φ_p), with the correction C of the constraints: the shares of the constraints are
            // subtracted.
            let mut shares = projector.project_weights(rhs, t_new, state);
            for share in &mut shares {
                *share = -*share;
            }
            rhs.pull_constraints(t_new, &y, &shares, (state, parameters))?;
        }
        Ok(stages.transposed_step(&self.rows, rhs, t, t_new, state, parameters)?)
    }
}

/// Weighted change λ·(f⁻ − f⁺) of the rates at a jump at time `t`, s. f⁻ is the right-hand side in the
/// intervals `before`, f⁺ that in `after`, and λ are `weights`.
fn weighted_jump_of_rates<R: TransposedRightHandSide>(
    rhs: &mut BetweenCorners<'_, R, f64>,
    before: IntervalsBetweenCorners,
    after: IntervalsBetweenCorners,
    t: f64,
    y: &[f64],
    weights: &[f64],
) -> Result<f64, Failure> {
    let mut sum = 0.0;
    for (sides, sign) in [(before, 1.0), (after, -1.0)] {
        let mut rates = vec![0.0; y.len()];
        rhs.set_corner_intervals(sides);
        rhs.rhs(t, y, &mut rates)?;
        sum += sign * rates.iter().zip(weights).map(|(rate, weight)| rate * weight).sum::<f64>();
    }
    Ok(sum)
}

/// Divides the steps of a run into groups between corners. Runs with equal steps ignore corners.
fn adjoint_steps_between_corners(course: &RecordedSteps<'_>) -> Vec<StepsBetweenCorners> {
    let RecordedSteps { span, ends, options, moved, .. } = course;
    let all: &[Corner] = if options.step.is_some() { &[] } else { &options.corners };
    let mut corners = Corners::new(all, *span);
    corners.pass_corners(span.0);
    let mut list = vec![StepsBetweenCorners { first: 0, sides: corners.intervals_between_corners(), jump: None }];
    for (step, t) in ends.iter().enumerate().take(ends.len().saturating_sub(1)) {
        let passed = corners.passed_corners(*t);
        if passed.is_empty() {
            continue;
        }
        let is_moved = |moved: &MovingJump| moved.by.iter().any(|by| *by != 0.0);
        let place = |corner: &Corner| moved.iter().position(|m| m.at.total_cmp(&corner.at).is_eq() && is_moved(m));
        let jump = passed.iter().filter(|corner| corner.jumps).find_map(place);
        list.push(StepsBetweenCorners { first: step + 1, sides: corners.intervals_between_corners(), jump });
    }
    list
}
