//! Bodies that are fixed to others are joined with them, so that the equations have as few bodies as the robot's
//! motion needs.

use crate::numbers::number_text;
use crate::pose::Pose;
use crate::robot::{Body, JointIndex, Marker, Omission, Robot};

/// Distance up to which the ends of a connection of fixed parts meet, m. Numbers of a file may have few digits.
const CLOSED: f64 = 1e-6;

/// Place of a former body after joining: index of the body that contains it (`None` for the ground), and its pose
/// there.
type Place = (Option<usize>, Pose);

/// Joins each body without joints with the body that carries it, and fixes joints at the ends of chains that move no
/// mass. Joined bodies become markers of the body that contains them.
pub fn join(robot: &mut Robot) {
    fix_massless_ends(robot);
    let former = std::mem::take(&mut robot.bodies);
    let mut places: Vec<Place> = Vec::with_capacity(former.len());
    for mut body in former {
        let (parent, outer) = match body.parent {
            Some(parent) => places[parent].clone(),
            None => (None, Pose::default()),
        };
        let pose = outer.compose(&body.pose);
        if !body.joints.is_empty() {
            places.push((Some(robot.bodies.len()), Pose::default()));
            body.parent = parent;
            body.pose = pose;
            robot.bodies.push(body);
            continue;
        }
        places.push((parent, pose.clone()));
        let has_mass = body.inertia.is_some();
        let shapes = body.shapes.into_iter().map(|mut shape| {
            shape.pose = pose.compose(&shape.pose);
            shape
        });
        match parent {
            Some(at) => {
                let carrier = &mut robot.bodies[at];
                if let Some(own) = body.inertia.map(|inertia| inertia.moved(&pose)) {
                    carrier.inertia =
                        Some(carrier.inertia.take().map_or_else(|| own.clone(), |before| before.joined(&own)));
                }
                carrier.shapes.extend(shapes);
            }
            None => robot.ground_shapes.extend(shapes),
        }
        robot.markers.push(Marker { name: body.name, body: parent, pose, has_mass });
    }
    for one in &mut robot.loops {
        move_end(&mut one.first, &mut one.first_pose, &places);
        move_end(&mut one.second, &mut one.second_pose, &places);
    }
    let (open, fixed): (Vec<_>, Vec<_>) = robot.loops.drain(..).partition(|one| one.first != one.second);
    robot.loops = open;
    for one in fixed {
        let gap = (one.first_pose.position - one.second_pose.position).norm();
        let apart = if gap > CLOSED { format!(", and stays open by {} m", number_text(gap)) } else { String::new() };
        let text = format!("connection {}: it joins parts that are fixed to one another{apart}", one.name);
        Omission::add(&mut robot.omissions, &text);
    }
    for joint in robot.couplings.iter_mut().flat_map(|one| std::iter::once(&mut one.follower).chain(&mut one.leader)) {
        move_joint(joint, &places);
    }
    for actuator in &mut robot.actuators {
        move_joint(&mut actuator.joint, &places);
    }
    robot.assembly = std::mem::take(&mut robot.assembly)
        .into_iter()
        .map(|(mut joint, value)| {
            move_joint(&mut joint, &places);
            (joint, value)
        })
        .collect();
}

/// Expresses an end of a loop in the axes of the body that contains it now.
fn move_end(body: &mut Option<usize>, pose: &mut Pose, places: &[Place]) {
    if let Some(before) = *body {
        let (now, outer) = &places[before];
        *body = *now;
        *pose = outer.compose(pose);
    }
}

/// Replaces the index of a joint's body by its index after joining. Bodies with joints stay bodies.
fn move_joint(joint: &mut JointIndex, places: &[Place]) {
    if let Some(now) = places[joint.body].0 {
        joint.body = now;
    }
}

/// Removes the joints of bodies that carry no mass, unless a loop or a coupling needs them.
fn fix_massless_ends(robot: &mut Robot) {
    let mut is_needed: Vec<bool> = robot.bodies.iter().map(has_inertia).collect();
    for at in robot.loops.iter().flat_map(|one| [one.first, one.second]).flatten() {
        is_needed[at] = true;
    }
    loop {
        let before = is_needed.clone();
        for at in (0..robot.bodies.len()).rev() {
            if let Some(parent) = robot.bodies[at].parent {
                is_needed[parent] |= is_needed[at];
            }
        }
        // A joint that leads one with mass is needed, too.
        for one in &robot.couplings {
            if let Some(leader) = one.leader {
                is_needed[leader.body] |= is_needed[one.follower.body];
            }
        }
        if is_needed == before {
            break;
        }
    }
    for at in (0..robot.bodies.len()).filter(|at| !is_needed[*at]) {
        robot.couplings.retain(|one| one.follower.body != at);
        robot.actuators.retain(|one| one.joint.body != at);
        for joint in robot.bodies[at].joints.drain(..) {
            let text = format!("motion of the joint {}: it moves no mass, and is fixed", joint.name);
            Omission::add(&mut robot.omissions, &text);
        }
    }
}

/// True if the body, or a drive of its joints, has mass or inertia.
fn has_inertia(body: &Body) -> bool {
    body.inertia.is_some() || body.joints.iter().any(|joint| joint.armature > 0.0)
}
