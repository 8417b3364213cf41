//! Distance of a coordinate from an angle near which the equations lose digits.

use crate::algebra::{Expr, Function, Node};
use crate::model::Model;

/// Distance of a coordinate from a multiple of 90°. It replaces the coordinate in the equations near that angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SingularDistance {
    /// Index of the replaced coordinate, counted from 0.
    pub coordinate: usize,
    /// Value of the coordinate at which the distance is zero, in quarter turns: 1 for 90°.
    pub quarter_turns: i32,
}

impl SingularDistance {
    /// Value of the coordinate, in degrees, at which the distance is zero.
    #[must_use]
    pub fn degrees(self) -> i64 {
        90 * i64::from(self.quarter_turns)
    }

    /// Name of the distance in the names of equations, such as `q2-90deg`.
    #[must_use]
    pub fn name(&self, model: &Model) -> String {
        self.distance_text(model, "deg")
    }

    /// Title of the distance for a heading, such as `q2-90°`.
    #[must_use]
    pub fn title(&self, model: &Model) -> String {
        self.distance_text(model, "°")
    }

    /// Text of the distance: coordinate, sign and degrees, followed by the text `unit`.
    fn distance_text(self, model: &Model, unit: &str) -> String {
        let sign = if self.quarter_turns < 0 { '+' } else { '-' };
        format!("{}{sign}{}{unit}", model.coordinates[self.coordinate].name, self.degrees().abs())
    }
}

/// Distances that are useful for a model: from +90° for each coordinate whose cosine divides in the kinematic
/// equations. Empty for a model with loops. Its divisors vanish at dead points, which runs pass by other equations.
#[must_use]
pub fn singular_distances(model: &Model) -> Vec<SingularDistance> {
    if !model.loops.is_empty() {
        return Vec::new();
    }
    let arena = &model.arena;
    let is_cosine = |e: &Expr, coordinate: Expr| match arena.node(*e) {
        Node::Apply(Function::Cos, angle) => *angle == coordinate,
        _ => false,
    };
    let divides = |coordinate| model.kinematic_equations.divisors.iter().any(|e| is_cosine(e, coordinate));
    let coordinates = model.coordinates.iter().enumerate().filter(|(_, c)| divides(c.symbol));
    coordinates.map(|(coordinate, _)| SingularDistance { coordinate, quarter_turns: 1 }).collect()
}
