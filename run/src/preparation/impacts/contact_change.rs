//! Changes of contacts, and the events by which they are reported.

use tripos_derive::scene::Impact;

/// Change of a contact that ends a part of a run, or that begins there. It holds the index of the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactChange {
    /// The gap of the contact closed.
    Closes(usize),
    /// The normal force of the contact no longer pushes.
    Opens(usize),
    /// The force along the sticking contact exceeds its friction limit.
    Slips(usize),
    /// The contact no longer slips. It may slip the other way in the next part of the run.
    Sticks(usize),
    /// The contact slips in the opposite direction.
    Reverses(usize),
    /// The forces of the slipping contact are no longer determined.
    Jams(usize),
    /// The gap of the contact is at its minimum and grows again: no contact changes.
    Nears(usize),
}

impl ContactChange {
    /// Index of the contact, and index of the kind of change.
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

    /// Event number of this change, in a scene with `contacts` contacts.
    pub fn event(self, contacts: usize) -> usize {
        let (at, what) = self.parts();
        what * contacts + at
    }

    /// Change that has the given event number, in a scene with `contacts` contacts; `None` if no change has this
    /// number.
    pub fn of_event(event: usize, contacts: usize) -> Option<Self> {
        let at = event % contacts;
        let what = [Self::Closes, Self::Opens, Self::Slips, Self::Sticks, Self::Reverses, Self::Jams, Self::Nears];
        what.get(event / contacts).map(|what| what(at))
    }

    /// Name of the event that reports this change: the name of the contact, then the kind of change.
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
