//! How slopes jump where velocities do, and where contacts are let go, held, stick or slip from there on.
//!
//! At an instant t(p) a motion y⁻(t, p) is taken to y⁺ = R(y⁻, p), from rates f⁻ to f⁺. Slopes at a fixed instant go from s⁻ to
//! s⁺ = R_y (s⁻ + f⁻ dt/dp) + R_p − f⁺ dt/dp, with dt/dp = −(g_y s⁻ + g_p)/(g_y f⁻) of what is zero there: a gap, a force, what friction bears beyond it, or a slip ([`super::zero`]).
//! M. A. Aizerman & F. R. Gantmakher, "On the stability of periodic motions", *Journal of Applied Mathematics and Mechanics* 22 (1958), 1065–1078; P. C. Müller,
//! "Calculation of Lyapunov exponents for dynamic systems with discontinuities", *Chaos, Solitons & Fractals* 5 (1995), 1671–1681. The map is linear in s⁻ and p: forwards it is applied to slopes, and a sweep
//! backwards takes its transpose.
//!
//! R is differentiated with the set of contacts that push, and with what sticks and slips, as it is. Where that changes with what is varied, where contacts that change together do not stay together, or close without a velocity,
//! there is no derivative, and it is said why.

use super::contacts::{Acting, Change, Direction, SMALL, Wide, Without};
use super::forces::{Forces, NOTHING, RatesAlong, Varied};
use super::grip::Grip;
use super::strike::{Law, Strike, along_rows, strikes};
use super::zero::{Coming, Zeros};
use crate::impacts::{Crossing, Kept, NONE};
use nalgebra::DVector;
use tripos_sim::{Failure, Mode};

/// The rates at an instant and a state while contacts are held.
pub type Flow<'c> = dyn Fn(&Kept, f64, &[f64]) -> Result<Vec<f64>, Failure> + 'c;

/// A crossing, and what all directions need of it.
pub struct Crossed<'c> {
    wide: &'c Wide<'c>,
    crossing: &'c Crossing<'c>,
    rates_along: &'c RatesAlong<'c>,
    /// What is zero at the instant.
    zeros: Zeros<'c>,
    strikes: Vec<Strike>,
    /// The rates after, with the forces of contacts that are held.
    rates: Vec<f64>,
    /// These forces; nothing where no contact is held.
    forces: Option<Forces>,
}

/// A direction, taken across a crossing.
pub struct Across {
    /// How the instant moves.
    pub later: f64,
    /// The slopes after it.
    pub slopes: Vec<f64>,
    /// How the impulses of each strike change.
    changes: Vec<Change>,
    /// The slopes before each strike.
    before: Vec<Vec<f64>>,
}

impl<'c> Crossed<'c> {
    /// A crossing in a motion of which `flow` gives the rates while contacts are held.
    ///
    /// # Errors
    /// Why there is no derivative there by anything.
    pub fn new(
        wide: &'c Wide<'c>,
        crossing: &'c Crossing<'c>,
        rates_along: &'c RatesAlong<'c>,
        flow: &Flow<'_>,
    ) -> Result<Self, String> {
        let said = |failure: Failure| failure.message;
        let (t, y, kept) = (crossing.t, &crossing.after.y, &crossing.after.kept);
        let forces = |kept: &Kept, y: &[f64]| -> Result<Option<Forces>, Failure> {
            if kept.is_empty() {
                return Ok(None);
            }
            Forces::new(wide.contacts, kept, y, flow(&NONE, t, y)?).map(Some)
        };
        let coming = Coming {
            wide,
            crossing,
            rates_along,
            rates: flow(crossing.kept, t, crossing.before).map_err(said)?,
            forces: forces(crossing.kept, crossing.before).map_err(said)?,
        };
        Ok(Self {
            wide,
            crossing,
            rates_along,
            zeros: Zeros::new(coming)?,
            strikes: strikes(wide.contacts, crossing).map_err(said)?,
            rates: flow(kept, t, y).map_err(said)?,
            forces: forces(kept, y).map_err(said)?,
        })
    }

    /// How the instant moves, and the slopes after it, from those before.
    ///
    /// # Errors
    /// Why there are none.
    pub fn across(&self, varied: &Varied<'_>, state: &[f64]) -> Result<(f64, Vec<f64>), String> {
        self.begins_together(varied, state)?;
        self.zeros.stay_together(varied, state)?;
        let across = self.linear(varied, state)?;
        self.stays_decided(varied, &across)?;
        self.stays_held(varied, &across.slopes)?;
        Ok((across.later, across.slopes))
    }

    /// Whether contacts hold the same motion, so that there are derivatives by what moves them alike only.
    pub fn shares(&self) -> bool {
        let before = &self.zeros.coming.forces;
        before.iter().chain(&self.forces).any(Forces::are_shared)
    }

    /// Whether there may be derivatives by some numbers only, of those that change the state before.
    pub fn asks(&self) -> bool {
        let is_open = |strike: &Strike| {
            let compliance =
                &strike.operators.of_u * strike.operators.inertia.solve(&strike.operators.of_u.transpose());
            let shared = strike.grip.system(&compliance).shared();
            let is_one = strike.undecided.is_empty() && strike.resting.is_empty() && strike.others.is_empty();
            !is_one || shared.contains(&true)
        };
        self.zeros.ask()
            || self.shares()
            || self.strikes.iter().any(is_open)
            || !self.lying().is_empty()
            || !self.at_limit().is_empty()
            || !self.at_rest().is_empty()
    }

    /// The map of slopes as it is, whether or not what it supposes stays so along this direction.
    ///
    /// # Errors
    /// Where something has no value.
    pub fn linear(&self, varied: &Varied<'_>, state: &[f64]) -> Result<Across, String> {
        let later = self.zeros.later(varied, state)?;
        let mut slopes: Vec<f64> = state.iter().zip(&self.zeros.coming.rates).map(|(s, f)| s + f * later).collect();
        let (mut changes, mut before): (Vec<Change>, _) = (Vec::new(), Vec::new());
        for strike in &self.strikes {
            let change = self.strike((strike, &strike.grip), varied, &slopes, changes.last())?;
            before.push(slopes.clone());
            let first = slopes.len() - change.variables.len();
            slopes[first..].iter_mut().zip(change.variables.iter()).for_each(|(s, more)| *s += more);
            changes.push(change);
        }
        slopes.iter_mut().zip(&self.rates).for_each(|(s, f)| *s -= f * later);
        Ok(Across { later, slopes, changes, before })
    }

    fn name(&self, contact: usize) -> &str {
        &self.wide.contacts.impacts[contact].name
    }

    fn normal(&self, contact: usize) -> usize {
        self.wide.contacts.rows[contact][0]
    }

    /// How the impulses of a strike change, if they follow from what this grip holds, where those of the strike before change so.
    fn strike(
        &self,
        (strike, grip): (&Strike, &Grip),
        varied: &Varied<'_>,
        slopes: &[f64],
        last: Option<&Change>,
    ) -> Result<Change, String> {
        let Strike { y, operators, law, impulses, .. } = strike;
        let acting = Acting { y, operators, impulses, grip };
        let contacts = self.wide.contacts;
        let velocities = contacts.rates(y).values;
        let e = along_rows(contacts, |at| contacts.impacts[at].restitution);
        let turns = along_rows(contacts, |at| contacts.turns(at, &velocities));
        let by_e = along_rows(contacts, |at| varied.restitutions[at]);
        // What opens gives nothing back, whatever its coefficient.
        let by_turns =
            along_rows(contacts, |at| if velocities[self.normal(at)] < 0.0 { varied.restitutions[at] } else { 0.0 });
        let nothing = DVector::zeros(contacts.count);
        let before = last.map_or_else(|| nothing.clone(), |change| change.impulses.clone());
        let (parts, by, given) = match law {
            Law::Turn => (turns.add_scalar(1.0), by_turns, grip.of_coefficients(varied.frictions, impulses)),
            Law::Stop { given: None } => {
                (nothing.add_scalar(1.0), nothing, grip.of_coefficients(varied.frictions, impulses))
            }
            Law::Stop { given: Some(given) } => {
                let friction = grip.of_coefficients(varied.frictions, &(impulses + given)) + grip.of_given(&before);
                (nothing.add_scalar(1.0), nothing, friction)
            }
            // e Λ of the strike before.
            Law::Return(of) => (nothing.clone(), nothing, e.component_mul(&before) + by_e.component_mul(of)),
        };
        let direction = Direction { parameters: varied.parameters, state: slopes };
        let without = Without::Move { parts: parts.as_slice(), by: by.as_slice() };
        self.wide.change(&acting, &without, direction, &given).map_err(|failure| failure.message)
    }

    fn undecided(&self, contact: usize, varied: &Varied<'_>) -> String {
        format!("whether the contact `{}` pushes or opens there changes with `{}`", self.name(contact), varied.name)
    }

    /// Refuses at the start to open a contact that is closed there, or to let it overlap.
    fn begins_together(&self, varied: &Varied<'_>, state: &[f64]) -> Result<(), String> {
        if self.crossing.happening.is_some() {
            return Ok(());
        }
        let after = self.crossing.after;
        let is_struck = |at: &&usize| self.strikes.iter().any(|strike| strike.grip.rows.contains(&self.normal(**at)));
        let hit = after.hits.iter().flatten().filter(is_struck);
        let direction = Direction { parameters: varied.parameters, state };
        for contact in after.kept.which.iter().chain(hit) {
            let (change, size) = self.wide.gap(*contact, self.crossing.before, direction);
            if change.abs() > SMALL * size {
                return Err(format!(
                    "the contact `{}` is closed at the start, and `{}` opens it",
                    self.name(*contact),
                    varied.name
                ));
            }
        }
        Ok(())
    }

    /// Refuses impulses of which others would follow where the number changes.
    fn stays_decided(&self, varied: &Varied<'_>, across: &Across) -> Result<(), String> {
        let largest = across.changes.iter().map(|change| change.size).fold(0.0, f64::max);
        for (at, (strike, change)) in self.strikes.iter().zip(&across.changes).enumerate() {
            if change.is_apart {
                return Err(super::contacts::APART.to_owned());
            }
            let inertia = &strike.operators.inertia;
            let direction = Direction { parameters: varied.parameters, state: &across.before[at] };
            for contact in &strike.resting {
                let (moved, size) = self.wide.velocity(self.normal(*contact), &strike.y, direction);
                if moved.abs() > SMALL * size {
                    let name = self.name(*contact);
                    return Err(format!(
                        "the contact `{name}` is hit at rest, and whether it takes part there changes with `{}`",
                        varied.name
                    ));
                }
            }
            for contact in &strike.undecided {
                let row = strike.operators.of_u.row(self.normal(*contact));
                let g = (row * inertia.solve(&row.transpose()))[0];
                if change.impulses[self.normal(*contact)].abs() * g.sqrt() > SMALL * change.size {
                    return Err(self.undecided(*contact, varied));
                }
            }
            for grip in &strike.others {
                let last = at.checked_sub(1).map(|before| &across.changes[before]);
                let other = self.strike((strike, grip), varied, &across.before[at], last)?;
                let apart = inertia.l().transpose() * (&other.speeds - &change.speeds);
                if apart.norm() > SMALL * largest.max(other.size) {
                    return Err(format!("whether contacts stick or slip in the impact changes with `{}`", varied.name));
                }
            }
        }
        Ok(())
    }

    /// The contacts that are held afterwards without a force.
    fn lying(&self) -> Vec<usize> {
        let Some(forces) = &self.forces else { return Vec::new() };
        forces.kept().map(|(at, _)| at).filter(|at| forces.is_nothing(self.normal(*at))).collect()
    }

    /// The contacts that stick afterwards at the limit of their friction.
    fn at_limit(&self) -> Vec<usize> {
        let Some(forces) = &self.forces else { return Vec::new() };
        let sticks = forces.kept().filter(|(_, mode)| *mode == Mode::Sticks).map(|(at, _)| at);
        sticks.filter(|at| forces.is_at_limit(self.wide.contacts, *at)).collect()
    }

    /// The contacts that begin to slip at the start.
    fn at_rest(&self) -> Vec<usize> {
        let Some(forces) = self.forces.as_ref().filter(|_| self.crossing.happening.is_none()) else {
            return Vec::new();
        };
        let (contacts, y) = (self.wide.contacts, &self.crossing.after.y);
        let rates = contacts.rates(y);
        let is_still = |at: &usize| {
            let row = contacts.rows[*at][1];
            let size: f64 = rates.slopes.row(row).iter().zip(y).map(|(slope, y)| (slope * y).abs()).sum();
            contacts.is_rough(*at) && rates.values[row].abs() <= NOTHING * size
        };
        let slips = forces.kept().filter(|(_, mode)| matches!(mode, Mode::Slips(_))).map(|(at, _)| at);
        slips.filter(is_still).collect()
    }

    /// Refuses contacts that lie without a force, where one would come, that stick at the limit, where they would slip, and that begin to slip, where they would slip the other way.
    fn stays_held(&self, varied: &Varied<'_>, slopes: &[f64]) -> Result<(), String> {
        let Some(forces) = &self.forces else { return Ok(()) };
        let contacts = self.wide.contacts;
        for contact in self.at_rest() {
            let direction = Direction { parameters: varied.parameters, state: slopes };
            let (change, size) = self.wide.velocity(contacts.rows[contact][1], &self.crossing.after.y, direction);
            if change.abs() > SMALL * size {
                let name = self.name(contact);
                return Err(format!("the contact `{name}` begins to slip at rest, and `{}` moves it", varied.name));
            }
        }
        let (lying, at_limit) = (self.lying(), self.at_limit());
        if lying.is_empty() && at_limit.is_empty() {
            return Ok(());
        }
        let change = forces.change(self.wide, self.rates_along, varied, slopes)?.together()?;
        let presses = |at: &&usize| {
            let row = self.normal(**at);
            change.impulses[row].abs() * forces.unit(row) > SMALL * change.size
        };
        if let Some(at) = lying.iter().find(presses) {
            return Err(self.undecided(*at, varied));
        }
        let slips = |at: &&usize| {
            let (margin, size) = forces.margin(contacts, **at, &change, varied);
            margin.abs() > SMALL * size
        };
        at_limit.iter().find(slips).map_or(Ok(()), |at| {
            Err(format!(
                "whether the contact `{}` sticks or slips there changes with `{}`",
                self.name(*at),
                varied.name
            ))
        })
    }
}
