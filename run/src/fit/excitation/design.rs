//! Search for the motion that determines base parameters best.

use super::candidate::{CandidateSpace, TOO_LARGE};
use super::evolution_strategy::{BestPoint, RandomNumbers, minimize};
use super::fourier_series::{FINE, FourierSeries, PhaseTable, StartConditions};
use super::information::{Information, independent_columns, log_determinant};
use super::motion_limits::MotionLimits;
use super::motion_regressor::{MotionRegressor, States};
use super::{Excitation, ExcitationOptions, Extremes};
use crate::{Error, Mechanism};
use nalgebra::DMatrix;
use tripos_derive::diagnostic::nearest_name_advice;
use tripos_derive::identify::Identification;
use tripos_derive::scene::MotionSample;

/// Number of evaluations of a search for each unknown, at most.
const EVALUATIONS: usize = 300;
/// Number of random motions of which the best one starts a search.
const DRAWS: usize = 20;
/// Number of random motions that show which columns of the regressor are independent.
const RICH: usize = 8;
/// Standard deviation of the unknowns at the start of a search.
const SPREAD: f64 = 0.4;
/// Value of motions that violate a condition of the domain, to which the violation is added.
const VIOLATED: f64 = 1e9;
/// Number of halvings by which the largest motion is found that keeps conditions of the domain.
const HALVINGS: usize = 12;
/// Number of times that a motion is made smaller until rounding and fine grids keep all limits.
const SHRINKINGS: usize = 40;
/// First relative reduction of such a motion.
const REDUCTION: f64 = 1e-6;

/// Designs a motion from which the base parameters `found` can be estimated well.
///
/// # Errors
/// [`Error::Request`] if the mechanism has loops or other constraints, or speeds that are no rates of coordinates; if a
/// limit or an option is wrong; or if no motion within the limits determines a base parameter. [`Error::Stopped`] if
/// the regressor has no value within the limits. [`Error::Interrupted`] if the observer of the model ends the search.
pub fn design_excitation(
    model: &Mechanism,
    found: &Identification,
    options: &ExcitationOptions,
) -> Result<Excitation, Error> {
    check_options(options)?;
    let design = Design::new(model, found, options)?;
    let counted = design.counted_columns(options.seed)?;
    let (series, tried) = design.search(&counted, options)?;
    let series = design.verified(&series)?;
    let information = Information::new(&design.weighted_regressor(&series)?, &counted);
    let conditions = design.least_values(&series, &design.fine_table());
    Ok(Excitation {
        samples: design.samples(&series),
        extremes: design.extremes(&series),
        conditions: design.limits.conditions.iter().map(|(name, _)| name.clone()).zip(conditions).collect(),
        unchecked: design.limits.unchecked.clone(),
        information,
        series,
        tried,
    })
}

/// Checks the numbers of the options.
///
/// # Errors
/// [`Error::Request`] for the first number that is wrong.
fn check_options(options: &ExcitationOptions) -> Result<(), Error> {
    let ExcitationOptions { period, harmonics, samples, starts, .. } = *options;
    if !(period.is_finite() && period > 0.0) {
        return Err(Error::request(format!("the period {period} s is not above 0"), "give a period above 0 s"));
    }
    let least = if options.is_at_rest { 2 } else { 1 };
    if !(least..=50).contains(&harmonics) {
        let why = if options.is_at_rest { " for a motion that starts at rest" } else { "" };
        let help = format!("give from {least} to 50 harmonics{why}");
        return Err(Error::request(format!("{harmonics} harmonics are not possible"), help));
    }
    if !(2 * harmonics + 2..=10_000).contains(&samples) {
        let help = format!("give from {} to 10000 samples", 2 * harmonics + 2);
        return Err(Error::request(format!("{samples} samples are not possible for {harmonics} harmonics"), help));
    }
    if !(1..=1000).contains(&starts) {
        return Err(Error::request(format!("{starts} searches are not possible"), "give from 1 to 1000 starts"));
    }
    Ok(())
}

/// Indices of the coordinates of which the generalized speeds are the rates, in the order of the speeds.
///
/// # Errors
/// [`Error::Request`] if a constraint relates coordinates, or if a speed is no rate of a coordinate.
fn coordinates_of_speeds(model: &Mechanism) -> Result<Vec<usize>, Error> {
    if model.time().is_some() {
        let help = "replace the prescribed motion by a coordinate";
        return Err(Error::request("the model depends on the time `t`, and a designed motion is periodic", help));
    }
    if !model.loops.is_empty() {
        let help = "design the motion of a model without the closing joints, or give `tripos fit` measured motions";
        return Err(Error::request("the model has loops, which relate its coordinates", help));
    }
    let find = |speed: &tripos_derive::model::Speed| {
        model.coordinates.iter().position(|coordinate| coordinate.rate == speed.definition).ok_or_else(|| {
            let what = format!("the speed `{}` is no rate of a coordinate", speed.name);
            let help = "define each speed as the rate of a coordinate, such as u1 = \"q1'\"";
            Error::request(what, help)
        })
    };
    let list = model.speeds.iter().map(find).collect::<Result<Vec<usize>, Error>>()?;
    if list.is_empty() {
        return Err(Error::request("the model has no generalized speeds", "give it a coordinate and a speed"));
    }
    if let Some(other) = (0..model.coordinates.len()).find(|at| !list.contains(at)) {
        let what = format!(
            "constraints relate the rate of `{}` to other rates: {} coordinates have {} speeds",
            model.coordinates[other].name,
            model.coordinates.len(),
            model.speeds.len()
        );
        return Err(Error::request(what, "give `tripos fit` measured motions, which keep the constraints"));
    }
    Ok(list)
}

/// Conditions at the start of each coordinate.
///
/// # Errors
/// [`Error::Request`] if a name is unknown, or if a value is not within the limits of the coordinate.
fn start_conditions(
    model: &Mechanism,
    limits: &MotionLimits,
    options: &ExcitationOptions,
) -> Result<Vec<StartConditions>, Error> {
    let start = StartConditions { is_at_rest: options.is_at_rest, home: None };
    let mut list = vec![start; model.coordinates.len()];
    for (name, value) in &options.home {
        let Some(at) = model.coordinates.iter().position(|coordinate| coordinate.name == *name) else {
            let help = nearest_name_advice(name, model.coordinates.iter().map(|c| c.name.as_str()));
            return Err(Error::request(format!("there is no coordinate `{name}` to start from"), help));
        };
        let [position, ..] = &limits.ranges[at];
        let (low, high) = (position.low.value, position.high.value);
        if !(low < *value && *value < high) {
            let what = format!("the start of `{name}` at {value} is not between its limits {low} and {high}");
            return Err(Error::request(what, "give a start between the limits, or other limits"));
        }
        list[at].home = Some(*value);
    }
    Ok(list)
}

/// Model, regressor and limits of a design.
struct Design<'a> {
    /// Model of the mechanism.
    model: &'a Mechanism,
    /// Period of the motion, s.
    period: f64,
    /// Number of harmonics of each coordinate.
    harmonics: usize,
    /// Index of the coordinate of which each generalized speed is the rate.
    coordinate_of: Vec<usize>,
    /// Regressor of the base parameters.
    regressor: MotionRegressor,
    /// Limits of the motion.
    limits: MotionLimits,
    /// Map from unknowns to motions within the limits.
    space: CandidateSpace,
    /// Instants at which forces are measured.
    instants: PhaseTable,
}

impl<'a> Design<'a> {
    /// Prepares a design.
    ///
    /// # Errors
    /// [`Error::Request`] if the model has constraints, if a limit or an option is wrong, or if there are too few
    /// samples.
    fn new(model: &'a Mechanism, found: &Identification, options: &ExcitationOptions) -> Result<Self, Error> {
        let coordinate_of = coordinates_of_speeds(model)?;
        let regressor = MotionRegressor::new(model, found, &options.noise)?;
        let limits = MotionLimits::new(model, &coordinate_of, &regressor.p, &options.limits)?;
        let starts = start_conditions(model, &limits, options)?;
        let (columns, rows) = (found.base.len(), options.samples * model.speeds.len());
        if rows < columns {
            let what = format!("{rows} measured forces cannot determine {columns} base parameters");
            let help = format!("give at least {} samples", columns.div_ceil(model.speeds.len()));
            return Err(Error::request(what, help));
        }
        let space = CandidateSpace::new(options.period, options.harmonics, limits.ranges.clone(), starts);
        Ok(Self {
            model,
            period: options.period,
            harmonics: options.harmonics,
            coordinate_of,
            regressor,
            limits,
            space,
            instants: PhaseTable::of_instants(options.harmonics, options.samples),
        })
    }

    /// States of a motion at the instants of a table.
    fn states(&self, series: &[FourierSeries], table: &PhaseTable) -> States {
        let values = |list: &[FourierSeries]| -> Vec<f64> {
            let columns: Vec<Vec<f64>> = list.iter().map(|series| table.values(series).collect()).collect();
            (0..table.len()).flat_map(|row| columns.iter().map(move |column| column[row])).collect()
        };
        let rate = |list: &[FourierSeries]| list.iter().map(|series| series.rate(self.period)).collect::<Vec<_>>();
        let speeds: Vec<FourierSeries> = self.coordinate_of.iter().map(|at| series[*at].clone()).collect();
        let u = rate(&speeds);
        States { q: values(series), rates: values(&rate(&u)), u: values(&u) }
    }

    /// Regressor of a motion at the instants of the measurement, with each row divided by the standard deviation of its
    /// force.
    ///
    /// # Errors
    /// [`Error::Stopped`] if the regressor has no finite value at an instant.
    fn weighted_regressor(&self, series: &[FourierSeries]) -> Result<DMatrix<f64>, Error> {
        self.regressor.at(&self.states(series, &self.instants))
    }

    /// Least value of each condition of the domain at the instants of a table. −∞ if a condition has no value.
    fn least_values(&self, series: &[FourierSeries], table: &PhaseTable) -> Vec<f64> {
        if self.limits.conditions.is_empty() {
            return Vec::new();
        }
        let States { q, u, .. } = self.states(series, table);
        let states = || q.chunks(self.model.coordinates.len()).zip(u.chunks(self.coordinate_of.len()));
        let least = |tape: &tripos_derive::algebra::value::tape::Tape| {
            let values = states().map(|(q, u)| tape.evaluate(&[&self.regressor.p, q, u].concat())[0]);
            values.fold(f64::INFINITY, |least, x| if x.is_nan() { f64::NEG_INFINITY } else { least.min(x) })
        };
        self.limits.conditions.iter().map(|(_, tape)| least(tape)).collect()
    }

    /// Sum of the amounts by which a motion violates conditions of the domain; 0 if it keeps them.
    fn violation(&self, series: &[FourierSeries], table: &PhaseTable) -> f64 {
        self.least_values(series, table)
            .iter()
            .map(|least| if *least > 0.0 { 0.0 } else { VIOLATED * 1e-3 - least })
            .sum()
    }

    /// Indices of the base parameters whose columns are independent in random motions within the limits.
    ///
    /// # Errors
    /// [`Error::Request`] if all columns are zero. [`Error::Stopped`] if the regressor has no value.
    fn counted_columns(&self, seed: u64) -> Result<Vec<usize>, Error> {
        let mut random = RandomNumbers::new(seed);
        let mut whole = DMatrix::zeros(0, self.regressor.columns);
        for _ in 0..RICH {
            let x = random.normal_vector(self.space.unknowns());
            let part = self.weighted_regressor(&self.space.motion(x.as_slice()).0)?;
            let first = whole.nrows();
            whole = whole.resize_vertically(first + part.nrows(), 0.0);
            whole.rows_mut(first, part.nrows()).copy_from(&part);
        }
        let counted = independent_columns(&whole);
        if counted.is_empty() {
            let help = "give at least one coordinate limits that let it move";
            return Err(Error::request("no motion within the limits determines a base parameter", help));
        }
        Ok(counted)
    }

    /// Motion of given unknowns, and the penalty of unknowns without an effect. A motion that violates a condition of
    /// the domain is made smaller until it keeps the condition at the samples, if the pose about which it moves does.
    fn motion(&self, x: &[f64]) -> (Vec<FourierSeries>, f64) {
        let (series, penalty) = self.space.motion(x);
        let scaled = |factor: f64| self.space.scaled(&series, factor);
        let keeps = |factor: f64| self.violation(&scaled(factor), &self.instants) == 0.0;
        if self.limits.conditions.is_empty() || keeps(1.0) || !keeps(0.0) {
            return (series, penalty);
        }
        let (mut inside, mut outside) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (inside + outside);
            if keeps(middle) { inside = middle } else { outside = middle }
        }
        (scaled(inside), penalty + TOO_LARGE * outside.ln().powi(2))
    }

    /// Value that the search minimizes: −log det of the information about the counted columns, with penalties. ∞ if the
    /// motion does not determine them.
    ///
    /// # Errors
    /// [`Error::Interrupted`] if the observer of the model ends the search; the errors of the regressor.
    fn value(&self, x: &[f64], counted: &[usize]) -> Result<f64, Error> {
        if self.model.follow.is_interrupted() {
            return Err(Error::Interrupted);
        }
        let (series, penalty) = self.motion(x);
        let violation = self.violation(&series, &self.instants);
        if violation > 0.0 {
            return Ok(VIOLATED + violation + penalty);
        }
        let own = self.weighted_regressor(&series)?.select_columns(counted);
        Ok(penalty - log_determinant(&mut own.tr_mul(&own)))
    }

    /// Best motion of all searches, and the number of motions that they tried.
    ///
    /// # Errors
    /// The errors of [`Self::value`].
    fn search(&self, counted: &[usize], options: &ExcitationOptions) -> Result<(Vec<FourierSeries>, usize), Error> {
        let unknowns = self.space.unknowns();
        let mut function = |x: &[f64]| self.value(x, counted);
        let mut best: Option<BestPoint> = None;
        let mut tried = 0;
        for start in 0..options.starts {
            let mut random = RandomNumbers::new(options.seed.wrapping_add((start as u64) << 32));
            let mut first = (f64::INFINITY, vec![0.0; unknowns]);
            for _ in 0..DRAWS {
                let x = random.normal_vector(unknowns).as_slice().to_vec();
                let value = function(&x)?;
                if value < first.0 || first.0.is_infinite() {
                    first = (value, x);
                }
            }
            let found = minimize(&mut function, &first.1, SPREAD, EVALUATIONS * unknowns, &mut random)?;
            tried += DRAWS + found.tried;
            if best.as_ref().is_none_or(|best| found.value < best.value) {
                best = Some(found);
            }
        }
        let x = best.map_or_else(|| vec![0.0; unknowns], |best| best.x);
        Ok((self.motion(&x).0, tried))
    }

    /// Instants at which the conditions of the domain are verified; none without conditions.
    fn fine_table(&self) -> PhaseTable {
        let count = if self.limits.conditions.is_empty() { 0 } else { FINE * self.harmonics + 1 };
        PhaseTable::of_instants(self.harmonics, count)
    }

    /// Rounded motion that keeps limits at every instant, and conditions of the domain on a fine grid. It is smaller
    /// than the given motion if need be.
    ///
    /// # Errors
    /// [`Error::Request`] if even small motions violate a condition of the domain.
    fn verified(&self, series: &[FourierSeries]) -> Result<Vec<FourierSeries>, Error> {
        let table = self.fine_table();
        let mut reduction = 0.0_f64;
        for _ in 0..SHRINKINGS {
            let rounded = self.space.rounded(&self.space.scaled(series, 1.0 - reduction));
            if let Some(rounded) = rounded.filter(|rounded| self.violation(rounded, &table) == 0.0) {
                return Ok(rounded);
            }
            reduction = if reduction == 0.0 { REDUCTION } else { (1.5 * reduction).min(1.0) };
        }
        let names: Vec<String> = self.limits.conditions.iter().map(|(name, _)| format!("`{name}`")).collect();
        let what = format!(
            "no motion within the limits was found that keeps the conditions of the domain: {}",
            names.join(", ")
        );
        Err(Error::request(what, "give limits within the domain by `--limit`"))
    }

    /// Samples of a motion at the instants of the measurement.
    fn samples(&self, series: &[FourierSeries]) -> Vec<MotionSample> {
        let States { q, u, rates } = self.states(series, &self.instants);
        let wide = |list: &[f64], width: usize, at: usize| {
            list[at * width..(at + 1) * width].iter().map(|x| (*x).into()).collect()
        };
        let (coordinates, speeds) = (self.model.coordinates.len(), self.coordinate_of.len());
        let last = self.instants.len().saturating_sub(1).max(1) as f64;
        let sample = |at: usize| MotionSample {
            t: Some(self.period * at as f64 / last),
            q: wide(&q, coordinates, at),
            u: wide(&u, speeds, at),
            rates: wide(&rates, speeds, at),
        };
        (0..self.instants.len()).map(sample).collect()
    }

    /// Extreme values of all coordinates and of their derivatives, with the limits.
    fn extremes(&self, series: &[FourierSeries]) -> Vec<Extremes> {
        let mut list = Vec::new();
        for ((coordinate, series), ranges) in self.model.coordinates.iter().zip(series).zip(&self.limits.ranges) {
            let rate = series.rate(self.period);
            let second = rate.rate(self.period);
            for ((series, range), primes) in [series, &rate, &second].into_iter().zip(ranges).zip(["", "'", "''"]) {
                let (least, largest) = series.extremes();
                let bound = |value: f64| Some(value).filter(|value| value.is_finite());
                list.push(Extremes {
                    name: format!("{}{primes}", coordinate.name),
                    least,
                    largest,
                    low: bound(range.low.value),
                    high: bound(range.high.value),
                });
            }
        }
        list
    }
}
