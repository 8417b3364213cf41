//! What happens where contacts are closed together: an impact, and which of them are held from there on.

use super::contacts::Response;
use super::held::Held;
use super::{Bouncing, NOTHING};
use nalgebra::DVector;
use tripos_sim::{Failure, ImpactRecord, SimError};

/// Contacts that are closed at one instant, and the one of them that opens there.
pub struct Meeting<'m> {
    pub closed: &'m [usize],
    pub opens: Option<usize>,
}

/// What becomes of contacts that are closed: which are held, and which would bounce too short.
struct Settled {
    held: Vec<usize>,
    short: Vec<usize>,
}

/// A state after velocities jumped, if they did, and which contacts are held from there on.
pub struct After {
    pub y: Vec<f64>,
    pub record: Option<ImpactRecord>,
    pub held: Vec<usize>,
    /// The contacts that were closed.
    pub closed: Vec<usize>,
    /// Whether they had impulses by the law of impact.
    pub is_hit: bool,
    /// Which of them were then brought to rest.
    pub rested: Vec<usize>,
}

impl After {
    /// A state at which nothing is closed.
    pub fn unchanged(y: &[f64]) -> Self {
        let none = Vec::new;
        Self { y: y.to_vec(), record: None, held: none(), closed: none(), is_hit: false, rested: none() }
    }
}

/// Impulses along all rows together, and what they did.
struct Blow {
    y: Vec<f64>,
    impulses: DVector<f64>,
    loss: f64,
    work: f64,
    /// What impulses did to each row, whatever the sign, J: the size of loss and work.
    turnover: f64,
}

impl Bouncing<'_> {
    /// Contacts that are closed at an instant: an impact if one of them closes further, then what is held.
    pub(super) fn meet(
        &self,
        (t, y): (f64, &[f64]),
        meeting: &Meeting<'_>,
    ) -> Result<Result<After, Failure>, SimError> {
        let mut free = Held { rhs: (self.equations)()?, contacts: self.contacts, which: &[] };
        Ok(self.met(&mut free, (t, y), meeting))
    }

    fn met(&self, free: &mut Held<'_>, (t, y): (f64, &[f64]), meeting: &Meeting<'_>) -> Result<After, Failure> {
        let mut blow = self.hit((t, y), meeting)?;
        let is_hit = blow.impulses.iter().any(|impulse| *impulse != 0.0);
        let (mut is_impact, mut rested) = (is_hit, Vec::new());
        let scale = self.speeds(y)?.zip_map(&self.speeds(&blow.y)?, f64::max);
        let Settled { mut held, short } = self.settle(free, (t, &blow.y), meeting, &scale)?;
        let more = short.iter().filter(|at| !held.contains(at));
        let all: Vec<usize> = held.iter().chain(more).copied().collect();
        if let Some((last, slips)) = self.bring_to_rest(&blow.y, &all, &scale)? {
            is_impact |= slips || !short.is_empty();
            blow = Blow {
                y: last.y,
                impulses: blow.impulses + last.impulses,
                loss: blow.loss + last.loss,
                work: blow.work + last.work,
                turnover: blow.turnover + last.turnover,
            };
            held = self.settle(free, (t, &blow.y), meeting, &scale)?.held;
            rested = all;
        }
        if blow.loss < -NOTHING.sqrt() * blow.turnover {
            let message = format!(
                "the impact at t = {t} s would create energy, {} J: contacts that do not slip and give back what closes them can do that, by Newton's law; \
                 give them a restitution of 0, or leave `no_slip` out",
                -blow.loss
            );
            return Err(Failure { code: "impact", message });
        }
        let normal = |contact: &usize| (*contact, blow.impulses[self.contacts.rows[*contact][0]]);
        let impulses = meeting.closed.iter().map(normal).filter(|(_, impulse)| *impulse != 0.0).collect();
        let record = ImpactRecord { t, impulses, before: y.to_vec(), loss: blow.loss, work: blow.work, held: short };
        let (record, closed) = (is_impact.then_some(record), meeting.closed.to_vec());
        Ok(After { y: blow.y, record, held, closed, is_hit, rested })
    }

    /// The impact of contacts that are closed together; no impulses where nothing closes.
    fn hit(&self, (t, y): (f64, &[f64]), meeting: &Meeting<'_>) -> Result<Blow, Failure> {
        let rates = self.contacts.rates(y);
        let response = self.contacts.response(y, &rates)?;
        let scale = self.speeds(y)?;
        let normal = |contact: &usize| self.contacts.rows[*contact][0];
        let name = |contact: &usize| format!("`{}`", self.contacts.impacts[*contact].name);
        let closed = meeting.closed;
        if let Some(fixed) = closed.iter().find(|at| response.compliance[(normal(at), normal(at))] <= 0.0) {
            let message = format!(
                "the contact {} is closed at t = {t} s, and no motion that the mechanism has changes its gap there",
                name(fixed)
            );
            return Err(Failure { code: "impact", message });
        }
        let closes = |at: &usize| response.velocities[normal(at)] < -NOTHING * scale[normal(at)];
        if meeting.opens.is_some() || !closed.iter().any(closes) {
            return Ok(struck(y, &response, DVector::zeros(self.contacts.count)));
        }
        let impulses = self.contacts.impulses(&response, closed).ok_or_else(|| {
            let names: Vec<String> = closed.iter().map(name).collect();
            let message = format!("no impulses part what closes at t = {t} s: {}", names.join(", "));
            Failure { code: "impact", message }
        })?;
        Ok(struck(y, &response, impulses))
    }

    /// Which of the contacts that are closed and at rest are pushed together and stay so, and of which others the next flight would be too short.
    fn settle(
        &self,
        free: &mut Held<'_>,
        (t, y): (f64, &[f64]),
        meeting: &Meeting<'_>,
        scale: &DVector<f64>,
    ) -> Result<Settled, Failure> {
        let now = free.free(t, y)?;
        let normal = |contact: &usize| self.contacts.rows[*contact][0];
        let velocity = |contact: &usize| now.response.velocities[normal(contact)];
        let is_still = |at: &usize| velocity(at).abs() <= NOTHING * scale[normal(at)];
        // What a flight of the shortest time could give.
        let slow = |at: &usize, accelerations: &DVector<f64>| {
            self.contacts.slow(*at, y, accelerations[normal(at)], self.least)
        };
        let is_slow = |at: &usize| velocity(at).abs() <= slow(at, &now.accelerations);
        let stays = |at: &usize| meeting.opens != Some(*at);
        let (rest, moving): (Vec<usize>, Vec<usize>) =
            meeting.closed.iter().copied().filter(stays).partition(|at| is_still(at) || is_slow(at));
        let (system, rows) = self.contacts.closed(&now.response, &rest);
        let pushed = system.push(&now.accelerations.select_rows(&rows)).ok_or_else(|| Failure {
            code: "impact",
            message: format!("no forces keep apart what is closed at t = {t} s"),
        })?;
        let forces = self.contacts.spread(&pushed, &rows);
        let accelerations = &now.accelerations + &now.response.compliance * &forces;
        let nothing = NOTHING * now.accelerations.amax();
        // What neither pushes nor opens stays as well, if that takes no friction.
        let lies = |at: &usize| self.contacts.rows[*at].len() == 1 && accelerations[normal(at)] <= nothing;
        let held: Vec<usize> = rest.into_iter().filter(|at| forces[normal(at)] > 0.0 || lies(at)).collect();
        let bounces = |at: &&usize| !is_still(at) && velocity(at) > 0.0 && meeting.opens.is_none();
        let falls = |at: &usize| velocity(at) > 0.0 && accelerations[normal(at)] < 0.0;
        let is_short = |at: &usize| falls(at) && velocity(at) <= slow(at, &accelerations);
        let short = held.iter().filter(bounces).copied().chain(moving.into_iter().filter(is_short)).collect();
        Ok(Settled { held, short })
    }

    /// What takes the last velocities from contacts that are to be held, and whether one of them slips; nothing if they have none.
    fn bring_to_rest(&self, y: &[f64], held: &[usize], scale: &DVector<f64>) -> Result<Option<(Blow, bool)>, Failure> {
        let response = self.contacts.response(y, &self.contacts.rates(y))?;
        let (closed, rows) = self.contacts.closed(&response, held);
        let left = response.velocities.select_rows(&rows);
        if left.iter().all(|velocity| *velocity == 0.0) {
            return Ok(None);
        }
        let mut slips = held.iter().flat_map(|at| self.contacts.rows[*at][1..].iter());
        let slipping = slips.any(|row| response.velocities[*row].abs() > NOTHING * scale[*row]);
        let places: Vec<usize> = (0..held.len()).collect();
        let some = closed.hold(&left, &places).ok_or_else(|| Failure {
            code: "not-finite",
            message: "the impulses that bring contacts to rest are not finite".to_owned(),
        })?;
        Ok(Some((struck(y, &response, self.contacts.spread(&some, &rows)), slipping)))
    }

    /// By what the velocities of rows are measured: their parts by each motion variable, and what drives them.
    fn speeds(&self, y: &[f64]) -> Result<DVector<f64>, Failure> {
        let rates = self.contacts.rates(y);
        let driven = self.contacts.response(y, &rates)?.driven;
        let n = self.contacts.system.lengths().coordinates;
        let of_row = |row: usize, _| {
            let parts = (n..y.len()).map(|at| (rates.slopes[(row, at)] * y[at]).abs()).sum::<f64>();
            parts + driven[row].abs()
        };
        Ok(DVector::from_fn(self.contacts.count, of_row))
    }
}

/// What impulses along all rows do to a state.
fn struck(y: &[f64], response: &Response, impulses: DVector<f64>) -> Blow {
    let mut after = y.to_vec();
    let changes = &response.changes * &impulses;
    let first = after.len() - changes.len();
    for (v, change) in after[first..].iter_mut().zip(changes.iter()) {
        *v += change;
    }
    // Thomson and Tait: impulses work on the mean of the velocities before and after.
    let velocities = &response.velocities * 2.0 + &response.compliance * &impulses;
    let loss = -0.5 * impulses.dot(&velocities);
    let work = -impulses.dot(&response.driven);
    let turnover = impulses.zip_fold(&velocities, 0.0, |sum, impulse, velocity| sum + (impulse * velocity).abs());
    Blow { y: after, impulses, loss, work, turnover }
}
