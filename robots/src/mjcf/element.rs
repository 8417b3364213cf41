//! Elements of MJCF files with the defaults of their classes.

use crate::pose::{Pose, axis_turn, quaternion_turn, turn_about, turn_to};
use crate::xml::{Reading, elements, numbers_of, place};
use nalgebra::{Matrix3, Vector3};
use roxmltree::Node;
use std::collections::BTreeMap;
use std::ops::Range;
use tripos_derive::diagnostic::nearest_name_advice;

/// Attributes that a class gives to elements of one tag: name, value and place in the file.
type TagDefaults<'a> = BTreeMap<&'a str, (&'a str, Range<usize>)>;
/// Attributes that a class gives, by tag.
type ClassDefaults<'a> = BTreeMap<&'a str, TagDefaults<'a>>;

/// Default classes of a file. Each contains the attributes of the classes around it.
#[derive(Default)]
pub struct Defaults<'a> {
    /// Attributes of the outermost class.
    main: ClassDefaults<'a>,
    /// Attributes by class.
    classes: BTreeMap<&'a str, ClassDefaults<'a>>,
}

impl<'a> Defaults<'a> {
    /// Reads the outermost `<default>` element.
    pub fn read(&mut self, node: Node<'a, '_>) {
        self.main = self.read_class(node, self.main.clone());
    }

    /// Reads a class, which starts from the attributes of the class around it.
    fn read_class(&mut self, node: Node<'a, '_>, around: ClassDefaults<'a>) -> ClassDefaults<'a> {
        let mut class = around;
        for child in elements(node).filter(|child| !child.has_tag_name("default")) {
            let tag = class.entry(child.tag_name().name()).or_default();
            for attribute in child.attributes() {
                tag.insert(attribute.name(), (attribute.value(), attribute.range_value()));
            }
        }
        for child in elements(node).filter(|child| child.has_tag_name("default")) {
            let inner = self.read_class(child, class.clone());
            if let Some(name) = child.attribute("class") {
                self.classes.insert(name, inner);
            }
        }
        if let Some(name) = node.attribute("class") {
            self.classes.insert(name, class.clone());
        }
        class
    }

    /// Element with the defaults of its class: its own, or `around`, that of the bodies around it. An unknown class
    /// is a mistake.
    pub fn element<'d, 'i>(
        &'d self,
        node: Node<'a, 'i>,
        around: Option<&str>,
        reading: &Reading,
    ) -> Element<'d, 'a, 'i> {
        self.element_as(node.tag_name().name(), node, around, reading)
    }

    /// Element with the defaults of its own class; an unknown class gives none.
    pub fn known_element<'d, 'i>(&'d self, node: Node<'a, 'i>) -> Element<'d, 'a, 'i> {
        let class = node.attribute("class").and_then(|name| self.classes.get(name));
        Element { node, defaults: class.unwrap_or(&self.main).get(node.tag_name().name()) }
    }

    /// Element as [`Self::element`] gives it, with the defaults that classes state under the tag `tag`.
    pub fn element_as<'d, 'i>(
        &'d self,
        tag: &str,
        node: Node<'a, 'i>,
        around: Option<&str>,
        reading: &Reading,
    ) -> Element<'d, 'a, 'i> {
        let name = node.attribute("class").or(around);
        let class = name.and_then(|name| self.classes.get(name));
        if let (Some(name), None) = (name, class)
            && name != "main"
        {
            let advice = nearest_name_advice(name, self.classes.keys().copied());
            reading.add(place(node), format!("there is no default class `{name}`"), advice);
        }
        Element { node, defaults: class.unwrap_or(&self.main).get(tag) }
    }
}

/// An element with the defaults of its class.
#[derive(Clone, Copy)]
pub struct Element<'d, 'a, 'i> {
    /// Element of the file.
    pub node: Node<'a, 'i>,
    /// Attributes that the class gives.
    defaults: Option<&'d TagDefaults<'a>>,
}

impl<'a> Element<'_, 'a, '_> {
    /// Text of an attribute with its place; `None` if neither the element nor its class has the attribute.
    fn attribute(&self, name: &str) -> Option<(&'a str, Range<usize>)> {
        let own = self.node.attribute_node(name).map(|attribute| (attribute.value(), attribute.range_value()));
        own.or_else(|| self.defaults.and_then(|defaults| defaults.get(name)).cloned())
    }

    /// Text of an attribute; `None` if neither the element nor its class has it.
    pub fn text(&self, name: &str) -> Option<&'a str> {
        self.attribute(name).map(|(text, _)| text)
    }

    /// Place of an attribute in the file, or of the element if the attribute is absent.
    pub fn place_of(&self, name: &str) -> Range<usize> {
        self.attribute(name).map_or_else(|| place(self.node), |(_, place)| place)
    }

    /// Numbers of an attribute. `None` if it is absent, or after recording a mistake.
    pub fn numbers(&self, name: &str, reading: &Reading) -> Option<Vec<f64>> {
        let (text, place) = self.attribute(name)?;
        numbers_of(text, &place, &format!("`{name}`"), reading)
    }

    /// First number of an attribute. `None` if the attribute is absent or empty, or after recording a mistake.
    pub fn number(&self, name: &str, reading: &Reading) -> Option<f64> {
        self.numbers(name, reading)?.first().copied()
    }

    /// Exactly `N` numbers of an attribute. `None` if the attribute is absent, or after recording a mistake.
    pub fn fixed<const N: usize>(&self, name: &str, reading: &Reading) -> Option<[f64; N]> {
        let numbers = self.numbers(name, reading)?;
        let count = numbers.len();
        let fixed = <[f64; N]>::try_from(numbers).ok();
        if fixed.is_none() {
            let message = format!("`{name}` has {count} numbers");
            reading.add(self.place_of(name), message, format!("give {N} numbers"));
        }
        fixed
    }

    /// Three numbers of an attribute, as a vector.
    pub fn vector(&self, name: &str, reading: &Reading) -> Option<Vector3<f64>> {
        self.fixed::<3>(name, reading).map(Vector3::from)
    }
}

/// Settings of `<compiler>` that say how numbers of the file are read.
pub struct Angles {
    /// Size of an angle of 1 in rad.
    pub unit: f64,
    /// Axes of Euler angles, each x, y or z; capital letters are axes of the outer frame.
    pub sequence: String,
}

/// Attributes that state an orientation.
const ORIENTATIONS: [&str; 5] = ["quat", "axisangle", "xyaxes", "zaxis", "euler"];

/// Reads the pose of an element: `pos` and one of the attributes of orientation.
pub fn read_pose(element: &Element<'_, '_, '_>, angles: &Angles, reading: &Reading) -> Pose {
    let position = element.vector("pos", reading).unwrap_or_default();
    Pose { position, rotation: read_orientation(element, angles, reading).unwrap_or_else(Matrix3::identity) }
}

/// Reads the orientation of an element. `None` if it states none, or after recording a mistake.
pub fn read_orientation(element: &Element<'_, '_, '_>, angles: &Angles, reading: &Reading) -> Option<Matrix3<f64>> {
    let own: Vec<&str> = ORIENTATIONS.into_iter().filter(|name| element.node.has_attribute(*name)).collect();
    if let [first, second, ..] = own[..] {
        let message = format!("both `{first}` and `{second}` state the orientation");
        reading.add(element.place_of(second), message, "give one of them");
        return None;
    }
    let name = own.first().copied().or_else(|| ORIENTATIONS.into_iter().find(|name| element.text(name).is_some()))?;
    let zero = |reading: &Reading| {
        reading.add(element.place_of(name), format!("`{name}` states no direction"), "give a vector that is not 0");
        None
    };
    match name {
        "quat" => {
            let [w, x, y, z] = element.fixed::<4>(name, reading)?;
            if [w, x, y, z].iter().all(|part| *part == 0.0) {
                return zero(reading);
            }
            Some(quaternion_turn(w, x, y, z))
        }
        "axisangle" => {
            let [x, y, z, angle] = element.fixed::<4>(name, reading)?;
            let axis = Vector3::new(x, y, z);
            if axis.norm() == 0.0 {
                return zero(reading);
            }
            Some(turn_about(&axis, reading.angle(angle * angles.unit)))
        }
        "xyaxes" => {
            let [a, b, c, d, e, f] = element.fixed::<6>(name, reading)?;
            let first = Vector3::new(a, b, c);
            let along = Vector3::new(d, e, f);
            if first.norm() == 0.0 || first.cross(&along).norm() == 0.0 {
                return zero(reading);
            }
            let first = first.normalize();
            let second = (along - first * first.dot(&along)).normalize();
            Some(Matrix3::from_columns(&[first, second, first.cross(&second)]))
        }
        "zaxis" => {
            let axis = element.vector(name, reading)?;
            if axis.norm() == 0.0 {
                return zero(reading);
            }
            Some(turn_to(&axis))
        }
        _ => {
            let [a, b, c] = element.fixed::<3>(name, reading)?;
            let mut rotation = Matrix3::identity();
            for (letter, angle) in angles.sequence.chars().zip([a, b, c]) {
                let axis = "xyz".find(letter.to_ascii_lowercase()).unwrap_or(0);
                let turn = axis_turn(axis, reading.angle(angle * angles.unit));
                rotation = if letter.is_ascii_uppercase() { turn * rotation } else { rotation * turn };
            }
            Some(rotation)
        }
    }
}
