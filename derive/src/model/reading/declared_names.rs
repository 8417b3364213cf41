//! Names of a model file: the kind of quantity that each name denotes, and the formulas in which each kind may occur.

use crate::algebra::text::parse::{
    InteractionName, VelocityName, VelocityOf, is_reserved_by_parser, parse_with_quantities,
};
use crate::algebra::value::zero_test::zero_divisor;
use crate::algebra::{Arena, Expr};
use crate::diagnostic::{Diagnostic, nearest_name_advice, shortened_for_message};
use crate::model::reactions::interactions::{GROUND, NamedReaction, StatedInteraction, named_reaction_unit};
use crate::model::units::Unit;
use crate::model::velocities::StatedVelocity;
use crate::toml_reader::{Located, TomlReader};
use rustc_hash::{FxHashMap, FxHashSet};
use std::cell::RefCell;
use std::ops::Range;

/// Kind of quantity or object that a name of a model file denotes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, PartialOrd, Ord)]
pub enum NameKind {
    /// Constant quantity with a unit.
    Parameter,
    /// Configuration variable q.
    Coordinate,
    /// Time derivative q' of a coordinate.
    Rate,
    /// Generalized speed u.
    Speed,
    /// Component of a velocity that a formula names, such as `v(P) @ N [1]`.
    Velocity,
    /// Component of a position that a formula names, such as `p(P) @ N [1]`.
    Position,
    /// Named formula of the section `[expressions]`.
    Expression,
    /// Signal that drives loads.
    Input,
    /// Unknown force or torque of a constraint or joint.
    Reaction,
    /// Reference frame.
    Frame,
    /// Point that is placed from another point.
    Point,
    /// Rigid body or particle.
    Body,
    /// Applied force, spring or friction.
    Force,
    /// Applied torque.
    Torque,
    /// Stated potential energy.
    Potential,
    /// Constraint, rolling contact or norm of Euler parameters.
    Constraint,
    /// Lagrange multiplier of a motion constraint.
    Multiplier,
    /// Condition of the domain in which the model holds.
    Condition,
}

impl NameKind {
    /// Noun for the kind in error messages, such as "parameter".
    pub fn noun(self) -> &'static str {
        match self {
            Self::Parameter => "parameter",
            Self::Coordinate => "coordinate",
            Self::Rate => "time derivative",
            Self::Speed => "speed",
            Self::Velocity => "velocity",
            Self::Position => "position",
            Self::Expression => "expression",
            Self::Input => "input",
            Self::Reaction => "reaction",
            Self::Frame => "frame",
            Self::Point => "point",
            Self::Body => "body",
            Self::Force => "force",
            Self::Torque => "torque",
            Self::Potential => "potential",
            Self::Constraint => "constraint",
            Self::Multiplier => "multiplier",
            Self::Condition => "condition",
        }
    }

    /// Plural noun for the kind in error messages, such as "parameters".
    fn plural(self) -> String {
        if self == Self::Velocity { "velocities".to_owned() } else { format!("{}s", self.noun()) }
    }
}

/// Kinds of quantities that a formula may contain. Numbers are always allowed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct AllowedQuantities(pub &'static [NameKind]);

/// Allows only numbers in a formula.
pub const CONSTANT: AllowedQuantities = AllowedQuantities(&[]);
/// Allows numbers and parameters in a formula.
pub const PARAMETERS: AllowedQuantities = AllowedQuantities(&[NameKind::Parameter]);
/// Allows parameters and coordinates, in formulas of positions and angles.
pub const CONFIGURATION: AllowedQuantities = AllowedQuantities(&[NameKind::Parameter, NameKind::Coordinate]);
/// Allows parameters, coordinates and positions, in formulas of potentials.
pub const PLACES: AllowedQuantities =
    AllowedQuantities(&[NameKind::Parameter, NameKind::Coordinate, NameKind::Position]);
/// Allows parameters, coordinates, their rates and velocities, in definitions of generalized
/// speeds.
pub const VELOCITY: AllowedQuantities =
    AllowedQuantities(&[NameKind::Parameter, NameKind::Coordinate, NameKind::Rate, NameKind::Velocity]);
/// Allows parameters, coordinates, their rates, speeds and velocities of points, in constraints.
pub const MOTION: AllowedQuantities = AllowedQuantities(&[
    NameKind::Parameter,
    NameKind::Coordinate,
    NameKind::Rate,
    NameKind::Speed,
    NameKind::Velocity,
]);
/// Allows the quantities of constraints and inputs, in formulas of loads.
pub const DRIVEN: AllowedQuantities = AllowedQuantities(&[
    NameKind::Parameter,
    NameKind::Coordinate,
    NameKind::Rate,
    NameKind::Speed,
    NameKind::Velocity,
    NameKind::Input,
]);
/// Allows every quantity that has a value during a run, in conditions of the domain.
pub const ANYTHING: AllowedQuantities = AllowedQuantities(&[
    NameKind::Parameter,
    NameKind::Coordinate,
    NameKind::Rate,
    NameKind::Speed,
    NameKind::Reaction,
    NameKind::Input,
]);

/// Name of time in formulas. Nothing else in a model may have this name.
pub const TIME: &str = "t";

/// Largest number of characters of a name, since it becomes an identifier in generated code.
const MAX_LENGTH: usize = 60;

/// All names of a model file, with their kinds and places.
///
/// Invariant: an error in a declaration is reported once, at the declaration. The name is then
/// marked as wrong, and everything that uses it fails silently.
#[derive(Default)]
pub struct Names {
    /// Declared names, each with its kind, the byte range of its declaration, and its symbol or term. The last is
    /// `None` for a kind without a symbol.
    known: FxHashMap<String, (NameKind, Range<usize>, Option<Expr>)>,
    /// Declared names in the order of declaration.
    order: Vec<String>,
    /// Names whose declaration is wrong. Their errors have been reported.
    spoiled: FxHashSet<String>,
    /// Kinds whose section could not be read. An unknown name may be of one of these kinds.
    unread: Vec<NameKind>,
    /// Name of the inertial frame; empty until it is read.
    pub root: String,
    /// Names that each named expression contains, with their kinds.
    made_of: FxHashMap<String, Vec<(String, NameKind)>>,
    /// Names to which a formula or an entry of the file refers.
    used: RefCell<FxHashSet<String>>,
    /// Velocities and positions that occur by name in formulas, without repetition.
    pub velocities: Vec<StatedVelocity>,
    /// Velocities that definitions of speeds name. They are checked once frames and points are declared.
    awaiting: Vec<StatedVelocity>,
    /// True once frames, points and bodies are declared, so that velocities can be checked.
    has_places: bool,
    /// True if the definition of a generalized speed contains a velocity by name.
    pub speeds_name_velocities: bool,
    /// Reactions that occur by name in formulas. They are resolved once reactions are found.
    pub reactions: Vec<NamedReaction>,
}

/// Error for a text that cannot be a name, because it is no identifier or is reserved. `None` if the text can be a
/// name.
pub fn not_a_name(name: &Located) -> Option<Diagnostic> {
    let text = &name.text;
    let is_valid = text.starts_with(|c: char| c.is_ascii_alphabetic())
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && text.len() <= MAX_LENGTH;
    if !is_valid {
        let message = format!("`{}` cannot be a name", shortened_for_message(text));
        let help = format!("a name is an ASCII letter and up to {} letters, digits and `_`", MAX_LENGTH - 1);
        return Some(Diagnostic::new(name.span.clone(), message, help));
    }
    let help = "choose another name: this one belongs to the expression language";
    (is_reserved_by_parser(text) || text == TIME || text == "deg")
        .then(|| Diagnostic::new(name.span.clone(), format!("`{text}` is reserved"), help))
}

impl Names {
    /// Declares a name of the given kind. Reports a name that is no identifier, is reserved, or is
    /// already declared.
    pub fn declare(&mut self, reader: &mut TomlReader<'_>, name: &Located, kind: NameKind, symbol: Option<Expr>) {
        let text = &name.text;
        let twice = || {
            let (other, span, _) = self.known.get(text)?;
            let message = format!("`{text}` is declared twice: as a {} and as a {}", other.noun(), kind.noun());
            let twice = Diagnostic::new(name.span.clone(), message, "rename one of the two");
            Some(twice.with_other(span.clone(), "first declared here"))
        };
        match not_a_name(name).or_else(twice) {
            Some(diagnostic) => {
                reader.errors.push(diagnostic);
                self.mark_wrong_name(text);
            }
            None => self.insert(text, kind, name.span.clone(), symbol),
        }
    }

    /// Declares a derived name such as `q1'`, without checks.
    pub fn insert(&mut self, text: &str, kind: NameKind, span: Range<usize>, symbol: Option<Expr>) {
        self.known.insert(text.to_owned(), (kind, span, symbol));
        self.order.push(text.to_owned());
    }

    /// Declares a derived name such as `q1'`, without checks, and marks it as used.
    pub fn insert_used(&mut self, text: &str, kind: NameKind, span: Range<usize>, symbol: Expr) {
        self.insert(text, kind, span, Some(symbol));
        self.used.borrow_mut().insert(text.to_owned());
    }

    /// Declares the name of a named expression with the term `e`. `parts` are all terms that occur in `e`.
    pub fn declare_expression(&mut self, reader: &mut TomlReader<'_>, name: &Located, e: Expr, parts: &[Expr]) {
        let is_part = |symbol: &Option<Expr>| symbol.is_some_and(|symbol| parts.contains(&symbol));
        let known = self.known.iter().filter(|(_, (kind, _, symbol))| *kind != NameKind::Expression && is_part(symbol));
        let mut made_of: Vec<(String, NameKind)> = known.map(|(name, (kind, ..))| (name.clone(), *kind)).collect();
        made_of.sort();
        self.made_of.insert(name.text.clone(), made_of);
        self.declare(reader, name, NameKind::Expression, Some(e));
    }

    /// Declares a frame or point that a joint adds. It counts as used, so that it is not reported as unused.
    pub fn declare_joint_name(&mut self, reader: &mut TomlReader<'_>, name: &Located, kind: NameKind) {
        self.declare(reader, name, kind, None);
        self.used.borrow_mut().insert(name.text.clone());
    }

    /// Marks a name, and the name of its rate, as wrongly declared. Its error must have been reported already.
    pub fn mark_wrong_name(&mut self, name: &str) {
        self.spoiled.insert(name.to_owned());
        self.spoiled.insert(format!("{name}'"));
    }

    /// Records that the names of the given kinds could not be read. The error must have been reported already.
    pub fn mark_unread_kinds(&mut self, kinds: &[NameKind]) {
        self.unread.extend(kinds);
    }

    /// True if an error that was already reported explains that `name` is not declared as one of `kinds`.
    fn is_already_reported(&self, name: &str, kinds: &[NameKind]) -> bool {
        self.spoiled.contains(name)
            || (!self.known.contains_key(name) && self.unread.iter().any(|kind| kinds.contains(kind)))
    }

    /// Declared names of the given kinds, in the order of declaration.
    pub fn names_of_kind(&self, kinds: &[NameKind]) -> Vec<&str> {
        self.order.iter().filter(|n| kinds.contains(&self.known[*n].0)).map(String::as_str).collect()
    }

    /// Symbols of all declared names of the given kinds, in no particular order.
    pub fn symbols_of(&self, kinds: &[NameKind]) -> Vec<Expr> {
        self.known.values().filter(|(kind, ..)| kinds.contains(kind)).filter_map(|(.., symbol)| *symbol).collect()
    }

    /// True if `name` is declared with the kind `kind`. Otherwise reports an error, unless an earlier error already
    /// explains it.
    pub fn expect(&self, reader: &mut TomlReader<'_>, name: &Located, kind: NameKind) -> bool {
        if self.is_already_reported(&name.text, &[kind]) {
            return false;
        }
        let message = match self.known.get(&name.text) {
            Some((found, _, _)) if *found == kind => {
                self.used.borrow_mut().insert(name.text.clone());
                return true;
            }
            Some((other, _, _)) => format!("`{}` is a {}, not a {}", name.text, other.noun(), kind.noun()),
            None => format!("there is no {} `{}`", kind.noun(), shortened_for_message(&name.text)),
        };
        reader.error_once(name.span.clone(), message, nearest_name_advice(&name.text, self.names_of_kind(&[kind])));
        false
    }

    /// Parameters, expressions, inputs, frames and points to which nothing in the file refers. Each is (noun of the
    /// kind, name), in the order of declaration.
    pub fn unused_declarations(&self) -> Vec<(&'static str, String)> {
        let used = self.used.borrow();
        let kinds = [NameKind::Parameter, NameKind::Expression, NameKind::Input, NameKind::Frame, NameKind::Point];
        let names = self.names_of_kind(&kinds).into_iter().filter(|name| !used.contains(*name));
        names.map(|name| (self.known[name].0.noun(), name.to_owned())).collect()
    }

    /// Named expressions in the order of declaration, as (name, term).
    pub fn expressions(&self) -> Vec<(String, Expr)> {
        let names = self.order.iter().filter(|name| self.known[*name].0 == NameKind::Expression);
        names.filter_map(|name| Some((name.clone(), self.known[name].2?))).collect()
    }

    /// Kind of a declared name; `None` if the name is not declared.
    pub fn kind(&self, name: &str) -> Option<NameKind> {
        self.known.get(name).map(|(kind, _, _)| *kind)
    }

    /// Byte range in the model file at which a name is declared; `None` if it is not declared.
    pub fn span(&self, name: &str) -> Option<Range<usize>> {
        self.known.get(name).map(|(_, span, _)| span.clone())
    }

    /// Byte range in the model file at which each name is declared, by name.
    pub fn places(&self) -> FxHashMap<String, Range<usize>> {
        self.known.iter().map(|(name, (_, span, _))| (name.clone(), span.clone())).collect()
    }

    /// Reads a formula that may contain only `allowed` quantities. `what` names the formula in error messages. `None`
    /// after an error is reported.
    pub fn formula(
        &mut self,
        reader: &mut TomlReader<'_>,
        arena: &mut Arena,
        formula: &Located,
        allowed: AllowedQuantities,
        what: &str,
    ) -> Option<Expr> {
        let (mut spoiled, mut unknown) = (false, false);
        let (mut velocities, mut found, mut interactions) = (Vec::new(), Vec::new(), Vec::new());
        let mut resolve = |arena: &mut Arena, name: &str| {
            if self.is_already_reported(name, allowed.0) {
                spoiled = true;
                return Ok(arena.symbol(name));
            }
            if let Some((symbol, unit)) = self.possible_reaction_name(arena, name, allowed) {
                found.push((symbol, name.to_owned(), unit));
                return Ok(symbol);
            }
            unknown = !self.known.contains_key(name);
            self.resolve(name, allowed, what)
        };
        let mut velocity = |arena: &mut Arena, name: &VelocityName<'_>| {
            let is_position = matches!(name.of, VelocityOf::Place(_)) && allowed.0.contains(&NameKind::Position);
            if !is_position && !allowed.0.contains(&NameKind::Velocity) {
                return Err(declared_name_not_allowed_message(NameKind::Velocity, &name.text(), allowed, what));
            }
            let mut name = name.clone();
            if name.frame.0.is_empty() {
                name.frame.0 = &self.root;
            }
            velocities.push(StatedVelocity::new(arena, formula, &name));
            Ok(arena.symbol(&name.text()))
        };
        let mut interaction = |arena: &mut Arena, name: &InteractionName<'_>| {
            if !allowed.0.contains(&NameKind::Reaction) {
                return Err(declared_name_not_allowed_message(NameKind::Reaction, &name.text(), allowed, what));
            }
            let stated = StatedInteraction::new(arena, formula, name);
            let symbol = stated.symbol;
            interactions.push(stated);
            Ok(symbol)
        };
        let result = parse_with_quantities(arena, &formula.text, &mut resolve, &mut velocity, &mut interaction);
        match result {
            Ok(_) if spoiled => None,
            Ok(e) => {
                self.record_declared_velocities(reader, velocities)?;
                self.record_declared_interactions(reader, interactions)?;
                let located = |name: String| Located { text: name, ..formula.clone() };
                self.reactions.extend(
                    found.into_iter().map(|(symbol, name, unit)| NamedReaction::Found(symbol, located(name), unit)),
                );
                let e = without_zero_divisor(reader, arena, formula, e)?;
                reader.is_computable(arena, formula, e).then_some(e)
            }
            Err(error) => {
                let (span, help) = (formula.part(error.span), error.help.unwrap_or_default());
                if unknown {
                    reader.error_once(span, error.message, help);
                } else {
                    reader.error(span, error.message, help);
                }
                None
            }
        }
    }

    /// Symbol and unit of a reaction that may be found later under the given name. `None` if the name is declared, if
    /// reactions are not `allowed`, or if no reaction can have this name.
    fn possible_reaction_name(
        &self,
        arena: &mut Arena,
        name: &str,
        allowed: AllowedQuantities,
    ) -> Option<(Expr, Unit)> {
        if !allowed.0.contains(&NameKind::Reaction) || self.known.contains_key(name) {
            return None;
        }
        let unit = named_reaction_unit(name, self.names_of_kind(&[NameKind::Body]).into_iter())?;
        // The symbol's name contains a space, which no declared symbol can have.
        Some((arena.symbol(&format!("reaction {name}")), unit))
    }

    /// Records the forces and torques between bodies that a formula names. `None` after reporting a name that is not
    /// declared.
    fn record_declared_interactions(
        &mut self,
        reader: &mut TomlReader<'_>,
        stated: Vec<StatedInteraction>,
    ) -> Option<()> {
        let knows_body = |name: &Located, reader: &mut TomlReader<'_>| {
            let is_ground =
                (name.text == GROUND || name.text == self.root) && self.kind(&name.text) != Some(NameKind::Body);
            is_ground || self.expect(reader, name, NameKind::Body)
        };
        let mut are_known = true;
        for name in &stated {
            let bodies = [&name.by, &name.on].into_iter().filter(|body| !knows_body(body, reader)).count();
            let point = name.about.as_ref().is_none_or(|point| self.expect(reader, point, NameKind::Point));
            are_known &= bodies == 0 && point && self.expect(reader, &name.frame, NameKind::Frame);
        }
        self.reactions.extend(stated.into_iter().filter(|_| are_known).map(NamedReaction::Between));
        are_known.then_some(())
    }

    /// Records the velocities that a formula names. `None` after reporting a name that is not declared.
    fn record_declared_velocities(&mut self, reader: &mut TomlReader<'_>, stated: Vec<StatedVelocity>) -> Option<()> {
        if !self.has_places {
            self.awaiting.extend(stated);
            return Some(());
        }
        let unknown = stated.iter().filter(|velocity| !self.are_velocity_names_declared(reader, velocity)).count();
        for velocity in stated {
            if unknown == 0 && self.velocities.iter().all(|other| other.symbol != velocity.symbol) {
                self.velocities.push(velocity);
            }
        }
        (unknown == 0).then_some(())
    }

    /// Velocities that definitions of speeds name and that are not yet checked. They are checked once frames and
    /// points are declared.
    pub fn undeclared_velocities(&self) -> &[StatedVelocity] {
        &self.awaiting
    }

    /// Checks and records the velocities that definitions of speeds name. Frames, points and bodies must be declared.
    /// Reports names that are not declared.
    pub fn check_awaiting_velocities(&mut self, reader: &mut TomlReader<'_>) {
        self.has_places = true;
        self.speeds_name_velocities = !self.awaiting.is_empty();
        let awaiting = std::mem::take(&mut self.awaiting);
        self.record_declared_velocities(reader, awaiting);
    }

    /// True if each name in a velocity is declared as the kind for which it is used. Reports every name that is not.
    fn are_velocity_names_declared(&self, reader: &mut TomlReader<'_>, velocity: &StatedVelocity) -> bool {
        let of: &[(&Located, NameKind)] = match &velocity.of {
            VelocityOf::Point(point) | VelocityOf::Place(point) => &[(point, NameKind::Point)],
            VelocityOf::Material(body, point) => &[(body, NameKind::Body), (point, NameKind::Point)],
            VelocityOf::Turning(body) if self.kind(&body.text) == Some(NameKind::Body) => &[(body, NameKind::Body)],
            VelocityOf::Turning(frame) => &[(frame, NameKind::Frame)],
        };
        let all = of.iter().copied().chain([(&velocity.frame, NameKind::Frame)]);
        all.filter(|(name, kind)| !self.expect(reader, name, *kind)).count() == 0
    }

    /// Term that a name in a formula denotes. Returns a message and advice if the name is unknown or its kind is not
    /// allowed.
    fn resolve(&self, name: &str, allowed: AllowedQuantities, what: &str) -> Result<Expr, (String, Option<String>)> {
        let plain = name.trim_end_matches('\'');
        match self.known.get(name) {
            Some((kind, _, Some(symbol))) if allowed.0.contains(kind) => {
                self.used.borrow_mut().insert(name.to_owned());
                Ok(*symbol)
            }
            Some((NameKind::Expression, _, Some(e))) => {
                let parts = self.made_of.get(name).map(Vec::as_slice).unwrap_or_default();
                match parts.iter().find(|(_, kind)| !allowed.0.contains(kind)) {
                    None => {
                        self.used.borrow_mut().insert(name.to_owned());
                        Ok(*e)
                    }
                    Some((part, kind)) => {
                        let (message, help) = declared_name_not_allowed_message(*kind, part, allowed, what);
                        Err((format!("{message}: it is in `{name}`"), help))
                    }
                }
            }
            Some((kind, _, _)) => Err(declared_name_not_allowed_message(*kind, name, allowed, what)),
            None if name == TIME => {
                Err((format!("time cannot stand in {what}"), Some("what has mass, and how much, stays".to_owned())))
            }
            None if ["deg", "degree", "degrees"].contains(&name) => Err((
                format!("unknown name `{name}`"),
                Some("angles are in radians: write 10 degrees as `10*pi/180`".to_owned()),
            )),
            None if self.known.get(plain).is_some_and(|(kind, _, _)| *kind != NameKind::Coordinate) => Err((
                format!("`{name}` does not exist: `{plain}` is a {}", self.known[plain].0.noun()),
                Some("a prime stands after coordinates only".to_owned()),
            )),
            None if named_reaction_unit(name, self.names_of_kind(&[NameKind::Body]).into_iter()).is_some() => {
                Err(declared_name_not_allowed_message(NameKind::Reaction, name, allowed, what))
            }
            None => Err((
                format!("unknown name `{}`", shortened_for_message(name)),
                Some(nearest_name_advice(name, self.names_of_kind(allowed.0))),
            )),
        }
    }
}

/// Message and advice for a name whose kind may not occur in a formula. `what` names the formula in the message.
fn declared_name_not_allowed_message(
    kind: NameKind,
    name: &str,
    allowed: AllowedQuantities,
    what: &str,
) -> (String, Option<String>) {
    let may: Vec<String> = allowed.0.iter().map(|kind| kind.plural()).collect();
    let may = if may.is_empty() { "numbers only".to_owned() } else { may.join(", ") };
    let message = format!("the {} `{name}` cannot stand in {what}", kind.noun());
    // A load may not depend on a reaction, which is a result of the motion.
    if kind == NameKind::Reaction && allowed.0.contains(&NameKind::Speed) {
        let why = "a reaction follows from the accelerations, which a load that depends on it would change";
        let help = "state the normal force as a formula of parameters and of the motion, such as `m*g`";
        return (format!("{message}: {why}"), Some(format!("{help}; allowed: {may}")));
    }
    (message, Some(format!("allowed: {may}")))
}

/// Returns the term `e`, unless it divides by an identically zero term, such as `cos(q)^2 + sin(q)^2 - 1`. In that
/// case reports an error and returns `None`.
fn without_zero_divisor(reader: &mut TomlReader<'_>, arena: &Arena, formula: &Located, e: Expr) -> Option<Expr> {
    let zero = zero_divisor(arena, e);
    let Some(zero) = zero else { return Some(e) };
    let message = format!(
        "division by zero: {} is zero",
        shortened_for_message(&crate::algebra::text::print::print_text(arena, zero))
    );
    reader.error(formula.span.clone(), message, "this divisor vanishes identically");
    None
}
