//! Coulomb's law of friction for contacts that push and never pull: the modes (sticking, slipping, opening) that closed
//! contacts can have together.
//!
//! A contact with friction has a row along its gap and a row along its slip. While it slips, at a velocity of the sign
//! s, its force along the slip is −μ s λ_n. The force along the gap then appears in both rows of the linear system for
//! all forces, and that system is not symmetric. While the contact sticks, both rows have no motion, and |λ_t| ≤ μ λ_n.
//!
//! The modes of several contacts are found by a trial of all combinations. Pivoting would end at the first solution
//! found. With friction there may be no solution, or several with different motions; [`UndecidedContacts`] reports
//! these cases. P. Painlevé, "Sur les lois du frottement de glissement", *Comptes Rendus* 121 (1895), 112–115. P.
//! Lötstedt, "Coulomb friction in two-dimensional rigid body systems", *Zeitschrift für Angewandte Mathematik und
//! Mechanik* 61 (1981), 605–615. F. Génot & B. Brogliato, "New results on Painlevé paradoxes", *European Journal of
//! Mechanics A/Solids* 18 (1999), 653–677.
//!
//! Absent on purpose: any knowledge of time, of steps and of models; any choice between different motions.

mod mode_trial;

pub(crate) use mode_trial::{ModeTrial, TriedContact};
use nalgebra::DVector;
use std::fmt;

/// Difference below which two motions of the contact rows count as the same, as a fraction of the
/// motion without contact forces.
const ALIKE: f64 = 1e-6;

/// Mode of a closed contact: it opens, pushes without friction, sticks or slips.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ContactMode {
    /// The contact opens, or could open: its contact force is zero.
    Opens,
    /// The contact has no friction and pushes; it has no motion along any of its rows.
    Pushes,
    /// The contact pushes, and friction prevents slip.
    Sticks,
    /// The contact pushes and slips. The number is the sign of the slip velocity, 1 or −1.
    Slips(f64),
}

impl ContactMode {
    /// True if the contact stays closed in this mode: it pushes, sticks or slips.
    #[must_use]
    pub fn is_held(self) -> bool {
        self != Self::Opens
    }

    /// Number of rows along which the contact may move: 0 if it pushes or sticks, 1 if it slips, 2 if it
    /// opens.
    fn free_rows_of_contact(self) -> usize {
        match self {
            Self::Pushes | Self::Sticks => 0,
            Self::Slips(_) => 1,
            Self::Opens => 2,
        }
    }
}

impl fmt::Display for ContactMode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Opens => "opens",
            Self::Pushes => "pushes",
            Self::Sticks => "sticks",
            Self::Slips(way) if *way > 0.0 => "slips forwards",
            Self::Slips(_) => "slips backwards",
        })
    }
}

/// Modes that closed contacts can have together, with their forces or, in an impact, their impulses.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactSolution {
    /// Mode of each closed contact, in the order of the contacts.
    pub modes: Vec<ContactMode>,
    /// True for each contact that has a force along its gap besides the given force.
    pub pushes: Vec<bool>,
    /// Forces along all rows of contacts, in N if the gap is in m; in an impact impulses, in N s.
    pub forces: DVector<f64>,
}

/// Reason why the laws of contact and friction do not decide the modes of contacts.
#[derive(Clone, Debug, PartialEq)]
pub enum UndecidedContacts {
    /// No combination of modes agrees with the laws of contact and friction.
    Nothing,
    /// Several combinations of modes agree with the laws, and their motions differ. Two of them are given,
    /// with a mode for each contact.
    Several([Vec<ContactMode>; 2]),
}

/// Checks that all found solutions have the same motion of the rows. Returns them sorted by freedom, the least freedom
/// first. `size` is the size of the motion without contact forces.
///
/// # Errors
/// [`UndecidedContacts`] if there are no solutions, or if they give different motions.
pub(crate) fn agreed_contact_motion(
    found: Vec<(ContactSolution, DVector<f64>)>,
    size: f64,
) -> Result<Vec<ContactSolution>, UndecidedContacts> {
    let Some((first, motion)) = found.first() else { return Err(UndecidedContacts::Nothing) };
    let differs = |(_, other): &&(ContactSolution, DVector<f64>)| (other - motion).amax() > ALIKE * size;
    if let Some((other, _)) = found.iter().find(differs) {
        return Err(UndecidedContacts::Several([first.modes.clone(), other.modes.clone()]));
    }
    let mut list: Vec<ContactSolution> = found.into_iter().map(|(found, _)| found).collect();
    list.sort_by_key(|found| found.modes.iter().map(|mode| mode.free_rows_of_contact()).sum::<usize>());
    Ok(list)
}

/// Forces of the first solution, which has the least freedom; an empty vector if there is none.
pub(super) fn forces_of_least_freedom(found: Vec<ContactSolution>) -> DVector<f64> {
    found.into_iter().next().map_or_else(|| DVector::zeros(0), |found| found.forces)
}
