//! A mechanism near a steady motion: its linear system, its modes, and what they say.

use super::Question;
use super::control::{Transfer, reached, stands_still, transfers};
use super::dense::Wide;
use super::eigen::{Mode, modes};
use super::newton::{Steady, Unknowns};
use super::quotient::Quotient;
use crate::{Error, Mechanism};
use nalgebra::DMatrix;
use tripos_derive::algebra::modular::{ZeroTest, zero_test};
use tripos_derive::scene::Asked;

/// What eigenvalues say of a steady motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stability {
    /// Some differences grow.
    Unstable,
    /// All differences die away.
    Attracting,
    /// All die away but those that lead to other motions of its family.
    AttractingInFamily,
    /// It is at rest at a strict minimum of the energy, and does not leave its neighbourhood (Lagrange, Dirichlet).
    Energy,
    /// None grows, some do not die away: what is of higher order decides.
    FirstOrder,
}

impl Stability {
    /// Its name in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Unstable => "unstable",
            Self::Attracting => "asymptotically stable",
            Self::AttractingInFamily => "stable in its family",
            Self::Energy => "stable",
            Self::FirstOrder => "stable to first order",
        }
    }

    /// What that means.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Unstable => "unstable: small differences grow",
            Self::Attracting => "asymptotically stable: small differences die away",
            Self::AttractingInFamily => {
                "stable: small differences die away, but for those that lead to other motions of its family"
            }
            Self::Energy => "stable: the energy is a strict minimum there",
            Self::FirstOrder => {
                "stable to first order: nothing grows, some of it does not die away, and terms of higher order decide"
            }
        }
    }
}

/// A linear system near a steady motion.
#[derive(Clone, Debug)]
pub struct About {
    /// Names of all states of the mechanism: coordinates, then speeds.
    pub all: Vec<String>,
    /// Where it is.
    pub steady: Steady,
    /// What the motion goes along, and how fast: a rate for each symmetry.
    pub moves: Vec<(String, f64)>,
    /// Names of the inputs.
    pub inputs: Vec<String>,
    /// Names of the outputs.
    pub outputs: Vec<String>,
    /// The system.
    pub system: Quotient,
    /// Its eigenvalues.
    pub modes: Vec<Mode>,
    /// What they say.
    pub stability: Stability,
    /// Names of states that tell the steady motions of its family from one another, as many as it has parameters.
    pub family: Vec<String>,
    /// Dimensions that the inputs reach.
    pub controllable: usize,
    /// Dimensions that the outputs show.
    pub observable: usize,
    /// Each input to each output.
    pub transfers: Vec<Transfer>,
}

/// What is asked of a linearisation.
#[derive(Clone, Debug, Default)]
pub struct Wanted {
    /// Inputs, by name: inputs of the model, or parameters. All inputs of the model if none is given.
    pub inputs: Vec<String>,
    /// Whether states that symmetries shift are kept.
    pub whole: bool,
    /// Whether a state that is not steady is taken as it is, with the loops closed by the coordinates that are sought.
    pub as_is: bool,
}

/// Linearises a mechanism about a steady motion: the state that is asked about, with what is sought of it solved for.
///
/// # Errors
/// [`Error`] if the model cannot be derived or has not such inputs, if the state is not steady and none is near it that could be, and
/// if it is singular.
pub fn linearise(model: &Mechanism, asked: &Asked, wanted: &Wanted) -> Result<About, Error> {
    let mut question = Question::new(model, asked, &wanted.inputs)?;
    let unknowns = Unknowns { states: asked.sought.clone(), moves: true };
    let mut steady = question.settle(&asked.x, &unknowns);
    if !steady.is_steady() {
        if !wanted.as_is {
            return Err(question.unbalanced(&steady));
        }
        steady = question.as_it_is(model, asked)?;
    }
    question.about(model, steady, wanted.whole)
}

impl Question {
    /// The linear system near a steady motion, with all that is said of it; `whole` keeps what symmetries shift.
    ///
    /// # Errors
    /// [`Error::Stopped`] in a singular pose, and where a slope has no value.
    pub fn about(&mut self, model: &Mechanism, steady: Steady, whole: bool) -> Result<About, Error> {
        let system = self.quotient(&steady, whole)?;
        let modes = modes(&system.a)?;
        let [a, b, c, d] = [&system.a, &system.b, &system.c, &system.d].map(Wide::rounded);
        let still = stands_still(&a);
        let family: Vec<String> = leading(&still).iter().map(|at| self.names[system.kept[*at]].clone()).collect();
        let stability = self.stability(&steady, &system, &modes, family.len());
        Ok(About {
            controllable: reached(&a, &b),
            observable: reached(&a.transpose(), &c.transpose()),
            transfers: transfers(&a, &b, &c, &d),
            all: self.names.clone(),
            moves: self.moves(model, &steady),
            inputs: self.inputs.iter().map(|at| model.parameters[*at].name.clone()).collect(),
            outputs: self.outputs.clone(),
            steady,
            system,
            modes,
            stability,
            family,
        })
    }
}

/// Rows of a matrix by which its columns are told from one another, the largest first.
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
    /// Why a state is not steady.
    #[must_use]
    pub fn unbalanced(&self, steady: &Steady) -> Error {
        let rates = steady.unbalanced.iter().map(|(at, left)| format!("{}' is left at {left:.6e}", self.names[*at]));
        let open = steady.open.iter().map(|(at, left)| format!("`{}` is open by {left:.6e}", self.loops[*at]));
        let list: Vec<String> = open.chain(rates).collect();
        let list = if list.is_empty() { "a rate is not a number there".to_owned() } else { list.join(", ") };
        Error::Request {
            what: format!("the state is not an equilibrium, nor carried along by a symmetry: {list}"),
            help: "put what may change under [guess], or ask `tripos equilibria` for what is near".to_owned(),
        }
    }

    /// What a motion goes along, where it goes.
    fn moves(&self, model: &Mechanism, steady: &Steady) -> Vec<(String, f64)> {
        let all = self.flow.symmetries.iter().zip(&steady.along);
        let all = all.map(|(symmetry, c)| (symmetry.words(model), c.hi()));
        all.filter(|(_, c)| c.abs() > super::newton::BALANCED).collect()
    }

    /// What the eigenvalues say of a motion whose family has so many parameters.
    fn stability(&mut self, steady: &Steady, system: &Quotient, modes: &[Mode], family: usize) -> Stability {
        let grows = modes.iter().any(|mode| mode.value[0] > mode.margin());
        let neutral = modes.iter().filter(|mode| mode.value[0].abs() <= mode.margin()).count();
        match (grows, neutral) {
            (true, _) => Stability::Unstable,
            (false, 0) => Stability::Attracting,
            (false, neutral) if neutral == family => Stability::AttractingInFamily,
            _ if self.is_least(steady, system, modes) => Stability::Energy,
            _ => Stability::FirstOrder,
        }
    }

    /// Whether a mechanism without friction, drive and gyroscopic forces rests at a strict minimum of its potential: there, and only
    /// there, all of its eigenvalues are imaginary and none is 0.
    fn is_least(&mut self, steady: &Steady, system: &Quotient, modes: &[Mode]) -> bool {
        let [_, _, power] = self.flow.energies;
        let power = self.flow.behind(&[power]);
        let is_conservative = zero_test(&self.flow.arena, power[0]) == ZeroTest::Zero;
        let speeds: Vec<usize> = (0..system.kept.len()).filter(|at| system.kept[*at] >= self.coordinates).collect();
        let among = system.a.part(&speeds, &speeds);
        let size = system.a.rounded().norm();
        let gyroscopic = among.rows.iter().flatten().any(|x| x.hi().abs() > 1e-12 * size);
        let oscillates = modes.iter().all(|mode| mode.value[1].abs() > (10.0 * mode.error).max(1e-9));
        steady.is_rest() && is_conservative && !gyroscopic && oscillates
    }
}
