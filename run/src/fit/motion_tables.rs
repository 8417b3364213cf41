//! Measured motions from tables: coordinates, speeds and their rates, inputs and forces.
//!
//! Speeds and rates that a table does not have are differences of the coordinates, after a low-pass filter that also
//! acts on all other columns (M. Gautier, P. Vandanjon & C. Presse, "Identification of inertial and drive gain
//! parameters of robots", IEEE Conf. Decision and Control (1994) 3764–3769).

use super::force_fit::MeasuredMotion;
use super::low_pass::{LowPass, central_differences};
use crate::code::compile_tape;
use crate::{Error, Mechanism};
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::plain_text::with_reliable_digits;
use tripos_derive::scene::{Loops, MeasuredTable};

/// Part of the distance of two instants by which an instant may be off, as in tables whose instants are rounded.
const EVEN: f64 = 0.05;
/// Number of samples at each end that are left out after differences, of which the ends are less accurate.
const END: usize = 4;

/// Measured motion of a table.
pub struct MotionTable {
    /// Measured motion at each instant.
    pub motions: Vec<MeasuredMotion>,
    /// Number of neighbouring rows that share an error: above 1 after a low-pass filter.
    pub rows_for_each_error: f64,
    /// Names of the columns that are not used.
    pub unused: Vec<String>,
    /// True if the table has both inputs and forces. Forces act beside the inputs.
    pub has_inputs_and_forces: bool,
    /// Largest residual of a loop of the model at the measured coordinates, in the unit of the loop.
    pub open: f64,
}

/// Columns of a table, filtered if a cut-off frequency is given.
struct Columns<'a> {
    /// Table of the measured quantities.
    table: &'a MeasuredTable,
    /// Filter for all columns; `None` without a cut-off frequency.
    filter: Option<LowPass>,
}

impl Columns<'_> {
    /// Numbers of a column, filtered.
    ///
    /// # Errors
    /// [`Error::Input`] if the table has no such column, or if a cell is no finite number.
    fn get(&self, name: &str) -> Result<Vec<f64>, Error> {
        let column = self.table.column(name)?;
        Ok(self.filter.as_ref().map_or_else(|| column.clone(), |filter| filter.filter(&column)))
    }
}

/// Reads a measured motion from a table. The table has a column for each coordinate. It may have columns for all speeds
/// (`u1`) and all their rates (`u1'`), for inputs, and for forces along speeds (`force(u1)`). Inputs without a column
/// have their default values, or 0. Forces without a column are 0. `cut_off` is the frequency of a low-pass filter for
/// all columns, Hz.
///
/// # Errors
/// [`Error::Input`] if a column is missing or has a cell that is no finite number. [`Error::Request`] if a parameter
/// has no value, if speeds or a filter need even instants, or if the filter does not fit the instants.
pub fn motion_of_table(
    model: &Mechanism,
    name: &str,
    table: &MeasuredTable,
    cut_off: Option<f64>,
) -> Result<MotionTable, Error> {
    let rows = table.rows();
    let speeds: Vec<String> = model.speeds.iter().map(|speed| speed.name.clone()).collect();
    let rate_names: Vec<String> = speeds.iter().map(|speed| format!("{speed}'")).collect();
    let has = |names: &[String]| names.iter().all(|name| table.has(name));
    let (has_speeds, has_rates) = (has(&speeds), has(&rate_names));
    let instants = if table.has("t") { Some(table.instants()?) } else { None };
    let is_differentiated = !(has_speeds && has_rates);
    let needs_even = is_differentiated || cut_off.is_some();
    let distance = if needs_even { Some(even_distance(name, instants.as_deref())?) } else { None };
    let filter = match (cut_off, distance) {
        (Some(cut_off), Some(distance)) => Some(LowPass::new(cut_off, distance).ok_or_else(|| {
            let most = with_reliable_digits(0.5 / distance, None);
            let every = with_reliable_digits(distance, None);
            let what = format!("a filter at {cut_off} Hz does not fit instants every {every} s");
            Error::request(what, format!("give a frequency above 0 and below {most} Hz"))
        })?),
        _ => None,
    };
    let columns = Columns { table, filter };
    let q = model.coordinates.iter().map(|c| columns.get(&c.name)).collect::<Result<Vec<_>, _>>()?;
    let defaults = default_values(model)?;
    let mut p: Vec<Vec<f64>> = defaults.iter().map(|value| vec![*value; rows]).collect();
    for (parameter, values) in model.parameters.iter().zip(&mut p).filter(|(parameter, _)| parameter.is_input) {
        if table.has(&parameter.name) {
            *values = columns.get(&parameter.name)?;
        }
    }
    let force = |speed: &String| {
        let head = format!("force({speed})");
        if table.has(&head) { columns.get(&head) } else { Ok(vec![0.0; rows]) }
    };
    let forces = speeds.iter().map(force).collect::<Result<Vec<_>, _>>()?;
    let at = |list: &[Vec<f64>], row: usize| -> Vec<f64> { list.iter().map(|values| values[row]).collect() };
    let u = match (has_speeds, distance) {
        (false, Some(distance)) => {
            let q_dot: Vec<Vec<f64>> = q.iter().map(|values| central_differences(values, distance)).collect();
            let definitions: Vec<_> = model.speeds.iter().map(|speed| speed.definition).collect();
            let symbols = [model.p(), model.q(), model.q_dot()].concat();
            let tape: Tape<f64> = compile_tape(&model.arena, &symbols, &definitions, "a generalized speed")?;
            let of_row = |row: usize| tape.evaluate(&[at(&p, row), at(&q, row), at(&q_dot, row)].concat());
            let values: Vec<Vec<f64>> = (0..rows).map(of_row).collect();
            (0..speeds.len()).map(|speed| values.iter().map(|row| row[speed]).collect()).collect()
        }
        _ => speeds.iter().map(|name| columns.get(name)).collect::<Result<Vec<_>, _>>()?,
    };
    let rates = match (has_rates, distance) {
        (false, Some(distance)) => u.iter().map(|values| central_differences(values, distance)).collect(),
        _ => rate_names.iter().map(|name| columns.get(name)).collect::<Result<Vec<_>, _>>()?,
    };
    let end = if is_differentiated { END } else { 0 };
    if rows <= 2 * end {
        let what = format!("`{name}` has {rows} rows, too few for differences of its coordinates");
        return Err(Error::request(what, "give more rows, or columns for all speeds and their rates"));
    }
    let row = |row: usize| MeasuredMotion {
        t: instants.as_ref().map(|t| t[row]),
        p: at(&p, row),
        q: at(&q, row),
        u: at(&u, row),
        rates: at(&rates, row),
        forces: at(&forces, row),
    };
    let motions: Vec<MeasuredMotion> = (end..rows - end).map(row).collect();
    let loops = Loops::new(model);
    let open = motions.iter().fold(0.0_f64, |most, moving| {
        loops.openings(&moving.p, &moving.q).iter().fold(most, |most, (_, residual)| most.max(residual.abs()))
    });
    let rows_for_each_error = match (cut_off, distance) {
        (Some(cut_off), Some(distance)) => LowPass::rows_for_each_error(cut_off, distance),
        _ => 1.0,
    };
    let inputs: Vec<String> = model.parameters.iter().filter(|p| p.is_input).map(|p| p.name.clone()).collect();
    let heads: Vec<String> = speeds.iter().map(|speed| format!("force({speed})")).collect();
    let of_coordinates: Vec<String> = model.coordinates.iter().map(|c| c.name.clone()).collect();
    let mut used = [of_coordinates, inputs.clone(), heads.clone(), vec!["t".to_owned()]].concat();
    if has_speeds {
        used.extend(speeds);
    }
    if has_rates {
        used.extend(rate_names);
    }
    Ok(MotionTable {
        motions,
        rows_for_each_error,
        unused: table.names.iter().filter(|name| !used.contains(name)).cloned().collect(),
        has_inputs_and_forces: [&inputs, &heads].iter().all(|list| list.iter().any(|name| table.has(name))),
        open,
    })
}

/// Distance of evenly spaced instants, s.
///
/// # Errors
/// [`Error::Request`] if there are no instants, or if they are not even.
fn even_distance(name: &str, instants: Option<&[f64]>) -> Result<f64, Error> {
    let help = "give evenly spaced instants, or columns for all speeds and their rates without a filter";
    let Some(t) = instants.filter(|t| t.len() > 1) else {
        return Err(Error::request(format!("`{name}` has no instants by which to differentiate or filter"), help));
    };
    let distance = (t[t.len() - 1] - t[0]) / (t.len() - 1) as f64;
    let is_even = |(at, t_at): (usize, &f64)| (t_at - (t[0] + distance * at as f64)).abs() <= EVEN * distance;
    if t.iter().enumerate().all(is_even) {
        return Ok(distance);
    }
    Err(Error::request(format!("the instants of `{name}` are not evenly spaced"), help))
}

/// Default values of the parameters, with 0 for inputs without one.
///
/// # Errors
/// [`Error::Request`] if a parameter has no value.
pub(super) fn default_values(model: &Mechanism) -> Result<Vec<f64>, Error> {
    let value = |p: &tripos_derive::model::Parameter| match &p.value {
        Some(value) => Ok(value.to_f64()),
        None if p.is_input => Ok(0.0),
        None => {
            let help = "give it a default in the model file";
            Err(Error::request(format!("the parameter `{}` has no value", p.name), help))
        }
    };
    model.parameters.iter().map(value).collect()
}
