//! A mistake of a publication, and the wrong entries that it causes.

use crate::diff::formulas::finding::Finding;

/// Kind of dependence of a wrong entry on another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Link {
    /// The same wrong value, or one mistake in another component.
    Repeated,
    /// The printed value follows when the other's printed value replaces the derived one.
    Follows,
    /// A number that others contradict: one of them is wrong, and nothing decides which.
    Contradicts,
}

impl Link {
    /// The words of a list, and of JSON.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Repeated => "repeated",
            Self::Follows => "follows",
            Self::Contradicts => "contradicts",
        }
    }
}

/// A wrong entry that is caused by a mistake made elsewhere. Entries are positions in the list of findings.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Follower {
    /// The entry.
    pub finding: usize,
    /// Kind of dependence on `from`.
    pub link: Link,
    /// The entries that it repeats, follows from or contradicts.
    pub from: Vec<usize>,
    /// Entries of other root mistakes that cause it as well.
    pub also: Vec<usize>,
}

/// A mistake that no other mistake explains, in the entry where it is first made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Root {
    /// The entry, a position in the list of findings.
    pub finding: usize,
    /// Description of the mistake, in words.
    pub mistake: String,
    /// The entries that it causes, in the order of the file.
    pub followers: Vec<Follower>,
}

impl Root {
    /// Number of entries that are wrong by this mistake, the root's own among them.
    #[must_use]
    pub fn entries(&self) -> usize {
        1 + self.followers.len()
    }

    /// The entry and the mistake, as a sentence without its full stop.
    #[must_use]
    pub fn title(&self, findings: &[Finding]) -> String {
        format!("{}: {}", findings[self.finding].id, self.mistake)
    }

    /// The followers with one kind of dependence.
    pub fn linked(&self, link: Link) -> impl Iterator<Item = &Follower> {
        self.followers.iter().filter(move |f| f.link == link)
    }
}
