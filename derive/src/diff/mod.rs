//! Comparison of a published derivation with the derived equations, entry by entry, and the effect of its errors on the
//! motion.
//!
//! Every entry is judged on its own: symbols of the publication stand for derived values, so that an error counts once,
//! in the entry where it is made. Nothing is repaired or guessed. The only free quantity is the factor of each row of a
//! linear system.

mod coordinate_search;
mod edits;
pub mod equations;
mod formulas;
pub mod grade;
mod permitted_states;
pub mod printed;
mod repairs;
mod roots;

pub use coordinate_search::{CoordinateSearch, CoordinateTable, find_coordinates};
pub use edits::declaration_changes::{Declaration, DeclaredProperty, Edit, Section};
pub use edits::derived_model::DerivedModel;
pub use edits::model_changes::{EntryChange, ModelDifference, diff_models};
pub use edits::scene_changes::{SettingChange, diff_scenes};
pub use edits::variable_changes::{VariableChange, VariableKind};
pub use formulas::finding::{Finding, Judgement};
pub use printed::consequences::{Agreement, Consequences, IntegralRate};
pub use printed::printed_equations::printed_equations;
pub use repairs::MistakeKind;
pub use roots::{DependenceKind, DependentEntry, RootMistake};

use crate::algebra::Expr;
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::text::definitions::define_names_in_part;
use crate::algebra::text::print::print_text;
use crate::mechanics::{Derivations, Kinematics, Quantities};
use crate::model::Model;
use crate::prove::Proof;
use crate::publication::{EntryKind, Publication, QuantityNames};
use equations::claim::Claim;
use equations::lagrange_multipliers::Multipliers;
use equations::matched_system::MatchedSystem;
use equations::row_judgement::TermTools;
use formulas::expansion_near_point::PointExpansion;
use formulas::finding::TracedFinding;
use printed::motion_system::MotionSystem;

/// Result of the comparison of a publication with the derived equations.
#[derive(Clone, Debug)]
pub struct Difference {
    /// Findings on all printed entries, in the order of the publication file. Rows and entries of a system are listed
    /// one after another.
    pub findings: Vec<Finding>,
    /// Root mistakes that cause the findings judged "different". Each such finding belongs to exactly one root mistake.
    pub roots: Vec<RootMistake>,
    /// Consequences of each printed system's errors for the motion.
    pub consequences: Vec<Consequences>,
    /// Comparisons of the motions that two printed systems predict, for each pair of systems.
    pub agreements: Vec<Agreement>,
}

impl Difference {
    /// Number of findings with the judgement `word`, such as "different" or "undecided".
    #[must_use]
    pub fn count(&self, word: &str) -> usize {
        self.findings.iter().filter(|f| f.judgement.word() == word).count()
    }

    /// Formulas in findings and consequences that documents show. Formulas in remarks are not included, since remarks
    /// are text.
    #[must_use]
    pub fn shown_formulas(&self) -> Vec<Expr> {
        let findings = self.findings.iter().flat_map(Finding::shown_formulas);
        findings.chain(self.consequences.iter().flat_map(Consequences::shown_formulas)).collect()
    }

    /// Gives a written name to each named term that the proof and the verdicts show, for use in all
    /// documents.
    pub fn write_names(&self, proof: &Proof, derivations: &mut Derivations) {
        proof.write_names(derivations);
        define_names_in_part(&mut derivations.kinematics.arena, "diff", &self.shown_formulas());
    }

    /// True if every finding is right or only stated, so that none is "different" or "undecided".
    #[must_use]
    pub fn is_clean(&self) -> bool {
        self.count("different") == 0 && self.count("undecided") == 0
    }
}

/// Judges every entry of a publication against the derived equations of the model.
/// `proof` is the proof that the formulations agree. If mistakes in abbreviations or the author's
/// multipliers become known, all entries are judged a second time.
pub fn judge_publication(
    model: &Model,
    derivations: &mut Derivations,
    publication: &Publication,
    proof: &Proof,
) -> Difference {
    let mut quantities = Quantities::new(model, derivations);
    let permitted = permitted_states::permitted_states(&mut quantities);
    let comparer = Comparer::in_permitted_states(permitted.clone());
    let names = QuantityNames::new(publication, &mut quantities);
    let numbers = parameter_numbers(model, &mut quantities, publication);
    let mut book = repairs::AbbreviationMistakes::new(&publication.shorthand);
    let mut tools = JudgementTools { quantities, comparer, names, numbers };
    let mut multipliers = Multipliers::default();
    let mut found = judge_entries(model, publication, &mut tools, &mut book, &mut multipliers);
    let Kinematics { arena, simplifier, .. } = &mut tools.quantities.derivations.kinematics;
    let mut terms = TermTools { arena, simplifier, comparer: &mut tools.comparer };
    if book.accept_suspected_corrections() | multipliers.choose_multiplier_matrix(&mut terms, model) {
        // All mistakes in abbreviations, and the author's multipliers, are known now.
        found = judge_entries(model, publication, &mut tools, &mut book, &mut multipliers);
    }
    let JudgementTools { mut quantities, mut comparer, .. } = tools;
    let JudgedEntries { findings, claims, tables, motions } = found;
    let swapped = formulas::swapped_lists::swapped_lists(model, publication);
    let roots =
        roots::find_root_mistakes(&mut quantities, &permitted, &findings, &claims, &tables, &swapped, publication);
    let (consequences, agreements) =
        printed::consequences::find_consequences(model, derivations, &mut comparer, proof, &motions);
    Difference { findings, roots, consequences, agreements }
}

/// Tools for the verdicts on a publication: derived quantities, the comparer, names and numbers.
struct JudgementTools<'a> {
    quantities: Quantities<'a>,
    /// Comparer of terms in permitted states: states that satisfy the model's constraints and
    /// domain.
    comparer: Comparer,
    /// Derived values of the symbols that the publication uses.
    names: QuantityNames,
    /// Parameters with numerical values, for statements about initial numbers and multipliers.
    numbers: Vec<(Expr, Expr)>,
}

/// Judges the entries of a publication one after another. Returns their findings, their claims (statements as data, for
/// tracing mistakes), matched systems and motions.
fn judge_entries(
    model: &Model,
    publication: &Publication,
    tools: &mut JudgementTools<'_>,
    book: &mut repairs::AbbreviationMistakes,
    multipliers: &mut Multipliers,
) -> JudgedEntries {
    let JudgementTools { quantities, comparer, names, numbers } = tools;
    let mut anywhere = Comparer::default();
    let mut changes_left = repairs::MOST_CHANGES;
    let mut found = JudgedEntries::default();
    let other_meanings = other_meanings(quantities, publication);
    for entry in &publication.entries {
        let first = found.findings.len();
        let earlier = found.tables.as_slice();
        let near = entry.near.as_ref().map(|near| PointExpansion::new(quantities, near));
        let words = near.as_ref().map(|near| near.words.clone());
        // A formula that is printed up to an order near a point is compared in all states, not only in permitted
        // states.
        let comparer = if near.is_some() { &mut anywhere } else { &mut *comparer };
        let mut judge = formulas::entry_judge::EntryJudge {
            quantities: &mut *quantities,
            comparer,
            names,
            earlier,
            near,
            changes_left: &mut changes_left,
            book: &mut *book,
            multipliers: &mut *multipliers,
            numbers,
        };
        match &entry.kind {
            EntryKind::Definition { text } => {
                let finding = Finding::new(&entry.id, &entry.section, Judgement::Stated, text);
                found.push(finding.with_claim(Claim::Other));
            }
            EntryKind::Equation { quantity, printed, text } => {
                let finding = Finding::new(&entry.id, &entry.section, Judgement::Stated, text);
                found.push(judge.judge_equation(finding, quantity, *printed));
            }
            EntryKind::System(system) => found.add_judged_system(judge.judge_system(entry, system)),
            EntryKind::Listing(listing) => found.add_judged_system(judge.judge_listing(entry, listing)),
            EntryKind::Initial(_) => {
                found.push(formulas::printed_numbers::judge_printed_number(model, publication, entry));
            }
        }
        for finding in found.findings[first..].iter_mut().filter(|finding| finding.wrong.is_some()) {
            finding.remarks.extend(other_meanings.iter().cloned());
        }
        // The first row of a system or listing also carries the remarks about the whole system.
        if let Some(finding) = found.findings.get_mut(first) {
            finding.remarks.extend(words);
            finding.remarks.extend(entry.repaired.iter().map(|text| format!("scan: {text}")));
            finding.remarks.extend(entry.note.clone());
        }
    }
    found
}

/// Remarks on names to which the publication gives another meaning than the model. Verdicts use the meaning of the
/// model.
fn other_meanings(quantities: &Quantities<'_>, publication: &Publication) -> Vec<String> {
    let arena = &quantities.derivations.kinematics.arena;
    let remark = |(name, value): &(String, Expr)| {
        format!("{name} stands for the model's {name} here; the printed {name} is {}", print_text(arena, *value))
    };
    publication.redefined.iter().map(remark).collect()
}

/// Pairs of a parameter and its number: the number of the publication if stated, else that of the model. Inputs without
/// a number get 0.
fn parameter_numbers(model: &Model, quantities: &mut Quantities<'_>, publication: &Publication) -> Vec<(Expr, Expr)> {
    let arena = &mut quantities.derivations.kinematics.arena;
    let stated = publication.entries.iter().filter_map(|entry| match &entry.kind {
        EntryKind::Initial(initial) => Some((initial.quantity, initial.value)),
        _ => None,
    });
    let stated: Vec<(Expr, Expr)> = stated.collect();
    let mut list = Vec::new();
    for p in &model.parameters {
        let own = stated.iter().find(|(symbol, _)| *symbol == p.symbol).map(|(_, value)| *value);
        let value = own.or_else(|| p.value.as_ref().map(|value| arena.number(value.clone())));
        let value = value.or(p.is_input.then_some(Expr::ZERO));
        list.extend(value.map(|value| (p.symbol, value)));
    }
    list
}

/// Results for the entries of a publication, collected in the order of its entries.
#[derive(Default)]
struct JudgedEntries {
    findings: Vec<Finding>,
    /// Claims of the findings (statements as data): the claim at index i belongs to the finding at
    /// index i.
    claims: Vec<Claim>,
    /// Printed systems matched with derived rows, for the tracing of mistakes.
    tables: Vec<MatchedSystem>,
    /// Motions of the printed systems, for consequences.
    motions: Vec<printed::judged_system::MatchedMotion>,
}

impl JudgedEntries {
    /// Adds the finding of one entry, with its claim (the entry's statement as data).
    fn push(&mut self, found: TracedFinding) {
        self.findings.push(found.finding);
        self.claims.push(found.claim);
    }

    /// Adds the findings, the matched rows and the motion of a judged system or program (listing).
    fn add_judged_system(&mut self, judged: printed::judged_system::JudgedSystem) {
        judged.findings.into_iter().for_each(|found| self.push(found));
        self.tables.extend(judged.table);
        self.motions.extend(judged.motion);
    }
}

/// Printed systems and programs (listings) of a publication as equations of motion. Entries that hold only near a
/// point, and programs without a complete motion, are left out.
pub fn printed_motions(model: &Model, derivations: &mut Derivations, publication: &Publication) -> Vec<MotionSystem> {
    let mut quantities = Quantities::new(model, derivations);
    let names = QuantityNames::new(publication, &mut quantities);
    let mut list = Vec::new();
    // An entry that holds near a point is no equation of the whole motion.
    for entry in publication.entries.iter().filter(|entry| entry.near.is_none()) {
        match &entry.kind {
            EntryKind::System(system) => {
                list.extend(printed::judged_system::motion_of_system(&mut quantities, &names, entry, system));
            }
            EntryKind::Listing(listing) => {
                if let Ok((motion, true)) = printed::listings::listing_motion(&mut quantities, &names, entry, listing) {
                    list.push(motion);
                }
            }
            _ => {}
        }
    }
    list
}
