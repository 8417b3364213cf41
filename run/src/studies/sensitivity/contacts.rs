//! Derivatives of the impulses and forces of contacts by parameters and state.
//!
//! Impulses and forces follow from a linear system while the set of pushing contacts stays: M a − Wᵀ Λ = 0, and W a + c
//! = 0 along the rows that push. c is the motion of these rows without them: accelerations, or the parts of velocities
//! that are to be removed. With a and Λ known, their derivatives follow from those of the residuals, by the same
//! matrices. Friction of slipping contacts stands in the same system ([`super::grip`]). The derivatives of the
//! residuals are differences in 32 digits ([`super::difference`]), so contacts need no second definition.

use super::difference::along;
use super::grip::Grip;
use crate::preparation::impacts::{Contacts, Operators};
use nalgebra::DVector;
use tripos_derive::algebra::value::evaluate::Tape;
use tripos_sim::Failure;
use tripos_traits::{DoubleDouble, Lengths, Scalar, System};

/// Fraction of the size of its terms below which a derivative counts as zero.
pub const SMALL: f64 = 1e-7;

/// The contacts of a scene in 32 digits.
pub struct Wide<'a> {
    pub contacts: &'a Contacts<'a>,
    system: &'a dyn System<DoubleDouble>,
    gaps: Vec<Tape<DoubleDouble>>,
    rates: Tape<DoubleDouble>,
    /// Relative gap below which a contact counts as touched, over the size of the gap's terms.
    pub near: f64,
}

/// Direction of parameters and of the integrated state, along which derivatives are taken.
#[derive(Clone, Copy)]
pub struct Direction<'d> {
    pub parameters: &'d [f64],
    pub state: &'d [f64],
}

/// Motion c of the rows without impulses or forces, with its derivative.
pub enum Without<'c> {
    /// Accelerations: from the rates of the state, whose derivatives are `by`.
    Accelerate { rates: &'c [f64], by: &'c [f64] },
    /// Velocities: from the parts of them that impulses remove, in the order of all rows. `by` holds the derivatives of
    /// the parts.
    Move { parts: &'c [f64], by: &'c [f64] },
}

/// Contacts at a state, with the impulses or forces along their rows.
pub struct Acting<'c> {
    pub y: &'c [f64],
    pub operators: &'c Operators,
    /// Λ along all rows.
    pub impulses: &'c DVector<f64>,
    /// Rows along which Λ follows from c, and the friction that follows from Λ.
    pub grip: &'c Grip,
}

/// Derivative of impulses or forces along a direction, and of their effect.
pub struct Change {
    /// The slopes of Λ along all rows.
    pub impulses: DVector<f64>,
    /// Slopes of the changes of the motion variables that Λ causes, or of their rates.
    pub variables: DVector<f64>,
    /// Slopes of the changes of the speeds that Λ causes, or of their rates.
    pub speeds: DVector<f64>,
    /// Size of the terms of the change along the rows, each over the root of its compliance.
    pub size: f64,
    /// True if dependent rows do not move alike: then no impulses or forces hold all of them.
    pub is_apart: bool,
}

impl Change {
    /// Returns the change if dependent contacts move alike.
    ///
    /// # Errors
    /// Reason why there is no derivative.
    pub fn together(self) -> Result<Self, String> {
        if self.is_apart { Err(APART.to_owned()) } else { Ok(self) }
    }
}

/// Reason why dependent contacts have no derivative.
pub const APART: &str = "contacts of which one follows from the others do not move alike";

impl<'a> Wide<'a> {
    /// Prepares contacts whose equations are known to 32 digits.
    pub fn new(contacts: &'a Contacts<'a>, system: &'a dyn System<DoubleDouble>, near: f64) -> Self {
        let gaps = contacts.gaps.iter().map(|(gap, _)| gap.to()).collect();
        Self { contacts, system, gaps, rates: contacts.rates.to(), near }
    }

    /// Derivative of a gap, and the size of its terms.
    pub fn gap(&self, contact: usize, y: &[f64], direction: Direction<'_>) -> (f64, f64) {
        let p = self.contacts.parameters;
        let n = self.system.lengths().coordinates;
        let (x, d) = ([p, &y[..n]].concat(), [direction.parameters, &direction.state[..n]].concat());
        let change = along(&x, &d, |x| self.gaps[contact].evaluate(x))[0];
        let slopes = self.contacts.gap_slopes(y);
        (change, size(change, slopes.row(contact).iter().zip(direction.state).map(|(slope, d)| slope * d)))
    }

    /// Derivative of the velocity along a row, and the size of its terms.
    pub fn velocity(&self, row: usize, y: &[f64], direction: Direction<'_>) -> (f64, f64) {
        let x = [self.contacts.parameters, y].concat();
        let change = along(&x, &[direction.parameters, direction.state].concat(), |x| self.rates.evaluate(x))[row];
        let slopes = self.contacts.rates(y).slopes;
        (change, size(change, slopes.row(row).iter().zip(direction.state).map(|(slope, d)| slope * d)))
    }

    /// Derivative of impulses or forces: Λ follows from c along its rows, and changes by `given` besides.
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
        let accelerates = matches!(without, Without::Accelerate { .. });
        let all = along(&x, &d, |x| self.residuals(x, &a, acting, accelerates));
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
        let carried = if accelerates { by } else { direction.state };
        let own = if accelerates { extra } else { acting.y };
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
            // Slopes have errors of integration. They count as the motion of the row times the largest relative change.
            let rounded = part * whole + ROUNDED * g.max(0.0).sqrt() * energy;
            let of_row = second[at].abs() + aside[*row].abs() + of_state + terms + rounded;
            size = size.max(if g > 0.0 { of_row / g.sqrt() } else { 0.0 });
            let left = second[at] + (of_u.row(*row) * &moved)[0];
            is_apart |= left.abs() > SMALL * of_row;
        }
        let variables = DVector::from_column_slice(third) + basis * &moved;
        Ok(Change { impulses, variables, speeds: moved, size, is_apart })
    }

    /// Residuals M a − Wᵀ Λ, then W a + c along the rows that follow, then the change of the motion variables by a.
    fn residuals(
        &self,
        x: &[DoubleDouble],
        a: &DVector<f64>,
        acting: &Acting<'_>,
        accelerates: bool,
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
            let without = if accelerates {
                dot(&slopes[row * state..(row + 1) * state], extra)
            } else {
                extra[*row] * velocities[*row]
            };
            out.push(of_a + without);
        }
        out.extend(added);
        out
    }
}

/// The permitted motions at a configuration.
struct Motions<'m> {
    system: &'m dyn System<DoubleDouble>,
    p: &'m [DoubleDouble],
    q: &'m [DoubleDouble],
}

impl Motions<'_> {
    /// Motion variables that belong to these speeds.
    fn variables(&self, u: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let mut v = vec![DoubleDouble::from_f64(0.0); self.system.lengths().variables];
        self.system.motion_variables(self.p, self.q, u, &mut v);
        v
    }

    fn energy(&self, v: &[DoubleDouble]) -> DoubleDouble {
        self.system.kinetic_energy(self.p, self.q, v)
    }

    /// Change of the motion variables by speeds a.
    fn added(&self, basis: &[Vec<DoubleDouble>], a: &DVector<f64>) -> Vec<DoubleDouble> {
        let mut out = vec![DoubleDouble::from_f64(0.0); self.system.lengths().variables];
        for (column, a) in basis.iter().zip(a.iter()) {
            let a = DoubleDouble::from_f64(*a);
            out.iter_mut().zip(column).for_each(|(out, own)| *out = *out + a * *own);
        }
        out
    }
}

fn axis(speeds: usize, at: usize) -> Vec<DoubleDouble> {
    (0..speeds).map(|other| DoubleDouble::int(i64::from(other == at))).collect()
}

fn sum(a: &[DoubleDouble], b: &[DoubleDouble]) -> Vec<DoubleDouble> {
    a.iter().zip(b).map(|(a, b)| *a + *b).collect()
}

fn less(a: &[DoubleDouble], b: &[DoubleDouble]) -> Vec<DoubleDouble> {
    a.iter().zip(b).map(|(a, b)| *a - *b).collect()
}

fn dot(a: &[DoubleDouble], b: &[DoubleDouble]) -> DoubleDouble {
    a.iter().zip(b).fold(DoubleDouble::from_f64(0.0), |sum, (a, b)| sum + *a * *b)
}

/// Fraction of the change of the whole motion that counts at least among a row's terms: a change below it is rounding.
const ROUNDED: f64 = 1e-5;

/// Largest change of any number along a direction, relative to its size or 1.
fn part_of(x: &[f64], direction: &[f64]) -> f64 {
    x.iter().zip(direction).map(|(x, d)| d.abs() / x.abs().max(1.0)).fold(0.0, f64::max)
}

/// Size of the terms of a derivative: its parts by the state, and the rest, which parameters cause.
fn size(change: f64, parts: impl Iterator<Item = f64>) -> f64 {
    let (sum, size) = parts.fold((0.0, 0.0), |(sum, size), part: f64| (sum + part, size + part.abs()));
    size + (change - sum).abs()
}

fn unknown() -> Failure {
    Failure { code: "not-finite", message: "what acts along contacts has no finite derivative".to_owned() }
}
