//! Start of an integration: its state and its span of time.

/// State at the start of an integration, and the span of time to integrate over.
#[derive(Clone, Copy)]
pub struct InitialState<'a, S = f64> {
    /// First and last instant of the integration, s.
    pub span: (f64, f64),
    /// Integrated state at the first instant.
    pub y: &'a [S],
}
