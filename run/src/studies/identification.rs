//! Identification of inertial parameters from motions: values of the base parameters, and the
//! regressor at given states.
//!
//! Base parameters are the combinations of inertial parameters that motions can determine.
//! [`tripos_derive::identify`] finds them. Each row of the regressor is one of the equations
//! Y_b π_b + rest = tau, with the base parameters π_b. Here tau = B r is the generalized force of the
//! inputs r ([`super::inverse`]).

use crate::state_arrays::{Arguments, StateRows, share_states, write_in_lanes};
use crate::{Error, Mechanism};
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::identify::{BaseParameter, BaseParameterFactor, Identification};
use tripos_derive::mechanics::RegressorParameters;
use tripos_derive::scene::MotionSample;
use tripos_traits::{DoubleDouble, Lanes};

/// Finds the base parameters of a mechanism: the combinations of inertial parameters that motions
/// can determine.
///
/// # Errors
/// [`Error::Input`] if the model cannot be derived.
pub fn identify(model: &Mechanism, varied: RegressorParameters) -> Result<Identification, Error> {
    Identification::new(model, varied).map_err(|error| Error::Input(model.diagnose(&error)))
}

/// Computes the numerical values of the base parameters to 32 digits, from the model's bodies and the
/// given parameters. `None` for a base parameter that contains a factor without a closed form.
///
/// # Errors
/// [`Error::Request`] if a formula contains a symbol without a value.
pub fn base_parameter_values(
    model: &Mechanism,
    found: &Identification,
    parameters: &[DoubleDouble],
) -> Result<Vec<Option<DoubleDouble>>, Error> {
    let columns = &found.regressor.columns;
    let mut terms: Vec<Expr> = columns.iter().map(|column| column.stated).collect();
    let groups = || found.base.iter().chain(&found.grouped);
    terms.extend(groups().flat_map(|base| &base.with).filter_map(|(_, factor)| match factor {
        BaseParameterFactor::Exact(e) => Some(*e),
        _ => None,
    }));
    let tape: Tape<DoubleDouble> =
        crate::code::compile_tape(&found.regressor.arena, &model.p(), &terms, "a parameter")?.to();
    let values = tape.evaluate(parameters);
    let (stated, factors) = values.split_at(columns.len());
    let mut factors = factors.iter();
    let mut of_groups: Vec<Vec<(usize, Option<DoubleDouble>)>> = Vec::new();
    for base in groups() {
        let value = |factor: &BaseParameterFactor, next: &mut std::slice::Iter<'_, DoubleDouble>| match factor {
            BaseParameterFactor::Exact(_) => next.next().copied(),
            BaseParameterFactor::Number(x) => Some((*x).into()),
            BaseParameterFactor::Unknown => None,
        };
        of_groups.push(base.with.iter().map(|(at, factor)| (*at, value(factor, &mut factors))).collect());
    }
    // With closed loops, a column of the regressor may represent a combination of columns. It then has the
    // value of this combination.
    let whole: Vec<(usize, usize)> =
        found.grouped.iter().enumerate().map(|(k, base)| (base.column, found.base.len() + k)).collect();
    let own = |at: usize, with: &[(usize, Option<DoubleDouble>)]| {
        with.iter().try_fold(stated[at], |sum, (at, factor)| Some(sum + stated[*at] * (*factor)?))
    };
    let value_of = |at: usize| match whole.iter().find(|(column, _)| *column == at) {
        Some((column, k)) => own(*column, &of_groups[*k]),
        None => Some(stated[at]),
    };
    let of_base = found.base.iter().zip(&of_groups).map(|(base, with)| {
        with.iter().try_fold(stated[base.column], |sum, (at, factor)| Some(sum + value_of(*at)? * (*factor)?))
    });
    Ok(of_base.collect())
}

/// Row of the regressor: the generalized force along one generalized speed at one state, as a linear
/// function of the base parameters.
#[derive(Clone, Debug)]
pub struct RegressorRow {
    /// Index of the state among the given states, from 0.
    pub state: usize,
    /// Index of the generalized speed along which the force acts, from 0.
    pub speed: usize,
    /// Factor of each base parameter π in the force, in the order of the base parameters.
    pub factors: Vec<DoubleDouble>,
    /// Known part of the force, with all inputs at 0. The whole force is Σ factor π + rest.
    pub rest: DoubleDouble,
}

/// Computes the rows of the regressor of the base parameters at the given states, one row for each state
/// and speed.
///
/// # Errors
/// [`Error::Request`] if a column contains a symbol without a value. [`Error::Stopped`] if a column has
/// no finite value at a state.
pub fn regressor_rows(
    model: &Mechanism,
    found: &Identification,
    parameters: &[DoubleDouble],
    states: &[MotionSample],
) -> Result<Vec<RegressorRow>, Error> {
    let speeds = model.speeds.len();
    let tape: Tape<DoubleDouble> = regressor_tape(model, found, &found.base)?.to();
    let mut p = parameters.to_vec();
    for at in inputs_in_regressor(model) {
        p[at] = 0.0.into();
    }
    let mut list = Vec::new();
    for (state, moving) in states.iter().enumerate() {
        let values = tape.evaluate(&[p.as_slice(), &moving.q, &moving.u, &moving.rates].concat());
        if values.iter().any(|x| !x.hi().is_finite()) {
            return Err(Error::Stopped(format!("the regressor has no value at state {}", state + 1)));
        }
        for speed in 0..speeds {
            let of = |column: usize| values[column * speeds + speed];
            let factors = (0..found.base.len()).map(of).collect();
            list.push(RegressorRow { state, speed, factors, rest: of(found.base.len()) });
        }
    }
    Ok(list)
}

/// Makes the tape of the regressor, from parameters, coordinates, generalized speeds and their rates. Its
/// outputs are the factors of each base parameter along all speeds, then the known part along all
/// speeds.
///
/// # Errors
/// [`Error::Request`] if a column contains a symbol without a value.
pub(crate) fn regressor_tape(model: &Mechanism, found: &Identification, base: &[BaseParameter]) -> Result<Tape, Error> {
    let regressor = &found.regressor;
    let columns = base.iter().map(|base| &regressor.columns[base.column].forces);
    let terms: Vec<Expr> = columns.chain([&regressor.rest]).flatten().copied().collect();
    let rates = model.speeds.iter().map(|speed| speed.rate).collect();
    let known = [model.p(), model.q(), model.u(), rates].concat();
    crate::code::compile_tape(&regressor.arena, &known, &terms, "the regressor")
}

/// Indices of the parameters that are inputs and count as unknown forces. In a regressor they are 0.
fn inputs_in_regressor(model: &Mechanism) -> Vec<usize> {
    let is_input =
        |at: &usize| model.parameters[*at].is_input && model.parameters[*at].unit.kilogram_exponent().is_one();
    (0..model.parameters.len()).filter(is_input).collect()
}

/// Regressor of the base parameters in double precision, for arrays of states.
pub struct StateRegressor {
    /// Tape of the regressor, for eight states at once.
    tape: Tape<Lanes<8>>,
    /// Indices of the inputs that are 0.
    inputs: Vec<usize>,
    /// Number of generalized speeds.
    speeds: usize,
}

impl StateRegressor {
    /// Compiles the regressor of a mechanism for arrays of states.
    ///
    /// # Errors
    /// [`Error::Request`] if a column contains a symbol without a value.
    pub fn new(model: &Mechanism, found: &Identification) -> Result<Self, Error> {
        let tape = regressor_tape(model, found, &found.base)?.to();
        Ok(Self { tape, inputs: inputs_in_regressor(model), speeds: model.speeds.len() })
    }

    /// Number of rows and of columns at each state. There is a row for each generalized speed and a column
    /// for each base parameter. The last column is the known part.
    #[must_use]
    pub fn shape(&self) -> (usize, usize) {
        (self.speeds, self.tape.outputs() / self.speeds.max(1))
    }

    /// Writes the regressor at each state to `out`, row by row. Arrays of many states are shared among all
    /// cores.
    ///
    /// # Panics
    /// If a length does not fit the model, or if `out` does not have the shape [`StateRegressor::shape`]
    /// for each state.
    pub fn evaluate(&self, p: &[f64], states: StateRows<'_>, out: &mut [f64]) {
        let (rows, columns) = self.shape();
        let width = rows * columns;
        assert_eq!(out.len(), states.count * width, "one place for each value");
        let mut p = p.to_vec();
        for at in &self.inputs {
            p[*at] = 0.0;
        }
        share_states(states.count, width, out, &|first, out| {
            let (mut inputs, mut scratch, mut values) = (Vec::new(), Vec::new(), vec![Lanes([0.0; 8]); width]);
            write_in_lanes::<8>(&p, states, width, first, out, |at, out| {
                let Arguments { p, q, v, v_dot } = at;
                inputs.clear();
                for part in [p, q, v, v_dot] {
                    inputs.extend_from_slice(part);
                }
                self.tape.evaluate_into(&inputs, &mut scratch, &mut values);
                for (at, out) in out.iter_mut().enumerate() {
                    *out = values[at % columns * rows + at / columns];
                }
            });
        });
    }
}
