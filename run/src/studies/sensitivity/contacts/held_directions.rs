//! Gap and slip directions along which contacts are held, and the friction of slipping contacts. Forces
//! along held directions follow from the motion. Friction follows from the normal forces.

use crate::preparation::impacts::{HeldContacts, SceneContacts};
use nalgebra::{DMatrix, DVector};
use tripos_linear::SingularValues;
use tripos_sim::{ContactMode, ContactSolution};

/// Fraction of the largest singular value below which a singular value counts as rounding.
const DEPENDENT: f64 = 1e-11;
/// Fraction of the largest singular value below which a singular value may be rounding.
const DOUBTFUL: f64 = 1e-9;

/// Gap and slip directions along which contacts are held, and the friction of slipping contacts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HeldDirections {
    /// Indices of the held directions among the gap and slip directions of all contacts.
    pub rows: Vec<usize>,
    /// Slipping contacts, with the data of their friction.
    pub slips: Vec<SlippingContact>,
}

/// Slipping contact, whose tangential force is −μ s times its normal force. s is the sign of its slip
/// velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlippingContact {
    /// Index of the contact, from 0.
    pub contact: usize,
    /// Index of the contact's gap direction among the directions of all contacts.
    pub normal: usize,
    /// Index of the contact's slip direction among the directions of all contacts.
    pub along: usize,
    /// Sign s of the contact's slip velocity, 1 or −1.
    pub way: f64,
    /// Tangential force per normal force, −μ s.
    pub factor: f64,
}

/// Choice if the gap velocity of a contact is held.
#[derive(Clone, Copy, PartialEq, Eq)]
enum GapTreatment {
    /// The gap velocity of the contact is held.
    Held,
    /// The gap velocity is free, and only the slip velocity is held. The contact then has no normal
    /// impulse except a given one.
    Free,
}

impl HeldDirections {
    /// Makes the held directions and the friction of the contacts in `kept`, by the mode of each.
    pub fn of_held_contacts(contacts: &SceneContacts<'_>, kept: &HeldContacts) -> Self {
        let mut grip = Self::default();
        kept.iter().for_each(|(at, mode)| grip.add(contacts, at, mode, GapTreatment::Held));
        grip
    }

    /// Makes the held directions and the friction of the contacts `which` in an impact. `found` are the
    /// modes of these contacts.
    pub fn of_impact_modes(contacts: &SceneContacts<'_>, which: &[usize], found: &ContactSolution) -> Self {
        let mut grip = Self::default();
        let each = which.iter().zip(&found.modes).zip(&found.pushes);
        each.for_each(|((at, mode), pushes)| {
            grip.add(contacts, *at, *mode, if *pushes { GapTreatment::Held } else { GapTreatment::Free });
        });
        grip
    }

    /// Adds the held directions and the friction of one contact in the given mode.
    fn add(&mut self, contacts: &SceneContacts<'_>, contact: usize, mode: ContactMode, gap: GapTreatment) {
        let rows = &contacts.rows[contact];
        let first = usize::from(gap == GapTreatment::Free);
        match mode {
            ContactMode::Opens => {}
            ContactMode::Pushes | ContactMode::Sticks => self.rows.extend(&rows[first..]),
            ContactMode::Slips(way) => {
                self.rows.extend(&rows[first..1]);
                let factor = -contacts.friction(contact).unwrap_or(0.0) * way;
                self.slips.push(SlippingContact { contact, normal: rows[0], along: rows[1], way, factor });
            }
        }
    }

    /// Matrix that converts forces along the held directions to forces along the `count` directions of
    /// all contacts, friction included. It has a row for each of these directions, and a column for
    /// each held direction.
    pub fn held_force_spread(&self, count: usize) -> DMatrix<f64> {
        let mut all = DMatrix::zeros(count, self.rows.len());
        for (at, row) in self.rows.iter().enumerate() {
            all[(*row, at)] = 1.0;
            for slip in self.slips.iter().filter(|slip| slip.normal == *row) {
                all[(slip.along, at)] += slip.factor;
            }
        }
        all
    }

    /// Derivative of the friction forces along all directions, if the coefficients of friction have the
    /// derivatives `by`, one for each contact. `forces` contains the normal forces.
    pub fn friction_by_coefficients(&self, by: &[f64], forces: &DVector<f64>) -> DVector<f64> {
        let mut all = DVector::zeros(forces.len());
        for slip in &self.slips {
            all[slip.along] -= slip.way * by[slip.contact] * forces[slip.normal];
        }
        all
    }

    /// Friction forces along all directions that the normal forces in `given` cause.
    pub fn friction_of_normal_forces(&self, given: &DVector<f64>) -> DVector<f64> {
        let mut all = DVector::zeros(given.len());
        for slip in &self.slips {
            all[slip.along] += slip.factor * given[slip.normal];
        }
        all
    }

    /// Makes the linear system for the forces along the held directions from the compliance G of all
    /// directions. It is scaled so that all directions are comparable.
    pub fn system(&self, compliance: &DMatrix<f64>) -> HeldDirectionSystem {
        let unit = |row: &usize| {
            let g = compliance[(*row, *row)];
            if g > 0.0 { 1.0 / g.sqrt() } else { 0.0 }
        };
        let unit = DVector::from_iterator(self.rows.len(), self.rows.iter().map(unit));
        let own = compliance.select_rows(&self.rows) * self.held_force_spread(compliance.nrows());
        let scaled = DMatrix::from_fn(unit.len(), unit.len(), |i, j| unit[i] * own[(i, j)] * unit[j]);
        HeldDirectionSystem { scaled, unit }
    }
}

/// Linear system A λ + c = 0 for the forces λ along held directions, where c is the motion of these
/// directions without the forces.
pub struct HeldDirectionSystem {
    /// Matrix A, with rows and columns scaled to comparable units.
    scaled: DMatrix<f64>,
    /// Scale of each direction, the inverse square root of its compliance; 0 if the compliance is not
    /// positive.
    unit: DVector<f64>,
}

impl HeldDirectionSystem {
    /// Solves A λ + c = 0 for the forces λ. If several solutions exist, returns the smallest in scaled
    /// units. `None` if the system or the solution is not finite.
    pub fn solve(&self, c: &DVector<f64>) -> Option<DVector<f64>> {
        self.solve_scaled(&self.scaled, c)
    }

    /// Solves Aᵀ x + c = 0 for x. If several solutions exist, returns the smallest in scaled units. `None`
    /// if the system or the solution is not finite.
    pub fn solve_transposed(&self, c: &DVector<f64>) -> Option<DVector<f64>> {
        self.solve_scaled(&self.scaled.transpose(), c)
    }

    /// Solves a linear system whose matrix is already scaled. If several solutions exist, returns the
    /// smallest. `None` if the system is not finite.
    fn solve_scaled(&self, matrix: &DMatrix<f64>, c: &DVector<f64>) -> Option<DVector<f64>> {
        if c.is_empty() {
            return Some(c.clone());
        }
        let c = c.component_mul(&self.unit);
        if !matrix.iter().chain(c.iter()).all(|x| x.is_finite()) {
            return None;
        }
        let found = SingularValues::new(matrix);
        let rounding = DEPENDENT * found.values.max();
        Some(found.solve(&-c, rounding).component_mul(&self.unit))
    }

    /// Tells for each held direction if its force is not determined, because other directions hold the
    /// same motion.
    pub fn undetermined_forces(&self) -> Vec<bool> {
        if self.unit.is_empty() || !self.scaled.iter().all(|x| x.is_finite()) {
            return vec![false; self.unit.len()];
        }
        let SingularValues { values, right: directions, .. } = SingularValues::new(&self.scaled);
        let rounding = DOUBTFUL * values.max();
        let nothing = values.iter().enumerate().filter(|(_, value)| **value <= rounding);
        let nothing: Vec<usize> = nothing.map(|(at, _)| at).collect();
        (0..self.unit.len()).map(|row| nothing.iter().any(|at| directions[(*at, row)].abs() > DOUBTFUL)).collect()
    }
}
