//! Rows that contacts hold, and friction of slipping contacts. Forces along held rows follow from the motion of the
//! rows, and friction follows from the forces along gaps.

use crate::preparation::impacts::{Contacts, HeldContacts};
use nalgebra::{DMatrix, DVector};
use tripos_sim::{ContactSolution, Mode};

/// Ratio to the largest singular value below which a singular value is rounding.
const DEPENDENT: f64 = 1e-11;
/// Ratio to the largest singular value below which a singular value may be rounding.
const DOUBTFUL: f64 = 1e-9;

/// Rows and friction that contacts hold, by the mode of each.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Grip {
    /// Indices of the held rows.
    pub rows: Vec<usize>,
    /// Friction of the slipping contacts.
    pub slips: Vec<Slip>,
}

/// A contact that slips: its force along the slip is −μ s times its force along the gap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slip {
    /// Index of the slipping contact.
    pub contact: usize,
    /// Index of the row of the contact's gap.
    pub normal: usize,
    /// Index of the row of the contact's slip.
    pub along: usize,
    /// Sign s of the contact's slip velocity.
    pub way: f64,
    /// Friction per force along the gap, −μ s.
    pub factor: f64,
}

/// Row of the gap of a contact.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Gap {
    /// The velocity of the gap is held.
    Held,
    /// Only the slip is held: the contact does not push beyond its given impulse.
    Free,
}

impl Grip {
    /// Rows and friction of contacts that are held in a motion.
    pub fn of(contacts: &Contacts<'_>, kept: &HeldContacts) -> Self {
        let mut grip = Self::default();
        kept.iter().for_each(|(at, mode)| grip.add(contacts, at, mode, Gap::Held));
        grip
    }

    /// Rows and friction of contacts in an impact, in modes that were found.
    pub fn found(contacts: &Contacts<'_>, which: &[usize], found: &ContactSolution) -> Self {
        let mut grip = Self::default();
        let each = which.iter().zip(&found.modes).zip(&found.pushes);
        each.for_each(|((at, mode), pushes)| {
            grip.add(contacts, *at, *mode, if *pushes { Gap::Held } else { Gap::Free });
        });
        grip
    }

    /// Adds the rows and friction of a contact in a mode.
    fn add(&mut self, contacts: &Contacts<'_>, contact: usize, mode: Mode, gap: Gap) {
        let rows = &contacts.rows[contact];
        let first = usize::from(gap == Gap::Free);
        match mode {
            Mode::Opens => {}
            Mode::Pushes | Mode::Sticks => self.rows.extend(&rows[first..]),
            Mode::Slips(way) => {
                self.rows.extend(&rows[first..1]);
                let factor = -contacts.friction(contact).unwrap_or(0.0) * way;
                self.slips.push(Slip { contact, normal: rows[0], along: rows[1], way, factor });
            }
        }
    }

    /// Matrix that takes forces along held rows to forces along all rows, one column for each held row.
    pub fn spread(&self, count: usize) -> DMatrix<f64> {
        let mut all = DMatrix::zeros(count, self.rows.len());
        for (at, row) in self.rows.iter().enumerate() {
            all[(*row, at)] = 1.0;
            for slip in self.slips.iter().filter(|slip| slip.normal == *row) {
                all[(slip.along, at)] += slip.factor;
            }
        }
        all
    }

    /// Derivative of friction along all rows if its coefficients change by `by`, for the given forces along gaps.
    pub fn of_coefficients(&self, by: &[f64], forces: &DVector<f64>) -> DVector<f64> {
        let mut all = DVector::zeros(forces.len());
        for slip in &self.slips {
            all[slip.along] -= slip.way * by[slip.contact] * forces[slip.normal];
        }
        all
    }

    /// Friction along all rows that the given forces along gaps cause.
    pub fn of_given(&self, given: &DVector<f64>) -> DVector<f64> {
        let mut all = DVector::zeros(given.len());
        for slip in &self.slips {
            all[slip.along] += slip.factor * given[slip.normal];
        }
        all
    }

    /// Linear system for the forces along the held rows, for a compliance G of all rows. Its units make rows
    /// comparable.
    pub fn system(&self, compliance: &DMatrix<f64>) -> HeldSystem {
        let unit = |row: &usize| {
            let g = compliance[(*row, *row)];
            if g > 0.0 { 1.0 / g.sqrt() } else { 0.0 }
        };
        let unit = DVector::from_iterator(self.rows.len(), self.rows.iter().map(unit));
        let own = compliance.select_rows(&self.rows) * self.spread(compliance.nrows());
        let scaled = DMatrix::from_fn(unit.len(), unit.len(), |i, j| unit[i] * own[(i, j)] * unit[j]);
        HeldSystem { scaled, unit }
    }
}

/// Linear system A λ + c = 0 along held rows, with the forces λ along them and the motion c of the rows without forces.
pub struct HeldSystem {
    /// Matrix A with its rows and columns in comparable units.
    scaled: DMatrix<f64>,
    /// Unit of each row, the inverse root of its compliance.
    unit: DVector<f64>,
}

impl HeldSystem {
    /// Solves for the forces λ of the least size, in comparable units; `None` if they are not finite.
    pub fn solve(&self, c: &DVector<f64>) -> Option<DVector<f64>> {
        self.solved(self.scaled.clone(), c)
    }

    /// Solves Aᵀ x + c = 0 for the x of the least size, in comparable units; `None` if it is not finite.
    pub fn solve_transposed(&self, c: &DVector<f64>) -> Option<DVector<f64>> {
        self.solved(self.scaled.transpose(), c)
    }

    /// Solves a scaled system for the solution of the least size; `None` if it is not finite.
    fn solved(&self, matrix: DMatrix<f64>, c: &DVector<f64>) -> Option<DVector<f64>> {
        if c.is_empty() {
            return Some(c.clone());
        }
        let c = c.component_mul(&self.unit);
        if !matrix.iter().chain(c.iter()).all(|x| x.is_finite()) {
            return None;
        }
        let svd = matrix.svd(true, true);
        let rounding = DEPENDENT * svd.singular_values.max();
        Some(svd.solve(&-c, rounding).ok()?.component_mul(&self.unit))
    }

    /// Flags the rows whose forces are not determined, since other rows hold the same motion.
    pub fn shared(&self) -> Vec<bool> {
        if self.unit.is_empty() || !self.scaled.iter().all(|x| x.is_finite()) {
            return vec![false; self.unit.len()];
        }
        let svd = self.scaled.clone().svd(false, true);
        let rounding = DOUBTFUL * svd.singular_values.max();
        let Some(directions) = svd.v_t else { return vec![true; self.unit.len()] };
        let nothing = svd.singular_values.iter().enumerate().filter(|(_, value)| **value <= rounding);
        let nothing: Vec<usize> = nothing.map(|(at, _)| at).collect();
        (0..self.unit.len()).map(|row| nothing.iter().any(|at| directions[(*at, row)].abs() > DOUBTFUL)).collect()
    }
}
