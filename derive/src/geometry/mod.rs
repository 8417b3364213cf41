//! Frames, points and vectors: positions and motions, before anything has mass.

mod components;
mod dots;
mod motion;
mod turn;
mod vector;

pub(crate) use components::transposed;
pub use components::{Components, apply_tensor, cross_components};
pub use dots::{Dots, SymmetricDots};
pub use motion::{Motion, angular_velocities, linear_velocities};
pub use turn::{Oriented, Turn, TurnSense};
pub use vector::{Frames, Part, Vector};

use crate::algebra::Expr;

/// A reference frame, turned from its parent frame.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Name of the frame in the model file.
    pub name: String,
    /// Number of the parent frame, and the turn from it; `None` for the inertial frame.
    pub rotation: Option<(usize, Turn)>,
}

/// Position of a point from its parent point.
#[derive(Clone, Copy, Debug)]
pub struct Placement {
    /// Index of the parent point.
    pub parent: usize,
    /// Index of the frame of the components.
    pub frame: usize,
    /// Components of the vector from the parent point to the point, m.
    pub components: [Expr; 3],
}

/// A point, placed from its parent point.
#[derive(Clone, Debug)]
pub struct Point {
    /// Name of the point in the model file.
    pub name: String,
    /// Position of the point from its parent point; `None` for the origin.
    pub position: Option<Placement>,
}
