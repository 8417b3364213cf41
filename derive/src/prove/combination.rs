//! Linear combinations of rows that lead from the equations of one formulation to those of another,
//! with the identities that prove them.

use crate::algebra::Expr;
use crate::algebra::meaning::identity::Identity;
use crate::mechanics::Formulation;

/// Linear combination of the rows of one formulation that gives the rows of another, with the
/// proved identities.
#[derive(Clone, Debug)]
pub struct Combination {
    /// Formulation whose rows are combined.
    pub of: Formulation,
    /// Formulation whose rows the linear combination gives.
    pub gives: Formulation,
    /// Substitutions in the rows before they are combined, as pairs of symbol and value: q̇ = W u + w
    /// and q̈ = W u̇ + x, or u = J q̇ + d and u̇ = J q̈ + y. Empty if both formulations have the same
    /// motion variables.
    pub relations: Vec<(Expr, Expr)>,
    /// Multipliers of the rows of `of`, one list for each row of the result. Empty if the rows are
    /// equal one by one.
    pub multipliers: Vec<Vec<Expr>>,
    /// Identities that were proved for the combined rows, each with the part of the system to which it
    /// belongs.
    pub identities: Vec<(CombinationPart, Identity)>,
}

/// Part of a linear system to which an identity belongs. All indices count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CombinationPart {
    /// Coefficient of an unknown in a combined row. It equals that of the expected row, or 0 if the
    /// expected row lacks the unknown.
    Coefficient {
        /// Index of the combined row.
        row: usize,
        /// Index of the unknown in the system.
        unknown: usize,
    },
    /// Right-hand side of a combined row, which equals that of the expected row.
    Right {
        /// Index of the combined row.
        row: usize,
    },
    /// Entry of a constraint's row after the substitution; it vanishes.
    Constraint,
    /// Sum of the powers of a reaction along a generalized speed; it vanishes.
    Power {
        /// Index of the generalized speed.
        speed: usize,
        /// Index of the reaction in the model.
        reaction: usize,
    },
}

/// Description of how the rows of one formulation follow from those of another, as data.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CombinationDescription {
    /// Formulation on the left of the text: that in speeds, if the second is in rates or has
    /// reactions.
    pub left: Formulation,
    /// Second formulation, whose rows are combined in the text.
    pub right: Formulation,
    /// Kind of the linear combination, such as Wᵀ times rows.
    pub kind: CombinationKind,
}

/// Kind of a linear combination of rows. W, w, J, d are those of q' = W u + w and u = J q' + d.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CombinationKind {
    /// Rows of both formulations are equal one by one, without any multipliers.
    RowByRow,
    /// Rows along speeds are Wᵀ times those along rates, and back by Jᵀ, with q' = W u and u = J q'.
    LinearSpeeds,
    /// Rows along speeds are Wᵀ times those along rates, and back by Jᵀ, with q' = W u + w and u = J
    /// q' + d.
    AffineSpeeds,
    /// Rows along speeds are Wᵀ times those along rates; the multipliers of the constraints cancel.
    Multipliers,
    /// Rows along speeds are the partial velocities times the Newton–Euler balances. The names are
    /// those of the reactions that the remaining balances give.
    PartialVelocities(Vec<String>),
    /// Rows along rates are the partial velocities with respect to q' times the Newton–Euler balances.
    PartialVelocitiesOfRates,
    /// Rows along rates are the partial velocities with respect to q' times the balances, up to
    /// constraint forces, which W cancels.
    ConstraintForces,
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
            CombinationKind::ConstraintForces => format!(
                "{left} = (partial velocities with respect to q') · {right}, the reactions being Aᵀλ along q', which W \
                 cancels on both sides"
            ),
        }
    }
}
