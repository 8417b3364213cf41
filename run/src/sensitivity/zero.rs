//! What is zero at an instant at which contacts change, and how that instant moves with what is varied.

use super::contacts::{Direction, SMALL, Wide};
use super::forces::{Forces, NOTHING, RatesAlong, Varied};
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
    /// What it happens by; nothing at the start.
    first: Option<Zero>,
    /// What else is zero at the same instant by itself, and stays so only if it moves alike.
    others: Vec<Zero>,
}

impl<'c> Zeros<'c> {
    /// What is zero where this comes to a crossing.
    ///
    /// # Errors
    /// Why there is no derivative there by anything.
    pub fn new(coming: Coming<'c>) -> Result<Self, String> {
        let (first, others) = zeros(&coming)?;
        Ok(Self { coming, first, others })
    }

    /// Whether more than one contact changes.
    pub fn are_several(&self) -> bool {
        !self.others.is_empty()
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

fn zeros(of: &Coming<'_>) -> Result<(Option<Zero>, Vec<Zero>), String> {
    let Crossing { happening, kept, after, .. } = of.crossing;
    let Some(happening) = *happening else { return Ok((None, Vec::new())) };
    let contact = happening.contact();
    let mut others = Vec::new();
    let first = match happening {
        Happening::Closes(_) => {
            let is_new = |other: &&usize| kept.mode(**other).is_none() && **other != contact;
            for other in after.closed.iter().filter(is_new) {
                others.extend(of.closes(*other)?);
            }
            of.closes(contact)?.ok_or_else(|| of.grazes(contact))?
        }
        Happening::Opens(_) => of.crosses(What::Force, contact)?,
        Happening::Slips(_) => of.crosses(What::Margin, contact)?,
        Happening::Sticks(_) | Happening::Reverses(_) => of.crosses(What::Slip, contact)?,
        Happening::Jams(_) => return Err(format!("the force of the contact `{}` is not determined", of.name(contact))),
    };
    if after.hits.is_empty() {
        for (other, mode) in kept.iter().filter(|(other, _)| *other != contact) {
            if let Some(what) = of.changes(other, mode) {
                others.push(of.crosses(what, other)?);
            }
        }
    }
    Ok((Some(first), others))
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

    /// The zero of a gap that closes; nothing if it opens.
    fn closes(&self, contact: usize) -> Result<Option<Zero>, String> {
        let slopes = self.wide.contacts.gap_slopes(self.crossing.before);
        let (rate, scale) = sum(slopes.row(contact).iter().zip(&self.rates).map(|(slope, rate)| slope * rate));
        if rate > NOTHING * scale {
            return Ok(None);
        }
        if rate >= -NOTHING * scale {
            return Err(self.grazes(contact));
        }
        Ok(Some(Zero { what: What::Gap, contact, rate }))
    }

    fn grazes(&self, contact: usize) -> String {
        format!("the contact `{}` is touched there without a velocity that closes it", self.name(contact))
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
