//! The names of a derivation's lines, read once for whoever typesets them.

/// The name of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepName<'a> {
    /// `omega(C) @ B [1]`: a component of a vector along an axis of a frame.
    Component(VectorName<'a>, Axis<'a>),
    /// `d v(P) @ B [3]/d u2`: a component of a partial velocity.
    Partial(VectorName<'a>, Axis<'a>, &'a str),
    /// `F[u1]`: what belongs to a speed or coordinate.
    Of(&'a str, &'a str),
    /// `q1'`, `T`: a symbol.
    Symbol(&'a str),
}

/// `omega(C)`: an angular velocity or acceleration, a velocity or acceleration in the inertial frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VectorName<'a> {
    /// `omega`, `alpha`, `v` or `a`.
    pub kind: &'a str,
    /// The frame or point that moves.
    pub of: &'a str,
}

/// `B [1]`: the first axis of frame B.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axis<'a> {
    /// The frame.
    pub frame: &'a str,
    /// 1, 2 or 3.
    pub index: &'a str,
}

impl<'a> VectorName<'a> {
    /// Reads `omega(C)`.
    pub fn read(text: &'a str) -> Option<Self> {
        let (kind, of) = text.strip_suffix(')')?.split_once('(')?;
        ["omega", "alpha", "v", "a"].contains(&kind).then_some(Self { kind, of })
    }
}

impl<'a> StepName<'a> {
    /// Reads the name of a line; what is nothing else is a symbol.
    pub fn read(text: &'a str) -> Self {
        let partial = || {
            let (above, speed) = text.strip_prefix("d ")?.rsplit_once("/d ")?;
            let (vector, axis) = component(above)?;
            Some(Self::Partial(vector, axis, speed))
        };
        let of = || {
            let (letter, of) = text.strip_suffix(']')?.split_once('[')?;
            Some(Self::Of(letter, of))
        };
        let whole = component(text).map(|(vector, axis)| Self::Component(vector, axis));
        whole.or_else(partial).or_else(of).unwrap_or(Self::Symbol(text))
    }
}

/// `omega(C) @ B [1]`.
fn component(text: &str) -> Option<(VectorName<'_>, Axis<'_>)> {
    let (of, place) = text.split_once(" @ ")?;
    let (frame, index) = place.strip_suffix(']')?.split_once(" [")?;
    Some((VectorName::read(of)?, Axis { frame, index }))
}
