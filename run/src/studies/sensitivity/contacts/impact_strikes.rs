//! Splits an impact into a sequence of strikes. A strike is a step of the impact, with a fixed set of
//! held contacts. Its impulses follow from the velocities before it.

use super::held_contact_forces::NOTHING;
use super::held_directions::HeldDirections;
use crate::preparation::impacts::{ContactCrossing, ContactOperators, HeldContacts, ImpulseResponse, SceneContacts};
use nalgebra::DVector;
use tripos_sim::{Failure, ImpactShare};

/// Law that determines the impulses of a strike (a step of an impact).
#[derive(Clone, Debug, PartialEq)]
pub enum StrikeLaw {
    /// Newton's law: impulses change each gap velocity by 1 + e times its value, with the restitution e.
    Turn,
    /// Impulses remove the velocities. This is the compression of Poisson's law, or brings contacts to
    /// rest. Known impulses `given` along gaps cause friction too; `None` if there are none.
    Stop { given: Option<DVector<f64>> },
    /// Expansion of Poisson's law: impulses along gaps are e times those of the strike before. The value
    /// has the impulses of the strike before.
    Return(DVector<f64>),
}

/// Strike (a step of an impact): impulses of contacts at a state, with the law that determines them.
pub struct Strike {
    /// State (q, v) before the impulses.
    pub y: Vec<f64>,
    /// Matrices at this state that relate generalized speeds, impulses of contacts and kinetic energy.
    pub operators: ContactOperators,
    /// Law that determines the impulses.
    pub law: StrikeLaw,
    /// Impulses of this strike along the gap and slip directions of all contacts.
    pub impulses: DVector<f64>,
    /// Held directions, whose motion determines the impulses, and the friction of slipping contacts.
    pub grip: HeldDirections,
    /// Indices of the contacts that neither push nor open in this strike, up to rounding.
    pub undecided: Vec<usize>,
    /// Indices of the contacts that take part by Newton's law although their gap velocity is zero. A
    /// contact whose gap opens would take no part.
    pub resting: Vec<usize>,
    /// Other choices of held directions and friction that give the contacts the same motion.
    pub others: Vec<HeldDirections>,
}

/// Computes the strikes (steps of an impact) at a change of contacts, in their order. The last strike
/// brings to rest the contacts that are held afterwards, even if they are at rest already.
///
/// # Errors
/// [`Failure`] if impulses cannot be computed, or a permitted motion has no inertia.
pub fn strikes(contacts: &SceneContacts<'_>, crossing: &ContactCrossing<'_>) -> Result<Vec<Strike>, Failure> {
    let after = crossing.after;
    let mut made = StrikeBuilder { contacts, y: crossing.before.to_vec(), list: Vec::new() };
    for hit in &after.hits {
        if contacts.is_poisson() {
            made.add_pushing_strike(hit, StrikeLaw::Stop { given: None })?;
            let given = made.add_expansion_strike()?;
            made.add_pushing_strike(hit, StrikeLaw::Stop { given: Some(given) })?;
        } else {
            made.add_pushing_strike(hit, StrikeLaw::Turn)?;
            made.note_resting(hit, crossing.kept);
        }
    }
    let mut still = HeldContacts::default();
    for at in &after.closed {
        if let Some(mode) = after.rested.mode(*at).or_else(|| after.kept.mode(*at)) {
            still.push(*at, mode);
        }
    }
    if !still.is_empty() {
        made.add_stopping_strike(&still)?;
    }
    Ok(made.list)
}

/// Makes a vector over the gap and slip directions of all contacts. At the gap direction of a contact
/// it has the value of `of` for this contact. At slip directions it is 0.
pub fn vector_over_gap_rows(contacts: &SceneContacts<'_>, of: impl Fn(usize) -> f64) -> DVector<f64> {
    let mut all = DVector::zeros(contacts.count);
    contacts.rows.iter().enumerate().for_each(|(at, rows)| all[rows[0]] = of(at));
    all
}

/// Strikes (steps of an impact) that are computed so far, and the state after them.
struct StrikeBuilder<'m> {
    /// Contacts of the scene.
    contacts: &'m SceneContacts<'m>,
    /// State (q, v) after the strikes so far.
    y: Vec<f64>,
    /// Strikes so far, in their order.
    list: Vec<Strike>,
}

impl StrikeBuilder<'_> {
    /// Response of the gap and slip velocities to impulses, at the state after the strikes so far. It
    /// relates each velocity to each impulse.
    ///
    /// # Errors
    /// `Failure` if a permitted motion has no inertia.
    fn response(&self) -> Result<ImpulseResponse, Failure> {
        self.contacts.response(&self.y, &self.contacts.rates(&self.y))
    }

    /// Adds a strike of the contacts `which`. Its impulses push the contacts apart and remove the part of
    /// the velocities that the law states.
    ///
    /// # Errors
    /// `Failure` if the impulses cannot be computed.
    fn add_pushing_strike(&mut self, which: &[usize], law: StrikeLaw) -> Result<(), Failure> {
        let contacts = self.contacts;
        let response = self.response()?;
        let (closed, rows) = contacts.closed_contact_system(&response, which);
        let e = vector_over_gap_rows(contacts, |at| {
            if law == StrikeLaw::Turn { contacts.newton_restitution(at, &response.velocities) } else { 0.0 }
        });
        let taken = response.velocities.component_mul(&e.add_scalar(1.0)).select_rows(&rows);
        if which.iter().any(|at| contacts.friction(*at).is_some()) {
            let given = match &law {
                StrikeLaw::Stop { given: Some(given) } => given.clone(),
                _ => DVector::zeros(contacts.count),
            };
            let along_gaps: Vec<f64> = which.iter().map(|at| given[contacts.rows[*at][0]]).collect();
            let found = closed
                .contact_modes_under_given_impulses(&taken, &vec![None; which.len()], &along_gaps)
                .map_err(|_| unknown_strike_impulses_failure())?;
            let grips: Vec<HeldDirections> =
                found.iter().map(|found| HeldDirections::of_impact_modes(contacts, which, found)).collect();
            let impulses = contacts.spread_over_contact_rows(&found[0].forces, &rows);
            let (grip, others) = (grips[0].clone(), grips[1..].to_vec());
            return self.add_strike(law, impulses, grip, Vec::new(), others);
        }
        let impulses = closed.contact_impulses(&taken).map_err(|_| unknown_strike_impulses_failure())?;
        let shares = closed.impact_shares(&taken, &impulses);
        let of = |wanted: &dyn Fn(ImpactShare) -> bool| -> Vec<usize> {
            which.iter().zip(&shares).filter(|(_, share)| wanted(**share)).map(|(at, _)| *at).collect()
        };
        let rows_of =
            of(&|share| share != ImpactShare::Parts).into_iter().flat_map(|at| contacts.rows[at].clone()).collect();
        let grip = HeldDirections { rows: rows_of, slips: Vec::new() };
        let undecided = of(&|share| share == ImpactShare::Neither);
        self.add_strike(law, contacts.spread_over_contact_rows(&impulses, &rows), grip, undecided, Vec::new())
    }

    /// Records in the last strike the contacts whose gap velocity was zero. Contacts that were held
    /// closed before are left out, because no varied number changes their gap velocity.
    fn note_resting(&mut self, hit: &[usize], kept: &HeldContacts) {
        let contacts = self.contacts;
        let Some(strike) = self.list.last_mut() else { return };
        let (rates, first) = (contacts.rates(&strike.y), strike.y.len() - strike.operators.basis.nrows());
        let rests = |at: &usize| {
            let row = contacts.rows[*at][0];
            let parts: f64 = (first..strike.y.len()).map(|at| (rates.slopes[(row, at)] * strike.y[at]).abs()).sum();
            rates.values[row].abs() <= NOTHING * parts
        };
        strike.resting = hit.iter().copied().filter(|at| kept.mode(*at).is_none() && rests(at)).collect();
    }

    /// Adds the strike of the expansion by Poisson's law. Its impulses along gaps are e times the impulses
    /// of the strike before. Returns these impulses.
    ///
    /// # Errors
    /// `Failure` if a permitted motion has no inertia.
    fn add_expansion_strike(&mut self) -> Result<DVector<f64>, Failure> {
        let nothing = || DVector::zeros(self.contacts.count);
        let compression = self.list.last().map_or_else(nothing, |strike| strike.impulses.clone());
        let given =
            vector_over_gap_rows(self.contacts, |at| self.contacts.impacts[at].restitution).component_mul(&compression);
        self.add_strike(
            StrikeLaw::Return(compression),
            given.clone(),
            HeldDirections::default(),
            Vec::new(),
            Vec::new(),
        )?;
        Ok(given)
    }

    /// Adds a strike whose impulses bring the contacts `still` to rest.
    ///
    /// # Errors
    /// `Failure` if the impulses are not finite.
    fn add_stopping_strike(&mut self, still: &HeldContacts) -> Result<(), Failure> {
        let contacts = self.contacts;
        let response = self.response()?;
        let (closed, rows) = contacts.closed_contact_system(&response, &still.which);
        let impulses = closed
            .forces_in_contact_modes(&response.velocities.select_rows(&rows), &still.modes)
            .ok_or_else(unknown_strike_impulses_failure)?;
        let impulses = contacts.spread_over_contact_rows(&impulses, &rows);
        self.add_strike(
            StrikeLaw::Stop { given: None },
            impulses,
            HeldDirections::of_held_contacts(contacts, still),
            Vec::new(),
            Vec::new(),
        )
    }

    /// Adds a strike with known impulses, and applies these impulses to the state. `undecided` and
    /// `others` become the fields of the [`Strike`].
    ///
    /// # Errors
    /// `Failure` if a permitted motion has no inertia.
    fn add_strike(
        &mut self,
        law: StrikeLaw,
        impulses: DVector<f64>,
        grip: HeldDirections,
        undecided: Vec<usize>,
        others: Vec<HeldDirections>,
    ) -> Result<(), Failure> {
        let operators = self.contacts.operators(&self.y, &self.contacts.rates(&self.y))?;
        let changes = &operators.basis * operators.inertia.solve(&(operators.of_u.transpose() * &impulses));
        let before = self.y.clone();
        let first = before.len() - changes.len();
        self.y[first..].iter_mut().zip(changes.iter()).for_each(|(v, change)| *v += change);
        let resting = Vec::new();
        self.list.push(Strike { y: before, operators, law, impulses, grip, undecided, resting, others });
        Ok(())
    }
}

/// Makes the failure for an impact whose impulses cannot be computed a second time.
fn unknown_strike_impulses_failure() -> Failure {
    Failure { code: "not-finite", message: "the impulses of an impact could not be computed a second time".to_owned() }
}
