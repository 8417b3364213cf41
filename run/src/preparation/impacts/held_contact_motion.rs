//! Motions in which contacts are held closed by contact forces.
//!
//! The forces λ of held contacts keep the gap and slip velocities of these contacts at zero:
//! G λ + a = 0. Here a are the rates of these velocities without the forces, and G λ is their change
//! by the forces. If a contact slips, its slip velocity is free. Its friction enters the same system
//! as −μ s times the normal force, where s is the sign of the slip. The forces change the equations
//! of motion to v̇ + M⁻¹ Wᵀ λ. Each step is corrected so that the held gaps stay closed.

use super::held_contacts::HeldContacts;
use super::scene_contacts::{ContactRates, ImpulseResponse, SceneContacts};
use nalgebra::DVector;
use tripos_sim::{Failure, RightHandSide};

/// Equations of motion with the forces of contacts that are held closed.
pub struct HeldContactEquations<'a> {
    /// Right-hand side of the equations of motion without contact forces.
    pub rhs: Box<dyn RightHandSide<f64> + 'a>,
    /// All contacts of the scene.
    pub contacts: &'a SceneContacts<'a>,
    /// Contacts that are held closed, each with its mode, such as sticking.
    pub kept: &'a HeldContacts,
}

/// Accelerations at a state without contact forces, and the response to such forces.
pub struct ContactFreeMotion {
    /// Rates of the state, ẏ = (q̇, v̇), without contact forces.
    pub rates: Vec<f64>,
    /// Accelerations along the gap and slip directions of all contacts, without contact forces.
    pub accelerations: DVector<f64>,
    /// Sum of the absolute terms of each acceleration in `accelerations`. An acceleration far below its
    /// sum counts as zero.
    pub sizes: DVector<f64>,
    /// Changes of the velocities by impulses along the contacts, equal to the changes of the
    /// accelerations by forces along the contacts.
    pub response: ImpulseResponse,
}

/// Fraction of the reference force [`ContactFreeMotion::reference_contact_force`] below which a contact force counts as
/// rounding.
pub(super) const ROUNDED: f64 = 1e-12;

impl ContactFreeMotion {
    /// Reference force of a gap or slip direction, for the decision which contact forces are rounding.
    /// This force would cancel the acceleration if all terms of the acceleration had one sign. Zero if
    /// no motion changes the velocity `row`.
    pub fn reference_contact_force(&self, row: usize) -> f64 {
        let g = self.response.compliance[(row, row)];
        if g > 0.0 { self.sizes[row] / g } else { 0.0 }
    }
}

impl HeldContactEquations<'_> {
    /// Computes the accelerations at an instant and a state without contact forces, and the response to
    /// such forces.
    ///
    /// # Errors
    /// [`Failure`] if the equations have no value at the state, or a permitted motion has no inertia.
    pub fn motion_without_contact_forces(&mut self, t: f64, y: &[f64]) -> Result<ContactFreeMotion, Failure> {
        let mut rates = vec![0.0; y.len()];
        self.rhs.rhs(t, y, &mut rates)?;
        let rows: ContactRates = self.contacts.rates(y);
        let accelerations = &rows.slopes * DVector::from_column_slice(&rates);
        let sizes = rows.slopes.abs() * DVector::from_column_slice(&rates).abs();
        let response = self.contacts.response(y, &rows)?;
        Ok(ContactFreeMotion { rates, accelerations, sizes, response })
    }

    /// Computes the forces of the held contacts along the gap and slip directions of all contacts.
    ///
    /// # Errors
    /// [`Failure`] if a force is not finite.
    pub fn forces(&self, free: &ContactFreeMotion) -> Result<DVector<f64>, Failure> {
        self.forces_of(free, self.kept)
    }

    /// Computes the forces of the contacts `kept`, as if these were held closed, along the gap and slip
    /// directions of all contacts.
    ///
    /// # Errors
    /// [`Failure`] if a force is not finite.
    pub fn forces_of(&self, free: &ContactFreeMotion, kept: &HeldContacts) -> Result<DVector<f64>, Failure> {
        let (closed, rows) = self.contacts.closed_contact_system(&free.response, &kept.which);
        let some =
            closed.forces_in_contact_modes(&free.accelerations.select_rows(&rows), &kept.modes).ok_or_else(|| {
                Failure {
                    code: "not-finite",
                    message: "the forces of contacts that are held are not finite".to_owned(),
                }
            })?;
        Ok(self.contacts.spread_over_contact_rows(&some, &rows))
    }

    /// Normal force of a held contact plus a margin for rounding, in N if the gap is in m. Negative if
    /// the contact would pull; NaN if no force can be computed.
    pub fn normal_force(&mut self, contact: usize, t: f64, y: &[f64]) -> f64 {
        let row = self.contacts.rows[contact][0];
        let force = self
            .motion_without_contact_forces(t, y)
            .and_then(|free| Ok(self.forces(&free)?[row] + ROUNDED * free.reference_contact_force(row)));
        force.unwrap_or(f64::NAN)
    }

    /// Friction limit of a sticking contact, μ times the normal force, minus the size of its tangential
    /// force. Negative if the contact must slip; NaN if no force can be computed.
    pub fn friction_margin(&mut self, contact: usize, t: f64, y: &[f64]) -> f64 {
        let mu = self.contacts.friction(contact).unwrap_or(0.0);
        let forces = self.motion_without_contact_forces(t, y).and_then(|free| self.forces(&free));
        let rows = &self.contacts.rows[contact];
        forces.map_or(f64::NAN, |forces| mu * forces[rows[0]] - forces[rows[1]].abs())
    }

    /// Determinant of the linear system for the forces of the held contacts, relative to its value
    /// without slip. NaN if the system cannot be computed.
    pub fn contact_force_determinant(&self, y: &[f64]) -> f64 {
        let response = self.contacts.response(y, &self.contacts.rates(y));
        let of = |response: ImpulseResponse| {
            self.contacts
                .closed_contact_system(&response, &self.kept.which)
                .0
                .contact_force_determinant(&self.kept.modes)
        };
        response.map_or(f64::NAN, of)
    }

    /// Power of the contact forces at a state, W. It is the power of moving obstacles plus the power of
    /// friction. NaN if no force can be computed.
    pub fn contact_force_power(&mut self, t: f64, y: &[f64]) -> f64 {
        let power = self.motion_without_contact_forces(t, y).and_then(|free| {
            let forces = self.forces(&free)?;
            let rows = self.kept.slipping().map(|(at, _)| self.contacts.rows[at][1]);
            let lost: f64 = rows.map(|row| forces[row] * free.response.velocities[row]).sum();
            Ok(lost - forces.dot(&free.response.driven))
        });
        power.unwrap_or(f64::NAN)
    }

    /// Indices of the gap and slip velocities that the contact forces hold at zero.
    pub fn rows(&self) -> Vec<usize> {
        self.kept.rows(self.contacts)
    }
}

impl RightHandSide<f64> for HeldContactEquations<'_> {
    fn rhs(&mut self, t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
        if self.kept.is_empty() {
            return self.rhs.rhs(t, y, dydt);
        }
        let free = self.motion_without_contact_forces(t, y)?;
        let changes = &free.response.changes * self.forces(&free)?;
        dydt.copy_from_slice(&free.rates);
        let of_v = dydt.len() - changes.len();
        for (rate, change) in dydt[of_v..].iter_mut().zip(changes.iter()) {
            *rate += change;
        }
        Ok(())
    }

    fn jacobian(&mut self, t: f64, y: &[f64], out: &mut [f64]) -> Option<Result<(), Failure>> {
        if self.kept.is_empty() { self.rhs.jacobian(t, y, out) } else { None }
    }

    fn taylor(&mut self, t: f64, order: usize, x: &mut [f64]) -> Option<Result<(), Failure>> {
        if self.kept.is_empty() { self.rhs.taylor(t, order, x) } else { None }
    }

    fn divisor_count(&self) -> usize {
        self.rhs.divisor_count()
    }

    fn divisors(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
        self.rhs.divisors(t, y, out);
    }

    fn divisor_name(&self, at: usize) -> String {
        self.rhs.divisor_name(at)
    }

    fn constraint_count(&self) -> usize {
        self.rhs.constraint_count() + self.kept.which.len() + self.rows().len()
    }

    fn constraints(&mut self, t: f64, y: &[f64], values: &mut [f64], slopes: &mut [f64]) {
        let (own, size) = (self.rhs.constraint_count(), y.len());
        self.rhs.constraints(t, y, &mut values[..own], &mut slopes[..own * size]);
        if self.kept.is_empty() {
            return;
        }
        let (gaps, rates) = (self.contacts.gap_slopes(y), self.contacts.rates(y));
        let mut next = own;
        for at in &self.kept.which {
            values[next] = self.contacts.gap(*at, y);
            let row = &mut slopes[next * size..(next + 1) * size];
            row.fill(0.0);
            row.iter_mut().zip(gaps.row(*at).iter()).for_each(|(slope, gap)| *slope = *gap);
            next += 1;
        }
        for at in self.rows() {
            values[next] = rates.values[at];
            let row = &mut slopes[next * size..(next + 1) * size];
            row.iter_mut().zip(rates.slopes.row(at).iter()).for_each(|(slope, rate)| *slope = *rate);
            next += 1;
        }
    }

    fn inertia(&mut self, t: f64, y: &[f64], out: &mut Vec<f64>) -> bool {
        self.rhs.inertia(t, y, out)
    }

    fn avoids_end_of_step(&mut self, t: f64, y: &[f64]) -> bool {
        self.rhs.avoids_end_of_step(t, y)
    }
}
