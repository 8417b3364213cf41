//! Numbers in scene and state files: exact formulas in parameters, which are parsed once and evaluated at each
//! reading.
//!
//! Invariant: the result of a reading depends only on the file and on the numbers that replace the file's numbers.
//! Earlier readings have no effect.

use super::named_positions::Places;
use super::scene_number::{Number, double_values, enclosed_values};
use crate::algebra::term::calculus::Substitution;
use crate::algebra::text::parse::{InteractionName, VelocityName, parse, parse_with_quantities};
use crate::algebra::value::interval::{constant_with_wide_interval, without_zeros_of_wide_interval};
use crate::algebra::value::rational_value::exact_value;
use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr, Rational};
use crate::diagnostic::{Diagnostic, nearest_name_advice};
use crate::model::{ImpossibleBody, Model, StatedInteraction, StatedUnit, Unit, redundant_reaction_message};
use crate::toml_reader::{Located, TomlReader};
use rustc_hash::FxHashMap;
use toml::de::DeTable;
use tripos_traits::{Ball, DoubleDouble};

/// Number of a scene that a sweep may vary: a parameter or a start value, by its index in the
/// model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VariedNumber {
    /// Value of the parameter with this index.
    Parameter(usize),
    /// Start value of the coordinate with this index.
    Coordinate(usize),
    /// Start value of the rate of the coordinate with this index.
    Rate(usize),
    /// Start value of the generalized speed with this index.
    Speed(usize),
}

/// One degree in radians, π/180, as a term.
fn degree(arena: &mut Arena) -> Expr {
    let pi = arena.pi();
    arena.scale(pi, &Rational::fraction(1, 180).expect("not zero"))
}

/// Parsed formulas of a scene or state file, kept for further readings.
#[derive(Default)]
pub struct ParsedFormulas {
    /// Formulas by the byte offset at which they begin in the file.
    formulas: FxHashMap<usize, Term>,
    /// Program that computes the generalized speeds from parameters, q and q̇; `None` until it is needed.
    pub(in crate::scene) speeds: Option<Tape>,
    /// Program that computes the motion constraints and speeds, which are linear in the rates; `None` until it is
    /// needed.
    pub(in crate::scene) conditions: Option<Tape>,
}

/// Parsed formula of a file, with the program that evaluates it.
struct Term {
    /// Formula as a term.
    expression: Expr,
    /// Program that evaluates the formula in doubles.
    tape: Tape,
    /// True if the formula contains a parameter or a name that the file defines.
    varies: bool,
    /// Value of a formula without parameters. `None` before it is evaluated, or if the formula contains parameters.
    constant: Option<Number>,
}

/// Number with a name that a state file defines for its own formulas.
#[derive(Clone, Debug)]
pub struct NamedNumber<N> {
    /// Name of the number in the file.
    pub name: String,
    /// Symbol of the number in formulas.
    pub symbol: Expr,
    /// Value of the number, in SI units.
    pub value: N,
}

/// Number that a scene gives to an input of the model, in place of a formula.
pub struct InputNumber {
    /// Index of the input in the model's parameters.
    pub parameter: usize,
    /// Value of the input, in SI units.
    pub number: Number,
    /// Byte range of the number in the scene file.
    pub span: std::ops::Range<usize>,
}

/// Reader of a scene, state or motion file, whose values belong to a model.
pub struct ValueReader<'a, 'm> {
    /// Reader of the TOML file, which collects the errors.
    pub reader: TomlReader<'a>,
    /// Model that the file belongs to; its arena receives the terms of formulas.
    pub model: &'m mut Model,
    /// Parsed formulas of the file, kept for further readings.
    pub terms: ParsedFormulas,
    /// Numbers that replace those of the file, each with its value.
    pub given: &'m [(VariedNumber, Number)],
    /// Instant of the state, s, if the file states it outside the state, such as by a scene's span. `None` otherwise.
    pub instant: Option<Number>,
    /// Numbers with names that the file defines for its own formulas.
    pub names: Vec<NamedNumber<Number>>,
    /// True if irrational formulas are evaluated to 32 digits, as derivatives of a start require. False if they are
    /// evaluated in doubles.
    pub is_wide: bool,
}

impl<'a, 'm> ValueReader<'a, 'm> {
    /// Creates a reader of a file that is read once, without replaced numbers.
    pub fn new(reader: TomlReader<'a>, model: &'m mut Model) -> Self {
        Self {
            reader,
            model,
            terms: ParsedFormulas::default(),
            given: &[],
            instant: None,
            names: Vec::new(),
            is_wide: false,
        }
    }
}

impl<'a> ValueReader<'a, '_> {
    /// Table under a key of the file. `None` if the key is absent, or after reporting a value that is no table.
    pub fn section(&mut self, table: &'a DeTable<'a>, key: &str) -> Option<&'a DeTable<'a>> {
        let value = self.reader.get(table, key)?;
        self.reader.table(value, &format!("`{key}`"), &format!("[{key}]"))
    }

    /// Values of all parameters, in the order of the model. A parameter that the file does not state has the model's
    /// default value. `None` after an error is reported.
    pub fn parameters(&mut self, table: &'a DeTable<'a>) -> Option<Vec<Number>> {
        let mut values: Vec<Option<Number>> = vec![None; self.model.parameters.len()];
        let mut places = vec![None; values.len()];
        let section = self.section(table, "parameters");
        for (name, value) in section.map_or(Vec::new(), |s| self.reader.entries(s)) {
            let Some(at) = self.model.parameters.iter().position(|p| p.name == name.text && !p.is_input) else {
                if self.model.inputs.iter().any(|input| input.name == name.text) {
                    self.reader.error(name.span, format!("`{}` is an input", name.text), "state it under [inputs]");
                    continue;
                }
                let help = nearest_name_advice(&name.text, self.model.parameters.iter().map(|p| p.name.as_str()));
                self.reader.error(name.span, format!("the model has no parameter `{}`", name.text), help);
                continue;
            };
            let Some(formula) = self.reader.formula(value, "a parameter's value") else { continue };
            self.check_unit(&formula, &self.model.parameters[at].unit.clone(), &name.text);
            let Some(number) = self.constant(&formula) else { continue };
            if let Some(message) = self.not_positive_message(at, &number) {
                self.reader.error(formula.span.clone(), message, "give a value above zero");
            }
            (values[at], places[at]) = (Some(number), Some(formula.span));
        }
        for InputNumber { parameter, number, span } in self.numbers_of_inputs(table) {
            (values[parameter], places[parameter]) = (Some(number), Some(span));
        }
        for (place, number) in self.given {
            let VariedNumber::Parameter(at) = *place else { continue };
            if let Some(message) = self.not_positive_message(at, number) {
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

    /// Reports parameter values with which a body cannot exist, such as an impossible inertia. The error is shown at
    /// the first stated value on which the body's mass or inertia depends.
    fn check_bodies(&mut self, values: &[Number], places: &[Option<std::ops::Range<usize>>]) {
        for ImpossibleBody { message, help, parameters } in self.model.impossible_bodies(&double_values(values)) {
            match parameters.into_iter().find_map(|at| places[at].clone()) {
                Some(span) => self.reader.error(span, message, help),
                None => self.reader.errors.push(Diagnostic::of_file(message, help)),
            }
        }
    }

    /// Message about a parameter that must be positive and is not. `None` if its value is allowed. `at` is the index
    /// of the parameter.
    fn not_positive_message(&self, at: usize, number: &Number) -> Option<String> {
        let parameter = &self.model.parameters[at];
        (parameter.positive && number.double <= 0.0)
            .then(|| format!("`{}` is stated to be positive but is {}", parameter.name, number.double))
    }

    /// Reports a number whose stated unit does not have the dimension of the quantity `name`.
    pub(in crate::scene) fn check_unit(&mut self, formula: &Located, unit: &Unit, name: &str) {
        if let Some(stated) = StatedUnit::of(&formula.text).filter(|stated| stated.unit != *unit) {
            let message =
                format!("`{name}` is in {}, but this number in {}", unit.unit_words(), stated.unit.unit_words());
            self.reader.error(formula.span.clone(), message, "state it in a unit of that kind");
        }
    }

    /// Evaluates a formula of numbers, `deg` and `pi`; `None` after an error is reported.
    pub fn constant(&mut self, formula: &Located) -> Option<Number> {
        self.evaluate(formula, &[], "a parameter's value")
    }

    /// Evaluates a formula of numbers, `deg`, `pi`, parameters and the file's own names. `what` names the number in
    /// error messages. `None` after an error is reported.
    pub fn number(&mut self, formula: &Located, parameters: &[Number], what: &str) -> Option<Number> {
        self.evaluate(formula, parameters, what)
    }

    /// Evaluates a formula in parameters. It is parsed only at the first reading. `None` after an error is reported.
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
        let own = self.names.iter().map(|named| named.value.double);
        let value = term.tape.evaluate(&double_values(parameters).into_iter().chain(own).collect::<Vec<_>>())[0];
        if !value.is_finite() {
            self.reader.error(
                formula.span.clone(),
                format!("{what} is {value}, not a finite number"),
                "give a finite number",
            );
            return None;
        }
        let symbols = self.model.parameters.iter().map(|p| p.symbol);
        let own = self.names.iter().map(|named| (named.symbol, &named.value));
        let pairs = symbols.zip(parameters).chain(own).filter_map(|(s, p)| Some((s, p.exact.clone()?)));
        let exact = exact_value(&self.model.arena, term.expression, &pairs.collect::<Vec<_>>());
        let number = match exact {
            Some(exact) => Number::exact(exact),
            None if self.is_wide => {
                let own = self.names.iter().map(|named| named.value.enclosure());
                let known: Vec<Ball> = enclosed_values(parameters).into_iter().chain(own).collect();
                let centres: Vec<DoubleDouble> = known.iter().map(|x| x.centre).collect();
                let centre = term.tape.to::<DoubleDouble>().evaluate(&centres)[0];
                // Without a bound on a parameter there is a value, but no bound on it.
                let gap = (term.tape.to::<Ball>().evaluate(&known)[0] - Ball::point(centre)).size();
                Number::enclosed(Ball { centre, radius: if gap.is_finite() { gap } else { f64::INFINITY } })
            }
            None => Number::rounded(value),
        };
        if !term.varies {
            self.terms.formulas.entry(place).and_modify(|term| term.constant = Some(number.clone()));
        }
        Some(number)
    }

    /// True if a formula contains the parameter with the given index. The formula must have been evaluated; otherwise
    /// false.
    pub fn mentions(&self, formula: &Located, parameter: usize) -> bool {
        let term = self.terms.formulas.get(&formula.span.start);
        term.is_some_and(|t| self.model.arena.mentions(t.expression, self.model.parameters[parameter].symbol))
    }

    /// Term of a formula that was already evaluated; `None` for any other formula.
    pub fn expression(&self, formula: &Located) -> Option<Expr> {
        self.terms.formulas.get(&formula.span.start).map(|term| term.expression)
    }

    /// Parses a formula in the first `known` parameters of the model and the file's own names. `None`
    /// after an error is reported.
    fn term(&mut self, formula: &Located, known: usize, what: &str) -> Option<Term> {
        let model = &mut *self.model;
        let known: Vec<(String, Expr)> =
            model.parameters.iter().take(known).map(|p| (p.name.clone(), p.symbol)).collect();
        let own = self.names.iter().map(|named| (named.name.clone(), named.symbol));
        let known: Vec<(String, Expr)> = known.into_iter().chain(own).collect();
        let symbols: Vec<Expr> = known.iter().map(|(_, e)| *e).collect();
        let of_parameters = model.expressions_in(&symbols);
        let stated = StatedUnit::of(&formula.text);
        let number = stated.as_ref().map_or_else(|| formula.clone(), |stated| stated.number_before_unit(formula));
        let result = parse(&mut model.arena, &number.text, &mut |arena, name| {
            if name == "deg" {
                return Ok(degree(arena));
            }
            if let Some((_, e)) = known.iter().chain(&of_parameters).find(|(n, _)| n == name) {
                return Ok(*e);
            }
            let names = known.iter().chain(&of_parameters).map(|(n, _)| n.as_str()).chain(["deg", "pi"]);
            Err((format!("`{name}` cannot stand in {what}"), Some(nearest_name_advice(name, names))))
        });
        let expression = match result {
            Ok(e) => stated.map_or(e, |stated| stated.apply(&mut model.arena, e)),
            Err(error) => {
                self.reader.error(formula.part(error.span), error.message, error.help.unwrap_or_default());
                return None;
            }
        };
        // A constant without functions is evaluated exactly, so it loses no digits.
        let lost = constant_with_wide_interval(&model.arena, expression);
        if let Some(lost) = lost.filter(|lost| exact_value(&model.arena, *lost, &[]).is_none()) {
            self.reader.report_lost_constant(&model.arena, formula, lost);
            return None;
        }
        let tape = Tape::new(&model.arena, &symbols, &[expression]).ok()?;
        let varies = symbols.iter().any(|symbol| model.arena.mentions(expression, *symbol));
        Some(Term { expression, tape, varies, constant: None })
    }

    /// Reads a formula of quantities that have a value during a run. They are parameters, t, q, q̇, u, inputs,
    /// reactions, positions and velocities. `None` after an error is reported.
    pub fn value_formula(&mut self, formula: &Located) -> Option<Expr> {
        self.value_formula_with(formula, &[])
    }

    /// Reads a formula of quantities that have a value during a run. It may also contain the names `others`, such as
    /// energies, and then accelerations. Names of the model take precedence over `others`. `None` after an error is
    /// reported.
    pub fn value_formula_with(&mut self, formula: &Located, others: &[&str]) -> Option<Expr> {
        let model = &mut *self.model;
        let mut known: Vec<(String, Expr)> = Vec::new();
        known.extend(model.parameters.iter().map(|p| (p.name.clone(), p.symbol)));
        known.extend(
            model.coordinates.iter().flat_map(|c| [(c.name.clone(), c.symbol), (format!("{}'", c.name), c.rate)]),
        );
        known.extend(model.speeds.iter().map(|s| (s.name.clone(), s.symbol)));
        known.extend(model.inputs.iter().map(|input| (input.name.clone(), input.value)));
        known.extend(model.reactions.iter().map(|r| (r.name.clone(), r.symbol)));
        known.extend(model.constraints.iter().map(|c| (c.fixes.clone(), c.value)));
        known.extend(model.dependent_speeds.iter().map(|speed| (speed.name.clone(), speed.definition)));
        known.extend(model.expressions.iter().cloned());
        if !others.is_empty() {
            known.extend(model.speeds.iter().map(|s| (format!("{}'", s.name), s.rate)));
        }
        let redundant: Vec<&str> = model.redundant.iter().map(|r| r.reaction.name.as_str()).collect();
        let mut resolve = |arena: &mut Arena, name: &str| {
            if let Some((_, e)) = known.iter().find(|(n, _)| n == name) {
                return Ok(*e);
            }
            if others.contains(&name) {
                return Ok(arena.symbol(name));
            }
            if name == "deg" {
                return Ok(degree(arena));
            }
            if redundant.contains(&name) {
                let (message, help) = redundant_reaction_message(name);
                return Err((message, Some(help.to_owned())));
            }
            let names = known.iter().map(|(n, _)| n.as_str()).chain(others.iter().copied());
            Err((format!("unknown name `{name}`"), Some(nearest_name_advice(name, names))))
        };
        let mut stated = Vec::new();
        let mut interaction = |arena: &mut Arena, name: &InteractionName<'_>| {
            let interaction = StatedInteraction::new(arena, formula, name);
            let symbol = interaction.symbol;
            stated.push(interaction);
            Ok(symbol)
        };
        let mut arena = std::mem::take(&mut model.arena);
        let mut places = Places::default();
        let mut component = |arena: &mut Arena, name: &VelocityName<'_>| places.component(&*model, arena, name);
        let result = parse_with_quantities(&mut arena, &formula.text, &mut resolve, &mut component, &mut interaction);
        self.model.arena = arena;
        let result = match result {
            Ok(e) => Ok(self.replace_interactions(e, &stated)?),
            Err(error) => Err(error),
        };
        let model = &mut *self.model;
        // Directions of oblique axes introduce square roots that cancel exactly.
        let result = result.map(|e| without_zeros_of_wide_interval(&mut model.arena, e));
        match result.map(|e| (e, constant_with_wide_interval(&model.arena, e))) {
            Ok((e, None)) => Some(e),
            Ok((_, Some(lost))) => {
                self.reader.report_lost_constant(&model.arena, formula, lost);
                None
            }
            Err(error) => {
                self.reader.error(formula.part(error.span), error.message, error.help.unwrap_or_default());
                None
            }
        }
    }

    /// Replaces the named forces and torques between bodies in a term by terms in reactions. `None`
    /// after an error is reported.
    fn replace_interactions(&mut self, e: Expr, stated: &[StatedInteraction]) -> Option<Expr> {
        let mut pairs = Vec::new();
        for interaction in stated {
            match self.model.interaction(interaction) {
                Ok(value) => pairs.push((interaction.symbol, value)),
                Err(error) => self.reader.errors.push(error),
            }
        }
        (pairs.len() == stated.len()).then(|| Substitution::new(&pairs).apply(&mut self.model.arena, e))
    }
}
