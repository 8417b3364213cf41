//! Relations that give unknowns, their conditions, and the branches of solutions that they make up.

use crate::algebra::Expr;

/// Function of an unknown that a relation gives: the unknown itself, its square, or a sine, cosine or tangent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// The unknown itself.
    Value,
    /// Square of the unknown.
    Square,
    /// Sine of an angle that is proportional to the unknown.
    Sine,
    /// Cosine of an angle that is proportional to the unknown.
    Cosine,
    /// Tangent of an angle that is proportional to the unknown.
    Tangent,
}

/// A relation for one unknown: its value, its square, or a sine, cosine or tangent of an angle proportional to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Relation {
    /// Unknown that the relation gives.
    pub unknown: Expr,
    /// Function of the unknown that the relation gives.
    pub kind: Kind,
    /// Angle whose sine, cosine or tangent is given; the unknown itself for other kinds.
    pub angle: Expr,
    /// Value of the function of the unknown.
    pub value: Expr,
}

impl Relation {
    /// Creates the relation unknown = value.
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
    /// Term on which the condition is.
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

/// Branch of solutions of a system: formulas for the unknowns, and their conditions.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Branch {
    /// Relations for the unknowns that were solved for, each in terms of the free unknowns.
    pub solved: Vec<Relation>,
    /// Conditions for the solution to be real.
    pub needs: Vec<Need>,
    /// Divisors of the solution, which are not 0.
    pub divided_by: Vec<Expr>,
    /// Further terms that must vanish, which were not solved.
    pub left: Vec<Expr>,
}

/// Solution for one unknown, with its conditions.
#[derive(Clone, Debug, Default)]
pub struct Solution {
    /// Relations for the unknown: one, or two if both sine and cosine are given.
    pub relations: Vec<Relation>,
    /// Conditions for the solution to be real.
    pub needs: Vec<Need>,
}

/// Solutions of a factor of an equation for one unknown.
#[derive(Clone, Debug, Default)]
pub struct Isolated {
    /// Solutions for the unknown; empty if no real number solves the factor.
    pub solutions: Vec<Solution>,
    /// Divisor of the solutions, if they divide by a term.
    pub divisor: Option<Expr>,
    /// Complexity of the solutions: 0 if the factor is linear, 1 with one square root, 2 with roots in both sine and
    /// cosine.
    pub degree: u8,
}
