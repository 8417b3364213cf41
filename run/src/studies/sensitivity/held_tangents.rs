//! Equations of motion with held contacts, in numbers that carry derivatives ("slopes").
//!
//! Invariant: the values are those of [`crate::preparation::impacts::HeldContactEquations`], bit by
//! bit. The slopes of the contact forces follow from the linear system for these forces
//! ([`crate::studies::sensitivity::contacts::precise_contacts`]).

use super::contacts::contact_history::{ContactHistory, end_derivatives};
use super::contacts::held_directions::HeldDirections;
use super::contacts::precise_contacts::{
    ActingContacts, ContactForceDerivative, ForceFreeMotion, ParameterStateDirection, PreciseContacts,
};
use super::varied_start::VariedStart;
use crate::preparation::impacts::HeldContactEquations;
use std::cell::RefCell;
use tripos_derive::algebra::value::tape::Tape;
use tripos_sim::{DynamicsWithTangents, Failure, RightHandSide};
use tripos_traits::{Real, Scalar, Tangent};

/// Gaps of contacts, and their gap and slip velocities, as tapes in numbers with `K` slopes.
pub struct ContactTapes<const K: usize> {
    /// Tapes of the gap of each contact. Inputs: parameters, then coordinates.
    pub gaps: Vec<Tape<Tangent<K>>>,
    /// Tape whose first values are the gap and slip velocities of all contacts. Inputs: parameters,
    /// then state.
    pub rates: Tape<Tangent<K>>,
}

/// Equations of motion with the forces of held contacts, in numbers with `K` slopes (derivatives).
pub struct HeldTangents<'a, const K: usize> {
    /// Equations of motion without contact forces, in numbers with slopes.
    pub rhs: DynamicsWithTangents<'a, K>,
    /// Equations of motion with the forces of held contacts, in double precision.
    pub held: HeldContactEquations<'a>,
    /// Contacts of the scene, computed to 32 digits, for derivatives.
    pub wide: &'a PreciseContacts<'a>,
    /// Gaps of the contacts, and their gap and slip velocities, as tapes with slopes.
    pub tapes: &'a ContactTapes<K>,
    /// Values of the parameters, with their slopes by each varied number.
    pub parameters: &'a [Tangent<K>],
    /// Varied numbers, with the derivatives of parameters and coefficients by each.
    pub seeds: &'a [VariedStart],
    /// Record in which early ends of derivatives are entered.
    pub history: &'a RefCell<ContactHistory>,
}

/// Rounds a state to doubles. The slopes of its numbers are dropped.
pub fn round_to_doubles<S: Real>(y: &[S]) -> Vec<f64> {
    y.iter().map(|y| y.to_f64()).collect()
}

/// Slopes of a state by the varied number with the index `at`.
pub fn slopes<S: Real>(y: &[S], at: usize) -> Vec<f64> {
    y.iter().map(|y| y.slope(at)).collect()
}

impl<const K: usize> HeldTangents<'_, K> {
    /// Adds the forces of held contacts, with their slopes, to the rates `dydt`.
    ///
    /// # Errors
    /// `Failure` if a force is not finite. A missing derivative of a force is no failure: it ends the
    /// derivatives.
    fn add_contact_forces(&mut self, t: f64, y: &[Tangent<K>], dydt: &mut [Tangent<K>]) -> Result<(), Failure> {
        let state = round_to_doubles(y);
        let free = self.held.motion_without_contact_forces(t, &state)?;
        let forces = self.held.forces(&free)?;
        let changes = &free.response.changes * &forces;
        let contacts = self.held.contacts;
        let operators = contacts.operators(&state, &contacts.rates(&state))?;
        let grip = HeldDirections::of_held_contacts(contacts, self.held.kept);
        let acting = ActingContacts { y: &state, operators: &operators, impulses: &forces, grip: &grip };
        let first = dydt.len() - changes.len();
        for (k, seed) in self.seeds.iter().enumerate() {
            let (by, along) = (slopes(dydt, k), slopes(y, k));
            let direction = ParameterStateDirection { parameters: &seed.parameters, state: &along };
            let without = ForceFreeMotion::Accelerate { rates: &free.rates, by: &by };
            let given = grip.friction_by_coefficients(&seed.frictions, &forces);
            let change = self.wide.contact_force_derivative(&acting, &without, direction, &given);
            match change.map_err(|failure| failure.message).and_then(ContactForceDerivative::require_common_motion) {
                Ok(change) => {
                    let more = dydt[first..].iter_mut().zip(change.variables.iter());
                    more.for_each(|(rate, more)| *rate = rate.turned(k, *more));
                }
                Err(why) => end_derivatives(self.history, k, t, why),
            }
        }
        for (rate, change) in dydt[first..].iter_mut().zip(changes.iter()) {
            rate.value += change;
        }
        Ok(())
    }

    /// Sets the slopes of the constraint values that belong to held contacts. These values begin at the
    /// index `own` of `values`: first the gaps, then the velocities.
    fn set_constraint_slopes(&self, own: usize, y: &[Tangent<K>], values: &mut [Tangent<K>]) {
        let n = y.len() - self.held.contacts.system.lengths().variables;
        let of_gaps: Vec<Tangent<K>> = [self.parameters, &y[..n]].concat();
        let of_rates: Vec<Tangent<K>> = [self.parameters, y].concat();
        let gaps = self.held.kept.which.iter().map(|at| self.tapes.gaps[*at].evaluate(&of_gaps)[0]);
        let velocities = self.tapes.rates.evaluate(&of_rates);
        let rates = self.held.rows().into_iter().map(|row| velocities[row]);
        for (value, tapes) in values[own..].iter_mut().zip(gaps.chain(rates)) {
            value.slopes = tapes.slopes;
        }
    }
}

impl<const K: usize> RightHandSide<Tangent<K>> for HeldTangents<'_, K> {
    fn rhs(&mut self, t: f64, y: &[Tangent<K>], dydt: &mut [Tangent<K>]) -> Result<(), Failure> {
        self.rhs.rhs(t, y, dydt)?;
        if self.held.kept.is_empty() { Ok(()) } else { self.add_contact_forces(t, y, dydt) }
    }

    fn jacobian(&mut self, t: f64, y: &[Tangent<K>], out: &mut [Tangent<K>]) -> Option<Result<(), Failure>> {
        if self.held.kept.is_empty() { self.rhs.jacobian(t, y, out) } else { None }
    }

    fn taylor(&mut self, t: f64, order: usize, x: &mut [Tangent<K>]) -> Option<Result<(), Failure>> {
        if self.held.kept.is_empty() { self.rhs.taylor(t, order, x) } else { None }
    }

    fn divisor_count(&self) -> usize {
        self.rhs.divisor_count()
    }

    fn divisors(&mut self, t: f64, y: &[Tangent<K>], out: &mut [Tangent<K>]) {
        self.rhs.divisors(t, y, out);
    }

    fn divisor_name(&self, at: usize) -> String {
        self.rhs.divisor_name(at)
    }

    fn constraint_count(&self) -> usize {
        self.held.constraint_count()
    }

    fn constraints(&mut self, t: f64, y: &[Tangent<K>], out: &mut [Tangent<K>], of_state: &mut [Tangent<K>]) {
        let (own, size) = (self.rhs.constraint_count(), y.len());
        self.rhs.constraints(t, y, &mut out[..own], &mut of_state[..own * size]);
        if self.held.kept.is_empty() {
            return;
        }
        let (mut plain, mut plain_slopes) = (vec![0.0; out.len()], vec![0.0; of_state.len()]);
        self.held.constraints(t, &round_to_doubles(y), &mut plain, &mut plain_slopes);
        let constants = |to: &mut [Tangent<K>], from: &[f64]| {
            to.iter_mut().zip(from).for_each(|(to, from)| *to = Tangent::from_f64(*from));
        };
        constants(&mut out[own..], &plain[own..]);
        constants(&mut of_state[own * size..], &plain_slopes[own * size..]);
        self.set_constraint_slopes(own, y, out);
    }

    fn inertia(&mut self, t: f64, y: &[Tangent<K>], out: &mut Vec<f64>) -> bool {
        self.rhs.inertia(t, y, out)
    }

    fn avoids_end_of_step(&mut self, t: f64, y: &[Tangent<K>]) -> bool {
        self.held.avoids_end_of_step(t, &round_to_doubles(y))
    }
}
