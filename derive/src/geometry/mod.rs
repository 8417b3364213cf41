//! Frames, points and vectors: where things are and how they move, before anything has mass.

mod motion;
mod vector;

pub use motion::{Motion, angular_velocities, linear_velocities};
pub use vector::{Components, Dots, Frames, Part, Vector, apply_tensor, cross_components};

use crate::algebra::Expr;

/// A reference frame, turned from its parent about one of the axes they share.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Its name in the file.
    pub name: String,
    /// Parent, axis (0, 1 or 2) and angle in radians; `None` for the inertial frame.
    pub rotation: Option<(usize, usize, Expr)>,
}

/// A point, placed from another.
#[derive(Clone, Debug)]
pub struct Point {
    /// Its name in the file.
    pub name: String,
    /// Parent point, frame of the components, components; `None` for the origin.
    pub position: Option<(usize, usize, [Expr; 3])>,
}
