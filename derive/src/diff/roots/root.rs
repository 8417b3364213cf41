//! Root mistake of a publication, with the wrong entries that it causes.

use crate::diff::formulas::finding::Finding;

/// Kind of dependence of a wrong entry on other wrong entries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DependenceKind {
    /// The entry has the same wrong value as another entry, or the same mistake in another
    /// component.
    Repeated,
    /// The printed value follows exactly when the printed values of other entries replace the derived values.
    Follows,
    /// The entry is a number that other printed numbers contradict. At least one of them is wrong, but the publication
    /// does not show which.
    Contradicts,
}

impl DependenceKind {
    /// Word for the kind of dependence, for lists and JSON, such as "follows".
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Repeated => "repeated",
            Self::Follows => "follows",
            Self::Contradicts => "contradicts",
        }
    }
}

/// Wrong entry that is a consequence of mistakes in other entries. Entries are given by their indices in the list of
/// findings.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DependentEntry {
    /// Index of the dependent entry among the findings.
    pub finding: usize,
    /// Kind of dependence on the entries in `from`.
    pub link: DependenceKind,
    /// Indices, among the findings, of the entries that the entry repeats, follows from or
    /// contradicts.
    pub from: Vec<usize>,
    /// Indices, among the findings, of entries with other root mistakes that also cause this entry.
    pub also: Vec<usize>,
}

/// Mistake that no other mistake explains, with the entry in which it first occurs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RootMistake {
    /// Index, among the findings, of the entry with the mistake.
    pub finding: usize,
    /// Description of the mistake, such as "3*u1 should be 2*u1".
    pub mistake: String,
    /// Wrong entries that the mistake causes, in the order of the publication file.
    pub followers: Vec<DependentEntry>,
}

impl RootMistake {
    /// Number of entries that are wrong because of the mistake, including the entry that contains it.
    #[must_use]
    pub fn entries(&self) -> usize {
        1 + self.followers.len()
    }

    /// Title of the mistake: the id of its entry and the description, without a full stop.
    #[must_use]
    pub fn title(&self, findings: &[Finding]) -> String {
        format!("{}: {}", findings[self.finding].id, self.mistake)
    }

    /// Wrong entries that the mistake causes by the given kind of dependence.
    pub fn followers_by_link(&self, link: DependenceKind) -> impl Iterator<Item = &DependentEntry> {
        self.followers.iter().filter(move |f| f.link == link)
    }
}
