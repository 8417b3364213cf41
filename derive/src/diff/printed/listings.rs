//! Judgement of printed programs (listings) that compute the time derivative of a state.

use super::judged_system::{JudgedSystem, MatchedMotion};
use super::motion_system::MotionSystem;
use crate::diff::equations::claim::Claim;
use crate::diff::equations::derived_system::{DerivedSystem, derived_system};
use crate::diff::equations::row_judgement::Row;
use crate::diff::formulas::entry_judge::{EntryJudge, PrintedFormulaValue};
use crate::diff::formulas::finding::{Finding, Judgement, TracedFinding, unjudged_finding};
use crate::diff::formulas::formula_reading::FormulaReading;

use crate::algebra::Expr;
use crate::algebra::solve::linear::solve_linear;
use crate::mechanics::{Kinematics, Quantities, QuantityKind};
use crate::publication::{Entry, Listing, QuantityNames, has_decimals};

/// Positions of the model's coordinates and motion variables (q̇ or u) in the state of a printed program (listing).
/// Each position is an index into the state; `None` for a variable that is not in the state.
fn variable_places_in_listing(
    quantities: &Quantities<'_>,
    listing: &Listing,
) -> (Vec<Option<usize>>, Vec<Option<usize>>) {
    let model = quantities.model;
    let variables = listing.formulation.variables(model);
    let place = |symbol: &Expr| listing.state.iter().position(|s| s == symbol);
    (model.q().iter().map(place).collect(), variables.iter().map(place).collect())
}

/// Column of a printed program's matrix for the motion variable with the index `at` in the
/// program's state.
fn column_of(listing: &Listing, at: usize) -> usize {
    listing.moving.iter().position(|moving| *moving == at).expect("a motion variable")
}

/// Converts a printed program (listing) to equations of motion, with its own q̇ and its own linear system or
/// accelerations. A variable that is not in the program's state gets the derivative 0. The second value is true if all
/// variables are in the state. The error is the reason why a printed term has no value.
pub fn listing_motion(
    quantities: &mut Quantities<'_>,
    names: &QuantityNames,
    entry: &Entry,
    listing: &Listing,
) -> Result<(MotionSystem, bool), String> {
    let in_rates = listing.formulation.is_in_rates();
    let reading = FormulaReading::of(listing.formulation);
    let (coordinates, variables) = variable_places_in_listing(quantities, listing);
    let mut resolved = |e: Expr| reading.value(quantities, names, e);
    let derivative: Vec<Expr> = listing.derivative.iter().map(|e| resolved(*e)).collect::<Result<_, _>>()?;
    let of_state = |at: &Option<usize>| at.map_or(Expr::ZERO, |at| derivative[at]);
    let count = variables.len();
    let unit = |i: usize| (0..count).map(|k| if k == i { Expr::ONE } else { Expr::ZERO }).collect::<Vec<_>>();
    let (matrix, right): (Vec<Vec<Expr>>, Vec<Expr>) = match &listing.matrix {
        // The rows are in the order of the listing, the columns in the order of the model.
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
    Ok((MotionSystem { id: entry.id.clone(), in_rates, coordinate_rates, matrix, right }, whole))
}

impl EntryJudge<'_, '_> {
    /// Judges a printed program: first its q̇ by the kinematic equations, then its matrix row by row or its
    /// accelerations.
    pub fn judge_listing(&mut self, entry: &Entry, listing: &Listing) -> JudgedSystem {
        let undecided = |why: String| {
            let finding = Finding { judgement: Judgement::Undecided(why), ..unjudged_finding(&entry.id, entry, "") };
            JudgedSystem { findings: vec![finding.with_claim(Claim::Other)], table: None, motion: None }
        };
        let (motion, whole) = match listing_motion(self.quantities, self.names, entry, listing) {
            Ok(found) => found,
            Err(why) => return undecided(why),
        };
        // A program that eliminates the reactions is compared with equations without reactions.
        let alike = listing.formulation.without_reactions();
        let order = match derived_system(self.quantities, alike, None) {
            Ok(order) => order,
            Err(why) => return undecided(why),
        };
        let reading = FormulaReading::of(listing.formulation);
        let model = self.quantities.model;
        let rates = if motion.in_rates { model.q_dot() } else { model.kinematic_equations.rates.clone() };
        let mut findings = Vec::new();
        let (coordinates, variables) = variable_places_in_listing(self.quantities, listing);
        for (i, rate) in rates.iter().enumerate() {
            let Some(at) = coordinates[i] else { continue };
            let (id, text) = (listing.derivative_id(&entry.id, at), &listing.derivative_texts[at]);
            let finding = unjudged_finding(&id, entry, text);
            let own = PrintedFormulaValue { raw: listing.derivative[at], value: motion.coordinate_rates[i], reading };
            findings.push(self.value(finding, &QuantityKind::Rate(i), own, *rate));
        }
        let (mut rows, mut matches) = (Vec::new(), Vec::new());
        let Some(texts) = &listing.matrix_texts else {
            findings.extend(self.judge_listing_accelerations(entry, listing, &motion, &order));
            let motion = whole.then_some(MatchedMotion { motion, matrix: Vec::new(), rows: Vec::new() });
            return self.restrict_judged_system(JudgedSystem { findings, table: None, motion });
        };
        let stated_rows =
            motion.matrix.iter().zip(&motion.right).map(|(row, right)| [row.as_slice(), &[*right]].concat());
        let (order, stated_rows) = match self.expand_judged_system(order, stated_rows.collect()) {
            Ok(both) => both,
            Err(why) => return undecided(why),
        };
        for (i, (texts, row)) in texts.iter().zip(stated_rows).enumerate() {
            let at_right = listing.moving[i];
            let right = &listing.derivative_texts[at_right];
            let has_decimals = texts.iter().chain([right]).any(|text| has_decimals(text));
            let judged = if has_decimals {
                self.judge_row_with_decimals(&row, &order, i)
            } else {
                self.judge_row(&row, &order, i)
            };
            for (j, at) in variables.iter().enumerate() {
                let Some(column) = at.map(|at| column_of(listing, at)) else { continue };
                let text = &texts[column];
                // A zero that is not written in the program is listed only if it is wrong.
                if text != "0" || !judged.entries[j].is_equal() {
                    let id = listing.matrix_id(&entry.id, i, column);
                    let claim = Claim::Entry { table: self.earlier.len(), row: i, column: j };
                    let raw = listing.matrix.as_ref().map_or(row[j], |matrix| matrix[i][column]);
                    let own = PrintedFormulaValue { raw, value: row[j], reading };
                    let finding = self.entry_finding(unjudged_finding(&id, entry, text), own, &judged, j);
                    let finding = finding.with_derived_row(&judged, &order.names);
                    findings.push(finding.with_claim(claim));
                }
            }
            let id = listing.derivative_id(&entry.id, at_right);
            let column = row.len() - 1;
            let claim = Claim::Entry { table: self.earlier.len(), row: i, column };
            let own = PrintedFormulaValue { raw: listing.derivative[at_right], value: row[column], reading };
            let finding = self.entry_finding(unjudged_finding(&id, entry, right), own, &judged, column);
            let finding = finding.with_derived_row(&judged, &order.names);
            findings.push(finding.with_claim(claim));
            rows.push(row);
            matches.push(judged.by);
        }
        let matrix = order.rows.iter().map(|row| row[..row.len() - 1].to_vec()).collect();
        let motion = whole.then(|| MatchedMotion { motion, matrix, rows: matches.clone() });
        let table = Some(order.into_matched_system(alike, rows, matches));
        self.restrict_judged_system(JudgedSystem { findings, table, motion })
    }

    /// Judges accelerations that a program states directly. They are compared with the solution of the derived system.
    fn judge_listing_accelerations(
        &mut self,
        entry: &Entry,
        listing: &Listing,
        motion: &MotionSystem,
        order: &DerivedSystem,
    ) -> Vec<TracedFinding> {
        let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
        let a: Vec<Row> = order.rows.iter().map(|row| row[..row.len() - 1].to_vec()).collect();
        let b: Vec<Row> = order.rows.iter().map(|row| vec![row[row.len() - 1]]).collect();
        let solution = solve_linear(arena, simplifier, &a, &b);
        let mut findings = Vec::new();
        let kind = if motion.in_rates { QuantityKind::SecondRate } else { QuantityKind::SpeedRate };
        let (_, variables) = variable_places_in_listing(self.quantities, listing);
        let mut places: Vec<(usize, usize)> =
            variables.into_iter().enumerate().filter_map(|(i, at)| Some((i, at?))).collect();
        // A mistake of an abbreviation is seen most clearly in an entry that consists of the abbreviation alone.
        places.sort_by_key(|(_, at)| !self.book.is_name(listing.derivative[*at]));
        for (i, at) in places {
            let (id, text) = (listing.derivative_id(&entry.id, at), &listing.derivative_texts[at]);
            let finding = unjudged_finding(&id, entry, text);
            let found = match &solution {
                Ok((values, _)) => {
                    let reading = FormulaReading::of(listing.formulation);
                    let own = PrintedFormulaValue { raw: listing.derivative[at], value: motion.right[i], reading };
                    let mut found = self.value(finding, &kind(i), own, values[i][0]);
                    if let Claim::Value { by, .. } = &mut found.claim {
                        *by = Some(listing.formulation);
                    }
                    found
                }
                Err(_) => {
                    let why = "the derived system is singular everywhere".to_owned();
                    Finding { judgement: Judgement::Undecided(why), ..finding }.with_claim(Claim::Other)
                }
            };
            findings.push((i, found));
        }
        findings.sort_by_key(|(i, _)| *i);
        findings.into_iter().map(|(_, found)| found).collect()
    }
}
