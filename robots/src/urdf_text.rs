//! Text of a URDF file: links in a tree of joints.
//!
//! Conventions are those of the reader, [`crate::import`]: `rpy` are turns about the fixed axes 1, 2 and 3, a link's
//! axes are those of the joint that carries it, and an inertia is about the mass centre. Numbers have the digits that
//! identify them. Poses and axes are computed, and have fifteen digits if rounding alone gives them more.

use crate::numbers::{exact_number_text, number_text, without_rounding};
use crate::pose::{Pose, yaw_pitch_roll};
use crate::robot::{Inertia, Shape, Solid};
use nalgebra::{Matrix3, Vector3};
use std::fmt::Write;

/// Size of a limit of URDF for a quantity without limit: rad, m, N, N m, rad/s or m/s.
///
/// URDF requires limits of effort and velocity for revolute and prismatic joints, and both ends of a range.
pub const NO_LIMIT: f64 = 1e6;

/// Robot as a tree of links.
#[derive(Clone, Debug)]
pub struct LinkTree {
    /// Name of the robot.
    pub name: String,
    /// Links. The first one is the root, and each other link stands after the link that carries it.
    pub links: Vec<Link>,
}

/// Rigid body of a [`LinkTree`], with the joint that carries it.
#[derive(Clone, Debug)]
pub struct Link {
    /// Name of the link.
    pub name: String,
    /// Mass and inertia in the axes of the link; `None` for a link without mass.
    pub inertia: Option<Inertia>,
    /// Shapes that show the link, in its axes. Ellipsoids and planes have no form in URDF, and are not written.
    pub shapes: Vec<Shape>,
    /// Joint that carries the link; `None` for the root.
    pub joint: Option<LinkJoint>,
}

/// Joint between a link and the link that carries it.
#[derive(Clone, Debug)]
pub struct LinkJoint {
    /// Name of the joint.
    pub name: String,
    /// Index of the link that carries the joint in [`LinkTree::links`].
    pub parent: usize,
    /// Pose of the moved link's axes in the axes of the carrier, where all coordinates of the joint are 0.
    pub origin: Pose,
    /// Motion that the joint permits.
    pub motion: LinkMotion,
}

/// Motion of a joint of a [`LinkTree`].
#[derive(Clone, Debug)]
pub enum LinkMotion {
    /// No motion.
    Fixed,
    /// Turn about an axis.
    Hinge(AxisJoint),
    /// Displacement along an axis.
    Slide(AxisJoint),
    /// Displacements along axes 1 and 2 of the joint's origin, then a turn about axis 3.
    Planar,
    /// Displacements along the axes of the joint's origin, and a turn by a quaternion.
    Floating,
}

/// Joint with one coordinate: its axis, limits, losses and coupling.
#[derive(Clone, Debug)]
pub struct AxisJoint {
    /// Axis in the axes of the moved link, of length 1.
    pub axis: Vector3<f64>,
    /// Smallest and largest value of the coordinate, rad or m; infinite without a limit.
    pub limits: (f64, f64),
    /// Viscous damping, N m s or N s/m.
    pub damping: f64,
    /// Dry friction, N m or N.
    pub friction: f64,
    /// Coordinate that this one follows; `None` for an independent coordinate.
    pub mimic: Option<Mimic>,
}

/// Coupling of a joint's coordinate q to that of another joint: q = factor · q of the leader + offset.
#[derive(Clone, Debug)]
pub struct Mimic {
    /// Name of the joint that leads.
    pub leader: String,
    /// Factor of the leader's coordinate.
    pub factor: f64,
    /// Value of the coordinate where the leader's coordinate is 0, rad or m.
    pub offset: f64,
}

/// Text of the URDF file of a robot. Each of the `comments` becomes a line of comment at the head of the file.
#[must_use]
pub fn urdf_text(robot: &LinkTree, comments: &[String]) -> String {
    let mut text = String::new();
    for comment in comments {
        // Two hyphens would end a comment of XML. After three hyphens, two still stand together once.
        let line = comment.replace(['\r', '\n'], " ").replace("--", "- -").replace("--", "- -");
        let _ = writeln!(text, "<!-- {line} -->");
    }
    let _ = writeln!(text, "<robot name=\"{}\">", escaped(&robot.name));
    for link in &robot.links {
        if let (Some(joint), name) = (&link.joint, escaped(&link.name)) {
            let parent = robot.links.get(joint.parent).map_or_else(String::new, |parent| escaped(&parent.name));
            write_joint(&mut text, joint, &parent, &name);
        }
        write_link(&mut text, link);
    }
    text + "</robot>\n"
}

/// Appends the element `link`.
fn write_link(text: &mut String, link: &Link) {
    let mut parts = String::new();
    if let Some(inertia) = &link.inertia {
        write_inertial(&mut parts, inertia);
    }
    for shape in &link.shapes {
        write_shape(&mut parts, shape);
    }
    let name = escaped(&link.name);
    let _ = if parts.is_empty() {
        writeln!(text, "  <link name=\"{name}\"/>")
    } else {
        writeln!(text, "  <link name=\"{name}\">\n{parts}  </link>")
    };
}

/// Appends the element `inertial`.
fn write_inertial(text: &mut String, inertia: &Inertia) {
    let tensor = &inertia.tensor;
    let [xx, xy, xz, yy, yz, zz] =
        [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)].map(|at| exact_number_text(tensor[at]));
    let mass = exact_number_text(inertia.mass);
    let origin = origin_text(&Pose::at(inertia.centre));
    let _ = writeln!(
        text,
        "    <inertial>\n      {origin}\n      <mass value=\"{mass}\"/>\n      <inertia ixx=\"{xx}\" ixy=\"{xy}\" \
         ixz=\"{xz}\" iyy=\"{yy}\" iyz=\"{yz}\" izz=\"{zz}\"/>\n    </inertial>"
    );
}

/// Appends the element `visual` of a shape. A capsule has three elements.
fn write_shape(text: &mut String, shape: &Shape) {
    let mut write_visual = |pose: &Pose, geometry: String| {
        let origin = origin_text(pose);
        let _ = writeln!(text, "    <visual>\n      {origin}\n      <geometry>{geometry}</geometry>\n    </visual>");
    };
    let sphere = |radius: f64| format!("<sphere radius=\"{}\"/>", exact_number_text(radius));
    let cylinder = |radius: f64, length: f64| {
        let (radius, length) = (exact_number_text(radius), exact_number_text(length));
        format!("<cylinder radius=\"{radius}\" length=\"{length}\"/>")
    };
    match &shape.solid {
        Solid::Sphere(radius) => write_visual(&shape.pose, sphere(*radius)),
        Solid::Cylinder(radius, length) => write_visual(&shape.pose, cylinder(*radius, *length)),
        Solid::Capsule(radius, length) => {
            write_visual(&shape.pose, cylinder(*radius, *length));
            for end in [-length / 2.0, length / 2.0] {
                write_visual(&shape.pose.compose(&Pose::at(Vector3::z() * end)), sphere(*radius));
            }
        }
        Solid::Block(size) => write_visual(&shape.pose, format!("<box size=\"{}\"/>", numbers_text(size))),
        Solid::Ellipsoid(_) | Solid::Plane => {}
    }
}

/// Appends the element `joint`.
fn write_joint(text: &mut String, joint: &LinkJoint, parent: &str, child: &str) {
    let (kind, axis) = match &joint.motion {
        LinkMotion::Fixed => ("fixed", None),
        LinkMotion::Hinge(axis) if has_limit(axis) => ("revolute", Some(axis)),
        LinkMotion::Hinge(axis) => ("continuous", Some(axis)),
        LinkMotion::Slide(axis) => ("prismatic", Some(axis)),
        LinkMotion::Planar => ("planar", None),
        LinkMotion::Floating => ("floating", None),
    };
    let (name, origin) = (escaped(&joint.name), origin_text(&joint.origin));
    let _ = writeln!(text, "  <joint name=\"{name}\" type=\"{kind}\">");
    let _ = writeln!(text, "    <parent link=\"{parent}\"/>\n    <child link=\"{child}\"/>\n    {origin}");
    if let LinkMotion::Planar = joint.motion {
        let _ = writeln!(text, "    <axis xyz=\"0 0 1\"/>");
    }
    if let Some(axis) = axis {
        let is_continuous = matches!(joint.motion, LinkMotion::Hinge(_)) && !has_limit(axis);
        write_axis_joint(text, axis, is_continuous);
    }
    let _ = writeln!(text, "  </joint>");
}

/// True if the coordinate has a limit on one side at least.
fn has_limit(joint: &AxisJoint) -> bool {
    joint.limits.0.is_finite() || joint.limits.1.is_finite()
}

/// Appends axis, limits, losses and coupling of a joint with one coordinate.
fn write_axis_joint(text: &mut String, joint: &AxisJoint, is_continuous: bool) {
    let axis = Vector3::from(without_rounding([joint.axis.x, joint.axis.y, joint.axis.z], 0.0));
    let _ = writeln!(text, "    <axis xyz=\"{}\"/>", numbers_text(&axis));
    if !is_continuous {
        let (lower, upper) = joint.limits;
        let stated = |bound: f64, none: f64| exact_number_text(if bound.is_finite() { bound } else { none });
        let [lower, upper] = [stated(lower, upper.min(-NO_LIMIT)), stated(upper, lower.max(NO_LIMIT))];
        let most = exact_number_text(NO_LIMIT);
        let _ =
            writeln!(text, "    <limit lower=\"{lower}\" upper=\"{upper}\" effort=\"{most}\" velocity=\"{most}\"/>");
    }
    if joint.damping != 0.0 || joint.friction != 0.0 {
        let [damping, friction] = [joint.damping, joint.friction].map(exact_number_text);
        let _ = writeln!(text, "    <dynamics damping=\"{damping}\" friction=\"{friction}\"/>");
    }
    if let Some(mimic) = &joint.mimic {
        let (leader, factor) = (escaped(&mimic.leader), exact_number_text(mimic.factor));
        let offset = exact_number_text(mimic.offset);
        let _ = writeln!(text, "    <mimic joint=\"{leader}\" multiplier=\"{factor}\" offset=\"{offset}\"/>");
    }
}

/// Element `origin` of a pose.
fn origin_text(pose: &Pose) -> String {
    let position = &pose.position;
    let xyz = Vector3::from(without_rounding([position.x, position.y, position.z], 0.0));
    if pose.rotation == Matrix3::identity() {
        return format!("<origin xyz=\"{}\"/>", numbers_text(&xyz));
    }
    let [yaw, pitch, roll] = without_rounding(yaw_pitch_roll(&pose.rotation), std::f64::consts::PI);
    let rpy = Vector3::new(roll, pitch, yaw);
    format!("<origin xyz=\"{}\" rpy=\"{}\"/>", numbers_text(&xyz), numbers_text(&rpy))
}

/// Three computed numbers, separated by spaces.
fn numbers_text(vector: &Vector3<f64>) -> String {
    [vector.x, vector.y, vector.z].map(number_text).join(" ")
}

/// Text as the value of an attribute of XML.
fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;");
    text.replace(['\r', '\n', '\t'], " ")
}
