//! Models that have no robot description in URDF, with the reasons.

use super::chains::{FrameTurn, NoChain, Places};
use super::numbers::Numbers;
use super::tree::{NodeMotion, Tree};
use std::ops::Range;
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::diagnostic::Diagnostic;
use tripos_derive::model::Body;

/// Errors of the parameters without value on which links, joints, limits or losses depend.
pub fn check_values(model: &Model) -> Vec<Diagnostic> {
    let mut terms: Vec<Expr> = Vec::new();
    terms.extend(model.frames.iter().filter_map(|frame| frame.rotation.as_ref()).flat_map(|(_, turn)| turn.terms()));
    terms.extend(model.points.iter().filter_map(|point| point.position.as_ref()).flat_map(|at| at.components));
    for body in &model.bodies {
        terms.push(body.mass);
        terms.extend(body.rigid.iter().flat_map(|(_, inertia)| inertia.tensor.as_flattened()));
    }
    terms.extend(model.gravity.iter().flat_map(|gravity| gravity.acceleration));
    terms.extend(model.domain.iter().map(|condition| condition.positive));
    terms.extend(model.shapes.iter().flat_map(|shape| shape.form.lengths()).map(|(_, length)| length));
    terms.extend(model.shapes.iter().flat_map(|shape| shape.position));
    let loads = model.torques.iter().map(|torque| torque.vector);
    let loads = loads.chain(model.forces.iter().map(|force| force.vector));
    let is_driven = |vector: &[Expr; 3]| {
        let mut inputs = model.parameters.iter().filter(|parameter| parameter.is_input);
        inputs.any(|input| vector.iter().any(|component| model.arena.mentions(*component, input.symbol)))
    };
    terms.extend(loads.filter(|vector| !is_driven(vector)).flatten());
    let used = model.arena.reachable(&terms);
    let missing = model
        .parameters
        .iter()
        .filter(|parameter| !parameter.is_input && parameter.value.is_none() && used.contains(&parameter.symbol));
    missing
        .map(|parameter| {
            Diagnostic::new(
                place_of(model, &parameter.name),
                format!("the parameter `{}` has no value", parameter.name),
                "URDF states numbers: add `value = …` to the parameter",
            )
        })
        .collect()
}

/// Errors of closed loops: URDF states trees. The condition that four Euler parameters have length 1 closes no loop.
pub fn check_loops(model: &Model, places: &Places<'_>, numbers: &Numbers) -> Vec<Diagnostic> {
    let is_norm = |equation: Expr| {
        let own: Vec<usize> = (0..numbers.coordinates.len())
            .filter(|at| model.arena.mentions(equation, numbers.coordinates[*at]))
            .collect();
        places.frames.iter().any(|frame| match frame.turn {
            FrameTurn::EulerParameters(mut list) => {
                list.sort_unstable();
                own == list
            }
            _ => false,
        })
    };
    let loops = model.loops.iter().chain(&model.closed).filter(|one| !one.prescribes && !is_norm(one.equation));
    let names = loops.map(|one| &one.name).chain(model.conditions.iter().map(|(name, _)| name));
    names
        .take(1)
        .map(|name| {
            let message = format!("the equation `{name}` between coordinates closes a loop: URDF states trees of joints alone");
            let advice = "leave the joints and constraints that close loops out of a copy of the model, and close the loops in the program that reads the file";
            // An equation of a joint is called after the joint.
            let joint = name.rfind('_').map(|at| &name[..at]);
            match model.declared.get(name).or_else(|| model.declared.get(joint?)) {
                Some(place) => Diagnostic::new(place.clone(), message, advice),
                None => Diagnostic::of_file(message, advice),
            }
        })
        .collect()
}

/// Error of a body that has no chain of joints.
pub fn diagnostic_of_chain(model: &Model, body: &Body, reason: NoChain) -> Diagnostic {
    let NoChain { message, advice, frame, point } = reason;
    let name = match (frame, point) {
        (Some(frame), _) => &model.frames[frame].name,
        (None, Some(point)) => &model.points[point].name,
        (None, None) => &body.name,
    };
    let message = format!("the body `{}` has no joint of URDF: {message}", body.name);
    Diagnostic::new(place_of(model, name), message, advice)
}

/// Errors of joints that URDF does not have, and of coordinates that are those of no joint.
pub fn check_tree(model: &Model, tree: &Tree) -> Vec<Diagnostic> {
    let mut errors = Vec::new();
    for (at, node) in tree.nodes.iter().enumerate().filter(|(_, node)| node.is_kept) {
        let frame = &model.frames[node.group].name;
        if let NodeMotion::EulerParameters(_) = node.motion {
            errors.push(Diagnostic::new(
                place_of(model, frame),
                format!("URDF has no ball joint: the frame `{frame}` turns by Euler parameters"),
                "state the turn by three angles, as `sequence = \"123\"` does, or free the body in all directions",
            ));
            continue;
        }
        for coordinate in node.coordinates() {
            let name = &model.coordinates[*coordinate].name;
            match tree.owner(*coordinate) {
                None => errors.push(Diagnostic::new(
                    place_of(model, name),
                    format!("`{name}` is the coordinate of no joint of URDF: each joint that it moves turns or slides by a multiple of it"),
                    "choose the angle, or the displacement, of a joint as the coordinate",
                )),
                Some(owner) if owner != at && node.coordinates().len() > 1 => errors.push(Diagnostic::new(
                    place_of(model, name),
                    format!("`{name}` is a coordinate of two joints, and a joint with several coordinates follows no other"),
                    "give each joint coordinates of its own",
                )),
                Some(_) => {}
            }
        }
    }
    errors
}

/// Place of a name in the model file; the beginning of the file if the name is made by Tripos.
pub fn place_of(model: &Model, name: &str) -> Range<usize> {
    model.declared.get(name).cloned().unwrap_or_default()
}
