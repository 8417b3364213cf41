//! The contacts of a scene in numbers: gaps, gap velocities, slip velocities, and the changes of these
//! velocities by impulses and forces.
//!
//! Each contact has one gap velocity, and may have slip velocities. Every such velocity is a row of
//! the vectors and matrices here. All quantities refer to the permitted motions `q̇ = W u + w`. An
//! impulse acts along the derivatives of a row velocity by u. It changes u by the inverse of the
//! matrix of the kinetic energy in u. So the constraints of the mechanism, such as loops and rolling,
//! also hold after an impact, in any variables.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use tripos_derive::Model;
use tripos_derive::algebra::term::calculus::{Differential, Substitution};
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::MotionVariables;
use tripos_derive::scene::{ImpactContact, ImpactLaw};
use tripos_sim::{ClosedContacts, ContactMode, Failure, UndecidedContacts};
use tripos_traits::{Enclosure, Interval, Lengths, System};

/// Largest gap at which a contact counts as closed, relative to the size of the gap's terms.
const ROUNDINGS: f64 = 64.0 * f64::EPSILON;

/// Least height of a flight between two impacts that exceeds rounding, relative to the size of the
/// gap's terms.
const TOLD: f64 = 4096.0 * f64::EPSILON;

/// Contacts of a scene in the variables that are integrated. Each contact has a row for the
/// velocity of its gap, and a row for each slip velocity along it.
pub struct SceneContacts<'a> {
    /// Equations of motion of the mechanism without contact forces.
    pub system: &'a dyn System<f64>,
    /// Values of the parameters, in the order of the model file.
    pub parameters: &'a [f64],
    /// Contacts as the scene file describes them.
    pub impacts: &'a [ImpactContact],
    /// Tapes of the gap of each contact, in doubles and in enclosures. Inputs: parameters, then
    /// coordinates.
    pub gaps: Vec<(Tape, Tape<Enclosure>)>,
    /// Tape of ∂gap/∂q, a row of n values for each contact. Inputs: parameters, then coordinates.
    slopes: Tape,
    /// Tape of the gap and slip velocities of all contacts, followed by their slopes along the state
    /// (q, v), row by row. Inputs: parameters, then state.
    pub rates: Tape,
    /// Indices of the rows of each contact. The row of the gap velocity is followed by the rows of the
    /// slip velocities. A contact with friction has one slip velocity.
    pub rows: Vec<Vec<usize>>,
    /// Number of rows: gap velocities and slip velocities of all contacts together.
    pub count: usize,
    /// Tapes of the slip velocity of each contact, in doubles and in enclosures; `None` without
    /// friction. Inputs: parameters, then state.
    pub slips: Vec<Option<(Tape, Tape<Enclosure>)>>,
}

/// Gap and slip velocities of all contacts at a state, with their slopes.
pub struct ContactRates {
    /// Gap and slip velocities of all contacts: for each contact its gap velocity, followed by its slip
    /// velocities.
    pub values: DVector<f64>,
    /// Partial derivatives of the velocities by the state (q, v): a matrix row for each velocity.
    pub slopes: DMatrix<f64>,
}

/// Matrices at a state that relate generalized speeds, impulses of contacts and the kinetic energy.
pub struct ContactOperators {
    /// Change of the motion variables v per unit of each generalized speed: a column for each speed.
    pub basis: DMatrix<f64>,
    /// Matrix W, the gap and slip velocities per unit of each generalized speed: a row for each velocity
    /// and a column for each speed.
    pub of_u: DMatrix<f64>,
    /// Cholesky factor of M, the matrix of the kinetic energy in the generalized speeds.
    pub inertia: Cholesky<f64, Dyn>,
}

/// Gap and slip velocities of all contacts at a state, and their changes by impulses along the
/// contacts.
pub struct ImpulseResponse {
    /// Gap and slip velocities of all contacts before the impulses.
    pub velocities: DVector<f64>,
    /// Parts of the gap and slip velocities that remain if all generalized speeds are zero. Moving
    /// obstacles cause them.
    pub driven: DVector<f64>,
    /// Change of the motion variables v per unit of impulse along each gap or slip direction: a column
    /// for each direction.
    pub changes: DMatrix<f64>,
    /// Matrix G, the change of each gap and slip velocity (row) per unit of impulse along each gap or
    /// slip direction (column). It is square.
    pub compliance: DMatrix<f64>,
}

impl<'a> SceneContacts<'a> {
    /// Prepares the contacts of a scene for equations of motion in the given motion variables:
    /// generalized speeds or rates q̇.
    pub fn new(
        model: &Model,
        impacts: &'a [ImpactContact],
        system: &'a dyn System<f64>,
        parameters: &'a [f64],
        variables: MotionVariables,
    ) -> Self {
        let mut arena = model.arena.clone();
        let (q, p) = (model.q(), model.p());
        let of_state: Vec<Expr> = [p.as_slice(), &q].concat();
        let value = |arena: &Arena, e: &[Expr], inputs: &[Expr]| {
            Tape::new(arena, inputs, e).expect("a contact is made of what its reader allows")
        };
        let gaps = impacts.iter().map(|impact| value(&arena, &[impact.gap], &of_state));
        let gaps = gaps.map(|tape| (tape.clone(), tape.to())).collect();
        let slopes: Vec<Expr> =
            impacts.iter().flat_map(|impact| contact_partial_derivatives(&mut arena, impact.gap, &q)).collect();
        let slopes = value(&arena, &slopes, &of_state);
        let (v, pairs): (Vec<Expr>, Vec<(Expr, Expr)>) = match variables {
            MotionVariables::Rates => (model.q_dot(), model.speeds.iter().map(|s| (s.symbol, s.definition)).collect()),
            MotionVariables::Speeds => {
                (model.u(), model.q_dot().into_iter().zip(model.kinematic_equations.rates.iter().copied()).collect())
            }
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
        let derivatives: Vec<Expr> =
            velocities.iter().flat_map(|e| contact_partial_derivatives(&mut arena, *e, &y)).collect();
        let inputs = [of_state, v].concat();
        let rates = value(&arena, &[velocities.as_slice(), &derivatives].concat(), &inputs);
        let slip = |(impact, rows): (&ImpactContact, &Vec<usize>)| {
            impact.friction.as_ref()?;
            let tape = value(&arena, &[velocities[rows[1]]], &inputs);
            Some((tape.clone(), tape.to()))
        };
        let slips = impacts.iter().zip(&rows).map(slip).collect();
        Self { system, parameters, impacts, gaps, slopes, rates, rows, count: velocities.len(), slips }
    }

    /// Coefficient of friction of a contact, without unit; `None` if the contact has no friction law.
    pub fn friction(&self, contact: usize) -> Option<f64> {
        self.impacts[contact].friction.as_ref().map(|friction| friction.coefficient)
    }

    /// True if the coefficient of friction of a contact is above zero. With a coefficient of zero, the
    /// direction of slip does not matter.
    pub fn is_rough(&self, contact: usize) -> bool {
        self.friction(contact).is_some_and(|mu| mu > 0.0)
    }

    /// Mode of a contact that is held closed and does not slip: sticking with a friction law, pushing
    /// without it.
    pub fn mode_without_slip(&self, contact: usize) -> ContactMode {
        if self.impacts[contact].friction.is_some() { ContactMode::Sticks } else { ContactMode::Pushes }
    }

    /// Coefficient of restitution that Newton's law of impact uses for a contact. It is zero if the gap
    /// does not close at the given gap and slip `velocities`.
    pub fn newton_restitution(&self, contact: usize, velocities: &DVector<f64>) -> f64 {
        if velocities[self.rows[contact][0]] < 0.0 { self.impacts[contact].restitution } else { 0.0 }
    }

    /// Joins the parameters and a state `y` into the inputs of a tape.
    fn inputs(&self, y: &[f64]) -> Vec<f64> {
        [self.parameters, y].concat()
    }

    /// Number of generalized coordinates in a state (q, v).
    fn coordinates(&self) -> usize {
        self.system.lengths().coordinates
    }

    /// Gap of a contact at a state, in the unit of the scene's formula; negative if the bodies overlap.
    pub fn gap(&self, contact: usize, y: &[f64]) -> f64 {
        self.gaps[contact].0.evaluate(&self.inputs(&y[..self.coordinates()]))[0]
    }

    /// Slopes ∂gap/∂q at a state: a matrix with a row for each contact and a column for each
    /// coordinate.
    pub fn gap_slopes(&self, y: &[f64]) -> DMatrix<f64> {
        let n = self.coordinates();
        DMatrix::from_row_slice(self.impacts.len(), n, &self.slopes.evaluate(&self.inputs(&y[..n])))
    }

    /// Computes the gap and slip velocities of all contacts at a state, and the slopes of these
    /// velocities.
    pub fn rates(&self, y: &[f64]) -> ContactRates {
        let out = self.rates.evaluate(&self.inputs(y));
        let (values, slopes) = out.split_at(self.count);
        ContactRates {
            values: DVector::from_column_slice(values),
            slopes: DMatrix::from_row_slice(self.count, y.len(), slopes),
        }
    }

    /// Size of the terms whose sum is the gap, in the unit of the gap. Rounding errors of the gap are
    /// fractions of this size. It includes the terms of the coordinates and the intermediate results,
    /// such as lengths that cancel.
    pub fn gap_term_size(&self, contact: usize, y: &[f64]) -> f64 {
        let of_coordinates: f64 =
            self.gap_slopes(y).row(contact).iter().zip(y).map(|(slope, q)| (slope * q).abs()).sum();
        let inputs = self.inputs(&y[..self.coordinates()]);
        let points: Vec<Enclosure> = inputs.iter().map(|x| Enclosure::constant(Interval::point(*x))).collect();
        let range = self.gaps[contact].1.evaluate(&points)[0].value;
        // Each operation is rounded outwards, to both sides.
        let on_the_way = (range.hi() - range.lo()) / (2.0 * f64::EPSILON);
        if on_the_way.is_finite() { of_coordinates + on_the_way } else { of_coordinates }
    }

    /// Largest gap at which a contact counts as closed, in the unit of the gap. It is the rounding error
    /// of the gap plus the change of the gap within `instant` s.
    pub fn closing_gap(&self, contact: usize, y: &[f64], rates: &ContactRates, instant: f64) -> f64 {
        ROUNDINGS * self.gap_term_size(contact, y) + rates.values[self.rows[contact][0]].abs() * instant
    }

    /// Velocity of an opening gap up to which its flight is too short, under the given acceleration of
    /// the gap. Such a flight lasts at most `least` s, or rises no higher than the rounding of the gap.
    pub fn shortest_flight_velocity(&self, contact: usize, y: &[f64], acceleration: f64, least: f64) -> f64 {
        let (height, a) = (TOLD * self.gap_term_size(contact, y), acceleration.abs());
        (0.5 * least * a).max((2.0 * a * height).sqrt())
    }

    /// Kinetic energy of a state, J.
    pub fn kinetic_energy(&self, y: &[f64]) -> f64 {
        let (q, v) = y.split_at(self.coordinates());
        self.system.kinetic_energy(self.parameters, q, v)
    }

    /// Computes the matrices at a state that relate generalized speeds, impulses of contacts and the
    /// kinetic energy.
    ///
    /// # Errors
    /// [`Failure`] if the kinetic energy is not positive definite, so that a permitted motion has no
    /// inertia.
    pub fn operators(&self, y: &[f64], rates: &ContactRates) -> Result<ContactOperators, Failure> {
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
            message: "a permitted motion has no inertia, so that the impulses are not known".to_owned(),
        })?;
        Ok(ContactOperators { basis, of_u, inertia })
    }

    /// Computes the gap and slip velocities at a state, and their changes by impulses along the gap and
    /// slip directions of all contacts.
    ///
    /// # Errors
    /// [`Failure`] if a permitted motion has no inertia.
    pub fn response(&self, y: &[f64], rates: &ContactRates) -> Result<ImpulseResponse, Failure> {
        let ContactOperators { basis, of_u, inertia } = self.operators(y, rates)?;
        let (q, v) = y.split_at(self.coordinates());
        let mut u = vec![0.0; self.system.lengths().speeds];
        self.system.generalized_speeds(self.parameters, q, v, &mut u);
        let moved = inertia.solve(&of_u.transpose());
        let driven = &rates.values - &of_u * DVector::from_vec(u);
        Ok(ImpulseResponse {
            velocities: rates.values.clone(),
            driven,
            changes: &basis * &moved,
            compliance: &of_u * moved,
        })
    }

    /// Computes the motion variables v for the generalized speeds `u` at the coordinates `q`.
    fn variables(&self, q: &[f64], u: &[f64]) -> DVector<f64> {
        let mut v = vec![0.0; self.system.lengths().variables];
        self.system.motion_variables(self.parameters, q, u, &mut v);
        DVector::from_vec(v)
    }

    /// Computes the matrix of the kinetic energy T in the generalized speeds, by second differences of
    /// T. These are exact up to rounding, because T is quadratic. `rest` are the motion variables at
    /// zero speeds.
    fn inertia(&self, q: &[f64], basis: &DMatrix<f64>, rest: &DVector<f64>) -> DMatrix<f64> {
        let energy = |shift: DVector<f64>| self.system.kinetic_energy(self.parameters, q, (rest + shift).as_slice());
        let still = energy(DVector::zeros(rest.len()));
        let speeds = basis.ncols();
        let diagonal: Vec<f64> = (0..speeds)
            .map(|i| energy(basis.column(i).into_owned()) + energy(-basis.column(i)) - 2.0 * still)
            .collect();
        // Scales the directions to equal energy, so that no speed is lost in the rounding of another with a
        // larger unit.
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

    /// Builds the linear system for impulses or forces of the given contacts, which are closed at one
    /// instant. Also returns the indices of their rows (gap and slip velocities) among all rows.
    pub fn closed_contact_system(
        &self,
        response: &ImpulseResponse,
        contacts: &[usize],
    ) -> (ClosedContacts, Vec<usize>) {
        let all: Vec<usize> = contacts.iter().flat_map(|at| self.rows[*at].clone()).collect();
        let mut next = 0..;
        let rows = contacts.iter().map(|at| next.by_ref().take(self.rows[*at].len()).collect()).collect();
        let compliance = response.compliance.select_rows(&all).select_columns(&all);
        let friction = contacts.iter().map(|at| self.friction(*at)).collect();
        (ClosedContacts { compliance, rows, friction }, all)
    }

    /// True if the scene uses Poisson's law of impact; false if it uses Newton's law.
    pub fn is_poisson(&self) -> bool {
        self.impacts.first().is_some_and(|impact| impact.law == ImpactLaw::Poisson)
    }

    /// Computes the impulses of the contacts `contacts`, which are closed at one instant, by the scene's
    /// law of impact. `velocities` are the gap and slip velocities of all contacts before the impact.
    /// Returns the impulses along the rows of all contacts, with 0 for contacts that take no part.
    ///
    /// # Errors
    /// [`UndecidedContacts`] if no impulses separate the contacts, or if several sets of impulses do.
    pub fn impulses(
        &self,
        response: &ImpulseResponse,
        velocities: &DVector<f64>,
        contacts: &[usize],
    ) -> Result<DVector<f64>, UndecidedContacts> {
        let (closed, rows) = self.closed_contact_system(response, contacts);
        let before = velocities.select_rows(&rows);
        let restitution: Vec<f64> = contacts.iter().map(|at| self.impacts[*at].restitution).collect();
        let some = if self.is_poisson() {
            closed.poisson_impact(&before, &restitution)
        } else {
            closed.newton_impact(&before, &restitution)
        };
        Ok(self.spread_over_contact_rows(&some?, &rows))
    }

    /// Spreads the values `some`, one for each index in `rows`, over the rows of all contacts. Every
    /// other row is 0.
    pub fn spread_over_contact_rows(&self, some: &DVector<f64>, rows: &[usize]) -> DVector<f64> {
        let mut all = DVector::zeros(self.count);
        for (row, value) in rows.iter().zip(some.iter()) {
            all[*row] = *value;
        }
        all
    }
}

/// Computes the partial derivatives of the expression `e` by each symbol of a list.
fn contact_partial_derivatives(arena: &mut Arena, e: Expr, symbols: &[Expr]) -> Vec<Expr> {
    symbols.iter().map(|symbol| Differential::partial(*symbol).apply(arena, e)).collect()
}
