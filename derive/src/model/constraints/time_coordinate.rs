//! Explicit time: a coordinate `t` whose rate is 1 by a constraint.
//!
//! Only the code that reads files knows that this coordinate is time. Terms that depend on t have a rate proportional
//! to t'. The multiplier of the constraint t' = 1 is the power of the drive, so energy is proved constant only if
//! that power is 0. Source: C. Lanczos, *The Variational Principles of Mechanics*, 4th edition (1970), chapter V, §6.

use crate::algebra::Expr;
use crate::model::bodies::input_signals::input_signal_formulas;
use crate::model::reading::declared_names::{NameKind, TIME};
use crate::model::reading::loading::Loading;
use crate::model::{Coordinate, Model, MotionConstraintKind, Unit};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Sections of a model file whose formulas may contain time.
const TIMED: [&str; 13] = [
    "speeds",
    "joints",
    "expressions",
    "frames",
    "points",
    "forces",
    "torques",
    "springs",
    "friction",
    "potentials",
    "constraints",
    "reactions",
    "domain",
];

/// Key of an entry under which prose stands, not a formula.
const PROSE: &str = "about";

impl<'a> Loading<'a> {
    /// Adds time as the last coordinate, if a formula of the model file or an input formula of a scene contains time.
    pub fn time(&mut self, table: &'a DeTable<'a>, coordinates: &mut Vec<Coordinate>) {
        let sections = TIMED.iter().filter_map(|key| table.get(*key));
        let in_inputs = input_signal_formulas(table, &self.bindings).into_iter().any(formula_names_time);
        if !in_inputs && !sections.into_iter().any(entry_names_time) {
            if coordinates.is_empty() {
                self.names.mark_unread_kinds(&[NameKind::Coordinate, NameKind::Rate]);
            }
            return;
        }
        let (symbol, rate) = (self.arena.symbol(TIME), self.arena.symbol(&format!("{TIME}'")));
        let unit = Unit::new(0, 0, 1);
        for (symbol, kind, unit) in
            [(symbol, NameKind::Coordinate, unit.clone()), (rate, NameKind::Rate, Unit::default())]
        {
            let name = self.arena.symbol_name(symbol).unwrap_or_default().to_owned();
            self.names.insert(&name, kind, 0..0, Some(symbol));
            self.units.insert(symbol, unit);
        }
        let about = "time".to_owned();
        coordinates.push(Coordinate { name: TIME.to_owned(), symbol, rate, second_rate: rate, unit, about });
    }
}

/// True if a formula contains the word `t`, which is the name of time.
fn formula_names_time(formula: &str) -> bool {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    formula.split(|c| !is_part(c)).any(|word| word == TIME)
}

/// True if a formula at any depth of an entry contains time.
fn entry_names_time(value: &Spanned<DeValue<'_>>) -> bool {
    let mut open = vec![value];
    while let Some(value) = open.pop() {
        match value.get_ref() {
            DeValue::String(text) if formula_names_time(text) => return true,
            DeValue::Array(list) => open.extend(list.iter()),
            DeValue::Table(table) => {
                open.extend(table.iter().filter(|(key, _)| key.get_ref() != PROSE).map(|(_, value)| value));
            }
            _ => {}
        }
    }
    false
}

impl Model {
    /// Index of time among the coordinates; `None` if time is not a coordinate, since no formula contains it.
    #[must_use]
    pub fn time(&self) -> Option<usize> {
        self.coordinates.iter().position(|c| c.name == TIME)
    }

    /// True if any constraint restricts the rates of coordinates. The constraint t' = 1 on time does not count.
    #[must_use]
    pub fn ties_rates(&self) -> bool {
        self.motion_constraints.iter().any(|constraint| constraint.kind != MotionConstraintKind::Clock)
    }

    /// True if constraints move the mechanism even if all generalized speeds are zero. This is so if a constraint
    /// prescribes a velocity, or if frames, points or constraints depend on time. The forces of these constraints do
    /// work, so T + V changes by more than the work of loads.
    #[must_use]
    pub fn is_driven(&self) -> bool {
        let states_velocity =
            |c: &crate::model::MotionConstraint| c.kind != MotionConstraintKind::Clock && c.drive != Expr::ZERO;
        if self.motion_constraints.iter().any(states_velocity) {
            return true;
        }
        let Some(time) = self.time().map(|at| &self.coordinates[at]) else { return false };
        let turns = self.frames.iter().filter_map(|f| f.rotation.as_ref()).flat_map(|(_, turn)| turn.terms());
        let places = self.points.iter().filter_map(|p| p.position).flat_map(|placement| placement.components);
        let geometry: Vec<Expr> = turns.chain(places).collect();
        let ties = self.motion_constraints.iter().filter(|c| c.kind != MotionConstraintKind::Clock).map(|c| c.equation);
        self.arena.reachable(&geometry).contains(&time.symbol)
            || self.arena.reachable(&ties.collect::<Vec<_>>()).contains(&time.rate)
    }
}
