//! Closing of loops at a start: solves for the coordinates that close the loops of a mechanism, from guesses.

use super::loops::{FoundPose, Loops};
use super::start::SolvedVariable;
use crate::algebra::value::rational_value::exact_value;
use crate::algebra::{Expr, Rational};
use crate::model::TIME;
use crate::plain_text::with_significant_digits;
use crate::scene::numbers::number_reader::ValueReader;
use crate::scene::numbers::scene_number::{Number, double_values, enclosed_values};
use std::ops::Range;
use toml::de::DeTable;
use tripos_traits::{Ball, DoubleDouble, Scalar};

/// Residual up to which a loop counts as closed if every coordinate is stated, relative to the size of its terms. It
/// is loose, since the numbers in files have few digits.
const STATED: f64 = 1e-9;
impl<'a> ValueReader<'a, '_> {
    /// Reads `[guess]`: guesses for the coordinates that the start does not state. The list has an entry for each
    /// coordinate, `None` if there is no guess for it. `None` as a whole after an error is reported.
    pub(in crate::scene) fn guesses(
        &mut self,
        table: &'a DeTable<'a>,
        parameters: &[Number],
    ) -> Option<Vec<Option<Number>>> {
        let mut guesses = vec![None; self.model.coordinates.len()];
        let Some(section) = self.section(table, "guess") else { return Some(guesses) };
        let place = self.reader.get(table, "guess").map_or(0..0, toml::Spanned::span);
        if self.model.loops.is_empty() && self.model.constraints.is_empty() {
            let message = "the model has no constraint that a coordinate could be solved from";
            self.reader.error(place, message, "state every coordinate in [start]");
            return None;
        }
        for (name, value) in self.reader.entries(section) {
            // A variable that a constraint determines needs no guess. A guess for it is only checked.
            if self.model.constraints.iter().any(|c| c.fixes == name.text) {
                let formula = self.reader.formula(value, &format!("`{}`", name.text))?;
                self.number(&formula, parameters, "a guess")?;
                continue;
            }
            let Some(at) = self.model.coordinates.iter().position(|c| c.name == name.text && c.name != TIME) else {
                let names = self.model.coordinates.iter().map(|c| c.name.as_str());
                let help = crate::diagnostic::nearest_name_advice(&name.text, names);
                self.reader.error(name.span, format!("the model has no coordinate `{}`", name.text), help);
                continue;
            };
            let formula = self.reader.formula(value, &format!("`{}`", name.text))?;
            guesses[at] = Some(self.number(&formula, parameters, "a guess")?);
        }
        Some(guesses)
    }

    /// Solves for the coordinates that are not stated so that all loops close, and sets them in `q`. `held` are
    /// stated values of variables that constraints determine, as (index of the constraint, value).
    ///
    /// Returns the coordinates that were solved for. `None` after reporting loops that stay open or a singular pose.
    pub(in crate::scene) fn close_loops(
        &mut self,
        q: &mut [Option<Number>],
        held: &[(usize, Number)],
        guesses: &[Option<Number>],
        parameters: &[Number],
        place: Range<usize>,
    ) -> Option<Vec<SolvedVariable>> {
        if let Some((name, gap)) = self.model.violated_condition(&double_values(parameters)) {
            let gap = with_significant_digits(gap.abs(), 4);
            let message = format!("at the values of this scene `{name}` is open by {gap} in every pose");
            let help = "give the positions of the loop's joints values with which the loop can be closed";
            self.reader.error(place, message, help);
            return None;
        }
        let free: Vec<usize> = (0..q.len()).filter(|at| q[*at].is_none()).collect();
        // If no coordinate is free, the held variables are checked later, when all values are known.
        let held = if free.is_empty() { &[] } else { held };
        if self.model.loops.is_empty() && held.is_empty() {
            // All loops were solved for coordinates: the others have the values of the assembled pose.
            for (value, assembled) in q.iter_mut().zip(self.model.assembly.iter().flatten()) {
                value.get_or_insert_with(|| Number::from_double_double(DoubleDouble::from_f64(*assembled)));
            }
            return Some(Vec::new());
        }
        let loops = Loops::with_held_variables(self.model, held);
        let p = double_values(parameters);
        let assembled = |at: usize| self.model.assembly.as_ref().map_or(0.0, |pose| pose[at]);
        let value = |at: usize| q[at].as_ref().or(guesses[at].as_ref()).map_or_else(|| assembled(at), |x| x.double);
        let start: Vec<f64> = (0..q.len()).map(value).collect();
        let all: Vec<usize> = (0..q.len()).collect();
        let found = loops.closed_pose_near(&p, &start, if free.is_empty() { &all } else { &free });
        let open_at_start = loops.loop_residuals(&p, &start);
        let is_stated = free.is_empty() && loops.is_closed(&p, &start, &open_at_start, STATED);
        if !found.is_closed || free.is_empty() && !is_stated {
            self.report_failed_loop_closing(&loops, &found, &open_at_start, &free, place);
            return None;
        }
        let turned = loops.turned_joint(&p, if is_stated { &start } else { &found.q });
        if let Some(joint) = turned {
            let message =
                format!("the joint `{joint}` is closed half a turn away from its orientation, by its equations alone");
            let help = "give values in [start] or [guess] that are nearer to its orientation";
            self.reader.error(place, message, help);
            return None;
        }
        if loops.is_singular(&p, &found.q) {
            let message = "the start is a singular pose: the slopes of the loops are dependent there, and several motions may go on from it";
            let shown = |at: &usize| format!("{} = {}", self.model.coordinates[*at].name, found.q[*at]);
            let pose: Vec<String> = all.iter().map(shown).collect();
            self.reader.error(place, message, format!("start beside {}", pose.join(", ")));
            return None;
        }
        if let Some(name) = loops.violated_redundant_loop(&p, &found.q) {
            let message = format!(
                "at the values of this scene `{name}` does not follow from the other constraints, as it does at the default values"
            );
            let help =
                "the mechanism has fewer freedoms there than its equations: make these values the defaults of a model";
            self.reader.error(place, message, help);
            return None;
        }
        // Refines to 32 digits with derivatives in doubles: each step adds about sixteen digits.
        let mut precise: Vec<DoubleDouble> = (0..q.len())
            .map(|at| q[at].as_ref().map_or_else(|| DoubleDouble::from_f64(found.q[at]), Number::extended))
            .collect();
        let moving = if free.is_empty() { &all } else { &free };
        let wide: Vec<DoubleDouble> = parameters.iter().map(Number::extended).collect();
        for _ in 0..3 {
            let open = loops.loop_residuals_extended(&wide, &precise);
            for (row, at) in moving.iter().enumerate() {
                for (column, open) in open.iter().enumerate() {
                    let share = DoubleDouble::from_f64(found.inverse[(row, column)]) * *open;
                    precise[*at] = precise[*at] - share;
                }
            }
        }
        let known = |at: usize| q[at].as_ref().map_or(Ball::point(precise[at]), Number::enclosure);
        let pose: Vec<Ball> = (0..q.len()).map(known).collect();
        let enclosed = self.is_wide.then(|| loops.enclosed_pose(&enclosed_values(parameters), &pose, &free)).flatten();
        if self.is_wide && free.is_empty() && self.is_exactly_closed(parameters, q) {
            return Some(Vec::new());
        }
        for at in moving {
            q[*at] = Some(Number::from_double_double(precise[*at]));
        }
        for (at, ball) in free.iter().zip(enclosed.iter().flatten()) {
            q[*at] = Some(Number::enclosed(*ball));
        }
        let name = |at: &usize| SolvedVariable {
            name: self.model.coordinates[*at].name.clone(),
            value: precise[*at].hi(),
            is_rate: false,
        };
        Some(free.iter().map(name).collect())
    }

    /// True if all loops are closed exactly at rational values of parameters and coordinates.
    fn is_exactly_closed(&self, parameters: &[Number], q: &[Option<Number>]) -> bool {
        let arena = &self.model.arena;
        let symbols = self.model.p().into_iter().chain(self.model.q());
        let values = parameters.iter().map(Some).chain(q.iter().map(Option::as_ref));
        let known = symbols.zip(values).filter_map(|(symbol, value)| Some((symbol, value?.exact.clone()?)));
        let known: Vec<(Expr, Rational)> = known.collect();
        let mut loops = self.model.loops.iter().chain(&self.model.closed);
        loops.all(|c| exact_value(arena, c.equation, &known).is_some_and(|open| open == Rational::ZERO))
    }

    /// Reports that the loops cannot be closed. The message names the loop with the largest residual and the nearest
    /// pose that was found.
    fn report_failed_loop_closing(
        &mut self,
        loops: &Loops,
        found: &FoundPose,
        open_at_start: &[f64],
        free: &[usize],
        place: Range<usize>,
    ) {
        let model = &self.model;
        let worst = |open: &[f64]| {
            let named = loops.names().map(str::to_owned).zip(open.iter().copied());
            named.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).unwrap_or_default()
        };
        let shown = |at: &usize| format!("{} = {}", model.coordinates[*at].name, found.q[*at]);
        let all: Vec<usize> = (0..found.q.len()).collect();
        let nearest: Vec<String> = if free.is_empty() { &all } else { free }.iter().map(shown).collect();
        let (message, help) = if free.is_empty() && found.is_closed {
            let (name, open) = worst(open_at_start);
            let message = format!(
                "the start breaks the constraint `{name}`: its value is {}, not 0",
                with_significant_digits(open, 4)
            );
            let help = format!(
                "leave a coordinate out of [start] for each loop, with a value near it in [guess]; the nearest closed \
                 configuration has {}",
                nearest.join(", ")
            );
            (message, help)
        } else {
            let (name, open) = worst(&found.open);
            let message = format!(
                "no configuration that closes the loops was found: `{name}` stays open by {}",
                with_significant_digits(open, 4)
            );
            (message, format!("the nearest that was found has {}: give other guesses", nearest.join(", ")))
        };
        self.reader.error(place, message, help);
    }
}
