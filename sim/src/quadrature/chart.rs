//! Variables by which stretches of a motion by quadrature are measured, and the kinetic energy along them.

#![allow(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]

use super::energy::Energy;
use tripos_traits::Scalar;

/// Map from the variable w ≥ 0 of a stretch of the motion to the coordinate q.
#[derive(Clone, Copy, Debug)]
pub(super) enum Chart {
    /// From a turning point halfway to the other one: q = end + side · length · sin²(w/2).
    Arc { end: f64, side: f64, length: f64 },
    /// From the only turning point of the motion on: q = end + side · w²/2.
    Root { end: f64, side: f64 },
    /// From a place that is not a turning point: q = end + side · w.
    Line { end: f64, side: f64 },
    /// From the place where the kinetic energy is least, `kinetic` there: q = end + side · width · sinh w. So dt/dw
    /// stays regular, however little kinetic energy is left at that place.
    Crest { end: f64, side: f64, width: f64, kinetic: f64 },
}

/// A place on a stretch of the motion, or a place in each lane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<S = f64> {
    pub(super) q: S,
    /// Distance |q − end| from the start of the stretch.
    pub(super) offset: S,
    /// Slope dq/dw of the coordinate, up to its sign.
    pub(super) reach: S,
}

impl Chart {
    /// Place of the stretch at the variable `w`.
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

    /// Coordinate q where w is 0, and the sign of dq/dw.
    pub(super) fn start(&self) -> (f64, f64) {
        let (Self::Arc { end, side, .. }
        | Self::Root { end, side }
        | Self::Line { end, side }
        | Self::Crest { end, side, .. }) = *self;
        (end, side)
    }

    /// Kinetic energy over the square of the reach, T/(dq/dw)². From a turning point it is −V\[end, q\] over the
    /// distance from the other turning point (2 if there is none). `slope` gives V\[a, b\]. From a crest both parts of
    /// T are positive.
    #[inline(always)]
    pub(super) fn level<S: Scalar>(&self, energy: &Energy<'_>, slope: impl Fn(S, S) -> S, at: &Place<S>) -> S {
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

    /// Kinetic energy T at a place, computed from the anchor, or from the turning point if there is no anchor.
    #[inline(always)]
    pub(super) fn kinetic<S: Scalar>(
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
            None => at.reach * at.reach * self.level(energy, slope, at),
        }
    }
}

/// Place from which the kinetic energy is computed, with its value there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Anchor {
    pub(super) q: f64,
    pub(super) offset: f64,
    pub(super) kinetic: f64,
    /// Sum of the energies that were added up to this place, each with its rounding error.
    added: f64,
}

impl Anchor {
    /// Makes the anchor at the end of a panel, where the energy `kinetic` follows from the anchor before.
    ///
    /// Energies that are larger than the remaining sum leave their rounding errors in it. Then the energy is counted
    /// from the start of the motion, if the kinetic energy there is smaller.
    pub(super) fn next(before: Option<Self>, energy: &Energy<'_>, end: &Place, kinetic: f64) -> Self {
        let added = before.map_or(0.0, |before| before.added + before.kinetic) + kinetic;
        let Place { q, offset, .. } = *end;
        if energy.kinetic + kinetic < 0.125 * added {
            let kinetic = energy.left(q);
            return Self { q, offset, kinetic, added: energy.kinetic + kinetic };
        }
        Self { q, offset, kinetic, added }
    }
}
