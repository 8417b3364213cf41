//! MJCF files of MuJoCo: bodies with their joints, geoms that give mass, loops and couplings under `<equality>`, and
//! actuators of joints.
//!
//! Conventions (MuJoCo XML reference): angles are in degrees unless the compiler says otherwise; the poses of the
//! file are those of the reference configuration, in which each joint coordinate has the value `ref`; an anchor of
//! `<connect>` is in the axes of the first body, one of `<weld>` in those of the second.

mod actuators;
mod compiler;
mod element;
mod equalities;
mod geoms;
mod mesh_assets;

use crate::pose::Pose;
use crate::robot::{Body, Inertia, Joint, JointIndex, JointMotion, Robot};
use crate::xml::{Reading, elements, has_nonzero_number, place, vector};
use compiler::{Compiler, InertiaSource};
use element::{Defaults, Element, read_orientation, read_pose};
use mesh_assets::MeshAssets;
use nalgebra::{Matrix3, Vector3};
use roxmltree::Node;
use std::collections::BTreeMap;

/// Acceleration of free fall of a file that states none, m/s².
const GRAVITY: f64 = 9.81;

/// A site or a body: index of the body (`None` for the ground), and the pose in its axes.
#[derive(Clone)]
struct NamedFrame {
    /// Index of the body; `None` for the ground.
    body: Option<usize>,
    /// Pose in the axes of the body.
    pose: Pose,
}

/// Reader of a file: the robot so far, and what elements refer to by name.
struct Reader<'a, 'm> {
    /// Reading so far.
    reading: &'m Reading,
    /// Settings of `<compiler>`.
    compiler: Compiler,
    /// Default classes.
    defaults: Defaults<'a>,
    /// Meshes that the file declares.
    meshes: MeshAssets,
    /// Robot so far.
    robot: Robot,
    /// Poses of the bodies on the ground in the reference configuration.
    reference_poses: Vec<Pose>,
    /// Bodies by name.
    bodies: BTreeMap<&'a str, usize>,
    /// Sites by name.
    sites: BTreeMap<&'a str, NamedFrame>,
    /// Joints by name.
    joints: BTreeMap<&'a str, JointIndex>,
}

/// Surroundings of an element: its body, the pose of its frame, and the default class of the elements in it.
#[derive(Clone)]
struct Surroundings<'a> {
    /// Index of the body; `None` for the ground.
    body: Option<usize>,
    /// Pose of the frame in the axes of the body.
    pose: Pose,
    /// Default class.
    class: Option<&'a str>,
}

/// An element in a body or in a frame of the body.
struct Framed<'a, 'i> {
    /// Element of the file.
    node: Node<'a, 'i>,
    /// Pose of the frame in the axes of the body.
    pose: Pose,
    /// Default class of the frame or the body.
    class: Option<&'a str>,
}

/// Elements in a body and in its frames, other than bodies, in the order of the file. `pose_of` reads the pose of a
/// frame.
fn framed_elements<'a, 'i>(
    node: Node<'a, 'i>,
    class: Option<&'a str>,
    pose_of: &dyn Fn(Node<'a, 'i>) -> Pose,
) -> Vec<Framed<'a, 'i>> {
    let mut found = Vec::new();
    for child in elements(node).filter(|child| !child.has_tag_name("body")) {
        if !child.has_tag_name("frame") {
            found.push(Framed { node: child, pose: Pose::default(), class });
            continue;
        }
        let outer = pose_of(child);
        let inside = framed_elements(child, child.attribute("childclass").or(class), pose_of);
        found.extend(inside.into_iter().map(|framed| Framed { pose: outer.compose(&framed.pose), ..framed }));
    }
    found
}

/// Reads an MJCF file.
pub fn read(root: Node<'_, '_>, reading: &Reading) -> Robot {
    let mut reader = Reader {
        reading,
        compiler: compiler::read(root, reading),
        defaults: Defaults::default(),
        meshes: MeshAssets::default(),
        robot: Robot::new(root.attribute("model").unwrap_or("robot"), GRAVITY),
        reference_poses: Vec::new(),
        bodies: BTreeMap::new(),
        sites: BTreeMap::new(),
        joints: BTreeMap::new(),
    };
    for include in root.descendants().filter(|node| node.has_tag_name("include")) {
        let advice = "put the text of that file here; MuJoCo's `mj_saveLastXML` writes a whole file";
        reading.add(place(include), "the file includes another one", advice);
    }
    for node in elements(root).filter(|node| node.has_tag_name("default")) {
        reader.defaults.read(node);
    }
    reader.meshes = MeshAssets::new(root, &reader.defaults, &reading.meshes);
    reader.read_options(root);
    for node in elements(root).filter(|node| node.has_tag_name("worldbody")) {
        reader.read_content(node, &Surroundings { body: None, pose: Pose::default(), class: None });
    }
    reader.scale_masses();
    for node in elements(root) {
        match node.tag_name().name() {
            "equality" => reader.read_equalities(node),
            "actuator" => reader.read_actuators(node),
            "compiler" | "default" | "option" | "worldbody" | "asset" | "visual" | "statistic" | "size" | "include" => {
            }
            other => {
                for part in elements(node) {
                    let text = format!("{} `{}`", other, part.tag_name().name());
                    reader.reading.omit(text);
                }
            }
        }
    }
    reader.robot
}

impl<'a> Reader<'a, '_> {
    /// Reads `<option>`: the acceleration of free fall.
    fn read_options(&mut self, root: Node<'a, '_>) {
        for node in elements(root).filter(|node| node.has_tag_name("option")) {
            if let Some(gravity) = vector(node, "gravity", self.reading) {
                self.robot.gravity = gravity;
            }
            for flag in elements(node).filter(|flag| flag.has_tag_name("flag")).flat_map(|flag| flag.attributes()) {
                match (flag.name(), flag.value()) {
                    ("gravity", "disable") => self.robot.gravity = Vector3::zeros(),
                    (
                        "spring" | "damper" | "actuation" | "equality" | "limit" | "frictionloss" | "passive",
                        "disable",
                    ) => {
                        self.reading.omit(format!("flag that disables `{}`: the model has it", flag.name()));
                    }
                    _ => {}
                }
            }
            for name in ["density", "viscosity", "wind"] {
                if node.attribute(name).is_some_and(has_nonzero_number) {
                    self.reading.omit(format!("{name} of the medium"));
                }
            }
        }
    }

    /// Reads the elements in a body, in a frame, or on the ground. Returns the geoms of the body.
    fn read_content(&mut self, node: Node<'a, '_>, around: &Surroundings<'a>) -> Vec<geoms::Geom> {
        let mut found = Vec::new();
        for child in elements(node) {
            let element = self.defaults.element(child, around.class, self.reading);
            match child.tag_name().name() {
                "geom" => {
                    let angles = &self.compiler.angles;
                    let geom = geoms::read(&element, &around.pose, angles, &self.meshes, self.reading);
                    if around.body.is_none() {
                        self.robot.ground_shapes.extend(geom.shape);
                    } else {
                        found.push(geom);
                    }
                }
                "site" => {
                    let pose = around.pose.compose(&read_pose(&element, &self.compiler.angles, self.reading));
                    if let Some(name) = child.attribute("name") {
                        self.sites.insert(name, NamedFrame { body: around.body, pose });
                    }
                }
                "frame" => {
                    let pose = around.pose.compose(&read_pose(&element, &self.compiler.angles, self.reading));
                    let class = child.attribute("childclass").or(around.class);
                    found.extend(self.read_content(child, &Surroundings { body: around.body, pose, class }));
                }
                "body" => self.read_body(child, around),
                "joint" | "freejoint" | "inertial" | "camera" | "light" => {}
                other @ ("replicate" | "attach" | "composite" | "flexcomp") => {
                    let advice = "write out its bodies; MuJoCo's `mj_saveLastXML` does it";
                    self.reading.add(place(child), format!("`{other}` makes bodies, and is not read"), advice);
                }
                other => self.reading.omit(format!("element `{other}`")),
            }
        }
        found
    }

    /// Reads a body and the bodies that it carries.
    fn read_body(&mut self, node: Node<'a, '_>, around: &Surroundings<'a>) {
        let index = self.robot.bodies.len();
        let class = node.attribute("childclass").or(around.class);
        let plain = self.defaults.element(node, None, self.reading);
        let pose = around.pose.compose(&read_pose(&plain, &self.compiler.angles, self.reading));
        let outer = around.body.map_or_else(Pose::default, |parent| self.reference_poses[parent].clone());
        self.reference_poses.push(outer.compose(&pose));
        let name = node.attribute("name").map_or_else(|| format!("body{}", index + 1), str::to_owned);
        if let Some(own) = node.attribute("name")
            && let Some(first) = self.bodies.insert(own, index)
        {
            let first = self.robot.bodies[first].place.clone();
            let message = format!("the body `{own}` stands twice");
            self.reading.add_with_other(place(node), message, "give each a name of its own", first, "first here");
        }
        if node.attribute("mocap") == Some("true") {
            self.reading.omit(format!("motion of the body {name}, which a user sets"));
        }
        if node.attribute("gravcomp").is_some_and(has_nonzero_number) {
            self.reading.omit(format!("compensation of the weight of {name}"));
        }
        self.robot.bodies.push(Body {
            name: name.clone(),
            parent: around.body,
            pose: pose.clone(),
            joints: Vec::new(),
            inertia: None,
            shapes: Vec::new(),
            place: place(node),
        });
        let is_top = around.body.is_none();
        let own = framed_elements(node, class, &|element| {
            read_pose(&self.defaults.element(element, None, self.reading), &self.compiler.angles, self.reading)
        });
        for Framed { node: child, pose: frame, class } in &own {
            if !matches!(child.tag_name().name(), "joint" | "freejoint") {
                continue;
            }
            let (child, class) = (*child, *class);
            let number = self.robot.bodies[index].joints.len();
            let Some(mut joint) = self.read_joint(child, class, &name, number, is_top) else { continue };
            joint.position = frame.transform(&joint.position);
            joint.axis = frame.rotation * joint.axis;
            if joint.motion == JointMotion::Free {
                // The coordinates of a free joint are the pose on the ground.
                self.robot.bodies[index].pose = Pose::default();
            }
            let joint_index = JointIndex { body: index, joint: number };
            if let Some(own) = child.attribute("name")
                && let Some(first) = self.joints.insert(own, joint_index)
            {
                let first = self.robot.joint(first).place.clone();
                let message = format!("the joint `{own}` stands twice");
                self.reading.add_with_other(place(child), message, "give each a name of its own", first, "first here");
            }
            let start = pose.clone();
            self.robot.bodies[index].joints.push(Joint { free_start: start, ..joint });
        }
        let inside = Surroundings { body: Some(index), pose: Pose::default(), class };
        let geoms = self.read_content(node, &inside);
        let inertial = own.iter().find(|framed| framed.node.has_tag_name("inertial"));
        self.robot.bodies[index].inertia = self.body_inertia(node, inertial, &geoms);
        self.robot.bodies[index].shapes = geoms.into_iter().filter_map(|geom| geom.shape).collect();
    }

    /// Mass and inertia of a body, from `<inertial>` or from its geoms. `None` for a body without mass.
    fn body_inertia(
        &self,
        node: Node<'a, '_>,
        inertial: Option<&Framed<'a, '_>>,
        geoms: &[geoms::Geom],
    ) -> Option<Inertia> {
        let takes_geoms = match self.compiler.inertia_source {
            InertiaSource::Auto => inertial.is_none(),
            InertiaSource::Geoms => !geoms.is_empty() || inertial.is_none(),
            InertiaSource::Inertial => false,
        };
        let inertia = if takes_geoms {
            let [least, most] = self.compiler.mass_groups;
            let massive = || geoms.iter().filter(|geom| geom.group >= least && geom.group <= most);
            if massive().any(|geom| geom.is_mesh) {
                let message = "the mass of this body comes from a mesh, which is not read";
                self.reading.add(place(node), message, "add `<inertial …/>` to the body");
            }
            massive().filter_map(|geom| geom.inertia.clone()).reduce(|sum, one| sum.joined(&one))
        } else {
            inertial.and_then(|inertial| Some(self.read_inertial(inertial.node)?.moved(&inertial.pose)))
        };
        let mut inertia = inertia.filter(|inertia| inertia.mass != 0.0)?;
        if inertia.mass > 0.0 {
            inertia.mass = inertia.mass.max(self.compiler.least_mass);
        }
        if self.compiler.least_moment > 0.0 {
            let mut principal = inertia.tensor.symmetric_eigen();
            principal.eigenvalues.apply(|moment| *moment = moment.max(self.compiler.least_moment));
            inertia.tensor = principal.recompose();
        }
        if let Some(reason) = inertia.impossibility() {
            if self.compiler.balances_moments {
                inertia.tensor = Matrix3::identity() * (inertia.tensor.trace() / 3.0);
            } else {
                let message = format!("this inertia is impossible: {reason}");
                let advice = "correct the mass or the moments: no body can have them";
                self.reading.add(place(inertial.map_or(node, |inertial| inertial.node)), message, advice);
            }
        }
        Some(inertia)
    }

    /// Reads `<inertial>`. `None` after recording a mistake.
    fn read_inertial(&self, node: Node<'a, '_>) -> Option<Inertia> {
        let element = self.defaults.element(node, None, self.reading);
        let pose = read_pose(&element, &self.compiler.angles, self.reading);
        let Some(mass) = element.number("mass", self.reading) else {
            if element.text("mass").is_none() {
                self.reading.add(place(node), "`inertial` has no mass", "add `mass=\"…\"`");
            }
            return None;
        };
        let tensor = match (element.text("fullinertia"), element.text("diaginertia")) {
            (Some(_), Some(_)) => {
                let message = "both `fullinertia` and `diaginertia` state the inertia";
                self.reading.add(element.place_of("fullinertia"), message, "give one of them");
                return None;
            }
            (Some(_), None) => {
                let [xx, yy, zz, xy, xz, yz] = element.fixed::<6>("fullinertia", self.reading)?;
                if read_orientation(&element, &self.compiler.angles, self.reading).is_some() {
                    let message = "`fullinertia` is in the axes of the body, and has no orientation of its own";
                    self.reading.add(element.place_of("fullinertia"), message, "leave the orientation out");
                }
                Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
            }
            (None, Some(_)) => Matrix3::from_diagonal(&element.vector("diaginertia", self.reading)?),
            (None, None) => Matrix3::zeros(),
        };
        Some(Inertia { mass, centre: Vector3::zeros(), tensor }.moved(&pose))
    }

    /// Reads a joint. `None` after recording a mistake.
    fn read_joint(
        &mut self,
        node: Node<'a, '_>,
        class: Option<&str>,
        body: &str,
        number: usize,
        is_top: bool,
    ) -> Option<Joint> {
        let element = self.defaults.element(node, class, self.reading);
        let is_free_element = node.has_tag_name("freejoint");
        let kind = if is_free_element { "free" } else { element.text("type").unwrap_or("hinge") };
        let motion = match kind {
            "hinge" => JointMotion::Hinge,
            "slide" => JointMotion::Slide,
            "ball" => JointMotion::Ball,
            "free" => JointMotion::Free,
            other => {
                let message = format!("there is no joint of the type `{other}`");
                self.reading.add(element.place_of("type"), message, "give `hinge`, `slide`, `ball` or `free`");
                return None;
            }
        };
        if motion == JointMotion::Free && !is_top {
            let advice = "put the body on the ground, or give it other joints";
            self.reading.add(place(node), "a free joint stands on a body that another body carries", advice);
            return None;
        }
        let axis = element.vector("axis", self.reading).unwrap_or_else(Vector3::z);
        if axis.norm() == 0.0 {
            self.reading.add(element.place_of("axis"), "the axis has the length 0", "give a direction");
            return None;
        }
        let number_text = if number == 0 { String::new() } else { (number + 1).to_string() };
        let name = node.attribute("name").map_or_else(|| format!("{body}_joint{number_text}"), str::to_owned);
        let mut joint = Joint::new(name, motion, axis, place(node));
        if motion != JointMotion::Free {
            joint.position = element.vector("pos", self.reading).unwrap_or_default();
        }
        if element.text("align") == Some("true") {
            self.reading
                .omit(format!("alignment of the free joint {}: its coordinates are those of the body", joint.name));
        }
        if is_free_element {
            return Some(joint);
        }
        let unit = if motion == JointMotion::Hinge { self.compiler.angles.unit } else { 1.0 };
        let value = |name: &str| element.number(name, self.reading).unwrap_or(0.0);
        joint.damping = value("damping");
        joint.friction = value("frictionloss");
        joint.stiffness = value("stiffness");
        joint.armature = value("armature");
        joint.spring_reference = value("springref") * unit;
        joint.reference = value("ref") * unit;
        list_joint_omissions(&element, &mut joint, self.reading);
        let is_limited = match element.text("limited") {
            Some("true") => true,
            Some("false") => false,
            _ => self.compiler.has_automatic_limits && element.text("range").is_some(),
        };
        if is_limited
            && joint.has_one_coordinate()
            && let Some([lower, upper]) = element.fixed::<2>("range", self.reading)
        {
            // The range 0 0 stands for no range, by which elements cancel that of their class.
            let is_none = lower == 0.0 && upper == 0.0;
            if lower >= upper && !is_none {
                let message = format!("the lower limit {lower} is not below the upper limit {upper}");
                self.reading.add(element.place_of("range"), message, "exchange the two limits");
            }
            joint.limits = (!is_none).then_some((lower * unit, upper * unit));
        }
        Some(joint)
    }

    /// Scales all masses and inertias to the total mass that the compiler sets.
    fn scale_masses(&mut self) {
        let Some(total) = self.compiler.total_mass else { return };
        let inertias = || self.robot.bodies.iter().filter_map(|body| body.inertia.as_ref());
        let factor = total / inertias().map(|inertia| inertia.mass).sum::<f64>();
        if factor.is_finite() {
            for inertia in self.robot.bodies.iter_mut().filter_map(|body| body.inertia.as_mut()) {
                inertia.mass *= factor;
                inertia.tensor *= factor;
            }
        }
    }
}

/// Lists properties of a joint that are left out, and removes them.
fn list_joint_omissions(element: &Element<'_, '_, '_>, joint: &mut Joint, reading: &Reading) {
    let name = joint.name.clone();
    if element.numbers("springdamper", reading).is_some_and(|numbers| numbers.iter().any(|n| *n != 0.0)) {
        reading.omit(format!("`springdamper` of the joint {name}"));
    }
    for property in ["stiffness", "damping"] {
        if element.numbers(property, reading).is_some_and(|n| n.iter().skip(1).any(|n| *n != 0.0)) {
            reading.omit(format!("higher powers in the {property} of the joint {name}"));
        }
    }
    if joint.has_one_coordinate() {
        if element.text("actuatorfrcrange").is_some() {
            reading.omit(format!("limit of the drives of the joint {name}"));
        }
        return;
    }
    if element.text("range").is_some() && joint.motion == JointMotion::Ball {
        reading.omit(format!("range of the ball joint {name}"));
    }
    let properties =
        [("stiffness", &mut joint.stiffness), ("armature", &mut joint.armature), ("dry friction", &mut joint.friction)];
    for (property, value) in properties {
        if *value != 0.0 {
            reading.omit(format!("{property} of the joint {name}, which has several coordinates"));
            *value = 0.0;
        }
    }
    if joint.motion == JointMotion::Free && joint.damping != 0.0 {
        reading.omit(format!("damping of the free joint {name}"));
        joint.damping = 0.0;
    }
}
