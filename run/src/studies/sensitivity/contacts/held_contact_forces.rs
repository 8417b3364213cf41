//! Forces of contacts that are held closed at a state, and the derivatives of these forces.

use super::held_directions::HeldDirections;
use super::precise_contacts::{
    ActingContacts, ContactForceDerivative, ForceFreeMotion, ParameterStateDirection, PreciseContacts,
};
use crate::preparation::impacts::{ContactOperators, HeldContacts, SceneContacts};
use nalgebra::DVector;
use tripos_sim::{ContactMode, Failure};

/// Fraction of the sizes of its terms below which a contact force or a velocity counts as zero.
pub const NOTHING: f64 = 1e-9;

/// Function that computes the derivative of the rates (q̇, v̇), without contact forces, at a state (q, v)
/// along a direction of parameters and state.
pub type RatesAlong<'c> = dyn Fn(&[f64], ParameterStateDirection<'_>) -> Vec<f64> + 'c;

/// Varied number of a scene, with the derivatives of parameters and of contact coefficients by this
/// number.
#[derive(Clone, Copy)]
pub struct VariedNumber<'v> {
    /// Name of the number, for messages.
    pub name: &'v str,
    /// Derivatives of the parameters by the number, in the order of the model.
    pub parameters: &'v [f64],
    /// Derivative of the coefficient of restitution of each contact by the number.
    pub restitutions: &'v [f64],
    /// Derivative of the coefficient of friction of each contact by the number.
    pub frictions: &'v [f64],
}

/// Contacts that are held closed at a state, with their forces, prepared for derivatives of these
/// forces.
pub struct HeldContactForces {
    /// Held contacts, each with its mode.
    kept: HeldContacts,
    /// State (q, v).
    y: Vec<f64>,
    /// Rates (q̇, v̇) of the state without contact forces.
    free: Vec<f64>,
    /// Matrices at the state that relate generalized speeds, impulses of contacts and kinetic energy.
    operators: ContactOperators,
    /// Held gap and slip directions, and friction of slipping contacts.
    grip: HeldDirections,
    /// Forces of the held contacts along the gap and slip directions of all contacts.
    along_rows: DVector<f64>,
    /// Accelerations along the gap and slip directions of all contacts, without contact forces.
    accelerations: DVector<f64>,
    /// Indices of the held directions whose force is not determined, because other contacts hold the same
    /// motion.
    shared: Vec<usize>,
}

impl HeldContactForces {
    /// Computes the forces of the contacts `kept`, which are held closed, at a state `y`. `free` are the
    /// rates of the state without contact forces.
    ///
    /// # Errors
    /// [`Failure`] if a force is not finite, or a permitted motion has no inertia.
    pub fn new(contacts: &SceneContacts<'_>, kept: &HeldContacts, y: &[f64], free: Vec<f64>) -> Result<Self, Failure> {
        let rates = contacts.rates(y);
        let (operators, response) = (contacts.operators(y, &rates)?, contacts.response(y, &rates)?);
        let accelerations = &rates.slopes * DVector::from_column_slice(&free);
        let (closed, rows) = contacts.closed_contact_system(&response, &kept.which);
        let some = closed.forces_in_contact_modes(&accelerations.select_rows(&rows), &kept.modes);
        let message = "the forces of contacts that are held are not finite".to_owned();
        let some = some.ok_or(Failure { code: "not-finite", message })?;
        let along_rows = contacts.spread_over_contact_rows(&some, &rows);
        let grip = HeldDirections::of_held_contacts(contacts, kept);
        let shared = grip.system(&response.compliance).undetermined_forces();
        let shared = grip.rows.iter().zip(shared).filter(|(_, is)| *is).map(|(row, _)| *row).collect();
        let (kept, y) = (kept.clone(), y.to_vec());
        Ok(Self { kept, y, free, operators, grip, along_rows, accelerations, shared })
    }

    /// Square root of the compliance G of a gap or slip direction. Forces of several directions can be
    /// compared after multiplication by their roots.
    pub fn compliance_root(&self, row: usize) -> f64 {
        let of_u = self.operators.of_u.row(row);
        (of_u * self.operators.inertia.solve(&of_u.transpose()))[0].sqrt()
    }

    /// Largest absolute acceleration along the held directions without contact forces. Each acceleration
    /// is divided by the root of its compliance.
    fn largest_scaled_acceleration(&self) -> f64 {
        let size = |row: &usize| self.accelerations[*row].abs() / self.compliance_root(*row);
        self.grip.rows.iter().map(size).fold(0.0, f64::max)
    }

    /// True if the contact force along the gap direction `row` is zero or negative, up to rounding.
    pub fn is_force_zero(&self, row: usize) -> bool {
        self.along_rows[row] * self.compliance_root(row) <= NOTHING * self.largest_scaled_acceleration()
    }

    /// True if the force of a sticking contact is at its friction limit, up to rounding. False if the
    /// contact has no friction law.
    pub fn is_at_limit(&self, contacts: &SceneContacts<'_>, contact: usize) -> bool {
        let rows = &contacts.rows[contact];
        let Some(mu) = contacts.friction(contact) else { return false };
        let margin = mu * self.along_rows[rows[0]] - self.along_rows[rows[1]].abs();
        margin * self.compliance_root(rows[1]) <= NOTHING * self.largest_scaled_acceleration()
    }

    /// True if the force along the held direction `row` is not determined, because other contacts hold
    /// the same motion.
    pub fn is_shared(&self, row: usize) -> bool {
        self.shared.contains(&row)
    }

    /// True if the force along any held direction is not determined, because several contacts hold the
    /// same motion.
    pub fn are_shared(&self) -> bool {
        !self.shared.is_empty()
    }

    /// Iterates over the indices of the held contacts, each with its mode.
    pub fn held_contacts(&self) -> impl Iterator<Item = (usize, ContactMode)> + '_ {
        self.kept.iter()
    }

    /// Computes the derivative of the contact forces by the varied number. `state` are the derivatives of
    /// the state (q, v) by this number.
    ///
    /// # Errors
    /// Text that says why the derivative is not finite.
    pub fn force_derivative(
        &self,
        wide: &PreciseContacts<'_>,
        rates_along: &RatesAlong<'_>,
        varied: &VariedNumber<'_>,
        state: &[f64],
    ) -> Result<ContactForceDerivative, String> {
        let direction = ParameterStateDirection { parameters: varied.parameters, state };
        let by = rates_along(&self.y, direction);
        let acting =
            ActingContacts { y: &self.y, operators: &self.operators, impulses: &self.along_rows, grip: &self.grip };
        let without = ForceFreeMotion::Accelerate { rates: &self.free, by: &by };
        let given = self.grip.friction_by_coefficients(varied.frictions, &self.along_rows);
        wide.contact_force_derivative(&acting, &without, direction, &given).map_err(|failure| failure.message)
    }

    /// Derivative of the friction margin μ N − |T| of a sticking contact by the varied number, and the
    /// size of the derivative's terms. N is the normal force, T the tangential force. `change` is the
    /// derivative of the contact forces.
    pub fn friction_margin_derivative(
        &self,
        contacts: &SceneContacts<'_>,
        contact: usize,
        change: &ContactForceDerivative,
        varied: &VariedNumber<'_>,
    ) -> (f64, f64) {
        let (normal, slip) = (contacts.rows[contact][0], contacts.rows[contact][1]);
        let mu = contacts.friction(contact).unwrap_or(0.0);
        let by_mu = varied.frictions[contact] * self.along_rows[normal];
        let by_slip = self.along_rows[slip].signum() * change.impulses[slip];
        let size = change.size * (mu / self.compliance_root(normal) + 1.0 / self.compliance_root(slip)) + by_mu.abs();
        (by_mu + mu * change.impulses[normal] - by_slip, size)
    }
}
