//! A mistake of a publication, and the wrong entries that come of it.

use crate::diff::finding::Finding;

/// How a wrong entry hangs on another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Link {
    /// A wrong value that stands there too, or one mistake in another component.
    Repeated,
    /// It comes out as printed when the other's printed value is put in the place of the derived one.
    Follows,
    /// A number that others contradict: one of them is wrong, and nothing tells which.
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

/// A wrong entry that comes of a mistake made elsewhere. Entries are positions in the list of findings.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Follower {
    /// The entry.
    pub finding: usize,
    /// How it hangs on `from`.
    pub link: Link,
    /// The entries that it repeats, follows from or contradicts.
    pub from: Vec<usize>,
    /// Entries of other root mistakes that it comes of as well.
    pub also: Vec<usize>,
}

/// A mistake that none of the others explains, where it is first made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Root {
    /// The entry, a position in the list of findings.
    pub finding: usize,
    /// What is wrong, in words.
    pub mistake: String,
    /// The entries that come of it, in the order of the file.
    pub followers: Vec<Follower>,
}

impl Root {
    /// How many entries are wrong by it.
    #[must_use]
    pub fn entries(&self) -> usize {
        1 + self.followers.len()
    }

    /// The entry and the mistake, as a sentence without its full stop.
    #[must_use]
    pub fn title(&self, findings: &[Finding]) -> String {
        format!("{}: {}", findings[self.finding].id, self.mistake)
    }

    /// The followers that hang on others in one way.
    pub fn linked(&self, link: Link) -> impl Iterator<Item = &Follower> {
        self.followers.iter().filter(move |f| f.link == link)
    }
}
