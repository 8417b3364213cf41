//! Loops file: the connections, couplings and assembled pose of a robot whose URDF file, a tree, cannot state them.
//!
//! The file is TOML. `[loops.NAME]` connects two links; `[couplings.NAME]` couples two joints by
//! q = multiplier · q_leader + offset; `[assembly]` has joint values near which the loops are closed. Positions are in
//! m, angles in rad. Poses are those of URDF: `xyz` and `rpy` in the axes of the link.

use crate::Options;
use crate::numbers::number_text;
use crate::pose::{Pose, roll_pitch_yaw, turn_to};
use crate::robot::{Coupling, Joint, JointIndex, Loop, LoopKind, Omission, Robot};
use crate::urdf::LARGEST_ANGLE;
use crate::xml::Reading;
use nalgebra::Vector3;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};
use tripos_derive::diagnostic::{Diagnostics, Source, nearest_name_advice, shortened_for_message};
use tripos_derive::toml_reader::{Located, TomlReader};

/// Sections of the file.
const SECTIONS: [&str; 4] = ["schema", "loops", "couplings", "assembly"];
/// Kinds of a loop.
const KINDS: [&str; 3] = ["connect", "weld", "hinge"];
/// Difference up to which the value of a joint agrees with its coupling, rad or m, or relative to values above 1. The
/// values of a file may have few digits.
const COUPLED: f64 = 1e-3;
/// Example of an end of a loop, for advice.
const END: &str = "{ link = \"rod\", xyz = [0, 0, 0.3] }";

/// Reads a loops file, and adds its loops, couplings and assembled pose to the robot, whose bodies are the links of the
/// URDF file. The inputs of joints that follow others are removed.
///
/// # Errors
/// All mistakes of the file, each with its place.
pub fn read(source: &Source, options: Options, robot: &mut Robot) -> Result<(), Diagnostics> {
    let (toml, table) = TomlReader::parse(source)?;
    let mut file = LoopsFile { toml, reading: Reading::new(options, &source.path), robot };
    let table = table.get_ref();
    file.toml.schema(table);
    file.toml.report_unknown_keys(table, "a loops file", &SECTIONS);
    for (name, value) in file.entries_of(table, "loops", "loops.NAME") {
        file.read_loop(&name, value);
    }
    for (name, value) in file.entries_of(table, "couplings", "couplings.NAME") {
        file.read_coupling(&name, value);
    }
    file.read_assembly(table);
    if file.robot.loops.is_empty() && file.robot.couplings.is_empty() && file.toml.errors.is_empty() {
        file.toml.error(0..0, "the file states no loop and no coupling", "add `[loops.NAME]` or `[couplings.NAME]`");
    }
    let LoopsFile { mut toml, reading, robot } = file;
    toml.finish()?;
    for omission in reading.into_omissions() {
        Omission::merge(&mut robot.omissions, omission);
    }
    Ok(())
}

/// Reader of a loops file, with the robot to which it adds.
struct LoopsFile<'a, 'r> {
    /// Reader of the text, with the mistakes so far.
    toml: TomlReader<'a>,
    /// Reading of angles, with its omissions.
    reading: Reading,
    /// Robot so far.
    robot: &'r mut Robot,
}

impl<'a> LoopsFile<'a, '_> {
    /// Entries of a section in the order of the file; none if the section is absent, or after recording a mistake.
    fn entries_of(
        &mut self,
        table: &'a DeTable<'a>,
        section: &str,
        form: &str,
    ) -> Vec<(Located, &'a Spanned<DeValue<'a>>)> {
        let Some(value) = self.toml.get(table, section) else { return Vec::new() };
        let found = self.toml.table(value, &format!("`{section}`"), &format!("`[{form}]`"));
        found.map_or_else(Vec::new, |found| self.toml.entries(found))
    }

    /// Reads a connection of two links. Mistakes are recorded.
    fn read_loop(&mut self, name: &Located, value: &'a Spanned<DeValue<'a>>) {
        let what = format!("the loop `{}`", name.text);
        let Some(table) = self.toml.table(value, &what, "`[loops.NAME]` with `kind`, `first` and `second`") else {
            return;
        };
        self.toml.report_unknown_keys(table, &what, &["kind", "first", "second", "axis"]);
        let frame = self.read_kind(table, name, &what);
        let is_point = matches!(frame, Some((_, LoopKind::Connect)));
        let ends = ["first", "second"].map(|key| {
            let value = self.toml.required(table, key, &what, &name.span)?;
            self.read_end(value, key, is_point)
        });
        let (Some((turn, kind)), [Some((first, first_pose)), Some((second, second_pose))]) = (frame, ends) else {
            return;
        };
        if first == second {
            let message = format!("both ends of {what} are on the same link");
            self.toml.error(name.span.clone(), message, "name two different links");
            return;
        }
        self.robot.loops.push(Loop {
            name: name.text.clone(),
            kind,
            first: Some(first),
            first_pose: first_pose.compose(&turn),
            second: Some(second),
            second_pose: second_pose.compose(&turn),
            place: name.span.clone(),
        });
    }

    /// Reads the values of joints near which the loops are closed. Mistakes are recorded.
    fn read_assembly(&mut self, table: &'a DeTable<'a>) {
        let mut places = Vec::new();
        for (name, value) in self.entries_of(table, "assembly", "assembly") {
            let place = value.span();
            let joint = self.joint(&name);
            let value = self.number(value, &format!("`{}`", name.text));
            if let (Some(joint), Some(value)) = (joint, value) {
                self.robot.assembly.insert(joint, value);
                places.push((joint, place));
            }
        }
        let key = table.iter().find(|(key, _)| key.get_ref() == "assembly");
        self.robot.assembly_place = key.map(|(key, _)| key.span());
        for (joint, place) in places {
            let (stated, name) = (self.robot.assembly[&joint], self.robot.joint(joint).name.clone());
            let Some(value) = self.robot.coupled_value(joint) else { continue };
            if (stated - value).abs() > COUPLED * value.abs().max(1.0) {
                let value = number_text(value);
                let message =
                    format!("the joint `{name}` is at {}, and its coupling puts it at {value}", number_text(stated));
                self.toml.error(place, message, format!("leave `{name}` out, or write {value}"));
            }
        }
    }

    /// Reads the kind of a loop and the axis of a hinge. The pose is that of the joint's axes in those of the
    /// connection. `None` after recording a mistake.
    fn read_kind(&mut self, table: &'a DeTable<'a>, name: &Located, what: &str) -> Option<(Pose, LoopKind)> {
        let axis = self.toml.get(table, "axis");
        let direction = axis.map(|axis| (axis.span(), self.vector(axis, "`axis`")));
        let value = self.toml.required(table, "kind", what, &name.span)?;
        let kind = self.toml.string(value, "`kind`")?;
        let (kind, is_hinge) = match kind.text.as_str() {
            "connect" => (LoopKind::Connect, false),
            "weld" => (LoopKind::Weld, false),
            "hinge" => (LoopKind::Hinge(2), true),
            other => {
                let advice = nearest_name_advice(other, KINDS);
                let message = format!("there is no loop of the kind `{}`", shortened_for_message(other));
                self.toml.error(kind.span, message, advice);
                return None;
            }
        };
        match direction {
            None if is_hinge => {
                self.toml.error(name.span.clone(), format!("{what} has no `axis`"), "add `axis = [0, 0, 1]`");
                None
            }
            None => Some((Pose::default(), kind)),
            Some((place, _)) if !is_hinge => {
                let message = format!("{what} has an axis, and is no hinge");
                self.toml.error(place, message, "leave `axis` out, or write `kind = \"hinge\"`");
                Some((Pose::default(), kind))
            }
            Some((_, None)) => None,
            Some((place, Some(axis))) if axis.norm() == 0.0 => {
                self.toml.error(place, "the axis has the length 0", "give a direction such as [0, 0, 1]");
                None
            }
            Some((_, Some(axis))) => {
                let (turn, at) = hinge_frame(&axis);
                Some((turn, LoopKind::Hinge(at)))
            }
        }
    }

    /// Reads an end of a loop: the index of its link, and the pose on it. A point has no orientation. `None` after
    /// recording a mistake.
    fn read_end(&mut self, value: &'a Spanned<DeValue<'a>>, key: &str, is_point: bool) -> Option<(usize, Pose)> {
        let what = format!("`{key}`");
        let table = self.toml.table(value, &what, &format!("`{END}`"))?;
        self.toml.report_unknown_keys(table, &what, &["link", "xyz", "rpy"]);
        let position = self.toml.get(table, "xyz").map_or(Some(Vector3::zeros()), |xyz| self.vector(xyz, "`xyz`"));
        let rpy = self.toml.get(table, "rpy");
        let angles = rpy.map_or(Some(Vector3::zeros()), |rpy| self.vector(rpy, "`rpy`"));
        if let (Some(rpy), true) = (rpy, is_point) {
            let message = "a connection of points has no orientation";
            self.toml.error(rpy.span(), message, "leave `rpy` out, or write `kind = \"weld\"` or `kind = \"hinge\"`");
        }
        if let (Some(rpy), Some(angles)) = (rpy, angles)
            && angles.amax() > LARGEST_ANGLE
        {
            let message = format!("an angle of {} rad is more than two turns", angles[angles.iamax()]);
            self.toml.error(rpy.span(), message, "angles are in radians, not in degrees");
        }
        let link = self.toml.required(table, "link", &what, &value.span())?;
        let link = self.toml.string(link, "`link`")?;
        let Some(body) = self.robot.bodies.iter().position(|body| body.name == link.text) else {
            let advice = nearest_name_advice(&link.text, self.robot.bodies.iter().map(|body| body.name.as_str()));
            self.toml.error(link.span, format!("there is no link `{}`", link.text), advice);
            return None;
        };
        let rotation = roll_pitch_yaw(&angles?.map(|angle| self.reading.angle(angle)));
        Some((body, Pose { position: position?, rotation }))
    }

    /// Reads an equation between two joint coordinates. Mistakes are recorded.
    fn read_coupling(&mut self, name: &Located, value: &'a Spanned<DeValue<'a>>) {
        let what = format!("the coupling `{}`", name.text);
        let Some(table) = self.toml.table(value, &what, "`[couplings.NAME]` with `joint` and `follows`") else {
            return;
        };
        self.toml.report_unknown_keys(table, &what, &["joint", "follows", "multiplier", "offset"]);
        let mut joint_of = |key: &str| {
            let value = self.toml.required(table, key, &what, &name.span)?;
            let text = self.toml.string(value, &format!("`{key}`"))?;
            let joint = self.joint(&text)?;
            Some((joint, text.span))
        };
        let (follower, leader) = (joint_of("joint"), joint_of("follows"));
        let mut number_of = |key: &str, default: f64| {
            self.toml.get(table, key).map_or(Some(default), |value| self.number(value, &format!("`{key}`")))
        };
        let coefficients = [number_of("offset", 0.0), number_of("multiplier", 1.0)];
        let (Some((follower, place)), Some((leader, leader_place)), [Some(offset), Some(multiplier)]) =
            (follower, leader, coefficients)
        else {
            return;
        };
        let is_known = |joint: JointIndex| self.robot.couplings.iter().any(|one| one.follower == joint);
        if is_known(follower) {
            let message = format!("the joint `{}` follows another joint already", self.robot.joint(follower).name);
            self.toml.error(place, message, "let each joint follow one other joint");
            return;
        }
        if self.leads_to(leader, follower) {
            let message = format!("the joint `{}` follows itself", self.robot.joint(follower).name);
            self.toml.error(leader_place, message, "let one joint of these move freely");
            return;
        }
        let coefficients = vec![offset, multiplier];
        self.robot.couplings.push(Coupling { follower, leader: Some(leader), coefficients });
        self.robot.actuators.retain(|actuator| actuator.joint != follower);
    }

    /// True if a joint is another one, or follows it over any number of joints.
    fn leads_to(&self, joint: JointIndex, other: JointIndex) -> bool {
        let mut at = Some(joint);
        while let Some(joint) = at {
            if joint == other {
                return true;
            }
            at = self.robot.couplings.iter().find(|one| one.follower == joint).and_then(|one| one.leader);
        }
        false
    }

    /// Joint with one coordinate that a text of the file names. `None` after recording a mistake.
    fn joint(&mut self, name: &Located) -> Option<JointIndex> {
        let moving = self.robot.bodies.iter().enumerate().flat_map(|(body, one)| {
            one.joints.iter().enumerate().map(move |(joint, one)| (JointIndex { body, joint }, one))
        });
        let known: Vec<(JointIndex, &Joint)> = moving.collect();
        let Some((index, joint)) = known.iter().find(|(_, joint)| joint.name == name.text) else {
            let advice = nearest_name_advice(&name.text, known.iter().map(|(_, joint)| joint.name.as_str()));
            self.toml.error(name.span.clone(), format!("there is no moving joint `{}`", name.text), advice);
            return None;
        };
        if !joint.has_one_coordinate() {
            let message = format!("the joint `{}` has several coordinates", name.text);
            self.toml.error(name.span.clone(), message, "name a revolute, continuous or prismatic joint");
            return None;
        }
        Some(*index)
    }

    /// Reads a finite number. `None` after recording a mistake.
    fn number(&mut self, value: &Spanned<DeValue<'_>>, what: &str) -> Option<f64> {
        let text = match value.get_ref() {
            DeValue::Integer(number) if number.radix() == 10 => Some(number.as_str()),
            DeValue::Float(number) => Some(number.as_str()),
            _ => None,
        };
        let number = text.and_then(|text| text.parse::<f64>().ok()).filter(|number| number.is_finite());
        if number.is_none() {
            self.toml.error(value.span(), format!("{what} is no finite number"), "write a number such as 0.25 or 1e-3");
        }
        number
    }

    /// Reads three finite numbers. `None` after recording a mistake.
    fn vector(&mut self, value: &'a Spanned<DeValue<'a>>, what: &str) -> Option<Vector3<f64>> {
        let list = match value.get_ref() {
            DeValue::Array(list) if list.len() == 3 => list,
            _ => {
                self.not_three_numbers(value.span(), what);
                return None;
            }
        };
        let numbers: Vec<Option<f64>> = list.iter().map(|number| self.number(number, what)).collect();
        match numbers[..] {
            [Some(x), Some(y), Some(z)] => Some(Vector3::new(x, y, z)),
            _ => None,
        }
    }

    /// Records that a value is no list of three numbers.
    fn not_three_numbers(&mut self, place: Range<usize>, what: &str) {
        self.toml.error(place, format!("{what} is no list of three numbers"), "write it as [0, 0, 0.25]");
    }
}

/// Pose, in the axes of a connection, of axes one of which lies along a direction, with the index of that axis. The
/// axes of the connection are kept if one of them lies along the direction.
fn hinge_frame(direction: &Vector3<f64>) -> (Pose, usize) {
    let along: Vec<usize> = (0..3).filter(|axis| direction[*axis] != 0.0).collect();
    match along[..] {
        [axis] => (Pose::default(), axis),
        _ => (Pose { position: Vector3::zeros(), rotation: turn_to(direction) }, 2),
    }
}
