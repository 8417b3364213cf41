//! Derivatives of the impulses and forces of contacts with respect to parameters and state.
//!
//! Impulses or forces Λ follow from a linear system as long as the set of pushing contacts stays
//! the same: M a − Wᵀ Λ = 0, and W a + c = 0 along the held gap and slip directions. Here a is the
//! motion that Λ causes. c is the motion without Λ: accelerations, or the parts of velocities that
//! impulses remove. With a and Λ known, their derivatives follow from the derivatives of the
//! residuals, by the same matrices. Friction of slipping contacts is part of the system
//! ([`super::held_directions`]).
//!
//! The derivatives of the residuals are differences in 32 digits
//! ([`crate::studies::sensitivity::difference`]). So the contacts need not be defined a second time.

use super::held_directions::HeldDirections;
use crate::preparation::impacts::{ContactOperators, SceneContacts};
use crate::studies::sensitivity::difference::directional_difference;
use nalgebra::DVector;
use tripos_derive::algebra::value::tape::Tape;
use tripos_sim::Failure;
use tripos_traits::{DoubleDouble, Lengths, Scalar, System};

/// Fraction of the sizes of its terms below which the derivative of a contact quantity counts as zero.
pub const SMALL: f64 = 1e-7;

/// Contacts of a scene, with the equations of motion in 32 digits for differences of numbers.
pub struct PreciseContacts<'a> {
    /// Contacts in double precision.
    pub contacts: &'a SceneContacts<'a>,
    /// Equations of motion in 32 digits.
    system: &'a dyn System<DoubleDouble>,
    /// Tapes of the gap of each contact. Inputs: parameters, then coordinates.
    gaps: Vec<Tape<DoubleDouble>>,
    /// Tape of the gap and slip velocities, followed by their derivatives by the state. Inputs:
    /// parameters, then state.
    rates: Tape<DoubleDouble>,
    /// Gap below which a contact counts as touched, relative to the size of the gap's terms.
    pub near: f64,
}

/// Direction in the space of parameters and integrated state, along which a derivative is taken.
#[derive(Clone, Copy)]
pub struct ParameterStateDirection<'d> {
    /// Components of the direction for each parameter.
    pub parameters: &'d [f64],
    /// Components of the direction for each component of the state (q, v).
    pub state: &'d [f64],
}

/// Motion c of the gap and slip directions of contacts without impulses or forces, and its derivative
/// along a direction.
pub enum ForceFreeMotion<'c> {
    /// Accelerations that the rates of the state, `rates`, cause. `by` are the derivatives of `rates`
    /// along a direction.
    Accelerate { rates: &'c [f64], by: &'c [f64] },
    /// Parts of the gap and slip velocities that impulses remove: each velocity times its factor in
    /// `parts`. `by` are the derivatives of the factors along a direction.
    Move { parts: &'c [f64], by: &'c [f64] },
}

/// Contacts at a state, with the impulses or forces Λ along their gap and slip directions.
pub struct ActingContacts<'c> {
    /// State (q, v).
    pub y: &'c [f64],
    /// Matrices at the state that relate generalized speeds, impulses of contacts and kinetic energy.
    pub operators: &'c ContactOperators,
    /// Impulses or forces Λ along the gap and slip directions of all contacts.
    pub impulses: &'c DVector<f64>,
    /// Held directions, whose motion c determines Λ, and the friction that follows from Λ.
    pub grip: &'c HeldDirections,
}

/// Derivative of impulses or forces Λ along a direction of parameters and state, with the derivative of
/// the motion that Λ causes.
pub struct ContactForceDerivative {
    /// Derivative of Λ along each gap and slip direction of all contacts.
    pub impulses: DVector<f64>,
    /// Derivative of the motion that Λ causes: of the change of the motion variables by impulses, or of
    /// the change of their rates by forces.
    pub variables: DVector<f64>,
    /// Derivative of the same motion in generalized speeds: of their change by impulses, or of the change
    /// of their rates by forces.
    pub speeds: DVector<f64>,
    /// Size of the terms of the derivative: the largest size over the held directions, each divided by
    /// the root of the direction's compliance.
    pub size: f64,
    /// True if dependent held directions would move differently, so that no impulses or forces can hold
    /// all of them.
    pub is_apart: bool,
}

impl ContactForceDerivative {
    /// Returns the derivative if contacts that depend on one another move alike.
    ///
    /// # Errors
    /// Text that says why the derivative does not exist, if dependent contacts move differently.
    pub fn require_common_motion(self) -> Result<Self, String> {
        if self.is_apart { Err(APART.to_owned()) } else { Ok(self) }
    }
}

/// Text that says why dependent contacts have no derivative.
pub const APART: &str = "dependent contacts do not move alike";

impl<'a> PreciseContacts<'a> {
    /// Prepares contacts for derivatives, with the equations of motion in 32 digits. A gap below
    /// `near`, relative to the size of its terms, counts as touched.
    pub fn new(contacts: &'a SceneContacts<'a>, system: &'a dyn System<DoubleDouble>, near: f64) -> Self {
        let gaps = contacts.gaps.iter().map(|(gap, _)| gap.to()).collect();
        Self { contacts, system, gaps, rates: contacts.rates.to(), near }
    }

    /// Derivative of a contact's gap along a direction at the state `y`, and the size of the derivative's
    /// terms.
    pub fn gap_derivative(&self, contact: usize, y: &[f64], direction: ParameterStateDirection<'_>) -> (f64, f64) {
        let p = self.contacts.parameters;
        let n = self.system.lengths().coordinates;
        let (x, d) = ([p, &y[..n]].concat(), [direction.parameters, &direction.state[..n]].concat());
        let change = directional_difference(&x, &d, |x| self.gaps[contact].evaluate(x))[0];
        let slopes = self.contacts.gap_slopes(y);
        (change, term_size(change, slopes.row(contact).iter().zip(direction.state).map(|(slope, d)| slope * d)))
    }

    /// Derivative of the gap or slip velocity with the index `row` along a direction at the state `y`, and
    /// the size of the derivative's terms.
    pub fn velocity_derivative(&self, row: usize, y: &[f64], direction: ParameterStateDirection<'_>) -> (f64, f64) {
        let x = [self.contacts.parameters, y].concat();
        let change =
            directional_difference(&x, &[direction.parameters, direction.state].concat(), |x| self.rates.evaluate(x))
                [row];
        let slopes = self.contacts.rates(y).slopes;
        (change, term_size(change, slopes.row(row).iter().zip(direction.state).map(|(slope, d)| slope * d)))
    }

    /// Computes the derivative of the impulses or forces Λ along a direction. The motion c of the held
    /// directions of `acting` determines Λ. `given` is a known part of the derivative of Λ, such as the
    /// part due to a coefficient of friction.
    ///
    /// # Errors
    /// `Failure` if the derivative is not finite.
    pub fn contact_force_derivative(
        &self,
        acting: &ActingContacts<'_>,
        without: &ForceFreeMotion<'_>,
        direction: ParameterStateDirection<'_>,
        given: &DVector<f64>,
    ) -> Result<ContactForceDerivative, Failure> {
        let ContactOperators { basis, of_u, inertia } = acting.operators;
        let (speeds, rows) = (basis.ncols(), &acting.grip.rows);
        let p = self.contacts.parameters;
        let a = inertia.solve(&(of_u.transpose() * acting.impulses));
        let (extra, by) = match without {
            ForceFreeMotion::Accelerate { rates, by } => (*rates, *by),
            ForceFreeMotion::Move { parts, by } => (*parts, *by),
        };
        let x = [p, acting.y, extra].concat();
        let d = [direction.parameters, direction.state, by].concat();
        let all = directional_difference(&x, &d, |x| self.residuals(x, &a, acting, without));
        let (first, rest) = all.split_at(speeds);
        let (second, third) = rest.split_at(rows.len());
        // M a′ = Wᵀ Λ′ − r₁ and W a′ = −r₂
        let first = inertia.solve(&DVector::from_column_slice(first));
        let aside = of_u * &first;
        let moved = inertia.solve(&(of_u.transpose() * given)) - &first;
        let compliance = of_u * inertia.solve(&of_u.transpose());
        let c = DVector::from_fn(rows.len(), |at, _| second[at] + (of_u.row(rows[at]) * &moved)[0]);
        let own = acting.grip.system(&compliance).solve(&c).ok_or_else(missing_contact_derivative_failure)?;
        let following = acting.grip.held_force_spread(given.len()) * own;
        let moved = moved + inertia.solve(&(of_u.transpose() * &following));
        let impulses = given + following;
        let slopes = self.contacts.rates(acting.y).slopes;
        let (carried, own) = match without {
            ForceFreeMotion::Accelerate { .. } => (by, extra),
            ForceFreeMotion::Move { .. } => (direction.state, acting.y),
        };
        // |W a| ≤ √G √(aᵀ M a) along each row.
        let measure = inertia.l().transpose();
        let energy = (&measure * &moved).norm() + (&measure * &first).norm();
        let part = largest_relative_change(&[p, acting.y].concat(), &[direction.parameters, direction.state].concat());
        let (mut size, mut is_apart) = (0.0_f64, false);
        for (at, row) in rows.iter().enumerate() {
            let of_state: f64 = slopes.row(*row).iter().zip(carried).map(|(slope, d)| (slope * d).abs()).sum();
            let terms: f64 = of_u.row(*row).iter().zip(moved.iter()).map(|(of, moved)| (of * moved).abs()).sum();
            let whole: f64 = slopes.row(*row).iter().zip(own).map(|(slope, own)| (slope * own).abs()).sum();
            let g = compliance[(*row, *row)];
            // Slopes of the state have errors of integration. Their size is estimated as the motion of the
            // row times the largest relative change.
            let rounded = part * whole + ROUNDED * g.max(0.0).sqrt() * energy;
            let of_row = second[at].abs() + aside[*row].abs() + of_state + terms + rounded;
            size = size.max(if g > 0.0 { of_row / g.sqrt() } else { 0.0 });
            let left = second[at] + (of_u.row(*row) * &moved)[0];
            is_apart |= left.abs() > SMALL * of_row;
        }
        let variables = DVector::from_column_slice(third) + basis * &moved;
        Ok(ContactForceDerivative { impulses, variables, speeds: moved, size, is_apart })
    }

    /// Computes the residuals of the linear system for Λ, in 32 digits: first M a − Wᵀ Λ, then W a + c
    /// along the held directions. The changes of the motion variables by a follow. `x` joins the
    /// parameters, the state and the factors of c.
    fn residuals(
        &self,
        x: &[DoubleDouble],
        a: &DVector<f64>,
        acting: &ActingContacts<'_>,
        without: &ForceFreeMotion<'_>,
    ) -> Vec<DoubleDouble> {
        let Lengths { parameters, coordinates: n, variables, speeds, .. } = self.system.lengths();
        let (state, count) = (n + variables, self.contacts.count);
        let (p, y, extra) = (&x[..parameters], &x[parameters..parameters + state], &x[parameters + state..]);
        let wide = DoubleDouble::from_f64;
        let told = self.rates.evaluate(&x[..parameters + state]);
        let (velocities, slopes) = told.split_at(count);
        let motions = PreciseMotions { system: self.system, p, q: &y[..n] };
        let rest = motions.variables(&vec![wide(0.0); speeds]);
        let basis: Vec<Vec<DoubleDouble>> =
            (0..speeds).map(|at| vector_difference(&motions.variables(&unit_vector(speeds, at)), &rest)).collect();
        let of_u = |row: usize, at: usize| dot(&slopes[row * state + n..(row + 1) * state], &basis[at]);
        let still = motions.energy(&rest);
        let added = motions.motion_variable_change(&basis, a);
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
                ForceFreeMotion::Accelerate { .. } => dot(&slopes[row * state..(row + 1) * state], extra),
                ForceFreeMotion::Move { .. } => extra[*row] * velocities[*row],
            };
            out.push(of_a + without);
        }
        out.extend(added);
        out
    }
}

/// Motions that the constraints permit in a configuration, computed in 32 digits.
struct PreciseMotions<'m> {
    /// Equations of motion in 32 digits.
    system: &'m dyn System<DoubleDouble>,
    /// Values of the parameters, in the order of the model.
    p: &'m [DoubleDouble],
    /// Values of the generalized coordinates, in the order of the model.
    q: &'m [DoubleDouble],
}

impl PreciseMotions<'_> {
    /// Computes the motion variables v from the generalized speeds `u`.
    fn variables(&self, u: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let mut v = vec![DoubleDouble::from_f64(0.0); self.system.lengths().variables];
        self.system.motion_variables(self.p, self.q, u, &mut v);
        v
    }

    /// Kinetic energy with the motion variables `v`, J.
    fn energy(&self, v: &[DoubleDouble]) -> DoubleDouble {
        self.system.kinetic_energy(self.p, self.q, v)
    }

    /// Change of the motion variables v if the generalized speeds change by `a`. `basis` has a column for
    /// each speed.
    fn motion_variable_change(&self, basis: &[Vec<DoubleDouble>], a: &DVector<f64>) -> Vec<DoubleDouble> {
        let mut out = vec![DoubleDouble::from_f64(0.0); self.system.lengths().variables];
        for (column, a) in basis.iter().zip(a.iter()) {
            let a = DoubleDouble::from_f64(*a);
            out.iter_mut().zip(column).for_each(|(out, own)| *out = *out + a * *own);
        }
        out
    }
}

/// Unit vector of `speeds` components, with 1 at the index `at`.
fn unit_vector(speeds: usize, at: usize) -> Vec<DoubleDouble> {
    (0..speeds).map(|other| DoubleDouble::int(i64::from(other == at))).collect()
}

/// Sum of two vectors, component by component.
fn sum(a: &[DoubleDouble], b: &[DoubleDouble]) -> Vec<DoubleDouble> {
    a.iter().zip(b).map(|(a, b)| *a + *b).collect()
}

/// Difference of two vectors, component by component.
fn vector_difference(a: &[DoubleDouble], b: &[DoubleDouble]) -> Vec<DoubleDouble> {
    a.iter().zip(b).map(|(a, b)| *a - *b).collect()
}

/// Scalar product of two vectors of equal length.
fn dot(a: &[DoubleDouble], b: &[DoubleDouble]) -> DoubleDouble {
    a.iter().zip(b).fold(DoubleDouble::from_f64(0.0), |sum, (a, b)| sum + *a * *b)
}

/// Fraction of the change of the whole motion that is always added to the size of a direction's terms.
/// Smaller changes are rounding errors.
const ROUNDED: f64 = 1e-5;

/// Largest change of a component of `x` along a direction, relative to the size of this component or to
/// 1, whichever is larger.
fn largest_relative_change(x: &[f64], direction: &[f64]) -> f64 {
    x.iter().zip(direction).map(|(x, d)| d.abs() / x.abs().max(1.0)).fold(0.0, f64::max)
}

/// Size of the terms of a derivative `change`: the absolute `parts` that the state causes, plus the
/// remainder that the parameters cause.
fn term_size(change: f64, parts: impl Iterator<Item = f64>) -> f64 {
    let (sum, size) = parts.fold((0.0, 0.0), |(sum, size), part: f64| (sum + part, size + part.abs()));
    size + (change - sum).abs()
}

/// Makes the failure for contact forces or impulses without a finite derivative.
fn missing_contact_derivative_failure() -> Failure {
    Failure { code: "not-finite", message: "the contact forces have no finite derivative".to_owned() }
}
