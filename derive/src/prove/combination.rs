//! Combinations of rows as values: the multipliers that lead from one formulation to another, the relations that are
//! put in before, and the identities that the combined rows satisfy.

use crate::algebra::Expr;
use crate::algebra::meaning::identity::Identity;
use crate::mechanics::Formulation;

/// Combination of the rows of one formulation that gives the rows of another, with its identities.
#[derive(Clone, Debug)]
pub struct Combination {
    /// Formulation whose rows are combined.
    pub of: Formulation,
    /// Formulation whose rows the combination gives.
    pub gives: Formulation,
    /// Relations that are put into the rows before they are combined, each a symbol with its value: q̇ = W u + w and
    /// q̈ = W u̇ + x, or u = J q̇ + d and u̇ = J q̈ + y. Empty if both formulations have the same motion variables.
    pub relations: Vec<(Expr, Expr)>,
    /// Multipliers of the rows of `of`: one list for each row of the result. Empty if rows are equal one by one.
    pub multipliers: Vec<Vec<Expr>>,
    /// Identities that the combined rows satisfy, each with the part of the system that it is about.
    pub identities: Vec<(Part, Identity)>,
}

/// Part of a linear system that an identity is about. Indices count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Coefficient of an unknown in a combined row, and the same coefficient of the expected row, or 0 for an unknown
    /// that the expected row lacks.
    Coefficient {
        /// Index of the row.
        row: usize,
        /// Index of the unknown.
        unknown: usize,
    },
    /// Right-hand side of a combined row, and that of the expected row.
    Right {
        /// Index of the row.
        row: usize,
    },
    /// Entry of a row of a constraint, which vanishes.
    Constraint,
    /// Sum of the powers of a reaction along a speed, which vanishes.
    Power {
        /// Index of the speed.
        speed: usize,
        /// Index of the reaction.
        reaction: usize,
    },
}

/// Way from the rows of one formulation to those of another, as data.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Map {
    /// Formulation that the way starts from in words: the one in speeds, if the other is in rates or has reactions.
    pub left: Formulation,
    /// Other formulation.
    pub right: Formulation,
    /// Kind of the combination.
    pub kind: MapKind,
}

/// Kind of a combination of rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MapKind {
    /// Rows are equal one by one.
    RowByRow,
    /// The rows along speeds are Wᵀ times those along rates, and back by Jᵀ, with q' = W u and u = J q'.
    LinearSpeeds,
    /// The rows along speeds are Wᵀ times those along rates, and back by Jᵀ, with q' = W u + w and u = J q' + d.
    AffineSpeeds,
    /// The rows along speeds are Wᵀ times those along rates, and the multipliers of the constraints cancel.
    Multipliers,
    /// The rows along speeds are the partial velocities times the balances; the names are those of the reactions that
    /// the other balances give.
    PartialVelocities(Vec<String>),
    /// The rows along rates are the partial velocities with respect to q' times the balances.
    PartialVelocitiesOfRates,
    /// The same up to the forces of the constraints, which W cancels on both sides.
    ConstraintForces,
}

impl Map {
    /// Way from one formulation to the other, in words and symbols.
    #[must_use]
    pub fn text(&self) -> String {
        let [left, right] = [self.left, self.right].map(|formulation| formulation.method().label);
        let both_ways = |with: &str| format!("{left} = Wᵀ · {right} and {right} = Jᵀ · {left}, with {with}");
        match &self.kind {
            MapKind::RowByRow => format!("{left} = {right}, row by row"),
            MapKind::LinearSpeeds => both_ways("q' = W u and u = J q'"),
            MapKind::AffineSpeeds => both_ways("q' = W u + w and u = J q' + d"),
            MapKind::Multipliers => format!(
                "{left} = Wᵀ · {right}, the multipliers cancel, and the rows of the constraints vanish, with q' = W u + w; \
                 what {right} has beside {left} gives the multipliers"
            ),
            MapKind::PartialVelocities(reactions) => {
                let given = match reactions.as_slice() {
                    [] => "both have the same number of rows".to_owned(),
                    [one] => format!("the remaining equation gives {one}"),
                    several => format!("the remaining equations give {}", several.join(", ")),
                };
                format!("{left} = (partial velocities) · {right}, the reactions cancel; {given}")
            }
            MapKind::PartialVelocitiesOfRates => {
                format!("{left} = (partial velocities with respect to q') · {right}, the reactions cancel")
            }
            MapKind::ConstraintForces => format!(
                "{left} = (partial velocities with respect to q') · {right}, the reactions being Aᵀλ along q', which W \
                 cancels on both sides"
            ),
        }
    }
}
