//! Equations of motion with the forces of held contacts, and products with the transposed derivatives
//! of these equations.
//!
//! Forces Λ along the gap and slip directions ("rows") of contacts change the rates of the motion
//! variables by B a. B is the derivative of the motion variables by the generalized speeds. The
//! equations are M a = Wᵀ Λ, and W a + c = 0 along the held rows. Here c = S ẏ, with the rates ẏ
//! without contact forces, and S is the derivative of the row velocities by the state.
//!
//! Let w be weights of the added rates, and b = Bᵀ w. Let `A = W M⁻¹ Wᵀ E`, where E adds the friction
//! of slipping contacts. The derivative of w·B a is a sum of derivatives at constant a and Λ:
//! `z₁·∂(M a − Wᵀ Λ) + z₂·∂(W a + c) + w·∂(B a)`. Here `Aᵀ z₂ = −Eᵀ W M⁻¹ b` and
//! `z₁ = −M⁻¹ (b + Wᵀ z₂)`.
//!
//! Each term is computed by running a tape backwards. The tape of the kinetic energy, a quadratic
//! form, gives M x·z. The tape of the motion variables gives B x. The tape of the row velocities gives
//! W and S.

use super::transposed_products::{BackwardTapes, TransposedProducts};
use crate::error::{Error, refused_scene_error};
use crate::preparation::impacts::{ContactOperators, HeldContactEquations, HeldContacts, SceneContacts};
use crate::preparation::problem::Problem;
use crate::studies::sensitivity::contacts::held_directions::HeldDirections;
use nalgebra::DVector;
use tripos_derive::algebra::value::tape::{BackwardWorkspace, Tape};
use tripos_sim::{Failure, ProductSums, RightHandSide, TransposedRightHandSide};

/// Equations of motion for a backward sweep. They contain the forces of held contacts if there are any.
pub struct TransposedMotion<'a> {
    /// Equations of motion without contact forces.
    free: TransposedProducts<'a>,
    /// Held contacts, prepared for transposed products; `None` if no contact is held closed.
    held: Option<TransposedHeldContacts<'a>>,
    /// Number of parameters, plus two coefficients (restitution and friction) for each contact of the
    /// scene.
    parameters: usize,
}

/// All contacts of a scene, and the list of the contacts that are held closed.
#[derive(Clone, Copy)]
pub struct ContactsAndHeld<'a> {
    /// All contacts of the scene.
    pub contacts: &'a SceneContacts<'a>,
    /// Contacts that are held closed, each with its mode.
    pub kept: &'a HeldContacts,
}

/// Contacts that are held closed, prepared for products with the transposed derivatives of their forces.
struct TransposedHeldContacts<'a> {
    /// Equations of motion with the forces of the held contacts.
    held: HeldContactEquations<'a>,
    /// Held gap and slip directions, and the friction of slipping contacts.
    grip: HeldDirections,
    /// Evaluator that runs tapes backwards.
    weights: TransposedContactTapes<'a>,
}

/// Evaluator that runs tapes backwards. It adds the derivatives of weighted sums of tape outputs to
/// given sums.
struct TransposedContactTapes<'a> {
    /// Tapes of the equations of motion.
    tapes: &'a BackwardTapes,
    /// Values of the parameters.
    parameters: &'a [f64],
    /// Working memory of the backward evaluation.
    room: BackwardWorkspace,
    /// Working memory for the derivatives by all inputs of a tape.
    slopes: Vec<f64>,
}

impl<'a> TransposedMotion<'a> {
    /// Prepares the equations of a problem, with the forces of held contacts if `contacts` is given. The
    /// derivatives by parameters then have more entries: by the coefficients of restitution, then by the
    /// coefficients of friction.
    ///
    /// # Errors
    /// [`Error::Request`] if the accelerations are not eliminated.
    pub fn new(
        problem: &'a Problem<'_>,
        tapes: &'a BackwardTapes,
        contacts: Option<ContactsAndHeld<'a>>,
    ) -> Result<Self, Error> {
        let free = TransposedProducts::new(problem, tapes)?;
        let count = contacts.map_or(0, |held| held.contacts.impacts.len());
        let parameters = problem.scene.parameters.as_slice();
        let held = contacts.filter(|held| !held.kept.is_empty()).map(|ContactsAndHeld { contacts, kept }| {
            let rhs = problem.right_hand_side().map_err(|error| refused_scene_error(problem.scene, &error))?;
            let weights =
                TransposedContactTapes { tapes, parameters, room: BackwardWorkspace::default(), slopes: Vec::new() };
            Ok::<_, Error>(TransposedHeldContacts {
                held: HeldContactEquations { rhs, contacts, kept },
                grip: HeldDirections::of_held_contacts(contacts, kept),
                weights,
            })
        });
        Ok(Self { free, held: held.transpose()?, parameters: parameters.len() + 2 * count })
    }
}

impl RightHandSide<f64> for TransposedMotion<'_> {
    fn rhs(&mut self, t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
        match &mut self.held {
            Some(holding) => holding.held.rhs(t, y, dydt),
            None => self.free.rhs(t, y, dydt),
        }
    }

    fn constraint_count(&self) -> usize {
        self.held.as_ref().map_or_else(|| self.free.constraint_count(), |holding| holding.held.constraint_count())
    }

    fn constraints(&mut self, t: f64, y: &[f64], values: &mut [f64], slopes: &mut [f64]) {
        match &mut self.held {
            Some(holding) => holding.held.constraints(t, y, values, slopes),
            None => self.free.constraints(t, y, values, slopes),
        }
    }

    fn inertia(&mut self, t: f64, y: &[f64], out: &mut Vec<f64>) -> bool {
        self.free.inertia(t, y, out)
    }
}

impl TransposedRightHandSide for TransposedMotion<'_> {
    fn parameter_count(&self) -> usize {
        self.parameters
    }

    fn add_transposed_product(
        &mut self,
        t: f64,
        y: &[f64],
        weights: &[f64],
        (state, parameters): ProductSums<'_>,
    ) -> Result<(), Failure> {
        let Some(holding) = &mut self.held else {
            return self.free.add_transposed_product(t, y, weights, (state, parameters));
        };
        let weights = holding.pull(t, y, weights, (&mut *state, &mut *parameters))?;
        self.free.add_transposed_product(t, y, &weights, (state, parameters))
    }

    fn add_transposed_constraint_product(
        &mut self,
        t: f64,
        y: &[f64],
        weights: &[f64],
        (state, parameters): ProductSums<'_>,
    ) -> Result<(), Failure> {
        let (own, rest) = weights.split_at(self.free.constraint_count());
        self.free.add_transposed_constraint_product(t, y, own, (&mut *state, &mut *parameters))?;
        let Some(TransposedHeldContacts { held, grip, weights }) = &mut self.held else { return Ok(()) };
        let (contacts, gaps) = (held.contacts, held.kept.which.len());
        let q = &y[..contacts.system.lengths().coordinates];
        for (at, weight) in held.kept.which.iter().zip(rest) {
            weights.pull(&contacts.gaps[*at].0, q, &[*weight], (&mut *state, &mut *parameters));
        }
        let mut of_rates = vec![0.0; contacts.rates.outputs()];
        grip.rows.iter().zip(&rest[gaps..]).for_each(|(row, weight)| of_rates[*row] += weight);
        weights.pull(&contacts.rates, y, &of_rates, (state, parameters));
        Ok(())
    }
}

impl TransposedHeldContacts<'_> {
    /// Adds the derivatives of the rates that contact forces cause, weighted by `weights`, to the sums
    /// `state` and `parameters`. Returns the weights of the rates without contact forces.
    ///
    /// # Errors
    /// `Failure` if the forces or their derivatives are not finite.
    fn pull(
        &mut self,
        t: f64,
        y: &[f64],
        weights: &[f64],
        (state, parameters): ProductSums<'_>,
    ) -> Result<Vec<f64>, Failure> {
        let contacts = self.held.contacts;
        let free = self.held.motion_without_contact_forces(t, y)?;
        let forces = self.held.forces(&free)?;
        let rates = contacts.rates(y);
        let ContactOperators { basis, of_u, inertia } = contacts.operators(y, &rates)?;
        let (n, rows) = (y.len() - basis.nrows(), &self.grip.rows);
        let of_rates = DVector::from_column_slice(&weights[n..]);
        let a = inertia.solve(&(of_u.transpose() * &forces));
        let b = basis.transpose() * &of_rates;
        let moved = inertia.solve(&b);
        let along = self.grip.held_force_spread(contacts.count).transpose() * (&of_u * &moved);
        let system = self.grip.system(&free.response.compliance);
        let z2 = system.solve_transposed(&along).ok_or_else(|| Failure {
            code: "not-finite",
            message: "the forces of contacts that are held have no finite derivative".to_owned(),
        })?;
        let z2 = rows.iter().zip(z2.iter()).fold(DVector::zeros(contacts.count), |mut all, (row, z)| {
            all[*row] = *z;
            all
        });
        let z1 = -(moved + inertia.solve(&(of_u.transpose() * &z2)));
        let (of_a, of_z) = (&basis * &a, &basis * &z1);
        let slopes = &rates.slopes;
        let mut of_contacts = vec![0.0; contacts.count * (1 + y.len())];
        let mut left = weights.to_vec();
        for row in 0..contacts.count {
            let own = &mut of_contacts[contacts.count + row * y.len()..][..y.len()];
            for (j, own) in own.iter_mut().enumerate() {
                // First the part of S in c = S ẏ, then the parts of W in −z₁·Wᵀ Λ and in z₂·W a.
                *own = z2[row] * free.rates[j];
                left[j] += z2[row] * slopes[(row, j)];
                if let Some(j) = j.checked_sub(n) {
                    *own += z2[row] * of_a[j] - forces[row] * of_z[j];
                }
            }
        }
        let of_v = slopes.columns(n, basis.nrows());
        let of_motions = [(&a, of_rates + of_v.transpose() * &z2), (&z1, -(of_v.transpose() * &forces))];
        for slip in &self.grip.slips {
            // Derivative of M a − Wᵀ Λ by a coefficient of friction: s Λₙ times the row of W that belongs to
            // the slip velocity.
            let first = parameters.len() - contacts.impacts.len();
            parameters[first + slip.contact] +=
                z1.dot(&of_u.row(slip.along).transpose()) * slip.way * forces[slip.normal];
        }
        let to = &mut (state, parameters);
        let weights = &mut self.weights;
        weights.pull(&contacts.rates, y, &of_contacts, (&mut *to.0, &mut *to.1));
        for (x, by) in of_motions {
            weights.pull_motion(&y[..n], x, &by, (&mut *to.0, &mut *to.1));
        }
        weights.pull_inertia(&y[..n], &a, &z1, (&mut *to.0, &mut *to.1));
        Ok(left)
    }
}

impl TransposedContactTapes<'_> {
    /// Adds the derivatives of a weighted sum of a tape's outputs to the sums `state` and `parameters`.
    /// The inputs of the tape are the parameters and the state `y`.
    fn pull(&mut self, tape: &Tape, y: &[f64], weights: &[f64], (state, parameters): ProductSums<'_>) {
        self.add_pulled_weights(tape, y, &[], weights, (state, parameters));
    }

    /// Adds the derivatives of a weighted sum of a tape's outputs to the sums `state` and `parameters`.
    /// Returns the derivatives by the values `more`, the last inputs of the tape.
    fn add_pulled_weights(
        &mut self,
        tape: &Tape,
        y: &[f64],
        more: &[f64],
        weights: &[f64],
        (state, parameters): ProductSums<'_>,
    ) -> Vec<f64> {
        let inputs = [self.parameters, y, more].concat();
        self.slopes.clear();
        self.slopes.resize(inputs.len(), 0.0);
        tape.backward_pass(&inputs, weights, &mut self.room, &mut self.slopes);
        let (by_parameters, rest) = self.slopes.split_at(self.parameters.len());
        let (by_state, rest) = rest.split_at(y.len());
        parameters.iter_mut().zip(by_parameters).for_each(|(sum, share)| *sum += share);
        state.iter_mut().zip(by_state).for_each(|(sum, share)| *sum += share);
        rest.to_vec()
    }

    /// Adds the derivatives of w·B x to the sums `state` and `parameters`. B x are the motion variables at
    /// the speeds x, minus the motion variables at zero speeds.
    fn pull_motion(&mut self, q: &[f64], x: &DVector<f64>, w: &DVector<f64>, (state, parameters): ProductSums<'_>) {
        let tapes = self.tapes;
        let still = vec![0.0; x.len()];
        self.add_pulled_weights(&tapes.motions, q, x.as_slice(), w.as_slice(), (&mut *state, &mut *parameters));
        self.add_pulled_weights(&tapes.motions, q, &still, (-w).as_slice(), (state, parameters));
    }

    /// Adds the derivatives of z·M x = T(x + z) − T(x) − T(z) + T(0) to the sums `state` and `parameters`,
    /// where T is the kinetic energy. z is first scaled to the size of x.
    fn pull_inertia(&mut self, q: &[f64], x: &DVector<f64>, z: &DVector<f64>, (state, parameters): ProductSums<'_>) {
        let (size, own) = (x.norm(), z.norm());
        if !(size > 0.0 && own > 0.0) {
            return;
        }
        let (z, unit) = (z * (size / own), own / size);
        let tapes = self.tapes;
        let nothing = DVector::zeros(x.len());
        for (u, sign) in [(x + &z, unit), (x.clone(), -unit), (z, -unit), (nothing, unit)] {
            let mut v = vec![0.0; tapes.motions.outputs()];
            let inputs = [self.parameters, q, u.as_slice()].concat();
            v.copy_from_slice(&tapes.motions.evaluate(&inputs));
            let by_v = self.add_pulled_weights(&tapes.energy, q, &v, &[sign], (&mut *state, &mut *parameters));
            self.add_pulled_weights(&tapes.motions, q, u.as_slice(), &by_v, (&mut *state, &mut *parameters));
        }
    }
}
