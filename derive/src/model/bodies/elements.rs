//! Elements of a mechanism (frames, points and bodies) as a model file states them.

use super::joints::Joints;
use crate::algebra::term::calculus::Gradient;
use crate::algebra::{Arena, Expr, Rational};
use crate::geometry::{Placement, Turn};
use crate::model::reading::declared_names::{AllowedQuantities, CONFIGURATION, NameKind, PARAMETERS};
use crate::model::reading::loading::Loading;
use crate::model::reading::tree::{Node, sort_parents_first};
use crate::model::units::Unit;
use crate::model::{
    AddedMass, Body, Contacts, Force, Frame, Gravity, Inertia, Parameter, Point, Potential, Reaction, Torque,
    impossible_bodies,
};
use crate::toml_reader::{Entry, Located};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Motion of a body along an axis of a frame, caused by a single variable of a constraint's equation.
#[derive(Clone, Copy)]
pub struct AxisMotion {
    /// Index of the frame whose axis the motion follows.
    pub frame: usize,
    /// Axis of the motion: 0, 1 or 2.
    pub axis: usize,
    /// Displacement or velocity along the axis per unit of the variable.
    pub distance: Expr,
}

/// Elements of a mechanism: frames, points and bodies, with the loads, reactions and contacts on
/// them.
#[derive(Default)]
pub struct Elements {
    /// Reference frames, parents first; the inertial frame has index 0.
    pub frames: Vec<Frame>,
    /// Points, parents first; the origin has index 0.
    pub points: Vec<Point>,
    /// Rigid bodies and particles.
    pub bodies: Vec<Body>,
    /// Added masses of rigid bodies.
    pub added_masses: Vec<AddedMass>,
    /// Uniform gravity; `None` if the model file states none.
    pub gravity: Option<Gravity>,
    /// Applied forces, including those of springs and friction.
    pub forces: Vec<Force>,
    /// Applied torques, including those of friction.
    pub torques: Vec<Torque>,
    /// Potential energies that the model file states.
    pub potentials: Vec<Potential>,
    /// Reactions that the model file states.
    pub reactions: Vec<Reaction>,
    /// Rolling, friction and comparisons of bodies that the model file states.
    pub contacts: Contacts,
}

impl Elements {
    /// Reads the sections of frames, points, bodies, loads and reactions of a model file. Errors are recorded in the
    /// reader.
    pub fn read<'a>(
        loading: &mut Loading<'a>,
        table: &'a DeTable<'a>,
        joints: &Joints<'a>,
        reactions: &[Entry<'a>],
    ) -> Self {
        let mut all = Self::default();
        all.read_inertial(loading, table);
        all.read_frames(loading, table, joints);
        all.read_points(loading, table, joints);
        all.read_bodies(loading, table, joints);
        all.read_particles(loading, table);
        loading.names.check_awaiting_velocities(&mut loading.reader);
        all.read_gravity(loading, table);
        all.read_forces(loading, table);
        all.read_torques(loading, table);
        all.read_reactions(loading, reactions);
        all
    }

    /// Index of the only body that a coordinate moves relative to its parent. The parent is the body or origin from
    /// which the body is placed. `None` if the coordinate moves no body in this way, or several bodies.
    pub fn body_moved_by_coordinate(&self, arena: &Arena, coordinate: Expr) -> Option<usize> {
        let depends = |terms: &[Expr]| arena.reachable(terms).contains(&coordinate);
        let is_bodily =
            |frame: usize| self.bodies.iter().any(|body| body.rigid.as_ref().is_some_and(|(own, _)| *own == frame));
        let moves = |body: &Body| {
            let steps = self.placement_steps(body);
            if steps.iter().any(|(_, position)| depends(*position)) {
                return true;
            }
            let own = body.rigid.as_ref().map(|(frame, _)| *frame);
            own.into_iter().chain(steps.into_iter().map(|(frame, _)| frame)).any(|frame| {
                let mut at = Some(frame).filter(|frame| own == Some(*frame) || !is_bodily(*frame));
                while let Some((parent, turn)) = at.and_then(|frame| self.frames[frame].rotation.as_ref()) {
                    if depends(&turn.terms()) {
                        return true;
                    }
                    at = Some(*parent).filter(|parent| !is_bodily(*parent));
                }
                false
            })
        };
        let mut found = (0..self.bodies.len()).filter(|body| moves(&self.bodies[*body]));
        found.next().filter(|_| found.next().is_none())
    }

    /// Axis along which a coordinate moves a body relative to its parent, the body or origin from which it is placed.
    /// `None` unless the coordinate occurs in exactly one component of one position vector on the way from the
    /// parent.
    pub fn axis_of_coordinate_motion(&self, arena: &mut Arena, body: usize, coordinate: Expr) -> Option<AxisMotion> {
        let steps = self.placement_steps(&self.bodies[body]);
        let components = steps.iter().flat_map(|(frame, position)| {
            position.iter().enumerate().map(|(axis, component)| (*frame, axis, *component))
        });
        let mut moved = components.filter(|(.., component)| arena.reachable(&[*component]).contains(&coordinate));
        let (frame, axis, component) = moved.next().filter(|_| moved.next().is_none())?;
        let slopes = Gradient::new(&[coordinate]).apply(arena, component);
        slopes.first().map(|(_, slope)| AxisMotion { frame, axis, distance: *slope })
    }

    /// Position vectors, as (frame, components), from the mass centre of a body back to the mass centre
    /// of its parent in the placement, or to the origin.
    fn placement_steps(&self, body: &Body) -> Vec<(usize, &[Expr; 3])> {
        let is_centre = |point: usize| self.bodies.iter().any(|body| body.centre == point);
        let mut steps = Vec::new();
        let mut at = Some(body.centre);
        while let Some(placement) = at.and_then(|point| self.points[point].position.as_ref()) {
            steps.push((placement.frame, &placement.components));
            at = Some(placement.parent).filter(|parent| !is_centre(*parent));
        }
        steps
    }

    /// Reads `[inertial]`: the inertial frame and the origin. Errors are recorded in the reader.
    fn read_inertial<'a>(&mut self, loading: &mut Loading<'a>, table: &'a DeTable<'a>) {
        let what = "`inertial`";
        let value = loading.reader.get(table, "inertial");
        let entry = value.and_then(|v| Some((loading.reader.table(v, what, "[inertial]")?, v.span())));
        let Some((entry, span)) = entry else {
            return loading.names.mark_unread_kinds(&[NameKind::Frame, NameKind::Point]);
        };
        loading.reader.report_unknown_keys(entry, what, &["frame", "origin"]);
        for (key, kind) in [("frame", NameKind::Frame), ("origin", NameKind::Point)] {
            let name = loading.reader.required(entry, key, what, &span);
            let name = name.and_then(|v| loading.reader.string(v, &format!("`{key}`")));
            let Some(name) = name else {
                loading.names.mark_unread_kinds(&[kind]);
                continue;
            };
            loading.names.declare(&mut loading.reader, &name, kind, None);
            match kind {
                NameKind::Frame => {
                    loading.names.root.clone_from(&name.text);
                    self.frames.push(Frame { name: name.text, rotation: None });
                }
                _ => self.points.push(Point { name: name.text, position: None }),
            }
        }
    }

    /// Reads `[frames]` and the frames of joints, and orders them so that parents come first. Errors are recorded in
    /// the reader.
    fn read_frames<'a>(&mut self, loading: &mut Loading<'a>, table: &'a DeTable<'a>, joints: &Joints<'a>) {
        let mut nodes = Vec::new();
        let root = self.frames.first().map(|f| f.name.clone());
        for (name, value) in loading.section(table, "frames", &[NameKind::Frame]) {
            let example = "{ from = \"N\", axis = 3, angle = \"q1\" }";
            let Some((entry, what)) = loading.entry(&name, value, NameKind::Frame, None, example) else { continue };
            let stated = loading.reader.get(entry, "euler_parameters");
            let by_turns = entry.contains_key("sequence");
            let keys: &[&str] = match stated {
                Some(_) => &["euler_parameters"],
                None if by_turns => &["sequence", "angles", "fixed"],
                None => &["axis", "angle"],
            };
            loading.reader.report_unknown_keys(entry, "a frame", &[keys, &["from", "about"]].concat());
            let parent = loading.reader.required(entry, "from", &what, &name.span);
            let parent = parent.and_then(|v| loading.reader.string(v, "`from`"));
            let axis = if stated.is_some() || by_turns { None } else { loading.reader.get(entry, "axis") };
            let is_vector = axis.is_some_and(|axis| axis.get_ref().is_array());
            if by_turns || stated.is_some() || is_vector {
                let turns = match (stated, axis) {
                    (Some(value), _) => loading.euler_parameters(value).map(|turn| vec![turn]),
                    (None, Some(axis)) => loading.turns_about(axis, entry, &what, &name.span),
                    (None, None) => loading.frame_turns(entry, &what, &name.span),
                };
                if let (Some(parent), Some(turns)) = (parent, turns) {
                    loading.add_frame_chain(&mut nodes, parent, &name, turns);
                }
                continue;
            }
            let axis = loading.reader.required(entry, "axis", &what, &name.span).and_then(|v| loading.axis_number(v));
            let angle = loading.turn_angle(entry, &what, &name.span);
            if let (Some(parent), Some(axis), Some(angle)) = (parent, axis, angle) {
                nodes.push(Node { name, parent, payload: Turn::About(axis, angle) });
            }
        }
        if let Some(root) = &root {
            nodes.extend(loading.joint_frames(joints, root));
        }
        for (node, parent) in sort_parents_first(loading, nodes, root.as_deref(), NameKind::Frame) {
            self.frames.push(Frame { name: node.name.text, rotation: Some((parent, node.payload)) });
        }
    }

    /// Reads `[points]` and the points of joints, and orders them so that parents come first. Errors are recorded in
    /// the reader.
    fn read_points<'a>(&mut self, loading: &mut Loading<'a>, table: &'a DeTable<'a>, joints: &Joints<'a>) {
        let mut nodes = Vec::new();
        for (name, value) in loading.section(table, "points", &[NameKind::Point]) {
            let example = "{ from = \"O\", frame = \"N\", position = [\"0\", \"0\", \"l\"] }";
            let Some((entry, what)) = loading.entry(&name, value, NameKind::Point, None, example) else { continue };
            loading.reader.report_unknown_keys(entry, "a point", &["from", "frame", "position", "about"]);
            let parent = loading.reader.required(entry, "from", &what, &name.span);
            let parent = parent.and_then(|v| loading.reader.string(v, "`from`"));
            let frame = self.frame(loading, entry, &what, &name.span);
            let metre = Unit::new(1, 0, 0);
            let position = vector(loading, entry, "position", &what, &name.span, CONFIGURATION, &metre);
            if let (Some(parent), Some(frame), Some(position)) = (parent, frame, position) {
                nodes.push(Node { name, parent, payload: (frame, position) });
            }
        }
        let root = self.points.first().map(|p| p.name.clone());
        if let (Some(frame), Some(point)) = (self.frames.first(), &root) {
            for Node { name, parent, payload: (frame, position) } in
                loading.joint_points(joints, table, (&frame.name, point))
            {
                if let Some(frame) = self.frame_named(loading, &frame) {
                    nodes.push(Node { name, parent, payload: (frame, position) });
                }
            }
        }
        for (node, parent) in sort_parents_first(loading, nodes, root.as_deref(), NameKind::Point) {
            let (frame, position) = node.payload;
            let placement = Placement { parent, frame, components: position };
            self.points.push(Point { name: node.name.text, position: Some(placement) });
        }
    }

    /// Reads `[bodies]`: frame, mass centre, mass and inertia of each rigid body. Errors are recorded in the reader.
    fn read_bodies<'a>(&mut self, loading: &mut Loading<'a>, table: &'a DeTable<'a>, joints: &Joints<'a>) {
        for (name, value) in loading.section(table, "bodies", &[NameKind::Body]) {
            let entry = loading.entry(&name, value, NameKind::Body, None, "[bodies.NAME]");
            let Some((entry, what)) = entry else { continue };
            loading.reader.report_unknown_keys(
                entry,
                "a body",
                &["frame", "centre", "mass", "inertia", "added_mass", "about"],
            );
            let carried = joints.bodies.get(&name.text).filter(|placed| placed.joint.is_some());
            let frame = match (carried, loading.reader.get(entry, "frame")) {
                (Some(placed), None) => self.frame_named(loading, &placed.frame),
                _ => self.frame(loading, entry, &what, &name.span),
            };
            let centre = match (carried, loading.reader.get(entry, "centre")) {
                (Some(placed), None) => self.point_named(loading, &placed.centre),
                _ => self.point(loading, entry, "centre", &what, &name.span),
            };
            let mass = mass(loading, entry, &what, &name.span);
            let inertia = loading.reader.required(entry, "inertia", &what, &name.span);
            let inertia = inertia.and_then(|v| self.inertia(loading, v, frame, centre, mass));
            if let (Some(frame), Some(centre), Some(mass), Some(inertia)) = (frame, centre, mass, inertia) {
                self.bodies.push(Body { name: name.text, centre, mass, rigid: Some((frame, inertia)) });
                self.read_added_mass(loading, entry, self.bodies.len() - 1, frame);
            }
        }
    }

    /// Reads `[particles]`: point and mass of each particle. Errors are recorded in the reader.
    fn read_particles<'a>(&mut self, loading: &mut Loading<'a>, table: &'a DeTable<'a>) {
        for (name, value) in loading.section(table, "particles", &[NameKind::Body]) {
            let entry = loading.entry(&name, value, NameKind::Body, None, "{ point = \"P\", mass = \"m\" }");
            let Some((entry, _)) = entry else { continue };
            let what = format!("particle `{}`", name.text);
            loading.reader.report_unknown_keys(entry, "a particle", &["point", "mass", "about"]);
            let centre = self.point(loading, entry, "point", &what, &name.span);
            let mass = mass(loading, entry, &what, &name.span);
            if let (Some(centre), Some(mass)) = (centre, mass) {
                self.bodies.push(Body { name: name.text, centre, mass, rigid: None });
            }
        }
    }

    /// Reads the inertia of a body and transforms it to the mass centre; `None` after an error is
    /// reported.
    fn inertia<'a>(
        &self,
        loading: &mut Loading<'a>,
        value: &'a Spanned<DeValue<'a>>,
        body_frame: Option<usize>,
        centre: Option<usize>,
        mass: Option<Expr>,
    ) -> Option<Inertia> {
        let what = "an inertia";
        if !matches!(value.get_ref(), DeValue::Table(_)) {
            return self.planar_inertia(loading, value, body_frame?);
        }
        let entry = loading.reader.table(value, what, "{ diagonal = [\"Ixx\", \"Iyy\", \"Izz\"] }")?;
        loading.reader.report_unknown_keys(entry, what, &["frame", "diagonal", "products", "about_point"]);
        let unit = Unit::new(2, 1, 0);
        let frame = match loading.reader.get(entry, "frame") {
            Some(_) => self.frame(loading, entry, what, &value.span()),
            None => body_frame,
        };
        let diagonal = vector(loading, entry, "diagonal", what, &value.span(), PARAMETERS, &unit)?;
        let products = match loading.reader.get(entry, "products") {
            Some(_) => vector(loading, entry, "products", what, &value.span(), PARAMETERS, &unit)?,
            None => [Expr::ZERO; 3],
        };
        let [xy, yz, zx] = products;
        let mut tensor = [[diagonal[0], xy, zx], [xy, diagonal[1], yz], [zx, yz, diagonal[2]]];
        if let Some(at) = loading.reader.get(entry, "about_point") {
            let point = self.point(loading, entry, "about_point", what, &value.span())?;
            let (frame, centre, mass) = (frame?, centre?, mass?);
            let Some(arm) = self.vector_between_points(&mut loading.arena, point, centre, frame) else {
                let help =
                    "the mass centre must be placed from that point, or that point from it, in the inertia's frame";
                loading.reader.error(at.span(), "the inertia cannot be moved to the mass centre", help);
                return None;
            };
            tensor = inertia_about_centre(&mut loading.arena, tensor, mass, arm);
        }
        Some(Inertia { frame: frame?, tensor })
    }

    /// Reads the inertia of a body that turns about one axis only, from its moment about that axis, kg
    /// m². The result is the inertia of a thin plate normal to the axis. `None` after an error is
    /// reported.
    fn planar_inertia<'a>(
        &self,
        loading: &mut Loading<'a>,
        value: &'a Spanned<DeValue<'a>>,
        frame: usize,
    ) -> Option<Inertia> {
        let formula = loading.reader.formula(value, "an inertia")?;
        let moment = loading.quantity(&formula, PARAMETERS, &Unit::new(2, 1, 0), "a moment of inertia")?;
        let coordinates = loading.names.symbols_of(&[NameKind::Coordinate]);
        let mut turns = Vec::new();
        let mut at = frame;
        while let Some((parent, turn)) = &self.frames[at].rotation {
            let moves = loading.arena.reachable(&turn.terms()).iter().any(|part| coordinates.contains(part));
            match turn {
                Turn::About(_, angle) if *angle == Expr::ZERO => {}
                Turn::About(axis, _) => turns.push((Some(*axis), moves)),
                Turn::Oriented(_) => turns.push((None, moves)),
            }
            at = *parent;
        }
        // A constant rotation between the plane of motion and the inertial frame has no effect here.
        while turns.last().is_some_and(|(_, moves)| !moves) {
            turns.pop();
        }
        let axis = turns.first().map_or(Some(2), |(axis, _)| *axis);
        let alone = axis.filter(|axis| turns.iter().all(|(other, _)| *other == Some(*axis)));
        let Some(axis) = alone else {
            let help = "state its three moments: inertia = { diagonal = [\"I1\", \"I2\", \"I3\"] }";
            loading.reader.error(
                value.span(),
                "a body that turns about several axes has more than one moment of inertia",
                help,
            );
            return None;
        };
        let half = loading.arena.scale(moment, &Rational::fraction(1, 2)?);
        let mut tensor = [[Expr::ZERO; 3]; 3];
        for (i, row) in tensor.iter_mut().enumerate() {
            row[i] = if i == axis { moment } else { half };
        }
        Some(Inertia { frame, tensor })
    }

    /// Components in `frame` of the vector from one point to another, m. `None` unless one of the two points is
    /// placed directly from the other, with components in `frame`.
    pub(super) fn vector_between_points(
        &self,
        arena: &mut Arena,
        from: usize,
        to: usize,
        frame: usize,
    ) -> Option<[Expr; 3]> {
        if from == to {
            return Some([Expr::ZERO; 3]);
        }
        let direct = |a: usize, b: usize| match &self.points[b].position {
            Some(placement) if placement.parent == a && placement.frame == frame => Some(placement.components),
            _ => None,
        };
        direct(from, to).or_else(|| direct(to, from).map(|r| r.map(|e| arena.neg(e))))
    }

    /// Index of the frame under the key `frame` of an entry; `None` after an error is reported.
    pub fn frame<'a>(
        &self,
        loading: &mut Loading<'a>,
        entry: &'a DeTable<'a>,
        what: &str,
        owner: &Range<usize>,
    ) -> Option<usize> {
        let value = loading.reader.required(entry, "frame", what, owner)?;
        let name = loading.reader.string(value, "`frame`")?;
        self.frame_named(loading, &name)
    }

    /// Index of the frame with the given name; `None` after reporting an unknown name.
    fn frame_named(&self, loading: &mut Loading<'_>, name: &Located) -> Option<usize> {
        let known = loading.names.expect(&mut loading.reader, name, NameKind::Frame);
        self.frames.iter().position(|f| known && f.name == name.text)
    }

    /// Index of the point with the given name; `None` after reporting an unknown name.
    fn point_named(&self, loading: &mut Loading<'_>, name: &Located) -> Option<usize> {
        let known = loading.names.expect(&mut loading.reader, name, NameKind::Point);
        self.points.iter().position(|p| known && p.name == name.text)
    }

    /// Index of the point under a key of an entry; `None` after an error is reported.
    pub fn point<'a>(
        &self,
        loading: &mut Loading<'a>,
        entry: &'a DeTable<'a>,
        key: &str,
        what: &str,
        owner: &Range<usize>,
    ) -> Option<usize> {
        let value = loading.reader.required(entry, key, what, owner)?;
        let name = loading.reader.string(value, &format!("`{key}`"))?;
        self.point_named(loading, &name)
    }

    /// Replaces every term of the elements by its value under `map`, for example to eliminate variables
    /// that constraints determine.
    pub fn rewrite(&mut self, map: &mut impl FnMut(Expr) -> Expr) {
        for frame in &mut self.frames {
            if let Some((_, turn)) = &mut frame.rotation {
                turn.rewrite(map);
            }
        }
        for point in &mut self.points {
            if let Some(Placement { components, .. }) = &mut point.position {
                *components = components.map(&mut *map);
            }
        }
        if let Some(gravity) = &mut self.gravity {
            for (at, _) in &mut gravity.zero_at {
                *at = map(*at);
            }
        }
        let energies = self.forces.iter_mut().flat_map(|f| f.energy.iter_mut().chain(f.damper.iter_mut().flatten()));
        for energy in energies.chain(self.potentials.iter_mut().flat_map(|p| [&mut p.energy, &mut p.explicit_rate])) {
            *energy = map(*energy);
        }
        let vectors = self.forces.iter_mut().map(|f| &mut f.vector);
        let vectors = vectors.chain(self.torques.iter_mut().map(|t| &mut t.vector));
        for vector in vectors.chain(self.reactions.iter_mut().map(|r| &mut r.direction)) {
            *vector = vector.map(&mut *map);
        }
    }

    /// Reports masses, inertias and added masses that no body can have at the default values of the
    /// parameters.
    pub fn check_elements(&self, loading: &mut Loading<'_>, parameters: &[Parameter]) {
        let known = impossible_bodies::default_parameter_values(parameters);
        for body in &self.bodies {
            if let Some((message, help)) =
                impossible_bodies::impossible_body_message(&loading.arena, &known, body, "the default")
            {
                let span = loading.names.span(&body.name).unwrap_or_default();
                loading.reader.error(span, message, help);
            }
        }
        self.check_added_masses(loading, parameters);
    }
}

/// Reads the mass of a body, kg, as a term; `None` after an error is reported.
fn mass<'a>(loading: &mut Loading<'a>, entry: &'a DeTable<'a>, what: &str, owner: &Range<usize>) -> Option<Expr> {
    let value = loading.reader.required(entry, "mass", what, owner)?;
    let formula = loading.reader.formula(value, "`mass`")?;
    loading.quantity(&formula, PARAMETERS, &Unit::new(0, 1, 0), &format!("the mass of {what}"))
}

/// Reads three formulas under a key, each with the unit `unit`. `None` after an error is reported.
pub fn vector<'a>(
    loading: &mut Loading<'a>,
    entry: &'a DeTable<'a>,
    key: &str,
    what: &str,
    owner: &Range<usize>,
    allowed: AllowedQuantities,
    unit: &Unit,
) -> Option<[Expr; 3]> {
    let value = loading.reader.required(entry, key, what, owner)?;
    let triple = loading.reader.triple(value, &format!("`{key}`"))?;
    let what = format!("the {key} of {what}");
    let [a, b, c] = triple.map(|formula| loading.quantity(&formula, allowed, unit, &what));
    Some([a?, b?, c?])
}

/// Moves a 3 × 3 inertia tensor from P to the mass centre C by Steiner's theorem: I_C = I_P − m
/// (|r|² 1 − r rᵀ). `arm` is r from P to C, m.
fn inertia_about_centre(arena: &mut Arena, tensor: [[Expr; 3]; 3], mass: Expr, arm: [Expr; 3]) -> [[Expr; 3]; 3] {
    let squares = arm.map(|r| arena.square(r));
    let length = arena.sum(&squares);
    let mut result = tensor;
    for (i, row) in result.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            let product = arena.mul(arm[i], arm[j]);
            let shift = if i == j { arena.sub(length, product) } else { arena.neg(product) };
            let shift = arena.mul(mass, shift);
            *entry = arena.sub(*entry, shift);
        }
    }
    result
}
