//! Relations that give unknowns in closed form, their conditions, and the branches of solutions
//! that they form.

use crate::algebra::Expr;

/// Kind of relation: it gives the unknown itself, its square, or the sine, cosine or tangent of an
/// angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RelationKind {
    /// The relation gives the unknown itself.
    Value,
    /// The relation gives the square of the unknown.
    Square,
    /// The relation gives the sine of an angle that is proportional to the unknown.
    Sine,
    /// The relation gives the cosine of an angle that is proportional to the unknown.
    Cosine,
    /// The relation gives the tangent of an angle that is proportional to the unknown.
    Tangent,
}

/// Relation function(unknown) = value. The function is the identity, the square, or the sine,
/// cosine or tangent of an angle proportional to the unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Relation {
    /// Unknown of the equations that the relation gives.
    pub unknown: Expr,
    /// Kind of function that the relation gives: the unknown itself, its square, or a sine, cosine
    /// or tangent.
    pub kind: RelationKind,
    /// Angle whose sine, cosine or tangent the relation gives, rad. For other kinds it is the
    /// unknown.
    pub angle: Expr,
    /// Value of the function of the unknown; the value does not contain the unknown.
    pub value: Expr,
}

impl Relation {
    /// Creates the relation unknown = value.
    pub(super) const fn value(unknown: Expr, value: Expr) -> Self {
        Self { unknown, kind: RelationKind::Value, angle: unknown, value }
    }
}

/// Condition under which a branch of solutions is real, in addition to the equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RelationCondition {
    /// The term is not negative: it is under a square root, or it is a square.
    NotNegative(Expr),
    /// The term lies from −1 to 1: it is the value of a sine or a cosine.
    Unit(Expr),
}

impl RelationCondition {
    /// Term that the condition restricts: it is not negative, or lies from −1 to 1.
    #[must_use]
    pub const fn term(self) -> Expr {
        match self {
            Self::NotNegative(e) | Self::Unit(e) => e,
        }
    }

    /// Returns the same kind of condition for the term `e`.
    pub(super) const fn of(self, e: Expr) -> Self {
        match self {
            Self::NotNegative(_) => Self::NotNegative(e),
            Self::Unit(_) => Self::Unit(e),
        }
    }
}

/// Branch of solutions of a system: relations that give the unknowns, and their conditions.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Branch {
    /// Relations for the unknowns that were solved for, each in terms of the free unknowns.
    pub solved: Vec<Relation>,
    /// Conditions under which the solutions are real.
    pub needs: Vec<RelationCondition>,
    /// Divisors of the solutions; the branch holds where they are not 0.
    pub divided_by: Vec<Expr>,
    /// Further terms that must be 0; these equations could not be solved.
    pub left: Vec<Expr>,
}

/// Solution of an equation for one unknown, with its conditions.
#[derive(Clone, Debug, Default)]
pub struct Solution {
    /// Relations that give the unknown: one, or two if both its sine and cosine are given.
    pub relations: Vec<Relation>,
    /// Conditions under which the solution is real.
    pub needs: Vec<RelationCondition>,
}

/// All solutions of one factor of an equation for one unknown, with their divisor.
#[derive(Clone, Debug, Default)]
pub struct FactorSolutions {
    /// Solutions for the unknown; empty if no real number solves the factor.
    pub solutions: Vec<Solution>,
    /// Common divisor of the solutions; `None` if they divide by no term.
    pub divisor: Option<Expr>,
    /// Complexity of the solutions: 0 if the factor is linear, 1 with one square root, 2 with roots in both sine and
    /// cosine.
    pub degree: u8,
}
