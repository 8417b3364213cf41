//! Text with formulas, as data: plain text prints the formulas, and a page typesets them.

use crate::algebra::text::print::text;
use crate::algebra::{Arena, Expr};

/// Part of a text: words, a term or an equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece {
    /// Plain words.
    Words(String),
    /// Term of the reduction's store.
    Term(Expr),
    /// Equation between two terms.
    Equation(Expr, Expr),
}

/// Text about a reduction, from words and terms of its store.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Prose(pub Vec<Piece>);

impl Prose {
    /// Text that consists of one term.
    #[must_use]
    pub fn term(e: Expr) -> Self {
        Self(vec![Piece::Term(e)])
    }

    /// Appends more text.
    #[must_use]
    pub fn then(mut self, more: impl Into<Self>) -> Self {
        self.0.extend(more.into().0);
        self
    }

    /// Whole text in plain characters. `arena` contains its terms.
    #[must_use]
    pub fn text(&self, arena: &Arena) -> String {
        let piece = |piece: &Piece| match piece {
            Piece::Words(words) => words.clone(),
            Piece::Term(e) => text(arena, *e),
            Piece::Equation(left, right) => format!("{} = {}", text(arena, *left), text(arena, *right)),
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
