//! Forces of contacts that are held at a state, and their derivatives.

use super::contacts::{Acting, Change, Direction, Wide, Without};
use super::grip::Grip;
use crate::preparation::impacts::{Contacts, HeldContacts, Operators};
use nalgebra::DVector;
use tripos_sim::{Failure, Mode};

/// Fraction of the size of its terms below which a force or a velocity of a contact counts as zero.
pub const NOTHING: f64 = 1e-9;

/// Function that gives the derivative, along a direction at a state, of the rates without forces of contacts.
pub type RatesAlong<'c> = dyn Fn(&[f64], Direction<'_>) -> Vec<f64> + 'c;

/// Number by which derivatives are taken, with the derivatives of parameters and of coefficients of contacts by it.
#[derive(Clone, Copy)]
pub struct Varied<'v> {
    pub name: &'v str,
    pub parameters: &'v [f64],
    /// Derivatives of the coefficients of restitution, one for each contact.
    pub restitutions: &'v [f64],
    /// Derivatives of the coefficients of friction, one for each contact.
    pub frictions: &'v [f64],
}

/// Contacts that are held at a state, and their forces.
pub struct Forces {
    kept: HeldContacts,
    y: Vec<f64>,
    /// Rates of the state without the forces of contacts.
    free: Vec<f64>,
    operators: Operators,
    grip: Grip,
    /// Forces of the held contacts along all rows.
    along_rows: DVector<f64>,
    /// Accelerations along all rows without the forces of contacts.
    accelerations: DVector<f64>,
    /// Indices of the rows whose force is not determined.
    shared: Vec<usize>,
}

impl Forces {
    /// Computes the forces of contacts that are held at a state. `free` holds the rates of the state without these
    /// forces.
    ///
    /// # Errors
    /// [`Failure`] where the forces are not finite.
    pub fn new(contacts: &Contacts<'_>, kept: &HeldContacts, y: &[f64], free: Vec<f64>) -> Result<Self, Failure> {
        let rates = contacts.rates(y);
        let (operators, response) = (contacts.operators(y, &rates)?, contacts.response(y, &rates)?);
        let accelerations = &rates.slopes * DVector::from_column_slice(&free);
        let (closed, rows) = contacts.closed(&response, &kept.which);
        let some = closed.hold(&accelerations.select_rows(&rows), &kept.modes);
        let message = "the forces of contacts that are held are not finite".to_owned();
        let some = some.ok_or(Failure { code: "not-finite", message })?;
        let along_rows = contacts.spread(&some, &rows);
        let grip = Grip::of(contacts, kept);
        let shared = grip.system(&response.compliance).shared();
        let shared = grip.rows.iter().zip(shared).filter(|(_, is)| *is).map(|(row, _)| *row).collect();
        let (kept, y) = (kept.clone(), y.to_vec());
        Ok(Self { kept, y, free, operators, grip, along_rows, accelerations, shared })
    }

    /// Root of the compliance G of a row: forces times this root are comparable between rows.
    pub fn unit(&self, row: usize) -> f64 {
        let of_u = self.operators.of_u.row(row);
        (of_u * self.operators.inertia.solve(&of_u.transpose()))[0].sqrt()
    }

    /// Largest acceleration along the held rows without forces, each divided by the root of the row's compliance.
    fn largest(&self) -> f64 {
        let size = |row: &usize| self.accelerations[*row].abs() / self.unit(*row);
        self.grip.rows.iter().map(size).fold(0.0, f64::max)
    }

    /// True if the contact force of a gap is zero or negative, up to rounding.
    pub fn is_nothing(&self, row: usize) -> bool {
        self.along_rows[row] * self.unit(row) <= NOTHING * self.largest()
    }

    /// True if a sticking contact is at the limit of its friction, except for rounding.
    pub fn is_at_limit(&self, contacts: &Contacts<'_>, contact: usize) -> bool {
        let rows = &contacts.rows[contact];
        let Some(mu) = contacts.friction(contact) else { return false };
        let margin = mu * self.along_rows[rows[0]] - self.along_rows[rows[1]].abs();
        margin * self.unit(rows[1]) <= NOTHING * self.largest()
    }

    /// True if the force along a row is not determined, since other rows hold the same motion.
    pub fn is_shared(&self, row: usize) -> bool {
        self.shared.contains(&row)
    }

    /// True if the force along any row is not determined.
    pub fn are_shared(&self) -> bool {
        !self.shared.is_empty()
    }

    /// Iterates over the indices of the held contacts, each with its mode.
    pub fn kept(&self) -> impl Iterator<Item = (usize, Mode)> + '_ {
        self.kept.iter()
    }

    /// Derivative of the forces along a direction: the slopes `state` of the state and those of the varied number.
    ///
    /// # Errors
    /// Text that says why the derivative has no value.
    pub fn change(
        &self,
        wide: &Wide<'_>,
        rates_along: &RatesAlong<'_>,
        varied: &Varied<'_>,
        state: &[f64],
    ) -> Result<Change, String> {
        let direction = Direction { parameters: varied.parameters, state };
        let by = rates_along(&self.y, direction);
        let acting = Acting { y: &self.y, operators: &self.operators, impulses: &self.along_rows, grip: &self.grip };
        let without = Without::Accelerate { rates: &self.free, by: &by };
        let given = self.grip.of_coefficients(varied.frictions, &self.along_rows);
        wide.change(&acting, &without, direction, &given).map_err(|failure| failure.message)
    }

    /// Derivative of the margin of a sticking contact, μ N − |T|, and the size of its terms.
    pub fn margin(&self, contacts: &Contacts<'_>, contact: usize, change: &Change, varied: &Varied<'_>) -> (f64, f64) {
        let (normal, slip) = (contacts.rows[contact][0], contacts.rows[contact][1]);
        let mu = contacts.friction(contact).unwrap_or(0.0);
        let by_mu = varied.frictions[contact] * self.along_rows[normal];
        let by_slip = self.along_rows[slip].signum() * change.impulses[slip];
        let size = change.size * (mu / self.unit(normal) + 1.0 / self.unit(slip)) + by_mu.abs();
        (by_mu + mu * change.impulses[normal] - by_slip, size)
    }
}
