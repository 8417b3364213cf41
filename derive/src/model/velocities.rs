//! Velocities that formulas of loads name: of a point, and of the material of a body that is at a point.

use crate::algebra::parse::VelocityName;
use crate::algebra::{Arena, Expr};
use crate::read::Located;
use std::ops::Range;

/// A component of a velocity in the inertial frame, m/s, that formulas of loads name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedVelocity {
    /// What stands for it in those formulas; its name is that of the quantity, `v(disk, P) @ A [1]`.
    pub symbol: Expr,
    /// The body whose material is meant, as it is at the point now; `None` for the point itself.
    pub body: Option<usize>,
    /// The point.
    pub point: usize,
    /// The frame of the component.
    pub frame: usize,
    /// The axis of the component: 0, 1 or 2.
    pub axis: usize,
}

/// A velocity as a formula names it, by names with their places in the file.
pub struct StatedVelocity {
    pub symbol: Expr,
    pub body: Option<Located>,
    pub point: Located,
    pub frame: Located,
    pub axis: usize,
}

impl StatedVelocity {
    pub fn new(arena: &mut Arena, formula: &Located, name: &VelocityName<'_>) -> Self {
        let located = |(text, place): &(&str, Range<usize>)| Located {
            text: (*text).to_owned(),
            span: formula.part(place.clone()),
            exact: formula.exact,
        };
        Self {
            symbol: arena.symbol(&name.text()),
            body: name.body.as_ref().map(located),
            point: located(&name.point),
            frame: located(&name.frame),
            axis: name.axis,
        }
    }
}
