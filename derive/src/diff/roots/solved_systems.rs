//! Accelerations from a derived system in which printed rows replace derived rows.

use crate::algebra::Expr;
use crate::algebra::solve::linear::solve_linear;
use crate::diff::equations::matched_system::MatchedSystem;
use crate::mechanics::{Kinematics, Quantities};
use rustc_hash::FxHashMap;

/// Largest number of unknowns of a system that is solved.
const MOST_UNKNOWNS: usize = 12;
/// Number of wrong rows up to which every combination is tried. If there are more rows, each row alone and all rows
/// together are tried.
const MOST_ROWS: usize = 4;

/// Solutions computed so far, by the index of the table and the indices of the printed rows. `None` for a system that
/// cannot be solved.
#[derive(Default)]
pub struct SolvedSystems(FxHashMap<(usize, Vec<usize>), Option<Vec<Expr>>>);

impl SolvedSystems {
    /// Combinations of wrong rows that are tried, as lists of indices, with the smallest combinations first. `rows` is
    /// the number of wrong rows.
    pub fn row_sets(rows: usize) -> Vec<Vec<usize>> {
        if rows > MOST_ROWS {
            return (0..rows).map(|row| vec![row]).chain([(0..rows).collect()]).collect();
        }
        let members = |set: u32| (0..rows).filter(|row| set & (1 << row) != 0).collect::<Vec<_>>();
        let mut sets: Vec<_> = (1..1_u32 << rows).map(members).collect();
        sets.sort_by_key(Vec::len);
        sets
    }

    /// Solves the table with index `place`, in which the printed `rows` replace derived rows. Returns one value for
    /// each unknown. `None` if the unknowns are not determined, or if there are more than twelve.
    pub fn solve_system(
        &mut self,
        quantities: &mut Quantities<'_>,
        table: &MatchedSystem,
        place: usize,
        rows: &[usize],
    ) -> Option<Vec<Expr>> {
        let solved =
            self.0.entry((place, rows.to_vec())).or_insert_with(|| solve_with_printed_rows(quantities, table, rows));
        solved.clone()
    }
}

/// Solves a table in which the printed `rows` replace the derived rows that they match. `None` if it cannot be solved.
fn solve_with_printed_rows(
    quantities: &mut Quantities<'_>,
    table: &MatchedSystem,
    rows: &[usize],
) -> Option<Vec<Expr>> {
    let Kinematics { arena, simplifier, .. } = &mut quantities.derivations.kinematics;
    let mut system = table.derived.clone();
    for row in rows {
        let (at, _) = table.matched_derived_row(*row)?;
        system[at].clone_from(&table.printed[*row]);
    }
    let n = table.unknowns.len();
    if system.len() != n || n > MOST_UNKNOWNS {
        return None;
    }
    let a: Vec<Vec<Expr>> = system.iter().map(|row| row[..n].to_vec()).collect();
    let b: Vec<Vec<Expr>> = system.iter().map(|row| vec![row[n]]).collect();
    let Ok((values, _)) = solve_linear(arena, simplifier, &a, &b) else { return None };
    Some(values.into_iter().map(|row| row[0]).collect())
}

#[cfg(test)]
mod tests {
    use super::SolvedSystems;

    #[test]
    fn few_rows_are_tried_in_all_sets_and_many_alone_and_together() {
        assert_eq!(SolvedSystems::row_sets(2), [vec![0], vec![1], vec![0, 1]]);
        assert_eq!(SolvedSystems::row_sets(3).len(), 7);
        assert_eq!(SolvedSystems::row_sets(5), [vec![0], vec![1], vec![2], vec![3], vec![4], vec![0, 1, 2, 3, 4]]);
        assert!(SolvedSystems::row_sets(0).is_empty());
    }
}
