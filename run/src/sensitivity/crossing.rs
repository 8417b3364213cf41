//! How slopes jump where velocities do, and where contacts are let go or held.
//!
//! At an instant t(p) a motion y⁻(t, p) is taken to y⁺ = R(y⁻, p), from rates f⁻ to f⁺. Slopes at a fixed instant go from s⁻ to
//! s⁺ = R_y (s⁻ + f⁻ dt/dp) + R_p − f⁺ dt/dp, with dt/dp = −(g_y s⁻ + g_p)/(g_y f⁻) of what is zero there, a gap or a force. M. A. Aizerman & F. R. Gantmakher, "On the stability
//! of periodic motions", *Journal of Applied Mathematics and Mechanics* 22 (1958), 1065–1078; P. C. Müller, "Calculation of Lyapunov exponents for dynamic systems with
//! discontinuities", *Chaos, Solitons & Fractals* 5 (1995), 1671–1681.
//!
//! R is differentiated with the set of contacts that push as it is. Where it changes with what is varied, where contacts that close together do not stay together, or close without a velocity, there is no
//! derivative, and it is said why.

use super::contacts::{Acting, Direction, SMALL, Wide, Without};
use super::strike::{Law, Strike, along_rows, strikes};
use crate::impacts::{Crossing, Happening, Kept};
use nalgebra::DVector;
use tripos_sim::Failure;

/// The part of its terms that the velocity of a gap must be for it to close.
const CLOSING: f64 = 1e-9;

/// The derivative of the rates of the equations without contacts, along a direction at a state.
pub type RatesAlong<'c> = dyn Fn(&[f64], Direction<'_>) -> Vec<f64> + 'c;

/// The rates at an instant and a state while contacts are held.
pub type Flow<'c> = dyn Fn(&[usize], f64, &[f64]) -> Result<Vec<f64>, Failure> + 'c;

/// A crossing, and what all directions need of it.
pub struct Crossed<'c> {
    wide: &'c Wide<'c>,
    crossing: &'c Crossing<'c>,
    rates_along: &'c RatesAlong<'c>,
    /// The rates before and after: with the forces of contacts that are held.
    before: Vec<f64>,
    after: Vec<f64>,
    /// Those without any forces of contacts, before and after.
    free: [Vec<f64>; 2],
    strikes: Vec<Strike>,
}

/// How an instant moves, and the size of what that is made of.
#[derive(Clone, Copy)]
struct Moves {
    by: f64,
    size: f64,
}

/// What is varied, and what parameters and restitutions do as it changes.
pub struct Varied<'v> {
    pub name: &'v str,
    pub parameters: &'v [f64],
    pub restitutions: &'v [f64],
}

impl<'c> Crossed<'c> {
    /// A crossing in a motion of which `flow` gives the rates while contacts are held.
    ///
    /// # Errors
    /// [`Failure`] where something has no value.
    pub fn new(
        wide: &'c Wide<'c>,
        crossing: &'c Crossing<'c>,
        rates_along: &'c RatesAlong<'c>,
        flow: &Flow<'_>,
    ) -> Result<Self, Failure> {
        let (t, y) = (crossing.t, &crossing.after.y);
        Ok(Self {
            wide,
            crossing,
            rates_along,
            before: flow(crossing.held, t, crossing.before)?,
            after: flow(&crossing.after.kept.which, t, y)?,
            free: [flow(&[], t, crossing.before)?, flow(&[], t, y)?],
            strikes: strikes(wide.contacts, crossing)?,
        })
    }

    /// How the instant moves, and the slopes after it, from those before.
    ///
    /// # Errors
    /// Why there are none.
    pub fn across(&self, varied: &Varied<'_>, state: &[f64]) -> Result<(f64, Vec<f64>), String> {
        let direction = Direction { parameters: varied.parameters, state };
        let later = self.later(varied, direction)?;
        let mut slopes: Vec<f64> = state.iter().zip(&self.before).map(|(s, f)| s + f * later).collect();
        let mut impulses = DVector::zeros(self.wide.contacts.count);
        for strike in &self.strikes {
            impulses = self.strike(strike, varied, &mut slopes, &impulses)?;
        }
        slopes.iter_mut().zip(&self.after).for_each(|(s, f)| *s -= f * later);
        self.stays(varied, &slopes)?;
        Ok((later, slopes))
    }

    fn name(&self, contact: usize) -> &str {
        &self.wide.contacts.impacts[contact].name
    }

    fn normal(&self, contact: usize) -> usize {
        self.wide.contacts.rows[contact][0]
    }

    /// Changes slopes as impulses do, and returns the derivatives of these.
    fn strike(
        &self,
        strike: &Strike,
        varied: &Varied<'_>,
        slopes: &mut [f64],
        before: &DVector<f64>,
    ) -> Result<DVector<f64>, String> {
        let Strike { y, operators, law, impulses, rows, undecided } = strike;
        let acting = Acting { y, operators, impulses, rows };
        let contacts = self.wide.contacts;
        let velocities = contacts.rates(y).values;
        let e = along_rows(contacts, |at| contacts.impacts[at].restitution);
        let turns = along_rows(contacts, |at| contacts.turns(at, &velocities));
        let by_e = along_rows(contacts, |at| varied.restitutions[at]);
        // What opens gives nothing back, whatever its coefficient.
        let by_turns =
            along_rows(contacts, |at| if velocities[self.normal(at)] < 0.0 { varied.restitutions[at] } else { 0.0 });
        let nothing = DVector::zeros(contacts.count);
        let (parts, by, given) = match law {
            Law::Turn => (turns.add_scalar(1.0), by_turns, nothing),
            Law::Stop => (nothing.add_scalar(1.0), nothing.clone(), nothing),
            // e Λ of the strike before.
            Law::Return(of) => (nothing.clone(), nothing, e.component_mul(before) + by_e.component_mul(of)),
        };
        let direction = Direction { parameters: varied.parameters, state: slopes };
        let without = Without::Move { parts: parts.as_slice(), by: by.as_slice() };
        let change = self.wide.change(&acting, &without, direction, &given);
        let change = change.map_err(|failure| failure.message)?;
        for contact in undecided {
            let row = self.normal(*contact);
            let g = (operators.of_u.row(row) * operators.inertia.solve(&operators.of_u.row(row).transpose()))[0];
            if change.impulses[row].abs() * g.sqrt() > SMALL * change.size {
                return Err(self.undecided(*contact, varied));
            }
        }
        let first = slopes.len() - change.variables.len();
        slopes[first..].iter_mut().zip(change.variables.iter()).for_each(|(s, more)| *s += more);
        Ok(change.impulses)
    }

    fn undecided(&self, contact: usize, varied: &Varied<'_>) -> String {
        format!("whether the contact `{}` pushes or opens there changes with `{}`", self.name(contact), varied.name)
    }

    /// How the instant moves.
    fn later(&self, varied: &Varied<'_>, direction: Direction<'_>) -> Result<f64, String> {
        let Crossing { happening, held, after, .. } = self.crossing;
        let is_new = |at: &&usize| !held.contains(*at);
        match *happening {
            None => {
                let hit = if after.is_hit { &after.closed[..] } else { &[] };
                let struck = self.strikes.first().map_or(&[][..], |strike| &strike.rows);
                let hit = hit.iter().filter(|at| struck.contains(&self.normal(**at)));
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
                Ok(0.0)
            }
            Some(Happening::Closes(contact)) => {
                let first = self.closes(contact, direction)?.ok_or_else(|| self.grazes(contact))?;
                for other in after.closed.iter().filter(is_new).filter(|other| **other != contact) {
                    let Some(moves) = self.closes(*other, direction)? else { continue };
                    self.together((contact, first), (*other, moves), varied)?;
                }
                Ok(first.by)
            }
            Some(Happening::Slips(_) | Happening::Sticks(_) | Happening::Reverses(_) | Happening::Jams(_)) => {
                Err("friction has no derivatives here".to_owned())
            }
            Some(Happening::Opens(contact)) => {
                let first = self.opens(contact, direction)?;
                for other in held.iter().filter(|at| **at != contact && after.kept.mode(**at).is_none()) {
                    self.together((contact, first), (*other, self.opens(*other, direction)?), varied)?;
                }
                Ok(first.by)
            }
        }
    }

    fn grazes(&self, contact: usize) -> String {
        format!("the contact `{}` is touched there without a velocity that closes it", self.name(contact))
    }

    /// Refuses what is at one instant and does not stay together.
    fn together(
        &self,
        (one, a): (usize, Moves),
        (other, b): (usize, Moves),
        varied: &Varied<'_>,
    ) -> Result<(), String> {
        if (a.by - b.by).abs() <= SMALL * a.size.max(b.size) {
            return Ok(());
        }
        let what = match self.crossing.happening {
            Some(Happening::Opens(_)) => "open",
            _ => "close",
        };
        Err(format!(
            "the contacts `{}` and `{}` {what} at one instant, which `{}` moves apart",
            self.name(one),
            self.name(other),
            varied.name
        ))
    }

    /// How the instant at which a gap closes moves; nothing if it opens.
    fn closes(&self, contact: usize, direction: Direction<'_>) -> Result<Option<Moves>, String> {
        let slopes = self.wide.contacts.gap_slopes(self.crossing.before);
        let parts =
            slopes.row(contact).iter().zip(&self.before).map(|(slope, rate)| slope * rate).collect::<Vec<f64>>();
        let (velocity, scale) = (parts.iter().sum::<f64>(), parts.iter().map(|part| part.abs()).sum::<f64>());
        if velocity > CLOSING * scale {
            return Ok(None);
        }
        if velocity >= -CLOSING * scale {
            return Err(self.grazes(contact));
        }
        let (change, size) = self.wide.gap(contact, self.crossing.before, direction);
        Ok(Some(Moves { by: -change / velocity, size: size / velocity.abs() }))
    }

    /// How the instant at which the force of a contact crosses zero moves.
    fn opens(&self, contact: usize, direction: Direction<'_>) -> Result<Moves, String> {
        let (y, row) = (self.crossing.before, self.normal(contact));
        let nothing = vec![0.0; direction.parameters.len()];
        let flow = Direction { parameters: &nothing, state: &self.before };
        let forces = Forces::new(self, (self.crossing.held, y), &self.free[0]).map_err(|failure| failure.message)?;
        if forces.is_shared() {
            return Err(format!(
                "more contacts than `{}` hold the same motion there, and share what pushes",
                self.name(contact)
            ));
        }
        let (along, after) = (forces.change(self, direction)?, forces.change(self, flow)?);
        let (change, rate) = (along.impulses[row], after.impulses[row]);
        let unit = forces.compliance(row).sqrt();
        if rate.abs() * unit <= SMALL * after.size {
            return Err(format!("the force of the contact `{}` does not cross zero there", self.name(contact)));
        }
        Ok(Moves { by: -change / rate, size: along.size / (rate.abs() * unit) })
    }

    /// Refuses contacts that lie without a force, where one would come.
    fn stays(&self, varied: &Varied<'_>, slopes: &[f64]) -> Result<(), String> {
        let held = &self.crossing.after.kept.which;
        if held.is_empty() {
            return Ok(());
        }
        let forces =
            Forces::new(self, (held, &self.crossing.after.y), &self.free[1]).map_err(|failure| failure.message)?;
        let lying: Vec<usize> = held.iter().copied().filter(|at| forces.is_nothing(self.normal(*at))).collect();
        if lying.is_empty() {
            return Ok(());
        }
        let change = forces.change(self, Direction { parameters: varied.parameters, state: slopes })?;
        let presses = |at: &&usize| {
            let row = self.normal(**at);
            change.impulses[row].abs() * forces.compliance(row).sqrt() > SMALL * change.size
        };
        lying.iter().find(presses).map_or(Ok(()), |at| Err(self.undecided(*at, varied)))
    }
}

/// The forces of contacts that are held at a state.
struct Forces<'f> {
    y: &'f [f64],
    free: &'f [f64],
    operators: crate::impacts::Operators,
    along_rows: DVector<f64>,
    accelerations: DVector<f64>,
    rows: Vec<usize>,
}

impl<'f> Forces<'f> {
    fn new(of: &Crossed<'_>, (held, y): (&[usize], &'f [f64]), free: &'f [f64]) -> Result<Self, Failure> {
        let contacts = of.wide.contacts;
        let rates = contacts.rates(y);
        let (operators, response) = (contacts.operators(y, &rates)?, contacts.response(y, &rates)?);
        let accelerations = &rates.slopes * DVector::from_column_slice(free);
        let (closed, rows) = contacts.closed(&response, held);
        let some = closed.hold(&accelerations.select_rows(&rows), &Kept::firm(contacts, held).modes);
        let message = "the forces of contacts that are held are not finite".to_owned();
        let some = some.ok_or(Failure { code: "not-finite", message })?;
        let forces = contacts.spread(&some, &rows);
        Ok(Self { y, free, operators, along_rows: forces, accelerations, rows })
    }

    /// G of a row.
    fn compliance(&self, row: usize) -> f64 {
        let of_u = self.operators.of_u.row(row);
        (of_u * self.operators.inertia.solve(&of_u.transpose()))[0]
    }

    /// Whether no force is along a row, but for rounding.
    fn is_nothing(&self, row: usize) -> bool {
        let size = |row: &usize| self.accelerations[*row].abs() / self.compliance(*row).sqrt();
        let largest = self.rows.iter().map(size).fold(0.0, f64::max);
        self.along_rows[row] * self.compliance(row).sqrt() <= CLOSING * largest
    }

    /// Whether rows that are held depend on one another.
    fn is_shared(&self) -> bool {
        let of_u = self.operators.of_u.select_rows(&self.rows);
        let mut compliance = &of_u * self.operators.inertia.solve(&of_u.transpose());
        let unit: Vec<f64> = compliance.diagonal().iter().map(|g| 1.0 / g.sqrt()).collect();
        for ((i, j), g) in (0..unit.len()).flat_map(|j| (0..unit.len()).map(move |i| (i, j))).zip(compliance.iter_mut())
        {
            *g *= unit[i] * unit[j];
        }
        let values = compliance.singular_values();
        values.min() <= CLOSING * values.max()
    }

    /// How they change.
    fn change(&self, of: &Crossed<'_>, direction: Direction<'_>) -> Result<super::contacts::Change, String> {
        let by = (of.rates_along)(self.y, direction);
        let acting = Acting { y: self.y, operators: &self.operators, impulses: &self.along_rows, rows: &self.rows };
        let without = Without::Accelerate { rates: self.free, by: &by };
        let nothing = DVector::zeros(self.along_rows.len());
        of.wide.change(&acting, &without, direction, &nothing).map_err(|failure| failure.message)
    }
}
