//! What is drawn.

use super::space::{Quaternion, Triple};

/// Something that is drawn, of one colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// What it is called: as the shape in the file, or as the body.
    pub label: String,
    /// Solids of one group have one colour: the body, the bodies counted from 0; nothing of what belongs to none.
    pub body: Option<usize>,
    /// The point at which it rolls or slides, if its radius is how far that is from its middle and not what a file says.
    pub touches: Option<usize>,
    /// What it is like.
    pub form: Form,
}

/// What a solid is like. Lengths are in m.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A ball about a point, fixed in a frame so that its turning is seen.
    Sphere {
        /// Where.
        at: Place,
        /// Its radius.
        radius: f64,
    },
    /// A cylinder about axis 3 of where it is.
    Cylinder {
        /// Where.
        at: Place,
        /// Its radius.
        radius: f64,
        /// Its length along the axis.
        length: f64,
    },
    /// A box along the axes of where it is.
    Box {
        /// Where.
        at: Place,
        /// Its three edges.
        size: Triple,
    },
    /// A rod from one point to another, however these move.
    Rod {
        /// The points.
        ends: [usize; 2],
        /// Its radius.
        radius: f64,
    },
    /// A coil from one point to another, as it is stretched.
    Spring {
        /// The points.
        ends: [usize; 2],
    },
    /// A plane across axis 3 of where it is, without an edge.
    Ground {
        /// Where.
        at: Place,
    },
}

/// Where a solid is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The frame that it is fixed in.
    pub frame: usize,
    /// The point that its middle is told from.
    pub point: usize,
    /// Where its middle is from there, in the frame, m.
    pub position: Triple,
    /// How its axes are turned from those of the frame.
    pub turned: Quaternion,
}

impl Place {
    /// With its middle in a point and along the axes of a frame.
    #[must_use]
    pub fn at(frame: usize, point: usize) -> Self {
        Self { frame, point, position: [0.0; 3], turned: [1.0, 0.0, 0.0, 0.0] }
    }
}

impl Form {
    /// The points that it is at or goes through.
    #[must_use]
    pub fn points(&self) -> Vec<usize> {
        match self {
            Self::Sphere { at, .. } | Self::Cylinder { at, .. } | Self::Box { at, .. } | Self::Ground { at } => {
                vec![at.point]
            }
            Self::Rod { ends, .. } | Self::Spring { ends } => ends.to_vec(),
        }
    }

    /// What it is called in a sentence.
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

    /// How far it reaches from its place at most.
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
