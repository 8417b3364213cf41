//! Base parameters from measured motions and forces, by linear least squares.
//!
//! Each instant and generalized speed gives an equation Σ Y π = τ − rest with the regressor Y of the base parameters π.
//! The equations of a speed have errors of the same size, which is estimated from their residuals (M. Gautier, "Dynamic
//! identification of robots with power model", IEEE Int. Conf. Robotics and Automation (1997) 1922–1927).

use super::uncertainty::{LinearSolution, solve_linear_least_squares};
use super::{
    Estimate, Fit, FitOptions, FittedQuantity, HUBER, check_given_names, check_number_of_values, has_pattern,
    noise_of_residuals, root_mean_square,
};
use crate::studies::identification::{base_parameter_values, regressor_tape};
use crate::{Error, Mechanism};
use nalgebra::{DMatrix, DVector};
use tripos_derive::algebra::value::tape::{Numeric, Tape};
use tripos_derive::identify::{BaseParameter, Identification};
use tripos_derive::model::Parameter;
use tripos_traits::{DoubleDouble, Real};

/// Largest number of times that the noise of the forces is estimated anew.
const ROUNDS: usize = 20;
/// Relative change of all noises below which they count as settled.
const SETTLED: f64 = 1e-6;
/// Fraction of the largest effect below which a combination of base parameters counts as untold.
const TINY: f64 = 1e-8;
/// Number of parts of the data for the cross-validation.
const PARTS: usize = 5;

/// Measured motion of a mechanism at an instant, with the forces along the generalized speeds.
#[derive(Clone, Debug)]
pub struct MeasuredMotion {
    /// Instant, s; `None` if it is not stated.
    pub t: Option<f64>,
    /// Values of the parameters, in which measured inputs stand, in the order of the model.
    pub p: Vec<f64>,
    /// Generalized coordinates.
    pub q: Vec<f64>,
    /// Generalized speeds.
    pub u: Vec<f64>,
    /// Rates of the generalized speeds.
    pub rates: Vec<f64>,
    /// Generalized force along each speed that acts beside the loads of the model.
    pub forces: Vec<f64>,
}

/// Linear equations of the base parameters: matrix · π = side, with a row for each instant and speed.
pub(super) struct ForceEquations {
    /// Factors of the base parameters.
    pub matrix: DMatrix<f64>,
    /// Known sides: the measured force less the known part.
    pub side: DVector<f64>,
    /// Number of generalized speeds. Row `at` belongs to the speed `at` modulo this number.
    pub speeds: usize,
}

/// Fit of base parameters to measured forces.
pub struct ForceFit {
    /// Estimates of the base parameters with their uncertainty, and the residuals of the forces.
    pub fit: Fit,
    /// Root of the mean square of the residuals of instants that were left out of the fit, in standard deviations. The
    /// instants are left out in five parts, one after the other. `None` if a part leaves a base parameter undetermined.
    pub unseen: Option<f64>,
    /// Weight of each row of the equations: the reciprocal of its standard deviation, less for outliers.
    pub(super) weights: Vec<f64>,
    /// Sum of the squares of the weighted residuals.
    pub(super) sum_of_squares: f64,
}

impl ForceEquations {
    /// Evaluates the equations at all instants of all experiments, for base parameters or for any columns of the
    /// regressor.
    ///
    /// # Errors
    /// [`Error::Request`] if a column contains a symbol without a value. [`Error::Stopped`] if a column has no finite
    /// value at an instant.
    pub(super) fn new(
        model: &Mechanism,
        found: &Identification,
        base: &[BaseParameter],
        motions: &[&MeasuredMotion],
    ) -> Result<Self, Error> {
        let speeds = model.speeds.len();
        let tape: Tape<f64> = regressor_tape(model, found, base)?;
        let columns = base.len();
        let mut matrix = DMatrix::zeros(motions.len() * speeds, columns);
        let mut side = DVector::zeros(motions.len() * speeds);
        for (at, moving) in motions.iter().enumerate() {
            let values = tape.evaluate(&[&moving.p[..], &moving.q, &moving.u, &moving.rates].concat());
            if values.iter().any(|x| !x.is_finite()) {
                return Err(Error::Stopped(format!("the regressor has no value in row {} of the data", at + 1)));
            }
            for speed in 0..speeds {
                let row = at * speeds + speed;
                for column in 0..columns {
                    matrix[(row, column)] = values[column * speeds + speed];
                }
                side[row] = moving.forces[speed] - values[columns * speeds + speed];
            }
        }
        Ok(Self { matrix, side, speeds })
    }

    /// Equations of the given rows alone, each multiplied by its weight.
    pub(super) fn weighted(&self, rows: &[usize], weights: &[f64]) -> (DMatrix<f64>, DVector<f64>) {
        let matrix =
            DMatrix::from_fn(rows.len(), self.matrix.ncols(), |i, j| self.matrix[(rows[i], j)] * weights[rows[i]]);
        let side = DVector::from_iterator(rows.len(), rows.iter().map(|row| self.side[*row] * weights[*row]));
        (matrix, side)
    }

    /// Residuals of all rows: the measured force less the force of the base parameters.
    fn residuals(&self, x: &DVector<f64>) -> DVector<f64> {
        &self.side - &self.matrix * x
    }

    /// Residuals of the rows of a speed.
    fn of_speed<'a>(&self, residuals: &'a DVector<f64>, speed: usize) -> impl Iterator<Item = f64> + 'a {
        residuals.iter().skip(speed).step_by(self.speeds.max(1)).copied()
    }
}

/// Fits base parameters to measured motions and forces. There is a list of motions for each experiment. Other
/// parameters have the values that the motions state.
///
/// # Errors
/// [`Error::Request`] if there are no data, or if a name of a noise is unknown; otherwise the errors of the regressor.
pub fn fit_to_forces(
    model: &Mechanism,
    found: &Identification,
    experiments: &[Vec<MeasuredMotion>],
    options: &FitOptions,
) -> Result<ForceFit, Error> {
    let motions: Vec<&MeasuredMotion> = experiments.iter().flatten().collect();
    let speeds = model.speeds.len();
    if motions.is_empty() || speeds == 0 {
        return Err(Error::request("there are no measured forces", "give a table with at least one row"));
    }
    let names: Vec<String> = model.speeds.iter().map(|speed| format!("force({})", speed.name)).collect();
    check_given_names("measured force", options.noise.iter().map(|(name, _)| name), &names)?;
    let given = |speed: usize| options.noise.iter().find(|(name, _)| *name == names[speed]).map(|(_, noise)| *noise);
    let equations = ForceEquations::new(model, found, &found.base, &motions)?;
    check_number_of_values(equations.side.len(), equations.matrix.ncols())?;
    if equations.side.iter().all(|side| *side == 0.0) {
        let help = "give columns for inputs, or for forces such as `force(u1)`";
        return Err(Error::request("all measured forces are 0, which tells no parameter", help));
    }
    if !(equations.side.norm_squared().is_finite() && equations.matrix.norm_squared().is_finite()) {
        let help = "look for measured values that are far off";
        return Err(Error::request("the squares of the measured values are too large for numbers", help));
    }
    let stated = stated_base_parameters(model, found)?;
    let guess = DVector::from_iterator(stated.len(), stated.iter().map(|value| value.unwrap_or(0.0)));
    let rows: Vec<usize> = (0..equations.side.len()).collect();
    let freedom = 1.0 - equations.matrix.ncols() as f64 / rows.len().max(1) as f64;
    let mut noise: Vec<f64> = (0..speeds)
        .map(|speed| {
            let own: Vec<f64> = equations.of_speed(&equations.side, speed).collect();
            given(speed).unwrap_or_else(|| Some(root_mean_square(&own)).filter(|x| *x > 0.0).unwrap_or(1.0))
        })
        .collect();
    let mut weights: Vec<f64> = rows.iter().map(|row| 1.0 / noise[row % speeds]).collect();
    let mut solution = solve_rows(&equations, &rows, &weights, &guess);
    let mut residuals = equations.residuals(&solution.x);
    for _ in 0..ROUNDS {
        let mut change = 0.0_f64;
        for (speed, noise) in noise.iter_mut().enumerate() {
            let own: Vec<f64> = equations.of_speed(&residuals, speed).collect();
            let now = given(speed).unwrap_or_else(|| noise_of_residuals(&own, freedom, options.is_robust));
            change = change.max((*noise / now - 1.0).abs());
            *noise = now;
        }
        for row in &rows {
            let in_deviations = residuals[*row].abs() / noise[row % speeds];
            let trust = if options.is_robust && in_deviations > HUBER { HUBER / in_deviations } else { 1.0 };
            weights[*row] = trust.sqrt() / noise[row % speeds];
        }
        solution = solve_rows(&equations, &rows, &weights, &guess);
        residuals = equations.residuals(&solution.x);
        if change <= SETTLED {
            break;
        }
    }
    let unseen = unseen_residuals(&equations, motions.len(), (&weights, &noise), &guess);
    let sum_of_squares = residuals.iter().zip(&weights).map(|(residual, weight)| (residual * weight).powi(2)).sum();
    let rows_for_each_error = options.rows_for_each_error.max(1.0);
    for error in solution.uncertainty.errors.iter_mut().flatten() {
        *error *= rows_for_each_error.sqrt();
    }
    let result =
        ForceResult { residuals: &residuals, noise: &noise, names: &names, stated: &stated, rows_for_each_error };
    let fit = fit_of_solution(found, experiments, &solution, &result);
    Ok(ForceFit { fit, unseen, weights, sum_of_squares })
}

/// Solves the given rows for the base parameters. Combinations that the rows do not tell are near the guess.
fn solve_rows(equations: &ForceEquations, rows: &[usize], weights: &[f64], guess: &DVector<f64>) -> LinearSolution {
    let (matrix, side) = equations.weighted(rows, weights);
    solve_linear_least_squares(&matrix, &side, guess, TINY)
}

/// Root of the mean square of the residuals of instants that were left out, in standard deviations. `None` if the rest
/// leaves a base parameter undetermined.
fn unseen_residuals(
    equations: &ForceEquations,
    instants: usize,
    (weights, noise): (&[f64], &[f64]),
    guess: &DVector<f64>,
) -> Option<f64> {
    let speeds = equations.speeds;
    let part_of = |row: &usize| (row / speeds) * PARTS / instants.max(1);
    let mut list = Vec::new();
    for part in 0..PARTS.min(instants) {
        let (out, rest): (Vec<usize>, Vec<usize>) = (0..instants * speeds).partition(|row| part_of(row) == part);
        let solution = solve_rows(equations, &rest, weights, guess);
        if !solution.uncertainty.untold.is_empty() {
            return None;
        }
        let residuals = equations.residuals(&solution.x);
        list.extend(out.iter().map(|row| residuals[*row] / noise[row % speeds]));
    }
    Some(root_mean_square(&list))
}

/// Values of the base parameters in the model, at the default values of its parameters. `None` for those without a
/// value.
///
/// # Errors
/// [`Error::Request`] if a formula of a base parameter contains a symbol without a value.
fn stated_base_parameters(model: &Mechanism, found: &Identification) -> Result<Vec<Option<f64>>, Error> {
    let value = |p: &Parameter| match &p.value {
        Some(value) => Some(DoubleDouble::from_rational(value)),
        None => p.is_input.then(|| DoubleDouble::from(0.0)),
    };
    let Some(defaults) = model.parameters.iter().map(value).collect::<Option<Vec<DoubleDouble>>>() else {
        return Ok(vec![None; found.base.len()]);
    };
    let values = base_parameter_values(model, found, &defaults)?;
    Ok(values.into_iter().map(|value| value.map(Real::to_f64)).collect())
}

/// Parts of the result of a fit of base parameters.
struct ForceResult<'a> {
    /// Residuals of all rows: the measured force less the force of the base parameters.
    residuals: &'a DVector<f64>,
    /// Standard deviation of the force along each speed.
    noise: &'a [f64],
    /// Name of the force along each speed.
    names: &'a [String],
    /// Values of the base parameters in the model.
    stated: &'a [Option<f64>],
    /// Number of neighbouring rows that share an error.
    rows_for_each_error: f64,
}

/// Collects the result of a fit of base parameters.
fn fit_of_solution(
    found: &Identification,
    experiments: &[Vec<MeasuredMotion>],
    solution: &LinearSolution,
    result: &ForceResult<'_>,
) -> Fit {
    let ForceResult { residuals, noise, names, stated, rows_for_each_error } = *result;
    let speeds = names.len();
    let estimates = found.base.iter().enumerate().map(|(at, base)| Estimate {
        name: found.regressor.columns[base.column].name.clone(),
        experiment: None,
        unit: found.regressor.columns[base.column].unit.to_string(),
        value: solution.x[at],
        error: solution.uncertainty.errors[at],
        stated: stated[at],
        is_at_bound: false,
    });
    let mut quantities = Vec::new();
    let mut first = 0;
    for (experiment, motions) in experiments.iter().enumerate() {
        for (speed, name) in names.iter().enumerate() {
            let own: Vec<f64> = (0..motions.len()).map(|at| residuals[(first + at) * speeds + speed]).collect();
            quantities.push(FittedQuantity {
                name: name.clone(),
                experiment,
                instants: motions.iter().filter_map(|moving| moving.t).collect(),
                noise: noise[speed],
                has_pattern: rows_for_each_error <= 1.0 && has_pattern(&own),
                residuals: own,
            });
        }
        first += motions.len();
    }
    let untold = solution.uncertainty.untold.iter().map(|direction| {
        direction.iter().enumerate().filter(|(_, rate)| **rate != 0.0).map(|(at, rate)| (at, *rate)).collect()
    });
    Fit {
        estimates: estimates.collect(),
        quantities,
        correlations: solution.uncertainty.correlations.clone(),
        untold: untold.collect(),
        steps: 0,
        has_converged: true,
    }
}
