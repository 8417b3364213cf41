//! Direction in which a function goes through zero.

/// Direction of the crossings that an event counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Crossings from negative to positive.
    Rising,
    /// Crossings from positive to negative.
    Falling,
    /// Crossings in both directions.
    Either,
}
