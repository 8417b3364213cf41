//! The forces of contacts that are held at a state, and how they change.

use super::contacts::{Acting, Change, Direction, Wide, Without};
use super::grip::Grip;
use crate::impacts::{Contacts, Kept, Operators};
use nalgebra::DVector;
use tripos_sim::{Failure, Mode};

/// What is nothing beside what it is made of.
pub const NOTHING: f64 = 1e-9;

/// The derivative of the rates of the equations without contacts, along a direction at a state.
pub type RatesAlong<'c> = dyn Fn(&[f64], Direction<'_>) -> Vec<f64> + 'c;

/// What is varied, and what parameters and the coefficients of contacts do as it changes.
#[derive(Clone, Copy)]
pub struct Varied<'v> {
    pub name: &'v str,
    pub parameters: &'v [f64],
    /// By contact: coefficients of restitution.
    pub restitutions: &'v [f64],
    /// By contact: coefficients of friction.
    pub frictions: &'v [f64],
}

/// Contacts that are held at a state, and their forces.
pub struct Forces {
    kept: Kept,
    y: Vec<f64>,
    /// The rates of the state without them.
    free: Vec<f64>,
    operators: Operators,
    grip: Grip,
    /// The forces along all rows.
    along_rows: DVector<f64>,
    /// What all rows would do without.
    accelerations: DVector<f64>,
    /// The rows of which the force is not determined.
    shared: Vec<usize>,
}

impl Forces {
    /// The forces of contacts that are held at a state with these rates without them.
    ///
    /// # Errors
    /// [`Failure`] where there are none.
    pub fn new(contacts: &Contacts<'_>, kept: &Kept, y: &[f64], free: Vec<f64>) -> Result<Self, Failure> {
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

    /// The root of G of a row: what a force along it is measured by.
    pub fn unit(&self, row: usize) -> f64 {
        let of_u = self.operators.of_u.row(row);
        (of_u * self.operators.inertia.solve(&of_u.transpose()))[0].sqrt()
    }

    /// The largest of what held rows would do without forces, each in its unit.
    fn largest(&self) -> f64 {
        let size = |row: &usize| self.accelerations[*row].abs() / self.unit(*row);
        self.grip.rows.iter().map(size).fold(0.0, f64::max)
    }

    /// Whether no force is along a row, but for rounding.
    pub fn is_nothing(&self, row: usize) -> bool {
        self.along_rows[row] * self.unit(row) <= NOTHING * self.largest()
    }

    /// Whether a contact that sticks is at the limit of its friction, but for rounding.
    pub fn is_at_limit(&self, contacts: &Contacts<'_>, contact: usize) -> bool {
        let rows = &contacts.rows[contact];
        let Some(mu) = contacts.friction(contact) else { return false };
        let margin = mu * self.along_rows[rows[0]] - self.along_rows[rows[1]].abs();
        margin * self.unit(rows[1]) <= NOTHING * self.largest()
    }

    /// Whether the force along a row is not determined, since others hold the same motion.
    pub fn is_shared(&self, row: usize) -> bool {
        self.shared.contains(&row)
    }

    /// Whether any is not.
    pub fn are_shared(&self) -> bool {
        !self.shared.is_empty()
    }

    /// The contacts that are held, and what each does.
    pub fn kept(&self) -> impl Iterator<Item = (usize, Mode)> + '_ {
        self.kept.iter()
    }

    /// How they change.
    ///
    /// # Errors
    /// Why that has no value.
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

    /// How the margin of a contact that sticks changes, μ N − |T|, and what that is made of.
    pub fn margin(&self, contacts: &Contacts<'_>, contact: usize, change: &Change, varied: &Varied<'_>) -> (f64, f64) {
        let (normal, slip) = (contacts.rows[contact][0], contacts.rows[contact][1]);
        let mu = contacts.friction(contact).unwrap_or(0.0);
        let by_mu = varied.frictions[contact] * self.along_rows[normal];
        let by_slip = self.along_rows[slip].signum() * change.impulses[slip];
        let size = change.size * (mu / self.unit(normal) + 1.0 / self.unit(slip)) + by_mu.abs();
        (by_mu + mu * change.impulses[normal] - by_slip, size)
    }
}
