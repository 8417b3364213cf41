//! Words in which formulas stand, as data: plain text prints what a page typesets.

use crate::algebra::print::text;
use crate::algebra::{Arena, Expr};

/// A part of what is said.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece {
    /// Words.
    Words(String),
    /// A term.
    Term(Expr),
    /// Two terms that are equal.
    Equation(Expr, Expr),
}

/// What is said of something: words and terms of a reduction's store.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Prose(pub Vec<Piece>);

impl Prose {
    /// Nothing but a term.
    #[must_use]
    pub fn term(e: Expr) -> Self {
        Self(vec![Piece::Term(e)])
    }

    /// This, then that.
    #[must_use]
    pub fn then(mut self, more: impl Into<Self>) -> Self {
        self.0.extend(more.into().0);
        self
    }

    /// In plain text.
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
