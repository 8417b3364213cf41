//! Finding: one entry of a publication with its judgement.

use crate::algebra::Expr;
use crate::algebra::meaning::compare::{Verdict, Witness};
use crate::algebra::meaning::permitted::Holds;

/// Judgement of a printed entry against the derived value.
#[derive(Clone, Debug, PartialEq)]
pub enum Judgement {
    /// The entry is equal in meaning to the derived value.
    Equal,
    /// The entry is equal to the derived value up to a factor.
    Scaled,
    /// The entry differs in meaning from the derived value.
    Different,
    /// The equality is not decided, with the reason.
    Undecided(String),
    /// The entry is a definition or number of the text, which no derived value can contradict.
    Stated,
}

impl Judgement {
    /// Word for the judgement in tables and JSON.
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

/// One entry of a publication with its judgement.
#[derive(Clone, Debug)]
pub struct Finding {
    /// Id of the entry in the publication file.
    pub id: String,
    /// Section of the publication that contains the entry.
    pub section: String,
    /// Judgement of the entry.
    pub judgement: Judgement,
    /// Region in which the printed and the derived value are equal, if they are.
    pub holds: Holds,
    /// Printed text of the entry, as transcribed.
    pub printed: String,
    /// Derived value; for scaled entries it is multiplied by the factor.
    pub derived: Option<Expr>,
    /// Factor with printed = factor · derived. For different entries, `Some` only if this holds exactly.
    pub factor: Option<Expr>,
    /// Difference printed − derived, simplified.
    pub difference: Option<Expr>,
    /// Description of the mistake, in words: wrong terms with their right values, and wrong entries of rows. `None` if
    /// it would be long.
    pub wrong: Option<String>,
    /// State in which the printed and the derived value differ.
    pub witness: Option<Witness>,
    /// Further remarks, such as the matched row or the garbled part of the scan.
    pub remarks: Vec<String>,
}

impl Finding {
    /// Finding of an entry with this judgement and no further data.
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

    /// Formulas of the finding that documents show.
    pub fn shown(&self) -> impl Iterator<Item = Expr> {
        [self.derived, self.factor, self.difference].into_iter().flatten()
    }

    /// Adds descriptions of the wrong terms, if there are any.
    pub(in crate::diff) fn name_terms(&mut self, terms: Vec<String>) {
        self.wrong = (!terms.is_empty()).then(|| terms.join("; "));
        self.remarks.extend(terms);
    }

    /// Adds the verdict of a comparison with the derived value.
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
