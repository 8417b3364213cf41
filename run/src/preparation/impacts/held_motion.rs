//! Motions in which contacts are held closed.
//!
//! The forces λ of held contacts keep the velocities along their rows at zero: G λ + a = 0, where a are the
//! accelerations along the rows without these forces. Where a contact slips, its row along the slip is released.
//! Friction enters the same system: −μ s times the force along the gap, with s the sign of the slip. The forces join
//! any equations, as v̇ + M⁻¹ Wᵀ λ. Each step ends on the contacts, as on any constraint.

use super::contacts::{Contacts, Rates, Response};
use super::held_contacts::HeldContacts;
use nalgebra::DVector;
use tripos_sim::{Failure, RightHandSide};

/// Equations of motion with the forces of contacts that are held.
pub struct Held<'a> {
    /// Equations of motion without the forces of contacts.
    pub rhs: Box<dyn RightHandSide<f64> + 'a>,
    pub contacts: &'a Contacts<'a>,
    /// Contacts that are held, with the mode of each.
    pub kept: &'a HeldContacts,
}

/// Motion of the contacts at a state without the forces of held contacts, and the response to forces.
pub struct Free {
    /// Rates of the state, ẏ, without the forces of contacts.
    pub rates: Vec<f64>,
    /// Accelerations along all rows of contacts, without the forces of contacts.
    pub accelerations: DVector<f64>,
    /// Sizes of the terms of each acceleration, added: a small fraction of this sum counts as zero.
    pub sizes: DVector<f64>,
    pub response: Response,
}

/// Forces below this fraction of [`Free::force_of_size`] count as rounding.
pub(super) const ROUNDED: f64 = 1e-12;

impl Free {
    /// Force that would cancel all terms of the acceleration along a row if the terms had one sign.
    pub fn force_of_size(&self, row: usize) -> f64 {
        let g = self.response.compliance[(row, row)];
        if g > 0.0 { self.sizes[row] / g } else { 0.0 }
    }
}

impl Held<'_> {
    /// Computes the motion of the contacts without their forces.
    ///
    /// # Errors
    /// [`Failure`] where the equations have no value.
    pub fn free(&mut self, t: f64, y: &[f64]) -> Result<Free, Failure> {
        let mut rates = vec![0.0; y.len()];
        self.rhs.rhs(t, y, &mut rates)?;
        let rows: Rates = self.contacts.rates(y);
        let accelerations = &rows.slopes * DVector::from_column_slice(&rates);
        let sizes = rows.slopes.abs() * DVector::from_column_slice(&rates).abs();
        let response = self.contacts.response(y, &rows)?;
        Ok(Free { rates, accelerations, sizes, response })
    }

    /// The forces of the held contacts along all rows.
    ///
    /// # Errors
    /// [`Failure`] where the forces are not finite.
    pub fn forces(&self, free: &Free) -> Result<DVector<f64>, Failure> {
        self.forces_of(free, self.kept)
    }

    /// The forces along all rows if these contacts are held.
    ///
    /// # Errors
    /// [`Failure`] where the forces are not finite.
    pub fn forces_of(&self, free: &Free, kept: &HeldContacts) -> Result<DVector<f64>, Failure> {
        let (closed, rows) = self.contacts.closed(&free.response, &kept.which);
        let some = closed.hold(&free.accelerations.select_rows(&rows), &kept.modes).ok_or_else(|| Failure {
            code: "not-finite",
            message: "the forces of contacts that are held are not finite".to_owned(),
        })?;
        Ok(self.contacts.spread(&some, &rows))
    }

    /// Force along the gap of a contact plus a margin for rounding, in N where the gap is in m. NaN where no force can
    /// be computed.
    pub fn normal(&mut self, contact: usize, t: f64, y: &[f64]) -> f64 {
        let row = self.contacts.rows[contact][0];
        let force = self.free(t, y).and_then(|free| Ok(self.forces(&free)?[row] + ROUNDED * free.force_of_size(row)));
        force.unwrap_or(f64::NAN)
    }

    /// Friction limit of a sticking contact minus the size of its force along the slip. NaN where no force can be
    /// computed.
    pub fn margin(&mut self, contact: usize, t: f64, y: &[f64]) -> f64 {
        let mu = self.contacts.friction(contact).unwrap_or(0.0);
        let forces = self.free(t, y).and_then(|free| self.forces(&free));
        let rows = &self.contacts.rows[contact];
        forces.map_or(f64::NAN, |forces| mu * forces[rows[0]] - forces[rows[1]].abs())
    }

    /// Determinant of the linear system for the forces of held contacts, relative to its value without slip. NaN where
    /// the system cannot be computed.
    pub fn determinant(&self, y: &[f64]) -> f64 {
        let response = self.contacts.response(y, &self.contacts.rates(y));
        let of = |response: Response| self.contacts.closed(&response, &self.kept.which).0.determinant(&self.kept.modes);
        response.map_or(f64::NAN, of)
    }

    /// Power of the forces of moving obstacles and of friction at a state, W. NaN where no force can be computed.
    pub fn power(&mut self, t: f64, y: &[f64]) -> f64 {
        let power = self.free(t, y).and_then(|free| {
            let forces = self.forces(&free)?;
            let rows = self.kept.slipping().map(|(at, _)| self.contacts.rows[at][1]);
            let lost: f64 = rows.map(|row| forces[row] * free.response.velocities[row]).sum();
            Ok(lost - forces.dot(&free.response.driven))
        });
        power.unwrap_or(f64::NAN)
    }

    /// Indices of the rows of contacts whose velocity is held at zero.
    pub fn rows(&self) -> Vec<usize> {
        self.kept.rows(self.contacts)
    }
}

impl RightHandSide<f64> for Held<'_> {
    fn rhs(&mut self, t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
        if self.kept.is_empty() {
            return self.rhs.rhs(t, y, dydt);
        }
        let free = self.free(t, y)?;
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

    fn avoids(&mut self, t: f64, y: &[f64]) -> bool {
        self.rhs.avoids(t, y)
    }
}
