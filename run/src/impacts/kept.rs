//! Which contacts are held, and what each of them does.

use super::contacts::Contacts;
use tripos_sim::Mode;

/// Contacts that are held, each with what it does: it pushes, sticks or slips.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Kept {
    pub which: Vec<usize>,
    /// In the same order.
    pub modes: Vec<Mode>,
}

/// No contacts.
pub static NONE: Kept = Kept { which: Vec::new(), modes: Vec::new() };

impl Kept {
    /// Whether nothing is held.
    pub fn is_empty(&self) -> bool {
        self.which.is_empty()
    }

    /// The contacts with what they do.
    pub fn iter(&self) -> impl Iterator<Item = (usize, Mode)> + '_ {
        self.which.iter().copied().zip(self.modes.iter().copied())
    }

    /// What a contact does; nothing if it is not held.
    pub fn mode(&self, contact: usize) -> Option<Mode> {
        self.iter().find(|(at, _)| *at == contact).map(|(_, mode)| mode)
    }

    /// Adds a contact.
    pub fn push(&mut self, contact: usize, mode: Mode) {
        self.which.push(contact);
        self.modes.push(mode);
    }

    /// The contacts that slip, each with the sign of its velocity.
    pub fn slipping(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.iter().filter_map(|(at, mode)| match mode {
            Mode::Slips(way) => Some((at, way)),
            _ => None,
        })
    }

    /// The rows that are held: of what slips that of the gap alone.
    pub fn rows(&self, contacts: &Contacts<'_>) -> Vec<usize> {
        let held = |(at, mode): (usize, Mode)| {
            let rows = &contacts.rows[at];
            if matches!(mode, Mode::Slips(_)) { rows[..1].to_vec() } else { rows.clone() }
        };
        self.iter().flat_map(held).collect()
    }
}
