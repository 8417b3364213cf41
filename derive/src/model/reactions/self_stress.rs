//! Self-stress: reactions that equilibrium does not determine. They occur in a loop that joints or rolling contacts
//! hold more often than necessary. They also occur where equations keep two points together and do not state which
//! further directions are held.
//!
//! For each redundant equation of a joint or contact, there are forces and torques in equilibrium with one another.
//! They do no work along any rate q̇, and may have any size. They satisfy A λ = 0, where A has a column for each of
//! them: its work along the rates q̇. They are computed in one closed pose, in doubles, at the default values. Forces
//! and torques of loops go down the tree of bodies to the ground.
//!
//! Source: S. Pellegrino & C. R. Calladine, Matrix analysis of statically and kinematically indeterminate frameworks,
//! *International Journal of Solids and Structures* 22 (1986) 409–428.

use super::interactions::Interaction;
use super::random_pose::RandomModel;
use super::relative_motion::{BodyPair, RelativeMotion, reaction_pair};
use crate::algebra::term::calculus::{Differential, Gradient};
use crate::algebra::{Arena, Expr};
use crate::geometry::{Frames, Motion, Vector};
use crate::model::impossible_bodies::{default_parameter_values, values_of_terms_at};
use crate::model::{ForcePlace, JointReaction, Model, Reaction, ReactionKind, SlipComponent};
use nalgebra::{DMatrix, DVector, Vector3};
use tripos_linear::SingularValues;

/// Norm up to which a column counts as dependent on other columns. It is the norm that the column keeps after these
/// are projected out, relative to its own norm.
const DEPENDENT: f64 = 1e-6;
/// Fraction of the largest component below which another component counts as zero.
const NOTHING: f64 = 1e-7;

/// Largest number of poses that are tried until one is found in which all required values exist.
const MOST_POSES: usize = 20;

/// Wrench: sum of forces and torques on a body, with components in the inertial frame.
#[derive(Clone, Copy)]
struct Wrench {
    /// Force, N.
    force: Vector3<f64>,
    /// Moment about the origin, N m.
    moment: Vector3<f64>,
}

impl Wrench {
    /// Wrench without force and moment.
    const ZERO: Self = Self { force: Vector3::new(0.0, 0.0, 0.0), moment: Vector3::new(0.0, 0.0, 0.0) };
}

/// Frames, points and reactions of a model in one pose, in doubles.
struct StressPose {
    /// Axes of each frame, with components in the inertial frame.
    axes: Vec<[Vector3<f64>; 3]>,
    /// Positions of the points in the inertial frame, m.
    points: Vec<Vector3<f64>>,
    /// Reactions as (direction in the inertial frame, work along each rate q̇). The reactions of the model come
    /// first, then redundant ones.
    acting: Vec<(Vector3<f64>, DVector<f64>)>,
}

/// Self-stress: forces and torques between pairs of bodies that are in equilibrium without loads.
struct SelfStress {
    /// Wrench on the first body of each pair; the opposite acts on the second.
    between: Vec<(BodyPair, Wrench)>,
    /// Largest force, N, and largest moment, N m, of the self-stress.
    size: (f64, f64),
    /// Largest distance of a point from the origin, m; 1 m if all points are at the origin.
    reach: f64,
}

/// Kind of the connection that holds a redundant direction.
enum RedundantConnection {
    /// Joint of the model file, by name.
    Joint(String),
    /// Rolling contact of the model file, by name.
    Contact(String),
    /// Reaction that the model file states.
    Connection,
}

/// Redundant reaction: its direction is held by another connection as well.
struct RedundantReaction {
    /// Name of the joint's or contact's equation, or of the stated reaction.
    name: String,
    /// Connection that holds the redundant direction.
    by: RedundantConnection,
    /// Reaction of size 1 along the redundant direction.
    reaction: Reaction,
}

impl Model {
    /// Message and advice for a wanted component of a force or torque that equilibrium does not determine; `None` if
    /// it is determined. `text` names the component in the message.
    pub(in crate::model) fn undetermined_component_message(
        &self,
        sought: &Interaction,
        text: &str,
    ) -> Option<(String, String)> {
        let is_simple =
            self.redundant.is_empty() && self.loops.is_empty() && self.repeated.iter().all(|r| r.rolled.is_none());
        if is_simple && self.stated_reactions().is_empty() {
            return None;
        }
        let drawn = RandomModel::new(self, &mut self.arena.clone());
        let relative = drawn.map(|drawn| RelativeMotion { model: self, drawn, ways_if_open: None });
        let resting = relative.as_ref().map(RelativeMotion::supported_pairs);
        let repeated = self.redundant_reactions(resting.as_deref().unwrap_or_default());
        if repeated.is_empty() {
            return self.closure_self_stress_message(&relative?, &resting?, sought, text);
        }
        let reactions: Vec<Reaction> = repeated.iter().map(|held| held.reaction.clone()).collect();
        let (Some(pose), Some(resting)) = (self.closed_stress_pose(&reactions), resting) else {
            let held = repeated.iter().filter(|held| !held.reaction.is_stated);
            let names: Vec<String> = held.map(|held| format!("`{}`", held.name)).collect();
            if names.is_empty() {
                return None;
            }
            let message = format!(
                "it is not known whether equilibrium determines `{text}`: joints or contacts hold {} more than once, and no closed pose is known \
                 at the default values",
                names.join(", ")
            );
            return Some((
                message,
                "give every parameter a default value, or let something leave that free".to_owned(),
            ));
        };
        let first = self.reactions.len();
        let twice = repeated.iter().enumerate().find_map(|(at, held)| {
            let stress = self.self_stress(&pose, first + at, &held.reaction, &resting)?;
            let share = stress.share(&pose, sought)?;
            Some(self.self_stress_message(text, sought, held, share, &stress))
        });
        twice.or_else(|| self.closure_self_stress_message(&relative?, &resting, sought, text))
    }

    /// Message and advice for a wanted component that is undetermined because equations keep two points together;
    /// otherwise `None`. `text` names the component in the message.
    fn closure_self_stress_message(
        &self,
        relative: &RelativeMotion<'_>,
        resting: &[BodyPair],
        sought: &Interaction,
        text: &str,
    ) -> Option<(String, String)> {
        let closings = relative.closure_reactions(resting);
        if closings.is_empty() {
            return None;
        }
        // Without a known closed pose, any pose shows the components that a plane mechanism leaves
        // undetermined.
        let pose = self.closed_stress_pose(&closings).or_else(|| self.any_stress_pose(&closings))?;
        let first = self.reactions.len();
        closings.iter().enumerate().find_map(|(at, reaction)| {
            let stress = self.self_stress(&pose, first + at, reaction, resting)?;
            let share = stress.share(&pose, sought)?;
            let unit = |is_torque: bool| if is_torque { "N m" } else { "N" };
            let BodyPair { body, against } = reaction_pair(reaction.kind);
            let message = format!(
                "equilibrium does not determine `{text}`: equations keep `{}` together with `{}`, and do not say what else holds there; each {} of a \
                 {} adds {} {} to it, whatever moves",
                self.bodies[body].name,
                self.holder_name(against),
                unit(matches!(reaction.kind, ReactionKind::Torque { .. })),
                reaction.name,
                rounded_stress_share(share),
                unit(sought.is_torque)
            );
            let help = "close the loop by [joints], name its reactions under [reactions], or ask for a component that is determined";
            Some((message, help.to_owned()))
        })
    }

    /// Redundant reactions of size 1: those of joints, forces at rolling contacts, and stated reactions. Examples are
    /// the ground that presses on one of two wheels, and a gear that presses on another gear along the line of their
    /// pinned centres. A direction that a body's own support holds twice counts once.
    fn redundant_reactions(&self, resting: &[BodyPair]) -> Vec<RedundantReaction> {
        let contacts = self.repeated.iter().filter_map(|r| Some((r.name.clone(), r.rolled?)));
        let contacts =
            contacts.filter(|(_, rolled)| !resting.iter().any(|pair| pair.joins(Some(rolled.body), rolled.against)));
        let contacts = contacts.map(|(name, SlipComponent { contact, body, against, point, frame, axis, .. })| {
            let (on, against) = (ForcePlace { body, point }, against.map(|body| ForcePlace { body, point }));
            let kind = ReactionKind::Force { on, against };
            let (label, symbol) = (format!("{name}_force"), Expr::ONE);
            let direction = unit_vector(axis);
            let reaction =
                Reaction { name: label, symbol, kind, frame, direction, is_stated: false, is_shared: false, law: None };
            RedundantReaction {
                name,
                by: RedundantConnection::Contact(self.contacts.rolling[contact].clone()),
                reaction,
            }
        });
        // Supports may hold the direction of a stated reaction between bodies that do not rest on one
        // another.
        let named = self.stated_reactions().iter().filter(|reaction| {
            let BodyPair { body, against } = reaction_pair(reaction.kind);
            !resting.iter().any(|pair| pair.joins(Some(body), against))
        });
        let named = named.map(|reaction| RedundantReaction {
            name: reaction.name.clone(),
            by: RedundantConnection::Connection,
            reaction: reaction.clone(),
        });
        let joints = self.redundant.iter().map(|held| {
            let JointReaction { joint, equation, reaction } = held.clone();
            RedundantReaction { name: equation, by: RedundantConnection::Joint(joint), reaction }
        });
        joints.chain(contacts).chain(named).collect()
    }

    /// Message and advice for a wanted component that a redundant reaction leaves undetermined. Each unit of the
    /// redundant reaction `held` adds `share` to the component, which `text` names.
    fn self_stress_message(
        &self,
        text: &str,
        sought: &Interaction,
        held: &RedundantReaction,
        share: f64,
        stress: &SelfStress,
    ) -> (String, String) {
        let RedundantReaction { name, by, reaction } = held;
        let what = match by {
            RedundantConnection::Contact(_) => "contacts hold",
            RedundantConnection::Connection => "connections hold",
            RedundantConnection::Joint(_) => "the joints hold",
        };
        let unit = |is_torque: bool| if is_torque { "N m" } else { "N" };
        let is_free_torque = matches!(reaction.kind, ReactionKind::Torque { .. });
        let way: Vec<String> = stress
            .between
            .iter()
            .filter(|(_, wrench)| !stress.is_nothing(wrench))
            .map(|(pair, _)| format!("{}–{}", self.holder_name(pair.against), self.bodies[pair.body].name))
            .collect();
        let message = format!(
            "equilibrium does not determine `{text}`: {what} `{name}` more than once, so that each {} of `{}` adds {} {} to it, \
             whatever moves; the same goes through {}",
            unit(is_free_torque),
            reaction.name,
            rounded_stress_share(share),
            unit(sought.is_torque),
            way.join(", ")
        );
        let free = match by {
            RedundantConnection::Contact(contact) => format!("let something give way where `{contact}` rolls"),
            RedundantConnection::Connection => {
                "name under [reactions] all forces and torques that hold these bodies".to_owned()
            }
            RedundantConnection::Joint(joint) => format!(
                "let the joint `{joint}`, or another of the loop, leave that motion free (a ball or a cylinder instead of a pin)"
            ),
        };
        (message, format!("{free}, or ask for a component that is determined"))
    }

    /// Pose of the assembly branch in which independence of constraints was decided, with the reactions that act in
    /// it. `None` if no closed pose is known.
    fn closed_stress_pose(&self, repeated: &[Reaction]) -> Option<StressPose> {
        match &self.branch {
            Some(branch) => self.stress_pose(repeated, branch.pose.clone(), 0),
            // Without loops, any pose and any parameter values will do.
            None if self.loops.is_empty() => self.any_stress_pose(repeated),
            None => None,
        }
    }

    /// Pose in which all required terms have values; `None` if none is found.
    fn any_stress_pose(&self, repeated: &[Reaction]) -> Option<StressPose> {
        (0..MOST_POSES).find_map(|at| {
            let first = at * (self.coordinates.len() + self.parameters.len());
            self.stress_pose(repeated, (first..).take(self.coordinates.len()).map(quasi_random).collect(), first)
        })
    }

    /// Evaluates frames, points and reactions in a pose. Parameters without a default value get
    /// quasi-random values, from index `first` on. `None` if a value does not exist.
    fn stress_pose(&self, repeated: &[Reaction], pose: Vec<f64>, first: usize) -> Option<StressPose> {
        let mut known = default_parameter_values(&self.parameters);
        if self.branch.is_none() {
            let open = self.parameters.iter().map(|p| p.symbol).filter(|symbol| known.iter().all(|(s, _)| s != symbol));
            let open: Vec<Expr> = open.collect();
            let drawn = (first + self.coordinates.len()..).map(|at| 1.0 + quasi_random(at));
            known.extend(open.into_iter().zip(drawn));
        }
        known.extend(self.coordinates.iter().map(|c| c.symbol).zip(pose));
        let mut arena = self.arena.clone();
        let mut frames = Frames::new(&self.frames);
        let mut wanted = Vec::new();
        for frame in 0..self.frames.len() {
            for axis in 0..3 {
                wanted.extend(frames.express(&mut arena, &Vector::in_frame(frame, unit_vector(axis)), 0));
            }
        }
        for point in 0..self.points.len() {
            let position = self.position(&mut arena, point);
            wanted.extend(frames.express(&mut arena, &position, 0));
        }
        let rates: Vec<_> = self.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        let mut d_dt = Differential::along(&rates);
        let motion = Motion::new(&mut arena, &mut frames, &self.frames, &self.points, &mut d_dt);
        let mut along = Gradient::new(&self.q_dot());
        let all: Vec<&Reaction> = self.reactions.iter().chain(repeated).collect();
        for reaction in &all {
            let direction = Vector::in_frame(reaction.frame, reaction.direction);
            wanted.extend(frames.express(&mut arena, &direction, 0));
            let velocity = self.relative_velocity(&mut arena, &mut frames, &motion, reaction.kind);
            let power = frames.dot(&mut arena, &direction, &velocity);
            wanted.extend(self.slopes(&mut arena, &mut along, power));
        }
        let values = values_of_terms_at(&arena, &known, &wanted)?;
        if !values.iter().all(|value| value.is_finite()) {
            return None;
        }
        let mut values = values.into_iter();
        let mut triple = || {
            let mut next = || values.next();
            Some(Vector3::new(next()?, next()?, next()?))
        };
        let axes = (0..self.frames.len()).map(|_| Some([triple()?, triple()?, triple()?])).collect::<Option<_>>()?;
        let points = (0..self.points.len()).map(|_| triple()).collect::<Option<_>>()?;
        let n = self.coordinates.len();
        let mut rest = values;
        let mut acting = Vec::new();
        for _ in &all {
            let own: Vec<f64> = rest.by_ref().take(3 + n).collect();
            acting.push((Vector3::from_row_slice(&own[..3]), DVector::from_row_slice(&own[3..])));
        }
        Some(StressPose { axes, points, acting })
    }

    /// Partial derivatives of a power with respect to each rate q̇, with 0 for the rate of time.
    fn slopes(&self, arena: &mut Arena, along: &mut Gradient, power: Expr) -> Vec<Expr> {
        let mut list = vec![Expr::ZERO; self.coordinates.len()];
        for (at, slope) in along.apply(arena, power).iter().filter(|(at, _)| Some(*at) != self.time()) {
            list[*at] = *slope;
        }
        list
    }

    /// Work of a reaction of size 1 along each rate q̇. After it come the forces and moments that the reaction
    /// transmits to contacts without own reactions (`Contacts::idle`), which must be zero.
    fn reaction_effect(&self, pose: &StressPose, at: usize, reaction: &Reaction, resting: &[BodyPair]) -> DVector<f64> {
        let (direction, work) = &pose.acting[at];
        let mut on_bodies = vec![Wrench::ZERO; self.bodies.len()];
        add_stress_on_bodies(&mut on_bodies, reaction, stress_wrench(pose, reaction, *direction));
        let mut all: Vec<f64> = work.iter().copied().collect();
        for (pair, wrench) in stress_on_supports(&mut on_bodies, resting) {
            if self.contacts.idle.contains(&pair.body) {
                all.extend(wrench.force.iter().chain(wrench.moment.iter()));
            }
        }
        DVector::from_vec(all)
    }

    /// Self-stress that contains one redundant reaction, with size 1. `None` if other reactions cannot
    /// balance it.
    fn self_stress(
        &self,
        pose: &StressPose,
        redundant: usize,
        its_reaction: &Reaction,
        resting: &[BodyPair],
    ) -> Option<SelfStress> {
        let all = self.reactions.len();
        let effect = |at: usize, reaction: &Reaction| self.reaction_effect(pose, at, reaction, resting);
        let work = &effect(redundant, its_reaction);
        let columns: Vec<DVector<f64>> = self.reactions.iter().enumerate().map(|(at, r)| effect(at, r)).collect();
        let matrix = DMatrix::from_fn(work.len(), all, |row, column| columns[column][row]);
        let length = work.norm();
        let mut sizes = if length > 0.0 && all > 0 {
            let found = SingularValues::new(&matrix).solve(work, NOTHING * matrix.norm());
            if (&matrix * &found - work).norm() > DEPENDENT * length {
                return None;
            }
            -found
        } else if length > 0.0 {
            return None;
        } else {
            DVector::zeros(all)
        };
        sizes = sizes.push(1.0);
        let mut between: Vec<(BodyPair, Wrench)> = Vec::new();
        let mut on_bodies = vec![Wrench::ZERO; self.bodies.len()];
        let reactions = self.reactions.iter().chain([its_reaction]);
        let places = (0..all).chain([redundant]);
        for ((reaction, place), size) in reactions.zip(places).zip(sizes.iter()) {
            let wrench = stress_wrench(pose, reaction, pose.acting[place].0 * *size);
            add_stress_on_bodies(&mut on_bodies, reaction, wrench);
            add_stress_between(&mut between, reaction_pair(reaction.kind), wrench);
        }
        for (pair, Wrench { force, moment }) in stress_on_supports(&mut on_bodies, resting) {
            add_stress_between(&mut between, pair, Wrench { force: -force, moment: -moment });
        }
        let reach = pose.points.iter().map(Vector3::norm).fold(0.0, f64::max);
        // The redundant reaction has size 1, even if the balancing reactions cancel it between two bodies.
        let own = if let ReactionKind::Force { .. } = its_reaction.kind { (1.0, 0.0) } else { (0.0, 1.0) };
        let size = between
            .iter()
            .fold(own, |(f, m): (f64, f64), (_, wrench)| (f.max(wrench.force.norm()), m.max(wrench.moment.norm())));
        Some(SelfStress { between, size, reach: if reach > 0.0 { reach } else { 1.0 } })
    }
}

impl SelfStress {
    /// True if a wrench is zero within rounding, compared with the largest wrench of the self-stress.
    fn is_nothing(&self, wrench: &Wrench) -> bool {
        wrench.force.norm() <= NOTHING * (self.size.0 + self.size.1 / self.reach)
            && wrench.moment.norm() <= NOTHING * (self.size.0 * self.reach + self.size.1)
    }

    /// Change of the wanted force or torque component per unit of self-stress; `None` if zero.
    fn share(&self, pose: &StressPose, sought: &Interaction) -> Option<f64> {
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for (BodyPair { body, against }, wrench) in &self.between {
            let sign = match (Some(*body), *against) {
                pair if pair == (sought.on, sought.by) => 1.0,
                pair if pair == (sought.by, sought.on) => -1.0,
                _ => continue,
            };
            force += wrench.force * sign;
            moment += wrench.moment * sign;
        }
        let axis = pose.axes[sought.frame][sought.axis];
        let about = sought.about.map_or_else(Vector3::zeros, |at| pose.points[at]);
        let (value, size) = if sought.is_torque {
            ((moment - about.cross(&force)).dot(&axis), self.size.0 * self.reach + self.size.1)
        } else {
            (force.dot(&axis), self.size.0 + self.size.1 / self.reach)
        };
        (value.abs() > NOTHING * size).then_some(value)
    }
}

/// Adds the wrench of a reaction to the body on which it acts, and the opposite wrench to the other body.
fn add_stress_on_bodies(on_bodies: &mut [Wrench], reaction: &Reaction, wrench: Wrench) {
    let BodyPair { body, against } = reaction_pair(reaction.kind);
    add_stress_wrench(&mut on_bodies[body], wrench, 1.0);
    if let Some(other) = against {
        add_stress_wrench(&mut on_bodies[other], wrench, -1.0);
    }
}

/// Wrench that each body transmits to its support, as (body with its support, wrench). `on_bodies` are the wrenches
/// that act on the bodies. `resting` lists the outermost bodies first.
fn stress_on_supports(on_bodies: &mut [Wrench], resting: &[BodyPair]) -> Vec<(BodyPair, Wrench)> {
    let mut list = Vec::with_capacity(resting.len());
    for pair in resting {
        let wrench = on_bodies[pair.body];
        if let Some(holder) = pair.against {
            add_stress_wrench(&mut on_bodies[holder], wrench, 1.0);
        }
        list.push((*pair, wrench));
    }
    list
}

/// Adds a wrench between two bodies to the sum for their pair in the list.
fn add_stress_between(list: &mut Vec<(BodyPair, Wrench)>, pair: BodyPair, wrench: Wrench) {
    match list.iter_mut().find(|(known, _)| *known == pair || Some(*known) == pair.reversed()) {
        Some((known, sum)) => add_stress_wrench(sum, wrench, if *known == pair { 1.0 } else { -1.0 }),
        None => list.push((pair, wrench)),
    }
}

/// Adds `sign` times a wrench to a sum.
fn add_stress_wrench(sum: &mut Wrench, wrench: Wrench, sign: f64) {
    sum.force += wrench.force * sign;
    sum.moment += wrench.moment * sign;
}

/// Wrench of a reaction with the given vector: a force at the reaction's point, or a torque.
fn stress_wrench(pose: &StressPose, reaction: &Reaction, vector: Vector3<f64>) -> Wrench {
    match reaction.kind {
        ReactionKind::Force { on, .. } => Wrench { force: vector, moment: pose.points[on.point].cross(&vector) },
        ReactionKind::Torque { .. } => Wrench { force: Vector3::zeros(), moment: vector },
    }
}

/// Unit vector of the axis 0, 1 or 2, as terms.
fn unit_vector(axis: usize) -> [Expr; 3] {
    let mut unit = [Expr::ZERO; 3];
    unit[axis] = Expr::ONE;
    unit
}

/// Quasi-random number between 0 and 1: the fractional part of a multiple of the golden ratio.
fn quasi_random(at: usize) -> f64 {
    (0.618_033_988_749_895 * (at + 1) as f64).fract()
}

/// Text of a value with three significant digits.
fn rounded_stress_share(value: f64) -> String {
    let text = format!("{value:.2e}");
    text.parse::<f64>().map_or(text, |value| value.to_string())
}
