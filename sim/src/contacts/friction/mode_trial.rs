//! Trial of combinations of contact modes: computes the forces in given modes, and checks that they
//! agree with the modes.

use super::{ContactMode, ContactSolution};
use nalgebra::{DMatrix, DVector};
use tripos_linear::SingularValues;

/// Relative size of a singular value below which it counts as rounding; the largest singular value is 1.
const DEPENDENT: f64 = 1e-11;
/// Smallest weight of a friction force when dependent forces share a load, as a fraction of the largest weight.
const LIGHT: f64 = 1e-6;
/// Factor on the weights of friction forces if friction could not bear its share of a load. Friction then takes only
/// the force that no gap can take.
const FAINT: f64 = 1e-3;
/// Number of iterative refinements of a least-squares solution that is found by singular values.
const REFINEMENTS: usize = 2;

/// Closed contact in a trial of modes, in the scaled units of its rows.
pub(crate) struct TriedContact<'t> {
    /// Index of the row of the contact's gap, then those of its slips. A contact with a coefficient of
    /// friction has a single slip.
    pub rows: &'t [usize],
    /// Coefficient of friction of the contact, in scaled units; `None` without friction.
    pub friction: Option<f64>,
    /// Sign of the velocity at which the contact slips, 1 or −1; `None` if it does not slip.
    pub slips: Option<f64>,
    /// Given force along the contact's gap, in addition to the force that the trial finds.
    pub given: f64,
}

/// Contacts that are closed together, for a trial of their modes.
///
/// The motion of their rows is G λ + c, where c is the motion without the forces λ. If λ are forces, the motion is an
/// acceleration; if λ are impulses, it is a velocity.
pub(crate) struct ModeTrial<'t> {
    /// Matrix G of the motion of all rows by forces or impulses, scaled so that its diagonal is 1.
    pub g: &'t DMatrix<f64>,
    /// Contacts that are closed at the same instant, in the scaled units of their rows.
    pub touches: Vec<TriedContact<'t>>,
}

/// Unknown force: the index of its row. If friction adds a proportional force, also the row of that
/// force and the ratio to the unknown force.
type UnknownForce = (usize, Option<(usize, f64)>);

/// Mode that is tried for a contact, and whether an unknown force acts along its gap.
#[derive(Clone, Copy)]
struct ModeChoice {
    /// Mode that is tried for the contact.
    mode: ContactMode,
    /// True if the contact has a force along its gap in addition to the given force.
    pushes: bool,
}

impl TriedContact<'_> {
    /// True if the contact has a coefficient of friction above zero.
    fn is_rough(&self) -> bool {
        self.friction.is_some_and(|mu| mu > 0.0)
    }

    /// Lists all modes that the contact could have, each with and without a force along the gap if both
    /// are possible.
    fn choices(&self) -> Vec<ModeChoice> {
        let pushes = |mode| ModeChoice { mode, pushes: true };
        if self.friction.is_none() {
            return vec![ModeChoice { mode: ContactMode::Opens, pushes: false }, pushes(ContactMode::Pushes)];
        }
        let grips = match self.slips {
            // Without friction the direction of the slip is unknown, and does not matter.
            _ if !self.is_rough() => vec![ContactMode::Slips(1.0)],
            Some(way) => vec![ContactMode::Slips(way)],
            None => vec![ContactMode::Sticks, ContactMode::Slips(1.0), ContactMode::Slips(-1.0)],
        };
        // A given force along the gap causes friction, even if no other force is added.
        let idle = if self.given > 0.0 { grips.clone() } else { vec![ContactMode::Opens] };
        idle.into_iter().map(|mode| ModeChoice { mode, pushes: false }).chain(grips.into_iter().map(pushes)).collect()
    }
}

impl ModeTrial<'_> {
    /// Finds all combinations of modes that agree with the laws of contact, each with its forces and the
    /// motion of the rows. Numbers up to `nothing` count as zero. If no contact has friction, only the
    /// first combination is returned, since all move alike.
    pub(crate) fn modes_in_agreement(&self, c: &DVector<f64>, nothing: f64) -> Vec<(ContactSolution, DVector<f64>)> {
        let choices: Vec<Vec<ModeChoice>> = self.touches.iter().map(TriedContact::choices).collect();
        let is_smooth = self.touches.iter().all(|touch| touch.friction.is_none());
        let mut list = Vec::new();
        for number in 0..choices.iter().map(Vec::len).product::<usize>() {
            let mut left = number;
            let chosen: Vec<ModeChoice> = choices
                .iter()
                .map(|own| {
                    let at = left % own.len();
                    left /= own.len();
                    own[at]
                })
                .collect();
            let Some(forces) = self.forces(c, &chosen) else { continue };
            let after = self.g * &forces + c;
            if self.agrees(&chosen, &forces, &after, nothing) {
                let (modes, pushes) = chosen.iter().map(|choice| (choice.mode, choice.pushes)).unzip();
                list.push((ContactSolution { modes, pushes, forces }, after));
                if is_smooth {
                    break;
                }
            }
        }
        list
    }

    /// Forces along all rows for contacts in given modes; `None` if a force is not finite.
    pub(crate) fn forces_in_modes(&self, c: &DVector<f64>, modes: &[ContactMode]) -> Option<DVector<f64>> {
        self.forces(c, &choices_of_modes(modes))
    }

    /// True if the given modes agree with the laws of contact and friction. Numbers up to `nothing` count
    /// as zero.
    pub(crate) fn modes_agree(&self, c: &DVector<f64>, modes: &[ContactMode], nothing: f64) -> bool {
        let chosen = choices_of_modes(modes);
        let forces = self.forces(c, &chosen);
        forces.is_some_and(|forces| {
            let after = self.g * &forces + c;
            self.agrees(&chosen, &forces, &after, nothing)
        })
    }

    /// Determinant of the linear system for the unknown forces of contacts in given modes.
    pub(crate) fn determinant(&self, modes: &[ContactMode]) -> f64 {
        self.matrix(&self.unknown_contact_forces(&choices_of_modes(modes))).determinant()
    }

    /// True if `forces` and the motion `after` of the rows under them agree with the chosen modes. Numbers
    /// up to `nothing` count as zero.
    fn agrees(&self, chosen: &[ModeChoice], forces: &DVector<f64>, after: &DVector<f64>, nothing: f64) -> bool {
        self.touches.iter().zip(chosen).all(|(touch, choice)| {
            let stays = |row: usize| after[row].abs() <= nothing;
            let normal = touch.rows[0];
            if !(forces[normal] >= -nothing && after[normal] >= -nothing && (!choice.pushes || stays(normal))) {
                return false;
            }
            let limit = touch.friction.unwrap_or(0.0) * (forces[normal] + touch.given) + nothing;
            match choice.mode {
                ContactMode::Opens => true,
                ContactMode::Pushes => touch.rows[1..].iter().all(|row| stays(*row)),
                ContactMode::Sticks => touch.rows[1..].iter().all(|row| stays(*row) && forces[*row].abs() <= limit),
                ContactMode::Slips(_) if touch.slips.is_some() || !touch.is_rough() => true,
                ContactMode::Slips(way) => way * after[touch.rows[1]] >= -nothing,
            }
        })
    }

    /// Computes the forces along all rows for the chosen modes, such that G λ + c is 0 along the rows that must not
    /// move. `None` if a force is not finite.
    fn forces(&self, c: &DVector<f64>, chosen: &[ModeChoice]) -> Option<DVector<f64>> {
        let unknown = self.unknown_contact_forces(chosen);
        let mut forces = self.friction_of_given_forces(chosen);
        let c = if forces.iter().all(|force| *force == 0.0) { c.clone() } else { c + self.g * &forces };
        if unknown.is_empty() {
            return Some(forces);
        }
        let part = self.matrix(&unknown);
        if !part.iter().all(|x| x.is_finite()) || !unknown.iter().all(|(row, _)| c[*row].is_finite()) {
            return None;
        }
        let sides = DVector::from_iterator(unknown.len(), unknown.iter().map(|(row, _)| -c[*row]));
        let found = SingularValues::new(&part);
        let rounding = DEPENDENT * found.values.max();
        let mut values = refined_least_forces(&found, &part, &sides, rounding);
        if found.values.min() <= rounding
            && let Some(weights) = self.weights_of_contact_forces(chosen, &unknown, &values)
        {
            values = weighted_least_forces(&part, &sides, &weights);
            if !self.friction_bears_forces(chosen, &unknown, &values) {
                // A motion along a slip can be prevented by a force along that slip; a force along a gap may prevent it
                // alone.
                let mut faint = weights;
                let along = faint.iter_mut().zip(&unknown).filter(|(_, (row, _))| !self.is_gap(*row));
                along.for_each(|(weight, _)| *weight *= FAINT);
                values = weighted_least_forces(&part, &sides, &faint);
            }
        }
        for ((row, follows), value) in unknown.iter().zip(values.iter()) {
            forces[*row] = *value;
            if let Some((other, factor)) = follows {
                forces[*other] += factor * value;
            }
        }
        Some(forces)
    }

    /// Lists the unknown forces of the chosen modes, which the linear system determines.
    fn unknown_contact_forces(&self, chosen: &[ModeChoice]) -> Vec<UnknownForce> {
        let mut list = Vec::new();
        for (touch, choice) in self.touches.iter().zip(chosen) {
            let normal = touch.rows[0];
            match choice.mode {
                ContactMode::Slips(way) if choice.pushes => {
                    list.push((normal, Some((touch.rows[1], touch.friction_force_per_normal_force(way)))));
                }
                ContactMode::Opens | ContactMode::Slips(_) => {}
                ContactMode::Pushes | ContactMode::Sticks => {
                    let first = usize::from(!choice.pushes);
                    list.extend(touch.rows[first..].iter().map(|row| (*row, None)));
                }
            }
        }
        list
    }

    /// Friction forces along slips that the given forces along gaps cause, with an entry for each row.
    fn friction_of_given_forces(&self, chosen: &[ModeChoice]) -> DVector<f64> {
        let mut forces = DVector::zeros(self.g.nrows());
        for (touch, choice) in self.touches.iter().zip(chosen) {
            if let ContactMode::Slips(way) = choice.mode {
                forces[touch.rows[1]] = touch.friction_force_per_normal_force(way) * touch.given;
            }
        }
        forces
    }

    /// Matrix of the linear system for the unknown forces, with a row and a column for each of them.
    fn matrix(&self, unknown: &[UnknownForce]) -> DMatrix<f64> {
        DMatrix::from_fn(unknown.len(), unknown.len(), |i, j| {
            let (row, (column, follows)) = (unknown[i].0, unknown[j]);
            let own = self.g[(row, column)];
            follows.map_or(own, |(other, factor)| own + factor * self.g[(row, other)])
        })
    }

    /// True if the row with this index is that of a contact's gap.
    fn is_gap(&self, row: usize) -> bool {
        self.touches.iter().any(|touch| touch.rows[0] == row)
    }

    /// True if friction can bear the forces `values` along the slips of all contacts that stick: |λ_t| ≤ μ λ_n.
    fn friction_bears_forces(&self, chosen: &[ModeChoice], unknown: &[UnknownForce], values: &DVector<f64>) -> bool {
        let force = |row: usize| unknown.iter().position(|(other, _)| *other == row).map_or(0.0, |at| values[at]);
        let bears = |touch: &TriedContact<'_>| touch.friction.unwrap_or(0.0) * (force(touch.rows[0]) + touch.given);
        let sticking = self.touches.iter().zip(chosen).filter(|(_, own)| own.mode == ContactMode::Sticks);
        sticking.map(|(touch, _)| touch).all(|touch| force(touch.rows[1]).abs() <= bears(touch))
    }

    /// Weights with which dependent unknown forces share a load, with an entry for each unknown force. `None` if
    /// friction bears no force.
    ///
    /// The weight of a force along a slip is the force that friction can bear there. No contact then slips while others
    /// could bear more.
    fn weights_of_contact_forces(
        &self,
        chosen: &[ModeChoice],
        unknown: &[UnknownForce],
        values: &DVector<f64>,
    ) -> Option<DVector<f64>> {
        let force = |row: usize| unknown.iter().position(|(other, _)| *other == row).map_or(0.0, |at| values[at]);
        let mut weights = DVector::from_element(unknown.len(), 1.0);
        let bears = |touch: &TriedContact<'_>| touch.friction.unwrap_or(0.0) * (force(touch.rows[0]) + touch.given);
        let sticking: Vec<_> =
            self.touches.iter().zip(chosen).filter(|(_, own)| own.mode == ContactMode::Sticks).collect();
        let most = sticking.iter().map(|(touch, _)| bears(touch)).fold(0.0, f64::max);
        for (touch, _) in sticking {
            let at = unknown.iter().position(|(row, _)| *row == touch.rows[1])?;
            weights[at] = bears(touch).max(LIGHT * most).sqrt();
        }
        (most > 0.0).then_some(weights)
    }
}

impl TriedContact<'_> {
    /// Friction force along the slip per unit of force along the gap. `way` is the sign of the slip velocity.
    fn friction_force_per_normal_force(&self, way: f64) -> f64 {
        -self.friction.unwrap_or(0.0) * way
    }
}

/// Choices for given modes, in which each contact that stays closed has an unknown force along its gap.
fn choices_of_modes(modes: &[ContactMode]) -> Vec<ModeChoice> {
    modes.iter().map(|mode| ModeChoice { mode: *mode, pushes: mode.is_held() }).collect()
}

/// Solution x of A x = b with the smallest sum of (xᵢ / wᵢ)² for the weights w; in the sense of least squares if there
/// is no solution.
fn weighted_least_forces(a: &DMatrix<f64>, b: &DVector<f64>, weights: &DVector<f64>) -> DVector<f64> {
    let scaled = DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| a[(i, j)] * weights[j]);
    let found = SingularValues::new(&scaled);
    let rounding = DEPENDENT * found.values.max();
    refined_least_forces(&found, &scaled, b, rounding).component_mul(weights)
}

/// Least-squares solution x of A x = b with the smallest length, by the singular values of A above `rounding`. The
/// solution is refined with its residuals.
fn refined_least_forces(found: &SingularValues, a: &DMatrix<f64>, b: &DVector<f64>, rounding: f64) -> DVector<f64> {
    let mut x = found.solve(b, rounding);
    for _ in 0..REFINEMENTS {
        x += found.solve(&(b - a * &x), rounding);
    }
    x
}
