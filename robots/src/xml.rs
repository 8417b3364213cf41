//! Elements and attributes of XML files, whose mistakes are collected with their places.

use crate::Options;
use crate::meshes::{Bounds, Meshes};
use crate::numbers::{number_text, rounded_multiple};
use crate::pose::Pose;
use crate::robot::{Omission, Robot, Shape, Solid};
use nalgebra::Vector3;
use roxmltree::{Document, Node, ParsingOptions};
use std::cell::RefCell;
use std::ops::Range;
use std::path::Path;
use tripos_derive::diagnostic::{Diagnostic, Diagnostics, Source, shortened_for_message};

/// Deepest nesting of elements that is read.
const MAX_DEPTH: usize = 200;

/// State of reading a file: its mistakes and omissions so far.
#[derive(Default)]
pub struct Reading {
    /// Mistakes so far.
    mistakes: RefCell<Vec<Diagnostic>>,
    /// Parts left out or simplified so far.
    omissions: RefCell<Vec<Omission>>,
    /// True if angles keep the digits of the file.
    is_as_written: bool,
    /// Bounds of the meshes that the file names.
    pub meshes: Meshes,
}

impl Reading {
    /// Begins to read the file at a path with these options.
    pub fn new(options: Options, path: &Path) -> Self {
        Self { is_as_written: options.is_as_written, meshes: Meshes::new(path), ..Self::default() }
    }

    /// Records a mistake at a byte range of the file, with advice.
    pub fn add(&self, place: Range<usize>, message: impl Into<String>, advice: impl Into<String>) {
        self.mistakes.borrow_mut().push(Diagnostic::new(place, message, advice));
    }

    /// Records a mistake that belongs to a second place, which `label` describes.
    pub fn add_with_other(&self, place: Range<usize>, message: String, advice: &str, other: Range<usize>, label: &str) {
        self.mistakes.borrow_mut().push(Diagnostic::new(place, message, advice).with_other(other, label));
    }

    /// Counts a part of the file that is left out or simplified.
    pub fn omit(&self, text: impl Into<String>) {
        Omission::add(&mut self.omissions.borrow_mut(), &text.into());
    }

    /// Shape of a mesh with a name, of which the frame has the pose `pose`: the box at its bounds. `None` after
    /// counting the mesh as left out, if it has no bounds.
    pub fn mesh_shape(&self, name: &str, bounds: Result<Bounds, String>, pose: &Pose) -> Option<Shape> {
        match bounds.and_then(|bounds| Ok((bounds.middle(), bounds.edges()?))) {
            Ok((middle, edges)) => {
                self.omit("form of a mesh: it is drawn as the box at its bounds");
                let pose = pose.compose(&Pose::at(middle));
                Some(Shape { solid: Solid::Block(edges), pose, mesh: Some(name.to_owned()) })
            }
            Err(reason) => {
                self.omit(format!("mesh {name}: {reason}"));
                None
            }
        }
    }

    /// Number of mistakes so far.
    pub fn count(&self) -> usize {
        self.mistakes.borrow().len()
    }

    /// Angle in rad. If its printed digits are those of a multiple of a twelfth of π, gives the multiple and records
    /// that; otherwise, or if angles keep their digits, gives the angle itself.
    pub fn angle(&self, angle: f64) -> f64 {
        let Some((multiple, text)) = rounded_multiple(angle).filter(|_| !self.is_as_written) else { return angle };
        if (multiple - angle).abs() > 4.0 * f64::EPSILON * multiple.abs() {
            self.omit(format!("digits of the angle {} rad: it is read as {text}", number_text(angle)));
        }
        multiple
    }

    /// Parts left out or simplified.
    pub fn into_omissions(self) -> Vec<Omission> {
        self.omissions.into_inner()
    }

    /// Gives the robot, with the omissions, if no mistake was recorded.
    ///
    /// # Errors
    /// All mistakes, in the order of their places.
    pub fn into_result(self, source: &Source, mut robot: Robot) -> Result<Robot, Diagnostics> {
        let list = self.mistakes.into_inner();
        robot.omissions = self.omissions.into_inner();
        if list.is_empty() { Ok(robot) } else { Err(Diagnostics::new(source.clone(), list)) }
    }
}

/// Number of characters of the longest reason of the parser that a message repeats in full.
const LONGEST_REASON: usize = 200;

/// Parses XML. Entities of a document type, elements nested more than 200 deep, and text that is no XML are refused.
///
/// # Errors
/// One diagnostic with its place.
pub fn parse(source: &Source) -> Result<Document<'_>, Diagnostics> {
    let fail = |place: Range<usize>, message: String, advice: &str| {
        Err(Diagnostics::new(source.clone(), vec![Diagnostic::new(place, message, advice)]))
    };
    let mut depth = 0_usize;
    for (at, character) in source.text.char_indices().filter(|(_, c)| *c == '<') {
        let rest = &source.text[at + character.len_utf8()..];
        if rest.starts_with('/') {
            depth = depth.saturating_sub(1);
        } else if rest.starts_with(char::is_alphabetic) {
            let end = rest.find('>').unwrap_or(0);
            depth += usize::from(!rest[..end].ends_with('/'));
        }
        if depth > MAX_DEPTH {
            let message = format!("elements are nested more than {MAX_DEPTH} deep");
            return fail(at..at + 1, message, "give a robot description whose bodies are nested less deep");
        }
    }
    // A document type is read, but entities, which can grow without bound, are not.
    let options = ParsingOptions { allow_dtd: !source.text.contains("<!ENTITY"), ..ParsingOptions::default() };
    match Document::parse_with_options(&source.text, options) {
        Ok(document) => Ok(document),
        Err(error) => {
            let at = offset_of(&source.text, error.pos());
            let is_macro = matches!(&error, roxmltree::Error::UnknownNamespace(prefix, _) if prefix == "xacro");
            let advice = if is_macro { XACRO } else { "give a robot description in XML: URDF or MJCF" };
            // The place is not repeated in the message.
            let (why, position) = (error.to_string(), format!(" at {}", error.pos()));
            let why = why.strip_suffix(&position).unwrap_or(&why);
            let length = source.text[at..].chars().next().map_or(0, char::len_utf8);
            // The parser repeats names of any length.
            let why =
                why.char_indices().nth(LONGEST_REASON).map_or(why.to_owned(), |(end, _)| format!("{}…", &why[..end]));
            fail(at..at + length, format!("this is no XML that can be read: {why}"), advice)
        }
    }
}

/// Advice for a file of xacro macros.
pub const XACRO: &str = "expand the macros first: xacro robot.urdf.xacro > robot.urdf";

/// Byte offset of a row and a column, counted from 1 in characters.
fn offset_of(text: &str, position: roxmltree::TextPos) -> usize {
    let row = usize::try_from(position.row).unwrap_or(1).max(1);
    let column = usize::try_from(position.col).unwrap_or(1).max(1);
    let start = text.split_inclusive('\n').take(row - 1).map(str::len).sum::<usize>();
    let line = text[start.min(text.len())..].split('\n').next().unwrap_or("");
    start + line.char_indices().nth(column - 1).map_or(line.len(), |(at, _)| at)
}

/// Byte range of an element's opening tag.
pub fn place(node: Node<'_, '_>) -> Range<usize> {
    let range = node.range();
    let text = &node.document().input_text()[range.clone()];
    let length = text.find('>').map_or(text.len(), |at| at + 1);
    range.start..range.start + length
}

/// Byte range of an attribute's value.
pub fn attribute_place(node: Node<'_, '_>, name: &str) -> Range<usize> {
    node.attribute_node(name).map_or_else(|| place(node), |attribute| attribute.range_value())
}

/// Child elements of an element, in the order of the file.
pub fn elements<'a, 'i>(node: Node<'a, 'i>) -> impl Iterator<Item = Node<'a, 'i>> {
    node.children().filter(Node::is_element)
}

/// First child element with a name.
pub fn element<'a, 'i>(node: Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    elements(node).find(|child| child.has_tag_name(name))
}

/// Numbers of a text, separated by white space; `None` after recording a mistake at `place`.
pub fn numbers_of(text: &str, place: &Range<usize>, what: &str, reading: &Reading) -> Option<Vec<f64>> {
    let mut numbers = Vec::new();
    for word in text.split_whitespace() {
        match word.parse::<f64>() {
            Ok(number) if number.is_finite() => numbers.push(number),
            _ => {
                let advice = if word.contains("${") {
                    XACRO
                } else if word.contains(',') {
                    "separate numbers by blanks, without commas"
                } else {
                    "write a finite number such as 0.25 or 1e-3"
                };
                reading.add(
                    place.clone(),
                    format!("{what} has `{}`, which is no number", shortened_for_message(word)),
                    advice,
                );
                return None;
            }
        }
    }
    Some(numbers)
}

/// True if a text has a number other than 0 among the numbers that white space separates.
pub fn has_nonzero_number(text: &str) -> bool {
    text.split_whitespace().filter_map(|word| word.parse::<f64>().ok()).any(|number| number != 0.0)
}

/// Attribute with exactly `N` numbers. `None` if the attribute is absent, or after recording a mistake.
pub fn fixed_numbers<const N: usize>(node: Node<'_, '_>, name: &str, reading: &Reading) -> Option<[f64; N]> {
    let text = node.attribute(name)?;
    let place = attribute_place(node, name);
    let numbers = numbers_of(text, &place, &format!("`{name}`"), reading)?;
    let count = numbers.len();
    let fixed = <[f64; N]>::try_from(numbers).ok();
    if fixed.is_none() {
        let wanted = if N == 1 { "one number".to_owned() } else { format!("{N} numbers") };
        reading.add(place, format!("`{name}` has {count} numbers"), format!("give {wanted}"));
    }
    fixed
}

/// Attribute with one number. `None` if the attribute is absent, or after recording a mistake.
pub fn number(node: Node<'_, '_>, name: &str, reading: &Reading) -> Option<f64> {
    fixed_numbers::<1>(node, name, reading).map(|[number]| number)
}

/// Attribute with three numbers, as a vector. `None` if the attribute is absent, or after recording a mistake.
pub fn vector(node: Node<'_, '_>, name: &str, reading: &Reading) -> Option<Vector3<f64>> {
    fixed_numbers::<3>(node, name, reading).map(Vector3::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first error of a text: its part of the text, and its message.
    fn error(text: &str) -> (String, String) {
        let source = Source::from_text("robot.urdf", text);
        let errors = parse(&source).map(drop).unwrap_err();
        let place = errors.list[0].span.clone().unwrap();
        (source.text[place].to_owned(), errors.list[0].message.clone())
    }

    #[test]
    fn errors_of_xml_have_a_whole_character_as_their_place() {
        let (part, message) = error("<robot name=\"ô\"ô></robot>");
        assert_eq!(part, "ô");
        assert_eq!(message, "this is no XML that can be read: expected a whitespace not 'ô'");
        let (_, message) = error(&format!("<robot><{}></robot>", "a".repeat(1000)));
        assert!(message.chars().count() < 300, "{message}");
        let (_, message) = error("<robot name\u{1b}=\"a\"/>");
        assert!(message.ends_with("expected '=' not '\\u{1b}'"), "{message}");
    }
}
