//! What is told of unknowns: relations, what they need, and branches of solutions.

use super::super::Expr;

/// What of an unknown is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// The unknown.
    Value,
    /// Its square.
    Square,
    /// The sine of an angle that is proportional to it.
    Sine,
    /// The cosine of such an angle.
    Cosine,
    /// The tangent of such an angle.
    Tangent,
}

/// What an unknown was found to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Relation {
    /// The unknown.
    pub unknown: Expr,
    /// What of it is told.
    pub kind: Kind,
    /// The angle, of which a sine, cosine or tangent is told; else the unknown.
    pub angle: Expr,
    /// What that is.
    pub value: Expr,
}

impl Relation {
    /// An unknown with its value.
    pub(super) const fn value(unknown: Expr, value: Expr) -> Self {
        Self { unknown, kind: Kind::Value, angle: unknown, value }
    }
}

/// What must be so where a branch holds, beside its equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Need {
    /// The term is not negative: it stands under a square root.
    NotNegative(Expr),
    /// The term lies from −1 to 1: it is a sine or a cosine.
    Unit(Expr),
}

impl Need {
    /// The term.
    #[must_use]
    pub const fn term(self) -> Expr {
        match self {
            Self::NotNegative(e) | Self::Unit(e) => e,
        }
    }

    pub(super) const fn of(self, e: Expr) -> Self {
        match self {
            Self::NotNegative(_) => Self::NotNegative(e),
            Self::Unit(_) => Self::Unit(e),
        }
    }
}

/// Solutions of a system that are told by formulas.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Branch {
    /// What the unknowns are that were solved for, each in those that are left free.
    pub solved: Vec<Relation>,
    /// What must be so for real numbers to be found.
    pub needs: Vec<Need>,
    /// What is divided by, and is not 0.
    pub divided_by: Vec<Expr>,
    /// What must vanish beside, and was not solved for.
    pub left: Vec<Expr>,
}

/// An unknown, with what that needs.
#[derive(Clone, Debug, Default)]
pub struct Solution {
    /// One relation; sine and cosine where both are told.
    pub relations: Vec<Relation>,
    /// What must be so.
    pub needs: Vec<Need>,
}

/// How a factor gives an unknown.
#[derive(Clone, Debug, Default)]
pub struct Isolated {
    /// The solutions; none if no real number solves it.
    pub solutions: Vec<Solution>,
    /// What is divided by.
    pub divisor: Option<Expr>,
    /// 0 if it is linear, 1 if it has a square root, 2 if both sine and cosine have one.
    pub degree: u8,
}
