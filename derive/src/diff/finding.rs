//! One entry of a publication, judged.

use crate::algebra::Expr;
use crate::algebra::compare::{Verdict, Witness};
use crate::algebra::permitted::Holds;

/// How a printed entry stands to what is derived.
#[derive(Clone, Debug, PartialEq)]
pub enum Judgement {
    /// Equal in meaning.
    Equal,
    /// Equal but for a factor.
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
    /// Where printed and derived are equal, if they are.
    pub holds: Holds,
    /// What is printed, as transcribed.
    pub printed: String,
    /// What is derived; for scaled entries times the factor.
    pub derived: Option<Expr>,
    /// printed = factor · derived; for different entries only where that holds exactly.
    pub factor: Option<Expr>,
    /// printed − derived, in its shortest form.
    pub difference: Option<Expr>,
    /// What is wrong, in words: terms with what they should be, and in rows the entries; where it is short.
    pub wrong: Option<String>,
    /// A state where printed and derived differ.
    pub witness: Option<Witness>,
    /// What else is to be said: which row it was matched with, what the scan garbled.
    pub remarks: Vec<String>,
}

impl Finding {
    /// An entry of which nothing more is known yet.
    pub(super) fn new(id: &str, section: &str, judgement: Judgement, printed: &str) -> Self {
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

    /// With the terms that are wrong, if they are known.
    pub(super) fn name_terms(&mut self, terms: Vec<String>) {
        self.wrong = (!terms.is_empty()).then(|| terms.join("; "));
        self.remarks.extend(terms);
    }

    /// With the answer of a comparison.
    pub(super) fn judged(mut self, (verdict, holds): (Verdict, Holds), derived: Expr) -> Self {
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
