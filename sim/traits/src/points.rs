//! Functions that quadrature evaluates, at several values of the coordinate at once.

use crate::{Lanes, Scalar};

/// The functions of a [`crate::System`] with one variable v that quadrature needs, at a value of the coordinate in each
/// lane.
pub trait Integrands<S: Scalar> {
    /// q̇, as [`crate::System::coordinate_rates`] writes it.
    fn coordinate_rates(&self, p: &[S], q: &[S], v: S, out: &mut [S]);
    /// T, as [`crate::System::kinetic_energy`] gives it.
    fn kinetic_energy(&self, p: &[S], q: &[S], v: S) -> S;
    /// V\[a, b\], as [`crate::System::potential_slope`] gives it.
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
