//! Conversion of quantities and states to the model's coordinates, if the publication gives its names another meaning.

use super::entries::EntryTable;
use super::publication_reader::PublicationReader;
use crate::algebra::Expr;
use crate::diagnostic::Diagnostic;
use crate::mechanics::{Quantity, QuantityKind};
use toml::Spanned;
use toml::de::DeValue;

/// State of a printed program (listing), its derivative, and the matrix that multiplies the derivative; `None` without
/// a matrix.
pub(super) type StateParts = (Vec<Expr>, Vec<Expr>, Option<Vec<Vec<Expr>>>);

impl<'a> PublicationReader<'a, '_> {
    /// Converts a printed value of a quantity in the publication's own coordinates to a quantity and value of the
    /// model. Reports a quantity that does not equal one of the model's quantities up to its sign, and returns `None`.
    pub fn in_own_coordinates(
        &mut self,
        item: &EntryTable<'a>,
        quantity: &Quantity,
        printed: Expr,
    ) -> Option<(Quantity, Expr)> {
        let Some((kind, is_turned)) = self.kind_in_model_coordinates(quantity.kind()) else {
            let span = self.reader.get(item.table, "quantity").map_or_else(|| item.span.clone(), Spanned::span);
            let message = format!("`{quantity}` is of a coordinate that is a sum of the model's");
            let help = "state the formula as an equation of motion, without a quantity, such as q1'' = …";
            self.reader.error(span, message, help);
            return None;
        };
        let printed = if is_turned { self.model.arena.neg(printed) } else { printed };
        Some((Quantity::new(kind, self.model), printed))
    }

    /// Accelerations, with their formulas, of those coordinates and speeds in a list of names that belong to the
    /// publication alone.
    pub(super) fn own_accelerations(&self, names: &'a [Spanned<DeValue<'a>>]) -> Vec<(String, Expr)> {
        let name = |value: &'a Spanned<DeValue<'a>>| match value.get_ref() {
            DeValue::String(name) => {
                Some((name.to_string(), self.words.declared_formula(name).filter(|_| name.ends_with('\''))?))
            }
            _ => None,
        };
        names.iter().filter_map(name).collect()
    }

    /// Reports names of derived quantities whose coordinate or speed has another meaning in the
    /// publication.
    pub fn report_names_in_own_coordinates(&mut self, names: &[(String, Quantity, Expr)]) {
        for (name, quantity, _) in names {
            let own = self.kind_in_model_coordinates(quantity.kind());
            if own.is_none_or(|(kind, is_turned)| is_turned || kind != *quantity.kind()) {
                let message = format!(
                    "`{name}` stands for `{quantity}`, which the publication defines differently from the model"
                );
                let help = "give the coordinate in [coordinates] a name that the model does not have";
                self.reader.errors.push(Diagnostic::of_file(message, help));
            }
        }
    }

    /// Kind of the model's quantity that equals a quantity in the publication's coordinates up to its sign. The second
    /// value is true for the opposite sign. `None` if there is no such quantity.
    fn kind_in_model_coordinates(&mut self, kind: &QuantityKind) -> Option<(QuantityKind, bool)> {
        let q: Vec<String> = self.model.coordinates.iter().map(|c| c.name.clone()).collect();
        let u: Vec<String> = self.model.speeds.iter().map(|s| s.name.clone()).collect();
        Some(match kind.clone() {
            QuantityKind::SecondRate(at) => {
                let (at, turned) = self.coordinate_up_to_sign(&q[at])?;
                (QuantityKind::SecondRate(at), turned)
            }
            QuantityKind::Rate(at) => {
                let (at, turned) = self.coordinate_up_to_sign(&q[at])?;
                (QuantityKind::Rate(at), turned)
            }
            QuantityKind::SpeedRate(at) => {
                let (at, turned) = self.speed_up_to_sign(&u[at])?;
                (QuantityKind::SpeedRate(at), turned)
            }
            QuantityKind::Speed(at) => {
                let (at, turned) = self.speed_up_to_sign(&u[at])?;
                (QuantityKind::Speed(at), turned)
            }
            QuantityKind::MassMatrix(i, j) => {
                let ((i, a), (j, b)) = (self.speed_up_to_sign(&u[i])?, self.speed_up_to_sign(&u[j])?);
                (QuantityKind::MassMatrix(i, j), a != b)
            }
            QuantityKind::LagrangeMatrix(i, j) => {
                let ((i, a), (j, b)) = (self.coordinate_up_to_sign(&q[i])?, self.coordinate_up_to_sign(&q[j])?);
                (QuantityKind::LagrangeMatrix(i, j), a != b)
            }
            QuantityKind::Christoffel(i, j) => {
                let ((i, a), (j, b)) = (self.coordinate_up_to_sign(&q[i])?, self.coordinate_up_to_sign(&q[j])?);
                (QuantityKind::Christoffel(i, j), a != b)
            }
            QuantityKind::MassRate(i, j) => {
                let ((i, a), (j, b)) = (self.coordinate_up_to_sign(&q[i])?, self.coordinate_up_to_sign(&q[j])?);
                (QuantityKind::MassRate(i, j), a != b)
            }
            QuantityKind::Row(row, at) if row.is_of_coordinates() => {
                let (at, turned) = self.coordinate_up_to_sign(&q[at])?;
                (QuantityKind::Row(row, at), turned)
            }
            QuantityKind::Row(row, at) => {
                let (at, turned) = self.speed_up_to_sign(&u[at])?;
                (QuantityKind::Row(row, at), turned)
            }
            QuantityKind::Partial { vector, of, frame, axis, speed: at } => {
                let (at, turned) = self.speed_up_to_sign(&u[at])?;
                (QuantityKind::Partial { vector, of, frame, axis, speed: at }, turned)
            }
            other => (other, false),
        })
    }

    /// Index of the model's coordinate whose rate equals the rate of `name` up to its sign. The second value is true
    /// for the opposite sign. `None` if there is no such coordinate.
    fn coordinate_up_to_sign(&mut self, name: &str) -> Option<(usize, bool)> {
        if !self.words.is_renamed(name) {
            return self.model.coordinates.iter().position(|c| c.name == name).map(|at| (at, false));
        }
        let rate = self.words.declared_formula(&format!("{name}'"))?;
        let list: Vec<Expr> = self.model.coordinates.iter().map(|c| c.rate).collect();
        let arena = &mut self.model.arena;
        let turned = arena.neg(rate);
        position_of_own_coordinate(&list, rate, turned)
    }

    /// Index of the model's speed that equals the speed `name` up to its sign. The second value is true for the
    /// opposite sign. `None` if there is no such speed.
    fn speed_up_to_sign(&mut self, name: &str) -> Option<(usize, bool)> {
        if !self.words.is_renamed(name) {
            return self.model.speeds.iter().position(|s| s.name == name).map(|at| (at, false));
        }
        let value = self.words.declared_formula(name)?;
        let list: Vec<Expr> = self.model.speeds.iter().map(|s| s.symbol).collect();
        let turned = self.model.arena.neg(value);
        position_of_own_coordinate(&list, value, turned)
    }

    /// Converts the state of a printed program (listing), its derivative and its matrix to the model's variables.
    /// Reports a variable that does not equal one of the model's variables up to its sign and zero, and returns `None`.
    pub(super) fn state_in_model_coordinates(
        &mut self,
        names: &[String],
        parts: StateParts,
        item: &EntryTable<'a>,
    ) -> Option<StateParts> {
        let (mut state, mut derivative, mut matrix) = parts;
        let mut turned_moving = Vec::new();
        for (at, name) in names.iter().enumerate() {
            if !self.words.is_renamed(name) {
                continue;
            }
            let stem = name.trim_end_matches('\'');
            let is_speed = self.model.speeds.iter().any(|s| s.name == stem);
            let found = if is_speed { self.speed_up_to_sign(stem) } else { self.coordinate_up_to_sign(stem) };
            let Some((to, turned)) = found else {
                let span = self.reader.get(item.table, "state").map_or_else(|| item.span.clone(), Spanned::span);
                let message = format!("`{name}` is a sum of the model's variables");
                self.reader.error(span, message, "a state has one variable of the model each");
                return None;
            };
            state[at] = if is_speed {
                self.model.speeds[to].symbol
            } else if stem == name {
                self.model.coordinates[to].symbol
            } else {
                self.model.coordinates[to].rate
            };
            if turned {
                turned_moving.push(at);
            }
        }
        // The derivative of a variable changes its sign together with the variable. With a matrix, the column of the
        // variable changes its sign instead.
        let moving: Vec<usize> =
            (0..names.len()).filter(|at| names[*at].ends_with('\'') || self.is_speed(&names[*at])).collect();
        for at in turned_moving {
            let column = moving.iter().position(|k| *k == at);
            match (&mut matrix, column) {
                (Some(matrix), Some(column)) => {
                    for row in matrix.iter_mut() {
                        row[column] = self.model.arena.neg(row[column]);
                    }
                }
                _ => derivative[at] = self.model.arena.neg(derivative[at]),
            }
        }
        Some((state, derivative, matrix))
    }

    /// True if a name belongs to a generalized speed of the model.
    fn is_speed(&self, name: &str) -> bool {
        self.model.speeds.iter().any(|s| s.name == name)
    }
}

/// Index of a value in a list, or of its negative `turned`. The second value is true if the negative was found. `None`
/// if neither is in the list.
fn position_of_own_coordinate(list: &[Expr], value: Expr, turned: Expr) -> Option<(usize, bool)> {
    let of = |e: Expr| list.iter().position(|one| *one == e);
    of(value).map(|at| (at, false)).or_else(|| of(turned).map(|at| (at, true)))
}
