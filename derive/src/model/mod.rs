//! A mechanism as the model file states it, checked.

mod angle;
mod bodies;
mod constraint;
pub(crate) mod constraints;
mod contacts;
mod corners;
mod input;
mod physics;
mod reactions;
mod read_model;
mod reading;
mod units;
mod velocities;

pub use crate::geometry::{Frame, Point, Turn};
pub(crate) use bodies::joint_kinds::JOINT_KINDS;
pub(crate) use bodies::shapes::SHAPE_KINDS;
pub use bodies::shapes::{Shape, ShapeForm, without_shapes};
pub use constraint::{Branch, Constraint, DependentConstraint, Loop, MotionConstraint, Rolled, Tie};
pub use contacts::{Compared, Contacts};
pub use input::{Binding, Input};
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

/// A quantity that stays fixed during a motion.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name in the file.
    pub name: String,
    /// Its symbol.
    pub symbol: Expr,
    /// Its unit, in SI.
    pub unit: Unit,
    /// The default value, if the file gives one.
    pub value: Option<Rational>,
    /// True if the file states that the parameter is positive.
    pub positive: bool,
    /// True if the parameter is an input, which drives loads and may change from one step to the next.
    pub is_input: bool,
    /// Description in words.
    pub about: String,
}

/// A configuration variable.
#[derive(Clone, Debug)]
pub struct Coordinate {
    /// Its name in the file.
    pub name: String,
    /// Symbol of the coordinate q.
    pub symbol: Expr,
    /// q̇, named `q'`.
    pub rate: Expr,
    /// q̈, named `q''`.
    pub second_rate: Expr,
    /// Its unit, in SI; radians count as 1.
    pub unit: Unit,
    /// Description in words.
    pub about: String,
}

impl Coordinate {
    /// True if an angle of more than one turn was probably meant in degrees: people write degrees with few decimals,
    /// and multiples of π have many.
    #[must_use]
    pub fn looks_like_degrees(&self, q: f64) -> bool {
        let is_short = (q - (100.0 * q).round() / 100.0).abs() <= f64::EPSILON * q.abs();
        self.unit.is_plain() && q.abs() > std::f64::consts::TAU && is_short
    }
}

/// A generalized speed.
#[derive(Clone, Debug)]
pub struct Speed {
    /// Its name in the file.
    pub name: String,
    /// Symbol of the speed u.
    pub symbol: Expr,
    /// u̇, named `u'`.
    pub rate: Expr,
    /// Its definition in terms of q and q̇, linear in q̇.
    pub definition: Expr,
    /// Its unit, that of its definition.
    pub unit: Unit,
}

/// A speed that a joint brings and constraints leave no choice of: it follows from the others.
#[derive(Clone, Debug)]
pub struct DependentSpeed {
    /// Its name.
    pub name: String,
    /// Its definition in terms of q and q̇.
    pub definition: Expr,
    /// True if the file names the speed, false if it has the joint's default name.
    pub is_stated: bool,
}

/// The inertia of a rigid body about its mass centre.
#[derive(Clone, Debug)]
pub struct Inertia {
    /// The frame of the components. The tensor is constant in the body.
    pub frame: usize,
    /// The symmetric tensor, kg m².
    pub tensor: [[Expr; 3]; 3],
}

/// A rigid body or a particle.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its name in the file.
    pub name: String,
    /// The mass centre.
    pub centre: usize,
    /// The mass, kg.
    pub mass: Expr,
    /// The body's frame and inertia; `None` for a particle.
    pub rigid: Option<(usize, Inertia)>,
}

/// Uniform gravity.
#[derive(Clone, Debug)]
pub struct Gravity {
    /// The frame of the components: inertial.
    pub frame: usize,
    /// The acceleration of free fall, m/s².
    pub acceleration: [Expr; 3],
    /// Values of coordinates at which the potential energy is zero; the others cancel or are 0.
    pub zero_at: Vec<(Expr, Expr)>,
}

/// Place at which a force or reaction acts: a body and a point moving with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The body.
    pub body: usize,
    /// The point of the body, as it is now.
    pub point: usize,
}

/// An applied force, and its opposite on another body if there is one.
#[derive(Clone, Debug)]
pub struct Force {
    /// Its name in the file.
    pub name: String,
    /// Place at which the force acts.
    pub on: Place,
    /// Place at which the opposite force acts.
    pub against: Option<Place>,
    /// The frame of the components.
    pub frame: usize,
    /// The components, N, in parameters, q, q̇, u and [`Model::velocities`].
    pub vector: [Expr; 3],
    /// The point at the other end of a spring or damper, on a body or the ground.
    pub end: Option<usize>,
    /// The potential energy in q, J, of the part of it and its opposite that remains at rest, if known: that of a
    /// spring.
    pub energy: Option<Expr>,
    /// Coefficient c of a damper, in parameters, and rate ḋ of its length, in q and q̇: the damper takes the power c
    /// ḋ².
    pub damper: Option<[Expr; 2]>,
}

/// An applied torque, and its opposite on another frame if there is one.
#[derive(Clone, Debug)]
pub struct Torque {
    /// Its name in the file.
    pub name: String,
    /// The frame that is turned, and the body it belongs to if it belongs to one.
    pub on: (usize, Option<usize>),
    /// The frame that the opposite torque turns.
    pub against: Option<(usize, Option<usize>)>,
    /// The frame of the components.
    pub frame: usize,
    /// The components, N m, in parameters, q, q̇, u and [`Model::velocities`].
    pub vector: [Expr; 3],
}

/// A potential energy as the file gives it.
#[derive(Clone, Debug)]
pub struct Potential {
    /// Its name in the file.
    pub name: String,
    /// V in parameters, q and t, J: it adds −∂V/∂q to the generalized forces of the coordinates other than time.
    pub energy: Expr,
}

/// Joint from which a body hangs.
#[derive(Clone, Copy, Debug)]
pub struct Hung {
    /// The body.
    pub body: usize,
    /// The body that it hangs on; the ground if there is none.
    pub on: Option<usize>,
    /// The point of the body at the joint.
    pub point: usize,
}

/// A force or torque between bodies that stands for potentials in the Newton–Euler equations.
#[derive(Clone, Debug)]
pub struct Effort {
    /// Places or bodies on which it acts.
    pub kind: ReactionKind,
    /// The frame of the components.
    pub frame: usize,
    /// The components, N or N m, in parameters and q.
    pub vector: [Expr; 3],
}

/// Places or bodies on which a reaction and its opposite act.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReactionKind {
    /// A force at a place, and the opposite at another if given.
    Force {
        /// Place at which it acts.
        on: Place,
        /// Place at which its opposite acts.
        against: Option<Place>,
    },
    /// A torque on a body, and the opposite on another if given.
    Torque {
        /// The body it turns.
        on: usize,
        /// The body its opposite turns.
        against: Option<usize>,
    },
}

/// An unknown force or torque that a constraint exerts along a known direction.
#[derive(Clone, Debug)]
pub struct Reaction {
    /// Its name in the file.
    pub name: String,
    /// Its symbol.
    pub symbol: Expr,
    /// Places or bodies on which it acts.
    pub kind: ReactionKind,
    /// The frame of the direction's components.
    pub frame: usize,
    /// The direction; positive values act along it.
    pub direction: [Expr; 3],
    /// True if the file names the reaction, false if it was found.
    pub is_stated: bool,
    /// True if the reaction does work by itself: the powers of all such reactions along every speed add up to zero.
    /// They hold directions that are held along no axis of a frame.
    pub is_shared: bool,
}

/// A condition of the domain in which the model holds.
#[derive(Clone, Debug)]
pub struct Condition {
    /// Its name in the file.
    pub name: String,
    /// The condition as written.
    pub text: String,
    /// An expression in parameters, q, q̇, u and reactions that is positive inside.
    pub positive: Expr,
}

/// The solved kinematic equations q̇ = W u + w.
#[derive(Clone, Debug, Default)]
pub struct KinematicEquations {
    /// q̇ of each generalized coordinate, in q and u: q̇ = W(q) u + w(q), W with a row for each coordinate and a column
    /// for each speed.
    pub rates: Vec<Expr>,
    /// Divisors: where one of these is zero, the speeds do not determine q̇.
    pub divisors: Vec<Expr>,
}

/// An equation that rolling or a joint states, and that says nothing new.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Repeated {
    /// Its name.
    pub name: String,
    /// True if the equation is one between coordinates, of a joint.
    pub is_of_loop: bool,
    /// The component of a slip that it states, if it states one.
    pub rolled: Option<Rolled>,
    /// Expression in q and q̇ that is zero, if the equation does not follow from the others in every pose. It follows
    /// wherever these are independent.
    pub elsewhere: Option<Expr>,
}

impl Repeated {
    /// One between coordinates, of a joint.
    fn of_loop(name: String) -> Self {
        Self { name, is_of_loop: true, rolled: None, elsewhere: None }
    }

    /// Equation that others already imply: in every pose, or with `elsewhere` only where these are independent.
    fn of(name: String, tie: Tie, elsewhere: Option<Expr>) -> Self {
        let rolled = if let Tie::Rolling(rolled) = tie { Some(rolled) } else { None };
        Self { name, is_of_loop: matches!(tie, Tie::Loop(_)), rolled, elsewhere }
    }
}

/// A mechanism, checked: every name resolved, frames and points in order, parents first.
#[derive(Clone)]
pub struct Model {
    /// The title.
    pub title: String,
    /// Source of the problem, as the file states it.
    pub reference: String,
    /// The file.
    pub source: Source,
    /// The store of every expression below.
    pub arena: Arena,
    /// Parameters, in the order of the file.
    pub parameters: Vec<Parameter>,
    /// Generalized coordinates, in the order of the file, and last [`TIME`] if formulas name it. Constrained
    /// configuration variables are not among them.
    pub coordinates: Vec<Coordinate>,
    /// Number of configuration variables: generalized coordinates and constrained variables, without time.
    pub configuration_variables: usize,
    /// Generalized speeds u, in the order of the file: n for n coordinates, less one for each motion constraint.
    pub speeds: Vec<Speed>,
    /// Motion constraints, those of [`Self::loops`] first.
    pub motion_constraints: Vec<MotionConstraint>,
    /// Frames, the inertial one first.
    pub frames: Vec<Frame>,
    /// Points, the origin first.
    pub points: Vec<Point>,
    /// Bodies and particles, in the order of the file.
    pub bodies: Vec<Body>,
    /// Gravity, if there is any.
    pub gravity: Option<Gravity>,
    /// Inputs, the signals that drive loads.
    pub inputs: Vec<Input>,
    /// The formulas that a scene gave to some of them, in the order of the scene.
    pub bindings: Vec<Binding>,
    /// Inputs that have a parameter of their name beside a formula ([`Self::with_varied`]).
    pub varied: Vec<String>,
    /// Applied forces.
    pub forces: Vec<Force>,
    /// Applied torques.
    pub torques: Vec<Torque>,
    /// Potentials.
    pub potentials: Vec<Potential>,
    /// All potentials as forces and torques between bodies; none if there is no potential, or they cannot be had so.
    pub efforts: Vec<Effort>,
    /// The velocities that the components of forces and torques name.
    pub velocities: Vec<NamedVelocity>,
    /// Reactions: those of the file, then those that were found.
    pub reactions: Vec<Reaction>,
    /// Reactions of joints along directions that are held otherwise as well, by the names of their equations. They are
    /// taken as zero.
    pub redundant: Vec<(String, Reaction)>,
    /// Contacts of bodies, beside rolling and reactions.
    pub contacts: Contacts,
    /// Holonomic constraints that fix a coordinate.
    pub constraints: Vec<Constraint>,
    /// Holonomic constraints that fix none.
    pub loops: Vec<Loop>,
    /// Loops whose rates follow from those of the others wherever all of them hold: they close the mechanism, and
    /// restrict no further velocity.
    pub closed: Vec<Loop>,
    /// Constraints that depend on others in the closed poses.
    pub dependent: Vec<DependentConstraint>,
    /// Speeds of joints that follow from [`Self::speeds`] by the constraints.
    pub dependent_speeds: Vec<DependentSpeed>,
    /// Branch of closed poses on which dependence was decided, if loops are to be closed and closed poses were found.
    pub branch: Option<Branch>,
    /// The domain.
    pub domain: Vec<Condition>,
    /// Bodies that joints carry, each with its holder.
    pub hung: Vec<Hung>,
    /// Shapes of the parts, as far as the file states them.
    pub shapes: Vec<Shape>,
    /// q̇ in terms of the speeds.
    pub kinematic_equations: KinematicEquations,
    /// Components of rolling that follow from other constraints, and count as none.
    pub repeated: Vec<Repeated>,
    /// Parameters, frames and points that nothing in the file refers to, each with what it is.
    pub unused: Vec<(&'static str, String)>,
    /// Byte range in the file of each name's declaration, for diagnostics.
    pub declared: FxHashMap<String, Range<usize>>,
}

impl Model {
    /// The unit of a term of this arena in parameters, coordinates and speeds, if it has one.
    #[must_use]
    pub fn unit_of(&self, arena: &Arena, e: Expr) -> Option<Unit> {
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
        unit_of(arena, e, &symbols.collect()).ok().flatten()
    }

    /// Symbols of the generalized coordinates.
    #[must_use]
    pub fn q(&self) -> Vec<Expr> {
        self.coordinates.iter().map(|c| c.symbol).collect()
    }

    /// Symbols of their time derivatives.
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

    /// Hash of the model text without shapes at its end, and of formulas of inputs. Equations that carry it were
    /// derived from exactly these.
    #[must_use]
    pub fn text_hash(&self) -> String {
        let text = without_shapes(&self.source.text);
        let bound = self.bindings.iter().map(|b| format!("\n{} = {}", b.input, b.formula));
        text_hash(&bound.fold(text.to_owned(), |text, bound| text + &bound))
    }

    /// Numbers of configuration variables, constraints, generalized coordinates and generalized speeds, in words.
    #[must_use]
    pub fn count(&self) -> String {
        let plural = |n: usize, one: &str| if n == 1 { format!("1 {one}") } else { format!("{n} {one}s") };
        let clock = usize::from(self.time().is_some());
        let count = format!(
            "{}, {}, {}, {}, {}",
            plural(self.configuration_variables, "configuration variable"),
            plural(self.constraints.len() + self.loops.len() + self.closed.len(), "holonomic constraint"),
            plural(self.coordinates.len() - clock, "generalized coordinate"),
            plural(self.motion_constraints.len() - self.loops.len() - clock, "nonholonomic constraint"),
            plural(self.speeds.len(), "generalized speed"),
        );
        if clock == 0 { count } else { count + ", time" }
    }
}

/// The hash that compiled equations carry: the first 16 hexadecimal digits of SHA-256.
#[must_use]
pub fn text_hash(text: &str) -> String {
    use sha2::Digest;
    let digest = sha2::Sha256::digest(text.as_bytes());
    let first = digest.iter().take(8).fold(0_u64, |n, byte| n << 8 | u64::from(*byte));
    format!("{first:016x}")
}
