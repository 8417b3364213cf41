//! Symbols of LaTeX in one form, however they are written.

/// A symbol of LaTeX in one form, however it is written: `\dot{q}_1`, `\dot q_{1}` and `\dot{q_1}` are equal.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Symbol {
    /// Letter or word of the symbol, with accents other than dots.
    pub base: String,
    /// Subscript of the symbol, without braces and type faces; may be empty.
    pub subscript: String,
    /// Superscript that is not a power, such as the `B` of `I^B`; may be empty.
    pub mark: String,
    /// Number of dots and primes: the order of the derivative with respect to time.
    pub dots: usize,
}

impl Symbol {
    pub(super) fn plain(base: impl Into<String>) -> Self {
        Self { base: base.into(), subscript: String::new(), mark: String::new(), dots: 0 }
    }

    /// The symbol without its dots, as LaTeX.
    #[must_use]
    pub fn still(&self) -> String {
        let part = |sign: char, text: &str| if text.is_empty() { String::new() } else { format!("{sign}{{{text}}}") };
        format!("{}{}{}", self.base, part('_', &self.subscript), part('^', &self.mark))
    }
}

impl std::fmt::Display for Symbol {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}{}", self.still(), "'".repeat(self.dots))
    }
}
