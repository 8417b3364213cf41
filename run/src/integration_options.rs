//! Integration options of the simulator, made from the settings of a scene.

use tripos_derive::scene::{Integrator, ProjectionTarget, Scene};
use tripos_sim::{Method, Options, OutputOption};
use tripos_traits::AbsoluteTolerance;

/// Makes the integration options of a scene: method, tolerances, steps, and the instants at which
/// samples are kept.
pub fn integration_options(scene: &Scene) -> Options {
    Options { output: sample_instants(scene), ..integration_options_for_ends(scene) }
}

/// Makes the integration options of a scene, but with samples only at the two ends of a run. The steps are
/// the same as with [`integration_options`].
pub fn integration_options_for_ends(scene: &Scene) -> Options {
    let how = &scene.integration;
    Options {
        // Quadrature takes no steps, so the method does not matter.
        method: how.method.method().unwrap_or(Method::Dop853),
        step: how.step,
        max_step: how.max_step,
        step_limit: how.step_limit,
        output: OutputOption::Ends,
        ..Options::tolerances(how.rtol, how.atol.clone())
    }
}

/// Describes the method of a scene with its tolerances or step, such as "ode45 with rtol 1e-3, atol 1e-5".
pub fn integration_method_words(scene: &Scene) -> String {
    let how = &scene.integration;
    if how.method == Integrator::Quadrature {
        return how.method.to_string();
    }
    let projected = match how.project {
        Some(ProjectionTarget::Energy) => ", each projected onto the energy",
        None => "",
    };
    let steps = match (how.step, &how.atol) {
        (Some(step), _) => format!("steps of {step:e} s"),
        (None, AbsoluteTolerance::Uniform(atol)) => format!("rtol {:e}, atol {atol:e}", how.rtol),
        (None, AbsoluteTolerance::Each(_)) => format!("rtol {:e}, an atol for each state", how.rtol),
    };
    let longest = how.max_step.map_or_else(String::new, |longest| format!(", steps of {longest:e} s at most"));
    let distance = how.distance.map_or_else(String::new, |d| {
        format!(", in a coordinate's distance from {}°", 90 * i64::from(d.quarter_turns))
    });
    format!("{} with {steps}{longest}{projected}{distance}", how.method)
}

/// Selects the instants at which a run of the scene keeps samples. If the scene states a number of samples,
/// they are equally spaced over its span. Otherwise there are four in each step. A program may set the instants
/// instead.
fn sample_instants(scene: &Scene) -> OutputOption {
    if !scene.integration.instants.is_empty() {
        return OutputOption::At(scene.integration.instants.clone());
    }
    match scene.integration.samples {
        None => OutputOption::Steps { refine: 4 },
        Some(n) => {
            let (from, to) = scene.span;
            let last = (n - 1).max(1) as f64;
            // The last instant is exact, without the rounding error of the division.
            OutputOption::At(
                (0..n).map(|i| if i + 1 == n { to } else { from + (to - from) * i as f64 / last }).collect(),
            )
        }
    }
}

/// Divides a span into `count` equal parts and returns the `count` + 1 instants, s. The last instant is exact,
/// without the rounding error of the division.
#[must_use]
pub fn equally_spaced_instants(span: (f64, f64), count: u32) -> Vec<f64> {
    let (from, to) = span;
    (0..=count).map(|i| if i == count { to } else { from + (to - from) * (f64::from(i) / f64::from(count)) }).collect()
}

#[cfg(test)]
mod tests {
    use super::equally_spaced_instants;

    /// Goal: the last instant is exact. Method: spans, forwards and backwards, whose parts do not add up in doubles.
    #[test]
    fn the_last_instant_is_the_end_of_the_span() {
        for hundredths in 1..1000 {
            let to = f64::from(hundredths) / 100.0;
            for span in [(0.0, to), (to, 0.1), (0.0, 1e-12 * to)] {
                let list = equally_spaced_instants(span, 40);
                assert!(list[0].total_cmp(&span.0).is_eq() && list[40].total_cmp(&span.1).is_eq(), "{span:?}");
                assert!(list.windows(2).all(|w| (w[1] - w[0]) * (span.1 - span.0) >= 0.0), "{span:?}");
            }
        }
    }
}
