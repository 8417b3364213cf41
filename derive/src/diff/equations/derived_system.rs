//! Derived system with which a printed system is compared.

use super::claim::Table;
use super::rows::{Match, Row};
use crate::algebra::Expr;
use crate::algebra::solve::linear::LinearForm;
use crate::mechanics::{Formulation, Kinematics, Quantities, RowName, balances};
use crate::model::MotionConstraintKind;

/// System in the order of the derived unknowns. Each row is its entries, then its right-hand side.
pub struct Ordered {
    /// Name of each row.
    pub names: Vec<RowName>,
    /// Symbols of the unknowns.
    pub unknowns: Vec<Expr>,
    /// Rows of the system, each with its right-hand side last.
    pub rows: Vec<Row>,
}

/// Derived system of a formulation. Balances have components in `frame`, the publication's frame, if it is stated. The
/// error is the reason why there is no system.
pub fn derived(quantities: &mut Quantities<'_>, system: Formulation, frame: Option<usize>) -> Result<Ordered, String> {
    let model = quantities.model;
    let found = quantities.derivations.list.iter().find(|(f, _)| *f == system).map(|(_, result)| result.clone());
    let equations = match found {
        Some(Ok(equations)) => equations,
        Some(Err(why)) => return Err(why.to_string()),
        None => return Err(format!("{} was not derived", system.name())),
    };
    let unknowns = equations.unknowns.clone();
    if let (true, Some(frame)) = (system.carries_reactions(), frame) {
        let kinematics = &mut quantities.derivations.kinematics;
        let velocities = kinematics.in_speeds(model);
        let mut form = LinearForm::new(&unknowns);
        let (mut names, mut rows) = (Vec::new(), Vec::new());
        for balance in balances(model, kinematics, &velocities, Some(frame)) {
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
        return Ok(Ordered { names, unknowns, rows });
    }
    // Time, a coordinate of the model whose rate is 1, is no coordinate of a publication.
    let time = model.time().map(|at| &model.coordinates[at]);
    let clocks: Vec<usize> = (0..model.motion_constraints.len())
        .filter(|at| model.motion_constraints[*at].kind == MotionConstraintKind::Clock)
        .collect();
    let is_of_time = |unknown: &Expr| {
        time.is_some_and(|t| t.second_rate == *unknown)
            || clocks.iter().any(|at| model.motion_constraints[*at].multiplier == *unknown)
    };
    let is_row_of_time = |name: &RowName| match name {
        RowName::Coordinate(at) => model.time() == Some(*at),
        RowName::Constraint(at) => clocks.contains(at),
        _ => false,
    };
    let columns: Vec<usize> = (0..unknowns.len()).filter(|at| !is_of_time(&unknowns[*at])).collect();
    let (mut names, mut rows) = (Vec::new(), Vec::new());
    for (name, (entries, right)) in equations.rows.into_iter().zip(equations.matrix.into_iter().zip(equations.forcing))
    {
        if !is_row_of_time(&name) {
            let row = columns.iter().map(|at| entries[*at]).chain([right]);
            rows.push(row.map(|e| quantities.at_clock(e)).collect());
            names.push(name);
        }
    }
    Ok(Ordered { names, unknowns: columns.into_iter().map(|at| unknowns[at]).collect(), rows })
}

impl Ordered {
    /// Table of this system beside the printed rows that were matched with it.
    pub fn beside(self, formulation: Formulation, printed: Vec<Row>, matches: Vec<Match>) -> Table {
        let Self { names, unknowns, rows } = self;
        Table { formulation, names, unknowns, derived: rows, printed, matches }
    }
}
