//! What happens to contacts, and the events by which that is reported.

use tripos_derive::scene::Impact;

/// Why a part of a run ended, or what a contact begins to do, by the place of the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Happening {
    /// A gap closed.
    Closes(usize),
    /// A force no longer pushes.
    Opens(usize),
    /// A force along a contact is more than friction can bear.
    Slips(usize),
    /// A contact no longer slips. Where a part ended so it may slip the other way from there.
    Sticks(usize),
    /// A contact slips the other way.
    Reverses(usize),
    /// The forces of what slips are no longer determined.
    Jams(usize),
    /// A gap is as small as it becomes before it grows again: nothing changes there.
    Nears(usize),
}

impl Happening {
    /// The contact, and the place among what may happen to it.
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

    /// The contact.
    pub fn contact(self) -> usize {
        self.parts().0
    }

    /// Its number among the events of so many contacts.
    pub fn event(self, contacts: usize) -> usize {
        let (at, what) = self.parts();
        what * contacts + at
    }

    /// What has a number.
    pub fn of_event(event: usize, contacts: usize) -> Option<Self> {
        let at = event % contacts;
        let what = [Self::Closes, Self::Opens, Self::Slips, Self::Sticks, Self::Reverses, Self::Jams, Self::Nears];
        what.get(event / contacts).map(|what| what(at))
    }

    /// The name of its event.
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
