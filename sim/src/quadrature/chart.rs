//! The variables by which stretches of the motion are measured, and the kinetic energy along them.

use super::energy::Energy;

/// How the coordinate follows from the variable w ≥ 0 of a stretch.
#[derive(Clone, Copy, Debug)]
pub(super) enum Chart {
    /// From one of two turning points halfway to the other: q = end + side · length · sin²(w/2).
    Arc { end: f64, side: f64, length: f64 },
    /// From the only turning point on: q = end + side · w²/2.
    Root { end: f64, side: f64 },
    /// From a place that is not a turning point: q = end + side · w.
    Line { end: f64, side: f64 },
}

/// A place of a stretch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) q: f64,
    /// |q − end|.
    pub(super) offset: f64,
    /// dq/dw, up to its sign.
    pub(super) reach: f64,
}

impl Chart {
    /// The place at `w`.
    pub(super) fn at(&self, w: f64) -> Place {
        let (end, side, offset, reach) = match *self {
            Self::Arc { end, side, length } => {
                let (sin, cos) = (0.5 * w).sin_cos();
                (end, side, length * sin * sin, length * sin * cos)
            }
            Self::Root { end, side } => (end, side, 0.5 * w * w, w),
            Self::Line { end, side } => (end, side, w, 1.0),
        };
        Place { q: end + side * offset, offset, reach }
    }

    /// Where w is 0, and which way it grows.
    pub(super) fn start(&self) -> (f64, f64) {
        let (Self::Arc { end, side, .. } | Self::Root { end, side } | Self::Line { end, side }) = *self;
        (end, side)
    }

    /// T/(reach)² at a distance from the turning point: −V\[end, q\] over what is left to the other one (2 where there
    /// is none).
    pub(super) fn level(&self, energy: &Energy<'_>, q: f64, offset: f64) -> f64 {
        let (end, side) = self.start();
        match self {
            Self::Arc { length, .. } => -side * energy.slope(end, q) / (length - offset),
            Self::Root { .. } => -side * energy.slope(end, q) / 2.0,
            Self::Line { .. } => energy.left(q),
        }
    }
}

/// Where the kinetic energy is known, and from where it is computed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Anchor {
    pub(super) q: f64,
    pub(super) offset: f64,
    pub(super) kinetic: f64,
    /// The sum of the energies that were added up to there, each with its rounding error.
    added: f64,
}

impl Anchor {
    /// The end of a panel, where the energy `kinetic` follows from the anchor before.
    ///
    /// Energies larger than what is left of them leave their errors behind; then the start is the better place to count
    /// from, if its own kinetic energy is smaller.
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
