//! Judgement of printed linear systems and of program listings.

use super::motion::Motion;
use crate::diff::equations::claim::{Claim, Table};
use crate::diff::equations::ordered::{Ordered, derived};
use crate::diff::equations::rows::{Match, Row, RowJudgement, Terms, judge};
use crate::diff::formulas::entries::{Judge, Printed, Reading};
use crate::diff::formulas::finding::{Finding, Judgement, Mistake, ROUNDED};
use crate::diff::formulas::rounding::agrees_as_rounded;

use crate::algebra::Expr;
use crate::algebra::meaning::compare::{Engine, Verdict};
use crate::algebra::meaning::permitted::Holds;
use crate::algebra::solve::linear::{LinearForm, solve};
use crate::algebra::text::print::text;
use crate::algebra::value::rank::rank;
use crate::mechanics::{Formulation, Kinematics, Quantities, QuantityKind};
use crate::publication::{Entry, Listing, Names, System, has_decimals, row_text};

/// Derived matrix with which a printed system is compared, and the matches of the printed rows.
#[derive(Clone, Debug)]
pub struct Matched {
    /// Matrix of the derived system.
    pub matrix: Vec<Vec<Expr>>,
    /// Match of each printed row.
    pub rows: Vec<Match>,
}

/// Judgement of one printed system or listing.
pub struct Judged {
    /// Findings for rows and entries, each with its claim.
    pub findings: Vec<(Finding, Claim)>,
    /// Printed system beside the derived rows; `None` if the listing states accelerations directly.
    pub table: Option<Table>,
    /// Printed system as equations of motion, with its matches; `None` if it is incomplete.
    pub motion: Option<(Motion, Matched)>,
}

/// Rows of a system as printed, in the order of the derived unknowns. Unknowns that are not printed have the
/// coefficient 0.
fn rows_as_printed(system: &System, order: &[Expr]) -> Vec<Row> {
    let columns: Vec<Option<usize>> = order.iter().map(|x| system.unknowns.iter().position(|u| u == x)).collect();
    let row = |(entries, right): (&Vec<Expr>, &Expr)| {
        let entries = columns.iter().map(|at| at.map_or(Expr::ZERO, |at| entries[at]));
        entries.chain([*right]).collect()
    };
    system.matrix.iter().zip(&system.right).map(row).collect()
}

/// Printed rows in the order of the derived unknowns, with derived quantities in the place of their names.
fn printed(
    quantities: &mut Quantities<'_>,
    names: &Names,
    system: &System,
    order: &[Expr],
) -> Result<Vec<Row>, String> {
    let reading = Reading::of(system.formulation);
    let mut form = LinearForm::new(order);
    let mut rows = Vec::new();
    for row in rows_as_printed(system, order) {
        let mut row = row.into_iter().map(|e| reading.value(quantities, names, e)).collect::<Result<Row, String>>()?;
        // Names of derived quantities may stand for accelerations.
        let arena = &mut quantities.derivations.kinematics.arena;
        let right = row.pop().unwrap_or(Expr::ZERO);
        let not_linear = |_| "it is not linear in the unknowns".to_owned();
        let (entries, rest) = form.coefficients(arena, right).map_err(not_linear)?;
        for (entry, more) in row.iter_mut().zip(entries) {
            *entry = arena.sub(*entry, more);
        }
        row.push(rest);
        rows.push(row);
    }
    Ok(rows)
}

/// Printed system as equations of motion; `None` unless it has all unknowns and rows of the derived system.
pub fn system_motion(quantities: &mut Quantities<'_>, names: &Names, entry: &Entry, system: &System) -> Option<Motion> {
    let order = derived(quantities, system.formulation, system.frame).ok()?;
    let rows = printed(quantities, names, system, &order.unknowns).ok()?;
    let all_there = order.unknowns.iter().all(|u| system.unknowns.contains(u));
    (all_there && rows.len() == order.unknowns.len()).then(|| motion(quantities, &entry.id, system.formulation, &rows))
}

fn motion(quantities: &Quantities<'_>, id: &str, formulation: Formulation, rows: &[Row]) -> Motion {
    let model = quantities.model;
    let in_rates = formulation.is_in_rates();
    Motion {
        id: id.to_owned(),
        in_rates,
        coordinate_rates: if in_rates { model.q_dot() } else { model.kinematic_equations.rates.clone() },
        matrix: rows.iter().map(|row| row[..row.len() - 1].to_vec()).collect(),
        right: rows.iter().map(|row| row[row.len() - 1]).collect(),
    }
}

/// Indices of the model's coordinates and motion variables in the state of a listing; `None` for an absent variable.
fn places(quantities: &Quantities<'_>, listing: &Listing) -> (Vec<Option<usize>>, Vec<Option<usize>>) {
    let model = quantities.model;
    let variables = listing.formulation.variables(model);
    let place = |symbol: &Expr| listing.state.iter().position(|s| s == symbol);
    (model.q().iter().map(place).collect(), variables.iter().map(place).collect())
}

/// Column of a listing's matrix for the motion variable at a place of its state.
fn column_of(listing: &Listing, at: usize) -> usize {
    listing.moving.iter().position(|moving| *moving == at).expect("a motion variable")
}

/// Listing as equations of motion, with its own q̇ and its own system or accelerations. A variable that its state lacks
/// has the derivative 0. The second value is true if no variable is lacking.
pub fn listing_motion(
    quantities: &mut Quantities<'_>,
    names: &Names,
    entry: &Entry,
    listing: &Listing,
) -> Result<(Motion, bool), String> {
    let in_rates = listing.formulation.is_in_rates();
    let reading = Reading::of(listing.formulation);
    let (coordinates, variables) = places(quantities, listing);
    let mut resolved = |e: Expr| reading.value(quantities, names, e);
    let derivative: Vec<Expr> = listing.derivative.iter().map(|e| resolved(*e)).collect::<Result<_, _>>()?;
    let of_state = |at: &Option<usize>| at.map_or(Expr::ZERO, |at| derivative[at]);
    let count = variables.len();
    let unit = |i: usize| (0..count).map(|k| if k == i { Expr::ONE } else { Expr::ZERO }).collect::<Vec<_>>();
    let (matrix, right): (Vec<Vec<Expr>>, Vec<Expr>) = match &listing.matrix {
        // Rows in the order of the listing, columns in the order of the model.
        Some(matrix) => {
            let mut ordered = Vec::new();
            for row in matrix {
                let row = variables.iter().map(|at| at.map_or(Expr::ZERO, |at| row[column_of(listing, at)]));
                ordered.push(row.map(&mut resolved).collect::<Result<_, _>>()?);
            }
            (ordered, listing.moving.iter().map(|at| derivative[*at]).collect())
        }
        None => ((0..count).map(unit).collect(), variables.iter().map(of_state).collect()),
    };
    let coordinate_rates = coordinates.iter().map(of_state).collect();
    let whole = coordinates.iter().chain(&variables).all(Option::is_some);
    Ok((Motion { id: entry.id.clone(), in_rates, coordinate_rates, matrix, right }, whole))
}

impl Judge<'_, '_> {
    /// Judges a printed system: each row, then each entry that has an id of its own.
    pub fn system(&mut self, entry: &Entry, system: &System) -> Judged {
        let both = derived(self.quantities, system.formulation, system.frame).and_then(|order| {
            let rows = printed(self.quantities, self.names, system, &order.unknowns)?;
            self.near(order, rows)
        });
        let (mut order, rows) = match both {
            Ok(both) => both,
            Err(why) => {
                let finding = Finding::new(&entry.id, &entry.section, Judgement::Undecided(why), "");
                return Judged { findings: vec![(finding, Claim::Other)], table: None, motion: None };
            }
        };
        let raw = rows_as_printed(system, &order.unknowns);
        let reading = Reading::of(system.formulation);
        let is_equation = system.row_texts.is_some();
        let multipliers = self.own_multipliers(&mut order, &rows);
        let mut findings: Vec<(Finding, Claim)> = Vec::new();
        let mut matches = Vec::new();
        for (i, row) in rows.iter().enumerate() {
            let texts = system.matrix_texts[i].iter().chain([&system.right_texts[i]]);
            let has_decimals =
                texts.chain(system.row_texts.iter().map(|texts| &texts[i])).any(|text| has_decimals(text));
            let judged = self.row(row, &order, i, has_decimals);
            let id = system.row_id(&entry.id, i);
            let (entries, right) = (&system.matrix_texts[i], &system.right_texts[i]);
            let shown = match &system.row_texts {
                Some(texts) => texts[i].clone(),
                None => row_text(entries, &system.unknown_names, right, entry.notation),
            };
            let finding = stated(&id, entry, &shown);
            let claim = match self.expanded_from(system.formulation, &order.unknowns, row) {
                Some((table, row)) => Claim::Expansion { table, row },
                None => Claim::Row { table: self.earlier.len(), row: i },
            };
            let row_printed: Vec<Printed> =
                raw[i].iter().zip(row).map(|(raw, value)| Printed { raw: *raw, value: *value, reading }).collect();
            findings.push((self.row_finding(finding, &row_printed, &order, &judged, i, is_equation), claim));
            for (j, unknown) in system.unknowns.iter().enumerate() {
                let Some(id) = system.matrix_id(i, j) else { break };
                let Some(at) = order.unknowns.iter().position(|u| u == unknown) else { continue };
                let text = &system.matrix_texts[i][j];
                let claim = Claim::Entry { table: self.earlier.len(), row: i, column: at };
                findings.push((self.entry_finding(stated(&id, entry, text), row_printed[at], &judged, at), claim));
            }
            if let Some(id) = system.right_id(i) {
                let at = row.len() - 1;
                let claim = Claim::Entry { table: self.earlier.len(), row: i, column: at };
                let finding = stated(&id, entry, &system.right_texts[i]);
                findings.push((self.entry_finding(finding, row_printed[at], &judged, at), claim));
            }
            matches.push(judged.by);
        }
        if let Some((first, _)) = findings.first_mut() {
            first.remarks.extend(multipliers);
        }
        self.completeness(&mut findings, entry, system, &rows, order.unknowns.len());
        let whole = order.unknowns.iter().all(|u| system.unknowns.contains(u)) && rows.len() == order.unknowns.len();
        let motion = whole.then(|| {
            let matrix = order.rows.iter().map(|row| row[..row.len() - 1].to_vec()).collect();
            (motion(self.quantities, &entry.id, system.formulation, &rows), Matched { matrix, rows: matches.clone() })
        });
        let table = order.beside(system.formulation, rows, matches);
        self.kept(Judged { findings, table: Some(table), motion })
    }

    /// Writes the derived rows with the multipliers of the printed rows. Describes the printed multipliers in words if
    /// they differ.
    fn own_multipliers(&mut self, order: &mut Ordered, rows: &[Row]) -> Option<String> {
        let multipliers: Vec<Expr> =
            self.quantities.model.motion_constraints.iter().map(|constraint| constraint.multiplier).collect();
        let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
        Terms { arena, simplifier, comparer: self.comparer }.adapt(order, rows, &multipliers)
    }

    /// Expands derived and printed rows up to the order of an entry that holds near a point. Rows of other entries are
    /// unchanged.
    fn near(&mut self, order: Ordered, rows: Vec<Row>) -> Result<(Ordered, Vec<Row>), String> {
        let Some(near) = &mut self.near else { return Ok((order, rows)) };
        let mut all = |quantities: &mut Quantities<'_>, list: Vec<Row>| -> Result<Vec<Row>, String> {
            let row = |row: Row| -> Result<Row, String> {
                let entry = |(at, e): (usize, Expr)| match order.unknowns.get(at) {
                    Some(unknown) => near.factor(quantities, *unknown, e),
                    None => near.formula(quantities, e),
                };
                row.into_iter().enumerate().map(entry).collect()
            };
            list.into_iter().map(row).collect()
        };
        let (derived, rows) = (all(self.quantities, order.rows.clone())?, all(self.quantities, rows)?);
        Ok((Ordered { rows: derived, ..order }, rows))
    }

    /// Index of the earlier printed system, and of its row, whose expansion near the point of the entry is this row.
    /// `None` if there is no such row, or if the entry holds everywhere.
    fn expanded_from(&mut self, formulation: Formulation, unknowns: &[Expr], row: &Row) -> Option<(usize, usize)> {
        for (table, earlier) in self.earlier.iter().enumerate() {
            if earlier.formulation != formulation || earlier.unknowns != unknowns {
                continue;
            }
            for (at, printed) in earlier.printed.iter().enumerate() {
                let near = self.near.as_mut()?;
                let mut is_same = true;
                for (column, (whole, own)) in printed.iter().zip(row).enumerate() {
                    let expanded = match unknowns.get(column) {
                        Some(unknown) => near.factor(self.quantities, *unknown, *whole),
                        None => near.formula(self.quantities, *whole),
                    };
                    let arena = &mut self.quantities.derivations.kinematics.arena;
                    is_same = expanded.is_ok_and(|e| self.comparer.compare(arena, e, *own).is_equal());
                    if !is_same {
                        break;
                    }
                }
                if is_same {
                    return Some((table, at));
                }
            }
        }
        None
    }

    /// Result of an entry, without table and motion if the entry holds near a point. Such an entry is no equation of
    /// the whole motion, and is traced to others only if it is the expansion of a row.
    fn kept(&self, judged: Judged) -> Judged {
        if self.near.is_none() {
            return judged;
        }
        let traced = |claim: Claim| if matches!(claim, Claim::Expansion { .. }) { claim } else { Claim::Other };
        let findings = judged.findings.into_iter().map(|(finding, claim)| (finding, traced(claim))).collect();
        Judged { findings, table: None, motion: None }
    }

    /// Marks a right row as different if it depends on the rows above it: then an equation of motion is missing.
    fn completeness(
        &self,
        findings: &mut [(Finding, Claim)],
        entry: &Entry,
        system: &System,
        rows: &[Row],
        unknowns: usize,
    ) {
        let arena = &self.quantities.derivations.kinematics.arena;
        let Some((first, _)) = findings.first_mut() else { return };
        if rows.len() < unknowns {
            first.remarks.push(format!(
                "the system has {} of {unknowns} equations: it does not determine the motion",
                rows.len()
            ));
        }
        let Some(row) = rank(arena, rows).and_then(|found| found.dependent) else { return };
        let id = system.row_id(&entry.id, row);
        let Some((finding, _)) = findings.iter_mut().find(|(f, _)| f.id == id) else { return };
        if rows.len() <= unknowns && matches!(finding.judgement, Judgement::Equal | Judgement::Scaled) {
            finding.judgement = Judgement::Different;
            finding.remarks.push("it follows from the rows above: an equation of motion is missing".to_owned());
        }
    }

    /// Judges a program: its q̇ by the kinematic equations, its system row by row, or its accelerations one by one.
    pub fn listing(&mut self, entry: &Entry, listing: &Listing) -> Judged {
        let undecided = |why: String| {
            let finding = Finding { judgement: Judgement::Undecided(why), ..stated(&entry.id, entry, "") };
            Judged { findings: vec![(finding, Claim::Other)], table: None, motion: None }
        };
        let (motion, whole) = match listing_motion(self.quantities, self.names, entry, listing) {
            Ok(found) => found,
            Err(why) => return undecided(why),
        };
        // A program that eliminates the reactions is compared with equations without reactions.
        let alike = listing.formulation.without_reactions();
        let order = match derived(self.quantities, alike, None) {
            Ok(order) => order,
            Err(why) => return undecided(why),
        };
        let reading = Reading::of(listing.formulation);
        let model = self.quantities.model;
        let rates = if motion.in_rates { model.q_dot() } else { model.kinematic_equations.rates.clone() };
        let mut findings = Vec::new();
        let (coordinates, variables) = places(self.quantities, listing);
        for (i, rate) in rates.iter().enumerate() {
            let Some(at) = coordinates[i] else { continue };
            let (id, text) = (listing.derivative_id(&entry.id, at), &listing.derivative_texts[at]);
            let finding = stated(&id, entry, text);
            let own = Printed { raw: listing.derivative[at], value: motion.coordinate_rates[i], reading };
            findings.push(self.value(finding, &QuantityKind::Rate(i), own, *rate));
        }
        let (mut rows, mut matches) = (Vec::new(), Vec::new());
        let Some(texts) = &listing.matrix_texts else {
            findings.extend(self.accelerations(entry, listing, &motion, &order));
            let matched = Matched { matrix: Vec::new(), rows: Vec::new() };
            return self.kept(Judged { findings, table: None, motion: whole.then_some((motion, matched)) });
        };
        let stated_rows =
            motion.matrix.iter().zip(&motion.right).map(|(row, right)| [row.as_slice(), &[*right]].concat());
        let (order, stated_rows) = match self.near(order, stated_rows.collect()) {
            Ok(both) => both,
            Err(why) => return undecided(why),
        };
        for (i, (texts, row)) in texts.iter().zip(stated_rows).enumerate() {
            let at_right = listing.moving[i];
            let right = &listing.derivative_texts[at_right];
            let has_decimals = texts.iter().chain([right]).any(|text| has_decimals(text));
            let judged = self.row(&row, &order, i, has_decimals);
            for (j, at) in variables.iter().enumerate() {
                let Some(column) = at.map(|at| column_of(listing, at)) else { continue };
                let text = &texts[column];
                // A zero that no line of the program states is listed only if it is wrong.
                if text != "0" || !judged.entries[j].is_equal() {
                    let id = listing.matrix_id(&entry.id, i, column);
                    let claim = Claim::Entry { table: self.earlier.len(), row: i, column: j };
                    let raw = listing.matrix.as_ref().map_or(row[j], |matrix| matrix[i][column]);
                    let own = Printed { raw, value: row[j], reading };
                    findings.push((self.entry_finding(stated(&id, entry, text), own, &judged, j), claim));
                }
            }
            let id = listing.derivative_id(&entry.id, at_right);
            let column = row.len() - 1;
            let claim = Claim::Entry { table: self.earlier.len(), row: i, column };
            let own = Printed { raw: listing.derivative[at_right], value: row[column], reading };
            findings.push((self.entry_finding(stated(&id, entry, right), own, &judged, column), claim));
            rows.push(row);
            matches.push(judged.by);
        }
        let matrix = order.rows.iter().map(|row| row[..row.len() - 1].to_vec()).collect();
        let matched = Matched { matrix, rows: matches.clone() };
        let table = Some(order.beside(alike, rows, matches));
        self.kept(Judged { findings, table, motion: whole.then_some((motion, matched)) })
    }

    /// Judges accelerations that a program states directly, by those that the derived system gives.
    fn accelerations(
        &mut self,
        entry: &Entry,
        listing: &Listing,
        motion: &Motion,
        order: &Ordered,
    ) -> Vec<(Finding, Claim)> {
        let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
        let a: Vec<Row> = order.rows.iter().map(|row| row[..row.len() - 1].to_vec()).collect();
        let b: Vec<Row> = order.rows.iter().map(|row| vec![row[row.len() - 1]]).collect();
        let solution = solve(arena, simplifier, &a, &b);
        let mut findings = Vec::new();
        let kind = if motion.in_rates { QuantityKind::SecondRate } else { QuantityKind::SpeedRate };
        let (_, variables) = places(self.quantities, listing);
        let mut places: Vec<(usize, usize)> =
            variables.into_iter().enumerate().filter_map(|(i, at)| Some((i, at?))).collect();
        // A mistake of an abbreviation shows best where the abbreviation stands alone.
        places.sort_by_key(|(_, at)| !self.book.is_name(listing.derivative[*at]));
        for (i, at) in places {
            let (id, text) = (listing.derivative_id(&entry.id, at), &listing.derivative_texts[at]);
            let finding = stated(&id, entry, text);
            let found = match &solution {
                Ok((values, _)) => {
                    let reading = Reading::of(listing.formulation);
                    let own = Printed { raw: listing.derivative[at], value: motion.right[i], reading };
                    self.value(finding, &kind(i), own, values[i][0])
                }
                Err(_) => {
                    let why = "the derived system is singular everywhere".to_owned();
                    (Finding { judgement: Judgement::Undecided(why), ..finding }, Claim::Other)
                }
            };
            findings.push((i, found));
        }
        findings.sort_by_key(|(i, _)| *i);
        findings.into_iter().map(|(_, found)| found).collect()
    }

    /// Judges a row. Its decimals, if it has some, may stand for parameters.
    fn row(&mut self, row: &Row, order: &Ordered, index: usize, has_decimals: bool) -> RowJudgement {
        if has_decimals && let Some(judged) = self.rounded(row, order, index) {
            return judged;
        }
        let parameters = self.quantities.model.p();
        let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
        let mut terms = Terms { arena, simplifier, comparer: self.comparer };
        judge(&mut terms, &parameters, row, &order.rows, index)
    }

    /// Judgement of a row that is a derived row to the digits printed, the one of equal number first; `None` if there
    /// is no such row, or if the row is equal without rounding.
    fn rounded(&mut self, row: &Row, order: &Ordered, index: usize) -> Option<RowJudgement> {
        let own = index.min(order.rows.len() - 1);
        for at in std::iter::once(own).chain((0..order.rows.len()).filter(|at| *at != own)) {
            let expected = order.rows[at].clone();
            let (mut entries, mut holds, mut is_rounded) = (Vec::new(), Vec::new(), false);
            for (printed, derived) in row.iter().zip(&expected) {
                let arena = &mut self.quantities.derivations.kinematics.arena;
                let (mut verdict, place) = self.comparer.compare_where(arena, *printed, *derived);
                if !verdict.is_equal()
                    && agrees_as_rounded(self.quantities, self.comparer, self.numbers, *printed, *derived)
                {
                    (verdict, is_rounded) = (Verdict::Equal(Engine::NormalForm), true);
                }
                if !verdict.is_equal() {
                    break;
                }
                entries.push(verdict);
                holds.push(place);
            }
            if is_rounded && entries.len() == row.len() {
                let by = Match::Row { at, factor: Expr::ONE };
                return Some(RowJudgement { by, entries, expected, holds, is_rounded });
            }
        }
        None
    }

    fn row_finding(
        &mut self,
        mut finding: Finding,
        row: &[Printed],
        order: &Ordered,
        judged: &RowJudgement,
        index: usize,
        is_equation: bool,
    ) -> Finding {
        finding.judgement = Judgement::Equal;
        finding.holds = judged.holds();
        // Row as one term: Σ entry · unknown − right.
        let as_term = |judge: &mut Self, row: &Row| {
            let arena = &mut judge.quantities.derivations.kinematics.arena;
            let mut terms: Vec<Expr> = row.iter().zip(&order.unknowns).map(|(a, x)| arena.mul(*a, *x)).collect();
            terms.push(arena.neg(row[row.len() - 1]));
            arena.sum(&terms)
        };
        finding.derived = Some(as_term(self, &judged.expected));
        match &judged.by {
            Match::Row { at, factor } => {
                // The sides of an equation may be the other way round.
                let is_turned = is_equation && *factor == Expr::MINUS_ONE;
                if *factor != Expr::ONE && !is_turned {
                    finding.factor = Some(*factor);
                    finding.judgement = Judgement::Scaled;
                }
                if *at != index {
                    finding.remarks.push(format!("compared with derived row {}", at + 1));
                }
            }
            Match::Combination { multipliers } => {
                finding.judgement = Judgement::Scaled;
                let arena = &self.quantities.derivations.kinematics.arena;
                let parts = multipliers.iter().enumerate().filter(|(_, m)| **m != Expr::ZERO);
                let parts: Vec<String> = parts.map(|(i, m)| format!("({}) row {}", text(arena, *m), i + 1)).collect();
                let by = if parts.is_empty() { "of derived rows".to_owned() } else { parts.join(" + ") };
                finding.remarks.push(format!("a combination: {by}"));
            }
        }
        if judged.is_rounded {
            finding.up_to = Some("to the digits printed");
            finding.remarks.push(ROUNDED.to_owned());
        }
        if judged.is_right() {
            return finding;
        }
        finding.holds = Holds::EVERYWHERE;
        let undecided = judged.entries.iter().find_map(|v| match v {
            Verdict::Undecided(why) => Some(why.clone()),
            _ => None,
        });
        let witness = judged.entries.iter().find_map(|v| match v {
            Verdict::Different(witness) => Some(witness.clone()),
            _ => None,
        });
        finding.judgement = match (&witness, undecided) {
            (None, Some(why)) => Judgement::Undecided(why),
            _ => Judgement::Different,
        };
        let raw: Row = row.iter().map(|printed| printed.raw).collect();
        let raw = as_term(self, &raw);
        let (model, arena) = (self.quantities.model, &self.quantities.derivations.kinematics.arena);
        if let Err(message) = model.checked_unit_of(arena, raw) {
            finding.remarks.push(format!("units alone show it: {message}"));
        }
        let wrong: Vec<usize> = (0..judged.entries.len()).filter(|at| !judged.entries[*at].is_equal()).collect();
        let mut places = Vec::new();
        let mut mistakes = Vec::new();
        for at in wrong {
            let unknown = order.unknowns.get(at);
            let (words, mistake) = self.wrong_place(unknown, row[at], judged.expected[at]);
            finding.places.push(self.place(unknown));
            places.push(words);
            mistakes.push(mistake);
        }
        if let [mistake] = mistakes.as_slice() {
            (finding.change, finding.slip) = (mistake.change, mistake.slip);
            finding.abbreviation.clone_from(&mistake.abbreviation);
        }
        let wrong = places.join("; ");
        finding.remarks.push(format!("wrong: {wrong}"));
        finding.wrong = Some(wrong);
        let values: Row = row.iter().map(|printed| printed.value).collect();
        let printed = as_term(self, &values);
        let expected = as_term(self, &judged.expected);
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let difference = arena.sub(printed, expected);
        // The witness is a state of the whole row, unknowns included, or else of a wrong entry.
        finding.witness = match self.comparer.compare(arena, printed, expected) {
            Verdict::Different(whole) => Some(whole),
            _ => witness,
        };
        finding.difference = Some(self.simplify(difference));
        finding
    }

    /// Name of an entry of a row.
    fn place(&self, unknown: Option<&Expr>) -> String {
        let arena = &self.quantities.derivations.kinematics.arena;
        match unknown {
            Some(unknown) => format!("the coefficient of {}", text(arena, *unknown)),
            None => "the right-hand side".to_owned(),
        }
    }

    /// Description of a wrong entry of a row, its place and what should be there, and the mistake.
    fn wrong_place(&mut self, unknown: Option<&Expr>, printed: Printed, expected: Expr) -> (String, Mistake) {
        let place = self.place(unknown);
        let difference = self.quantities.derivations.kinematics.arena.sub(printed.value, expected);
        let difference = self.simplify(difference);
        let mistake = self.mistake(printed, expected, difference);
        if !mistake.words.is_empty() {
            return (format!("in {place}, {}", mistake.words.join(", ")), mistake);
        }
        let arena = &self.quantities.derivations.kinematics.arena;
        (format!("{place} is off by {}", text(arena, difference)), mistake)
    }

    fn entry_finding(&mut self, finding: Finding, printed: Printed, judged: &RowJudgement, at: usize) -> Finding {
        let verdict = (judged.entries[at].clone(), judged.holds[at]);
        let mut finding = finding.judged(verdict, judged.expected[at]);
        match &judged.by {
            Match::Row { factor, .. } if *factor != Expr::ONE => {
                finding.factor = Some(*factor);
                if finding.judgement == Judgement::Equal {
                    finding.judgement = Judgement::Scaled;
                }
            }
            Match::Combination { .. } if finding.judgement == Judgement::Equal => finding.judgement = Judgement::Scaled,
            Match::Combination { .. } | Match::Row { .. } => {}
        }
        if finding.judgement == Judgement::Different {
            let difference = self.quantities.derivations.kinematics.arena.sub(printed.value, judged.expected[at]);
            let difference = self.simplify(difference);
            finding.difference = Some(difference);
            finding.name_mistake(self.mistake(printed, judged.expected[at], difference));
        }
        finding
    }
}

/// Finding of an entry before it is judged.
fn stated(id: &str, entry: &Entry, text: &str) -> Finding {
    Finding::new(id, &entry.section, Judgement::Stated, text)
}
