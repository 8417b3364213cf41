//! Names of components of velocities and positions in expressions. The velocity of a point is
//! written `v(P) @ A [1]`, that of the material of a body at a point `v(disk, P) @ A [1]`. An
//! angular velocity is `omega(B) @ A [3]`, a position `p(P) @ A [1]`.

use super::error::ParseError;
use super::quantity_cursor::{QuantityCursor, Word};

/// Object of which a velocity or position is taken. `N` is the type of names, such as `&str`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum VelocityOf<N> {
    /// Velocity of a point, by the point's name.
    Point(N),
    /// Velocity of the material point of a body that is at a given point: names of the body and of
    /// the point.
    Material(N, N),
    /// Angular velocity of a body or a frame, by its name.
    Turning(N),
    /// Position of a point relative to the origin, by the point's name.
    Place(N),
}

/// Name of a component of a velocity or position. The parser does not check that its points, bodies
/// and frame exist.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VelocityName<'a> {
    /// Object of which the velocity or position is taken.
    pub of: VelocityOf<Word<'a>>,
    /// Frame along whose axis the component is taken.
    pub frame: Word<'a>,
    /// Axis of the frame along which the component is taken: 0, 1 or 2.
    pub axis: usize,
}

/// Help text for errors: the syntax of a velocity and a position.
const FORM: &str = "write v(POINT) @ FRAME [1], v(BODY, POINT) @ FRAME [1] for the material of a body, omega(BODY) @ FRAME [1], or \
                    p(POINT) @ FRAME [1] for a position";

/// True if a word before a parenthesis begins a velocity or position: `v`, `omega` or `p`.
pub(super) fn is_velocity(word: &str) -> bool {
    ["v", "omega", "p"].contains(&word)
}

impl<'a> VelocityName<'a> {
    /// Reads the name of a velocity or position, beginning with its opening parenthesis at byte
    /// `at`. `word` is its keyword. Returns the name and the byte where it ends. Error if the
    /// syntax is wrong.
    pub(super) fn read(word: &str, text: &'a str, at: usize) -> Result<(Self, usize), ParseError> {
        let mut cursor = QuantityCursor { text, at, form: FORM };
        cursor.mark('(')?;
        let of = if word == "omega" {
            VelocityOf::Turning(cursor.word("a body or a frame")?)
        } else if word == "p" {
            VelocityOf::Place(cursor.word("a point")?)
        } else {
            let first = cursor.word("a point")?;
            if cursor.next_is(',') {
                VelocityOf::Material(first, cursor.after(',', "a point")?)
            } else if cursor.takes("of") {
                VelocityOf::Material(cursor.word("a body")?, first)
            } else {
                VelocityOf::Point(first)
            }
        };
        cursor.mark(')')?;
        let (frame, axis) = cursor.component()?;
        Ok((Self { of, frame, axis }, cursor.at))
    }

    /// Reads the two points of `distance(P, Q)`, beginning with the opening parenthesis. Returns
    /// the names of their position components, for each of the three axes of the inertial frame,
    /// and the byte where the call ends. The inertial frame has an empty name here. Error if the
    /// syntax is wrong.
    pub(super) fn distance_ends(text: &'a str, at: usize) -> Result<([[Self; 2]; 3], usize), ParseError> {
        let mut cursor = QuantityCursor { text, at, form: FORM };
        cursor.mark('(')?;
        let first = cursor.word("a point")?;
        let second = cursor.after(',', "a point")?;
        cursor.mark(')')?;
        let place =
            |word: &Word<'a>, axis| Self { of: VelocityOf::Place(word.clone()), frame: ("", word.1.clone()), axis };
        Ok(([0, 1, 2].map(|axis| [place(&first, axis), place(&second, axis)]), cursor.at))
    }

    /// Canonical text of the name, independent of spaces: `v(disk, P) @ A [1]`.
    #[must_use]
    pub fn text(&self) -> String {
        let of = match &self.of {
            VelocityOf::Point(point) => VelocityOf::Point(point.0),
            VelocityOf::Material(body, point) => VelocityOf::Material(body.0, point.0),
            VelocityOf::Turning(body) => VelocityOf::Turning(body.0),
            VelocityOf::Place(point) => VelocityOf::Place(point.0),
        };
        canonical_velocity_name(&of, self.frame.0, self.axis)
    }
}

/// Canonical name of a component of a velocity or position, such as `v(disk, P) @ A [1]`.
#[must_use]
pub fn canonical_velocity_name(of: &VelocityOf<&str>, frame: &str, axis: usize) -> String {
    let of = match of {
        VelocityOf::Point(point) => format!("v({point})"),
        VelocityOf::Material(body, point) => format!("v({body}, {point})"),
        VelocityOf::Turning(body) => format!("omega({body})"),
        VelocityOf::Place(point) => format!("p({point})"),
    };
    format!("{of} @ {frame} [{}]", axis + 1)
}
