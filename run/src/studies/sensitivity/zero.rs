//! Functions that are zero at an instant at which contacts change, and the derivative of that instant.

use super::contacts::{Direction, SMALL, Wide};
use super::forces::{Forces, NOTHING, RatesAlong, Varied};
use super::graze;
use crate::preparation::impacts::{ContactChange, Crossing};
use tripos_sim::Mode;

/// Function of the state that is zero where a contact changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum What {
    /// Gap of a contact that closes.
    Gap,
    /// Force along the gap of a contact that opens.
    Force,
    /// Friction limit of a sticking contact minus its force along the slip.
    Margin,
    /// Slip velocity of a contact that slips.
    Slip,
}

/// Function of a contact that crosses zero at an instant, and its rate there.
#[derive(Clone, Copy, Debug)]
struct Zero {
    what: What,
    contact: usize,
    rate: f64,
}

/// Derivative of an instant with respect to a number, and the size of the derivative's terms.
#[derive(Clone, Copy)]
struct Moves {
    by: f64,
    size: f64,
}

/// State of a motion just before a crossing, with its rates and forces.
pub struct Coming<'c> {
    pub wide: &'c Wide<'c>,
    pub crossing: &'c Crossing<'c>,
    pub rates_along: &'c RatesAlong<'c>,
    /// Rates before the crossing, with the forces of held contacts.
    pub rates: Vec<f64>,
    /// Forces of the contacts held before the crossing; `None` if no contact is held.
    pub forces: Option<Forces>,
}

/// Functions of contacts that are zero at a crossing, and contacts that are only touched.
pub struct Zeros<'c> {
    pub coming: Coming<'c>,
    /// Function whose zero causes the crossing; `None` at the start, and if a contact is only touched.
    first: Option<Zero>,
    /// Other functions that cross zero at the same instant by themselves. They stay together only if their zeros move
    /// alike.
    others: Vec<Zero>,
    /// Indices of the contacts that are touched without a velocity that closes them.
    touched: Vec<usize>,
}

impl<'c> Zeros<'c> {
    /// Finds the functions of contacts that are zero at a crossing.
    ///
    /// # Errors
    /// Text that says why there is no derivative by any number.
    pub fn new(coming: Coming<'c>) -> Result<Self, String> {
        let (list, touched) = zeros(&coming)?;
        let mut list = list.into_iter();
        let first = list.next();
        Ok(Self { coming, first, others: list.collect(), touched })
    }

    /// True if more than one contact changes, or a contact is only touched.
    pub fn ask(&self) -> bool {
        !self.others.is_empty() || !self.touched.is_empty()
    }

    /// Derivative of the instant of the crossing with respect to the varied number; zero at the start of a run.
    ///
    /// # Errors
    /// Text that says why the derivative has no value.
    pub fn later(&self, varied: &Varied<'_>, state: &[f64]) -> Result<f64, String> {
        self.first.as_ref().map_or(Ok(0.0), |zero| Ok(self.coming.moves(zero, varied, state)?.by))
    }

    /// Refuses a number that moves the zeros of one instant apart.
    ///
    /// # Errors
    /// Text that names the contacts and the number.
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

/// Finds the zeros of a crossing, the one that causes it first, and the contacts that are touched without a velocity.
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

/// Ways in which a gap reaches zero.
enum Closing {
    /// The gap grows.
    Opens,
    /// The gap is at its minimum, within the error of the run.
    Touches,
    /// The gap closes at this rate, which is negative.
    Closes(f64),
}

impl Coming<'_> {
    fn name(&self, contact: usize) -> &str {
        &self.wide.contacts.impacts[contact].name
    }

    fn normal(&self, contact: usize) -> usize {
        self.wide.contacts.rows[contact][0]
    }

    /// Function whose zero makes a held contact change; `None` if it does not change, or only because other contacts
    /// change.
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

    /// Finds the way in which the gap of a contact reaches zero.
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
        // Depth to which the gap would go without the impact.
        let depth = if acceleration > 0.0 { 0.5 * rate * rate / acceleration } else { f64::INFINITY };
        if rate >= -NOTHING * scale || depth <= self.wide.near * contacts.made_of(contact, y) {
            return Closing::Touches;
        }
        Closing::Closes(rate)
    }

    /// Zero of a contact that was held before the crossing, with the rate at which its function crosses zero.
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

    /// Derivative of a contact's function along a direction, and the size of its terms.
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

    /// Derivative of the instant at which a function is zero, and the size of its terms.
    fn moves(&self, zero: &Zero, varied: &Varied<'_>, state: &[f64]) -> Result<Moves, String> {
        let (change, size) = self.value(zero.what, zero.contact, varied, state)?;
        Ok(Moves { by: -change / zero.rate, size: size / zero.rate.abs() })
    }
}

/// Sum of terms, and the sum of their sizes.
fn sum(terms: impl Iterator<Item = f64>) -> (f64, f64) {
    terms.fold((0.0, 0.0), |(sum, size), term: f64| (sum + term, size + term.abs()))
}
