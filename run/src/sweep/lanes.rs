//! Runs of a sweep side by side in vector registers.
//!
//! Invariant: whether a point runs in lanes depends on the point and the scene alone, and its result on nothing else in
//! its block: so a sweep cut into shards gives the same rows.

use crate::code::Code;
use crate::how::options_of_ends;
use crate::problem::Problem;
use tripos_derive::Model;
use tripos_derive::scene::{Scene, Solve};
use tripos_sim::batch::{self, Outcome, Plan, Trajectory};
use tripos_sim::{Method, Options, Output, Solution};
use tripos_traits::{CompiledSystem, InLanes};

/// The equations of a sweep in lanes, if its runs may share them: they are compiled and eliminated, the method is
/// DOP853 with steps chosen by the error, and nothing is watched on the way.
pub fn equations(model: &Model, scene: &Scene, solve: Solve, code: &Code) -> Option<InLanes<'static>> {
    let Code::Compiled(CompiledSystem { lanes: Some(lanes), .. }) = code else { return None };
    let how = &scene.integration;
    // Lanes look at nothing on their way: neither at events nor at what the equations divide by.
    let divides = code.system().divisor_count() > 0;
    let watched = divides || !model.domain.is_empty() || !scene.events.is_empty() || !scene.impacts.is_empty();
    // Nor do they end their steps at corners.
    let cornered = !model.corners(&scene.parameters).is_empty();
    let plain = solve == Solve::Eliminated && how.method == Method::Dop853.name() && how.step.is_none();
    (plain && !watched && !cornered).then_some(*lanes)
}

/// What one point asks of a batch.
pub struct Request {
    plan: Plan,
    parameters: Vec<f64>,
    start: Vec<f64>,
}

impl Request {
    /// The request of a problem that can start; others are for the scalar run, which says why they cannot.
    pub fn new(problem: &Problem<'_>) -> Option<Self> {
        let scene: &Scene = problem.scene;
        let Options { rtol, atol, max_step, step_limit, .. } = options_of_ends(scene).ok()?;
        let (parameters, start) = (scene.parameters.clone(), problem.start().ok()?);
        let finite = parameters.iter().chain(&start).all(|x| x.is_finite());
        let plan = Plan { span: scene.span, rtol, atol, max_step, step_limit };
        finite.then_some(Self { plan, parameters, start })
    }
}

/// Runs the requests, those of one plan together. Nothing for those whose plan makes no sense: the scalar run says why.
pub fn run(equations: InLanes<'_>, requests: &[Request]) -> Vec<Option<Solution>> {
    let mut solutions: Vec<Option<Solution>> = requests.iter().map(|_| None).collect();
    let mut left: Vec<usize> = (0..requests.len()).collect();
    while let Some(first) = left.first() {
        let plan = requests[*first].plan.clone();
        let (together, others): (Vec<usize>, Vec<usize>) = left.iter().partition(|at| requests[**at].plan == plan);
        left = others;
        let trajectories: Vec<Trajectory<'_>> = together
            .iter()
            .map(|at| Trajectory { parameters: &requests[*at].parameters, start: &requests[*at].start })
            .collect();
        let Ok(outcomes) = batch::integrate(equations, &plan, &trajectories) else { continue };
        for (at, outcome) in together.into_iter().zip(outcomes) {
            solutions[at] = Some(solution(&requests[at], outcome));
        }
    }
    solutions
}

/// The outcome with its start, as [`Output::Ends`] has it.
fn solution(request: &Request, outcome: Outcome) -> Solution {
    let Outcome { t_end, y_end, stop, steps, rejected, evaluations } = outcome;
    debug_assert_eq!(request.plan.options().output, Output::Ends);
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
        events: Vec::new(),
        impacts: Vec::new(),
        projection: None,
        warnings: Vec::new(),
    }
}
