//! Changes of contacts, such as closing or slipping, and the numbers of the events that report
//! them.

use tripos_derive::scene::ImpactContact;

/// Change of a contact at which a part of a run ends and the next part begins. The value of each
/// variant is the index of the contact in the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactChange {
    /// The gap of the contact falls to zero, so that the contact closes.
    Closes(usize),
    /// The normal force of the contact falls to zero, so that the contact opens.
    Opens(usize),
    /// The tangential force of the sticking contact exceeds its friction limit.
    Slips(usize),
    /// The slip velocity of the contact reaches zero. The contact may slip the other way in the next
    /// part of the run.
    Sticks(usize),
    /// The slip velocity of the contact changes its sign.
    Reverses(usize),
    /// The forces of the slipping contact are no longer determined by its friction (Painlevé's
    /// paradox).
    Jams(usize),
    /// The gap of the open contact passes a minimum. The contact stays open.
    Nears(usize),
}

impl ContactChange {
    /// Returns the index of the contact, and the index of the kind of change from 0 (closes) to 6 (nears).
    fn contact_and_kind(self) -> (usize, usize) {
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

    /// Index in the scene of the contact that changes, from 0.
    pub fn contact(self) -> usize {
        self.contact_and_kind().0
    }

    /// Number of the event that reports this change in a scene with `contacts` contacts. The user's
    /// events are not counted: the first event of a contact has number 0.
    pub fn event_number(self, contacts: usize) -> usize {
        let (at, what) = self.contact_and_kind();
        what * contacts + at
    }

    /// Finds the change of a contact that the event with the given number reports. The user's events are
    /// not counted: the first event of a contact has number 0. `contacts` is the number of contacts in
    /// the scene, above zero. `None` if no change has this number.
    pub fn from_event_number(event: usize, contacts: usize) -> Option<Self> {
        let at = event % contacts;
        let what = [Self::Closes, Self::Opens, Self::Slips, Self::Sticks, Self::Reverses, Self::Jams, Self::Nears];
        what.get(event / contacts).map(|what| what(at))
    }

    /// Name of the event that reports this change: the contact's name, then the kind of change, as in
    /// `heel opens`. For a contact that closes it is the contact's name alone.
    pub fn name(self, impacts: &[ImpactContact]) -> String {
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
