//! Finding: the judgement of a printed entry, with the data that explain it.

use crate::algebra::Expr;
use crate::algebra::meaning::compare::{Verdict, Witness};
use crate::algebra::meaning::permitted_states::StatesOfValidity;
use crate::diff::equations::claim::Claim;
use crate::diff::equations::row_judgement::{RowJudgement, RowMatchResult};
use crate::diff::repairs::MistakeKind;
use crate::mechanics::RowName;
use crate::publication::Entry;

/// Remark on an entry that equals the derived value only to the digits printed.
pub(in crate::diff) const ROUNDED: &str =
    "to the digits printed, with the numbers of the parameters, and 0 for inputs without one";

/// Judgement of a printed entry against the derived value.
#[derive(Clone, Debug, PartialEq)]
pub enum Judgement {
    /// The printed entry equals the derived value.
    Equal,
    /// The printed entry equals the derived value times a factor.
    Scaled,
    /// The printed entry differs from the derived value.
    Different,
    /// Neither equality nor difference is proved, for the given reason.
    Undecided(String),
    /// The entry is a definition or a number of the text, which no derived value can contradict.
    Stated,
}

impl Judgement {
    /// Word for the judgement in tables and JSON, such as "scaled".
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
    /// Changes the judgement to "equal" for an entry whose remaining difference is allowed. `up_to` names this
    /// difference, and `remark` is added.
    pub(in crate::diff) fn accept_with_remark(self, up_to: &'static str, remark: String) -> Self {
        Self {
            judgement: Judgement::Equal,
            up_to: Some(up_to),
            // The earlier remarks on units and terms describe the difference, so that they are dropped.
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

/// Mistake in a printed formula: its description, the change that repairs it, and its kind.
#[derive(Clone, Debug, Default)]
pub(in crate::diff) struct Mistake {
    /// Descriptions of the wrong parts; empty if no description is short.
    pub(in crate::diff) words: Vec<String>,
    /// Wrong part with the right part; `None` unless this change is the whole mistake.
    pub(in crate::diff) change: Option<(Expr, Expr)>,
    /// Kind of the mistake; `None` unless there is exactly one mistake of a known kind.
    pub(in crate::diff) slip: Option<MistakeKind>,
    /// Names of the wrong abbreviations; empty unless their formulas contain all mistakes.
    pub(in crate::diff) abbreviations: Vec<String>,
}

impl Mistake {
    /// Creates the mistake in a single part. `change` is the wrong part with the right part.
    pub(in crate::diff) fn of_single_part(words: Vec<String>, change: (Expr, Expr), slip: Option<MistakeKind>) -> Self {
        Self { words, change: Some(change), slip, ..Self::default() }
    }
}

/// Judgement of one printed entry, with the data that explain it.
#[derive(Clone, Debug)]
pub struct Finding {
    /// Id of the entry in the publication file.
    pub id: String,
    /// Section or page of the publication that contains the entry.
    pub section: String,
    /// Judgement of the entry: equal, scaled, different, undecided or stated.
    pub judgement: Judgement,
    /// Region of states in which the printed value equals the derived value: everywhere, unless the judgement limits
    /// it.
    pub holds: StatesOfValidity,
    /// Difference that an accepted entry may have, in words, such as "up to a constant"; `None` for
    /// exact equality.
    pub up_to: Option<&'static str>,
    /// Printed text of the entry, as transcribed in the publication file.
    pub printed: String,
    /// Derived value; for a scaled entry it is multiplied by the factor. `None` if no value was derived.
    pub derived: Option<Expr>,
    /// Factor printed ÷ derived; `None` without a common factor. A "different" entry has a factor only if it is exact.
    pub factor: Option<Expr>,
    /// Name of the derived row with which a printed row, or the row of a printed entry, was compared, and the factor
    /// printed ÷ derived of the row. `None` for other entries, for sums of derived rows, and for rows that no
    /// derivation shows: those with the author's multipliers, and balances along the axes of a stated frame.
    pub derived_row: Option<(RowName, Expr)>,
    /// Difference printed − derived, simplified; `None` unless the entry is "different".
    pub difference: Option<Expr>,
    /// Description of the mistake in words: wrong terms, or wrong entries of a row, with their right values. `None` if
    /// the entry is right, or if the description would be long.
    pub wrong: Option<String>,
    /// Wrong part with the right part of the printed formula; `None` unless this change is the whole mistake.
    pub change: Option<(Expr, Expr)>,
    /// Kind of the mistake; `None` unless there is exactly one mistake of a known kind.
    pub slip: Option<MistakeKind>,
    /// Names of the wrong abbreviations; empty unless their formulas contain all mistakes.
    pub abbreviations: Vec<String>,
    /// Places of the mistakes within a row, such as "the right-hand side"; empty for other entries.
    pub places: Vec<String>,
    /// State in which the printed and the derived value differ, with both values; `None` if none
    /// was found.
    pub witness: Option<Witness>,
    /// Further remarks, such as the matched derived row or an illegible part of the scan.
    pub remarks: Vec<String>,
}

/// Finding with its claim: the statement of the entry as data, with which wrong entries are traced to other entries.
pub(in crate::diff) struct TracedFinding {
    /// Finding of the entry, with its judgement.
    pub(in crate::diff) finding: Finding,
    /// Claim of the entry, as data for tracing.
    pub(in crate::diff) claim: Claim,
}

impl Finding {
    /// Combines the finding with its claim: the statement of the entry as data, for tracing mistakes.
    pub(in crate::diff) fn with_claim(self, claim: Claim) -> TracedFinding {
        TracedFinding { finding: self, claim }
    }

    /// Finding of an entry with the given judgement and printed text, without further data.
    pub(in crate::diff) fn new(id: &str, section: &str, judgement: Judgement, printed: &str) -> Self {
        Self {
            id: id.to_owned(),
            section: section.to_owned(),
            judgement,
            holds: StatesOfValidity::EVERYWHERE,
            up_to: None,
            printed: printed.to_owned(),
            derived: None,
            factor: None,
            derived_row: None,
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

    /// Adds the name and the factor of the derived row with which the row was compared. `names` are the names of the
    /// derived rows. Nothing is added for a sum of derived rows, or without names.
    pub(in crate::diff) fn with_derived_row(mut self, judged: &RowJudgement, names: &[RowName]) -> Self {
        if let RowMatchResult::Row { at, factor } = judged.by {
            self.derived_row = names.get(at).map(|name| (name.clone(), factor));
        }
        self
    }

    /// Formulas of the finding that documents show: derived value, factor and difference.
    pub fn shown_formulas(&self) -> impl Iterator<Item = Expr> {
        [self.derived, self.factor, self.difference].into_iter().flatten()
    }

    /// Adds the description, the repair and the kind of a mistake to the finding.
    pub(in crate::diff) fn name_mistake(&mut self, mistake: Mistake) {
        let Mistake { words, change, slip, abbreviations } = mistake;
        (self.slip, self.abbreviations) = (slip, abbreviations);
        self.wrong = (!words.is_empty()).then(|| words.join("; "));
        self.remarks.extend(words);
        self.change = change;
    }

    /// Adds the derived value, and the verdict of its comparison with the printed value.
    pub(in crate::diff) fn with_verdict(mut self, verdict: Verdict, holds: StatesOfValidity, derived: Expr) -> Self {
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

/// Creates the finding of an entry before it is judged: id, section and printed text.
pub(in crate::diff) fn unjudged_finding(id: &str, entry: &Entry, text: &str) -> Finding {
    Finding::new(id, &entry.section, Judgement::Stated, text)
}
