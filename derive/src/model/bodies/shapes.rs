//! Shapes of bodies, from the section `[shapes]` of a model file. Views draw them; no equation uses them.
//!
//! Invariant: no derived result depends on a shape. The hash of a model's text does not depend on shapes at the end
//! of the file ([`equations_text`]).

use super::elements::Elements;
use crate::algebra::Expr;
use crate::diagnostic::{nearest_name_advice, shortened_for_message};
use crate::model::Parameter;
use crate::model::impossible_bodies::{default_parameter_values, values_of_terms_at};
use crate::model::reading::declared_names::{CONSTANT, NameKind, PARAMETERS};
use crate::model::reading::loading::Loading;
use crate::model::units::{StatedUnit, Unit};
use crate::toml_reader::{Located, TomlReader};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A visible shape, such as a sphere or a disk, fixed in a frame.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Name of the shape in the model file.
    pub name: String,
    /// Description of the shape in words; empty if the model file gives none.
    pub about: String,
    /// Form of the shape.
    pub form: ShapeForm,
    /// Index of the body to which the shape belongs; `None` if the model file names no body.
    pub body: Option<usize>,
    /// Index of the frame in which the shape is fixed.
    pub frame: usize,
    /// Index of the point from which the position of the shape's centre is measured.
    pub point: usize,
    /// Components, in `frame`, of the vector from `point` to the shape's centre, m.
    pub position: [Expr; 3],
}

/// Form of a shape with its lengths, m, as terms in parameters.
#[derive(Clone, Debug)]
pub enum ShapeForm {
    /// Ball about the shape's centre.
    Sphere {
        /// Radius of the ball, m.
        radius: Expr,
    },
    /// Disk about an axis, 0, 1 or 2, of the shape's frame.
    Disk {
        /// Axis of the disk: 0, 1 or 2.
        axis: usize,
        /// Radius of the disk, m.
        radius: Expr,
        /// Thickness of the disk, m; `None` for a thin disk.
        thickness: Option<Expr>,
    },
    /// Cylinder about an axis, 0, 1 or 2, of the shape's frame.
    Cylinder {
        /// Axis of the cylinder: 0, 1 or 2.
        axis: usize,
        /// Radius of the cylinder, m.
        radius: Expr,
        /// Length of the cylinder, m.
        length: Expr,
    },
    /// Box with edges along the axes of the shape's frame.
    Box {
        /// Lengths of the edges along the three axes, m.
        size: [Expr; 3],
    },
    /// Line through points, in their order.
    Line {
        /// Indices of the points, at least two.
        through: Vec<usize>,
        /// Radius of the line, m; `None` for a thin line.
        radius: Option<Expr>,
    },
    /// Plane whose normal is an axis, 0, 1 or 2, of the shape's frame.
    Ground {
        /// Axis normal to the plane: 0, 1 or 2.
        axis: usize,
    },
}

impl ShapeForm {
    /// Lengths of the shape, each as (key that states it in the model file, term in m).
    #[must_use]
    pub fn lengths(&self) -> Vec<(&'static str, Expr)> {
        match self {
            Self::Sphere { radius } => vec![("radius", *radius)],
            Self::Disk { radius, thickness, .. } => {
                [("radius", *radius)].into_iter().chain(thickness.map(|e| ("thickness", e))).collect()
            }
            Self::Cylinder { radius, length, .. } => vec![("radius", *radius), ("length", *length)],
            Self::Box { size } => size.iter().map(|edge| ("size", *edge)).collect(),
            Self::Line { radius, .. } => radius.iter().map(|radius| ("radius", *radius)).collect(),
            Self::Ground { .. } => Vec::new(),
        }
    }
}

/// Kinds of shapes: the name of each kind, its own keys, and an example of an entry.
const KINDS: [(&str, &[&str], &str); 6] = [
    ("sphere", &["radius"], "{ kind = \"sphere\", body = \"bob\", radius = \"r\" }"),
    ("disk", &["radius", "thickness", "axis"], "{ kind = \"disk\", body = \"wheel\", axis = 3, radius = \"R\" }"),
    (
        "cylinder",
        &["radius", "length", "axis"],
        "{ kind = \"cylinder\", body = \"drum\", axis = 3, radius = \"r\", length = \"l\" }",
    ),
    ("box", &["size"], "{ kind = \"box\", body = \"crate\", size = [\"a\", \"b\", \"c\"] }"),
    ("line", &["through", "radius"], "{ kind = \"line\", through = [\"O\", \"P\"] }"),
    ("ground", &["axis"], "{ kind = \"ground\", axis = 3 }"),
];

/// Names of the kinds of shapes, in the order of [`KINDS`].
pub(crate) const SHAPE_KINDS: [&str; KINDS.len()] = {
    let mut names = [""; KINDS.len()];
    let mut at = 0;
    while at < names.len() {
        names[at] = KINDS[at].0;
        at += 1;
    }
    names
};

/// Keys that place a shape; a line has none of them.
const PLACE: [&str; 4] = ["body", "frame", "at", "position"];

/// Entry of `[shapes]` that is being read, with its name and place for error messages.
struct Entry<'a, 'b> {
    /// Table of the entry in the model file.
    table: &'a DeTable<'a>,
    /// Name of the shape in error messages, such as "shape `wheel`".
    what: &'b str,
    /// Byte range of the shape's name in the model file.
    owner: &'b Range<usize>,
}

impl<'a> Loading<'a> {
    /// Reads the section `[shapes]` of a model file. A shape may have the same name as a body. Wrong shapes are
    /// reported and left out.
    pub fn shapes(&mut self, table: &'a DeTable<'a>, elements: &Elements, parameters: &[Parameter]) -> Vec<Shape> {
        let mut list = Vec::new();
        for (name, value) in self.section(table, "shapes", &[]) {
            if name.text.trim().is_empty() {
                self.reader.error(name.span, "a shape has no name", "name it, such as [shapes.wheel]");
                continue;
            }
            let what = format!("shape `{}`", shortened_for_message(&name.text));
            let Some(table) = self.reader.table(value, &what, KINDS[0].2) else { continue };
            let before = self.reader.errors.len();
            let shape = self.shape(elements, &name, &Entry { table, what: &what, owner: &name.span });
            let Some(shape) = shape.filter(|_| self.reader.errors.len() == before) else { continue };
            self.report_nonpositive_lengths(parameters, &shape, &name.span, table);
            list.push(shape);
        }
        list
    }

    /// Reads a single shape; `None` after an error is reported.
    fn shape(&mut self, elements: &Elements, name: &Located, entry: &Entry<'a, '_>) -> Option<Shape> {
        let kind = self.reader.required(entry.table, "kind", entry.what, entry.owner)?;
        let kind = self.reader.string(kind, "`kind`")?;
        let Some((kind, keys, _)) = KINDS.iter().find(|(known, ..)| *known == kind.text) else {
            let message = format!("there is no kind of shape `{}`", shortened_for_message(&kind.text));
            self.reader.error(
                kind.span,
                message,
                nearest_name_advice(&kind.text, KINDS.iter().map(|(known, ..)| *known)),
            );
            return None;
        };
        let place: &[&str] = if *kind == "line" { &[] } else { &PLACE };
        let article = if *kind == "ground" { "the ground".to_owned() } else { format!("a {kind}") };
        self.reader.report_unknown_keys(entry.table, &article, &[&["kind", "about"], *keys, place].concat());
        let about = self.about(entry.table);
        let form = self.shape_form(elements, kind, entry);
        let (body, frame, point) =
            if *kind == "line" { (None, 0, 0) } else { self.shape_place(elements, kind, entry)? };
        let position = match self.reader.get(entry.table, "position") {
            Some(_) => self.lengths(entry, "position")?,
            None => [Expr::ZERO; 3],
        };
        Some(Shape { name: name.text.clone(), about, form: form?, body, frame, point, position })
    }

    /// Reads the form of a shape of the given kind, with its lengths. `None` after an error is reported.
    fn shape_form(&mut self, elements: &Elements, kind: &str, entry: &Entry<'a, '_>) -> Option<ShapeForm> {
        let axis = match self.reader.get(entry.table, "axis") {
            Some(value) => self.shape_axis(value)?,
            None => 2,
        };
        Some(match kind {
            "sphere" => ShapeForm::Sphere { radius: self.required_shape_length(entry, "radius")? },
            "disk" => {
                let thickness = self.optional_shape_length(entry, "thickness");
                ShapeForm::Disk { axis, radius: self.required_shape_length(entry, "radius")?, thickness }
            }
            "cylinder" => {
                let length = self.required_shape_length(entry, "length");
                ShapeForm::Cylinder { axis, radius: self.required_shape_length(entry, "radius")?, length: length? }
            }
            "box" => {
                let size = self.lengths(entry, "size")?;
                ShapeForm::Box { size }
            }
            "line" => {
                let radius = self.optional_shape_length(entry, "radius");
                ShapeForm::Line { through: self.shape_line_points(elements, entry)?, radius }
            }
            _ => ShapeForm::Ground { axis },
        })
    }

    /// Reads the number of a shape's axis, 1, 2 or 3, as 0, 1 or 2. `None` after reporting any other value.
    fn shape_axis(&mut self, value: &'a Spanned<DeValue<'a>>) -> Option<usize> {
        let axis = match value.get_ref() {
            DeValue::Integer(n) => ["1", "2", "3"].iter().position(|axis| *axis == n.as_str()),
            _ => None,
        };
        if axis.is_none() {
            self.reader.error(value.span(), "the axis of a shape is 1, 2 or 3", "write axis = 3");
        }
        axis
    }

    /// Reads a required length of a shape, m; `None` after an error is reported.
    fn required_shape_length(&mut self, entry: &Entry<'a, '_>, key: &str) -> Option<Expr> {
        self.reader.required(entry.table, key, entry.what, entry.owner)?;
        self.optional_shape_length(entry, key)
    }

    /// Reads an optional length of a shape, m. `None` if the key is absent, or after an error is reported; such an
    /// error makes the reader leave the shape out.
    fn optional_shape_length(&mut self, entry: &Entry<'a, '_>, key: &str) -> Option<Expr> {
        let value = self.reader.get(entry.table, key)?;
        let formula = self.reader.formula(value, &format!("`{key}`"))?;
        self.shape_length(&formula, &format!("the {key} of {}", entry.what))
    }

    /// Reads three lengths of a shape under one key, m; `None` after an error is reported.
    fn lengths(&mut self, entry: &Entry<'a, '_>, key: &str) -> Option<[Expr; 3]> {
        let value = self.reader.required(entry.table, key, entry.what, entry.owner)?;
        let triple = self.reader.triple(value, &format!("`{key}`"))?;
        let what = format!("the {key} of {}", entry.what);
        let [a, b, c] = triple.map(|formula| self.shape_length(&formula, &what));
        Some([a?, b?, c?])
    }

    /// Reads a length of a shape, m: a formula of parameters, or a number with a unit of length. A number does not
    /// become a parameter, since no equation contains it. `None` after an error is reported.
    fn shape_length(&mut self, formula: &Located, what: &str) -> Option<Expr> {
        let metre = Unit::new(1, 0, 0);
        let Some(stated) = StatedUnit::of(&formula.text) else {
            return self.quantity(formula, PARAMETERS, &metre, what);
        };
        if stated.unit != metre {
            let unit = stated.unit.unit_words();
            let message = format!("{what} must be in m, but `{}` is in {unit}", shortened_for_message(&formula.text));
            self.reader.error(formula.span.clone(), message, "give a length, such as \"2 cm\"");
            return None;
        }
        let number = self.names.formula(
            &mut self.reader,
            &mut self.arena,
            &stated.number_before_unit(formula),
            CONSTANT,
            what,
        )?;
        Some(stated.apply(&mut self.arena, number))
    }

    /// Reads `through`: indices of the points of a line. `None` after reporting fewer than two points
    /// or an unknown point.
    fn shape_line_points(&mut self, elements: &Elements, entry: &Entry<'a, '_>) -> Option<Vec<usize>> {
        let value = self.reader.required(entry.table, "through", entry.what, entry.owner)?;
        let help = "name two points or more, such as through = [\"O\", \"P\"]";
        let DeValue::Array(array) = value.get_ref() else {
            self.reader.error(value.span(), "`through` must be a list of points", help);
            return None;
        };
        if array.len() < 2 {
            self.reader.error(value.span(), format!("{} goes through fewer than two points", entry.what), help);
            return None;
        }
        let points: Vec<Option<usize>> = array
            .iter()
            .map(|name| {
                let name = self.reader.string(name, "a point of `through`")?;
                let known = self.names.expect(&mut self.reader, &name, NameKind::Point);
                elements.points.iter().position(|point| known && point.name == name.text)
            })
            .collect();
        points.into_iter().collect()
    }

    /// Reads the body, frame and point of a shape, as indices. Unless the shape states a frame or point, those of its
    /// body are used. `None` after reporting a shape without a place.
    fn shape_place(
        &mut self,
        elements: &Elements,
        kind: &str,
        entry: &Entry<'a, '_>,
    ) -> Option<(Option<usize>, usize, usize)> {
        let body = match self.reader.get(entry.table, "body") {
            None => None,
            Some(value) => {
                let name = self.reader.string(value, "`body`")?;
                let known = self.names.expect(&mut self.reader, &name, NameKind::Body);
                Some(elements.bodies.iter().position(|body| known && body.name == name.text)?)
            }
        };
        let stated = |loading: &Self, key: &str| loading.reader.get(entry.table, key).is_some();
        let has_place = body.is_some() || kind == "ground" || (stated(self, "frame") && stated(self, "at"));
        if !has_place {
            let help = "add `body = …`, or both `frame = …` and `at = …`";
            self.reader.error(entry.owner.clone(), format!("{} is nowhere", entry.what), help);
            return None;
        }
        let of_body = body.map(|body| &elements.bodies[body]);
        let frame = if stated(self, "frame") {
            elements.frame(self, entry.table, entry.what, entry.owner)
        } else {
            Some(of_body.and_then(|body| body.rigid.as_ref()).map_or(0, |(frame, _)| *frame))
        };
        let point = if stated(self, "at") {
            elements.point(self, entry.table, "at", entry.what, entry.owner)
        } else {
            Some(of_body.map_or(0, |body| body.centre))
        };
        Some((body, frame?, point?))
    }

    /// Reports lengths of a shape that are not positive at the default values of the parameters.
    fn report_nonpositive_lengths(
        &mut self,
        parameters: &[Parameter],
        shape: &Shape,
        owner: &Range<usize>,
        table: &'a DeTable<'a>,
    ) {
        let known = default_parameter_values(parameters);
        for (key, length) in shape.form.lengths() {
            let value = values_of_terms_at(&self.arena, &known, &[length]).map(|values| values[0]);
            if let Some(value) = value.filter(|value| value.is_nan() || *value <= 0.0) {
                let span = self.reader.get(table, key).map_or_else(|| owner.clone(), Spanned::span);
                let message = format!(
                    "the {key} of shape `{}` is {value} at the default values",
                    shortened_for_message(&shape.name)
                );
                self.reader.error(span, message, "what can be seen is longer than 0");
            }
        }
    }
}

/// Part of a model's text from which equations are derived. The sections `[shapes]` and `[notation]` at the end of
/// the file are left out, and blank lines before them.
///
/// A section `[shapes]` or `[notation]` stays if another section follows it. A line that only resembles a section
/// header stays too, such as a line in a longer string.
#[must_use]
pub fn equations_text(text: &str) -> &str {
    let is_look = |line: &str| ["[shapes]", "[shapes.", "[notation]"].iter().any(|look| line.starts_with(look));
    let starts = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1));
    // A header may be indented. A line that only resembles a header keeps the whole text.
    let mut headers = starts
        .filter(|at| text[*at..].trim_start_matches([' ', '\t']).starts_with('['))
        .skip_while(|at| !is_look(&text[*at..]));
    let Some(first) = headers.next() else { return text };
    if !headers.all(|at| is_look(&text[at..])) {
        return text;
    }
    let mut rest = &text[..first];
    while rest.ends_with("\n\n") {
        rest = &rest[..rest.len() - 1];
    }
    // If the cut goes through a string or an array, the rest is no valid file, and the whole text is
    // kept.
    let source = crate::diagnostic::Source::from_text("model.toml", rest);
    if TomlReader::parse(&source).is_ok() { rest } else { text }
}

#[cfg(test)]
mod tests {
    use super::equations_text;

    /// Goal: only shapes and notation at the end of a text are left out. Method: texts with shapes at the end, before
    /// other sections, and inside strings and arrays.
    #[test]
    fn shapes_at_the_end_of_a_file_are_no_part_of_its_equations() {
        let model = "name = \"a\"\n[points]\nP = 1\n";
        for shapes in [
            "[shapes]\nx = 1\n",
            "\n\n[shapes]\n# a\nx = { y = 1 }\n",
            "[shapes.x]\ny = 1\n[notation]\nx = \"y\"\n[shapes.z]\ny = 2\n",
        ] {
            assert_eq!(equations_text(&format!("{model}{shapes}")), model, "{shapes}");
        }
        for whole in [
            model.to_owned(),
            format!("[shapes]\nx = 1\n{model}[points]\n"),
            format!("{model}[shapes]\nx = 1\n[frames]\n"),
            format!("{model}about = \"\"\"\n[shapes]\n\"\"\"\n"),
            format!("{model}list = [\n[shapes]\n]\n"),
            format!("{model}[notations]\nx = 1\n"),
            format!("{model}[shapes]\nx = 1\n  [forces.f]\ny = 2\n"),
            format!("{model}[notation]\nx = 1\n\t[ forces . f ]\ny = 2\n"),
        ] {
            assert_eq!(equations_text(&whole), whole);
        }
    }
}
