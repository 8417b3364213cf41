//! States in scene and state files: all coordinates and speeds of a model at one instant, checked
//! against the constraints.

use super::rates::StatedMotion;
use super::start::{EnclosedStart, ExactStart, InitialMotion, SolvedVariable};
use crate::algebra::value::tape::Tape;
use crate::algebra::{Expr, Rational};
use crate::diagnostic::{Diagnostic, Diagnostics, Source};
use crate::model::{Model, TIME, Unit};
use crate::plain_text::with_significant_digits;
use crate::scene::numbers::number_reader::{ValueReader, VariedNumber};
use crate::scene::numbers::scene_number::{Number, double_values, enclosed_values, extended_values};
use crate::scene::settings::inputs::bind_inputs;
use crate::toml_reader::{Located, TomlReader};
use std::ops::Range;
use toml::de::DeTable;
use tripos_traits::Ball;

/// State of a mechanism at one instant: in doubles, and as the file states it.
#[derive(Clone, Debug, Default)]
pub struct Start {
    /// Values of the coordinates in SI units, in the order of the model.
    pub q: Vec<f64>,
    /// Values of the generalized speeds in SI units, in the order of the model.
    pub u: Vec<f64>,
    /// Parameters and state to 32 digits, as the file states them.
    pub exact: ExactStart,
    /// Parameters and state as balls that contain the numbers of the file.
    pub enclosed: EnclosedStart,
    /// Coordinates and rates that the file does not state, so that they were solved for.
    pub closed: Vec<SolvedVariable>,
}

/// State of a mechanism at one instant: parameters, coordinates and generalized speeds.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Values of the parameters in SI units, in the order of the model.
    pub parameters: Vec<f64>,
    /// Values of the generalized coordinates in SI units, in the order of the model.
    pub q: Vec<f64>,
    /// Values of the generalized speeds in SI units, in the order of the model.
    pub u: Vec<f64>,
}

impl State {
    /// Warnings about angles of the state that were probably meant in degrees, one line each. These
    /// angles exceed one turn and have few decimals.
    #[must_use]
    pub fn hints(&self, model: &Model) -> Vec<String> {
        let turned = model.coordinates.iter().zip(&self.q).filter(|(c, q)| c.looks_like_degrees(**q));
        turned.map(|(c, q)| format!("`{}` is {q} rad: if degrees are meant, write \"{q}*deg\"", c.name)).collect()
    }
}

/// Reads a state file: `[state]`, and `[parameters]` if values differ from the model's defaults. Formulas that the
/// file gives to inputs replace the inputs in the model.
///
/// # Errors
/// Returns [`Diagnostics`] with every error of the state file.
pub fn load_state(source: &Source, model: &mut Model) -> Result<State, Diagnostics> {
    bind_inputs(source, model)?;
    let (reader, table) = TomlReader::parse(source)?;
    let table = table.get_ref();
    let mut values = ValueReader::new(reader, model);
    values.state_file(table, &[]);
    let parameters = values.parameters(table);
    let state = values.section(table, "state");
    if state.is_none() {
        let help = "add [state] with every coordinate and every speed or every q'";
        values.reader.errors.push(Diagnostic::of_file("the file has no `state`", help));
    }
    let state = state.and_then(|state| values.state(table, state, parameters.as_deref()?));
    values.reader.finish()?;
    let Start { q, u, .. } = state.expect("reported if missing");
    Ok(State { parameters: double_values(&parameters.expect("reported if missing")), q, u })
}

/// Stated value of a variable that a constraint of the model determines.
struct ConstrainedValue {
    /// Index of the constraint that determines the variable.
    constraint: usize,
    /// Stated value, in SI units.
    number: Number,
    /// Byte range of the value in the file.
    span: Range<usize>,
}

/// Numbers of stated values and of stated rates, for variables that constraints determine.
#[derive(Clone, Copy)]
struct ConstrainedCounts {
    /// Number of stated values of variables that constraints determine.
    held: usize,
    /// Number of stated rates of variables that constraints determine.
    fixed: usize,
}

/// Residual up to which a stated value satisfies its constraint, relative to one plus the size of
/// the value.
const RESIDUAL: f64 = 1e-9;

/// Stated numbers in a list, as (index, ball that contains the value). Entries without a number are left out.
fn state_entries_by_index(list: &[Option<(Number, Located)>]) -> Vec<(usize, Ball)> {
    let stated = list.iter().enumerate().filter_map(|(at, stated)| Some((at, stated.as_ref()?.0.enclosure())));
    stated.collect()
}

/// Name of a coordinate's rate in scene and state files, such as `q1'`. `at` is the index of the coordinate.
fn state_rate_name(model: &Model, at: usize) -> String {
    format!("{}'", model.coordinates[at].name)
}

impl<'a> ValueReader<'a, '_> {
    /// Reads a state: every coordinate, and every speed or every rate q̇. `None` after an error is reported.
    ///
    /// The file may leave out coordinates that loops determine, or that follow from stated values of variables that
    /// constraints determine. Guesses for these coordinates are under the key `guess` of `file`. The file may also
    /// leave out rates that follow from the other rates.
    pub fn state(&mut self, file: &'a DeTable<'a>, table: &'a DeTable<'a>, parameters: &[Number]) -> Option<Start> {
        let before = self.reader.errors.len();
        let (n, p) = (self.model.coordinates.len(), self.model.speeds.len());
        let (mut q, mut rates, mut u) = (vec![None; n], vec![None; n], vec![None; p]);
        let (mut constrained, mut fixed) = (Vec::new(), Vec::new());
        for (name, value) in self.reader.entries(table) {
            let Some(formula) = self.reader.formula(value, &format!("`{}`", name.text)) else { continue };
            let Some(number) = self.number(&formula, parameters, "a value at the start") else { continue };
            if let Some(unit) = self.unit_in_state(&name.text) {
                self.check_unit(&formula, &unit, &name.text);
            }
            let model = &self.model;
            let rate = name.text.strip_suffix('\'');
            if let Some(at) = model.coordinates.iter().position(|c| c.name == name.text) {
                q[at] = Some(number);
            } else if let Some(at) = rate.and_then(|r| model.coordinates.iter().position(|c| c.name == r)) {
                rates[at] = Some((number, name));
            } else if let Some(at) = model.speeds.iter().position(|s| s.name == name.text) {
                u[at] = Some((number, name));
            } else if let Some(at) = model.constraints.iter().position(|c| c.fixes == name.text) {
                constrained.push(ConstrainedValue { constraint: at, number, span: formula.span });
            } else if let Some(at) = rate.and_then(|r| model.constraints.iter().position(|c| c.fixes == r)) {
                fixed.push((at, number, name));
            } else {
                let rates: Vec<String> = model.coordinates.iter().map(|c| format!("{}'", c.name)).collect();
                let known = model.coordinates.iter().map(|c| c.name.as_str());
                let known =
                    known.chain(rates.iter().map(String::as_str)).chain(model.speeds.iter().map(|s| s.name.as_str()));
                let (message, help) = model.unknown_state_name(&name.text, known);
                self.reader.error(name.span, message, help);
            }
        }
        if self.reader.errors.len() > before {
            return None;
        }
        for (place, number) in self.given {
            match *place {
                VariedNumber::Parameter(_) => {}
                VariedNumber::Coordinate(at) => q[at] = Some(number.clone()),
                VariedNumber::Rate(at) => {
                    let name = Located { text: state_rate_name(self.model, at), span: 0..0, exact: false };
                    rates[at] = Some((number.clone(), name));
                }
                VariedNumber::Speed(at) => u[at].iter_mut().for_each(|(stated, _)| *stated = number.clone()),
            }
        }
        let guesses = self.guesses(file, parameters)?;
        let place = self.reader.entries(table).first().map_or(0..0, |(key, _)| key.span.clone());
        let doubly = guesses.iter().zip(&q).position(|(guess, q)| guess.is_some() && q.is_some());
        if let Some(at) = doubly {
            let message = format!("`{}` is stated and guessed", self.model.coordinates[at].name);
            self.reader.error(place, message, "leave it out of [guess], or out of [start] if the loops determine it");
            return None;
        }
        self.set_time_of_state(&mut q, &mut rates, &place)?;
        let held: Vec<(usize, Number)> = constrained.iter().map(|c| (c.constraint, c.number.clone())).collect();
        self.report_missing_values(table, &q, &rates, &u, ConstrainedCounts { held: held.len(), fixed: fixed.len() })?;
        let mut closed = self.close_loops(&mut q, &held, &guesses, parameters, place.clone())?;
        let exact_q: Vec<Number> = q.into_iter().flatten().collect();
        let (p, q) = (double_values(parameters), double_values(&exact_q));
        self.check_constraints_of_state(&constrained, &p, &q);
        let by_rates = rates.iter().any(Option::is_some) || !fixed.is_empty();
        let stated = StatedMotion {
            rates: state_entries_by_index(&rates),
            fixed: fixed.iter().map(|(at, x, _)| (*at, x.enclosure())).collect(),
            speeds: state_entries_by_index(&u),
        };
        let given =
            |list: Vec<Option<(Number, Located)>>| list.into_iter().flatten().map(|(x, _)| x).collect::<Vec<Number>>();
        let (mut rates, exact_u) = (given(rates), given(u));
        let is_whole = rates.len() == n && fixed.is_empty();
        if by_rates && is_whole {
            self.check_motion_of_state(table, &p, &q, &double_values(&rates));
        } else if self.model.ties_rates() || !fixed.is_empty() {
            let solved = self.solve_rates(&stated, parameters, &exact_q, &place)?;
            if by_rates {
                closed.extend(self.solved_rates(&stated, &solved));
                rates = self.numbers_of_solved_rates(&stated, parameters, &exact_q, solved);
            }
        }
        let u = if by_rates { self.speeds_of_state(&p, &q, &double_values(&rates)) } else { double_values(&exact_u) };
        if let Some(at) = u.iter().position(|x| !x.is_finite()) {
            let message = format!("the speed `{}` is not finite at this state", self.model.speeds[at].name);
            self.reader.errors.push(Diagnostic::of_file(message, "choose another state"));
            return None;
        }
        let (motion, enclosed) = if by_rates {
            (InitialMotion::Rates(extended_values(&rates)), InitialMotion::Rates(enclosed_values(&rates)))
        } else {
            (InitialMotion::Speeds(extended_values(&exact_u)), InitialMotion::Speeds(enclosed_values(&exact_u)))
        };
        let enclosed =
            EnclosedStart { parameters: enclosed_values(parameters), q: enclosed_values(&exact_q), motion: enclosed };
        let rational = parameters.iter().map(|p| p.exact.clone()).collect();
        let exact =
            ExactStart { parameters: extended_values(parameters), rational, q: extended_values(&exact_q), motion };
        Some(Start { q, u, exact, enclosed, closed })
    }

    /// Sets the time coordinate to the first instant of the span. For a state file it is the stated instant, or 0 if
    /// the file states none. `None` after an error is reported.
    fn set_time_of_state(
        &mut self,
        q: &mut [Option<Number>],
        rates: &mut [Option<(Number, Located)>],
        place: &Range<usize>,
    ) -> Option<()> {
        let Some(at) = self.model.time() else { return Some(()) };
        if rates[at].is_some() || self.instant.is_some() && q[at].is_some() {
            let help = "leave the time out: a run starts at the first instant of `span`";
            self.reader.error(place.clone(), "time is not part of a start", help);
            return None;
        }
        let stated = q[at].take().unwrap_or_else(|| Number::exact(Rational::ZERO));
        q[at] = Some(self.instant.clone().unwrap_or(stated));
        if rates.iter().any(Option::is_some) {
            let name = Located { text: format!("{TIME}'"), span: place.clone(), exact: false };
            rates[at] = Some((Number::exact(Rational::ONE), name));
        }
        Some(())
    }

    /// Reports coordinates, speeds and rates that have no value, and a mixture of speeds and rates. `None` after an
    /// error is reported.
    fn report_missing_values(
        &mut self,
        table: &'a DeTable<'a>,
        q: &[Option<Number>],
        rates: &[Option<(Number, Located)>],
        u: &[Option<(Number, Located)>],
        constrained: ConstrainedCounts,
    ) -> Option<()> {
        let ConstrainedCounts { held, fixed } = constrained;
        let model = &self.model;
        let place = self.reader.entries(table).first().map_or(0..0, |(key, _)| key.span.clone());
        let open = model.coordinates.iter().zip(q).filter(|(_, x)| x.is_none());
        let mut missing: Vec<String> = open.map(|(c, _)| c.name.clone()).collect();
        if !model.loops.is_empty() || missing.len() <= held {
            missing.clear();
        }
        let by_rate = fixed > 0 || rates.iter().any(Option::is_some);
        let by_speed = u.iter().flatten().next();
        if let (true, Some((_, name))) = (by_rate, by_speed) {
            let help = "state every speed or every q', not both kinds: the definitions give the others";
            self.reader.error(name.span.clone(), "speeds and time derivatives are mixed", help);
            return None;
        }
        if by_rate && (model.ties_rates() || fixed > 0) {
            // Further rates follow from the stated rates, or are reported later as undetermined.
        } else if by_rate {
            let names = model.coordinates.iter().zip(rates).filter(|(_, x)| x.is_none());
            missing.extend(names.map(|(c, _)| format!("{}'", c.name)));
        } else {
            let names = model.speeds.iter().zip(u).filter(|(_, x)| x.is_none());
            missing.extend(names.map(|(s, _)| s.name.clone()));
        }
        if missing.is_empty() {
            return Some(());
        }
        let message = format!("no value for {}", missing.join(", "));
        self.reader.error(place, message, "give every coordinate, and every speed or every q'");
        None
    }

    /// Reports stated values of variables that contradict the constraint which determines them.
    fn check_constraints_of_state(&mut self, stated: &[ConstrainedValue], parameters: &[f64], q: &[f64]) {
        for ConstrainedValue { constraint, number, span } in stated {
            let constraint = self.model.constraints[*constraint].clone();
            let inputs = [parameters, q].concat();
            let symbols = [self.model.p(), self.model.q()].concat();
            let Ok(tape) = Tape::new(&self.model.arena, &symbols, &[constraint.value]) else { continue };
            let value = tape.evaluate(&inputs)[0];
            let residual = number.double - value;
            if residual.is_nan() || residual.abs() > RESIDUAL * (1.0 + value.abs()) {
                let message = format!(
                    "the constraint `{}` is broken: `{}` is off by {}",
                    constraint.name,
                    constraint.fixes,
                    with_significant_digits(residual, 4)
                );
                let help = format!("leave `{}` out, or state {value}", constraint.fixes);
                self.reader.error(span.clone(), message, help);
            }
        }
    }

    /// Reports stated rates that violate a motion constraint. Generalized speeds could not represent such rates.
    fn check_motion_of_state(&mut self, table: &'a DeTable<'a>, parameters: &[f64], q: &[f64], rates: &[f64]) {
        let model = &self.model;
        let symbols = [model.p(), model.q(), model.q_dot()].concat();
        let equations: Vec<Expr> = model.motion_constraints.iter().map(|c| c.equation).collect();
        let values = match Tape::new(&model.arena, &symbols, &equations) {
            Ok(tape) => tape.evaluate(&[parameters, q, rates].concat()),
            Err(unknown) => unreachable!("constraints tie coordinates and rates, not {}", unknown.0),
        };
        let size = rates.iter().fold(1.0, |most: f64, rate| most.max(rate.abs()));
        let place = self.reader.entries(table).first().map_or(0..0, |(key, _)| key.span.clone());
        for (constraint, residual) in model.motion_constraints.iter().zip(values) {
            if residual.is_nan() || residual.abs() > RESIDUAL * size {
                let message = format!(
                    "the start breaks the motion constraint `{}`: its value is {}, not 0",
                    constraint.name,
                    with_significant_digits(residual, 4)
                );
                self.reader.error(
                    place.clone(),
                    message,
                    "give the generalized speeds instead of rates: speeds always satisfy the constraint",
                );
            }
        }
    }

    /// Generalized speeds in SI units, computed from parameters, coordinates and rates.
    pub(in crate::scene) fn speeds_of_state(&mut self, parameters: &[f64], q: &[f64], rates: &[f64]) -> Vec<f64> {
        let model = &self.model;
        let tape = self.terms.speeds.get_or_insert_with(|| {
            let symbols = [model.p(), model.q(), model.q_dot()].concat();
            let definitions: Vec<Expr> = model.speeds.iter().map(|s| s.definition).collect();
            match Tape::new(&model.arena, &symbols, &definitions) {
                Ok(tape) => tape,
                Err(unknown) => unreachable!("speeds are defined by coordinates and rates, not by {}", unknown.0),
            }
        });
        tape.evaluate(&[parameters, q, rates].concat())
    }

    /// Unit of the coordinate, rate or speed with the given name; `None` for any other name.
    fn unit_in_state(&self, name: &str) -> Option<Unit> {
        let model = &self.model;
        let coordinates = model.coordinates.iter();
        let rate = name.strip_suffix('\'');
        let of_speeds = model.speeds.iter().find(|s| s.name == name).map(|s| s.unit.clone());
        of_speeds.or_else(|| {
            let coordinate = coordinates.clone().find(|c| c.name == rate.unwrap_or(name))?;
            Some(if rate.is_some() { coordinate.unit.per_second() } else { coordinate.unit.clone() })
        })
    }
}
