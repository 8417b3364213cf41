//! Geometry of frames, points and vectors: positions, rotations and velocities, before any masses
//! or forces.

mod components;
mod dot_product_sums;
mod frame_transport;
mod frames;
mod motion;
mod rotation;
mod vector;

pub(crate) use components::transposed;
pub use components::{Components, apply_tensor, cross_components};
pub use dot_product_sums::{Dots, SymmetricDots};
pub use frame_transport::{name_transported_components, rotate_and_name_components};
pub use frames::Frames;
pub use motion::{Motion, angular_velocities, linear_velocities};
pub use rotation::{Oriented, Turn, TurnSense};
pub use vector::{Part, Vector};

use crate::algebra::Expr;

/// A reference frame, rotated from its parent frame.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Name of the frame in the model file.
    pub name: String,
    /// Index of the parent frame and the rotation from it; `None` for the inertial frame.
    pub rotation: Option<(usize, Turn)>,
}

/// Position of a point relative to its parent point.
#[derive(Clone, Copy, Debug)]
pub struct Placement {
    /// Index of the parent point in the model's list of points.
    pub parent: usize,
    /// Index of the frame in which `components` are given.
    pub frame: usize,
    /// Components, in `frame`, of the vector from the parent point to this point, m.
    pub components: [Expr; 3],
}

/// A point of the model, placed relative to its parent point.
#[derive(Clone, Debug)]
pub struct Point {
    /// Name of the point in the model file.
    pub name: String,
    /// Position relative to the parent point; `None` for the origin, which is fixed in the inertial
    /// frame.
    pub position: Option<Placement>,
}
