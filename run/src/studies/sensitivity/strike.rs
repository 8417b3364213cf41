//! An impact as a sequence of strikes. The impulses of a strike follow from the velocities before it and the rows that
//! one set of contacts holds.

use super::forces::NOTHING;
use super::grip::Grip;
use crate::preparation::impacts::{Contacts, Crossing, HeldContacts, Operators, Response};
use nalgebra::DVector;
use tripos_sim::{Failure, Share};

/// Law that determines the impulses of a strike.
#[derive(Clone, Debug, PartialEq)]
pub enum Law {
    /// Impulses remove the velocities along gaps times 1 + e, by Newton's law.
    Turn,
    /// Impulses remove the velocities, by Poisson's law or to bring contacts to rest. Impulses `given` along gaps cause
    /// friction as well.
    Stop { given: Option<DVector<f64>> },
    /// Impulses along gaps are e times those of the strike before, which the variant holds, by Poisson's law.
    Return(DVector<f64>),
}

/// Impulses at a state, with the law that determines them.
pub struct Strike {
    /// State before the impulses.
    pub y: Vec<f64>,
    pub operators: Operators,
    pub law: Law,
    /// Impulses along all rows of contacts.
    pub impulses: DVector<f64>,
    /// Rows from whose motion the impulses follow, and friction of slipping contacts.
    pub grip: Grip,
    /// Indices of the contacts that neither push nor open.
    pub undecided: Vec<usize>,
    /// Indices of the contacts that take part by Newton's law though their gaps have no velocity. They would take no
    /// part if their gaps opened.
    pub resting: Vec<usize>,
    /// Other sets of rows and friction by which contacts with friction may get the same motion.
    pub others: Vec<Grip>,
}

/// Computes the strikes of a crossing, in their order. Contacts that are held after the crossing are brought to rest,
/// even if they rest already.
///
/// # Errors
/// [`Failure`] if a quantity of the contacts has no value.
pub fn strikes(contacts: &Contacts<'_>, crossing: &Crossing<'_>) -> Result<Vec<Strike>, Failure> {
    let after = crossing.after;
    let mut made = Making { contacts, y: crossing.before.to_vec(), list: Vec::new() };
    for hit in &after.hits {
        if contacts.is_poisson() {
            made.push(hit, Law::Stop { given: None })?;
            let given = made.give_back()?;
            made.push(hit, Law::Stop { given: Some(given) })?;
        } else {
            made.push(hit, Law::Turn)?;
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
        made.rest(&still)?;
    }
    Ok(made.list)
}

/// Vector over all rows that holds a coefficient of each contact at the row of its gap, and 0 at rows of slips.
pub fn along_rows(contacts: &Contacts<'_>, of: impl Fn(usize) -> f64) -> DVector<f64> {
    let mut all = DVector::zeros(contacts.count);
    contacts.rows.iter().enumerate().for_each(|(at, rows)| all[rows[0]] = of(at));
    all
}

/// Strikes of a crossing so far, and the state after them.
struct Making<'m> {
    contacts: &'m Contacts<'m>,
    y: Vec<f64>,
    list: Vec<Strike>,
}

impl Making<'_> {
    /// Response of the velocities to impulses at the present state.
    fn response(&self) -> Result<Response, Failure> {
        self.contacts.response(&self.y, &self.contacts.rates(&self.y))
    }

    /// Adds a strike of the contacts `which`, whose impulses push and remove the velocities that the law states.
    fn push(&mut self, which: &[usize], law: Law) -> Result<(), Failure> {
        let contacts = self.contacts;
        let response = self.response()?;
        let (closed, rows) = contacts.closed(&response, which);
        let e =
            along_rows(contacts, |at| if law == Law::Turn { contacts.turns(at, &response.velocities) } else { 0.0 });
        let taken = response.velocities.component_mul(&e.add_scalar(1.0)).select_rows(&rows);
        if which.iter().any(|at| contacts.friction(*at).is_some()) {
            let given = match &law {
                Law::Stop { given: Some(given) } => given.clone(),
                _ => DVector::zeros(contacts.count),
            };
            let along_gaps: Vec<f64> = which.iter().map(|at| given[contacts.rows[*at][0]]).collect();
            let found = closed.tried(&taken, &vec![None; which.len()], &along_gaps).map_err(|_| unknown())?;
            let grips: Vec<Grip> = found.iter().map(|found| Grip::found(contacts, which, found)).collect();
            let impulses = contacts.spread(&found[0].forces, &rows);
            let (grip, others) = (grips[0].clone(), grips[1..].to_vec());
            return self.add(law, impulses, grip, Vec::new(), others);
        }
        let impulses = closed.push(&taken).map_err(|_| unknown())?;
        let shares = closed.shares(&taken, &impulses);
        let of = |wanted: &dyn Fn(Share) -> bool| -> Vec<usize> {
            which.iter().zip(&shares).filter(|(_, share)| wanted(**share)).map(|(at, _)| *at).collect()
        };
        let rows_of = of(&|share| share != Share::Parts).into_iter().flat_map(|at| contacts.rows[at].clone()).collect();
        let grip = Grip { rows: rows_of, slips: Vec::new() };
        let undecided = of(&|share| share == Share::Neither);
        self.add(law, contacts.spread(&impulses, &rows), grip, undecided, Vec::new())
    }

    /// Records the contacts of the last strike whose gaps had no velocity. A contact that was held is left out: its
    /// velocity stays zero whatever is varied.
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

    /// Adds a strike with e times the last impulses along gaps, and returns its impulses.
    fn give_back(&mut self) -> Result<DVector<f64>, Failure> {
        let nothing = || DVector::zeros(self.contacts.count);
        let compression = self.list.last().map_or_else(nothing, |strike| strike.impulses.clone());
        let given = along_rows(self.contacts, |at| self.contacts.impacts[at].restitution).component_mul(&compression);
        self.add(Law::Return(compression), given.clone(), Grip::default(), Vec::new(), Vec::new())?;
        Ok(given)
    }

    /// Adds a strike whose impulses bring contacts to rest.
    fn rest(&mut self, still: &HeldContacts) -> Result<(), Failure> {
        let contacts = self.contacts;
        let response = self.response()?;
        let (closed, rows) = contacts.closed(&response, &still.which);
        let impulses = closed.hold(&response.velocities.select_rows(&rows), &still.modes).ok_or_else(unknown)?;
        let impulses = contacts.spread(&impulses, &rows);
        self.add(Law::Stop { given: None }, impulses, Grip::of(contacts, still), Vec::new(), Vec::new())
    }

    /// Adds a strike with known impulses, and applies them to the state. `undecided` and `others` are the fields of
    /// [`Strike`].
    fn add(
        &mut self,
        law: Law,
        impulses: DVector<f64>,
        grip: Grip,
        undecided: Vec<usize>,
        others: Vec<Grip>,
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

fn unknown() -> Failure {
    Failure { code: "not-finite", message: "the impulses of an impact could not be computed a second time".to_owned() }
}
