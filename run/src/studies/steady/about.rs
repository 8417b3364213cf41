//! Linear system of a mechanism near a steady motion, with its modes and stability.

use super::Question;
use super::control::{Transfer, reached, transfers};
use super::dense::Wide;
use super::eigen::modes;
use super::mode::Mode;
use super::newton::{Steady, Unknowns};
use super::quotient::{Quotient, Shifted};
use super::verdict::Stability;
use crate::{Error, Mechanism};
use nalgebra::DMatrix;
use tripos_derive::plain::significant;
use tripos_derive::scene::Asked;

/// Linear system near a steady motion, with its eigenvalues, stability and transfer functions.
#[derive(Clone, Debug)]
pub struct About {
    /// Names of all states of the mechanism: coordinates, followed by generalized speeds.
    pub all: Vec<String>,
    /// Index of the time t among the states; `None` if the model does not name the time.
    pub time: Option<usize>,
    /// Steady motion about which the mechanism is linearised.
    pub steady: Steady,
    /// Symmetries along which the steady motion moves, each as a description and a rate.
    pub moves: Vec<(String, f64)>,
    /// Names of the inputs of the linear system.
    pub inputs: Vec<String>,
    /// Names of the outputs of the linear system.
    pub outputs: Vec<String>,
    /// Matrices of the linear system, and the states that they refer to.
    pub system: Quotient,
    /// Eigenvalues of the matrix A, with their multiplicities and errors.
    pub modes: Vec<Mode>,
    /// Stability of the steady motion, judged by the eigenvalues.
    pub stability: Stability,
    /// Names of the states that distinguish the neighbouring steady motions, as many as their family
    /// has parameters. Empty if no neighbouring steady motions were found.
    pub family: Vec<String>,
    /// Number of independent directions that the matrix A maps to zero.
    pub still: usize,
    /// Dimension of the subspace of states that the inputs can reach.
    pub controllable: usize,
    /// Dimension of the space of states that the outputs can distinguish.
    pub observable: usize,
    /// Transfer functions of the linear system from each input to each output.
    pub transfers: Vec<Transfer>,
}

impl About {
    /// Iterates over the names and values of coordinates and speeds in the steady motion; the time is
    /// left out.
    pub fn states(&self) -> impl Iterator<Item = (&str, f64)> + '_ {
        let all = self.all.iter().zip(&self.steady.x).enumerate().filter(|(at, _)| Some(*at) != self.time);
        all.map(|(_, (name, x))| (name.as_str(), x.hi()))
    }
}

/// Options of a linearisation about a steady motion.
#[derive(Clone, Debug, Default)]
pub struct Wanted {
    /// Names of the inputs of the linear system: inputs or other parameters of the model. If empty, all
    /// inputs of the model.
    pub inputs: Vec<String>,
    /// True if states that a symmetry shifts, such as cyclic coordinates, stay in the linear system.
    pub whole: bool,
    /// True if a state that is not steady is accepted too. Only its loops are then closed, by the
    /// sought coordinates.
    pub as_is: bool,
}

/// Advice for the user if the state is not steady.
const ASK: &str =
    "put the values that may change under [guess], or let `tripos equilibria` find a steady motion nearby";

/// Linearises a mechanism about a steady motion near the requested state; the sought states are
/// solved for.
///
/// # Errors
/// [`Error`] if the model cannot be derived or lacks an input, or if the state is singular.
/// [`Error`] also if no steady state is found near the requested state, unless the options accept
/// this.
pub fn linearise(model: &Mechanism, asked: &Asked, wanted: &Wanted) -> Result<About, Error> {
    let mut question = Question::new(model, asked, &wanted.inputs)?;
    let unknowns = Unknowns { states: asked.sought.clone(), moves: true };
    let mut steady = question.settle(&asked.x, &unknowns);
    if !steady.is_steady() {
        if !wanted.as_is {
            return Err(question.unbalanced(&steady, ASK));
        }
        steady = question.as_it_is(model, asked)?;
    }
    let shifted = if wanted.whole { Shifted::Kept } else { Shifted::LeftOut };
    question.about(model, steady, shifted)
}

/// Choice to search for steady motions beside a steady motion (its family), or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Family {
    /// Neighbouring steady motions are searched for.
    Sought,
    /// Neighbouring steady motions are not searched for.
    LeftOut,
}

impl Question {
    /// Computes the linear system near a steady motion, with its modes and stability. `shifted` tells
    /// if the states that symmetries shift stay in the system.
    ///
    /// # Errors
    /// [`Error::Stopped`] if loops are dependent in this pose, or a slope has no finite value.
    /// `Error::Request` if the equations are singular at the state.
    pub fn about(&mut self, model: &Mechanism, steady: Steady, shifted: Shifted) -> Result<About, Error> {
        self.about_in(model, steady, shifted, Family::Sought)
    }

    /// Computes the linear system near a steady motion, with or without a search for neighbouring
    /// steady motions.
    ///
    /// # Errors
    /// `Error::Stopped` for a singular pose or a slope without value; `Error::Request` for singular
    /// equations.
    pub(super) fn about_in(
        &mut self,
        model: &Mechanism,
        steady: Steady,
        shifted: Shifted,
        family: Family,
    ) -> Result<About, Error> {
        self.poles.refuse(&self.parameters, &steady)?;
        let system = self.quotient(&steady, shifted)?;
        let [a, b, c] = [&system.a, &system.b, &system.c].map(Wide::rounded);
        let modes = modes(&system.a, steady.uncertain + steady.residual / a.norm().max(1.0))?;
        let still = modes.iter().find(|mode| mode.value.iter().all(|x| x.abs() <= 0.0)).map_or(0, |mode| mode.vectors);
        let sought = if family == Family::Sought { still } else { 0 };
        let beside = self.family_directions(&steady, &system, sought);
        let family: Vec<String> = leading(&beside).iter().map(|at| self.names[system.kept[*at]].clone()).collect();
        let stability = self.stability(&steady, &system, &modes, family.len());
        Ok(About {
            controllable: reached(&a, &b),
            observable: reached(&a.transpose(), &c.transpose()),
            transfers: transfers(&system.a, &system.b, &system.c, &system.d)?,
            all: self.names.clone(),
            time: self.time,
            moves: self.moves(model, &steady),
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

/// Indices, in ascending order, of rows that distinguish the columns of a matrix, as many as
/// columns. Rows with large entries are preferred.
fn leading(columns: &DMatrix<f64>) -> Vec<usize> {
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

impl Question {
    /// Error that lists why a state is not steady: rates, forces and open loops. `help` is the advice
    /// to the user.
    #[must_use]
    pub fn unbalanced(&self, steady: &Steady, help: &str) -> Error {
        let rates = steady
            .unbalanced
            .iter()
            .map(|(at, left)| format!("{}' is left at {}", self.names[*at], significant(*left, 4)));
        let open =
            steady.open.iter().map(|(at, left)| format!("`{}` is open by {}", self.loops[*at], significant(*left, 4)));
        let forces = steady.forces.iter();
        let forces = forces
            .map(|(at, left)| format!("the force along {} is left at {}", self.names[*at], significant(*left, 4)));
        let list: Vec<String> = open.chain(rates).chain(forces).collect();
        let list = if list.is_empty() { "a rate is not a number there".to_owned() } else { list.join(", ") };
        Error::Request {
            what: format!("the state is not an equilibrium, nor carried along by a symmetry: {list}"),
            help: help.to_owned(),
        }
    }

    /// Symmetries along which a steady motion moves, each as a description and a rate; the shift of
    /// time is left out.
    fn moves(&self, model: &Mechanism, steady: &Steady) -> Vec<(String, f64)> {
        let all = self.flow.symmetries.iter().zip(&steady.along).enumerate();
        let all = all.filter(|(at, _)| Some(*at) != self.by_time);
        let all = all.map(|(_, (symmetry, c))| (symmetry.words(model), c.hi()));
        all.filter(|(_, c)| c.abs() > super::newton::BALANCED).collect()
    }
}
