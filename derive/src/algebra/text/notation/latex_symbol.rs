//! LaTeX symbols in a normal form: different ways to write a symbol give the same value.

/// Symbol of LaTeX in a normal form: `\dot{q}_1`, `\dot q_{1}` and `\dot{q_1}` are equal.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct LatexSymbol {
    /// Letter or word of the symbol, with its accents except dots.
    pub base: String,
    /// Subscript of the symbol, without braces and type faces; empty if there is none.
    pub subscript: String,
    /// Superscript that is not a power, such as the `B` of `I^B`; empty if there is none.
    pub mark: String,
    /// Number of dots and primes: the order of the time derivative.
    pub dots: usize,
}

impl LatexSymbol {
    /// Creates a symbol without subscript, superscript and dots.
    pub(super) fn plain(base: impl Into<String>) -> Self {
        Self { base: base.into(), subscript: String::new(), mark: String::new(), dots: 0 }
    }

    /// LaTeX text of the symbol without its dots.
    #[must_use]
    pub fn without_dots(&self) -> String {
        let part = |sign: char, text: &str| if text.is_empty() { String::new() } else { format!("{sign}{{{text}}}") };
        format!("{}{}{}", self.base, part('_', &self.subscript), part('^', &self.mark))
    }
}

impl std::fmt::Display for LatexSymbol {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}{}", self.without_dots(), "'".repeat(self.dots))
    }
}
