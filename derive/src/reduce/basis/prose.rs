//! Text with formulas, as data. Plain output prints the formulas in plain characters; a web page
//! typesets them.

use crate::algebra::text::print::print_text;
use crate::algebra::{Arena, Expr};

/// Part of a text with formulas: words, a term or an equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece {
    /// Plain words without formulas.
    Words(String),
    /// Term in the reduction's arena, to be shown as a formula.
    Term(Expr),
    /// Equation left = right between two terms in the reduction's arena.
    Equation(Expr, Expr),
}

/// Text about a reduction, as a sequence of words, terms and equations.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Prose(pub Vec<Piece>);

impl Prose {
    /// Creates a text that consists of a single formula.
    #[must_use]
    pub fn term(e: Expr) -> Self {
        Self(vec![Piece::Term(e)])
    }

    /// Appends words, a term, an equation or another text to the text. Returns the longer text.
    #[must_use]
    pub fn append_prose(mut self, more: impl Into<Self>) -> Self {
        self.0.extend(more.into().0);
        self
    }

    /// Text in plain characters, with its formulas printed. `arena` must contain the terms of the
    /// text.
    #[must_use]
    pub fn text(&self, arena: &Arena) -> String {
        let piece = |piece: &Piece| match piece {
            Piece::Words(words) => words.clone(),
            Piece::Term(e) => print_text(arena, *e),
            Piece::Equation(left, right) => format!("{} = {}", print_text(arena, *left), print_text(arena, *right)),
        };
        self.0.iter().map(piece).collect()
    }
}

impl From<&str> for Prose {
    fn from(words: &str) -> Self {
        words.to_owned().into()
    }
}

impl From<String> for Prose {
    fn from(words: String) -> Self {
        Self(vec![Piece::Words(words)])
    }
}

impl From<Piece> for Prose {
    fn from(piece: Piece) -> Self {
        Self(vec![piece])
    }
}
