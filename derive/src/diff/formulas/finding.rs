//! One entry of a publication, judged.

use crate::algebra::Expr;
use crate::algebra::meaning::compare::{Verdict, Witness};
use crate::algebra::meaning::permitted::Holds;

/// Relation of a printed entry to the derived value.
#[derive(Clone, Debug, PartialEq)]
pub enum Judgement {
    /// Equal in meaning.
    Equal,
    /// Equal up to a factor.
    Scaled,
    /// Different in meaning.
    Different,
    /// Undecided, with the reason.
    Undecided(String),
    /// A definition or number of the text, which nothing can contradict.
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
    /// The verdict.
    pub judgement: Judgement,
    /// Region where printed and derived are equal, if they are.
    pub holds: Holds,
    /// The printed text, as transcribed.
    pub printed: String,
    /// The derived value; for scaled entries times the factor.
    pub derived: Option<Expr>,
    /// printed = factor · derived; for different entries only where that holds exactly.
    pub factor: Option<Expr>,
    /// printed − derived, in its shortest form.
    pub difference: Option<Expr>,
    /// Description of the mistake, in words: wrong terms with their right values, and in rows the entries. `None` if it
    /// would be long.
    pub wrong: Option<String>,
    /// A state where printed and derived differ.
    pub witness: Option<Witness>,
    /// Further remarks: the row it was matched with, the garbled part of the scan.
    pub remarks: Vec<String>,
}

impl Finding {
    /// An entry that is not judged further yet.
    pub(in crate::diff) fn new(id: &str, section: &str, judgement: Judgement, printed: &str) -> Self {
        Self {
            id: id.to_owned(),
            section: section.to_owned(),
            judgement,
            holds: Holds::EVERYWHERE,
            printed: printed.to_owned(),
            derived: None,
            factor: None,
            difference: None,
            wrong: None,
            witness: None,
            remarks: Vec::new(),
        }
    }

    /// Every formula that is shown of it.
    pub fn shown(&self) -> impl Iterator<Item = Expr> {
        [self.derived, self.factor, self.difference].into_iter().flatten()
    }

    /// Adds the wrong terms, if they are known.
    pub(in crate::diff) fn name_terms(&mut self, terms: Vec<String>) {
        self.wrong = (!terms.is_empty()).then(|| terms.join("; "));
        self.remarks.extend(terms);
    }

    /// Adds the verdict of a comparison.
    pub(in crate::diff) fn judged(mut self, (verdict, holds): (Verdict, Holds), derived: Expr) -> Self {
        self.derived = Some(derived);
        self.holds = holds;
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
