//! Finding: one entry of a publication with its judgement.

use crate::algebra::Expr;
use crate::algebra::meaning::compare::{Verdict, Witness};
use crate::algebra::meaning::permitted::Holds;
use crate::diff::equations::claim::Claim;
use crate::diff::repairs::Slip;

/// Remark on an entry that is equal to the digits printed only.
pub(in crate::diff) const ROUNDED: &str =
    "to the digits printed, with the numbers of the parameters, and 0 for inputs without one";

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

impl Finding {
    /// Finding of an entry that is equal up to a difference that does not count, with a remark on it.
    pub(in crate::diff) fn accepted(self, up_to: &'static str, remark: String) -> Self {
        Self {
            judgement: Judgement::Equal,
            up_to: Some(up_to),
            // Remarks on units and terms are about a difference.
            remarks: vec![remark],
            difference: None,
            wrong: None,
            change: None,
            slip: None,
            abbreviations: Vec::new(),
            places: Vec::new(),
            witness: None,
            factor: None,
            ..self
        }
    }
}

/// Mistake in a printed formula.
#[derive(Clone, Debug, Default)]
pub(in crate::diff) struct Mistake {
    /// Descriptions of the wrong parts; empty if none is short.
    pub(in crate::diff) words: Vec<String>,
    /// Wrong part, and the right part in its place, if this is the whole mistake.
    pub(in crate::diff) change: Option<(Expr, Expr)>,
    /// Kind of the mistake, if there is one alone.
    pub(in crate::diff) slip: Option<Slip>,
    /// Names of the abbreviations in whose formulas the mistakes are, if these are the whole mistake.
    pub(in crate::diff) abbreviations: Vec<String>,
}

impl Mistake {
    /// Mistake of one part, with the right part in its place.
    pub(in crate::diff) fn of_one(words: Vec<String>, change: (Expr, Expr), slip: Option<Slip>) -> Self {
        Self { words, change: Some(change), slip, ..Self::default() }
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
    /// Difference that an equal entry may have, in words, such as "up to a constant"; `None` for an exact equality.
    pub up_to: Option<&'static str>,
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
    /// Wrong part of the printed formula, and the right part in its place, if this is the whole mistake.
    pub change: Option<(Expr, Expr)>,
    /// Kind of the mistake, if there is one alone.
    pub slip: Option<Slip>,
    /// Names of the abbreviations in whose formulas the mistakes are, if these are the whole mistake.
    pub abbreviations: Vec<String>,
    /// Places of the mistakes in a row, such as "the right-hand side"; empty for other entries.
    pub places: Vec<String>,
    /// State in which the printed and the derived value differ.
    pub witness: Option<Witness>,
    /// Further remarks, such as the matched row or the garbled part of the scan.
    pub remarks: Vec<String>,
}

/// A finding with the claim of its entry, by which wrong entries are traced to others.
pub(in crate::diff) struct TracedFinding {
    pub(in crate::diff) finding: Finding,
    pub(in crate::diff) claim: Claim,
}

impl Finding {
    /// The finding with the claim of its entry.
    pub(in crate::diff) fn with_claim(self, claim: Claim) -> TracedFinding {
        TracedFinding { finding: self, claim }
    }

    /// Finding of an entry with this judgement and no further data.
    pub(in crate::diff) fn new(id: &str, section: &str, judgement: Judgement, printed: &str) -> Self {
        Self {
            id: id.to_owned(),
            section: section.to_owned(),
            judgement,
            holds: Holds::EVERYWHERE,
            up_to: None,
            printed: printed.to_owned(),
            derived: None,
            factor: None,
            difference: None,
            wrong: None,
            change: None,
            slip: None,
            abbreviations: Vec::new(),
            places: Vec::new(),
            witness: None,
            remarks: Vec::new(),
        }
    }

    /// Formulas of the finding that documents show.
    pub fn shown(&self) -> impl Iterator<Item = Expr> {
        [self.derived, self.factor, self.difference].into_iter().flatten()
    }

    /// Adds the description of the mistake, if there is one.
    pub(in crate::diff) fn name_mistake(&mut self, mistake: Mistake) {
        let Mistake { words, change, slip, abbreviations } = mistake;
        (self.slip, self.abbreviations) = (slip, abbreviations);
        self.wrong = (!words.is_empty()).then(|| words.join("; "));
        self.remarks.extend(words);
        self.change = change;
    }

    /// Adds the verdict of a comparison with the derived value.
    pub(in crate::diff) fn judged(mut self, verdict: Verdict, holds: Holds, derived: Expr) -> Self {
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
