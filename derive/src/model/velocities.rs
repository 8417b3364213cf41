//! Velocities and positions that occur by name in formulas. They belong to a point, to the material of a body at a
//! point, or to a rotating frame.

use super::units::Unit;
use crate::algebra::text::parse::{VelocityName, VelocityOf};
use crate::algebra::{Arena, Expr};
use crate::toml_reader::Located;
use std::ops::Range;

/// Component of a velocity or position that occurs by name in formulas. A velocity is relative to the inertial frame,
/// m/s or rad/s; a position is in m.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedVelocity {
    /// Symbol of the component. Its name is the text of the component in formulas, such as `v(disk, P) @ A [1]`.
    pub symbol: Expr,
    /// Object whose velocity or position is taken, by index: a point, the material of a body at a point, or a
    /// rotating frame.
    pub of: VelocityOf<usize>,
    /// Index of the frame along whose axis the component is taken.
    pub frame: usize,
    /// Axis of the component: 0, 1 or 2.
    pub axis: usize,
}

/// Velocity or position component as a formula states it: names with their places in the file.
pub struct StatedVelocity {
    /// Symbol of the component in formulas.
    pub symbol: Expr,
    /// Object whose velocity or position is taken, by name.
    pub of: VelocityOf<Located>,
    /// Name of the frame along whose axis the component is taken.
    pub frame: Located,
    /// Axis of the component: 0, 1 or 2.
    pub axis: usize,
}

impl StatedVelocity {
    /// Creates the velocity or position that the parsed `name` in the text `formula` denotes.
    pub fn new(arena: &mut Arena, formula: &Located, name: &VelocityName<'_>) -> Self {
        let located = |(text, place): &(&str, Range<usize>)| Located {
            text: (*text).to_owned(),
            span: formula.part(place.clone()),
            exact: formula.exact,
        };
        let of = match &name.of {
            VelocityOf::Point(point) => VelocityOf::Point(located(point)),
            VelocityOf::Material(body, point) => VelocityOf::Material(located(body), located(point)),
            VelocityOf::Turning(frame) => VelocityOf::Turning(located(frame)),
            VelocityOf::Place(point) => VelocityOf::Place(located(point)),
        };
        Self { symbol: arena.symbol(&name.text()), of, frame: located(&name.frame), axis: name.axis }
    }

    /// Unit of the velocity or position: m/s, rad/s or m.
    pub fn unit(&self) -> Unit {
        match self.of {
            VelocityOf::Point(_) | VelocityOf::Material(..) => Unit::new(1, 0, -1),
            VelocityOf::Turning(_) => Unit::new(0, 0, -1),
            VelocityOf::Place(_) => Unit::new(1, 0, 0),
        }
    }
}
