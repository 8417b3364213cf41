//! What a derivation may cost, by counts that are the same on every machine.

use super::error::DeriveError;
use crate::algebra::Arena;
use crate::geometry::Frames;
use crate::model::Model;

/// Frames and points between bodies and the ground, over all bodies, that are derived: a mass matrix has about as many
/// entries.
const MOST_LINKS: usize = 25_000;

/// Terms of a store above which a derivation is given up: about a gigabyte.
const MOST_TERMS: usize = 6_000_000;

/// Refuses a model whose equations would be too many.
///
/// # Errors
/// [`DeriveError::TooLarge`].
pub(super) fn check_tree(model: &Model) -> Result<(), DeriveError> {
    let frames = Frames::new(&model.frames);
    let links = |centre: usize, frame: Option<usize>| {
        let points = std::iter::successors(Some(centre), |at| model.points[*at].position.map(|(parent, ..)| parent));
        points.count() + frame.map_or(0, |frame| frames.ancestors(frame).len())
    };
    let count = model.bodies.iter().map(|body| links(body.centre, body.rigid.as_ref().map(|(own, _)| *own))).sum();
    refuse(model, count, MOST_LINKS, "frames and points between its bodies and the ground")
}

/// Refuses what has become too large.
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
