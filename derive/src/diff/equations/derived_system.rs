//! Derived system of equations with which a printed system is compared.

use super::matched_system::MatchedSystem;
use super::row_judgement::{Row, RowMatchResult};
use crate::algebra::Expr;
use crate::algebra::solve::linear::LinearForm;
use crate::mechanics::{Formulation, Kinematics, Quantities, RowName, newton_euler_balances};
use crate::model::{Model, MotionConstraintKind};

/// Derived linear system. Its columns are in the order of the unknowns, and each row ends with its right-hand side.
#[derive(Clone)]
pub struct DerivedSystem {
    /// Name of each row, such as its speed, coordinate or balance.
    pub names: Vec<RowName>,
    /// Symbols of the unknowns (accelerations, multipliers, reactions), in the order of the
    /// columns.
    pub unknowns: Vec<Expr>,
    /// Rows of the system: one coefficient for each unknown, then the right-hand side.
    pub rows: Vec<Row>,
}

/// Derives the system of the formulation `system`. Newton–Euler balances have components in `frame` if it is given. The
/// error is the reason why the formulation has no system.
pub fn derived_system(
    quantities: &mut Quantities<'_>,
    system: Formulation,
    frame: Option<usize>,
) -> Result<DerivedSystem, String> {
    let model = quantities.model;
    let found = quantities.derivations.list.iter().find(|(f, _)| *f == system).map(|(_, result)| result.clone());
    let equations = match found {
        Some(Ok(equations)) => equations,
        Some(Err(why)) => return Err(why.to_string()),
        None => return Err(format!("{} was not derived", system.name())),
    };
    let unknowns = equations.unknowns.clone();
    if let (true, Some(frame)) = (system.has_reactions(), frame) {
        let kinematics = &mut quantities.derivations.kinematics;
        let velocities = kinematics.in_speeds(model);
        let mut form = LinearForm::new(&unknowns);
        let (mut names, mut rows) = (Vec::new(), Vec::new());
        for balance in newton_euler_balances(model, kinematics, &velocities, Some(frame)) {
            let Kinematics { arena, simplifier, .. } = kinematics;
            let (mut row, rest) = form
                .coefficients(arena, balance.residual)
                .map_err(|_| "a balance is not linear in the unknowns".to_owned())?;
            row.push(arena.neg(rest));
            let row: Row = row.into_iter().map(|e| simplifier.simplify(arena, e)).collect();
            if row.iter().any(|e| *e != Expr::ZERO) {
                names.push(RowName::Balance(balance.name));
                rows.push(row);
            }
        }
        let powers = equations.rows.into_iter().zip(equations.matrix);
        for (name, mut row) in powers.filter(|(name, _)| matches!(name, RowName::Power(_) | RowName::Law { .. })) {
            row.push(Expr::ZERO);
            names.push(name);
            rows.push(row);
        }
        return Ok(DerivedSystem { names, unknowns, rows });
    }
    let rows = equations.matrix.into_iter().zip(equations.forcing).map(|(mut row, right)| {
        row.push(right);
        row.into_iter().map(|e| quantities.at_clock(e)).collect()
    });
    let rows = rows.collect();
    Ok(DerivedSystem { names: equations.rows, unknowns, rows })
}

/// True if an unknown is the second derivative of time, or the multiplier of the clock constraint
/// t' = 1.
pub fn is_derived_unknown_of_time(model: &Model, unknown: Expr) -> bool {
    let is_second_rate = model.time().is_some_and(|at| model.coordinates[at].second_rate == unknown);
    let mut constraints = model.motion_constraints.iter();
    is_second_rate || constraints.any(|c| c.kind == MotionConstraintKind::Clock && c.multiplier == unknown)
}

impl DerivedSystem {
    /// Removes the rows and unknowns of time. Time is a coordinate of the model, but not of publications.
    pub fn without_time(self, model: &Model) -> Self {
        let is_row_of_time = |name: &RowName| match name {
            RowName::Coordinate(at) => model.time() == Some(*at),
            RowName::Constraint(at) => model.motion_constraints[*at].kind == MotionConstraintKind::Clock,
            _ => false,
        };
        let Self { names, unknowns, rows } = self;
        let right = unknowns.len();
        let kept: Vec<usize> = (0..right).filter(|at| !is_derived_unknown_of_time(model, unknowns[*at])).collect();
        let of_motion = names.into_iter().zip(rows).filter(|(name, _)| !is_row_of_time(name));
        let (names, rows) =
            of_motion.map(|(name, row)| (name, kept.iter().chain([&right]).map(|at| row[*at]).collect())).unzip();
        Self { names, unknowns: kept.into_iter().map(|at| unknowns[at]).collect(), rows }
    }

    /// Names of the rows if a derivation shows these rows (`are_shown`), else no names.
    pub fn shown_rows(&self, are_shown: bool) -> &[RowName] {
        if are_shown { &self.names } else { &[] }
    }

    /// Combines this derived system with the printed rows and their matches.
    pub fn into_matched_system(
        self,
        formulation: Formulation,
        printed: Vec<Row>,
        matches: Vec<RowMatchResult>,
    ) -> MatchedSystem {
        let Self { names, unknowns, rows } = self;
        MatchedSystem { formulation, names, unknowns, derived: rows, printed, matches }
    }
}
