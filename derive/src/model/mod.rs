//! A mechanism as the model file states it, checked.

mod angle;
mod bodies;
mod constraint;
pub(crate) mod constraints;
mod contacts;
mod corners;
mod forces;
mod input;
mod physics;
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
    AddedVelocity, Branch, Constraint, DependentConstraint, Loop, MotionConstraint, MotionConstraintKind, Opening,
    Rolled,
};
pub use contacts::{Compared, Contacts, StatedVelocity};
pub use forces::{Effort, Force, JointReaction, Place, Potential, Reaction, ReactionKind, Torque};
pub use input::{Binding, Input};
pub use physics::ImpossibleBody;
pub use reactions::interactions::GROUND;
pub(crate) use reactions::interactions::{StatedInteraction, is_redundant};
pub use read_model::{is_model, load};
pub use reading::names::TIME;
pub(crate) use reading::names::not_a_name;
pub(crate) use units::StatedUnit;
pub use units::Unit;
pub use velocities::NamedVelocity;

use crate::algebra::{Arena, Expr, Rational};
use crate::diagnostic::Source;
use rustc_hash::FxHashMap;
use std::ops::Range;
use units::unit_of;

/// A quantity that stays fixed during a motion, or an input.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name of the parameter in the model file.
    pub name: String,
    /// Symbol of the parameter in formulas.
    pub symbol: Expr,
    /// Unit of the parameter, in SI.
    pub unit: Unit,
    /// Default value of the parameter, in SI; `None` if the model file gives none.
    pub value: Option<Rational>,
    /// True if the model file states that the parameter is positive.
    pub positive: bool,
    /// True if the parameter is an input, which drives loads and may change from one step to the next.
    pub is_input: bool,
    /// Description of the parameter in words; empty if the model file gives none.
    pub about: String,
}

/// A configuration variable q, with the symbols of its derivatives. Time is the last one if formulas name it.
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
    /// Unit of the coordinate, in SI; radians count as 1.
    pub unit: Unit,
    /// Description of the coordinate in words; empty if the model file gives none.
    pub about: String,
}

impl Coordinate {
    /// True if an angle q of more than one turn was probably meant in degrees: it has at most two decimals. Multiples
    /// of π have more decimals.
    #[must_use]
    pub fn looks_like_degrees(&self, q: f64) -> bool {
        let is_short = (q - (100.0 * q).round() / 100.0).abs() <= f64::EPSILON * q.abs();
        self.unit.is_plain() && q.abs() > std::f64::consts::TAU && is_short
    }
}

/// A generalized speed u, with its definition in q and q̇.
#[derive(Clone, Debug)]
pub struct Speed {
    /// Name of the speed in the model file.
    pub name: String,
    /// Symbol of the speed u.
    pub symbol: Expr,
    /// Symbol of the time derivative u̇ of the speed, named `u'`.
    pub rate: Expr,
    /// Definition of the speed in terms of q and q̇, linear in q̇.
    pub definition: Expr,
    /// Unit of the speed, that of its definition.
    pub unit: Unit,
}

/// A speed of a joint that constraints make dependent: it follows from the generalized speeds of the model.
#[derive(Clone, Debug)]
pub struct DependentSpeed {
    /// Name of the dependent speed.
    pub name: String,
    /// Definition of the dependent speed in terms of q and q̇.
    pub definition: Expr,
    /// True if the model file names the dependent speed, false if it has the joint's default name.
    pub is_stated: bool,
}

/// The inertia of a rigid body about its mass centre.
#[derive(Clone, Debug)]
pub struct Inertia {
    /// Index of the frame of the tensor's components. The tensor is constant in the body.
    pub frame: usize,
    /// Components of the symmetric inertia tensor about the mass centre, kg m².
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
    /// Index of the body's frame, and inertia of the body; `None` for a particle.
    pub rigid: Option<(usize, Inertia)>,
}

/// Added mass of a rigid body: the kinetic energy ½ νᵀ M_A ν of the fluid that moves with it.
///
/// The fluid has the impulse p and the moment of impulse h with (p, h) = M_A ν. The added mass acts on the body with
/// the force −dp/dt and, about the mass centre, the moment −(dh/dt + v × p), rates being those in the inertial frame
/// (T. I. Fossen, *Handbook of Marine Craft Hydrodynamics and Motion Control* (2011), §6.3; H. Lamb, *Hydrodynamics*
/// (1932), §124).
#[derive(Clone, Debug)]
pub struct AddedMass {
    /// Index of the body.
    pub body: usize,
    /// Symmetric matrix M_A for ν = (v, ω), in the frame of the body: v of the mass centre; kg, kg m, kg m².
    pub tensor: [[Expr; 6]; 6],
}

/// Uniform gravity, which acts on every body.
#[derive(Clone, Debug)]
pub struct Gravity {
    /// Index of the frame of the acceleration's components: the inertial frame.
    pub frame: usize,
    /// Components of the acceleration of free fall, m/s².
    pub acceleration: [Expr; 3],
    /// Coordinates and their values where the potential energy is zero. Coordinates that are not listed are 0 there.
    pub zero_at: Vec<(Expr, Expr)>,
}

/// A body that a joint carries, with the body or ground that holds it.
#[derive(Clone, Copy, Debug)]
pub struct CarriedBody {
    /// Index of the body that the joint carries.
    pub body: usize,
    /// Index of the body that holds the carried body; `None` for the ground.
    pub on: Option<usize>,
    /// Index of the carried body's point at the joint.
    pub point: usize,
}

/// A condition of the domain in which the model holds.
#[derive(Clone, Debug)]
pub struct Condition {
    /// Name of the condition in the model file.
    pub name: String,
    /// Inequality of the condition, as the model file writes it.
    pub text: String,
    /// Expression in parameters, q, q̇, u and reactions that is positive inside the domain.
    pub positive: Expr,
}

/// The solved kinematic equations q̇ = W u + w.
#[derive(Clone, Debug, Default)]
pub struct KinematicEquations {
    /// Rates q̇ of the generalized coordinates, in q and u: q̇ = W(q) u + w(q). W has a row for each coordinate and a
    /// column for each speed.
    pub rates: Vec<Expr>,
    /// Divisors of the solution: where one of them is zero, the speeds do not determine q̇.
    pub divisors: Vec<Expr>,
}

/// An equation of rolling or of a joint that follows from other constraints, so that it restricts no velocity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Repeated {
    /// Name of the repeated equation.
    pub name: String,
    /// True if the repeated equation is one of a joint, between coordinates.
    pub is_of_loop: bool,
    /// Component of a slip that the repeated equation sets to zero; `None` if it is not one of rolling.
    pub rolled: Option<Rolled>,
    /// Expression in q and q̇ that is zero, if the equation does not follow from other constraints in every pose. It
    /// follows in the poses where the other constraints are independent. `None` if it follows in every pose.
    pub elsewhere: Option<Expr>,
}

impl Repeated {
    /// A repeated equation between coordinates, of a joint, that follows in every pose.
    fn of_loop(name: String) -> Self {
        Self { name, is_of_loop: true, rolled: None, elsewhere: None }
    }

    /// A repeated equation that others imply: in every pose, or with `elsewhere` only where those others are
    /// independent.
    fn of(name: String, kind: MotionConstraintKind, elsewhere: Option<Expr>) -> Self {
        let rolled = if let MotionConstraintKind::Rolling(rolled) = kind { Some(rolled) } else { None };
        Self { name, is_of_loop: matches!(kind, MotionConstraintKind::Loop(_)), rolled, elsewhere }
    }
}

/// A mechanism, checked: every name is resolved, and frames and points are in order, parents first.
#[derive(Clone)]
pub struct Model {
    /// Title of the model.
    pub title: String,
    /// Source of the problem, as the model file cites it.
    pub reference: String,
    /// Text of the model file, with its name.
    pub source: Source,
    /// Store of every expression of the model.
    pub arena: Arena,
    /// Parameters, in the order of the model file.
    pub parameters: Vec<Parameter>,
    /// Generalized coordinates, in the order of the model file, and last [`TIME`] if formulas name it. Constrained
    /// configuration variables are not among them.
    pub coordinates: Vec<Coordinate>,
    /// Number of configuration variables: generalized coordinates and constrained variables, without time.
    pub configuration_variables: usize,
    /// Generalized speeds u, in the order of the model file: n for n coordinates, less one for each motion constraint.
    pub speeds: Vec<Speed>,
    /// Motion constraints, those of [`Self::loops`] first.
    pub motion_constraints: Vec<MotionConstraint>,
    /// Frames, the inertial one first.
    pub frames: Vec<Frame>,
    /// Points, the origin first.
    pub points: Vec<Point>,
    /// Bodies and particles, in the order of the model file.
    pub bodies: Vec<Body>,
    /// Gravity; `None` if the model file states none.
    pub gravity: Option<Gravity>,
    /// Inputs: the signals that drive loads.
    pub inputs: Vec<Input>,
    /// Formulas that a scene gives to inputs, in the order of the scene.
    pub bindings: Vec<Binding>,
    /// Names of inputs whose formula has a parameter of the same name added to it ([`Self::with_varied`]).
    pub varied: Vec<String>,
    /// Applied forces, including those of springs and friction.
    pub forces: Vec<Force>,
    /// Applied torques, including those of friction about axes.
    pub torques: Vec<Torque>,
    /// Added masses of bodies, at most one for each.
    pub added_masses: Vec<AddedMass>,
    /// Potential energies that the model file states.
    pub potentials: Vec<Potential>,
    /// All potentials as forces and torques between bodies. Empty if there is no potential, or if none are found.
    pub efforts: Vec<Effort>,
    /// Velocities and positions that the components of forces, torques and other formulas name.
    pub velocities: Vec<NamedVelocity>,
    /// Reactions: first those of the model file, then those that were found.
    pub reactions: Vec<Reaction>,
    /// Reactions of joints along directions that are held otherwise as well. They are taken as zero.
    pub redundant: Vec<JointReaction>,
    /// Contacts of bodies that the model file states, other than reactions.
    pub contacts: Contacts,
    /// Holonomic constraints that are solved for a coordinate.
    pub constraints: Vec<Constraint>,
    /// Motions along the coordinates that equations of closed joints fix, as if these joints were open.
    pub openings: Vec<Opening>,
    /// Holonomic constraints that are solved for no coordinate.
    pub loops: Vec<Loop>,
    /// Loops whose rates follow from those of [`Self::loops`] wherever all loops are closed. They restrict no further
    /// velocity.
    pub closed: Vec<Loop>,
    /// Constraints that depend on others in the closed poses.
    pub dependent: Vec<DependentConstraint>,
    /// Speeds of joints that follow from [`Self::speeds`] by the constraints.
    pub dependent_speeds: Vec<DependentSpeed>,
    /// Branch of closed poses on which dependence was decided, if loops are to be closed and closed poses were found.
    pub branch: Option<Branch>,
    /// Conditions of the domain in which the model holds.
    pub domain: Vec<Condition>,
    /// Bodies that joints carry, each with its holder.
    pub carried: Vec<CarriedBody>,
    /// Shapes of the parts that the model file states.
    pub shapes: Vec<Shape>,
    /// Rates q̇ in terms of the speeds u.
    pub kinematic_equations: KinematicEquations,
    /// Equations of rolling and of joints that follow from other constraints, and do not count as constraints.
    pub repeated: Vec<Repeated>,
    /// Parameters, expressions, inputs, frames and points that the model file declares and never uses: noun of the
    /// kind, and name.
    pub unused: Vec<(&'static str, String)>,
    /// Byte range in the model file of each name's declaration, for diagnostics.
    pub declared: FxHashMap<String, Range<usize>>,
    /// Names and terms of `[expressions]`, in the order of the model file.
    pub expressions: Vec<(String, Expr)>,
}

impl Model {
    /// Named expressions of the model that contain no other symbols than these.
    pub(crate) fn expressions_in(&self, symbols: &[Expr]) -> Vec<(String, Expr)> {
        let is_known = |e: &Expr| self.arena.symbol_name(*e).is_none() || symbols.contains(e);
        let list = self.expressions.iter().filter(|(_, e)| self.arena.reachable(&[*e]).iter().all(is_known));
        list.cloned().collect()
    }

    /// Unit of a term of `arena` in parameters, coordinates and speeds; `None` if its parts do not fit or it has no
    /// unit.
    #[must_use]
    pub fn unit_of(&self, arena: &Arena, e: Expr) -> Option<Unit> {
        self.checked_unit_of(arena, e).ok().flatten()
    }

    /// Unit of a term of `arena` in parameters, coordinates and speeds; `None` if it has none.
    ///
    /// # Errors
    /// Message that parts of the term do not fit one another, such as a sum of a mass and a length.
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

    /// Symbols of the generalized coordinates.
    #[must_use]
    pub fn q(&self) -> Vec<Expr> {
        self.coordinates.iter().map(|c| c.symbol).collect()
    }

    /// Symbols of the rates q̇ of the generalized coordinates.
    #[must_use]
    pub fn q_dot(&self) -> Vec<Expr> {
        self.coordinates.iter().map(|c| c.rate).collect()
    }

    /// Symbols of the generalized speeds.
    #[must_use]
    pub fn u(&self) -> Vec<Expr> {
        self.speeds.iter().map(|s| s.symbol).collect()
    }

    /// Symbols of the parameters.
    #[must_use]
    pub fn p(&self) -> Vec<Expr> {
        self.parameters.iter().map(|p| p.symbol).collect()
    }

    /// Hash of the model text, without shapes and notation at its end, and of the formulas of inputs. Equations that
    /// carry this hash were derived from exactly this text and these formulas.
    #[must_use]
    pub fn text_hash(&self) -> String {
        let text = equations_text(&self.source.text);
        let bound = self.bindings.iter().map(|b| format!("\n{} = {}", b.input, b.formula));
        text_hash(&bound.fold(text.to_owned(), |text, bound| text + &bound))
    }

    /// Numbers of configuration variables, constraints, generalized coordinates and generalized speeds, in words.
    #[must_use]
    pub fn count(&self) -> String {
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

/// Hash of a text, as compiled equations carry it: the first 16 hexadecimal digits of its SHA-256.
#[must_use]
pub fn text_hash(text: &str) -> String {
    use sha2::Digest;
    let digest = sha2::Sha256::digest(text.as_bytes());
    let first = digest.iter().take(8).fold(0_u64, |n, byte| n << 8 | u64::from(*byte));
    format!("{first:016x}")
}
