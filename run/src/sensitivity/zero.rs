//! What is zero at an instant at which contacts change, and how that instant moves with what is varied.

use super::contacts::{Direction, SMALL, Wide};
use super::forces::{Forces, NOTHING, RatesAlong, Varied};
use super::graze;
use crate::impacts::{Crossing, Happening};
use tripos_sim::Mode;

/// A function of the state that is zero where a contact changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum What {
    /// The gap of a contact that closes.
    Gap,
    /// The force along the gap of one that opens.
    Force,
    /// By how much the force along the slip of one that sticks is below what friction bears.
    Margin,
    /// The velocity at which one slips.
    Slip,
}

/// A zero of a contact, with the rate at which it is crossed.
#[derive(Clone, Copy, Debug)]
struct Zero {
    what: What,
    contact: usize,
    rate: f64,
}

/// How an instant moves, and the size of what that is made of.
#[derive(Clone, Copy)]
struct Moves {
    by: f64,
    size: f64,
}

/// What comes to a crossing.
pub struct Coming<'c> {
    pub wide: &'c Wide<'c>,
    pub crossing: &'c Crossing<'c>,
    pub rates_along: &'c RatesAlong<'c>,
    /// The rates before, with the forces of contacts that are held.
    pub rates: Vec<f64>,
    /// These forces; nothing where no contact is held.
    pub forces: Option<Forces>,
}

/// What is zero at a crossing.
pub struct Zeros<'c> {
    pub coming: Coming<'c>,
    /// What it happens by; nothing at the start, and where a contact is only touched.
    first: Option<Zero>,
    /// What else is zero at the same instant by itself, and stays so only if it moves alike.
    others: Vec<Zero>,
    /// Contacts that are touched without a velocity.
    touched: Vec<usize>,
}

impl<'c> Zeros<'c> {
    /// What is zero where this comes to a crossing.
    ///
    /// # Errors
    /// Why there is no derivative there by anything.
    pub fn new(coming: Coming<'c>) -> Result<Self, String> {
        let (list, touched) = zeros(&coming)?;
        let mut list = list.into_iter();
        let first = list.next();
        Ok(Self { coming, first, others: list.collect(), touched })
    }

    /// Whether more than one contact changes, or one is only touched.
    pub fn ask(&self) -> bool {
        !self.others.is_empty() || !self.touched.is_empty()
    }

    /// How the instant moves: not at all at the start.
    ///
    /// # Errors
    /// Why that has no value.
    pub fn later(&self, varied: &Varied<'_>, state: &[f64]) -> Result<f64, String> {
        self.first.as_ref().map_or(Ok(0.0), |zero| Ok(self.coming.moves(zero, varied, state)?.by))
    }

    /// Refuses what is zero at one instant and does not stay together.
    ///
    /// # Errors
    /// What does not, and by what.
    pub fn stay_together(&self, varied: &Varied<'_>, state: &[f64]) -> Result<(), String> {
        let (wide, y) = (self.coming.wide, self.coming.crossing.before);
        self.touched.iter().try_for_each(|contact| graze::check(wide, (*contact, y), varied, state))?;
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

/// What is zero, first that by which it happens, and the contacts that are touched without a velocity.
fn zeros(of: &Coming<'_>) -> Result<(Vec<Zero>, Vec<usize>), String> {
    let Crossing { happening, kept, after, .. } = of.crossing;
    let Some(happening) = *happening else { return Ok((Vec::new(), Vec::new())) };
    let contact = happening.contact();
    let mut touched = Vec::new();
    let mut list = match happening {
        Happening::Closes(_) | Happening::Nears(_) => {
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
        Happening::Opens(_) => vec![of.crosses(What::Force, contact)?],
        Happening::Slips(_) => vec![of.crosses(What::Margin, contact)?],
        Happening::Sticks(_) | Happening::Reverses(_) => vec![of.crosses(What::Slip, contact)?],
        Happening::Jams(_) => return Err(format!("the force of the contact `{}` is not determined", of.name(contact))),
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

/// How a gap that is nothing comes to it.
enum Closing {
    /// It grows.
    Opens,
    /// It is at its least, but for what a run leaves open.
    Touches,
    /// It closes, at this rate.
    Closes(f64),
}

impl Coming<'_> {
    fn name(&self, contact: usize) -> &str {
        &self.wide.contacts.impacts[contact].name
    }

    fn normal(&self, contact: usize) -> usize {
        self.wide.contacts.rows[contact][0]
    }

    /// What of a contact that was held is zero, if it changes by itself at the instant: not because others do.
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

    /// How a gap that is nothing comes to it.
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
        // Without the impact it would become no smaller than this.
        let depth = if acceleration > 0.0 { 0.5 * rate * rate / acceleration } else { f64::INFINITY };
        if rate >= -NOTHING * scale || depth <= self.wide.near * contacts.made_of(contact, y) {
            return Closing::Touches;
        }
        Closing::Closes(rate)
    }

    /// A zero of a contact that was held.
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
                "more contacts than `{}` hold the same motion there, and share what pushes",
                self.name(contact)
            ));
        }
        let (rate, size) = self.value(what, contact, &time, &self.rates)?;
        if rate.abs() <= SMALL * size {
            let what = match what {
                What::Force | What::Gap => "force of the contact `{}` does not cross zero there",
                What::Margin => "force of the contact `{}` only touches what its friction bears there",
                What::Slip => "slip of the contact `{}` ends there without a deceleration",
            };
            return Err(format!("the {}", what.replace("{}", self.name(contact))));
        }
        Ok(Zero { what, contact, rate })
    }

    /// The derivative of what is zero along a direction, and the size of what it is made of.
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

    /// How the instant of a zero moves.
    fn moves(&self, zero: &Zero, varied: &Varied<'_>, state: &[f64]) -> Result<Moves, String> {
        let (change, size) = self.value(zero.what, zero.contact, varied, state)?;
        Ok(Moves { by: -change / zero.rate, size: size / zero.rate.abs() })
    }
}

/// A sum, and that of the sizes of its terms.
fn sum(terms: impl Iterator<Item = f64>) -> (f64, f64) {
    terms.fold((0.0, 0.0), |(sum, size), term: f64| (sum + term, size + term.abs()))
}
