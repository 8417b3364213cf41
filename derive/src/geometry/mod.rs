//! Frames, points and vectors: where things are and how they move, before anything has mass.

mod components;
mod motion;
mod turn;
mod vector;

pub(crate) use components::transposed;
pub use components::{Components, apply_tensor, cross_components};
pub use motion::{Motion, angular_velocities, linear_velocities};
pub use turn::{Oriented, Turn};
pub use vector::{Dots, Frames, Part, Vector};

use crate::algebra::Expr;

/// A reference frame, turned from its parent.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Its name in the file.
    pub name: String,
    /// Parent, and how it is turned from there; `None` for the inertial frame.
    pub rotation: Option<(usize, Turn)>,
}

/// A point, placed from another.
#[derive(Clone, Debug)]
pub struct Point {
    /// Its name in the file.
    pub name: String,
    /// Parent point, frame of the components, components; `None` for the origin.
    pub position: Option<(usize, usize, [Expr; 3])>,
}
