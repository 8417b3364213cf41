//! Choice of a second run of the same motion, which measures the error of the first run.
//!
//! The two runs have different steps. Their difference is the error of the less exact run. A run that is ten times
//! finer shows the whole error of the first run. A run that is ten times coarser shows its own error, which is larger.
//!
//! The finer run is another method at a tenth of the tolerances. It is chosen if it is known to cost no more than the
//! first run. The coarser run always costs less.
//!
//! Invariant: a second run never has the same steps as the first, not even if both have the longest allowed step, since
//! equal steps make equal errors. Cost is counted in evaluations of the right-hand side, not timed.

use crate::error_test::SMALLEST_RTOL;
use crate::methods::method_rules::method_rules;
use crate::methods::run_options::Options;
use crate::methods::step_size_rules::StepSizeRules;
use crate::methods::taylor::taylor_order;
use crate::solution::Solution;
use tripos_traits::{AbsoluteTolerance, Method};

/// Factor by which the tolerances of a second run are finer or coarser than those of the first run.
const TIMES: f64 = 10.0;
/// Fraction of the difference from a coarser second run that counts as the first run's error. A tenth would be
/// expected, but a motion may amplify the two errors differently. With the fraction one half, 4 of 208 runs of gauss6
/// had more than ten times the stated error.
const PART: f64 = 1.0;
/// Largest tolerance at which `dop853` takes no more evaluations than a method of order 5 at ten times
/// the tolerance. At this tolerance Taylor's method takes no more time than `dop853`.
const FINE: f64 = 1e-6;
/// Cost of a finer second run, in units of the first run's cost, at tolerances above `FINE`.
const COARSE_COST: f64 = 1.6;
/// Number of evaluations of the right-hand side that a second run may always take, even if the first
/// run took fewer.
const LEAST: f64 = 20_000.0;
/// Largest cost of a second run, in units of the first run's cost: 1, with a margin for the error of
/// the forecast.
const MOST: f64 = 1.25;
/// Relative and absolute tolerance of the second run that checks a run with equal steps.
const EQUAL: f64 = 1e-12;

/// Second run of a motion, whose difference from the first run measures the error of the first.
#[derive(Clone, Debug, PartialEq)]
pub struct SecondRun {
    /// Options of the second run. Its output option is that of the first run, and may be changed.
    pub options: Options,
    /// Fraction of the difference of the two runs that counts as the error of the first run.
    pub part: f64,
    /// True if the second run has smaller errors than the first. The second run then shows the behaviour of the motion
    /// better.
    pub is_finer: bool,
    /// Description of the second run in words, such as "dop853 at a tenth of the tolerances".
    pub words: String,
}

/// Cost of the Taylor coefficients of the equations, compared with a step of the method `dop853`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TaylorSeries {
    /// The Taylor coefficients of a step cost at most as much as a step of `dop853`.
    Cheap,
    /// The Taylor coefficients of a step cost more than a step of `dop853`, or the equations have none.
    Costly,
}

/// Lists the second runs that can measure the error of a run with these options, best first. If the first of the list
/// ends early, the next can be tried. `solution` is the result of the first run over `span`, s.
#[must_use]
pub fn second_runs(options: &Options, solution: &Solution, span: (f64, f64), series: TaylorSeries) -> Vec<SecondRun> {
    let method = options.method;
    let spent = solution.evaluations as f64 * second_run_evaluation_cost(options);
    let first = FirstRun { options, spent, length: (span.1 - span.0).abs() };
    let is_cheap = first_run_tolerance(options) <= FINE || COARSE_COST * spent <= LEAST;
    let finer_by = |other: Method, cost: f64| first.finer_second_run(other, TIMES, cost);
    if options.step.is_some() {
        return vec![finer_by(Method::Dop853, 0.5), first.coarser_second_run()];
    }
    match method {
        Method::Taylor => vec![finer_by(Method::Taylor, MOST)],
        // Most motions are not stiff, and the implicit method takes several times as long for them. The errors of
        // Gauss6 are far below the tolerances; DOP853 reaches them only at much finer tolerances.
        Method::Gauss6 => vec![first.finer_second_run(Method::Dop853, TIMES * TIMES, 0.5), first.coarser_second_run()],
        Method::Dop853 if is_cheap && series == TaylorSeries::Cheap => vec![finer_by(Method::Taylor, MOST)],
        Method::Ode45 | Method::Dopri5 if is_cheap => vec![finer_by(Method::Dop853, MOST)],
        Method::Dop853 | Method::Radau5 if COARSE_COST * spent <= LEAST => vec![finer_by(method, MOST)],
        _ => vec![first.coarser_second_run()],
    }
}

/// First run, whose error a second run measures.
struct FirstRun<'a> {
    /// Options of the first run, whose error is wanted.
    options: &'a Options,
    /// Cost of the first run, in evaluations of the right-hand side.
    spent: f64,
    /// Length of the span of the first run, s.
    length: f64,
}

impl FirstRun<'_> {
    /// Makes the second run by `method` at tolerances that are `times` times finer. `cost` is the largest allowed cost
    /// of the second run, in units of the first run's cost.
    fn finer_second_run(&self, method: Method, times: f64, cost: f64) -> SecondRun {
        let first = self.options;
        let same = method == first.method;
        let mut options = match first.step {
            Some(_) => Options { method, step: None, order: None, ..Options::tolerances(EQUAL, EQUAL) },
            None => Options { method, order: None, ..self.options_at_tolerances(1.0 / times) },
        };
        options.max_step = if same { Some(self.longest_step_of_second_run(1.0 / times)) } else { first.max_step };
        if same && method == Method::Taylor {
            options.order = Some((taylor_order(first) + 3).min(crate::methods::run_options::ORDERS.1));
        }
        let how = if first.step.is_some() {
            format!("at tolerances of {EQUAL:e}")
        } else if times > TIMES {
            "at a hundredth of the tolerances".to_owned()
        } else {
            "at a tenth of the tolerances".to_owned()
        };
        let words = format!("{} {how}", method.name());
        SecondRun { options: self.limit_second_run(options, cost), part: 1.0, is_finer: true, words }
    }

    /// Makes the second run by the first run's method at ten times the tolerances. If the first run has equal steps,
    /// the steps of the second are lengthened until they make ten times the error.
    fn coarser_second_run(&self) -> SecondRun {
        let first = self.options;
        let stretch = TIMES.powf(1.0 / f64::from(first.method.order().unwrap_or(8)));
        let mut options = self.options_at_tolerances(TIMES);
        options.step = first.step.map(|step| step * stretch);
        options.initial_step = first.initial_step.map(|step| step * stretch);
        options.max_step = Some(self.longest_step_of_second_run(TIMES));
        let how = if first.step.is_some() {
            format!("with steps {stretch:.2} times as long")
        } else {
            "at ten times the tolerances".to_owned()
        };
        let words = format!("{} {how}", first.method.name());
        SecondRun { options: self.limit_second_run(options, MOST), part: PART, is_finer: false, words }
    }

    /// Options of the first run with tolerances multiplied by `times`, and without an initial step.
    fn options_at_tolerances(&self, times: f64) -> Options {
        let first = self.options;
        let rtol = if first.rtol > 0.0 { (first.rtol * times).clamp(SMALLEST_RTOL, 0.5) } else { 0.0 };
        let atol = match &first.atol {
            AbsoluteTolerance::Uniform(atol) => AbsoluteTolerance::Uniform(atol * times),
            AbsoluteTolerance::Each(list) => AbsoluteTolerance::Each(list.iter().map(|atol| atol * times).collect()),
        };
        Options { rtol, atol, initial_step: None, ..first.clone() }
    }

    /// Largest step size, s, at which a step makes `times` times the error of the longest step of the first
    /// run.
    fn longest_step_of_second_run(&self, times: f64) -> f64 {
        let order = f64::from(self.options.method.order().unwrap_or(8));
        let own = method_rules(self.options.method).map_or(1.0, StepSizeRules::longest_part) * self.length;
        self.options.max_step.unwrap_or(own) * times.powf(1.0 / order)
    }

    /// Sets the limit on the number of steps so that the second run costs at most `cost` times the first
    /// run.
    fn limit_second_run(&self, options: Options, cost: f64) -> Options {
        let evaluations = (cost * self.spent).max(LEAST);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "positive, and far below 2^64")]
        let step_limit = (evaluations
            / (second_run_evaluations_per_step(options.method) * second_run_evaluation_cost(&options)))
        .ceil() as u64;
        Options { step_limit, ..options }
    }
}

/// Tolerance that decides most steps: the relative tolerance, or the smallest absolute tolerance if the relative one is
/// zero.
fn first_run_tolerance(options: &Options) -> f64 {
    if options.rtol > 0.0 { options.rtol } else { options.atol.smallest() }
}

/// Typical number of evaluations of the right-hand side in an attempted step of a method.
fn second_run_evaluations_per_step(method: Method) -> f64 {
    match method {
        Method::Taylor => 1.0,
        Method::Rk4 => 4.0,
        Method::Ode45 | Method::Dopri5 => 6.0,
        // Three stages of an implicit method are iterated about four times.
        Method::Dop853 | Method::Gauss6 | Method::Radau5 => 12.0,
    }
}

/// Cost of an evaluation in calls of the right-hand side: 1, or the order of the series for Taylor's
/// method.
fn second_run_evaluation_cost(options: &Options) -> f64 {
    if options.method == Method::Taylor { taylor_order(options) as f64 } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{OutputOption, integrate};

    fn run(options: &Options) -> Solution {
        let mut rhs = |_t: f64, y: &[f64], out: &mut [f64]| {
            (out[0], out[1]) = (y[1], -y[0].sin());
            Ok(())
        };
        integrate(&mut rhs, (0.0, 40.0), &[2.5, 0.0], options, &mut []).unwrap()
    }

    /// Methods that need only the right-hand side; a run at the tolerance 1e-13 is the reference.
    #[test]
    fn a_second_run_tells_the_error_within_a_digit_and_costs_no_more() {
        let exact = run(&Options { method: Method::Dop853, ..Options::tolerances(1e-13, 1e-13) }).y_end;
        let apart = |a: &[f64], b: &[f64]| (a[0] - b[0]).abs().max((a[1] - b[1]).abs());
        for method in [Method::Ode45, Method::Dopri5, Method::Dop853] {
            for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
                let options =
                    Options { method, output: OutputOption::Ends, ..Options::tolerances(tolerance, tolerance) };
                let first = run(&options);
                let second = &second_runs(&options, &first, (0.0, 40.0), TaylorSeries::Costly)[0];
                let other = run(&Options { output: OutputOption::Ends, ..second.options.clone() });
                assert_eq!(other.stop, crate::Stop::End, "{}", second.words);
                let (told, right) = (second.part * apart(&other.y_end, &first.y_end), apart(&exact, &first.y_end));
                assert!(told > 0.1 * right && told < 30.0 * right, "{method:?} {tolerance}: {told:e} for {right:e}");
                assert!(other.evaluations as f64 <= (MOST * first.evaluations as f64).max(LEAST));
            }
        }
    }

    #[test]
    fn steps_that_only_a_bound_decides_are_others_in_the_second_run() {
        for step in [None, Some(0.01)] {
            let max_step = if step.is_none() { Some(0.01) } else { None };
            let options = Options { method: Method::Dopri5, step, max_step, ..Options::tolerances(1e-2, 1e-2) };
            let first = run(&options);
            for second in second_runs(&options, &first, (0.0, 40.0), TaylorSeries::Costly) {
                let other = run(&Options { step_limit: 1_000_000, ..second.options });
                assert_ne!(other.steps, first.steps, "{}", second.words);
            }
        }
    }
}
