//! Solids that represent a mechanism in a picture.

use super::space::{Quaternion, Triple};

/// Drawn solid of a single colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// Name of the shape in the model file, or of the body.
    pub label: String,
    /// Index of the body that the solid belongs to, from 0. The solids of a body have one colour. `None` for a solid of
    /// no body.
    pub body: Option<usize>,
    /// Index of the point at which the solid rolls or slides, if the distance of that point determines the solid's
    /// radius. `None` if the model file states the radius.
    pub touches: Option<usize>,
    /// Shape and place of the solid.
    pub form: Form,
}

/// Shape and place of a solid. Lengths are in m.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A ball about a point, fixed in a frame so that its turning can be seen.
    Sphere {
        /// Place of the centre and the axes.
        at: Place,
        /// Radius, m.
        radius: f64,
    },
    /// A cylinder about axis 3 of its place.
    Cylinder {
        /// Place of the centre and the axes.
        at: Place,
        /// Radius, m.
        radius: f64,
        /// Length along the axis, m.
        length: f64,
    },
    /// A box along the axes of its place.
    Box {
        /// Place of the centre and the axes.
        at: Place,
        /// Lengths of the edges along the three axes, m.
        size: Triple,
    },
    /// A rod from one point to another, also if their distance changes.
    Rod {
        /// Indices of the two points.
        ends: [usize; 2],
        /// Radius, m.
        radius: f64,
    },
    /// A coil from one point to another, as long as their distance.
    Spring {
        /// Indices of the two points.
        ends: [usize; 2],
    },
    /// An unbounded plane, perpendicular to axis 3 of its place.
    Ground {
        /// Place of a point of the plane and of its axes.
        at: Place,
    },
}

/// Position and attitude of a solid, fixed in a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Index of the frame in which the solid is fixed.
    pub frame: usize,
    /// Index of the point from which the centre of the solid is measured.
    pub point: usize,
    /// Position of the solid's centre from the point, in the frame, m.
    pub position: Triple,
    /// Rotation of the solid's axes from those of the frame.
    pub turned: Quaternion,
}

impl Place {
    /// Makes a place with its centre in a point and along the axes of a frame.
    #[must_use]
    pub fn at(frame: usize, point: usize) -> Self {
        Self { frame, point, position: [0.0; 3], turned: [1.0, 0.0, 0.0, 0.0] }
    }
}

impl Form {
    /// Indices of the points that the form is placed from or ends in.
    #[must_use]
    pub fn points(&self) -> Vec<usize> {
        match self {
            Self::Sphere { at, .. } | Self::Cylinder { at, .. } | Self::Box { at, .. } | Self::Ground { at } => {
                vec![at.point]
            }
            Self::Rod { ends, .. } | Self::Spring { ends } => ends.to_vec(),
        }
    }

    /// English noun for the form, for a sentence.
    #[must_use]
    pub fn noun(&self) -> &'static str {
        match self {
            Self::Sphere { .. } => "sphere",
            Self::Cylinder { radius, length, .. } if length < radius => "disk",
            Self::Cylinder { radius, length, .. } if *length > 6.0 * radius => "rod",
            Self::Cylinder { .. } => "cylinder",
            Self::Box { .. } => "box",
            Self::Rod { .. } => "rod",
            Self::Spring { .. } => "spring",
            Self::Ground { .. } => "ground",
        }
    }

    /// Greatest distance from the centre of the form to its surface, m. A rod counts by its radius, a spring or the
    /// ground by 0.
    #[must_use]
    pub fn reach(&self) -> f64 {
        match self {
            Self::Sphere { radius, .. } | Self::Rod { radius, .. } => *radius,
            Self::Cylinder { radius, length, .. } => radius.hypot(0.5 * length),
            Self::Box { size, .. } => 0.5 * super::space::length(*size),
            Self::Spring { .. } | Self::Ground { .. } => 0.0,
        }
    }
}
