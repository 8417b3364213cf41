//! Reasons why the equations of a model cannot be derived, each with advice for the user.

use super::unsolved::Unsolved;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::Model;
use std::fmt;

/// Reason why equations of motion cannot be derived.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DeriveError {
    /// A body's inertia is stated in a frame that moves relative to the body, and is not constant in
    /// the body.
    InertiaNotConstant {
        /// Name of the body whose inertia is not constant.
        body: String,
        /// Name of the frame in which the model states the inertia.
        frame: String,
        /// Name of the frame that is fixed in the body.
        body_frame: String,
    },
    /// A reaction does work in a motion that the constraints permit.
    ReactionWorks {
        /// Name of the reaction that does work.
        reaction: String,
        /// Name of the generalized speed, or of a coordinate with a prime (its rate), along which the
        /// reaction does work.
        motion: String,
        /// Formula of the reaction's power for each unit of `motion`.
        rate: String,
    },
    /// A force or torque divides by a velocity that is zero at all times.
    LoadDividesByZero {
        /// Name of the force or torque that divides by zero.
        load: String,
        /// Formula that divides by zero after the velocities are substituted.
        term: String,
    },
    /// The direction of a reaction is not a unit vector, so the value of the reaction would not be the
    /// force.
    DirectionNotUnit {
        /// Name of the reaction whose direction is wrong.
        reaction: String,
        /// Formula of the squared length of the direction; it should be 1.
        square: String,
    },
    /// The potential energy has no value at the configuration `zero_at`, where the model sets the energy to zero.
    NoZeroOfPotential {
        /// Formula that divides by zero at the configuration `zero_at` of the model.
        term: String,
    },
    /// A generalized speed moves no mass: its row of the mass matrix is zero or depends on other rows.
    NoInertia {
        /// Name of the generalized speed that moves no mass, or of a coordinate with a prime (its rate).
        speed: String,
    },
    /// A generalized speed moves no mass at the parameter values of a scene, such as a zero mass.
    NoInertiaAt {
        /// Name of the generalized speed that moves no mass.
        speed: String,
        /// Names of the parameters that are 0 in the scene.
        zero: Vec<String>,
    },
    /// An acceleration does not enter the equations linearly. This is a defect of the program.
    NotLinear,
    /// The linear equations for the accelerations have no usable solution.
    Unsolved(Unsolved),
    /// The number of reactions is wrong for Newton–Euler: it must be the number of equations less that of speeds.
    ReactionCount {
        /// Number of Newton–Euler equations that are not 0 = 0.
        equations: usize,
        /// Number of generalized speeds of the model.
        speeds: usize,
        /// Number of reactions that the model has, stated or found by the program.
        reactions: usize,
        /// Number of balance equations of all bodies, including those that are 0 = 0. The model needs at most as many
        /// reactions as there are balance equations less speeds.
        all: usize,
        /// Components of balances that contain inertia or a load, one text for each body and kind: `disk force b1,
        /// b2`.
        felt: Vec<String>,
    },
    /// The Newton–Euler equations do not determine each reaction, because the reactions are linearly
    /// dependent.
    ReactionsDependent,
    /// The program found a reaction by itself but cannot show that this reaction does no work.
    ReactionNotShown {
        /// Name of the reaction that the program found.
        reaction: String,
    },
    /// A torque acts on a frame without a body, so that no body's moment balance contains it.
    TorqueOnNothing {
        /// Name of the torque without a body.
        torque: String,
    },
    /// A potential cannot be written as forces and torques between bodies, which Newton–Euler needs.
    PotentialOnNothing {
        /// Name of the potential in the model file.
        potential: String,
    },
    /// The model has more links, or the derivation more terms, than the limits allow.
    TooLarge {
        /// Number of bodies of the model.
        bodies: usize,
        /// Number of coordinates of the model.
        coordinates: usize,
        /// Number of links or terms that was counted.
        count: usize,
        /// Noun for the counted items in the message: links or terms.
        what: &'static str,
        /// Largest number of links or terms that is allowed.
        most: usize,
    },
    /// Parameters of a body cannot be identified, because the body has an added mass (of a surrounding fluid).
    AddedMass {
        /// Name of the body that has an added mass.
        body: String,
    },
    /// A mechanism with loops gets no reduced equations, because these would not keep its loops closed.
    LoopsReduced {
        /// Name of a loop of the mechanism.
        name: String,
    },
    /// A mechanism whose constraints leave no free speed gets no reduced equations.
    NothingMoves,
    /// The reduced equations of a scene could not be proved equivalent to the model's equations.
    ReductionNotProved {
        /// Statement about the reduced equations whose proof failed, in words.
        what: String,
    },
}

impl DeriveError {
    /// True if the model is right and only the chosen formulation cannot be derived for it.
    #[must_use]
    pub fn is_unsupported(&self) -> bool {
        matches!(
            self,
            Self::ReactionCount { .. }
                | Self::ReactionsDependent
                | Self::ReactionNotShown { .. }
                | Self::TorqueOnNothing { .. }
                | Self::PotentialOnNothing { .. }
        )
    }

    /// Name in the model file that the error is about, `None` if there is none, and advice for the user.
    fn place_and_advice_of_error(&self) -> (Option<&str>, &'static str) {
        match self {
            Self::InertiaNotConstant { body, .. } => (
                Some(body),
                "state the inertia in the body's frame, or in a frame in which the body turns about its axis of symmetry",
            ),
            Self::ReactionWorks { reaction, .. } => (
                Some(reaction),
                "a reaction acts at the constraint and along the forbidden motion; a force that does work is an applied force",
            ),
            Self::DirectionNotUnit { reaction, .. } => {
                (Some(reaction), "divide the direction by its length, as in [\"sqrt(1/2)\", \"sqrt(1/2)\", 0]")
            }
            Self::LoadDividesByZero { load, .. } => {
                (Some(load), "divide by what can differ from zero, such as the speed of a point that moves")
            }
            Self::NoZeroOfPotential { .. } => {
                (None, "give every coordinate that divides a value in `zero_at`, or leave `zero_at` out")
            }
            Self::NoInertia { speed } => (
                Some(speed.trim_end_matches('\'')),
                "give a mass to the bodies that move with the coordinate, or leave the coordinate out",
            ),
            Self::NoInertiaAt { speed, .. } => (
                Some(speed),
                "give a mass to the bodies that move with the coordinate, or leave the coordinate out of the model",
            ),
            Self::NotLinear => (None, "this is a defect of the program: please report the model"),
            Self::Unsolved(why) => (None, why.help()),
            Self::ReactionCount { .. } => (
                None,
                "the reactions do not lie along axes of frames: name in [reactions] every force and torque that each joint exerts, along every direction and axis that it prevents, or use kane or lagrange",
            ),
            Self::ReactionsDependent => (
                None,
                "let each constraint be enforced by one reaction along its own direction, or use kane or lagrange",
            ),
            Self::ReactionNotShown { .. } => (None, "name the reactions in [reactions], or use kane or lagrange"),
            Self::TorqueOnNothing { torque } => (Some(torque), "let it act on a rigid body, or use kane or lagrange"),
            Self::PotentialOnNothing { potential } => {
                (Some(potential), "state forces, torques or springs instead, or use kane or lagrange")
            }
            Self::TooLarge { .. } => (
                None,
                "join bodies that hardly move against one another, or cut long branches: each body counts all that lies between it and the ground",
            ),
            Self::AddedMass { body } => (Some(body), "leave `added_mass` out of the model that is identified"),
            Self::LoopsReduced { name } => {
                (Some(name), "run the scene by one of the model's formulations, which keep the contact closed")
            }
            Self::NothingMoves => {
                (None, "run the scene by one of the model's formulations, which follow the constraints")
            }
            Self::ReductionNotProved { .. } => (None, "run the scene by one of the model's formulations"),
        }
    }
}

impl std::error::Error for DeriveError {}

impl fmt::Display for DeriveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::InertiaNotConstant { body, frame, body_frame } => {
                write!(
                    f,
                    "the inertia of `{body}` is constant in the frame `{frame}`, but not in the body's frame `{body_frame}`"
                )
            }
            Self::ReactionWorks { reaction, motion, rate } => {
                let along = motion.trim_end_matches('\'');
                write!(f, "the reaction `{reaction}` does work along `{along}`: power {rate} for each unit of {motion}")
            }
            Self::DirectionNotUnit { reaction, square } => {
                write!(f, "the direction of `{reaction}` is no unit vector: the square of its length is {square}")
            }
            Self::LoadDividesByZero { load, term } => {
                write!(f, "the load `{load}` divides by a term that is always zero, in {term}")
            }
            Self::NoZeroOfPotential { term } => {
                write!(
                    f,
                    "the potential energy has no value at the configuration `zero_at`: {term} divides by zero there"
                )
            }
            Self::NoInertia { speed } => {
                write!(f, "the speed `{speed}` moves no mass: the mass matrix is singular in every configuration")
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
            Self::Unsolved(why) => why.fmt(f),
            Self::ReactionCount { equations, speeds, reactions, all, felt } => {
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
                            ", in no other components than these: {}; each that acts in another brings another equation into play, up to {} reactions when all {all} are",
                            felt.join("; "),
                            all.saturating_sub(*speeds)
                        )
                    }
                )
            }
            Self::ReactionsDependent => {
                write!(f, "newton-euler is not possible: its equations do not determine the reactions one by one")
            }
            Self::ReactionNotShown { reaction } => {
                write!(
                    f,
                    "newton-euler is not possible: it cannot be shown that the reaction `{reaction}` does no work"
                )
            }
            Self::TorqueOnNothing { torque } => {
                write!(f, "newton-euler is not possible: the torque `{torque}` acts on a frame without a body")
            }
            Self::PotentialOnNothing { potential } => {
                write!(
                    f,
                    "newton-euler is not possible: on which bodies the potential `{potential}` acts cannot be told from how they move"
                )
            }
            Self::TooLarge { bodies, coordinates, count, what, most } => write!(
                f,
                "the equations are too large: {bodies} bodies and {coordinates} coordinates make {count} {what}, more than {most}"
            ),
            Self::AddedMass { body } => write!(
                f,
                "inertial parameters are not identified: `{body}` has an added mass, which no motion tells from its own"
            ),
            Self::LoopsReduced { name } => write!(
                f,
                "a scene's reduced equations are not made of a mechanism with loops: nothing would keep `{name}` closed in them"
            ),
            Self::NothingMoves => {
                write!(
                    f,
                    "the constraints leave no speed: there are no equations of motion that a scene's own could be made of"
                )
            }
            Self::ReductionNotProved { what } => write!(f, "the reduced equations of the scene are not proved: {what}"),
        }
    }
}

impl Model {
    /// Diagnostics that show a derivation error at its place in the model file, with advice.
    #[must_use]
    pub fn diagnose(&self, error: &DeriveError) -> Diagnostics {
        let (name, help) = error.place_and_advice_of_error();
        let span = name.and_then(|n| self.declared.get(n).cloned());
        let diagnostic =
            Diagnostic { message: error.to_string(), span, other: None, help: Some(help.to_owned()), file: None };
        Diagnostics::new(self.source.clone(), vec![diagnostic])
    }
}
