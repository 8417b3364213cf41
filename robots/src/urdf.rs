//! URDF files: links and joints in a tree, with limits, damping, mimic joints and shapes.
//!
//! Conventions (URDF XML specification, ros.org): `rpy` are turns about the fixed axes 1, 2 and 3; a link's axes are
//! those of the joint that carries it; an inertia is about the mass centre, in the axes of its `<origin>`; a cylinder
//! lies along axis 3; the ground's axis 3 points up.

mod shapes;

use crate::Options;
use crate::pose::{Pose, roll_pitch_yaw};
use crate::robot::{Actuator, ActuatorInput, Body, Coupling, Inertia, Joint, JointIndex, JointMotion, Robot, Shape};
use crate::xml::{Reading, XACRO, attribute_place, element, elements, number, numbers_of, place, vector};
use nalgebra::{Matrix3, Vector3};
use roxmltree::Node;
use std::collections::BTreeMap;
use tripos_derive::diagnostic::nearest_name_advice;

/// Acceleration of free fall, m/s²; URDF files state none.
const GRAVITY: f64 = 9.81;
/// Largest plausible angle of a pose, rad. Larger numbers are degrees.
pub const LARGEST_ANGLE: f64 = 13.0;

/// Size from which a limit is none: files write such numbers for joints that move without end.
const NO_LIMIT: f64 = 1000.0;

/// A joint of the file, before its place in the tree is known.
struct UrdfJoint<'a, 'i> {
    /// Element of the joint.
    node: Node<'a, 'i>,
    /// Name of the joint.
    name: &'a str,
    /// Name of the link that carries the joint.
    parent: &'a str,
    /// Name of the link that the joint moves.
    child: &'a str,
}

/// Reads a URDF file.
pub fn read(root: Node<'_, '_>, options: Options, reading: &Reading) -> Robot {
    let mut robot = Robot::new(root.attribute("name").unwrap_or("robot"), GRAVITY);
    refuse_macros(root, reading);
    let links = named_elements(root, "link", reading);
    let names = named_elements(root, "joint", reading);
    let joints: Vec<UrdfJoint<'_, '_>> =
        names.iter().filter_map(|(name, node)| read_ends(*node, name, &links, reading)).collect();
    let Some(order) = link_order(root, &links, &joints, reading) else { return robot };
    let mut bodies: BTreeMap<&str, usize> = BTreeMap::new();
    for (link, joint) in &order {
        let Some((_, node)) = links.iter().find(|(name, _)| name == link) else { continue };
        let (inertia, shapes) = read_link(*node, reading);
        let (pose, moving, parent) = match joint {
            Some(joint) => {
                let (pose, moving) = read_joint(joint, reading);
                (pose, moving, bodies.get(joint.parent).copied())
            }
            None if options.is_floating => {
                let name = format!("{link}_free");
                (Pose::default(), Some(Joint::new(name, JointMotion::Free, Vector3::z(), place(*node))), None)
            }
            None => (Pose::default(), None, None),
        };
        bodies.insert(link, robot.bodies.len());
        robot.bodies.push(Body {
            name: (*link).to_owned(),
            parent,
            pose,
            joints: moving.into_iter().collect(),
            inertia,
            shapes,
            place: place(*node),
        });
    }
    read_mimics(&joints, &bodies, &mut robot, reading);
    add_actuators(root, &joints, &bodies, &mut robot, reading);
    list_omissions(root, reading);
    robot
}

/// Records a mistake for each macro of xacro.
fn refuse_macros(root: Node<'_, '_>, reading: &Reading) {
    for node in root.descendants().filter(Node::is_element) {
        if node.tag_name().namespace().is_some_and(|space| space.contains("xacro")) {
            reading.add(place(node), format!("`{}` is a macro of xacro", node.tag_name().name()), XACRO);
            return;
        }
        if let Some(attribute) = node.attributes().find(|attribute| attribute.value().contains("${")) {
            reading.add(attribute.range_value(), "this is a formula of xacro", XACRO);
            return;
        }
    }
}

/// Children of the root with a tag, each with its name. Names that are missing or repeated are mistakes.
fn named_elements<'a, 'i>(root: Node<'a, 'i>, tag: &str, reading: &Reading) -> Vec<(&'a str, Node<'a, 'i>)> {
    let mut list: Vec<(&str, Node<'_, '_>)> = Vec::new();
    for node in elements(root).filter(|node| node.has_tag_name(tag)) {
        let Some(name) = node.attribute("name").filter(|name| !name.is_empty()) else {
            reading.add(place(node), format!("this {tag} has no name"), "add `name=\"…\"`");
            continue;
        };
        if let Some((_, first)) = list.iter().find(|(other, _)| *other == name) {
            reading.add_with_other(
                attribute_place(node, "name"),
                format!("the {tag} `{name}` stands twice"),
                "give each a name of its own",
                attribute_place(*first, "name"),
                "first here",
            );
            continue;
        }
        list.push((name, node));
    }
    list
}

/// Reads the two links of a joint. `None` after recording a mistake.
fn read_ends<'a, 'i>(
    node: Node<'a, 'i>,
    name: &'a str,
    links: &[(&'a str, Node<'a, 'i>)],
    reading: &Reading,
) -> Option<UrdfJoint<'a, 'i>> {
    let link_of = |tag: &str| {
        let Some(end) = element(node, tag) else {
            reading.add(
                place(node),
                format!("the joint `{name}` has no `{tag}`"),
                format!("add `<{tag} link=\"…\"/>`"),
            );
            return None;
        };
        let Some(link) = end.attribute("link") else {
            reading.add(place(end), format!("`{tag}` names no link"), "add `link=\"…\"`");
            return None;
        };
        if !links.iter().any(|(known, _)| *known == link) {
            let advice = nearest_name_advice(link, links.iter().map(|(known, _)| *known));
            reading.add(attribute_place(end, "link"), format!("there is no link `{link}`"), advice);
            return None;
        }
        Some(link)
    };
    let (parent, child) = (link_of("parent"), link_of("child"));
    Some(UrdfJoint { node, name, parent: parent?, child: child? })
}

/// Links in an order in which each stands after the link that carries it, each with its joint. `None` after recording
/// a mistake: a link with two joints, a loop of joints, or several roots.
fn link_order<'a, 'j, 'i>(
    root: Node<'a, 'i>,
    links: &[(&'a str, Node<'a, 'i>)],
    joints: &'j [UrdfJoint<'a, 'i>],
    reading: &Reading,
) -> Option<Vec<(&'a str, Option<&'j UrdfJoint<'a, 'i>>)>> {
    let before = reading.count();
    let mut carrier: BTreeMap<&str, &UrdfJoint<'_, '_>> = BTreeMap::new();
    for joint in joints {
        if let Some(first) = carrier.get(joint.child) {
            reading.add_with_other(
                place(joint.node),
                format!("two joints, `{}` and `{}`, carry the link `{}`", first.name, joint.name, joint.child),
                "a URDF file is a tree: leave one joint out, and close the loop by a file for `--loops`",
                place(first.node),
                "first here",
            );
            continue;
        }
        carrier.insert(joint.child, joint);
    }
    let roots: Vec<&(&str, Node<'_, '_>)> = links.iter().filter(|(name, _)| !carrier.contains_key(name)).collect();
    match roots[..] {
        [] if links.is_empty() => reading.add(place(root), "the file has no link", "give a URDF file with links"),
        [] => reading.add(
            place(joints.first().map_or(root, |joint| joint.node)),
            "the joints form a loop: each link is carried by another",
            "leave out the joint that closes the loop, and close it by a file for `--loops`",
        ),
        [_] => {}
        [first, second, ..] => {
            reading.add_with_other(
                place(second.1),
                format!("no joint carries the link `{}`, and none carries `{}`", second.0, first.0),
                "connect all links by joints to one root",
                place(first.1),
                "another root",
            );
        }
    }
    if reading.count() > before {
        return None;
    }
    let mut order: Vec<(&str, Option<&UrdfJoint<'_, '_>>)> = roots.iter().map(|(name, _)| (*name, None)).collect();
    let mut next = 0;
    while next < order.len() {
        let parent = order[next].0;
        order.extend(joints.iter().filter(|joint| joint.parent == parent).map(|joint| (joint.child, Some(joint))));
        next += 1;
    }
    if let Some((name, node)) = links.iter().find(|(name, _)| !order.iter().any(|(known, _)| known == name)) {
        reading.add(
            place(*node),
            format!("the link `{name}` is in a loop of joints that the root does not carry"),
            "leave out the joint that closes the loop, and close it by a file for `--loops`",
        );
        return None;
    }
    Some(order)
}

/// Reads the pose of an `<origin>`; the identity if the element is absent.
fn read_origin(node: Node<'_, '_>, reading: &Reading) -> Pose {
    let Some(origin) = element(node, "origin") else { return Pose::default() };
    let position = vector(origin, "xyz", reading).unwrap_or_default();
    let angles = vector(origin, "rpy", reading).unwrap_or_default();
    if angles.amax() > LARGEST_ANGLE {
        let message = format!("an angle of {} rad is more than two turns", angles[angles.iamax()]);
        reading.add(attribute_place(origin, "rpy"), message, "angles of URDF are in radians, not in degrees");
    }
    Pose { position, rotation: roll_pitch_yaw(&angles.map(|angle| reading.angle(angle))) }
}

/// Reads the mass properties and the shapes of a link.
fn read_link(node: Node<'_, '_>, reading: &Reading) -> (Option<Inertia>, Vec<Shape>) {
    let inertia = element(node, "inertial").and_then(|inertial| read_inertial(inertial, reading));
    let shown: Vec<Node<'_, '_>> = elements(node).filter(|child| child.has_tag_name("visual")).collect();
    let tag = if shown.is_empty() { "collision" } else { "visual" };
    let shown = elements(node).filter(|child| child.has_tag_name(tag));
    (inertia, shown.filter_map(|shape| shapes::read(shape, read_origin(shape, reading), reading)).collect())
}

/// Reads `<inertial>`. `None` for a link without mass and inertia, or after recording a mistake.
fn read_inertial(node: Node<'_, '_>, reading: &Reading) -> Option<Inertia> {
    let pose = read_origin(node, reading);
    let before = reading.count();
    let wanted = |owner: Option<Node<'_, '_>>, tag: &str, name: &str| {
        let Some(owner) = owner else {
            reading.add(place(node), format!("`inertial` has no `{tag}`"), format!("add `<{tag} …/>`"));
            return None;
        };
        if !owner.has_attribute(name) {
            reading.add(place(owner), format!("`{tag}` has no `{name}`"), format!("add `{name}=\"…\"`"));
        }
        number(owner, name, reading)
    };
    let mass = wanted(element(node, "mass"), "mass", "value");
    let tensor = element(node, "inertia");
    let moment = |name: &str| wanted(tensor, "inertia", name);
    let product = |name: &str| tensor.and_then(|tensor| number(tensor, name, reading)).unwrap_or(0.0);
    let (xx, yy, zz) = (moment("ixx"), moment("iyy"), moment("izz"));
    let (xy, xz, yz) = (product("ixy"), product("ixz"), product("iyz"));
    if reading.count() > before {
        return None;
    }
    let own =
        Inertia { mass: mass?, centre: Vector3::zeros(), tensor: Matrix3::new(xx?, xy, xz, xy, yy?, yz, xz, yz, zz?) };
    if let Some(reason) = own.impossibility() {
        let advice = "correct the mass or the moments: no body can have them";
        reading.add(place(tensor.unwrap_or(node)), format!("this inertia is impossible: {reason}"), advice);
        return None;
    }
    (own.mass > 0.0 || own.tensor.amax() > 0.0).then(|| own.moved(&pose))
}

/// Reads the pose of a joint, and the joint; `None` in its place for a fixed joint.
fn read_joint(urdf: &UrdfJoint<'_, '_>, reading: &Reading) -> (Pose, Option<Joint>) {
    let node = urdf.node;
    let pose = read_origin(node, reading);
    let motion = match node.attribute("type") {
        Some("fixed") => return (pose, None),
        Some("revolute" | "continuous") => JointMotion::Hinge,
        Some("prismatic") => JointMotion::Slide,
        Some("floating") => JointMotion::Free,
        Some("planar") => JointMotion::Planar,
        Some("spherical" | "ball") => JointMotion::Ball,
        Some(other) => {
            let known = ["revolute", "continuous", "prismatic", "fixed", "floating", "planar"];
            let advice = nearest_name_advice(other, known);
            reading.add(attribute_place(node, "type"), format!("there is no joint of the type `{other}`"), advice);
            return (pose, None);
        }
        None => {
            reading.add(place(node), "this joint has no type", "add `type=\"revolute\"`, for example");
            return (pose, None);
        }
    };
    let axis = element(node, "axis").map_or(Some(Vector3::x()), |axis| vector(axis, "xyz", reading));
    let axis = axis.unwrap_or_else(Vector3::x);
    if axis.norm() == 0.0 {
        let tag = element(node, "axis").unwrap_or(node);
        reading.add(place(tag), "the axis has the length 0", "give a direction such as `xyz=\"0 0 1\"`");
    }
    let mut joint = Joint::new(urdf.name.to_owned(), motion, axis, place(node));
    if let Some(dynamics) = element(node, "dynamics") {
        joint.damping = non_negative(dynamics, "damping", reading);
        joint.friction = non_negative(dynamics, "friction", reading);
        if !joint.has_one_coordinate() && (joint.damping > 0.0 || joint.friction > 0.0) {
            reading.omit(format!("damping and friction of the joint {}", urdf.name));
        }
    }
    let is_limited = joint.has_one_coordinate() && node.attribute("type") != Some("continuous");
    if let Some(limit) = element(node, "limit").filter(|_| is_limited) {
        let bound = |name: &str| {
            let text = limit.attribute(name).unwrap_or("0").trim();
            match text.parse::<f64>() {
                Ok(infinite) if infinite.is_infinite() => infinite,
                _ => number(limit, name, reading).unwrap_or(0.0),
            }
        };
        let (lower, upper) = (bound("lower"), bound("upper"));
        if lower > upper {
            let message = format!("the lower limit {lower} exceeds the upper limit {upper}");
            reading.add(place(limit), message, "exchange the two limits");
        }
        let stated = [lower, upper].map(f64::abs).into_iter().filter(|bound| *bound < NO_LIMIT);
        if motion == JointMotion::Hinge && stated.fold(0.0, f64::max) > 8.0 * LARGEST_ANGLE {
            let message = format!("the limits {lower} and {upper} rad are more than sixteen turns");
            reading.add(place(limit), message, "angles of URDF are in radians, not in degrees");
        }
        let [lower, upper] =
            [lower, upper].map(|bound: f64| if bound.abs() < NO_LIMIT { bound } else { f64::INFINITY.copysign(bound) });
        joint.limits = (lower < upper && (lower.is_finite() || upper.is_finite())).then_some((lower, upper));
    }
    (pose, Some(joint))
}

/// Number of an attribute that must not be negative; 0 if it is absent, or after recording a mistake.
fn non_negative(node: Node<'_, '_>, name: &str, reading: &Reading) -> f64 {
    let value = number(node, name, reading).unwrap_or(0.0);
    if value < 0.0 {
        reading.add(attribute_place(node, name), format!("`{name}` is negative"), "give 0 or a positive number");
    }
    value.max(0.0)
}

/// Reads the mimic joints: q = multiplier · q_leader + offset.
fn read_mimics(joints: &[UrdfJoint<'_, '_>], bodies: &BTreeMap<&str, usize>, robot: &mut Robot, reading: &Reading) {
    for joint in joints {
        let Some(mimic) = element(joint.node, "mimic") else { continue };
        let Some(name) = mimic.attribute("joint") else {
            reading.add(place(mimic), "`mimic` names no joint", "add `joint=\"…\"`");
            continue;
        };
        let Some(leader) = joints.iter().find(|other| other.name == name) else {
            let advice = nearest_name_advice(name, joints.iter().map(|other| other.name));
            reading.add(attribute_place(mimic, "joint"), format!("there is no joint `{name}`"), advice);
            continue;
        };
        let index = |joint: &UrdfJoint<'_, '_>| {
            let body = *bodies.get(joint.child)?;
            let has_one = robot.bodies[body].joints.first().is_some_and(Joint::has_one_coordinate);
            has_one.then_some(JointIndex { body, joint: 0 })
        };
        let (Some(follower), Some(leader_index)) = (index(joint), index(leader)) else {
            let message = format!("a mimic joint and its leader must each have one coordinate: `{}`", joint.name);
            reading.add(place(mimic), message, "let revolute, continuous and prismatic joints alone follow others");
            continue;
        };
        let multiplier = number(mimic, "multiplier", reading).unwrap_or(1.0);
        let offset = number(mimic, "offset", reading).unwrap_or(0.0);
        // Leaders of leaders, until one does not follow another: a joint that comes back to itself has no leader.
        let mut at = leader;
        let mut steps = 0;
        while let Some(next) = element(at.node, "mimic").and_then(|mimic| mimic.attribute("joint"))
            && steps <= joints.len()
            && let Some(found) = joints.iter().find(|other| other.name == next)
        {
            at = found;
            steps += 1;
        }
        if steps > joints.len() || leader.name == joint.name {
            let message = format!("the joint `{}` follows itself", joint.name);
            reading.add(place(mimic), message, "let one joint of these move freely");
            continue;
        }
        let coefficients = vec![offset, multiplier];
        robot.couplings.push(Coupling { follower, leader: Some(leader_index), coefficients });
    }
}

/// Adds an input for each joint with one coordinate that does not follow another. If the file has transmissions, only
/// their joints have inputs.
fn add_actuators(
    root: Node<'_, '_>,
    joints: &[UrdfJoint<'_, '_>],
    bodies: &BTreeMap<&str, usize>,
    robot: &mut Robot,
    reading: &Reading,
) {
    let transmissions: Vec<&str> = elements(root)
        .filter(|node| node.has_tag_name("transmission"))
        .flat_map(|node| elements(node).filter(|part| part.has_tag_name("joint")))
        .filter_map(|joint| joint.attribute("name"))
        .collect();
    for name in &transmissions {
        if !joints.iter().any(|joint| joint.name == *name) {
            reading.omit(format!("transmission of the unknown joint {name}"));
        }
    }
    for joint in joints {
        let Some(body) = bodies.get(joint.child).copied() else { continue };
        let has_one = robot.bodies[body].joints.first().is_some_and(Joint::has_one_coordinate);
        let is_driven = transmissions.is_empty() || transmissions.contains(&joint.name);
        if has_one && is_driven && element(joint.node, "mimic").is_none() {
            robot.actuators.push(Actuator {
                name: format!("tau_{}", joint.name),
                joint: JointIndex { body, joint: 0 },
                gain: 1.0,
                bias: 0.0,
                position_gain: 0.0,
                velocity_gain: 0.0,
                input: ActuatorInput::Load,
            });
        }
    }
}

/// Attributes of the elements that are read. An attribute with a slip in its name would otherwise be lost.
const ATTRIBUTES: &[(&str, &[&str])] = &[
    ("origin", &["xyz", "rpy"]),
    ("axis", &["xyz"]),
    ("mass", &["value"]),
    ("inertia", &["ixx", "ixy", "ixz", "iyy", "iyz", "izz"]),
    ("limit", &["lower", "upper", "effort", "velocity"]),
    ("dynamics", &["damping", "friction"]),
    ("mimic", &["joint", "multiplier", "offset"]),
];

/// Lists the elements of the root that have no meaning in a model of rigid bodies.
fn list_omissions(root: Node<'_, '_>, reading: &Reading) {
    for node in elements(root) {
        match node.tag_name().name() {
            "link" | "joint" | "material" | "transmission" => {}
            other => reading.omit(format!("element `{other}`")),
        }
    }
    for (tag, known) in ATTRIBUTES {
        for node in root.descendants().filter(|node| node.has_tag_name(*tag)) {
            for attribute in node.attributes().filter(|attribute| !known.contains(&attribute.name())) {
                reading.omit(format!("unknown attribute `{}` of `{tag}`", attribute.name()));
            }
        }
    }
    let limits = root.descendants().filter(|node| node.has_tag_name("limit"));
    for limit in limits.flat_map(|node| node.attributes()) {
        let is_kept = matches!(limit.name(), "lower" | "upper");
        let numbers = numbers_of(limit.value(), &limit.range_value(), limit.name(), &Reading::default());
        if !is_kept && numbers.is_some_and(|numbers| numbers.iter().any(|number| *number != 0.0)) {
            reading.omit(format!("limit of {}", limit.name()));
        }
    }
}
