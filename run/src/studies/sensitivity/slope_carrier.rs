//! Runs with contacts in numbers that carry derivatives ("slopes"), by parameters and by numbers of the
//! start.

use super::contacts::contact_history::{ContactChangeInstant, ContactHistory, end_derivatives};
use super::contacts::crossing_derivatives::CrossingDerivatives;
use super::contacts::precise_contacts::{ParameterStateDirection, PreciseContacts};
use super::corners::check_no_corner;
use super::held_tangents::{ContactTapes, HeldTangents, round_to_doubles, slopes};
use super::varied_start::VariedStart;
use crate::preparation::impacts::{
    ContactCrossing, GapMinimum, HeldContactEquations, HeldContacts, NumberCarrier, SceneContacts,
};
use crate::preparation::problem::Problem;
use std::cell::RefCell;
use tripos_sim::{Corner, DynamicsWithTangents, RightHandSide, SimError};
use tripos_traits::{Flow, Real, Scalar, Series, Tangent};

/// Functions that compute the rates of a state with slopes (derivatives), and its Taylor coefficients
/// with slopes; `None` if these are not available.
pub type SlopeFunctions<'a, const K: usize> = (&'a dyn Flow<Tangent<K>>, Option<&'a dyn Series<Tangent<K>>>);

/// Carrier that computes runs with contacts in numbers with slopes, by at most `K` varied numbers.
pub struct SlopeCarrier<'a, const K: usize> {
    /// Scene with its equations of motion.
    pub problem: &'a Problem<'a>,
    /// Functions that compute rates with slopes, and Taylor coefficients with slopes if available.
    pub parts: SlopeFunctions<'a, K>,
    /// Values of the parameters, with their slopes by each varied number.
    pub parameters: &'a [Tangent<K>],
    /// Varied numbers, with the derivatives of the start and the parameters by each number.
    pub seeds: &'a [VariedStart],
    /// Instants at which a prescribed motion or force has a kink or a jump.
    pub corners: &'a [Corner],
    /// Contacts of the scene in double precision.
    pub contacts: &'a SceneContacts<'a>,
    /// Contacts of the scene, computed to 32 digits, for derivatives.
    wide: PreciseContacts<'a>,
    /// Gaps of the contacts, and their gap and slip velocities, as tapes with slopes.
    tapes: ContactTapes<K>,
    /// Largest minimum of a gap that counts as touching, relative to the size of the gap's terms. `None`
    /// if minima are not watched.
    pub near: Option<f64>,
    /// Minima of gaps in time that are below the limit `near`.
    pub approaches: RefCell<Vec<GapMinimum>>,
    /// Changes of contacts so far, with the derivatives of their instants, and early ends of derivatives.
    pub history: RefCell<ContactHistory>,
}

impl<'a, const K: usize> SlopeCarrier<'a, K> {
    /// Prepares a run of a problem with contacts. A gap below `near`, relative to the size of its terms,
    /// counts as zero. Corners of the drive and touching gaps are ignored unless the fields `corners`
    /// and `near` are set afterwards.
    pub fn new(
        problem: &'a Problem<'a>,
        parts: SlopeFunctions<'a, K>,
        parameters: &'a [Tangent<K>],
        seeds: &'a [VariedStart],
        contacts: &'a SceneContacts<'a>,
        near: f64,
    ) -> Self {
        let wide = PreciseContacts::new(contacts, problem.code.extended(), near);
        let tapes =
            ContactTapes { gaps: contacts.gaps.iter().map(|(gap, _)| gap.to()).collect(), rates: contacts.rates.to() };
        let history = RefCell::new(ContactHistory::new(seeds.len()));
        let approaches = RefCell::new(Vec::new());
        Self { problem, parts, parameters, seeds, corners: &[], contacts, wide, tapes, near: None, approaches, history }
    }
}

/// Computes the derivative of the rates (q̇, v̇), without contact forces, at a state `y` along a direction
/// of parameters and state.
pub fn rates_along<const K: usize>(
    problem: &Problem<'_>,
    flow: &dyn Flow<Tangent<K>>,
    y: &[f64],
    direction: ParameterStateDirection<'_>,
) -> Vec<f64> {
    let along = |values: &[f64], by: &[f64]| -> Vec<Tangent<K>> {
        values.iter().zip(by).map(|(value, by)| Tangent::from_f64(*value).turned(0, *by)).collect()
    };
    let p = along(&problem.scene.parameters, direction.parameters);
    let y = along(y, direction.state);
    let (q, v) = y.split_at(problem.system().lengths().coordinates);
    let mut rates = vec![Tangent::from_f64(0.0); y.len()];
    let (q_dot, v_dot) = rates.split_at_mut(q.len());
    flow.rates(&p, q, v, q_dot, v_dot);
    slopes(&rates, 0)
}

impl<const K: usize> NumberCarrier<Tangent<K>> for SlopeCarrier<'_, K> {
    fn equations<'e>(&'e self, kept: &'e HeldContacts) -> Result<Box<dyn RightHandSide<Tangent<K>> + 'e>, SimError> {
        let rhs = DynamicsWithTangents::new(self.problem.system(), self.parts.0, self.parts.1, self.parameters);
        let unsolved = SimError::Option { name: "equations", must: "equations with eliminated accelerations" };
        let rhs = rhs.ok_or(unsolved)?;
        let held = HeldContactEquations { rhs: self.problem.right_hand_side()?, contacts: self.contacts, kept };
        let (wide, tapes, seeds) = (&self.wide, &self.tapes, self.seeds);
        Ok(Box::new(HeldTangents {
            rhs,
            held,
            wide,
            tapes,
            parameters: self.parameters,
            seeds,
            history: &self.history,
        }))
    }

    fn reported_gap_limit(&self) -> Option<f64> {
        self.near
    }

    fn record_gap_minimum(&self, approach: &GapMinimum) {
        self.approaches.borrow_mut().push(approach.clone());
    }

    fn state_after_crossing(&self, crossing: &ContactCrossing<'_>, before: &[Tangent<K>]) -> Vec<Tangent<K>> {
        if crossing.after.closed.is_empty() {
            return before.to_vec();
        }
        let flow = |kept: &HeldContacts, t: f64, y: &[f64]| self.problem.rates_with_contacts(self.contacts, kept, t, y);
        let along =
            |y: &[f64], direction: ParameterStateDirection<'_>| rates_along(self.problem, self.parts.0, y, direction);
        let crossed = check_no_corner(self.corners, crossing);
        let crossed = crossed.and_then(|()| CrossingDerivatives::new(&self.wide, crossing, &along, &flow));
        let mut after: Vec<Tangent<K>> = crossing.after.y.iter().map(|y| Tangent::from_f64(*y)).collect();
        let mut moves = Vec::new();
        for (k, seed) in self.seeds.iter().enumerate() {
            let found = match &crossed {
                Ok(crossed) => crossed.slopes_after_crossing(&seed.as_varied_number(), &slopes(before, k)),
                Err(message) => Err(message.clone()),
            };
            let over = self.history.borrow().endings[k].as_ref().map(|ending| ending.why.clone());
            let (later, list) = over.map_or(found, Err).unwrap_or_else(|why| {
                end_derivatives(&self.history, k, crossing.t, why);
                (f64::NAN, vec![0.0; after.len()])
            });
            moves.push(later);
            after.iter_mut().zip(list).for_each(|(y, slope)| *y = y.turned(k, slope));
        }
        let kept = crossing.after.kept.clone();
        self.history.borrow_mut().instants.push(ContactChangeInstant { t: crossing.t, moves, kept });
        debug_assert_eq!(round_to_doubles(&after), crossing.after.y);
        after
    }
}
