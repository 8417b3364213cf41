//! Limits of the cost of a derivation, by counts that are the same on every machine.

use super::error::DeriveError;
use crate::algebra::Arena;
use crate::geometry::Frames;
use crate::model::Model;

/// Most links that are derived: frames and points between a body and the ground, added up over all bodies. The mass
/// matrix of such a model has about as many entries.
const MOST_LINKS: usize = 25_000;

/// Most terms of a store. A derivation with more terms, about a gigabyte, is given up.
const MOST_TERMS: usize = 6_000_000;

/// Refuses a model with more than `MOST_LINKS` links.
///
/// # Errors
/// [`DeriveError::TooLarge`].
pub(super) fn check_tree(model: &Model) -> Result<(), DeriveError> {
    let frames = Frames::new(&model.frames);
    let links = |centre: usize, frame: Option<usize>| {
        let points =
            std::iter::successors(Some(centre), |at| model.points[*at].position.map(|placement| placement.parent));
        points.count() + frame.map_or(0, |frame| frames.ancestors(frame).len())
    };
    let count = model.bodies.iter().map(|body| links(body.centre, body.rigid.as_ref().map(|(own, _)| *own))).sum();
    refuse(model, count, MOST_LINKS, "frames and points between its bodies and the ground")
}

/// Refuses a derivation whose store has more than `MOST_TERMS` terms.
///
/// # Errors
/// [`DeriveError::TooLarge`].
pub(super) fn check_terms(model: &Model, arena: &Arena) -> Result<(), DeriveError> {
    refuse(model, arena.len(), MOST_TERMS, "terms")
}

fn refuse(model: &Model, count: usize, most: usize, what: &'static str) -> Result<(), DeriveError> {
    let (bodies, coordinates) = (model.bodies.len(), model.coordinates.len());
    if count > most { Err(DeriveError::TooLarge { bodies, coordinates, count, what, most }) } else { Ok(()) }
}
