//! Coulomb's law among contacts that push and never pull: which of them stick, slip and open together.
//!
//! A contact with friction has a row along its gap and one along its slip. While it slips, at a velocity of the sign s, its force along the slip is −μ s λ_n:
//! the force along the gap stands in both rows of the linear system from which all forces follow at once, and that system is not symmetric. While
//! it sticks, both rows are held, and |λ_t| ≤ μ λ_n. What holds of several contacts is found by trying all modes of all of them: no pivoting, which ends in the first
//! solution that it meets. With friction there may be none, or several that move differently (P. Painlevé, "Sur les lois du frottement de glissement", *Comptes
//! Rendus* 121 (1895), 112–115; P. Lötstedt, "Coulomb friction in two-dimensional rigid body systems", *Zeitschrift für Angewandte Mathematik und Mechanik* 61
//! (1981), 605–615; F. Génot & B. Brogliato, "New results on Painlevé paradoxes", *European Journal of Mechanics A/Solids* 18 (1999), 653–677): [`Undecided`] says so.
//!
//! Absent on purpose: any knowledge of time, of steps and of models; any choice between motions that differ.

mod trial;

use nalgebra::DVector;
use std::fmt;
pub(crate) use trial::{Touch, Trial};

/// Motions that differ by less than this part of what would be without contacts are one.
const ALIKE: f64 = 1e-6;

/// What a contact that is closed does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// It opens, or could: it has no force.
    Opens,
    /// It pushes, without friction of a coefficient, and holds all of its rows.
    Pushes,
    /// It pushes, and friction keeps it from slipping.
    Sticks,
    /// It pushes, and slips at a velocity of this sign, 1 or −1.
    Slips(f64),
}

impl Mode {
    /// Whether the contact stays closed.
    #[must_use]
    pub fn is_held(self) -> bool {
        self != Self::Opens
    }

    /// How much of a contact is let go: nothing, its slip, or all of it.
    fn freedom(self) -> usize {
        match self {
            Self::Pushes | Self::Sticks => 0,
            Self::Slips(_) => 1,
            Self::Opens => 2,
        }
    }
}

impl fmt::Display for Mode {
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

/// Modes that contacts can have together, and their forces, or impulses, along all rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// A mode for each contact.
    pub modes: Vec<Mode>,
    /// Whether each has a force along its gap beside what it is given there.
    pub pushes: Vec<bool>,
    /// Along all rows: in N where the gap is in m, or N s.
    pub forces: DVector<f64>,
}

/// Why contacts do not say what they do together.
#[derive(Clone, Debug, PartialEq)]
pub enum Undecided {
    /// No modes agree with the laws of contacts and friction.
    Nothing,
    /// These do, among others perhaps, and move differently.
    Several([Vec<Mode>; 2]),
}

/// What was found with how the rows move, as one motion: in the order of how little is let go.
///
/// # Errors
/// [`Undecided`] if there is none, or more than one.
pub(crate) fn one_motion(found: Vec<(Found, DVector<f64>)>, size: f64) -> Result<Vec<Found>, Undecided> {
    let Some((first, motion)) = found.first() else { return Err(Undecided::Nothing) };
    let differs = |(_, other): &&(Found, DVector<f64>)| (other - motion).amax() > ALIKE * size;
    if let Some((other, _)) = found.iter().find(differs) {
        return Err(Undecided::Several([first.modes.clone(), other.modes.clone()]));
    }
    let mut list: Vec<Found> = found.into_iter().map(|(found, _)| found).collect();
    list.sort_by_key(|found| found.modes.iter().map(|mode| mode.freedom()).sum::<usize>());
    Ok(list)
}
