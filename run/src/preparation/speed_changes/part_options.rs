//! Integration options for the parts of a run, and the joining of the solutions of the parts.

use tripos_sim::projection::ProjectionReport;
use tripos_sim::{Kind, Options, OutputOption, Solution};
use tripos_traits::{AbsoluteTolerance, Method, System};

/// Largest relative tolerance up to which a smaller tolerance is widened.
const COARSEST: f64 = 1e-3;

/// Makes the options of a part of a run in the rates of all n coordinates. The absolute tolerance of
/// each rate is the smallest tolerance of the speeds. DOP853 replaces methods that need Taylor series
/// or Jacobians, because the equations in all rates do not have them.
pub(super) fn part_options_in_rates(options: &Options, n: usize) -> Options {
    let mut options = options.clone();
    if let AbsoluteTolerance::Each(list) = &options.atol {
        let (of_q, of_u) = list.split_at(n.min(list.len()));
        let least = of_u.iter().copied().fold(f64::INFINITY, f64::min);
        options.atol = AbsoluteTolerance::Each([of_q, &vec![least; n]].concat());
    }
    if options.method == Method::Taylor || options.method.needs_jacobian() {
        options.method = Method::Dop853;
    }
    options
}

/// Multiplies the tolerances of integration options by `times`. The relative tolerance is widened to
/// at most 1e-3.
pub(super) fn wider_part_options(options: &Options, times: f64) -> Options {
    let atol = match &options.atol {
        AbsoluteTolerance::Uniform(atol) => AbsoluteTolerance::Uniform(times * atol),
        AbsoluteTolerance::Each(list) => AbsoluteTolerance::Each(list.iter().map(|atol| times * atol).collect()),
    };
    Options { rtol: options.rtol.max((times * options.rtol).min(COARSEST)), atol, ..options.clone() }
}

/// Makes the options for the rest of a run over `span`, s, after its first part `done`. Only the later
/// output instants remain, and only the steps that are left.
#[must_use]
pub fn options_for_next_part<S>(options: &Options, done: &Solution<S>, span: (f64, f64)) -> Options {
    let output = match &options.output {
        OutputOption::At(times) => {
            let toward = (span.1 - span.0).signum();
            let kept = times.iter().take_while(|at| (*at - done.t_end) * toward <= 0.0).count();
            OutputOption::At(times[kept..].to_vec())
        }
        other => other.clone(),
    };
    let step_limit = options.step_limit.saturating_sub(done.steps + done.rejected);
    Options { output, step_limit, initial_step: None, ..options.clone() }
}

/// Appends the solution `leg` of the next part of a run to the solution `all` of the run so far.
/// Times, states, work, events, warnings and counts are joined. The end and the reason of the stop are
/// those of `leg`.
#[must_use]
pub fn join_part_solutions<S>(mut all: Solution<S>, mut leg: Solution<S>, options: &Options) -> Solution<S> {
    let skipped = usize::from(!matches!(options.output, OutputOption::At(_)));
    if options.output == OutputOption::Ends {
        all.t.truncate(1);
        all.y.truncate(1);
        all.work.truncate(1);
    }
    all.t.extend(leg.t.drain(skipped..));
    all.y.extend(leg.y.drain(skipped..));
    all.work.extend(leg.work.drain(skipped.min(leg.work.len())..).map(|work| all.work_end + work));
    let start = all.t_end;
    all.events.extend(
        leg.events.into_iter().filter(|event| event.kind != Kind::AtStart || event.t.total_cmp(&start).is_ne()),
    );
    for warning in leg.warnings {
        if !all.warnings.contains(&warning) {
            all.warnings.push(warning);
        }
    }
    all.projection = match (all.projection.take(), leg.projection) {
        (Some(mut first), Some(second)) => {
            first.add(&second);
            Some(first)
        }
        (first, second) => first.or(second),
    };
    Solution {
        t_end: leg.t_end,
        y_end: leg.y_end,
        work_end: all.work_end + leg.work_end,
        steps: all.steps + leg.steps,
        rejected: all.rejected + leg.rejected,
        evaluations: all.evaluations + leg.evaluations,
        jacobians: all.jacobians + leg.jacobians,
        stop: leg.stop,
        ..all
    }
}

/// Converts the projection report of a part in chosen speeds to the state and the constraints in all
/// rates. Missing entries are zero. Both states begin with the same coordinates, and both lists of
/// constraints begin with the same constraints.
pub(super) fn part_projection_in_rates(report: &ProjectionReport, rates: &dyn System<f64>) -> ProjectionReport {
    let wide = |list: &[f64], kept: usize, count: usize| {
        let mut list = list[..kept].to_vec();
        list.resize(count, 0.0);
        list
    };
    let (count, lengths) = (rates.constraint_count(), rates.lengths());
    ProjectionReport {
        moved: wide(&report.moved, lengths.coordinates, lengths.state()),
        removed: wide(&report.removed, report.removed.len(), count),
        largest: wide(&report.largest, report.largest.len(), count),
        ..report.clone()
    }
}
