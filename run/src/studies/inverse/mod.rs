//! Inverse dynamics: the generalized forces that a given motion needs, and the inputs that produce
//! them.
//!
//! A motion needs generalized forces M u̇ − f along the speeds, in addition to all loads that the
//! model states. The forcing f contains these loads with the wanted inputs at zero. Loads that are
//! linear in the inputs r add B r to f. The inputs r are the least-squares solution with the least
//! norm, and its residual is reported.
//!
//! For large mechanisms, M u̇ − f is computed by recursion. Source: J. Y. S. Luh, M. W. Walker & R. P. C.
//! Paul, ASME J. Dyn. Sys. Meas. Control 102 (1980) 69–76.

mod least_squares;
mod prescribed_motion;

pub use prescribed_motion::motion_samples;

use crate::{Error, Mechanism};
use least_squares::{LeastSquaresSolver, round_to_doubles};
use tripos_derive::Formulation;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::term::calculus::Gradient;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::mechanics::Unsolved;
use tripos_derive::plain_text::with_reliable_digits;
use tripos_derive::scene::{Loops, MotionSample};
use tripos_traits::DoubleDouble;

/// Residual up to which inputs count as producing the wanted forces, relative to the largest term of
/// these forces.
const LEFT: f64 = 1e-10;

/// Inverse dynamics of a mechanism. It computes the forces that a motion needs, and the inputs that
/// produce these forces.
pub struct InverseDynamics {
    /// Names of the generalized speeds along which the forces act.
    pub speeds: Vec<String>,
    /// Names of the inputs whose values are computed.
    pub inputs: Vec<String>,
    /// Indices of these inputs among the model's parameters.
    places: Vec<usize>,
    /// Tape of the required forces, followed by the matrix B row by row, in double precision. B relates
    /// forces and inputs. Arguments: parameters, q, u and u̇.
    tape: Tape,
    /// Tape of the required forces, followed by the matrix B row by row, to 32 digits. B relates forces and
    /// inputs. Arguments: parameters, q, u and u̇.
    wide: Tape<DoubleDouble>,
    /// Loops of the model. They tell how far a pose is from closing them.
    loops: Loops,
}

/// Generalized forces that a motion needs at an instant, and the inputs that produce them.
#[derive(Clone, Debug)]
pub struct RequiredForces {
    /// Generalized force M u̇ − f along each speed, with the inputs at 0. Its unit is the unit of power
    /// divided by the unit of the speed.
    pub along: Vec<DoubleDouble>,
    /// Inputs that produce the forces. If there are several solutions, the one of least norm. `None` if no
    /// inputs produce the forces, or if there are no inputs.
    pub inputs: Option<Vec<f64>>,
    /// Part of the force along each speed that the best inputs do not produce.
    pub left: Vec<f64>,
    /// Number of independent directions of force that the inputs can produce in this pose: the rank of B.
    pub reached: usize,
    /// Largest absolute residual of a loop in the pose, in the unit of the loop.
    pub open: f64,
}

impl InverseDynamics {
    /// Prepares the inverse dynamics of a model. `names` are the inputs to compute. They may also be other
    /// parameters in which the loads are linear. If the list is empty, all inputs of the model are
    /// computed.
    ///
    /// # Errors
    /// [`Error`] if the model cannot be derived, lacks a named input, or has forces that are not linear
    /// in the inputs.
    pub fn new(model: &Mechanism, names: &[String]) -> Result<Self, Error> {
        let places = input_indices(model, names)?;
        let symbols: Vec<Expr> = places.iter().map(|at| model.parameters[*at].symbol).collect();
        let derivation = model.derive(Formulation::Kane)?;
        let mut arena = derivation.arena;
        let proved = derivation.equations.with_certified_inverse_dynamics(&mut arena);
        let required = proved.map_err(|why| Error::request(format!("{why}"), Unsolved::from(why).help()))?.required;
        let mut gradient = Gradient::new(&symbols);
        let mut outputs = required.clone();
        for force in &required {
            let mut row = vec![Expr::ZERO; symbols.len()];
            for &(at, slope) in gradient.apply(&mut arena, *force).iter() {
                let seconds = gradient.apply(&mut arena, slope);
                if let Some((other, _)) = seconds.iter().find(|(_, e)| zero_test(&arena, *e) != ZeroTest::Zero) {
                    return Err(nonlinear_input_error(model, places[at], places[*other]));
                }
                row[at] = arena.neg(slope);
            }
            outputs.extend(row);
        }
        let rates = model.speeds.iter().map(|speed| speed.rate).collect();
        let known = [model.p(), model.q(), model.u(), rates].concat();
        let tape = crate::code::compile_tape(&arena, &known, &outputs, "inverse dynamics")?;
        Ok(Self {
            speeds: model.speeds.iter().map(|s| s.name.clone()).collect(),
            inputs: places.iter().map(|at| model.parameters[*at].name.clone()).collect(),
            places,
            wide: tape.to(),
            tape,
            loops: Loops::new(model),
        })
    }

    /// Computes the forces that a motion needs at an instant, and the inputs that produce them.
    /// `parameters` are in the order of the model. The values of the wanted inputs among them are ignored.
    ///
    /// # Errors
    /// [`Error::Stopped`] if a force has no finite value.
    pub fn required_forces_at(
        &self,
        parameters: &[DoubleDouble],
        moving: &MotionSample,
    ) -> Result<RequiredForces, Error> {
        let mut p = parameters.to_vec();
        for at in &self.places {
            p[*at] = 0.0.into();
        }
        let known = [p.as_slice(), &moving.q, &moving.u, &moving.rates].concat();
        let values = self.wide.evaluate(&known);
        let (along, columns) = values.split_at(self.speeds.len());
        if let Some(at) = values.iter().position(|x| !x.hi().is_finite()) {
            let speed = &self.speeds[if at < along.len() { at } else { (at - along.len()) / self.inputs.len() }];
            let when = moving.t.map_or_else(String::new, |t| format!(" at t = {} s", with_reliable_digits(t, None)));
            return Err(Error::Stopped(format!("the force along `{speed}` has no value{when}")));
        }
        let rows: Vec<&[DoubleDouble]> =
            (0..along.len()).map(|r| &columns[r * self.inputs.len()..(r + 1) * self.inputs.len()]).collect();
        let found = LeastSquaresSolver::new(&rows).solve(&rows, along);
        let largest = self.tape.largest_terms(&round_to_doubles(&known))[..along.len()]
            .iter()
            .fold(0.0, |most: f64, x| most.max(*x));
        let left = round_to_doubles(&found.left);
        let is_given = left.iter().all(|x| x.abs() <= LEFT * largest);
        let open = self.loops.openings(&round_to_doubles(&p), &round_to_doubles(&moving.q));
        Ok(RequiredForces {
            along: along.to_vec(),
            inputs: (is_given && !self.inputs.is_empty()).then(|| round_to_doubles(&found.x)),
            left,
            reached: found.rank,
            open: open.iter().fold(0.0, |most: f64, (_, x)| most.max(x.abs())),
        })
    }
}

/// Makes the error for forces that are not linear in one parameter, or that contain a product of two
/// parameters. Both are given by index.
fn nonlinear_input_error(model: &Mechanism, at: usize, other: usize) -> Error {
    let [name, other] = [at, other].map(|at| &model.parameters[at].name);
    let what = if name == other {
        format!("forces are not linear in `{name}`")
    } else {
        format!("forces hold products of `{name}` and `{other}`")
    };
    Error::request(what, "name with --input parameters in which the loads are linear")
}

/// Finds the indices of the named parameters among all parameters. If `names` is empty, returns the
/// indices of all inputs of the model.
///
/// # Errors
/// [`Error::Request`] if a name is unknown or given twice.
fn input_indices(model: &Mechanism, names: &[String]) -> Result<Vec<usize>, Error> {
    if names.is_empty() {
        return Ok((0..model.parameters.len()).filter(|at| model.parameters[*at].is_input).collect());
    }
    let mut places = Vec::new();
    for name in names {
        let at = model.parameters.iter().position(|p| p.name == *name).ok_or_else(|| {
            let help =
                tripos_derive::diagnostic::nearest_name_advice(name, model.parameters.iter().map(|p| p.name.as_str()));
            Error::request(format!("the model has no input `{name}`"), help)
        })?;
        if places.contains(&at) {
            return Err(Error::request(format!("the input `{name}` is named twice"), "name it once"));
        }
        places.push(at);
    }
    Ok(places)
}
