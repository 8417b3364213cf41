//! What can be identified from motion, in numbers: values of base parameters, and the regressor at given states.
//!
//! The base parameters themselves are found by [`tripos_derive::identify`]. What inputs do is Y_b π_b + rest, row by row, with the
//! inputs' own share on the left: tau = B r ([`crate::inverse`]).

use crate::{Error, Mechanism};
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::evaluate::Tape;
use tripos_derive::identify::{Factor, Identification};
use tripos_derive::mechanics::Varied;
use tripos_derive::scene::Moving;
use tripos_traits::DoubleDouble;

/// Finds the base parameters of a mechanism.
///
/// # Errors
/// [`Error::Input`] if the model cannot be derived.
pub fn identify(model: &Mechanism, varied: Varied) -> Result<Identification, Error> {
    Identification::new(model, varied).map_err(|error| Error::Input(model.diagnose(&error)))
}

/// The values of the base parameters, as the model states its bodies and these values its parameters; nothing where a factor has no closed
/// form.
///
/// # Errors
/// [`Error::Request`] if a formula mentions what has no value.
pub fn values(
    model: &Mechanism,
    found: &Identification,
    parameters: &[DoubleDouble],
) -> Result<Vec<Option<DoubleDouble>>, Error> {
    let columns = &found.regressor.columns;
    let mut terms: Vec<Expr> = columns.iter().map(|column| column.stated).collect();
    let groups = || found.base.iter().chain(&found.grouped);
    terms.extend(groups().flat_map(|base| &base.with).filter_map(|(_, factor)| match factor {
        Factor::Exact(e) => Some(*e),
        _ => None,
    }));
    let tape: Tape<DoubleDouble> = crate::code::tape(&found.regressor.arena, &model.p(), &terms, "a parameter")?.to();
    let values = tape.evaluate(parameters);
    let (stated, factors) = values.split_at(columns.len());
    let mut factors = factors.iter();
    let mut of_groups: Vec<Vec<(usize, Option<DoubleDouble>)>> = Vec::new();
    for base in groups() {
        let value = |factor: &Factor, next: &mut std::slice::Iter<'_, DoubleDouble>| match factor {
            Factor::Exact(_) => next.next().copied(),
            Factor::Number(x) => Some((*x).into()),
            Factor::Unknown => None,
        };
        of_groups.push(base.with.iter().map(|(at, factor)| (*at, value(factor, &mut factors))).collect());
    }
    // What stands for a combination of its own has the value of that, with closed loops.
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

/// A row of the regressor: the force along a speed at a state.
#[derive(Clone, Debug)]
pub struct Row {
    /// The state, by its place.
    pub state: usize,
    /// The speed, by its place.
    pub speed: usize,
    /// What each base parameter is multiplied by.
    pub factors: Vec<DoubleDouble>,
    /// What is known: the force is Σ factor π + rest. Inputs are 0 in it.
    pub rest: DoubleDouble,
}

/// The regressor of the base parameters at states.
///
/// # Errors
/// [`Error::Request`] if a column mentions what has no value; [`Error::Stopped`] where one has none at a state.
pub fn rows(
    model: &Mechanism,
    found: &Identification,
    parameters: &[DoubleDouble],
    states: &[Moving],
) -> Result<Vec<Row>, Error> {
    let regressor = &found.regressor;
    let speeds = model.speeds.len();
    let columns = found.base.iter().map(|base| &regressor.columns[base.column].forces);
    let terms: Vec<Expr> = columns.chain([&regressor.rest]).flatten().copied().collect();
    let rates = model.speeds.iter().map(|speed| speed.rate).collect();
    let known = [model.p(), model.q(), model.u(), rates].concat();
    let tape: Tape<DoubleDouble> = crate::code::tape(&regressor.arena, &known, &terms, "the regressor")?.to();
    let mut p = parameters.to_vec();
    let inputs =
        (0..p.len()).filter(|at| model.parameters[*at].is_input && model.parameters[*at].unit.of_mass().is_one());
    for at in inputs.collect::<Vec<_>>() {
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
            list.push(Row { state, speed, factors, rest: of(found.base.len()) });
        }
    }
    Ok(list)
}
