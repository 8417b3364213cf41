//! Simulation, without Tripos, of rigid bodies in a plane, with pins, and points that meet walls with Coulomb friction.
//!
//! Every body has its place, its angle and their rates. Pins and contacts are rows of one dense linear system of the
//! laws of Newton and Euler. Steps are short and of equal length, by the classical method of Runge; changes inside a
//! step are found by bisection. The modes of contacts are found by trying all combinations, also a little later. Of
//! those that agree with Coulomb's law at the instant, the right one still agrees shortly after.

/// Mode of a contact: open, sticking, or slipping with this sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Does {
    Open,
    Stick,
    Slip(f64),
}

#[derive(Clone, Debug)]
pub struct Body {
    pub mass: f64,
    pub moment: f64,
}

/// A pin: a point of a body, and one of another, or of the ground.
#[derive(Clone, Debug)]
pub struct Pin {
    pub body: usize,
    pub at: [f64; 2],
    pub to: Option<usize>,
    pub there: [f64; 2],
}

/// Contact of a point p of a body with a wall: the gap is normal · p − offset. With the point r of another body it is
/// normal · (p − r) − offset.
#[derive(Clone, Debug)]
pub struct Contact {
    pub body: usize,
    pub at: [f64; 2],
    pub other: Option<(usize, [f64; 2])>,
    pub normal: [f64; 2],
    pub offset: f64,
    /// Coefficient of friction; 0 for none.
    pub mu: f64,
    pub e: f64,
}

#[derive(Clone, Debug)]
pub struct World {
    pub bodies: Vec<Body>,
    pub pins: Vec<Pin>,
    pub contacts: Vec<Contact>,
    pub gravity: f64,
    pub poisson: bool,
}

/// Places and angles of all bodies, then their rates.
pub type State = Vec<f64>;

/// Change of a contact: its instant, s, its contact's index and its new mode.
pub type ContactEvent = (f64, usize, Does);

/// Row of the linear system: slopes by rates of the bodies, and the part of its rate without their accelerations.
struct Row {
    slopes: Vec<f64>,
    bias: f64,
}

/// Impulse data: velocities along normals and along contacts that impulses take away, given impulses along normals, and
/// contacts that push no more than given.
struct Blow<'b> {
    taken: Vec<f64>,
    given: &'b [f64],
    idle: Vec<bool>,
}

/// The length of a step, s.
const STEP: f64 = 1e-3;
/// Size below which a velocity or force counts as zero.
const NOTHING: f64 = 1e-9;
/// Time ahead at which modes must still agree, s.
const AHEAD: f64 = 1e-6;

impl World {
    /// Position of a point of a body.
    pub fn place(y: &[f64], body: usize, at: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = y[3 * body + 2].sin_cos();
        [y[3 * body] + cos * at[0] - sin * at[1], y[3 * body + 1] + sin * at[0] + cos * at[1]]
    }

    /// Row for the velocity of a point of a body along a direction.
    fn along(&self, y: &[f64], body: usize, at: [f64; 2], direction: [f64; 2]) -> Row {
        let count = 3 * self.bodies.len();
        let (sin, cos) = y[3 * body + 2].sin_cos();
        let r = [cos * at[0] - sin * at[1], sin * at[0] + cos * at[1]];
        let mut slopes = vec![0.0; count];
        slopes[3 * body] = direction[0];
        slopes[3 * body + 1] = direction[1];
        slopes[3 * body + 2] = -direction[0] * r[1] + direction[1] * r[0];
        let omega = y[count + 3 * body + 2];
        Row { slopes, bias: -(direction[0] * r[0] + direction[1] * r[1]) * omega * omega }
    }

    fn pins(&self, y: &[f64]) -> Vec<Row> {
        let mut list = Vec::new();
        for pin in &self.pins {
            for direction in [[1.0, 0.0], [0.0, 1.0]] {
                let mut row = self.along(y, pin.body, pin.at, direction);
                if let Some(to) = pin.to {
                    let other = self.along(y, to, pin.there, direction);
                    row.slopes.iter_mut().zip(&other.slopes).for_each(|(a, b)| *a -= b);
                    row.bias -= other.bias;
                }
                list.push(row);
            }
        }
        list
    }

    /// The rows of a contact, along its normal and along its wall.
    fn contact(&self, y: &[f64], at: usize) -> [Row; 2] {
        let c = &self.contacts[at];
        [c.normal, self.tangent(at)].map(|direction| {
            let mut row = self.along(y, c.body, c.at, direction);
            if let Some((other, there)) = c.other {
                let less = self.along(y, other, there, direction);
                row.slopes.iter_mut().zip(&less.slopes).for_each(|(a, b)| *a -= b);
                row.bias -= less.bias;
            }
            row
        })
    }

    fn tangent(&self, at: usize) -> [f64; 2] {
        let [x, y] = self.contacts[at].normal;
        [y, -x]
    }

    pub fn gap(&self, y: &[f64], at: usize) -> f64 {
        let c = &self.contacts[at];
        let p = Self::place(y, c.body, c.at);
        let r = c.other.map_or([0.0; 2], |(other, there)| Self::place(y, other, there));
        c.normal[0] * (p[0] - r[0]) + c.normal[1] * (p[1] - r[1]) - c.offset
    }

    /// The velocities of a contact along its normal and along its wall.
    pub fn velocity(&self, y: &[f64], at: usize) -> [f64; 2] {
        let v = &y[3 * self.bodies.len()..];
        self.contact(y, at).map(|row| row.slopes.iter().zip(v).map(|(a, b)| a * b).sum())
    }

    /// Kinetic and potential energy.
    pub fn energy(&self, y: &[f64]) -> f64 {
        let v = &y[3 * self.bodies.len()..];
        let of = |(at, body): (usize, &Body)| {
            let [x, y_rate, w] = [v[3 * at], v[3 * at + 1], v[3 * at + 2]];
            0.5 * body.mass * (x * x + y_rate * y_rate)
                + 0.5 * body.moment * w * w
                + body.mass * self.gravity * y[3 * at + 1]
        };
        self.bodies.iter().enumerate().map(of).sum()
    }

    /// Accelerations of the bodies and forces of contacts in these modes, as (normal, along) each. In an impact,
    /// changes of velocities and impulses. `None` if they are not determined.
    fn solve(&self, y: &[f64], does: &[Does], impact: Option<&Blow<'_>>) -> Option<(Vec<f64>, Vec<[f64; 2]>)> {
        let count = 3 * self.bodies.len();
        let pins = self.pins(y);
        let (rows, total) = (count + pins.len(), count + pins.len() + 2 * does.len());
        let mut a = vec![vec![0.0; total + 1]; total];
        for (at, body) in self.bodies.iter().enumerate() {
            (a[3 * at][3 * at], a[3 * at + 1][3 * at + 1], a[3 * at + 2][3 * at + 2]) =
                (body.mass, body.mass, body.moment);
            if impact.is_none() {
                a[3 * at + 1][total] = -body.mass * self.gravity;
            }
        }
        for (at, row) in pins.iter().enumerate() {
            exerts(&mut a, row, count + at);
            a[count + at][..count].copy_from_slice(&row.slopes);
            a[count + at][total] = if impact.is_some() { 0.0 } else { -row.bias };
        }
        for (at, what) in does.iter().enumerate() {
            let [normal, along] = self.contact(y, at);
            let (n, t) = (rows + 2 * at, rows + 2 * at + 1);
            exerts(&mut a, &normal, n);
            exerts(&mut a, &along, t);
            let given = impact.map_or(0.0, |blow| blow.given[at]);
            let side = |which: usize| match impact {
                Some(blow) => -blow.taken[2 * at + which],
                None => -[&normal, &along][which].bias,
            };
            let held = |row: &Row, side: f64, to: &mut Vec<f64>| {
                to[..count].copy_from_slice(&row.slopes);
                to[total] = side;
            };
            let is_idle = impact.is_some_and(|blow| blow.idle[at]);
            match what {
                Does::Open => (a[n][n], a[t][t]) = (1.0, 1.0),
                Does::Stick => {
                    held(&normal, side(0), &mut a[n]);
                    held(&along, side(1), &mut a[t]);
                }
                Does::Slip(way) => {
                    held(&normal, side(0), &mut a[n]);
                    (a[t][t], a[t][n]) = (1.0, self.contacts[at].mu * way);
                    a[t][total] = -self.contacts[at].mu * way * given;
                }
            }
            if is_idle {
                a[n] = vec![0.0; total + 1];
                a[n][n] = 1.0;
            }
        }
        let x = eliminated(a)?;
        let forces = (0..does.len()).map(|at| [x[rows + 2 * at], x[rows + 2 * at + 1]]).collect();
        Some((x[..count].to_vec(), forces))
    }

    fn rates(&self, y: &[f64], does: &[Does]) -> Option<Vec<f64>> {
        let count = 3 * self.bodies.len();
        Some([&y[count..], &self.solve(y, does, None)?.0].concat())
    }

    fn stepped(&self, y: &[f64], does: &[Does], h: f64) -> Option<State> {
        let at = |k: &[f64], part: f64| -> State { y.iter().zip(k).map(|(y, k)| y + part * h * k).collect() };
        let a = self.rates(y, does)?;
        let b = self.rates(&at(&a, 0.5), does)?;
        let c = self.rates(&at(&b, 0.5), does)?;
        let d = self.rates(&at(&c, 1.0), does)?;
        Some((0..y.len()).map(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i])).collect())
    }

    /// Margins of each contact's mode; below 0 the mode is impossible. `None` if forces are not determined.
    fn margins(&self, y: &[f64], does: &[Does]) -> Option<Vec<f64>> {
        let (_, forces) = self.solve(y, does, None)?;
        let margin = |at: usize| match does[at] {
            Does::Open => self.gap(y, at),
            Does::Stick => forces[at][0].min(self.contacts[at].mu * forces[at][0] - forces[at][1].abs()),
            Does::Slip(way) if self.contacts[at].mu > 0.0 => forces[at][0].min(way * self.velocity(y, at)[1]),
            Does::Slip(_) => forces[at][0],
        };
        Some((0..does.len()).map(margin).collect())
    }

    /// All combinations in which each contact has one of its own choices.
    fn all<T: Copy>(choices: &[Vec<T>]) -> Vec<Vec<T>> {
        let mut list: Vec<Vec<T>> = vec![Vec::new()];
        for own in choices {
            list = list.iter().flat_map(|so_far| own.iter().map(|one| [so_far.as_slice(), &[*one]].concat())).collect();
        }
        list
    }

    /// Modes of contacts from a state on. These contacts are closed and at rest along their normals. Several modes that
    /// move differently, or none, are an error.
    pub fn decide(&self, y: &[f64], closed: &[bool]) -> Result<Vec<Does>, String> {
        let choices = |at: usize| -> Vec<Does> {
            let slip = self.velocity(y, at)[1];
            match closed[at] {
                false => vec![Does::Open],
                true if self.contacts[at].mu == 0.0 => vec![Does::Slip(1.0), Does::Open],
                true if slip.abs() > NOTHING => vec![Does::Slip(slip.signum()), Does::Open],
                true => vec![Does::Stick, Does::Slip(1.0), Does::Slip(-1.0), Does::Open],
            }
        };
        let choices: Vec<Vec<Does>> = (0..closed.len()).map(choices).collect();
        let mut found: Vec<(Vec<Does>, State)> = Vec::new();
        for does in Self::all(&choices) {
            let Some(later) = self.stepped(y, &does, AHEAD) else { continue };
            let Some(margins) = self.margins(&later, &does) else { continue };
            // A gap is of the second order in the time ahead, a slip of the first.
            let least = |at: usize| match does[at] {
                Does::Open => -1e-13,
                _ => -1e-11,
            };
            if margins.iter().enumerate().all(|(at, margin)| *margin >= least(at)) {
                found.push((does, later));
            }
        }
        let Some((first, later)) = found.first() else { return Err("no modes".to_owned()) };
        let apart = |(_, other): &&(Vec<Does>, State)| other.iter().zip(later).any(|(a, b)| (a - b).abs() > 1e-9);
        if let Some((other, _)) = found.iter().find(apart) {
            return Err(format!("several: {first:?} and {other:?}"));
        }
        Ok(first.clone())
    }

    /// State after impacts of closed contacts. Several, or none, are an error.
    pub fn hit(&self, y: &[f64], closed: &[bool]) -> Result<State, String> {
        let before: Vec<[f64; 2]> = (0..closed.len()).map(|at| self.velocity(y, at)).collect();
        let nothing = vec![0.0; closed.len()];
        if self.poisson {
            let (pressed, impulses) = self.pushed(y, closed, &nothing, &nothing)?;
            let back: Vec<f64> = (0..closed.len()).map(|at| self.contacts[at].e * impulses[at][0]).collect();
            return Ok(self.pushed(&pressed, closed, &nothing, &back)?.0);
        }
        // By Newton's law an opening contact takes no part, until an impact closes it.
        let (mut after, mut before) = (y.to_vec(), before);
        for _ in 0..50 {
            let hit: Vec<bool> = (0..closed.len()).map(|at| closed[at] && before[at][0] <= NOTHING).collect();
            if (0..closed.len()).all(|at| !closed[at] || before[at][0] >= -NOTHING) {
                return Ok(after);
            }
            let wanted: Vec<f64> =
                (0..closed.len()).map(|at| (-self.contacts[at].e * before[at][0]).max(0.0)).collect();
            after = self.pushed(&after, &hit, &wanted, &nothing)?.0;
            before = (0..closed.len()).map(|at| self.velocity(&after, at)).collect();
        }
        Err("impacts without end".to_owned())
    }

    /// State after impulses that leave normal velocities of at least `wanted`, with these given impulses along normals.
    /// Also returns all impulses along contacts.
    fn pushed(
        &self,
        y: &[f64],
        closed: &[bool],
        wanted: &[f64],
        given: &[f64],
    ) -> Result<(State, Vec<[f64; 2]>), String> {
        let count = 3 * self.bodies.len();
        let choice = |at: usize| -> Vec<(Does, bool)> {
            let grips = match (closed[at], self.contacts[at].mu > 0.0) {
                (false, _) => Vec::new(),
                (true, false) => vec![Does::Slip(1.0)],
                (true, true) => vec![Does::Stick, Does::Slip(1.0), Does::Slip(-1.0)],
            };
            let idle = grips.iter().filter(|_| given[at] > 0.0).map(|does| (*does, true));
            let pushing = grips.iter().map(|does| (*does, false));
            idle.chain(pushing).chain((given[at] == 0.0).then_some((Does::Open, true))).collect()
        };
        let choices: Vec<Vec<(Does, bool)>> = (0..closed.len()).map(choice).collect();
        let mut found: Vec<(State, Vec<[f64; 2]>)> = Vec::new();
        for chosen in Self::all(&choices) {
            found.extend(self.blow(y, &chosen, closed, wanted, given));
        }
        let Some(first) = found.first().cloned() else { return Err("no impulses".to_owned()) };
        let apart = |(other, _): &&(State, Vec<[f64; 2]>)| {
            other[count..].iter().zip(&first.0[count..]).any(|(a, b)| (a - b).abs() > 1e-7)
        };
        if found.iter().any(|one| apart(&one)) { Err("several impulses".to_owned()) } else { Ok(first) }
    }

    /// State and impulses of one combination; `None` if it contradicts the laws.
    fn blow(
        &self,
        y: &[f64],
        chosen: &[(Does, bool)],
        closed: &[bool],
        wanted: &[f64],
        given: &[f64],
    ) -> Option<(State, Vec<[f64; 2]>)> {
        let count = 3 * self.bodies.len();
        let (does, idle): (Vec<Does>, Vec<bool>) = chosen.iter().copied().unzip();
        let with = self.with_given(y, given)?;
        let before: Vec<[f64; 2]> = (0..does.len()).map(|at| self.velocity(&with, at)).collect();
        let taken = (0..does.len()).flat_map(|at| [before[at][0] - wanted[at], before[at][1]]).collect();
        let (jumps, impulses) = self.solve(y, &does, Some(&Blow { taken, given, idle }))?;
        let mut after = with;
        after[count..].iter_mut().zip(&jumps).for_each(|(v, jump)| *v += jump);
        let agrees = |at: usize| {
            let ([normal, slip], [push, along]) = (self.velocity(&after, at), impulses[at]);
            let limit = self.contacts[at].mu * (push + given[at]);
            let is_right = match does[at] {
                Does::Open => true,
                Does::Stick => along.abs() <= limit + NOTHING,
                Does::Slip(way) => self.contacts[at].mu == 0.0 || way * slip >= -NOTHING,
            };
            !closed[at] || is_right && push >= -NOTHING && normal >= wanted[at] - NOTHING
        };
        (0..does.len()).all(agrees).then_some((after, impulses))
    }

    /// The state after given impulses along normals.
    fn with_given(&self, y: &[f64], given: &[f64]) -> Option<State> {
        if given.iter().all(|x| *x == 0.0) {
            return Some(y.to_vec());
        }
        let count = 3 * self.bodies.len();
        let pins = self.pins(y);
        let total = count + pins.len();
        let mut a = vec![vec![0.0; total + 1]; total];
        for (at, body) in self.bodies.iter().enumerate() {
            (a[3 * at][3 * at], a[3 * at + 1][3 * at + 1], a[3 * at + 2][3 * at + 2]) =
                (body.mass, body.mass, body.moment);
        }
        for (at, row) in pins.iter().enumerate() {
            exerts(&mut a, row, count + at);
            a[count + at][..count].copy_from_slice(&row.slopes);
        }
        for (at, push) in given.iter().enumerate() {
            let [normal, _] = self.contact(y, at);
            (0..count).for_each(|k| a[k][total] += normal.slopes[k] * push);
        }
        let jumps = eliminated(a)?;
        let mut after = y.to_vec();
        after[count..].iter_mut().zip(&jumps).for_each(|(v, jump)| *v += jump);
        Some(after)
    }

    /// Runs from a state over a time. Returns the final state and the changes of contacts.
    pub fn run(&self, y: &[f64], span: f64) -> Result<(State, Vec<ContactEvent>), String> {
        let (mut t, mut y, mut list) = (0.0, y.to_vec(), Vec::new());
        let count = self.contacts.len();
        let mut does = vec![Does::Open; count];
        let mut last = -1.0;
        while t < span {
            let h = STEP.min(span - t);
            let next = self.stepped(&y, &does, h).ok_or("no motion")?;
            let is_fine = |y: &[f64]| -> Result<bool, String> {
                let margins = self.margins(y, &does).ok_or("no forces")?;
                // An opening or newly slipping contact has margin zero there, and so does a gap that has just opened.
                Ok(margins.iter().all(|margin| *margin >= -1e-12))
            };
            if is_fine(&next)? {
                (t, y) = (t + h, next);
                continue;
            }
            let (mut low, mut high) = (0.0, h);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                let there = self.stepped(&y, &does, middle).ok_or("no motion")?;
                if is_fine(&there)? { low = middle } else { high = middle }
            }
            let there = self.stepped(&y, &does, high).ok_or("no motion")?;
            (t, y) = (t + high, there);
            if t - last < 1e-7 {
                return Err(format!("too much happens at {t}"));
            }
            last = t;
            let (after, now) = self.changed(&y, &does)?;
            for contact in (0..count).filter(|at| now[*at] != does[*at]) {
                list.push((t, contact, now[contact]));
            }
            (y, does) = (after, now);
        }
        Ok((y, list))
    }

    /// State after a change and the modes of the contacts from there on.
    fn changed(&self, y: &[f64], does: &[Does]) -> Result<(State, Vec<Does>), String> {
        let is_closed = |at: usize| does[at] != Does::Open || self.gap(y, at) <= 1e-10;
        let closed: Vec<bool> = (0..does.len()).map(is_closed).collect();
        let closes = |at: usize| closed[at] && does[at] == Does::Open && self.velocity(y, at)[0] < -NOTHING;
        let mut after = y.to_vec();
        if (0..does.len()).any(closes) {
            after = self.hit(y, &closed)?;
        }
        let rests: Vec<bool> =
            (0..does.len()).map(|at| closed[at] && self.velocity(&after, at)[0].abs() <= NOTHING).collect();
        let now = self.decide(&after, &rests)?;
        Ok((after, now))
    }
}

/// Enters the effect on the bodies of a force along a row into its column of a system.
fn exerts(a: &mut [Vec<f64>], row: &Row, column: usize) {
    a.iter_mut().zip(&row.slopes).for_each(|(to, slope)| to[column] = -slope);
}

/// Solves a system with its right side as last column, by elimination with pivots from whole columns and rows. `None`
/// if it is singular.
fn eliminated(mut a: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let n = a.len();
    let mut columns: Vec<usize> = (0..n).collect();
    let size = a.iter().flat_map(|row| &row[..n]).fold(0.0_f64, |m, x| m.max(x.abs()));
    for k in 0..n {
        let (mut i, mut j, mut most) = (k, k, 0.0);
        for (r, row) in a.iter().enumerate().skip(k) {
            for (c, x) in row.iter().enumerate().take(n).skip(k) {
                if x.abs() > most {
                    (i, j, most) = (r, c, x.abs());
                }
            }
        }
        if most <= 1e-11 * size {
            return None;
        }
        a.swap(k, i);
        for row in &mut a {
            row.swap(k, j);
        }
        columns.swap(k, j);
        let pivot = a[k].clone();
        for row in a.iter_mut().skip(k + 1) {
            let factor = row[k] / pivot[k];
            row.iter_mut().zip(&pivot).skip(k).for_each(|(x, p)| *x -= factor * p);
        }
    }
    let mut x = vec![0.0; n];
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|c| a[k][c] * x[c]).sum();
        x[k] = (a[k][n] - known) / a[k][k];
    }
    let mut out = vec![0.0; n];
    columns.iter().zip(&x).for_each(|(column, x)| out[*column] = *x);
    Some(out)
}
