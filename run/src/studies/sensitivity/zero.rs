//! Functions of contacts that are zero at the instant of a change of contacts, and the derivatives
//! of this instant.

use super::contacts::{Direction, SMALL, Wide};
use super::forces::{Forces, NOTHING, RatesAlong, Varied};
use super::graze;
use crate::preparation::impacts::{ContactChange, Crossing};
use tripos_sim::Mode;

/// Kind of function of the state that is zero at the instant at which a contact changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum What {
    /// Gap of a contact, which closes.
    Gap,
    /// Normal force of a contact, which opens.
    Force,
    /// Friction limit of a sticking contact minus the size of its tangential force.
    Margin,
    /// Slip velocity of a contact, whose slip ends or reverses.
    Slip,
}

/// Function of a contact that crosses zero at an instant, with its rate there.
#[derive(Clone, Copy, Debug)]
struct Zero {
    /// Kind of the function, such as a gap or a slip velocity.
    what: What,
    /// Index of the contact in the scene, from 0.
    contact: usize,
    /// Time derivative of the function at its zero, in its unit per s.
    rate: f64,
}

/// Derivative of an instant by a varied number, and the size of the derivative's terms.
#[derive(Clone, Copy)]
struct Moves {
    /// Derivative of the instant, s per unit of the varied number.
    by: f64,
    /// Sum of the sizes of the derivative's terms, in the unit of the derivative.
    size: f64,
}

/// Motion just before a change of contacts, with its rates and contact forces.
pub struct Coming<'c> {
    /// Contacts of the scene in 32 digits.
    pub wide: &'c Wide<'c>,
    /// Instant, states and contacts of the change.
    pub crossing: &'c Crossing<'c>,
    /// Function for the derivative of the rates without contact forces.
    pub rates_along: &'c RatesAlong<'c>,
    /// Rates (q̇, v̇) before the change, with the forces of held contacts.
    pub rates: Vec<f64>,
    /// Forces of the contacts held closed before the change; `None` if no contact was held.
    pub forces: Option<Forces>,
}

/// Functions of contacts that are zero at a change of contacts, and contacts that are touched
/// without an impact.
pub struct Zeros<'c> {
    /// Motion just before the change.
    pub coming: Coming<'c>,
    /// Function whose zero causes the change. `None` at the start of a run, and if contacts are only
    /// touched.
    first: Option<Zero>,
    /// Other functions that are zero at the same instant by coincidence. A varied number must move all
    /// these zeros alike.
    others: Vec<Zero>,
    /// Indices of the contacts that are touched without a closing velocity.
    touched: Vec<usize>,
}

impl<'c> Zeros<'c> {
    /// Finds the functions of contacts that are zero at a change of contacts.
    ///
    /// # Errors
    /// Text that says why there is no derivative by any number.
    pub fn new(coming: Coming<'c>) -> Result<Self, String> {
        let (list, touched) = zeros(&coming)?;
        let mut list = list.into_iter();
        let first = list.next();
        Ok(Self { coming, first, others: list.collect(), touched })
    }

    /// True if several contacts change at the instant, or a contact is only touched. Each varied number
    /// must then be checked.
    pub fn ask(&self) -> bool {
        !self.others.is_empty() || !self.touched.is_empty()
    }

    /// Derivative of the instant of the change by the varied number; 0 at the start of a run. `state`
    /// holds the derivatives of the state.
    ///
    /// # Errors
    /// Text that says why the derivative has no value.
    pub fn later(&self, varied: &Varied<'_>, state: &[f64]) -> Result<f64, String> {
        self.first.as_ref().map_or(Ok(0.0), |zero| Ok(self.coming.moves(zero, varied, state)?.by))
    }

    /// Checks that the varied number moves all zeros of the instant alike, and does not change a gap
    /// that is only touched.
    ///
    /// # Errors
    /// Text that names the contacts and the number if there is no derivative.
    pub fn stay_together(&self, varied: &Varied<'_>, state: &[f64]) -> Result<(), String> {
        let (wide, y) = (self.coming.wide, self.coming.crossing.before);
        self.touched.iter().try_for_each(|contact| graze::check(wide, *contact, y, varied, state))?;
        let Some(first) = self.first.as_ref().filter(|_| !self.others.is_empty()) else { return Ok(()) };
        let a = self.coming.moves(first, varied, state)?;
        for other in &self.others {
            let b = self.coming.moves(other, varied, state)?;
            if (a.by - b.by).abs() > SMALL * a.size.max(b.size) {
                let what = match first.what {
                    What::Gap => "close",
                    What::Force => "open",
                    What::Margin | What::Slip => "slip or stick",
                };
                return Err(format!(
                    "the contacts `{}` and `{}` {what} at one instant, which `{}` moves apart",
                    self.coming.name(first.contact),
                    self.coming.name(other.contact),
                    varied.name
                ));
            }
        }
        Ok(())
    }
}

/// Finds the functions that are zero at a change of contacts, with the cause of the change first.
/// The second list has the contacts that are touched without a closing velocity.
///
/// # Errors
/// Text that says why there is no derivative by any number.
fn zeros(of: &Coming<'_>) -> Result<(Vec<Zero>, Vec<usize>), String> {
    let Crossing { contact_change, kept, after, .. } = of.crossing;
    let Some(contact_change) = *contact_change else { return Ok((Vec::new(), Vec::new())) };
    let contact = contact_change.contact();
    let mut touched = Vec::new();
    let mut list = match contact_change {
        ContactChange::Closes(_) | ContactChange::Nears(_) => {
            let is_new = |other: &usize| kept.mode(*other).is_none() && *other != contact;
            let mut list = Vec::new();
            for at in std::iter::once(contact).chain(after.closed.iter().copied().filter(is_new)) {
                match of.closes(at) {
                    Closing::Opens if at != contact => {}
                    Closing::Opens | Closing::Touches => touched.push(at),
                    Closing::Closes(rate) => list.push(Zero { what: What::Gap, contact: at, rate }),
                }
            }
            list
        }
        ContactChange::Opens(_) => vec![of.crosses(What::Force, contact)?],
        ContactChange::Slips(_) => vec![of.crosses(What::Margin, contact)?],
        ContactChange::Sticks(_) | ContactChange::Reverses(_) => vec![of.crosses(What::Slip, contact)?],
        ContactChange::Jams(_) => {
            return Err(format!("the force of the contact `{}` is not determined", of.name(contact)));
        }
    };
    if after.hits.is_empty() {
        for (other, mode) in kept.iter().filter(|(other, _)| *other != contact) {
            if let Some(what) = of.changes(other, mode) {
                list.push(of.crosses(what, other)?);
            }
        }
    }
    Ok((list, touched))
}

/// Behaviour of a contact's gap at the instant at which it is zero.
enum Closing {
    /// The gap increases from zero.
    Opens,
    /// The gap is at its minimum, up to the error of the run.
    Touches,
    /// The gap closes with this negative rate, in its unit per s.
    Closes(f64),
}

impl Coming<'_> {
    /// Name of a contact, by its index.
    fn name(&self, contact: usize) -> &str {
        &self.wide.contacts.impacts[contact].name
    }

    /// Index of the gap direction of a contact among the directions of all contacts.
    fn normal(&self, contact: usize) -> usize {
        self.wide.contacts.rows[contact][0]
    }

    /// Kind of function whose zero makes a held contact change its mode. `None` if the contact does not
    /// change, or changes only because other contacts do.
    fn changes(&self, contact: usize, mode: Mode) -> Option<What> {
        let forces = self.forces.as_ref()?;
        match (mode, self.crossing.after.kept.mode(contact)) {
            (_, None) => forces.is_nothing(self.normal(contact)).then_some(What::Force),
            (Mode::Sticks, Some(Mode::Slips(_))) => {
                forces.is_at_limit(self.wide.contacts, contact).then_some(What::Margin)
            }
            (Mode::Slips(_), Some(Mode::Sticks)) => Some(What::Slip),
            (Mode::Slips(one), Some(Mode::Slips(other))) => (one * other < 0.0).then_some(What::Slip),
            _ => None,
        }
    }

    /// Finds the behaviour of a contact's gap that is zero: it opens, touches or closes.
    fn closes(&self, contact: usize) -> Closing {
        let (contacts, y) = (self.wide.contacts, self.crossing.before);
        let slopes = contacts.gap_slopes(y);
        let (rate, scale) = sum(slopes.row(contact).iter().zip(&self.rates).map(|(slope, rate)| slope * rate));
        if rate > NOTHING * scale {
            return Closing::Opens;
        }
        let slopes = contacts.rates(y).slopes;
        let (acceleration, _) =
            sum(slopes.row(self.normal(contact)).iter().zip(&self.rates).map(|(slope, rate)| slope * rate));
        // Depth of penetration that the gap would reach without the impact.
        let depth = if acceleration > 0.0 { 0.5 * rate * rate / acceleration } else { f64::INFINITY };
        if rate >= -NOTHING * scale || depth <= self.wide.near * contacts.made_of(contact, y) {
            return Closing::Touches;
        }
        Closing::Closes(rate)
    }

    /// Makes the zero of a contact's function at the change, with the rate at which the function
    /// crosses zero.
    ///
    /// # Errors
    /// Text that says why the function has no crossing, or its force is not determined.
    fn crosses(&self, what: What, contact: usize) -> Result<Zero, String> {
        let still = vec![0.0; self.wide.contacts.parameters.len()];
        let none = vec![0.0; self.wide.contacts.impacts.len()];
        let time = Varied { name: "t", parameters: &still, restitutions: &none, frictions: &none };
        let rows = &self.wide.contacts.rows[contact];
        let shared = |row: &usize| self.forces.as_ref().is_some_and(|forces| forces.is_shared(*row));
        let needed = match what {
            What::Force => &rows[..1],
            What::Margin => &rows[..2],
            What::Gap | What::Slip => &[],
        };
        if needed.iter().any(shared) {
            return Err(format!(
                "the contact `{}` and others hold the same motion there, and their shares of the force are not determined",
                self.name(contact)
            ));
        }
        let (rate, size) = self.value(what, contact, &time, &self.rates)?;
        if rate.abs() <= SMALL * size {
            let what = match what {
                What::Force | What::Gap => "force of the contact `{}` does not cross zero there",
                What::Margin => "force of the contact `{}` only touches the limit of friction there",
                What::Slip => "slip of the contact `{}` ends there without a deceleration",
            };
            return Err(format!("the {}", what.replace("{}", self.name(contact))));
        }
        Ok(Zero { what, contact, rate })
    }

    /// Derivative of a contact's function by the varied number, and the size of its terms. `state`
    /// holds the derivatives of the state.
    ///
    /// # Errors
    /// Text that says why the derivative has no value.
    fn value(&self, what: What, contact: usize, varied: &Varied<'_>, state: &[f64]) -> Result<(f64, f64), String> {
        let direction = Direction { parameters: varied.parameters, state };
        match what {
            What::Gap => return Ok(self.wide.gap(contact, self.crossing.before, direction)),
            What::Slip => {
                let row = self.wide.contacts.rows[contact][1];
                return Ok(self.wide.velocity(row, self.crossing.before, direction));
            }
            What::Force | What::Margin => {}
        }
        let unknown = || format!("the force of the contact `{}` is not known", self.name(contact));
        let forces = self.forces.as_ref().ok_or_else(unknown)?;
        let change = forces.change(self.wide, self.rates_along, varied, state)?;
        let row = self.normal(contact);
        Ok(match what {
            What::Margin => forces.margin(self.wide.contacts, contact, &change, varied),
            _ => (change.impulses[row], change.size / forces.unit(row)),
        })
    }

    /// Derivative of the instant at which a function is zero by the varied number, and the size of its
    /// terms.
    ///
    /// # Errors
    /// Text that says why the derivative has no value.
    fn moves(&self, zero: &Zero, varied: &Varied<'_>, state: &[f64]) -> Result<Moves, String> {
        let (change, size) = self.value(zero.what, zero.contact, varied, state)?;
        Ok(Moves { by: -change / zero.rate, size: size / zero.rate.abs() })
    }
}

/// Sum of terms, and the sum of their absolute values.
fn sum(terms: impl Iterator<Item = f64>) -> (f64, f64) {
    terms.fold((0.0, 0.0), |(sum, size), term: f64| (sum + term, size + term.abs()))
}
