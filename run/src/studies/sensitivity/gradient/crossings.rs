//! Impacts and other changes of contacts in the backward sweep that computes a gradient.

use super::recorded_steps::Part;
use crate::preparation::impacts::{Contacts, Crossing, HeldContacts};
use crate::preparation::problem::Problem;
use crate::studies::sensitivity::bounce::{meets_no_corner, rates_along};
use crate::studies::sensitivity::contacts::{Direction, Wide};
use crate::studies::sensitivity::equations::Equations;
use crate::studies::sensitivity::forces::Varied;
use crate::studies::sensitivity::history::Ending;
use crate::studies::sensitivity::jumps::Crossed;
use tripos_sim::{Corner, Pulled};

/// Contacts of a scene, with the data for derivatives across their changes in a backward sweep.
pub struct Crossings<'a> {
    /// Scene with its equations of motion.
    pub problem: &'a Problem<'a>,
    /// Contacts in double precision.
    pub contacts: &'a Contacts<'a>,
    /// Contacts in 32 digits, for differences.
    pub wide: Wide<'a>,
    /// Equations of motion that also compute derivatives of the rates.
    pub equations: &'a Equations,
    /// Instants at which the equations have a jump or a kink, as in a prescribed motion.
    pub corners: &'a [Corner],
}

impl Crossings<'_> {
    /// Prepares a change of contacts for derivatives and applies the function `of` to it.
    ///
    /// # Errors
    /// [`Ending`] with the instant and the reason if there is no derivative.
    pub fn at<T>(
        &self,
        crossing: &Crossing<'_>,
        of: impl FnOnce(&Crossed<'_>) -> Result<T, String>,
    ) -> Result<T, Ending> {
        let flow = |kept: &HeldContacts, t: f64, y: &[f64]| self.problem.flow(self.contacts, kept, t, y);
        let along =
            |y: &[f64], direction: Direction<'_>| rates_along(self.problem, self.equations.one().0, y, direction);
        let crossed = meets_no_corner(self.corners, crossing);
        let crossed = crossed.and_then(|()| Crossed::new(&self.wide, crossing, &along, &flow));
        let known = crossed.and_then(|crossed| of(&crossed));
        known.map_err(|why| Ending { t: crossing.t, why })
    }

    /// Goes back across the change of contacts with which a part of a run begins. Replaces the weights
    /// of the state after the change by those of the state before, and adds the shares of parameters
    /// and coefficients. Returns true if each varied number must be checked for a derivative.
    ///
    /// # Errors
    /// [`Ending`] with the instant and the reason if there is no derivative by any number.
    pub fn back(&self, part: &Part, (state, parameters): Pulled<'_>) -> Result<bool, Ending> {
        let Some(crossing) = part.crossing() else { return Ok(false) };
        self.at(&crossing, |crossed| {
            let after = state.to_vec();
            let (p, c) = (self.contacts.parameters.len(), self.contacts.impacts.len());
            let still = [vec![0.0; state.len()], vec![0.0; p], vec![0.0; c], vec![0.0; c]];
            let share = |kind: usize, at: usize| {
                let mut one = still.clone();
                one[kind][at] = 1.0;
                let [along, parameters, restitutions, frictions] = &one;
                let varied = Varied { name: "", parameters, restitutions, frictions };
                let slopes = crossed.linear(&varied, along)?.slopes;
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
            Ok(crossed.asks())
        })
    }
}
