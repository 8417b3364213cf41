//! Contacts of a scene: where bodies meet, how they part, and what holds them from slipping.
//!
//! Which contacts matter and how much a collision costs is what a scene supposes of its mechanism: the equations of the model stay
//! what they are, and so does their hash.

use super::places::Places;
use super::values::{Number, Values};
use crate::algebra::calculus::Differential;
use crate::algebra::parse::{InteractionName, VelocityName, VelocityOf, parse_with_quantities};
use crate::algebra::{Arena, Expr};
use crate::diagnostic::nearest;
use crate::model::TIME;
use crate::read::Located;
use toml::de::{DeTable, DeValue};
use tripos_traits::DoubleDouble;

/// How much of the closing velocity, or of the impulse of compression, comes back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ImpactLaw {
    /// Newton's: the normal velocity after is −e times the one before, or more where other contacts push.
    #[default]
    Newton,
    /// Poisson's: the impulse of expansion is e times that of compression.
    Poisson,
}

impl ImpactLaw {
    /// The names in scene files.
    pub const NAMES: [&str; 2] = ["newton", "poisson"];
}

/// A contact of a scene.
#[derive(Clone, Debug)]
pub struct Impact {
    /// Its name.
    pub name: String,
    /// The gap, in parameters and coordinates: positive apart, 0 where the bodies meet.
    pub gap: Expr,
    /// Its rate in parameters, q and q̇.
    pub rate: Expr,
    /// Velocities that no longer slip from the moment that the contact closes, in parameters, q, q̇ and u; none where it is smooth.
    pub slips: Vec<Expr>,
    /// The coefficient of restitution, from 0 to 1.
    pub restitution: f64,
    /// Its value to 32 digits, where they are known.
    pub restitution_extended: DoubleDouble,
    /// The law; one for all contacts of a scene.
    pub law: ImpactLaw,
}

impl Impact {
    /// This contact with another coefficient of restitution.
    pub(super) fn with(&self, restitution: &Number) -> Self {
        Self { restitution: restitution.double, restitution_extended: restitution.extended(), ..self.clone() }
    }
}

/// The most contacts of a scene: which of them push is looked for among all of their subsets.
const MOST: usize = 10;
/// The key of the section.
const IMPACTS: &str = "impacts";

impl<'a> Values<'a, '_> {
    /// The coefficients of restitution, in the order of the file, for these values of parameters.
    pub(super) fn restitutions(&mut self, table: &'a DeTable<'a>, parameters: &[Number]) -> Vec<Number> {
        let Some(section) = table.get(IMPACTS).and_then(|value| value.get_ref().as_table()) else { return Vec::new() };
        let mut list = Vec::new();
        for (name, value) in self.reader.entries(section) {
            let Some(entry) = value.get_ref().as_table() else { continue };
            let stated = self.reader.need(entry, "restitution", &format!("the contact `{}`", name.text), &name.span);
            let formula = stated.and_then(|value| self.reader.formula(value, "`restitution`"));
            let number = formula.as_ref().and_then(|f| Some((f, self.number(f, parameters, "`restitution`")?)));
            if let Some((formula, e)) = number.as_ref().filter(|(_, e)| !(0.0..=1.0).contains(&e.double)) {
                let help = "0 takes all of the closing velocity away, 1 gives all of it back";
                self.reader.error(
                    formula.span.clone(),
                    format!("the restitution of `{}` is {}, not from 0 to 1", name.text, e.double),
                    help,
                );
            }
            list.push(number.map_or_else(|| Number::rounded(0.0), |(_, e)| e));
        }
        list
    }

    /// Reads `[impacts.NAME]`, with coefficients of restitution that were read before, for a start at these values.
    pub(super) fn impacts(&mut self, table: &'a DeTable<'a>, restitutions: &[Number]) -> Vec<Impact> {
        let Some(section) = self.section(table, IMPACTS) else { return Vec::new() };
        let (mut places, mut list) = (Places::default(), Vec::<Impact>::new());
        let entries = self.reader.entries(section);
        if let Some((name, _)) = entries.get(MOST) {
            let message = format!("the scene has {} contacts, more than {MOST}", entries.len());
            self.reader.error(name.span.clone(), message, "leave out those that are not met");
        }
        for ((name, value), restitution) in
            entries.into_iter().zip(restitutions.iter().cloned().chain(std::iter::repeat(Number::rounded(0.0))))
        {
            let what = format!("the contact `{}`", name.text);
            let Some(entry) =
                self.reader.table(value, &what, "[impacts.NAME] with gap = \"…\" and restitution = \"…\"")
            else {
                continue;
            };
            self.reader.allow(entry, &what, &["gap", "restitution", "law", "no_slip", "about"]);
            let law = match self.choice(Some(entry), "law", &ImpactLaw::NAMES) {
                Some("poisson") => ImpactLaw::Poisson,
                _ => ImpactLaw::Newton,
            };
            if list.first().is_some_and(|first| first.law != law) {
                let help = "impulses of one instant follow from all contacts together: state one law for all of them";
                self.reader.error(name.span.clone(), format!("{what} has another law than those before it"), help);
            }
            let gap = self.reader.need(entry, "gap", &what, &name.span);
            let gap = gap.and_then(|value| self.reader.formula(value, "`gap`"));
            let gap = gap.and_then(|formula| self.gap(&mut places, &formula));
            let slips = self.slips(&mut places, entry);
            if law == ImpactLaw::Poisson && !slips.is_empty() {
                let help = "leave `no_slip` out, or take law = \"newton\"";
                self.reader.error(
                    name.span.clone(),
                    format!("{what} does not slip, which Poisson's law says nothing of"),
                    help,
                );
            }
            if let Some((gap, rate)) = gap {
                let (restitution, restitution_extended) = (restitution.double, restitution.extended());
                list.push(Impact { name: name.text, gap, rate, slips, restitution, restitution_extended, law });
            }
        }
        list
    }

    /// A gap and its rate.
    fn gap(&mut self, places: &mut Places, formula: &Located) -> Option<(Expr, Expr)> {
        let gap = self.contact_formula(places, formula, false)?;
        let model = &mut *self.model;
        if !model.coordinates.iter().any(|c| c.name != TIME && model.arena.mentions(gap, c.symbol)) {
            let help = "a gap is a formula of coordinates or positions, such as \"p(P) @ N [3] - R\"";
            self.reader.error(formula.span.clone(), "no coordinate changes this gap", help);
            return None;
        }
        let rates: Vec<_> = model.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        let rate = Differential::along(&rates).apply(&mut model.arena, gap);
        Some((gap, rate))
    }

    /// `no_slip = ["v(A) @ N [1]"]`.
    fn slips(&mut self, places: &mut Places, entry: &'a DeTable<'a>) -> Vec<Expr> {
        let Some(value) = self.reader.get(entry, "no_slip") else { return Vec::new() };
        let DeValue::Array(array) = value.get_ref() else {
            let help = "write no_slip = [\"v(A) @ N [1]\"], the velocities along the contact";
            self.reader.error(value.span(), "`no_slip` must be a list of velocities", help);
            return Vec::new();
        };
        let mut list = Vec::new();
        for entry in array {
            let Some(formula) = self.reader.formula(entry, "a velocity") else { continue };
            let Some(slip) = self.contact_formula(places, &formula, true) else { continue };
            let model = &*self.model;
            let moving = model.coordinates.iter().map(|c| c.rate).chain(model.u());
            if !moving.clone().any(|symbol| model.arena.mentions(slip, symbol)) {
                let message = "what does not slip is a velocity, and no speed is in this";
                self.reader.error(formula.span.clone(), message, "write a velocity, such as \"v(A) @ N [1]\"");
                continue;
            }
            list.push(slip);
        }
        list
    }

    /// A formula in parameters, coordinates and positions, and, `with_rates`, in rates, speeds and velocities.
    fn contact_formula(&mut self, places: &mut Places, formula: &Located, with_rates: bool) -> Option<Expr> {
        let model = &mut *self.model;
        let mut arena = std::mem::take(&mut model.arena);
        let mut known: Vec<(String, Expr)> = model.parameters.iter().map(|p| (p.name.clone(), p.symbol)).collect();
        known.extend(model.coordinates.iter().map(|c| (c.name.clone(), c.symbol)));
        known.extend(model.constraints.iter().map(|c| (c.fixes.clone(), c.value)));
        if with_rates {
            known.extend(model.coordinates.iter().map(|c| (format!("{}'", c.name), c.rate)));
            known.extend(model.speeds.iter().map(|s| (s.name.clone(), s.symbol)));
        }
        let what = if with_rates { "a velocity that does not slip" } else { "a gap" };
        let mut resolve = |_: &mut Arena, name: &str| {
            if let Some((_, e)) = known.iter().find(|(known, _)| known == name) {
                return Ok(*e);
            }
            let help = if name == TIME {
                "nothing in the model names `t`: let a point of it move in time, and take its position".to_owned()
            } else {
                nearest(name, known.iter().map(|(known, _)| known.as_str()))
            };
            Err((format!("`{name}` cannot stand in {what}"), Some(help)))
        };
        let mut component = |arena: &mut Arena, name: &VelocityName<'_>| {
            if !with_rates && !matches!(name.of, VelocityOf::Place(_)) {
                let help = "a gap is made of coordinates and positions".to_owned();
                return Err((format!("the velocity `{}` cannot stand in a gap", name.text()), Some(help)));
            }
            places.component(model, arena, name)
        };
        let mut interaction = |_: &mut Arena, name: &InteractionName<'_>| {
            let help = "contacts are made of places and velocities".to_owned();
            Err((format!("`{}` cannot stand in {what}", name.text()), Some(help)))
        };
        let result = parse_with_quantities(&mut arena, &formula.text, &mut resolve, &mut component, &mut interaction);
        model.arena = arena;
        match result {
            Ok(e) => self.reader.is_computable(&self.model.arena, formula, e).then_some(e),
            Err(error) => {
                self.reader.error(formula.part(error.span), error.message, error.help.unwrap_or_default());
                None
            }
        }
    }
}
