//! Sentences about a speed chart. Every number in a sentence is one of its measurements.

use crate::phrases::seconds;
use tripos::studies::work_precision_chart::Measurement;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::scene::AccelerationSolution;
use tripos_sim::Method;
use tripos_sim::work_precision::fastest_within_error;

/// Accuracies for which a method is recommended: largest relative errors at the end of a run.
pub const TARGETS: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// Returns the fastest run with an error of at most `target`, among the runs for which `of` is true. `None` if there is
/// none. Runs of printed equations never count, because printed equations may differ from the derived equations.
pub fn fastest(list: &[Measurement], target: f64, of: impl Fn(&Measurement) -> bool) -> Option<&Measurement> {
    let some: Vec<&Measurement> = list.iter().filter(|m| of(m) && is_derived(m)).collect();
    let points: Vec<(f64, f64)> = some.iter().map(|m| (m.seconds.median, m.error.unwrap_or(f64::NAN))).collect();
    fastest_within_error(&points, target).map(|at| some[at])
}

/// Returns the accuracy at which kinds of runs are compared: the middle target, or the first if no
/// run reaches the middle target. `None` if no run reaches either.
fn comparison_accuracy(list: &[Measurement]) -> Option<f64> {
    [TARGETS[1], TARGETS[0]].into_iter().find(|target| fastest(list, *target, |_| true).is_some())
}

/// Returns the run time, s, at which a curve crosses an accuracy; `None` if it does not cross. The
/// time is interpolated on logarithmic axes, since tolerances are far apart.
fn time_at_accuracy(curve: &[&Measurement], target: f64) -> Option<f64> {
    let points: Vec<(f64, f64)> =
        curve.iter().filter_map(|m| Some((m.error?.max(f64::MIN_POSITIVE).ln(), m.seconds.median.ln()))).collect();
    let target = target.ln();
    let between = points.windows(2).filter(|p| p[0].0 > target && p[1].0 <= target);
    let between = between.map(|p| p[0].1 + (p[1].1 - p[0].1) * (target - p[0].0) / (p[1].0 - p[0].0));
    let at_once = points.first().filter(|p| p.0 <= target).map(|p| p.1);
    at_once.into_iter().chain(between).reduce(f64::min).map(f64::exp)
}

/// Returns, for each kind of run, the shortest time, s, in which it reaches an accuracy, with the best choice of
/// everything else. `None` for a kind that does not reach it. `of` gives the kind of a run.
fn times_by_kind<'a, Kind: PartialEq>(
    list: &'a [Measurement],
    target: f64,
    kinds: impl IntoIterator<Item = Kind>,
    of: impl Fn(&'a Measurement) -> Option<Kind>,
) -> Vec<(Kind, Option<f64>)> {
    let mut curves: Vec<Vec<&Measurement>> = Vec::new();
    for m in list.iter().filter(|m| is_derived(m)) {
        let same = |o: &Measurement| o.by == m.by && o.solve == m.solve && o.way.method() == m.way.method();
        match curves.iter_mut().find(|curve| same(curve[0])) {
            Some(curve) => curve.push(m),
            None => curves.push(vec![m]),
        }
    }
    let time = |kind: &Kind| {
        let own = curves.iter().filter(|curve| of(curve[0]).as_ref() == Some(kind));
        own.filter_map(|curve| time_at_accuracy(curve, target)).reduce(f64::min)
    };
    kinds.into_iter().map(|kind| (time(&kind), kind)).map(|(time, kind)| (kind, time)).collect()
}

/// Lists kinds of runs with their times, such as `kane in 1.00 ms, lagrange not at all`.
fn list_times<Kind>(times: &[(Kind, Option<f64>)], name: impl Fn(&Kind) -> String) -> String {
    let one = |(kind, time): &(Kind, Option<f64>)| match time {
        Some(time) => format!("{} in {}", name(kind), seconds(*time)),
        None => format!("{} not at all", name(kind)),
    };
    times.iter().map(one).collect::<Vec<_>>().join(", ")
}

/// Returns the ratio of the longest to the shortest time, among the kinds that have a time. `None`
/// for fewer than two times.
fn slowest_to_fastest_ratio<Kind>(times: &[(Kind, Option<f64>)]) -> Option<f64> {
    let arrived: Vec<f64> = times.iter().filter_map(|(_, time)| *time).collect();
    let (least, most) = (arrived.iter().copied().reduce(f64::min)?, arrived.iter().copied().reduce(f64::max)?);
    (arrived.len() > 1).then_some(most / least)
}

/// Lists the derived sets of equations that were measured, without repetition.
fn equations(list: &[Measurement]) -> Vec<&EquationsOrigin> {
    let mut found: Vec<&EquationsOrigin> = Vec::new();
    for m in list.iter().filter(|m| is_derived(m)) {
        if !found.contains(&&m.by) {
            found.push(&m.by);
        }
    }
    found
}

/// True if the run uses derived equations, false if it uses printed equations of a publication.
pub fn is_derived(m: &Measurement) -> bool {
    m.by.printed_id().is_none()
}

/// True if the run uses the equations of the whole model, false for a scene's reduced equations.
/// Only runs of the whole model compare methods and solves.
pub fn is_whole(m: &Measurement) -> bool {
    !m.by.is_reduced()
}

/// Returns the shortest time, s, in which each set of equations reaches the accuracy `target`, with the best method and
/// solve. `None` for equations that do not reach it.
fn time_by_equations(list: &[Measurement], target: f64) -> Vec<(&EquationsOrigin, Option<f64>)> {
    times_by_kind(list, target, equations(list), |m| Some(&m.by))
}

/// Returns the shortest time, s, in which each method reaches the accuracy `target` with the equations of the whole
/// model. `None` for a method that does not reach it.
fn time_by_method(list: &[Measurement], target: f64) -> Vec<(Method, Option<f64>)> {
    times_by_kind(list, target, Method::ALL, |m| m.way.method().filter(|_| is_whole(m)))
}

/// Returns the shortest time, s, in which the equations of the whole model reach the accuracy `target`, for each way to
/// solve for the accelerations. `None` for a way that does not reach it.
fn time_by_solve(list: &[Measurement], target: f64) -> Vec<(AccelerationSolution, Option<f64>)> {
    times_by_kind(list, target, AccelerationSolution::ALL, |m| is_whole(m).then_some(m.solve))
}

/// Returns a sentence that compares a scene's reduced equations with the fastest whole equations.
/// `None` unless both reach the accuracy `target`.
fn reduction_gain_sentence(list: &[Measurement], target: f64) -> Option<String> {
    let times = times_by_kind(list, target, [false, true], |m| Some(is_whole(m)));
    let [(_, Some(own)), (_, Some(whole))] = times.as_slice() else { return None };
    let (times, faster) = if own <= whole { (whole / own, "faster") } else { (own / whole, "slower") };
    Some(format!(
        "The scene's reduced equations get to {target:e} in {}, {times:.1} times {faster} than the fastest of the whole model's, in {}.",
        seconds(*own),
        seconds(*whole)
    ))
}

/// Returns the caption of the speed chart. `until` is the time at the end of the runs, s.
pub fn chart_caption(list: &[Measurement], until: f64) -> String {
    let seen = format!(
        "Each point is a run at one tolerance: its time, the middle one of several, and its error at t = {until} s; lower \
         and further left is better. What no other point of a panel beats in both is its Pareto front."
    );
    let Some(target) = comparison_accuracy(list) else { return seen };
    let own = list.iter().any(|m| !is_whole(m));
    let whole = if own { " by the equations of the whole model" } else { "" };
    let formulations = if own {
        let times = list_times(&time_by_equations(list, target), |by| by.name());
        format!("; by formulation, with the best of everything else: {times}")
    } else {
        String::new()
    };
    format!(
        "{seen} Read off the curves, an error of {target:e} takes{whole}, by method: {}; by how accelerations are found: {}{formulations}.",
        list_times(&time_by_method(list, target), |method| method.name().to_owned()),
        list_times(&time_by_solve(list, target), |solve| solve.name().to_owned())
    )
}

/// Returns a recommendation of equations, method and solve for the scene, as one paragraph.
pub fn chart_recommendation(list: &[Measurement]) -> String {
    let best: Vec<&Measurement> = TARGETS.iter().filter_map(|t| fastest(list, *t, |_| true)).collect();
    let Some(target) = comparison_accuracy(list) else {
        return format!("No measured run of this scene reaches an error of {:e}.", TARGETS[0]);
    };
    let common = |of: &dyn Fn(&Measurement) -> &'static str| {
        let first = best.first().map(|m| of(m))?;
        best.iter().all(|m| of(m) == first).then_some(first)
    };
    let own = !best.is_empty() && best.iter().all(|m| !is_whole(m));
    let use_ = match (common(&|m| m.way.solve(m.solve)), common(&|m| m.way.name())) {
        (_, Some(method)) if own => {
            format!(
                "Use the scene's reduced equations by {method}: on this scene that is the fastest to every accuracy below."
            )
        }
        _ if own => {
            "Use the scene's reduced equations: on this scene they are the fastest to every accuracy below; the \
                     method depends on the accuracy."
                .to_owned()
        }
        (Some(solve), Some(method)) => format!(
            "Use {method} with {solve} accelerations: on this scene that is the fastest to every accuracy below."
        ),
        (Some(solve), None) => format!(
            "Use {solve} accelerations: on this scene they are the fastest to every accuracy below; the method depends on the accuracy."
        ),
        (None, Some(method)) => format!(
            "Use {method}: on this scene it is the fastest to every accuracy below; how accelerations are best found depends on the accuracy."
        ),
        (None, None) => "On this scene solve and method depend on the accuracy, as listed below.".to_owned(),
    };
    let factors = [
        ("methods", slowest_to_fastest_ratio(&time_by_method(list, target))),
        ("solves", slowest_to_fastest_ratio(&time_by_solve(list, target))),
        ("formulations", slowest_to_fastest_ratio(&time_by_equations(list, target))),
    ];
    let factors: Vec<String> =
        factors.iter().filter_map(|(what, factor)| Some(format!("{what} {:.1}", (*factor)?))).collect();
    let compared = (!factors.is_empty()).then(|| {
        format!(
            "At an error of {target:e} the slowest that gets there takes longer than the fastest by a factor: {}.",
            factors.join(", ")
        )
    });
    [Some(use_), reduction_gain_sentence(list, target), compared].into_iter().flatten().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use tripos::studies::chart_case::MethodAtTolerance;
    use tripos_derive::Formulation;
    use tripos_sim::Stop;
    use tripos_sim::work_precision::TimeStatistics;

    const KANE: EquationsOrigin = EquationsOrigin::Derived(Formulation::Kane);

    fn run(
        by: EquationsOrigin,
        solve: AccelerationSolution,
        method: Method,
        time: f64,
        error: Option<f64>,
    ) -> Measurement {
        Measurement {
            by,
            solve,
            way: MethodAtTolerance::Steps(method, 1e-9),
            seconds: TimeStatistics { least: time, median: time, most: time, runs: 1 },
            error,
            steps: 1,
            evaluations: 1,
            stop: Stop::End,
            drifts: Vec::new(),
        }
    }

    /// Truth: on logarithmic axes, 1e-6 in 1 ms lies halfway between 1e-4 in 0.1 ms and 1e-8 in 10 ms.
    #[test]
    fn words_are_those_of_the_measurements() {
        let list = [
            run(KANE, AccelerationSolution::Eliminated, Method::Dop853, 1e-4, Some(1e-4)),
            run(KANE, AccelerationSolution::Eliminated, Method::Dop853, 1e-2, Some(1e-8)),
            run(Formulation::Lagrange.into(), AccelerationSolution::Eliminated, Method::Dop853, 2e-3, Some(1e-10)),
            run(KANE, AccelerationSolution::Numeric, Method::Dop853, 3e-3, Some(1e-10)),
            run(KANE, AccelerationSolution::Eliminated, Method::Ode45, 8e-3, Some(1e-9)),
            run(KANE, AccelerationSolution::Eliminated, Method::Rk4, 1e-3, Some(1e-2)),
            run(KANE, AccelerationSolution::Eliminated, Method::Gauss6, 1e-3, None),
            run(
                EquationsOrigin::Printed { id: "x".to_owned(), formulation: Formulation::Kane },
                AccelerationSolution::Numeric,
                Method::Dop853,
                1e-6,
                Some(0.0),
            ),
        ];
        let caption = chart_caption(&list, 10.0);
        assert!(caption.contains("at t = 10 s") && caption.contains("an error of 1e-6 takes"), "{caption}");
        assert!(caption.contains("rk4 not at all, ode45 in 8.00 ms"), "{caption}");
        assert!(caption.contains("eliminated in 1.00 ms, numeric in 3.00 ms."), "{caption}");
        let lead = chart_recommendation(&list);
        assert!(lead.starts_with("Use dop853 with eliminated accelerations"), "{lead}");
        assert!(lead.ends_with("methods 8.0, solves 3.0, formulations 2.0."), "{lead}");
    }

    /// Truth: 0.1 ms against 1 ms. The factors between methods and between solves remain those of the whole model.
    #[test]
    fn a_scenes_own_equations_are_named_where_they_win() {
        let mut list = vec![
            run(KANE, AccelerationSolution::Eliminated, Method::Dop853, 1e-3, Some(1e-10)),
            run(KANE, AccelerationSolution::Numeric, Method::Dop853, 3e-3, Some(1e-10)),
            run(KANE, AccelerationSolution::Eliminated, Method::Ode45, 8e-3, Some(1e-10)),
            run(EquationsOrigin::Reduced, AccelerationSolution::Eliminated, Method::Dop853, 1e-4, Some(1e-10)),
        ];
        let said = chart_recommendation(&list);
        assert!(said.starts_with("Use the scene's reduced equations by dop853: on this scene"), "{said}");
        assert!(
            said.contains(
                "get to 1e-6 in 100 µs, 10.0 times faster than the fastest of the whole model's, in 1.00 ms."
            ),
            "{said}"
        );
        assert!(said.ends_with("methods 8.0, solves 3.0, formulations 10.0."), "{said}");
        assert!(
            chart_caption(&list, 1.0)
                .ends_with("by formulation, with the best of everything else: kane in 1.00 ms, reduced in 100 µs.")
        );
        list[3].seconds.median = 2e-3;
        let said = chart_recommendation(&list);
        assert!(
            said.starts_with("Use dop853 with eliminated accelerations:") && said.contains("2.0 times slower"),
            "{said}"
        );
    }

    #[test]
    fn where_nothing_arrives_it_is_said() {
        let list = [run(KANE, AccelerationSolution::Eliminated, Method::Dop853, 1e-3, None)];
        assert!(
            chart_recommendation(&list).starts_with("No measured run") && chart_caption(&list, 1.0).ends_with("front.")
        );
    }
}
