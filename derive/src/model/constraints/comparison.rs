//! Comparison of bodies by constraints: finds the bodies that a constraint relates, and tests if it compares their
//! motions.
//!
//! An equation compares two bodies if it stays satisfied while both move together. Then, for each direction, the
//! derivatives with respect to its variables sum to zero, as in `y2 = y1 + h`. A rope over a pulley, `a + b = l`,
//! relates two bodies without comparing them: the pulley supports both.

use crate::algebra::term::calculus::Gradient;
use crate::algebra::text::parse::VelocityOf;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::model::bodies::elements::{AxisMotion, Elements};
use crate::model::contacts::{ComparedBodies, ConstrainedVelocity};
use crate::model::reading::declared_names::NameKind;
use crate::model::reading::loading::Loading;
use crate::model::{Coordinate, NamedVelocity};

/// Variable of a constraint's equation, with the motion that it causes.
struct ComparedVariable {
    /// Symbol of the variable.
    symbol: Expr,
    /// Motion of a body along an axis that the variable alone causes; `None` if it causes any other motion.
    motion: Option<AxisMotion>,
}

impl Loading<'_> {
    /// Finds the bodies that a constraint's equation relates. Named velocities in the equation must not have been
    /// replaced by terms yet.
    pub fn compare_bodies(
        &mut self,
        elements: &Elements,
        coordinates: &[Coordinate],
        velocities: &[NamedVelocity],
        name: &str,
        equation: Expr,
    ) -> ComparedBodies {
        let parts = self.arena.reachable(&[equation]);
        let names: Vec<&NamedVelocity> = velocities.iter().filter(|v| parts.contains(&v.symbol)).collect();
        let named: Vec<VelocityOf<usize>> = names.iter().map(|v| v.of.clone()).collect();
        let has_speeds = self.names.symbols_of(&[NameKind::Speed]).iter().any(|speed| parts.contains(speed));
        let moved = self.compared_bodies_in_equation(elements, coordinates, equation);
        let translations = names.iter().filter(|v| !matches!(v.of, VelocityOf::Turning(_)));
        let mut tied: Vec<ComparedVariable> = translations
            .map(|v| ComparedVariable {
                symbol: v.symbol,
                motion: Some(AxisMotion { frame: v.frame, axis: v.axis, distance: Expr::ONE }),
            })
            .collect();
        let mut own = Vec::new();
        // Coordinates are coefficients if the equation also contains several named velocities, or speeds.
        if names.len() <= 1 && !has_speeds {
            for (body, symbol, coordinate) in body_variables(&self.arena, elements, coordinates, equation) {
                own.push(body);
                tied.push(ComparedVariable {
                    symbol,
                    motion: elements.axis_of_coordinate_motion(&mut self.arena, body, coordinate),
                });
            }
            own.sort_unstable();
            own.dedup();
        }
        let may_compare = !names.is_empty() || own.len() == 2;
        let is_difference = may_compare && is_difference(&mut self.arena, &tied, equation);
        let others = self.names.symbols_of(&[NameKind::Rate, NameKind::Speed]);
        let alone = match names.as_slice() {
            [NamedVelocity { of: VelocityOf::Place(_), .. }] => None,
            [only] if !others.iter().any(|symbol| parts.contains(symbol)) => {
                Some(ConstrainedVelocity { of: only.of.clone(), frame: only.frame, axis: only.axis })
            }
            _ => None,
        };
        ComparedBodies { name: name.to_owned(), alone, named, own, moved, is_difference }
    }

    /// Indices of bodies whose own coordinates an equation contains, in the order of the model file. If the equation
    /// contains rates of coordinates, only these rates count.
    pub fn compared_bodies_in_equation(
        &self,
        elements: &Elements,
        coordinates: &[Coordinate],
        equation: Expr,
    ) -> Vec<usize> {
        let own = body_variables(&self.arena, elements, coordinates, equation);
        let mut bodies: Vec<usize> = own.into_iter().map(|(body, ..)| body).collect();
        bodies.sort_unstable();
        bodies.dedup();
        bodies
    }
}

/// Coordinates in an equation that each move a single body, as (body, symbol in the equation, coordinate). If the
/// equation contains rates of coordinates, only these rates count, and the symbols are rates.
fn body_variables(
    arena: &Arena,
    elements: &Elements,
    coordinates: &[Coordinate],
    equation: Expr,
) -> Vec<(usize, Expr, Expr)> {
    let parts = arena.reachable(&[equation]);
    let moves = coordinates.iter().any(|c| parts.contains(&c.rate));
    let tied = coordinates.iter().map(|c| (if moves { c.rate } else { c.symbol }, c.symbol));
    let tied = tied.filter(|(symbol, _)| parts.contains(symbol));
    tied.filter_map(|(symbol, coordinate)| {
        Some((elements.body_moved_by_coordinate(arena, coordinate)?, symbol, coordinate))
    })
    .collect()
}

/// True if an equation compares bodies: it stays satisfied while all bodies that it relates move together, along each
/// direction. False if it does not, or if a direction is unknown.
fn is_difference(arena: &mut Arena, tied: &[ComparedVariable], equation: Expr) -> bool {
    let Some(motions) = tied.iter().map(|one| one.motion).collect::<Option<Vec<_>>>() else { return false };
    let symbols: Vec<Expr> = tied.iter().map(|one| one.symbol).collect();
    let slopes = Gradient::new(&symbols).apply(arena, equation);
    let stays = |along: &AxisMotion| {
        let is_along = |motion: &AxisMotion| (motion.frame, motion.axis) == (along.frame, along.axis);
        let moved = slopes.iter().filter(|(at, _)| is_along(&motions[*at]));
        let moved: Vec<(Expr, Expr)> = moved.map(|(at, slope)| (*slope, motions[*at].distance)).collect();
        let terms: Option<Vec<Expr>> = moved.into_iter().map(|(slope, way)| arena.div(slope, way)).collect();
        let sum = terms.map(|terms| arena.sum(&terms));
        sum.is_some_and(|sum| zero_test(arena, sum) == ZeroTest::Zero)
    };
    !motions.is_empty() && motions.iter().all(stays)
}
