//! Linear relations between the columns of a regressor, in residues modulo a prime.

use super::known_parameters::KnownParameters;
use crate::algebra::value::field::Field;
use crate::algebra::value::rank::{reduced_echelon_form, unique_solution};
use crate::algebra::value::residues::ResidueSampler;
use crate::algebra::{Arena, Expr};
use crate::mechanics::Column;
use rustc_hash::FxHashSet;

/// Number of further states at which the rank of the columns must not increase.
const STILL: usize = 2;
/// Largest number of random draws for a state, in search of values at which all terms are defined. Each square root of
/// a moving term halves the chance of a draw.
const TRIES: usize = 500;
/// Largest number of primes that are tried. The square root of a number exists modulo every second prime.
const PRIMES: usize = 12;

/// Linear relations between the columns of a regressor. Their factors can be computed at random
/// values of the known parameters.
pub struct ColumnRelations<'a> {
    /// Source of random values, and evaluator of the columns and atoms.
    sampler: ResidueSampler<'a>,
    /// Finite field (integers modulo a prime) of all residues.
    field: Field,
    /// Symbols that change during a motion. They get new random values for each state.
    moving: &'a FxHashSet<Expr>,
    /// Number of generalized speeds, which is the number of rows of the regressor.
    speeds: usize,
    /// Number of columns of the regressor.
    columns: usize,
    /// Indices of the regressor's columns that do not depend linearly on earlier columns.
    pub pivots: Vec<usize>,
    /// Dependent nonzero columns, as pairs of the column's index and the pivot columns of which it
    /// is a linear combination. The latter are indices into `pivots`.
    pub dependent: Vec<(usize, Vec<usize>)>,
    /// Number of random states at which the columns were evaluated to find their rank.
    pub states: usize,
}

/// Residues of factors and atoms at a point. A point is one choice of random values for the known
/// parameters.
pub struct RelationResidues {
    /// Factors of each dependent column, as residues, in the order of the pivot columns in its
    /// linear combination.
    pub factors: Vec<Vec<u64>>,
    /// Values of the atoms, as residues, in the order of [`KnownParameters::atoms`].
    pub atoms: Vec<u64>,
}

/// Parameters whose values at a point come from another seed than that of the point, with this
/// seed. `None` if there are none.
pub type ChangedParameters<'s> = Option<(&'s FxHashSet<Expr>, u64)>;

impl<'a> ColumnRelations<'a> {
    /// Finds the dependent columns for general values of the known parameters. `None` if no values
    /// of the columns are found modulo any of the tried primes.
    pub fn new(arena: &'a Arena, columns: &[Column], letters: &'a KnownParameters) -> Option<Self> {
        let terms = columns.iter().flat_map(|column| &column.forces).chain(letters.atoms()).copied().collect();
        let mut sampler = ResidueSampler::new(arena, terms);
        let (field, seed) = (sampler.field(), sampler.seed());
        let speeds = columns.first().map_or(0, |column| column.forces.len());
        let (pivots, dependent) = Default::default();
        let mut table = Self {
            sampler,
            field,
            moving: &letters.moving,
            speeds,
            columns: columns.len(),
            pivots,
            dependent,
            states: 0,
        };
        if columns.is_empty() {
            return Some(table);
        }
        let mut seed = seed;
        for _ in 0..PRIMES {
            if table.find_state_count(seed).is_some() {
                break;
            }
            (table.field, table.states) = (table.sampler.field(), 0);
            seed = table.seed();
        }
        if table.states == 0 {
            return None;
        }
        // Two points are used, since a factor may be 0 by chance at one of them.
        let again = table.seed();
        for seed in [seed, again] {
            table.add_supports(seed)?;
        }
        table.dependent.iter_mut().for_each(|(_, support)| support.sort_unstable());
        table.dependent.retain(|(_, support)| !support.is_empty());
        Some(table)
    }

    /// Increases the number of states until the rank of the columns no longer increases. `None` if
    /// no values of the terms are found.
    fn find_state_count(&mut self, seed: u64) -> Option<()> {
        self.states = self.columns.div_ceil(self.speeds.max(1)).max(1);
        let rank = |table: &Self, states: usize| {
            Some(reduced_echelon_form(table.field, &mut table.rows(seed, None, states)?.0).len())
        };
        let mut known = rank(self, self.states)?;
        loop {
            let next = rank(self, self.states + STILL)?;
            self.states += STILL;
            if next == known {
                return Some(());
            }
            (known, self.states) = (next, self.states + self.columns.div_ceil(4 * self.speeds));
        }
    }

    /// Adds the pivot columns on which each dependent column depends at a point. `None` if no
    /// values of the terms are found there.
    fn add_supports(&mut self, seed: u64) -> Option<()> {
        let mut rows = self.rows(seed, None, self.states)?.0;
        let pivots = reduced_echelon_form(self.field, &mut rows);
        if self.pivots.len() < pivots.len() {
            self.pivots.clone_from(&pivots);
            self.dependent = (0..self.columns).filter(|at| !pivots.contains(at)).map(|at| (at, Vec::new())).collect();
        }
        for (column, support) in &mut self.dependent {
            for (pivot, row) in rows.iter().enumerate() {
                if row[*column] != 0 && !support.contains(&pivot) {
                    support.push(pivot);
                }
            }
        }
        Some(())
    }

    /// Draws a seed for a further point, which has other random values of the known parameters.
    pub fn seed(&mut self) -> u64 {
        self.sampler.seed()
    }

    /// Finite field (integers modulo a prime) of all residues.
    pub fn field(&self) -> Field {
        self.field
    }

    /// Evaluates the columns and the atoms at random states, as residues. Returns a matrix with a
    /// row for each speed of each state, and the values of the atoms. `None` if no values of the
    /// terms are found.
    fn rows(&self, seed: u64, moved: ChangedParameters<'_>, states: usize) -> Option<(Vec<Vec<u64>>, Vec<u64>)> {
        let mut rows = Vec::new();
        let mut left = states;
        for state in 0..u64::try_from(states * TRIES).unwrap_or(u64::MAX) {
            let layers: Vec<_> = [(self.moving, state)].into_iter().chain(moved).collect();
            let Some(values) = self.sampler.at(self.field, seed, &layers) else { continue };
            let (forces, of_letters) = values.split_at(self.columns * self.speeds);
            for speed in 0..self.speeds {
                rows.push((0..self.columns).map(|column| forces[column * self.speeds + speed]).collect());
            }
            left -= 1;
            if left == 0 {
                return Some((rows, of_letters.to_vec()));
            }
        }
        None
    }

    /// Factors of the dependent columns at the point of a seed, as residues. `None` if the columns
    /// have no values there, or if the factors are not unique.
    pub fn relation_factors_at(&self, seed: u64, moved: ChangedParameters<'_>) -> Option<RelationResidues> {
        let (rows, atoms) = self.rows(seed, moved, self.states)?;
        let factors = self.dependent.iter().map(|(column, support)| {
            let places: Vec<usize> = support.iter().map(|pivot| self.pivots[*pivot]).chain([*column]).collect();
            let part = rows.iter().map(|row| places.iter().map(|at| row[*at]).collect());
            // Rows with only zeros state nothing about the factors.
            unique_solution(self.field, part.filter(|row: &Vec<u64>| row.iter().any(|x| *x != 0)).collect())
        });
        Some(RelationResidues { factors: factors.collect::<Option<_>>()?, atoms })
    }
}
