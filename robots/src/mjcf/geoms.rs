//! Geoms of MJCF files: shapes, and the mass and inertia that they give to bodies.

use super::element::{Angles, Element, read_pose};
use super::mesh_assets::MeshAssets;
use crate::pose::{Pose, turn_to};
use crate::robot::{Inertia, Shape, Solid};
use crate::xml::{Reading, place};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::PI;
use tripos_derive::diagnostic::shortened_for_message;

/// Density of a geom that states neither mass nor density, kg/m³ (MuJoCo XML reference, `geom/density`).
const DENSITY: f64 = 1000.0;

/// A geom of a body.
pub struct Geom {
    /// Shape; `None` for a mesh without bounds and a height field.
    pub shape: Option<Shape>,
    /// Mass and inertia in the axes of the body; `None` for a geom without volume.
    pub inertia: Option<Inertia>,
    /// Group of the geom, by which the compiler selects the geoms that give mass.
    pub group: f64,
    /// True for a mesh, whose mass is not known.
    pub is_mesh: bool,
}

/// Reads a geom. `around` is the pose of the frame that contains it, in the axes of the body.
pub fn read(
    element: &Element<'_, '_, '_>,
    around: &Pose,
    angles: &Angles,
    assets: &MeshAssets,
    reading: &Reading,
) -> Geom {
    let group = element.number("group", reading).unwrap_or(0.0);
    let kind = element.text("type").unwrap_or(if element.text("mesh").is_some() { "mesh" } else { "sphere" });
    let shown = shortened_for_message(kind);
    let size = element.numbers("size", reading).unwrap_or_default();
    let mut own = read_pose(element, angles, reading);
    let mut half = None;
    if let Some([a, b, c, d, e, f]) = element.fixed::<6>("fromto", reading) {
        let (from, to) = (Vector3::new(a, b, c), Vector3::new(d, e, f));
        if (to - from).norm() == 0.0 || !matches!(kind, "capsule" | "cylinder" | "box" | "ellipsoid") {
            let advice = "give two different points, for a capsule, a cylinder, a box or an ellipsoid";
            reading.add(element.place_of("fromto"), format!("`fromto` states no {shown}"), advice);
        } else {
            own = Pose { position: (from + to) / 2.0, rotation: turn_to(&(to - from)) };
            half = Some((to - from).norm() / 2.0);
        }
    }
    let pose = around.compose(&own);
    let mesh = element.text("mesh").filter(|_| !matches!(kind, "hfield" | "sdf"));
    if let Some(name) = mesh.filter(|_| kind == "mesh" || size.is_empty()) {
        let bounds = if kind == "mesh" {
            assets.bounds(name, &reading.meshes)
        } else {
            Err(format!("a {kind} that MuJoCo fits to it is not read"))
        };
        return Geom { shape: reading.mesh_shape(name, bounds, &pose), inertia: None, group, is_mesh: true };
    }
    let needed = match (kind, half) {
        ("plane" | "hfield" | "mesh" | "sdf", _) => 0,
        ("sphere", _) | (_, Some(_)) => 1,
        ("capsule" | "cylinder", None) => 2,
        _ => 3,
    };
    if size.len() < needed || size.iter().take(needed).any(|length| *length <= 0.0) {
        let message = format!("the size of this {shown} needs {needed} positive numbers");
        reading.add(element.place_of("size"), message, "give radii and half lengths, m");
        return Geom { shape: None, inertia: None, group, is_mesh: false };
    }
    let solid = match kind {
        "plane" => Solid::Plane,
        "sphere" => Solid::Sphere(size[0]),
        "capsule" => Solid::Capsule(size[0], 2.0 * half.unwrap_or_else(|| size[1])),
        "cylinder" => Solid::Cylinder(size[0], 2.0 * half.unwrap_or_else(|| size[1])),
        "box" | "ellipsoid" => {
            let half_edges = half
                .map_or_else(|| Vector3::new(size[0], size[1], size[2]), |half| Vector3::new(size[0], size[0], half));
            if kind == "box" { Solid::Block(half_edges * 2.0) } else { Solid::Ellipsoid(half_edges) }
        }
        "mesh" | "hfield" | "sdf" => {
            let name = element.text("mesh").or_else(|| element.text("hfield")).unwrap_or("without a name");
            reading.omit(format!("{shown} {name}"));
            return Geom { shape: None, inertia: None, group, is_mesh: kind == "mesh" };
        }
        other => {
            reading.add(place(element.node), format!("there is no geom of the type `{other}`"), "correct the type");
            return Geom { shape: None, inertia: None, group, is_mesh: false };
        }
    };
    let mass = element.number("mass", reading);
    let density = element.number("density", reading).unwrap_or(DENSITY);
    if element.text("shellinertia") == Some("true") {
        reading.omit("shell of a geom: its inertia is that of a solid".to_owned());
    }
    let inertia = unit_inertia(&solid).map(|(volume, moments)| {
        let mass = mass.unwrap_or(density * volume);
        Inertia { mass, centre: Vector3::zeros(), tensor: Matrix3::from_diagonal(&(moments * mass)) }.moved(&pose)
    });
    Geom {
        shape: Some(Shape { solid, pose, mesh: None }),
        inertia: inertia.filter(|inertia| inertia.mass != 0.0),
        group,
        is_mesh: false,
    }
}

/// Volume of a solid, m³, and its principal moments of inertia for a mass of 1, m². `None` for a plane.
fn unit_inertia(solid: &Solid) -> Option<(f64, Vector3<f64>)> {
    Some(match *solid {
        Solid::Sphere(radius) => (4.0 / 3.0 * PI * radius.powi(3), Vector3::repeat(0.4 * radius * radius)),
        Solid::Cylinder(radius, length) => {
            let across = radius * radius / 4.0 + length * length / 12.0;
            (PI * radius * radius * length, Vector3::new(across, across, radius * radius / 2.0))
        }
        Solid::Capsule(radius, length) => {
            let cylinder = PI * radius * radius * length;
            let ends = 4.0 / 3.0 * PI * radius.powi(3);
            let volume = cylinder + ends;
            let (cylinder_part, ends_part) = (cylinder / volume, ends / volume);
            let square = radius * radius;
            let along = cylinder_part * square / 2.0 + ends_part * 0.4 * square;
            let across = cylinder_part * (square / 4.0 + length * length / 12.0)
                + ends_part * (0.4 * square + length * length / 4.0 + 3.0 / 8.0 * length * radius);
            (volume, Vector3::new(across, across, along))
        }
        Solid::Block(edges) => {
            let squares = edges.component_mul(&edges) / 12.0;
            (edges.product(), Vector3::repeat(squares.sum()) - squares)
        }
        Solid::Ellipsoid(semi_axes) => {
            let squares = semi_axes.component_mul(&semi_axes) / 5.0;
            (4.0 / 3.0 * PI * semi_axes.product(), Vector3::repeat(squares.sum()) - squares)
        }
        Solid::Plane => return None,
    })
}
