//! Links of a robot description from the tree of joints.

use super::Description;
use super::builder::LinkBuilder;
use super::joint_numbers::JointNumbers;
use super::names::Names;
use super::remarks::{names, parts_without_form};
use super::shapes::shape_on_node;
use super::tree::{NodeMotion, NodePlace, axes_with_third};
use nalgebra::Vector3;
use tripos_derive::diagnostic::Diagnostic;
use tripos_derive::model::JointedBody;
use tripos_robots::{AxisJoint, Inertia, Link, LinkJoint, LinkMotion, LinkTree, Mimic, Pose};

/// Link of a node.
struct NodeLink {
    /// Index of the body that gives the link its name, mass and axes; `None` for the ground and for links without a
    /// body.
    body: Option<usize>,
    /// Pose of the link's axes in the axes of the node.
    pose: Pose,
    /// Name of the joint.
    joint: String,
    /// Index of the link in the description; `None` for a node that was joined with another.
    link: Option<usize>,
}

impl LinkBuilder<'_> {
    /// Makes the description. `Err` with the errors of bodies whose mass or inertia is no number.
    pub fn description(mut self) -> Result<Description, Vec<Diagnostic>> {
        let mut remarks = parts_without_form(self.model, &self.numbers);
        let numbers = self.joint_numbers(&mut remarks);
        let inertias = self.inertias()?;
        let mut joint_names = Names::default();
        let mut nodes = self.node_links(&mut joint_names);
        let mut link_names = Names::default();
        let body_names: Vec<String> = self.model.bodies.iter().map(|body| link_names.reserve(&body.name)).collect();
        let root = link_names.reserve("world");
        let mut links = vec![Link { name: root, inertia: None, shapes: Vec::new(), joint: None }];
        nodes[0].link = Some(0);
        for at in (1..nodes.len()).filter(|at| self.tree.nodes[*at].is_kept) {
            let name = match nodes[at].body {
                Some(body) => body_names[body].clone(),
                None => link_names.reserve(&format!("{}_link", nodes[at].joint)),
            };
            let inertia = nodes[at].body.and_then(|body| self.inertia_on(body, &inertias[body], &nodes[at].pose));
            let joint = self.link_joint(at, &nodes, &numbers);
            nodes[at].link = Some(links.len());
            links.push(Link { name, inertia, shapes: Vec::new(), joint: Some(joint) });
        }
        for body in 0..self.centres.len() {
            let node = self.centres[body].node;
            let (false, Some(parent)) = (nodes[node].body == Some(body), nodes[node].link) else { continue };
            let pose = self.body_pose(body);
            let inertia = self.inertia_on(body, &inertias[body], &pose);
            let origin = nodes[node].pose.inverse().compose(&pose);
            let name = self.joint_of(body).map(|joint| self.model.points[joint.point].name.clone());
            let name = name.unwrap_or_else(|| format!("{}_fixed", body_names[body]));
            let joint = LinkJoint { name: joint_names.reserve(&name), parent, origin, motion: LinkMotion::Fixed };
            links.push(Link { name: body_names[body].clone(), inertia, shapes: Vec::new(), joint: Some(joint) });
        }
        self.add_points(&nodes, &mut links, &mut link_names, &mut joint_names, &mut remarks);
        self.add_shapes(&nodes, &mut links, &mut remarks);
        let notes = self.notes_on_links(&links, &mut remarks);
        let coordinates = self.coordinate_sentences(&nodes);
        Ok(Description { robot: LinkTree { name: self.model.title.clone(), links }, coordinates, remarks, notes })
    }

    /// Tree joint that places a body.
    fn joint_of(&self, body: usize) -> Option<JointedBody> {
        self.model.carried.iter().find(|joint| joint.body == body).copied()
    }

    /// Pose of a body's axes in the axes of its node. The origin is at the joint that places the body; without one, at
    /// the origin of the node, and for a particle at its place.
    fn body_pose(&mut self, body: usize) -> Pose {
        let Some((frame, _)) = self.model.bodies[body].rigid else {
            return Pose::at(self.centres[body].position);
        };
        let rotation = self.places.frames[frame].in_group;
        let at_joint = self.joint_of(body).and_then(|joint| {
            let chain = self.places.chain(&mut self.numbers, Some(frame), joint.point).ok()?;
            self.tree.find(&self.places, &chain).filter(|place| place.node == self.centres[body].node)
        });
        Pose { position: at_joint.map_or_else(Vector3::zeros, |place| place.position), rotation }
    }

    /// Links of the nodes, with the names of their joints. The first rigid body of a node gives its link mass and axes,
    /// or else the first particle.
    fn node_links(&mut self, names: &mut Names) -> Vec<NodeLink> {
        let mut list = Vec::new();
        for at in 0..self.tree.nodes.len() {
            let own = (0..self.centres.len()).filter(|body| self.centres[*body].node == at && at > 0);
            let body = own.min_by_key(|body| (self.model.bodies[*body].rigid.is_none(), *body));
            let mut pose = body.map_or_else(Pose::default, |body| self.body_pose(body));
            let node = &self.tree.nodes[at];
            match node.motion {
                NodeMotion::Slide { .. } => {}
                NodeMotion::Planar { axis, .. } => pose = Pose { rotation: axes_with_third(axis), ..Pose::default() },
                NodeMotion::Turn { .. } => pose.position = Vector3::zeros(),
                NodeMotion::Ground | NodeMotion::EulerParameters(_) | NodeMotion::Free(_) => pose = Pose::default(),
            }
            list.push(NodeLink { body, pose, joint: String::new(), link: None });
        }
        // Joints that lead have the first choice of a name.
        let follows = |at: &usize| {
            let first = self.tree.nodes[*at].coordinates().first();
            first.and_then(|coordinate| self.tree.owner(*coordinate)) != Some(*at)
        };
        let mut order: Vec<usize> = (1..list.len()).filter(|at| self.tree.nodes[*at].is_kept).collect();
        order.sort_by_key(follows);
        for at in order {
            list[at].joint = names.reserve(&self.joint_name(at));
        }
        list
    }

    /// Name of a node's joint: that of the model's joint, if it brings one coordinate alone or if the node has all its
    /// coordinates. Otherwise, the name is that of the coordinate.
    fn joint_name(&self, at: usize) -> String {
        let node = &self.tree.nodes[at];
        let first = node.coordinates().first().copied();
        let is_leader = first.and_then(|coordinate| self.tree.owner(coordinate)) == Some(at);
        let is_own = |joint: &&JointedBody| {
            let carrier = joint.on.map_or(0, |on| self.centres[on].node);
            let between = self.tree.nodes_between(carrier, self.centres[joint.body].node);
            let coordinates = || between.iter().map(|node| self.tree.nodes[*node].coordinates());
            let is_alone = is_leader && coordinates().all(|own| own == node.coordinates());
            between.contains(&at) && (between.len() == 1 || is_alone)
        };
        match (self.model.carried.iter().find(is_own), first) {
            (Some(joint), _) => self.model.points[joint.point].name.clone(),
            (None, Some(coordinate)) if is_leader => self.model.coordinates[coordinate].name.clone(),
            (None, Some(coordinate)) => format!("{}_follower", self.model.coordinates[coordinate].name),
            (None, None) => "joint".to_owned(),
        }
    }

    /// Joint that moves a node.
    fn link_joint(&self, at: usize, nodes: &[NodeLink], numbers: &JointNumbers) -> LinkJoint {
        let node = &self.tree.nodes[at];
        let owner = node.coordinates().first().and_then(|coordinate| self.tree.owner(*coordinate));
        let is_own = owner == Some(at);
        let mut origin = node.origin.clone();
        let to_link = nodes[at].pose.rotation.transpose();
        let leader = owner.filter(|_| !is_own);
        let axis_joint = |coordinate: usize, axis: Vector3<f64>, factor: f64, offset: f64| {
            let reach = |q: f64| factor * q + offset;
            let (lower, upper) = numbers.limits[coordinate];
            let limits = match leader {
                None => (lower, upper),
                Some(_) if factor < 0.0 => (reach(upper), reach(lower)),
                Some(_) => (reach(lower), reach(upper)),
            };
            let (damping, friction) = numbers.damping_and_friction(at);
            let mimic = leader.map(|leader| Mimic { leader: nodes[leader].joint.clone(), factor, offset });
            AxisJoint { axis: to_link * axis, limits, damping, friction, mimic }
        };
        let motion = match node.motion {
            NodeMotion::Turn { coordinate, axis, slope, constant } => {
                let unit = Vector3::ith(axis, 1.0);
                LinkMotion::Hinge(if is_own {
                    origin.rotation *= node.constant_turn();
                    axis_joint(coordinate, unit * slope.signum(), 1.0, 0.0)
                } else {
                    axis_joint(coordinate, unit, slope, constant)
                })
            }
            NodeMotion::Slide { coordinate, vector } => {
                let factor = if is_own { 1.0 } else { vector.norm() };
                LinkMotion::Slide(axis_joint(coordinate, vector.normalize(), factor, 0.0))
            }
            NodeMotion::Planar { .. } => LinkMotion::Planar,
            NodeMotion::Free(_) => LinkMotion::Floating,
            NodeMotion::Ground | NodeMotion::EulerParameters(_) => LinkMotion::Fixed,
        };
        let origin = nodes[node.carrier].pose.inverse().compose(&origin).compose(&nodes[at].pose);
        let parent = nodes[node.carrier].link.unwrap_or(0);
        LinkJoint { name: nodes[at].joint.clone(), parent, origin, motion }
    }

    /// Adds a fixed link without mass for each point that stands for no body and no joint and from which nothing is
    /// placed, such as the tip of a tool. Its axes are those of the link that carries it. Points without a link are
    /// added to the remarks.
    fn add_points(
        &mut self,
        nodes: &[NodeLink],
        links: &mut Vec<Link>,
        link_names: &mut Names,
        joint_names: &mut Names,
        remarks: &mut Vec<String>,
    ) {
        let points = &self.model.points;
        let is_used = |at: usize| {
            self.model.bodies.iter().any(|body| body.centre == at)
                || self.model.carried.iter().any(|joint| joint.point == at)
                || points.iter().filter_map(|point| point.position.as_ref()).any(|place| place.parent == at)
        };
        let tips: Vec<usize> = (1..points.len()).filter(|at| !is_used(*at)).collect();
        for at in tips {
            let chain = self.places.chain(&mut self.numbers, None, at);
            let place = chain.ok().and_then(|chain| self.tree.find(&self.places, &chain));
            let carried = place.and_then(|place| Some((nodes[place.node].link?, place)));
            let Some((parent, NodePlace { node, position })) = carried else {
                remarks.push(format!("point `{}`: it moves with no link", points[at].name));
                continue;
            };
            let origin = Pose::at(nodes[node].pose.inverse().transform(&position));
            let name = link_names.reserve(&points[at].name);
            let joint = joint_names.reserve(&format!("{name}_fixed"));
            let joint = LinkJoint { name: joint, parent, origin, motion: LinkMotion::Fixed };
            links.push(Link { name, inertia: None, shapes: Vec::new(), joint: Some(joint) });
        }
    }

    /// Adds the shapes to their links. Shapes without a form in URDF are added to the remarks.
    fn add_shapes(&mut self, nodes: &[NodeLink], links: &mut [Link], remarks: &mut Vec<String>) {
        for shape in &self.model.shapes {
            match shape_on_node(shape, &self.places, &self.tree, &mut self.numbers) {
                Ok((node, found)) => {
                    let Some(link) = nodes[node].link else {
                        remarks.push(format!("shape `{}`: it moves with no link", shape.name));
                        continue;
                    };
                    let pose = nodes[node].pose.inverse().compose(&found.pose);
                    links[link].shapes.push(tripos_robots::Shape { pose, ..found });
                }
                Err(reason) => remarks.push(format!("shape `{}`: {reason}", shape.name)),
            }
        }
    }

    /// Sentences on links that readers may refuse. Coordinates without a joint are added to the remarks.
    fn notes_on_links(&self, links: &[Link], remarks: &mut Vec<String>) -> Vec<String> {
        let mut notes = Vec::new();
        let unused = (0..self.numbers.coordinates.len()).filter(|at| self.tree.owner(*at).is_none());
        let unused = names(unused.map(|at| self.model.coordinates[at].name.as_str()));
        if !unused.is_empty() {
            remarks.push(format!("coordinates {unused}: they move no body"));
        }
        let moves = |link: &&Link| link.joint.as_ref().is_some_and(|joint| !matches!(joint.motion, LinkMotion::Fixed));
        let is_light = |link: &&Link| {
            let least = |one: &Inertia| one.tensor.symmetric_eigenvalues().min().min(one.mass);
            link.inertia.as_ref().is_none_or(|one| least(one) <= 0.0)
        };
        let light = names(links.iter().filter(moves).filter(is_light).map(|link| link.name.as_str()));
        if !light.is_empty() {
            notes.push(format!(
                "mass or a moment of inertia of the links {light} is zero: MuJoCo and Gazebo refuse such links"
            ));
        }
        let is_impossible = |link: &&Link| link.inertia.as_ref().is_some_and(|one| one.impossibility().is_some());
        let impossible = names(links.iter().filter(is_impossible).map(|link| link.name.as_str()));
        if !impossible.is_empty() {
            notes.push(format!(
                "moments of inertia of the links {impossible} are those of no body: readers may refuse these links"
            ));
        }
        notes
    }

    /// Sentences on the coordinates of joints whose names differ from those of the coordinates.
    fn coordinate_sentences(&self, nodes: &[NodeLink]) -> Vec<String> {
        let mut list = Vec::new();
        for (at, node) in self.tree.nodes.iter().enumerate().skip(1).filter(|(_, node)| node.is_kept) {
            let own = node.coordinates().iter().filter(|coordinate| self.tree.owner(**coordinate) == Some(at));
            let own: Vec<&str> = own.map(|coordinate| self.model.coordinates[*coordinate].name.as_str()).collect();
            if !own.is_empty() && own != [nodes[at].joint.as_str()] {
                let word = if own.len() == 1 { "coordinate" } else { "coordinates" };
                list.push(format!("Joint `{}` has the {word} {}.", nodes[at].joint, names(own.into_iter())));
            }
        }
        list
    }
}
