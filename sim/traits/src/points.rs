//! Functions that quadrature evaluates, at several values of the coordinate at once.

use crate::{Lanes, Scalar};

/// Functions of a [`crate::System`] with one motion variable v that quadrature needs. Each lane has its own value of
/// the coordinate.
pub trait Integrands<S: Scalar> {
    /// Writes q̇, as [`crate::System::coordinate_rates`] does.
    fn coordinate_rates(&self, p: &[S], q: &[S], v: S, out: &mut [S]);
    /// Kinetic energy T, as [`crate::System::kinetic_energy`] gives it.
    fn kinetic_energy(&self, p: &[S], q: &[S], v: S) -> S;
    /// Divided difference V\[a, b\] of the potential energy, as [`crate::System::potential_slope`] gives it.
    fn potential_slope(&self, p: &[S], a: S, b: S) -> S;
}

/// [`Integrands`] at four and at eight points at once.
#[derive(Clone, Copy)]
pub struct AtPoints<'a> {
    /// Integrands at four points.
    pub four: &'a (dyn Integrands<Lanes<4>> + Sync),
    /// Integrands at eight points.
    pub eight: &'a (dyn Integrands<Lanes<8>> + Sync),
}

impl<'a> AtPoints<'a> {
    /// Integrands of equations that are written for every scalar.
    #[must_use]
    pub const fn of<E: Integrands<Lanes<4>> + Integrands<Lanes<8>> + Sync>(equations: &'a E) -> Self {
        Self { four: equations, eight: equations }
    }
}
