//! Direction in which the function of an event crosses zero.

/// Direction of the zero crossings that an event counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Crossings of zero from negative to positive only.
    Rising,
    /// Crossings of zero from positive to negative only.
    Falling,
    /// Crossings of zero in both directions.
    Either,
}
