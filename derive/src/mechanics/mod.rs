//! Equations of motion by three methods that share nothing but the kinematics.

mod accelerations;
mod distance;
mod energy;
mod inertia;
mod kane;
mod kinematics;
mod lagrange;
mod newton_euler;
mod quantities;
mod vector;

pub use accelerations::{Jacobian, Solved, accelerations, energy_gradient, jacobian};
pub(crate) use distance::visit;
pub use distance::{Distance, distances, in_distance};
pub use energy::Momentum;
pub use inertia::{InertiaCheck, has_inertia_at};
pub use kinematics::{Kinematics, Load, Velocities, motion_rates, rates_to_speeds, speeds_to_rates};
pub use lagrange::generalized_forces;
pub use newton_euler::{Balance, balances, partial_velocities};
pub use quantities::{Energy, Owner, Quantities, Quantity, QuantityError, QuantityKind, Row, VectorName};
pub use vector::{Frames, Vector};

use crate::algebra::steps::Definition;
use crate::algebra::{Arena, Expr};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::Model;
use std::fmt;

/// A method of derivation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Formulation {
    /// Kane's method.
    Kane,
    /// Lagrange's equations.
    Lagrange,
    /// Newton's and Euler's equations of each body.
    NewtonEuler,
}

impl Formulation {
    /// All of them, in the order in which they are always listed.
    pub const ALL: [Self; 3] = [Self::Kane, Self::Lagrange, Self::NewtonEuler];

    /// The name on the command line and in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Kane => "kane",
            Self::Lagrange => "lagrange",
            Self::NewtonEuler => "newton-euler",
        }
    }

    /// The name in a heading.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Kane => "Kane's method",
            Self::Lagrange => "Lagrange's equations",
            Self::NewtonEuler => "Newton–Euler equations",
        }
    }
}

/// A stage of a derivation, to be shown: named quantities and their values.
#[derive(Clone, Debug)]
pub struct Step {
    /// What it gives.
    pub title: String,
    /// (name, value)
    pub lines: Vec<(String, Expr)>,
}

/// Equations of motion  matrix · unknowns = forcing,  q̇ = `coordinate_rates`.
#[derive(Clone, Debug)]
pub struct Equations {
    /// What they are called on the command line and in files: `kane`, or `printed:ID` for printed ones.
    pub name: String,
    /// What they are called in a heading.
    pub title: String,
    /// The method they come from; it tells what the motion variables are.
    pub formulation: Formulation,
    /// Symbols that stand for terms in parameters, q and v in everything below, each after those that it mentions: none but in
    /// reduced equations.
    pub definitions: Vec<Definition>,
    /// The generalized coordinates q, or the distance that stands for one ([`in_distance`]).
    pub coordinates: Vec<Expr>,
    /// The motion variables v that are integrated beside q: u, or q̇ for Lagrange.
    pub variables: Vec<Expr>,
    /// Their time derivatives, then the reactions.
    pub unknowns: Vec<Expr>,
    /// What each row balances.
    pub rows: Vec<String>,
    /// Square; in parameters, q and v.
    pub matrix: Vec<Vec<Expr>>,
    /// One entry a row; in parameters, q and v.
    pub forcing: Vec<Expr>,
    /// Whether the matrix is symmetric by construction, and positive definite where it is regular.
    pub symmetric: bool,
    /// Multipliers of the rows, one list for each motion variable, under which the reactions cancel and a
    /// symmetric, positive definite system is left: the partial velocities. Empty without reactions.
    pub projection: Vec<Vec<Expr>>,
    /// q̇ in q and v.
    pub coordinate_rates: Vec<Expr>,
    /// u in q and v.
    pub generalized_speeds: Vec<Expr>,
    /// u̇ in q, v and v̇.
    pub generalized_speed_rates: Vec<Expr>,
    /// v in q and u.
    pub motion_variables: Vec<Expr>,
    /// T in q and v.
    pub kinetic_energy: Expr,
    /// V in q.
    pub potential_energy: Expr,
    /// Expressions in q that the kinematic equations divide by.
    pub divisors: Vec<Expr>,
}

/// Why a formulation cannot be derived.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DeriveError {
    /// The inertia of a body, stated in a frame that the body turns in, is not constant in the body.
    InertiaNotConstant {
        /// The body.
        body: String,
        /// The frame its inertia is stated in.
        frame: String,
        /// The body's own frame.
        body_frame: String,
    },
    /// A reaction does work in a permitted motion.
    ReactionWorks {
        /// The reaction.
        reaction: String,
        /// The rate of a coordinate, or the speed, that it works along.
        motion: String,
        /// The power for each unit of that.
        rate: String,
    },
    /// The direction of a reaction has another length than 1, so its value would not be the force.
    DirectionNotUnit {
        /// The reaction.
        reaction: String,
        /// The square of the length.
        square: String,
    },
    /// The potential energy has no value where the model puts its zero.
    NoZeroOfPotential {
        /// The term that divides by zero.
        term: String,
    },
    /// A speed moves no mass: the mass matrix has a zero row.
    NoInertia {
        /// The speed.
        speed: String,
    },
    /// At the values of a scene a speed moves no mass.
    NoInertiaAt {
        /// The speed.
        speed: String,
        /// The parameters that are 0 there.
        zero: Vec<String>,
    },
    /// An acceleration did not come out linear: cannot happen for a checked model.
    NotLinear,
    /// Newton–Euler needs as many reactions as there are equations left.
    ReactionCount {
        /// Equations that are not 0 = 0.
        equations: usize,
        /// Generalized speeds.
        speeds: usize,
        /// Reactions named.
        reactions: usize,
        /// Equations of all bodies: as many reactions as speeds leave over of these can be needed, and no more.
        all: usize,
    },
    /// The reactions named are not independent: they cannot be told apart.
    ReactionsDependent,
    /// Lagrange's equations of coordinates that a motion constraint ties together need a multiplier.
    MotionConstraint {
        /// The constraint.
        constraint: String,
    },
    /// A torque on a frame without a body: no moment balance holds it.
    TorqueOnNothing {
        /// The torque.
        torque: String,
    },
    /// A scene's own equations are not known to give what the model's give.
    ReductionNotProved {
        /// What is not known.
        what: String,
    },
}

impl DeriveError {
    /// Whether the model is right and only this formulation cannot be had.
    #[must_use]
    pub fn is_unsupported(&self) -> bool {
        matches!(
            self,
            Self::ReactionCount { .. }
                | Self::ReactionsDependent
                | Self::MotionConstraint { .. }
                | Self::TorqueOnNothing { .. }
        )
    }

    /// The name in the model file that it is about, and what to do.
    fn place_and_help(&self) -> (Option<&str>, &'static str) {
        match self {
            Self::InertiaNotConstant { body, .. } => (
                Some(body),
                "state the inertia in the body's frame, or in one that it turns in about an axis of symmetry",
            ),
            Self::ReactionWorks { reaction, .. } => (
                Some(reaction),
                "a reaction acts where and along what its constraint forbids; a force that works is an applied force",
            ),
            Self::DirectionNotUnit { reaction, .. } => {
                (Some(reaction), "divide the direction by its length, as in [\"sqrt(1/2)\", \"sqrt(1/2)\", 0]")
            }
            Self::NoZeroOfPotential { .. } => {
                (None, "give every coordinate that divides a value in `zero_at`, or leave `zero_at` out")
            }
            Self::NoInertia { speed } => {
                (Some(speed.trim_end_matches('\'')), "give mass to what moves with it, or leave the coordinate out")
            }
            Self::NoInertiaAt { speed, .. } => {
                (Some(speed), "give mass to what moves with it, or leave the coordinate out of the model")
            }
            Self::NotLinear => (None, "this is a defect of the program: please report the model"),
            Self::ReactionCount { .. } => (
                None,
                "name in [reactions] every force and torque that each joint exerts, along every direction and axis that it prevents, or use kane or lagrange",
            ),
            Self::ReactionsDependent => (
                None,
                "let each constraint be enforced by one reaction along its own direction, or use kane or lagrange",
            ),
            Self::MotionConstraint { constraint } => (Some(constraint), "use kane, which needs no multiplier"),
            Self::TorqueOnNothing { torque } => (Some(torque), "let it act on a rigid body, or use kane or lagrange"),
            Self::ReductionNotProved { .. } => (None, "run the scene by one of the model's formulations"),
        }
    }
}

impl std::error::Error for DeriveError {}

impl fmt::Display for DeriveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::InertiaNotConstant { body, frame, body_frame } => {
                write!(f, "the inertia of `{body}` is constant in `{frame}` but not in its own frame `{body_frame}`")
            }
            Self::ReactionWorks { reaction, motion, rate } => {
                let along = motion.trim_end_matches('\'');
                write!(f, "the reaction `{reaction}` works along `{along}`: power {rate} for each unit of {motion}")
            }
            Self::DirectionNotUnit { reaction, square } => {
                write!(f, "the direction of `{reaction}` is no unit vector: the square of its length is {square}")
            }
            Self::NoZeroOfPotential { term } => {
                write!(
                    f,
                    "the potential energy has no value where `zero_at` puts its zero: {term} divides by zero there"
                )
            }
            Self::NoInertia { speed } => {
                write!(f, "`{speed}` moves no mass of its own: the mass matrix is singular in every configuration")
            }
            Self::NoInertiaAt { speed, zero } => {
                let zero: Vec<String> = zero.iter().map(|name| format!("{name} = 0")).collect();
                let zero = zero.join(" and ");
                write!(
                    f,
                    "`{speed}` moves no mass of its own where {zero}: the mass matrix is singular in every configuration"
                )
            }
            Self::NotLinear => write!(f, "the equations are not linear in the accelerations"),
            Self::ReactionCount { equations, speeds, reactions, all } => {
                let needed = equations.saturating_sub(*speeds);
                let plural = |n: usize, what: &str| if n == 1 { format!("1 {what}") } else { format!("{n} {what}s") };
                write!(
                    f,
                    "newton-euler has {equations} equations for {} unknowns, {} and {}: {} needed{}",
                    speeds + reactions,
                    plural(*speeds, "speed"),
                    plural(*reactions, "reaction"),
                    if needed == 1 { "1 reaction is".to_owned() } else { format!("{needed} reactions are") },
                    if equations == all {
                        String::new()
                    } else {
                        format!(
                            " of those that keep these equations; each may bring another equation into play, up to {} reactions when all {all} are",
                            all.saturating_sub(*speeds)
                        )
                    }
                )
            }
            Self::ReactionsDependent => {
                write!(f, "newton-euler is not possible: its equations do not determine the reactions one by one")
            }
            Self::MotionConstraint { constraint } => {
                write!(f, "lagrange is not possible: the motion constraint `{constraint}` needs a multiplier")
            }
            Self::TorqueOnNothing { torque } => {
                write!(f, "newton-euler is not possible: the torque `{torque}` acts on a frame without a body")
            }
            Self::ReductionNotProved { what } => write!(f, "the reduced equations of the scene are not proved: {what}"),
        }
    }
}

impl Model {
    /// The same error with its place in the model file.
    #[must_use]
    pub fn diagnose(&self, error: &DeriveError) -> Diagnostics {
        let (name, help) = error.place_and_help();
        let span = name.and_then(|n| self.declared.get(n).cloned());
        let diagnostic = Diagnostic { message: error.to_string(), span, other: None, help: Some(help.to_owned()) };
        Diagnostics::new(self.source.clone(), vec![diagnostic])
    }
}

/// One formulation of a model, with the store of its terms.
#[derive(Clone)]
pub struct Derivation {
    /// The terms of `equations`.
    pub arena: Arena,
    /// The equations.
    pub equations: Equations,
}

/// One formulation of a model as a textbook shows it, with the store of its terms.
#[derive(Clone)]
pub struct DerivationInSteps {
    /// The terms of `equations` and `steps`.
    pub arena: Arena,
    /// The equations.
    pub equations: Equations,
    /// What they come from, in order.
    pub steps: Vec<Step>,
}

/// All formulations of a model over one store of terms, so that they can be compared.
pub struct Derivations {
    /// The kinematics that they share, with the store of all terms.
    pub kinematics: Kinematics,
    /// Each formulation, or why this one cannot be had.
    pub list: Vec<(Formulation, Result<Equations, DeriveError>)>,
}

impl Derivations {
    /// The equations by one method, if it is possible.
    #[must_use]
    pub fn get(&self, formulation: Formulation) -> Option<&Equations> {
        self.list.iter().find(|(f, _)| *f == formulation).and_then(|(_, equations)| equations.as_ref().ok())
    }
}

/// Derives the equations of motion of a model.
///
/// # Errors
/// [`DeriveError`]; ask [`DeriveError::is_unsupported`] whether another formulation may succeed.
pub fn derive(model: &Model, formulation: Formulation) -> Result<Derivation, DeriveError> {
    let mut kinematics = Kinematics::new(model)?;
    let equations = derive_with(model, &mut kinematics, formulation)?;
    Ok(Derivation { arena: kinematics.arena, equations })
}

/// Derives the equations of motion of a model, and shows what they come from, step by step.
///
/// # Errors
/// As [`derive()`].
pub fn derive_in_steps(model: &Model, formulation: Formulation) -> Result<DerivationInSteps, DeriveError> {
    let mut kinematics = Kinematics::new(model)?;
    let equations = derive_with(model, &mut kinematics, formulation)?;
    let steps = match formulation {
        Formulation::Kane => kane::steps(model, &mut kinematics),
        Formulation::Lagrange => lagrange::steps(model, &mut kinematics)?,
        Formulation::NewtonEuler => newton_euler::steps(model, &mut kinematics),
    };
    Ok(DerivationInSteps { arena: kinematics.arena, equations, steps })
}

/// Derives the equations of motion of a model by every method.
///
/// # Errors
/// [`DeriveError`] if the model is wrong; a formulation that this model does not support is listed with its reason.
pub fn derive_all(model: &Model) -> Result<Derivations, DeriveError> {
    let mut kinematics = Kinematics::new(model)?;
    let mut list = Vec::new();
    for f in Formulation::ALL {
        match derive_with(model, &mut kinematics, f) {
            Err(error) if !error.is_unsupported() => return Err(error),
            result => list.push((f, result)),
        }
    }
    Ok(Derivations { kinematics, list })
}

fn derive_with(model: &Model, kinematics: &mut Kinematics, formulation: Formulation) -> Result<Equations, DeriveError> {
    let equations = match formulation {
        Formulation::Kane => kane::derive(model, kinematics),
        Formulation::Lagrange => lagrange::derive(model, kinematics),
        Formulation::NewtonEuler => newton_euler::derive(model, kinematics),
    }?;
    let rank = crate::algebra::rank::rank(&kinematics.arena, &equations.matrix);
    match rank.and_then(|r| r.dependent) {
        Some(row) => Err(singular(model, formulation, row)),
        None => Ok(equations),
    }
}

/// The matrix is singular in every configuration: a row follows from those before it.
fn singular(model: &Model, formulation: Formulation, row: usize) -> DeriveError {
    match formulation {
        Formulation::Kane => DeriveError::NoInertia { speed: model.speeds[row].name.clone() },
        Formulation::Lagrange => DeriveError::NoInertia { speed: format!("{}'", model.coordinates[row].name) },
        Formulation::NewtonEuler => DeriveError::ReactionsDependent,
    }
}

fn kinematic_step(model: &Model) -> Step {
    let rates = model.coordinates.iter().zip(&model.kinematic_equations.rates);
    let mut lines: Vec<_> = model.speeds.iter().map(|s| (s.name.clone(), s.definition)).collect();
    lines.extend(rates.map(|(c, e)| (format!("{}'", c.name), *e)));
    Step { title: "Generalized speeds and kinematic equations".to_owned(), lines }
}
