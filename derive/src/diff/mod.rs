//! A published derivation compared with the derived one, entry by entry, and what its errors do to the motion.
//!
//! Every entry is judged on its own: symbols of the text stand for what is derived, so an error counts once, where it
//! is made. Nothing is repaired or guessed; the only freedom is the factor that each row of a linear system may carry.

mod consequences;
mod declared;
mod entries;
mod finding;
mod initial;
mod models;
pub mod motion;
mod printed;
mod row_text;
pub mod rows;
mod scenes;
mod systems;
mod terms;
mod transfer;

pub use consequences::{Agreement, Consequences, Rate};
pub use declared::{Declaration, Edit, Property, Section};
pub use finding::{Finding, Judgement};
pub use models::{Change, Derived, ModelDifference, diff_models};
pub use printed::printed_equations;
pub use scenes::{Setting, diff_scenes};

use crate::algebra::compare::Comparer;
use crate::mechanics::{Derivations, Quantities};
use crate::model::Model;
use crate::prove::Proof;
use crate::report::{EntryKind, Names, Report};
use motion::Motion;

/// A report, judged.
#[derive(Clone, Debug)]
pub struct Difference {
    /// Every entry in the order of the file; rows and single entries of systems after one another.
    pub findings: Vec<Finding>,
    /// What each printed system makes of the motion.
    pub consequences: Vec<Consequences>,
    /// Whether the printed systems give the same motion.
    pub agreements: Vec<Agreement>,
}

impl Difference {
    /// How many findings have this word.
    #[must_use]
    pub fn count(&self, word: &str) -> usize {
        self.findings.iter().filter(|f| f.judgement.word() == word).count()
    }

    /// Whether nothing is different and nothing undecided.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        self.count("different") == 0 && self.count("undecided") == 0
    }
}

/// Judges every entry of a report.
pub fn diff(model: &Model, derivations: &mut Derivations, report: &Report, proof: &Proof) -> Difference {
    let mut comparer = Comparer::default();
    let mut findings = Vec::new();
    let mut motions: Vec<(Motion, systems::Matched)> = Vec::new();
    let mut quantities = Quantities::new(model, derivations);
    let names = Names::new(report, &mut quantities);
    for entry in &report.entries {
        let first = findings.len();
        match &entry.kind {
            EntryKind::Definition { text } => {
                findings.push(Finding::new(&entry.id, &entry.section, Judgement::Stated, text));
            }
            EntryKind::Equation { quantity, printed, text } => {
                let finding = Finding::new(&entry.id, &entry.section, Judgement::Stated, text);
                let mut judge = entries::Judge { quantities: &mut quantities, comparer: &mut comparer, names: &names };
                findings.push(judge.equation(finding, quantity, *printed));
            }
            EntryKind::System(system) => {
                let mut judge = entries::Judge { quantities: &mut quantities, comparer: &mut comparer, names: &names };
                let judged = judge.system(entry, system);
                findings.extend(judged.findings);
                motions.extend(judged.motion);
            }
            EntryKind::Listing(listing) => {
                let mut judge = entries::Judge { quantities: &mut quantities, comparer: &mut comparer, names: &names };
                let judged = judge.listing(entry, listing);
                findings.extend(judged.findings);
                motions.extend(judged.motion);
            }
            EntryKind::Initial(_) => findings.push(initial::judge(model, report, entry)),
        }
        // Of a system or listing the first row carries what holds for all of it.
        if let Some(finding) = findings.get_mut(first) {
            finding.remarks.extend(entry.repaired.iter().map(|text| format!("scan: {text}")));
            finding.remarks.extend(entry.note.clone());
        }
    }
    let (consequences, agreements) = consequences::draw(model, derivations, &mut comparer, proof, &motions);
    Difference { findings, consequences, agreements }
}

/// The printed systems and listings of a report as equations of motion.
pub fn motions(model: &Model, derivations: &mut Derivations, report: &Report) -> Vec<Motion> {
    let mut quantities = Quantities::new(model, derivations);
    let names = Names::new(report, &mut quantities);
    let mut list = Vec::new();
    for entry in &report.entries {
        match &entry.kind {
            EntryKind::System(system) => list.extend(systems::system_motion(&mut quantities, &names, entry, system)),
            EntryKind::Listing(listing) => {
                if let Ok((motion, true)) = systems::listing_motion(&mut quantities, &names, entry, listing) {
                    list.push(motion);
                }
            }
            _ => {}
        }
    }
    list
}
