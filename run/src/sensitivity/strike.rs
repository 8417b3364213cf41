//! An impact as a sequence of impulses, each of which follows from the velocities before it by one set of contacts.

use crate::impacts::{Contacts, Crossing, Kept, Operators};
use nalgebra::DVector;
use tripos_derive::scene::ImpactLaw;
use tripos_sim::{Failure, Share};

/// What impulses follow from.
#[derive(Clone, Debug, PartialEq)]
pub enum Law {
    /// They take 1 + e of the velocities along gaps, by Newton's law.
    Turn,
    /// They take velocities away.
    Stop,
    /// They are parts e of the impulses of the strike before, along all rows, by Poisson's law.
    Return(DVector<f64>),
}

/// Impulses at a state.
pub struct Strike {
    /// The state before.
    pub y: Vec<f64>,
    pub operators: Operators,
    pub law: Law,
    /// Along all rows.
    pub impulses: DVector<f64>,
    /// The rows along which they follow from velocities.
    pub rows: Vec<usize>,
    /// The contacts that neither push nor open.
    pub undecided: Vec<usize>,
}

/// The impulses of a crossing, one after the other. What is held afterwards is brought to rest, also where it is.
///
/// # Errors
/// [`Failure`] where something has no value.
pub fn strikes(contacts: &Contacts<'_>, crossing: &Crossing<'_>) -> Result<Vec<Strike>, Failure> {
    let after = crossing.after;
    let mut made = Making { contacts, y: crossing.before.to_vec(), list: Vec::new() };
    let is_poisson = contacts.impacts.first().is_some_and(|impact| impact.law == ImpactLaw::Poisson);
    match after.is_hit {
        true if is_poisson => {
            made.push(&after.closed, Law::Stop)?;
            let compression = made.list.last().map(|strike| strike.impulses.clone());
            made.give_back(&compression.unwrap_or_else(|| DVector::zeros(contacts.count)))?;
            made.push(&after.closed, Law::Stop)?;
        }
        true => made.push(&after.closed, Law::Turn)?,
        false => {}
    }
    let still: Vec<usize> =
        after.closed.iter().copied().filter(|at| after.kept.mode(*at).is_some() || after.rested.contains(at)).collect();
    if !still.is_empty() {
        made.rest(&still)?;
    }
    Ok(made.list)
}

/// The coefficients of restitution along gaps, 0 along slips.
pub fn along_rows(contacts: &Contacts<'_>, of: impl Fn(usize) -> f64) -> DVector<f64> {
    let mut all = DVector::zeros(contacts.count);
    contacts.rows.iter().enumerate().for_each(|(at, rows)| all[rows[0]] = of(at));
    all
}

/// Impulses so far, and the state after them.
struct Making<'m> {
    contacts: &'m Contacts<'m>,
    y: Vec<f64>,
    list: Vec<Strike>,
}

impl Making<'_> {
    /// Impulses that push, from what velocities a law takes.
    fn push(&mut self, which: &[usize], law: Law) -> Result<(), Failure> {
        let contacts = self.contacts;
        let response = contacts.response(&self.y, &contacts.rates(&self.y))?;
        let (closed, rows) = contacts.closed(&response, which);
        let e =
            along_rows(contacts, |at| if law == Law::Turn { contacts.turns(at, &response.velocities) } else { 0.0 });
        let taken = response.velocities.component_mul(&e.add_scalar(1.0)).select_rows(&rows);
        let impulses = closed.push(&taken).map_err(|_| unknown())?;
        let shares = closed.shares(&taken, &impulses);
        let of = |wanted: &dyn Fn(Share) -> bool| -> Vec<usize> {
            which.iter().zip(&shares).filter(|(_, share)| wanted(**share)).map(|(at, _)| *at).collect()
        };
        let rows_of = of(&|share| share != Share::Parts).into_iter().flat_map(|at| contacts.rows[at].clone()).collect();
        self.add(law, contacts.spread(&impulses, &rows), rows_of, of(&|share| share == Share::Neither))
    }

    /// Parts e of impulses.
    fn give_back(&mut self, compression: &DVector<f64>) -> Result<(), Failure> {
        let e = along_rows(self.contacts, |at| self.contacts.impacts[at].restitution);
        self.add(Law::Return(compression.clone()), e.component_mul(compression), Vec::new(), Vec::new())
    }

    /// Impulses that bring contacts to rest.
    fn rest(&mut self, which: &[usize]) -> Result<(), Failure> {
        let contacts = self.contacts;
        let response = contacts.response(&self.y, &contacts.rates(&self.y))?;
        let (closed, rows) = contacts.closed(&response, which);
        let modes = Kept::firm(contacts, which).modes;
        let impulses = closed.hold(&response.velocities.select_rows(&rows), &modes).ok_or_else(unknown)?;
        let impulses = contacts.spread(&impulses, &rows);
        self.add(Law::Stop, impulses, rows, Vec::new())
    }

    fn add(
        &mut self,
        law: Law,
        impulses: DVector<f64>,
        rows: Vec<usize>,
        undecided: Vec<usize>,
    ) -> Result<(), Failure> {
        let operators = self.contacts.operators(&self.y, &self.contacts.rates(&self.y))?;
        let changes = &operators.basis * operators.inertia.solve(&(operators.of_u.transpose() * &impulses));
        let before = self.y.clone();
        let first = before.len() - changes.len();
        self.y[first..].iter_mut().zip(changes.iter()).for_each(|(v, change)| *v += change);
        self.list.push(Strike { y: before, operators, law, impulses, rows, undecided });
        Ok(())
    }
}

fn unknown() -> Failure {
    Failure { code: "not-finite", message: "the impulses of an impact are not found again".to_owned() }
}
