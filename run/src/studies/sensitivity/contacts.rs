//! Derivatives of the impulses and forces of contacts with respect to parameters and state.
//!
//! Impulses and forces Λ follow from a linear system while the set of pushing contacts stays: M a − Wᵀ Λ = 0, and W a +
//! c = 0 along the rows that push. c is the motion of these rows without Λ: accelerations, or the parts of velocities
//! that are to be removed. Once a and Λ are known, their derivatives follow from those of the residuals, by the same
//! matrices. Friction of slipping contacts is part of the same system ([`super::grip`]). The derivatives of the
//! residuals are differences in 32 digits ([`super::difference`]), so contacts need no second definition.

use super::difference::along;
use super::grip::Grip;
use crate::preparation::impacts::{Contacts, Operators};
use nalgebra::DVector;
use tripos_derive::algebra::value::evaluate::Tape;
use tripos_sim::Failure;
use tripos_traits::{DoubleDouble, Lengths, Scalar, System};

/// Fraction of the size of its terms below which a derivative of a contact counts as zero.
pub const SMALL: f64 = 1e-7;

/// The contacts of a scene with their equations in 32 digits.
pub struct Wide<'a> {
    pub contacts: &'a Contacts<'a>,
    system: &'a dyn System<DoubleDouble>,
    gaps: Vec<Tape<DoubleDouble>>,
    rates: Tape<DoubleDouble>,
    /// Gap below which a contact counts as touched, relative to the size of the gap's terms.
    pub near: f64,
}

/// Direction in parameters and in the integrated state, along which derivatives are taken.
#[derive(Clone, Copy)]
pub struct Direction<'d> {
    pub parameters: &'d [f64],
    pub state: &'d [f64],
}

/// Motion c of the rows of contacts without impulses or forces, with its derivative along a direction.
pub enum Without<'c> {
    /// Accelerations along the rows of contacts, from the rates of the state; `by` holds the derivatives of `rates`.
    Accelerate { rates: &'c [f64], by: &'c [f64] },
    /// Parts of the velocities along the rows that impulses remove, in the order of all rows. `by` holds the
    /// derivatives of the factors `parts`.
    Move { parts: &'c [f64], by: &'c [f64] },
}

/// Contacts at a state, with the impulses or forces Λ along their rows.
pub struct Acting<'c> {
    pub y: &'c [f64],
    pub operators: &'c Operators,
    /// Impulses or forces Λ along all rows.
    pub impulses: &'c DVector<f64>,
    /// Rows along which Λ follows from the motion c, and the friction that follows from Λ.
    pub grip: &'c Grip,
}

/// Derivative of impulses or forces Λ along a direction, and derivative of their effect.
pub struct Change {
    /// Derivative of Λ along each row.
    pub impulses: DVector<f64>,
    /// Derivatives of the changes that Λ causes: of the motion variables, or of their rates.
    pub variables: DVector<f64>,
    /// Derivatives of the changes that Λ causes: of the generalized speeds, or of their rates.
    pub speeds: DVector<f64>,
    /// Size of the terms of the change along the rows, each divided by the root of the row's compliance. The largest of
    /// all rows.
    pub size: f64,
    /// True if dependent rows do not move alike: then no impulses or forces can hold all of them.
    pub is_apart: bool,
}

impl Change {
    /// Returns the change if dependent contacts move alike, otherwise an error.
    ///
    /// # Errors
    /// Text that says why there is no derivative.
    pub fn together(self) -> Result<Self, String> {
        if self.is_apart { Err(APART.to_owned()) } else { Ok(self) }
    }
}

/// Text that says why dependent contacts have no derivative.
pub const APART: &str = "dependent contacts do not move alike";

impl<'a> Wide<'a> {
    /// Prepares contacts whose equations are known to 32 digits.
    pub fn new(contacts: &'a Contacts<'a>, system: &'a dyn System<DoubleDouble>, near: f64) -> Self {
        let gaps = contacts.gaps.iter().map(|(gap, _)| gap.to()).collect();
        Self { contacts, system, gaps, rates: contacts.rates.to(), near }
    }

    /// Derivative of the gap of a contact along a direction at a state, and the size of its terms.
    pub fn gap(&self, contact: usize, y: &[f64], direction: Direction<'_>) -> (f64, f64) {
        let p = self.contacts.parameters;
        let n = self.system.lengths().coordinates;
        let (x, d) = ([p, &y[..n]].concat(), [direction.parameters, &direction.state[..n]].concat());
        let change = along(&x, &d, |x| self.gaps[contact].evaluate(x))[0];
        let slopes = self.contacts.gap_slopes(y);
        (change, size(change, slopes.row(contact).iter().zip(direction.state).map(|(slope, d)| slope * d)))
    }

    /// Derivative, along a direction at a state, of the velocity along a row, and the size of its terms.
    pub fn velocity(&self, row: usize, y: &[f64], direction: Direction<'_>) -> (f64, f64) {
        let x = [self.contacts.parameters, y].concat();
        let change = along(&x, &[direction.parameters, direction.state].concat(), |x| self.rates.evaluate(x))[row];
        let slopes = self.contacts.rates(y).slopes;
        (change, size(change, slopes.row(row).iter().zip(direction.state).map(|(slope, d)| slope * d)))
    }

    /// Derivative of impulses or forces along a direction. Λ follows from c along the rows of the grip, and changes by
    /// `given` in addition.
    pub fn change(
        &self,
        acting: &Acting<'_>,
        without: &Without<'_>,
        direction: Direction<'_>,
        given: &DVector<f64>,
    ) -> Result<Change, Failure> {
        let Operators { basis, of_u, inertia } = acting.operators;
        let (speeds, rows) = (basis.ncols(), &acting.grip.rows);
        let p = self.contacts.parameters;
        let a = inertia.solve(&(of_u.transpose() * acting.impulses));
        let (extra, by) = match without {
            Without::Accelerate { rates, by } => (*rates, *by),
            Without::Move { parts, by } => (*parts, *by),
        };
        let x = [p, acting.y, extra].concat();
        let d = [direction.parameters, direction.state, by].concat();
        let all = along(&x, &d, |x| self.residuals(x, &a, acting, without));
        let (first, rest) = all.split_at(speeds);
        let (second, third) = rest.split_at(rows.len());
        // M a′ = Wᵀ Λ′ − r₁ and W a′ = −r₂
        let first = inertia.solve(&DVector::from_column_slice(first));
        let aside = of_u * &first;
        let moved = inertia.solve(&(of_u.transpose() * given)) - &first;
        let compliance = of_u * inertia.solve(&of_u.transpose());
        let c = DVector::from_fn(rows.len(), |at, _| second[at] + (of_u.row(rows[at]) * &moved)[0]);
        let own = acting.grip.system(&compliance).solve(&c).ok_or_else(unknown)?;
        let following = acting.grip.spread(given.len()) * own;
        let moved = moved + inertia.solve(&(of_u.transpose() * &following));
        let impulses = given + following;
        let slopes = self.contacts.rates(acting.y).slopes;
        let (carried, own) = match without {
            Without::Accelerate { .. } => (by, extra),
            Without::Move { .. } => (direction.state, acting.y),
        };
        // |W a| ≤ √G √(aᵀ M a) along each row.
        let measure = inertia.l().transpose();
        let energy = (&measure * &moved).norm() + (&measure * &first).norm();
        let part = part_of(&[p, acting.y].concat(), &[direction.parameters, direction.state].concat());
        let (mut size, mut is_apart) = (0.0_f64, false);
        for (at, row) in rows.iter().enumerate() {
            let of_state: f64 = slopes.row(*row).iter().zip(carried).map(|(slope, d)| (slope * d).abs()).sum();
            let terms: f64 = of_u.row(*row).iter().zip(moved.iter()).map(|(of, moved)| (of * moved).abs()).sum();
            let whole: f64 = slopes.row(*row).iter().zip(own).map(|(slope, own)| (slope * own).abs()).sum();
            let g = compliance[(*row, *row)];
            // Slopes have errors of integration, which count as the motion of the row times the largest relative
            // change.
            let rounded = part * whole + ROUNDED * g.max(0.0).sqrt() * energy;
            let of_row = second[at].abs() + aside[*row].abs() + of_state + terms + rounded;
            size = size.max(if g > 0.0 { of_row / g.sqrt() } else { 0.0 });
            let left = second[at] + (of_u.row(*row) * &moved)[0];
            is_apart |= left.abs() > SMALL * of_row;
        }
        let variables = DVector::from_column_slice(third) + basis * &moved;
        Ok(Change { impulses, variables, speeds: moved, size, is_apart })
    }

    /// Computes in 32 digits the residuals M a − Wᵀ Λ, then W a + c along the rows of the grip, then the change of the
    /// motion variables by a.
    fn residuals(
        &self,
        x: &[DoubleDouble],
        a: &DVector<f64>,
        acting: &Acting<'_>,
        without: &Without<'_>,
    ) -> Vec<DoubleDouble> {
        let Lengths { parameters, coordinates: n, variables, speeds, .. } = self.system.lengths();
        let (state, count) = (n + variables, self.contacts.count);
        let (p, y, extra) = (&x[..parameters], &x[parameters..parameters + state], &x[parameters + state..]);
        let wide = DoubleDouble::from_f64;
        let told = self.rates.evaluate(&x[..parameters + state]);
        let (velocities, slopes) = told.split_at(count);
        let motions = Motions { system: self.system, p, q: &y[..n] };
        let rest = motions.variables(&vec![wide(0.0); speeds]);
        let basis: Vec<Vec<DoubleDouble>> =
            (0..speeds).map(|at| less(&motions.variables(&axis(speeds, at)), &rest)).collect();
        let of_u = |row: usize, at: usize| dot(&slopes[row * state + n..(row + 1) * state], &basis[at]);
        let still = motions.energy(&rest);
        let added = motions.added(&basis, a);
        let moved = motions.energy(&sum(&rest, &added));
        let mut out = Vec::with_capacity(speeds + acting.grip.rows.len() + variables);
        for (at, own) in basis.iter().enumerate() {
            // T is a quadratic form: T(e + a) − T(e) − T(a) + T(0) = eᵀ M a.
            let with = sum(&rest, own);
            let momentum = motions.energy(&sum(&with, &added)) - motions.energy(&with) - moved + still;
            let impulses = (0..count).fold(wide(0.0), |sum, row| sum + of_u(row, at) * wide(acting.impulses[row]));
            out.push(momentum - impulses);
        }
        for row in &acting.grip.rows {
            let of_a = (0..speeds).fold(wide(0.0), |sum, at| sum + of_u(*row, at) * wide(a[at]));
            let without = match without {
                Without::Accelerate { .. } => dot(&slopes[row * state..(row + 1) * state], extra),
                Without::Move { .. } => extra[*row] * velocities[*row],
            };
            out.push(of_a + without);
        }
        out.extend(added);
        out
    }
}

/// Motions that the constraints permit at a configuration, in 32 digits.
struct Motions<'m> {
    system: &'m dyn System<DoubleDouble>,
    p: &'m [DoubleDouble],
    q: &'m [DoubleDouble],
}

impl Motions<'_> {
    /// Motion variables that belong to the generalized speeds `u`.
    fn variables(&self, u: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let mut v = vec![DoubleDouble::from_f64(0.0); self.system.lengths().variables];
        self.system.motion_variables(self.p, self.q, u, &mut v);
        v
    }

    /// Kinetic energy with the motion variables `v`, J.
    fn energy(&self, v: &[DoubleDouble]) -> DoubleDouble {
        self.system.kinetic_energy(self.p, self.q, v)
    }

    /// Change of the motion variables if the generalized speeds change by `a`; `basis` has one column for each speed.
    fn added(&self, basis: &[Vec<DoubleDouble>], a: &DVector<f64>) -> Vec<DoubleDouble> {
        let mut out = vec![DoubleDouble::from_f64(0.0); self.system.lengths().variables];
        for (column, a) in basis.iter().zip(a.iter()) {
            let a = DoubleDouble::from_f64(*a);
            out.iter_mut().zip(column).for_each(|(out, own)| *out = *out + a * *own);
        }
        out
    }
}

/// Unit vector of `speeds` components, with 1 at the index `at`.
fn axis(speeds: usize, at: usize) -> Vec<DoubleDouble> {
    (0..speeds).map(|other| DoubleDouble::int(i64::from(other == at))).collect()
}

fn sum(a: &[DoubleDouble], b: &[DoubleDouble]) -> Vec<DoubleDouble> {
    a.iter().zip(b).map(|(a, b)| *a + *b).collect()
}

/// Difference of two vectors, component by component.
fn less(a: &[DoubleDouble], b: &[DoubleDouble]) -> Vec<DoubleDouble> {
    a.iter().zip(b).map(|(a, b)| *a - *b).collect()
}

fn dot(a: &[DoubleDouble], b: &[DoubleDouble]) -> DoubleDouble {
    a.iter().zip(b).fold(DoubleDouble::from_f64(0.0), |sum, (a, b)| sum + *a * *b)
}

/// Fraction of the change of the whole motion that counts at least among the terms of a row: a smaller change is
/// rounding.
const ROUNDED: f64 = 1e-5;

/// Largest change of any component along a direction, relative to the size of the component or 1.
fn part_of(x: &[f64], direction: &[f64]) -> f64 {
    x.iter().zip(direction).map(|(x, d)| d.abs() / x.abs().max(1.0)).fold(0.0, f64::max)
}

/// Size of the terms of a derivative: its `parts` by the state, and the rest, which parameters cause.
fn size(change: f64, parts: impl Iterator<Item = f64>) -> f64 {
    let (sum, size) = parts.fold((0.0, 0.0), |(sum, size), part: f64| (sum + part, size + part.abs()));
    size + (change - sum).abs()
}

/// Failure that reports impulses or forces without a finite derivative.
fn unknown() -> Failure {
    Failure { code: "not-finite", message: "the contact forces have no finite derivative".to_owned() }
}
