//! Relations that give unknowns, their conditions, and the branches of solutions that they make up.

use crate::algebra::Expr;

/// Function of an unknown that a relation gives: the unknown itself, its square, or a sine, cosine or tangent.
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

/// A relation for one unknown: its value, its square, or a sine, cosine or tangent of an angle proportional to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Relation {
    /// The unknown.
    pub unknown: Expr,
    /// Function of the unknown that the relation gives.
    pub kind: Kind,
    /// The angle whose sine, cosine or tangent is given; else the unknown.
    pub angle: Expr,
    /// Value of that function.
    pub value: Expr,
}

impl Relation {
    /// An unknown with its value.
    pub(super) const fn value(unknown: Expr, value: Expr) -> Self {
        Self { unknown, kind: Kind::Value, angle: unknown, value }
    }
}

/// Condition, beside the equations, under which a branch has real solutions.
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
    /// Relations for the unknowns that were solved for, each in terms of the free ones.
    pub solved: Vec<Relation>,
    /// Conditions for the solution to be real.
    pub needs: Vec<Need>,
    /// Divisors of the solution, which are not 0.
    pub divided_by: Vec<Expr>,
    /// Further terms that must vanish, which were not solved.
    pub left: Vec<Expr>,
}

/// An unknown, with what that needs.
#[derive(Clone, Debug, Default)]
pub struct Solution {
    /// One relation, or two where both sine and cosine are given.
    pub relations: Vec<Relation>,
    /// Conditions for the solution to be real.
    pub needs: Vec<Need>,
}

/// Solutions of a factor of an equation for one unknown.
#[derive(Clone, Debug, Default)]
pub struct Isolated {
    /// The solutions; none if no real number solves it.
    pub solutions: Vec<Solution>,
    /// Divisor of the solutions, if they divide by a term.
    pub divisor: Option<Expr>,
    /// 0 if it is linear, 1 if it has a square root, 2 if both sine and cosine have one.
    pub degree: u8,
}
