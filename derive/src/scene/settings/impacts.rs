//! Impacts of a scene: contacts at which bodies meet and part, their restitution, and friction along the contacts.
//!
//! Contacts and the energy lost in a collision are assumptions of a scene about its mechanism. They change neither
//! the equations of the model nor the hash of these equations.

use crate::algebra::term::calculus::Differential;
use crate::algebra::text::parse::{InteractionName, VelocityName, VelocityOf, parse_with_quantities};
use crate::algebra::{Arena, Expr};
use crate::diagnostic::nearest_name_advice;
use crate::model::TIME;
use crate::scene::numbers::named_positions::Places;
use crate::scene::numbers::number_reader::ValueReader;
use crate::scene::numbers::scene_number::Number;
use crate::toml_reader::Located;
use toml::Spanned;
use toml::de::{DeTable, DeValue};
use tripos_traits::DoubleDouble;

/// Kind of formula that a contact states: its gap, or a velocity along the contact.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ContactFormula {
    /// Distance between the bodies at the contact.
    Gap,
    /// Velocity of slip along the contact.
    Slip,
}

/// Values that a coefficient of a contact may have, with the message and advice about any other value.
struct PermittedCoefficient<'p> {
    /// Test of a value: true if the value is permitted.
    may_be: &'p dyn Fn(f64) -> bool,
    /// Fault of a value that is not permitted, for the error message, such as "below 0".
    wrong: &'p str,
    /// Advice for a value that is not permitted.
    help: &'p str,
}

/// Law of restitution at impacts. It gives the part of the closing velocity, or of the impulse of compression, that
/// is returned.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ImpactLaw {
    /// Newton's law: the normal velocity after the impact is −e times the normal velocity before it, or greater if
    /// other contacts push.
    #[default]
    Newton,
    /// Poisson's law: the impulse of expansion is e times the impulse of compression.
    Poisson,
}

impl ImpactLaw {
    /// Names of the laws of restitution in scene files.
    pub const NAMES: [&str; 2] = ["newton", "poisson"];
}

/// Contact in a scene, at which two bodies can meet and part again.
#[derive(Clone, Debug)]
pub struct ImpactContact {
    /// Name of the contact in the scene file.
    pub name: String,
    /// Gap of the contact as a term in parameters and coordinates, m: positive if the bodies are apart,
    /// 0 if they touch.
    pub gap: Expr,
    /// Time derivative of the gap as a term in parameters, q and q̇, m/s.
    pub rate: Expr,
    /// Velocities along the contact that are zero while the contact is closed, as terms in parameters,
    /// q, q̇ and u. Empty if the contact can slip.
    pub slips: Vec<Expr>,
    /// Coulomb friction of the contact; `None` without friction. A contact with friction has no
    /// `slips`.
    pub friction: Option<ContactFriction>,
    /// Coefficient of restitution of the contact, from 0 to 1.
    pub restitution: f64,
    /// Coefficient of restitution to 32 digits; the double itself if no more digits are known.
    pub restitution_extended: DoubleDouble,
    /// Law of restitution at the contact. All contacts of a scene have the same law.
    pub law: ImpactLaw,
}

/// Coulomb friction at a contact: the friction force is at most the coefficient times the normal
/// force.
#[derive(Clone, Debug)]
pub struct ContactFriction {
    /// Velocity at which the contact slips, m/s, as a term in parameters, q, q̇ and u. It is linear in q̇ and u.
    pub along: Expr,
    /// Coefficient of friction, 0 or more.
    pub coefficient: f64,
    /// Coefficient of friction to 32 digits; the double itself if no more digits are known.
    pub coefficient_extended: DoubleDouble,
}

/// Coefficients of restitution and friction of a contact, at the parameter values of a scene.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Coefficients {
    /// Coefficient of restitution, from 0 to 1.
    restitution: Number,
    /// Coefficient of friction; `None` if the contact has no friction.
    friction: Option<Number>,
}

impl ImpactContact {
    /// Copy of the contact with the given coefficients of restitution and friction.
    pub(in crate::scene) fn with_coefficients(&self, of: &Coefficients) -> Self {
        let friction = self.friction.as_ref().zip(of.friction.as_ref()).map(|(own, mu)| ContactFriction {
            coefficient: mu.double,
            coefficient_extended: mu.extended(),
            ..own.clone()
        });
        let (restitution, restitution_extended) = (of.restitution.double, of.restitution.extended());
        Self { friction, restitution, restitution_extended, ..self.clone() }
    }
}

/// Largest number of contacts in a scene. At an impact, all subsets of the contacts are searched for those that push.
const MOST: usize = 10;
/// Largest number of contacts with friction in a scene. The search for their motion tries all combinations of
/// sticking, slipping in either direction and opening.
const MOST_ROUGH: usize = 4;
/// Key of the section of a scene file that states contacts.
const IMPACTS: &str = "impacts";

impl<'a> ValueReader<'a, '_> {
    /// Reads the coefficients of all contacts, in the order of the scene file, at the given parameter
    /// values. Wrong values are reported.
    pub(in crate::scene) fn impact_coefficients(
        &mut self,
        table: &'a DeTable<'a>,
        parameters: &[Number],
    ) -> Vec<Coefficients> {
        let Some(section) = table.get(IMPACTS).and_then(|value| value.get_ref().as_table()) else { return Vec::new() };
        let mut list = Vec::new();
        for (name, value) in self.reader.entries(section) {
            let Some(entry) = value.get_ref().as_table() else { continue };
            let stated =
                self.reader.required(entry, "restitution", &format!("the contact `{}`", name.text), &name.span);
            let restitution = stated.and_then(|value| {
                let may_be = |e: f64| (0.0..=1.0).contains(&e);
                let help = "0 takes all of the closing velocity away, 1 gives all of it back";
                let permitted = PermittedCoefficient { may_be: &may_be, wrong: "not from 0 to 1", help };
                self.impact_coefficient(value, "restitution", &name.text, parameters, &permitted)
            });
            let friction = self.reader.get(entry, "friction").and_then(|value| {
                let may_be = |mu: f64| mu >= 0.0 && mu.is_finite();
                let help = "friction takes energy: its coefficient is 0 or more";
                let permitted = PermittedCoefficient { may_be: &may_be, wrong: "below 0", help };
                self.impact_coefficient(value, "friction", &name.text, parameters, &permitted)
            });
            list.push(Coefficients { restitution: restitution.unwrap_or_else(|| Number::from_double(0.0)), friction });
        }
        list
    }

    /// Reads a coefficient of a contact, whose name in the file is `key`. A value that is not permitted is reported.
    /// `None` if the coefficient has no value.
    fn impact_coefficient(
        &mut self,
        value: &'a Spanned<DeValue<'a>>,
        key: &str,
        contact: &str,
        parameters: &[Number],
        permitted: &PermittedCoefficient<'_>,
    ) -> Option<Number> {
        let PermittedCoefficient { may_be, wrong, help } = permitted;
        let quoted = format!("`{key}`");
        let formula = self.reader.formula(value, &quoted)?;
        let number = self.number(&formula, parameters, &quoted)?;
        if !may_be(number.double) {
            let message = format!("the {key} of `{contact}` is {}, {wrong}", number.double);
            self.reader.error(formula.span.clone(), message, *help);
        }
        Some(number)
    }

    /// Reads the contacts `[impacts.NAME]` of a scene. `coefficients` are those of the contacts, in their order.
    /// Wrong contacts are reported.
    pub(in crate::scene) fn impacts(
        &mut self,
        table: &'a DeTable<'a>,
        coefficients: &[Coefficients],
    ) -> Vec<ImpactContact> {
        let Some(section) = self.section(table, IMPACTS) else { return Vec::new() };
        let (mut places, mut list) = (Places::default(), Vec::<ImpactContact>::new());
        let entries = self.reader.entries(section);
        if let Some((name, _)) = entries.get(MOST) {
            let message = format!("the scene has {} contacts, more than {MOST}", entries.len());
            self.reader.error(name.span.clone(), message, "leave out those that are not met");
        }
        let none = Coefficients { restitution: Number::from_double(0.0), friction: None };
        for ((name, value), own) in entries.into_iter().zip(coefficients.iter().chain(std::iter::repeat(&none))) {
            let what = format!("the contact `{}`", name.text);
            let Some(entry) =
                self.reader.table(value, &what, "[impacts.NAME] with gap = \"…\" and restitution = \"…\"")
            else {
                continue;
            };
            self.reader.report_unknown_keys(
                entry,
                &what,
                &["gap", "restitution", "law", "no_slip", "friction", "along", "about"],
            );
            let law = match self.choice(Some(entry), "law", &ImpactLaw::NAMES) {
                Some("poisson") => ImpactLaw::Poisson,
                _ => ImpactLaw::Newton,
            };
            if list.first().is_some_and(|first| first.law != law) {
                let help = "impulses of one instant follow from all contacts together: state one law for all of them";
                self.reader.error(name.span.clone(), format!("{what} has another law than those before it"), help);
            }
            let gap = self.reader.required(entry, "gap", &what, &name.span);
            let gap = gap.and_then(|value| self.reader.formula(value, "`gap`"));
            let gap = gap.and_then(|formula| self.gap(&mut places, &formula));
            let slips = self.impact_no_slip_velocities(&mut places, entry);
            if law == ImpactLaw::Poisson && !slips.is_empty() {
                let help = "leave `no_slip` out, or take law = \"newton\"";
                self.reader.error(
                    name.span.clone(),
                    format!("{what} does not slip, which Poisson's law says nothing of"),
                    help,
                );
            }
            let friction = self.friction(&mut places, &name, entry, own.friction.as_ref());
            if friction.is_some() && list.iter().filter(|impact| impact.friction.is_some()).count() == MOST_ROUGH {
                let help = "give friction to those that matter most, or `no_slip` to those that do not slip";
                self.reader.error(name.span.clone(), format!("more than {MOST_ROUGH} contacts have friction"), help);
            }
            if let Some((gap, rate)) = gap {
                let (restitution, restitution_extended) = (own.restitution.double, own.restitution.extended());
                list.push(ImpactContact {
                    name: name.text,
                    gap,
                    rate,
                    slips,
                    friction,
                    restitution,
                    restitution_extended,
                    law,
                });
            }
        }
        list
    }

    /// Reads the friction of a contact: `friction = "mu"` with `along = "v(A) @ N [1]"`. `None` if the contact has no
    /// friction, or after an error is reported.
    fn friction(
        &mut self,
        places: &mut Places,
        name: &Located,
        entry: &'a DeTable<'a>,
        coefficient: Option<&Number>,
    ) -> Option<ContactFriction> {
        let (friction, along) = (self.reader.get(entry, "friction"), self.reader.get(entry, "along"));
        if let (Some(value), true) = (friction, entry.get("no_slip").is_some()) {
            let message = format!("the contact `{}` has friction of a coefficient, and does not slip", name.text);
            self.reader.error(value.span(), message, "leave `no_slip` out, or `friction` with `along`");
            return None;
        }
        let along = match (friction, along) {
            (None, None) => return None,
            (Some(value), None) => {
                let help = "add along = \"v(A) @ N [1]\", the velocity at which the contact slips";
                let message = format!("the friction of `{}` needs the velocity along which it acts", name.text);
                self.reader.error(value.span(), message, help);
                return None;
            }
            (None, Some(value)) => {
                let message = format!("`along` of the contact `{}` has no friction to go with", name.text);
                self.reader.error(value.span(), message, "add friction = 0.3, or leave `along` out");
                return None;
            }
            (Some(_), Some(value)) => self.reader.formula(value, "`along`")?,
        };
        let slip = self.slip_velocity(places, &along)?;
        let mu = coefficient?;
        Some(ContactFriction { along: slip, coefficient: mu.double, coefficient_extended: mu.extended() })
    }

    /// Reads a velocity along a contact, which must be linear in rates and speeds. `None` after an
    /// error is reported.
    fn slip_velocity(&mut self, places: &mut Places, formula: &Located) -> Option<Expr> {
        let slip = self.contact_formula(places, formula, ContactFormula::Slip)?;
        let model = &mut *self.model;
        let moving: Vec<Expr> = model.coordinates.iter().map(|c| c.rate).chain(model.u()).collect();
        let arena = &mut model.arena;
        if !moving.iter().any(|symbol| arena.mentions(slip, *symbol)) {
            let message = "this formula must be a velocity, and contains no speed";
            self.reader.error(formula.span.clone(), message, "write a velocity, such as \"v(A) @ N [1]\"");
            return None;
        }
        let slopes: Vec<Expr> = moving.iter().map(|symbol| Differential::partial(*symbol).apply(arena, slip)).collect();
        if slopes.iter().any(|slope| moving.iter().any(|symbol| arena.mentions(*slope, *symbol))) {
            let message = "a velocity along a contact must be linear in speeds";
            self.reader.error(formula.span.clone(), message, "write a velocity, such as \"v(A) @ N [1]\"");
            return None;
        }
        Some(slip)
    }

    /// Reads the gap of a contact. Returns the gap and its time derivative as terms; `None` after an
    /// error is reported.
    fn gap(&mut self, places: &mut Places, formula: &Located) -> Option<(Expr, Expr)> {
        let gap = self.contact_formula(places, formula, ContactFormula::Gap)?;
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

    /// Reads the velocities that are zero while a contact is closed, such as `no_slip = ["v(A) @ N [1]"]`. Empty if
    /// the key is absent.
    fn impact_no_slip_velocities(&mut self, places: &mut Places, entry: &'a DeTable<'a>) -> Vec<Expr> {
        let Some(value) = self.reader.get(entry, "no_slip") else { return Vec::new() };
        let DeValue::Array(array) = value.get_ref() else {
            let help = "write no_slip = [\"v(A) @ N [1]\"], the velocities along the contact";
            self.reader.error(value.span(), "`no_slip` must be a list of velocities", help);
            return Vec::new();
        };
        let mut list = Vec::new();
        for entry in array {
            let Some(formula) = self.reader.formula(entry, "a velocity") else { continue };
            list.extend(self.slip_velocity(places, &formula));
        }
        list
    }

    /// Reads a formula that a contact states, in parameters, coordinates and positions. A slip velocity may also
    /// contain rates, speeds and velocities. `None` after an error is reported.
    fn contact_formula(&mut self, places: &mut Places, formula: &Located, kind: ContactFormula) -> Option<Expr> {
        let with_rates = kind == ContactFormula::Slip;
        let model = &mut *self.model;
        let mut arena = std::mem::take(&mut model.arena);
        let mut known: Vec<(String, Expr)> = model.parameters.iter().map(|p| (p.name.clone(), p.symbol)).collect();
        known.extend(model.coordinates.iter().map(|c| (c.name.clone(), c.symbol)));
        known.extend(model.constraints.iter().map(|c| (c.fixes.clone(), c.value)));
        if with_rates {
            known.extend(model.coordinates.iter().map(|c| (format!("{}'", c.name), c.rate)));
            known.extend(model.speeds.iter().map(|s| (s.name.clone(), s.symbol)));
        }
        let what = if with_rates { "a velocity along a contact" } else { "a gap" };
        let mut resolve = |_: &mut Arena, name: &str| {
            if let Some((_, e)) = known.iter().find(|(known, _)| known == name) {
                return Ok(*e);
            }
            let help = if name == TIME {
                "nothing in the model names `t`: let a point of it move in time, and take its position".to_owned()
            } else {
                nearest_name_advice(name, known.iter().map(|(known, _)| known.as_str()))
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
