//! Solids that represent a mechanism in a picture.

use super::space::{Quaternion, Triple};

/// Solid of a single colour that represents a body, a pin, a spring or the ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// Name of the shape in the model file, or of the body.
    pub label: String,
    /// Index of the body to which the solid belongs, from 0; `None` for a solid of no body. Solids
    /// of a body share a colour.
    pub body: Option<usize>,
    /// Index of the point of contact whose distance determines the solid's radius, if the solid
    /// rolls or slides.
    /// `None` for any other solid, and if the model file states the radius.
    pub touches: Option<usize>,
    /// Shape of the solid, with its place and size.
    pub form: SolidForm,
}

/// Shape, place and size of a drawn solid. Lengths are in m.
#[derive(Clone, Debug, PartialEq)]
pub enum SolidForm {
    /// Ball about a point, fixed in a frame so that its rotation can be seen.
    Sphere {
        /// Place of the sphere's centre and of the axes that turn with it.
        at: SolidPlace,
        /// Radius of the sphere, m.
        radius: f64,
    },
    /// Cylinder (or disk) about axis 3 of its place.
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
    /// Rod from one point to another; it follows them if their distance changes.
    Rod {
        /// Indices of the two points that the rod joins.
        ends: [usize; 2],
        /// Radius of the rod, m.
        radius: f64,
    },
    /// Coil spring from one point to another, as long as their distance.
    Spring {
        /// Indices of the two points that the spring joins.
        ends: [usize; 2],
    },
    /// Unbounded plane, perpendicular to axis 3 of its place.
    Ground {
        /// Place of a point of the plane, with its axes.
        at: SolidPlace,
    },
}

/// Position and attitude of a solid, fixed in a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidPlace {
    /// Index of the frame in which the solid is fixed.
    pub frame: usize,
    /// Index of the point from which the centre of the solid is measured.
    pub point: usize,
    /// Position of the solid's centre from the point, in the frame, m.
    pub position: Triple,
    /// Rotation of the solid's axes from the axes of the frame, as Euler parameters.
    pub turned: Quaternion,
}

impl Solid {
    /// True if the solid is a pin: a sphere that belongs to no body and joins other solids.
    pub(in crate::pictures) fn is_pin(&self) -> bool {
        self.body.is_none() && matches!(self.form, SolidForm::Sphere { .. })
    }
}

impl SolidPlace {
    /// Place with its centre in a point, and its axes along those of a frame.
    #[must_use]
    pub fn at(frame: usize, point: usize) -> Self {
        Self { frame, point, position: [0.0; 3], turned: [1.0, 0.0, 0.0, 0.0] }
    }
}

impl SolidForm {
    /// Indices of the points at which the form is placed or ends.
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

    /// Greatest distance from the centre of the form to its surface, m: for a rod its radius, for a
    /// spring or the ground 0.
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
