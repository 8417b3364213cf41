//! Limits on the size of a derivation. They count links of the model and terms, so a derivation meets the same limits
//! on every machine.

use super::derive_error::DeriveError;
use crate::algebra::Arena;
use crate::geometry::Frames;
use crate::model::Model;

/// Largest number of links of a model whose equations are derived. A link is a frame or point between a body and the
/// ground. A link that several bodies share is counted once for each. The mass matrix has about as many entries as
/// the model has links.
const MOST_LINKS: usize = 25_000;

/// Largest number of terms in the arena. A derivation that needs more terms (about a gigabyte) is
/// refused.
const MOST_TERMS: usize = 6_000_000;

/// Refuses a model with more than `MOST_LINKS` links. A link is a frame or point between a body and the ground.
///
/// # Errors
/// Returns [`DeriveError::TooLarge`] for such a model.
pub(super) fn check_link_limit(model: &Model) -> Result<(), DeriveError> {
    let frames = Frames::new(&model.frames);
    let links = |centre: usize, frame: Option<usize>| {
        let points =
            std::iter::successors(Some(centre), |at| model.points[*at].position.map(|placement| placement.parent));
        points.count() + frame.map_or(0, |frame| frames.ancestors(frame).len())
    };
    let count = model.bodies.iter().map(|body| links(body.centre, body.rigid.as_ref().map(|(own, _)| *own))).sum();
    check_limit(model, count, MOST_LINKS, "frames and points between its bodies and the ground")
}

/// Refuses a derivation whose arena has more than `MOST_TERMS` terms.
///
/// # Errors
/// Returns [`DeriveError::TooLarge`] for such a derivation.
pub(super) fn check_term_limit(model: &Model, arena: &Arena) -> Result<(), DeriveError> {
    check_limit(model, arena.len(), MOST_TERMS, "terms")
}

/// Returns `DeriveError::TooLarge` if `count` exceeds `most`. `what` is the noun for the counted
/// items.
fn check_limit(model: &Model, count: usize, most: usize, what: &'static str) -> Result<(), DeriveError> {
    let (bodies, coordinates) = (model.bodies.len(), model.coordinates.len());
    if count > most { Err(DeriveError::TooLarge { bodies, coordinates, count, what, most }) } else { Ok(()) }
}
