//! Proof that results computed from equations of motion satisfy them: accelerations, their Jacobian, inverse
//! dynamics.
//!
//! The equations are M x = f with x = (v̇, reactions or multipliers). The solved v̇ are substituted. Then M x − f is
//! evaluated modulo random primes at random states, in dual numbers along a random direction of the state. With
//! reactions, v̇ is right if the remaining system has a solution for the reactions. The derivative of M x − f
//! vanishes only if the Jacobian is the derivative of v̇.
//!
//! Residues are exact: rounding can neither hide nor invent an error. A wrong formula passes only if a polynomial
//! that is not zero vanishes at every point. The probability of a zero at one point is below the degree divided by
//! 2^60 (Schwartz 1980, Zippel 1979).
//!
//! If constraints tie the motion variables, v = W(q) u with independent speeds u. The equations then hold only for
//! states that satisfy the constraints.
//!
//! Invariant: the check never uses the derivatives of [`crate::algebra::term::calculus`], from which the Jacobian was
//! computed.

use super::jacobian::Jacobian;
use crate::algebra::solve::elimination::Elimination;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::term::steps::{Definition, fresh_symbol, substitute_steps};
use crate::algebra::text::definitions::write_definitions;
use crate::algebra::value::field::Field;
use crate::algebra::value::tangent::{TangentValue, Tangents};
use crate::algebra::{Arena, Expr};
use crate::mechanics::equations::Equations;
use crate::mechanics::unsolved::Unproved;
use std::collections::BTreeMap;

/// Number of random states at which equations are checked, each modulo a different prime.
const POINTS: usize = 2;

/// Evidence that a result (accelerations, Jacobian or inverse dynamics) satisfies the equations of
/// motion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certificate {
    /// Primes modulo which the result was checked. Each was used at a different random state.
    pub primes: Vec<u64>,
}

/// Proves that the solved v̇ satisfy the equations of motion. If `jacobian` is given, proves that it is their
/// derivative.
///
/// # Errors
/// Returns [`Unproved`] with the first row that fails, or `Unproved::NoPoint` if no random state gives all terms a
/// value.
pub fn certify_accelerations(
    arena: &Arena,
    equations: &Equations,
    solved: &Elimination,
    jacobian: Option<&Jacobian>,
) -> Result<Certificate, Unproved> {
    let mut claim = CertificateClaim::new(arena, equations, solved, jacobian);
    let terms = claim.terms();
    let mut tangents = Tangents::new(&claim.arena, &terms, &claim.along);
    let mut primes = Vec::with_capacity(POINTS);
    for _ in 0..POINTS {
        let (field, values) = tangents.next().ok_or(Unproved::NoPoint)?;
        claim.shape.check(field, &values)?;
        primes.push(field.prime);
    }
    Ok(Certificate { primes })
}

/// Claim to be proved: equations, solution and Jacobian. They are terms in parameters, q, v and the symbols of the
/// direction.
struct CertificateClaim {
    /// Arena of all terms of the claim; a copy of the caller's.
    arena: Arena,
    /// Coordinates and independent motion variables, each paired with the symbol of its component of
    /// the direction.
    along: Vec<(Expr, Expr)>,
    /// Matrix M of the equations as they were derived.
    matrix: Vec<Vec<Expr>>,
    /// Right-hand side f of the equations as they were derived.
    forcing: Vec<Expr>,
    /// Rates q̇ of the coordinates, as the equations give them.
    coordinate_rates: Vec<Expr>,
    /// Accelerations v̇, as the solution gives them.
    accelerations: Vec<Expr>,
    /// Derivatives of q̇ and v̇ along the direction, from the Jacobian; empty without a Jacobian.
    slopes: Vec<Expr>,
    /// Numbers of terms of each kind, by which the list of values is split.
    shape: CertificateShape,
}

/// Numbers of terms of each kind in the list that [`CertificateClaim::terms`] returns.
#[derive(Clone, Copy)]
struct CertificateShape {
    /// Number of rows of the equations.
    rows: usize,
    /// Number of unknowns: accelerations, then reactions or multipliers.
    unknowns: usize,
    /// Number of coordinates, and so of rates q̇.
    coordinates: usize,
    /// Number of accelerations v̇.
    accelerations: usize,
    /// True if the claim includes a Jacobian. The list then ends with the derivatives along the direction.
    has_slopes: bool,
}

impl CertificateClaim {
    /// States the claim. Symbols of definitions are replaced by their terms. If constraints tie the motion variables
    /// v, they are expressed in independent speeds.
    fn new(arena: &Arena, equations: &Equations, solved: &Elimination, jacobian: Option<&Jacobian>) -> Self {
        let mut arena = arena.clone();
        let Direction { along, states, slopes } = Direction::new(&mut arena, equations);
        // The definitions of the equations come first, so that the matrix is used in its original form, which the
        // elimination may have changed.
        let mut put = states.clone();
        substitute_steps(&mut arena, &mut put, &equations.definitions);
        let matrix: Vec<Vec<Expr>> = equations.matrix.iter().map(|row| put.all(&mut arena, row)).collect();
        let forcing = put.all(&mut arena, &equations.forcing);
        let coordinate_rates = put.all(&mut arena, &equations.coordinate_rates);
        let n = equations.variables.len();
        let mut put = states;
        if let Some(jacobian) = jacobian {
            jacobian.direction.iter().zip(&slopes).for_each(|(symbol, slope)| put.set(*symbol, *slope));
        }
        substitute_steps(&mut arena, &mut put, jacobian.map_or(&solved.steps, |jacobian| &jacobian.steps));
        let accelerations = put.all(&mut arena, &equations.unknowns[..n]);
        let rows = jacobian.map_or(&[][..], |jacobian| &jacobian.entries);
        let is_product = jacobian.is_some_and(|jacobian| !jacobian.direction.is_empty());
        let products = rows.iter().map(|row| {
            let row = put.all(&mut arena, row);
            if is_product { row[0] } else { dot(&mut arena, &row, &slopes) }
        });
        let slopes: Vec<Expr> = products.collect();
        let shape = CertificateShape {
            rows: forcing.len(),
            unknowns: equations.unknowns.len(),
            coordinates: coordinate_rates.len(),
            accelerations: n,
            has_slopes: jacobian.is_some(),
        };
        Self { arena, along, matrix, forcing, coordinate_rates, accelerations, slopes, shape }
    }

    /// All terms of the claim: M row by row, f, q̇, v̇, then the derivatives along the direction.
    fn terms(&mut self) -> Vec<Expr> {
        let lists = [&self.forcing, &self.coordinate_rates, &self.accelerations, &self.slopes];
        self.matrix.iter().chain(lists).flatten().copied().collect()
    }
}

/// Direction of the state (q, v) along which the right-hand side is differentiated.
struct Direction {
    /// Coordinates and independent motion variables, each paired with the symbol of its component of
    /// the direction.
    along: Vec<(Expr, Expr)>,
    /// Substitution that replaces dependent motion variables by terms in independent variables. Empty if all are
    /// independent.
    states: Substitution,
    /// Components of the direction for all coordinates and motion variables, as terms in the symbols of
    /// `along`.
    slopes: Vec<Expr>,
}

impl Direction {
    /// Creates a direction with a fresh symbol for each coordinate and independent motion variable.
    fn new(arena: &mut Arena, equations: &Equations) -> Self {
        let is_tied = equations.speeds.len() < equations.variables.len();
        let independent = if is_tied { &equations.speeds } else { &equations.variables };
        let moving = equations.coordinates.iter().chain(independent);
        let along: Vec<(Expr, Expr)> = moving.map(|x| (*x, fresh_symbol(arena, "direction"))).collect();
        let mut states = Substitution::default();
        if is_tied {
            let mut put = Substitution::default();
            substitute_steps(arena, &mut put, &equations.definitions);
            let values = put.all(arena, &equations.motion_variables);
            equations.variables.iter().zip(values).for_each(|(v, value)| states.set(*v, value));
        }
        let mut slope_of = Differential::along(&along);
        let all = equations.coordinates.iter().chain(&equations.variables);
        let slopes = all.map(|x| {
            let value = states.apply(arena, *x);
            slope_of.apply(arena, value)
        });
        let slopes = slopes.collect();
        Self { along, states, slopes }
    }
}

/// Scalar product Σ a_i b_i of two lists of terms.
fn dot(arena: &mut Arena, a: &[Expr], b: &[Expr]) -> Expr {
    let products: Vec<Expr> = a.iter().zip(b).map(|(a, b)| arena.mul(*a, *b)).collect();
    arena.sum(&products)
}

impl CertificateShape {
    /// Checks the claim at a random state. `values` are the values of [`CertificateClaim::terms`] modulo the prime of
    /// the field `f`.
    ///
    /// # Errors
    /// Returns `Unproved` with the first row of the Jacobian or of the equations that does not hold.
    fn check(&self, f: Field, values: &[TangentValue]) -> Result<(), Unproved> {
        let (matrix, rest) = values.split_at(self.rows * self.unknowns);
        let (forcing, rest) = rest.split_at(self.rows);
        let (coordinate_rates, rest) = rest.split_at(self.coordinates);
        let (accelerations, slopes) = rest.split_at(self.accelerations);
        if self.has_slopes {
            let (of_rates, _) = slopes.split_at(self.coordinates);
            let is_wrong = |(rate, slope): (&TangentValue, &TangentValue)| rate.slope != slope.value;
            if let Some(row) = coordinate_rates.iter().zip(of_rates).position(is_wrong) {
                return Err(Unproved::Jacobian(row));
            }
        }
        let v_dot: Vec<TangentValue> = accelerations
            .iter()
            .enumerate()
            .map(|(at, dual)| match slopes.get(self.coordinates + at) {
                Some(slope) => TangentValue { slope: slope.value, ..*dual },
                None => *dual,
            })
            .collect();
        // The reactions r solve B r = f − M v̇.
        let rows = matrix.chunks(self.unknowns.max(1)).zip(forcing).map(|(row, right)| {
            let (of_v_dot, of_reactions) = row.split_at(self.accelerations);
            let right = of_v_dot.iter().zip(&v_dot).fold(*right, |right, (m, x)| right.minus_product(f, *m, *x));
            let left = of_reactions.iter().copied().enumerate().filter(|(_, entry)| !entry.is_zero()).collect();
            CertificateRow { left, right }
        });
        match first_uncertified_row(f, rows) {
            None => Ok(()),
            Some((row, WrongDualPart::Value)) => Err(Unproved::Accelerations(row)),
            Some((row, WrongDualPart::Slope)) => Err(Unproved::Jacobian(self.coordinates + row)),
        }
    }
}

/// Linear equation Σ left · unknown = right, in dual numbers modulo a prime.
struct CertificateRow {
    /// Nonzero coefficients of the equation, by index of the unknown.
    left: BTreeMap<usize, TangentValue>,
    /// Right-hand side of the linear equation.
    right: TangentValue,
}

/// Part of a dual number that should be zero but is not.
enum WrongDualPart {
    /// The value is not zero, so the equation itself is wrong.
    Value,
    /// The derivative part is not zero, so the Jacobian is wrong.
    Slope,
}

/// Finds the first row that contradicts the rows before it, by sparse elimination. Returns its
/// index and the wrong part; `None` if the rows have a solution.
fn first_uncertified_row(f: Field, rows: impl Iterator<Item = CertificateRow>) -> Option<(usize, WrongDualPart)> {
    let mut pivots: BTreeMap<usize, CertificateRow> = BTreeMap::new();
    for (at, mut row) in rows.enumerate() {
        let mut from = 0;
        let mut own = None;
        while let Some((&column, &entry)) = row.left.range(from..).find(|(_, entry)| entry.value != 0) {
            let Some(pivot) = pivots.get(&column) else {
                own = Some(column);
                break;
            };
            row.subtract(f, pivot, column, entry);
            from = column + 1;
        }
        if let Some(column) = own {
            pivots.insert(column, row);
        } else if row.right.value != 0 {
            return Some((at, WrongDualPart::Value));
        } else if row.right.slope != 0 && row.left.is_empty() {
            return Some((at, WrongDualPart::Slope));
        }
    }
    None
}

impl CertificateRow {
    /// Subtracts a multiple of a pivot row from this row so that the entry in the pivot's column becomes zero.
    fn subtract(&mut self, f: Field, pivot: &Self, column: usize, entry: TangentValue) {
        let Some(factor) = entry.quotient(f, pivot.left[&column]) else { return };
        for (at, x) in &pivot.left {
            let known = self.left.remove(at).unwrap_or_default();
            let left = known.minus_product(f, factor, *x);
            if !left.is_zero() && *at != column {
                self.left.insert(*at, left);
            }
        }
        self.right = self.right.minus_product(f, factor, pivot.right);
    }
}

impl Equations {
    /// Adds the inverse dynamics M v̇ − f to the equations. If the formulation derived it separately, that form is
    /// kept and proved equal. Equations with reactions or multipliers are returned unchanged.
    ///
    /// # Errors
    /// Returns [`Unproved::InverseDynamics`] with the first row that differs.
    pub fn with_certified_inverse_dynamics(self, arena: &mut Arena) -> Result<Self, Unproved> {
        let has_others = self.formulation.has_reactions() || self.unknowns.len() > self.variables.len();
        if has_others {
            return Ok(self);
        }
        if !self.required.is_empty() {
            certify_inverse_dynamics(arena, &self)?;
            return Ok(self);
        }
        let row = |(row, right): (&Vec<Expr>, &Expr)| {
            let mut terms: Vec<Expr> = row.iter().zip(&self.unknowns).map(|(m, x)| arena.mul(*m, *x)).collect();
            terms.push(arena.neg(*right));
            arena.sum(&terms)
        };
        let required = self.matrix.iter().zip(&self.forcing).map(row).collect();
        Ok(Self { required, ..self })
    }
}

/// Proves that the derived inverse dynamics equals M v̇ − f for any v̇.
///
/// # Errors
/// Returns [`Unproved::InverseDynamics`] with the first row that differs.
pub fn certify_inverse_dynamics(arena: &Arena, equations: &Equations) -> Result<Certificate, Unproved> {
    let mut arena = arena.clone();
    let mut put = Substitution::default();
    substitute_steps(&mut arena, &mut put, &equations.definitions);
    let matrix: Vec<Expr> = equations.matrix.iter().flat_map(|row| put.all(&mut arena, row)).collect();
    let [forcing, required] = [&equations.forcing, &equations.required].map(|list| put.all(&mut arena, list));
    let terms = [matrix, forcing, required, equations.unknowns.clone()].concat();
    let mut tangents = Tangents::new(&arena, &terms, &[]);
    let (rows, columns) = (equations.forcing.len(), equations.unknowns.len());
    let mut primes = Vec::with_capacity(POINTS);
    for _ in 0..POINTS {
        let (f, values) = tangents.next().ok_or(Unproved::NoPoint)?;
        let (matrix, rest) = values.split_at(rows * columns);
        let (forcing, rest) = rest.split_at(rows);
        let (required, unknowns) = rest.split_at(equations.required.len());
        for (row, given) in required.iter().enumerate() {
            let products = matrix[row * columns..][..columns].iter().zip(unknowns);
            let left = products.fold(forcing[row], |left, (m, x)| left.minus_product(f, *m, *x));
            if f.add(left.value, given.value) != 0 {
                return Err(Unproved::InverseDynamics(row));
            }
        }
        primes.push(f.prime);
    }
    Ok(Certificate { primes })
}

/// Proves that a Jacobian contains the derivatives of `values` with respect to the symbols `along`. The values may
/// contain symbols that `steps` define.
///
/// # Errors
/// Returns [`Unproved::Jacobian`] with the index of the first value whose derivatives differ.
pub fn certify_slopes(
    arena: &Arena,
    steps: &[Definition],
    values: &[Expr],
    jacobian: &Jacobian,
    along: &[Expr],
) -> Result<Certificate, Unproved> {
    let mut arena = arena.clone();
    let along: Vec<(Expr, Expr)> = along.iter().map(|x| (*x, fresh_symbol(&mut arena, "direction"))).collect();
    let directions: Vec<Expr> = along.iter().map(|(_, direction)| *direction).collect();
    let mut put = Substitution::default();
    substitute_steps(&mut arena, &mut put, steps);
    let rates = put.all(&mut arena, values);
    let mut put = Substitution::default();
    substitute_steps(&mut arena, &mut put, &jacobian.steps);
    let mut products = Vec::with_capacity(rates.len());
    for row in &jacobian.entries {
        let row = put.all(&mut arena, row);
        products.push(dot(&mut arena, &row, &directions));
    }
    let terms = [rates, products].concat();
    let mut tangents = Tangents::new(&arena, &terms, &along);
    let mut primes = Vec::with_capacity(POINTS);
    for _ in 0..POINTS {
        let (field, values) = tangents.next().ok_or(Unproved::NoPoint)?;
        let (rates, products) = values.split_at(jacobian.entries.len());
        let is_wrong = |(rate, product): (&TangentValue, &TangentValue)| rate.slope != product.value;
        if let Some(row) = rates.iter().zip(products).position(is_wrong) {
            return Err(Unproved::Jacobian(row));
        }
        primes.push(field.prime);
    }
    Ok(Certificate { primes })
}

/// Proves that two lists of generalized forces are equal if the symbols of `steps` have the values of `steps`.
///
/// # Errors
/// Returns [`Unproved::InverseDynamics`] with the index of the first pair that differs.
pub fn certify_equal_forces(
    arena: &Arena,
    steps: &[Definition],
    left: &[Expr],
    right: &[Expr],
) -> Result<Certificate, Unproved> {
    let mut arena = arena.clone();
    let mut put = Substitution::default();
    let (definitions, written) = write_definitions(&mut arena, &[], &[left, right].concat());
    substitute_steps(&mut arena, &mut put, steps);
    substitute_steps(&mut arena, &mut put, &definitions);
    let terms = put.all(&mut arena, &written);
    let mut tangents = Tangents::new(&arena, &terms, &[]);
    let mut primes = Vec::with_capacity(POINTS);
    for _ in 0..POINTS {
        let (field, values) = tangents.next().ok_or(Unproved::NoPoint)?;
        let (left, right) = values.split_at(left.len());
        if let Some(row) = left.iter().zip(right).position(|(left, right)| left.value != right.value) {
            return Err(Unproved::InverseDynamics(row));
        }
        primes.push(field.prime);
    }
    Ok(Certificate { primes })
}
