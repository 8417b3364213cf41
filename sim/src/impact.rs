//! Impulses and forces of contacts that push and never pull.
//!
//! Rows w of contacts are the velocities at which they open, w u, and those at which they slip, as linear forms in independent speeds
//! u of which the kinetic energy has the matrix M. Impulses Λ along them change u by M⁻¹ Wᵀ Λ and the velocities of contacts by G Λ,
//! G = W M⁻¹ Wᵀ. Of contacts that are closed together all impulses follow at once from one complementarity: each pushes, or opens faster than
//! its law asks for, never both. Friedrich Pfeiffer & Christoph Glocker, *Multibody Dynamics with Unilateral Contacts* (1996), chapter 8; for Newton's
//! law in this form J. J. Moreau, *Unilateral contact and dry friction in finite freedom dynamics* (1988), §§ 3 and 5.
//!
//! Absent on purpose: any knowledge of time, of steps and of models.

use nalgebra::{DMatrix, DVector};

/// What counts as nothing, over the largest of its kind.
const NOTHING: f64 = 1e-10;
/// Singular values below this part of the largest one are rounding.
const DEPENDENT: f64 = 1e-11;

/// What an impact did.
#[derive(Clone, Debug, PartialEq)]
pub struct ImpactRecord {
    /// When, s.
    pub t: f64,
    /// The contacts that had an impulse, by their places, each with its normal impulse: in N s where the gap is in m.
    pub impulses: Vec<(usize, f64)>,
    /// The state before.
    pub before: Vec<f64>,
    /// The energy that the contacts took, J.
    pub loss: f64,
    /// The work that moving obstacles did, J.
    pub work: f64,
    /// Contacts of which later bounces are too short to be told apart: they are held from here on.
    pub held: Vec<usize>,
}

/// What one of the contacts that are closed at one instant does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Share {
    /// It pushes.
    Pushes,
    /// It opens, or opens faster than its law asks for.
    Parts,
    /// Neither: it could do either as well.
    Neither,
}

/// Contacts that are closed at one instant.
#[derive(Clone, Debug)]
pub struct Closed {
    /// G = W M⁻¹ Wᵀ, a row for each row of W.
    pub compliance: DMatrix<f64>,
    /// The rows of each contact: that of its gap, then those of its slips.
    pub rows: Vec<Vec<usize>>,
}

impl Closed {
    /// Newton's law: the impulses of all rows, from the velocities before, a coefficient of restitution for each contact; `None` if no impulses part the
    /// bodies.
    #[must_use]
    pub fn newton(&self, velocities: &DVector<f64>, restitution: &[f64]) -> Option<DVector<f64>> {
        let mut wanted = velocities.clone();
        for (rows, e) in self.rows.iter().zip(restitution) {
            wanted[rows[0]] *= 1.0 + e;
        }
        self.push(&wanted)
    }

    /// Poisson's law, likewise: a compression that stops what closes, then an expansion with e times its impulses, or more where
    /// that leaves something closing.
    #[must_use]
    pub fn poisson(&self, velocities: &DVector<f64>, restitution: &[f64]) -> Option<DVector<f64>> {
        let compression = self.push(velocities)?;
        let mut both = compression.clone();
        for (rows, e) in self.rows.iter().zip(restitution) {
            both[rows[0]] *= 1.0 + e;
        }
        let more = self.push(&(velocities + &self.compliance * &both))?;
        Some(both + more)
    }

    /// Λ with Λ ≥ 0 and G Λ + c ≥ 0 along gaps, one of them 0 at each contact, and G Λ + c = 0 along the slips of those that push; `None` if
    /// there are none. With accelerations for velocities these are forces.
    #[must_use]
    pub fn push(&self, c: &DVector<f64>) -> Option<DVector<f64>> {
        let (scaled, unit) = self.scaled();
        let c = c.component_mul(&unit);
        let nothing = NOTHING * c.amax();
        (0..1_usize << self.rows.len()).find_map(|chosen| {
            let pushes = |contact: usize| chosen >> contact & 1 == 1;
            let rows: Vec<usize> =
                self.rows.iter().enumerate().filter(|(at, _)| pushes(*at)).flat_map(|(_, rows)| rows.clone()).collect();
            let impulses = held(&scaled, &c, &rows)?;
            let after = &scaled * &impulses + &c;
            let stays = rows.iter().all(|row| after[*row].abs() <= nothing);
            let parts = self.rows.iter().all(|rows| impulses[rows[0]] >= -nothing && after[rows[0]] >= -nothing);
            (stays && parts).then(|| impulses.component_mul(&unit))
        })
    }

    /// What each contact does by impulses that [`Closed::push`] found for these velocities.
    #[must_use]
    pub fn shares(&self, c: &DVector<f64>, impulses: &DVector<f64>) -> Vec<Share> {
        let (scaled, unit) = self.scaled();
        let c = c.component_mul(&unit);
        let impulses = impulses.zip_map(&unit, |impulse, unit| if unit > 0.0 { impulse / unit } else { 0.0 });
        let after = &scaled * &impulses + &c;
        let nothing = NOTHING * c.amax();
        let share = |rows: &Vec<usize>| match rows[0] {
            row if impulses[row] > nothing => Share::Pushes,
            row if after[row] > nothing => Share::Parts,
            _ => Share::Neither,
        };
        self.rows.iter().map(share).collect()
    }

    /// Λ with G Λ + c = 0 along all rows of these contacts, of least size where rows depend on one another.
    #[must_use]
    pub fn hold(&self, c: &DVector<f64>, contacts: &[usize]) -> Option<DVector<f64>> {
        let rows: Vec<usize> = contacts.iter().flat_map(|at| self.rows[*at].clone()).collect();
        let (scaled, unit) = self.scaled();
        Some(held(&scaled, &c.component_mul(&unit), &rows)?.component_mul(&unit))
    }

    /// G in units in which all rows are alike, and these units.
    fn scaled(&self) -> (DMatrix<f64>, DVector<f64>) {
        let unit = self.compliance.diagonal().map(|g| if g > 0.0 { 1.0 / g.sqrt() } else { 0.0 });
        let n = unit.len();
        (DMatrix::from_fn(n, n, |i, j| unit[i] * self.compliance[(i, j)] * unit[j]), unit)
    }
}

/// Λ of these rows alone, of least size, so that G Λ + c is 0 along them as far as it can be; `None` if it is not finite.
fn held(g: &DMatrix<f64>, c: &DVector<f64>, rows: &[usize]) -> Option<DVector<f64>> {
    let mut all = DVector::zeros(c.len());
    if rows.is_empty() {
        return Some(all);
    }
    let part = g.select_rows(rows).select_columns(rows);
    if !part.iter().all(|x| x.is_finite()) || !rows.iter().all(|row| c[*row].is_finite()) {
        return None;
    }
    let sides = -c.select_rows(rows);
    let svd = part.svd(true, true);
    let found = svd.solve(&sides, DEPENDENT * svd.singular_values.max()).ok()?;
    for (row, value) in rows.iter().zip(found.iter()) {
        all[*row] = *value;
    }
    Some(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn closed(g: &[f64], rows: &[&[usize]]) -> Closed {
        let n: usize = rows.iter().map(|rows| rows.len()).sum();
        let compliance = DMatrix::from_row_slice(n, n, g);
        Closed { compliance, rows: rows.iter().map(|rows| rows.to_vec()).collect() }
    }

    /// Truth: a mass m at −v leaves with e v; the impulse is (1 + e) m v, by either law.
    #[test]
    fn one_contact_gives_back_e_times_what_closed_it_by_either_law() {
        let one = closed(&[1.0 / 3.0], &[&[0]]);
        let before = DVector::from_vec(vec![-2.0]);
        for e in [0.0, 0.3, 1.0] {
            let (newton, poisson) = (one.newton(&before, &[e]).unwrap(), one.poisson(&before, &[e]).unwrap());
            assert!((newton[0] - (1.0 + e) * 6.0).abs() < 1e-14 && (poisson[0] - newton[0]).abs() < 1e-14, "{e}");
        }
        assert_eq!(one.newton(&-before, &[0.5]).unwrap()[0], 0.0, "what opens is left alone");
    }

    /// Truth: three equal masses in a row, the first at 1, with e = 1. Contacts 12 and 23 are closed: g₁' = u₂ − u₁ = −1, g₂' = 0, G = [[2, −1],
    /// [−1, 2]]. Newton's law in one: ξ₁ = 0 and ξ₂ = 0 give G Λ = (2, 0), Λ = (4/3, 2/3), so u = (−1/3, 2/3, 2/3): energy is kept. Poisson's: compression
    /// Λ = (2/3, 1/3), doubled the same.
    #[test]
    fn three_masses_in_a_row_share_an_impact_as_moreau_has_it() {
        let row = closed(&[2.0, -1.0, -1.0, 2.0], &[&[0], &[1]]);
        let before = DVector::from_vec(vec![-1.0, 0.0]);
        for impulses in [row.newton(&before, &[1.0, 1.0]).unwrap(), row.poisson(&before, &[1.0, 1.0]).unwrap()] {
            assert!((impulses[0] - 4.0 / 3.0).abs() < 1e-14 && (impulses[1] - 2.0 / 3.0).abs() < 1e-14, "{impulses}");
        }
    }

    /// Truth: with e = 1 at the contact that is hit and e = 0 at the other, Newton's law asks g₂' = 0 only, Poisson's lets the second go on with half of it:
    /// compression (2/3, 1/3), expansion (2/3, 0): G (4/3, 1/3) + (−1, 0) = (4/3, −2/3): the second still closes, and pushes 1/3 more.
    #[test]
    fn poisson_pushes_again_where_expansion_leaves_something_closing() {
        let row = closed(&[2.0, -1.0, -1.0, 2.0], &[&[0], &[1]]);
        let before = DVector::from_vec(vec![-1.0, 0.0]);
        let impulses = row.poisson(&before, &[1.0, 0.0]).unwrap();
        assert!((impulses[0] - 4.0 / 3.0).abs() < 1e-14 && (impulses[1] - 2.0 / 3.0).abs() < 1e-14, "{impulses}");
    }

    /// Truth: the masses of before; with the second at rest apart from the first it neither pushes nor opens, and what opens parts.
    #[test]
    fn contacts_share_in_an_impact_by_pushing_or_parting_or_neither() {
        let row = closed(&[2.0, -1.0, -1.0, 2.0], &[&[0], &[1]]);
        let shares = |c: &[f64]| {
            let c = DVector::from_column_slice(c);
            row.shares(&c, &row.push(&c).unwrap())
        };
        assert_eq!(shares(&[-1.0, 0.0]), [Share::Pushes, Share::Pushes]);
        assert_eq!(shares(&[-1.0, 0.25]), [Share::Pushes, Share::Pushes]);
        assert_eq!(shares(&[-1.0, 0.75]), [Share::Pushes, Share::Parts]);
        assert_eq!(shares(&[-1.0, 0.5]), [Share::Pushes, Share::Neither]);
    }

    /// Four legs of a table that falls flat: their rows are of rank 3, and the velocities after are told all the same.
    #[test]
    fn rows_that_depend_on_one_another_have_impulses_of_least_size() {
        let ones = vec![1.0; 16];
        let table = closed(&ones, &[&[0], &[1], &[2], &[3]]);
        let before = DVector::from_vec(vec![-1.0; 4]);
        let impulses = table.newton(&before, &[0.5; 4]).unwrap();
        assert!((impulses.sum() - 1.5).abs() < 1e-14 && impulses.iter().all(|x| *x >= 0.0), "{impulses}");
    }

    /// A wedge between walls that both close: nothing parts them.
    #[test]
    fn what_no_impulse_parts_is_said() {
        let wedged = closed(&[1.0, -1.0, -1.0, 1.0], &[&[0], &[1]]);
        assert!(wedged.newton(&DVector::from_vec(vec![-1.0, -1.0]), &[0.0, 0.0]).is_none());
    }

    /// A contact that does not slip: a point mass that comes in at an angle leaves along the normal alone.
    #[test]
    fn a_contact_without_slip_takes_the_velocity_along_it() {
        let rough = closed(&[0.5, 0.0, 0.0, 0.5], &[&[0, 1]]);
        let before = DVector::from_vec(vec![-1.0, 3.0]);
        let impulses = rough.newton(&before, &[0.5]).unwrap();
        let after = before + &rough.compliance * impulses;
        assert!((after[0] - 0.5).abs() < 1e-14 && after[1].abs() < 1e-14, "{after}");
    }
}
