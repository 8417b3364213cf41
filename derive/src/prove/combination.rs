//! Linear combinations that turn the rows of one formulation into those of another, with the
//! identities that prove them.

use crate::algebra::Expr;
use crate::algebra::meaning::identity::Identity;
use crate::mechanics::Formulation;

/// Linear combination of the rows of one formulation that gives the rows of another formulation,
/// with the identities that prove it.
#[derive(Clone, Debug)]
pub struct Combination {
    /// Formulation whose rows are multiplied and added.
    pub of: Formulation,
    /// Formulation whose rows are the result of the linear combination.
    pub gives: Formulation,
    /// Substitutions in the rows before they are combined, as pairs (symbol, value). For speeds
    /// they are q̇ = W u + w and q̈ = W u̇ + x. For rates they are u = J q̇ + d and u̇ = J q̈ + y.
    /// Empty if both formulations have the same motion variables.
    pub relations: Vec<(Expr, Expr)>,
    /// Multipliers of the rows of `of`, with one list for each row of the result. Empty if both
    /// formulations have equal rows.
    pub multipliers: Vec<Vec<Expr>>,
    /// Identities that were proved for the combined rows, as pairs of the part of the linear system
    /// and the identity.
    pub identities: Vec<(CombinationPart, Identity)>,
}

/// Part of a linear system to which an identity belongs. All indices count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CombinationPart {
    /// Coefficient of an unknown in a combined row. It equals the coefficient in the expected row,
    /// or 0 if the expected row does not contain the unknown.
    Coefficient {
        /// Index of the combined row.
        row: usize,
        /// Index of the unknown in the system.
        unknown: usize,
    },
    /// Right-hand side of a combined row. It equals the right-hand side of the expected row.
    Right {
        /// Index of the combined row.
        row: usize,
    },
    /// Entry of a constraint's row after the substitution of speeds for rates; it is identically
    /// zero.
    Constraint,
    /// Sum of the powers of a reaction along a generalized speed; it is identically zero.
    Power {
        /// Index of the generalized speed.
        speed: usize,
        /// Index of the reaction in the model.
        reaction: usize,
    },
}

/// Description, as data, of the way in which the rows of one formulation follow from those of
/// another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CombinationDescription {
    /// Formulation on the left of the text, such as Kane's in `Kane = Wᵀ · Lagrange`.
    pub left: Formulation,
    /// Formulation on the right of the text, whose rows are multiplied.
    pub right: Formulation,
    /// Kind of the linear combination, such as Wᵀ times rows.
    pub kind: CombinationKind,
}

/// Kind of a linear combination of rows. W, w, J and d are those of the equations q' = W u + w and
/// u = J q' + d.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CombinationKind {
    /// Rows of both formulations are equal one by one, without any multipliers.
    RowByRow,
    /// Rows along speeds are Wᵀ times those along rates, and rows along rates are Jᵀ times those
    /// along speeds. Here q' = W u and u = J q'.
    LinearSpeeds,
    /// Rows along speeds are Wᵀ times those along rates, and rows along rates are Jᵀ times those
    /// along speeds. Here q' = W u + w and u = J q' + d.
    AffineSpeeds,
    /// Rows along speeds are Wᵀ times those along rates; the multipliers of the constraints cancel.
    Multipliers,
    /// Rows along speeds are the partial velocities times the Newton–Euler balances. The list has
    /// the names of the reactions; the balances that are not used give their values.
    PartialVelocities(Vec<String>),
    /// Rows along rates are the partial velocities with respect to q' times the Newton–Euler balances.
    PartialVelocitiesOfRates,
    /// Rows along rates are the partial velocities with respect to q' times the Newton–Euler
    /// balances, except for constraint forces. Wᵀ cancels these forces.
    ConstraintForces,
    /// Both formulations are proved equivalent to a third one, without a direct combination of their rows.
    Through(Formulation),
}

impl CombinationDescription {
    /// Text of the combination in words and symbols, such as `Kane = Wᵀ · Lagrange`.
    #[must_use]
    pub fn text(&self) -> String {
        let [left, right] = [self.left, self.right].map(|formulation| formulation.method().label);
        let both_ways = |with: &str| format!("{left} = Wᵀ · {right} and {right} = Jᵀ · {left}, with {with}");
        match &self.kind {
            CombinationKind::RowByRow => format!("{left} = {right}, row by row"),
            CombinationKind::LinearSpeeds => both_ways("q' = W u and u = J q'"),
            CombinationKind::AffineSpeeds => both_ways("q' = W u + w and u = J q' + d"),
            CombinationKind::Multipliers => format!(
                "{left} = Wᵀ · {right}, the multipliers cancel, and the rows of the constraints vanish, with q' = W u + w; \
                 what {right} has beside {left} gives the multipliers"
            ),
            CombinationKind::PartialVelocities(reactions) => {
                let given = match reactions.as_slice() {
                    [] => "both have the same number of rows".to_owned(),
                    [one] => format!("the remaining equation gives {one}"),
                    several => format!("the remaining equations give {}", several.join(", ")),
                };
                format!("{left} = (partial velocities) · {right}, the reactions cancel; {given}")
            }
            CombinationKind::PartialVelocitiesOfRates => {
                format!("{left} = (partial velocities with respect to q') · {right}, the reactions cancel")
            }
            CombinationKind::Through(middle) => {
                format!("{left} and {right} have the same motions, since both have those of {}", middle.method().label)
            }
            CombinationKind::ConstraintForces => format!(
                "{left} = (partial velocities with respect to q') · {right}, the reactions being Aᵀλ along q', which W \
                 cancels on both sides"
            ),
        }
    }
}
