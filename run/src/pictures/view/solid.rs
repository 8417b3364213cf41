//! Solids that represent a mechanism in a picture.

use super::space::{Quaternion, Triple};

/// Solid of one colour that represents a body, a pin, a spring or the ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// Name of the solid: the name of its shape in the model file, or of its body, point or force.
    pub label: String,
    /// Index of the body to which the solid belongs, from 0; `None` if it belongs to no body. All solids of a
    /// body have the same colour.
    pub body: Option<usize>,
    /// Index of the point of contact, if the solid rolls or slides. The distance of this point gives the radius
    /// of the solid. `None` for any other solid, or if the model file states the radius.
    pub touches: Option<usize>,
    /// Shape of the solid, with its place and size.
    pub form: SolidForm,
}

/// Shape, place and size of a drawn solid. Lengths are in m.
#[derive(Clone, Debug, PartialEq)]
pub enum SolidForm {
    /// Ball about a point, fixed in a frame, so that its rotation can be shown.
    Sphere {
        /// Place of the centre of the sphere, and of the axes that rotate with it.
        at: SolidPlace,
        /// Radius of the sphere, m.
        radius: f64,
    },
    /// Cylinder or disk about axis 3 of its place.
    Cylinder {
        /// Place of the cylinder's centre and axes.
        at: SolidPlace,
        /// Radius of the cylinder, m.
        radius: f64,
        /// Length of the cylinder along its axis, m.
        length: f64,
    },
    /// Rectangular box along the axes of its place.
    Box {
        /// Place of the box's centre and axes.
        at: SolidPlace,
        /// Lengths of the box's edges along the three axes, m.
        size: Triple,
    },
    /// Rod from one point to another. It follows the points if their distance changes.
    Rod {
        /// Indices of the two points that the rod joins.
        ends: [usize; 2],
        /// Radius of the rod, m.
        radius: f64,
    },
    /// Coil spring from one point to another. Its length is the distance of the points.
    Spring {
        /// Indices of the two points that the spring joins.
        ends: [usize; 2],
    },
    /// Unlimited plane, perpendicular to axis 3 of its place.
    Ground {
        /// Place of one point of the plane, with its axes.
        at: SolidPlace,
    },
}

/// Position and orientation of a solid that is fixed in a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidPlace {
    /// Index of the frame in which the solid is fixed.
    pub frame: usize,
    /// Index of the point from which the centre of the solid is measured.
    pub point: usize,
    /// Position of the solid's centre from the point, in the frame, m.
    pub position: Triple,
    /// Rotation from the axes of the frame to the axes of the solid, as Euler parameters.
    pub turned: Quaternion,
}

impl Solid {
    /// True if the solid is a pin: a sphere that belongs to no body and joins other solids.
    pub(in crate::pictures) fn is_pin(&self) -> bool {
        self.body.is_none() && matches!(self.form, SolidForm::Sphere { .. })
    }
}

impl SolidPlace {
    /// Makes a place whose centre is a point, and whose axes are the axes of a frame. Both are given by index.
    #[must_use]
    pub fn at(frame: usize, point: usize) -> Self {
        Self { frame, point, position: [0.0; 3], turned: [1.0, 0.0, 0.0, 0.0] }
    }
}

impl SolidForm {
    /// Indices of the points from which the form is placed, or between which it extends.
    #[must_use]
    pub fn points(&self) -> Vec<usize> {
        match self {
            Self::Sphere { at, .. } | Self::Cylinder { at, .. } | Self::Box { at, .. } | Self::Ground { at } => {
                vec![at.point]
            }
            Self::Rod { ends, .. } | Self::Spring { ends } => ends.to_vec(),
        }
    }

    /// English noun for the form, for use in a sentence.
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

    /// Greatest distance from the centre of the form to its surface, m. For a rod it is the radius. For a spring
    /// or the ground it is 0.
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
