//! Shapes of links.

use super::chains::Places;
use super::numbers::Numbers;
use super::tree::{NodePlace, Tree, axes_with_third};
use nalgebra::{Matrix3, Vector3};
use tripos_derive::model::{Shape, ShapeForm};
use tripos_robots::{Pose, Solid};

/// Shape of a model on a node of the tree, with its pose in the axes of the node. `Err` with the reason if URDF has no
/// such shape, or if it is fixed to no node.
pub fn shape_on_node(
    shape: &Shape,
    places: &Places<'_>,
    tree: &Tree,
    numbers: &mut Numbers,
) -> Result<(usize, tripos_robots::Shape), &'static str> {
    const NO_NUMBERS: &str = "its lengths are no numbers";
    let length = |e| numbers.constant(e).ok_or(NO_NUMBERS);
    let along = |axis: usize| axes_with_third(axis);
    let (solid, axes) = match &shape.form {
        ShapeForm::Sphere { radius } => (Solid::Sphere(length(*radius)?), Matrix3::identity()),
        ShapeForm::Cylinder { axis, radius, length: long } => {
            (Solid::Cylinder(length(*radius)?, length(*long)?), along(*axis))
        }
        ShapeForm::Disk { axis, radius, thickness: Some(thickness) } => {
            (Solid::Cylinder(length(*radius)?, length(*thickness)?), along(*axis))
        }
        ShapeForm::Box { size: [a, b, c] } => {
            (Solid::Block(Vector3::new(length(*a)?, length(*b)?, length(*c)?)), Matrix3::identity())
        }
        ShapeForm::Disk { .. } => return Err("a thin disk"),
        ShapeForm::Line { .. } => return Err("a line"),
        ShapeForm::Ground { .. } => return Err("a plane"),
    };
    let chain = places.chain(numbers, Some(shape.frame), shape.point);
    let chain = chain.map_err(|_| "its frame and its point are on two links")?;
    let place = tree.find(places, &chain).ok_or("it is fixed to no link")?;
    let middle = numbers.constants(&shape.position).ok_or(NO_NUMBERS)?;
    let NodePlace { node, position } = place;
    let rotation = places.frames[shape.frame].in_group;
    let pose = Pose { position: position + rotation * Vector3::from(middle), rotation: rotation * axes };
    Ok((node, tripos_robots::Shape { solid, pose, mesh: None }))
}
