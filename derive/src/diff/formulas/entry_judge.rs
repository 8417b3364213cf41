//! Judgement of printed values of named quantities.

use super::expansion_near_point::PointExpansion;
use super::finding::{Finding, Judgement, Mistake, ROUNDED, TracedFinding};
use super::formula_reading::FormulaReading;
use super::ratio::constant_ratio;
use super::rounded_numbers::agrees_to_printed_digits;
use super::wrong_terms::{WrongTerm, wrong_terms};
use crate::diff::equations::claim::Claim;
use crate::diff::equations::lagrange_multipliers::Multipliers;
use crate::diff::equations::matched_system::MatchedSystem;
use crate::diff::repairs::{
    AbbreviationMistakes, MistakeKind, PrintedFormula, Repair, RepairSearch, RepairTools, find_change_pair, find_repair,
};

use crate::algebra::meaning::compare::Comparer;
use crate::algebra::meaning::permitted_states::StatesOfValidity;
use crate::algebra::text::print::print_text;
use crate::algebra::{Expr, Node};
use crate::mechanics::{Kinematics, Quantities, Quantity, QuantityKind};
use crate::publication::{QuantityNames, has_decimals};

/// Largest number of rounds in which a derived value is shortened before it is shown.
const MOST_ROUNDS: usize = 4;

/// Longest printed or derived value, in bytes, that a finding shows as a whole.
pub(super) const LONGEST: usize = 70;

/// Longest list of wrong terms, in bytes, that is reported. If the list is longer, two changes of the formula are
/// sought instead.
const LONGEST_LIST: usize = 150;

/// Formula as printed, with its value in the variables of the comparison.
#[derive(Clone, Copy, Debug)]
pub struct PrintedFormulaValue {
    /// Formula as printed, in the names of the publication.
    pub raw: Expr,
    /// Value of the formula, in the variables in which it is compared.
    pub value: Expr,
    /// Variables in which the printed formula is compared with the derived value.
    pub reading: FormulaReading,
}

/// Judge of the entries of a publication, with all tools and earlier results.
pub struct EntryJudge<'a, 'b> {
    /// Derived quantities with which entries are compared.
    pub quantities: &'a mut Quantities<'b>,
    /// Comparer that decides the equality of terms and stores their normal forms.
    pub comparer: &'a mut Comparer,
    /// Derived values of the names that the publication uses.
    pub names: &'a QuantityNames,
    /// Printed systems that precede the judged entry in the publication.
    pub earlier: &'a [MatchedSystem],
    /// Point near which the entry holds, with the order of the approximation; `None` if the entry claims to hold
    /// everywhere.
    pub near: Option<PointExpansion>,
    /// Number of changes that may still be tried in the search for mistakes.
    pub changes_left: &'a mut usize,
    /// Record of the publication's abbreviations, with the abbreviations known to be wrong.
    pub book: &'a mut AbbreviationMistakes,
    /// Lagrange multipliers as the publication defines them.
    pub multipliers: &'a mut Multipliers,
    /// Parameters with their numbers, from the publication or else from the model.
    pub numbers: &'a [(Expr, Expr)],
}

impl EntryJudge<'_, '_> {
    /// Judges the entry `quantity = printed`. Returns its finding and its claim (the statement as data, for tracing
    /// mistakes).
    pub fn judge_equation(&mut self, finding: Finding, quantity: &Quantity, printed: Expr) -> TracedFinding {
        let (raw, in_rates) = (printed, self.quantities.mentions_rates(printed));
        // In a formula for an acceleration, all other accelerations are replaced with their derived values.
        let is_solved = matches!(quantity.kind(), QuantityKind::SpeedRate(_) | QuantityKind::SecondRate(_));
        let both = self.names.resolve_quantity_names(self.quantities, printed).and_then(|printed| {
            let derived = self.quantities.value(quantity)?;
            let printed = if is_solved { self.quantities.solved(printed)? } else { printed };
            Ok((printed, derived))
        });
        let (printed, derived) = match both {
            Ok(both) => both,
            Err(why) => return Finding { judgement: Judgement::Undecided(why), ..finding }.with_claim(Claim::Other),
        };
        // The definition of a speed contains rates, whatever variables the printed entry uses.
        let in_rates = in_rates || self.quantities.mentions_rates(derived);
        let derived = if in_rates { self.quantities.before_constraints(quantity.kind(), derived) } else { derived };
        let mut rewrite = |e: Expr| if in_rates { self.quantities.in_rates(e) } else { self.quantities.in_speeds(e) };
        let (printed, derived) = (rewrite(printed), rewrite(derived));
        let derived = self.simplify(derived);
        let printed = PrintedFormulaValue { raw, value: printed, reading: FormulaReading { in_rates, is_solved } };
        let TracedFinding { finding: found, claim } = self.value(finding.clone(), quantity.kind(), printed, derived);
        let finding = match quantity.kind() {
            // Only a difference with the unit of an energy can be a freely chosen part of an energy.
            QuantityKind::Energy(energy) if energy.has_a_zero() => {
                let found = self.energy_with_free_constant(finding, &found, printed, derived).unwrap_or(found);
                if self.unit_remark(raw, derived).is_none() {
                    self.up_to_free_parts(found, *energy, printed.value)
                } else {
                    found
                }
            }
            _ => found,
        };
        finding.with_claim(claim)
    }

    /// Judges a printed value of a quantity against the derived value. Both are given in the same variables.
    pub fn value(
        &mut self,
        finding: Finding,
        kind: &QuantityKind,
        printed: PrintedFormulaValue,
        derived: Expr,
    ) -> TracedFinding {
        if let Some(near) = &mut self.near {
            near.separate_orders_if_needed(self.quantities, &[printed.value]);
            // A difference beyond the order of an approximation is not traced to other entries.
            let both = near
                .expand_formula(self.quantities, printed.value)
                .and_then(|p| Ok((p, near.expand_formula(self.quantities, derived)?)));
            let finding = match both {
                Ok((value, derived)) => {
                    self.judge_against_derived(finding, PrintedFormulaValue { value, ..printed }, derived)
                }
                Err(why) => Finding { judgement: Judgement::Undecided(why), ..finding },
            };
            return finding.with_claim(Claim::Other);
        }
        let finding = self.judge_against_derived(finding, printed, derived);
        finding.with_claim(Claim::Value { kind: kind.clone(), printed: printed.value, derived, by: None })
    }

    /// Judges a printed value against a derived value. For a wrong value, the finding also gets the difference. It gets
    /// the factor if the ratio of the values is constant, and the mistake otherwise.
    pub fn judge_against_derived(&mut self, finding: Finding, printed: PrintedFormulaValue, derived: Expr) -> Finding {
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let (verdict, holds) = self.comparer.compare_with_states(arena, printed.value, derived);
        let is_everywhere = verdict.is_equal() && holds == StatesOfValidity::EVERYWHERE;
        let derived = if is_everywhere { derived } else { self.shorten_in_permitted_states(derived) };
        let mut finding = finding.with_verdict(verdict, holds, derived);
        if is_everywhere {
            self.book.record_right_formula(printed.raw);
        }
        if finding.judgement == Judgement::Different {
            if has_decimals(&finding.printed)
                && agrees_to_printed_digits(self.quantities, self.comparer, self.numbers, printed.value, derived)
            {
                return finding.accept_with_remark("to the digits printed", ROUNDED.to_owned());
            }
            finding.remarks.extend(self.unit_remark(printed.raw, derived));
            let arena = &mut self.quantities.derivations.kinematics.arena;
            let difference = arena.sub(printed.value, derived);
            let difference = self.simplify(difference);
            finding.difference = Some(difference);
            let factor = constant_ratio(self.quantities, self.comparer, printed.value, derived);
            finding.factor = factor.or_else(|| {
                // In permitted states, rates that depend on others, as for a rolling wheel, are written in the
                // independent rates.
                let arena = &mut self.quantities.derivations.kinematics.arena;
                let [own, right] =
                    [printed.value, derived].map(|e| self.comparer.permitted().write_in_free_symbols(arena, e));
                constant_ratio(self.quantities, self.comparer, own, right)
            });
            match finding.factor {
                None => finding.name_mistake(self.find_mistake(printed, derived, difference)),
                Some(factor) => {
                    let arena = &self.quantities.derivations.kinematics.arena;
                    finding.slip = MistakeKind::of_factor(arena, factor);
                    let is_involved = arena.reachable(&[factor]).iter().any(|e| match arena.node(*e) {
                        Node::Sum(constant, terms) => terms.len() > 1 || !constant.is_zero(),
                        Node::Apply(..) => true,
                        _ => false,
                    });
                    // A factor in parameters may come from a wrong abbreviation. If both values are constant, any
                    // mistake gives a factor, so that a factor with sums or functions is no information.
                    let is_number = arena.as_number(factor).is_some();
                    let found = self.find_abbreviation_mistake(printed, derived, RepairSearch::Values);
                    let found = found.filter(|mistake| !mistake.abbreviations.is_empty());
                    let mistake = if is_involved && found.is_none() && !is_number {
                        self.find_repair(printed, derived, RepairSearch::Values)
                    } else {
                        found
                    };
                    if let Some(mistake) = mistake {
                        finding.factor = None;
                        finding.name_mistake(mistake);
                    }
                }
            }
        }
        finding
    }

    /// Remark that the unit of a printed value is inconsistent, or not the unit of the derived value. `None` if the
    /// units fit or are unknown.
    fn unit_remark(&self, printed: Expr, derived: Expr) -> Option<String> {
        let (model, arena) = (self.quantities.model, &self.quantities.derivations.kinematics.arena);
        let has_parameters = |e: Expr| model.parameters.iter().any(|p| arena.mentions(e, p.symbol));
        if !has_parameters(printed) && has_parameters(derived) {
            // Units cannot be checked, since numbers stand for parameters.
            return None;
        }
        match (model.checked_unit_of(arena, printed), model.checked_unit_of(arena, derived)) {
            (Err(message), _) => Some(format!("units alone show it: {message}")),
            (Ok(Some(own)), Ok(Some(right))) if own != right => Some(format!(
                "units alone show it: it is in {}, and should be in {}",
                own.unit_words(),
                right.unit_words()
            )),
            _ => None,
        }
    }

    /// Describes the mistake in a printed value in the shortest way found. It is a single wrong term of a sum, or the
    /// smallest change that makes the formula right. Otherwise it is a list of all wrong terms, or both whole values if
    /// they are short.
    pub fn find_mistake(&mut self, printed: PrintedFormulaValue, derived: Expr, difference: Expr) -> Mistake {
        if let Some(mistake) = self.find_abbreviation_mistake(printed, derived, RepairSearch::Values) {
            return mistake;
        }
        let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
        let terms = wrong_terms(arena, simplifier, printed.value, difference);
        let words: Vec<String> = terms.iter().map(|term| term.words(arena)).collect();
        let slip = if let [term] = *terms.as_slice() { Some(term.slip(arena)) } else { None };
        match *terms.as_slice() {
            [WrongTerm::Extra(own)] => return Mistake::of_single_part(words, (own, Expr::ZERO), slip),
            [WrongTerm::Other(own, right)] => return Mistake::of_single_part(words, (own, right), slip),
            _ => {}
        }
        if let Some(mistake) = self.find_repair(printed, derived, RepairSearch::Values) {
            return mistake;
        }
        let (model, arena) = (self.quantities.model, &self.quantities.derivations.kinematics.arena);
        let has_units = |term: &WrongTerm| term.parts().all(|e| model.checked_unit_of(arena, e).is_ok());
        let is_listed = !words.is_empty()
            && words.iter().map(String::len).sum::<usize>() <= LONGEST_LIST
            && terms.iter().all(has_units);
        if !is_listed && let Some(words) = self.find_two_mistakes(printed, derived) {
            return Mistake { words, ..Mistake::default() };
        }
        let arena = &self.quantities.derivations.kinematics.arena;
        if let [WrongTerm::Extra(own), WrongTerm::Missing(right)] | [WrongTerm::Missing(right), WrongTerm::Extra(own)] =
            *terms.as_slice()
        {
            let words = WrongTerm::Other(own, right).words(arena);
            return Mistake::of_single_part(vec![words], (own, right), slip);
        }
        let [before, after] = [printed.value, derived].map(|e| print_text(arena, e));
        let is_long = before.len() > LONGEST || after.len() > LONGEST;
        let is_each_printed = !terms.is_empty() && terms.iter().all(|term| !matches!(term, WrongTerm::Missing(_)));
        if is_long || is_each_printed {
            return Mistake { words, change: None, slip, abbreviations: Vec::new() };
        }
        Mistake::of_single_part(vec![format!("{before} should be {after}")], (printed.value, derived), slip)
    }

    /// Finds a single slip that explains the whole error of a printed value; the slip may be in an abbreviation. `None`
    /// if there is none.
    pub fn find_slip(&mut self, printed: PrintedFormulaValue, derived: Expr) -> Option<Mistake> {
        let found = self.find_abbreviation_mistake(printed, derived, RepairSearch::Slips);
        found.or_else(|| self.find_repair(printed, derived, RepairSearch::Slips))
    }

    /// Finds a single change that makes a printed value right, with its abbreviations written out. `None` if there is
    /// none.
    fn find_repair(&mut self, printed: PrintedFormulaValue, derived: Expr, search: RepairSearch) -> Option<Mistake> {
        let Repair { words, parts, slip, .. } =
            self.search_repairs_with_tools(printed, |tools, formula, _| find_repair(tools, formula, derived, search))?;
        Some(Mistake { words: vec![words], change: parts, slip: Some(slip), abbreviations: Vec::new() })
    }

    /// Mistake of a formula that uses abbreviations, found with the abbreviations kept as symbols.
    /// Returns `None` if the formula uses no abbreviation, or if no mistake is found.
    fn find_abbreviation_mistake(
        &mut self,
        printed: PrintedFormulaValue,
        derived: Expr,
        search: RepairSearch,
    ) -> Option<Mistake> {
        let found = self.search_repairs_with_tools(printed, |tools, _, book| {
            book.find_abbreviation_mistake(tools, printed.raw, derived, search)
        })?;
        Some(Mistake { words: found.words, change: found.parts, slip: found.slip, abbreviations: found.abbreviations })
    }

    /// Finds two mistakes that together explain the whole error of a formula, and describes them. `None` if none are
    /// found. Abbreviations are first kept as symbols; if no mistakes are found in this way, they are written out.
    fn find_two_mistakes(&mut self, printed: PrintedFormulaValue, derived: Expr) -> Option<Vec<String>> {
        self.search_repairs_with_tools(printed, |tools, formula, book| {
            if let Some(found) = book.find_two_mistakes(tools, printed.raw, derived) {
                return Some(found.words);
            }
            find_change_pair(tools, formula, derived).map(|both| both.map(|one| one.words).into())
        })
    }

    /// Runs `search` for repairs of a printed formula, with the formula, the tools and the record of abbreviations as
    /// arguments. If the entry holds near a point, changed formulas are expanded before they are compared.
    fn search_repairs_with_tools<T>(
        &mut self,
        printed: PrintedFormulaValue,
        search: impl FnOnce(&mut RepairTools<'_, '_>, &mut PrintedFormula, &mut AbbreviationMistakes) -> Option<T>,
    ) -> Option<T> {
        let (names, reading, near) = (self.names, printed.reading, &mut self.near);
        let mut rewriting = |quantities: &mut Quantities<'_>, e: Expr| {
            let value = reading.value(quantities, names, e)?;
            near.as_mut().map_or(Ok(value), |near| near.expand_formula(quantities, value))
        };
        let mut formula =
            PrintedFormula::without_abbreviations(&self.quantities.derivations.kinematics.arena, printed.raw);
        let (quantities, comparer) = (&mut *self.quantities, &mut *self.comparer);
        let mut tools = RepairTools { quantities, comparer, rewriting: &mut rewriting, left: self.changes_left };
        search(&mut tools, &mut formula, self.book)
    }

    /// Shortens a term in at most four rounds. The result is equal to the term in all states that the constraints
    /// permit.
    fn shorten_in_permitted_states(&mut self, e: Expr) -> Expr {
        let mut short = e;
        // The shortened term may contain further sums that can be shortened.
        for _ in 0..MOST_ROUNDS {
            let arena = &mut self.quantities.derivations.kinematics.arena;
            let next = self.comparer.permitted().replace_by_shorter_terms(arena, short);
            if next == short {
                break;
            }
            short = self.simplify(next);
        }
        short
    }

    /// Simplifies a term of the derivations. The result is equal to the term everywhere.
    pub fn simplify(&mut self, e: Expr) -> Expr {
        let kinematics = &mut self.quantities.derivations.kinematics;
        kinematics.simplifier.simplify(&mut kinematics.arena, e)
    }
}
