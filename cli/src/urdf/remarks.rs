//! Parts of a model that a robot description in URDF does not have.

use super::numbers::Numbers;
use tripos_derive::Model;
use tripos_derive::model::MotionConstraintKind;

/// Acceleration of free fall that readers of URDF take, m/s², along the axes of the ground.
const USUAL_GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// Sentences about the parts of a model for which URDF has no form, except loads, shapes and limits.
pub fn parts_without_form(model: &Model, numbers: &Numbers) -> Vec<String> {
    let mut list = Vec::new();
    match &model.gravity {
        None => list.push("gravity: the model has none, and readers of URDF add 9.81 m/s² against axis 3".to_owned()),
        Some(gravity) => match numbers.constants(&gravity.acceleration) {
            Some(found) if found == USUAL_GRAVITY => {}
            Some([x, y, z]) => list.push(format!(
                "gravity ({x}, {y}, {z}) m/s²: readers of URDF take (0, 0, -9.81) m/s²; set it in their program"
            )),
            None => list.push(
                "gravity that depends on inputs or on the time: set it in the program that reads the file".to_owned(),
            ),
        },
    }
    let inputs = names(model.inputs.iter().map(|input| input.name.as_str()));
    if !inputs.is_empty() {
        list.push(format!("inputs {inputs}: URDF states no drives"));
    }
    let potentials = names(model.potentials.iter().map(|potential| potential.name.as_str()));
    if !potentials.is_empty() {
        list.push(format!("potentials {potentials}: URDF states no springs"));
    }
    let added = names(model.added_masses.iter().map(|added| model.bodies[added.body].name.as_str()));
    if !added.is_empty() {
        list.push(format!("added masses of {added}: URDF states no fluid"));
    }
    let constraints = model.motion_constraints.iter().filter(|constraint| {
        matches!(constraint.kind, MotionConstraintKind::Stated | MotionConstraintKind::Rolling(_))
    });
    let driven = model.loops.iter().filter(|one| one.prescribes).map(|one| one.name.as_str());
    let constraints = names(constraints.map(|constraint| constraint.name.as_str()).chain(driven));
    if !constraints.is_empty() {
        list.push(format!("constraints {constraints}: URDF states none, and the robot moves without them"));
    }
    list
}

/// Names in backquotes, separated by commas.
pub fn names<'a>(list: impl Iterator<Item = &'a str>) -> String {
    list.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}
