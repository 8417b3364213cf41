//! Numbers in scene and state files: exact formulas in parameters, parsed once, evaluated for each reading.
//!
//! Invariant: what a reading gives depends on the file and on the numbers given in its stead, never on earlier
//! readings.

use super::start::{Closed, Exact, Stated};
use crate::algebra::evaluate::{Numeric, Tape};
use crate::algebra::exact::exact_value;
use crate::algebra::interval::lost_constant;
use crate::algebra::parse::parse;
use crate::algebra::{Expr, Rational};
use crate::diagnostic::{Diagnostic, nearest};
use crate::model::{Model, StatedUnit, TIME, Unit};
use crate::read::{Located, Reader};
use rustc_hash::FxHashMap;
use std::ops::Range;
use toml::de::DeTable;
use tripos_traits::DoubleDouble;

/// A number of a file.
#[derive(Clone, Debug)]
pub struct Number {
    /// Rounded.
    pub double: f64,
    /// As it is, where that is known: not for function values such as √2.
    pub exact: Option<Rational>,
    /// To 32 digits, where they are known.
    extended: DoubleDouble,
}

impl Number {
    /// Known exactly.
    pub fn exact(value: Rational) -> Self {
        Self { double: value.to_f64(), extended: DoubleDouble::of(&value), exact: Some(value) }
    }

    /// A number of which no more than the double is known.
    pub fn rounded(double: f64) -> Self {
        Self { double, exact: None, extended: double.into() }
    }

    /// To 32 digits.
    pub fn wide(extended: DoubleDouble) -> Self {
        Self { double: extended.hi(), exact: None, extended }
    }

    /// To 32 digits, where they are known.
    pub fn extended(&self) -> DoubleDouble {
        self.extended
    }
}

/// A number of a scene that may be given instead of what its file says, by its place in the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Varied {
    /// A parameter.
    Parameter(usize),
    /// A coordinate at the start.
    Coordinate(usize),
    /// The rate of a coordinate at the start.
    Rate(usize),
    /// A generalized speed at the start.
    Speed(usize),
}

/// What does not change from one reading of a file to the next: its formulas, parsed.
#[derive(Default)]
pub struct Terms {
    /// By their places in the file.
    formulas: FxHashMap<usize, Term>,
    /// The generalized speeds as functions of parameters, q and q̇.
    speeds: Option<Tape>,
}

/// A formula of a file.
struct Term {
    expression: Expr,
    tape: Tape,
    /// Whether it mentions a parameter.
    varies: bool,
    /// Its value, once it was evaluated, if it mentions no parameter.
    constant: Option<Number>,
}

/// Rounded to doubles.
pub fn doubles(numbers: &[Number]) -> Vec<f64> {
    numbers.iter().map(|n| n.double).collect()
}

fn extended(numbers: &[Number]) -> Vec<DoubleDouble> {
    numbers.iter().map(Number::extended).collect()
}

/// A state at one instant, with what the file says of it beyond the precision of a double.
#[derive(Clone, Debug, Default)]
pub struct Start {
    /// Coordinates.
    pub q: Vec<f64>,
    /// Generalized speeds.
    pub u: Vec<f64>,
    /// The values to 32 digits.
    pub exact: Exact,
    /// Coordinates that were solved for.
    pub closed: Vec<Closed>,
}

/// Reads values that belong to a model.
pub struct Values<'a, 'm> {
    pub reader: Reader<'a>,
    pub model: &'m mut Model,
    /// Formulas that were met before, in this file.
    pub terms: Terms,
    /// Numbers that stand in the stead of the file's.
    pub given: &'m [(Varied, Number)],
    /// The instant of the state, s, where the file states it elsewhere.
    pub instant: Option<Number>,
}

/// How far a stated constrained variable may be from where its constraint puts it.
const RESIDUAL: f64 = 1e-9;

impl<'a, 'm> Values<'a, 'm> {
    /// A reader of a file that is read once, as it is.
    pub fn new(reader: Reader<'a>, model: &'m mut Model) -> Self {
        Self { reader, model, terms: Terms::default(), given: &[], instant: None }
    }
}

impl<'a> Values<'a, '_> {
    /// A table under a key, if there is one.
    pub fn section(&mut self, table: &'a DeTable<'a>, key: &str) -> Option<&'a DeTable<'a>> {
        let value = self.reader.get(table, key)?;
        self.reader.table(value, &format!("`{key}`"), &format!("[{key}]"))
    }

    /// Values of all parameters: those stated, the model's defaults for the rest.
    pub fn parameters(&mut self, table: &'a DeTable<'a>) -> Option<Vec<Number>> {
        let mut values: Vec<Option<Number>> = vec![None; self.model.parameters.len()];
        let mut places = vec![None; values.len()];
        let section = self.section(table, "parameters");
        for (name, value) in section.map_or(Vec::new(), |s| self.reader.entries(s)) {
            let Some(at) = self.model.parameters.iter().position(|p| p.name == name.text) else {
                let help = nearest(&name.text, self.model.parameters.iter().map(|p| p.name.as_str()));
                self.reader.error(name.span, format!("the model has no parameter `{}`", name.text), help);
                continue;
            };
            let Some(formula) = self.reader.formula(value, "a parameter's value") else { continue };
            self.check_unit(&formula, &self.model.parameters[at].unit.clone(), &name.text);
            let Some(number) = self.constant(&formula) else { continue };
            if let Some(message) = self.not_positive(at, &number) {
                self.reader.error(formula.span.clone(), message, "give a value above zero");
            }
            (values[at], places[at]) = (Some(number), Some(formula.span));
        }
        for (place, number) in self.given {
            let Varied::Parameter(at) = *place else { continue };
            if let Some(message) = self.not_positive(at, number) {
                self.reader.errors.push(Diagnostic::of_file(message, "give a value above zero"));
            }
            values[at] = Some(number.clone());
        }
        for (parameter, value) in self.model.parameters.iter().zip(&mut values) {
            if value.is_none() {
                *value = parameter.value.clone().map(Number::exact);
            }
            if value.is_none() {
                let message = format!("the parameter `{}` has no value", parameter.name);
                let help = "give it in [parameters], or a default in the model file";
                self.reader.errors.push(Diagnostic::of_file(message, help));
            }
        }
        let values: Vec<Number> = values.into_iter().collect::<Option<_>>()?;
        self.check_bodies(&values, &places);
        Some(values)
    }

    /// Refuses values at which a body cannot exist, where the first of them that matters is stated.
    fn check_bodies(&mut self, values: &[Number], places: &[Option<std::ops::Range<usize>>]) {
        for (message, help, parameters) in self.model.impossible(&doubles(values)) {
            match parameters.into_iter().find_map(|at| places[at].clone()) {
                Some(span) => self.reader.error(span, message, help),
                None => self.reader.errors.push(Diagnostic::of_file(message, help)),
            }
        }
    }

    /// What is wrong with the value of a parameter that is stated to be positive.
    fn not_positive(&self, at: usize, number: &Number) -> Option<String> {
        let parameter = &self.model.parameters[at];
        (parameter.positive && number.double <= 0.0)
            .then(|| format!("`{}` is stated to be positive but is {}", parameter.name, number.double))
    }

    /// Every coordinate, and every speed or every q′: as (q, u).
    ///
    /// Coordinates may be left out that close the loops; guesses of them are under the key `guess` of `file`.
    pub fn state(&mut self, file: &'a DeTable<'a>, table: &'a DeTable<'a>, parameters: &[Number]) -> Option<Start> {
        let before = self.reader.errors.len();
        let (n, p) = (self.model.coordinates.len(), self.model.speeds.len());
        let (mut q, mut rates, mut u) = (vec![None; n], vec![None; n], vec![None; p]);
        let mut constrained = Vec::new();
        for (name, value) in self.reader.entries(table) {
            let Some(formula) = self.reader.formula(value, &format!("`{}`", name.text)) else { continue };
            let Some(number) = self.number(&formula, parameters, "a value at the start") else { continue };
            if let Some(unit) = self.unit_at_start(&name.text) {
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
                constrained.push((at, number, formula.span));
            } else {
                let rates: Vec<String> = model.coordinates.iter().map(|c| format!("{}'", c.name)).collect();
                let known = model.coordinates.iter().map(|c| c.name.as_str());
                let known =
                    known.chain(rates.iter().map(String::as_str)).chain(model.speeds.iter().map(|s| s.name.as_str()));
                let help = nearest(&name.text, known);
                self.reader.error(name.span, format!("the model has no coordinate or speed `{}`", name.text), help);
            }
        }
        if self.reader.errors.len() > before {
            return None;
        }
        for (place, number) in self.given {
            match *place {
                Varied::Parameter(_) => {}
                Varied::Coordinate(at) => q[at] = Some(number.clone()),
                Varied::Rate(at) => rates[at].iter_mut().for_each(|(stated, _)| *stated = number.clone()),
                Varied::Speed(at) => u[at].iter_mut().for_each(|(stated, _)| *stated = number.clone()),
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
        self.now(&mut q, &mut rates, &place)?;
        self.complete(table, &q, &rates, &u)?;
        let closed = self.close(&mut q, &guesses, parameters, place)?;
        let exact_q: Vec<Number> = q.into_iter().flatten().collect();
        let (p, q) = (doubles(parameters), doubles(&exact_q));
        self.check_constrained(&constrained, &p, &q);
        let given =
            |list: Vec<Option<(Number, Located)>>| list.into_iter().flatten().map(|(x, _)| x).collect::<Vec<Number>>();
        let (rates, exact_u) = (given(rates), given(u));
        let by_rates = !rates.is_empty();
        if by_rates {
            self.check_motion(table, &p, &q, &doubles(&rates));
        }
        let u = if by_rates { self.speeds_from_rates(&p, &q, &doubles(&rates)) } else { doubles(&exact_u) };
        if let Some(at) = u.iter().position(|x| !x.is_finite()) {
            let message = format!("the speed `{}` is not finite at this state", self.model.speeds[at].name);
            self.reader.errors.push(Diagnostic::of_file(message, "choose another state"));
            return None;
        }
        let motion = if by_rates { Stated::Rates(extended(&rates)) } else { Stated::Speeds(extended(&exact_u)) };
        let rational = parameters.iter().map(|p| p.exact.clone()).collect();
        let exact = Exact { parameters: extended(parameters), rational, q: extended(&exact_q), motion };
        Some(Start { q, u, exact, closed })
    }

    /// Puts time in: the instant at which the span starts, or what a state file says, with 0 for nothing.
    fn now(
        &mut self,
        q: &mut [Option<Number>],
        rates: &mut [Option<(Number, Located)>],
        place: &Range<usize>,
    ) -> Option<()> {
        let Some(at) = self.model.time() else { return Some(()) };
        if rates[at].is_some() || self.instant.is_some() && q[at].is_some() {
            let help = "leave it out: the first instant of `span` is where it starts";
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

    /// Reports what is missing; speeds and rates must not be mixed.
    fn complete(
        &mut self,
        table: &'a DeTable<'a>,
        q: &[Option<Number>],
        rates: &[Option<(Number, Located)>],
        u: &[Option<(Number, Located)>],
    ) -> Option<()> {
        let model = &self.model;
        let place = self.reader.entries(table).first().map_or(0..0, |(key, _)| key.span.clone());
        let open = model.coordinates.iter().zip(q).filter(|(_, x)| x.is_none() && model.loops.is_empty());
        let mut missing: Vec<String> = open.map(|(c, _)| c.name.clone()).collect();
        let by_rate = rates.iter().any(Option::is_some);
        let by_speed = u.iter().flatten().next();
        if let (true, Some((_, name))) = (by_rate, by_speed) {
            let help = "state every speed or every q', not some of both: the others follow from the definitions";
            self.reader.error(name.span.clone(), "speeds and time derivatives are mixed", help);
            return None;
        }
        if by_rate {
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

    fn check_constrained(&mut self, stated: &[(usize, Number, std::ops::Range<usize>)], parameters: &[f64], q: &[f64]) {
        for (at, number, span) in stated {
            let constraint = self.model.constraints[*at].clone();
            let inputs = [parameters, q].concat();
            let symbols = [self.model.p(), self.model.q()].concat();
            let Ok(tape) = Tape::new(&self.model.arena, &symbols, &[constraint.value]) else { continue };
            let value = tape.evaluate(&inputs)[0];
            let residual = number.double - value;
            if residual.is_nan() || residual.abs() > RESIDUAL * (1.0 + value.abs()) {
                let message = format!(
                    "the constraint `{}` is broken: `{}` is off by {residual:e}",
                    constraint.name, constraint.fixes
                );
                let help = format!("leave `{}` out, or state {value}", constraint.fixes);
                self.reader.error(span.clone(), message, help);
            }
        }
    }

    /// Rates that a motion constraint does not permit are reported: the speeds that are left say nothing of them.
    fn check_motion(&mut self, table: &'a DeTable<'a>, parameters: &[f64], q: &[f64], rates: &[f64]) {
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
                let message =
                    format!("the start breaks the motion constraint `{}`: it is {residual:e}, not 0", constraint.name);
                self.reader.error(place.clone(), message, "state the speeds, which satisfy it by themselves");
            }
        }
    }

    fn speeds_from_rates(&mut self, parameters: &[f64], q: &[f64], rates: &[f64]) -> Vec<f64> {
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

    /// The unit of a coordinate, rate or speed.
    fn unit_at_start(&self, name: &str) -> Option<Unit> {
        let model = &self.model;
        let coordinates = model.coordinates.iter();
        let rate = name.strip_suffix('\'');
        let of_speeds = model.speeds.iter().find(|s| s.name == name).map(|s| s.unit.clone());
        of_speeds.or_else(|| {
            let coordinate = coordinates.clone().find(|c| c.name == rate.unwrap_or(name))?;
            Some(if rate.is_some() { coordinate.unit.per_second() } else { coordinate.unit.clone() })
        })
    }

    /// Reports a number that is stated in a unit of another kind.
    fn check_unit(&mut self, formula: &Located, unit: &Unit, name: &str) {
        if let Some(stated) = StatedUnit::of(&formula.text).filter(|stated| stated.unit != *unit) {
            let message = format!("`{name}` is in {}, but this number in {}", unit.words(), stated.unit.words());
            self.reader.error(formula.span.clone(), message, "state it in a unit of that kind");
        }
    }

    /// A formula of numbers, `deg` and `pi`.
    pub fn constant(&mut self, formula: &Located) -> Option<Number> {
        self.evaluate(formula, &[], "a parameter's value")
    }

    /// A formula of numbers, `deg`, `pi` and parameters.
    pub fn number(&mut self, formula: &Located, parameters: &[Number], what: &str) -> Option<Number> {
        self.evaluate(formula, parameters, what)
    }

    fn evaluate(&mut self, formula: &Located, parameters: &[Number], what: &str) -> Option<Number> {
        let place = formula.span.start;
        if !self.terms.formulas.contains_key(&place) {
            let term = self.term(formula, parameters.len(), what)?;
            self.terms.formulas.insert(place, term);
        }
        let term = self.terms.formulas.get(&place)?;
        if let Some(number) = &term.constant {
            return Some(number.clone());
        }
        let value = term.tape.evaluate(&doubles(parameters))[0];
        if !value.is_finite() {
            self.reader.error(
                formula.span.clone(),
                format!("{what} is {value}, not a finite number"),
                "give a finite number",
            );
            return None;
        }
        let symbols = self.model.parameters.iter().map(|p| p.symbol);
        let pairs = symbols.zip(parameters).filter_map(|(s, p)| Some((s, p.exact.clone()?)));
        let exact = exact_value(&self.model.arena, term.expression, &pairs.collect::<Vec<_>>());
        let number = exact.map_or_else(|| Number::rounded(value), Number::exact);
        if !term.varies {
            self.terms.formulas.entry(place).and_modify(|term| term.constant = Some(number.clone()));
        }
        Some(number)
    }

    /// Whether a formula that was evaluated mentions a parameter.
    pub fn mentions(&self, formula: &Located, parameter: usize) -> bool {
        let term = self.terms.formulas.get(&formula.span.start);
        term.is_some_and(|t| self.model.arena.mentions(t.expression, self.model.parameters[parameter].symbol))
    }

    /// A formula in the first `known` parameters, parsed.
    fn term(&mut self, formula: &Located, known: usize, what: &str) -> Option<Term> {
        let model = &mut *self.model;
        let known: Vec<(String, Expr)> =
            model.parameters.iter().take(known).map(|p| (p.name.clone(), p.symbol)).collect();
        let stated = StatedUnit::of(&formula.text);
        let number = stated.as_ref().map_or_else(|| formula.clone(), |stated| stated.number(formula));
        let result = parse(&mut model.arena, &number.text, &mut |arena, name| {
            if name == "deg" {
                let pi = arena.pi();
                return Ok(arena.scale(pi, &Rational::fraction(1, 180).expect("not zero")));
            }
            if let Some((_, symbol)) = known.iter().find(|(n, _)| n == name) {
                return Ok(*symbol);
            }
            let names = known.iter().map(|(n, _)| n.as_str()).chain(["deg", "pi"]);
            Err((format!("`{name}` cannot stand in {what}"), Some(nearest(name, names))))
        });
        let expression = match result {
            Ok(e) => stated.map_or(e, |stated| stated.apply(&mut model.arena, e)),
            Err(error) => {
                self.reader.error(formula.part(error.span), error.message, error.help.unwrap_or_default());
                return None;
            }
        };
        // Without functions a value is exact.
        let lost = lost_constant(&model.arena, expression);
        if let Some(lost) = lost.filter(|lost| exact_value(&model.arena, *lost, &[]).is_none()) {
            self.reader.lost(&model.arena, formula, lost);
            return None;
        }
        let symbols: Vec<Expr> = known.iter().map(|(_, e)| *e).collect();
        let tape = Tape::new(&model.arena, &symbols, &[expression]).ok()?;
        let varies = symbols.iter().any(|symbol| model.arena.mentions(expression, *symbol));
        Some(Term { expression, tape, varies, constant: None })
    }

    /// A formula in everything that has a value during a run.
    pub fn motion_formula(&mut self, formula: &Located) -> Option<Expr> {
        self.motion_formula_with(formula, &[])
    }

    /// A formula of a motion that may also mention `others`, such as accelerations; names of the model hide them.
    pub fn motion_formula_with(&mut self, formula: &Located, others: &[&str]) -> Option<Expr> {
        let model = &mut *self.model;
        let mut known: Vec<(String, Expr)> = Vec::new();
        known.extend(model.parameters.iter().map(|p| (p.name.clone(), p.symbol)));
        known.extend(
            model.coordinates.iter().flat_map(|c| [(c.name.clone(), c.symbol), (format!("{}'", c.name), c.rate)]),
        );
        known.extend(model.speeds.iter().map(|s| (s.name.clone(), s.symbol)));
        known.extend(model.reactions.iter().map(|r| (r.name.clone(), r.symbol)));
        known.extend(model.constraints.iter().map(|c| (c.fixes.clone(), c.value)));
        if !others.is_empty() {
            known.extend(model.speeds.iter().map(|s| (format!("{}'", s.name), s.rate)));
        }
        let result = parse(&mut model.arena, &formula.text, &mut |arena, name| {
            if let Some((_, e)) = known.iter().find(|(n, _)| n == name) {
                return Ok(*e);
            }
            if others.contains(&name) {
                return Ok(arena.symbol(name));
            }
            let names = known.iter().map(|(n, _)| n.as_str()).chain(others.iter().copied());
            Err((format!("unknown name `{name}`"), Some(nearest(name, names))))
        });
        match result.map(|e| (e, lost_constant(&model.arena, e))) {
            Ok((e, None)) => Some(e),
            Ok((_, Some(lost))) => {
                self.reader.lost(&model.arena, formula, lost);
                None
            }
            Err(error) => {
                self.reader.error(formula.part(error.span), error.message, error.help.unwrap_or_default());
                None
            }
        }
    }
}
