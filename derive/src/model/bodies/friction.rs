//! Dry friction that is smooth at rest: at a point of contact, and about an axis.
//!
//! Coulomb's law jumps where the slip changes sign. Here the resistance against the slip s is R(s) s/√(|s|² + s₀²).
//! It is within s₀²/(2|s|²) of Coulomb's law if |s| is well above s₀, and linear in s if |s| is well below s₀.
//!
//! The resistance R may be higher at rest (R_s) and fall with the slip by A. Stribeck's curve: R(s) = R + (R_s − R)
//! exp(−|s|²/s_S²). Source: B. Armstrong-Hélouvry, P. Dupont & C. Canudas de Wit, Automatica 30 (1994) 1083–1138.

use super::elements::Elements;
use super::mechanism_motion::MechanismMotion;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Function};
use crate::diagnostic::shortened_for_message;
use crate::geometry::Vector;
use crate::model::reading::declared_names::{AllowedQuantities, DRIVEN, NameKind, PARAMETERS};
use crate::model::reading::loading::Loading;
use crate::model::units::Unit;
use crate::model::{Force, ForcePlace, Torque};
use crate::toml_reader::Located;
use std::ops::Range;
use toml::de::DeTable;

/// Contact with friction between two bodies, or between a body and the ground.
enum FrictionContact {
    /// Contact at a point, between the material of the body in `on` and that of the body `against` or the ground. If
    /// `normal` is an axis of `frame`, friction acts only across this axis.
    Point { on: ForcePlace, against: Option<usize>, frame: usize, normal: Option<usize> },
    /// Contact of the body `on`, which rotates about `axis` of `frame`, with the body `against` or the ground.
    Axis { on: usize, against: Option<usize>, frame: usize, axis: usize },
}

/// Friction entry that is being read from the model file, as error messages name and locate it.
#[derive(Clone, Copy)]
struct FrictionEntry<'o> {
    /// Name of the friction entry in error messages, such as "friction `f`".
    what: &'o str,
    /// Byte range of the friction's name in the model file.
    span: &'o Range<usize>,
}

/// Law of resistance against slip at a contact.
#[derive(Clone, Copy)]
struct FrictionLaw {
    /// Resistance during sliding, N or N m.
    resistance: Expr,
    /// Resistance at rest, N or N m, and the slip s_S over which its excess decays, m/s or rad/s. `None` if the
    /// resistance at rest is not higher than during sliding.
    at_rest: Option<(Expr, Expr)>,
    /// Slip s₀, m/s or rad/s; well below it the resistance is linear in the slip.
    smoothing: Expr,
}

/// Friction entry as the model file states it, before it becomes a load.
pub struct StatedFriction {
    /// Name of the friction in the model file.
    name: Located,
    /// Bodies and place of the contact.
    contact: FrictionContact,
    /// Law of resistance against slip.
    law: FrictionLaw,
}

impl<'a> Loading<'a> {
    /// Reads the section `[friction]` of a model file: an entry `[friction.NAME]` for each contact.
    /// Errors are recorded in the reader.
    pub fn friction(&mut self, table: &'a DeTable<'a>, elements: &Elements) -> Vec<StatedFriction> {
        let mut list = Vec::new();
        for (name, value) in self.section(table, "friction", &[]) {
            let example = "[friction.NAME] with on = \"block\", coefficient = \"mu\", normal_force = \"m*g\" and smoothing = \"v0\"";
            let Some((entry, _)) = self.entry(&name, value, NameKind::Force, None, example) else { continue };
            let what = format!("friction `{}`", name.text);
            let owner = FrictionEntry { what: &what, span: &name.span };
            let found = if entry.contains_key("torque") {
                self.friction_about_axis(entry, elements, owner)
            } else {
                self.friction_at_point(entry, elements, owner)
            };
            if let Some((contact, law)) = found {
                list.push(StatedFriction { name, contact, law });
            }
        }
        list
    }

    /// Reads friction at a point of contact; `None` after an error is reported.
    fn friction_at_point(
        &mut self,
        entry: &'a DeTable<'a>,
        elements: &Elements,
        owner: FrictionEntry<'_>,
    ) -> Option<(FrictionContact, FrictionLaw)> {
        let FrictionEntry { what, span } = owner;
        let keys = [
            "on",
            "at",
            "against",
            "frame",
            "normal",
            "coefficient",
            "normal_force",
            "static",
            "stribeck",
            "smoothing",
            "about",
        ];
        self.reader.report_unknown_keys(entry, "friction", &keys);
        let on = elements.load_place(self, entry, "on", "at", what, span);
        let against = self.friction_against(entry, elements);
        let (frame, normal) = match self.reader.get(entry, "normal") {
            Some(axis) => (elements.frame(self, entry, what, span)?, Some(self.axis_number(axis)?)),
            None => (0, None),
        };
        let plain = Unit::default();
        let speed = Unit::new(1, 0, -1);
        let coefficient = self.required_quantity(entry, "coefficient", DRIVEN, &plain, owner);
        let load = self.required_quantity(entry, "normal_force", DRIVEN, &Unit::new(1, 1, -2), owner)?;
        let (coefficient, against, on) = (coefficient?, against?, on?);
        let resistance = self.arena.mul(coefficient, load);
        let at_rest = self.friction_at_rest(entry, &plain, &speed, owner)?;
        let at_rest = at_rest.map(|(coefficient, until)| (self.arena.mul(coefficient, load), until));
        let smoothing = self.smoothing(entry, &speed, owner)?;
        Some((FrictionContact::Point { on, against, frame, normal }, FrictionLaw { resistance, at_rest, smoothing }))
    }

    /// Reads friction about an axis; `None` after an error is reported.
    fn friction_about_axis(
        &mut self,
        entry: &'a DeTable<'a>,
        elements: &Elements,
        owner: FrictionEntry<'_>,
    ) -> Option<(FrictionContact, FrictionLaw)> {
        let FrictionEntry { what, span } = owner;
        let keys = ["on", "against", "frame", "axis", "torque", "static", "stribeck", "smoothing", "about"];
        self.reader.report_unknown_keys(entry, "friction about an axis", &keys);
        let on = self.reader.required(entry, "on", what, span)?;
        let on = self.reader.string(on, "`on`")?;
        let on = self.rigid_body_named(elements, &on)?;
        let against = self.friction_against(entry, elements)?;
        let frame = elements.frame(self, entry, what, span);
        let axis = self.reader.required(entry, "axis", what, span)?;
        let axis = self.axis_number(axis);
        let (moment, speed) = (Unit::new(2, 1, -2), Unit::new(0, 0, -1));
        let resistance = self.required_quantity(entry, "torque", DRIVEN, &moment, owner)?;
        let at_rest = self.friction_at_rest(entry, &moment, &speed, owner)?;
        let smoothing = self.smoothing(entry, &speed, owner)?;
        Some((
            FrictionContact::Axis { on, against, frame: frame?, axis: axis? },
            FrictionLaw { resistance, at_rest, smoothing },
        ))
    }

    /// Index of the rigid body that the key `against` of a friction entry names. `Some(None)` is the ground, if the
    /// key is absent. `None` after an error is reported.
    #[allow(clippy::option_option, reason = "no body is the ground, no answer an error")]
    fn friction_against(&mut self, entry: &'a DeTable<'a>, elements: &Elements) -> Option<Option<usize>> {
        let Some(value) = self.reader.get(entry, "against") else { return Some(None) };
        let name = self.reader.string(value, "`against`")?;
        self.rigid_body_named(elements, &name).map(Some)
    }

    /// Index of the rigid body with the given name; `None` after reporting a particle or an unknown name.
    fn rigid_body_named(&mut self, elements: &Elements, name: &Located) -> Option<usize> {
        let body = elements.body_named(self, name)?;
        if elements.bodies[body].rigid.is_some() {
            return Some(body);
        }
        let message = format!("`{}` is a particle", shortened_for_message(&name.text));
        self.reader.error(name.span.clone(), message, "name a rigid body, or leave `against` out for the ground");
        None
    }

    /// Reads the formula under a required key of a friction entry, and checks that its unit is `unit`. `None` after
    /// an error is reported.
    fn required_quantity(
        &mut self,
        entry: &'a DeTable<'a>,
        key: &str,
        allowed: AllowedQuantities,
        unit: &Unit,
        owner: FrictionEntry<'_>,
    ) -> Option<Expr> {
        let FrictionEntry { what, span } = owner;
        let value = self.reader.required(entry, key, what, span)?;
        let formula = self.reader.formula(value, &format!("`{key}`"))?;
        self.quantity(&formula, allowed, unit, &format!("`{key}` of {what}"))
    }

    /// Reads the keys `static` and `stribeck` of a friction entry: the resistance at rest, and the slip over which
    /// its excess decays. Both must be stated or neither. `Some(None)` if both are absent; `None` after an error is
    /// reported.
    #[allow(clippy::option_option, reason = "nothing stated is no error")]
    fn friction_at_rest(
        &mut self,
        entry: &'a DeTable<'a>,
        unit: &Unit,
        speed: &Unit,
        owner: FrictionEntry<'_>,
    ) -> Option<Option<(Expr, Expr)>> {
        if !entry.contains_key("static") && !entry.contains_key("stribeck") {
            return Some(None);
        }
        let more = self.required_quantity(entry, "static", DRIVEN, unit, owner);
        let until = self.required_quantity(entry, "stribeck", PARAMETERS, speed, owner);
        Some(Some((more?, until?)))
    }

    /// Reads the slip s₀ under the key `smoothing` of a friction entry, which must not be zero. `None` after an error
    /// is reported.
    fn smoothing(&mut self, entry: &'a DeTable<'a>, speed: &Unit, owner: FrictionEntry<'_>) -> Option<Expr> {
        let FrictionEntry { what, span } = owner;
        let smoothing = self.required_quantity(entry, "smoothing", PARAMETERS, speed, owner)?;
        if zero_test(&self.arena, smoothing) == ZeroTest::NonZero {
            return Some(smoothing);
        }
        let help = "state a speed far below those that matter: the law is linear below it";
        self.reader.error(span.clone(), format!("{what} jumps where the slip is 0"), help);
        None
    }

    /// Adds the forces and torques of friction to the elements, and the bodies that rub to the contacts.
    pub fn friction_loads(
        &mut self,
        moving: &mut MechanismMotion,
        elements: &mut Elements,
        stated: Vec<StatedFriction>,
    ) {
        for friction in stated {
            match friction.contact {
                FrictionContact::Point { on, against, frame, normal } => {
                    let slip = moving.material_velocity(&mut self.arena, elements, on.body, on.point);
                    let other = against.map(|body| moving.material_velocity(&mut self.arena, elements, body, on.point));
                    let slip = difference(&mut self.arena, slip, other);
                    let mut components = [0, 1, 2].map(|axis| moving.component(&mut self.arena, &slip, frame, axis));
                    if let Some(normal) = normal {
                        components[normal] = Expr::ZERO;
                    }
                    let Some(vector) = self.friction_resistance(&friction, components) else { continue };
                    elements.contacts.rubbing.push((on.body, against));
                    let against = against.map(|body| ForcePlace { body, point: on.point });
                    let name = friction.name.text;
                    elements.forces.push(Force {
                        name,
                        on,
                        against,
                        frame,
                        vector,
                        end: None,
                        energy: None,
                        damper: None,
                    });
                }
                FrictionContact::Axis { on, against, frame, axis } => {
                    let frame_of = |body: usize| elements.bodies[body].rigid.as_ref().map_or(0, |(frame, _)| *frame);
                    let spin = moving.angular_velocity(frame_of(on));
                    let other = against.map(|body| moving.angular_velocity(frame_of(body)));
                    let spin = difference(&mut self.arena, spin, other);
                    let mut components = [Expr::ZERO; 3];
                    components[axis] = moving.component(&mut self.arena, &spin, frame, axis);
                    let Some(vector) = self.friction_resistance(&friction, components) else { continue };
                    elements.contacts.rubbing.push((on, against));
                    let against = against.map(|body| (frame_of(body), Some(body)));
                    let on = (frame_of(on), Some(on));
                    elements.torques.push(Torque { name: friction.name.text, on, against, frame, vector });
                }
            }
        }
    }

    /// Force or torque −R(s) s/√(|s|² + s₀²) against a slip s, with three components. `None` after
    /// reporting that the slip is always zero.
    fn friction_resistance(&mut self, friction: &StatedFriction, slip: [Expr; 3]) -> Option<[Expr; 3]> {
        let arena = &mut self.arena;
        let squares = slip.map(|s| arena.square(s));
        let square = arena.sum(&squares);
        if zero_test(arena, square) == ZeroTest::Zero {
            let message = format!("nothing slips at friction `{}`", friction.name.text);
            self.reader.error(friction.name.span.clone(), message, "name bodies that move against one another there");
            return None;
        }
        let FrictionLaw { mut resistance, at_rest, smoothing } = friction.law;
        if let Some((at_rest, until)) = at_rest {
            let scale = arena.square(until);
            let part = arena.div(square, scale)?;
            let part = arena.neg(part);
            let fade = arena.apply(Function::Exp, part);
            let more = arena.sub(at_rest, resistance);
            let more = arena.mul(more, fade);
            resistance = arena.add(resistance, more);
        }
        let smooth = arena.square(smoothing);
        let size = arena.add(square, smooth);
        let size = arena.apply(Function::Sqrt, size);
        let by_slip = arena.div(resistance, size)?;
        let by_slip = arena.neg(by_slip);
        Some(slip.map(|s| arena.mul(by_slip, s)))
    }
}

/// Difference of two vectors: the first less the second. `None` as the second vector means zero, such as the velocity
/// of the ground.
fn difference(arena: &mut Arena, one: Vector, other: Option<Vector>) -> Vector {
    match other {
        Some(other) => {
            let back = other.neg(arena);
            one.add(arena, &back)
        }
        None => one,
    }
}
