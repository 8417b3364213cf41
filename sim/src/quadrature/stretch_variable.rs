//! Variables w in which parts (stretches) of a motion of one degree of freedom are integrated, and the
//! kinetic energy along them.

#![allow(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]

use super::energy::Energy;
use tripos_traits::Scalar;

/// Map from the variable w ≥ 0 to the coordinate q, for the integration of a stretch. `end` is q at w = 0, and `side`
/// is the sign of dq/dw, 1 or −1.
#[derive(Clone, Copy, Debug)]
pub(super) enum StretchVariable {
    /// Starts at a turning point and leads halfway to the other turning point, `length` away: q = end + side · length ·
    /// sin²(w/2).
    Arc { end: f64, side: f64, length: f64 },
    /// Starts at the only turning point of the motion: q = end + side · w²/2.
    Root { end: f64, side: f64 },
    /// Starts at a coordinate that is not a turning point: q = end + side · w.
    Line { end: f64, side: f64 },
    /// Starts at the coordinate of the least kinetic energy, `kinetic`, J: q = end + side · width · sinh w. dt/dw stays
    /// regular, however little kinetic energy is left there.
    Crest { end: f64, side: f64, width: f64, kinetic: f64 },
}

/// Point on a stretch of the motion, or a point in each lane of a vector type `S`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<S = f64> {
    /// Coordinate q of the point.
    pub(super) q: S,
    /// Distance |q − end| of the point from the start of the stretch, in the unit of q.
    pub(super) offset: S,
    /// Absolute slope |dq/dw| of the coordinate by the variable of the stretch.
    pub(super) reach: S,
}

impl StretchVariable {
    /// Computes the point of the stretch at its variable `w`.
    #[inline(always)]
    pub(super) fn at<S: Scalar>(&self, w: S) -> Place<S> {
        let (half, (end, side)) = (S::from_f64(0.5), self.start());
        let (offset, reach) = match *self {
            Self::Arc { length, .. } => {
                let ((sin, cos), length) = ((half * w).sin_cos(), S::from_f64(length));
                (length * sin * sin, length * sin * cos)
            }
            Self::Root { .. } => (half * w * w, w),
            Self::Line { .. } => (w, S::from_f64(1.0)),
            Self::Crest { width, .. } => {
                let width = S::from_f64(width);
                (width * w.sinh(), width * w.cosh())
            }
        };
        Place { q: S::from_f64(end) + S::from_f64(side) * offset, offset, reach }
    }

    /// Coordinate q at w = 0, and the sign of dq/dw, 1 or −1.
    pub(super) fn start(&self) -> (f64, f64) {
        let (Self::Arc { end, side, .. }
        | Self::Root { end, side }
        | Self::Line { end, side }
        | Self::Crest { end, side, .. }) = *self;
        (end, side)
    }

    /// Quotient T/(dq/dw)² of the kinetic energy and the square of the slope, at a point of the stretch. `slope(a, b)`
    /// is the divided difference V\[a, b\] of the potential energy.
    ///
    /// From a turning point it is −V\[end, q\] divided by the distance from the other turning point (2 if there is
    /// none). From a crest both parts of T are positive.
    #[inline(always)]
    pub(super) fn kinetic_energy_over_slope_squared<S: Scalar>(
        &self,
        energy: &Energy<'_>,
        slope: impl Fn(S, S) -> S,
        at: &Place<S>,
    ) -> S {
        let (end, side) = self.start();
        let pushes = || S::from_f64(-side) * slope(S::from_f64(end), at.q);
        match self {
            Self::Arc { length, .. } => pushes() / (S::from_f64(*length) - at.offset),
            Self::Root { .. } => pushes() / S::from_f64(2.0),
            Self::Line { .. } => {
                let start = S::from_f64(energy.start);
                S::from_f64(energy.kinetic) - (at.q - start) * slope(start, at.q)
            }
            Self::Crest { kinetic, .. } => (S::from_f64(*kinetic) + at.offset * pushes()) / (at.reach * at.reach),
        }
    }

    /// Kinetic energy T, J, at a point of the stretch, computed from the anchor; `None` computes it from the start of
    /// the stretch. `slope(a, b)` is the divided difference V\[a, b\] of the potential energy.
    #[inline(always)]
    pub(super) fn kinetic_energy_at<S: Scalar>(
        &self,
        energy: &Energy<'_>,
        anchor: Option<Anchor>,
        slope: impl Fn(S, S) -> S,
        at: &Place<S>,
    ) -> S {
        match anchor {
            Some(Anchor { q, offset, kinetic, .. }) => {
                let (_, side) = self.start();
                let gone = S::from_f64(side) * (at.offset - S::from_f64(offset));
                S::from_f64(kinetic) - gone * slope(S::from_f64(q), at.q)
            }
            None => at.reach * at.reach * self.kinetic_energy_over_slope_squared(energy, slope, at),
        }
    }
}

/// Point of a stretch with known kinetic energy, from which the kinetic energy at later points is
/// computed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Anchor {
    /// Coordinate q of the point with known kinetic energy.
    pub(super) q: f64,
    /// Distance of the anchor from the start of the stretch, in the unit of q.
    pub(super) offset: f64,
    /// Kinetic energy at the coordinate `q`, J.
    pub(super) kinetic: f64,
    /// Sum of the kinetic energies at all anchors so far, J; it measures the rounding error of `kinetic`.
    added: f64,
}

impl Anchor {
    /// Creates the anchor at the end of a panel, a subinterval of the stretch. `kinetic` is the kinetic energy there,
    /// J, computed from the anchor `before`.
    ///
    /// Energies that are larger than their sum leave their rounding errors in it. The kinetic energy is then computed
    /// from the start of the motion again, if the kinetic energy there is smaller.
    pub(super) fn next_anchor(before: Option<Self>, energy: &Energy<'_>, end: &Place, kinetic: f64) -> Self {
        let added = before.map_or(0.0, |before| before.added + before.kinetic) + kinetic;
        let Place { q, offset, .. } = *end;
        if energy.kinetic + kinetic < 0.125 * added {
            let kinetic = energy.kinetic_energy_left(q);
            return Self { q, offset, kinetic, added: energy.kinetic + kinetic };
        }
        Self { q, offset, kinetic, added }
    }
}
