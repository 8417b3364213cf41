//! Integrands of quadrature for systems with one degree of freedom, at several values of the
//! coordinate at once.

use crate::{Lanes, Scalar};

/// Functions that quadrature needs of a [`crate::System`] with a single motion variable v. Each
/// lane has its own value of the coordinate.
pub trait Integrands<S: Scalar> {
    /// Writes the coordinates' rates q̇, like [`crate::System::coordinate_rates`].
    fn coordinate_rates(&self, p: &[S], q: &[S], v: S, out: &mut [S]);
    /// Kinetic energy T, J, like [`crate::System::kinetic_energy`].
    fn kinetic_energy(&self, p: &[S], q: &[S], v: S) -> S;
    /// Divided difference V\[a, b\] of the potential energy, like [`crate::System::potential_slope`].
    fn potential_slope(&self, p: &[S], a: S, b: S) -> S;
}

/// Integrands of quadrature at four points, and at eight points, at once; see [`Integrands`].
#[derive(Clone, Copy)]
pub struct AtPoints<'a> {
    /// Integrands at four values of the coordinate at once.
    pub four: &'a (dyn Integrands<Lanes<4>> + Sync),
    /// Integrands at eight values of the coordinate at once.
    pub eight: &'a (dyn Integrands<Lanes<8>> + Sync),
}

impl<'a> AtPoints<'a> {
    /// Wraps equations that are generic over the scalar, so that they serve four and eight points.
    #[must_use]
    pub const fn of<E: Integrands<Lanes<4>> + Integrands<Lanes<8>> + Sync>(equations: &'a E) -> Self {
        Self { four: equations, eight: equations }
    }
}
