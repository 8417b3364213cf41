//! Linear system of a mechanism near a steady motion, with its modes and stability.

use super::SteadyProblem;
use super::quotient_system::{QuotientSystem, ShiftedStates};
use super::spectra::controllability::{TransferFunction, controllable_dimension, transfer_functions};
use super::spectra::eigenvalues::eigenvalue_modes;
use super::spectra::mode::Mode;
use super::spectra::wide_matrix::WideMatrix;
use super::stability::Stability;
use super::steady_newton::Unknowns;
use super::steady_state::SteadyState;
use crate::{Error, Mechanism};
use nalgebra::DMatrix;
use tripos_derive::plain_text::with_significant_digits;
use tripos_derive::scene::StateWithUnknowns;

/// Linear system near a steady motion, with its eigenvalues, stability and transfer functions.
#[derive(Clone, Debug)]
pub struct SteadyLinearSystem {
    /// Names of all states of the mechanism: coordinates, followed by generalized speeds.
    pub all: Vec<String>,
    /// Index of the time t among the states; `None` if the model does not name the time.
    pub time: Option<usize>,
    /// Steady motion near which the mechanism is linearised.
    pub steady: SteadyState,
    /// Symmetries along which the steady motion moves, each as a description and a rate.
    pub moves: Vec<(String, f64)>,
    /// Names of the inputs of the linear system.
    pub inputs: Vec<String>,
    /// Names of the outputs of the linear system.
    pub outputs: Vec<String>,
    /// Matrices of the linear system, and the indices of its states.
    pub system: QuotientSystem,
    /// Eigenvalues of the matrix A, with their multiplicities and errors.
    pub modes: Vec<Mode>,
    /// Stability of the steady motion, judged by the eigenvalues.
    pub stability: Stability,
    /// Names of states whose values tell the neighbouring steady motions apart. Their number is the number
    /// of parameters of the family of steady motions. Empty if no neighbouring steady motions were found.
    pub family: Vec<String>,
    /// Number of independent directions of states that the matrix A maps to zero.
    pub still: usize,
    /// Dimension of the subspace of states that the inputs can reach.
    pub controllable: usize,
    /// Dimension of the space of states that the outputs can distinguish.
    pub observable: usize,
    /// Transfer functions of the linear system from each input to each output.
    pub transfers: Vec<TransferFunction>,
}

impl SteadyLinearSystem {
    /// Iterates over the coordinates and speeds of the steady motion, each as name and value. The time is
    /// left out.
    pub fn states(&self) -> impl Iterator<Item = (&str, f64)> + '_ {
        let all = self.all.iter().zip(&self.steady.x).enumerate().filter(|(at, _)| Some(*at) != self.time);
        all.map(|(_, (name, x))| (name.as_str(), x.hi()))
    }
}

/// Options of a linearisation near a steady motion.
#[derive(Clone, Debug, Default)]
pub struct LinearisationOptions {
    /// Names of the inputs of the linear system: inputs or other parameters of the model. If the list is
    /// empty, all inputs of the model are taken.
    pub inputs: Vec<String>,
    /// True if states that a symmetry shifts, such as cyclic coordinates, stay in the linear system.
    pub whole: bool,
    /// True if a state that is not steady is accepted too. Its loops are then closed by changing the
    /// unknown coordinates, and nothing else is solved for.
    pub as_is: bool,
}

/// Advice to the user if the state is not steady.
const ASK: &str =
    "put the values that may change under [guess], or let `tripos equilibria` find a steady motion nearby";

/// Linearises a mechanism near a steady motion at the requested state. The unknown states of the request
/// are solved for.
///
/// # Errors
/// [`Error`] if the model cannot be derived or lacks a named input, or if the state is singular. Also if
/// no steady state is found near the requested state, unless the options accept this.
pub fn linearise(
    model: &Mechanism,
    asked: &StateWithUnknowns,
    wanted: &LinearisationOptions,
) -> Result<SteadyLinearSystem, Error> {
    let mut question = SteadyProblem::new(model, asked, &wanted.inputs)?;
    let unknowns = Unknowns { states: asked.sought.clone(), moves: true };
    let mut steady = question.find_steady_state(&asked.x, &unknowns);
    if !steady.is_steady() {
        if !wanted.as_is {
            return Err(question.not_steady_error(&steady, ASK));
        }
        steady = question.accept_state(model, asked)?;
    }
    let shifted = if wanted.whole { ShiftedStates::Kept } else { ShiftedStates::LeftOut };
    question.linear_system_near(model, steady, shifted)
}

/// Choice if the steady motions beside a steady motion (its family) are searched for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FamilySearch {
    /// Neighbouring steady motions are searched for.
    Sought,
    /// Neighbouring steady motions are not searched for.
    LeftOut,
}

impl SteadyProblem {
    /// Computes the linear system near a steady motion, with its modes and stability. `shifted` tells
    /// if the states that symmetries shift stay in the system.
    ///
    /// # Errors
    /// [`Error::Stopped`] if loops are dependent in this pose, or if a slope is not finite.
    /// `Error::Request` if the equations are singular at the state.
    pub fn linear_system_near(
        &mut self,
        model: &Mechanism,
        steady: SteadyState,
        shifted: ShiftedStates,
    ) -> Result<SteadyLinearSystem, Error> {
        self.linear_system_with_family(model, steady, shifted, FamilySearch::Sought)
    }

    /// Computes the linear system near a steady motion, with its modes and stability. `family` tells if
    /// neighbouring steady motions are searched for.
    ///
    /// # Errors
    /// `Error::Stopped` if loops are dependent in this pose, or if a slope is not finite.
    /// `Error::Request` if the equations are singular at the state.
    pub(super) fn linear_system_with_family(
        &mut self,
        model: &Mechanism,
        steady: SteadyState,
        shifted: ShiftedStates,
        family: FamilySearch,
    ) -> Result<SteadyLinearSystem, Error> {
        self.poles.refuse_singular_state(&self.parameters, &steady)?;
        let system = self.quotient(&steady, shifted)?;
        let [a, b, c] = [&system.a, &system.b, &system.c].map(WideMatrix::rounded);
        let modes = eigenvalue_modes(&system.a, steady.uncertain + steady.residual / a.norm().max(1.0))?;
        let still = modes.iter().find(|mode| mode.value.iter().all(|x| x.abs() <= 0.0)).map_or(0, |mode| mode.vectors);
        let sought = if family == FamilySearch::Sought { still } else { 0 };
        let beside = self.family_directions(&steady, &system, sought);
        let family: Vec<String> =
            distinguishing_rows(&beside).iter().map(|at| self.names[system.kept[*at]].clone()).collect();
        let stability = self.judge_stability(&steady, &system, &modes, family.len());
        Ok(SteadyLinearSystem {
            controllable: controllable_dimension(&a, &b),
            observable: controllable_dimension(&a.transpose(), &c.transpose()),
            transfers: transfer_functions(&system.a, &system.b, &system.c, &system.d)?,
            all: self.names.clone(),
            time: self.time,
            moves: self.motion_along_symmetries(model, &steady),
            inputs: self.inputs.iter().map(|at| model.parameters[*at].name.clone()).collect(),
            outputs: self.outputs.clone(),
            steady,
            system,
            modes,
            stability,
            family,
            still,
        })
    }
}

/// Chooses as many rows of a matrix as it has columns, so that these rows distinguish the columns. Rows
/// with large entries are preferred. Returns the indices in ascending order.
fn distinguishing_rows(columns: &DMatrix<f64>) -> Vec<usize> {
    let mut left = columns.clone();
    let mut rows = Vec::new();
    while rows.len() < left.ncols() {
        let row =
            left.row_iter().map(|row| row.norm()).enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |m| m.0);
        let direction = left.row(row).normalize();
        left -= &left * direction.transpose() * &direction;
        rows.push(row);
    }
    rows.sort_unstable();
    rows
}

impl SteadyProblem {
    /// Makes the error that lists why a state is not steady: rates, forces and open loops that are left.
    /// `help` is the advice to the user.
    #[must_use]
    pub fn not_steady_error(&self, steady: &SteadyState, help: &str) -> Error {
        let rates = steady
            .unbalanced
            .iter()
            .map(|(at, left)| format!("{}' is left at {}", self.names[*at], with_significant_digits(*left, 4)));
        let open = steady
            .open
            .iter()
            .map(|(at, left)| format!("`{}` is open by {}", self.loops[*at], with_significant_digits(*left, 4)));
        let forces = steady.forces.iter();
        let forces = forces.map(|(at, left)| {
            format!("the force along {} is left at {}", self.names[*at], with_significant_digits(*left, 4))
        });
        let list: Vec<String> = open.chain(rates).chain(forces).collect();
        let list = if list.is_empty() { "a rate is not a number there".to_owned() } else { list.join(", ") };
        Error::Request {
            what: format!("the state is not an equilibrium, nor carried along by a symmetry: {list}"),
            help: help.to_owned(),
        }
    }

    /// Symmetries along which a steady motion moves, each as a description and a rate. The shift of time is
    /// left out.
    fn motion_along_symmetries(&self, model: &Mechanism, steady: &SteadyState) -> Vec<(String, f64)> {
        let all = self.flow.symmetries.iter().zip(&steady.along).enumerate();
        let all = all.filter(|(at, _)| Some(*at) != self.by_time);
        let all = all.map(|(_, (symmetry, c))| (symmetry.words(model), c.hi()));
        all.filter(|(_, c)| c.abs() > super::steady_state::BALANCED).collect()
    }
}
