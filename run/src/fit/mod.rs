//! Parameters from measurements: least squares on measured forces, or on measured motions.
//!
//! - [`excitation`]: motions within limits, from which base parameters can be estimated well.
//! - [`force_fit`]: the generalized forces that a motion needs are linear in base parameters
//!   ([`tripos_derive::identify`]). Measured motions and forces give them by linear least squares.
//! - [`possible_inertia`]: inertial parameters that real bodies can have, nearest to measured forces.
//! - [`run_fit`]: parameters and starts for which runs of scenes come nearest to measured motions. The derivatives of
//!   the runs are exact ([`crate::studies::sensitivity`]).
//!
//! Standard errors are those of least squares with independent errors of each measured quantity, of which the size is
//! estimated from the residuals (Y. Bard, *Nonlinear Parameter Estimation* (1974), § 7.5).

pub mod excitation;
pub mod force_fit;
mod levenberg_marquardt;
mod low_pass;
pub mod motion_tables;
pub mod possible_inertia;
pub mod run_fit;
mod uncertainty;

use crate::Error;
use std::ops::RangeInclusive;
use tripos_derive::diagnostic::nearest_name_advice;

/// Result of a fit: estimates with their uncertainty, and the residuals.
#[derive(Clone, Debug)]
pub struct Fit {
    /// Estimates of the unknowns.
    pub estimates: Vec<Estimate>,
    /// Measured quantities, with their residuals.
    pub quantities: Vec<FittedQuantity>,
    /// Correlation of each pair of estimates, from −1 to 1; 0 for undetermined unknowns.
    pub correlations: Vec<Vec<f64>>,
    /// Directions in which unknowns can move without a change of any residual, as pairs (index of the unknown, rate).
    pub untold: Vec<Vec<(usize, f64)>>,
    /// Number of steps of the search; 0 if the fit is linear.
    pub steps: usize,
    /// True if the search came to an end by itself. False if it used up its steps.
    pub has_converged: bool,
}

/// Estimate of an unknown.
#[derive(Clone, Debug)]
pub struct Estimate {
    /// Name of the unknown: a parameter, a number of the start, or the inertial parameter that names a base parameter.
    pub name: String,
    /// Index of the experiment to which the unknown belongs. `None` if it belongs to all.
    pub experiment: Option<usize>,
    /// Unit of the unknown in SI; empty if it has none or if it is not known.
    pub unit: String,
    /// Estimated value.
    pub value: f64,
    /// Standard error of the value. `None` if the data do not determine the unknown, or if it is at a bound.
    pub error: Option<f64>,
    /// Value in the model or the scene, from which a search starts. `None` if there is none.
    pub stated: Option<f64>,
    /// True if the estimate is at one of its bounds.
    pub is_at_bound: bool,
}

/// Measured quantity of an experiment, with its residuals.
#[derive(Clone, Debug)]
pub struct FittedQuantity {
    /// Name of the quantity.
    pub name: String,
    /// Index of the experiment.
    pub experiment: usize,
    /// Instants of the measurements, s; empty if the table has none.
    pub instants: Vec<f64>,
    /// Residuals: measured value less the value of the model, in the unit of the quantity.
    pub residuals: Vec<f64>,
    /// Standard deviation of the measured values, in the unit of the quantity: the given one, or the one that the
    /// residuals show.
    pub noise: f64,
    /// True if neighbouring residuals are alike, so that the model lacks something, or the search ended at a wrong
    /// minimum. Standard errors are then too small.
    pub has_pattern: bool,
}

impl FittedQuantity {
    /// Root of the mean square of the residuals.
    #[must_use]
    pub fn root_mean_square(&self) -> f64 {
        root_mean_square(&self.residuals)
    }
}

/// Options of a fit.
#[derive(Clone, Debug, Default)]
pub struct FitOptions {
    /// True if large residuals count linearly, by Huber's loss, so that outliers move the estimates little.
    pub is_robust: bool,
    /// Names of measured quantities with their known standard deviations. The others are estimated from the residuals.
    pub noise: Vec<(String, f64)>,
    /// Number of neighbouring rows that share an error, such as after a low-pass filter
    /// ([`motion_tables::MotionTable::rows_for_each_error`]). Numbers below 1 count as 1. Standard errors grow with its
    /// root.
    pub rows_for_each_error: f64,
}

/// Unknown of a fit.
#[derive(Clone, Debug)]
pub struct Unknown {
    /// Name of the unknown.
    pub name: String,
    /// Least and largest value of the unknown.
    pub bounds: RangeInclusive<f64>,
    /// Value that the unknown probably has, with its standard deviation. `None` if nothing is known beforehand.
    pub prior: Option<(f64, f64)>,
}

/// Residual, in standard deviations, above which Huber's loss is linear. It costs 5 % of the precision if all errors
/// are normal (P. J. Huber, *Robust Statistics* (1981), § 4.5).
const HUBER: f64 = 1.345;

/// Residual whose square is Huber's loss of a residual in standard deviations, with its derivative.
fn huber_residual(r: f64) -> (f64, f64) {
    if r.abs() <= HUBER {
        return (r, 1.0);
    }
    let root = (2.0 * HUBER * r.abs() - HUBER * HUBER).sqrt();
    (root.copysign(r), HUBER / root)
}

/// Correlation of neighbouring residuals above which they have a pattern, and the number of standard deviations that it
/// has to exceed.
const ALIKE: (f64, f64) = (0.3, 4.0);

/// True if neighbouring residuals are alike. Independent errors have a correlation of standard deviation 1/√n.
fn has_pattern(residuals: &[f64]) -> bool {
    let mean = residuals.iter().sum::<f64>() / residuals.len().max(1) as f64;
    let square: f64 = residuals.iter().map(|x| (x - mean).powi(2)).sum();
    let products: f64 = residuals.windows(2).map(|pair| (pair[0] - mean) * (pair[1] - mean)).sum();
    let least = ALIKE.0.max(ALIKE.1 / (residuals.len().max(1) as f64).sqrt());
    square > 0.0 && products / square > least
}

/// Checks that there are more measured values than unknowns.
///
/// # Errors
/// [`Error::Request`] if there are not.
fn check_number_of_values(values: usize, unknowns: usize) -> Result<(), Error> {
    if values > unknowns {
        return Ok(());
    }
    let what = format!("there are {values} measured values for {unknowns} unknowns");
    Err(Error::request(what, "give more rows than unknowns, or find fewer unknowns"))
}

/// Root of the mean square of numbers; 0 if there are none.
fn root_mean_square(list: &[f64]) -> f64 {
    let sum: f64 = list.iter().map(|x| x * x).sum();
    (sum / list.len().max(1) as f64).sqrt()
}

/// Standard deviation of errors from residuals. `freedom` is the share of residuals that the unknowns leave free, from
/// 0 to 1. With `is_robust`, it is 1.4826 times the median of the absolute residuals, which outliers move little.
fn noise_of_residuals(residuals: &[f64], freedom: f64, is_robust: bool) -> f64 {
    let least = residuals.iter().fold(0.0_f64, |most, x| most.max(x.abs())) * f64::EPSILON;
    let spread = if is_robust {
        let mut sizes: Vec<f64> = residuals.iter().map(|x| x.abs()).collect();
        sizes.sort_by(f64::total_cmp);
        1.4826 * sizes.get(sizes.len() / 2).copied().unwrap_or(0.0)
    } else {
        root_mean_square(residuals)
    };
    (spread / freedom.max(f64::EPSILON).sqrt()).max(least).max(f64::MIN_POSITIVE)
}

/// Checks that every name of `given` is among the names `known`. `what` says what has the names.
///
/// # Errors
/// [`Error::Request`] with the first unknown name.
fn check_given_names<'a>(
    what: &str,
    given: impl IntoIterator<Item = &'a String>,
    known: &[String],
) -> Result<(), Error> {
    match given.into_iter().find(|name| !known.contains(name)) {
        Some(name) => {
            let help = nearest_name_advice(name, known.iter().map(String::as_str));
            Err(Error::request(format!("there is no {what} `{name}`"), help))
        }
        None => Ok(()),
    }
}
