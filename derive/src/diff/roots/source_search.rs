//! Search for the earlier wrong entries that are proved to cause a wrong entry.
//!
//! The nearest earlier entries are tried first: a line is more likely to follow from the line above it than from a line
//! one page before. The number of comparisons is limited. Beyond the limit, entries stay unexplained.

use super::consequences_of_values::ValueConsequences;
use super::exact_comparison::{ExactComparison, WrongValue};
use super::root::DependenceKind;
use super::row_changes::row_changed_by_printed_values;
use super::shared_mistake::find_shared_mistake;
use super::solved_systems::SolvedSystems;
use crate::algebra::Expr;
use crate::algebra::meaning::permitted_states::PermittedStates;
use crate::algebra::value::rank::independent_rows;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::diff::equations::claim::Claim;
use crate::diff::equations::matched_system::MatchedSystem;
use crate::diff::equations::row_judgement::Row;
use crate::diff::formulas::constant_terms::is_constant;
use crate::mechanics::{Quantities, QuantityKind};
use rustc_hash::FxHashMap;

/// Largest number of sources that are combined to explain an entry, besides the combination of all sources.
const LARGEST_SET: usize = 3;
/// Largest number of rows of a system whose combinations are compared with a printed row.
const MOST_ROWS: usize = 8;
/// Largest number of combinations of each size that are tried for one entry.
const SETS: usize = 100;

/// Reason why an entry is wrong. Entries are given by their indices in the list of wrong entries.
pub struct DependenceReason {
    /// Kind of dependence on the sources: repeated, follows or contradicts.
    pub link: DependenceKind,
    /// Indices of the entries that are named as sources.
    pub from: Vec<usize>,
    /// Indices of the earlier entries whose roots the entry shares.
    pub hangs_on: Vec<usize>,
}

impl DependenceReason {
    /// Creates a reason with the sources `from`, all of which are named.
    pub fn new(link: DependenceKind, from: Vec<usize>) -> Self {
        Self { link, hangs_on: from.clone(), from }
    }
}

/// Place of a printed row: indices of its table and of the row within the table.
#[derive(Clone, Copy)]
struct RowPlace {
    table: usize,
    row: usize,
}

/// Search for the reasons of the wrong entries of a publication, with its intermediate results.
pub struct SourceSearch<'a, 'b> {
    /// Comparisons of terms, limited in number.
    exact: ExactComparison<'a, 'b>,
    /// Claims of the wrong entries, in the order of the publication file.
    stated: &'a [&'a Claim],
    /// Printed systems that are matched with derived rows.
    tables: &'a [MatchedSystem],
    /// Values of the wrong entries in q, u and u̇; `None` for entries that are not values of
    /// quantities.
    values: Vec<Option<WrongValue>>,
    /// Consequences of each wrong value alone; `None` for entries that are not values of quantities.
    chains: Vec<Option<ValueConsequences>>,
    /// Rows that follow from one wrong value, by (source, table, derived row). `None` if the row does not depend on the
    /// value.
    rows: FxHashMap<(usize, usize, usize), Option<Row>>,
    /// Solutions of derived systems in which printed rows replace derived ones.
    solutions: SolvedSystems,
    /// Description of the mistake that each entry shares with another component; `None` if there is no such mistake.
    pub shared: Vec<Option<String>>,
}

impl<'a, 'b> SourceSearch<'a, 'b> {
    /// Creates the search among the wrong entries. `stated` are their claims (statements as data), in the order of the
    /// publication file.
    pub fn new(
        quantities: &'a mut Quantities<'b>,
        permitted: &PermittedStates,
        stated: &'a [&'a Claim],
        tables: &'a [MatchedSystem],
    ) -> Self {
        let mut values = Vec::new();
        for claim in stated {
            let Claim::Value { kind, printed, derived, .. } = claim else {
                values.push(None);
                continue;
            };
            let (printed, derived) = (quantities.in_speeds(*printed), quantities.in_speeds(*derived));
            values.push(Some(WrongValue { kind: kind.clone(), printed, derived }));
        }
        let model = quantities.model;
        let chain = |v: &Option<WrongValue>| v.as_ref().map(|v| ValueConsequences::new(model, vec![v.clone()]));
        Self {
            chains: values.iter().map(chain).collect(),
            shared: vec![None; values.len()],
            exact: ExactComparison::new(quantities, permitted),
            stated,
            tables,
            values,
            rows: FxHashMap::default(),
            solutions: SolvedSystems::default(),
        }
    }

    /// Finds the reason why the entry `at` is wrong among the entries before it; `None` if the entry is a root mistake.
    pub fn find_source(&mut self, at: usize) -> Option<DependenceReason> {
        let before = (0..at).rev();
        if let Claim::Expansion { table, row } = self.stated[at] {
            let is_whole = |source: &usize| matches!(self.stated[*source], Claim::Row { table: t, row: r } if (t, r) == (table, row));
            return before
                .clone()
                .find(is_whole)
                .map(|source| DependenceReason::new(DependenceKind::Follows, vec![source]));
        }
        if let Claim::HeldTime = self.stated[at] {
            let earlier = before.clone().find(|source| matches!(self.stated[*source], Claim::HeldTime));
            return earlier.map(|source| DependenceReason::new(DependenceKind::Repeated, vec![source]));
        }
        if let Some(source) = before.clone().find(|source| self.repeats_source(*source, at)) {
            return Some(DependenceReason::new(DependenceKind::Repeated, vec![source]));
        }
        if let Some(source) = before.clone().find(|source| self.follows_from_source(*source, at)) {
            let link = if self.is_opposite(source, at) { DependenceKind::Repeated } else { DependenceKind::Follows };
            return Some(DependenceReason::new(link, vec![source]));
        }
        if let Some(sources) = self.find_solved_rows(at) {
            return Some(DependenceReason::new(DependenceKind::Follows, sources));
        }
        if let Some(source) = self.find_shared_mistake(at) {
            return Some(DependenceReason::new(DependenceKind::Repeated, vec![source]));
        }
        self.follows_from_several(at).map(|sources| DependenceReason::new(DependenceKind::Follows, sources))
    }

    /// True if `value` equals the printed value in `of`. Energies whose zero is free may differ by a constant.
    fn is_printed(&mut self, value: Expr, of: &WrongValue) -> bool {
        let arena = &mut self.exact.quantities.derivations.kinematics.arena;
        let difference = arena.sub(value, of.printed);
        match of.kind {
            QuantityKind::Energy(energy) if energy.has_a_zero() => is_constant(self.exact.quantities, difference),
            _ => self.exact.compare_exactly(difference, Expr::ZERO),
        }
    }

    /// True if the entry `at` repeats the entry `source`: it has the same wrong value of one quantity, or the same
    /// error in a row.
    fn repeats_source(&mut self, source: usize, at: usize) -> bool {
        if let (Some(a), Some(b)) = (&self.values[source], &self.values[at]) {
            let (kinds_agree, a, b) = (a.kind == b.kind, a.printed, b.printed);
            return kinds_agree && self.exact.compare_exactly(a, b);
        }
        let (Some(a), Some(b)) = (self.row_of(source), self.row_of(at)) else { return false };
        let (from, to) = (&self.tables[a.table], &self.tables[b.table]);
        let (Some((row, factor)), Some((own, _))) = (from.matched_derived_row(a.row), to.matched_derived_row(b.row))
        else {
            return false;
        };
        if from.formulation != to.formulation || from.names[row] != to.names[own] {
            return false;
        }
        let arena = &mut self.exact.quantities.derivations.kinematics.arena;
        let Some(with) = from.printed[a.row].iter().map(|e| arena.div(*e, factor)).collect::<Option<Row>>() else {
            return false;
        };
        // A single wrong entry determines no other entry of its row.
        if let Claim::Entry { column, .. } = self.stated[source]
            && !matches!(self.stated[at], Claim::Entry { column: c, .. } if c == column)
        {
            return false;
        }
        self.fits_printed_entry(at, b, &with)
    }

    /// Place of the row that contains an entry; `None` for an entry that is not in a row.
    fn row_of(&self, at: usize) -> Option<RowPlace> {
        match *self.stated[at] {
            Claim::Row { table, row } | Claim::Entry { table, row, .. } => Some(RowPlace { table, row }),
            _ => None,
        }
    }

    /// True if the printed entry `at` agrees with the row `with`, which replaces the derived row. A row must agree as a
    /// whole, up to a factor. A single entry must agree only in its own column.
    fn fits_printed_entry(&mut self, at: usize, place: RowPlace, with: &Row) -> bool {
        let table = &self.tables[place.table];
        let printed = &table.printed[place.row];
        if let (Claim::Entry { column, .. }, Some((_, factor))) =
            (self.stated[at], table.matched_derived_row(place.row))
        {
            let scaled = self.exact.quantities.derivations.kinematics.arena.mul(factor, with[*column]);
            if self.exact.compare_exactly(scaled, printed[*column]) {
                return true;
            }
        }
        self.is_multiple(printed, with)
    }

    /// True if the row `a` is a multiple of the row `b`.
    fn is_multiple(&mut self, a: &Row, b: &Row) -> bool {
        let arena = &mut self.exact.quantities.derivations.kinematics.arena;
        let both = |at: &usize| [a[*at], b[*at]].iter().all(|e| zero_test(arena, *e) == ZeroTest::NonZero);
        let Some(pivot) = (0..a.len()).find(both) else { return false };
        (0..a.len()).filter(|at| *at != pivot).all(|at| {
            let arena = &mut self.exact.quantities.derivations.kinematics.arena;
            let (left, right) = (arena.mul(a[at], b[pivot]), arena.mul(b[at], a[pivot]));
            self.exact.compare_exactly(left, right)
        })
    }

    /// True if the printed entry `at` follows exactly when the printed value of `source` replaces
    /// the derived value.
    fn follows_from_source(&mut self, source: usize, at: usize) -> bool {
        let Some(mut chain) = self.chains[source].take() else { return false };
        let key = self
            .row_of(at)
            .and_then(|at| Some((source, at.table, self.tables[at.table].matched_derived_row(at.row)?.0)));
        if let Some(key) = key {
            let table = &self.tables[key.1];
            let quantities = &mut *self.exact.quantities;
            self.rows.entry(key).or_insert_with(|| row_changed_by_printed_values(quantities, &mut chain, table, key.2));
        }
        let known = key.and_then(|key| self.rows[&key].clone());
        let found =
            self.gives_printed_entry(&mut chain, known, at) || self.gives_printed_combination(&mut chain, source, at);
        self.chains[source] = Some(chain);
        found
    }

    /// True if the printed values in `chain` give exactly the printed entry `at`. `row` is the row of the entry,
    /// computed with these values; `None` if the entry is not in a row.
    fn gives_printed_entry(&mut self, chain: &mut ValueConsequences, row: Option<Row>, at: usize) -> bool {
        if let (Some(place), Some(row)) = (self.row_of(at), row) {
            return self.fits_printed_entry(at, place, &row);
        }
        let Some(value) = self.values[at].clone() else { return false };
        let reached =
            chain.printed(&value.kind).is_none().then(|| chain.value(self.exact.quantities, &value.kind)).flatten();
        reached.is_some_and(|reached| self.is_printed(reached, &value))
    }

    /// True if the printed row `at` is a combination of the rows that follow from the printed values in `chain`, which
    /// are those of the entry `source`. An equation solved for an acceleration is such a combination.
    fn gives_printed_combination(&mut self, chain: &mut ValueConsequences, source: usize, at: usize) -> bool {
        let Claim::Row { table: place, row } = *self.stated[at] else { return false };
        let table = &self.tables[place];
        if table.derived.len() > MOST_ROWS {
            return false;
        }
        let quantities = &mut *self.exact.quantities;
        let mut is_changed = false;
        let mut rows: Vec<Row> = Vec::new();
        for (derived, own) in table.derived.iter().enumerate() {
            let changed = self
                .rows
                .entry((source, place, derived))
                .or_insert_with(|| row_changed_by_printed_values(quantities, chain, table, derived));
            is_changed |= changed.is_some();
            rows.push(changed.clone().unwrap_or_else(|| own.clone()));
        }
        let arena = &self.exact.quantities.derivations.kinematics.arena;
        let count = |rows: &[Row]| independent_rows(arena, rows).map(|found| found.len());
        let with = [&rows[..], std::slice::from_ref(&table.printed[row])].concat();
        is_changed && count(&rows).is_some() && count(&rows) == count(&with)
    }

    /// True if the printed value at `at` equals the printed value at `source`, or its negative. Inertia torques T* =
    /// −dH/dt are printed with either sign.
    fn is_opposite(&mut self, source: usize, at: usize) -> bool {
        let (Some(a), Some(b)) = (&self.values[source], &self.values[at]) else { return false };
        let (a, b) = (a.printed, b.printed);
        let negative = self.exact.quantities.derivations.kinematics.arena.neg(a);
        self.exact.compare_exactly(a, b) || self.exact.compare_exactly(negative, b)
    }

    /// Finds wrong printed rows before the entry `at`, an acceleration, whose solution gives exactly the printed
    /// acceleration. Returns the indices of the entries with these rows. `None` if there are none, or if the entry is
    /// no acceleration.
    fn find_solved_rows(&mut self, at: usize) -> Option<Vec<usize>> {
        let value = self.values[at].clone()?;
        let symbol = self.acceleration_of(at)?;
        // If the entry names its formulation, the equations of this formulation are tried first.
        let Claim::Value { by, .. } = self.stated[at] else { return None };
        let mut tables: Vec<(usize, &MatchedSystem)> = self.tables.iter().enumerate().rev().collect();
        tables.sort_by_key(|(_, table)| *by != Some(table.formulation));
        for (place, table) in tables {
            let Some(column) = table.unknowns.iter().position(|u| *u == symbol) else { continue };
            let rows = self.wrong_rows(place, at);
            for set in SolvedSystems::row_sets(rows.len()) {
                let chosen: Vec<usize> = set.iter().map(|i| rows[*i].0).collect();
                let Some(solved) = self.solutions.solve_system(self.exact.quantities, table, place, &chosen) else {
                    continue;
                };
                let solved = self.exact.quantities.in_speeds(solved[column]);
                if self.exact.compare_exactly(solved, value.printed) {
                    return Some(set.into_iter().map(|i| rows[i].1).collect());
                }
            }
            for (row, first) in rows {
                if let Some(sources) = self.find_solved_row(at, table, row, column, &value) {
                    return Some(sources.into_iter().chain([first]).collect());
                }
            }
        }
        None
    }

    /// Finds printed accelerations from which one printed row gives the entry `at`, another acceleration. Returns the
    /// indices of their entries. The row is solved for the entry's acceleration, with the last printed value of each
    /// other acceleration. Returns `None` if the result is not the printed entry.
    fn find_solved_row(
        &mut self,
        at: usize,
        table: &MatchedSystem,
        row: usize,
        column: usize,
        value: &WrongValue,
    ) -> Option<Vec<usize>> {
        let own = table.printed[row].clone();
        let right = own.len() - 1;
        let (mut rest, mut sources) = (own[right], Vec::new());
        for (other, unknown) in table.unknowns.iter().enumerate().filter(|(other, _)| *other != column) {
            if own[other] == Expr::ZERO {
                continue;
            }
            let source = (0..at).rev().find(|source| self.acceleration_of(*source) == Some(*unknown))?;
            let arena = &mut self.exact.quantities.derivations.kinematics.arena;
            let product = arena.mul(own[other], self.values[source].as_ref()?.printed);
            rest = arena.sub(rest, product);
            sources.push(source);
        }
        if sources.is_empty() {
            return None;
        }
        let solved = self.exact.quantities.derivations.kinematics.arena.div(rest, own[column])?;
        let solved = self.exact.quantities.in_speeds(solved);
        self.exact.compare_exactly(solved, value.printed).then_some(sources)
    }

    /// Symbol of the acceleration whose formula the publication prints in the wrong entry with index
    /// `at`; `None` if the entry is not an acceleration.
    fn acceleration_of(&self, at: usize) -> Option<Expr> {
        let model = self.exact.quantities.model;
        match self.values[at].as_ref()?.kind {
            QuantityKind::SpeedRate(speed) => Some(model.speeds[speed].rate),
            QuantityKind::SecondRate(coordinate) => Some(model.coordinates[coordinate].second_rate),
            _ => None,
        }
    }

    /// Indices of wrong rows of a table, each with the index of the first entry that contains the row. Only entries
    /// before the entry `before` count.
    fn wrong_rows(&self, table: usize, before: usize) -> Vec<(usize, usize)> {
        let mut rows: Vec<(usize, usize)> = Vec::new();
        for at in 0..before {
            let Some(RowPlace { row, .. }) = self.row_of(at).filter(|place| place.table == table) else { continue };
            if !rows.iter().any(|(known, _)| *known == row) {
                rows.push((row, at));
            }
        }
        rows
    }

    /// Finds an earlier entry with the same mistake, which is another component of the same vector or matrix. Returns
    /// its index, and records the description of the shared mistake. Returns `None` if there is none.
    fn find_shared_mistake(&mut self, at: usize) -> Option<usize> {
        let own = self.values[at].clone()?;
        for source in (0..at).rev() {
            let Some(other) = self.values[source].clone() else { continue };
            if let Some(shared) = find_shared_mistake(&mut self.exact, &other, &own) {
                let words = shared.words(self.exact.quantities);
                self.shared[source].get_or_insert_with(|| words.clone());
                self.shared[at] = Some(words);
                return Some(source);
            }
        }
        None
    }

    /// Finds several earlier wrong values that together give exactly the entry: two, three, or one of each quantity.
    /// Returns the indices of their entries; `None` if no combination gives the entry.
    fn follows_from_several(&mut self, at: usize) -> Option<Vec<usize>> {
        let reaching: Vec<usize> = (0..at).rev().filter(|source| self.depends_on_source(*source, at)).collect();
        for set in self.source_sets(&reaching) {
            if self.follows_from_sources(&set, at) {
                return Some(set);
            }
        }
        let mut all = self.nearest_source_of_each_quantity(&reaching);
        if all.len() <= LARGEST_SET || !self.follows_from_sources(&all, at) {
            return None;
        }
        // A value that the result does not need is no source.
        for source in all.clone() {
            let fewer: Vec<usize> = all.iter().copied().filter(|s| *s != source).collect();
            if self.follows_from_sources(&fewer, at) {
                all = fewer;
            }
        }
        all.sort_unstable();
        Some(all)
    }

    /// Combinations of two and of three sources of different quantities, each in the order of the
    /// publication file.
    fn source_sets(&self, sources: &[usize]) -> Vec<Vec<usize>> {
        let is_other = |set: &[usize], source: usize| set.iter().all(|s| self.kind(*s) != self.kind(source));
        let larger = |sets: &[Vec<usize>]| {
            let mut list = Vec::new();
            for set in sets {
                let earlier = sources.iter().filter(|source| **source < set[0] && is_other(set, **source));
                list.extend(earlier.map(|source| [&[*source], &set[..]].concat()));
            }
            list
        };
        let mut sets: Vec<Vec<usize>> = sources.iter().map(|source| vec![*source]).collect();
        let mut tried = Vec::new();
        for _ in 1..LARGEST_SET {
            sets = larger(&sets);
            sets.truncate(SETS);
            tried.extend(sets.iter().cloned());
        }
        tried
    }

    /// Quantity whose value the publication prints in an entry; `None` for an entry that is no value.
    fn kind(&self, at: usize) -> Option<&QuantityKind> {
        self.values[at].as_ref().map(|v| &v.kind)
    }

    /// True if the expected value of the entry `at` depends on the printed value of `source`.
    fn depends_on_source(&mut self, source: usize, at: usize) -> bool {
        if let Some(place) = self.row_of(at) {
            let Some((derived, _)) = self.tables[place.table].matched_derived_row(place.row) else { return false };
            return self.rows.get(&(source, place.table, derived)).is_some_and(Option::is_some);
        }
        let Some(kind) = self.values[at].as_ref().map(|v| v.kind.clone()) else { return false };
        let Some(chain) = &mut self.chains[source] else { return false };
        chain.printed(&kind).is_none() && chain.value(self.exact.quantities, &kind).is_some()
    }

    /// Selects one source for each quantity: the one nearest to the entry that is explained.
    fn nearest_source_of_each_quantity(&self, sources: &[usize]) -> Vec<usize> {
        let mut chosen: Vec<usize> = Vec::new();
        for source in sources {
            if !chosen.iter().any(|c| self.kind(*c) == self.kind(*source)) {
                chosen.push(*source);
            }
        }
        chosen
    }

    /// True if the printed entry `at` follows exactly when the values of all `sources` together replace the derived
    /// values.
    fn follows_from_sources(&mut self, sources: &[usize], at: usize) -> bool {
        let put: Vec<WrongValue> = sources.iter().filter_map(|s| self.values[*s].clone()).collect();
        let twice = put.iter().enumerate().any(|(i, value)| put[..i].iter().any(|other| other.kind == value.kind));
        if twice || self.exact.has_no_comparisons_left() {
            return false;
        }
        let mut chain = ValueConsequences::new(self.exact.quantities.model, put);
        let row = self.row_of(at).and_then(|place| {
            let table = &self.tables[place.table];
            row_changed_by_printed_values(
                self.exact.quantities,
                &mut chain,
                table,
                table.matched_derived_row(place.row)?.0,
            )
        });
        self.gives_printed_entry(&mut chain, row, at)
    }
}
