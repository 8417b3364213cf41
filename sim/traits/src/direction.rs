//! Direction in which a function goes through zero.

/// Direction of the crossings that an event counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// From negative to positive.
    Rising,
    /// From positive to negative.
    Falling,
    /// In both directions.
    Either,
}
