//! Judgement of printed values of named quantities.

use super::finding::{Finding, Judgement, Mistake, ROUNDED, TracedFinding};
use super::near::Near;
use super::ratio::constant_ratio;
use super::rounding::agrees_as_rounded;
use super::terms::{WrongTerm, wrong_terms};
use crate::diff::equations::claim::{Claim, Table};
use crate::diff::equations::multipliers::Multipliers;
use crate::diff::repairs::{Book, Formula, Repair, Search, Slip, Tools, pair, repair};

use crate::algebra::meaning::compare::Comparer;
use crate::algebra::meaning::permitted::Holds;
use crate::algebra::text::print::text;
use crate::algebra::{Expr, Node};
use crate::mechanics::{Formulation, Kinematics, Quantities, Quantity, QuantityKind};
use crate::publication::{Names, has_decimals};

/// Most rounds in which sums of a derived value are shortened.
const MOST_ROUNDS: usize = 4;

/// Longest text of a printed and of a derived value that are set against one another as a whole, in bytes.
pub(super) const LONGEST: usize = 70;

/// Longest list of wrong terms in the place of which two changes of the formula are sought, in bytes.
const LONGEST_LIST: usize = 150;

/// Variables in which a printed formula is compared.
#[derive(Clone, Copy, Debug)]
pub struct Reading {
    /// True if the variables are q and q̇, false if they are q and u.
    pub in_rates: bool,
    /// True if accelerations in the formula stand for their derived values.
    pub is_solved: bool,
}

impl Reading {
    /// Reading of the formulas of a system, in the variables of its formulation.
    pub fn of(formulation: Formulation) -> Self {
        Self { in_rates: formulation.is_in_rates(), is_solved: false }
    }

    /// Value of a printed term, with derived quantities in the place of their names.
    ///
    /// # Errors
    /// The reason why the term has no value.
    pub fn value(self, quantities: &mut Quantities<'_>, names: &Names, e: Expr) -> Result<Expr, String> {
        let e = names.resolve(quantities, e)?;
        let e = if self.is_solved { quantities.solved(e)? } else { e };
        Ok(if self.in_rates { quantities.in_rates(e) } else { quantities.in_speeds(e) })
    }
}

/// A formula as printed, and its value.
#[derive(Clone, Copy, Debug)]
pub struct Printed {
    /// Formula as printed, with the names of the publication.
    pub raw: Expr,
    /// Value of the formula, in the variables in which it is compared.
    pub value: Expr,
    /// Variables in which the formula is compared.
    pub reading: Reading,
}

/// Judge of the entries of a publication, one by one.
pub struct Judge<'a, 'b> {
    /// Derived quantities with which entries are compared.
    pub quantities: &'a mut Quantities<'b>,
    /// Comparer, which decides the equality of terms and remembers normal forms.
    pub comparer: &'a mut Comparer,
    /// Values of the names that the publication gives to derived quantities.
    pub names: &'a Names,
    /// Printed systems before this entry.
    pub earlier: &'a [Table],
    /// Point near which the formula claims to hold; `None` if the formula claims to hold everywhere.
    pub near: Option<Near>,
    /// Number of changes that may still be tried to name mistakes.
    pub changes_left: &'a mut usize,
    /// Abbreviations of the publication, and those that are known to be wrong.
    pub book: &'a mut Book,
    /// Multipliers of the publication.
    pub multipliers: &'a mut Multipliers,
    /// Parameters with the numbers that the publication, or else the model, gives them.
    pub numbers: &'a [(Expr, Expr)],
}

impl Judge<'_, '_> {
    /// Judges `quantity = printed`, and returns the claim of the entry.
    pub fn equation(&mut self, finding: Finding, quantity: &Quantity, printed: Expr) -> TracedFinding {
        let (raw, in_rates) = (printed, self.quantities.mentions_rates(printed));
        // An acceleration in the formula for an acceleration stands for its derived value.
        let is_solved = matches!(quantity.kind(), QuantityKind::SpeedRate(_) | QuantityKind::SecondRate(_));
        let both = self.names.resolve(self.quantities, printed).and_then(|printed| {
            let derived = self.quantities.value(quantity)?;
            let printed = if is_solved { self.quantities.solved(printed)? } else { printed };
            Ok((printed, derived))
        });
        let (printed, derived) = match both {
            Ok(both) => both,
            Err(why) => return Finding { judgement: Judgement::Undecided(why), ..finding }.with_claim(Claim::Other),
        };
        // The definition of a speed contains rates, in whatever variables the entry is printed.
        let in_rates = in_rates || self.quantities.mentions_rates(derived);
        let derived = if in_rates { self.quantities.before_constraints(quantity.kind(), derived) } else { derived };
        let mut rewrite = |e: Expr| if in_rates { self.quantities.in_rates(e) } else { self.quantities.in_speeds(e) };
        let (printed, derived) = (rewrite(printed), rewrite(derived));
        let derived = self.simplify(derived);
        let printed = Printed { raw, value: printed, reading: Reading { in_rates, is_solved } };
        let TracedFinding { finding: found, claim } = self.value(finding.clone(), quantity.kind(), printed, derived);
        let finding = match quantity.kind() {
            // What is added to an energy is an energy.
            QuantityKind::Energy(energy) if energy.has_a_zero() => {
                let found = self.with_other_zero(finding, &found, printed, derived).unwrap_or(found);
                if self.units(raw, derived).is_none() {
                    self.up_to_free_parts(found, *energy, printed.value)
                } else {
                    found
                }
            }
            _ => found,
        };
        finding.with_claim(claim)
    }

    /// Judges a printed value of a quantity against the derived value; both are in the same variables.
    pub fn value(&mut self, finding: Finding, kind: &QuantityKind, printed: Printed, derived: Expr) -> TracedFinding {
        if let Some(near) = &mut self.near {
            near.keep_products_of(self.quantities, &[printed.value]);
            // A difference beyond the order of an approximation is not traced to other entries.
            let both = near
                .formula(self.quantities, printed.value)
                .and_then(|p| Ok((p, near.formula(self.quantities, derived)?)));
            let finding = match both {
                Ok((value, derived)) => self.compare(finding, Printed { value, ..printed }, derived),
                Err(why) => Finding { judgement: Judgement::Undecided(why), ..finding },
            };
            return finding.with_claim(Claim::Other);
        }
        let finding = self.compare(finding, printed, derived);
        finding.with_claim(Claim::Value { kind: kind.clone(), printed: printed.value, derived, by: None })
    }

    /// Judges a printed against a derived value. Adds the difference and, if the values have a constant ratio, the
    /// factor; else the mistake.
    pub fn compare(&mut self, finding: Finding, printed: Printed, derived: Expr) -> Finding {
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let (verdict, holds) = self.comparer.compare_where(arena, printed.value, derived);
        let is_everywhere = verdict.is_equal() && holds == Holds::EVERYWHERE;
        let derived = if is_everywhere { derived } else { self.shortened(derived) };
        let mut finding = finding.judged(verdict, holds, derived);
        if is_everywhere {
            self.book.trust(printed.raw);
        }
        if finding.judgement == Judgement::Different {
            if has_decimals(&finding.printed)
                && agrees_as_rounded(self.quantities, self.comparer, self.numbers, printed.value, derived)
            {
                return finding.accepted("to the digits printed", ROUNDED.to_owned());
            }
            finding.remarks.extend(self.units(printed.raw, derived));
            let arena = &mut self.quantities.derivations.kinematics.arena;
            let difference = arena.sub(printed.value, derived);
            let difference = self.simplify(difference);
            finding.difference = Some(difference);
            let factor = constant_ratio(self.quantities, self.comparer, printed.value, derived);
            finding.factor = factor.or_else(|| {
                // Rates that follow from others, as of a rolling wheel, are written in these.
                let arena = &mut self.quantities.derivations.kinematics.arena;
                let [own, right] = [printed.value, derived].map(|e| self.comparer.permitted().put(arena, e));
                constant_ratio(self.quantities, self.comparer, own, right)
            });
            match finding.factor {
                None => finding.name_mistake(self.mistake(printed, derived, difference)),
                Some(factor) => {
                    let arena = &self.quantities.derivations.kinematics.arena;
                    finding.slip = Slip::of_factor(arena, factor);
                    let is_involved = arena.reachable(&[factor]).iter().any(|e| match arena.node(*e) {
                        Node::Sum(constant, terms) => terms.len() > 1 || !constant.is_zero(),
                        Node::Apply(..) => true,
                        _ => false,
                    });
                    // A factor in parameters may come of an abbreviation that the formula is multiplied or divided by.
                    // Where all is constant, any mistake makes a factor: one with sums and functions says nothing.
                    let is_number = arena.as_number(factor).is_some();
                    let found = self.mistake_in_abbreviations(printed, derived, Search::Values);
                    let found = found.filter(|mistake| !mistake.abbreviations.is_empty());
                    let mistake = if is_involved && found.is_none() && !is_number {
                        self.changed(printed, derived, Search::Values)
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

    /// Remark that the units of a printed value convict it; `None` if they fit.
    fn units(&self, printed: Expr, derived: Expr) -> Option<String> {
        let (model, arena) = (self.quantities.model, &self.quantities.derivations.kinematics.arena);
        let has_parameters = |e: Expr| model.parameters.iter().any(|p| arena.mentions(e, p.symbol));
        if !has_parameters(printed) && has_parameters(derived) {
            // Numbers stand for parameters.
            return None;
        }
        match (model.checked_unit_of(arena, printed), model.checked_unit_of(arena, derived)) {
            (Err(message), _) => Some(format!("units alone show it: {message}")),
            (Ok(Some(own)), Ok(Some(right))) if own != right => {
                Some(format!("units alone show it: it is in {}, and should be in {}", own.words(), right.words()))
            }
            _ => None,
        }
    }

    /// Mistake in a printed value: the wrong term of a sum, the smallest change that makes the formula right, all wrong
    /// terms of a sum, or the whole values if they are short.
    pub fn mistake(&mut self, printed: Printed, derived: Expr, difference: Expr) -> Mistake {
        if let Some(mistake) = self.mistake_in_abbreviations(printed, derived, Search::Values) {
            return mistake;
        }
        let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
        let terms = wrong_terms(arena, simplifier, printed.value, difference);
        let words: Vec<String> = terms.iter().map(|term| term.words(arena)).collect();
        let slip = if let [term] = *terms.as_slice() { Some(term.slip(arena)) } else { None };
        match *terms.as_slice() {
            [WrongTerm::Extra(own)] => return Mistake::of_one(words, (own, Expr::ZERO), slip),
            [WrongTerm::Other(own, right)] => return Mistake::of_one(words, (own, right), slip),
            _ => {}
        }
        if let Some(mistake) = self.changed(printed, derived, Search::Values) {
            return mistake;
        }
        let (model, arena) = (self.quantities.model, &self.quantities.derivations.kinematics.arena);
        let has_units = |term: &WrongTerm| term.parts().all(|e| model.checked_unit_of(arena, e).is_ok());
        let is_listed = !words.is_empty()
            && words.iter().map(String::len).sum::<usize>() <= LONGEST_LIST
            && terms.iter().all(has_units);
        if !is_listed && let Some(words) = self.two_mistakes(printed, derived) {
            return Mistake { words, ..Mistake::default() };
        }
        let arena = &self.quantities.derivations.kinematics.arena;
        if let [WrongTerm::Extra(own), WrongTerm::Missing(right)] | [WrongTerm::Missing(right), WrongTerm::Extra(own)] =
            *terms.as_slice()
        {
            let words = WrongTerm::Other(own, right).words(arena);
            return Mistake::of_one(vec![words], (own, right), slip);
        }
        let [before, after] = [printed.value, derived].map(|e| text(arena, e));
        let is_long = before.len() > LONGEST || after.len() > LONGEST;
        let is_each_printed = !terms.is_empty() && terms.iter().all(|term| !matches!(term, WrongTerm::Missing(_)));
        if is_long || is_each_printed {
            return Mistake { words, change: None, slip, abbreviations: Vec::new() };
        }
        Mistake::of_one(vec![format!("{before} should be {after}")], (printed.value, derived), slip)
    }

    /// Slip that is the whole mistake of a printed value, also in an abbreviation; `None` if there is no such slip.
    pub fn slip(&mut self, printed: Printed, derived: Expr) -> Option<Mistake> {
        let found = self.mistake_in_abbreviations(printed, derived, Search::Slips);
        found.or_else(|| self.changed(printed, derived, Search::Slips))
    }

    /// One change of a printed value, with its abbreviations written out, that makes it right; `None` if there is none.
    fn changed(&mut self, printed: Printed, derived: Expr, search: Search) -> Option<Mistake> {
        let Repair { words, parts, slip, .. } =
            self.with_tools(printed, |tools, formula, _| repair(tools, formula, derived, search))?;
        Some(Mistake { words: vec![words], change: parts, slip: Some(slip), abbreviations: Vec::new() })
    }

    /// Mistake of a formula that uses abbreviations, found with the abbreviations as symbols; `None` if there are none,
    /// or if no mistake is found.
    fn mistake_in_abbreviations(&mut self, printed: Printed, derived: Expr, search: Search) -> Option<Mistake> {
        let found = self.with_tools(printed, |tools, _, book| book.mistake(tools, printed.raw, derived, search))?;
        Some(Mistake { words: found.words, change: found.parts, slip: found.slip, abbreviations: found.abbreviations })
    }

    /// Descriptions of two mistakes that are all of a formula's, with abbreviations as symbols if they are found so.
    fn two_mistakes(&mut self, printed: Printed, derived: Expr) -> Option<Vec<String>> {
        self.with_tools(printed, |tools, formula, book| {
            if let Some(found) = book.two_mistakes(tools, printed.raw, derived) {
                return Some(found.words);
            }
            pair(tools, formula, derived).map(|both| both.map(|one| one.words).into())
        })
    }

    /// Searches for repairs of a formula, with abbreviations written out, or with those of the book. Near a point, the
    /// changed formula is expanded before it is compared.
    fn with_tools<T>(
        &mut self,
        printed: Printed,
        search: impl FnOnce(&mut Tools<'_, '_>, &mut Formula, &mut Book) -> Option<T>,
    ) -> Option<T> {
        let (names, reading, near) = (self.names, printed.reading, &mut self.near);
        let mut rewriting = |quantities: &mut Quantities<'_>, e: Expr| {
            let value = reading.value(quantities, names, e)?;
            near.as_mut().map_or(Ok(value), |near| near.formula(quantities, value))
        };
        let mut formula = Formula::plain(&self.quantities.derivations.kinematics.arena, printed.raw);
        let (quantities, comparer) = (&mut *self.quantities, &mut *self.comparer);
        let mut tools = Tools { quantities, comparer, rewriting: &mut rewriting, left: self.changes_left };
        search(&mut tools, &mut formula, self.book)
    }

    /// Shortest form of a term that is equal in permitted states.
    fn shortened(&mut self, e: Expr) -> Expr {
        let mut short = e;
        // The shortened term may contain more sums that can be shortened.
        for _ in 0..MOST_ROUNDS {
            let arena = &mut self.quantities.derivations.kinematics.arena;
            let next = self.comparer.permitted().shortened(arena, short);
            if next == short {
                break;
            }
            short = self.simplify(next);
        }
        short
    }

    /// Simplified form of a term.
    pub fn simplify(&mut self, e: Expr) -> Expr {
        let kinematics = &mut self.quantities.derivations.kinematics;
        kinematics.simplifier.simplify(&mut kinematics.arena, e)
    }
}
