//! A row as a combination of others.

use super::printed::Printed;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::solve::linear::solve_linear;
use tripos_derive::algebra::text::parse::parse_primed;
use tripos_derive::mechanics::Kinematics;

/// λ such that Σ λ · (row of the system) has the entries of this row, its right-hand side left aside; nothing if there
/// are none, or infinitely many.
pub fn find(printed: &mut Printed, system: usize, row: &[String]) -> Option<Vec<Expr>> {
    let rows = &printed.systems[system].terms;
    let Kinematics { arena, simplifier, .. } = &mut printed.derivations.kinematics;
    let entry = |text: &String| parse_primed(arena, text, 2, &mut |arena, name| Ok(arena.symbol(name)));
    let entries: Vec<Expr> = row.iter().map(entry).collect::<Result<_, _>>().ok()?;
    let n = rows.len();
    let transposed: Vec<Vec<Expr>> = (0..n).map(|column| rows.iter().map(|row| row[column]).collect()).collect();
    let right: Vec<Vec<Expr>> = entries[..n].iter().map(|e| vec![*e]).collect();
    let (solution, _) = solve_linear(arena, simplifier, &transposed, &right).ok()?;
    Some(solution.into_iter().map(|values| values[0]).collect())
}
