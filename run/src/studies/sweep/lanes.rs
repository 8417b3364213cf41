//! Runs of a sweep that are computed at the same time, in the lanes of vector registers.
//!
//! Invariant: the point and the scene alone decide if a point of the sweep is run in lanes. The result of
//! a point does not depend on the other points of its block. So a sweep divided into shards gives the
//! same rows.

use crate::code::Code;
use crate::integration_options::integration_options_for_ends;
use crate::preparation::problem::Problem;
use crate::trust::watched_functions::{WatchedFunctions, watched_events};
use tripos_derive::scene::{AccelerationSolution, Scene};
use tripos_sim::batch::{self, BatchOutcome, BatchPlan, Trajectory, WatchedTrajectory};
use tripos_sim::{EliminatedDynamics, Method, Options, OutputOption, Solution};
use tripos_traits::{CompiledSystem, InLanes};

/// Finds the equations that compute several runs of a sweep at once in lanes of vector registers. `None`
/// if the run of this problem cannot use lanes.
///
/// The equations must be compiled, with eliminated accelerations. The integrator must be DOP853 or
/// Taylor's method with error control. Contacts, constraints, projection and corners are not allowed.
pub fn lane_equations(problem: &Problem<'_>) -> Option<InLanes<'static>> {
    let Problem { model, scene, code, solve, .. } = *problem;
    let Code::Compiled(CompiledSystem { lanes: Some(lanes), .. }) = code else { return None };
    let how = &scene.integration;
    let has_method =
        how.method == Method::Dop853.into() || how.method == Method::Taylor.into() && lanes.series.is_some();
    // Lanes cannot correct states onto constraints, end steps at corners, or compute impacts.
    let is_moved = code.system().constraint_count() > 0 || !scene.impacts.is_empty();
    let cornered = !model.corner_instants(&scene.parameters).is_empty();
    let is_free = how.step.is_none() && how.project.is_none();
    let plain = solve == AccelerationSolution::Eliminated && is_free && !is_moved && !cornered;
    (has_method && plain).then_some(*lanes)
}

/// Request to run one point of a sweep in lanes: its problem, start and integration plan.
pub struct LaneRequest<'s> {
    /// Scene of the point with its equations.
    problem: Problem<'s>,
    /// Integration plan: integrator, span, tolerances and limits.
    plan: BatchPlan,
    /// Integrated state (q, v) at the start.
    start: Vec<f64>,
}

impl<'s> LaneRequest<'s> {
    /// Makes the request for a problem. `None` if the run cannot start. The ordinary run of the point then
    /// reports the reason.
    pub fn new(problem: Problem<'s>) -> Option<Self> {
        let scene: &Scene = problem.scene;
        let Options { method, order, rtol, atol, max_step, step_limit, .. } = integration_options_for_ends(scene);
        let start = problem.start().ok()?;
        let finite = scene.parameters.iter().chain(&start).all(|x| x.is_finite());
        let plan = BatchPlan { method, order, span: scene.span, rtol, atol, max_step, step_limit };
        finite.then_some(Self { problem, plan, start })
    }

    /// Parameters and start of the run, in the form that the batch integrator reads.
    fn trajectory(&self) -> Trajectory<'_> {
        Trajectory { parameters: &self.problem.scene.parameters, start: &self.start }
    }

    /// Events that the run watches, and its equations, which give the divisors.
    fn watched_lane<'a>(&'a self, balance: &'a WatchedFunctions) -> WatchedTrajectory<'a> {
        let equations = EliminatedDynamics::new(self.problem.system(), &self.problem.scene.parameters);
        let equations = Box::new(equations.expect("only eliminated equations are had in lanes"));
        WatchedTrajectory { equations, events: watched_events(&self.problem, balance) }
    }
}

/// Runs requests in lanes. Requests with equal plans run together. Returns a solution for each request,
/// in the order of the requests. `None` for an invalid plan. The ordinary run of the point then reports
/// the reason.
pub fn run_lanes(
    equations: InLanes<'_>,
    balance: &WatchedFunctions,
    requests: &[LaneRequest<'_>],
) -> Vec<Option<Solution>> {
    let mut solutions: Vec<Option<Solution>> = requests.iter().map(|_| None).collect();
    let mut left: Vec<usize> = (0..requests.len()).collect();
    while let Some(first) = left.first() {
        let plan = requests[*first].plan.clone();
        let (together, others): (Vec<usize>, Vec<usize>) = left.iter().partition(|at| requests[**at].plan == plan);
        left = others;
        let trajectories: Vec<Trajectory<'_>> = together.iter().map(|at| requests[*at].trajectory()).collect();
        let watching = |at: usize| requests[together[at]].watched_lane(balance);
        let Ok(outcomes) = batch::integrate_watched(equations, &plan, &trajectories, Some(&watching)) else { continue };
        for (at, outcome) in together.into_iter().zip(outcomes) {
            solutions[at] = Some(lane_solution(&requests[at], outcome));
        }
    }
    solutions
}

/// Converts the outcome of a run in lanes to a solution with two samples: its start and its end.
fn lane_solution(request: &LaneRequest<'_>, outcome: BatchOutcome) -> Solution {
    let BatchOutcome { t_end, y_end, stop, steps, rejected, evaluations, events } = outcome;
    debug_assert_eq!(request.plan.options().output, OutputOption::Ends);
    Solution {
        t: vec![request.plan.span.0, t_end],
        y: vec![request.start.clone(), y_end.clone()],
        work: Vec::new(),
        t_end,
        y_end,
        work_end: 0.0,
        steps,
        rejected,
        evaluations,
        jacobians: 0,
        stop,
        events,
        impacts: Vec::new(),
        projection: None,
        warnings: Vec::new(),
    }
}
