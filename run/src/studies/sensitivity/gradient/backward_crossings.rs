//! Impacts and other changes of contacts in the backward sweep. The sweep computes a gradient from the
//! end of a run to its start.

use super::recorded_steps::RecordedPart;
use crate::preparation::impacts::{ContactCrossing, HeldContacts, SceneContacts};
use crate::preparation::problem::Problem;
use crate::studies::sensitivity::contacts::contact_history::DerivativeEnd;
use crate::studies::sensitivity::contacts::crossing_derivatives::CrossingDerivatives;
use crate::studies::sensitivity::contacts::held_contact_forces::VariedNumber;
use crate::studies::sensitivity::contacts::precise_contacts::{ParameterStateDirection, PreciseContacts};
use crate::studies::sensitivity::corners::check_no_corner;
use crate::studies::sensitivity::equations_with_slopes::SlopeEquations;
use crate::studies::sensitivity::slope_carrier::rates_along;
use tripos_sim::{Corner, ProductSums};

/// Contacts of a scene, prepared for derivatives across their changes in a backward sweep.
pub struct BackwardCrossings<'a> {
    /// Scene with its equations of motion.
    pub problem: &'a Problem<'a>,
    /// Contacts in double precision.
    pub contacts: &'a SceneContacts<'a>,
    /// Contacts in 32 digits, for differences.
    pub wide: PreciseContacts<'a>,
    /// Equations of motion that also compute derivatives of the rates.
    pub equations: &'a SlopeEquations,
    /// Instants at which the equations have a jump or a kink, as in a prescribed motion.
    pub corners: &'a [Corner],
}

impl BackwardCrossings<'_> {
    /// Prepares a change of contacts for derivatives, and applies the function `of` to it.
    ///
    /// # Errors
    /// [`DerivativeEnd`] with the instant and the reason if the derivative does not exist.
    pub fn with_crossing<T>(
        &self,
        crossing: &ContactCrossing<'_>,
        of: impl FnOnce(&CrossingDerivatives<'_>) -> Result<T, String>,
    ) -> Result<T, DerivativeEnd> {
        let flow = |kept: &HeldContacts, t: f64, y: &[f64]| self.problem.rates_with_contacts(self.contacts, kept, t, y);
        let along = |y: &[f64], direction: ParameterStateDirection<'_>| {
            rates_along(self.problem, self.equations.rates_with_one_slope().0, y, direction)
        };
        let crossed = check_no_corner(self.corners, crossing);
        let crossed = crossed.and_then(|()| CrossingDerivatives::new(&self.wide, crossing, &along, &flow));
        let known = crossed.and_then(|crossed| of(&crossed));
        known.map_err(|why| DerivativeEnd { t: crossing.t, why })
    }

    /// Goes back across the change of contacts with which a part of a run begins. Replaces the weights of
    /// the state after the change by the weights of the state before it. Adds the contributions of the
    /// parameters and coefficients to their sums. Returns true if the derivative by each varied number
    /// must be checked.
    ///
    /// # Errors
    /// [`DerivativeEnd`] with the instant and the reason if no derivative exists.
    pub fn pull_across_crossing(
        &self,
        part: &RecordedPart,
        (state, parameters): ProductSums<'_>,
    ) -> Result<bool, DerivativeEnd> {
        let Some(crossing) = part.crossing() else { return Ok(false) };
        self.with_crossing(&crossing, |crossed| {
            let after = state.to_vec();
            let (p, c) = (self.contacts.parameters.len(), self.contacts.impacts.len());
            let still = [vec![0.0; state.len()], vec![0.0; p], vec![0.0; c], vec![0.0; c]];
            let share = |kind: usize, at: usize| {
                let mut one = still.clone();
                one[kind][at] = 1.0;
                let [along, parameters, restitutions, frictions] = &one;
                let varied = VariedNumber { name: "", parameters, restitutions, frictions };
                let slopes = crossed.unchecked_slopes_after_crossing(&varied, along)?.slopes;
                Ok::<_, String>(slopes.iter().zip(&after).map(|(slope, weight)| slope * weight).sum::<f64>())
            };
            for (at, own) in state.iter_mut().enumerate() {
                *own = share(0, at)?;
            }
            let of_parameters =
                (0..p).map(|at| (1, at)).chain((0..c).map(|at| (2, at))).chain((0..c).map(|at| (3, at)));
            for (sum, (kind, at)) in parameters.iter_mut().zip(of_parameters) {
                *sum += share(kind, at)?;
            }
            Ok(crossed.needs_checks())
        })
    }
}
