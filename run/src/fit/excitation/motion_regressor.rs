//! Regressor of the base parameters along a motion.

use super::information::{Information, independent_columns};
use crate::fit::check_given_names;
use crate::fit::motion_tables::default_values;
use crate::state_arrays::{Rows, StateRows};
use crate::studies::identification::StateRegressor;
use crate::{Error, Mechanism};
use nalgebra::DMatrix;
use tripos_derive::identify::Identification;
use tripos_derive::scene::MotionSample;
use tripos_traits::Real;

/// Coordinates, speeds and their rates at several instants, one instant after the other.
pub(super) struct States {
    /// Coordinates.
    pub q: Vec<f64>,
    /// Generalized speeds.
    pub u: Vec<f64>,
    /// Rates of the generalized speeds.
    pub rates: Vec<f64>,
}

/// Regressor of the base parameters, with the standard deviations of the forces.
pub(super) struct MotionRegressor {
    /// Regressor at arrays of states.
    regressor: StateRegressor,
    /// Default values of the parameters.
    pub p: Vec<f64>,
    /// Number of coordinates.
    coordinates: usize,
    /// Number of base parameters.
    pub columns: usize,
    /// Reciprocal of the standard deviation of the force along each speed.
    weights: Vec<f64>,
}

impl MotionRegressor {
    /// Compiles the regressor of a mechanism. `noise` has names of forces, such as `force(u1)`, with their standard
    /// deviations in SI units; 1 for the others.
    ///
    /// # Errors
    /// [`Error::Request`] if a name of a force is unknown, if a parameter has no value, or if there are no base
    /// parameters.
    pub fn new(model: &Mechanism, found: &Identification, noise: &[(String, f64)]) -> Result<Self, Error> {
        let names: Vec<String> = model.speeds.iter().map(|speed| format!("force({})", speed.name)).collect();
        check_given_names("force", noise.iter().map(|(name, _)| name), &names)?;
        let deviation = |name: &String| noise.iter().find(|(known, _)| known == name).map_or(1.0, |(_, x)| *x);
        if found.base.is_empty() {
            return Err(Error::request("the model has no base parameters", "give its bodies masses"));
        }
        Ok(Self {
            regressor: StateRegressor::new(model, found)?,
            p: default_values(model)?,
            coordinates: model.coordinates.len(),
            columns: found.base.len(),
            weights: names.iter().map(|name| 1.0 / deviation(name)).collect(),
        })
    }

    /// Regressor at states, with each row divided by the standard deviation of its force: a row for each state and
    /// speed, a column for each base parameter.
    ///
    /// # Errors
    /// [`Error::Stopped`] if the regressor has no finite value at a state.
    pub fn at(&self, states: &States) -> Result<DMatrix<f64>, Error> {
        let speeds = self.weights.len();
        let count = states.u.len() / speeds.max(1);
        let rows = StateRows {
            count,
            q: Rows::each(&states.q, self.coordinates),
            v: Rows::each(&states.u, speeds),
            v_dot: Rows::each(&states.rates, speeds),
        };
        let width = self.columns + 1;
        let mut values = vec![0.0; count * speeds * width];
        self.regressor.evaluate(&self.p, rows, &mut values);
        let matrix = DMatrix::from_fn(count * speeds, self.columns, |row, column| {
            values[row * width + column] * self.weights[row % speeds]
        });
        if matrix.iter().all(|x| x.is_finite()) {
            return Ok(matrix);
        }
        let why = "the regressor has no value in a pose of a motion within the limits: narrow the limits by `--limit`";
        Err(Error::Stopped(why.to_owned()))
    }
}

/// Information that forces at given samples of a motion give about base parameters. The counted columns are those that
/// do not depend on others at these samples. `noise` has names of forces with their standard deviations.
///
/// # Errors
/// The errors of the regressor: [`Error::Request`] for unknown names and missing values, [`Error::Stopped`] if it has
/// no finite value at a sample.
pub fn information_of_samples(
    model: &Mechanism,
    found: &Identification,
    samples: &[MotionSample],
    noise: &[(String, f64)],
) -> Result<Information, Error> {
    let regressor = MotionRegressor::new(model, found, noise)?;
    let states = States {
        q: samples.iter().flat_map(|sample| &sample.q).map(|x| x.to_f64()).collect(),
        u: samples.iter().flat_map(|sample| &sample.u).map(|x| x.to_f64()).collect(),
        rates: samples.iter().flat_map(|sample| &sample.rates).map(|x| x.to_f64()).collect(),
    };
    let weighted = regressor.at(&states)?;
    let counted = independent_columns(&weighted);
    Ok(Information::new(&weighted, &counted))
}
