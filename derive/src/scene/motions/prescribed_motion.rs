//! Prescribed motions for inverse dynamics: at one instant, by formulas of t, or by samples.

use crate::algebra::term::calculus::Differential;
use crate::algebra::text::parse::parse;
use crate::algebra::value::interval::constant_with_wide_interval;
use crate::algebra::{Expr, Rational};
use crate::diagnostic::{Diagnostic, Diagnostics, Source, nearest_name_advice};
use crate::model::{Model, StatedUnit, TIME};
use crate::scene::numbers::number_reader::ValueReader;
use crate::scene::numbers::scene_number::{Number, extended_values};
use crate::toml_reader::{Located, TomlReader};
use toml::de::DeTable;
use tripos_traits::DoubleDouble;

/// Largest number of instants at which a prescribed motion is evaluated.
const MOST: usize = 1_000_000;

/// Prescribed motion, with the values of the parameters.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Values of the parameters to 32 digits, in SI units and in the order of the model.
    pub parameters: Vec<DoubleDouble>,
    /// Prescribed motion as the file gives it: samples or formulas.
    pub given: MotionForm,
}

/// Form in which a motion is prescribed: samples or formulas of time.
#[derive(Clone, Debug)]
pub enum MotionForm {
    /// Coordinates, speeds and accelerations at successive instants.
    Samples(Vec<MotionSample>),
    /// Formulas of t for the coordinates.
    Formulas(Formulas),
}

/// Sample of a motion: coordinates, generalized speeds and their rates at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionSample {
    /// Instant of the sample, s; `None` if it is not stated.
    pub t: Option<f64>,
    /// Generalized coordinates in SI units and in the order of the model. Time is included if it is a coordinate of
    /// the model.
    pub q: Vec<DoubleDouble>,
    /// Generalized speeds in SI units, in the order of the model.
    pub u: Vec<DoubleDouble>,
    /// Time derivatives of the generalized speeds in SI units, in the order of the model.
    pub rates: Vec<DoubleDouble>,
}

/// Coordinates as formulas of time, and the instants at which they are evaluated.
#[derive(Clone, Debug)]
pub struct Formulas {
    /// Symbol of time t in the formulas.
    pub time: Expr,
    /// Each coordinate as three terms in parameters and t: its value, first and second time derivative. `None` for a
    /// coordinate that loops determine.
    pub coordinates: Vec<Option<[Expr; 3]>>,
    /// Start values for the search for coordinates that loops determine, in SI units. A value is 0 if the file gives
    /// none.
    pub guesses: Vec<f64>,
    /// Instants at which the motion is evaluated, s, evenly spaced.
    pub instants: Vec<f64>,
}

/// Reads a motion file: `[state]` with `[accelerations]`, or `[motion]` with `[times]`. Formulas that the file gives
/// to inputs replace the inputs in the model.
///
/// # Errors
/// Returns [`Diagnostics`] with every error of the motion file.
pub fn load_motion(source: &Source, model: &mut Model) -> Result<Motion, Diagnostics> {
    let (mut reader, table) = TomlReader::parse(source)?;
    reader.schema(table.get_ref());
    let mut values = ValueReader::new(reader, model);
    let inputs = values.inputs(table.get_ref());
    values.reader.finish()?;
    if inputs.bindings != values.model.bindings {
        *model = model.reread_with_inputs(inputs.bindings, source, inputs.place)?;
    }
    let (reader, table) = TomlReader::parse(source)?;
    let table = table.get_ref();
    let mut values = ValueReader::new(reader, model);
    let keys =
        ["schema", "title", "about", "parameters", "inputs", "state", "accelerations", "motion", "times", "guess"];
    values.reader.report_unknown_keys(table, "a motion", &keys);
    let parameters = values.parameters(table);
    let given = match (&parameters, table.contains_key("state"), table.contains_key("motion")) {
        (None, ..) => None,
        (Some(parameters), true, false) => {
            values.prescribed_state(table, parameters).map(|moving| MotionForm::Samples(vec![moving]))
        }
        (Some(parameters), false, true) => values.motion_formulas(table, parameters).map(MotionForm::Formulas),
        _ => {
            let help = "give [state] with [accelerations] for one instant, or [motion] with [times]";
            values.reader.errors.push(Diagnostic::of_file("the file is no motion", help));
            None
        }
    };
    values.reader.finish()?;
    let parameters = extended_values(&parameters.expect("reported if missing"));
    Ok(Motion { parameters, given: given.expect("reported if missing") })
}

impl<'a> ValueReader<'a, '_> {
    /// Reads `[state]` and `[accelerations]` of a motion file as a single sample; `None` after an error
    /// is reported.
    fn prescribed_state(&mut self, table: &'a DeTable<'a>, parameters: &[Number]) -> Option<MotionSample> {
        let state = self.section(table, "state")?;
        let start = self.state(table, state, parameters);
        let mut rates: Vec<Option<DoubleDouble>> = vec![None; self.model.speeds.len()];
        let names: Vec<String> = self.model.speeds.iter().map(|s| format!("{}'", s.name)).collect();
        for (name, value) in self.section(table, "accelerations").map_or(Vec::new(), |s| self.reader.entries(s)) {
            let Some(at) = names.iter().position(|known| *known == name.text) else {
                let help = nearest_name_advice(&name.text, names.iter().map(String::as_str));
                self.reader.error(name.span, format!("the model has no acceleration `{}`", name.text), help);
                continue;
            };
            let formula = self.reader.formula(value, &format!("`{}`", name.text));
            rates[at] = formula.and_then(|f| self.number(&f, parameters, "an acceleration")).map(|n| n.extended());
        }
        let missing: Vec<&str> =
            names.iter().zip(&rates).filter(|(_, rate)| rate.is_none()).map(|(name, _)| name.as_str()).collect();
        if !missing.is_empty() && self.reader.errors.is_empty() {
            let message = format!("no value for {}", missing.join(", "));
            let advice = "give the rate of every speed in [accelerations]";
            self.section_error(table, "accelerations", message, advice);
        }
        let start = start?;
        let t = self.model.time().map(|at| start.q[at]);
        // If the file states rates, the speeds computed from them are known only in doubles.
        let by_rates = || start.u.iter().map(|x| DoubleDouble::from(*x)).collect();
        let u = if let crate::scene::InitialMotion::Speeds(u) = start.exact.motion { u } else { by_rates() };
        Some(MotionSample { t, q: start.exact.q, u, rates: rates.into_iter().collect::<Option<_>>()? })
    }

    /// Reports an error at a section of a file, or about the file as a whole if it does not have the section.
    fn section_error(&mut self, table: &'a DeTable<'a>, section: &str, message: String, advice: &str) {
        let place = self.reader.get(table, section).map(toml::Spanned::span);
        self.reader.errors.push(match place {
            Some(place) => Diagnostic::new(place, message, advice),
            None => Diagnostic::of_file(message, advice),
        });
    }

    /// Reads `[motion]`, `[times]` and `[guess]` of a motion file; `None` after an error is reported.
    fn motion_formulas(&mut self, table: &'a DeTable<'a>, parameters: &[Number]) -> Option<Formulas> {
        let time = self.model.arena.symbol(TIME);
        let mut formulas: Vec<Option<Expr>> = vec![None; self.model.coordinates.len()];
        let section = self.section(table, "motion")?;
        for (name, value) in self.reader.entries(section) {
            let Some(at) = self.prescribed_coordinate(&name) else { continue };
            if let Some(formula) = self.reader.formula(value, &format!("`{}`", name.text)) {
                formulas[at] = self.formula_of_time(&formula, time);
            }
        }
        if let Some(at) = self.model.time() {
            formulas[at] = Some(time);
        }
        let mut guesses = vec![0.0; formulas.len()];
        for (name, value) in self.section(table, "guess").map_or(Vec::new(), |s| self.reader.entries(s)) {
            let Some(at) = self.prescribed_coordinate(&name) else { continue };
            let formula = self.reader.formula(value, &format!("`{}`", name.text));
            guesses[at] = formula.and_then(|f| self.number(&f, parameters, "a guess"))?.double;
        }
        let open = self.model.coordinates.iter().zip(&formulas).filter(|(_, formula)| formula.is_none());
        let open: Vec<String> = open.map(|(c, _)| c.name.clone()).collect();
        if !open.is_empty() && self.model.loops.is_empty() && self.reader.errors.is_empty() {
            let message = format!("no formula for {}", open.join(", "));
            let help = "give every coordinate in [motion]: no loop determines one";
            self.section_error(table, "motion", message, help);
        }
        let instants = self.prescribed_instants(table, parameters)?;
        let mut d_dt = Differential::partial(time);
        let arena = &mut self.model.arena;
        let coordinates = formulas.into_iter().map(|formula| {
            let first = d_dt.apply(arena, formula?);
            Some([formula?, first, d_dt.apply(arena, first)])
        });
        Some(Formulas { time, coordinates: coordinates.collect(), guesses, instants })
    }

    /// Index of the coordinate with the given name; `None` after reporting an unknown name or time.
    fn prescribed_coordinate(&mut self, name: &Located) -> Option<usize> {
        let model = &self.model;
        let at = model.coordinates.iter().position(|c| c.name == name.text && c.name != TIME);
        if at.is_none() {
            let known = model.coordinates.iter().map(|c| c.name.as_str()).filter(|known| *known != TIME);
            let help = nearest_name_advice(&name.text, known);
            self.reader.error(name.span.clone(), format!("the model has no coordinate `{}`", name.text), help);
        }
        at
    }

    /// Reads a formula in parameters and time t; `None` after an error is reported.
    fn formula_of_time(&mut self, formula: &Located, time: Expr) -> Option<Expr> {
        let model = &mut *self.model;
        let own = model.parameters.iter().filter(|p| !p.is_input).map(|p| (p.name.clone(), p.symbol));
        let known: Vec<(String, Expr)> = own.chain([(TIME.to_owned(), time)]).collect();
        let stated = StatedUnit::of(&formula.text);
        let number = stated.as_ref().map_or_else(|| formula.clone(), |stated| stated.number_before_unit(formula));
        let parsed = parse(&mut model.arena, &number.text, &mut |arena, name| {
            if name == "deg" {
                let pi = arena.pi();
                return Ok(arena.scale(pi, &Rational::fraction(1, 180).expect("not zero")));
            }
            let found = known.iter().find(|(known, _)| known == name).map(|(_, symbol)| *symbol);
            let names = known.iter().map(|(known, _)| known.as_str()).chain(["deg", "pi"]);
            found.ok_or_else(|| (format!("`{name}` cannot stand in a motion"), Some(nearest_name_advice(name, names))))
        });
        match parsed {
            Ok(e) => {
                let e = stated.map_or(e, |stated| stated.apply(&mut model.arena, e));
                if let Some(lost) = constant_with_wide_interval(&model.arena, e) {
                    self.reader.report_lost_constant(&model.arena, formula, lost);
                    return None;
                }
                Some(e)
            }
            Err(error) => {
                self.reader.error(formula.part(error.span), error.message, error.help.unwrap_or_default());
                None
            }
        }
    }

    /// Reads `[times]`: evenly spaced instants, s, both ends included. `None` after an error is
    /// reported.
    fn prescribed_instants(&mut self, table: &'a DeTable<'a>, parameters: &[Number]) -> Option<Vec<f64>> {
        let example = "add [times] with from = 0, to = 2, count = 101";
        let Some(section) = self.section(table, "times") else {
            if self.reader.errors.is_empty() {
                self.reader.errors.push(Diagnostic::of_file("the motion has no `times`", example));
            }
            return None;
        };
        self.reader.report_unknown_keys(section, "`times`", &["from", "to", "count"]);
        let place = self.reader.entries(section).first().map_or(0..0, |(key, _)| key.span.clone());
        let mut number = |key: &str| {
            let value = self.reader.required(section, key, "`times`", &place)?;
            let formula = self.reader.formula(value, &format!("`{key}`"))?;
            Some(self.number(&formula, parameters, "an instant")?.double)
        };
        let (from, to, count) = (number("from"), number("to"), number("count"));
        let (from, to, count) = (from?, to?, count?);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the range, and whole")]
        let whole = (count.fract() == 0.0 && count >= 1.0 && count <= MOST as f64).then_some(count as usize);
        let Some(whole) = whole else {
            self.reader.error(place, format!("`count` is {count}"), format!("give a whole number from 1 to {MOST}"));
            return None;
        };
        let share = |k: usize| if whole == 1 { 0.0 } else { k as f64 / (whole - 1) as f64 };
        Some((0..whole).map(|k| from + (to - from) * share(k)).collect())
    }
}
