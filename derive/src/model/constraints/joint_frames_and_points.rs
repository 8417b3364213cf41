//! Frames and points that joints add to a model, and the equations of joints that close loops.

use super::configuration_constraints::{Closure, StatedConstraint};
use crate::algebra::term::calculus::Substitution;
use crate::algebra::{Expr, Rational};
use crate::geometry::{Frame, Turn, Vector, cross_components};
use crate::model::bodies::elements::{Elements, vector};
use crate::model::bodies::joint_kinds::{JointFreedom, JointKind};
use crate::model::bodies::joints::{Joint, Joints, PlacedBody};
use crate::model::bodies::mechanism_motion::MechanismMotion;
use crate::model::reading::declared_names::{CONFIGURATION, NameKind, PARAMETERS};
use crate::model::reading::loading::Loading;
use crate::model::reading::tree::Node;
use crate::model::units::Unit;
use crate::model::{ForcePlace, HeldOrientation, JointReaction, JointedBody, Model, Reaction, ReactionKind};
use crate::toml_reader::Located;
use toml::de::{DeTable, DeValue};

/// Frame as (parent, rotation), before frames are sorted.
type FrameNode = Node<Turn>;
/// Point as (parent, frame of its components, components in m), before points are sorted.
type PointNode = Node<(Located, [Expr; 3])>;

/// Joint that closes a loop, with its frames, points and bodies by index.
pub struct ClosingJoint {
    /// Name of the closing joint in the model file.
    name: Located,
    /// Kind of the joint, which determines the equations of the loop.
    kind: JointKind,
    /// Axes of the joint's rotations, 0 to 2.
    axes: Vec<usize>,
    /// Indices of the joint's frame on the body to which it is attached, and of its frame on the
    /// closing body.
    frames: [usize; 2],
    /// True if the inertial frame is the last common ancestor of the joint's two frames.
    parts_at_ground: bool,
    /// Indices of the joint's point on the body to which it is attached, and of its point on the
    /// closing body.
    points: [usize; 2],
    /// Index of the closing body, and of the body to which the joint attaches it; `None` for the ground.
    bodies: (usize, Option<usize>),
}

impl Joint<'_> {
    /// Name `JOINT_part` of a frame or point that the joint `JOINT` adds.
    fn joint_part_name(&self, part: &str) -> Located {
        Located { text: format!("{}_{part}", self.name.text), span: self.name.span.clone(), exact: false }
    }

    /// Name of the joint's base frame, which is fixed on the body to which the joint is attached. The joint's
    /// rotations and displacements are measured from this frame.
    fn base_frame_name(&self, joints: &Joints<'_>, root: &str) -> Located {
        let has_own = self.entry.contains_key("turned") || self.along.is_some();
        if has_own { self.joint_part_name("base") } else { self.frame_below(joints, root) }
    }

    /// Name of the frame of the body to which the joint is attached, or of the inertial frame.
    fn frame_below(&self, joints: &Joints<'_>, root: &str) -> Located {
        match self.to.as_ref().and_then(|to| Some((to, joints.bodies.get(&to.text)?))) {
            Some((to, placed)) => Located { text: placed.frame.text.clone(), ..to.clone() },
            None => Located { text: root.to_owned(), span: self.name.span.clone(), exact: false },
        }
    }

    /// Name of the point from which positions on a body are measured. It is the point of the joint that places the
    /// body, or else the body's mass centre. For the ground it is the origin.
    fn body_reference_point(&self, body: Option<&Located>, joints: &Joints<'_>, origin: &str) -> Located {
        let text = match body.and_then(|body| joints.bodies.get(&body.text)) {
            Some(PlacedBody { joint: Some(joint), .. }) => joint.text.clone(),
            Some(placed) => placed.centre.text.clone(),
            None => origin.to_owned(),
        };
        Located { text, span: body.unwrap_or(&self.name).span.clone(), exact: false }
    }
}

impl<'a> Joints<'a> {
    /// Joints that close loops, with indices into the sorted frames, points and bodies.
    pub fn closing_joints(&self, elements: &Elements) -> Vec<ClosingJoint> {
        let frame = |name: &str| elements.frames.iter().position(|f| f.name == name);
        let point = |name: &str| elements.points.iter().position(|p| p.name == name);
        let body = |name: &str| elements.bodies.iter().position(|b| b.name == name);
        let root = elements.frames.first().map_or("", |f| f.name.as_str());
        let closing = |joint: &Joint<'a>| {
            let frames = [
                frame(&joint.base_frame_name(self, root).text)?,
                frame(&joint.joint_part_name("closed_base").text)
                    .or_else(|| frame(&self.bodies.get(&joint.body.text)?.frame.text))?,
            ];
            Some(ClosingJoint {
                name: joint.name.clone(),
                kind: joint.kind,
                axes: joint.axes.clone(),
                frames,
                parts_at_ground: last_common_frame(&elements.frames, frames) == 0,
                points: [point(&joint.name.text)?, point(&joint.joint_part_name("closed").text)?],
                bodies: (
                    body(&joint.body.text)?,
                    match &joint.to {
                        Some(to) => Some(body(&to.text)?),
                        None => None,
                    },
                ),
            })
        };
        self.list.iter().filter(|joint| !joint.carries).filter_map(closing).collect()
    }
}

impl Joints<'_> {
    /// Bodies that joints place, each with its point at the joint and with the body to which the joint attaches it.
    pub fn jointed_bodies(&self, elements: &Elements) -> Vec<JointedBody> {
        let body = |name: &str| elements.bodies.iter().position(|body| body.name == name);
        let carries = |joint: &Joint<'_>| {
            let on = match &joint.to {
                Some(to) => Some(body(&to.text)?),
                None => None,
            };
            let point = elements.points.iter().position(|point| point.name == joint.name.text)?;
            Some(JointedBody { body: body(&joint.body.text)?, on, point })
        };
        self.list.iter().filter(|joint| joint.carries).filter_map(carries).collect()
    }
}

impl<'a> Loading<'a> {
    /// Declares the frames that joints add, and returns them with their rotations. Errors are recorded in the reader.
    pub fn joint_frames(&mut self, joints: &Joints<'a>, root: &str) -> Vec<FrameNode> {
        let mut nodes = Vec::new();
        for joint in &joints.list {
            let mut parent = joint.frame_below(joints, root);
            let (turned, mut tilted) = (self.reader.get(joint.entry, "turned"), None);
            if turned.is_some() || joint.along.is_some() {
                let base = joint.joint_part_name("base");
                let turns = turned.map_or(Some(Vec::new()), |value| self.turns_under_key(joint, "turned", value));
                let turns = turns.and_then(|mut turns| {
                    if let Some(along) = joint.along {
                        let [there, back] = self.turn_towards_vector(along, &format!("the axis of {}", joint.what))?;
                        turns.push(there);
                        tilted = Some(back);
                    }
                    Some(turns)
                });
                let Some(turns) = turns else {
                    self.names.mark_wrong_name(&base.text);
                    if let Some(placed) = joints.bodies.get(&joint.body.text).filter(|_| joint.carries) {
                        self.names.mark_wrong_name(&placed.frame.text);
                    }
                    continue;
                };
                parent = self.add_frame_chain(&mut nodes, parent, &base, turns);
            }
            if let Some(turned) = self.reader.get(joint.entry, "body_turned")
                && let Some(placed) = joints.bodies.get(&joint.body.text)
            {
                let last = joint.joint_part_name("closed_base");
                match self.turns_under_key(joint, "body_turned", turned) {
                    Some(turns) => drop(self.add_frame_chain(&mut nodes, placed.frame.clone(), &last, turns)),
                    None => self.names.mark_wrong_name(&last.text),
                }
            }
            let Some(placed) = joints.bodies.get(&joint.body.text).filter(|_| joint.carries) else { continue };
            let turns = self.joint_frame_turns(joint).into_iter().chain(tilted).collect();
            self.add_frame_chain(&mut nodes, parent, &placed.frame, turns);
        }
        nodes
    }

    /// Rotations by which a joint orients the body that it places, as terms in the joint's coordinates. A joint
    /// without rotations gives one rotation by the angle 0.
    fn joint_frame_turns(&mut self, joint: &Joint<'a>) -> Vec<Turn> {
        let mut turns = Vec::new();
        let mut parameters = Vec::new();
        for (name, freedom) in joint.coordinates.iter().zip(joint.kind.freedoms(&joint.axes)) {
            let symbol = self.arena.symbol(&name.text);
            match freedom {
                JointFreedom::About(axis) | JointFreedom::Screwed(axis) => turns.push(Turn::About(axis, symbol)),
                JointFreedom::Parameter => parameters.push(symbol),
                JointFreedom::Along(_) => {}
            }
        }
        if let Ok(parameters) = <[Expr; 4]>::try_from(parameters) {
            turns.push(Turn::by_euler_parameters(&mut self.arena, parameters));
        }
        if turns.is_empty() {
            turns.push(Turn::About(2, Expr::ZERO));
        }
        turns
    }

    /// Adds a chain of frames that leads from `parent` to the frame `last` by successive rotations. Intermediate
    /// frames are declared as `LAST_turnK`. Returns the name of the last frame in the chain.
    pub fn add_frame_chain(
        &mut self,
        nodes: &mut Vec<FrameNode>,
        mut parent: Located,
        last: &Located,
        turns: Vec<Turn>,
    ) -> Located {
        let count = turns.len();
        for (at, payload) in turns.into_iter().enumerate() {
            let is_last = at + 1 == count;
            let turned = || Located { text: format!("{}_turn{}", last.text, at + 1), ..last.clone() };
            let name = if is_last { last.clone() } else { turned() };
            // The frame `last` is already declared if the model file states it.
            if !is_last || self.names.kind(&name.text).is_none() {
                self.names.declare_joint_name(&mut self.reader, &name, NameKind::Frame);
            }
            nodes.push(Node { name: name.clone(), parent, payload });
            parent = name;
        }
        parent
    }

    /// Declares the points that joints add, and returns them. Each joint adds a point with the joint's name, and the
    /// mass centre of the body that it places. Errors are recorded in the reader.
    pub fn joint_points(&mut self, joints: &Joints<'a>, table: &'a DeTable<'a>, root: (&str, &str)) -> Vec<PointNode> {
        let stated = table.get("points").and_then(|v| v.get_ref().as_table());
        let mut nodes = Vec::new();
        for joint in &joints.list {
            let (below, base) = (joint.frame_below(joints, root.0), joint.base_frame_name(joints, root.0));
            let home = joint.body_reference_point(joint.to.as_ref(), joints, root.1);
            let Some((mut from, at)) = self.joint_point_place(joint, "at", home) else {
                self.mark_wrong_joint_points(joint, joints);
                continue;
            };
            let Some(way) = self.joint_point_displacement(joint) else {
                self.mark_wrong_joint_points(joint, joints);
                continue;
            };
            let mut payload = (below.clone(), at);
            if base.text == below.text {
                payload.1 = [0, 1, 2].map(|i| self.arena.add(at[i], way[i]));
            } else if way != [Expr::ZERO; 3] {
                if at != [Expr::ZERO; 3] {
                    let name = joint.joint_part_name("on");
                    self.names.declare_joint_name(&mut self.reader, &name, NameKind::Point);
                    nodes.push(Node { name: name.clone(), parent: from, payload });
                    from = name;
                }
                payload = (base, way);
            }
            self.names.declare_joint_name(&mut self.reader, &joint.name, NameKind::Point);
            nodes.push(Node { name: joint.name.clone(), parent: from, payload });
            let Some(placed) = joints.bodies.get(&joint.body.text) else { continue };
            if !joint.carries {
                let home = joint.body_reference_point(Some(&joint.body), joints, root.1);
                let Some((from, at)) = self.joint_point_place(joint, "body_at", home) else { continue };
                let name = joint.joint_part_name("closed");
                self.names.declare_joint_name(&mut self.reader, &name, NameKind::Point);
                nodes.push(Node { name, parent: from, payload: (placed.frame.clone(), at) });
            } else if stated.is_none_or(|points| !points.contains_key(placed.centre.text.as_str())) {
                let Some((from, at)) = self.joint_point_place(joint, "centre", joint.name.clone()) else {
                    self.names.mark_wrong_name(&placed.centre.text);
                    continue;
                };
                self.names.declare_joint_name(&mut self.reader, &placed.centre, NameKind::Point);
                nodes.push(Node { name: placed.centre.clone(), parent: from, payload: (placed.frame.clone(), at) });
            } else if let Some(value) = self.reader.get(joint.entry, "centre") {
                let message = format!("the mass centre of `{}` is a point already", joint.body.text);
                self.reader.error(value.span(), message, "state it in one of the two places");
            }
        }
        nodes
    }

    /// Marks the points of a joint as wrongly declared, after their error was reported.
    fn mark_wrong_joint_points(&mut self, joint: &Joint<'a>, joints: &Joints<'a>) {
        self.names.mark_wrong_name(&joint.name.text);
        if let Some(placed) = joints.bodies.get(&joint.body.text).filter(|_| joint.carries) {
            self.names.mark_wrong_name(&placed.centre.text);
        }
    }

    /// Reads the position of a joint on a body under a key, which is a point or three components from `home`, m. If
    /// the key is absent, the position is `home`. `None` after an error is reported.
    fn joint_point_place(&mut self, joint: &Joint<'a>, key: &str, home: Located) -> Option<(Located, [Expr; 3])> {
        match self.reader.get(joint.entry, key) {
            None => Some((home, [Expr::ZERO; 3])),
            Some(value) => match value.get_ref() {
                DeValue::String(_) => Some((self.reader.string(value, key)?, [Expr::ZERO; 3])),
                _ => {
                    let metre = Unit::new(1, 0, 0);
                    let (what, span) = (&joint.what, &joint.name.span);
                    Some((home, vector(self, joint.entry, key, what, span, CONFIGURATION, &metre)?))
                }
            },
        }
    }

    /// Displacement of a joint's point that the joint's coordinates cause, m, with components in the joint's base
    /// frame. `None` after an error is reported.
    fn joint_point_displacement(&mut self, joint: &Joint<'a>) -> Option<[Expr; 3]> {
        let mut way = [Expr::ZERO; 3];
        for (name, freedom) in joint.coordinates.iter().zip(joint.kind.freedoms(&joint.axes)) {
            let q = self.arena.symbol(&name.text);
            match freedom {
                JointFreedom::Along(axis) => way[axis] = q,
                JointFreedom::Screwed(axis) => {
                    let lead = self.reader.required(joint.entry, "lead", &joint.what, &joint.name.span)?;
                    let lead = self.reader.formula(lead, "`lead`")?;
                    let lead = self.quantity(&lead, PARAMETERS, &Unit::new(1, 0, 0), "the lead of a screw")?;
                    let turn = self.arena.pi();
                    let turn = self.arena.scale(turn, &Rational::integer(2));
                    let advance = self.arena.mul(lead, q);
                    way[axis] = self.arena.div(advance, turn)?;
                }
                JointFreedom::About(_) | JointFreedom::Parameter => {}
            }
        }
        Some(way)
    }

    /// Equations of joints that close loops, each with the reaction that enforces it. They are components of the
    /// vector between the joint's two points, m, and cosines between axes that stay perpendicular.
    ///
    /// The reaction force on the closing body acts at that body's joint point. Its opposite acts on the other body,
    /// at its joint point or at its material that is at the first point. So the pair does no work in open loops
    /// either.
    pub fn closing_joint_equations(
        &mut self,
        moving: &mut MechanismMotion,
        closings: &[ClosingJoint],
    ) -> ClosingEquations {
        let (mut list, mut holding, mut closures) = (Vec::new(), Vec::new(), Vec::new());
        let mut orientations = Vec::new();
        for ClosingJoint { name, kind, axes, frames: [base, body], parts_at_ground, points: [on, at], bodies } in
            closings
        {
            let axis = axes.first().copied().unwrap_or(2);
            let across = [(axis + 1) % 3, (axis + 2) % 3];
            // `ways` are the axes along which the two points coincide. `right` are pairs (axis of the closing body,
            // axis of the base frame) that stay perpendicular.
            let (ways, right): (Vec<usize>, Vec<(usize, usize)>) = match kind {
                JointKind::Pin => (vec![0, 1, 2], across.map(|i| (axis, i)).to_vec()),
                JointKind::Ball => (vec![0, 1, 2], Vec::new()),
                JointKind::Universal => (vec![0, 1, 2], vec![(axes[1], axes[0])]),
                JointKind::Slider => (across.to_vec(), vec![(0, 1), (1, 2), (2, 0)]),
                JointKind::Cylinder => (across.to_vec(), across.map(|i| (axis, i)).to_vec()),
                JointKind::Planar => (vec![axis], across.map(|i| (axis, i)).to_vec()),
                JointKind::Weld => (vec![0, 1, 2], vec![(0, 1), (1, 2), (2, 0)]),
                JointKind::Free | JointKind::Screw => (Vec::new(), Vec::new()),
            };
            let mut state =
                |loading: &mut Self, part: String, equation: Expr, kind: ReactionKind, along: (usize, [Expr; 3])| {
                    let name_of = format!("{}_{part}", name.text);
                    let what = if let ReactionKind::Force { .. } = kind { "force" } else { "torque" };
                    let called = format!("{}_{what}{}", name.text, part.trim_start_matches("turn"));
                    let symbol = loading.arena.symbol(&called);
                    let located = Located { text: called.clone(), ..name.clone() };
                    loading.names.declare(&mut loading.reader, &located, NameKind::Reaction, Some(symbol));
                    let (frame, direction) = along;
                    let reaction = Reaction {
                        name: called,
                        symbol,
                        kind,
                        frame,
                        direction,
                        is_stated: false,
                        is_shared: false,
                        law: None,
                    };
                    holding.push(JointReaction { joint: name.text.clone(), equation: name_of.clone(), reaction });
                    list.push(StatedConstraint {
                        name: name_of,
                        equation,
                        enforced_by: None,
                        span: name.span.clone(),
                        may_repeat: true,
                    });
                };
            let way = moving.vector_between_points(&mut self.arena, *on, *at);
            // The points coincide in every frame; formulas are shortest in the frame from which both points are
            // stated. In an open loop, the rate of the vector's components depends on the frame, and so does
            // the place of the opposite force.
            let is_told_there = *parts_at_ground && ways.len() == 3;
            let (frame, held) = if is_told_there { (0, on) } else { (*base, at) };
            for i in ways {
                let equation = moving.component(&mut self.arena, &way, frame, i);
                let against = bodies.1.map(|body| ForcePlace { body, point: *held });
                let kind = ReactionKind::Force { on: ForcePlace { body: bodies.0, point: *at }, against };
                let mut direction = [Expr::ZERO; 3];
                direction[i] = Expr::ONE;
                let vector = way.clone();
                closures.push(Closure {
                    joint: name.text.clone(),
                    name: format!("{}_{}", name.text, i + 1),
                    vector,
                    frame,
                    axis: i,
                });
                state(self, format!("{}", i + 1), equation, kind, (frame, direction));
            }
            if let JointKind::Weld | JointKind::Slider = kind {
                let cosines = [0, 1, 2].map(|i| {
                    let mut unit = [Expr::ZERO; 3];
                    unit[i] = Expr::ONE;
                    moving.component(&mut self.arena, &Vector::in_frame(*body, unit), *base, i)
                });
                orientations.push(HeldOrientation { joint: name.text.clone(), cosines: self.arena.sum(&cosines) });
            }
            for (of, along) in right {
                let mut unit = [Expr::ZERO; 3];
                unit[of] = Expr::ONE;
                let axis = Vector::in_frame(*body, unit);
                closures.push(Closure {
                    joint: name.text.clone(),
                    name: format!("{}_turn{}{}", name.text, of + 1, along + 1),
                    vector: axis.clone(),
                    frame: *base,
                    axis: along,
                });
                let [x, y, z] = [0, 1, 2].map(|i| moving.component(&mut self.arena, &axis, *base, i));
                // The cosine of two axes changes as the body rotates about their common normal.
                let mut other = [Expr::ZERO; 3];
                other[along] = Expr::ONE;
                let direction = cross_components(&mut self.arena, &[x, y, z], &other);
                let kind = ReactionKind::Torque { on: bodies.0, against: bodies.1 };
                state(self, format!("turn{}{}", of + 1, along + 1), [x, y, z][along], kind, (*base, direction));
            }
        }
        ClosingEquations { equations: list, reactions: holding, closures, orientations }
    }
}

/// Equations of the joints that close loops.
pub struct ClosingEquations {
    /// Equations between coordinates.
    pub equations: Vec<StatedConstraint>,
    /// Reactions that enforce the equations, one for each.
    pub reactions: Vec<JointReaction>,
    /// Left sides of the equations as components of vectors, one for each.
    pub closures: Vec<Closure>,
    /// Orientations that welds and sliders hold.
    pub orientations: Vec<HeldOrientation>,
}

/// Index of the last common ancestor of two frames in the tree of frames.
fn last_common_frame(frames: &[Frame], [mut a, mut b]: [usize; 2]) -> usize {
    // A frame comes after its parent in the list.
    while a != b {
        let later = if a > b { &mut a } else { &mut b };
        *later = frames[*later].rotation.as_ref().map_or(0, |(parent, _)| *parent);
    }
    a
}

impl Model {
    /// Adds to the model the reactions of those joint equations that are constraints. Reactions of redundant
    /// equations go to `redundant`. In the directions of reactions, the coordinates that constraints determine are
    /// replaced by their values.
    pub(in crate::model) fn add_joint_reactions(&mut self, holding: Vec<JointReaction>, fixed: &mut Substitution) {
        for mut held in holding {
            let reaction = &mut held.reaction;
            reaction.direction = reaction.direction.map(|e| fixed.apply(&mut self.arena, e));
            let solved = self.constraints.iter().any(|c| c.name == held.equation);
            if solved || self.motion_constraints.iter().any(|c| c.name == held.equation) {
                self.reactions.push(held.reaction);
            } else {
                self.redundant.push(held);
            }
        }
    }
}
