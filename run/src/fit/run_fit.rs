//! Parameters and starts for which runs of scenes come nearest to measured motions.

use super::levenberg_marquardt::{Minimum, Residuals, WithJacobian, minimize};
use super::uncertainty::uncertainty_of_jacobian;
use super::{
    Estimate, Fit, FitOptions, FittedQuantity, Unknown, check_given_names, check_number_of_values, has_pattern,
    huber_residual, noise_of_residuals,
};
use crate::equations_name::{EquationsName, find_equations_or_first};
use crate::{DerivativeInstants, Error, Overrides, Run, Scene};
use nalgebra::{DMatrix, DVector};
use std::ops::RangeInclusive;
use tripos_derive::model::TIME;
use tripos_derive::scene::MeasuredTable;

/// Largest number of steps of a search. Each step is a run with derivatives.
const STEPS: usize = 200;
/// Largest number of times that the noise of the measured quantities is estimated anew.
const ROUNDS: usize = 6;
/// Relative change of all noises below which they count as settled.
const SETTLED: f64 = 1e-3;
/// Parts of the measured instants to which runs are fitted one after the other. A run that is far from the data fits a
/// short part first, from which the phase of a longer part follows.
const GROWING: [f64; 4] = [0.1, 0.2, 0.4, 0.7];
/// Least number of instants of such a part, for each unknown.
const INSTANTS_FOR_EACH: usize = 4;
/// Weight of a relative change of an unknown in such a part, in spreads of the measured values. Short parts do not tell
/// every unknown.
const TOWARDS_GUESS: f64 = 0.3;
/// Fraction of the largest effect of an unknown below which a combination of unknowns counts as untold.
const TINY: f64 = 1e-7;

/// Experiment: a scene, and what was measured of its motion.
pub struct Experiment {
    /// Name of the experiment, such as that of its file.
    pub name: String,
    /// Scene of the experiment. Its start and parameters are the first guess.
    pub scene: Scene,
    /// Measured quantities: a column `t`, and columns with the names of coordinates, speeds or outputs of the scene, or
    /// with formulas for outputs.
    pub table: MeasuredTable,
}

/// Experiment that is ready for runs.
struct PreparedExperiment {
    /// Name of the experiment, such as that of its file.
    name: String,
    /// Scene that shows the measured quantities at the measured instants.
    scene: Scene,
    /// Measured instants, s.
    instants: Vec<f64>,
    /// Names of the measured quantities.
    names: Vec<String>,
    /// Values of each measured quantity, in the order of the instants.
    values: Vec<Vec<f64>>,
}

/// Unknown of a fit, as a column of the Jacobian.
struct Column {
    /// Index in the list of requested unknowns.
    unknown: usize,
    /// Index of the experiment to which it belongs. `None` if it belongs to all.
    experiment: Option<usize>,
}

/// Residuals of runs in standard deviations, as functions of the unknowns.
struct RunResiduals<'a> {
    /// Experiments that are run.
    experiments: &'a [PreparedExperiment],
    /// Requested unknowns.
    unknowns: &'a [Unknown],
    /// Columns of the Jacobian.
    columns: &'a [Column],
    /// Standard deviation of each measured quantity of each experiment.
    noise: Vec<Vec<f64>>,
    /// True if large residuals count linearly.
    is_robust: bool,
    /// Part of the measured instants that is used, up to 1.
    part: f64,
    /// Values near which the unknowns stay weakly; empty if the data alone count.
    guess: Vec<f64>,
    /// Settings of all runs.
    how: Overrides,
}

/// Fits parameters and numbers of the start to measured motions. Parameters belong to all experiments. Numbers of the
/// start belong to one experiment each. `how` overrides settings of all scenes.
///
/// # Errors
/// [`Error::Input`] if a table or a name is wrong. [`Error::Request`] if a run cannot be differentiated, or ends before
/// the last measured instant at the first guess.
pub fn fit_to_runs(
    experiments: Vec<Experiment>,
    unknowns: &[Unknown],
    options: &FitOptions,
    how: &Overrides,
) -> Result<Fit, Error> {
    let Some(first) = experiments.first() else {
        return Err(Error::request("there are no data", "give at least one table"));
    };
    if unknowns.is_empty() {
        return Err(Error::request("nothing is to be fitted", "name parameters or numbers of the start"));
    }
    let by = find_equations_or_first(first.scene.mechanism(), how.by.as_ref())?;
    let how = Overrides { by: Some(EquationsName::from(by.name().as_str())), ..how.clone() };
    let parameters: Vec<String> = first.scene.mechanism().parameters.iter().map(|p| p.name.clone()).collect();
    let prepared = experiments.into_iter().map(prepare_experiment).collect::<Result<Vec<_>, _>>()?;
    let measured: Vec<String> = prepared.iter().flat_map(|experiment| experiment.names.clone()).collect();
    check_given_names("measured quantity", options.noise.iter().map(|(name, _)| name), &measured)?;
    let columns: Vec<Column> = unknowns
        .iter()
        .enumerate()
        .flat_map(|(unknown, of)| -> Vec<Column> {
            if parameters.contains(&of.name) {
                return vec![Column { unknown, experiment: None }];
            }
            (0..prepared.len()).map(|at| Column { unknown, experiment: Some(at) }).collect()
        })
        .collect();
    let start = columns
        .iter()
        .map(|column| {
            let of = &prepared[column.experiment.unwrap_or(0)];
            of.scene.number(&unknowns[column.unknown].name).map_err(|error| {
                let (what, help) = error.message_and_advice();
                Error::request(what, help.unwrap_or_default())
            })
        })
        .collect::<Result<Vec<f64>, _>>()?;
    let given = |name: &String| options.noise.iter().find(|(known, _)| known == name).map(|(_, noise)| *noise);
    let noise = prepared.iter().map(|experiment| {
        let own = experiment.names.iter().zip(&experiment.values);
        own.map(|(name, values)| given(name).unwrap_or_else(|| spread_of_values(values))).collect()
    });
    let mut residuals = RunResiduals {
        experiments: &prepared,
        unknowns,
        columns: &columns,
        noise: noise.collect(),
        // The first search finds the size of the errors, without which no residual counts as large.
        is_robust: false,
        part: 1.0,
        guess: Vec::new(),
        how,
    };
    let bounds: Vec<_> = columns.iter().map(|column| unknowns[column.unknown].bounds.clone()).collect();
    let values = prepared.iter().map(|experiment| experiment.names.len() * experiment.instants.len()).sum::<usize>();
    check_number_of_values(values + residuals.prior_residuals(&start).len(), columns.len())?;
    let (near, mut steps) = fit_growing_parts(&mut residuals, &start, &bounds)?;
    let near = better_start(&mut residuals, &start, near)?;
    let mut found = minimize(&mut residuals, &near, &bounds, STEPS)?;
    steps += found.steps;
    for _ in 0..ROUNDS {
        let left = residuals.unscaled(&found)?;
        let rows: usize = left.iter().flatten().map(Vec::len).sum();
        let freedom = 1.0 - columns.len() as f64 / rows.max(1) as f64;
        let mut change = 0.0_f64;
        for (experiment, left) in left.iter().enumerate() {
            for (at, left) in left.iter().enumerate() {
                if given(&prepared[experiment].names[at]).is_none() {
                    let now = noise_of_residuals(left, freedom, options.is_robust);
                    change = change.max((residuals.noise[experiment][at] / now - 1.0).abs());
                    residuals.noise[experiment][at] = now;
                }
            }
        }
        if change <= SETTLED && residuals.is_robust == options.is_robust {
            break;
        }
        residuals.is_robust = options.is_robust;
        found = minimize(&mut residuals, &found.x, &bounds, STEPS)?;
        steps += found.steps;
    }
    let left = residuals.unscaled(&found)?;
    Ok(fit_of_minimum(&residuals, &found, &start, left, steps))
}

/// Fits growing parts of the measured instants, each from the result of the part before. Returns the last unknowns and
/// the number of steps.
///
/// # Errors
/// [`Error`] if a run cannot be made at the first guess, or if the search has to end.
fn fit_growing_parts(
    residuals: &mut RunResiduals<'_>,
    start: &[f64],
    bounds: &[RangeInclusive<f64>],
) -> Result<(Vec<f64>, usize), Error> {
    let (mut x, mut steps) = (start.to_vec(), 0);
    for part in GROWING {
        let instants = residuals.experiments.iter().map(|of| number_of_part(of.instants.len(), part)).min();
        if instants.is_none_or(|instants| instants < INSTANTS_FOR_EACH * start.len()) {
            continue;
        }
        residuals.part = part;
        residuals.guess.clone_from(&x);
        let found = minimize(residuals, &x, bounds, STEPS)?;
        x = found.x;
        steps += found.steps;
    }
    residuals.part = 1.0;
    residuals.guess.clear();
    Ok((x, steps))
}

/// Returns the given start or the result of the growing parts: the one with the smaller residuals at all instants.
///
/// # Errors
/// [`Error`] if the search has to end.
fn better_start(residuals: &mut RunResiduals<'_>, start: &[f64], near: Vec<f64>) -> Result<Vec<f64>, Error> {
    let mut cost = |x: &[f64]| {
        let found = residuals.residuals(x)?;
        Ok::<f64, Error>(found.map_or(f64::INFINITY, |found| found.norm_squared()))
    };
    Ok(if cost(start)? <= cost(&near)? { start.to_vec() } else { near })
}

/// Number of instants in a part of `count` instants.
fn number_of_part(count: usize, part: f64) -> usize {
    // The number lies between 0 and the count.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and the count")]
    let number = (part * count as f64).ceil() as usize;
    number.min(count)
}

/// Prepares an experiment: the scene shows the measured quantities at the measured instants.
///
/// # Errors
/// [`Error::Input`] if the table has no instants or no measured quantity, or if a column is no quantity of the scene.
/// [`Error::Request`] if the scene starts after the first instant.
fn prepare_experiment(experiment: Experiment) -> Result<PreparedExperiment, Error> {
    let Experiment { name, scene, table } = experiment;
    let instants = table.instants()?;
    let names: Vec<String> = table.names.iter().filter(|name| *name != TIME).cloned().collect();
    if names.is_empty() {
        let help = "give a column with the name of a coordinate, a speed or an output of the scene";
        return Err(Error::request(format!("`{name}` has no measured quantity"), help));
    }
    let values = names.iter().map(|name| table.column(name)).collect::<Result<Vec<_>, _>>()?;
    let from = scene.description().span.0;
    if instants[0] < from {
        let what = format!("`{name}` begins at {} s, before the scene begins at {from} s", instants[0]);
        return Err(Error::request(what, "let `span` of the scene begin with the first measured instant"));
    }
    if instants.len() < 2 {
        return Err(Error::request(format!("`{name}` has one instant"), "give at least two rows"));
    }
    for name in &names {
        if let Err(error) = scene.with_outputs_at(std::slice::from_ref(name), &instants) {
            let (why, help) = error.message_and_advice();
            let what = format!("the column `{name}` is no quantity of the scene: {why}");
            return Err(Error::Input(table.column_error(what, help.unwrap_or_default())));
        }
    }
    let scene = scene.with_outputs_at(&names, &instants)?;
    Ok(PreparedExperiment { name, scene, instants, names, values })
}

/// Spread of measured values, by which a quantity is scaled before its noise is known: the standard deviation, or the
/// size if all values are equal, or 1 if all are 0.
fn spread_of_values(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let off: Vec<f64> = values.iter().map(|x| x - mean).collect();
    let spread = super::root_mean_square(&off);
    if spread > 0.0 {
        spread
    } else if mean == 0.0 {
        1.0
    } else {
        mean.abs()
    }
}

impl RunResiduals<'_> {
    /// Scene of an experiment with the unknowns at the given values.
    ///
    /// # Errors
    /// [`Error`] if the scene cannot have the values.
    fn scene_at(&self, experiment: usize, x: &[f64]) -> Result<Scene, Error> {
        let own = self.columns.iter().zip(x).filter(|(column, _)| column.experiment.is_none_or(|of| of == experiment));
        let set: Vec<(String, f64)> = own.map(|(column, x)| (self.unknowns[column.unknown].name.clone(), *x)).collect();
        let scene = self.experiments[experiment].scene.with_numbers(&set)?;
        Ok(if self.part < 1.0 { scene.with_instants(self.instants(experiment)) } else { scene })
    }

    /// Instants of an experiment that are used.
    fn instants(&self, experiment: usize) -> &[f64] {
        let all = &self.experiments[experiment].instants;
        &all[..number_of_part(all.len(), self.part)]
    }

    /// Settings of the runs of an experiment, which last to its last used instant.
    fn how(&self, experiment: usize) -> Overrides {
        Overrides { until: self.instants(experiment).last().copied(), ..self.how.clone() }
    }

    /// Measured values less those of a run, for each measured quantity. `None` if the run ends before the last instant
    /// or has no value there.
    fn differences(&self, experiment: usize, run: &Run) -> Result<Option<Vec<Vec<f64>>>, Error> {
        let of = &self.experiments[experiment];
        if run.solution.t.len() < self.instants(experiment).len() {
            return Ok(None);
        }
        let mut list = Vec::new();
        for (name, values) in of.names.iter().zip(&of.values) {
            let shown = run.column_of_quantity(name)?;
            list.push(values.iter().zip(shown).map(|(measured, shown)| measured - shown).collect::<Vec<f64>>());
        }
        Ok(list.iter().flatten().all(|x| x.is_finite()).then_some(list))
    }

    /// Residuals of the priors of unknowns at the given values, with the index and the slope of each.
    fn prior_residuals(&self, x: &[f64]) -> Vec<(usize, f64, f64)> {
        let of = |(at, column): (usize, &Column)| {
            let (value, deviation) = self.unknowns[column.unknown].prior?;
            Some((at, (x[at] - value) / deviation, 1.0 / deviation))
        };
        let priors = self.columns.iter().enumerate().filter_map(of);
        let guesses = self.guess.iter().enumerate().map(|(at, guess)| {
            let weight = TOWARDS_GUESS / if *guess == 0.0 { 1.0 } else { guess.abs() };
            (at, weight * (x[at] - guess), weight)
        });
        priors.chain(guesses).collect()
    }

    /// Joins residuals in standard deviations, by Huber's loss if large ones count linearly, and those of the priors.
    fn joined(&self, differences: &[Vec<Vec<f64>>], x: &[f64]) -> Vec<f64> {
        let mut list = Vec::new();
        for (differences, noise) in differences.iter().zip(&self.noise) {
            for (differences, noise) in differences.iter().zip(noise) {
                list.extend(differences.iter().map(|r| self.loss_residual(-r / noise).0));
            }
        }
        list.extend(self.prior_residuals(x).into_iter().map(|(_, residual, _)| residual));
        list
    }

    /// Residual whose square is the loss of a residual in standard deviations, with its derivative.
    fn loss_residual(&self, r: f64) -> (f64, f64) {
        if self.is_robust { huber_residual(r) } else { (r, 1.0) }
    }

    /// Measured values less those of the runs at the minimum, by experiment and quantity.
    fn unscaled(&self, found: &Minimum) -> Result<Vec<Vec<Vec<f64>>>, Error> {
        let mut list = Vec::new();
        for experiment in 0..self.experiments.len() {
            let run = self.scene_at(experiment, &found.x)?.simulate(&self.how(experiment))?;
            let differences = self.differences(experiment, &run)?;
            list.push(differences.ok_or_else(|| Error::Stopped(run.ending.clone()))?);
        }
        Ok(list)
    }
}

impl Residuals for RunResiduals<'_> {
    fn residuals(&mut self, x: &[f64]) -> Result<Option<DVector<f64>>, Error> {
        let mut all = Vec::new();
        for experiment in 0..self.experiments.len() {
            // Values that the scene cannot have, and runs that cannot be made, ask for a shorter step.
            let run = match self.scene_at(experiment, x).and_then(|scene| scene.simulate(&self.how(experiment))) {
                Ok(run) => run,
                Err(Error::Interrupted) => return Err(Error::Interrupted),
                Err(_) => return Ok(None),
            };
            let Some(differences) = self.differences(experiment, &run)? else { return Ok(None) };
            all.push(differences);
        }
        Ok(Some(DVector::from_vec(self.joined(&all, x))))
    }

    fn with_jacobian(&mut self, x: &[f64]) -> Result<WithJacobian, Error> {
        let mut all = Vec::new();
        let mut rows: Vec<Vec<f64>> = Vec::new();
        for experiment in 0..self.experiments.len() {
            let scene = self.scene_at(experiment, x)?;
            let own: Vec<usize> = (0..self.columns.len())
                .filter(|at| self.columns[*at].experiment.is_none_or(|of| of == experiment))
                .collect();
            let names: Vec<&str> =
                own.iter().map(|at| self.unknowns[self.columns[*at].unknown].name.as_str()).collect();
            let found = scene.sensitivities(&names, DerivativeInstants::Samples, &self.how(experiment))?;
            let of = &self.experiments[experiment];
            let Some(differences) = self.differences(experiment, &found.run)? else {
                let what = format!("the run of `{}` does not give every measured value: {}", of.name, found.run.ending);
                let help = "leave later rows out, or start the search nearer to the measured motion";
                return Err(Error::request(what, help));
            };
            for (at, name) in of.names.iter().enumerate() {
                let shown = found.names.iter().position(|known| known == name);
                let shown = shown.ok_or_else(|| Error::Stopped(format!("`{name}` has no derivatives")))?;
                let noise = self.noise[experiment][at];
                for (sample, difference) in differences[at].iter().enumerate() {
                    let slope = self.loss_residual(-difference / noise).1 / noise;
                    let mut row = vec![0.0; self.columns.len()];
                    for (k, column) in own.iter().enumerate() {
                        row[*column] = slope * found.samples[k][sample][shown];
                    }
                    rows.push(row);
                }
            }
            all.push(differences);
        }
        for (at, _, slope) in self.prior_residuals(x) {
            let mut row = vec![0.0; self.columns.len()];
            row[at] = slope;
            rows.push(row);
        }
        let jacobian = DMatrix::from_fn(rows.len(), self.columns.len(), |i, j| rows[i][j]);
        if jacobian.iter().any(|x| !x.is_finite()) {
            let what = "a derivative of the measured quantities has no value".to_owned();
            return Err(Error::request(what, "start the search elsewhere, or fit other numbers"));
        }
        Ok((DVector::from_vec(self.joined(&all, x)), jacobian))
    }
}

/// Collects the result of a fit from the minimum of the residuals.
fn fit_of_minimum(
    residuals: &RunResiduals<'_>,
    found: &Minimum,
    start: &[f64],
    left: Vec<Vec<Vec<f64>>>,
    steps: usize,
) -> Fit {
    let columns = residuals.columns;
    let is_at_bound = |at: usize| {
        let bounds = &residuals.unknowns[columns[at].unknown].bounds;
        found.x[at] <= *bounds.start() || found.x[at] >= *bounds.end()
    };
    // Unknowns at a bound count as known, since they do not follow the data.
    let free: Vec<usize> = (0..columns.len()).filter(|at| !is_at_bound(*at)).collect();
    let size = |at: &usize| if found.x[*at] == 0.0 { 1.0 } else { found.x[*at].abs() };
    let sizes: Vec<f64> = free.iter().map(size).collect();
    let uncertainty = uncertainty_of_jacobian(&found.jacobian.select_columns(&free), &sizes, TINY);
    let mut errors = vec![None; columns.len()];
    let mut correlations = vec![vec![0.0; columns.len()]; columns.len()];
    for (i, at) in free.iter().enumerate() {
        errors[*at] = uncertainty.errors[i];
        for (j, other) in free.iter().enumerate() {
            correlations[*at][*other] = uncertainty.correlations[i][j];
        }
    }
    let estimates = columns.iter().enumerate().map(|(at, column)| {
        let name = residuals.unknowns[column.unknown].name.clone();
        let scene = &residuals.experiments[column.experiment.unwrap_or(0)].scene;
        Estimate {
            unit: scene.unit_of_number(&name),
            experiment: column.experiment.filter(|_| residuals.experiments.len() > 1),
            name,
            value: found.x[at],
            error: errors[at],
            stated: Some(start[at]),
            is_at_bound: is_at_bound(at),
        }
    });
    let mut quantities = Vec::new();
    for (experiment, (of, left)) in residuals.experiments.iter().zip(left).enumerate() {
        for (at, (name, left)) in of.names.iter().zip(left).enumerate() {
            quantities.push(FittedQuantity {
                name: name.clone(),
                experiment,
                instants: of.instants.clone(),
                has_pattern: has_pattern(&left),
                residuals: left,
                noise: residuals.noise[experiment][at],
            });
        }
    }
    let untold = uncertainty.untold.iter().map(|direction| {
        let parts = direction.iter().enumerate().filter(|(_, rate)| **rate != 0.0);
        parts.map(|(i, rate)| (free[i], *rate)).collect()
    });
    Fit {
        estimates: estimates.collect(),
        quantities,
        correlations,
        untold: untold.collect(),
        steps,
        has_converged: found.has_converged,
    }
}
