//! Kinds of mistakes in printed formulas, from the likeliest to the least likely.

use crate::algebra::{Arena, Expr, Node};

/// Kind of a mistake in a printed formula, the likeliest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum MistakeKind {
    /// A sign is lost or gained.
    Sign,
    /// A number is wrong.
    Number,
    /// A symbol is wrong, or a dot of a time derivative is lost or gained.
    Symbol,
    /// A sine is printed for a cosine, a cosine for a sine, or the argument is wrong.
    Function,
    /// An exponent is wrong.
    Power,
    /// A factor is printed that should not be there.
    ExtraFactor,
    /// A factor is missing in print.
    LostFactor,
    /// A term is printed that should not be there.
    ExtraTerm,
    /// A term is missing in print.
    LostTerm,
}

impl MistakeKind {
    /// Kind of the mistake in a value that is wrong by the factor `factor`, which is the printed value divided by the
    /// right value. Returns `None` for a factor with both extra and lost symbols, and for sums.
    #[must_use]
    pub fn of_factor(arena: &Arena, factor: Expr) -> Option<Self> {
        if factor == Expr::MINUS_ONE {
            return Some(Self::Sign);
        }
        if arena.as_number(factor).is_some() {
            return Some(Self::Number);
        }
        match arena.node(factor) {
            Node::Symbol(_) => Some(Self::ExtraFactor),
            Node::Product(factors) if factors.iter().all(|(_, n)| *n > 0) => Some(Self::ExtraFactor),
            Node::Product(factors) if factors.iter().all(|(_, n)| *n < 0) => Some(Self::LostFactor),
            _ => None,
        }
    }

    /// Name of the kind of mistake, such as "a sign".
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Sign => "a sign",
            Self::Number => "a number",
            Self::Symbol => "a symbol or a dot",
            Self::Function => "a sine, cosine or argument",
            Self::Power => "a power",
            Self::ExtraFactor => "a factor too many",
            Self::LostFactor => "a factor too few",
            Self::ExtraTerm => "a term too many",
            Self::LostTerm => "a term too few",
        }
    }
}
