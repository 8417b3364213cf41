//! Rotations of frames as model files state them: by axes and angles, or by Euler parameters.

use super::configuration_constraints::StatedConstraint;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Expr, Function};
use crate::diagnostic::shortened_for_message;
use crate::geometry::{Frame, Turn};
use crate::model::bodies::joints::Joint;
use crate::model::reading::declared_names::{AllowedQuantities, CONFIGURATION, NameKind, PARAMETERS};
use crate::model::reading::loading::Loading;
use crate::model::units::Unit;
use crate::toml_reader::Located;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

impl<'a> Loading<'a> {
    /// Reads successive rotations, such as `{ sequence = "13", angles = ["pi/2", "a"] }`. `None` after
    /// an error is reported.
    pub fn turns(&mut self, entry: &'a DeTable<'a>, what: &str, span: &Range<usize>) -> Option<Vec<Turn>> {
        let sequence = self.reader.required(entry, "sequence", what, span)?;
        let axes = self.turn_sequence(sequence, None)?;
        let angles = self.reader.required(entry, "angles", what, span)?;
        let DeValue::Array(list) = angles.get_ref() else {
            self.reader.error(angles.span(), "`angles` must be an array", "write an angle for each turn");
            return None;
        };
        if list.len() != axes.len() {
            let message = format!("{} turns have {} angles", axes.len(), list.len());
            self.reader.error(angles.span(), message, "write an angle for each digit of `sequence`");
            return None;
        }
        let mut turns = Vec::new();
        for (axis, angle) in axes.into_iter().zip(list.iter()) {
            let angle = self.reader.formula(angle, "an angle")?;
            turns.push(Turn::About(axis, self.quantity(&angle, CONFIGURATION, &Unit::default(), "an angle")?));
        }
        Some(turns)
    }

    /// Reads the successive rotations that lead to a frame. Rotations about space-fixed axes are returned in reverse
    /// order. `None` after an error is reported.
    pub fn frame_turns(&mut self, entry: &'a DeTable<'a>, what: &str, span: &Range<usize>) -> Option<Vec<Turn>> {
        let mut turns = self.turns(entry, what, span)?;
        match self.reader.get(entry, "fixed") {
            None => {}
            Some(value) => {
                let fixed = self.reader.string(value, "`fixed`")?;
                match fixed.text.as_str() {
                    "body" => {}
                    "space" => turns.reverse(),
                    other => {
                        let message =
                            format!("turns are fixed in body or space, not in `{}`", shortened_for_message(other));
                        self.reader.error(fixed.span, message, "write fixed = \"space\", or leave it out");
                        return None;
                    }
                }
            }
        }
        Some(turns)
    }

    /// Reads the rotations under a key of a joint, such as `turned`; `None` after an error is reported.
    pub fn turns_under_key(
        &mut self,
        joint: &Joint<'a>,
        key: &str,
        value: &'a toml::Spanned<DeValue<'a>>,
    ) -> Option<Vec<Turn>> {
        let what = format!("`{key}` of {}", joint.what);
        let table = self.reader.table(value, &what, "{ sequence = \"13\", angles = [\"pi/2\", \"a\"] }")?;
        self.reader.report_unknown_keys(table, &what, &["sequence", "angles"]);
        self.turns(table, &what, &value.span())
    }

    /// Reads a vector. Returns the rotation that takes axis 3 to the vector's direction, and the inverse of this
    /// rotation. `None` after an error is reported.
    pub fn turn_towards_vector(&mut self, value: &'a Spanned<DeValue<'a>>, what: &str) -> Option<[Turn; 2]> {
        let components = self.turn_numbers(value, what, PARAMETERS)?;
        let squares = components.map(|e| self.arena.square(e));
        let square = self.arena.sum(&squares);
        let square = Simplifier::default().simplify(&mut self.arena, square);
        if zero_test(&self.arena, square) != ZeroTest::NonZero {
            self.reader.error(value.span(), format!("{what} has no direction"), "write axis = [1, 0, 1], or axis = 3");
            return None;
        }
        let length = self.arena.apply(Function::Sqrt, square);
        let unit = components.map(|e| self.arena.div(e, length).expect("it is not zero"));
        Some(Turn::shortest_turn_to(&mut self.arena, 2, &unit))
    }

    /// Reads a rotation by an angle about a vector, as three successive rotations. `None` after an error is reported.
    pub fn turns_about(
        &mut self,
        axis: &'a Spanned<DeValue<'a>>,
        entry: &'a DeTable<'a>,
        what: &str,
        span: &Range<usize>,
    ) -> Option<Vec<Turn>> {
        let way = self.turn_towards_vector(axis, &format!("the axis of {what}"));
        let angle = self.turn_angle(entry, what, span)?;
        let [there, back] = way?;
        Some(vec![there, Turn::About(2, angle), back])
    }

    /// Reads the rotation angle of a frame under the key `angle`, rad; `None` after an error is reported.
    pub fn turn_angle(&mut self, entry: &'a DeTable<'a>, what: &str, span: &Range<usize>) -> Option<Expr> {
        let angle = self.reader.required(entry, "angle", what, span)?;
        let angle = self.reader.formula(angle, "an angle")?;
        self.quantity(&angle, CONFIGURATION, &Unit::default(), "an angle")
    }

    /// Reads an array of N formulas without units; `None` after an error is reported.
    fn turn_numbers<const N: usize>(
        &mut self,
        value: &'a Spanned<DeValue<'a>>,
        what: &str,
        allowed: AllowedQuantities,
    ) -> Option<[Expr; N]> {
        let list = value.get_ref().as_array().filter(|list| list.len() == N);
        let Some(list) = list else {
            self.reader.error(value.span(), format!("{what} must be an array of {N}"), "write one formula for each");
            return None;
        };
        let mut values = Vec::new();
        for item in list {
            let formula = self.reader.formula(item, what)?;
            values.push(self.quantity(&formula, allowed, &Unit::default(), what)?);
        }
        values.try_into().ok()
    }

    /// Reads four Euler parameters and returns their rotation; `None` after an error is reported.
    pub fn euler_parameters(&mut self, value: &'a Spanned<DeValue<'a>>) -> Option<Turn> {
        let what = "`euler_parameters`";
        let parameters: [Expr; 4] = self.turn_numbers(value, what, CONFIGURATION)?;
        let squares = parameters.map(|e| self.arena.square(e));
        let square = self.arena.sum(&squares);
        if zero_test(&self.arena, square) != ZeroTest::NonZero {
            self.reader.error(value.span(), format!("{what} are all 0"), "name four coordinates, the scalar first");
            return None;
        }
        Some(Turn::by_euler_parameters(&mut self.arena, parameters))
    }

    /// Constraints `FRAME_norm`, one for each frame that is rotated by Euler parameters. Each states that the sum of
    /// the four squares is 1.
    pub fn euler_parameter_norms(&mut self, frames: &[Frame]) -> Vec<StatedConstraint> {
        let mut list = Vec::new();
        for frame in frames {
            let Some((_, turn @ Turn::Oriented(oriented))) = &frame.rotation else { continue };
            if oriented.spins.is_empty() {
                continue;
            }
            let squares: Vec<Expr> = turn.quantities().into_iter().map(|e| self.arena.square(e)).collect();
            let length = self.arena.sum(&squares);
            let equation = self.arena.sub(length, Expr::ONE);
            let span = self.names.span(&frame.name).unwrap_or_default();
            let name = Located { text: format!("{}_norm", frame.name), span: span.clone(), exact: false };
            self.names.declare_joint_name(&mut self.reader, &name, NameKind::Constraint);
            list.push(StatedConstraint { name: name.text, equation, enforced_by: None, span, may_repeat: true });
        }
        list
    }
}
