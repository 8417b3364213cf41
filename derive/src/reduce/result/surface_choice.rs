//! Choice of the singular surface from which the equations of a reduction measure a coordinate.

use crate::mechanics::SingularDistance;
use std::f64::consts::FRAC_PI_2;

/// Number of whole turns to either side of zero within which singular values of a coordinate are
/// searched.
const MOST_TURNS: i32 = 100;

/// Choice of the singular surface from which reduced equations measure a coordinate. The start of the motion decides
/// it, because the nearest surface is chosen.
#[derive(Clone, Debug, Default)]
pub struct SurfaceChoice {
    /// Surfaces that were examined, each with true if a divisor of the equations vanishes there. Empty if the start
    /// does not matter.
    pub(in crate::reduce) examined: Vec<(SingularDistance, bool)>,
    /// Surface from which the equations are written; `None` if they are written in the coordinates themselves.
    pub chosen: Option<SingularDistance>,
}

impl SurfaceChoice {
    /// True if the same surface is chosen for a motion that starts at the coordinates `q`. False if this is not known.
    #[must_use]
    pub fn holds_for_start(&self, q: &[f64]) -> bool {
        let has_examined = |place: &SingularDistance| {
            let nearest = nearest_repetition(*place, q);
            self.examined.iter().any(|(examined, _)| *examined == nearest)
        };
        let is_known = self.examined.iter().all(|(place, _)| has_examined(place));
        self.examined.is_empty() || (is_known && nearest_singular(&self.examined, q) == self.chosen)
    }
}

/// Surface nearest to the coordinates `q`, among those on which a divisor vanishes.
pub(in crate::reduce) fn nearest_singular(
    examined: &[(SingularDistance, bool)],
    q: &[f64],
) -> Option<SingularDistance> {
    let away = |place: &SingularDistance| distance_from_surface(*place, q);
    let key = |place: &SingularDistance| (place.coordinate, place.quarter_turns);
    let singular = examined.iter().filter(|(_, vanishes)| *vanishes).map(|(place, _)| *place);
    singular.min_by(|a, b| away(a).total_cmp(&away(b)).then(key(a).cmp(&key(b))))
}

/// Absolute distance of the coordinates `q` from a surface, rad.
fn distance_from_surface(place: SingularDistance, q: &[f64]) -> f64 {
    (q[place.coordinate] - f64::from(place.quarter_turns) * FRAC_PI_2).abs()
}

/// Repetition of a surface after whole turns that is nearest to the coordinates `q`.
pub(in crate::reduce) fn nearest_repetition(place: SingularDistance, q: &[f64]) -> SingularDistance {
    let again = (-MOST_TURNS..=MOST_TURNS).map(|turn| SingularDistance {
        quarter_turns: (place.quarter_turns + 2).rem_euclid(4) - 2 + 4 * turn,
        ..place
    });
    again.min_by(|a, b| distance_from_surface(*a, q).total_cmp(&distance_from_surface(*b, q))).unwrap_or(place)
}
