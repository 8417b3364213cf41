//! A published derivation compared with the derived one, entry by entry, and what its errors do to the motion.
//!
//! Every entry is judged on its own: symbols of the text stand for what is derived, so an error counts once, where it
//! is made. Nothing is repaired or guessed; the only freedom is the factor that each row of a linear system may carry.

mod consequences;
mod declared;
mod entries;
mod initial;
mod models;
pub mod motion;
mod printed;
pub mod rows;
mod scenes;
mod systems;
mod transfer;

pub use consequences::{Agreement, Consequences, Rate};
pub use declared::{Declaration, Edit, Property, Section};
pub use models::{Change, Derived, ModelDifference, diff_models};
pub use printed::printed_equations;
pub use scenes::{Setting, diff_scenes};

use crate::algebra::Expr;
use crate::algebra::compare::{Comparer, Verdict, Witness};
use crate::mechanics::{Derivations, Quantities};
use crate::model::Model;
use crate::prove::Proof;
use crate::report::{EntryKind, Names, Report};
use motion::Motion;

/// How a printed entry stands to what is derived.
#[derive(Clone, Debug, PartialEq)]
pub enum Judgement {
    /// The same.
    Equal,
    /// The same but for a factor.
    Scaled,
    /// Not the same.
    Different,
    /// Not known, and why.
    Undecided(String),
    /// Stated: nothing can contradict it.
    Stated,
}

impl Judgement {
    /// The word in tables and JSON.
    #[must_use]
    pub const fn word(&self) -> &'static str {
        match self {
            Self::Equal => "equal",
            Self::Scaled => "scaled",
            Self::Different => "different",
            Self::Undecided(_) => "undecided",
            Self::Stated => "stated",
        }
    }
}

/// One entry, judged.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The entry's id.
    pub id: String,
    /// The section it stands in.
    pub section: String,
    /// The answer.
    pub judgement: Judgement,
    /// What is printed, as transcribed.
    pub printed: String,
    /// What is derived; for scaled entries times the factor.
    pub derived: Option<Expr>,
    /// printed = factor · derived; for different entries only where that holds exactly.
    pub factor: Option<Expr>,
    /// printed − derived, in its shortest form.
    pub difference: Option<Expr>,
    /// A state where printed and derived differ.
    pub witness: Option<Witness>,
    /// What else is to be said: which row it was matched with, what the scan garbled.
    pub remarks: Vec<String>,
}

impl Finding {
    fn new(id: &str, section: &str, judgement: Judgement, printed: &str) -> Self {
        Self {
            id: id.to_owned(),
            section: section.to_owned(),
            judgement,
            printed: printed.to_owned(),
            derived: None,
            factor: None,
            difference: None,
            witness: None,
            remarks: Vec::new(),
        }
    }

    fn judged(mut self, verdict: Verdict, derived: Expr) -> Self {
        self.derived = Some(derived);
        match verdict {
            Verdict::Equal(_) => self.judgement = Judgement::Equal,
            Verdict::Different(witness) => {
                self.judgement = Judgement::Different;
                self.witness = Some(witness);
            }
            Verdict::Undecided(why) => self.judgement = Judgement::Undecided(why),
        }
        self
    }
}

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
