//! Loads as a model file states them (gravity, forces and torques), and reactions.

use super::elements::{Elements, vector};
use crate::algebra::Expr;
use crate::algebra::text::parse::VelocityOf;
use crate::diagnostic::shortened_for_message;
use crate::model::reading::declared_names::{CONFIGURATION, DRIVEN, NameKind, PARAMETERS};
use crate::model::reading::loading::Loading;
use crate::model::units::Unit;
use crate::model::velocities::StatedVelocity;
use crate::model::{Force, ForcePlace, Gravity, NamedVelocity, Reaction, ReactionKind, Torque};
use crate::toml_reader::{Entry, Located};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

impl Elements {
    /// Reads the section `[gravity]` of a model file. Errors are recorded in the reader.
    pub fn read_gravity<'a>(&mut self, loading: &mut Loading<'a>, table: &'a DeTable<'a>) {
        let Some(value) = loading.reader.get(table, "gravity") else { return };
        let what = "`gravity`";
        let Some(entry) = loading.reader.table(value, what, "[gravity]") else { return };
        loading.reader.report_unknown_keys(entry, what, &["frame", "acceleration", "zero_at"]);
        let frame = self.frame(loading, entry, what, &value.span());
        if let (Some(frame), Some(stated)) = (frame.filter(|f| *f != 0), loading.reader.get(entry, "frame")) {
            let (name, inertial) = (&self.frames[frame].name, &self.frames[0].name);
            let message = format!("gravity is stated in the frame `{name}`, not in the inertial frame `{inertial}`");
            loading.reader.error(stated.span(), message, format!("state its components in `{inertial}`"));
        }
        let unit = Unit::new(1, 0, -2);
        let acceleration = vector(loading, entry, "acceleration", what, &value.span(), PARAMETERS, &unit);
        let zero_at =
            loading.reader.get(entry, "zero_at").map_or(Vec::new(), |v| gravity_zero_configuration(loading, v));
        if let (Some(frame), Some(acceleration)) = (frame, acceleration) {
            self.gravity = Some(Gravity { frame, acceleration, zero_at });
        }
    }

    /// Reads the section `[forces]` of a model file. Errors are recorded in the reader.
    pub fn read_forces<'a>(&mut self, loading: &mut Loading<'a>, table: &'a DeTable<'a>) {
        for (name, value) in loading.section(table, "forces", &[]) {
            let entry = loading.entry(&name, value, NameKind::Force, None, "[forces.NAME]");
            let Some((entry, what)) = entry else { continue };
            let keys = ["on", "at", "against", "against_at", "frame", "vector", "about"];
            loading.reader.report_unknown_keys(entry, "a force", &keys);
            let on = self.load_place(loading, entry, "on", "at", &what, &name.span);
            let against = self.opposite_force_place(loading, entry, on, &what, &name.span);
            let frame = self.frame(loading, entry, &what, &name.span);
            let unit = Unit::new(1, 1, -2);
            let vector = vector(loading, entry, "vector", &what, &name.span, DRIVEN, &unit);
            if let (Some(on), Some(frame), Some(vector)) = (on, frame, vector) {
                self.forces.push(Force {
                    name: name.text,
                    on,
                    against,
                    frame,
                    vector,
                    end: None,
                    energy: None,
                    damper: None,
                });
            }
        }
    }

    /// Reads the section `[torques]` of a model file. Errors are recorded in the reader.
    pub fn read_torques<'a>(&mut self, loading: &mut Loading<'a>, table: &'a DeTable<'a>) {
        for (name, value) in loading.section(table, "torques", &[]) {
            let entry = loading.entry(&name, value, NameKind::Torque, None, "[torques.NAME]");
            let Some((entry, what)) = entry else { continue };
            loading.reader.report_unknown_keys(entry, "a torque", &["on", "against", "frame", "vector", "about"]);
            let on = loading.reader.required(entry, "on", &what, &name.span);
            let on = on.and_then(|v| self.torque_target(loading, v, "on"));
            let against = loading.reader.get(entry, "against").and_then(|v| self.torque_target(loading, v, "against"));
            // A torque on the ground has no effect.
            let against = against.filter(|(frame, _)| *frame != 0);
            let frame = self.frame(loading, entry, &what, &name.span);
            let unit = Unit::new(2, 1, -2);
            let vector = vector(loading, entry, "vector", &what, &name.span, DRIVEN, &unit);
            if let (Some(on), Some(frame), Some(vector)) = (on, frame, vector) {
                self.torques.push(Torque { name: name.text, on, against, frame, vector });
            }
        }
    }

    /// Reads the target of a torque: a rigid body or a massless frame. Returns (frame, body); the body is `None` if
    /// the frame has no body. `None` after an error is reported.
    fn torque_target<'a>(
        &self,
        loading: &mut Loading<'a>,
        value: &'a Spanned<DeValue<'a>>,
        key: &str,
    ) -> Option<(usize, Option<usize>)> {
        let name = loading.reader.string(value, &format!("`{key}`"))?;
        if loading.names.kind(&name.text) == Some(NameKind::Frame) {
            let frame = self.frames.iter().position(|f| f.name == name.text)?;
            let body = self.bodies.iter().position(|b| b.rigid.as_ref().is_some_and(|(f, _)| *f == frame));
            return Some((frame, body));
        }
        let body = self.body_named(loading, &name)?;
        match &self.bodies[body].rigid {
            Some((frame, _)) => Some((*frame, Some(body))),
            None => {
                let message = format!("the body `{}` is a particle: no torque can act on a particle", name.text);
                loading.reader.error(name.span, message, "name a rigid body or a frame");
                None
            }
        }
    }

    /// Index of the rigid body on which a reaction torque acts. `None` for the ground, or after
    /// reporting a frame without a body.
    fn torque_body<'a>(&self, loading: &mut Loading<'a>, entry: &'a DeTable<'a>, key: &str) -> Option<usize> {
        let value = loading.reader.get(entry, key)?;
        let (frame, body) = self.torque_target(loading, value, key)?;
        if body.is_none() && (frame != 0 || key == "on") {
            let message =
                format!("the frame `{}` carries no body on which a torque could act", self.frames[frame].name);
            loading.reader.error(value.span(), message, "name a rigid body");
            return None;
        }
        body
    }

    /// Reads the entries of `[reactions]`, whose names have already been declared. Errors are recorded in the reader.
    pub fn read_reactions<'a>(&mut self, loading: &mut Loading<'a>, entries: &[Entry<'a>]) {
        for (name, value) in entries {
            let what = format!("reaction `{}`", name.text);
            let Some(entry) = loading.reader.table(value, &what, "[reactions.NAME]") else {
                loading.names.mark_wrong_name(&name.text);
                continue;
            };
            let Some(torque) = is_torque(loading, entry) else { continue };
            let symbol = loading.arena.symbol(&name.text);
            let (keys, unit): (&[&str], _) = if torque {
                (&["kind", "on", "against", "frame", "direction", "about"], Unit::new(2, 1, -2))
            } else {
                (&["kind", "on", "at", "against", "against_at", "frame", "direction", "about"], Unit::new(1, 1, -2))
            };
            loading.units.insert(symbol, unit);
            loading.reader.report_unknown_keys(entry, if torque { "a reaction torque" } else { "a reaction" }, keys);
            let frame = self.frame(loading, entry, &what, &name.span);
            let plain = Unit::default();
            let direction = vector(loading, entry, "direction", &what, &name.span, CONFIGURATION, &plain);
            if let (Some([Expr::ZERO, Expr::ZERO, Expr::ZERO]), Some(value)) =
                (direction, loading.reader.get(entry, "direction"))
            {
                let help = "a direction has a component that is not 0, as in [0, 0, 1]";
                loading.reader.error(value.span(), format!("the direction of {what} is zero"), help);
            }
            let kind = if torque {
                loading.reader.required(entry, "on", &what, &name.span);
                let on = self.torque_body(loading, entry, "on");
                let against = self.torque_body(loading, entry, "against");
                on.map(|on| ReactionKind::Torque { on, against })
            } else {
                let on = self.load_place(loading, entry, "on", "at", &what, &name.span);
                let against = self.opposite_force_place(loading, entry, on, &what, &name.span);
                on.map(|on| ReactionKind::Force { on, against })
            };
            if let (Some(kind), Some(frame), Some(direction)) = (kind, frame, direction) {
                self.reactions.push(Reaction {
                    name: name.text.clone(),
                    symbol,
                    kind,
                    frame,
                    direction,
                    is_stated: true,
                    is_shared: false,
                    law: None,
                });
            }
        }
    }

    /// Velocities and positions that occur by name in formulas, such as the velocity of a point. Their points, frames
    /// and bodies are given by index. Unknown names are left out and reported.
    pub fn velocities(&self, loading: &mut Loading<'_>) -> Vec<NamedVelocity> {
        let stated = std::mem::take(&mut loading.names.velocities);
        stated.iter().filter_map(|velocity| self.velocity(loading, velocity)).collect()
    }

    /// Resolves the names of a stated velocity or position to indices; `None` after an error is
    /// reported.
    fn velocity(&self, loading: &mut Loading<'_>, stated: &StatedVelocity) -> Option<NamedVelocity> {
        let StatedVelocity { symbol, axis, .. } = *stated;
        let point_of = |name: &Located| self.points.iter().position(|p| p.name == name.text);
        let frame_of = |name: &Located| self.frames.iter().position(|f| f.name == name.text);
        let body_of = |name: &Located| self.bodies.iter().position(|b| b.name == name.text);
        let frame = frame_of(&stated.frame)?;
        let of = match &stated.of {
            VelocityOf::Point(name) => VelocityOf::Point(point_of(name)?),
            VelocityOf::Place(name) => VelocityOf::Place(point_of(name)?),
            VelocityOf::Turning(name) => match body_of(name) {
                Some(body) => VelocityOf::Turning(self.frame_of_body(loading, name, body)?),
                None => VelocityOf::Turning(frame_of(name)?),
            },
            VelocityOf::Material(name, place) => {
                let (body, point) = (body_of(name)?, point_of(place)?);
                if self.bodies[body].rigid.is_none() && self.bodies[body].centre != point {
                    let help = format!("write v({}): a particle has no material elsewhere", place.text);
                    let message = format!("the particle `{}` is not at the point `{}`", name.text, place.text);
                    loading.reader.error(place.span.clone(), message, help);
                    return None;
                }
                VelocityOf::Material(body, point)
            }
        };
        Some(NamedVelocity { symbol, of, frame, axis })
    }

    /// Index of the frame of a rigid body; `None` after reporting a particle, which has no frame.
    fn frame_of_body(&self, loading: &mut Loading<'_>, name: &Located, body: usize) -> Option<usize> {
        let frame = self.bodies[body].rigid.as_ref().map(|(frame, _)| *frame);
        if frame.is_none() {
            let message = format!("the particle `{}` has no angular velocity", name.text);
            loading.reader.error(name.span.clone(), message, "name a rigid body or a frame");
        }
        frame
    }

    /// Index of the body with the given name; `None` after reporting an unknown name.
    pub fn body_named(&self, loading: &mut Loading<'_>, name: &Located) -> Option<usize> {
        let known = loading.names.expect(&mut loading.reader, name, NameKind::Body);
        self.bodies.iter().position(|b| known && b.name == name.text)
    }

    /// Reads a body and a point under two keys of an entry. If the point's key is absent, the point is the body's
    /// mass centre. `None` after an error is reported.
    pub fn load_place<'a>(
        &self,
        loading: &mut Loading<'a>,
        entry: &'a DeTable<'a>,
        body_key: &str,
        point_key: &str,
        what: &str,
        owner: &Range<usize>,
    ) -> Option<ForcePlace> {
        let value = loading.reader.required(entry, body_key, what, owner)?;
        let name = loading.reader.string(value, &format!("`{body_key}`"))?;
        let body = self.body_named(loading, &name);
        let stated = loading.reader.get(entry, point_key);
        let point = stated.and_then(|_| self.point(loading, entry, point_key, what, owner));
        let body = body?;
        let centre = self.bodies[body].centre;
        let point = if stated.is_some() { point? } else { centre };
        if self.bodies[body].rigid.is_none() && point != centre {
            let help = "leave the point out: a force on a particle acts where the particle is";
            let span = stated.map_or(owner.clone(), Spanned::span);
            loading.reader.error(span, format!("the particle `{}` is not at this point", name.text), help);
            return None;
        }
        Some(ForcePlace { body, point })
    }

    /// Reads the place of the force's opposite: on the body `against`, at the point `against_at` or else at the
    /// force's own point. `None` if the key `against` is absent, or after an error is reported.
    fn opposite_force_place<'a>(
        &self,
        loading: &mut Loading<'a>,
        entry: &'a DeTable<'a>,
        on: Option<ForcePlace>,
        what: &str,
        owner: &Range<usize>,
    ) -> Option<ForcePlace> {
        let stated = loading.reader.get(entry, "against");
        if let (None, Some(at)) = (stated, loading.reader.get(entry, "against_at")) {
            let help = "add `against = …`, or leave `against_at` out";
            loading.reader.error(at.span(), format!("{what} has `against_at` without `against`"), help);
        }
        let value = stated?;
        if loading.reader.get(entry, "against_at").is_some() {
            return self.load_place(loading, entry, "against", "against_at", what, owner);
        }
        let name = loading.reader.string(value, "`against`")?;
        let body = self.body_named(loading, &name)?;
        let point = if self.bodies[body].rigid.is_some() { on?.point } else { self.bodies[body].centre };
        Some(ForcePlace { body, point })
    }
}

/// Reads the key `kind` of a reaction: true for a torque, false for a force or if the key is absent. `None` after
/// reporting any other value.
fn is_torque<'a>(loading: &mut Loading<'a>, entry: &'a DeTable<'a>) -> Option<bool> {
    let Some(value) = loading.reader.get(entry, "kind") else { return Some(false) };
    let kind = loading.reader.string(value, "`kind`")?;
    match kind.text.as_str() {
        "force" => Some(false),
        "torque" => Some(true),
        other => {
            let message = format!("unknown kind of reaction: `{}`", shortened_for_message(other));
            loading.reader.error(kind.span, message, "a reaction is a \"force\" or a \"torque\"");
            None
        }
    }
}

/// Reads the configuration at which the potential energy of gravity is zero, as pairs (coordinate, value).
fn gravity_zero_configuration<'a>(loading: &mut Loading<'a>, value: &'a Spanned<DeValue<'a>>) -> Vec<(Expr, Expr)> {
    let Some(table) = loading.reader.table(value, "`zero_at`", "{ q2 = 0 }") else { return Vec::new() };
    let entries = loading.reader.entries(table);
    loading.coordinate_values(entries)
}
