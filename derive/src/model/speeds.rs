//! Generalized speeds and the kinematic equations they give.

use super::loading::Loading;
use super::names::{Kind, VELOCITY};
use super::{Coordinate, KinematicEquations, Speed};
use crate::algebra::blocks::solve_blocks;
use crate::algebra::calculus::Substitution;
use crate::algebra::linear::LinearForm;
use crate::algebra::simplify::Simplifier;
use crate::algebra::{Expr, Node};
use crate::diagnostic::shown;
use crate::read::{Located, Reader};
use std::ops::Range;
use toml::de::DeTable;

impl<'a> Loading<'a> {
    /// Declares the speeds; their definitions are read once the coordinates are known.
    pub fn speed_symbols(&mut self, table: &'a DeTable<'a>) -> Vec<(Located, Located)> {
        let mut texts = Vec::new();
        for (name, value) in self.section(table, "speeds", &[Kind::Speed]) {
            let symbol = self.arena.symbol(&name.text);
            self.names.declare(&mut self.reader, &name, Kind::Speed, Some(symbol));
            let what = format!("speed `{}`", shown(&name.text));
            match self.reader.formula(value, &what) {
                Some(formula) => texts.push((name, formula)),
                None => self.names.spoil(&name.text),
            }
        }
        for (name, formula) in &texts {
            let what = "the definition of a speed";
            // The unit of a speed is that of its definition: read here, since forces may use speeds.
            let e = self.names.formula(&mut self.reader, &mut self.arena, formula, VELOCITY, what);
            let unit = e.and_then(|e| self.unit_of(e, &formula.span));
            let symbol = self.arena.symbol(&name.text);
            self.units.extend(unit.map(|unit| (symbol, unit)));
        }
        texts
    }

    /// The speeds, with what the constraints fix put in.
    pub fn speeds(
        &mut self,
        texts: Vec<(Located, Located)>,
        replacements: &[(Expr, Expr)],
    ) -> Vec<(Speed, Range<usize>)> {
        let mut fixed = Substitution::new(replacements);
        let mut speeds = Vec::new();
        for (name, formula) in texts {
            // Already reported where it was declared, if it has errors.
            let mut scratch = Reader::new(self.reader.source);
            let Some(e) = self.names.formula(&mut scratch, &mut self.arena, &formula, VELOCITY, "a speed") else {
                continue;
            };
            let definition = fixed.apply(&mut self.arena, e);
            let rate = self.arena.symbol(&format!("{}'", name.text));
            let symbol = self.arena.symbol(&name.text);
            let unit = self.units.get(&symbol).cloned().unwrap_or_default();
            speeds.push((Speed { name: name.text, symbol, rate, definition, unit }, formula.span));
        }
        speeds
    }

    /// Solves u = J q̇ + d for q̇; reports speeds too few, too many, not linear or not independent.
    pub fn kinematic_equations(
        &mut self,
        table: &DeTable<'_>,
        coordinates: &[Coordinate],
        speeds: &[(Speed, Range<usize>)],
    ) -> Option<KinematicEquations> {
        if speeds.len() != coordinates.len() {
            self.report_count(table, coordinates, speeds);
            return None;
        }
        let before = self.reader.errors.len();
        let rates: Vec<Expr> = coordinates.iter().map(|c| c.rate).collect();
        let mut form = LinearForm::new(&rates);
        let (mut matrix, mut right) = (Vec::new(), Vec::new());
        for (speed, span) in speeds {
            match form.coefficients(&mut self.arena, speed.definition) {
                Ok((row, rest)) => {
                    matrix.push(row);
                    right.push(self.arena.sub(speed.symbol, rest));
                }
                Err(not_linear) => {
                    let names: Vec<String> = coordinates.iter().map(|c| format!("{}'", c.name)).collect();
                    let message = format!(
                        "speed `{}` is not linear in the time derivatives {}: its coefficient of {} is {}",
                        speed.name,
                        names.join(", "),
                        self.arena.symbol_name(not_linear.symbol).unwrap_or_default(),
                        shown(&crate::algebra::print::text(&self.arena, not_linear.coefficient)),
                    );
                    self.reader.error(span.clone(), message, "a generalized speed must read  u = Σ c_i(q) q_i' + d(q)");
                }
            }
        }
        if self.reader.errors.len() > before {
            return None;
        }
        match solve_blocks(&mut self.arena, &mut Simplifier::default(), &matrix, &right) {
            Ok((rates, divisors)) => {
                let divisors = self.moving_factors(&divisors, coordinates);
                Some(KinematicEquations { rates, divisors })
            }
            Err(singular) => {
                let (speed, span) = &speeds[singular.row];
                let message = format!(
                    "the speeds are not independent: rank {} of {}; `{}` follows from the others",
                    singular.rank,
                    speeds.len(),
                    speed.name
                );
                self.reader.error(span.clone(), message, "the speeds must determine every q' uniquely");
                None
            }
        }
    }

    /// The factors of divisors that depend on coordinates, each once: a length that divides does not vanish
    /// on the way.
    fn moving_factors(&self, divisors: &[Expr], coordinates: &[Coordinate]) -> Vec<Expr> {
        let mut factors = Vec::new();
        for divisor in divisors {
            let inner = match self.arena.node(*divisor) {
                Node::Sum(constant, terms) if constant.is_zero() && terms.len() == 1 => terms[0].0,
                _ => *divisor,
            };
            let bases: Vec<Expr> = match self.arena.node(inner) {
                Node::Product(list) => list.iter().filter(|(_, n)| *n > 0).map(|(base, _)| *base).collect(),
                _ => vec![inner],
            };
            for base in bases {
                if coordinates.iter().any(|c| self.arena.mentions(base, c.symbol)) && !factors.contains(&base) {
                    factors.push(base);
                }
            }
        }
        factors
    }

    fn report_count(&mut self, table: &DeTable<'_>, coordinates: &[Coordinate], speeds: &[(Speed, Range<usize>)]) {
        let (n, m) = (speeds.len(), coordinates.len());
        let plural = |n: usize| if n == 1 { "" } else { "s" };
        let message =
            format!("{n} speed{} for {m} generalized coordinate{}: the numbers must agree", plural(n), plural(m));
        let section = table.iter().find(|(key, _)| key.get_ref() == "speeds").map(|(key, _)| key.span());
        let surplus = speeds.get(m).and_then(|(speed, _)| self.names.span(&speed.name));
        let names: Vec<&str> = coordinates.iter().take(20).map(|c| c.name.as_str()).collect();
        let help = format!(
            "define one speed for each coordinate that no constraint fixes ({}); nonholonomic constraints are not supported yet",
            names.join(", ")
        );
        self.reader.error(surplus.or(section).unwrap_or_default(), message, help);
    }
}
