//! Orthographic projection of a mechanism onto the sheet, and choice of the direction of view.

use super::drawing_elements::DrawingPoint;
use crate::pictures::view::Triple;
use crate::pictures::view::space::{add_scaled_vector, cross, dot, subtract_vectors, unit_vector};

/// Directions of an oblique view, degrees: angle about the vertical from the first horizontal axis, then
/// elevation. In each view, the first axis points to the lower left and the second axis to the right.
const OBLIQUE: [(f64, f64); 6] = [(32.0, 20.0), (50.0, 20.0), (22.0, 20.0), (60.0, 25.0), (40.0, 32.0), (68.0, 18.0)];

/// Orthographic projection of the inertial frame onto the sheet.
#[derive(Clone, Debug)]
pub struct Camera {
    /// Unit vector of the inertial frame that points to the right on the sheet.
    pub right: Triple,
    /// Unit vector of the inertial frame that points up on the sheet.
    pub up: Triple,
    /// Unit vector of the inertial frame from the mechanism to the viewer.
    pub towards: Triple,
    /// Scale of the projection, px on the sheet per metre.
    pub scale: f64,
}

impl Camera {
    /// Makes a camera that looks along the normal of a plane. The component of `up` in the plane points
    /// upwards on the sheet. If `up` is along the normal, another axis points upwards: the second after the
    /// axis closest to the normal. The scale is 1.
    pub fn camera_along_normal(normal: Triple, up: Triple) -> Self {
        let inside = add_scaled_vector(up, -dot(up, normal), normal);
        let largest = (0..3).max_by(|a, b| normal[*a].abs().total_cmp(&normal[*b].abs())).unwrap_or(2);
        let mut other = [0.0; 3];
        other[(largest + 2) % 3] = 1.0;
        let up =
            if dot(inside, inside) > 1e-6 { inside } else { add_scaled_vector(other, -dot(other, normal), normal) };
        let up = unit_vector(up).unwrap_or([0.0, 1.0, 0.0]);
        Self { right: cross(up, normal), up, towards: normal, scale: 1.0 }
    }

    /// Makes an oblique camera from the side and above, the best of six directions. It shows rotations about
    /// the axes `turns` as open as possible, and the vectors `ways` as long as possible. The scale is 1.
    pub fn oblique_camera(up: Triple, turns: &[Triple], ways: &[Triple]) -> Self {
        let all = OBLIQUE.map(|(turn, height)| Self::camera_at_angles(up, turn.to_radians(), height.to_radians()));
        let worth = |camera: &Self| {
            let open = turns.iter().map(|axis| dot(*axis, camera.towards).abs().min(0.5)).fold(0.5, f64::min);
            let seen = |way: &Triple| (1.0 - dot(*way, camera.towards).powi(2)).max(0.0).sqrt().min(0.8);
            let long = ways.iter().filter_map(|way| unit_vector(*way)).map(|way| seen(&way)).fold(0.8, f64::min);
            // The worth is rounded, since its last digits may differ between machines.
            (100.0 * (open + 0.6 * long)).round()
        };
        let mut best = all[0].clone();
        for camera in &all[1..] {
            if worth(camera) > worth(&best) {
                best = camera.clone();
            }
        }
        best
    }

    /// Makes an oblique camera at the angle `turn` about the vertical and the elevation `height`, rad.
    fn camera_at_angles(up: Triple, turn: f64, height: f64) -> Self {
        let axis = (0..3).max_by(|a, b| up[*a].abs().total_cmp(&up[*b].abs())).unwrap_or(2);
        let mut first = [0.0; 3];
        // The horizontal axes are the other two. With `up` as the third axis, they form a right-handed system.
        first[(axis + if up[axis] < 0.0 { 2 } else { 1 }) % 3] = 1.0;
        let first = unit_vector(add_scaled_vector(first, -dot(first, up), up)).unwrap_or([1.0, 0.0, 0.0]);
        let second = cross(up, first);
        let level = add_scaled_vector(first.map(|x| turn.cos() * x), turn.sin(), second);
        let towards = add_scaled_vector(level.map(|x| height.cos() * x), height.sin(), up);
        let right = cross(up, level);
        Self { right, up: cross(towards, right), towards, scale: 1.0 }
    }

    /// Projects a place in the inertial frame, m, to a point on the sheet, px.
    pub fn project_point(&self, place: Triple) -> DrawingPoint {
        [self.scale * dot(self.right, place), -self.scale * dot(self.up, place)]
    }

    /// Coordinate of a place in the inertial frame, m, along the direction to the viewer. It is larger for
    /// closer places.
    pub fn depth(&self, place: Triple) -> f64 {
        dot(self.towards, place)
    }

    /// Projects a unit vector onto the sheet, without scale. Its length is then at most 1.
    pub fn project_direction(&self, direction: Triple) -> DrawingPoint {
        [dot(self.right, direction), -dot(self.up, direction)]
    }

    /// Projects the vector between two places in the inertial frame, m, to a vector on the sheet, px.
    pub fn project_vector(&self, from: Triple, to: Triple) -> DrawingPoint {
        self.project_point(subtract_vectors(to, from))
    }

    /// Converts a length on the sheet, px, to a length of the mechanism, m.
    pub fn metres(&self, px: f64) -> f64 {
        px / self.scale
    }
}
