//! Parser for the text of a quantity, such as `v(Cstar) @ B [1]`. It resolves every name in a model and gives a
//! [`Quantity`].

use crate::diagnostic::{nearest_name_advice, shortened_for_message};
use crate::mechanics::quantity::{EnergyQuantity, Quantity, QuantityKind, QuantityOwner, RowQuantity, VectorName};
use crate::model::Model;
use std::ops::Range;

/// Error in the text of a quantity, with its place and advice.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct QuantityError {
    /// Description of the error, in a single line.
    pub message: String,
    /// Advice for the user on how to correct the text.
    pub help: String,
    /// Position of the error, as a byte range of the parsed text.
    pub range: Range<usize>,
}

/// First words of quantities that are neither vectors, rows nor energies.
const OTHER_NAMES: [&str; 7] = ["rotation", "d", "I", "M", "E", "C", "Edot"];

impl Quantity {
    /// Parses the name of a quantity, such as `v(Cstar) @ B [1]`. `docs/publication.md` lists all names.
    ///
    /// # Errors
    /// Returns the first [`QuantityError`] in the text: its form is wrong, or the model has no such point, frame,
    /// body, speed, coordinate or component.
    pub fn parse(text: &str, model: &Model) -> Result<Self, QuantityError> {
        let mut cursor = QuantityParser { text, at: 0, model, form: String::new() };
        cursor.skip_space();
        let kind = cursor.quantity()?;
        if cursor.at < text.len() {
            let message =
                format!("`{}` does not belong to the name of a quantity", shortened_for_message(&text[cursor.at..]));
            return Err(cursor.error(cursor.at..text.len(), message));
        }
        Ok(Self::new(kind, model))
    }
}

/// Word of the parsed text, with its byte range.
type Word<'a> = (&'a str, Range<usize>);

/// State of the parser: the text of a quantity, and the position in it.
struct QuantityParser<'a> {
    /// Whole text of the quantity that is being parsed.
    text: &'a str,
    /// Byte offset of the next character to read.
    at: usize,
    /// Model in which names are resolved.
    model: &'a Model,
    /// Expected form of the quantity, such as `v(POINT) @ FRAME [COMPONENT]`. Empty until the quantity's kind is
    /// known.
    form: String,
}

impl<'a> QuantityParser<'a> {
    /// Moves the position past white space.
    fn skip_space(&mut self) {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
    }

    /// Creates an error at a byte range. Its advice is the expected form of the quantity.
    fn error(&self, range: Range<usize>, message: impl Into<String>) -> QuantityError {
        let help = if self.form.is_empty() {
            "write the name of one quantity, such as v(P) @ B [1]; docs/publication.md lists them".to_owned()
        } else {
            format!("the form is `{}`", self.form)
        };
        QuantityError { message: message.into(), help, range }
    }

    /// True if the next character of the text is `mark`.
    fn next_is(&self, mark: char) -> bool {
        self.text[self.at..].starts_with(mark)
    }

    /// Reads the character `mark` and the white space after it. Returns an error if `mark` is missing.
    fn parse_mark(&mut self, mark: char) -> Result<(), QuantityError> {
        if !self.next_is(mark) {
            let length = self.text[self.at..].chars().next().map_or(0, char::len_utf8);
            return Err(self.error(self.at..self.at + length, format!("`{mark}` is missing here")));
        }
        self.at += mark.len_utf8();
        self.skip_space();
        Ok(())
    }

    /// Reads a word: letters, digits and `_`, then primes. Returns an error if it is missing; `what` is the noun for
    /// the word in this error.
    fn parse_word(&mut self, what: &str) -> Result<Word<'a>, QuantityError> {
        let rest = &self.text[self.at..];
        let plain = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(rest.len());
        let primes = rest[plain..].bytes().take_while(|b| *b == b'\'').count();
        if plain == 0 {
            let length = rest.chars().next().map_or(0, char::len_utf8);
            return Err(self.error(self.at..self.at + length, format!("{what} is missing here")));
        }
        let range = self.at..self.at + plain + primes;
        self.at = range.end;
        self.skip_space();
        Ok((&self.text[range.clone()], range))
    }

    /// Reads a quantity of any kind, from its first word on. Returns an error if its form is wrong or a name is
    /// unknown.
    fn quantity(&mut self) -> Result<QuantityKind, QuantityError> {
        let (head, range) = self.parse_word("the name of a quantity")?;
        let model = self.model;
        let coordinate = |name: &str| model.coordinates.iter().position(|c| c.name == name);
        if let Some(at) = head.strip_suffix("''").and_then(coordinate) {
            return Ok(QuantityKind::SecondRate(at));
        }
        if let Some(once) = head.strip_suffix('\'') {
            if let Some(at) = coordinate(once) {
                return Ok(QuantityKind::Rate(at));
            }
            if let Some(at) = model.speeds.iter().position(|s| s.name == once) {
                return Ok(QuantityKind::SpeedRate(at));
            }
        }
        if let Some((energy, _)) = EnergyQuantity::ALL.iter().find(|(_, n)| *n == head) {
            return Ok(QuantityKind::Energy(*energy));
        }
        // Speeds may have names such as `v`, so only `v(` begins a velocity.
        let begins = self.next_is('(') || self.next_is('[') || head == "d" && self.at < self.text.len();
        if !begins && let Some(at) = model.speeds.iter().position(|s| s.name == head) {
            return Ok(QuantityKind::Speed(at));
        }
        if let Some((vector, name)) = VectorName::ALL.iter().find(|(_, n)| *n == head) {
            self.form = format!("{name}({}) @ FRAME [COMPONENT]", vector.owner().placeholder());
            if *vector == VectorName::Velocity && self.names_two() {
                return self.material_velocity();
            }
            let (of, frame, axis) = self.component(*vector)?;
            return Ok(QuantityKind::Component { vector: *vector, of, frame, axis });
        }
        if let Some((row, name)) = RowQuantity::ALL.iter().find(|(_, n)| *n == head) {
            let lagrange = row.is_of_coordinates();
            self.form = format!("{name}[{}]", if lagrange { "COORDINATE" } else { "SPEED" });
            self.parse_mark('[')?;
            let at = if lagrange { self.coordinate()? } else { self.speed()? };
            self.parse_mark(']')?;
            return Ok(QuantityKind::Row(*row, at));
        }
        match head {
            "rotation" => self.rotation(),
            "d" => self.partial(),
            "I" => self.inertia(),
            "M" | "E" | "C" | "Edot" => self.matrix_entry(head),
            _ => Err(self.unknown_quantity_error(head, range)),
        }
    }

    /// Creates the error for an unknown first word. Its advice is the nearest known name.
    fn unknown_quantity_error(&self, head: &str, range: Range<usize>) -> QuantityError {
        let model = self.model;
        let rates = model.coordinates.iter().flat_map(|c| [format!("{}'", c.name), format!("{}''", c.name)]);
        let rates: Vec<String> = rates.chain(model.speeds.iter().map(|s| format!("{}'", s.name))).collect();
        let known = EnergyQuantity::ALL
            .iter()
            .map(|(_, n)| *n)
            .chain(OTHER_NAMES)
            .chain(RowQuantity::ALL.iter().map(|(_, n)| *n));
        let known = known.chain(VectorName::ALL.iter().map(|(_, n)| *n));
        let known = known.chain(model.speeds.iter().map(|s| s.name.as_str())).chain(rates.iter().map(String::as_str));
        let message = format!("unknown quantity `{}`", shortened_for_message(head));
        let is_fixed = |variable: &str| variable == head.trim_end_matches('\'');
        if let Some(constraint) = model.constraints.iter().find(|constraint| is_fixed(&constraint.fixes)) {
            let (name, fixes) = (&constraint.name, &constraint.fixes);
            let help =
                format!("the constraint `{name}` fixes `{fixes}`: judge its rate as a velocity, v(POINT) @ FRAME [1]");
            return QuantityError { message, help, range };
        }
        QuantityError { message, help: nearest_name_advice(head, known), range }
    }

    /// Reads `(OWNER) @ FRAME [COMPONENT]`, and returns the indices of owner, frame and axis. Returns an error if the
    /// form is wrong or a name is unknown.
    fn component(&mut self, vector: VectorName) -> Result<(usize, usize, usize), QuantityError> {
        self.parse_mark('(')?;
        self.component_after(vector)
    }

    /// Reads `OWNER) @ FRAME [COMPONENT]` after the opening parenthesis, and returns the indices of owner, frame and
    /// axis. Returns an error if the form is wrong or a name is unknown.
    fn component_after(&mut self, vector: VectorName) -> Result<(usize, usize, usize), QuantityError> {
        let of = self.owner(vector.owner())?;
        self.parse_mark(')')?;
        self.parse_mark('@')?;
        let frame = self.owner(QuantityOwner::Frame)?;
        self.parse_mark('[')?;
        let axis = self.axis()?;
        self.parse_mark(']')?;
        Ok((of, frame, axis))
    }

    /// True if the text in the next parentheses contains a comma, as in `v(BODY, POINT)`.
    fn names_two(&self) -> bool {
        self.text[self.at..].split(')').next().is_some_and(|inside| inside.contains(','))
    }

    /// Reads `(BODY, POINT) @ FRAME [COMPONENT]` after `v`: the velocity of a body's material at a point. Returns an
    /// error if the form is wrong or a name is unknown.
    fn material_velocity(&mut self) -> Result<QuantityKind, QuantityError> {
        "v(BODY, POINT) @ FRAME [COMPONENT]".clone_into(&mut self.form);
        self.parse_mark('(')?;
        let (body, place) = (self.owner(QuantityOwner::Body)?, self.at);
        self.parse_mark(',')?;
        let (point, frame, axis) = self.component_after(VectorName::Velocity)?;
        let of = &self.model.bodies[body];
        if of.rigid.is_none() && of.centre != point {
            let message = format!("the particle `{}` is not at the point `{}`", of.name, self.model.points[point].name);
            return Err(self.error(place..self.at, message));
        }
        Ok(QuantityKind::MaterialVelocity { body, point, frame, axis })
    }

    /// Reads `(FRAME, FRAME) [ROW,COLUMN]` after `rotation`: an entry of a rotation matrix. Returns an error if the
    /// form is wrong or a name is unknown.
    fn rotation(&mut self) -> Result<QuantityKind, QuantityError> {
        "rotation(FRAME, FRAME) [ROW,COLUMN]".clone_into(&mut self.form);
        self.parse_mark('(')?;
        let from = self.owner(QuantityOwner::Frame)?;
        self.parse_mark(',')?;
        let to = self.owner(QuantityOwner::Frame)?;
        self.parse_mark(')')?;
        Ok(QuantityKind::Rotation { from, to, entry: self.entry()? })
    }

    /// Reads a partial velocity after `d`, such as `v(POINT) @ FRAME [COMPONENT]/d SPEED`. Returns an error if the
    /// form is wrong or a name is unknown.
    fn partial(&mut self) -> Result<QuantityKind, QuantityError> {
        "d v(POINT) @ FRAME [COMPONENT]/d SPEED".clone_into(&mut self.form);
        let (head, range) = self.parse_word("`v` or `omega`")?;
        let vector = match head {
            "v" => VectorName::Velocity,
            "omega" => {
                "d omega(FRAME) @ FRAME [COMPONENT]/d SPEED".clone_into(&mut self.form);
                VectorName::AngularVelocity
            }
            _ => {
                let message =
                    format!("partial velocities are of `v` or `omega`, not of `{}`", shortened_for_message(head));
                return Err(self.error(range, message));
            }
        };
        let (of, frame, axis) = self.component(vector)?;
        self.parse_mark('/')?;
        let (d, range) = self.parse_word("`d`")?;
        if d != "d" {
            return Err(self.error(range, "`d` is missing here"));
        }
        Ok(QuantityKind::Partial { vector, of, frame, axis, speed: self.speed()? })
    }

    /// Reads `(BODY) @ FRAME [ROW,COLUMN]` after `I`: an entry of a body's inertia tensor. Returns an error if the
    /// form is wrong or a name is unknown.
    fn inertia(&mut self) -> Result<QuantityKind, QuantityError> {
        "I(BODY) @ FRAME [ROW,COLUMN]".clone_into(&mut self.form);
        self.parse_mark('(')?;
        let body = self.owner(QuantityOwner::RigidBody)?;
        self.parse_mark(')')?;
        self.parse_mark('@')?;
        let frame = self.owner(QuantityOwner::Frame)?;
        Ok(QuantityKind::Inertia { body, frame, entry: self.entry()? })
    }

    /// Reads `[ROW,COLUMN]` after the name of a matrix. Rows and columns of `M` are speeds; those of `E`, `C` and
    /// `Edot` are coordinates. Returns an error if the form is wrong or a name is unknown.
    fn matrix_entry(&mut self, head: &str) -> Result<QuantityKind, QuantityError> {
        let kane = head == "M";
        let what = if kane { "SPEED" } else { "COORDINATE" };
        self.form = format!("{head}[{what},{what}]");
        self.parse_mark('[')?;
        let row = if kane { self.speed()? } else { self.coordinate()? };
        self.parse_mark(',')?;
        let column = if kane { self.speed()? } else { self.coordinate()? };
        self.parse_mark(']')?;
        Ok(match head {
            "M" => QuantityKind::MassMatrix(row, column),
            "C" => QuantityKind::Christoffel(row, column),
            "Edot" => QuantityKind::MassRate(row, column),
            _ => QuantityKind::LagrangeMatrix(row, column),
        })
    }

    /// Reads `[ROW,COLUMN]` of a 3 × 3 tensor, and returns both indices from 0. Returns an error if the form is
    /// wrong.
    fn entry(&mut self) -> Result<(usize, usize), QuantityError> {
        self.parse_mark('[')?;
        let row = self.axis()?;
        self.parse_mark(',')?;
        let column = self.axis()?;
        self.parse_mark(']')?;
        Ok((row, column))
    }

    /// Reads a component 1, 2 or 3, and returns its index from 0. Returns an error for any other word.
    fn axis(&mut self) -> Result<usize, QuantityError> {
        let (text, range) = self.parse_word("a component")?;
        match text {
            "1" | "2" | "3" => Ok(usize::from(text.as_bytes()[0] - b'1')),
            _ => {
                let message = format!("there is no component `{}`", shortened_for_message(text));
                Err(QuantityError { message, help: "components are 1, 2 and 3".to_owned(), range })
            }
        }
    }

    /// Reads a generalized speed by its name or number, and returns its index. Returns an error if there is no such
    /// speed.
    fn speed(&mut self) -> Result<usize, QuantityError> {
        let names: Vec<&str> = self.model.speeds.iter().map(|s| s.name.as_str()).collect();
        self.parse_named_or_numbered("speed", &names)
    }

    /// Reads a coordinate by its name or number, and returns its index. Returns an error if there is no such
    /// coordinate.
    fn coordinate(&mut self) -> Result<usize, QuantityError> {
        let names: Vec<&str> = self.model.coordinates.iter().map(|c| c.name.as_str()).collect();
        self.parse_named_or_numbered("coordinate", &names)
    }

    /// Reads an item of a list by its name or its number from 1, and returns its index from 0. `noun` names the kind
    /// of item in an error.
    fn parse_named_or_numbered(&mut self, noun: &str, names: &[&str]) -> Result<usize, QuantityError> {
        let (text, range) = self.parse_word(&format!("a {noun}"))?;
        if let Some(at) = names.iter().position(|n| *n == text) {
            return Ok(at);
        }
        let number = text.parse::<usize>().ok().filter(|n| (1..=names.len()).contains(n));
        let is_number = text.bytes().all(|b| b.is_ascii_digit());
        number.map(|n| n - 1).ok_or_else(|| {
            let message = format!("the model has no {noun} `{}`", shortened_for_message(text));
            let help = if is_number {
                format!("it has {}", count_with_noun(names.len(), noun))
            } else {
                nearest_name_advice(text, names.iter().copied())
            };
            QuantityError { message, help, range }
        })
    }

    /// Reads the name of a point, frame or body, and returns its index in the model. Returns an error if the model
    /// has no object of this name.
    fn owner(&mut self, owner: QuantityOwner) -> Result<usize, QuantityError> {
        let model = self.model;
        let (noun, names): (&str, Vec<&str>) = match owner {
            QuantityOwner::Point => ("point", model.points.iter().map(|p| p.name.as_str()).collect()),
            QuantityOwner::Frame => ("frame", model.frames.iter().map(|f| f.name.as_str()).collect()),
            QuantityOwner::Body | QuantityOwner::RigidBody => {
                ("body", model.bodies.iter().map(|b| b.name.as_str()).collect())
            }
        };
        let (text, range) = self.parse_word(&format!("a {noun}"))?;
        let Some(at) = names.iter().position(|n| *n == text) else {
            let message = format!("the model has no {noun} `{}`", shortened_for_message(text));
            return Err(QuantityError { message, help: nearest_name_advice(text, names), range });
        };
        if owner == QuantityOwner::RigidBody && model.bodies[at].rigid.is_none() {
            let message = format!("the body `{text}` is a particle, which has no rotation");
            let help = "inertia, angular momentum and moments belong to rigid bodies".to_owned();
            return Err(QuantityError { message, help, range });
        }
        Ok(at)
    }
}

/// Text of a number with its noun, such as `1 speed` or `2 speeds`.
fn count_with_noun(n: usize, noun: &str) -> String {
    if n == 1 { format!("1 {noun}") } else { format!("{n} {noun}s") }
}
