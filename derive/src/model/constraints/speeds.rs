//! Generalized speeds of a model file, and the kinematic equations that they define.

use super::motion_constraints::MotionConstraints;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::block_systems::solve_blocks;
use crate::algebra::solve::elimination::divisors;
use crate::algebra::solve::linear::LinearForm;
use crate::algebra::solve::pivot_values::PivotValues;
use crate::algebra::solve::system_labels::SystemLabels;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::contraction::contract_products;
use crate::algebra::value::rank::rank;
use crate::algebra::{Arena, Expr, Node};
use crate::diagnostic::shortened_for_message;
use crate::model::bodies::joints::Joints;
use crate::model::reading::declared_names::{NameKind, VELOCITY};
use crate::model::reading::loading::Loading;
use crate::model::{Coordinate, KinematicEquations, MotionConstraint, Speed};
use crate::toml_reader::{Located, TomlReader};
use std::ops::Range;
use toml::de::DeTable;

/// Generalized speeds, each with the byte range of its definition; then the dependent speeds that were left out.
type ChosenSpeeds = (Vec<(Speed, Range<usize>)>, Vec<Speed>);

impl<'a> Loading<'a> {
    /// Declares the speeds, and reads the section of expressions. Records the units of the speeds. Returns (name,
    /// definition as text) of each speed, since definitions are read once all coordinates are known.
    pub fn speed_symbols(&mut self, table: &'a DeTable<'a>, joints: &Joints<'a>) -> Vec<(Located, Located)> {
        let mut texts = Vec::new();
        for (name, value) in self.section(table, "speeds", &[NameKind::Speed]) {
            let symbol = self.arena.symbol(&name.text);
            self.names.declare(&mut self.reader, &name, NameKind::Speed, Some(symbol));
            let what = format!("speed `{}`", shortened_for_message(&name.text));
            match self.reader.formula(value, &what) {
                Some(formula) => texts.push((name, formula)),
                None => self.names.mark_wrong_name(&name.text),
            }
        }
        for (name, formula) in &joints.speeds {
            let symbol = self.arena.symbol(&name.text);
            self.names.declare(&mut self.reader, name, NameKind::Speed, Some(symbol));
            texts.push((name.clone(), formula.clone()));
        }
        let expressions = self.expressions(table);
        for (name, formula) in &texts {
            let what = "the definition of a speed";
            // A speed has the unit of its definition. The definition is read here for its unit, since forces may
            // contain speeds.
            let e = self.names.formula(&mut self.reader, &mut self.arena, formula, VELOCITY, what);
            self.record_units_of_velocities();
            let unit = e.and_then(|e| self.unit_of(e, &formula.span));
            let symbol = self.arena.symbol(&name.text);
            self.units.extend(unit.map(|unit| (symbol, unit)));
        }
        // Units of expressions that contain speeds are known only here.
        for (e, span) in expressions {
            self.unit_of(e, &span);
        }
        texts
    }

    /// Reads the definitions of the speeds as terms. In them, terms replace named velocities, then variables that
    /// constraints determine.
    pub fn speeds(
        &mut self,
        texts: Vec<(Located, Located)>,
        velocities: &[(Expr, Expr)],
        replacements: &[(Expr, Expr)],
    ) -> Vec<(Speed, Range<usize>)> {
        let mut of_motion = Substitution::new(velocities);
        let mut fixed = Substitution::new(replacements);
        let mut speeds = Vec::new();
        for (name, formula) in texts {
            // Errors in a definition were already reported when the speed was declared.
            let mut scratch = TomlReader::new(self.reader.source);
            let Some(e) = self.names.formula(&mut scratch, &mut self.arena, &formula, VELOCITY, "a speed") else {
                continue;
            };
            let e = of_motion.apply(&mut self.arena, e);
            let definition = fixed.apply(&mut self.arena, e);
            let rate = self.arena.symbol(&format!("{}'", name.text));
            let symbol = self.arena.symbol(&name.text);
            let unit = self.units.get(&symbol).cloned().unwrap_or_default();
            speeds.push((Speed { name: name.text, symbol, rate, definition, unit }, formula.span));
        }
        speeds
    }

    /// Splits speeds into independent and dependent speeds. A speed of a joint is dependent if it follows from the
    /// constraints and earlier speeds. A speed of the section `[speeds]` is never dependent.
    ///
    /// Speeds along the coordinates in `fixed`, which constraints determine, are considered last. Such a coordinate
    /// may stand still while the mechanism moves.
    pub fn independent_speeds(
        &mut self,
        coordinates: &[Coordinate],
        fixed: &[(Expr, Expr)],
        speeds: Vec<(Speed, Range<usize>)>,
        joints: &Joints<'_>,
        ties: &MotionConstraints,
    ) -> ChosenSpeeds {
        let mut left_out = Vec::new();
        if let Some(chosen) = &ties.speeds {
            let mut stay = Vec::new();
            for (at, (speed, span)) in speeds.into_iter().enumerate() {
                if chosen.contains(&at) {
                    stay.push((speed, span));
                } else {
                    left_out.push(speed);
                }
            }
            return (stay, left_out);
        }
        let rates: Vec<Expr> = coordinates.iter().map(|c| c.rate).collect();
        let mut form = LinearForm::new(&rates);
        let (mut stay, mut brought): (Vec<_>, Vec<_>) =
            speeds.into_iter().partition(|(speed, _)| !joints.adds_joint_speed(speed));
        let mut row = |arena: &mut Arena, e: Expr| form.coefficients(arena, e).ok().map(|(row, _)| row);
        let equations = ties.motion.iter().map(|(c, _)| c.equation).chain(stay.iter().map(|(s, _)| s.definition));
        let rows: Option<Vec<_>> = equations.map(|e| row(&mut self.arena, e)).collect();
        let of_brought: Option<Vec<_>> = brought.iter().map(|(s, _)| row(&mut self.arena, s.definition)).collect();
        // A definition that is not linear is reported later, when the equations are solved for the rates.
        if let (Some(mut rows), Some(of_brought)) = (rows, of_brought) {
            let first = rows.len();
            rows.extend(of_brought);
            let is_fixed = |at: &usize| fixed.iter().any(|(_, value)| *value == brought[*at].0.definition);
            let (last, mut order): (Vec<usize>, Vec<usize>) = (0..brought.len()).partition(is_fixed);
            order.extend(last);
            let sorted = (0..first).chain(order.iter().map(|at| first + at));
            let mut rows: Vec<Vec<Expr>> = sorted.map(|at| rows[at].clone()).collect();
            while rows.len() > coordinates.len() {
                let Some(at) = rank(&self.arena, &rows).and_then(|found| found.dependent).filter(|at| *at >= first)
                else {
                    break;
                };
                rows.remove(at);
                order.remove(at - first);
            }
            let mut at = 0;
            brought.retain(|(speed, _)| {
                let stays = order.contains(&at);
                at += 1;
                if !stays {
                    left_out.push(speed.clone());
                }
                stays
            });
        }
        stay.append(&mut brought);
        (stay, left_out)
    }

    /// Solves u = J q̇ + d and A q̇ + a = 0 for the rates q̇. `None` after reporting speeds that are too few, too
    /// many, not linear in q̇ or not independent.
    pub fn kinematic_equations(
        &mut self,
        table: &DeTable<'_>,
        coordinates: &[Coordinate],
        speeds: &[(Speed, Range<usize>)],
        constraints: &[(MotionConstraint, Range<usize>)],
        point: Option<&PivotValues>,
    ) -> Option<KinematicEquations> {
        if coordinates.is_empty() || speeds.len() + constraints.len() != coordinates.len() {
            self.report_speed_count(table, coordinates, speeds, constraints);
            return None;
        }
        let before = self.reader.errors.len();
        let rates: Vec<Expr> = coordinates.iter().map(|c| c.rate).collect();
        let mut form = LinearForm::new(&rates);
        let (mut matrix, mut right) = (Vec::new(), Vec::new());
        for (constraint, _) in constraints {
            // The constraints were already found to be linear when they were read.
            let (row, rest) = form.coefficients(&mut self.arena, constraint.equation).ok()?;
            matrix.push(row);
            right.push(self.arena.neg(rest));
        }
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
                        shortened_for_message(&crate::algebra::text::print::print_text(
                            &self.arena,
                            not_linear.coefficient
                        )),
                    );
                    self.reader.error(span.clone(), message, "a generalized speed must read  u = Σ c_i(q) q_i' + d(q)");
                }
            }
        }
        if self.reader.errors.len() > before {
            return None;
        }
        let labels = SystemLabels {
            rows: constraints
                .iter()
                .map(|(c, _)| &c.name)
                .chain(speeds.iter().map(|(s, _)| &s.name))
                .cloned()
                .collect(),
            unknowns: coordinates.iter().map(|c| c.name.clone()).collect(),
            symbols: speeds.iter().map(|(s, _)| (s.symbol, s.name.clone())).collect(),
        };
        let labels = (!constraints.is_empty()).then_some(&labels);
        match solve_blocks(&mut self.arena, &mut Simplifier::default(), &matrix, &right, point, labels) {
            Ok((rates, divisors)) => {
                let divisors = divisors.iter().map(|e| contract_products(&mut self.arena, *e)).collect::<Vec<_>>();
                let divisors = self.speed_divisor_factors(&divisors, coordinates);
                let rates = if constraints.is_empty() {
                    rates
                } else {
                    self.name_speed_coefficients(coordinates, speeds, &rates)
                };
                Some(KinematicEquations { rates, divisors, has_dependent_speeds: false })
            }
            Err(singular) => {
                // The constraints come first and are independent, so the singular row is that of a speed.
                let (speed, span) = &speeds[singular.row.saturating_sub(constraints.len())];
                let message = if constraints.is_empty() {
                    format!(
                        "the speeds are not independent: rank {} of {}; `{}` follows from the others",
                        singular.rank,
                        speeds.len(),
                        speed.name
                    )
                } else {
                    format!(
                        "the speeds are not independent: `{}` follows from the others and the constraints",
                        speed.name
                    )
                };
                self.reader.error(span.clone(), message, "the speeds must determine every q' uniquely");
                None
            }
        }
    }

    /// Gives names to the coefficients of W and w in q̇ = W u + w that divide by sums. For example, `ratio_q2_u1` is
    /// the factor of u1 in q2', up to a constant factor. Without names, loop equations would grow with every product
    /// of these coefficients.
    fn name_speed_coefficients(
        &mut self,
        coordinates: &[Coordinate],
        speeds: &[(Speed, Range<usize>)],
        rates: &[Expr],
    ) -> Vec<Expr> {
        let symbols: Vec<Expr> = speeds.iter().map(|(speed, _)| speed.symbol).collect();
        let mut form = LinearForm::new(&symbols);
        let mut simplifier = Simplifier::default();
        let mut named = |arena: &mut Arena, e: Expr, name: String| {
            let e = simplifier.simplify(arena, e);
            let e = contract_products(arena, e);
            if divides_by_sum(arena, e) { arena.name(e, &name) } else { e }
        };
        let mut result = Vec::new();
        for (rate, coordinate) in rates.iter().zip(coordinates) {
            let Ok((row, rest)) = form.coefficients(&mut self.arena, *rate) else {
                result.push(*rate);
                continue;
            };
            let mut terms = vec![named(&mut self.arena, rest, format!("drift_{}", coordinate.name))];
            for (coefficient, (speed, _)) in row.into_iter().zip(speeds) {
                let by = named(&mut self.arena, coefficient, format!("ratio_{}_{}", coordinate.name, speed.name));
                terms.push(self.arena.mul(by, speed.symbol));
            }
            result.push(self.arena.sum(&terms));
        }
        result
    }

    /// Factors of divisors that contain coordinates, without repetition. A factor without coordinates, such as a
    /// length, does not vanish during a motion.
    pub(super) fn speed_divisor_factors(&self, divisors: &[Expr], coordinates: &[Coordinate]) -> Vec<Expr> {
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

    /// Reports that the numbers of speeds, constraints and coordinates do not fit together.
    fn report_speed_count(
        &mut self,
        table: &DeTable<'_>,
        coordinates: &[Coordinate],
        speeds: &[(Speed, Range<usize>)],
        constraints: &[(MotionConstraint, Range<usize>)],
    ) {
        if coordinates.is_empty() {
            let place = table.iter().find(|(key, _)| key.get_ref() == "constraints").map(|(key, _)| key.span());
            let message = "the constraints fix every coordinate: there is no state";
            let help = "leave one of the speeds out, and start its coordinate at the wanted value";
            self.reader.error(place.unwrap_or_default(), message, help);
            return;
        }
        let (n, m) = (speeds.len(), coordinates.len());
        let plural = |n: usize| if n == 1 { "" } else { "s" };
        let section = table.iter().find(|(key, _)| key.get_ref() == "speeds").map(|(key, _)| key.span());
        let needed = m.saturating_sub(constraints.len());
        let surplus = speeds.get(needed).and_then(|(speed, _)| self.names.span(&speed.name));
        let names: Vec<&str> = coordinates.iter().take(20).map(|c| c.name.as_str()).collect();
        let names = names.join(", ");
        let held: Vec<String> = constraints.iter().take(20).map(|(c, _)| format!("`{}`", c.name)).collect();
        let place = surplus.or(section).unwrap_or_default();
        let (message, help) = if constraints.is_empty() {
            let message =
                format!("{n} speed{} for {m} generalized coordinate{}: the numbers must agree", plural(n), plural(m));
            let help = format!(
                "define one speed for each coordinate that no constraint fixes ({names}); constraints on velocities, each of which \
                 takes a speed away, stand under [constraints] and [rolling]"
            );
            (message, help)
        } else if needed == 0 {
            let count = constraints.len();
            let message =
                format!("{count} motion constraint{} on {m} coordinate{}: nothing can move", plural(count), plural(m));
            let other = format!("leave one of {} out", held.join(", "));
            let help = if count == m { format!("define no speed, since all rates follow, or {other}") } else { other };
            (message, help)
        } else {
            let count = constraints.len();
            let message = format!(
                "{n} speed{} for {m} generalized coordinates and {count} motion constraint{}: {needed} {} left",
                plural(n),
                plural(count),
                if needed == 1 { "is" } else { "are" }
            );
            let help = format!(
                "define {needed} speed{} that the constraints ({}) leave independent; the other rates of {names} follow",
                plural(needed),
                held.join(", ")
            );
            (message, help)
        };
        self.reader.error(place, message, help);
    }
}

/// True if a term has a divisor that is a sum.
fn divides_by_sum(arena: &Arena, e: Expr) -> bool {
    let is_sum =
        |e: &Expr| matches!(arena.node(*e), Node::Sum(constant, terms) if !constant.is_zero() || terms.len() > 1);
    divisors(arena, &[e]).iter().any(is_sum)
}
