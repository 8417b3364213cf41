//! Configuration constraints: equations between coordinates, solved for a coordinate if possible. Reads all entries
//! of `[constraints]`.
//!
//! A coordinate for which a constraint is solved leaves the model. Each new solution is substituted into the earlier
//! solutions, so no solution contains a coordinate that left the model.
//!
//! A prescribed coordinate stays, with its constraint, if a potential depends on it. If a value replaced the
//! coordinate, the potential would depend on time alone there and exert no force. The power of the drive would then
//! lack the potential's part.

use super::constant_loops::KnownParameters;
use crate::algebra::solve::linear::LinearForm;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::text::print::length_up_to_names;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::diagnostic::Diagnostic;
use crate::geometry::Vector;
use crate::model::bodies::elements::Elements;
use crate::model::reading::declared_names::{MOTION, NameKind, TIME};
use crate::model::reading::loading::Loading;
use crate::model::{Constraint, Coordinate, Potential};
use crate::plain_text::with_significant_digits;
use crate::toml_reader::TomlReader;
use rustc_hash::FxHashSet;
use std::ops::Range;
use toml::de::DeTable;

/// Constraint of a model file as it was read, before it is solved for a coordinate.
pub struct StatedConstraint {
    /// Name of the constraint in the model file.
    pub name: String,
    /// Left side less right side of the constraint's equation: the term that the constraint makes zero.
    pub equation: Expr,
    /// Index of the reaction that enforces the constraint; `None` if the model file states none.
    pub enforced_by: Option<usize>,
    /// Byte range of the equation in the model file.
    pub span: Range<usize>,
    /// True if the equation may be redundant without an error; a redundant equation is then left out. False for an
    /// entry of `[constraints]`, whose redundancy is an error.
    pub may_repeat: bool,
}

impl StatedConstraint {
    /// The constraint with a substitution applied to its equation.
    pub fn substitute(self, arena: &mut Arena, put: &mut Substitution) -> Self {
        Self { equation: put.apply(arena, self.equation), ..self }
    }
}

/// Component of a vector that a closing joint makes zero. It is the left side of an equation between coordinates.
#[derive(Clone, Debug)]
pub struct Closure {
    /// Name of the joint that closes the loop.
    pub joint: String,
    /// Name of the equation.
    pub name: String,
    /// Vector between the two points of the joint, m, or unit vector along an axis of the joint.
    pub vector: Vector,
    /// Index of the frame along whose axis the component is taken.
    pub frame: usize,
    /// Axis of the frame: 0, 1 or 2.
    pub axis: usize,
}

impl Closure {
    /// True if both closures are components of one vector in one frame.
    pub fn is_beside(&self, other: &Self) -> bool {
        self.vector == other.vector && self.frame == other.frame
    }
}

impl<'a> Loading<'a> {
    /// Reads the section `[constraints]` of a model file. Errors are recorded in the reader.
    pub fn constraints(&mut self, table: &'a DeTable<'a>, elements: &Elements) -> Vec<StatedConstraint> {
        let mut stated = Vec::new();
        for (name, value) in self.section(table, "constraints", &[]) {
            let (value, enforced_by) = if value.get_ref().is_str() {
                // `NAME = "z = 0"` is the short form of an entry whose only key is the equation.
                self.names.declare(&mut self.reader, &name, NameKind::Constraint, None);
                (value, None)
            } else {
                let entry =
                    self.entry(&name, value, NameKind::Constraint, None, "\"z = 0\" or { equation = \"z = 0\" }");
                let Some((entry, what)) = entry else { continue };
                self.reader.report_unknown_keys(entry, "a constraint", &["equation", "enforced_by", "about"]);
                let enforced_by = self.enforced_by(entry, elements);
                let Some(value) = self.reader.required(entry, "equation", &what, &name.span) else { continue };
                (value, enforced_by)
            };
            let Some(text) = self.reader.string(value, "`equation`") else { continue };
            let help = "write the equation as \"z = 0\"";
            let Some((left, (_, right))) = self.split_relation(&text, &["="], help) else { continue };
            let what = "a constraint";
            let left = self.formula(&left, MOTION, what);
            let right = self.formula(&right, MOTION, what);
            let (Some(left), Some(right)) = (left, right) else { continue };
            self.record_units_of_velocities();
            if !self.have_same_unit(left, right, &text.span) {
                continue;
            }
            let equation = self.arena.sub(left, right);
            stated.push(StatedConstraint {
                name: name.text,
                equation,
                enforced_by,
                span: text.span,
                may_repeat: false,
            });
        }
        stated
    }

    /// Index of the reaction under the key `enforced_by`. `None` if the key is absent, or after an
    /// error is reported.
    fn enforced_by(&mut self, entry: &'a DeTable<'a>, elements: &Elements) -> Option<usize> {
        let value = self.reader.get(entry, "enforced_by")?;
        let reaction = self.reader.string(value, "`enforced_by`")?;
        let known = self.names.expect(&mut self.reader, &reaction, NameKind::Reaction);
        elements.reactions.iter().position(|r| known && r.name == reaction.text)
    }
}

/// Results of solving the constraints between coordinates.
pub struct SolvedConfiguration {
    /// Constraints that were solved for a coordinate.
    pub constraints: Vec<Constraint>,
    /// Replacements of the coordinates that constraints determine, and of their rates: (symbol, term that replaces
    /// it).
    pub replacements: Vec<(Expr, Expr)>,
    /// Constraints that could not be solved for a coordinate: loops and prescribed coordinates.
    pub kept: Vec<StatedConstraint>,
    /// Equations of closing joints without coordinates, which parameters fulfil at their default
    /// values.
    pub constant: Vec<StatedConstraint>,
    /// Names of redundant equations that were left out without an error.
    pub repeated: Vec<String>,
    /// Names of unsolved constraints of the model file that contain a single coordinate other than
    /// time.
    pub prescribing: Vec<String>,
    /// Coordinates that equations of closing joints determine.
    pub opened: OpenedCoordinates,
    /// Constraints that were solved for a coordinate as a function of time.
    pub drives: Vec<Drive>,
    /// Term of a solution that divides by zero once the solutions are substituted into one another. `None` if there
    /// is no such term.
    pub undefined: Option<Expr>,
}

/// Coordinates that equations of closing joints determine, and that would move freely if these
/// joints were open.
#[derive(Default)]
pub struct OpenedCoordinates {
    /// Symbols of the coordinates that equations of closing joints determine.
    pub symbols: Vec<Expr>,
    /// Symbols of the rates of the coordinates in [`Self::symbols`], in the same order.
    pub rates: Vec<Expr>,
    /// Coordinates and rates that the model file's own constraints determine, as (symbol, value). The values are
    /// terms in the remaining coordinates.
    pub before: Vec<(Expr, Expr)>,
}

/// Solves each constraint in turn for a coordinate, and removes this coordinate from the list. Reports constraints
/// that are always or never satisfied, at the default values `known` if only parameters decide it.
pub fn solve_configuration_constraints(
    reader: &mut TomlReader<'_>,
    arena: &mut Arena,
    coordinates: &mut Vec<Coordinate>,
    potentials: &[Potential],
    stated: Vec<StatedConstraint>,
    closures: &[Closure],
    known: &KnownParameters<'_>,
) -> SolvedConfiguration {
    let long = names_of_long_closures(arena, &stated, closures);
    let (mut solved, mut kept, mut repeated) = (Vec::<Constraint>::new(), Vec::new(), Vec::new());
    let mut constant = Vec::new();
    let mut undefined = None;
    let mut replacements: Vec<(Expr, Expr)> = Vec::new();
    let (mut prescribing, every) = (Vec::new(), configuration_symbols(coordinates));
    let (mut opened, mut drives) = (OpenedCoordinates::default(), Vec::new());
    for constraint in stated {
        let equation = Substitution::new(&replacements).apply(arena, constraint.equation);
        let all = configuration_symbols(coordinates);
        let mentions = |e: Expr| all.iter().any(|symbol| arena.mentions(e, *symbol));
        let depends = equation != constraint.equation && constraint.equation != Expr::ZERO;
        if zero_test(arena, equation) == ZeroTest::Zero {
            if constraint.may_repeat {
                repeated.push(constraint.name);
                continue;
            }
            let name = &constraint.name;
            let (message, help) = if depends {
                (format!("the constraint `{name}` follows from those before it"), "remove it")
            } else {
                let help = "remove it, or state a relation that restricts the coordinates";
                (format!("the constraint `{name}` is always fulfilled"), help)
            };
            reader.error(constraint.span, message, help);
            continue;
        }
        if !mentions(equation) && constraint.may_repeat {
            if coordinates.iter().any(|c| arena.mentions(equation, c.symbol)) {
                report_loop_in_time(reader, arena, &constraint, &drives);
                continue;
            }
            match known.gap(arena, equation).filter(|gap| *gap != 0.0) {
                Some(gap) => report_open_loop(reader, &constraint, gap, depends),
                None => constant.push(StatedConstraint { equation, ..constraint }),
            }
            continue;
        }
        if !mentions(equation) {
            report_constant_constraint(reader, &constraint, depends, arena.as_number(equation).is_some());
            continue;
        }
        let mut put = Substitution::new(&replacements);
        let energies: Vec<Expr> = potentials.iter().map(|potential| put.apply(arena, potential.energy)).collect();
        let solved_for = if long.contains(&constraint.name) {
            None
        } else {
            solve_configuration_constraint(arena, coordinates, &energies, equation)
        };
        let Some((at, solution)) = solved_for else {
            let named = every.iter().filter(|symbol| arena.mentions(constraint.equation, **symbol)).count();
            if named == 1 && !constraint.may_repeat {
                prescribing.push(constraint.name.clone());
            }
            kept.push(StatedConstraint { equation, ..constraint });
            continue;
        };
        let fixed = coordinates.remove(at);
        if coordinates.iter().any(|c| c.name == TIME && arena.mentions(solution, c.symbol)) {
            let (name, span) = (constraint.name.clone(), constraint.span.clone());
            drives.push(Drive { name, span, symbol: fixed.symbol });
        }
        // Equations of joints come after the constraints of the model file.
        if constraint.may_repeat {
            if opened.symbols.is_empty() {
                opened.before.clone_from(&replacements);
            }
            opened.symbols.push(fixed.symbol);
            opened.rates.push(fixed.rate);
        }
        let rates: Vec<_> = coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        let rate = Differential::along(&rates).apply(arena, solution);
        let mut earlier = Substitution::new(&[(fixed.symbol, solution), (fixed.rate, rate)]);
        let before = replacements.iter_mut().map(|(_, replacement)| replacement);
        for solution in before.chain(solved.iter_mut().map(|constraint| &mut constraint.value)) {
            *solution = earlier.apply(arena, *solution);
        }
        undefined = undefined.or(earlier.undefined);
        replacements.extend([(fixed.symbol, solution), (fixed.rate, rate)]);
        solved.push(Constraint {
            name: constraint.name,
            equation: constraint.equation,
            fixes: fixed.name,
            value: solution,
            enforced_by: constraint.enforced_by,
        });
    }
    SolvedConfiguration {
        constraints: solved,
        replacements,
        kept,
        constant,
        repeated,
        prescribing,
        opened,
        drives,
        undefined,
    }
}

/// Reports a constraint of the model file without coordinates. `depends` is true if constraints before it removed its
/// coordinates, and `is_number` if it contains no parameter either.
fn report_constant_constraint(
    reader: &mut TomlReader<'_>,
    constraint: &StatedConstraint,
    depends: bool,
    is_number: bool,
) {
    let name = &constraint.name;
    let (message, help) = if depends {
        (format!("the constraint `{name}` contradicts those before it"), "remove one of them")
    } else {
        let what = if is_number { "is never fulfilled" } else { "has no coordinate" };
        let help = "a holonomic constraint is an equation between coordinates";
        (format!("the constraint `{name}` {what}"), help)
    };
    reader.error(constraint.span.clone(), message, help);
}

/// A constraint that sets a coordinate as a function of time.
pub struct Drive {
    /// Name of the constraint.
    pub name: String,
    /// Byte range of the constraint in the model file.
    pub span: Range<usize>,
    /// Symbol of the coordinate that it sets.
    symbol: Expr,
}

/// Advice for a drive that other constraints hold.
pub(super) const HELD_DRIVE_ADVICE: &str = "let a joint of the loop move along with the drive, or remove the drive";

/// Message about the drive `name` that other constraints hold.
pub(super) fn held_drive_message(name: &str) -> String {
    format!("the drive `{name}` is held: the other joints and constraints fix what it is to move")
}

/// Reports an equation of a closing joint of which time alone is left, at the drive that brings time into it.
fn report_loop_in_time(reader: &mut TomlReader<'_>, arena: &Arena, constraint: &StatedConstraint, drives: &[Drive]) {
    if let Some(drive) = drives.iter().rev().find(|drive| arena.mentions(constraint.equation, drive.symbol)) {
        let error = Diagnostic::new(drive.span.clone(), held_drive_message(&drive.name), HELD_DRIVE_ADVICE);
        reader.errors.push(error.with_other(constraint.span.clone(), "this joint closes the loop"));
        return;
    }
    let name = &constraint.name;
    let message = format!("the joint cannot close its loop at all times: only time changes `{name}`, which must be 0");
    reader.error(constraint.span.clone(), message, "let a joint of the loop leave this direction free");
}

/// Reports an equation of a closing joint that no coordinate can fulfil, with its gap in SI units. `depends` is true if
/// constraints before it removed its coordinates.
fn report_open_loop(reader: &mut TomlReader<'_>, constraint: &StatedConstraint, gap: f64, depends: bool) {
    let (name, gap) = (&constraint.name, with_significant_digits(gap.abs(), 4));
    let (message, help) = if depends {
        (
            format!("the constraint `{name}` contradicts those before it: it is open by {gap} wherever they hold"),
            "correct the positions of the loop's joints, or remove one of the constraints",
        )
    } else {
        (
            format!("the joint cannot close its loop: `{name}` is open by {gap} in every pose"),
            "correct the positions of the loop's joints",
        )
    };
    reader.error(constraint.span.clone(), message, help);
}

/// Length of the equations of one closure above which they stay constraints, in printed nodes. Their solutions would
/// occur in the position of every body beyond the joint.
const LONG_CLOSURE: usize = 150;

/// Names of the equations of long closures. The components of one vector are all long or all short.
fn names_of_long_closures(arena: &Arena, stated: &[StatedConstraint], closures: &[Closure]) -> FxHashSet<String> {
    let length = |closure: &Closure| {
        let equation = stated.iter().find(|constraint| constraint.name == closure.name);
        equation.map_or(0, |constraint| length_up_to_names(arena, constraint.equation))
    };
    let is_long = |closure: &&Closure| {
        let beside = closures.iter().filter(|other| other.is_beside(closure));
        beside.map(length).fold(0, usize::saturating_add) > LONG_CLOSURE
    };
    closures.iter().filter(is_long).map(|closure| closure.name.clone()).collect()
}

/// Symbols of the coordinates, time excepted.
fn configuration_symbols(coordinates: &[Coordinate]) -> Vec<Expr> {
    coordinates.iter().filter(|c| c.name != TIME).map(|c| c.symbol).collect()
}

/// Solves an equation for the last coordinate that occurs in it linearly with a constant, nonzero factor. If the
/// equation contains time, coordinates that occur in `energies` are excluded. Returns (index of the coordinate, its
/// value); `None` if no coordinate fits.
fn solve_configuration_constraint(
    arena: &mut Arena,
    coordinates: &[Coordinate],
    energies: &[Expr],
    equation: Expr,
) -> Option<(usize, Expr)> {
    let is_driven = coordinates.iter().any(|c| c.name == TIME && arena.mentions(equation, c.symbol));
    // An equation is never solved for time.
    for (at, coordinate) in coordinates.iter().enumerate().rev().filter(|(_, c)| c.name != TIME) {
        if is_driven && energies.iter().any(|energy| arena.mentions(*energy, coordinate.symbol)) {
            continue;
        }
        let Ok((factors, rest)) = LinearForm::new(&[coordinate.symbol]).coefficients(arena, equation) else { continue };
        let constant = !coordinates.iter().any(|c| arena.mentions(factors[0], c.symbol));
        if constant && zero_test(arena, factors[0]) == ZeroTest::NonZero {
            let quotient = arena.div(rest, factors[0])?;
            return Some((at, arena.neg(quotient)));
        }
    }
    None
}
