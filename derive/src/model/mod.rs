//! Model of a mechanism as its model file states it, after it is read and checked.

mod angle_units;
mod bodies;
mod constraint;
pub(crate) mod constraints;
mod contacts;
mod drive_corners;
mod forces;
mod impossible_bodies;
mod input;
mod reactions;
mod read_model;
mod reading;
mod units;
mod velocities;

pub use crate::geometry::{Frame, Placement, Point, Turn, TurnSense};
pub(crate) use bodies::joint_kinds::JOINT_KINDS;
pub(crate) use bodies::shapes::SHAPE_KINDS;
pub use bodies::shapes::{Shape, ShapeForm, equations_text};
pub use constraint::{
    AddedVelocity, AssemblyBranch, Constraint, HeldOrientation, JointOpeningMotion, LoopEquation, MotionConstraint,
    MotionConstraintKind, RedundantConstraint, SlipComponent,
};
pub use contacts::{ComparedBodies, ConstrainedVelocity, Contacts};
pub use forces::{Force, ForcePlace, JointReaction, Potential, PotentialForce, Reaction, ReactionKind, Torque};
pub use impossible_bodies::ImpossibleBody;
pub use input::{Input, InputBinding};
pub use reactions::interactions::GROUND;
pub(crate) use reactions::interactions::{StatedInteraction, redundant_reaction_message};
pub use read_model::{is_model, load};
pub use reading::declared_names::TIME;
pub(crate) use reading::declared_names::not_a_name;
pub(crate) use units::StatedUnit;
pub use units::Unit;
pub use velocities::NamedVelocity;

use crate::algebra::{Arena, Expr, Rational};
use crate::diagnostic::Source;
use constraints::constant_loops::KnownParameters;
use rustc_hash::FxHashMap;
use std::ops::Range;
use units::unit_of;

/// Parameter of a model: a quantity that is constant during a motion, or a numeric input.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name of the parameter in the model file.
    pub name: String,
    /// Symbol of the parameter in the model's arena.
    pub symbol: Expr,
    /// Unit of the parameter, in SI.
    pub unit: Unit,
    /// Default value of the parameter, in SI; `None` if the model file gives none.
    pub value: Option<Rational>,
    /// True if the model file states that the parameter is positive; false if it states nothing.
    pub positive: bool,
    /// True if the parameter is an input, which drives loads and may change between steps.
    pub is_input: bool,
    /// Description of the parameter in words; empty if the model file gives none.
    pub about: String,
}

/// Generalized coordinate q, with the symbols of its derivatives. Time is the last coordinate if
/// formulas contain it.
#[derive(Clone, Debug)]
pub struct Coordinate {
    /// Name of the coordinate in the model file.
    pub name: String,
    /// Symbol of the coordinate q.
    pub symbol: Expr,
    /// Symbol of the rate q̇ of the coordinate, named `q'`.
    pub rate: Expr,
    /// Symbol of the second time derivative q̈ of the coordinate, named `q''`.
    pub second_rate: Expr,
    /// Unit of the coordinate in SI; radians count as 1.
    pub unit: Unit,
    /// Description of the coordinate in words; empty if the model file gives none.
    pub about: String,
}

impl Coordinate {
    /// True if a value q of this coordinate, in rad, was probably meant in degrees. The coordinate must be an angle,
    /// and q must exceed one turn and have at most two decimals. Multiples of π have more decimals.
    #[must_use]
    pub fn looks_like_degrees(&self, q: f64) -> bool {
        let is_short = (q - (100.0 * q).round() / 100.0).abs() <= f64::EPSILON * q.abs();
        self.unit.is_plain() && q.abs() > std::f64::consts::TAU && is_short
    }
}

/// Generalized speed u, with its definition in q and q̇.
#[derive(Clone, Debug)]
pub struct Speed {
    /// Name of the speed in the model file.
    pub name: String,
    /// Symbol of the speed u.
    pub symbol: Expr,
    /// Symbol of the time derivative u̇ of the speed, named `u'`.
    pub rate: Expr,
    /// Definition of the speed as a term in q and q̇, linear in q̇.
    pub definition: Expr,
    /// Unit of the speed in SI: the unit of its definition.
    pub unit: Unit,
}

/// Speed of a joint that constraints determine from the generalized speeds, so that it is not one of them.
#[derive(Clone, Debug)]
pub struct DependentSpeed {
    /// Name of the dependent speed.
    pub name: String,
    /// Definition of the dependent speed as a term in q and q̇.
    pub definition: Expr,
    /// True if the model file states the speed's name; false if it is the default name of its joint.
    pub is_stated: bool,
}

/// Inertia of a rigid body about its mass centre.
#[derive(Clone, Debug)]
pub struct Inertia {
    /// Index of the frame in which the tensor's components are given. In this frame the tensor is constant.
    pub frame: usize,
    /// Symmetric 3 × 3 inertia tensor about the mass centre, kg m².
    pub tensor: [[Expr; 3]; 3],
}

/// A rigid body or a particle.
#[derive(Clone, Debug)]
pub struct Body {
    /// Name of the body or particle in the model file.
    pub name: String,
    /// Index of the point that is the body's mass centre.
    pub centre: usize,
    /// Mass of the body, kg.
    pub mass: Expr,
    /// Index of the frame fixed in the body, and inertia of the body; `None` for a particle.
    pub rigid: Option<(usize, Inertia)>,
}

/// Added mass of a rigid body: the fluid around the body has the kinetic energy ½ νᵀ M_A ν. Here ν = (v, ω) is the
/// velocity of the body's mass centre and its angular velocity.
///
/// The fluid has the impulse p and the moment of impulse h with (p, h) = M_A ν. The added mass acts on the body with
/// the force −dp/dt and, about the mass centre, with the moment −(dh/dt + v × p). Time derivatives are taken in the
/// inertial frame.
///
/// Sources: T. I. Fossen, *Handbook of Marine Craft Hydrodynamics and Motion Control* (2011), §6.3; H. Lamb,
/// *Hydrodynamics* (1932), §124.
#[derive(Clone, Debug)]
pub struct AddedMass {
    /// Index of the body that the fluid surrounds.
    pub body: usize,
    /// Symmetric 6 × 6 matrix M_A for ν = (v, ω), where v is the velocity of the mass centre. Components are in the
    /// body's frame. The blocks are in kg, kg m and kg m².
    pub tensor: [[Expr; 6]; 6],
}

/// Uniform gravity, which acts on every body.
#[derive(Clone, Debug)]
pub struct Gravity {
    /// Index of the frame in which the components of the acceleration are given: the inertial frame.
    pub frame: usize,
    /// Components of the acceleration of free fall, m/s².
    pub acceleration: [Expr; 3],
    /// Configuration at which the potential energy of gravity is zero, as (symbol of a coordinate, value).
    /// Coordinates that are not listed are 0 there.
    pub zero_at: Vec<(Expr, Expr)>,
}

/// Body that a joint places by its coordinates (a tree joint), with the body or ground to which the joint attaches
/// it.
#[derive(Clone, Copy, Debug)]
pub struct JointedBody {
    /// Index of the body that the joint places.
    pub body: usize,
    /// Index of the body to which the joint attaches the placed body; `None` for the ground.
    pub on: Option<usize>,
    /// Index of the joint's point on the placed body.
    pub point: usize,
}

/// Condition of the domain in which the model holds: a term must be positive.
#[derive(Clone, Debug)]
pub struct DomainCondition {
    /// Name of the condition in the model file.
    pub name: String,
    /// Inequality of the condition, as the model file writes it.
    pub text: String,
    /// Term in parameters, q, q̇, u and reactions that is positive inside the domain.
    pub positive: Expr,
}

/// Kinematic equations q̇ = W u + w, solved for the rates of the coordinates.
#[derive(Clone, Debug, Default)]
pub struct KinematicEquations {
    /// Rates q̇ of the n coordinates as terms in q and u: q̇ = W(q) u + w(q), where W is n × p for p
    /// generalized speeds.
    pub rates: Vec<Expr>,
    /// Divisors of the solution for q̇. In a pose in which a divisor is zero, the generalized speeds do not determine
    /// q̇.
    pub divisors: Vec<Expr>,
    /// True if each joint gives the rates of its coordinates from its own speeds, and closed loops determine some of
    /// these speeds from the generalized speeds. The rates then contain the dependent speeds as named terms.
    pub has_dependent_speeds: bool,
}

/// Redundant equation of rolling or of a joint: it follows from other constraints, so it restricts no further
/// velocity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RedundantEquation {
    /// Name of the redundant equation.
    pub name: String,
    /// True if the redundant equation is a joint's equation between coordinates; false if it is an equation between
    /// velocities.
    pub is_of_loop: bool,
    /// Slip component that the equation sets to zero, if it is an equation of rolling; otherwise
    /// `None`.
    pub rolled: Option<SlipComponent>,
    /// Left side of an equation that is redundant only in poses in which the other constraints are independent: a
    /// term in q and q̇. `None` if the equation is redundant in every pose.
    pub elsewhere: Option<Expr>,
}

impl RedundantEquation {
    /// Creates the record of a joint's equation between coordinates that is redundant in every pose.
    fn of_loop(name: String) -> Self {
        Self { name, is_of_loop: true, rolled: None, elsewhere: None }
    }

    /// Creates the record of a redundant equation of the given kind. `None` for `elsewhere` means that it is
    /// redundant in every pose. Otherwise `elsewhere` is its left side, a term in q and q̇, and it is redundant only
    /// in poses in which the other constraints are independent.
    fn of(name: String, kind: MotionConstraintKind, elsewhere: Option<Expr>) -> Self {
        let rolled = if let MotionConstraintKind::Rolling(rolled) = kind { Some(rolled) } else { None };
        Self { name, is_of_loop: matches!(kind, MotionConstraintKind::Loop(_)), rolled, elsewhere }
    }
}

/// Model of a mechanism, after it is read and checked. Every name is resolved, and frames and points are listed after
/// their parents.
#[derive(Clone)]
pub struct Model {
    /// Title of the model.
    pub title: String,
    /// Source of the problem, as the model file cites it; empty if it cites none.
    pub reference: String,
    /// Text of the model file, with its path.
    pub source: Source,
    /// Arena that stores every term of the model.
    pub arena: Arena,
    /// Parameters, in the order of the model file.
    pub parameters: Vec<Parameter>,
    /// Generalized coordinates in the order of the model file, with [`TIME`] last if formulas contain time. Variables
    /// that constraints determine are left out.
    pub coordinates: Vec<Coordinate>,
    /// Number of configuration variables, time excluded: generalized coordinates, and variables that constraints
    /// determine.
    pub configuration_variables: usize,
    /// Generalized speeds u in the order of the model file. There are as many as coordinates less motion constraints.
    pub speeds: Vec<Speed>,
    /// Motion constraints. The time derivatives of [`Self::loops`] come first.
    pub motion_constraints: Vec<MotionConstraint>,
    /// Reference frames, parents first; the inertial frame has index 0.
    pub frames: Vec<Frame>,
    /// Points, parents first; the origin has index 0.
    pub points: Vec<Point>,
    /// Bodies and particles, in the order of the model file.
    pub bodies: Vec<Body>,
    /// Uniform gravity; `None` if the model file states none.
    pub gravity: Option<Gravity>,
    /// Inputs: signals that drive loads.
    pub inputs: Vec<Input>,
    /// Formulas that a scene gives to inputs, in the order of the scene file; empty without a scene.
    pub bindings: Vec<InputBinding>,
    /// Names of inputs to whose formula a parameter with the input's name is added
    /// ([`Self::reread_with_varied_inputs`]).
    pub varied: Vec<String>,
    /// Applied forces, including those of springs and friction.
    pub forces: Vec<Force>,
    /// Applied torques, including those of friction about axes.
    pub torques: Vec<Torque>,
    /// Added masses of bodies, at most one for each body.
    pub added_masses: Vec<AddedMass>,
    /// Potential energies that the model file states.
    pub potentials: Vec<Potential>,
    /// Forces and torques between bodies that replace all potentials in the Newton–Euler equations. Empty without
    /// potentials, or if no such forces are found.
    pub efforts: Vec<PotentialForce>,
    /// Velocities and positions that occur by name in forces, torques and other formulas.
    pub velocities: Vec<NamedVelocity>,
    /// Reactions: first those that the model file states, then those found automatically.
    pub reactions: Vec<Reaction>,
    /// Reactions of joints along directions in which other connections hold the bodies as well. They are taken as
    /// zero.
    pub redundant: Vec<JointReaction>,
    /// Contacts of bodies that the model file states, other than reactions.
    pub contacts: Contacts,
    /// Holonomic constraints that are solved for a configuration variable.
    pub constraints: Vec<Constraint>,
    /// Motions that closed joints would permit if each alone were open. Reactions are computed from these motions.
    pub openings: Vec<JointOpeningMotion>,
    /// Independent holonomic constraints that are not solved for a configuration variable.
    pub loops: Vec<LoopEquation>,
    /// Redundant loop equations: their rates follow from those of [`Self::loops`] in all poses in which the loops are
    /// closed. They restrict no further velocity.
    pub closed: Vec<LoopEquation>,
    /// Orientations that closing joints hold, and that their equations alone do not determine.
    pub orientations: Vec<HeldOrientation>,
    /// Pose with closed loops near the values under `[assembly]`, at the default values: a value in SI units for each
    /// generalized coordinate. `None` if the model file has no such section.
    pub assembly: Option<Vec<f64>>,
    /// Equations of closing joints without coordinates, as (name, left side): conditions on parameters
    /// under which the loops can be closed. The default values satisfy them.
    pub conditions: Vec<(String, Expr)>,
    /// Constraints that follow from other constraints in all poses in which the loops are closed.
    pub dependent: Vec<RedundantConstraint>,
    /// Speeds of joints that the constraints determine from [`Self::speeds`].
    pub dependent_speeds: Vec<DependentSpeed>,
    /// Assembly branch in which redundancy was decided; `None` without loops, or if no closed pose was
    /// found.
    pub branch: Option<AssemblyBranch>,
    /// Conditions of the domain in which the model holds, each a term that must be positive.
    pub domain: Vec<DomainCondition>,
    /// Bodies that joints place, each with the body to which the joint attaches it.
    pub carried: Vec<JointedBody>,
    /// Shapes of the bodies for views, as the model file states them.
    pub shapes: Vec<Shape>,
    /// Kinematic equations: rates q̇ as terms in the generalized speeds u.
    pub kinematic_equations: KinematicEquations,
    /// Redundant equations of rolling and of joints, which are left out of the constraints.
    pub repeated: Vec<RedundantEquation>,
    /// Parameters, expressions, inputs, frames and points that the model file declares and never uses,
    /// as (kind in words, name).
    pub unused: Vec<(&'static str, String)>,
    /// Byte range in the model file at which each name is declared, for diagnostics.
    pub declared: FxHashMap<String, Range<usize>>,
    /// Named formulas of `[expressions]`, as (name, term), in the order of the model file.
    pub expressions: Vec<(String, Expr)>,
}

impl Model {
    /// Condition on parameters that given values of the parameters violate, as (name, gap of the loop in
    /// SI units). `None` if the values satisfy all conditions.
    pub(crate) fn violated_condition(&self, parameters: &[f64]) -> Option<(&str, f64)> {
        let known: Vec<(Expr, f64)> = self.p().into_iter().zip(parameters.iter().copied()).collect();
        let units = self.parameters.iter().map(|p| (p.symbol, p.unit.clone())).collect();
        let known = KnownParameters::new(&known, &units);
        self.conditions.iter().find_map(|(name, equation)| {
            let gap = known.gap(&self.arena, *equation)?;
            (gap != 0.0).then_some((name.as_str(), gap))
        })
    }

    /// Named expressions of `[expressions]` that contain no symbols other than `symbols`, as (name, term).
    pub(crate) fn expressions_in(&self, symbols: &[Expr]) -> Vec<(String, Expr)> {
        let is_known = |e: &Expr| self.arena.symbol_name(*e).is_none() || symbols.contains(e);
        let list = self.expressions.iter().filter(|(_, e)| self.arena.reachable(&[*e]).iter().all(is_known));
        list.cloned().collect()
    }

    /// Unit of a term of `arena` in parameters, coordinates, speeds and reactions. `None` if the units of its parts
    /// do not fit, or if the term has no definite unit, such as 0.
    #[must_use]
    pub fn unit_of(&self, arena: &Arena, e: Expr) -> Option<Unit> {
        self.checked_unit_of(arena, e).ok().flatten()
    }

    /// Unit of a term of `arena` in parameters, coordinates, speeds and reactions. `None` if the term has no definite
    /// unit, such as 0.
    ///
    /// # Errors
    /// Returns a message if the units of the term's parts do not fit, as in a sum of a mass and a length.
    pub fn checked_unit_of(&self, arena: &Arena, e: Expr) -> Result<Option<Unit>, String> {
        let per_second = |unit: &Unit| unit.times(&Unit::new(0, 0, -1));
        let parameters = self.parameters.iter().map(|p| (p.symbol, p.unit.clone()));
        let coordinates = self.coordinates.iter().flat_map(|c| {
            let rate = per_second(&c.unit);
            [(c.symbol, c.unit.clone()), (c.second_rate, per_second(&rate)), (c.rate, rate)]
        });
        let speeds = self.speeds.iter().flat_map(|s| [(s.symbol, s.unit.clone()), (s.rate, per_second(&s.unit))]);
        let reactions = self.reactions.iter().map(|reaction| {
            let lever = i64::from(matches!(reaction.kind, ReactionKind::Torque { .. }));
            (reaction.symbol, Unit::new(1 + lever, 1, -2))
        });
        let symbols = parameters.chain(coordinates).chain(speeds).chain(reactions);
        unit_of(arena, e, &symbols.collect()).map_err(|(message, _)| message)
    }

    /// Symbols of the generalized coordinates, time included if it is a coordinate.
    #[must_use]
    pub fn q(&self) -> Vec<Expr> {
        self.coordinates.iter().map(|c| c.symbol).collect()
    }

    /// Symbols of the rates q̇ of the generalized coordinates, in their order.
    #[must_use]
    pub fn q_dot(&self) -> Vec<Expr> {
        self.coordinates.iter().map(|c| c.rate).collect()
    }

    /// Symbols of the generalized speeds u, in the order of [`Self::speeds`].
    #[must_use]
    pub fn u(&self) -> Vec<Expr> {
        self.speeds.iter().map(|s| s.symbol).collect()
    }

    /// Symbols of the parameters, in the order of [`Self::parameters`].
    #[must_use]
    pub fn p(&self) -> Vec<Expr> {
        self.parameters.iter().map(|p| p.symbol).collect()
    }

    /// Hash of the model's text and of the formulas that a scene gives to inputs, 16 hexadecimal digits. Shapes and
    /// notation at the end of the text are left out. Equations with this hash were derived from exactly this text and
    /// these formulas.
    #[must_use]
    pub fn text_hash(&self) -> String {
        let text = equations_text(&self.source.text);
        let bound = self.bindings.iter().map(|b| format!("\n{} = {}", b.input, b.formula));
        text_hash(&bound.fold(text.to_owned(), |text, bound| text + &bound))
    }

    /// Phrase for people with the numbers of configuration variables, constraints, generalized coordinates and
    /// generalized speeds.
    #[must_use]
    pub fn counts_in_words(&self) -> String {
        let plural = |n: usize, one: &str| if n == 1 { format!("1 {one}") } else { format!("{n} {one}s") };
        let clock = usize::from(self.time().is_some());
        let nonholonomic =
            |c: &&MotionConstraint| matches!(c.kind, MotionConstraintKind::Stated | MotionConstraintKind::Rolling(_));
        let count = format!(
            "{}, {}, {}, {}, {}",
            plural(self.configuration_variables, "configuration variable"),
            plural(self.constraints.len() + self.loops.len() + self.closed.len(), "holonomic constraint"),
            plural(self.coordinates.len() - clock, "generalized coordinate"),
            plural(self.motion_constraints.iter().filter(nonholonomic).count(), "nonholonomic constraint"),
            plural(self.speeds.len(), "generalized speed"),
        );
        if clock == 0 { count } else { count + ", time" }
    }
}

/// Hash of a text: the first 16 hexadecimal digits of its SHA-256. Compiled equations store it to
/// recognize their model.
#[must_use]
pub fn text_hash(text: &str) -> String {
    let mut digest = text_digest(text);
    digest.truncate(16);
    digest
}

/// SHA-256 of a text as 64 hexadecimal digits. Certificates of proofs are bound to their files by it.
#[must_use]
pub fn text_digest(text: &str) -> String {
    use sha2::Digest;
    use std::fmt::Write;
    sha2::Sha256::digest(text.as_bytes()).iter().fold(String::new(), |mut digits, byte| {
        let _ = write!(digits, "{byte:02x}");
        digits
    })
}
