//! Mistake of a publication, and the wrong entries that it causes.

use crate::diff::formulas::finding::Finding;

/// Kind of dependence of a wrong entry on other entries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Link {
    /// The entry has an equal wrong value, or an equal mistake in another component.
    Repeated,
    /// The printed value follows when the printed values of other entries replace the derived ones.
    Follows,
    /// The entry is a number that other numbers contradict: one of them is wrong, and nothing decides which.
    Contradicts,
}

impl Link {
    /// Word for the link in lists and in JSON.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Repeated => "repeated",
            Self::Follows => "follows",
            Self::Contradicts => "contradicts",
        }
    }
}

/// Wrong entry that a mistake in other entries causes. Entries are indices in the list of findings.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Follower {
    /// Index of the entry among the findings.
    pub finding: usize,
    /// Kind of dependence on `from`.
    pub link: Link,
    /// Entries that it repeats, follows from or contradicts, as indices among the findings.
    pub from: Vec<usize>,
    /// Entries with other root mistakes that also cause it, as indices among the findings.
    pub also: Vec<usize>,
}

/// Mistake that no other mistake explains, in the entry where it first occurs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Root {
    /// Index of the entry among the findings.
    pub finding: usize,
    /// Description of the mistake, in words.
    pub mistake: String,
    /// Entries that the mistake causes, in the order of the publication file.
    pub followers: Vec<Follower>,
}

impl Root {
    /// Number of entries that are wrong by this mistake, the root's own among them.
    #[must_use]
    pub fn entries(&self) -> usize {
        1 + self.followers.len()
    }

    /// Id of the entry and its mistake, as a sentence without its full stop.
    #[must_use]
    pub fn title(&self, findings: &[Finding]) -> String {
        format!("{}: {}", findings[self.finding].id, self.mistake)
    }

    /// Followers with one kind of dependence.
    pub fn linked(&self, link: Link) -> impl Iterator<Item = &Follower> {
        self.followers.iter().filter(move |f| f.link == link)
    }
}
