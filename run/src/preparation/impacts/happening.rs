//! Changes of contacts, and the events by which they are reported.

use tripos_derive::scene::Impact;

/// Change of a contact that ends a part of a run, or that begins there. It holds the index of the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Happening {
    /// A gap closed.
    Closes(usize),
    /// A force no longer pushes.
    Opens(usize),
    /// A force along a contact is more than friction can bear.
    Slips(usize),
    /// A contact no longer slips. It may slip the other way in the next part.
    Sticks(usize),
    /// A contact slips the other way.
    Reverses(usize),
    /// The forces of what slips are no longer determined.
    Jams(usize),
    /// A gap is at its minimum and grows again: no contact changes.
    Nears(usize),
}

impl Happening {
    /// Index of the contact, and of the kind of change.
    fn parts(self) -> (usize, usize) {
        match self {
            Self::Closes(at) => (at, 0),
            Self::Opens(at) => (at, 1),
            Self::Slips(at) => (at, 2),
            Self::Sticks(at) => (at, 3),
            Self::Reverses(at) => (at, 4),
            Self::Jams(at) => (at, 5),
            Self::Nears(at) => (at, 6),
        }
    }

    /// Index of the contact that changes.
    pub fn contact(self) -> usize {
        self.parts().0
    }

    /// Number of this change among the events of this many contacts.
    pub fn event(self, contacts: usize) -> usize {
        let (at, what) = self.parts();
        what * contacts + at
    }

    /// Change that has this event number; `None` if there is none.
    pub fn of_event(event: usize, contacts: usize) -> Option<Self> {
        let at = event % contacts;
        let what = [Self::Closes, Self::Opens, Self::Slips, Self::Sticks, Self::Reverses, Self::Jams, Self::Nears];
        what.get(event / contacts).map(|what| what(at))
    }

    /// Name of the event of this change.
    pub fn name(self, impacts: &[Impact]) -> String {
        let name = &impacts[self.contact()].name;
        let what = match self {
            Self::Closes(_) => return name.clone(),
            Self::Opens(_) => "opens",
            Self::Slips(_) => "slips",
            Self::Sticks(_) => "sticks",
            Self::Reverses(_) => "reverses",
            Self::Jams(_) => "jams",
            Self::Nears(_) => "nears",
        };
        format!("{name} {what}")
    }
}
