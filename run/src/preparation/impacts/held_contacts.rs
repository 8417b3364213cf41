//! List of the contacts that are held closed, with the mode of each: pushing, sticking or slipping.

use super::scene_contacts::SceneContacts;
use tripos_sim::ContactMode;

/// Contacts that are held closed, each with its mode: it pushes, sticks or slips.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HeldContacts {
    /// Indices of the held contacts among the contacts of the scene.
    pub which: Vec<usize>,
    /// Modes of the held contacts, in the order of `which`.
    pub modes: Vec<ContactMode>,
}

/// Empty list of held contacts, for a motion without contact.
pub static NONE: HeldContacts = HeldContacts { which: Vec::new(), modes: Vec::new() };

impl HeldContacts {
    /// True if no contact is held closed.
    pub fn is_empty(&self) -> bool {
        self.which.is_empty()
    }

    /// Iterates over the indices of the held contacts, each with its mode.
    pub fn iter(&self) -> impl Iterator<Item = (usize, ContactMode)> + '_ {
        self.which.iter().copied().zip(self.modes.iter().copied())
    }

    /// Mode of a contact, such as sticking; `None` if the contact is not held closed.
    pub fn mode(&self, contact: usize) -> Option<ContactMode> {
        self.iter().find(|(at, _)| *at == contact).map(|(_, mode)| mode)
    }

    /// Adds a contact that is held closed, with its mode.
    pub fn push(&mut self, contact: usize, mode: ContactMode) {
        self.which.push(contact);
        self.modes.push(mode);
    }

    /// Removes a contact from the held contacts; does nothing if it is not held.
    pub fn remove(&mut self, contact: usize) {
        if let Some(at) = self.which.iter().position(|held| *held == contact) {
            self.which.remove(at);
            self.modes.remove(at);
        }
    }

    /// Iterates over the held contacts that slip. Each item is the index of the contact and the sign of
    /// its slip velocity.
    pub fn slipping(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.iter().filter_map(|(at, mode)| match mode {
            ContactMode::Slips(way) => Some((at, way)),
            _ => None,
        })
    }

    /// Indices of the gap and slip velocities that are held at zero. A slipping contact holds only its
    /// gap velocity at zero.
    pub fn rows(&self, contacts: &SceneContacts<'_>) -> Vec<usize> {
        let held = |(at, mode): (usize, ContactMode)| {
            let rows = &contacts.rows[at];
            if matches!(mode, ContactMode::Slips(_)) { rows[..1].to_vec() } else { rows.clone() }
        };
        self.iter().flat_map(held).collect()
    }
}
