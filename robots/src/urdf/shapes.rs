//! Shapes of a URDF file.

use crate::meshes::MeshFrame;
use crate::pose::Pose;
use crate::robot::{Shape, Solid};
use crate::xml::{Reading, element, elements, fixed_numbers, number, place};
use nalgebra::Vector3;
use roxmltree::Node;

/// Reads the shape of a `<visual>` or `<collision>` whose origin has a pose in the axes of the link. `None` for a mesh
/// without bounds, or after recording a mistake.
pub fn read(node: Node<'_, '_>, pose: Pose, reading: &Reading) -> Option<Shape> {
    let geometry = elements(element(node, "geometry")?).next()?;
    let length = |name: &str| {
        let found = number(geometry, name, reading);
        if !geometry.has_attribute(name) {
            let tag = geometry.tag_name().name();
            reading.add(place(geometry), format!("`{tag}` has no `{name}`"), format!("add `{name}=\"…\"`"));
        }
        found
    };
    let solid = match geometry.tag_name().name() {
        "sphere" => Solid::Sphere(length("radius")?),
        "cylinder" => Solid::Cylinder(length("radius")?, length("length")?),
        "capsule" => Solid::Capsule(length("radius")?, length("length")?),
        "box" => Solid::Block(Vector3::from(fixed_numbers::<3>(geometry, "size", reading)?)),
        "mesh" => return read_mesh(geometry, &pose, reading),
        other => {
            reading.omit(format!("shape `{other}`"));
            return None;
        }
    };
    Some(Shape { solid, pose, mesh: None })
}

/// Reads a mesh as the box at its bounds. `None` after counting the mesh as left out.
fn read_mesh(node: Node<'_, '_>, pose: &Pose, reading: &Reading) -> Option<Shape> {
    let Some(name) = node.attribute("filename") else {
        reading.omit("mesh without a file");
        return None;
    };
    let numbers: Vec<f64> =
        node.attribute("scale").unwrap_or("1 1 1").split_whitespace().filter_map(|word| word.parse().ok()).collect();
    let bounds = match numbers[..] {
        [x, y, z] => {
            let frame = MeshFrame { scale: Vector3::new(x, y, z), ..MeshFrame::default() };
            reading.meshes.bounds(&reading.meshes.place_in_packages(name), &frame)
        }
        _ => Err("its `scale` is not three numbers".to_owned()),
    };
    reading.mesh_shape(name, bounds, pose)
}
