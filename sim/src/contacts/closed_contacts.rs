//! Impulses of impacts and forces of closed contacts that push and never pull.
//!
//! Each row w of a contact is a linear form in the independent speeds u: w u is the velocity at which the contact
//! opens, or the velocity at which it slips. The kinetic energy has the matrix M in u. Impulses Λ along the rows change
//! u by M⁻¹ Wᵀ Λ and the velocities of contacts by G Λ, with G = W M⁻¹ Wᵀ.
//!
//! A complementarity problem gives the impulses of all contacts that are closed together. Each contact either pushes,
//! or opens faster than its law of impact asks for, never both. Friedrich Pfeiffer & Christoph Glocker, *Multibody
//! Dynamics with Unilateral Contacts* (1996), chapter 8. For Newton's law in this form: J. J. Moreau, *Unilateral
//! contact and dry friction in finite freedom dynamics* (1988), §§ 3 and 5.
//!
//! Absent on purpose: any knowledge of time, of steps and of models.

use super::friction::{
    ContactMode, ContactSolution, ModeTrial, TriedContact, UndecidedContacts, agreed_contact_motion,
    forces_of_least_freedom,
};
use nalgebra::{DMatrix, DVector};

/// Size up to which a velocity, acceleration or force of contacts counts as zero, in scaled units. It
/// is a fraction of the largest velocity or acceleration of a row without contact forces.
const NOTHING: f64 = 1e-10;

/// Record of an impact: its time, its impulses, and the energy that it dissipated.
#[derive(Clone, Debug, PartialEq)]
pub struct ImpactRecord {
    /// Time of the impact, s.
    pub t: f64,
    /// Contacts that had an impulse: the index of the contact and its normal impulse. The impulse is in N s if the gap
    /// is in m.
    pub impulses: Vec<(usize, f64)>,
    /// State of the equations just before the impact.
    pub before: Vec<f64>,
    /// Energy that the contacts dissipated in the impact, J.
    pub loss: f64,
    /// Work that moving obstacles did in the impact, J.
    pub work: f64,
    /// Indices of contacts that stay closed after the impact, because further bounces would be too short to
    /// be resolved.
    pub held: Vec<usize>,
}

/// Behaviour of a closed contact in an impact: it pushes, it opens, or it does neither.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImpactShare {
    /// The contact pushes: its normal impulse is positive.
    Pushes,
    /// The contact opens, or opens faster than its law of impact asks for.
    Parts,
    /// The contact neither pushes nor opens by more than rounding, so that it could do either.
    Neither,
}

/// Contacts that are closed at the same instant: the matrix of their motion by impulses, and their
/// friction.
#[derive(Clone, Debug)]
pub struct ClosedContacts {
    /// Matrix G = W M⁻¹ Wᵀ that gives the velocities of all contact rows by impulses along them. It has a
    /// row and a column for each row of W.
    pub compliance: DMatrix<f64>,
    /// Indices of each contact's rows in W: first the row of its gap, then the rows of its slips.
    pub rows: Vec<Vec<usize>>,
    /// Coefficient of friction of each contact; `None` without friction. A contact with friction has a single slip row.
    pub friction: Vec<Option<f64>>,
}

impl ClosedContacts {
    /// Computes the impulses along all rows by Newton's law of impact. `velocities` are the velocities of the rows
    /// before the impact. `restitution` has a coefficient for each contact; a contact that already opens ignores it.
    ///
    /// # Errors
    /// [`UndecidedContacts`] if no impulses separate the bodies, or if Coulomb's law allows several motions.
    pub fn newton_impact(
        &self,
        velocities: &DVector<f64>,
        restitution: &[f64],
    ) -> Result<DVector<f64>, UndecidedContacts> {
        let mut wanted = velocities.clone();
        for (rows, e) in self.rows.iter().zip(restitution) {
            if wanted[rows[0]] < 0.0 {
                wanted[rows[0]] *= 1.0 + e;
            }
        }
        self.contact_impulses(&wanted)
    }

    /// Computes the impulses along all rows by Poisson's law of impact. `velocities` are the velocities of the rows
    /// before the impact, and `restitution` has a coefficient e for each contact.
    ///
    /// A compression stops the contacts that close. In the expansion that follows, each contact gets e times its
    /// impulse of the compression, or more if it would still close. Friction obeys Coulomb's law in each of the two
    /// phases, with the impulses of the phase and the slip at its end.
    ///
    /// # Errors
    /// [`UndecidedContacts`], as for [`ClosedContacts::newton_impact`].
    pub fn poisson_impact(
        &self,
        velocities: &DVector<f64>,
        restitution: &[f64],
    ) -> Result<DVector<f64>, UndecidedContacts> {
        let compression = self.contact_impulses(velocities)?;
        let given: Vec<f64> = self.rows.iter().zip(restitution).map(|(rows, e)| e * compression[rows[0]]).collect();
        let mut both = compression;
        for (rows, e) in self.rows.iter().zip(restitution) {
            both[rows[0]] *= 1.0 + e;
        }
        let more = self.contact_modes_under_given_impulses(
            &(velocities + &self.compliance * &both),
            &vec![None; given.len()],
            &given,
        )?;
        Ok(both + forces_of_least_freedom(more))
    }

    /// Computes the impulses Λ along all rows of the contacts. `c` are the velocities of the rows without these
    /// impulses. Along each gap Λ ≥ 0 and G Λ + c ≥ 0, and one of the two is 0.
    ///
    /// Along the slips of contacts that push, G Λ + c = 0. If a contact has friction, its slip velocity G Λ + c obeys
    /// Coulomb's law instead. If `c` are accelerations instead of velocities, Λ are the forces of contacts that do not
    /// slip yet.
    ///
    /// # Errors
    /// [`UndecidedContacts`] if there are no such Λ, or several that give different motions.
    pub fn contact_impulses(&self, c: &DVector<f64>) -> Result<DVector<f64>, UndecidedContacts> {
        let count = self.rows.len();
        Ok(forces_of_least_freedom(self.contact_modes_under_given_impulses(
            c,
            &vec![None; count],
            &vec![0.0; count],
        )?))
    }

    /// Finds all combinations of modes that contacts can have under accelerations `c` of their rows, with the contact
    /// forces. All combinations give the same motion; the one with the least freedom is first.
    ///
    /// `slips` has the sign of the slip velocity of each contact, 1 or −1; `None` for a contact that does not slip.
    ///
    /// # Errors
    /// [`UndecidedContacts`] if there is no combination, or if combinations give different motions.
    pub fn contact_modes(
        &self,
        c: &DVector<f64>,
        slips: &[Option<f64>],
    ) -> Result<Vec<ContactSolution>, UndecidedContacts> {
        self.contact_modes_under_given_impulses(c, slips, &vec![0.0; slips.len()])
    }

    /// True if contacts can have these modes together under accelerations `c` of their rows. `slips` has
    /// the sign of the slip velocity of each contact; `None` for a contact that does not slip.
    #[must_use]
    pub fn contact_modes_are_possible(&self, c: &DVector<f64>, slips: &[Option<f64>], modes: &[ContactMode]) -> bool {
        let (scaled, unit) = self.scaled_compliance();
        let c = c.component_mul(&unit);
        self.trial(&scaled, &unit, slips, &vec![0.0; slips.len()]).modes_agree(&c, modes, NOTHING * c.amax())
    }

    /// Determinant of the linear system for the contact forces in these modes, in scaled units. It is at least 0 if no
    /// contact slips. If it is negative, the forces of slipping contacts do not exist or are not unique.
    #[must_use]
    pub fn contact_force_determinant(&self, modes: &[ContactMode]) -> f64 {
        let (scaled, unit) = self.scaled_compliance();
        let none = (vec![None; modes.len()], vec![0.0; modes.len()]);
        self.trial(&scaled, &unit, &none.0, &none.1).determinant(modes)
    }

    /// Finds all combinations of modes under motions `c` of the rows, with their forces, if forces `given` already act
    /// along the gaps. Friction acts on the sum of the given and the found forces.
    ///
    /// `c` are accelerations, or velocities with impulses instead of forces. `slips` has the sign of the slip velocity
    /// of each contact; `None` for a contact that does not slip. The combination with the least freedom is first.
    ///
    /// # Errors
    /// [`UndecidedContacts`] if there is no combination, or if combinations give different motions.
    pub fn contact_modes_under_given_impulses(
        &self,
        c: &DVector<f64>,
        slips: &[Option<f64>],
        given: &[f64],
    ) -> Result<Vec<ContactSolution>, UndecidedContacts> {
        let (scaled, unit) = self.scaled_compliance();
        let c = c.component_mul(&unit);
        let found = self.trial(&scaled, &unit, slips, given).modes_in_agreement(&c, NOTHING * c.amax());
        let mut list = agreed_contact_motion(found, c.amax())?;
        for found in &mut list {
            found.forces.component_mul_assign(&unit);
        }
        Ok(list)
    }

    /// Creates the trial of modes of these contacts in scaled units. `scaled` is the matrix G in scaled units, and
    /// `unit` the unit of each row.
    fn trial<'t>(
        &'t self,
        scaled: &'t DMatrix<f64>,
        unit: &DVector<f64>,
        slips: &[Option<f64>],
        given: &[f64],
    ) -> ModeTrial<'t> {
        let touch = |at: usize| {
            let rows = &self.rows[at];
            let u = |row: usize| unit[row];
            // A force in the scaled row is the force divided by the unit of the row.
            let friction =
                self.friction[at].map(|mu| if u(rows[1]) > 0.0 { mu * u(rows[0]) / u(rows[1]) } else { 0.0 });
            let given = if u(rows[0]) > 0.0 { given[at] / u(rows[0]) } else { 0.0 };
            TriedContact { rows, friction, slips: slips[at], given }
        };
        ModeTrial { g: scaled, touches: (0..self.rows.len()).map(touch).collect() }
    }

    /// Behaviour of each contact in an impact, from the impulses that [`ClosedContacts::contact_impulses`] found. `c`
    /// are the velocities of the rows before the impact.
    #[must_use]
    pub fn impact_shares(&self, c: &DVector<f64>, impulses: &DVector<f64>) -> Vec<ImpactShare> {
        let (scaled, unit) = self.scaled_compliance();
        let c = c.component_mul(&unit);
        let impulses = impulses.zip_map(&unit, |impulse, unit| if unit > 0.0 { impulse / unit } else { 0.0 });
        let after = &scaled * &impulses + &c;
        let nothing = NOTHING * c.amax();
        let share = |rows: &Vec<usize>| match rows[0] {
            row if impulses[row] > nothing => ImpactShare::Pushes,
            row if after[row] > nothing => ImpactShare::Parts,
            _ => ImpactShare::Neither,
        };
        self.rows.iter().map(share).collect()
    }

    /// Finds the forces Λ of contacts in given modes: G Λ + c = 0 along the rows that must not move, and friction along
    /// the rows that slip. `None` if Λ is not finite.
    ///
    /// If rows depend on one another, Λ is the smallest solution, or a solution that friction can bear.
    #[must_use]
    pub fn forces_in_contact_modes(&self, c: &DVector<f64>, modes: &[ContactMode]) -> Option<DVector<f64>> {
        let (scaled, unit) = self.scaled_compliance();
        let none = (vec![None; modes.len()], vec![0.0; modes.len()]);
        let trial = self.trial(&scaled, &unit, &none.0, &none.1);
        Some(trial.forces_in_modes(&c.component_mul(&unit), modes)?.component_mul(&unit))
    }

    /// Matrix G scaled to a diagonal of 1, and the scale of each row, which is 1 / √G_kk; 0 for a row that
    /// cannot move.
    fn scaled_compliance(&self) -> (DMatrix<f64>, DVector<f64>) {
        let unit = self.compliance.diagonal().map(|g| if g > 0.0 { 1.0 / g.sqrt() } else { 0.0 });
        let n = unit.len();
        (DMatrix::from_fn(n, n, |i, j| unit[i] * self.compliance[(i, j)] * unit[j]), unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn closed(g: &[f64], rows: &[&[usize]]) -> ClosedContacts {
        let n: usize = rows.iter().map(|rows| rows.len()).sum();
        let compliance = DMatrix::from_row_slice(n, n, g);
        ClosedContacts {
            compliance,
            rows: rows.iter().map(|rows| rows.to_vec()).collect(),
            friction: vec![None; rows.len()],
        }
    }

    /// Truth: a mass m that arrives at the velocity −v leaves with e v. The impulse is (1 + e) m v, by either law.
    #[test]
    fn one_contact_gives_back_e_times_what_closed_it_by_either_law() {
        let one = closed(&[1.0 / 3.0], &[&[0]]);
        let before = DVector::from_vec(vec![-2.0]);
        for e in [0.0, 0.3, 1.0] {
            let (newton, poisson) =
                (one.newton_impact(&before, &[e]).unwrap(), one.poisson_impact(&before, &[e]).unwrap());
            assert!((newton[0] - (1.0 + e) * 6.0).abs() < 1e-14 && (poisson[0] - newton[0]).abs() < 1e-14, "{e}");
        }
        assert_eq!(one.newton_impact(&-before, &[0.5]).unwrap()[0], 0.0, "what opens is left alone");
    }

    /// Truth: three equal masses stand in a row. The first comes at velocity 1, and the third leaves the second at 0.4.
    /// The second still meets the third, and all three get the same velocity. Newton's law demands no rebound from a
    /// contact that opens before the impact; a bound −e γ⁻ below 0 would make it close.
    #[test]
    fn what_opens_before_an_impact_is_not_driven_in() {
        let row = closed(&[2.0, -1.0, -1.0, 2.0], &[&[0], &[1]]);
        let before = DVector::from_vec(vec![-1.0, 0.4]);
        let after = &before + &row.compliance * row.newton_impact(&before, &[0.0, 1.0]).unwrap();
        assert!(after[0].abs() < 1e-14 && after[1].abs() < 1e-14, "{after}");
    }

    /// Truth: three equal masses in a row, the first at velocity 1, with e = 1. Contacts 12 and 23 are closed: g₁' = u₂
    /// − u₁ = −1, g₂' = 0, G = [[2, −1], [−1, 2]]. Newton's law: ξ₁ = 0 and ξ₂ = 0 give G Λ = (2, 0) and Λ = (4/3,
    /// 2/3). Then u = (−1/3, 2/3, 2/3), and the energy is kept. Poisson's law: the compression Λ = (2/3, 1/3), doubled,
    /// is the same.
    #[test]
    fn three_masses_in_a_row_share_an_impact_as_moreau_has_it() {
        let row = closed(&[2.0, -1.0, -1.0, 2.0], &[&[0], &[1]]);
        let before = DVector::from_vec(vec![-1.0, 0.0]);
        for impulses in
            [row.newton_impact(&before, &[1.0, 1.0]).unwrap(), row.poisson_impact(&before, &[1.0, 1.0]).unwrap()]
        {
            assert!((impulses[0] - 4.0 / 3.0).abs() < 1e-14 && (impulses[1] - 2.0 / 3.0).abs() < 1e-14, "{impulses}");
        }
    }

    /// Truth: e = 1 at the contact that is hit, e = 0 at the other. Newton's law demands g₂' = 0 only. Poisson's law
    /// has the compression (2/3, 1/3) and the expansion (2/3, 0). Then G (4/3, 1/3) + (−1, 0) = (4/3, −2/3): the second
    /// contact still closes, and pushes 1/3 more.
    #[test]
    fn poisson_pushes_again_where_expansion_leaves_something_closing() {
        let row = closed(&[2.0, -1.0, -1.0, 2.0], &[&[0], &[1]]);
        let before = DVector::from_vec(vec![-1.0, 0.0]);
        let impulses = row.poisson_impact(&before, &[1.0, 0.0]).unwrap();
        assert!((impulses[0] - 4.0 / 3.0).abs() < 1e-14 && (impulses[1] - 2.0 / 3.0).abs() < 1e-14, "{impulses}");
    }

    /// Truth: three equal masses in a row; the second contact opens at 0.5 before the impact. It neither pushes nor
    /// opens after the impact. If it opens faster before the impact, it also opens after it.
    #[test]
    fn contacts_share_in_an_impact_by_pushing_or_parting_or_neither() {
        let row = closed(&[2.0, -1.0, -1.0, 2.0], &[&[0], &[1]]);
        let shares = |c: &[f64]| {
            let c = DVector::from_column_slice(c);
            row.impact_shares(&c, &row.contact_impulses(&c).unwrap())
        };
        assert_eq!(shares(&[-1.0, 0.0]), [ImpactShare::Pushes, ImpactShare::Pushes]);
        assert_eq!(shares(&[-1.0, 0.25]), [ImpactShare::Pushes, ImpactShare::Pushes]);
        assert_eq!(shares(&[-1.0, 0.75]), [ImpactShare::Pushes, ImpactShare::Parts]);
        assert_eq!(shares(&[-1.0, 0.5]), [ImpactShare::Pushes, ImpactShare::Neither]);
    }

    /// Four legs of a table that falls flat: their rows have the rank 3, and the velocities after the impact are unique
    /// all the same.
    #[test]
    fn rows_that_depend_on_one_another_have_impulses_of_least_size() {
        let ones = vec![1.0; 16];
        let table = closed(&ones, &[&[0], &[1], &[2], &[3]]);
        let before = DVector::from_vec(vec![-1.0; 4]);
        let impulses = table.newton_impact(&before, &[0.5; 4]).unwrap();
        assert!((impulses.sum() - 1.5).abs() < 1e-14 && impulses.iter().all(|x| *x >= 0.0), "{impulses}");
    }

    /// A wedge between two walls that both close: no impulses separate the bodies, which is reported as an error.
    #[test]
    fn what_no_impulse_parts_is_said() {
        let wedged = closed(&[1.0, -1.0, -1.0, 1.0], &[&[0], &[1]]);
        assert!(
            wedged.newton_impact(&DVector::from_vec(vec![-1.0, -1.0]), &[0.0, 0.0]) == Err(UndecidedContacts::Nothing)
        );
    }

    /// A contact without a slip row: a point mass that comes in at an angle is pushed along the normal alone.
    #[test]
    fn a_contact_without_slip_takes_the_velocity_along_it() {
        let rough = closed(&[0.5, 0.0, 0.0, 0.5], &[&[0, 1]]);
        let before = DVector::from_vec(vec![-1.0, 3.0]);
        let impulses = rough.newton_impact(&before, &[0.5]).unwrap();
        let after = before + &rough.compliance * impulses;
        assert!((after[0] - 0.5).abs() < 1e-14 && after[1].abs() < 1e-14, "{after}");
    }

    /// Three contacts, of which the outer two slip in opposite directions. The entries of the matrix have very
    /// different sizes, and its singular values are known to few digits. Truth: with the friction of each slip
    /// inserted, the forces along the gaps solve three equations, and all three are positive.
    #[test]
    fn contacts_with_entries_of_very_different_sizes_push_together() {
        let (a, b) = (0.000_100_996_633_714_906_53, 0.005_049_158_356_898_252);
        let (x, y, z) = (0.587_489_711_545_432, 0.252_424_255_891_537_6, 0.023_137_449_192_242_29);
        let g = [
            [1.638_435_986_825_109, x, a, a, b],
            [x, 0.981_012_836_669_957_1, b, b, y],
            [a, b, 7.064_054_485_005_78, a, b],
            [a, b, a, 0.585_561_814_984_556_6, z],
            [b, y, b, z, 1.328_861_773_123_242],
        ];
        let three = ClosedContacts {
            compliance: DMatrix::from_fn(5, 5, |i, j| g[i][j]),
            rows: vec![vec![0, 1], vec![2], vec![3, 4]],
            friction: vec![Some(0.78), None, Some(0.08)],
        };
        let c = DVector::from_vec(vec![
            -9.476_405_074_815_432,
            -0.704_821_167_727_817_7,
            -9.812_030_410_216_18,
            -9.147_180_939_245_233,
            -0.040_794_709_212_863_24,
        ]);
        let found = three.contact_modes(&c, &[Some(1.0), None, Some(-1.0)]).unwrap();
        assert_eq!(found[0].modes, [ContactMode::Slips(1.0), ContactMode::Pushes, ContactMode::Slips(-1.0)]);
        let (forces, after) = (&found[0].forces, &three.compliance * &found[0].forces + &c);
        assert!([0, 2, 3].iter().all(|row| after[*row].abs() < 1e-13 && forces[*row] > 1.0), "{forces}{after}");
        assert!((forces[1] + 0.78 * forces[0]).abs() < 1e-13 && (forces[4] - 0.08 * forces[3]).abs() < 1e-13);
    }
}
