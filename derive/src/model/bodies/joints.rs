//! Joints of a model file. Each connects two bodies. A joint that places a body adds its frame, points, coordinates
//! and speeds.
//!
//! A joint adds entries to the sections of a model file, under names that formulas may use. Only the code that reads
//! files knows of joints. The first joint of a body places it, unless the body's frame is declared. A further joint
//! of a body closes a loop.

use super::joint_kinds::{
    JointFreedom, JointKind, KINDS, angular_velocity_by_euler_parameters, angular_velocity_formulas,
};
use crate::diagnostic::{nearest_name_advice, shortened_for_message};
use crate::model::reading::declared_names::NameKind;
use crate::model::reading::loading::Loading;
use crate::model::units::Unit;
use crate::model::{DependentSpeed, Speed};
use crate::toml_reader::Located;
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Value of the key `sequence` that selects Euler parameters instead of successive rotations.
const EULER: &str = "euler";

/// Joint as the model file states it: its kind, its axes and the two bodies.
pub struct Joint<'a> {
    /// Name of the joint in the model file.
    pub name: Located,
    /// Table of the joint in the model file.
    pub entry: &'a DeTable<'a>,
    /// Name of the joint in error messages, such as "joint `pivot`".
    pub what: String,
    /// Kind of the joint, which determines its degrees of freedom.
    pub kind: JointKind,
    /// Axes of the joint's rotations, 0 to 2, in their order. A kind with one axis has a single entry; Euler
    /// parameters have none.
    pub axes: Vec<usize>,
    /// Formulas of the vector along which axis 3 of the joint points. `None` if the model file states an axis by
    /// number, or no axis.
    pub along: Option<&'a Spanned<DeValue<'a>>>,
    /// Name of the body that the joint places, or that it ties to another body by closing a loop.
    pub body: Located,
    /// Name of the body to which the joint attaches the body `body`; `None` for the ground.
    pub to: Option<Located>,
    /// True if the joint places its body by coordinates (a tree joint); false if the joint closes a loop.
    pub carries: bool,
    /// Names of the joint's coordinates, in the order of its degrees of freedom.
    pub coordinates: Vec<Located>,
}

/// Names of the frame and mass centre of a body, and of the joint that places it.
#[derive(Clone)]
pub struct PlacedBody {
    /// Name of the body's frame.
    pub frame: Located,
    /// Name of the body's mass centre.
    pub centre: Located,
    /// Name of the joint that places the body, which is also the name of the joint's point on the body. `None` if no
    /// joint places the body.
    pub joint: Option<Located>,
}

/// All joints of a model file, and the names by which they place bodies.
#[derive(Default)]
pub struct Joints<'a> {
    /// Joints, in the order of the model file.
    pub list: Vec<Joint<'a>>,
    /// Names of each rigid body's frame and mass centre, stated or default, by the name of the body.
    pub bodies: FxHashMap<String, PlacedBody>,
    /// Generalized speeds that joints add, each as (name, definition as text).
    pub speeds: Vec<(Located, Located)>,
    /// Names of those joint speeds that the model file itself names, under the key `speeds`.
    pub stated_speeds: FxHashSet<String>,
    /// True if a joint could not be read. Names that this joint would have added are then not reported as missing.
    pub is_short: bool,
}

impl Joints<'_> {
    /// True if one of the joints adds the given generalized speed to the model.
    pub fn adds_joint_speed(&self, speed: &Speed) -> bool {
        self.speeds.iter().any(|(name, _)| name.text == speed.name)
    }

    /// Converts a speed of a joint into a dependent speed, for a speed that constraints determine.
    pub fn dependent_joint_speed(&self, speed: Speed) -> DependentSpeed {
        let is_stated = self.stated_speeds.contains(&speed.name);
        DependentSpeed { name: speed.name, definition: speed.definition, is_stated }
    }

    /// Coordinates that joints add to the model, each as (name, unit, description).
    pub fn coordinates(&self) -> Vec<(Located, Unit, String)> {
        let mut list = Vec::new();
        for joint in self.list.iter().filter(|joint| joint.carries) {
            for (name, freedom) in joint.coordinates.iter().zip(joint.kind.freedoms(&joint.axes)) {
                let unit = if let JointFreedom::Along(_) = freedom { Unit::new(1, 0, 0) } else { Unit::default() };
                let about = match freedom {
                    JointFreedom::Along(axis) => format!("way along axis {} of {}", axis + 1, joint.what),
                    JointFreedom::About(axis) | JointFreedom::Screwed(axis) => {
                        format!("turn about axis {} of {}", axis + 1, joint.what)
                    }
                    JointFreedom::Parameter => format!("Euler parameter of {}", joint.what),
                };
                list.push((name.clone(), unit, about.replace('`', "")));
            }
        }
        list
    }
}

impl<'a> Loading<'a> {
    /// Reads `[joints]` without the formulas of its entries, since these may contain coordinates of joints. Errors
    /// are recorded in the reader.
    pub fn joints(&mut self, table: &'a DeTable<'a>) -> Joints<'a> {
        let mut joints = Joints::default();
        let entries =
            self.section(table, "joints", &[NameKind::Point, NameKind::Frame, NameKind::Coordinate, NameKind::Speed]);
        if entries.is_empty() {
            return joints;
        }
        let keys = |section: &str| -> Vec<&str> {
            let section = table.get(section).and_then(|v| v.get_ref().as_table());
            section.map_or(Vec::new(), |section| section.keys().map(|key| key.get_ref().as_ref()).collect())
        };
        let mut frames = keys("frames");
        let inertial = table.get("inertial").and_then(|v| v.get_ref().as_table());
        frames.extend(inertial.and_then(|t| t.get("frame")).and_then(|v| v.get_ref().as_str()));
        if let Some(bodies) = table.get("bodies").and_then(|v| v.get_ref().as_table()) {
            for (name, body) in bodies {
                let named = |key: &str, default: String| match body.get_ref().as_table().and_then(|b| b.get(key)) {
                    Some(value) => {
                        let text = value.get_ref().as_str().unwrap_or_default().to_owned();
                        Located { text, span: value.span(), exact: false }
                    }
                    None => Located { text: default, span: name.span(), exact: false },
                };
                let frame = named("frame", format!("{}_frame", name.get_ref()));
                let centre = named("centre", format!("{}_centre", name.get_ref()));
                joints.bodies.insert(name.get_ref().to_string(), PlacedBody { frame, centre, joint: None });
            }
        }
        for (name, value) in entries {
            let before = self.reader.errors.len();
            if let Some(joint) = self.joint(&mut joints, &frames, name.clone(), value) {
                joints.list.push(joint);
                continue;
            }
            joints.is_short = true;
            // Names that the failed joint would have added are not reported as missing.
            let carried = joints.bodies.values().filter(|placed| placed.joint.as_ref() == Some(&name));
            for placed in carried {
                self.names.mark_wrong_name(&placed.frame.text);
                self.names.mark_wrong_name(&placed.centre.text);
            }
            if self.reader.errors.len() == before {
                // The error that made this joint fail is reported elsewhere.
                self.names.mark_wrong_name(&name.text);
            } else {
                self.names.mark_unread_kinds(&[
                    NameKind::Point,
                    NameKind::Frame,
                    NameKind::Coordinate,
                    NameKind::Rate,
                    NameKind::Speed,
                ]);
            }
        }
        joints
    }

    /// Reads one joint. `None` if it could not be read; the error has then been reported.
    fn joint(
        &mut self,
        joints: &mut Joints<'a>,
        frames: &[&str],
        name: Located,
        value: &'a toml::Spanned<DeValue<'a>>,
    ) -> Option<Joint<'a>> {
        let what = format!("joint `{}`", shortened_for_message(&name.text));
        let entry = self.reader.table(value, &what, "[joints.NAME] with kind = \"pin\" and body = \"arm\"")?;
        self.about(entry);
        let body = self.jointed_body(joints, entry, "body", &what, &name.span)?;
        let placed = joints.bodies.get_mut(&body.text)?;
        let carries = placed.joint.is_none() && !frames.contains(&placed.frame.text.as_str());
        if carries {
            placed.joint = Some(name.clone());
        }
        let stated = self.reader.required(entry, "kind", &what, &name.span)?;
        let stated = self.reader.string(stated, "`kind`")?;
        let Some((_, kind)) = KINDS.iter().find(|(known, _)| *known == stated.text) else {
            let message = format!("there is no joint of the kind `{}`", shortened_for_message(&stated.text));
            self.reader.error(stated.span, message, nearest_name_advice(&stated.text, KINDS.map(|(known, _)| known)));
            return None;
        };
        let kind = *kind;
        let to = match self.reader.get(entry, "to") {
            Some(_) => Some(self.jointed_body(joints, entry, "to", &what, &name.span)?),
            None => None,
        };
        if to.as_ref().is_some_and(|to| to.text == body.text) {
            self.reader.error(body.span, format!("{what} connects `{}` to itself", body.text), "name two bodies");
            return None;
        }
        let along = self.reader.get(entry, "axis").filter(|axis| axis.get_ref().is_array());
        let axes = if along.is_some() { vec![2] } else { self.joint_axes(kind, entry, &what)? };
        let mut keys = vec!["kind", "body", "to", "at", "turned", "about"];
        keys.extend(if carries { &["coordinates", "speeds", "centre"][..] } else { &["body_at", "body_turned"][..] });
        keys.extend(kind.keys());
        self.reader.report_unknown_keys(entry, if carries { &what } else { "a joint that closes a loop" }, &keys);
        if let (false, Some(along)) = (carries, along) {
            let help = "turn its axes on both bodies by `turned` and `body_turned`";
            self.reader.error(along.span(), "the axis of a joint that closes a loop is 1, 2 or 3", help);
            return None;
        }
        if !carries && matches!(kind, JointKind::Free | JointKind::Screw) {
            let message = format!("{what} cannot close a loop: `{}` is placed already", body.text);
            let help = "leave the other place of the body out, or state the tie under [constraints]";
            self.reader.error(stated.span, message, help);
            return None;
        }
        let mut joint = Joint { name, entry, what, kind, axes, along, body, to, carries, coordinates: Vec::new() };
        if carries {
            let freedoms = kind.freedoms(&joint.axes);
            joint.coordinates = self.joint_names(&joint, "coordinates", freedoms.len(), |at, one| {
                if one { format!("q_{}", joint.name.text) } else { format!("q_{}_{}", joint.name.text, at + 1) }
            })?;
            let speeds = self.joint_speeds(&joint, &freedoms)?;
            if self.reader.get(entry, "speeds").is_some() {
                joints.stated_speeds.extend(speeds.iter().map(|(name, _)| name.text.clone()));
            }
            joints.speeds.extend(speeds);
        }
        Some(joint)
    }

    /// Name of the rigid body under a key of a joint. `None` after an error is reported, such as a name that is no
    /// rigid body.
    fn jointed_body(
        &mut self,
        joints: &Joints<'a>,
        entry: &'a DeTable<'a>,
        key: &str,
        what: &str,
        span: &Range<usize>,
    ) -> Option<Located> {
        let value = self.reader.required(entry, key, what, span)?;
        let name = self.reader.string(value, &format!("`{key}`"))?;
        if joints.bodies.contains_key(&name.text) {
            return Some(name);
        }
        let message = format!("there is no rigid body `{}`", shortened_for_message(&name.text));
        let mut known: Vec<&str> = joints.bodies.keys().map(String::as_str).collect();
        known.sort_unstable();
        self.reader.error_once(name.span, message, nearest_name_advice(&name.text, known));
        None
    }

    /// Reads the axes, 0 to 2, of the rotations of a joint; an empty list for Euler parameters. `None` after an error
    /// is reported.
    fn joint_axes(&mut self, kind: JointKind, entry: &'a DeTable<'a>, what: &str) -> Option<Vec<usize>> {
        match kind {
            JointKind::Weld => Some(Vec::new()),
            JointKind::Ball | JointKind::Free => match self.reader.get(entry, "sequence") {
                Some(value) if value.get_ref().as_str() == Some(EULER) => Some(Vec::new()),
                Some(value) => self.turn_sequence(value, Some(3)),
                None => Some(vec![0, 1, 2]),
            },
            JointKind::Universal => {
                let Some(value) = self.reader.get(entry, "axes") else { return Some(vec![0, 1]) };
                let DeValue::Array(list) = value.get_ref() else {
                    self.reader.error(value.span(), "`axes` must be an array", "write axes = [1, 2]");
                    return None;
                };
                let axes: Option<Vec<usize>> = list.iter().map(|v| self.axis_number(v)).collect();
                let axes = axes?;
                if axes.len() != 2 || axes[0] == axes[1] {
                    let message = format!("the axes of {what} are not two different ones");
                    self.reader.error(value.span(), message, "write axes = [1, 2]");
                    return None;
                }
                Some(axes)
            }
            _ => match self.reader.get(entry, "axis") {
                Some(value) => Some(vec![self.axis_number(value)?]),
                None => Some(vec![2]),
            },
        }
    }

    /// Reads the number of an axis, 1, 2 or 3, as 0, 1 or 2. `None` after reporting any other value.
    pub fn axis_number(&mut self, value: &'a toml::Spanned<DeValue<'a>>) -> Option<usize> {
        let axis = match value.get_ref() {
            DeValue::Integer(n) => ["1", "2", "3"].iter().position(|a| *a == n.as_str()),
            _ => None,
        };
        if axis.is_none() {
            self.reader.error(value.span(), "the axis of a rotation is 1, 2 or 3", "write axis = 3");
        }
        axis
    }

    /// Reads the axes of successive rotations, such as `"313"`, each as 0, 1 or 2. `count` is the required number of
    /// axes; `None` allows any. Returns `None` after an error is reported.
    pub fn turn_sequence(&mut self, value: &'a toml::Spanned<DeValue<'a>>, count: Option<usize>) -> Option<Vec<usize>> {
        let text = self.reader.string(value, "`sequence`")?;
        let axes: Option<Vec<usize>> =
            text.text.chars().map(|c| ['1', '2', '3'].iter().position(|axis| *axis == c)).collect();
        let good = axes.filter(|axes| {
            let follow = axes.windows(2).all(|pair| pair[0] != pair[1]);
            follow && (1..=12).contains(&axes.len()) && count.is_none_or(|n| n == axes.len())
        });
        if good.is_none() {
            let message = format!("`{}` is not a sequence of turns", shortened_for_message(&text.text));
            let help = "write the axes of the turns one after the other, such as \"313\"; neighbours differ";
            self.reader.error(text.span, message, help);
        }
        good
    }

    /// Reads `count` names under a key of a joint. If the key is absent, `default` makes the names. `None` after an
    /// error is reported.
    fn joint_names(
        &mut self,
        joint: &Joint<'a>,
        key: &str,
        count: usize,
        default: impl Fn(usize, bool) -> String,
    ) -> Option<Vec<Located>> {
        let Some(value) = self.reader.get(joint.entry, key) else {
            let span = joint.name.span.clone();
            let name = |at| Located { text: default(at, count == 1), span: span.clone(), exact: false };
            return Some((0..count).map(name).collect());
        };
        let help = format!("write {key} = [\"a\", \"b\", …], a name for each motion of the joint");
        let DeValue::Array(list) = value.get_ref() else {
            self.reader.error(value.span(), format!("`{key}` must be an array"), help);
            return None;
        };
        if list.len() != count {
            let message = format!("{} names {} {key}, but has {count}", joint.what, list.len());
            self.reader.error(value.span(), message, help);
            return None;
        }
        list.iter().map(|item| self.reader.string(item, &format!("one of `{key}`"))).collect()
    }

    /// Names and definitions, as text, of the speeds of a joint: rates of displacements and rotations.
    /// For three rotations they are the components of the body's relative angular velocity in the
    /// body's frame. `None` after an error is reported.
    fn joint_speeds(&mut self, joint: &Joint<'a>, freedoms: &[JointFreedom]) -> Option<Vec<(Located, Located)>> {
        let none = self.reader.get(joint.entry, "speeds").and_then(|v| v.get_ref().as_array());
        if none.is_some_and(|list| list.iter().next().is_none()) {
            return Some(Vec::new());
        }
        let parameters = freedoms.iter().filter(|freedom| **freedom == JointFreedom::Parameter).count();
        let has_parameters = parameters > 0;
        let count = freedoms.len() - usize::from(has_parameters);
        let turns_in_space = matches!(joint.kind, JointKind::Ball | JointKind::Free);
        let first_turn = if turns_in_space { count - 3 } else { count };
        let names = self.joint_names(joint, "speeds", count, |at, _| {
            let coordinate = &joint.coordinates[at].text;
            // A component of ω along an axis of the body is not the rate of a coordinate. So the speed is named by
            // the number of its axis, not by an angle.
            let is_number = |rest: &str| !rest.is_empty() && rest.bytes().all(|byte| byte.is_ascii_digit());
            if at >= first_turn && (has_parameters || !coordinate.strip_prefix('q').is_some_and(is_number)) {
                return format!("u_{}_{}", joint.name.text, at + 1);
            }
            match coordinate.strip_prefix('q') {
                Some(rest) => format!("u{rest}"),
                None => format!("u_{coordinate}"),
            }
        })?;
        let mut formulas: Vec<String> = joint.coordinates.iter().map(|q| format!("{}'", q.text)).collect();
        if turns_in_space {
            let q: Vec<&str> = joint.coordinates[first_turn..].iter().map(|q| q.text.as_str()).collect();
            let components = match q.as_slice() {
                [w, x, y, z] => angular_velocity_by_euler_parameters([w, x, y, z]).into(),
                angles => angular_velocity_formulas(&joint.axes, angles),
            };
            formulas.splice(first_turn.., components);
        }
        let definition = |text, name: &Located| Located { text, span: name.span.clone(), exact: false };
        Some(names.into_iter().zip(formulas).map(|(name, text)| (name.clone(), definition(text, &name))).collect())
    }
}
