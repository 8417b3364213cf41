//! Work–precision measurements: computing time of runs against their error.
//!
//! The error of a run is the largest |found − reference| / (1 + |reference|) over all components. Absent on purpose:
//! models, and the search for a reference.

#[cfg(feature = "clock")]
use std::ops::ControlFlow;
#[cfg(feature = "clock")]
use std::time::Instant;

use tripos_traits::{DoubleDouble, Method, Real, Scalar, larger};

use crate::methods::run_options::{Options, OutputOption};

/// Statistics of the measured times of repeated runs, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeStatistics {
    /// Shortest measured computing time, s.
    pub least: f64,
    /// Median of the measured times, s; for an even number of times, the lower of the middle two.
    pub median: f64,
    /// Longest measured computing time, s.
    pub most: f64,
    /// Number of runs that were timed.
    pub runs: usize,
}

impl TimeStatistics {
    /// Computes the statistics of measured times, s. `None` if there are no times.
    #[must_use]
    pub fn of_times(times: &[f64]) -> Option<Self> {
        let mut sorted = times.to_vec();
        sorted.sort_by(f64::total_cmp);
        let (least, most) = (*sorted.first()?, *sorted.last()?);
        Some(Self { least, median: sorted[(sorted.len() - 1) / 2], most, runs: sorted.len() })
    }
}

/// Error of a state: the largest |found − reference| / (1 + |reference|) over all components, computed in double-double
/// numbers. NaN if a component is NaN, or if the lengths differ.
#[must_use]
pub fn work_precision_error(found: &[DoubleDouble], reference: &[DoubleDouble]) -> f64 {
    if found.len() != reference.len() {
        return f64::NAN;
    }
    let one = |(x, r): (&DoubleDouble, &DoubleDouble)| ((*x - *r).abs() / (DoubleDouble::int(1) + r.abs())).to_f64();
    found.iter().zip(reference).map(one).fold(0.0, larger)
}

/// Options for a run of a method at a tolerance, over a span of `length` s.
///
/// Relative and absolute tolerance are equal. A method without an error estimate takes equal steps of length/10 ·
/// tolerance^(1/order), so that its error falls about in proportion to the tolerance.
#[must_use]
pub fn work_precision_options(method: Method, tolerance: f64, length: f64, step_limit: u64) -> Options {
    let order = method.order().filter(|_| !method.is_adaptive());
    let step = order.map(|order| 0.1 * length.abs() * tolerance.powf(1.0 / f64::from(order)));
    Options { method, step, step_limit, output: OutputOption::Ends, ..Options::tolerances(tolerance, tolerance) }
}

/// Measures the time of each job `repeats` times, s. All jobs run once before any job runs again, so that other load of
/// the machine affects them alike. Returns a list of times for each job.
///
/// `after` is called after every single run. If it breaks, the measurement ends, and that run is not counted.
#[cfg(feature = "clock")]
pub fn timed_in_turn(
    jobs: &mut [Box<dyn FnMut() + '_>],
    repeats: usize,
    mut after: impl FnMut() -> ControlFlow<()>,
) -> Vec<Vec<f64>> {
    let mut all = vec![Vec::with_capacity(repeats); jobs.len()];
    for _ in 0..repeats {
        for (job, times) in jobs.iter_mut().zip(&mut all) {
            let start = Instant::now();
            job();
            let seconds = start.elapsed().as_secs_f64();
            if after().is_break() {
                return all;
            }
            times.push(seconds);
        }
    }
    all
}

/// Indices of the points (time in s, error) that no other point beats in both time and error, sorted by time. Points
/// that are not finite are left out.
#[must_use]
pub fn work_precision_front(points: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> =
        (0..points.len()).filter(|i| points[*i].0.is_finite() && points[*i].1.is_finite()).collect();
    order.sort_by(|a, b| points[*a].0.total_cmp(&points[*b].0).then(points[*a].1.total_cmp(&points[*b].1)));
    let mut best = f64::INFINITY;
    order.retain(|i| {
        let better = points[*i].1 < best;
        best = best.min(points[*i].1);
        better
    });
    order
}

/// Index of the fastest point (time in s, error) whose error is at most `target`; `None` if no error is
/// so small.
#[must_use]
pub fn fastest_within_error(points: &[(f64, f64)], target: f64) -> Option<usize> {
    let good = (0..points.len()).filter(|i| points[*i].1 <= target && points[*i].0.is_finite());
    good.min_by(|a, b| points[*a].0.total_cmp(&points[*b].0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spread_has_the_middle_time() {
        let spread = TimeStatistics::of_times(&[3.0, 1.0, 9.0, 2.0]).unwrap();
        assert_eq!((spread.least, spread.median, spread.most, spread.runs), (1.0, 2.0, 9.0, 4));
        assert_eq!(TimeStatistics::of_times(&[]), None);
    }

    #[test]
    fn errors_are_relative_to_large_references_and_absolute_to_small_ones() {
        let wide = |list: &[f64]| list.iter().map(|x| DoubleDouble::from_f64(*x)).collect::<Vec<_>>();
        assert_eq!(work_precision_error(&wide(&[3.0, 0.5]), &wide(&[1.0, 0.0])), 1.0);
        // Numbers closer together than the precision of an `f64`: 1 + 1e-25 and 1.
        let close = [DoubleDouble::sum(1.0, 1e-25)];
        assert!((work_precision_error(&close, &wide(&[1.0])) / 0.5e-25 - 1.0).abs() < 1e-6);
        assert!(
            work_precision_error(&wide(&[f64::NAN]), &wide(&[1.0])).is_nan()
                && work_precision_error(&wide(&[1.0]), &[]).is_nan()
        );
    }

    #[test]
    fn the_front_has_what_nothing_beats() {
        let points =
            [(1.0, 1e-3), (2.0, 1e-6), (3.0, 1e-5), (2.0, 1e-7), (f64::NAN, 0.0), (9.0, f64::NAN), (5.0, 1e-7)];
        assert_eq!(work_precision_front(&points), [0, 3]);
        assert_eq!(fastest_within_error(&points, 1e-5), Some(1));
        assert_eq!(fastest_within_error(&points, 1e-9), None);
    }

    #[test]
    fn every_job_is_timed_as_often_as_the_others() {
        let (mut first, mut second, mut told) = (0, 0, 0);
        let mut jobs: Vec<Box<dyn FnMut() + '_>> = vec![Box::new(|| first += 1), Box::new(|| second += 1)];
        let times = timed_in_turn(&mut jobs, 3, || {
            told += 1;
            ControlFlow::Continue(())
        });
        drop(jobs);
        assert_eq!((first, second, told), (3, 3, 6));
        assert!(times.iter().all(|t| t.len() == 3 && t.iter().all(|x| *x >= 0.0)));
    }

    #[test]
    fn a_method_without_error_estimate_takes_equal_steps() {
        let options = work_precision_options(Method::Rk4, 1e-8, 10.0, 100);
        assert!((options.step.unwrap() - 0.01).abs() < 1e-12);
        assert_eq!(super::work_precision_options(Method::Ode45, 1e-8, 10.0, 100).step, None);
    }
}
