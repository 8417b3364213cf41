//! The contacts of a scene as numbers: gaps, the velocities along them, and what impulses and forces along them do.
//!
//! Everything is told of the permitted motions, q̇ = W u + w: impulses and forces go along the slopes of velocities in u, and change u
//! by the inverse of the kinetic energy's matrix in u. So what ties the mechanism, loops and rolling among it, holds after an impact as before it, whichever
//! variables are integrated.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use tripos_derive::Model;
use tripos_derive::algebra::calculus::{Differential, Substitution};
use tripos_derive::algebra::evaluate::Tape;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::scene::{Impact, ImpactLaw};
use tripos_sim::{Closed, Failure, Mode, Undecided};
use tripos_traits::{Enclosure, Interval, Lengths, System};

/// Roundings of what a gap is made of below which it is closed.
const ROUNDINGS: f64 = 64.0 * f64::EPSILON;

/// Roundings of it that a flight must rise to be told from them.
const TOLD: f64 = 4096.0 * f64::EPSILON;

/// The contacts of a scene in the variables that are integrated.
pub struct Contacts<'a> {
    pub system: &'a dyn System<f64>,
    pub parameters: &'a [f64],
    pub impacts: &'a [Impact],
    /// Each gap in numbers and in ranges.
    pub gaps: Vec<(Tape, Tape<Enclosure>)>,
    /// ∂gap/∂q, a row for each contact.
    slopes: Tape,
    /// The velocities of all rows, then their slopes along q and v, row by row, in parameters and state.
    pub rates: Tape,
    /// The rows of each contact: that of its gap, then those of its slips, one of them where it has friction.
    pub rows: Vec<Vec<usize>>,
    /// How many rows there are.
    pub count: usize,
    /// The slip of each contact with friction, in parameters and state, in numbers and in ranges.
    pub slips: Vec<Option<(Tape, Tape<Enclosure>)>>,
}

/// The rows of all contacts at a state.
pub struct Rates {
    /// The velocities.
    pub values: DVector<f64>,
    /// Their slopes along the state, a row each.
    pub slopes: DMatrix<f64>,
}

/// How speeds, impulses and the kinetic energy go together at a state.
pub struct Operators {
    /// The motion variables that each speed alone gives, a column each.
    pub basis: DMatrix<f64>,
    /// The velocities of all rows by speeds, W.
    pub of_u: DMatrix<f64>,
    /// M, the matrix of the kinetic energy in speeds, factored.
    pub inertia: Cholesky<f64, Dyn>,
}

/// What impulses do at a state.
pub struct Response {
    /// The velocities of all rows.
    pub velocities: DVector<f64>,
    /// The parts of them that are there without speeds.
    pub driven: DVector<f64>,
    /// The change of the motion variables by a unit of impulse along each row, a column each.
    pub changes: DMatrix<f64>,
    /// The change of the velocities of all rows, G.
    pub compliance: DMatrix<f64>,
}

impl<'a> Contacts<'a> {
    /// The contacts of a scene of this model, for equations in the rates of coordinates or in generalized speeds.
    pub fn new(
        model: &Model,
        impacts: &'a [Impact],
        (system, parameters): (&'a dyn System<f64>, &'a [f64]),
        in_rates: bool,
    ) -> Self {
        let mut arena = model.arena.clone();
        let (q, p) = (model.q(), model.p());
        let of_state: Vec<Expr> = [p.as_slice(), &q].concat();
        let value = |arena: &Arena, e: &[Expr], inputs: &[Expr]| {
            Tape::new(arena, inputs, e).expect("a contact is made of what its reader allows")
        };
        let gaps = impacts.iter().map(|impact| value(&arena, &[impact.gap], &of_state));
        let gaps = gaps.map(|tape| (tape.clone(), tape.to())).collect();
        let slopes: Vec<Expr> = impacts.iter().flat_map(|impact| along(&mut arena, impact.gap, &q)).collect();
        let slopes = value(&arena, &slopes, &of_state);
        let (v, pairs): (Vec<Expr>, Vec<(Expr, Expr)>) = if in_rates {
            (model.q_dot(), model.speeds.iter().map(|s| (s.symbol, s.definition)).collect())
        } else {
            (model.u(), model.q_dot().into_iter().zip(model.kinematic_equations.rates.iter().copied()).collect())
        };
        let mut told = Substitution::new(&pairs);
        let (mut velocities, mut rows) = (Vec::new(), Vec::<Vec<usize>>::new());
        for impact in impacts {
            let first = velocities.len();
            let own = std::iter::once(&impact.rate).chain(&impact.slips);
            let own = own.chain(impact.friction.as_ref().map(|friction| &friction.along));
            velocities.extend(own.map(|e| told.apply(&mut arena, *e)));
            rows.push((first..velocities.len()).collect());
        }
        let y = [q.as_slice(), &v].concat();
        let derivatives: Vec<Expr> = velocities.iter().flat_map(|e| along(&mut arena, *e, &y)).collect();
        let inputs = [of_state, v].concat();
        let rates = value(&arena, &[velocities.as_slice(), &derivatives].concat(), &inputs);
        let slip = |(impact, rows): (&Impact, &Vec<usize>)| {
            impact.friction.as_ref()?;
            let tape = value(&arena, &[velocities[rows[1]]], &inputs);
            Some((tape.clone(), tape.to()))
        };
        let slips = impacts.iter().zip(&rows).map(slip).collect();
        Self { system, parameters, impacts, gaps, slopes, rates, rows, count: velocities.len(), slips }
    }

    /// The coefficient of friction of a contact that has one.
    pub fn friction(&self, contact: usize) -> Option<f64> {
        self.impacts[contact].friction.as_ref().map(|friction| friction.coefficient)
    }

    /// Whether friction at a contact has any force: without, it slips either way.
    pub fn is_rough(&self, contact: usize) -> bool {
        self.friction(contact).is_some_and(|mu| mu > 0.0)
    }

    /// What a contact does that is held and does not slip.
    pub fn firm(&self, contact: usize) -> Mode {
        if self.impacts[contact].friction.is_some() { Mode::Sticks } else { Mode::Pushes }
    }

    /// The coefficient of restitution by which Newton's law turns the velocity of a gap: what opens gives nothing back.
    pub fn turns(&self, contact: usize, velocities: &DVector<f64>) -> f64 {
        if velocities[self.rows[contact][0]] < 0.0 { self.impacts[contact].restitution } else { 0.0 }
    }

    /// Parameters and a state.
    fn inputs(&self, y: &[f64]) -> Vec<f64> {
        [self.parameters, y].concat()
    }

    /// The coordinates of a state, and their count.
    fn coordinates(&self) -> usize {
        self.system.lengths().coordinates
    }

    /// The gap of a contact.
    pub fn gap(&self, contact: usize, y: &[f64]) -> f64 {
        self.gaps[contact].0.evaluate(&self.inputs(&y[..self.coordinates()]))[0]
    }

    /// ∂gap/∂q of each contact.
    pub fn gap_slopes(&self, y: &[f64]) -> DMatrix<f64> {
        let n = self.coordinates();
        DMatrix::from_row_slice(self.impacts.len(), n, &self.slopes.evaluate(&self.inputs(&y[..n])))
    }

    /// The rows of all contacts.
    pub fn rates(&self, y: &[f64]) -> Rates {
        let out = self.rates.evaluate(&self.inputs(y));
        let (values, slopes) = out.split_at(self.count);
        Rates {
            values: DVector::from_column_slice(values),
            slopes: DMatrix::from_row_slice(self.count, y.len(), slopes),
        }
    }

    /// What a gap is made of: the size of which rounding is a part. That of coordinates, and that of all that is computed on the way, such as
    /// lengths that cancel.
    pub fn made_of(&self, contact: usize, y: &[f64]) -> f64 {
        let of_coordinates: f64 =
            self.gap_slopes(y).row(contact).iter().zip(y).map(|(slope, q)| (slope * q).abs()).sum();
        let inputs = self.inputs(&y[..self.coordinates()]);
        let points: Vec<Enclosure> = inputs.iter().map(|x| Enclosure::constant(Interval::point(*x))).collect();
        let range = self.gaps[contact].1.evaluate(&points)[0].value;
        // Each operation is rounded outwards, to both sides.
        let on_the_way = (range.hi() - range.lo()) / (2.0 * f64::EPSILON);
        if on_the_way.is_finite() { of_coordinates + on_the_way } else { of_coordinates }
    }

    /// How small a gap must be to be one of rounding, or to close within `instant` s.
    pub fn closing_gap(&self, contact: usize, y: &[f64], rates: &Rates, instant: f64) -> f64 {
        ROUNDINGS * self.made_of(contact, y) + rates.values[self.rows[contact][0]].abs() * instant
    }

    /// The velocity at which a flight under this acceleration takes no longer than `least` s, or rises no higher than can be told from rounding.
    pub fn slow(&self, contact: usize, y: &[f64], acceleration: f64, least: f64) -> f64 {
        let (height, a) = (TOLD * self.made_of(contact, y), acceleration.abs());
        (0.5 * least * a).max((2.0 * a * height).sqrt())
    }

    /// The kinetic energy of a state, J.
    pub fn kinetic_energy(&self, y: &[f64]) -> f64 {
        let (q, v) = y.split_at(self.coordinates());
        self.system.kinetic_energy(self.parameters, q, v)
    }

    /// How speeds and impulses go together.
    ///
    /// # Errors
    /// [`Failure`] where something that moves has no inertia.
    pub fn operators(&self, y: &[f64], rates: &Rates) -> Result<Operators, Failure> {
        let n = self.coordinates();
        let q = &y[..n];
        let Lengths { variables, speeds, .. } = self.system.lengths();
        let rest = self.variables(q, &vec![0.0; speeds]);
        let mut basis = DMatrix::zeros(variables, speeds);
        for (at, mut column) in basis.column_iter_mut().enumerate() {
            let mut axis = vec![0.0; speeds];
            axis[at] = 1.0;
            column.copy_from(&(self.variables(q, &axis) - &rest));
        }
        let of_u = rates.slopes.columns(n, variables) * &basis;
        let factor = self
            .inertia(q, &basis, &rest)
            .cholesky()
            .filter(|factor| factor.l_dirty().diagonal().iter().all(|x| *x > 0.0));
        let inertia = factor.ok_or_else(|| Failure {
            code: "singular",
            message: "something that the constraints let move has no inertia, so that no impulse is known there"
                .to_owned(),
        })?;
        Ok(Operators { basis, of_u, inertia })
    }

    /// What impulses along the rows do.
    ///
    /// # Errors
    /// As [`Contacts::operators`].
    pub fn response(&self, y: &[f64], rates: &Rates) -> Result<Response, Failure> {
        let Operators { basis, of_u, inertia } = self.operators(y, rates)?;
        let (q, v) = y.split_at(self.coordinates());
        let mut u = vec![0.0; self.system.lengths().speeds];
        self.system.generalized_speeds(self.parameters, q, v, &mut u);
        let moved = inertia.solve(&of_u.transpose());
        let driven = &rates.values - &of_u * DVector::from_vec(u);
        Ok(Response { velocities: rates.values.clone(), driven, changes: &basis * &moved, compliance: &of_u * moved })
    }

    /// The motion variables of speeds.
    fn variables(&self, q: &[f64], u: &[f64]) -> DVector<f64> {
        let mut v = vec![0.0; self.system.lengths().variables];
        self.system.motion_variables(self.parameters, q, u, &mut v);
        DVector::from_vec(v)
    }

    /// The matrix of the kinetic energy in u, by its second differences, which are exact but for rounding: T is a quadratic form.
    fn inertia(&self, q: &[f64], basis: &DMatrix<f64>, rest: &DVector<f64>) -> DMatrix<f64> {
        let energy = |shift: DVector<f64>| self.system.kinetic_energy(self.parameters, q, (rest + shift).as_slice());
        let still = energy(DVector::zeros(rest.len()));
        let speeds = basis.ncols();
        let diagonal: Vec<f64> = (0..speeds)
            .map(|i| energy(basis.column(i).into_owned()) + energy(-basis.column(i)) - 2.0 * still)
            .collect();
        // Directions of one energy, so that no speed drowns in the unit of another.
        let unit: Vec<DVector<f64>> = (0..speeds).map(|i| basis.column(i) / diagonal[i].sqrt()).collect();
        DMatrix::from_fn(speeds, speeds, |i, j| {
            if i == j {
                return diagonal[i];
            }
            let (a, b) = (&unit[i.min(j)], &unit[i.max(j)]);
            let mixed = energy(a + b) - energy(a - b) - energy(b - a) + energy(-(a + b));
            mixed / 4.0 * (diagonal[i] * diagonal[j]).sqrt()
        })
    }

    /// These contacts, closed at one instant, and where their rows are among all.
    pub fn closed(&self, response: &Response, contacts: &[usize]) -> (Closed, Vec<usize>) {
        let all: Vec<usize> = contacts.iter().flat_map(|at| self.rows[*at].clone()).collect();
        let mut next = 0..;
        let rows = contacts.iter().map(|at| next.by_ref().take(self.rows[*at].len()).collect()).collect();
        let compliance = response.compliance.select_rows(&all).select_columns(&all);
        let friction = contacts.iter().map(|at| self.friction(*at)).collect();
        (Closed { compliance, rows, friction }, all)
    }

    /// Whether the scene has Poisson's law: else Newton's.
    pub fn is_poisson(&self) -> bool {
        self.impacts.first().is_some_and(|impact| impact.law == ImpactLaw::Poisson)
    }

    /// The impulses of contacts that are closed together, along all rows, by the law of the scene, from the velocities of all rows before.
    ///
    /// # Errors
    /// [`Undecided`] if none part them, or different ones would.
    pub fn impulses(
        &self,
        response: &Response,
        velocities: &DVector<f64>,
        contacts: &[usize],
    ) -> Result<DVector<f64>, Undecided> {
        let (closed, rows) = self.closed(response, contacts);
        let before = velocities.select_rows(&rows);
        let restitution: Vec<f64> = contacts.iter().map(|at| self.impacts[*at].restitution).collect();
        let some = if self.is_poisson() {
            closed.poisson(&before, &restitution)
        } else {
            closed.newton(&before, &restitution)
        };
        Ok(self.spread(&some?, &rows))
    }

    /// Values of some rows among those of all, the others being 0.
    pub fn spread(&self, some: &DVector<f64>, rows: &[usize]) -> DVector<f64> {
        let mut all = DVector::zeros(self.count);
        for (row, value) in rows.iter().zip(some.iter()) {
            all[*row] = *value;
        }
        all
    }
}

/// The slopes of a term along symbols.
fn along(arena: &mut Arena, e: Expr, symbols: &[Expr]) -> Vec<Expr> {
    symbols.iter().map(|symbol| Differential::partial(*symbol).apply(arena, e)).collect()
}
