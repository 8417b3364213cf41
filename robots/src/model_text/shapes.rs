//! Shapes of a model file.

use super::Writer;
use crate::names::Names;
use crate::numbers::{number_text, without_rounding};
use crate::pose::axis_permutation;
use crate::robot::{Omission, Shape, Solid};
use nalgebra::{Matrix3, Vector3};
use tripos_derive::plain_text::{one_line, with_visible_characters};

/// Frame and point of a shape.
struct ShapePlace {
    /// Name for the entry.
    owner: String,
    /// Frame along whose axes the shape is placed.
    frame: String,
    /// Point from which the shape is placed.
    point: String,
    /// Position of the shape's middle from the point, along the axes of the frame, m.
    middle: Vector3<f64>,
    /// Axes of the frame along which the axes of the solid lie.
    axes: [usize; 3],
    /// Direction of the solid's axis 3 along the axes of the frame.
    along: Vector3<f64>,
}

impl Writer<'_> {
    /// Writes the shapes of the ground and of the bodies.
    pub(super) fn write_shapes(&mut self) {
        // Names of shapes are separate from other names.
        let mut used = Names::default();
        for shape in &self.robot.ground_shapes {
            self.write_shape(None, shape, &mut used);
        }
        for (at, body) in self.robot.bodies.iter().enumerate() {
            for shape in &body.shapes {
                self.write_shape(Some(at), shape, &mut used);
            }
        }
    }

    /// Writes a shape; a capsule has three entries.
    fn write_shape(&mut self, body: Option<usize>, shape: &Shape, used: &mut Names) {
        let place = self.shape_place(body, shape);
        let axis = place.axes[2] + 1;
        let sphere = |radius: f64| format!("kind = \"sphere\", radius = {}", length_text(radius));
        let cylinder = |radius: f64, length: f64| {
            let (radius, length) = (length_text(radius), length_text(length));
            format!("kind = \"cylinder\", axis = {axis}, radius = {radius}, length = {length}")
        };
        let mut entries = Vec::new();
        match &shape.solid {
            Solid::Sphere(radius) => entries.push(("", sphere(*radius), place.middle)),
            Solid::Cylinder(radius, length) => entries.push(("", cylinder(*radius, *length), place.middle)),
            Solid::Capsule(radius, length) => {
                let half = place.along * (length / 2.0);
                entries.push(("", cylinder(*radius, *length), place.middle));
                entries.push(("_end1", sphere(*radius), place.middle - half));
                entries.push(("_end2", sphere(*radius), place.middle + half));
            }
            Solid::Block(size) => {
                let mut edges = [0.0; 3];
                for (own, outer) in place.axes.iter().enumerate() {
                    edges[*outer] = size[own];
                }
                let edges = edges.map(length_text).join(", ");
                entries.push(("", format!("kind = \"box\", size = [{edges}]"), place.middle));
            }
            Solid::Ellipsoid(semi_axes) => {
                let text = "form of an ellipsoid: it is drawn as a sphere";
                Omission::add(&mut self.omissions, text);
                entries.push(("", sphere(semi_axes.sum() / 3.0), place.middle));
            }
            Solid::Plane => entries.push(("", format!("kind = \"ground\", axis = {axis}"), place.middle)),
        }
        let comment = shape.mesh.as_ref().map_or_else(String::new, |mesh| {
            format!(" # Bounds of the mesh {}", with_visible_characters(&one_line(mesh)))
        });
        for (suffix, keys, middle) in entries {
            let components = without_rounding([middle.x, middle.y, middle.z], 0.0);
            let position = if components.iter().all(|component| *component == 0.0) {
                String::new()
            } else {
                format!(", position = [{}]", components.map(length_text).join(", "))
            };
            let name = used.reserve(&format!("{}{suffix}", place.owner), &["*"]);
            let (frame, point) = (&place.frame, &place.point);
            self.sections
                .shapes
                .push(format!("{name} = {{ {keys}, frame = \"{frame}\", at = \"{point}\"{position} }}{comment}"));
        }
    }

    /// Frame and place of a shape. A shape that is turned by no multiple of a right angle gets a frame of its own.
    fn shape_place(&mut self, body: Option<usize>, shape: &Shape) -> ShapePlace {
        let owner = body.map_or_else(|| "ground".to_owned(), |at| self.bodies[at].body.clone());
        let (frame, point, pose) = self.on_body(body, &shape.pose);
        let (frame, point) = (frame.to_owned(), point.to_owned());
        let (middle, rotation) = (pose.position, &pose.rotation);
        let is_round = matches!(shape.solid, Solid::Sphere(_) | Solid::Ellipsoid(_));
        let axes = if is_round { Some([0, 1, 2]) } else { axis_permutation(rotation) };
        if let Some(axes) = axes {
            return ShapePlace { owner, frame, point, middle, axes, along: rotation * Vector3::z() };
        }
        let turned = self.names.reserve(&format!("{owner}_shape"), &["*"]);
        let turn = self.turn(&turned, rotation);
        let (frame, rotation) = match turn {
            Some(turn) => {
                self.sections.frames.push(format!("{turned} = {{ from = \"{frame}\", {turn} }}"));
                (turned, *rotation)
            }
            None => (frame, Matrix3::identity()),
        };
        ShapePlace { owner, frame, point, middle: rotation.transpose() * middle, axes: [0, 1, 2], along: Vector3::z() }
    }
}

/// Length as a number with its unit; 0 without.
fn length_text(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("\"{} m\"", number_text(value)) }
}
